#!/usr/bin/env python3
"""Thousands of random specs through search, map and independent verification, as one batch; then what came of them.

Scale 0.1 .. 10, any rotation, regions of 3 .. 30 corners (every third outline on a grid), fixed and free poles, bent and
triangular plates, two and three layers; every third spec has obstacles, every fourth a tolerance, every sixth a gap between
the sheets, every twelfth a grid of lengths. Says how many designs failed their verification (none may), how far they are above the proven bound, how
often each grounding wins, and how many verdicts without a design are proven by interval arithmetic.

usage: random_specs.py KEMPE [COUNT] [SEED] [FOLDER]
"""
import collections
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile


def star(rng, centre, radius, corners):
    turns = sorted(rng.uniform(0, 0.8) + i for i in range(corners))
    return [[centre[0] + r * math.cos(2 * math.pi * t / corners), centre[1] + r * math.sin(2 * math.pi * t / corners)]
            for t in turns for r in [radius * rng.uniform(0.3, 1)]]


def grid_outline(rng, centre, radius):
    """An L, a U, a comb or a rectangle on a grid, with corners within straight edges, from any corner on and either way round."""
    a, b, c, d = (rng.randint(1, 4) for _ in range(4))
    corners = rng.choice([
        [[0, 0], [a + b, 0], [a + b, a], [a, a], [a, a + c], [0, a + c]],
        [[0, 0], [2 * a + b, 0], [2 * a + b, c + d], [a + b, c + d], [a + b, c], [a, c], [a, c + d], [0, c + d]],
        [[0, 0], [5, 0], [5, d + 1], [4, d + 1], [4, 1], [3, 1], [3, d + 1], [2, d + 1], [2, 1], [1, 1], [1, d + 1], [0, d + 1]],
        [[0, 0], [a, 0], [a + b, 0], [a + b, c], [a + b, c + d], [0, c + d]]])
    first = rng.randrange(len(corners))
    corners = (corners[first:] + corners[:first])[::rng.choice([1, -1])]
    step = max(1, round(radius / max(max(corner) for corner in corners)))
    return [[step * x + round(centre[0]), step * y + round(centre[1])] for x, y in corners]


def outline(rng, centre, radius, corners):
    return grid_outline(rng, centre, radius) if rng.random() < 1 / 3 else star(rng, centre, radius, corners)


def spec(rng):
    scale = math.exp(rng.uniform(math.log(0.1), math.log(10)))
    rotation = rng.choice([0, 90, 180, -90]) if rng.random() < 0.25 else rng.uniform(-180, 180)
    if abs(scale - 1) < 1e-3 and abs(rotation) < 0.1:
        scale = 2
    away, bearing = rng.uniform(40, 400), rng.uniform(-math.pi, math.pi)
    centre, radius = (away * math.cos(bearing), away * math.sin(bearing)), away * rng.uniform(0.02, 0.8)
    width = rng.uniform(2, 25)
    one = {"copy": {"scale": scale, "rotation_deg": rotation},
           "region": {"polygon_mm": outline(rng, centre, radius, rng.randint(3, 30))},
           "pole": {"at_mm": [0, 0]},
           "links": {"width_mm": width, "pin_diameter_mm": width * rng.uniform(0.2, 1), "layers": rng.choice([2, 3]),
                     "plate": rng.choice(["bent", "triangle"]), "shortest_mm": rng.uniform(1, 40),
                     "longest_mm": rng.uniform(200, 2000)},
           "limits": {"transmission_deg": rng.uniform(0, 50), "clearance_mm": rng.uniform(0, 3)}}
    if rng.random() < 1 / 3:
        reach = rng.uniform(5, 60)
        one["pole"] = {"within_mm": [[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]]}
    if rng.random() < 1 / 3:
        one["objective"] = {"maximize": "transmission"}
    if rng.random() < 1 / 4:
        one["tolerance"] = {"length_mm": rng.uniform(0.01, 0.1), "play_mm": rng.uniform(0, 0.05)}
        if rng.random() < 1 / 2:
            one["limits"]["copy_error_mm"] = rng.uniform(0.1, 2) * max(1, scale)
        if rng.random() < 1 / 2:
            one["objective"] = {"minimize": rng.choice(["copy_error", "copy_error", "copy_error", "footprint"])}
    if rng.random() < 1 / 12:
        one["links"]["grid_mm"] = rng.choice([1, 2, 5])
    if rng.random() < 1 / 6:
        one["limits"]["sheets_gap_mm"] = rng.uniform(0, 20)
    if rng.random() < 1 / 3:
        one["obstacles"] = []
        for _ in range(rng.randint(1, 4)):
            turn, far = rng.uniform(-math.pi, math.pi), away * rng.uniform(0.3, 3)
            one["obstacles"].append({"polygon_mm": outline(rng, (far * math.cos(turn), far * math.sin(turn)),
                                                          rng.uniform(3, 0.2 * away + 3), rng.randint(3, 12)),
                                    "layers": rng.choice([[1, 1], [1, 2], [2, 2]])})
    return one


def gap(design):
    """How far the design is from its bound, as a share; None without a bound."""
    bound, value = design.get("lower_bound"), design.get("value")
    return None if bound is None or not bound else abs(value - bound) / abs(bound)


def report(rows):
    states = collections.Counter(row["status"] for row in rows)
    print("outcomes            ", dict(states))
    designs = [row for row in rows if row["status"] == "design"]
    print("groundings          ", dict(collections.Counter(row["vertex"] for row in designs)))
    for free, kind in ((True, "no obstacles"), (False, "obstacles")):
        gaps = sorted(g for row in designs if row["plain"] == free for g in [gap(row)] if g is not None)
        if gaps:
            # A tree ends a ten-thousandth of the design's value from it, which is a little more of the bound's.
            within = {share: sum(g <= 1.001 * share for g in gaps) for share in (1e-4, 1e-3, 1e-2, 5e-2)}
            print(f"{kind:20s} {len(gaps)} with a bound; within 0.01 %: {within[1e-4]}, 0.1 %: {within[1e-3]}, 1 %: "
                  f"{within[1e-2]}, 5 %: {within[5e-2]}; worst {100 * gaps[-1]:.2g} %")
    none = [row for row in rows if row["status"] in ("no design", "none found")]
    print(f"no design            {len(none)}, proven {sum(bool(row.get('proven')) for row in none)}")
    for row in rows:
        if row["status"] not in ("design", "no design", "none found"):
            print("FAILED", json.dumps(row)[:300])


def written(arguments):
    """KEMPE [COUNT] [SEED] [FOLDER]: the program, the folder, its random specs, and the file of them, written there, a line each."""
    count, seed = (int(arguments[i]) if len(arguments) > i else default for i, default in ((1, 1000), (2, 1)))
    folder = pathlib.Path(arguments[3] if len(arguments) > 3 else tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    rng = random.Random(seed)
    specs = [spec(rng) for _ in range(count)]
    lines = folder / "specs.jsonl"
    lines.write_text("".join(json.dumps(one) + "\n" for one in specs))
    return arguments[0], folder, specs, lines


def main():
    kempe, folder, specs, lines = written(sys.argv[1:])
    subprocess.run([kempe, "synthesize", "--batch", lines, "-o", folder / "out", "--quiet"], check=False)
    rows = [json.loads(line) for line in (folder / "out" / "results.jsonl").read_text().splitlines()]
    for one, row in zip(specs, rows):
        row["plain"] = "obstacles" not in one
    report(rows)


if __name__ == "__main__":
    main()
