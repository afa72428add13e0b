"""What is wrong with a real instrument, from what it drew."""
from __future__ import annotations

import json
import os
from typing import Any, Mapping

from . import _core
from ._answers import error_of
from ._spec import Path, text_of


def calibrate(measurements: Path | Mapping[str, Any]) -> dict[str, Any]:
    """The calibration of an instrument from its readings: what `kempe calibrate --json` prints, as a dict (docs/calibration.md).

    `measurements` is a TOML file of readings, or its tables as a dict. Lengths mm. A table `simulate` plays no part.
    Raises SpecError with all faults.

    >>> readings = [{"arm_angle_deg": 30, "error_mm": [0.10, -0.30]}, {"arm_angle_deg": 60, "error_mm": [0.30, -0.50]}]
    >>> found = calibrate({"instrument": {"arm_mm": 500, "ratio": 0.5}, "reading": readings})
    >>> {name: round(length, 3) for name, length in found["corrections_mm"].items()}
    {'AC': 0.346, 'CF': -0.22, 'BE': -0.41, 'DE': 0.173}
    """
    if isinstance(measurements, Mapping):
        found = _core.calibrate_text(text_of(measurements), os.getcwd())
    else:
        found = _core.calibrate(measurements)
    if isinstance(found, list):
        raise error_of(found, lines=not isinstance(measurements, Mapping))
    answer: dict[str, Any] = json.loads(found)
    if isinstance(measurements, Mapping):
        answer = _without_lines(answer)
    return answer


def _without_lines(value: Any) -> Any:
    """A dict has no lines that a person could look at."""
    if isinstance(value, list):
        return [_without_lines(one) for one in value]
    if isinstance(value, dict):
        return {key: _without_lines(one) for key, one in value.items() if key != "line"}
    return value
