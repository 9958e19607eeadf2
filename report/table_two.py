"""The paper's Table 2 beside the times of this run, and the verdict on the nets."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from statistics import median

from report.experiment_layout import Column, Table, counted
from report.experiments import PaperRow, TableTwo
from report.findings import fastest
from report.formatting import NOTHING, duration, microseconds, three_digits
from report.model import END_TO_END, KERNEL, SCENE, Row, Study

TITLE = "Table 2 then and now"
RULE = "thin_naccache_shinghal"
ARITHMETIC = ("simd_float_bits", "simd_fixed_point", "autovec")
"""Techniques that evaluate a net's sums and activations for every pixel."""
CIRCUIT = ("simd_bitpacked", "simd_bitpacked_row")
"""Techniques that evaluate the gates to which a net was compiled."""
UNKNOWN_RULE = "net_two_layer_rounded"

HEADER = (
    Column("Method", False), Column("Paper, s"), Column("Paper, ratio"),
    Column("Reference here, µs"), Column("Ratio"), Column("Best variant here", False),
    Column("Best, µs"), Column("Ratio"))


@dataclass(frozen=True)
class Now:
    """What this run says about one row of the paper; None was not timed."""

    paper: PaperRow
    reference: Row | None
    best: Row | None

    @property
    def is_net(self) -> bool:
        """True for a net, which the paper compares to the rule."""
        return self.paper.operation.startswith("net_")


def make_table_two(study: Study, paper: TableTwo) -> Table:
    """Then and now: scalar code against scalar code, best variant against best variant."""
    rows = [_now(study, row) for row in paper.rows]
    rule = _now(study, PaperRow("", RULE, 1, 1))
    return Table(TITLE, _sentence(paper, rows, rule), HEADER,
                 tuple(_cells(row, rule) for row in rows), paper.command,
                 verdict=_verdict(study, rows, rule))


def _now(study: Study, row: PaperRow) -> Now:
    timed = _one_thread(study, row.operation, END_TO_END)
    return Now(row, next((r for r in timed if r.name.is_reference), None),
               fastest(r for r in timed if not r.name.is_reference and not r.is_peer))


def _one_thread(study: Study, case: str, scope: str) -> list[Row]:
    return [row for row in study.select(case, SCENE)
            if row.name.threads == 1 and row.name.scope == scope]


def _cells(row: Now, rule: Now) -> tuple[str, ...]:
    return (row.paper.method, f"{row.paper.seconds:.2f}", three_digits(row.paper.ratio),
            _time(row.reference), _ratio(row.reference, rule.reference),
            row.best.name.variant_label if row.best else NOTHING,
            _time(row.best), _ratio(row.best, rule.best))


def _time(row: Row | None) -> str:
    if row is None:
        return NOTHING
    return microseconds(row.median_ns) + (" (noisy)" if row.is_noisy else "")


def _ratio(row: Row | None, rule: Row | None) -> str:
    return three_digits(row.median_ns / rule.median_ns) if row and rule else NOTHING


def _sentence(paper: TableTwo, rows: list[Now], rule: Now) -> str:
    """How much longer the nets take than the rule: in the paper, scalar here, best here."""
    nets = [row for row in rows if row.is_net]
    then = _span(row.paper.ratio for row in nets)
    scalar = _span(_ratios((row.reference, rule.reference) for row in nets))
    best = _span(_ratios((row.best, rule.best) for row in nets))
    if not (then and scalar):
        return f"The paper timed {len(rows)} methods on a {paper.machine}; no net was timed here."
    now = f", and by the fastest variant of each {best} times" if best else ""
    return (f"On a {paper.machine} and a picture of {paper.image} pixels the nets took {then} "
            f"times as long as Naccache-Shinghal; here, on {SCENE}, one thread, end to end, their "
            f"scalar references take {scalar} times as long{now}.")


def _ratios(pairs: Iterable[tuple[Row | None, Row | None]]) -> Iterator[float]:
    return (row.median_ns / rule.median_ns for row, rule in pairs if row and rule)


def _span(values: Iterable[float]) -> str:
    """The range of some factors, or nothing if there are none."""
    ordered = sorted(values)
    ends = [three_digits(value) for value in ordered[:1] + ordered[-1:]]
    return " to ".join(dict.fromkeys(ends))


def _verdict(study: Study, rows: list[Now], rule: Now) -> str:
    nets = [row.paper.operation for row in rows if row.is_net]
    parts = (_arithmetic_verdict(study, nets, rule.best), _circuit_verdict(study, nets))
    return " ".join(part for part in parts if part)


def _arithmetic_verdict(study: Study, nets: list[str], rule: Row | None) -> str:
    """Whether the fastest net by honest arithmetic is slower than the rule at its fastest."""
    net = fastest(row for name in nets for row in _one_thread(study, name, END_TO_END)
                  if row.name.technique in ARITHMETIC)
    if net is None or rule is None:
        return ""
    factor = net.median_ns / rule.median_ns
    verdict = (f"is still slower than the rule: {three_digits(factor)} times its time"
               if factor > 1 else
               f"is no longer slower than the rule: {three_digits(1 / factor)} times as fast")
    return (f"A net evaluated by honest arithmetic {verdict} ({net.name.case.name}, "
            f"{net.name.variant_label}, {duration(net.median_ns)}; the rule, "
            f"{rule.name.variant_label}, {duration(rule.median_ns)}; end to end, one thread).")


def _circuit_pairs(study: Study, nets: list[str]) -> list[tuple[Row, Row]]:
    """Nets compiled to circuits and the rule in the same technique and instruction set."""
    rules = {row.name.variant: row for row in _one_thread(study, RULE, KERNEL)}
    return [(row, rules[row.name.variant])
            for name in nets for row in _one_thread(study, name, KERNEL)
            if row.name.technique in CIRCUIT and row.name.variant in rules]


def _circuit_verdict(study: Study, nets: list[str]) -> str:
    """What nets cost that learned the rule, and what one costs whose table nobody minimised."""
    pairs = _circuit_pairs(study, nets)
    if not pairs:
        return ""
    ratios = list(_ratios(pairs))
    noisy = sum(net.is_noisy or rule.is_noisy for net, rule in pairs)
    general = _span(_ratios(_circuit_pairs(study, [UNKNOWN_RULE])))
    other = (f" A net that learned no known rule ({UNKNOWN_RULE}) runs as a decision diagram and "
             f"takes {general} times the rule's time." if general else "")
    return (f"A net that learned the rule, compiled to its circuit, takes {_span(ratios)} times the "
            f"rule's time in the same technique and instruction set, {three_digits(median(ratios))} "
            f"times in the middle (ratio of medians over {counted(len(pairs), 'pair')}, {noisy} of "
            f"them with a noisy row; kernel, one thread).{other}")
