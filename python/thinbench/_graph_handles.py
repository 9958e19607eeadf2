"""Graphs of the library as arrays."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library
from thinbench._network import EDGE
from thinbench._skeleton_graph import KINDS, Array, Graph, Groups, bounds_of, counted

_PIXEL = np.dtype(("i4", 2))  # column and row
_NODE = np.dtype([("kind", "i4"), ("first_pixel", "u4"), ("pixel_count", "u4")])


def split_graph(handle: ctypes.c_void_p, pixels: Iterable[Sequence[int]]) -> ctypes.c_void_p:
    """The graph with a node at each pixel (row, column), instead of the handle."""
    try:
        places = np.array([_pixel_of(pixel) for pixel in _arrays.each("nodes", pixels)], np.int32)
        split = ctypes.c_void_p()
        if len(places):
            _library.split_graph(handle, _library.address(places), len(places), ctypes.byref(split))
    except BaseException:
        _library.graph_destroy(handle)
        raise
    if not split:
        return handle
    _library.graph_destroy(handle)
    return split


def _pixel_of(pixel: Sequence[int]) -> tuple[int, int]:
    column, row = _arrays.pixel("nodes", pixel)
    if row < 0 or column < 0:
        raise ValueError(f"nodes: expected pixels of the skeleton, got row {row}, column {column}")
    return column, row


def pruning(min_length: float, min_widths: float, removes_components: bool, distances: Array | None,
            spacing: tuple[float, float], image: str) -> tuple[bytes, Any]:
    """A thinbench_pruning struct, and what must live as long; `image` is the argument that gives distances."""
    widths = _arrays.real("min_widths", min_widths)
    if distances is None and widths > 0:
        raise ValueError(f"min_widths: expected {image}=..., what was thinned, beside it, got {widths:g} without")
    parts = None if distances is None else _arrays.numbers(distances), _library.spacing(*spacing)
    return _library.pruning(_arrays.real("min_length", min_length), widths, *parts, bool(removes_components)), parts


def taken(handle: ctypes.c_void_p, shape: tuple[int, ...], spacing: tuple[float, float], distances: Array | None, *,
          has_labels: bool = False) -> Graph:
    """The graph of a handle, which is destroyed; `shape` is that of the image."""
    try:
        nodes, edges, node_pixels, edge_pixels = (
            _library.copied(handle, [list_of], dtype)[0] for list_of, dtype in (
                (_library.graph_nodes, _NODE), (_library.graph_edges, EDGE),
                (_library.graph_node_pixels, _PIXEL), (_library.graph_edge_pixels, _PIXEL)))
        labels = _library.copied(handle, [_library.graph_node_labels], np.dtype(np.int32))[0].astype(np.int64)
        widths = {} if distances is None else _width_columns(handle, distances, len(edges))
    finally:
        _library.graph_destroy(handle)
    pixels = Groups(node_pixels[:, ::-1], bounds_of(nodes["pixel_count"]))
    chains = _chains(edges, edge_pixels)
    node_columns, edge_columns = _node_columns(nodes, pixels, distances), {**_edge_columns(edges, spacing), **widths}
    if has_labels:
        node_columns["label"] = labels
        edge_columns["label"] = labels[edges["from"]]
    return counted(node_columns, edge_columns, spacing, shape, pixels, chains, edges, distances)


def _chains(edges: Array, lines: Array) -> Groups:
    """The rows and columns along each edge, from start to stop."""
    bounds = bounds_of(edges["pixel_count"] + 2)
    first, last = bounds[:-1], bounds[1:] - 1
    values = np.empty((bounds[-1], 2), np.int32)
    values[first], values[last] = edges["start"], edges["stop"]
    is_line = np.ones(len(values), bool)
    is_line[first] = is_line[last] = False
    values.view(np.int64)[is_line] = lines.view(np.int64)  # a pixel at a time
    return Groups(values[:, ::-1], bounds)


def _node_columns(nodes: Array, pixels: Groups, distances: Array | None) -> dict[str, Array]:
    sums = pixels.reduced(np.add, pixels.values.astype(np.int64))
    rows, columns = (sums / nodes["pixel_count"][:, None]).T
    found = {"kind": KINDS[nodes["kind"]], "row": rows, "column": columns}
    if distances is not None:
        found["width"] = 2 * pixels.reduced(np.maximum, distances[tuple(pixels.values.T)])
    return found


def _edge_columns(edges: Array, spacing: tuple[float, float]) -> dict[str, Array]:
    rows, columns = spacing
    difference = (edges["stop"] - edges["start"])[:, ::-1] * spacing
    straight = edges["horizontal_steps"] * columns + edges["vertical_steps"] * rows
    return {"from": edges["from"].astype(np.int64), "to": edges["to"].astype(np.int64),
            "length": straight + edges["diagonal_steps"] * np.sqrt(columns * columns + rows * rows),
            "chord": np.hypot(difference[:, 0], difference[:, 1])}


def _width_columns(handle: ctypes.c_void_p, distances: npt.NDArray[np.float64], count: int) -> dict[str, Array]:
    widths = np.empty((count, 4))
    _library.edge_widths(handle, _arrays.numbers(distances), None, widths.ctypes.data, widths.itemsize * 4)
    return {"width-" + name: widths[:, i] for i, name in enumerate(("mean", "median", "min", "max"))}
