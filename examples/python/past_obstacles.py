"""Where a plagiograph of given lengths can go beside a vice and a lamp's foot, and what its pen draws there.

usage: scripts/python examples/python/past_obstacles.py
"""
import numpy as np

import kempe

spec = kempe.Spec(
    copy=1.4j,
    mechanism={"vertex": "pole", "VA_mm": 50, "VB_mm": 35, "assembly": 3},
    links={"width_mm": 6, "pin_diameter_mm": 3},
    limits={"transmission_deg": 15},
    obstacles=[{"name": "vice", "rectangle_mm": [20, -60, 40, 20]},
               {"name": "foot of the lamp", "circle_mm": [-60, 40, 12]}])
design = kempe.workspace(spec)
print(design.map)
for loss in design.map.losses:
    print(f"lost {loss.area_mm2:.0f} mm2: {', '.join((loss.cause, *loss.parts))}")
print(design.map.why(70, 0).sentence)

circle = 66 + 4 * np.exp(1j * np.linspace(0, 2 * np.pi, 200))
copied = design.trace([circle])
print(f"drawn {copied.drawn_length_mm:.1f} mm, missing {copied.missing_length_mm:.1f} mm")
