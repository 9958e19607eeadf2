"""Graphs of skeletons, pruning, classes of pixels."""

from __future__ import annotations

import ctypes
import warnings
from collections.abc import Iterable, Sequence
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _images, _library, _thinning
from thinbench._graph_handles import pruning, split_graph, taken
from thinbench._rules import Rule
from thinbench._skeleton_graph import Graph

PIXEL_CLASSES = ("background", "isolated", "end", "line", "junction")

Spacing = float | Sequence[float]


def skeleton_graph(skeleton: npt.ArrayLike, image: npt.ArrayLike | None = None, *, spacing: Spacing = 1,
                   nodes: Iterable[Sequence[int]] = (), not_thin: Literal["warn", "raise", "ignore"] = "warn",
                   threads: int = 1) -> Graph:
    """Find the nodes of a skeleton and the lines between them.

    Parameters
    ----------
    skeleton : array of bool or uint8, shape (H, W)
        Nonzero is foreground; thin lines, such as `thin` makes.
    image : array of bool or uint8, shape (H, W), optional
        What was thinned, for the widths of edges.
    spacing : float or two floats
        The distance between the centres of neighbouring rows, and of neighbouring columns. Lengths,
        widths and tolerances are in this unit; rows and columns remain numbers of pixels.
    nodes : iterable of (row, column)
        Pixels of lines that become nodes of the kind "given"; they come last. Each splits its edge in two.
    not_thin : str
        What to do about blocks of 2 x 2 foreground pixels: "warn" and "raise" name their number and
        the first. They become junctions.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.

    Returns
    -------
    Graph
        The number of its nodes minus that of its edges is `euler_number(skeleton)`.

    References
    ----------
    docs/graphs.md: the definition of nodes and edges.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> cross = np.array([[0, 1, 0, 0], [1, 1, 1, 1], [0, 1, 0, 0]], bool)
    >>> found = thinbench.skeleton_graph(cross)
    >>> print(found.nodes["kind"], found.edges["length"])
    ['end' 'end' 'junction' 'end' 'end'] [1. 1. 2. 1.]
    """
    array = _arrays.binary(skeleton, name="skeleton")
    options = _arrays.execution(threads)
    lines = _arrays.image(array)
    _check_thin(lines, not_thin)
    units = _arrays.spacing("spacing", spacing)
    distances = None if image is None else _distances_of(image, array.shape, units, threads)
    handle = ctypes.c_void_p()
    _library.skeleton_graph(lines, options, ctypes.byref(handle))
    return taken(split_graph(handle, nodes), array.shape, units, distances)


def prune(skeleton: npt.ArrayLike, min_length: float = 0, *, min_widths: float = 0,
          image: npt.ArrayLike | None = None, spacing: Spacing = 1, removes_components: bool = False,
          out: npt.NDArray[Any] | None = None, threads: int = 1) -> npt.NDArray[Any]:
    """Remove short branches from a skeleton.

    A branch is a line from an end to a junction. Each round removes the shortest of the short
    branches of every junction, until none is left. Holes remain.

    Parameters
    ----------
    skeleton : array of bool or uint8, shape (H, W)
        Nonzero is foreground. Never modified.
    min_length : float
        Branches below it are removed. Diagonal steps count the square root of 2.
    min_widths : float
        So are branches below this many times the width of `image` at their junction, which is twice
        the distance to the background.
    image : array of bool or uint8, shape (H, W), optional
        What was thinned; needed with `min_widths`.
    spacing : float or two floats
        The distance between rows, and between columns, in whose unit `min_length` is.
    removes_components : bool
        Also remove lines and pixels on their own that are shorter than `min_length`.
    out : array, optional
        Receives the result: same shape and dtype as the skeleton, C-contiguous. May be the skeleton.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.

    Returns
    -------
    array of the shape and dtype of the skeleton

    References
    ----------
    docs/graphs.md: the definition of branches.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> line = np.zeros((3, 9), bool)
    >>> line[2, :] = line[1, 4] = True
    >>> print(thinbench.prune(line, 2).astype(int)[1])
    [0 0 0 0 0 0 0 0 0]
    """
    array = _arrays.binary(skeleton, name="skeleton")
    options = _arrays.execution(threads)
    units = _arrays.spacing("spacing", spacing)
    distances = None if image is None else _distances_of(image, array.shape, units, threads)
    limits, _alive = pruning(min_length, min_widths, removes_components, distances, units, "image")
    result = _arrays.result_for(array, out)
    _library.prune(*_arrays.images(array, result), limits, options, None)
    return result


