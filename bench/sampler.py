"""The map beside plain grid samplers of equal accuracy: one in C++, one in Python with NumPy and Shapely."""
import json
import subprocess

from measure import HOME, SYSTEM_PYTHON, Row, json_of, shown

TARGET = 50


def rows(context):
    for obstacles in (10, 50) if context.quick else (1, 10, 50, 200):
        result = json_of(context.program("sampler"), obstacles)
        on = f"{obstacles} obstacle{'s' * (obstacles > 1)}; {result['samples']:.2g} samples, band {result['uncertain_mm2'] / result['free_mm2']:.2%}"
        ratio = result["sampler_s"] / result["map_s"]
        yield Row("map beside a grid sampler in C++", on, shown(result["map_s"]), shown(result["sampler_s"]), f"{ratio:.0f}",
                  str(TARGET), ratio >= TARGET)
        peer = subprocess.run([SYSTEM_PYTHON, HOME / "peers" / "shapely_sampler.py"], input=json.dumps(result["scene"]),
                              capture_output=True, text=True)
        if peer.returncode != 0:
            yield Row("map beside a grid sampler with NumPy and Shapely", on, shown(result["map_s"]), "Shapely absent")
            continue
        peer = json.loads(peer.stdout)
        whole = peer["sample_s"] * result["samples"]
        ratio = whole / result["map_s"]
        agree = abs(peer["free_share"] - result["free_share"])
        yield Row("map beside a grid sampler with NumPy and Shapely", f"{on}; free shares {agree:.1%} apart",
                  shown(result["map_s"]), shown(whole), f"{ratio:.0f}", str(TARGET), ratio >= TARGET)
