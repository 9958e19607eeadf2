"""The tables of the paper's experiments, in the order of the page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from report.batches import batches_table
from report.cluster_runs import cluster_runs_table
from report.experiment_layout import Table, columns, counted
from report.experiments import (KINDS, Counted, EdgeQuality, Experiments, FixedPoint, HiddenNeurons,
                                OperationCounts, Quantisation, Trained)
from report.formatting import NOTHING, percent
from report.literal_holes import literal_holes_table
from report.model import Study
from report.plot_hidden import plot_hidden
from report.quality_tables import make_quality_tables
from report.table_two import make_table_two

Item = TypeVar("Item")


def make_tables(study: Study, experiments: Experiments) -> list[Table]:
    """A table of each experiment there is, and a second one of the operation counts: gates."""
    tables: list[Table] = []
    if experiments.edge_quality:
        tables.append(_edge_quality(experiments.edge_quality))
    if experiments.literal_holes:
        tables.append(literal_holes_table(experiments.literal_holes))
    if experiments.quality:
        tables += make_quality_tables(experiments.quality, study.directory)
    if experiments.batches:
        tables.append(batches_table(experiments.batches))
    if experiments.table_two:
        tables.append(make_table_two(study, experiments.table_two))
    if experiments.cluster_runs:
        tables.append(cluster_runs_table(experiments.cluster_runs))
    if experiments.quantisation:
        tables.append(_quantisation(experiments.quantisation))
    if experiments.hidden_neurons:
        tables.append(_hidden_neurons(experiments.hidden_neurons))
    if experiments.operation_counts:
        tables += [_counts(experiments.operation_counts), _gates(experiments.operation_counts)]
    return tables


def holding_from(items: Sequence[Item], holds: Callable[[Item], bool]) -> Item | None:
    """The first item from which on all hold, or None if the last does not."""
    first = None
    for item in reversed(items):
        if not holds(item):
            break
        first = item
    return first


def _edge_quality(data: EdgeQuality) -> Table:
    header = columns(["Operation"], ["Noise, sigma", "Precision", "Recall", "Figure of merit",
                                     "Marked", "Precision without P2"])
    order = list(dict.fromkeys(row.operation for row in data.rows))
    rows = tuple((row.operation, str(row.sigma), f"{row.precision:.3f}", f"{row.recall:.3f}",
                  f"{row.figure_of_merit:.3f}", percent(100 * row.marked),
                  f"{row.precision_without_p2:.3f}")
                 for row in sorted(data.rows, key=lambda row: (order.index(row.operation),
                                                               row.sigma)))
    return Table("Edges against true contours", _edge_sentence(data), header, rows, data.command)


def _edge_sentence(data: EdgeQuality) -> str:
    most = max(data.rows, key=lambda row: row.marked)
    return (f"P1 is {data.gradient_threshold}, P2 is {data.brightness_threshold}; means over {counted(data.seeds, 'seed')} of the "
            "noise, in grey levels. True contours are the pixels on both sides of a part's border "
            "in the scene without noise. Precision: edge pixels with a contour pixel at most one "
            "pixel away; recall: contour pixels with an edge pixel that near; marked: edge pixels "
            "of all pixels. The more is marked, the less recall says: "
            f"{percent(100 * most.marked)} of all pixels, as {most.operation} marks at sigma "
            f"{most.sigma}, would come that near to {percent(100 * _by_chance(most.marked))} of "
            "the contours if they were marked at random. Figure of merit: Pratt's, against the "
            "inner side of the borders alone, one pixel wide, so edges two pixels wide stay below "
            "1.")


def _by_chance(marked: float) -> float:
    """How much of 3 x 3 pixels has one of those that are marked at random."""
    return 1 - (1 - marked) ** 9


def _quantisation(data: Quantisation) -> Table:
    names = list(data.rows[0].right)
    header = columns(["Weights"], ["Fractional bits", "Largest integer",
                                   *(label for name in names
                                     for label in (f"Right, {name}", "Rate"))])
    rows = tuple((row.weights, str(row.fractional_bits), f"{row.largest_integer:,}",
                  *(cell for right in row.right.values()
                    for cell in _part(right, data.descriptors)))
                 for row in data.rows)
    return Table("Recognition rate under fixed point", _fixed_point_sentence(data), header, rows,
                 data.command)


def _fixed_point_sentence(data: Quantisation) -> str:
    parts = [_enough(data, weights) for weights in dict.fromkeys(r.weights for r in data.rows)]
    worst = min(data.rows, key=lambda row: min(row.right.values()))
    return (f"Of {data.descriptors} neighbourhoods both activations judge all right "
            f"{' and '.join(parts)}; the worst row, {worst.weights} weights with "
            f"{counted(worst.fractional_bits, 'fractional bit')}, still gets "
            f"{min(worst.right.values())}.")


def _enough(data: Quantisation, weights: str) -> str:
    """How many fractional bits are enough, with weights made in one way."""
    def is_perfect(row: FixedPoint) -> bool:
        return all(right == data.descriptors for right in row.right.values())
    rows = sorted((row for row in data.rows if row.weights == weights),
                  key=lambda row: row.fractional_bits)
    first = holding_from(rows, is_perfect)
    if first is None:
        return f"with no number of fractional bits tried that was kept up ({weights} weights)"
    return f"from {counted(first.fractional_bits, 'fractional bit')} on ({weights} weights)"


def _hidden_neurons(data: HiddenNeurons) -> Table:
    header = columns([], ["Hidden neurons", "Best, right", "Rate", "Median, right", "Rate",
                          f"Seeds that reach {data.descriptors}", "Share", "Their median epochs"])
    rows = tuple(_trained_cells(data, row) for row in data.rows)
    return Table("Hidden neurons against recognition rate", _hidden_sentence(data), header, rows,
                 data.command, plot=plot_hidden(data))


def _trained_cells(data: HiddenNeurons, row: Trained) -> tuple[str, ...]:
    epochs = f"{row.median_epochs_of_those:g}" if row.seeds_with_all_right else NOTHING
    return (str(row.hidden), *_part(row.best, data.descriptors),
            *_part(row.median, data.descriptors), *_part(row.seeds_with_all_right, data.seeds),
            epochs)


def _hidden_sentence(data: HiddenNeurons) -> str:
    fewest = next((row.hidden for row in data.rows if row.seeds_with_all_right), None)
    if fewest is None:
        return (f"With none of the numbers of hidden neurons tried did any of "
                f"{counted(data.seeds, 'seed')} learn all {data.descriptors} neighbourhoods.")
    always = holding_from(data.rows, lambda row: row.seeds_with_all_right == data.seeds)
    rest = (f"from {always.hidden} on every seed does" if always else
            "at the largest number tried some seeds still do not")
    return (f"{counted(fewest, 'hidden neuron')} are the fewest with which any of "
            f"{counted(data.seeds, 'seed')} learns all {data.descriptors} neighbourhoods; {rest}.")


def _counts(data: OperationCounts) -> Table:
    header = columns(["Method", "The paper says"], [kind.capitalize() for kind in KINDS])
    rows = tuple((method.method, method.paper or NOTHING,
                  *(_two_parts(method, kind) for kind in KINDS)) for method in data.methods)
    return Table("Operation counts", _counts_sentence(data), header, rows, data.command)


def _counts_sentence(data: OperationCounts) -> str:
    least, most = (pick(data.methods, key=lambda method: method.arithmetic) for pick in (min, max))
    return (f"The methods need from {least.arithmetic} ({least.method}) to {most.arithmetic} "
            f"({most.method}) arithmetic operations. Counts: per {data.per}. Where two are "
            "given, they are of sums + of activations.")


def _two_parts(method: Counted, kind: str) -> str:
    sums, activations = method.sums[kind], method.activations[kind]
    return f"{sums} + {activations}" if activations else str(sums)


def _gates(data: OperationCounts) -> Table:
    rows = tuple((f"Gates of {inputs} inputs", str(size.gates), str(size.inverters),
                  str(size.gates + size.inverters)) for inputs, size in data.circuit.items())
    least = min(data.circuit.items(), key=lambda item: item[1].gates + item[1].inverters)
    sentence = (f"{sum(data.nets.values())} of {counted(len(data.nets), 'net')} compile to the "
                f"rule, whose smallest circuit has {counted(least[1].gates, 'gate')} of {least[0]} "
                f"inputs and {counted(least[1].inverters, 'inverter')}.")
    return Table("The compiled circuit", sentence,
                 columns(["Circuit"], ["Gates", "Inverters", "Together"]), rows, data.command)


def _part(value: float, whole: int) -> tuple[str, str]:
    """A count, and the part of the whole that it is."""
    return f"{value:g}", percent(100 * value / whole)
