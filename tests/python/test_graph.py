"""Distances, graphs, pruning, and what is made of graphs: drawn ones with known answers, SciPy, loops."""

from __future__ import annotations

import json
import warnings

import numpy as np
import pytest
from scipy import ndimage
from scipy.sparse import csgraph

import thinbench
from images import random_image


def drawn(*lines):
    return np.array([[pixel == "#" for pixel in line] for line in lines])


TREE = drawn("#.........#",
             ".#.......#.",
             "..#######..",
             ".....#.....",
             ".....#.....")
EIGHT = drawn("#########",
              "#...#...#",
              "#...#...#",
              "#########",
              "........#")
RING_WITH_TAILS = np.array([[0, 0, 0, 1, 1, 0, 0, 0],
                            [1, 1, 1, 0, 0, 1, 1, 1],
                            [0, 0, 0, 1, 1, 0, 0, 0]], bool)


def test_distances_take_spacing_threads_and_out():
    image = np.random.RandomState(1).rand(40, 60) < 0.9
    for spacing in (1, 2, (1, 3), [1e-3, 40]):
        out = np.empty(image.shape)
        assert thinbench.distances(image, spacing=spacing, threads=2, out=out) is out
        np.testing.assert_array_max_ulp(out, ndimage.distance_transform_edt(image, sampling=spacing), maxulp=1)
    squares = np.empty(image.shape, np.int32)
    assert thinbench.squared_distances(image, threads=2, out=squares) is squares
    np.testing.assert_array_equal(squares, np.rint(ndimage.distance_transform_edt(image) ** 2))
    assert (thinbench.distances(np.ones((3, 4), bool)) == np.inf).all()
    thinbench.release_memory()


def test_shortest_paths_by_scipy_take_any_column_as_cost():
    graph = thinbench.skeleton_graph(RING_WITH_TAILS)
    assert csgraph.shortest_path(graph.to_csgraph())[0, 3] == pytest.approx(4 + 1 + 2 * 2**0.5)
    graph.edges["cost"] = np.arange(4.0)  # edges without cost remain
    assert csgraph.shortest_path(graph.to_csgraph("cost"), directed=False)[0].tolist() == [0, 0, 1, 4]


def test_empty_images_have_empty_graphs():
    for shape in ((0, 5), (5, 0), (3, 3)):
        for graph in (thinbench.skeleton_graph(np.zeros(shape, bool)), thinbench.graph_of_labels(np.zeros(shape, int))):
            assert len(graph.nodes["kind"]) == len(graph.edges["from"]) == 0


def test_widths_are_those_of_the_image_at_each_pixel_and_of_nodes_and_may_be_infinite():
    image = np.ones((5, 9), bool)
    skeleton = drawn(".........", ".........", "#########", ".........", ".........")
    infinite = thinbench.skeleton_graph(skeleton, image)
    assert infinite.edges["width-max"].tolist() == [np.inf]
    geojson = infinite.to_geojson()
    assert geojson["features"][2]["properties"]["width_min"] is None
    json.dumps(geojson, allow_nan=False)
    image[1, 0] = image[0, 1:5] = False
    for spacing in (1, 0.5):
        uneven = thinbench.skeleton_graph(skeleton, image, spacing=spacing)
        widths = uneven.edge_widths(0)
        np.testing.assert_allclose(widths, 2 * thinbench.distances(image, spacing=spacing)[2])
        found = [uneven.edges[f"width-{name}"][0] for name in ("mean", "median", "min", "max")]
        assert found == [reduce(widths) for reduce in (np.mean, np.median, np.min, np.max)]
        assert len(set(found)) == 4 and uneven.nodes["width"].tolist() == widths[[0, -1]].tolist()
    block = drawn("##", "##", "..")  # a node is as wide as its widest pixel
    assert thinbench.skeleton_graph(block, block, not_thin="ignore").nodes["width"] == [4]


@pytest.mark.parametrize(("options", "is_pruned"), [
    ({"min_length": 2.5}, True), ({"min_length": 2}, False), ({"min_length": 2.5, "spacing": 2}, False),
    ({"min_widths": 1, "image": np.arange(44).reshape(4, 11) > 10}, True), ({}, False)])
