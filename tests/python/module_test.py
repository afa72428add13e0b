#!/usr/bin/env python3
"""The module kempe from a user's side: its page, its docstrings, its examples, and what they promise.

usage: module_test.py SOURCE [unittest's arguments]     PYTHONPATH leads to the module
"""
import doctest
import importlib
import os
import pathlib
import pickle
import re
import runpy
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import unittest.mock

import numpy as np

import kempe

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
SMALL = {"copy": 1.4j, "region": {"rectangle_mm": [62, -5, 8, 10]}, "links": {"width_mm": 6, "pin_diameter_mm": 3}}
SPEC = kempe.Spec(**SMALL)
DESIGN = kempe.synthesize(SPEC)


# The tables that have a short form, and what they are without it.
SHORT = {"copy": dict, "region": dict, "pole": dict, "table": dict, "material": dict, "objective": dict, "obstacles": list, "bodies": list}


class Shape:
    """A foreign shape."""

    def __init__(self, kind, coordinates):
        self.__geo_interface__ = {"type": kind, "coordinates": coordinates}


def square(x, y, size):
    return [(x, y), (x + size, y), (x + size, y + size), (x, y + size), (x, y)]


class InAFolder(unittest.TestCase):
    def setUp(self):
        scratch, before = tempfile.TemporaryDirectory(), os.getcwd()
        self.addCleanup(scratch.cleanup)
        self.addCleanup(os.chdir, before)
        os.chdir(scratch.name)


class Page(InAFolder):
    def test_every_program_of_the_page_runs(self):
        text = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
        programs = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        self.assertGreater(len(programs), 3)
        exec("\n".join(programs), {"__name__": "page"})
        self.assertTrue(pathlib.Path("out/plate/report.html").exists())

    def test_docstrings(self):
        for name in ("", "._spec", "._work", "._design", "._calibration", "._linkage", "._generators", "._geometry", "._answers", "._text", "._start", "._program"):
            result = doctest.testmod(importlib.import_module("kempe" + name))
            self.assertEqual(result.failed, 0)

    def test_everything_public_says_what_it_is(self):
        for name in kempe.__all__:
            thing = getattr(kempe, name)
            self.assertTrue(thing.__doc__, name)
            members = vars(thing).items() if isinstance(thing, type) else ()
            for member, value in members:
                if not member.startswith("_") and (callable(value) or isinstance(value, (property, classmethod))):
                    self.assertTrue(value.__doc__, f"{name}.{member}")

    def test_examples(self):
        examples = sorted((SOURCE / "examples" / "python").glob("*.py"))
        self.assertTrue(examples)
        for example in examples:
            with self.subTest(example.name), unittest.mock.patch.object(sys, "argv", [str(example)]):
                runpy.run_path(str(example), run_name="__main__")


