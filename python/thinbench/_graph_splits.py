"""Graphs with nodes at given pixels of their lines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays
from thinbench._skeleton_graph import Graph, Groups, bounds_of, counted

Array = npt.NDArray[Any]


def split_at(graph: Graph, pixels: Iterable[Sequence[int]]) -> Graph:
    """The graph with a node at each pixel (row, column); pixels of nodes change nothing."""
    for pixel in pixels:
        if len(pixel) != 2:
            raise ValueError(f"nodes: expected pairs of row and column, got {pixel!r}")
        row, column = (_arrays.integer("nodes", number) for number in pixel)
        graph = _split(graph, np.array([row, column]))
    return graph


def _split(graph: Graph, pixel: Array) -> Graph:
    if (graph._nodes.values == pixel).all(axis=1).any():
        return graph
    places = np.flatnonzero((graph._chains.values == pixel).all(axis=1))
    if len(places) == 0:
        raise ValueError(f"nodes: expected pixels of the skeleton, got row {pixel[0]}, column {pixel[1]}")
    edge = int(np.searchsorted(graph._chains.bounds, places[0], side="right")) - 1
    chain = graph.edge_pixels(edge)
    at = int(places[0] - graph._chains.bounds[edge])
    node = len(graph.nodes["kind"])
    ends = [(graph.edges["from"][edge], chain[:at + 1]), (graph.edges["to"][edge], chain[at:][::-1])]
    pieces = [_piece(graph, int(first), node, part) for first, part in ends]
    edges = {name: np.insert(np.delete(column, edge), edge, [piece[name] for piece in pieces])
             for name, column in graph.edges.items()}
    chains = [graph.edge_pixels(i) for i in range(len(graph.edges["from"]))]
    chains[edge:edge + 1] = [part for _, part in ends]
    nodes = {name: np.append(column, _node_value(graph, name, pixel)) for name, column in graph.nodes.items()}
    node_pixels = Groups(np.concatenate([graph._nodes.values, pixel[None].astype(np.int32)]),
                         np.append(graph._nodes.bounds, graph._nodes.bounds[-1] + 1))
    return counted(nodes, edges, graph.spacing, node_pixels,
                   Groups(np.concatenate(chains), bounds_of([len(part) for part in chains])), graph._distances)


def _node_value(graph: Graph, name: str, pixel: Array) -> Any:
    if name == "width" and graph._distances is not None:
        return 2 * graph._distances[tuple(pixel)]
    return {"kind": "given", "row": pixel[0], "column": pixel[1]}.get(name, 0)


def _piece(graph: Graph, first: int, last: int, chain: Array) -> dict[str, float]:
    """The columns of an edge along these pixels."""
    rows, columns = graph.spacing
    steps = np.abs(np.diff(chain, axis=0))
    diagonal = int((steps.sum(axis=1) == 2).sum())
    down, across = steps.sum(axis=0) - diagonal
    found = {"from": first, "to": last,
             "length": across * columns + down * rows + diagonal * np.sqrt(columns * columns + rows * rows),
             "chord": float(np.hypot(*((chain[-1] - chain[0]) * graph.spacing)))}
    if graph._distances is not None:
        widths = 2 * graph._distances[tuple(chain.T)]
        found.update({"width-mean": widths.mean(), "width-median": np.median(widths),
                      "width-min": widths.min(), "width-max": widths.max()})
    return found
