"""The Python interface: results, arrays of all shapes, threads, memory."""

from __future__ import annotations

import contextlib
import doctest
import gc
import os
import resource
import subprocess
import sys
import tracemalloc

import numpy as np
import pytest

import thinbench
from images import random_image
from waiting import in_eight_threads, longest_wait_during

MODULES = ["", "._thinning", "._rules", "._images", "._graph", "._label_graphs", "._catalogue", "._binarise",
           "._packed", "._path", ".dask", ".compat", ".compat.cv2", ".compat.ndimage", ".compat.skimage"]


@pytest.mark.parametrize("name", MODULES)
def test_examples_in_docstrings_hold(name):
    result = doctest.testmod(pytest.importorskip(f"thinbench{name}"))
    assert result.failed == 0 and result.attempted > 0


def test_apply_is_another_name_of_thin():
    assert thinbench.apply is thinbench.thin


def test_bool_and_uint8_give_the_same_skeleton_in_their_own_type():
    image = random_image(11)
    as_bool = thinbench.thin(image)
    as_bytes = thinbench.thin(image * np.uint8(7))
    assert as_bool.dtype == bool and as_bytes.dtype == np.uint8
    assert set(np.unique(as_bool.view(np.uint8))) <= {0, 1}
    np.testing.assert_array_equal(as_bytes, as_bool * np.uint8(255))


def thin_labels(image, **options):
    return thinbench.thin_labels(image * 7, **options) == 7


def thin_packed(image, bit_order="big", **options):
    packed = np.packbits(image, axis=1, bitorder=bit_order)
    thinned = thinbench.thin_packed(packed, image.shape[1], bit_order=bit_order, **options)
    return np.unpackbits(thinned, axis=1, count=image.shape[1], bitorder=bit_order) == 1


def thin_many(image, **options):
    return thinbench.thin_many([EMPTY, image], **options)[1]


SOLID, EMPTY, DIAGONAL = np.ones((7, 7), bool), np.zeros((7, 7), bool), np.eye(2, dtype=bool)
OPEN = np.array([[0, 5, 5], [5, 0, 5], [5, 5, 5]])
"""Its hole and the outside touch at a corner."""


@pytest.mark.parametrize(("function", "image", "options", "count"), [
    *((thinbench.thin, EMPTY, {"rule": "dilate", "border": border}, count)
      for border, count in (("background", 0), ("keep", 0), ("foreground", 24))),
    *((function, SOLID, {"rule": "erode"} | options, count)
      for function in (thinbench.thin, thin_labels, thin_packed, thin_many) for options, count in (
          ({"border": "background"}, 25), ({"border": "keep"}, 49), ({"border": "background", "max_iterations": 2}, 9),
          ({"border": "background", "max_iterations": 9}, 0))),
    (thinbench.thin, SOLID, {"rule": "erode", "border": "foreground"}, 49),
    (thin_packed, SOLID, {"rule": "erode", "border": "background", "bit_order": "little"}, 25),
    *((thinbench.midpoint_scan, image, {"directions": directions}, count) for image, directions, count in (
        (np.ones((3, 5), bool), "rows", 3), (np.ones((3, 5), bool), ["columns"], 5),
        (np.ones((3, 5), bool), ["rows", "columns"], 7), (SOLID, [], 0), (DIAGONAL, "diagonals", 1),
        (DIAGONAL, "antidiagonals", 2), (DIAGONAL[::-1], "diagonals", 2), (DIAGONAL[::-1], "antidiagonals", 1))),
    (thinbench.midpoint_scan, np.ones((4, 5), bool), {"directions": "rows", "border": "keep"}, 16),
    *((function, OPEN != 0 if function == thinbench.fill_holes else OPEN, options, count)
      for function in (thinbench.fill_holes, thinbench.fill_holes_of_labels) for options, count in (
          ({}, 8), ({"connectivity": 4}, 7), ({"max_area": 0}, 7), ({"max_area": 1}, 8)))])
def test_options_are_passed_on(function, image, options, count):
    result = function(image, **options)
    assert np.count_nonzero(result) == count and result.dtype == image.dtype


