"""Distances, graphs and pruning: equal to SciPy's where it has them, to what is known otherwise."""

from __future__ import annotations

import json
import warnings

import numpy as np
import pytest
from scipy import ndimage
from scipy.sparse import csgraph

import thinbench
from images import random_image

RING_WITH_TAILS = np.array([[0, 0, 0, 1, 1, 0, 0, 0],
                            [1, 1, 1, 0, 0, 1, 1, 1],
                            [0, 0, 0, 1, 1, 0, 0, 0]], bool)


@pytest.mark.parametrize("share", [0.5, 0.9, 0.999])
def test_distances_equal_scipys(share):
    image = np.random.RandomState(1).rand(150, 200) < share
    image[70, 90] = False
    np.testing.assert_array_equal(thinbench.distance(image), ndimage.distance_transform_edt(image))
    np.testing.assert_array_equal(thinbench.distance(image, threads=2, squared=True),
                                  np.rint(ndimage.distance_transform_edt(image) ** 2))


def test_without_background_distances_are_infinite():
    assert (thinbench.distance(np.ones((3, 4), bool)) == np.inf).all()
    assert (thinbench.distance(np.ones((3, 4), bool), squared=True) == 2**31 - 1).all()


def test_distances_of_views_of_any_strides_equal_those_of_copies():
    image = np.random.RandomState(2).rand(40, 60) < 0.9
    for view in (image[::2, ::3], image.T, image[::-1]):
        np.testing.assert_array_equal(thinbench.distance(view), thinbench.distance(view.copy()))


def test_a_ring_with_tails_has_parallel_edges():
    graph = thinbench.graph(RING_WITH_TAILS)
    assert list(graph.nodes["kind"]) == ["end", "junction", "junction", "end"]
    assert list(graph.nodes["degree"]) == [1, 3, 3, 1]
    assert sorted(zip(graph.edges["from"], graph.edges["to"], strict=True)) == [(0, 1), (1, 2), (1, 2), (2, 3)]
    np.testing.assert_allclose(graph.edges["length"], [2, 1 + 2 * 2**0.5, 1 + 2 * 2**0.5, 2])
    np.testing.assert_allclose(graph.edges["chord"], [2, 3, 3, 2])
    assert graph.edge_pixels(0).tolist() == [[1, 0], [1, 1], [1, 2]]
    assert graph.node_pixels(1).tolist() == [[1, 2]]


def test_nodes_minus_edges_is_the_euler_number_and_every_pixel_is_once():
    for seed in range(20):
        skeleton = thinbench.thin(random_image(seed))
        graph = thinbench.graph(skeleton, not_thin="ignore")
        edges = graph.edges["from"]
        assert len(graph.nodes["kind"]) - len(edges) == thinbench.euler_number(skeleton)
        pixels = [graph.node_pixels(n) for n in range(len(graph.nodes["kind"]))]
        pixels += [graph.edge_pixels(e)[1:-1] for e in range(len(edges))]
        drawn = np.zeros(skeleton.shape, int)
        np.add.at(drawn, tuple(np.concatenate(pixels).T), 1)
        np.testing.assert_array_equal(drawn, skeleton != 0)


def test_widths_are_those_of_the_image():
    image = np.zeros((9, 30), bool)
    image[1:8, 1:29] = True
    skeleton = np.zeros_like(image)
    skeleton[4, 5:25] = True
    graph = thinbench.graph(skeleton, image)
    assert [graph.edges[f"width-{name}"].tolist() for name in ("mean", "min", "max")] == [[8], [8], [8]]


def test_without_background_widths_are_infinite():
    line = np.ones((1, 5), bool)
    edges = thinbench.graph(line, line).edges
    assert [edges[f"width-{name}"].tolist() for name in ("mean", "min", "max")] == [[np.inf]] * 3


def test_shortest_paths_by_scipy():
    graph = thinbench.graph(RING_WITH_TAILS)
    distances = csgraph.shortest_path(graph.to_csgraph())
    assert distances[0, 3] == pytest.approx(4 + 1 + 2 * 2**0.5)


def test_networkx_graph_has_the_columns():
    pytest.importorskip("networkx")
    graph = thinbench.graph(RING_WITH_TAILS).to_networkx()
    assert (graph.number_of_nodes(), graph.number_of_edges()) == (4, 4)
    assert graph.nodes[1]["kind"] == "junction"
    assert len(graph[1][2]) == 2 and graph[0][1][0]["pixels"].shape == (3, 2)


def test_empty_images_have_empty_graphs():
    for shape in ((0, 5), (5, 0), (3, 3)):
        graph = thinbench.graph(np.zeros(shape, bool))
        assert len(graph.nodes["kind"]) == len(graph.edges["from"]) == 0


def test_pruning_removes_spurs():
    line = np.zeros((4, 20), np.uint8)
    line[3, :] = 255
    line[1:3, 10] = 255
    expected = line.copy()
    expected[1:3, 10] = 0
    np.testing.assert_array_equal(thinbench.prune(line, 2.5), expected)
    np.testing.assert_array_equal(thinbench.prune(line, 2), line)
    image = np.ones_like(line)
    image[0] = 0
    np.testing.assert_array_equal(thinbench.prune(line, min_widths=1, image=image), expected)


def test_unsuitable_arguments_are_named():
    line = np.ones((1, 5), bool)
    with pytest.raises(ValueError, match="min_length"):
        thinbench.prune(line, -1)
    with pytest.raises(ValueError, match="min_widths"):
        thinbench.prune(line, min_widths=1)
    with pytest.raises(ValueError, match="image: expected the skeleton's shape"):
        thinbench.graph(line, np.ones((2, 5), bool))
    with pytest.raises(ValueError, match="32767"):
        thinbench.distance(np.ones((1, 40000), bool))


