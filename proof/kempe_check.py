#!/usr/bin/env python3
"""Checks a design of Kempe from its files alone; shares no code with Kempe. The theorems stand in docs/proof.md.

usage: kempe_check.py design.json [certificate.jsonl]
       kempe_check.py certificate.jsonl

A line a claim: proven, not proven or refuted. Exit code 0: all claims are proven; 1: one is not; 2: a file cannot be read.

eps:      claims 1 and 2 and the limits forgive 1e-6 mm and 1e-6 degrees; claims 3 and 4 forgive nothing.
Assumes:  + - * / and sqrt of doubles are rounded correctly (IEEE 754); the numbers of the files are the doubles nearest
          to them; rings are simple, and holes lie inside their polygon.
"""
import json
import math
import sys
from fractions import Fraction
from itertools import product
from math import inf, nextafter

EPS_MM, EPS_DEG = 1e-6, 1e-6
MOST_CELLS = 400_000  # of one search; then the answer is "not proven"
LINKS = ("VA", "VB", "ACX", "BCY")
PINS = {"A": ("VA", "ACX"), "B": ("VB", "BCY"), "C": ("ACX", "BCY"), "V": ("VA", "VB")}
POSTS = {"V": ("VA", "VB"), "X": ("ACX",), "Y": ("BCY",)}
ROLES = {"pole": ("V", "X"), "tracer": ("X", "V"), "pen": ("X", "Y")}  # vertex: pole, tracer


class Unreadable(Exception):
    """A file that says nothing definite: file, key, what was found, what is allowed."""


class Open(Exception):
    """Interval arithmetic decides nothing here."""


class Refuted(Exception):
    """A claim that is false, with the reason."""


# ---------------------------------------------------------------------------------------------- intervals


class I:
    """An interval that contains the exact value: every result is moved outwards by one step."""
    __slots__ = ("lo", "hi")

    def __init__(self, lo, hi=None):
        self.lo, self.hi = lo, lo if hi is None else hi

    def __add__(self, o):
        if o.__class__ is not I:
            if o.__class__ is Jet:
                return o + self
            o = I(o)
        if not (o.lo or o.hi):
            return self
        if not (self.lo or self.hi):
            return o
        return I(nextafter(self.lo + o.lo, -inf), nextafter(self.hi + o.hi, inf))

    def __neg__(self):
        return I(-self.hi, -self.lo)

    def __sub__(self, o):
        return self + (-o)

    def __mul__(self, o):
        if o.__class__ is not I:
            if o.__class__ is Jet:
                return o * self
            o = I(o)
        a, b, c, d = self.lo, self.hi, o.lo, o.hi
        if not (a or b) or not (c or d):
            return ZERO
        products = (a * c, a * d, b * c, b * d)
        lo, hi = min(products), max(products)
        if not (lo > -1e150 and hi < 1e150):  # no infinity comes up, and so no NaN
            raise Open
        return I(nextafter(lo, -inf), nextafter(hi, inf))

    def __truediv__(self, o):
        if o.__class__ is not I:
            o = I(o)
        if not (o.lo > 1e-140 or o.hi < -1e-140):
            raise Open
        return self * I(nextafter(1 / o.hi, -inf), nextafter(1 / o.lo, inf))

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, o):
        return I(o) - self

    def sqrt(self):
        if not self.lo >= 0:
            raise Open
        return I(max(0.0, nextafter(math.sqrt(self.lo), -inf)), nextafter(math.sqrt(self.hi), inf))

    def square(self):
        size = (abs(self.lo), abs(self.hi))
        low = 0.0 if self.lo <= 0 <= self.hi else min(size)
        return I(max(0.0, nextafter(low * low, -inf)), nextafter(max(size) ** 2, inf))

    def size(self):
        return max(abs(self.lo), abs(self.hi))

    def middle(self):
        return 0.5 * self.lo + 0.5 * self.hi


ZERO = I(0.0)


class Jet:
    """A value with its derivatives by some variables, all intervals."""
    __slots__ = ("v", "d")

    def __init__(self, v, d):
        self.v, self.d = v, d

    def __add__(self, o):
        if o.__class__ is not Jet:
            return Jet(self.v + o, self.d)
        return Jet(self.v + o.v, [x + y for x, y in zip(self.d, o.d)])

    def __neg__(self):
        return Jet(-self.v, [-x for x in self.d])

    def __sub__(self, o):
        return self + (-o)

    def __mul__(self, o):
        if o.__class__ is not Jet:
            return Jet(self.v * o, [x * o for x in self.d])
        return Jet(self.v * o.v, [x * o.v + self.v * y for x, y in zip(self.d, o.d)])

    def __truediv__(self, o):
        q = self.v / o.v
        return Jet(q, [(x - q * y) / o.v for x, y in zip(self.d, o.d)])

    __radd__, __rmul__ = __add__, __mul__

    def sqrt(self):
        root = self.v.sqrt()
        return Jet(root, [x / (root * 2.0) for x in self.d])

    def square(self):
        return Jet(self.v.square(), [x * self.v * 2.0 for x in self.d])


def cmul(a, b):
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def cadd(a, b):
    return a[0] + b[0], a[1] + b[1]


def csub(a, b):
    return a[0] - b[0], a[1] - b[1]


def cabs(a):
    return (a[0].square() + a[1].square()).sqrt()


def dot(n, a):
    return a[0] * n[0] + a[1] * n[1]


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
    c, s = (I(nextafter(t / one, -inf), nextafter(t / one, inf)) if rest else I(float(t >> 160)) for t in sums)
    return [(c, s), (-s, c), (-c, -s), (s, -c)][int(quarters)]


# ------------------------------------------------------------------------------------------ plane geometry (doubles)


def side(p, q, r):
    """The sign of the turn p-q-r, exact."""
    left, right = (q[0] - p[0]) * (r[1] - p[1]), (q[1] - p[1]) * (r[0] - p[0])
    if abs(left - right) > 1e-14 * (abs(left) + abs(right)) + 1e-290:
        return left - right
    p, q, r = ([Fraction(c) for c in point] for point in (p, q, r))
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def where(point, rings):
    """1 inside, 0 on an edge, -1 outside, by the even-odd rule; exact."""
    inside = -1
    for ring in rings:
        for p, q in zip(ring, ring[1:]):
            if (p[1] > point[1]) != (q[1] > point[1]) or p[1] == point[1] or q[1] == point[1]:
                turn = side(p, q, point)
                if turn == 0 and min(p[0], q[0]) <= point[0] <= max(p[0], q[0]) and min(p[1], q[1]) <= point[1] <= max(p[1], q[1]):
                    return 0
                if (p[1] > point[1]) != (q[1] > point[1]) and (turn > 0) == (q[1] > p[1]):
                    inside = -inside
    return inside


def to_segment(p, a, b):
    """From p to the nearest point of the segment a-b."""
    ax, ay, dx, dy = a[0] - p[0], a[1] - p[1], b[0] - a[0], b[1] - a[1]
    length = dx * dx + dy * dy
    t = min(1.0, max(0.0, -(ax * dx + ay * dy) / length)) if length else 0.0
    return ax + t * dx, ay + t * dy


