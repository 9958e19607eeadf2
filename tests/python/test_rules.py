"""Rules: a plain reference, other projects' results, notations, files, errors, threads."""

from __future__ import annotations

import copy
import gc
import json
import os
import pickle
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import thinbench
from images import random_image
from record_bwmorph import OPERATION_CASES, OPERATIONS, assert_recorded, repetitions
from thinbench import Rule, compat
from waiting import in_eight_threads, longest_wait_during

ROOT = Path(__file__).resolve().parents[2]
BORDERS = ["background", "keep", "foreground"]
CENTRE = (np.arange(512) & 16) != 0
NEIGHBOURS = (5, 2, 1, 0, 3, 6, 7, 8)  # bits of the window from the east, anticlockwise


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


def random_rule(seed: int, border: str) -> Rule:
    """Tables that change many or few windows; a third of the rules only removes or adds pixels."""
    random = np.random.RandomState(seed)
    changes = random.rand(random.randint(1, 5), 512) < random.choice([0.02, 0.3, 0.5])
    tables = CENTRE ^ changes
    if seed % 3:
        return Rule(tables, border=border, max_iterations=random.randint(1, 6))
    return Rule(tables & CENTRE if seed % 2 else tables | CENTRE, border=border)


def assert_equals_reference(image: np.ndarray, rule: Rule) -> None:
    expected, iterations = reference(image, rule)
    result, count = thinbench.apply(image, rule, return_iterations=True)
    np.testing.assert_array_equal(result, expected)
    assert count == iterations


@pytest.mark.parametrize("border", BORDERS)
def test_random_rules_equal_the_reference(border):
    for seed in range(45):
        rule = random_rule(seed, border)
        for size in (8, 64, 64, 300):
            assert_equals_reference(random_image(100 * size + seed, size), rule)


@pytest.mark.parametrize("border", BORDERS)
def test_wide_images_and_eight_sub_iterations_equal_the_reference(border):
    random = np.random.RandomState(7)
    rule = Rule(CENTRE ^ (random.rand(8, 512) < 0.1), border=border, max_iterations=2)
    for shape in [(1, 1), (1, 700), (40, 1), (2, 2), (33, 513), (5, 1200)]:
        assert_equals_reference(random.rand(*shape) < 0.5, rule)


def test_stacks_strides_types_and_outputs():
    for seed in range(12):
        rule = random_rule(seed, BORDERS[seed % 3])
        random = np.random.RandomState(seed)
        stack = random.rand(37, 20, random.choice([9, 31, 140])) < 0.6
        expected = [reference(image, rule) for image in stack]
        images = np.array([image for image, _ in expected])
        for threads in (1, 3):
            result, iterations = thinbench.apply(stack, rule, threads=threads,
                                                 return_iterations=True)
            np.testing.assert_array_equal(result, images)
            assert iterations == max(count for _, count in expected)
        np.testing.assert_array_equal(thinbench.apply(stack.view(np.uint8) * 7, rule), images * 255)
        np.testing.assert_array_equal(thinbench.apply(stack[::2], rule), images[::2])
        assert thinbench.apply(stack, rule, out=stack) is stack
        np.testing.assert_array_equal(stack, images)


@pytest.mark.parametrize("border", BORDERS)
def test_in_place_and_threads_equal_the_reference(border):
    rule = Rule.from_hensel("B3/S23", border=border, max_iterations=3)
    image = np.random.RandomState(3).rand(1100, 1000) < 0.4
    expected, _ = reference(image, rule)
    np.testing.assert_array_equal(thinbench.apply(image, rule, threads=2), expected)
    thinbench.apply(image, rule, out=image)
    np.testing.assert_array_equal(image, expected)


@pytest.mark.parametrize("shape", [(0, 0), (0, 5), (5, 0), (0, 3, 4), (2, 0, 4)])
def test_empty_images_are_accepted(shape):
    for border in BORDERS:
        rule = Rule(np.ones(512, bool), border=border)
        assert thinbench.apply(np.ones(shape, bool), rule).shape == shape


# Other projects.

