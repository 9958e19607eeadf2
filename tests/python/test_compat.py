"""The functions with other projects' names give those projects' results: a row for each, with what is drawn."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from images import iteration_limit, random_image
from record_bwmorph import CASES, OPERATION_CASES, OPERATIONS, assert_recorded, repetitions
from thinbench import compat

cv2 = pytest.importorskip("cv2")
data = pytest.importorskip("skimage.data")
measure = pytest.importorskip("skimage.measure")
morphology = pytest.importorskip("skimage.morphology")
ndimage = pytest.importorskip("scipy.ndimage")
CV2, SCIPY, SKIMAGE = compat.cv2, compat.ndimage, compat.skimage

many = settings(max_examples=500, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
one_of = st.sampled_from
VIEWS = {
    "plain": lambda image: image,
    "transposed": lambda image: image.T,
    "flipped": lambda image: image[::-1, ::-1],
    "every other column": lambda image: image[:, ::2],
    "part": lambda image: image[1:-1, 2:-1],
    "without rows": lambda image: image[:0],
    "without columns": lambda image: image[:, :0],
}
SIDES = one_of([8, 64, 64, 64, 64, 64, 64, 64, 64, 300])
SMALL = st.just(24)
"""Where the other project takes milliseconds per object."""


def grey_levels(image: np.ndarray, seed: int) -> np.ndarray:
    """Foreground from 128 to 255, background from 0 to 127."""
    random = np.random.RandomState(seed)
    return (random.randint(0, 128, image.shape) + 128 * image).astype(np.uint8)


def several_values(image: np.ndarray, seed: int) -> np.ndarray:
    """An image of up to four values, one of which is negative."""
    values = np.random.RandomState(seed).randint(0, 4, image.shape)
    return np.where(image, values, 0 if seed % 2 else values.max(axis=0) - 1)


def labels_of(image: np.ndarray, seed: int) -> np.ndarray:
    return several_values(image, 1) if seed % 3 == 0 else 3 * measure.label(image, connectivity=1 + seed % 2)


def sources(*dtypes: Any, make: Callable[[np.ndarray, int], np.ndarray] = lambda image, _: image,
            sides: st.SearchStrategy[int] = SIDES) -> st.SearchStrategy[np.ndarray]:
    """What is made of random images, half of them views of another."""
    views = one_of([VIEWS["plain"]] * len(VIEWS) + [*VIEWS.values()])
    return st.builds(lambda seed, side, view, number, dtype: view(make(random_image(seed, side), number).astype(dtype)),
                     st.integers(0, 2**32 - 1), sides, views, st.integers(0, 1000), one_of(dtypes))


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


def assert_same_but_for_the_last_bit(found, expected):
    assert found.dtype == expected.dtype
    np.testing.assert_array_max_ulp(found, expected, 1)


class Row(NamedTuple):
    """Both functions, strategies of the image and of a tuple of the other arguments, and how results are compared."""

    ours: Callable[..., Any]
    theirs: Callable[..., Any]
    images: st.SearchStrategy[np.ndarray]
    arguments: st.SearchStrategy[tuple[Any, ...]] = st.just(())
    compare: Callable[[Any, Any], None] = assert_same


def columns_by(regionprops_table: Callable[..., Any]) -> Callable[..., Any]:
    return lambda labels, *properties: regionprops_table(labels, properties=properties, separator="_")


DTYPES = [bool, np.uint8, np.int32, np.float64]
STRUCTURES = one_of([None, [[0, 1, 0], [1, 1, 1], [0, 1, 0]], np.ones((3, 3))])
STEPS = [(CV2.DIST_L2, 3), (CV2.DIST_L2, 5), *itertools.product([1, 3], [0, 3, 5])]
CONNECTIVITIES, LABEL_TYPES, NONE = one_of([8, 4]), one_of([CV2.CV_32S, CV2.CV_16U]), st.just(None)
PROPERTIES = ("label", "area", "bbox", "centroid", "euler_number", "area_filled", "area_bbox", "extent")
SMALL_REGIONS = (sources(bool, np.uint8, np.int64, make=lambda image, _: 3 * measure.label(image) % 120),
                 st.tuples(one_of([0, 1, 2, 5, 5.5, 64]), one_of([1, 2])))
ROWS = {
    "scipy label": Row(SCIPY.label, ndimage.label, sources(*DTYPES),
                       st.tuples(STRUCTURES, one_of([None, np.int32, np.int64, np.uint16, float]))),
    "scipy binary_fill_holes": Row(SCIPY.binary_fill_holes, ndimage.binary_fill_holes, sources(*DTYPES),
                                   st.tuples(STRUCTURES)),
    "scipy distance_transform_edt": Row(SCIPY.distance_transform_edt, ndimage.distance_transform_edt, sources(*DTYPES),
                                        st.tuples(one_of([None, 1, 0.5, (2, 2), (1, 3), (2, 0.25)]))),
    "scipy distance_transform_edt, indices": Row(
        SCIPY.distance_transform_edt, ndimage.distance_transform_edt, sources(bool),
        st.tuples(NONE, st.booleans(), st.just(True))),
    "skimage thin": Row(SKIMAGE.thin, morphology.thin, sources(*DTYPES), st.tuples(one_of([None, 0, 1, 2, 3, 4, 5]))),
    "skimage skeletonize": Row(SKIMAGE.skeletonize, lambda image: morphology.skeletonize(image, method="zhang"),
                               sources(*DTYPES)),
    "skimage label, two values": Row(
        SKIMAGE.label, measure.label, sources(*DTYPES, make=lambda image, _: 255 * image),
        st.tuples(one_of([None, 0, 1, 255]), st.booleans(), one_of([None, 1, 2]))),
    "skimage label, several values": Row(
        SKIMAGE.label, measure.label, sources(np.int8, np.int64, np.float64, make=several_values),
        st.tuples(one_of([None, 0, 2, -1, 9]), st.just(True), one_of([None, 1, 2]))),
    "skimage regionprops_table": Row(
        columns_by(SKIMAGE.regionprops_table), columns_by(measure.regionprops_table),
        sources(np.int32, np.int64, np.uint16, make=labels_of, sides=SMALL),
        st.permutations(PROPERTIES).map(lambda names: tuple(names[:3]))),
    "skimage remove_small_objects": Row(SKIMAGE.remove_small_objects, morphology.remove_small_objects, *SMALL_REGIONS),
    "skimage remove_small_holes": Row(SKIMAGE.remove_small_holes, morphology.remove_small_holes, *SMALL_REGIONS),
    "cv2 thinning": Row(CV2.thinning, cv2.ximgproc.thinning, sources(np.uint8, make=grey_levels),
                        st.tuples(NONE, one_of([CV2.THINNING_ZHANGSUEN, CV2.THINNING_GUOHALL]))),
    "cv2 connectedComponents": Row(CV2.connectedComponents, cv2.connectedComponents, sources(np.uint8, np.int8),
                                   st.tuples(NONE, CONNECTIVITIES, LABEL_TYPES)),
    "cv2 connectedComponentsWithStats": Row(
        CV2.connectedComponentsWithStats, cv2.connectedComponentsWithStats, sources(np.uint8, np.int8),
        st.tuples(NONE, NONE, NONE, CONNECTIVITIES, LABEL_TYPES)),
    "cv2 connectedComponentsWithAlgorithm": Row(
        CV2.connectedComponentsWithAlgorithm, cv2.connectedComponentsWithAlgorithm, sources(np.uint8),
        st.tuples(CONNECTIVITIES, LABEL_TYPES, st.integers(-1, 5))),
    "cv2 distanceTransform by steps": Row(CV2.distanceTransform, cv2.distanceTransform, sources(np.uint8),
                                          one_of(STEPS)),
    "cv2 distanceTransform": Row(
        CV2.distanceTransform, cv2.distanceTransform, sources(np.uint8),
        st.just((CV2.DIST_L2, CV2.DIST_MASK_PRECISE)), assert_same_but_for_the_last_bit),
}
NEED_PIXELS = {name for name in ROWS if name.startswith(("cv2", "skimage thin", "skimage regionprops"))}
"""On empty images the other project raises or crashes."""


@pytest.mark.filterwarnings("ignore::UserWarning")  # of labels, whether that is meant
@pytest.mark.parametrize("name", ROWS)
@many
@given(st.data())
def test_results_are_those_of_the_other_project(name, data):
    row = ROWS[name]
    image, arguments = data.draw(row.images), data.draw(row.arguments)
    if image.size or name not in NEED_PIXELS:
        row.compare(row.ours(image, *arguments), row.theirs(np.ascontiguousarray(image), *arguments))


@pytest.mark.parametrize("picture", [~data.horse(), data.coins() > 110, data.coins() < 110, data.page() > 128])
def test_pictures_have_the_results_of_other_projects(picture):
    assert_same(SCIPY.distance_transform_edt(picture, return_indices=True),
                ndimage.distance_transform_edt(picture, return_indices=True))
    grey = picture.astype(np.uint8)
    for kind, mask in STEPS:
        assert_same(CV2.distanceTransform(grey, kind, mask), cv2.distanceTransform(grey, kind, mask))
    labels = measure.label(picture)
    assert_measures_equal_scikit_image(labels, (labels % 255 + 1).astype(np.uint8))


# Columns of regionprops_table that are rounded.

ROUNDED = ("inertia_tensor", "inertia_tensor_eigvals", "axis_major_length", "axis_minor_length", "eccentricity",
           "perimeter", "equivalent_diameter_area")
INTENSITIES = ("intensity_max", "intensity_mean", "intensity_min", "centroid_weighted")


def measured_by_both(labels, levels, properties):
    """What both projects say, as arrays of one row for each column."""
    found, expected = (table(labels, levels, properties=properties)
                       for table in (SKIMAGE.regionprops_table, measure.regionprops_table))
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
@given(sources(np.int32, np.uint16, make=lambda image, _: several_values(image, 1), sides=SMALL),
       one_of([np.uint8, np.int16, np.float32, np.float64]), st.integers(0, 1000))
def test_measures_of_shapes_and_intensities_equal_scikit_image_but_for_rounding(labels, kind, seed):
    if not (labels > 0).any():
        return
    levels = np.random.RandomState(seed).randint(1, 100, labels.shape).astype(kind)
    assert_measures_equal_scikit_image(labels, levels / 3 if kind == np.float64 else levels)


# Single values, and arrays that the caller gives.

def test_skimage_thin_takes_the_old_name_of_its_limit():
    image = random_image(2)
    with pytest.warns(FutureWarning, match="max_num_iter"):
        np.testing.assert_array_equal(SKIMAGE.thin(image, max_iter=1), morphology.thin(image, 1))


@pytest.mark.parametrize("image", [[[0, 255, 255], [0, 255, 7]], [[0, 0.5, 1.5]], [[-1, 0, 1]]])
def test_skeletonize_takes_what_is_nonzero(image):
    np.testing.assert_array_equal(SKIMAGE.skeletonize(image), morphology.skeletonize(np.array(image) != 0))


@pytest.mark.parametrize("background", [2**32 - 1, 2**40, 1.0])
def test_a_background_beyond_int32_is_one_as_any_other(background):
    image = np.array([[1, 2**32 - 1, 5], [1, 5, 2**32 - 1]], np.uint32)
    assert_same(SKIMAGE.label(image, background=background), measure.label(image, background=background))


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize(("function", "image", "arguments"), [
    ("remove_small_holes", np.array([[-1, 0, -1, 0, 0]]), [2]), ("remove_small_holes", np.array([[-128, 0]], "i1"), []),
    ("remove_small_objects", np.array([[-1, 0, 3]]), [0]), ("remove_small_objects", np.array([[5, 0, 3]], "u8"), [0]),
    ("remove_small_objects", np.array([[1, 2, 2]]), [float("nan")]),
    *(("remove_small_" + name, np.eye(3, dtype=bool), [2, connectivity]) for name in ("objects", "holes")
      for connectivity in (1.0, 2.0, np.int8(2)))])
def test_small_regions_are_removed_as_by_scikit_image_from_odd_arguments(function, image, arguments):
    assert_same(getattr(SKIMAGE, function)(image, *arguments), getattr(morphology, function)(image, *arguments))


def test_small_objects_of_uint64_are_removed_where_scikit_image_fails():
    image = np.array([[2**64 - 1, 2**64 - 1, 7, 0]], np.uint64)
    assert_same(SKIMAGE.remove_small_objects(image, 2), np.array([[2**64 - 1, 2**64 - 1, 0, 0]], np.uint64))


def test_a_table_of_no_labels_is_empty_where_scikit_image_fails():
    assert not any(map(len, SKIMAGE.regionprops_table(np.zeros((0, 3), int)).values()))


def test_labels_as_bool_are_those_of_scipy():
    assert_same(SCIPY.label([[1, 0, 1]], output=bool), ndimage.label([[1, 0, 1]], output=bool))


def arrays_in(result: Any) -> list[np.ndarray]:
    return [one for one in (result if isinstance(result, tuple) else [result]) if isinstance(one, np.ndarray)]


@pytest.mark.parametrize(("function", "arguments", "name", "dtype"), [
    (SCIPY.label, {}, "output", np.int16), (SCIPY.binary_fill_holes, {}, "output", np.int16),
    (SCIPY.distance_transform_edt, {}, "distances", float),
    (SCIPY.distance_transform_edt, {"return_distances": False, "return_indices": True}, "indices", np.int32),
    (SKIMAGE.remove_small_objects, {"min_size": 5}, "out", bool),
    (SKIMAGE.remove_small_holes, {"area_threshold": 5}, "out", bool), (CV2.thinning, {}, "dst", np.uint8),
    (CV2.connectedComponents, {"connectivity": 4}, "labels", np.int32),
    (CV2.distanceTransform, {"distanceType": 2, "maskSize": 0}, "dst", np.float32)])
def test_results_are_written_where_the_caller_says(function, arguments, name, dtype):
    image = random_image(7).astype(bool if dtype == bool else np.uint8)
    expected = arrays_in(function(image, **arguments))
    out = np.empty(expected[0].shape, dtype)
    returned = arrays_in(function(image, **arguments, **{name: out}))
    np.testing.assert_array_equal(out, expected[0])
    assert [one is out for one in returned] == ([] if name in ("output", "distances", "indices") else [True])


@pytest.mark.parametrize(("function", "source"), [
    (CV2.thinning, grey_levels(random_image(5), 5)),
    (lambda image, out: SKIMAGE.remove_small_objects(image, 5, out=out), random_image(7))])
def test_the_image_may_become_the_result(function, source):
    expected = function(source, np.empty_like(source))
    assert function(source, source) is source
    np.testing.assert_array_equal(source, expected)


# Octave's results, which are recorded.

def test_bwmorph_thins_as_octave_with_any_limit():
    limits = [iteration_limit(seed) for seed in range(CASES)]
    assert_recorded("thin", [
        compat.bwmorph(random_image(seed), "thin", np.inf if limit is None else limit)
        for seed, limit in enumerate(limits)])


@pytest.mark.parametrize("operation", OPERATIONS)
def test_bwmorph_equals_octave(operation):
    assert_recorded(operation, [compat.bwmorph(random_image(seed), operation, repetitions(seed))
                                for seed in range(OPERATION_CASES)])


def test_bwmorph_with_inf_repeats_until_nothing_changes():
    assert not compat.bwmorph(np.pad(random_image(5), 1), "erode", np.inf).any()
