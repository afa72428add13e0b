#!/usr/bin/env python3
"""The three path tasks of Cabrera, Simon and Prado (Mechanism and Machine Theory 37, 2002, 1165-1177) by `kempe path`, beside the best
published linkages, SciPy's differential evolution, pylinkage (PyPI) and the crate four-bar (crates.io), on one machine in one run: the
sum of squared distances, evaluations of the whole path, seconds of CPU.

Points, bounds and published linkages are those of the code to Nguyen-Van and others (Symmetry 14(2), 2022, 381; GitHub,
sy-nguyen-van/DE_Jaya_Synthesis_Four_Bar_Mechanisms, folders Case1 to Case3), which has the linkages of others too. Each is computed
again here by the formula of that code, which has one assembly mode alone, and so are the answers of `kempe path`, which must be a Grashof linkage with the crank as its
shortest link and all lengths within the bounds, as published. Kempe's own limits are narrower: the rocker's pivot lies within the
bounds too, no length is longer than them.

Differential evolution works on all unknowns as the literature does (pivots, lengths, coupler point, angles), 15 for each
unknown in its population, pays for every point at which the loop does not close, and is not asked for a Grashof linkage; its best of SEEDS
runs is shown, with the evaluations and seconds of all of them.

pylinkage meets points exactly by Burmester's theory over a grid of coupler angles, takes no timing and no limits, and its cost grows exponentially
with the points, so the first task alone is given to it, with linkages that are not Grashof's allowed.

four-bar fits shapes by elliptical Fourier descriptors and takes neither timing nor limits, so it has the points alone; its error is the
distance of each point from the nearest place of its whole curve, in any order, which no fit in order can be below. `kempe path` does the same points with the timing
free. Its client, peers/four_bar, is built with cargo here when this runs; the crate's licence is AGPL-3.0-or-later, nothing of it is shipped.

usage: path.py KEMPE [SEEDS]     needs NumPy and SciPy; pylinkage and cargo if they are there
"""
import importlib.metadata
import importlib.util
import json
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import warnings

import numpy as np
from scipy.optimize import differential_evolution

LOOP = [[0.5, 1.1], [0.4, 1.1], [0.3, 1.1], [0.2, 1.0], [0.1, 0.9], [0.05, 0.75], [0.02, 0.6], [0, 0.5], [0, 0.4],
        [0.03, 0.3], [0.1, 0.25], [0.15, 0.2], [0.2, 0.3], [0.3, 0.4], [0.4, 0.5], [0.5, 0.7], [0.6, 0.9], [0.6, 1.0]]
LINE = [[20, 20 + 5 * i] for i in range(6)]
FIVE = [[3, 3], [2.759, 3.363], [2.372, 3.663], [1.890, 3.862], [1.355, 3.943]]
FIVE_ANGLES, LOOP_ANGLES = [30, 45, 60, 75, 90], [20 * i for i in range(18)]

# Published linkages: ground, crank, coupler, rocker, coupler point along and beside, crank's pivot, ground link's direction; then the crank's
# angles from the ground link, or the first of them.
LIN_HSIAO = [45.9540268793200, 10.1413352283990, 36.1198616002200, 49.7905570636800, 51.4935231082160, 16.4957302836340,
             59.9251894962240, -0.2672551778894, 0.8623849541875,
             4.4968313984955, 3.9468529220684, 3.5120853909802, 3.1107812488088, 2.7101093119519, 2.2654986625734]
MUMSA_LINE = [31.78826, 8.20465, 24.93213, 31.38593, 34.19372, 14.41567, -6.36652, 56.83676, 4.01596,
              1.36655, 2.33077, 2.87104, 3.39459, 3.97096, 4.96349]
HCDJ_LINE = [14.201369, 8.0143127, 16.309922, 12.253871, 27.797721, 11.305412, -2.3095310, 45.695083, 4.5172417,
             6.2532447, 2.4038981, 2.9362397, 3.4905751, 4.0650776, 5.2095019]
CABRERA_FIVE = [3.0630424, 1.9959624, 3.305823, 2.524706, 1.645158, 1.708959, 0, 0, 0, np.pi / 6]
MUMSA_FIVE = [3.77326856, 2.00000403, 4.11697104, 2.74615671, 1.67848787, 1.67098007, 0, 0, 0, np.pi / 6]
HCDJ_FIVE = [4.2930812, 1.9978324, 4.7374099, 2.9417301, 1.7074051, 1.6441696, 0, 0, 0, np.pi / 6]
CABRERA_LOOP = [3.057878, 0.237803, 4.828954, 2.056456, 0.767038, 1.850828, 1.776808, -0.641991, 1.002168, 0.226186]
MUMSA_LOOP = [4.453772, 0.297057, 3.913095, 0.849372, -2.067338, 1.6610626, -1.309243, 2.806964, 2.7387359, 4.853543]
HCDJ_LOOP = [49.800886, 0.28817159, 48.476138, 1.6336420, -23.412810, 7.6644886, -14.836153, 20.140223, 2.5286091, 5.0644224]

