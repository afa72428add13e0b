#!/usr/bin/env python3
"""`kempe verify` from outside: every statement of a design's file is falsified alone, and must be found; whatever stays
true must still hold.

A kind of falsehood is tried on six of the designs that can have it, others for every kind; with KEMPE_EVERY=1 on all of them.

usage: verify_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import collections
import copy
import json
import math
import os
import pathlib
import random
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from program import EXAMPLES, POLE_IN_HOLE, kempe

DESIGNS_A_KIND = 6  # that a kind of falsehood is tried on

# What the examples do not have: a pole area, all limits at once, a stock, a grid that moves k, locks, tools, a load on what rests.
SPECS = {
    "everything": """
[copy]
scale = 0.5
rotation_deg = 150
[region]
rectangle_mm = {at = [120, -30], size = [60, 40]}
[pole]
within_mm = [[-20, -20], [20, -20], [20, 20], [-20, 20]]
[links]
width_mm = 10
pin_diameter_mm = 5
layers = 3
shortest_mm = 20
longest_mm = 300
[limits]
sheets_gap_mm = 5
copy_error_mm = 0.9
[tolerance]
length_mm = 0.05
play_mm = 0.02
[tool]
follower_radius_mm = 3
cutter_radius_mm = 1
[[obstacles]]
name = "vice"
rectangle_mm = {at = [-60, 120], size = [120, 30]}
layers = [1, 4]
[objective]
groundings = ["pole", "pen"]
""",
    "grid": """
[copy]
scale = 1.37
rotation_deg = 60
[region]
rectangle_mm = {at = [80, -20], size = [40, 30]}
[links]
grid_mm = 5
width_mm = 8
pin_diameter_mm = 4
""",
    "locked": """
[copy]
scale = 2
rotation_deg = 90
[region]
rectangle_mm = {at = [40, -10], size = [20, 15]}
[links]
VA_mm = 60
width_mm = 6
pin_diameter_mm = 3
[objective]
maximize = "transmission"
""",
    "resting": """
