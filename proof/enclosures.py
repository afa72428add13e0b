"""Intervals, plane geometry, the search over cells and readers of values, for kempe_check.py and tolerance_check.py. Nothing here
knows of linkages.

Every result of interval arithmetic holds the exact one: + - * / and sqrt of doubles are rounded correctly (IEEE 754), and each
result is moved outwards by one step.
"""
import math
from collections import namedtuple
from fractions import Fraction
from itertools import product
from math import hypot, inf, nextafter

EPS_MM, EPS_DEG = 1e-6, 1e-6
AT_REST = {"joint": "pole", "beyond": 0.0, "rest": 1.0}  # seen from; what its rings are grown by; 1 in the table's frame
MOST_CELLS = 200_000  # of one search; then the answer is "not proven"


class Open(Exception):
    """Nothing is decided."""


class Refuted(Exception):
    """A claim is false, and why."""


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
        if not self or not o:
            return self or o
        return I(nextafter(self.lo + o.lo, -inf), nextafter(self.hi + o.hi, inf), total(self.d, o.d))

    def __mul__(self, o):
        o = o if o.__class__ is I else I(o)
        if not self or not o:
            return ZERO
        ends = (self.lo * o.lo, self.lo * o.hi, self.hi * o.lo, self.hi * o.hi)
        lo, hi = min(ends), max(ends)
        if not (lo > -1e150 and hi < 1e150):  # so no infinity comes up, and no NaN
            raise Open
        if self.size() and o.size():
            lo, hi = nextafter(lo, -inf), nextafter(hi, inf)
        return I(lo, hi, total(self.slopes_times(o), o.slopes_times(self)) if self.d or o.d else None)

    def __truediv__(self, o):
        o = o if o.__class__ is I else I(o)
        if not (o.lo > 1e-140 or o.hi < -1e-140):
            raise Open
        inverse = I(nextafter(1 / o.hi, -inf), nextafter(1 / o.lo, inf))
        inverse.d = o.slopes_times(-(inverse * inverse))
        return self * inverse

    __radd__, __rmul__ = __add__, __mul__

    def sqrt(self):
        if not self.lo >= 0:
            raise Open
        root = I(max(0.0, nextafter(math.sqrt(self.lo), -inf)), nextafter(math.sqrt(self.hi), inf))
        root.d = self.d and self.slopes_times(I(0.5) / root)
        return root

    def square(self):
        found = self * self
        return I(max(0.0, found.lo), found.hi, found.d)


class Z:
    """A complex number x + iy of two intervals."""
    __slots__ = ("x", "y")

    def __init__(self, x, y):
        self.x, self.y = x if x.__class__ is I else I(x), y if y.__class__ is I else I(y)

    def __neg__(self): return Z(-self.x, -self.y)
    def __add__(self, o): return Z(self.x + o.x, self.y + o.y)
    def __sub__(self, o): return Z(self.x - o.x, self.y - o.y)
    def times(self, o): return Z(self.x * o.x - self.y * o.y, self.x * o.y + self.y * o.x)
    def __mul__(self, o): return self.times(o) if o.__class__ is Z else Z(self.x * o, self.y * o)
    def __truediv__(self, o): return self * o.conj() / o.square() if o.__class__ is Z else Z(self.x / o, self.y / o)
    def conj(self): return Z(self.x, -self.y)
    def square(self): return self.x.square() + self.y.square()  # of the modulus
    def middle(self): return self.x.middle(), self.y.middle()


ZERO, ONE = I(0.0), I(1.0)
NIL, UNIT = Z(ZERO, ZERO), Z(ONE, ZERO)


def total(slopes, others):
    both = slopes and others
    return {**slopes, **{v: slopes[v] + x if v in slopes else x for v, x in others.items()}} if both else slopes or others


def unit_circle(degrees):
    """Cosine + i sine of decimal degrees: Taylor's series in whole multiples of 2^-160, the rest far below 2^-100."""
    quarters, rest = divmod(Fraction(degrees) % 360, 90)
    pi = Fraction("3.14159265358979323846264338327950288419716939937511")
    x, one = int((rest * pi / 180) * (1 << 160)), 1 << 160
    sums, term, n = [one, 0], one, 0
    while term:
        n += 1
        term = term * x // (n << 160)
        sums[n % 2] += term if n % 4 < 2 else -term
    c, s = (I(t / one) + I(-1e-40, 1e-40) if rest else I(float(t >> 160)) for t in sums)
    return [Z(c, s), Z(-s, c), Z(-c, -s), Z(s, -c)][int(quarters)]


# Plane geometry in doubles: exact where it decides, else a guess that is proven by intervals or kept away from by a slack.

def edges_of(rings):
    return [edge for ring in rings for edge in zip(ring, ring[1:])]


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
    for p, q in edges_of(rings):
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
    edges, others = ([(Q[i - 1], Q[i]) for i in range(len(Q))] for Q in (A, B))
    for p, around in ((A[0], others), (B[0], edges)):  # one inside the other?
        turns = [side(*edge, p) for edge in around] if len(around) > 2 else [0]
        if min(turns) > 0 or max(turns) < 0:
            return 0.0, 0.0
    for (a, b), (c, d) in product(edges, others):
        if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
            return 0.0, 0.0
    ways = [to_segment(p, *e) for p in A for e in others] + [(-x, -y) for x, y in (to_segment(p, *e) for p in B for e in edges)]
    return min(ways, key=lambda v: hypot(*v))


