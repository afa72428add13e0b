#!/usr/bin/env python3
"""A plain sampler of the two angles with NumPy and Shapely: is a link within the clearance of an obstacle?

Reads the scene that kempe_sampler_bench prints on stdin; prints CPU seconds a sample and the share of free samples. Poses
are computed for all samples at once; pins and posts are left out, which is to its advantage.
"""
import json
import math
import sys
import time

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.ops import unary_union
from shapely.prepared import prep

SAMPLES = 4000


def poses(scene, rng):
    d = rng.uniform(*scene["opening"], SAMPLES)
    bearing = rng.uniform(-math.pi, math.pi, SAMPLES)
    s, p = complex(*scene["shape"]), scene["VA_mm"] + 0j
    q = scene["VB_mm"] * np.exp(1j * d)
    chain = p + q / s
    turn = np.exp(1j * bearing) * np.abs(chain) / chain
    A, B = p * turn, q * turn
    return dict(V=0 * A, A=A, B=B, C=A + B, X=A + B / s, Y=B + A * s)


def main():
    scene = json.load(sys.stdin)
    start = time.process_time()
    reach = scene["width_mm"] / 2 + scene["clearance_mm"]
    forbidden = prep(unary_union([Polygon(ring) for ring in scene["obstacles"]]).buffer(reach))
    once = time.process_time() - start
    start = time.process_time()
    z = poses(scene, np.random.default_rng(5))
    lines = [np.stack([np.stack([z[j].real, z[j].imag], axis=1) for j in link], axis=1).tolist()
             for link in ("VA", "VB", "CAX", "CBY")]
    free = sum(not any(forbidden.intersects(LineString(link)) for link in links) for links in zip(*lines))
    spent = time.process_time() - start
    json.dump({"sample_s": spent / SAMPLES, "once_s": once, "free_share": free / SAMPLES}, sys.stdout)


main()
