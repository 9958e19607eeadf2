"""What cannot be is rejected in one line that has the value; nothing is written."""

from __future__ import annotations

import math

import numpy as np
import pytest

import thinbench
from thinbench import Rule, compat

IMAGE = np.ones((4, 4), bool)
GREY = np.ones((4, 4), np.uint8)
LABELS = np.ones((4, 4), np.int32)
PACKED = np.packbits(IMAGE, axis=-1)
LINE = np.ones((1, 5), bool)
GRAPH = thinbench.skeleton_graph(LINE)
TABLE = np.zeros(512, bool)
MAP = np.pad(np.ones((31, 91), bool), 5)
LIFE = Rule.from_hensel("B3/S23")
SCIPY, SKIMAGE, CV2 = compat.ndimage, compat.skimage, compat.cv2


def assert_rejected(error, said, function, *arguments, **options):
    """`said` is in the message as it stands."""
    with pytest.raises(error, match="^[^\n]*$") as caught:
        function(*arguments, **options)
    assert said in str(caught.value)


THINNING = {
    "thin": (thinbench.thin, IMAGE), "thin_labels": (thinbench.thin_labels, LABELS),
    "thin_packed": (thinbench.thin_packed, PACKED, 4),
    "thin_many": (thinbench.thin_many, [IMAGE]), "thin_many of none": (thinbench.thin_many, [])}


@pytest.mark.parametrize("function", THINNING)
@pytest.mark.parametrize(("options", "error", "said"), [
    ({"rule": "zhang"}, ValueError, "'zhang'"),
    ({"rule": 7}, TypeError, "got int"),
    ({"rule": LIFE}, ValueError, "max_iterations"),
    ({"rule": "life", "max_iterations": 2**31 - 1}, ValueError, "max_iterations"),
    ({"rule": "mb2", "border": "foreground"}, ValueError, "foreground"),
    ({"border": "wrap"}, ValueError, "'wrap'"),
    ({"max_iterations": 0}, ValueError, "got 0"),
    ({"max_iterations": 1.5}, TypeError, "1.5"),
    ({"max_iterations": 2**40}, ValueError, str(2**40)),
    ({"threads": 0}, ValueError, "got 0"),
    ({"threads": True}, TypeError, "True"),
], ids=str)
def test_options_of_thinning(function, options, error, said):
    call, *arguments = THINNING[function]
    out = arguments[0].copy() if function in ("thin", "thin_labels", "thin_packed") else None
    assert_rejected(error, said, call, *arguments, **options | ({} if out is None else {"out": out}))
    assert out is None or np.array_equal(out, arguments[0])


def read_only(array):
    array.flags.writeable = False
    return array


WRITING = {
    "thin": (thinbench.thin, IMAGE), "thin_labels": (thinbench.thin_labels, LABELS),
    "thin_packed": (thinbench.thin_packed, np.zeros((4, 4), np.uint8), 32),
    "fill_holes": (thinbench.fill_holes, IMAGE),
    "distances": (lambda image, out: thinbench.distances(image, out=out), IMAGE.astype(float)),
    "squared_distances": (lambda image, out: thinbench.squared_distances(image, out=out), IMAGE.astype(np.int32))}


@pytest.mark.parametrize("function", WRITING)
@pytest.mark.parametrize(("change", "error", "said"), [
    (lambda out: out[:, ::2], ValueError, "(4, 2)"),
    (lambda out: out.T[::-1], ValueError, "strides"),
    (read_only, ValueError, "read-only"),
    (lambda out: [[0]], TypeError, "list"),
    (lambda out: out.astype("i8"), ValueError, "int64")])
def test_arrays_for_the_result(function, change, error, said):
    call, image, *arguments = WRITING[function]
    out = change(np.zeros_like(image))
    assert_rejected(error, said, call, IMAGE if "distances" in function else image, *arguments, out=out)
    assert not np.any(out)


ONE_IMAGE = [thinbench.fill_holes, thinbench.find_regions, thinbench.label_regions, thinbench.find_objects,
             thinbench.label_objects, thinbench.euler_number, thinbench.label_image, thinbench.distances,
             thinbench.squared_distances, thinbench.skeleton_graph, thinbench.prune, thinbench.medial_axis,
             thinbench.classify_pixels]


