"""A batch on threads and on MPI ranks: how it scales."""
import json
import os
import pathlib
import shutil
import tempfile

from measure import Row, metered


def specs(count):
    for i in range(count):
        yield {"copy": {"scale": 1.2 + 2 * i / count, "rotation_deg": 30 + 120 * i / count},
               "region": {"rectangle_mm": {"at": [60, -10], "size": [20, 20]}}, "pole": {"at_mm": [0, 0]},
               "links": {"width_mm": 6, "pin_diameter_mm": 3}}


def rows(context):
    count = 24 if context.quick else 96
    cores = os.cpu_count()
    mpi = shutil.which("mpirun")
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_rmaps_base_oversubscribe": "1"}
    with tempfile.TemporaryDirectory() as scratch:
        source = pathlib.Path(scratch) / "specs.jsonl"
        source.write_text("".join(json.dumps(spec) + "\n" for spec in specs(count)))
        first = None
        ways = [([], 1), ([], 2)] + [([mpi, "-n", str(n)], 1) for n in (1, 2, 4) if mpi]
        for launch, jobs in ways:
            out = pathlib.Path(scratch) / f"out-{len(launch) and launch[2]}-{jobs}"
            run = metered([*launch, context.kempe, "synthesize", "--batch", source, "-o", out, "-j", jobs, "--quiet"],
                          env=environment)
            if run.code != 0:
                yield Row("batch", f"{count} specs", run.stderr.strip().splitlines()[0])
                continue
            result = (out / "results.jsonl").read_bytes()
            first = first or (run.wall_s, result)
            how = f"{launch[2]} MPI ranks" if launch else f"{jobs} threads"
            same = "same bytes" if result == first[1] else "OTHER BYTES"
            yield Row("batch", f"{count} specs, {how} on {cores} cores", f"{run.wall_s:.1f} s, {run.cpu_s:.1f} s CPU, {same}", "",
                      f"{first[0] / run.wall_s:.2f}", "same bytes", result == first[1])
    if not mpi:
        yield Row("batch", "MPI ranks", "Open MPI absent")
