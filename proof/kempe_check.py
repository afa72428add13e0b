#!/usr/bin/env python3
"""Checks a design of Kempe from its files alone; shares no code with Kempe. The theorems stand in docs/proof.md.

usage: kempe_check.py design.json [certificate.jsonl]   or   kempe_check.py certificate.jsonl

A line a claim: proven, not proven or refuted. Exit code 0: all claims are proven; 1: one is not; 2: a file cannot be read.

eps:      claims 1, 2 and 5 and the limits forgive 1e-6 mm and 1e-6 degrees; claims 3 and 4 forgive nothing.
Assumes:  + - * / and sqrt of doubles are rounded correctly (IEEE 754); the numbers of the files are the doubles nearest
          to them; rings are simple, and holes lie inside their polygon.
"""
import json
import math
import sys
from fractions import Fraction
from itertools import product
from math import hypot, inf, nextafter

EPS_MM, EPS_DEG = 1e-6, 1e-6
MOST_CELLS = 200_000  # of one search; then the answer is "not proven"
STAGES = (0.25, 0.5, 0.75, 1.0)  # of the way from the nominal instrument to another, evenly spaced
LINKS = ("VA", "VB", "ACX", "BCY")
PINS = {"A": ("VA", "ACX"), "B": ("VB", "BCY"), "C": ("ACX", "BCY"), "V": ("VA", "VB")}
POSTS = {"V": ("VA", "VB"), "X": ("ACX",), "Y": ("BCY",)}
PARTS = LINKS + tuple("pin " + j for j in PINS) + tuple("post " + j for j in POSTS)
# A joint has a hole in each of its links, which play sets apart. Capitals: the first link of PINS; small letters: the second.
HOLES = {"VA": "VA", "VB": "vB", "ACX": "aCX", "BCY": "bcY", "pin A": "Aa", "pin B": "Bb", "pin C": "Cc"}
LENGTHS = ("VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY")
LOOKED_AT = ("format", "copy", "region", "mechanism", "limits", "tolerance", "obstacles", "pole", "links", "objective", "cutting")
VERTICES = ("pole", "tracer", "pen")  # who stands at the vertex V


class Unreadable(Exception):
    """A file that says nothing definite: file, key, what was found, what is allowed."""


class Open(Exception):
    """Nothing is decided."""


class Refuted(Exception):
    """A claim is false, and why."""


class I:
    """An interval that holds the exact value, each result moved outwards by one step; `d`: its derivatives, by variable."""
    __slots__ = ("lo", "hi", "d")

    def __init__(self, lo, hi=None, d=None):
        self.lo, self.hi, self.d = lo, lo if hi is None else hi, d

    def __add__(self, o):
        o = o if o.__class__ is I else I(o)
        if not (o.lo or o.hi or o.d):
            return self
        if not (self.lo or self.hi or self.d):
            return o
        return I(nextafter(self.lo + o.lo, -inf), nextafter(self.hi + o.hi, inf), both(self.d, o.d))

    def __neg__(self):
        return I(-self.hi, -self.lo, self.d and {v: -x for v, x in self.d.items()})

    def __sub__(self, o):
        return self + -o

    def __rsub__(self, o):
        return -self + o

    def __mul__(self, o):
        o = o if o.__class__ is I else I(o)
        if not (self.lo or self.hi or self.d) or not (o.lo or o.hi or o.d):
            return ZERO
        ends = (self.lo * o.lo, self.lo * o.hi, self.hi * o.lo, self.hi * o.hi)
        lo, hi = min(ends), max(ends)
        if not (lo > -1e150 and hi < 1e150):  # so no infinity comes up, and no NaN
            raise Open
        zero = not (self.lo or self.hi) or not (o.lo or o.hi)
        lo, hi = (0.0, 0.0) if zero else (nextafter(lo, -inf), nextafter(hi, inf))
        return I(lo, hi, both(times(self.d, o), times(o.d, self)) if self.d or o.d else None)

    def __truediv__(self, o):
        if not (o.lo > 1e-140 or o.hi < -1e-140):
            raise Open
        inverse = I(nextafter(1 / o.hi, -inf), nextafter(1 / o.lo, inf))
        inverse.d = o.d and times(o.d, -(inverse * inverse))
        return self * inverse

    __radd__, __rmul__ = __add__, __mul__

    def sqrt(self):
        if not self.lo >= 0:
            raise Open
        root = I(max(0.0, nextafter(math.sqrt(self.lo), -inf)), nextafter(math.sqrt(self.hi), inf))
        root.d = self.d and times(self.d, I(0.5) / root)
        return root

    def square(self):
        low = 0.0 if self.lo <= 0 <= self.hi else min(abs(self.lo), abs(self.hi))
        high = nextafter(self.size() * self.size(), inf) if self.size() else 0.0
        return I(max(0.0, nextafter(low * low, -inf)), high, times(self.d, I(2 * self.lo, 2 * self.hi)))

    def size(self):
        return max(abs(self.lo), abs(self.hi))

    def middle(self):
        return 0.5 * self.lo + 0.5 * self.hi


ZERO, ONE = I(0.0), I(1.0)


def times(slopes, o):
    return slopes and {v: x * I(o.lo, o.hi) for v, x in slopes.items()}


def both(one, other):
    return {**one, **{v: one[v] + x if v in one else x for v, x in other.items()}} if one and other else one or other


def cmul(a, b):
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def cadd(a, b):
    return a[0] + b[0], a[1] + b[1]


def csub(a, b):
    return a[0] - b[0], a[1] - b[1]


def conj(a):
    return a[0], -a[1]


def cdiv(a, b):
    return tuple(c / square_of(b) for c in cmul(a, conj(b)))


def square_of(a):
    return a[0].square() + a[1].square()


def centre(a):
    return a[0].middle(), a[1].middle()


def apex(d, left, right, sign):
    """The third corner of a triangle on the base from 0 to 1, d: the base's square, by Heron. That there are slopes proves that
    its height does not vanish."""
    f = ONE / d
    h = (((left + right).square() * f - 1.0) * (1.0 - (left - right).square() * f)).sqrt() * sign
    return ((left.square() - right.square()) * f + 1.0) * 0.5, h * 0.5


def unit_circle(degrees):
    """Cosine and sine of decimal degrees: Taylor's series in whole multiples of 2^-160, the rest far below 2^-100."""
    quarters, rest = divmod(Fraction(degrees) % 360, 90)
    pi = Fraction("3.14159265358979323846264338327950288419716939937511")
    x, one = int((rest * pi / 180) * (1 << 160)), 1 << 160
    sums, term, n = [one, 0], one, 0
    while term:
        n += 1
        term = term * x // (n << 160)
        sums[n % 2] += term if n % 4 < 2 else -term
    c, s = (I(t / one) + I(-1e-40, 1e-40) if rest else I(float(t >> 160)) for t in sums)
    return [(c, s), (-s, c), (-c, -s), (s, -c)][int(quarters)]


# Plane geometry in doubles: exact where it decides, else a guess that is proven by intervals or kept away from by a slack.


def side(p, q, r):
    """The sign of the turn p-q-r, exact."""
    left, right = (q[0] - p[0]) * (r[1] - p[1]), (q[1] - p[1]) * (r[0] - p[0])
    if abs(left - right) > 1e-14 * (abs(left) + abs(right)) + 1e-290:
        return left - right
    p, q, r = ([Fraction(c) for c in point] for point in (p, q, r))
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def where(point, rings):
    """1 inside, 0 on an edge, -1 outside, by the even-odd rule; exact."""
    (x, y), inside = point, -1
    for p, q in (edge for ring in rings for edge in zip(ring, ring[1:])):
        if min(p[1], q[1]) <= y <= max(p[1], q[1]):
            turn = side(p, q, point)
            if turn == 0 and min(p[0], q[0]) <= x <= max(p[0], q[0]):
                return 0
            if (p[1] > y) != (q[1] > y) and (turn > 0) == (q[1] > p[1]):
                inside = -inside
    return inside


