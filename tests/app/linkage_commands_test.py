#!/usr/bin/env python3
"""solve, mobility and centres from outside: what a person types, what must come of it.

usage: linkage_commands_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import csv
import html.parser
import io
import json
import math
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import EXAMPLES, KEMPE, kempe

LINKAGES = EXAMPLES / "linkages"

BARS = """
[ground]
A = [0, 0]
D = [60, 0]
[links]
crank = { joints = ["A", "B"], A-B = 20 }
rod = { joints = ["B", "C"], B-C = 50 }
rocker = { joints = ["D", "C"], D-C = 40 }
[guess]
C = [45, 38]
"""
TURN = """
[[drivers]]
angle = "crank"
from_deg = 0
to_deg = 360
"""


class Case(program.Case):
    def linkage(self, text):
        path = self.scratch / "linkage.toml"
        path.write_text(text)
        return path

    def assertRefused(self, run, code, *words):
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertNotIn("nan", run.stdout.lower())


class Solve(Case):
    def test_press_table(self):
        table = self.scratch / "press.csv"
        run = kempe("solve", LINKAGES / "shear-press.toml", "-o", table)
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = list(csv.DictReader(io.StringIO(table.read_text())))
        self.assertEqual(len(rows), 9)
        self.assertAlmostEqual(float(rows[4]["P_x_m"]), 0.512348, places=6)
        self.assertAlmostEqual(float(rows[8]["C_y_m"]), -0.198994, places=6)
        on_stdout = kempe("solve", LINKAGES / "shear-press.toml").stdout
        self.assertEqual(on_stdout, table.read_text())
        as_json = json.loads(kempe("solve", LINKAGES / "shear-press.toml", "--json").stdout)
        self.assertIsNone(as_json["stop"])
        self.assertEqual(len(as_json["rows"]), 9)

    def test_forces_of_the_press_at_work(self):
        table = self.scratch / "press.csv"
        run = kempe("solve", LINKAGES / "shear-press-forces.toml", "-o", table)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("driver P.y: -928.866 N at step 0, its largest\n", run.stdout)
        self.assertIn("largest reaction: 2300.67 N in joint B (lever, rod) at step 0\n", run.stdout)
        as_json = json.loads(kempe("solve", LINKAGES / "shear-press-forces.toml", "--json").stdout)
        self.assertEqual(as_json["forces"]["undetermined"], [])
        self.assertEqual(as_json["forces"]["sentences"], run.stdout.splitlines()[1:])
        for row in csv.DictReader(io.StringIO(table.read_text())):
            pushed = sum(float(row[name]) for name in ("A_on_lever_x_N", "C_from_ground_x_N"))
            self.assertLess(abs(pushed), 2)  # of a thousand: what the ground bears sideways is the inertia alone

    def test_every_example_runs_with_its_animation(self):
        for linkage in sorted(LINKAGES.glob("*.toml")):
            page, picture = self.scratch / "motion.html", self.scratch / "motion.svg"
            run = kempe("solve", linkage, "-o", self.scratch / "t.csv", "--animate", page, "--animate", picture)
            self.assertEqual(run.returncode, 0, linkage.name + run.stderr)
            xml.etree.ElementTree.parse(picture)
            html.parser.HTMLParser().feed(page.read_text())
            self.assertIn("</html>", page.read_text())

    def test_rates_agree_with_differences(self):
        run = kempe("solve", LINKAGES / "slider-crank.toml", "--steps", 7200)
        rows = list(csv.DictReader(io.StringIO(run.stdout)))
        for i in range(100, 7100, 333):
            step = float(rows[i + 1]["time_s"]) - float(rows[i - 1]["time_s"])
            for place, rate in [("B_x_mm", "B_vx_mm_per_s"), ("B_vx_mm_per_s", "B_ax_mm_per_s2")]:
                difference = (float(rows[i + 1][place]) - float(rows[i - 1][place])) / step
                self.assertTrue(math.isclose(difference, float(rows[i][rate]), rel_tol=1e-4, abs_tol=1), (place, i))

    def test_flags_ask_for_more_columns(self):
        linkage = self.linkage(BARS + TURN)
        plain = kempe("solve", linkage).stdout.splitlines()[0]
        full = kempe("solve", linkage, "--velocities", "--accelerations", "--angles", "rod,rocker").stdout.splitlines()[0]
        self.assertEqual(plain, "step,time_s,B_x_mm,B_y_mm,C_x_mm,C_y_mm")
        for column in ["C_vy_mm_per_s", "C_ax_mm_per_s2", "rod_angle_deg", "rocker_rate_rad_per_s",
                       "rocker_acceleration_rad_per_s2"]:
            self.assertIn(column, full)
        self.assertRefused(kempe("solve", linkage, "--angles", "piston"), 2, "piston")

    def test_a_strut_drives_by_its_length(self):
        strut = '[[drivers]]\ndistance = ["A", "C"]\nfrom = 45\nto = 65\n[motion]\nsteps = 8\n'
        rows = list(csv.DictReader(io.StringIO(kempe("solve", self.linkage(BARS + strut)).stdout)))
        self.assertEqual(len(rows), 9)
        for i, row in enumerate(rows):
            A, D = (0, 0), (60, 0)
            B, C = ((float(row[f"{p}_x_mm"]), float(row[f"{p}_y_mm"])) for p in "BC")
            for a, b, length in [(A, C, 45 + 2.5 * i), (A, B, 20), (B, C, 50), (D, C, 40)]:
                self.assertAlmostEqual(math.dist(a, b), length, places=9)

    def test_angles_and_places_pass_zero_beside_a_strut(self):
        for driver, at in (('angle = "a"\nfrom_deg = -30\nto_deg = 30', lambda share: math.radians(60 * share - 30)),
                           ('angle = "a"\nfrom_deg = 0\nto_deg = 10', lambda share: math.radians(10 * share)),
                           ('coordinate = "B.y"\nfrom = -0.3\nto = 0.2', lambda share: math.asin(0.5 * share - 0.3))):
            path = self.linkage(f"""