def medial_axis(image: npt.ArrayLike, rule: str | Rule = "guo_hall", *, spacing: Spacing = 1,
                threads: int = 1) -> tuple[npt.NDArray[Any], npt.NDArray[np.float64]]:
    """Thin an image, and say at each pixel of the skeleton how far the background is.

    The skeleton is that of `thin`, not the one of scikit-image's function of this name, which has other
    pixels; the distances are exact.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W)
        Nonzero is foreground. At most 32767 pixels on a side.
    rule : str or Rule
        As for `thin`.
    spacing, threads
        As for `distances`.

    Returns
    -------
    skeleton : array of the shape and dtype of the image
    distances : array of float64, shape (H, W)
        0 outside the skeleton.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> bar = np.zeros((5, 9), bool)
    >>> bar[1:4, 1:8] = True
    >>> skeleton, distances = thinbench.medial_axis(bar)
    >>> print(distances[2])
    [0. 0. 2. 2. 2. 2. 2. 0. 0.]
    """
    skeleton = _thinning.thin(image, rule, threads=threads, stack=False)
    distances = _images.distances(image, spacing=spacing, threads=threads)
    distances[skeleton == 0] = 0
    return skeleton, distances


def classify_pixels(image: npt.ArrayLike) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.uint8]]:
    """Say what each pixel of a skeleton is, and to how many neighbours it is joined.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W)
        Nonzero is foreground.

    Returns
    -------
    classes : array of uint8, shape (H, W)
        Positions in `PIXEL_CLASSES`: "background", "isolated", "end", "line", "junction".
    degrees : array of uint8, shape (H, W)
        0 to 4; 0 on background.

    References
    ----------
    docs/graphs.md: the definition.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> classes, degrees = thinbench.classify_pixels(np.array([[1, 0, 1, 1, 1]], bool))
    >>> print(classes, degrees)
    [[1 0 2 3 2]] [[0 0 1 2 1]]
    """
    array = _arrays.binary(image)
    classes, degrees = np.empty(array.shape, np.uint8), np.empty(array.shape, np.uint8)
    _library.classify_pixels(_arrays.image(array), _arrays.image(classes), _arrays.image(degrees), None)
    return classes, degrees


def _check_thin(lines: bytes, not_thin: str) -> None:
    if not_thin not in ("warn", "raise", "ignore"):
        raise ValueError(f"not_thin: expected 'warn', 'raise' or 'ignore', got {not_thin!r}")
    count, first = ctypes.c_int64(), (ctypes.c_int32 * 2)()
    if not_thin == "ignore":
        return
    _library.full_blocks(lines, None, ctypes.byref(count), first)
    if count.value == 0:
        return
    blocks = "block of 2 x 2 pixels" if count.value == 1 else "blocks of 2 x 2 pixels, the first"
    message = f"skeleton: not thin: {count.value} {blocks} at row {first[1]}, column {first[0]}"
    if not_thin == "raise":
        raise ValueError(message)
    warnings.warn(message, stacklevel=3)


def _distances_of(image: npt.ArrayLike, shape: tuple[int, ...], spacing: tuple[float, float],
                  threads: int) -> npt.NDArray[np.float64]:
    distances = _images.distances(image, spacing=spacing, threads=threads)
    if distances.shape != shape:
        raise ValueError(f"image: expected the skeleton's shape {shape}, got {distances.shape}")
    return distances
