"""Claims that experiments decide: counts, recognition, edges, connectivity."""

from __future__ import annotations

from itertools import takewhile

from report.claims.claim import Claim, judged, open_claim
from report.measure.benchmarks import Json
from report.page.operations import PRINTED_RULE

PAPER_NETS = 12
PAPER_HIDDEN = 8
RELIABLE = 0.95
"""Precision and recall from which edges are called reliable here."""


def operation_counts(data: Json | None) -> Claim:
    """Section 4's counts per pixel."""
    claim = ("A pixel costs 40 logical and 3 arithmetic operations by the rule, more than 150 "
             "arithmetic ones by the two-layer net and 39 by the cluster")
    if data is None:
        return open_claim(claim, "thinbench-study experiment operation-counts")
    rule, nets, cluster = (_counts(data, beginning) for beginning in
                           ("Naccache-Shinghal, four", "Two-layer net", "Cluster"))
    parts = [bool(rule) and all((logical, arithmetic) == (40, 3) for _, logical, arithmetic in rule),
             bool(nets) and all(arithmetic > 150 for _, _, arithmetic in nets),
             bool(cluster) and all(arithmetic == 39 for _, _, arithmetic in cluster)]
    figure = "; ".join(f"{method}: {logical} logical, {arithmetic} arithmetic"
                       for method, logical, arithmetic in rule + nets + cluster)
    counted = "The references were run on numbers that count, and give"
    return judged(claim, parts, figure, f"{counted} the paper's counts.", f"{counted} other counts.", data["command"])


def linear_threshold(data: Json | None) -> Claim:
    """Section 3.2: equation (2) in place of (1)."""
    claim = "With the linear threshold (2) in place of the sigmoid (1) recognition stays at 100 %"
    if data is None:
        return open_claim(claim, "thinbench-study experiment quantisation")
    total, found = data["descriptors"], data["as_published"]
    right = {"sigmoid": found["right_sigmoid"], "linear threshold": found["right_linear"]}
    figure = ", ".join(f"{name}: {count} of {total}" for name, count in right.items())
    return judged(claim, [all(count == total for count in right.values())], figure,
                  "Table 1 as published gives the rule's answer to every neighbourhood with both functions.",
                  "Table 1 as published gives a wrong answer to some neighbourhood.", data["command"])


def twelve_nets(data: Json | None) -> Claim:
    """Section 3.3: the size of the cluster."""
    claim = f"A cluster of {PAPER_NETS} single-layer nets represents the rule"
    if data is None:
        return open_claim(claim, "thinbench-study experiment cluster-runs")
    needed = len(data["rows"])
    return judged(claim, [needed <= PAPER_NETS], f"{needed} nets are needed and enough",
                  "Descriptors cannot be cut into fewer runs.", "Descriptors cannot be cut into so few runs.",
                  data["command"])


def eight_hidden_neurons(data: Json | None) -> Claim:
    """Section 3.2: "a number of eight hidden neurones is optimal"."""
    claim = f"{PAPER_HIDDEN} hidden neurons are optimal"
    if data is None:
        return open_claim(claim, "thinbench-study experiment hidden-neurons")
    learnt = {row["hidden"]: row["seeds_with_all_right"] for row in data["rows"]}
    fewest = min((hidden for hidden, seeds in learnt.items() if seeds), default=None)
    sure = min((hidden for hidden, seeds in learnt.items() if seeds == data["seeds"]), default=None)
    parts = [f"the smallest net that learnt all {data['descriptors']} has {fewest} neurons" if fewest else
             f"none learnt all {data['descriptors']}"]
    parts += [f"with {PAPER_HIDDEN}, {learnt[PAPER_HIDDEN]} of {data['seeds']} random starts succeed"] \
        if PAPER_HIDDEN in learnt else []
    parts += [f"with {sure}, all do"] if sure else []
    return judged(claim, [fewest == PAPER_HIDDEN], "; ".join(parts), "No smaller net learnt the rule.",
                  "Smaller nets can represent the rule; more neurons only make training succeed more often.",
                  data["command"])


def reliable_edges(data: Json | None) -> Claim:
    """Section 2.1: "reliable edge detection with strong rejection of false edges"."""
    claim = "Edge detection is reliable and rejects false edges strongly"
    if data is None:
        return open_claim(claim, "thinbench-study experiment edge-quality")
    rows = data["rows"]
    sigmas = sorted({row["sigma"] for row in rows})
    good = list(takewhile(lambda sigma: all(_is_reliable(r) for r in rows if r["sigma"] == sigma), sigmas))
    worst = min(rows, key=lambda row: (row["precision"], row["operation"]))
    where = f"up to sigma {max(good)}" if good else "at no noise"
    figure = (f"precision and recall of every operator are at least {100 * RELIABLE:.0f} % {where}; at sigma "
              f"{worst['sigma']} precision falls to {100 * worst['precision']:.0f} % ({worst['operation']}; "
              f"{100 * worst['precision_without_p2']:.0f} % without P2)")
    return judged(claim, [sigma in good for sigma in sigmas], figure, "All operators stand all noise that was tried.",
                  "With fixed thresholds noise exceeds P1, and P2 only rejects what is dark enough.", data["command"])


def connected_skeleton(data: Json | None) -> Claim:
    """Section 3.1: that the procedure as published makes a skeleton."""
    claim = "The procedure as published keeps a skeleton connected"
    rows = [row for row in data["rows"] if row["operation"] == PRINTED_RULE] if data else []
    if data is None or not rows:
        return open_claim(claim, "thinbench-study experiment quality")
    figure = "; ".join(f"{row['input']}: {row['objects_before']} objects before, "
                       f"{row['objects_after']} after" for row in rows)
    return judged(claim, [row["objects_before"] == row["objects_after"] for row in rows], figure,
                  "There are as many objects as before.",
                  "Both sides of a line are removed at once, so that thin parts break or vanish.", data["command"])


def _counts(data: Json, beginning: str) -> list[tuple[str, int, int]]:
    """Methods with their logical and arithmetic operations."""
    return [(method["method"], method["sums"]["logical"],
             method["sums"]["arithmetic"] + method["activations"]["arithmetic"])
            for method in data["methods"] if method["method"].startswith(beginning)]


def _is_reliable(row: Json) -> bool:
    return bool(min(row["precision"], row["recall"]) >= RELIABLE)