def test_pruning_takes_lengths_in_the_unit_of_the_spacing_or_widths(options, is_pruned):
    line = np.where(drawn("...........", ".....#.....", ".....#.....", "###########"), 255, 0).astype(np.uint8)
    found = thinbench.prune(line, **options)
    np.testing.assert_array_equal(found[3], line[3])
    assert found.dtype == np.uint8 and found[:3].any() != is_pruned


def test_classes_of_pixels_have_names_and_degrees():
    image = drawn("#.###..", "....#.#", "##..###", "##....#")
    classes, degrees = thinbench.classify_pixels(image)
    assert [thinbench.PIXEL_CLASSES[c] for c in classes[0, :4]] == ["isolated", "background", "end", "line"]
    assert [thinbench.PIXEL_CLASSES[c] for c in classes[2, 4:]] == ["line", "line", "junction"]
    assert degrees[2].tolist() == [2, 2, 0, 0, 2, 2, 3]


def test_polylines_keep_what_is_farther_than_the_tolerance():
    graph = thinbench.skeleton_graph(drawn("#.....#", ".#...#.", "..#.#..", "...#..."))
    assert [line.tolist() for line in graph.polylines(1)] == [[[0, 0], [3, 3], [0, 6]]]
    assert [line.tolist() for line in graph.polylines(3)] == [[[0, 0], [0, 6]]]


@pytest.mark.parametrize("spacing", [1, 0.006, 30, (0.5, 0.006), (0.5, 30)])
def test_the_default_tolerance_is_the_larger_side_of_a_pixel(spacing):
    graph = thinbench.skeleton_graph(thinbench.thin(random_image(6, 100)), spacing=spacing, not_thin="ignore")
    expected = [line.tolist() for line in graph.polylines(max(graph.spacing))]
    assert expected not in ([line.tolist() for line in graph.polylines(value)] for value in (0, 1e9))
    assert [line.tolist() for line in graph.polylines()] == expected
    lengths = graph.smoothed_lengths(max(graph.spacing)).tolist()
    assert graph.smoothed_lengths().tolist() == graph.summary()["smoothed-length"].tolist() == lengths
    assert graph.to_geojson() == graph.to_geojson(max(graph.spacing))
    assert [f["properties"]["smoothed_length"] for f in graph.to_geojson()["features"][-len(lengths):]] == lengths


def test_a_ring_with_tails_has_parallel_edges():
    graph = thinbench.skeleton_graph(RING_WITH_TAILS)
    assert list(graph.nodes["kind"]) == ["end", "junction", "junction", "end"]
    assert list(graph.nodes["degree"]) == [1, 3, 3, 1]
    assert sorted(zip(graph.edges["from"], graph.edges["to"], strict=True)) == [(0, 1), (1, 2), (1, 2), (2, 3)]
    np.testing.assert_allclose(graph.edges["length"], [2, 1 + 2 * 2**0.5, 1 + 2 * 2**0.5, 2])
    np.testing.assert_allclose(graph.edges["chord"], [2, 3, 3, 2])
    assert graph.edge_points(0).tolist() == [[1, 0], [1, 1], [1, 2]]
    assert graph.node_pixels(1).tolist() == [[1, 2]]


def test_networkx_graph_has_the_columns():
    pytest.importorskip("networkx")
    graph = thinbench.skeleton_graph(RING_WITH_TAILS).to_networkx()
    assert (graph.number_of_nodes(), graph.number_of_edges()) == (4, 4)
    assert graph.nodes[1]["kind"] == "junction"
    assert len(graph[1][2]) == 2 and graph[0][1][0]["points"].shape == (3, 2)


