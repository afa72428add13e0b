#!/usr/bin/env python3
"""workshop.pdf, read by a reader that shares nothing with its writer: dimensions and lines against design.json, parts against
bom.csv, the ruler as poppler renders it, letters that keep clear of each other and inside the frame.

usage: workshop_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import csv
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import program
from pdf_reader import pages_of
from program import EXAMPLES, TEN_LINES, kempe

EXACT = 1e-3  # mm
PAPER = {"A4": (210, 297), "A3": (297, 420)}
FRAME = (20, 10)  # mm: from the left edge of the paper, from the others
LINKS = ["VA", "VB", "ACX", "BCY"]


def drawing_of(page):
    """What the title block says of a sheet: its drawing and scale."""
    def value(field):
        name = next(one for one in page.texts if one.text == field)
        return next(one.text for one in page.texts if abs(one.x - name.x) < 0.01 and 0 < name.y - one.y < 9 and one is not name)

    over, under = (float(one) for one in value("Scale").split(":")) if ":" in value("Scale") else (1, 1)
    return value("Drawing"), over / under


def outlined_circles(page, radius):
    """Centres of the circles drawn as visible edges with this radius."""
    found = [path.circle() for path in page.paths if abs(path.pen - 0.5) < 0.01 and path.stroked]
    return [(x, y) for x, y, r in filter(None, found) if abs(r - radius) < EXACT]


def departure(places, link, lengths):
    """How far stated coordinates of a link's holes lie from those that its lengths give, mm: the latter laid on the former as well as
    turning about the first hole allows, with either hand; the hand is not of this comparison."""
    stated = [complex(*places[joint]) - complex(*places[link[0]]) for joint in link]
    true = [0, lengths[frozenset(link[:2])]]
    if len(link) == 3:
        a, b, c = true[1], lengths[frozenset(link[0] + link[2])], lengths[frozenset(link[1:])]
        along = (a * a + b * b - c * c) / (2 * a)
        true.append(complex(along, math.sqrt(max(0.0, b * b - along * along))))
    least = math.inf
    for hand in (true, [complex(z).conjugate() for z in true]):
        turn = sum(z * complex(w).conjugate() for z, w in zip(stated, hand))
        turn /= abs(turn)
        off = [z - turn * w for z, w in zip(stated, hand)]
        middle = complex((max(z.real for z in off) + min(z.real for z in off)) / 2, (max(z.imag for z in off) + min(z.imag for z in off)) / 2)
        least = min(least, max(max(abs((z - middle).real), abs((z - middle).imag)) for z in off))
    return least


def apart(one, other):
    """True if two boxes, turned or not, do not overlap: some side of one separates them."""
    for box in (one, other):
        for i in range(2):
            axis = (box[i + 1][0] - box[i][0], box[i + 1][1] - box[i][1])
            spans = [[axis[0] * x + axis[1] * y for x, y in corners] for corners in (one, other)]
            slack = 1e-6 * math.hypot(*axis)
            if max(spans[0]) <= min(spans[1]) + slack or max(spans[1]) <= min(spans[0]) + slack:
                return True
    return False


def thin_box(a, b, thick=0.01):
    """A line from a to b as a box, mm."""
    x, y = (thick * (b[i] - a[i]) / math.dist(a, b) for i in (0, 1))
    return [a, b, (b[0] - y, b[1] + x), (a[0] - y, a[1] + x)]


class Case(program.Case):
    def drawn(self, text, name="job.toml", paper=None, folder="out"):
        """The folder that a spec becomes."""
        spec, out = self.scratch / name, self.scratch / folder
        spec.write_text(text)
        command = "workspace" if "[mechanism]" in text else "synthesize"
        run = kempe(command, spec, "-o", out, "--quiet", *(["--paper", paper] if paper else []))
        self.assertEqual(run.returncode, 0, run.stderr)
        return out

    def pages(self, out):
        return pages_of((out / "workshop.pdf").read_bytes())

    def check_letters(self, pages, where):
        faults = []
        for number, page in enumerate(pages, 1):
            boxes = [(one.text, one.corners()) for one in page.texts if one.text.strip()]
            for (text, box), (other, second) in itertools.combinations(boxes, 2):
                if not apart(box, second):
                    faults.append(f"sheet {number}: '{text}' lies on '{other}'")
            for text, box in boxes:
                if not all(FRAME[0] <= x <= page.size[0] - FRAME[1] and FRAME[1] <= y <= page.size[1] - FRAME[1] for x, y in box):
                    faults.append(f"sheet {number}: '{text}' leaves the frame")
        self.assertEqual(faults, [], where)


class Dimensions(Case):
    def check_link(self, pages, link, design):
        mechanism = design["mechanism"]
        lengths = {frozenset(name): value for name, value in mechanism["lengths_mm"].items()}
        pairs = [frozenset(pair) for pair in itertools.combinations(link, 2)]
        hole = mechanism["pin_diameter_mm"] + design["cutting"]["hole_fit_mm"]
        sheets = [page for page in pages if drawing_of(page)[0].startswith(f"Link {link},")]
        first = sheets[0]
        # the tables
        rows = {frozenset(row[0]): float(row[1]) for row in first.table("Between holes", 45) if len(row) == 2 and row[0] != "Holes"}
        self.assertEqual(set(rows), set(pairs))
        for pair in pairs:
            self.assertLessEqual(abs(rows[pair] - lengths[pair]), EXACT)
        heading = next(one.text for one in first.texts if one.text.startswith("Holes, from "))
        places = {row[0]: (float(row[1]), float(row[2])) for row in first.table(heading, 78) if len(row) == 4 and row[0] != "Hole"}
        self.assertEqual(places[heading[-1]], (0, 0))
        self.assertLessEqual(departure(places, link, lengths), EXACT)
        # the lines, on every sheet that shows the whole link
        for sheet in sheets:
            scale = drawing_of(sheet)[1]
            centres = outlined_circles(sheet, 0.5 * hole * scale)
            if len(centres) != len(link):
                self.assertIn("tile", drawing_of(sheet)[0])
                continue
            found = sorted(math.dist(a, b) / scale for a, b in itertools.combinations(centres, 2))
            for drawn, wanted in zip(found, sorted(lengths[pair] for pair in pairs)):
                self.assertLessEqual(abs(drawn - wanted), EXACT)
        # what stands at the arrows
        said = {one.text for one in first.texts}
        for x, y in places.values():
            for value in (x, abs(y)):
                self.assertTrue(value == 0 or any(re.fullmatch(r"[\d.]+", one) and float(one) == value for one in said))

    def test_agree_with_the_design(self):
        for example in sorted(EXAMPLES.glob("*.toml")):
            with self.subTest(example.name):
                out = self.drawn(example.read_text(), example.name, folder=example.stem)
                design = json.loads((out / "design.json").read_text())
                pages = self.pages(out)
                for link in LINKS:
                    self.check_link(pages, link, design)

    def test_tiles_join(self):
        out = self.drawn((EXAMPLES.parents[1] / "bench/tasks/router-among-obstacles.toml").read_text())
        tiles = [page for page in self.pages(out) if "Link VA" in drawing_of(page)[0] and "tile" in drawing_of(page)[0]]
        self.assertEqual(len(tiles), 2)
        marks = []
        for tile in tiles:
            rings = [path.circle() for path in tile.paths if not path.clipped]
            rings = sorted((x, y) for x, y, r in filter(None, rings) if abs(r - 2) < EXACT)
            self.assertEqual(len(rings), 2)
            hole, = [(x, y) for x, y in outlined_circles(tile, 5) if FRAME[0] < x < tile.size[0] - FRAME[1]]
            marks.append([(x - hole[0], y - hole[1]) for x, y in rings])
        for (x, y), (u, v) in zip(*marks):  # laid on each other the holes are as far apart as the bar is long
            self.assertLessEqual(abs(math.hypot(x - u, y - v) - 270), EXACT)


    def test_crosses_of_one_name_are_one_place(self):
        out = self.drawn("""
