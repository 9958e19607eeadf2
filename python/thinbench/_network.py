"""Paths through graphs: nodes with numbers, and links between them."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _library

_LINK = np.dtype([("from", "u4"), ("to", "u4"), ("length", "f8")])
_PATH = np.dtype([("length", "f8"), ("first_node", "u8"), ("node_count", "u8"), ("first_edge", "u8"),
                  ("edge_count", "u8"), ("first_point", "i8"), ("last_point", "i8")])
EDGE = np.dtype([("from", "u4"), ("to", "u4"), ("start", "i4", 2), ("stop", "i4", 2), ("first_pixel", "u4"),
                 ("pixel_count", "u4"), ("horizontal_steps", "u4"), ("vertical_steps", "u4"), ("diagonal_steps", "u4")])

Array = npt.NDArray[Any]
Path = tuple[float, Array, Array, int, int]  # its length, nodes, links, and points of the first and the last; -1: none


def links(first: Array, last: Array, length: Array) -> Array:
    """What the functions below take."""
    table = np.empty(len(first), _LINK)
    table["from"], table["to"], table["length"] = first, last, length
    return table


def main_paths(nodes: int, edges: Array, pixels: Array, spacing: tuple[float, float]) -> list[Path]:
    """Of edges of the type EDGE; pixels are columns and rows."""
    return _found(_library.main_paths, nodes, edges, _library.address(pixels), len(pixels), _library.spacing(*spacing))


def cycles(nodes: int, table: Array) -> list[Path]:
    return _found(_library.cycles, nodes, table)


def shortest_path(nodes: int, table: Array, first: int, last: int) -> list[Path]:
    """One path, or none."""
    return _found(_library.shortest_path, nodes, table, first, last)


def components(nodes: int, table: Array) -> Array:
    """The component of every node, numbered from 0 by their first nodes."""
    numbers = np.empty(nodes, np.uint32)
    _library.components_of(nodes, _library.address(table), len(table), _library.address(numbers))
    return numbers.astype(np.int64)


def _found(function: Callable[..., None], nodes: int, table: Array, *more: Any) -> list[Path]:
    handle = ctypes.c_void_p()
    function(nodes, _library.address(table), len(table), *more, ctypes.byref(handle))
    try:
        paths = _library.copied(handle, [_library.graph_paths_list], _PATH)[0]
        numbers = [_library.copied(handle, [list_of], np.dtype("u4"))[0].astype(np.int64)
                   for list_of in (_library.graph_paths_nodes, _library.graph_paths_edges)]
    finally:
        _library.graph_paths_destroy(handle)
    return [(float(length), numbers[0][node:node + node_count], numbers[1][edge:edge + edge_count], first, last)
            for length, node, node_count, edge, edge_count, first, last in paths.tolist()]
