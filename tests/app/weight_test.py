"""Sag, balance and feel from the spec to the file, its check and its report; copies of a loaded instrument."""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv[1]
TASK = """[copy]
scale = 0.5
rotation_deg = 180
[region]
polygon_mm = [[60, -10], [90, -10], [90, 10], [60, 10]]
[links]
width_mm = 12
thickness_mm = 4
pin_diameter_mm = 5
[tolerance]
length_mm = 0.05
play_mm = 0.02
[material]
name = "steel"
"""
LOAD = "[load]\npen_N = 10\npen_mass_kg = 0.5\n"
SQUARE = '<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="10mm" viewBox="0 0 20 10"><path d="M2 2H18V8H2Z"/></svg>'


def kempe(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120)


class Weight(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.here = pathlib.Path(self.folder.name)
        (self.here / "square.svg").write_text(SQUARE)

    def tearDown(self):
        self.folder.cleanup()

    def design(self, text, name="design"):
        (self.here / "spec.toml").write_text(text)
        done = kempe("synthesize", self.here / "spec.toml", "-o", self.here / name)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout, json.loads((self.here / name / "design.json").read_text())

    def verified(self, stated):
        file = self.here / "changed.json"
        file.write_text(json.dumps(stated))
        return json.loads(kempe("verify", file, "--json").stdout)

    def test_what_a_tilted_table_adds_is_in_every_figure(self):
        """A router's weight pulls along an upright table: no trace gives way by more, or pulls harder at a pin, than the figures say."""
        load = "[load]\npen_N = 10\npen_mass_kg = 3\n"
        level = self.design(TASK + load)[1]["quality"]
        stated = self.design(TASK + load + "tilt_deg = 90\n")[1]["quality"]
        self.assertGreater(stated["load_error_max_mm"], 1.1 * level["load_error_max_mm"])
        self.assertEqual(stated["hand_force_max_N"], level["hand_force_max_N"])
        loaded = json.loads(self.trace("--load", "--forces", self.here / "forces.csv", "--json").stdout)
        self.assertLessEqual(loaded["departure_max_mm"],
                             (stated["load_error_layered_max_mm"] + stated["weight_error_layered_max_mm"]) * (1 + 1e-9))
        rows = list(csv.DictReader((self.here / "forces.csv").read_text().splitlines()))
        pins = max(float(row[f"pin_{pin}_N"]) for row in rows for pin in "ABCV")
        self.assertLessEqual(pins, stated["pin_force_max_N"] * (1 + 1e-9))
        self.assertGreater(pins, 0.3 * stated["pin_force_max_N"])

    def test_the_links_own_weight_pulls_along_a_tilted_table(self):
        load = "[load]\npen_N = 10\n"
        keys = ("weight_error_max_mm", "weight_error_layered_max_mm", "weight_rise_max_mm")
        said, level = self.design(TASK + load)
        self.assertNotIn("own weight", said)
        self.assertNotIn("own weight", (self.here / "design" / "report.html").read_text())
        tilted = self.design(TASK + load + "tilt_deg = 30\n")[1]
        said, upright = self.design(TASK + load + "tilt_deg = 90\n")
        self.assertRegex(said, r"budget .* own weight [0-9.e-]+")
        self.assertIn("The links' own weight along the table", (self.here / "design" / "report.html").read_text().replace("&#39;", "'"))
        for key in keys:
            self.assertNotIn(key, level["quality"])
            self.assertAlmostEqual(upright["quality"][key], 2 * tilted["quality"][key], delta=1e-6 * upright["quality"][key])
        self.assertGreater(upright["quality"]["weight_error_layered_max_mm"], upright["quality"]["weight_error_max_mm"])
        for key in ("pin_force_max_N", "stress_max_MPa"):
            self.assertGreater(upright["quality"][key], level["quality"][key])
        self.assertEqual(upright["quality"]["load_error_max_mm"], level["quality"]["load_error_max_mm"])
        self.assertTrue(self.verified(upright)["certified"])
        for key in (*keys, "pin_force_max_N", "stress_max_MPa", "stress_layered_max_MPa"):
            for share in (0.999, 1.001):
                wrong = json.loads(json.dumps(upright))
                wrong["quality"][key] *= share
                self.assertEqual([one["limit"] for one in self.verified(wrong)["broken"]], ["quality." + key])
        lighter = json.loads(json.dumps(upright))
        lighter["load"]["tilt_deg"] = 45
        self.assertLessEqual({"quality." + key for key in keys}, {one["limit"] for one in self.verified(lighter)["broken"]})
        silent = json.loads(json.dumps(upright))  # as older files, whose forces and stress lack the weight
        for key in keys:
            silent["quality"].pop(key)
        self.assertIn("quality.pin_force_max_N", [one["limit"] for one in self.verified(silent)["broken"]])
        back = kempe("report", self.here / "design" / "design.json", "-o", self.here / "again")
        self.assertEqual(back.returncode, 0, back.stderr)
        self.assertEqual(json.loads((self.here / "again" / "design.json").read_text())["quality"], upright["quality"])

    def trace(self, *more, design="design"):
        return kempe("trace", self.here / design / "design.json", self.here / "square.svg", "-o", self.here / "copy.svg", "--fit", *more)

    def test_sag_is_stated_and_found_again(self):
        said, stated = self.design(TASK + LOAD)
        self.assertIn("sag ", said)
        self.assertIn("friction adds up to", said)
        self.assertGreater(stated["quality"]["sag_max_mm"], 0)
        self.assertTrue(self.verified(stated)["certified"])
        stated["quality"]["sag_max_mm"] *= 0.9
        self.assertIn("quality.sag_max_mm", [one["limit"] for one in self.verified(stated)["broken"]])
        report = (self.here / "design" / "report.html").read_text()
        self.assertIn("Weight, balance and feel", report)

    def test_what_rests_does_not_sink_and_a_longer_grip_sinks_less(self):
        hanging = self.design(TASK + LOAD)[1]["quality"]["sag_max_mm"]
        gripped = self.design(TASK + LOAD + "grip_mm = 20\n")[1]["quality"]["sag_max_mm"]
        resting = self.design(TASK + LOAD + 'rests = ["tracer", "pen"]\n')[1]["quality"]["sag_max_mm"]
        self.assertLess(gripped, hanging)
        self.assertLess(resting, 1e-9)

    def test_a_limit_is_kept_and_a_broken_one_is_found(self):
        free = self.design(TASK + LOAD)[1]
        limit = 1.5 * free["quality"]["sag_max_mm"]
        kept = self.design(f"[limits]\nsag_mm = {limit}\n" + TASK + LOAD)[1]
        self.assertLessEqual(kept["quality"]["sag_max_mm"], limit)
        kept["limits"]["sag_mm"] = 0.5 * kept["quality"]["sag_max_mm"]
        self.assertIn("limits.sag_mm", [one["limit"] for one in self.verified(kept)["broken"]])

    def test_each_joint_has_its_own_pin(self):
        mixed = self.design(TASK.replace("pin_diameter_mm = 5", 'hardware = {default = "M3 bolt", V = "M8 bolt"}') + LOAD)[1]
        self.assertTrue(self.verified(mixed)["certified"])
        mixed["mechanism"]["hardware"] = "M8 bolt"
        self.assertIn("quality.sag_max_mm", [one["limit"] for one in self.verified(mixed)["broken"]])

    def test_a_limit_without_a_material_is_broken(self):
        stated = self.design("[limits]\nsag_mm = 50\n" + TASK + LOAD)[1]
        del stated["material"], stated["load"]
        for figure in [key for key in stated["quality"] if key.startswith(("sag", "mass", "load", "pin_f", "hand", "stress"))]:
            del stated["quality"][figure]
        said = self.verified(stated)
        self.assertEqual([one["limit"] for one in said["broken"]], ["limits.sag_mm"])
        self.assertFalse(said["certified"])

    def test_an_upright_table_has_its_balance(self):
        said, stated = self.design(TASK + LOAD + "tilt_deg = 90\n")
        self.assertIn("balance ", said)
        self.assertEqual(stated["load"]["tilt_deg"], 90)
        self.assertTrue(self.verified(stated)["certified"])

    def test_on_an_upright_table_nothing_sinks_and_rounding_is_not_told(self):
        spec = TASK + LOAD + 'tilt_deg = 90\nrests = ["pen"]\n'
        said, stated = self.design(spec.replace("[tolerance]\nlength_mm = 0.05\nplay_mm = 0.02\n", ""))
        self.assertEqual(stated["quality"]["sag_max_mm"], 0)
        self.assertIn("sag          none: on an upright table nothing sinks by its weight", said)
        page = (self.here / "design" / "report.html").read_text()
        self.assertNotRegex(page.split("<body>")[1].split("<script")[0], r"\de-1\d")
        self.assertNotIn("<b>Sag</b>: ", page)
        self.assertNotIn("rests on the table, which bears", page)
        self.assertIn("Neither pen nor tracer leaves its plane by weight or play.", page)

    def test_what_the_load_lifts_stands_beside_what_sinks(self):
        self.assertGreater(self.design(TASK + LOAD)[1]["quality"]["load_rise_max_mm"], 0.001)
        page = (self.here / "design" / "report.html").read_text()
        self.assertRegex(page, r"<dt>Lifted or lowered</dt><dd>[0-9.]+\u00a0mm<small>by the load at worst, beside the sag")
        self.assertRegex(page, r"en or tracer sinks by up to <b>[^<]+</b> by weight and play: the spec sets no limit")
        self.assertRegex(page, r"The load lifts or lowers pen or tracer by up to <b>[0-9.]+\u00a0mm</b>")
        self.assertIn("Down or up, all together", page)
        exact = TASK.replace("[tolerance]\nlength_mm = 0.05\nplay_mm = 0.02\n", "")
        upright = self.design(exact + LOAD + "tilt_deg = 90\n")[0]
        self.assertNotIn("and against sinking", upright)
        self.assertRegex(upright, "at right angles to the table .* at worst: pull ")
        self.assertIn("and against what the load lifts or lowers", upright)
        page = (self.here / "design" / "report.html").read_text()
        self.assertIn(" against what the load lifts or lowers: ", page)
        self.assertNotIn("against sinking", page)

    def test_the_answer_as_data_has_how_it_feels(self):
        (self.here / "spec.toml").write_text(TASK + LOAD + "tilt_deg = 90\n")
        answer = subprocess.run([PROGRAM, "synthesize", self.here / "spec.toml", "-o", self.here / "design", "--json"],
                                capture_output=True, text=True, check=True).stdout
        feel = json.loads(answer)["feel"]
        said = subprocess.run([PROGRAM, "synthesize", self.here / "spec.toml", "-o", self.here / "design"],
                              capture_output=True, text=True, check=True).stdout
        self.assertIn(f"holds up to {feel['weight_max_N']:.3g} N of weight", said)
        for weight in feel["counterweights"]:
            self.assertIn(f"{weight['mass_kg']:.3g} kg on {weight['link']}, {weight['arm_mm']:.4g} mm from {weight['from']}", said)
        for spring in feel["springs"]:
            self.assertIn(f"{spring['rate_N_mm']:.3g} N/mm from {spring['height_mm']:.4g} mm uphill", said)

    def test_a_loaded_instrument_draws_beside_the_drawn_one(self):
        self.design(TASK + LOAD)
        plain = json.loads(self.trace("--json").stdout)
        loaded = json.loads(self.trace("--load", "--forces", self.here / "forces.csv", "--json").stdout)
        self.assertLess(plain["departure_max_mm"], 1e-9)
        self.assertGreater(loaded["departure_max_mm"], 1e-5)
        with open(self.here / "forces.csv", newline="") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        self.assertGreater(len(rows), 50)
        for row in rows:
            # Without friction and on a level table the hand holds |k| of the drag; friction adds along the motion.
            self.assertAlmostEqual(row["hand_N"], 0.5 * 10 + row["friction_N"], delta=1e-9)
            self.assertAlmostEqual(row["pole_N"], 1.5 * 10, delta=1e-9)
        most = max(math.hypot(row["give_x_mm"], row["give_y_mm"]) for row in rows)
        self.assertAlmostEqual(loaded["departure_max_mm"], most, delta=0.05 * most)
        copy = (self.here / "copy.svg").read_text()
        self.assertIn("hand 5", copy)

    def test_a_design_without_a_load_cannot_tell(self):
        self.design(TASK)
        done = self.trace("--load")
        self.assertEqual(done.returncode, 2)
        self.assertIn("load", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
