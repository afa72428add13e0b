#!/usr/bin/env python3
"""Random specs as one batch on one thread: the slowest of them, and how far designs are from their proven bound.

usage: slowest.py KEMPE [COUNT] [SEED] [FOLDER]

CPU time of a spec is what the process used between two lines of the batch's journal, looked at every hundredth of a second.
Ctrl-C ends the batch; what came of it by then is told.
"""
import json
import pathlib
import subprocess
import sys
import time

import random_specs

LISTED = 12
NEAR = {"no obstacles": 1e-4, "obstacles": 1e-2}  # shares of the bound that are asked for


def cpu_so_far(pid):
    """s, of all threads of a running process; None if it has ended."""
    try:
        return 1e-9 * sum(int((task / "schedstat").read_text().split()[0]) for task in pathlib.Path(f"/proc/{pid}/task").iterdir())
    except (FileNotFoundError, ProcessLookupError):
        return None


def journal(out):
    """The whole lines of a batch's journal: on one thread in the order of the specs."""
    return [line for file in out.glob("journal-*.jsonl") for line in file.read_bytes().splitlines(keepends=True) if line.endswith(b"\n")]


def timed(kempe, lines, out):
    """The results of a batch, each with its CPU seconds."""
    process = subprocess.Popen([kempe, "synthesize", "--batch", lines, "-o", out, "-j", "1", "--quiet"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seconds, before, last, ended = [], 0.0, 0.0, False
    read, known = {}, 0  # bytes of each file of the journal, and the whole lines in all
    try:
        while not ended:
            ended = process.poll() is not None
            last = cpu_so_far(process.pid) or last
            for file in out.glob("journal-*.jsonl"):
                with file.open("rb") as lines_of_file:
                    lines_of_file.seek(read.get(file, 0))
                    new = lines_of_file.read()
                read[file] = read.get(file, 0) + len(new)
                known += new.count(b"\n")
            if known > len(seconds):  # several that were quick share what they took
                seconds += [(last - before) / (known - len(seconds))] * (known - len(seconds))
                before = last
            time.sleep(0.01)
    except KeyboardInterrupt:  # what there is by then
        process.terminate()
    return [json.loads(json.loads(line)["result"]) for line in journal(out)[:len(seconds)]], seconds


def kind(spec):
    """What makes a spec costly, in words."""
    words = [f"{spec['links'].get('layers', 2)} layers", "free pole" if "within_mm" in spec["pole"] else "fixed pole"]
    words += [f"{len(spec['obstacles'])} obstacles"] if "obstacles" in spec else []
    words += [key for key in spec["limits"] if key not in ("transmission_deg", "clearance_mm")]
    words += ["grid"] if "grid_mm" in spec["links"] else []
    return ", ".join([*words, *(f"{key} {value}" for key, value in spec.get("objective", {}).items())])


def main():
    kempe, folder, specs, lines = random_specs.written(sys.argv[1:])
    rows, seconds = timed(kempe, lines, folder / "out")
    print(f"{len(rows)} specs, {sum(seconds):.0f} s of CPU, {sum(s > 60 for s in seconds)} above a minute")
    for i in sorted(range(len(rows)), key=lambda i: -seconds[i])[:LISTED]:
        proven = ", proven" if rows[i].get("proven") else ""
        print(f"  {i:5d}  {seconds[i]:6.1f} s  {rows[i]['status']}{proven}: {kind(specs[i])}")
    for name, near in NEAR.items():
        gaps = sorted((g, i) for i, row in enumerate(rows) if row["status"] == "design" and ("obstacles" in specs[i]) == (name == "obstacles")
                      for g in [random_specs.gap(row)] if g is not None)
        within = sum(g <= near for g, _ in gaps)
        print(f"{name}: {within} of {len(gaps)} within {100 * near:g} % of their bound")
        for g, i in reversed(gaps[-LISTED:]):
            if g > near:
                print(f"  {i:5d}  {100 * g:6.2f} %  {kind(specs[i])}")


if __name__ == "__main__":
    main()