[ground]
A = [0, 0]
[links]
a = {{ joints = ["A", "B"], A-B = 1 }}
b = {{ joints = ["B", "C"], B-C = 1 }}
[guess]
B = [1, 0]
C = [0.5, 0.9]
[[drivers]]
distance = ["A", "C"]
from = 1
to = 1.1
[[drivers]]
{driver}
[motion]
steps = 7
[output]
points = ["B", "C"]
""")
            run = kempe("solve", path)
            self.assertEqual(run.returncode, 0, run.stderr)
            rows = list(csv.DictReader(io.StringIO(run.stdout)))
            self.assertEqual(len(rows), 8)
            for step, row in enumerate(rows):
                turn = at(step / 7)
                self.assertAlmostEqual(float(row["B_x_mm"]), math.cos(turn), places=6)
                self.assertAlmostEqual(float(row["B_y_mm"]), math.sin(turn), places=6)
                self.assertAlmostEqual(math.hypot(float(row["C_x_mm"]), float(row["C_y_mm"])), 1 + 0.1 * step / 7, places=6)

    def test_a_slide_drives_the_piston(self):
        text = (LINKAGES / "slider-crank.toml").read_text()
        for old, new in [('angle = "crank"', 'slide = "piston"'), ("from_deg = 0", "from = 75"), ("to_deg = 360", "to = 125")]:
            self.assertIn(old, text)
            text = text.replace(old, new)
        rows = list(csv.DictReader(io.StringIO(kempe("solve", self.linkage(text)).stdout)))
        self.assertEqual(len(rows), 73)
        for i, row in enumerate(rows):
            ax, ay, bx, by, vx, vy = (float(row[k]) for k in ["A_x_mm", "A_y_mm", "B_x_mm", "B_y_mm", "A_vx_mm_per_s", "A_vy_mm_per_s"])
            self.assertAlmostEqual(bx, 75 + 50 * i / 72, places=9)
            self.assertAlmostEqual(math.hypot(ax, ay), 30, places=9)
            self.assertAlmostEqual(math.dist((ax, ay), (bx, by)), 100, places=9)
            self.assertAlmostEqual(ax * vx + ay * vy, 0, places=6)  # along the crank's circle
            self.assertAlmostEqual((ax - bx) * (vx - 1250) + (ay - by) * vy, 0, places=6)  # and the rod keeps its length
        self.assertRefused(kempe("solve", self.linkage(text.replace('slide = "piston"', 'slide = "cylinder"'))), 2, "cylinder")

    def test_assemblies(self):
        linkage = self.linkage(BARS + TURN)
        rows = list(csv.DictReader(io.StringIO(kempe("solve", linkage, "--assemblies").stdout)))
        self.assertEqual(len(rows), 2)
        self.assertGreater(float(rows[0]["C_y_mm"]), 0)
        self.assertLess(float(rows[1]["C_y_mm"]), 0)
        other = list(csv.DictReader(io.StringIO(kempe("solve", linkage, "--assembly", 1).stdout)))
        self.assertTrue(all(float(row["C_y_mm"]) < 0 for row in other))
        self.assertRefused(kempe("solve", linkage, "--assembly", 2), 2, "0 to 1")

    def test_bounds_are_sought_among_many_closings(self):
        """Of five four-bars that know nothing of each other, 32 closings; that there is none cannot be known."""
        def text(height):
            bars = range(5)
            return "\n".join(
                ["[ground]"] + [f"A{i} = [{4 * i}, 0]\nD{i} = [{4 * i + 3.5}, 0]" for i in bars] + ["[links]"] +
                [f'a{i} = {{ joints = ["A{i}", "B{i}"], A{i}-B{i} = 1 }}\nb{i} = {{ joints = ["B{i}", "C{i}"], B{i}-C{i} = 3.5 }}\n'
                 f'c{i} = {{ joints = ["D{i}", "C{i}"], D{i}-C{i} = 2 }}' for i in bars] +
                [f'[[drivers]]\nangle = "a{i}"\nfrom_deg = 30\nto_deg = 40' for i in bars] + ["[bounds]"] +
                [f"C{i} = {{ y = [{-height if i % 2 else 0}, {0 if i % 2 else height}] }}" for i in bars[:-1]] +
                [f"C4 = {{ y = [{height - 5}, {height}] }}", "[output]", "points = " + json.dumps([f"C{i}" for i in bars])])
        run = kempe("solve", self.linkage(text(5)), "--steps", 1)
        self.assertEqual(run.returncode, 0, run.stderr)
        row = next(csv.DictReader(io.StringIO(run.stdout)))
        for i in range(5):
            self.assertEqual(float(row[f"C{i}_y_mm"]) < 0, i % 2 == 1)
        self.assertRefused(kempe("solve", self.linkage(text(50)), "--steps", 1), 6, "C4", "there may be more closings")

    def test_dead_point_is_named_and_the_table_kept(self):
        linkage, table = self.linkage(BARS.replace("A-B = 20", "A-B = 45") + TURN), self.scratch / "t.csv"
        run = kempe("solve", linkage, "-o", table, "--animate", self.scratch / "m.html")
        self.assertRefused(run, 3, "dead point at step 11.728 of 36", "angle of crank = 117.279613 deg",
                           "B, C and D in line (rod, rocker)")
        rows = table.read_text().splitlines()
        self.assertEqual(len(rows), 14)
        self.assertIn("The motion ends early: dead point", (self.scratch / "m.html").read_text())
        stop = json.loads(kempe("solve", linkage, "--json").stdout)["stop"]
        self.assertEqual(stop["kind"], "dead point")

    def test_bad_input(self):
        cases = [
            (BARS.replace("B-C = 50", "B-C = 130") + TURN, 3, ["does not assemble: joint", "has a gap of"]),
            (BARS.replace("B-C = 50", "B-C = 110") + TURN, 3, ["at the start of the motion", "out of reach", "has a gap of"]),
            (BARS + TURN + '[[drivers]]\nangle = "rocker"\nfrom_deg = 70\nto_deg = 90\n', 2,
             ["linkage.toml:16: drivers: found 2 driven values for a mobility of 1"]),
            (BARS + TURN + "[bars]\nA-C = 50\n", 2, ["1 driven value for a mobility of 0"]),
            (BARS, 2, ["[[drivers]]"]),
            (BARS.replace("rocker =", 'loose = { joints = ["C", "E"], C-E = 9 }\nrocker =') + TURN, 2,
             ["1 driven value for a mobility of 2"]),
            (BARS + TURN.replace('"crank"', '"clank"'), 2, ["linkage.toml:13: drivers[1].angle", "clank", "crank"]),
            (BARS.replace("A-B = 20", "A-B = 0") + TURN, 2, ["linkage.toml:6: links.crank.A-B: found 0"]),
            ("", 2, ["an empty file"]),
        ]
        for text, code, words in cases:
            self.assertRefused(kempe("solve", self.linkage(text)), code, *words)
        self.assertRefused(kempe("solve", self.scratch / "none.toml"), 2, "none.toml")
        self.assertRefused(kempe("solve", self.linkage(BARS + TURN), "--animate", "x.gif"), 2, ".html or .svg")
        self.assertRefused(kempe("solve", self.linkage(BARS + TURN), "-o", self.scratch / "no" / "such" / "t.csv"), 5)

    def test_same_input_same_bytes(self):
        linkage = LINKAGES / "watt-six-bar.toml"
        for name in ["a", "b"]:
            kempe("solve", linkage, "-o", self.scratch / f"{name}.csv", "--animate", self.scratch / f"{name}.html")
        for kind in ["csv", "html"]:
            self.assertEqual((self.scratch / f"a.{kind}").read_bytes(), (self.scratch / f"b.{kind}").read_bytes())

    def test_distances_are_understood_and_a_better_way_is_told(self):
        run = kempe("solve", LINKAGES / "pantograph-by-distances.toml")
        self.assertEqual(run.returncode, 0)
        self.assertIn('along = [0, 6, 9]', run.stderr)
        self.assertEqual(kempe("solve", LINKAGES / "pantograph-by-distances.toml", "--quiet").stderr, "")
        last = list(csv.DictReader(io.StringIO(run.stdout)))[-1]
        self.assertAlmostEqual(float(last["E_x_cm"]), 9, places=12)
        self.assertAlmostEqual(float(last["E_y_cm"]), 7.5, places=12)


SLOT = """
[ground]
O = [0, 0]
D = [2, 0]
[links]
crank = { joints = ["O", "A"], O-A = 1 }
slot = { at = { D = [0, 0] } }
[[sliders]]
point = "A"
on = "slot"
through = [0, 0.2]
direction_deg = 0
[[drivers]]
angle = "crank"
from_deg = 10
to_deg = 370
"""
SCALED = """
[ground]
O = [0, 0]
D = [{D!r}, 0]
[links]
first = {{ joints = ["O", "A"], O-A = {a!r} }}
second = {{ joints = ["D", "B"], D-B = {b!r} }}
AP = {{ joints = ["A", "P"], A-P = {c!r} }}
PB = {{ joints = ["P", "B"], P-B = {c!r} }}
[[gears]]
wheels = ["first", "second"]
teeth = [{teeth!r}, {half!r}]
mesh_deg = [0, 90]
[[drivers]]
angle = "first"
from_deg = 0
to_deg = 360
[bounds]
P = {{ y = [0, {c!r}] }}
"""


def evaluated(expression, **values):
    """What an expression of `solve --equations` comes to: angles in degrees, a number before a function multiplies it."""
    python = re.sub(r"(\d) (cos|sin)\(", r"\1 * \2(", expression).replace("^", "**")
    names = {"cos": lambda degrees: math.cos(math.radians(degrees)), "sin": lambda degrees: math.sin(math.radians(degrees)),
             "sqrt": math.sqrt, "__builtins__": {}}
    return eval(python, names, values)


class Equations(Case):
    def test_every_printed_number_follows_from_the_others(self):
        for linkage in sorted(LINKAGES.glob("*.toml")):
            for step in (0, 3.5):
                run = kempe("solve", linkage, "--equations", step, "--json", "--quiet")
                self.assertEqual(run.returncode, 0, run.stderr)
                told = json.loads(run.stdout)
                unknowns = told["unknowns"]
                size = max(1, *map(abs, unknowns.values()))
                for equation in told["equations"]:
                    for text, values in ((equation["symbols"], unknowns), (equation["numbers"], {})):
                        left, right = text.split(" = ")
                        self.assertAlmostEqual(evaluated(left, **values), float(right), delta=1e-7 * size, msg=text)
                    left = equation["symbols"].split(" = ")[0]
                    for name, value in unknowns.items():
                        change = 1e-4 * size
                        slope = (evaluated(left, **{**unknowns, name: value + change})
                                 - evaluated(left, **{**unknowns, name: value - change})) / (2 * change)
                        self.assertAlmostEqual(equation["derivatives"].get(name, 0), slope, delta=1e-4 * max(1, abs(slope)),
                                               msg=f"{linkage.stem}: {name} in {left}")

    def test_the_text_holds_the_same(self):
        told = json.loads(kempe("solve", LINKAGES / "slider-crank.toml", "--equations", 3, "--json").stdout)
        text = kempe("solve", LINKAGES / "slider-crank.toml", "--equations", 3).stdout
        for equation in told["equations"]:
            self.assertIn(f"  {equation['symbols']}\n  {equation['numbers']}\n", text)
        self.assertIn("x_crank + 30 cos(t_crank) - x_rod = 0\n  0 + 30 cos(15) - 28.97777479 = 0\n", text)
        self.assertTrue(text.endswith("9 unknowns, 9 equations, 1 of them a driver's\n"))

    def test_wheels_have_their_radii_in_the_files_unit(self):
        text = (LINKAGES / "geared-five-bar.toml").read_text()
        told = [json.loads(kempe("solve", self.linkage(head + text), "--equations", 3, "--json").stdout)["equations"] for head in ("", 'unit = "in"\n')]
        for in_mm, in_inches in zip(*told):
            self.assertEqual(in_mm["symbols"], in_inches["symbols"])
            for name, slope in in_mm["derivatives"].items():
                self.assertAlmostEqual(in_inches["derivatives"][name], slope, delta=1e-9 * max(1, abs(slope)))

    def test_a_step_that_is_not_there(self):
        self.assertRefused(kempe("solve", LINKAGES / "slider-crank.toml", "--equations", 1e6), 2, "--equations", "a step from 0 to")
        self.assertRefused(kempe("solve", LINKAGES / "slider-crank.toml", "--equations", -1), 2, "a step from 0 to")


class Units(Case):
    """What a linkage does depends neither on the unit nor on its size."""

    def answer(self, text):
        linkage = self.linkage(text)
        solved = kempe("solve", linkage, "--json", "--velocities", "--accelerations", "--quiet")
        table = json.loads(solved.stdout) if solved.stdout else None
        mobility = json.loads(kempe("mobility", linkage, "--json", "--quiet").stdout)
        centres = kempe("centres", linkage, "--at", 1, "--json", "--quiet")
        kinds = [(c["links"], c["kind"], c["source"]) for c in json.loads(centres.stdout)["centres"]]
        return solved.returncode, table, {key: mobility[key] for key in ("mobility", "rank", "gruebler", "redundant")}, kinds

    def assertSame(self, one, other, scale=1.0):
        self.assertEqual(one[0], other[0])
        self.assertEqual(one[2:], other[2:])
        self.assertEqual(len(one[1]["rows"]), len(other[1]["rows"]))
        self.assertEqual((one[1]["stop"] or {}).get("kind"), (other[1]["stop"] or {}).get("kind"))
        for number, column in enumerate(zip(zip(*one[1]["rows"]), zip(*other[1]["rows"]))):
            name = one[1]["columns"][number]
            by = scale if "_x_" in name or "_y_" in name or "_vx" in name or "_vy" in name or "_ax" in name or "_ay" in name else 1
            here, there = ([v for v in values if v is not None] for values in column)
            most = max(map(abs, there), default=0)
            speed = max((abs(v) for row in other[1]["rows"] for v in row if v is not None), default=1)
            for a, b in zip(here, there):
                self.assertAlmostEqual(a / by, b, delta=1e-9 * max(most, 1e-3 * speed), msg=name)

    def test_every_example_in_every_unit(self):
        for linkage in sorted(LINKAGES.glob("*.toml")):
            text = re.sub(r"\[masses\]\n(.+\n)+", "", linkage.read_text())  # masses do not become lighter in a smaller unit
            lines = [line for line in text.splitlines() if not line.startswith(("unit", "gravity"))]
            answers = [self.answer("\n".join([f'unit = "{unit}"', *lines])) for unit in ("mm", "cm", "m", "in")]
            for answer in answers[1:]:
                with self.subTest(linkage.name):
                    self.assertSame(answer, answers[0])

    def test_a_turning_slot_of_any_size(self):
        def scaled(by):
            return SLOT.replace("[2, 0]", f"[{2 * by!r}, 0]").replace("O-A = 1", f"O-A = {by!r}").replace("0.2", repr(0.2 * by))
        one = self.answer(scaled(1.0))
        self.assertEqual((one[0], one[2]["mobility"]), (0, 1))
        for size in (1e-6, 1e-3, 8e3, 1e4, 1e6):
            with self.subTest(size):
                self.assertSame(self.answer(scaled(size)), one, size)

    def test_gears_of_any_size_and_number_of_teeth(self):
        def geared(by, teeth):
            return SCALED.format(D=90 * by, a=25 * by, b=20 * by, c=80 * by, teeth=2 * teeth, half=teeth)
        one = self.answer(geared(1.0, 1))
        self.assertEqual(one[0], 0)
        for by, teeth in ((1e-6, 20), (1e-3, 200), (1e4, 1), (1e6, 20), (1.0, 20), (1.0, 200), (1.0, 20000)):
            with self.subTest((by, teeth)):
                self.assertSame(self.answer(geared(by, teeth)), one, by)

    def test_where_a_dead_point_lies_does_not_depend_on_unit_or_steps(self):
        dead = BARS.replace("A-B = 20", "A-B = 45") + TURN
        places = set()
        for unit, steps in (("mm", 36), ("m", 36), ("in", 7), ("cm", 1000)):
            stop = json.loads(kempe("solve", self.linkage(f'unit = "{unit}"' + dead), "--json", "--steps", steps).stdout)["stop"]
            self.assertEqual(stop["kind"], "dead point")
            places.add(round(stop["step"] / steps, 9))
        self.assertEqual(len(places), 1)


class Missing(Case):
    def test_what_is_missing_is_told_in_its_own_unit(self):
        wedge = """