class Specs(InAFolder):
    def words(self, make):
        with self.assertRaises(kempe.SpecError) as raised:
            make()
        return [(fault.key, fault.found, fault.allowed) for fault in raised.exception.faults]

    def test_faults_have_the_words_of_the_file(self):
        """Each fault of the corpus that TOML can hold, said by keywords."""
        import tomllib
        compared = 0
        for file in sorted((SOURCE / "tests" / "corpus" / "specs").glob("*.toml")):
            try:
                tables = tomllib.loads(file.read_text(encoding="utf-8"))
            except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError):
                continue
            if any(not isinstance(tables.get(name, kind()), kind) for name, kind in SHORT.items()) or file.stem == "nested-keys":
                continue  # in the file a fault, by keywords a short form; a key of more parts than Python can nest
            try:
                kempe.Spec.from_toml(file.read_text(encoding="utf-8"), SOURCE / "tests" / "corpus" / "specs")
            except kempe.SpecError as in_file:
                if "file" in tables.get("region", {}) or any("=" in fault.allowed and "kempe " in fault.allowed for fault in in_file.faults):
                    continue
                expected = sorted((fault.key, fault.found, fault.allowed) for fault in in_file.faults)
                with self.subTest(file.name):
                    self.assertEqual(sorted(self.words(lambda: kempe.Spec(**tables))), expected)
                    self.assertTrue(all(fault.file is None for fault in in_file.faults))
                compared += 1
        self.assertGreater(compared, 30)

    def test_files(self):
        for file in sorted((SOURCE / "specs" / "examples").glob("*.toml")):
            spec = kempe.load(file)
            self.assertEqual(spec, kempe.Spec.from_toml(file.read_text(encoding="utf-8"), file.parent))
            self.assertEqual(spec, kempe.Spec.from_toml(spec.to_toml()))
            self.assertEqual(spec, pickle.loads(pickle.dumps(spec)))
            self.assertEqual(spec, spec.replace())
            self.assertEqual(hash(spec), hash(spec.replace()))
        with self.assertRaises(kempe.SpecError) as raised:
            kempe.load(SOURCE / "tests" / "corpus" / "specs" / "links-width-negative.toml")
        self.assertEqual(raised.exception.faults[0].line, 8)
        self.assertEqual(pickle.loads(pickle.dumps(raised.exception)).faults, raised.exception.faults)

    def test_short_forms_say_the_same(self):
        corners = square(62, -5, 8)[:-1]
        whole = kempe.Spec(copy={"scale": 2, "rotation_deg": 90}, region={"polygon_mm": corners}, pole={"at_mm": [3, 4]},
                           objective={"maximize": "transmission"}, material={"name": "steel"},
                           obstacles=[{"polygon_mm": square(200, 0, 5)[:-1]}])
        for ratio in (2j, np.complex128(2j), 2 * np.exp(0.5j * np.pi).imag * 1j):
            for region in (corners, np.array(corners), np.array(corners) @ [1, 1j], Shape("Polygon", [square(62, -5, 8)]),
                           {"type": "Polygon", "coordinates": [square(62, -5, 8)]}):
                for pole in ((3, 4), 3 + 4j, np.array([3, 4]), Shape("Point", (3, 4))):
                    short = kempe.Spec(copy=ratio, region=region, pole=pole, objective="transmission", material="steel",
                                       obstacles=Shape("Polygon", [square(200, 0, 5)]))
                    self.assertEqual(short, whole)
        inches = kempe.Spec(units="in", copy=2, region=np.array(square(1, 1, 2)[:-1]))
        self.assertAlmostEqual(inches.region.area, 4 * 25.4**2)

    def test_replace(self):
        spec = kempe.Spec(**SMALL, pole=(1, 2), limits={"clearance_mm": 1})
        other = spec.replace(region={"circle_mm": [80, 0, 5]}, pole={"within_mm": square(0, 0, 9)[:-1]}, objective="transmission",
                             limits={"transmission_deg": 20}, copy={"scale": 2})
        self.assertEqual(other, kempe.Spec(copy=2j, links=SMALL["links"], region={"circle_mm": [80, 0, 5]}, objective="transmission",
                                           pole=Shape("Polygon", [square(0, 0, 9)]), limits={"transmission_deg": 20, "clearance_mm": 1}))
        self.assertEqual(spec.replace(limits=None, pole=None), SPEC)
        self.assertEqual(spec.replace(limits={"clearance_mm": None}, pole=(0, 0)), SPEC)

    def test_shapes_with_holes(self):
        holed = Shape("Polygon", [square(50, 0, 20), square(55, 5, 5)])
        self.assertAlmostEqual(kempe.Spec(copy=2, region=holed).region.area, 400 - 25)
        self.assertEqual(kempe.Spec(copy=2, region=kempe.Spec(copy=2, region=holed).region).region.area, 375)
        self.assertEqual(self.words(lambda: kempe.Spec(copy=2, region=[(1, 2), (4, 2), (4, 4)], obstacles=[{"polygon_mm": holed}]))[0][0],
                         "obstacles[0].polygon_mm")
        with self.assertRaisesRegex(ValueError, "in the hole of another"):
            kempe.Spec(copy=2, region=Shape("MultiPolygon", [[square(0, 0, 9), square(2, 2, 5)], [square(3, 3, 1)]]))
        for empty in ({"type": "Polygon", "coordinates": []}, {"type": "Polygon"}, {"type": "Feature", "geometry": None}):
            with self.assertRaisesRegex(kempe.SpecError, "region"):
                kempe.Spec(copy=2, region=empty)
        with self.assertRaisesRegex(ValueError, "LineString has no area"):
            kempe.Spec(copy=2, region=Shape("LineString", [(0, 0), (1, 1)]))

    def test_what_no_file_can_hold(self):
        region = {"circle_mm": [80, 0, 20]}
        self.assertEqual(self.words(lambda: kempe.Spec(copy=2, region=region, title="\ud800"))[0][0], "title")
        self.assertEqual(self.words(lambda: kempe.Spec(copy=2, region=region, limits={"clearance_mm": object})),
                         [("limits.clearance_mm", repr(object), "a number, a text, True or False, or a list of these")])
        self.assertEqual(self.words(lambda: kempe.Spec(copy=2, region=region, limits=7))[0][0], "limits")
        for number in (float("nan"), float("inf"), -float("inf"), 10**400, -(10**400), 10**30):
            self.assertEqual(self.words(lambda: kempe.Spec(copy=2, region=region, limits={"clearance_mm": number}))[0][0],
                             "limits.clearance_mm")
        for title in ('a "quoted" \\ name', "Größe", "#", "a = 1"):
            self.assertEqual(kempe.Spec(copy=2, region=region, title=title).title, title)
        for title in ("two\nlines", "\x7f", "\0"):
            self.assertEqual(self.words(lambda: kempe.Spec(copy=2, region=region, title=title))[0][0], "title")
        self.assertEqual(self.words(lambda: kempe.Spec(**SMALL, **{"a b\n[x]": {"c": 1}}))[0][1], "an unknown table")
        endless = []
        endless.append(endless)
        self.assertEqual(self.words(lambda: kempe.Spec(copy=2, region=endless))[0][1], "lists in lists without end")


