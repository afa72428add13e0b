"""Twelve specs beside SciPy's differential evolution: objective and CPU time. And what synthesize may cost."""
import json
import tempfile

from measure import EXAMPLES, HOME, SYSTEM_PYTHON, Row, metered

CPU_TARGET, OBJECTIVE_TARGET = 100, 1.005


def designed(context, spec):
    """The whole command: search, bound, map, verification, files."""
    with tempfile.TemporaryDirectory() as out:
        return metered([context.kempe, "synthesize", spec, "-o", out, "-j", "1", "--json"])


def beside_scipy(context):
    effort = ["--seeds", "1", "--iterations", "60"] if context.quick else ["--seeds", "5", "--iterations", "200"]
    for spec in sorted((HOME / "specs").glob("*.toml")):
        run = designed(context, spec)
        if run.code != 0:
            yield Row("synthesis", spec.stem, run.stderr.strip().replace("\n", " "), reached=False)
            continue
        search = json.loads(run.stdout)["search"]
        peer = metered([SYSTEM_PYTHON, HOME / "peers" / "differential_evolution.py", spec, *effort])
        own = f"{search['objective']} {search['value']:.4f}, {run.cpu_s:.2f} s CPU"
        if peer.code != 0:
            yield Row("synthesis", spec.stem, own, "SciPy absent")
            continue
        peer = json.loads(peer.stdout)
        ratio = peer["cpu_s"] / run.cpu_s
        if not peer["feasible"]:
            yield Row("synthesis", spec.stem, own, f"found no design, {peer['cpu_s']:.0f} s CPU", f"CPU {ratio:.0f}",
                      f"CPU {CPU_TARGET}", ratio >= CPU_TARGET)
            continue
        worse = peer["objective"] / search["value"] if search["objective"] == "transmission" else search["value"] / peer["objective"]
        yield Row("synthesis", spec.stem, own, f"{peer['objective']:.4f}, {peer['cpu_s']:.0f} s CPU",
                  f"objective {worse:.4f}, CPU {ratio:.0f}", f"objective {OBJECTIVE_TARGET}, CPU {CPU_TARGET}",
                  worse <= OBJECTIVE_TARGET and ratio >= CPU_TARGET)


def costs(context):
    for on, spec, target in (("plagiograph, no obstacle", EXAMPLES / "plagiograph.toml", 0.5),
                             ("nameplate, pole free, no obstacle", EXAMPLES / "nameplate.toml", 0.5),
                             ("clamped plate, three obstacles", EXAMPLES / "clamped-plate.toml", 0.6),
                             ("router, three obstacles", HOME / "tasks" / "router-among-obstacles.toml", 0.6),
                             ("pantorouter, three obstacles, two bodies, a table", EXAMPLES / "pantorouter.toml", 1.5)):
        runs = [designed(context, spec) for _ in range(1 if context.quick else 5)]
        cpu, memory = min(run.cpu_s for run in runs), max(run.memory_mb for run in runs)
        if runs[0].code != 0:
            on += f" (exit {runs[0].code})"
        yield Row("synthesize, files included", on, f"{cpu:.2f} s CPU, {memory:.0f} MB", "", "", f"{target} s, 300 MB",
                  cpu < target and memory < 300 and runs[0].code == 0)


def rows(context):
    yield from costs(context)
    yield from beside_scipy(context)
