"""Verdicts follow the data: changed data changes them."""

from __future__ import annotations

import copy
from dataclasses import replace
from typing import Any

import pytest
from conftest import MACHINE, ROOT, build, make_facts, make_row, write_run

from report.claims import Claim, Verdict, judge, of_experiments, of_times
from report.errors import ReportError
from report.files import to_json
from report.measure.run import Run
from report.measure.timings import Row
from report.page.experiments import DIRECTORY, NAMES, experiment_tables, load_experiments
from report.page.operations import Rows
from report.page.table_two import PAPER, table_two

GOLDEN = load_experiments()


def rows_with(*rows: Row) -> Rows:
    return Rows(Run(ROOT, make_facts(list(rows)), list(rows)))


def golden(name: str, **changes: Any) -> Any:
    return copy.deepcopy(GOLDEN[name]) | changes


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


def test_operation_counts_hold_only_where_every_count_is_the_papers():
    data = golden("operation-counts")
    assert of_experiments.operation_counts(data).verdict is Verdict.HOLDS
    cluster = next(one for one in data["methods"] if one["method"].startswith("Cluster"))
    cluster["sums"]["arithmetic"] += 1
    assert of_experiments.operation_counts(data).verdict is Verdict.PARTLY


def test_one_wrong_neighbourhood_refutes_the_linear_threshold():
    data = golden("quantisation", as_published={"right_sigmoid": 256, "right_linear": 255})
    assert of_experiments.linear_threshold(data).verdict is Verdict.FAILS


def test_twelve_nets_hold_with_twelve_runs_and_fail_with_thirteen():
    data = golden("cluster-runs")
    assert of_experiments.twelve_nets(data).verdict is Verdict.HOLDS
    assert of_experiments.twelve_nets(data | {"rows": data["rows"] * 2}).verdict is Verdict.FAILS


def test_eight_neurons_are_optimal_only_where_fewer_learn_less():
    data = golden("hidden-neurons")
    assert of_experiments.eight_hidden_neurons(data).verdict is Verdict.FAILS
    eight_up = [row for row in data["rows"] if row["hidden"] >= 8]
    assert of_experiments.eight_hidden_neurons(data | {"rows": eight_up}).verdict is Verdict.HOLDS


def test_edges_are_reliable_in_part_where_noise_breaks_some():
    data = golden("edge-quality")
    assert of_experiments.reliable_edges(data).verdict is Verdict.PARTLY
    clean = [row for row in data["rows"] if row["sigma"] == 0]
    assert of_experiments.reliable_edges(data | {"rows": clean}).verdict is Verdict.HOLDS


def test_a_skeleton_is_connected_only_if_objects_stay_as_many():
    data = golden("quality")
    assert of_experiments.connected_skeleton(data).verdict is Verdict.FAILS
    whole = [row | {"objects_after": row["objects_before"]} for row in data["rows"]]
    assert of_experiments.connected_skeleton(data | {"rows": whole}).verdict is Verdict.HOLDS


def bytes_claim(byte_ns: float) -> Claim:
    rule = "thin_naccache_shinghal"
    return of_times.bytes_are_faster(rows_with(
        make_row(rule, "reference", "baseline", 1e7), make_row(rule, "lut", "baseline", byte_ns),
        make_row(rule, "bitpacked", "baseline", 1e5)))


def test_bytes_are_faster_only_where_the_whole_interval_says_so():
    assert bytes_claim(1e4).verdict is Verdict.HOLDS
    assert bytes_claim(0.99e5).verdict is Verdict.FAILS
    assert bytes_claim(1e6).verdict is Verdict.FAILS


def nets_claim(arithmetic_ns: float, circuit_ns: float) -> Claim:
    net = "net_two_layer_linear"
    return of_times.nets_do_not_pay(rows_with(
        make_row("thin_naccache_shinghal", "simd_bitpacked", "avx2", 1e5),
        make_row(net, "simd_float_bits", "avx2", arithmetic_ns),
        make_row(net, "simd_bitpacked", "avx2", circuit_ns)))


def test_nets_improve_times_only_where_they_are_faster_than_the_rule():
    assert nets_claim(1e6, 3e5).verdict is Verdict.HOLDS
    assert nets_claim(1e6, 1e5).verdict is Verdict.HOLDS
    assert nets_claim(1e6, 5e4).verdict is Verdict.PARTLY
    assert nets_claim(5e4, 5e4).verdict is Verdict.FAILS


def test_integers_gain_time_but_lose_answers():
    net = "net_two_layer_linear"
    rows = rows_with(make_row(net, "simd_float_bits", "avx2", 2e5),
                     make_row(net, "simd_fixed_point", "avx2", 1e5))
    assert of_times.integers_do_not_pay(rows, GOLDEN["quantisation"]).verdict is Verdict.PARTLY


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
    equal = rows_with(*(make_row(row.operation, technique, "baseline", 1e7)
                        for row in PAPER for technique in ("reference", "bitpacked")))
    assert of_times.order_of_table_two(equal).verdict is Verdict.FAILS


def test_table_two_gives_the_papers_ratio_to_the_same_times():
    for row in table_two(paper_rows(False)).rows:
        assert row[3] == row[5] == row[7]


def test_claims_without_data_are_open():
    claims = judge(rows_with(make_row("holes", "simd_runs", "avx2", 1e5)), {})
    assert len(claims) == 10 and all(claim.verdict is Verdict.OPEN for claim in claims)


def test_claims_name_their_run(tmp_path, capsys):
    rows = [replace(make_row("holes", "simd_runs", "avx2", 1e5), border="")]
    directory = write_run(tmp_path / "run", rows)
    built = build(directory, capsys)
    assert MACHINE["commit"] in built.text("claims.md") and DIRECTORY.is_dir()
