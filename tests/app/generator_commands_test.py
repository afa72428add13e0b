#!/usr/bin/env python3
"""function, inversor and calibrate from outside, and every shipped example by the README's one command.

usage: generator_commands_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import csv
import json
import math
import pathlib
import random
import re
import signal
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import EXAMPLES, KEMPE, SOURCE, kempe

GENERATORS = EXAMPLES / "generators"
CALIBRATION = EXAMPLES / "calibration"


class Case(program.Case):
    def file(self, text, name="spec.toml"):
        path = self.scratch / name
        path.write_text(text)
        return path

    def answer(self, *arguments):
        run = kempe(*arguments, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def assertRefused(self, run, code, *words):
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertNotIn("nan", run.stdout.lower())


class Function(Case):
    def test_logarithm_is_minimax_and_says_what_holds_it(self):
        plot = self.scratch / "error.svg"
        answer = self.answer("function", GENERATORS / "logarithm.toml", "--plot", plot)
        self.assertLess(answer["structural_error_max_deg"], 0.04694)
        self.assertGreaterEqual(answer["transmission_min_deg"], 25)
        self.assertEqual(answer["minimax"], {"equal_ripples": 5, "unknowns": 5, "limits_at_work": [],
                                             "local_minimum_proven": True})
        self.assertEqual((answer["output"]["y_at_start"], answer["output"]["y_at_end"]), (0, math.log10(2)))
        self.assertTrue(any("points" in element.attrib or "d" in element.attrib
                            for element in xml.etree.ElementTree.parse(plot).iter()))
        # The loop closes by the printed lengths and angles alone.
        lengths = answer["lengths_mm"]
        for at in answer["structural_error"][::20]:
            phi, psi = math.radians(at["input_deg"]), math.radians(at["output_deg"])
            x = lengths["ground"] + lengths["output"] * math.cos(psi) - lengths["input"] * math.cos(phi)
            y = lengths["output"] * math.sin(psi) - lengths["input"] * math.sin(phi)
            self.assertAlmostEqual(math.hypot(x, y), lengths["coupler"], places=9)

    def test_limit_at_work_is_named(self):
        spec = self.file((GENERATORS / "logarithm.toml").read_text().replace("_deg = 25", "_deg = 45"))
        answer = self.answer("function", spec)
        self.assertEqual(answer["minimax"]["limits_at_work"], ["transmission_deg"])
        self.assertEqual(answer["minimax"]["equal_ripples"], 5)
        self.assertAlmostEqual(answer["structural_error_max_deg"], 0.0607124, places=6)

    def test_three_four_and_five_points(self):
        base = (GENERATORS / "logarithm.toml").read_text().replace('"minimax" ', '"precision_points" ')
        self.assertIn('"precision_points" ', base)
        for points in [3, 4, 5]:
            spec = self.file(base.replace("[input]", f"points = {points}\n[input]").replace("_deg = 25", "_deg = 0"))
            answer = self.answer("function", spec)
            self.assertEqual(len(answer["precision_points"]), points)
            self.assertLess(answer["structural_error_max_deg"], 1)

    @staticmethod
    def value(words):
        """A printed sum, with cos and sqrt, angles in degrees."""
        words = re.sub(r"(?<=[0-9]) cos\(", " * cos(", words).replace("^", "**")
        return eval(words, {"cos": lambda angle: math.cos(math.radians(angle)), "sqrt": math.sqrt})

    def test_equations_hold_with_the_numbers_printed(self):
        starts = "[input]\nstart_deg = 30\nrange_deg = 60\n[output]\nstart_deg = 60\nrange_deg = 90\n"
        exact = self.file('[function]\nexpression = "log10(x)"\nx = [1, 2]\npoints = 3\n' + starts)
        for spec, spaced in [(exact, True), (GENERATORS / "logarithm.toml", False)]:
            answer, run = self.answer("function", spec, "--equations"), kempe("function", spec, "--equations")
            work, lengths = answer["equations"], answer["lengths_mm"]
            self.assertGreaterEqual(len(work["points"]), 3)
            for j, point in enumerate(work["points"]):
                left, right = point["equation"].split(" = ")
                self.assertAlmostEqual(self.value(left), self.value(right), delta=2e-8 if spaced else 1e-6)
                self.assertIn(point["equation"], run.stdout)
                self.assertAlmostEqual(point["y"], math.log10(point["x"]), places=12)
                if spaced:  # Chebyshev's spacing, from the lower end upward
                    words, told = point["spacing"].split(" = ")
                    self.assertAlmostEqual(self.value(words), float(told), places=9)
                    self.assertAlmostEqual(point["x"], 1.5 - 0.5 * math.cos(math.pi * (2 * j + 1) / 6), places=9)
                else:
                    self.assertEqual(point["spacing"], "")
            # The lengths from the printed lines, each by its own right side.
            for letter, name in [("a", "input"), ("c", "output"), ("b", "coupler")]:
                line = re.search(rf"^  {letter} = [^=]* = (.*) = (\S+)$", run.stdout, re.M)
                self.assertAlmostEqual(self.value(line[1]), lengths[name], delta=1e-6 * lengths[name])
                self.assertAlmostEqual(float(line[2]), lengths[name], delta=1e-8 * lengths[name])
            heights = [ripple["error_deg"] for ripple in work["ripples"]]
            self.assertTrue(all(a * b < 0 for a, b in zip(heights, heights[1:])), heights)
            self.assertAlmostEqual(max(map(abs, heights)), answer["structural_error_max_deg"], delta=1e-6)
            self.assertGreaterEqual(len(heights), 4)

    def spec(self, expression, x, method, input_deg, output_deg, ratio, transmission):
        return self.file(f'[function]\nexpression = "{expression}"\nx = {x}\n{method}\n[input]\nrange_deg = {input_deg}\n'
                         f'[output]\nrange_deg = {output_deg}\n[links]\nlongest_ratio = {ratio}\n'
                         f'[limits]\ntransmission_deg = {transmission}\n')

    def test_four_points_are_found_in_a_narrow_window(self):
        points = 'method = "precision_points"\npoints = 4'
        answer = self.answer("function", self.spec("x^2", [0, 1], points, 60, -60, 5, 30))
        self.assertLess(answer["structural_error_max_deg"], 0.8562)
        self.assertGreaterEqual(answer["transmission_min_deg"], 30)
        answer = self.answer("function", self.spec("x^2", [0, 1], points, 90, 90, 20, 20))
        self.assertLess(answer["structural_error_max_deg"], 0.1)

    def test_minimax_of_a_steep_end(self):
        answer = self.answer("function", self.spec("sqrt(x)", [0.01, 1], 'method = "minimax"', 80, 70, 8, 30))
        self.assertLess(answer["structural_error_max_deg"], 1.8252)
        self.assertTrue(answer["minimax"]["local_minimum_proven"])

    def test_nothing_found_is_not_said_to_be_nothing_there(self):
        for method in ['points = 3', 'points = 4', 'points = 5', 'method = "minimax"', 'method = "least_squares"']:
            run = kempe("function", self.spec("log10(x)", [1, 2], method, 60, 90, 1.5, 89))
            self.assertRefused(run, 6, "no design found", "Searched:", "not a proof that none exists")
            self.assertNotIn("no design exists", run.stderr)

    def test_bad_input(self):
        good = (GENERATORS / "logarithm.toml").read_text()
        for old, new, code, words in [
            ('"log10(x)"', '"log10(x"', 2, ["function.expression"]),
            ('"log10(x)"', '"1/(x-1.5)"', 3, ["function.expression", "no finite value at x = 1.5", "allowed"]),
            ('"log10(x)"', '"3"', 6, ["function.expression", "constant", "allowed"]),
            ('"log10(x)"', '"sin(x)^2 + cos(x)^2"', 6, ["function.expression", "constant", "allowed"]),
            ('"log10(x)"', '"tan(40*x)"', 6, ["function.expression", "without end towards x = 1.0", "allowed: a function that is finite"]),
            ('"log10(x)"', '"sin(1e6*x)"', 6, ["function.expression", "ups and downs", "allowed: a smoother function"]),
            ('"log10(x)"', '"1e300*10000000*(x-1.5)"', 6, ["function.expression", "allowed: values that differ by at most 1e+300"]),
            ('"log10(x)"', '"x = 3"', 2, ["toml:", "function.expression", "an assignment at position 2"]),
            ('"log10(x)"', '"x, 2*x"', 2, ["function.expression", "2 values"]),
            ('"log10(x)"', '"x\\u0000y"', 2, ["function.expression", "number 0"]),
            ('"log10(x)"', '"' + "x+" * 600 + 'x"', 2, ["function.expression", "at most 1000 characters"]),
            ("x = [1, 2]", "x = [999999999.9999999, 1000000000]", 2, ["function.x", "above the lower"]),
            ("x = [1, 2]", "x = [0, 1e-300]", 2, ["function.x", "above the lower"]),
            ("x = [1, 2]", "x = [2, 1]", 2, ["function.x", "found [2, 1]", "lower below upper"]),
            ("range_deg = 60", "range_deg = 0", 2, ["input.range_deg"]),
            ("range_deg = 60", "range_deg = -1e-9", 2, ["input.range_deg", "found -1e-09", "at least 1e-06 degrees"]),
            ("ground_mm = 100", "ground_mm = nan", 2, ["links.ground_mm"]),
        ]:
            self.assertIn(old, good)
            self.assertRefused(kempe("function", self.file(good.replace(old, new))), code, *words)
        table = (GENERATORS / "table.toml").read_text()
        for rows, code, words in [
            ("[0, 1], [1, 1], [2, 1], [3, 1]", 6, ["function.table", "constant"]),
            ("[0, 1], [1, 2], [1, 3], [3, 4]", 2, ["function.table", "x = 1 after 1"]),
            ("[0, 1], [1, 2], [1.0000000001, 3], [3, 4]", 2, ["function.table", "apart"]),
            ("[0, 1], [1, 2], [2, 3], [1e200, 4]", 2, ["function.table", "1e+200"]),
            ("[0, 1], [1, 2], [2, 3], [3, 1e300]", 2, ["function.table", "1e+300"]),
            ("[0, 1], [1, 2], [2, nan], [3, 4]", 2, ["function.table", "x rising"]),
            ("[0, 1], [1, 2]", 2, ["function.table", "found 2 rows"]),
        ]:
            text = re.sub(r"table = .*", f"table = [{rows}]", table)
            self.assertRefused(kempe("function", self.file(text)), code, *words)

    def test_a_time_limit_and_a_signal_hand_out_the_best_so_far(self):
        slow = self.spec("sin(100*x)", [0, 1], 'method = "least_squares"', 60, 10, 20, 0)
        self.assertRefused(kempe("function", slow, "--time-limit", "1e-6"), 6, "stopped (time limit of 1e-06 s)", "nothing is written")
        self.assertRefused(kempe("function", slow, "--time-limit", "0"), 2)
        run = kempe("function", slow, "--time-limit", 2, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        answer = json.loads(run.stdout)
        self.assertIs(answer["complete"], False)
        self.assertIn("stopped", answer["reservation"])
        self.assertIn("stopped", run.stderr)
        whole = self.answer("function", GENERATORS / "logarithm.toml", "--time-limit", 1e6)
        self.assertEqual(whole, self.answer("function", GENERATORS / "logarithm.toml"))
        self.assertNotIn("complete", whole)
        for number in signal.SIGINT, signal.SIGTERM:
            process = subprocess.Popen([KEMPE, "function", slow, "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            time.sleep(2)
            process.send_signal(number)
            told, words = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130, words)
            self.assertIs(json.loads(told)["complete"], False)

    def test_a_function_that_bends_everywhere_ends_with_a_reservation(self):
        run = kempe("function", self.spec("log10(x) + 1e-5*sin(1e6*x)", [1, 2], "points = 3", 60, 90, 20, 0), "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("bends in more places than are looked at", json.loads(run.stdout)["reservation"])


    def test_the_linkage_file_moves_as_the_function_says(self):
        """The general solver, which knows no Freudenstein, gives the output crank's printed angles and the function's values."""
        for spec, wanted in [(GENERATORS / "logarithm.toml", math.log10), (GENERATORS / "table.toml", None)]:
            linkage = self.scratch / "linkage.toml"
            answer = self.answer("function", spec, "--linkage", linkage)
            samples = answer["structural_error"]
            solved = self.answer("solve", linkage, "--steps", len(samples) - 1)
            self.assertIsNone(solved["stop"])
            columns = [solved["columns"].index(f"{name}_angle_deg") for name in ("input", "output")]
            x_head, y_head = (re.search(rf"^# {v} = (\S+) \+ (\S+) \* \(angle of \S+ - (\S+)\) / (\S+)$", linkage.read_text(),
                                        re.MULTILINE).groups() for v in "xy")
            dial = lambda head, angle: float(head[0]) + float(head[1]) * (angle - float(head[2])) / float(head[3])
            y_a_degree = abs(float(y_head[1]) / float(y_head[3]))
            for row, sample in zip(solved["rows"], samples, strict=True):
                angles = [row[column] for column in columns]
                for angle, printed in zip(angles, (sample["input_deg"], sample["output_deg"])):
                    self.assertAlmostEqual((angle - printed + 180) % 360 - 180, 0, places=8)
                self.assertAlmostEqual(dial(x_head, angles[0]), sample["x"], places=9)
                y = dial(y_head, float(y_head[2]) + (angles[1] - float(y_head[2]) + 180) % 360 - 180)
                if wanted:
                    y_wanted = wanted(sample["x"])
                    self.assertLess(abs(y - y_wanted), 1.0001 * answer["structural_error_max_deg"] * y_a_degree)
            self.assertEqual(self.answer("mobility", linkage)["mobility"], 1)
            self.assertEqual(self.answer("centres", linkage)["count"], 6)
        self.assertIn("linkage file", kempe("function", spec, "--linkage", linkage).stdout)


class Inversor(Case):
    def test_the_linkage_file_keeps_the_lens_in_focus_on_a_straight_line(self):
        """The general solver knows lengths alone: the image stays on the scale line, and x x' = f^2."""
        for spec, kinds in [("copy-camera", ["peaucellier", "hart", "right_angle"]), ("enlarger", ["hart", "right_angle"])]:
            answer = self.answer("inversor", GENERATORS / f"{spec}.toml")
            f, (low, high) = answer["focal_length_mm"], answer["magnification"]
            for kind in kinds:
                linkage = self.scratch / "linkage.toml"
                wish = [] if kind == answer["best"] else ["--kind", kind]
                self.answer("inversor", GENERATORS / f"{spec}.toml", "--linkage", linkage, *wish)
                solved = self.answer("solve", linkage)
                self.assertIsNone(solved["stop"])
                Px, Py, Qx, Qy = (solved["columns"].index(f"{p}_{axis}_mm") for p in "PQ" for axis in "xy")
                for row in solved["rows"]:
                    self.assertAlmostEqual(row[Py], 0, places=8)
                    self.assertAlmostEqual(row[Qy], 0, places=8)
                    self.assertAlmostEqual(row[Px] * row[Qx], f * f if kind == "peaucellier" else -f * f, delta=1e-8 * f * f)
                    p, q = row[Px] + f, abs(row[Qx]) + f
                    self.assertAlmostEqual(1 / p + 1 / q, 1 / f, places=12)
                first, last = solved["rows"][0], solved["rows"][-1]
                self.assertAlmostEqual(abs(first[Qx]), f * low, delta=1e-8 * f)
                self.assertAlmostEqual(abs(last[Qx]), f * high, delta=1e-8 * f)
                self.assertEqual(self.answer("mobility", linkage)["mobility"], 1)
                self.assertTrue(all(c["velocity_error"] < 1e-8 for c in self.answer("centres", linkage, "--at", 30)["centres"]))

    def test_no_linkage_file_of_an_inversor_that_does_not_exist(self):
        linkage = self.scratch / "linkage.toml"
        self.assertRefused(kempe("inversor", GENERATORS / "enlarger.toml", "--linkage", linkage, "--kind", "peaucellier"), 6,
                           "magnification 1")
        self.assertFalse(linkage.exists())
        self.assertRefused(kempe("inversor", GENERATORS / "enlarger.toml", "--linkage", linkage, "--kind", "scott"), 2)
        self.assertRefused(kempe("inversor", GENERATORS / "enlarger.toml", "--kind", "hart"), 2)
    def test_all_three_and_the_best(self):
        answer = self.answer("inversor", GENERATORS / "copy-camera.toml")
        sizes = {one["kind"]: one["size_mm"] for one in answer["inversors"]}
        self.assertEqual(set(sizes), {"peaucellier", "hart", "right_angle"})
        self.assertEqual(answer["best"], min(sizes, key=sizes.get))
        for one in answer["inversors"]:
            self.assertAlmostEqual(one["travel_image_mm"], 150 * (2.5 - 1.3))
            self.assertGreaterEqual(one["transmission_min_deg"], 8 - 1e-9)
            self.assertTrue(any(length["sensitivity_mm_per_mm"] > 0 for length in one["lengths"]))

    def test_what_does_not_exist_says_why(self):
        answer = self.answer("inversor", GENERATORS / "enlarger.toml")
        self.assertIn("magnification 1", answer["inversors"][0]["why_not"])
        spec = self.file("[lens]\nfocal_length_mm = 150\nmagnification = [0.05, 20]\n[limits]\ntransmission_deg = 40\n")
        self.assertRefused(kempe("inversor", spec), 6, "not proven", "peaucellier", "hart", "right_angle")
        self.assertRefused(kempe("inversor", self.file("[lens]\nfocal_length_mm = -1\nmagnification = [1, 2]\n")), 2,
                           "lens.focal_length_mm")


