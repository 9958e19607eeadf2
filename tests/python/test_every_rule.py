"""Every function takes every kind of rule, and gives what `thin` gives for each image alone."""

from __future__ import annotations

import numpy as np
import pytest

import thinbench
from images import random_image
from test_rules import reference
from thinbench import Rule


def random_tables(seed: int) -> np.ndarray:
    """Two tables that remove pixels, and often add some."""
    random = np.random.RandomState(seed)
    return ((np.arange(512) & 16) != 0) ^ (random.rand(2, 512) < 0.1)


def random_net(seed: int) -> Rule:
    return Rule.two_layer_net(np.random.RandomState(seed).randn(9, 9), ("sigmoid", "linear")[seed % 2])


def random_cluster(seed: int) -> Rule:
    return Rule.cluster([99, 200, 255], np.random.RandomState(seed).randint(-3, 4, (3, 9)))


KINDS = {
    "built-in": "guo_hall",
    "5 x 5": "mb2",
    "sequential": "spta",
    "of an operation": "thin_lu_wang",
    "named": "majority",
    "named, with a border": "erode",
    "named, without a limit": "golay_l",
    "tables": Rule(random_tables(1), max_iterations=3),
    "tables that remove": Rule(random_tables(2) & (np.arange(512) & 16 != 0), border="keep"),
    "notation": Rule.from_hensel("B3/S23", max_iterations=4),
    "two-layer net": random_net(4),
    "linear net": random_net(5),
    "cluster": random_cluster(6),
}
LIMITS = [{}, {"max_iterations": 2}, {"border": "background", "max_iterations": 2**31 - 1}]
BORDERS = [{"border": border} for border in ("background", "keep", "foreground")]

every_rule = pytest.mark.parametrize("rule", KINDS.values(), ids=KINDS)
all_options = pytest.mark.parametrize("options", LIMITS + BORDERS, ids=str)


def one_by_one(images, rule, **options) -> tuple[list[np.ndarray], int]:
    """The results, and the maximum number of iterations."""
    results = [thinbench.thin(image, rule, return_iterations=True, **options) for image in images]
    return [image for image, _ in results], max((count for _, count in results), default=0)


def or_reason(function, *arguments, **options):
    """The result of a call, or why it is rejected."""
    try:
        return function(*arguments, **options)
    except ValueError as error:
        assert "\n" not in str(error)
        return str(error)


@every_rule
@pytest.mark.parametrize("border", ["background", "keep", "foreground"])
def test_rules_with_tables_equal_the_reference(rule, border):
    used = Rule.named(rule) if isinstance(rule, str) else rule
    if len(used.tables) == 0:
        return
    limited = Rule(used.tables, border=border, max_iterations=3)
    for seed in range(12):
        image = random_image(seed, 150)
        expected, iterations = reference(image, limited)
        result = thinbench.thin(image, rule, border=border, max_iterations=3, return_iterations=True)
        np.testing.assert_array_equal(result[0], expected)
        assert result[1] == iterations


@every_rule
@all_options
def test_stacks_and_lists(rule, options):
    images = [random_image(seed % 23, 70) for seed in range(40)]
    results = or_reason(thinbench.thin_many, images, rule, threads=2, **options)
    expected = or_reason(one_by_one, images, rule, **options)
    if isinstance(expected, str):
        assert results == expected
        return
    for image, result in zip(expected[0], results):
        np.testing.assert_array_equal(result, image)
    stack = np.random.RandomState(3).rand(20, 21, 33) < 0.6
    expected, iterations = one_by_one(stack, rule, **options)
    result = thinbench.apply(stack, rule, return_iterations=True, **options)
    np.testing.assert_array_equal(result[0], expected)
    assert result[1] == iterations


@every_rule
@all_options
def test_packed_images(rule, options):
    for seed in range(6):
        image = random_image(seed, 200)
        expected = or_reason(thinbench.thin, image, rule, **options)
        packed = np.packbits(image, axis=-1)
        result = or_reason(thinbench.thin_packed, packed, image.shape[1], rule, **options)
        if isinstance(expected, str):
            assert result == expected
        else:
            np.testing.assert_array_equal(result, np.packbits(expected, axis=-1))


@every_rule
@all_options
def test_labels(rule, options):
    for seed in range(6):
        image = random_image(seed, 90)
        labels = image * (1 + np.arange(image.shape[1]) // 20 % 5).astype(np.int32)
        result = or_reason(thinbench.thin_labels, labels, rule, **options)
        if isinstance(result, str):
            assert "label" in result or result == or_reason(thinbench.thin, image, rule, **options)
            return
        expected = np.zeros_like(labels)
        for label in np.unique(labels[labels > 0]):
            expected[thinbench.thin(labels == label, rule, **options)] = label
        np.testing.assert_array_equal(result, expected)


@every_rule
@all_options
def test_dask_arrays(rule, options):
    da = pytest.importorskip("dask.array")
    tb_dask = pytest.importorskip("thinbench.dask")
    for seed in range(3):
        image = random_image(seed, 90)
        array = da.from_array(image, chunks=(31, 40))
        result = or_reason(tb_dask.thin, array, rule, depth=16, **options)
        if isinstance(result, str):
            assert "no bound" in result or result == or_reason(thinbench.thin, image, rule, **options)
            return
        np.testing.assert_array_equal(result.compute(scheduler="synchronous"),
                                      thinbench.thin(image, rule, **options))


IMAGE = np.ones((4, 4), bool)
LABELS = IMAGE.astype(np.int32)
PACKED = np.packbits(IMAGE, axis=-1)
ADDING = Rule.from_hensel("B3/S23")


@pytest.mark.parametrize(("call", "message"), [
    (lambda: thinbench.thin_labels(LABELS, "majority"), "adds pixels"),
    (lambda: thinbench.thin_labels(LABELS, ADDING, max_iterations=1), "adds pixels"),
    (lambda: thinbench.thin_labels(LABELS, "guo_hall", border="foreground"), "foreground"),
    (lambda: thinbench.thin_labels(LABELS, "erode"), "foreground"),
    (lambda: thinbench.thin(IMAGE, ADDING), "max_iterations"),
    (lambda: thinbench.thin_many([IMAGE], ADDING), "max_iterations"),
    (lambda: thinbench.thin_many([], ADDING), "max_iterations"),
    (lambda: thinbench.thin_packed(PACKED, 4, ADDING), "max_iterations"),
    (lambda: thinbench.thin(IMAGE, "life", max_iterations=2**31 - 1), "max_iterations"),
    (lambda: thinbench.thin(IMAGE, "mb2", border="foreground"), "foreground"),
    (lambda: thinbench.thin_many([IMAGE], "spta", border="foreground"), "foreground"),
    (lambda: thinbench.thin_packed(PACKED, 4, "midpoint_scan", border="foreground"), "foreground"),
])
def test_what_a_function_cannot_do_is_rejected_in_one_line(call, message):
    with pytest.raises(ValueError, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)
