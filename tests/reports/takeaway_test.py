#!/usr/bin/env python3
"""What people take away, judged from outside by readers that share nothing with the program: the drawings of every
example by ezdxf, a coat of arms copied through the mechanism by a reader of its own, and drawings that are broken or
hostile.

usage: takeaway_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import csv
import json
import math
import pathlib
import re
import socket
import struct
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import EXAMPLES, FILES, SOURCE, kempe

ORACLE = SOURCE / "tests" / "reports" / "dxf_oracle.py"
# Debian's iso-flags-svg: the greater coat of arms of Serbia, 42 000 lines and curves.
ARMS = pathlib.Path("/usr/share/iso-flags-svg/country-4x3/rs.svg")
LINKS = ["VA", "VB", "ACX", "BCY"]


class Case(program.Case):
    maxDiff = 2000

    def design_of(self, example, more=""):
        """The folder that an example becomes, `more` added to its spec."""
        text = (EXAMPLES / example).read_text()
        spec, out = self.scratch / example, self.scratch / "out"
        spec.write_text(text + "\n" + more)
        run = kempe("workspace" if "[mechanism]" in text else "synthesize", spec, "-o", out, "--quiet")
        self.assertEqual(run.returncode, 0, f"{example}: {run.stderr}")
        return out


def distances_of(joints, lengths):
    """Between the joints of a link, in the order 01, 02, 12; a name's letters may stand either way round."""
    pairs = [(0, 1)] if len(joints) == 2 else [(0, 1), (0, 2), (1, 2)]
    known = {frozenset(name): value for name, value in lengths.items()}
    return [known[frozenset((joints[i], joints[j]))] for i, j in pairs]


