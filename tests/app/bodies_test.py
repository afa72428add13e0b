#!/usr/bin/env python3
"""Bodies and the table's edge against an oracle that shares no line with the program: joints by intersecting circles, gaps edge by
edge. Random given mechanisms are mapped; no place called free is in contact, no place well clear is called lost, and `kempe verify`
says of a region that is not free that it is not, and of one that is that it is. Random tasks are designed; of many linkages drawn
at random below the bound none does the task, though some would without the bodies. And the shipped example with bodies.

usage: bodies_test.py KEMPE SOURCE_DIR [--specs N] [--tasks N] [--seed N] [unittest arguments]
"""
import argparse
import cmath
import itertools
import json
import math
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from program import Case, kempe

# Places where a joint moves much faster than the tracer: outlines flattened to 0.01 mm there stand for larger gaps.
LOST_SLACK = 1.0
ROUNDING = 1e-6


def shape_of(k, vertex):
    return {"pole": k, "tracer": 1 - k, "pen": 1 - 1 / k}[vertex]


def modes(s):
    """The intervals of the opening, upward from -pi, between neighbours among 0, pi, arg s (mod pi)."""
    a = cmath.phase(s)
    ends = sorted({-math.pi, 0.0, math.pi} | {x for x in (a, a - math.pi, a + math.pi) if -math.pi < x < math.pi})
    kept = [ends[0]]
    for end in ends[1:]:
        if end - kept[-1] > 1e-12:
            kept.append(end)
    return list(zip(kept, kept[1:]))


class Mechanism:
    """A copying linkage from its ratio, two lengths and its assembly mode."""

    def __init__(self, k, vertex, va, vb, mode, pole):
        self.k, self.vertex, self.va, self.vb, self.pole = k, vertex, va, vb, pole
        self.s = shape_of(k, vertex)
        self.mode = modes(self.s)[mode]
        self.carrier = {"pole": {"tracer": "X", "pen": "Y"}, "tracer": {"tracer": "V", "pen": "Y"},
                        "pen": {"tracer": "Y", "pen": "V"}}[vertex]
        self.pole_joint = "V" if vertex == "pole" else "X"

    def pose(self, tracer):
        """The joints with the tracer at a place, and the transmission angle's distance from the mode's ends; or None."""
        pen = self.pole + self.k * (tracer - self.pole)
        V, X, Y = {"pole": (self.pole, tracer, pen), "tracer": (tracer, self.pole, pen), "pen": (pen, self.pole, tracer)}[self.vertex]
        way, ax = X - V, self.vb / abs(self.s)
        c = abs(way)
        if c < 1e-9:
            return None
        along = (c * c + self.va ** 2 - ax ** 2) / (2 * c)
        squared = self.va ** 2 - along ** 2
        if squared < 0:
            return None
        for side in (1, -1):
            A = V + way / c * complex(along, side * math.sqrt(squared))
            q = self.s * (X - A)
            d = cmath.phase(q / (A - V))
            if self.mode[0] < d < self.mode[1]:
                return {"V": V, "A": A, "B": V + q, "C": A + q, "X": X, "Y": Y}, min(d - self.mode[0], self.mode[1] - d)
        return None


def to_segment(p, a, b):
    d = b - a
    if d == 0:
        return abs(p - a)
    t = ((p - a) * d.conjugate()).real / abs(d) ** 2
    return abs(p - a - max(0.0, min(1.0, t)) * d)


def side(a, b, p):
    return ((b - a).conjugate() * (p - a)).imag


def between(a, b, c, d):
    if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
        return 0.0
    return min(to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b))


def edges(ring):
    return [(ring[0], ring[-1])] if len(ring) < 3 else list(zip(ring, ring[1:] + ring[:1]))


def inside(ring, p):
    found = False
    if len(ring) < 3:
        return found
    for a, b in edges(ring):
        if (a.imag > p.imag) != (b.imag > p.imag) and p.real < a.real + (p.imag - a.imag) / (b.imag - a.imag) * (b.real - a.real):
            found = not found
    return found


def apart(one, other):
    """Of two rings, filled where they have three corners."""
    if inside(one, other[0]) or inside(other, one[0]):
        return 0.0
    return min(between(*e, *f) for e in edges(one) for f in edges(other))


