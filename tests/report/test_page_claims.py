"""Verdicts follow the data: changed data changes them."""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from conftest import MACHINE, ROOT, make_facts, make_row

from report.claims import Claim, Verdict, judge, of_experiments, of_times
from report.errors import ReportError
from report.files import to_json
from report.measure.run import Run
from report.measure.timings import Row
from report.page.experiments import DIRECTORY, NAMES, experiment_tables, load_experiments
from report.page.operations import Rows
from report.page.sentences import choice_text
from report.page.table_two import PAPER, table_two

GOLDEN = load_experiments()


def rows_with(*rows: Row) -> Rows:
    return Rows(Run(ROOT, make_facts(list(rows)), list(rows)))


def test_every_experiment_is_stored_and_has_a_table():
    assert set(GOLDEN) == set(NAMES)
    assert len(experiment_tables(GOLDEN)) >= len(NAMES)
    for table in experiment_tables(GOLDEN):
        assert table.rows and all(len(row) == len(table.header) for row in table.rows)


def test_a_damaged_experiment_is_rejected(tmp_path):
    (tmp_path / "experiments").mkdir()
    (tmp_path / "experiments" / "quality.json").write_bytes(to_json({"schema": 1, "experiment": "quality"}))
    with pytest.raises(ReportError, match="quality.json"):
        load_experiments(tmp_path)


def without_a_sum(data: Any) -> None:
    """One count is another than the paper's."""
    cluster = next(one for one in data["methods"] if one["method"].startswith("Cluster"))
    cluster["sums"]["arithmetic"] += 1


def only_rows(where: Callable[[Any], bool]) -> Callable[[Any], None]:
    """Others are left out."""
    def change(data: Any) -> None:
        data["rows"] = [row for row in data["rows"] if where(row)]
    return change


def with_whole_objects(data: Any) -> None:
    """There are as many objects after thinning as before."""
    for row in data["rows"]:
        row["objects_after"] = row["objects_before"]


@pytest.mark.parametrize(("claim", "name", "before", "change", "after"), [
    (of_experiments.operation_counts, "operation-counts", Verdict.HOLDS, without_a_sum, Verdict.PARTLY),
    (of_experiments.linear_threshold, "quantisation", Verdict.HOLDS,
     lambda data: data.update(as_published={"right_sigmoid": 256, "right_linear": 255}), Verdict.FAILS),
    (of_experiments.twelve_nets, "cluster-runs", Verdict.HOLDS,
     lambda data: data.update(rows=data["rows"] * 2), Verdict.FAILS),
    (of_experiments.eight_hidden_neurons, "hidden-neurons", Verdict.FAILS,
     only_rows(lambda row: row["hidden"] >= 8), Verdict.HOLDS),
    (of_experiments.reliable_edges, "edge-quality", Verdict.PARTLY,
     only_rows(lambda row: row["sigma"] == 0), Verdict.HOLDS),
    (of_experiments.connected_skeleton, "quality", Verdict.FAILS, with_whole_objects, Verdict.HOLDS)])
def test_verdicts_follow_the_results_of_experiments(
        claim: Callable[[Any], Claim], name: str, before: Verdict, change: Callable[[Any], object],
        after: Verdict) -> None:
    data = copy.deepcopy(GOLDEN[name])
    assert claim(data).verdict is before
    change(data)
    assert claim(data).verdict is after


RULE, NET = "thin_naccache_shinghal", "net_two_layer_linear"


@pytest.mark.parametrize(("claim", "times", "verdict"), [
    *((of_times.bytes_are_faster, [(RULE, "reference", "baseline", 1e7), (RULE, "lut", "baseline", byte_ns),
                                   (RULE, "bitpacked", "baseline", 1e5)], verdict)
      for byte_ns, verdict in ((1e4, Verdict.HOLDS), (0.99e5, Verdict.FAILS), (1e6, Verdict.FAILS))),  # by the interval
    *((of_times.nets_do_not_pay, [(RULE, "simd_bitpacked", "avx2", 1e5), (NET, "simd_float_bits", "avx2", arithmetic_ns),
                                  (NET, "simd_bitpacked", "avx2", circuit_ns)], verdict)
      for arithmetic_ns, circuit_ns, verdict in ((1e6, 3e5, Verdict.HOLDS), (1e6, 1e5, Verdict.HOLDS),
                                                 (1e6, 0.96e5, Verdict.HOLDS),  # the same circuit elsewhere in memory
                                                 (1e6, 5e4, Verdict.PARTLY), (5e4, 5e4, Verdict.FAILS))),
    (lambda rows: of_times.integers_do_not_pay(rows, GOLDEN["quantisation"]),  # time is gained, answers are lost
     [(NET, "simd_float_bits", "avx2", 2e5), (NET, "simd_fixed_point", "avx2", 1e5)], Verdict.PARTLY)])
def test_verdicts_follow_times(claim, times, verdict):
    assert claim(rows_with(*(make_row(*time) for time in times))).verdict is verdict


def paper_rows(swap: bool) -> Rows:
    """Times in the paper's order, or two of them exchanged."""
    seconds = [row.seconds for row in PAPER]
    seconds[:2] = reversed(seconds[:2]) if swap else seconds[:2]
    return rows_with(*(make_row(row.operation, technique, "baseline", ns * time)
                       for row, time in zip(PAPER, seconds)
                       for technique, ns in (("reference", 1e7), ("bitpacked", 1e5))))


def test_the_order_of_table_two_holds_only_if_no_pair_is_swapped():
    assert of_times.order_of_table_two(paper_rows(False)).verdict is Verdict.HOLDS
    assert of_times.order_of_table_two(paper_rows(True)).verdict is Verdict.PARTLY
    in_order = sorted(PAPER, key=lambda row: row.seconds)
    equal = rows_with(*(make_row(row.operation, technique, "baseline", 1e7 * 1.009 ** place)
                        for place, row in enumerate(in_order) for technique in ("reference", "bitpacked")))
    assert of_times.order_of_table_two(equal).verdict is Verdict.FAILS


def test_table_two_gives_the_papers_ratio_to_the_same_times():
    for row in table_two(paper_rows(False)).rows:
        assert row[3] == row[5] == row[7]


def test_claims_without_data_are_open():
    claims = judge(rows_with(make_row("holes", "simd_runs", "avx2", 1e5)), {})
    assert len(claims) == 10 and all(claim.verdict is Verdict.OPEN for claim in claims)


def test_claims_name_their_run(make):
    built = make([replace(make_row("holes", "simd_runs", "avx2", 1e5), border="")])
    assert MACHINE["commit"] in built.text("claims.md") and DIRECTORY.is_dir()


def test_a_case_where_another_variant_is_faster_than_the_choice_is_named():
    def group(case: str, chosen: float, **changes: Any) -> list[Row]:
        return [make_row(case, "simd", "avx512", chosen, **changes), make_row(case, "scalar", "baseline", 100, **changes)]
    near, slow = group("holes", 104.9), group("edges_sobel", 130)
    assert choice_text([*near, *slow]) == (
        "In **1 of 2** cases the variant that the library takes is within 5 % of the fastest; "
        "not in edges_sobel on scene (1.30\N{MULTIPLICATION SIGN} its time).")
    assert choice_text(near) == ("In **1 of 1** cases the variant that the library takes is within 5 % of the fastest.")
    assert choice_text([*group("holes", 130, flags="open"), *group("holes", 130, threads=2), slow[0]]) == ""
