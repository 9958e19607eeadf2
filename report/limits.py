"""Time against limit as a table and a figure."""

from __future__ import annotations

from report.experiment_layout import Column, Table, columns
from report.formatting import NOTHING, microseconds, scope_label
from report.limit_reasons import MEASURED, REACHED_PERCENT, explained, reason
from report.limit_rows import Limit, Limits, copy_ns
from report.model import SCOPES, Study
from report.plot_limits import plot_limits

TITLE = "Time against limit"
HEADER = columns(["Case", "Scope", "Technique", "ISA"],
                 ["Instructions", "Per cycle", "µs", "Limit µs", "Of limit",
                  "Per row and iteration", "Copy µs"]) + (Column("Bottleneck", False),)


def limits_table(study: Study, limits: Limits | None) -> Table | None:
    """The rows by case and scope, the fastest first; None where nothing was counted."""
    if limits is None or not limits.rows:
        return None
    order = {name: place for place, name in enumerate(study.cases)}
    rows = sorted(limits.rows, key=lambda row: (
        order.get(row.case.name, len(order)), SCOPES.index(row.scope), row.ns))
    cells = tuple((*_cells(row, copy_ns(study, limits, row)), reason(study, limits, row))
                  for row in rows)
    return Table(TITLE, _sentence(limits), HEADER, cells, "thinbench instructions --limits",
                 plot=plot_limits(study, limits), words=explained(row[-1] for row in cells))


def _sentence(limits: Limits) -> str:
    left_out = (f" {limits.skipped} rows execute too many to be counted, or do not run here."
                if limits.skipped else "")
    width, height = limits.size
    how = (f", {limits.by_callgrind} rows by callgrind and the others by single steps"
           if limits.by_callgrind else " by single steps")
    return (f"Instructions of one call on {limits.input}, {width} x {height} pixels, counted{how}; "
            "time and frequency were measured next to each other. The limit is the time "
            f"of a core that issues {limits.issue_width:g} instructions in every cycle, which is "
            "assumed and not measured; above 100 % the core issues more. The copy is one of the "
            "same bytes, of packed bits for bit-packed techniques, where it was timed on the same "
            "input; where an operation gives numbers, its input is packed and read."
            f"{left_out} Where less than {REACHED_PERCENT:g} % of the limit is reached, the last "
            f"column names the bottleneck: {' and '.join(MEASURED)} follow from times, any "
            "other word is a known bound of the technique and was not measured for the row.")


def _cells(row: Limit, copy: float | None) -> tuple[str, ...]:
    each = row.per_row_and_iteration
    return (row.case.name, scope_label(row.scope), row.technique, row.isa,
            f"{row.instructions:,}", f"{row.instructions_per_cycle:.2f}", microseconds(row.ns),
            microseconds(row.limit_ns), f"{row.percent:.0f} %",
            NOTHING if each is None else f"{each:.1f}",
            NOTHING if copy is None else microseconds(copy))
