"""Speed-up of every variant as bars, end to end and kernel side by side."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import blended_transform_factory

from report.cases import file_stem
from report.findings import Finding, fastest
from report.formatting import NOTHING, duration, scope_label, speedup_text, times
from report.model import BASELINE, SCOPES, Row, Study
from report.plot_style import (CARD, CYCLE, GREEN, GREY, GRID, INK, MUTED, ORANGE, PURPLE, SKY,
                               WIDTH, Plot, hover, label_ticks, log_ticks, rendered, title)
from report.tables import to_csv

LEFT, RIGHT, TOP, BOTTOM = 3.1, 0.3, 1.15, 0.62
BAR_PITCH, GROUP_GAP = 0.25, 0.45

LOOK = {BASELINE: (GREY, ""), "sse4.2": (ORANGE, "///"), "avx2": (SKY, "|||"),
        "avx512": (GREEN, "\\\\\\"), "avx512icl": (PURPLE, "xxx")}
SPARE_HATCHES = ("---", "+++", "//")


@dataclass(frozen=True)
class Bar:
    """The place of one variant in the figure; y counts bars from the top."""

    technique: str
    isa: str
    threads: int
    y: float
    opens_group: bool
    rows: dict[str, Row]

    @property
    def label(self) -> str:
        """The technique in words; other people's are marked."""
        words = self.technique.replace("_", " ")
        return f"{words} (peer)" if any(row.is_peer for row in self.rows.values()) else words


def plot_speedups(study: Study, finding: Finding) -> Plot | None:
    """The figure for one case and input, or None if there is only the reference."""
    rows = [row for row in study.select(finding.case, finding.input)
            if not row.name.is_reference]
    if not rows:
        return None
    bars = _arrange(study, rows)
    depth = bars[-1].y + 1
    height = TOP + BOTTOM + BAR_PITCH * depth
    figure = Figure(figsize=(WIDTH, height))
    panels = figure.subplots(1, 2, sharex=True, sharey=True, gridspec_kw={
        "left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH, "wspace": 0.06,
        "top": 1 - TOP / height, "bottom": BOTTOM / height})
    title(figure, f"{finding.case} on {finding.input}: speed-up over the scalar reference",
          f"{finding.reference.width} x {finding.reference.height} pixels, the reference takes "
          f"{duration(finding.reference.median_ns)}; log scale, longer is faster")
    _set_limits(panels[0], rows, depth)
    for axes, scope in zip(panels, SCOPES):
        _draw_panel(axes, bars, scope)
    _label_bars(panels[0], bars)
    return rendered(figure, f"speedup_{file_stem(finding.case)}_{finding.input}",
                    _caption(finding), _alt(finding, rows),
                    to_csv(study.select(finding.case, finding.input)))


def look_of(isa: str) -> tuple[str, str]:
    """Colour and hatch of an instruction set, also of one that is not known yet."""
    number = sum(isa.encode())
    spare = (CYCLE[number % len(CYCLE)], SPARE_HATCHES[number % len(SPARE_HATCHES)])
    return LOOK.get(isa, spare)


def _arrange(study: Study, rows: list[Row]) -> list[Bar]:
    """Groups variants by technique, the technique of the fastest row first."""
    by_technique: dict[str, list[Row]] = {}
    for row in rows:
        by_technique.setdefault(row.name.technique, []).append(row)
    techniques = sorted(by_technique, key=lambda t: -max(r.speedup for r in by_technique[t]))
    bars: list[Bar] = []
    y = 0.0
    for technique in techniques:
        group = sorted(by_technique[technique],
                       key=lambda r: (study.machine.isa_order(r.name.isa), r.name.threads))
        for number, (variant, same) in enumerate(groupby(group, lambda r: r.name.variant)):
            bars.append(Bar(*variant, y, number == 0, {r.name.scope: r for r in same}))
            y += 1
        y += GROUP_GAP
    return bars


def _set_limits(axes: Axes, rows: list[Row], depth: float) -> None:
    """One scale for both panels that holds 1 and leaves room for the numbers behind the bars."""
    low = min(0.8, *(0.7 * row.speedup for row in rows))
    high = max(2.0, *(row.speedup for row in rows))
    high *= (high / low) ** 0.22
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    axes.set_ylim(depth - 0.35, -0.65)
    label_ticks(axes, "x", log_ticks(low, high), lambda value: f"{value:g}×")
    label_ticks(axes, "y", [], str)


def _draw_panel(axes: Axes, bars: list[Bar], scope: str) -> None:
    best = fastest(bar.rows[scope] for bar in bars
                   if scope in bar.rows and not bar.rows[scope].is_peer)
    axes.set_title(scope_label(scope).capitalize(), pad=8)
    axes.spines["left"].set_visible(False)
    axes.axvline(1, color=INK, linewidth=1.2, zorder=3)
    for bar in bars:
        if bar.opens_group and bar.y > 0:
            axes.axhline(bar.y - (1 + GROUP_GAP) / 2, color=GRID, linewidth=0.8)
        row = bar.rows.get(scope)
        if row is None:
            _write(axes, 1, bar.y, f"\u00a0{NOTHING}", color=MUTED)
            continue
        colour, hatch = look_of(bar.isa)
        [patch] = axes.barh(bar.y, row.speedup - 1, left=1, height=0.78, color=colour, hatch=hatch,
                            edgecolor=CARD, linewidth=0)
        hover(patch, f"{row.name.variant_label}, {scope_label(scope)}: {speedup_text(row)}, "
                     f"{duration(row.median_ns)}")
        note = times(row.speedup) + (" (noisy)" if row.is_noisy else "")
        _write(axes, max(row.speedup, 1), bar.y, f"\u00a0{note}", color=INK,
               weight="bold" if row is best else "normal")
    axes.set_xlabel("times as fast as the reference")


def _write(axes: Axes, x: float, y: float, text: str, **look: str) -> None:
    axes.text(x, y, text, va="center_baseline", size=8.5, **look)


def _label_bars(axes: Axes, bars: list[Bar]) -> None:
    """Technique once a group, then instruction set and threads for each bar."""
    inches = blended_transform_factory(axes.figure.dpi_scale_trans, axes.transData)
    for bar in bars:
        if bar.opens_group:
            axes.text(0.2, bar.y, bar.label, transform=inches, size=9.5, weight="bold",
                      va="center_baseline")
        threads = f", {bar.threads} threads" if bar.threads > 1 else ""
        axes.text(LEFT - 0.12, bar.y, bar.isa + threads, transform=inches, size=9, color=MUTED,
                  ha="right", va="center_baseline")


def _caption(finding: Finding) -> str:
    return (f"{finding.case} on {finding.input}: speed-up of each variant, grouped by "
            "technique. Colour and hatch tell the instruction set; bold is the fastest of a panel; "
            "a dash was not timed in that scope.")


def _alt(finding: Finding, rows: list[Row]) -> str:
    parts = [f"{row.name.variant_label}, {scope_label(row.name.scope)}: {times(row.speedup)}"
             for row in (finding.end_to_end, finding.kernel) if row]
    return (f"Bars of the speed-up of {len(rows)} rows of {finding.case} on {finding.input}. "
            f"Fastest: {'; '.join(parts)}.")