def test_geojson_has_transformed_points_and_lines():
    found = thinbench.skeleton_graph(RING_WITH_TAILS).to_geojson(transform=(2, 0, 100, 0, -2, 50))
    points = [f for f in found["features"] if f["geometry"]["type"] == "Point"]
    lines = [f for f in found["features"] if f["geometry"]["type"] == "LineString"]
    assert json.loads(json.dumps(found)) == found
    spaced = thinbench.skeleton_graph(RING_WITH_TAILS, spacing=(2, 10)).to_geojson()
    assert spaced["features"][0]["geometry"]["coordinates"] == [5, 3] and spaced["spacing"] == [10, 2]
    assert len(points) == len(lines) == 4
    assert points[0]["geometry"]["coordinates"] == [101, 47]
    assert lines[0]["geometry"]["coordinates"] == [[101, 47], [105, 47]]
    assert [list(feature) for feature in found["features"]] == [["type", "id", "geometry", "properties"]] * 8
    assert [feature["id"] for feature in found["features"]] == [1, 2, 3, 4, 5, 6, 7, 8]
    assert points[1]["properties"] == {"id": 2, "kind": "junction", "degree": 3}
    assert lines[0]["properties"] == {"id": 1, "from": 1, "to": 2, "pixels": 1, "length": 2,
                                      "smoothed_length": 2, "chord": 2, "kind": "edge"}


def test_a_line_of_geojson_has_two_positions_also_where_it_is_one_pixel():
    graph = thinbench.skeleton_graph(np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]], bool).repeat(2, 0).repeat(2, 1),
                                     not_thin="ignore")
    assert graph.edges["length"].tolist() == [0]
    assert graph.to_geojson()["features"][1]["geometry"]["coordinates"] == [[0.5, 0.5], [0.5, 0.5]]


def test_blocks_of_an_image_that_is_not_thin_are_reported():
    thick = np.zeros((5, 9), bool)
    thick[1:3, 4:7] = True
    message = "skeleton: not thin: 2 blocks of 2 x 2 pixels, the first at row 1, column 4"
    with pytest.warns(UserWarning, match=message):
        thinbench.skeleton_graph(thick)
    with pytest.raises(ValueError, match=message):
        thinbench.skeleton_graph(thick, not_thin="raise")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert thinbench.skeleton_graph(thick, not_thin="ignore").nodes["kind"].tolist() == ["junction"]


def test_a_graph_says_in_a_line_what_it_is():
    cross = np.array([[0, 1, 0, 0], [1, 1, 1, 1], [0, 1, 0, 0]], bool)
    assert repr(thinbench.skeleton_graph(cross)) == "Graph(5 nodes (4 end, 1 junction), 4 edges of length 5.0)"
    assert repr(thinbench.skeleton_graph(cross[1:2])) == "Graph(2 nodes (2 end), 1 edge of length 3.0)"
    assert repr(thinbench.skeleton_graph(cross[1:2, :1])) == "Graph(1 node (1 isolated), 0 edges of length 0.0)"
    assert repr(thinbench.skeleton_graph(np.zeros((2, 2), bool))) == "Graph(0 nodes, 0 edges of length 0.0)"


def test_a_graph_is_plotted_as_lines_and_points():
    figure = pytest.importorskip("matplotlib.figure").Figure()
    graph = thinbench.skeleton_graph(thinbench.thin(random_image(6)), not_thin="ignore")
    ax = figure.add_subplot()
    assert graph.plot(ax) is ax
    ends = sum(len(line.get_xdata()) for line in ax.lines if line.get_label() == "end")
    assert ends == (graph.nodes["kind"] == "end").sum()
    lines = [line for line in ax.lines if line.get_linestyle() == "-"]
    assert len(lines) == len(graph.edges["length"])
    bottom, top = ax.get_ylim()
    assert bottom > top
    graph.plot(ax)
    assert ax.get_ylim() == (bottom, top)


def test_the_main_path_of_a_tree_leaves_out_its_short_branch():
    path = thinbench.skeleton_graph(TREE).main_path()
    assert path.length == pytest.approx(6 + 4 * 2**0.5)
    assert path.points.tolist() == [[0, 0], [1, 1], *[[2, x] for x in range(2, 9)], [1, 9], [0, 10]]
    assert len(path.nodes) == 3 and len(path.edges) == 2
    uneven = thinbench.skeleton_graph(TREE, spacing=(0.5, 2)).main_path()
    assert uneven.length == pytest.approx(6 * 2 + 4 * (4 + 0.25) ** 0.5)


def test_the_main_path_is_the_longest_of_those_of_the_components():
    graph = thinbench.skeleton_graph(drawn("##.#", "....", "###."))
    assert [path.length for path in graph.main_paths()] == [1, 0, 2] and graph.main_path().length == 2


