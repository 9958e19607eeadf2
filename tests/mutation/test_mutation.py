"""The operators make the mutants expected, and mutants of a small program are judged right."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from choice import Candidate, Equivalents, Result, candidates, read_equivalents, stale, to_try
from families import FAMILIES, Family
from operators import Mutation, mutations
from run import EQUIVALENTS, KERNELS, report
from trial import Build, Trial

RULES = candidates(FAMILIES[0], KERNELS, 1)


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


def listed(one: Candidate) -> Equivalents:
    """A list with this mutant alone."""
    return {(one.file, one.mutation.before, one.mutation.after): "A reason."}


def test_survivors_that_nothing_explains_are_tried_again_and_others_are_not() -> None:
    results = {one.key: Result("survived") for one in RULES[:3]} | {RULES[3].key: Result("killed")}
    assert list(to_try([RULES], 4, results, listed(RULES[1]))) == [RULES[0], RULES[2]]


def test_every_family_has_sources_and_every_directory_a_family() -> None:
    directories = {path.name for path in KERNELS.iterdir() if path.is_dir()} - {"include"}
    files = [file for family in FAMILIES for file in family.files(KERNELS)]
    assert all(family.files(KERNELS) for family in FAMILIES)
    assert {file.split("/")[0] for file in files} == directories
    assert all((KERNELS / file).is_file() for file in files)


def test_an_equivalent_mutant_is_stale_if_its_line_is_gone_or_no_operator_makes_it(tmp_path: Path) -> None:
    (tmp_path / "toy.cpp").write_text("  return a + 1;\n", encoding="utf-8")
    fresh = ("toy.cpp", "return a + 1;", "return a + 2;")
    wrong = [("toy.cpp", "return b + 1;", "return b + 2;"), ("toy.cpp", "return a + 1;", "return b;"),
             ("gone.cpp", "return a + 1;", "return a + 2;")]
    assert stale(dict.fromkeys([fresh, *wrong], "A reason."), tmp_path) == wrong


def test_every_entry_of_the_list_has_a_reason_and_occurs_once() -> None:
    entries = read_equivalents(EQUIVALENTS)
    assert all(reason.endswith(".") for reason in entries.values())
    assert len(entries) == len(json.loads(EQUIVALENTS.read_text(encoding="utf-8")))


TOY = """int toy(int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i) sum += i;
  return sum + 0;
}
int endless(int n) {
  int sum = 0;
  while (sum < n) sum = sum + 1;
  return sum;
}
"""
TOY_TEST = """int toy(int);
int endless(int);
int main() { return toy(3) == 3 && toy(0) == 0 && endless(3) == 3 ? 0 : 1; }
"""
TOY_BUILD = """cmake_minimum_required(VERSION 3.25)
project(toy CXX)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
add_executable(toy_test kernels/toy.cpp test.cpp)
"""
FAMILY = Family("toy", ("toy.cpp",), ("toy_test",), ())


@pytest.fixture(name="trial", scope="module")
def toy_trial(tmp_path_factory: pytest.TempPathFactory) -> Trial:
    """Of a file with two functions and of a program that tests it."""
    sources = tmp_path_factory.mktemp("toy")
    (sources / "kernels").mkdir()
    for name, text in (("kernels/toy.cpp", TOY), ("test.cpp", TOY_TEST),
                       ("CMakeLists.txt", TOY_BUILD)):
        (sources / name).write_text(text, encoding="utf-8")
    build = Build(sources, sources / "build", "baseline", ["toy_test"])
    return Trial(sources / "kernels", build, build)


@pytest.mark.parametrize(("before", "after", "state", "test"), [
    ("i < n", "i <= n", "killed", "toy_test (status 1)"),
    ("sum = 0", "sum = 1", "killed", "toy_test (status 1)"),
    ("return sum + 0", "return sum - 0", "same code", ""),
    ("i = 0", "i = 1", "survived", ""),  # adds 0 no more
    ("(int n) {", "(int n) }", "not compiled", ""),
    ("sum = sum + 1", "sum = sum", "killed", "toy_test ("),  # never ends: by the limit of the processor or, on a busy machine, of the wall
])
def test_a_mutant_is_judged_by_its_code_and_its_tests(
        trial: Trial, before: str, after: str, state: str, test: str) -> None:
    line = next(line for line in TOY.splitlines() if before in line)
    change = Mutation("any", TOY.splitlines().index(line) + 1, line, line.replace(before, after))
    result = trial.result(Candidate(FAMILY, "toy.cpp", change, "a key"))
    assert result.state == state and (result.test.startswith(test) if test else result.test == "")
    assert (trial.kernels / "toy.cpp").read_text(encoding="utf-8") == TOY


def test_survivors_that_nothing_explains_lower_the_share(capsys: pytest.CaptureFixture[str]) -> None:
    explained, other, killed = RULES[:3]
    tried = [(explained, Result("survived")), (other, Result("survived")),
             *[(killed, Result("killed", "a test"))] * 49]
    assert report(tried, listed(explained)) == 0
    assert "killed: 49 of 50, 98.0 %" in capsys.readouterr().out
    assert report(tried[:-1], listed(explained)) == 1
    assert f"survived: {other}" in capsys.readouterr().out
