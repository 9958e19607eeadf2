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
import re
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from thinbench import _arrays, _library, _tables

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
    content = _content_of(file)
    try:
        return _rule(json.loads(content.decode("utf-8-sig"), object_pairs_hook=_object))
    except UnicodeDecodeError as error:
        raise ValueError(f"{file}: not UTF-8 at byte {error.start + 1}") from None
    except RecursionError:
        raise ValueError(f"{file}: values are nested too deep") from None
    except (TypeError, ValueError) as error:
        raise ValueError(f"{file}: {error}") from None


def write(path: str | os.PathLike[str], rule: Rule) -> None:
    """Writes a file that reads back as this rule."""
    rows = np.packbits(rule.tables, axis=1)
    content: dict[str, Any] = {"sub_iterations": [{"raster": row.tobytes().hex()} for row in rows],
                               "border": rule.border}
    if rule.max_iterations is not None:
        content["max_iterations"] = rule.max_iterations
    Path(path).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def _content_of(file: str) -> bytes:
    mode = os.stat(file).st_mode
    if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):  # a pipe would block, open() rejects a directory
        raise ValueError(f"cannot read {file!r}: it is not a regular file")
    with open(file, "rb") as opened:
        content = opened.read(_MAX_BYTES + 1)
    if len(content) > _MAX_BYTES:
        raise ValueError(f"cannot read {file!r}: it has more than 1,000,000 bytes")
    return content


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise ValueError(f"the key {_shown(key)} is repeated")
        found[key] = value
    return found


def _shown(text: str) -> str:
    return json.dumps(text if len(text) <= 40 else text[:40] + "...")


def _check_keys(value: Any, where: str, *keys: str) -> None:
    if not isinstance(value, dict):
        raise ValueError(f"{where} must be an object")
    for key in value:
        if key not in keys:
            raise ValueError(f"{where} has the unknown key {_shown(key)}")


def _rule(root: Any) -> Rule:
    where = "the outermost value"
    _check_keys(root, where, "name", "sub_iterations", "hensel", "border", "max_iterations")
    if ("hensel" in root) == ("sub_iterations" in root):
        raise ValueError(f"{where} must have either sub_iterations or hensel")
    _check_name(root.get("name", "rule"))
    tables = _table({"hensel": root["hensel"]}, where) if "hensel" in root else _sub_iterations(root)
    border = root.get("border", "background")
    _arrays.one_of("border", border, _library.BORDERS)
    limit = None
    if "max_iterations" in root:
        limit = _arrays.limit(_arrays.integer("max_iterations", root["max_iterations"]))  # an integer, not null
    return Rule(tables, border, limit)


def _check_name(name: Any) -> None:
    """As UTF-8, which has no lone surrogates."""
    if not isinstance(name, str) or re.search(r"[\0-\x1f\x7f\ud800-\udfff]", name) \
            or not 1 <= len(name.encode()) <= _MAX_NAME_LENGTH:
        raise ValueError("name must have 1 to 100 bytes without control characters")


def _sub_iterations(root: dict[str, Any]) -> _tables.Tables:
    tables = root["sub_iterations"]
    if not isinstance(tables, list) or not 1 <= len(tables) <= _MAX_SUB_ITERATIONS:
        raise ValueError("sub_iterations must be a list of 1 to 8 tables")
    return np.concatenate([_table(table, f"sub_iterations[{index}]")
                           for index, table in enumerate(tables)])


def _raster(text: str) -> _tables.Tables:
    if re.fullmatch("[01]{512}", text):
        return np.array([[digit == "1" for digit in text]])
    if re.fullmatch("[0-9a-fA-F]{128}", text):
        return np.unpackbits(np.frombuffer(bytes.fromhex(text), np.uint8)).astype(bool)[None]
    raise ValueError("expected 512 digits 0 and 1 or 128 hexadecimal digits, "
                     f"got {_arrays.counted(len(text), 'character')}")


_KINDS: dict[str, tuple[Callable[..., _tables.Tables], tuple[str, ...]]] = {
    "raster": (_raster, ()),
    "makelut": (_tables.from_values, ("order",)),
    "remove": (_tables.from_removals, ("order",)),
    "patterns": (_tables.from_patterns, ()),
    "hensel": (_tables.from_hensel, ()),
}


def _table(table: Any, where: str) -> _tables.Tables:
    _check_keys(table, where, "order", *_KINDS)
    kind = next((kind for kind in _KINDS if kind in table), None)
    if kind is None:
        raise ValueError(f"{where} must have raster, makelut, remove, patterns or hensel")
    make, others = _KINDS[kind]
    _check_keys(table, where, kind, *others)
    try:
        made = make(table[kind], *(table.get(other) for other in others))
    except (TypeError, ValueError) as error:
        raise ValueError(f"{where}.{kind} is invalid: {error}") from None
    if len(made) != 1:
        raise ValueError(f"{where}.{kind} is invalid: it has {len(made)} tables")
    return made
