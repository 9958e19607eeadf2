"""The tables of the first screen, for the README and as LaTeX: headline, ladder and nets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from report.experiment_layout import Column, columns
from report.findings import fastest
from report.formatting import microseconds, speedup_text, three_digits, times
from report.intervals import time_ratio
from report.model import END_TO_END, KERNEL, SCENE, Row, Study
from report.table_two import ARITHMETIC, CIRCUIT, RULE


@dataclass(frozen=True)
class ShortTable:
    """A table without words round it; its cells may hold `code`."""

    header: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Headline:
    """A case worth a line on the first screen, and the peer that people know, of equal output."""

    case: str
    words: str
    peer: str = ""
    peer_words: str = ""


HEADLINES = (
    Headline(RULE, f"the paper's thinning, `{RULE}`"),
    Headline("thin_zhang_suen:keep", "`thin_zhang_suen`, border kept", "opencv", "OpenCV's"),
    Headline("thin_guo_hall:keep", "`thin_guo_hall`, border kept", "opencv", "OpenCV's"),
    Headline("thin_spta_directional", "`thin_spta_directional`"),
    Headline("skeleton_scan", "`skeleton_scan`, the paper's other method"),
    Headline("net_two_layer_linear", "thinning by the two-layer net, as a circuit"),
    Headline("edges_sobel", "`edges_sobel`, both thresholds", "opencv", "OpenCV's"),
    Headline("holes", "`holes`: areas, centres, boxes"),
    Headline("localise_objects", "`localise_objects`: grey picture to centres"))

NETS = (("net_two_layer_sigmoid", "two layers, sigmoid"),
        ("net_two_layer_linear", "two layers, linear threshold"),
        ("net_single_layer_cluster", "cluster of single layers"))


def _headline_table(study: Study) -> ShortTable:
    lines = []
    for headline in HEADLINES:
        best = fastest(row for row in _variants(study, headline.case, END_TO_END)
                       if row.name.technique not in ARITHMETIC)
        if best:
            lines.append((headline.words, _microseconds(best), _variant(best),
                          _against(study, headline, best)))
    return ShortTable((Column("operation", False), Column("µs"), Column("technique", False),
                       Column("against", False)), tuple(lines))


def _against(study: Study, headline: Headline, best: Row) -> str:
    own = f"{speedup_text(best)} its plain reference"
    peer = next((row for row in study.select(headline.case, SCENE)
                 if row.name.technique == headline.peer and row.name.scope == END_TO_END
                 and headline.peer in study.equal_peers), None)
    if peer is None:
        return own
    ratio = time_ratio(peer, best)
    bounds = f"{three_digits(ratio.low)} to {three_digits(ratio.high)}"
    return f"{times(ratio.ratio)} ({bounds}) {headline.peer_words}, {own}"


def _ladder_table(study: Study) -> ShortTable:
    lines = []
    kernels = {row.name.variant: row for row in _variants(study, RULE, KERNEL)}
    for row in study.select(RULE, SCENE):
        if row.name.scope != END_TO_END or row.name.threads > 1 or row.is_peer:
            continue
        kernel = kernels.get(row.name.variant)
        lines.append((row.name.technique, row.name.isa,
                      _microseconds(kernel) if kernel else "",
                      speedup_text(kernel) if kernel else "",
                      _microseconds(row), speedup_text(row)))
    return ShortTable(columns(["technique", "instruction set"],
                              ["kernel µs", "", "end to end µs", ""]), tuple(lines))


def _nets_table(study: Study) -> ShortTable:
    lines = []
    for case, words in NETS:
        rows = _variants(study, case, END_TO_END)
        sums = fastest(row for row in rows if row.name.technique in ARITHMETIC)
        circuit = fastest(row for row in rows if row.name.technique in CIRCUIT)
        if sums and circuit:
            lines.append((words, three_digits(sums.reference_ns / 1e6),
                          f"{_microseconds(sums)} ({_variant(sums)})", times(sums.speedup),
                          _microseconds(circuit), times(circuit.speedup)))
    return ShortTable(columns(["net"], ["reference ms", "arithmetic µs", "", "circuit µs", ""]),
                      tuple(lines))


SHORT_TABLES: dict[str, Callable[[Study], ShortTable]] = {
    "headline": _headline_table, "ladder": _ladder_table, "nets": _nets_table}


def _variants(study: Study, case: str, scope: str) -> list[Row]:
    return [row for row in study.select(case, SCENE)
            if row.name.threads == 1 and row.name.scope == scope
            and not row.name.is_reference and not row.is_peer]


def _variant(row: Row) -> str:
    return f"{row.name.technique}, {row.name.isa}"


def _microseconds(row: Row) -> str:
    """A median time, without decimals that nobody needs."""
    return three_digits(row.median_ns / 1e3) if row.median_ns < 1e6 else \
        microseconds(row.median_ns).split(".", maxsplit=1)[0]
