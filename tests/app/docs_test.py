#!/usr/bin/env python3
"""The pages name what is there: links lead to files and headings, named files and folders exist, and the glossary's names stand in the
files that it gives for them."""
import pathlib
import re
import sys

NAMED_FILE = re.compile(r"(?<![\w./*-])[\w./-]*\w\.(?:hpp|cpp|py|mjs|js|cmake|toml)\b")
# A room's folder or a file of it without its ending: "synthesis/calibration/advice".
NAMED_PLACE = re.compile(
    r"(?<![\w./*-])(?:app|bench|examples|geometry|kinematics|library|proof|reports|scripts|specs|synthesis|tests|workspace)"
    r"(?:/[\w-]+)+(?![\w/*…-]|\.\w|\()")
LINK = re.compile(r'\]\(([^)\s#]*)(#[^)\s]*)?\)|src="([^"]+)"')
UNITS = re.compile(r"_(?:mm2?|deg)$")
# Names that a reader chooses, or that a program writes.
INVENTED = re.compile(r"^(?:SPEC|LINKAGE|MEASUREMENTS|NAME|FILE|commands/NAME|app/commands/NAME)\.|simulated\.toml$|^my-[\w-]+\.toml$|^out/")


def pages(root):
    return [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").glob("*.md"))]


def tree(root):
    """Every file of the project, by its path."""
    skipped = {"build", "out", "node_modules", ".git"}
    return {
        str(path.relative_to(root))
        for path in root.rglob("*")
        if path.is_file() and not skipped & set(path.relative_to(root).parts[:-1])
    }


def anchors(page):
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M)
    return {"#" + re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


def broken_links(page):
    for target, anchor, picture in LINK.findall(page.read_text(encoding="utf-8")):
        if target.startswith("http"):
            continue
        file = page.parent / (target or picture) if target or picture else page
        if not file.exists():
            yield f"{page}: a link to {target or picture}, which is not there"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file):
            yield f"{page}: a link to {target}{anchor}, a heading that is not there"


def files_not_there(page, files):
    ends = {"/".join(file.split("/")[i:]) for file in files for i in range(file.count("/") + 1)}
    for name in sorted(set(NAMED_FILE.findall(page.read_text(encoding="utf-8")))):
        if name not in ends and not INVENTED.search(name):
            yield f"{page}: {name}, which is not there"
    places = {str(above) for file in files for above in pathlib.PurePath(file).parents}
    places |= {file[: -len(pathlib.PurePath(file).suffix) or None] for file in files}
    for name in sorted(set(NAMED_PLACE.findall(page.read_text(encoding="utf-8")))):
        if name not in places and not INVENTED.search(name + "."):
            yield f"{page}: {name}, which is not there"


def tables(page):
    """The rows of every table of a page, as dictionaries by the names of its columns."""
    columns = None
    for line in page.read_text(encoding="utf-8").splitlines():
        if not line.startswith("|"):
            columns = None
            continue
        cells = [cell.strip() for cell in line.replace("\\|", "").strip("|").split("|")]
        if columns is None:
            columns = cells
        elif not set(line) <= set("|- "):
            yield dict(zip(columns, cells))


def text_of(root, files, named):
    """The sources that a cell names, by the ends of their paths, each with its header; with or without an extension."""
    text = ""
    for name in re.findall(r"[\w./]+", named):
        stem = re.sub(r"\.(hpp|cpp)$", "", name)
        for file in files:
            if re.search(rf"(^|/){re.escape(stem)}\.\w+$", file) or ("/" + file).endswith("/" + name):
                text += (root / file).read_text(encoding="utf-8")
    return text


def functions_not_there(root, page, files):
    for row in tables(page):
        names = re.findall(r"`([\w:…-]+)`", row.get("function", ""))
        if not names or not row.get("file"):
            continue
        text = text_of(root, files, row["file"])
        for name in names:
            if not any(word in text for word in name.split("::")):
                yield f"{page}: {name} does not stand in {row['file']}"


def glossary(root):
    text = (root / "docs/notation.md").read_text(encoding="utf-8")
    for line in text[text.index("## Glossary") :].splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) == 7 and cells[4] and cells[1] not in ("term", "---"):
            yield cells[1], re.findall(r"`([^`]+)`", cells[3]), cells[4].split(", ")


def source_with_header(root, file):
    """The text of a file and, of a header, of its source."""
    both = {root / file, (root / file).with_suffix(".cpp")}
    return "".join(path.read_text(encoding="utf-8") for path in sorted(both) if path.is_file())


def mentions(name, text):
    """The last part of a name as a whole word; of a key that ends in a unit also the field without it."""
    word = name.split("::")[-1].strip("[]-/")
    return any(re.search(rf"(?<!\w){re.escape(one)}(?!\w)", text) for one in (word, UNITS.sub("", word)))


def stands_in(name, text):
    """A type must be defined there, not only used."""
    outer = name.split("::")[0]
    is_defined = re.search(rf"\b(?:struct|class|using)\s+(?:KEMPE_EXPORT\s+)?{re.escape(outer)}\b(?!;)", text)
    return mentions(name, text) and (is_defined is not None or not re.match("[A-Z][a-z]", outer))


def names_not_there(root):
    """Each name of a row stands in one of the row's files, and each of the files has one of the names."""
    for term, names, files in glossary(root):
        texts = {file: source_with_header(root, file) for file in files}
        for name in names:
            if name not in FILES and not any(stands_in(name, text) for text in texts.values()):
                yield f"docs/notation.md: {term}: {name} does not stand in {', '.join(files)}"
        for file, text in texts.items():
            if names and not any(mentions(name, text) for name in names):
                yield f"docs/notation.md: {term}: {file} has none of {', '.join(names)}"


FILES = {"design.json"}  # written by other files than the one that holds the type


def main(root):
    files, faults = tree(root), []
    for page in pages(root):
        faults += [*broken_links(page), *files_not_there(page, files), *functions_not_there(root, page, files)]
    faults += names_not_there(root)
    print("\n".join(faults) or f"{len(pages(root))} pages name what is there")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
