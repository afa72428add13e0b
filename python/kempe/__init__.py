"""Kempe: the best copying linkage for a task, with everything that is needed to build it.

>>> import kempe
>>> spec = kempe.Spec(copy=1.4j,                                          # 1.4 times as large, turned by 90 degrees
...                   region={"rectangle_mm": [62, -5, 8, 10]},           # or a Shapely polygon
...                   links={"width_mm": 6, "pin_diameter_mm": 3})
>>> design = kempe.synthesize(spec)
>>> design.vertex, design.map.covers_region, bool(design.verify())
('tracer', True, True)

Lengths are millimetres, angles degrees where a name ends in _deg, places (x, y) in the table's frame. docs/python.md tells more.
"""
from ._answers import (Audit, Broken, Change, CopiedDrawing, CopiedLine, Error, Fault, Loss, NoDesign, NoMotion, NotWritten,
                       Sheet, SpecError, Stopped, TracedDrawing, Verdict, Verification)
from ._calibration import Calibration, calibrate, calibration
from ._core import version as __version__
from ._design import Design, Map, verify
from ._generators import (Cognate, FunctionGenerator, Inversor, InversorLength, PathGenerator, PathGenerators, Plagiograph,
                          function_generator, inversor, path_generator)
from ._geometry import Region
from ._linkage import Centre, Centres, Linkage, Mobility, Motion, MotionEnd, number_synthesis
from ._program import program
from ._spec import Spec, load
from ._start import Template, studio_page, templates
from ._work import Front, pareto, proof_of_none, sweep, synthesize, workspace

__all__ = [
    "Audit", "Broken", "Calibration", "Centre", "Centres", "Change", "Cognate", "CopiedDrawing", "CopiedLine", "Design", "Error",
    "Fault", "Front", "FunctionGenerator", "Inversor", "InversorLength", "Linkage", "Loss", "Map", "Mobility", "Motion", "MotionEnd",
    "NoDesign", "NoMotion", "NotWritten", "PathGenerator", "PathGenerators", "Plagiograph", "Region", "Sheet", "Spec", "SpecError",
    "Stopped", "Template", "TracedDrawing", "Verdict", "Verification", "__version__", "calibrate", "calibration", "function_generator",
    "inversor", "load", "number_synthesis", "pareto", "path_generator", "program", "proof_of_none", "studio_page", "sweep", "synthesize",
    "templates", "verify", "workspace",
]

for _name in __all__:  # a reader of a traceback or a pickle finds everything under kempe
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = "kempe"
del _name