class Path(Case):
    LINE = GENERATORS / "straight-line.toml"

    def turned(self, solved, name):
        return [row[solved["columns"].index(name)] for row in solved["rows"]]

    def test_the_linkage_file_and_both_cognates_pass_the_points(self):
        """The general solver on the file, 20 degrees a step: the coupler point is where the answer says, and its cognates too."""
        linkage = self.scratch / "loop.toml"
        for cognate in ([], ["--cognate", 1], ["--cognate", 2]):
            answer = self.answer("path", GENERATORS / "loop.toml", "-o", linkage, *cognate)["answers"][0]
            solved = self.answer("solve", linkage, "--steps", 17)
            self.assertIsNone(solved["stop"])
            for row, x, y in zip(answer["reached_mm"], self.turned(solved, "P_x_mm"), self.turned(solved, "P_y_mm"), strict=True):
                self.assertAlmostEqual(row[0], x, delta=1e-8)
                self.assertAlmostEqual(row[1], y, delta=1e-8)
            self.assertEqual(self.answer("mobility", linkage)["mobility"], 1)
        points = re.findall(r"\[([-\d.]+), ([-\d.]+)\]", (GENERATORS / "loop.toml").read_text().split("driver_deg")[0])
        squares = [math.dist(map(float, point), reached) ** 2 for point, reached in zip(points, answer["reached_mm"], strict=True)]
        self.assertAlmostEqual(math.sqrt(sum(squares) / 18), answer["error_rms_mm"], delta=1e-12)
        self.assertAlmostEqual(math.sqrt(max(squares)), answer["error_max_mm"], delta=1e-12)
        self.assertLess(sum(squares), 0.00903)
        self.assertIsNone(answer["lower_bound_mm"])
        self.assertEqual([cognate["driver"] for cognate in answer["cognates"]], ["coupler", "crank"])

    def test_a_line_is_met_and_the_limits_kept(self):
        answers = self.answer("path", self.LINE)["answers"]
        for answer in answers:
            self.assertGreaterEqual(answer["transmission_min_deg"], 40)
            self.assertLessEqual(max(math.dist(*answer["pivots_mm"]), answer["crank_mm"], answer["coupler_mm"], answer["rocker_mm"]), 60)
        self.assertLess(answers[0]["error_max_mm"], 1e-9)
        turns = answers[0]["driver_deg"]
        self.assertIn(turns, (sorted(turns), sorted(turns, reverse=True)))
        text = kempe("path", self.LINE)
        self.assertEqual(text.returncode, 0, text.stderr)
        self.assertIn("no bound of the least error is known", text.stdout)

    def test_the_motion_that_is_asked_for(self):
        good = (GENERATORS / "five-poses.toml").read_text()
        for motion in ("crank-rocker", "double rocker"):
            run = kempe("path", self.file(good + f'motion = "{motion}"\n'), "--json")
            if run.returncode == 6:
                continue
            self.assertEqual({answer["motion"] for answer in json.loads(run.stdout)["answers"]}, {motion})
        line = self.LINE.read_text()
        for answer in self.answer("path", self.file(line + 'motion = "crank turns fully"\n'))["answers"]:
            ground = math.dist(*answer["pivots_mm"])
            others = [answer["coupler_mm"], answer["rocker_mm"]]
            shortest, *rest = sorted([ground, answer["crank_mm"], *others])
            self.assertIn(shortest, (ground, answer["crank_mm"]))
            self.assertLess(shortest + rest[2], rest[0] + rest[1])
        self.assertRefused(kempe("path", self.file(line + 'motion = "all"\n')), 2, "limits.motion", "crank turns fully")

    def test_pages_of_answers(self):
        page, picture = self.scratch / "page.html", self.scratch / "picture.svg"
        poses = GENERATORS / "five-poses.toml"
        for arguments, words in (([], "5 wanted poses"), (["--cognate", 1], "5 wanted places of P"),
                                 (["--copy-rotation", 20, "--answer", 1], "5 wanted poses")):
            run = kempe("path", poses, "--animate", page, "--animate", picture, *arguments)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn(words, page.read_text())
            wanted = xml.etree.ElementTree.parse(picture).find(".//*[@id='wanted']")
            self.assertEqual(sum(element.tag.endswith("circle") for element in wanted), 5)
            self.assertEqual(sum(element.tag.endswith("path") for element in wanted), 5 if "poses" in words else 0)
        self.assertRefused(kempe("path", self.LINE, "--animate", "x.gif"), 2, "--animate", ".html or .svg")
        self.assertRefused(kempe("path", self.LINE, "--answer", "2"), 2, "--answer", "beside -o or --animate")
        self.assertRefused(kempe("path", poses, "--animate", poses), 2)
        self.assertRefused(kempe("path", self.LINE, "-o", page, "--animate", page), 2)

    def test_the_plagiograph_on_the_coupler_copies_the_curve(self):
        """The general solver on both files: the six-bar's point is where the four-bar's, turned and scaled about the pole, is."""
        four, six = self.scratch / "four.toml", self.scratch / "six.toml"
        for cognate, pole, rotation in (([], ["--copy-pole", "crank"], -30), ([], [], 60), (["--cognate", 1], [], -30),
                                        (["--cognate", 2], ["--copy-pole", "rocker"], -30)):
            with self.subTest(cognate=cognate, pole=pole, rotation=rotation):
                wanted = ["--copy-scale", 2, "--copy-rotation", rotation, *pole, *cognate]
                # Not every answer can be copied so: its parallelogram may pass a change point.
                number = next(n for n in (3, 2, 1) if kempe("path", self.LINE, "-o", six, "--answer", n, *wanted).returncode == 0)
                self.answer("path", self.LINE, "-o", four, "--answer", number, *cognate)
                found = self.answer("path", self.LINE, "-o", six, "--answer", number, *wanted)
                copy = found["answers"][number - 1]["copy"]
                x, y = copy["pole_mm"]
                self.assertIn(copy["pole_mm"], copy["four_bar"]["pivots_mm"])
                self.assertEqual(copy["pole"] == "crank_pivot", copy["pole_mm"] == copy["four_bar"]["pivots_mm"][0])
                if pole:
                    self.assertEqual(copy["pole"], f"{pole[1]}_pivot")
                ratio = 2 * complex(math.cos(math.radians(rotation)), math.sin(math.radians(rotation)))
                drawn, copied = self.answer("solve", four), self.answer("solve", six)
                self.assertIsNone(copied["stop"])
                columns = [self.turned(drawn, f"P_{axis}_mm") for axis in "xy"] + [self.turned(copied, f"Y_{axis}_mm") for axis in "xy"]
                self.assertEqual(len(columns[0]), 61)
                for px, py, yx, yy in zip(*columns, strict=True):
                    image = complex(x, y) + ratio * (complex(px, py) - complex(x, y))
                    self.assertLess(abs(complex(yx, yy) - image), 1e-8)
                self.assertLess(math.dist(copy["copied_mm"][0], (columns[2][0], columns[3][0])), 1e-8)
                self.assertLess(copy["error_max_mm"], 1e-9)
                self.assertGreater(copy["parallelogram_min_deg"], 1)
                self.assertEqual(self.answer("mobility", six)["mobility"], 1)

    def test_a_copy_that_passes_a_change_point_is_refused(self):
        file = self.scratch / "six.toml"
        loop = GENERATORS / "loop.toml"
        for answer in self.answer("path", loop, "--copy-rotation", 90)["answers"]:
            self.assertIn("change point", answer["copy"]["why_not"])
        self.assertRefused(kempe("path", loop, "--copy-rotation", 90, "-o", file), 6, "change point")
        self.assertRefused(kempe("path", self.LINE, "--copy-scale", 1, "-o", file), 6, "the curve itself")
        self.assertFalse(file.exists())
        for wrong in (("--copy-scale", 0), ("--copy-scale", "nan"), ("--copy-rotation", 400), ("--copy-pole", "third")):
            self.assertRefused(kempe("path", self.LINE, *wrong), 2)

    def test_bad_input(self):
        good = (GENERATORS / "loop.toml").read_text()
        for old, new, words in [
            ("points_mm", "points", ["path.points", "points_mm"]),
            ("[0.5, 1.1]", "[0.5, nan]", [":5:", "path.points_mm"]),
            ("[0.5, 1.1],", "", [":8:", "path.driver_deg", "17 points"]),
            ("[0, 20, 40", "[0, 40, 20", [":8:", "path.driver_deg", "rising or falling"]),
            ("340]", "360]", [":8:", "path.driver_deg", "less than 360"]),
            ("longest_mm = 50", "longest_mm = -1", [":11:", "limits.longest_mm"]),
            ("[50, -50], [50, 50]", "[50, 50], [50, -50]", [":12:", "limits.pivots_within_mm", "not convex"]),
            ("[limits]", "minimize = 'all'\n[limits]", ["path.minimize", "largest_distance"]),
        ]:
            self.assertIn(old, good)
            self.assertRefused(kempe("path", self.file(good.replace(old, new, 1))), 2, *words)
        for points in ["[[1, 1], [1, 1], [1, 1]]", "[[1, 1], [2, 1]]", "[]", "3"]:
            self.assertRefused(kempe("path", self.file(f"[path]\npoints_mm = {points}\n")), 2, "path.points_mm", ":2:")
        for given, words in [("crank_pivot_mm = [60, 0]", ["limits.crank_pivot_mm", ":13:", "within limits.pivots_within_mm"]),
                             ("crank_pivot_mm = [0]", ["limits.crank_pivot_mm", ":13:", "[x, y]"]),
                             ("ground_deg = 400", ["limits.ground_deg", ":13:", "-360 to 360"]),
                             ("first_angle_deg = 'up'", ["limits.first_angle_deg", ":13:"])]:
            self.assertRefused(kempe("path", self.file(good + given + "\n")), 2, *words)
        poses = (GENERATORS / "five-poses.toml").read_text()
        self.assertRefused(kempe("path", self.file(poses + "\nground_deg = 3\n")), 2, "limits.ground_deg", "poses_mm")
        self.assertRefused(kempe("path", self.LINE, "--cognate", "1"), 2)

    def test_a_number_of_no_answer_is_a_fault_of_the_option(self):
        run = kempe("path", GENERATORS / "straight-line.toml", "-o", self.scratch / "line.toml", "--answer", "6", "--json")
        self.assertEqual(run.returncode, 2)
        self.assertEqual([fault["key"] for fault in json.loads(run.stdout)["error"]["faults"]], ["--answer"])

    def test_nothing_found_is_not_said_to_be_nothing_there(self):
        spec = self.file("[path]\nposes_mm = [[0, 0, 5], [10, 3, 5], [20, 12, 5], [30, 27, 5], [40, 48, 5]]\n")
        self.assertRefused(kempe("path", spec, "-o", self.scratch / "none.toml"), 6, "Searched:", "not a proof that none exists")
        self.assertFalse((self.scratch / "none.toml").exists())

    def test_five_poses_by_substitution_and_by_the_general_solver(self):
        spec, linkage = GENERATORS / "five-poses.toml", self.scratch / "poses.toml"
        poses = [tuple(map(float, pose)) for pose in re.findall(r"^  \[(\S+), (\S+), (\S+)\],$", spec.read_text(), re.MULTILINE)]
        self.assertEqual(len(poses), 5)
        found = self.answer("path", spec, "-o", linkage)
        self.assertEqual(len(found["dyads"]), 4)
        for dyad in found["dyads"]:
            (X, Y), (u, v) = dyad["centre_mm"], dyad["circle_point_mm"]
            for x, y, angle in poses:
                c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
                self.assertAlmostEqual(math.hypot(x + c * u - s * v - X, y + s * u + c * v - Y), dyad["length_mm"], delta=1e-8)
        answer = found["answers"][0]
        self.assertLess(answer["error_max_mm"], 1e-9)
        self.assertLess(answer["error_angle_max_deg"], 1e-9)
        for pose, reached, turned in zip(poses, answer["reached_mm"], answer["reached_deg"], strict=True):
            self.assertLess(math.dist(pose[:2], reached) + abs(pose[2] - turned), 1e-8)
        ends = self.answer("solve", linkage, "--steps", 1)
        for name, wanted in (("P_x_mm", 88), ("P_y_mm", 20), ("coupler_angle_deg", 52)):
            first, last = self.turned(ends, name)
            self.assertAlmostEqual(last - first, wanted, delta=1e-8)
        self.assertEqual(kempe("path", spec).returncode, 0)

    def test_bad_poses(self):
        good = (GENERATORS / "five-poses.toml").read_text()
        for old, new, words in [
            ("[0, 0, 0]", "[0, 0]", [":6:", "path.poses_mm"]),
            ("[20, 16, 10]", "[0, 0, 360]", [":7:", "path.poses_mm", "different"]),
            ("[20, 16, 10]", "[20, 16, inf]", [":7:", "path.poses_mm"]),
            ("poses_mm = [", "poses_mm = [ [1, 1, 1],", [":5:", "path.poses_mm", "3 to 5"]),
            ("[limits]", "driver_deg = [1, 2, 3, 4, 5]\n[limits]", ["path.driver_deg", "points_mm"]),
            ("[limits]", "points_mm = [[1, 1], [2, 2], [3, 4]]\n[limits]", ["path.points_mm", "both"]),
        ]:
            self.assertIn(old, good)
            self.assertRefused(kempe("path", self.file(good.replace(old, new, 1))), 2, *words)


