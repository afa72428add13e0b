#!/usr/bin/env python3
"""Prints what gcovr found: rooms, files below 90 %, lines not run. usage: coverage_table.py COVERAGE.json [--lines]"""
import collections
import json
import sys

ENOUGH = 0.9
ROOMS = ("geometry", "kinematics", "specs", "workspace", "synthesis")


def spans(numbers):
    """[3, 4, 5, 9] as "3-5, 9"."""
    found = []
    for n in numbers:
        if found and n == found[-1][1] + 1:
            found[-1][1] = n
        else:
            found.append([n, n])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in found)


def main():
    files = {}
    for file in json.load(open(sys.argv[1]))["files"]:
        counted = [line for line in file["lines"] if not line.get("gcovr/noncode")]
        missed = sorted(line["line_number"] for line in counted if line["count"] == 0)
        files[file["file"]] = (len(counted), missed)
    rooms = collections.defaultdict(lambda: [0, 0])
    for name, (lines, missed) in files.items():
        rooms[name.split("/")[0]][0] += lines
        rooms[name.split("/")[0]][1] += len(missed)
    below = False
    for room in ROOMS:
        lines, missed = rooms[room]
        share = 1 - missed / lines if lines else 0
        below |= share < ENOUGH
        print(f"{room:12} {100 * share:6.2f} % of {lines} lines, {missed} not run")
    for name, (lines, missed) in sorted(files.items()):
        if lines and len(missed) > (1 - ENOUGH) * lines:
            print(f"  {name}: {100 * (1 - len(missed) / lines):.1f} % of {lines}")
    if "--lines" in sys.argv:
        for name, (_, missed) in sorted(files.items()):
            if missed:
                print(f"{name}: {spans(missed)}")
    return 1 if below else 0


sys.exit(main())
