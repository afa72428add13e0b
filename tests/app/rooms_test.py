#!/usr/bin/env python3
"""The rooms' order: a file includes only its own folder and those below it, the heavy libraries stay in their files,
the public headers (include/kempe) stand on their own, and no two
types outside unnamed namespaces share a full name (the linker would silently take one's functions for the other's)."""
import collections
import importlib.machinery
import importlib.util
import pathlib
import re
import sys

loader = importlib.machinery.SourceFileLoader("rooms", str(pathlib.Path(sys.argv[1]) / "scripts" / "rooms"))
rooms = importlib.util.module_from_spec(importlib.util.spec_from_loader("rooms", loader))
sys.dont_write_bytecode = True
loader.exec_module(rooms)
FOLDERS, ROOMS = rooms.FOLDERS, rooms.ROOMS
HEAVY = {  # a library's headers -> the files that may include them
    r"CGAL/": r"_backend\.cpp$|^interval\.hpp$",
    r"geometry/interval\.hpp": r"_backend\.cpp$|^(reach_intervals|load_waves|first_order|instrument_box)\.hpp$",
    r"synthesis/bound/(reach_intervals|load_waves|first_order|tracer_place|touch_figures)\.hpp":
        r"_backend\.cpp$|^(tracer_place|touch_figures)\.hpp$",
    r"synthesis/tolerance/instrument_box\.hpp": r"_backend\.cpp$",
    r"nlopt": r"_backend\.cpp$",
    r"Ip[A-Z]|coin": r"_backend\.cpp$",
    r"hpdf": r"_backend\.cpp$",
}
# The public headers that need the whole library below them; the others hold the values that every room uses.
FACADE = {f"kempe/{name}.hpp" for name in ("calibrate", "design", "generators", "kempe", "map", "sketch", "trace", "validate", "verify", "write")}
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|enum(?: class)?) (\w+)(?: final)?(?: :| \{|$)")


def faults_of(path, folder):
    text = path.read_text(encoding="utf-8")
    if folder not in FOLDERS:
        yield f"{path}: the folder {folder} has no place in the order of the rooms"
        return
    for included in rooms.INCLUDE.findall(text):
        used = included.rpartition("/")[0]
        if folder == "kempe" and not re.fullmatch(r"kempe/\w+\.hpp|Eigen/\w+|[a-z_]+", included):
            yield f"{path}: a public header includes the standard library, Eigen and its like, not {included}"
        if included in FACADE and folder == "kempe" and f"kempe/{path.name}" not in FACADE:
            yield f"{path}: it includes {included} and belongs to the same headers: FACADE lacks it"
        if included in FACADE and folder not in ("kempe", "library", "python", "studio"):
            yield f"{path}: {included} is for users of the library; inside it only library/, python/ and studio/ include it"
        if folder == "python" and used in FOLDERS and used not in ("kempe", "python"):
            yield f"{path}: python/ knows the library by its public headers alone, not {included}"
        if used in FOLDERS and FOLDERS.index(used) > FOLDERS.index(folder):
            yield f"{path}: {folder} may not include {included}"
        elif used.split("/")[0] in ROOMS and used not in FOLDERS:
            yield f"{path}: {included} lies in no folder of the rooms"
        for library, allowed in HEAVY.items():
            if re.match(library, included) and not re.search(allowed, path.name):
                yield f"{path}: {included} belongs into a *_backend.cpp"
    if not folder.startswith("app") and path.name != "invariant.cpp" and re.search(r"\bstd::(cout|cerr|exit)\b|\b(exit|abort)\s*\(|[^fn]printf\s*\(", text):
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


def main(root):
    faults, homes = [], collections.defaultdict(list)
    for room in ROOMS:
        for path in rooms.sources(root / rooms.PLACES.get(room, room)):
            faults += faults_of(path, rooms.folder_of(path, root))
            for name in types_in(path):
                homes[name].append(str(path))
    for name, files in homes.items():
        if len(files) > 1:
            faults.append(f"{name} is defined more than once: {', '.join(files)}")
    picture = root / "docs" / "pictures" / "rooms.svg"
    if picture.read_text(encoding="utf-8") != rooms.picture(root):
        faults.append(f"{picture} is not the picture of these sources: run scripts/rooms")
    print("\n".join(faults) or f"{len(FOLDERS)} folders of {len(ROOMS)} rooms in order")
    return 1 if faults else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
