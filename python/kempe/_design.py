"""Designs and their maps."""
from __future__ import annotations

import html
import json
import math
import os
from typing import TYPE_CHECKING, Any, Iterable, Optional, Sequence

import numpy as np
import numpy.typing as npt

from . import _core
from ._answers import (Audit, CopiedDrawing, CopiedLine, Loss, NotWritten, Point, Sheet, TracedDrawing, Verdict,
                       Verification, broken_of, error_of, check_time_limit)
from ._geometry import Array, Region
from ._program import studio_file
from ._spec import Path

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: How closely straight edges follow the map's arcs unless it is said, mm.
TOLERANCE = 0.05


def points_of(points: npt.ArrayLike) -> Array:
    """An array (n, 2) of numbers, of complex numbers too; one that is such an array is not copied."""
    array = np.asarray(points)
    if np.iscomplexobj(array):
        array = np.stack([array.real, array.imag], axis=-1)
    array = np.ascontiguousarray(array, dtype=np.float64)
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"points have the shape (n, 2), or are n complex numbers; these have the shape {array.shape}")
    return array


class Map:
    """Where the tracer can go, where the real links can follow, and why not elsewhere. Areas mm^2, places mm."""

    __slots__ = ("_inside", "_design")

    def __init__(self, design: Design):
        self._inside, self._design = design._inside.map, design

    @property
    def covers_region(self) -> bool:
        """True if every point of the region is certainly in one component of the free workspace."""
        return self._inside.covers_region

    @property
    def why_not_covered(self) -> str:
        """Why it is not; "" if it is."""
        return self._inside.why_not_covered

    @property
    def reachable_mm2(self) -> float:
        """Within reach of the assembly mode."""
        return self._inside.reachable_area

    @property
    def usable_mm2(self) -> float:
        """Of that, with the transmission kept."""
        return self._inside.usable_area

    @property
    def free_mm2(self) -> float:
        """Of that, certainly without contact."""
        return self._inside.collision_free_area

    @property
    def uncertain_mm2(self) -> float:
        """Neither proven free nor proven in contact."""
        return self._inside.uncertain_area

    @property
    def complete(self) -> bool:
        """False: stopped early; what is called free is, but more is uncertain than was asked for."""
        return self._inside.complete

    @property
    def free(self) -> Region:
        """What is certainly free: edges within 0.05 mm of the true set, inside it. shapely.geometry.shape() takes it."""
        return self.free_within(TOLERANCE)

    @property
    def reachable(self) -> Region:
        """What is within reach: edges within 0.05 mm of the true set, around it."""
        return self.reachable_within(TOLERANCE)

    def free_within(self, tolerance: float) -> Region:
        """What is certainly free, with straight edges inside the true set, within `tolerance` (mm, >= 1e-7) of its arcs."""
        return Region(self._inside.collision_free(_length(tolerance)))

    def reachable_within(self, tolerance: float) -> Region:
        """What is within reach, with straight edges around the true set, within `tolerance` (mm, >= 1e-7) of its arcs."""
        return Region(self._inside.reachable(_length(tolerance)))

    @property
    def losses(self) -> list[Loss]:
        """What is lost of the disc of the outer reach, and to what."""
        return [Loss(cause, tuple(parts), area) for cause, parts, area in self._inside.losses()]

    @property
    def sheets(self) -> list[Sheet]:
        """The largest sheets that fit."""
        return [Sheet(*sheet) for sheet in self._inside.largest_sheets()]

    def why(self, x: float, y: float) -> Verdict:
        """Whether the tracer can stand at a place (mm), and why not."""
        return Verdict(*self._inside.at(float(x), float(y)))

    def is_free(self, points: npt.ArrayLike) -> npt.NDArray[np.bool_]:
        """For each of n places (n, 2), mm, whether the tracer can certainly stand there: n truth values."""
        return self._inside.are_free(points_of(points))

    def plot(self, axes: Optional[Axes] = None) -> Axes:
        """Draws region, reach and free workspace on Matplotlib's axes (new ones unless given), which it returns."""
        from ._plots import plot_map
        return plot_map(self._design, axes)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Map) and self._design == other._design

    def __hash__(self) -> int:
        return hash(self._design)

    def __reduce__(self) -> Any:
        return Map, (self._design,)

    def __repr__(self) -> str:
        covers = "covers the region" if self.covers_region else f"does not cover the region: {self.why_not_covered}"
        return f"<kempe.Map: {self.free_mm2:.6g} mm2 free of {self.reachable_mm2:.6g} mm2 within reach; {covers}>"