def to_segment(p, a, b):
    """From p to the nearest point of the segment a-b."""
    ax, ay, dx, dy = a[0] - p[0], a[1] - p[1], b[0] - a[0], b[1] - a[1]
    length = dx * dx + dy * dy
    t = min(1.0, max(0.0, -(ax * dx + ay * dy) / length)) if length else 0.0
    return ax + t * dx, ay + t * dy


def apart(A, B):
    """The shortest way from convex A to convex B, given by their corners in order; (0, 0) if they meet."""
    for P, Q in ((A, B), (B, A)):
        turns = [side(Q[i - 1], Q[i], P[0]) for i in range(len(Q))] if len(Q) > 2 else [0]
        if min(turns) > 0 or max(turns) < 0:
            return 0.0, 0.0
    edges = [(Q[i - 1], Q[i]) for Q in (A, B) for i in range(len(Q))]
    for (a, b), (c, d) in product(edges[:len(A)], edges[len(A):]):
        if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
            return 0.0, 0.0
    ways = [to_segment(p, *e) for p in A for e in edges[len(A):]]
    ways += [(-x, -y) for x, y in (to_segment(p, *e) for p in B for e in edges[:len(A)])]
    return min(ways, key=lambda v: hypot(*v))


def convex(ring):
    """True if a closed ring turns one way only, and once around."""
    corners = list(zip(ring, ring[1:], ring[2:] + ring[1:2]))
    turns = [side(*c) for c in corners]
    ways = [math.atan2(q[1] - p[1], q[0] - p[0]) for p, q in zip(ring, ring[1:] + ring[1:2])]
    around = sum(math.remainder(v - u, 2 * math.pi) for u, v in zip(ways, ways[1:]))
    return (min(turns) >= 0 or max(turns) <= 0) and abs(around) < 7


def clip(corners, axis, at, keep):
    """The part of a polygon on one side of a line; corners on the line have its coordinate exactly."""
    out = []
    for p, q in zip(corners, corners[1:] + corners[:1]):
        u, v = keep * (p[axis] - at), keep * (q[axis] - at)
        if u >= 0:
            out.append(p)
        if u < 0 < v or v < 0 < u:
            cut = [p[i] + u / (u - v) * (q[i] - p[i]) for i in (0, 1)]
            cut[axis] = at
            out.append(tuple(cut))
    return out


def tree_of(edges):
    """Edges under rectangles: (corners, size, children or None)."""
    if len(edges) == 1:
        return edges[0], 0.0, None
    (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*(p for e in edges for p in e)))
    half = len(edges) // 2
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)], math.dist((x0, y0), (x1, y1)), (tree_of(edges[:half]), tree_of(edges[half:]))


class Shape:
    """What ratio and vertex fix: s, g, the factors of the lengths, and the modes."""

    def __init__(self, task, vertex):
        turn, one = unit_circle(task.degrees), (ONE, ZERO)
        self.vertex, k = vertex, tuple(c * task.scale for c in turn)
        self.k, inverse = k, cdiv(one, k)
        self.s = {"pole": k, "tracer": csub(one, k), "pen": csub(one, inverse)}[vertex]
        self.g = {"pole": one, "tracer": (-ONE, ZERO), "pen": (-k[0], -k[1])}[vertex]
        self.abs_s, self.abs_1s, self.abs_g = (square_of(z).sqrt() for z in (self.s, csub(one, self.s), self.g))
        self.straight = not (k[1].lo or k[1].hi)
        self.up = -1.0 if self.s[1].hi < 0 or self.straight and self.s[0].hi < 0 else 1.0  # the sign of arg s
        if not (self.straight or self.s[1].lo > 0 or self.s[1].hi < 0) or not self.abs_s.lo > 0:
            raise Open("the shape is nearly degenerate")
        half = (self.abs_s + self.abs_1s + 1.0) * 0.5
        self.size = (half + 1.0, half + self.abs_s)  # of a and of b
        self.of_a = {"VA": ONE, "BC": ONE, "BY": self.abs_s, "CY": self.abs_1s}
        self.of_b = {"VB": self.abs_s, "AC": self.abs_s, "AX": ONE, "CX": self.abs_1s}
        self.modes = 2 if self.straight else 4
        # (alpha, beta) of joint - V = alpha p + beta q/s
        no = (ZERO, ZERO)
        self.seen = {"V": (no, no), "A": (one, no), "B": (no, self.s), "C": (one, self.s), "X": (one, one), "Y": (self.s, self.s)}

    def signs(self, mode):
        """Of sin psi and of sin d."""
        sin_d = -1 if mode < self.modes // 2 else 1
        return (sin_d if self.straight else 1 if mode in (0, 3) else -1) * self.up, sin_d

    def window(self, mode, degrees):
        """Cosines of the least and the largest |psi| with the transmission angle asked for."""
        c, s = unit_circle(degrees)
        if self.straight:
            return c, -c
        # The change point in this half turn is psi = -arg s modulo pi; the dead point is 0 where d comes to arg s itself.
        cc, cs = self.s[0] * (-self.up * self.signs(mode)[0]) / self.abs_s, self.s[1] * self.up / self.abs_s
        return (c, cc * c + cs * s) if (mode > 1) == (self.up > 0) else (cc * c - cs * s, -c)


def occupied(part, layers):
    """The layers that a part fills, given those of the links."""
    if part in LINKS:
        return {layers[part]}
    kind, joint = part.split()
    levels = sorted(layers[link] for link in (PINS if kind == "pin" else POSTS)[joint])
    return set(range(levels[0] + 1, levels[-1])) if kind == "pin" else set(range(1, levels[0]))


def joints_of(part):
    return tuple(part) if part in LINKS else (part[-1],)


def may_meet(one, other):
    return not set(joints_of(one)) & set(joints_of(other))


def pieces(part, plate):
    """Convex pieces of a part's axis, by joints."""
    joints = joints_of(part)
    return [joints[:2], joints[::2]] if len(joints) == 3 and plate == "bent" else [joints]


def share(one, other, layers, obstacles):
    """True if a part has a layer in common with a part, or with an obstacle given by its number."""
    if isinstance(other, str):
        return bool(occupied(one, layers) & occupied(other, layers))
    return any(obstacles[other]["layers"][0] <= layer <= obstacles[other]["layers"][1] for layer in occupied(one, layers))


class File:
    """A JSON object; whatever is not as allowed is refused with its key."""

    def __init__(self, name, data):
        self.name, self.data = name, data

    def fault(self, key, found, allowed):
        raise Unreadable(f"{self.name}: {key}: found {str(found)[:60]}; allowed: {allowed}")

    def get(self, path, among=None):
        at = self.data
        for key in path.split("."):
            at = at[key] if isinstance(at, dict) and key in at else self.fault(path, "nothing", "a value")
        return at if among is None or at in among else self.fault(path, at, " or ".join(among))

    def number(self, path, low=-1e9, high=1e9, value=inf, kind=float):
        value = self.get(path) if value is inf else value
        if type(value) not in (int, kind) or not low <= value <= high:
            self.fault(path, value, f"a {'whole ' * (kind is int)}number from {low} to {high}")
        return kind(value)

    def optional(self, path):
        table, _, key = path.rpartition(".")
        return self.number(path, 0) if (self.get(table) or {}).get(key) is not None else None

    def point(self, path, value):
        if not isinstance(value, list) or len(value) != 2:
            self.fault(path, value, "[x, y]")
        return tuple(self.number(path, -2e7, 2e7, c) for c in value)

    def polygons(self, path):
        value = self.get(path)
        if not isinstance(value, dict) or value.get("type") != "MultiPolygon" or not isinstance(value.get("coordinates"), list):
            self.fault(path, value, "a MultiPolygon")
        polygons = [[[self.point(path, c) for c in ring] for ring in polygon] for polygon in value["coordinates"]]
        for polygon in polygons:
            if not polygon or any(len(ring) < 4 or ring[0] != ring[-1] for ring in polygon):
                self.fault(path, polygon, "closed rings of three corners and more")
            if any(where(c, polygon[:1]) < 0 for hole in polygon[1:] for c in hole):
                self.fault(path, "a hole outside its polygon", "holes inside")
        return polygons