[copy]
scale = 1.0
rotation_deg = 70
[region]
rectangle_mm = {at = [300, -100], size = [200, 200]}
[links]
width_mm = 30
pin_diameter_mm = 8
thickness_mm = 6
longest_mm = 900
[limits]
transmission_deg = 15
""")
        design = json.loads((out / "design.json").read_text())
        pages = self.pages(out)
        grids = 0
        for link in ("ACX", "BCY"):
            tiles = [page for page in pages if f"Link {link}," in drawing_of(page)[0] and "tile" in drawing_of(page)[0]]
            if len(tiles) < 4:
                continue
            grids += 1
            shown, holes = {}, {}
            for number, tile in enumerate(tiles):
                rings = [path.circle() for path in tile.paths if not path.clipped]
                rings = [(x, y) for x, y, r in filter(None, rings) if abs(r - 2) < EXACT]
                names = [one for one in tile.texts if re.fullmatch(r"[A-Z]\d+-[A-Z]\d+ [ab]", one.text)]
                self.assertEqual(len(names), len(rings))
                self.assertEqual(len({one.text for one in names}), len(names), "a name stands twice on one sheet")
                own = drawing_of(tile)[0].split("tile ")[1].split(" ")[0]
                for one in names:
                    self.assertIn(own, one.text.split(" ")[0].split("-"))
                    ring = min(rings, key=lambda at: min(math.dist(at, (one.x, one.y)), math.dist(at, (one.x + one.width, one.y))))
                    shown.setdefault(one.text, []).append((number, ring))
                holes[number] = outlined_circles(tile, 0.5 * design["mechanism"]["pin_diameter_mm"])
            for name, places in shown.items():
                self.assertEqual(len(places), 2, name)
            # laid so that its crosses meet, each tile has one place, whichever way one comes to it
            moved = {0: (0, 0)}
            while len(moved) < len(tiles):
                for places in shown.values():
                    (one, at), (other, there) = places
                    for known, new, a, b in ((one, other, at, there), (other, one, there, at)):
                        if known in moved and new not in moved:
                            moved[new] = tuple(moved[known][i] + a[i] - b[i] for i in (0, 1))
            for name, ((one, at), (other, there)) in shown.items():
                for i in (0, 1):
                    self.assertLessEqual(abs(moved[one][i] + at[i] - moved[other][i] - there[i]), EXACT, name)
        self.assertGreater(grids, 0)


def with_hardware(name):
    """A spec whose links are wide and thick enough for any of it."""
    text = (EXAMPLES.parent / "templates/sign-router.toml").read_text()
    return re.sub("width_mm = .*", "width_mm = 40", re.sub("thickness_mm = .*", "thickness_mm = 9", re.sub('hardware = "[^"]*"', f'hardware = "{name}"', text)))


class Parts(Case):
    def test_of_the_bill_are_drawn_and_no_others(self):
        specs = {example: (EXAMPLES / f"{example}.toml").read_text() for example in ("plagiograph", "pantorouter", "clamped-plate")}
        specs |= {name: with_hardware(name) for name in ("M6 bolt", "M8 shoulder bolt", "608 bearing", "8 mm dowel", "6 mm dowel and bush")}
        for name, text in specs.items():
            with self.subTest(name):
                out = self.drawn(text, name.replace(" ", "-") + ".toml", folder=name.replace(" ", "-"))
                bill = list(csv.DictReader((out / "bom.csv").read_text().splitlines()))
                pages = self.pages(out)
                listed, in_lists = {}, set()
                for page in pages:
                    if "Parts list" in {one.text for one in page.texts}:
                        in_lists |= {one.text for one in page.texts}
                        for row in page.table("Parts list", 240):
                            if row and row[0].isdigit() and len(row) > 2:
                                listed[int(row[0])] = row[2].removeprefix("link ")
                self.assertEqual(set(listed), set(range(1, len(bill) + 1)))
                for number, one in enumerate(bill, 1):  # a long name goes on in the next line
                    self.assertTrue(one["name"].startswith(listed[number]), one["name"])
                    self.assertIn(one["name"][len(listed[number]):].strip(), in_lists | {""})
                stack = next(page for page in pages if drawing_of(page)[0].startswith("Stack"))
                assembly = next(page for page in pages if drawing_of(page)[0].startswith("Assembly"))
                said = {int(m[1]): m[2] for m in (re.fullmatch(r"(\d+)  (.+)", one.text) for one in stack.texts) if m}
                for number, one in enumerate(bill, 1):
                    if one["item"] == "strip":  # what links are sawn off
                        continue
                    self.assertIn(number, said, one["name"])
                    if one["item"] in ("link", "pin", "post"):
                        self.assertIn(str(number), {text.text for text in assembly.texts}, one["name"])
                    if one["item"] == "link":
                        self.assertTrue(any(f"Link {one['name']}, item {number}" in drawing_of(page)[0] for page in pages))
                for number, what in said.items():
                    self.assertEqual("2 washers" if bill[number - 1]["name"] == "washer" else bill[number - 1]["name"], what)


def said_on(page):
    """All words of a sheet as one line; words that go on in the next line follow each other."""
    return " ".join(one.text for one in page.texts)


class Warnings(Case):
    def notes(self, out):
        return json.loads(kempe("report", out / "design.json", "-o", self.scratch / "again", "--json").stdout)["notes"]

    def test_stand_before_the_parts(self):
        text = """
