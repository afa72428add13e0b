#!/usr/bin/env python3
"""The program under fire: full disks, kills, closed pipes, jumping clocks, strange names, hostile files.

What is asked for everywhere: a file is whole or absent, the exit code tells the truth, and no number is wrong. "Whole" is
checked byte by byte against a run that nothing disturbed.

usage: faults_test.py KEMPE SOURCE_DIR FAULT_SHIM [unittest arguments]
"""
import base64
import contextlib
import csv
import fcntl
import hashlib
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from program import EXAMPLES, KEMPE, SOURCE, TEN_LINES

SHIM = pathlib.Path(sys.argv[3]).resolve()
KILLS = 40
SPEC = TEN_LINES
OTHER_SPEC = SPEC.replace("1.4", "1.7")


def kempe(*arguments, environment=None, **options):
    defaults = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL, "timeout": 600}
    return subprocess.run([KEMPE, *arguments], env={**os.environ, **(environment or {})}, **{**defaults, **options})


def preloaded(**settings):
    """The environment in which the shim brings the fault: at=3 is KEMPE_FAULT_AT=3, fault=... is KEMPE_FAULT."""
    names = {name: "KEMPE_FAULT" + ("" if name == "fault" else "_" + name.upper()) for name in settings}
    return {"LD_PRELOAD": str(SHIM), **{names[name]: str(value) for name, value in settings.items()}}


def contents(folder):
    """Every finished file below a folder; drafts, which only a kill leaves behind, end in .tmp and are no results."""
    folder = pathlib.Path(folder)
    if not folder.is_dir():
        return {}
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file() and p.suffix != ".tmp"}


class Case(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls._home = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls._home.cleanup)
        cls.home = pathlib.Path(cls._home.name)
        cls.spec = cls.home / "spec.toml"
        cls.spec.write_text(SPEC)
        cls.other_spec = cls.home / "other.toml"
        cls.other_spec.write_text(OTHER_SPEC)
        cls.whole = cls.undisturbed(cls.spec)

    @classmethod
    def undisturbed(cls, spec):
        out = cls.home / ("whole-" + spec.stem)
        if not out.exists():
            run = kempe("synthesize", spec, "-o", out, "--quiet")
            assert run.returncode == 0, run.stderr
        return contents(out)

    def setUp(self):
        self._scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self._scratch.cleanup)
        self.scratch = pathlib.Path(self._scratch.name)
        self.out = self.scratch / "out"

    def assertWholeOrAbsent(self, folder, whole=None):
        whole = self.whole if whole is None else whole
        for name, bytes_ in contents(folder).items():
            self.assertIn(name, whole)
            self.assertEqual(bytes_, whole[name], f"{name} is not the file that an undisturbed run writes")

    def assertSameFiles(self, one, other):
        """Names the first line that differs: unittest's own comparison takes minutes for reports."""
        self.assertEqual(sorted(one), sorted(other))
        for name in one:
            for a, b in zip(one[name].splitlines(), other[name].splitlines()):
                if a != b:
                    at = next((i for i, (x, y) in enumerate(zip(a, b)) if x != y), min(len(a), len(b)))
                    self.fail(f"{name}: {a[max(0, at - 60):at + 60]} against {b[max(0, at - 60):at + 60]}")
            self.assertEqual(len(one[name]), len(other[name]), name)

    def assertTold(self, run, code, *words):
        message = run.stderr.decode(errors="replace")
        self.assertEqual(run.returncode, code, message)
        self.assertIn("kempe: ", message)
        for word in words:
            self.assertIn(word, message)


