"""Tables of custom rules: 512 values per sub-iteration, from arrays and from notations."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library

Tables = npt.NDArray[np.bool_]  # of shape (sub-iterations, 512)
Words = npt.NDArray[np.uint64]  # 8 per table: window w is bit w % 64 of word w / 64

WINDOWS = 512
WINDOW_ORDERS = {"matlab": b"matlab", "octave": b"octave"}
NEIGHBOUR_ORDERS = {"descriptor": b"descriptor", "clockwise": b"clockwise", "raster": b"raster"}


def bits(name: str, values: Any, width: int = WINDOWS) -> Tables:
    """Values 0 and 1 of shape (width,) or (sub-iterations, width), with two dimensions."""
    array = _arrays.as_array(name, values)
    if array.dtype != bool and not np.issubdtype(array.dtype, np.integer):
        raise TypeError(f"{name}: expected dtype bool or integer, got {array.dtype}")
    if array.ndim not in (1, 2) or array.shape[-1] != width:
        raise ValueError(f"{name}: expected shape ({width},) or (sub-iterations, {width}), "
                         f"got {array.shape}")
    others = array[(array != 0) & (array != 1)]
    if others.size:
        raise ValueError(f"{name}: expected values 0 and 1, got {others[0]}")
    tables: Tables = array.reshape(-1, width).astype(bool, order="C")
    return tables


def to_words(tables: Tables) -> Words:
    """As the C interface takes them."""
    packed = np.packbits(tables, axis=1, bitorder="little")
    return packed.view("<u8").astype(np.uint64)


def from_words(words: Words) -> Tables:
    """The inverse of `to_words`."""
    packed = words.astype("<u8").view(np.uint8)
    return np.unpackbits(packed, bitorder="little").reshape(-1, WINDOWS).astype(bool)


def _made(function: Callable[..., None], *arguments: Any) -> Tables:
    """The table that a function of the C interface writes."""
    words = np.empty(WINDOWS // 64, np.uint64)
    function(*arguments, words.ctypes.data)
    return from_words(words)


def encoded(name: str, text: Any) -> bytes:
    """The text as the C interface takes it."""
    notation = _arrays.text(name, text)
    if "\0" in notation:
        raise ValueError(f"{name}: expected no null character, got {notation!r}")
    return notation.encode()


def from_hensel(notation: str) -> Tables:
    return _made(_library.table_from_hensel, encoded("notation", notation))


def from_patterns(patterns: Iterable[str]) -> Tables:
    if isinstance(patterns, str):
        raise TypeError(f"patterns: expected a list of strings, got {patterns!r}")
    lines = [encoded("patterns", pattern) for pattern in _arrays.each("patterns", patterns)]
    array = (ctypes.c_char_p * len(lines))(*lines)
    return _made(_library.table_from_patterns, array, len(lines))


def from_values(lut: Any, order: str) -> Tables:
    name = _arrays.one_of("order", order, WINDOW_ORDERS)
    return _each(_library.table_from_values, bits("lut", lut), name)


def from_removals(removed: Any, order: str) -> Tables:
    name = _arrays.one_of("order", order, NEIGHBOUR_ORDERS)
    return _each(_library.table_from_removals, bits("removed", removed, 256), name)


def _each(function: Callable[..., None], tables: Tables, order: bytes) -> Tables:
    made = [_made(function, table.tobytes(), order) for table in tables]
    return np.concatenate([np.empty((0, WINDOWS), bool), *made])


def from_function(next_value: Callable[[Tables], Any]) -> Tables:
    if not callable(next_value):
        raise TypeError(f"next_value: expected a function, got {next_value!r}")
    windows = np.arange(WINDOWS)[:, None] >> np.arange(9) & 1
    return np.array([[_bit(next_value(window)) for window in windows.astype(bool).reshape(-1, 3, 3)]])


def _bit(value: Any) -> bool:
    if np.size(value) != 1 or value not in (0, 1):
        got = " ".join(repr(value).split())
        raise ValueError(f"next_value: expected True or False for each window, got {got}")
    return bool(value)