[copy]
scale = 0.5
[region]
rectangle_mm = {at = [120, -60], size = [160, 120]}
[links]
width_mm = 25
thickness_mm = 5
hardware = {A = "M6 bolt", C = "3 mm dowel"}
pin_diameter_mm = 8
[limits]
clearance_mm = 1
[cutting]
process = "laser"
"""
        for name, text in (("ten", TEN_LINES), ("mixed", text)):
            out = self.drawn(text, name + ".toml", folder=name)
            notes = self.notes(out)
            self.assertGreater(len(notes), 0)
            lists = [page for page in self.pages(out) if drawing_of(page)[0].startswith("Parts list")]
            self.assertIn("Before making", {one.text for one in lists[0].texts})
            said = " ".join(map(said_on, lists))
            for note in notes:
                self.assertIn(note[0].upper() + note[1:], said)
            self.check_letters(self.pages(out), name)

    def test_links_that_cannot_be_cut_say_so_on_every_sheet_of_theirs(self):
        for name, region, width in (("small", "[60, -40, 9, 8]", 5), ("large", "[600, -400, 900, 800]", 50)):
            with self.subTest(name):
                out = self.drawn(f"""
[copy]
scale = "1:3"
[region]
rectangle_mm = {region}
[links]
width_mm = {width}
pin_diameter_mm = {width}
thickness_mm = 2
longest_mm = 3000
[limits]
transmission_deg = 20
[cutting]
hole_fit_mm = 0.2
""", name + ".toml", folder=name)
                self.assertFalse((out / "parts").exists())
                pages = self.pages(out)
                sentence = f"he links cannot be cut as they are: holes of {width + 0.2} mm leave no wall in links {width} mm wide; thinner pins"
                links = [page for page in pages if drawing_of(page)[0].startswith("Link ")]
                self.assertEqual(len(links), 4, "no tiles to cut by")
                for page in links:
                    self.assertIn("Do not cut: t" + sentence, said_on(page))
                    self.assertIn("Hole to edge: no wall", {one.text for one in page.texts})
                lists = next(page for page in pages if drawing_of(page)[0].startswith("Parts list"))
                self.assertIn("T" + sentence, said_on(lists))
                self.assertTrue(any(page.says("Cutting list: cannot be cut, their holes are as wide as the links") for page in pages))
                self.check_letters(pages, name)


class Bench(Case):
    def check_places(self, out, obstacles):
        """Each place of the table against the design, from the edge of its [table]."""
        design = json.loads((out / "design.json").read_text())
        pages = self.pages(out)
        heading = "Places on the bench, mm"
        tables = [page.table(heading, 172) for page in pages if heading in {one.text for one in page.texts}]
        rows = [row for table in tables for row in table if len(row) == 4 and row[0].isdigit()]
        left, front = (min(point[i] for point in design["table"]["coordinates"][0][0]) for i in (0, 1))
        pole = design["mechanism"]["pole_position_mm"]
        self.assertEqual(rows[0][1][:4], "pole")
        self.assertLessEqual(math.dist((float(rows[0][2]) + left, float(rows[0][3]) + front), pole), EXACT)
        self.assertEqual(len(rows), 5 + 2 * obstacles)
        self.assertEqual([int(row[0]) for row in rows], list(range(1, len(rows) + 1)))
        plan = next(page for page in pages if drawing_of(page)[0].startswith("Bench plan"))
        self.assertTrue({row[0] for row in rows} <= {one.text for one in plan.texts})
        for body in design["bodies"]:
            self.assertIn(body["name"], {one.text for one in plan.texts})
        return drawing_of(plan)[1], len([page for page in pages if drawing_of(page)[0].startswith("Bench plan")])

    def test_plan_and_places(self):
        text = (EXAMPLES / "pantorouter.toml").read_text()
        self.assertEqual(self.check_places(self.drawn(text), 3), (0.2, 1))
        far = "".join(f'[[obstacles]]\nname = "bin {i}"\ncircle_mm = [{-390 + 15 * i}, -290, 5]\n' for i in range(30))
        self.assertEqual(self.check_places(self.drawn(text + far, "bins.toml", folder="bins"), 33), (0.2, 3))


    def test_holds_what_bodies_sweep(self):
        out = self.drawn("""
