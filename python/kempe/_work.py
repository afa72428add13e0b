"""The searches: kempe.synthesize, kempe.workspace, and what repeats them."""
from __future__ import annotations

import os
import warnings
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence

from . import _core
from ._answers import Change, Error, NoDesign, Stopped, check_time_limit, error_of
from ._design import Design, names_of
from ._spec import Path, Spec

#: Told the share of the work done, 0..1, and what is being done.
Progress = Callable[[float, str], object]


class Front(dict[str, list[Any]]):
    """A front as columns: the two objectives, `design`, and each figure. pandas.DataFrame(front) is a table."""

    _values: list[tuple[float, float]]  # of the objectives as the library has them: mm, rad, mm^2, kg

    def save(self, folder: Path, title: str = "design", *, paper: str = "A4") -> list[str]:
        """Writes what `kempe pareto` writes: report.html, front.csv, and a folder a point with all files of its design. Returns their names.

        Raises NotWritten, with the reason, where a design fails its verification or a folder cannot be written.
        """
        first, second = list(self)[:2]
        points = [(*values, design._inside) for values, design in zip(self._values, self["design"])]
        return names_of(_core.write_front(first, second, points, folder, title, paper))


def synthesize(spec: Spec, *, seed: int = 1, threads: Optional[int] = None, time_limit: Optional[float] = None,
               progress: Optional[Progress] = None, diagnose: bool = True, map_tolerance: float = 0.005,
               largest_sheets: bool = True) -> Design:
    """The best design for a spec, which keeps every limit (docs/search.md). Same spec and seed, same design, bit for bit.

    threads         None: as many as the machine has; the design does not depend on it
    time_limit      seconds; at its end the best so far comes back, its .complete being False
    progress        called with a share, 0..1, and what it is the share of: "searching", "mapping", ...; each begins anew
    diagnose        look for the least relaxations where there is no design
    map_tolerance   share of the free workspace that may stay uncertain, 0.00001 to 0.5
    largest_sheets  look for the largest rectangles that fit the workspace: the slowest part of a map

    Other threads run meanwhile; Ctrl-C ends it with KeyboardInterrupt, an exception of `progress` with that exception.
    Raises NoDesign with the reason, and Stopped where the time limit came before any answer.

    >>> task = Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "pin_diameter_mm": 3})
    >>> design = synthesize(task)
    >>> design.size_mm >= design.lower_bound
    True
    >>> design.pen([(66, 0)]).round(9) + 0
    array([[ 0. , 92.4]])
    """
    wishes = _wishes(spec, seed, threads, time_limit, diagnose, map_tolerance, largest_sheets)
    return _answer(_core.design(spec._inside, wishes, progress))


def workspace(spec: Spec, *, time_limit: Optional[float] = None, progress: Optional[Progress] = None,
              map_tolerance: float = 0.005, largest_sheets: bool = True) -> Design:
    """The mechanism that the spec's table `mechanism` gives, with its map among the obstacles; see synthesize().

    The limits are not required of it: the map says where they are kept.

    >>> given = Spec(copy=1.4j, mechanism={"vertex": "pole", "VA_mm": 50, "VB_mm": 35, "assembly": 3})
    >>> workspace(given).map.why(70, 0).free
    True
    """
    wishes = _wishes(spec, 1, 1, time_limit, False, map_tolerance, largest_sheets)
    return _answer(_core.map(spec._inside, wishes, progress))


