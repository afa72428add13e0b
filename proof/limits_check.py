"""The part of kempe_check.py that a design's file needs beside claims 1 and 2: the claim "limits of the file", of all that is
limited but the clearance and the transmission angle; and that a log given with the file is about its task and proves what it
states. The theorems stand in docs/proof.md.
"""
import math
from math import hypot

from kempe_check import (CHOICE, EPS_MM, LIMITS, NUMBER, OBJECTIVE, SHARED, WIDTHS, Pair, Refuted, beside, edges_of, fits, need,
                         permitted, to_segment, within)

STATED = {"search": {"objective": OBJECTIVE, "value": NUMBER[:2]}, "quality": {"lower_bound": NUMBER}}


def keep(design):
    """The claim: lengths, vertex, layers, the pole's place, the gap between the sheets and the copy error are as limited."""
    task, vertex = design.task, design.shape.vertex
    if task.sheets_gap_mm is not None:  # the pen is a part that keeps away from the region itself
        gap, pen = max(task.sheets_gap_mm, 1e-9 + EPS_MM), "V" if vertex == "pen" else "Y"
        design.keep_out([Pair("the pen", pen, "the original", ["pole"], "table", gap, edges_of(rings), rings)
                         for rings in design.region])
    if task.copy_error_mm is not None:
        beside("tolerance_check").Tolerances(design).copy_error()
    need(all(design.data.get(key) is not None for key in CHOICE), "not checked: pole, links, objective (not stated)")
    vars(task).update(vars(fits(design.data, CHOICE, design.name + ": ")))
    for name, length in design.lengths.items():
        low, high = permitted(task, name)
        off = [low - length, length - high]
        if name not in ("CX", "CY"):
            off += [abs(math.remainder(length, task.grid_mm))] if task.grid_mm else []
            off += [min(abs(length - each) for each in task.stock_mm)] if task.stock_mm else []
        need(max(off) <= EPS_MM, f"length {name} = {length}: too short or long, not as locked, not of grid or stock", Refuted)
    possible = vertex in task.groundings and max(design.layers.values()) <= task.layers
    need(possible, "this vertex or layer is not permitted", Refuted)
    away = min(hypot(*to_segment(design.pole, *edge)) for rings in task.pole for edge in edges_of(rings))
    need(away <= EPS_MM or within(design.pole, task.pole), "the pole stands elsewhere than permitted", Refuted)
    unread = sorted("limits." + key for key, value in design.data["limits"].items() if value is not None and key not in LIMITS)
    need(not unread, "not checked: " + ", ".join(unread))


def match(log, design):
    """The log speaks of the design's task, and proves what the design's file states."""
    copy, mechanism, bound = design.data["copy"], design.data["mechanism"], log.task.bound
    wanted = {key: copy.get("wanted_" + key, copy[key]) for key in ("scale", "rotation_deg")}
    theirs = {**{key: design.data.get(key) for key in SHARED}, **{key: mechanism[key] for key in WIDTHS},
              "plate": design.task.plate, "copy": wanted}
    for key in theirs:
        need(log.data["task"].get(key) == theirs[key], f"the log's {key} is not the design's")
    stated, over = fits(design.data, STATED, design.name + ": "), 1 if log.by == "size" else -1
    need(log.by == stated.objective, "the log is not about the design's objective")
    need(over * stated.value >= over * bound - EPS_MM, f"this design has {stated.value}", Refuted)
    need(stated.lower_bound is None or over * (stated.lower_bound - bound) <= EPS_MM, f"it states {stated.lower_bound}")
