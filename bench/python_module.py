"""The Python module beside the library that it calls."""
import json
import os
import pathlib
import subprocess
import tempfile

from measure import SYSTEM_PYTHON, Row, json_of, shown

IMPORT = "import time; begin = time.process_time(); import kempe; print(time.process_time() - begin)"
# The places of python_bench.cpp; CPU time, the least of several rounds.
WORK = """
import json, sys, time
import numpy as np
import kempe
file, count, rounds = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
spec = kempe.Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "pin_diameter_mm": 3})
design = kempe.synthesize(spec)
open(file, "w").write(design.to_json())
share = np.arange(count) / count
points = 90 * share[:, None] * np.stack([np.cos(1000 * share), np.sin(1000 * share)], axis=-1)

def least(work):
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        result = work()
        times.append(time.process_time() - begin)
    return min(times), result

seconds, pens = least(lambda: design.pen(points))
wall = []
for _ in range(rounds):
    begin = time.perf_counter()
    kempe.Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "pin_diameter_mm": 3})
    wall.append(time.perf_counter() - begin)
search, _ = least(lambda: kempe.synthesize(spec, threads=1))
print(json.dumps({"search": search, "seconds": seconds, "sum": float(np.nansum(pens)), "spec": min(wall)}))
"""


def rows(context):
    environment = {**os.environ, "PYTHONPATH": str(context.build / "python")}

    def python(*words):
        return subprocess.run([SYSTEM_PYTHON, "-c", *map(str, words)], env=environment, check=True, capture_output=True, text=True).stdout

    rounds = 5 if context.quick else 15
    with tempfile.TemporaryDirectory() as scratch:
        file = pathlib.Path(scratch) / "design.json"
        ours = json.loads(python(WORK, file, 10**6, rounds))
        theirs = json_of(context.program("python"), file, 10**6, rounds)
    ratio = ours["seconds"] / theirs["seconds"]
    same = abs(ours["sum"] - theirs["sum"]) <= 1e-9 * 1e8
    yield Row("Python: design.pen", "10^6 places, a loop in C++", shown(ours["seconds"]), f"C++ {shown(theirs['seconds'])}", f"{ratio:.2f}",
              "1.3, same places", ratio <= 1.3 and same)
    begin = min(float(python(IMPORT)) for _ in range(rounds))
    yield Row("Python: import kempe", "NumPy included", shown(begin), "", "", "0.2 s", begin < 0.2)
    yield Row("Python: a spec by keywords", "plagiograph", shown(ours["spec"]), "", "", "1 ms", ours["spec"] < 1e-3)
    added = ours["search"] - theirs["design"]
    yield Row("Python: kempe.synthesize", "plagiograph, one thread", shown(ours["search"]), f"C++ {shown(theirs['design'])}",
              f"{ours['search'] / theirs['design']:.2f}", "1 ms more", added < 1e-3)
