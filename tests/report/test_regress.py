"""The regression check, on samples with known times."""

from __future__ import annotations

import copy
from argparse import Namespace
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pandas as pd
import pytest
from conftest import make_samples
from fake_programs import MACHINE, Noise, install, make_facts
from junitparser import JUnitXml

from report.__main__ import main
from report.errors import ReportError
from report.measure.benchmarks import Benchmarks, Json
from report.measure.estimates import Estimate
from report.measure.machine import machine_facts
from report.regress import builds, command, output, self_test, stored
from report.regress.verdicts import (Layer, RowVerdict, Verdict, decide, exit_status, judge,
                                     layer_of, skipped)
from report.schemas import check_schema

PASS, FAIL, INCONCLUSIVE, SKIPPED = Verdict
CACHE = 2.0 ** 20
ROW, OTHER = (f"thin_guo_hall/{name}/1/end_to_end/scene"
              for name in ("bitpacked/baseline", "simd_bitpacked/avx2"))


FACTS = make_facts()


def samples_of(slower: float = 1.0, *, reference: float = 1.0, facts: Json = FACTS, noise: Noise = Noise(),
               processes: int = 9, seed: int = 1) -> pd.DataFrame:
    """`bitpacked` and the reference take so many times as long as usual."""
    samples = make_samples(facts, noise, processes, seed)
    technique = samples["row"].str.split("/").str[1]
    samples["ns"] *= technique.map({"bitpacked": slower, "reference": reference}).fillna(1.0)
    return samples


def measured(*arguments: float, facts: Json = FACTS, **options: Any) -> stored.Measured:
    """As a comparison takes it."""
    return stored.measured_from(facts, samples_of(*arguments, facts=facts, **options))


def baseline_of(before: stored.Measured) -> Json:
    """As --update writes it."""
    return stored.baseline_from(before, MACHINE, "", "first", None)


def verdict_on(before: stored.Measured, now: stored.Measured, cache: float = CACHE) -> RowVerdict:
    """Of the row that is slowed down."""
    rows = stored.against_baseline(now, baseline_of(before), cache, False)
    return next(row for row in rows if row.name == ROW)


def change(value: float) -> Estimate:
    """With an interval of 1 % to both sides."""
    return Estimate(value, value - 0.01, value + 0.01)


@pytest.mark.parametrize("value, verdict", [(0.88, FAIL), (0.895, INCONCLUSIVE), (0.92, PASS)])
def test_a_row_fails_only_where_its_whole_interval_is_beyond_the_limit(value: float,
                                                                       verdict: Verdict) -> None:
    assert judge(change(value), 0.10) == verdict


@pytest.mark.parametrize("rounds, verdict", [
    ([PASS], PASS), ([FAIL, FAIL], FAIL), ([INCONCLUSIVE, PASS], PASS),
    ([INCONCLUSIVE, FAIL, FAIL], FAIL), ([FAIL, PASS, PASS], PASS),
    ([FAIL, INCONCLUSIVE, FAIL, FAIL], FAIL), ([INCONCLUSIVE] * 5, INCONCLUSIVE),
    ([INCONCLUSIVE] * 4 + [FAIL], INCONCLUSIVE)])
def test_fail_needs_two_rounds_in_a_row_and_pass_one_after_it(rounds: list[Verdict], verdict: Verdict) -> None:
    left = list(rounds)
    rows = decide(lambda number, names, alone: [RowVerdict("a", left.pop(0))])
    assert [row.verdict for row in rows] == [verdict]
    assert left == []


@pytest.mark.parametrize("chosen, shown, asked", [
    (None, [("a", PASS), ("b", FAIL), ("c", SKIPPED)], [(0, None, set()), (1, {"b"}, {"b"})]),
    ({"a"}, [("a", PASS)], [(0, {"a"}, set())])])