def apart(A, B):
    """A vector from the nearest point of convex A (one to three corners) to convex B (corners in order); None if they meet.
    Only a guess of a direction: what it proves is computed anew."""
    best, least = None, inf
    for P, Q, turn in ((A, B, 1), (B, A, -1)):
        for p in P:
            for i in range(len(Q) if len(Q) > 2 else 1):
                v = to_segment(p, Q[i], Q[(i + 1) % len(Q)])
                size = v[0] * v[0] + v[1] * v[1]
                if size < least:
                    best, least = (turn * v[0], turn * v[1]), size
    if len(A) > 1 and len(B) > 1 and (any(crosses(A[i], A[i - 1], B[j], B[j - 1]) for i in range(len(A)) for j in range(len(B)))):
        return None
    if any(len(Q) > 2 and inside_convex(P[0], Q) for P, Q in ((A, B), (B, A))):
        return None
    return best


def crosses(a, b, c, d):
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def inside_convex(p, ring):
    turns = [side(ring[i - 1], ring[i], p) for i in range(len(ring))]
    return all(t > 0 for t in turns) or all(t < 0 for t in turns)


def size_of(v):
    return math.hypot(v[0], v[1])


def clip(ring, axis, at, keep):
    """The part of a closed polygon (last corner not repeated) on one side of a line; corners on the line are exact."""
    out = []
    for p, q in zip(ring, ring[1:] + ring[:1]):
        u, v = keep * (p[axis] - at), keep * (q[axis] - at)
        if u >= 0:
            out.append(p)
        if u * v < 0 or (u < 0 < v) or (v < 0 < u):
            t = u / (u - v)
            cut = [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]
            cut[axis] = at
            out.append(tuple(cut))
    return out


def tree_of(edges):
    """Edges under rectangles: (rectangle's corners, size, children or None)."""
    if len(edges) == 1:
        return (list(edges[0]), 0.0, None)
    xs, ys = [p[0] for e in edges for p in e], [p[1] for e in edges for p in e]
    x0, x1, y0, y1 = min(xs), max(xs), min(ys), max(ys)
    half = len(edges) // 2
    return ([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], math.hypot(x1 - x0, y1 - y0),
            (tree_of(edges[:half]), tree_of(edges[half:])))


# ------------------------------------------------------------------------------------------------ the linkage


class Shape:
    """What ratio and vertex fix: s, g, the factors of the lengths, and the modes."""

    def __init__(self, scale, degrees, vertex):
        turn = unit_circle(degrees)
        k = self.k = (turn[0] * I(scale), turn[1] * I(scale))
        one, squared = (I(1.0), ZERO), k[0].square() + k[1].square()
        inverse = (k[0] / squared, -k[1] / squared)
        self.vertex = vertex
        self.s = {"pole": k, "tracer": csub(one, k), "pen": csub(one, inverse)}[vertex]
        self.g = {"pole": one, "tracer": (I(-1.0), ZERO), "pen": (-k[0], -k[1])}[vertex]
        self.abs_s, self.abs_1s, self.abs_g = cabs(self.s), cabs(csub(one, self.s)), cabs(self.g)
        self.straight = not (k[1].lo or k[1].hi)
        if not (self.straight or k[1].lo > 0 or k[1].hi < 0) or self.abs_s.lo <= 0:
            raise Open
        half = (self.abs_s + self.abs_1s + 1.0) * I(0.5)
        self.size = (half + 1.0, half + self.abs_s)  # of a and of b
        self.of_a = {"VA": I(1.0), "BC": I(1.0), "BY": self.abs_s, "CY": self.abs_1s}
        self.of_b = {"VB": self.abs_s, "AC": self.abs_s, "AX": I(1.0), "CX": self.abs_1s}

    def modes(self):
        return 2 if self.straight else 4

    def sign_of_sin_d(self, mode):
        return -1 if mode < self.modes() // 2 else 1

    def sign_of_psi(self, mode):
        """Of sin psi: sin d at the change point changes sign there, sin psi at the dead point; modes lie between them."""
        if self.straight:
            return self.sign_of_sin_d(mode) * (1 if self.s[0].lo > 0 else -1)
        return (1 if mode % 2 else -1) * (1 if mode > 1 else -1) * (1 if self.s[1].lo > 0 else -1)

    def window(self, mode, degrees):
        """Cosines of the least and the largest |psi| with the transmission angle asked for."""
        c, s = unit_circle(degrees)
        if self.straight:
            return c, -c
        sign = 1.0 if self.s[1].lo > 0 else -1.0
        # The change point in this half turn: psi = -arg s modulo pi.
        cc, cs = self.s[0] * (-sign * self.sign_of_psi(mode)) / self.abs_s, self.s[1] * sign / self.abs_s
        return (c, cc * c + cs * s) if self.near_zero(mode) else (cc * c - cs * s, -c)

    def near_zero(self, mode):
        """True if |psi| begins at 0 in this mode: where d is arg s itself, not half a turn away from it."""
        return mode in ((2, 3) if self.s[1].lo > 0 else (0, 1))

    def joints(self, pole, z, a, b, sign):
        """All joints with the tracer at pole + z, by (2)."""
        w = cmul(self.g, z)
        r = w[0].square() + w[1].square()
        aa, bb, ab = a.square(), b.square(), a * b * 2.0
        h = (ab.square() - (r - aa - bb).square()).sqrt() * float(sign)
        m = (r + aa - bb, -h)
        p = tuple(c / (r * 2.0) for c in cmul(w, m))
        q = cmul(self.s, csub(w, p))
        V = pole if self.vertex == "pole" else csub(pole, w)
        A, B, X = cadd(V, p), cadd(V, q), cadd(V, w)
        return {"V": V, "A": A, "B": B, "C": cadd(A, q), "X": X, "Y": cadd(V, cmul(self.s, w))}

    def seen(self, joint):
        """(alpha, beta) of joint - V = alpha p + beta q/s."""
        one, zero = (I(1.0), ZERO), (ZERO, ZERO)
        return {"V": (zero, zero), "A": (one, zero), "B": (zero, self.s), "C": (one, self.s), "X": (one, one), "Y": (self.s, self.s)}[joint]


# ------------------------------------------------------------------------------------------------- the parts


def occupied(part, layers):
    """The layers that a part fills, given those of the links."""
    kind, _, joint = part.partition(" ")
    if kind == "pin":
        low, high = sorted(layers[link] for link in PINS[joint])
        return set(range(low + 1, high))
    if kind == "post":
        return set(range(1, min(layers[link] for link in POSTS[joint])))
    return {layers[part]}


PARTS = LINKS + tuple("pin " + j for j in PINS) + tuple("post " + j for j in POSTS)


def joints_of(part):
    return set(part) if part in LINKS else {part[-1]}


def pieces(part, plate):
    """Convex pieces of a part's axis, by joints."""
    if part in ("ACX", "BCY"):
        return [tuple(part)] if plate == "triangle" else [(part[0], part[1]), (part[0], part[2])]
    return [tuple(part)] if part in LINKS else [(part[-1],)]


def may_meet(one, other):
    return not joints_of(one) & joints_of(other)