[copy]
scale = 0.6
rotation_deg = 180
[region]
rectangle_mm = {at = [60, -20], size = [40, 30]}
[links]
width_mm = 12
thickness_mm = 4
hardware = {default = "M5 bolt", A = "M4 bolt"}
[material]
name = "aluminium"
[load]
pen_N = 8
rests = ["tracer"]
pen_mass_kg = 0.3
""",
}

# Tolerances that are not small beside its links, at the edge of its range.
ROUGHLY_MADE = """
[copy]
scale = 0.5
rotation_deg = 60
[region]
rectangle_mm = {at = [50, -10], size = [30, 30]}
[links]
width_mm = 10
thickness_mm = 5
plate = "triangle"
layers = 3
longest_mm = 600
pin_diameter_mm = 3
[limits]
clearance_mm = 0.5
transmission_deg = 20
copy_error_mm = 3.5
[tolerance]
length_mm = 0.2
play_mm = 0.1
[objective]
minimize = "size"
groundings = ["pen"]
"""
SMALLEST_TO_THE_FIRST_ORDER = """
[mechanism]
vertex = "pen"
VA_mm = 43.4331516203
VB_mm = 35.8636506692
"""

# Plates of three holes nearly in line, still made by three lengths.
NEARLY_STRAIGHT = """
[copy]
scale = 0.5
rotation_deg = 3
[region]
rectangle_mm = {at = [50, -10], size = [30, 30]}
[links]
width_mm = 10
thickness_mm = 5
plate = "triangle"
layers = 3
pin_diameter_mm = 3
[limits]
transmission_deg = 20
[tolerance]
length_mm = 0.05
play_mm = 0.02
[objective]
groundings = ["pole"]
"""


def corners(design):
    return [corner for rings in design["region"]["coordinates"] for ring in rings for corner in ring]


def middle(design):
    points = corners(design)
    return [(min(p[i] for p in points) + max(p[i] for p in points)) / 2 for i in (0, 1)]


def extent(design):
    points = corners(design)
    return max(max(p[i] for p in points) - min(p[i] for p in points) for i in (0, 1))


def square(centre, half):
    x, y = centre
    return {"type": "MultiPolygon", "coordinates": [[[[x - half, y - half], [x + half, y - half], [x + half, y + half],
                                                      [x - half, y + half], [x - half, y - half]]]]}



def falsehoods(design):
    """(key that must be found broken, a function that makes the file state it)."""
    mechanism, quality, workspace = design["mechanism"], design["quality"], design["workspace"]
    made = []

    def add(key, change):
        made.append((key, change))

    def scaled(table, key, factor=1.02, name=None):
        def change(d):
            d[table][key] *= factor
        value = design[table].get(key)
        if value:
            add(name or f"{table}.{key}", change)

    for name in mechanism["lengths_mm"]:
        add(f"mechanism.lengths_mm.{name}", lambda d, n=name: d["mechanism"]["lengths_mm"].update(
            {n: d["mechanism"]["lengths_mm"][n] * 1.02}))
    add("mechanism.shape", lambda d: d["mechanism"].update(shape=[d["mechanism"]["shape"][0] + 0.01, d["mechanism"]["shape"][1]]))
    add("mechanism.assembly", lambda d: d["mechanism"].update(assembly=(d["mechanism"]["assembly"] + 1) % 2))
    add("mechanism.orientation", lambda d: d["mechanism"]["orientation"].update(
        parallelogram=-d["mechanism"]["orientation"]["parallelogram"]))
    lower, upper = mechanism["opening_deg"]
    add("mechanism.opening_deg", lambda d: d["mechanism"].update(opening_deg=[max(lower - 2, -180), upper]))
    add("mechanism.opening_deg", lambda d: d["mechanism"].update(opening_deg=[lower, min(upper + 2, 180)]))
    add("mechanism.opening_deg", lambda d: d["mechanism"].update(opening_deg=[lower, lower + 1e-3]))
    add("mechanism.links", lambda d: d["mechanism"]["links"][0].update(layer=d["mechanism"]["links"][1]["layer"]))
    add("mechanism.pin_diameter_mm", lambda d: d["mechanism"].update(pin_diameter_mm=d["mechanism"]["link_width_mm"] * 1.02))
    add("mechanism.shape", lambda d: d["copy"].update(scale=d["copy"]["scale"] * 1.02))
    add("mechanism.shape", lambda d: d["copy"].update(rotation_deg=d["copy"]["rotation_deg"] + 2))

    def obstacle(d, size, at):
        d["obstacles"] = d.get("obstacles", []) + [{"name": "vice", "shape": square(at, size / 2), "layers": [1, 8]}]

    for size in (0.3 * extent(design), 60):
        add("obstacles", lambda d, s=size: obstacle(d, s, middle(d)))
        add("region", lambda d, s=size: obstacle(d, s, middle(d)))
    add("obstacles", lambda d: obstacle(d, 1, d["mechanism"]["pole_position_mm"]))

    def enlarge(d):
        x, y = middle(d)
        for corner in corners(d):
            corner[0], corner[1] = x + 20 * (corner[0] - x), y + 20 * (corner[1] - y)
    add("region", enlarge)

    def move_corner(d):
        ring = d["region"]["coordinates"][0][0]
        far = max(range(len(ring)), key=lambda i: math.dist(ring[i], d["mechanism"]["pole_position_mm"]))
        moved = [ring[far][0] + 1e4 * (ring[far][0] - middle(d)[0]), ring[far][1] + 1e4 * (ring[far][1] - middle(d)[1])]
        d["region"]["coordinates"][0][0] = [moved if p == ring[far] else p for p in ring]
    add("region", move_corner)

    add("verification.certified", lambda d: d["verification"].update(certified=False, failure="broken"))
    add("limits.transmission_deg", lambda d: d["limits"].update(transmission_deg=quality["transmission_min_deg"] + 0.5))
    if quality["clearance_min_mm"] is not None:
        add("limits.clearance_mm", lambda d: d["limits"].update(clearance_mm=quality["clearance_min_mm"] + 0.05))
    add("limits.sheets_gap_mm", lambda d: d["limits"].update(sheets_gap_mm=1e4))
    if design["tolerance"]:
        add("limits.copy_error_mm", lambda d: d["limits"].update(copy_error_mm=1e-9))
        add("limits.copy_error_mm", lambda d: d["limits"].update(copy_error_mm=0.98 * quality["copy_error_worst_mm"]))
        add("quality.copy_error_worst_mm", lambda d: d["tolerance"].update(length_mm=1.1 * d["tolerance"]["length_mm"]))
    else:
        add("limits.copy_error_mm", lambda d: d["limits"].update(copy_error_mm=1e-9))  # under no tolerance nothing is kept

        def tolerance(d):
            d["tolerance"] = {"length_mm": 0.05, "play_mm": 0.02}
            d["limits"]["copy_error_mm"] = 1e-9
        add("limits.copy_error_mm", tolerance)

    if not design.get("bodies") and not design.get("table"):  # beside these it is refused
        add("tolerance.robust", lambda d: d.update(tolerance={"length_mm": 9, "play_mm": 0, "robust": True}))
    if "robust" in quality:
        add("tolerance.robust", lambda d: d["tolerance"].update(length_mm=1.5 * d["tolerance"]["length_mm"]))
        if design["objective"]:
            add("quality.robust.holds", lambda d: d["quality"]["robust"].update(holds=False))
        add("quality.robust.clearance_min_mm", lambda d: d["quality"]["robust"].update(
            clearance_min_mm=quality["robust"]["clearance_min_mm"] + 0.05))
        add("quality.robust.clearance_loss_mm", lambda d: d["quality"]["robust"].update(
            clearance_loss_mm=quality["robust"]["clearance_loss_mm"] + 0.05))

    if design["links"]:
        lengths = mechanism["lengths_mm"].values()
        add("links.shortest_mm", lambda d: d["links"].update(shortest_mm=1.02 * min(lengths)))
        add("links.longest_mm", lambda d: d["links"].update(longest_mm=0.98 * max(lengths)))
        bore = mechanism["pin_diameter_mm"] + max(0, design["cutting"]["hole_fit_mm"])
        add("links.wall_mm", lambda d: d["links"].update(wall_mm=1.02 * (min(lengths) - bore)))
        add("links.layers", lambda d: d["mechanism"]["links"][0].update(layer=9))
        add("links.grid_mm", lambda d: d["links"].update(grid_mm=0.9973 * mechanism["lengths_mm"]["VA"]))
        add("links.stock_mm", lambda d: d["links"].update(stock_mm=[0.98 * x for x in lengths]))
        for name in mechanism["lengths_mm"]:
            add(f"links.{name}_mm", lambda d, n=name: d["links"].update({n + "_mm": 1.02 * mechanism["lengths_mm"][n]}))
        at = mechanism["pole_position_mm"]
        add("pole.at_mm", lambda d: d.update(pole={"at_mm": [at[0] + 1, at[1]]}))
        add("pole.within_mm", lambda d: d.update(pole={"within_mm": square([at[0] + 5, at[1]], 4)}))
        other = next(v for v in ("pole", "tracer", "pen") if v != mechanism["vertex"])
        add("objective.groundings", lambda d: d.update(objective={"groundings": [other]}))
        add("cutting.hole_fit_mm", lambda d: d["cutting"].update(hole_fit_mm=min(lengths)))

    for key in ("size_mm", "clearance_min_mm", "copy_error_worst_mm", "copy_error_rss_mm", "distortion_worst_mm", "footprint_mm2"):
        if key != "clearance_min_mm" or not design["obstacles"]:  # among obstacles it is certain to 0.01 mm only
            scaled("quality", key)
    for key in ("load_error_layered_max_mm", "load_rise_max_mm", "stress_layered_max_MPa", "pin_force_max_N", "weight_error_max_mm",
                "weight_error_layered_max_mm", "weight_rise_max_mm"):  # both ways: they are the most, not bounds
        for factor in (0.999, 1.001):
            scaled("quality", key, factor)
    add("quality.clearance_min_mm", lambda d: d["quality"].update(clearance_min_mm=(quality["clearance_min_mm"] or 0) + 0.05))
    add("quality.transmission_min_deg", lambda d: d["quality"].update(transmission_min_deg=0.98 * quality["transmission_min_deg"]))
    for key in ("reachable_mm2", "usable_mm2", "collision_free_mm2"):
        scaled("workspace", key)
    add("workspace.uncertain_mm2", lambda d: d["workspace"].update(uncertain_mm2=workspace["uncertain_mm2"] + 0.01 * workspace["usable_mm2"]))
    add("workspace.region_covered", lambda d: d["workspace"].update(region_covered=False))
    if workspace["sheets"]:
        add("workspace.sheets", lambda d: d["workspace"]["sheets"][0].update(centre_mm=d["mechanism"]["pole_position_mm"]))
        add("workspace.sheets", lambda d: d["workspace"]["largest_sheet"].update(width_mm=1e5))
        if workspace["sheets"][0]["name"].startswith("A"):
            add("workspace.sheets", lambda d: d["workspace"]["sheets"][0].update(width_mm=1.001 * d["workspace"]["sheets"][0]["width_mm"]))
        for factor in (0.98, 1.02):  # both sides: a sheet that is only wider may still fit
            add("workspace.sheets", lambda d, f=factor: [
                s.update(width_mm=f * s["width_mm"], height_mm=f * s["height_mm"]) for s in d["workspace"]["sheets"]])
        add("workspace.largest_sheet", lambda d: d["workspace"]["largest_sheet"].update(
            height_mm=0.98 * d["workspace"]["largest_sheet"]["height_mm"]))
    scaled("search", "value")
    if quality["lower_bound"] is not None:
        wrong = 0.95 if design["search"]["objective"] == "transmission" else 1.05
        add("quality.lower_bound", lambda d: d["quality"].update(lower_bound=wrong * design["search"]["value"]))
    add("verification.flips", lambda d: d["verification"].update(flips=1))
    scaled("verification", "scale")
    add("verification.rotation_deg", lambda d: d["verification"].update(rotation_deg=d["verification"]["rotation_deg"] + 1))
    add("verification.copy_error_max_mm", lambda d: d["verification"].update(copy_error_max_mm=1))
    add("verification.loop_residual_max_mm", lambda d: d["verification"].update(loop_residual_max_mm=1))
    if "ratio_error" in design["copy"]:
        add("copy.ratio_error", lambda d: d["copy"].update(wanted_scale=1.02 * d["copy"]["wanted_scale"]))
        scaled("copy", "ratio_error")
    if design["tool"]:
        for key in ("exact_follower_radius_mm", "exact_cutter_radius_mm", "cut_outside_mm", "template_offset_mm"):
            scaled("tool", key)
    return made


def truths(design, rng):
    """Changes after which the file still states nothing but the truth."""
    far = 1e5
    links = design["links"]

    def start_elsewhere(d):
        ring = d["region"]["coordinates"][0][0]
        start = rng.randrange(len(ring) - 1)
        d["region"]["coordinates"][0][0] = ring[start:-1] + ring[:start] + [ring[start]]

    def obstacle_out_of_reach(d):
        turn = rng.uniform(-math.pi, math.pi)
        at = [d["mechanism"]["pole_position_mm"][0] + far * math.cos(turn), d["mechanism"]["pole_position_mm"][1] + far * math.sin(turn)]
        d["obstacles"].append({"name": "wall", "shape": square(at, rng.uniform(1, 1000)), "layers": [1, rng.randint(1, 8)]})

    def obstacle_above(d):
        lowest = 1 + max([link["layer"] for link in d["mechanism"]["links"]] + [body["layers"][1] for body in d.get("bodies", [])])
        d["obstacles"].append({"name": "lamp", "shape": square(middle(d), rng.uniform(1, 500)), "layers": [lowest, 20]})

    def rounding(d):
        for key in ("size_mm", "footprint_mm2", "copy_error_worst_mm"):
            if d["quality"][key]:
                d["quality"][key] *= 1 + rng.uniform(-1, 1) * 1e-13

    def narrower_opening(d):
        lower, upper = d["mechanism"]["opening_deg"]
        d["mechanism"]["opening_deg"] = [lower + 1e-9 * rng.random(), upper - 1e-9 * rng.random()]

    def other_order(d):
        items = list(d.items())
        rng.shuffle(items)
        d.clear()
        d.update(items)

    def note(d):
        d["note_" + str(rng.randint(0, 999))] = "cut on Monday"

    changes = [start_elsewhere, obstacle_out_of_reach, obstacle_above, rounding, narrower_opening, other_order, note,
               lambda d: d["search"].update(evaluations=rng.randint(0, 10**6), seed=rng.randint(0, 99)),
               lambda d: d["workspace"].update(largest_sheet={}, sheets=[]),
               lambda d: d["cutting"].update(gap_mm=rng.uniform(0, 50)),
               lambda d: d.update(why_not_fewer_layers=[])]
    if design["quality"]["lower_bound"] is not None:
        share = rng.uniform(0.5, 1)
        changes.append(lambda d: d["quality"].update(lower_bound=(
            d["quality"]["lower_bound"] * (1 / share if d["search"]["objective"] == "transmission" else share))))
    if links:
        changes += [lambda d: d["links"].update(shortest_mm=d["links"]["shortest_mm"] * rng.uniform(0.1, 1)),
                    lambda d: d["links"].update(wall_mm=d["links"]["wall_mm"] * rng.uniform(0.1, 1)),
                    lambda d: d["links"].update(longest_mm=d["links"]["longest_mm"] * rng.uniform(1, 10)),
                    lambda d: d["links"].update(layers=d["links"]["layers"] + rng.randint(0, 3)),
                    lambda d: d["objective"].update(groundings=["pole", "tracer", "pen"]),
                    lambda d: d.update(pole={"within_mm": square(d["mechanism"]["pole_position_mm"], rng.uniform(1e-3, 1e3))})]
        if links["grid_mm"]:
            changes.append(lambda d: d["links"].update(grid_mm=d["links"]["grid_mm"] / rng.randint(1, 5)))
        if links["stock_mm"]:
            changes.append(lambda d: d["links"]["stock_mm"].append(rng.uniform(1, 1e3)))
    return changes


UNCOVERED = """
[copy]
scale = 1.4
rotation_deg = 90
[region]
rectangle_mm = {{at = [40, -40], size = [120, 80]}}
[links]
width_mm = 6
pin_diameter_mm = 3
[limits]
transmission_deg = 30
{sheets_gap}
[[obstacles]]
polygon_mm = [[-40, 60], [-30, 60], [-30, 70], [-40, 70]]
[mechanism]
vertex = "pole"
VA_mm = 50
VB_mm = 35
assembly = 3
"""


class Verify(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(__import__("shutil").rmtree, cls.scratch)
        specs = sorted(EXAMPLES.glob("*.toml"))
        for name, text in SPECS.items():
            specs.append(cls.scratch / f"{name}.toml")
            specs[-1].write_text(text)
        cls.designs = {}
        for spec in specs:
            command = "workspace" if "[mechanism]" in spec.read_text() else "synthesize"
            out = cls.scratch / spec.stem
            run = kempe(command, spec, "-o", out, "--quiet")
            assert run.returncode == 0, f"{spec.name}: {run.stderr}"
            cls.designs[spec.stem] = json.loads((out / "design.json").read_text())

    def synthesize_text(self, text, *arguments, command="synthesize"):
        spec = self.scratch / "rough.toml"
        spec.write_text(text)
        run = kempe(command, spec, "-o", self.scratch / "rough", *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def verify(self, design, *arguments):
        path = self.scratch / "stated.json"
        path.write_text(json.dumps(design))
        return kempe("verify", path, *(arguments or ["--json"]))

    def assertCertified(self, run, message=""):
        self.assertEqual(run.returncode, 0, f"{message}: {run.stderr}")
        found = json.loads(run.stdout)
        self.assertTrue(found["certified"])
        self.assertEqual(found["broken"], [])
        return found

    def assertBroken(self, run, key):
        self.assertEqual(run.returncode, 4, f"{key}: {run.stdout} {run.stderr}")
        found = json.loads(run.stdout)
        self.assertFalse(found["certified"])
        broken = {one["limit"]: one for one in found["broken"]}
        self.assertIn(key, broken)
        self.assertIn(key, found["checked"])
        self.assertIn(key, run.stderr)
        self.assertEqual(set(broken[key]), {"limit", "attained", "allowed", "where_mm", "sentence"})
        return broken[key]

    def test_every_design_written_holds_and_every_limit_named(self):
        for name, design in self.designs.items():
            with self.subTest(name):
                found = self.assertCertified(self.verify(design), name)
                said = set(found["checked"]) | {one["key"] for one in found["not_checked"]}
                for table in ("limits", "links"):
                    for key, value in (design[table] or {}).items():
                        if value not in (None, []):
                            self.assertIn(f"{table}.{key}", said)
                quality = {f"quality.{k}": v for k, v in design["quality"].items() if k != "robust"}
                quality |= {f"quality.robust.{k}": v for k, v in design["quality"].get("robust", {}).items()}
                for key, value in {**quality,
                                   **{f"workspace.{k}": v for k, v in design["workspace"].items() if k.endswith("mm2")}}.items():
                    if value is not None:
                        self.assertIn(key, said)
                for key in ["region", "copy", "mechanism.opening_deg"] + ["obstacles"] * bool(design["obstacles"]):
                    self.assertIn(key, found["checked"])

    def test_every_falsehood_is_found(self):
        kinds = collections.defaultdict(list)  # of a key the first, second, ... falsehood that a design can have
        for name, design in self.designs.items():
            seen = collections.Counter()
            for key, change in falsehoods(design):
                kinds[key, seen[key]].append((name, change))
                seen[key] += 1
        rng = random.Random(1)
        for (key, _), all_of_them in kinds.items():
            tried = all_of_them if os.environ.get("KEMPE_EVERY") else rng.sample(all_of_them, min(DESIGNS_A_KIND, len(all_of_them)))
            for name, change in tried:
                with self.subTest(f"{name}: {key}"):
                    stated = copy.deepcopy(self.designs[name])
                    change(stated)
                    self.assertBroken(self.verify(stated), key)

    def test_areas_errors_and_forces_below_zero_are_refused(self):
        design = self.designs["pantorouter-upright"]
        signed = {"quality.clearance_min_mm", "quality.lower_bound", "verification.rotation_deg", "verification.scale"}
        tried = 0
        for table in ("quality", "workspace", "verification"):
            for key, value in design[table].items():
                if f"{table}.{key}" in signed or type(value) is not float or key == "map_tolerance":
                    continue
                stated = copy.deepcopy(design)
                stated[table][key] = -1.0
                with self.subTest(f"{table}.{key}"):
                    run = self.verify(stated)
                    self.assertEqual(run.returncode, 2, run.stderr)
                    self.assertIn(f"{table}.{key}: found -1", run.stderr)
                tried += 1
        self.assertGreater(tried, 15)

    def test_figures_of_a_breach_are_those_of_the_plane(self):
        """Attained, allowed and place, computed here by the plainest means."""
        for name, design in self.designs.items():
            with self.subTest(name):
                stated = copy.deepcopy(design)
                stated["limits"]["sheets_gap_mm"] = 1e4
                breach = self.assertBroken(self.verify(stated), "limits.sheets_gap_mm")
                pole = complex(*design["mechanism"]["pole_position_mm"])
                k = complex(*(design["copy"]["scale"] * f(math.radians(design["copy"]["rotation_deg"])) for f in (math.cos, math.sin)))
                points = [complex(*p) for p in corners(design)]
                most = min(abs(p - (pole + k * (q - pole))) for p in points for q in points)
                self.assertLessEqual(breach["attained"], most + 1e-6)
                self.assertEqual(breach["allowed"], 1e4)
                stated = copy.deepcopy(design)
                at = middle(design)
                stated["obstacles"].append({"shape": square(at, 1), "layers": [1, 8]})
                breach = self.assertBroken(self.verify(stated), "obstacles")
                self.assertLess(breach["attained"], breach["allowed"])
                reach = max(abs(p - pole) for p in points)
                self.assertLessEqual(abs(complex(*breach["where_mm"]) - pole), reach * (1 + 1e-9))

    def test_a_given_mechanism_that_does_not_cover_its_region(self):
        for sheets_gap in ("", "sheets_gap_mm = 3"):
            spec = self.scratch / "uncovered.toml"
            spec.write_text(UNCOVERED.format(sheets_gap=sheets_gap))
            run = kempe("workspace", spec, "-o", self.scratch / "uncovered")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("NOT COVERED", run.stdout)
            design = json.loads((self.scratch / "uncovered" / "design.json").read_text())
            self.assertFalse(design["workspace"]["region_covered"])
            found = self.assertCertified(self.verify(design))
            self.assertEqual(found["driven_over"], "workspace")
            unsaid = {one["key"] for one in found["not_checked"]}
            self.assertLessEqual({"region", "obstacles", "limits.clearance_mm", "limits.transmission_deg"}, unsaid)
            self.assertEqual("limits.sheets_gap_mm" in unsaid, bool(sheets_gap))
            for key, change in falsehoods(design):
                if key.startswith(("mechanism.", "workspace.", "verification.", "quality.size")) and key != "workspace.region_covered":
                    with self.subTest(key):
                        told = copy.deepcopy(design)
                        change(told)
                        self.assertBroken(self.verify(told), key)
            self.assertBroken(self.verify({**design, "workspace": {**design["workspace"], "region_covered": True}}),
                              "workspace.region_covered")
            searched = {**design, "objective": self.designs["plagiograph"]["objective"], "links": self.designs["plagiograph"]["links"],
                        "pole": self.designs["plagiograph"]["pole"]}
            self.assertBroken(self.verify(searched), "region")  # what was searched for must cover it

    def test_what_stays_true_holds(self):
        rng = random.Random(1)
        names = sorted(self.designs)
        for i in range(100):
            name = names[i % len(names)]
            stated = copy.deepcopy(self.designs[name])
            for change in rng.sample(truths(stated, rng), 3):
                change(stated)
            with self.subTest(f"{name}, {i}"):
                self.assertCertified(self.verify(stated), f"{name}, {i}")

    def test_the_worst_instrument_found_stands_beside_a_first_order_that_understates_it(self):
        run = self.synthesize_text(ROUGHLY_MADE)
        self.assertIn("to the first order, which is too small here", run.stdout)
        self.assertNotIn("kept to the first order alone", run.stdout)
        design = json.loads((self.scratch / "rough" / "design.json").read_text())
        quality = design["quality"]
        self.assertGreater(quality["copy_error_at_corner_mm"], 1.1 * quality["copy_error_worst_mm"])
        self.assertLess(quality["copy_error_at_corner_mm"], 3.5)  # the limit, which the first order alone would keep with smaller links
        self.assertGreater(quality["size_mm"], 1.05 * quality["lower_bound"])
        found = self.assertCertified(self.verify(design))
        self.assertIn("quality.copy_error_at_corner_mm", found["checked"])

        run = self.synthesize_text(ROUGHLY_MADE + SMALLEST_TO_THE_FIRST_ORDER, command="workspace")
        kept_to_first_order = "more than the 3.5 mm that limits.copy_error_mm allows, which are kept to the first order alone"
        self.assertIn(kept_to_first_order, run.stdout)
        out = self.scratch / "rough"
        report = (out / "report.html").read_text()
        self.assertIn(kept_to_first_order, report)
        self.assertIn("An instrument can exceed the limit on the copy error", report)
        design = json.loads((out / "design.json").read_text())
        found = self.assertCertified(self.verify(design))
        self.assertIn("limits.copy_error_mm", {one["key"] for one in found["not_checked"]})
        for factor in (0.93, 1.07):
            wrong = copy.deepcopy(design)
            wrong["quality"]["copy_error_at_corner_mm"] *= factor
            self.assertBroken(self.verify(wrong), "quality.copy_error_at_corner_mm")
        older = copy.deepcopy(design)
        del older["quality"]["copy_error_at_corner_mm"]
        unsaid = {one["key"]: one["why"] for one in self.assertCertified(self.verify(older))["not_checked"]}
        self.assertIn("understates", unsaid["quality.copy_error_at_corner_mm"])

    def test_plates_that_may_not_exist_are_named(self):
        run = self.synthesize_text(NEARLY_STRAIGHT)
        self.assertRegex(run.stdout, r"plate (ACX|BCY) can be impossible to make: lengths off by 0\.0\d+ mm or more")
        self.assertIn("can be impossible to make", (self.scratch / "rough" / "report.html").read_text())
        notes = json.loads(self.synthesize_text(NEARLY_STRAIGHT, "--json").stdout)["notes"]
        self.assertTrue(any("can be impossible to make" in note for note in notes), notes)

    def test_what_an_older_file_does_not_state_is_named(self):
        for name, design in self.designs.items():
            with self.subTest(name):
                stated = copy.deepcopy(design)
                for key in ("limits", "tolerance", "links", "pole", "objective", "cutting", "obstacles", "tool", "search"):
                    stated.pop(key)
                for key in ("copy_error_worst_mm", "copy_error_rss_mm", "distortion_worst_mm", "sag_max_mm"):  # of tolerances
                    stated["quality"][key] = None
                if design["obstacles"]:
                    stated["quality"]["clearance_min_mm"] = None
                    continue  # its clearance is that to obstacles which are no longer there
                found = self.assertCertified(self.verify(stated), name)
                said = {one["key"] for one in found["not_checked"]}
                self.assertLessEqual({"limits", "links", "pole", "objective", "obstacles"}, said)

    def test_limits_of_another_version_are_refused_and_other_keys_named(self):
        for table, key in (("limits", "noise_mm"), ("limits", "transmision_deg"), ("tolerance", "length_um"),
                           ("links", "widest_mm"), ("pole", "near_mm"), ("objective", "forbidden")):
            stated = copy.deepcopy(self.designs["everything"])
            stated[table][key] = 1
            run = self.verify(stated)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(f"{table}.{key}", run.stderr)
        stated = copy.deepcopy(self.designs["everything"])
        stated["obstacles"][0]["height_mm"] = 3
        self.assertEqual(self.verify(stated).returncode, 2)
        stated = copy.deepcopy(self.designs["everything"])
        stated["title"] = "Shop sign"
        stated["engraver"], stated["quality"]["mass_kg"] = "Ada", 1.2
        unchecked = {one["key"] for one in self.assertCertified(self.verify(stated))["not_checked"]}
        self.assertLessEqual({"engraver", "quality.mass_kg"}, unchecked)
        self.assertNotIn("title", unchecked)

    def test_rings_that_are_no_region_are_refused(self):
        stated = copy.deepcopy(self.designs["plagiograph"])
        (x, y), size = middle(stated), 3
        stated["region"]["coordinates"] = [[[[x, y], [x + size, y + size], [x + size, y], [x, y + size], [x, y]]]]
        run = self.verify(stated)
        self.assertEqual(run.returncode, 2)
        self.assertIn("region", run.stderr)

    def test_the_weakest_transmission_is_where_it_is_said(self):
        """The pole stands in a hole of the region: the nearest place lies on the hole's edge."""
        spec = self.scratch / "hole.toml"
        spec.write_text(POLE_IN_HOLE)
        self.assertEqual(kempe("workspace", spec, "-o", self.scratch / "hole", "--quiet").returncode, 0)
        stated = json.loads((self.scratch / "hole" / "design.json").read_text())
        stated["limits"]["transmission_deg"] = 17.4
        broken = self.assertBroken(self.verify(stated), "limits.transmission_deg")
        at = ",".join(str(x) for x in broken["where_mm"])
        told = kempe("workspace", spec, f"--why={at}").stdout
        self.assertAlmostEqual(math.hypot(*broken["where_mm"]), 30, delta=1e-6, msg=told)

    def test_the_proof_of_a_bound_is_named_where_its_log_stands(self):
        design = self.designs["plagiograph"]
        self.assertIsNotNone(design["quality"]["lower_bound"])
        self.assertNotIn("certificate.jsonl", self.verify(design, "--quiet").stdout)
        log = self.scratch / "certificate.jsonl"
        log.write_text("")
        run = self.verify(design, "--quiet")
        log.unlink()
        self.assertIn(f"proof/kempe_check.py {self.scratch / 'stated.json'} {log}", run.stdout)

    def test_the_words_say_the_same(self):
        design = copy.deepcopy(self.designs["clamped-plate"])
        run = self.verify(design, "--quiet")
        self.assertEqual(run.returncode, 0)
        self.assertTrue(run.stdout.startswith("holds "))
        design["obstacles"].append({"name": "block", "shape": square(middle(design), 30), "layers": [1, 8]})
        run = self.verify(design, "--quiet")
        self.assertEqual(run.returncode, 4)
        self.assertTrue(run.stdout.startswith("DOES NOT HOLD"))
        said = json.loads(self.verify(design, "--quiet", "--json").stdout)
        for word in ("broken       obstacles: ", "block", f"checked      {len(said['checked'])} statements", "not checked  search: "):
            self.assertIn(word, run.stdout)
        self.assertIn("limits.transmission_deg", said["checked"])
        self.assertFalse(said["certified"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
