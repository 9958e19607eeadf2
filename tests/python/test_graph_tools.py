"""Main paths, cycles, tables and graphs of labels: drawn graphs with known answers, loops, networkx."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from scipy import ndimage

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


def test_the_main_path_of_a_tree_leaves_out_its_short_branch():
    path = thinbench.graph(TREE).main_path()
    assert path.length == pytest.approx(6 + 4 * 2**0.5)
    assert path.pixels.tolist() == [[0, 0], [1, 1], *[[2, x] for x in range(2, 9)], [1, 9], [0, 10]]
    assert len(path.nodes) == 3 and len(path.edges) == 2


def test_main_paths_are_in_the_unit_of_the_spacing():
    graph = thinbench.graph(TREE, spacing=(0.5, 2))
    assert graph.main_path().length == pytest.approx(6 * 2 + 4 * (4 + 0.25) ** 0.5)
    assert graph.edges["chord"].max() == pytest.approx((25 + 1) ** 0.5 * 2, abs=1)


def test_there_is_a_main_path_for_each_component_and_none_without_nodes():
    graph = thinbench.graph(drawn("##.#", "....", "###."))
    assert [path.length for path in graph.main_paths()] == [1, 0, 2]
    assert graph.main_path().pixels.tolist() == [[2, 0], [2, 1], [2, 2]]
    with pytest.raises(ValueError, match="main_path: expected a graph with nodes, got none"):
        thinbench.graph(np.zeros((3, 3), bool)).main_path()


def test_main_paths_equal_those_by_networkx():
    networkx = pytest.importorskip("networkx")
    for seed in range(15):
        graph = thinbench.graph(thinbench.thin(random_image(seed)), not_thin="ignore")
        lengths = []
        other = networkx.from_scipy_sparse_array(graph.to_csgraph())
        for nodes in sorted(networkx.connected_components(other), key=min):
            part = other.subgraph(nodes)
            ways = dict(networkx.all_pairs_dijkstra_path_length(part))
            lengths.append(max(max(way.values()) for way in ways.values()))
        np.testing.assert_allclose([path.length for path in graph.main_paths()], lengths)


def test_cycles_close_by_their_longest_edge_and_know_their_holes():
    graph = thinbench.graph(EIGHT)
    cycles = graph.cycles()
    assert len(cycles) == 2
    assert sorted(len(cycle.holes) for cycle in cycles) == [1, 1]
    assert sorted(hole for cycle in cycles for hole in cycle.holes.tolist()) == [[1, 1], [1, 5]]
    for cycle in cycles:
        assert graph.edges["length"][cycle.edges[-1]] == graph.edges["length"][cycle.edges].max()
        assert cycle.pixels[0].tolist() == cycle.pixels[-1].tolist()


def test_a_cycle_round_another_encloses_both_holes():
    ring = drawn("#######",
                 "#..#..#",
                 "#.#.#.#",
                 "#..#..#",
                 "#.....#",
                 "#######")
    assert sorted(len(cycle.holes) for cycle in thinbench.graph(ring, not_thin="ignore").cycles()) == [1, 2]


def test_there_are_as_many_cycles_as_edges_minus_nodes_plus_components():
    for seed in range(10):
        graph = thinbench.graph(thinbench.thin(random_image(seed)), not_thin="ignore")
        nodes, edges = len(graph.nodes["kind"]), len(graph.edges["from"])
        components = int(graph.nodes["component"].max()) + 1
        assert len(graph.cycles()) == edges - nodes + components
        assert components == ndimage.label(thinbench.thin(random_image(seed)), np.ones((3, 3)))[1]
        opened = graph.open_cycles()
        assert opened.cycles() == [] and opened.nodes["component"].max() + 1 == components


def test_open_cycles_takes_the_longest_edge_of_short_cycles_only():
    graph = thinbench.graph(EIGHT)
    lengths = sorted(cycle.length for cycle in graph.cycles())
    assert len(graph.open_cycles(lengths[0] - 1).edges["from"]) == len(graph.edges["from"])
    assert len(graph.open_cycles(lengths[-1]).edges["from"]) == len(graph.edges["from"]) - 2


def test_widths_are_known_at_each_pixel_and_of_nodes():
    image = np.ones((5, 9), bool)
    image[0] = image[-1] = False
    skeleton = drawn(".........", ".........", "#########", ".........", ".........")
    graph = thinbench.graph(skeleton, image)
    assert graph.edge_widths(0).tolist() == [4] * 9
    assert graph.edges["width-median"].tolist() == [4] and graph.nodes["width"].tolist() == [4, 4]
    graph = thinbench.graph(skeleton, image, spacing=0.5)
    assert graph.edges["width-mean"].tolist() == [2] and graph.edges["length"].tolist() == [4]
    with pytest.raises(ValueError, match="edge_widths: expected a graph"):
        thinbench.graph(skeleton).edge_widths(0)


def test_the_summary_has_the_columns_of_skan_and_the_values_of_a_table_by_hand():
    graph = thinbench.graph(TREE, spacing=(2, 1))
    table = graph.summary()
    assert list(table["branch-type"]) == [1, 1, 1]
    assert list(table["skeleton-id"]) == [0, 0, 0]
    assert table["node-id-src"].tolist() == [0, 1, 2] and table["node-id-dst"].tolist() == [2, 2, 3]
    np.testing.assert_allclose(table["branch-distance"], [2 * 5**0.5 + 2, 2 * 5**0.5 + 2, 4], atol=1)
    assert table["image-coord-src-0"].tolist() == [0, 0, 2] and table["coord-dst-0"][2] == 8
    np.testing.assert_allclose(table["tortuosity"], table["branch-distance"] / table["euclidean-distance"])
    assert "branch_distance" in graph.summary(separator="_")


def test_branch_types_are_those_of_ends_junctions_and_closed_lines():
    line = thinbench.graph(drawn("###")).summary()
    ring = thinbench.graph(drawn(".#.", "#.#", ".#.")).summary()
    eight = thinbench.graph(EIGHT).summary()
    assert line["branch-type"].tolist() == [0] and ring["branch-type"].tolist() == [3]
    assert np.isnan(ring["tortuosity"]).all() and set(eight["branch-type"].tolist()) == {1, 2}


def test_a_subgraph_has_the_edges_that_are_asked_for_and_their_nodes():
    graph = thinbench.graph(TREE)
    long = graph.subgraph(graph.edges["length"] > 4)
    assert len(long.edges["from"]) == 2 and long.nodes["kind"].tolist() == ["end", "end", "junction"]
    assert long.nodes["degree"].tolist() == [1, 1, 2]
    assert long.edge_pixels(1).tolist() == graph.edge_pixels(1).tolist()
    assert len(graph.subgraph([]).nodes["kind"]) == 0
    with pytest.raises(ValueError, match="edges: expected a bool for each of 3 edges"):
        graph.subgraph(np.array([True]))


def test_given_pixels_are_nodes_that_split_their_edges():
    graph = thinbench.graph(TREE, nodes=[(2, 3), (0, 0)])
    assert graph.nodes["kind"].tolist() == ["end", "end", "junction", "end", "given"]
    assert len(graph.edges["from"]) == 4
    assert graph.edges["length"].sum() == pytest.approx(thinbench.graph(TREE).edges["length"].sum())
    path = graph.shortest_path(4, 1)
    assert path.pixels[0].tolist() == [2, 3] and path.pixels[-1].tolist() == [0, 10]
    with pytest.raises(ValueError, match="nodes: expected pixels of the skeleton, got row 4, column 0"):
        thinbench.graph(TREE, nodes=[(4, 0)])
    with pytest.raises(ValueError, match="nodes: expected pixels of the skeleton, got row -1, column 0"):
        thinbench.graph(TREE, nodes=[(-1, 0)])


def test_the_nearest_pixel_of_an_edge_is_found_in_the_unit_of_the_spacing():
    assert thinbench.graph(TREE).nearest(4, 6) == (2, 4, 5, 1.0)
    assert thinbench.graph(TREE, spacing=(1, 3)).nearest(4, 7)[1:] == (2, 7, 2.0)


def test_there_is_no_path_between_components():
    with pytest.raises(ValueError, match="no path leads from node 0 to node 2"):
        thinbench.graph(drawn("##.##")).shortest_path(0, 2)
    with pytest.raises(ValueError, match="expected numbers of nodes from 0 to 3, got 4"):
        thinbench.graph(drawn("##.##")).shortest_path(0, 4)


def by_a_loop(skeletons, labels):
    return [thinbench.graph(skeletons == label, labels == label, not_thin="ignore")
            for label in np.unique(labels[labels != 0])]


@pytest.mark.parametrize("seed", range(30))
def test_the_graphs_of_labels_are_those_of_a_loop(seed):
    random = np.random.RandomState(seed)
    labels = np.kron(random.randint(0, 2 + seed % 5, (12, 15)), np.ones((1 + seed % 4,) * 2, int)) * 7
    skeletons = np.where(random.rand(*labels.shape) < 0.7, labels, 0)
    found = thinbench.graph_labels(skeletons, labels)
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
        kept = thinbench.prune(skeletons == label, 2, min_widths=0.5, image=labels == label, remove_components=True)
        expected[kept] = label
    found = thinbench.prune_labels(skeletons, 2, min_widths=0.5, labels=labels, remove_components=True)
    assert found.dtype == skeletons.dtype
    np.testing.assert_array_equal(found, expected)
    with pytest.raises(ValueError, match="min_widths: expected labels=..., what was thinned"):
        thinbench.prune_labels(skeletons, min_widths=1)


def test_label_images_of_other_shapes_are_rejected_and_empty_ones_have_no_graph():
    assert len(thinbench.graph_labels(np.zeros((3, 4), int)).nodes["kind"]) == 0
    with pytest.raises(ValueError, match=r"labels: expected the skeletons' shape \(3, 4\), got \(3, 3\)"):
        thinbench.graph_labels(np.zeros((3, 4), int), np.zeros((3, 3), int))


@pytest.mark.parametrize("sampling", [2, (1, 3), (0.25, 0.7), [1e-3, 40]])
def test_distances_with_sampling_equal_scipys(sampling):
    for seed in range(20):
        image = np.random.RandomState(seed).rand(40, 60) < 0.5 + seed / 41
        image[seed, 5] = False
        np.testing.assert_array_max_ulp(thinbench.distance(image, sampling=sampling),
                                        ndimage.distance_transform_edt(image, sampling=sampling), maxulp=1)


def test_unsuitable_spacings_are_rejected():
    for spacing, message in ((0, "from 1e-30 to 1e30, got 0"), ((1, 2, 3), "a number or two"), (np.nan, "got nan")):
        with pytest.raises(ValueError, match=message):
            thinbench.graph(TREE, spacing=spacing)
    with pytest.raises(ValueError, match="squared: expected no sampling beside it, got 2"):
        thinbench.distance(TREE, sampling=2, squared=True)


def test_pruning_is_in_the_unit_of_the_spacing():
    assert thinbench.prune(TREE, 3)[3:].sum() == 0
    assert thinbench.prune(TREE, 3, spacing=2)[3:].sum() == 2
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert thinbench.prune(TREE, min_widths=2, image=TREE, spacing=0.1)[3:].sum() == 0


def test_the_medial_axis_is_the_skeleton_with_its_distances():
    image = random_image(5)
    skeleton, distances = thinbench.medial_axis(image, "zhang_suen", spacing=(2, 1))
    np.testing.assert_array_equal(skeleton, thinbench.thin(image, "zhang_suen"))
    np.testing.assert_array_equal(distances, np.where(skeleton, thinbench.distance(image, sampling=(2, 1)), 0))
    with pytest.raises(ValueError, match=r"\(2, 3, 4\)"):
        thinbench.medial_axis(np.zeros((2, 3, 4), bool))
