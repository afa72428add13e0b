#!/usr/bin/env python3
"""The rooms' order: a file includes only its own room and those below it, the heavy libraries stay in their files, and no two
types outside unnamed namespaces share a full name (the linker would silently take one's functions for the other's)."""
import collections
import pathlib
import re
import sys

ROOMS = ["kinematics", "specs", "workspace", "synthesis", "reports", "app"]
HEAVY = {  # a library's headers -> the files that may include them
    r"CGAL/": r"_backend\.cpp$",
    r"nlopt": r"_backend\.cpp$",
    r"Ip[A-Z]|coin": r"_backend\.cpp$",
}
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|enum(?: class)?) (\w+)(?: final)?(?: :| \{|$)")
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


def types_in(path):
    """The full names of the types a file defines at namespace level, outside unnamed namespaces."""
    spaces = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if opened := re.match(r"(?:inline )?namespace(?: ([\w:]+))? \{", line):
            spaces.append(opened[1])
        elif line.startswith("}  // namespace"):
            spaces.pop()
        elif (named := TYPE.match(line)) and None not in spaces:
            yield "::".join(spaces + [named[1]])


def sources(folder):
    return sorted(p for e in ("*.hpp", "*.cpp") for p in folder.rglob(e) if "node_modules" not in p.parts)


def main(root):
    faults, homes = [], collections.defaultdict(list)
    for room in ROOMS:
        for path in sources(root / room):
            faults += faults_of(path, room)
            for name in types_in(path):
                homes[name].append(str(path))
    for name, files in homes.items():
        if len(files) > 1:
            faults.append(f"{name} is defined more than once: {', '.join(files)}")
    print("\n".join(faults) or f"{len(ROOMS)} rooms in order")
    return 1 if faults else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
