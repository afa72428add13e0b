#!/usr/bin/env python3
"""Checks a design of Kempe from its files alone; shares no code with Kempe. The theorems stand in docs/proof.md.

usage: kempe_check.py design.json [certificate.jsonl]   or   kempe_check.py certificate.jsonl

A line a claim: proven, not proven or refuted. Exit code 0: all claims are proven; 1: one is not; 2: a file cannot be read.
Beside this file must lie enclosures.py (intervals, plane geometry, the search over cells, readers of values) and, for claim 5 and
the limit on the copy error, tolerance_check.py; for bodies and a table's edge, bodies_check.py.

eps:      claims 1, 2 and 5 and the limits forgive 1e-6 mm and 1e-6 degrees; claims 3 and 4 forgive nothing.
Assumes:  + - * / and sqrt of doubles are rounded correctly (IEEE 754); the numbers of the files are the doubles nearest
          to them; rings are simple, and holes lie inside their polygon.
"""
import json
import math
import sys
from collections import namedtuple
from fractions import Fraction
from itertools import combinations, product
from math import hypot, inf
from types import SimpleNamespace

from enclosures import (AT_REST, EPS_DEG, EPS_MM, NIL, ONE, SPOT, UNIT, ZERO, I, Open, Refuted, Z, apart, cloud, convex, corners,
                        cover, edges_of, listed, must, number, optional, point, polygons, squared_distances, to_segment, tree_of,
                        unit_circle, ways_around, where, word)

LINKS = ("VA", "VB", "ACX", "BCY")
PINS = {"A": ("VA", "ACX"), "B": ("VB", "BCY"), "C": ("ACX", "BCY"), "V": ("VA", "VB")}
POSTS = {"V": ("VA", "VB"), "X": ("ACX",), "Y": ("BCY",)}
JOINTS = {**{link: link for link in LINKS}, **{"pin " + j: j for j in PINS}, **{"post " + j: j for j in POSTS}}  # of each part
LENGTHS = ("VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY")
VERTICES = ("pole", "tracer", "pen")  # who stands at the vertex V
SHARED = ("region", "pole", "links", "limits", "obstacles", "bodies", "table", "objective", "tolerance", "cutting")  # in both files

class Unreadable(Exception):
    """A file that says nothing definite: file, key, what was found, what is allowed."""

def plain(reason):
    """On one line: names from the files may hold anything."""
    return str(reason).encode("unicode_escape").decode()

class Shape:
    """What ratio and vertex fix: s, g, the factors of the lengths, and the modes."""

    def __init__(self, task, vertex):
        k = self.k = unit_circle(task.degrees) * task.scale
        s = self.s = {"pole": k, "tracer": UNIT - k, "pen": UNIT - UNIT / k}[vertex]
        self.vertex, self.g = vertex, {"pole": UNIT, "tracer": -UNIT, "pen": -k}[vertex]
        self.abs_s, self.abs_1s, self.abs_g = (z.square().sqrt() for z in (s, UNIT - s, self.g))
        self.straight = not (k.y.lo or k.y.hi)
        self.modes = 2 if self.straight else 4
        self.up = -1.0 if s.y.hi < 0 or self.straight and s.x.hi < 0 else 1.0  # the sign of arg s
        if not (self.straight or s.y.lo > 0 or s.y.hi < 0) or not self.abs_s.lo > 0:
            raise Open("the shape is nearly degenerate")
        half = (self.abs_s + self.abs_1s + 1.0) * 0.5
        self.size = (half + 1.0, half + self.abs_s)  # of a and of b
        self.of_a = {"VA": ONE, "BC": ONE, "BY": self.abs_s, "CY": self.abs_1s}
        self.of_b = {"VB": self.abs_s, "AC": self.abs_s, "AX": ONE, "CX": self.abs_1s}
        # (alpha, beta) of joint - pole = alpha p + beta q/s
        seen = {"V": (NIL, NIL), "A": (UNIT, NIL), "B": (NIL, s), "C": (UNIT, s), "X": (UNIT, UNIT), "Y": (s, s)}
        pole = seen["V" if vertex == "pole" else "X"]
        self.seen = {**{j: (alpha - pole[0], beta - pole[1]) for j, (alpha, beta) in seen.items()}, "pole": (NIL, NIL)}

    def signs(self, mode):
        """Of sin psi and of sin d."""
        sin_d = -1 if mode < self.modes // 2 else 1
        return (sin_d if self.straight else 1 if mode in (0, 3) else -1) * self.up, sin_d

    def window(self, mode, degrees):
        """Cosines of the least and the largest |psi| with the transmission angle asked for."""
        limit = unit_circle(degrees)
        if self.straight:
            return limit.x, -limit.x
        # The change point in this half turn is psi = -arg s modulo pi; the dead point is 0 where d comes to arg s itself.
        cc, cs = self.s.x * (-self.up * self.signs(mode)[0]) / self.abs_s, self.s.y * self.up / self.abs_s
        return (limit.x, cc * limit.x + cs * limit.y) if (mode > 1) == (self.up > 0) else (cc * limit.x - cs * limit.y, -limit.x)

    def opened(self, a, b, w, sign):
        """By (2): for constants alpha, beta the place alpha p + beta q/s = w ((alpha - beta) p/w + beta)."""
        r, aa, bb = w.square(), a.square(), b.square()
        h = ((a * b * 2.0).square() - (r - aa - bb).square()).sqrt() * float(sign)
        p = Z(r + aa - bb, -h) / (r * 2.0)
        return lambda alpha, beta: w * ((alpha - beta) * p + beta)