class Thing:
    def __init__(self, name, rings, around, low, high, joints=(), post=False):
        self.name, self.rings, self.around, self.low, self.high, self.joints, self.post = name, rings, around, low, high, set(joints), post
        corners = [z for ring in rings for z in ring]
        self.middle = sum(corners) / len(corners)
        self.reach = max(abs(z - self.middle) for z in corners) + around


def gap(one, other):
    return min(apart(a, b) for a in one.rings for b in other.rings) - one.around - other.around


class World:
    """A spec's parts, bodies, obstacles and table in a pose."""

    def __init__(self, spec):
        self.spec, self.linkage = spec, spec["linkage"]

    def parts(self, J):
        spec, layer = self.spec, dict(zip(("VA", "VB", "ACX", "BCY"), self.spec["layers"]))
        w, r, all_ = spec["width"] / 2, spec["pin"] / 2, []
        for link, plate in (("VA", None), ("VB", None), ("ACX", "A"), ("BCY", "B")):
            if plate is None:
                rings = [[J[link[0]], J[link[1]]]]
            elif spec["plate"] == "triangle":
                rings = [[J[j] for j in link]]
            else:
                rings = [[J["C"], J[plate]], [J[plate], J[link[2]]]]
            all_.append(Thing("link " + link, rings, w, layer[link], layer[link], link))
        for joint, (one, other) in {"V": ("VA", "VB"), "A": ("VA", "ACX"), "B": ("VB", "BCY"), "C": ("ACX", "BCY")}.items():
            low, high = sorted((layer[one], layer[other]))
            if high - low > 1:
                all_.append(Thing("pin " + joint, [[J[joint]]], r, low + 1, high - 1, joint))
        for joint in (self.linkage.pole_joint, *self.linkage.carrier.values()):
            lowest = min(layer[link] for link in layer if joint in link)
            all_.append(Thing("post " + joint, [[J[joint]]], r, 1, lowest - 1, joint, True))
        return all_

    def bodies(self, J):
        found = []
        for body in self.spec["bodies"]:
            joint, link = self.linkage.carrier[body["at"]], body.get("turns_with", "")
            ring, around = ([body["centre"]], body["radius"]) if "radius" in body else (body["ring"], 0.0)
            axis = self.axis(J, joint, link) if link else 1
            found.append((joint, link, Thing(body["name"], [[J[joint] + axis * z for z in ring]], around, *body["layers"])))
        return found

    @staticmethod
    def axis(J, joint, link):
        """From a joint to the nearest other one of its link, the first of its name where two are equally near."""
        others = [other for other in link if other != joint]
        least = min(abs(J[other] - J[joint]) for other in others)
        way = next(J[other] - J[joint] for other in others if abs(J[other] - J[joint]) < least * (1 + 1e-7))
        return way / abs(way)

    def at_pole(self):
        """The gap between the pole's post, in layer 1, and what is at rest there: obstacles and the table's edge."""
        pole, found = self.linkage.pole, [math.inf]
        for obstacle in self.spec["obstacles"]:
            if obstacle["layers"][0] == 1:
                found.append(apart(obstacle["ring"], [pole]))
        if table := self.spec["table"]:
            found.append(min(to_segment(pole, *edge) for edge in edges(table)) if inside(table, pole) else 0.0)
        return min(found) - self.spec["pin"] / 2

    def tightest(self, tracer):
        """The smallest gap of anything, and of what; None out of reach."""
        found = self.linkage.pose(tracer)
        if not found:
            return None
        J, margin = found
        parts, bodies = self.parts(J), self.bodies(J)
        obstacles = [Thing(o["name"], [o["ring"]], 0.0, *o["layers"]) for o in self.spec["obstacles"]]
        best = (math.inf, "nothing")

        def look(one, other, always=False):
            nonlocal best
            if abs(one.middle - other.middle) - one.reach - other.reach > best[0]:
                return  # farther apart than what is near already
            if always or max(one.low, other.low) <= min(one.high, other.high):
                best = min(best, (gap(one, other), f"{one.name} and {other.name}"))

        for i, one in enumerate(parts):
            for other in parts[:i]:
                if not one.joints & other.joints:
                    look(one, other, one.post and other.post)
            for obstacle in obstacles:
                # The pole's post is looked at in layer 1 even where a link lies there.
                stands = one.post and one.joints == {self.linkage.pole_joint} and obstacle.low == 1
                look(one, obstacle, stands)
        for i, (joint, link, body) in enumerate(bodies):
            for part in parts:
                # Pins and posts of the link that it is fixed to do not move against it.
                on_link = not part.name.startswith("link") and part.joints <= set(link)
                if joint not in part.joints and not on_link:
                    look(part, body)
            for obstacle in obstacles:
                look(body, obstacle)
            for other_joint, _, other in bodies[:i]:
                if other_joint != joint:
                    look(body, other)
        table = self.spec["table"]
        if table:
            # A post above nothing is as wide as a pin at most: the link that holds it is wider.
            for thing in [p for p in parts if p.low <= p.high or p.joints == {self.linkage.pole_joint}] + [b for _, _, b in bodies]:
                for ring in thing.rings:
                    on = inside(table, ring[0])
                    edge = min(between(*e, *f) for e in edges(ring) for f in edges(table)) if on else 0.0
                    best = min(best, (edge - thing.around, f"{thing.name} and the table's edge"))
        return best[0], best[1], margin


