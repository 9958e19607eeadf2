"""The shared library and its C interface, by ctypes. Calls release the GIL."""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

_library = ctypes.CDLL(str(Path(__file__).with_name("libthinbench.so")))

# Structs are passed as packed bytes, which is faster than ctypes.Structure.
STACK = struct.Struct("Pnnnnn")  # data, count, height, width, stride, image_stride
OUTPUT = struct.Struct("PnnB7x")  # data, stride, image_stride, foreground
PACKED = struct.Struct("Pnnni4x")  # data, height, width, stride, lsb_first
_OPTIONS = struct.Struct("NiiiPP")  # size, keep_border, max_iterations, threads, isa, technique
_VARIANT = struct.Struct("NPPiP")
_NAMED_RULE = struct.Struct("NPPPPNPi4x")  # size, name, description, source, tables, and below

_BYTES = ctypes.c_char_p
_POINTER = ctypes.c_void_p
_INT = ctypes.c_int32


def _function(name: str, *arguments: type, result: type | None = _INT) -> Callable[..., Any]:
    function: Callable[..., Any] = getattr(_library, "thinbench_" + name)
    function.argtypes = arguments  # type: ignore[attr-defined]
    function.restype = result  # type: ignore[attr-defined]
    return function


_last_error = _function("last_error", result=_BYTES)
_EXCEPTIONS = {1: ValueError, 2: MemoryError}


def _raise_error(status: int, function: Any, arguments: Any) -> None:
    if status:
        raise _EXCEPTIONS.get(status, RuntimeError)(_last_error().decode(errors="replace"))


def _checked(name: str, *arguments: type) -> Callable[..., None]:
    """A function that raises an exception instead of returning a status."""
    function = _function(name, *arguments)
    function.errcheck = _raise_error  # type: ignore[attr-defined]
    return function


version = _function("version", result=_BYTES)
thin = _checked("thin", _BYTES, _BYTES, _BYTES, _BYTES, _POINTER)
thin_packed = _checked(
    "thin_packed", _BYTES, _BYTES, _POINTER, ctypes.c_ssize_t, _BYTES, _POINTER)
thin_labels = _checked("thin_labels", _BYTES, _POINTER, ctypes.c_ssize_t, _POINTER, ctypes.c_ssize_t,
                       ctypes.c_ssize_t, ctypes.c_ssize_t, _BYTES, _POINTER)
edges = _checked("edges", _BYTES, _BYTES, _BYTES, _INT, _INT, _BYTES)
squared_distances = _checked(
    "squared_distances", _BYTES, _POINTER, ctypes.c_ssize_t, _BYTES)
classify_pixels = _checked(
    "classify_pixels", _BYTES, _POINTER, ctypes.c_ssize_t, _POINTER, ctypes.c_ssize_t)
full_blocks = _checked("full_blocks", _BYTES, _POINTER, _POINTER)
polyline = _checked(
    "polyline", _POINTER, ctypes.c_size_t, ctypes.c_double, _POINTER, _POINTER)
skeleton_graph = _checked("skeleton_graph", _BYTES, _BYTES, _POINTER)
prune = _checked("prune", _BYTES, _BYTES, _BYTES, _BYTES, _POINTER)
find_regions = _checked(
    "find_regions", _BYTES, _POINTER, ctypes.c_ssize_t, _BYTES, _POINTER)
localise = _checked("localise", _BYTES, _INT, _INT, _BYTES, _POINTER)
fill_holes = _checked("fill_holes", _BYTES, _BYTES, _BYTES)
euler_number = _checked("euler_number", _BYTES, _INT, _BYTES, _POINTER)
regions_objects = _function(
    "regions_objects", _POINTER, _POINTER, ctypes.c_size_t, result=_POINTER)
regions_holes = _function(
    "regions_holes", _POINTER, _POINTER, ctypes.c_size_t, result=_POINTER)
graph_nodes, graph_edges, graph_node_pixels, graph_edge_pixels = (
    _function("graph_" + part, _POINTER, _POINTER, ctypes.c_size_t, result=_POINTER)
    for part in ("nodes", "edges", "node_pixels", "edge_pixels"))
graph_edge_widths = _checked("graph_edge_widths", _POINTER, _POINTER, ctypes.c_ssize_t, ctypes.c_ssize_t,
                             ctypes.c_ssize_t, _POINTER)