def may_meet(one, other):
    return not set(JOINTS[one]) & set(JOINTS[other])

def occupied(part, layers):
    """The layers that a part fills, given those of the links."""
    if part in LINKS:
        return {layers[part]}
    levels = sorted(layers[link] for link in (PINS if part.startswith("pin") else POSTS)[part[-1]])
    return set(range(levels[0] + 1, levels[-1]) if part.startswith("pin") else range(1, levels[0]))

def share(one, other, layers, obstacles):
    """True if a part has a layer in common with a part, or with an obstacle given by its number."""
    others = occupied(other, layers) if isinstance(other, str) else obstacles[other].layers
    return not occupied(one, layers).isdisjoint(others)

# Readers of tables
def obstacle(value):
    (rings,), (low, high) = polygons(value["shape"]), listed(number(0, 64, [int]), 2)(value["layers"])
    return SimpleNamespace(rings=rings, layers=range(low, high + 1), name=value.get("name") or "an obstacle", **AT_REST)

def links(value):
    found = {link["name"]: link for link in value}
    plate = word("bent", "triangle")(found["ACX"]["shape"])
    must(plate == found["BCY"]["shape"] and len(value) == len(LINKS), value, "VA, VB, ACX and BCY, both plates of one shape")
    return {link: number(1, 64, [int])(found[link]["layer"]) for link in LINKS}, plate

def area(value):
    found = polygons(value["within_mm"]) if "within_mm" in value else [[[point(value["at_mm"])] * 2]]
    return must(found and len(value) == 1, value, "at_mm or within_mm") and found

LENGTH, OBJECTIVE = number(0), word("size", "transmission")  # of others no log can be
TASK = {"scale": ("copy.scale", number(1e-6)), "degrees": ("copy.rotation_deg", number(-3600, 3600)),
        "region": ("region", polygons), "obstacles": ("obstacles", listed(obstacle)), "clearance": ("limits.clearance_mm", LENGTH),
        "transmission": ("limits.transmission_deg", number(0, 90)), "sheets_gap": ("limits.sheets_gap_mm", optional(LENGTH)),
        "copy_error": ("limits.copy_error_mm", optional(LENGTH)), "strip": ("limits.longest_strip_mm", optional(LENGTH)),
        "length": ("tolerance.length_mm", optional(LENGTH)), "play": ("tolerance.play_mm", optional(LENGTH))}
CHOICE = {"longest": ("links.longest_mm", LENGTH), "shortest": ("links.shortest_mm", LENGTH),
          "wall": ("links.wall_mm", LENGTH), "seat": ("links.seat_mm", optional(LENGTH)),
          "hole_fit": ("cutting.hole_fit_mm", number(-10, 10)), "most_layers": ("links.layers", number(1, 8, [int])),
          "grid": ("links.grid_mm", optional(LENGTH)), "stock": ("links.stock_mm", optional(listed(LENGTH))),
          "locked": ("links", lambda table: {n: v for n in LENGTHS if (v := optional(LENGTH)(table.get(n + "_mm")))}),
          "groundings": ("objective.groundings", listed(word(*VERTICES))), "area": ("pole", area)}
WIDTHS = {"width": ("link_width_mm", number(1e-6)), "pin": ("pin_diameter_mm", number(1e-6))}
DESIGN = {"format": ("format", word("kempe-design/1")), **{key: ("mechanism." + at, each) for key, (at, each) in WIDTHS.items()},
          "links": ("mechanism.links", links), "vertex": ("mechanism.vertex", word(*VERTICES)),
          "assembly": ("mechanism.assembly", number(0, 3, [int])), "pole": ("mechanism.pole_position_mm", point),
          "lengths": ("mechanism.lengths_mm", lambda table: {n: number(1e-6)(table.get(n)) for n in LENGTHS}),
          "robust": ("tolerance.robust", word(True, False, None))}
