#!/usr/bin/env python3
"""Kempe beside SciPy's differential evolution on the same specs: objective and CPU time.

usage: synthesis_table.py KEMPE [SEEDS]
The peer (peers/differential_evolution.py) states the problem a second time, for fixed or free poles, without obstacles.
"""
import json
import pathlib
import platform
import resource
import subprocess
import sys
import tempfile

HOME = pathlib.Path(__file__).resolve().parent
EXAMPLES = HOME.parent / "specs" / "examples"
SPECS = ["plagiograph", "half-turn", "sixty", "nameplate", "matlab-circle"]


def cpu_of(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(command, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return run, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    kempe = sys.argv[1]
    seeds = sys.argv[2] if len(sys.argv) > 2 else "5"
    print(f"{platform.machine()}, {platform.system()}; peer: SciPy differential evolution, best of {seeds} seeds\n")
    print("| spec | objective | kempe | proven bound | peer | kempe CPU s, files included | peer CPU s | ratio |")
    print("|---|---|---|---|---|---|---|---|")
    for name in SPECS:
        spec = EXAMPLES / f"{name}.toml"
        with tempfile.TemporaryDirectory() as out:
            run, cpu = cpu_of(kempe, "synthesize", spec, "-o", out, "-j", "1", "--json")
        if run.returncode != 0:
            print(f"| {name} | {run.stderr.strip()} |")
            continue
        design = json.loads(run.stdout)
        search, bound = design["search"], design["quality"]["lower_bound"]
        peer = json.loads(subprocess.run(["/usr/bin/python3", HOME / "peers" / "differential_evolution.py", spec, "--seeds",
                                          seeds], capture_output=True, text=True, check=True).stdout)
        shown = "-" if bound is None else f"{bound:.4f}"
        print(f"| {name} | {search['objective']} | {search['value']:.4f} | {shown} | {peer['objective']:.4f} | {cpu:.2f} | "
              f"{peer['cpu_s']:.1f} | {peer['cpu_s'] / cpu:.0f} |", flush=True)


main()
