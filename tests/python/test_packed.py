"""Packed images from Python: equal to images of bytes; errors."""

from __future__ import annotations

import doctest
import importlib

import numpy as np
import pytest

import thinbench
from images import random_image


def test_example_in_docstring_holds():
    result = doctest.testmod(importlib.import_module("thinbench._packed"))
    assert result.failed == 0 and result.attempted > 0


@pytest.mark.parametrize("rule", thinbench.rules())
@pytest.mark.parametrize("bit_order", ["big", "little"])
def test_packed_equals_bytes(rule, bit_order):
    for seed in range(12):
        image = random_image(seed, 200)
        border = ("background", "keep")[seed % 2]
        limit = None if seed % 3 else 2
        expected, count = thinbench.thin(image, rule, border=border, max_iterations=limit,
                                         return_iterations=True)
        packed = np.packbits(image, axis=-1, bitorder=bit_order)
        before = packed.copy()
        result, iterations = thinbench.thin_packed(
            packed, image.shape[1], rule, bit_order=bit_order, border=border,
            max_iterations=limit, return_iterations=True)
        np.testing.assert_array_equal(result, np.packbits(expected, axis=-1, bitorder=bit_order))
        np.testing.assert_array_equal(packed, before)
        assert iterations == count


def test_any_strides_and_out():
    image = random_image(3, 200)
    expected = np.packbits(thinbench.thin(image), axis=-1)
    packed = np.packbits(image, axis=-1)
    width = image.shape[1]
    wide = np.full((2 * packed.shape[0], packed.shape[1] + 3), 255, np.uint8)
    for view in (wide[::2, :packed.shape[1]], wide[::-2, packed.shape[1]::-1][:, 1:]):
        view[:] = packed
        np.testing.assert_array_equal(thinbench.thin_packed(view, width), expected)
    assert thinbench.thin_packed(packed, width, out=packed) is packed
    np.testing.assert_array_equal(packed, expected)


@pytest.mark.parametrize("shape", [(0, 0), (0, 2), (3, 0)])
def test_empty_images_are_accepted(shape):
    assert thinbench.thin_packed(np.zeros(shape, np.uint8), 8 * shape[1]).shape == shape


@pytest.mark.parametrize(("call", "error", "message"), [
    (lambda p, out: thinbench.thin_packed(p.astype(int), 20, out=out), TypeError, "int64"),
    (lambda p, out: thinbench.thin_packed(p, 25, out=out), ValueError, r"\(H, 4\).*\(5, 3\)"),
    (lambda p, out: thinbench.thin_packed(p, 16, out=out), ValueError, r"\(H, 2\)"),
    (lambda p, out: thinbench.thin_packed(p[0], 20, out=out), ValueError, r"\(3,\)"),
    (lambda p, out: thinbench.thin_packed(p, -1, out=out), ValueError, "-1"),
    (lambda p, out: thinbench.thin_packed(p, 20.0, out=out), TypeError, "20.0"),
    (lambda p, out: thinbench.thin_packed(p, 20, "zhang", out=out), ValueError, "'zhang'"),
    (lambda p, out: thinbench.thin_packed(p, 20, bit_order="msb", out=out), ValueError, "'msb'"),
    (lambda p, out: thinbench.thin_packed(p, 20, max_iterations=0, out=out), ValueError, "got 0"),
    (lambda p, out: thinbench.thin_packed(p, 20, out=out[:4]), ValueError, r"\(4, 3\)"),
    (lambda p, out: thinbench.thin_packed(p, 20, threads=0, out=out), ValueError, "got 0"),
])
def test_invalid_arguments_are_rejected_in_one_line_and_nothing_is_written(call, error, message):
    packed = np.zeros((5, 3), np.uint8)
    out = np.full((5, 3), 90, np.uint8)
    with pytest.raises(error, match=message) as caught:
        call(packed, out)
    assert "\n" not in str(caught.value)
    assert (out == 90).all()
