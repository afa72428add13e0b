"""Function generators, inversors and path generators: linkages designed for a task."""
from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from typing import Any, Callable, Iterator, Mapping, Optional, Union

import numpy as np

from . import _core
from ._answers import NoDesign, Point, Stopped, check_time_limit, error_of
from ._geometry import Array
from ._linkage import Linkage, Wanted
from ._spec import Path, text_of

_Spec = Union[Path, Mapping[str, Any]]
_Found = Union[tuple[str, list[tuple[str, str, tuple[Wanted, ...]]], str], list[tuple[str, int, str, str, str]], _core.NothingGenerated]


@dataclass(frozen=True)
class FunctionGenerator:
    """A four-bar whose output crank shows a function of its input crank. Lengths mm, angles degrees."""

    method: str  #: "precision_points", "least_squares" or "minimax"
    lengths_mm: Mapping[str, float]  #: ground, input, coupler, output
    branch: int  #: 1 or 2: how it is assembled
    motion: str  #: "crank-rocker", "double rocker", ...
    input_start_deg: float
    input_range_deg: float
    output_start_deg: float
    output_range_deg: float
    y_at_start: float  #: the dial's ends
    y_at_end: float
    structural_error_max_deg: float
    structural_error_rms_deg: float
    transmission_min_deg: float
    precision_points: tuple[float, ...]  #: x where the error is meant to vanish, or vanishes
    minimax: Optional[Mapping[str, Any]] = field(repr=False)  #: what is known of a minimax design: "local_minimum_proven", ...
    rejected: Mapping[str, int] = field(repr=False)  #: candidates with defects, by defect
    equations: Mapping[str, Any] = field(repr=False)  #: as `kempe function --equations --json` has them
    reservation: str  #: what is not claimed; "" where nothing is left to say
    complete: bool  #: False: the time limit came first, and this is the best found by then
    linkage: Linkage  #: the four-bar O-A-B-D, its input crank driven
    plot_svg: str = field(repr=False)  #: the structural error's curve, the text of an SVG file
    _curve: tuple[Mapping[str, float], ...] = field(repr=False)

    @property
    def structural_error(self) -> dict[str, Array]:
        """The error's curve as columns over x: x, y, y_generated, input_deg, output_deg, error_deg."""
        return {name: np.array([row[name] for row in self._curve]) for name in self._curve[0]}


@dataclass(frozen=True)
class InversorLength:
    """A length of an inversor and what an error in it does."""

    name: str
    count: int  #: so many equal links
    mm: float
    sensitivity_mm_per_mm: float  #: the image's error, at most over the range


@dataclass(frozen=True)
class Inversor:
    """An inversor for a lens: object and image stay in focus at every magnification of its range."""

    kind: str  #: "peaucellier", "hart" or "right_angle"
    size_mm: float  #: the sum of all its lengths
    lengths: tuple[InversorLength, ...]
    travel_object_mm: float
    travel_image_mm: float
    transmission_min_deg: float
    linkage: Linkage  #: focus O, object P (driven), image Q
    point_share: Optional[float] = None  #: of Hart's bars
    others: tuple[Inversor, ...] = field(default=(), repr=False)  #: larger ones of the other kinds
    why_not: Mapping[str, str] = field(default_factory=dict, repr=False)  #: of the kinds of which there is none


@dataclass(frozen=True)
class Cognate:
    """One of the two other four-bars that draw the same coupler curve (Roberts and Chebyshev). Lengths mm, angles degrees."""

    pivots_mm: tuple[Point, Point]  #: of crank and rocker
    crank_mm: float
    coupler_mm: float
    rocker_mm: float
    coupler_point_mm: Point  #: along the coupler from the crank's joint, and to the left of it
    assembly_mode: int  #: 1 or 2
    driver: str  #: "crank" or "coupler": which link turns as the crank of the first four-bar
    driver_deg: tuple[float, ...]  #: its angle at each point
    linkage: Linkage = field(repr=False)
    _wanted: tuple[Wanted, ...] = field(default=(), repr=False, compare=False)

    def animation(self, kind: str = "html") -> str:
        """Its linkage moving, with the points or poses asked for and the deviations from them: "html" has a slider, "svg" plays by itself."""
        return self.linkage._animation(kind, self._wanted)


