"""Shapes of other programs: whatever has __geo_interface__ (Shapely, GeoPandas, a GeoJSON object)."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Ring = list[list[float]]
#: A polygon: its outer ring and its holes, (n, 2) each, the first point not repeated.
Polygon = tuple[Array, list[Array]]


class Rings(NamedTuple):
    """The rings of a shape."""

    outer: list[Ring]
    holes: list[Ring]


def is_geometry(value: object) -> bool:
    """True for an object with __geo_interface__ and for a GeoJSON object."""
    return hasattr(value, "__geo_interface__") or (isinstance(value, Mapping) and isinstance(value.get("type"), str))


def rings_of(shape: Any) -> Rings:
    """The rings of a Polygon, a MultiPolygon, or of a collection of them; anything else is a ValueError."""
    polygons = list(_polygons(shape if isinstance(shape, Mapping) else shape.__geo_interface__))
    polygons = [polygon for polygon in polygons if polygon]  # an empty one has no rings
    outer = [polygon[0] for polygon in polygons]
    holes = [hole for polygon in polygons for hole in polygon[1:]]
    if any(_is_inside(ring[0], hole) for ring in outer for hole in holes):
        raise ValueError("a polygon lies in the hole of another: a spec has no words for that")
    return Rings(outer, holes)


def _polygons(shape: Mapping[str, Any]) -> Iterable[list[Ring]]:
    kind = shape.get("type")
    if kind == "Polygon":
        yield [_ring(ring) for ring in shape.get("coordinates") or []]
    elif kind == "MultiPolygon":
        for rings in shape.get("coordinates") or []:
            yield [_ring(ring) for ring in rings]
    elif kind == "Feature":
        if shape.get("geometry") is not None:  # a feature may have no place
            yield from _polygons(shape["geometry"])
    elif kind == "FeatureCollection":
        for feature in shape.get("features") or []:
            yield from _polygons(feature)
    elif kind == "GeometryCollection":
        for geometry in shape.get("geometries") or []:
            yield from _polygons(geometry)
    else:
        raise ValueError(f"a {kind} has no area: a Polygon or MultiPolygon is wanted")


def _ring(points: Sequence[Sequence[float]]) -> Ring:
    ring = [[float(point[0]), float(point[1])] for point in points]
    if len(ring) > 1 and ring[0] == ring[-1]:
        ring.pop()
    if not ring:
        raise ValueError("a ring without points")
    return ring


def _is_inside(point: Sequence[float], ring: Ring) -> bool:
    inside, (x, y) = False, point
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
            inside = not inside
    return inside


class Region:
    """A plane region with straight edges, mm, as Shapely reads it: shapely.geometry.shape(region).

    polygons   a list of (outer ring, list of holes), arrays of shape (n, 2); outer rings run counter-clockwise
    """

    def __init__(self, polygons: Sequence[Polygon]):
        self.polygons = list(polygons)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return {"type": "MultiPolygon",
                "coordinates": tuple(tuple(_closed(ring) for ring in (outer, *holes)) for outer, holes in self.polygons)}

    @property
    def area(self) -> float:
        """mm^2."""
        return float(sum(_area(outer) - sum(abs(_area(hole)) for hole in holes) for outer, holes in self.polygons))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Region) and self.__geo_interface__ == other.__geo_interface__

    __hash__ = None  # type: ignore[assignment]

    def __bool__(self) -> bool:
        return bool(self.polygons)

    def __repr__(self) -> str:
        return f"<kempe.Region: {len(self.polygons)} polygons, {self.area:.6g} mm2>"


def _closed(ring: Array) -> tuple[tuple[float, float], ...]:
    points = [(float(x), float(y)) for x, y in ring]
    return tuple(points + points[:1])


def _area(ring: Array) -> float:
    if len(ring) == 0:
        return 0.0
    x, y = (ring - ring[0]).T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
