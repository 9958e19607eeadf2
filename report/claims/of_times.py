"""Claims that times decide: Table 2, nets, integers, bytes."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from report.claims.claim import Claim, Verdict, judged, open_claim
from report.formatting import counted, interval, three_digits
from report.measure.estimates import Estimate
from report.measure.benchmarks import Json
from report.measure.timings import Row, row_ratio
from report.page.operations import ARITHMETIC, PRINTED_RULE, Rows, fastest
from report.page.table_two import PAPER, PaperRow

COMMAND = "./study"
NETS = ("net_two_layer_sigmoid", "net_two_layer_linear", "net_single_layer_cluster")
INTEGER_NET = "net_two_layer_linear"
INTEGERS, FLOATS = ("simd_fixed_point",), ("simd_float_bits",)
CIRCUIT = ("simd_bitpacked", "simd_bitpacked_row")
"""Techniques that evaluate the gates to which a net was compiled."""

SCALAR_BYTES, SCALAR_BITS = ("lut", "lut_sliding"), ("bitpacked",)
BYTES = (*SCALAR_BYTES, "autovec", "simd_bytes")
BITS = (*SCALAR_BITS, "simd_bitpacked", "simd_bitpacked_row", "simd_bitpacked_tiles")
EQUAL = 1.05
"""Of two times, one of which is at most so many times the other: nets and rules that are compiled to the same circuit
differ by how their code lies in memory."""


def time_ratio(above: Row | None, below: Row | None) -> Estimate | None:
    """One time over another; None where a row is missing."""
    return None if above is None or below is None else row_ratio(above, below)


def _text(ratio: Estimate) -> str:
    """Such as 1.17 (1.14\N{EN DASH}1.30)."""
    return f"{three_digits(ratio.value)} ({interval(ratio.low, ratio.high)})"


def order_of_table_two(rows: Rows) -> Claim:
    """Table 2: which method is faster than which."""
    claim = "The order of the methods in Table 2"
    known = [(paper, reference, best) for paper in PAPER
             if (reference := rows.reference(paper.operation))
             and (best := fastest(rows.own(paper.operation)))]
    if len(known) < 2:
        return open_claim(claim, COMMAND)
    scalar = _pairs_in_order([(paper, reference) for paper, reference, _ in known])
    now = _pairs_in_order([(paper, best) for paper, _, best in known])
    figure = (f"of {len(scalar)} pairs of methods {sum(scalar)} keep the paper's order when references are "
              f"timed, and {sum(now)} when the fastest variants are")
    return judged(claim, [*scalar, *now], figure, "The order is still the paper's.",
                  "Which method is faster depends on what its form lets the processor do at once.", COMMAND)


def nets_do_not_pay(rows: Rows) -> Claim:
    """Section 4: "neural networks do not improve computation time"."""
    claim = "Neural networks do not improve computation time"
    rule = fastest(rows.own(PRINTED_RULE))
    honest = time_ratio(_fastest(rows, NETS, ARITHMETIC), rule)
    compiled = time_ratio(_fastest(rows, NETS, CIRCUIT), rule)
    if not (honest and compiled):
        return open_claim(claim, COMMAND)
    slower, free = honest.low > 1, compiled.value <= EQUAL
    verdict = Verdict.of([EQUAL * honest.high >= 1, EQUAL * compiled.high >= 1])
    figure = (f"time of the fastest net over that of the fastest rule: {_text(honest)} with its "
              f"arithmetic, {_text(compiled)} compiled to a circuit")
    return Claim(claim, verdict, figure, _why_nets(slower, free), COMMAND)


def _why_nets(slower: bool, free: bool) -> str:
    if slower and free:
        return ("Their arithmetic is slower than the rule; but a trained net is a table, and as a "
                "circuit it costs what the rule costs.")
    return ("Both as arithmetic and as circuits they are slower." if slower else
            "Even their arithmetic is not slower than the rule any more.")


def integers_do_not_pay(rows: Rows, data: Json | None) -> Claim:
    """Section 4: integers are no faster and recognise less."""
    claim = "Integer approximation does not reduce processing time, but reduces the recognition rate"
    ratio = time_ratio(_fastest(rows, (INTEGER_NET,), FLOATS),
                       _fastest(rows, (INTEGER_NET,), INTEGERS))
    if data is None or ratio is None:
        return open_claim(claim, f"{COMMAND}; thinbench-study experiment quantisation")
    right = [(row["fractional_bits"], min(row["right_sigmoid"], row["right_linear"]))
             for row in data["rows"]]
    whole = min(count for bits, count in right if bits == 0)
    wrong = max((bits for bits, count in right if count < data["descriptors"]), default=-1)
    enough = min((bits for bits, _ in right if bits > wrong), default=None)
    verdict = Verdict.of([ratio.low <= 1, whole < data["descriptors"]])
    figure = (f"8-bit integers are {_text(ratio)} times as fast as floats; integers are right on "
              f"{whole} of {data['descriptors']} at worst, " +
              ("and no fixed point is right on all" if enough is None else
               f"fixed point on all from {counted(enough, 'fractional bit')} on"))
    why = "More pixels fit a register as bytes." if ratio.low > 1 else "Integers gain no time."
    why += " Answers are lost." if enough is None else " Fractional bits keep every answer."
    return Claim(claim, verdict, figure, why, f"{COMMAND}; {data['command']}")


def bytes_are_faster(rows: Rows) -> Claim:
    """Section 2: "coded at byte (not bit) level ... yields faster processing"."""
    claim = "One byte per pixel yields faster processing than one bit"
    scalar = time_ratio(_fastest(rows, (PRINTED_RULE,), SCALAR_BYTES),
                        _fastest(rows, (PRINTED_RULE,), SCALAR_BITS))
    best = time_ratio(_fastest(rows, (PRINTED_RULE,), BYTES),
                      _fastest(rows, (PRINTED_RULE,), BITS))
    if not (scalar and best):
        return open_claim(claim, COMMAND)
    figure = (f"time with bytes over time with bits, packing and unpacking included: {_text(scalar)} "
              f"by scalar variants, {_text(best)} with the widest instructions")
    return judged(claim, [scalar.high < 1, best.high < 1], figure, "Packing costs more than it gains.",
                  "A word of packed pixels takes as many instructions as a single pixel would, and "
                  "packing costs little beside it.", COMMAND)


def _fastest(rows: Rows, cases: Iterable[str], techniques: Iterable[str]) -> Row | None:
    return fastest(row for case in cases for row in rows.own(case) if row.technique in techniques)


def _pairs_in_order(rows: list[tuple[PaperRow, Row]]) -> list[bool]:
    """For each pair of methods whether the faster one of the paper is the faster one here, by more
    than their intervals and than what counts as equal."""
    in_order = sorted(rows, key=lambda one: one[0].seconds)
    return [EQUAL * fast.high_ns < slow.time_ns for (_, fast), (_, slow) in combinations(in_order, 2)]