class Designs(InAFolder):
    def test_is_a_value(self):
        again = pickle.loads(pickle.dumps(DESIGN))
        self.assertEqual(again, DESIGN)
        self.assertEqual(hash(again), hash(DESIGN))
        self.assertEqual(again.figures, DESIGN.figures)
        self.assertEqual(again.map, DESIGN.map)
        self.assertNotEqual(DESIGN, kempe.synthesize(SPEC.replace(limits={"transmission_deg": 31})))
        self.assertRegex(repr(DESIGN), r"^<kempe.Design: (pole|tracer|pen) at V, VA [0-9.]+, VB [0-9.]+ mm, size 230\.")
        with self.assertRaises(AttributeError):
            DESIGN.size_mm = 3

    def test_figures_are_those_of_the_file(self):
        file = DESIGN.to_dict()
        self.assertEqual(DESIGN.lengths_mm, file["mechanism"]["lengths_mm"])
        self.assertEqual(DESIGN.vertex, file["mechanism"]["vertex"])
        self.assertEqual(DESIGN.assembly, file["mechanism"]["assembly"])
        self.assertEqual(list(DESIGN.pole_mm), file["mechanism"]["pole_position_mm"])
        self.assertEqual(DESIGN.layers, {link["name"]: link["layer"] for link in file["mechanism"]["links"]})
        np.testing.assert_allclose(DESIGN.opening_deg, file["mechanism"]["opening_deg"], rtol=1e-15)
        for name in ("size_mm", "clearance_min_mm", "footprint_mm2", "lower_bound", "copy_error_worst_mm"):
            self.assertEqual(getattr(DESIGN, name), file["quality"][name], name)
        self.assertAlmostEqual(DESIGN.transmission_min_deg, file["quality"]["transmission_min_deg"], 12)
        self.assertEqual(DESIGN.map.free_mm2, file["workspace"]["collision_free_mm2"])
        loaded = kempe.synthesize(SPEC.replace(material="steel", load={"pen_N": 5}))
        for name in ("load_error_max_mm", "load_error_layered_max_mm", "load_rise_max_mm", "stress_max_MPa", "stress_layered_max_MPa",
                     "sag_max_mm", "mass_kg"):
            self.assertEqual(getattr(loaded, name), loaded.to_dict()["quality"][name], name)
            self.assertGreater(getattr(loaded, name), 0, name)
        tilted = kempe.synthesize(SPEC.replace(material="steel", load={"pen_N": 5, "tilt_deg": 60}))
        for name in ("weight_error_max_mm", "weight_error_layered_max_mm", "weight_rise_max_mm"):
            self.assertEqual(getattr(tilted, name), tilted.to_dict()["quality"][name], name)
            self.assertGreater(getattr(tilted, name), 0, name)
            self.assertIsNone(getattr(loaded, name), name)
        budget = loaded.error_budget
        self.assertAlmostEqual(budget["give_mm"], loaded.load_error_layered_max_mm, delta=1e-8 * budget["give_mm"])
        self.assertAlmostEqual(budget["in_plane_mm"], sum(part["error_mm"] for part in budget["sources"] if part["in_plane"]),
                               delta=1e-8 * budget["in_plane_mm"])
        best = budget["would_help_most"]["give"]
        self.assertLess(best["after_mm"], best["before_mm"])
        self.assertIsNone(DESIGN.error_budget)
        feel = tilted.feel
        self.assertLess(0, feel["mass_min_kg"])
        self.assertLessEqual(feel["mass_min_kg"], feel["mass_max_kg"])
        self.assertGreater(feel["hand_max_N"], feel["weight_max_N"])
        self.assertEqual([weight["link"] for weight in feel["counterweights"]][0], "VA")
        self.assertEqual(loaded.feel["weight_max_N"], 0)
        self.assertIsNone(DESIGN.feel)
        self.assertIsNone(DESIGN.load_error_layered_max_mm)
        self.assertIsNone(DESIGN.stress_layered_max_MPa)

    def test_poses(self):
        points = np.random.default_rng(1).uniform(-90, 90, (2000, 2))
        pens, joints = DESIGN.pen(points), DESIGN.joints(points)
        self.assertEqual((pens.shape, joints.shape), ((2000, 2), (2000, 6, 2)))
        there = ~np.isnan(pens[:, 0])
        self.assertTrue(0 < there.sum() < 2000)
        np.testing.assert_allclose(pens[there] @ [1, 1j], 1.4j * (points[there] @ [1, 1j]), atol=1e-9)
        np.testing.assert_array_equal(np.isnan(joints).any(axis=(1, 2)), ~there)
        for (one, other), name in {(0, 1): "VA", (0, 2): "VB", (1, 3): "AC", (3, 5): "CY", (1, 4): "AX"}.items():
            np.testing.assert_allclose(np.linalg.norm(joints[there, one] - joints[there, other], axis=1),
                                       DESIGN.lengths_mm[name], atol=1e-9)
        np.testing.assert_array_equal(DESIGN.pen(points @ [1, 1j]), pens)
        np.testing.assert_array_equal(DESIGN.pen(points[::2]), pens[::2])  # not in one piece
        np.testing.assert_array_equal(DESIGN.pen(points.tolist()), pens)
        self.assertEqual(DESIGN.pen([]).shape, (0, 2))
        self.assertTrue(np.isnan(DESIGN.pen([(np.nan, 0), (np.inf, 1)])).all())
        for wrong in ([1, 2, 3], np.zeros((2, 3)), 5):
            with self.assertRaisesRegex(ValueError, "shape"):
                DESIGN.pen(wrong)
        free = DESIGN.map.is_free(points)
        self.assertEqual(list(free), [bool(DESIGN.map.why(*point)) for point in points])
        self.assertFalse((free & ~there).any())

    def test_map_and_shapes(self):
        free, reach = DESIGN.map.free, DESIGN.map.reachable
        self.assertTrue(0.99 * DESIGN.map.free_mm2 < free.area <= DESIGN.map.free_mm2)
        self.assertTrue(DESIGN.map.reachable_mm2 <= reach.area < 1.01 * DESIGN.map.reachable_mm2)
        rings = free.__geo_interface__["coordinates"][0]
        self.assertEqual(rings[0][0], rings[0][-1])
        self.assertTrue(DESIGN.map.is_free(free.polygons[0][0].mean(axis=0, keepdims=True) * 0 + [66, 0])[0])
        for tolerance in (0, -1, float("nan")):
            with self.assertRaisesRegex(ValueError, "at least 1e-07"):
                DESIGN.map.free_within(tolerance)
        self.assertIn("out of reach", {loss.cause for loss in DESIGN.map.losses})
        self.assertIn("reach", DESIGN.map.why(0, 0).sentence)
        try:
            from shapely.geometry import box, shape
        except ImportError:
            return
        self.assertAlmostEqual(shape(free).area, free.area)
        self.assertEqual(kempe.Spec(**{**SMALL, "region": box(62, -5, 70, 5)}).region.area, 80)

    def test_files(self):
        names = DESIGN.save(pathlib.Path("out"), "a title")
        self.assertEqual(sorted(names), sorted(str(path.relative_to("out")) for path in pathlib.Path("out").rglob("*") if path.is_file()))
        self.assertIn("a title", pathlib.Path("out/report.html").read_text(encoding="utf-8"))
        self.assertEqual(pathlib.Path("out/drawing.svg").read_text(encoding="utf-8"), DESIGN.to_svg())
        self.assertTrue(kempe.verify("out/design.json"))
        again = kempe.Design.load("out/design.json")
        self.assertEqual(again.lengths_mm, DESIGN.lengths_mm)
        self.assertIsNotNone(again.lower_bound)
        pathlib.Path("file").write_text("")
        with self.assertRaises(kempe.NotWritten):
            DESIGN.save("file")

    def test_nobody_is_believed(self):
        file = DESIGN.to_dict()
        pathlib.Path("forged.json").write_text(DESIGN.to_json().replace(f'"size_mm": {file["quality"]["size_mm"]}', '"size_mm": 99.5'))
        found = kempe.verify("forged.json")
        self.assertFalse(found)
        self.assertEqual([broken.limit for broken in found.broken], ["quality.size_mm", "search.value"])
        with self.assertRaisesRegex(kempe.SpecError, "quality.size_mm"):
            kempe.Design.load("forged.json")
        bound = f'"lower_bound": {file["quality"]["lower_bound"]}'
        tight = kempe.Design.from_json(DESIGN.to_json().replace(bound, f'"lower_bound": {DESIGN.size_mm - 1e-9}'))
        self.assertTrue(tight.lower_bound is None or tight.lower_bound < DESIGN.size_mm - 1e-5)  # what was proven anew
        with self.assertRaises(kempe.SpecError):
            kempe.Design.from_json(DESIGN.to_json().replace(bound, '"lower_bound": 231'))
        for text in ("", "{}", "[1]", DESIGN.to_json()[:500]):
            with self.assertRaises(kempe.SpecError):
                kempe.Design.from_json(text)
        with self.assertRaises(FileNotFoundError):
            kempe.Design.load("nothing.json")
        pathlib.Path("bytes.json").write_bytes(b"{\xff\0}")
        with self.assertRaisesRegex(kempe.SpecError, "bytes.json"):
            kempe.Design.load("bytes.json")

    def test_trace(self):
        circle = 66 + 3 * np.exp(1j * np.linspace(0, 2 * np.pi, 90))
        copied = DESIGN.trace([circle, [(66, 0), (300, 0)]])
        self.assertFalse(copied)
        self.assertEqual([line.original for line in copied.missing], [1])
        np.testing.assert_allclose(copied.drawn[0].points @ [1, 1j], 1.4j * circle, atol=1e-9)
        self.assertEqual(copied, pickle.loads(pickle.dumps(copied)))
        with self.assertRaisesRegex(kempe.SpecError, "lines\\[1\\]"):
            DESIGN.trace([[(66, 0)], [(np.nan, 0)]])
        with self.assertRaisesRegex(kempe.SpecError, "step"):
            DESIGN.trace([], step=0)

    def test_traced_lines_of_all_kinds(self):
        self.assertEqual(DESIGN.trace([[]]).poses, DESIGN.trace([]).poses)
        through_the_pole = [(66, 0), (-66, 0)]  # the tracer cannot come to its middle, however long the steps are
        fine, coarse = DESIGN.trace([through_the_pole]), DESIGN.trace([through_the_pole], step=1000)
        self.assertGreater(fine.missing_length_mm, 100)
        self.assertAlmostEqual(fine.missing_length_mm, coarse.missing_length_mm, places=6)
        for line, step in ((through_the_pole, 1e-10), ([(65, 0), (1e300, 0)], 0.5)):
            with self.assertRaisesRegex(kempe.SpecError, "step: found .* poses; allowed: at most 5000000 poses"):
                DESIGN.trace([line], step=step)

    def test_drawings_that_cannot_be_traced(self):
        line = '<svg xmlns="http://www.w3.org/2000/svg" width="8mm" height="6mm" viewBox="0 0 8 6"><path d="M0 6L8 0"/></svg>'
        for key, options in (("material", {"load": True}), ("material", {"forces": True}), ("fit", {"fit": True, "scale": 2}),
                             ("fit", {"fit": True, "at": (1, 2)}), ("scale", {"scale": 0}), ("step_mm", {"step_mm": np.nan}),
                             ("tolerance_mm", {"tolerance_mm": 11}), ("at", {"at": (np.inf, 0)})):
            with self.assertRaises(kempe.SpecError) as raised:
                DESIGN.trace_drawing(svg=line, **options)
            self.assertEqual([fault.key for fault in raised.exception.faults], [key])
        pathlib.Path("empty.svg").write_text(line.replace('<path d="M0 6L8 0"/>', "<text>A</text>"))
        with self.assertRaisesRegex(kempe.SpecError, "empty.svg.*without lines.*1 text"):
            DESIGN.trace_drawing("empty.svg")
        for file in ("nothing.svg", SOURCE / "README.md"):
            with self.assertRaisesRegex(kempe.SpecError, pathlib.Path(file).name):
                DESIGN.trace_drawing(file)
        for wrong in ({}, {"drawing": "empty.svg", "svg": line}, {"svg": line, "instrument": -1}, {"svg": line, "at": (1, 2, 3)}):
            with self.assertRaises(TypeError):
                DESIGN.trace_drawing(**wrong)

    def test_in_a_notebook(self):
        self.assertTrue(DESIGN._repr_svg_().startswith("<?xml") or DESIGN._repr_svg_().startswith("<svg"))
        self.assertRegex(DESIGN._repr_html_(), r'^<iframe srcdoc="&lt;!DOCTYPE html')
        self.assertNotIn("<script", DESIGN._repr_html_())

    def test_plots(self):
        try:
            import matplotlib.pyplot as plt
        except ImportError:
            self.skipTest("Matplotlib is not there")
        axes = DESIGN.plot(at=(66, 2))
        self.assertEqual({text.get_text() for text in axes.texts}, set("VABCXY"))
        self.assertIs(DESIGN.map.plot(plt.subplots()[1]).get_aspect() in ("equal", 1), True)
        axes.figure.savefig("plot.png")
        self.assertGreater(pathlib.Path("plot.png").stat().st_size, 5000)
        with self.assertRaisesRegex(ValueError, "cannot stand"):
            DESIGN.plot(at=(0, 0))
        plt.close("all")


