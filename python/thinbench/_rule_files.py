"""Rules given by tables, as JSON files; tools/rules/rule_file.hpp describes the same format.

    {"name": "my rule",
     "sub_iterations": [table, ...],     1 to 8; or "hensel": "B3/S23" for this one table
     "border": "background",             or "keep" or "foreground"; default: background
     "max_iterations": 1}                default: until nothing changes

A table is an object with one of the keys "raster" (512 digits 0 and 1, or 128 hexadecimal ones, of
which the highest bit comes first), "makelut" and "order", "remove" and "order", "patterns", or
"hensel". Errors are ValueErrors that name the file and the field.
"""

from __future__ import annotations

import json
import os
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from thinbench import _library, _tables

_MAX_BYTES = 1_000_000
_MAX_NAME_LENGTH = 100
_MAX_SUB_ITERATIONS = 8


class Rule(NamedTuple):
    """What a file says, beside the name."""

    tables: _tables.Tables
    border: str
    max_iterations: int | None


def read(path: str | os.PathLike[str]) -> Rule:
    """The rule of a regular file of at most 1 MB."""
    file = os.fspath(path)
    root = _parsed(_text_of(file), file)
    try:
        return _rule(root)
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from None


def write(path: str | os.PathLike[str], rule: Rule) -> None:
    """Writes a file that reads back as this rule."""
    rows = np.packbits(rule.tables, axis=1)
    content: dict[str, Any] = {"sub_iterations": [{"raster": row.tobytes().hex()} for row in rows],
                               "border": rule.border}
    if rule.max_iterations is not None:
        content["max_iterations"] = rule.max_iterations
    Path(path).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def _text_of(file: str) -> str:
    if not stat.S_ISREG(os.stat(file).st_mode):  # a pipe would block
        raise ValueError(f"cannot read {file!r}: it is not a regular file")
    with open(file, "rb") as opened:
        content = opened.read(_MAX_BYTES + 1)
    if len(content) > _MAX_BYTES:
        raise ValueError(f"cannot read {file!r}: it has more than 1,000,000 bytes")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"{file}: not UTF-8 at byte {error.start + 1}") from None


def _parsed(text: str, file: str) -> Any:
    try:
        return json.loads(text, object_pairs_hook=_object, parse_constant=_no_constant)
    except RecursionError:
        raise ValueError(f"{file}: values are nested too deep") from None
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from None


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise ValueError(f"the key {_shown(key)} is repeated")
        found[key] = value
    return found


def _no_constant(text: str) -> None:
    raise ValueError(f"{text} is no number")


def _shown(text: str) -> str:
    return json.dumps(text if len(text) <= 40 else text[:40] + "...")


def _rule(root: Any) -> Rule:
    where = "the outermost value"
    _allow_only(root, where, "name", "sub_iterations", "hensel", "border", "max_iterations")
    if ("hensel" in root) == ("sub_iterations" in root):
        raise ValueError(f"{where} must have either sub_iterations or hensel")
    if "name" in root:
        _check_name(root["name"])
    tables = (_hensel(root["hensel"], "hensel") if "hensel" in root
              else _sub_iterations(root["sub_iterations"]))
    return Rule(tables, _border(root.get("border", "background")), _limit(root))


def _allow_only(value: Any, where: str, *keys: str) -> None:
    if not isinstance(value, dict):
        raise ValueError(f"{where} must be an object")
    for key in value:
        if key not in keys:
            raise ValueError(f"{where} has the unknown key {_shown(key)}")


def _check_name(name: Any) -> None:
    text = _text(name, "name")
    length = len(text.encode(errors="replace"))
    if not 1 <= length <= _MAX_NAME_LENGTH or any(symbol < " " or symbol == "\x7f"
                                                  for symbol in text):
        raise ValueError("name must have 1 to 100 bytes without control characters")


def _border(border: Any) -> str:
    if _text(border, "border") not in _library.BORDERS:
        raise ValueError('border must be "background", "keep" or "foreground"')
    return str(border)


def _limit(root: dict[str, Any]) -> int | None:
    if "max_iterations" not in root:
        return None
    limit = root["max_iterations"]
    if type(limit) is not int:
        raise ValueError("max_iterations must be an integer")
    if not 1 <= limit < 2**31:
        raise ValueError("max_iterations must lie between 1 and 2147483647")
    return limit