class Task:
    """What was asked for, from the tables that design.json and a log have in common."""

    def __init__(self, file, made, plate):
        self.file, self.plate = file, plate
        self.scale, self.degrees = file.number("copy.scale", 1e-6), file.number("copy.rotation_deg", -3600, 3600)
        self.width, self.pin = (file.number(made + key, 1e-6) for key in ("link_width_mm", "pin_diameter_mm"))
        self.region, self.obstacles = file.polygons("region"), []
        self.clearance, self.transmission = file.number("limits.clearance_mm", 0), file.number("limits.transmission_deg", 0, 90)
        self.sheets_gap, self.copy_error = file.optional("limits.sheets_gap_mm"), file.optional("limits.copy_error_mm")
        for i, table in enumerate(file.get("obstacles")):
            rings, layers = File(f"{file.name}: obstacles[{i}]", table).polygons("shape"), table.get("layers")
            if not isinstance(layers, list) or len(layers) != 2 or len(rings) != 1:
                file.fault(f"obstacles[{i}]", table, "a shape of one polygon and layers [lowest, highest]")
            low, high = (file.number(f"obstacles[{i}].layers", 0, 64, layer, int) for layer in layers)
            name = str(table.get("name") or f"obstacle {i + 1}")
            layers = low, file.number(name + ": layers", low, 64, high, int)
            self.obstacles.append({"rings": rings[0], "layers": layers, "name": name})

    def half(self, part):
        return 0.5 * (self.width if part in LINKS else self.pin)

    def read_choice(self):
        """What limits the choice of a design: lengths, layers, groundings, the pole's place."""
        file = self.file
        self.layers, self.longest = file.number("links.layers", 1, 8, kind=int), file.number("links.longest_mm", 0)
        apart_ = I(self.pin + max(0.0, file.number("cutting.hole_fit_mm", -10, 10))) + file.number("links.wall_mm", 0)
        self.shortest = max(file.number("links.shortest_mm", 0), apart_.lo)
        self.locked = {n: v for n in LENGTHS if (v := file.optional(f"links.{n}_mm"))}
        self.grid, stock = file.optional("links.grid_mm"), file.get("links.stock_mm") or ()
        self.stock = [file.number("links.stock_mm", 0, value=s) for s in stock]
        self.groundings, pole = file.get("objective.groundings"), file.get("pole")
        known = isinstance(self.groundings, list) and set(self.groundings) <= set(VERTICES)
        if not isinstance(pole, dict) or len(pole) != 1 or not known:
            file.fault("pole, objective.groundings", pole, "at_mm or within_mm, and a list of vertices")
        self.pole_at = file.point("pole.at_mm", pole["at_mm"]) if "at_mm" in pole else None
        self.pole_within = None if self.pole_at else file.polygons("pole.within_mm") or file.fault("pole.within_mm", [], "an area")