class Kills(Case):
    def calls(self, *arguments):
        """How many calls that change a file this run makes."""
        count = self.scratch / "count"
        run = kempe(*arguments, environment=preloaded(count=count))
        self.assertEqual(run.returncode, 0, run.stderr)
        return int(count.read_text())

    def test_killed_at_every_call_that_writes(self):
        mechanism = EXAMPLES / "report-mechanism.toml"
        reference = self.scratch / "reference"
        calls = self.calls("workspace", mechanism, "-o", reference)
        whole = contents(reference)
        self.assertGreater(calls, len(whole))
        moments = range(1, calls + 1) if calls <= KILLS else sorted({1 + i * (calls - 1) // (KILLS - 1) for i in range(KILLS)})
        for at in moments:
            out = self.scratch / str(at)
            run = kempe("workspace", mechanism, "-o", out, environment=preloaded(fault="kill", at=at))
            self.assertEqual(run.returncode, -signal.SIGKILL, f"call {at}: {run.stderr}")
            self.assertWholeOrAbsent(out, whole)
            shutil.rmtree(out, ignore_errors=True)

    def test_killed_while_old_files_are_replaced_leaves_the_old_or_the_new(self):
        target = self.scratch / "table.csv"
        linkage = EXAMPLES / "linkages" / "slider-crank.toml"
        calls = self.calls("solve", linkage, "-o", target)
        new = target.read_bytes()
        for at in range(1, calls + 1):
            target.write_bytes(b"old")
            run = kempe("solve", linkage, "-o", target, environment=preloaded(fault="kill", at=at))
            self.assertEqual(run.returncode, -signal.SIGKILL)
            self.assertIn(target.read_bytes(), (b"old", new))

    def test_killed_at_random_moments(self):
        chance = random.Random(8)
        began = time.monotonic()
        kempe("synthesize", self.spec, "-o", self.scratch / "timed")
        lasts = time.monotonic() - began
        for _ in range(KILLS):
            process = subprocess.Popen([KEMPE, "synthesize", self.spec, "-o", self.out], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            time.sleep(chance.uniform(0, 1.2 * lasts))
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.assertWholeOrAbsent(self.out)
        run = kempe("synthesize", self.spec, "-o", self.out)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertSameFiles(contents(self.out), self.whole)

    def test_killed_batch_goes_on_with_the_same_bytes(self):
        specs = self.scratch / "specs"
        specs.mkdir()
        for i in range(3):
            (specs / f"{i}.toml").write_text(SPEC.replace("90", str(60 + 20 * i)))
        reference = self.scratch / "reference"
        calls = self.calls("synthesize", "--batch", specs, "-o", reference, "-j", "1")
        whole = {name: (reference / name).read_bytes() for name in ("results.jsonl", "results.csv")}
        for at in range(1, calls + 1):
            out = self.scratch / str(at)
            batch = ("synthesize", "--batch", specs, "-o", out, "-j", "1", "--quiet")
            run = kempe(*batch, environment=preloaded(fault="kill", at=at))
            # Lines that come at once are synchronised at once: a run may make two calls less than the one that was counted.
            self.assertIn(run.returncode, (-signal.SIGKILL,) if at <= calls - 2 else (-signal.SIGKILL, 0))
            for name in set(whole) & set(contents(out)):
                self.assertEqual((out / name).read_bytes(), whole[name])
            self.assertEqual(kempe(*batch).returncode, 0)
            self.assertEqual({name: (out / name).read_bytes() for name in whole}, whole, f"killed at call {at}")


class Disks(Case):
    @contextlib.contextmanager
    def small_disk(self, options):
        """A file system of its own, where this machine lets one be mounted; else nothing."""
        place = self.scratch / "disk"
        place.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", place], capture_output=True)
        try:
            yield place if mounted.returncode == 0 else None
        finally:
            if mounted.returncode == 0:
                subprocess.run(["umount", place], check=True)

    def test_full_disk_at_any_call(self):
        for fault, words in (("full", "No space left on device"), ("readonly", "Read-only file system"),
                             ("broken", "Input/output error")):
            for at in (1, 2, 3, 4, 5, 6, 11, 17, 23):
                with self.subTest(fault=fault, at=at):
                    out = self.scratch / f"{fault}-{at}"
                    run = kempe("workspace", EXAMPLES / "report-mechanism.toml", "-o", out,
                                environment=preloaded(fault=fault, at=at))
                    self.assertTold(run, 5, words)
                    self.assertEqual(contents(out), {})
                    self.assertEqual(list(out.rglob("*.tmp")), [], "drafts are taken away")

    def test_a_disk_that_is_really_full(self):
        with self.small_disk("size=64k") as disk:
            if disk is not None:
                run = kempe("synthesize", self.spec, "-o", disk / "out")
                self.assertTold(run, 5, "No space left on device")
                self.assertEqual([p for p in disk.rglob("*") if p.is_file()], [])

        def files_of_64k_at_most():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 16, 1 << 16))

        run = kempe("synthesize", self.spec, "-o", self.out, preexec_fn=files_of_64k_at_most)
        self.assertTold(run, 5, "File too large")
        self.assertEqual([p for p in self.out.rglob("*") if p.is_file()], [])

    def test_a_folder_that_is_really_read_only(self):
        with self.small_disk("size=1m,ro") as disk:
            if disk is not None:
                run = kempe("synthesize", self.spec, "-o", disk)
                self.assertTold(run, 5, "Read-only file system", str(disk))
        if os.geteuid() != 0:  # root writes where the mode forbids it
            self.out.mkdir(mode=0o555)
            self.assertTold(kempe("synthesize", self.spec, "-o", self.out), 5, "Permission denied")
        in_the_way = self.scratch / "a file"
        in_the_way.write_text("")
        self.assertTold(kempe("synthesize", self.spec, "-o", in_the_way), 5, "a file")
        self.assertEqual(in_the_way.read_bytes(), b"")

    def test_a_folder_stands_where_a_file_should(self):
        (self.out / "design.json").mkdir(parents=True)
        self.assertTold(kempe("synthesize", self.spec, "-o", self.out), 5, "design.json")
        self.assertWholeOrAbsent(self.out)
        self.assertEqual(list(self.out.rglob("*.tmp")), [])

    def test_the_journal_of_a_batch_on_a_full_disk(self):
        specs = self.scratch / "specs.jsonl"
        specs.write_text('{"copy": {"scale": 90}}\n' * 3)
        for at in range(1, 4):
            out = self.scratch / str(at)
            run = kempe("synthesize", "--batch", specs, "-o", out, "-j", "1", "--quiet",
                        environment=preloaded(fault="full", at=at))
            self.assertTold(run, 5, "No space left on device")
            self.assertNotIn("results.jsonl", contents(out))
            run = kempe("synthesize", "--batch", specs, "-o", out, "-j", "1", "--quiet")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(len((out / "results.jsonl").read_text().splitlines()), 3)


class Streams(Case):
    COMMANDS = (
        ("verify", "design.json"),
        ("synthesize", "spec.toml", "-o", "again"),
        ("synthesize", "spec.toml", "-o", "again", "--json"),
        ("solve", EXAMPLES / "linkages" / "slider-crank.toml"),
        ("mobility", EXAMPLES / "linkages" / "hart.toml"),
        ("function", EXAMPLES / "generators" / "logarithm.toml"),
        ("--help",),
    )

    def check_all(self, check, **options):
        """Runs every command with these streams; `check` looks at each run."""
        for command in self.COMMANDS:
            folder = pathlib.Path(tempfile.mkdtemp(dir=self.scratch))
            (folder / "design.json").write_bytes(self.whole["design.json"])
            (folder / "spec.toml").write_text(SPEC)
            with self.subTest(command=command[0]):
                run = kempe(*command, cwd=folder, **options)
                self.assertWholeOrAbsent(folder / "again")
                check(run)

    def test_nobody_reads_stdout(self):
        for ignored in (False, True):
            def before():
                signal.signal(signal.SIGPIPE, signal.SIG_IGN if ignored else signal.SIG_DFL)

            reader, writer = os.pipe()
            os.close(reader)
            try:
                allowed = (5,) if ignored else (5, -signal.SIGPIPE)
                self.check_all(lambda run: self.assertIn(run.returncode, allowed, run.stderr), stdout=writer,
                               preexec_fn=before, restore_signals=False)
            finally:
                os.close(writer)

    def test_stdout_is_a_full_disk(self):
        with open("/dev/full", "wb") as full:
            self.check_all(lambda run: self.assertTold(run, 5, "stdout"), stdout=full)

    def test_stdout_is_closed(self):
        self.check_all(lambda run: self.assertTold(run, 5, "stdout"), stdout=None, preexec_fn=lambda: os.close(1))

    def test_all_three_streams_are_closed(self):
        self.check_all(lambda run: self.assertEqual(run.returncode, 5), stdout=None, stderr=None,
                       preexec_fn=lambda: os.closerange(0, 3))

    def test_nothing_that_is_printed_lands_in_a_file(self):
        specs = self.scratch / "specs.jsonl"
        specs.write_text('{"copy": {"scale": 90}}\n')
        reference = self.scratch / "reference"
        self.assertEqual(kempe("synthesize", "--batch", specs, "-o", reference, "-j", "1").returncode, 0)
        for first, last in ((1, 1), (2, 2), (1, 2), (0, 2)):
            with self.subTest(closed=(first, last)):
                out = self.scratch / f"{first}-{last}"
                run = kempe("synthesize", "--batch", specs, "-o", out, "-j", "1", stdin=None, stdout=None, stderr=None,
                            preexec_fn=lambda: os.closerange(first, last + 1))
                self.assertIn(run.returncode, (0,) if first == 2 else (5,))
                self.assertSameFiles(contents(out), contents(reference))


class Surroundings(Case):
    def assertSameDesign(self, **options):
        run = kempe("synthesize", self.spec, "-o", self.out, **options)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertSameFiles(contents(self.out), self.whole)

    def test_a_calendar_that_jumps(self):
        self.assertSameDesign(environment=preloaded(clock="jumps"))

    def test_a_steady_clock_that_leaps(self):
        self.assertSameDesign(environment=preloaded(clock="leaps"))

    def german(self):
        """The environment of a German user: decimal commas, dots between thousands."""
        places = self.scratch / "locales"
        if not places.exists():
            places.mkdir()
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", places / "de_DE.UTF-8"], check=True, capture_output=True)
        return {"LOCPATH": str(places), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}

    def test_the_german_locale_is_really_there(self):
        script = 'import locale; locale.setlocale(locale.LC_ALL, ""); print(locale.localeconv()["decimal_point"])'
        run = subprocess.run([sys.executable, "-c", script], env={**os.environ, **self.german()}, capture_output=True, text=True)
        self.assertEqual(run.stdout.strip(), ",", run.stderr)

    def test_decimal_commas_change_nothing(self):
        self.assertSameDesign(environment=self.german())

    def test_decimal_commas_change_nothing_even_where_the_host_program_asks_for_them(self):
        self.assertSameDesign(environment={**self.german(), **preloaded(locale=1)})

    def test_no_reader_and_no_writer_obeys_the_locale(self):
        environment = {**self.german(), **preloaded(locale=1)}
        corpus = SOURCE / "tests" / "corpus"
        design = self.scratch / "design.json"
        design.write_bytes(self.whole["design.json"])
        drawing = self.scratch / "drawing.svg"
        drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">'
                           '<path d="M62.5 99.25 C 64.5 98.5 66.25 99.5 68.125 99.25"/></svg>')
        region = self.scratch / "region.toml"
        commands = [("verify", design),
                    ("trace", design, drawing, "-o", "copy.svg", "--csv", "poses.csv", "--json"),
                    ("function", EXAMPLES / "generators" / "logarithm.toml"),
                    ("inversor", EXAMPLES / "generators" / "enlarger.toml"),
                    ("calibrate", EXAMPLES / "calibration" / "knight.toml", "-o", "calibration"),
                    ("solve", EXAMPLES / "linkages" / "shear-press.toml", "-o", "t.csv", "--animate", "t.html", "--velocities"),
                    ("mobility", EXAMPLES / "linkages" / "watt-six-bar.toml"),
                    ("centres", EXAMPLES / "linkages" / "watt-six-bar.toml", "--at", "0")]
        for reader in ("svg", "dxf", "geojson"):
            for n, file in enumerate(sorted((corpus / reader).glob("*." + reader))):
                spec = self.scratch / f"{reader}-{n}.toml"
                shutil.copy(file, self.scratch)
                spec.write_text(SPEC.replace("rectangle_mm = {at = [60, -5], size = [10, 10]}", f'file = {json.dumps(file.name)}')
                                + '[mechanism]\nvertex = "pole"\nVA_mm = 50\nVB_mm = 35\n[pole]\nat_mm = [0, 0]\n')
                commands.append(("workspace", spec, "-o", "map"))
        for command in commands:
            with self.subTest(command=[str(part) for part in command[:2]]):
                results = []
                for surroundings in ({}, environment):
                    folder = pathlib.Path(tempfile.mkdtemp(dir=self.scratch))
                    run = kempe(*command, environment=surroundings, cwd=folder)
                    results.append((run.returncode, run.stdout, run.stderr, contents(folder)))
                plain, german = results
                self.assertEqual(plain[0], german[0], german[2])
                self.assertSameFiles({"stdout": plain[1], "stderr": plain[2], **plain[3]},
                                     {"stdout": german[1], "stderr": german[2], **german[3]})

    NAMES = ("gravür.toml", "雕刻 板.toml", "نقش.toml", "гравёр.toml", "לוח.toml", "नक़्शा.toml", "🖋️.toml", "a\nb\tc.toml",
             "quote'\"<&>.toml", "percent%s%n{}.toml", "-o.toml", "e\u0301 against é.toml", b"not \xff\xfe utf-8.toml", "x" * 200 + ".toml")

    def test_file_names_in_any_script(self):
        for name in self.NAMES:
            with self.subTest(name=name):
                folder = os.fsencode(self.scratch / "names")
                shutil.rmtree(folder, ignore_errors=True)
                os.mkdir(folder)
                spec = os.path.join(folder, os.fsencode(name))
                shutil.copy(self.spec, spec)
                out = spec + b".out"
                run = kempe("synthesize", spec, "-o", out, "--json")
                self.assertEqual(run.returncode, 0, run.stderr)
                json.loads(run.stdout.decode())
                found = contents(os.fsdecode(out))
                self.assertEqual(found["design.json"], self.whole["design.json"])
                found["report.html"].decode()
                run = kempe("verify", os.path.join(out, b"design.json"), "--json")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertTrue(json.loads(run.stdout.decode())["certified"])
                run = kempe("verify", spec)
                self.assertTold(run, 2)

    def test_a_batch_of_files_with_any_name(self):
        specs = os.fsencode(self.scratch / "specs")
        os.mkdir(specs)
        for name in self.NAMES:
            pathlib.Path(os.fsdecode(os.path.join(specs, os.fsencode(name)))).write_text("[copy]\nscale = -1\n")
        run = kempe("synthesize", "--batch", specs, "-o", self.out, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = (self.out / "results.jsonl").read_text(encoding="utf-8").splitlines()
        self.assertEqual([json.loads(line)["status"] for line in lines], ["bad input"] * len(self.NAMES))
        names = {json.loads(line)["name"] for line in lines}
        self.assertLessEqual({name for name in self.NAMES if isinstance(name, str)}, names)


class Company(Case):
    def test_two_runs_into_one_folder_leave_the_files_of_one(self):
        both = {"spec": self.whole, "other": self.undisturbed(self.other_spec)}
        slowly = preloaded(slow_rename_ms=20)
        for _ in range(4):
            runs = [subprocess.Popen([KEMPE, "synthesize", spec, "-o", self.out, "-j", "1"], stdout=subprocess.DEVNULL,
                                     env={**os.environ, **slowly}) for spec in (self.spec, self.other_spec)]
            self.assertEqual([run.wait() for run in runs], [0, 0])
            found = contents(self.out)
            self.assertTrue(found in both.values(), "a folder with files of both runs")
            self.assertEqual(list(self.out.rglob("*.tmp")), [])

    def test_two_batches_into_one_folder(self):
        specs = self.scratch / "specs"
        specs.mkdir()
        for i in range(3):
            (specs / f"{i}.toml").write_text(SPEC.replace("90", str(60 + 20 * i)))
        batch = [KEMPE, "synthesize", "--batch", specs, "-j", "1", "--quiet", "-o"]
        subprocess.run([*batch, self.scratch / "reference"], check=True, stdout=subprocess.DEVNULL)
        runs = [subprocess.Popen([*batch, self.out], stdout=subprocess.DEVNULL) for _ in range(2)]
        self.assertEqual([run.wait() for run in runs], [0, 0])
        for name in ("results.jsonl", "results.csv"):
            self.assertEqual((self.out / name).read_bytes(), (self.scratch / "reference" / name).read_bytes())


class Hostile(Case):
    READERS = {"synthesize": ("-o", "out"), "workspace": ("-o", "out"), "verify": (), "solve": (), "mobility": (),
               "centres": ("--at", "0"), "calibrate": (), "function": (), "inversor": (), "path": ()}

    def assertRefusedByAll(self, file):
        for command, options in self.READERS.items():
            with self.subTest(command=command, file=str(file)[:60]):
                folder = pathlib.Path(tempfile.mkdtemp(dir=self.scratch))
                run = kempe(command, file, *options, cwd=folder, timeout=120)
                self.assertTold(run, 2)
                self.assertEqual(contents(folder), {})

    def test_bytes_that_are_no_input(self):
        deep = 200_000
        inputs = {"empty": b"", "zeros": bytes(4096), "noise": random.Random(8).randbytes(4096), "bytes": bytes(range(256)) * 20,
                  "brackets": b"a = " + b"[" * deep, "tables": b"[" * deep, "braces": b"a = " + b"{a=" * deep,
                  "json": b'{"format":' * deep, "json-array": b"[" * deep + b"]" * deep, "quotes": b'"' * deep,
                  "dots": b"a" + b".a" * deep + b" = 1", "line": b"a" * 2_000_000, "bom": b"\xef\xbb\xbf", "utf-16": SPEC.encode("utf-16"),
                  "surrogate": b'a = "\xed\xa0\x80"', "many": b"a = 1\n" * 10_000}
        for name, bytes_ in inputs.items():
            file = self.scratch / name
            file.write_bytes(bytes_)
            self.assertRefusedByAll(file)

    def test_files_that_are_no_files(self):
        loop = self.scratch / "loop"
        loop.symlink_to(loop)
        for file in (self.scratch, self.scratch / "absent", "/dev/null", "/dev/zero", loop, "", "x" * 5000):
            self.assertRefusedByAll(file)

    def test_regions_that_are_no_drawings(self):
        deep = 100_000
        drawings = {"a.svg": b"", "b.svg": b"<svg>" * deep, "c.svg": b"<svg><path d='M" + b"0" * 100_000 + b"'/></svg>",
                    "d.svg": b'<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h1e308v1e308h-1e308z"/></svg>',
                    "e.dxf": b"", "f.dxf": b"0\nSECTION\n2\nENTITIES\n" + b"0\nLINE\n" * 10_000, "g.dxf": b"999\n" * 100_000,
                    "h.geojson": b"", "i.geojson": b'{"type":"Polygon","coordinates":' + b"[" * deep,
                    "j.geojson": b'{"type":"Polygon","coordinates":[[[1e999,0],[1,0],[1,1],[1e999,0]]]}',
                    "k.geojson": b"[" * deep + b"]" * deep, "l.txt": b"", "m.svg": b"<!DOCTYPE svg [<!ENTITY a 'a'>]><svg>&a;</svg>"}
        for name, bytes_ in drawings.items():
            with self.subTest(name):
                (self.scratch / name).write_bytes(bytes_)
                spec = self.scratch / "spec.toml"
                spec.write_text(SPEC.replace("rectangle_mm = {at = [60, -5], size = [10, 10]}", f'file = "{name}"'))
                self.assertTold(kempe("synthesize", spec, "-o", self.out, timeout=120), 2)
                self.assertEqual(contents(self.out), {})

    def test_a_spec_from_a_pipe_is_read_once(self):
        run = kempe("synthesize", "/dev/stdin", "-o", self.out, stdin=None, input=SPEC.encode())
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(contents(self.out)["design.json"], self.whole["design.json"])
        self.assertIn(b"rotation_deg = 90", contents(self.out)["report.html"])


class Batches(Case):
    """Bad lines, forged and damaged journals: what is bad is said and done again, the rest stands."""

    def batch(self, source, out=None, **options):
        return kempe("synthesize", "--batch", source, "-o", out or self.out, "-j", "1", **options)

    def lines(self, *lines):
        source = self.scratch / "specs.jsonl"
        source.write_text("".join(line + "\n" for line in lines))
        return source

    def results(self):
        return [json.loads(line) for line in (self.out / "results.jsonl").read_text().splitlines()]

    SPEC_LINE = json.dumps({"copy": {"scale": 1.4, "rotation_deg": 90},
                            "region": {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}},
                            "links": {"width_mm": 6, "pin_diameter_mm": 3}})

    def test_an_errors_text_never_becomes_a_spec(self):
        inside = json.dumps(SPEC)[1:-1]
        link = self.scratch / "specs" / f"{SPEC[:100]}.toml".replace("/", "")
        link.parent.mkdir()
        link.symlink_to(self.scratch / ("absent\n" + SPEC.replace("/", "")[:120]))
        run = self.batch(self.lines(f'{{"x{inside}#": null}}', f'{{"x{inside}": }}', '{"copy": 1, "copy": 2}'))
        self.assertEqual(run.returncode, 0, run.stderr)
        statuses = [(line["status"], line["message"]) for line in self.results()]
        self.assertEqual([status for status, _ in statuses], ["bad input"] * 3)
        self.assertIn("null", statuses[0][1])
        self.assertIn("twice", statuses[2][1])
        run = self.batch(link.parent, self.scratch / "linked")
        self.assertEqual(run.returncode, 0, run.stderr)
        result = json.loads((self.scratch / "linked" / "results.jsonl").read_text())
        self.assertEqual(result["status"], "bad input")
        self.assertIn("no such file", result["message"])

    def test_a_fault_names_the_line_of_the_batch_alone(self):
        wide = self.SPEC_LINE.replace('"pin_diameter_mm": 3', '"pin_diameter_mm": 30')
        self.assertEqual(self.batch(self.lines(self.SPEC_LINE.replace("scale", "size"), wide)).returncode, 0)
        for number, line in enumerate(self.results(), 1):
            self.assertRegex(line["message"], rf"^line-{number}: (copy|links)\.")

    def test_depth_has_a_limit(self):
        deep = 30_000
        run = self.batch(self.lines('{"a": ' + "[" * deep + "]" * deep + "}", '{"a": ' + '{"a": ' * deep + "1" + "}" * deep + "}",
                                    self.SPEC_LINE))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual([line["status"] for line in self.results()], ["bad input", "bad input", "design"])
        self.assertIn("64", self.results()[0]["message"])

    def test_a_journal_is_input(self):
        source = self.lines(self.SPEC_LINE, self.SPEC_LINE.replace("1.4", "1.7"))
        self.assertEqual(self.batch(source).returncode, 0)
        whole = (self.out / "results.jsonl").read_bytes()
        journal = self.out / "journal-0.jsonl"
        records = [json.loads(line) for line in journal.read_text().splitlines()]
        forged = {
            "no JSON": {**records[0], "result": "not json"}, "a list": {**records[0], "result": "[]"},
            "a word": {**records[0], "result": '{"status": "design"}'}, "no text": {**records[0], "result": 3},
            "another's": {**records[0], "result": records[1]["result"]}, "nothing": {}}
        for name, record in forged.items():
            with self.subTest(name):
                journal.write_text(json.dumps(record) + "\n" + json.dumps(records[1]) + "\n")
                run = self.batch(source)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertEqual((self.out / "results.jsonl").read_bytes(), whole)
                self.assertIn(b"journal-0.jsonl:1", run.stderr)
        for end in range(0, len(json.dumps(records[0])), 97):
            journal.write_text(json.dumps(records[1]) + "\n" + json.dumps(records[0])[:end])
            self.assertEqual(self.batch(source, ).returncode, 0)
            self.assertEqual((self.out / "results.jsonl").read_bytes(), whole)
        for noise in (b"\xff\xfe\n", b"[" * 100_000 + b"\n", b"\0" * 1000):
            journal.write_bytes(noise)
            self.assertEqual(self.batch(source).returncode, 0)
            self.assertEqual((self.out / "results.jsonl").read_bytes(), whole)

    def test_a_journal_of_another_version_is_refused(self):
        def check(*texts):  # FNV-1a, 64 bit
            value = 0xCBF29CE484222325
            for byte in "\n".join(texts).encode():
                value = (value ^ byte) * 0x100000001B3 % 2**64
            return f"{value:016x}"
        source = self.lines(self.SPEC_LINE)
        self.assertEqual(self.batch(source).returncode, 0)
        whole = (self.out / "results.jsonl").read_bytes()
        journal = self.out / "journal-0.jsonl"
        ours = journal.read_text()
        record = json.loads(ours)
        self.assertEqual(record["check"], check(record["version"], record["key"], record["result"]))
        unversioned = {"key": record["key"], "result": record["result"], "check": check(record["key"], record["result"])}
        later = {"version": "kempe-batch/3 9.0", "key": record["key"], "result": record["result"],
                 "check": check("kempe-batch/3 9.0", record["key"], record["result"])}
        for name, said, other in (("older", "older versions", unversioned), ("later", "kempe-batch/3 9.0", later)):
            for file, number in (("journal-0.jsonl", 2), ("journal-4.jsonl", 1)):
                with self.subTest(name, file=file):
                    (self.out / "results.jsonl").write_bytes(b"before\n")
                    before = ours if file == "journal-0.jsonl" else ""
                    (self.out / file).write_text(before + json.dumps(other) + "\n")
                    self.assertTold(self.batch(source), 2, f"{file}:{number}", "version", said, record["version"])
                    self.assertEqual((self.out / "results.jsonl").read_bytes(), b"before\n")
                    (self.out / file).unlink()
                    journal.write_text(ours)
        self.assertEqual(self.batch(source).returncode, 0)
        self.assertEqual((self.out / "results.jsonl").read_bytes(), whole)

    def test_a_journal_is_a_regular_file(self):
        source = self.lines(self.SPEC_LINE)
        elsewhere = self.scratch / "elsewhere"
        elsewhere.write_text("kept\n")
        self.out.mkdir()
        (self.out / "journal-0.jsonl").symlink_to(elsewhere)
        self.assertTold(self.batch(source), 5, "journal-0.jsonl", "link")
        self.assertEqual(elsewhere.read_text(), "kept\n")
        (self.out / "journal-0.jsonl").unlink()
        os.mkfifo(self.out / "journal-0.jsonl")
        self.assertTold(self.batch(source, timeout=60), 5, "journal-0.jsonl")
        (self.out / "journal-0.jsonl").rename(self.out / "journal-7.jsonl")  # another's, which is passed over
        self.assertEqual(self.batch(source, timeout=60).returncode, 0)

    def test_tables_hold_texts_and_no_formulas(self):
        specs = self.scratch / "specs"
        specs.mkdir()
        for name in ("=cmd|'a'!A1.toml", "+1.toml", "-1.toml", "@x.toml"):
            (specs / name).write_text("")
        self.assertEqual(self.batch(specs).returncode, 0)
        with open(self.out / "results.csv", newline="") as table:
            names = [row["name"] for row in csv.DictReader(table)]
        self.assertEqual(sorted(names), sorted(["'=cmd|'a'!A1.toml", "'+1.toml", "'-1.toml", "'@x.toml"]))


