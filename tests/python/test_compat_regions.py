"""Labels, holes, distances and tables with other projects' names equal those projects' results."""

from __future__ import annotations

import itertools
import warnings

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from images import random_image
from test_compat import DTYPES, cv2, images, many, views
from thinbench import compat

data = pytest.importorskip("skimage.data")
measure = pytest.importorskip("skimage.measure")
morphology = pytest.importorskip("skimage.morphology")
ndimage = pytest.importorskip("scipy.ndimage")
CROSS = [[0, 1, 0], [1, 1, 1], [0, 1, 0]]
STRUCTURES = [None, CROSS, np.ones((3, 3))]
PROPERTIES = ("label", "area", "bbox", "centroid", "euler_number", "area_filled", "area_bbox", "extent")
ROUNDED = ("inertia_tensor", "inertia_tensor_eigvals", "axis_major_length", "axis_minor_length", "eccentricity",
           "perimeter", "equivalent_diameter_area")
STEPS = [(compat.cv2.DIST_L2, 3), (compat.cv2.DIST_L2, 5), *itertools.product([1, 3], [0, 3, 5])]
INTENSITIES = ("intensity_max", "intensity_mean", "intensity_min", "centroid_weighted")


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
@given(images(), views(), st.booleans())
def test_indices_of_the_nearest_background_equal_scipy(image, view, return_distances):
    source = view(image)
    arguments = {"return_distances": return_distances, "return_indices": True}
    assert_same(compat.ndimage.distance_transform_edt(source, **arguments),
                ndimage.distance_transform_edt(source, **arguments))


@pytest.mark.parametrize("picture", [~data.horse(), data.coins() > 110, data.coins() < 110, data.page() > 128])
def test_pictures_have_the_distances_of_other_projects(picture):
    assert_same(compat.ndimage.distance_transform_edt(picture, return_indices=True),
                ndimage.distance_transform_edt(picture, return_indices=True))
    grey = picture.astype(np.uint8)
    for kind, mask in STEPS:
        assert_same(compat.cv2.distanceTransform(grey, kind, mask), cv2.distanceTransform(grey, kind, mask))


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


def measured_by_both(labels, levels, properties):
    """What both projects say, as arrays of one row for each column."""
    found, expected = (table(labels, levels, properties=properties)
                       for table in (compat.skimage.regionprops_table, measure.regionprops_table))
    assert list(found) == list(expected)
    return np.array([*found.values()]), np.array([*expected.values()])


def assert_measures_equal_scikit_image(labels, levels):
    np.testing.assert_allclose(*measured_by_both(labels, levels, ROUNDED), rtol=1e-9, atol=1e-5)
    np.testing.assert_allclose(*measured_by_both(labels, levels, INTENSITIES),
                               rtol=1e-5 if levels.dtype == np.float32 else 1e-12)
    (down, _, _, across), _ = measured_by_both(labels, levels, ["inertia_tensor"])
    found, expected = measured_by_both(labels, levels, ["orientation"])
    turn = np.abs(found - expected)[0]  # along a diagonal, rounding decides about scikit-image's sign
    assert (np.minimum(turn, np.pi - turn)[np.abs(down - across) > 1e-6 * (1 + down)] < 1e-6).all()


@many
@given(small_images(), views(), st.sampled_from([np.int32, np.uint16]),
       st.sampled_from([np.uint8, np.int16, np.float32, np.float64]), st.integers(0, 1000))
def test_measures_of_shapes_and_intensities_equal_scikit_image_but_for_rounding(image, view, dtype, kind, seed):
    labels = view(several_values(image, 1).astype(dtype))
    if not (labels > 0).any():
        return
    levels = np.random.RandomState(seed).randint(1, 100, labels.shape).astype(kind)
    assert_measures_equal_scikit_image(labels, levels / 3 if kind == np.float64 else levels)


@pytest.mark.parametrize("picture", [~data.horse(), data.coins() > 110, data.page() > 128])
def test_measures_of_pictures_equal_scikit_image_but_for_rounding(picture):
    labels = measure.label(picture)
    assert_measures_equal_scikit_image(labels, labels.astype(np.uint8))


@many
@given(images(), views(), st.sampled_from([0, 1, 2, 5, 5.5, 64]), st.sampled_from([1, 2]),
       st.sampled_from([bool, np.uint8, np.int64]))
def test_small_objects_and_holes_are_removed_as_by_scikit_image(image, view, size, connectivity, dtype):
    source = view(image if dtype == bool else 3 * measure.label(image).astype(dtype) % 120)
    for name in ("remove_small_objects", "remove_small_holes"):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of labels, whether that is meant
            expected = getattr(morphology, name)(source, size, connectivity)
        assert_same(getattr(compat.skimage, name)(source, size, connectivity), expected)


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
@given(images(), st.sampled_from([8, 4]), st.sampled_from(LABEL_TYPES), st.integers(-1, 5))
def test_connected_components_with_an_algorithm_equal_opencv(image, connectivity, ltype, algorithm):
    source = image.astype(np.uint8)
    assert_same(compat.cv2.connectedComponentsWithAlgorithm(source, connectivity, ltype, algorithm),
                cv2.connectedComponentsWithAlgorithm(source, connectivity, ltype, algorithm))


@many
@given(images(), views(), st.sampled_from(STEPS))
def test_distances_by_steps_equal_opencv(image, view, kind):
    source = view(image.astype(np.uint8))
    if source.size > 0:
        assert_same(compat.cv2.distanceTransform(source, *kind),
                    cv2.distanceTransform(np.ascontiguousarray(source), *kind))


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
    indices = np.empty((2, *image.shape), np.int32)
    assert compat.ndimage.distance_transform_edt(image, None, False, True, indices=indices) is None
    np.testing.assert_array_equal(indices, ndimage.distance_transform_edt(image, None, False, True))
    target = np.empty(image.shape, np.int32)
    assert compat.cv2.connectedComponents(image, target, 4)[1] is target
    np.testing.assert_array_equal(target, labels)
    binary = image > 0
    removed = compat.skimage.remove_small_objects(binary, 5)
    assert compat.skimage.remove_small_objects(binary, 5, out=binary) is binary
    np.testing.assert_array_equal(binary, removed)
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
