#!/usr/bin/env python3
"""The program from outside: what a person or a script types, and what must come of it.

usage: commands_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import EXAMPLES, FILES, KEMPE, POLE_IN_HOLE, SOURCE, TEN_LINES, kempe


def wait_until_caught(pid, number):
    """Until the process has a handler of the signal: on a busy machine that takes a while."""
    for _ in range(5000):
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
        caught = int(next(line for line in status.splitlines() if line.startswith("SigCgt")).split()[1], 16)
        if caught >> (number - 1) & 1:
            return
        time.sleep(0.002)


class Case(program.Case):
    def spec(self, text=TEN_LINES, name="spec.toml"):
        path = self.scratch / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def synthesize(self, text=TEN_LINES, *arguments):
        return kempe("synthesize", self.spec(text), "-o", self.scratch / "out", *arguments)

    def assertNothingWritten(self, but=()):
        out = self.scratch / "out"
        self.assertLessEqual({p.name for p in out.iterdir()} if out.exists() else set(), set(but))

    def assertRefused(self, run, code, *words):
        self.assertEqual(run.returncode, code, run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertNothingWritten(but={"certificate.jsonl"} if code == 3 else ())  # the log of the proof


def specs_of(kind):
    for path in sorted(EXAMPLES.glob("*.toml")):
        if ("[mechanism]" in path.read_text()) == (kind == "workspace"):
            yield path


class Examples(Case):
    def check(self, command, path):
        out = self.scratch / path.stem
        run = kempe(command, path, "-o", out, "--quiet")
        self.assertEqual(run.returncode, 0, f"{path.name}: {run.stderr}")
        self.assertLessEqual(FILES, {p.name for p in out.iterdir()})
        design = json.loads((out / "design.json").read_text())
        size = sum(design["mechanism"]["lengths_mm"].values())
        self.assertEqual(design["format"], "kempe-design/1")
        self.assertTrue(design["verification"]["certified"], path.name)
        self.assertEqual(design["verification"]["flips"], 0)
        self.assertLess(design["verification"]["copy_error_max_mm"], 1e-9 * size)
        checked = kempe("verify", out / "design.json", "--json")
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertTrue(json.loads(checked.stdout)["certified"])
        features = json.loads((out / "workspace.geojson").read_text())["features"]
        self.check_pen_side(features, design["copy"]["scale"])
        layers = {f["properties"]["layer"] for f in features}
        for layer in ("reachable", "usable", "collision_free", "uncertain", "region", "copy", "copy_workspace",
                      "obstacles", "footprint"):
            self.assertIn(layer, layers)
        return design

    def check_pen_side(self, features, scale):
        """The pen's map is the image of the tracer's: every area, and every cause with its parts."""
        def areas(layer):
            return [(f["properties"].get("cause"), f["properties"].get("parts"), f["properties"]["area_mm2"])
                    for f in features if f["properties"]["layer"] == layer]
        for tracer, pen in (("reachable", "copy_reachable"), ("usable", "copy_usable"), ("collision_free", "copy_workspace"),
                            ("uncertain", "copy_uncertain"), ("lost", "copy_lost")):
            self.assertEqual([one[:2] for one in areas(tracer)], [one[:2] for one in areas(pen)])
            for (_, _, here), (_, _, there) in zip(areas(tracer), areas(pen)):
                self.assertAlmostEqual(there, scale ** 2 * here, delta=1e-3 * scale ** 2 * here + 20)  # flattened to 0.01 mm each

    def test_every_example_becomes_a_verified_design(self):
        for path in specs_of("synthesize"):
            with self.subTest(path.name):
                design = self.check("synthesize", path)
                self.assertTrue(design["workspace"]["region_covered"])
                bound = design["quality"]["lower_bound"]
                if bound is not None:
                    value = design["search"]["value"]
                    if design["search"]["objective"] == "transmission":
                        self.assertGreaterEqual(bound, value - 1e-6)
                    else:
                        self.assertLessEqual(bound, value * (1 + 1e-9))

    def test_every_given_mechanism_gets_its_map(self):
        for path in specs_of("workspace"):
            with self.subTest(path.name):
                self.check("workspace", path)

    # A given mechanism whose parallelogram's bars touch at every opening that keeps the transmission angle.
    TOUCHING = POLE_IN_HOLE.replace("50", "70").replace("assembly = 0", "assembly = 1")

    # Dead point and change point lie 3 degrees apart: no opening is 5 degrees from both.
    TOO_NARROW = """
