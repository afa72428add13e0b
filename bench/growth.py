"""Growth curves and their fitted exponents: time ~ n^e."""
import json
import math
import pathlib
import random
import tempfile

from measure import Row, exponent, google_benchmarks, metered, n_log_n_exponent, shown

SLACK = 0.05  # by which noise may lift an exponent


def row(what, sizes, times, unit):
    fitted, allowed = exponent(sizes, times), n_log_n_exponent(sizes)
    points = ", ".join(f"{n}: {shown(t)}" for n, t in zip(sizes, times))
    return Row(f"growth with {what}", f"{unit} {sizes[0]} .. {sizes[-1]}", points, "", f"n^{fitted:.2f}",
               f"n log n (n^{allowed:.2f} here)", fitted <= allowed + SLACK)


def wave(n):
    """A disc with a wavy outline: a circle about the pole meets few of its edges."""
    ring = []
    for i in range(n):
        t = 2 * math.pi * i / n
        r = 20 + 2 * math.sin(9 * t) + 0.3 * math.sin(57 * t)
        ring.append([120 + r * math.cos(t), r * math.sin(t)])
    return ring


def comb(n):
    """A square whose right half is slit into teeth: circles about the pole cross every edge."""
    teeth = n // 4
    ring = [[100, -20]]
    for i in range(teeth):
        y = -20 + 40 * i / teeth
        ring += [[140, y], [140, y + 20 / teeth], [120, y + 20 / teeth], [120, y + 40 / teeth]]
    return ring + [[100, 20]]


def synthesized(context, folder, outline, n):
    """The run of synthesize, whole command, with a region of n corners in a GeoJSON file."""
    ring = outline(n)
    (folder / "region.geojson").write_text(json.dumps({"type": "Polygon", "coordinates": [ring + ring[:1]]}))
    spec = folder / "spec.toml"
    spec.write_text('copy = {scale = 1.4, rotation_deg = 90}\nregion = {file = "region.geojson"}\npole = {at_mm = [0, 0]}\n')
    run = metered([context.kempe, "synthesize", spec, "-o", folder / "out", "-j", "1", "--quiet"])
    if run.code != 0:
        raise RuntimeError(run.stderr)
    return run


def vertices(context, folder):
    sizes = [100, 1000, 10_000, 100_000] + ([] if context.quick else [1_000_000])
    runs = [synthesized(context, folder, wave, n) for n in sizes]
    yield row("corners of the region (synthesize, files included)", sizes, [run.cpu_s for run in runs], "corners")
    memory = max(run.memory_mb for run in runs)
    yield Row("peak memory of the same", f"{sizes[-1]} corners", f"{memory:.0f} MB", "", "", "300 MB", memory < 300)
    sizes = [100, 1000, 10_000] + ([] if context.quick else [100_000])
    times = [synthesized(context, folder, comb, n).cpu_s for n in sizes]
    yield row("corners of a comb (synthesize, files included)", sizes, times, "corners")


def readings(context, folder):
    """calibrate from n readings: the example's two settings with rounded noise."""
    sizes = [10, 100, 1000, 10_000] + ([] if context.quick else [100_000])
    times, memory, rng = [], 0, random.Random(3)
    for n in sizes:
        text = ["[instrument]\narm_mm = 500\nratio = 0.5\n[fit]\nfree = [\"scales\", \"arms\"]\nreading_uncertainty_mm = 0.01\n"]
        for i in range(n):
            angle = 20 + 50 * (i + 0.5) / n
            t = math.radians(angle)
            x = 0.2 * math.cos(t) + 0.1 * math.cos(2 * t) + rng.gauss(0, 0.01)
            y = 0.3 * math.sin(t) - 0.1 * math.cos(2 * t) + rng.gauss(0, 0.01)
            ratio = "ratio = 0.25\n" if i % 2 else ""
            text.append(f"[[reading]]\narm_angle_deg = {angle:.6f}\nerror_mm = [{x:.4f}, {y:.4f}]\n{ratio}")
        file = folder / "readings.toml"
        file.write_text("".join(text))
        run = metered([context.kempe, "calibrate", file, "--json"])
        if run.code != 0:
            raise RuntimeError(run.stderr)
        times.append(run.cpu_s)
        memory = max(memory, run.memory_mb)
    yield row("readings (calibrate, whole command)", sizes, times, "readings")
    yield Row("peak memory of the same", f"{sizes[-1]} readings", f"{memory:.0f} MB", "", "", "300 MB", memory < 300)


def rows(context):
    times = google_benchmarks(context.program("kernels"), "^pose_batch", 0.05 if context.quick else 0.3, 2)
    sizes = [10 ** e for e in range(3, 8)]
    yield row("poses (in columns)", sizes, [times[f"pose_batch/{n}"] for n in sizes], "poses")
    counts = [1, 2, 5, 10, 25, 50, 100, 200, 400]
    times = google_benchmarks(context.program("workspace"), "^map_by_obstacles", 0.05, 1 if context.quick else 3)
    yield row("obstacles (map)", counts, [times[f"map_by_obstacles/{n}"] for n in counts], "obstacles of 20 corners,")
    with tempfile.TemporaryDirectory() as scratch:
        yield from vertices(context, pathlib.Path(scratch))
        yield from readings(context, pathlib.Path(scratch))