def test_tables_of_scikit_images_thin():
    skeletonize = pytest.importorskip("skimage.morphology._skeletonize")
    tables = [skeletonize.G123_LUT, skeletonize.G123P_LUT]
    for limit in (1, 2, None):
        rule = Rule.from_deletions(tables, max_iterations=limit)
        for seed in range(60):
            image = random_image(seed)
            np.testing.assert_array_equal(thinbench.apply(image, rule),
                                          skeletonize.thin(image, max_num_iter=limit))
    assert Rule.from_deletions(tables) == Rule.named("thin")


def test_table_of_scikit_images_skeletonize():
    morphology = pytest.importorskip("skimage.morphology")
    source = (ROOT / "reference" / "zhang_suen_skimage.cpp").read_text()
    values = np.array([int(digit) for digit in "".join(re.findall(r'"([0-3]{64})"', source))])
    by_descriptor = np.array([values & 1, values >> 1])
    rule = Rule.from_deletions(by_descriptor)
    # The same in scikit-image's own order, from the north-west clockwise.
    places = [NEIGHBOURS.index(pixel) for pixel in (0, 1, 2, 5, 8, 7, 6, 3)]
    descriptors = sum((np.arange(256) >> bit & 1) << place for bit, place in enumerate(places))
    assert Rule.from_deletions(by_descriptor[:, descriptors], "clockwise") == rule
    for seed in range(100):
        image = random_image(seed)
        np.testing.assert_array_equal(thinbench.apply(image, rule),
                                      morphology.skeletonize(image, method="zhang"))


def test_dilation_and_erosion_equal_scikit_image():
    morphology = pytest.importorskip("skimage.morphology")
    cross = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]], bool)
    for footprint in (np.ones((3, 3), bool), cross):
        dilate = Rule.from_function(lambda window: window[footprint].any(), max_iterations=1)
        erode = Rule.from_function(lambda window: window[footprint].all(), max_iterations=1,
                                         border="foreground")
        for seed in range(60):
            image = random_image(seed)
            np.testing.assert_array_equal(thinbench.apply(image, dilate),
                                          morphology.binary_dilation(image, footprint))
            np.testing.assert_array_equal(thinbench.apply(image, erode),
                                          morphology.binary_erosion(image, footprint))


@pytest.mark.parametrize("operation", OPERATIONS)
def test_named_rules_and_bwmorph_equal_the_recorded_results_of_octave(operation):
    once = operation in {"bridge", "clean", "fill", "hbreak", "remove"}
    limits = [1 if once else repetitions(seed) for seed in range(OPERATION_CASES)]
    assert_recorded(operation, [
        thinbench.apply(random_image(seed), operation, max_iterations=limit)
        for seed, limit in enumerate(limits)])
    assert_recorded(operation, [compat.bwmorph(random_image(seed), operation, repetitions(seed))
                                for seed in range(OPERATION_CASES)])


def test_bwmorph_with_inf_repeats_until_nothing_changes():
    assert not compat.bwmorph(np.pad(random_image(5), 1), "erode", np.inf).any()


def test_patterns_equal_pillow_inside_its_border():
    image_module = pytest.importorskip("PIL.Image")
    morph = pytest.importorskip("PIL.ImageMorph")
    for name in ["corner", "dilation4", "dilation8", "erosion4", "erosion8", "edge"]:
        builder = morph.LutBuilder(op_name=name)
        rule = Rule.from_patterns(builder.patterns, max_iterations=1)
        assert rule.tables[0].astype(np.uint8).tobytes() == builder.build_lut()
        operator = morph.MorphOp(lut=builder.build_lut())
        for seed in range(60):
            image = np.pad(random_image(seed), 2)
            pillow = image_module.fromarray(image.view(np.uint8) * np.uint8(255))
            expected = np.asarray(operator.apply(pillow)[1]) != 0
            np.testing.assert_array_equal(thinbench.apply(image, rule)[1:-1, 1:-1],
                                          expected[1:-1, 1:-1])


def by_convolution(boards: np.ndarray, generations: int) -> np.ndarray:
    ndimage = pytest.importorskip("scipy.ndimage")
    for _ in range(generations):
        count = ndimage.convolve(boards.astype(np.uint8), np.ones((1, 3, 3), np.uint8), mode="constant")
        boards = (count == 3) | (boards & (count == 4))
    return boards


