"""Any planar linkage: its motion, its freedoms, its instant centres."""
from __future__ import annotations

import json
import os
from dataclasses import dataclass, field, fields
from typing import Any, Iterator, Mapping, Optional, Sequence, TypeVar, Union

import numpy as np

from . import _core
from ._answers import NoMotion, Point, Stopped, error_of
from ._geometry import Array
from ._spec import Path, text_of

_Answer = TypeVar("_Answer")
#: A place asked for: x, y, x and y reached, direction and direction reached (poses only), share of the motion; mm, rad.
Wanted = tuple[float, float, float, float, Optional[float], Optional[float], float]
_MM = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}


@dataclass(frozen=True)
class MotionEnd:
    """How a motion ended before its time."""

    kind: str  #: "dead point", "change point", "over-constrained", ...
    step: float  #: where
    sentences: tuple[str, ...]  #: which joints are in line, which links can still move
    sentence: str  #: all of it

    def __str__(self) -> str:
        return self.sentence


@dataclass(frozen=True, eq=False)
class Motion:
    """A linkage moved by its drivers, as arrays of n moments by name. True if it went to its end.

    Points: mm, mm/s and mm/s^2 in the table's frame, arrays (n, 2), those of the ground included. Links: degrees (a full turn
    counts on), rad/s and rad/s^2, arrays (n,). NaN where a value does not exist: rates and forces where the motion stopped,
    reactions that rigid links do not determine.
    """

    linkage: str  #: its name
    unit: str  #: of lengths in .to_columns(): that of the linkage's file
    steps: Array = field(repr=False)  #: (n,); 0, 1, ..., the last a fraction where the motion ended early
    times_s: Array = field(repr=False)  #: (n,)
    positions: Mapping[str, Array] = field(repr=False)
    velocities: Mapping[str, Array] = field(repr=False)
    accelerations: Mapping[str, Array] = field(repr=False)
    angles_deg: Mapping[str, Array] = field(repr=False)  #: of each link's x axis
    rates_rad_per_s: Mapping[str, Array] = field(repr=False)
    accelerations_rad_per_s2: Mapping[str, Array] = field(repr=False)
    #: (n, 2), N: "B_on_rod" in a joint, "C_from_ground" in a guide; none without loads
    reactions: Mapping[str, Array] = field(repr=False)
    #: (n,), N or N m by the name's end: every force's column, the drivers' too ("drive_P_y_N")
    forces: Mapping[str, Array] = field(repr=False)
    force_sentences: tuple[str, ...] = field(repr=False)  #: what the forces come to
    undetermined: tuple[str, ...] = field(repr=False)  #: joints whose reactions rigid links do not determine
    end: Optional[MotionEnd]  #: None: it went to its end
    _table: Mapping[str, Array] = field(repr=False)

    def to_columns(self) -> dict[str, Array]:
        """The table of `kempe solve`, a column a name with its unit: pandas.DataFrame(motion.to_columns()) takes it.

        In the unit of the linkage's file: the points, links and transmission angles that the file wants, with velocities,
        accelerations and all forces.
        """
        return dict(self._table)

    def __bool__(self) -> bool:
        return self.end is None

    def __len__(self) -> int:
        return len(self.steps)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Motion) and all(_same(getattr(self, one.name), getattr(other, one.name)) for one in fields(self))


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, Mapping):
        return list(one) == list(other) and all(_same(one[name], other[name]) for name in one)
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=True)
    return bool(one == other)


@dataclass(frozen=True)
class Mobility:
    """How many freedoms a linkage has: counted by Gruebler, and in truth. Drivers are left out of both."""

    linkage: str  #: its name
    links: int  #: the ground included
    free_points: int  #: points that belong to no link
    full_joints: int
    sliding_pairs: int  #: those of the full joints in which a link slides without turning
    half_joints: int
    gruebler: int  #: the count
    gruebler_in_numbers: str  #: "3 (n - 1) - 2 j1 - j2 = 3 (4 - 1) - 2 * 4 - 0 = 1"
    unknowns: int
    equations: int
    rank: int  #: of the equations' Jacobian near the position looked at
    rank_here: int  #: at that position itself
    mobility: int  #: the true one: freedoms of finite motion
    drivers: int  #: driven values
    singular_position: bool  #: the position looked at has more freedoms at first order
    redundant: tuple[tuple[str, ...], ...]  #: sets of joints of which one equation says nothing new
    sentences: tuple[str, ...]  #: why count and truth differ, or that they agree
    notes: tuple[str, ...] = ()  #: what the reader understood otherwise than it was written

    def __str__(self) -> str:
        return "\n".join([self.gruebler_in_numbers, *self.sentences])


@dataclass(frozen=True)
class Centre:
    """The instant centre of two links: where both move alike."""

    links: tuple[str, str]
    kind: str  #: "finite", "infinity" or "undetermined"
    source: str  #: "primary" (a joint), "aronhold-kennedy", "velocities" or "none"
    at_mm: Optional[Point] = None  #: finite only
    direction_deg: Optional[float] = None  #: towards it; at infinity only
    joint: Optional[str] = None  #: the primary's
    lines: tuple[Mapping[str, Any], ...] = ()  #: the two on which it lies
    velocity_error: Optional[float] = None  #: how unlike the two links move at it, relative to their speed


