#!/usr/bin/env python3
"""docs/teaching.md: every command that the page shows is run, and prints what the page quotes.

usage: teaching_test.py KEMPE SOURCE_DIR [--print]     --print: what the commands print, instead of comparing

In a block of the kind `console` a line that begins with `$ ` is a command for bash. The lines under it are its output, first standard output, then
standard error; `...` stands for any number of lines left out, and `exit code N` comes last if N is not 0. Numbers may differ in their last digits.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)


def shown(page):
    """Each command of the page with the lines quoted under it."""
    for block in BLOCK.findall(page):
        for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, *quoted = part.rstrip("\n").split("\n")
            yield command, quoted


def is_same(quoted, printed):
    """The same words, and numbers within 1e-6 of each other or of 1e-9."""
    if NUMBER.sub("#", quoted) != NUMBER.sub("#", printed):
        return False
    pairs = zip(NUMBER.findall(quoted), NUMBER.findall(printed))
    return all(abs(float(a) - float(b)) <= 1e-9 + 1e-6 * abs(float(a)) for a, b in pairs)


def matches(quoted, printed):
    if not quoted:
        return not printed
    if quoted[0] == "...":
        return any(matches(quoted[1:], printed[i:]) for i in range(len(printed) + 1))
    return bool(printed) and is_same(quoted[0], printed[0]) and matches(quoted[1:], printed[1:])


def run(command, folder, environment):
    done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=folder, env=environment, capture_output=True, text=True, timeout=120)
    lines = (done.stdout + done.stderr).splitlines()
    return lines + ([f"exit code {done.returncode}"] if done.returncode else [])


def main(kempe, source, only_print):
    page = (source / "docs" / "teaching.md").read_text(encoding="utf-8")
    faults = []
    exercises = re.split(r"^## (?=\d+\. )", page, flags=re.M)[1:]
    if [int(text.split(".")[0]) for text in exercises] != list(range(1, 11)):
        faults.append("the exercises are not numbered 1 to 10")
    faults += [f"exercise {text.splitlines()[0]} has no command" for text in exercises if not BLOCK.search(text)]
    faults += [f"exercise {text.splitlines()[0]} has no answer" for text in exercises if "**Answer.**" not in text]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "specs").symlink_to(source / "specs")
        (folder / "bin").mkdir()
        (folder / "bin" / "kempe").symlink_to(kempe)
        environment = dict(os.environ, PATH=f"{folder / 'bin'}:{os.environ['PATH']}", LC_ALL="C")
        count = 0
        for count, (command, quoted) in enumerate(shown(page), 1):
            printed = run(command, folder, environment)
            if only_print:
                print("\n".join([f"$ {command}", *printed]))
            elif not matches(quoted, printed):
                faults.append("\n".join([f"$ {command}", "prints", *printed, "and the page quotes", *quoted]))
    print("\n".join(faults) or f"{count} commands print what the page quotes")
    return 1 if faults or count < 10 else 0


if __name__ == "__main__":
    if shutil.which("bash") is None:
        sys.exit("no bash")
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), "--print" in sys.argv))
