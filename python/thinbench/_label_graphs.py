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
    labels, numbers = np.unique(objects, return_inverse=True)
    colours = _colours(labels, numbers.reshape(objects.shape))[numbers.reshape(objects.shape)]
    graphs = [find((colours == colour) & (lines != 0), colours == colour)
              for colour in range(1, max(int(colours.max(initial=0)), 1) + 1)]
    found = _joined(graphs)
    of_nodes = lines[tuple(found._nodes.values[found._nodes.bounds[:-1]].T)]
    found.nodes["label"] = of_nodes.astype(np.int64)
    found.edges["label"] = found.nodes["label"][found.edges["from"]]
    return found._with_edges(np.argsort(found.edges["label"], kind="stable"),
                             np.argsort(found.nodes["label"], kind="stable"))


def _colours(labels: Array, numbers: Array) -> Array:
    """1, 2, ... for every label, and 0 for the background, so that labels that touch have different ones."""
    neighbours: dict[int, list[int]] = {}
    for one, other in _touching(numbers, labels != 0):
        neighbours.setdefault(int(other), []).append(int(one))
    colours: Array = (labels != 0).astype(np.int64)
    for number in sorted(neighbours):  # all that it has touched so far are below
        taken = {int(colours[other]) for other in neighbours[number]}
        colours[number] = min(set(range(1, len(taken) + 2)) - taken)
    return colours


def _touching(numbers: Array, is_label: Array) -> Array:
    """The pairs of labels with pixels that are 8-neighbours, the lower first."""
    height, width = numbers.shape
    pairs = []
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
        one = numbers[:height - down, max(-right, 0):width - max(right, 0)].ravel()
        other = numbers[down:, max(right, 0):width + min(right, 0)].ravel()
        touch = (one != other) & is_label[one] & is_label[other]
        pairs.append(np.stack([one[touch], other[touch]], axis=-1))
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
