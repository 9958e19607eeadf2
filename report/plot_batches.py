"""Images per second, one by one and as a batch."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.plot_style import BLUE, ORANGE, WIDTH, Plot, rendered, styled, title
from report.tables import csv_text

if TYPE_CHECKING:
    from report.batches import BatchRow, Batches

HEIGHT = 3.4
LEFT, RIGHT, TOP, BOTTOM = 2.3, 0.6, 1.15, 0.6
BAR = 0.38


def plot_batches(data: Batches) -> Plot:
    """A panel for each size; two bars for each case."""
    sides = list(dict.fromkeys(row.side for row in data.rows))
    with styled():
        figure = Figure(figsize=(WIDTH, HEIGHT))
        panels = figure.subplots(1, len(sides), squeeze=False, sharey=True, gridspec_kw={
            "left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH, "wspace": 0.15,
            "top": 1 - TOP / HEIGHT, "bottom": BOTTOM / HEIGHT})[0]
        title(figure, "Many small images", f"{data.images:,} images of strokes, one thread")
        for axes, side in zip(panels, sides):
            _draw(axes, [row for row in data.rows if row.side == side], side)
        panels[0].invert_yaxis()
        panels[0].legend(frameon=False, loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
        return rendered(figure, "batches", _caption(data), _alt(data), _csv(data))


def _draw(axes: Axes, rows: list[BatchRow], side: int) -> None:
    places = range(len(rows))
    axes.barh([place - BAR / 2 for place in places], [row.single_per_second / 1e6 for row in rows],
              height=BAR, color=ORANGE, label="one by one")
    axes.barh([place + BAR / 2 for place in places], [row.batch_per_second / 1e6 for row in rows],
              height=BAR, color=BLUE, label="batch")
    axes.set_yticks(list(places), [row.case.name for row in rows])
    axes.set_title(f"{side} x {side} pixels", pad=8)
    axes.set_xlabel("million images per second")


def _caption(data: Batches) -> str:
    return (f"Images per second of {data.images:,} images of strokes on one thread, one by one by "
            "the fastest variant and as a batch.")


def _alt(data: Batches) -> str:
    parts = [f"{row.case.name} at {row.side} x {row.side}: {row.single_per_second:,.0f}, "
             f"{row.batch_per_second:,.0f}" for row in data.rows]
    return f"Bars of images per second, one by one and as a batch. {'; '.join(parts)}."


def _csv(data: Batches) -> str:
    header = ("operation", "side", "single", "isa", "single_per_second", "batch_per_second",
              "ratio", "ratio_low", "ratio_high", "border", "max_iterations")
    return csv_text(header, ((row.case.operation, row.side, row.single, row.isa,
                              row.single_per_second, row.batch_per_second, row.ratio,
                              row.ratio_low, row.ratio_high, *row.case.columns) for row in data.rows))