def pareto(spec: Spec, between: Sequence[str], *, points: int = 15, seed: int = 1, threads: Optional[int] = None,
           time_limit: Optional[float] = None, progress: Optional[Progress] = None,
           map_tolerance: float = 0.005) -> Front:
    """The front between two objectives, as columns: the two, `design`, and each figure; the best in the first stands first.

    between   two of "size" (mm), "transmission" (degrees), "copy_error" (mm), "footprint" (mm^2), "load_error" (mm), "mass" (kg)
    points    about so many designs, 2 to 200; fewer where searches give the same design again, or the time limit came

    No point is better than another in both. The designs have no bound. Raises what synthesize() raises, and ValueError for
    objectives that are none; warns (RuntimeWarning) where the time limit cut the front short.
    """
    if isinstance(between, str) or len(between) != 2:
        raise ValueError(f"two objectives are wanted, as (\"size\", \"transmission\"); found {between!r}")
    first, second = between
    if first == second:
        raise ValueError(f"two objectives are wanted; found {first!r} twice")
    wishes = _wishes(spec, seed, threads, time_limit, True, map_tolerance, False)
    found = _core.front(spec._inside, first, second, points, wishes, progress)
    if not isinstance(found, tuple):
        raise _error_of(found)
    complete, rows = found
    if not complete:
        warnings.warn("stopped by the time limit: points of the front are missing", RuntimeWarning, stacklevel=2)
    designs = [Design._of(row[2]) for row in rows]
    front = Front(columns_of({first: [row[0] for row in rows], second: [row[1] for row in rows], "design": designs}, designs))
    front._values = [row[3:] for row in rows]
    return front


def proof_of_none(spec: Spec) -> str:
    """The log of the proof that a spec has no design, where NoDesign says .proven: the text of certificate.jsonl (docs/proof.md).

    The program proof/kempe_check.py checks it without Kempe. Raises Error where there is none, with the reason.

    >>> task = Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "longest_mm": 20})
    >>> proof_of_none(task).count("\\n") > 1
    True
    """
    log = _core.proof_of_none(spec._inside)
    if isinstance(log, tuple):
        raise Error(*log)
    if isinstance(log, list):
        raise error_of(log)
    return log


def _wishes(spec: Spec, seed: int, threads: Optional[int], time_limit: Optional[float], diagnose: bool, map_tolerance: float,
            largest_sheets: bool) -> _core.Wishes:
    if not isinstance(spec, Spec):
        raise TypeError(f"a kempe.Spec is wanted, not {type(spec).__name__}: kempe.load() reads one from a file")
    if not 1e-5 <= map_tolerance <= 0.5:
        raise ValueError(f"map_tolerance is 0.00001 to 0.5; found {map_tolerance}")
    check_time_limit(time_limit)
    return _core.Wishes(seed=seed, threads=threads if threads is not None else os.cpu_count() or 1, time_limit=time_limit,
                        diagnose=diagnose, map_tolerance=map_tolerance, largest_sheets=largest_sheets)


def _answer(outcome: _core.Outcome) -> Design:
    if outcome.design is None:
        raise _error_of(outcome)
    return Design._of(outcome.design)


def _error_of(outcome: _core.Outcome) -> Error:
    if outcome.kind == "bad_spec":
        return error_of(outcome.faults)
    if outcome.kind == "stopped":
        return Stopped(outcome.reason, outcome.proven_bound)
    return NoDesign(outcome.reason, [Change(*change) for change in outcome.changes], outcome.proven)


def sweep(spec: Spec, table: str, key: str, values: Iterable[Any], **options: Any) -> dict[str, list[Any]]:
    """A design for each value of one key, as columns: the key's values, `design` (None where there is none), and each figure.

    `options` are those of synthesize(). A spec with a fault raises SpecError before anything is searched.
    pandas.DataFrame(sweep(...)) is a table; the figures of no design are None.

    >>> task = Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "pin_diameter_mm": 3})
    >>> columns = sweep(task, "limits", "transmission_deg", [20, 30, 80], diagnose=False)
    >>> columns["transmission_deg"], [size is None for size in columns["size_mm"]]
    ([20, 30, 80], [False, False, True])
    """
    values = list(values)
    specs = [spec.replace(**{table: {key: value}}) for value in values]
    designs: list[Optional[Design]] = []
    for one in specs:
        try:
            designs.append(synthesize(one, **options))
        except NoDesign:
            designs.append(None)
    return columns_of({key: values, "design": designs}, designs)


def columns_of(first: Mapping[str, Sequence[Any]], designs: Sequence[Optional[Design]]) -> dict[str, list[Any]]:
    """`first`, and a column a figure of the designs; a name of `first` that is a figure's too stays."""
    rows = [design.figures if design is not None else {} for design in designs]
    names = list(dict.fromkeys(name for row in rows for name in row))
    columns: dict[str, list[Any]] = {name: list(column) for name, column in first.items()}
    for name in names:
        columns.setdefault(name, [row.get(name) for row in rows])
    return columns
