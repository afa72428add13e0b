#!/usr/bin/env python3
"""The synthesis problem written a second time, plainly, for SciPy's differential evolution.

Shares no code with Kempe: the linkage is built point by point. What the whole region asks of the linkage is exact: its
nearest and farthest point from the pole give the openings that are used, and at their ends the transmission is least.
Contact within the linkage depends on the opening alone and is looked at for a row of openings, ends included.
Obstacles are left out. Used to compare objective and CPU time.

usage: differential_evolution.py SPEC.toml [--seeds N] [--iterations N]
Prints one JSON object: the best objective found, CPU seconds, evaluations.
"""
import argparse
import cmath
import itertools
import json
import math
import sys
import time
import tomllib

import numpy as np
from scipy.optimize import differential_evolution

LINKS = ["VA", "VB", "ACX", "BCY"]
JOINTS = {"VA": "VA", "VB": "VB", "ACX": "ACX", "BCY": "BCY"}


OPENINGS = 33


class Region:
    """Polygons or a disc: distances from a point, and from its own copy."""

    def __init__(self, region):
        self.disc, self.rings = None, []
        if "circle_mm" in region:
            self.disc = (complex(*region["circle_mm"]["centre"]), region["circle_mm"]["radius"])
            return
        if "rectangle_mm" in region:
            (x, y), (w, h) = region["rectangle_mm"]["at"], region["rectangle_mm"]["size"]
            rings = [[(x, y), (x + w, y), (x + w, y + h), (x, y + h)]]
        else:
            rings = region["polygon_mm"]
            rings = [rings] if isinstance(rings[0][0], (int, float)) else rings
        self.rings = [[complex(*p) for p in ring] for ring in rings]
        self.a = np.array([p for ring in self.rings for p in ring])
        self.b = np.array([p for ring in self.rings for p in ring[1:] + ring[:1]])

    def holds(self, z):
        return abs(z - self.disc[0]) <= self.disc[1] if self.disc else inside(self.rings, z)

    def reach(self, z):
        """Nearest and farthest distance of the region from a point outside it."""
        if self.disc:
            away = abs(z - self.disc[0])
            return away - self.disc[1], away + self.disc[1]
        return point_segment(z, self.a, self.b).min(), np.abs(self.a - z).max()

    def gap_to_copy(self, pole, k):
        """Distance between region and copy; 0 where they overlap."""
        if self.disc:
            centre = pole + k * (self.disc[0] - pole)
            return max(0, abs(centre - self.disc[0]) - self.disc[1] * (1 + abs(k)))
        a, b = pole + k * (self.a - pole), pole + k * (self.b - pole)
        if self.holds(a[0]) or inside([list(a)], self.a[0]):
            return 0
        return segment_segment(self.a[:, None], self.b[:, None], a[None, :], b[None, :]).min()


def inside(rings, z):
    odd = False
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            if (a.imag > z.imag) != (b.imag > z.imag) and z.real < a.real + (z.imag - a.imag) * (b.real - a.real) / (b.imag - a.imag):
                odd = not odd
    return odd


def point_segment(p, a, b):
    ab = b - a
    t = np.clip(((p - a) * np.conj(ab)).real / np.maximum(np.abs(ab) ** 2, 1e-300), 0, 1)
    return np.abs(p - a - t * ab)


def segment_segment(a, b, c, d):
    cross = lambda u, v: u.real * v.imag - u.imag * v.real
    crossing = (cross(b - a, c - a) * cross(b - a, d - a) < 0) & (cross(d - c, a - c) * cross(d - c, b - c) < 0)
    apart = np.minimum(np.minimum(point_segment(a, c, d), point_segment(b, c, d)),
                       np.minimum(point_segment(c, a, b), point_segment(d, a, b)))
    return np.where(crossing, 0, apart)


