"""Holes of label images are filled label by label."""

from __future__ import annotations

import numpy as np
import pytest

import thinbench
from images import random_image


@pytest.mark.parametrize("connectivity", [4, 8])
@pytest.mark.parametrize("dtype", [np.uint8, np.int32, np.int64])
def test_holes_are_filled_as_by_a_loop_over_scipy(connectivity, dtype):
    ndimage = pytest.importorskip("scipy.ndimage")
    structure = None if connectivity == 8 else np.ones((3, 3))
    for seed in range(12):
        labels = ndimage.label(random_image(seed, 60))[0].astype(dtype) % 7
        holes = {label: ndimage.binary_fill_holes(labels == label, structure) & (labels == 0)
                 for label in range(1, 7)}
        filled = thinbench.fill_holes_of_labels(labels, connectivity=connectivity)
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
    assert thinbench.fill_holes_of_labels(labels, max_area=1, out=labels) is labels
    np.testing.assert_array_equal(labels[1], [3, 3, 3, 0, 0, 3])
    assert thinbench.fill_holes_of_labels(labels.T[::-1], out=None).min() == 3