def share(one, other, layers, obstacles):
    mine = occupied(one, layers)
    if isinstance(other, str):
        return bool(mine & occupied(other, layers))
    low, high = obstacles[other]["layers"]
    return any(low <= layer <= high for layer in mine)


# ---------------------------------------------------------------------------------------------- the files


class File:
    """Numbers and tables of a JSON object; whatever is not as allowed is refused with its key."""

    def __init__(self, name, data):
        self.name, self.data = name, data

    def fault(self, key, found, allowed):
        raise Unreadable(f"{self.name}: {key}: found {str(found)[:60]}; allowed: {allowed}")

    def get(self, path, allowed="present"):
        at = self.data
        for key in path.split("."):
            if not isinstance(at, dict) or key not in at:
                self.fault(path, "nothing", allowed)
            at = at[key]
        return at

    def number(self, path, low=-1e9, high=1e9, value=inf):
        value = self.get(path, "a number") if value is inf else value
        if type(value) not in (int, float) or not low <= value <= high:
            self.fault(path, value, f"a number from {low} to {high}")
        return float(value)

    def optional(self, path, low=0.0, high=1e9):
        table, _, key = path.rpartition(".")
        table = self.get(table) if table else self.data
        return None if table is None or table.get(key) is None else self.number(path, low, high)

    def whole(self, path, value, low, high):
        if type(value) is not int or not low <= value <= high:
            self.fault(path, value, f"a whole number from {low} to {high}")
        return value

    def point(self, path, value):
        if not isinstance(value, list) or len(value) != 2:
            self.fault(path, value, "[x, y]")
        return self.number(path, -2e7, 2e7, value[0]), self.number(path, -2e7, 2e7, value[1])

    def polygons(self, path, value=None):
        value = self.get(path) if value is None else value
        found = value.get("coordinates") if isinstance(value, dict) and value.get("type") == "MultiPolygon" else None
        if not isinstance(found, list) or not all(isinstance(p, list) and p and all(isinstance(r, list) for r in p) for p in found):
            self.fault(path, value, "a MultiPolygon")
        polygons = [[[self.point(path, c) for c in ring] for ring in polygon] for polygon in found]
        for polygon in polygons:
            for ring in polygon:
                if len(ring) < 4 or ring[0] != ring[-1]:
                    self.fault(path, ring, "closed rings of three corners and more")
            if any(where(c, polygon[:1]) < 0 for hole in polygon[1:] for c in hole):
                self.fault(path, "a hole outside its polygon", "holes inside")
        return polygons


class Task:
    """What was asked for, from the tables that design.json and a log have in common."""

    def __init__(self, file, scale, degrees, width, pin, plate):
        self.file, self.scale, self.degrees, self.plate = file, scale, degrees, plate
        self.width, self.pin = width, pin
        self.region = file.polygons("region")
        self.clearance = file.number("limits.clearance_mm", 0)
        self.transmission = file.number("limits.transmission_deg", 0, 90)
        self.sheets_gap = file.optional("limits.sheets_gap_mm")
        self.copy_error = file.optional("limits.copy_error_mm")
        self.obstacles = []
        listed = file.get("obstacles")
        for i, o in enumerate(listed if isinstance(listed, list) else file.fault("obstacles", listed, "a list")):
            part = File(file.name, o)
            rings = part.polygons("shape")
            layers = part.get("layers")
            if not isinstance(layers, list) or len(layers) != 2 or len(rings) != 1:
                file.fault(f"obstacles[{i}]", o, "a shape of one polygon and layers [lowest, highest]")
            layers = [file.whole(f"obstacles[{i}].layers", n, 1, 64) for n in layers]
            self.obstacles.append({"rings": rings[0], "layers": layers, "name": str(o.get("name", i))})

    def half(self, part):
        return 0.5 * (self.width if part in LINKS else self.pin)

    def read_choice(self):
        """What limits the choice of a design: lengths, layers, groundings, the pole's place."""
        file = self.file
        self.layers = file.whole("links.layers", file.get("links.layers"), 1, 8)
        hole = self.pin + max(0.0, file.number("cutting.hole_fit_mm", -10, 10))
        self.shortest = I(file.number("links.shortest_mm", 0))
        self.apart = I(hole) + file.number("links.wall_mm", 0) if file.data["links"].get("wall_mm") is not None else I(0.0)
        self.longest = file.number("links.longest_mm", 0)
        self.locked = {n: v for n in ("VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY") if (v := file.optional(f"links.{n}_mm"))}
        self.groundings = file.get("objective.groundings")
        pole = file.get("pole")
        if not isinstance(pole, dict) or len(pole) != 1 or not pole.keys() <= {"at_mm", "within_mm"}:
            file.fault("pole", pole, "at_mm or within_mm")
        self.pole_at = file.point("pole.at_mm", pole["at_mm"]) if "at_mm" in pole else None
        self.pole_within = None if self.pole_at else file.polygons("pole.within_mm")
        if not isinstance(self.groundings, list) or not all(g in ROLES for g in self.groundings):
            file.fault("objective.groundings", self.groundings, "a list of pole, tracer, pen")


# --------------------------------------------------------------------------------- claims 1 and 2: a design


