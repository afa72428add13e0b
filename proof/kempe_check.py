#!/usr/bin/env python3
"""Checks a design of Kempe from its files alone; shares no code with Kempe. The theorems stand in docs/proof.md.
usage: kempe_check.py design.json [certificate.jsonl]   or   kempe_check.py certificate.jsonl
A line a claim: proven, not proven or refuted. Exit code 0: all claims are proven; 1: one is not; 2: a file cannot be read.
Claims 1 to 4 stand here. Beside it stand limits_check.py (a design's other limits; that a log is about it), tolerance_check.py
(claim 5; limits on the copy error) and bodies_check.py (bodies; a table's edge): what they hold is not proven without them.
eps:      claims 1, 2 and 5 and the limits forgive 1e-6 mm and 1e-6 degrees; claims 3 and 4 forgive nothing.
Assumes:  + - * / and sqrt of doubles are rounded correctly (IEEE 754); the numbers of the files are the doubles nearest
          to them; rings are simple, and holes lie inside their polygon.
"""
import json
import sys
from collections import namedtuple
from fractions import Fraction
from functools import cache
from itertools import combinations, product
from math import atan2, cos, dist, factorial, hypot, inf, nextafter, pi, sin, sqrt
from pathlib import Path
from types import SimpleNamespace
EPS_MM, EPS_DEG = 1e-6, 1e-6
MOST_CELLS = 200_000  # of one search; then the answer is "not proven"
LINKS = ("VA", "VB", "ACX", "BCY")
# Each part, and the links whose layers say which it fills: a link its own, a pin those between its two, a post those below.
LAYERED_BY = {**{link: (link,) for link in LINKS}, "pin A": ("VA", "ACX"), "pin B": ("VB", "BCY"), "pin C": ("ACX", "BCY"),
              "pin V": ("VA", "VB"), "post V": ("VA", "VB"), "post X": ("ACX",), "post Y": ("BCY",)}
JOINTS = {part: part.split()[-1] for part in LAYERED_BY}
COPIED = ("V", "X", "Y")  # pole, tracer and pen: the copy says where they are, whatever the lengths
LENGTHS = ("VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY")
VERTICES = ("pole", "tracer", "pen")  # who stands at the vertex V
SHARED = ("region", "pole", "links", "limits", "obstacles", "bodies", "table", "objective", "tolerance", "cutting")  # by both files
AT_REST = {"joint": "pole", "beyond": 0.0, "rest": 1.0}  # seen from; what its rings are grown by; 1 in the table's frame
class Open(Exception): """Nothing is decided."""
class Refuted(Exception): """A claim is false, and why."""
class Unreadable(Exception): """A file that says nothing definite: file, key, what was found, what is allowed."""
def need(good, reason="", fault=Open):
    if not good:
        raise fault(reason)

class I:
    """An interval that holds the exact value, each result moved outwards by one step; `d`: its derivatives, by variable."""
    __slots__ = ("lo", "hi", "d")
    def __init__(self, lo, hi=None, d=None):
        self.lo, self.hi, self.d = lo, lo if hi is None else hi, d
    def __bool__(self): return bool(self.lo or self.hi or self.d)
    def __neg__(self): return I(-self.hi, -self.lo, self.d and {v: -x for v, x in self.d.items()})
    def __sub__(self, o): return self + -o
    def __rsub__(self, o): return -self + o
    def size(self): return max(abs(self.lo), abs(self.hi))
    def middle(self): return 0.5 * self.lo + 0.5 * self.hi
    def slopes_times(self, o): return self.d and {v: x * I(o.lo, o.hi) for v, x in self.d.items()}
    def __add__(self, o):
        o = o if o.__class__ is I else I(o)
        return I(nextafter(self.lo + o.lo, -inf), nextafter(self.hi + o.hi, inf), total(self.d, o.d)) if self and o else self or o
    def __mul__(self, o):
        o = o if o.__class__ is I else I(o)
        if self is ONE or o is ONE or not (self and o):
            return ZERO if not (self and o) else o if self is ONE else self
        ends = (self.lo * o.lo, self.lo * o.hi, self.hi * o.lo, self.hi * o.hi)
        lo, hi = nextafter(min(ends), -inf), nextafter(max(ends), inf)
        need(lo > -1e150 and hi < 1e150)  # so no infinity comes up, and no NaN
        return I(lo, hi, (self.d or o.d) and total(self.slopes_times(o), o.slopes_times(self)))
    def __truediv__(self, o):
        o = o if o.__class__ is I else I(o)
        need(o.lo > 1e-140 or o.hi < -1e-140)
        inverse = I(nextafter(1 / o.hi, -inf), nextafter(1 / o.lo, inf))
        return self * I(inverse.lo, inverse.hi, o.slopes_times(-(inverse * inverse)))
    def sqrt(self):
        need(self.lo >= 0)
        root = I(max(0.0, nextafter(sqrt(self.lo), -inf)), nextafter(sqrt(self.hi), inf))
        return I(root.lo, root.hi, self.d and self.slopes_times(I(0.5) / root))
    def square(self):
        found = self * self
        return I(max(0.0, found.lo), found.hi, found.d)
    __radd__, __rmul__ = __add__, __mul__

class Z:
    """A complex number x + iy of two intervals."""
    __slots__ = ("x", "y")
    def __init__(self, x, y):
        self.x, self.y = x if x.__class__ is I else I(x), y if y.__class__ is I else I(y)
    def __neg__(self): return Z(-self.x, -self.y)
    def __add__(self, o): return Z(self.x + o.x, self.y + o.y)
    def __sub__(self, o): return Z(self.x - o.x, self.y - o.y)
    def __mul__(self, o):
        return Z(self.x * o.x - self.y * o.y, self.x * o.y + self.y * o.x) if o.__class__ is Z else Z(self.x * o, self.y * o)
    def __truediv__(self, o): return self * o.conj() / o.square() if o.__class__ is Z else Z(self.x / o, self.y / o)
    def conj(self): return Z(self.x, -self.y)
    def square(self): return self.x.square() + self.y.square()  # of the modulus
    def middle(self): return self.x.middle(), self.y.middle()