def random_spec(dice):
    """A given mechanism that works somewhere, with bodies, and perhaps a table and obstacles."""
    vertex = dice.choice(["pole", "tracer", "pen"])
    scale, rotation = dice.uniform(0.4, 2.2), dice.choice([0, 0, 180, dice.uniform(-170, 170)])
    k = cmath.rect(scale, math.radians(rotation))
    s = shape_of(k, vertex)
    if not 0.25 < abs(s) < 4 or 0 < abs(math.sin(cmath.phase(s))) < 0.15:
        return None
    va, vb = dice.uniform(80, 200), dice.uniform(80, 200)
    ax = vb / abs(s)
    if not 40 < ax < 300:
        return None
    pole = complex(dice.uniform(-50, 50), dice.uniform(-50, 50))
    mode = dice.randrange(len(modes(s)))
    linkage = Mechanism(k, vertex, va, vb, mode, pole)
    for _ in range(200):
        tracer = pole + cmath.rect(dice.uniform(20, 500), dice.uniform(-math.pi, math.pi))
        found = linkage.pose(tracer)
        if found and found[1] > 0.6:
            break
    else:
        return None
    layers = dice.choice([[1, 2, 2, 1], [2, 1, 1, 2], [1, 2, 3, 4], [1, 3, 3, 1], [2, 3, 1, 4]])
    spec = {"linkage": linkage, "scale": scale, "rotation": rotation, "vertex": vertex, "mode": mode, "layers": layers,
            "width": dice.uniform(6, 16), "plate": dice.choice(["bent", "bent", "triangle"]), "clearance": dice.uniform(0.2, 3),
            "bodies": [], "obstacles": [], "table": None}
    spec["pin"] = spec["width"] * dice.uniform(0.3, 0.8)
    for i in range(dice.randrange(1, 4)):
        low = dice.randrange(1, 6)
        body = {"name": f"thing {i + 1}", "at": dice.choice(["tracer", "pen"]), "layers": [low, dice.randrange(low, 9)]}
        if dice.random() < 0.45:
            joint = linkage.carrier[body["at"]]
            body["turns_with"] = dice.choice([link for link in ("VA", "VB", "ACX", "BCY") if joint in link])
        if dice.random() < 0.4:
            body.update(centre=complex(dice.uniform(-25, 25), dice.uniform(-25, 25)) * dice.choice([0, 1]), radius=dice.uniform(4, 50))
        else:
            corners, start = dice.randrange(3, 8), dice.uniform(0, 6)  # star-shaped about the point: simple, perhaps not convex
            body["ring"] = [cmath.rect(dice.uniform(6, 50), start + 2 * math.pi * j / corners) for j in range(corners)]
            away = complex(dice.uniform(-20, 20), dice.uniform(-20, 20))
            body["ring"] = [z + away for z in body["ring"]]
        spec["bodies"].append(body)
    joints = list(linkage.pose(tracer)[0].values())
    for i in range(dice.randrange(0, 3)):
        corners, centre, low = dice.randrange(3, 7), tracer + cmath.rect(dice.uniform(30, 250), dice.uniform(-3, 3)), dice.randrange(1, 4)
        spec["obstacles"].append({"name": f"block {i + 1}", "layers": [low, dice.randrange(low, 9)], "ring": [
            centre + cmath.rect(dice.uniform(5, 40), 2 * math.pi * j / corners) for j in range(corners)]})
    if dice.random() < 0.7:
        left, right = min(z.real for z in joints) - dice.uniform(10, 120), max(z.real for z in joints) + dice.uniform(10, 120)
        low, high = min(z.imag for z in joints) - dice.uniform(10, 120), max(z.imag for z in joints) + dice.uniform(10, 120)
        spec["table"] = [complex(left, low), complex(right, low), complex(right, high), complex(left, high)]
        if dice.random() < 0.4:  # a notch: not convex
            spec["table"].insert(3, complex((left + right) / 2, high - dice.uniform(1, 0.3 * (high - low))))
    size = dice.uniform(4, 14)
    spec["region"] = (tracer - complex(size, size) / 2, size)
    return spec


