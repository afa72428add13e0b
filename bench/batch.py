"""A batch on threads and on MPI ranks: how it scales; and the memory of a long one."""
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


def refused(file, count):
    """Specs without a search: what is kept of one is the same."""
    with open(file, "w") as lines:
        lines.writelines(json.dumps({"copy": {"scale": -1 - i}}) + "\n" for i in range(count))


def memory(context, scratch):
    used = {}
    for count in (1000, 20_000 if context.quick else 100_000):
        source = scratch / f"{count}.jsonl"
        refused(source, count)
        run = metered([context.kempe, "synthesize", "--batch", source, "-o", scratch / f"out-{count}", "-j", 2, "--quiet"])
        used[count] = run.memory_mb
    (few, small), (many, large) = used.items()
    yield Row("memory of a batch", f"{few} and {many} specs that are refused", f"{small:.1f} MB, {large:.1f} MB", "",
              f"{large / small:.2f}", "1.1", large < 1.1 * small)


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
            yield Row("batch", f"{count} specs, {how} on {cores} cores",
                      f"{run.wall_s:.1f} s, {run.cpu_s:.1f} s CPU, {count / run.cpu_s:.0f} specs a second and core, {same}", "",
                      f"{first[0] / run.wall_s:.2f}", "same bytes", result == first[1])
        yield from memory(context, pathlib.Path(scratch))
    if not mpi:
        yield Row("batch", "MPI ranks", "Open MPI absent")
