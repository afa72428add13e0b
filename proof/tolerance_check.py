"""The part of kempe_check.py that tolerances need: claim 5 (every instrument) and the limit on the copy error. It is imported for a
design or a log that asks for one of the two. The theorems stand in docs/proof.md.
"""
import math
from itertools import product
from math import hypot

from kempe_check import EPS_MM, NIL, ONE, UNIT, ZERO, I, Open, Refuted, Z, cover, fits

# A joint has a hole in each of its links, which play sets apart. Capitals: the first link of PINS; small letters: the second.
HOLES = {"VA": "VA", "VB": "vB", "ACX": "aCX", "BCY": "bcY", "pin A": "Aa", "pin B": "Bb", "pin C": "Cc"}
STAGES = (0.25, 0.5, 0.75, 1.0)  # of the way from the nominal instrument to another, evenly spaced


def apex(d, left, right, sign):
    """The third corner of a triangle on the base from 0 to 1, d: the base's square, by Heron. That there are slopes proves that
    its height does not vanish."""
    f = ONE / d
    h = (((left + right).square() * f - 1.0) * (1.0 - (left - right).square() * f)).sqrt() * sign
    return Z((left.square() - right.square()) * f + 1.0, h) * 0.5


def box_of(z):
    """Middles and half widths of a complex interval, in doubles, with more than their rounding."""
    return *z.middle(), *(0.5 * (c.hi - c.lo) + 1e-15 * c.size() for c in (z.x, z.y))


def slopes_of(way):
    x, y = way.x.d or {}, way.y.d or {}
    return {v: box_of(Z(x.get(v, ZERO), y.get(v, ZERO))) for v in {**x, **y}}


