#!/usr/bin/env python3
"""The figures of random designs once more, from design.json alone and in the plainest way: joints by intersecting circles,
bars as Shapely's buffered lines, at some hundred places of the region. Shares no line with Kempe.

For every design of the random specs (random_specs.py): the lengths close at every place in one assembly; the size; the
smallest transmission angle; no bar nearer than `clearance_min_mm` to a bar of its layer or to an obstacle (pins and posts are
not looked at); the footprint, which is an outer bound on a grid, at most EXCESS larger than what the bars pass over.

usage: plain_figures.py KEMPE [COUNT] [SEED]      exit 1 if a figure is wrong
"""
import cmath
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

from shapely.geometry import LineString, Point, Polygon, shape
from shapely.ops import nearest_points, unary_union

from random_specs import spec

GAP_MM = 0.011    # to 0.01 mm the smallest gap is certified
LENGTH = 1e-6     # of the larger figure: lengths are written with ten digits
ANGLE_DEG = 0.01  # places lie on the region's nearest and farthest point of the pole, to rounding
EXCESS = 0.12     # of the footprint
MISSED = 0.015    # of the footprint: what the places leave out is missing from ours, not from Kempe's
LINKS = ("VA", "VB", "ACX", "BCY")


def toml(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml(entry)}" for key, entry in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value) if isinstance(value, (str, bool)) else repr(value)


def as_complex(point):
    return complex(point.x, point.y)


class Design:
    def __init__(self, design):
        mechanism = design["mechanism"]
        self.lengths, self.vertex = mechanism["lengths_mm"], mechanism["vertex"]
        self.shape, self.pole = complex(*mechanism["shape"]), complex(*mechanism["pole_position_mm"])
        self.k = cmath.rect(design["copy"]["scale"], math.radians(design["copy"]["rotation_deg"]))
        self.openings = [math.radians(angle) for angle in mechanism["opening_deg"]]
        self.links = {link["name"]: link for link in mechanism["links"]}
        self.width = mechanism["link_width_mm"]
        self.region = shape(design["region"])
        self.obstacles = [(shape(one["shape"]), one["layers"]) for one in design["obstacles"]]
        self.quality = design["quality"]

    def places(self):
        """Along the outline, over the inside, and where the region is nearest to the pole and farthest from it."""
        here = Point(self.pole.real, self.pole.imag)
        places = [] if self.region.contains(here) else [as_complex(nearest_points(self.region, here)[0])]
        for polygon in getattr(self.region, "geoms", [self.region]):
            for ring in (polygon.exterior, *polygon.interiors):
                places += [complex(*corner) for corner in ring.coords]
                places += [as_complex(ring.interpolate(i / 300, normalized=True)) for i in range(300)]
        left, low, right, high = self.region.bounds
        for i in range(24):
            for j in range(24):
                place = Point(left + (right - left) * (i + 0.5) / 24, low + (high - low) * (j + 0.5) / 24)
                if self.region.contains(place):
                    places.append(as_complex(place))
        return places

    def joints_at(self, tracer):
        """The six joints and the opening; nothing if no elbow's opening is one of the design's."""
        pen = self.pole + self.k * (tracer - self.pole)
        V, X, Y = {"pole": (self.pole, tracer, pen), "tracer": (tracer, self.pole, pen),
                   "pen": (pen, self.pole, tracer)}[self.vertex]
        way, VA, AX = X - V, self.lengths["VA"], self.lengths["AX"]
        along = (abs(way) ** 2 + VA**2 - AX**2) / (2 * abs(way))
        beside = math.sqrt(max(0.0, VA**2 - along**2))
        for side in (beside, -beside):
            A = V + way / abs(way) * complex(along, side)
            q = self.shape * (X - A)
            opening = cmath.phase(q / (A - V))
            for turned in (opening - 2 * math.pi, opening, opening + 2 * math.pi):
                if self.openings[0] - 1e-6 <= turned <= self.openings[1] + 1e-6:
                    return dict(V=V, A=A, B=V + q, C=A + q, X=X, Y=Y), turned
        return None, None

    def axis(self, name, joints):
        """A link's middle lines: a bar's, a bent plate's from its corner, or a triangle."""
        at = [(joints[letter].real, joints[letter].imag) for letter in name]
        if len(at) == 2:
            return LineString(at)
        if self.links[name]["shape"] == "triangle":
            return Polygon(at)
        return unary_union([LineString([at[0], other]) for other in at[1:]])


def faults(design):
    wrong, swept = [], []
    lengths, quality = design.lengths, design.quality
    least_transmission = math.pi
    for place in design.places():
        joints, opening = design.joints_at(place)
        if joints is None:
            return [f"the tracer does not get to {place:.6f}"]
        for name, length in lengths.items():
            if abs(abs(joints[name[0]] - joints[name[1]]) - length) > LENGTH * max(lengths.values()):
                wrong.append(f"{name} is {abs(joints[name[0]] - joints[name[1]])} at {place:.6f}, not {length}")
        for angle in (opening, opening - cmath.phase(design.shape)):
            least_transmission = min(least_transmission, math.asin(min(1.0, abs(math.sin(angle)))))
        axes = {name: design.axis(name, joints) for name in LINKS}
        swept += [axis.buffer(design.width / 2) for axis in axes.values()]
        for name, axis in axes.items():
            layer = design.links[name]["layer"]
            gaps = [(other, axis.distance(axes[other]) - design.width) for other in LINKS
                    if other > name and design.links[other]["layer"] == layer and not set(other) & set(name)]
            gaps += [("an obstacle", axis.distance(shape_) - design.width / 2) for shape_, (low, high) in design.obstacles
                     if low <= layer <= high]
            wrong += [f"{name} comes {gap:.6f} mm near to {other} at {place:.6f}" for other, gap in gaps
                      if gap < quality["clearance_min_mm"] - GAP_MM]
        if wrong:
            return wrong
    size = sum((lengths[a] + lengths[b] + lengths[c]) / 2 for a, b, c in (("AC", "AX", "CX"), ("BC", "BY", "CY")))
    size += lengths["VA"] + lengths["VB"]
    if abs(size - quality["size_mm"]) > LENGTH * size:
        wrong.append(f"size {size}, not {quality['size_mm']}")
    if abs(math.degrees(least_transmission) - quality["transmission_min_deg"]) > ANGLE_DEG:
        wrong.append(f"transmission {math.degrees(least_transmission)}, not {quality['transmission_min_deg']}")
    footprint = unary_union(swept).area
    if not (1 - MISSED) * footprint <= quality["footprint_mm2"] <= (1 + EXCESS) * footprint:
        wrong.append(f"footprint {footprint}, not {quality['footprint_mm2']}")
    return wrong


def main():
    kempe = sys.argv[1]
    count, seed = (int(sys.argv[i]) if len(sys.argv) > i else default for i, default in ((2, 100), (3, 1)))
    rng, designs, failures = random.Random(seed), 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for number in range(count):
            (folder / "spec.toml").write_text("".join(f"{key} = {toml(value)}\n" for key, value in spec(rng).items()))
            run = subprocess.run([kempe, "synthesize", folder / "spec.toml", "-o", folder / "out", "--quiet"],
                                 capture_output=True, check=False)
            if run.returncode == 0:
                designs += 1
                wrong = faults(Design(json.loads((folder / "out" / "design.json").read_text())))
                failures += bool(wrong)
                for sentence in wrong[:3]:
                    print(f"spec {number} of seed {seed}: {sentence}")
    print(f"{count} specs, {designs} designs, {failures} with a wrong figure")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
