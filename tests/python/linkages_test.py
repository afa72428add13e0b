#!/usr/bin/env python3
"""Linkages, function generators and inversors in Python: each figure against the program's, and against NumPy's own.

usage: linkages_test.py SOURCE PROGRAM [unittest's arguments]     PYTHONPATH leads to the module
"""
import json
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
import unittest

import numpy as np

import kempe

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
LINKAGES = sorted((SOURCE / "specs" / "examples" / "linkages").glob("*.toml"))
GENERATORS = SOURCE / "specs" / "examples" / "generators"
WATT = SOURCE / "specs" / "examples" / "linkages" / "watt-six-bar.toml"
DIAL = """[function]
expression = "log10(x)"
x = [1, 2]
method = "minimax"
[input]
range_deg = 60
start_deg = 86
[output]
range_deg = 90
start_deg = -19
"""
PRESS = SOURCE / "specs" / "examples" / "linkages" / "shear-press-forces.toml"


def told(*arguments, code=0):
    """What the program prints as JSON."""
    done = subprocess.run([PROGRAM, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True)
    assert done.returncode == code, done.stderr
    return json.loads(done.stdout)


def rows(array):
    """Absent values of the program's table are NaN in Python."""
    return np.array([np.nan if value is None else value for value in array], dtype=float)


class LikeTheProgram(unittest.TestCase):
    """The very numbers that the command prints."""

    def test_solve(self):
        self.assertGreater(len(LINKAGES), 10)
        for file in LINKAGES:
            with self.subTest(file.name):
                linkage = kempe.Linkage.read(file)
                motion, expected = linkage.solve(), told("solve", file, "--velocities", "--accelerations")
                columns = motion.to_columns()
                self.assertEqual(list(columns), expected["columns"])
                for i, name in enumerate(expected["columns"]):
                    np.testing.assert_array_equal(columns[name], rows(row[i] for row in expected["rows"]), name)
                self.assertEqual((linkage.name, linkage.unit), (expected["linkage"], expected["unit"]))
                self.assertEqual(motion.end is None, expected["stop"] is None)
                self.assertEqual(len(motion), linkage.steps + 1)

    def test_arrays_are_the_table_in_millimetres(self):
        for file, in_mm in ((WATT, 1), (PRESS, 1000)):
            motion = kempe.Linkage.read(file).solve(steps=5)
            columns, unit = motion.to_columns(), motion.unit
            for name in ("B", "F" if file == WATT else "P"):
                for axis, letter in enumerate("xy"):
                    for array, column in ((motion.positions, f"{name}_{letter}_{unit}"),
                                          (motion.velocities, f"{name}_v{letter}_{unit}_per_s"),
                                          (motion.accelerations, f"{name}_a{letter}_{unit}_per_s2")):
                        np.testing.assert_allclose(array[name][:, axis], columns[column] * in_mm, rtol=1e-15)
            for name, force in motion.reactions.items():
                np.testing.assert_array_equal(force, np.column_stack([columns[f"{name}_x_N"], columns[f"{name}_y_N"]]))
            self.assertEqual([name for name in columns if name.endswith(("_N", "_N_m"))], list(motion.forces))
        self.assertIn("rocker_angle_deg", kempe.Linkage.read(WATT).solve(steps=2).to_columns())

    def test_assemblies_steps_and_seed(self):
        linkage = kempe.Linkage.read(WATT)
        expected = told("solve", WATT, "--assemblies")
        found = linkage.assemblies()
        self.assertEqual(len(found), expected["assemblies"])
        for places, row in zip(found, expected["rows"]):
            flat = [number for name in "ABEFG" for number in places[name]]
            self.assertEqual(flat, row[1:])
        other = told("solve", WATT, "--assembly", 2, "--steps", 7, "--seed", 3)
        motion = linkage.solve(7, assembly=2, seed=3)
        np.testing.assert_array_equal(motion.to_columns()["G_x_mm"], [row[other["columns"].index("G_x_mm")] for row in other["rows"]])
        self.assertNotEqual(motion, linkage.solve(7, seed=3))

    def test_mobility_centres_and_equations(self):
        for file in LINKAGES:
            with self.subTest(file.name):
                linkage = kempe.Linkage.read(file)
                found, expected = linkage.mobility(), told("mobility", file)
                for name, value in expected.items():
                    self.assertEqual(json.loads(json.dumps(getattr(found, name))), value, name)
                at = min(1.5, linkage.steps)
                expected, found = told("centres", file, "--at", at), linkage.centres(at)
                self.assertEqual((len(found), found.time_s, list(found.drivers)), (expected["count"], expected["time_s"], expected["drivers"]))
                in_mm = {"mm": 1, "cm": 10, "m": 1000, "in": 25.4}[linkage.unit]
                for centre, one in zip(found, expected["centres"]):
                    self.assertEqual((list(centre.links), centre.kind, centre.source), (one["links"], one["kind"], one["source"]))
                    self.assertEqual((centre.joint, centre.velocity_error), (one.get("joint"), one.get("velocity_error")))
                    self.assertEqual((centre.direction_deg, list(centre.lines)), (one.get("direction_deg"), one.get("lines", [])))
                    if centre.at_mm is not None:
                        self.assertEqual(centre.at_mm, tuple(one[f"{axis}_{linkage.unit}"] * in_mm for axis in "xy"))
                    self.assertEqual(found[centre.links[::-1]], centre)
                self.assertEqual(linkage.equations(at), told("solve", file, "--equations", at))
        for links, freedoms in ((6, 1), (8, 1), (7, 2), (5, 1)):
            self.assertEqual(kempe.number_synthesis(links, freedoms), told("mobility", "--links", links, "--dof", freedoms))

    def test_files(self):
        with tempfile.TemporaryDirectory() as scratch:
            page, film, picture = (pathlib.Path(scratch) / name for name in ("a.html", "a.svg", "c.svg"))
            subprocess.run([PROGRAM, "solve", WATT, "--animate", page, "--animate", film, "--json"], check=True, capture_output=True)
            subprocess.run([PROGRAM, "centres", WATT, "--at", "3", "-o", picture], check=True, capture_output=True)
            linkage = kempe.Linkage.read(WATT)
            self.assertEqual(linkage.animation(), page.read_text(encoding="utf-8"))
            self.assertEqual(linkage.animation("svg"), film.read_text(encoding="utf-8"))
            subprocess.run([PROGRAM, "centres", WATT, "--at", "3", "--page", page, "--json"], check=True, capture_output=True)
            self.assertEqual(linkage.centres_page(3), page.read_text(encoding="utf-8"))
            self.assertEqual(linkage.centres_drawing(3), picture.read_text(encoding="utf-8"))
            self.assertEqual(linkage._repr_svg_(), linkage.animation("svg"))

    def test_function_generators(self):
        with tempfile.TemporaryDirectory() as scratch:
            dial = pathlib.Path(scratch) / "dial.toml"
            dial.write_text(DIAL)
            for file in (dial, GENERATORS / "table.toml"):
                linkage, plot = pathlib.Path(scratch) / "f.toml", pathlib.Path(scratch) / "f.svg"
                expected = told("function", file, "--linkage", linkage, "--plot", plot, "--equations")
                found = kempe.function_generator(file)
                for key in ("method", "lengths_mm", "branch", "motion", "structural_error_max_deg", "structural_error_rms_deg",
                            "transmission_min_deg", "rejected", "equations"):
                    self.assertEqual(getattr(found, key), expected[key], key)
                self.assertEqual((list(found.precision_points), found.minimax), (expected["precision_points"], expected.get("minimax")))
                self.assertEqual((found.input_start_deg, found.input_range_deg), tuple(expected["input"].values()))
                self.assertEqual((found.output_start_deg, found.output_range_deg, found.y_at_start, found.y_at_end),
                                 tuple(expected["output"].values()))
                self.assertEqual([dict(zip(found.structural_error, row)) for row in zip(*found.structural_error.values())],
                                 expected["structural_error"])
                self.assertEqual(found.linkage.to_toml(), linkage.read_text(encoding="utf-8"))
                self.assertEqual(found.plot_svg, plot.read_text(encoding="utf-8"))
                tables = tomllib.loads(file.read_text(encoding="utf-8"))
                self.assertEqual(found, kempe.function_generator(tables))
                self.assertEqual(found, kempe.function_generator(**tables))
                self.assertEqual(found, pickle.loads(pickle.dumps(found)))

    def test_inversors(self):
        with tempfile.TemporaryDirectory() as scratch:
            for name in ("enlarger", "copy-camera"):
                file, linkage = GENERATORS / f"{name}.toml", pathlib.Path(scratch) / "i.toml"
                expected = told("inversor", file, "--linkage", linkage)
                found = kempe.inversor(file)
                self.assertEqual(found.kind, expected["best"])
                self.assertEqual(found.linkage.to_toml(), linkage.read_text(encoding="utf-8"))
                for row in expected["inversors"]:
                    if "why_not" in row:
                        self.assertEqual(found.why_not[row["kind"]], row["why_not"])
                        continue
                    one = next(one for one in (found, *found.others) if one.kind == row["kind"])
                    for key, value in row.items():
                        if key != "lengths":
                            self.assertEqual(getattr(one, key), value, key)
                    self.assertEqual([vars(length) for length in one.lengths], row["lengths"])
                    told("inversor", file, "--linkage", linkage, "--kind", one.kind)
                    self.assertEqual(one.linkage.to_toml(), linkage.read_text(encoding="utf-8"))
                self.assertEqual(found, kempe.inversor(tomllib.loads(file.read_text(encoding="utf-8"))))
                self.assertEqual(found, pickle.loads(pickle.dumps(found)))


    def test_path_generators(self):
        with tempfile.TemporaryDirectory() as scratch:
            for name in ("straight-line", "five-poses"):
                file, linkage = GENERATORS / f"{name}.toml", pathlib.Path(scratch) / "p.toml"
                expected, found = told("path", file), kempe.path_generator(file)
                self.assertEqual((len(found), found.bound, found.searched), (len(expected["answers"]), expected["bound"], expected["searched"]))
                self.assertEqual(list(found.dyads), expected.get("dyads", []))
                for number, (one, row) in enumerate(zip(found, expected["answers"]), 1):
                    np.testing.assert_array_equal(one.reached_mm, row.pop("reached_mm"))
                    self.assertIsNone(row.pop("lower_bound_mm"))
                    for which, (other, wanted) in enumerate(zip(one.cognates, row.pop("cognates"), strict=True), 1):
                        for key, value in wanted.items():
                            self.assertEqual(json.loads(json.dumps(getattr(other, key))), value, key)
                        if (number, which) == (1, 2):
                            told("path", file, "--linkage", linkage, "--cognate", which)
                            self.assertEqual(other.linkage.to_toml(), linkage.read_text(encoding="utf-8"))
                    for key, value in row.items():
                        self.assertEqual(json.loads(json.dumps(getattr(one, key))), value, key)
                told("path", file, "--linkage", linkage, "--answer", len(found))
                self.assertEqual(found[len(found) - 1].linkage.to_toml(), linkage.read_text(encoding="utf-8"))
                self.assertEqual(found, kempe.path_generator(**tomllib.loads(file.read_text(encoding="utf-8"))))
                self.assertEqual(found, pickle.loads(pickle.dumps(found)))

    def test_copies_of_coupler_curves(self):
        with tempfile.TemporaryDirectory() as scratch:
            for name, options, keywords in (
                    ("straight-line", ["--copy-scale", 2, "--copy-rotation", -30], {"copy_scale": 2, "copy_rotation_deg": -30}),
                    ("five-poses", ["--copy-rotation", 40, "--copy-pole", "rocker", "--cognate", 2],
                     {"copy_rotation_deg": 40, "copy_pole": "rocker", "copy_cognate": 2})):
                file, linkage, made = GENERATORS / f"{name}.toml", pathlib.Path(scratch) / "copy.toml", 0
                expected = [row["copy"] for row in told("path", file, "--linkage", linkage, *options)["answers"]]
                found = kempe.path_generator(file, **keywords)
                self.assertEqual(found[0].copy.linkage.to_toml(), linkage.read_text(encoding="utf-8"))
                for one, row in zip(found, expected, strict=True):
                    self.assertEqual((one.copy is None, one.why_no_copy), ("why_not" in row, row.get("why_not", "")))
                    if one.copy is None:
                        continue
                    made += 1
                    np.testing.assert_array_equal(one.copy.copied_mm, row.pop("copied_mm"))
                    for key, value in row.items():
                        self.assertEqual(json.loads(json.dumps(getattr(one.copy, key))), value, key)
                    ratio = row["scale"] * np.exp(1j * np.radians(row["rotation_deg"]))
                    turned = (one.reached_mm - row["pole_mm"]) @ [1, 1j] * ratio
                    np.testing.assert_allclose((one.copy.copied_mm - row["pole_mm"]) @ [1, 1j], turned, atol=1e-6)
                self.assertGreater(made, 0)
                self.assertEqual(found, pickle.loads(pickle.dumps(found)))
            self.assertIsNone(kempe.path_generator(file)[0].copy)

    def test_traced_drawings(self):
        """What `kempe trace` writes, byte for byte: exact, made within the tolerances, under the load, partly out of reach."""
        design = kempe.synthesize(kempe.Spec(
            copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "thickness_mm": 3, "pin_diameter_mm": 3},
            material="PLA", load={"pen_N": 5}, tolerance={"length_mm": 0.05, "play_mm": 0.02}), largest_sheets=False)
        drawing = SOURCE / "docs" / "pictures" / "letter.svg"
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            design.save(folder / "design")
            copy, joints, forces = folder / "copy.svg", folder / "joints.csv", folder / "forces.csv"
            for options, keywords, code in (
                    (["--fit"], {"fit": True}, 0),
                    (["--fit", "--instrument", 3, "--csv", joints, "--tolerance", 0.05, "--step", 1],
                     {"fit": True, "instrument": 3, "joints": True, "tolerance_mm": 0.05, "step_mm": 1}, 0),
                    (["--fit", "--load", "--forces", forces], {"fit": True, "load": True, "forces": True}, 0),
                    (["--at", 60, -6, "--scale", 0.2, "--csv", joints], {"at": (60, -6), "scale": 0.2, "joints": True}, 4)):
                with self.subTest(options=options):
                    expected = told("trace", folder / "design" / "design.json", drawing, "-o", copy, *options, code=code)
                    expected.pop("copy")
                    found = design.trace_drawing(drawing, **keywords)
                    self.assertEqual((found.answer, bool(found)), (expected, code == 0))
                    self.assertEqual(found.svg, copy.read_text(encoding="utf-8"))
                    self.assertEqual(found.joints_csv, joints.read_text() if "joints" in keywords else "")
                    self.assertEqual(found.forces_csv, forces.read_text() if "forces" in keywords else "")
                    self.assertEqual(found.poses, expected["poses"])
                    if "joints" in keywords:
                        self.assertEqual(len(found.joints["reached"]), found.poses)
                        self.assertEqual(np.isnan(found.joints["Y_y_mm"]).sum(), found.poses_missed)
                    if "forces" in keywords:
                        self.assertEqual((found.forces["hand_N"].shape[0], found.joints), (found.poses, {}))
                    self.assertEqual(found, pickle.loads(pickle.dumps(found)))
                    text = design.trace_drawing(svg=drawing.read_text(encoding="utf-8"), **keywords)
                    self.assertEqual((text.answer, text.joints_csv, text.forces_csv), (found.answer, found.joints_csv, found.forces_csv))

    def test_calibration(self):
        folder = SOURCE / "specs" / "examples" / "calibration"
        for name, options, keywords in (
                ("knight", ["--target-mm", 0.2, "--ratios", "1:3,0.4"], {"target_mm": 0.2, "ratios": ["1:3", 0.4]}),
                ("ten-readings", ["--method", "least_squares", "--plan", "--plan-readings", 3],
                 {"method": "least_squares", "plan": True, "plan_readings": 3}),
                ("simulate", ["--simulate", "--seed", 7], {"simulate": True, "seed": 7})):
            with tempfile.TemporaryDirectory() as scratch:
                file = folder / f"{name}.toml"
                expected, found = told("calibrate", file, *options, "-o", scratch), kempe.calibration(file, **keywords)
                self.assertEqual(found.answer, expected)
                self.assertEqual(found.page_html, (pathlib.Path(scratch) / "report.html").read_text(encoding="utf-8"))
                simulated = pathlib.Path(scratch) / "simulated.toml"
                self.assertEqual(found.simulated_toml, simulated.read_text(encoding="utf-8") if simulated.exists() else "")


