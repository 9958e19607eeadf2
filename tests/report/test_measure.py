"""Estimates, timings.csv, controls and the sampler's processes."""

from __future__ import annotations

import lzma
import random
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import make_samples
from fake_programs import MACHINE, TIMES, install, make_plan

from report.errors import ReportError
from report.measure.converge import measure_until_converged, open_entries
from report.measure.estimates import NEEDED, TOLERANCE, floor_of
from report.measure.run import controls_of, load_run, load_samples, write_run
from report.measure.sampler import Sampler, Samples, every_entry
from report.measure.timings import Origin, Row, read_csv, rows_of, to_csv
from report.schemas import check_schema

ROOT = Path(__file__).resolve().parents[2]
STATES = [{"chain_ns": 0.3}] * 2


def samples_of(**options: Any) -> Samples:
    """Two inputs."""
    return make_samples(make_plan(("scene", "square_64")), **options)


def rows(samples: Samples) -> list[Row]:
    """As they are published."""
    return rows_of(samples, Origin("run", "machine", "commit"))


@pytest.mark.parametrize("spread", [0.001, 0.05, 0.5])
def test_quotients_of_published_times_are_the_published_speedups(tmp_path: Path,
                                                                 spread: float) -> None:
    path = tmp_path / "timings.csv"
    path.write_text(to_csv(rows(samples_of(spread=spread))))
    published = read_csv(path)
    references = {row.input: row for row in published if row.is_reference}
    peers = {(row.technique, row.input): row for row in published if row.peer}
    assert len(published) == 2 * len(TIMES)
    for row in published:
        quotient = references[row.input].time_ns / row.time_ns
        assert row.speedup_vs_reference == pytest.approx(quotient, rel=0.005)
        assert row.speedup_low <= row.speedup_vs_reference <= row.speedup_high
        assert row.time_ns <= row.high_ns and row.time_ns <= row.typical_ns
        assert row.ns_per_pixel == pytest.approx(row.time_ns / row.width / row.height, rel=1e-4)
        if row.peer_name:
            peer = peers[row.peer_name, row.input]
            assert row.speedup_vs_peer == pytest.approx(peer.time_ns / row.time_ns, rel=0.005)


def test_a_machine_that_is_slower_for_all_rows_leaves_speedups_alone(
        monkeypatch: pytest.MonkeyPatch) -> None:
    before = rows(samples_of())
    monkeypatch.setenv("FAKE_SLOWDOWN", "1.7")
    for old, new in zip(before, rows(samples_of())):
        assert new.speedup_vs_reference == pytest.approx(old.speedup_vs_reference)
        assert new.time_ns == pytest.approx(1.7 * old.time_ns, rel=1e-3)


def test_results_that_did_not_settle_and_groups_whose_controls_fail_are_flagged() -> None:
    def flags(samples: Samples) -> set[str]:
        return {row.flags for row in rows(samples)}

    assert flags(samples_of()) == {""}
    assert flags(samples_of(processes=2)) == {"open"}
    assert "open" in flags(samples_of(spread=3))
    assert flags(samples_of(same=1.05)) == {"control"}


def test_rows_are_compared_with_peers_of_equal_output_only() -> None:
    for row in rows(samples_of()):
        assert row.peer_name == ("" if row.peer else "leptonica_4")


def test_rows_survive_the_csv_file(tmp_path: Path) -> None:
    path = tmp_path / "timings.csv"
    path.write_text(to_csv(rows(samples_of())))
    again = read_csv(path)
    assert to_csv(again) == path.read_text()
    assert again[0].max_iterations is None and again[0].verified is True
    path.write_text(path.read_text().replace("time_ns", "mean_ns"))
    with pytest.raises(ReportError, match="line 2: column 'time_ns' is missing"):
        read_csv(path)


@pytest.mark.parametrize("time", ["0", "-1", "nan", "inf"])
def test_a_table_with_impossible_times_or_a_truncated_line_is_rejected(tmp_path: Path, time: str) -> None:
    path = tmp_path / "timings.csv"
    published = replace(rows(samples_of())[0], time_ns=float(time))
    path.write_text(to_csv([published]))
    with pytest.raises(ReportError, match="line 2: expected times above 0, got time_ns"):
        read_csv(path)
    path.write_text(to_csv(rows(samples_of())[:1]).rstrip().rpartition(",")[0] + "\n")
    with pytest.raises(ReportError, match="line 2: column 'sweep' is missing"):
        read_csv(path)


def test_controls_decide_whether_a_run_concludes() -> None:
    assert controls_of([samples_of()])["passed"]
    assert not controls_of([samples_of(same=1.05)])["passed"]
    assert not controls_of([samples_of(slowed=1.02)])["passed"]
    assert not controls_of([])["passed"]


def test_a_directory_holds_all_of_a_run(tmp_path: Path) -> None:
    samples = samples_of()
    written = write_run(tmp_path / "run", MACHINE, {}, [("", samples)])
    run = load_run(tmp_path / "run")
    assert run.facts == written.facts and run.is_conclusive
    assert run.facts["run"] == "intel-6-143-8-1a2b3c4d/run"
    assert to_csv(run.rows) == to_csv(written.rows)
    assert load_samples(tmp_path / "run") == [samples]
    check_schema("plan", samples.plan, "plan")
    check_schema("process", vars(samples.processes[0]), "process")


