#!/usr/bin/env python3
"""Batches of any length: sweeps, kills at any moment, and memory that does not grow.

usage: batch_test.py KEMPE
"""
import collections
import csv
import itertools
import json
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

KEMPE = str(pathlib.Path(sys.argv.pop(1)).resolve())
SPEC = {"copy": {"scale": 1.4, "rotation_deg": 90}, "region": {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}},
        "pole": {"at_mm": [0, 0]}, "links": {"width_mm": 6, "pin_diameter_mm": 3}}
RESULTS = ("results.jsonl", "results.csv")


def with_value(spec, key, value):
    """A copy of a spec with one key set."""
    first, _, rest = key.partition(".")
    return {**spec, first: with_value(spec.get(first, {}), rest, value) if rest else value}


class Case(unittest.TestCase):
    def setUp(self):
        # Of files in memory, where there are such: a disk that synchronises slowly would only make the test last longer.
        memory = pathlib.Path("/dev/shm")
        scratch = tempfile.TemporaryDirectory(dir=memory if os.access(memory, os.W_OK) else None)
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)

    def command(self, source, out, *options):
        return [KEMPE, "synthesize", "--batch", str(source), "-o", str(out), "--quiet", *map(str, options)]

    def run_batch(self, source, out, *options):
        run = subprocess.run(self.command(source, out, *options), capture_output=True, text=True, timeout=900)
        self.assertEqual(run.returncode, 0, run.stderr)
        return {name: (out / name).read_bytes() for name in RESULTS}

    def refused(self, source, *words):
        run = subprocess.run(self.command(source, self.scratch / "refused"), capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 2, run.stderr)
        for word in (str(source), *words):
            self.assertIn(word, run.stderr)
        self.assertFalse((self.scratch / "refused").exists())

    def lines(self, specs, name="specs.jsonl"):
        file = self.scratch / name
        with open(file, "w") as stream:
            stream.writelines((one if isinstance(one, str) else json.dumps(one)) + "\n" for one in specs)
        return file

    def sweep(self, spec, axes, name="sweep.json"):
        file = self.scratch / name
        file.write_text(json.dumps({"spec": spec, "axes": [{"key": key, "values": values} for key, values in axes]}))
        return file

    def journal_keys(self, out):
        """The keys of all whole lines."""
        keys = []
        for path in out.glob("journal-*.jsonl"):
            for line in path.read_bytes().splitlines(keepends=True):
                if line.endswith(b"}\n"):
                    keys.append(json.loads(line)["key"])
        return keys


class Sweeps(Case):
    def test_cells_mean_what_the_same_lines_mean(self):
        axes = [("copy.scale", [0.7, 1.4]), ("region", [SPEC["region"], {"circle_mm": {"centre": [70, 0], "radius": 6}}]),
                ("links.width_mm", [6, 8, -1])]
        cells = list(itertools.product(*(enumerate(values, 1) for _, values in axes)))
        specs, names = [], []
        for cell in cells:
            spec = SPEC
            for (key, _), (_, value) in zip(axes, cell):
                spec = with_value(spec, key, value)
            specs.append(spec)
            names.append("cell-" + "-".join(str(place) for place, _ in cell))
        swept = self.run_batch(self.sweep(SPEC, axes), self.scratch / "swept", "-j", 2)
        listed = self.run_batch(self.lines(specs), self.scratch / "listed", "-j", 1)
        swept, listed = ([json.loads(line) for line in one["results.jsonl"].splitlines()] for one in (swept, listed))
        self.assertEqual([one["name"] for one in swept], names)
        for one, other in zip(swept, listed, strict=True):
            for result in (one, other):
                if "message" in result:
                    result["message"] = result["message"].replace(result["name"], "")
                del result["name"]
            self.assertEqual(one, other)
        states = collections.Counter(one["status"] for one in swept)
        self.assertEqual(states["bad input"], 4)
        self.assertGreater(states["design"], 4)

    def test_a_key_that_the_spec_lacks_is_added(self):
        without = {key: value for key, value in SPEC.items() if key != "copy"}
        axes = [("copy.scale", [1.4]), ("copy.rotation_deg", [90])]
        swept = self.run_batch(self.sweep(without, axes), self.scratch / "swept")
        listed = self.run_batch(self.lines([SPEC]), self.scratch / "listed")
        self.assertEqual(swept["results.jsonl"].replace(b"cell-1-1", b"line-1"), listed["results.jsonl"])

    def test_what_is_no_sweep_is_refused(self):
        file = self.scratch / "no.json"
        for text in ("", "[]", json.dumps(SPEC), '{"spec": 1, "axes": []}', '{"spec": {}, "axes": {}}',
                     '{"spec": {}, "axes": [], "more": 1}', '{"spec": {}, "spec": {}, "axes": []}'):
            with self.subTest(text):
                file.write_text(text)
                self.refused(file)
        for axes, words in (([("copy.scale", [])], ("axes[1]", "not empty")), ([("copy..scale", [1])], ("axes[1].key",)),
                            ([("", [1])], ("axes[1].key",)), ([("copy.scale.x", [1])], ('"scale" is no table',)),
                            ([("copy.scale", [1]), ("copy.scale", [2])], ("axes[2].key",)),
                            ([("links.width_mm", [1]), ("links", [{}])], ("axes[2].key", "links.width_mm")),
                            ([(f"a.x{i}", [1] * 100) for i in range(5)], ("cells", "fewer"))):
            with self.subTest(axes[0][0]):
                self.refused(self.sweep(SPEC, axes), *words)


