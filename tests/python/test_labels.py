"""Label images and lists of images equal each label and each image thinned alone."""

from __future__ import annotations

import numpy as np
import pytest

import thinbench
from images import random_image

DTYPES = [np.uint16, np.int32]


def random_labels(seed: int, dtype: type, max_side: int = 90) -> np.ndarray:
    """Random images cut into blocks, with sparse labels that recur."""
    image = random_image(seed, max_side)
    height, width = image.shape
    values = np.array([1, 2, 7, 500, 65535 if dtype == np.uint16 else 2**31 - 1], dtype)
    blocks = (np.arange(height)[:, None] // 14 * 3 + np.arange(width) // 20) % len(values)
    return values[blocks] * image.astype(dtype)


def one_after_another(labels: np.ndarray, *arguments, **options) -> tuple[np.ndarray, int]:
    """The labels thinned in a loop, and the maximum number of iterations."""
    result, most = np.zeros_like(labels), 0
    for label in np.unique(labels[labels != 0]):
        skeleton, iterations = thinbench.thin(labels == label, *arguments, return_iterations=True,
                                              **options)
        result[skeleton] = label
        most = max(most, iterations)
    return result, most


@pytest.mark.parametrize("rule", thinbench.rules())
@pytest.mark.parametrize("border", ["background", "keep"])
def test_each_label_is_thinned_as_if_alone(rule, border):
    for seed in range(12):
        labels = random_labels(seed, DTYPES[seed % 2])
        limit = (None, None, 1, 3)[seed % 4]
        expected = one_after_another(labels, rule, border=border, max_iterations=limit)
        result = thinbench.thin_labels(labels, rule, border=border, max_iterations=limit,
                                       threads=1 + seed % 3, return_iterations=True)
        np.testing.assert_array_equal(result[0], expected[0])
        assert result[0].dtype == labels.dtype and result[1] == expected[1]


@pytest.mark.parametrize("connectivity", [4, 8])
@pytest.mark.parametrize("dtype", [np.uint8, np.int32, np.int64])
def test_holes_are_filled_as_by_a_loop_over_scipy(connectivity, dtype):
    ndimage = pytest.importorskip("scipy.ndimage")
    structure = None if connectivity == 8 else np.ones((3, 3))
    for seed in range(12):
        labels = ndimage.label(random_image(seed, 60))[0].astype(dtype) % 7
        holes = {label: ndimage.binary_fill_holes(labels == label, structure) & (labels == 0)
                 for label in range(1, 7)}
        filled = thinbench.fill_label_holes(labels, connectivity=connectivity)
        assert filled.dtype == dtype
        np.testing.assert_array_equal(filled[labels != 0], labels[labels != 0])
        background = labels == 0
        np.testing.assert_array_equal(filled[background] != 0, sum(holes.values())[background] != 0)
        for label, hole in holes.items():
            assert hole[(filled == label) & background].all()
            alone = hole & (sum(one.astype(int) for one in holes.values()) == 1)
            assert (filled[alone] == label).all()


def test_holes_of_labels_up_to_an_area_are_filled_in_place():
    labels = np.array([[3, 3, 3, 3, 3, 3], [3, 0, 3, 0, 0, 3], [3, 3, 3, 3, 3, 3]])
    assert thinbench.fill_label_holes(labels, max_area=1, out=labels) is labels
    np.testing.assert_array_equal(labels[1], [3, 3, 3, 0, 0, 3])
    assert thinbench.fill_label_holes(labels.T[::-1], out=None).min() == 3


@pytest.mark.parametrize(("options", "error", "message"), [
    ({"connectivity": 6}, ValueError, "connectivity.*6"), ({"max_area": -1}, ValueError, "max_area.*-1"),
    ({"max_area": 1.5}, TypeError, "max_area.*1.5"), ({"out": np.zeros((2, 2))}, ValueError, "out.*float64")])
def test_holes_of_labels_reject_what_does_not_fit(options, error, message):
    with pytest.raises(error, match=message):
        thinbench.fill_label_holes(np.ones((2, 2), int), **options)


def test_labels_equal_a_loop_over_scikit_image():
    measure = pytest.importorskip("skimage.measure")
    morphology = pytest.importorskip("skimage.morphology")
    for seed in range(8):
        labels = random_labels(seed, np.int32)
        expected = np.zeros_like(labels)
        for region in measure.regionprops(labels % 1000 * (labels > 0)):
            top, left, bottom, right = region.bbox
            part = expected[top:bottom, left:right]
            skeleton = morphology.thin(np.pad(region.image, 1))[1:-1, 1:-1]
            part[skeleton] = labels[top:bottom, left:right][skeleton]
        np.testing.assert_array_equal(thinbench.thin_labels(labels, "guo_hall_skimage"), expected)


@pytest.mark.parametrize("dtype", DTYPES)
def test_views_and_out_of_any_kind_give_the_same_labels(dtype):
    base = np.stack([random_labels(4, dtype)] * 2, axis=-1)
    for view in (base[..., 0], base[::-1, ::-1, 1], base[..., 0].T, base[3:3, :, 0],
                 base[2:30, 3:].copy()[:, 1:, 0], np.ones((0, 5), dtype), np.ones((5, 0), dtype)):
        before = view.copy()
        expected = one_after_another(view)[0]
        np.testing.assert_array_equal(thinbench.thin_labels(view), expected)
        np.testing.assert_array_equal(view, before)
        out = np.ascontiguousarray(view)
        assert thinbench.thin_labels(out, out=out) is out
        np.testing.assert_array_equal(out, expected)


LABELS = np.ones((4, 4), np.int32)


@pytest.mark.parametrize(("call", "error", "message"), [
    (lambda out: thinbench.thin_labels(LABELS.astype(np.int64), out=out), ValueError, "int64"),
    (lambda out: thinbench.thin_labels(LABELS.astype(float)), TypeError, "float64"),
    (lambda out: thinbench.thin_labels(LABELS[0]), ValueError, r"\(4,\)"),
    (lambda out: thinbench.thin_labels(-LABELS, out=out), ValueError, "got -1 in row 0, column 0"),
    (lambda out: thinbench.thin_labels(LABELS, "zhang", out=out), ValueError, "'zhang'"),
    (lambda out: thinbench.thin_labels(LABELS, border="wrap", out=out), ValueError, "'wrap'"),
    (lambda out: thinbench.thin_labels(LABELS, max_iterations=0, out=out), ValueError, "got 0"),
    (lambda out: thinbench.thin_labels(LABELS, threads=0, out=out), ValueError, "got 0"),
    (lambda out: thinbench.thin_labels(LABELS, out=out.astype(np.uint16)), ValueError, "uint16"),
    (lambda out: thinbench.thin_many([np.ones((2, 2, 2), bool)]), ValueError, r"\(2, 2, 2\)"),
    (lambda out: thinbench.thin_many([np.ones((2, 2))]), TypeError, "float64"),
    (lambda out: thinbench.thin_many([], "zhang"), ValueError, "'zhang'"),
])
def test_invalid_arguments_are_rejected_in_one_line_and_nothing_is_written(call, error, message):
    out = np.full((4, 4), 9, np.int32)
    with pytest.raises(error, match=message) as caught:
        call(out)
    assert "\n" not in str(caught.value)
    assert (out == 9).all()


@pytest.mark.parametrize("options", [{}, {"rule": "spta", "border": "keep"},
                                     {"max_iterations": 2, "threads": 3}])
def test_list_of_mixed_sizes_equals_its_images_in_order(options):
    images = [random_image(seed % 17, 40) for seed in range(60)]
    images = [image if index % 3 else image * np.uint8(200) for index, image in enumerate(images)]
    images += [images[5].T, images[6][:, ::-1], np.ones((0, 4), bool)]
    before = [image.copy() for image in images]
    results = thinbench.thin_many(iter(images), **options)
    assert len(results) == len(images) and thinbench.thin_many([]) == []
    for image, result, unchanged in zip(images, results, before):
        assert result.dtype == image.dtype
        np.testing.assert_array_equal(result, thinbench.thin(image, **options))
        np.testing.assert_array_equal(image, unchanged)
