"""Table 2 of the paper beside the times of a run."""

from __future__ import annotations

from dataclasses import dataclass

from report.formatting import NOTHING, duration, three_digits, variant
from report.measure.timings import Row
from report.page.operations import PRINTED_RULE, Rows, fastest
from report.page.tables import Table


@dataclass(frozen=True)
class PaperRow:
    """A method of the paper, the operation that is the same here, and the paper's seconds."""

    method: str
    operation: str
    seconds: float


PAPER = (PaperRow("Hole detection and localisation", "holes", 0.67),
         PaperRow("Original skeleton", "midpoint_scan", 0.31),
         PaperRow("Naccache-Shinghal", PRINTED_RULE, 0.73),
         PaperRow("Two-layer net, sigmoid", "net_two_layer_sigmoid", 5.11),
         PaperRow("Two-layer net, linear threshold", "net_two_layer_linear", 3.54),
         PaperRow("Cluster of single-layer nets", "net_single_layer_cluster", 0.89))
PAPER_MACHINE = "Pentium II MMX of 350 MHz"
PAPER_RULE = next(row for row in PAPER if row.operation == PRINTED_RULE)

HEADER = ("Method", "Best variant here", "Paper", "To its rule", "Plain C++ here", "To the rule",
          "Best here", "To the rule")


def table_two(rows: Rows) -> Table:
    """Then and now; ratios are to the paper's thinning rule in the same column."""
    rule = rows.reference(PRINTED_RULE), fastest(rows.own(PRINTED_RULE))
    cells = []
    for paper in PAPER:
        reference, best = rows.reference(paper.operation), fastest(rows.own(paper.operation))
        cells.append((paper.method, variant(best) if best else NOTHING, f"{paper.seconds:.2f} s",
                      three_digits(paper.seconds / PAPER_RULE.seconds),
                      *_time_and_ratio(reference, rule[0]), *_time_and_ratio(best, rule[1])))
    return Table("Table 2 then and now",
                 f"The paper's times are of a {PAPER_MACHINE} and an image of 510 × 412 pixels; "
                 f"those here of {rows.input}, end to end, one thread.",
                 HEADER, tuple(cells), "./study", first_number=2)


def _time_and_ratio(row: Row | None, rule: Row | None) -> tuple[str, str]:
    return (duration(row.time_ns) if row else NOTHING,
            three_digits(row.time_ns / rule.time_ns) if row and rule else NOTHING)
