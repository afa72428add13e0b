"""Runs the notebooks, stores their outputs, and renders them to build/notebooks/*.html. usage: scripts/notebooks [NAME ...]"""
import os
import pathlib
import sys
import tempfile

import nbformat
from nbclient import NotebookClient
from nbconvert import HTMLExporter

HERE = pathlib.Path(__file__).resolve().parent
PAGES = HERE.parents[1] / "build" / "notebooks"
DRESS = """
:root { color-scheme: light dark; --ink: #1d1c1a; --paper: #fdfcf9; --box: #f1eee6; --line: #d8d3c6; --link: #2f5f9f; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e4da; --paper: #1b1a18; --box: #262421; --line: #47433b; --link: #8db8ef; } }
body { background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; max-width: 54rem; margin: 0 auto; padding: 1rem; }
h1, h2 { line-height: 1.2; } a { color: var(--link); } .anchor-link, .jp-InputPrompt, .jp-OutputPrompt, .prompt { display: none; }
pre { background: var(--box); border: 1px solid var(--line); border-radius: 4px; padding: .7rem; overflow-x: auto; font-size: 13px; line-height: 1.4; }
.jp-OutputArea-output pre, .output_area pre { background: none; border-style: dashed; }
img { max-width: 100%; height: auto; background: #fff; }
.highlight .k, .highlight .kn, .highlight .ow { font-weight: 600; } .highlight .c1, .highlight .sd { opacity: .7; font-style: italic; }
"""


def joined(outputs):
    """What is printed in one go arrives in pieces."""
    whole = []
    for output in outputs:
        if whole and output.output_type == whole[-1].output_type == "stream" and output.name == whole[-1].name:
            whole[-1].text += output.text
        else:
            whole.append(output)
    return whole


def run(file):
    book = nbformat.read(file, as_version=4)
    book.cells.insert(0, nbformat.v4.new_code_cell("%matplotlib inline"))  # else the first picture is not drawn
    with tempfile.TemporaryDirectory() as scratch:
        NotebookClient(book, timeout=300, kernel_name="python3", resources={"metadata": {"path": scratch}}).execute()
    del book.cells[0]
    for cell in book.cells:
        if cell.cell_type == "code":
            cell.outputs = joined(cell.outputs)
    body, _ = HTMLExporter(template_name="basic").from_notebook_node(book)
    title = next(line for line in book.cells[0].source.splitlines() if line).lstrip("# ")
    page = ("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">"
            f"<title>{title}</title><style>{DRESS}</style></head><body>{body}</body></html>\n")
    PAGES.mkdir(parents=True, exist_ok=True)
    (PAGES / f"{file.stem}.html").write_text(page, encoding="utf-8")
    for cell in book.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.execution_count = None
            if "measured" in cell.metadata.get("tags", []):
                cell.outputs = []
            for output in cell.outputs:
                if "execution_count" in output:
                    output["execution_count"] = None
    book.metadata = nbformat.from_dict({"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
                                        "language_info": {"name": "python"}})
    nbformat.write(book, file)


os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
for one in sorted(HERE.glob("*.ipynb")):
    if not sys.argv[1:] or one.stem in sys.argv[1:]:
        run(one)
        print(PAGES / f"{one.stem}.html")
