"""Techniques in a few families, which all plots show in the same colours."""

from __future__ import annotations

from dataclasses import dataclass

from report.measure.timings import Row
from report.page.operations import COPIES


@dataclass(frozen=True)
class Family:
    """Colours are those of Okabe and Ito, which the common kinds of colour blindness keep apart."""

    words: str
    colour: str
    marker: str  # as matplotlib calls it


REFERENCE = Family("plain C++ reference", "#8b929b", "o")
PEER = Family("other project, equal output", "#e69f00", "D")
OTHER = Family("other project, other output", "#e69f00", "d")
COPY = Family("copy of the bytes", "#009e73", "|")
TABLES = Family("tables, union-find", "#c3a800", "s")
COMPILER = Family("vectorised by the compiler", "#cc79a7", "v")
WORDS = Family("64 pixels in a word", "#56b4e9", "^")
NUMBERS = Family("SIMD on bytes and numbers", "#d55e00", "X")
BITS = Family("SIMD on packed bits", "#0072b2", "o")
FAMILIES = (REFERENCE, TABLES, COMPILER, WORDS, NUMBERS, BITS, PEER, OTHER, COPY)

OF_TECHNIQUE = {
    "reference": REFERENCE, "lut": TABLES, "lut_sliding": TABLES, "union_find": TABLES,
    "autovec": COMPILER, "bitpacked": WORDS, "bitpacked_runs": WORDS,
    "bitpacked_contacts": WORDS, "simd_contacts": BITS,
    "bitpacked_flood": WORDS, "simd_flood": BITS,
    "simd_bitpacked": BITS, "simd_bitpacked_row": BITS, "simd_bitpacked_tiles": BITS,
    "simd_runs": BITS}


def family(row: Row, equal_peers: set[str]) -> Family:
    """Of a row's technique; `equal_peers` are those with equal output."""
    if row.peer:
        return COPY if row.technique in COPIES else PEER if row.technique in equal_peers else OTHER
    return OF_TECHNIQUE.get(row.technique, NUMBERS)
