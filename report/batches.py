"""Many small images at once against one by one: the experiment's file and its table."""

from __future__ import annotations

from dataclasses import dataclass

from report.cases import Case, case_in
from report.errors import ReportError
from report.experiment_layout import Table, columns, counted
from report.json_fields import Fields
from report.plot_batches import plot_batches


@dataclass(frozen=True)
class BatchRow:
    """Images per second of one case at one size."""

    case: Case
    side: int
    foreground: float
    iterations: int
    single: str
    """Technique and ISA of what thins one by one."""
    isa: str
    single_per_second: float
    batch_per_second: float
    ratio: float
    ratio_low: float
    ratio_high: float


@dataclass(frozen=True)
class Batches:
    """Both ways, by case and size."""

    command: str
    images: int
    rounds: int
    rows: tuple[BatchRow, ...]


def parse_batches(fields: Fields) -> Batches:
    """What a file of this experiment holds."""
    return Batches(fields.text("command"), fields.count("images", 1), fields.count("rounds", 3),
                   tuple(_row(row) for row in fields.some("rows")))


def _row(row: Fields) -> BatchRow:
    ratio, low, high = (row.positive(key) for key in ("ratio", "ratio_low", "ratio_high"))
    if not low <= ratio <= high:
        raise ReportError(f"{row.where}: ratio is {ratio}; it must lie from {low} to {high}")
    return BatchRow(case_in(row), row.count("side", 1),
                    row.at_most(row.renamed("foreground", "dark"), 1),
                    row.count(row.renamed("iterations", "passes"), 1), row.text("single"),
                    row.text(row.renamed("isa", "level")),
                    row.positive("single_per_second"), row.positive("batch_per_second"),
                    ratio, low, high)


def batches_table(data: Batches) -> Table:
    """A row for each case and size."""
    header = columns(["Case", "One by one", "Batch"],
                     ["Side", "Images/s, one by one", "Images/s, batch", "Ratio"])
    rows = tuple((row.case.name, row.single, row.isa, str(row.side),
                  f"{row.single_per_second:,.0f}", f"{row.batch_per_second:,.0f}",
                  f"{row.ratio:.2f}× ({row.ratio_low:.2f} to {row.ratio_high:.2f})")
                 for row in data.rows)
    sentence = (f"{counted(data.images, 'image')} of random strokes, bytes in to bytes out, on one "
                "thread: one by one by whichever variant was fastest, and as a batch with one "
                f"image per lane. Both ran interleaved; of {data.rounds} rounds the median, and in "
                "brackets all but the lowest and the highest. Every image was equal to its "
                "reference.")
    return Table("Many small images", sentence, header, rows, data.command, _verdict(data),
                 plot_batches(data))


def _verdict(data: Batches) -> str:
    parts = []
    for side in dict.fromkeys(row.side for row in data.rows):
        ratios = [row.ratio for row in data.rows if row.side == side]
        parts.append(f"{min(ratios):.1f} to {max(ratios):.1f} times at {side} x {side} pixels")
    return f"As a batch they are thinned faster: {', '.join(parts)}."