INSTRUMENT = "[instrument]\narm_mm = 500\nratio = 0.5\n"


def reading(angle, x, y):
    return f"[[reading]]\narm_angle_deg = {angle}\nerror_mm = [{x}, {y}]\n"


class Calibrate(Case):
    def test_reader_of_knights_paper_types_two_readings(self):
        answer = self.answer("calibrate", self.file(INSTRUMENT + reading(30, 0.10, -0.30) + reading(60, 0.30, -0.50)))
        (x30, y30), (x60, y60), s = (0.10, -0.30), (0.30, -0.50), math.sqrt(3) / 2
        expected = {"AC": s * (y60 + x30) - 0.5 * (y30 + x60), "CF": s * (x30 - y60) + 0.5 * (y30 - x60),
                    "BE": s / 2 * (x30 - y60) - 0.25 * (y30 - x60), "DE": s / 2 * (x30 + y60) + 0.25 * (y30 + x60)}
        for scale, error in expected.items():
            self.assertAlmostEqual(answer["errors_mm"][scale], error, places=9)
            self.assertAlmostEqual(answer["corrections_mm"][scale], -error, delta=1e-6)
        self.assertLess(answer["residual_mm"], 0.001)

    def test_equations_hold_with_the_numbers_printed(self):
        two = reading(30, 0.10, -0.30) + reading(60, 0.30, -0.50)
        four = two + reading(45, 0.19, -0.41) + reading(20, 0.09, -0.26).replace("[[reading]]", "[[reading]]\nexchanged = true")
        turned = {"cos": lambda angle: math.cos(math.radians(angle)), "sin": lambda angle: math.sin(math.radians(angle))}
        for text in (two, four):
            arguments = ("calibrate", self.file(INSTRUMENT + text), "--method", "knight", "--equations")
            answer, run = self.answer(*arguments), kempe(*arguments)
            self.assertEqual(run.returncode, 0, run.stderr)
            count, told = len(answer["equations"]["readings"]), {}
            self.assertEqual(count, text.count("[[reading]]"))
            for name, words in re.findall(r"^  (\w+) = (.*)$", run.stdout, re.M):
                *sums, value = words.split(" = ")
                told[name] = float(value)
                for one in sums:  # each right side by itself
                    one = re.sub(r"(?<=[0-9]) (cos|sin)\(", r" * \1(", one).replace("^", "**")
                    self.assertAlmostEqual(eval(one, turned), told[name], delta=1e-8, msg=f"{name} = {words}")
            self.assertEqual(len(told), 5 * count + 2 + 2 * count + 8 * count + 8)
            if count == 4:
                self.assertAlmostEqual(told["x4"], -0.5 * 0.09)
                self.assertAlmostEqual(told["y4"], 0.5 * 0.26)
            # The errors are those of the answer, and what they leave of s and d is neither high nor tilted: least squares.
            for scale, row in zip(("AC", "CF", "BE", "DE"), answer["equations"]["matrix"], strict=True):
                self.assertAlmostEqual(told[f"e_{scale}"], answer["errors_mm"][scale], delta=1e-9)
                self.assertAlmostEqual(told[f"correction_{scale}"], answer["corrections_mm"][scale], delta=1e-6)
                for entry, name in zip(row, [f"{scale}{axis}{i + 1}" for i in range(count) for axis in "xy"], strict=True):
                    self.assertAlmostEqual(told[name], entry, delta=1e-8)
            for letter, height, slope in (("s", "DE", "CF"), ("d", "BE", "AC")):
                left = [told[f"{letter}{i}"] - told[f"e_{height}"] - told[f"e_{slope}"] * told[f"c{i}"] for i in range(1, count + 1)]
                self.assertAlmostEqual(sum(left), 0, delta=1e-8)
                self.assertAlmostEqual(sum(one * told[f"c{i + 1}"] for i, one in enumerate(left)), 0, delta=1e-8)
        self.assertRefused(kempe("calibrate", CALIBRATION / "plotter.toml", "--equations"), 2, "--equations", "method knight")

    def test_rounds_go_on_until_the_target(self):
        first = reading(30, 0.62, -1.15) + reading(60, 0.85, -2.04)
        second = (reading(30, 0.01, 0.02) + reading(60, -0.02, 0.01)).replace("[[reading]]", "[[reading]]\nround = 2")
        before = self.answer("calibrate", self.file(INSTRUMENT + first))
        after = self.answer("calibrate", self.file(INSTRUMENT + first + second))
        self.assertFalse(before["target_reached"])
        self.assertTrue(after["target_reached"])
        self.assertEqual(len(after["rounds"]), 2)
        strict = self.answer("calibrate", self.file(INSTRUMENT + first + second), "--target-mm", 0.001)
        self.assertFalse(strict["target_reached"])

    def plotter(self, readings, ruler):
        head, *rest = (CALIBRATION / "plotter.toml").read_text().split("[[reading]]")
        if not ruler:
            head = head[:head.index("[lengths_mm]")]
        self.file((CALIBRATION / "drawing-pantograph.json").read_text(), "drawing-pantograph.json")
        return self.file(head + "".join("[[reading]]" + one for one in rest[:readings]))

    def test_plotter_owner_types_ten_points_and_gets_lengths(self):
        answer = self.answer("calibrate", self.plotter(10, True))
        self.assertEqual(answer["unidentifiable"], [])
        for name in ["VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY"]:
            self.assertLess(answer["uncertainty_mm"][name], 0.2)
            self.assertLess(abs(answer["errors_mm"][name]), 1.5)
        self.assertLess(answer["residual_mm"], 0.05 * answer["largest_departure_mm"])

    def test_without_a_ruler_two_sizes_are_named_with_what_would_tell(self):
        answer = self.answer("calibrate", self.plotter(10, False))
        self.assertEqual(len(answer["unidentifiable"]), 2)
        for one in answer["unidentifiable"]:
            self.assertIn("together with", one["in_words"])
            self.assertIn("measure", one["what_would_tell"][0]["measure"])

    def test_measured_lengths_that_cannot_be_or_would_go_unused(self):
        readings = reading(30, 0.10, -0.30) + reading(60, 0.30, -0.50)
        arm = lambda length: f"[lengths_mm]\narm_AC = {length}\n"
        self.assertRefused(kempe("calibrate", self.file(INSTRUMENT + arm(600) + readings)), 2, "lengths_mm.arm_AC",
                           "600 mm, of 500 mm drawn")
        self.assertRefused(kempe("calibrate", self.file(INSTRUMENT + arm(500.1) + readings)), 2, "lengths_mm.arm_AC",
                           "stays as drawn", '"arms"')
        off = self.plotter(10, True).read_text().replace("CX = 390.52", "CX = 490.52")
        self.assertRefused(kempe("calibrate", self.file(off)), 2, "lengths_mm.CX", "a twentieth")

    def test_hundreds_of_wrong_readings_among_thousands_are_left_out(self):
        """There are more sets of 300 among 2400 than a double counts."""
        rng = random.Random(7)
        wrong = set(rng.sample(range(2400), 300))
        text = "[instrument]\narm_mm = 500\nratio = 0.5\n[fit]\nreading_uncertainty_mm = 0.05\nmethod = \"least_squares\"\n"
        for i in range(2400):
            x, y = rng.gauss(0, 0.05), rng.gauss(0, 0.05)
            off = 3 if i in wrong else 0
            text += f"[[reading]]\narm_angle_deg = {10 + i / 35:.4f}\nerror_mm = [{x + off:.4f}, {y - 0.7 * off:.4f}]\n"
        path = self.scratch / "many.toml"
        path.write_text(text)
        answer = self.answer("calibrate", path)
        self.assertEqual([one["name"] for one in answer["outliers"]], [f"reading {i + 1}" for i in sorted(wrong)])
        for error in answer["errors_mm"].values():
            self.assertLess(abs(error), 0.02)

    def test_a_mistyped_reading_is_named_although_the_noise_is_stated(self):
        right = self.answer("calibrate", self.plotter(12, True))
        self.assertEqual(right["outliers"], [])
        self.assertFalse(right["residuals_against_stated"]["contradicts_stated_uncertainty"])
        path = self.plotter(12, True)
        path.write_text(path.read_text().replace("359.66", "395.66").replace("343.99", "334.99"))
        answer = self.answer("calibrate", path, "-o", self.scratch / "out")
        self.assertEqual([one["name"] for one in answer["outliers"]], ["reading 3", "reading 9"])
        self.assertEqual(answer["reading_uncertainty_source"], "stated")
        for name, error in right["errors_mm"].items():
            self.assertLess(abs(answer["errors_mm"][name] - error), 0.3)
        self.assertGreater(max(abs(answer["errors_with_outliers_mm"][name] - error)
                               for name, error in right["errors_mm"].items()), 1)
        self.assertIn("outlier, left out", (self.scratch / "out" / "report.html").read_text())
        path.write_text(path.read_text().replace("[fit]", "[fit]\nkeep_outliers = true"))
        kept = self.answer("calibrate", path)
        self.assertTrue(kept["residuals_against_stated"]["contradicts_stated_uncertainty"])
        self.assertEqual(kept["errors_mm"], answer["errors_with_outliers_mm"])
        self.assertEqual(kept["errors_without_outliers_mm"], answer["errors_mm"])

    def test_knights_method_leaves_out_what_stands_out(self):
        angles = [20, 30, 40, 50, 60, 70]
        text = INSTRUMENT + '[fit]\nmethod = "knight"\nreading_uncertainty_mm = 0.01\n'
        clean = text + "".join(reading(angle, 0, 0.01 * (-1) ** angle) for angle in angles)
        wrong = clean.replace(reading(50, 0, 0.01), reading(50, 5, 0.01))
        answer = self.answer("calibrate", self.file(wrong))
        self.assertEqual([one["name"] for one in answer["outliers"]], ["reading 4"])
        self.assertLess(max(map(abs, answer["errors_mm"].values())), 0.1)

    def test_setting_table_erect_and_reversed(self):
        answer = self.answer("calibrate", CALIBRATION / "knight.toml", "--ratios", "1:3,5:2")
        rows = [(row["ratio"], row["image"]) for row in answer["settings"]]
        for ratio in ["1:3", "5:2"]:
            self.assertIn((ratio, "erect"), rows)
            self.assertIn((ratio, "reversed"), rows)
        for row in answer["settings"]:
            # Two readings to 0.01 mm, held over all arm angles; at 5:2 what is left is enlarged.
            self.assertLess(row["predicted_error_mm"], 0.25)
            for scale in ["AC", "CF", "BE", "DE"]:
                self.assertAlmostEqual(row["set_mm"][scale] - row["corrections_mm"][scale], 500 * row["setting"],
                                       places=6)

    def test_plan_proposes_exchanged_readings(self):
        answer = self.answer("calibrate", CALIBRATION / "knight.toml", "--plan", "--plan-readings", 4)
        self.assertEqual(len(answer["plan"]["readings"]), 4)
        self.assertTrue(all(one["exchanged"] for one in answer["plan"]["readings"]))
        self.assertGreater(answer["plan"]["gain_over_evenly_spread"], 1.5)

    def test_simulation_keeps_the_figures(self):
        answer = self.answer("calibrate", CALIBRATION / "simulate.toml", "--simulate", "--quiet", "--seed", 3,
                             "-o", self.scratch / "simulated")
        simulation = answer["simulation"]
        self.assertEqual(simulation["instruments"], 1000)
        self.assertLess(simulation["rounds"][-1]["residual_largest_mm"], 0.1)
        again = self.answer("calibrate", self.scratch / "simulated" / "simulated.toml")
        hidden = simulation["hidden_errors_of_first_mm"]
        for scale, error in hidden.items():
            self.assertAlmostEqual(again["rounds"][0]["errors_mm"][scale], error, delta=0.1)

    def test_bad_input(self):
        for text, words in [
            (INSTRUMENT, ["no readings", "--plan"]),
            (INSTRUMENT + reading(30, 0.1, 0.2), ["fewer than two", "30 and 60"]),
            (INSTRUMENT + reading(30, 0.1, 0.2) + reading(30, 0.1, 0.2), ["one arm angle", "30 and 60"]),
            (INSTRUMENT + reading(0, 0.1, 0.2) + reading(60, 0.1, 0.2), [":5:", "measure at 30 and 60"]),
            (INSTRUMENT + reading(30, 0.1, 0.2) + reading(90, 0.1, 0.2), [":8:", "measure at 30 and 60"]),
            (INSTRUMENT + reading(30, 120, -400) + reading(60, 0.1, 0.2), ["micrometres"]),
            (INSTRUMENT + reading(0.52, 0.1, 0.2) + reading(1.05, 0.1, 0.2), ["radians"]),
            (INSTRUMENT + "[[reading]]\ntracer_mm = [1200, 0]\npen_mm = [600, 0]\n" * 3, ["beyond the reach"]),
        ]:
            self.assertRefused(kempe("calibrate", self.file(text)), 2, *words)


