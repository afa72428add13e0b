#!/usr/bin/env python3
"""The animation of README.md is what scripts/animation makes of this program's output, to the last digit that it writes."""
import pathlib
import re
import subprocess
import sys
import tempfile

NUMBER = re.compile(r"-?(?:\d+\.?\d*|\.\d+)")


def main(kempe, source):
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder, "copying.svg")
        subprocess.run([source / "scripts/animation", "--kempe", kempe, "-o", made], check=True)
        now, stored = made.read_text(), (source / "docs/pictures/copying.svg").read_text()
    same = NUMBER.sub("#", now) == NUMBER.sub("#", stored)
    same = same and all(abs(float(a) - float(b)) < 0.02 for a, b in zip(NUMBER.findall(now), NUMBER.findall(stored)))
    print("the animation is current" if same else "docs/pictures/copying.svg is old: run scripts/animation")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2])))
