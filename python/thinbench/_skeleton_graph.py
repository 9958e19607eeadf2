"""The graph of a skeleton as arrays: nodes, edges and their pixels."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library, _network

KINDS = np.array(["isolated", "end", "junction", "cycle", "given"])
Array = npt.NDArray[Any]
Columns = dict[str, Array]


class Groups(NamedTuple):
    """Arrays of any length, one after another: number i is `values[bounds[i]:bounds[i + 1]]`."""

    values: Array
    bounds: Array

    def of(self, i: int) -> Array:
        return self.values[self.bounds[i]:self.bounds[i + 1]]

    def lengths(self) -> Array:
        return np.diff(self.bounds)

    def chosen(self, numbers: Array) -> Groups:
        lengths = self.lengths()[numbers]
        bounds = bounds_of(lengths)
        places = np.repeat(self.bounds[:-1][numbers] - bounds[:-1], lengths) + np.arange(bounds[-1])
        return Groups(self.values[places], bounds)

    def reduced(self, function: Any, values: Array) -> Array:
        """A ufunc over the values of each group, of which none is empty."""
        found: Array = function.reduceat(values, self.bounds[:-1]) if len(self.bounds) > 1 else values[:0]
        return found


def bounds_of(lengths: Array) -> Array:
    bounds = np.zeros(len(lengths) + 1, np.int64)
    np.cumsum(lengths, out=bounds[1:])
    return bounds


class GraphPath(NamedTuple):
    """From node to node by edges, whose numbers are positions in the columns of a graph.

    `points` are the rows and columns along the edges. In a node of several pixels they go straight from
    one edge to the next, which adds nothing to the length.

    A main path may begin or end at a pixel of an edge instead. Then only a part of the first edge is on it,
    from point `first_point` of `edge_points(edges[0])` to the first node, or of the last edge, from the last node
    to point `last_point` of `edge_points(edges[-1])`. Both are None at nodes. A path within one edge has no nodes.
    """

    length: float
    nodes: Array
    edges: Array
    points: Array
    first_point: int | None
    last_point: int | None


class GraphPlace(NamedTuple):
    """A pixel of an edge, and how far it is from where it was looked for."""

    edge: int
    row: int
    column: int
    distance: float


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
        "kind": "isolated", "end", "junction" or "cycle", or "given" if the caller asked for it; "row"
        and "column" of the centre of its pixels; "degree": how many ends of edges it has; "component":
        the number of its component; with an image also "width", the greatest of its pixels.
    edges : dict of arrays, one element per edge
        "from" and "to": numbers of nodes; "length": the steps from pixel to pixel; "chord": the
        distance between its ends; with an image also "width-mean", "width-median", "width-min" and
        "width-max" of twice the distance to the background. A loop within a junction, round a hole that
        its pixels enclose, has length 0. Of `graph_of_labels` also "label", as for nodes.
    spacing : two floats
        The distance between rows and that between columns, in whose unit lengths and widths are.
    shape : two integers
        The rows and columns of the skeleton.
    """

    nodes: Columns
    edges: Columns
    spacing: tuple[float, float]
    shape: tuple[int, ...]
    _nodes: Groups  # rows and columns of their pixels
    _chains: Groups  # those along the edges, with both ends
    _table: Array  # the edges of the library, whose nodes and first pixels may be those of another graph
    _distances: Array | None  # of the image that was thinned

    def __repr__(self) -> str:
        kinds, counts = np.unique(self.nodes["kind"], return_counts=True)
        of = ", ".join(f"{count} {kind}" for kind, count in zip(kinds, counts))
        length = float(self.edges["length"].sum())
        return (f"Graph({_arrays.counted(len(self.nodes['kind']), 'node')}{f' ({of})' if of else ''}, "
                f"{_arrays.counted(len(self.edges['length']), 'edge')} of length {length:.1f})")

    def plot(self, ax: Any = None) -> Any:
        """Draws edges as lines and nodes as points in a matplotlib Axes, the current one by default; returns it.

        Columns run to the right and rows down, as `imshow` draws the image.
        """
        if ax is None:
            from matplotlib import pyplot  # type: ignore[import]

            ax = pyplot.gca()
        for i in range(len(self.edges["from"])):
            chain = self.edge_points(i)
            ax.plot(chain[:, 1], chain[:, 0], "-", color="tab:orange", linewidth=1)
        for kind, colour in zip(KINDS, ("tab:gray", "tab:green", "tab:blue", "tab:purple", "tab:red")):
            chosen = self.nodes["kind"] == kind
            if chosen.any():
                ax.plot(self.nodes["column"][chosen], self.nodes["row"][chosen], ".", color=colour, label=str(kind))
        ax.set_aspect("equal")
        if ax.get_ylim()[0] < ax.get_ylim()[1]:
            ax.invert_yaxis()
        return ax

    def node_pixels(self, node: int) -> Array:
        """Rows and columns of the pixels of a node: an array of int32, shape (N, 2)."""
        return self._nodes.of(self._node("node", node))

    def edge_points(self, edge: int) -> Array:
        """Rows and columns along an edge, from a pixel of one node to one of the other: shape (N, 2)."""
        return self._chains.of(_arrays.number_below(len(self.edges["from"]), "edge", edge))

    def _node(self, name: str, number: Any) -> int:
        return _arrays.number_below(len(self.nodes["kind"]), name, number)

    def edge_widths(self, edge: int) -> Array:
        """The width at each of `edge_points(edge)`. The graph must know its image."""
        return self._widths("edge_widths", self.edge_points(edge))

    def path_widths(self, path: GraphPath) -> Array:
        """The width at each of `path.points`. The graph must know its image."""
        return self._widths("path_widths", path.points)

    def _widths(self, name: str, pixels: Array) -> Array:
        if self._distances is None:
            raise ValueError(f"{name}: expected a skeleton_graph(skeleton, image), whose image gives the widths")
        widths: Array = 2 * self._distances[tuple(pixels.T)]
        return widths

    def edge_labels(self) -> Array:
        """The number of its edge, from 1, at each pixel of an edge: an array of int32 of the shape of the skeleton.

        A node with one edge belongs to it, such as an end or the first pixel of a closed line. Where edges
        meet and elsewhere it is 0.
        """
        first, last = self.edges["from"], self.edges["to"]
        count = len(self.nodes["kind"])
        numbers = np.arange(1, len(first) + 1, dtype=np.int32)
        of_nodes = np.zeros(count, np.int32)
        of_nodes[first] = of_nodes[last] = numbers
        of_nodes[np.bincount(first, minlength=count) + np.bincount(last[last != first], minlength=count) > 1] = 0
        labels = np.zeros(self.shape, np.int32)
        labels[tuple(self._chains.values.T)] = np.repeat(numbers, self._chains.lengths())
        labels[tuple(self._nodes.values.T)] = np.repeat(of_nodes, self._nodes.lengths())
        return labels

    def polylines(self, tolerance: float | None = None) -> list[Array]:
        """Rows and columns of the points of each edge that are needed so that none of its pixels is farther
        than `tolerance` from the line through them (Douglas and Peucker 1973): arrays of shape (N, 2).

        The tolerance is in the unit of the spacing; by default it is the larger side of a pixel."""
        most = max(self.spacing) if tolerance is None else _arrays.real("tolerance", tolerance)
        return [self._polyline(self.edge_points(i), most) for i in range(len(self.edges["from"]))]

    def _polyline(self, chain: Array, tolerance: float) -> Array:
        points = np.ascontiguousarray(chain[:, ::-1], np.int32)
        kept = np.empty(chain.shape, np.int32)
        count = ctypes.c_size_t()
        _library.polyline(points.ctypes.data, len(points), tolerance, _library.spacing(*self.spacing),
                          kept.ctypes.data, ctypes.byref(count))
        return kept[:count.value, ::-1].copy()

    def smoothed_lengths(self, tolerance: float | None = None) -> Array:
        """The length of each of `polylines(tolerance)`, which is less than that of the steps where a line runs
        between the directions of rows, columns and diagonals."""
        return self._lengths(self.polylines(tolerance))

    def _lengths(self, lines: list[Array]) -> Array:
        bounds = bounds_of(np.array([len(line) for line in lines], np.int64))
        points = np.concatenate([*lines, np.empty((0, 2), np.int32)])
        steps = np.diff(points, axis=0, prepend=points[:1]) * self.spacing
        lengths = np.hypot(steps[:, 0], steps[:, 1])
        lengths[bounds[:-1]] = 0
        of_lines = np.repeat(np.arange(len(lines)), np.diff(bounds))
        return np.bincount(of_lines, lengths, len(lines))  # sums in their order, as the program does

    def main_paths(self) -> list[GraphPath]:
        """The longest of the shortest paths between two nodes or pixels of edges, of each component.

        Of paths that are equally long, the one with the lowest first point, then with the lowest last one: the
        nodes, then the pixels of the edges in their order. Exact for graphs with cycles, too, whose paths may
        begin and end within an edge. A component without edges has a path of one pixel.
        """
        table = self._table.copy()
        table["from"], table["to"] = self.edges["from"], self.edges["to"]
        table["first_pixel"] = self._chains.bounds[:-1] + 1
        pixels = np.ascontiguousarray(self._chains.values[:, ::-1])
        found = _network.main_paths(len(self.nodes["kind"]), table, pixels, self.spacing)
        return [self._path(*path) for path in found]

    def main_path(self) -> GraphPath:
        """The longest of `main_paths()`, of equal ones the first."""
        paths = self.main_paths()
        if not paths:
            raise ValueError("main_path: expected a graph with nodes, got none")
        return max(paths, key=lambda path: path.length)

    def shortest_path(self, from_node: int, to_node: int) -> GraphPath:
        """Between two nodes; its points are those along the way. ValueError if there is none."""
        found = _network.shortest_path(*self._links(), self._node("from_node", from_node),
                                       self._node("to_node", to_node))
        if not found:
            raise ValueError(f"no path leads from node {from_node} to node {to_node}")
        return self._path(*found[0])

    def cycles(self) -> list[GraphPath]:
        """Cycles of which every other is a combination; their number is edges - nodes + components.

        Each is closed by an edge that is not in the minimum spanning forest, the longest of its edges and the
        last: it leads back to the first node. The points end with the first one.
        """
        return [_closed(self._path(*path)) for path in _network.cycles(*self._links())]

    def open_cycles(self, max_length: float = math.inf) -> Graph:
        """The graph without the closing edges of `cycles()` that are at most so long: without their
        longest edges, of equally long ones the last."""
        longest = _arrays.real("max_length", max_length)
        if not longest >= 0:
            raise ValueError(f"max_length: expected a number of at least 0, got {longest:g}")
        keep = np.ones(len(self.edges["from"]), bool)
        for length, _, edges, *_ in _network.cycles(*self._links()):
            keep[edges[-1]] = length > longest
        return self._with_edges(np.flatnonzero(keep), np.arange(len(self.nodes["kind"])))

    def subgraph(self, edges: npt.ArrayLike) -> Graph:
        """Of some edges, by their numbers or by a bool for each, and of their nodes.

        Numbers of nodes, degrees and components are those of the subgraph; kinds remain.
        """
        chosen = _edge_numbers(edges, len(self.edges["from"]))
        used = np.unique(np.concatenate([self.edges["from"][chosen], self.edges["to"][chosen]]))
        return self._with_edges(chosen, used)

    def nearest(self, row: float, column: float) -> GraphPlace:
        """The pixel of an edge that is nearest to a point, the first with the least distance."""
        if len(self._chains.values) == 0:
            raise ValueError("nearest: expected a graph with edges, got none")
        point = _arrays.real("row", row), _arrays.real("column", column)
        if not all(map(math.isfinite, point)):
            raise ValueError(f"nearest: expected a finite point, got {point[0]:g}, {point[1]:g}")
        with np.errstate(over="ignore"):  # beyond all numbers is infinity
            distances = np.hypot(*((self._chains.values - point) * self.spacing).T)
        at = int(distances.argmin())
        edge = int(np.searchsorted(self._chains.bounds, at, side="right")) - 1
        place = self._chains.values[at]
        return GraphPlace(edge, int(place[0]), int(place[1]), float(distances[at]))

    def parents(self, root: int) -> Array:
        """For each node the next one on the way to node `root`, as in SWC files; -1 for the root itself and in
        other components. ValueError if the component has cycles, of which `open_cycles()` has none."""
        number, count = self._node("root", root), len(self.nodes["kind"])
        is_in = self.nodes["component"] == self.nodes["component"][number]
        cycles = int(is_in[self.edges["from"]].sum() - is_in.sum()) + 1
        if cycles > 0:
            raise ValueError(f"root: expected a node of a tree, got {number} in a component with "
                             f"{_arrays.counted(cycles, 'cycle')}; open_cycles() opens them")
        ends = np.concatenate([self.edges["from"], self.edges["to"]])
        others = np.concatenate([self.edges["to"], self.edges["from"]])
        neighbours = Groups(others[np.argsort(ends)], bounds_of(np.bincount(ends, minlength=count)))
        parents = np.full(count, -1)
        to_visit = [number]
        while to_visit:
            node = to_visit.pop()
            children = neighbours.of(node)
            children = children[children != parents[node]]
            parents[children] = node
            to_visit += children.tolist()
        return parents

    def summary(self, separator: str = "-", *, image: npt.ArrayLike | None = None,
                tolerance: float | None = None) -> Columns:
        """A table of the edges with the column names of skan's `summarize`, as a dict of arrays.

        "branch-type" is 0 between ends, 1 between an end and a junction, 2 between junctions, 3 for a
        closed line. "tortuosity" is the length by the distance between the ends, NaN where these are one
        place. With an image, "mean-pixel-value" and "stdev-pixel-value" are those of its values along each
        edge, both ends included. "smoothed-length" are the `smoothed_lengths(tolerance)`.
        `pandas.DataFrame(graph.summary())` is the table that scripts expect.
        """
        nodes, edges = self.nodes, self.edges
        sides = [("src", edges["from"], self._chains.bounds[:-1]), ("dst", edges["to"], self._chains.bounds[1:] - 1)]
        table: Columns = {"skeleton-id": nodes["component"][edges["from"]]}
        table.update({"node-id-" + side: node.copy() for side, node, _ in sides})
        table["branch-distance"] = edges["length"].copy()
        table["branch-type"] = self._branch_types()
        if image is not None:
            table["mean-pixel-value"], table["stdev-pixel-value"] = self._means_and_deviations(
                _arrays.as_array("image", image, float))
        places = {side: self._chains.values[at] for side, _, at in sides}
        for prefix, unit in (("image-coord", (1, 1)), ("coord", self.spacing)):
            for side, pixels in places.items():
                table.update({f"{prefix}-{side}-{axis}": pixels[:, axis] * unit[axis] for axis in (0, 1)})
        table["euclidean-distance"] = edges["chord"].copy()
        with np.errstate(invalid="ignore", divide="ignore"):
            table["tortuosity"] = np.where(edges["chord"] > 0, edges["length"] / edges["chord"], np.nan)
        table["smoothed-length"] = self.smoothed_lengths(tolerance)
        table.update({name: edges[name].copy() for name in edges if name.startswith("width-") or name == "label"})
        return {name.replace("-", _arrays.text("separator", separator)): column for name, column in table.items()}

    def _means_and_deviations(self, image: Array) -> tuple[Array, Array]:
        """Of its values along each edge."""
        if image.shape != self.shape:
            raise ValueError(f"image: expected the skeleton's shape {self.shape}, got {image.shape}")
        lengths = self._chains.lengths()
        values = image[tuple(self._chains.values.T)]
        means = self._chains.reduced(np.add, values) / lengths
        squares = (values - np.repeat(means, lengths)) ** 2
        return means, np.sqrt(self._chains.reduced(np.add, squares) / lengths)

    def _branch_types(self) -> Array:
        first, last = (self.nodes["kind"][self.edges[side]] for side in ("from", "to"))
        ends = (first == "end").astype(int) + (last == "end")
        return np.where(first == "cycle", 3, 2 - ends)

    def to_geojson(self, tolerance: float | None = None, transform: Sequence[float] | None = None) -> dict[str, Any]:
        """What `thinbench graph --geojson` writes: a Point for each node, a LineString for each edge.

        The lines are `polylines(tolerance)`.
        `transform` is (a, b, c, d, e, f) of x' = a x + b y + c, y' = d x + e y + f, by default that of the
        spacing, which is written x first. The centre of the first pixel is at x = 0.5, y = 0.5.
        Ids count from 1: those of features go on from the nodes to the edges, those in properties do not.
        A width without background is None.
        """
        spaced = (self.spacing[1], 0, 0, 0, self.spacing[0], 0)
        a, b, c, d, e, f = _finite("transform", spaced if transform is None else transform)

        def position(row: float, column: float) -> list[float]:
            x, y = float(column) + 0.5, float(row) + 0.5
            return _finite("transform", [a * x + b * y + c, d * x + e * y + f], 2)

        nodes, edges = self.nodes, self.edges
        widths = {name: name.replace("-", "_") for name in edges if name.startswith("width-")}
        features: list[dict[str, Any]] = []

        def add(kind: str, coordinates: Any, properties: dict[str, Any]) -> None:
            features.append({"type": "Feature", "id": len(features) + 1,
                             "geometry": {"type": kind, "coordinates": coordinates}, "properties": properties})

        for i in range(len(nodes["kind"])):
            properties = {"id": i + 1, "kind": str(nodes["kind"][i]), "degree": int(nodes["degree"][i]),
                          **_label(nodes, i)}
            add("Point", position(nodes["row"][i], nodes["column"][i]), properties)
        lines = self.polylines(tolerance)
        smoothed_lengths = self._lengths(lines)
        for i, line in enumerate(lines):
            properties = {"id": i + 1, "kind": "edge", "from": int(edges["from"][i]) + 1, "to": int(edges["to"][i]) + 1,
                          "pixels": len(self.edge_points(i)) - 2, "length": float(edges["length"][i]),
                          "smoothed_length": float(smoothed_lengths[i]), "chord": float(edges["chord"][i])}
            for column, name in widths.items():
                width = float(edges[column][i])
                properties[name] = width if math.isfinite(width) else None
            properties |= _label(edges, i)
            add("LineString", [position(*point) for point in line], properties)
        return {"type": "FeatureCollection", "spacing": list(self.spacing[::-1]), "unit": None, "features": features}

    def to_networkx(self) -> Any:
        """A networkx.MultiGraph with the columns as attributes of nodes and edges, and "points" of edges."""
        import networkx  # type: ignore[import]

        graph = networkx.MultiGraph()
        for node in range(len(self.nodes["kind"])):
            graph.add_node(node, **{name: column[node].item() for name, column in self.nodes.items()})
        for edge in range(len(self.edges["from"])):
            values = {name: column[edge].item() for name, column in self.edges.items()}
            graph.add_edge(values.pop("from"), values.pop("to"), points=self.edge_points(edge), **values)
        return graph

    def to_csgraph(self, weight: str = "length") -> Any:
        """A symmetric scipy.sparse.csr_matrix of a column of the edges, for scipy.sparse.csgraph.

        Of parallel edges the one with the least weight remains; loops are left out.
        """
        from scipy import sparse  # type: ignore[import]

        ends = np.sort(np.stack([self.edges["from"], self.edges["to"]]), axis=0)
        column = _arrays.one_of("weight", weight, self.edges)
        order = np.lexsort((column, ends[1], ends[0]))
        order = order[ends[0, order] != ends[1, order]]
        first = np.ones(len(order), bool)
        first[1:] = (np.diff(ends[:, order]) != 0).any(axis=0)
        order = order[first]
        one, other = ends[:, order].astype(np.int64)
        weights = np.tile(column[order], 2)
        places = np.concatenate([one, other]), np.concatenate([other, one])
        count = len(self.nodes["kind"])
        return sparse.coo_matrix((weights, places), (count, count)).tocsr()

    def _links(self) -> tuple[int, Array]:
        return len(self.nodes["kind"]), _network.links(self.edges["from"], self.edges["to"], self.edges["length"])

    def _path(self, length: float, nodes: Array, edges: Array, first: int, last: int) -> GraphPath:
        """`first` and `last` are positions between the ends of the first and the last edge, or -1 at nodes."""
        start, stop = (None if point < 0 else point + 1 for point in (first, last))
        pixels = self._pixels_along(nodes, edges, start, stop)
        is_new = np.ones(len(pixels), bool)
        is_new[1:] = (np.diff(pixels, axis=0) != 0).any(axis=1)
        return GraphPath(length, nodes, edges, pixels[is_new], start, stop)

    def _pixels_along(self, nodes: Array, edges: Array, start: int | None, stop: int | None) -> Array:
        """Where edges meet in one pixel, it is there twice."""
        if len(nodes) == 0:
            return self.edge_points(edges[0])[start:None if stop is None else stop + 1]
        if len(edges) == 0:
            return self.node_pixels(nodes[0])[:1]
        whole = edges[0 if start is None else 1:len(edges) if stop is None else -1]
        chains = [self.edge_points(edge) if self.edges["from"][edge] == node else self.edge_points(edge)[::-1]
                  for node, edge in zip(nodes, whole)]
        if start is not None:
            chains.insert(0, self._part(edges[0], nodes[0], start)[::-1])
        if stop is not None:
            chains.append(self._part(edges[-1], nodes[-1], stop))
        return np.concatenate(chains)

    def _part(self, edge: int, node: int, pixel: int) -> Array:
        """From one of its nodes to a pixel of an edge; of a loop the shorter part, of equal ones the first."""
        chain = self.edge_points(edge)
        is_first = self.edges["from"][edge] == node
        if is_first and self.edges["to"][edge] == node:
            steps = np.abs(np.diff(chain[:pixel + 1], axis=0))
            diagonal = int((steps.sum(axis=1) == 2).sum())
            down, across = (int(count) - diagonal for count in steps.sum(axis=0))
            rows, columns = self.spacing
            position = across * columns + down * rows + diagonal * math.sqrt(columns * columns + rows * rows)
            is_first = position <= self.edges["length"][edge] - position
        return chain[:pixel + 1] if is_first else chain[pixel:][::-1]

    def _with_edges(self, edges: Array, nodes: Array) -> Graph:
        """Of these edges and nodes, in this order."""
        numbers = np.zeros(len(self.nodes["kind"]), np.int64)
        numbers[nodes] = np.arange(len(nodes))
        columns = {name: column[edges] for name, column in self.edges.items()}
        columns.update({side: numbers[columns[side]] for side in ("from", "to")})
        kept = {name: column[nodes] for name, column in self.nodes.items()}
        return counted(kept, columns, self.spacing, self.shape, self._nodes.chosen(nodes), self._chains.chosen(edges),
                       self._table[edges], self._distances)