def pair(z):
    return f"[{z.real!r}, {z.imag!r}]"


def ring_text(ring):
    return "[" + ", ".join(map(pair, ring)) + "]"


def toml(spec):
    at, size = spec["region"]
    linkage = spec["linkage"]
    text = f"""[copy]
scale = {spec["scale"]!r}
rotation_deg = {spec["rotation"]!r}
[region]
rectangle_mm = {{at = {pair(at)}, size = [{size!r}, {size!r}]}}
[pole]
at_mm = {pair(linkage.pole)}
[links]
width_mm = {spec["width"]!r}
pin_diameter_mm = {spec["pin"]!r}
plate = "{spec["plate"]}"
layers = 8
longest_mm = 3000
shortest_mm = 1
[limits]
clearance_mm = {spec["clearance"]!r}
transmission_deg = 8
[mechanism]
vertex = "{spec["vertex"]}"
VA_mm = {linkage.va!r}
VB_mm = {linkage.vb!r}
assembly = {spec["mode"]}
layers = {spec["layers"]}
"""
    for body in spec["bodies"]:
        text += f'[[bodies]]\nname = "{body["name"]}"\nat = "{body["at"]}"\nlayers = {body["layers"]}\n'
        if "turns_with" in body:
            text += f'turns_with = "{body["turns_with"]}"\n'
        if "radius" in body:
            text += f'circle_mm = {{centre = {pair(body["centre"])}, radius = {body["radius"]!r}}}\n'
        else:
            text += f"polygon_mm = {ring_text(body['ring'])}\n"
    for obstacle in spec["obstacles"]:
        text += f'[[obstacles]]\nname = "{obstacle["name"]}"\nlayers = {obstacle["layers"]}\npolygon_mm = {ring_text(obstacle["ring"])}\n'
    if spec["table"]:
        text += f"[table]\npolygon_mm = {ring_text(spec['table'])}\n"
    return text


def polygons(features, layer):
    for feature in features:
        if feature["properties"]["layer"] == layer:
            geometry = feature["geometry"]
            for polygon in geometry["coordinates"] if geometry["type"] == "MultiPolygon" else [geometry["coordinates"]]:
                yield [[complex(*at) for at in ring[:-1]] for ring in polygon]


def holds(polygon, p):
    return inside(polygon[0], p) and not any(inside(hole, p) for hole in polygon[1:])


def within(areas, p):
    return any(holds(polygon, p) for polygon in areas)


def places_in(areas, count, dice):
    """Random places of polygons."""
    if not areas:
        return
    boxes = [(min(z.real for z in a[0]), max(z.real for z in a[0]), min(z.imag for z in a[0]), max(z.imag for z in a[0])) for a in areas]
    weights = [(b[1] - b[0]) * (b[3] - b[2]) for b in boxes]
    for _ in range(count):
        i = dice.choices(range(len(areas)), weights)[0]
        p = complex(dice.uniform(*boxes[i][:2]), dice.uniform(*boxes[i][2:]))
        if holds(areas[i], p):
            yield p