def convex(ring):
    """True if a closed ring, which is simple, turns one way only."""
    turns = [side(*corners) for corners in zip(ring, ring[1:], ring[2:] + ring[1:2])]
    return min(turns) >= 0 or max(turns) <= 0


def clip(corners, axis, at, keep):
    """The part of a polygon on one side of a line; corners on the line have its coordinate exactly."""
    out = []
    for p, q in zip(corners, corners[1:] + corners[:1]):
        u, v = keep * (p[axis] - at), keep * (q[axis] - at)
        out += [p] if u >= 0 else []
        if u < 0 < v or v < 0 < u:
            cut = [p[i] + u / (u - v) * (q[i] - p[i]) for i in (0, 1)]
            cut[axis] = at
            out.append(tuple(cut))
    return out


def squared_distances(origin, polygons):
    """The least and the largest to the polygons' edges: exact, then rounded outwards."""
    squares = []
    for edge in (edge for polygon in polygons for edge in edges_of(polygon)):
        (x, y), (u, v) = ([Fraction(c) - Fraction(o) for c, o in zip(p, origin)] for p in edge)
        along, length = x * (x - u) + y * (y - v), (x - u) ** 2 + (y - v) ** 2
        squares += [x * x + y * y] + [(x * v - y * u) ** 2 / length] * (0 < along < length)
    return [I(nextafter(float(square), -inf), nextafter(float(square), inf)) for square in (min(squares), max(squares))]


def ways_around(A, B, least, most):
    """Ways from A to B as lists of corners: straight, and on circles about the origin of radii from least to most."""
    yield [A, B]
    start, turn = math.atan2(A[1], A[0]), math.atan2(B[1], B[0]) - math.atan2(A[1], A[0])
    for part, t in product((0.5, 0.25, 0.75, 0.1, 0.9), (turn, turn - 2 * math.pi, turn + 2 * math.pi)):
        r, bearings = least + part * (most - least), (start + t * i / 400 for i in range(401))
        yield [A, *((r * math.cos(bearing), r * math.sin(bearing)) for bearing in bearings), B]


Tree = namedtuple("Tree", "corners size children")  # edges under rectangles; an edge itself has no children
SPOT = Tree([(0.0, 0.0)], 0.0, ())


def tree_of(edges):
    if len(edges) == 1:
        return Tree(edges[0], 0.0, ())
    (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*(p for e in edges for p in e)))
    children = tree_of(edges[:len(edges) // 2]), tree_of(edges[len(edges) // 2:])
    return Tree([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], math.dist((x0, y0), (x1, y1)), children)


def cover(parts, pending, rings, pending_in):
    """Cells of a polygon, halved until nothing is pending in any. `rings`: the polygon's, if it is not convex."""
    (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*parts[0]))
    todo, cells = [([x0, x1, y0, y1], parts, pending)], 0
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


def cloud(still, moving, ways):
    """Places whose hull, grown by a radius, holds a point over a cell (mean value theorem); the radius; how far the point moves."""
    slopes = moving.x.d or {}, moving.y.d or {}
    ends = [still + Z(*(sum((d.get(v, ZERO) * x for v, x in way.items()), ZERO) for d in slopes)) for way in ways]
    points, middle = [e.middle() for e in ends], still.middle()
    radius = 0.5 * (1 + 1e-15) * max(hypot(nextafter(e.x.hi - e.x.lo, inf), nextafter(e.y.hi - e.y.lo, inf)) for e in ends)
    return points, radius, max(math.dist(p, middle) for p in points)


def corners(box, names):
    """Of a box of intervals by name."""
    return product(*((box[v].lo, box[v].hi) for v in names))


# Readers of values: each returns what it was given, or raises ValueError with what is allowed.

def must(good, value, allowed):
    if not good:
        raise ValueError(allowed)
    return value


def number(low=-1e9, high=1e9, kinds=(int, float)):
    return lambda value: must(type(value) in kinds and low <= value <= high, value, f"a number from {low} to {high}")


def word(*among):
    return lambda value: must(value in among, value, " or ".join(map(str, among)))


def optional(reader):
    return lambda value: None if value is None else reader(value)


def listed(reader, length=None):
    return lambda value: [reader(each) for each in must(isinstance(value, list) and length in (None, len(value)), value, "a list")]


def point(value):
    return tuple(listed(number(-2e7, 2e7), 2)(value))


def polygons(value):
    found = listed(listed(listed(point)))(must(value["type"] == "MultiPolygon", value, "a MultiPolygon")["coordinates"])
    for polygon in found:
        must(polygon and all(len(r) > 3 and r[0] == r[-1] for r in polygon), found, "closed rings of three corners and more")
        must(all(where(c, polygon[:1]) >= 0 for hole in polygon[1:] for c in hole), found, "holes inside their polygon")
    return found