GIVEN = {"crank_pivot_mm": [0, 0], "ground_deg": 0, "first_angle_deg": 30}
# name, points, crank angles in degrees or None, bound, what is given, published linkages
TASKS = [("case 1: six points of a line, timing free", LINE, None, 60, {},
          {"MUMSA": MUMSA_LINE, "Lin and Hsiao": LIN_HSIAO, "Nguyen-Van and others": HCDJ_LINE}),
         ("case 2: five points with timing, crank's pivot, ground link's direction and first angle given", FIVE, FIVE_ANGLES, 50, GIVEN,
          {"Cabrera, Simon, Prado": CABRERA_FIVE, "MUMSA": MUMSA_FIVE, "Nguyen-Van and others": HCDJ_FIVE}),
         ("case 2 without what is given", FIVE, FIVE_ANGLES, 50, {}, {}),
         ("case 3: loop of eighteen points, timing from a free angle", LOOP, LOOP_ANGLES, 50, {},
          {"Cabrera, Simon, Prado": CABRERA_LOOP, "MUMSA": MUMSA_LOOP, "Nguyen-Van and others": HCDJ_LOOP})]
SHAPES = [("six points of a line", LINE, 60, ["open", "partial"]), ("five points", FIVE, 50, ["open", "partial"]), ("loop of eighteen points", LOOP, 50, ["closed"])]


def published_error(linkage, points, angles):
    """The sum of squared distances by the published formula; infinity where the loop opens."""
    r1, r2, r3, r4, along, beside, x0, y0, base = linkage[:9]
    total = 0
    for point, angle in zip(points, angles, strict=True):
        k1, k4, k5 = r1 / r2, r1 / r3, (r4**2 - r1**2 - r2**2 - r3**2) / (2 * r3 * r2)
        d, e, f = np.cos(angle) - k1 + k4 * np.cos(angle) + k5, -2 * np.sin(angle), k1 + (k4 - 1) * np.cos(angle) + k5
        if e * e < 4 * d * f:
            return np.inf
        coupler = 2 * np.arctan((-e - np.sqrt(e * e - 4 * d * f)) / (2 * d))
        place = r2 * np.exp(1j * angle) + (along + 1j * beside) * np.exp(1j * coupler)
        total += abs(place * np.exp(1j * base) + complex(x0, y0) - complex(*point)) ** 2
    return total


def published_angles(linkage, timing):
    first = linkage[9]
    return linkage[9:] if timing is None else [first + np.radians(angle - timing[0]) for angle in timing]


def as_published(answer, bound):
    """An answer's unknowns and crank angles in the published form, and whether they keep the published limits."""
    crank_pivot, rocker_pivot = (complex(*pivot) for pivot in answer["pivots_mm"])
    base = np.angle(rocker_pivot - crank_pivot)
    lengths = [abs(rocker_pivot - crank_pivot), answer["crank_mm"], answer["coupler_mm"], answer["rocker_mm"]]
    linkage = [*lengths, *answer["coupler_point_mm"], crank_pivot.real, crank_pivot.imag, base]
    rest = sorted(lengths)
    kept = (lengths[1] == rest[0] and rest[0] + rest[3] <= rest[1] + rest[2] and answer["driver_deg"][1] > answer["driver_deg"][0]
            and max(abs(value) for value in linkage[:8]) <= bound)
    return linkage, np.radians(answer["driver_deg"]) - base, kept


def by_kempe(kempe, points, timing, bound, given):
    text = f"[path]\npoints_mm = {points}\n" + (f"driver_deg = {timing}\n" if timing else "")
    text += f"[limits]\nlongest_mm = {bound}\npivots_within_mm = [[-{bound}, -{bound}], [{bound}, -{bound}], [{bound}, {bound}], [-{bound}, {bound}]]\n"
    text += "".join(f"{key} = {value}\n" for key, value in given.items())
    with tempfile.TemporaryDirectory() as folder:
        spec = pathlib.Path(folder) / "spec.toml"
        spec.write_text(text)
        start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run = subprocess.run([kempe, "path", spec, "--json"], capture_output=True, text=True, check=True)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start
    answer = json.loads(run.stdout)
    best = answer["answers"][0]
    return answer["answers"], best["error_rms_mm"] ** 2 * len(points), answer["searched"]["evaluations"], answer["searched"]["starts"], seconds


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