def test_only_open_rows_are_measured_again_and_what_failed_is_judged_alone(
        chosen: set[str] | None, shown: list[tuple[str, Verdict]], asked: list[object]) -> None:
    calls: list[object] = []

    def attempt(number: int, rows: set[str] | None, alone: set[str]) -> list[RowVerdict]:
        calls.append((number, rows, alone))
        return [RowVerdict("a", PASS), RowVerdict("b", FAIL), skipped("c", "new")]

    assert [(row.name, row.verdict) for row in decide(attempt, chosen)] == shown
    assert calls == asked


OTHER_STATE = "another state of the machine: the reference took"


@pytest.mark.parametrize(("slower", "options", "verdict", "reason"), [
    (1.0, {}, PASS, ""), (1.2, {}, FAIL, ""),
    (1.0, {"noise": Noise(clock=2)}, PASS, ""), (1.2, {"noise": Noise(clock=2)}, FAIL, ""),  # compared in clock cycles
    (1.5, {"reference": 0.8}, INCONCLUSIVE, OTHER_STATE), (1.3, {"reference": 1.3}, PASS, ""),
    (1.5, {"noise": Noise(same=1.05)}, INCONCLUSIVE, "the controls of its case failed")])
def test_only_a_slowdown_in_the_same_state_fails(slower: float, options: dict[str, Any], verdict: Verdict,
                                                 reason: str) -> None:
    row = verdict_on(measured(), measured(slower, **options))
    assert row.verdict == verdict and row.reason.startswith(reason) and bool(row.reason) == bool(reason)
    if not options:
        assert row.before and row.now and row.now.row == pytest.approx(slower * row.before.row, rel=0.02)
        assert row.now.reference == pytest.approx(row.before.reference, rel=0.02)


@pytest.mark.parametrize(("slower", "verdict"), [(1.15, PASS), (1.3, FAIL)])
def test_images_beyond_the_cache_may_lose_twice_as_much(slower: float, verdict: Verdict) -> None:
    assert verdict_on(measured(), measured(slower), 10).verdict == verdict


def test_one_reference_that_moved_neither_slows_its_rows_nor_lets_them_fail() -> None:
    facts = make_facts(("scene", "square_32", "square_64"))
    now = samples_of(facts=facts)
    moved = now["row"].str.contains("reference/baseline/1/end_to_end/scene")
    now.loc[moved, "ns"] *= 0.8
    assert verdict_on(measured(facts=facts), stored.measured_from(facts, now)).verdict == PASS
    now.loc[now["row"] == ROW, "ns"] *= 1.2
    slower = verdict_on(measured(facts=facts), stored.measured_from(facts, now))
    assert slower.verdict == INCONCLUSIVE and slower.reason.startswith("another state of the machine")


def test_rows_that_cannot_be_compared_are_skipped() -> None:
    baseline = baseline_of(measured())
    baseline["rows"]["gone/a/b/1/kernel/scene"] = baseline["rows"].pop(OTHER)
    now = measured(1.5)
    rows = {row.name: row
            for row in stored.against_baseline(now, baseline, CACHE, False)}
    assert rows[OTHER].reason == "new: there is nothing to compare with"
    assert rows["gone/a/b/1/kernel/scene"].reason == "not measured in this run"
    assert "gone/a/b/1/kernel/scene" not in {
        row.name for row in stored.against_baseline(now, baseline, CACHE, False, is_part=True)}
    assert rows[ROW].verdict == FAIL
    other_image = measured(1.5, facts=make_facts(pixels="1" * 16))
    assert {row.reason for row in stored.against_baseline(
        other_image, baseline_of(measured()), CACHE, False)} == {"another image than in the baseline"}


def test_a_baseline_fits_its_schema_and_keeps_its_history() -> None:
    first = baseline_of(measured())
    second = stored.baseline_from(measured(0.8), MACHINE, "", "faster", first)
    check_schema("baseline", second, "baseline")
    assert [event["reason"] for event in second["history"]] == ["first", "faster"]
    assert second["history"][0]["change"] is None
    assert second["history"][1]["change"] == pytest.approx(1.25 ** 0.5, rel=0.02)


