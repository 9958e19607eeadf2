"""The bottleneck of a row that does not reach its limit, in one word each."""

from __future__ import annotations

from collections.abc import Iterable

from report.limit_rows import Limit, Limits, copy_ns, timed_ns
from report.model import END_TO_END, Study

REACHED_PERCENT = 80.0
"""From this share of the limit up there is no bottleneck to name."""

COPY_SHARE = 0.5
"""The part of a row's time from which a copy of the same bytes is the reason."""

TIMED_SHARE = 0.9
"""The part of a row's time up to which the other time of the same row disagrees with it."""

BYTES, UNSTEADY, NOT_KNOWN = "bytes", "unsteady", "not known"
MEASURED = (BYTES, UNSTEADY)
"""The reasons that follow from times; the others are what is known of techniques."""

VECTOR_PORTS, INTEGER_PORTS = "vector ports", "integer ports"
TABLE_LOADS, BRANCHES, LISTS = "table loads", "branches", "lists"

SENTENCES = {
    UNSTEADY: "Times disagree: in the table of all rows the same row took at least a tenth less.",
    BYTES: "The copy beside the row takes at least half of its time.",
    VECTOR_PORTS: "On Intel's processors 512-bit instructions start at most two per cycle and shorter "
                  "vector instructions at most three; only loads, stores and scalar instructions "
                  "come on top of them.",
    INTEGER_PORTS: "On Intel's processors arithmetic in general registers starts at most four or "
                   "five times per cycle, shifts and branches at most twice.",
    TABLE_LOADS: "A look-up waits for the pixels that its place is made of, and loads start at most "
                 "two or three per cycle.",
    BRANCHES: "How often loops run follows the picture; where a branch is mispredicted, what was "
              "begun is discarded.",
    LISTS: "Lists of active tiles are made in every sub-iteration, and each tile is loaded across cache lines "
           "and stored twice.",
    NOT_KNOWN: "No bound of the technique is known.",
}

OF_TECHNIQUE = {
    "lut": TABLE_LOADS,
    "lut_sliding": TABLE_LOADS,
    "union_find": BRANCHES,
    "autovec": VECTOR_PORTS,
    "simd_float_bits": VECTOR_PORTS,
    "simd_fixed_point": VECTOR_PORTS,
    "bitpacked": INTEGER_PORTS,
    "bitpacked_runs": BRANCHES,
    "simd_bytes": VECTOR_PORTS,
    "simd_bitpacked": VECTOR_PORTS,
    "simd_bitpacked_tiles": LISTS,
    "simd_bitpacked_row": VECTOR_PORTS,
    "simd_16bit": VECTOR_PORTS,
    "simd_8bit": VECTOR_PORTS,
    "simd_runs": BRANCHES,
}
"""What bounds each technique, as the texts above its kernels say; rows on one thread."""


def reason(study: Study, limits: Limits, limit: Limit) -> str:
    """The word, or nothing for a row that reaches its limit.

    Only end to end can it be the bytes: kernels work on packed planes in near caches, and some
    take less time than the copy there.
    """
    if limit.percent >= REACHED_PERCENT:
        return ""
    timed, copy = timed_ns(study, limits, limit), copy_ns(study, limits, limit)
    if timed and timed <= TIMED_SHARE * limit.ns:
        return UNSTEADY
    if limit.scope == END_TO_END and copy and copy >= COPY_SHARE * limit.ns:
        return BYTES
    return OF_TECHNIQUE.get(limit.technique, NOT_KNOWN)


def explained(words: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """The words that occur, each with its sentence."""
    found = set(words)
    return tuple((word, text) for word, text in SENTENCES.items() if word in found)