class Design:
    """Claims 1, 2 and 5, and the limits."""

    def __init__(self, file):
        self.file = file
        file.get("format", ("kempe-design/1",))
        links = {l.get("name"): l for l in file.get("mechanism.links")}
        if not links.keys() >= set(LINKS) or links["ACX"].get("shape") != links["BCY"].get("shape"):
            file.fault("mechanism.links", links, "VA, VB, ACX, BCY, both plates of one shape")
        self.layers = {l: file.number("mechanism.links", 1, 64, links[l].get("layer"), int) for l in LINKS}
        task = self.task = Task(file, "mechanism.", links["ACX"].get("shape"))
        if task.plate not in ("bent", "triangle"):
            file.fault("mechanism.links", task.plate, "bent or triangle")
        shape = self.shape = Shape(task, file.get("mechanism.vertex", VERTICES))
        self.sign, self.sign_d = shape.signs(file.number("mechanism.assembly", 0, shape.modes - 1, kind=int))
        self.pole = file.point("mechanism.pole_position_mm", file.get("mechanism.pole_position_mm"))
        self.lengths = {n: file.number(f"mechanism.lengths_mm.{n}", 1e-6) for n in LENGTHS}
        self.a, self.b = I(self.lengths["VA"]), I(self.lengths["VB"]) / shape.abs_s
        sides = [x.middle() for x in (ONE, shape.abs_s, shape.abs_1s)]
        self.flat = 20 * abs(shape.s[1].middle()) < max(sides) * min(sides)
        self.exact = {n: f * unit for unit, factors in ((self.a, shape.of_a), (self.b, shape.of_b)) for n, f in factors.items()}
        tolerant = file.data.get("tolerance") is not None
        self.length, self.play = (tolerant and file.optional(f"tolerance.{key}_mm") or 0.0 for key in ("length", "play"))
        self.robust = tolerant and file.get("tolerance").get("robust", False)
        if self.robust not in (True, False):
            file.fault("tolerance.robust", self.robust, "true or false")
        # Places are taken from the pole. In doubles they, and the corners of cells, are off by less than `slip`.
        self.region, self.blocks = self.local(task.region), self.local([o["rings"] for o in task.obstacles])
        sizes = [max((abs(c) for p in polygons for ring in p for corner in ring for c in corner), default=0.0)
                 for polygons in (task.region + [o["rings"] for o in task.obstacles] + [[[self.pole]]], self.region + self.blocks)]
        self.slip = 2.0 ** -50 * sizes[0] + 2.0 ** -44 * sizes[1]

    def local(self, polygons):
        return [[[(c[0] - self.pole[0], c[1] - self.pole[1]) for c in ring] for ring in polygon] for polygon in polygons]

    def near(self, point):
        return tuple(I(c - self.slip, c + self.slip) for c in point)

    def distances(self):
        """Enclosures of the least and the largest squared distance of the region from the pole."""
        if not self.region or any(where(self.pole, polygon) >= 0 for polygon in self.task.region):
            raise Refuted("the pole stands in the region, where the tracer cannot go" if self.region else "the file has no region")
        least, most = I(inf), I(0.0)
        for ring in (ring for polygon in self.region for ring in polygon):
            corners = [self.near(c) for c in ring]
            squares = [square_of(c) for c in corners]
            for p, q, pp, qq in zip(corners, corners[1:], squares, squares[1:]):
                way, lo, hi = csub(q, p), min(pp.lo, qq.lo), min(pp.hi, qq.hi)
                along, length = -(p[0] * way[0] + p[1] * way[1]), square_of(way)
                if length.lo <= 0:  # an edge too short for a direction
                    lo = square_of(tuple(I(min(c.lo, d.lo), max(c.hi, d.hi)) for c, d in zip(p, q))).lo
                elif along.hi > 0 and along.lo < length.hi:  # the foot may lie on the edge
                    lo = min(lo, ((p[0] * way[1] - p[1] * way[0]).square() / length).lo)
                    part = min(1.0, max(0.0, along.middle() / length.middle()))
                    hi = min(hi, square_of(cadd(p, tuple(c * part for c in way))).hi)
                least, most = I(min(least.lo, lo), min(least.hi, hi)), I(max(most.lo, pp.lo), max(most.hi, pp.hi))
        return least, most

    def reached(self):
        """Claim 1. Sets the range of distances, and the way that the tracer moves radially."""
        shape = self.shape
        for name, length in self.lengths.items():
            if (self.exact[name] - length).size() > EPS_MM:
                raise Refuted(f"length {name} = {length} does not fit VA, VB and the ratio")
        squares, sine, cotangents = self.distances(), unit_circle(max(0.0, self.task.transmission - EPS_DEG))[1], []
        for place, square in zip(("nearest", "farthest"), squares):
            c = (square * shape.abs_g.square() - self.a.square() - self.b.square()) / (self.a * self.b * 2.0)
            if c.lo > 1 or c.hi < -1:
                raise Refuted(f"the {place} place, {math.sqrt(square.middle()):.6g} mm from the pole, is out of reach")
            sin_psi = ((1.0 - c) * (c + 1.0)).sqrt()
            sin_d = (shape.s[0] * sin_psi * self.sign + shape.s[1] * c) / shape.abs_s * self.sign_d
            for point, x in (("dead", sin_psi), ("change", sin_d)):
                if x.hi < sine.lo or x.hi <= 0:
                    raise Refuted(f"at the {place} place the {point} point is only "
                                  f"{math.degrees(math.asin(max(-1, x.hi))):.6g} degrees away")
                if not (x.lo >= sine.hi and x.lo > 0):
                    raise Open
            cotangents.append((shape.s[0] * c - shape.s[1] * sin_psi * self.sign) / shape.abs_s / (sin_d * self.sign_d))
        self.range = [square.sqrt() for square in squares]
        self.cotangents = [(min(c.lo for c in cotangents), 0.0), (max(c.hi for c in cotangents), 0.0)]
        self.radius = [(self.range[0].lo, 0.0), (self.range[1].hi, 0.0)]
        return f" (transmission {self.task.transmission:g} degrees, eps {EPS_DEG:g} degrees)"

    def nominal(self, z):
        """The holes, from the pole, with the tracer at z, by (2); and the turns into the frames of links."""
        s, w, a, b = self.shape.s, cmul(self.shape.g, z), self.a, self.b
        r, aa, bb = square_of(w), a.square(), b.square()
        h = ((a * b * 2.0).square() - (r - aa - bb).square()).sqrt() * self.sign
        p = tuple(c / (r * 2.0) for c in cmul(w, (r + aa - bb, -h)))
        q, V = cmul(s, csub(w, p)), (ZERO, ZERO) if self.shape.vertex == "pole" else (-w[0], -w[1])
        A, B, C, X, Y = cadd(V, p), cadd(V, q), cadd(V, cadd(p, q)), cadd(V, w), cadd(V, cmul(s, w))
        turns = {"ACX": tuple(x / self.exact["AC"] for x in conj(q)), "VA": tuple(x / a for x in conj(p)), "table": (ONE, ZERO)}
        return {"V": V, "v": V, "A": A, "a": A, "B": B, "b": B, "C": C, "c": C, "X": X, "Y": Y, "P": (ZERO, ZERO)}, turns

    def instrument(self, z, share=1.0):
        """The same of all instruments within a share of the tolerances, the tracer on the axis, with slopes by all that may be
        wrong, triangle by triangle: the ways from hole to hole, and the turns."""
        reach, still = {}, self.nominal((square_of(z).sqrt(), ZERO))[0]

        def off(value, by, name):
            reach[name] = I(-by * share, by * share)
            return value + I(-by * share, by * share, {name: ONE}) if by else value

        def way(i, j, at_i, at_j):  # by the mean value theorem often narrower than the difference
            out = []
            for c, exact in zip(csub(at_j, at_i), csub(still[j], still[i])):
                about = sum((slope * reach[v] for v, slope in (c.d or {}).items()), exact)
                out.append(I(max(c.lo, about.lo), min(c.hi, about.hi), c.d))
            return out

        def dyad(i, j, at_i, at_j, left, right, sign):  # the joint of two bars that hang at i and j
            base = way(i, j, at_i, at_j)
            return cadd(at_i, cmul(base, apex(square_of(base), L[left], L[right], sign)))

        def third(o, p, q, at_o, at_p):  # hole q of a plate whose holes o and p are given
            turn = cdiv(csub(spots[q], spots[o]), csub(spots[p], spots[o]))
            if self.length and not self.flat:
                side, one, other = (L["".join(sorted(n))] for n in (o + p, o + q, p + q))
                turn = apex(side.square(), one, other, 1.0 if turn[1].lo > 0 else -1.0)
            return cadd(at_o, cmul(way(o, p, at_o, at_p), turn))

        s, vertex, no, one = self.shape.s, self.shape.vertex, (ZERO, ZERO), (ONE, ZERO)
        L = {name: off(x, self.length, name) for name, x in self.exact.items()}
        e = {j: (off(ZERO, 0.5 * self.play, j + "x"), off(ZERO, 0.5 * self.play, j + "y")) for j in "PVABC"}
        spots = {"A": no, "B": no, "C": one, "X": cdiv(one, s), "Y": s}  # in the plates' frames, in units of AC and BC
        if self.flat and self.length:
            for tip, corner in (("X", "A"), ("Y", "B")):
                height = off(spots[tip][1] * self.exact[corner + "C"], self.length, "C" + tip)
                along = (L[corner + tip].square() - height.square()).sqrt() * (1.0 if s[0].lo > 0 else -1.0)
                spots[tip] = along / L[corner + "C"], height / L[corner + "C"]
                L["C" + tip] = square_of(csub(spots[tip], one)).sqrt() * L[corner + "C"]
        r, P = square_of(z).sqrt(), no
        T = r, ZERO
        if vertex == "pen":
            X, Y = e["P"], T
            C = dyad("X", "Y", X, csub(Y, e["C"]), "CX", "CY", self.sign)
            c = cadd(C, e["C"])
            a, b = third("C", "X", "A", C, X), third("C", "Y", "B", c, Y)
            A, B = csub(a, e["A"]), csub(b, e["B"])
            V = dyad("A", "B", A, csub(B, e["V"]), "VA", "VB", self.sign_d)
            v = cadd(V, e["V"])
        else:
            V, X, v = (e["P"], T, e["V"]) if vertex == "pole" else (T, e["P"], cadd(T, e["V"]))
            A = dyad("V", "X", V, csub(X, e["A"]), "VA", "AX", -self.sign)
            a = cadd(A, e["A"])
            C = third("A", "X", "C", a, X)
            c = cadd(C, e["C"])
            B = dyad("V", "C", v, csub(c, e["B"]), "VB", "BC", self.sign_d)
            b = cadd(B, e["B"])
            Y = third("B", "C", "Y", b, c)
        at = {"V": V, "v": v, "A": A, "a": a, "B": B, "b": b, "C": C, "c": c, "X": X, "Y": Y, "P": P}
        turns = {"ACX": tuple(x / L["AC"] for x in conj(way("a", "C", a, C))),
                 "VA": tuple(x / L["VA"] for x in conj(way("V", "A", V, A))),
                 "table": tuple(x / r for x in z)}
        return lambda i, j: way(i, j, at[i], at[j]), turns

    def loss(self, n, slopes):
        """How far all that the tolerances let vary can move a way along n."""
        def slope(variable):
            x, y, dx, dy = slopes.get(variable, (0.0, 0.0, 0.0, 0.0))
            return abs(n[0] * x + n[1] * y) + abs(n[0]) * dx + abs(n[1]) * dy
        pins = sum(hypot(slope(j + "x"), slope(j + "y")) for j in "PVABC") if self.play else 0.0
        return (1 + 1e-14) * (self.length * sum(map(slope, LENGTHS)) + 0.5 * self.play * pins)

    def holes(self, part, piece):
        if part in LINKS:
            return [HOLES[part][part.index(joint)] for joint in piece]
        return "P" if part[-1] == ("V" if self.shape.vertex == "pole" else "X") else HOLES.get(part, part[-1])

    def clear(self, every=False):
        """Claim 2, or claim 5. Contact of the linkage with itself does not change if all turns about the pole."""
        task, self.every, itself, blocked = self.task, every, [], []
        for one, other in ((one, other) for i, one in enumerate(PARTS) for other in PARTS[:i]):
            together = share(one, other, self.layers, ())
            if not may_meet(one, other):
                if together and one in LINKS and other in LINKS:
                    raise Refuted(f"{other} and {one} share a joint and a layer")
            elif together or one.startswith("post") and other.startswith("post"):
                # Parallel to VB and ACX, or to VA and BCY: seen from there such parts do not turn.
                frame = "ACX" if {"VB", "ACX"} & {one, other} else "VA"
                itself += [(other, self.holes(other, A), one, self.holes(one, B), frame, ([(0.0, 0.0)], 0.0, None),
                            task.half(one) + task.half(other) + task.clearance)
                           for A, B in product(pieces(other, task.plate), pieces(one, task.plate))]
        self.cover([self.radius], itself, None, self.pending_in)
        # A part that meets no edge on its way is inside an obstacle always or never: one place decides.
        for (i, block), part in product(enumerate(self.blocks), PARTS):
            for piece in pieces(part, task.plate) if share(part, i, self.layers, task.obstacles) else ():
                holes, name = self.holes(part, piece), task.obstacles[i]["name"]
                if where(self.seen(self.region[0][0][0], "table", holes)[0], block) > 0:
                    raise Refuted(f"{part} is inside {name}")
                blocked += [(part, holes, name, "P", "table", tree_of(list(zip(ring, ring[1:]))), task.half(part) + task.clearance)
                            for ring in block]
        for rings in self.region if blocked else ():
            simple = len(rings) == 1 and convex(rings[0])
            self.cover([ring[:-1] for ring in rings], blocked, None if simple else rings, self.pending_in)
            if rings is not self.region[0]:
                self.way(self.region[0][0], rings[0], blocked)
        return f" (clearance {self.task.clearance:g} mm, eps {EPS_MM:g} mm)"

    def seen(self, z, frame, names):
        """Holes of the nominal linkage, from the pole, with the tracer at z."""
        holes, turns = self.nominal((I(z[0]), I(z[1])))
        return [centre(cmul(holes[j], turns[frame])) for j in names]

    def cover(self, parts, pairs, rings, pending_in):
        """Cells of a polygon, halved until nothing is pending in any. `rings`: the polygon's, if it is not convex."""
        (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*parts[0]))
        todo, cells = [([x0, x1, y0, y1], parts, pairs)], 0
        while todo:
            (box, parts, pending), cells = todo.pop(), cells + 1
            # A corner of the cell counts only if it is in the region; all others are on the region's edges.
            hull = [c for c in {c for part in parts for c in part}
                    if rings is None or not (c[0] in box[:2] and c[1] in box[2:]) or where(c, rings) >= 0]
            left = pending_in(box, hull, pending) if hull else None
            if left is not None:
                axis = 0 if box[1] - box[0] >= box[3] - box[2] else 1
                m = 0.5 * box[2 * axis] + 0.5 * box[2 * axis + 1]
                if m in box[2 * axis:2 * axis + 2] or cells > MOST_CELLS:
                    raise Open
                for end, keep in ((1, -1), (0, 1)):
                    child = list(box)
                    child[2 * axis + end] = m
                    todo.append((child, [clip(part, axis, m, keep) for part in parts], left))

    def pending_in(self, box, hull, pending):
        """The pairs not proven apart over the hull; None if there are none, and the linkage closes."""
        m = 0.5 * box[0] + 0.5 * box[1], 0.5 * box[2] + 0.5 * box[3]
        z = tuple(I(box[2 * i] - self.slip, box[2 * i + 1] + self.slip, {"xy"[i]: ONE}) for i in (0, 1))
        try:
            (moving, turning), (still, turn) = self.nominal(z), self.nominal((I(m[0]), I(m[1])))
            wrong = [self.instrument([I(c.lo, c.hi) for c in z], part) for part in STAGES] if self.every else []
        except Open:
            return pending
        ways, known, left, todo = [dict(zip("xy", csub(self.near(v), m))) for v in hull], {}, [], list(pending)

        def moved(i, j, frame):  # the way from hole to hole
            if (i, j, frame) not in known:
                at, over = cmul(csub(still[j], still[i]), turn[frame]), cmul(csub(moving[j], moving[i]), turning[frame])
                slopes = [slopes_of(cmul(way(i, j), twisting[frame])) for way, twisting in wrong]
                known[i, j, frame] = *cloud(at, over, ways), slopes
            return known[i, j, frame]

        while todo:
            pair = part, A, other, B, frame, node, distance = todo.pop()
            clouds = [moved(i, j, frame) for i, j in product(A, B)]
            P, Q = ([centre(cmul(still[j], turn[frame])) for j in names] for names in (A, B))
            v = apart(P, [cadd(q, e) for q in Q for e in node[0]])
            if not self.separated(v, clouds, node[0], distance):
                if node[2] and node[1] > max(c[2] for c in clouds):
                    todo += [(part, A, other, B, frame, child, distance) for child in node[2]]
                    continue
                if hypot(*v) < distance and not node[2]:
                    self.refute(hull[0], pair)
                left.append(pair)
        return left or None

    def separated(self, v, clouds, edge, distance):
        """True if one direction proves the two farther apart than the distance all over the cell."""
        if not (gap := hypot(*v)):
            return False
        n = v[0] / gap, v[1] / gap
        far = min(n[0] * p[0] + n[1] * p[1] for p in edge)
        near = min(min(n[0] * p[0] + n[1] * p[1] for p in points) - radius - sum(self.loss(n, s) for s in slopes) / len(STAGES)
                   for points, radius, _, _, slopes in clouds)
        slack = 1e-14 * (abs(far) + abs(near) + max(abs(c) for p in edge for c in p)) + 4 * self.slip
        return far + near >= distance - EPS_MM + slack

    def refute(self, place, pair):
        """Perhaps at this place the two are nearer than they may be."""
        part, A, other, B, frame, node, distance = pair
        try:
            P, Q = (self.seen(place, frame, names) for names in (A, B))
        except Open:
            return
        gap = hypot(*apart(P, [cadd(p, e) for p in Q for e in node[0]]))
        if gap < distance - 2 * EPS_MM:
            raise Refuted(f"{part} and {other}: gap {gap - distance + self.task.clearance:.6g} mm with the tracer at "
                          f"({place[0]:.6g}, {place[1]:.6g}) from the pole; allowed {self.task.clearance:g}")

    def way(self, one, other, pairs):
        """Two polygons are joined if a way from corner to corner, straight or around the pole, is clear as well."""
        A, B = min(product(one[::1 + len(one) // 40], other[::1 + len(other) // 40]), key=lambda pq: math.dist(*pq))
        least, most = self.range[0].hi, self.range[1].lo
        start, turn, ways = math.atan2(A[1], A[0]), math.atan2(B[1], B[0]) - math.atan2(A[1], A[0]), [[A, B]]
        for r, t in product((0.5, 0.25, 0.75, 0.1, 0.9), (turn, turn - 2 * math.pi, turn + 2 * math.pi)):
            r, steps = least + r * (most - least), 2 + int(abs(t) / 0.02)
            bearings = [start + t * i / steps for i in range(steps + 1)]
            ways.append([A, *((r * math.cos(bearing), r * math.sin(bearing)) for bearing in bearings), B])
        for way in ways:
            try:
                for p, q in zip(way, way[1:]):
                    if hypot(*to_segment((0.0, 0.0), p, q)) < least - EPS_MM or max(hypot(*p), hypot(*q)) > most + EPS_MM:
                        raise Open
                    self.cover([[p, q]], pairs, None, self.pending_in)
                return
            except (Open, Refuted):
                continue
        raise Open("no way from polygon to polygon was found")

    def every_instrument(self):
        """Claim 5."""
        return f" (lengths within {self.length:g} mm, play {self.play:g} mm)" + self.clear(True)

    def limits(self):
        """What else the file limits."""
        task = self.task
        if task.sheets_gap is not None:
            self.sheets_apart(max(task.sheets_gap - EPS_MM, 1e-9))
        if task.copy_error is not None:
            if not (self.length or self.play):
                raise Open("limits.copy_error_mm without a tolerance")
            self.cover([self.cotangents], (), None, self.too_wrong_in)
        if any(self.file.get(key) is None for key in ("pole", "links", "objective", "cutting")):
            raise Open("not checked: pole, links, objective (not stated)")
        task.read_choice()
        for name, length in self.lengths.items():
            locked = task.locked.get(name, length)
            if not task.shortest - EPS_MM <= length <= task.longest + EPS_MM or abs(length - locked) > EPS_MM:
                raise Refuted(f"length {name} = {length} is not within {task.shortest:g} and {task.longest:g}, or not as locked")
            if name not in ("CX", "CY") and (task.grid and abs(math.remainder(length, task.grid)) > EPS_MM
                                             or task.stock and min(abs(length - s) for s in task.stock) > EPS_MM):
                raise Refuted(f"length {name} = {length} is not of the grid or the stock")
        if self.shape.vertex not in task.groundings or max(self.layers.values()) > task.layers:
            raise Refuted("this vertex or layer is not permitted")
        edges = [e for polygon in task.pole_within or [] for ring in polygon for e in zip(ring, ring[1:])]
        if not any(where(self.pole, p) >= 0 for p in task.pole_within or []):
            edges = edges or [(task.pole_at, task.pole_at)]
            if min(hypot(*to_segment(self.pole, *edge)) for edge in edges) > EPS_MM:
                raise Refuted("the pole stands elsewhere than permitted")

    def too_wrong_in(self, box, hull, pending):
        """None if the copy error keeps its limit all over a cell of cot d."""
        if self.exceeding(self.sources(I(box[0], box[1])), self.task.copy_error + EPS_MM) is None:
            return None
        if found := self.exceeding(self.sources(I(hull[0][0])), self.task.copy_error + 2 * EPS_MM):
            opening = math.degrees(math.atan2(self.sign_d, self.sign_d * hull[0][0]))
            raise Refuted(f"copy error {found:.6g} mm at the opening {opening:.6g} degrees; allowed {self.task.copy_error:g}")
        return pending

    def sources(self, x):
        """The pen's deviation by each length and by each coordinate of each pin, times a constant of length 1, from x = cot d
        (docs/tolerance.md: D). A flat plate's third hole is off at right angles to its line."""
        s, one, i = self.shape.s, (ONE, ZERO), (ZERO, ONE)
        t, y = csub(one, s), (x.square() + 1.0).sqrt() * self.sign_d  # 1 - s, 1 / sin d
        e, ix, iy = (x / y, ONE / y), (ZERO, x), (ZERO, y)

        def tip(u, v):  # how the tip moves by its plate's lengths; u, v: directions to it from the two others
            v = i if self.flat else tuple(c / square_of(v).sqrt() for c in v)
            u, c = tuple(c / square_of(u).sqrt() for c in u), u
            c = cmul(conj(u), v)[1]
            by_far = tuple(x / c for x in cmul(i, u))
            return tuple(x * v[0] for x in by_far), tuple(-x / c for x in cmul(i, v)), by_far

        xi, eta = tip(conj(s), cmul(t, conj(s))), tip(s, (-t[0], -t[1]))
        out = {"VA": cmul(t, csub(one, ix)), "VB": cmul(t, iy), "AC": csub(cmul(e, csub(one, cmul(s, xi[0]))), cmul(t, iy)),
               "BC": cadd(csub(eta[0], one), cmul(t, ix)), "AX": cmul(cmul(s, xi[1]), e), "CX": cmul(cmul(s, xi[2]), e),
               "BY": eta[1], "CY": eta[2], "Ax": cmul(t, csub(one, ix)), "Cx": csub(one, cmul(t, ix)), "Cy": csub(i, cmul(t, i))}
        out["Bx"], out["By"] = out["Vx"], out["Vy"] = cmul(t, ix), cmul(t, i)
        out.update({"Px": out["Ax"]} if self.shape.vertex == "pole" else {"Px": s, "Py": cmul(s, i)})
        factor = ONE / self.shape.abs_1s if self.shape.vertex == "pen" else ONE
        return {name: box_of([c * factor for c in way]) for name, way in out.items()}

    def exceeding(self, slopes, limit):
        """A deviation that may be above the limit; None if there is none. Between the directions u and v none is longer than what
        all can do along w = u + v, divided by the smaller of u.w and v.w."""
        todo = [((1.0, 0.0), (0.0, 1.0)), ((0.0, 1.0), (-1.0, 0.0))]
        while todo:
            u, v = todo.pop()
            w = cadd(u, v)
            most, size = self.loss(w, slopes), hypot(*w)
            if most > limit * size * (1 - 1e-12):
                return most / size
            if most > limit * min(u[0] * w[0] + u[1] * w[1], v[0] * w[0] + v[1] * w[1]) * (1 - 1e-12):
                m = w[0] / size, w[1] / size
                todo += [(u, m), (m, v)]
        return None

    def sheets_apart(self, gap):
        """No place of the region is nearer to a place of its copy: edges by trees of rectangles, then one inside the other."""
        copies = [[[centre(cmul(self.shape.k, self.near(p))) for p in ring] for ring in polygon] for polygon in self.region]
        slack = (16 * self.slip + 1e-13 * self.range[1].hi) * (1 + self.task.scale)
        todo = [tuple(tree_of([e for p in some for r in p for e in zip(r, r[1:])]) for some in (self.region, copies))]
        while todo:
            one, other = todo.pop()
            between = hypot(*apart(one[0], other[0]))
            if between < gap + slack:
                if not one[2] and not other[2]:
                    raise (Refuted if between < gap - EPS_MM - slack else Open)(f"original and copy are {between:.6g} mm apart")
                todo += [(c, other) for c in one[2]] if one[2] and one[1] >= other[1] else [(one, c) for c in other[2]]
        for some, others in ((self.region, copies), (copies, self.region)):
            if any(where(polygon[0][0], other) >= 0 for polygon in some for other in others):
                raise Refuted("original and copy overlap")


def cloud(still, moving, ways):
    """Places whose hull, grown by a radius, holds a joint over a cell; the radius; how far it moves; where it is in the middle."""
    slopes = [c.d or {} for c in moving]
    ends = [[still[i] + sum((slopes[i].get(v, ZERO) * x for v, x in way.items()), ZERO) for i in (0, 1)] for way in ways]
    points, middle = [centre(e) for e in ends], centre(still)
    radius = 0.5 * (1 + 1e-15) * max(hypot(*(nextafter(c.hi - c.lo, inf) for c in e)) for e in ends)
    return points, radius, max(math.dist(p, middle) for p in points), middle


def box_of(z):
    """Middles and half widths of a complex interval, in doubles, with more than their rounding."""
    return *centre(z), *(0.5 * (c.hi - c.lo) + 1e-15 * c.size() for c in z)


def slopes_of(way):
    return {v: box_of([c.d[v] if c.d and v in c.d else ZERO for c in way]) for v in both(way[0].d or {}, way[1].d or {})}


class Node:
    """Designs: ranges of a, b and the pole's x, y; cosines of the least and largest |psi|; layer assignments."""

    def __init__(self, box, window, assignments):
        self.box, self.window, self.assignments = box, window, assignments

    def corners(self, names):
        return product(*((self.box[v].lo, self.box[v].hi) for v in names))

    def middle(self):
        return {v: i.middle() for v, i in self.box.items()}


class Certificate:
    """Claims 3 and 4: a log is read line by line, and every line must close or divide the next node."""

    def __init__(self, name, lines):
        file = self.file = File(name, lines[0] if lines else None)
        file.get("format", ("kempe-certificate/1",))
        self.claim, self.objective = file.get("claim", ("bound", "none")), file.get("objective")
        self.bound = file.number("bound") if self.claim == "bound" else None
        task = File(name, file.get("task"))
        self.task, self.lines, self.at = Task(task, "", task.get("plate", ("bent", "triangle"))), lines, 0
        self.task.read_choice()

    def belongs_to(self, design):
        """The log speaks of the design's task, and proves what the design's file states."""
        mine, copy, mechanism = self.task.file.data, design.get("copy"), design.get("mechanism")
        tables = ("region", "pole", "links", "limits", "obstacles", "objective", "tolerance", "cutting")
        theirs = {key: design.get(key) for key in tables}
        theirs["copy"] = {key: copy.get("wanted_" + key, copy.get(key)) for key in ("scale", "rotation_deg")}
        theirs.update({key: mechanism.get(key) for key in ("link_width_mm", "pin_diameter_mm")})
        theirs["plate"] = mechanism["links"][2].get("shape")
        for key, value in theirs.items():
            if mine.get(key) != value:
                raise Open(f"the log's {key} is not the design's")
        if self.claim != "bound" or design.get("search.objective") != self.objective:
            raise Open("the log is about something else than the design's objective")
        value, stated = design.number("search.value"), design.optional("quality.lower_bound")
        over = 1 if self.objective == "size" else -1
        if over * value < over * self.bound - EPS_MM:
            raise Refuted(f"this design has {value}")
        if stated is not None and over * stated > over * self.bound + EPS_MM:
            raise Open(f"the file states {stated}")

    def prove(self):
        if self.claim == "bound" and self.objective not in ("size", "transmission"):
            raise Open(f"objective {self.objective} has no rules")
        for vertex in (v for v in VERTICES if v in self.task.groundings):
            self.shape = Shape(self.task, vertex)
            for mode in range(self.shape.modes):
                self.sign, todo = self.shape.signs(mode)[0], [self.root(mode)]
                while todo:
                    self.at += 1
                    try:
                        todo += reversed(self.step(todo.pop(), self.lines[self.at]))
                    except (KeyError, TypeError, ValueError, IndexError, AttributeError, ArithmeticError, Open) as fault:
                        raise Open(f"{vertex}, mode {mode}, line {self.at + 1}: {fault or 'nothing is decided'}") from None
        if self.at != len(self.lines) - 1:
            raise Open(f"line {self.at + 2}: all trees are closed")
        return f" ({self.at} nodes)"

    def root(self, mode):
        task, ranges = self.task, []
        for factors in (self.shape.of_a, self.shape.of_b):
            locked = [I(task.locked[name]) / factors[name] for name in factors if name in task.locked]
            lo = max([(I(task.shortest) / f).lo for f in factors.values()] + [l.lo for l in locked])
            ranges.append(I(lo, min([(I(task.longest) / f).hi for f in factors.values()] + [l.hi for l in locked])))
        poles = [task.pole_at] if task.pole_at else [c for polygon in task.pole_within for c in polygon[0]]
        ranges += [I(min(c), max(c)) for c in zip(*poles)]
        by_bound = self.bound if self.claim == "bound" and self.objective == "transmission" else 0.0
        every = [dict(zip(LINKS, layers)) for layers in product(range(1, task.layers + 1), repeat=4)]
        joined = [(one, other) for one, other in product(LINKS, LINKS) if one < other and not may_meet(one, other)]
        return Node(dict(zip("abxy", ranges)), self.shape.window(mode, max(task.transmission, by_bound)),
                    [l for l in every if all(l[one] != l[other] for one, other in joined)])

    def step(self, node, line):
        """The children of a node; none if its leaf refutes it."""
        for rule in ("split", "share", "contact"):
            if rule in line:
                return getattr(self, rule)(node, line)
        if not getattr(self, "leaf_" + line["leaf"])(node, line):
            raise Open(f"{line['leaf']} does not refute")
        return []

    def split(self, node, line):
        old, at = node.box[line["split"]], float(line["at"])
        if not old.lo < at < old.hi:
            raise Open(f"{at} does not split {old.lo} to {old.hi}")
        return [Node({**node.box, line["split"]: half}, node.window, node.assignments) for half in (I(old.lo, at), I(at, old.hi))]

    def share(self, node, line):
        one, other = line["share"]
        if one not in PARTS or other not in PARTS and not 0 <= other < len(self.task.obstacles):
            raise Open("unknown parts")
        together = [share(one, other, l, self.task.obstacles) for l in node.assignments]
        return [Node(node.box, node.window, [l for l, t in zip(node.assignments, together) if t == wanted])
                for wanted in (True, False)]

    def contact(self, node, line):
        u, (one, other) = I(float(line["u"])), line["contact"]
        if not 0 < u.lo < 1e9 or not all(share(one[0], other[0], l, ()) for l in node.assignments):
            raise Open("these parts need not keep apart")
        cosine, sine = (ONE - u.square()) / (u.square() + ONE), u * 2.0 / (u.square() + ONE) * self.sign
        allowed = I(self.task.half(one[0])) + self.task.half(other[0]) + self.task.clearance
        for a, b in node.corners("ab"):
            joints = {j: cadd(tuple(c * a for c in alpha), cmul(beta, (cosine * b, sine * b)))
                      for j, (alpha, beta) in self.shape.seen.items()}
            if not square_of(csub(self.material(one, joints), self.material(other, joints))).hi < allowed.square().lo:
                raise Open("the points are not in contact all over the box")
        return [Node(node.box, window, node.assignments) for window in ((node.window[0], cosine), (cosine, node.window[1]))]

    def material(self, point, joints):
        """A material point of a part, from its joints."""
        part, *t = point
        t, ends = [float(x) for x in t], joints_of(part)
        if part not in PARTS or len(t) != len(ends) - 1 or not all(x >= 0 for x in t) or not sum(t) <= 1:
            raise Open(f"{point} is no point of a part")
        if len(t) == 2 and self.task.plate == "bent" and 0 not in t:
            raise Open(f"{point} is not on the bent plate")
        at = joints[ends[0]]
        for x, joint in zip(t, ends[1:]):
            at = cadd(at, tuple(c * x for c in csub(joints[joint], joints[ends[0]])))
        return at

    def place(self, value):
        """A place of the region, as intervals."""
        if len(value) == 2:
            point = self.file.point("place", value)
            if not any(where(point, polygon) >= 0 for polygon in self.task.region):
                raise Open(f"{value} is not in the region")
            return I(point[0]), I(point[1])
        polygon, ring, corner, t = value
        if not (min(polygon, ring, corner) >= 0 and 0 <= t <= 1):
            raise Open(f"{value} is no place of the region")
        p, q = self.task.region[polygon][ring][corner:corner + 2]
        return tuple(I(p[i]) + (I(q[i]) - p[i]) * float(t) for i in (0, 1))

    def leaf_sum(self, node, line):
        """Q about the middle of the box: value, slopes g, squares q and the product m of a and b."""
        middle, shape, task = node.middle(), self.shape, self.task
        a, b, value, m = I(middle["a"]), I(middle["b"]), ZERO, ZERO
        g, q = dict.fromkeys("abxy", ZERO), dict.fromkeys("abxy", ZERO)
        for name, *places, weight in line["of"]:
            if not 0 <= weight < 1e9:
                raise Open("a weight is negative")
            weight, turn = I(float(weight)), {"far": -1.0, "near": 1.0, "posts": 1.0, "bound": 0.0}[name]
            if name == "bound":
                if self.claim != "bound" or self.objective != "size":
                    raise Open("there is no bound")
                value += weight * (self.bound - shape.size[0] * a - shape.size[1] * b)
                g["a"], g["b"] = g["a"] - weight * shape.size[0], g["b"] - weight * shape.size[1]
                continue
            away = tuple(t - middle[v] for t, v in zip(self.place(places[0]), "xy"))
            pole = weight * turn * (1.0 if name == "posts" else shape.abs_g.square())
            value += pole * square_of(away)
            for v, t in zip("xy", away):
                g[v], q[v] = g[v] - pole * t * 2.0, q[v] + pole
            if name == "posts":
                smallest = I(min(1.0, shape.abs_s.hi, shape.abs_1s.hi)) * shape.abs_g.hi
                value += -weight * ((I(task.pin) + task.clearance) / I(smallest.hi)).square()
                continue
            c, length = node.window[name == "near"], weight * -turn
            value += length * (a.square() + b.square() + a * b * c * 2.0)
            g["a"], g["b"] = g["a"] + length * (a + b * c) * 2.0, g["b"] + length * (b + a * c) * 2.0
            q["a"], q["b"], m = q["a"] + length, q["b"] + length, m + length * c * 2.0
        half = {v: I(max((I(i.hi) - middle[v]).hi, (middle[v] - I(i.lo)).hi)) for v, i in node.box.items()}
        most = value + I(m.size()) * half["a"] * half["b"]
        for v, h in half.items():
            slope, square = I(g[v].size()), I(q[v].hi)
            inside = square.hi < 0 and slope.hi < (square * h * -2.0).lo
            most += slope.square() / (square * -4.0) if inside else slope * h + square * h.square()
        return most.hi < 0

    def point_at(self, point, T, z):
        """P + alpha p + beta q/s, by (2), the point's constants less the pole's collected before a, b and P vary."""
        seen, pole = self.shape.seen, (z["x"], z["y"])
        still = seen["V" if self.shape.vertex == "pole" else "X"]
        alpha, beta = (csub(self.material(point, {j: c[i] for j, c in seen.items()}), still[i]) for i in (0, 1))
        w, aa, bb = cmul(self.shape.g, csub(T, pole)), z["a"].square(), z["b"].square()
        r = square_of(w)
        h = ((z["a"] * z["b"] * 2.0).square() - (r - aa - bb).square()).sqrt() * float(self.sign)
        zeta = (r + aa - bb) / (r * 2.0), -h / (r * 2.0)
        return cadd(pole, cmul(w, cadd(cmul(csub(alpha, beta), zeta), beta)))

    def leaf_lengths(self, node, line):
        return any(node.box[v].lo > node.box[v].hi for v in "ab")

    def leaf_layers(self, node, line):
        return not node.assignments

    def leaf_pole(self, node, line):
        """The box of poles holds no place of their area: no edge of it comes in, and it is not all inside."""
        (x0, x1), (y0, y1), corners = *((node.box[v].lo, node.box[v].hi) for v in "xy"), list(node.corners("xy"))
        for polygon in self.task.pole_within:
            for p, q in (edge for ring in polygon for edge in zip(ring, ring[1:])):
                beside = max(p[0], q[0]) < x0 or min(p[0], q[0]) > x1 or max(p[1], q[1]) < y0 or min(p[1], q[1]) > y1
                turns = [side(p, q, c) for c in corners]
                if not (beside or min(turns) > 0 or max(turns) < 0):
                    return False
            if where(corners[0], polygon) >= 0:
                return False
        return True

    def leaf_sheets(self, node, line):
        one, other = (self.place(p) for p in line["places"])
        poles = [(I(x), I(y)) for x, y in node.corners("xy")]
        ways = [csub(cadd(P, cmul(self.shape.k, csub(one, P))), other) for P in poles]
        return max(square_of(way).hi for way in ways) < I(self.task.sheets_gap).square().lo

    def leaf_obstacle(self, node, line):
        """A part's point stays, over the box, within reach of a convex piece of an obstacle."""
        index, point, edge = line["obstacle"], line["point"], line["edge"]
        if not all(share(point[0], index, l, self.task.obstacles) for l in node.assignments) or index < 0:
            raise Open("the part does not meet this obstacle")
        ring, *holes = self.task.obstacles[index]["rings"]
        if edge is None and (holes or not convex(ring)) or edge is not None and not 0 <= edge < len(ring) - 1:
            raise Open("the obstacle is not convex, or has no such edge")
        K, T = ring[:-1] if edge is None else ring[edge:edge + 2], self.place(line["place"])
        names = [v for v in "abxy" if node.box[v].lo < node.box[v].hi]
        middle = {v: I(m) for v, m in node.middle().items()}
        wide = {v: I(i.lo, i.hi, {v: ONE} if v in names else None) for v, i in node.box.items()}
        moving, still = (self.point_at(point, T, z) for z in (wide, middle))
        ways = [{v: c - middle[v] for v, c in zip(names, corner)} for corner in node.corners(names)]
        points, radius, _, _ = cloud(still, moving, ways)
        allowed = (self.task.half(point[0]) + self.task.clearance) * (1 - 1e-15)
        return all(hypot(*apart([p], K)) + radius + 1e-14 * max(abs(c) for c in p) < allowed for p in points)


def after_claim_1():
    raise Open("claim 1 comes first")


def claim(name, proof):
    """Prints one claim's line; True if it is proven."""
    try:
        print(f"{name}: proven{proof() or ''}")
        return True
    except Refuted as reason:
        print(f"{name}: refuted: {reason}")
    except (Open, ArithmeticError) as reason:
        print(f"{name}: not proven{': ' + str(reason) if str(reason) else ''}")
    return False


def read(name):
    """The objects of a JSON or JSON lines file."""
    def refuse(word):
        raise ValueError(word)
    try:
        with open(name, encoding="utf-8") as file:
            text = file.read()
        return [json.loads(part, parse_constant=refuse) for part in (text.splitlines() if name.endswith(".jsonl") else [text])]
    except OSError as fault:
        raise Unreadable(f"{name}: found {fault.strerror}; allowed: a file that can be read")
    except (ValueError, RecursionError) as fault:
        raise Unreadable(f"{name}: found {str(fault)[:80]}; allowed: JSON")


def main(names):
    if len(names) not in (1, 2):
        raise Unreadable(__doc__)
    files, good = [read(name) for name in names], True
    design = None if names[0].endswith(".jsonl") else File(names[0], files.pop(0)[0])
    try:
        checked, logs = design and Design(design), [Certificate(names[-1], lines) for lines in files]
    except (AttributeError, TypeError, KeyError, IndexError, OverflowError, Open) as fault:
        raise Unreadable(f"{', '.join(names)}: found {fault}; allowed: a table as docs/design-file.md or docs/proof.md has it")
    if checked:
        good = claim("1 every point is reached on one assembly mode", checked.reached)
        claims = [("2 the parts keep their clearance", checked.clear), ("limits of the file", checked.limits)]
        if checked.robust:
            claims.append(("5 every instrument within the tolerances is on one assembly and clear", checked.every_instrument))
        for title, proof in claims:
            good = claim(title, proof if hasattr(checked, "range") else after_claim_1) and good
        print("not looked at:", ", ".join(sorted(design.data.keys() - set(LOOKED_AT))))
    for log in logs:
        word = {"size": "mm is smaller", "transmission": "degrees is larger"}.get(log.objective, "is better")
        title = "4 no design exists" if log.claim == "none" else f"3 no design than {log.bound:.12g} {word}"
        good = claim(title, lambda: (design and log.belongs_to(design)) or log.prove()) and good
    return good


if __name__ == "__main__":
    try:
        sys.exit(0 if main(sys.argv[1:]) else 1)
    except Unreadable as message:
        print(message, file=sys.stderr)
        sys.exit(2)
