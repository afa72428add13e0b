#!/usr/bin/env python3
"""What the command line does, in Python: docs/python.md names a way for every command and option of it, and the files are the same.

usage: commands_test.py SOURCE PROGRAM [unittest's arguments]     PYTHONPATH leads to the module
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import kempe

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SMALL = """[copy]
scale = 1.4
rotation_deg = 90
[region]
rectangle_mm = {at = [62, -5], size = [8, 10]}
[links]
width_mm = 6
pin_diameter_mm = 3
"""
PAGE = '<!DOCTYPE html>\n<script type="application/json" id="studio-spec">null</script>\n'


def run(*words, code=0, **options):
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, **options)
    assert done.returncode == code, f"{done.returncode}: {done.stderr}"
    return done.stdout


def files_of(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def commands():
    """What `kempe help` lists."""
    lines = run("help").split("Subcommands:")[1].splitlines()
    return [line.split()[0] for line in lines if line.startswith("  ") and line[2:3].isalpha()]


def options(command):
    """The long options of a command, those of every command left out."""
    words = re.findall(r"^  (?:-\w,)?(--[\w-]+)", run(command, "--help"), re.MULTILINE)
    return [word for word in words if word not in ("--help", "--json", "--quiet")]


def table():
    """The page's table of commands: for each its row of (in Python, options)."""
    page = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
    section = page.split("\n## Commands\n")[1].split("\n## ")[0]
    rows = [[cell.strip() for cell in line.strip("|").split(" | ")] for line in section.splitlines() if line.startswith("| `")]
    return {row[0].strip("` "): row[1:] for row in rows}


class Table(unittest.TestCase):
    def test_every_command_has_a_row(self):
        self.assertGreater(len(commands()), 15)
        self.assertEqual(list(table()), commands())

    def test_every_option_has_its_way(self):
        for command, cells in table().items():
            self.assertEqual(len(cells), 2, command)
            with self.subTest(command):
                self.assertEqual(set(re.findall(r"`(--[\w-]+)", cells[1])), set(options(command)))

    def test_every_way_is_there(self):
        for command, cells in table().items():
            ways = re.findall(r"`kempe\.([\w.]+)", " ".join(cells))
            self.assertTrue(ways or "`python -m kempe" in cells[0] or "`help(" in cells[0], command)
            for way in ways:
                thing = kempe
                for name in way.split("."):
                    thing = getattr(thing, name)


