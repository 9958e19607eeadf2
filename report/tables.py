"""The rows of a study as CSV for programs and as Markdown for readers."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence

from report.formatting import microseconds, percent, scope_label, speedup_text
from report.model import Row, Study, is_sweep_input

CSV_HEADER = (
    "operation", "technique", "isa", "threads", "scope", "input", "width", "height", "passes",
    "median_ns", "min_ns", "ns_per_pixel", "speedup_vs_reference", "verified",
    "repetitions", "spread_percent", "peer", "speedup_low", "speedup_high", "speedup_from",
    "plan_bytes", "border", "max_iterations")

MARKDOWN_HEADER = (
    "operation", "border", "max. iterations", "input", "scope", "technique", "isa", "threads",
    "iterations", "median µs", "ns/pixel", "speed-up", "spread", "memory KiB")
MARKDOWN_NUMBERS = MARKDOWN_HEADER.index("threads")


def csv_text(header: Iterable[object], lines: Iterable[Iterable[object]]) -> str:
    """Lines of comma-separated values, quoted where they need it."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(lines)
    return text.getvalue()


def to_csv(rows: Iterable[Row]) -> str:
    """Every row; columns are only ever added at the right.

    Times are nanoseconds; spread_percent is the interquartile range in percent
    of the median, and empty where a single repetition leaves it unknown.
    speedup_vs_reference is the ratio measured in pairs where speedup_from is
    "paired", with its interval; where it is "medians", reference and row were
    timed apart and their medians divided, and no interval is known. plan_bytes
    is the memory that a variant holds for an input of this size, its planes
    included; it asks for none while it runs. operation, border and
    max_iterations together are the case; passes are the iterations it took.
    """
    return csv_text(CSV_HEADER, (_csv_fields(row) for row in rows))


def to_markdown(study: Study) -> str:
    """The rows of the scene and of users' pictures; the size sweep is left to the CSV."""
    rows = [row for row in study.rows if not is_sweep_input(row.name.input)]
    rule = ["---:" if index >= MARKDOWN_NUMBERS else "---"
            for index in range(len(MARKDOWN_HEADER))]
    lines = [markdown_line(MARKDOWN_HEADER), markdown_line(rule)]
    lines += [markdown_line(_markdown_fields(row)) for row in rows]
    return "\n".join(lines) + "\n"


def _csv_fields(row: Row) -> list[object]:
    name = row.name
    spread = row.spread_percent
    return [
        name.case.operation, name.technique, name.isa, name.threads, name.scope, name.input,
        row.width, row.height, "" if row.iterations is None else row.iterations,
        f"{row.median_ns:.2f}", f"{row.min_ns:.2f}", f"{row.ns_per_pixel:.6f}",
        f"{row.speedup:.4f}", 1, len(row.samples_ns), "" if spread is None else f"{spread:.2f}",
        int(row.is_peer),
        *((f"{row.paired.low:.4f}", f"{row.paired.high:.4f}", "paired") if row.paired
          else ("", "", "medians")),
        "" if row.plan_bytes is None else row.plan_bytes, *name.case.columns]


def _markdown_fields(row: Row) -> list[str]:
    name = row.name
    return [
        name.case.operation, *name.case.columns, name.input, scope_label(name.scope),
        name.technique + (" (peer)" if row.is_peer else ""), name.isa,
        str(name.threads), "" if row.iterations is None else str(row.iterations),
        microseconds(row.median_ns), f"{row.ns_per_pixel:.4f}", speedup_text(row),
        percent(row.spread_percent) + (" (noisy)" if row.is_noisy else ""),
        "" if row.plan_bytes is None else f"{row.plan_bytes / 1024:,.0f}"]


def markdown_line(fields: Sequence[str]) -> str:
    """A row of a Markdown table."""
    return "| " + " | ".join(field.replace("|", "\\|") for field in fields) + " |"
