"""Makes page, tables and overview of a run in memory, then writes all of them."""

from __future__ import annotations

from pathlib import Path

from report.claims import judge
from report.claims import to_markdown as claims_to_markdown
from report.files import write_files
from report.formatting import NOTHING, duration, flag_text, markdown_table, speedup_text, times
from report.formatting import variant
from report.measure.run import load_run
from report.measure.timings import Row
from report.page.experiments import experiment_tables, load_experiments
from report.page.headline import headline_table
from report.page.html import to_html
from report.page.operations import Headline, Rows, label
from report.page.overview import overview
from report.page.sentences import origin, sentences, warnings
from report.page.table_two import table_two
from report.page.tables import to_markdown

PAGE, MARKDOWN, CLAIMS = "index.html", "timings.md", "claims.md"


def build_page(directory: Path) -> str:
    """Returns the summary to print."""
    rows = Rows(load_run(directory))
    lines = rows.headlines()
    experiments = load_experiments(directory)
    claims = judge(rows, experiments)
    svg = overview(rows, lines)
    write_files(directory, {
        "overview.svg": svg.encode(),
        MARKDOWN: _timings(rows, lines).encode(),
        CLAIMS: claims_to_markdown(claims, origin(rows.run)).encode(),
        PAGE: to_html(rows, lines, svg, claims,
                      [table_two(rows), *experiment_tables(experiments)]).encode()})
    return summary(rows, lines, directory)


def summary(rows: Rows, lines: list[Headline], directory: Path) -> str:
    """For the terminal: headline rows, what is doubtful, and where the page is."""
    cells = [(line.label, duration(line.best.time_ns), speedup_text(line.best),
              times(line.best.speedup_vs_peer) if line.peer else "", variant(line.best))
             for line in lines]
    head = ("operation", "time", "over plain C++ (interval)", "over peer", "technique")
    widths = [max(map(len, column)) for column in zip(head, *cells)]
    text = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip()
            for line in (head, *cells)]
    return "\n".join([*text, "", *warnings(rows.run), f"Page: {directory / PAGE}"]) + "\n"


def _timings(rows: Rows, lines: list[Headline]) -> str:
    parts = ["# Timings\n", f"{origin(rows.run)} Image {rows.input}, one thread, end to end. Every "
             "row is in timings.csv.\n", *(f"- {text}" for text in sentences(rows, lines)), "",
             *(f"- **{text}**" for text in warnings(rows.run)), headline_table(lines),
             to_markdown(table_two(rows))]
    parts += [f"## {label(case)}\n\n{_case_table(rows.of(case))}" for case in rows.cases]
    return "\n".join(parts)


def _case_table(rows: list[Row]) -> str:
    cells = [(row.technique, row.isa, duration(row.time_ns),
              duration(row.high_ns), duration(row.typical_ns), speedup_text(row),
              times(row.speedup_vs_peer) if row.speedup_vs_peer else NOTHING, flag_text(row, ""))
             for row in sorted(rows, key=lambda row: row.time_ns)]
    return markdown_table(("technique", "ISA", "time", "up to", "typical",
                           "over plain C++", "over peer", "flags"), cells,
                          frozenset((2, 3, 4, 5, 6)))
