#!/usr/bin/env python3
"""Watt's six-bar moved: where its last joint is slowest, how far its rocker swings, its freedoms and its instant centres."""
import pathlib

import numpy as np

import kempe

file = pathlib.Path(__file__).parents[2] / "specs" / "examples" / "linkages" / "watt-six-bar.toml"
linkage = kempe.Linkage.read(file)
motion = linkage.solve()

speeds = {name: np.hypot(*velocity.T) for name, velocity in motion.velocities.items()}
slowest = int(np.argmin(speeds["G"]))
print(f"{linkage.name}: {len(motion)} moments; its ways to assemble: {len(linkage.assemblies())}")
print(f"G moves slowest at step {slowest}: {speeds['G'][slowest]:.1f} mm/s, fastest {speeds['G'].max():.1f} mm/s")
print(f"the rocker swings over {np.ptp(motion.angles_deg['rocker']):.2f} degrees")
print(linkage.mobility())
for centre in linkage.centres(at=slowest):
    if centre.source == "aronhold-kennedy" and centre.at_mm is not None:
        print(f"{' and '.join(centre.links):20} turn about {centre.at_mm[0]:9.2f}, {centre.at_mm[1]:9.2f} mm")
