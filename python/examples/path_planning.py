"""Plans paths for robots on the skeleton of a floor plan, and draws them: docs/path-planning.md explains it.

Needs SciPy and matplotlib.
"""

from __future__ import annotations

import argparse
from itertools import pairwise, product
from pathlib import Path

import numpy as np
import numpy.typing as npt
import thinbench
from matplotlib.figure import Figure
from scipy.sparse import csgraph
from scipy.spatial import KDTree

Mask = npt.NDArray[np.bool_]
Distances = npt.NDArray[np.float64]
Pixels = npt.NDArray[np.int64]  # rows and columns: shape (N, 2)
Point = tuple[int, int]

START, GOAL = (150, 40), (80, 590)
# Rectangles: first row, first column, last row + 1, last column + 1. Pillars: row, column, radius.
WALLS = [(0, 0, 8, 640), (472, 0, 480, 640), (0, 0, 480, 8), (0, 632, 480, 640), (192, 8, 200, 420),
         (262, 8, 270, 632), (8, 206, 192, 214), (8, 420, 472, 428)]
DOORS = [(192, 40, 200, 90), (192, 300, 200, 345), (80, 206, 105, 214), (262, 330, 270, 380), (214, 420, 238, 428),
         (390, 420, 440, 428), (262, 550, 270, 605)]
FURNITURE = [(214, 175, 222, 215), (40, 70, 80, 140), (120, 150, 192, 165), (30, 260, 60, 370), (110, 290, 130, 340),
             (60, 490, 130, 540), (170, 560, 200, 632), (320, 500, 345, 580), (420, 500, 472, 560), (270, 8, 300, 150)]
PILLARS = [(row, column, 9) for row in (340, 410) for column in (60, 140, 220, 300)]
COLOURS = ("#e69f00", "#0072b2", "#009e73", "#cc79a7")


def floor_plan() -> Mask:
    """True where a robot may be; walls enclose it."""
    free = np.ones((480, 640), bool)
    for blocked, rectangles in ((True, WALLS), (False, DOORS), (True, FURNITURE)):
        for top, left, bottom, right in rectangles:
            free[top:bottom, left:right] = not blocked
    rows, columns = np.ogrid[:480, :640]
    for row, column, radius in PILLARS:
        free &= (rows - row) ** 2 + (columns - column) ** 2 > radius**2
    return free


def plan_path(free: Mask, skeleton: Mask, width: float, start: Point, goal: Point) -> Pixels:
    """The shortest path on the skeleton, from start to goal, that is as wide as the robot everywhere."""
    distance = thinbench.distances(free)
    graph = thinbench.skeleton_graph(with_points(skeleton, distance, width, [start, goal]), free,
                                     not_thin="ignore")  # the blocks at start and goal
    nodes = [graph.node_pixels(node) for node in range(len(graph.nodes["kind"]))]
    narrow_node = np.array([2 * distance[tuple(pixels.T)].min() < width for pixels in nodes])
    narrow = narrow_node[[graph.edges["from"], graph.edges["to"]]].any(axis=0) | (graph.edges["width-min"] < width)
    graph.edges["cost"] = np.where(narrow, np.inf, graph.edges["length"])
    first, last = (next(node for node, pixels in enumerate(nodes) if (pixels == point).all(axis=1).any())
                   for point in (start, goal))
    costs, before = csgraph.dijkstra(graph.to_csgraph("cost"), indices=first, return_predecessors=True)
    if np.isinf(costs[last]) or narrow_node[last]:
        raise ValueError(f"no path from {start} to {goal} is wide enough for a robot {width:g} pixels wide")
    path = traced(before, first, last)
    edges = [graph.edge_points(cheapest_edge(graph, *ends)) for ends in pairwise(path)]
    return in_order(np.concatenate([nodes[node] for node in path] + edges), start, goal)


def with_points(skeleton: Mask, distance: Distances, width: float, points: list[Point]) -> Mask:
    """The skeleton with a line to each point. A block of 2 x 2 pixels is a junction, so every point is in a node."""
    lines = skeleton.copy()
    for row, column in points:
        lines[tuple(line_to_skeleton(skeleton, distance, width, (row, column)).T)] = True
        blocks = [np.s_[y:y + 2, x:x + 2] for y, x in product((row - 1, row), (column - 1, column))]
        lines[max(blocks, key=lambda block: float(distance[block].min()))] = True
    return lines


