"""The best plagiograph for a small region, and all files that a workshop needs to build it.

usage: scripts/python examples/python/design_and_write.py [FOLDER]
"""
import sys

import kempe

spec = kempe.Spec(copy=1.4j, region={"rectangle_mm": [62, -5, 8, 10]}, links={"width_mm": 6, "pin_diameter_mm": 3})
try:
    design = kempe.synthesize(spec)
except kempe.NoDesign as none:
    sys.exit(str(none))
print(design)
files = design.save(sys.argv[1] if len(sys.argv) > 1 else "out/python", title="design_and_write")
print(f"{len(files)} files")