def met(a, ra, b, rb, near):
    """Where two circles meet, the place nearer to `near`."""
    way = b - a
    distance = np.hypot(*way)
    along = (ra**2 - rb**2 + distance**2) / (2 * distance)
    aside = np.sqrt(ra**2 - along**2) * np.array([-way[1], way[0]]) / distance
    middle = a + along * way / distance
    return min(middle + aside, middle - aside, key=lambda place: np.hypot(*(place - near)))


# Watt's six-bar as bars between points.
BARS = {"OA": 25, "AB": 75, "AE": 60, "BE": 50, "DB": 60, "DF": 75, "BF": 45, "EG": 60, "FG": 60}


class LikeNumPy(unittest.TestCase):
    """The same figures by other formulas: circles, bars that keep their lengths, Newton's laws, closed loops."""

    def test_positions_from_circles(self):
        motion = kempe.Linkage.read(WATT).solve()
        at = {"O": np.zeros(2), "D": np.array([80.0, 0]), "B": np.array([82.0, 60]), "E": np.array([34.0, 60]),
              "F": np.array([120.0, 60]), "G": np.array([78.0, 110])}
        for i, angle in enumerate(np.radians(np.linspace(0, 360, 121))):
            at["A"] = 25 * np.array([np.cos(angle), np.sin(angle)])
            at["B"] = met(at["A"], 75, at["D"], 60, at["B"])
            at["E"] = met(at["A"], 60, at["B"], 50, at["E"])
            at["F"] = met(at["D"], 75, at["B"], 45, at["F"])
            at["G"] = met(at["E"], 60, at["F"], 60, at["G"])
            for name, place in at.items():
                np.testing.assert_allclose(motion.positions[name][i], place, atol=1e-9, err_msg=f"{name} at {i}")
        np.testing.assert_allclose(motion.angles_deg["crank"], np.linspace(0, 360, 121), atol=1e-9)

    def rates(self, motion, i):
        """Velocities and accelerations of all points: bars keep their lengths."""
        names, speed = "ABEFG", 2 * np.pi / motion.times_s[-1]
        place = {name: array[i] for name, array in motion.positions.items()}
        matrix, bend = np.zeros((11, 10)), np.zeros(11)
        for row, bar in enumerate(BARS):
            for end, sign in zip(bar, (1, -1)):
                if end in names:
                    column = 2 * names.index(end)
                    matrix[row, column:column + 2] = sign * (place[bar[0]] - place[bar[1]])
        matrix[9, 0] = matrix[10, 1] = 1
        known = np.zeros(11)
        known[9:] = speed * np.array([-place["A"][1], place["A"][0]])
        velocity = np.linalg.lstsq(matrix, known, rcond=None)[0].reshape(5, 2)
        of = {name: velocity[k] for k, name in enumerate(names)} | {"O": np.zeros(2), "D": np.zeros(2)}
        for row, bar in enumerate(BARS):
            bend[row] = -np.sum((of[bar[0]] - of[bar[1]])**2)
        bend[9:] = -speed**2 * place["A"]
        second = np.linalg.lstsq(matrix, bend, rcond=None)[0].reshape(5, 2)
        return of, {name: second[k] for k, name in enumerate(names)}, matrix[:9]

    def test_rates_centres_and_mobility_from_bars(self):
        linkage = kempe.Linkage.read(WATT)
        motion = linkage.solve()
        ends = {"ground": "OD", "crank": "OA", "coupler": "AB", "rocker": "DB", "EG": "EG", "FG": "FG"}
        for i in (0, 17, 60, 101):
            velocity, second, jacobian = self.rates(motion, i)
            for name, value in second.items():
                np.testing.assert_allclose(motion.velocities[name][i], velocity[name], atol=1e-8)
                np.testing.assert_allclose(motion.accelerations[name][i], value, atol=1e-6)
            spin = {}
            for link, (a, b) in ends.items():
                way, rate = (motion.positions[b] - motion.positions[a])[i], velocity[b] - velocity[a]
                spin[link] = (way[0] * rate[1] - way[1] * rate[0]) / way.dot(way)
                if link != "ground":
                    self.assertAlmostEqual(motion.rates_rad_per_s[link][i], spin[link], delta=1e-9)
            centres = linkage.centres(i)
            self.assertEqual(len(centres), 15)
            for centre in centres:
                self.assertEqual(centre.kind, "finite")
                there = []
                for link in centre.links:
                    start = ends[link][0]
                    x, y = np.array(centre.at_mm) - motion.positions[start][i]
                    there.append(velocity[start] + spin[link] * np.array([-y, x]))
                size = 1 + np.hypot(*there[0]) + np.hypot(*centre.at_mm) * max(map(abs, spin.values()))
                self.assertLess(np.hypot(*(there[0] - there[1])) / size, 1e-9, centre)
            found = linkage.mobility()
            self.assertEqual(found.mobility, 10 - np.linalg.matrix_rank(jacobian))
            self.assertEqual(found.gruebler, 3 * (found.links - 1) - 2 * found.full_joints - found.half_joints)
            self.assertEqual((found.links, found.full_joints, found.gruebler), (6, 7, 1))

    def test_forces_obey_newton(self):
        """The press: what pins, guide and hand bear, against the momentum and the work of the whole. m, N."""
        motion = kempe.Linkage.read(PRESS).solve(steps=12)
        moved = []  # mass, velocity, acceleration of each centre of mass; inertia, rate and its change
        for link, origin, centre, mass, inertia in (("lever", "A", (0.3, 0.05), 3.0, 0.12), ("rod", "B", (0.2, 0), 1.2, 0.016)):
            angle = np.radians(motion.angles_deg[link])
            spin, change = motion.rates_rad_per_s[link][:, None], motion.accelerations_rad_per_s2[link][:, None]
            arm = np.column_stack([np.cos(angle) * centre[0] - np.sin(angle) * centre[1], np.sin(angle) * centre[0] + np.cos(angle) * centre[1]])
            square = np.column_stack([-arm[:, 1], arm[:, 0]])
            moved.append((mass, motion.velocities[origin] / 1000 + spin * square,
                          motion.accelerations[origin] / 1000 + change * square - spin**2 * arm, inertia, spin[:, 0], change[:, 0]))
        still = np.zeros(len(motion))
        moved.append((2.5, motion.velocities["C"] / 1000, motion.accelerations["C"] / 1000, 0, still, still))
        hand = np.column_stack([still, motion.forces["drive_P_y_N"]])
        sheet, fall = np.array([0, 2000.0]), np.array([0, -9.81])
        momentum = sum(mass * acceleration for mass, _, acceleration, _, _, _ in moved)
        outside = motion.reactions["A_on_lever"] + motion.reactions["C_from_ground"] + hand + sheet + sum(one[0] for one in moved) * fall
        np.testing.assert_allclose(outside, momentum, atol=1e-8)
        work = sum(mass * np.sum((acceleration - fall) * velocity, 1) + inertia * spin * change
                   for mass, velocity, acceleration, inertia, spin, change in moved)
        np.testing.assert_allclose(motion.forces["drive_P_y_N"] * motion.velocities["P"][:, 1] / 1000
                                   + motion.velocities["C"][:, 1] * 2, work, atol=1e-8)

    def test_four_bars_close_and_show_the_function(self):
        found = kempe.function_generator(tomllib.loads(DIAL))
        length, curve = found.lengths_mm, found.structural_error
        crank = length["input"] * np.exp(1j * np.radians(curve["input_deg"]))
        rocker = length["ground"] + length["output"] * np.exp(1j * np.radians(curve["output_deg"]))
        np.testing.assert_allclose(abs(crank - rocker), length["coupler"], rtol=1e-12)
        wanted = found.output_start_deg + 90 * (np.log10(curve["x"]) / np.log10(2))
        np.testing.assert_allclose(curve["output_deg"] - wanted, curve["error_deg"], atol=1e-10)
        self.assertLess(np.abs(curve["error_deg"]).max(), found.structural_error_max_deg + 1e-12)
        motion = found.linkage.solve(steps=180)
        points = {name: place @ [1, 1j] for name, place in motion.positions.items()}
        np.testing.assert_allclose(points["A"], crank, atol=1e-8)
        np.testing.assert_allclose(points["B"], rocker, atol=1e-8)

    def test_inversors_keep_the_lens_sharp(self):
        best = kempe.inversor(GENERATORS / "enlarger.toml")
        for one in (best, *best.others):
            places = one.linkage.solve(steps=20).positions
            np.testing.assert_allclose(np.abs(places["P"][:, 0] * places["Q"][:, 0]), 150**2, rtol=1e-9)
            self.assertAlmostEqual(one.size_mm, sum(length.count * length.mm for length in one.lengths), delta=1e-9)


