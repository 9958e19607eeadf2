"""Parameter sweeps: plans, resuming, curves."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from conftest import make_row, study, without_progress
from fake_programs import install

from report.measure.estimates import NEEDED_PROCESSES
from report.measure.measurement import UNFINISHED
from report.measure.run import load_run
from report.measure.timings import Row
from report.sweeps.plans import SWEEPS, plan_words, thread_steps
from report.sweeps.series import load_sweep_rows, sweep_series, sweeps_markdown, worst_places

SWEPT = ["--quick", "--only", "depth", "--only", "size"]


@pytest.fixture(name="programs", scope="module")
def _programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    builds = tmp_path_factory.mktemp("builds")
    install(builds / "release")
    return builds


@pytest.fixture(name="run", scope="module")
def _run(programs: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("run")
    done = study(programs, "sweeps", *SWEPT, "--seconds", "1", "--out", directory)
    assert (done.returncode, without_progress(done.stderr)) == (0, ""), done.stderr
    return directory


def test_a_sweep_is_a_run_of_its_own_beside_the_study(run: Path) -> None:
    found = load_run(run / "sweeps")
    assert {row.sweep for row in found.rows} == {"depth", "size"}
    assert found.facts["run"].endswith(f"/{run.name}/sweeps")
    assert not (run / "sweeps" / UNFINISHED).exists()
    assert load_sweep_rows(run) == found.rows and load_sweep_rows(run / "absent") == []


def test_points_of_a_curve_stand_at_the_values_that_are_swept(run: Path) -> None:
    curves = {(one.sweep, one.label): [point.x for point in one.points]
              for one in sweep_series(load_sweep_rows(run))}
    assert curves["depth", "bitpacked/baseline"] == [4, 8, 16, 32, 64]
    assert list(dict.fromkeys(sweep for sweep, _ in curves)) == ["size", "depth"]


def test_curves_are_told_apart_by_what_else_varies(run: Path) -> None:
    row = next(row for row in load_sweep_rows(run) if row.technique == "bitpacked")

    def labels(*changed: Row) -> list[str]:
        return [one.label for one in sweep_series(changed)]

    noise = [replace(row, sweep="density", input=f"noise_512_{percent}_{block}")
             for percent in (10, 50) for block in (1, 4)]
    assert labels(*noise) == ["bitpacked/baseline, blocks of 1", "bitpacked/baseline, blocks of 4"]
    isas = [replace(row, sweep="isa", isa=isa) for isa in ("baseline", "avx2")]
    assert [[point.x for point in one.points] for one in sweep_series(isas)] == [
        ["baseline", "avx2"]]
    reference = replace(row, sweep="isa", technique="reference")
    assert not labels(reference) and not labels(replace(row, sweep=""))


def test_markdown_has_a_table_for_each_case(run: Path) -> None:
    text = (run / "sweeps" / "sweeps.md").read_text()
    found = load_run(run / "sweeps")
    assert text == sweeps_markdown(found)
    found.facts["controls"] |= {"failed": 1, "groups": 4}
    assert "The controls of 1 of 4 cases failed" in sweeps_markdown(found)
    assert "**thin_guo_hall** by side of the square, pixels" in text
    assert "| 511 | " in text


def test_the_worst_noise_of_a_case_stands_beside_the_scene() -> None:
    row = make_row("holes", "simd_runs", "avx512", 1e4)
    noise = [replace(row, sweep="density", input=f"noise_512_{percent}_1", ns_per_pixel=percent / 10) for percent in (10, 50)]
    scene = [replace(row, ns_per_pixel=0.5)]
    assert "| `holes` | noise_512_50_1 | 5 | 10 |" in worst_places([*noise, replace(noise[1], threads=2)], scene)
    assert "| `holes` | noise_512_50_1 | 5 |  |" in worst_places(noise, [])


def test_an_interrupted_measurement_ends_with_what_there_is_and_goes_on(programs: Path, tmp_path: Path) -> None:
    words = [*SWEPT, "--seconds", "3", "--out", tmp_path]
    # Interrupted by its own program in the fourth process, as Ctrl-C would do.
    stopping = tmp_path / "stopping"
    program = install(stopping / "release") / "thinbench_benchmarks"
    program.write_text(program.read_text().replace(
        "exec", f'case "$*" in *--known*) [ "$(ls "{tmp_path}/sweeps/{UNFINISHED}" | wc -l)" -lt 4 ] || '
                "{ kill -INT $PPID; sleep 9; };; esac\nexec", 1))
    done = study(stopping, "sweeps", *words)
    assert done.returncode == 130 and "The same command with --resume goes on" in done.stdout, done.stderr
    assert sum(row.processes for row in load_run(tmp_path / "sweeps").rows) > 0
    assert "interrupted measurement" in study(programs, "sweeps", *words).stderr
    done = study(programs, "sweeps", *words, "--resume")
    assert done.returncode == 0, done.stderr
    assert not (tmp_path / "sweeps" / UNFINISHED).exists()
    assert min(row.processes for row in load_run(tmp_path / "sweeps").rows) >= NEEDED_PROCESSES


def test_full_sweeps_have_at_least_as_many_inputs_as_quick_ones_of_the_same_rows() -> None:
    for sweep in SWEEPS:
        quick, full = (plan_words(sweep, is_quick, 2) for is_quick in (True, False))
        assert quick.count("--input") <= full.count("--input")
        assert full[full.index("--filter") + 1] == quick[quick.index("--filter") + 1]


def test_threads_go_up_to_all_cores() -> None:
    assert thread_steps(1) == thread_steps(2) == [2]
    assert thread_steps(4) == [2, 3, 4]
    assert thread_steps(32) == [2, 3, 4, 5, 6, 7, 8, 12, 18, 27, 32]
