#!/usr/bin/env python3
"""Random specs with obstacles through two builds of Kempe: is the new one's design ever worse, or its bound looser?

usage: two_builds.py OLD_KEMPE NEW_KEMPE [COUNT] [SEED] [FOLDER]

A design is worse if its value is, by more than a millionth; a bound is looser likewise. CPU is that of each whole batch on one
thread. Exit code 1 if any design is lost or worse, or any bound looser.
"""
import json
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

import random_specs

WORSE = 1e-6


def specs_with_obstacles(count, seed):
    rng = random.Random(seed)
    found = []
    while len(found) < count:
        one = random_specs.spec(rng)
        if "obstacles" in one:
            found.append(one)
    return found


def run(kempe, lines, out):
    """The rows of a batch in their order, and its CPU seconds."""
    def spent():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    before = spent()
    subprocess.run([kempe, "synthesize", "--batch", lines, "-o", out, "-j", "1", "--quiet"], check=False)
    rows = [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]
    return rows, spent() - before


def excess(old, new, maximised):
    """By what share the new figure is worse than the old one."""
    if old == new:
        return 0.0
    return (old - new if maximised else new - old) / abs(old)


def compare(specs, old_rows, new_rows):
    """What is worse, in words; and how many designs are the same, better, and proven better or worse bounded."""
    faults, better, tighter, both = [], 0, 0, 0
    for number, (spec, old, new) in enumerate(zip(specs, old_rows, new_rows)):
        maximised = spec.get("objective", {}).get("maximize") == "transmission"
        if old["status"] != new["status"]:
            (faults if old["status"] == "design" else []).append(f"{number}: {old['status']} -> {new['status']}")
            print(f"{number}: {old['status']} -> {new['status']}")
            continue
        if old["status"] != "design":
            if old.get("proven") and not new.get("proven"):
                faults.append(f"{number}: no longer proven")
            continue
        both += 1
        worse = excess(old["value"], new["value"], maximised)
        better += worse < -WORSE
        if worse > WORSE:
            faults.append(f"{number}: worse by {worse:.2g}")
        if old.get("lower_bound") is not None:
            if new.get("lower_bound") is None:
                faults.append(f"{number}: bound lost")
                continue
            looser = excess(new["lower_bound"], old["lower_bound"], maximised)
            tighter += looser < -WORSE
            if looser > WORSE:
                faults.append(f"{number}: bound looser by {looser:.2g}")
    print(f"{both} designs in both; {better} better, {tighter} bounds tighter; {len(faults)} faults")
    return faults


def main():
    old, new = sys.argv[1:3]
    count, seed = (int(sys.argv[i]) if len(sys.argv) > i else default for i, default in ((3, 200), (4, 1)))
    folder = pathlib.Path(sys.argv[5] if len(sys.argv) > 5 else tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    specs = specs_with_obstacles(count, seed)
    lines = folder / "specs.jsonl"
    lines.write_text("".join(json.dumps(one) + "\n" for one in specs))
    old_rows, old_cpu = run(old, lines, folder / "old")
    new_rows, new_cpu = run(new, lines, folder / "new")
    print(f"CPU of {count} specs: {old_cpu:.1f} s, {new_cpu:.1f} s: {count / old_cpu:.2f} and {count / new_cpu:.2f} specs a second")
    faults = compare(specs, old_rows, new_rows)
    for fault in faults:
        print("FAULT", fault)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