def test_a_directory_without_a_run_is_rejected_in_one_line(tmp_path: Path) -> None:
    with pytest.raises(ReportError, match="run.json: cannot be read"):
        load_run(tmp_path)
    (tmp_path / "run.json").write_text('{"schema": 1}')
    with pytest.raises(ReportError, match="run.json: "):
        load_run(tmp_path)
    (tmp_path / "samples.jsonl.xz").write_bytes(lzma.compress(b'{"seed": 1}\n'))
    with pytest.raises(ReportError, match="samples.jsonl.xz: holds no samples"):
        load_samples(tmp_path)


def test_processes_are_fresh_and_their_groups_in_the_order_of_the_plan(tmp_path: Path) -> None:
    sampler = Sampler(install(tmp_path) / "thinbench_sampler")
    samples = Samples(sampler.plan(["--input", "scene", "--input", "square_64"]))
    seen: list[int] = []
    samples.processes = [sampler.measure(samples.plan, seed, None, lambda: seen.append(1)) for seed in (0, 1)]
    assert len(seen) == 2 * sum(group["layouts"] for group in samples.plan["groups"])
    assert len(samples.processes[0].groups) == 2
    assert samples.processes[0].states == STATES
    assert samples.processes[0].groups != samples.processes[1].groups


def noisy_time(dice: random.Random, state: dict[str, float]) -> float:
    """An epoch of a call of 100 ns on a machine with bursts, steps and drifts."""
    if dice.random() < 0.02:
        state["burst"] = dice.choice((1.0, 1.0, 1.1, 1.9))
    state["drift"] = min(max(state["drift"] + dice.gauss(0, 0.002), 1.0), 1.05)
    return 100 * state["burst"] * state["drift"] * (1 + abs(dice.gauss(0, 0.01)))


def test_floors_that_converged_are_right_beside_bursts_steps_and_drifts() -> None:
    errors, settled = [], 0
    for trial in range(300):
        dice = random.Random(trial)
        state = {"burst": 1.0, "drift": 1.0}
        found: list[list[list[float]]] = []
        while len(found) < 12:
            layout = dice.choice((1.0, 1.0, 1.0, 1.03))
            found.append([[layout * noisy_time(dice, state) for _ in range(5)] for _ in range(3)])
            if floor_of(found).converged:
                break
        floor = floor_of(found)
        settled += floor.converged
        if floor.converged:
            errors.append(floor.time / 100 - 1)
    assert settled >= 200
    assert np.median(errors) < 0.01 and np.quantile(errors, 0.95) < 0.06


def test_one_lucky_layout_does_not_decide() -> None:
    usual = [[[100.0, 101.0]] for _ in range(11)]
    lucky = [[90.0]]
    assert replace(floor_of([*usual, lucky]), processes=11) == floor_of(usual)
    assert floor_of([*usual, lucky, lucky, lucky]).time == 90
    few = floor_of([*usual[:10], lucky])
    assert few.time == 90 and few.high == 100 and not few.converged
    assert floor_of(usual).converged
    assert not floor_of(usual[:NEEDED - 1]).converged
    assert floor_of([*usual, [[100 * (1 - TOLERANCE / 2)]]]).converged


def test_processes_go_on_with_what_is_open_until_time_is_up(tmp_path: Path) -> None:
    sampler = Sampler(install(tmp_path) / "thinbench_sampler")
    samples = Samples(sampler.plan(["--input", "scene"]))
    measure_until_converged([(sampler, samples)], 100)
    assert not open_entries(samples) and len(samples.processes) >= NEEDED
    for number, process in enumerate(samples.processes):
        process.groups[0][2] = [[1.0 + number]]
    assert open_entries(samples) == {0: [2]}
    now = len(samples.processes)
    samples.processes.append(sampler.measure(samples.plan, now, {0: [2]}))
    assert [bool(entry) for entry in samples.processes[-1].groups[0]] == [
        entry == 2 for entry in every_entry(samples.plan)[0]]
    measure_until_converged([(sampler, samples)], 0)
    assert len(samples.processes) == now + 1


def test_a_group_whose_controls_fail_is_measured_again_whole() -> None:
    assert not open_entries(samples_of(spread=0.001))
    samples = samples_of(spread=0.001, same=1.05)
    assert open_entries(samples) == every_entry(samples.plan)


def test_failures_of_the_sampler_are_reported_with_its_status(tmp_path: Path) -> None:
    sampler = Sampler(install(tmp_path) / "thinbench_sampler")
    with pytest.raises(ReportError) as found:
        sampler.plan(["--input", "broken"])
    assert found.value.status == 2
    (tmp_path / "thinbench_sampler").write_text("#!/bin/sh\nexit 1\n")
    with pytest.raises(ReportError, match="a measuring process failed"):
        sampler.measure(make_plan(), 0)
    (tmp_path / "thinbench_sampler").write_text("#!/bin/sh\nprintf '{\"gro'\nexit 1\n")
    with pytest.raises(ReportError, match="a measuring process failed"):
        sampler.measure(make_plan(), 0)
    (tmp_path / "thinbench_sampler").write_text("#!/bin/sh\nkill -9 $$\n")
    with pytest.raises(ReportError) as found:
        sampler.plan([])
    assert found.value.status == 1


def test_every_column_is_documented() -> None:
    text = (ROOT / "docs" / "measuring.md").read_text()
    assert [field.name for field in fields(Row) if f"`{field.name}`" not in text] == []
