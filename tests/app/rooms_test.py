#!/usr/bin/env python3
"""The rooms' order: a file includes only its own room and those below it, and the heavy libraries stay in their files."""
import pathlib
import re
import sys

ROOMS = ["kinematics", "specs", "workspace", "synthesis", "reports", "app"]
HEAVY = {  # a library's headers -> the files that may include them
    r"CGAL/": r"_backend\.cpp$",
    r"nlopt": r"_backend\.cpp$",
    r"Ip[A-Z]|coin": r"_backend\.cpp$",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.M)


def faults_of(path, room):
    text = path.read_text(encoding="utf-8")
    for included in INCLUDE.findall(text):
        first = included.split("/")[0]
        if first in ROOMS and ROOMS.index(first) > ROOMS.index(room):
            yield f"{path}: {room} may not include {included}"
        for library, allowed in HEAVY.items():
            if re.match(library, included) and not re.search(allowed, path.name):
                yield f"{path}: {included} belongs into a *_backend.cpp"
    if room != "app" and re.search(r"\bstd::(cout|cerr|exit)\b|\b(exit|abort)\s*\(|[^f]printf\s*\(", text):
        yield f"{path}: only app/ writes to the terminal or exits"


def main(root):
    faults = []
    for room in ROOMS:
        for path in sorted(p for e in ("*.hpp", "*.cpp") for p in (root / room).rglob(e)):
            if "node_modules" not in path.parts:
                faults += faults_of(path, room)
    print("\n".join(faults) or f"{len(ROOMS)} rooms in order")
    return 1 if faults else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