@dataclass(frozen=True)
class Plagiograph:
    """Two links more on a four-bar's coupler: a point that draws the coupler curve scaled and turned about a pivot. mm, degrees."""

    scale: float
    rotation_deg: float
    pole: str  #: "crank_pivot" or "rocker_pivot": about which it is scaled and turned
    pole_mm: Point
    four_bar: Mapping[str, Any] = field(repr=False)  #: on which it stands, the answer or its cognate, as `kempe path --json` has it
    coupler_joint_mm: Point  #: along the coupler from the crank's joint, and to the left of it
    arm_mm: float
    link_mm: float
    copy_point_mm: Point  #: on the link, in its frame
    copied_mm: Array = field(repr=False, compare=False)  #: (n, 2): where the copying point is at each point of the path
    error_max_mm: float  #: from the exact image
    parallelogram_min_deg: float  #: how near to flat its parallelogram comes
    linkage: Linkage = field(repr=False)  #: the six-bar; Y draws the copy
    _wanted: tuple[Wanted, ...] = field(default=(), repr=False, compare=False)

    def animation(self, kind: str = "html") -> str:
        """Its linkage moving, with the points or poses asked for and the deviations from them: "html" has a slider, "svg" plays by itself."""
        return self.linkage._animation(kind, self._wanted)


@dataclass(frozen=True)
class PathGenerator:
    """A four-bar whose coupler point follows a path, or whose coupler takes poses. Lengths mm, angles degrees."""

    pivots_mm: tuple[Point, Point]  #: of crank and rocker
    crank_mm: float
    coupler_mm: float
    rocker_mm: float
    coupler_point_mm: Point  #: along the coupler from the crank's joint, and to the left of it
    assembly_mode: int  #: 1 or 2
    motion: str  #: "crank-rocker", "double rocker", ...
    driver_deg: tuple[float, ...]  #: the crank's angle at each point
    reached_mm: Array = field(repr=False, compare=False)  #: (n, 2): where the coupler point is at each
    error_rms_mm: float  #: root of the mean squared distance
    error_max_mm: float
    transmission_min_deg: float  #: from the first point to the last
    active_limits: tuple[Mapping[str, Any], ...]  #: the limits at which it stands, as `kempe path --json` has them
    cognates: tuple[Cognate, ...] = field(repr=False)  #: two, or none where the coupler point lies on a joint
    linkage: Linkage = field(repr=False)  #: O, A, B, D and the coupler point P, its crank driven
    reached_deg: tuple[float, ...] = ()  #: of poses: how far the coupler has turned at each
    error_angle_max_deg: Optional[float] = None  #: of poses
    copy: Optional[Plagiograph] = None  #: where one was asked for, and there is one
    why_no_copy: str = ""  #: where one was asked for, and there is none
    _wanted: tuple[Wanted, ...] = field(default=(), repr=False, compare=False)

    def animation(self, kind: str = "html") -> str:
        """Its linkage moving, with the points or poses asked for and the deviations from them: "html" has a slider, "svg" plays by itself."""
        return self.linkage._animation(kind, self._wanted)


@dataclass(frozen=True)
class PathGenerators:
    """What a search for path generators found: `.best`, and as a sequence all answers, the best first."""

    answers: tuple[PathGenerator, ...]
    bound: str  #: what is not claimed: nothing is proven about what was not found
    searched: Mapping[str, int] = field(repr=False)  #: what was looked at
    dyads: tuple[Mapping[str, Any], ...] = field(default=(), repr=False)  #: of five poses: all, as `kempe path --json` has them

    @property
    def best(self) -> PathGenerator:
        """The first answer."""
        return self.answers[0]

    def __iter__(self) -> Iterator[PathGenerator]:
        return iter(self.answers)

    def __len__(self) -> int:
        return len(self.answers)

    def __getitem__(self, index: int) -> PathGenerator:
        return self.answers[index]