def line_to_skeleton(skeleton: Mask, distance: Distances, width: float, point: Point) -> Pixels:
    """The shortest straight line from a point to the skeleton that is wide enough everywhere."""
    clear = 2 * distance >= width
    targets = np.argwhere(skeleton & clear)
    for target in targets[np.argsort(np.hypot(*(targets - point).T))]:
        line: Pixels = np.rint(np.linspace(point, target, np.abs(target - point).max() + 1)).astype(np.int64)
        if clear[tuple(line.T)].all():
            return line
    raise ValueError(f"no straight line from {point} to the skeleton is wide enough for a robot {width:g} pixels wide")


def cheapest_edge(graph: thinbench.Graph, node: int, other: int) -> int:
    """Of parallel edges the one whose cost to_csgraph keeps."""
    ends = np.sort([graph.edges["from"], graph.edges["to"]], axis=0)
    joins = (ends == np.sort([[node], [other]], axis=0)).all(axis=0)
    return int(np.where(joins, graph.edges["cost"], np.inf).argmin())


def in_order(pixels: Pixels, start: Point, goal: Point) -> Pixels:
    """The shortest path over these pixels, from each to one of its eight neighbours."""
    tree = KDTree(np.unique(pixels, axis=0))
    first, last = tree.query([start, goal])[1]
    steps = tree.sparse_distance_matrix(tree, 1.5).tocsr()
    before = csgraph.dijkstra(steps, indices=first, return_predecessors=True)[1]
    return np.asarray(tree.data[traced(before, first, last)], np.int64)


def traced(before: npt.NDArray[np.int32], first: int, last: int) -> list[int]:
    """The path from the first to the last, of which SciPy gives what comes before each."""
    path = [last]
    while path[-1] != first:
        path.append(int(before[path[-1]]))
    return path[::-1]


def draw(free: Mask, skeleton: Mask, paths: list[tuple[float, Pixels]], file: Path) -> None:
    height, width = free.shape
    picture = np.where(free[..., None], 255, np.array([60, 66, 74])).astype(np.uint8)
    picture[skeleton] = 150
    figure = Figure(figsize=(width / 100, height / 100 + 0.3), dpi=100)  # so a pixel is 0.72 points
    axes = figure.add_axes((0, 0, 1, height / (height + 30)))
    axes.imshow(picture, interpolation="nearest")
    axes.set_axis_off()
    for (robot, path), colour in zip(sorted(paths, key=lambda pair: -pair[0]), COLOURS * len(paths)):
        axes.plot(path[:, 1], path[:, 0], color=colour, linewidth=0.72 * robot, alpha=0.3, solid_capstyle="round")
        axes.plot(path[:, 1], path[:, 0], color=colour, label=f"robot {robot:g} pixels wide")
    for name, (row, column) in (("start", START), ("goal", GOAL)):
        axes.plot(column, row, "ko", markersize=4)
        axes.annotate(name, (column, row), (0, 7), textcoords="offset points", ha="center")
    figure.legend(loc="upper center", ncols=4, frameon=False, borderaxespad=0)
    figure.savefig(file, metadata={"Software": None})


def main() -> None:
    parser = argparse.ArgumentParser(description="Plans paths for robots in a floor plan and draws them.")
    parser.add_argument("--robot", type=float, nargs="+", default=[16, 32], metavar="WIDTH", help="pixels (16 32)")
    parser.add_argument("--out", type=Path, default=Path("paths.png"), metavar="FILE", help="picture (paths.png)")
    options = parser.parse_args()
    if not min(options.robot) > 0:
        parser.error("--robot takes widths above 0")
    free = floor_plan()
    skeleton = thinbench.prune(thinbench.thin(free), min_widths=1, image=free)
    try:
        paths = [(robot, plan_path(free, skeleton, robot, START, GOAL)) for robot in options.robot]
        draw(free, skeleton, paths, options.out)
    except (ValueError, OSError) as error:
        parser.exit(1, f"{parser.prog}: {error}\n")
    for robot, path in paths:
        length = np.hypot(*np.diff(path, axis=0).T).sum()
        print(f"robot {robot:g} pixels wide: a path of {length:.0f} pixels")


if __name__ == "__main__":
    main()
