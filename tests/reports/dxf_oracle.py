#!/usr/bin/env python3
"""Judges drawings with ezdxf, which shares nothing with the writer: audits them, measures outlines and holes.

usage: dxf_oracle.py EXPECTATIONS.json
The file is a list of {"dxf": path, "width": mm, "hole": mm, "kerf": mm, "links": [{"name", "style", "joints", "lengths"}]}
and perhaps "nested": true where boxes may overlap; joints are the letters and lengths the distances between them (01, 02, 12). Prints what is wrong; exit 1.
"""
import json
import math
import sys

import ezdxf

faults = []


def fault(text):
    faults.append(text)


def outline_area(polyline):
    vertices = [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0)) for v in polyline.vertices]
    total = 0.0
    for (x, y, bulge), (u, v, _) in zip(vertices, vertices[1:] + vertices[:1]):
        total += 0.5 * (x * v - u * y)
        sweep = 4 * math.atan(bulge)
        if bulge:
            radius = math.hypot(u - x, v - y) / (2 * math.sin(abs(sweep) / 2))
            total += math.copysign(0.5 * radius * radius * (abs(sweep) - math.sin(abs(sweep))), bulge)
    return total


def cut_through_stadium(a, b, r, y):
    """The interval of x in which the horizontal line at y meets the segment ab grown by r; None for none."""
    xs = []
    for px, py in (a, b):
        if abs(y - py) <= r:
            half = math.sqrt(r * r - (y - py) ** 2)
            xs += [px - half, px + half]
    length = math.hypot(b[0] - a[0], b[1] - a[1])
    nx, ny = -r * (b[1] - a[1]) / length, r * (b[0] - a[0]) / length
    for s in (1, -1):
        (px, py), (qx, qy) = (a[0] + s * nx, a[1] + s * ny), (b[0] + s * nx, b[1] + s * ny)
        if min(py, qy) <= y <= max(py, qy) and py != qy:
            xs.append(px + (qx - px) * (y - py) / (qy - py))
    return (min(xs), max(xs)) if xs else None


def area_by_scanning(a, b, angle, r, lines=20000):
    """Area of two arms from one corner, each grown by r, by summing chords."""
    corner, one, other = (0.0, 0.0), (a, 0.0), (b * math.cos(angle), b * math.sin(angle))
    bottom, top = -r, max(0.0, other[1]) + r
    total, step = 0.0, (top - bottom) / lines
    for i in range(lines):
        y = bottom + (i + 0.5) * step
        cuts = [c for c in (cut_through_stadium(corner, one, r, y), cut_through_stadium(corner, other, r, y)) if c]
        covered = sum(v - u for u, v in cuts)
        if len(cuts) == 2:
            covered -= max(0.0, min(cuts[0][1], cuts[1][1]) - max(cuts[0][0], cuts[1][0]))
        total += covered * step
    return total


def expected_area(link, width):
    """The area and how well it is known, relatively."""
    r, sides = width / 2, link["lengths"]
    if len(sides) == 1:
        return sides[0] * width + math.pi * r * r, 1e-6
    a, b, c = sides  # corner-C, corner-tip, C-tip
    half = (a + b + c) / 2
    triangle = math.sqrt(max(0.0, half * (half - a) * (half - b) * (half - c)))
    if min(half - a, half - b, half - c) < 1e-9 * half:  # straight; its area would be the root of rounding
        return max(sides) * width + math.pi * r * r, 1e-6
    if link["style"] == "triangle":
        return triangle + 2 * half * r + math.pi * r * r, 1e-6
    angle = math.acos((a * a + b * b - c * c) / (2 * a * b))
    notch = r / math.tan(angle / 2)
    if notch > min(a, b):
        return area_by_scanning(a, b, angle, r), 1e-5
    return 2 * r * (a + b) - notch * r + r * r * (math.pi - angle) / 2 + math.pi * r * r, 1e-6


def judge_link(path, space, link, case):
    name = f"{path} {link['name']}"
    on_layer = [e for e in space if e.dxf.layer == link["name"]]
    outlines = [e for e in on_layer if e.dxftype() == "POLYLINE"]
    holes = [e for e in on_layer if e.dxftype() == "CIRCLE"]
    if len(outlines) + len(holes) != len(on_layer):
        fault(f"{name}: more than outlines and holes on its layer")
    if len(outlines) != 1 or not outlines[0].is_closed:
        return fault(f"{name}: not one closed outline")
    area = outline_area(outlines[0])
    wanted, precision = expected_area(link, case["width"] + case["kerf"])
    if abs(area - wanted) > precision * wanted:
        fault(f"{name}: area {area}, wanted {wanted}")
    if len(holes) != len(link["joints"]):
        return fault(f"{name}: {len(holes)} holes")
    for hole in holes:
        if abs(2 * hole.dxf.radius - case["hole"]) > 1e-9:
            fault(f"{name}: a hole of diameter {2 * hole.dxf.radius}")
    pairs = [(0, 1), (0, 2), (1, 2)] if len(holes) == 3 else [(0, 1)]
    for (i, j), wanted in zip(pairs, link["lengths"]):
        distance = (holes[i].dxf.center - holes[j].dxf.center).magnitude
        if abs(distance - wanted) > 1e-9:
            fault(f"{name}: holes {i} and {j} are {distance} apart, wanted {wanted}")


def overlapping_boxes(space, names):
    boxes = []
    for entity in space:
        if entity.dxftype() == "POLYLINE" and entity.dxf.layer in names:
            xs = [v.dxf.location.x for v in entity.vertices]
            ys = [v.dxf.location.y for v in entity.vertices]
            boxes.append((min(xs), min(ys), max(xs), max(ys)))
    return any(a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
               for i, a in enumerate(boxes) for b in boxes[:i])


def judge(case):
    document = ezdxf.readfile(case["dxf"])
    audit = document.audit()
    if audit.errors or audit.fixes:
        fault(f"{case['dxf']}: audit {[str(e.message) for e in audit.errors + audit.fixes]}")
    if document.units != 4:
        fault(f"{case['dxf']}: units {document.units}, not mm")
    space = document.modelspace()
    known = {layer.dxf.name for layer in document.layers}
    for entity in space:
        if entity.dxf.layer not in known:
            fault(f"{case['dxf']}: layer {entity.dxf.layer} is in no table")
    for link in case["links"]:
        judge_link(case["dxf"], space, link, case)
    if not case.get("nested") and overlapping_boxes(space, {link["name"] for link in case["links"]}):
        fault(f"{case['dxf']}: links overlap on the sheet")


with open(sys.argv[1], encoding="utf-8") as file:
    for one in json.load(file):
        judge(one)
print("\n".join(faults))
sys.exit(1 if faults else 0)
