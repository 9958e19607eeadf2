"""All claims, in the order of the paper."""

from __future__ import annotations

from report.claims import of_experiments, of_times
from report.claims.claim import Claim
from report.experiments import Experiments
from report.model import Study


def judge(study: Study, experiments: Experiments) -> list[Claim]:
    """One verdict a claim; what the run has no data for is said to be open."""
    return [
        of_times.bytes_are_faster(study),
        of_experiments.reliable_edges(experiments.edge_quality),
        of_experiments.connected_skeleton(experiments.quality),
        of_experiments.eight_hidden_neurons(experiments.hidden_neurons),
        of_experiments.linear_threshold(experiments.quantisation),
        of_experiments.twelve_nets(experiments.cluster_runs),
        of_experiments.operation_counts(experiments.operation_counts),
        of_times.order_of_table_two(study, experiments.table_two),
        of_times.integers_do_not_pay(study, experiments.quantisation),
        of_times.nets_do_not_pay(study)]
