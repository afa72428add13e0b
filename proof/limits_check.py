"""The part of kempe_check.py that the claim "limits of the file" needs: what a design's file limits beside the clearance and the
transmission angle. The theorems stand in docs/proof.md.
"""
import math
from math import hypot

from kempe_check import (CHOICE, EPS_MM, LIMITS, Pair, Refuted, beside, edges_of, fits, need, permitted, to_segment, within)


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
