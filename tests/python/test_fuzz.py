"""Arrays and arguments of any kind: the pixels of a plain copy, or one line that names the argument.
THINBENCH_FUZZ_EXAMPLES sets how many calls of each kind are tried, other ones in every run."""

from __future__ import annotations

import os
import pickle
import re
from collections.abc import Callable
from typing import Any

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy import ndimage

import thinbench

EXAMPLES = os.environ.get("THINBENCH_FUZZ_EXAMPLES")
SETTINGS = settings(max_examples=int(EXAMPLES or 150), derandomize=EXAMPLES is None, deadline=None,
                    database=None, suppress_health_check=list(HealthCheck))
NAMED = [*thinbench.rules(), *thinbench.named_rules()]
RULES = [*NAMED, thinbench.Rule.from_hensel("B3/S23"), thinbench.Rule.named("net_two_layer_linear")]
DTYPES = ["?", "u1", "i1", "u2", ">u2", "i4", ">i4", "i8", "f4", "f8", "c8", "O", "S1", "U2", "M8[s]",
          [("a", "u1"), ("b", "?")]]
ODD = st.one_of(st.none(), st.booleans(), st.text(max_size=5), st.floats(), st.binary(max_size=3),
                st.integers(), st.sampled_from([2**31, -2**31 - 1, 2**63, 2**64, [], {}, RULES, np.int8(2),
                                                np.array(1), np.array([1, 2]), np.float32(1)]))


def arguments(usual: st.SearchStrategy[Any], default: Any) -> st.SearchStrategy[Any]:
    """Mostly what is allowed; at times anything."""
    return st.one_of(st.just(default), usual, usual, usual, ODD)


def pixels(shape: tuple[int, ...], dtype: Any, seed: int) -> np.ndarray:
    """Noise; of dtypes that are not numbers, whatever NumPy makes of it."""
    random = np.random.RandomState(seed)
    noise = np.asarray(random.randint(0, 3, shape) * random.randint(0, 2, shape))
    return noise.astype(dtype) if np.dtype(dtype).fields is None else np.zeros(shape, dtype)


@st.composite
def arrays(draw: st.DrawFn, usual: tuple[Any, ...] = ("?", "u1"), dimensions: int = 2) -> np.ndarray:
    """Of any dtype, shape, order, strides and alignment, though mostly of those that are accepted."""
    is_usual = draw(st.integers(0, 4)) > 0
    dtype = draw(st.sampled_from(usual if is_usual else DTYPES))
    count = dimensions if is_usual else draw(st.integers(0, 4))
    shape = tuple(draw(st.lists(st.integers(0, 24), min_size=count, max_size=count)))
    array = pixels(shape, dtype, draw(st.integers(0, 99)))
    layout = draw(st.sampled_from(["plain", "fortran", "steps", "broadcast", "unaligned", "read-only", "unpickled"]))
    if layout == "fortran":
        array = np.asfortranarray(array)
    if layout == "steps" and shape:
        steps = [draw(st.sampled_from([-2, -1, 1, 1, 2, 3])) for _ in shape]
        array = array[tuple(slice(None, None, step) for step in steps)]
    if layout == "broadcast" and array.ndim > 0 and array.shape[0] > 0:
        array = np.broadcast_to(array[:1], array.shape)
    if layout == "unaligned" and array.dtype != object:
        memory = np.zeros(array.nbytes + 1, np.uint8)[1:]
        memory[...] = np.frombuffer(array.tobytes(), np.uint8)
        array = memory.view(array.dtype).reshape(array.shape)
    if layout == "unpickled":
        array = pickle.loads(pickle.dumps(array))
    if layout == "read-only":
        array.flags.writeable = False
    return array


def result_or_reason(names: str, call: Callable[..., Any], *positional: Any, **named: Any) -> Any:
    """None if the call is rejected, by one line that names one of the arguments."""
    try:
        return call(*positional, **named)
    except (TypeError, ValueError) as error:
        assert re.match(rf"({names})\b", str(error)) and "\n" not in str(error), str(error)
        return None


THINNING = {"rule": arguments(st.sampled_from(RULES), "guo_hall"),
            "border": arguments(st.sampled_from(["background", "keep", "foreground"]), None),
            "max_iterations": arguments(st.integers(1, 4), None),
            "threads": arguments(st.integers(1, 3), 1)}
NAMES = f"images?|rule|{'|'.join(NAMED)}|custom|border|max_iterations|threads|out"


@SETTINGS
@given(st.one_of(arrays(), arrays(dimensions=3)), st.fixed_dictionaries(THINNING))
def test_thin_gives_the_pixels_of_a_plain_copy_or_names_the_argument(image, options):
    before = image.copy()
    found = result_or_reason(NAMES, thinbench.thin, image, return_iterations=True, **options)
    if found is None:
        return
    result, iterations = found
    assert image.dtype in (bool, np.uint8) and image.ndim in (2, 3)
    assert result.shape == image.shape and result.dtype == image.dtype
    np.testing.assert_array_equal(image, before)
    foreground = np.ascontiguousarray(before != 0)
    images = foreground if image.ndim == 3 else foreground[None]
    expected = [thinbench.thin(np.ascontiguousarray(one), return_iterations=True, **options) for one in images]
    np.testing.assert_array_equal(result != 0, np.array([one for one, _ in expected]).reshape(image.shape))
    assert iterations == max((count for _, count in expected), default=0)


