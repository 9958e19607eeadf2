"""Arrays and arguments of any kind: the result of plain copies, or one line that names the argument.
THINBENCH_FUZZ_EXAMPLES sets how many calls of each kind are tried, other ones in every run."""

from __future__ import annotations

import os
import pickle
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

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


OPTIONS = st.fixed_dictionaries({
    "rule": arguments(st.sampled_from(RULES), "guo_hall"),
    "border": arguments(st.sampled_from(["background", "keep", "foreground"]), None),
    "max_iterations": arguments(st.integers(1, 4), None), "threads": arguments(st.integers(1, 3), 1)})
NAMES = f"images?|rule|{'|'.join(NAMED)}|custom|border|max_iterations|threads|out"
LEVELS = arguments(st.integers(0, 255), 40)
TABLES = st.one_of(arrays(("?", "u1"), 1), st.builds(lambda seed: pixels((512,), "?", seed), st.integers(0, 9)),
                   st.builds(lambda seed: pixels((2, 512), "u1", seed) != 0, st.integers(0, 9)), ODD)


def thin_packed(packed: Any, width: Any, order: Any, options: dict[str, Any]) -> Any:
    """Mostly with a width that fits."""
    if packed.ndim == 2 and isinstance(width, int) and width == 200:
        width = 8 * packed.shape[1]
    return thinbench.thin_packed(packed, width, bit_order=order, return_iterations=True, **options)


def rule_of_tables(tables: Any, border: Any, limit: Any, image: Any) -> Any:
    return thinbench.apply(image, thinbench.Rule(tables, border=border, max_iterations=limit))


EDGES = "image|gradient_threshold|gradient threshold|brightness_threshold|brightness threshold"
CALLS: dict[str, tuple[str, Callable[..., Any], list[st.SearchStrategy[Any]]]] = {
    "thin": (NAMES, lambda image, options: thinbench.thin(image, return_iterations=True, **options),
             [st.one_of(arrays(), arrays(dimensions=3)), OPTIONS]),
    "thin_many": (NAMES, lambda images, options: thinbench.thin_many(images, **options),
                  [st.lists(arrays(), max_size=4), OPTIONS]),
    "thin_labels": ("labels|label|" + NAMES, lambda labels, options: thinbench.thin_labels(labels, **options),
                    [arrays(("u2", ">u2", "i4")), OPTIONS]),
    "thin_packed": ("packed|width|bit_order|" + NAMES, thin_packed,
                    [arrays(("u1",)), st.one_of(st.integers(-1, 200), ODD),
                     arguments(st.sampled_from(["big", "little"]), "big"), OPTIONS]),
    **{name: ("image", getattr(thinbench, name), [arrays()]) for name in (
        "label_regions", "fill_holes", "euler_number", "distances", "squared_distances", "midpoint_scan",
        "classify_pixels")},
    "binarise": ("image", thinbench.binarise, [arrays(("?", "u1", "u2"))]),
    "label_values": ("image", thinbench.label_values, [arrays(("u1", "i4", "i8"))]),
    "detect_edges": (EDGES + "|operator", thinbench.detect_edges, [
        arrays(("u1",)), arguments(st.sampled_from(["sobel", "roberts4", "mero_vassy_5x5"]), "sobel"), LEVELS, LEVELS]),
    "localise_objects": (EDGES, thinbench.localise_objects, [arrays(("u1",)), LEVELS, LEVELS]),
    "a rule of tables": ("tables|sub_iterations|border|max_iterations|image|custom", rule_of_tables, [
        TABLES, arguments(st.sampled_from(["background", "keep", "foreground"]), "background"),
        arguments(st.integers(1, 3), 1), arrays()]),
    "a notation": ("notation|rule", lambda notation: thinbench.Rule.from_hensel(notation, max_iterations=1),
                   [st.one_of(st.text("BbSs/0123456789-cekainyqjrtwz ", max_size=12), ODD)]),
}


def plain(value: Any) -> Any:
    """With copies of the arrays: by rows, aligned, writable and in the machine's order of bytes."""
    if isinstance(value, list):
        return [plain(one) for one in value]
    return value.astype(value.dtype.newbyteorder("="), order="C") if isinstance(value, np.ndarray) else value


@pytest.mark.parametrize("name", CALLS)
@SETTINGS
@given(st.data())
def test_a_call_gives_what_it_gives_with_plain_copies_or_names_the_argument(name, data):
    names, call, strategies = CALLS[name]
    drawn = [data.draw(strategy) for strategy in strategies]
    copies = [plain(value) for value in drawn]
    result = result_or_reason(names, call, *drawn)
    if result is not None:
        np.testing.assert_equal(result, call(*copies))
    np.testing.assert_equal(plain(drawn), copies)


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