@pytest.mark.parametrize("seed", range(20))
def test_fifty_boards_of_life_equal_a_convolution_for_200_generations(seed):
    random = np.random.RandomState(seed)
    boards = random.rand(50, *random.randint(1, 50, 2)) < random.uniform(0.1, 0.6, (50, 1, 1))
    life = Rule.from_hensel("B3/S23", max_iterations=200)
    np.testing.assert_array_equal(thinbench.apply(boards, life), by_convolution(boards, 200))
    np.testing.assert_array_equal(thinbench.apply(boards, life, max_iterations=7), by_convolution(boards, 7))


def population(cells: list[str], side: int, generations: int) -> int:
    board = np.zeros((side, side), np.uint8)
    for y, row in enumerate(cells, side // 2):
        for x, cell in enumerate(row, side // 2):
            board[y, x] = cell == "#"
    return np.count_nonzero(thinbench.apply(board, "life", max_iterations=generations, out=board))


@pytest.mark.parametrize(("cells", "side", "generations", "count"), [
    ([".##", "##.", ".#."], 600, 1103, 116), ([".#.....", "...#...", "##..###"], 2800, 5206, 633)],
    ids=["r-pentomino", "acorn"])
def test_patterns_of_life_have_their_known_numbers_of_cells(cells, side, generations, count):
    assert population(cells, side, generations) == count


# Tables and notations.

@pytest.mark.parametrize("kind", [bool, np.uint8, np.int64])
def test_tables_are_bits_of_any_type_and_read_only(kind):
    table = np.random.RandomState(1).rand(512) < 0.5
    rule = Rule(table.astype(kind), max_iterations=1)
    np.testing.assert_array_equal(rule.tables, table[None])
    assert rule.tables.dtype == bool
    with pytest.raises(ValueError):
        rule.tables[0, 0] = True
    with pytest.raises(ValueError):
        rule.tables.flags.writeable = True
    with pytest.raises(AttributeError):
        rule.border = "keep"


def test_makelut_and_function_agree():
    weights = np.random.RandomState(2).rand(3, 3) - 0.5

    def heavy(window: np.ndarray) -> bool:
        return bool((weights * window).sum() > 0)

    def by_columns(order: int) -> list[bool]:
        bits = [[index >> i & 1 for i in range(9)][::order] for index in range(512)]
        return [heavy(np.reshape(window, (3, 3), order="F")) for window in bits]

    expected = Rule.from_function(heavy, max_iterations=1)
    assert Rule.from_makelut(by_columns(1), max_iterations=1) == expected
    assert Rule.from_makelut(by_columns(-1), "octave", max_iterations=1) == expected
    both = Rule.from_makelut([by_columns(1)] * 2, max_iterations=1)
    np.testing.assert_array_equal(both.tables, np.repeat(expected.tables, 2, axis=0))


def test_hensel_equals_its_definition():
    def seeds_and_dots(window: np.ndarray) -> bool:
        neighbours = window.sum() - window[1, 1]
        return neighbours == 2 if not window[1, 1] else neighbours == 0

    assert (Rule.from_hensel("b2/s0", max_iterations=1)
            == Rule.from_function(seeds_and_dots, max_iterations=1))


def test_named_rules_are_listed_and_found():
    rules = thinbench.named_rules()
    assert list(rules) == sorted(rules) and len(rules) >= 16
    for name, rule in rules.items():
        assert rule == Rule.named(name) and rule.name == name
        assert rule.description and rule.source and not rule.is_built_in
    assert Rule.named("life") == Rule.from_hensel("B3/S23", max_iterations=1)


def test_gates_are_few_and_optimised_rules_have_no_more():
    assert Rule(CENTRE).gates == (0,)
    fast = Rule.named("majority")
    slow = Rule(fast.tables, max_iterations=1, optimise=True)
    assert 4 <= slow.gates[0] <= fast.gates[0] <= 25


def test_rules_are_values():
    rule = Rule.from_hensel("B3/S23", border="keep", max_iterations=4)
    for same in (pickle.loads(pickle.dumps(rule)), copy.copy(rule), copy.deepcopy(rule),
                 Rule(rule.tables, border="keep", max_iterations=4)):
        assert same == rule and hash(same) == hash(rule)
        np.testing.assert_array_equal(thinbench.apply(random_image(1), same),
                                      thinbench.apply(random_image(1), rule))
    assert rule != Rule.from_hensel("B3/S23", border="keep", max_iterations=5) and rule != "B3/S23"
    assert repr(rule) == "Rule(custom, 1 sub-iteration, border='keep', max_iterations=4)"


# Files.

def written(directory: Path, content: object) -> Path:
    path = directory / "rule.json"
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    return path


@pytest.mark.parametrize("name", ["thin", "life", "golay_l"])
def test_saved_rules_load_as_equal_ones(name, tmp_path):
    Rule.named(name).save(tmp_path / "rule.json")
    assert Rule.load(tmp_path / "rule.json") == Rule.named(name)


def test_every_kind_of_table_loads(tmp_path):
    random = np.random.RandomState(5)
    values = (random.rand(512) < 0.5).astype(int).tolist()
    patterns = ["4:(... .1. .0.)->0", "M:(1.. ... ...)->1"]
    kinds = [
        ({"raster": "".join(map(str, values))}, Rule(values, max_iterations=7)),
        ({"raster": "8" + 127 * "0"}, Rule(np.arange(512) == 0, max_iterations=7)),
        ({"makelut": values, "order": "octave"},
         Rule.from_makelut(values, "octave", max_iterations=7)),
        ({"remove": [value == 1 for value in values[:256]], "order": "raster"},
         Rule.from_deletions(values[:256], "raster", max_iterations=7)),
        ({"patterns": patterns}, Rule.from_patterns(patterns, max_iterations=7)),
        ({"hensel": "B3/S23"}, Rule.from_hensel("B3/S23", max_iterations=7)),
    ]
    for table, expected in kinds:
        path = written(tmp_path, {"name": "x", "sub_iterations": [table], "max_iterations": 7})
        assert Rule.load(path) == expected
    path = written(tmp_path, {"hensel": "B/S012345678", "border": "foreground"})
    assert Rule.load(str(path)) == Rule(CENTRE, border="foreground")


LIFE = '"hensel": "B3/S23", "max_iterations": 1'


@pytest.mark.parametrize(("content", "message"), [
    ("", "rule.json: Expecting value"),
    ("[]", "the outermost value must be an object"),
    ("{}", "either sub_iterations or hensel"),
    (f'{{{LIFE}, "hensel": "B3/S23"}}', 'the key "hensel" is repeated'),
    (f'{{{LIFE}, "colour": 1}}', 'unknown key "colour"'),
    (f'{{{LIFE}, "border": "wrap"}}', "border: .* 'wrap'"),
    (f'{{{LIFE}, "name": "a\\nb"}}', "name must have"),
    ('{"hensel": "B/S", "max_iterations": 0}', "at least 1, got 0"),
    ('{"hensel": "B/S", "max_iterations": true}', "expected an integer"),
    ('{"hensel": "B/S", "max_iterations": NaN}', "expected an integer, got nan"),
    ('{"hensel": 5}', "hensel is invalid: .* got 5"),
    ('{"hensel": "B9/S"}', "hensel is invalid: .* got '9'"),
    ('{"sub_iterations": []}', "list of 1 to 8 tables"),
    ('{"sub_iterations": [5]}', r"sub_iterations\[0\] must be an object"),
    ('{"sub_iterations": [{}]}', "must have raster, makelut"),
    ('{"sub_iterations": [{"raster": "01", "hensel": ""}]}', 'unknown key "hensel"'),
    ('{"sub_iterations": [{"raster": "01"}]}', "got 2 characters"),
    (json.dumps({"sub_iterations": [{"raster": 511 * "0" + "2"}]}), "512 digits 0 and 1"),
    (json.dumps({"sub_iterations": [{"raster": "g" + 127 * "0"}]}), "128 hexadecimal digits"),
    (json.dumps({"sub_iterations": [{"makelut": 512 * [0]}]}), "order: .* None"),
    (json.dumps({"sub_iterations": [{"makelut": 512 * [0], "order": "raster"}]}), "order: .* 'raster'"),
    (json.dumps({"sub_iterations": [{"remove": 255 * [0], "order": "raster"}]}), r"\(255,\)"),
    (json.dumps({"sub_iterations": [{"remove": 256 * [3], "order": "raster"}]}), "remove is invalid: .* got 3"),
    (json.dumps({"sub_iterations": [{"remove": [256 * [0]] * 2, "order": "raster"}]}), "2 tables"),
    ('{"sub_iterations": [{"patterns": ["4:(...)->1"]}]}', "patterns is invalid: .* column 7"),
    ('{"sub_iterations": [{"patterns": [[]]}]}', "patterns is invalid"),
    ('{"sub_iterations": [{"patterns": 5}]}', "patterns is invalid"),
    (900_000 * "[", "nested too deep"),
    (r'{"hensel": "B/S", "name": "a\ud800"}', "name must have 1 to 100 bytes"),
    ('{"hensel": "B/S"}' + 1_000_000 * " ", "more than 1,000,000 bytes"),
])
def test_invalid_files_are_rejected_in_one_line(content, message, tmp_path):
    with pytest.raises(ValueError, match=message) as caught:
        Rule.load(written(tmp_path, content))
    assert "\n" not in str(caught.value)


def test_only_regular_files_of_text_are_read(tmp_path):
    with pytest.raises(FileNotFoundError):
        Rule.load(tmp_path / "none.json")
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path, tmp_path / "pipe"):
        with pytest.raises(ValueError, match="not a regular file"):
            Rule.load(path)
    (tmp_path / "latin").write_bytes(b'{"name": "\xe9"}')
    with pytest.raises(ValueError, match="not UTF-8 at byte 11"):
        Rule.load(tmp_path / "latin")


# Errors, threads, memory.


def test_threads_share_a_rule():
    rule = Rule(random_rule(1, "background").tables, max_iterations=20)
    images = [random_image(seed, 300) for seed in range(20)]
    expected = [reference(image, rule)[0] for image in images]
    wrong: list[int] = []

    def work() -> None:
        own = pickle.loads(pickle.dumps(rule))
        for _ in range(5):
            for image, right in zip(images, expected):
                for one in (rule, own):
                    if not np.array_equal(thinbench.apply(image, one), right):
                        wrong.append(1)

    in_eight_threads(work)
    assert not wrong


def test_other_threads_run_during_a_call():
    image = np.random.RandomState(1).rand(1000, 1000) < 0.4
    restless = Rule.from_hensel("B2/S", max_iterations=10_000)
    assert longest_wait_during(lambda: thinbench.apply(image, restless)) < 0.5  # 1 with the interpreter locked


def test_rules_are_freed():
    def resident() -> int:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")

    def make(first: int, count: int) -> None:
        for number in range(first, first + count):
            deleted = number >> (np.arange(256) % 20) & 1
            Rule.from_deletions(np.tile(deleted, (8, 1)))
        gc.collect()

    make(1, 500)
    before = resident()
    make(1000, 3000)
    assert resident() - before < 2_000_000


SCRIPT = """
import numpy as np, thinbench
from images import random_image
from record_bwmorph import digest
for seed in range(12):
    table = np.random.RandomState(seed).rand(2, 512) < 0.5
    border = ["background", "keep", "foreground"][seed % 3]
    rule = thinbench.Rule(table, border=border, max_iterations=3)
    for side in (20, 300, 1500):
        print(digest(thinbench.apply(random_image(seed, side), rule)))
"""


def test_results_do_not_depend_on_machine_code():
    def output(**variables: str) -> str:
        paths = [os.environ.get("PYTHONPATH", ""), str(Path(__file__).parent)]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths), **variables}
        return subprocess.run([sys.executable, "-c", SCRIPT], env=environment, check=True,
                              capture_output=True, text=True).stdout

    compiled = output()
    assert len(compiled.split()) == 36
    assert output(THINBENCH_MACHINE_CODE="off") == compiled
    assert output(THINBENCH_MAX_ISA="baseline") == compiled


@pytest.mark.parametrize("shape", [(20, 30), (20, 300), (3, 20, 30)])
def test_sub_iterations_that_undo_one_another_go_on(shape):
    complement = np.arange(512) & 16 == 0
    image = np.random.default_rng(1).random(shape) < 0.5
    result, iterations = thinbench.thin(image, Rule([complement, complement], max_iterations=7), return_iterations=True)
    np.testing.assert_array_equal(result, image)
    assert iterations == 7
