"""What is known of two builds without a clock: counts of instructions and machine code."""

from __future__ import annotations

import copy
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from report.errors import ReportError
from report.measure.benchmarks import Json
from report.regress import counts
from report.regress.machine_code import same_isas
from report.regress.verdicts import Verdict

PASS, FAIL, INCONCLUSIVE, SKIPPED = Verdict
ISAS = ("baseline", "sse4.2", "avx2")


def counted(**changes: object) -> Json:
    """A document of one row."""
    row = {"row": "a", "instructions": 1000, "method": "callgrind", "iterations": 3} | changes
    return {"build": {"compiler": "GNU 12", "libc": "2.36"}, "input": {"hash": "1"},
            "valgrind": "3.19", "max_steps": 5000, "rows": [row], "skipped": []}


def verdict_of(before: Json, now: Json) -> tuple[Verdict, str]:
    """On the only row."""
    row, = counts.compare(before, now).layer.rows
    return row.verdict, row.reason


@pytest.mark.parametrize("instructions, verdict, reason", [
    (1000, PASS, ""), (1010, PASS, ""),
    (1020, FAIL, "1,000 instructions before, 1,020 now (+2.0 %)"),
    (900, PASS, "1,000 instructions before, 900 now (-10.0 %)")])
def test_one_percent_more_is_tolerated(instructions: int, verdict: Verdict, reason: str) -> None:
    assert verdict_of(counted(), counted(instructions=instructions)) == (verdict, reason)


def test_another_number_of_iterations_fails() -> None:
    assert verdict_of(counted(), counted(iterations=4)) == (FAIL, "3 iterations before, 4 now")


def test_a_row_that_became_too_long_to_count_fails() -> None:
    before, now = counted(method="single_steps"), counted()
    now["rows"], now["skipped"] = [], [{"row": "a", "reason": "more steps than are counted"}]
    assert verdict_of(before, now) == (FAIL, "1,000 instructions before, now too many to count")
    assert counts.compare(counted(), now).layer.verdict == SKIPPED


def test_a_row_that_is_gone_is_listed_except_where_a_part_was_counted() -> None:
    now = counted()
    now["rows"] = [now["rows"][0] | {"row": "b"}]
    assert [row.name for row in counts.compare(counted(), now).layer.rows] == []
    both = counted()
    both["rows"] += now["rows"]
    assert [(row.name, row.verdict) for row in counts.compare(both, now).layer.rows] == [("b", PASS), ("a", SKIPPED)]
    assert [row.name for row in counts.compare(both, now, is_part=True).layer.rows] == ["b"]


@pytest.mark.parametrize("part, value, reason", [
    ("build", {"compiler": "Clang 14", "libc": "2.36"}, "of another compiler"),
    ("input", {"hash": "2"}, "of another input"),
    ("rows", [], "no row was counted in the same way before"),
    ("valgrind", "3.20", "no row was counted in the same way before")])
def test_counts_of_something_else_are_not_compared(part: str, value: object, reason: str) -> None:
    layer = counts.compare(counted() | {part: value}, counted()).layer
    assert layer.verdict == SKIPPED and layer.summary.endswith(reason)


def test_single_steps_do_not_depend_on_valgrind() -> None:
    steps = counted(method="single_steps")
    assert verdict_of(steps | {"valgrind": "3.20"}, copy.deepcopy(steps)) == (PASS, "")


def test_a_build_that_cannot_count_says_why(tmp_path: Path) -> None:
    program = tmp_path / "thinbench-study"
    program.write_text("#!/bin/sh\necho 'no row matches' >&2\nexit 2\n")
    program.chmod(0o755)
    with pytest.raises(ReportError, match="instructions cannot be counted: no row matches") as error:
        counts.count(program, [])
    assert error.value.status == 2


@pytest.fixture(name="make_build")
def _make_build(tmp_path: Path) -> Callable[..., Path]:
    """Builds a program of two objects, one of them for AVX2, and returns where the programs are."""

    def make(name: str, common: str = "int f() { return 1; }",
             avx2: str = "int g() { return 2; }", flags: str = "") -> Path:
        build = tmp_path / name
        build.mkdir()
        (build / "common.cpp").write_text(common)
        (build / "avx2.cpp").write_text(avx2)
        (build / "build.ninja").write_text(
            f"rule cc\n  command = c++ -O1 {flags} -c $in -o $out\n"
            "rule ld\n  command = touch $out\n"
            "build common.dir/x.o: cc common.cpp\n"
            "build kernels/thinbench_avx2.dir/x.o: cc avx2.cpp\n"
            "build bin/thinbench_benchmarks: ld common.dir/x.o kernels/thinbench_avx2.dir/x.o\n")
        subprocess.run(["ninja", "-C", str(build)], check=True, capture_output=True)
        return build / "bin"

    return make


def test_rows_below_a_changed_isa_run_the_same_machine_code(
        make_build: Callable[..., Path]) -> None:
    base = make_build("base")
    assert same_isas(base, make_build("same", flags="-g"), ISAS) == set(ISAS)
    assert same_isas(base, make_build("avx2", avx2="int g() { return 3; }"),
                     ISAS) == {"baseline", "sse4.2"}
    assert same_isas(base, make_build("all", common="int f() { return 3; }"), ISAS) == set()


def test_programs_without_their_build_are_not_called_the_same(
        make_build: Callable[..., Path], tmp_path: Path) -> None:
    (tmp_path / "alone").mkdir()
    assert same_isas(tmp_path / "alone", make_build("base"), ISAS) == set()
