"""Verdicts follow the data: changed data changes them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import OPERATION, ROOT, Run, entries, jittered

from report.build import claims_text
from report.cases import Case
from report.claims import Verdict, judge
from report.claims import of_experiments as experiments
from report.claims import of_times as times
from report.cluster_runs import ClusterRuns, LearntRun
from report.experiments import (KINDS, Counted, EdgeQuality, EdgeRates, Experiments, FixedPoint,
                                HiddenNeurons, OperationCounts, PaperRow, Quantisation, TableTwo,
                                Trained)
from report.intervals import median_bounds
from report.loading import load_study
from report.quality import Quality, Skeleton

LINEAR = "net_two_layer_linear"


def counted(method: str, logical: int, arithmetic: int) -> Counted:
    none = dict.fromkeys(KINDS, 0)
    return Counted(method, "", none | {"logical": logical, "arithmetic": arithmetic}, none)


def counts(cluster: int) -> OperationCounts:
    methods = (counted("Naccache-Shinghal, four expressions", 40, 3),
               counted("Two-layer net, sigmoid", 0, 180), counted("Cluster of nets", 0, cluster))
    return OperationCounts("command", "pixel", methods, {}, {})


def test_operation_counts_hold_only_where_every_count_is_the_papers():
    assert experiments.operation_counts(counts(39)).verdict is Verdict.HOLDS
    assert experiments.operation_counts(counts(40)).verdict is Verdict.PARTLY
    assert "40 arithmetic" in experiments.operation_counts(counts(40)).figure


@pytest.mark.parametrize("right, verdict", [(256, Verdict.HOLDS), (255, Verdict.FAILS)])
def test_linear_threshold_must_keep_every_answer(right, verdict):
    data = Quantisation("command", 256, (), {"sigmoid": 256, "linear threshold": right})
    assert experiments.linear_threshold(data).verdict is verdict


@pytest.mark.parametrize("nets, verdict", [(11, Verdict.HOLDS), (12, Verdict.HOLDS),
                                           (13, Verdict.FAILS)])
def test_cluster_holds_while_twelve_nets_are_enough(nets, verdict):
    data = ClusterRuns("command", (LearntRun(0, 1, 1, 1),) * nets)
    assert experiments.twelve_nets(data).verdict is verdict


@pytest.mark.parametrize("fewest, verdict", [(4, Verdict.FAILS), (8, Verdict.HOLDS),
                                             (9, Verdict.FAILS), (99, Verdict.FAILS)])
def test_eight_neurons_are_optimal_only_where_fewer_never_learn(fewest, verdict):
    rows = tuple(Trained(h, 256, 250.0, 20 if h >= fewest else 0, 1.0) for h in range(2, 13))
    assert experiments.eight_hidden_neurons(
        HiddenNeurons("command", 256, 20, rows)).verdict is verdict


def edge_rates(sigma: int, precision: float) -> EdgeRates:
    given = {"operation": "edges_sobel", "sigma": sigma, "precision": precision, "recall": 1.0,
             "figure_of_merit": 1.0, "precision_without_p2": 0.5}
    extra = {name: 0.0 for name in EdgeRates.__dataclass_fields__ if name not in given}
    return EdgeRates(**given, **extra)


@pytest.mark.parametrize("at_16, verdict", [(0.96, Verdict.HOLDS), (0.5, Verdict.PARTLY)])
def test_edges_are_reliable_as_far_as_precision_reaches(at_16, verdict):
    data = EdgeQuality("command", 40, 128, 1, (edge_rates(0, 1.0), edge_rates(16, at_16)))
    claim = experiments.reliable_edges(data)
    assert claim.verdict is verdict
    assert ("up to sigma 16" in claim.figure) == (verdict is Verdict.HOLDS)


@pytest.mark.parametrize("after, verdict", [(22, Verdict.HOLDS), (23, Verdict.FAILS)])
def test_skeleton_is_connected_only_with_as_many_objects_as_before(after, verdict):
    row = Skeleton(Case(OPERATION), "scene", (22, after), (47, 47), 9, 0, 0, 0, 0.0, 0.0, 1.0, 31)
    claim = experiments.connected_skeleton(Quality("command", (row,)))
    assert claim.verdict is verdict and f"{after} after" in claim.figure


def with_rows(run: Run, times_ns: dict[str, float]):
    """The study of a run with these rows on the scene as well; names are operation/technique."""
    for name, ns in times_ns.items():
        full = f"{name}/baseline/1/end_to_end/scene"
        run.timings["benchmarks"] += entries(full, (510, 412), jittered(ns, full))
    return load_study(run.write())


def fixed_point(*right: int) -> Quantisation:
    rows = tuple(FixedPoint("rounded", bits, {"sigmoid": count, "linear threshold": count}, 20)
                 for bits, count in enumerate(right))
    return Quantisation("command", 256, rows, {})


@pytest.mark.parametrize("integers_ns, right, verdict", [
    (1e5, (251, 256), Verdict.FAILS), (9e5, (251, 256), Verdict.PARTLY),
    (1e5, (251, 255), Verdict.PARTLY), (9e5, (251, 255), Verdict.HOLDS)])
def test_integers_are_judged_by_time_and_by_recognition(run, integers_ns, right, verdict):
    study = with_rows(run, {f"{LINEAR}/reference": 4e7, f"{LINEAR}/simd_float_bits": 5e5,
                            f"{LINEAR}/simd_fixed_point": integers_ns})
    assert times.integers_do_not_pay(study, fixed_point(*right)).verdict is verdict


@pytest.mark.parametrize("arithmetic_gain, circuit_gain, verdict", [
    (0.1, 1.0, Verdict.PARTLY), (0.1, 0.5, Verdict.HOLDS), (2.0, 1.0, Verdict.FAILS)])
def test_nets_are_judged_as_arithmetic_and_as_circuits(run, arithmetic_gain, circuit_gain, verdict):
    rule_ns = 20.0 * 510 * 412 / 90
    study = with_rows(run, {f"{LINEAR}/reference": 4e7,
                            f"{LINEAR}/simd_float_bits": rule_ns / arithmetic_gain,
                            f"{LINEAR}/simd_bitpacked": rule_ns / circuit_gain})
    assert times.nets_do_not_pay(study).verdict is verdict


def test_bytes_lose_where_packed_rows_are_faster_and_win_where_they_are_slower(run):
    assert times.bytes_are_faster(load_study(run.write())).verdict is Verdict.FAILS
    for technique in ("bitpacked", "simd_bitpacked"):
        for entry in run.iterations(f"/{technique}/"):
            for clock in ("cpu_time", "real_time"):
                entry[clock] *= 1000
    assert times.bytes_are_faster(load_study(run.write())).verdict is Verdict.HOLDS


@pytest.mark.parametrize("net_ns, verdict", [(4e7, Verdict.PARTLY), (1e6, Verdict.FAILS)])
def test_order_of_table_two_is_that_of_references_and_fastest_variants(run, net_ns, verdict):
    paper = TableTwo("command", "image", "machine", (PaperRow("rule", OPERATION, 0.73, 1),
                                                     PaperRow("net", LINEAR, 3.54, 4.85)))
    study = with_rows(run, {f"{LINEAR}/reference": net_ns, f"{LINEAR}/lut": 10.0})
    assert times.order_of_table_two(study, paper).verdict is verdict


def test_claims_without_data_are_open_and_say_what_measures_them(run):
    study = load_study(run.write())
    open_claims = [claim for claim in judge(study, Experiments())
                   if claim.verdict is Verdict.OPEN]
    assert len(open_claims) == 9
    assert all(claim.command for claim in open_claims)


def test_bounds_of_a_median_are_second_and_eighth_of_nine():
    values = tuple(float(i) for i in range(1, 10))
    assert median_bounds(values) == (2, 8)
    assert median_bounds(values[:3]) == (1, 3)
    assert median_bounds((5.0,)) == (5, 5)


def test_committed_claims_are_what_the_committed_run_gives():
    text = (ROOT / "report" / "CLAIMS.md").read_text(encoding="utf-8")
    commit = re.search(r"Run of commit (\S+) on", text).group(1)
    runs = [path for path in Path(ROOT, "results").glob(f"*/*-{commit}") if path.is_dir()]
    assert len(runs) == 1, commit
    assert claims_text(runs[0]).rstrip() == text.rstrip()
