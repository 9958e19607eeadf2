"""Estimates, timings.csv, controls and measuring processes."""

from __future__ import annotations

import itertools
import random
import time
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from conftest import ROOT, make_samples
from fake_programs import MACHINE, PROBE, TIMES, Noise, install, make_facts

from report.errors import ReportError
from report.measure.benchmarks import Benchmarks, with_rows
from report.measure.estimates import NEEDED, NEEDED_PROCESSES, Estimates, ratio_of
from report.measure.measurement import UNFINISHED, Measurement, Part
from report.measure.run import controls_of, load_run, write_run
from report.measure.timings import Origin, Row, read_csv, rows_of, to_csv

FACTS = make_facts(("scene", "square_64"))
ROW = "thin_guo_hall/bitpacked/baseline/1/end_to_end/scene"


def rows(samples: pd.DataFrame) -> list[Row]:
    """As they are published."""
    return rows_of(FACTS, Estimates(samples), Origin("run", "machine", "commit"))


def samples_of(noise: Noise = Noise(), processes: int = 9) -> pd.DataFrame:
    """Two inputs."""
    return make_samples(FACTS, noise, processes)


@pytest.mark.parametrize("spread", [0.001, 0.05, 0.5])
def test_quotients_of_published_times_are_the_published_speedups(tmp_path: Path, spread: float) -> None:
    path = tmp_path / "timings.csv"
    path.write_text(to_csv(rows(samples_of(Noise(spread=spread)))))
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


def test_times_are_right_where_most_moments_are_shared() -> None:
    for row in rows(samples_of(Noise(spread=0.02, busy=0.7), processes=12)):
        assert row.time_ns == pytest.approx(TIMES[row.technique], rel=0.01)
        assert row.typical_ns > 1.3 * row.time_ns and row.flags == ""


def test_the_clock_divides_out_and_stands_beside_the_times() -> None:
    half = pd.concat([samples_of(processes=4), samples_of(Noise(clock=1.04), processes=4).assign(
        process=lambda table: table["process"] + 4)])
    times = Estimates(half)
    assert times.time(ROW).value == pytest.approx(TIMES["bitpacked"], rel=0.005)
    assert times.time(ROW).quiet == 64
    assert Estimates(samples_of(Noise(clock=2))).cycle_ns == pytest.approx(0.5, rel=0.005)
    never_quiet = samples_of()
    never_quiet[["before", "after"]] *= 1 + np.random.default_rng(1).random((len(never_quiet), 2))
    assert Estimates(never_quiet).cycle_ns == pytest.approx(0.25, rel=0.005)


def test_a_repetition_whose_probes_differ_does_not_count() -> None:
    samples = samples_of()
    early = samples["process"] < 5
    samples.loc[early, "after"] *= 1.04
    samples.loc[early, "ns"] *= 0.5
    assert Estimates(samples).time(ROW).value == pytest.approx(TIMES["bitpacked"], rel=0.005)


@pytest.mark.parametrize("processes", [3, 9])
@pytest.mark.parametrize("busy", [0.0, 0.6])
def test_intervals_hold_the_true_value_about_as_often_as_they_say(busy: float, processes: int) -> None:
    """Every process has an offset of its own, as layouts make it."""
    held = 0
    for trial in range(60):
        dice = random.Random(trial)
        lines = [(process, row, ns * offset * neighbour * (1 + 0.01 * dice.random()),
                  neighbour * PROBE, neighbour * PROBE, 0.25)
                 for process in range(processes) for row, ns in (("a", 1000.0), ("b", 500.0))
                 for offset in [1 + 0.005 * dice.gauss(0, 1)] for _ in range(20)
                 for neighbour in [1.5 if dice.random() < busy else 1.0]]
        times = Estimates(pd.DataFrame(lines, columns=["process", "row", "ns", "before", "after", "cycle"]))
        ratio = ratio_of(times.time("a"), times.time("b"))
        held += ratio.low <= 2 <= ratio.high
    assert held >= 50  # of 60, where 57 are meant