def pair_of(slower: float, noise: Noise = Noise(), processes: int = 9) -> builds.Pair:
    """Two builds, one of them with a slower row and its controls."""
    (pair,), _ = builds.common_pairs(FACTS, FACTS)
    both = [samples_of(factor, facts=pair.facts[0], noise=noise, processes=processes, seed=seed).assign(build=build)
            for build, (factor, seed) in enumerate(((1.0, 1), (slower, 2)))]
    samples = pd.concat(both, ignore_index=True)
    pair.tables += [table.drop(columns="process") for _, table in samples.groupby("process")]
    return pair


def verdicts(pair: builds.Pair) -> dict[str, RowVerdict]:
    """By name."""
    return {row.name: row for row in builds.verdicts_of(pair, False, 5)}


@pytest.mark.parametrize("slower, verdict", [(1.0, PASS), (0.9, PASS), (1.06, FAIL)])
def test_two_builds_are_told_apart(slower: float, verdict: Verdict) -> None:
    rows = verdicts(pair_of(slower))
    assert rows[ROW].verdict == verdict
    assert rows[OTHER].verdict == PASS
    row = rows[ROW]
    assert row.change and row.before and row.now
    assert row.change.value == pytest.approx(row.before.row / row.now.row)


def test_the_interval_is_wider_where_more_rows_are_compared() -> None:
    times = builds.times_of(pair_of(1.0, Noise(spread=0.05)).tables)
    before, now = (times.time(key) for key in builds.keys_of(ROW))
    few, many = (builds.change_of(before, now, compared) for compared in (1, 500))
    assert few.value == many.value and many.low < few.low and few.high < many.high


def test_controls_that_fail_reject_the_comparison_of_two_builds() -> None:
    wide = verdicts(pair_of(1.06, Noise(same=1.08, slowed=1.3)))[ROW]
    assert wide.verdict == INCONCLUSIVE and wide.reason.startswith("a row differs from itself by")
    blind = verdicts(pair_of(1.2, Noise(slowed=1.0)))[ROW]
    assert blind.verdict == INCONCLUSIVE
    assert blind.reason == "the injected slowdown of 10 % was not found"


def test_two_builds_without_quiet_moments_are_not_judged() -> None:
    assert verdicts(pair_of(1.2, Noise(busy=0.98)))[ROW].verdict == INCONCLUSIVE


def test_replayed_slowdowns_are_found_and_equal_builds_pass() -> None:
    recorded = [pair_of(1.0, processes=5 * builds.PAIRS)]
    assert self_test.replay(recorded, 0, 10) == ({PASS: 10}, builds.PAIRS)
    assert self_test.replay(recorded, 5, 10) == ({FAIL: 10}, 2 * builds.PAIRS)


@pytest.mark.parametrize(("equal", "slower", "verdict"), [
    ({PASS: 100}, {FAIL: 90, PASS: 10}, PASS),
    ({PASS: 100}, {FAIL: 70, PASS: 30}, FAIL),
    ({PASS: 99, FAIL: 1}, {FAIL: 100}, FAIL),
    ({PASS: 100}, {FAIL: 40, INCONCLUSIVE: 60}, INCONCLUSIVE),
    ({PASS: 45, INCONCLUSIVE: 55}, {FAIL: 100}, INCONCLUSIVE)])
def test_the_self_test_fails_where_verdicts_are_wrong_and_not_where_there_are_none(equal, slower, verdict) -> None:
    assert self_test.judged({("idle", 0): Counter(equal), ("idle", 5): Counter(slower)}) == verdict


def test_processes_of_two_builds_take_turns() -> None:
    order = []

    class Named(Benchmarks):
        """Notes when it measures."""

        def measure(self, facts: Json, options: Sequence[str] = ()) -> pd.DataFrame:
            order.append(str(self.program))
            return make_samples(facts, processes=1).drop(columns="process")

    pairs, _ = builds.common_pairs(FACTS, FACTS)
    builds.measure_in_turn((Named(Path("before")), Named(Path("now"))), pairs, range(3))
    assert order == ["now", "before", "before", "now", "now", "before"]
    assert len(pairs[0].tables) == 3 and set(pairs[0].tables[0]["build"]) == {0, 1}


