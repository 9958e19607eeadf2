"""Graphs of skeletons, pruning, classes of pixels."""

from __future__ import annotations

import ctypes
import math
import struct
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _images, _library

KINDS = np.array(["isolated", "end", "junction", "cycle"])
PIXEL_CLASSES = ("background", "isolated", "end", "line", "junction")
_PIXEL = np.dtype([("x", "i4"), ("y", "i4")])
_NODE = np.dtype([("kind", "i4"), ("first_pixel", "u4"), ("pixel_count", "u4")])
_EDGE = np.dtype([("from", "u4"), ("to", "u4"), ("start", _PIXEL), ("stop", _PIXEL), ("first_pixel", "u4"),
                  ("pixel_count", "u4"), ("straight_steps", "u4"), ("diagonal_steps", "u4")])
_PRUNING = struct.Struct("NddPni4x")

Array = npt.NDArray[Any]
Columns = dict[str, Array]


@dataclass(frozen=True, eq=False, repr=False)
class Graph:
    """A skeleton as nodes and the lines between them.

    Two pixels are joined if they are 4-neighbours, or diagonal neighbours without a common
    4-neighbour in the skeleton. A pixel with one joined neighbour is an end, with none isolated,
    with three or four part of a junction, as is every pixel of a block of 2 x 2. Joined junction
    pixels are one node. A closed line without junctions has a node of one pixel.

    Attributes
    ----------
    nodes : dict of arrays, one element per node
        "kind": "isolated", "end", "junction" or "cycle"; "row" and "column" of the centre of its
        pixels; "degree": how many ends of edges it has.
    edges : dict of arrays, one element per edge
        "from" and "to": numbers of nodes; "length": steps along rows and columns count 1, diagonal
        ones the square root of 2; "chord": the distance between its ends; with an image also
        "width-mean", "width-min" and "width-max", twice the distance to the background. A loop
        within a junction, round a hole that its pixels enclose, has length 0.
    """

    nodes: Columns
    edges: Columns
    _node_pixels: list[Array]
    _edge_pixels: list[Array]

    def __repr__(self) -> str:
        kinds, counts = np.unique(self.nodes["kind"], return_counts=True)
        of = ", ".join(f"{count} {kind}" for kind, count in zip(kinds, counts))
        length = float(self.edges["length"].sum())
        return (f"Graph({len(self.nodes['kind'])} nodes{f' ({of})' if of else ''}, "
                f"{len(self.edges['length'])} edges of length {length:.1f})")

    def plot(self, ax: Any = None) -> Any:
        """Draws edges as lines and nodes as points in a matplotlib Axes, the current one by default; returns it.

        Columns run to the right and rows down, as `imshow` draws the image.
        """
        if ax is None:
            from matplotlib import pyplot  # type: ignore[import]

            ax = pyplot.gca()
        for chain in self._edge_pixels:
            ax.plot(chain[:, 1], chain[:, 0], "-", color="tab:orange", linewidth=1)
        for kind, colour in zip(KINDS, ("tab:gray", "tab:green", "tab:blue", "tab:purple")):
            chosen = self.nodes["kind"] == kind
            if chosen.any():
                ax.plot(self.nodes["column"][chosen], self.nodes["row"][chosen], ".", color=colour, label=str(kind))
        ax.set_aspect("equal")
        if ax.get_ylim()[0] < ax.get_ylim()[1]:
            ax.invert_yaxis()
        return ax

    def node_pixels(self, node: int) -> Array:
        """Rows and columns of the pixels of a node: an array of int32, shape (N, 2)."""
        return self._node_pixels[node]

    def edge_pixels(self, edge: int) -> Array:
        """Rows and columns along an edge, from a pixel of one node to one of the other: shape (N, 2)."""
        return self._edge_pixels[edge]

    def polylines(self, tolerance: float = 1) -> list[Array]:
        """Rows and columns of the points of each edge that are needed so that none of its pixels is farther
        than `tolerance` from the line through them (Douglas and Peucker 1973): arrays of shape (N, 2)."""
        return [_polyline(chain, tolerance) for chain in self._edge_pixels]

    def to_geojson(self, tolerance: float = 1, transform: Sequence[float] = (1, 0, 0, 0, 1, 0)) -> dict[str, Any]:
        """What `thinbench graph --geojson` writes: a Point for each node, a LineString for each edge.

        `transform` is (a, b, c, d, e, f) of x' = a x + b y + c, y' = d x + e y + f. The centre of the
        first pixel is at x = 0.5, y = 0.5. Ids count from 1. A width without background is None.
        """
        a, b, c, d, e, f = _finite("transform", transform)

        def position(row: float, column: float) -> list[float]:
            x, y = float(column) + 0.5, float(row) + 0.5
            return _finite("transform", [a * x + b * y + c, d * x + e * y + f], 2)

        def feature(kind: str, coordinates: Any, properties: dict[str, Any]) -> dict[str, Any]:
            return {"type": "Feature", "geometry": {"type": kind, "coordinates": coordinates}, "properties": properties}

        nodes, edges = self.nodes, self.edges
        widths = {name: name.replace("-", "_") for name in edges if name.startswith("width-")}
        features = []
        for i in range(len(nodes["kind"])):
            properties = {"id": i + 1, "kind": str(nodes["kind"][i]), "degree": int(nodes["degree"][i])}
            features.append(feature("Point", position(nodes["row"][i], nodes["column"][i]), properties))
        for i, line in enumerate(self.polylines(tolerance)):
            properties = {"id": i + 1, "from": int(edges["from"][i]) + 1, "to": int(edges["to"][i]) + 1,
                          "pixels": len(self._edge_pixels[i]) - 2,
                          "length": float(edges["length"][i]), "chord": float(edges["chord"][i])}
            for column, name in widths.items():
                width = float(edges[column][i])
                properties[name] = width if math.isfinite(width) else None
            features.append(feature("LineString", [position(*point) for point in line], properties))
        return {"type": "FeatureCollection", "features": features}

    def to_networkx(self) -> Any:
        """A networkx.MultiGraph with the columns as attributes of nodes and edges, and "pixels" of edges."""
        import networkx  # type: ignore[import]

        graph = networkx.MultiGraph()
        for node in range(len(self.nodes["kind"])):
            graph.add_node(node, **{name: column[node].item() for name, column in self.nodes.items()})
        for edge in range(len(self.edges["from"])):
            values = {name: column[edge].item() for name, column in self.edges.items()}
            graph.add_edge(values.pop("from"), values.pop("to"), pixels=self._edge_pixels[edge], **values)
        return graph

    def to_csgraph(self, weight: str = "length") -> Any:
        """A symmetric scipy.sparse.csr_matrix of a column of the edges, for scipy.sparse.csgraph.

        Of parallel edges the one with the least weight remains; loops are left out.
        """
        from scipy import sparse  # type: ignore[import]

        ends = np.sort(np.stack([self.edges["from"], self.edges["to"]]), axis=0)
        order = np.lexsort((self.edges[weight], ends[1], ends[0]))
        order = order[ends[0, order] != ends[1, order]]
        first = np.ones(len(order), bool)
        first[1:] = (np.diff(ends[:, order]) != 0).any(axis=0)
        order = order[first]
        one, other = ends[:, order].astype(np.int64)
        weights = np.tile(self.edges[weight][order], 2)
        places = np.concatenate([one, other]), np.concatenate([other, one])
        count = len(self.nodes["kind"])
        return sparse.coo_matrix((weights, places), (count, count)).tocsr()


