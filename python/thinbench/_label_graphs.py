"""Graphs and pruning of skeletons that share an image, each with its own label."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library
from thinbench._graph_handles import pruning, taken
from thinbench._skeleton_graph import Graph

Array = npt.NDArray[Any]
Spacing = float | Sequence[float]


def graph_of_labels(skeletons: npt.ArrayLike, labels: npt.ArrayLike | None = None, *, spacing: Spacing = 1,
                    threads: int = 1) -> Graph:
    """Find the graphs of many skeletons that share an image, each with its own label, in one call.

    Pixels with different labels are never joined, even where they touch. The result is that of a loop over
    the labels with `skeleton_graph(skeletons == label, labels == label)`, one after another.

    Parameters
    ----------
    skeletons : array of bool or integers, shape (H, W)
        0 is background; `thin_labels(labels)` makes such an image.
    labels : array of bool or integers, shape (H, W), optional
        What was thinned, for the widths of edges.
    spacing, threads
        As for `skeleton_graph`.

    Returns
    -------
    Graph
        Nodes and edges have a column "label", by which they are sorted.

    Examples
    --------
    >>> import thinbench
    >>> found = thinbench.graph_of_labels([[5, 5, 5, 2], [0, 0, 0, 2]])
    >>> print(found.edges["label"], found.edges["length"])
    [2 5] [1. 2.]
    """
    lines = _arrays.label_rows(_arrays.labels(skeletons, "skeletons"))
    options = _arrays.execution(threads)
    units = _arrays.spacing("spacing", spacing)
    distances = None if labels is None else _distances_of(labels, lines.shape, units, options)
    handle = ctypes.c_void_p()
    _library.graph_of_labels(_arrays.numbers(lines), options, ctypes.byref(handle))
    return taken(handle, lines.shape, units, distances, has_labels=True)


def prune_labels(skeletons: npt.ArrayLike, min_length: float = 0, *, min_widths: float = 0,
                 labels: npt.ArrayLike | None = None, spacing: Spacing = 1, removes_components: bool = False,
                 out: npt.NDArray[Any] | None = None, threads: int = 1) -> npt.NDArray[Any]:
    """Remove short branches from many skeletons that share an image, each as if it were alone.

    Parameters
    ----------
    skeletons : array of bool or integers, shape (H, W)
        0 is background; `thin_labels(labels)` makes such an image. Never modified.
    min_length, min_widths, spacing, removes_components, threads
        As for `prune`.
    labels : array of bool or integers, shape (H, W), optional
        What was thinned; needed with `min_widths`.
    out : array, optional
        Receives the result: same shape and dtype as the skeletons, C-contiguous. May be the skeletons.

    Returns
    -------
    array of the shape and dtype of the skeletons

    Examples
    --------
    >>> import thinbench
    >>> print(thinbench.prune_labels([[0, 5, 0, 2], [5, 5, 5, 2]], 1.5))
    [[0 0 0 2]
     [5 5 5 2]]
    """
    image = _arrays.labels(skeletons, "skeletons")
    lines = _arrays.label_rows(image)
    options = _arrays.execution(threads)
    units = _arrays.spacing("spacing", spacing)
    distances = None if labels is None else _distances_of(labels, lines.shape, units, options)
    result = _arrays.result_for(image, out)
    kept = np.empty(lines.shape, np.int32)
    limits, _alive = pruning(min_length, min_widths, removes_components, distances, units, "labels")
    _library.prune_labels(_arrays.numbers(lines), _arrays.numbers(kept), limits, options, None)
    result[...] = kept
    return result


def _distances_of(labels: npt.ArrayLike, shape: tuple[int, ...], spacing: tuple[float, float],
                  options: bytes | None) -> Array:
    objects = _arrays.label_rows(_arrays.labels(labels))
    if objects.shape != shape:
        raise ValueError(f"labels: expected the skeletons' shape {shape}, got {objects.shape}")
    distances = np.empty(objects.shape)
    _library.distances_of_labels(_arrays.numbers(objects), _arrays.numbers(distances), _library.spacing(*spacing),
                                 options)
    return distances
