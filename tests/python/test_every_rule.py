"""Every kind of rule, by a plain reference; label images, which are thinned label by label."""

from __future__ import annotations

import numpy as np
import pytest

import thinbench
from images import random_image
from thinbench import Rule


def random_tables(seed: int) -> np.ndarray:
    """Two tables that remove pixels, and often add some."""
    random = np.random.RandomState(seed)
    return ((np.arange(512) & 16) != 0) ^ (random.rand(2, 512) < 0.1)


def random_net(seed: int) -> Rule:
    return Rule.from_two_layer_net(np.random.RandomState(seed).randn(9, 9), ("sigmoid", "linear")[seed % 2])


def random_cluster(seed: int) -> Rule:
    return Rule.from_cluster([99, 200, 255], np.random.RandomState(seed).randint(-3, 4, (3, 9)))


KINDS = {name: name for name in thinbench.rules()} | {
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

WITH_TABLES = {name: used for name, rule in KINDS.items()
               if len((used := Rule.named(rule) if isinstance(rule, str) else rule).tables)}

every_rule = pytest.mark.parametrize("rule", KINDS.values(), ids=KINDS)
all_options = pytest.mark.parametrize("options", LIMITS + BORDERS, ids=str)


def or_reason(function, *arguments, **options):
    """The result of a call, or why it is rejected."""
    try:
        return function(*arguments, **options)
    except ValueError as error:
        assert "\n" not in str(error)
        return str(error)


def next_image(image: np.ndarray, table: np.ndarray, border: str) -> np.ndarray:
    """One sub-iteration, by a look-up for every pixel."""
    height, width = image.shape
    padded = np.pad(image, 1, constant_values=border == "foreground")
    windows = sum(padded[k // 3:k // 3 + height, k % 3:k % 3 + width].astype(int) << k
                  for k in range(9))
    result = table[windows]
    if border == "keep":
        for edge in (np.s_[0], np.s_[-1], np.s_[:, 0], np.s_[:, -1]):
            result[edge] = image[edge]
    return result


def reference(image: np.ndarray, rule: Rule) -> tuple[np.ndarray, int]:
    """The result and the number of iterations."""
    iterations = 0
    while rule.max_iterations is None or iterations < rule.max_iterations:
        changed = False
        for table in rule.tables:
            before, image = image, next_image(image, table, rule.border)
            changed |= not np.array_equal(image, before)
        iterations += 1
        if not changed:
            break
    return image, iterations


@pytest.mark.parametrize("rule", WITH_TABLES.values(), ids=WITH_TABLES)
@pytest.mark.parametrize("border", ["background", "keep", "foreground"])
def test_rules_with_tables_equal_the_reference(rule, border):
    limited = Rule(rule.tables, border=border, max_iterations=3)
    for seed in range(12):
        image = random_image(seed, 150)
        expected, iterations = reference(image, limited)
        result = thinbench.thin(image, rule, border=border, max_iterations=3, return_iterations=True)
        np.testing.assert_array_equal(result[0], expected)
        assert result[1] == iterations


def random_labels(seed: int) -> np.ndarray:
    """Random images cut into blocks, with sparse labels that recur; of both types."""
    dtype, last = ((np.uint16, 65535), (np.int32, 2**31 - 1))[seed % 2]
    image = random_image(seed, 90)
    height, width = image.shape
    values = np.array([1, 2, 7, 500, last], dtype)
    blocks = (np.arange(height)[:, None] // 14 * 3 + np.arange(width) // 20) % len(values)
    return values[blocks] * image.astype(dtype)


def label_by_label(labels: np.ndarray, rule="guo_hall", **options) -> tuple[np.ndarray, int]:
    """The labels thinned in a loop, and the maximum number of iterations."""
    result, iterations = np.zeros_like(labels), 0
    for label in np.unique(labels[labels != 0]):
        skeleton, count = thinbench.thin(labels == label, rule, return_iterations=True, **options)
        result[skeleton] = label
        iterations = max(iterations, count)
    return result, iterations


@every_rule
@all_options
def test_each_label_is_thinned_as_if_alone(rule, options):
    for seed in range(12):
        labels = random_labels(seed)
        result = or_reason(thinbench.thin_labels, labels, rule, threads=1 + seed % 3, return_iterations=True,
                           **options)
        if isinstance(result, str):
            used = Rule.named(rule) if isinstance(rule, str) else rule
            adds = any(table[(np.arange(512) & 16) == 0].any() for table in used.tables)
            assert ("adds pixels" in result and adds or
                    "background or keep for labels" in result and options.get("border", used.border) == "foreground" or
                    result == or_reason(thinbench.thin, labels != 0, rule, **options))
            return
        expected, iterations = label_by_label(labels, rule, **options)
        np.testing.assert_array_equal(result[0], expected)
        assert result[0].dtype == labels.dtype and result[1] == iterations


@pytest.mark.parametrize("seed", [4, 5])
def test_views_of_labels_and_out_give_the_same_labels(seed):
    base = np.stack([random_labels(seed)] * 2, axis=-1)
    for view in (base[..., 0], base[::-1, ::-1, 1], base[..., 0].T, base[3:3, :, 0],
                 base[2:30, 3:].copy()[:, 1:, 0], base[:0, :5, 0], base[:5, :0, 0]):
        before = view.copy()
        expected = label_by_label(view)[0]
        np.testing.assert_array_equal(thinbench.thin_labels(view), expected)
        np.testing.assert_array_equal(view, before)
        out = np.ascontiguousarray(view)
        assert thinbench.thin_labels(out, out=out) is out
        np.testing.assert_array_equal(out, expected)


def test_labels_equal_a_loop_over_scikit_image():
    measure = pytest.importorskip("skimage.measure")
    morphology = pytest.importorskip("skimage.morphology")
    for seed in range(1, 16, 2):
        labels = random_labels(seed)
        expected = np.zeros_like(labels)
        for region in measure.regionprops(labels % 1000 * (labels > 0)):
            top, left, bottom, right = region.bbox
            part = expected[top:bottom, left:right]
            skeleton = morphology.thin(np.pad(region.image, 1))[1:-1, 1:-1]
            part[skeleton] = labels[top:bottom, left:right][skeleton]
        np.testing.assert_array_equal(thinbench.thin_labels(labels, "guo_hall_skimage"), expected)


@pytest.mark.parametrize("dtype", [bool, "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8"])
def test_label_arrays_of_any_integer_type(dtype):
    labels = thinbench.label_image(random_image(7))[0] % 2
    expected = thinbench.thin_labels(labels)
    found = thinbench.thin_labels(labels.astype(dtype))
    assert found.dtype == dtype
    np.testing.assert_array_equal(found, expected.astype(dtype))


@pytest.mark.parametrize("rule", thinbench.rules())
def test_operations_of_the_program_are_names_of_rules(rule):
    image = random_image(4)
    np.testing.assert_array_equal(thinbench.thin(image, f"thin_{rule}"), thinbench.thin(image, rule))
