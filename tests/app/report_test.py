#!/usr/bin/env python3
"""`kempe report` from outside: a design's file gives back the folder that it came from, and nothing comes of a file that lies.

usage: report_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import copy
import csv
import json
import pathlib
import random
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import FILES, POLE_IN_HOLE, SOURCE, TEN_LINES, kempe

# Files that follow from the design alone; the report shows the spec too, which design.json does not hold as it was written.
SAME = ("links.csv", "bom.csv", "drawing.dxf", "drawing.svg", "workspace.geojson")


# A key of every table that a design keeps.
EVERYTHING = """title = "Sign for the shop"
[copy]
scale = 1.4
rotation_deg = 90
[region]
rectangle_mm = {at = [60, -5], size = [10, 10]}
[links]
width_mm = 12
hardware = "M4 bolt"
[cutting]
process = "laser"
[tool]
cutter_radius_mm = 2
[table]
rectangle_mm = [-400, -400, 800, 800]
[[bodies]]
name = "router"
at = "pen"
circle_mm = {centre = [0, 0], radius = 5}
layers = [3, 4]
[[obstacles]]
name = "clamp"
rectangle_mm = [150, 150, 20, 20]
"""


class Case(program.Case):
    def made(self, text=TEN_LINES, command="synthesize"):
        spec = self.scratch / "spec.toml"
        spec.write_text(text)
        out = self.scratch / "made"
        run = kempe(command, spec, "-o", out)
        self.assertEqual(run.returncode, 0, run.stderr)
        return out

    def assertNothingWritten(self, folder):
        self.assertFalse(folder.exists(), list(folder.iterdir()) if folder.exists() else None)


class Restored(Case):
    def test_a_design_gives_back_its_folder(self):
        for text, command in ((TEN_LINES, "synthesize"), (POLE_IN_HOLE, "workspace"),
                              (EVERYTHING, "synthesize"),
                              (EVERYTHING.replace('"M4 bolt"', '{default = "M4 bolt", V = "4 mm dowel and bush", C = "M3 bolt"}'), "synthesize"),
                              (TEN_LINES + "[objective]\nmaximize = 'transmission'\n[tolerance]\nplay_mm = 0.1\n", "synthesize")):
            made, again = self.made(text, command), self.scratch / "again"
            run = kempe("report", made / "design.json", "-o", again)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertLessEqual(FILES, {p.name for p in again.iterdir()})
            for name in SAME:
                self.assertEqual((again / name).read_bytes(), (made / name).read_bytes(), name)
            for part in (made / "parts").glob("*.*"):
                if part.suffix != ".step":
                    self.assertEqual((again / "parts" / part.name).read_bytes(), part.read_bytes(), part.name)
            before, after = (json.loads((folder / "design.json").read_text()) for folder in (made, again))
            self.assertEqual(after["search"], before["search"])
            measured = {"quality", "workspace", "verification"}  # anew, to their tolerances
            self.assertEqual({key: after[key] for key in after if key not in measured},
                             {key: before[key] for key in before if key not in measured})
            self.assertEqual(kempe("verify", again / "design.json").returncode, 0)
            self.assertIn("</html>", (again / "report.html").read_text())

    def test_holes_and_screws_are_each_joints_own(self):
        hardware = {"default": "M4 bolt", "V": "608 bearing", "C": "M3 bolt", "A": "6 mm dowel and bush"}
        named = ", ".join(f'{joint} = "{name}"' for joint, name in hardware.items())
        text = TEN_LINES.replace("width_mm = 6\npin_diameter_mm = 3", f"width_mm = 30\nthickness_mm = 7\nlongest_mm = 900\nhardware = {{{named}}}")
        made = self.made(text.replace("at = [60, -5]", "at = [260, -5]") + "[cutting]\nhole_fit_mm = 0.2\n")
        design = json.loads((made / "design.json").read_text())
        self.assertEqual(design["mechanism"]["hardware"], hardware)
        self.assertEqual(design["mechanism"]["pin_diameter_mm"], 8)
        wide = {"V": 22, "A": 8, "B": 4.2, "C": 3.2, "X": 4.2, "Y": 4.2}
        for link in ("VA", "VB", "ACX", "BCY"):
            lines = [line.strip() for line in (made / "parts" / f"{link}.dxf").read_text().splitlines()]
            circles = [i for i in range(0, len(lines) - 1, 2) if (lines[i], lines[i + 1]) == ("0", "CIRCLE")]
            found = []
            for i in circles:
                end = next(j for j in range(i + 2, len(lines), 2) if lines[j] == "0")
                found.append(round(2 * next(float(lines[j + 1]) for j in range(i + 2, end, 2) if lines[j] == "40"), 6))
            self.assertEqual(sorted(found), sorted(wide[joint] for joint in link), link)
        bill = {row["name"]: int(row["quantity"]) for row in csv.DictReader((made / "bom.csv").read_text().splitlines())}
        self.assertEqual(bill["bearing 608 8 x 22 x 7"], 2)
        self.assertEqual(bill["bush ISO 3547 6 x 8"], 2)
        self.assertEqual(sorted(name.split(" x ")[0] for name in bill if name.startswith(("screw", "parallel"))),
                         ["parallel pin ISO 8734 6", "screw ISO 4762 M3", "screw ISO 4762 M4"])
        self.assertEqual((bill["nut ISO 4032 M3"], bill["nut ISO 4032 M4"]), (1, 1))
        self.assertEqual(kempe("verify", made / "design.json").returncode, 0)
        check = subprocess.run([sys.executable, SOURCE / "proof" / "kempe_check.py", made / "design.json"], capture_output=True, text=True)
        self.assertEqual(check.returncode, 0, check.stdout)
        # Of designs that thinner pins and smaller holes would allow nothing is proven: no bound, no proof that there is none.
        self.assertIsNone(design["quality"]["lower_bound"])
        spec = self.scratch / "spec.toml"
        spec.write_text(spec.read_text().replace("[links]", "[links]\nVA_mm = 20"))
        run = kempe("synthesize", spec, "-o", self.scratch / "none", "--json")
        self.assertEqual(run.returncode, 6, run.stderr)
        self.assertIs(json.loads(run.stdout)["proven"], False)
        self.assertNotIn("no design exists", run.stderr)
        # A thicker pin than contact is stated for is told.
        design["mechanism"]["hardware"]["B"] = "M12 bolt"
        lie = self.scratch / "thick.json"
        lie.write_text(json.dumps(design))
        run = kempe("verify", lie)
        self.assertEqual(run.returncode, 4)
        self.assertIn("a pin of 12 mm", run.stdout + run.stderr)

    def test_words_and_json_are_those_of_synthesize(self):
        made = self.made()
        words = kempe("report", made / "design.json", "-o", self.scratch / "one").stdout
        for line in ("copy ", "lengths", "size ", "verified ", "written "):
            self.assertIn("\n" + line if line != "copy " else line, words)
        told = json.loads(kempe("report", made / "design.json", "-o", self.scratch / "two", "--json").stdout)
        self.assertIn("report.html", told["files"])
        self.assertEqual(told["mechanism"]["vertex"], json.loads((made / "design.json").read_text())["mechanism"]["vertex"])

    def boasting(self, text, share):
        """What comes of a design whose file claims a bound at this share of its value."""
        design = json.loads((self.made(text) / "design.json").read_text())
        design["quality"]["lower_bound"] = design["search"]["value"] * share
        file = self.scratch / "boast.json"
        file.write_text(json.dumps(design))
        run = kempe("report", file, "-o", self.scratch / "out", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def test_a_bound_that_is_proven_anew_comes_with_its_log(self):
        told = self.boasting(TEN_LINES, 0.99)
        self.assertLessEqual(told["quality"]["lower_bound"], 0.99 * told["search"]["value"] * (1 + 1e-12))
        self.assertIn("certificate.jsonl", told["files"])
        out = self.scratch / "out"
        check = subprocess.run([sys.executable, SOURCE / "proof" / "kempe_check.py", out / "design.json", out / "certificate.jsonl"],
                               capture_output=True, text=True)
        self.assertEqual(check.returncode, 0, check.stdout)

    def test_a_bound_without_a_proof_is_left_out(self):
        told = self.boasting(TEN_LINES + "[objective]\nminimize = 'footprint'\n", 0.99)
        self.assertIsNone(told["quality"]["lower_bound"])
        self.assertTrue(any("no log proves it" in sentence for sentence in told["left_out"]), told["left_out"])
        self.assertNotIn("certificate.jsonl", told["files"])


class Told(Case):
    def made_and_said(self, text):
        """What the program says of a design, whose folder is `made`."""
        spec = self.scratch / "spec.toml"
        spec.write_text(text)
        run = kempe("synthesize", spec, "-o", self.scratch / "made")
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def test_where_layer_1_stands(self):
        text = TEN_LINES.replace("width_mm = 6\npin_diameter_mm = 3", "width_mm = 30\nthickness_mm = 7\nlongest_mm = 900")
        text = text.replace("at = [60, -5]", "at = [260, -5]")
        for hardware, raised in (('"6 mm dowel"', False), ('"M6 bolt"', True)):
            said = self.made_and_said(text + f"hardware = {hardware}\n")
            page = (self.scratch / "made" / "report.html").read_text()
            words = r"ayer 1 stands [0-9.]+ mm above the table, for the heads under it" if raised else "ayer 1 lies next to the table"
            for told in (said, page):
                self.assertRegex(told, words)
                self.assertEqual("next to the table" in told, not raised)

    def test_links_that_cannot_be_cut_are_nothing_to_work_from(self):
        text = TEN_LINES.replace("pin_diameter_mm = 3", "pin_diameter_mm = 6") + "[cutting]\nhole_fit_mm = 0.2\n"
        self.made_and_said(text)
        page = (self.scratch / "made" / "report.html").read_text()
        self.assertIn("cannot be cut as they are", page)
        self.assertNotIn("To work from", page)


class Hostile(Case):
    def test_of_a_design_that_lies_nothing_is_written(self):
        made = self.made()
        good = json.loads((made / "design.json").read_text())

        def lies():
            for path, value in ((("mechanism", "lengths_mm", "VA"), 1.01), (("quality", "size_mm"), 0.5),
                                (("limits", "transmission_deg"), 2), (("workspace", "collision_free_mm2"), 3),
                                (("mechanism", "pole_position_mm", 0), None), (("links", "longest_mm"), 0.01)):
                lie = copy.deepcopy(good)
                place = lie
                for key in path[:-1]:
                    place = place[key]
                place[path[-1]] = place[path[-1]] * value if value is not None else 3.0
                yield path, lie

        for path, lie in lies():
            file, out = self.scratch / "lie.json", self.scratch / "out"
            file.write_text(json.dumps(lie))
            run = kempe("report", file, "-o", out)
            self.assertIn(run.returncode, (2, 4), f"{path}: {run.stderr}")
            self.assertIn("lie.json", run.stderr)
            self.assertNothingWritten(out)

    def test_files_that_are_none(self):
        design = (self.made() / "design.json").read_text()
        out, file = self.scratch / "out", self.scratch / "odd.json"
        chance = random.Random(22)
        odd = ["", "{", "[]", "null", "{}", design[:2000], TEN_LINES, design.replace("kempe-design/1", "kempe-design/9"),
               re.sub(r'"VA": [0-9.]+', '"VA": 1e400', design), "\0" * 100, "[" * 100000]
        for _ in range(60):  # one byte of another value, often still JSON
            place = chance.randrange(len(design))
            odd.append(design[:place] + chance.choice('0123456789-.,:[]{}"enx') + design[place + 1:])
        for text in odd:
            file.write_text(text)
            run = kempe("report", file, "-o", out)
            self.assertIn(run.returncode, (0, 2, 4), f"{text[:80]!r}: {run.stderr}")
            if run.returncode == 0:  # a digit that no check can see, such as one of the seed
                for path in sorted(out.rglob("*"), reverse=True):
                    path.rmdir() if path.is_dir() else path.unlink()
                out.rmdir()
            self.assertNothingWritten(out)

    def test_every_fault_is_told_at_once(self):
        design = json.loads((self.made() / "design.json").read_text())
        design["copy"]["scale"] = -1
        del design["mechanism"]["thickness_mm"]
        design["quality"]["size_mm"] = "large"
        design["limits"]["clearance_mm"] = None
        file = self.scratch / "many.json"
        file.write_text(json.dumps(design))
        run = kempe("report", file, "-o", self.scratch / "out", "--json")
        self.assertEqual(run.returncode, 2)
        keys = [fault["key"] for fault in json.loads(run.stdout)["error"]["faults"]]
        self.assertEqual(keys, ["copy.scale", "mechanism.thickness_mm", "quality.size_mm", "limits.clearance_mm"])
        self.assertEqual(kempe("verify", file, "--json").stdout, run.stdout)

    def test_a_name_in_a_design_stays_text(self):
        text = TEN_LINES + '[[obstacles]]\nname = "<script>alert(1)</script>"\nrectangle_mm = [400, 400, 9, 9]\n'
        made, out = self.made(text), self.scratch / "out"
        self.assertEqual(kempe("report", made / "design.json", "-o", out).returncode, 0)
        self.assertNotIn("<script>alert(1)", (out / "report.html").read_text())

    def test_the_input_is_not_overwritten(self):
        made = self.made()
        run = kempe("report", made / "design.json", "-o", made)
        self.assertEqual(run.returncode, 2)
        self.assertIn("an output that is the input", run.stderr)


class Front(Case):
    def test_every_point_has_a_report_that_the_page_leads_to(self):
        out = self.scratch / "front"
        spec = self.scratch / "spec.toml"
        spec.write_text(TEN_LINES)
        run = kempe("pareto", spec, "--between", "size,transmission", "--points", "4", "-o", out)
        self.assertEqual(run.returncode, 0, run.stderr)
        points = [line.split(",")[0] for line in (out / "front.csv").read_text().splitlines()[1:]]
        page = (out / "report.html").read_text()
        self.assertLess(page.index('id="pareto"'), page.index('id="map"'))  # the front first
        for point in points:
            self.assertIn(f'<a href="{point}/report.html">', page)
            self.assertLessEqual(FILES, {p.name for p in (out / point).iterdir()})
            self.assertEqual(kempe("verify", out / point / "design.json").returncode, 0)
        again = self.scratch / "again"
        self.assertEqual(kempe("report", out / points[-1] / "design.json", "-o", again).returncode, 0)
        self.assertEqual((again / "drawing.dxf").read_bytes(), (out / points[-1] / "drawing.dxf").read_bytes())

    def test_a_front_with_fewer_points_than_asked_says_why(self):
        spec = self.scratch / "grid.toml"
        spec.write_text(TEN_LINES.replace("[links]", "[links]\ngrid_mm = 20"))
        run = kempe("pareto", spec, "--between", "size,transmission", "--points", "9", "-o", self.scratch / "few")
        self.assertEqual(run.returncode, 0, run.stderr)
        found = len((self.scratch / "few/front.csv").read_text().splitlines()) - 1
        self.assertLess(found, 9)
        self.assertIn(f"9 searches gave {found} different design{'' if found == 1 else 's'} that", run.stdout)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
