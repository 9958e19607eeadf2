"""Time against limit: the fastest row of each case, what bounds it, and a copy."""

from __future__ import annotations

from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import blended_transform_factory

from report.formatting import duration, round_duration, scope_label
from report.limit_reasons import reason
from report.limit_rows import Limit, Limits, copy_ns
from report.model import SCOPES, Study
from report.plot_style import (BLUE, GREY, GRID, INK, MUTED, ORANGE, WIDTH, Plot, hover, label_ticks,
                               log_ticks, rendered, styled, title)
from report.tables import csv_text

LEFT, RIGHT, TOP, BOTTOM, PITCH = 2.5, 0.3, 1.45, 0.62, 0.27
TIME = {"marker": "o", "color": BLUE, "markersize": 6.5}
LIMIT = {"marker": "|", "color": INK, "markersize": 11, "markeredgewidth": 2}
COPY = {"marker": "D", "color": ORANGE, "markersize": 5.5, "markeredgecolor": INK,
        "markeredgewidth": 0.7}


@dataclass(frozen=True)
class Dot:
    """One line of a panel."""

    row: Limit
    copy_ns: float | None
    bottleneck: str
    y: int

    @property
    def times(self) -> list[float]:
        """All that is drawn of it."""
        return [self.row.ns, self.row.limit_ns, *([self.copy_ns] if self.copy_ns else [])]


def plot_limits(study: Study, limits: Limits) -> Plot | None:
    """The figure, or None if nothing was counted."""
    cases = [name for name in study.cases
             if any(row.case.name == name for row in limits.rows)]
    dots = [_fastest(study, limits, name, scope, place)
            for place, name in enumerate(cases) for scope in SCOPES]
    drawn = [dot for dot in dots if dot]
    if not drawn:
        return None
    with styled():
        height = TOP + BOTTOM + PITCH * len(cases)
        figure = Figure(figsize=(WIDTH, height))
        panels = figure.subplots(1, 2, sharex=True, sharey=True, gridspec_kw={
            "left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH, "wspace": 0.06,
            "top": 1 - TOP / height, "bottom": BOTTOM / height})
        title(figure, f"Time against limit on {limits.input}",
              "the fastest row of each case on one thread among those that were counted; "
              "log scale, left is faster")
        _set_limits(panels[0], drawn, len(cases))
        for axes, scope in zip(panels, SCOPES):
            _draw_panel(axes, [dot for dot in drawn if dot.row.scope == scope], scope)
        _label_lines(panels[0], cases)
        _explain(figure, limits)
        return rendered(figure, "limits", _caption(limits), _alt(drawn), _csv(drawn))


def _fastest(study: Study, limits: Limits, case: str, scope: str, place: int) -> Dot | None:
    rows = [row for row in limits.rows if (row.case.name, row.scope) == (case, scope)]
    best = min(rows, key=lambda row: row.ns, default=None)
    if best is None:
        return None
    return Dot(best, copy_ns(study, limits, best), reason(study, limits, best), place)


def _set_limits(axes: Axes, dots: list[Dot], depth: int) -> None:
    """One scale for both panels, with room for the numbers behind the dots."""
    values = [value for dot in dots for value in dot.times]
    low, high = min(values) / 1.4, max(values)
    high *= (high / low) ** 0.16
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    axes.set_ylim(depth - 0.35, -0.65)
    label_ticks(axes, "x", log_ticks(low, high), round_duration)
    label_ticks(axes, "y", [], str)


def _draw_panel(axes: Axes, dots: list[Dot], scope: str) -> None:
    axes.set_title(scope_label(scope).capitalize(), pad=8)
    axes.spines["left"].set_visible(False)
    axes.set_xlabel("one call")
    for dot in dots:
        axes.plot([min(dot.times), max(dot.times)], [dot.y, dot.y], color=GRID, linewidth=1.6)
        axes.plot([dot.row.limit_ns, dot.row.ns], [dot.y, dot.y], color=GREY, linewidth=2.2)
        if dot.copy_ns:
            axes.plot(dot.copy_ns, dot.y, linestyle="", **COPY)
        [time] = axes.plot(dot.row.ns, dot.y, linestyle="", **TIME)
        axes.plot(dot.row.limit_ns, dot.y, linestyle="", **LIMIT)
        hover(time, f"{dot.row.case.name}, {dot.row.technique} ({dot.row.isa}): "
                    f"{duration(dot.row.ns)}, limit {duration(dot.row.limit_ns)}")
        axes.text(max(dot.times), dot.y, f"\N{NO-BREAK SPACE}\N{NO-BREAK SPACE}{dot.row.percent:.0f} %",
                  va="center_baseline", size=8.5, color=INK)


def _label_lines(axes: Axes, cases: list[str]) -> None:
    inches = blended_transform_factory(axes.figure.dpi_scale_trans, axes.transData)
    for place, name in enumerate(cases):
        axes.text(0.2, place, name, transform=inches, size=9.5, va="center_baseline")


def _explain(figure: Figure, limits: Limits) -> None:
    """The marks in words, in one line below the title."""
    handles = [figure.axes[0].plot([], [], linestyle="", label=label, **look)[0]
               for label, look in ((f"limit of {limits.issue_width:g} instructions per cycle", LIMIT),
                                   ("measured time", TIME), ("copy, or only reading", COPY))]
    figure.legend(handles=handles, loc="upper left", frameon=False, ncols=3, labelcolor=MUTED,
                  bbox_to_anchor=(0.1 / WIDTH, 1 - 0.68 / figure.get_figheight()))


def _caption(limits: Limits) -> str:
    return ("The fastest counted row of each case: its time (dot), the time in which its "
            f"instructions would be issued at {limits.issue_width:g} per cycle (bar), and a copy "
            "of the same memory, or a read where numbers come out (diamond), where one was timed. "
            "The number is the limit in percent of the time.")


def _csv(dots: list[Dot]) -> str:
    header = ("operation", "scope", "technique", "isa", "instructions", "ns", "limit_ns",
              "percent_of_limit", "copy_ns", "bottleneck", "border", "max_iterations")
    return csv_text(header, ((row.case.operation, row.scope, row.technique, row.isa,
                              row.instructions, row.ns, row.limit_ns, row.percent, copy_ns or "",
                              bottleneck, *row.case.columns)
                             for row, copy_ns, bottleneck in (
                                 (dot.row, dot.copy_ns, dot.bottleneck) for dot in dots)))


def _alt(dots: list[Dot]) -> str:
    parts = [f"{dot.row.case.name}, {scope_label(dot.row.scope)}, {dot.row.technique}: "
             f"{duration(dot.row.ns)}, limit {duration(dot.row.limit_ns)}" for dot in dots]
    return f"Dots of time beside marks of limits. {'; '.join(parts)}."