class Examples(Case):
    def test_the_readmes_one_command_runs_them_all(self):
        self.assertIn("scripts/examples", (SOURCE / "README.md").read_text())
        run = subprocess.run([SOURCE / "scripts" / "examples", self.scratch, KEMPE], capture_output=True, text=True,
                             timeout=600)
        self.assertEqual(run.returncode, 0, run.stderr)
        for linkage in (SOURCE / "specs" / "examples" / "linkages").glob("*.toml"):
            rows = list(csv.reader((self.scratch / f"{linkage.stem}.csv").read_text().splitlines()))
            self.assertGreater(len(rows), 5)
            self.assertFalse(any(cell.lower() in ("nan", "inf", "") for row in rows for cell in row), linkage.stem)
            for picture in ["", "-centres"]:
                xml.etree.ElementTree.parse(self.scratch / f"{linkage.stem}{picture}.svg")
            centres = json.loads((self.scratch / f"{linkage.stem}-centres.json").read_text())
            self.assertTrue(all(one["velocity_error"] < 1e-8 for one in centres["centres"]), linkage.stem)
        page = (self.scratch / "index.html").read_text()
        leads_to = re.findall(r'(?:href|src)="([^"]+)"', page)
        self.assertEqual([name for name in leads_to if not (self.scratch / name).is_file()], [])
        for kind, ending in (("linkages", ".html"), ("generators", "-linkage.html")):
            for example in (SOURCE / "specs" / "examples" / kind).glob("*.toml"):
                self.assertIn(example.stem + ending, leads_to)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