[copy]
scale = 0.3
rotation_deg = 3
[region]
rectangle_mm = {at = [120, -60], size = [20, 20]}
[links]
width_mm = 20
pin_diameter_mm = 3
layers = 8
[limits]
transmission_deg = 5
[mechanism]
vertex = "pole"
VA_mm = 90
VB_mm = 60
layers = [1, 3, 6, 8]
"""

    def test_a_mechanism_without_a_usable_opening_is_told_so(self):
        for text in (self.TOUCHING, re.sub(r"(?s)\[region\].*?(?=\[links\])", "", self.TOUCHING), self.TOO_NARROW):
            out = self.scratch / "touching"
            run = kempe("workspace", self.spec(text), "-o", out)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("opening      none keeps", run.stdout)
            self.assertIn("transmission none", run.stdout)
            self.assertIsNone(json.loads((out / "design.json").read_text())["mechanism"]["opening_deg"])
            self.assertIn("none keeps", (out / "report.html").read_text())
            self.assertIn("No opening keeps", (out / "drawing.svg").read_text())
            for shown in (run.stdout, (out / "drawing.svg").read_text(), (out / "report.html").read_text()):
                self.assertNotRegex(shown, r"57\.2958|57\.296|57\.3°")  # the bounds that stand for an empty interval

    def test_ten_kilometres_from_the_origin_the_drawings_are_those_of_the_design(self):
        """There places are rounded to 2e-9 mm, and parts are drawn to 1e-9 mm all the same."""
        text = (EXAMPLES / "report-mechanism.toml").read_text()
        out, far = self.scratch / "out", 9.9e6
        region = [[x + far, y + far] for x, y in ((62, -5), (70, -5), (70, 5), (62, 5))]
        text = re.sub(r"polygon_mm = .*", f"polygon_mm = {region}", text)
        run = kempe("workspace", self.spec(text + f"[pole]\nat_mm = [{far}, {far}]\n"), "-o", out)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertTrue((out / "drawing.dxf").exists())

    def test_lengths_follow_the_shape(self):
        self.assertEqual(self.synthesize().returncode, 0)
        mechanism = json.loads((self.scratch / "out" / "design.json").read_text())["mechanism"]
        s, l = complex(*mechanism["shape"]), mechanism["lengths_mm"]
        self.assertAlmostEqual(l["AC"], l["VB"], places=9)
        self.assertAlmostEqual(l["BC"], l["VA"], places=9)
        self.assertAlmostEqual(l["AX"], l["VB"] / abs(s), places=9)
        self.assertAlmostEqual(l["BY"], l["VA"] * abs(s), places=9)

    def test_why_names_the_cause_at_a_point(self):
        path = next(specs_of("workspace"))
        run = kempe("workspace", path, "--why", "1000,0")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("reach", run.stdout)


class Habits(Case):
    def test_the_files_of_a_design_are_those_of_the_page(self):
        page = (SOURCE / "docs" / "commands.md").read_text()
        for name in FILES:
            self.assertIn(f"`{name}`", page)

    def test_a_folder_holds_one_design(self):
        """Parts of an earlier one must not be cut for this one; what is no file of a design stays."""
        out, sheet = self.scratch / "out", "[cutting]\nsheet_mm = [600, 600]\n"
        (out / "parts").mkdir(parents=True)
        for name in ("nested.dxf", "parts/mine.dxf"):
            (out / name).write_text("mine")
        self.assertEqual(self.synthesize().returncode, 0)
        self.assertEqual((out / "nested.dxf").read_text(), "mine")  # there was no design before
        self.assertEqual(self.synthesize(TEN_LINES + sheet).returncode, 0)
        self.assertNotEqual((out / "nested.dxf").read_text(), "mine")
        run = self.synthesize()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertFalse((out / "nested.dxf").exists())
        self.assertIn("Removed, left by an earlier design: nested.dxf.", run.stdout)
        self.assertEqual((out / "parts" / "mine.dxf").read_text(), "mine")
        self.assertTrue((out / "parts" / "VA.dxf").exists())

    def test_a_shorter_front_leaves_no_points_of_a_longer_one(self):
        out = self.scratch / "front"
        for points in (5, 3):
            run = kempe("pareto", EXAMPLES / "plagiograph.toml", "--between", "size,transmission", "--points", points, "-o", out, "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            found = json.loads(run.stdout)
            self.assertEqual(sorted(p.name for p in out.iterdir() if p.is_dir()), [f"{i + 1:02}" for i in range(found["points"])])
        self.assertTrue(any("files of 04/" in sentence for sentence in found["left_out"]))

    def test_a_design_takes_the_place_of_a_front_and_a_front_that_of_a_design(self):
        out, front = self.scratch / "out", ["pareto", EXAMPLES / "plagiograph.toml", "--between", "size,transmission", "--points", 3]
        self.assertEqual(kempe(*front, "-o", out).returncode, 0)
        self.assertEqual(self.synthesize().returncode, 0)
        self.assertFalse((out / "front.csv").exists() or (out / "01").exists())
        self.assertEqual(kempe(*front, "-o", out).returncode, 0)
        self.assertTrue((out / "front.csv").exists())
        self.assertFalse((out / "design.json").exists() or (out / "parts").exists())

    def test_a_proof_that_there_is_none_leaves_the_log_of_a_design_alone(self):
        self.assertEqual(self.synthesize().returncode, 0)
        log = (self.scratch / "out" / "certificate.jsonl").read_bytes()
        run = self.synthesize(TEN_LINES + "[limits]\ntransmission_deg = 85\n")
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertIn("holds a design", run.stderr)
        self.assertEqual((self.scratch / "out" / "certificate.jsonl").read_bytes(), log)

    def test_the_readme_shows_what_is_printed(self):
        page = (SOURCE / "README.md").read_text()
        shown = page.split("It prints, shortened", 1)[1].split("```")[1].strip().splitlines()
        printed = kempe("synthesize", EXAMPLES / "plagiograph.toml", "-o", self.scratch / "out").stdout.splitlines()
        self.assertGreater(len(shown), 5)
        self.assertEqual([line for line in shown if line not in printed], [])

    def test_help_of_every_command_has_an_example(self):
        listed = kempe("--help").stdout.split("Subcommands:")[1].splitlines()
        commands = [line.split()[0] for line in listed if line.startswith("  ") and line.split() and line[2] != " "]
        self.assertGreater(len(commands), 4)
        for command in commands:
            self.assertIn("Example:", kempe(command, "--help").stdout, command)

    def test_json_is_one_object_and_stderr_is_empty(self):
        run = self.synthesize(TEN_LINES, "--json")
        self.assertEqual(run.returncode, 0)
        self.assertIn("quality", json.loads(run.stdout))
        self.assertEqual(run.stderr, "")

    def test_same_seed_same_bytes_for_any_number_of_threads(self):
        seen = set()
        for threads in (1, 2, 7):
            out = self.scratch / str(threads)
            self.assertEqual(kempe("synthesize", self.spec(), "-o", out, "-j", threads).returncode, 0)
            seen.add(tuple((out / name).read_bytes() for name in sorted(FILES)))
        self.assertEqual(len(seen), 1)

    def test_the_locale_changes_nothing(self):
        self.synthesize()
        plain = (self.scratch / "out" / "design.json").read_bytes()
        environment = dict(os.environ, LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8")
        kempe("synthesize", self.spec(), "-o", self.scratch / "german", env=environment)
        self.assertEqual((self.scratch / "german" / "design.json").read_bytes(), plain)

    def test_file_names_in_any_script(self):
        spec = self.spec(TEN_LINES, "gravür '\"<&> 雕.toml")
        run = kempe("synthesize", spec, "-o", self.scratch / "añb \"<x>")
        self.assertEqual(run.returncode, 0, run.stderr)
        report = (self.scratch / "añb \"<x>" / "report.html").read_text()
        self.assertNotIn("<&> 雕", report)

    def test_markup_in_a_spec_stays_text(self):
        text = TEN_LINES + "# </script><script>alert(1)</script><img src=x onerror=alert(2)>\n"
        self.assertEqual(self.synthesize(text).returncode, 0)
        report = (self.scratch / "out" / "report.html").read_text()
        self.assertNotIn("<script>alert(1)", report)
        self.assertNotIn("<img src=x", report)

    def test_closed_stdout_is_an_error_that_says_so(self):
        with open("/dev/full", "w") as full:
            run = subprocess.run([KEMPE, "synthesize", self.spec(), "-o", self.scratch / "out"], stdout=full,
                                 stderr=subprocess.PIPE, text=True, timeout=600)
        self.assertEqual(run.returncode, 5, run.stderr)


class BadInput(Case):
    def test_mistakes_name_file_line_key_and_what_is_allowed(self):
        mistakes = {
            "scale = 1.4\n": ("scale = -1\n", "copy.scale"),
            "scale = 1.4": ("scale = nan", "copy.scale"),
            "scale = 1.4 ": None,
            "rotation_deg": ("rotation_rad", "rotation_rad"),
            "width_mm = 6": ("width_mm = -6", "links.width_mm"),
            "pin_diameter_mm": ("pin_diametre_mm", "pin_diameter_mm"),
            "size = [10, 10]": ("size = [0, 10]", "rectangle_mm"),
        }
        for old, new in mistakes.items():
            if new is None:
                continue
            with self.subTest(new[0]):
                self.assertIn(old, TEN_LINES)
                run = self.synthesize(TEN_LINES.replace(old, new[0]))
                self.assertRefused(run, 2, "spec.toml:", new[1])

    def test_readings_as_few_as_the_unknowns_say_what_their_intervals_assume(self):
        knight = EXAMPLES / "calibration" / "knight.toml"
        answer = kempe("calibrate", knight)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("assumed      readings are uncertain by 0.01 mm", answer.stdout)
        stated = self.spec(knight.read_text() + "\n[fit]\nreading_uncertainty_mm = 0.05\n", "stated.toml")
        self.assertNotIn("assumed", kempe("calibrate", stated).stdout)

    def test_a_design_needs_a_region_also_beside_a_mechanism(self):
        mapped = '[copy]\nscale = 0.3\n[mechanism]\nvertex = "pole"\nVA_mm = 90\nVB_mm = 60\n'
        spec = self.spec(mapped, "mapped.toml")
        self.assertRefused(kempe("synthesize", spec, "-o", self.scratch / "out"), 2, "mapped.toml: region: found nothing", "kempe workspace")
        self.assertRefused(kempe("pareto", spec, "--between", "size,transmission", "-o", self.scratch / "out"), 2, "region: found nothing")
        self.assertEqual(kempe("workspace", spec, "-o", self.scratch / "mapped").returncode, 0)

    def test_ratio_one_without_rotation_is_no_mechanism(self):
        run = self.synthesize(TEN_LINES.replace("1.4", "1").replace("90", "0"))
        self.assertRefused(run, 2, "copy")

    def test_crossing_region(self):
        crossing = "polygon_mm = [[60,-5],[70,5],[70,-5],[60,5]]"
        run = self.synthesize(TEN_LINES.replace("rectangle_mm = {at = [60, -5], size = [10, 10]}", crossing))
        self.assertRefused(run, 2, "polygon_mm")

    def test_empty_and_noise(self):
        self.assertRefused(self.synthesize(b""), 2, "spec.toml")
        self.assertRefused(self.synthesize(bytes(range(256)) * 20), 2, "spec.toml")
        self.assertRefused(kempe("synthesize", self.scratch / "absent.toml", "-o", self.scratch / "out"), 2, "absent.toml")

    def test_region_around_the_pole(self):
        text = TEN_LINES.replace("at = [60, -5], size = [10, 10]", "at = [-5, -5], size = [10, 10]")
        self.assertRefused(self.synthesize(text), 3, "no design")

    def test_region_out_of_reach(self):
        text = TEN_LINES.replace("at = [60, -5]", "at = [6000, -5]")
        self.assertRefused(self.synthesize(text), 3, "longest")

    def test_no_design_in_json_names_each_limit_and_what_would_do(self):
        def asking(degrees):
            return TEN_LINES + f"[limits]\ntransmission_deg = {degrees}\n"

        run = self.synthesize(asking(80), "--json")
        self.assertRefused(run, 3, "no design exists")
        said = json.loads(run.stdout)
        self.assertTrue(said["proven"])
        self.assertEqual(said["requirement"], "limits.transmission_deg")
        self.assertEqual([one["limit"] for one in said["relaxations"]], ["transmission"])
        enough = re.search(r"([0-9.]+) would do", said["relaxations"][0]["sentence"])
        self.assertEqual(self.synthesize(asking(enough[1])).returncode, 0)

    def test_a_search_that_found_none_is_no_proof(self):
        spec = self.spec(TEN_LINES + "[tolerance]\nlength_mm = 2\nplay_mm = 1\nrobust = true\n")
        run = kempe("synthesize", spec, "-o", self.scratch / "out", "--json")
        self.assertRefused(run, 6, "no design was found (not proven: one may exist)")
        self.assertNotIn("no design exists", run.stderr)
        said = json.loads(run.stdout)
        self.assertEqual((said["error"], said["proven"], said["files"]), ("no design was found", False, []))
        lines, out = self.scratch / "specs.jsonl", self.scratch / "batch"
        far = {"rectangle_mm": {"at": [6000, -5], "size": [10, 10]}}
        near = {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}}
        links = {"width_mm": 6, "pin_diameter_mm": 3}
        specs = [{"region": near, "tolerance": {"length_mm": 2, "play_mm": 1, "robust": True}}, {"region": far}]
        lines.write_text("".join(json.dumps({"copy": {"scale": 1.4, "rotation_deg": 90}, "links": links, **one}) + "\n" for one in specs))
        self.assertEqual(kempe("synthesize", "--batch", lines, "-o", out).returncode, 0)
        told = [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]
        self.assertEqual([(one["status"], one["proven"]) for one in told], [("none found", False), ("no design", True)])

    def test_joints_stand_no_nearer_than_their_holes_and_a_wall(self):
        def spec(keys, cutting=""):
            return ("[copy]\nscale = 3.5\n[region]\npolygon_mm = [[-190, 34], [-202, 17], [-180, -1]]\n[links]\n"
                    "width_mm = 24.5\npin_diameter_mm = 20.5\nshortest_mm = 2\nlongest_mm = 950\n" + keys + "[limits]\n"
                    "transmission_deg = 16\nsheets_gap_mm = 4.1\n" + cutting)

        for keys, cutting, least in (("", "", 22.55), ("wall_mm = 0.5\n", "", 21), ("wall_mm = 40\n", "", 60.5),
                                     ("", "[cutting]\nhole_fit_mm = 1.5\n", 24.05),
                                     ("", "[cutting]\nhole_fit_mm = -0.5\n", 22.55)):
            run = self.synthesize(spec(keys, cutting), "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            said = json.loads(run.stdout)
            shortest = min(said["mechanism"]["lengths_mm"].values())
            self.assertGreaterEqual(shortest, least * (1 - 1e-9))
            self.assertLess(shortest, least * (1 + 1e-6))  # the wall is what holds them apart
            self.assertEqual([sentence for sentence in said["left_out"] if not sentence.startswith("certificate")], [])
            self.assertTrue((self.scratch / "out" / "parts" / "ACX.stl").exists())

    def test_a_locked_length_nearer_than_holes_can_be(self):
        text = TEN_LINES.replace("[links]", "[links]\nVA_mm = 16\nwall_mm = 13.5")
        self.assertRefused(self.synthesize(text), 3, "links.wall_mm = 13.5", "links.VA_mm", "13 would fit", "proven")

    def test_the_longest_multiple_of_a_grid_counts_although_it_is_rounded(self):
        """301.2 / 100.4 is below 3 in doubles."""
        text = """
