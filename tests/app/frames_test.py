#!/usr/bin/env python3
"""The same job in other frames and sizes, next to straight plates, without a transmission limit, without a region.

usage: frames_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import json
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from program import Case, kempe

JOB = """
[copy]
scale = {scale}
rotation_deg = {rotation}
[region]
polygon_mm = [{region}]
[pole]
at_mm = [{x}, {y}]
[links]
width_mm = {width}
pin_diameter_mm = {pin}
thickness_mm = {thickness}
shortest_mm = {shortest}
longest_mm = {longest}
[limits]
clearance_mm = {clearance}
transmission_deg = {transmission}
[[obstacles]]
polygon_mm = [{obstacle}]
layers = [1, 1]
"""

REGION = [(62, -5), (70, -5), (70, 5), (62, 5)]
OBSTACLE = [(90, 60), (110, 60), (110, 75)]

DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm" viewBox="0 0 10 10">
<path d="M1 1 L9 1 L9 9 Z" fill="none" stroke="black"/></svg>"""


def job(size=1, at=(0, 0), scale=1.4, rotation=90, transmission=30):
    place = lambda corners: ", ".join(f"[{size * x + at[0]!r}, {size * y + at[1]!r}]" for x, y in corners)
    return JOB.format(scale=scale, rotation=repr(rotation), transmission=transmission, x=at[0], y=at[1],
                      region=place(REGION), obstacle=place(OBSTACLE), width=6 * size, pin=3 * size,
                      thickness=4 * size, shortest=15 * size, longest=400 * size, clearance=0.5 * size)


class Frames(Case):
    def design(self, text, command="synthesize"):
        spec, out = self.scratch / "spec.toml", self.scratch / "out"
        spec.write_text(text)
        run = kempe(command, spec, "-o", out, "--quiet")
        self.assertEqual(run.returncode, 0, run.stderr)
        checked = kempe("verify", out / "design.json", "--json")
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        self.assertTrue(json.loads(checked.stdout)["certified"])
        return json.loads((out / "design.json").read_text()), json.loads(checked.stdout)

    def trace(self, *where):
        drawing = self.scratch / "drawing.svg"
        drawing.write_text(DRAWING)
        run = kempe("trace", self.scratch / "out" / "design.json", drawing, "-o", self.scratch / "copy.svg",
                         *where, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def test_the_same_design_wherever_the_table_begins(self):
        here, _ = self.design(job())
        for at in [(2e6, -3e6), (-9.9e6, 9.9e6), (123456.0, 0.0)]:
            there, _ = self.design(job(at=at))
            self.assertAlmostEqual(there["quality"]["size_mm"], here["quality"]["size_mm"], delta=1e-6)
            for name, length in here["mechanism"]["lengths_mm"].items():
                self.assertAlmostEqual(there["mechanism"]["lengths_mm"][name], length, delta=1e-5, msg=name)
            self.assertEqual(there["mechanism"]["pole_position_mm"], list(at))
            self.assertLess(self.trace("--fit")["departure_max_mm"], 1e-8)

    def test_the_same_design_at_every_size(self):
        here, _ = self.design(job())
        for exponent in (-6, -5, -3, -1, 1, 2):
            size = 10.0 ** exponent
            there, _ = self.design(job(size=size))
            for figure, power in (("size_mm", 1), ("transmission_min_deg", 0), ("footprint_mm2", 2), ("lower_bound", 1)):
                self.assertAlmostEqual(there["quality"][figure] / size ** power / here["quality"][figure], 1, delta=1e-6,
                                       msg=f"{figure} at {size}")
            self.assertEqual(self.trace("--fit")["left_out"], 0)

    def test_what_is_too_large_is_refused_with_the_limit(self):
        spec = self.scratch / "spec.toml"
        spec.write_text(job(size=1000))
        run = kempe("synthesize", spec, "-o", self.scratch / "out")
        self.assertEqual(run.returncode, 2)
        self.assertIn("links.width_mm", run.stderr)
        self.assertIn("<= 1000 mm", run.stderr)

    def test_rotations_next_to_straight(self):
        straight = {turn: self.design(job(rotation=turn))[0]["quality"]["size_mm"] for turn in (0, 180)}
        for rotation in (179.99999, 180.0000001, -1e-5, 1e-9, 179.999999999, 180.001, -0.01):
            found, _ = self.design(job(rotation=rotation))
            near = straight[0 if abs(rotation) < 1 else 180]
            self.assertAlmostEqual(found["quality"]["size_mm"] / near, 1, delta=5e-3, msg=rotation)
            self.assertLess(found["verification"]["copy_error_max_mm"], 1e-9)

    def test_no_transmission_limit(self):
        for scale, rotation in ((1.4, 90), (4, -60), (0.5, 180)):
            found, _ = self.design(job(scale=scale, rotation=rotation, transmission=0))
            self.assertGreater(found["quality"]["transmission_min_deg"], 0.000999)
            self.assertGreaterEqual(found["quality"]["size_mm"], found["quality"]["lower_bound"])

    def test_a_mechanism_without_a_region(self):
        text = job(transmission=15)
        text = text[:text.index("[region]")] + text[text.index("[pole]"):]
        given = "[mechanism]\nvertex = \"tracer\"\nVA_mm = 56.8\nVB_mm = 25.8\nassembly = {}\n"
        for assembly in (0, 3):
            found, checked = self.design(text + given.format(assembly), "workspace")
            self.assertEqual(found["region"]["coordinates"], [])
            self.assertEqual(found["verification"]["driven_over"], "workspace")
            self.assertEqual(checked["driven_over"], "workspace")
            self.assertGreater(checked["samples"], 100)
            self.assertGreater(found["workspace"]["collision_free_mm2"], 0)
            self.assertGreaterEqual(found["quality"]["transmission_min_deg"], 15 - 1e-6)
            for absent in ("clearance_min_mm", "footprint_mm2"):
                self.assertIsNone(found["quality"][absent])
            features = json.loads((self.scratch / "out" / "workspace.geojson").read_text())["features"]
            by_layer = {feature["properties"]["layer"]: feature for feature in features}
            self.assertEqual(by_layer["region"]["geometry"]["coordinates"], [])
            self.assertTrue(by_layer["collision_free"]["geometry"]["coordinates"])
            page = (self.scratch / "out" / "report.html").read_text()
            self.assertIn("no region given", page)
            self.assertNotIn("Region to trace", page)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