def total(slopes, others):
    more = slopes and others and {v: slopes[v] + x if v in slopes else x for v, x in others.items()}
    return {**slopes, **more} if more else slopes or others
ZERO, ONE = I(0.0), I(1.0)
NIL, UNIT = Z(ZERO, ZERO), Z(ONE, ZERO)
@cache
def unit_circle(degrees):  # cosine + i sine of decimal degrees, by Taylor: 50 digits of pi, cut at 2^-160; 50 terms leave < 1e-50
    quarters, rest = divmod(Fraction(degrees) % 360, 90)
    x = Fraction(int(rest * Fraction("3.14159265358979323846264338327950288419716939937511") / 180 * 2 ** 160), 2 ** 160)
    terms = [x ** n / factorial(n) * (-1) ** (n // 2) for n in range(50)]
    c, s = (I(float(sum(terms[odd::2]))) + (I(-1e-40, 1e-40) if rest else 0.0) for odd in (0, 1))
    return [Z(c, s), Z(-s, c), Z(-c, -s), Z(s, -c)][int(quarters)]

# Plane geometry in doubles: exact where it decides, else a guess that is proven by intervals or kept away from by a slack.
def edges_of(rings): return [edge for ring in rings for edge in zip(ring, ring[1:])]
def exact(*points): return [[Fraction(c) for c in p] for p in points]
def span(points): return [(min(c), max(c)) for c in zip(*points)]  # of x and of y
def within(point, some): return any(where(point, rings) >= 0 for rings in some)  # one of some polygons, or on its edge
def largest(some): return max(abs(c) for rings in some for ring in rings for corner in ring for c in corner)
def side(p, q, r):  # the sign of the turn p-q-r, exact
    left, right = (q[0] - p[0]) * (r[1] - p[1]), (q[1] - p[1]) * (r[0] - p[0])
    if left.__class__ is Fraction or abs(left - right) > 1e-14 * (abs(left) + abs(right)) + 1e-290:
        return left - right
    return side(*exact(p, q, r))
def where(point, rings):  # 1 inside, 0 on an edge, -1 outside, by the even-odd rule; exact
    (x, y), inside = point, -1
    for p, q in edges_of(rings):
        if min(p[1], q[1]) <= y <= max(p[1], q[1]):
            turn = side(p, q, point)
            if turn == 0 and min(p[0], q[0]) <= x <= max(p[0], q[0]):
                return 0
            if (p[1] > y) != (q[1] > y) and (turn > 0) == (q[1] > p[1]):
                inside = -inside
    return inside
def to_segment(p, a, b):  # from p to the nearest point of the segment a-b
    ax, ay, dx, dy = a[0] - p[0], a[1] - p[1], b[0] - a[0], b[1] - a[1]
    length = dx * dx + dy * dy
    t = min(1, max(0, -(ax * dx + ay * dy) / length)) if length else 0  # so that fractions stay exact
    return ax + t * dx, ay + t * dy
def apart(A, B):  # the shortest way from convex A to convex B, given by their corners in order; (0, 0) if they meet
    edges, others = ([(Q[i - 1], Q[i]) for i in range(len(Q))] for Q in (A, B))
    crossed = len(A) > 1 < len(B) and any(side(a, b, c) * side(a, b, d) < 0 > side(c, d, a) * side(c, d, b)
                                          for (a, b), (c, d) in product(edges, others))
    if crossed or len(B) > 2 and where(A[0], [B + B[:1]]) > 0 or len(A) > 2 and where(B[0], [A + A[:1]]) > 0:
        return 0.0, 0.0
    ways = [to_segment(p, *e) for p in A for e in others] + [(-x, -y) for x, y in (to_segment(p, *e) for p in B for e in edges)]
    return min(ways, key=lambda v: hypot(*v))
def beyond(p, ring):  # how far outside a closed convex ring a place is; negative: how deep inside
    least = min(hypot(*to_segment(p, *edge)) for edge in edges_of([ring]))
    return -least if where(p, [ring]) > 0 else least
def convex(ring):  # true if a closed ring, which is simple, turns one way only
    turns = [side(*corners) for corners in zip(ring, ring[1:], ring[2:] + ring[1:2])]
    return min(turns) >= 0 or max(turns) <= 0
def squared_distances(origin, some):  # the least and the largest to the polygons' edges: exact, then rounded outwards
    (o,), edges = exact(origin), edges_of(exact(*ring) for rings in some for ring in rings)
    squares = [x * x + y * y for p, q in edges for x, y in ((p[0] - o[0], p[1] - o[1]), to_segment(o, p, q))]
    return [I(nextafter(float(square), -inf), nextafter(float(square), inf)) for square in (min(squares), max(squares))]
def clip(edge, axis, at, keep):  # the part of an edge on one side of a line, in a list; an end on the line is there exactly
    (u, p), (v, q) = sorted((keep * (c[axis] - at), c) for c in edge)
    if u < 0 < v:
        p = tuple(at if i == axis else p[i] + u / (u - v) * (q[i] - p[i]) for i in (0, 1))
    return [(p, q)] if v > 0 or u >= 0 else []

def cover(rings, pending, pending_in):
    """Cells of a polygon, or of a segment there and back, halved until nothing is pending in any. A cell is the hull of what a
    rectangle holds of the edges, and of its corners in the polygon."""
    inside = cache(lambda corner: where(corner, rings) >= 0)
    todo, cells = [(span(rings[0]), edges_of(rings), pending)], 0
    while todo:
        (box, edges, pending), cells = todo.pop(), cells + 1
        hull = [*{p for edge in edges for p in edge}.union(filter(inside, product(*box)))]
        if hull and (left := pending_in(box, hull, pending)) is not None:
            axis, low, high = max(((i, *box[i]) for i in (0, 1)), key=lambda each: each[2] - each[1])
            m = 0.5 * low + 0.5 * high
            need(low < m < high and cells <= MOST_CELLS)
            for half, keep in (((low, m), -1), ((m, high), 1)):
                parts = [part for edge in edges for part in clip(edge, axis, m, keep)]
                todo.append(([*box[:axis], half, *box[axis + 1:]], parts, left))
def cloud(still, moving, ways):
    """Places whose hull, grown by a radius, holds a point over a cell (mean value theorem); the radius; how far the point moves."""
    slopes = moving.x.d or {}, moving.y.d or {}
    ends = [still + Z(*(sum((d.get(v, ZERO) * x for v, x in way.items()), ZERO) for d in slopes)) for way in ways]
    points, middle = [e.middle() for e in ends], still.middle()
    radius = 0.5 * (1 + 1e-15) * max(hypot(nextafter(e.x.hi - e.x.lo, inf), nextafter(e.y.hi - e.y.lo, inf)) for e in ends)
    return points, radius, max(dist(p, middle) for p in points)

# Values of a file
def plain(reason): return str(reason).encode("unicode_escape").decode()  # on one line: names from the files may hold anything
def must(good, path, value, allowed):
    if not good:
        raise Unreadable(f"{path.rstrip('.')}: found {'nothing' if value is None else plain(value)[:60]}; allowed: {allowed}")
def fits(value, shape, path):
    """The value, if it is as `shape` says: (least, largest) a number, a whole one if both are written so, or what else the tuple
    lists; {..}: one of these; [shape]: a list; [shape, shape]: two; {key: shape}: a table, with its inner tables merged into it."""
    if isinstance(shape, dict):
        out = SimpleNamespace()
        for key, inner in shape.items():
            found = fits(value.get(key) if isinstance(value, dict) else None, inner, f"{path}{key}.")
            vars(out).update(vars(found) if isinstance(found, SimpleNamespace) else {key: found})
        return out
    if isinstance(shape, list):
        must(isinstance(value, list) and len(shape) in (1, len(value)), path, value, "a list" + " of two" * (len(shape) - 1))
        return (list if len(shape) == 1 else tuple)(fits(each, inner, path) for each, inner in zip(value, shape * len(value)))
    if isinstance(shape, tuple):
        number = type(value) in {type(end) for end in shape[:2]} | {int} and shape[0] <= value <= shape[1]
        must(number or value in shape[2:], path, value, f"a number from {shape[0]:g} to {shape[1]:g}")
    elif isinstance(shape, set):
        must(any(value == each for each in shape), path, value, " or ".join(sorted(map(str, shape))))
    return shape(value, path) if callable(shape) else value
def polygons(value, path):
    found = fits(value, {"type": {"MultiPolygon"}, "coordinates": [[[POINT]]]}, path).coordinates
    closed = all(len(ring) > 3 and ring[0] == ring[-1] for rings in found for ring in rings)
    must(found and all(found) and closed, path, value, "polygons of closed rings of three corners and more")
    must(all(within(c, [rings[:1]]) for rings in found for c in sum(rings[1:], [])), path, value, "holes inside their polygon")
    return found
def obstacle(value, path):
    found = fits(value, {"shape": polygons, "layers": [(0, 64)] * 2}, path)
    must(len(found.shape) == 1, path, value, "one polygon")
    (low, high), name = found.layers, value.get("name") or "an obstacle"
    return SimpleNamespace(rings=found.shape[0], layers=range(low, high + 1), name=name, **AT_REST)
def links(value, path):
    found = {link.name: link for link in fits(value, [{"name": set(LINKS), "layer": (1, 64), "shape": SHAPES}], path)}
    good = len(value) == len(found) == 4 and found["ACX"].shape == found["BCY"].shape != "bar"
    must(good, path, value, "VA, VB, ACX and BCY, both plates of one shape")
    return {link: found[link].layer for link in LINKS}, found["ACX"].shape
def area(value, path):
    must(isinstance(value, dict) and len(value) == 1, path, value, "a table of at_mm or within_mm")
    return [[[fits(value["at_mm"], POINT, path)] * 2]] if "at_mm" in value else polygons(value.get("within_mm"), path)
POINT, LENGTH, MAYBE, WIDTH = [(-2e7, 2e7)] * 2, (0.0, 1e9), (0.0, 1e9, None), (1e-6, 1e9)
SHAPES, OBJECTIVE, NUMBER = {"bar", "bent", "triangle"}, {"size", "transmission"}, (-1e9, 1e9, None)  # of others no log can be
LIMITS = {"clearance_mm": LENGTH, "transmission_deg": (0.0, 90.0),
          **dict.fromkeys(("sheets_gap_mm", "copy_error_mm", "longest_strip_mm"), MAYBE)}
TASK = {"region": polygons, "obstacles": [obstacle], "copy": {"scale": WIDTH, "rotation_deg": (-3600.0, 3600.0)},
        "limits": LIMITS, "tolerance": {"length_mm": MAYBE, "play_mm": MAYBE, "robust": {True, False, None}}}
WIDTHS = {"link_width_mm": WIDTH, "pin_diameter_mm": WIDTH}
LINKAGE = {**WIDTHS, "links": links, "vertex": set(VERTICES), "assembly": (0, 3), "pole_position_mm": POINT,
           "lengths_mm": lambda value, path: vars(fits(value, dict.fromkeys(LENGTHS, WIDTH), path))}
CHOICE = {"links": {"longest_mm": LENGTH, "shortest_mm": LENGTH, "wall_mm": LENGTH, "seat_mm": MAYBE, "layers": (1, 8),
                    "grid_mm": MAYBE, "stock_mm": lambda value, path: value and fits(value, [LENGTH], path),
                    **{name + "_mm": MAYBE for name in LENGTHS}},
          "cutting": {"hole_fit_mm": (-10.0, 10.0)}, "objective": {"groundings": [set(VERTICES)]}, "pole": area}
DESIGN = {"format": {"kempe-design/1"}, **TASK, "mechanism": LINKAGE}
LOG = {"format": {"kempe-certificate/1"}, "claim": {"bound", "none"}, "objective": OBJECTIVE, "bound": NUMBER,
       "task": {**TASK, **CHOICE, **WIDTHS, "plate": {"bent", "triangle"}}}

# Linkages and their parts
class Shape:
    """What ratio and vertex fix: s, g, the factors of the lengths, and the modes."""
    def __init__(self, task, vertex):
        k = self.k = unit_circle(task.rotation_deg) * task.scale
        s = self.s = {"pole": k, "tracer": UNIT - k, "pen": UNIT - UNIT / k}[vertex]
        self.vertex, self.g = vertex, {"pole": UNIT, "tracer": -UNIT, "pen": -k}[vertex]
        self.abs_s, self.abs_1s, self.abs_g = (z.square().sqrt() for z in (s, UNIT - s, self.g))
        self.modes = 4 if k.y.lo or k.y.hi else 2
        self.up = -1.0 if s.y.hi < 0 or self.modes == 2 and s.x.hi < 0 else 1.0  # the sign of arg s
        need((self.modes == 2 or s.y.lo > 0 or s.y.hi < 0) and self.abs_s.lo > 0, "the shape is nearly degenerate")
        self.turn = s.conj() / self.abs_s
        half = (self.abs_s + self.abs_1s + 1.0) * 0.5
        self.size, self.gg = (half + 1.0, half + self.abs_s), self.abs_g.square()  # of a and of b; |g| squared
        between = I(task.pin_diameter_mm) + task.clearance_mm  # of two posts; so far from the tracer the pole is at least:
        self.posts = I((between / (I(min(1.0, self.abs_s.hi, self.abs_1s.hi)) * self.abs_g)).lo)
        self.of_a = {"VA": ONE, "BC": ONE, "BY": self.abs_s, "CY": self.abs_1s}
        self.of_b = {"VB": self.abs_s, "AC": self.abs_s, "AX": ONE, "CX": self.abs_1s}
        # (alpha, beta) of joint - pole = alpha p + beta q/s
        seen = {"V": (NIL, NIL), "A": (UNIT, NIL), "B": (NIL, s), "C": (UNIT, s), "X": (UNIT, UNIT), "Y": (s, s)}
        pole = seen["V" if vertex == "pole" else "X"]
        self.seen = {**{j: (alpha - pole[0], beta - pole[1]) for j, (alpha, beta) in seen.items()}, "pole": (NIL, NIL)}
    def signs(self, mode):  # of sin psi and of sin d
        sin_d = -1 if mode < self.modes // 2 else 1
        return (sin_d if self.modes == 2 else 1 if mode in (0, 3) else -1) * self.up, sin_d
    def window(self, mode, degrees):  # cosines of the least and the largest |psi| with the transmission angle asked for
        limit, (sign, sign_d) = unit_circle(degrees), self.signs(mode)
        # The change point in this half turn is psi = -arg s modulo pi; the dead point is 0 (then first) where d comes to arg s.
        cc, cs = self.s.x * (-self.up * sign) / self.abs_s, self.s.y * self.up / self.abs_s
        return (limit.x, cc * limit.x + cs * limit.y) if sign_d * self.up > 0 else (cc * limit.x - cs * limit.y, -limit.x)
    def opened(self, a, b, w, sign):
        """By (1) and (2), for constants alpha, beta: the place alpha p + beta q/s, seen from the table and from frames that turn
        with p (VA) and with q (ACX)."""
        r, aa, bb, ab = w.square(), a.square(), b.square(), a * b * 2.0
        h = (ab.square() - (r - aa - bb).square()).sqrt() * float(sign)
        p, psi = Z((aa - bb) / r + ONE, -h / r) * 0.5, Z(r - aa - bb, h) / ab
        return {"table": lambda alpha, beta: w * ((alpha - beta) * p + beta),
                "VA": lambda alpha, beta: alpha * a + beta * (psi * b),
                "ACX": lambda alpha, beta: (alpha * (psi.conj() * a) + beta * b) * self.turn}
def may_meet(one, other): return not set(JOINTS[one]) & set(JOINTS[other])
def half(task, part): return 0.5 * (task.link_width_mm if part in LINKS else task.pin_diameter_mm)
def between(task, *parts): return sum(half(task, part) for part in parts) + task.clearance_mm  # from axis to axis
def occupied(part, layers):  # the layers that a part fills, given those of the links
    levels = sorted(layers[link] for link in LAYERED_BY[part])
    return set(levels if part in LINKS else range(levels[0] + 1, levels[-1]) if part.startswith("pin") else range(1, levels[0]))
def share(one, other, layers, obstacles):  # a part has a layer in common with a part, or with an obstacle given by its number
    return not occupied(one, layers).isdisjoint(occupied(other, layers) if isinstance(other, str) else obstacles[other].layers)
def permitted(task, name):  # the least and the largest length; a strip holds half a width more beyond each of the joints
    least = max(task.shortest_mm, (I(task.seat_mm or task.pin_diameter_mm + max(0.0, task.hole_fit_mm)) + task.wall_mm).lo)
    strip, locked = task.longest_strip_mm, getattr(task, name + "_mm")
    most = task.longest_mm if strip is None else min(task.longest_mm, (I(strip) - task.link_width_mm).hi)
    return (least, most) if locked is None else (max(least, locked), min(most, locked))
def pieces(task, part):  # convex pieces of a part's axis, by joints
    joints = JOINTS[part]
    return [joints[:2], joints[::2]] if len(joints) == 3 and task.plate == "bent" else [joints]
def beside(name):  # another file of the checker
    try:
        return __import__(name)
    except ModuleNotFoundError:
        raise Open(f"needs {name}.py") from None
# Two parts whose axes may not come nearer than `wide`: names, joints that span them, the frame they are seen from; the other is
# spanned by its joints and by each of some edges, those of a polygon's rings.
Pair = namedtuple("Pair", "one joints other others frame wide edges rings", defaults=([((0.0, 0.0),) * 2], None))
class Design:
    """Claims 1 and 2."""
    def __init__(self, name, data):
        self.name, self.data, self.range, self.losses = name, data, None, lambda z: lambda *which: 0.0
        task = self.task = fits(data, DESIGN, name + ": ")
        (self.layers, task.plate), self.lengths, self.pole = task.links, task.lengths_mm, task.pole_position_mm
        shape = self.shape = Shape(task, task.vertex)
        self.sign, self.sign_d = shape.signs(task.assembly)
        must(task.assembly < shape.modes, f"{name}: mechanism.assembly", task.assembly, f"0 to {shape.modes - 1}")
        self.a, self.b = I(self.lengths["VA"]), I(self.lengths["VB"]) / shape.abs_s
        self.exact = {n: f * unit for unit, factors in ((self.a, shape.of_a), (self.b, shape.of_b)) for n, f in factors.items()}
        # Places are taken from the pole. In doubles they, and the corners of cells, are off by less than `slip`.
        given = task.region + [o.rings for o in task.obstacles]
        local = [[[(c[0] - self.pole[0], c[1] - self.pole[1]) for c in ring] for ring in rings] for rings in given]
        self.region, self.blocks = local[:len(task.region)], local[len(task.region):]
        self.slip = 2.0 ** -50 * largest(given + [[[self.pole]]]) + 2.0 ** -44 * largest(local)
    def reached(self):  # claim 1; sets the range of distances, and the cosines of psi at its ends
        task, shape, ends = self.task, self.shape, []
        need(not within(self.pole, task.region), "the pole stands in the region, where the tracer cannot go", Refuted)
        for name, length in self.lengths.items():
            need((self.exact[name] - length).size() <= EPS_MM, f"{name} = {length} does not fit VA, VB and the ratio", Refuted)
        first, last = shape.window(task.assembly, max(0.0, task.transmission_deg - EPS_DEG))
        for place, square in zip(("nearest", "farthest"), squared_distances(self.pole, task.region)):
            c = (square * shape.gg - self.a.square() - self.b.square()) / (self.a * self.b * 2.0)
            here = f"the {place} place, {sqrt(square.middle()):.6g} mm from the pole,"
            need(c.lo <= 1 and c.hi >= -1, here + " is out of reach", Refuted)
            need(c.lo <= first.hi and c.hi >= last.lo, here + " is too near to a dead or change point, or beyond it", Refuted)
            need(c.hi < first.lo and c.lo > last.hi)
            ends.append((square.sqrt(), c))
        self.range, self.cosines = zip(*ends)
        return f" (transmission {task.transmission_deg:g} degrees, eps {EPS_DEG:g} degrees)"
    def seen(self, z):  # all joints from the pole, with the tracer at z
        place = self.shape.opened(self.a, self.b, self.shape.g * z, self.sign)["table"]
        return {joint: place(*constants) for joint, constants in self.shape.seen.items()}
    def clear(self):  # claim 2, or claim 5 with losses; in contact with itself the linkage may be turned about the pole
        need(self.range, "claim 1 comes first")
        task, pairs = self.task, []
        for other, one in combinations(JOINTS, 2):
            together, joined = share(one, other, self.layers, ()), not may_meet(one, other)
            need(not (together and joined and {one, other} <= set(LINKS)), f"{other}, {one} share a joint and a layer", Refuted)
            if not joined and (together or one.startswith("post") and other.startswith("post")):
                # Parallel to VB and ACX, or to VA and BCY: seen from there such parts do not turn.
                frame, wide = "ACX" if {"VB", "ACX"} & {one, other} else "VA", between(task, one, other)
                pairs += [Pair(other, A, one, B, frame, wide) for A, B in product(pieces(task, other), pieces(task, one))]
        for (i, block), part in product(enumerate(self.blocks), JOINTS):
            if share(part, i, self.layers, task.obstacles):
                wide, name = between(task, part), task.obstacles[i].name
                pairs += [Pair(part, one, name, ["pole"], "table", wide, edges_of(block), block) for one in pieces(task, part)]
        if self.data.get("bodies") or self.data.get("table"):
            pairs += beside("bodies_check").pairs_of(self)
        blocked, itself = ([pair for pair in pairs if (pair.frame == "table") == fixed] for fixed in (True, False))
        first, last = (self.range[0].lo, 0.0), (self.range[1].hi, 0.0)
        cover([[first, last, first]], itself, self.pending_in)
        self.keep_out(blocked)
        for rings in self.region[1:] if blocked else ():
            self.join(self.region[0][0], rings[0], blocked)
        return f" (clearance {task.clearance_mm:g} mm, eps {EPS_MM:g} mm)"
    def keep_out(self, pairs):
        """Parts keep away from rings, over the region. One that meets no edge is inside always or never: one place decides."""
        for rings in self.region if pairs else ():
            joints = self.seen(Z(*rings[0][0]))
            for pair in pairs:
                at = (joints[pair.joints[0]] - joints[pair.others[0]]).middle()
                inside = pair.rings(at) if callable(pair.rings) else where(at, pair.rings) > 0
                need(not inside, f"{pair.one} is inside {pair.other}", Refuted)
            cover(rings, pairs, self.pending_in)
    def pending_in(self, box, hull, pending):  # the pairs not proven apart over the hull; None if none is left and all closes
        m, slip, seen = tuple(0.5 * low + 0.5 * high for low, high in box), self.slip, self.shape.seen
        z = Z(*(I(low - slip, high + slip, {v: ONE}) for v, (low, high) in zip("xy", box)))
        try:
            moving, still = (self.shape.opened(self.a, self.b, self.shape.g * at, self.sign) for at in (z, Z(*m)))
            loss = self.losses(z)
        except Open:
            return pending
        ways = [{v: I(c - slip, c + slip) - o for v, c, o in zip("xy", corner, m)} for corner in hull]
        spot = cache(lambda joint, frame: still[frame](*seen[joint]).middle())
        @cache
        def way(i, j, frame):  # from joint to joint
            constants = [to - of for of, to in zip(seen[i], seen[j])]
            return cloud(still[frame](*constants), moving[frame](*constants), ways)
        left, todo = [], list(pending)
        while todo:
            pair = todo.pop()
            frame, ((x0, x1), (y0, y1)) = pair.frame, span(p for edge in pair.edges for p in edge)
            ends = pair.edges[0] if len(pair.edges) == 1 else ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
            clouds = {(i, j): way(i, j, frame) for i, j in product(pair.joints, pair.others)}
            P, Q = ([spot(joint, frame) for joint in some] for some in (pair.joints, pair.others))
            v = apart(P, [(q[0] + e[0], q[1] + e[1]) for q in Q for e in ends])
            gap, several = hypot(*v), len(pair.edges) // 2
            n = v[0] / (gap or 1.0), v[1] / (gap or 1.0)  # one direction that proves the two apart all over the cell
            far = min(n[0] * p[0] + n[1] * p[1] for p in ends)
            near = min(min(n[0] * p[0] + n[1] * p[1] for p in points) - radius - loss(n, pair, *joints)
                       for joints, (points, radius, _) in clouds.items())
            slack = 1e-14 * (abs(far) + abs(near) + max(abs(c) for p in ends for c in p)) + 4 * slip
            parted = gap and far + near >= pair.wide - EPS_MM + slack
            if not parted and several and dist(ends[0], ends[2]) > max(moved for *_, moved in clouds.values()):
                todo += [pair._replace(edges=some) for some in (pair.edges[:several], pair.edges[several:])]
            elif not parted:
                met = not several and gap < pair.wide - 2 * EPS_MM and (frame != "table" or within(m, self.region))
                need(not met, f"{pair.one} and {pair.other} come to {gap:.6g} mm from axis to axis with the tracer at "
                              f"({m[0]:.6g}, {m[1]:.6g}) from the pole; needed: {pair.wide:g}", Refuted)
                left.append(pair)
        return left or None
    def join(self, one, other, pairs):
        """Two polygons are joined if a way from corner to corner, straight or on a circle about the pole, is clear as well."""
        A, B = min(product(one[::1 + len(one) // 40], other[::1 + len(other) // 40]), key=lambda pq: dist(*pq))
        least, most, start, end = self.range[0].hi, self.range[1].lo, atan2(A[1], A[0]), atan2(B[1], B[0])
        for part, turns, steps in [(0, 0, 0), *product((0.5, 0.25, 0.75, 0.1, 0.9), (0, -1, 1), (401,))]:
            r, turn = least + part * (most - least), (end - start + 2 * pi * turns) / 400
            arc = [(r * cos(start + turn * i), r * sin(start + turn * i)) for i in range(steps)]
            try:
                for p, q in zip([A, *arc], [*arc, B]):
                    need(hypot(*to_segment((0.0, 0.0), p, q)) >= least - EPS_MM and max(hypot(*p), hypot(*q)) <= most + EPS_MM)
                    cover([[p, q, p]], pairs, self.pending_in)
                return
            except (Open, Refuted):
                continue
        raise Open("no way from polygon to polygon was found")

# Designs of a log, a box: ranges of a, b and the pole's x, y; cosines of the least and largest |psi|; layer assignments.
Node = namedtuple("Node", "box window assignments")
def corners(box, names): return product(*((box[v].lo, box[v].hi) for v in names))

class Certificate:
    """Claims 3 and 4: a log is read line by line, and every line must close or divide the next node."""
    def __init__(self, name, lines):
        self.data, self.lines, self.at = lines[0] if lines else None, lines, 0
        task = self.task = fits(self.data, LOG, name + ": ")
        self.blocks, self.by = task.obstacles, task.objective if task.claim == "bound" else None
        must((task.claim == "none") == (task.bound is None), name + ": bound", task.bound, "a number beside claim bound alone")
    def prove(self):
        for vertex in (v for v in VERTICES if v in self.task.groundings):
            self.shape = Shape(self.task, vertex)
            if self.data["task"].get("bodies") or self.data["task"].get("table"):
                self.blocks = self.task.obstacles + beside("bodies_check").blocks_of(self, vertex)
            for mode in range(self.shape.modes):
                (self.sign, self.sign_d), todo = self.shape.signs(mode), [self.root(mode)]
                while todo:
                    self.at += 1
                    try:
                        todo += reversed(self.step(todo.pop(), self.lines[self.at]))
                    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, Open, Unreadable) as fault:
                        raise Open(f"{vertex}, mode {mode}, line {self.at + 1}: {fault or 'nothing is decided'}") from None
        need(self.at == len(self.lines) - 1, f"line {self.at + 2}: all trees are closed")
        return f" ({self.at} nodes)"
    def root(self, mode):
        task, box = self.task, {}
        for v, factors in ("a", self.shape.of_a), ("b", self.shape.of_b):
            ends = [(I(low) / f, I(high) / f) for name, f in factors.items() for low, high in [permitted(task, name)]]
            box[v] = I(max(low.lo for low, _ in ends), min(high.hi for _, high in ends))
        box.update({v: I(*ends) for v, ends in zip("xy", span(corner for rings in task.pole for corner in rings[0]))})
        joined = [pair for pair in combinations(LINKS, 2) if not may_meet(*pair)]
        every = (dict(zip(LINKS, layers)) for layers in product(range(1, task.layers + 1), repeat=4))
        least = max(task.transmission_deg, self.task.bound if self.by == "transmission" else 0.0)
        return Node(box, self.shape.window(mode, least), [l for l in every if all(l[one] != l[other] for one, other in joined)])
    def step(self, node, line):  # the children of a node; none if its leaf refutes it
        if rule := next((rule for rule in ("split", "share", "contact", "copy_error") if rule in line), None):
            return getattr(self, rule)(node, line)
        need(getattr(self, "leaf_" + line["leaf"])(node, line), f"{line['leaf']} does not refute")
        return []
    def split(self, node, line):
        old, at = node.box[line["split"]], float(line["at"])
        need(old.lo < at < old.hi, f"{at} does not split {old.lo} to {old.hi}")
        return [node._replace(box={**node.box, line["split"]: part}) for part in (I(old.lo, at), I(at, old.hi))]
    def share(self, node, line):
        one, other = line["share"]
        need(one in JOINTS and (other in JOINTS or 0 <= other < len(self.blocks)), "unknown parts")
        return [node._replace(assignments=[l for l in node.assignments if share(one, other, l, self.blocks) == wanted])
                for wanted in (True, False)]
    def contact(self, node, line):
        u, (one, other) = I(float(line["u"])), line["contact"]
        keep_apart = may_meet(one[0], other[0]) and all(share(one[0], other[0], l, ()) for l in node.assignments)
        need(0 < u.lo < 1e9 and keep_apart, "these parts need not keep apart")
        turn = Z(ONE - u.square(), u * 2.0 * self.sign) / (u.square() + ONE)
        alpha, beta = (one - other for one, other in zip(self.material(one), self.material(other)))
        allowed = I(half(self.task, one[0])) + half(self.task, other[0]) + self.task.clearance_mm
        met = all((alpha * a + beta * (turn * b)).square().hi < allowed.square().lo for a, b in corners(node.box, "ab"))
        need(met, "the points are not in contact all over the box")
        return [node._replace(window=window) for window in ((node.window[0], turn.x), (turn.x, node.window[1]))]
    def copy_error(self, node, line): return beside("tolerance_check").cut(self, node, line)
    def material(self, named, origin="pole"):  # (alpha, beta) of a material point of a part, seen from a joint
        part, *t = named
        t, seen = [float(x) for x in t], [self.shape.seen[joint] for joint in JOINTS[part]]
        on_part = len(t) == len(seen) - 1 and all(0 <= x <= 1 for x in t) and sum(map(Fraction, t)) <= 1
        need(on_part and (len(t) < 2 or self.task.plate != "bent" or 0 in t), f"{named} is no point of a part")
        return [sum(((to - at) * x for x, to in zip(t, others)), start=at - o)
                for o, (at, *others) in zip(self.shape.seen[origin], zip(*seen))]
    @cache
    def place(self, value):  # a place of the region, as intervals
        if len(value) == 2:
            need(within(fits([*value], POINT, "place"), self.task.region), f"{value} is not in the region")
            return Z(*value)
        polygon, ring, corner, t = value
        need(min(polygon, ring, corner) >= 0 and 0 <= t <= 1, f"{value} is no place of the region")
        p, q = (Z(*c) for c in self.task.region[polygon][ring][corner:corner + 2])
        return p + (q - p) * float(t)
    def leaf_lengths(self, node, line): return any(i.lo > i.hi for i in node.box.values())
    def leaf_layers(self, node, line): return not node.assignments
    def leaf_sum(self, node, line):
        """A sum Q of requirements is negative all over the box: about its middle, Q has the squares k of x and y, l of a and b, and
        the product m of a and b; its slopes by x and y are -2 `pull`."""
        a, b, x, y = (I(node.box[v].middle()) for v in "abxy")
        (of_a, of_b), gg, P = self.shape.size, self.shape.gg, Z(x, y)
        Q, k, l, m, sizes, pull = ZERO, ZERO, ZERO, ZERO, ZERO, NIL
        # How often each has R, the square of the way to its place, 1 and the size
        terms = {"far": (ONE, -gg, ZERO, ZERO), "near": (-ONE, gg, ZERO, ZERO),
                 "posts": (ZERO, ONE, -self.shape.posts.square(), ZERO), "bound": (ZERO, ZERO, I(self.task.bound or 0.0), -ONE)}
        for name, *places, weight in line["of"]:
            need(0 <= weight < 1e9, "a weight is negative")
            need(name != "bound" or self.by == "size", "there is no bound")
            away, weight = NIL if name == "bound" else self.place(tuple(places[0])) - P, I(float(weight))
            of_R, of_way, rest, of_size = (weight * each if each else ZERO for each in terms[name])
            l, m, sizes = l + of_R, m + of_R * node.window[name == "near"], sizes + of_size
            Q, k, pull = Q + of_way * away.square() + rest, k + of_way, pull + away * of_way
        Q += l * (a.square() + b.square()) + m * a * b * 2.0 + sizes * (of_a * a + of_b * b)
        slopes = (l * a + m * b) * 2.0 + sizes * of_a, (l * b + m * a) * 2.0 + sizes * of_b, pull.x * 2.0, pull.y * 2.0
        reach = [I(max((I(node.box[v].hi) - at).hi, (at - node.box[v].lo).hi)) for v, at in zip("abxy", (a, b, x, y))]
        most = Q + I((m * 2.0).size()) * reach[0] * reach[1]
        for slope, h, q in zip(slopes, reach, (l, l, k, k)):
            g, q = I(slope.size()), I(q.hi)
            inside = q.hi < 0 and g.hi < (q * h * -2.0).lo
            most += g.square() / (q * -4.0) if inside else g * h + q * h.square()
        return most.hi < 0
    def leaf_pole(self, node, line):  # no edge of the pole's area comes near the box of poles, and a corner of it is not inside
        one, two, four, three = corners(node.box, "xy")
        edges = [edge for rings in self.task.pole for edge in edges_of(rings)]
        near = 1e-12 * largest([*self.task.pole, [[one, three]]])
        return not within(one, self.task.pole) and min(hypot(*apart([one, two, three, four], edge)) for edge in edges) > near
    def leaf_sheets(self, node, line):
        one, other = (self.place(tuple(p)) for p in line["places"])
        ways = [Z(*P) + self.shape.k * (one - Z(*P)) - other for P in corners(node.box, "xy")]
        return max(way.square().hi for way in ways) < I(self.task.sheets_gap_mm).square().lo
    def leaf_obstacle(self, node, line):
        """A part's point stays, over the box, within reach of a convex piece of an obstacle, or of a body seen from its joint."""
        index, (part, *t), edge, box = line["obstacle"], line["point"], line["edge"], node.box
        block, (ring, *holes) = self.blocks[index], self.blocks[index].rings
        meets = block.joint not in JOINTS[part] and all(share(part, index, l, self.blocks) for l in node.assignments)
        need(meets, "the part does not meet this obstacle")
        convex_piece = 0 <= edge < len(ring) - 1 if edge is not None else not holes and convex(ring)
        need(convex_piece, "the obstacle is not convex, or has no such edge")
        K, T = ring[:-1] if edge is None else ring[edge:edge + 2], self.place(tuple(line["place"]))
        constants = self.material((part, *t), block.joint)
        copied = any(at and joint in COPIED for joint, at in zip(JOINTS[part], (not any(t), *(x == 1 for x in t))))
        def point_at(a, b, x, y):
            w = self.shape.g * (T - Z(x, y))
            seen = w * constants[1] if copied else self.shape.opened(a, b, w, self.sign)["table"](*constants)
            return Z(x, y) * block.rest + seen
        names, middle = [v for v in "abxy" if box[v].lo < box[v].hi], {v: I(i.middle()) for v, i in box.items()}
        wide = {v: I(i.lo, i.hi, {v: ONE} if v in names else None) for v, i in box.items()}
        ways = [{v: c - middle[v] for v, c in zip(names, corner)} for corner in corners(box, names)]
        points, radius, _ = cloud(point_at(**middle), point_at(**wide), ways)
        slack = 1e-14 * max(abs(c) for p in points + K for c in p)  # beyond() is off by less
        allowed = (between(self.task, part) + block.beyond) * (1 - 1e-15)
        return any(all(beyond(p, [*some, some[0]]) + radius + slack < allowed for p in points)
                   for some in (K[::len(K) // 40 + 1], K))  # of a round obstacle some corners are mostly enough

def claim(name, proof):  # prints one claim's line; True if it is proven
    try:
        said = f"proven{proof() or ''}"
    except (Refuted, Open, ArithmeticError) as reason:
        said = ("refuted" if isinstance(reason, Refuted) else "not proven") + (": " + plain(reason) if str(reason) else "")
    print(f"{name}: {said}")
    return said.startswith("proven")
def once(pairs):
    need(len(dict(pairs)) == len(pairs), f"a key twice in {[key for key, _ in pairs]}", ValueError)
    return dict(pairs)
def read(name):  # the objects of a JSON or JSON lines file
    try:
        text = Path(name).read_text(encoding="utf-8").rstrip("\n")
        return [json.loads(part, object_pairs_hook=once) for part in (text.split("\n") if name.endswith(".jsonl") else [text])]
    except (OSError, ValueError, RecursionError) as fault:
        raise Unreadable(f"{name}: found {plain(fault)[:80]}; allowed: a file of JSON, each key once")
def main(names):
    need(len(names) in (1, 2), __doc__, Unreadable)
    files, claims = [read(name) for name in names], []
    try:
        design = None if names[0].endswith(".jsonl") else Design(names[0], files.pop(0)[0])
        log = Certificate(names[-1], files[0]) if files else None
    except Open as fault:
        raise Unreadable(f"{names[0]}: copy: found {fault}; allowed: a ratio that no shape of is degenerate")
    if design:
        title = "5 every instrument within the tolerances stays on one assembly mode and keeps the clearance"
        claims = [("1 every point is reached on one assembly mode", design.reached),
                  ("2 the parts keep their clearance", design.clear),
                  ("limits of the file", lambda: beside("limits_check").keep(design)),
                  (title, lambda: beside("tolerance_check").every_instrument(design))][:4 if design.task.robust else 3]
    if log:
        better = {"size": "smaller than {:.12g} mm", "transmission": "larger than {:.12g} degrees", None: ""}[log.by]
        title = "3 no design is " + better.format(log.task.bound) if log.by else "4 no design exists"
        claims.append((title, lambda: (design and beside("limits_check").match(log, design)) or log.prove()))
    good = all([claim(*each) for each in claims])
    if design:
        unread = sorted(design.data.keys() - {*SHARED, "format", "copy", "mechanism"})
        print("not looked at:", plain(", ".join(unread + ["claim 3, whose log is certificate.jsonl"] * (not log))))
    return good

if __name__ == "__main__":
    sys.modules["kempe_check"] = sys.modules["__main__"]  # for the files beside it
    try:
        sys.exit(0 if main(sys.argv[1:]) else 1)
    except Unreadable as message:
        print(message, file=sys.stderr)
        sys.exit(2)
