#!/usr/bin/env python3
"""What the program designs the independent checker proves: tasks with what the shipped examples lack (certificates_test.py has
those). A clearance two micrometres larger than the design's own it does not.

usage: designs_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

KEMPE = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
CHECKER = SOURCE / "proof" / "kempe_check.py"

SPECS = {
    "islands, a hole, triangles, a concave obstacle": """
[copy]
scale = 0.8
rotation_deg = 37
[region]
polygon_mm = [[[60, -20], [75, -20], [75, 20], [60, 20]], [[60, 30], [70, 30], [65, 40]]]
holes_mm = [[[64, -4], [70, -4], [67, 4]]]
[links]
width_mm = 6
pin_diameter_mm = 3
plate = "triangle"
[[obstacles]]
polygon_mm = [[90, -60], [120, -60], [120, 60], [90, 60], [90, 50], [110, 50], [110, -50], [90, -50]]
""",
    "three layers beside a low clamp, a region that is not convex": """
[copy]
scale = 0.5
rotation_deg = 200
[region]
polygon_mm = [[100, -40], [160, -40], [160, 40], [130, 40], [130, 0], [100, 0]]
[links]
layers = 3
[[obstacles]]
polygon_mm = [[-110, -20], [-100, -20], [-100, 0], [-110, 0]]
layers = [1, 1]
""",
    "pen at the vertex, a free pole, a grid of lengths": """
[copy]
scale = 2.5
rotation_deg = 0
[region]
circle_mm = {centre = [0, 0], radius = 20}
[pole]
within_mm = [[-80, -80], [80, -80], [80, -60], [-80, -60]]
[links]
grid_mm = 5
[objective]
groundings = ["pen"]
""",
}


def designed(spec, folder):
    made = subprocess.run([KEMPE, "synthesize", spec, "-o", folder], capture_output=True, text=True)
    assert made.returncode == 0, made.stdout + made.stderr
    return pathlib.Path(folder) / "design.json"


def check(*files):
    return subprocess.run([sys.executable, CHECKER, *files], capture_output=True, text=True)


class Designs(unittest.TestCase):
    def proven(self, spec):
        with tempfile.TemporaryDirectory() as folder:
            file = designed(spec, folder)
            found = check(file)
            design = json.loads(file.read_text(encoding="utf-8"))
            claims = 3 + bool((design["tolerance"] or {}).get("robust"))
            self.assertEqual((found.returncode, found.stdout.count(": proven")), (0, claims), found.stdout + found.stderr)
            design["limits"]["clearance_mm"] = design["quality"]["clearance_min_mm"] + 0.002
            file.write_text(json.dumps(design), encoding="utf-8")
            found = check(file)
            self.assertEqual(found.returncode, 1, found.stdout + found.stderr)
            self.assertRegex(found.stdout, "2 the parts keep their clearance: (refuted|not proven)")

    def test_what_the_examples_lack(self):
        for name, text in SPECS.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                spec = pathlib.Path(folder) / "spec.toml"
                spec.write_text(text, encoding="utf-8")
                self.proven(spec)

    def test_a_log_of_a_small_tree(self):
        """The rules close a tree that is built with them."""
        with tempfile.TemporaryDirectory() as folder:
            file, log = designed(SOURCE / "specs" / "examples" / "plagiograph.toml", folder), pathlib.Path(folder) / "certificate.jsonl"
            subprocess.run([sys.executable, SOURCE / "tests" / "proof" / "tree_builder.py", file, log], check=True)
            found = check(file, log)
            self.assertEqual((found.returncode, found.stdout.count(": proven")), (0, 4), found.stdout + found.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
