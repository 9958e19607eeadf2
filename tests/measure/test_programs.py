"""The sampler plans, measures and finds a wrong result; the program of Google Benchmark checks itself."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import pytest

PROGRAMS = Path(os.environ["THINBENCH_PROGRAMS"])
ROW = ("--input", "square_64", "--filter", "^edges_sobel/autovec/baseline/1")


def sampler(*words: str, given: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAMS / "thinbench_sampler", *words], input=given, text=True, capture_output=True,
                          check=False)


@pytest.fixture(name="plan", scope="module")
def planned() -> str:
    done = sampler("plan", *ROW)
    assert done.returncode == 0, done.stderr
    return done.stdout


def measured(plan: str) -> list[dict[str, Any]]:
    done = sampler("measure", "--seed", "1", given=plan)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


def shortest(lines: list[dict[str, Any]]) -> float:
    return min(time for line in lines if "group" in line for time in line["entries"][0])


def test_each_layout_is_a_line_between_two_states_of_the_machine(plan: str) -> None:
    lines = measured(plan)
    assert sum("chain_ns" in json.dumps(line) for line in lines) == 2
    assert sum(line.get("group") == 0 for line in lines) == 3


def test_times_follow_the_clock_of_the_plan(plan: str) -> None:
    slow = measured(plan.replace('"cycle_ns":', '"cycle_ns":1000'))
    assert shortest(slow) > 100 * shortest(measured(plan))


def test_a_wrong_result_is_not_measured(plan: str) -> None:
    done = sampler("measure", given=re.sub(r'"hash":"[0-9a-f]{16}","name"', '"hash":"0123456789abcdef","name"', plan))
    assert done.returncode != 0 and "gave another result" in done.stderr


def test_slow_rows_are_skipped_with_the_reason() -> None:
    done = sampler("plan", *ROW, "--max-call", "1e-9")
    assert done.returncode == 0 and '"reason":"a call takes more than 1e-09 s"' in done.stdout


@pytest.mark.parametrize(("words", "message"), [
    (("--filter", "no_such_row"), "no row matches the filter 'no_such_row'"),
    (("--bogus",), "there is no option '--bogus'")])
def test_wrong_usage_is_status_2_and_a_line(words: tuple[str, ...], message: str) -> None:
    done = sampler("plan", *words)
    assert done.returncode == 2 and message in done.stderr


def test_google_benchmark_runs_the_rows_that_are_asked_for() -> None:
    done = subprocess.run([PROGRAMS / "thinbench_benchmarks", *ROW[:2], "--filter", "^edges_sobel/",
                           "--benchmark_filter=autovec", "--benchmark_min_time=0.001", "--benchmark_format=json"],
                          text=True, capture_output=True, check=True)
    names = [row["name"] for row in json.loads(done.stdout)["benchmarks"]]
    assert names and all("/autovec/" in name and name.startswith("edges_sobel/") for name in names)