[copy]
scale = 2
[region]
rectangle_mm = {at = [100, -30], size = [60, 60]}
[links]
width_mm = 15
pin_diameter_mm = 6
layers = 4
[objective]
groundings = ["pole", "tracer"]
[[bodies]]
name = "router"
at = "pen"
circle_mm = {centre = [0, 0], radius = 60}
layers = [4, 8]
""")
        heading = "Places on the bench, mm"
        pages = self.pages(out)
        table = next(page.table(heading, 172) for page in pages if heading in {one.text for one in page.texts})
        rows = {row[1]: (float(row[2]), float(row[3])) for row in table if len(row) == 4 and row[0].isdigit()}
        left, front = rows["copy, left and front"]
        right, back = rows["copy, right and back"]
        self.assertGreaterEqual(left, 60 - EXACT)  # the pen comes to the copy's corners, the router 60 mm beyond
        self.assertGreaterEqual(front, 60 - EXACT)
        plan = next(page for page in pages if drawing_of(page)[0].startswith("Bench plan"))
        figures = [float(one.text) for one in plan.texts if re.fullmatch(r"[\d.]+", one.text) and "." in one.text or one.text.isdigit()]
        self.assertAlmostEqual(front, 60, 2)
        for wanted in (right + 60, back + 60):  # the bench ends there
            self.assertTrue(any(abs(one - wanted) < 2 * EXACT for one in figures), wanted)
        space = re.search(r"Bench space.*?>(\d+) × (\d+)", (out / "report.html").read_text(), re.S)
        self.assertEqual([int(space[1]), int(space[2])], [math.ceil(right + 60 - EXACT), math.ceil(back + 60 - EXACT)])


class Sheets(Case):
    def test_are_of_the_paper_asked_for(self):
        for paper, (width, height) in PAPER.items():
            for page in self.pages(self.drawn(TEN_LINES, paper=paper, folder=paper)):
                self.assertLess(abs(min(page.size) - width) + abs(max(page.size) - height), 1e-3)
        run = kempe("synthesize", self.scratch / "job.toml", "-o", self.scratch / "no", "--paper", "A5")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("A5", run.stderr)

    def test_are_the_same_bytes_each_time(self):
        texts = [(self.drawn(TEN_LINES, folder=folder) / "workshop.pdf").read_bytes() for folder in ("one", "two")]
        self.assertEqual(*texts)
        self.assertNotIn(b"Date", texts[0])

    def test_name_their_design(self):
        out = self.drawn(TEN_LINES)
        sum_of = subprocess.run(["sha1sum", out / "design.json"], capture_output=True, text=True).stdout[:16]
        pages = self.pages(out)
        for number, page in enumerate(pages, 1):
            self.assertTrue(page.says(sum_of))
            self.assertTrue(page.says(f"{number} of {len(pages)}"))

    def test_title_blocks_cut_no_figure(self):
        for scale, rotation, words in (('"2:3"', 180, "scale 2:3, rotation 180°"), (0.7071068, -123.4567, "scale 0.707107, rotation -123.457°"),
                                       (1.4, 90, "scale 1.4, rotation 90°")):
            text = TEN_LINES.replace("scale = 1.4", f"scale = {scale}").replace("rotation_deg = 90", f"rotation_deg = {rotation}")
            pages = self.pages(self.drawn(text.replace("at = [60, -5]", "at = [90, -5]")))
            for page in pages:
                self.assertIn(words, {one.text for one in page.texts})
            self.check_letters(pages, words)

    def test_letters_of_the_assembly_lie_on_no_edge(self):
        wide = """
