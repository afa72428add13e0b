"""The program kempe and the files that are installed with it, seen from the package."""
from __future__ import annotations

import os
import pathlib
import sys
from typing import NoReturn

from ._answers import Error

_PACKAGE = pathlib.Path(__file__).absolute().parent  # of a link, where it leads from
_BUILD = _PACKAGE.parents[1]


def program() -> pathlib.Path:
    """The program `kempe` that belongs to this module: what the environment's KEMPE_PROGRAM names, the one in the package (of a wheel),
    in the build's folder, or in bin/ of the folder where the module is installed. Raises Error where there is none.
    """
    if named := os.environ.get("KEMPE_PROGRAM"):
        return pathlib.Path(named)
    places = [folder / "bin" / "kempe" for folder in (_PACKAGE, *_PACKAGE.parents)]
    if (_BUILD / "CMakeCache.txt").exists():
        places.insert(0, _BUILD / "app" / "kempe")
    for place in places:
        if place.is_file() and os.access(place, os.X_OK):
            return place
    raise Error("the program kempe is not installed beside this module; the environment's KEMPE_PROGRAM may name it")


def studio_file() -> pathlib.Path:
    """The page that scripts/studio has built, as `kempe studio` finds it. Raises Error where there is none."""
    if named := os.environ.get("KEMPE_STUDIO"):
        return pathlib.Path(named)
    places = [folder / "share" / "kempe" / "studio.html" for folder in (_PACKAGE, *_PACKAGE.parents)]
    if (_BUILD / "CMakeCache.txt").exists():
        places.insert(0, _BUILD.parents[1] / "out" / "studio.html")
    for place in places:
        if place.is_file():
            return place
    raise Error("the studio's page is not there: scripts/studio builds it; the environment's KEMPE_STUDIO may name its place")


def main() -> NoReturn:
    """`python -m kempe COMMAND ...`: the program takes the place of Python, with the same words, streams and exit code."""
    try:
        found = program()
    except Error as fault:
        sys.exit(f"kempe: {fault}")
    try:
        os.execv(found, [str(found), *sys.argv[1:]])
    except OSError as fault:
        sys.exit(f"kempe: {found}: {fault.strerror}")
