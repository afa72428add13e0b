#!/usr/bin/env python3
"""The logs that the program writes beside its designs, and beside its proofs that there is none, read by the checker.

usage: certificates_test.py KEMPE SOURCE_DIR [RANDOM_SPECS [SEED]]
"""
import importlib.util
import json
import pathlib
import random
import subprocess
import sys
import tempfile

KEMPE, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
COUNT, SEED = (int(a) for a in (sys.argv[3:] + ["12", "7"][len(sys.argv) - 3:])[:2])
CHECKER = SOURCE / "proof" / "kempe_check.py"
LEFT_OUT = "left out"
MOST_LEFT_OUT = 0.1  # of the bounds: trees that do not close in 20,000 lines, or touch a design too closely
NO_DESIGN = """[copy]
scale = 0.5
[region]
rectangle_mm = {at = [100, -50], size = [400, 100]}
[links]
width_mm = 12
pin_diameter_mm = 6
thickness_mm = 4
longest_mm = 150
"""


def module(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


def run(*command):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True)


def check(*files):
    ran = run(sys.executable, CHECKER, *files)
    return ran.returncode, ran.stdout + ran.stderr


def log_of_design(spec_file, folder):
    """What is wrong with the log of a spec's design; None if it has no bound that rules exist for."""
    ran = run(KEMPE, "synthesize", spec_file, "-o", folder, "--json")
    if ran.returncode not in (0, 3):
        return f"exit {ran.returncode}: {ran.stderr}"
    log = folder / "certificate.jsonl"
    if ran.returncode == 3:
        if not json.loads(ran.stdout)["proven"]:
            return None
        if not log.exists():
            return LEFT_OUT
        code, told = check(log)
        return None if code == 0 and "4 no design exists: proven" in told else told
    design = json.loads((folder / "design.json").read_text())
    if design["quality"]["lower_bound"] is None or design["search"]["objective"] not in ("size", "transmission"):
        return None
    if not log.exists():
        told = any(s.startswith("certificate.jsonl is left out") for s in json.loads(ran.stdout)["left_out"])
        return LEFT_OUT if told else "a bound without its log, and no word of it"
    code, told = check(folder / "design.json", log)
    return None if code == 0 else told


def main():
    faults, logs, left_out = [], 0, []
    with tempfile.TemporaryDirectory() as temporary:
        root = pathlib.Path(temporary)
        (root / "none.toml").write_text(NO_DESIGN)
        specs = sorted((SOURCE / "specs" / "examples").glob("*.toml")) + [root / "none.toml"]
        transmission = root / "transmission.toml"
        transmission.write_text((SOURCE / "specs/examples/plagiograph.toml").read_text() + "\n[objective]\nmaximize = \"transmission\"\n")
        if "[objective]" not in (SOURCE / "specs/examples/plagiograph.toml").read_text():
            specs.append(transmission)
        rng, random_specs = random.Random(SEED), module(SOURCE / "bench" / "random_specs.py")
        for i in range(COUNT):
            path = root / f"random-{i}.toml"
            path.write_text(toml(random_specs.spec(rng)))
            specs.append(path)
        for number, spec in enumerate(specs):
            folder = root / f"out-{number}"
            fault = log_of_design(spec, folder)
            logs += (folder / "certificate.jsonl").exists()
            if fault == LEFT_OUT:
                left_out.append(spec.name)
            elif fault:
                faults.append(f"{spec.name}: {fault}")
    for fault in faults:
        print(fault)
    print(f"{logs} logs of {len(specs)} specs, left out: {left_out}, {len(faults)} faults")
    return 1 if faults or len(left_out) > MOST_LEFT_OUT * (logs + len(left_out)) else 0


def toml(value):
    """A spec given as JSON tables, as TOML."""
    def inline(v):
        if isinstance(v, dict):
            return "{" + ", ".join(f"{k} = {inline(x)}" for k, x in v.items()) + "}"
        if isinstance(v, list):
            return "[" + ", ".join(map(inline, v)) + "]"
        return json.dumps(v)
    return "\n".join(f"{key} = {inline(each)}" for key, each in value.items()) + "\n"


if __name__ == "__main__":
    sys.exit(main())
