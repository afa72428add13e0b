#!/usr/bin/env python3
"""`kempe init` from outside: ten jobs, each a spec that becomes a design.

usage: init_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import json
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import FILES, SOURCE, kempe


def listed():
    return json.loads(kempe("init", "--json").stdout)["templates"]


class Templates(program.Case):
    def test_are_ten_each_with_a_line(self):
        names = [one["name"] for one in listed()]
        self.assertEqual(len(names), 10)
        self.assertEqual(set(names), {path.stem for path in (SOURCE / "specs" / "templates").glob("*.toml")})
        lines = kempe("init").stdout.splitlines()
        for one, line in zip(listed(), lines):
            self.assertTrue(line.startswith(one["name"]) and line.endswith(one["purpose"]), line)
            self.assertLess(len(line), 120)

    def test_become_verified_designs(self):
        for one in listed():
            with self.subTest(one["name"]):
                spec, out = self.scratch / f"{one['name']}.toml", self.scratch / one["name"]
                run = kempe("init", one["name"], "-o", spec)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertEqual(spec.read_bytes(), (SOURCE / "specs" / "templates" / spec.name).read_bytes())
                run = kempe("synthesize", spec, "-o", out, "--quiet")
                self.assertEqual(run.returncode, 0, f"{one['name']}: {run.stderr}")
                self.assertLessEqual(FILES, {p.name for p in out.iterdir()})
                self.assertTrue(list((out / "parts").glob("*.dxf")), "the links can be cut")
                design = json.loads((out / "design.json").read_text())
                self.assertTrue(design["workspace"]["region_covered"])
                self.assertTrue(design["search"]["complete"])
                self.assertEqual(kempe("verify", out / "design.json").returncode, 0)

    def test_are_printed_without_a_file(self):
        text = (SOURCE / "specs" / "templates" / "sign-router.toml").read_text()
        self.assertEqual(kempe("init", "sign-router").stdout, text)
        self.assertEqual(json.loads(kempe("init", "sign-router", "--json").stdout)["spec"], text)

    def test_that_are_none_are_told_the_nearest(self):
        run = kempe("init", "sign-ruter")
        self.assertEqual(run.returncode, 2)
        self.assertIn("sign-router (the nearest known template)", run.stderr)
        self.assertIn("one of the templates sign-router, ", kempe("init", "\x1b[31mcar").stderr)
        self.assertNotIn("\x1b", kempe("init", "\x1b[31mcar").stderr)

    def test_never_replace_a_file(self):
        spec = self.scratch / "mine.toml"
        spec.write_text("mine")
        run = kempe("init", "sign-router", "-o", spec)
        self.assertEqual(run.returncode, 2)
        self.assertEqual(spec.read_text(), "mine")
        self.assertEqual(kempe("init", "sign-router", "-o", self.scratch / "no" / "such" / "mine.toml").returncode, 5)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
