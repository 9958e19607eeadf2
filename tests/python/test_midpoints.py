"""The midpoint scan against runs found by NumPy."""

import numpy as np
import pytest

import thinbench
from images import random_image

DIRECTIONS = {"rows": (0, 1), "columns": (1, 0), "diagonals": (1, 1), "antidiagonals": (1, -1)}


def marks(image: np.ndarray, step: tuple[int, int]) -> np.ndarray:
    """The midpoint of every run along a direction, the first of two."""
    result = np.zeros_like(image)
    padded = np.pad(image, 1)
    for y, x in np.argwhere(image):
        if padded[y + 1 - step[0], x + 1 - step[1]]:
            continue
        length = 1
        while padded[y + 1 + length * step[0], x + 1 + length * step[1]]:
            length += 1
        result[y + (length - 1) // 2 * step[0], x + (length - 1) // 2 * step[1]] = True
    return result


@pytest.mark.parametrize("directions", [*([name] for name in DIRECTIONS), [*DIRECTIONS], [], ["rows", "diagonals"]])
def test_midpoints_are_those_of_the_runs(directions):
    for seed in range(5):
        image = random_image(seed)
        expected = np.zeros_like(image)
        for name in directions:
            expected |= marks(image, DIRECTIONS[name])
        np.testing.assert_array_equal(thinbench.midpoint_scan(image, directions), expected)


def test_the_border_is_kept_on_request_and_the_result_may_replace_the_image():
    image = np.ones((6, 9), np.uint8)
    kept = thinbench.midpoint_scan(image, "rows", border="keep")
    assert (kept[[0, -1]] == 255).all() and (kept[1:-1, 1:-1] == thinbench.midpoint_scan(image, "rows")[1:-1, 1:-1]).all()
    thinbench.midpoint_scan(image, "rows", border="keep", out=image)
    np.testing.assert_array_equal(image, kept)
