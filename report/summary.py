"""The plain-text summary that `build` prints: one block for each case and picture."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass

from report.experiment_layout import counted
from report.findings import (Finding, find, main_sentence, noise_of, noise_sentence,
                             speedup_sentence)
from report.formatting import NOTHING, microseconds, times
from report.model import END_TO_END, KERNEL, Row, Study

WIDTH = 100
LEGEND = "* fastest   ~ noisy   times: median of the repetitions   x: speed-up   ? inconclusive"


@dataclass(frozen=True)
class Line:
    """A variant with its rows in both scopes."""

    variant: tuple[str, str, int]
    kernel: Row | None
    end_to_end: Row | None

    @property
    def rows(self) -> list[Row]:
        """The rows there are; lines are sorted by the first."""
        return [row for row in (self.end_to_end, self.kernel) if row]


def to_text(study: Study) -> str:
    """All blocks, the legend, and what the run shows in two sentences."""
    findings = find(study)
    blocks = [_block(study, finding) for finding in findings]
    notes = [LEGEND] if blocks else []
    for sentence in (main_sentence(findings), speedup_sentence(study),
                     noise_sentence(noise_of(study))):
        notes += textwrap.wrap(sentence, WIDTH)
    if study.machine.run.is_partial:
        notes += textwrap.wrap(f"This was a partial run ({study.machine.run.words}).", WIDTH)
    if study.skipped:
        notes.append(f"Skipped rows: {len(study.skipped)}; the page lists them with the reasons.")
    return "\n\n".join(["\n".join(block) for block in blocks] + ["\n".join(notes)]) + "\n"


def _block(study: Study, finding: Finding) -> list[str]:
    reference = finding.reference
    count = reference.iterations
    iterations = "" if count is None else f", {counted(count, 'iteration')}"
    title = _cut(f"{finding.case} on {finding.input}", 70)
    title += f" ({reference.width} x {reference.height}{iterations})"
    header = _columns("technique", "isa", "threads", "kernel µs", "x", "end-to-end µs", "x")
    lines = sorted(_lines(study.select(finding.case, finding.input)),
                   key=lambda line: (line.rows[0].median_ns, line.variant))
    body = [_text_line(line, finding.best) for line in lines]
    return [title, "  " + header, "  " + "-" * len(header), *body]


def _lines(rows: list[Row]) -> list[Line]:
    by_key = {(row.name.variant, row.name.scope): row for row in rows}
    variants = {row.name.variant for row in rows}
    return [Line(v, by_key.get((v, KERNEL)), by_key.get((v, END_TO_END))) for v in variants]


def _text_line(line: Line, best: Row | None) -> str:
    technique, isa, threads = line.variant
    mark = "*" if any(row is best for row in line.rows) else " "
    noise = "~" if any(row.is_noisy for row in line.rows) else " "
    return (mark + noise + _columns(technique, isa, str(threads), _time(line.kernel),
                                    _gain(line.kernel), _time(line.end_to_end),
                                    _gain(line.end_to_end))).rstrip()


def _columns(technique: str, isa: str, threads: str, kernel: str, kernel_gain: str,
             end_to_end: str, end_to_end_gain: str) -> str:
    return (f"{_cut(technique, 24):24}  {_cut(isa, 12):12} {threads:>7} {kernel:>14} "
            f"{kernel_gain:>8} {end_to_end:>15} {end_to_end_gain:>8}")


def _time(row: Row | None) -> str:
    return microseconds(row.median_ns) if row else NOTHING


def _gain(row: Row | None) -> str:
    if row is None:
        return NOTHING
    return times(row.speedup) + ("?" if row.paired and row.paired.is_inconclusive else "")


def _cut(text: str, width: int) -> str:
    return text if len(text) <= width else text[:width - 1] + "…"