[copy]
scale = "2:3"
rotation_deg = 180
[region]
rectangle_mm = [-250, -450, 150, 120]
[pole]
at_mm = [-100, -200]
[links]
width_mm = 36
hardware = "M10 bolt"
thickness_mm = 12
layers = 3
shortest_mm = 70
longest_mm = 900
grid_mm = 5
[limits]
clearance_mm = 3
transmission_deg = 25
[cutting]
process = "drill"
[objective]
groundings = ["pole", "tracer"]
"""
        large = """
[copy]
scale = 3
rotation_deg = 37
[region]
rectangle_mm = [-4000, -3500, 1500, 900]
[pole]
at_mm = [-2500, -2500]
[links]
width_mm = 80
hardware = "M12 bolt"
thickness_mm = 18
shortest_mm = 200
longest_mm = 6000
layers = 3
[limits]
clearance_mm = 5
transmission_deg = 5
"""
        for name, text in (("wide", wide), ("large", large), ("ten", TEN_LINES)):
            assembly = self.pages(self.drawn(text, name + ".toml", folder=name))[0]
            inside = [path for path in assembly.paths if path.stroked and path.circle() is None and abs(path.pen - 0.5) < 0.01]
            rings = [path.ends() for path in inside]
            edges = [thin_box(a, b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1]) if math.dist(a, b) > 0.1]
            self.assertGreater(len(edges), 8)
            letters = [one for one in assembly.texts if re.fullmatch("[VABCXY]( pole| tracer| pen)?", one.text)]
            self.assertEqual(len(letters), 6)
            for one in letters:
                box = one.corners()
                for edge in edges:
                    self.assertTrue(apart(box, edge), f"{name}: '{one.text}' lies on an edge")

    def test_stand_any_title(self):
        long_name = "a long name " * 15
        for name in (long_name, "(brackets) \\ and %", "Größe ½ Ω Жук 中文", "tab\tand\x01bell\x07", "  "):
            with self.subTest(name):
                self.check_letters(self.pages(self.drawn(TEN_LINES, name + ".toml")), name)

    def test_letters_keep_clear_of_each_other(self):
        for example in sorted(EXAMPLES.glob("*.toml")):
            for paper in PAPER:
                out = self.drawn(example.read_text(), example.name, paper, f"{example.stem}-{paper}")
                self.check_letters(self.pages(out), f"{example.name} on {paper}")

    def test_letters_keep_clear_on_random_specs(self):
        chance = random.Random(7)
        for i in range(24):
            text = f"""