class SameFiles(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.spec = self.folder / "plate.toml"
        self.spec.write_text(SMALL)
        self.page = self.folder / "page.html"
        self.page.write_text(PAGE)
        self.enterContext(unittest.mock.patch.dict(os.environ, KEMPE_STUDIO=str(self.page)))

    def test_templates(self):
        listed = json.loads(run("init", "--json"))["templates"]
        self.assertEqual([{"name": one.name, "purpose": one.purpose} for one in kempe.templates().values()], listed)
        for name, one in kempe.templates().items():
            self.assertEqual(one.toml, run("init", name))
            self.assertEqual(one.spec, kempe.Spec.from_toml(one.toml))
            one.save(self.folder / f"{name}.toml")
            self.assertEqual((self.folder / f"{name}.toml").read_bytes(), (SOURCE / "specs" / "templates" / f"{name}.toml").read_bytes())
        with self.assertRaises(FileExistsError):
            one.save(self.folder / f"{name}.toml")

    def test_studio(self):
        drawing = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8" width="8mm" height="8mm"><path d="M1 1H7V7H1Z"/></svg>'
        (self.folder / "square.svg").write_text(drawing)
        drawn = self.folder / "drawn.toml"
        drawn.write_text("[copy]\nscale = 2\n[region]\nfile = 'square.svg'\n[pole]\nat_mm = [-70, 0]\n")
        for file in (self.spec, drawn):
            run("studio", file, "-o", self.folder / "theirs.html")
            self.assertEqual(kempe.studio_page(file), (self.folder / "theirs.html").read_text(encoding="utf-8"))
        self.assertIn("rotation_deg = 90", kempe.studio_page(kempe.load(self.spec)))
        self.assertEqual(kempe.studio_page(self.spec, page=self.page), kempe.studio_page(self.spec))
        self.spec.write_text("[copy]\nscale = 0\n")
        with self.assertRaisesRegex(kempe.SpecError, "copy.scale"):
            kempe.studio_page(self.spec)
        self.page.write_text("another page")
        with self.assertRaisesRegex(kempe.SpecError, "no page of the studio"):
            kempe.studio_page(drawn)
        with unittest.mock.patch.dict(os.environ, KEMPE_STUDIO=""), unittest.mock.patch("pathlib.Path.is_file", lambda path: False):
            with self.assertRaisesRegex(kempe.Error, "scripts/studio"):
                kempe.studio_page(drawn)

    def test_reports(self):
        run("synthesize", self.spec, "-o", self.folder / "made", "--quiet")
        made = self.folder / "made" / "design.json"
        run("report", made, "-o", self.folder / "theirs", "--paper", "A3", "--studio", "--quiet")
        design = kempe.Design.load(made)
        names = design.save(self.folder / "ours", "design.json", paper="A3", studio=True)
        ours, theirs = files_of(self.folder / "ours"), files_of(self.folder / "theirs")
        self.assertEqual(set(names), set(ours))
        self.assertEqual(set(ours), set(theirs))
        self.assertIn("studio.html", ours)
        self.assertIn(b'<a href="studio.html">', ours["report.html"])
        for name in ours.keys() - {"studio.html"}:  # there the spec has the name of the file
            self.assertEqual(ours[name], theirs[name], name)
        with self.assertRaisesRegex(ValueError, "A4 or A3"):
            design.save(self.folder / "no", paper="letter")
        self.assertFalse((self.folder / "no").exists())
        coarse = kempe.Design.load(made, time_limit=0)
        self.assertFalse(coarse.map.complete)

    def test_fronts(self):
        run("pareto", self.spec, "--between", "size,transmission", "--points", 3, "-o", self.folder / "theirs", "--quiet")
        front = kempe.pareto(kempe.load(self.spec), ("size", "transmission"), points=3)
        names = front.save(self.folder / "ours", "plate.toml")
        ours, theirs = files_of(self.folder / "ours"), files_of(self.folder / "theirs")
        self.assertEqual(set(names), set(ours))
        self.assertEqual(set(ours), set(theirs))
        for name in ours:
            if not name.endswith("report.html"):  # a page shows the spec as its file has it
                self.assertEqual(ours[name], theirs[name], name)
        self.assertIn(b'id="pareto"', ours["report.html"])
        (self.folder / "file").touch()
        with self.assertRaises(kempe.NotWritten):
            front.save(self.folder / "file")

    def test_proofs_of_none(self):
        self.spec.write_text(SMALL + "longest_mm = 20\n")
        run("synthesize", self.spec, "-o", self.folder / "none", "--quiet", code=3)
        spec = kempe.load(self.spec)
        with self.assertRaises(kempe.NoDesign) as none:
            kempe.synthesize(spec)
        self.assertTrue(none.exception.proven)
        self.assertEqual(kempe.proof_of_none(spec), (self.folder / "none" / "certificate.jsonl").read_text())
        with self.assertRaisesRegex(kempe.Error, "left out"):
            kempe.proof_of_none(kempe.Spec.from_toml(SMALL))

    def test_calibrations(self):
        for name in ("knight", "plotter"):
            file = SOURCE / "specs" / "examples" / "calibration" / f"{name}.toml"
            with self.subTest(name):
                theirs = self.folder / f"{name}-theirs"
                words = ("--equations",) if name == "knight" else ("--plan",)
                printed = run("calibrate", file, "-o", theirs, *words)
                found = kempe.calibration(file, equations=name == "knight", plan=name != "knight")
                self.assertEqual((str(found), found.answer), (printed, json.loads(found.json)))
                self.assertEqual(set(found.save(self.folder / name)), set(files_of(theirs)))
                self.assertEqual(files_of(self.folder / name), files_of(theirs))
        self.assertIn("equations", kempe.calibration(SOURCE / "specs/examples/calibration/knight.toml", equations=True).answer)
        with self.assertRaisesRegex(kempe.SpecError, "equations: found the method least_squares"):
            kempe.calibration(file, equations=True)

    def test_pages_of_paths(self):
        generators = SOURCE / "specs" / "examples" / "generators"
        poses = kempe.path_generator(generators / "five-poses.toml", copy_scale=2).best
        points = kempe.path_generator(generators / "straight-line.toml").best
        for name, words, one in (("five-poses", (), poses), ("five-poses", ("--cognate", 2), poses.cognates[1]),
                                 ("five-poses", ("--copy-scale", 2), poses.copy), ("straight-line", (), points)):
            with self.subTest(name, words=words):
                page, drawing = self.folder / "theirs.html", self.folder / "theirs.svg"
                run("path", generators / f"{name}.toml", "--animate", page, "--animate", drawing, *words)
                self.assertEqual(one.animation(), page.read_text(encoding="utf-8"))
                self.assertEqual(one.animation("svg"), drawing.read_text(encoding="utf-8"))


class Program(unittest.TestCase):
    def call(self, *words, **options):
        return subprocess.run([sys.executable, "-m", "kempe", *words], capture_output=True, text=True, **options)

    def test_its_commands_run_from_python(self):
        with unittest.mock.patch.dict(os.environ, KEMPE_PROGRAM=str(PROGRAM)):
            done = self.call("help")
            self.assertEqual((done.returncode, done.stdout), (0, run("help")))
            self.assertEqual(self.call("init", "nothing").returncode, 2)
            self.assertEqual(kempe.program(), PROGRAM)

    def test_language_models_are_served_from_python(self):
        asked = '{"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"protocolVersion": "2025-06-18"}}\n'
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(os.environ, KEMPE_PROGRAM=str(PROGRAM)):
            done = self.call("mcp", "--folder", folder, input=asked)
        self.assertEqual(json.loads(done.stdout)["result"]["protocolVersion"], "2025-06-18")

    def test_of_the_build_it_is_found(self):
        with unittest.mock.patch.dict(os.environ, KEMPE_PROGRAM=""):
            self.assertTrue(os.path.samefile(kempe.program(), PROGRAM))

    def test_without_it_a_sentence_says_so(self):
        with unittest.mock.patch.dict(os.environ, KEMPE_PROGRAM="/nothing/kempe"):
            done = self.call("help")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("/nothing/kempe", done.stderr)


unittest.main(argv=sys.argv)