class Parts(Case):
    def expectations(self, out, fit=None, kerf=None):
        """Fit and kerf as given, else as the design's file says."""
        design = json.loads((out / "design.json").read_text())
        mechanism, cutting = design["mechanism"], design["cutting"]
        fit = cutting["hole_fit_mm"] if fit is None else fit
        kerf = cutting["kerf_mm"] if kerf is None else kerf
        links = [{"name": link["name"], "style": link["shape"], "joints": link["joints"],
                  "lengths": distances_of(link["joints"], mechanism["lengths_mm"])} for link in mechanism["links"]]
        common = {"width": mechanism["link_width_mm"], "hole": mechanism["pin_diameter_mm"] + fit - kerf, "kerf": kerf}
        cases = [dict(common, dxf=str(out / "drawing.dxf"), links=links)]
        if (out / "nested.dxf").exists():  # outlines are kept apart there, not their boxes
            cases.append(dict(common, dxf=str(out / "nested.dxf"), links=links, nested=True))
        return cases + [dict(common, dxf=str(out / "parts" / f"{link['name']}.dxf"), links=[link]) for link in links]

    def judge(self, cases):
        asked = self.scratch / "expectations.json"
        asked.write_text(json.dumps(cases))
        run = subprocess.run(["/usr/bin/python3", ORACLE, asked], capture_output=True, text=True, timeout=600)
        self.assertEqual((run.returncode, run.stdout.strip()), (0, ""), run.stderr)

    def test_ezdxf_finds_every_drawing_of_every_example_sound_and_as_designed(self):
        for path in sorted(EXAMPLES.glob("*.toml")):
            with self.subTest(path.name):
                out = self.design_of(path.name)
                self.judge(self.expectations(out))

    def test_kerf_fit_and_sheet_reach_every_drawing(self):
        out = self.design_of("plagiograph.toml", "[cutting]\nhole_fit_mm = 0.1\nkerf_mm = 0.2\nsheet_mm = [400, 300]\n")
        cases = self.expectations(out, fit=0.1, kerf=0.2)
        self.assertEqual(len(cases), 6)
        self.judge(cases)

    def test_the_folder_holds_a_file_of_each_kind_for_each_link(self):
        out = self.design_of("nameplate.toml")
        for link in LINKS:
            for kind in ("dxf", "svg", "stl"):
                self.assertTrue((out / "parts" / f"{link}.{kind}").stat().st_size > 0)
        rows = list(csv.DictReader((out / "bom.csv").read_text().splitlines()))
        self.assertEqual([row["name"] for row in rows if row["item"] == "link"], LINKS)
        self.assertEqual(sum(row["item"] == "pin" for row in rows), 3)
        self.assertEqual(sum(row["item"] == "post" for row in rows), 3)

    def test_a_solid_is_as_large_as_its_drawing_says(self):
        out = self.design_of("nameplate.toml")
        mechanism = json.loads((out / "design.json").read_text())["mechanism"]
        for link in mechanism["links"]:
            data = (out / "parts" / f"{link['name']}.stl").read_bytes()
            count = struct.unpack_from("<I", data, 80)[0]
            volume = 0.0
            for i in range(count):
                a, b, c = (struct.unpack_from("<3f", data, 84 + 50 * i + 12 * j) for j in (1, 2, 3))
                volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                           + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
            # The nameplate's links are straight: a slot less its holes.
            width, hole = mechanism["link_width_mm"], mechanism["pin_diameter_mm"]
            length = max(distances_of(link["joints"], mechanism["lengths_mm"]))
            area = length * width + math.pi / 4 * (width ** 2 - len(link["joints"]) * hole ** 2)
            self.assertAlmostEqual(volume / (area * mechanism["thickness_mm"]), 1, delta=2e-3)

    def check_left_out(self, spec, command, *words):
        """Exit 0, the six files and the bill, no part, and a sentence in all places where one looks."""
        path, out = self.scratch / "spec.toml", self.scratch / "left-out"
        path.write_text(spec)
        run = kempe(command, path, "-o", out, "--quiet")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual({file.name for file in out.iterdir()} - {"certificate.jsonl"}, FILES | {"bom.csv"})
        said = json.loads(kempe(command, path, "-o", out, "--quiet", "--json").stdout)["left_out"]
        self.assertEqual(len(said), 1)
        for word in words:
            for text in (run.stderr, run.stdout, said[0], (out / "report.html").read_text()):
                self.assertIn(word, text)
        self.assertIn("The links cannot be cut", (out / "drawing.svg").read_text())
        self.assertNotIn("parts/VA.dxf", (out / "report.html").read_text())
        self.judge(self.expectations_of_drawing(out))
        self.assertEqual(kempe("verify", out / "design.json").returncode, 0)

    def expectations_of_drawing(self, out, fit=0.0):
        mechanism = json.loads((out / "design.json").read_text())["mechanism"]
        links = [{"name": link["name"], "style": link["shape"], "joints": link["joints"],
                  "lengths": distances_of(link["joints"], mechanism["lengths_mm"])} for link in mechanism["links"]]
        return [{"width": mechanism["link_width_mm"], "hole": mechanism["pin_diameter_mm"] + fit, "kerf": 0.0,
                 "dxf": str(out / "drawing.dxf"), "links": links}]

    def test_pins_as_wide_as_the_links_leave_no_wall_and_that_is_said(self):
        spec = ("[copy]\nscale = 1.4\nrotation_deg = 90\n[region]\nrectangle_mm = {at = [62, -5], size = [8, 10]}\n"
                "[links]\nwidth_mm = 12\npin_diameter_mm = 12\n")
        self.check_left_out(spec, "synthesize", "no wall", "12 mm")

    def test_holes_of_a_given_mechanism_that_run_into_each_other_leave_out_its_parts_alone(self):
        spec = ("[copy]\nscale = 0.15\nrotation_deg = 40\n[region]\nrectangle_mm = {at = [80, -20], size = [30, 40]}\n"
                "[links]\nwidth_mm = 8\npin_diameter_mm = 6\n[limits]\nclearance_mm = 0\ntransmission_deg = 10\n"
                "[mechanism]\nvertex = \"pen\"\nVA_mm = 15.5\nVB_mm = 23.4\nassembly = 0\n")
        self.check_left_out(spec, "workspace", "link ACX has its holes A and X", "6 mm wide", "no wall")

    def test_a_sheet_that_is_too_small_is_said_and_stops_nothing(self):
        spec = self.scratch / "spec.toml"
        spec.write_text((EXAMPLES / "nameplate.toml").read_text() + "\n[cutting]\nsheet_mm = [100, 100]\n")
        run = kempe("synthesize", spec, "-o", self.scratch / "out", "--quiet")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("no nested.dxf: link", run.stderr)
        self.assertIn("does not fit on a sheet of 100 x 100 mm", run.stderr)
        self.assertFalse((self.scratch / "out" / "nested.dxf").exists())
        self.assertTrue((self.scratch / "out" / "drawing.dxf").exists())