def path_generator(spec: Optional[_Spec] = None, *, copy_scale: Optional[float] = None, copy_rotation_deg: Optional[float] = None,
                   copy_pole: Optional[str] = None, copy_cognate: int = 0, **tables: Any) -> PathGenerators:
    """Four-bars whose coupler follows points or takes poses (docs/path.md): from a TOML file, from its tables as a dict, or keywords.

    copy_scale, copy_rotation_deg   add to each answer the plagiograph that draws its curve scaled and turned: 0.001 to 1000, -360 to 360
    copy_pole                       about this pivot, "crank" or "rocker"; None: the one farther from change points
    copy_cognate                    0: on the answer; 1 or 2: on that cognate of it

    Raises SpecError with all faults, and NoDesign where none is found.

    >>> line = [[20, 20], [20, 25], [20, 30], [20, 35], [20, 40], [20, 45]]
    >>> found = path_generator(path={"points_mm": line}, limits={"longest_mm": 60, "transmission_deg": 20})
    >>> found.best.error_max_mm < 1e-9, found.best.reached_mm.shape, len(found.best.cognates)
    (True, (6, 2), 2)
    >>> copy = path_generator(path={"points_mm": line}, limits={"longest_mm": 60, "transmission_deg": 20}, copy_scale=2).best.copy
    >>> "wanted" in found.best.animation("svg")  # the points asked for, as rings
    True
    >>> copy.copied_mm.shape, copy.linkage.points
    ((6, 2), ['O', 'D', 'A', 'B', 'P', 'C', 'Q', 'Y'])
    """
    copy = None
    if copy_scale is not None or copy_rotation_deg is not None or copy_pole is not None:
        copy = _core.PlagiographOptions(1 if copy_scale is None else copy_scale, 0 if copy_rotation_deg is None else copy_rotation_deg,
                                        copy_pole or "", copy_cognate)
    elif copy_cognate:
        raise TypeError("copy_cognate: there is no copy without copy_scale, copy_rotation_deg or copy_pole")
    found, linkages, wanted, _ = _generated(lambda file: _core.generate_path(file, copy), lambda text: _core.generate_path_text(text, copy),
                                            spec, tables)
    answers = []
    for number, row in enumerate(found["answers"], 1):
        row.pop("lower_bound_mm", None)  # none is known
        name = f"answer_{number}"
        cognates = tuple(Cognate(**_tuples(one), linkage=linkages[f"{name}_cognate_{which}"], _wanted=wanted[f"{name}_cognate_{which}"])
                         for which, one in enumerate(row.pop("cognates"), 1))
        reached = np.array(row.pop("reached_mm"))
        made = row.pop("copy", {})
        answers.append(PathGenerator(**_tuples(row), reached_mm=reached, cognates=cognates, linkage=linkages[name],
                                     copy=_plagiograph_of(made, linkages.get(f"{name}_copy"), wanted.get(f"{name}_copy", ())),
                                     why_no_copy=made.get("why_not", ""), _wanted=wanted[name]))
    return PathGenerators(tuple(answers), found["bound"], found["searched"], tuple(found.get("dyads", ())))


def _plagiograph_of(row: Mapping[str, Any], linkage: Optional[Linkage], wanted: tuple[Wanted, ...]) -> Optional[Plagiograph]:
    if linkage is None:
        return None
    copied = np.array(row["copied_mm"])
    return Plagiograph(**_tuples({key: value for key, value in row.items() if key != "copied_mm"}), copied_mm=copied, linkage=linkage,
                       _wanted=wanted)


def _tuples(row: Mapping[str, Any]) -> dict[str, Any]:
    return {key: tuple(tuple(one) if isinstance(one, list) else one for one in value) if isinstance(value, list) else value
            for key, value in row.items()}


