#!/usr/bin/env python3
"""A batch under MPI: the same bytes for any number of ranks, and on after a rank was lost.

usage: ranks_test.py KEMPE MPIEXEC
"""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

KEMPE, MPIEXEC = sys.argv.pop(1), sys.argv.pop(1)
SCALES = [0.5, 0.7, 1.3, 1.4, 1.6, 1.8, 2, 2.2, 2.5, 3]
# Open MPI asks twice before it runs as root or more ranks than cores; what it keeps at its end is no leak of ours.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"}


def spec(scale):
    return {"copy": {"scale": scale, "rotation_deg": 90}, "region": {"rectangle_mm": {"at": [60, -5], "size": [10, 10]}},
            "pole": {"at_mm": [0, 0]}, "links": {"width_mm": 6, "pin_diameter_mm": 3}}


def children(pid):
    """Processes that `pid` started, directly or through others."""
    found, parents = [], {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parents[int(entry.name)] = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except (OSError, IndexError):
                pass  # ended meanwhile
    wanted = {pid}
    while new := [child for child, parent in parents.items() if parent in wanted and child not in wanted]:
        wanted.update(new)
        found += new
    return found


def is_rank(pid):
    try:
        return os.path.samefile(f"/proc/{pid}/exe", KEMPE)
    except OSError:
        return False


class Ranks(unittest.TestCase):
    def setUp(self):
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix="kempe ranks "))
        self.addCleanup(shutil.rmtree, self.scratch)
        self.source = self.scratch / "specs.jsonl"
        lines = [json.dumps(spec(scale)) for scale in SCALES]
        lines.insert(3, "no spec at all")
        self.source.write_text("\n".join(lines) + "\n")
        self.count = len(lines)

    def command(self, ranks, out, *arguments):
        start = [MPIEXEC, "-n", str(ranks)] if ranks else []
        return [*start, KEMPE, "synthesize", "--batch", str(self.source), "-o", str(out), *arguments]

    def results(self, ranks, out, *arguments):
        run = subprocess.run(self.command(ranks, out, *arguments), capture_output=True, text=True, env=ENVIRONMENT)
        self.assertEqual(run.returncode, 0, run.stderr)
        # MPI itself warns on stderr too, and also in brackets.
        done = sum(1 for line in run.stderr.splitlines() if re.match(rf"\[\d+/{self.count}\] ", line))
        return (out / "results.jsonl").read_bytes(), (out / "results.csv").read_bytes(), done

    def journal_lines(self, out):
        return [line for path in out.glob("journal-*.jsonl") for line in path.read_text().splitlines() if line.endswith("}")]

    def test_the_same_bytes_for_any_number_of_ranks_and_threads(self):
        alone = self.results(0, self.scratch / "alone", "-j", "1")
        self.assertEqual(len(alone[0].splitlines()), self.count)
        for ranks, threads in ((1, 1), (2, 1), (4, 1), (2, 2)):
            shared = self.results(ranks, self.scratch / f"ranks-{ranks}-{threads}", "-j", str(threads))
            self.assertEqual(shared[:2], alone[:2])
            self.assertEqual(shared[2], self.count)
        self.assertEqual(len(list((self.scratch / "ranks-4-1").glob("journal-*.jsonl"))), 4)

    def test_a_lost_ranks_specs_are_done_again(self):
        # Enough of them that the others are not through before one rank is lost.
        self.source.write_text(8 * self.source.read_text())
        self.count *= 8
        alone = self.results(0, self.scratch / "alone", "-j", "1")
        out = self.scratch / "out"
        run = subprocess.Popen(self.command(4, out, "-j", "1"), env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 120
        while run.poll() is None and time.monotonic() < deadline and not self.journal_lines(out):
            time.sleep(0.005)
        ranks = [pid for pid in children(run.pid) if is_rank(pid)]
        self.assertTrue(ranks, "no rank is left to be lost")
        os.kill(ranks[-1], signal.SIGKILL)
        self.assertNotEqual(run.wait(timeout=120), 0)
        self.assertFalse((out / "results.jsonl").exists())
        before = len(self.journal_lines(out))
        self.assertGreater(before, 0)
        self.assertLess(before, self.count)
        resumed = self.results(2, out, "-j", "1")
        self.assertEqual(resumed[:2], alone[:2])
        self.assertEqual(resumed[2], self.count - before)

    def test_no_rank_waits_for_one_that_cannot_write(self):
        out = self.scratch / "out"
        out.mkdir()
        (out / "journal-1.jsonl").mkdir()  # rank 1 cannot open its journal
        run = subprocess.run(self.command(3, out), capture_output=True, text=True, env=ENVIRONMENT, timeout=120)
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertIn("journal-1.jsonl", run.stderr)


unittest.main(verbosity=2)