# --- A reader of SVG artwork of its own: paths of m l h v c s z, rectangles, polygons, use, matrix and translate. ---

def matrix_of(text):
    if not text:
        return (1, 0, 0, 1, 0, 0)
    kind, inside = re.fullmatch(r"(matrix|translate)\(([^)]*)\)", text.strip()).groups()
    numbers = tuple(float(x) for x in re.split(r"[\s,]+", inside.strip()))
    return numbers if kind == "matrix" else (1, 0, 0, 1, *numbers)


def times(m, n):
    return (m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3], m[1] * n[2] + m[3] * n[3],
            m[0] * n[4] + m[2] * n[5] + m[4], m[1] * n[4] + m[3] * n[5] + m[5])


def applied(m, z):
    return complex(m[0] * z.real + m[2] * z.imag + m[4], m[1] * z.real + m[3] * z.imag + m[5])


def strokes_of_path(data):
    """Lists of pieces (two or four points), one a sub-path."""
    tokens = re.findall(r"[a-zA-Z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", data)
    strokes, pieces, at, start, i, command, control = [], [], 0j, 0j, 0, None, None

    def number():
        nonlocal i
        i += 1
        return float(tokens[i - 1])

    def point(relative):
        x = number()
        return complex(x, number()) + (at if relative else 0)

    def ended():
        nonlocal pieces
        if len(pieces) == 2 and all(len(p) == 2 for p in pieces) and abs(pieces[1][1] - pieces[0][0]) < 1e-9:
            pieces = pieces[:1]  # out and back: the program draws the line once
        if pieces:
            strokes.append(pieces)
        pieces = []

    while i < len(tokens):
        if tokens[i].isalpha():
            command = tokens[i]
            i += 1
        small, relative = command.lower(), command.islower()
        before = control if small == "s" else None
        control = None
        if small == "m":
            ended()
            at = start = point(relative)
            command = "l" if relative else "L"
        elif small == "z":
            if at != start:
                pieces.append((at, start))
            at = start
            ended()
        elif small in "cs":
            first = point(relative) if small == "c" else (2 * at - before if before is not None else at)
            second = point(relative)
            end = point(relative)
            pieces.append((at, first, second, end))
            at, control = end, second
        else:
            if small == "l":
                to = point(relative)
            elif small == "h":
                to = complex(number() + (at.real if relative else 0), at.imag)
            else:
                to = complex(at.real, number() + (at.imag if relative else 0))
            pieces.append((at, to))
            at = to
    ended()
    return strokes