def test_builds_are_compared_on_the_rows_with_equal_results() -> None:
    before, now = copy.deepcopy(FACTS), copy.deepcopy(FACTS)
    copied = next(name for name in before["rows"] if "copy" in name)
    before["rows"][copied]["hash"] = "another"
    now["rows"][ROW.replace("/1/", "/3/")] = copy.deepcopy(now["rows"][ROW])
    pairs, left_out = builds.common_pairs(before, now)
    assert {row.reason for row in left_out} == {"new: there is nothing to compare with",
                                               "another result than in the other build"}
    assert not any("reference" in name or "copy" in name for pair in pairs for name in pair.rows)
    gone = copy.deepcopy(FACTS)
    del gone["rows"][OTHER]
    gone["skipped"] = [{"row": OTHER, "reason": "a call takes more than 1 s"}]
    assert [(row.name, row.reason) for row in builds.common_pairs(FACTS, gone)[1] if row.name == OTHER] == [
        (OTHER, "a call takes more than 1 s")]


def test_an_existing_build_is_the_base(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(builds, "PAIRS", 3)
    text, status = run(tmp_path, monkeypatch, base_build=install(tmp_path / "base"))
    assert (text.splitlines()[-1], status) == ("instructions SKIPPED, times PASS", 0)


@pytest.mark.parametrize("instructions, times, counts_only, status", [
    (PASS, PASS, False, 0), (FAIL, PASS, False, 1), (PASS, FAIL, False, 1),
    (PASS, INCONCLUSIVE, False, 3), (PASS, SKIPPED, False, 4), (SKIPPED, PASS, False, 0),
    (PASS, SKIPPED, True, 0), (FAIL, SKIPPED, True, 1), (SKIPPED, SKIPPED, True, 4)])
def test_exit_statuses(instructions: Verdict, times: Verdict, counts_only: bool,
                       status: int) -> None:
    layers = (Layer(verdict, []) for verdict in (instructions, times))
    assert exit_status(*layers, counts_only) == status


def outcome(*verdicts: Verdict) -> output.Outcome:
    """One row of each verdict, and counts of one."""
    rows = [RowVerdict(f"row <{verdict}>", verdict, "", change(0.9), 0.025, None, None)
            for verdict in verdicts]
    return output.Outcome(Layer(PASS, [RowVerdict("counted", PASS)]), layer_of(rows),
                          {"counted": 1234})


def test_junit_is_read_back(tmp_path: Path) -> None:
    path = tmp_path / "regress.xml"
    path.write_bytes(output.to_junit(outcome(*Verdict)))
    suites = {suite.name: suite for suite in JUnitXml.fromfile(str(path))}
    times = suites["times"]
    assert (times.tests, times.failures, times.skipped, times.errors) == (4, 1, 2, 0)
    results = {case.name: [type(result).__name__ for result in case.result] for case in times}
    assert results == {"row <PASS>": [], "row <FAIL>": ["Failure"],
                       "row <INCONCLUSIVE>": ["Skipped"], "row <SKIPPED>": ["Skipped"]}
    assert suites["instructions"].failures == 0


def test_bencher_metrics_have_intervals() -> None:
    rows = stored.against_baseline(measured(), baseline_of(measured()), CACHE, False)
    metrics = output.to_bencher(output.Outcome(Layer(PASS, []), layer_of(rows), {ROW: 1234}))
    assert metrics[ROW]["instructions"] == {"value": 1234}
    speedup = metrics[ROW]["speedup"]
    assert speedup["lower_value"] <= speedup["value"] <= speedup["upper_value"]
    assert speedup["value"] == pytest.approx(20, rel=0.05)
    assert metrics[ROW]["latency"]["value"] == pytest.approx(5e4, rel=0.05)


def test_github_is_told_only_what_is_wrong() -> None:
    fine = outcome(PASS, SKIPPED)
    assert output.to_annotations(fine) == output.to_markdown(fine) == ""
    wrong = outcome(PASS, FAIL, INCONCLUSIVE, INCONCLUSIVE)
    lines = output.to_annotations(wrong).splitlines()
    assert [line.split(" ")[0] for line in lines] == ["::error", "::warning"]
    assert "-10.0 %25" in lines[0]
    assert output.to_markdown(wrong).count("\n| INCONCLUSIVE") == 2


def test_only_rows_that_did_not_pass_are_shown_and_the_verdicts_last() -> None:
    found = outcome(PASS, FAIL)
    assert "row <PASS>" not in output.to_text(found, False)
    assert "row <PASS>" in output.to_text(found, True)
    assert output.to_text(found, False).splitlines()[-1] == "instructions PASS, times FAIL"


def options_of(tmp_path: Path, **changes: object) -> Namespace:
    """As the command line gives them."""
    defaults = {"against": None, "base_build": None, "filter": "", "image": [], "foreground": "auto",
                "threshold": "otsu", "all": False, "judge_threads": False, "update": False,
                "baselines": tmp_path / "baselines", "reason": None, "no_instructions": True,
                "counts_only": False, "junit": None, "bencher": None, "github": False,
                "self_test": False, "quick": False}
    return Namespace(**defaults | changes)


def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, **changes: object) -> tuple[str, int]:
    """The command, with programs that know their times, on a machine without other work."""
    monkeypatch.setattr(command, "is_clean", lambda: True)
    for name in ("PROCESSES", "UPDATE_PROCESSES"):
        monkeypatch.setattr(stored, name, 3)
    programs = install(tmp_path / "bin")
    return command.run_regress(None, options_of(tmp_path, **changes),  # type: ignore[arg-type]
                               lambda _root, _targets: programs)


