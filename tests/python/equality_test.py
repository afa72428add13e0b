#!/usr/bin/env python3
"""Random tasks give the same design, to the byte of design.json, through the text of a file, keywords, C++ and the program.

usage: equality_test.py TWIN PROGRAM [COUNT [FIRST]]     PYTHONPATH leads to the module; every fifth task goes through the program
"""
import pathlib
import subprocess
import sys
import tempfile

import kempe
from tasks import Task

twin, program = sys.argv[1:3]
count, first = (int(word) for word in (sys.argv[3:] + ["20", "1"][len(sys.argv) - 3:]))
OPTIONS = {"largest_sheets": False, "diagnose": False, "threads": 1}


def texts(tasks):
    """What C++ makes of each task."""
    lines = "\n".join(task.line() for task in tasks) + "\n"
    told = subprocess.run([twin], input=lines.encode(), capture_output=True, check=True).stdout
    while told:
        size, _, told = told.partition(b"\n")
        yield told[:int(size)].decode()
        told = told[int(size):]


def answer(spec):
    try:
        return kempe.synthesize(spec, **OPTIONS).to_json()
    except kempe.NoDesign as none:
        return none.sentence


def by_program(task, folder):
    (folder / "spec.toml").write_text(task.toml())
    done = subprocess.run([program, "synthesize", folder / "spec.toml", "-o", folder / "theirs", "--quiet"], capture_output=True)
    return (folder / "theirs" / "design.json").read_bytes() if done.returncode == 0 else None


def saved(task, folder):
    kempe.synthesize(kempe.Spec(**task.keywords())).save(folder / "ours")
    return (folder / "ours" / "design.json").read_bytes()


tasks = [Task(number) for number in range(first, first + count)]
faults, designs = [], 0
for number, (task, expected) in enumerate(zip(tasks, texts(tasks), strict=True), first):
    by_keywords, by_text = answer(kempe.Spec(**task.keywords())), answer(kempe.Spec.from_toml(task.toml()))
    has_design = expected.startswith("{")
    designs += has_design
    if not expected == by_keywords == by_text:
        faults.append(f"task {number}: C++ {len(expected)} bytes, keywords {len(by_keywords)}, text {len(by_text)}")
    if has_design and number % 5 == 0:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            if by_program(task, folder) != saved(task, folder):
                faults.append(f"task {number}: the program's design.json is another one")
print("\n".join(faults) or f"{count} tasks, {designs} designs, the same in all ways")
sys.exit(1 if faults or designs * 2 < count else 0)
