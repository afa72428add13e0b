#!/usr/bin/env python3
"""Joins the engine, the scripts and the templates into one page that opens as a file and may ask nothing of a network.

usage: make_page.py ENGINE_FOLDER OUT.html      the folder holds engine.js and engine.wasm
"""
import base64
import gzip
import hashlib
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "studio" / "page"
# Shared with the report: its colours and lines, its kinematics, its grid.
STYLES = [ROOT / "reports/web/report.css", PAGE / "studio.css"]
SCRIPTS = [ROOT / "reports/web/kinematics.js", ROOT / "reports/web/frame.js"] + [
    PAGE / name for name in ("toml.js", "words.js", "naming.js", "ways.js", "shapes.js", "labels.js", "stage.js", "share.js", "engine.js", "menu.js", "colours.js",
                            "lengths.js", "panel.js", "homography.js", "drawing.js", "photo.js", "main.js")]
# Shown in the gallery below the templates of kempe init; the first is what the page opens with, and not shown.
EXAMPLES = ["plagiograph", "nameplate", "clamped-plate", "pantorouter", "half-turn", "matlab-circle", "sixty", "two-layer",
             "robust-plagiograph"]
# What stands on the table is drawn, not typed; the rest of a spec gets a field a key, in this order.
DRAWN = {"region", "pole", "obstacles", "bodies", "table", "mechanism"}


def list_of(key):
    """What a list holds that one field can show: "numbers", "pairs" of numbers, or "words" to choose from; None for any other."""
    items = key["items"]
    if items.get("type") == "number":
        return "numbers"
    if items.get("type") == "array" and items["items"].get("type") == "number" and items.get("maxItems") == 2:
        return "pairs"
    return "words" if "enum" in items else None


def keys():
    """The keys of a spec that one field can hold, from its schema."""
    schema = json.loads((ROOT / "docs/spec.schema.json").read_text(encoding="utf-8"))
    found = []
    above = {name: key for name, key in schema["properties"].items() if key.get("type") == "string"}
    tables = {"": {"type": "object", "properties": above}, **schema["properties"]}
    for table, of in tables.items():
        if table in DRAWN or of.get("type") != "object":
            continue
        for name, key in of["properties"].items():
            ratio = any(form.get("type") == "number" for form in key.get("anyOf", []))  # a number, or "1:3"
            words = key.get("enum") or next((form["enum"] for form in key.get("anyOf", []) if "enum" in form), None)
            kind = "number" if ratio else list_of(key) if key.get("type") == "array" else key.get("type")
            if words or kind in ("number", "integer", "boolean", "string", "numbers", "pairs", "words"):
                found.append({"table": table, "name": name, "type": kind, "ratio": ratio,
                              "enum": key["items"]["enum"] if kind == "words" else words,
                              "description": key.get("description", ""), "default": key.get("default")})
    first = ["copy", "limits", "links", "objective", "material", "load"]
    return sorted(found, key=lambda key: first.index(key["table"]) if key["table"] in first else len(first) + (key["table"] == ""))


def templates():
    """Those of kempe init, in its order."""
    folder = ROOT / "specs/templates"
    return [card(folder / f"{name}.toml") for name in (folder / "order.txt").read_text(encoding="utf-8").split()]


def card(path):
    text = path.read_text(encoding="utf-8")
    words = []
    for line in text.splitlines():
        if not line.startswith("# ") or line.startswith("# Run:"):
            break
        words.append(line[2:])
    sentence = " ".join(words).split(". ")[0].rstrip(".")
    return {"name": path.stem, "title": sentence.split(":")[0] if len(sentence) > 120 else sentence, "text": text}


def inside_script(text):
    """The two spellings that can end or change a script element; both stay the same string in JavaScript and JSON."""
    return text.replace("</script", "<\\/script").replace("<!--", "<\\!--")


def source(text):
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def page(engine):
    style = "\n".join(path.read_text(encoding="utf-8") for path in STYLES)
    script = inside_script("\n".join(path.read_text(encoding="utf-8") for path in SCRIPTS) + "\nkempe.begin();\n")
    worker = inside_script((engine / "engine.js").read_text(encoding="utf-8") + "\n" + (PAGE / "worker.js").read_text(encoding="utf-8"))
    wasm = base64.b64encode(gzip.compress((engine / "engine.wasm").read_bytes(), 9, mtime=0)).decode()
    first, *examples = [card(ROOT / "specs/examples" / f"{name}.toml") for name in EXAMPLES]
    data = json.dumps({"keys": keys(), "first": first, "templates": templates(), "examples": examples}, ensure_ascii=False)
    policy = (f"default-src 'none'; base-uri 'none'; form-action 'none'; img-src data: blob:; worker-src blob:; "
              f"style-src {source(style)}; script-src {source(script)} 'wasm-unsafe-eval'")
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Kempe studio</title>
<style>{style}</style>
</head>
{(PAGE / "page.html").read_text(encoding="utf-8")}
<script type="application/json" id="studio-data">{inside_script(data).replace("<", chr(92) + "u003c")}</script>
<script type="application/json" id="studio-spec">null</script>
<script type="text/plain" id="engine-script">{worker}</script>
<script type="text/plain" id="engine-wasm">{wasm}</script>
<script>{script}</script>
</body>
</html>
"""


def main(engine, out):
    out.parent.mkdir(parents=True, exist_ok=True)
    text = page(engine)
    out.write_text(text, encoding="utf-8")
    print(f"{out}: {len(text.encode()) / 1e6:.1f} MB")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
