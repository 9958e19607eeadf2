"""The paper's experiments, repeated: JSON files that are the same on every machine."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from report.building import ROOT
from report.files import read_json
from report.formatting import NOTHING, counted
from report.measure.benchmarks import Json
from report.page.operations import label
from report.page.tables import Table
from report.schemas import check_schema

DIRECTORY = ROOT / "results" / "experiments"
NAMES = ("quality", "edge-quality", "literal-holes", "quantisation", "hidden-neurons",
         "cluster-runs", "operation-counts")
Experiments = dict[str, Json]
Column = tuple[str, Callable[[Json], Any]]


def load_experiments(run: Path | None = None) -> Experiments:
    """By name; those of the run's directory, where it has some, else the project's."""
    found = {}
    for name in NAMES:
        paths = [directory / f"{name}.json"
                 for directory in ((run / "experiments", DIRECTORY) if run else (DIRECTORY,))]
        for path in paths:
            if path.exists():
                found[name] = read_json(path)
                check_schema("experiment", found[name], str(path))
                break
    return found


def experiment_tables(experiments: Experiments) -> list[Table]:
    """In the order of the page."""
    return [table for name in NAMES if name in experiments
            for table in _MAKERS[name](experiments[name])]


def _key(name: str, style: str = ",") -> Callable[[Json], str]:
    def text(row: Json) -> str:
        value = row[name]
        return NOTHING if value is None else value if isinstance(value, str) else f"{value:{style}}"
    return text


def _change(name: str) -> Callable[[Json], str]:
    def text(row: Json) -> str:
        before, after = row[f"{name}_before"], row[f"{name}_after"]
        return f"{before:,}" if before == after else f"{before:,} → {after:,}"
    return text


def _case(row: Json) -> str:
    return label(row["operation"])


def _table(title: str, sentence: str, columns: list[Column], rows: list[Json],
           data: Json) -> Table:
    cells = tuple(tuple(str(value(row)) for _, value in columns) for row in rows)
    return Table(title, sentence, tuple(name for name, _ in columns), cells, data["command"])


def _quality(data: Json) -> Iterator[Table]:
    columns = [("Operation", _case), ("Objects", _change("objects")), ("Holes", _change("holes")),
               ("Pixels", _key("pixels")), ("2 × 2 blocks", _key("blocks")), ("Ends", _key("ends")),
               ("Branches", _key("branches")), ("Mean distance", _key("mean_distance", ".3f")),
               ("Largest", _key("largest_distance", ".2f")),
               ("Minimum symmetry", _key("min_symmetry", ".3f")),
               ("Iterations", _key("iterations"))]
    for name in dict.fromkeys(row["input"] for row in data["rows"]):
        yield _table(f"Skeletons of {name}",
                     "Objects are 8-connected, holes 4-connected; an arrow means that their number "
                     "changed. Distances, in pixels, are from the medial axis. Symmetry is the "
                     "smallest overlap with the skeleton of the rotated input.",
                     columns, [row for row in data["rows"] if row["input"] == name], data)


def _edge_quality(data: Json) -> Iterator[Table]:
    rates = ("precision", "recall", "figure_of_merit", "marked", "precision_without_p2")
    columns = [("Operation", _case), ("Noise, sigma", _key("sigma")),
               *((name.replace("_", " ").capitalize().replace("p2", "P2"), _key(name, ".3f"))
                 for name in rates)]
    rows = sorted(data["rows"], key=lambda row: (row["operation"], row["sigma"]))
    yield _table("Edges against true contours",
                 f"The gradient threshold P1 is {data['gradient_threshold']}, the brightness "
                 f"threshold P2 {data['brightness_threshold']}; means over "
                 f"{counted(data['seeds'], 'seed')} of the noise. Edges and contours match at a "
                 "distance of one pixel or less. Marked: edge pixels of all pixels. Figure of "
                 "merit: Pratt's, against contours one pixel wide.", columns, rows, data)


def _literal_holes(data: Json) -> Iterator[Table]:
    columns = [("Images", _key("pictures")), ("Tried", _key("tried")), ("Right", _key("right")),
               ("Rejected", _key("rejected")), ("Holes", _key("true_holes")),
               ("Counted", _key("counted"))]
    yield _table("Holes by the scan as published",
                 "The relabelling scan counts every contour but one as a hole, so each object "
                 "beyond the first adds one; it rejects images that need more than 254 grey levels. "
                 "Holes and counted are of the first image on which it is wrong, or of the last.",
                 columns, data["rows"], data)


def _quantisation(data: Json) -> Iterator[Table]:
    columns = [("Weights", _key("weights")), ("Fractional bits", _key("fractional_bits")),
               ("Right, sigmoid", _key("right_sigmoid")), ("Right, linear", _key("right_linear")),
               ("Largest integer", _key("largest_integer"))]
    yield _table("The nets in fixed point",
                 f"How many of {data['descriptors']} neighbourhoods the two-layer net of Table 1 "
                 "decides as the rule does, by the fractional bits of its weights.",
                 columns, data["rows"], data)


def _hidden_neurons(data: Json) -> Iterator[Table]:
    columns = [("Hidden neurons", _key("hidden")), ("Best, right", _key("best")),
               ("Median, right", _key("median", "g")),
               (f"Starts that reach {data['descriptors']}", _key("seeds_with_all_right")),
               ("Their median epochs", lambda row: f"{row['median_epochs_of_those']:g}"
                if row["seeds_with_all_right"] else NOTHING)]
    yield _table("Hidden neurons",
                 f"How many of {data['descriptors']} neighbourhoods nets learn, from "
                 f"{counted(data['seeds'], 'random start')} each.", columns, data["rows"], data)


def _cluster_runs(data: Json) -> Iterator[Table]:
    columns = [("First descriptor", _key("first")), ("Last", _key("last")),
               ("Epochs", _key("epochs")), ("Largest weight", _key("largest_weight"))]
    yield _table("Single-layer nets that the rule needs",
                 f"{len(data['rows'])} nets, each for the longest run of descriptors that one "
                 "neuron can learn. One descriptor more is inseparable each time, so no other cut "
                 "takes fewer.", columns, data["rows"], data)


KINDS = ("logical", "comparisons", "additions", "multiplications", "divisions", "powers",
         "arithmetic")


def _operation_counts(data: Json) -> Iterator[Table]:
    def both(kind: str) -> Callable[[Json], str]:
        return lambda row: f"{row['sums'][kind]}" + (
            f" + {row['activations'][kind]}" if row["activations"][kind] else "")
    columns = [("Method", _key("method")), ("The paper", lambda row: row["paper"] or NOTHING),
               *((kind.capitalize(), both(kind)) for kind in KINDS)]
    gates = "; ".join(f"{size['gates']} gates of {words} inputs and {size['inverters']} inverters"
                      for words, size in (("two", data["circuit"]["two_input"]),
                                          ("three", data["circuit"]["three_input"])))
    yield _table("Operation counts",
                 f"Counted by running each method, per {data['per']}. Two numbers are of sums + of "
                 f"activations. As a circuit the rule takes {gates}.", columns, data["methods"], data)


_MAKERS: dict[str, Callable[[Json], Iterator[Table]]] = {
    "quality": _quality, "edge-quality": _edge_quality, "literal-holes": _literal_holes,
    "quantisation": _quantisation, "hidden-neurons": _hidden_neurons,
    "cluster-runs": _cluster_runs, "operation-counts": _operation_counts}