def counted(nodes: Columns, edges: Columns, spacing: tuple[float, float], shape: tuple[int, ...], node_pixels: Groups,
            chains: Groups, table: Array, distances: Array | None) -> Graph:
    """A graph whose degrees and components are counted."""
    count = len(nodes["kind"])
    nodes["degree"] = np.bincount(edges["from"], minlength=count) + np.bincount(edges["to"], minlength=count)
    nodes["component"] = _network.components(count, _network.links(edges["from"], edges["to"], edges["length"]))
    return Graph(nodes, edges, spacing, shape, node_pixels, chains, table, distances)


def _closed(cycle: GraphPath) -> GraphPath:
    """With the first point at its end, also where it leaves a node by another pixel than it enters it."""
    points = cycle.points
    return cycle if (points[0] == points[-1]).all() else cycle._replace(points=np.concatenate([points, points[:1]]))


def _edge_numbers(edges: npt.ArrayLike, count: int) -> Array:
    """Numbers of edges, which are given as such or by a bool for each."""
    chosen = _arrays.as_array("edges", edges)
    if chosen.dtype == bool and chosen.shape != (count,):
        raise ValueError(f"edges: expected bools of shape ({count},), got {chosen.shape}")
    if chosen.ndim != 1:
        raise ValueError(f"edges: expected one dimension, got shape {chosen.shape}")
    if chosen.size and chosen.dtype.kind not in "biu":
        raise TypeError(f"edges: expected integers or bools, got dtype {chosen.dtype}")
    numbers = np.flatnonzero(chosen) if chosen.dtype == bool else chosen
    outside = numbers[(numbers < 0) | (numbers >= count)]
    if outside.size:
        raise ValueError(f"edges: expected numbers from 0 to {count - 1}, got {outside[0]}")
    return numbers.astype(np.int64)


def _label(columns: Columns, i: int) -> dict[str, int]:
    return {"label": int(columns["label"][i])} if "label" in columns else {}


def _finite(name: str, numbers: Sequence[float], count: int = 6) -> list[float]:
    found = [_arrays.real(name, number) for number in _arrays.each(name, numbers)]
    for number in found:
        if not math.isfinite(number):
            raise ValueError(f"{name}: expected finite numbers, got {number}")
    if len(found) != count:
        raise ValueError(f"{name}: expected {count} numbers, got {len(found)}")
    return found