def layer_choices(layers):
    for choice in itertools.product(range(1, layers + 1), repeat=4):
        va, vb, acx, bcy = choice
        if va != vb and va != acx and vb != bcy and acx != bcy and set(choice) == set(range(1, max(choice) + 1)):
            yield dict(zip(LINKS, choice))


class Problem:
    def __init__(self, spec):
        copy = spec["copy"]
        self.k = cmath.rect(copy.get("scale", 1), math.radians(copy.get("rotation_deg", 0)))
        if abs(self.k.imag) < 1e-12 * abs(self.k):
            self.k = complex(self.k.real, 0)
        self.region = Region(spec["region"])
        links, limits = spec.get("links", {}), spec.get("limits", {})
        self.width, self.pin = links.get("width_mm", 12), links.get("pin_diameter_mm", 6)
        self.plate, self.layers = links.get("plate", "bent"), links.get("layers", 2)
        hole_distance = self.pin + max(0, spec.get("cutting", {}).get("hole_fit_mm", 0)) + links.get("wall_mm", self.pin / 10)
        self.shortest, self.longest = max(links.get("shortest_mm", 15), hole_distance), links.get("longest_mm", 400)
        self.clearance = limits.get("clearance_mm", 0.5)
        self.transmission = math.radians(limits.get("transmission_deg", 30))
        self.sheets_gap = limits.get("sheets_gap_mm")
        pole = spec.get("pole", {"at_mm": [0, 0]})
        self.pole_at = complex(*pole["at_mm"]) if "at_mm" in pole else None
        if self.pole_at is None:
            rings = pole["within_mm"]
            rings = [rings] if isinstance(rings[0][0], (int, float)) else rings
            self.pole_rings = [[complex(*p) for p in ring] for ring in rings]
        self.maximize = spec.get("objective", {}).get("maximize") == "transmission"
        self.groundings = spec.get("objective", {}).get("groundings", ["pole", "tracer", "pen"])
        self.evaluations = 0

    def bounds(self):
        b = [(math.log(1), math.log(self.longest))] * 2
        if self.pole_at is None:
            z = np.array([p for ring in self.pole_rings for p in ring])
            b += [(z.real.min(), z.real.max()), (z.imag.min(), z.imag.max())]
        return b

    def choices(self):
        for vertex in self.groundings:
            for elbow, side in itertools.product((1, -1), (1, -1)):
                for layers in layer_choices(self.layers):
                    yield vertex, elbow, side, layers

    def cost(self, u, vertex, elbow, side, layers):
        """Objective plus penalties for every limit that is broken."""
        self.evaluations += 1
        VA, VB = math.exp(u[0]), math.exp(u[1])
        pole = self.pole_at if self.pole_at is not None else complex(u[2], u[3])
        k = self.k
        s = {"pole": k, "tracer": 1 - k, "pen": 1 - 1 / k}[vertex]
        lengths = [VA, VB, VB / abs(s), VB * abs(1 - s) / abs(s), VA * abs(s), VA * abs(1 - s)]
        broken = sum(max(0, self.shortest - l) + max(0, l - self.longest) for l in lengths)
        if self.pole_at is None and not inside(self.pole_rings, pole):
            broken += 1
        if self.region.holds(pole):
            return 1e6
        if self.sheets_gap is not None:
            broken += max(0, self.sheets_gap - self.region.gap_to_copy(pole, k))
        reach = np.array(self.region.reach(pole)) * {"pole": 1, "tracer": 1, "pen": abs(k)}[vertex]
        a, b = VA, VB / abs(s)
        ends = (a * a + b * b - reach ** 2) / (2 * a * b)  # cosine of the angle V A X
        outside = np.maximum(np.abs(ends) - 1, 0)
        if outside.max() > 0:
            return 1e5 * (1 + outside.max())
        cosine = np.cos(np.linspace(*np.arccos(ends), OPENINGS))
        w = np.sqrt(np.maximum(0, a * a + b * b - 2 * a * b * cosine)) + 0j  # the chain, laid along the x axis
        # Angle at A of the triangle V A X, then A, and everything else by vectors.
        at_V = np.arccos(np.clip((a * a + np.abs(w) ** 2 - b * b) / (2 * a * np.abs(w)), -1, 1))
        p = VA * np.exp(1j * (np.angle(w) + elbow * at_V))
        q = (w - p) * s
        V = 0 * w
        A, B, C, X, Y = p, q, p + q, w, q + s * p
        sine = (np.conj(p) * q).imag / (VA * VB)
        if np.any(np.sign(sine) != side):
            return 1e4 * (1 + np.mean(np.sign(sine) != side))
        serial = np.sqrt(1 - cosine ** 2)
        mu = np.arcsin(np.minimum(1, np.minimum(np.abs(sine), serial))).min()
        if not self.maximize:
            broken += 100 * max(0, self.transmission - mu)
        broken += self.contact(dict(V=V, A=A, B=B, C=C, X=X, Y=Y), vertex, layers, s)
        ACX = (VB + VB / abs(s) + VB * abs(1 - s) / abs(s)) / 2
        BCY = (VA + VA * abs(s) + VA * abs(1 - s)) / 2
        objective = -math.degrees(mu) if self.maximize else VA + VB + ACX + BCY
        return objective + (1e3 * (1 + broken) if broken > 1e-9 else 0)

    def segments(self, link, s):
        if link in ("VA", "VB"):
            return [tuple(link)]
        first, middle, last = link
        if abs(s.imag) < 1e-12 * abs(s) or self.plate == "triangle":
            return [(first, middle), (middle, last), (first, last)]
        return [(first, middle), (first, last)]

    def contact(self, z, vertex, layers, s):
        broken = 0
        need = self.width + self.clearance
        for one, other in (("VA", "BCY"), ("VB", "ACX")):
            if layers[one] == layers[other]:
                for a, b in self.segments(one, s):
                    for c, d in self.segments(other, s):
                        broken += max(0, need - segment_segment(z[a], z[b], z[c], z[d]).min())
        at = {"V": ("VA", "VB"), "A": ("VA", "ACX"), "B": ("VB", "BCY"), "C": ("ACX", "BCY"), "X": ("ACX",), "Y": ("BCY",)}
        posts = {"V", "X", "Y"}
        occupied = {}
        for joint, links in at.items():
            levels = [layers[l] for l in links]
            span = set(range(min(levels) + 1, max(levels)))
            if joint in posts:
                span |= set(range(1, min(levels)))
            occupied[joint] = span
            for link in LINKS:
                if layers[link] in span and link not in links:
                    for a, b in self.segments(link, s):
                        broken += max(0, (self.pin + self.width) / 2 + self.clearance - point_segment(z[joint], z[a], z[b]).min())
        for one, other in itertools.combinations(at, 2):
            if (one in posts and other in posts) or occupied[one] & occupied[other]:
                broken += max(0, self.pin + self.clearance - np.abs(z[one] - z[other]).min())
        return broken


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("spec")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--iterations", type=int, default=200)
    arguments = parser.parse_args()
    with open(arguments.spec, "rb") as file:
        problem = Problem(tomllib.load(file))
    best = (math.inf, None)
    start = time.process_time()
    for seed in range(arguments.seeds):
        for choice in problem.choices():
            found = differential_evolution(problem.cost, problem.bounds(), args=choice, seed=seed, popsize=15,
                                           maxiter=arguments.iterations, tol=1e-10, polish=False)
            if found.fun < best[0]:
                best = (found.fun, (choice[0], [math.exp(v) for v in found.x[:2]], list(found.x[2:]), choice[3]))
    feasible = best[0] < 1e3 if not problem.maximize else best[0] < 0
    json.dump({"feasible": bool(feasible), "objective": abs(best[0]), "design": best[1],
               "cpu_s": time.process_time() - start, "evaluations": problem.evaluations}, sys.stdout)
    print()


if __name__ == "__main__":
    main()
