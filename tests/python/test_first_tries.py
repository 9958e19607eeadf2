"""What people type first: photographs, masked arrays, names that are nearly right."""

from __future__ import annotations

import numpy as np
import pytest

import thinbench
from images import random_image
from thinbench import Rule, compat
from record_bwmorph import OPERATION_CASES, OPERATIONS, assert_recorded, repetitions

PHOTO = np.random.RandomState(1).randint(0, 256, (40, 60, 3)).astype(np.uint8)


@pytest.mark.parametrize("samples", [3, 4])
@pytest.mark.parametrize("function", [thinbench.thin, thinbench.apply, thinbench.distance, thinbench.fill_holes,
                                      thinbench.regions, thinbench.graph, thinbench.label])
def test_a_photograph_is_rejected_with_the_way_to_a_binary_image(function, samples):
    photo = np.dstack([PHOTO, PHOTO[..., 0]])[..., :samples]
    with pytest.raises(ValueError, match=r"shape \(40, 60, \d\), which looks like colours; `thinbench.binarise\("):
        function(photo)


def test_a_stack_three_pixels_wide_needs_a_word():
    stack = (PHOTO > 100).astype(np.uint8)
    with pytest.raises(ValueError, match="stack=True"):
        thinbench.thin(stack)
    expected = [thinbench.thin(image) for image in stack]
    np.testing.assert_array_equal(thinbench.thin(stack, stack=True), expected)
    np.testing.assert_array_equal(thinbench.thin_many(list(stack)), expected)
    np.testing.assert_array_equal(thinbench.thin(stack != 0), np.array(expected) != 0)
    with pytest.raises(ValueError, match=r"\(H, W\)"):
        thinbench.thin(np.ones((5, 6, 7), bool), stack=False)


@pytest.mark.parametrize("function", [thinbench.thin, thinbench.distance, thinbench.edges, thinbench.localise,
                                      thinbench.binarise, thinbench.thin_labels])
def test_masked_elements_are_rejected(function):
    image = np.ma.masked_array(np.ones((4, 5), np.uint8), mask=np.zeros((4, 5), bool))
    function(image)
    image.mask[1, 2] = True
    with pytest.raises(ValueError, match="expected no masked elements, got 1"):
        function(image)


def test_errors_of_lists_name_the_element():
    with pytest.raises(TypeError, match=r"^images\[2\]: expected dtype bool or uint8, got float64"):
        thinbench.thin_many([np.ones((3, 3), bool), np.ones((4, 4), np.uint8), np.ones((3, 3))])


def test_errors_of_prune_and_graph_name_their_own_arguments():
    skeleton = thinbench.thin(random_image(3))
    with pytest.raises(ValueError, match=r"^min_widths: expected image=\.\.\., .* got 1 without$"):
        thinbench.prune(skeleton, min_widths=1)
    for function in (thinbench.prune, thinbench.graph):
        with pytest.raises(TypeError, match="^skeleton: expected dtype"):
            function(skeleton.astype(float))


@pytest.mark.parametrize("operation", OPERATIONS)
def test_bwmorph_knows_every_operation_that_named_rules_know(operation):
    assert_recorded(operation, [compat.bwmorph(random_image(seed), operation, repetitions(seed))
                                for seed in range(OPERATION_CASES)])


def test_bwmorph_with_inf_repeats_until_nothing_changes():
    image = random_image(5)
    assert not compat.bwmorph(np.pad(image, 1), "erode", np.inf).any()
    with pytest.raises(ValueError, match="may never end"):
        compat.bwmorph(image, "majority", np.inf)


@pytest.mark.parametrize("call, said", [
    (lambda: thinbench.thin(np.ones((3, 3), bool), "guohall"), "did you mean 'guo_hall'?"),
    (lambda: thinbench.thin(np.ones((3, 3), bool), "thin_zhangsuen"), "did you mean 'thin_zhang_suen'?"),
    (lambda: Rule.named("majorty"), "did you mean 'majority'?"),
    (lambda: thinbench.edges(np.ones((3, 3), np.uint8), "sobell"), "did you mean 'sobel'?"),
    (lambda: thinbench.thin(np.ones((3, 3), bool), border="kep"), "did you mean 'keep'?"),
    (lambda: compat.bwmorph(np.ones((3, 3)), "cleen"), "did you mean 'clean'?")])
def test_names_that_are_nearly_right_are_recognised(call, said):
    with pytest.raises((ValueError, NotImplementedError), match="^[^\n]*$") as failure:
        call()
    assert str(failure.value).endswith(said)


@pytest.mark.parametrize("rule", [name for name in thinbench.rules() if not name.startswith("net_")])
def test_operations_of_the_program_are_names_of_rules(rule):
    operation = "skeleton_scan" if rule == "midpoint_scan" else f"thin_{rule}"
    image = random_image(4)
    np.testing.assert_array_equal(thinbench.thin(image, operation), thinbench.thin(image, rule))


def test_a_graph_says_in_a_line_what_it_is():
    cross = np.array([[0, 1, 0, 0], [1, 1, 1, 1], [0, 1, 0, 0]], bool)
    assert repr(thinbench.graph(cross)) == "Graph(5 nodes (4 end, 1 junction), 4 edges of length 5.0)"
    assert repr(thinbench.graph(np.zeros((2, 2), bool))) == "Graph(0 nodes, 0 edges of length 0.0)"


def test_a_graph_is_plotted_as_lines_and_points():
    figure = pytest.importorskip("matplotlib.figure").Figure()
    graph = thinbench.graph(thinbench.thin(random_image(6)), not_thin="ignore")
    ax = figure.add_subplot()
    assert graph.plot(ax) is ax
    ends = sum(len(line.get_xdata()) for line in ax.lines if line.get_label() == "end")
    assert ends == (graph.nodes["kind"] == "end").sum()
    lines = [line for line in ax.lines if line.get_linestyle() == "-"]
    assert len(lines) == len(graph.edges["length"])
    bottom, top = ax.get_ylim()
    assert bottom > top
    graph.plot(ax)
    assert ax.get_ylim() == (bottom, top)


@pytest.mark.parametrize("dtype", [bool, "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8"])
def test_label_arrays_of_any_integer_type(dtype):
    labels = thinbench.label(random_image(7))[0] % 2
    expected = thinbench.thin_labels(labels)
    found = thinbench.thin_labels(labels.astype(dtype))
    assert found.dtype == dtype
    np.testing.assert_array_equal(found, expected.astype(dtype))


@pytest.mark.parametrize("value, dtype", [(2**31, "u4"), (2**40, "i8"), (2**63, "u8"), (-2**40, "i8"), (-1, "i2")])
def test_labels_that_do_not_fit_are_rejected(value, dtype):
    labels = np.ones((3, 4), dtype)
    labels[1, 1] = value
    with pytest.raises(ValueError, match=str(value)):
        thinbench.thin_labels(labels)