def baseline_name(tmp_path: Path) -> str:
    return f"{machine_facts(install(tmp_path / 'bin') / 'thinbench_benchmarks', '')['fingerprint']}.json"


def test_the_command_writes_a_baseline_and_compares_with_it(
        tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text, status = run(tmp_path, monkeypatch)
    assert status == 4 and "there is no baseline" in text
    name = baseline_name(tmp_path)
    assert run(tmp_path, monkeypatch, update=True, reason="first")[1] == 0
    assert [path.name for path in (tmp_path / "baselines").iterdir()] == [name]
    text, status = run(tmp_path, monkeypatch, junit=tmp_path / "regress.xml")
    assert (text.splitlines()[-1], status) == ("instructions SKIPPED, times PASS", 0)
    assert JUnitXml.fromfile(str(tmp_path / "regress.xml")) is not None


def test_a_busy_machine_makes_no_baseline(tmp_path: Path,
                                          monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stored, "why_unfit", lambda _: "3 rows did not settle")
    with pytest.raises(ReportError, match="no baseline was written: 3 rows") as error:
        run(tmp_path, monkeypatch, update=True, reason="first")
    assert error.value.status == 3
    assert not (tmp_path / "baselines").exists()


def test_errors_are_no_verdict(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = baseline_name(tmp_path)
    (tmp_path / "baselines").mkdir()
    (tmp_path / "baselines" / name).write_text("{}")
    with pytest.raises(ReportError, match="regress: .*is a required property") as error:
        run(tmp_path, monkeypatch)
    assert error.value.status == 2


@pytest.mark.parametrize("words, text", [
    (["--update"], "--update needs --reason TEXT"),
    (["--reason", "why"], "--reason needs --update"),
    (["--update", "--reason", "why", "--filter", "^holes/"], "with --filter or --image it needs --baselines DIR"),
    (["--update", "--reason", "why", "--against", "HEAD"], "it excludes --against"),
    (["--against", "no_such_commit"], "there is no commit 'no_such_commit' in this clone"),
    (["--against", ""], "there is no commit '' in this clone"),
    (["--base-build", "/nowhere"], "'/nowhere' holds no program thinbench-study"),
    (["--quick"], "--quick needs --self-test"),
    (["--foreground", "dark"], "--foreground needs --image"),
    (["--no-instructions", "--counts-only"], "not allowed with")])
def test_wrong_usage_ends_with_status_2(words: list[str], text: str,
                                        capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["regress", *words])
    assert stop.value.code == 2
    assert text in capsys.readouterr().err