def artwork(path):
    """The strokes of a picture, in its own pixels, in the order of drawing."""
    strokes, root = [], ElementTree.parse(path).getroot()
    by_id = {node.get("id"): node for node in root.iter()}

    def closed(corners):
        return list(zip(corners, corners[1:] + corners[:1]))

    def visit(node, matrix):
        tag = node.tag.split("}")[-1]
        if tag in ("defs", "metadata", "clipPath"):
            return
        matrix = times(matrix, matrix_of(node.get("transform")))
        found = []
        if tag == "path":
            found = strokes_of_path(node.get("d"))
        elif tag == "rect":
            x, y, w, h = (float(node.get(key, 0)) for key in ("x", "y", "width", "height"))
            corners = [complex(x, y), complex(x + w, y), complex(x + w, y + h), complex(x, y + h)]
            found = [closed(corners)]
        elif tag == "polygon":
            numbers = [float(x) for x in re.split(r"[\s,]+", node.get("points").strip())]
            found = [closed([complex(x, y) for x, y in zip(numbers[::2], numbers[1::2])])]
        elif tag == "use":
            visit(by_id[node.get("{http://www.w3.org/1999/xlink}href")[1:]], matrix)
        strokes.extend([[tuple(applied(matrix, z) for z in piece) for piece in stroke] for stroke in found])
        for child in node:
            visit(child, matrix)

    visit(root, (1, 0, 0, 1, 0, 0))
    return strokes


def on_piece(piece, t):
    if len(piece) == 2:
        return piece[0] + t * (piece[1] - piece[0])
    a, b, c, d = piece
    u = 1 - t
    return u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d


def to_segment(z, a, b):
    along = b - a
    squared = abs(along) ** 2
    t = 0.0 if squared == 0 else min(1.0, max(0.0, ((z - a) * along.conjugate()).real / squared))
    return abs(a + t * along - z)


def to_piece(z, piece, within):
    """Distance of a point from a line or a cubic, or infinity where it is surely more than `within`."""
    if len(piece) == 2:
        return to_segment(z, *piece)
    xs, ys = [p.real for p in piece], [p.imag for p in piece]
    if not (min(xs) - within <= z.real <= max(xs) + within and min(ys) - within <= z.imag <= max(ys) + within):
        return math.inf

    def refined(t):
        step = 1 / 64
        for _ in range(32):
            t = min((max(0.0, t - step), t, min(1.0, t + step)), key=lambda s: abs(on_piece(piece, s) - z))
            step *= 0.6
        return abs(on_piece(piece, t) - z)

    places = sorted((i / 64 for i in range(65)), key=lambda s: abs(on_piece(piece, s) - z))
    return min(map(refined, places[:2]))


def lines_of_copy(path, group):
    """The polylines of a group of the copy in the table's frame, y upward, closed ones closed."""
    lines = []
    for node in ElementTree.parse(path).getroot():
        if node.get("id") != group:
            continue
        for one in node:
            strokes = strokes_of_path(one.get("d"))
            pieces = [piece for stroke in strokes for piece in stroke]
            if pieces:
                lines.append([pieces[0][0].conjugate()] + [piece[1].conjugate() for piece in pieces])
    return lines


