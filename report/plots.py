"""All figures of a study, in the order in which the page shows them."""

from __future__ import annotations

from report.findings import find
from report.model import SCOPES, Study
from report.plot_sizes import plot_sizes
from report.plot_speedups import plot_speedups
from report.plot_style import Plot, styled


def make_plots(study: Study) -> list[Plot]:
    """Speed-ups for every case and picture, then the size sweeps."""
    with styled():
        speedups = [plot_speedups(study, finding) for finding in find(study)]
        sizes = [plot_sizes(study, case, scope)
                 for case in study.cases for scope in SCOPES]
        return [plot for plot in speedups + sizes if plot]