RING = drawn(".#####.",
             ".#...#.",
             ".#...#.",
             ".#####.")


def test_the_main_path_of_a_ring_is_half_of_it_and_ends_within_its_edge():
    graph = thinbench.skeleton_graph(np.pad(RING, 1), np.ones((6, 9), bool) & (np.arange(6) > 0)[:, None])
    path = graph.main_path()
    assert path.length == 7 and path.nodes.tolist() == [0] and path.edges.tolist() == [0]
    assert (path.first_point, path.last_point) == (None, 7) and graph.edge_points(0)[path.last_point].tolist() == [4, 6]
    assert path.points.tolist() == [[1, x] for x in range(2, 7)] + [[y, 6] for y in range(2, 5)]
    assert graph.path_widths(path).tolist() == [2] * 5 + [4, 6, 8]
    with pytest.raises(ValueError, match="path_widths: expected a skeleton_graph"):
        thinbench.skeleton_graph(RING).path_widths(path)


@pytest.mark.parametrize("seed", range(40))
def test_pixels_of_main_paths_have_their_length_whatever_the_order_of_edges(seed):
    skeleton = thinbench.thin(np.random.RandomState(seed).rand(12, 14) < 0.6 + seed / 100)
    graph = thinbench.skeleton_graph(skeleton, spacing=(1, 1) if seed % 2 else (0.3, 2), not_thin="ignore")
    backwards = graph.subgraph(np.arange(len(graph.edges["from"]))[::-1])
    lengths = [sorted(path.length for path in part.main_paths() if len(path.edges)) for part in (graph, backwards)]
    np.testing.assert_allclose(*lengths)
    for part in (graph, backwards):
        nodes = np.full(part.shape, -1)
        for node in range(len(part.nodes["kind"])):
            nodes[tuple(part.node_pixels(node).T)] = node
        for path in part.main_paths():
            along = nodes[tuple(path.points.T)]
            is_within = (along[1:] == along[:-1]) & (along[1:] >= 0)  # it goes straight on, without length
            steps = np.hypot(*(np.diff(path.points, axis=0) * part.spacing).T)
            assert steps[~is_within].sum() == pytest.approx(path.length)


def test_edge_labels_tell_lines_apart_that_meet_at_a_junction():
    graph = thinbench.skeleton_graph(TREE)
    expected = np.zeros(TREE.shape, np.int32)
    for edge in range(3):
        expected[tuple(graph.edge_points(edge).T)] = edge + 1
    expected[tuple(graph.node_pixels(2).T)] = 0
    np.testing.assert_array_equal(graph.edge_labels(), expected)
    assert graph.edge_labels().dtype == np.int32
    np.testing.assert_array_equal(thinbench.skeleton_graph(RING).edge_labels(), RING)
    assert graph.subgraph([2]).edge_labels()[2, 5] == 1
    assert thinbench.skeleton_graph(np.zeros((2, 3), bool)).edge_labels().tolist() == [[0] * 3] * 2


def test_smoothed_lengths_are_those_of_the_polylines():
    graph = thinbench.skeleton_graph(drawn("###......", "...###...", "......###"), spacing=(2, 1))
    assert graph.smoothed_lengths().tolist() == [np.hypot(8, 4)]
    tree = thinbench.skeleton_graph(TREE, spacing=(2, 1))
    np.testing.assert_allclose(tree.smoothed_lengths(0), tree.edges["length"])
    assert tree.summary(tolerance=0)["smoothed-length"].tolist() == tree.smoothed_lengths(0).tolist()
    assert len(thinbench.skeleton_graph(np.zeros((2, 3), bool)).smoothed_lengths()) == 0


def test_parents_lead_to_the_root_of_a_tree():
    graph = thinbench.skeleton_graph(np.vstack([TREE, np.zeros_like(TREE[:1]), TREE[:1]]))
    assert graph.parents(3)[:4].tolist() == [2, 2, 3, -1]
    assert graph.parents(0).tolist() == [-1, 2, 0, 2, -1, -1]
    with pytest.raises(ValueError, match="root: expected a number from 0 to 5, got 6"):
        graph.parents(6)
    eight = thinbench.skeleton_graph(EIGHT)
    with pytest.raises(ValueError, match="root: expected a node of a tree, got 1 in a component with 2 cycles"):
        eight.parents(1)
    assert (np.sort(eight.open_cycles().parents(1)) >= 0).sum() == len(eight.nodes["kind"]) - 1


