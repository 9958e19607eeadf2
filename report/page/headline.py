"""The first table, as the page, timings.md and the README have it."""

from __future__ import annotations

from report.formatting import NOTHING, duration, markdown_table, speedup_text, times, variant
from report.measure.timings import Row
from report.page.operations import Headline

HEADER = ("operation", "time", "technique", "over plain C++", "over best scalar", "AVX2",
          "peer, equal output", "copy bound")
README_HEADER = ("operation", "time", "with AVX2", "technique", "speed-up over plain reference",
                 "against OpenCV (equal output)")


def headline_cells(lines: list[Headline]) -> list[tuple[str, ...]]:
    """A line for each case."""
    return [(line.label, duration(line.best.time_ns), variant(line.best),
             speedup_text(line.best), times(line.over_scalar), _time(line.avx2), peer_cell(line),
             copy_cell(line))
            for line in lines]


def headline_table(lines: list[Headline]) -> str:
    """As Markdown."""
    return markdown_table(HEADER, headline_cells(lines), frozenset((1, 3, 4, 5, 6, 7)))


def readme_table(lines: list[Headline]) -> str:
    """As the README has it."""
    cells = [(f"{line.label}, `{line.case}`", duration(line.best.time_ns), _time(line.avx2),
              variant(line.best), speedup_text(line.best),
              times(line.best.speedup_vs_peer) if _is_opencv(line) else "")
             for line in lines]
    return markdown_table(README_HEADER, cells, frozenset((1, 2, 4, 5)))


def peer_cell(line: Headline) -> str:
    """Its time, and how many times as fast the best variant is."""
    if line.peer is None:
        return NOTHING
    return f"{duration(line.peer.time_ns)} ({times(line.best.speedup_vs_peer)})"


def copy_cell(line: Headline) -> str:
    """Its time, and its share of the best variant's."""
    if line.copy is None or line.copy_share is None:
        return NOTHING
    return f"{duration(line.copy.time_ns)} ({100 * line.copy_share:.0f} %)"


def _time(row: Row | None) -> str:
    return duration(row.time_ns) if row else NOTHING


def _is_opencv(line: Headline) -> bool:
    return line.peer is not None and line.peer.technique == "opencv"