class NotOurs(Case):
    """Devices, pipes, links, inputs: what is not the run's own is left as it is."""

    LINKAGE = EXAMPLES / "linkages" / "slider-crank.toml"

    def setUp(self):
        super().setUp()
        self.table = self.scratch / "reference.csv"
        self.assertEqual(kempe("solve", self.LINKAGE, "-o", self.table).returncode, 0)

    def test_a_device_stays_a_device(self):
        null = self.scratch / "null"
        try:
            os.mknod(null, stat.S_IFCHR | 0o666, os.makedev(1, 3))
        except PermissionError:
            null.symlink_to("/dev/null")
        self.assertEqual(kempe("solve", self.LINKAGE, "-o", null).returncode, 0)
        self.assertTrue(stat.S_ISCHR(os.stat(null).st_mode))
        full = self.scratch / "full"
        full.symlink_to("/dev/full")
        self.assertTold(kempe("solve", self.LINKAGE, "-o", full), 5, "No space left on device")
        self.assertTrue(full.is_symlink())

    def test_a_pipe_is_written_to(self):
        pipe = self.scratch / "pipe"
        os.mkfifo(pipe)
        reader = subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE)
        self.assertEqual(kempe("solve", self.LINKAGE, "-o", pipe).returncode, 0)
        self.assertEqual(reader.communicate(timeout=60)[0], self.table.read_bytes())
        self.assertTrue(stat.S_ISFIFO(os.stat(pipe).st_mode))

    def test_the_name_of_an_open_file(self):
        for name in ("/dev/stdout", "/proc/self/fd/1", "/dev/fd/1"):
            with self.subTest(name), open(self.out, "wb") as out:
                run = kempe("solve", self.LINKAGE, "-o", name, stdout=out)
                self.assertEqual(run.returncode, 0, run.stderr)
            self.assertTrue(self.out.read_bytes().startswith(self.table.read_bytes()))

    def test_pipes_and_locks_are_not_waited_for_without_a_word(self):
        pipe = self.scratch / "pipe"
        os.mkfifo(pipe)
        self.assertTold(kempe("solve", self.LINKAGE, "-o", pipe, timeout=60), 5, "a pipe without a reader")
        self.assertTold(kempe("synthesize", pipe, "-o", self.out, timeout=60), 2, "a pipe without data")
        self.out.mkdir()
        holder = os.open(self.out, os.O_RDONLY)
        fcntl.flock(holder, fcntl.LOCK_EX)
        self.assertTold(kempe("synthesize", self.spec, "-o", self.out, timeout=120), 5, "locked")
        os.close(holder)
        self.assertEqual(contents(self.out), {})

    def test_a_link_stays_a_link_and_a_mode_stays(self):
        target = self.scratch / "target.csv"
        target.write_text("old")
        target.chmod(0o600)
        link = self.scratch / "link.csv"
        link.symlink_to("target.csv")
        self.assertEqual(kempe("solve", self.LINKAGE, "-o", link).returncode, 0)
        self.assertTrue(link.is_symlink())
        self.assertEqual(target.read_bytes(), self.table.read_bytes())
        self.assertEqual(stat.S_IMODE(target.stat().st_mode), 0o600)

    def test_names_as_long_as_the_system_takes(self):
        for length in (240, 249, 255):
            long = self.scratch / ("x" * (length - 4) + ".csv")
            run = kempe("solve", self.LINKAGE, "-o", long)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(long.read_bytes(), self.table.read_bytes())

    def test_an_output_is_neither_an_input_nor_another_output(self):
        linkage, spec = self.scratch / "linkage.toml", self.scratch / "spec.toml"
        shutil.copy(self.LINKAGE, linkage)
        design, drawing = self.scratch / "design.json", self.scratch / "drawing.svg"
        design.write_bytes(self.whole["design.json"])
        drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="72mm" height="72mm" viewBox="0 0 72 72">'
                           '<path d="M62 62h4v4h-4z"/></svg>')
        spec.write_text(SPEC.replace("rectangle_mm = {at = [60, -5], size = [10, 10]}", 'file = "drawing.svg"'))
        hard = self.scratch / "hard.toml"
        os.link(linkage, hard)
        lines = self.scratch / "results.jsonl"
        lines.write_text("{}\n")
        before = contents(self.scratch)
        for command in (("solve", linkage, "-o", linkage), ("solve", linkage, "-o", hard),
                        ("solve", linkage, "-o", self.scratch / "." / "new.svg", "--animate", self.scratch / "new.svg"),
                        ("trace", design, drawing, "-o", design), ("trace", design, drawing, "-o", drawing),
                        ("trace", design, drawing, "-o", "new", "--csv", "new"),
                        ("centres", linkage, "--at", "0", "-o", linkage),
                        ("function", EXAMPLES / "generators" / "logarithm.toml", "--plot", EXAMPLES / "generators" / "logarithm.toml"),
                        ("synthesize", spec, "-o", self.scratch), ("synthesize", "--batch", lines, "-o", self.scratch)):
            with self.subTest(command=[str(part) for part in command]):
                self.assertTold(kempe(*command, cwd=self.scratch), 2)
                self.assertEqual(contents(self.scratch), before)


