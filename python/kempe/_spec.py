"""Tasks: kempe.Spec, from keywords, text or a file."""
from __future__ import annotations

import os
import tomllib
from typing import Any, Mapping, Union

from . import _core
from ._answers import Fault, SpecError, error_of
from ._geometry import Region
from ._text import Unsayable, toml_of

Path = Union[str, "os.PathLike[str]"]
_WHOLE = ("region", "pole", "table", "objective")


def text_of(tables: Mapping[str, Any]) -> str:
    """The tables as a file's text; SpecError for what no file can hold."""
    try:
        return toml_of(tables)
    except Unsayable as fault:
        raise SpecError([Fault(None, None, fault.key, fault.found, fault.allowed)]) from None
    except RecursionError:
        raise SpecError([Fault(None, None, "", "lists in lists without end", "tables of keys and values")]) from None


class Spec:
    """A task: how to copy, what to cover, what to build of. Made whole or not at all.

    The keywords are the tables of a spec's file (docs/spec.md), their values dicts of its keys: millimetres where a key ends
    in _mm, degrees where it ends in _deg. NumPy's arrays and numbers may stand for lists and numbers, a complex number for a
    point, None for what is left out. Some tables have a short form:

    copy       a complex ratio k (its scale |k|, its rotation arg k), a number or "1:3" for the scale alone
    region     a shape with __geo_interface__ (a Shapely polygon), or an array (n, 2) of the corners
    pole       a place (x, y) or x + 1j * y; a shape in which it may stand
    table      like region
    obstacles  one, or a list: each a dict, a shape, or corners; bodies the same
    material   its name
    objective  "transmission", or what is made small: "size", "copy_error", "footprint", "load_error", "mass"

    Raises SpecError with all faults, in the words of the file's reader.

    >>> spec = Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "pin_diameter_mm": 3})
    >>> spec.copy
    1.4j
    >>> Spec(copy=2, region={"circle_mm": [80, 0, 20]}, links={"widht_mm": 6}, limits={"transmission_deg": 100})
    Traceback (most recent call last):
    ...
    kempe.SpecError: links.widht_mm: found an unknown key; allowed: width_mm (the nearest known key)
    limits.transmission_deg: found 100; allowed: a number >= 0 and < 90 degrees
    """

    __slots__ = ("_inside",)
    _inside: _core.Spec

    def __init__(self, **tables: Any):
        found = _core.parse(text_of(tables), "", os.getcwd())
        if isinstance(found, list):
            raise error_of(found, lines=False)
        self._inside = found

    @classmethod
    def _of(cls, inside: _core.Spec) -> Spec:
        spec = cls.__new__(cls)
        spec._inside = inside
        return spec

    @classmethod
    def from_toml(cls, text: str, folder: Path = ".") -> Spec:
        """The spec of a file's text; a drawing that it names is looked for in `folder`.

        Raises SpecError with all faults and their lines.

        >>> Spec.from_toml("[copy]\\nscale = 2\\n[region]\\ncircle_mm = [80, 0, 20]").copy
        (2+0j)
        """
        found = _core.parse(text, "", folder)
        if isinstance(found, list):
            raise error_of(found)
        return cls._of(found)

    def to_toml(self) -> str:
        """The text of a file with this spec; what has its default value is left out.

        >>> print(Spec(copy="1:2", region={"circle_mm": [80, 0, 20]}, pole=(0, 5)).to_toml().split("[region]")[0])
        [copy]
        scale = 0.5
        <BLANKLINE>
        """
        return self._inside.toml()

    def replace(self, **tables: Any) -> Spec:
        """The same spec with other keys; a dict's keys join those that are there, None takes a table or key away.

        Whole are replaced what a dict says in one of several ways (region, pole, table, objective), obstacles and bodies.

        >>> spec = Spec(copy=2, region={"circle_mm": [80, 0, 20]}, limits={"clearance_mm": 1})
        >>> print(spec.replace(limits={"transmission_deg": 25}).to_toml().split("[limits]")[1])
        <BLANKLINE>
        clearance_mm = 1.0
        transmission_deg = 25.0
        <BLANKLINE>
        """
        old = tomllib.loads(self.to_toml())
        for name, given in tables.items():
            joins = name not in _WHOLE and isinstance(given, Mapping) and isinstance(old.get(name), Mapping)
            old[name] = {**old[name], **given} if joins else given
        return Spec(**old)

    @property
    def title(self) -> str:
        """Heads report and drawings; "" for none."""
        return self._inside.title

    @property
    def copy(self) -> complex:
        """The ratio wanted: pen - pole = k (tracer - pole)."""
        return self._inside.copy

    @property
    def region(self) -> Region:
        """What the tracer must cover, mm."""
        return Region(self._inside.region)

    @property
    def objective(self) -> str:
        """What is sought: "size", "transmission", ..."""
        return self._inside.objective

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Spec) and self.to_toml() == other.to_toml()

    def __hash__(self) -> int:
        return hash(self.to_toml())

    def __reduce__(self) -> Any:
        return Spec.from_toml, (self.to_toml(),)

    def __repr__(self) -> str:
        title = f"{self.title!r}, " if self.title else ""
        return f"<kempe.Spec: {title}copy {self.copy:.6g}, region {self.region.area:.6g} mm2, objective {self.objective}>"


def load(file: Path) -> Spec:
    """The spec of a TOML file (docs/spec.md); a drawing that it names is looked for beside it.

    Raises SpecError with all faults, each with its line.
    """
    found = _core.load(file)
    if isinstance(found, list):
        raise error_of(found)
    return Spec._of(found)
