"""Labels, holes, distances and tables with other projects' names equal those projects' results."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from images import random_image
from test_compat import DTYPES, cv2, images, many, views
from thinbench import compat

measure = pytest.importorskip("skimage.measure")
ndimage = pytest.importorskip("scipy.ndimage")
CROSS = [[0, 1, 0], [1, 1, 1], [0, 1, 0]]
STRUCTURES = [None, CROSS, np.ones((3, 3))]
PROPERTIES = ("label", "area", "bbox", "centroid", "euler_number", "area_filled")


def small_images() -> st.SearchStrategy[np.ndarray]:
    """Where the other project takes milliseconds per object."""
    return st.builds(random_image, st.integers(0, 2**32 - 1), st.just(24))


def assert_same(found, expected):
    """Equal arrays of one type, numbers, or tuples or dicts of these."""
    if isinstance(expected, dict):
        assert list(found) == list(expected)
        found, expected = tuple(found.values()), tuple(expected.values())
    if isinstance(expected, tuple):
        assert len(found) == len(expected)
        for one, other in zip(found, expected):
            assert_same(one, other)
        return
    assert type(found) is type(expected)
    np.testing.assert_array_equal(found, expected)
    if isinstance(expected, np.ndarray):
        assert found.dtype == expected.dtype


def several_values(image: np.ndarray, seed: int) -> np.ndarray:
    """An image of up to four values, one of which is negative."""
    values = np.random.RandomState(seed).randint(0, 4, image.shape)
    return np.where(image, values, 0 if seed % 2 else values.max(axis=0) - 1)


@many
@given(images(), views(), st.sampled_from(STRUCTURES), st.sampled_from(DTYPES),
       st.sampled_from([None, np.int32, np.int64, np.uint16, float]))
def test_label_equals_scipy(image, view, structure, dtype, output):
    source = view(image.astype(dtype))
    assert_same(compat.ndimage.label(source, structure, output), ndimage.label(source, structure, output))


@many
@given(images(), views(), st.sampled_from(STRUCTURES), st.sampled_from(DTYPES))
def test_binary_fill_holes_equals_scipy(image, view, structure, dtype):
    source = view(image.astype(dtype))
    assert_same(compat.ndimage.binary_fill_holes(source, structure), ndimage.binary_fill_holes(source, structure))


@many
@given(images(), views(), st.sampled_from([None, 1, 0.5, (2, 2), (1, 3), (2, 0.25)]), st.sampled_from(DTYPES))
def test_distance_transform_edt_equals_scipy(image, view, sampling, dtype):
    source = view(image.astype(dtype))
    assert_same(compat.ndimage.distance_transform_edt(source, sampling),
                ndimage.distance_transform_edt(source, sampling))


@many
@given(images(), views(), st.sampled_from([None, 1, 2]), st.sampled_from([None, 0, 1, 255]),
       st.sampled_from([bool, np.uint8, np.int32, np.float64]), st.booleans())
def test_label_of_two_values_equals_scikit_image(image, view, connectivity, background, dtype, return_num):
    source = view((image * (255 if dtype == np.uint8 else 1)).astype(dtype))
    arguments = (background, return_num, connectivity)
    assert_same(compat.skimage.label(source, *arguments), measure.label(source, *arguments))


@many
@given(images(), views(), st.sampled_from([None, 1, 2]), st.sampled_from([None, 0, 2, -1, 9]),
       st.integers(0, 1000), st.sampled_from([np.int8, np.int64, np.float64]))
def test_label_of_several_values_equals_scikit_image(image, view, connectivity, background, seed, dtype):
    source = view(several_values(image, seed).astype(dtype))
    arguments = (background, True, connectivity)
    assert_same(compat.skimage.label(source, *arguments), measure.label(source, *arguments))


@many
@given(small_images(), views(), st.sampled_from([1, 2, None]), st.sampled_from([np.int32, np.int64, np.uint16]),
       st.permutations(PROPERTIES))
def test_regionprops_table_equals_scikit_image(image, view, connectivity, dtype, properties):
    source = view(several_values(image, 1) if connectivity is None
                  else 3 * measure.label(image, connectivity=connectivity)).astype(dtype)
    arguments = {"properties": properties[:3], "separator": "_"}
    if source.size == 0:  # scikit-image raises
        assert not any(map(len, compat.skimage.regionprops_table(source, **arguments).values()))
        return
    assert_same(compat.skimage.regionprops_table(source, **arguments),
                measure.regionprops_table(source, **arguments))


LABEL_TYPES = [compat.cv2.CV_32S, compat.cv2.CV_16U]


@many
@given(images(), views(), st.sampled_from([8, 4]), st.sampled_from(LABEL_TYPES), st.sampled_from([np.uint8, np.int8]))
def test_connected_components_equal_opencv(image, view, connectivity, ltype, dtype):
    source = view(image.astype(dtype))
    if source.size == 0:  # OpenCV crashes
        with pytest.raises(ValueError, match="with pixels"):
            compat.cv2.connectedComponents(source)
        return
    copy = np.ascontiguousarray(source)
    assert_same(compat.cv2.connectedComponents(source, None, connectivity, ltype),
                cv2.connectedComponents(copy, None, connectivity, ltype))
    assert_same(compat.cv2.connectedComponentsWithStats(source, None, None, None, connectivity, ltype),
                cv2.connectedComponentsWithStats(copy, None, None, None, connectivity, ltype))


@many
@given(images(), views())
def test_distance_transform_equals_opencv_but_for_the_last_bit(image, view):
    source = view(image.astype(np.uint8))
    if source.size == 0:
        with pytest.raises(ValueError, match="with pixels"):
            compat.cv2.distanceTransform(source, compat.cv2.DIST_L2, compat.cv2.DIST_MASK_PRECISE)
        return
    arguments = (cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    found = compat.cv2.distanceTransform(source, *arguments)
    assert found.dtype == np.float32
    np.testing.assert_array_max_ulp(found, cv2.distanceTransform(np.ascontiguousarray(source), *arguments), 1)


def test_results_are_written_where_the_caller_says():
    image = random_image(7).astype(np.uint8)
    labels, count = compat.ndimage.label(image)
    output = np.empty(image.shape, np.int16)
    assert compat.ndimage.label(image, output=output) == count
    np.testing.assert_array_equal(output, labels)
    assert compat.ndimage.binary_fill_holes(image, output=output) is None
    np.testing.assert_array_equal(output, compat.ndimage.binary_fill_holes(image))
    distances = np.empty(image.shape)
    assert compat.ndimage.distance_transform_edt(image, distances=distances) is None
    np.testing.assert_array_equal(distances, compat.ndimage.distance_transform_edt(image))
    target = np.empty(image.shape, np.int32)
    assert compat.cv2.connectedComponents(image, target, 4)[1] is target
    np.testing.assert_array_equal(target, labels)
    floats = np.empty(image.shape, np.float32)
    assert compat.cv2.distanceTransform(image, 2, 0, floats) is floats
    np.testing.assert_array_equal(floats, compat.cv2.distanceTransform(image, 2, 0))


def test_a_background_beyond_int32_is_one_as_any_other():
    image = np.array([[1, 2**32 - 1, 5], [1, 5, 2**32 - 1]], np.uint32)
    for background in (2**32 - 1, 2**40, 1.0):
        expected = measure.label(image, background=background)
        np.testing.assert_array_equal(compat.skimage.label(image, background=background), expected)


def test_labels_as_bool_are_those_of_scipy():
    image = np.array([[1, 0, 1]])
    found, count = compat.ndimage.label(image, output=bool)
    expected, expected_count = ndimage.label(image, output=bool)
    assert found.dtype == expected.dtype and count == expected_count
    np.testing.assert_array_equal(found, expected)
