"""What comes back beside designs: faults, reasons, verdicts, checks."""
from __future__ import annotations

import csv
from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ._geometry import Array

Point = tuple[float, float]


@dataclass(frozen=True)
class Fault:
    """Something that is wrong with a spec or a file."""

    file: Optional[str]  #: as it was named; None if not from a file
    line: Optional[int]  #: from 1; None: no one line
    key: str  #: "copy.scale"; "" for no one key
    found: str  #: what stands there
    allowed: str  #: what may stand there

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line) if part is not None)
        parts = [place, self.key, f"found {self.found}" if self.found else ""]
        return ": ".join(part for part in parts if part) + (f"; allowed: {self.allowed}" if self.allowed else "")


@dataclass(frozen=True)
class Change:
    """A limit that, moved so far and alone, makes a design possible; or an obstacle that, taken away alone, does."""

    key: str  #: "links.longest_mm"
    sentence: str

    def __str__(self) -> str:
        return self.sentence


class Error(Exception):
    """What kempe raises of its own."""


class SpecError(Error, ValueError):
    """A spec, or a file, in which something is wrong: all of it, in .faults."""

    def __init__(self, faults: Sequence[Fault]):
        super().__init__("\n".join(map(str, faults)))
        self.faults: list[Fault] = list(faults)

    def __reduce__(self) -> Any:
        return type(self), (self.faults,)


class NoDesign(Error):
    """There is no design for a spec: .sentence says why, .relaxations what would help, .proven if it is certain."""

    def __init__(self, sentence: str, relaxations: Sequence[Change] = (), proven: bool = False):
        super().__init__("\n".join(dict.fromkeys([sentence, *map(str, relaxations)])))
        self.sentence, self.relaxations, self.proven = sentence, list(relaxations), proven

    def __reduce__(self) -> Any:
        return type(self), (self.sentence, self.relaxations, self.proven)


class Stopped(Error):
    """The time limit, or a motion's limit of work, came before an answer; no design can beat .proven_bound, if it is there."""

    def __init__(self, sentence: str, proven_bound: Optional[float] = None):
        super().__init__(sentence)
        self.sentence, self.proven_bound = sentence, proven_bound

    def __reduce__(self) -> Any:
        return type(self), (self.sentence, self.proven_bound)


class NoMotion(Error):
    """A linkage does not assemble, cannot start, or does not get where it was wanted: .sentence says why."""

    def __init__(self, sentence: str):
        super().__init__(sentence)
        self.sentence = sentence


class NotWritten(Error):
    """Nothing was written: the design does not hold, or the folder cannot be written."""


@dataclass(frozen=True)
class Verdict:
    """Whether the tracer can stand at a place. True where it certainly can."""

    free: bool
    uncertain: bool  #: neither proven free nor proven in contact
    sentence: str

    def __bool__(self) -> bool:
        return self.free


@dataclass(frozen=True)
class Loss:
    """A share of the plane within the outer reach that is lost."""

    cause: str  #: "out of reach", "contact", ...
    parts: tuple[str, ...]  #: the two in contact; else ()
    area_mm2: float


@dataclass(frozen=True)
class Sheet:
    """A rectangle that fits the free workspace."""

    name: str  #: "A4"
    width_mm: float
    height_mm: float
    centre_mm: Point
    turn_deg: float


@dataclass(frozen=True)
class Broken:
    """Something that does not hold."""

    limit: str  #: its key
    attained: Optional[float]  #: in the key's unit
    allowed: Optional[float]
    where_mm: Optional[Point]  #: the tracer's place
    sentence: str


@dataclass(frozen=True)
class Verification:
    """What came of driving the linkage, built from its eight lengths alone, over the region. True if all holds."""

    holds: bool
    broken: tuple[Broken, ...] = ()
    samples: int = 0  #: places visited
    copy_error_max_mm: float = 0
    loop_residual_max_mm: float = 0
    scale: float = 0  #: of the similarity fitted to what was driven
    rotation_deg: float = 0
    flips: int = 0  #: changes of assembly mode seen
    over_workspace: bool = False  #: driven over the free workspace: there is no region within reach
    failure: str = ""  #: a sentence; "" if all holds

    def __bool__(self) -> bool:
        return self.holds


@dataclass(frozen=True)
class Audit:
    """What of a design.json does not hold. True if all does."""

    holds: bool
    broken: tuple[Broken, ...] = ()

    def __bool__(self) -> bool:
        return self.holds


@dataclass(frozen=True, eq=False)
class CopiedLine:
    """A line that the pen drew, or should have drawn."""

    original: int  #: which of the given lines, from 0
    points: Array  #: (n, 2), mm

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, CopiedLine) and self.original == other.original
                and np.array_equal(self.points, other.points))


@dataclass(frozen=True)
class CopiedDrawing:
    """What became of a drawing. True if all of it was drawn."""

    drawn: list[CopiedLine] = field(repr=False)
    missing: list[CopiedLine] = field(repr=False)
    drawn_length_mm: float  #: of the original
    missing_length_mm: float  #: of the original
    poses: int  #: tried
    poses_missed: int
    departure_mm: float  #: largest distance of the pen from the similar image

    def __bool__(self) -> bool:
        return self.poses_missed == 0


@dataclass(frozen=True)
class TracedDrawing(CopiedDrawing):
    """A drawing's file copied, with what `kempe trace` writes of it; shows the copy in a notebook."""

    answer: Mapping[str, Any] = field(repr=False)  #: what `kempe trace --json` prints, without the copy's file (docs/commands.md)
    svg: str = field(repr=False)  #: the copy, the text of an SVG file at 1:1; what is missing in red
    joints_csv: str = field(repr=False)  #: what `kempe trace --csv` writes; "" unless asked for
    forces_csv: str = field(repr=False)  #: what `kempe trace --forces` writes; "" unless asked for

    @property
    def joints(self) -> dict[str, Array]:
        """The joints' places as columns, n poses each: stroke, reached (0 or 1), tracer_x_mm, ..., Y_y_mm; NaN where not reached.

        Empty unless asked for. pandas.DataFrame(copy.joints) is a table.
        """
        return _columns_of(self.joints_csv)

    @property
    def forces(self) -> dict[str, Array]:
        """What the hand feels as columns, one entry for each pose reached: hand_N, pin_A_N, ...; NaN at a dead point.

        Empty unless asked for. Newtons, mm and kg as the names end (docs/loads.md).
        """
        return _columns_of(self.forces_csv)

    def _repr_svg_(self) -> str:
        return self.svg


def _columns_of(text: str) -> dict[str, Array]:
    """A table of numbers, its first row their names; what is empty is NaN."""
    rows = list(csv.reader(text.splitlines()))
    if not rows:
        return {}
    return {name: np.array([float(row[i] or "nan") for row in rows[1:]]) for i, name in enumerate(rows[0])}


def broken_of(rows: Sequence[tuple[Any, ...]]) -> tuple[Broken, ...]:
    return tuple(Broken(*row) for row in rows)


def error_of(rows: Sequence[tuple[str, int, str, str, str]], lines: bool = True) -> SpecError:
    """The error that says these faults; without lines where the text is none that anybody wrote."""
    return SpecError([Fault(file or None, line if lines and line > 0 else None, key, found, allowed)
                      for file, line, key, found, allowed in rows])


def check_time_limit(seconds: Optional[float]) -> None:
    """Raises ValueError for what is no time: NaN and numbers below 0."""
    if seconds is not None and not seconds >= 0:
        raise ValueError(f"time_limit is a number of seconds >= 0; found {seconds}")
