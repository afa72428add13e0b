"""The program from outside, for the tests: how it is started, its examples, a small spec, a folder to work in.

A test that takes the program as its first argument says, before anything else of the project:

    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
    from program import kempe
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

KEMPE = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(__file__).resolve().parents[1]
EXAMPLES = SOURCE / "specs" / "examples"
# What every design comes with, beside the parts (docs/commands.md).
FILES = {"design.json", "links.csv", "drawing.dxf", "drawing.svg", "workspace.geojson", "workshop.pdf", "report.html"}
TEN_LINES = """
[copy]
scale = 1.4
rotation_deg = 90
[region]
rectangle_mm = {at = [60, -5], size = [10, 10]}
[links]
width_mm = 6
pin_diameter_mm = 3
"""

# A given mechanism whose pole stands in a hole of its region.
POLE_IN_HOLE = """
[copy]
scale = 1.5
rotation_deg = 90
[region]
polygon_mm = [[-50, -50], [50, -50], [50, 50], [-50, 50]]
holes_mm = [[[-30, -30], [30, -30], [30, 30], [-30, 30]]]
[links]
width_mm = 6
pin_diameter_mm = 3
[mechanism]
vertex = "pole"
VA_mm = 80
VB_mm = 82.5
assembly = 0
layers = [1, 2, 2, 1]
[limits]
transmission_deg = 2
"""


def kempe(*arguments, timeout=600, **options):
    """The program run to its end, its output as text; it may take `timeout` seconds."""
    return subprocess.run([KEMPE, *map(str, arguments)], capture_output=True, text=True, timeout=timeout, **options)


class Case(unittest.TestCase):
    """A test with a folder of its own, which goes with it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)
