"""Claims that experiments decide: counts, recognition, edges, connectivity."""

from __future__ import annotations

from report.claims.claim import Claim, Verdict, open_claim
from report.cluster_runs import ClusterRuns
from report.experiments import Counted, EdgeQuality, EdgeRates, HiddenNeurons, OperationCounts
from report.experiments import Quantisation
from report.quality import Quality

PAPER_NETS = 12
PAPER_HIDDEN = 8
PRINTED_RULE = "thin_naccache_shinghal"
RELIABLE = 0.95
"""Precision and recall from which edges are called reliable here."""


def operation_counts(data: OperationCounts | None) -> Claim:
    """Section 4's counts a pixel."""
    claim = ("A pixel costs 40 logical and 3 arithmetic operations by the rule, more than 150 "
             "arithmetic ones by the two-layer net and 39 by the cluster")
    if data is None:
        return open_claim(claim, "thinbench experiment operation-counts")
    rule = _methods(data, "Naccache-Shinghal, four")
    nets, cluster = _methods(data, "Two-layer net"), _methods(data, "Cluster")
    parts = [bool(rule) and all((m.sums["logical"], m.arithmetic) == (40, 3) for m in rule),
             bool(nets) and all(m.arithmetic > 150 for m in nets),
             bool(cluster) and all(m.arithmetic == 39 for m in cluster)]
    figure = "; ".join(f"{m.method}: {m.sums['logical']} logical, {m.arithmetic} arithmetic"
                       for m in rule + nets + cluster)
    verdict = Verdict.of(parts)
    why = ("The references were run on numbers that count, and give the paper's counts."
           if verdict is Verdict.HOLDS else
           "The references were run on numbers that count, and give other counts.")
    return Claim(claim, verdict, figure, why, data.command)


def linear_threshold(data: Quantisation | None) -> Claim:
    """Section 3.2: equation (2) in place of (1)."""
    claim = "With the linear threshold (2) in place of the sigmoid (1) recognition stays at 100 %"
    if data is None or not data.as_published:
        return open_claim(claim, "thinbench experiment quantisation")
    right = data.as_published
    figure = ", ".join(f"{name}: {count} of {data.descriptors}" for name, count in right.items())
    verdict = Verdict.of([all(count == data.descriptors for count in right.values())])
    why = ("Table 1 as published gives the rule's answer to every neighbourhood with both functions."
           if verdict is Verdict.HOLDS else
           "Table 1 as published gives a wrong answer to some neighbourhood.")
    return Claim(claim, verdict, figure, why, data.command)


def twelve_nets(data: ClusterRuns | None) -> Claim:
    """Section 3.3: the size of the cluster."""
    claim = f"A cluster of {PAPER_NETS} single-layer nets represents the rule"
    if data is None:
        return open_claim(claim, "thinbench experiment cluster-runs")
    needed = len(data.rows)
    verdict = Verdict.of([needed <= PAPER_NETS])
    exact = "exactly as many" if needed == PAPER_NETS else "fewer"
    why = (f"The fewest that runs of descriptors can be cut into is {exact}."
           if verdict is Verdict.HOLDS else "No cut into runs of descriptors has so few.")
    return Claim(claim, verdict, f"{needed} nets are needed and enough", why, data.command)


def eight_hidden_neurons(data: HiddenNeurons | None) -> Claim:
    """Section 3.2: "a number of eight hidden neurones is optimal"."""
    claim = f"{PAPER_HIDDEN} hidden neurons are optimal"
    if data is None:
        return open_claim(claim, "thinbench experiment hidden-neurons")
    reached = [row for row in data.rows if row.seeds_with_all_right > 0]
    sure = [row for row in reached if row.seeds_with_all_right == data.seeds]
    fewest = reached[0].hidden if reached else None
    at_paper = next((row for row in data.rows if row.hidden == PAPER_HIDDEN), None)
    verdict = Verdict.of([fewest == PAPER_HIDDEN])
    parts = [f"fewest that learnt all {data.descriptors}: {fewest}" if fewest else
             f"none learnt all {data.descriptors}"]
    parts += [f"{PAPER_HIDDEN}: {at_paper.seeds_with_all_right} of {data.seeds} seeds"] \
        if at_paper else []
    parts += [f"every seed from {sure[0].hidden} on"] if sure else []
    why = ("No smaller net learnt the rule." if verdict is Verdict.HOLDS else
           "Smaller nets can represent the rule; more neurons only make training succeed more often.")
    return Claim(claim, verdict, "; ".join(parts), why, data.command)


def reliable_edges(data: EdgeQuality | None) -> Claim:
    """Section 2.1: "reliable edge detection with strong rejection of false edges"."""
    claim = "Edge detection is reliable and rejects false edges strongly"
    if data is None:
        return open_claim(claim, "thinbench experiment edge-quality")
    sigmas = sorted({row.sigma for row in data.rows})
    good = [s for s in sigmas if all(_is_reliable(r) for r in data.rows if r.sigma == s)]
    verdict = Verdict.of([s in good for s in sigmas])
    worst = min(data.rows, key=lambda row: (row.precision, row.operation))
    upto = f"up to sigma {max(good)}" if good else "at no noise"
    figure = (f"precision and recall of every operator are at least {RELIABLE:.0%} {upto}; at sigma "
              f"{worst.sigma} precision falls to {worst.precision:.0%} ({worst.operation}; "
              f"{worst.precision_without_p2:.0%} without P2)")
    why = ("All operators stand all noise that was tried." if verdict is Verdict.HOLDS else
           "With fixed thresholds noise exceeds P1, and P2 only rejects what is dark enough.")
    return Claim(claim, verdict, figure, why, data.command)


def connected_skeleton(data: Quality | None) -> Claim:
    """Section 3.1: that the procedure as printed makes a skeleton."""
    claim = "The printed procedure keeps a skeleton connected"
    rows = [row for row in data.rows if row.case.name == PRINTED_RULE] if data else []
    if data is None or not rows:
        return open_claim(claim, "thinbench experiment quality")
    verdict = Verdict.of([row.objects[0] == row.objects[1] for row in rows])
    figure = "; ".join(f"{row.input}: {row.objects[0]} objects before, {row.objects[1]} after"
                       for row in rows)
    why = ("No object vanished or fell apart." if verdict is Verdict.HOLDS else
           "Both sides of a line are removed at once, so that thin parts break or vanish.")
    return Claim(claim, verdict, figure, why, data.command)


def _methods(data: OperationCounts, beginning: str) -> list[Counted]:
    return [method for method in data.methods if method.method.startswith(beginning)]


def _is_reliable(row: EdgeRates) -> bool:
    return min(row.precision, row.recall) >= RELIABLE