@pytest.mark.parametrize(("function", "arguments"), [
    (thinbench.thin, [SOLID]), (thinbench.thin_labels, [SOLID * 7]),
    (thinbench.thin_packed, [np.packbits(SOLID, axis=1), 7])])
def test_iterations_are_returned_on_request(function, arguments):
    options = {"rule": "erode", "border": "background", "max_iterations": 2}
    result, iterations = function(*arguments, **options, return_iterations=True)
    assert iterations == 2
    np.testing.assert_array_equal(result, function(*arguments, **options))


@pytest.mark.parametrize(("function", "options"), [
    (thinbench.thin, {}), (thinbench.thin_labels, {}), (thinbench.fill_holes, {}), (thinbench.fill_holes_of_labels, {}),
    (thinbench.midpoint_scan, {"directions": "rows"})])
def test_out_receives_the_result_and_may_be_the_image(function, options):
    image = random_image(3).astype(np.uint8)
    expected = function(image, **options)
    for out in (np.empty_like(image), image):
        assert function(image, out=out, **options) is out
        np.testing.assert_array_equal(out, expected)


@pytest.mark.parametrize("dtype", [bool, "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8"])
@pytest.mark.parametrize("function", [thinbench.thin_labels, thinbench.fill_holes_of_labels,
                                      lambda skeletons: thinbench.prune_labels(skeletons, 3)])
def test_label_arrays_of_any_integer_type(function, dtype):
    labels = thinbench.label_image(random_image(7))[0] % 2
    found = function(labels.astype(dtype))
    assert found.dtype == dtype
    np.testing.assert_array_equal(found, function(labels).astype(dtype))


@pytest.mark.parametrize("rule", ["guo_hall", "majority", "mb2"])
@pytest.mark.parametrize("shape", [(2**62, 0, 0), (2**62, 0, 1), (2**62, 1, 0)])
def test_stacks_without_pixels_take_no_time(rule, shape):
    assert thinbench.thin(np.empty(shape, bool), rule, threads=2, stack=True).shape == shape


@pytest.mark.parametrize(("shape", "view"), [
    ((4, 1, 9), lambda base: base[:, ::5]), ((4, 1, 9), lambda base: base[:, ::-3]), ((4, 1, 1), lambda base: base[:, ::5]),
    ((4, 6, 9), lambda base: base[::3][:1]), ((4, 6, 9), lambda base: base[:0, ::5]), ((1, 6, 9), lambda base: base[::7]),
    ((200, 1, 30), lambda base: base[:, ::100000])])
def test_strides_of_axes_of_length_1_mean_nothing_in_stacks(shape, view):
    stack = view(np.random.RandomState(0).rand(*shape) < 0.8)
    assert stack.flags.c_contiguous and stack.strides != stack.copy().strides
    expected = thinbench.thin(stack.copy(), stack=True)
    np.testing.assert_array_equal(thinbench.thin(stack, stack=True), expected)
    np.testing.assert_array_equal(thinbench.thin(stack, out=stack, stack=True), expected)


@pytest.mark.parametrize("function", [
    thinbench.thin, thinbench.thin_labels, thinbench.fill_holes, thinbench.fill_holes_of_labels, thinbench.midpoint_scan,
    lambda image, **options: thinbench.prune(image, 2, **options),
    lambda image, **options: thinbench.prune_labels(image, 2, **options),
    lambda image, **options: thinbench.thin_packed(image, 512, **options)])
@pytest.mark.parametrize("rows", [slice(1, 3, 2), slice(3, 1, -2)])
def test_one_row_of_an_image_may_become_the_result(function, rows):
    row = np.random.RandomState(0).randint(0, 2, (5, 64)).astype(np.uint8)[rows]
    expected = function(row.copy())
    assert function(row, out=row) is row
    np.testing.assert_array_equal(row, expected)


def test_partial_overlap_is_rejected():
    memory = np.zeros(100, bool)
    with pytest.raises(ValueError, match="overlap"):
        thinbench.thin(memory[:64].reshape(8, 8), out=memory[8:72].reshape(8, 8))


