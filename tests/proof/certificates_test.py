#!/usr/bin/env python3
"""The designs that the program makes and the logs that it writes beside them, and beside its proofs that there is none, read by
the checker: those of the examples and of random specs. Every claim of a design must be proven, and every log. Where there is no
log the program must say so. A clearance two micrometres larger than the design's own the checker must not prove of an example.

Without a count the random specs are chosen ones: every pair of what specs can have is in one of them (obstacles, a free pole, the
three objectives and verdicts, two to four layers, both plates, a grid, gaps, a limit on the copy error, ratios of 0 or 180 degrees).
"""
import argparse
import collections
import importlib.util
import json
import pathlib
import random
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time

MOST_LEFT_OUT = 0.1  # of the bounds and verdicts: trees that do not close in 100,000 lines or in the time, or touch a design too closely
MOST_SECONDS = 60  # of the processor and the checker, for one design or log
MOST_BYTES = 5_000_000  # of a log
CHOSEN_SEED, CHOSEN = 5001, (18, 55, 64, 72, 104, 107, 134, 142, 164, 209, 212, 218, 221, 258)
LONG = (23, 106)  # of the same seed: their trees close in 3,000 lines if no cell is left uneven, and no opening cut without end
LONGEST = 37  # of the same seed: a verdict that none exists, whose log has 90,000 lines
# Of another seed: obstacles are met between the points spread along long links, or at places between those looked at first.
MET_BETWEEN_SEED, MET_BETWEEN, NEAR = 5005, (797, 806, 922), 1e-3
# Of one more: small obstacles in the way of long thin links, looked at from more than twenty places before its tree closes.
FROM_MANY_PLACES_SEED, FROM_MANY_PLACES = 5003, 433
NO_DESIGN = """[copy]
scale = 0.5
[region]
rectangle_mm = {at = [100, -50], size = [400, 100]}
[links]
width_mm = 12
pin_diameter_mm = 6
thickness_mm = 4
longest_mm = 150
"""


def module(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


def run(*command):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True)