graph_destroy = _function("graph_destroy", _POINTER, result=None)
regions_destroy = _function("regions_destroy", _POINTER, result=None)
rule_name = _function("rule_name", ctypes.c_size_t, result=_BYTES)
rule_description = _function("rule_description", ctypes.c_size_t, result=_BYTES)
rule_reach = _function("rule_reach", ctypes.c_size_t)
edge_operator_name = _function("edge_operator_name", ctypes.c_size_t, result=_BYTES)
isa_name = _function("isa_name", ctypes.c_size_t, result=_BYTES)
isa_available = _function("isa_available", _BYTES)
_rule_variant = _function("rule_variant", _BYTES, ctypes.c_size_t, _POINTER)
table_from_hensel = _checked("table_from_hensel", _BYTES, _POINTER)
table_from_patterns = _checked("table_from_patterns", _POINTER, ctypes.c_size_t, _POINTER)
table_from_values = _checked("table_from_values", _BYTES, _BYTES, _POINTER)
table_from_removals = _checked("table_from_removals", _BYTES, _BYTES, _POINTER)
named_rule_name = _function("named_rule_name", ctypes.c_size_t, result=_BYTES)
_find_named_rule = _checked("find_named_rule", _BYTES, _POINTER)
_custom_rule_create = _checked(
    "custom_rule_create", _POINTER, ctypes.c_size_t, _BYTES, _INT, _INT, _POINTER)
_custom_rule_gates = _checked("custom_rule_gates", _POINTER, ctypes.c_size_t, _POINTER)
custom_rule_destroy = _function("custom_rule_destroy", _POINTER, result=None)
apply = _checked("apply", _POINTER, _BYTES, _BYTES, _BYTES, _POINTER)
_thinner_create = _checked(
    "thinner_create", _BYTES, ctypes.c_ssize_t, ctypes.c_ssize_t, _BYTES, _POINTER)
_thinner_technique = _function("thinner_technique", _POINTER, result=_BYTES)
_thinner_isa = _function("thinner_isa", _POINTER, result=_BYTES)
_thinner_destroy = _function("thinner_destroy", _POINTER, result=None)

@lru_cache(maxsize=256)
def options(keep_border: bool = False, max_iterations: int = 0, threads: int = 1) -> bytes:
    """A thinbench_options struct."""
    return _OPTIONS.pack(_OPTIONS.size, keep_border, max_iterations, threads, 0, 0)


def _text(pointer: int | None) -> str | None:
    return ctypes.string_at(pointer).decode() if pointer else None


def rule_variants(rule: bytes) -> list[tuple[str | None, str | None, bool, str | None]]:
    """Technique, ISA, whether threaded, and the reason why it cannot run, of all variants."""
    found: list[tuple[str | None, str | None, bool, str | None]] = []
    buffer = ctypes.create_string_buffer(_VARIANT.pack(_VARIANT.size, 0, 0, 0, 0), _VARIANT.size)
    while _rule_variant(rule, len(found), buffer) == 0:
        _, technique, isa, threaded, reason = _VARIANT.unpack(buffer.raw)
        found.append((_text(technique), _text(isa), bool(threaded), _text(reason)))
    return found


def chosen_variant(rule: bytes, height: int, width: int) -> tuple[str, str]:
    """The technique and ISA for images of this size."""
    thinner = ctypes.c_void_p()
    _thinner_create(rule, width, height, None, ctypes.byref(thinner))
    found = _thinner_technique(thinner).decode(), _thinner_isa(thinner).decode()
    _thinner_destroy(thinner)
    return found


class NamedRule(NamedTuple):
    """A thinbench_named_rule struct."""

    description: str
    source: str
    words: npt.NDArray[np.uint64]  # 8 per sub-iteration
    sub_iterations: int
    border: str
    max_iterations: int  # 0: unlimited


def find_named_rule(name: bytes) -> NamedRule:
    """The rule of this name."""
    size = _NAMED_RULE.size
    buffer = ctypes.create_string_buffer(_NAMED_RULE.pack(size, *[0] * 7), size)
    _find_named_rule(name, buffer)
    _, _, description, source, tables, sub_iterations, border, limit = _NAMED_RULE.unpack(
        buffer.raw)
    words = np.frombuffer(ctypes.string_at(tables, 64 * sub_iterations), np.uint64)
    return NamedRule(_text(description) or "", _text(source) or "", words, sub_iterations,
                     _text(border) or "", limit)


def custom_rule(words: npt.NDArray[np.uint64], border: bytes, max_iterations: int,
                optimise: bool) -> int | None:
    """The address of a new rule."""
    handle = ctypes.c_void_p()
    _custom_rule_create(words.ctypes.data, len(words), border, max_iterations, optimise,
                        ctypes.byref(handle))
    return handle.value


def custom_rule_gates(handle: int | None, sub_iteration: int) -> int:
    """The number of gates of a sub-iteration."""
    gates = ctypes.c_int32()
    _custom_rule_gates(handle, sub_iteration, ctypes.byref(gates))
    return gates.value


def all_names(name_at: Callable[..., Any]) -> list[str]:
    """The names that a function of the catalogue lists."""
    found: list[str] = []
    while (name := name_at(len(found))) is not None:
        found.append(name.decode())
    return found
