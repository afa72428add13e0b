"""Designs on Matplotlib's axes."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

import numpy as np

from ._geometry import Region

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._design import Design

#: Links and the joints that they run through, in the order of joints().
_LINKS = {"VA": (0, 1), "VB": (0, 2), "ACX": (3, 1, 4), "BCY": (3, 2, 5)}
_COLOURS = {"VA": "#3b6fb6", "VB": "#4d9a5b", "ACX": "#b5523b", "BCY": "#7d5ba6"}


def plot_map(design: Design, axes: Optional[Axes]) -> Axes:
    axes = axes if axes is not None else _new_axes()
    _fill(axes, design.map.reachable, facecolor="#8a857826", edgecolor="#8a8578", label="within reach")
    _fill(axes, design.map.free, facecolor="#4d9a5b40", edgecolor="#4d9a5b", label="free")
    region = _region(design)
    if region:
        _fill(axes, region, facecolor="#3b6fb640", edgecolor="#3b6fb6", label="region")
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
    axes.legend(loc="best", fontsize="small")
    return axes


def plot_design(design: Design, axes: Optional[Axes], at: Optional[Sequence[float]]) -> Axes:
    axes = plot_map(design, axes)
    region = _region(design)
    if region:
        k, pole = design.copy, complex(*design.pole_mm)
        copied = Region([(_turned(outer, k, pole), [_turned(hole, k, pole) for hole in holes])
                         for outer, holes in region.polygons])
        _fill(axes, copied, facecolor="#b5523b30", edgecolor="#b5523b", label="copy")
    joints = _shown_pose(design, at)
    for link, through in _LINKS.items():
        x, y = joints[list(through)].T
        axes.plot(x, y, color=_COLOURS[link], linewidth=3, solid_capstyle="round", alpha=0.85, zorder=3)
    axes.plot(*joints.T, "o", color="#222222", markersize=4, zorder=4)
    for name, place in zip("VABCXY", joints):
        axes.annotate(name, place, xytext=(4, 4), textcoords="offset points", fontsize="small")
    axes.autoscale_view()
    axes.legend(loc="best", fontsize="small")
    axes.set_title(f"{design.vertex} at V, size {design.size_mm:.4g} mm")
    return axes


def _shown_pose(design: Design, at: Optional[Sequence[float]]) -> Any:
    """The joints with the tracer at `at`, or at a place of the region, or of the free workspace, that is within reach."""
    if at is not None:
        joints = design.joints([at])[0]
        if np.isnan(joints).any():
            raise ValueError(f"the tracer cannot stand at {tuple(at)}: {design.map.why(*at).sentence}")
        return joints
    for region in (_region(design), design.map.free, design.map.reachable):
        corners = [outer for outer, _ in region.polygons if len(outer)]
        if corners:
            every = np.concatenate(corners)
            found = design.joints(np.vstack([0.5 * (every.min(axis=0) + every.max(axis=0)), every]))
            found = found[~np.isnan(found).any(axis=(1, 2))]
            if len(found):
                return found[0]
    raise ValueError("the linkage has no pose")


def _region(design: Design) -> Region:
    polygons = design.to_dict()["region"]["coordinates"]
    return Region([(np.array(rings[0][:-1]), [np.array(ring[:-1]) for ring in rings[1:]]) for rings in polygons])


def _turned(ring: Any, k: complex, pole: complex) -> Any:
    places = pole + k * (ring[:, 0] + 1j * ring[:, 1] - pole)
    return np.stack([places.real, places.imag], axis=-1)


def _new_axes() -> Axes:
    import matplotlib.pyplot as plt
    return plt.subplots()[1]


def _fill(axes: Axes, region: Region, **style: Any) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path
    rings = [ring for outer, holes in region.polygons for ring in (outer, *holes) if len(ring)]
    if not rings:
        return
    corners = np.concatenate([np.vstack([ring, ring[:1]]) for ring in rings])
    codes = np.concatenate([[Path.MOVETO] + [Path.LINETO] * (len(ring) - 1) + [Path.CLOSEPOLY] for ring in rings])
    axes.add_patch(PathPatch(Path(corners, codes), **style))
    axes.update_datalim(corners)
