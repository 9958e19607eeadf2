"""The graphs of all labels of an image, of which labels that touch are looked at apart."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench._skeleton_graph import Graph, Groups, bounds_of, counted

Array = npt.NDArray[Any]


def graph_of(lines: Array, objects: Array, find: Callable[[Array, Array], Graph]) -> Graph:
    """`find(lines, objects)` for labels that do not touch one another, as often as needed."""
    is_line, is_object = lines != 0, objects != 0
    pairs = _touching(objects, is_object)
    if len(pairs) == 0:
        found = find(is_line, is_object)
    else:
        labels, numbers = np.unique(objects, return_inverse=True)
        colours = _colours(labels, np.searchsorted(labels, pairs))
        of_pixels = colours[numbers].reshape(objects.shape)
        found = _joined([find(is_line & (of_pixels == colour), of_pixels == colour)
                         for colour in range(1, int(colours.max()) + 1)])
    of_nodes = lines[tuple(found._nodes.values[found._nodes.bounds[:-1]].T)]
    found.nodes["label"] = of_nodes.astype(np.int64)
    found.edges["label"] = found.nodes["label"][found.edges["from"]]
    return found._with_edges(np.argsort(found.edges["label"], kind="stable"),
                             np.argsort(found.nodes["label"], kind="stable"))


def _colours(labels: Array, pairs: Array) -> Array:
    """1, 2, ... for every label, and 0 for the background, so that both of each pair are different."""
    neighbours: dict[int, list[int]] = {}
    for one, other in pairs.tolist():
        neighbours.setdefault(other, []).append(one)
    colours: Array = (labels != 0).astype(np.int64)
    for number in sorted(neighbours):  # the others of its pairs are below, and have their colours
        taken = {int(colours[other]) for other in neighbours[number]}
        colours[number] = min(set(range(1, len(taken) + 2)) - taken)
    return colours


def _touching(objects: Array, is_object: Array) -> Array:
    """The pairs of labels with pixels that are 8-neighbours, the lower first."""
    height, width = objects.shape
    pairs = []
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
        here = np.s_[:height - down, max(-right, 0):width - max(right, 0)]
        there = np.s_[down:, max(right, 0):width + min(right, 0)]
        touch = objects[here] != objects[there]
        touch &= is_object[here]
        touch &= is_object[there]
        pairs.append(np.stack([objects[here][touch], objects[there][touch]], axis=-1))
    found: Array = np.unique(np.sort(np.concatenate(pairs), axis=1), axis=0)
    return found


def _joined(graphs: list[Graph]) -> Graph:
    """All nodes, one graph after another, and all edges."""
    if len(graphs) == 1:
        return graphs[0]
    first = bounds_of([len(graph.nodes["kind"]) for graph in graphs])
    nodes = {name: np.concatenate([graph.nodes[name] for graph in graphs]) for name in graphs[0].nodes}
    edges = {name: np.concatenate([graph.edges[name] for graph in graphs]) for name in graphs[0].edges}
    for side in ("from", "to"):
        edges[side] = np.concatenate([graph.edges[side] + start for graph, start in zip(graphs, first)])
    distances = [graph._distances for graph in graphs if graph._distances is not None]
    return counted(nodes, edges, graphs[0].spacing, _concatenated([graph._nodes for graph in graphs]),
                   _concatenated([graph._chains for graph in graphs]),
                   np.maximum.reduce(distances) if distances else None)


def _concatenated(groups: list[Groups]) -> Groups:
    lengths = np.concatenate([group.lengths() for group in groups])
    return Groups(np.concatenate([group.values for group in groups]), bounds_of(lengths))