def test_results_without_quiet_moments_and_groups_whose_controls_fail_are_flagged() -> None:
    def flags(noise: Noise, processes: int = 9) -> set[str]:
        return {row.flags for row in rows(samples_of(noise, processes))}

    assert flags(Noise()) == {""}
    assert flags(Noise(), NEEDED_PROCESSES - 1) == {"open"}
    assert "open" in flags(Noise(busy=0.97))
    assert flags(Noise(same=1.05)) == {"control"}
    assert flags(Noise(slowed=1.02)) == {"control"}
    assert NEEDED > 1


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
    published = replace(rows(samples_of())[0], time_ns=1.2345)
    path.write_text(to_csv([published]).replace("1.2345", time))
    with pytest.raises(ReportError, match="line 2: expected times above 0, got time_ns"):
        read_csv(path)
    path.write_text(to_csv(rows(samples_of())[:1]).rstrip().rpartition(",")[0] + "\n")
    with pytest.raises(ReportError, match="line 2: column 'sweep' is missing"):
        read_csv(path)


def part_of(samples: pd.DataFrame) -> Part:
    """That was measured."""
    return Part(FACTS, tables=[samples])


def test_controls_are_counted_by_group() -> None:
    def failed(noise: Noise) -> int:
        samples = samples_of(noise)
        return int(controls_of([(part_of(samples), Estimates(samples))])["failed"])

    assert (failed(Noise()), failed(Noise(same=1.05)), failed(Noise(slowed=1.02))) == (0, 2, 2)


def test_a_directory_holds_all_of_a_run(tmp_path: Path) -> None:
    samples = samples_of()
    written = write_run(tmp_path / "run", MACHINE, {}, [part_of(samples)])
    run = load_run(tmp_path / "run")
    assert run.facts == written.facts and run.facts["controls"]["failed"] == 0
    assert run.facts["run"] == "intel-6-143-8-1a2b3c4d/run"
    assert to_csv(run.rows) == to_csv(written.rows)
    again = pd.read_csv(tmp_path / "run" / "samples.csv.xz")
    assert len(again) == len(samples) and set(again) == {*samples, "sweep"}
    assert Estimates(again).time(ROW).value == pytest.approx(Estimates(samples).time(ROW).value, rel=1e-3)


def test_a_row_that_failed_is_skipped_with_the_reason(tmp_path: Path) -> None:
    samples = samples_of()
    run = write_run(tmp_path / "run", MACHINE, {}, [part_of(samples[samples["row"] != ROW])])
    assert ROW not in {row.name for row in run.rows} and len(run.rows) == 2 * len(TIMES) - 1
    assert [item["reason"] for item in run.facts["skipped"] if item["row"] == ROW] == [
        "it was not measured: it failed, or time was up"]


def test_a_directory_without_a_run_is_rejected_in_one_line(tmp_path: Path) -> None:
    with pytest.raises(ReportError, match="run.json: cannot be read"):
        load_run(tmp_path)
    for text in ('{"schema": 1}', '{"schema"'):
        (tmp_path / "run.json").write_text(text)
        with pytest.raises(ReportError, match="run.json: "):
            load_run(tmp_path)


def test_one_thread_has_processor_time_and_several_have_the_clock_on_the_wall(tmp_path: Path) -> None:
    benchmarks = Benchmarks(install(tmp_path) / "thinbench_benchmarks")
    facts = benchmarks.verify(["--input", "scene"])
    ns = benchmarks.measure(facts).groupby("row")["ns"].min()
    assert ns[ROW] == pytest.approx(TIMES["bitpacked"], rel=0.01)
    facts["rows"][ROW]["threads"] = 2
    assert benchmarks.measure(facts).groupby("row")["ns"].min()[ROW] == pytest.approx(2 * TIMES["bitpacked"], rel=0.01)


@pytest.fixture(name="benchmarks")
def _benchmarks(tmp_path: Path) -> Benchmarks:
    return Benchmarks(install(tmp_path / "bin") / "thinbench_benchmarks")


def test_rounds_go_on_until_time_is_up_and_times_can_settle(benchmarks: Benchmarks, tmp_path: Path,
                                                            monkeypatch: pytest.MonkeyPatch) -> None:
    seconds = itertools.count()  # each look at the clock takes one
    monkeypatch.setattr(time, "monotonic", lambda: next(seconds))
    measurement = Measurement.begin(tmp_path, {}, lambda: [Part(FACTS), Part(make_facts(("square_8",)))])
    assert measurement.run(benchmarks, 0)
    assert [len(part.tables) for part in measurement.parts] == [NEEDED_PROCESSES] * 2
    assert measurement.run(benchmarks, 50)
    assert min(len(part.tables) for part in measurement.parts) > NEEDED_PROCESSES
    measurement.close()
    assert not (tmp_path / UNFINISHED).exists()


