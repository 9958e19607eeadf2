"""Rules: tables, notations, files, threads, memory."""

from __future__ import annotations

import copy
import gc
import json
import os
import pickle
from pathlib import Path

import numpy as np
import pytest

import thinbench
from images import random_image
from thinbench import Rule
from waiting import in_eight_threads

PIXELS = (np.arange(512) >> np.arange(9)[:, None]) & 1 == 1
"""Of all windows, in raster order."""
CENTRE = PIXELS[4]


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


def test_tables_may_have_any_strides():
    tables = np.random.RandomState(1).rand(4, 512) < 0.5
    for view in (np.asfortranarray(tables), tables[::-2, ::-1], np.asfortranarray(tables)[:1]):
        np.testing.assert_array_equal(Rule(view, max_iterations=1).tables, view)


@pytest.mark.parametrize(("rule", "table"), [
    (Rule.from_hensel("B/S012345678"), CENTRE), (Rule.from_patterns(["1:(..1 .0. ...)->1"]), CENTRE | PIXELS[2]),
    *((Rule.from_removals(np.arange(256) >> 3 & 1, order), CENTRE & ~PIXELS[pixel])
      for order, pixel in (("descriptor", 0), ("raster", 3), ("clockwise", 5)))])
def test_notations_and_orders_make_their_tables(rule, table):
    np.testing.assert_array_equal(rule.tables, table[None])


def test_makelut_and_function_agree():
    weights = np.random.RandomState(2).rand(3, 3) - 0.5

    def heavy(window: np.ndarray) -> bool:
        return bool((weights * window).sum() > 0)

    def by_columns(order: int) -> list[bool]:
        bits = [[index >> i & 1 for i in range(9)][::order] for index in range(512)]
        return [heavy(np.reshape(window, (3, 3), order="F")) for window in bits]

    expected = Rule.from_function(heavy, max_iterations=1)
    assert Rule.from_values(by_columns(1), max_iterations=1) == expected
    assert Rule.from_values(by_columns(-1), "octave", max_iterations=1) == expected
    both = Rule.from_values([by_columns(1)] * 2, max_iterations=1)
    np.testing.assert_array_equal(both.tables, np.repeat(expected.tables, 2, axis=0))


def test_rules_are_listed_and_found():
    built_in, named = thinbench.rules(), thinbench.named_rules()
    assert next(iter(built_in)) == "naccache_shinghal" and list(named) == sorted(named) and len(named) >= 16
    assert len(built_in | named) == len(built_in) + len(named)
    for name, rule in (built_in | named).items():
        assert rule == Rule.named(name) and rule.name == name and rule.description
        assert rule.is_built_in == (name in built_in)
    assert all(rule == Rule.named(f"thin_{name}") for name, rule in built_in.items())
    assert all(rule.source for rule in named.values())
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


class Named(Rule):
    """With an attribute and with other parameters than a rule's."""

    def __init__(self, label: str) -> None:
        super().__init__(CENTRE, max_iterations=3)
        self.label = label


class Plain(Rule):
    """Without anything of its own."""


@pytest.mark.parametrize("rule", [
    Named("a"), Plain(CENTRE, border="keep"), Plain.named("majority"), Plain.from_hensel("B3/S23", max_iterations=1),
    Plain.from_two_layer_net(np.ones((9, 9))), Plain.from_cluster([255], np.ones((1, 9)))], ids=repr)
def test_copies_of_a_subclass_are_of_it(rule):
    for same in (pickle.loads(pickle.dumps(rule)), copy.copy(rule), copy.deepcopy(rule)):
        assert type(same) is type(rule) and same == rule and same.name == rule.name
        assert getattr(same, "label", None) == getattr(rule, "label", None)


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
         Rule.from_values(values, "octave", max_iterations=7)),
        ({"remove": [value == 1 for value in values[:256]], "order": "raster"},
         Rule.from_removals(values[:256], "raster", max_iterations=7)),
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
    ('{"hensel": "B/S", "max_iterations": 0}', "rule.json: max_iterations: expected at least 1, got 0"),
    ('{"hensel": "B/S", "max_iterations": true}', "expected an integer"),
    ('{"hensel": "B/S", "max_iterations": null}', "rule.json: max_iterations: expected an integer, got None"),
    ('{"hensel": "B/S", "max_iterations": NaN}', "expected an integer, got nan"),
    ('{"hensel": 5}', "hensel is invalid: .* got 5"),
    ('{"hensel": "B9/S"}', "hensel is invalid: .* got '9'"),
    ('{"sub_iterations": []}', "list of 1 to 8 tables"),
    ('{"sub_iterations": [5]}', r"sub_iterations\[0\] must be an object"),
    ('{"sub_iterations": [{}]}', "must have raster, makelut"),
    ('{"sub_iterations": [{"raster": "01", "hensel": ""}]}', 'unknown key "hensel"'),
    ('{"sub_iterations": [{"raster": "01"}]}', "got 2 characters"),
    ('{"sub_iterations": [{"raster": "0"}]}', "got 1 character$"),
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
    with pytest.raises(IsADirectoryError):
        Rule.load(tmp_path)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(ValueError, match="not a regular file"):
        Rule.load(tmp_path / "pipe")
    (tmp_path / "latin").write_bytes(b'{"name": "\xe9"}')
    with pytest.raises(ValueError, match="not UTF-8 at byte 11"):
        Rule.load(tmp_path / "latin")


def test_threads_share_a_rule():
    rule = Rule(CENTRE ^ (np.random.RandomState(1).rand(2, 512) < 0.3), max_iterations=20)
    images = [random_image(seed, 300) for seed in range(20)]
    expected = [thinbench.apply(image, rule) for image in images]
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


def test_rules_are_freed():
    def resident() -> int:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")

    def make(first: int, count: int) -> None:
        for number in range(first, first + count):
            removed = number >> (np.arange(256) % 20) & 1
            Rule.from_removals(np.tile(removed, (8, 1)))
        gc.collect()

    make(1, 500)
    before = resident()
    make(1000, 3000)
    assert resident() - before < 2_000_000


@pytest.mark.parametrize("shape", [(20, 30), (20, 300), (3, 20, 30)])
def test_sub_iterations_that_undo_one_another_go_on(shape):
    image = np.random.default_rng(1).random(shape) < 0.5
    result, iterations = thinbench.thin(image, Rule([~CENTRE, ~CENTRE], max_iterations=7), return_iterations=True)
    np.testing.assert_array_equal(result, image)
    assert iterations == 7