@SETTINGS
@given(arrays(), st.one_of(arrays(), ODD))
def test_out_receives_the_result_or_is_named(image, out):
    for function in (thinbench.thin, thinbench.fill_holes):
        before = np.copy(out)
        result = result_or_reason(NAMES, function, image, out=out)
        if result is None:
            assert not isinstance(out, np.ndarray) or out.tobytes() == before.tobytes()
        elif out is not None:
            assert result is out
            np.testing.assert_array_equal(out, function(image.copy()))


@SETTINGS
@given(st.lists(arrays(), max_size=4), st.fixed_dictionaries(THINNING))
def test_thin_many_gives_what_thin_gives_or_names_the_argument(images, options):
    results = result_or_reason(NAMES, thinbench.thin_many, images, **options)
    if results is None:
        return
    assert len(results) == len(images)
    for image, result in zip(images, results):
        np.testing.assert_array_equal(result, thinbench.thin(image, **options))


@SETTINGS
@given(arrays(("u2", "i4")), st.fixed_dictionaries(THINNING))
def test_thin_labels_gives_what_each_label_gives_or_names_the_argument(labels, options):
    result = result_or_reason("labels|label|" + NAMES, thinbench.thin_labels, labels, **options)
    if result is None:
        return
    expected = np.zeros(labels.shape, labels.dtype)
    for label in set(labels.ravel().tolist()) - {0}:
        expected[thinbench.thin(np.ascontiguousarray(labels == label), **options)] = label
    np.testing.assert_array_equal(result, expected)


@SETTINGS
@given(arrays(("u1",)), st.one_of(st.integers(-1, 200), ODD), arguments(st.sampled_from(["big", "little"]), "big"),
       st.fixed_dictionaries(THINNING))
def test_thin_packed_gives_what_thin_gives_or_names_the_argument(packed, width, order, options):
    names = "packed|width|bit_order|" + NAMES
    if packed.ndim == 2 and isinstance(width, int) and width == 200:
        width = 8 * packed.shape[1]
    found = result_or_reason(names, thinbench.thin_packed, packed, width, bit_order=order, return_iterations=True,
                             **options)
    if found is None:
        return
    image = np.unpackbits(np.ascontiguousarray(packed), axis=-1, count=width, bitorder=order)
    expected, iterations = thinbench.thin(image, return_iterations=True, **options)
    expected = np.packbits(expected != 0, axis=-1, bitorder=order)
    np.testing.assert_array_equal(found[0], expected.reshape(packed.shape))
    assert found[1] == iterations


@SETTINGS
@given(arrays())
def test_regions_filled_holes_and_distances_are_those_of_scipy_or_the_image_is_named(image):
    found = result_or_reason("image", thinbench.label_regions, image)
    filled = result_or_reason("image", thinbench.fill_holes, image)
    number = result_or_reason("image", thinbench.euler_number, image)
    assert (found is None) == (filled is None) == (number is None)
    if found is None:
        return
    table, labels = found
    objects, count = ndimage.label(image != 0, np.ones((3, 3)))
    np.testing.assert_array_equal(np.where(labels <= count, labels, 0), objects)
    np.testing.assert_array_equal(filled != 0, ndimage.binary_fill_holes(image != 0))
    assert number == count - int(table["is_hole"].sum())
    if not np.all(image):
        np.testing.assert_array_equal(thinbench.distances(image), ndimage.distance_transform_edt(image != 0))


@SETTINGS
@given(arrays(("u1",)), arguments(st.sampled_from(["sobel", "roberts4", "mero_vassy_5x5"]), "sobel"),
       arguments(st.integers(0, 255), 40), arguments(st.integers(0, 255), 128))
def test_edges_are_those_of_a_plain_copy_or_the_argument_is_named(image, operator, gradient, brightness):
    names = "image|operator|gradient_threshold|gradient threshold|brightness_threshold|brightness threshold"
    result = result_or_reason(names, thinbench.detect_edges, image, operator, gradient, brightness)
    if result is not None:
        np.testing.assert_array_equal(
            result, thinbench.detect_edges(np.array(image, order="C"), operator, gradient, brightness))
    found = result_or_reason(names, thinbench.localise_objects, image, gradient, brightness)
    if found is not None:
        again = thinbench.localise_objects(np.array(image, order="C"), gradient, brightness)
        for name, column in found.items():
            np.testing.assert_array_equal(column, again[name])


TABLES = st.one_of(arrays(("?", "u1"), 1), st.builds(lambda seed: pixels((512,), "?", seed), st.integers(0, 9)),
                   st.builds(lambda seed: pixels((2, 512), "u1", seed) != 0, st.integers(0, 9)), ODD)
RULE_NAMES = "tables|sub_iterations|border|max_iterations"


@SETTINGS
@given(TABLES, arguments(st.sampled_from(["background", "keep", "foreground"]), "background"),
       arguments(st.integers(1, 3), 1), arrays())
def test_rules_of_tables_are_applied_alike_to_copies_or_the_argument_is_named(tables, border, limit, image):
    rule = result_or_reason(RULE_NAMES, thinbench.Rule, tables, border=border, max_iterations=limit)
    if rule is None:
        return
    result = result_or_reason("image|custom", thinbench.apply, image, rule)
    if result is not None:
        np.testing.assert_array_equal(result, thinbench.apply(np.array(image, order="C"), rule))


@SETTINGS
@given(st.one_of(st.text("BbSs/0123456789-cekainyqjrtwz ", max_size=12), ODD))
def test_notations_are_read_or_named(notation):
    result_or_reason("notation|rule", thinbench.Rule.from_hensel, notation, max_iterations=1)