def _sub_iterations(value: Any) -> _tables.Tables:
    tables = _list(value, "sub_iterations", 1, _MAX_SUB_ITERATIONS, "tables")
    return np.concatenate([_table(table, f"sub_iterations[{index}]")
                           for index, table in enumerate(tables)])


def _table(table: Any, where: str) -> _tables.Tables:
    for key, (keys, read_table) in _KINDS.items():
        if isinstance(table, dict) and key in table:
            _allow_only(table, where, *keys)
            missing = [name for name in keys if name not in table]
            if missing:
                raise ValueError(f"{where}.{missing[0]} is missing")
            return read_table(*(table[name] for name in keys), f"{where}.{key}")
    _allow_only(table, where)
    raise ValueError(f"{where} must have raster, makelut, remove, patterns or hensel")


def _raster(value: Any, where: str) -> _tables.Tables:
    text = _text(value, where)
    if len(text) not in (_tables.WINDOWS, _tables.WINDOWS // 4):
        raise ValueError(f"{where} has {len(text)} characters; it must have 512 digits 0 and 1 or "
                         "128 hexadecimal digits")
    digits = "01" if len(text) == _tables.WINDOWS else "0123456789abcdefABCDEF"
    for position, digit in enumerate(text, 1):
        if digit not in digits:
            expected = "0 or 1" if digits == "01" else "0 to 9 or a to f"
            raise ValueError(f"{where} has no digit {expected} at position {position}")
    if digits == "01":
        return np.array([[digit == "1" for digit in text]])
    return np.unpackbits(np.frombuffer(bytes.fromhex(text), np.uint8)).astype(bool)[None]


def _makelut(values: Any, order: Any, where: str) -> _tables.Tables:
    _check_order(order, where, _tables.WINDOW_ORDERS)
    return _tables.from_makelut(_values(values, where, _tables.WINDOWS), order)


def _remove(values: Any, order: Any, where: str) -> _tables.Tables:
    _check_order(order, where, _tables.NEIGHBOUR_ORDERS)
    return _tables.from_deletions(_values(values, where, 256), order)


def _patterns(value: Any, where: str) -> _tables.Tables:
    patterns = [_text(pattern, f"{where}[{index}]")
                for index, pattern in enumerate(_list(value, where, 1, 1000, "patterns"))]
    return _notation(_tables.from_patterns, patterns, where)


def _hensel(value: Any, where: str) -> _tables.Tables:
    return _notation(_tables.from_hensel, _text(value, where), where)


_KINDS: dict[str, tuple[tuple[str, ...], Callable[..., _tables.Tables]]] = {
    "raster": (("raster",), _raster),
    "makelut": (("makelut", "order"), _makelut),
    "remove": (("remove", "order"), _remove),
    "patterns": (("patterns",), _patterns),
    "hensel": (("hensel",), _hensel),
}


def _notation(make: Callable[[Any], _tables.Tables], value: Any, where: str) -> _tables.Tables:
    try:
        return make(value)
    except ValueError as error:
        raise ValueError(f"{where} is invalid: {error}") from None


def _check_order(order: Any, where: str, orders: dict[str, bytes]) -> None:
    field = where.rpartition(".")[0] + ".order"
    if _text(order, field) not in orders:
        raise ValueError(f"{field} must be one of {', '.join(map(_shown, orders))}")


def _values(value: Any, where: str, count: int) -> list[bool]:
    values = _list(value, where, count, count, "values")
    for index, one in enumerate(values):
        if not isinstance(one, (bool, int, float)) or one not in (0, 1):
            raise ValueError(f"{where}[{index}] must be 0 or 1")
    return [bool(one) for one in values]


def _list(value: Any, where: str, least: int, most: int, what: str) -> list[Any]:
    if not isinstance(value, list):
        raise ValueError(f"{where} must be a list")
    if not least <= len(value) <= most:
        expected = str(most) if least == most else f"{least} to {most}"
        raise ValueError(f"{where} has {len(value)} {what}; it must have {expected}")
    return value


def _text(value: Any, where: str) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{where} must be a text")
    return value