def test_columns_of_regions_are_those_of_their_labels():
    for seed in range(40):
        labels, table = thinbench.label_regions(random_image(seed))
        for index, label in enumerate(table["label"]):
            ys, xs = np.nonzero(labels == label)
            row = [table[name][index] for name in (
                "area", "centroid-0", "centroid-1", "bbox-0", "bbox-1", "bbox-2", "bbox-3")]
            np.testing.assert_allclose(row, [len(ys), ys.mean(), xs.mean(), ys.min(), xs.min(),
                                             ys.max() + 1, xs.max() + 1])


def test_objects_are_the_regions_that_are_no_holes():
    for seed in range(20):
        image = random_image(seed)
        regions = thinbench.find_regions(image)
        labels, labelled = thinbench.label_objects(image)
        np.testing.assert_array_equal(labels, thinbench.label_image(image)[0])
        for objects in (thinbench.find_objects(image), labelled):
            np.testing.assert_equal(objects, {name: column[~regions["is_hole"]] for name, column in regions.items()})


BY_COLUMNS = """
import numpy as np
import thinbench
image = np.random.RandomState(1).rand(300, 400) < 0.3
for name in ("thin", "fill_holes", "find_regions", "label_regions", "find_objects", "label_objects", "label_image",
             "euler_number", "distances", "squared_distances", "classify_pixels", "prune", "midpoint_scan"):
    function = getattr(thinbench, name)
    np.testing.assert_equal(function(np.asfortranarray(image)), function(image), name)
"""


def test_the_copy_of_an_image_by_columns_lives_as_long_as_the_call():
    """Freed memory is overwritten at once."""
    subprocess.run([sys.executable, "-c", BY_COLUMNS], check=True, env={**os.environ, "MALLOC_PERTURB_": "85"})


def test_localise_finds_an_object_and_its_hole():
    picture = np.full((60, 60), 255, np.uint8)
    picture[10:50, 10:50] = 0
    picture[25:35, 25:35] = 255
    found = thinbench.localise_objects(picture)
    np.testing.assert_array_equal(found["is_hole"], [False, True])
    np.testing.assert_array_equal(found["enclosing_object"], [0, 1])
    np.testing.assert_allclose(found["centroid-0"], 29.5)


def test_other_threads_run_during_a_call():
    image = np.ones((1500, 1500), bool)
    waits = (longest_wait_during(lambda: thinbench.thin(image, "mb2")) for _ in range(10))
    assert any(wait < 0.5 for wait in waits)  # 1 with the interpreter locked; a busy machine makes some longer


@contextlib.contextmanager
def no_leak():
    """Neither Python's memory nor the process grows meanwhile."""
    gc.collect()
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    resident = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    yield
    gc.collect()
    grown = tracemalloc.get_traced_memory()[0] - before
    tracemalloc.stop()
    assert grown < 100_000
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - resident < 8192  # KiB


def test_calls_from_eight_threads_are_equal_and_leak_nothing():
    image = random_image(7, 300)
    expected, regions = thinbench.thin(image), thinbench.find_regions(image)

    def work() -> None:
        for _ in range(125):
            np.testing.assert_array_equal(thinbench.thin(image), expected)
            np.testing.assert_equal(thinbench.label_regions(image)[1], regions)
            with pytest.raises(ValueError):
                thinbench.thin(image, "none")

    in_eight_threads(work)
    with no_leak():
        in_eight_threads(work)


def test_a_stack_three_pixels_wide_needs_a_word():
    stack = np.random.RandomState(1).randint(0, 2, (40, 60, 3)).astype(np.uint8)
    expected = [thinbench.thin(image) for image in stack]
    np.testing.assert_array_equal(thinbench.thin(stack, stack=True), expected)
    np.testing.assert_array_equal(thinbench.thin_many(list(stack)), expected)
    np.testing.assert_array_equal(thinbench.thin(stack != 0, stack=True), np.array(expected) != 0)
