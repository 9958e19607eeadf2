"""What the coverage report counts, on made-up counts."""

from __future__ import annotations

from collections import defaultdict

import pytest

from report.errors import ReportError
from tests.coverage.run import (
    FileCoverage, check_counts, explanations, gaps, is_for_compilers, parse_branches, parse_lcov, summary)

NAME = "kernels/api/edges.cpp"


def coverage() -> dict[str, FileCoverage]:
    """Line 3 never ran; the condition of line 2 was never false; that of line 1 is a constant."""
    files: dict[str, FileCoverage] = defaultdict(FileCoverage)
    parse_lcov(f"SF:{NAME}\nDA:1,5\nDA:2,1\nDA:3,0\nend_of_record\nSF:{NAME}\nDA:2,4\n", files)
    parse_branches({"data": [{"files": [{"filename": NAME, "branches": [
        [2, 7, 2, 9, 3, 0, 0, 0, 4], [2, 7, 2, 9, 2, 0, 0, 0, 4], [1, 7, 1, 9, 0, 0, 0, 0, 4]]}]}]}, files)
    return files


def test_counts_are_added_and_what_never_ran_is_named_but_for_constants() -> None:
    found = coverage()[NAME]
    assert found.lines == {1: 5, 2: 5, 3: 0} and found.branches[2, 7] == (5, 0)
    assert (found.missed_lines(), found.missed_outcomes()) == ([3], ["2:7 never false"])
    _, lines, branches = summary(coverage())
    assert (round(lines, 2), branches) == (66.67, 50)


def test_a_gap_without_a_reason_is_wrong_and_a_reason_without_a_gap_is_shown() -> None:
    shown, wrong = gaps(coverage(), explanations("# why\nkernels/api/many.cpp: no reason\n"))
    assert shown[:2] == ["kernels/api/many.cpp: has a reason but no gap this time", f"{NAME}: NOT EXPLAINED"]
    assert wrong == [f"{NAME} has a gap that explained.txt does not explain"]
    assert gaps(coverage(), {NAME: "out of memory"})[1] == []


def test_counts_that_could_not_be_added_are_an_error() -> None:
    check_counts("LLVM Profile Note: all is well\n")
    with pytest.raises(ReportError, match="the counts of 1 test are lost; the first: /a/7_0.profraw is of another program"):
        check_counts("Passed\nLLVM Profile Error: Profile Merging of file /a/7_0.profraw failed: File exists\n")


SOURCE = """int used() {
  return 1;
}

template <class T>
constexpr T table(
    T from) {
  return from;
}

constexpr int kCount = 3;
int count() { return kCount; }
"""


def test_functions_that_the_compiler_evaluates_are_known_by_their_declaration() -> None:
    found = [line for line in (1, 7, 12) if is_for_compilers(SOURCE, line)]
    assert found == [7]
