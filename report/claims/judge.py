"""All claims, in the order of the paper."""

from __future__ import annotations

from report.claims import of_experiments, of_times
from report.claims.claim import Claim
from report.page.experiments import Experiments
from report.page.operations import Rows


def judge(rows: Rows, experiments: Experiments) -> list[Claim]:
    """A verdict for each claim; one without data is open."""
    found = experiments.get
    return [
        of_times.bytes_are_faster(rows),
        of_experiments.reliable_edges(found("edge-quality")),
        of_experiments.connected_skeleton(found("quality")),
        of_experiments.eight_hidden_neurons(found("hidden-neurons")),
        of_experiments.linear_threshold(found("quantisation")),
        of_experiments.twelve_nets(found("cluster-runs")),
        of_experiments.operation_counts(found("operation-counts")),
        of_times.order_of_table_two(rows),
        of_times.integers_do_not_pay(rows, found("quantisation")),
        of_times.nets_do_not_pay(rows)]
