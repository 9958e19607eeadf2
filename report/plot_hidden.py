"""Hidden neurons against recognition rate, and the seeds that learn everything."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.experiments import HiddenNeurons
from report.formatting import percent
from report.plot_style import BLUE, GREEN, ORANGE, WIDTH, Plot, rendered, styled, title
from report.tables import csv_text

HEIGHT = 3.6
LEFT, RIGHT, TOP, BOTTOM = 0.75, 0.3, 1.15, 0.6


def plot_hidden(data: HiddenNeurons) -> Plot:
    """The best and median rate as lines; beside them the share of perfect seeds as bars."""
    with styled():
        figure = Figure(figsize=(WIDTH, HEIGHT))
        rates, share = figure.subplots(1, 2, gridspec_kw={
            "left": LEFT / WIDTH, "right": 1 - RIGHT / WIDTH, "wspace": 0.2,
            "top": 1 - TOP / HEIGHT, "bottom": BOTTOM / HEIGHT})
        title(figure, "Hidden neurons against recognition rate",
              f"{data.seeds} seeds each, {data.descriptors} neighbourhoods")
        _draw_rates(rates, data)
        _draw_share(share, data)
        return rendered(figure, "hidden_neurons", _caption(data), _alt(data), _csv(data))


def _draw_rates(axes: Axes, data: HiddenNeurons) -> None:
    hidden = [row.hidden for row in data.rows]
    best = [100 * row.best / data.descriptors for row in data.rows]
    median = [100 * row.median / data.descriptors for row in data.rows]
    for label, rates, colour, style in (("best seed", best, BLUE, "o-"),
                                        ("median seed", median, ORANGE, "s--")):
        axes.plot(hidden, rates, style, label=label, color=colour, linewidth=1.7, markersize=4.5)
    axes.set_title("Neighbourhoods recognised, %", pad=8)
    axes.legend(frameon=False, loc="lower right")
    _set_numbers(axes, hidden)


def _draw_share(axes: Axes, data: HiddenNeurons) -> None:
    hidden = [row.hidden for row in data.rows]
    axes.bar(hidden, [100 * row.seeds_with_all_right / data.seeds for row in data.rows],
             width=0.7, color=GREEN)
    axes.set_ylim(0, 105)
    axes.set_title(f"Seeds that reach {data.descriptors}, %", pad=8)
    _set_numbers(axes, hidden)


def _set_numbers(axes: Axes, hidden: list[int]) -> None:
    axes.set_xlim(hidden[0] - 0.6, hidden[-1] + 0.6)
    axes.set_xticks(hidden)
    axes.set_xlabel("hidden neurons")


def _caption(data: HiddenNeurons) -> str:
    return (f"Hidden neurons: best and median rate of recognition over {data.seeds} seeds, and "
            f"the share of seeds that get all {data.descriptors} neighbourhoods right.")


def _csv(data: HiddenNeurons) -> str:
    header = ("hidden", "best", "median", "seeds_with_all_right", "seeds", "descriptors")
    return csv_text(header, ((row.hidden, row.best, row.median, row.seeds_with_all_right,
                              data.seeds, data.descriptors) for row in data.rows))


def _alt(data: HiddenNeurons) -> str:
    parts = [f"{row.hidden}: {percent(100 * row.best / data.descriptors)}, "
             f"{percent(100 * row.median / data.descriptors)}, "
             f"{percent(100 * row.seeds_with_all_right / data.seeds)}" for row in data.rows]
    return ("Lines and bars by number of hidden neurons. Best rate, median rate and share of "
            f"seeds without an error: {'; '.join(parts)}.")