[copy]
scale = {round(math.exp(chance.uniform(-1.5, 1.5)), 3)}
rotation_deg = {chance.choice([0, 180, 37, 90, -120, round(chance.uniform(-170, 170), 1)])}
[region]
rectangle_mm = {{at = [{chance.uniform(40, 200):.1f}, {chance.uniform(-60, 60):.1f}], size = [{chance.uniform(4, 60):.1f}, {chance.uniform(4, 60):.1f}]}}
[links]
width_mm = {chance.uniform(5, 30):.2f}
pin_diameter_mm = {chance.uniform(1, 4.9):.2f}
thickness_mm = {chance.uniform(1, 12):.2f}
layers = {chance.randint(2, 4)}
longest_mm = 3000
"""
            spec, out = self.scratch / "random.toml", self.scratch / f"random{i}"
            spec.write_text(text)
            run = kempe("synthesize", spec, "-o", out, "--quiet")
            if run.returncode == 3:  # no such linkage
                continue
            self.assertEqual(run.returncode, 0, run.stderr)
            self.check_letters(self.pages(out), text)


class Ruler(Case):
    def test_measures_100_mm_as_rendered(self):
        out = self.drawn(TEN_LINES)
        number, page = next((n, page) for n, page in enumerate(self.pages(out), 1) if drawing_of(page)[1] == 1 and page.says("100 mm:"))
        dots = 300 / 25.4
        image = subprocess.run(["pdftoppm", "-r", "300", "-gray", "-f", str(number), "-l", str(number), out / "workshop.pdf"],
                               capture_output=True).stdout
        header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", image)
        width, height = int(header[1]), int(header[2])
        zero, hundred = (next(one for one in page.texts if one.text == text) for text in ("0", "100"))
        row = round(height - (zero.y + 0.9 + 2.5 + 3.6) * dots)  # near the tops of the long ticks
        line = image[header.end() + row * width: header.end() + (row + 1) * width]

        def tick_near(text):
            middle = (text.x + 0.5 * text.width) * dots
            ink = [(x, 255 - line[x]) for x in range(round(middle - 5), round(middle + 6))]
            return sum((x + 0.5) * dark for x, dark in ink) / sum(dark for _, dark in ink)

        self.assertLessEqual(abs(tick_near(hundred) - tick_near(zero) - 100 * dots), 0.5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
