#!/usr/bin/env python3
"""The notebooks run from top to bottom, and print what is stored in them. Cells that measure (tag "measured") only run.

usage: notebooks_test.py SOURCE [NAME ...]     PYTHONPATH leads to the module; pictures are drawn where Matplotlib is there
"""
import contextlib
import importlib.util
import io
import json
import os
import pathlib
import sys
import tempfile
import warnings

source = pathlib.Path(sys.argv[1]).resolve()
files = sorted((source / "docs" / "notebooks").glob("*.ipynb"))
files = [file for file in files if file.stem in sys.argv[2:]] if sys.argv[2:] else files
if importlib.util.find_spec("matplotlib") is None:
    print("no Matplotlib: the notebooks are not run")
    sys.exit(77)
warnings.filterwarnings("ignore", message=".*non-interactive.*")
faults, compared = [], 0
for file in files:
    book, names = json.loads(file.read_text(encoding="utf-8")), {"__name__": "__main__"}
    text = json.dumps(book)
    if "/home/" in text or "/tmp/" in text or "Traceback" in text:
        faults.append(f"{file.name}: holds a place of some machine, or an error")
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)
        for number, cell in enumerate(cell for cell in book["cells"] if cell["cell_type"] == "code"):
            told = io.StringIO()
            with contextlib.redirect_stdout(told):
                exec(compile("".join(cell["source"]), f"{file.name} cell {number + 1}", "exec"), names)
            stored = "".join("".join(output["text"]) for output in cell["outputs"] if output["output_type"] == "stream")
            if "measured" in cell["metadata"].get("tags", []):
                if cell["outputs"]:
                    faults.append(f"{file.name} cell {number + 1}: stores what was measured once")
            elif told.getvalue() != stored:
                faults.append(f"{file.name} cell {number + 1}: prints\n{told.getvalue()}but stored is\n{stored}")
            compared += bool(stored)
        os.chdir(source)
print("\n".join(faults) or f"{len(files)} notebooks, {compared} outputs as stored")
sys.exit(bool(faults or compared < len(files)))
