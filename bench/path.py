#!/usr/bin/env python3
"""The three path tasks of Cabrera, Simon and Prado (Mechanism and Machine Theory 37, 2002, 1165-1177) by `kempe path` and by SciPy's
differential evolution, on one machine in one run: the sum of squared distances, evaluations of the whole path, seconds of CPU.

Both have the same freedom: pivots anywhere within the published bounds, every length within them, the first crank angle free. The
published second case fixes both pivots' line, which the tasks here leave free. Differential evolution works on all unknowns as the
literature does (pivots, lengths, coupler point, angles), 15 for each unknown in its population, and pays for every point at which
the loop does not close; its best of SEEDS runs is shown, with the evaluations and seconds of all of them.

Where pylinkage (PyPI) is installed, its path_generation is asked too. It meets points exactly by Burmester's theory over a grid of coupler angles,
takes no timing and no limits, and its cost grows exponentially with the points, so the first task alone is given to it, with linkages that are not Grashof's allowed.

usage: path.py KEMPE [SEEDS]     needs NumPy and SciPy; pylinkage if it is there
"""
import importlib.metadata
import importlib.util
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time
import warnings

import numpy as np
from scipy.optimize import differential_evolution

LOOP = [[0.5, 1.1], [0.4, 1.1], [0.3, 1.1], [0.2, 1.0], [0.1, 0.9], [0.05, 0.75], [0.02, 0.6], [0, 0.5], [0, 0.4],
        [0.03, 0.3], [0.1, 0.25], [0.15, 0.2], [0.2, 0.3], [0.3, 0.4], [0.4, 0.5], [0.5, 0.7], [0.6, 0.9], [0.6, 1.0]]
TASKS = [("case 1: six points of a line, timing free", [[20, 20 + 5 * i] for i in range(6)], None, 60),
         ("case 2: five points with timing", [[3, 3], [2.759, 3.363], [2.372, 3.663], [1.890, 3.862], [1.355, 3.943]],
          [30, 45, 60, 75, 90], 50),
         ("case 3: loop of eighteen points, timing from a free angle", LOOP, [20 * i for i in range(18)], 50)]


def by_kempe(kempe, points, timing, bound):
    text = f"[path]\npoints_mm = {points}\n" + (f"driver_deg = {timing}\n" if timing else "")
    text += f"[limits]\nlongest_mm = {bound}\npivots_within_mm = [[-{bound}, -{bound}], [{bound}, -{bound}], [{bound}, {bound}], [-{bound}, {bound}]]\n"
    with tempfile.TemporaryDirectory() as folder:
        spec = pathlib.Path(folder) / "spec.toml"
        spec.write_text(text)
        start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run = subprocess.run([kempe, "path", spec, "--json"], capture_output=True, text=True, check=True)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start
    answer = json.loads(run.stdout)
    return answer["answers"][0]["error_rms_mm"] ** 2 * len(points), answer["searched"]["evaluations"], answer["searched"]["starts"], seconds


def cost(points, timing):
    wanted = np.array([complex(*p) for p in points])[:, None]
    turns = None if timing is None else np.radians(np.array(timing) - timing[0])[:, None]

    looked = [0]

    def square(x):  # one column for each member of the population
        x = x.reshape(x.shape[0], -1)
        looked[0] += x.shape[1]
        A0, B0 = x[0] + 1j * x[1], x[2] + 1j * x[3]
        a, b, c, p, q, mode = x[4], x[5], x[6], x[7], x[8], np.where(x[9] < 0, -1, 1)
        if turns is None:  # the crank turns one way: the first angle, then the steps, of either sense
            angle = x[10] + np.sign(x[11] - 0.5) * np.cumsum(np.vstack([np.zeros_like(x[10]), np.abs(x[12:])]), axis=0)
            over = np.maximum(0, np.abs(x[12:]).sum(axis=0) - 2 * np.pi)
        else:
            angle, over = x[10] + turns, 0
        A = A0 + a * np.exp(1j * angle)
        gap = A - B0
        e = np.abs(gap) + 1e-300
        cosine = (e * e + c * c - b * b) / (2 * e * c)
        B = B0 + c * gap / e * np.exp(1j * mode * np.arccos(np.clip(cosine, -1, 1)))
        P = A + (p + 1j * q) * (B - A) / b
        missing = np.maximum(0, np.abs(cosine) - 1)
        return (np.abs(P - wanted) ** 2).sum(axis=0) + 1e3 * missing.sum(axis=0) + 1e3 * over

    return lambda x: square(x) if x.ndim > 1 else float(square(x)[0]), looked


def by_evolution(points, timing, bound, seeds):
    bounds = [(-bound, bound)] * 4 + [(1e-2, bound)] * 3 + [(-bound, bound)] * 2 + [(-1, 1), (-np.pi, np.pi)]
    if timing is None:
        bounds += [(0, 1)] + [(1e-3, 3)] * (len(points) - 1)
    best, evaluations, start = np.inf, 0, time.process_time()
    for seed in range(seeds):
        square, looked = cost(points, timing)
        result = differential_evolution(square, bounds, vectorized=True, updating="deferred", maxiter=5000,
                                        tol=1e-12, seed=seed, polish=False)
        best, evaluations = min(best, float(result.fun)), evaluations + looked[0]
    return best, evaluations, time.process_time() - start


def by_pylinkage(points):
    """How many linkages its search returns, and seconds of CPU."""
    from pylinkage.synthesis import path_generation
    start = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = path_generation([tuple(map(float, point)) for point in points], max_solutions=3, require_grashof=False)
    return len(found.solutions), time.process_time() - start


def main():
    kempe, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    for name, points, timing, bound in TASKS:
        error, evaluations, starts, seconds = by_kempe(kempe, points, timing, bound)
        print(f"{name}\n  kempe path              {error:10.3e} mm^2  {evaluations:9d} evaluations, {starts} linear fits  {seconds:6.2f} s", flush=True)
        error, evaluations, seconds = by_evolution(points, timing, bound, seeds)
        print(f"  differential evolution  {error:10.3e} mm^2  {evaluations:9d} evaluations, {seeds} runs  {seconds:6.2f} s", flush=True)
        if importlib.util.find_spec("pylinkage") and timing is None:
            found, seconds = by_pylinkage(points)
            print(f"  pylinkage {importlib.metadata.version('pylinkage')}         {found} linkages through all points  {seconds:6.2f} s", flush=True)


main()
