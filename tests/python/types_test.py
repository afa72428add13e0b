#!/usr/bin/env python3
"""The package under mypy --strict, its compiled module against its stub, and a user's program under --strict.

usage: types_test.py SOURCE PACKAGES
"""
import os
import pathlib
import subprocess
import sys
import tempfile

source, packages = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
USER = '''
import numpy as np
import kempe

spec = kempe.Spec(copy=1.4j, region=np.zeros((3, 2)), links={"width_mm": 6})
design: kempe.Design = kempe.synthesize(spec, progress=lambda share, what: print(share, what))
size: float = design.size_mm + design.pen([(0, 0)])[0, 0]
try:
    names: list[str] = design.save("out")
except kempe.SpecError as error:
    keys: list[str] = [fault.key for fault in error.faults]
verdict: kempe.Verdict = design.map.why(1, 2)
motion: kempe.Motion = kempe.Linkage.read("linkage.toml").solve(steps=8)
freedoms: int = kempe.Linkage(ground={"O": [0, 0]}).mobility().mobility
speed: float = motion.velocities["A"][0, 0] + kempe.inversor("lens.toml").linkage.solve().times_s[-1]
wrong: str = design.size_mm
'''
# What no stub says: the class of pybind11's classes, and that they have no __init__ of their own.
ALLOWED = "".join(f"kempe\\._core\\.{name}\nkempe\\._core\\.{name}\\.__init__\n" for name in
                  ("CalibratedInstrument", "CalibrationOptions", "Design", "DrawingOptions", "Linkage", "Map", "NoMotion", "NothingGenerated", "Outcome", "PlagiographOptions", "Spec", "Wishes"))


def run(*command, folder):
    done = subprocess.run([sys.executable, "-m", *map(str, command)], cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "MYPYPATH": str(packages), "PYTHONPATH": str(packages)})
    return done.stdout + done.stderr, done.returncode


faults = []
with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(scratch)
    (folder / "allowed.txt").write_text(ALLOWED)
    (folder / "user.py").write_text(USER)
    config = ("--config-file", source / "pyproject.toml", "--cache-dir", folder / "cache")
    told, code = run("mypy", *config, "--strict", "-p", "kempe", "-m", "user", folder=folder)
    wrong = [line for line in told.splitlines() if ": error:" in line]
    if [line.split(":")[:2] for line in wrong] != [["user.py", str(USER.count("\n"))]]:
        faults.append(f"one error is expected, in the last line of user.py:\n{told}")
    told, code = run("mypy.stubtest", "kempe._core", "--allowlist", folder / "allowed.txt", "--ignore-unused-allowlist",
                     "--mypy-config-file", source / "pyproject.toml", folder=folder)
    if code != 0:
        faults.append(told)
print("\n".join(faults) or "types are true")
sys.exit(bool(faults))
