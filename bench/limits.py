#!/usr/bin/env python3
"""How far commands go on beyond their time limit, once the spec is read: CPU time by a clock of CPU time, whatever else the machine does.

usage, alone: limits.py KEMPE [--limits S ...] [--only WORD ...] [--random N] [--seed N]
"""
import argparse
import dataclasses
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile

import random_specs
from growth import comb, wave
from measure import EXAMPLES, HOME, Row, shown

LIMITS = [0.05, 0.2, 1, 5]
LARGE = 100_000  # bytes of a spec whose reading is looked at: it is not counted


def allowed(limit):
    return max(0.1, 0.1 * limit)


def inline(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {inline(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(inline, value)) + "]"
    return json.dumps(value)


def toml(spec):
    return "".join(f"{key} = {inline(value)}\n" for key, value in spec.items())


def around(rng, count, corners, near, far, size):
    """Obstacles about the origin, low ones."""
    all_ = []
    for _ in range(count):
        away, turn = rng.uniform(near, far), rng.uniform(-math.pi, math.pi)
        all_.append({"polygon_mm": random_specs.star(rng, (away * math.cos(turn), away * math.sin(turn)), size, corners),
                     "layers": [1, 1]})
    return all_


def generated(rng):
    """Specs by name whose searches, maps and files are as long as can be."""
    copy, pole = {"scale": 1.4, "rotation_deg": 90}, {"at_mm": [0, 0]}
    small = {"polygon_mm": [[62, -5], [70, -5], [70, 5], [62, 5]]}
    sheet = {"rectangle_mm": {"at": [90, -50], "size": [150, 100]}}
    free = {"within_mm": [[-40, -40], [40, -40], [40, 40], [-40, 40]]}
    tolerance = {"length_mm": 0.05, "play_mm": 0.02}
    wide = {"width_mm": 24, "pin_diameter_mm": 6}
    yield "wave-100000", {"copy": copy, "region": {"polygon_mm": wave(100_000)}, "pole": pole}
    yield "comb-20000", {"copy": copy, "region": {"polygon_mm": comb(20_000)}, "pole": pole}
    yield "comb-100000", {"copy": copy, "region": {"polygon_mm": comb(100_000)}, "pole": pole}
    yield "wave-100000-free-pole", {"copy": {"scale": 0.5}, "region": {"polygon_mm": wave(100_000)}, "pole": free,
                                    "limits": {"sheets_gap_mm": 2}}
    yield "comb-3000-obstacles", {"copy": copy, "region": {"polygon_mm": comb(3000)}, "pole": pole,
                                  "obstacles": around(rng, 20, 20, 150, 300, 10)}
    for count, corners in ((50, 20), (300, 100), (1000, 200)):
        yield f"obstacles-{count}x{corners}", {"copy": copy, "region": sheet, "pole": pole, "links": {"layers": 3},
                                               "obstacles": around(rng, count, corners, 180, 700, 12)}
    yield "obstacles-40-free-pole", {"copy": {"scale": 0.5, "rotation_deg": 30}, "region": sheet, "pole": free,
                                     "links": {"layers": 4}, "obstacles": around(rng, 40, 12, 150, 500, 10)}
    yield "grid-1", {"copy": {"scale": 0.37, "rotation_deg": 41}, "region": sheet, "pole": pole, "links": {"grid_mm": 1}}
    yield "grid-1-free-pole", {"copy": {"scale": 0.37, "rotation_deg": 41}, "region": sheet, "pole": free, "links": {"grid_mm": 1}}
    yield "grid-2-footprint", {"copy": {"scale": 0.4}, "region": sheet, "pole": free, "links": {"grid_mm": 2, "layers": 3},
                               "objective": {"minimize": "footprint"}, "limits": {"sheets_gap_mm": 3}}
    yield "grid-1-obstacles", {"copy": {"scale": 0.37, "rotation_deg": 41}, "region": sheet, "pole": pole,
                               "links": {"grid_mm": 1, "layers": 3}, "obstacles": around(rng, 6, 10, 250, 500, 10)}
    yield "robust-wide", {"copy": copy, "region": small, "pole": pole, "links": wide, "limits": {"clearance_mm": 0.5},
                          "tolerance": tolerance | {"robust": True}}
    yield "robust-free-pole", {"copy": {"scale": 0.5, "rotation_deg": 20}, "region": sheet, "pole": free, "links": wide,
                               "limits": {"clearance_mm": 1}, "tolerance": tolerance | {"robust": True}}
    yield "robust-obstacles", {"copy": {"scale": 0.5, "rotation_deg": 20}, "region": sheet, "pole": pole, "links": {"layers": 3},
                               "limits": {"clearance_mm": 1}, "tolerance": tolerance | {"robust": True},
                               "obstacles": around(rng, 5, 12, 280, 500, 15)}
    yield "robust-wave-20000", {"copy": copy, "region": {"polygon_mm": wave(20_000)}, "pole": pole,
                                "tolerance": tolerance | {"robust": True}}
    yield "copy-error", {"copy": {"scale": 3, "rotation_deg": 30}, "region": sheet, "pole": free, "tolerance": tolerance,
                         "objective": {"minimize": "copy_error"}}
    yield "footprint-wave-20000", {"copy": copy, "region": {"polygon_mm": wave(20_000)}, "pole": pole,
                                   "objective": {"minimize": "footprint"}}
    yield "four-layers-footprint", {"copy": {"scale": 0.6, "rotation_deg": -70}, "region": sheet, "pole": free,
                                    "links": {"layers": 4}, "objective": {"minimize": "footprint"}}
    yield "no-design", {"copy": {"scale": 0.6, "rotation_deg": -70}, "region": sheet, "pole": free,
                        "links": {"layers": 4, "longest_mm": 60}, "obstacles": around(rng, 5, 12, 280, 500, 15)}
    yield "no-design-clearance", {"copy": {"scale": 0.6}, "region": sheet, "pole": pole, "links": {"layers": 3},
                                  "limits": {"clearance_mm": 60, "sheets_gap_mm": 10}, "obstacles": around(rng, 30, 12, 200, 500, 15)}


def specs(folder, count, seed):
    """Files of specs by name: the examples, the bench's, generated ones and random ones."""
    for home in (EXAMPLES, HOME / "specs"):
        for file in sorted(home.glob("*.toml")):
            if file.name != "pairs.toml":
                yield file.stem, file
    rng = random.Random(seed)
    for name, spec in generated(rng):
        file = folder / f"{name}.toml"
        file.write_text(toml(spec))
        yield name, file
    for i in range(count):
        file = folder / f"random-{i}.toml"
        file.write_text(toml(random_specs.spec(rng)))
        yield file.stem, file


class Meter:
    """Runs commands whose clock is their own CPU time (cpu_clock.c)."""

    def __init__(self, folder):
        self.clock = folder / "cpu_clock.so"
        subprocess.run([os.environ.get("CC", "cc"), "-O1", "-shared", "-fPIC", "-o", self.clock, HOME / "cpu_clock.c", "-ldl"], check=True)

    def cpu_s(self, command):
        """CPU s of a command, start-up included, and its exit code."""
        process = subprocess.Popen([str(c) for c in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env=os.environ | {"LD_PRELOAD": str(self.clock)})
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        return usage.ru_utime + usage.ru_stime, process.returncode


@dataclasses.dataclass
class Overrun:
    name: str
    limit: float
    cpu_s: float
    code: int

    @property
    def is_over(self):
        return self.cpu_s > allowed(self.limit)


def measured(kempe, folder, limits, count, seed, only=()):
    meter = Meter(folder)
    for name, file in specs(folder, count, seed):
        if only and not any(word in name for word in only):
            continue

        def run(limit):
            return meter.cpu_s([kempe, "synthesize", file, "-o", folder / "out", "-j", "1", "--quiet", "--time-limit", limit])
        # A limit that is over once the spec is read ends the command.
        reading = run(1e-6)[0] if file.stat().st_size > LARGE else 0
        for limit in limits:
            used, code = run(limit)
            yield Overrun(name, limit, max(0.0, used - max(limit, reading)), code)


def rows(context):
    with tempfile.TemporaryDirectory() as folder:
        runs = list(measured(context.kempe, pathlib.Path(folder), LIMITS[:2] if context.quick else LIMITS,
                             5 if context.quick else 40, 2026))
    for limit in sorted({run.limit for run in runs}):
        of_limit = sorted((run for run in runs if run.limit == limit), key=lambda run: run.cpu_s)
        worst, over = of_limit[-1], sum(run.is_over for run in of_limit)
        yield Row("CPU time after a time limit", f"{len(of_limit)} specs, limit {limit} s",
                  f"95 % below {shown(of_limit[int(0.95 * len(of_limit))].cpu_s)}, most {shown(worst.cpu_s)} ({worst.name})",
                  "", f"{over} above", f"{shown(allowed(limit))}", over == 0)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("kempe", type=pathlib.Path)
    parser.add_argument("--limits", nargs="+", type=float, default=LIMITS)
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--random", type=int, default=40)
    parser.add_argument("--seed", type=int, default=2026)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for run in measured(arguments.kempe, pathlib.Path(folder), arguments.limits, arguments.random, arguments.seed,
                            arguments.only):
            print(f"{run.name:26s} {run.limit:5.2f} s  CPU after {run.cpu_s:6.3f}  exit {run.code}"
                  f"{'  OVER' if run.is_over else ''}", flush=True)


if __name__ == "__main__":
    main()