class Figures(Case):
    def test_the_copy_error_of_the_tolerances_stands_beside_the_solvers(self):
        loose = {**SPEC, "tolerance": {"length_mm": 1.5, "play_mm": 0.05}}
        lines = self.lines([SPEC, loose])
        found = self.run_batch(lines, self.scratch / "out")
        exact, toleranced = (json.loads(line) for line in found["results.jsonl"].splitlines())
        design = json.loads((OneOfMany.design(self, lines, "line-2") / "design.json").read_text())["quality"]
        for name in ("copy_error_worst_mm", "copy_error_at_corner_mm"):
            self.assertNotIn(name, exact)
            self.assertEqual(toleranced[name], design[name])
        self.assertLess(toleranced["copy_error_max_mm"], 1e-9)
        rows = list(csv.DictReader(found["results.csv"].decode().splitlines()))
        self.assertEqual([row["copy_error_worst_mm"] for row in rows], ["", str(toleranced["copy_error_worst_mm"])])
        self.assertEqual([row["copy_error_at_corner_mm"] for row in rows], ["", str(toleranced["copy_error_at_corner_mm"])])


class OneOfMany(Case):
    def design(self, source, name, *options):
        out = self.scratch / f"only-{name}"
        run = subprocess.run([*self.command(source, out, *options), "--only", name], capture_output=True, text=True, timeout=600)
        self.assertEqual(run.returncode, 0, run.stderr)
        return out

    def test_a_batch_s_design_has_the_files_and_the_figures_of_its_line(self):
        sweep = self.scratch / "sweep.json"
        sweep.write_text(json.dumps({"spec": SPEC, "axes": [{"key": "copy.scale", "values": [0.7, 1.4]},
                                                            {"key": "links.width_mm", "values": [6, 8, 10]}]}))
        lines = self.lines([SPEC, "", with_value(SPEC, "copy.scale", 2)])
        folder = self.scratch / "specs"
        folder.mkdir()
        (folder / "a.toml").write_text("[copy]\nscale = 1.4\n[region]\nrectangle_mm = [60, -5, 10, 10]\n")
        (folder / "b.toml").write_text("[copy]\nscale = 3\n")
        for source, name in ((sweep, "cell-2-3"), (sweep, "cell-1-1"), (lines, "line-3"), (folder, "a.toml")):
            results = self.run_batch(source, self.scratch / f"all-{source.name}")["results.jsonl"]
            told = next(one for one in map(json.loads, results.splitlines()) if one["name"] == name)
            out = self.design(source, name)
            design = json.loads((out / "design.json").read_text())
            self.assertEqual(design["mechanism"]["lengths_mm"]["VA"], told["VA_mm"], name)
            self.assertEqual(design["quality"]["size_mm"], told["size_mm"], name)
            self.assertTrue((out / "report.html").exists() and (out / "workshop.pdf").exists())

    def test_a_name_that_no_spec_has_is_refused(self):
        sweep = self.scratch / "sweep.json"
        sweep.write_text(json.dumps({"spec": SPEC, "axes": [{"key": "copy.scale", "values": [0.7, 1.4]}]}))
        for source, names in ((sweep, ("cell-3", "cell-0", "cell-1-1", "cell", "cell-", "cell--1", "cell-01", "cell-1x", "line-1", "")),
                              (self.lines([SPEC]), ("line-2", "line-0", "line-01", "cell-1"))):
            for name in names:
                run = subprocess.run([*self.command(source, self.scratch / "none"), f"--only={name}"], capture_output=True, text=True)
                self.assertEqual(run.returncode, 2, (name, run.stderr))
                self.assertIn("--only", run.stderr)
        self.assertFalse((self.scratch / "none").exists())