def test_the_summary_has_means_and_deviations_of_an_image_along_edges():
    graph = thinbench.skeleton_graph(TREE)
    image = np.random.RandomState(3).rand(*TREE.shape)
    table = graph.summary(image=image)
    values = [image[tuple(graph.edge_points(edge).T)] for edge in range(3)]
    np.testing.assert_allclose(table["mean-pixel-value"], [np.mean(v) for v in values])
    np.testing.assert_allclose(table["stdev-pixel-value"], [np.std(v) for v in values])
    assert "mean-pixel-value" not in graph.summary()
    with pytest.raises(ValueError, match=r"image: expected the skeleton's shape \(5, 11\), got \(2, 2\)"):
        graph.summary(image=image[:2, :2])


def test_cycles_close_by_their_longest_edge():
    graph = thinbench.skeleton_graph(EIGHT)
    cycles = graph.cycles()
    assert len(cycles) == 2
    for cycle in cycles:
        assert graph.edges["length"][cycle.edges[-1]] == graph.edges["length"][cycle.edges].max()
        assert cycle.points[0].tolist() == cycle.points[-1].tolist()


def test_points_of_a_cycle_end_with_the_first_where_it_meets_a_junction_in_two_pixels():
    graph = thinbench.skeleton_graph(drawn("...####", "...#..#", "..##..#", "#######", "...#..."), not_thin="ignore")
    cycle, = graph.cycles()
    assert cycle.points[[0, -2, -1]].tolist() == [[2, 3], [3, 3], [2, 3]]
    assert cycle.length == 11 and len(cycle.points) == 13  # 11 steps, and one within the junction


def test_open_cycles_takes_the_longest_edge_of_short_cycles_only():
    graph = thinbench.skeleton_graph(EIGHT)
    lengths = sorted(cycle.length for cycle in graph.cycles())
    assert len(graph.open_cycles(lengths[0] - 1).edges["from"]) == len(graph.edges["from"])
    assert len(graph.open_cycles(lengths[-1]).edges["from"]) == len(graph.edges["from"]) - 2


def test_the_summary_has_the_columns_of_skan_and_the_values_of_a_table_by_hand():
    graph = thinbench.skeleton_graph(TREE, spacing=(2, 1))
    table = graph.summary()
    assert list(table["skeleton-id"]) == [0, 0, 0]
    assert table["node-id-src"].tolist() == [0, 1, 2] and table["node-id-dst"].tolist() == [2, 2, 3]
    np.testing.assert_allclose(table["branch-distance"], [2 * 5**0.5 + 2, 2 * 5**0.5 + 2, 4], atol=1)
    assert table["image-coord-src-0"].tolist() == [0, 0, 2] and table["coord-dst-0"][2] == 8
    np.testing.assert_allclose(table["tortuosity"], table["branch-distance"] / table["euclidean-distance"])
    assert "branch_distance" in graph.summary(separator="_")
    assert not any(np.shares_memory(column, own) for column in table.values() for own in graph.edges.values())


@pytest.mark.parametrize(("lines", "types"), [
    (TREE, {1}), (drawn("###"), {0}), (drawn(".#.", "#.#", ".#."), {3}), (EIGHT, {1, 2})])
def test_branch_types_are_those_of_ends_junctions_and_closed_lines(lines, types):
    table = thinbench.skeleton_graph(lines).summary()
    assert set(table["branch-type"].tolist()) == types and np.isnan(table["tortuosity"]).all() == (types == {3})


def test_a_subgraph_has_the_edges_that_are_asked_for_and_their_nodes():
    graph = thinbench.skeleton_graph(TREE)
    long = graph.subgraph(graph.edges["length"] > 4)
    assert len(long.edges["from"]) == 2 and long.nodes["kind"].tolist() == ["end", "end", "junction"]
    assert long.nodes["degree"].tolist() == [1, 1, 2]
    assert long.edge_points(1).tolist() == graph.edge_points(1).tolist()
    assert len(graph.subgraph([]).nodes["kind"]) == 0
    assert thinbench.skeleton_graph(TREE, spacing=(0.5, 2)).subgraph([0]).spacing == (0.5, 2)