@pytest.mark.parametrize("function", [thinbench.fill_holes, thinbench.fill_holes_of_labels, thinbench.label_image,
                                      thinbench.find_regions, thinbench.euler_number])
@pytest.mark.parametrize(("threads", "error", "said"), [
    (0, ValueError, "got 0"), (2000, ValueError, "got 2000"), (1.5, TypeError, "threads: expected an integer, got 1.5"),
    (None, TypeError, "threads: expected an integer, got None")])
def test_threads(function, threads, error, said):
    assert_rejected(error, said, function, IMAGE, threads=threads)


@pytest.mark.parametrize("function", [thinbench.fill_holes, thinbench.fill_holes_of_labels, thinbench.label_image,
                                      thinbench.label_values, thinbench.euler_number])
def test_connectivity_is_given_by_its_name(function):
    assert_rejected(TypeError, "positional argument", function, IMAGE, 8)


@pytest.mark.parametrize("function", [thinbench.thin, *ONE_IMAGE])
@pytest.mark.parametrize(("image", "error", "said"), [
    (np.ones((4, 4)), TypeError, "float64"), (np.full((4, 4), np.nan), TypeError, "float64"),
    (np.ones((4, 4), object), TypeError, "object"), (np.ones((4, 4), np.int8), TypeError, "int8"),
    ([[1, 0]], TypeError, "int64"), (np.ones(4, bool), ValueError, "(4,)"),
    (np.ones((1, 2, 3, 4), bool), ValueError, "(1, 2, 3, 4)")], ids=str)
def test_images(function, image, error, said):
    assert_rejected(error, said, function, image)


@pytest.mark.parametrize("function", ONE_IMAGE)
def test_stacks_where_an_image_is_needed(function):
    assert_rejected(ValueError, "(2, 3, 4)", function, np.ones((2, 3, 4), bool))


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("dtype", [bool, np.uint8])
def test_a_channel_axis_is_no_stack_unless_it_is_said(channels, dtype):
    image = np.ones((20, 30, channels), dtype)
    assert_rejected(ValueError, f"shape (20, 30, {channels}), whose last axis looks like channels; ", thinbench.thin, image)
    assert thinbench.thin(image, stack=True).shape == image.shape


def every_compat_function():
    """Those that take an image and need no more."""
    yield lambda image: compat.bwmorph(image, "thin")
    for module, names in ((SCIPY, "label binary_fill_holes distance_transform_edt"),
                          (SKIMAGE, "thin skeletonize label remove_small_objects remove_small_holes regionprops_table"),
                          (CV2, "thinning connectedComponents connectedComponentsWithStats")):
        yield from (getattr(module, name) for name in names.split())
    yield lambda image: CV2.distanceTransform(image, 2, 0)


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize("function", [
    *ONE_IMAGE, thinbench.thin, thinbench.thin_labels, thinbench.detect_edges, thinbench.localise_objects,
    thinbench.fill_holes_of_labels, thinbench.label_values, thinbench.graph_of_labels, thinbench.prune_labels,
    lambda image: thinbench.thin_many([image]), lambda image: thinbench.find_path(image, (0, 0), (1, 1)),
    *every_compat_function()])
def test_channels_are_rejected_with_what_takes_one(function, channels):
    with pytest.raises((ValueError, NotImplementedError), match=r"^[^\n]*\[\.\.\., 0\]`[^\n]*$"):
        function(np.ones((20, 30, channels), np.uint8))


@pytest.mark.parametrize("function", [thinbench.thin, thinbench.distances, thinbench.detect_edges,
                                      thinbench.localise_objects, thinbench.binarise, thinbench.thin_labels,
                                      lambda packed: thinbench.thin_packed(packed, 40)])
def test_masked_elements_are_rejected(function):
    image = np.ma.masked_array(np.ones((4, 5), np.uint8), mask=np.zeros((4, 5), bool))
    function(image)
    image.mask[1, 2] = True
    assert_rejected(ValueError, "expected no masked elements, got 1", function, image)