class Bodies(Case):
    specs, seed = 40, 22

    def test_maps_and_verification_agree_with_a_plain_sampling(self):
        dice = random.Random(self.seed)
        seen = {"specs": 0, "free places": 0, "lost places": 0, "covered": 0, "not covered": 0, "told apart by bodies or table": 0,
                "refused at the pole": 0, "turning bodies": 0}
        while seen["specs"] < self.specs:
            spec = random_spec(dice)
            if spec:
                self.look_at(spec, seen, dice, f"spec {seen['specs']}")
                seen["specs"] += 1
        print(", ".join(f"{count} {what}" for what, count in seen.items()), file=sys.stderr)
        self.assertGreater(seen["covered"], self.specs // 20)
        self.assertGreater(seen["told apart by bodies or table"], self.specs // 10)

    def look_at(self, spec, seen, dice, label):
        world, clearance = World(spec), spec["clearance"]
        seen["turning bodies"] += sum("turns_with" in body for body in spec["bodies"])
        file = self.scratch / "spec.toml"
        file.write_text(toml(spec))
        out = self.scratch / "out"
        run = kempe("workspace", file, "-o", out, "--quiet")
        if (at_pole := world.at_pole()) < clearance:
            # The pole moves nowhere: nothing is free, and no map is asked for.
            if at_pole < clearance - ROUNDING:
                self.assertEqual(run.returncode, 3, f"{label}: {at_pole} at the pole: {run.stderr}\n{toml(spec)}")
                self.assertIn("the pole", run.stderr)
            seen["refused at the pole"] += 1
            return
        self.assertEqual(run.returncode, 0, f"{label}: {run.stderr}\n{toml(spec)}")
        features = json.loads((out / "workspace.geojson").read_text())["features"]
        free, lost = list(polygons(features, "collision_free")), []
        for feature in features:
            if feature["properties"]["layer"] == "lost" and feature["properties"]["cause"] == "contact":  # not of the pen: copy_lost
                lost += list(polygons([feature], feature["properties"]["layer"]))
        for place in places_in(free, 60, dice):
            found = world.tightest(place)
            self.assertIsNotNone(found, f"{label}: {place} is called free and out of reach")
            self.assertGreaterEqual(found[0], clearance - ROUNDING, f"{label}: {found[1]} at {place}, called free\n{toml(spec)}")
            seen["free places"] += 1
        for place in places_in(lost, 60, dice):
            found = world.tightest(place)
            if found and not within(free, place):
                self.assertLess(found[0], clearance + LOST_SLACK, f"{label}: {found[1]} at {place}, called lost\n{toml(spec)}")
                seen["lost places"] += 1
        self.verify(world, spec, out, seen, label)

    def verify(self, world, spec, out, seen, label):
        at, size = spec["region"]
        steps = 16
        grid = [at + complex(i, j) * size / steps for i in range(steps + 1) for j in range(steps + 1)]
        found = [world.tightest(place) for place in grid]
        least = min((one or (-1.0, "out of reach") for one in found), key=lambda one: one[0])
        design = json.loads((out / "design.json").read_text())
        covered = design["workspace"]["region_covered"]
        if covered:
            seen["covered"] += 1
            self.assertGreaterEqual(least[0], spec["clearance"] - ROUNDING, f"{label}: {least[1]} in a region that is called covered")
            self.assertGreaterEqual(least[0], design["quality"]["clearance_min_mm"] - 0.02, f"{label}: the smallest gap is {least}")
        else:
            seen["not covered"] += 1
        run = kempe("verify", out / "design.json", "--json")
        self.assertEqual(run.returncode, 0, f"{label}: {run.stdout}{run.stderr}\n{toml(spec)}")
        if covered or least[0] >= spec["clearance"] - ROUNDING:
            return
        if "thing" in least[1] or "table" in least[1]:
            seen["told apart by bodies or table"] += 1
        forged = dict(design, workspace=dict(design["workspace"], region_covered=True))
        place = self.scratch / "forged.json"
        place.write_text(json.dumps(forged))
        run = kempe("verify", place, "--json")
        self.assertEqual(run.returncode, 4, f"{label}: {least} is not found: {run.stdout}{run.stderr}\n{toml(spec)}")
        broken = {one["limit"] for one in json.loads(run.stdout)["broken"]}
        self.assertIn("region", broken, f"{label}: {broken}")


def size_of(linkage):
    """Half the perimeter round each link's joints, summed."""
    s, va, vb = linkage.s, linkage.va, linkage.vb
    plates = (vb, vb / abs(s), abs(1 - s) * vb / abs(s)), (va, va * abs(s), va * abs(1 - s))
    return va + vb + sum(map(sum, plates)) / 2


def lengths_of(linkage):
    s, va, vb = linkage.s, linkage.va, linkage.vb
    return va, vb, vb / abs(s), abs(1 - s) * vb / abs(s), va * abs(s), va * abs(1 - s)


def stacks(most):
    """All layers of VA, VB, ACX, BCY in which links that share a joint differ."""
    for va, vb, acx, bcy in itertools.product(range(1, most + 1), repeat=4):
        if va not in (vb, acx) and bcy not in (vb, acx):
            yield [va, vb, acx, bcy]


def random_task(dice):
    """A copy, a region and a pole, with what moves along and what stands about."""
    scale, rotation = dice.choice([dice.uniform(0.4, 0.7), dice.uniform(1.5, 2)]), dice.choice([0, 0, 180, dice.uniform(40, 140)])
    away, size = cmath.rect(dice.uniform(180, 320), dice.uniform(-math.pi, math.pi)), (dice.uniform(40, 110), dice.uniform(40, 110))
    at, k = away - complex(*size) / 2, cmath.rect(scale, math.radians(rotation))
    task = {"k": k, "scale": scale, "rotation": rotation, "at": at, "size": size, "width": 14.0, "pin": 6.0, "plate": "bent",
            "clearance": 1.0, "transmission": 20.0, "shortest": 30.0, "longest": 600.0, "most": dice.choice([2, 3, 4]), "bodies": [],
            "obstacles": [], "table": None, "pole": 0j}
    for i in range(dice.randrange(1, 3)):
        low = dice.randrange(1, 3)
        body = {"name": f"thing {i + 1}", "at": dice.choice(["tracer", "pen"]), "layers": [low, dice.randrange(low, 9)]}
        if dice.random() < 0.5:
            body.update(centre=complex(dice.uniform(-15, 15), dice.uniform(-15, 15)), radius=dice.uniform(15, 50))
        else:
            body["ring"] = [cmath.rect(dice.uniform(15, 55), 2 * math.pi * j / 5) for j in range(5)]
        task["bodies"].append(body)
    if dice.random() < 0.5:
        centre = away * cmath.rect(dice.uniform(0.3, 1.4), dice.choice([-1, 1]) * dice.uniform(0.5, 1.5))
        task["obstacles"].append({"name": "block", "layers": [1, dice.randrange(1, 5)],
                                  "ring": [centre + cmath.rect(dice.uniform(10, 30), 2 * math.pi * j / 4) for j in range(4)]})
    if dice.random() < 0.3:
        xs, ys = (0, at.real, at.real + size[0]), (0, at.imag, at.imag + size[1])
        beyond = [dice.uniform(60, 160) for _ in range(4)]
        low, high = complex(min(xs) - beyond[0], min(ys) - beyond[1]), complex(max(xs) + beyond[2], max(ys) + beyond[3])
        task["table"] = [low, complex(high.real, low.imag), high, complex(low.real, high.imag)]
    return task


def things_toml(task):
    text = ""
    for body in task["bodies"]:
        text += f'[[bodies]]\nname = "{body["name"]}"\nat = "{body["at"]}"\nlayers = {body["layers"]}\n'
        text += (f"circle_mm = {{centre = {pair(body['centre'])}, radius = {body['radius']!r}}}\n" if "radius" in body
                 else f"polygon_mm = {ring_text(body['ring'])}\n")
    for obstacle in task["obstacles"]:
        text += f'[[obstacles]]\nname = "{obstacle["name"]}"\nlayers = {obstacle["layers"]}\npolygon_mm = {ring_text(obstacle["ring"])}\n'
    return text + (f"[table]\npolygon_mm = {ring_text(task['table'])}\n" if task["table"] else "")


def task_toml(task):
    return f"""[copy]
scale = {task["scale"]!r}
rotation_deg = {task["rotation"]!r}
[region]
rectangle_mm = {{at = {pair(task["at"])}, size = {list(task["size"])}}}
[links]
width_mm = {task["width"]}
pin_diameter_mm = {task["pin"]}
shortest_mm = {task["shortest"]}
longest_mm = {task["longest"]}
layers = {task["most"]}
[limits]
clearance_mm = {task["clearance"]}
transmission_deg = {task["transmission"]}
""" + things_toml(task)


class Rivals:
    """Linkages drawn at random for a task, and whether they do it, looked at place by place."""

    def __init__(self, task, vertices=("pole", "tracer", "pen")):
        self.task, self.vertices = task, vertices

    def places(self, steps):
        """Of the region, its corners first."""
        at, (wide, high) = self.task["at"], self.task["size"]
        grid = [at + complex(i * wide, j * high) / steps for i in range(steps + 1) for j in range(steps + 1)]
        corner = [at, at + wide, at + complex(wide, high), at + complex(0, high)]
        return corner + [z for z in grid if z not in corner]

    def drawn(self, dice, low, high):
        """A linkage with a size between two, its lengths within the limits; or None."""
        task, vertex = self.task, dice.choice(self.vertices)
        mode = dice.randrange(len(modes(shape_of(task["k"], vertex))))
        va = math.exp(dice.uniform(-1.2, 1.2))
        one = Mechanism(task["k"], vertex, va, 1.0, mode, task["pole"])
        grow = dice.uniform(low, high) / size_of(one)
        one = Mechanism(task["k"], vertex, va * grow, grow, mode, task["pole"])
        return one if task["shortest"] <= min(lengths_of(one)) and max(lengths_of(one)) <= task["longest"] else None

    def reaches(self, linkage, places):
        poses = [linkage.pose(place) for place in places]
        return all(poses) and min(pose[1] for pose in poses) >= math.radians(self.task["transmission"])

    def is_free(self, linkage, layers, places, without_bodies=False):
        found = dict(self.task, linkage=linkage, layers=layers)
        if without_bodies:
            found.update(bodies=[], table=None)
        world = World(found)
        return all((at := world.tightest(place)) and at[0] >= self.task["clearance"] for place in places)

    def winner(self, linkage, seen):
        """Layers in which a linkage does the task as far as many places tell."""
        few = self.places(4)
        if not self.reaches(linkage, few):
            return None
        free = [layers for layers in stacks(self.task["most"]) if self.is_free(linkage, layers, few[:4], True)]
        seen["would do without bodies"] += any(self.is_free(linkage, layers, few, True) for layers in free)
        many = self.places(40)
        return next((layers for layers in free if self.is_free(linkage, layers, few) and self.is_free(linkage, layers, many)), None)


class Bound(Case):
    tasks, seed = 8, 7

    def test_no_linkage_below_the_bound_does_the_task(self):
        dice = random.Random(self.seed)
        seen = {"designs": 0, "without a design": 0, "linkages drawn": 0, "would do without bodies": 0}
        for i in range(self.tasks):
            task = random_task(dice)
            file, out = self.scratch / "task.toml", self.scratch / "designed"
            file.write_text(task_toml(task))
            run = kempe("synthesize", file, "-o", out, "--quiet", "-j", "1", "--json")
            self.assertIn(run.returncode, (0, 3), f"task {i}: {run.stderr}\n{task_toml(task)}")
            if run.returncode == 0:
                bound = json.loads((out / "design.json").read_text())["quality"]["lower_bound"]
                low, high = 0.7 * bound, bound * (1 - 1e-9)
                seen["designs"] += 1
            elif "proven" in run.stdout + run.stderr:
                low, high = 500.0, 2500.0
                seen["without a design"] += 1
            else:
                continue
            self.look_for_winners(Rivals(task), dice, low, high, seen, 300, f"task {i}")
        print(", ".join(f"{count} {what}" for what, count in seen.items()), file=sys.stderr)
        self.assertGreater(seen["designs"], self.tasks // 4)
        self.assertGreater(seen["would do without bodies"], self.tasks)

    def look_for_winners(self, rivals, dice, low, high, seen, count, label):
        for _ in range(count):
            linkage = rivals.drawn(dice, low, high)
            if not linkage:
                continue
            seen["linkages drawn"] += 1
            layers = rivals.winner(linkage, seen)
            self.assertIsNone(layers, f"{label}: {linkage.vertex} at the vertex, mode {linkage.mode}, VA {linkage.va}, VB {linkage.vb}, layers "
                              f"{layers}: {size_of(linkage)} beats the bound {high}\n{task_toml(rivals.task)}")


class Pantorouter(Case):
    """The shipped example: a router at the pen, the follower's holder at the tracer, a backboard."""

    def setUp(self):
        super().setUp()
        self.out = self.scratch / "pantorouter"
        run = kempe("synthesize", EXAMPLE, "-o", self.out, "--quiet", "-j", "1")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.design = json.loads((self.out / "design.json").read_text())

    def task(self):
        """What the file says, as the oracle reads it."""
        design, (corners,) = self.design, self.design["region"]["coordinates"][0]
        at, size = complex(*map(min, zip(*corners))), [max(axis) - min(axis) for axis in zip(*corners)]

        def ring(shape):
            ((outer,),) = shape["coordinates"]
            return [complex(*corner) for corner in outer[:-1]]
        bodies = [dict(b, **({"centre": complex(*b["circle_mm"]["centre"]), "radius": b["circle_mm"]["radius"]} if "circle_mm" in b
                             else {"ring": ring(b["shape"])})) for b in design["bodies"]]
        mechanism, limits = design["mechanism"], design["limits"]
        return {"k": complex(*[design["copy"]["scale"], 0]), "scale": design["copy"]["scale"], "rotation": 0, "at": at, "size": size,
                "width": mechanism["link_width_mm"], "pin": mechanism["pin_diameter_mm"], "plate": "bent",
                "clearance": limits["clearance_mm"], "transmission": limits["transmission_deg"], "most": design["links"]["layers"],
                "shortest": design["links"]["shortest_mm"], "longest": design["links"]["longest_mm"], "bodies": bodies,
                "obstacles": [{"name": o["name"], "layers": o["layers"], "ring": ring(o["shape"])} for o in design["obstacles"]],
                "table": ring(design["table"]), "pole": complex(*mechanism["pole_position_mm"])}

    def world(self):
        task, mechanism = self.task(), self.design["mechanism"]
        linkage = Mechanism(task["k"], mechanism["vertex"], mechanism["lengths_mm"]["VA"], mechanism["lengths_mm"]["VB"],
                            mechanism["assembly"], task["pole"])
        return World(dict(task, linkage=linkage, layers=[link["layer"] for link in mechanism["links"]]))

    def test_is_clear_at_every_place_of_a_fine_grid(self):
        world, task = self.world(), self.task()
        found = [world.tightest(place) for place in Rivals(task).places(60)]
        self.assertTrue(all(found))
        self.assertGreaterEqual(min(found)[0], task["clearance"] - ROUNDING, min(found))
        self.assertAlmostEqual(min(found)[0], self.design["quality"]["clearance_min_mm"], delta=0.05, msg=min(found)[1])
        self.assertGreaterEqual(min(margin for _, _, margin in found), math.radians(task["transmission"] - 1e-6))
        self.assertIn("router", min(found)[1])

    def test_verify_finds_a_router_that_is_a_little_wider(self):
        file = self.scratch / "wider.json"
        for wider, code in ((0.0, 0), (0.1, 4)):
            design = json.loads(json.dumps(self.design))
            design["bodies"][0]["circle_mm"]["radius"] += wider
            file.write_text(json.dumps(design))
            run = kempe("verify", file, "--json")
            self.assertEqual(run.returncode, code, run.stdout + run.stderr)
            if code:
                self.assertIn("bodies", {one["limit"] for one in json.loads(run.stdout)["broken"]})

    def test_no_linkage_below_its_bound_does_its_task(self):
        bound = self.design["quality"]["lower_bound"]
        self.assertLess(self.design["search"]["value"], bound * (1 + 2e-4))
        seen = {"linkages drawn": 0, "would do without bodies": 0}
        rivals = Rivals(self.task(), self.design["objective"]["groundings"])
        Bound.look_for_winners(self, rivals, random.Random(5), 0.97 * bound, bound * (1 - 1e-9), seen, 700, "pantorouter")
        self.assertGreater(seen["would do without bodies"], 3)


if __name__ == "__main__":
    arguments = argparse.ArgumentParser()
    arguments.add_argument("kempe")
    arguments.add_argument("source")
    arguments.add_argument("--specs", type=int, default=Bodies.specs)
    arguments.add_argument("--tasks", type=int, default=Bound.tasks)
    arguments.add_argument("--seed", type=int, default=Bodies.seed)
    known, rest = arguments.parse_known_args()
    Bodies.specs, Bodies.seed, Bound.tasks = known.specs, known.seed, known.tasks
    EXAMPLE = pathlib.Path(known.source) / "specs/examples/pantorouter.toml"
    unittest.main(argv=[sys.argv[0], *rest])