class Design:
    """A linkage with its parts, its map and its figures. A value: it does not change, compares by its design.json, pickles.

    Lengths mm, angles degrees (their names end in _deg), places (x, y) in the table's frame. An attribute is named like its
    key in design.json (docs/design-file.md).
    """

    __slots__ = ("_inside", "_json")
    _inside: _core.Design
    _json: Optional[str]

    @classmethod
    def _of(cls, inside: _core.Design) -> Design:
        design = cls.__new__(cls)
        design._inside, design._json = inside, None
        return design

    @classmethod
    def load(cls, file: Path, *, time_limit: Optional[float] = None) -> Design:
        """The design of a design.json, of whatever origin: verified first, map and figures computed anew.

        Its bound is kept where its proof is found again. `time_limit`: seconds; then a coarser map, .map.complete being False.
        Raises SpecError for a file that cannot be read or does not hold.
        """
        with open(file, "rb") as stream:
            return cls._restored(stream.read(), os.fspath(file), False, time_limit)

    @classmethod
    def from_json(cls, text: str, name: str = "") -> Design:
        """The same of a text; `name` stands for the file in messages."""
        return cls._restored(text, name, False)

    @classmethod
    def _restored(cls, text: str | bytes, name: str, is_own: bool, time_limit: Optional[float] = None) -> Design:
        check_time_limit(time_limit)
        found = _core.restore(text, name, is_own, time_limit)
        if isinstance(found, list):
            raise error_of(found)
        return cls._of(found)

    @property
    def copy(self) -> complex:
        """The ratio attained; with stock lengths it may differ from the spec's."""
        return self._inside.copy

    @property
    def scale(self) -> float:
        """|k|."""
        return self._inside.scale

    @property
    def rotation_deg(self) -> float:
        """The copy's turn, counter-clockwise."""
        return math.degrees(self._inside.rotation)

    @property
    def vertex(self) -> str:
        """What stands at V: "pole", "tracer" or "pen"."""
        return self._inside.grounding

    @property
    def assembly(self) -> int:
        """The assembly mode: which usable interval of the opening, from 0."""
        return self._inside.assembly_mode

    @property
    def pole_mm(self) -> Point:
        """Where the pole stands."""
        return self._inside.pole

    @property
    def lengths_mm(self) -> dict[str, float]:
        """The eight distances between joints of one link: VA, VB, AC, BC, AX, CX, BY, CY."""
        return self._inside.lengths

    @property
    def layers(self) -> dict[str, int]:
        """Of each link; 1 is next to the table."""
        return dict(zip(("VA", "VB", "ACX", "BCY"), self._inside.layers))

    @property
    def section_mm(self) -> tuple[float, float]:
        """Width and thickness of the links."""
        return self._inside.section

    @property
    def opening_deg(self) -> Point:
        """Ends of the certified usable opening."""
        lower, upper = self._inside.opening
        return math.degrees(lower), math.degrees(upper)

    @property
    def size_mm(self) -> float:
        """Half the perimeters of the links' hulls, summed."""
        return self._inside.size

    @property
    def transmission_min_deg(self) -> float:
        """Smallest over the region."""
        return math.degrees(self._inside.transmission_min)

    @property
    def clearance_min_mm(self) -> Optional[float]:
        """Smallest gap between parts over the region; None where nothing can touch."""
        return self._inside.clearance_min

    @property
    def footprint_mm2(self) -> float:
        """Outer bound of the area swept while the tracer covers the region."""
        return self._inside.footprint

    @property
    def copy_error_worst_mm(self) -> Optional[float]:
        """Worst case over the region under the spec's tolerance, to the first order (docs/tolerance.md); None without it."""
        return self._inside.copy_error

    @property
    def load_error_max_mm(self) -> Optional[float]:
        """Most that the pen gives way over the region under the spec's load; None without it."""
        return self._inside.load_error

    @property
    def load_error_layered_max_mm(self) -> Optional[float]:
        """The same with pins and layers; None also where two joints of a link are too near each other for it."""
        return self._inside.load_error_layered

    @property
    def load_rise_max_mm(self) -> Optional[float]:
        """Most that tracer or pen rises or sinks under the load, by the layers of the links; None as above."""
        return self._inside.load_rise

    @property
    def weight_error_max_mm(self) -> Optional[float]:
        """Most that the pen gives way by the links' own weight along a tilted table; None on a level one and without a load."""
        return self._inside.weight_error

    @property
    def weight_error_layered_max_mm(self) -> Optional[float]:
        """The same with pins and layers; None also where load_error_layered_max_mm is."""
        return self._inside.weight_error_layered

    @property
    def weight_rise_max_mm(self) -> Optional[float]:
        """Most that tracer or pen rises or sinks by the links' own weight along a tilted table; None as above."""
        return self._inside.weight_rise

    @property
    def stress_max_MPa(self) -> Optional[float]:
        """Largest stress in a link under the load, by bending and pull in the plane alone, on a tilted table with the links' own
        weight along it; None without a load."""
        return self._inside.stress

    @property
    def stress_layered_max_MPa(self) -> Optional[float]:
        """The same with bending and twist out of the plane, to compare with the material's strength; None as load_error_layered_max_mm."""
        return self._inside.stress_layered

    @property
    def sag_max_mm(self) -> Optional[float]:
        """Most that tracer or pen sinks over the region; None without a material."""
        return self._inside.sag

    @property
    def mass_kg(self) -> Optional[float]:
        """Of the four links; None without a material."""
        return self._inside.mass

    @property
    def robust_clearance_mm(self) -> Optional[float]:
        """No instrument within the tolerance has a smaller gap: proven. None unless tolerance.robust asks for it."""
        return self._inside.robust_clearance

    @property
    def objective(self) -> str:
        """What was made small, or large (transmission)."""
        return self._inside.objective

    @property
    def value(self) -> Optional[float]:
        """The objective's value: mm, degrees, mm^2 or kg; None for a given mechanism."""
        return self._in_degrees(self._inside.value)

    @property
    def lower_bound(self) -> Optional[float]:
        """No design for the spec can be better than this, in the unit of value: proven. None where nothing is."""
        return self._in_degrees(self._inside.proven_bound)

    def _in_degrees(self, figure: Optional[float]) -> Optional[float]:
        return math.degrees(figure) if figure is not None and self.objective == "transmission" else figure

    @property
    def complete(self) -> bool:
        """False: the search was stopped early, a better design may exist."""
        return self._inside.complete

    @property
    def error_budget(self) -> Optional[dict[str, Any]]:
        """The whole error of the made and loaded instrument, part by part, with what would help (docs/loads.md); None without a load.

        Each of `["sources"]` has its "error_mm" and what "would_help"; "in_plane_mm" and "down_mm" are their sums, "give_mm" is how far
        the pen gives way, and "would_help_most" has the best change against each of these.
        """
        text = self._inside.error_budget()
        return json.loads(text) if text else None

    @property
    def feel(self) -> Optional[dict[str, Any]]:
        """How the instrument feels in the hand, and what balances it on a tilted table (docs/loads-out-of-plane.md); None without a load.

        "mass_min_kg" and "mass_max_kg" at the tracer, "friction_share", "hand_max_N", "weight_max_N", "counterweights", which
        balance it at every tilt, and "springs".
        """
        text = self._inside.feel()
        return json.loads(text) if text else None

    @property
    def map(self) -> Map:
        """Where the tracer can stand."""
        return Map(self)

    @property
    def figures(self) -> dict[str, Any]:
        """The figures as one row of a table: pandas.DataFrame([design.figures for design in designs])."""
        row: dict[str, Any] = {"scale": self.scale, "rotation_deg": self.rotation_deg, "vertex": self.vertex,
                               "assembly": self.assembly, "pole_x_mm": self.pole_mm[0], "pole_y_mm": self.pole_mm[1]}
        row |= {f"{name}_mm": length for name, length in self.lengths_mm.items()}
        row |= {name: getattr(self, name) for name in _FIGURES}
        row |= {"free_mm2": self.map.free_mm2, "covers_region": self.map.covers_region}
        return row

    def pen(self, points: npt.ArrayLike) -> Array:
        """Where the pen is when the tracer stands at each of n places (n, 2), mm: (n, 2); NaN where there is no pose.

        In closed form; contact plays no part (see Map.is_free). A million places take a fraction of a second.
        """
        return self._inside.pens(points_of(points))

    def joints(self, points: npt.ArrayLike) -> Array:
        """The joints V, A, B, C, X, Y when the tracer stands at each of n places (n, 2), mm: (n, 6, 2); NaN without a pose."""
        return self._inside.joints(points_of(points))

    def verify(self) -> Verification:
        """Builds the linkage from its eight lengths alone and drives the tracer over the region by the general solver."""
        found = self._inside.verify()
        return Verification(broken=broken_of(found.pop("broken")), **found)

    def trace(self, lines: Iterable[npt.ArrayLike], step: float = 0.5) -> CopiedDrawing:
        """Copies lines, each of shape (n, 2), mm, pose by pose, poses at most `step` mm apart.

        Where the tracer cannot follow, the line is cut; what is missing is told. Raises SpecError for what is not finite.
        """
        found = self._inside.trace([points_of(line) for line in lines], float(step))
        if isinstance(found, list):
            raise error_of(found)
        return CopiedDrawing(**_with_lines(found))

    def trace_drawing(self, drawing: Optional[Path] = None, *, svg: Optional[str] = None, at: Optional[Sequence[float]] = None,
                      scale: Optional[float] = None, fit: bool = False, tolerance_mm: Optional[float] = None,
                      step_mm: Optional[float] = None, instrument: Optional[int] = None, load: bool = False, joints: bool = False,
                      forces: bool = False) -> TracedDrawing:
        """Copies an SVG pose by pose, as `kempe trace` does: a file, or its text as `svg`.

        at            (x, y), mm: where the lower left corner of its page lies; None: (0, 0)
        scale         it is enlarged so many times, 1e-6 to 1e6
        fit           instead of both: in the middle of the region's box, as large as fits
        tolerance_mm  curves are followed to this, 1e-7 to 10 mm; None: 0.01, or a thousandth of the region's diagonal if less
        step_mm       poses are at most this far apart, 1e-4 to 1e3 mm; None: 0.5, or a twentieth of the region's diagonal if less
        instrument    the seed of an instrument made within the design's tolerances, which draws instead
        load          the pen gives way under the design's load
        joints        make the table of the joints' places (.joints)
        forces        make the table of what the hand feels (.forces), and colour the copy by it

        Raises SpecError for what is no SVG or has no lines, for options out of range, and for `load` and `forces` with a spec that has no
        material or load. A place beyond reach is told in .missing.

        >>> from kempe import Spec, synthesize
        >>> task = Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "pin_diameter_mm": 3})
        >>> line = '<svg xmlns="http://www.w3.org/2000/svg" width="8mm" height="6mm" viewBox="0 0 8 6"><path d="M0 6L8 0"/></svg>'
        >>> copy = synthesize(task).trace_drawing(svg=line, at=(62, -3), joints=True)
        >>> bool(copy), copy.drawn[0].points[[0, -1]].round(6).tolist(), round(copy.drawn_length_mm, 6)
        (True, [[4.2, 86.8], [-4.2, 98.0]], 10.0)
        >>> len(copy.joints["Y_x_mm"]) == copy.poses
        True
        """
        place = None if at is None else [float(number) for number in at]
        options = _core.DrawingOptions(place, scale, fit, tolerance_mm, step_mm, instrument, load, joints, forces)
        if svg is not None and drawing is None:
            found = self._inside.trace_svg(svg, options)
        elif drawing is not None and svg is None:
            found = self._inside.trace_svg_file(drawing, options)
        else:
            raise TypeError("a file, or a text as svg=: one of them")
        if isinstance(found, list):
            raise error_of(found)
        return TracedDrawing(answer=json.loads(found.pop("json")), **_with_lines(found))

    def save(self, folder: Path, title: str = "design", *, paper: str = "A4", studio: bool = False) -> list[str]:
        """Writes what `kempe synthesize` writes, all files or none, and returns their names; `title` heads the report.

        paper   of workshop.pdf: "A4" or "A3"
        studio  also write studio.html, the browser page with this spec inside

        Raises NotWritten, with the reason, for a design that fails its verification and a folder that cannot be written, Error where
        there is no page of the studio.
        """
        page = studio_file().read_text(encoding="utf-8") if studio else ""
        return names_of(self._inside.write(folder, title, paper, page))

    def to_json(self) -> str:
        """The text of design.json (docs/design-file.md), verified. A file of save() may state its bound a little looser."""
        if self._json is None:
            self._json = self._inside.json()
        return self._json

    def to_dict(self) -> dict[str, Any]:
        """The same as a dict."""
        return json.loads(self.to_json())  # type: ignore[no-any-return]

    def to_html(self, title: str = "design") -> str:
        """The report: one page that needs no other file."""
        return self._inside.report(title)

    def to_svg(self) -> str:
        """The drawing of all parts and the assembly at 1:1."""
        return self._inside.drawing()

    def plot(self, axes: Optional[Axes] = None, at: Optional[Sequence[float]] = None) -> Axes:
        """Draws map, region, copy and linkage on Matplotlib's axes (new ones unless given), which it returns.

        The tracer stands at `at`, mm; unless given, in the middle of the region.
        """
        from ._plots import plot_design
        return plot_design(self, axes, at)

    def _repr_html_(self) -> str:
        page = html.escape(self.to_html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:42rem;border:0" title="Report of the design"></iframe>'

    def _repr_svg_(self) -> str:
        return self.to_svg()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Design) and (self._inside is other._inside or self.to_json() == other.to_json())

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __reduce__(self) -> Any:
        return _own_design, (self.to_json(),)

    def __repr__(self) -> str:
        lengths = ", ".join(f"{name} {length:.4g}" for name, length in list(self.lengths_mm.items())[:2])
        bound = f", {self.objective} proven within {self.lower_bound:.6g}" if self.lower_bound is not None else ""
        return (f"<kempe.Design: {self.vertex} at V, {lengths} mm, size {self.size_mm:.6g} mm, "
                f"transmission {self.transmission_min_deg:.4g} deg{bound}>")