@pytest.mark.parametrize(("call", "error", "said"), [
    (lambda: Rule(np.zeros(511, bool)), ValueError, "(511,)"),
    (lambda: Rule(np.zeros((0, 512), bool)), ValueError, "got 0"),
    (lambda: Rule(np.zeros((9, 512), bool)), ValueError, "got 9"),
    (lambda: Rule(np.zeros(512)), TypeError, "float64"),
    (lambda: Rule(np.full(512, 2)), ValueError, "got 2"),
    (lambda: Rule(TABLE, border="wrap"), ValueError, "'wrap'"),
    (lambda: Rule(TABLE, border=None), TypeError, "None"),
    (lambda: Rule(TABLE, max_iterations=0), ValueError, "got 0"),
    (lambda: Rule(TABLE, max_iterations=1.5), TypeError, "1.5"),
    (lambda: Rule.from_two_layer_net(np.ones((9, 8))), ValueError, "(9, 8)"),
    (lambda: Rule.from_two_layer_net(np.ones((9, 9)), "relu"), ValueError, "'relu'"),
    (lambda: Rule.from_two_layer_net([["1"] * 9] * 9), TypeError, "dtype"),
    (lambda: Rule.from_cluster([], []), ValueError, "last: expected shape (nets,) with at least one net, and"),
    (lambda: Rule.from_cluster([[99], [255]], np.ones((2, 9))), ValueError, "weights of shape (nets, 9); got (2, 1)"),
    (lambda: Rule.from_cluster([7.5], np.ones((1, 9))), TypeError, "7.5"),
    (lambda: Rule.from_cluster([99, 255], np.ones((1, 9))), ValueError, "(2, 9)"),
    (lambda: Rule.from_hensel("B3/S29"), ValueError, "column 6: expected"),
    (lambda: Rule.from_hensel("B3/S23\0x"), ValueError, "null character"),
    (lambda: Rule.from_hensel("B\u00e9\n"), ValueError, "column 2"),
    (lambda: Rule.from_hensel(3), TypeError, "3"),
    (lambda: Rule.from_patterns("4:(... .1. .0.)->0"), TypeError, "list of strings"),
    (lambda: Rule.from_patterns([3]), TypeError, "3"),
    (lambda: Rule.from_patterns(5), TypeError, "patterns: expected a list, got 5"),
    (lambda: Rule.from_function(5), TypeError, "next_value: expected a function, got 5"),
    (lambda: Rule.from_patterns(["4:(...)->1"]), ValueError, "pattern 1"),
    (lambda: Rule.from_values(TABLE, "raster"), ValueError, "'raster'"),
    (lambda: Rule.from_values(TABLE[:256]), ValueError, "(256,)"),
    (lambda: Rule.from_removals(TABLE), ValueError, "(512,)"),
    (lambda: Rule.from_removals(TABLE[:256], "matlab"), ValueError, "'matlab'"),
    (lambda: Rule.from_removals(np.zeros((0, 256), bool)), ValueError, "got 0"),
    (lambda: Rule.from_function(lambda window: 1 // 0), ZeroDivisionError, "zero"),
    (lambda: Rule.from_function(lambda window: None), ValueError, "next_value: expected True or False"),
    (lambda: Rule.from_function(np.sum), ValueError, "for each window, got 2"),
    (lambda: Rule.from_function(lambda window: window), ValueError, "for each window, got array"),
    (lambda: thinbench.thin(IMAGE, "B3/S23"), ValueError, "Rule.from_hensel takes a notation"),
    (lambda: Rule.named("Life"), ValueError, "got 'Life'"),
    (lambda: Rule.named(None), TypeError, "None"),
    (lambda: Rule.named("mb2").save("mb2.json"), ValueError, "'mb2' has no tables"),
    (lambda: Rule.named("spta"), ValueError, "got 'spta'"),
    (lambda: Rule.named("majorty"), ValueError, "did you mean 'majority'?"),
    (lambda: thinbench.thin(IMAGE, border="kep"), ValueError, "did you mean 'keep'?"),
    (lambda: thinbench.thin(np.ones((5, 6, 7), bool), stack=False), ValueError, "(H, W)"),
    *((lambda samples=samples: thinbench.thin(np.zeros((40, 60, samples), np.uint8)), ValueError,
       f"shape (40, 60, {samples}), whose last axis looks like channels; `thinbench.binarise(") for samples in (3, 4)),
    (lambda: thinbench.thin_many([np.ones((2, 2, 2), bool)]), ValueError, "(2, 2, 2)"),
    (lambda: thinbench.thin_many([IMAGE, GREY, np.ones((3, 3))]), TypeError, "images[2]: expected dtype"),
    (lambda: thinbench.thin_labels(LABELS.astype(float)), TypeError, "float64"),
    (lambda: thinbench.thin_labels(LABELS[0]), ValueError, "(4,)"),
    (lambda: thinbench.thin_labels(-LABELS), ValueError, "got -1 in row 0, column 0"),
    *((lambda value=value: thinbench.thin_labels(np.full((3, 4), value)), ValueError, str(value))
      for value in (2**31, 2**40, np.uint64(2**63), -2**40, np.int16(-1))),
    (lambda: thinbench.thin_labels(LABELS, "majority"), ValueError, "adds pixels"),
    (lambda: thinbench.thin_labels(LABELS, border="foreground"), ValueError, "expected background or keep"),
    (lambda: thinbench.thin_packed(PACKED.astype(int), 4), TypeError, "int64"),
    (lambda: thinbench.thin_packed(PACKED, 25), ValueError, "(H, 4)"),
    (lambda: thinbench.thin_packed(PACKED[0], 4), ValueError, "(1,)"),
    (lambda: thinbench.thin_packed(PACKED, -1), ValueError, "-1"),
    (lambda: thinbench.thin_packed(PACKED, 4.0), TypeError, "4.0"),
    (lambda: thinbench.thin_packed(PACKED, 4, bit_order="msb"), ValueError, "'msb'"),
    (lambda: thinbench.midpoint_scan(IMAGE, ["rows", "colums"]), ValueError, "did you mean 'columns'?"),
    (lambda: thinbench.midpoint_scan(IMAGE, border="foreground"), ValueError, "'foreground'"),
    (lambda: thinbench.midpoint_scan(IMAGE, threads=0), ValueError, "got 0"),
    (lambda: thinbench.detect_edges(IMAGE), TypeError, "bool"),
    (lambda: thinbench.detect_edges(GREY, "sobell"), ValueError, "did you mean 'sobel'?"),
    (lambda: thinbench.detect_edges(GREY, gradient_threshold=256), ValueError, "256"),
    (lambda: thinbench.euler_number(IMAGE, connectivity=6), ValueError, "6"),
    (lambda: thinbench.label_image(IMAGE, connectivity=6), ValueError, "6"),
    (lambda: thinbench.fill_holes(IMAGE, connectivity=6), ValueError, "6"),
    (lambda: thinbench.fill_holes(IMAGE, max_area=-1), ValueError, "max_area: expected"),
    (lambda: thinbench.fill_holes(IMAGE, max_area=1.5), TypeError, "max_area: expected"),
    (lambda: thinbench.fill_holes_of_labels(np.ones((2, 2), int), connectivity=6), ValueError, "6"),
    (lambda: thinbench.fill_holes_of_labels(np.ones((2, 2), int), max_area=-1), ValueError, "max_area: expected"),
    (lambda: thinbench.fill_holes_of_labels(np.ones((2, 2), int), out=np.zeros((2, 2))), ValueError, "float64"),
    (lambda: thinbench.distances(np.ones((1, 40000), bool)), ValueError, "32767"),
    (lambda: thinbench.skeleton_graph(LINE.astype(float)), TypeError, "skeleton: expected dtype"),
    (lambda: thinbench.skeleton_graph(LINE, np.ones((2, 5), bool)), ValueError, "image: expected the skeleton's shape"),
    (lambda: thinbench.skeleton_graph(LINE, not_thin="stop"), ValueError, "got 'stop'"),
    (lambda: thinbench.skeleton_graph(LINE, spacing=0), ValueError, "from 1e-30 to 1e30, got 0"),
    (lambda: thinbench.skeleton_graph(LINE, spacing=(1, 2, 3)), ValueError, "a number or two"),
    (lambda: thinbench.skeleton_graph(LINE, nodes=[(4, 0)]), ValueError,
     "nodes: expected pixels of the skeleton, got row 4"),
    (lambda: thinbench.skeleton_graph(LINE, nodes=[(-1, 0)]), ValueError, "got row -1, column 0"),
    (lambda: thinbench.skeleton_graph(~IMAGE).main_path(), ValueError,
     "main_path: expected a graph with nodes, got none"),
    (lambda: GRAPH.edge_widths(0), ValueError, "edge_widths: expected a skeleton_graph(skeleton, image)"),
    (lambda: GRAPH.subgraph(np.array([True] * 2)), ValueError, "edges: expected bools of shape (1,), got (2,)"),
    (lambda: GRAPH.shortest_path(0, 2), ValueError, "to_node: expected a number from 0 to 1, got 2"),
    (lambda: GRAPH.shortest_path(-1, 0), ValueError, "from_node: expected a number from 0 to 1, got -1"),
    (lambda: GRAPH.parents(2), ValueError, "root: expected a number from 0 to 1, got 2"),
    (lambda: GRAPH.node_pixels(2), ValueError, "node: expected a number from 0 to 1, got 2"),
    (lambda: GRAPH.edge_points(-1), ValueError, "edge: expected a number from 0 to 0, got -1"),
    (lambda: GRAPH.edge_points(0.0), TypeError, "edge: expected an integer, got 0.0"),
    (lambda: thinbench.skeleton_graph(LINE, LINE).edge_widths("0"), TypeError, "edge: expected an integer, got '0'"),
    (lambda: GRAPH.to_geojson(transform=5), TypeError, "transform: expected a list, got 5"),
    (lambda: GRAPH.to_csgraph("colour"), ValueError, "weight: expected one of from, to, length, chord; got 'colour'"),
    (lambda: GRAPH.summary(5), TypeError, "separator: expected a string, got 5"),
    (lambda: GRAPH.summary(image="x"), ValueError, "image: expected an array; "),
    (lambda: thinbench.skeleton_graph(LINE, nodes=5), TypeError, "nodes: expected a list, got 5"),
    (lambda: thinbench.skeleton_graph(LINE, nodes=(0, 2)), TypeError, "nodes: expected a row and a column, got 0"),
    (lambda: thinbench.skeleton_graph(LINE, nodes=[(0, 1, 2)]), TypeError,
     "nodes: expected a row and a column, got (0, 1, 2)"),
    (lambda: thinbench.thin_many(5), TypeError, "images: expected a list, got 5"),
    (lambda: thinbench.midpoint_scan(IMAGE, 5), TypeError, "directions: expected a list, got 5"),
    (lambda: thinbench.skeleton_graph(LINE & (np.arange(5) != 2)).shortest_path(0, 2), ValueError,
     "from node 0 to node 2"),
    (lambda: GRAPH.to_geojson(transform=(1e308, 1e308, 1e308, 0, 1, 0)), ValueError, "transform: expected finite"),
    (lambda: GRAPH.to_geojson(transform=(1, 0, 0, 0, 1)), ValueError, "transform: expected 6 numbers, got 5"),
    (lambda: GRAPH.open_cycles(math.nan), ValueError, "max_length: expected a number of at least 0, got nan"),
    (lambda: GRAPH.open_cycles(-0.5), ValueError, "max_length: expected a number of at least 0, got -0.5"),
    (lambda: GRAPH.open_cycles("a"), TypeError, "max_length: expected a number, got 'a'"),
    (lambda: GRAPH.open_cycles("1"), TypeError, "max_length: expected a number, got '1'"),
    (lambda: GRAPH.nearest(math.nan, 0), ValueError, "nearest: expected a finite point, got nan, 0"),
    (lambda: GRAPH.nearest(0.5, -math.inf), ValueError, "nearest: expected a finite point, got 0.5, -inf"),
    (lambda: GRAPH.nearest(None, 0), TypeError, "row: expected a number, got None"),
    (lambda: thinbench.skeleton_graph(~IMAGE).nearest(0, 0), ValueError,
     "nearest: expected a graph with edges, got none"),
    (lambda: GRAPH.subgraph([0, 1]), ValueError, "edges: expected numbers from 0 to 0, got 1"),
    (lambda: GRAPH.subgraph([-1]), ValueError, "edges: expected numbers from 0 to 0, got -1"),
    (lambda: GRAPH.subgraph(np.array([2**63], np.uint64)), ValueError, f"got {2**63}"),
    (lambda: GRAPH.subgraph([0.0]), TypeError, "edges: expected integers or bools, got dtype float64"),
    (lambda: GRAPH.subgraph([[0]]), ValueError, "edges: expected one dimension, got shape (1, 1)"),
    (lambda: GRAPH.subgraph(0), ValueError, "edges: expected one dimension, got shape ()"),
    *((lambda call=call, value=value: call(np.array([[value]])), ValueError,
       f"{name}: expected numbers that fit into int32, got {value}")
      for value in (-2**31 - 1, 2**31, np.uint32(2**32 - 1), np.uint64(2**63))
      for call, name in ((thinbench.label_values, "image"), (thinbench.graph_of_labels, "skeletons"),
                         (thinbench.prune_labels, "skeletons"), (thinbench.fill_holes_of_labels, "labels"))),
    (lambda: thinbench.label_values(np.ones((2, 2))), TypeError, "image: expected bool or integers, got float64"),
    (lambda: thinbench.label_values(LABELS[0]), ValueError, "image: expected shape (H, W), got (4,)"),
    (lambda: thinbench.graph_of_labels(LABELS[0]), ValueError, "skeletons: expected shape (H, W), got (4,)"),
    (lambda: thinbench.prune_labels(np.ones((2, 2)), 1), TypeError, "skeletons: expected bool or integers"),
    (lambda: thinbench.graph_of_labels(LABELS, LABELS[1:]), ValueError, "labels: expected the skeletons' shape (4, 4)"),
    (lambda: thinbench.prune(LINE, 10**400), ValueError, "min_length: expected less than 2**1024 in magnitude"),
    (lambda: thinbench.prune(LINE, min_widths=1), ValueError, "min_widths: expected image=..., "),
    (lambda: thinbench.prune_labels(LABELS, min_widths=1), ValueError, "min_widths: expected labels=..., "),
    (lambda: thinbench.prune(LINE, "a"), TypeError, "min_length: expected a number, got"),
    (lambda: GRAPH.polylines([1, 2]), TypeError, "tolerance: expected a number, got"),
    (lambda: thinbench.find_path(MAP, (20, 20), (20, 400)), ValueError, "goal: row 20, column 400 is outside"),
    (lambda: thinbench.find_path(MAP, 5, (20, 40)), TypeError, "start: expected a row and a column, got 5"),
    (lambda: thinbench.find_path(MAP, (20, 1.5), (20, 40)), TypeError, "start"),
    (lambda: thinbench.find_path(np.zeros((0, 0), bool), (0, 0), (0, 0)), ValueError, "outside the map of 0 x 0"),
    (lambda: thinbench.binarise(GREY, channel="gray"), ValueError, "did you mean 'grey'?"),
    (lambda: thinbench.binarise(GREY, foreground="light"), ValueError, "'light'"),
    (lambda: thinbench.binarise(GREY, threshold=256), ValueError, "256"),
    (lambda: thinbench.binarise(GREY, threshold="local", window=4), ValueError, "odd"),
    (lambda: thinbench.binarise(GREY, window=5), ValueError, "window: expected threshold='local'"),
    (lambda: thinbench.binarise(GREY, offset=10), ValueError, "offset: expected threshold='local'"),
    (lambda: thinbench.binarise(GREY, threshold="local", offset=300), ValueError, "300"),
    (lambda: compat.bwmorph(IMAGE, "cleen"), NotImplementedError, "did you mean 'clean'?"),
    (lambda: compat.bwmorph(IMAGE, "majority", np.inf), ValueError, "may never end"),
    (lambda: compat.bwmorph(IMAGE, "thin", 1.5), ValueError, "1.5"),
    (lambda: compat.bwmorph(IMAGE, "thin", np.nan), ValueError, "nan"),
    (lambda: compat.bwmorph(IMAGE, "thin", "all"), TypeError, "'all'"),
])
def test_values(call, error, said):
    assert_rejected(error, said, call)


@pytest.mark.parametrize(("name", "call"), [
    *(("image", function) for function in (*ONE_IMAGE[:9], *ONE_IMAGE[11:], thinbench.thin, thinbench.detect_edges,
                                           thinbench.binarise, thinbench.label_values, SKIMAGE.thin)),
    ("images", lambda rows: thinbench.thin_many([rows])), ("labels", thinbench.thin_labels),
    ("packed", lambda rows: thinbench.thin_packed(rows, 5)), ("skeleton", thinbench.skeleton_graph),
    ("skeletons", thinbench.graph_of_labels), ("labels", lambda rows: thinbench.graph_of_labels(LABELS, rows)),
    ("free", lambda rows: thinbench.find_path(rows, (0, 0), (0, 0))),
    ("spacing", lambda rows: thinbench.distances(IMAGE, spacing=rows)), ("tables", Rule), ("lut", Rule.from_values),
    ("removed", Rule.from_removals), ("weights", Rule.from_two_layer_net),
    ("last", lambda rows: Rule.from_cluster(rows, [[1] * 9])), ("weights", lambda rows: Rule.from_cluster([255], rows)),
    ("edges", GRAPH.subgraph), ("image", lambda rows: GRAPH.summary(image=rows)), ("src", CV2.thinning),
    ("image", SKIMAGE.skeletonize), ("image", CV2.connectedComponents), ("label_image", SKIMAGE.label), ("ar", SKIMAGE.remove_small_objects),
    ("intensity_image", lambda rows: SKIMAGE.regionprops_table(LABELS, rows)), ("input", SCIPY.label),
    ("structure", lambda rows: SCIPY.label(IMAGE, rows)), ("structure", lambda rows: SCIPY.binary_fill_holes(IMAGE, rows)),
    ("sampling", lambda rows: SCIPY.distance_transform_edt(IMAGE, rows))])
def test_lists_that_are_no_arrays(name, call):
    with pytest.raises(ValueError, match=rf"^{name}\b[^\n]*: expected an array; "):
        call([[1, 0], [1]])


ONE = np.ones((3, 3), np.uint8)
CHECKERS = np.indices((600, 600)).sum(axis=0).astype(np.uint8) % 2


@pytest.mark.parametrize(("function", "arguments", "options", "error", "said"), [
    (CV2.thinning, [ONE[:0]], {}, ValueError, "(0, 3)"),
    (CV2.connectedComponents, [ONE[:0]], {}, ValueError, "with pixels"),
    (CV2.distanceTransform, [ONE[:0], 2, 0], {}, ValueError, "with pixels"),
    (SKIMAGE.thin, [ONE[:0]], {}, ValueError, "(0, 3)"),
    (CV2.thinning, [ONE], {"thinningType": 7}, ValueError, "7"),
    (CV2.thinning, [ONE.astype(float)], {}, TypeError, "float64"),
    (CV2.thinning, [ONE, np.zeros((3, 4), np.uint8)], {}, ValueError, "(3, 4)"),
    (CV2.connectedComponents, [ONE], {"connectivity": 6}, ValueError, "6"),
    *((function, [ONE], {"connectivity": 8.0}, TypeError, "connectivity: expected an integer, got 8.0")
      for function in (CV2.connectedComponents, CV2.connectedComponentsWithStats)),
    (CV2.connectedComponentsWithAlgorithm, [ONE, 8, [], 0], {}, TypeError, "ltype: expected an integer, got []"),
    (CV2.distanceTransform, [ONE, np.ones(2), 0], {}, TypeError, "distanceType: expected an integer"),
    (CV2.connectedComponents, [ONE], {"ltype": 3}, ValueError, "3"),
    (CV2.connectedComponents, [ONE, np.empty((3, 3))], {}, ValueError, "float64"),
    (CV2.connectedComponents, [ONE > 0], {}, TypeError, "bool"),
    (CV2.connectedComponents, [CHECKERS, None, 4, CV2.CV_16U], {}, ValueError, "180000 objects were found, and CV_16U holds numbers up to 65535; use CV_32S"),
    (CV2.connectedComponentsWithStats, [ONE], {"stats": ONE}, NotImplementedError, "cv2"),
    (CV2.connectedComponentsWithAlgorithm, [ONE, 8, CV2.CV_32S, 6], {}, ValueError, "6"),
    (CV2.distanceTransform, [ONE, 4, 0], {}, NotImplementedError, "distanceType: expected 1 or 2 or 3, got 4"),
    (CV2.distanceTransform, [ONE, 2, 7], {}, NotImplementedError, "maskSize"),
    (CV2.distanceTransform, [ONE, 2, 0], {"dstType": 0}, NotImplementedError, "dstType"),
    (CV2.distanceTransform, [ONE, 2, 0, ONE], {}, ValueError, "uint8"),
    (SKIMAGE.skeletonize, [ONE], {"method": "lee"}, NotImplementedError, "scikit-image"),
    (SKIMAGE.skeletonize, [np.zeros((3, 3, 3))], {}, NotImplementedError, "scikit-image"),
    (SKIMAGE.skeletonize, [ONE], {"method": "other"}, ValueError, "other"),
    (SKIMAGE.thin, [ONE[0]], {}, ValueError, "(3,)"),
    (SKIMAGE.thin, [ONE, -1], {}, ValueError, "-1"),
    (SKIMAGE.thin, [ONE.astype("M8[s]")], {}, TypeError, "datetime64"),
    (SKIMAGE.label, [ONE], {"connectivity": 3}, ValueError, "3"),
    (SKIMAGE.label, [ONE], {"background": "2"}, TypeError, "'2'"),
    (SKIMAGE.label, [ONE], {"background": np.inf}, ValueError, "background: expected a finite number, got inf"),
    (SKIMAGE.regionprops_table, [ONE], {"separator": 5}, TypeError, "separator: expected a string, got 5"),
    (SKIMAGE.label, [ONE[0]], {}, NotImplementedError, "skimage.measure.label"),
    (SKIMAGE.regionprops_table, [ONE], {"properties": ("label", "solidity")}, NotImplementedError,
     "'solidity'; use skimage.measure.regionprops_table"),
    (SKIMAGE.regionprops_table, [ONE, ONE[1:]], {}, ValueError, "intensity_image: expected shape (3, 3), got (2, 3)"),
    (SKIMAGE.regionprops_table, [ONE, np.ones((3, 3, 3))], {}, NotImplementedError, "skimage"),
    (SKIMAGE.regionprops_table, [ONE], {"properties": ["intensity_max"]}, ValueError, "'intensity_max', got None"),
    (SKIMAGE.remove_small_objects, [ONE, 2, 3], {}, ValueError, "3"),
    (SKIMAGE.remove_small_objects, [ONE, "2"], {}, TypeError, "'2'"),
    (SKIMAGE.remove_small_objects, [ONE / 2], {}, TypeError, "float64"),
    (SKIMAGE.remove_small_objects, [np.array([[-5]])], {}, ValueError, "-5"),
    (SKIMAGE.remove_small_holes, [ONE[0]], {}, NotImplementedError, "skimage.morphology.remove_small_holes"),
    (SKIMAGE.remove_small_holes, [ONE, "2"], {}, TypeError, "area_threshold: expected a number, got '2'"),
    (SKIMAGE.remove_small_holes, [ONE], {"out": ONE}, ValueError, "expected bool"),
    (SKIMAGE.regionprops_table, [ONE > 0], {}, TypeError, "bool"),
    (SCIPY.label, [np.ones((3, 3, 3))], {}, NotImplementedError, "scipy.ndimage.label"),
    (SCIPY.label, [ONE, [[1, 1, 1]] * 2], {}, ValueError, "(2, 3)"),
    (SCIPY.label, [ONE, [1, 1, 1]], {}, RuntimeError, "(3,)"),
    (SCIPY.label, [ONE, np.eye(3)], {}, NotImplementedError, "scipy.ndimage.label"),
    (SCIPY.label, [ONE], {"output": np.empty((3, 4))}, ValueError, "(3, 4)"),
    (SCIPY.label, [ONE + 1j], {}, TypeError, "complex"),
    (SCIPY.label, [CHECKERS], {"output": np.int8}, RuntimeError, "180000 labels, got int8"),
    (SCIPY.binary_fill_holes, [ONE, np.ones((5, 5))], {}, NotImplementedError, "scipy"),
    (SCIPY.binary_fill_holes, [ONE], {"origin": 1}, NotImplementedError, "origin"),
    (SCIPY.binary_fill_holes, [ONE], {"output": np.empty(3, bool)}, RuntimeError, "(3,)"),
    (SCIPY.distance_transform_edt, [ONE, 2], {"return_indices": True}, NotImplementedError, "scipy"),
    (SCIPY.distance_transform_edt, [ONE], {"return_indices": True, "indices": ONE}, RuntimeError, "(2, 3, 3)"),
    (SCIPY.distance_transform_edt, [ONE, (1, 2, 3)], {}, RuntimeError, "(1, 2, 3)"),
    (SCIPY.distance_transform_edt, [ONE], {"sampling": -2}, ValueError, "sampling: expected numbers"),
    (SCIPY.distance_transform_edt, [ONE], {"return_distances": False}, RuntimeError, "False"),
    (SCIPY.distance_transform_edt, [ONE], {"distances": ONE}, RuntimeError, "uint8"),
    (SCIPY.distance_transform_edt, [ONE], {"distances": 5}, TypeError, "distances: expected an array, got int"),
])
def test_what_compat_does_not_support(function, arguments, options, error, said):
    """The message names the function of the other project where that can do it."""
    assert_rejected(error, said, function, *arguments, **options)
