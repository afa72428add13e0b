"""Loads from the spec to the file, its check and its report: what is stated, what is found out, what a person reads."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
TASK = """[copy]
scale = 1.4
rotation_deg = 90
[region]
polygon_mm = [[62, -5], [70, -5], [70, 5], [62, 5]]
[links]
width_mm = 6
thickness_mm = 2
pin_diameter_mm = 3
[tolerance]
length_mm = 0.05
play_mm = 0.02
"""
LOADED = TASK + '[material]\nname = "steel"\n[load]\npen_N = 10\n'


def kempe(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def beyond(said):
    """mm, what pins and layers add to the load error of the links, as the summary's budget has it."""
    line = next(line for line in said.splitlines() if line.startswith("budget"))
    return sum(float(size) for size in re.findall(r" (?:pins|layers) ([0-9.e+-]+)", line))


class Loads(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.here = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def design(self, text, name="design"):
        spec = self.here / "spec.toml"
        spec.write_text(text)
        done = kempe("synthesize", spec, "-o", self.here / name)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, json.loads((self.here / name / "design.json").read_text())

    def written(self, stated):
        file = self.here / "changed.json"
        file.write_text(json.dumps(stated))
        return file

    def verify(self, stated):
        return json.loads(kempe("verify", self.written(stated), "--json").stdout)

    def test_under_a_limit_its_figure_is_named_and_that_the_bound_goes_without_it(self):
        with tempfile.TemporaryDirectory() as folder:
            spec, out = pathlib.Path(folder, "limited.toml"), pathlib.Path(folder, "out")
            said = {}
            for limit in ("", "[limits]\nload_error_mm = 0.4567\n"):
                spec.write_text(LOADED + limit)
                run = kempe("synthesize", spec, "-o", out)
                self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
                said[bool(limit)] = run.stdout, (out / "report.html").read_text()
            for text in said[False]:
                self.assertNotIn("whatever limits.load_error_mm is", text)
            for text in said[True]:
                self.assertIn(", whatever limits.load_error_mm is", text)
            self.assertRegex(said[True][0], r"mm by the links alone \(limit 0\.4567 mm\), ")
            self.assertRegex(said[True][1], r"limit 0\.4567\smm")

    def test_a_load_changes_no_design(self):
        _, plain = self.design(TASK, "plain")
        said, loaded = self.design(LOADED, "loaded")
        self.assertEqual(plain["mechanism"], loaded["mechanism"])
        self.assertNotIn("load", plain)
        self.assertRegex(said, r"it gives way by 0.6994 mm at worst, with pins and layers\n"
                               r" +and by 0.6929 mm by the links alone, [0-9.e-]+ mm in the stiffest direction\n")
        self.assertAlmostEqual(loaded["quality"]["load_error_max_mm"], 0.69285, delta=1e-4)
        self.assertAlmostEqual(loaded["quality"]["hand_force_max_N"], 14, delta=1e-9)

    def test_wrong_figures_are_found(self):
        _, stated = self.design(LOADED)
        self.assertTrue(self.verify(stated)["certified"])
        for key, share in (("load_error_max_mm", 1.01), ("load_error_min_mm", 3), ("pin_force_max_N", 0.99),
                           ("hand_force_max_N", 1.01), ("stress_max_MPa", 0.9), ("mass_kg", 1.001)):
            wrong = json.loads(json.dumps(stated))
            wrong["quality"][key] *= share
            broken = [one["limit"] for one in self.verify(wrong)["broken"]]
            self.assertEqual(broken, ["quality." + key])
        for key, share in (("load_error_layered_max_mm", 1.001), ("load_rise_max_mm", 0.999)):
            self.assertGreater(stated["quality"][key], 0)
            wrong = json.loads(json.dumps(stated))
            wrong["quality"][key] *= share
            self.assertEqual([one["limit"] for one in self.verify(wrong)["broken"]], ["quality." + key])
            wrong["quality"].pop(key)  # one without the other
            self.assertEqual(kempe("verify", self.written(wrong)).returncode, 2)
        older = json.loads(json.dumps(stated))
        older["quality"].pop("stress_layered_max_MPa")
        self.assertTrue(self.verify(older)["certified"])
        for key in ("load_error_layered_max_mm", "load_rise_max_mm"):
            older["quality"].pop(key)
        self.assertTrue(self.verify(older)["certified"])
        for share in (0.999, 1.001):
            wrong = json.loads(json.dumps(stated))
            wrong["quality"]["stress_layered_max_MPa"] *= share
            self.assertEqual([one["limit"] for one in self.verify(wrong)["broken"]], ["quality.stress_layered_max_MPa"])
        wrong["quality"]["stress_layered_max_MPa"] = stated["quality"]["stress_max_MPa"]  # what links in the plane would bear
        self.assertEqual([one["limit"] for one in self.verify(wrong)["broken"]], ["quality.stress_layered_max_MPa"])
        wide = json.loads(json.dumps(stated))
        wide["mechanism"]["pin_diameter_mm"] = wide["mechanism"]["link_width_mm"]  # holes leave nothing of the links
        broken = [one["limit"] for one in self.verify(wide)["broken"]]
        for key in ("stress_max_MPa", "stress_layered_max_MPa"):
            self.assertIn("quality." + key, broken)
        softer = json.loads(json.dumps(stated))
        softer["material"]["E_GPa"] /= 2
        self.assertIn("quality.load_error_max_mm", [one["limit"] for one in self.verify(softer)["broken"]])
        limited = json.loads(json.dumps(stated))
        limited["limits"]["load_error_mm"] = 0.5
        self.assertIn("limits.load_error_mm", [one["limit"] for one in self.verify(limited)["broken"]])

    def test_two_limits_that_are_both_in_the_way_are_told_with_what_would_do(self):
        spec = self.here / "spec.toml"
        both = "[limits]\nload_error_mm = {}\nsag_mm = {}\n"
        spec.write_text(LOADED + both.format(0.01, 0.01))
        told = kempe("synthesize", spec, "-o", self.here / "none")
        self.assertNotEqual(told.returncode, 0)
        self.assertIn("limits.load_error_mm = 0.01 and limits.sag_mm = 0.01 are both in the way", told.stderr)
        enough = re.search(r"both in the way, ([0-9.]+) and ([0-9.]+) together would do", told.stderr)
        self.design(LOADED + both.format(*enough.groups()))

    def test_the_answer_as_data_has_the_error_budget(self):
        (self.here / "spec.toml").write_text(LOADED)
        answer = json.loads(kempe("synthesize", self.here / "spec.toml", "-o", self.here / "design", "--json").stdout)
        budget, quality = answer["error_budget"], answer["quality"]
        self.assertAlmostEqual(budget["give_mm"], quality["load_error_layered_max_mm"], delta=1e-8 * budget["give_mm"])
        errors = {part["source"]: part["error_mm"] for part in budget["sources"]}
        self.assertAlmostEqual(errors["links"], quality["load_error_max_mm"], delta=1e-8 * errors["links"])
        for in_plane, total in ((True, "in_plane_mm"), (False, "down_mm")):
            parts = [part["error_mm"] for part in budget["sources"] if part["in_plane"] == in_plane]
            self.assertAlmostEqual(budget[total], sum(parts), delta=1e-7 * budget[total])
        for part in budget["sources"]:
            for change in part["would_help"]:
                self.assertLess(change["after_mm"], part["error_mm"])
        for best in budget["would_help_most"].values():
            self.assertLess(best["after_mm"], best["before_mm"])

    def test_the_report_answers(self):
        said, stated = self.design(LOADED + '[limits]\nload_error_mm = 0.4\n[objective]\nminimize = "load_error"\n')
        self.assertIn("none is stated for the load error", said)
        self.assertIsNone(stated["quality"]["lower_bound"])
        self.assertEqual(stated["search"]["value"], stated["quality"]["load_error_max_mm"])
        page = (self.here / "design" / "report.html").read_text()
        for words in ("Will it be stiff enough?", "Yes: ", "8\u00a0×\u00a02\u00a0mm instead of 6\u00a0×\u00a02\u00a0mm", "ream the hole",
                      "In the plane, all together", "Down or up, all together", "Load, pins and layers over the region", "Sag over the region"):
            self.assertIn(words, page)
        narrow = json.loads((self.here / "design" / "design.json").read_text())
        self.assertRegex(said, "budget .* layers [0-9]")
        self.assertRegex(said, " down .* pull [0-9]")
        self.assertIn("Layers: links bent out of the plane", page)
        narrow["limits"]["load_error_mm"] = stated["quality"]["load_error_max_mm"] + 0.9 * beyond(said)
        (self.here / "narrow.json").write_text(json.dumps(narrow))
        self.assertEqual(kempe("report", self.here / "narrow.json", "-o", self.here / "narrow").returncode, 0)
        self.assertIn("By the links alone yes, with pins and layers no: ", (self.here / "narrow" / "report.html").read_text())
        again = kempe("report", self.here / "design" / "design.json", "-o", self.here / "again")
        self.assertEqual(again.returncode, 0, again.stderr)
        back = json.loads((self.here / "again" / "design.json").read_text())
        self.assertEqual(back["quality"], stated["quality"])
        self.assertEqual(back["load"], stated["load"])

    def test_layers_that_cannot_be_stated_are_not_left_out_in_silence(self):
        spec = self.here / "spec.toml"
        # Tracer and pen stand 0.12 mm apart on their link.
        spec.write_text("""[copy]
scale = 1.002
[region]
circle_mm = { centre = [90, 0], radius = 5 }
[mechanism]
vertex = "pole"
VA_mm = 60
VB_mm = 60
assembly = 1
[links]
width_mm = 10
thickness_mm = 3
pin_diameter_mm = 3
[material]
name = "steel"
[load]
pen_N = 1
[limits]
load_error_mm = 1000
""")
        done = kempe("workspace", spec, "-o", self.here / "thin")
        self.assertIn("what the layers add is not stated", done.stdout, done.stderr)
        page = (self.here / "thin" / "report.html").read_text()
        self.assertIn("By links and pins yes; what the layers add is not stated", page)

    def test_a_limit_may_count_pins_and_layers(self):
        wide = LOADED.replace("width_mm = 6\nthickness_mm = 2", "width_mm = 14\nthickness_mm = 6").replace('"steel"', '"PLA"')
        _, free = self.design(wide)
        limit = 0.9 * free["quality"]["load_error_layered_max_mm"]
        said, links = self.design(wide + f"[limits]\nload_error_mm = {limit}\n")
        self.assertIn("limits.load_error_in_all = true counts them", said)
        said, stated = self.design(wide + f"[limits]\nload_error_mm = {limit}\nload_error_in_all = true\n")
        self.assertIs(stated["limits"]["load_error_in_all"], True)
        self.assertLessEqual(stated["quality"]["load_error_layered_max_mm"], limit * (1 + 1e-9))
        self.assertGreater(links["quality"]["load_error_layered_max_mm"], limit)
        self.assertRegex(said, r"mm at worst \(limit [0-9.]+ mm\), with pins and layers\n")
        self.assertNotIn("speaks of the links alone", said)
        self.assertIn("are allowed in all", (self.here / "design" / "report.html").read_text())
        self.assertTrue(self.verify(stated)["certified"])
        stricter = json.loads(json.dumps(stated))  # kept by the links, not in all
        stricter["limits"]["load_error_mm"] = 0.5 * (stated["quality"]["load_error_max_mm"] + stated["quality"]["load_error_layered_max_mm"])
        self.assertEqual([one["limit"] for one in self.verify(stricter)["broken"]], ["limits.load_error_mm"])
        stricter["limits"]["load_error_in_all"] = False
        self.assertTrue(self.verify(stricter)["certified"])
        again = kempe("report", self.here / "design" / "design.json", "-o", self.here / "again")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.here / "again" / "design.json").read_text(), (self.here / "design" / "design.json").read_text())
        spec = self.here / "spec.toml"
        refused = kempe("pareto", spec, "--between", "size,load_error", "-o", self.here / "front")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("limits.load_error_in_all", refused.stderr)

    def test_the_lightest_section_is_taken(self):
        text = LOADED.replace("width_mm = 6\nthickness_mm = 2\n", "sections_mm = [[10, 3], [6, 2], [8, 2]]\n")
        said, stated = self.design(text + '[limits]\nload_error_mm = 0.25\n[objective]\nminimize = "mass"\n')
        self.assertEqual((stated["mechanism"]["link_width_mm"], stated["mechanism"]["thickness_mm"]), (8, 2))
        self.assertEqual(stated["links"]["sections_mm"], [[6, 2], [8, 2], [10, 3]])
        narrow = stated["quality"]["load_error_max_mm"] + beyond(said) > 0.25
        self.assertEqual("speaks of the links alone" in said, narrow)
        self.assertIn("By the links alone yes, with pins and layers no: " if narrow else "Yes: ", (self.here / "design" / "report.html").read_text())
        self.assertIn("of 3 to choose from", said)
        self.assertTrue(self.verify(stated)["certified"])
        other = json.loads(json.dumps(stated))
        other["links"]["sections_mm"] = [[6, 2], [10, 3]]
        self.assertEqual([one["limit"] for one in self.verify(other)["broken"]], ["links.sections_mm"])
        again = kempe("report", self.here / "design" / "design.json", "-o", self.here / "again")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(json.loads((self.here / "again" / "design.json").read_text())["mechanism"], stated["mechanism"])

    def test_fronts_know_loads(self):
        spec = self.here / "spec.toml"
        spec.write_text(LOADED)
        done = kempe("pareto", spec, "--between", "size,load_error", "--points", "3", "-o", self.here / "front")
        self.assertEqual(done.returncode, 0, done.stderr)
        spec.write_text(TASK)
        refused = kempe("pareto", spec, "--between", "size,mass", "-o", self.here / "front2")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("material", refused.stderr)
        spec.write_text(LOADED.replace("width_mm = 6\nthickness_mm = 2\n", "sections_mm = [[6, 2], [10, 3]]\n"))
        done = kempe("pareto", spec, "--between", "mass,load_error", "--points", "3", "-o", self.here / "front3")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split(",") for line in (self.here / "front3" / "front.csv").read_text().splitlines()]
        self.assertEqual(rows[0][-2:], ["width_mm", "thickness_mm"])
        self.assertEqual({row[-2] for row in rows[1:]}, {"6", "10"})
        points = [(float(row[1]), float(row[2])) for row in rows[1:]]
        self.assertEqual(points, sorted(points))
        self.assertEqual([error for _, error in points], sorted((error for _, error in points), reverse=True))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
