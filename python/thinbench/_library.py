"""The shared library and its C interface, by ctypes. Calls release the GIL."""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable, Sequence
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
_THINNING = struct.Struct("NPi4x")  # size, border, max_iterations, reserved
SPACING = struct.Struct("dd")  # y, x
PRUNING = struct.Struct("NddPni4xP")
_EXECUTION = struct.Struct("Ni4xP")  # size, threads, isa
_RULE_INFO = struct.Struct("NPPPi4xPNPii")  # size, name, and as RuleInfo

_address_of_buffer = ctypes.addressof
_buffer_of: Callable[[Any], ctypes.c_char] = ctypes.c_char.from_buffer

_BYTES = ctypes.c_char_p
_POINTER = ctypes.c_void_p
_INT = ctypes.c_int32
_SIZE = ctypes.c_size_t
_DISTANCE = ctypes.c_ssize_t

UNLIMITED = 2**31 - 1
ANY_HOLE_AREA = 2**63 - 1
_NAMES = [ctypes.create_string_buffer(name) for name in (b"background", b"keep", b"foreground")]
BORDERS = {name.value.decode(): ctypes.addressof(name) for name in _NAMES}


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
_release_memory = _function("release_memory", result=None)


def release_memory() -> None:
    """Free the memory that the calling thread keeps for its next calls, at most 8 MiB."""
    _release_memory()


thin = _checked("thin", _POINTER, _BYTES, _BYTES, _BYTES, _BYTES, _POINTER)
thin_packed = _checked(
    "thin_packed", _POINTER, _BYTES, _POINTER, _DISTANCE, _BYTES, _BYTES, _POINTER)
thin_labels = _checked("thin_labels", _POINTER, _POINTER, _DISTANCE, _POINTER, _DISTANCE, _DISTANCE,
                       _DISTANCE, _BYTES, _BYTES, _POINTER)
binarise = _checked("binarise", _BYTES, _BYTES, _BYTES, _POINTER, _POINTER)
select_channel = _checked("select_channel", _POINTER, _DISTANCE, _POINTER, _DISTANCE, _DISTANCE,
                          _DISTANCE, _INT, _BYTES, _POINTER)
midpoint_scan = _checked("midpoint_scan", _BYTES, _BYTES, _INT, _BYTES, _BYTES)
edges = _checked("edges", _BYTES, _BYTES, _BYTES, _INT, _INT, _BYTES)
squared_distances = _checked("squared_distances", _BYTES, _POINTER, _DISTANCE, _BYTES)
distances = _checked("distances", _BYTES, _POINTER, _DISTANCE, _BYTES, _BYTES)
classify_pixels = _checked("classify_pixels", _BYTES, _POINTER, _DISTANCE, _POINTER, _DISTANCE)
full_blocks = _checked("full_blocks", _BYTES, _POINTER, _POINTER)
polyline = _checked("polyline", _POINTER, _SIZE, ctypes.c_double, _BYTES, _POINTER, _POINTER)
skeleton_graph = _checked("skeleton_graph", _BYTES, _BYTES, _POINTER)


class Pixel(ctypes.Structure):
    """A thinbench_pixel struct."""

    _fields_ = [("x", ctypes.c_int32), ("y", ctypes.c_int32)]


find_path = _checked("find_path", _BYTES, Pixel, Pixel, ctypes.c_double, _BYTES, _POINTER, _POINTER)
prune = _checked("prune", _BYTES, _BYTES, _BYTES, _BYTES, _POINTER)
graph_of_labels = _checked("graph_of_labels", _POINTER, _DISTANCE, _DISTANCE, _DISTANCE, _BYTES, _POINTER)
label_distances = _checked("label_distances", _POINTER, _DISTANCE, _POINTER, _DISTANCE, _DISTANCE, _DISTANCE,
                           _BYTES, _BYTES)
prune_labels = _checked("prune_labels", _POINTER, _DISTANCE, _POINTER, _DISTANCE, _DISTANCE, _DISTANCE, _BYTES,
                        _BYTES, _POINTER)
graph_split = _checked("graph_split", _POINTER, _POINTER, _SIZE, _POINTER)
find_regions = _checked("find_regions", _BYTES, _POINTER, _DISTANCE, _BYTES, _POINTER)
label_image, label_components = (
    _checked(name, _BYTES, _POINTER, _DISTANCE, _INT, _BYTES, _BYTES, _POINTER)
    for name in ("label_image", "label_components"))
label_values = _checked("label_values", _POINTER, _DISTANCE, _POINTER, _DISTANCE, _DISTANCE, _DISTANCE, _INT,
                        _INT, _POINTER)
localise = _checked("localise", _BYTES, _INT, _INT, _BYTES, _POINTER)
fill_small_holes = _checked(
    "fill_small_holes", _BYTES, _BYTES, _INT, ctypes.c_int64, _BYTES)
fill_label_holes = _checked("fill_label_holes", _POINTER, _DISTANCE, _POINTER, _DISTANCE, _DISTANCE, _DISTANCE,
                            _INT, ctypes.c_int64, _BYTES)
euler_number = _checked("euler_number", _BYTES, _INT, _BYTES, _POINTER)
(regions_objects, regions_holes, graph_nodes, graph_edges, graph_node_pixels, graph_edge_pixels, graph_node_labels,
 graph_paths_list, graph_paths_nodes, graph_paths_edges) = (
    _function(lists, _POINTER, _POINTER, _SIZE, result=_POINTER)
    for lists in ("regions_objects", "regions_holes", "graph_nodes", "graph_edges", "graph_node_pixels",
                  "graph_edge_pixels", "graph_node_labels", "graph_paths_list", "graph_paths_nodes", "graph_paths_edges"))
