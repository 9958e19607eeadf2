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
from thinbench._cycle_holes import CycleHoles

KINDS = np.array(["isolated", "end", "junction", "cycle", "given"])
Array = npt.NDArray[Any]
Columns = dict[str, Array]


class Groups(NamedTuple):
    """Arrays of any length, one after another: number i is `values[bounds[i]:bounds[i + 1]]`."""

    values: Array
    bounds: Array

    def of(self, i: int) -> Array:
        if not -len(self.bounds) < i < len(self.bounds) - 1:
            raise IndexError(f"expected a number below {len(self.bounds) - 1}, got {i}")
        i %= len(self.bounds) - 1
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

    `pixels` are the rows and columns along the edges. In a node of several pixels they go straight from
    one edge to the next, which adds nothing to the length.
    """

    length: float
    nodes: Array
    edges: Array
    pixels: Array


class Cycle(NamedTuple):
    """A closed path; the last of its edges leads back to the first of its nodes.

    `holes` are the rows and columns of the first pixel of each hole of the skeleton that it encloses.
    """

    length: float
    nodes: Array
    edges: Array
    pixels: Array
    holes: Array


class Place(NamedTuple):
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
    """

    nodes: Columns
    edges: Columns
    spacing: tuple[float, float]
    _nodes: Groups  # rows and columns of their pixels
    _chains: Groups  # those along the edges, with both ends
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
            chain = self.edge_pixels(i)
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
        return self._nodes.of(node)

    def edge_pixels(self, edge: int) -> Array:
        """Rows and columns along an edge, from a pixel of one node to one of the other: shape (N, 2)."""
        return self._chains.of(edge)

    def edge_widths(self, edge: int) -> Array:
        """The width at each of `edge_pixels(edge)`. The graph must know its image."""
        if self._distances is None:
            raise ValueError("edge_widths: expected a skeleton_graph(skeleton, image), whose image gives the widths")
        rows, columns = self.edge_pixels(edge).T
        widths: Array = 2 * self._distances[rows, columns]
        return widths

    def polylines(self, tolerance: float = 1) -> list[Array]:
        """Rows and columns of the points of each edge that are needed so that none of its pixels is farther
        than `tolerance` from the line through them (Douglas and Peucker 1973): arrays of shape (N, 2)."""
        return [self._polyline(self.edge_pixels(i), tolerance) for i in range(len(self.edges["from"]))]

    def _polyline(self, chain: Array, tolerance: float) -> Array:
        points = np.ascontiguousarray(chain[:, ::-1], np.int32)
        kept = np.empty(chain.shape, np.int32)
        count = ctypes.c_size_t()
        _library.polyline(points.ctypes.data, len(points), _arrays.real("tolerance", tolerance),
                          _library.spacing(*self.spacing), kept.ctypes.data, ctypes.byref(count))
        return kept[:count.value, ::-1].copy()

    def main_paths(self) -> list[GraphPath]:
        """The longest of the shortest paths between two nodes, of each component.

        Of paths that are equally long, the one with the lowest first node, then with the lowest last one.
        Exact for graphs with cycles, too. A component without edges has a path of one pixel.
        """
        return [self._path(*path) for path in _network.main_paths(*self._links())]

    def main_path(self) -> GraphPath:
        """The longest of `main_paths()`, of equal ones the first."""
        paths = self.main_paths()
        if not paths:
            raise ValueError("main_path: expected a graph with nodes, got none")
        return max(paths, key=lambda path: path.length)

    def shortest_path(self, from_node: int, to_node: int) -> GraphPath:
        """Between two nodes; its pixels are those along the way. ValueError if there is none."""
        found = _network.shortest_path(*self._links(), _arrays.integer("from_node", from_node),
                                       _arrays.integer("to_node", to_node))
        if not found:
            raise ValueError(f"no path leads from node {from_node} to node {to_node}")
        return self._path(*found[0])

    def cycles(self) -> list[Cycle]:
        """Cycles of which every other is a combination; their number is edges - nodes + components.

        Each is closed by an edge that is not in the minimum spanning forest, the longest of its edges.
        """
        holes = CycleHoles(*self._labelled_pixels())
        found = []
        for length, nodes, edges in _network.cycles(*self._links()):
            path = self._path(length, np.append(nodes, nodes[0]), edges)
            node, label = nodes[0], self._label_of(nodes[0])
            if len(edges) == 1 and len(self.edge_pixels(edges[0])) <= 2:
                enclosed = holes.in_next_loop(node, self.node_pixels(node), label)
            else:
                enclosed = holes.in_curve(self._curve(nodes, edges, holes), label)
            found.append(Cycle(length, nodes, edges, path.pixels, enclosed))
        return found

    def open_cycles(self, max_length: float = math.inf) -> Graph:
        """The graph without the closing edges of `cycles()` that are at most so long: without their
        longest edges, of equally long ones the last."""
        longest = _arrays.real("max_length", max_length)
        if not longest >= 0:
            raise ValueError(f"max_length: expected a number of at least 0, got {longest:g}")
        keep = np.ones(len(self.edges["from"]), bool)
        for length, _, edges in _network.cycles(*self._links()):
            keep[edges[-1]] = length > longest
        return self._with_edges(np.flatnonzero(keep), np.arange(len(self.nodes["kind"])))

    def subgraph(self, edges: npt.ArrayLike) -> Graph:
        """Of some edges, by their numbers or by a bool for each, and of their nodes.

        Numbers of nodes, degrees and components are those of the subgraph; kinds remain.
        """
        chosen = _edge_numbers(edges, len(self.edges["from"]))
        used = np.unique(np.concatenate([self.edges["from"][chosen], self.edges["to"][chosen]]))
        return self._with_edges(chosen, used)

    def nearest(self, row: float, column: float) -> Place:
        """The pixel of an edge that is nearest to a point, the first with the least distance."""
        if len(self._chains.values) == 0:
            raise ValueError("nearest: expected a graph with edges, got none")
        point = _arrays.real("row", row), _arrays.real("column", column)
        if not all(map(math.isfinite, point)):
            raise ValueError(f"nearest: expected a finite point, got {point[0]:g}, {point[1]:g}")
        away = (self._chains.values - point) * self.spacing
        squares = (away ** 2).sum(axis=1)
        at = int(squares.argmin())
        edge = int(np.searchsorted(self._chains.bounds, at, side="right")) - 1
        place = self._chains.values[at]
        return Place(edge, int(place[0]), int(place[1]), float(np.sqrt(squares[at])))

    def summary(self, separator: str = "-") -> Columns:
        """A table of the edges with the column names of skan's `summarize`, as a dict of arrays.

        "branch-type" is 0 between ends, 1 between an end and a junction, 2 between junctions, 3 for a
        closed line. "tortuosity" is the length by the distance between the ends, NaN where these are one
        place. `pandas.DataFrame(graph.summary())` is the table that scripts expect.
        """
        nodes, edges = self.nodes, self.edges
        sides = [("src", edges["from"], self._chains.bounds[:-1]), ("dst", edges["to"], self._chains.bounds[1:] - 1)]
        table: Columns = {"skeleton-id": nodes["component"][edges["from"]]}
        table.update({"node-id-" + side: node.copy() for side, node, _ in sides})
        table["branch-distance"] = edges["length"].copy()
        table["branch-type"] = self._branch_types()
        places = {side: self._chains.values[at] for side, _, at in sides}
        for prefix, unit in (("image-coord", (1, 1)), ("coord", self.spacing)):
            for side, pixels in places.items():
                table.update({f"{prefix}-{side}-{axis}": pixels[:, axis] * unit[axis] for axis in (0, 1)})
        table["euclidean-distance"] = edges["chord"].copy()
        with np.errstate(invalid="ignore", divide="ignore"):
            table["tortuosity"] = np.where(edges["chord"] > 0, edges["length"] / edges["chord"], np.nan)
        table.update({name: edges[name].copy() for name in edges if name.startswith("width-") or name == "label"})
        return {name.replace("-", separator): column for name, column in table.items()}

    def _branch_types(self) -> Array:
        first, last = (self.nodes["kind"][self.edges[side]] for side in ("from", "to"))
        ends = (first == "end").astype(int) + (last == "end")
        return np.where(first == "cycle", 3, 2 - ends)

    def to_geojson(self, tolerance: float = 1, transform: Sequence[float] | None = None) -> dict[str, Any]:
        """What `thinbench graph --geojson` writes: a Point for each node, a LineString for each edge.

        `transform` is (a, b, c, d, e, f) of x' = a x + b y + c, y' = d x + e y + f, by default that of the
        spacing, which is written x first. The centre of the first pixel is at x = 0.5, y = 0.5. Ids count
        from 1. A width without background is None.
        """
        spaced = (self.spacing[1], 0, 0, 0, self.spacing[0], 0)
        a, b, c, d, e, f = _finite("transform", spaced if transform is None else transform)

        def position(row: float, column: float) -> list[float]:
            x, y = float(column) + 0.5, float(row) + 0.5
            return _finite("transform", [a * x + b * y + c, d * x + e * y + f], 2)

        def feature(kind: str, coordinates: Any, properties: dict[str, Any]) -> dict[str, Any]:
            return {"type": "Feature", "geometry": {"type": kind, "coordinates": coordinates}, "properties": properties}

        nodes, edges = self.nodes, self.edges
        widths = {name: name.replace("-", "_") for name in edges if name.startswith("width-")}
        features = []
        for i in range(len(nodes["kind"])):
            properties = {"id": i + 1, "kind": str(nodes["kind"][i]), "degree": int(nodes["degree"][i]),
                          **_label(nodes, i)}
            features.append(feature("Point", position(nodes["row"][i], nodes["column"][i]), properties))
        for i, line in enumerate(self.polylines(tolerance)):
            properties = {"id": i + 1, "from": int(edges["from"][i]) + 1, "to": int(edges["to"][i]) + 1,
                          "pixels": len(self.edge_pixels(i)) - 2,
                          "length": float(edges["length"][i]), "chord": float(edges["chord"][i])}
            for column, name in widths.items():
                width = float(edges[column][i])
                properties[name] = width if math.isfinite(width) else None
            properties |= _label(edges, i)
            features.append(feature("LineString", [position(*point) for point in line], properties))
        return {"type": "FeatureCollection", "spacing": list(self.spacing[::-1]), "unit": None, "features": features}

    def to_networkx(self) -> Any:
        """A networkx.MultiGraph with the columns as attributes of nodes and edges, and "pixels" of edges."""
        import networkx  # type: ignore[import]

        graph = networkx.MultiGraph()
        for node in range(len(self.nodes["kind"])):
            graph.add_node(node, **{name: column[node].item() for name, column in self.nodes.items()})
        for edge in range(len(self.edges["from"])):
            values = {name: column[edge].item() for name, column in self.edges.items()}
            graph.add_edge(values.pop("from"), values.pop("to"), pixels=self.edge_pixels(edge), **values)
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

    def _links(self) -> tuple[int, Array]:
        return len(self.nodes["kind"]), _network.links(self.edges["from"], self.edges["to"], self.edges["length"])

    def _directed(self, nodes: Array, edges: Array) -> list[Array]:
        """The pixels of edges, each from the node beside it."""
        return [self.edge_pixels(edge) if self.edges["from"][edge] == node else self.edge_pixels(edge)[::-1]
                for node, edge in zip(nodes, edges)]

    def _path(self, length: float, nodes: Array, edges: Array) -> GraphPath:
        chains = self._directed(nodes, edges)
        pixels = np.concatenate(chains) if chains else self.node_pixels(nodes[0])[:1]
        is_new = np.ones(len(pixels), bool)
        is_new[1:] = (np.diff(pixels, axis=0) != 0).any(axis=1)
        return GraphPath(length, nodes, edges, pixels[is_new])

    def _label_of(self, node: int) -> int:
        return int(self.nodes["label"][node]) if "label" in self.nodes else 0

    def _labelled_pixels(self) -> tuple[Array, Array]:
        """All pixels, some of them twice, and their labels; 0 in graphs without labels."""
        pixels: Array = np.concatenate([self._nodes.values, self._chains.values]).astype(np.int64)
        if "label" not in self.nodes:
            return pixels, np.zeros(len(pixels), np.int64)
        return pixels, np.concatenate([np.repeat(self.nodes["label"], self._nodes.lengths()),
                                       np.repeat(self.edges["label"], self._chains.lengths())])

    def _curve(self, nodes: Array, edges: Array, holes: CycleHoles) -> Array:
        """The pixels of a cycle, each beside the next, with those of its nodes that lead from edge to edge."""
        chains = self._directed(nodes, edges)
        parts = []
        for node, chain, following in zip(np.roll(nodes, -1), chains, chains[1:] + chains[:1]):
            parts += [chain, holes.way(node, self.node_pixels(node), chain[-1], following[0])]
        return np.concatenate(parts)

    def _with_edges(self, edges: Array, nodes: Array) -> Graph:
        """Of these edges and nodes, in this order."""
        numbers = np.zeros(len(self.nodes["kind"]), np.int64)
        numbers[nodes] = np.arange(len(nodes))
        columns = {name: column[edges] for name, column in self.edges.items()}
        columns.update({side: numbers[columns[side]] for side in ("from", "to")})
        kept = {name: column[nodes] for name, column in self.nodes.items()}
        return counted(kept, columns, self.spacing, self._nodes.chosen(nodes), self._chains.chosen(edges),
                       self._distances)


def counted(nodes: Columns, edges: Columns, spacing: tuple[float, float], node_pixels: Groups, chains: Groups,
                 distances: Array | None) -> Graph:
    """A graph whose degrees and components are counted."""
    count = len(nodes["kind"])
    nodes["degree"] = np.bincount(edges["from"], minlength=count) + np.bincount(edges["to"], minlength=count)
    nodes["component"] = _network.components(count, _network.links(edges["from"], edges["to"], edges["length"]))
    return Graph(nodes, edges, spacing, node_pixels, chains, distances)


def _edge_numbers(edges: npt.ArrayLike, count: int) -> Array:
    """Numbers of edges, which are given as such or by a bool for each."""
    chosen = np.asarray(edges)
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
    found = [_arrays.real(name, number) for number in numbers]
    for number in found:
        if not math.isfinite(number):
            raise ValueError(f"{name}: expected finite numbers, got {number}")
    if len(found) != count:
        raise ValueError(f"{name}: expected {count} numbers, got {len(found)}")
    return found
