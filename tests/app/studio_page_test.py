#!/usr/bin/env python3
"""kempe studio from outside: the page with a spec inside, whatever the spec holds. The page here is a stand-in with the studio's one
place for a spec; tests/studio opens the true one.

usage: studio_page_test.py KEMPE SOURCE_DIR [unittest arguments]
"""
import json
import os
import pathlib
import re
import shutil
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import KEMPE, TEN_LINES, kempe

BEFORE = '<!DOCTYPE html>\n<script type="application/json" id="studio-spec">'
AFTER = '</script>\n<script>kempe.begin();</script>\n'
HOSTILE = '# </script><script>alert(1)</script> <!-- <script id="x"> \' " \\ & \u2028 \u2029 ünïcode 雕 \U0001f527 \\u003c\n'
SQUARE = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8" width="8mm" height="8mm"><path d="M1 1H7V7H1Z"/></svg>'


class Studio(program.Case):
    def setUp(self):
        super().setUp()
        self.page = self.scratch / "built.html"
        self.page.write_text(BEFORE + "null" + AFTER)
        self.environment = dict(os.environ, KEMPE_STUDIO=str(self.page))
        self.spec = self.scratch / "plate.toml"
        self.spec.write_text(TEN_LINES)
        self.out = self.scratch / "plate.studio.html"

    def studio(self, *arguments, **options):
        return kempe("studio", *arguments, **{"env": self.environment, **options})

    def inside(self, page):
        """What the page holds, read as a browser does: up to the first end of the element."""
        text = page.read_text(encoding="utf-8")
        self.assertTrue(text.startswith(BEFORE))
        data, rest = text[len(BEFORE):].split("</script", 1)
        self.assertEqual("</script" + rest, AFTER)
        self.assertNotIn("<", data)
        return json.loads(data)

    def test_the_page_lies_beside_the_spec_and_its_path_is_printed(self):
        run = self.studio(self.spec)
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, f"{self.out}\n", ""))
        self.assertEqual(self.inside(self.out), {"name": "plate", "text": TEN_LINES, "files": []})
        run = self.studio(self.spec, "-o", self.scratch / "other.html", "--json")
        self.assertEqual(json.loads(run.stdout), {"page": str(self.scratch / "other.html")})
        self.assertEqual((self.scratch / "other.html").read_bytes(), self.out.read_bytes())

    def test_no_text_leaves_its_place(self):
        text = HOSTILE + TEN_LINES
        spec = self.scratch / "a'\"<b>&雕.toml"
        spec.write_text(text, encoding="utf-8")
        self.assertEqual(self.studio(spec, "-o", self.out).returncode, 0)
        self.assertEqual(self.inside(self.out), {"name": "a'\"<b>&雕", "text": text, "files": []})

    def test_a_page_that_holds_a_spec_takes_another(self):
        self.spec.write_text(HOSTILE + TEN_LINES)
        self.studio(self.spec)
        again = self.scratch / "again.html"
        self.spec.write_text(TEN_LINES)
        run = self.studio(self.spec, "-o", again, env=dict(os.environ, KEMPE_STUDIO=str(self.out)))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.inside(again)["text"], TEN_LINES)

    def test_the_drawing_comes_along(self):
        (self.scratch / "in").mkdir()
        (self.scratch / "in" / "square.svg").write_text(SQUARE.replace("<path", "<!-- </script> \udcff --><path"), errors="surrogateescape")
        self.spec.write_text(re.sub(r"rectangle_mm.*", 'file = "in/square.svg"\nmargin_mm = 1', TEN_LINES) + "[pole]\nat_mm = [90, 0]\n")
        run = self.studio(self.spec)
        self.assertEqual(run.returncode, 0, run.stderr)
        (drawing,) = self.inside(self.out)["files"]
        self.assertEqual(drawing["name"], "square.svg")
        self.assertIn("M1 1H7V7H1Z", drawing["text"])

    def test_without_a_built_page_the_command_that_builds_it_is_named(self):
        run = self.studio(self.spec, env=dict(os.environ, KEMPE_STUDIO=str(self.scratch / "absent.html")))
        self.assertEqual(run.returncode, 1)
        for word in ("scripts/studio", "absent.html", "KEMPE_STUDIO"):
            self.assertIn(word, run.stderr)
        self.assertFalse(self.out.exists())
        self.page.write_text("<p>another page")
        run = self.studio(self.spec, "--json")
        self.assertEqual(run.returncode, 1)
        self.assertIn("no page of the studio", json.loads(run.stdout)["sentence"])
        self.assertFalse(self.out.exists())

    def test_an_installed_program_finds_the_page_beside_itself(self):
        (self.scratch / "prefix" / "bin").mkdir(parents=True)
        share = self.scratch / "prefix" / "share" / "kempe"
        share.mkdir(parents=True)
        moved = self.scratch / "prefix" / "bin" / "kempe"
        shutil.copy(KEMPE, moved)
        environment = {name: value for name, value in os.environ.items() if name != "KEMPE_STUDIO"}

        def run():
            return program.subprocess.run([moved, "studio", self.spec], capture_output=True, text=True, env=environment, timeout=60)

        absent = run()
        self.assertEqual(absent.returncode, 1)
        self.assertIn(f"{share}/studio.html", absent.stderr)
        self.assertNotIn(f"{self.scratch.parent}/out/", absent.stderr)  # no steps into folders of others
        shutil.copy(self.page, share / "studio.html")
        self.assertEqual(run().returncode, 0)
        self.assertEqual(self.inside(self.out)["name"], "plate")

    def test_bad_specs_and_places_write_nothing(self):
        self.spec.write_text("[copy]\nscale = 0\n")
        run = self.studio(self.spec)
        self.assertEqual(run.returncode, 2)
        self.assertIn("copy.scale", run.stderr)
        self.assertFalse(self.out.exists())
        self.spec.write_text(TEN_LINES)
        for clash in (self.spec, self.page):
            before = clash.read_bytes()
            self.assertEqual(self.studio(self.spec, "-o", clash).returncode, 2)
            self.assertEqual(clash.read_bytes(), before)
        self.assertEqual(self.studio(self.spec, "-o", self.scratch).returncode, 5)
        self.assertEqual(sorted(path.name for path in self.scratch.iterdir()), ["built.html", "plate.toml"])

    def test_the_report_leads_to_the_page_that_stands_beside_it(self):
        folder = self.scratch / "design"
        plain = kempe("synthesize", self.spec, "-o", self.scratch / "plain", env=self.environment)
        self.assertEqual(plain.returncode, 0, plain.stderr)
        self.assertNotIn("studio.html", (self.scratch / "plain" / "report.html").read_text())
        run = kempe("synthesize", self.spec, "-o", folder, "--studio", env=self.environment)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn('<a href="studio.html">', (folder / "report.html").read_text())
        self.assertEqual(self.inside(folder / "studio.html")["text"], TEN_LINES)
        absent = dict(os.environ, KEMPE_STUDIO=str(self.scratch / "absent.html"))
        run = kempe("synthesize", self.spec, "-o", self.scratch / "none", "--studio", env=absent)
        self.assertEqual(run.returncode, 1)
        self.assertIn("scripts/studio", run.stderr)
        self.assertFalse((self.scratch / "none").exists())
        run = kempe("synthesize", "--batch", self.scratch, "-o", self.scratch / "none", "--studio", env=self.environment)
        self.assertEqual(run.returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