_FIGURES = ("size_mm", "transmission_min_deg", "clearance_min_mm", "footprint_mm2", "copy_error_worst_mm", "load_error_max_mm",
            "load_error_layered_max_mm", "load_rise_max_mm", "weight_error_max_mm", "weight_error_layered_max_mm", "weight_rise_max_mm",
            "stress_max_MPa", "stress_layered_max_MPa", "sag_max_mm", "mass_kg", "robust_clearance_mm", "objective", "value",
            "lower_bound", "complete")


def _with_lines(copy: dict[str, Any]) -> dict[str, Any]:
    return copy | {key: [CopiedLine(*line) for line in copy[key]] for key in ("drawn", "missing")}


def names_of(written: tuple[list[str], list[str], str]) -> list[str]:
    """The files written, or the error that says why there are none."""
    files, _, reason = written
    if reason:
        raise NotWritten(reason)
    return files


def _own_design(text: str) -> Design:
    return Design._restored(text, "", True)


def _length(tolerance: float) -> float:
    if not tolerance >= 1e-7:  # below it arcs become millions of edges
        raise ValueError(f"a tolerance is at least 1e-07 mm; found {tolerance}")
    return float(tolerance)


def verify(design: Design | Path) -> Verification | Audit:
    """A design driven over its region; of a design.json everything that it states, checked from the file alone.

    Raises SpecError for a file that cannot be read.
    """
    if isinstance(design, Design):
        return design.verify()
    found = _core.verify(design)
    if isinstance(found, list):
        raise error_of(found)
    holds, broken = found
    return Audit(holds, broken_of(broken))
