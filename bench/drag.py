"""Sketches while a handle is dragged: thousand small steps of a spec, each from the last one's design, beside the whole search."""
from measure import EXAMPLES, HOME, Row, json_of

FRAME_MS, NEAR = 16, 0.95


def rows(context):
    steps, every = (200, 20) if context.quick else (1000, 10)
    examples = [EXAMPLES / f"{name}.toml" for name in ("plagiograph", "nameplate", "half-turn", "sixty", "two-layer", "clamped-plate",
                                                       "pantorouter")]
    for spec in [*examples, HOME / "tasks" / "router-among-obstacles.toml"]:
        run = json_of(context.program("drag"), spec, steps, every)
        missed = run["compared"] - run["within_2_percent"]
        shown = (f"{run['ms_median']:.1f} ms, 95 % below {run['ms_95']:.1f} ms, most {run['ms_most']:.1f} ms; within 2 % of the search "
                 f"{run['within_2_percent']} of {run['compared']}, none found where the search finds one {run['lost']}")
        yield Row(f"sketch a step, {run['steps']} steps", spec.stem, shown, "", "", f"95 % below {FRAME_MS} ms, 95 % within 2 %",
                  run["ms_95"] < FRAME_MS and missed <= (1 - NEAR) * run["compared"])
