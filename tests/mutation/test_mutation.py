"""The operators make the mutants expected, and mutants of a small program are judged right."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

# pylint: disable=wrong-import-position
from choice import (Candidate, Equivalent, append_result, candidates, read_equivalents,  # noqa: E402
                    read_results, result_of, stale)
from families import FAMILIES, Check, Family  # noqa: E402
from operators import mutations  # noqa: E402
from run import EQUIVALENTS, ROOT, main  # noqa: E402
from tree import EDITS, Overlay, Tree  # noqa: E402
from trial import Trial, Usual, Verdict  # noqa: E402


def changes(line: str) -> set[tuple[str, str]]:
    """(operator, mutated line) of a text of one line."""
    return {(one.operator, one.apply(line)) for one in mutations(line)}


@pytest.mark.parametrize(("line", "operator", "mutant"), [
    ("x = a & ~b;", "gate", "x = a | ~b;"),
    ("x = a & ~b;", "gate", "x = a & b;"),
    ("x = a & ~b;", "statement", ";"),
    ("return n.n1 ^ p;", "neighbour", "return n.n3 ^ p;"),
    ("return n.n7 ^ p;", "neighbour", "return n.n1 ^ p;"),
    ("return Traits::west(word);", "neighbour", "return Traits::east(word);"),
    ("for (Index y = 0; y < height - 1; ++y) {", "comparison", "for (Index y = 0; y <= height - 1; ++y) {"),
    ("for (Index y = 0; y < height - 1; ++y) {", "offset", "for (Index y = 0; y < height; ++y) {"),
    ("for (Index y = 0; y < height - 1; ++y) {", "number", "for (Index y = 1; y < height - 1; ++y) {"),
    ("return word << 3;", "shift", "return word >> 3;"),
    ("if (changed(x)) return true;", "flag", "if (!(changed(x))) return true;"),
    ("if (changed(x)) return true;", "flag", "if (changed(x)) return false;"),
    ("return a || b;", "flag", "return a && b;"),
    ("return mask & 0x80;", "constant", "return mask & 0x81;"),
    ("return next<sub>(n);", "sub-iteration", "return next<(sub == 0 ? 1 : 0)>(n);"),
    ("changed |= any(next);", "statement", ";"),
])
def test_an_operator_changes_one_place(line: str, operator: str, mutant: str) -> None:
    assert (operator, mutant) in changes(line)


@pytest.mark.parametrize("line", [
    "// n.n1 & 1", "Thinner::~Thinner() = default;", "virtual ~State() = default;", "#if 1 < 2",
    'throw Error("1 < 2");', "template <int sub>", "static_assert(1 < 2);",
    "/* 1 < 2 */", "const auto text = \"a & b\";", "__builtin_prefetch(from + 64);"])
def test_what_decides_no_pixel_is_left_alone(line: str) -> None:
    assert not mutations(line)


def test_the_rest_of_a_text_remains() -> None:
    text = "int f(int a) {\n  return a + 1;  // b + 1\n}\n"
    assert {one.apply(text) for one in mutations(text)} == {text.replace("a + 1", "a"), text.replace("a + 1", "a + 2"),
                                                            text.replace("a + 1", "a - 1")}


def test_the_choice_depends_on_the_seed_alone_and_rotates_operators() -> None:
    family = next(one for one in FAMILIES if one.name == "rules")
    kernels = ROOT / "kernels"
    order = candidates(family, kernels, 1)
    assert order == candidates(family, kernels, 1) != candidates(family, kernels, 2)
    operators = {one.mutation.operator for one in order}
    assert {one.mutation.operator for one in order[:len(operators)]} == operators


def test_every_family_has_sources_and_every_edit_of_the_copy_finds_its_text() -> None:
    assert all(family.files(ROOT / "kernels") for family in FAMILIES)
    for name, before, _ in EDITS:
        assert before in (ROOT / name).read_text(encoding="utf-8")


def test_an_equivalent_mutant_is_stale_if_its_line_is_gone_or_no_operator_makes_it(tmp_path: Path) -> None:
    (tmp_path / "toy.cpp").write_text("  return a + 1;\n", encoding="utf-8")
    fresh = Equivalent("toy.cpp", "return a + 1;", "return a + 2;", "a reason")
    gone, unmade = replace(fresh, before="return b + 1;"), replace(fresh, after="return b;")
    assert list(stale([fresh, gone, unmade], tmp_path)) == [gone, unmade]


def test_every_entry_of_the_list_has_a_reason_and_occurs_once() -> None:
    entries = read_equivalents(EQUIVALENTS)
    assert all(one.reason.endswith(".") for one in entries)
    assert len({(one.file, one.before, one.after) for one in entries}) == len(entries)


TOY = """int toy(int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i) sum += i;
  return sum + 0;
}
"""
OBJECT = "kernels/CMakeFiles/thinbench_common.dir/toy.cpp.o"
TOY_TEST = """int toy(int);
int main() { return toy(3) == 3 && toy(0) == 0 ? 0 : 1; }
"""


@pytest.fixture(name="toy")
def toy_trial(tmp_path: Path) -> Trial:
    """A trial of a file with a function and of a program that tests it."""
    tree = Tree(tmp_path)
    tree.kernels.mkdir(parents=True)
    for name in ("bin", "kernels/CMakeFiles/thinbench_common.dir"):
        (tree.build / name).mkdir(parents=True)
    (tree.kernels / "toy.cpp").write_text(TOY, encoding="utf-8")
    (tree.build / "test.cpp").write_text(TOY_TEST, encoding="utf-8")
    tree.objects = {"kernels/toy.cpp": [OBJECT]}
    tree.commands = {OBJECT: ["g++", "-O1", "-c", str(tree.kernels / "toy.cpp"), "-o", OBJECT]}
    tree.links = {"toy_test": ["g++", "test.o", OBJECT, "-o", "bin/toy_test"]}
    tree.inputs = {"toy_test": {"test.o", OBJECT}}
    for command in (["g++", "-c", "test.cpp"], tree.commands[OBJECT], tree.links["toy_test"]):
        subprocess.run(command, cwd=tree.build, check=True)
    return Trial(Overlay(tree, tmp_path / "mutant"), Usual(tree, tmp_path / "seconds.json"))


FAMILY = Family("toy", ("toy.cpp",), (Check("toy_test"),), ())


def verdict(trial: Trial, before: str, after: str) -> Verdict:
    """Of the mutant that has `after` in place of `before`."""
    mutated = TOY.replace(before, after)
    mutation = next(one for one in mutations(TOY) if one.apply(TOY) == mutated)
    return trial.judge(FAMILY, "toy.cpp", mutation)


def test_a_mutant_is_judged_by_its_code_and_its_tests(toy: Trial) -> None:
    assert verdict(toy, "i < n", "i <= n") == Verdict("killed", "toy_test (status 1)")
    assert verdict(toy, "sum = 0", "sum = 1").state == "killed"
    assert verdict(toy, "return sum + 0", "return sum - 0") == Verdict("same code")
    assert verdict(toy, "i = 0", "i = 1") == Verdict("survived")  # adds 0 no more


def test_a_mutant_that_never_ends_is_killed(toy: Trial) -> None:
    text = "int toy(int n) {\n  int sum = 0;\n  while (sum < n) sum = sum + 1;\n  return sum;\n}\n"
    (toy.tree.kernels / "toy.cpp").write_text(text, encoding="utf-8")
    endless = next(one for one in mutations(text) if one.before == " + 1")
    assert toy.judge(FAMILY, "toy.cpp", endless) == Verdict("killed", "toy_test (time limit)")


def test_what_the_compiler_rejects_does_not_count(toy: Trial) -> None:
    toy.tree.commands[OBJECT].append("-no-such-option")
    assert verdict(toy, "i < n", "i <= n") == Verdict("not compiled")


def test_results_are_read_again_without_a_line_cut_short(tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    candidate: Candidate = candidates(FAMILIES[0], ROOT / "kernels", 1)[0]
    result = result_of(candidate, "killed", "a test", 1.25)
    append_result(path, result)
    with path.open("a", encoding="utf-8") as out:
        out.write('{"key": "cut')
    assert read_results(path) == {candidate.key: result}
    append_result(path, result_of(candidate, "survived", "", 2))
    assert read_results(path)[candidate.key].state == "survived"


def test_wrong_options_are_refused() -> None:
    with pytest.raises(SystemExit) as error:
        main(["--number", "-1"])
    assert error.value.code == 2
