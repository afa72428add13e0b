"""The studio in a browser: from the move of a hand to the picture, step after step, and what a long drag leaves in memory."""
import json
import os
import pathlib
import subprocess

from measure import Row

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = pathlib.Path(os.environ.get("KEMPE_STUDIO", ROOT / "out/studio.html"))
# Goals, ms: a step of a hand without obstacles, and among them.
GOALS = {"plagiograph": 33, "nameplate": 33, "clamped-plate": 100, "pantorouter": 100}
MORE_BYTES = 1 << 20


def rows(context):
    lacking = [str(path) for path in (PAGE, ROOT / "tests/web/node_modules/playwright-core") if not path.exists()]
    if lacking:
        yield Row("studio", "", f"not measured: {' and '.join(lacking)} not there (scripts/studio --test makes both)")
        return
    steps = 200 if context.quick else 1000
    run = subprocess.run(["node", ROOT / "bench/studio_drag.mjs", str(steps), *GOALS], capture_output=True, text=True, check=True)
    for line in run.stdout.splitlines():
        of = json.loads(line)
        goal = GOALS[of["template"]]
        shown = (f"{of['ms_median']:.0f} ms, 95 % below {of['ms_95']:.0f} ms, most {of['ms_most']:.0f} ms; {of['without_design']} without a "
                 f"design; {of['heap_grown'] / 1e6:+.2f} MB of objects, {of['engine_grown'] / 1e6:+.2f} MB of engine")
        yield Row(f"studio, a hand's step to the picture, {of['steps']} steps", of["template"], shown, "", "",
                  f"95 % below {goal} ms, memory as before", of["ms_95"] < goal and of["heap_grown"] < MORE_BYTES and of["engine_grown"] <= 0)
