"""The functions with other projects' names give those projects' pixels."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from images import iteration_limit, pictures, random_image
from record_bwmorph import CASES, digest
from thinbench import compat

CV2_TYPES = [compat.cv2.THINNING_ZHANGSUEN, compat.cv2.THINNING_GUOHALL]
DTYPES = [bool, np.uint8, np.int32, np.float64]
many = settings(max_examples=2000, deadline=None, derandomize=True,
                suppress_health_check=list(HealthCheck))


@st.composite
def images(draw) -> np.ndarray:
    """Random images up to 300 x 300, some of them empty or views with strides."""
    max_side = draw(st.sampled_from([8, 64, 64, 64, 64, 64, 64, 64, 64, 300]))
    image = random_image(draw(st.integers(0, 2**32 - 1)), max_side)
    view = draw(st.sampled_from(
        ["plain", "transposed", "flipped", "every other column", "wide", "plain", "empty"]))
    if view == "transposed":
        return image.T
    if view == "flipped":
        return image[::-1]
    if view == "every other column":
        return image[:, ::2]
    if view == "empty":
        return image[:0] if draw(st.booleans()) else image[:, :0]
    return np.pad(image, 3)[3:-3, 3:-3] if view == "wide" else image


def grey_levels(image: np.ndarray, seed: int) -> np.ndarray:
    """Foreground from 128 to 255, background from 0 to 127."""
    random = np.random.RandomState(seed)
    return (random.randint(0, 128, image.shape) + 128 * image).astype(np.uint8)


@many
@given(images(), st.integers(0, 1000))
def test_cv2_thinning_equals_opencv(image, seed):
    cv2 = pytest.importorskip("cv2")
    source = grey_levels(image, seed)
    if image.size == 0:
        with pytest.raises(cv2.error):
            cv2.ximgproc.thinning(source)
        return
    for thinning_type in CV2_TYPES:
        expected = cv2.ximgproc.thinning(np.ascontiguousarray(source), thinningType=thinning_type)
        np.testing.assert_array_equal(
            compat.cv2.thinning(source, thinningType=thinning_type), expected)


@many
@given(images(), st.sampled_from([None, 0, 1, 2, 3, 4, 5]), st.sampled_from(DTYPES))
def test_skimage_thin_equals_scikit_image(image, limit, dtype):
    morphology = pytest.importorskip("skimage.morphology")
    source = image.astype(dtype)
    if image.size == 0:
        for function in (compat.skimage.thin, morphology.thin):
            with pytest.raises(ValueError):
                function(source)
        return
    np.testing.assert_array_equal(
        compat.skimage.thin(source, limit), morphology.thin(source, max_num_iter=limit))


@many
@given(images(), st.sampled_from(DTYPES))
def test_skeletonize_equals_scikit_image(image, dtype):
    morphology = pytest.importorskip("skimage.morphology")
    source = image.astype(dtype)
    np.testing.assert_array_equal(
        compat.skimage.skeletonize(source), morphology.skeletonize(source, method="zhang"))


def test_bwmorph_equals_the_recorded_results_of_octave():
    recorded = json.loads(Path(__file__).with_name("bwmorph.json").read_text())["hashes"]
    assert len(recorded) == CASES
    for seed, expected in enumerate(recorded):
        limit = iteration_limit(seed)
        thinned = compat.bwmorph(random_image(seed), "thin", np.inf if limit is None else limit)
        assert digest(thinned) == expected, seed


@pytest.mark.parametrize("path", pictures(), ids=lambda path: path.name)
def test_pictures_equal_all_peers(path):
    cv2 = pytest.importorskip("cv2")
    morphology = pytest.importorskip("skimage.morphology")
    grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    for thinning_type in CV2_TYPES:
        np.testing.assert_array_equal(
            compat.cv2.thinning(grey, thinningType=thinning_type),
            cv2.ximgproc.thinning(grey, thinningType=thinning_type))
    image = grey < 128
    for limit in [None, 0, 1, 2, 3, 4, 5]:
        np.testing.assert_array_equal(
            compat.skimage.thin(image, limit), morphology.thin(image, max_num_iter=limit))
    np.testing.assert_array_equal(
        compat.skimage.skeletonize(image), morphology.skeletonize(image, method="zhang"))


def test_opencv_counts_128_as_foreground_and_127_as_background():
    cv2 = pytest.importorskip("cv2")
    source = np.array([[127, 128, 255]], np.uint8)
    np.testing.assert_array_equal(compat.cv2.thinning(source), [[0, 255, 255]])
    np.testing.assert_array_equal(cv2.ximgproc.thinning(source), [[0, 255, 255]])


def test_cv2_thinning_writes_into_dst_and_in_place():
    source = grey_levels(random_image(5), 5)
    expected = compat.cv2.thinning(source)
    target = np.empty_like(source)
    assert compat.cv2.thinning(source, target) is target
    np.testing.assert_array_equal(target, expected)
    compat.cv2.thinning(source, source)
    np.testing.assert_array_equal(source, expected)


@pytest.mark.parametrize(("call", "error", "message"), [
    (lambda: compat.cv2.thinning(np.zeros((0, 3), np.uint8)), ValueError, r"\(0, 3\)"),
    (lambda: compat.cv2.thinning(np.zeros((3, 3), np.uint8), thinningType=7), ValueError, "7"),
    (lambda: compat.cv2.thinning(np.zeros((3, 3))), TypeError, "float64"),
    (lambda: compat.skimage.skeletonize(np.zeros((3, 3)), method="lee"), NotImplementedError,
     "scikit-image"),
    (lambda: compat.skimage.skeletonize(np.zeros((3, 3, 3))), NotImplementedError, "scikit-image"),
    (lambda: compat.skimage.skeletonize(np.zeros((3, 3)), method="other"), ValueError, "other"),
    (lambda: compat.skimage.thin(np.zeros(3)), ValueError, r"\(3,\)"),
    (lambda: compat.skimage.thin(np.zeros((3, 3)), -1), ValueError, "-1"),
    (lambda: compat.bwmorph(np.zeros((3, 3)), "skel"), NotImplementedError, "skel"),
    (lambda: compat.bwmorph(np.zeros((3, 3)), "thin", 1.5), ValueError, "1.5"),
])
def test_invalid_arguments_are_rejected_with_their_value(call, error, message):
    with pytest.raises(error, match=message):
        call()