@dataclass(frozen=True)
class Centres:
    """Every instant centre of a linkage at one moment. centres["crank", "rod"] is that of two links, in either order."""

    linkage: str  #: its name
    step: float
    time_s: float
    drivers: tuple[Mapping[str, Any], ...]  #: what each drives, with its value and rate, as in the file's unit
    all: tuple[Centre, ...] = field(repr=False)

    def __getitem__(self, links: tuple[str, str]) -> Centre:
        for centre in self.all:
            if set(centre.links) == set(links) and len(set(links)) == 2:
                return centre
        raise KeyError(links)

    def __iter__(self) -> Iterator[Centre]:
        return iter(self.all)

    def __len__(self) -> int:
        return len(self.all)


class Linkage:
    """Any planar linkage with its drivers, loads and motion. Made whole or not at all; it never changes.

    The keywords are the tables and keys of a linkage file (docs/linkage-file.md), as dicts, lists and numbers; NumPy's arrays
    too. Lengths are in its `unit`, millimetres unless it says another. Linkage.read() takes a file, Linkage.from_toml() its text.

    Raises SpecError with all faults, in the words of the file's reader.

    >>> four_bar = Linkage(ground={"O": [0, 0], "D": [80, 0]},
    ...                    links={"crank": {"joints": ["O", "A"], "O-A": 25}, "rod": {"joints": ["A", "B"], "A-B": 75},
    ...                           "rocker": {"joints": ["D", "B"], "D-B": 60}},
    ...                    drivers=[{"angle": "crank", "from_deg": 0, "to_deg": 360}], guess={"B": [82, 60]})
    >>> motion = four_bar.solve(steps=8)
    >>> motion.positions["A"][2].round(9) + 0
    array([ 0., 25.])
    >>> print(four_bar.mobility())
    3 (n - 1) - 2 j1 - j2 = 3 (4 - 1) - 2 * 4 - 0 = 1
    Gruebler's count and the true mobility agree: 1
    >>> four_bar.centres(at=0)["crank", "rod"].at_mm
    (25.0, 0.0)
    >>> Linkage(ground={"O": [0, 0]}, links={"crank": {"joints": ["O", "A"], "O-A": -25}})
    Traceback (most recent call last):
    ...
    kempe.SpecError: links.crank.O-A: found -25; allowed: the distance of two joints, > 0
    """

    __slots__ = ("_inside", "_file")
    _inside: _core.Linkage
    _file: str

    def __init__(self, **tables: Any):
        found = _core.parse_linkage(text_of(tables), "")
        if isinstance(found, list):
            raise error_of(found, lines=False)
        self._inside, self._file = found, ""

    @classmethod
    def from_toml(cls, text: str, name: str = "") -> Linkage:
        """The linkage of a file's text; `name` stands for the file in messages.

        Raises SpecError with all faults and their lines.
        """
        found = _core.parse_linkage(text, name)
        if isinstance(found, list):
            raise error_of(found)
        linkage = cls.__new__(cls)
        linkage._inside, linkage._file = found, name
        return linkage

    @classmethod
    def read(cls, file: Path) -> Linkage:
        """The linkage of a TOML file. Raises SpecError with all faults, each with its line."""
        found = _core.read_linkage(file)
        if isinstance(found, list):
            raise error_of(found)
        linkage = cls.__new__(cls)
        linkage._inside, linkage._file = found, os.fsencode(file).decode(errors="backslashreplace")
        return linkage

    def to_toml(self) -> str:
        """The text of its file."""
        return self._inside.text

    @property
    def name(self) -> str:
        """What it is called."""
        return self._inside.name

    @property
    def unit(self) -> str:
        """Of its file and of columns: "mm", "cm", "m" or "in"."""
        return self._inside.unit

    @property
    def points(self) -> list[str]:
        """The points' names, those of the ground first."""
        return self._inside.points

    @property
    def links(self) -> list[str]:
        """The links' names, without the ground."""
        return self._inside.links

    @property
    def steps(self) -> int:
        """Into how many equal parts its file cuts the motion."""
        return self._inside.steps

    @property
    def notes(self) -> list[str]:
        """What the reader understood otherwise than it was written, for people."""
        return self._inside.notes

    def solve(self, steps: Optional[int] = None, *, assembly: int = 0, seed: int = 1) -> Motion:
        """The motion that the drivers give: positions, velocities, accelerations, and forces where there are loads.

        steps     equal parts of the motion; None: as many as its file wants
        assembly  which of .assemblies(seed=seed) to start in
        seed      of the random numbers in the search for assembly modes

        Where the linkage cannot go on, the motion ends there: .end says why. Raises NoMotion where it does not assemble or cannot
        start, SpecError for steps or assembly that cannot be, and for drivers that do not fit the mobility, Stopped where the
        work allowed was spent.
        """
        found = _answer(self._inside.solve(steps, assembly, seed))
        end = found["end"]
        return Motion(linkage=self.name, unit=self.unit, steps=found["steps"], times_s=found["times"], positions=found["places"],
                      velocities=found["velocities"], accelerations=found["accelerations"],
                      angles_deg={name: np.degrees(angle) for name, angle in found["angles"].items()},
                      rates_rad_per_s=found["rates"], accelerations_rad_per_s2=found["changes"],
                      reactions=found["reactions"], forces=found["forces"],
                      force_sentences=tuple(found["force_sentences"]), undetermined=tuple(found["undetermined"]),
                      end=None if end is None else MotionEnd(end[0], end[1], tuple(end[2]), end[3]),
                      _table=found["table"])

    def assemblies(self, *, seed: int = 1) -> tuple[dict[str, Point], ...]:
        """The closed positions at the start of the motion, the chosen one first: each point's place, mm.

        Found by search: none is invented, one may be missed. Raises NoMotion where nothing closes.
        """
        return _answer(self._inside.assemblies(seed))

    def mobility(self, *, seed: int = 1) -> Mobility:
        """Gruebler's count with its numbers, the true mobility, and why they differ. Raises NoMotion where nothing closes."""
        found = json.loads(_answer(self._inside.mobility(seed)))
        return Mobility(**{name: _tuples(value) for name, value in found.items()})

    def centres(self, at: float = 0, *, assembly: int = 0, seed: int = 1) -> Centres:
        """Every instant centre at a step, whole or not, of its file's motion.

        Raises NoMotion where the motion does not get there.
        """
        found = json.loads(_answer(self._inside.centres(at, assembly, seed)))
        centres = tuple(self._centre(one) for one in found["centres"])
        return Centres(found["linkage"], found["step"], found["time_s"], tuple(found["drivers"]), centres)

    def _centre(self, found: dict[str, Any]) -> Centre:
        keys = [f"{axis}_{self.unit}" for axis in "xy"]
        if keys[0] in found:
            x, y = (found.pop(key) * _MM[self.unit] for key in keys)
            found["at_mm"] = (x, y)
        return Centre(**{name: tuple(value) if isinstance(value, list) else value for name, value in found.items()})

    def centres_drawing(self, at: float = 0, *, assembly: int = 0, seed: int = 1) -> str:
        """The same drawn on the linkage, the text of an SVG file."""
        return _answer(self._inside.centres_drawing(at, assembly, seed))

    def centres_page(self, at: float = 0, *, assembly: int = 0, seed: int = 1) -> str:
        """The same found step by step by Aronhold and Kennedy's theorem, the text of an HTML page that needs no other file."""
        return _answer(self._inside.centres_page(at, assembly, seed))

    def equations(self, at: float = 0, *, assembly: int = 0, seed: int = 1) -> dict[str, Any]:
        """The loop equations at a step with their numbers and derivatives: `kempe solve --equations --json` as a dict."""
        found: dict[str, Any] = json.loads(_answer(self._inside.equations(at, assembly, seed)))
        return found

    def animation(self, kind: str = "html", *, steps: Optional[int] = None, assembly: int = 0, seed: int = 1) -> str:
        """The linkage moving, the text of one file without a network: "html" has a slider, "svg" plays by itself."""
        return self._animation(kind, (), steps, assembly, seed)

    def _animation(self, kind: str, wanted: Sequence[Wanted] = (), steps: Optional[int] = None, assembly: int = 0, seed: int = 1) -> str:
        """The same with the places that its point P was asked for."""
        if kind not in ("html", "svg"):
            raise ValueError(f"an animation is \"html\" or \"svg\"; found {kind!r}")
        return _answer(self._inside.animation(kind == "html", steps, assembly, seed, wanted))

    def _repr_svg_(self) -> Optional[str]:
        try:
            return self.animation("svg")
        except (NoMotion, Stopped, ValueError):
            return None  # it does not move

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Linkage) and (self.to_toml(), self.name) == (other.to_toml(), other.name)

    def __hash__(self) -> int:
        return hash((self.to_toml(), self.name))

    def __reduce__(self) -> Any:
        return Linkage.from_toml, (self.to_toml(), self._file)

    def __repr__(self) -> str:
        return f"<kempe.Linkage: {self.name!r}, {len(self.links)} links, {len(self.points)} points>"


def number_synthesis(links: int, freedoms: int = 1) -> dict[str, Any]:
    """The assortments of links of which a chain with these freedoms can be made: `kempe mobility --links --json` as a dict.

    `links` 2 to 40, the ground included; `freedoms` 0 to 40. Raises SpecError beyond.

    >>> number_synthesis(6)["assortments"]
    [{'n2': 4, 'n3': 2, 'n4': 0}]
    """
    found = _core.chains(links, freedoms)
    if isinstance(found, list):
        raise error_of(found)
    answer: dict[str, Any] = json.loads(found)
    return answer


def _answer(found: Union[_Answer, list[tuple[str, int, str, str, str]], _core.NoMotion]) -> _Answer:
    """The answer, or the error that says why there is none."""
    if isinstance(found, list):
        raise error_of(found)
    if isinstance(found, _core.NoMotion):
        raise Stopped(found.sentence) if found.stopped else NoMotion(found.sentence)
    return found


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value