main_paths = _checked("main_paths", ctypes.c_uint32, _POINTER, _SIZE, _POINTER)
cycles = _checked("cycles", ctypes.c_uint32, _POINTER, _SIZE, _POINTER)
shortest_path = _checked(
    "shortest_path", ctypes.c_uint32, _POINTER, _SIZE, ctypes.c_uint32, ctypes.c_uint32, _POINTER)
components = _checked("components", ctypes.c_uint32, _POINTER, _SIZE, _POINTER)
graph_paths_destroy = _function("graph_paths_destroy", _POINTER, result=None)
graph_edge_widths = _checked(
    "graph_edge_widths", _POINTER, _POINTER, _DISTANCE, _DISTANCE, _DISTANCE, _POINTER)
graph_destroy = _function("graph_destroy", _POINTER, result=None)
regions_destroy = _function("regions_destroy", _POINTER, result=None)
table_from_hensel = _checked("table_from_hensel", _BYTES, _POINTER)
table_from_patterns = _checked("table_from_patterns", _POINTER, _SIZE, _POINTER)
table_from_values = _checked("table_from_values", _BYTES, _BYTES, _POINTER)
table_from_removals = _checked("table_from_removals", _BYTES, _BYTES, _POINTER)
rule_named = _checked("rule_named", _BYTES, _POINTER)
rule_from_tables = _checked("rule_from_tables", _POINTER, _SIZE, _BYTES, _INT, _POINTER)
rule_from_two_layer_net = _checked("rule_from_two_layer_net", _POINTER, _BYTES, _POINTER)
rule_from_cluster = _checked("rule_from_cluster", _POINTER, _POINTER, _SIZE, _POINTER)
rule_destroy = _function("rule_destroy", _POINTER, result=None)
rule_name = _function("rule_name", _SIZE, result=_BYTES)
_rule_describe = _checked("rule_describe", _POINTER, _POINTER)
_rule_gates = _checked("rule_gates", _POINTER, _SIZE, _POINTER)
edge_operator_name = _function("edge_operator_name", _SIZE, result=_BYTES)
isa_name = _function("isa_name", _SIZE, result=_BYTES)
isa_available = _function("isa_available", _BYTES)


@lru_cache(maxsize=256)
def thinning(border: int, max_iterations: int) -> bytes | None:
    """A thinbench_thinning struct, with one of BORDERS; 0 stands for what the rule says."""
    return _THINNING.pack(_THINNING.size, border, max_iterations) if border or max_iterations else None


@lru_cache(maxsize=256)
def execution(threads: int) -> bytes | None:
    """A thinbench_execution struct; None, the library's default, for one thread."""
    return _EXECUTION.pack(_EXECUTION.size, threads, 0) if threads != 1 else None


class RuleInfo(NamedTuple):
    """A thinbench_rule_info struct."""

    name: str
    description: str
    source: str
    is_built_in: bool
    words: npt.NDArray[np.uint64]  # 8 per sub-iteration
    border: str
    max_iterations: int
    reach: int


def describe(handle: int | None) -> RuleInfo:
    """What a rule says about itself."""
    buffer = ctypes.create_string_buffer(_RULE_INFO.pack(_RULE_INFO.size, *[0] * 9), _RULE_INFO.size)
    _rule_describe(handle, buffer)
    (_, name, description, source, built_in, tables, sub_iterations, border, max_iterations,
     reach) = _RULE_INFO.unpack(buffer.raw)
    words = np.frombuffer(ctypes.string_at(tables, 64 * sub_iterations), np.uint64)
    return RuleInfo(_text(name), _text(description), _text(source), bool(built_in), words,
                    _text(border), max_iterations, reach)


def _text(pointer: int | None) -> str:
    return ctypes.string_at(pointer).decode() if pointer else ""


def gates(handle: int | None, sub_iteration: int) -> int:
    """The number of gates of a sub-iteration."""
    number = ctypes.c_int32()
    _rule_gates(handle, sub_iteration, ctypes.byref(number))
    return number.value


def address(array: npt.NDArray[Any]) -> int:
    """Where the first element is."""
    try:
        return _address_of_buffer(_buffer_of(array))  # a quarter of the time, but not for all arrays
    except (BufferError, TypeError, ValueError):  # read-only, with gaps, or without elements
        place: int = array.__array_interface__["data"][0]
        return place


def copied(handle: ctypes.c_void_p, lists: Sequence[Callable[..., Any]], dtype: np.dtype[Any],
           ) -> tuple[npt.NDArray[Any], list[int]]:
    """Lists of a result, which they outlive, one after another, and their lengths."""
    number = ctypes.c_size_t()
    place = ctypes.byref(number)
    found = [(list_of(handle, place, dtype.itemsize), number.value) for list_of in lists]
    counts = [count for _, count in found]
    total = sum(counts)
    memory = bytearray(total * dtype.itemsize)
    copy: npt.NDArray[Any] = np.ndarray(total, dtype, memory)
    if memory:
        to = _address_of_buffer(_buffer_of(memory))
        for first, count in found:
            if count:
                ctypes.memmove(to, first, count * dtype.itemsize)
                to += count * dtype.itemsize
    return copy, counts


def handle_from(make: Callable[..., None], *arguments: Any) -> int | None:
    """The address of the object that a function of the library makes."""
    handle = ctypes.c_void_p()
    make(*arguments, ctypes.byref(handle))
    return handle.value


def all_names(name_at: Callable[..., Any]) -> list[str]:
    """The names that a function of the catalogue lists."""
    found: list[str] = []
    while (name := name_at(len(found))) is not None:
        found.append(name.decode())
    return found
