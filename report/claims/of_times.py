"""Claims that times decide: Table 2, nets, integers, bytes."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from report.claims.claim import Claim, Verdict, open_claim
from report.experiments import PaperRow, Quantisation, TableTwo
from report.findings import fastest
from report.intervals import Interval, time_ratio
from report.model import END_TO_END, SCENE, Row, Study
from report.table_two import ARITHMETIC, CIRCUIT, RULE

COMMAND = "./study"
NETS = ("net_two_layer_sigmoid", "net_two_layer_linear", "net_single_layer_cluster")
INTEGER_NET = "net_two_layer_linear"
INTEGERS = ("simd_fixed_point",)
FLOATS = ("simd_float_bits",)
BYTES = ("lut", "lut_sliding", "autovec", "simd_bytes")
BITS = ("bitpacked", "simd_bitpacked", "simd_bitpacked_row")
NO_COST = 1.05
"""A net that takes at most so many times the rule's time costs nothing."""


def order_of_table_two(study: Study, paper: TableTwo | None) -> Claim:
    """Table 2: who is faster than whom."""
    claim = "The order of the methods in Table 2"
    rows = [(row, _reference(study, row.operation), _best(study, row.operation))
            for row in (paper.rows if paper else ())]
    known = [(row, reference, best) for row, reference, best in rows if reference and best]
    if len(known) < 2:
        return open_claim(claim, COMMAND)
    scalar = _pairs_in_order([(row, reference) for row, reference, _ in known])
    now = _pairs_in_order([(row, best) for row, _, best in known])
    verdict = Verdict.of([*scalar, *now])
    figure = (f"of {len(scalar)} pairs of methods {sum(scalar)} come in the paper's order by their "
              f"references and {sum(now)} by their fastest variants")
    why = ("The order is still the paper's." if verdict is Verdict.HOLDS else
           "Which method is faster depends on what its form lets the processor do at once.")
    return Claim(claim, verdict, figure, why, COMMAND)


def nets_do_not_pay(study: Study) -> Claim:
    """Section 4: "neural networks do not improve computation time"."""
    claim = "Neural networks do not improve computation time"
    rule = _best(study, RULE)
    honest = _ratio(fastest(_rows(study, NETS, ARITHMETIC)), rule)
    compiled = _ratio(fastest(_rows(study, NETS, CIRCUIT)), rule)
    if not (honest and compiled):
        return open_claim(claim, COMMAND)
    slower, free = honest.low > 1, compiled.ratio <= NO_COST
    verdict = Verdict.of([slower, not free]) if slower else Verdict.FAILS
    figure = (f"time of the fastest net over that of the fastest rule: {honest.text} by honest "
              f"arithmetic, {compiled.text} compiled to a circuit")
    why = _why_nets(slower, free)
    return Claim(claim, verdict, figure, why, COMMAND)


def integers_do_not_pay(study: Study, data: Quantisation | None) -> Claim:
    """Section 4: integers are no faster and recognise less."""
    claim = "Integer approximation does not reduce processing time, but reduces the recognition rate"
    ratio = _ratio(fastest(_rows(study, (INTEGER_NET,), FLOATS)),
                   fastest(_rows(study, (INTEGER_NET,), INTEGERS)))
    if data is None or ratio is None:
        return open_claim(claim, f"{COMMAND}; thinbench experiment quantisation")
    whole = [row for row in data.rows if row.fractional_bits == 0]
    lost = any(min(row.right.values()) < data.descriptors for row in whole)
    enough = [row.fractional_bits for row in data.rows
              if min(row.right.values()) == data.descriptors]
    verdict = Verdict.of([ratio.low <= 1, lost and not enough])
    figure = (f"8-bit integers are {ratio.text} times as fast as floats; whole numbers are right on "
              f"{min(min(row.right.values()) for row in whole)} of {data.descriptors} at worst, "
              + (f"fixed point on all from {min(enough)} fractional bits on" if enough else
                 "and no fixed point is right on all"))
    why = ("More pixels fit a register as bytes." if ratio.low > 1 else
           "Integers gain no time.")
    why += (" A single bit behind the point keeps every answer." if enough and min(enough) == 1 else
            " Bits behind the point keep every answer." if enough else " Answers are lost.")
    return Claim(claim, verdict, figure, why, f"{COMMAND}; {data.command}")


def bytes_are_faster(study: Study) -> Claim:
    """Section 2: "coded at byte (not bit) level ... yields faster processing"."""
    claim = "One byte a pixel yields faster processing than one bit"
    scalar = _ratio(_scalar(study, BYTES), _scalar(study, BITS))
    best = _ratio(fastest(_rows(study, (RULE,), BYTES)), fastest(_rows(study, (RULE,), BITS)))
    if not (scalar and best):
        return open_claim(claim, COMMAND)
    verdict = Verdict.of([scalar.high < 1, best.high < 1])
    figure = (f"time with bytes over time with bits, packing and unpacking included: {scalar.text} "
              f"in plain C++, {best.text} with the widest instructions")
    why = ("Packing costs more than it gains." if verdict is Verdict.HOLDS else
           "A word of packed pixels is thinned by the instructions that one pixel would take, and "
           "packing costs little beside it.")
    return Claim(claim, verdict, figure, why, COMMAND)


def _why_nets(slower: bool, free: bool) -> str:
    if slower and free:
        return ("Their arithmetic is slower than the rule; but a trained net is a table, and as a "
                "circuit it costs what the rule costs.")
    return ("Both as arithmetic and as circuits they are slower." if slower else
            "Even their arithmetic is not slower than the rule any more.")


def _rows(study: Study, cases: Iterable[str], techniques: Iterable[str]) -> list[Row]:
    """Variants on the scene, one thread, bytes to bytes."""
    return [row for case in cases for row in study.select(case, SCENE)
            if row.name.technique in techniques and row.name.threads == 1
            and row.name.scope == END_TO_END and not row.is_peer]


def _scalar(study: Study, techniques: Iterable[str]) -> Row | None:
    return fastest(row for row in _rows(study, (RULE,), techniques)
                   if row.name.isa == "baseline" and row.name.technique.split("_")[0] in
                   ("lut", "bitpacked"))


def _best(study: Study, case: str) -> Row | None:
    return fastest(row for row in study.select(case, SCENE)
                   if row.name.threads == 1 and row.name.scope == END_TO_END
                   and not row.name.is_reference and not row.is_peer)


def _reference(study: Study, case: str) -> Row | None:
    return next((row for row in study.select(case, SCENE) if row.name.is_reference), None)


def _ratio(above: Row | None, below: Row | None) -> Interval | None:
    return time_ratio(above, below) if above and below else None


def _pairs_in_order(rows: list[tuple[PaperRow, Row]]) -> list[bool]:
    """For each pair of methods whether the faster one of the paper is the faster one here."""
    return [(a.seconds < b.seconds) == (here.median_ns < there.median_ns)
            for (a, here), (b, there) in combinations(rows, 2)]