def test_given_pixels_are_nodes_that_split_their_edges():
    graph = thinbench.skeleton_graph(TREE, nodes=[(2, 3), (0, 0)])
    assert graph.nodes["kind"].tolist() == ["end", "end", "junction", "end", "given"]
    assert len(graph.edges["from"]) == 4
    assert graph.edges["length"].sum() == pytest.approx(thinbench.skeleton_graph(TREE).edges["length"].sum())
    path = graph.shortest_path(4, 1)
    assert path.points[0].tolist() == [2, 3] and path.points[-1].tolist() == [0, 10]


def test_the_nearest_pixel_of_an_edge_is_found_in_the_unit_of_the_spacing():
    assert thinbench.skeleton_graph(TREE).nearest(4, 6) == (2, 4, 5, 1.0)
    assert thinbench.skeleton_graph(TREE, spacing=(1, 3)).nearest(4, 6)[1:] == (2, 6, 2.0)


@pytest.mark.filterwarnings("error")
def test_the_distance_of_a_far_point_is_a_number_as_long_as_there_is_one():
    graph = thinbench.skeleton_graph(TREE)
    assert graph.nearest(3e200, -4e200).distance == pytest.approx(5e200, rel=1e-15)
    assert graph.nearest(1e300, 0).distance == 1e300
    assert thinbench.skeleton_graph(TREE, spacing=1e30).nearest(1e300, 0).distance == np.inf


def by_a_loop(skeletons, labels):
    return [thinbench.skeleton_graph(skeletons == label, labels == label, not_thin="ignore")
            for label in np.unique(labels[labels != 0])]


@pytest.mark.parametrize("seed", range(30))
def test_the_graphs_of_labels_are_those_of_a_loop(seed):
    random = np.random.RandomState(seed)
    labels = np.kron(random.randint(0, 2 + seed % 5, (12, 15)), np.ones((1 + seed % 4,) * 2, int)) * 7
    skeletons = np.where(random.rand(*labels.shape) < 0.7, labels, 0)
    found = thinbench.graph_of_labels(skeletons, labels)
    graphs = by_a_loop(skeletons, labels)
    first = np.cumsum([0] + [len(graph.nodes["kind"]) for graph in graphs])
    for name in graphs[0].edges:
        shift = first if name in ("from", "to") else np.zeros(len(first))
        expected = [graph.edges[name] + more for graph, more in zip(graphs, shift)]
        np.testing.assert_array_equal(found.edges[name], np.concatenate(expected))
    for name in set(graphs[0].nodes) - {"component"}:
        np.testing.assert_array_equal(found.nodes[name], np.concatenate([graph.nodes[name] for graph in graphs]))
    assert found.summary()["label"].tolist() == found.edges["label"].tolist()
    assert set(found.nodes["label"]) == set(skeletons[skeletons != 0])


@pytest.mark.parametrize("seed", range(20))
def test_labels_are_pruned_as_if_each_were_alone(seed):
    random = np.random.RandomState(seed)
    labels = np.kron(random.randint(0, 5, (12, 15)), np.ones((2, 2), int)) * 300
    skeletons = np.where(random.rand(*labels.shape) < 0.6, labels, 0)
    expected = np.zeros_like(skeletons)
    for label in np.unique(labels[labels != 0]):
        kept = thinbench.prune(skeletons == label, 2, min_widths=0.5, image=labels == label, removes_components=True)
        expected[kept] = label
    found = thinbench.prune_labels(skeletons, 2, min_widths=0.5, labels=labels, removes_components=True)
    assert found.dtype == skeletons.dtype
    np.testing.assert_array_equal(found, expected)


def test_the_medial_axis_is_the_skeleton_with_its_distances():
    image = random_image(5)
    skeleton, distances = thinbench.medial_axis(image, "zhang_suen", spacing=(2, 1))
    np.testing.assert_array_equal(skeleton, thinbench.thin(image, "zhang_suen"))
    np.testing.assert_array_equal(distances, np.where(skeleton, thinbench.distances(image, spacing=(2, 1)), 0))
