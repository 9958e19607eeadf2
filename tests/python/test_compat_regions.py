"""Labels, holes, distances and tables with other projects' names equal those projects' results."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from images import random_image
from test_compat import DTYPES, images, many, views
from thinbench import compat

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
    ndimage = pytest.importorskip("scipy.ndimage")
    source = view(image.astype(dtype))
    assert_same(compat.ndimage.label(source, structure, output), ndimage.label(source, structure, output))


@many
@given(images(), views(), st.sampled_from(STRUCTURES), st.sampled_from(DTYPES))
def test_binary_fill_holes_equals_scipy(image, view, structure, dtype):
    ndimage = pytest.importorskip("scipy.ndimage")
    source = view(image.astype(dtype))
    assert_same(compat.ndimage.binary_fill_holes(source, structure), ndimage.binary_fill_holes(source, structure))


@many
@given(images(), views(), st.sampled_from([None, 1, 0.5, (2, 2)]), st.sampled_from(DTYPES))
def test_distance_transform_edt_equals_scipy(image, view, sampling, dtype):
    ndimage = pytest.importorskip("scipy.ndimage")
    source = view(image.astype(dtype))
    assert_same(compat.ndimage.distance_transform_edt(source, sampling),
                ndimage.distance_transform_edt(source, sampling))


@many
@given(images(), views(), st.sampled_from([None, 1, 2]), st.sampled_from([None, 0, 1, 255]),
       st.sampled_from([bool, np.uint8, np.int32, np.float64]), st.booleans())
def test_label_of_two_values_equals_scikit_image(image, view, connectivity, background, dtype, return_num):
    measure = pytest.importorskip("skimage.measure")
    source = view((image * (255 if dtype == np.uint8 else 1)).astype(dtype))
    arguments = (background, return_num, connectivity)
    assert_same(compat.skimage.label(source, *arguments), measure.label(source, *arguments))


@many
@given(images(), views(), st.sampled_from([None, 1, 2]), st.sampled_from([None, 0, 2, -1, 9]),
       st.integers(0, 1000), st.sampled_from([np.int8, np.int64, np.float64]))
def test_label_of_several_values_equals_scikit_image(image, view, connectivity, background, seed, dtype):
    measure = pytest.importorskip("skimage.measure")
    source = view(several_values(image, seed).astype(dtype))
    arguments = (background, True, connectivity)
    assert_same(compat.skimage.label(source, *arguments), measure.label(source, *arguments))


@many
@given(small_images(), views(), st.sampled_from([1, 2, None]), st.sampled_from([np.int32, np.int64, np.uint16]),
       st.permutations(PROPERTIES))
def test_regionprops_table_equals_scikit_image(image, view, connectivity, dtype, properties):
    measure = pytest.importorskip("skimage.measure")
    source = view(several_values(image, 1) if connectivity is None
                  else 3 * measure.label(image, connectivity=connectivity)).astype(dtype)
    arguments = {"properties": properties[:3], "separator": "_"}
    if source.size == 0:  # scikit-image raises
        assert not any(map(len, compat.skimage.regionprops_table(source, **arguments).values()))
        return
    assert_same(compat.skimage.regionprops_table(source, **arguments),
                measure.regionprops_table(source, **arguments))