class Copies(Case):
    def copy(self, design, drawing, *arguments):
        out = self.scratch / "copy.svg"
        return kempe("trace", design / "design.json", drawing, "-o", out, "--json", *arguments), out

    def similarity(self, design):
        read = json.loads((design / "design.json").read_text())
        k = read["copy"]["scale"] * complex(math.cos(math.radians(read["copy"]["rotation_deg"])),
                                            math.sin(math.radians(read["copy"]["rotation_deg"])))
        pole = complex(*read["mechanism"]["pole_position_mm"])
        return lambda z: pole + k * (z - pole)

    def test_a_coat_of_arms_of_40000_segments_is_copied_within_a_millionth_of_a_millimetre(self):
        self.assertTrue(ARMS.exists(), "iso-flags-svg is not there: run scripts/bootstrap tests")
        within, at, enlarged = 1e-6, -84 + 20j, 0.98
        design = self.design_of("nameplate.toml")
        run, out = self.copy(design, ARMS, "--at", at.real, at.imag, "--scale", enlarged, "--tolerance", "1e-6")
        self.assertEqual(run.returncode, 0, run.stderr)
        image, mm = self.similarity(design), enlarged * 25.4 / 96
        strokes = [[tuple(image(at + mm * complex(z.real, 480 - z.imag)) for z in piece) for piece in stroke]
                   for stroke in artwork(ARMS)]
        self.assertGreater(sum(map(len, strokes)), 10000)
        lines = lines_of_copy(out, "copy")
        self.assertEqual(len(lines), len(strokes))
        self.assertEqual(json.loads(run.stdout)["strokes"], len(strokes))
        for number, (stroke, line) in enumerate(zip(strokes, lines)):
            # Both run the same way: each is followed along the other, forward only.
            i = 0
            for piece in stroke:
                for t in (0.3, 0.7, 1):
                    z = on_piece(piece, t)
                    while to_segment(z, line[i], line[i + 1]) > within:
                        i += 1
                        self.assertLess(i + 1, len(line), f"stroke {number} at {z}: not in the copy")
            i = 0
            for z in line[::101] + line[-1:]:
                while to_piece(z, stroke[i], within) > within:
                    i += 1
                    self.assertLess(i, len(stroke), f"stroke {number} at {z}: not in the original")

    def square(self, name="square.svg", more="", size=40):
        path = self.scratch / name
        path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="{size}mm"'
                        f' height="{size}mm" viewBox="0 0 {size} {size}"><path d="M2,2H{size - 2}V{size - 2}H2Z"/>{more}</svg>')
        return path

    def test_what_cannot_be_reached_is_left_out_in_red_and_counted(self):
        design = self.design_of("plagiograph.toml")
        run, out = self.copy(design, self.square(size=200), "--at", "0", "-100")
        self.assertEqual(run.returncode, 4, run.stderr)
        told = json.loads(run.stdout)
        self.assertGreater(told["left_out"], 0)
        self.assertEqual(sum(told["left_out_by_cause"].values()), told["left_out"])
        self.assertIn(str(told["left_out"]), run.stderr)
        groups = {node.get("id"): node for node in ElementTree.parse(out).getroot()}
        self.assertEqual(groups["left-out"].get("stroke"), "#e00000")
        image = self.similarity(design)
        corners = [image(complex(x, y)) for x, y in ((2, 98), (198, 98), (198, -98), (2, -98))]
        sides = list(zip(corners, corners[1:] + corners[:1]))
        for group in ("copy", "left-out"):
            lines = lines_of_copy(out, group)
            self.assertGreater(len(lines), 0, group)
            for z in (z for line in lines for z in line):
                self.assertLess(min(to_segment(z, a, b) for a, b in sides), 1e-9)

    def test_every_joint_of_every_pose_keeps_the_lengths(self):
        design = self.design_of("plagiograph.toml")
        table = self.scratch / "poses.csv"
        run, _ = self.copy(design, self.square(size=10), "--at", "61", "-5", "--csv", table)
        self.assertEqual(run.returncode, 0, run.stderr)
        lengths = json.loads((design / "design.json").read_text())["mechanism"]["lengths_mm"]
        rows = list(csv.DictReader(table.read_text().splitlines()))
        self.assertEqual(len(rows), json.loads(run.stdout)["poses"])
        for row in rows:
            at = {joint: complex(float(row[f"{joint}_x_mm"]), float(row[f"{joint}_y_mm"])) for joint in "VABCXY"}
            for name, length in lengths.items():
                self.assertAlmostEqual(abs(at[name[0]] - at[name[1]]), length, delta=1e-9)

    def test_an_instrument_as_made_draws_otherwise_and_the_same_seed_draws_the_same(self):
        design = self.design_of("plagiograph.toml", "[tolerance]\nlength_mm = 0.05\nplay_mm = 0.02\n")
        texts = []
        for seed in (1, 1, 2):
            run, out = self.copy(design, self.square(size=10), "--at", "61", "-5", "--instrument", seed)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertGreater(json.loads(run.stdout)["departure_max_mm"], 0.001)
            texts.append(out.read_bytes())
        self.assertEqual(texts[0], texts[1])
        self.assertNotEqual(texts[0], texts[2])

    def refused(self, drawing, *words):
        design = self.scratch / "design.json"
        if not design.exists():
            design.write_bytes((self.design_of("plagiograph.toml") / "design.json").read_bytes())
        out = self.scratch / "copy.svg"
        run = kempe("trace", design, drawing, "-o", out)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertFalse(out.exists())
        for word in words:
            self.assertIn(word, run.stderr)

    def test_broken_svg_is_refused_with_its_line(self):
        broken = self.scratch / "broken.svg"
        broken.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm">\n<path d="M0,0L1,1"\n</svg>')
        self.refused(broken, "broken.svg:")
        broken.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm">\n<path d="M0,0L1,q"/></svg>')
        self.refused(broken, "broken.svg:2")

    def test_an_entity_bomb_is_refused(self):
        bomb = self.scratch / "bomb.svg"
        entities = "".join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, 12))
        bomb.write_text(f'<!DOCTYPE svg [<!ENTITY a0 "M0,0L1,1">{entities}]>\n'
                        '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm"><path d="&a11;"/></svg>')
        self.refused(bomb, "bomb.svg:", "entit")

    def test_text_instead_of_paths_is_said(self):
        path = self.scratch / "words.svg"
        path.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="10mm"><text x="1" y="5">ABC</text></svg>')
        self.refused(path, "words.svg", "text")

    def test_nothing_outside_is_fetched_and_no_script_is_copied(self):
        design = self.design_of("plagiograph.toml")
        with socket.create_server(("127.0.0.1", 0)) as server:
            server.settimeout(0.2)
            url = f"http://127.0.0.1:{server.getsockname()[1]}"
            drawing = self.square(size=10, more=f'<script>alert("{url}")</script><image xlink:href="{url}/a.png" width="3" height="3"/>'
                                  f'<use xlink:href="{url}/b.svg#c"/><path d="M3,3L4,4" onclick="alert(1)" style="fill:url({url}/d)"/>')
            run, out = self.copy(design, drawing, "--at", "61", "-5")
            self.assertEqual(run.returncode, 0, run.stderr)
            with self.assertRaises(TimeoutError, msg="something was fetched"):
                server.accept()
        told, copy = json.loads(run.stdout), out.read_text()
        self.assertEqual((told["images"], told["references"]), (1, 2))
        for word in ("script", "alert", "127.0.0.1", "onclick", "image"):
            self.assertNotIn(word, copy)

    def test_names_with_spaces_quotes_and_markup_stay_names(self):
        design = self.design_of("plagiograph.toml")
        drawing = self.square("a \"b\" 'c' <script>alert(1)<&amp;> d.svg".replace("/", ""), size=10)
        out = self.scratch / "copy of \"it\" <b>.svg"
        run = kempe("trace", design / "design.json", drawing, "-o", out, "--at", "61", "-5")
        self.assertEqual(run.returncode, 0, run.stderr)
        title = ElementTree.parse(out).getroot()[0]
        self.assertEqual(title.text, f"{drawing.name}, copied")
        self.assertNotIn("<script", out.read_text())

    def test_a_dxf_without_units_asks_for_them(self):
        drawing = self.scratch / "region.dxf"
        drawing.write_bytes((SOURCE / "tests" / "corpus" / "dxf" / "without-units.dxf").read_bytes())
        spec = self.scratch / "spec.toml"
        text = '[copy]\nscale = 2\nrotation_deg = 30\n[region]\nfile = "region.dxf"\ncover = "hull"\n{}[links]\nwidth_mm = 6\npin_diameter_mm = 3\n'
        spec.write_text(text.format(""))
        run = kempe("synthesize", spec, "-o", self.scratch / "out")
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("units", run.stderr)
        spec.write_text(text.format('units = "mm"\n'))
        run = kempe("synthesize", spec, "-o", self.scratch / "out")
        self.assertIn(run.returncode, (0, 3), run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