class _Stopping(Benchmarks):
    """Ctrl-C in the third process."""

    started = 0

    def measure(self, *words: object) -> pd.DataFrame:  # type: ignore[override]
        self.started += 1
        if self.started == 3:
            raise KeyboardInterrupt
        return super().measure(*words)  # type: ignore[arg-type]


def test_an_interrupted_measurement_goes_on_where_it_was(benchmarks: Benchmarks, tmp_path: Path) -> None:
    key = {"seconds": 3}
    first = Measurement.begin(tmp_path, key, lambda: [Part(FACTS, "a"), Part(with_rows(FACTS, [ROW]), "b")])
    assert not first.run(_Stopping(benchmarks.program), 3)
    done = [len(part.tables) for part in first.parts]
    assert sum(done) == 2
    with pytest.raises(ReportError, match="holds an interrupted measurement: continue it with --resume"):
        Measurement.begin(tmp_path, key, lambda: [Part(FACTS)])
    with pytest.raises(ReportError, match="seconds was 3 and is now 4; --resume needs the same"):
        Measurement.resume(tmp_path, {"seconds": 4})
    again = Measurement.resume(tmp_path, key)
    assert [len(part.tables) for part in again.parts] == done
    for old, new in zip(first.parts, again.parts):
        assert (old.facts, old.sweep) == (new.facts, new.sweep)
        assert np.allclose(old.samples["ns"], new.samples["ns"])
    assert again.run(benchmarks, 0)
    assert [len(part.tables) for part in again.parts] == [NEEDED_PROCESSES] * 2
    table = next((tmp_path / UNFINISHED).glob("*.csv"))
    table.write_bytes(table.read_bytes()[:40] + b"\xff\0")
    with pytest.raises(ReportError, match=f"{table.name}: is no table; delete"):
        Measurement.resume(tmp_path, key)


def test_nothing_to_continue_is_said(tmp_path: Path) -> None:
    with pytest.raises(ReportError, match="plan.json"):
        Measurement.resume(tmp_path, {})
    (tmp_path / UNFINISHED).mkdir()
    (tmp_path / UNFINISHED / "plan.json").write_text("")
    with pytest.raises(ReportError, match="cannot be continued; delete it"):
        Measurement.resume(tmp_path, {})


def test_rows_that_all_take_too_long_are_no_run(tmp_path: Path) -> None:
    facts = make_facts() | {"rows": {}, "skipped": [{"row": "a", "reason": "a call takes more than 1 s"}]}
    with pytest.raises(ReportError, match="every row that matches is skipped: a call takes more than 1 s"):
        Measurement.begin(tmp_path, {}, lambda: [Part(facts)])
    assert not (tmp_path / UNFINISHED).exists()


def test_failures_of_the_program_are_reported_with_its_status(benchmarks: Benchmarks) -> None:
    with pytest.raises(ReportError) as found:
        benchmarks.verify(["--input", "broken"])
    assert found.value.status == 2
    benchmarks.program.write_text("#!/bin/sh\nexit 1\n")
    with pytest.raises(ReportError, match="a measuring process failed"):
        benchmarks.measure(FACTS)
    benchmarks.program.write_text("#!/bin/sh\nkill -9 $$\n")
    with pytest.raises(ReportError) as found:
        benchmarks.verify([])
    assert found.value.status == 1


def test_whole_lines_of_a_failing_process_count(benchmarks: Benchmarks) -> None:
    lines = len(benchmarks.measure(FACTS))
    program = benchmarks.program
    whole = program.with_name("whole")
    program.rename(whole)
    program.write_text(f'#!/bin/sh\n"{whole}" "$@"\ntruncate -s -12 "$4"\nexit 1\n')
    program.chmod(0o755)
    assert len(benchmarks.measure(FACTS)) == lines - 1 > 0


def test_every_column_is_documented() -> None:
    text = (ROOT / "results" / "README.md").read_text()
    assert [field.name for field in fields(Row) if f"`{field.name}`" not in text] == []
