"""The shared library and its C interface, by ctypes. Calls release the GIL."""

from __future__ import annotations

import ctypes
import struct
import sys
from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

_ENDING = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")
_library = ctypes.CDLL(str(Path(__file__).with_name("libthinbench" + _ENDING)))

# Structs are passed as packed bytes, which is faster than ctypes.Structure. Each begins with its size.
IMAGE = struct.Struct("NPnnnB7x")  # data, width, height, stride, foreground
STACK = struct.Struct("NPnnnnnB7x")  # data, count, width, height, stride, image_stride, foreground
PACKED = struct.Struct("NPnnni4x")  # data, width, height, stride, lsb_first
NUMBERS = struct.Struct("NPnnn")  # data, width, height, stride; labels, reals or 16 bits
COLOURS = struct.Struct("NPnnni4x")  # data, width, height, stride, samples
PATH_REQUEST = struct.Struct("Niiiid")  # start x, start y, goal x, goal y, width
FOUND_PATH = struct.Struct("NNdd")  # count, length, min_width
_SPACING = struct.Struct("Ndd")  # x, y
_PRUNING = struct.Struct("NddPPi4x")  # min_length, min_widths, distances, spacing, removes_components
_HOLE_FILLING = struct.Struct("Nqi4x")  # max_area, connectivity
_THINNING = struct.Struct("NPi4x")  # border, max_iterations
_EXECUTION = struct.Struct("Ni4xP")  # threads, isa
_RULE_INFO = struct.Struct("NPPPi4xPNPii")  # as RuleInfo

_address_of_buffer = ctypes.addressof
_buffer_of: Callable[[Any], ctypes.c_char] = ctypes.c_char.from_buffer

_BYTES = ctypes.c_char_p
# What the letters of signatures stand for: bytes, an address, a number of a kind.
_TYPES = {"b": _BYTES, "p": ctypes.c_void_p, "i": ctypes.c_int32, "u": ctypes.c_uint32, "n": ctypes.c_size_t,
          "d": ctypes.c_double}

UNLIMITED = 2**31 - 1
ANY_HOLE_AREA = 2**63 - 1
_NAMES = [ctypes.create_string_buffer(name) for name in (b"background", b"keep", b"foreground")]
BORDERS = {name.value.decode(): ctypes.addressof(name) for name in _NAMES}


def _function(name: str, arguments: str = "", result: Any = None) -> Callable[..., Any]:
    function: Callable[..., Any] = getattr(_library, "thinbench_" + name)
    function.argtypes = [_TYPES[argument] for argument in arguments]  # type: ignore[attr-defined]
    function.restype = result  # type: ignore[attr-defined]
    return function


_last_error = _function("last_error", result=_BYTES)
_EXCEPTIONS = {1: ValueError, 2: MemoryError}


def _raise_error(status: int, function: Any, arguments: Any) -> None:
    if status:
        raise _EXCEPTIONS.get(status, RuntimeError)(_last_error().decode(errors="replace"))


def _checked(name: str, arguments: str) -> Callable[..., None]:
    """A function that raises an exception instead of returning a status."""
    function = _function(name, arguments, ctypes.c_int32)
    function.errcheck = _raise_error  # type: ignore[attr-defined]
    return function


def _list(name: str) -> Callable[..., Any]:
    """A list of a handle, whose length and element size follow."""
    return _function(name, "ppn", ctypes.c_void_p)


version = _function("version", result=_BYTES)
_release_memory = _function("release_memory")


def release_memory() -> None:
    """Free the memory that the calling thread and idle workers keep for the next calls, at most 8 MiB each."""
    _release_memory()


isa_name = _function("isa_name", "n", _BYTES)
isa_available = _function("isa_available", "b", ctypes.c_int32)

rule_named = _checked("rule_named", "bp")
rule_from_tables = _checked("rule_from_tables", "pnbip")
rule_from_two_layer_net = _checked("rule_from_two_layer_net", "pbp")
rule_from_cluster = _checked("rule_from_cluster", "ppnp")
rule_destroy = _function("rule_destroy", "p")
rule_name = _function("rule_name", "n", _BYTES)
_rule_describe = _checked("rule_describe", "pp")
_rule_gates = _checked("rule_gates", "pnp")
table_from_hensel = _checked("table_from_hensel", "bp")
table_from_patterns = _checked("table_from_patterns", "pnp")
table_from_values = _checked("table_from_values", "bbp")
table_from_removals = _checked("table_from_removals", "bbp")