def graph(skeleton: npt.ArrayLike, image: npt.ArrayLike | None = None, *,
          not_thin: Literal["warn", "raise", "ignore"] = "warn", threads: int = 1) -> Graph:
    """Find the nodes of a skeleton and the lines between them.

    Parameters
    ----------
    skeleton : array of bool or uint8, shape (H, W)
        Nonzero is foreground; thin lines, such as `thin` makes.
    image : array of bool or uint8, shape (H, W), optional
        What was thinned, for the widths of edges.
    not_thin : str
        What to do about blocks of 2 x 2 foreground pixels: "warn" and "raise" name their number and
        the first. They become junctions.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.

    Returns
    -------
    Graph
        The number of its nodes minus that of its edges is `euler_number(skeleton)`.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit.

    References
    ----------
    docs/graphs.md: the definition of nodes and edges.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> cross = np.array([[0, 1, 0, 0], [1, 1, 1, 1], [0, 1, 0, 0]], bool)
    >>> found = thinbench.graph(cross)
    >>> print(found.nodes["kind"], found.edges["length"])
    ['end' 'end' 'junction' 'end' 'end'] [1. 1. 2. 1.]
    """
    array = _arrays.binary(skeleton, name="skeleton")
    options = _library.execution(_arrays.integer("threads", threads))
    stack, kept_alive = _arrays.source(array)
    _check_thin(stack, not_thin)
    handle = ctypes.c_void_p()
    _library.skeleton_graph(stack, options, ctypes.byref(handle))
    del kept_alive
    return _taken(handle, None if image is None else _squares_of(image, array.shape, threads))