LOG = {"format": ("format", word("kempe-certificate/1")), "claim": ("claim", word("bound", "none")),
       "objective": ("objective", OBJECTIVE), "bound": ("bound", optional(number())),
       "plate": ("task.plate", word("bent", "triangle")),
       **{key: ("task." + at, each) for key, (at, each) in {**TASK, **WIDTHS, **CHOICE}.items()}}
STATED = {"objective": ("search.objective", OBJECTIVE), "value": ("search.value", number()),
          "bound": ("quality.lower_bound", optional(number()))}

def read_keys(name, data, rules):
    """The values of a file's keys, by a table: (path, reader)."""
    out = SimpleNamespace()
    for attribute, (path, reader) in rules.items():
        value = data
        for key in path.split("."):
            value = value.get(key) if isinstance(value, dict) else None
        try:
            setattr(out, attribute, reader(value))
        except (ValueError, TypeError, KeyError, AttributeError) as fault:
            allowed = fault if isinstance(fault, ValueError) else "a table as docs/design-file.md has it"
            found = "nothing" if value is None else plain(value)[:60]
            raise Unreadable(f"{name}: {path}: found {found}; allowed: {allowed}") from None
    return out

def shortest(task):
    return max(task.shortest, (I(task.seat or task.pin + max(0.0, task.hole_fit)) + task.wall).lo)

def longest(task):
    """The largest distance of two joints of a link: a strip also holds half a width beyond each of them."""
    return task.longest if task.strip is None else min(task.longest, (I(task.strip) - task.width).hi)

def half(task, part):
    return 0.5 * (task.width if part in LINKS else task.pin)

def pieces(task, part):
    """Convex pieces of a part's axis, by joints."""
    joints = JOINTS[part]
    return [joints[:2], joints[::2]] if len(joints) == 3 and task.plate == "bent" else [joints]

def tolerances(of):
    from tolerance_check import Tolerances
    return Tolerances(of)

def surroundings(of, vertex=None):
    import bodies_check
    try:
        return bodies_check.blocks_of(of, vertex) if vertex else bodies_check.pairs_of(of, JOINTS, Pair, occupied, pieces, half)
    except (ValueError, TypeError, KeyError, AttributeError) as fault:
        raise Unreadable(f"{of.name}: bodies or table: found {plain(fault)[:60]}; allowed: as docs/design-file.md has it") from None

# Two parts whose axes may not come nearer than `wide`: names, joints that span them, the frame they are seen from; the other is
# spanned by its joints and a tree of edges, those of a polygon's rings.
Pair = namedtuple("Pair", "one joints other others frame wide tree rings", defaults=(SPOT, None))

