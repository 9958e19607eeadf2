"""`./study compare`, and a fleet of two jobs whose runs are compared."""

from __future__ import annotations

import csv
import io
import subprocess
from pathlib import Path
from typing import Any

import pytest
from conftest import make_samples
from fake_programs import MACHINE, Noise, install, make_facts

from report.compare import Comparison, compare_runs
from report.errors import ReportError
from report.measure.measurement import Part
from report.measure.run import Run, load_run, write_run

HERE = Path(__file__).parent


def made_run(directory: Path, pixels: str = "0" * 16, machine: dict[str, Any] | None = None,
             inputs: tuple[str, ...] = ("scene", "square_64"), clock: float = 1.0) -> Run:
    """A run of nine processes."""
    facts = make_facts(inputs, pixels)
    samples = make_samples(facts, Noise(spread=0.01, clock=clock))
    write_run(directory, MACHINE | (machine or {}), {}, [Part(facts, tables=[samples])])
    return load_run(directory)


@pytest.fixture(name="runs")
def _runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Run]:
    """The second is on a machine that takes twice as long, the third at another commit."""
    first = made_run(tmp_path / "a")
    monkeypatch.setenv("FAKE_SLOWDOWN", "2")
    second = made_run(tmp_path / "b", machine={
        "fingerprint": "amd-25-17-1-0a0b0c0d", "cpu": MACHINE["cpu"] | {"flags": ["sse4_2"]}})
    monkeypatch.delenv("FAKE_SLOWDOWN")
    return [first, second, made_run(tmp_path / "c", machine={"commit": "def5678"})]


def test_ratios_of_all_runs_stand_side_by_side(runs: list[Run], tmp_path: Path) -> None:
    said = compare_runs(runs, tmp_path / "out")
    assert said.startswith("12 rows of 3 runs")
    lines = list(csv.DictReader(io.StringIO((tmp_path / "out/comparison.csv").read_text())))
    assert len(lines) == 36
    for line in lines:
        slower = line["machine"].startswith("amd")
        assert float(line["times_as_fast"]) == pytest.approx(0.5 if slower else 1, rel=0.01)
        assert float(line["speedup_ratio"]) == pytest.approx(1, rel=0.01)


def test_what_differs_is_listed_and_nothing_else(runs: list[Run]) -> None:
    differences = {line[0]: line[1:] for line in Comparison(runs).differences}
    assert differences["machine.commit"] == ["abc1234", "abc1234", "def5678"]
    assert differences["machine.cpu.flags"] == ["avx2", "nothing more", "avx2"]
    assert "machine.os" not in differences


def test_the_page_stands_alone_and_escapes_what_it_shows(runs: list[Run], tmp_path: Path) -> None:
    compare_runs(runs, tmp_path)
    page = (tmp_path / "comparison.html").read_text()
    assert "Fake &lt;CPU&gt;" in page and "prefers-color-scheme: dark" in page
    assert "http" not in page and "src=" not in page
    text = (tmp_path / "comparison.md").read_text()
    assert "| thin_guo_hall / scene | 0.5 | 1 | simd_bitpacked avx2 | " in text


def test_other_pixels_are_not_compared_and_that_is_said(tmp_path: Path) -> None:
    first = made_run(tmp_path / "a", inputs=("scene",))
    other = made_run(tmp_path / "b", pixels="1" * 16)
    with pytest.raises(ReportError, match="no row in common.* B: input 'scene' has other pixels"):
        Comparison([first, other])
    with_both = Comparison([first, other, made_run(tmp_path / "c", inputs=("scene",))])
    assert with_both.remarks[0] == "B: input 'scene' has other pixels than in A, not compared"
    assert all(line.rows[1] is None and line.rows[2] for line in with_both.lines)


def test_rows_that_only_one_run_has_are_named(tmp_path: Path) -> None:
    both = [made_run(tmp_path / "a"), made_run(tmp_path / "b", machine={"commit": "def5678"}, inputs=("scene",))]
    (remark,) = Comparison(both).remarks
    assert remark.startswith("only A has 6 rows: thin_guo_hall/") and remark.endswith("and 3 more")


def test_runs_of_one_kind_of_processor_are_compared_in_clock_cycles(tmp_path: Path) -> None:
    first = made_run(tmp_path / "a", inputs=("scene",))
    slow = made_run(tmp_path / "b", machine={"commit": "def5678"}, inputs=("scene",), clock=1.2)
    other = made_run(tmp_path / "c", machine={"cpu": MACHINE["cpu"] | {"model": 1}}, inputs=("scene",), clock=1.2)
    for line in Comparison([first, slow, other]).lines:
        assert line.time_ratio(1) == pytest.approx(1, rel=0.01)
        assert line.time_ratio(2) == pytest.approx(1 / 1.2, rel=0.01)


def test_the_same_run_twice_is_rejected(tmp_path: Path) -> None:
    run = made_run(tmp_path / "a")
    with pytest.raises(ReportError, match="hold the same run; expected different runs"):
        Comparison([run, run])


def test_runs_of_parallel_jobs_merge_without_a_server(tmp_path: Path) -> None:
    install(tmp_path / "builds" / "release")
    jobs = subprocess.run(
        ["parallel", "--will-cite", "--quote", "--jobs", "2", "/usr/bin/python3", HERE / "fake_study.py",
         tmp_path / "builds", "sweeps", "--quick", "--seconds", "1", "--only", "isa", "--out", tmp_path / "fleet/{}",
         ":::", "one", "two"], check=False, text=True, capture_output=True)
    assert jobs.returncode == 0, jobs.stderr
    runs = sorted((tmp_path / "fleet").glob("*/sweeps"))
    done = subprocess.run(["/usr/bin/python3", "-m", "report", "compare", *runs,
                           "--out", tmp_path / "out"], check=False, text=True, capture_output=True,
                          cwd=HERE.parents[1])
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("6 rows of 2 runs")
