"""Typed access to parsed JSON, with errors that name the file, the field and the value."""

from __future__ import annotations

import json
import lzma
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from report.errors import ReportError

SCHEMA = 1


class Fields:
    """One JSON object, and the words by which errors refer to it."""

    def __init__(self, data: Any, where: str) -> None:
        if not isinstance(data, dict):
            raise ReportError(f"{where}: found {_shown(data)} where a JSON object belongs")
        self.data = data
        self.where = where

    def has(self, key: str) -> bool:
        """True if the field is there and not null."""
        return self.data.get(key) is not None

    def renamed(self, key: str, old: str) -> str:
        """What the field is called in this file: files from before it was renamed have `old`."""
        return old if self.has(old) and not self.has(key) else key

    def text(self, key: str) -> str:
        """A non-empty string."""
        value = self.required(key)
        if not isinstance(value, str) or not value.strip():
            raise self._wrong(key, "a non-empty string")
        return value

    def number(self, key: str) -> float:
        """A finite number."""
        value = self.required(key)
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not is_number or not math.isfinite(value):
            raise self._wrong(key, "a finite number")
        return float(value)

    def positive(self, key: str) -> float:
        """A finite number above zero."""
        value = self.number(key)
        if value <= 0:
            raise self._wrong(key, "a number above zero")
        return value

    def count(self, key: str, least: int = 0) -> int:
        """A whole number, also if written as 3.0, that is not below `least`."""
        value = self.number(key)
        if not value.is_integer() or value < least:
            raise self._wrong(key, f"a whole number of at least {least}")
        return int(value)

    def at_most(self, key: str, most: float) -> float:
        """A number from zero to `most`, so that no rate is above 100 %."""
        value = self.number(key)
        if not 0 <= value <= most:
            raise ReportError(f"{self.where}: {key} is {value:g}; it must be from 0 to {most}")
        return value

    def listed(self, key: str) -> list[Any]:
        """An array."""
        value = self.required(key)
        if not isinstance(value, list):
            raise self._wrong(key, "an array")
        return value

    def children(self, key: str) -> list[Fields]:
        """An array of objects."""
        return [Fields(item, f"{self.where}: {key}[{index}]")
                for index, item in enumerate(self.listed(key))]

    def some(self, key: str) -> list[Fields]:
        """An array with at least one object in it."""
        children = self.children(key)
        if not children:
            raise ReportError(f"{self.where}: {key} is []; it must hold at least one row")
        return children

    def child(self, key: str) -> Fields:
        """An object."""
        return Fields(self.required(key), f"{self.where}: {key}")

    def check_schema(self) -> None:
        """Refuses a layout that this version does not know."""
        if self.data.get("schema") != SCHEMA:
            raise self._wrong("schema", str(SCHEMA))

    def required(self, key: str) -> Any:
        """Whatever is there; not null."""
        if not self.has(key):
            raise ReportError(f"{self.where}: field '{key}' is missing; it must be given")
        return self.data[key]

    def _wrong(self, key: str, right: str) -> ReportError:
        value = _shown(self.data.get(key))
        return ReportError(f"{self.where}: {key} is {value}; it must be {right}")


def read_object(path: Path) -> Fields:
    """Parses a file that holds one JSON object, or the same file packed by xz beside it."""
    return _parsed(path, lambda text: text)


def read_line(path: Path) -> Fields:
    """Parses the first line of a file of JSON objects, or of the same file packed by xz."""
    return _parsed(path, lambda text: text.partition("\n")[0])


def _parsed(path: Path, part: Callable[[str], str]) -> Fields:
    packed = path.with_name(path.name + ".xz")
    try:
        if not path.exists() and packed.exists():
            text = lzma.decompress(packed.read_bytes()).decode("utf-8")
        else:
            text = path.read_text(encoding="utf-8")
        return Fields(json.loads(part(text)), str(path))
    except FileNotFoundError:
        raise ReportError(f"{path}: no such file; a finished run leaves it here") from None
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError, EOFError, lzma.LZMAError) as error:
        raise ReportError(f"{path}: not complete JSON: {error}; run the benchmark again") from None


def _shown(value: Any) -> str:
    """The value as JSON, truncated if it is long."""
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 60 else text[:57] + "..."