[copy]
scale = 1
rotation_deg = 60
[region]
rectangle_mm = {at = [415, -5], size = [10, 10]}
[links]
grid_mm = 100.4
longest_mm = 301.2
WALL
[limits]
transmission_deg = 20
"""
        for key in ("wall_mm", "shortest_mm"):
            run = self.synthesize(text.replace("WALL", f"{key} = 250"), "--quiet")
            self.assertEqual(run.returncode, 0, run.stderr)

    def test_a_copy_on_its_original_is_told_with_what_helps(self):
        def spec(gap, pole="[0, 0]"):
            return ("[copy]\nscale = 0.5\n[region]\nrectangle_mm = {at = [100, -60], size = [200, 120]}\n"
                    f"[pole]\nat_mm = {pole}\n[limits]\n{gap}\n")

        elsewhere = []
        for value in (5, 0.001, 0):
            run = self.synthesize(spec(f"sheets_gap_mm = {value}"))
            self.assertRefused(run, 3, "proven: no linkage can", "overlaps the original, whatever the links are", "(0, 0)")
            self.assertNotIn("one of these alone", run.stderr)
            place = re.search(r"the pole at \((.*)\) mm would do", run.stderr)
            elsewhere.append(spec(f"sheets_gap_mm = {value}", f"[{place[1]}]"))
        for text in elsewhere:
            self.assertEqual(self.synthesize(text).returncode, 0)
        note = "the copy overlaps the original; limits.sheets_gap_mm keeps them apart"
        run = self.synthesize(spec(""))
        self.assertEqual(run.returncode, 0)
        self.assertIn(note, run.stdout)
        self.assertIn(note[1:], (self.scratch / "out" / "report.html").read_text())
        self.assertTrue(json.loads(self.synthesize(spec(""), "--json").stdout)["copy_overlaps_original"])
        self.assertNotIn(note, self.synthesize(TEN_LINES).stdout)
        self.assertNotIn(note[1:], (self.scratch / "out" / "report.html").read_text())
        self.assertFalse(json.loads(self.synthesize(TEN_LINES, "--json").stdout)["copy_overlaps_original"])

    def test_a_pole_in_the_region_is_told_with_its_place_and_another(self):
        run = self.synthesize(TEN_LINES + "[pole]\nat_mm = [65, 1]\n")
        self.assertRefused(run, 3, "proven: no linkage can", "(65, 1) mm stands inside the region", "would do")

    def test_plate_longer_than_allowed(self):
        text = TEN_LINES.replace("scale = 1.4", "scale = 90")
        self.assertRefused(self.synthesize(text), 3, "longest")

    def test_a_million_corners_are_work_and_not_an_error(self):
        count = int(1_000_000 * float(os.environ.get("KEMPE_SAMPLES", "1")))  # fewer in a slow (sanitised) build
        ring = ",".join(f"[{65 + 4 * math.cos(2 * math.pi * i / count):.9f},{4 * math.sin(2 * math.pi * i / count):.9f}]"
                        for i in range(count))
        text = TEN_LINES.replace("rectangle_mm = {at = [60, -5], size = [10, 10]}", f"polygon_mm = [{ring}]")
        run = self.synthesize(text)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_folder_that_cannot_be_written(self):
        blocker = self.spec("", "file")
        run = kempe("synthesize", self.spec(), "-o", blocker / "out")
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertIn("cannot", run.stderr)

    def test_design_cut_short_or_edited(self):
        self.assertEqual(self.synthesize().returncode, 0)
        design = self.scratch / "out" / "design.json"
        whole = design.read_text()
        for share in (0.0, 0.3, 0.9):
            design.write_text(whole[: int(len(whole) * share)])
            self.assertEqual(kempe("verify", design).returncode, 2)
        edited = json.loads(whole)
        for name in edited["mechanism"]["lengths_mm"]:
            changed = json.loads(whole)
            changed["mechanism"]["lengths_mm"][name] *= 1.001
            design.write_text(json.dumps(changed))
            run = kempe("verify", design)
            self.assertEqual(run.returncode, 4, f"{name}: {run.stderr}")
        edited["mechanism"]["lengths_mm"]["VA"] = float("nan")
        design.write_text(json.dumps(edited))
        self.assertEqual(kempe("verify", design).returncode, 2)


LONG_SEARCH = """
[copy]
scale = 0.1
rotation_deg = -89.999
[region]
circle_mm = {centre = [-57, 157], radius = 51}
[links]
width_mm = 20
pin_diameter_mm = 10
plate = "triangle"
layers = 4
longest_mm = 3000
[limits]
transmission_deg = 0
[[obstacles]]
rectangle_mm = {at = [111, 101], size = [28, 26]}
layers = [2, 2]
[[obstacles]]
rectangle_mm = {at = [0, -66], size = [9, 4]}
layers = [1, 8]
[objective]
minimize = "footprint"
"""


class Inches(Case):
    """What a file in inches is told can be typed into it."""
    TEXT = ('units = "in"\n[copy]\nscale = 2\n[region]\nrectangle_in = [8, 0, 4, 6]\n[links]\nwidth_in = 0.75\n'
            "pin_diameter_in = 0.25\n")

    def assertToldInInches(self, run):
        self.assertIn(run.returncode, (3, 6), run.stderr)
        self.assertNotRegex(run.stderr, "_mm|[0-9)] mm")

    def test_a_value_that_would_do_is_one_of_the_file(self):
        for table, key, value in (("links", "longest_in", "5"), ("limits", "sheets_gap_in", "9")):

            def spec(number):
                line = f"{key} = {number}\n"
                return self.TEXT + (line if table == "links" else f"[{table}]\n" + line)

            run = self.synthesize(spec(value))
            self.assertToldInInches(run)
            enough = re.search(rf"{table}\.{key} = {value} is in the way; ([0-9.]+) would do.*: VA = [0-9.]+ in, VB", run.stderr)
            self.assertTrue(enough, run.stderr)
            self.assertEqual(self.synthesize(spec(enough[1])).returncode, 0, enough[1])

    def test_a_place_that_would_do_is_one_of_the_file(self):
        def spec(place):
            return self.TEXT + f"[pole]\nat_in = [{place}]\n"

        run = self.synthesize(spec("10, 3"))
        self.assertToldInInches(run)
        self.assertIn("the pole at (10, 3) in stands inside the region", run.stderr)
        place = re.search(r"pole.at_in is in the way; the pole at \((.*?)\) in would do", run.stderr)
        self.assertTrue(place, run.stderr)
        self.assertEqual(self.synthesize(spec(place[1])).returncode, 0, place[1])

    def test_holes_too_near_are_told_in_inches(self):
        run = self.synthesize(self.TEXT + "shortest_in = 0.3\nVA_in = 0.5\nwall_in = 0.4\n")
        self.assertToldInInches(run)
        words = ("links.wall_in = 0.4 is in the way: two holes of 0.25 in with a wall of 0.4 in between them stand 0.65 in apart, "
                 "and links.VA_in leaves them 0.5 in; 0.25 would fit")
        self.assertIn(words, run.stderr)

    def test_programs_read_the_same_keys_as_ever(self):
        run = self.synthesize(self.TEXT + "longest_in = 5\n", "--json")
        said = json.loads(run.stdout)
        self.assertEqual(said["requirement"], "links.longest_mm")
        self.assertEqual(said["relaxations"][0]["key"], "links.longest_mm")
        self.assertGreater(said["relaxations"][0]["VA_mm"], 127)
        self.assertIn("links.longest_in = 5 is in the way", said["sentence"])

    def test_a_mechanism_is_told_of_keys_of_the_file(self):
        mechanism = '[mechanism]\nvertex = "pole"\nVA_in = 5\nVB_in = 5\nassembly = 0\n'
        out = self.scratch / "out"
        self.assertRefused(kempe("workspace", self.spec(self.TEXT), "-o", out), 2, "with vertex, VA_in, VB_in")
        free = self.TEXT + "[pole]\nwithin_in = [[0, 0], [1, 0], [0, 1]]\n" + mechanism
        self.assertRefused(kempe("workspace", self.spec(free), "-o", out), 2, "pole.within_in", "at_in:")
        under = self.TEXT + mechanism + "[[obstacles]]\ncircle_in = [0, 0, 1]\n"
        self.assertRefused(kempe("workspace", self.spec(under), "-o", out), 3, "the pole at (0, 0) in")

    def test_lengths_in_the_table_have_no_rounding_noise(self):
        text = self.TEXT.replace("scale = 2", "scale = 0.5\nrotation_deg = 180").replace("[8, 0, 4, 6]", "[8, -3, 4, 6]")
        mechanism = '[mechanism]\nvertex = "pole"\nVA_in = 3\nVB_in = 5\nassembly = 0\n[limits]\ntransmission_deg = 1\n'
        run = kempe("workspace", self.spec(text + mechanism), "-o", self.scratch / "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        table = (self.scratch / "out" / "links.csv").read_text()
        self.assertIn("BCY,CY,114.3,", table)
        self.assertNotRegex(table, r"\d{12}")

    def test_the_summary_names_keys_of_the_file(self):
        run = self.synthesize(self.TEXT)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("cutting.hole_fit_in gives", run.stdout)
        self.assertNotIn("hole_fit_mm", run.stdout)


class TimeLimits(Case):
    def test_stopped_before_an_answer_is_exit_6(self):
        self.assertRefused(self.synthesize(LONG_SEARCH, "--time-limit", "0.001"), 6, "stopped (time limit of 0.001 s)")
        run = self.synthesize(LONG_SEARCH, "--time-limit", "0.001", "--json")
        self.assertEqual(run.returncode, 6)
        self.assertEqual(json.loads(run.stdout)["error"], "stopped")

    def test_a_proof_is_told_whatever_the_limit(self):
        text = TEN_LINES + "[pole]\nat_mm = [65, 0]\n"
        self.assertRefused(self.synthesize(text, "--time-limit", "0.001"), 3, "inside the region")

    def test_a_limit_that_is_not_reached_changes_nothing(self):
        out = self.scratch / "out"
        self.assertEqual(self.synthesize(TEN_LINES).returncode, 0)
        without = (out / "design.json").read_bytes()
        self.assertEqual(self.synthesize(TEN_LINES, "--time-limit", "1e6").returncode, 0)
        self.assertEqual((out / "design.json").read_bytes(), without)

    def test_what_is_no_time_is_refused(self):
        for seconds in ("nan", "inf", "-1", "0", "soon"):
            self.assertRefused(self.synthesize(TEN_LINES, "--time-limit", seconds), 2)

    def test_of_each_spec_of_a_batch(self):
        specs, out = self.scratch / "specs", self.scratch / "out"
        specs.mkdir()
        (specs / "long.toml").write_text(LONG_SEARCH)
        run = kempe("synthesize", "--batch", specs, "-o", out, "--time-limit", "0.001")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(json.loads((out / "results.jsonl").read_text())["status"], "stopped")

    def test_a_front_of_sections_that_was_stopped_is_no_proof(self):
        spec = self.spec("""