def processor_time():
    """Of all processes that have ended: seconds that do not depend on what else the machine does."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


# An obstacle in the original: no pole and no lengths help, and a few lines a root say so.
IN_THE_WAY = """[copy]
scale = 0.5
[region]
rectangle_mm = {at = [-60, 0], size = [120, 80]}
[pole]
within_mm = [[-150, 320], [150, 320], [150, 420], [-150, 420]]
[links]
width_mm = 15
pin_diameter_mm = 8
longest_mm = 400
[[obstacles]]
name = "block"
rectangle_mm = {at = [50, 20], size = [30, 40]}
"""
FEW_LINES = 100


class Trial:
    """One spec through program and checker. `outcome`: "proven", "no log", "no claim" (nothing to prove) or what is wrong."""

    def __init__(self, options, spec, folder):
        self.options, self.spec, self.folder = options, spec, folder
        self.claims, self.seconds, self.bytes, self.nodes, self.why = [], None, 0, 0, ""
        self.gap = None  # of the bound that is stated, as a share of the design's value
        limit = ["--time-limit", options.time_limit] if options.time_limit else []
        began = time.monotonic()
        self.ran = run(options.kempe, "synthesize", spec, "-o", folder, "--json", *limit)
        self.program_seconds = time.monotonic() - began
        self.log = folder / "certificate.jsonl"
        self.outcome = {0: self.of_design, 3: self.of_none, 6: lambda: "no claim"}.get(
            self.ran.returncode, lambda: f"exit {self.ran.returncode}: {self.ran.stderr}")()

    def of_none(self):
        said = json.loads(self.ran.stdout)
        if not said["proven"]:
            return "no claim"
        if not self.log.exists():
            self.why = next((s for s in said.get("left_out", []) if "certificate.jsonl" in s), "")
            return "no log" if self.why else "a verdict without its log, and no word of it"
        return self.check([self.log], "4 no design exists: proven")

    def of_design(self):
        design = json.loads((self.folder / "design.json").read_text())
        bound = design["quality"]["lower_bound"]
        if bound is not None:
            self.gap = abs(bound / design["search"]["value"] - 1)
        files = [self.folder / "design.json"] + [self.log] * self.log.exists()
        outcome = self.check(files, "3 no design is" if self.log.exists() else "1 every point")
        self.why = next((s for s in json.loads(self.ran.stdout)["left_out"] if s.startswith("certificate.jsonl")), "")
        if outcome != "proven" or self.log.exists():
            return outcome
        if bound is not None:
            return "a bound without its log"
        return "no log" if self.why else outcome

    def check(self, files, expected):
        began = processor_time()
        ran = run(sys.executable, self.options.source / "proof" / "kempe_check.py", *files)
        self.seconds = processor_time() - began
        self.claims = [line[0] for line in ran.stdout.splitlines() if ": proven" in line]
        if self.log.exists():
            text = self.log.read_bytes()
            self.bytes, self.nodes = len(text), text.count(b"\n") - 1
        left = [line for line in ran.stdout.splitlines() if re.search(": (not proven|refuted)", line)]
        unknown = re.compile(r"limits of the file: not proven: not checked: (limits\.load_error_in_all, )?limits\.(load_error|sag)_mm(, limits\.sag_mm)?")
        by_rule = all(unknown.fullmatch(line) for line in left)  # no rule of the checker speaks of loads
        if ran.returncode != (1 if left else 0) or not by_rule or expected not in ran.stdout:
            return ran.stdout + ran.stderr
        if self.seconds > MOST_SECONDS or self.bytes > MOST_BYTES:
            return f"{self.seconds:.1f} s, a log of {self.bytes} bytes"
        return "proven"

    def sharp(self):
        """What is wrong, if two micrometres more clearance than the design has are proven."""
        design = json.loads((self.folder / "design.json").read_text())
        design["limits"]["clearance_mm"] = design["quality"]["clearance_min_mm"] + 0.002
        file = self.folder / "more-clearance.json"
        file.write_text(json.dumps(design), encoding="utf-8")
        said = run(sys.executable, self.options.source / "proof" / "kempe_check.py", file).stdout
        return "" if re.search("2 the parts keep their clearance: (refuted|not proven)", said) else "more clearance: " + said

    def row(self):
        return {"spec": self.spec.name, "outcome": self.outcome, "exit": self.ran.returncode, "claims": "".join(self.claims),
                "seconds": self.seconds, "bytes": self.bytes, "nodes": self.nodes, "why": self.why, "gap": self.gap,
                "program_seconds": round(self.program_seconds, 2)}


def examples(source, root):
    (root / "none.toml").write_text(NO_DESIGN)
    (root / "in-the-way.toml").write_text(IN_THE_WAY)
    transmission = root / "transmission.toml"
    transmission.write_text((source / "specs/examples/plagiograph.toml").read_text() + "\n[objective]\nmaximize = \"transmission\"\n")
    return sorted((source / "specs" / "examples").glob("*.toml")) + [root / "none.toml", root / "in-the-way.toml", transmission]


def random_specs(source, root, count, seed, chosen=None):
    """All that a seed gives, or those of the chosen numbers."""
    rng, maker = random.Random(seed), module(source / "bench" / "random_specs.py")
    for i in range(count):
        path, spec = root / f"random-{seed}-{i}.toml", maker.spec(rng)
        if rng.random() < 0.25:
            spec["links"]["layers"] = 4
        if chosen is not None and i not in chosen:
            continue
        path.write_text(toml(spec))
        yield path


def toml(value):
    """A spec given as JSON tables, as TOML."""
    def inline(v):
        if isinstance(v, dict):
            return "{" + ", ".join(f"{k} = {inline(x)}" for k, x in v.items()) + "}"
        if isinstance(v, list):
            return "[" + ", ".join(map(inline, v)) + "]"
        return json.dumps(v)
    return "\n".join(f"{key} = {inline(each)}" for key, each in value.items()) + "\n"


def summary(rows):
    kinds = collections.Counter(row["outcome"] if row["outcome"] in ("proven", "no log", "no claim") else "fault" for row in rows)
    proven = collections.Counter(claim for row in rows for claim in row["claims"])
    times = [row["seconds"] for row in rows if row["seconds"] is not None]
    logs = [row["bytes"] for row in rows if row["bytes"]]
    return (f"{len(rows)} specs: {dict(kinds)}; claims proven: {dict(sorted(proven.items()))}; Python median "
            f"{statistics.median(times or [0]):.2f} s, largest {max(times, default=0):.1f} s; {len(logs)} logs, median "
            f"{statistics.median(logs or [0]) / 1000:.0f} kB, largest {max(logs, default=0) / 1e6:.2f} MB")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kempe")
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("count", type=int, nargs="?", help="random specs; without it some chosen ones")
    parser.add_argument("seed", type=int, nargs="?", default=CHOSEN_SEED)
    parser.add_argument("--time-limit", help="of the program, in seconds")
    parser.add_argument("--only-random", action="store_true", help="without the examples")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the specs and results, one line a spec as they come")
    options = parser.parse_args()
    rows, faults = [], []
    with tempfile.TemporaryDirectory() as temporary:
        root = options.keep or pathlib.Path(temporary)
        root.mkdir(parents=True, exist_ok=True)
        shipped = [] if options.only_random else examples(options.source, root)
        if options.count:
            specs = list(random_specs(options.source, root, options.count, options.seed))
        else:
            specs = [*random_specs(options.source, root, max(CHOSEN) + 1, CHOSEN_SEED, (*CHOSEN, *LONG, LONGEST)),
                     *random_specs(options.source, root, max(MET_BETWEEN) + 1, MET_BETWEEN_SEED, MET_BETWEEN),
                     *random_specs(options.source, root, FROM_MANY_PLACES + 1, FROM_MANY_PLACES_SEED, (FROM_MANY_PLACES,))]
        for spec in [*shipped, *specs]:
            with tempfile.TemporaryDirectory() as folder:
                trial = Trial(options, spec, pathlib.Path(folder) / "out")
                rows.append(trial.row())
                if spec in shipped and trial.ran.returncode == 0 and (wrong := trial.sharp()):
                    faults.append(f"{spec.name}: {wrong}")
            with (root / f"results-{options.seed}.jsonl").open("a") as results:
                results.write(json.dumps(rows[-1]) + "\n")
            if rows[-1]["outcome"] not in ("proven", "no log", "no claim"):
                faults.append(f"{spec.name}: {rows[-1]['outcome']}")
    for fault in faults:
        print(fault)
    left_out = [(row["spec"], row["why"]) for row in rows if row["outcome"] == "no log"]
    print("no log:", left_out)
    print(summary(rows))
    if not options.count and left_out:
        print("each of the chosen specs has a log")
        return 1
    long = [row["nodes"] for row in rows if row["spec"] == "in-the-way.toml" and row["nodes"] > FEW_LINES]
    if long:
        print("the log of an obstacle in the original has lines:", long)
        return 1
    far = [row["spec"] for row in rows if f"-{MET_BETWEEN_SEED}-" in row["spec"] and not row["gap"] < NEAR]
    if not options.count and far:
        print("bounds too far from their designs:", far)
        return 1
    claims = sum(row["bytes"] > 0 for row in rows) + len(left_out)
    return 1 if faults or len(left_out) > MOST_LEFT_OUT * claims else 0


if __name__ == "__main__":
    sys.exit(main())
