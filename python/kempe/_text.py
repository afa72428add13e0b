"""A spec's tables as the text of its file: the reader of files then judges both alike."""
from __future__ import annotations

import cmath
import datetime
import json
import math
import numbers
import re
from typing import Any, Iterable, Mapping

from ._geometry import Rings, is_geometry, rings_of

Tables = Mapping[str, Any]
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+\Z")
_LISTS = ("obstacles", "bodies")  # tables that may stand several times


class Unsayable(Exception):
    """A value that no file can hold."""

    def __init__(self, key: str, found: str, allowed: str):
        super().__init__(key, found, allowed)
        self.key, self.found, self.allowed = key, found, allowed


def toml_of(tables: Tables) -> str:
    """The text of a spec's file; `tables` are its tables, shortened ones too (see kempe.Spec)."""
    tables = {name: value for name, value in tables.items() if value is not None}
    suffix = "in" if tables.get("units") == "in" else "mm"
    head, rest = [], []
    for name, given in tables.items():
        if name in _LISTS:
            several = [given] if isinstance(given, Mapping) or is_geometry(given) else list(given)
            for number, one in enumerate(several):
                rest.append(f"\n[[{name}]]\n" + _lines(_outlined(one, suffix), f"{name}[{number}]"))
            if not several:
                head.append(f"{name} = []\n")
            continue
        whole = _whole_table(name, given, suffix)
        if isinstance(whole, Mapping):
            rest.append(f"\n[{_key(name)}]\n" + _lines(whole, name))
        else:
            head.append(f"{_key(name)} = {_value(whole, name)}\n")
    return "".join(head + rest) or "# nothing\n"  # an empty text is no file


def _whole_table(name: str, given: Any, suffix: str) -> Any:
    """What a short form stands for: copy = 1.4j, region = a polygon, material = "steel"."""
    if name == "copy":
        return _copy(given)
    if name in ("region", "table"):
        return _outlined(given, suffix)
    if name == "pole":
        return _pole(given, suffix)
    if name == "material" and isinstance(given, str):
        return {"name": given}
    if name == "objective" and isinstance(given, str):
        return {"maximize" if given == "transmission" else "minimize": given}
    return given


def _copy(given: Any) -> Any:
    if isinstance(given, numbers.Complex) and not isinstance(given, numbers.Real):
        ratio = complex(given)
        return {"scale": abs(ratio), "rotation_deg": math.degrees(cmath.phase(ratio))}
    if isinstance(given, (str, numbers.Real)):
        return {"scale": given}
    return given


def _pole(given: Any, suffix: str) -> Any:
    if is_geometry(given) and not (isinstance(given, Mapping) and "type" not in given):
        geometry = given if isinstance(given, Mapping) else given.__geo_interface__
        if geometry.get("type") == "Point":
            return {f"at_{suffix}": [float(number) for number in geometry["coordinates"]]}
        return {f"within_{suffix}": given}
    if isinstance(given, Mapping):
        return given
    if isinstance(given, numbers.Complex):
        return {f"at_{suffix}": complex(given)}
    return {f"at_{suffix}": given}


def _outlined(given: Any, suffix: str) -> Any:
    """A table with an outline; a geometry or a list of points alone is that outline."""
    if isinstance(given, Mapping) and not is_geometry(given):
        return given
    if is_geometry(given):
        rings = rings_of(given)
        table: dict[str, Any] = {f"polygon_{suffix}": rings.outer}
        if rings.holes:
            table[f"holes_{suffix}"] = rings.holes
        return table
    if isinstance(given, str) or not hasattr(given, "__len__"):
        return given
    return {f"polygon_{suffix}": given}


def _lines(table: Any, name: str) -> str:
    if not isinstance(table, Mapping):
        raise Unsayable(name, _shown(table), "a table: a dict of keys and values")
    return "".join(f"{_key(key)} = {_value(value, f'{name}.{key}')}\n" for key, value in table.items() if value is not None)


def _key(name: object) -> str:
    if not isinstance(name, str):
        raise Unsayable("", f"the key {name!r}", "keys that are texts")
    return name if _BARE_KEY.match(name) else _text(name, name)


def _text(text: str, key: str) -> str:
    try:
        text.encode()
    except UnicodeEncodeError:
        raise Unsayable(key, ascii(text), "text that UTF-8 can hold") from None
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any, key: str) -> str:
    """The value as TOML. Floats keep their last bit."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value, key)
    if isinstance(value, Mapping) and not is_geometry(value):
        inside = ", ".join(f"{_key(one)} = {_value(of, f'{key}.{one}')}" for one, of in value.items() if of is not None)
        return "{" + inside + "}"
    if is_geometry(value):
        return _rings(rings_of(value), key)
    if hasattr(value, "tolist"):  # NumPy's arrays and numbers
        return _value(value.tolist(), key)
    if isinstance(value, numbers.Integral) and -2**63 <= int(value) < 2**63:
        return str(int(value))
    if isinstance(value, numbers.Real):
        exact: Any = value
        try:
            return repr(float(exact))
        except OverflowError:
            return "inf" if exact > 0 else "-inf"
    if isinstance(value, numbers.Complex):
        number = complex(value)
        return f"[{number.real!r}, {number.imag!r}]"
    if isinstance(value, (datetime.date, datetime.time)):
        return value.isoformat()  # no key takes one; the reader says so
    if isinstance(value, Iterable):
        return "[" + ", ".join(_value(one, key) for one in value) + "]"
    raise Unsayable(key, _shown(value), "a number, a text, True or False, or a list of these")


def _rings(rings: Rings, key: str) -> str:
    if rings.holes:
        raise Unsayable(key, "a polygon with holes", "one without")
    return _value(rings.outer, key)


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."
