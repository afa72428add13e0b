#!/usr/bin/env python3
"""Random specs as a workshop writes them: whole millimetres, round posts, clamps, bodies, tables, bolts and bearings, loads, sections, stock
and locked lengths. Each is designed, verified and checked by itself, on one thread.

A line a spec: number, outcome, CPU seconds of synthesize; then exit code and CPU seconds of verify and of the checker. What should not be is
marked FAULT: a design that verify refuses, a claim that the checker does not prove (limits on load error and sag are not its business), an
exit code of no meaning. At the end the slowest.

usage: workshop_specs.py KEMPE [COUNT] [SEED] [FOLDER]
"""
import math
import pathlib
import random
import shutil
import sys
import tempfile

import limits
import measure

LISTED = 12
CHECKER = measure.ROOT / "proof" / "kempe_check.py"
SETTLED = {0: "design", 2: "not read", 3: "none", 6: "none found"}  # exit codes of synthesize
NOT_CHECKED = ("limits.load_error_mm", "limits.sag_mm")


def shape(rng, centre, size):
    x, y, r = round(centre[0]), round(centre[1]), max(1, round(size))
    kind = rng.choice(["rectangle", "rectangle", "circle", "polygon"])
    if kind == "circle":
        return {"circle_mm": {"centre": [x, y], "radius": r}}
    if kind == "rectangle":
        w, h = (max(1, round(r * rng.uniform(0.3, 2))) for _ in range(2))
        return {"rectangle_mm": {"at": [x - w // 2, y - h // 2], "size": [w, h]}}
    n = rng.choice([3, 4, 6])
    turns = [2 * math.pi * i / n + 0.3 for i in range(n)]
    return {"polygon_mm": [[x + round(r * math.cos(t), 1), y + round(r * math.sin(t), 1)] for t in turns]}


def square(x, y, side):
    return [[x, y], [x + side, y], [x + side, y + side], [x, y + side]]


def region(rng, centre, size):
    """One outline, two squares or a square with a hole."""
    kind, (x, y), r = rng.random(), map(round, centre), max(4, round(size))
    if kind < 0.1:
        one = {"polygon_mm": [square(x - r, y, r // 2), square(x + r // 2, y - r // 2, r // 2)]}
    elif kind < 0.2:
        one = {"polygon_mm": square(x - r, y - r, 2 * r), "holes_mm": [square(x - r // 2, y - r // 2, r)]}
    else:
        one = shape(rng, centre, size)
    return {**one, "margin_mm": rng.choice([1, 5])} if rng.random() < 0.15 else one


def links(rng):
    one = {"layers": rng.choice([2, 2, 3, 3, 4, 5, 8]), "longest_mm": rng.choice([300, 400, 600, 1000])}
    if rng.random() < 0.25:
        one["hardware"] = rng.choice(["M4 bolt", "M6 shoulder bolt", "608 bearing", "624 bearing", "5 mm dowel and bush", "M6 bolt"])
        one.update(width_mm=30 if "bearing" in one["hardware"] else 16, thickness_mm=8)
    else:
        one["width_mm"] = rng.choice([8, 10, 12, 15, 20, 25])
        one["pin_diameter_mm"] = rng.choice([3, 4, 6, one["width_mm"] * 0.5])
    if rng.random() < 0.4:
        one["plate"] = "triangle"
    if rng.random() < 0.15:
        one["grid_mm"] = rng.choice([1, 5, 10])
    elif rng.random() < 0.08:
        one["stock_mm"] = [20, 40, 60, 80, 100, 120, 150, 200, 250, 300, 400]
    if rng.random() < 0.08:
        one[rng.choice(["VA_mm", "VB_mm", "AX_mm", "BY_mm"])] = rng.choice([60, 100, 150, 200])
    return one


def add_loads(rng, spec):
    spec["material"] = {"name": rng.choice(["steel", "aluminium", "PLA", "birch plywood"])}
    load = spec["load"] = {"pen_N": rng.choice([2, 10, 50]), "rests": rng.choice([["tracer", "pen"], ["pen"], ["tracer"]])}
    if rng.random() < 0.3:
        load["pen_mass_kg"] = rng.choice([0.5, 3])
    if rng.random() < 0.3:
        load["tilt_deg"] = rng.choice([15, 90])
    if rng.random() < 0.4:
        spec["limits"]["load_error_mm"] = rng.choice([0.05, 0.2, 1])
    if rng.random() < 0.25:
        spec["limits"]["sag_mm"] = rng.choice([0.2, 1, 3])
    if rng.random() < 0.15 and "hardware" not in spec["links"]:
        spec["links"].pop("width_mm")
        spec["links"].update(sections_mm=[[12, 4], [15, 5], [20, 6]], pin_diameter_mm=6)


def add_layers(rng, solid):
    lowest = rng.randint(1, 4)
    solid["layers"] = [lowest, rng.randint(lowest, 8)]


def add_surroundings(rng, spec, away):
    if rng.random() < 0.6:
        spec["obstacles"] = []
        for _ in range(rng.choice([1, 1, 2, 3])):
            turn, far = rng.uniform(-math.pi, math.pi), away * rng.choice([0.2, 0.4, 0.7, 1, 1.3, 2])
            spec["obstacles"].append(shape(rng, (far * math.cos(turn), far * math.sin(turn)), rng.choice([4, 8, 15, 30, 60])))
            if rng.random() < 0.4:
                add_layers(rng, spec["obstacles"][-1])
    if rng.random() < 0.2:
        spec["bodies"] = []
        for at in rng.choice([["pen"], ["tracer"], ["pen", "tracer"]]):
            spec["bodies"].append({"at": at, **shape(rng, (0, 0), rng.choice([8, 15, 30, 50]))})
            if rng.random() < 0.2:
                spec["bodies"][-1]["turns_with"] = rng.choice(["VA", "VB", "ACX", "BCY"])
            if rng.random() < 0.4:
                add_layers(rng, spec["bodies"][-1])
    if rng.random() < 0.12:
        w = rng.choice([2, 3, 4]) * away
        spec["table"] = {"rectangle_mm": {"at": [-w, -w], "size": [2 * w, 2 * w]}}


def add_tolerance(rng, spec):
    spec["tolerance"] = {"length_mm": rng.choice([0.05, 0.1]), "play_mm": rng.choice([0, 0.02, 0.05])}
    if rng.random() < 0.3 and not {"bodies", "table"} & spec.keys():
        spec["tolerance"]["robust"] = True
    if rng.random() < 0.3:
        spec["limits"]["copy_error_mm"] = rng.choice([0.3, 0.5, 1, 2])


def objective(rng, spec):
    kind, one = rng.random(), {}
    if kind < 0.15:
        one = {"maximize": "transmission"}
    elif kind < 0.3:
        one = {"minimize": "footprint"}
    elif kind < 0.4 and "tolerance" in spec:
        one = {"minimize": "copy_error"}
    elif kind < 0.5 and "load" in spec:
        one = {"minimize": rng.choice(["load_error", "mass"])}
    if rng.random() < 0.1:
        one["groundings"] = rng.choice([["pole"], ["tracer"], ["pen"], ["pole", "pen"]])
    return one


def spec(rng):
    scale, rotation = rng.choice([0.1, 0.25, 0.5, 0.75, 1, 1.4, 2, 3, 5, "1:2", "1:4", "3:1"]), rng.choice([0, 0, 0, 180, 180, 90, -90, 45, 30, 10, 137])
    one = {"copy": {"scale": scale, "rotation_deg": 180 if scale == 1 and rotation == 0 else rotation}}
    away, bearing = rng.choice([60, 100, 150, 200, 300, 400]), math.radians(rng.choice([0, 30, 45, 90, 120, 180, 200, 270, 300]))
    one["region"] = region(rng, (away * math.cos(bearing), away * math.sin(bearing)), away * rng.choice([0.05, 0.1, 0.2, 0.3, 0.4]))
    if rng.random() < 0.35:
        h = rng.choice([10, 30, 60])
        one["pole"] = {"within_mm": square(-h, -h, 2 * h)}
    elif rng.random() < 0.3:
        one["pole"] = {"at_mm": [rng.choice([0, 5, -20]), rng.choice([0, 10])]}
    one["links"] = links(rng)
    one["limits"] = {"transmission_deg": rng.choice([15, 20, 25, 30, 30, 40])}
    for chance, key, values in ((0.5, "clearance_mm", [0, 0.5, 1, 2]), (0.15, "sheets_gap_mm", [0, 5, 20]), (0.1, "longest_strip_mm", [200, 300, 400])):
        if rng.random() < chance:
            one["limits"][key] = rng.choice(values)
    add_surroundings(rng, one, away)
    if rng.random() < 0.25:
        add_tolerance(rng, one)
    if rng.random() < 0.25:
        add_loads(rng, one)
    if chosen := objective(rng, one):
        one["objective"] = chosen
    return one


def checked(out, with_design):
    """Exit code and CPU seconds of the checker, and what it should have proven; None without a file that it reads."""
    names = ("design.json", "certificate.jsonl") if with_design else ("certificate.jsonl",)
    files = [out / name for name in names if (out / name).exists()]
    if not files:
        return None
    run = measure.metered([sys.executable, CHECKER, *files])
    left = [line for line in run.stdout.splitlines() if not line.startswith("not looked at") and ": proven" not in line]
    ended = "" if run.code in (0, 1) else f"the checker ended with code {run.code} "
    return run, ended + run.stderr + "; ".join(line for line in left if not any(key in line for key in NOT_CHECKED))


def row(kempe, path, out):
    """What came of one spec: outcome, CPU seconds, words for the rest, faults."""
    shutil.rmtree(out, ignore_errors=True)  # of an earlier run
    run = measure.metered([kempe, "synthesize", path, "-o", out, "--threads", "1"])
    outcome = SETTLED.get(run.code, f"exit code {run.code}")
    words, faults = [], [] if run.code in SETTLED else [run.stderr[:200]]
    if run.code == 0:
        again = measure.metered([kempe, "verify", out / "design.json"])
        words.append(f"verify {again.code} {again.cpu_s:.2f} s")
        faults += [again.stdout[-200:]] if again.code else []
    if found := checked(out, run.code == 0):
        words.append(f"checker {found[0].code} {found[0].cpu_s:.2f} s")
        faults += [found[1]] if found[1] else []
    return outcome, run.cpu_s, words, faults


def main():
    arguments = sys.argv[1:]
    count, seed = (int(arguments[i]) if len(arguments) > i else default for i, default in ((1, 100), (2, 1)))
    folder = pathlib.Path(arguments[3] if len(arguments) > 3 else tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    seconds = {}
    for i in range(count):
        path = folder / f"workshop-{seed}-{i}.toml"
        path.write_text(limits.toml(spec(random.Random(f"{seed}-{i}"))))
        outcome, cpu, words, faults = row(arguments[0], path, path.with_suffix(""))
        seconds[path.stem] = cpu
        print(f"{path.stem:18s} {outcome:10s} {cpu:7.2f} s", *words, *(f"FAULT: {fault}" for fault in faults), sep="  ", flush=True)
    print(f"{count} specs, {sum(seconds.values()):.0f} s of CPU, {sum(s > 60 for s in seconds.values())} above a minute")
    for name in sorted(seconds, key=lambda name: -seconds[name])[:LISTED]:
        print(f"  {name:18s} {seconds[name]:7.2f} s")


if __name__ == "__main__":
    main()