sliders = [
  { link = "b1", on = "ground", through = "O", direction_deg = 0 },
  { link = "b2", on = "ground", through = "O", direction_deg = 90 },
  { link = "b2", on = "b1", through = [0, 3], direction_deg = 45 },
]
[ground]
O = [0, 0]
[links]
b1 = { at = { P = [0, 0] } }
b2 = { at = { Q = [0, 0] } }
"""
        for unit in ("mm", "m", "in"):
            run = kempe("solve", self.linkage(f'unit = "{unit}"' + wedge))
            self.assertRefused(run, 3, "does not turn: off by 45 degrees")
            self.assertNotIn("0.78", run.stderr)

    def test_whole_turns_of_fixed_angles_do_not_count(self):
        same = """
sliders = [
  { link = "block", on = "ground", through = "O", direction_deg = 350 },
  { link = "block", on = "ground", through = "O", direction_deg = -10 },
]
drivers = [{ slide = "block", from = 0, to = 5 }]
[ground]
O = [0, 0]
[links]
block = { at = { P = [0, 0] } }
"""
        run = kempe("solve", self.linkage(same))
        self.assertEqual(run.returncode, 0, run.stderr)
        last = list(csv.DictReader(io.StringIO(run.stdout)))[-1]
        self.assertAlmostEqual(float(last["P_x_mm"]), 5 * math.cos(math.radians(-10)), places=12)

    def test_a_gap_is_the_distance_that_is_missing(self):
        arm = """
