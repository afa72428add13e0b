#!/usr/bin/env python3
"""The program takes none of the functions that musl gives it (cmake/one_libm.cmake) from a shared library: else the last digits
of designs would depend on the processor.

usage: one_libm_test.py NM PROGRAM FUNCTIONS
"""
import pathlib
import subprocess
import sys

nm, program, functions = sys.argv[1:]
listed = subprocess.run([nm, "--dynamic", "--undefined-only", program], capture_output=True, text=True, check=True).stdout
imported = {line.split()[-1].split("@")[0] for line in listed.splitlines()}
assert "malloc" in imported or "free" in imported, f"{nm} lists nothing that {program} takes from the C library"
foreign = sorted(imported & set(pathlib.Path(functions).read_text().split()))
if foreign:
    sys.exit(f"{program} takes from a shared library: {', '.join(foreign)}")