class Design:
    """Claims 1 and 2, and the limits."""
    def __init__(self, name, data):
        self.name, self.data, self.losses, self.range = name, data, None, None
        task = self.task = read_keys(name, data, {**TASK, **DESIGN})
        (self.layers, task.plate), self.lengths, self.pole, self.robust = task.links, task.lengths, task.pole, task.robust
        shape = self.shape = Shape(task, task.vertex)
        self.sign, self.sign_d = shape.signs(task.assembly)
        if task.assembly >= shape.modes:
            raise Unreadable(f"{name}: mechanism.assembly: found {task.assembly}; allowed: 0 to {shape.modes - 1}")
        self.a, self.b = I(self.lengths["VA"]), I(self.lengths["VB"]) / shape.abs_s
        self.exact = {n: f * unit for unit, factors in ((self.a, shape.of_a), (self.b, shape.of_b)) for n, f in factors.items()}
        # Places are taken from the pole. In doubles they, and the corners of cells, are off by less than `slip`.
        self.region, self.blocks = self.local(task.region), self.local([o.rings for o in task.obstacles])
        sizes = [max((abs(c) for p in polygons for ring in p for corner in ring for c in corner), default=0.0)
                 for polygons in (task.region + [o.rings for o in task.obstacles] + [[[self.pole]]], self.region + self.blocks)]
        self.slip = 2.0 ** -50 * sizes[0] + 2.0 ** -44 * sizes[1]

    def local(self, some):
        return [[[(c[0] - self.pole[0], c[1] - self.pole[1]) for c in ring] for ring in polygon] for polygon in some]

    def reached(self):
        """Claim 1. Sets the range of distances, and what the openings are at its ends."""
        shape, self.openings = self.shape, []
        if not self.region or any(where(self.pole, polygon) >= 0 for polygon in self.task.region):
            raise Refuted("the pole stands in the region, where the tracer cannot go" if self.region else "the file has no region")
        for name, length in self.lengths.items():
            if (self.exact[name] - length).size() > EPS_MM:
                raise Refuted(f"length {name} = {length} does not fit VA, VB and the ratio")
        sine = unit_circle(max(0.0, self.task.transmission - EPS_DEG)).y
        for place, square in zip(("nearest", "farthest"), squared_distances(self.pole, self.task.region)):
            c = (square * shape.abs_g.square() - self.a.square() - self.b.square()) / (self.a * self.b * 2.0)
            if c.lo > 1 or c.hi < -1:
                raise Refuted(f"the {place} place, {math.sqrt(square.middle()):.6g} mm from the pole, is out of reach")
            sin_psi = ((1.0 - c) * (c + 1.0)).sqrt()
            sin_d = (shape.s.x * sin_psi * self.sign + shape.s.y * c) / shape.abs_s * self.sign_d
            for kind, x in (("dead", sin_psi), ("change", sin_d)):
                if x.hi < sine.lo or x.hi <= 0:
                    away = math.degrees(math.asin(max(-1, x.hi)))
                    raise Refuted(f"at the {place} place the {kind} point is only {away:.6g} degrees away")
                if not (x.lo >= sine.hi and x.lo > 0):
                    raise Open
            self.openings.append((square.sqrt(), c, sin_psi, sin_d))
        self.range = [opening[0] for opening in self.openings]
        return f" (transmission {self.task.transmission:g} degrees, eps {EPS_DEG:g} degrees)"

    def nominal(self, z):
        """The joints, from the pole, with the tracer at z; and the turns into the frames of links."""
        place = self.shape.opened(self.a, self.b, self.shape.g * z, self.sign)
        joints, p, q = {j: place(*seen) for j, seen in self.shape.seen.items()}, place(UNIT, NIL), place(NIL, self.shape.s)
        return joints, {"ACX": q.conj() / self.exact["AC"], "VA": p.conj() / self.a, "table": UNIT}

    def clear(self):
        """Claim 2, or claim 5 with losses. Contact of the linkage with itself does not change if all turns about the pole."""
        task, itself, blocked = self.task, [], []
        if not self.range:
            raise Open("claim 1 comes first")
        for other, one in combinations(JOINTS, 2):
            together = share(one, other, self.layers, ())
            if together and not may_meet(one, other) and {one, other} <= set(LINKS):
                raise Refuted(f"{other} and {one} share a joint and a layer")
            if may_meet(one, other) and (together or one.startswith("post") and other.startswith("post")):
                # Parallel to VB and ACX, or to VA and BCY: seen from there such parts do not turn.
                frame, wide = "ACX" if {"VB", "ACX"} & {one, other} else "VA", half(task, one) + half(task, other) + task.clearance
                itself += [Pair(other, A, one, B, frame, wide) for A, B in product(pieces(task, other), pieces(task, one))]
        met = surroundings(self) if any(map(self.data.get, ("bodies", "table"))) else []
        itself += [pair for pair in met if pair.frame != "table"]
        cover([[(self.range[0].lo, 0.0), (self.range[1].hi, 0.0)]], itself, None, self.pending_in)
        for (i, block), part in product(enumerate(self.blocks), JOINTS):
            if share(part, i, self.layers, task.obstacles):
                wide, tree, name = half(task, part) + task.clearance, tree_of(edges_of(block)), task.obstacles[i].name
                blocked += [Pair(part, piece, name, ["pole"], "table", wide, tree, block) for piece in pieces(task, part)]
        self.keep_out(blocked := blocked + [pair for pair in met if pair.frame == "table"])
        for rings in self.region[1:] if blocked else ():
            self.way(self.region[0][0], rings[0], blocked)
        return f" (clearance {task.clearance:g} mm, eps {EPS_MM:g} mm)"

    def keep_out(self, pairs):
        """Parts keep away from rings, over the region. One that meets no edge is inside always or never: one place decides."""
        for rings in self.region if pairs else ():
            joints = self.nominal(Z(*rings[0][0]))[0]
            for pair in pairs:
                at = (joints[pair.joints[0]] - joints[pair.others[0]]).middle()
                if pair.rings(at) if callable(pair.rings) else where(at, pair.rings) > 0:
                    raise Refuted(f"{pair.one} is inside {pair.other}")
            simple = len(rings) == 1 and convex(rings[0])
            cover([ring[:-1] for ring in rings], pairs, None if simple else rings, self.pending_in)

    def pending_in(self, box, hull, pending):
        """The pairs not proven apart over the hull; None if there are none, and the linkage closes."""
        m, slip = (0.5 * box[0] + 0.5 * box[1], 0.5 * box[2] + 0.5 * box[3]), self.slip
        z = Z(I(box[0] - slip, box[1] + slip, {"x": ONE}), I(box[2] - slip, box[3] + slip, {"y": ONE}))
        try:
            (moving, turning), (still, turn) = self.nominal(z), self.nominal(Z(*m))
            loss = self.losses(z) if self.losses else lambda *which: 0.0
        except Open:
            return pending
        ways = [{v: I(c - slip, c + slip) - o for v, c, o in zip("xy", corner, m)} for corner in hull]
        clouds, left, todo = {}, [], list(pending)
        while todo:
            pair = todo.pop()
            names, frame, corners = list(product(pair.joints, pair.others)), pair.frame, pair.tree.corners
            for i, j in names:  # the way from joint to joint
                if (i, j, frame) not in clouds:
                    clouds[i, j, frame] = cloud((still[j] - still[i]) * turn[frame], (moving[j] - moving[i]) * turning[frame], ways)
            P, Q = ([(still[j] * turn[frame]).middle() for j in some] for some in (pair.joints, pair.others))
            v = apart(P, [(q[0] + e[0], q[1] + e[1]) for q in Q for e in corners])
            if gap := hypot(*v):  # one direction n proves the two apart all over the cell
                n = v[0] / gap, v[1] / gap
                far, near = min(n[0] * p[0] + n[1] * p[1] for p in corners), inf
                for i, j in names:
                    points, radius, _ = clouds[i, j, frame]
                    near = min(near, min(n[0] * p[0] + n[1] * p[1] for p in points) - radius - loss(n, pair, i, j))
                slack = 1e-14 * (abs(far) + abs(near) + max(abs(c) for p in corners for c in p)) + 4 * slip
                if far + near >= pair.wide - EPS_MM + slack:
                    continue
            if pair.tree.children and pair.tree.size > max(clouds[i, j, frame][2] for i, j in names):
                todo += [pair._replace(tree=child) for child in pair.tree.children]
                continue
            real = frame != "table" or any(where(m, polygon) >= 0 for polygon in self.region)
            if real and gap < pair.wide - 2 * EPS_MM and not pair.tree.children:
                raise Refuted(f"{pair.one} and {pair.other} come to {gap:.6g} mm from axis to axis with the tracer at "
                              f"({m[0]:.6g}, {m[1]:.6g}) from the pole; needed: {pair.wide:g}")
            left.append(pair)
        return left or None

    def way(self, one, other, pairs):
        """Two polygons are joined if a way from corner to corner, straight or around the pole, is clear as well."""
        A, B = min(product(one[::1 + len(one) // 40], other[::1 + len(other) // 40]), key=lambda pq: math.dist(*pq))
        least, most = self.range[0].hi, self.range[1].lo
        for way in ways_around(A, B, least, most):
            try:
                for p, q in zip(way, way[1:]):
                    if hypot(*to_segment((0.0, 0.0), p, q)) < least - EPS_MM or max(hypot(*p), hypot(*q)) > most + EPS_MM:
                        raise Open
                    cover([[p, q]], pairs, None, self.pending_in)
                return
            except (Open, Refuted):
                continue
        raise Open("no way from polygon to polygon was found")

    def every_instrument(self):
        """Claim 5: claim 2 with what the tolerances may take off every way."""
        self.losses = tolerances(self).losses
        return f" (lengths within {self.task.length or 0:g} mm, play {self.task.play or 0:g} mm)" + self.clear()

    def limits(self):
        """What else the file limits."""
        task, shape = self.task, self.shape
        if task.sheets_gap is not None:  # the pen is a part that keeps away from the region itself
            gap, pen = max(task.sheets_gap, 1e-9 + EPS_MM), "V" if shape.vertex == "pen" else "Y"
            self.keep_out([Pair("the pen", pen, "the original", ["pole"], "table", gap, tree_of(edges_of(rings)), rings)
                           for rings in self.region])
        if task.copy_error is not None:
            tolerances(self).copy_error()
        if any(self.data.get(key) is None for key in ("pole", "links", "objective", "cutting")):
            raise Open("not checked: pole, links, objective (not stated)")
        vars(task).update(vars(read_keys(self.name, self.data, CHOICE)))
        for name, length in self.lengths.items():
            off = [shortest(task) - length, length - longest(task), abs(length - task.locked.get(name, length))]
            off += [abs(math.remainder(length, task.grid))] if task.grid and name not in ("CX", "CY") else []
            off += [min(abs(length - each) for each in task.stock)] if task.stock and name not in ("CX", "CY") else []
            if max(off) > EPS_MM:
                raise Refuted(f"length {name} = {length}: too short or long, not as locked, or not of the grid or the stock")
        if shape.vertex not in task.groundings or max(self.layers.values()) > task.most_layers:
            raise Refuted("this vertex or layer is not permitted")
        away = min(hypot(*to_segment(self.pole, *edge)) for polygon in task.area for edge in edges_of(polygon))
        if away > EPS_MM and not any(where(self.pole, polygon) >= 0 for polygon in task.area):
            raise Refuted("the pole stands elsewhere than permitted")

# Designs of a log: ranges of a, b and the pole's x, y; cosines of the least and largest |psi|; layer assignments.
Node = namedtuple("Node", "box window assignments")

class Certificate:
    """Claims 3 and 4: a log is read line by line, and every line must close or divide the next node."""
    def __init__(self, name, lines):
        self.name, self.data, self.lines, self.at = name, lines[0] if lines else None, lines, 0
        task = self.task = read_keys(name, self.data, LOG)
        self.claim, self.objective, self.bound = task.claim, task.objective, task.bound
        self.by = self.objective if self.bound is not None else None
        if (self.claim == "bound") != (self.bound is not None):
            raise Unreadable(f"{name}: bound: found {self.bound}; allowed: a number beside claim bound, null beside none")

    def belongs_to(self, design):
        """The log speaks of the design's task, and proves what the design's file states."""
        mine, theirs, mechanism = self.data["task"], {key: design.data.get(key) for key in SHARED}, design.data["mechanism"]
        copy = design.data["copy"]
        theirs["copy"] = {key: copy.get("wanted_" + key, copy[key]) for key in ("scale", "rotation_deg")}
        theirs.update({key: mechanism[key] for key, _ in WIDTHS.values()}, plate=design.task.plate)
        for key in theirs:
            if mine.get(key) != theirs[key]:
                raise Open(f"the log's {key} is not the design's")
        stated = read_keys(design.name, design.data, STATED)
        if self.claim != "bound" or stated.objective != self.objective:
            raise Open("the log is about something else than the design's objective")
        over = 1 if self.objective == "size" else -1
        if over * stated.value < over * self.bound - EPS_MM:
            raise Refuted(f"this design has {stated.value}")
        if stated.bound is not None and over * stated.bound > over * self.bound + EPS_MM:
            raise Open(f"the file states {stated.bound}")

    def prove(self):
        for vertex in (v for v in VERTICES if v in self.task.groundings):
            self.shape, beside = Shape(self.task, vertex), any(map(self.data["task"].get, ("bodies", "table")))
            self.blocks = self.task.obstacles + (surroundings(self, vertex) if beside else [])
            for mode in range(self.shape.modes):
                (self.sign, self.sign_d), todo = self.shape.signs(mode), [self.root(mode)]
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
            lo = max([(I(shortest(task)) / f).lo for f in factors.values()] + [l.lo for l in locked])
            ranges.append(I(lo, min([(I(longest(task)) / f).hi for f in factors.values()] + [l.hi for l in locked])))
        ranges += [I(min(c), max(c)) for c in zip(*(corner for polygon in task.area for corner in polygon[0]))]
        joined = [pair for pair in combinations(LINKS, 2) if not may_meet(*pair)]
        every = (dict(zip(LINKS, layers)) for layers in product(range(1, task.most_layers + 1), repeat=4))
        return Node(dict(zip("abxy", ranges)),
                    self.shape.window(mode, max(task.transmission, self.bound if self.by == "transmission" else 0.0)),
                    [l for l in every if all(l[one] != l[other] for one, other in joined)])

    def step(self, node, line):
        """The children of a node; none if its leaf refutes it."""
        for rule in ("split", "share", "contact", "copy_error"):
            if rule in line:
                return getattr(self, rule)(node, line)
        empty = {"lengths": any(i.lo > i.hi for i in node.box.values()), "layers": not node.assignments}
        if not (empty[line["leaf"]] if line["leaf"] in empty else getattr(self, "leaf_" + line["leaf"])(node, line)):
            raise Open(f"{line['leaf']} does not refute")
        return []

    def split(self, node, line):
        old, at = node.box[line["split"]], float(line["at"])
        if not old.lo < at < old.hi:
            raise Open(f"{at} does not split {old.lo} to {old.hi}")
        return [node._replace(box={**node.box, line["split"]: part}) for part in (I(old.lo, at), I(at, old.hi))]

    def share(self, node, line):
        one, other = line["share"]
        if one not in JOINTS or other not in JOINTS and not 0 <= other < len(self.blocks):
            raise Open("unknown parts")
        return [node._replace(assignments=[l for l in node.assignments if share(one, other, l, self.blocks) == wanted])
                for wanted in (True, False)]

    def contact(self, node, line):
        u, (one, other) = I(float(line["u"])), line["contact"]
        keep_apart = may_meet(one[0], other[0]) and all(share(one[0], other[0], l, ()) for l in node.assignments)
        if not 0 < u.lo < 1e9 or not keep_apart:
            raise Open("these parts need not keep apart")
        turn = Z(ONE - u.square(), u * 2.0 * self.sign) / (u.square() + ONE)
        allowed = I(half(self.task, one[0])) + half(self.task, other[0]) + self.task.clearance
        for a, b in corners(node.box, "ab"):
            joints = {j: alpha * a + beta * (turn * b) for j, (alpha, beta) in self.shape.seen.items()}
            if not (self.material(one, joints) - self.material(other, joints)).square().hi < allowed.square().lo:
                raise Open("the points are not in contact all over the box")
        return [node._replace(window=window) for window in ((node.window[0], turn.x), (turn.x, node.window[1]))]

    def copy_error(self, node, line):
        """The openings before the first and after the second cosine exceed the limit on the copy error, all if it is no larger."""
        (start, end), (first, last) = node.window, listed(number(-1, 1), 2)(line["copy_error"])
        for low, high in ((first, start.hi), (end.lo, last)):
            if low < high:
                tolerances(self).exceeded(low, high)
        left = I(first) if first < start.hi else start, I(last) if last > end.lo else end
        return [node._replace(window=left)] if first > last else []

    def material(self, named, joints):
        """A material point of a part, from its joints."""
        part, *t = named
        t, ends = [float(x) for x in t], JOINTS[part]
        off_bent_plate = len(t) == 2 and self.task.plate == "bent" and 0 not in t
        if len(t) != len(ends) - 1 or not all(0 <= x <= 1 for x in t) or sum(map(Fraction, t)) > 1 or off_bent_plate:
            raise Open(f"{named} is no point of a part")
        return sum(((joints[joint] - joints[ends[0]]) * x for x, joint in zip(t, ends[1:])), start=joints[ends[0]])

    def place(self, value):
        """A place of the region, as intervals."""
        if len(value) == 2:
            if not any(where(point(value), polygon) >= 0 for polygon in self.task.region):
                raise Open(f"{value} is not in the region")
            return Z(*point(value))
        polygon, ring, corner, t = value
        if not (min(polygon, ring, corner) >= 0 and 0 <= t <= 1):
            raise Open(f"{value} is no place of the region")
        p, q = (Z(*c) for c in self.task.region[polygon][ring][corner:corner + 2])
        return p + (q - p) * float(t)

    def leaf_sum(self, node, line):
        """A sum Q of requirements, about the box's middle: with slopes; its squares of a and b, of x and y; m, its product ab."""
        shape, box = self.shape, node.box
        middle = {v: i.middle() for v, i in box.items()}
        a, b, x, y = (I(c, c, {v: ONE}) for v, c in middle.items())
        Q, of_ab, of_xy, m = ZERO, ZERO, ZERO, ZERO
        for name, *places, weight in line["of"]:
            if not 0 <= weight < 1e9:
                raise Open("a weight is negative")
            weight = I(float(weight)) * {"far": -1.0, "near": 1.0, "posts": 1.0, "bound": 1.0}[name]
            if name == "bound":
                if self.by != "size":
                    raise Open("there is no bound")
                Q += weight * (self.bound - shape.size[0] * a - shape.size[1] * b)
                continue
            away = (self.place(places[0]) - Z(x, y)).square()
            if name == "posts":
                nearest = (I(self.task.pin) + self.task.clearance) / (I(min(1.0, shape.abs_s.hi, shape.abs_1s.hi)) * shape.abs_g)
                Q, of_xy = Q + weight * (away - I(nearest.lo).square()), of_xy + weight
                continue
            c, gg = node.window[name == "near"], shape.abs_g.square()
            Q += weight * (gg * away - (a.square() + b.square() + a * b * c * 2.0))
            of_ab, of_xy, m = of_ab - weight, of_xy + weight * gg, m - weight * c * 2.0
        reach = {v: I(max((I(i.hi) - middle[v]).hi, (middle[v] - I(i.lo)).hi)) for v, i in box.items()}
        most = I(Q.lo, Q.hi) + I(m.size()) * reach["a"] * reach["b"]
        for v, h in reach.items():
            g, q = I((Q.d or {}).get(v, ZERO).size()), I((of_ab if v in "ab" else of_xy).hi)
            inside = q.hi < 0 and g.hi < (q * h * -2.0).lo
            most += g.square() / (q * -4.0) if inside else g * h + q * h.square()
        return most.hi < 0

    def leaf_pole(self, node, line):
        """The box of poles holds no place of their area: no edge of it comes near, and a corner is not inside."""
        one, two, four, three = corners(node.box, "xy")
        edges = [edge for polygon in self.task.area for edge in edges_of(polygon)]
        near = 1e-12 * max(abs(c) for c in one + three + sum(sum(edges, ()), ()))
        return (not any(where(one, polygon) >= 0 for polygon in self.task.area)
                and min(hypot(*apart([one, two, three, four], edge)) for edge in edges) > near)

    def leaf_sheets(self, node, line):
        one, other = (self.place(p) for p in line["places"])
        ways = [Z(*P) + self.shape.k * (one - Z(*P)) - other for P in corners(node.box, "xy")]
        return max(way.square().hi for way in ways) < I(self.task.sheets_gap).square().lo

    def leaf_obstacle(self, node, line):
        """A part's point stays, over the box, within reach of a convex piece of an obstacle, or of a body seen from its joint."""
        index, named, edge, box, seen = line["obstacle"], line["point"], line["edge"], node.box, self.shape.seen
        block, (ring, *holes) = self.blocks[index], self.blocks[index].rings
        if block.joint in JOINTS[named[0]] or not all(share(named[0], index, l, self.blocks) for l in node.assignments):
            raise Open("the part does not meet this obstacle")
        if edge is None and (holes or not convex(ring)) or edge is not None and not 0 <= edge < len(ring) - 1:
            raise Open("the obstacle is not convex, or has no such edge")
        K, T = ring[:-1] if edge is None else ring[edge:edge + 2], self.place(line["place"])
        constants = [self.material(named, {j: pair[i] - seen[block.joint][i] for j, pair in seen.items()}) for i in (0, 1)]
        names, middle = [v for v in "abxy" if box[v].lo < box[v].hi], {v: I(i.middle()) for v, i in box.items()}

        def point_at(a, b, x, y):
            return Z(x, y) * block.rest + self.shape.opened(a, b, self.shape.g * (T - Z(x, y)), self.sign)(*constants)
        wide = {v: I(i.lo, i.hi, {v: ONE} if v in names else None) for v, i in box.items()}
        ways = [{v: c - middle[v] for v, c in zip(names, corner)} for corner in corners(box, names)]
        points, radius, _ = cloud(point_at(**middle), point_at(**wide), ways)
        allowed = (half(self.task, named[0]) + self.task.clearance + block.beyond) * (1 - 1e-15)
        slack = 1e-14 * max(abs(c) for p in points + K for c in p)  # apart() is off by less
        return all(hypot(*apart([p], K)) + radius + slack < allowed for p in points)

def claim(name, proof):
    """Prints one claim's line; True if it is proven."""
    try:
        print(f"{name}: proven{proof() or ''}")
        return True
    except Refuted as reason:
        print(f"{name}: refuted: {plain(reason)}")
    except (Open, ArithmeticError, ModuleNotFoundError) as reason:
        print(f"{name}: not proven{': ' + plain(reason) if str(reason) else ''}")
    return False

def table(pairs):
    return must(len(dict(pairs)) == len(pairs), dict(pairs), f"a key twice in {[key for key, _ in pairs]}")

def read(name):
    """The objects of a JSON or JSON lines file."""
    try:
        with open(name, encoding="utf-8") as file:
            text = file.read()
        parts = text.rstrip("\n").split("\n") if name.endswith(".jsonl") else [text]
        return [json.loads(part, object_pairs_hook=table) for part in parts]
    except (OSError, ValueError, RecursionError) as fault:
        raise Unreadable(f"{name}: found {plain(fault)[:80]}; allowed: a file of JSON, each key once")

def main(names):
    if len(names) not in (1, 2):
        raise Unreadable(__doc__)
    files, good = [read(name) for name in names], True
    try:
        design = None if names[0].endswith(".jsonl") else Design(names[0], files.pop(0)[0])
        logs = [Certificate(names[-1], lines) for lines in files]
    except (AttributeError, TypeError, KeyError, IndexError, OverflowError, Open) as fault:
        allowed = "a table as docs/design-file.md or docs/proof.md has it"
        raise Unreadable(f"{', '.join(names)}: found {plain(fault)}; allowed: {allowed}")
    if design:
        good = claim("1 every point is reached on one assembly mode", design.reached)
        good = claim("2 the parts keep their clearance", design.clear) and good
        good = claim("limits of the file", design.limits) and good
        if design.robust:
            good = claim("5 every instrument within the tolerances stays on one assembly mode and keeps the clearance",
                         design.every_instrument) and good
        unread = sorted(design.data.keys() - {*SHARED, "format", "copy", "mechanism"})
        print("not looked at:", plain(", ".join(unread + ["claim 3, whose log is certificate.jsonl"] * (not logs))))
    for log in logs:
        better, unit = {"size": ("smaller", " mm"), "transmission": ("larger", " degrees")}[log.objective]
        title = "4 no design exists" if log.claim == "none" else f"3 no design is {better} than {log.bound:.12g}{unit}"
        good = claim(title, lambda: (design and log.belongs_to(design)) or log.prove()) and good
    return good

if __name__ == "__main__":
    try:
        sys.exit(0 if main(sys.argv[1:]) else 1)
    except Unreadable as message:
        print(message, file=sys.stderr)
        sys.exit(2)
