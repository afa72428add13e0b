#!/usr/bin/env python3
"""Writes DXF drawings with ezdxf and, beside each, the points that ezdxf itself flattens them to.

usage: dxf_oracle.py FOLDER
"""
import json
import pathlib
import random
import sys

import ezdxf
from ezdxf.disassemble import recursive_decompose


def fill(space, version):
    rng = random.Random(7)
    spot = lambda: (rng.uniform(-100, 100), rng.uniform(-100, 100))
    space.add_line(spot(), spot())
    space.add_circle(spot(), 12.5)
    for start, end in [(10, 200), (300, 20), (0, 359)]:
        space.add_arc(spot(), 20, start, end)
    bulged = [(*spot(), rng.uniform(-2, 2)) for _ in range(6)]
    space.add_polyline2d([p[:2] for p in bulged], close=True)
    if version == "R12":
        line = space.add_polyline2d([])
        line.append_formatted_vertices(bulged, "xyb")
        line.close(True)
        return
    space.add_lwpolyline(bulged, format="xyb", close=True)
    space.add_ellipse(spot(), (30, 10), 0.4, 0.5, 4)
    space.add_ellipse(spot(), (30, 10), 0.4)
    space.add_spline(degree=3).control_points = [(*spot(), 0) for _ in range(9)]
    space[-1].knots = ezdxf.math.BSpline([(0, 0)] * 9, 4).knots()
    space.add_open_spline([spot() for _ in range(7)], degree=2)
    space.add_rational_spline([spot() for _ in range(8)], [1, 2, 1, 0.5, 1, 3, 1, 1], degree=3)
    space.add_arc((5, 5), 3, 20, 100, dxfattribs={"extrusion": (0, 0, -1)})


def block_drawing(document):
    inner = document.blocks.new("inner", base_point=(1, 2))
    inner.add_line((0, 0), (10, 5))
    inner.add_arc((3, 3), 4, 15, 200)
    outer = document.blocks.new("outer")
    outer.add_blockref("inner", (5, 5), dxfattribs={"rotation": 30, "xscale": 2, "yscale": 2})
    outer.add_circle((0, 0), 3)
    space = document.modelspace()
    space.add_blockref("outer", (50, 20), dxfattribs={"rotation": -70})
    space.add_blockref("outer", (-50, 20), dxfattribs={"xscale": -1})


def flattened(entity):
    """Points on the entity itself: ezdxf's paths would replace arcs by cubic curves."""
    if entity.dxftype() == "LINE":
        return [entity.dxf.start, entity.dxf.end]
    if entity.dxftype() in ("POLYLINE", "LWPOLYLINE"):
        points = []
        for piece in entity.virtual_entities():
            more = flattened(piece)
            if points and points[-1].distance(more[0]) > points[-1].distance(more[-1]):
                more.reverse()
            points += more
        return points
    return [ezdxf.math.Vec3(p) for p in entity.flattening(1e-4)]


def points_of(space):
    return [[(p.x, p.y) for p in flattened(entity)]
            for entity in recursive_decompose(space) if entity.dxftype() not in ("TEXT", "MTEXT")]


folder = pathlib.Path(sys.argv[1])
for name, version, units in [("r12", "R12", 4), ("r2000", "R2000", 1), ("r2018", "R2018", 5), ("blocks", "R2000", 4)]:
    document = ezdxf.new(version, units=units)
    if name == "blocks":
        block_drawing(document)
    else:
        fill(document.modelspace(), version)
        document.modelspace().add_text("Kempe")
    document.saveas(folder / f"{name}.dxf")
    (folder / f"{name}.json").write_text(json.dumps(points_of(document.modelspace())))