[copy]
scale = 1.4
rotation_deg = 90
[region]
polygon_mm = [[62, -5], [70, -5], [70, 5], [62, 5]]
[links]
sections_mm = [[12, 4], [200, 4]]
[limits]
longest_strip_mm = 205
""")
        front = ("pareto", spec, "--between", "size,transmission", "--points", "3", "-o", self.scratch / "out")
        self.assertNotEqual(kempe(*front, "--time-limit", "0.01").returncode, 3)
        self.assertEqual(kempe(*front, "--quiet").returncode, 0)

    def test_of_a_front_and_of_a_map(self):
        spec, out = self.spec(LONG_SEARCH), self.scratch / "out"
        front = kempe("pareto", spec, "--between", "size,transmission", "-o", out, "--time-limit", "0.001")
        self.assertRefused(front, 6, "stopped")
        given = EXAMPLES / "report-mechanism.toml"
        run = kempe("workspace", given, "-o", out, "--time-limit", "0.000001", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        told = json.loads(run.stdout)
        self.assertIs(told["workspace"]["complete"], False)
        self.assertIsNone(told["quality"]["footprint_mm2"])
        self.assertLessEqual({"design.json", "links.csv", "bom.csv"}, set(told["files"]))
        self.assertEqual(kempe("verify", out / "design.json").returncode, 0)

    def test_a_region_of_many_corners_is_stopped_too(self):
        """How soon, bench/limits.py measures."""
        teeth = "".join(f", [140, {y}], [140, {y + 0.004}], [120, {y + 0.004}], [120, {y + 0.008}]"
                        for y in (-20 + 0.008 * i for i in range(5000)))
        text = ("copy = {scale = 1.4, rotation_deg = 90}\npole = {at_mm = [0, 0]}\n"
                f"region = {{polygon_mm = [[100, -20]{teeth}, [100, 20]]}}\n")
        for limit in ("0.001", "0.3"):
            run = self.synthesize(text, "--time-limit", limit, "-j", "1")
            self.assertIn(run.returncode, (0, 6), run.stderr)
            self.assertRegex(run.stderr, "stopped|time was over")


class ObstaclesOutOfReach(Case):
    FAR = "".join(f"[[obstacles]]\nname = 'far {i}'\nrectangle_mm = {{at = [{2000 + 9 * i}, 2000], size = [5, 5]}}\n"
                  for i in range(300))

    def test_are_left_out_and_named(self):
        out = self.scratch / "out"
        run = self.synthesize(TEN_LINES + self.FAR)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("300 out of reach of any permitted instrument", run.stdout)
        design = json.loads((out / "design.json").read_text())
        self.assertEqual(design["search"]["obstacles_out_of_reach"], [f"far {i}" for i in range(300)])
        self.assertEqual(len(design["obstacles"]), 300)
        self.assertIn("far 199", (out / "report.html").read_text())
        self.assertEqual(kempe("verify", out / "design.json").returncode, 0)
        self.synthesize(TEN_LINES)
        without = json.loads((out / "design.json").read_text())
        self.assertEqual(without["mechanism"], design["mechanism"])

    def test_are_named_where_there_is_no_design(self):
        text = TEN_LINES + "[limits]\ntransmission_deg = 80\n" + self.FAR
        run = self.synthesize(text, "--json")
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertEqual(len(json.loads(run.stdout)["obstacles_out_of_reach"]), 300)


class Faults(Case):
    def whole_or_absent(self, folder):
        for name in FILES:
            path = folder / name
            if path.exists() and name.endswith(".json"):
                json.loads(path.read_text())
            if path.exists() and name == "report.html":
                self.assertIn("</html>", path.read_text())
            if path.exists() and name == "drawing.dxf":
                self.assertTrue(path.read_text().rstrip().endswith("EOF"))

    def test_killed_at_any_moment_no_file_is_half_written(self):
        out = self.scratch / "out"
        for i in range(100):
            process = subprocess.Popen([KEMPE, "synthesize", self.spec(), "-o", out], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            time.sleep(0.003 * i)
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.whole_or_absent(out)

    def test_two_runs_into_one_folder(self):
        out = self.scratch / "out"
        both = [subprocess.Popen([KEMPE, "synthesize", self.spec(), "-o", out], stdout=subprocess.DEVNULL) for _ in range(2)]
        for process in both:
            self.assertEqual(process.wait(), 0)
        self.whole_or_absent(out)
        self.assertEqual({p.name for p in out.iterdir() if not p.is_dir()} - FILES - {"bom.csv", "nested.dxf", "certificate.jsonl"}, set())

    def test_interrupted_search_ends_with_130(self):
        # Many layers make the search long enough to be met by a signal.
        text = TEN_LINES.replace("[links]", "[links]\nlayers = 6")
        process = subprocess.Popen([KEMPE, "synthesize", self.spec(text), "-o", self.scratch / "out", "-j", "1"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        wait_until_caught(process.pid, signal.SIGINT)
        time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, message = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, message)
        self.whole_or_absent(self.scratch / "out")


class Batch(Case):
    def specs(self):
        folder = self.scratch / "specs"
        folder.mkdir()
        for i in range(6):
            (folder / f"{i}.toml").write_text(TEN_LINES.replace("90", str(60 + 10 * i)))
        (folder / "bad.toml").write_text("[copy]\nscale = -1\n")
        (folder / "none.toml").write_text(TEN_LINES.replace("at = [60, -5]", "at = [6000, -5]"))
        return folder

    def results(self, source, out, *arguments):
        run = kempe("synthesize", "--batch", source, "-o", out, *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return (out / "results.jsonl").read_bytes(), (out / "results.csv").read_bytes(), run.stderr

    def test_same_bytes_for_any_number_of_threads_and_one_bad_spec_stops_no_other(self):
        source = self.specs()
        one = self.results(source, self.scratch / "one", "-j", 1)
        two = self.results(source, self.scratch / "two", "-j", 3)
        self.assertEqual(one[:2], two[:2])
        statuses = [json.loads(line)["status"] for line in one[0].decode().splitlines()]
        self.assertEqual(statuses, ["design"] * 6 + ["bad input", "no design"])

    def test_goes_on_after_a_kill_and_does_nothing_twice(self):
        source, out = self.specs(), self.scratch / "out"
        whole = self.results(source, self.scratch / "whole", "-j", 1)
        process = subprocess.Popen([KEMPE, "synthesize", "--batch", source, "-o", out, "-j", "1"],
                                   stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
        process.stderr.readline()  # at least one spec is finished
        process.send_signal(signal.SIGKILL)
        process.communicate()
        before = sum(1 for p in out.glob("journal-*.jsonl") for line in p.read_text().splitlines() if line)
        resumed = self.results(source, out, "-j", 1)
        self.assertEqual(resumed[:2], whole[:2])
        self.assertEqual(len(resumed[2].splitlines()), 8 - before)

    def test_lines_of_json_mean_what_the_same_toml_means(self):
        lines = self.scratch / "specs.jsonl"
        spec = {"copy": {"scale": 1.4, "rotation_deg": 90},
                "region": {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}},
                "links": {"width_mm": 6, "pin_diameter_mm": 3}}
        lines.write_text(json.dumps(spec) + "\nno json\n")
        result = self.results(lines, self.scratch / "out")[0].decode().splitlines()
        self.synthesize()
        design = json.loads((self.scratch / "out" / "design.json").read_text())
        self.assertEqual(json.loads(result[0])["VA_mm"], design["mechanism"]["lengths_mm"]["VA"])
        self.assertEqual(json.loads(result[1])["status"], "bad input")

    def test_values_and_bounds_are_in_the_unit_of_the_design_file(self):
        spec = {"copy": {"scale": 1.4, "rotation_deg": 90}, "region": {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}},
                "links": {"width_mm": 6, "pin_diameter_mm": 3}}
        objectives = ({"minimize": "size"}, {"maximize": "transmission"}, {"minimize": "footprint"})
        lines = self.scratch / "specs.jsonl"
        lines.write_text("".join(json.dumps(dict(spec, objective=one)) + "\n" for one in objectives))
        results = [json.loads(line) for line in self.results(lines, self.scratch / "out")[0].decode().splitlines()]
        for objective, result in zip(objectives, results):
            (way, name), = objective.items()
            self.synthesize(TEN_LINES + f'[objective]\n{way} = "{name}"\n')
            design = json.loads((self.scratch / "out" / "design.json").read_text())
            self.assertEqual(result["objective"], name)
            self.assertEqual(result["value"], design["search"]["value"])
            # The design's may be stated a millionth looser, as its log proves it.
        self.assertAlmostEqual((result.get("lower_bound") or 1) / (design["quality"]["lower_bound"] or 1), 1, delta=2e-6)
        self.assertAlmostEqual(results[1]["value"], results[1]["transmission_deg"], places=9)
        self.assertGreater(results[1]["value"], 10)  # degrees: no angle in radians is so large

    def test_lines_know_of_holes(self):
        links = {"width_mm": 12, "pin_diameter_mm": 11, "shortest_mm": 1}
        spec = {"copy": {"scale": 1.4, "rotation_deg": 90}, "region": {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}}}
        lines = self.scratch / "specs.jsonl"
        lines.write_text("".join(json.dumps(dict(spec, links=dict(links, **more))) + "\n" for more in (
            {}, {"pin_diameter_mm": 12}, {"VA_mm": 12})))
        kept, no_wall, locked = map(json.loads, self.results(lines, self.scratch / "out")[0].decode().splitlines())
        self.assertEqual([one["status"] for one in (kept, no_wall, locked)], ["design", "design", "no design"])
        self.assertGreaterEqual(min(kept["VA_mm"], kept["VB_mm"]), 12.1 * (1 - 1e-9))
        self.assertNotIn("parts", kept)
        self.assertIn("leave no wall", no_wall["parts"])
        self.assertTrue(locked["proven"])
        self.assertIn("links.pin_diameter_mm = 11", locked["message"])


class Words(Case):
    """People get text, programs JSON, of answers and of faults."""
    ANSWERS = [("verify", EXAMPLES / "calibration" / "drawing-pantograph.json"),
               ("mobility", EXAMPLES / "linkages" / "hart.toml"), ("mobility", "--links", 8, "--dof", 1),
               ("mobility", "--links", 5, "--dof", 1), ("centres", EXAMPLES / "linkages" / "shear-press.toml", "--at", 3),
               ("function", EXAMPLES / "generators" / "logarithm.toml"), ("function", EXAMPLES / "generators" / "table.toml"),
               ("inversor", EXAMPLES / "generators" / "enlarger.toml"),
               *(("calibrate", EXAMPLES / "calibration" / f"{name}.toml", *options) for name, options in
                 [("knight", ()), ("plotter", ()), ("plotter-without-ruler", ()), ("ten-readings", ("--plan",)),
                  ("knight-second-round", ()), ("simulate", ("--simulate",))])]

    def numbers(self, value):
        """Every number of a JSON value."""
        if isinstance(value, dict):
            value = list(value.values())
        if isinstance(value, list):
            return [number for one in value for number in self.numbers(one)]
        return [value] if isinstance(value, (int, float)) and not isinstance(value, bool) else []

    def test_answers_are_text_and_json_on_request(self):
        for arguments in self.ANSWERS:
            told, asked = kempe(*arguments), kempe(*arguments, "--json")
            self.assertEqual((told.returncode, asked.returncode), (0, 0), told.stderr)
            answer = json.loads(asked.stdout)
            self.assertIsInstance(answer, dict)
            with self.assertRaises(ValueError):
                json.loads(told.stdout)
            for line in told.stdout.splitlines():
                self.assertRegex(line, r"^(\S[\w ]{0,11} | {2,}\S)", arguments)  # a label, or what belongs to one above
                self.assertLess(len(line), 180)
            self.assertNotRegex(told.stdout, r"\bnan\b|\binf\b|null|-0\.0+\b")
            # What the text says in figures stands in the JSON, which has more of them.
            exact = self.numbers(answer)
            widths = [(half, answer["uncertainty_mm"][name]) for name, half in answer.get("interval_95_mm", {}).items() if half]
            exact += [number * widths[0][0] / widths[0][1] for number in exact] if widths else []  # 95 % where the JSON has the standard
            if "arm_mm" in answer.get("instrument", {}):  # a scale stands at arm times ratio, an arm has its error
                arm, ratio = answer["instrument"]["arm_mm"], answer["instrument"]["ratio"]
                exact += [arm * ratio, *(arm + error for error in answer.get("errors_mm", {}).values())]
            figures = told.stdout.replace(str(answer.get("linkage")), "")  # a name is no figure
            for figure in re.findall(r"(?<![\w.])[-+]?\d+\.\d{3,}(?![\w.])", figures):
                step = 10.0 ** -len(figure.split(".")[1])
                self.assertTrue(any(abs(abs(number) - abs(float(figure))) <= 0.51 * step for number in exact),
                                f"{arguments}: {figure}")

    SLIPS = "[copy]\nscale = 0\n[region]\npolygon_mm = [[0, 0], [1, 1]]\n[links]\nwidht_mm = 6\n[objectve]\n"

    def test_every_fault_of_a_spec_is_told_in_words_and_in_json(self):
        keys = [(2, "copy.scale"), (4, "region.polygon_mm"), (6, "links.widht_mm"), (7, "objectve")]
        run = self.synthesize(self.SLIPS)
        self.assertRefused(run, 2)
        self.assertEqual(run.stdout, "")
        spec = self.scratch / "spec.toml"
        lines = run.stderr.splitlines()
        self.assertEqual(len(lines), len(keys))
        for line, (number, key) in zip(lines, keys):
            self.assertTrue(line.startswith(f"kempe: {spec}:{number}: {key}: found "), line)
        asked = self.synthesize(self.SLIPS, "--json")
        self.assertRefused(asked, 2, *lines)
        faults = json.loads(asked.stdout)["error"]["faults"]
        self.assertEqual([(fault["file"], fault["line"], fault["key"]) for fault in faults],
                         [(str(spec), *key) for key in keys])
        for fault, line in zip(faults, lines):
            self.assertEqual(list(fault), ["file", "line", "key", "found", "allowed"])
            self.assertTrue(line.endswith(f"found {fault['found']}; allowed: {fault['allowed']}"), line)

    def test_values_of_options_that_are_none(self):
        spec = self.spec()
        for option, value in (("--seed", "-5"), ("--seed", "99999999999999999999"), ("--seed", "1e3"), ("--paper", "A5"), ("--paper", "1")):
            run = kempe("synthesize", spec, "-o", self.scratch / "out", option, value)
            self.assertRefused(run, 2, option, f"found {value}; allowed: ")

    def test_commands_that_are_told_can_be_typed(self):
        for name in ("a b.toml", "it's.toml", "a;b.toml"):
            folder = self.scratch / name
            run = kempe("init", "plagiograph", "-o", folder)
            line = next(line for line in run.stdout.splitlines() if line.startswith("next"))
            words = subprocess.run(["sh", "-c", f"printf '%s\\n' {line[4:]}"], capture_output=True, text=True).stdout.splitlines()
            self.assertEqual(words[:3], ["kempe", "synthesize", str(folder)])

    def test_a_fault_is_json_for_every_command(self):
        bad = self.spec("[copy\n", "bad.toml")
        for command, *rest in (("synthesize", "-o", self.scratch / "out"), ("workspace", "-o", self.scratch / "out"), ("verify",),
                               ("report", "-o", self.scratch / "out"), ("solve",), ("mobility",), ("centres",), ("calibrate",), ("function",), ("inversor",), ("path",),
                               ("studio",), ("pareto", "--between", "size,transmission", "-o", self.scratch / "out")):
            run = kempe(command, bad, *rest, "--json")
            self.assertRefused(run, 2, str(bad))
            fault = json.loads(run.stdout)["error"]["faults"][0]
            self.assertEqual((fault["file"], fault["line"]), (str(bad), 1), command)
            run = kempe(command, self.scratch / "absent.toml", *rest, "--json")
            self.assertEqual(json.loads(run.stdout)["error"]["faults"][0]["found"], "no such file", command)
            run = kempe(command, bad, *rest, "--frobnicate", "--json")
            self.assertRefused(run, 2, f"kempe {command}: ", f"see kempe {command} --help")
            self.assertEqual(json.loads(run.stdout)["error"]["faults"][0]["key"], command)

    def test_an_answer_that_does_not_exist_is_json_too(self):
        lens = self.spec("[lens]\nfocal_length_mm = 100\nmagnification = [0.5, 2]\n[links]\nlongest_mm = 1\n", "lens.toml")
        run = kempe("inversor", lens, "--json")
        self.assertEqual(run.returncode, 6)
        told = json.loads(run.stdout)
        self.assertEqual((told["error"], told["proven"]), ("no design was found", False))

    def test_a_file_of_another_kind_is_told_its_command(self):
        design = kempe("synthesize", self.spec(), "-o", self.scratch / "made") and self.scratch / "made" / "design.json"
        press = EXAMPLES / "linkages" / "shear-press.toml"
        knight = EXAMPLES / "calibration" / "knight.toml"
        for command, file, found, use in (("synthesize", press, "a linkage file", "kempe solve"), ("solve", self.spec(), "a spec of a", "kempe synthesize"),
                                          ("synthesize", design, "a design.json", "kempe verify"), ("verify", press, "a linkage file", "kempe solve"),
                                          ("report", self.spec(), "a spec of a", "kempe synthesize"), ("calibrate", press, "a linkage file", "kempe solve"),
                                          ("function", knight, "a file of measurements", "kempe calibrate")):
            out = () if command in ("solve", "verify", "calibrate", "function") else ("-o", self.scratch / "out")
            run = kempe(command, file, *out, "--json")
            self.assertRefused(run, 2, f"found {found}", use)
            faults = json.loads(run.stdout)["error"]["faults"]
            self.assertEqual([(fault["file"], fault["line"], fault["key"]) for fault in faults], [(str(file), None, None)], command)

    def test_another_place_of_the_pole_is_offered(self):
        text = "[copy]\nscale = 1.4\nrotation_deg = 37\n[region]\nrectangle_mm = [-20, -15, 40, 30]\n"
        run = self.synthesize(text, "--json")
        self.assertRefused(run, 3, "pole")
        offered = [one for one in json.loads(run.stdout)["relaxations"] if one["key"] == "pole.at_mm"]
        self.assertEqual(len(offered), 1, run.stdout)
        place = re.search(r"the pole at \((.*)\) mm would do", offered[0]["sentence"])
        self.assertEqual(self.synthesize(text + f"[pole]\nat_mm = [{place[1]}]\n").returncode, 0)

    def test_help_by_name_is_help_by_option(self):
        self.assertEqual(kempe("help").stdout, kempe("--help").stdout)
        self.assertEqual(kempe("help", "synthesize").stdout, kempe("synthesize", "--help").stdout)
        self.assertEqual(kempe("-v").stdout, kempe("--version").stdout)
        self.assertRefused(kempe("help", "synthesise"), 2, "synthesize (the nearest known command)")
        self.assertEqual(json.loads(kempe("help", "verify", "--json").stdout)["help"], kempe("verify", "--help").stdout)

    def test_manual_and_completions_name_every_command_and_option(self):
        share = self.scratch / "share"
        run = kempe("help", "--write", share)
        self.assertEqual(run.returncode, 0, run.stderr)
        listed = kempe("--help").stdout.split("Subcommands:")[1].splitlines()
        commands = [line.split()[0] for line in listed if line.startswith("  ") and line.split() and line[2] != " "]
        shells = [(share / path).read_text() for path in ("bash-completion/completions/kempe", "zsh/site-functions/_kempe",
                                                          "fish/vendor_completions.d/kempe.fish")]
        index = (share / "man/man1/kempe.1").read_text()
        for command in commands:
            page = (share / f"man/man1/kempe-{command}.1").read_text()
            self.assertIn(f"kempe\\-{command}", index)
            self.assertNotRegex(page, r"(?m)^[.'](?!TH|SH|TP|B|EX|EE)")  # nothing else begins like a request
            options = set(re.findall(r"(?<![\w-])--([a-z][\w-]+)", kempe(command, "--help").stdout.split("Example:")[0]))
            for option in options - {"help"} if command == "help" else options:
                self.assertIn("\\-\\-" + option.replace("-", "\\-"), page, command)
                self.assertIn("--" + option, shells[0])
            for shell in shells:
                self.assertIn(command, shell)
        self.assertEqual(subprocess.run(["bash", "-n", share / "bash-completion/completions/kempe"]).returncode, 0)

    def test_bash_completes(self):
        share = self.scratch / "share"
        kempe("help", "--write", share)
        script = (f". {share}/bash-completion/completions/kempe; COMP_WORDS=({{words}}); COMP_CWORD={{at}}; _kempe; "
                  'echo "${{COMPREPLY[@]}}"')

        def completed(words):
            text = script.format(words=" ".join(f"'{word}'" for word in words), at=len(words) - 1)
            return subprocess.run(["bash", "-c", text], capture_output=True, text=True, cwd=self.scratch).stdout.split()

        self.assertEqual(completed(["kempe", "syn"]), ["synthesize"])
        self.assertEqual(completed(["kempe", "help", "verif"]), ["verify"])
        self.assertEqual(completed(["kempe", "synthesize", "--time"]), ["--time-limit"])
        self.assertIn("share", completed(["kempe", "synthesize", "sha"]))

    def test_commands_that_are_none(self):
        for word, meant in (("synthesise", "synthesize"), ("verfy", "verify"), ("center", "centres"), ("optimise", None), ("frobnicate", None)):
            run = kempe(word, "spec.toml")
            self.assertRefused(run, 2, f"kempe {word}: no such command; " + (f"did you mean {meant}?" if meant else "there are "))
            self.assertEqual("did you mean" in run.stderr, meant is not None)
            self.assertEqual(run.stdout, "")
            self.assertEqual(json.loads(kempe(word, "--json").stdout)["error"]["faults"][0]["found"], "no such command")
        self.assertRefused(kempe(), 2, "kempe --help")
        self.assertRefused(kempe("--frobnicate"), 2, "kempe --frobnicate: no such option")


class Generators(Case):
    def test_function_examples(self):
        for path in [EXAMPLES / "generators" / name for name in ("logarithm.toml", "table.toml")]:
            run = kempe("function", path, "--json", "--plot", self.scratch / "error.svg")
            self.assertEqual(run.returncode, 0, run.stderr)
            design = json.loads(run.stdout)
            self.assertLess(design["structural_error_max_deg"], 3)
            self.assertIn("</svg>", (self.scratch / "error.svg").read_text())

    def test_function_mistakes(self):
        good = (EXAMPLES / "generators" / "logarithm.toml").read_text()
        for old, new, word in (("\"log10(x)\"", "\"log10(\"", "expression"), ("x = [1, 2]", "x = [2, 1]", "function.x"),
                               ("range_deg = 60", "range_deg = 0", "range_deg"), ("method = ", "methd = ", "function.method"),
                               ("ground_mm", "ground_cm", "links.ground_mm")):
            run = kempe("function", self.spec(good.replace(old, new, 1)))
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(word, run.stderr)

    def test_inversor_example(self):
        run = kempe("inversor", EXAMPLES / "generators" / "enlarger.toml", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        found = json.loads(run.stdout)
        self.assertEqual(found["best"], "right_angle")
        self.assertEqual([i["kind"] for i in found["inversors"]], ["peaucellier", "hart", "right_angle"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