def prune(skeleton: npt.ArrayLike, min_length: float = 0, *, min_widths: float = 0,
          image: npt.ArrayLike | None = None, remove_components: bool = False,
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
    remove_components : bool
        Also remove lines and pixels on their own that are shorter than `min_length`.
    out : array, optional
        Receives the result: same shape and dtype as the skeleton, C-contiguous. May be the skeleton.
    threads : int
        The maximum number of threads. An image below 2**20 pixels uses one.

    Returns
    -------
    array of the shape and dtype of the skeleton

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit; then nothing is written.

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
    options = _library.execution(_arrays.integer("threads", threads))
    widths = _arrays.real("min_widths", min_widths)
    if image is None and widths > 0:
        raise ValueError(f"min_widths: expected image=..., what was thinned, beside it, got {widths:g} without")
    squares = None if image is None else _squares_of(image, array.shape, threads)
    pruning = _PRUNING.pack(_PRUNING.size, _arrays.real("min_length", min_length),
                            widths, 0 if squares is None else squares.ctypes.data,
                            array.shape[1], bool(remove_components))
    result = _arrays.result_for(array, out)
    stack, kept_alive = _arrays.source(array)
    _library.prune(stack, _arrays.destination(result), pruning, options, None)
    del kept_alive
    return result


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

    Raises
    ------
    TypeError, ValueError
        If the image does not fit.

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
    stack, kept_alive = _arrays.source(array)
    classes, degrees = np.empty(array.shape, np.uint8), np.empty(array.shape, np.uint8)
    stride = array.shape[1]
    _library.classify_pixels(stack, classes.ctypes.data, stride, degrees.ctypes.data, stride)
    del kept_alive
    return classes, degrees


def _check_thin(stack: bytes, not_thin: str) -> None:
    if not_thin not in ("warn", "raise", "ignore"):
        raise ValueError(f"not_thin: expected 'warn', 'raise' or 'ignore', got {not_thin!r}")
    count, first = ctypes.c_int64(), (ctypes.c_int32 * 2)()
    if not_thin == "ignore":
        return
    _library.full_blocks(stack, ctypes.byref(count), first)
    if count.value == 0:
        return
    blocks = "block of 2 x 2 pixels" if count.value == 1 else "blocks of 2 x 2 pixels, the first"
    message = f"skeleton: not thin: {count.value} {blocks} at row {first[1]}, column {first[0]}"
    if not_thin == "raise":
        raise ValueError(message)
    warnings.warn(message, stacklevel=3)


def _finite(name: str, numbers: Sequence[float], count: int = 6) -> list[float]:
    found = [_arrays.real(name, number) for number in numbers]
    for number in found:
        if not math.isfinite(number):
            raise ValueError(f"{name}: expected finite numbers, got {number}")
    if len(found) != count:
        raise ValueError(f"{name}: expected {count} numbers, got {len(found)}")
    return found


def _polyline(chain: Array, tolerance: float) -> Array:
    """The distances do not depend on the order of the two columns."""
    kept = np.empty(chain.shape, np.int32)
    points = np.ascontiguousarray(chain, np.int32)
    count = ctypes.c_size_t()
    _library.polyline(points.ctypes.data, len(points), _arrays.real("tolerance", tolerance), kept.ctypes.data, ctypes.byref(count))
    return kept[:count.value].copy()


def _squares_of(image: npt.ArrayLike, shape: tuple[int, ...], threads: int) -> npt.NDArray[np.int32]:
    squares = _images.distance(image, squared=True, threads=threads)
    if squares.shape != shape:
        raise ValueError(f"image: expected the skeleton's shape {shape}, got {squares.shape}")
    return squares


def _taken(handle: ctypes.c_void_p, squares: npt.NDArray[np.int32] | None) -> Graph:
    """The graph of a handle, which is destroyed."""
    try:
        nodes, edges, node_pixels, edge_pixels = (
            _copied(handle, list_of, dtype) for list_of, dtype in (
                (_library.graph_nodes, _NODE), (_library.graph_edges, _EDGE),
                (_library.graph_node_pixels, _PIXEL), (_library.graph_edge_pixels, _PIXEL)))
        widths = {} if squares is None else _width_columns(handle, squares, len(edges))
    finally:
        _library.graph_destroy(handle)
    pixels_of_nodes = np.split(_rows_and_columns(node_pixels), nodes["first_pixel"][1:])
    lines = np.split(_rows_and_columns(edge_pixels), edges["first_pixel"][1:])
    starts, stops = _rows_and_columns(edges["start"]), _rows_and_columns(edges["stop"])
    chains = [np.concatenate([starts[i:i + 1], lines[i], stops[i:i + 1]]) for i in range(len(edges))]
    return Graph(_node_columns(nodes, edges, pixels_of_nodes), {**_edge_columns(edges), **widths},
                 pixels_of_nodes[:len(nodes)], chains)


def _copied(handle: ctypes.c_void_p, list_of: Any, dtype: np.dtype[Any]) -> Array:
    count = ctypes.c_size_t()
    address = list_of(handle, ctypes.byref(count), dtype.itemsize)
    copy = np.empty(count.value, dtype)
    if count.value:
        ctypes.memmove(copy.ctypes.data, address, copy.nbytes)
    return copy


def _rows_and_columns(pixels: Array) -> Array:
    return np.stack([pixels["y"], pixels["x"]], axis=-1)


def _node_columns(nodes: Array, edges: Array, pixels: list[Array]) -> Columns:
    centres = np.array([group.mean(axis=0) for group in pixels[:len(nodes)]]).reshape(-1, 2)
    degree = np.bincount(edges["from"], minlength=len(nodes)) + np.bincount(edges["to"], minlength=len(nodes))
    return {"kind": KINDS[nodes["kind"]], "row": centres[:, 0], "column": centres[:, 1], "degree": degree}


def _edge_columns(edges: Array) -> Columns:
    difference = _rows_and_columns(edges["stop"]) - _rows_and_columns(edges["start"])
    return {"from": edges["from"].astype(np.int64), "to": edges["to"].astype(np.int64),
            "length": edges["straight_steps"] + edges["diagonal_steps"] * np.sqrt(2),
            "chord": np.hypot(difference[:, 0], difference[:, 1])}


def _width_columns(handle: ctypes.c_void_p, squares: npt.NDArray[np.int32], count: int) -> Columns:
    widths = np.empty((count, 3))
    height, width = squares.shape
    _library.graph_edge_widths(handle, squares.ctypes.data, height, width, width, widths.ctypes.data)
    return {"width-" + name: widths[:, i] for i, name in enumerate(("mean", "min", "max"))}
