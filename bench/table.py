#!/usr/bin/env python3
"""Kempe beside its peers, in one table: what was measured, on what, the ratio, and whether the target is reached.

usage: table.py BUILD_FOLDER [--quick] [--only SECTION ...]
"""
import argparse
import datetime
import os
import pathlib
import platform
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import batch
import drag
import forward
import growth
import kernels
import limits
import python_module
import sampler
import studio
import synthesis
from measure import HEAD, Context

SECTIONS = {"kernels": kernels, "forward": forward, "sampler": sampler, "growth": growth, "synthesis": synthesis, "batch": batch,
            "drag": drag, "limits": limits, "python": python_module, "studio": studio}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="fewer rounds, a weaker differential evolution: some minutes")
    parser.add_argument("--only", nargs="+", choices=SECTIONS, default=list(SECTIONS))
    arguments = parser.parse_args()
    context = Context(arguments.build.resolve(), arguments.quick)
    how = "quick run" if arguments.quick else "full run"
    print(f"{datetime.date.today()}, {os.cpu_count()} cores {platform.machine()}, {platform.system()}, {how}; times are CPU time "
          f"of one core, the least of several rounds; load at the start {os.getloadavg()[0]:.1f}\n")
    print(HEAD)
    missed = 0
    for name in arguments.only:
        for row in SECTIONS[name].rows(context):
            print(row.line(), flush=True)
            missed += row.reached is False
    print(f"\n{missed} targets not reached")


main()
