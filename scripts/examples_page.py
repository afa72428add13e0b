#!/usr/bin/env python3
"""The page over all that scripts/examples has made: a picture, a sentence and the count of freedoms for each, in the report's dress.

usage: examples_page.py FOLDER     writes FOLDER/index.html
"""
import html
import json
import pathlib
import re
import sys
import tomllib

SOURCE = pathlib.Path(__file__).resolve().parent.parent
EXAMPLES = SOURCE / "specs" / "examples"
STYLE = """
main { max-width: 1400px; margin: 0 auto; padding: 0 24px 40px; }
.shown { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(300px, 100%), 1fr)); gap: 16px; }
.shown article { display: flex; flex-direction: column; border: 1px solid var(--line); border-radius: 10px; background: var(--card); overflow: hidden; break-inside: avoid; }
.shown .picture { display: block; height: 200px; background: #fff; border-bottom: 1px solid var(--line); }
.shown img { width: 100%; height: 100%; object-fit: contain; }
.shown h3 { margin: 12px 16px 0; } .shown p { margin: 6px 16px; font-size: .875rem; overflow-wrap: anywhere; }
.shown .more { margin-top: auto; padding-bottom: 12px; } .shown a { color: var(--accent); }
"""


def told(file):
    """What the comment at a file's head says, without the line that says how to run it."""
    lines = []
    for line in file.read_text().splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return re.sub(r"\s*(Run with|Run:).*", "", " ".join(lines))


def card(title, text, picture, links):
    """`links`: words and files, the first of them where the picture leads."""
    first = html.escape(links[0][1])
    shown = f'<a class="picture" href="{first}"><img loading="lazy" alt="" src="{html.escape(picture)}"></a>' if picture else ""
    more = " · ".join(f'<a href="{html.escape(file)}">{html.escape(words)}</a>' for words, file in links)
    return f'<article>{shown}<h3>{html.escape(title)}</h3>{"".join(f"<p>{html.escape(one)}</p>" for one in text)}<p class="more">{more}</p></article>'


def linkage(folder, file):
    name = file.stem
    mobility = json.loads((folder / f"{name}-mobility.json").read_text())
    count = mobility["gruebler_in_numbers"] + f"; true mobility {mobility['mobility']}"
    return card(tomllib.loads(file.read_text()).get("name", name), [told(file), count], f"{name}.svg",
                [("moving", f"{name}.html"), ("table", f"{name}.csv"), ("instant centres", f"{name}-centres.html")])


def of_lectures():
    """The names of the files in the table of docs/teaching.md, in its order."""
    table = re.search(r"^\| linkage of a lecture .*?\n\n", (SOURCE / "docs" / "teaching.md").read_text(), re.M | re.S).group()
    return re.findall(r"`([\w-]+)\.toml`", table)


def generator(folder, file):
    links = [("moving", f"{file.stem}-linkage.html"), ("linkage file", f"{file.stem}-linkage.toml"), ("figures", f"{file.stem}.json")]
    if (folder / f"{file.stem}.svg").exists():
        links.append(("structural error", f"{file.stem}.svg"))
    return card(file.stem.replace("-", " ").capitalize(), [told(file)], f"{file.stem}-linkage.svg", links)


def calibration(_, file):
    return card(file.stem.replace("-", " ").capitalize(), [told(file)], None, [("what came out", f"calibration-{file.stem}.json")])


def main():
    folder = pathlib.Path(sys.argv[1])
    parts = []
    lectures = [EXAMPLES / "linkages" / f"{name}.toml" for name in of_lectures()]
    others = [file for file in sorted((EXAMPLES / "linkages").glob("*.toml")) if file not in lectures]
    calibrations = [file for file in sorted((EXAMPLES / "calibration").glob("*.toml"))
                    if (folder / f"calibration-{file.stem}.json").exists()]
    for heading, files, of in (("Linkages of lectures", lectures, linkage), ("Other linkages", others, linkage),
                               ("Generators", sorted((EXAMPLES / "generators").glob("*.toml")), generator),
                               ("Calibrations", calibrations, calibration)):
        cards = "\n".join(of(folder, file) for file in files)
        parts.append(f"<h2>{heading}</h2>\n<div class=\"shown\">\n{cards}\n</div>")
    style = (SOURCE / "reports" / "web" / "report.css").read_text()
    (folder / "index.html").write_text(
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>Kempe · examples</title>\n<style>{style}{STYLE}</style>\n</head>\n<body>\n<main>\n<header><p class=\"brand\">Kempe · examples</p>"
        "<h1>Linkages, generators, calibrations</h1></header>\n" + "\n".join(parts) + "\n</main>\n</body>\n</html>\n")


if __name__ == "__main__":
    main()
