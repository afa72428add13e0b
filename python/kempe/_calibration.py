"""What is wrong with a real instrument, from what it drew."""
from __future__ import annotations

import html
import json
import os
from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence

from . import _core
from ._answers import error_of
from ._design import names_of
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


@dataclass(frozen=True)
class Calibration:
    """A calibration as its command gives it; in a notebook it shows its page."""

    answer: Mapping[str, Any]  #: what `kempe calibrate --json` prints (docs/calibration.md); mm, degrees
    page_html: str = field(repr=False)  #: report.html, the text of a page that needs no other file
    simulated_toml: str = field(repr=False)  #: the first simulated instrument's readings as a file of measurements; "" without any
    text: str = field(repr=False)  #: what `kempe calibrate` prints for a person
    json: str = field(repr=False)  #: calibration.json

    def save(self, folder: Path) -> list[str]:
        """Writes what `kempe calibrate` writes: calibration.json, report.html and, of a simulation, simulated.toml. Returns their names.

        All or none: raises NotWritten where the folder cannot be written.
        """
        return names_of(_core.write_calibration(self.json, self.page_html, self.simulated_toml, folder))

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        page = html.escape(self.page_html, quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:42rem;border:0" title="Calibration"></iframe>'


def calibration(measurements: Path | Mapping[str, Any], *, target_mm: Optional[float] = None, method: Optional[str] = None,
                ratios: Sequence[str | float] = (), plan: bool = False, plan_readings: Optional[int] = None, simulate: bool = False,
                seed: int = 1, equations: bool = False) -> Calibration:
    """The calibration of an instrument with all that `kempe calibrate` can be asked for, and with its page.

    measurements   a TOML file of readings, or its tables as a dict
    target_mm      the copy error that is good enough, 1e-6 to 1000 mm
    method         "knight" or "least_squares"; None: what fits the readings
    ratios         a table of settings for each: "1:3" or 0.4; 0.01 to 100
    plan           propose the readings that determine most; plan_readings: how many, 1 to 100
    simulate       simulate instruments with hidden errors (the table `simulate`), drawn by `seed`
    equations      write out Knight's equations of the last round, and the matrix that turns its readings into errors

    Raises SpecError with all faults, those of the options too.

    >>> knight = {"instrument": {"arm_mm": 500, "ratio": 0.5},
    ...           "reading": [{"arm_angle_deg": 30, "error_mm": [0.1, -0.3]}, {"arm_angle_deg": 60, "error_mm": [0.3, -0.5]}]}
    >>> len(calibration(knight, plan=True, plan_readings=4).answer["plan"]["readings"])
    4
    >>> [len(row) for row in calibration(knight, equations=True).answer["equations"]["matrix"]]  # AC, CF, BE, DE by four departures
    [4, 4, 4, 4]
    """
    is_file = not isinstance(measurements, Mapping)
    options = _core.CalibrationOptions(target_mm, method or "", [str(ratio) for ratio in ratios], plan, plan_readings, simulate, seed, equations)
    if isinstance(measurements, Mapping):
        found = _core.calibrate_with(options, text_of(measurements), os.getcwd())
    else:
        found = _core.calibrate_file_with(options, measurements)
    if isinstance(found, list):
        raise error_of(found, lines=is_file)
    answer = json.loads(found.json)
    return Calibration(answer if is_file else _without_lines(answer), found.page, found.simulated, found.text, found.json)


def _without_lines(value: Any) -> Any:
    """A dict has no lines that a person could look at."""
    if isinstance(value, list):
        return [_without_lines(one) for one in value]
    if isinstance(value, dict):
        return {key: _without_lines(one) for key, one in value.items() if key != "line"}
    return value