class Limits(Case):
    """Limits of the system, as a shell leaves the signals."""

    def test_files_no_larger_than_the_shell_allows(self):
        before = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 16, 1 << 16))
        run = kempe("synthesize", self.spec, "-o", self.out, preexec_fn=before)
        self.assertTold(run, 5, "File too large")
        self.assertEqual([p for p in self.out.rglob("*") if p.is_file()], [])

    def test_threads_that_cannot_be_made(self):
        own_alone = {"OPENBLAS_NUM_THREADS": "1"}  # where Ipopt's BLAS is OpenBLAS, it ends a program that cannot have its threads
        run = kempe("synthesize", self.spec, "-o", self.out, "-j", "8", environment={**preloaded(threads=0), **own_alone})
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertSameFiles(contents(self.out), self.whole)
        specs = self.scratch / "specs.jsonl"
        specs.write_text(Batches.SPEC_LINE + "\n")
        run = kempe("synthesize", "--batch", specs, "-o", self.scratch / "batch", "-j", "8",
                    environment={**preloaded(threads=1), **own_alone})
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_numbers_that_are_none(self):
        for number in ("nan", "inf", "-inf", "-1", "1e999", "0x"):
            with self.subTest(number):
                self.assertEqual(kempe("synthesize", self.spec, "-o", self.out, "--time-limit", number).returncode, 2)
                self.assertEqual(kempe("workspace", self.spec, "--why", number, number).returncode, 2)
        for number in ("nan", "inf"):
            drawing = self.scratch / "drawing.svg"
            drawing.write_text("<svg/>")
            (self.scratch / "design.json").write_bytes(self.whole["design.json"])
            run = kempe("trace", "design.json", drawing, "-o", "copy.svg", "--at", number, number, cwd=self.scratch)
            self.assertEqual(run.returncode, 2, run.stderr)


