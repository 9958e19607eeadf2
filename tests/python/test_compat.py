"""The functions with other projects' names give those projects' pixels."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from images import iteration_limit, random_image
from record_bwmorph import CASES, assert_recorded
from thinbench import compat

cv2 = pytest.importorskip("cv2")
morphology = pytest.importorskip("skimage.morphology")
CV2_TYPES = [compat.cv2.THINNING_ZHANGSUEN, compat.cv2.THINNING_GUOHALL]
DTYPES = [bool, np.uint8, np.int32, np.float64]
many = settings(max_examples=500, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


VIEWS = {
    "plain": lambda image: image,
    "transposed": lambda image: image.T,
    "flipped": lambda image: image[::-1, ::-1],
    "every other column": lambda image: image[:, ::2],
    "part": lambda image: image[1:-1, 2:-1],
    "without rows": lambda image: image[:0],
    "without columns": lambda image: image[:, :0],
}


def images() -> st.SearchStrategy[np.ndarray]:
    """Random images up to 300 x 300."""
    sides = st.sampled_from([8, 64, 64, 64, 64, 64, 64, 64, 64, 300])
    return st.builds(random_image, st.integers(0, 2**32 - 1), sides)


def views() -> st.SearchStrategy[Callable[[np.ndarray], np.ndarray]]:
    """Half of them the image itself."""
    return st.sampled_from([VIEWS["plain"]] * len(VIEWS) + [*VIEWS.values()])


def grey_levels(image: np.ndarray, seed: int) -> np.ndarray:
    """Foreground from 128 to 255, background from 0 to 127."""
    random = np.random.RandomState(seed)
    return (random.randint(0, 128, image.shape) + 128 * image).astype(np.uint8)


@many
@given(images(), views(), st.integers(0, 1000))
def test_cv2_thinning_equals_opencv(image, view, seed):
    source = view(grey_levels(image, seed))
    if source.size == 0:
        with pytest.raises(cv2.error):
            cv2.ximgproc.thinning(source)
        return
    for thinning_type in CV2_TYPES:
        expected = cv2.ximgproc.thinning(np.ascontiguousarray(source), thinningType=thinning_type)
        np.testing.assert_array_equal(
            compat.cv2.thinning(source, thinningType=thinning_type), expected)


@many
@given(images(), views(), st.sampled_from([None, 0, 1, 2, 3, 4, 5]), st.sampled_from(DTYPES))
def test_skimage_thin_equals_scikit_image(image, view, limit, dtype):
    source = view(image.astype(dtype))
    if source.size == 0:
        for function in (compat.skimage.thin, morphology.thin):
            with pytest.raises(ValueError):
                function(source)
        return
    np.testing.assert_array_equal(
        compat.skimage.thin(source, limit), morphology.thin(source, max_num_iter=limit))


@many
@given(images(), views(), st.sampled_from(DTYPES))
def test_skeletonize_equals_scikit_image(image, view, dtype):
    source = view(image.astype(dtype))
    np.testing.assert_array_equal(
        compat.skimage.skeletonize(source), morphology.skeletonize(source, method="zhang"))


def test_skimage_thin_takes_the_old_name_of_its_limit():
    image = random_image(2)
    with pytest.warns(FutureWarning, match="max_num_iter"):
        np.testing.assert_array_equal(compat.skimage.thin(image, max_iter=1), morphology.thin(image, 1))


@pytest.mark.parametrize("image", [[[0, 255, 255], [0, 255, 7]], [[0, 0.5, 1.5]], [[-1, 0, 1]]])
def test_skeletonize_takes_what_is_nonzero(image):
    np.testing.assert_array_equal(compat.skimage.skeletonize(image), morphology.skeletonize(np.array(image) != 0))


def test_bwmorph_equals_the_recorded_results_of_octave():
    limits = [iteration_limit(seed) for seed in range(CASES)]
    assert_recorded("thin", [
        compat.bwmorph(random_image(seed), "thin", np.inf if limit is None else limit)
        for seed, limit in enumerate(limits)])


def test_cv2_thinning_writes_into_dst_and_in_place():
    source = grey_levels(random_image(5), 5)
    expected = compat.cv2.thinning(source)
    target = np.empty_like(source)
    assert compat.cv2.thinning(source, target) is target
    np.testing.assert_array_equal(target, expected)
    compat.cv2.thinning(source, source)
    np.testing.assert_array_equal(source, expected)