class Tolerances:
    """Of a design whose claim 1 is proven, or of a log at one of its roots (kempe_check.Design, kempe_check.Certificate)."""

    def __init__(self, design):
        self.design, self.shape, self.sign, self.sign_d = design, design.shape, design.sign, design.sign_d
        self.length, self.play, s = design.task.length_mm or 0.0, design.task.play_mm or 0.0, design.shape.s
        sides = [x.middle() for x in (ONE, self.shape.abs_s, self.shape.abs_1s)]
        self.flat = 20 * abs(s.y.middle()) < max(sides) * min(sides)
        self.spots = {"A": NIL, "B": NIL, "C": UNIT, "X": UNIT / s, "Y": s}  # in the plates' frames, in units of AC and BC

    def loss(self, n, slopes, wide=1):
        """How far all that the tolerances let vary can move a way along n; with wide = -1 how far at least."""
        def slope(variable):
            x, y, dx, dy = slopes.get(variable, (0.0, 0.0, 0.0, 0.0))
            return max(0.0, abs(n[0] * x + n[1] * y) + wide * (abs(n[0]) * dx + abs(n[1]) * dy))
        pins = sum(hypot(slope(j + "x"), slope(j + "y")) for j in "PVABC") if self.play else 0.0
        lengths = sum(map(slope, (*self.shape.of_a, *self.shape.of_b)))
        return (1 + wide * 1e-14) * (self.length * lengths + 0.5 * self.play * pins)

    # Claim 5

    def losses(self, z):
        """For a cell of the tracer's places: how much shorter along n a pair's way between joints may be than nominal."""
        wrong, slopes = [self.instrument(z.square().sqrt(), z, stage) for stage in STAGES], {}

        def loss(n, pair, *joints):
            found = 0.0
            for i, j in product(self.holes(pair.one, joints[0]), self.holes(pair.other, joints[1])):
                if (i, j, pair.frame) not in slopes:
                    slopes[i, j, pair.frame] = [slopes_of(way(i, j) * turns[pair.frame]) for way, turns in wrong]
                found = max(found, sum(self.loss(n, each) for each in slopes[i, j, pair.frame]) / len(STAGES))
            return found
        return loss

    def holes(self, part, joint):
        if joint == "pole":
            return "P"
        if not part.startswith(("pin", "post")):
            return HOLES[part][part.index(joint)]
        return "P" if joint == ("V" if self.shape.vertex == "pole" else "X") else HOLES.get(part, joint)

    def instrument(self, r, z, stage=1.0):
        """All instruments within a share of the tolerances, the tracer on the axis at r, triangle by triangle, with slopes by all
        that may be wrong: the ways from hole to hole, and the turns into the frames of links."""
        r = I(r.lo, r.hi)
        reach, still, signs = {}, self.design.seen(Z(r, ZERO)), (self.sign, self.sign_d)

        still.update({j.lower(): still[j] for j in "VABC"}, P=NIL)

        def off(value, by, name):
            reach[name] = I(-by * stage, by * stage)
            return value + I(-by * stage, by * stage, {name: ONE}) if by else value

        def way(i, j, at_i, at_j):  # by the mean value theorem often narrower than the difference
            def narrowed(c, exact):
                about = sum((slope * reach[v] for v, slope in (c.d or {}).items()), exact)
                return I(max(c.lo, about.lo), min(c.hi, about.hi), c.d)
            found, exact = at_j - at_i, still[j] - still[i]
            return Z(narrowed(found.x, exact.x), narrowed(found.y, exact.y))

        def dyad(i, j, at_i, at_j, left, right, sign):  # the joint of two bars that hang at i and j
            base = way(i, j, at_i, at_j)
            return at_i + base * apex(base.square(), L[left], L[right], sign)

        def third(o, p, q, at_o, at_p):  # hole q of a plate whose holes o and p are given
            turn = (spots[q] - spots[o]) / (spots[p] - spots[o])
            if self.length and not self.flat:
                side, one, other = (L["".join(sorted(n))] for n in (o + p, o + q, p + q))
                turn = apex(side.square(), one, other, 1.0 if turn.y.lo > 0 else -1.0)
            return at_o + way(o, p, at_o, at_p) * turn

        L = {name: off(x, self.length, name) for name, x in self.design.exact.items()}
        e = {j: Z(*(off(ZERO, 0.5 * self.play, j + c) for c in "xy")) for j in "PVABC"}
        spots, vertex = dict(self.spots), self.shape.vertex
        if self.flat and self.length:
            for tip, corner in (("X", "A"), ("Y", "B")):
                height = off(spots[tip].y * self.design.exact[corner + "C"], self.length, "C" + tip)
                along = (L[corner + tip].square() - height.square()).sqrt() * (1.0 if self.shape.s.x.lo > 0 else -1.0)
                spots[tip] = Z(along, height) / L[corner + "C"]
                L["C" + tip] = (spots[tip] - UNIT).square().sqrt() * L[corner + "C"]
        T = Z(r, ZERO)
        if vertex == "pen":
            X, Y = e["P"], T
            C = dyad("X", "Y", X, Y - e["C"], "CX", "CY", signs[0])
            c = C + e["C"]
            a, b = third("C", "X", "A", C, X), third("C", "Y", "B", c, Y)
            A, B = a - e["A"], b - e["B"]
            V = dyad("A", "B", A, B - e["V"], "VA", "VB", signs[1])
            v = V + e["V"]
        else:
            V, X, v = (e["P"], T, e["V"]) if vertex == "pole" else (T, e["P"], T + e["V"])
            A = dyad("V", "X", V, X - e["A"], "VA", "AX", -signs[0])
            a = A + e["A"]
            C = third("A", "X", "C", a, X)
            c = C + e["C"]
            B = dyad("V", "C", v, c - e["B"], "VB", "BC", signs[1])
            b = B + e["B"]
            Y = third("B", "C", "Y", b, c)
        at = {"V": V, "v": v, "A": A, "a": a, "B": B, "b": b, "C": C, "c": c, "X": X, "Y": Y, "P": NIL}
        turns = {"ACX": way("a", "C", a, C).conj() / L["AC"], "VA": way("V", "A", V, A).conj() / L["VA"],
                 "table": Z(I(z.x.lo, z.x.hi), I(z.y.lo, z.y.hi)) / r}
        return lambda i, j: way(i, j, at[i], at[j]), turns

    # The limit on the copy error

    def copy_error(self):
        """The limit is kept from the nearest to the farthest place: over cells of cos psi."""
        if not self.design.range:
            raise Open("claim 1 comes first")
        self.over_cells([end for cosine in self.design.cosines for end in (cosine.lo, cosine.hi)], self.too_wrong_in)

    def exceeded(self, *cosines):
        """No opening between these cosines of psi keeps the limit."""
        self.over_cells(cosines, self.not_surely_wrong_in)

    def over_cells(self, cosines, pending_in):
        if not (self.length or self.play):
            raise Open("limits.copy_error_mm without a tolerance")
        first, last = (max(-1.0, min(cosines)), 0.0), (min(1.0, max(cosines)), 0.0)
        cover([[first, last, first]], (), pending_in)

    def too_wrong_in(self, box, hull, pending):
        """None if the copy error keeps its limit all over a cell of cos psi."""
        limit = self.design.task.copy_error_mm
        sine, slopes = self.sources(I(*box[0]))
        if sine.lo > 0 and not self.exceeding(slopes, (limit + EPS_MM) * sine.lo):
            return None
        sine, slopes = self.sources(I(hull[0][0]))
        if self.exceeding(slopes, (limit + 2 * EPS_MM) * sine.hi, -1):
            raise Refuted(f"copy error above {limit:g} mm at the opening {math.degrees(math.asin(min(1, sine.hi))):.6g} degrees")
        return pending

    def not_surely_wrong_in(self, box, hull, pending):
        """None if the copy error is above its limit all over a cell of cos psi."""
        limit = self.design.task.copy_error_mm
        sine, slopes = self.sources(I(*box[0]))
        if self.exceeding(slopes, limit * max(0.0, sine.hi), -1):
            return None
        sine, slopes = self.sources(I(hull[0][0]))
        if not self.exceeding(slopes, limit * sine.hi):
            raise Open(f"the limit on the copy error is kept where cos psi is {hull[0][0]}")
        return pending

    def sources(self, cosine):
        """|sin d|; and the pen's deviation by each length and by each coordinate of each pin times |sin d| and a constant of length
        1, from cos psi (docs/tolerance.md: D). A flat plate's third hole is off at right angles to its line."""
        s, i = self.shape.s, Z(ZERO, ONE)
        e = Z(cosine, ((1.0 - cosine) * (cosine + 1.0)).sqrt() * float(self.sign)) * s / self.shape.abs_s  # the turn by d
        t, sine = UNIT - s, Z(e.y, ZERO)
        it, by_pin_A = i * t * e.x, t * Z(e.y, -e.x)

        def tip(far, near):  # how the tip moves by its plate's lengths; to it from the two others
            u, v = far / far.square().sqrt(), i if self.flat else near / near.square().sqrt()
            c = (u.conj() * v).y
            by_far = i * u / c
            return by_far * v.x, -(i * v) / c, by_far

        xi, eta = tip(s.conj(), t * s.conj()), tip(s, -t)
        out = {"VA": by_pin_A, "VB": i * t, "AC": e * sine * (UNIT - s * xi[0]) - i * t, "BC": (eta[0] - UNIT) * sine + it,
               "AX": s * xi[1] * e * sine, "CX": s * xi[2] * e * sine, "BY": eta[1] * sine, "CY": eta[2] * sine,
               "Ax": by_pin_A, "Bx": it, "By": i * t * sine, "Cx": sine - it, "Cy": i * s * sine, "Vx": it, "Vy": i * t * sine}
        out.update({"Px": by_pin_A} if self.shape.vertex == "pole" else {"Px": s * sine, "Py": i * s * sine})
        factor = ONE / self.shape.abs_1s if self.shape.vertex == "pen" else ONE
        return e.y * float(self.sign_d), {name: box_of(way * factor) for name, way in out.items()}

    def exceeding(self, slopes, limit, wide=1):
        """True if some deviation may be above the limit; with wide = -1, if one is. Between the directions u and v none is longer
        than what all can do along w = u + v, divided by the smaller of u.w and v.w."""
        todo = [((1.0, 0.0), (0.0, 1.0)), ((0.0, 1.0), (-1.0, 0.0))]
        while todo:
            u, v = todo.pop()
            w = u[0] + v[0], u[1] + v[1]
            most, size = self.loss(w, slopes, wide), hypot(*w)
            if most > limit * size * (1 - wide * 1e-12):
                return True
            if most > limit * min(u[0] * w[0] + u[1] * w[1], v[0] * w[0] + v[1] * w[1]) * (1 - 1e-12):
                m = w[0] / size, w[1] / size
                todo += [(u, m), (m, v)]
        return False


def every_instrument(design):
    """Claim 5: claim 2 with what the tolerances may take off every way."""
    design.losses = Tolerances(design).losses
    return f" (lengths within {design.task.length_mm or 0:g} mm, play {design.task.play_mm or 0:g} mm)" + design.clear()


def cut(log, node, line):
    """A rule of claims 3 and 4: openings before the first and after the second cosine exceed the limit on the copy error; that is
    all of them, if the first is no larger."""
    (start, end), tolerances = node.window, Tolerances(log)
    first, last = fits(line["copy_error"], [(-1.0, 1.0)] * 2, "copy_error")
    for low, high in ((first, start.hi), (end.lo, last)):
        if low < high:
            tolerances.exceeded(low, high)
    left = I(first) if first < start.hi else start, I(last) if last > end.lo else end
    return [node._replace(window=left)] if first > last else []