thin = _checked("thin", "pbbbbp")
thin_stack = _checked("thin_stack", "pbbbbp")
thin_many = _checked("thin_many", "pbbnbbp")
thin_packed = _checked("thin_packed", "pbbbbp")
thin_labels = _checked("thin_labels", "pbbbbp")
midpoint_scan = _checked("midpoint_scan", "bbibb")
binarise = _checked("binarise", "bbbbpp")
binarise16 = _checked("binarise16", "bbbbpp")
select_channel = _checked("select_channel", "bbbbp")
select_channel16 = _checked("select_channel16", "bbbbp")
detect_edges = _checked("detect_edges", "bbbiib")
edge_operator_name = _function("edge_operator_name", "n", _BYTES)
squared_distances = _checked("squared_distances", "bbb")
distances = _checked("distances", "bbbb")
distances_of_labels = _checked("distances_of_labels", "bbbb")

find_regions = _checked("find_regions", "bbp")
label_regions = _checked("label_regions", "bbbp")
find_objects = _checked("find_objects", "bbp")
label_objects = _checked("label_objects", "bbibbp")
label_image = _checked("label_image", "bbibbp")
label_values = _checked("label_values", "bbiibp")
localise_objects = _checked("localise_objects", "bbiibp")
regions_objects = _list("regions_objects")
regions_holes = _list("regions_holes")
regions_destroy = _function("regions_destroy", "p")
fill_holes = _checked("fill_holes", "bbbb")
fill_holes_of_labels = _checked("fill_holes_of_labels", "bbbb")
euler_number = _checked("euler_number", "bibp")

classify_pixels = _checked("classify_pixels", "bbbb")
full_blocks = _checked("full_blocks", "bbpp")
skeleton_graph = _checked("skeleton_graph", "bbp")
graph_of_labels = _checked("graph_of_labels", "bbp")
split_graph = _checked("split_graph", "ppnp")
prune = _checked("prune", "bbbbp")
prune_labels = _checked("prune_labels", "bbbbp")
graph_nodes = _list("graph_nodes")
graph_edges = _list("graph_edges")
graph_node_pixels = _list("graph_node_pixels")
graph_edge_pixels = _list("graph_edge_pixels")
graph_node_labels = _list("graph_node_labels")
graph_destroy = _function("graph_destroy", "p")
edge_widths = _checked("edge_widths", "pbbpn")
polyline = _checked("polyline", "pndbpp")

main_paths = _checked("main_paths", "upnpnbp")
cycles = _checked("cycles", "upnp")
shortest_path = _checked("shortest_path", "upnuup")
components_of = _checked("components_of", "upnp")
graph_paths_list = _list("graph_paths_list")
graph_paths_nodes = _list("graph_paths_nodes")
graph_paths_edges = _list("graph_paths_edges")
graph_paths_destroy = _function("graph_paths_destroy", "p")
find_path = _checked("find_path", "bbbpnp")


@lru_cache(maxsize=256)
def thinning(border: int, max_iterations: int) -> bytes | None:
    """A thinbench_thinning struct, with one of BORDERS; 0 stands for what the rule says."""
    return _THINNING.pack(_THINNING.size, border, max_iterations) if border or max_iterations else None


@lru_cache(maxsize=256)
def execution(threads: int) -> bytes | None:
    """A thinbench_execution struct; None, the library's default, for one thread."""
    return _EXECUTION.pack(_EXECUTION.size, threads, 0) if threads != 1 else None


def hole_filling(connectivity: int, max_area: int) -> bytes:
    """A thinbench_hole_filling struct."""
    return _HOLE_FILLING.pack(_HOLE_FILLING.size, max_area, connectivity)


def spacing(rows: float, columns: float) -> bytes | None:
    """A thinbench_spacing struct; None, the library's default, for squares of side 1."""
    return None if rows == columns == 1 else _SPACING.pack(_SPACING.size, columns, rows)


def pruning(min_length: float, min_widths: float, distances: bytes | None, spacing: bytes | None,
            removes_components: bool) -> bytes:
    """A thinbench_pruning struct; the other structs must live as long."""
    return _PRUNING.pack(_PRUNING.size, min_length, min_widths, *map(_address_of_bytes, (distances, spacing)),
                         removes_components)


def _address_of_bytes(data: bytes | None) -> int:
    return 0 if data is None else ctypes.cast(ctypes.c_char_p(data), ctypes.c_void_p).value or 0


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
