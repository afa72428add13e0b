#!/usr/bin/env python3
"""Instruments that are wrong: every length off, every pin off its hole's centre, closed numerically. Twelve equations (five
connections and the tracer, two coordinates each) in the places and turns of four links, solved by Newton's method from the nominal
position; no formula of the checker is used.

usage: instruments.py design.json COUNT [SEED]     the smallest gap of random and of worst instruments, and the largest copy error
"""
import cmath
import json
import math
import random
import sys

import mutations

LENGTHS = ("VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY")
PINS = "PVABC"
LINKS = ("VA", "VB", "ACX", "BCY")


class Broken(Exception):
    """The loops cannot be closed."""


def solved(matrix, right):
    """Gauss's elimination with pivots."""
    n, rows = len(right), [list(row) + [r] for row, r in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda j: abs(rows[j][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        if abs(rows[i][i]) < 1e-14:
            raise Broken
        for j in range(i + 1, n):
            f = rows[j][i] / rows[i][i]
            if f:
                rows[j] = [x - f * y for x, y in zip(rows[j], rows[i])]
    out = [0.0] * n
    for i in reversed(range(n)):
        out[i] = (rows[i][n] - sum(rows[i][j] * out[j] for j in range(i + 1, n))) / rows[i][i]
    return out


def is_flat(s):
    """docs/tolerance.md: height over the longest side below 1/20 of the shortest."""
    sides = sorted((1.0, abs(s), abs(1 - s)))
    return abs(s.imag) / sides[2] < sides[0] / 20


class Instrument:
    """`off`: what is wrong, by a length's name (mm, of a flat plate's CX or CY: out of line) or a pin's letter (complex mm)."""

    def __init__(self, judge, off):
        self.judge, self.off, s = judge, off, judge.s
        nominal = {"VA": judge.a, "BC": judge.a, "BY": abs(s) * judge.a, "CY": abs(1 - s) * judge.a,
                   "VB": abs(s) * judge.b, "AC": abs(s) * judge.b, "AX": judge.b, "CX": abs(1 - s) * judge.b}
        self.flat = is_flat(s)
        L = {n: nominal[n] + (0.0 if self.flat and n in ("CX", "CY") else off.get(n, 0.0)) for n in LENGTHS}
        self.links = {"VA": {"V": 0j, "A": L["VA"] + 0j}, "VB": {"V": 0j, "B": L["VB"] + 0j},
                      "ACX": {"A": 0j, "C": L["AC"] + 0j, "X": self.tip(L["AC"], L["AX"], L["CX"], 1 / s, nominal["AC"], "CX")},
                      "BCY": {"B": 0j, "C": L["BC"] + 0j, "Y": self.tip(L["BC"], L["BY"], L["CY"], s, nominal["BC"], "CY")}}
        self.e = {pin: off.get(pin, 0j) for pin in PINS}

    def tip(self, base, side, far, s, nominal, third):
        """The third hole of a plate from its corner, the second hole on the axis."""
        if self.flat:
            height = (s * nominal).imag + self.off.get(third, 0.0)
            return complex(math.copysign(math.sqrt(side * side - height * height), s.real), height)
        angle = math.acos((base * base + side * side - far * far) / (2 * base * side))
        return cmath.rect(side, math.copysign(angle, s.imag))

    def residuals(self, at, T):
        """Of the twelve equations, with the links' places and turns `at`."""
        P, vertex, e, H = self.judge.pole, self.judge.vertex, self.e, self.holes(at)
        on_pole, tracer = ("VA", "V") if vertex == "pole" else ("ACX", "X"), {"pole": ("ACX", "X"), "tracer": ("VA", "V"), "pen": ("BCY", "Y")}
        pin_v = P if vertex == "pole" else H["VA", "V"]
        gaps = [H[on_pole] - P - e["P"], H["VB", "V"] - pin_v - e["V"], H["ACX", "A"] - H["VA", "A"] - e["A"],
                H["BCY", "B"] - H["VB", "B"] - e["B"], H["BCY", "C"] - H["ACX", "C"] - e["C"], H[tracer[vertex]] - T]
        return [c for g in gaps for c in (g.real, g.imag)]

    def holes(self, at):
        return {(link, j): complex(at[3 * i], at[3 * i + 1]) + z * cmath.exp(1j * at[3 * i + 2])
                for i, link in enumerate(LINKS) for j, z in self.links[link].items()}

    def closed(self, T):
        """Where the holes are with the tracer at T, from the nominal position by small steps of what is off."""
        joints = self.judge.pose(T)
        if not joints:
            raise Broken
        at = []
        for link in LINKS:
            p, q = joints[0][link[0]], joints[0][link[1]]
            at += [p.real, p.imag, cmath.phase(q - p)]
        for _ in range(30):
            now = self.residuals(at, T)
            if max(map(abs, now)) < 1e-11:
                return self.holes(at)
            h = 1e-7
            columns = [[(x - y) / h for x, y in zip(self.residuals(at[:i] + [at[i] + h] + at[i + 1:], T), now)] for i in range(12)]
            at = [x - d for x, d in zip(at, solved(list(zip(*columns)), now))]
        raise Broken

    def gaps(self, T):
        """Of the parts that may not touch: (names, gap) of each pair, obstacles among them."""
        H, m, P = self.closed(T), self.judge.m, self.judge.pole
        pole = "V" if self.judge.vertex == "pole" else "X"
        parts = []
        for name, strokes, layers, half, joints in mutations.parts_of(m):
            if name in LINKS:
                segments = [(H[name, s[0]], H[name, s[1]]) for s in strokes]
            elif name[-1] == pole:
                segments = [(P, P)]
            elif name in ("pin V", "post V"):
                segments = [(H["VA", "V"],) * 2]
            elif name.startswith("pin"):
                segments = [(z, z) for (link, j), z in H.items() if j == name[-1]]
            else:
                segments = [(H["ACX" if name[-1] == "X" else "BCY", name[-1]],) * 2]
            parts.append((name, segments, layers, half, joints))
        out = {}
        for i, p in enumerate(parts):
            for q in parts[:i]:
                if not p[4] & q[4] and (p[2] & q[2] or p[0].startswith("post") and q[0].startswith("post")):
                    out[p[0], q[0]] = min(mutations.between(*u, *v) for u in p[1] for v in q[1]) - p[3] - q[3]
            for o in self.judge.design["obstacles"]:
                if any(o["layers"][0] <= n <= o["layers"][1] for n in p[2]):
                    edges = [e for ring in mutations.rings_of(o["shape"])[0] for e in zip(ring, ring[1:])]
                    out[p[0], o["name"]] = min(mutations.between(*u, *e) for u in p[1] for e in edges) - p[3]
        return out

    def pen(self, T):
        H = self.closed(T)
        return H["VA", "V"] if self.judge.vertex == "pen" else H["BCY", "Y"]


def random_off(chance, length, play):
    """Lengths at their limits or within, pins at their holes' walls or within."""
    at_limits = chance.random() < 0.7
    share = (lambda: 1.0) if at_limits else chance.random
    off = {n: length * share() * chance.choice((-1, 1)) for n in LENGTHS}
    return off | {p: cmath.rect(0.5 * play * share(), chance.uniform(0, 2 * math.pi)) for p in PINS}


def worst_off(judge, length, play, T, value):
    """What is off in the worst way for a value of an instrument, by its differences at the nominal one."""
    step, start, off = 1e-4, value(Instrument(judge, {})), {}
    for n in LENGTHS:
        off[n] = math.copysign(length, start - value(Instrument(judge, {n: step})))
    for p in PINS:
        slope = complex(*(start - value(Instrument(judge, {p: step * u})) for u in (1, 1j)))
        off[p] = 0.5 * play * slope / abs(slope) if slope else 0j
    return off


def smallest_gap(design, count, chance):
    """The smallest gap of any pair, over random instruments and for every pair the worst of its tightest places."""
    judge, tolerance = mutations.Judge(design), design["tolerance"]
    length, play = tolerance["length_mm"], tolerance["play_mm"]
    places = list(mutations.places(judge.region))
    least = min((Instrument(judge, random_off(chance, length, play)).gaps(chance.choice(places)) for _ in range(count)),
                key=lambda gaps: min(gaps.values(), default=math.inf))
    least = min(least.values(), default=math.inf)
    nominal = [(T, Instrument(judge, {}).gaps(T)) for T in places]
    for pair in nominal[0][1]:
        for T, _ in sorted(nominal, key=lambda n: n[1][pair])[:2]:
            off = worst_off(judge, length, play, T, lambda one: one.gaps(T)[pair])
            least = min(least, *Instrument(judge, off).gaps(T).values())
    return least


def slopes_of_pen(judge, T):
    """The pen's deviation by each length, from differences."""
    h = 1e-4
    return {n: (Instrument(judge, {n: h}).pen(T) - Instrument(judge, {n: -h}).pen(T)) / (2 * h) for n in LENGTHS}


def largest_copy_error(design):
    """Of first order: the longest vector, over directions, of the differences of the pen's place; at the nearest and farthest places."""
    judge, tolerance = mutations.Judge(design), design["tolerance"]
    places = sorted(mutations.places(judge.region), key=lambda T: abs(T - judge.pole))
    largest, h = 0.0, 1e-4
    for T in places[:1] + places[-1:]:
        slopes = slopes_of_pen(judge, T)
        pins = [[(Instrument(judge, {p: h * u}).pen(T) - Instrument(judge, {p: -h * u}).pen(T)) / (2 * h) for u in (1, 1j)] for p in PINS]
        for i in range(720):
            u = cmath.rect(1, math.pi * i / 720)
            along = [tolerance["length_mm"] * abs((z * u.conjugate()).real) for z in slopes.values()]
            along += [0.5 * tolerance["play_mm"] * math.hypot(*((z * u.conjugate()).real for z in pin)) for pin in pins]
            largest = max(largest, sum(along))
    return largest


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        given = json.load(file)
    print("smallest gap", smallest_gap(given, int(sys.argv[2]), random.Random(int((sys.argv + ["1"])[3]))))
    print("largest copy error", largest_copy_error(given))