class Faults(unittest.TestCase):
    def faults(self, make):
        with self.assertRaises(kempe.SpecError) as raised:
            make()
        self.assertEqual(pickle.loads(pickle.dumps(raised.exception)).faults, raised.exception.faults)
        return raised.exception.faults

    def test_files_have_the_faults_that_the_program_tells(self):
        files = sorted((SOURCE / "tests" / "corpus" / "linkage-faults").glob("*.toml"))
        compared = 0
        for file in files:
            with self.subTest(file.name):
                expected = told("solve", file, code=2)["error"]["faults"]
                found = self.faults(lambda: kempe.Linkage.read(file).solve())
                self.assertEqual([(one.file, one.line, one.key, one.found, one.allowed) for one in found],
                                 [(one["file"], one["line"], one["key"] or "", one["found"], one["allowed"]) for one in expected])
                compared += 1
        self.assertGreater(compared, 50)
        for command, call in (("function", kempe.function_generator), ("inversor", kempe.inversor)):
            for text in ("[lens]\nfocal_length_mm = -1\n", "[function]\nexpression = \"log10(\"\nx = [1, 2]\n", "no TOML", ""):
                with tempfile.TemporaryDirectory() as scratch:
                    file = pathlib.Path(scratch) / "bad.toml"
                    file.write_text(text)
                    expected = told(command, file, code=2)["error"]["faults"]
                    self.assertEqual([(one.line, one.key, one.found) for one in self.faults(lambda: call(file))],
                                     [(one["line"], one["key"] or "", one["found"]) for one in expected])
            self.faults(lambda: call("no such file.toml"))
            self.faults(lambda: call({"lens": {"focal_length_mm": object()}}))
            self.faults(call)
            with self.assertRaises(TypeError):
                call(GENERATORS / "enlarger.toml", lens={})

    def test_keywords_have_the_faults_of_the_text(self):
        compared = 0
        for file in sorted((SOURCE / "tests" / "corpus" / "linkage-faults").glob("*.toml")):
            text = file.read_text(encoding="utf-8", errors="replace")
            try:
                tables = tomllib.loads(text)
            except (tomllib.TOMLDecodeError, RecursionError):
                continue
            try:
                kempe.Linkage.from_toml(text)
            except kempe.SpecError as in_text:
                with self.subTest(file.name):
                    found = self.faults(lambda: kempe.Linkage(**tables))
                    self.assertEqual(sorted((one.key, one.found, one.allowed) for one in found),
                                     sorted((one.key, one.found, one.allowed) for one in in_text.faults))
                    self.assertTrue(all(one.line is None and one.file is None for one in found))
                compared += 1
        self.assertGreater(compared, 40)

    def test_a_file_may_be_called_anything(self):
        with tempfile.TemporaryDirectory() as scratch:
            file = os.fsencode(scratch) + b"/odd\xff.toml"
            pathlib.Path(os.fsdecode(file)).write_text(WATT.read_text(encoding="utf-8").replace('name = "Watt six-bar"', ""))
            linkage = kempe.Linkage.read(os.fsdecode(file))
            self.assertTrue(linkage.name.startswith("odd"))
            self.assertEqual(linkage.equations()["linkage"], linkage.name)
            self.assertEqual((linkage.mobility().linkage, linkage.centres().linkage), (linkage.name, linkage.name))
            self.assertIn("<svg", linkage.centres_drawing())
            self.assertEqual(linkage, pickle.loads(pickle.dumps(linkage)))

    def test_arguments(self):
        linkage = kempe.Linkage.read(WATT)
        for wrong, key in ((lambda: linkage.solve(steps=0), "steps"), (lambda: linkage.solve(steps=2**30), "steps"),
                           (lambda: linkage.solve(assembly=99), "assembly"), (lambda: linkage.solve(assembly=-1), "assembly"),
                           (lambda: linkage.centres(at=-1), "at"), (lambda: linkage.centres(at=float("nan")), "at"),
                           (lambda: kempe.number_synthesis(1), "links"), (lambda: kempe.number_synthesis(6, -1), "freedoms")):
            self.assertEqual([one.key for one in self.faults(wrong)], [key])
        with self.assertRaises(ValueError):
            linkage.animation("gif")
        knight = SOURCE / "specs" / "examples" / "calibration" / "knight.toml"
        for key, value in (("target_mm", 0), ("target_mm", float("nan")), ("method", "guess"), ("plan_readings", 101), ("ratios", ["x"])):
            self.assertEqual([one.key for one in self.faults(lambda: kempe.calibration(knight, **{key: value}))], [key])
        self.faults(lambda: kempe.calibration("no such file.toml"))
        self.faults(lambda: kempe.path_generator(path={"points_mm": [[0, 0]]}))
        line = GENERATORS / "straight-line.toml"
        for key, value in (("scale", 0), ("scale", float("nan")), ("rotation_deg", 361), ("pole", "here")):
            self.assertEqual([one.key for one in self.faults(lambda: kempe.path_generator(line, **{f"copy_{key}": value}))], [f"copy.{key}"])
        self.assertEqual([one.key for one in self.faults(lambda: kempe.path_generator(line, copy_scale=2, copy_cognate=3))], ["copy.cognate"])
        with self.assertRaises(TypeError):
            kempe.path_generator(line, copy_cognate=1)

    def test_where_there_is_no_motion(self):
        bars = {"crank": {"joints": ["O", "A"], "O-A": 10}, "rod": {"joints": ["A", "B"], "A-B": 30}, "rocker": {"joints": ["D", "B"], "D-B": 15}}
        far = kempe.Linkage(ground={"O": [0, 0], "D": [80, 0]}, links=bars, drivers=[{"angle": "crank", "from_deg": 0, "to_deg": 360}])
        for call in (far.solve, far.mobility, far.centres, far.assemblies):
            with self.assertRaises(kempe.NoMotion) as raised:
                call()
            self.assertIn("does not assemble", raised.exception.sentence)
            self.assertEqual(pickle.loads(pickle.dumps(raised.exception)).sentence, raised.exception.sentence)
        self.assertIsNone(far._repr_svg_())
        stuck = kempe.Linkage(ground={"O": [0, 0], "D": [40, 0]}, links=bars | {"rod": {"joints": ["A", "B"], "A-B": 25}},
                              drivers=[{"angle": "crank", "from_deg": 0, "to_deg": 360}], motion={"steps": 36})
        motion = stuck.solve()
        self.assertFalse(motion)
        self.assertIn(motion.end.kind, str(motion.end))
        self.assertEqual(motion.end.step, motion.steps[-1])
        self.assertTrue(np.isnan(motion.velocities["A"][-1]).all() and np.isfinite(motion.positions["A"]).all())
        with self.assertRaises(kempe.NoMotion):
            stuck.centres(at=36)
        with self.assertRaises(kempe.NoDesign) as none:
            kempe.inversor(lens={"focal_length_mm": 150, "magnification": [0.5, 2]}, limits={"transmission_deg": 80})
        self.assertFalse(none.exception.proven)
        for expression, is_proven in (("0 * x", False), ("1 / (x - 0.5)", True)):  # the places where it is constant are not all
            with self.assertRaises(kempe.NoDesign) as none:
                kempe.function_generator(function={"expression": expression, "x": [0, 1]}, input={"range_deg": 60}, output={"range_deg": 60})
            self.assertEqual(none.exception.proven, is_proven)
            self.assertIn("function.expression", str(none.exception))
        slow = {"function": {"expression": "sin(100*x)", "x": [0, 1], "method": "least_squares"}, "input": {"range_deg": 60},
                "output": {"range_deg": 10}}
        with self.assertRaises(kempe.Stopped):
            kempe.function_generator(slow, time_limit=0)
        self.assertFalse(kempe.function_generator(slow, time_limit=2).complete)
        self.assertTrue(kempe.function_generator(tomllib.loads(DIAL)).complete)