class Kills(Case):
    """A spec that was finished is never done again, and the results are those of a run that nothing disturbed."""

    SPECS = 60

    def source(self, chance):
        specs = [with_value(with_value(SPEC, "copy.scale", round(chance.uniform(1.2, 3), 6)), "copy.rotation_deg",
                            round(chance.uniform(30, 150), 6)) for _ in range(self.SPECS)]
        return self.lines(["" if i % 7 == 3 else "no spec" if i % 11 == 5 else one for i, one in enumerate(specs)])

    def test_at_random_moments(self):
        kills = 0
        for seed in range(4):
            chance = random.Random(seed)
            source, out = self.source(chance), self.scratch / f"out-{seed}"
            started = time.monotonic()
            whole = self.run_batch(source, self.scratch / f"whole-{seed}", "-j", 2)
            count, began = len(whole["results.jsonl"].splitlines()), time.monotonic()
            longest = (began - started) / 5  # so that it takes some ten kills on any machine
            while not (out / "results.jsonl").exists():
                self.assertLess(time.monotonic() - began, 300)
                process = subprocess.Popen(self.command(source, out, "-j", chance.choice([1, 2, 3])), stdout=subprocess.DEVNULL)
                time.sleep(chance.uniform(0, longest))
                before = self.journal_keys(out)
                process.send_signal(signal.SIGKILL)
                kills += process.wait() == -signal.SIGKILL
                after = self.journal_keys(out)
                self.assertEqual(after[:len(before)], before)
                self.assertEqual(len(set(after)), len(after), "a finished spec was done again")
            self.assertEqual({name: (out / name).read_bytes() for name in RESULTS if (out / name).exists()},
                             {name: whole[name] for name in RESULTS if (out / name).exists()})
            self.assertEqual(self.run_batch(source, out), whole)
            self.assertEqual(len(self.journal_keys(out)), count)
        self.assertGreaterEqual(kills, 12)

    def test_only_what_was_edited_is_done_again(self):
        specs = [with_value(SPEC, "copy.scale", 1.2 + 0.1 * i) for i in range(5)]
        source, out = self.lines(specs), self.scratch / "out"
        self.run_batch(source, out)
        specs[2] = with_value(SPEC, "copy.scale", 2.5)
        edited = self.run_batch(self.lines(specs), out)
        self.assertEqual(len(self.journal_keys(out)), 6)
        self.assertEqual(edited, self.run_batch(source, self.scratch / "anew"))
        # A folder's specs are known by their names: one more before them moves none.
        folder = self.scratch / "folder"
        folder.mkdir()
        for i in (1, 2):
            (folder / f"{i}.toml").write_text(f"copy = {{scale = {i + 1}}}")
        self.run_batch(folder, self.scratch / "of-a-folder")
        (folder / "0.toml").write_text("copy = {scale = -1}")
        results = self.run_batch(folder, self.scratch / "of-a-folder")["results.jsonl"].splitlines()
        self.assertEqual([json.loads(line)["name"] for line in results], ["0.toml", "1.toml", "2.toml"])
        self.assertEqual(len(self.journal_keys(self.scratch / "of-a-folder")), 3)


def is_sanitised():
    """A sanitiser keeps what was freed, to find who uses it still."""
    program = pathlib.Path(KEMPE).read_bytes()
    return b"__asan_init" in program or b"__tsan_init" in program


@unittest.skipIf(is_sanitised(), "a sanitiser's memory is not the program's")
class Memory(Case):
    def memory(self, source, *options):
        """Largest resident memory of a batch, MB."""
        out = self.scratch / f"out-{source.name}"
        watch = ("import resource, subprocess, sys; code = subprocess.run(sys.argv[1:]).returncode; "
                 "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024); sys.exit(code)")
        run = subprocess.run([sys.executable, "-c", watch, *self.command(source, out, *options)], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return float(run.stdout.split()[-1])

    def test_does_not_grow_with_the_batch(self):
        """Of specs that are refused, which take no search: what is kept of a spec is the same."""
        def few_and_many(make):
            few, many = (self.memory(make(count), "-j", 2) for count in (1_000, 30_000))
            self.assertLess(many, few + 4)
        few_and_many(lambda count: self.lines(({"copy": {"scale": -1 - i}} for i in range(count)), f"{count}.jsonl"))
        few_and_many(lambda count: self.sweep(with_value(SPEC, "links.width_mm", -1), [
            ("copy.scale", list(range(1, count // 100 + 1))), ("copy.rotation_deg", list(range(100)))], f"{count}.json"))


unittest.main(verbosity=2)