[ground]
O = [0, 0]
[links]
a = { joints = ["O", "A"], O-A = 3 }
b = { joints = ["A", "P"], A-P = 2 }
[[drivers]]
path = "P"
circle = { centre = [0, 0], radius = RADIUS }
"""
        for unit in ("mm", "cm", "m", "in"):
            for radius, missing in ((0.99999, 1e-5), (5.25, 0.25), (0.5, 0.5)):
                run = kempe("solve", self.linkage(f'unit = "{unit}"' + arm.replace("RADIUS", str(radius))))
                self.assertRefused(run, 3, f"has a gap of {missing:g} {unit}", "joint O")


class WorkIsBounded(Case):
    def test_slides_that_nearly_coincide_end_with_the_place(self):
        text = (LINKAGES / "right-angle-inversor.toml").read_text()
        for bearing in ("[5.9999999999999995e-05, -10]", "[0, -10]", "[-1e-3, -10]"):
            self.assertIn("R = [60, -10]", text)
            linkage = self.linkage(text.replace("R = [60, -10]", f"R = {bearing}"))
            run = kempe("solve", linkage)
            self.assertRefused(run, 6, "limit of work at step 16.", "angle of pinion = ", "Image runs off")
            self.assertEqual(kempe("centres", linkage).returncode, 0)  # step 0 is not beyond it
            self.assertRefused(kempe("centres", linkage, "--at", 30), 6, "ends before step 30", "Image runs off")

    def test_one_step_of_many_costs_no_table(self):
        linkage = self.linkage(BARS + TURN + "[motion]\nsteps = 1000000\n")
        run = kempe("centres", linkage, "--at", 999999.5)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_a_motion_too_short_for_its_accelerations_is_refused(self):
        run = kempe("solve", self.linkage(BARS + TURN + "[motion]\nduration_s = 1e-155\n"))
        self.assertRefused(run, 2, "motion.duration_s", "1e-155", "at least 1e-6")

    def test_a_long_motion_obeys_ctrl_c(self):
        table = self.scratch / "t.csv"
        process = subprocess.Popen([KEMPE, "solve", self.linkage(BARS + TURN), "--steps", "1000000", "-o", table],
                                   stderr=subprocess.PIPE, text=True)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        _, words = process.communicate(timeout=60)
        self.assertIn(process.returncode, (0, 130))  # 0: it was done before
        if process.returncode == 130:
            self.assertIn("stopped", words)
            self.assertEqual(list(self.scratch.glob("t.csv*")), [])


class Mobility(Case):
    def test_examples(self):
        for name, expected in [("plagiograph", 2), ("six-bar-plagiograph", 1), ("pantograph-by-distances", 2), ("hart", 1)]:
            answer = json.loads(kempe("mobility", LINKAGES / f"{name}.toml", "--json").stdout)
            self.assertEqual(answer["mobility"], expected, name)
            self.assertTrue(answer["sentences"])

    def test_gruebler_is_computed_again_from_what_is_printed(self):
        for linkage in sorted(LINKAGES.glob("*.toml")):
            with self.subTest(linkage.name):
                text = kempe("mobility", linkage, "--quiet").stdout
                answer = json.loads(kempe("mobility", linkage, "--json", "--quiet").stdout)
                count = re.search(r"^Gruebler +(3 \(n - 1\).*)$", text, re.MULTILINE)[1]
                self.assertEqual(count, answer["gruebler_in_numbers"])
                _, numbers, result = count.split(" = ")
                product = re.sub(r"^3 \(", "3 * (", numbers)
                self.assertRegex(product, r"^[-+*() 0-9]+$")
                self.assertEqual(eval(product), int(result))
                unknowns, equations = map(int, re.search(r"(\d+) unknowns - (\d+) equations", text).groups())
                mobility, independent = map(int, re.search(r"^mobility +(\d+): (\d+) of the", text, re.MULTILINE).groups())
                self.assertEqual(unknowns - equations, int(result))
                self.assertEqual((mobility, independent), (answer["mobility"], answer["rank"]))
                if mobility != int(result):
                    self.assertRegex(text, f"Gruebler counts {result}, the true mobility is {mobility}: .*(redundant|shaky)")
        piston = kempe("mobility", LINKAGES / "slider-crank.toml").stdout
        self.assertIn("3 revolute joints, 1 sliding pair\n", piston)
        self.assertIn("3 (4 - 1) - 2 * 4 - 0 = 1\n", piston)

    def test_number_synthesis(self):
        answer = json.loads(kempe("mobility", "--links", 6, "--dof", 1, "--json").stdout)
        self.assertEqual(answer["joints"], 7)
        self.assertEqual(answer["assortments"], [{"n2": 4, "n3": 2, "n4": 0}])
        self.assertEqual(kempe("mobility").returncode, 2)
        self.assertEqual(kempe("mobility", "--links", 100).returncode, 2)

    def test_contradicting_drivers_do_not_hide_the_mobility(self):
        linkage = self.linkage(BARS + TURN + '[[drivers]]\nangle = "rocker"\nfrom_deg = 70\nto_deg = 90\n')
        answer = json.loads(kempe("mobility", linkage, "--json").stdout)
        self.assertEqual(answer["mobility"], 1)
        self.assertEqual(answer["drivers"], 2)


class Centres(Case):
    def test_plagiograph_has_ten_of_which_two_at_infinity(self):
        picture = self.scratch / "centres.svg"
        run = kempe("centres", LINKAGES / "plagiograph.toml", "--at", 3, "--json", "-o", picture)
        answer = json.loads(run.stdout)
        self.assertEqual(answer["count"], 10)
        far = [sorted(c["links"]) for c in answer["centres"] if c["kind"] == "infinity"]
        self.assertEqual(sorted(far), [["ACX", "OB"], ["BCY", "OA"]])
        self.assertTrue(all(c["velocity_error"] < 1e-9 for c in answer["centres"]))
        xml.etree.ElementTree.parse(picture)

    def test_steps_between_and_beyond(self):
        self.assertEqual(kempe("centres", LINKAGES / "slider-crank.toml", "--at", 2.5).returncode, 0)
        self.assertRefused(kempe("centres", LINKAGES / "slider-crank.toml", "--at", 73), 2, "a step from 0 to 72")
        dead = self.linkage(BARS.replace("A-B = 20", "A-B = 45") + TURN)
        self.assertRefused(kempe("centres", dead, "--at", 20), 3, "dead point")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