def function_generator(spec: Optional[_Spec] = None, *, time_limit: Optional[float] = None, **tables: Any) -> FunctionGenerator:
    """A function-generating four-bar (docs/function-generator.md): from a TOML file, from its tables as a dict, or from keywords.
    `time_limit`: seconds; then the best so far, its .complete being False.

    Raises SpecError with all faults, NoDesign where none is found (.proven: none exists), and Stopped where the time limit came first.

    >>> dial = function_generator(function={"expression": "log10(x)", "x": [1, 2], "points": 3}, input={"range_deg": 60},
    ...                           output={"range_deg": 90})
    >>> len(dial.precision_points), dial.linkage.links
    (3, ['input', 'coupler', 'output'])
    """
    check_time_limit(time_limit)
    found, linkages, _, plot = _generated(lambda file: _core.generate_function(file, time_limit),
                                            lambda text: _core.generate_function_text(text, time_limit), spec, tables)
    return FunctionGenerator(
        method=found["method"], lengths_mm=found["lengths_mm"], branch=found["branch"], motion=found["motion"],
        input_start_deg=found["input"]["start_deg"], input_range_deg=found["input"]["range_deg"],
        output_start_deg=found["output"]["start_deg"], output_range_deg=found["output"]["range_deg"],
        y_at_start=found["output"]["y_at_start"], y_at_end=found["output"]["y_at_end"],
        structural_error_max_deg=found["structural_error_max_deg"], structural_error_rms_deg=found["structural_error_rms_deg"],
        transmission_min_deg=found["transmission_min_deg"], precision_points=tuple(found["precision_points"]),
        minimax=found.get("minimax"), rejected=found["rejected"], equations=found["equations"],
        reservation=found.get("reservation", ""), complete=found.get("complete", True),
        linkage=linkages["four_bar"], plot_svg=plot, _curve=tuple(found["structural_error"]))


def inversor(spec: Optional[_Spec] = None, **tables: Any) -> Inversor:
    """The smallest inversor for a lens (docs/inversor.md), with those of the other kinds: from a TOML file, a dict or keywords.

    Raises SpecError with all faults, and NoDesign where no kind is found.

    >>> best = inversor(lens={"focal_length_mm": 150, "magnification": [0.5, 2]}, limits={"transmission_deg": 12})
    >>> best.kind, [other.kind for other in best.others], list(best.why_not)
    ('right_angle', ['hart'], ['peaucellier'])
    """
    found, linkages, _, _ = _generated(_core.generate_inversor, _core.generate_inversor_text, spec, tables)
    rows = {row["kind"]: row for row in found["inversors"]}
    why_not = {kind: row["why_not"] for kind, row in rows.items() if "why_not" in row}
    best, *others = [_inversor_of(rows[kind], linkage) for kind, linkage in linkages.items()]
    return replace(best, others=tuple(others), why_not=why_not)


def _inversor_of(row: dict[str, Any], linkage: Linkage) -> Inversor:
    return Inversor(kind=row["kind"], size_mm=row["size_mm"],
                    lengths=tuple(InversorLength(**length) for length in row["lengths"]),
                    travel_object_mm=row["travel_object_mm"], travel_image_mm=row["travel_image_mm"],
                    transmission_min_deg=row["transmission_min_deg"], linkage=linkage, point_share=row.get("point_share"))


def _generated(of_file: Callable[[Path], _Found], of_text: Callable[[str], _Found], spec: Optional[_Spec],
               tables: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Linkage], dict[str, tuple[Wanted, ...]], str]:
    """The command's JSON, the linkages by kind, what each was asked for, the plot; or the error that says why not."""
    if spec is not None and tables:
        raise TypeError("a file, a dict or keywords: one of them")
    is_file = spec is not None and not isinstance(spec, Mapping)
    if spec is None or isinstance(spec, Mapping):
        answer = of_text(text_of(tables if spec is None else spec))
    else:
        answer = of_file(spec)
    if isinstance(answer, list):
        raise error_of(answer, lines=is_file)
    if isinstance(answer, _core.NothingGenerated):
        if answer.stopped:
            raise Stopped(answer.sentence)
        raise NoDesign(answer.sentence, proven=answer.proven)
    text, linkages, plot = answer
    by_kind = {kind: Linkage.from_toml(linkage) for kind, linkage, _ in linkages}
    return json.loads(text), by_kind, {kind: wanted for kind, _, wanted in linkages}, plot