class Design:
    def __init__(self, file):
        self.file = file
        if file.get("format") != "kempe-design/1":
            file.fault("format", file.get("format"), "kempe-design/1")
        number = file.number
        links = file.get("mechanism.links")
        if not isinstance(links, list) or [l.get("name") for l in links if isinstance(l, dict)] != list(LINKS):
            file.fault("mechanism.links", links, "the links VA, VB, ACX, BCY")
        plates = {l.get("shape") for l in links[2:]}
        if not plates <= {"bent", "triangle"} or len(plates) != 1:
            file.fault("mechanism.links", plates, "plates that are both bent or both triangle")
        self.layers = {l["name"]: file.whole("mechanism.links.layer", l.get("layer"), 1, 64) for l in links}
        self.task = Task(file, number("copy.scale", 1e-6), number("copy.rotation_deg", -3600, 3600),
                         number("mechanism.link_width_mm", 0), number("mechanism.pin_diameter_mm", 0), plates.pop())
        vertex = file.get("mechanism.vertex")
        if vertex not in ROLES:
            file.fault("mechanism.vertex", vertex, "pole, tracer or pen")
        self.shape = Shape(self.task.scale, self.task.degrees, vertex)
        self.mode = file.whole("mechanism.assembly", file.get("mechanism.assembly"), 0, self.shape.modes() - 1)
        self.pole = file.point("mechanism.pole_position_mm", file.get("mechanism.pole_position_mm"))
        self.lengths = {n: number(f"mechanism.lengths_mm.{n}", 1e-6) for n in ("VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY")}
        self.a, self.b = I(self.lengths["VA"]), I(self.lengths["VB"]) / self.shape.abs_s
        self.sign = self.shape.sign_of_psi(self.mode)
        # Places are taken from the pole; a double so far from it may be off by `slip`.
        largest = max(abs(c) for p in self.task.region + [o["rings"] for o in self.task.obstacles] + [[[self.pole]]]
                      for ring in p for corner in ring for c in corner)
        self.slip = 2.0 ** -50 * largest
        self.region = [[[self.local(c) for c in ring] for ring in polygon] for polygon in self.task.region]

    def local(self, point):
        return point[0] - self.pole[0], point[1] - self.pole[1]

    def near(self, point):
        """A place as intervals that hold the exact one."""
        return tuple(I(c - self.slip, c + self.slip) for c in point)

    # Claim 1

    def lengths_agree(self):
        """The eight lengths are those of one linkage of this ratio."""
        for factors, unit in ((self.shape.of_a, self.a), (self.shape.of_b, self.b)):
            for name, factor in factors.items():
                off = (factor * unit - self.lengths[name]).size()
                if off > EPS_MM:
                    raise Refuted(f"length {name} = {self.lengths[name]} is off by {off:.3g} mm")

    def distances(self):
        """Enclosures of the least and the largest squared distance of the region from the pole."""
        if not self.region:
            raise Refuted("the file has no region")
        least, most = I(inf), I(0.0)
        for polygon, exact in zip(self.region, self.task.region):
            if where(self.pole, exact) >= 0:
                raise Refuted("the pole stands in the region, where the tracer cannot go")
            for ring in polygon:
                corners = [self.near(c) for c in ring]
                squares = [c[0].square() + c[1].square() for c in corners]
                for p, q, pp, qq in zip(corners, corners[1:], squares, squares[1:]):
                    way = csub(q, p)
                    along = -(p[0] * way[0] + p[1] * way[1])
                    length = way[0].square() + way[1].square()
                    ends = I(min(pp.lo, qq.lo), min(pp.hi, qq.hi))
                    if along.hi > 0 and along.lo < length.hi and length.lo > 0:
                        foot = (p[0] * way[1] - p[1] * way[0]).square() / length
                        ends = I(min(foot.lo, ends.lo), ends.hi if along.lo < 0 or along.hi > length.lo else min(foot.hi, ends.hi))
                    least = I(min(least.lo, ends.lo), min(least.hi, ends.hi))
                    most = I(max(most.lo, pp.lo), max(most.hi, pp.hi))
        return least, most

    def cosine(self, square):
        """Of psi, by (1), at a squared distance from the pole."""
        a2, b2 = self.a.square(), self.b.square()
        return (square * self.shape.abs_g.square() - a2 - b2) / (self.a * self.b * 2.0)

    def reached(self):
        """Claim 1 but for the connection of several polygons. Sets the range of cos psi over the region."""
        self.lengths_agree()
        self.range = least, most = self.distances()
        sine = unit_circle(max(0.0, self.task.transmission - EPS_DEG))[1]
        s = self.shape.s
        cosines = []
        for what, square in (("nearest", least), ("farthest", most)):
            c = self.cosine(square)
            if c.lo > 1 or c.hi < -1:
                raise Refuted(f"the {what} place, {math.sqrt(square.middle()):.6g} mm from the pole, is out of reach")
            sin_psi = ((1.0 - c) * (c + 1.0)).sqrt()
            sin_d = (s[0] * sin_psi * float(self.sign) + s[1] * c) / self.shape.abs_s * float(self.shape.sign_of_sin_d(self.mode))
            for word, x in (("dead", sin_psi), ("change", sin_d)):
                if x.hi < sine.lo or x.hi <= 0:
                    raise Refuted(f"at the {what} place the {word} point is {math.degrees(math.asin(max(-1, x.hi))):.6g} degrees away")
                if not (x.lo >= sine.hi and x.lo > 0):
                    raise Open
            cosines.append(c)
        self.cosines = I(cosines[0].lo, cosines[1].hi)

    # Claim 2: the linkage and itself

    def clear_of_itself(self):
        task, layers = self.task, self.layers
        for name, joint in (("VA", "V"), ("ACX", "A"), ("BCY", "B"), ("ACX", "C")):
            others = [l for l in LINKS if joint in l and l != name]
            if any(layers[l] == layers[name] for l in others):
                raise Refuted(f"links that share joint {joint} lie in one layer")
        for i, one in enumerate(PARTS):
            for other in PARTS[:i]:
                posts = one.startswith("post") and other.startswith("post")
                if may_meet(one, other) and (posts or share(one, other, layers, task.obstacles)):
                    for A, B in product(pieces(other, task.plate), pieces(one, task.plate)):
                        self.pair_is_clear(other, A, one, B, task.half(one) + task.half(other) + task.clearance)

    def pair_is_clear(self, one, A, other, B, distance):
        """Intervals of cos psi, halved until one direction separates the two all over each."""
        along_q = {"VB", "ACX"} & {one, other}  # seen from q the two do not turn
        a, b, seen = self.a, self.b, self.shape.seen
        fixed, moving = ((1, b), (0, a)) if along_q else ((0, a), (1, b))
        still = [[tuple(c * fixed[1] for c in seen(j)[fixed[0]]) for j in piece] for piece in (A, B)]
        drift = tuple(c * moving[1] for c in csub(seen(B[0])[moving[0]], seen(A[0])[moving[0]]))
        turn = -self.sign if along_q else self.sign
        rough = [[(c[0].middle(), c[1].middle()) for c in piece] for piece in still]
        todo, cells = [self.cosines], 0
        while todo:
            x = todo.pop()
            cells += 1
            m = x.middle()
            at = I(m), ((1.0 - I(m)) * (1.0 + I(m))).sqrt() * float(turn)
            y = ((1.0 - x) * (1.0 + x)).sqrt() * float(turn)
            shift = cmul(drift, at)
            moved = [(p[0] + shift[0].middle(), p[1] + shift[1].middle()) for p in rough[1]]
            v = apart(rough[0], moved)
            gap = size_of(v) if v else 0.0
            if gap < distance - 2 * EPS_MM:
                raise Refuted(f"{one} and {other}: gap {gap - distance + self.task.clearance:.6g} mm at cos psi = {m:.9g}; allowed "
                              f"{self.task.clearance:g}")
            n = v[0] / gap, v[1] / gap
            # n . (drift e^(i psi)) = f cos psi + e sin psi
            f, e = dot(n, drift), drift[0] * n[1] - drift[1] * n[0]
            slope = f - e * x / y
            swing = f * at[0] + e * at[1] + slope * (x - m)
            near = min(dot(n, p).lo for p in still[1]) - max(dot(n, p).hi for p in still[0])
            if not nextafter(nextafter(near, -inf) + swing.lo, -inf) >= (distance - EPS_MM) * (1 + 1e-15):
                if not x.lo < m < x.hi or cells > MOST_CELLS:
                    raise Open
                todo += [I(x.lo, m), I(m, x.hi)]

    # Claim 2: obstacles, by place

    def clear_of_obstacles(self):
        pairs = self.obstacle_pairs()
        if not pairs:
            return
        self.inside_no_obstacle(pairs)
        for rings, exact in zip(self.region, self.task.region):
            convex = len(rings) == 1 and inside_convex_ring(rings[0])
            self.cover([ring[:-1] for ring in rings], pairs, None if convex else exact)
        if len(self.region) > 1:
            for i in range(1, len(self.region)):
                self.way(self.region[0][0], self.region[i][0], pairs)

    def obstacle_pairs(self):
        """Every piece of a part with the tree of edges of every obstacle in its layers."""
        pairs, task = [], self.task
        for i, obstacle in enumerate(task.obstacles):
            trees = [tree_of(list(zip(local, local[1:]))) for ring in obstacle["rings"] for local in [[self.local(c) for c in ring]]]
            for part in PARTS:
                if share(part, i, self.layers, task.obstacles):
                    pairs += [(part, piece, tree, i) for piece in pieces(part, task.plate) for tree in trees]
        return pairs

    def inside_no_obstacle(self, pairs):
        """A part that meets no edge on its way is inside an obstacle always or never: one place decides."""
        place = self.region[0][0][0]
        joints = self.place_of_joints(tuple(I(c) for c in place))
        for part, piece, _, i in pairs:
            point = tuple(c.middle() for c in joints[piece[0]])
            if where(point, [[self.local(c) for c in ring] for ring in self.task.obstacles[i]["rings"]]) > 0:
                raise Refuted(f"{part} is inside {self.task.obstacles[i]['name']}")

    def place_of_joints(self, z):
        return self.shape.joints((ZERO, ZERO), z, self.a, self.b, self.sign)

    def cover(self, rings, pairs, exact):
        """Cells of a polygon, halved until all pairs are proven apart in each. `exact`: the polygon, if it is not convex."""
        xs, ys = [c[0] for c in rings[0]], [c[1] for c in rings[0]]
        todo, cells = [((min(xs), max(xs), min(ys), max(ys)), rings, pairs)], 0
        while todo:
            box, parts, pending = todo.pop()
            hull = self.hull_of(box, parts, exact)
            if not hull:
                continue
            cells += 1
            left = self.pending_in(box, hull, pending)
            if left:
                axis = 0 if box[1] - box[0] >= box[3] - box[2] else 1
                low, high = box[2 * axis], box[2 * axis + 1]
                m = 0.5 * low + 0.5 * high
                if not low < m < high or high - low < 1e-8 or cells > MOST_CELLS:
                    raise Open
                for half, keep in (((low, m), -1), ((m, high), 1)):
                    child = (*half, *box[2:]) if axis == 0 else (*box[:2], *half)
                    todo.append((child, [clip(r, axis, m, keep) for r in parts], left))

    def hull_of(self, box, parts, exact):
        """Places whose convex hull holds the region's part in a box. A corner of the box counts only if it is in the region."""
        points = {c for part in parts for c in part}
        if exact is None:
            return list(points)
        corners = {c for c in points if c[0] in box[:2] and c[1] in box[2:]}
        return [c for c in points if c not in corners or where((c[0] + self.pole[0], c[1] + self.pole[1]), exact) >= 0]

    def pending_in(self, box, hull, pending):
        """The pairs not proven apart over the hull."""
        z = tuple(Jet(I(box[2 * i] - self.slip, box[2 * i + 1] + self.slip), [I(1.0 - i), I(float(i))]) for i in (0, 1))
        middle = 0.5 * box[0] + 0.5 * box[1], 0.5 * box[2] + 0.5 * box[3]
        try:
            moving = self.shape.joints((ZERO, ZERO), z, Jet(self.a, [ZERO, ZERO]), Jet(self.b, [ZERO, ZERO]), self.sign)
            still = self.place_of_joints((I(middle[0]), I(middle[1])))
        except Open:
            return pending
        clouds = {}
        for joint in {j for _, piece, _, _ in pending for j in piece}:
            clouds[joint] = self.cloud(still[joint], moving[joint], middle, hull)
        left, todo = [], list(pending)
        while todo:
            part, piece, node, i = todo.pop()
            distance = self.task.half(part) + self.task.clearance
            reach = max(clouds[j][2] for j in piece)
            if self.separated(piece, clouds, node[0], distance):
                continue
            if node[2] and node[1] > reach:
                todo += [(part, piece, child, i) for child in node[2]]
                continue
            if not node[2]:
                self.refute(hull[0], part, piece, node[0], distance, i)
            left.append((part, piece, node, i))
        return left

    def cloud(self, still, moving, middle, hull):
        """(places whose hull, grown by a radius, holds the joint over the cell; the radius; how far it moves; its middle)."""
        if moving.__class__ is tuple and moving[0].__class__ is not Jet:  # the pole stays
            point = still[0].middle(), still[1].middle()
            return [point], still[0].size() + still[1].size(), 0.0, point
        points, radius, way = [], 0.0, 0.0
        for v in hull:
            dx, dy = (I(v[i] - self.slip, v[i] + self.slip) - middle[i] for i in (0, 1))
            c = [still[i] + moving[i].d[0] * dx + moving[i].d[1] * dy for i in (0, 1)]
            point = c[0].middle(), c[1].middle()
            points.append(point)
            radius = max(radius, size_of([nextafter(c[i].hi - c[i].lo, inf) for i in (0, 1)]))
        point = still[0].middle(), still[1].middle()
        way = max(size_of((p[0] - point[0], p[1] - point[1])) for p in points)
        return points, radius, way, point

    def separated(self, piece, clouds, edge, distance):
        """True if one direction proves a piece farther than the distance from an edge (or rectangle) all over the cell."""
        v = apart([clouds[j][3] for j in piece], edge)
        if not v or not (gap := size_of(v)):
            return False
        n = v[0] / gap, v[1] / gap
        far = min(n[0] * p[0] + n[1] * p[1] for p in edge)
        near = max(max(n[0] * p[0] + n[1] * p[1] for p in clouds[j][0]) + clouds[j][1] for j in piece)
        slack = 1e-14 * (abs(far) + abs(near) + max(abs(c) for p in edge for c in p)) + 4 * self.slip
        return far - near >= distance - EPS_MM + slack

    def refute(self, place, part, piece, edge, distance, i):
        """At one place of the region the part is nearer than it may be."""
        try:
            joints = self.place_of_joints(tuple(I(c) for c in place))
        except Open:
            return
        v = apart([tuple(c.middle() for c in joints[j]) for j in piece], edge)
        gap = size_of(v) if v else 0.0
        if gap < distance - 2 * EPS_MM:
            raise Refuted(f"{part} and {self.task.obstacles[i]['name']}: gap {gap - self.task.half(part):.6g} mm with the tracer at "
                          f"({place[0] + self.pole[0]:.6g}, {place[1] + self.pole[1]:.6g}); allowed {self.task.clearance:g}")

    def way(self, one, other, pairs):
        """Two polygons are joined if a way from corner to corner, straight or around the pole, is clear as well."""
        A, B = min(((p, q) for p in one[::1 + len(one) // 40] for q in other[::1 + len(other) // 40]),
                   key=lambda pq: math.dist(*pq))
        least, most = math.sqrt(self.range[0].hi), math.sqrt(self.range[1].lo)
        (ra, ta), (rb, tb) = ((math.hypot(*p), math.atan2(p[1], p[0])) for p in (A, B))
        turn = math.remainder(tb - ta, 2 * math.pi)
        ways = [[A, B]]
        for r in (0.5 * (ra + rb), 0.5 * (least + most), 0.9 * least + 0.1 * most, 0.1 * least + 0.9 * most):
            for angle in (turn, turn - math.copysign(2 * math.pi, turn)):
                steps = max(2, int(abs(angle) / 0.02))
                arc = [(r * math.cos(ta + angle * i / steps), r * math.sin(ta + angle * i / steps)) for i in range(steps + 1)]
                ways.append([A, *arc, B])
        for way in ways:
            try:
                for p, q in zip(way, way[1:]):
                    middle = to_segment((0.0, 0.0), p, q)
                    if p != q and not (math.hypot(*middle) ** 2 >= self.range[0].lo * (1 - 1e-12) and max(math.hypot(*p), math.hypot(*q)) ** 2
                                       <= self.range[1].hi * (1 + 1e-12)):
                        raise Open
                    if p != q:
                        self.cover([[p, q]], pairs, None)
                return
            except (Open, Refuted):
                continue
        raise Open

    # The other limits of the file

    def limits(self):
        """Checks what else the file limits; returns the keys that it could not check."""
        task, unchecked = self.task, []
        if task.copy_error is not None:
            unchecked.append("limits.copy_error_mm")
        if task.sheets_gap is not None:
            self.sheets_apart(max(task.sheets_gap - EPS_MM, 1e-9))
        if any(self.file.data.get(key) is None for key in ("pole", "links", "objective", "cutting")):
            return unchecked + ["pole, links, objective (not in the file)"]
        task.read_choice()
        self.lengths_allowed()
        if self.shape.vertex not in task.groundings:
            raise Refuted(f"vertex {self.shape.vertex} is not among the groundings")
        if max(self.layers.values()) > task.layers:
            raise Refuted(f"a link lies above layer {task.layers}")
        if task.pole_at and math.dist(task.pole_at, self.pole) > EPS_MM:
            raise Refuted("the pole does not stand where it should")
        if task.pole_within and not any(where(self.pole, p) >= 0 for p in task.pole_within):
            edges = [(p, q) for polygon in task.pole_within for ring in polygon for p, q in zip(ring, ring[1:])]
            if min(size_of(to_segment(self.pole, *edge)) for edge in edges) > EPS_MM:
                raise Refuted("the pole stands outside its area")
        return unchecked

    def lengths_allowed(self):
        task, get = self.task, self.file.get("links").get
        least = max(task.shortest.hi, task.apart.hi)
        for name, length in self.lengths.items():
            if not least - EPS_MM <= length <= task.longest + EPS_MM:
                raise Refuted(f"length {name} = {length} is not within {least:g} and {task.longest:g}")
            if name in task.locked and abs(length - task.locked[name]) > EPS_MM:
                raise Refuted(f"length {name} = {length} is locked at {task.locked[name]}")
            if name not in ("CX", "CY"):
                grid, stock = self.file.optional("links.grid_mm"), get("stock_mm") or []
                if grid and abs(math.remainder(length, grid)) > EPS_MM:
                    raise Refuted(f"length {name} = {length} is no multiple of {grid}")
                if stock and min(abs(length - self.file.number("links.stock_mm", 0, 1e9, s)) for s in stock) > EPS_MM:
                    raise Refuted(f"length {name} = {length} is not in stock")

    def sheets_apart(self, gap):
        """No place of the region is nearer to a place of its copy: edges by trees of rectangles, then one inside the other."""
        k = self.shape.k
        copies = [[[tuple(c.middle() for c in cmul(k, self.near(p))) for p in ring] for ring in polygon] for polygon in self.region]
        slack = 16 * self.slip * (1 + self.task.scale) + 1e-13 * math.sqrt(self.range[1].hi) * (1 + self.task.scale)
        todo = [(tree_of([e for p in self.region for r in p for e in zip(r, r[1:])]),
                 tree_of([e for p in copies for r in p for e in zip(r, r[1:])]))]
        while todo:
            one, other = todo.pop()
            v = apart(one[0], other[0])
            if v and size_of(v) >= gap + slack:
                continue
            if not one[2] and not other[2]:
                if (size_of(v) if v else 0.0) < gap - EPS_MM - slack:
                    raise Refuted(f"original and copy are {size_of(v) if v else 0.0:.6g} mm apart; allowed {self.task.sheets_gap:g}")
                raise Open
            todo += [(c, other) for c in one[2]] if one[2] and one[1] >= other[1] else [(one, c) for c in other[2]]
        for some, others in ((self.region, copies), (copies, self.region)):
            if any(where(polygon[0][0], other) >= 0 for polygon in some for other in others):
                raise Refuted("original and copy overlap")


# ------------------------------------------------------------------------------ claims 3 and 4: a certificate


class Node:
    """Designs: ranges of a, b and the pole's x, y; cosines of the least and largest |psi|; layer assignments."""

    def __init__(self, box, window, assignments):
        self.box, self.window, self.assignments = box, window, assignments


class Certificate:
    def __init__(self, name, lines):
        file = self.file = File(name, lines[0] if lines else None)
        if not isinstance(file.data, dict) or file.data.get("format") != "kempe-certificate/1":
            file.fault("format", file.data, "kempe-certificate/1")
        self.claim, self.objective = file.get("claim"), file.get("objective")
        if self.claim not in ("bound", "none"):
            file.fault("claim", self.claim, "bound or none")
        self.bound = file.number("bound") if self.claim == "bound" else None
        table = File(name, file.get("task"))
        self.task = task = Task(table, table.number("copy.scale", 1e-6), table.number("copy.rotation_deg", -3600, 3600),
                                table.number("link_width_mm", 0), table.number("pin_diameter_mm", 0), table.get("plate"))
        if task.plate not in ("bent", "triangle"):
            table.fault("plate", task.plate, "bent or triangle")
        task.read_choice()
        self.lines, self.at = lines, 0

    def prove(self):
        if self.claim == "bound" and self.objective not in ("size", "transmission"):
            raise Open(f"objective {self.objective} has no rules")
        for vertex in ROLES:
            if vertex in self.task.groundings:
                self.shape = Shape(self.task.scale, self.task.degrees, vertex)
                for mode in range(self.shape.modes()):
                    self.sign = self.shape.sign_of_psi(mode)
                    self.prove_root(mode)
        if self.at != len(self.lines) - 1:
            raise Open(f"line {self.at + 2}: all trees are closed")
        return f" ({self.at} nodes)"

    def belongs_to(self, design):
        """The log speaks of the design's task, and proves what the design's file states."""
        mine, copy, mechanism = self.task.file.data, design.get("copy"), design.get("mechanism")
        theirs = {key: design.get(key) for key in ("region", "pole", "links", "limits", "obstacles", "objective", "tolerance", "cutting")}
        theirs["copy"] = {key: copy.get("wanted_" + key, copy.get(key)) for key in ("scale", "rotation_deg")}
        theirs.update({key: mechanism.get(key) for key in ("link_width_mm", "pin_diameter_mm")}, plate=mechanism["links"][2].get("shape"))
        for key, value in theirs.items():
            if mine.get(key) != value:
                raise Open(f"the log's {key} is not the design's")
        if self.claim != "bound" or design.get("search.objective") != self.objective:
            raise Refuted("the log is about something else")
        value, stated = design.number("search.value"), design.optional("quality.lower_bound")
        over = 1.0 if self.objective == "size" else -1.0
        if over * value < over * self.bound:
            raise Refuted(f"this design has {value}")
        if stated is not None and over * stated > over * self.bound + EPS_MM:
            raise Open(f"the file states {stated}")

    def prove_root(self, mode):
        todo = [self.root(mode)]
        while todo:
            node = todo.pop()
            self.at += 1
            try:
                if self.at >= len(self.lines):
                    raise Open("a node without its line")
                line = self.lines[self.at]
                rule = next((getattr(self, "node_" + r) for r in ("split", "share", "contact") if r in line), None)
                if rule:
                    todo += reversed(rule(node, line))
                elif not getattr(self, "leaf_" + line["leaf"])(node, line):
                    raise Open(f"{line['leaf']} does not refute")
            except (KeyError, TypeError, ValueError, IndexError, AttributeError, Open, OverflowError) as fault:
                raise Open(f"line {self.at + 1}: {fault or 'nothing proven'}") from None

    def root(self, mode):
        task, shape = self.task, self.shape
        least = max(task.shortest.hi, task.apart.lo)
        ranges = []
        for factors in (shape.of_a, shape.of_b):
            lo = max((I(least) / f).lo for f in factors.values())
            hi = min((I(task.longest) / f).hi for f in factors.values())
            for name in factors.keys() & task.locked.keys():
                locked = I(task.locked[name]) / factors[name]
                lo, hi = max(lo, locked.lo), min(hi, locked.hi)
            ranges.append(I(lo, hi))
        corners = [task.pole_at] if task.pole_at else [c for polygon in task.pole_within for c in polygon[0]]
        ranges += [I(min(c[i] for c in corners), max(c[i] for c in corners)) for i in (0, 1)]
        limit = max(task.transmission, self.bound if self.objective == "transmission" and self.claim == "bound" else 0.0)
        every = [dict(zip(LINKS, layers)) for layers in product(range(1, task.layers + 1), repeat=4)]
        meet = [(one, other) for one, other in product(LINKS, LINKS) if one < other and not may_meet(one, other)]
        return Node(dict(zip("abxy", ranges)), shape.window(mode, limit),
                    [l for l in every if all(l[one] != l[other] for one, other in meet)])

    # Inner nodes

    def node_split(self, node, line):
        old, at = node.box[line["split"]], float(line["at"])
        if not old.lo < at < old.hi:
            raise Open(f"{at} does not split {old.lo} to {old.hi}")
        return [Node({**node.box, line["split"]: half}, node.window, node.assignments) for half in (I(old.lo, at), I(at, old.hi))]

    def node_share(self, node, line):
        one, other = line["share"]
        if one not in PARTS or not (other in PARTS or 0 <= other < len(self.task.obstacles)):
            raise Open("unknown parts")
        together = [l for l in node.assignments if share(one, other, l, self.task.obstacles)]
        return [Node(node.box, node.window, together), Node(node.box, node.window, [l for l in node.assignments if l not in together])]

    def node_contact(self, node, line):
        u, (one, other) = float(line["u"]), line["contact"]
        if not 0 < u < 1e9 or not may_meet(one[0], other[0]) or not all(share(one[0], other[0], l, ()) for l in node.assignments):
            raise Open("these parts need not keep apart")
        cosine, sine = (1.0 - I(u).square()) / (1.0 + I(u).square()), I(u) * 2.0 / (1.0 + I(u).square())
        allowed = (I(self.task.half(one[0])) + self.task.half(other[0]) + self.task.clearance).square().lo
        for a, b in product(*((i.lo, i.hi) for i in (node.box["a"], node.box["b"]))):
            q = cosine * b, sine * (b * self.sign)
            joints = {j: cadd(tuple(c * a for c in alpha), cmul(beta, q)) for j in "VABCXY" for alpha, beta in [self.shape.seen(j)]}
            gap = csub(self.material(one, joints), self.material(other, joints))
            if not (gap[0].square() + gap[1].square()).hi < allowed:
                raise Open("the points are not in contact all over the box")
        return [Node(node.box, window, node.assignments) for window in ((node.window[0], cosine), (cosine, node.window[1]))]

    def material(self, point, joints):
        """A material point of a part, from its joints."""
        part, *t = point
        t = [float(x) for x in t]
        plate, bar = part in ("ACX", "BCY"), part in ("VA", "VB")
        if part not in PARTS or len(t) != plate * 2 + bar or not all(0 <= x <= 1 for x in t):
            raise Open(f"{point} is no point of a part")
        if plate and not (t[0] + t[1] <= 1 if self.task.plate == "triangle" else 0 in t):
            raise Open(f"{point} is not on the plate")
        start = joints[part[0] if part in LINKS else part[-1]]
        for x, joint in zip(t, part[1:]):
            start = cadd(start, tuple(c * x for c in csub(joints[joint], joints[part[0]])))
        return start

    # Leaves

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
        corners = self.task.region[polygon][ring]
        p, q = corners[corner], corners[corner + 1]
        return tuple(I(p[i]) + (I(q[i]) - p[i]) * float(t) for i in (0, 1))

    def leaf_sum(self, node, line):
        """Q about the middle of the box: value, slopes and squares, and the product of a and b."""
        middle = {v: i.middle() for v, i in node.box.items()}
        a, b = I(middle["a"]), I(middle["b"])
        value, slope, square, mixed = ZERO, dict.fromkeys("abxy", ZERO), dict.fromkeys("abxy", ZERO), ZERO
        for name, *place, weight in line["of"]:
            if not 0 <= weight < 1e9:
                raise Open("a weight is negative")
            weight = I(float(weight))
            if name == "bound":
                if self.claim != "bound" or self.objective != "size":
                    raise Open("there is no bound")
                value += weight * (self.bound - self.shape.size[0] * a - self.shape.size[1] * b)
                slope["a"], slope["b"] = (slope[v] - weight * f for v, f in zip("ab", self.shape.size))
                continue
            away = tuple(t - middle[v] for t, v in zip(self.place(place[0]), "xy"))
            side_of = {"far": -1.0, "near": 1.0, "posts": 1.0}[name]
            pole = weight * side_of if name == "posts" else weight * self.shape.abs_g.square() * side_of
            value += pole * (away[0].square() + away[1].square())
            for v, t in zip("xy", away):
                slope[v], square[v] = slope[v] - pole * t * 2.0, square[v] + pole
            if name == "posts":
                s = self.shape
                smallest = min(1.0, s.abs_s.hi, s.abs_1s.hi) * s.abs_g.hi * (1 + 1e-15)
                value += -weight * ((I(self.task.pin) + self.task.clearance) / smallest).square()
                continue
            c = node.window[0 if name == "far" else 1]
            length = -weight * side_of
            value += length * (a.square() + b.square() + a * b * c * 2.0)
            slope["a"] += length * (a + b * c) * 2.0
            slope["b"] += length * (b + a * c) * 2.0
            square["a"], square["b"], mixed = square["a"] + length, square["b"] + length, mixed + length * c * 2.0
        half = {v: I(max((I(i.hi) - middle[v]).hi, (middle[v] - I(i.lo)).hi)) for v, i in node.box.items()}
        most = value + I(mixed.size()) * half["a"] * half["b"]
        for v, h in half.items():
            g, q = I(slope[v].size()), I(square[v].hi)
            if q.hi < 0 and g.hi < (q * h * -2.0).lo:
                most += g.square() / (q * -4.0)
            else:
                most += g * h + q * h.square()
        return most.hi < 0

    def leaf_lengths(self, node, line):
        return any(node.box[v].lo > node.box[v].hi for v in "ab")

    def leaf_layers(self, node, line):
        return not node.assignments

    def leaf_pole(self, node, line):
        (x0, x1), (y0, y1) = ((node.box[v].lo, node.box[v].hi) for v in "xy")
        corners = list(product((x0, x1), (y0, y1)))
        for polygon in self.task.pole_within or [[[self.task.pole_at] * 2]]:
            if where((x0, y0), polygon) >= 0:
                return False
            for ring in polygon:
                for p, q in zip(ring, ring[1:]):
                    beside = max(p[0], q[0]) < x0 or min(p[0], q[0]) > x1 or max(p[1], q[1]) < y0 or min(p[1], q[1]) > y1
                    turns = [side(p, q, c) for c in corners]
                    if not (beside or min(turns) > 0 or max(turns) < 0):
                        return False
        return True

    def leaf_sheets(self, node, line):
        one, other = (self.place(p) for p in line["places"])
        for corner in product(*((i.lo, i.hi) for i in (node.box["x"], node.box["y"]))):
            P = tuple(I(c) for c in corner)
            way = csub(cadd(P, cmul(self.shape.k, csub(one, P))), other)
            if not (way[0].square() + way[1].square()).hi < I(self.task.sheets_gap).square().lo:
                return False
        return True

    def leaf_obstacle(self, node, line):
        index, point = line["obstacle"], line["point"]
        obstacle = self.task.obstacles[index]
        if index < 0 or not all(share(point[0], index, l, self.task.obstacles) for l in node.assignments):
            raise Open("the part does not meet this obstacle")
        ring = obstacle["rings"][0]
        if line["edge"] is None:
            if len(obstacle["rings"]) > 1 or not inside_convex_ring(ring):
                raise Open("the obstacle is not convex")
            K = ring[:-1]
        else:
            K = [ring[line["edge"]], ring[line["edge"] + 1]] if line["edge"] >= 0 else []
        T = self.place(line["place"])
        names = [v for v in "abxy" if node.box[v].lo < node.box[v].hi]
        jets = {v: Jet(node.box[v], [I(float(v == n)) for n in names]) for v in "abxy"}
        middle = {v: I(node.box[v].middle()) for v in "abxy"}
        at = []
        for box in (jets, middle):
            pole = box["x"], box["y"]
            at.append(self.material(point, self.shape.joints(pole, csub(T, pole), box["a"], box["b"], self.sign)))
        allowed = (self.task.half(point[0]) + self.task.clearance) * (1 - 1e-15)
        for corner in product(*((node.box[v].lo, node.box[v].hi) for v in names)):
            J = []
            for c in (0, 1):
                J.append(at[1][c])
                for v, to, slope in zip(names, corner, at[0][c].d):
                    J[c] = J[c] + slope * (to - middle[v])
            radius = size_of([nextafter(c.hi - c.lo, inf) for c in J])
            centre = tuple(c.middle() for c in J)
            near = 0.0 if len(K) > 2 and inside_convex(centre, K) else min(size_of(to_segment(centre, K[i], K[i - 1])) for i in range(len(K)))
            if not near + radius + 1e-14 * max(abs(c) for c in centre) < allowed:
                return False
        return True


def inside_convex_ring(ring):
    """True if a closed ring turns one way only, and once around."""
    turns = [side(p, q, r) for p, q, r in zip(ring, ring[1:], ring[2:] + ring[1:2])]
    angles = sum(math.remainder(math.atan2(r[1] - q[1], r[0] - q[0]) - math.atan2(q[1] - p[1], q[0] - p[0]), 2 * math.pi)
                 for p, q, r in zip(ring, ring[1:], ring[2:] + ring[1:2]))
    return (all(t >= 0 for t in turns) or all(t <= 0 for t in turns)) and abs(angles) < 7


# ------------------------------------------------------------------------------------------------- main


def claim(name, proof):
    """Prints one claim's line; True if it is proven."""
    try:
        print(f"{name}: proven{proof() or ''}")
        return True
    except Refuted as reason:
        print(f"{name}: refuted: {reason}")
    except (Open, OverflowError, ZeroDivisionError) as reason:
        print(f"{name}: not proven{': ' + str(reason) if str(reason) else ''}")
    return False


def check_design(file):
    design = Design(file)

    def clear():
        design.clear_of_itself()
        design.clear_of_obstacles()
        return f" (clearance {design.task.clearance:g} mm, eps {EPS_MM:g} mm)"

    def limits():
        unchecked = design.limits()
        if unchecked:
            raise Open("not checked: " + ", ".join(unchecked))

    good = claim("1 every point is reached on one assembly mode", lambda: design.reached() or
                 f" (transmission {design.task.transmission:g} degrees, eps {EPS_DEG:g} degrees)")
    if not good:
        print("2 the parts keep their clearance: not proven: claim 1 comes first")
        return False
    good = claim("2 the parts keep their clearance", clear)
    return claim("limits of the file", limits) and good


def check_certificate(name, lines, design):
    log = Certificate(name, lines)
    unit = "mm" if log.objective == "size" else "degrees"
    better = {"size": "below", "transmission": "above"}.get(log.objective, "beyond")
    title = "4 no design exists" if log.claim == "none" else f"3 no design is {better} {log.bound:.12g} {unit}"

    def proof():
        if design:
            log.belongs_to(design)
        return log.prove()
    return claim(title, proof)


def read(name):
    """The lines of a JSON or JSON lines file."""
    def refuse(word):
        raise ValueError(word)
    try:
        text = open(name, encoding="utf-8").read()
        if name.endswith(".jsonl"):
            return [json.loads(line, parse_constant=refuse) for line in text.splitlines()]
        return [json.loads(text, parse_constant=refuse)]
    except OSError as fault:
        raise Unreadable(f"{name}: found {fault.strerror}; allowed: a file that can be read")
    except (ValueError, RecursionError) as fault:
        raise Unreadable(f"{name}: found {str(fault)[:80]}; allowed: JSON of numbers, texts and lists")


def main(arguments):
    if not 1 <= len(arguments) <= 2:
        raise Unreadable(__doc__)
    data = [read(name) for name in arguments]
    if len(data) == 1 and arguments[0].endswith(".jsonl"):
        return check_certificate(arguments[0], data[0], None)
    design = File(arguments[0], data[0][0])
    good = check_design(design)
    return all([good] + [check_certificate(name, lines, design) for name, lines in zip(arguments[1:], data[1:])])


if __name__ == "__main__":
    try:
        sys.exit(0 if main(sys.argv[1:]) else 1)
    except Unreadable as fault:
        print(fault, file=sys.stderr)
        sys.exit(2)