class Searches(InAFolder):
    def test_no_design(self):
        with self.assertRaises(kempe.NoDesign) as raised:
            kempe.synthesize(SPEC.replace(links={"longest_mm": 20}))
        none = pickle.loads(pickle.dumps(raised.exception))
        self.assertTrue(none.proven)
        self.assertEqual([change.key for change in none.relaxations], ["links.longest_mm"])
        self.assertIn("would do", str(none))

    def test_columns(self):
        front = kempe.pareto(SPEC, ("size", "transmission"), points=3)
        self.assertEqual(len({len(column) for column in front.values()}), 1)
        self.assertEqual(front["size"], sorted(front["size"]))
        self.assertEqual(front["transmission"], sorted(front["transmission"]))
        self.assertEqual(front["size"], front["size_mm"])
        np.testing.assert_allclose(front["transmission"], front["transmission_min_deg"], atol=1e-6)
        for between in (("size",), ("size", "size"), ("size", "beauty")):
            with self.assertRaises(ValueError):
                kempe.pareto(SPEC, between)
        with self.assertRaises(kempe.SpecError):
            kempe.pareto(SPEC, ("size", "mass"))
        with self.assertRaises(kempe.NoDesign):
            kempe.pareto(SPEC.replace(links={"longest_mm": 20}), ("size", "transmission"))

    def test_progress_is_told_and_its_exception_ends_the_work(self):
        phases = {}
        kempe.synthesize(SPEC, progress=lambda share, what: phases.setdefault(what, []).append(share))
        self.assertIn("mapping", phases)
        for what, shares in phases.items():
            self.assertTrue(all(0 <= share <= 1 for share in shares), what)
            self.assertEqual(shares, sorted(shares), what)
        self.assertEqual(phases["mapping"][-1], 1)

        def refuse(share, what):
            raise RuntimeError("enough")
        with self.assertRaisesRegex(RuntimeError, "enough"):
            kempe.synthesize(kempe.load(SOURCE / "specs" / "examples" / "nameplate.toml"), progress=refuse)

    def test_other_threads_run_meanwhile(self):
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0.001)
        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        kempe.synthesize(SPEC)
        after = counted[0]
        done.set()
        thread.join()
        self.assertGreater(after, before)

    def test_ctrl_c(self):
        """A search without end is stopped by a signal, soon and with KeyboardInterrupt."""
        program = ("import kempe\nspec = kempe.load(r'%s')\nprint('ready', flush=True)\ntry:\n    while True:\n"
                   "        kempe.synthesize(spec)\nexcept KeyboardInterrupt:\n    print('stopped')\n"
                   % (SOURCE / "specs" / "examples" / "nameplate.toml"))
        with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as running:
            self.assertEqual(running.stdout.readline(), "ready\n")
            time.sleep(0.3)
            running.send_signal(signal.SIGINT)
            told, _ = running.communicate(timeout=60)
        self.assertEqual((told, running.returncode), ("stopped\n", 0))

    def test_wrong_arguments(self):
        for wrong in (lambda: kempe.synthesize("spec.toml"), lambda: kempe.synthesize(SPEC, seed="x"), lambda: kempe.synthesize(SPEC, seed=-1)):
            with self.assertRaises(TypeError):
                wrong()
        with self.assertRaises(ValueError):
            kempe.synthesize(SPEC, map_tolerance=float("nan"))
        for options in ({"map_tolerance": -1}, {"map_tolerance": 5}, {"time_limit": float("nan")}, {"time_limit": -1}):
            with self.assertRaisesRegex(ValueError, f"{next(iter(options))} is .*; found"):
                kempe.synthesize(SPEC, **options)
        with self.assertRaisesRegex(ValueError, "at least 1e-07 mm; found 1e-300"):
            DESIGN.map.free_within(1e-300)
        self.assertIsInstance(kempe.synthesize(SPEC, time_limit=60, threads=0), kempe.Design)
        with self.assertRaises(kempe.Stopped):
            kempe.synthesize(SPEC, time_limit=0)

    def test_calibration(self):
        import tomllib
        folder = SOURCE / "specs" / "examples" / "calibration"
        os.chdir(folder)
        compared = 0
        for file in sorted(folder.glob("*.toml")):
            tables = tomllib.loads(file.read_text(encoding="utf-8"))
            if "reading" not in tables:
                continue
            found = kempe.calibrate(file)
            for reading in found["readings"]:
                self.assertGreater(reading.pop("line"), 1)
            self.assertEqual(found, kempe.calibrate(tables))
            self.assertEqual(found["format"], "kempe-calibration/1")
            compared += 1
        self.assertGreater(compared, 2)
        knight = tomllib.loads((folder / "knight.toml").read_text(encoding="utf-8"))
        with self.assertRaises(kempe.SpecError) as raised:
            kempe.calibrate({**knight, "instrument": {**knight["instrument"], "arm_mm": -1}})
        self.assertEqual([(fault.line, fault.key) for fault in raised.exception.faults], [(None, "instrument.arm_mm")])
        with self.assertRaisesRegex(kempe.SpecError, "nothing.toml"):
            kempe.calibrate("nothing.toml")

    def test_no_mechanism(self):
        with self.assertRaisesRegex(kempe.SpecError, "mechanism"):
            kempe.workspace(SPEC)


if __name__ == "__main__":
    unittest.main()