def test_classes_and_degrees_of_pixels_follow_the_definition():
    image = np.array([[1, 0, 1, 1, 1, 0, 0],
                      [0, 0, 0, 0, 1, 0, 1],
                      [1, 1, 0, 0, 1, 1, 1],
                      [1, 1, 0, 0, 0, 0, 1]], bool)
    classes, degrees = thinbench.classify_pixels(image)
    assert [thinbench.PIXEL_CLASSES[c] for c in classes[0, :4]] == ["isolated", "background", "end", "line"]
    assert [thinbench.PIXEL_CLASSES[c] for c in classes[2, 4:]] == ["line", "line", "junction"]
    assert thinbench.PIXEL_CLASSES[classes[3, 1]] == "junction"
    assert degrees[2].tolist() == [2, 2, 0, 0, 2, 2, 3]


def test_polylines_keep_what_is_farther_than_the_tolerance():
    skeleton = np.zeros((4, 7), bool)
    skeleton[[0, 1, 2, 3, 2, 1, 0], range(7)] = True
    graph = thinbench.graph(skeleton)
    assert [line.tolist() for line in graph.polylines(1)] == [[[0, 0], [3, 3], [0, 6]]]
    assert [line.tolist() for line in graph.polylines(3)] == [[[0, 0], [0, 6]]]
    with pytest.raises(ValueError, match="tolerance: expected a finite number of at least 0, got nan"):
        graph.polylines(np.nan)


def test_geojson_has_transformed_points_and_lines():
    found = thinbench.graph(RING_WITH_TAILS).to_geojson(transform=(2, 0, 100, 0, -2, 50))
    points = [f for f in found["features"] if f["geometry"]["type"] == "Point"]
    lines = [f for f in found["features"] if f["geometry"]["type"] == "LineString"]
    assert json.loads(json.dumps(found)) == found
    assert len(points) == len(lines) == 4
    assert points[0]["geometry"]["coordinates"] == [101, 47]
    assert lines[0]["geometry"]["coordinates"] == [[101, 47], [105, 47]]
    assert points[1]["properties"] == {"id": 2, "kind": "junction", "degree": 3}
    assert lines[0]["properties"] == {"id": 1, "from": 1, "to": 2, "pixels": 1, "length": 2, "chord": 2}
    with pytest.raises(ValueError, match="transform: expected finite numbers, got inf"):
        thinbench.graph(RING_WITH_TAILS).to_geojson(transform=(1e308, 1e308, 1e308, 0, 1, 0))
    with pytest.raises(ValueError, match="transform: expected finite numbers, got nan"):
        thinbench.graph(RING_WITH_TAILS).to_geojson(transform=(1, 0, 0, 0, np.nan, 0))
    with pytest.raises(ValueError, match="transform: expected 6 numbers, got 5"):
        thinbench.graph(RING_WITH_TAILS).to_geojson(transform=(1, 0, 0, 0, 1))


def test_blocks_of_an_image_that_is_not_thin_are_reported():
    thick = np.zeros((5, 9), bool)
    thick[1:3, 4:7] = True
    message = "skeleton: not thin: 2 blocks of 2 x 2 pixels, the first at row 1, column 4"
    with pytest.warns(UserWarning, match=message):
        thinbench.graph(thick)
    with pytest.raises(ValueError, match=message):
        thinbench.graph(thick, not_thin="raise")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert thinbench.graph(thick, not_thin="ignore").nodes["kind"].tolist() == ["junction"]
    with pytest.raises(ValueError, match="not_thin: expected 'warn', 'raise' or 'ignore', got 'stop'"):
        thinbench.graph(thick, not_thin="stop")


def test_geojson_of_widths_without_background_is_json():
    line = np.ones((1, 9), bool)
    found = thinbench.graph(line, line).to_geojson()
    assert found["features"][2]["properties"]["width_min"] is None
    json.dumps(found, allow_nan=False)


def test_edges_without_cost_remain_in_csgraph():
    graph = thinbench.graph(RING_WITH_TAILS)
    graph.edges["cost"] = np.arange(4.0)
    costs = csgraph.shortest_path(graph.to_csgraph("cost"), directed=False)
    assert costs[0].tolist() == [0, 0, 1, 4]


def test_number_beyond_floats_is_named():
    with pytest.raises(ValueError, match=r"min_length: expected less than 2\*\*1024 in magnitude"):
        thinbench.prune(RING_WITH_TAILS, 10**400)


@pytest.mark.parametrize("value", ["a", None, [1, 2]])
def test_what_is_no_number_is_named(value):
    with pytest.raises(TypeError, match="min_length: expected a number, got"):
        thinbench.prune(RING_WITH_TAILS, value)
    with pytest.raises(TypeError, match="tolerance: expected a number, got"):
        thinbench.graph(RING_WITH_TAILS).polylines(value)


def test_distances_are_written_into_the_array_that_is_given():
    image = random_image(3)
    for squared, dtype in ((False, np.float64), (True, np.int32)):
        out = np.empty(image.shape, dtype)
        assert thinbench.distance(image, squared=squared, out=out) is out
        np.testing.assert_array_equal(out, thinbench.distance(image, squared=squared))
    with pytest.raises(ValueError, match="out: expected float64"):
        thinbench.distance(image, out=np.empty(image.shape, np.int32))
    thinbench.release_memory()
