"""Forward kinematics beside SolveSpace's library and planegcs: the same poses, positions compared."""
import pathlib
import subprocess
import tempfile

from measure import EXAMPLES, HOME, Row, json_of

LINKAGES = [HOME / "linkages" / "four-bar.toml"] + [
    EXAMPLES / "linkages" / f"{name}.toml"
    for name in ("plagiograph", "watt-six-bar", "stephenson-six-bar", "peaucellier-lipkin", "six-bar-plagiograph")]
PACKAGE = "@salusoft89/planegcs@1.3.0"
TARGET = 5


def planegcs_folder(build):
    """Where npm has put the peer; nothing if it cannot be had."""
    folder = build / "bench" / "planegcs"
    if not (folder / "node_modules" / "@salusoft89" / "planegcs").exists():
        folder.mkdir(parents=True, exist_ok=True)
        command = ["npm", "install", "--no-save", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix", folder, PACKAGE]
        try:
            if subprocess.run(command, capture_output=True).returncode != 0:
                return None
        except FileNotFoundError:
            return None
    return folder


def measured(context, linkage, planegcs):
    poses, rounds = 3600, 5 if context.quick else 10
    with tempfile.TemporaryDirectory() as scratch:
        task = pathlib.Path(scratch) / "task.json"
        result = json_of(context.program("forward"), linkage, poses, rounds, task)
        if planegcs:
            result.update(json_of("node", HOME / "peers" / "planegcs_forward.mjs", planegcs, task, 8))
    return result


def rows(context):
    planegcs = planegcs_folder(context.build)
    for linkage in LINKAGES:
        result = measured(context, linkage, planegcs)
        peers, times, apart = [], [], []
        for key, name in (("solvespace", "SolveSpace"), ("planegcs", "planegcs")):
            if f"{key}_us" not in result:
                peers.append(f"{name} absent")
                continue
            times.append(result[f"{key}_us"])
            apart.append(result[f"{key}_apart_mm"])
            given_up = result[f"{key}_failures"]
            peers.append(f"{name} {times[-1]:.3g} us" + (f", {given_up} poses given up" if given_up else ""))
        row = Row("forward kinematics, a pose", f"{result['linkage']}, {result['unknowns']} unknowns",
                  f"{result['kempe_us']:.3g} us", "; ".join(peers), "", f"{TARGET}, apart < 1e-8 mm")
        if times:
            ratio = min(times) / result["kempe_us"]
            row.ratio = f"{ratio:.1f}, apart {max(apart):.0e} mm"
            row.reached = ratio >= TARGET and max(apart) <= 1e-8 and result["kempe_failures"] == 0
        yield row