class Values(unittest.TestCase):
    def test_they_compare_pickle_and_print(self):
        for file in LINKAGES:
            linkage = kempe.Linkage.read(file)
            again = kempe.Linkage.from_toml(linkage.to_toml(), str(file))
            self.assertEqual((linkage, hash(linkage)), (again, hash(again)))
            self.assertEqual(linkage, pickle.loads(pickle.dumps(linkage)))
        linkage = kempe.Linkage.read(WATT)
        self.assertEqual(repr(linkage), "<kempe.Linkage: 'Watt six-bar', 5 links, 7 points>")
        self.assertNotEqual(linkage, kempe.Linkage.read(PRESS))
        for one in (linkage.solve(steps=3), linkage.mobility(), linkage.centres(2)):
            self.assertEqual(one, pickle.loads(pickle.dumps(one)))
            self.assertLess(len(repr(one)), 900)
            self.assertNotEqual(one, None)
        self.assertEqual(linkage.points, ["O", "D", "A", "B", "E", "F", "G"])
        with self.assertRaises(KeyError):
            linkage.centres()["crank", "nothing"]
        with self.assertRaises(KeyError):
            linkage.centres()["crank", "crank"]

    def test_others_run_meanwhile_and_ctrl_c_ends_it(self):
        import _thread
        linkage, ticks, done = kempe.Linkage.read(WATT), [], threading.Event()

        def tick():
            while not done.wait(0.01):
                ticks.append(time.monotonic())
                if len(ticks) == 10:
                    _thread.interrupt_main()

        helper = threading.Thread(target=tick)
        helper.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                for _ in range(50):
                    linkage.solve(steps=20000)
        finally:
            done.set()
            helper.join()
        self.assertGreaterEqual(len(ticks), 10)


if __name__ == "__main__":
    os.environ.setdefault("PYTHONDONTWRITEBYTECODE", "1")
    unittest.main()
