"""A reader of the PDF files that drawings are, for tests: it shares nothing with their writer.

Of each page: its size, its paths (points in mm, pen width, dashes, filled or not) and its texts with their places.
"""
import re
import zlib

MM = 25.4 / 72
TOKEN = re.compile(rb"\((?:\\.|[^\\()])*\)|\[[^\]]*\]|/[^\s/\[\]()<>]+|[-+.\d]+|[A-Za-z*]+|<[0-9A-Fa-f]*>")
ESCAPES = {b"n": b"\n", b"r": b"\r", b"t": b"\t", b"b": b"\b", b"f": b"\f"}


def unescaped(text):
    def plain(match):
        code = match[1]
        return bytes([int(code, 8)]) if code.isdigit() else ESCAPES.get(code, code)

    return re.sub(rb"\\([0-7]{3}|.)", plain, text, flags=re.S)


class Path:
    def __init__(self, pieces, pen, dashed, stroked, filled, clipped):
        self.pieces = pieces  # [("m" | "l", [point]), ("c", [point, point, point]), ("h", [])]
        self.pen, self.dashed, self.stroked, self.filled, self.clipped = pen, dashed, stroked, filled, clipped

    def ends(self):
        return [points[-1] for _, points in self.pieces if points]

    def circle(self):
        """(x, y, radius) in mm of a path of curves alone that is a circle; else None."""
        kinds = [kind for kind, _ in self.pieces]
        if kinds[0] != "m" or set(kinds[1:]) - {"c", "h"} or kinds.count("c") < 4:
            return None
        points = self.ends()[1:]
        x, y = (sum(c) / len(points) for c in zip(*points))
        radii = [((p[0] - x) ** 2 + (p[1] - y) ** 2) ** 0.5 for p in points]
        return (x, y, sum(radii) / len(radii)) if max(radii) - min(radii) < 1e-3 else None


class Text:
    CAPITAL = 0.737  # of osifont's letters, of the size of its type

    def __init__(self, text, matrix, size, width):
        self.text, self.x, self.y, self.size, self.width = text, matrix[4] * MM, matrix[5] * MM, size, width
        self.along = (matrix[0], matrix[1])

    def corners(self):
        """Of the box of its capitals, mm."""
        (ux, uy), high = self.along, self.CAPITAL * self.size
        return [(self.x + a * ux - b * uy, self.y + a * uy + b * ux)
                for a, b in ((0, 0), (self.width, 0), (self.width, high), (0, high))]


class Page:
    def __init__(self, size, content, fonts):
        self.size, self.paths, self.texts, self.fonts = size, [], [], fonts
        self.read(content)

    def read(self, content):
        stack, pieces, state, kept = [], [], {"w": 1.0, "d": False, "clip": 0}, []
        font, widths, matrix = 0.0, {}, [1, 0, 0, 1, 0, 0]
        for token in TOKEN.findall(content):
            if not re.fullmatch(rb"[A-Za-z*]+", token):
                stack.append(token)
                continue
            op = token.decode()
            numbers = [float(one) for one in stack if re.fullmatch(rb"[-+.\d]+", one)]
            points = [(numbers[i] * MM, numbers[i + 1] * MM) for i in range(0, len(numbers) - 1, 2)]
            if op in "mlc":
                pieces.append((op, points))
            elif op == "h":
                pieces.append(("h", []))
            elif op in ("S", "B", "f", "b", "s"):
                self.paths.append(Path(pieces, state["w"], state["d"], op != "f", op in "Bfb", state["clip"]))
                pieces = []
            elif op == "n":
                pieces = []
            elif op == "W":
                state["clip"] += 1
            elif op == "w":
                state["w"] = numbers[0] * MM
            elif op == "d":
                state["d"] = stack[0] != b"[]" and bool(re.search(rb"\d", stack[0]))
            elif op == "q":
                kept.append(dict(state))
            elif op == "Q":
                state = kept.pop()
            elif op == "Tf":
                font, widths = numbers[-1] * MM, self.fonts[stack[0][1:].decode()]
            elif op == "Tm":
                matrix = numbers
            elif op == "Tj":
                codes = unescaped(stack[-1][1:-1])
                width = sum(widths[code] for code in codes) * font / 1000
                self.texts.append(Text(codes.decode("cp1252", "replace"), matrix, font, width))
            stack = []

    def says(self, words):
        return any(words in one.text for one in self.texts)

    def row_of(self, text):
        """The texts on the baseline of another, from left to right."""
        return [one.text for one in sorted(self.texts, key=lambda one: one.x) if abs(one.y - text.y) < 0.01]

    def table(self, heading, width):
        """The rows below a table's heading, the cells of each from left to right, as far as rows stand close."""
        at = next(one for one in self.texts if one.text == heading)
        inside = [one for one in self.texts if at.x - 1 < one.x < at.x + width and one.y < at.y - 1]
        rows, last = [], at.y
        for y in sorted({round(one.y, 1) for one in inside}, reverse=True):
            if last - y > 10:
                break
            rows.append([one.text for one in sorted(inside, key=lambda one: one.x) if abs(one.y - y) < 0.1])
            last = y
        return rows


def pages_of(data):
    """The pages of a PDF, in order."""
    objects = {}
    for match in re.finditer(rb"(\d+) 0 obj\s(.*?)\sendobj", data, re.S):
        objects[int(match[1])] = match[2]
    tree = next(body for body in objects.values() if re.search(rb"/Type\s*/Pages\b", body))
    kids = [int(number) for number in re.findall(rb"(\d+) 0 R", re.search(rb"/Kids\s*\[(.*?)\]", tree, re.S)[1])]
    def font_widths(number):
        body = objects[number]
        first = int(re.search(rb"/FirstChar\s+(\d+)", body)[1])
        widths = re.search(rb"/Widths\s*\[([^\]]*)\]", body)[1].split()
        return {first + i: float(width) for i, width in enumerate(widths)}

    pages = []
    for kid in kids:
        body = objects[kid]
        box = [float(one) for one in re.search(rb"/MediaBox\s*\[([^\]]*)\]", body)[1].split()]
        content = objects[int(re.search(rb"/Contents\s+(\d+) 0 R", body)[1])]
        stream = re.search(rb"stream\r?\n(.*)\r?\nendstream", content, re.S)[1]
        fonts = {name.decode(): font_widths(int(number)) for name, number in re.findall(rb"/(F\d+)\s+(\d+) 0 R", body)}
        pages.append(Page((box[2] * MM, box[3] * MM), zlib.decompressobj().decompress(stream), fonts))
    return pages
