#!/usr/bin/env python3
"""The rooms' order: a file includes only its own folder and those below it, the heavy libraries stay in their files, and no two
types outside unnamed namespaces share a full name (the linker would silently take one's functions for the other's)."""
import collections
import pathlib
import re
import sys

# From the ground up. A folder may use those before it; a room's own level stands where its folders use it or are used by it.
FOLDERS = [
    "geometry", "geometry/regions",
    "kinematics", "kinematics/planar",
    "specs/text", "specs/drawings", "specs", "specs/linkages",
    "workspace", "workspace/contact", "workspace/map",
    "synthesis/solvers", "synthesis/tolerance", "synthesis/problem", "synthesis/bound", "synthesis/search", "synthesis/design",
    "synthesis/verification", "synthesis/calibration", "synthesis/functions",
    "reports/pictures", "reports/data", "reports/drawings", "reports/page", "reports/linkages", "reports/calibration",
    "reports/audit", "reports",
    "app", "app/commands",
]
ROOMS = sorted({folder.split("/")[0] for folder in FOLDERS})
HEAVY = {  # a library's headers -> the files that may include them
    r"CGAL/": r"_backend\.cpp$",
    r"nlopt": r"_backend\.cpp$",
    r"Ip[A-Z]|coin": r"_backend\.cpp$",
}
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|enum(?: class)?) (\w+)(?: final)?(?: :| \{|$)")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.M)


def faults_of(path, folder):
    text = path.read_text(encoding="utf-8")
    if folder not in FOLDERS:
        yield f"{path}: the folder {folder} has no place in the order of the rooms"
        return
    for included in INCLUDE.findall(text):
        used = included.rpartition("/")[0]
        if used in FOLDERS and FOLDERS.index(used) > FOLDERS.index(folder):
            yield f"{path}: {folder} may not include {included}"
        elif used.split("/")[0] in ROOMS and used not in FOLDERS:
            yield f"{path}: {included} lies in no folder of the rooms"
        for library, allowed in HEAVY.items():
            if re.match(library, included) and not re.search(allowed, path.name):
                yield f"{path}: {included} belongs into a *_backend.cpp"
    if not folder.startswith("app") and re.search(r"\bstd::(cout|cerr|exit)\b|\b(exit|abort)\s*\(|[^f]printf\s*\(", text):
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
            faults += faults_of(path, path.parent.relative_to(root).as_posix())
            for name in types_in(path):
                homes[name].append(str(path))
    for name, files in homes.items():
        if len(files) > 1:
            faults.append(f"{name} is defined more than once: {', '.join(files)}")
    print("\n".join(faults) or f"{len(FOLDERS)} folders of {len(ROOMS)} rooms in order")
    return 1 if faults else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
