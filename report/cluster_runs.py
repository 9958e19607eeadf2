"""How many single-layer nets the rule needs: the experiment's file and its table."""

from __future__ import annotations

from dataclasses import dataclass

from report.experiment_layout import Table, columns
from report.json_fields import Fields


@dataclass(frozen=True)
class LearntRun:
    """Descriptors that one neuron has learnt."""

    first: int
    last: int
    epochs: int
    largest_weight: int


@dataclass(frozen=True)
class ClusterRuns:
    """As few runs as can be."""

    command: str
    rows: tuple[LearntRun, ...]


def parse_cluster_runs(fields: Fields) -> ClusterRuns:
    """What a file of this experiment holds."""
    return ClusterRuns(fields.text("command"), tuple(
        LearntRun(*(row.count(key) for key in ("first", "last", "epochs", "largest_weight")))
        for row in fields.some("rows")))


def cluster_runs_table(data: ClusterRuns) -> Table:
    """A row for each net."""
    header = columns([], ["First descriptor", "Last", "Epochs", "Largest weight"])
    rows = tuple((str(row.first), str(row.last), str(row.epochs), str(row.largest_weight))
                 for row in data.rows)
    sentence = (f"{len(data.rows)} nets, each for the longest run of descriptors that a single "
                "neuron can learn. One descriptor more is proved inseparable each time, and a part "
                "of a separable run is separable, so no other cut takes fewer.")
    return Table("Single-layer nets that the rule needs", sentence, header, rows, data.command)
