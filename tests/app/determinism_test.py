#!/usr/bin/env python3
"""The same inputs, the same bytes: design.json of every example against its stored hashes.

Two hashes an example stand in design-hashes.txt. The first is of the file's bytes: the same for any number of threads on
every processor, in release builds with musl's sines and powers (cmake/one_libm.cmake). The second is of the design with numbers
rounded to 11 digits, and without the few figures that only measure rounding or count work (ROUNDING): the same for every
compiler, build type and C library. Each example is also run with fused multiplication and wide vectors hidden from the
libraries, as on an older processor, and must give the same hash. All run in a folder with an options file of a library's own,
which must change nothing.

scripts/update-hashes writes the hashes anew, after a change that is meant to change designs, and names the examples whose
design changed.

usage: determinism_test.py KEMPE SOURCE_DIR [--threads 1,2,7] [--rounded] [--update]
  --rounded   compare the second hash only: for builds whose compiler or C library rounds differently
"""
import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile

STORED = pathlib.Path(__file__).resolve().parent / "design-hashes.txt"
HEAD = """# SHA-256 of every example's design.json, and of its design rounded to 11 digits (determinism_test.py says why two).
# Written by scripts/update-hashes.
"""
ROUNDING = {"verification": ("copy_error_max_mm", "loop_residual_max_mm", "scale", "rotation_deg"), "search": ("evaluations",)}
OLD_PROCESSOR = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-AVX512F,-FMA,-FMA4", "OPENBLAS_CORETYPE": "Nehalem"}


def stored_hashes():
    if not STORED.exists():
        return {}
    lines = [line.split() for line in STORED.read_text().splitlines() if line and not line.startswith("#")]
    return {name: (exact, rounded) for exact, rounded, name in lines}


def write_hashes(found):
    STORED.write_text(HEAD + "".join(f"{exact} {rounded} {name}\n" for name, (exact, rounded) in sorted(found.items())))


def examples(source):
    return sorted((source.resolve() / "specs" / "examples").glob("*.toml"))


def rounded(value):
    if isinstance(value, dict):
        return {key: rounded(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [rounded(entry) for entry in value]
    if isinstance(value, float):
        return 0 if abs(value) < 1e-9 else float(f"{value:.11g}")
    return value


def canonical(design):
    """The design's text, rounded and without the figures of ROUNDING."""
    object_ = json.loads(design)
    for table, keys in ROUNDING.items():
        for key in keys:
            del object_[table][key]
    return json.dumps(rounded(object_), indent=1).encode()


def sha256(text):
    return hashlib.sha256(text).hexdigest()


def design_of(kempe, spec, threads, surroundings=None):
    """The bytes of one example's design.json; else nothing and a sentence."""
    command = "workspace" if "[mechanism]" in spec.read_text() else "synthesize"
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "ipopt.opt").write_text("no_such_option 1\n")
        arguments = [kempe, command, spec, "-o", "out", "--quiet"]
        if command == "synthesize":
            arguments += ["-j", str(threads)]
        run = subprocess.run(arguments, capture_output=True, text=True, timeout=900, cwd=folder,
                             env={**os.environ, **(surroundings or {})})
        if run.returncode != 0:
            return None, f"{spec.name}: exit {run.returncode}: {run.stderr.strip()}"
        return (pathlib.Path(folder) / "out" / "design.json").read_bytes(), ""


def first_difference(one, other):
    for a, b in zip(one.decode().splitlines(), other.decode().splitlines()):
        if a != b:
            return f"{a.strip()} against {b.strip()}"
    return "one is longer"


def hashes_of(kempe, spec, threads, seen):
    """Both hashes of an example's design, and what is wrong with it; `seen` is what must be the same of a file's bytes."""
    first, fault = design_of(kempe, spec, threads[0])
    if first is None:
        return None, [fault]
    faults = []
    for count in threads[1:]:
        other, fault = design_of(kempe, spec, count)
        if other != first:
            faults.append(fault or f"{spec.name}: {count} threads give other bytes than {threads[0]}: {first_difference(first, other)}")
    old, fault = design_of(kempe, spec, threads[0], OLD_PROCESSOR)
    if old is None or seen(old) != seen(first):
        faults.append(fault or f"{spec.name}: another design on an older processor: " + first_difference(seen(first), seen(old)))
    return (sha256(first), sha256(canonical(first))), faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kempe", type=pathlib.Path)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--threads", default="1,2,7")
    parser.add_argument("--rounded", action="store_true")
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    kempe, wanted, found, faults = arguments.kempe.resolve(), stored_hashes(), {}, []
    threads = arguments.threads.split(",")
    for spec in examples(arguments.source):
        both, wrong = hashes_of(kempe, spec, threads, canonical if arguments.rounded else bytes)
        faults += wrong
        if both is not None:
            found[spec.name] = both
    if arguments.update:
        for name in sorted(set(found) | set(wanted)):
            if wanted.get(name) != found.get(name):
                print(f"{name}: {'new' if name not in wanted else 'gone' if name not in found else 'changed'}")
        if not faults:
            write_hashes(found)
    else:
        if set(wanted) != {spec.name for spec in examples(arguments.source)}:
            faults.append(f"{STORED.name} does not name exactly the examples: run scripts/update-hashes")
        compared = slice(1, 2) if arguments.rounded else slice(0, 2)
        faults += [f"{name}: the design's hashes are {both[compared]}, stored are {wanted[name][compared]}"
                   for name, both in found.items() if name in wanted and wanted[name][compared] != both[compared]]
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(found)} examples with {arguments.threads} threads, {len(faults)} faults")
    return 1 if faults else 0


sys.exit(main())