class Words(Case):
    """What comes from outside cannot move, colour or forge what a person reads."""

    NASTY = "\x1b[31mred\x1b[0m\u202egnp.exe\u2028\u200b\x07"

    def assertPlain(self, text):
        for character in ("\x1b", "\u202e", "\u2028", "\u200b", "\x07"):
            self.assertNotIn(character, text)

    def test_names_are_shown_written_out(self):
        nasty = self.scratch / (self.NASTY + "\nverified     forged.toml")
        nasty.write_text("x = 1\n")
        for command in (("synthesize", nasty, "-o", self.out), ("verify", nasty), ("solve", nasty), ("calibrate", nasty),
                        ("function", nasty), ("synthesize", self.scratch / ("absent" + nasty.name), "-o", self.out),
                        (self.NASTY,), ("synthesize", "--" + self.NASTY)):
            run = kempe(*command)
            self.assertEqual(run.returncode, 2)
            text = run.stderr.decode() + run.stdout.decode()
            self.assertPlain(text)
            self.assertFalse(any(line.startswith("verified") for line in text.splitlines()), text)
        folder = self.scratch / (self.NASTY + "\nverified     forged")
        run = kempe("synthesize", self.spec, "-o", folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertPlain(run.stdout.decode())
        self.assertEqual(sum(line.startswith("verified") for line in run.stdout.decode().splitlines()), 1)

    def test_an_obstacles_name_is_one_line(self):
        spec = self.scratch / "spec.toml"
        name = json.dumps(self.NASTY + "\nverified     1 position", ensure_ascii=True)
        spec.write_text(SPEC + f"[[obstacles]]\nname = {name}\npolygon_mm = [[-2000, -2000], [2000, -2000], [2000, 2000], [-2000, 2000]]\n")
        run = kempe("synthesize", spec, "-o", self.out)
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertPlain(run.stderr.decode())
        self.assertIn("\\nverified", run.stderr.decode())
        self.assertFalse(any(line.startswith("verified") for line in run.stderr.decode().splitlines()))

    def test_every_page_has_the_same_policy(self):
        page = self.scratch / "page.html"
        run = kempe("solve", EXAMPLES / "linkages" / "slider-crank.toml", "--animate", page, "-o", self.scratch / "t.csv")
        self.assertEqual(run.returncode, 0, run.stderr)
        for text in (page.read_text(), self.whole["report.html"].decode()):
            policy = re.search(r'Content-Security-Policy" content="([^"]*)"', text)[1]
            self.assertNotIn("unsafe", policy)
            self.assertIn("default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; style-src 'sha256-", policy)
            for tag in ("style", "script"):
                for body in re.findall(rf"<{tag}>(.*?)</{tag}>", text, re.S):
                    self.assertIn(base64.b64encode(hashlib.sha256(body.encode()).digest()).decode(), policy)
            elements = re.sub(r"<script>.*?</script>", "", text, flags=re.S)
            self.assertIsNone(re.search(r'<[^>]* style="', elements))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]], verbosity=1)