def by_evolution(points, timing, bound, given, seeds):
    bounds = [(-bound, bound)] * 4 + [(1e-2, bound)] * 3 + [(-bound, bound)] * 2 + [(-1, 1), (-np.pi, np.pi)]
    if given:  # the crank's pivot at the origin, the ground link along x, the first angle
        bounds[:4] = [(0, 0), (0, 0), (1e-2, bound), (0, 0)]
        bounds[10] = (np.radians(given["first_angle_deg"]),) * 2
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


def client_of_four_bar():
    """The crate's client, built; or a sentence that says why not."""
    if not shutil.which("cargo"):
        return None, "cargo is not there"
    source = pathlib.Path(__file__).resolve().parent / "peers" / "four_bar"
    target = pathlib.Path(tempfile.gettempdir()) / "kempe-bench-four-bar"
    shutil.copytree(source, target, dirs_exist_ok=True)  # cargo writes a lock file beside its sources
    built = subprocess.run(["cargo", "build", "--release", "--quiet", "--manifest-path", target / "Cargo.toml"], capture_output=True, text=True)
    if built.returncode != 0:
        return None, "it could not be built: " + (built.stderr.strip().splitlines() or ["no word"])[-1]
    return target / "target" / "release" / "four-bar-peer", ""


def by_four_bar(client, points, modes, generations=500, population=200):
    """Its best of its ways to see the points: sum of squares from the nearest places of its curve, and evaluations and seconds of all."""
    best, evaluations, seconds = np.inf, 0, 0.0
    for mode in modes:
        start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run = subprocess.run([client, mode, str(generations), str(population), "1"], input="\n".join(f"{x} {y}" for x, y in points),
                             capture_output=True, text=True, check=True)
        seconds += resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start
        looked, *lines = run.stdout.splitlines()
        evaluations += int(looked)
        curve = np.array([complex(*map(float, line.split())) for line in lines])
        if curve.size < 2:
            continue
        wanted, along = np.array([complex(*p) for p in points])[:, None], np.diff(curve)
        share = np.clip(((wanted - curve[:-1]) * along.conj()).real / (np.abs(along) ** 2 + 1e-300), 0, 1)
        best = min(best, float((np.abs(wanted - curve[:-1] - share * along) ** 2).min(axis=1).sum()))
    return best, evaluations, seconds


def main():
    kempe, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    for name, points, timing, bound, given, published in TASKS:
        answers, error, evaluations, starts, seconds = by_kempe(kempe, points, timing, bound, given)
        print(f"{name}\n  kempe path              {error:10.3e} mm^2  {evaluations:9d} evaluations, {starts} linear fits  {seconds:6.2f} s", flush=True)
        if published:
            forms = [as_published(answer, bound) for answer in answers]
            least = min([published_error(linkage, points, angles) for linkage, angles, kept in forms if kept], default=np.inf)
            print(f"    by the published formula {least:10.3e} mm^2, the least of its answers within the published limits")
        for who, linkage in published.items():
            print(f"    published, {who:24s} {published_error(linkage, points, published_angles(linkage, timing)):10.3e} mm^2")
        error, evaluations, seconds = by_evolution(points, timing, bound, given, seeds)
        print(f"  differential evolution  {error:10.3e} mm^2  {evaluations:9d} evaluations, {seeds} runs  {seconds:6.2f} s", flush=True)
        if timing is None and not importlib.util.find_spec("pylinkage"):
            print("  pylinkage is not there")
        elif timing is None:
            found, seconds = by_pylinkage(points)
            print(f"  pylinkage {importlib.metadata.version('pylinkage')}         {found} linkages through all points  {seconds:6.2f} s", flush=True)
    client, why_not = client_of_four_bar()
    if client is None:
        print(f"the crate four-bar is left out: {why_not}")
        return
    for name, points, bound, modes in SHAPES:
        _, error, evaluations, starts, seconds = by_kempe(kempe, points, None, bound, {})
        print(f"{name}, the shape alone\n  kempe path, timing free {error:10.3e} mm^2  {evaluations:9d} evaluations, {starts} linear fits  {seconds:6.2f} s", flush=True)
        error, evaluations, seconds = by_four_bar(client, points, modes)
        print(f"  four-bar 7.0.5          {error:10.3e} mm^2  {evaluations:9d} evaluations, {len(modes)} runs  {seconds:6.2f} s", flush=True)


main()
