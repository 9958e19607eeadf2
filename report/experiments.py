"""Reads what DIR/experiments holds of the paper's experiments; every file may be absent."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from report.batches import Batches, parse_batches
from report.cluster_runs import ClusterRuns, parse_cluster_runs
from report.errors import ReportError
from report.json_fields import Fields, read_object
from report.literal_holes import LiteralHoles, parse_literal_holes
from report.quality import Quality, parse_quality

KINDS = ("logical", "comparisons", "additions", "multiplications", "divisions", "powers",
         "arithmetic")
"""Kinds of operations that are counted; the last sums up the four before it."""

Loaded = TypeVar("Loaded")


@dataclass(frozen=True)
class PaperRow:
    """A row of the paper's Table 2, and the operation that stands for it here."""

    method: str
    operation: str
    seconds: float
    ratio: float


@dataclass(frozen=True)
class TableTwo:
    """The paper's Table 2."""

    command: str
    image: str
    machine: str
    rows: tuple[PaperRow, ...]


@dataclass(frozen=True)
class FixedPoint:
    """Neighbourhoods judged right by a net whose weights keep so many fractional bits."""

    weights: str
    fractional_bits: int
    right: dict[str, int]
    """By the activation's name."""
    largest_integer: int


@dataclass(frozen=True)
class Quantisation:
    """The recognition rate under fixed point."""

    command: str
    descriptors: int
    rows: tuple[FixedPoint, ...]
    as_published: dict[str, int]
    """With the weights of Table 1 themselves, by the activation's name; empty in older files."""


@dataclass(frozen=True)
class Trained:
    """What the seeds reached with one number of hidden neurons."""

    hidden: int
    best: int
    median: float
    seeds_with_all_right: int
    median_epochs_of_those: float


@dataclass(frozen=True)
class HiddenNeurons:
    """Hidden neurons against recognition rate, by number of hidden neurons."""

    command: str
    descriptors: int
    seeds: int
    rows: tuple[Trained, ...]


@dataclass(frozen=True)
class Counted:
    """Operations of one method, those of sums and of activations apart."""

    method: str
    paper: str
    sums: dict[str, int]
    activations: dict[str, int]

    @property
    def arithmetic(self) -> int:
        """All arithmetic operations."""
        return self.sums["arithmetic"] + self.activations["arithmetic"]


@dataclass(frozen=True)
class Gates:
    """The size of a circuit."""

    gates: int
    inverters: int


@dataclass(frozen=True)
class OperationCounts:
    """Operations of each method, and the circuit to which the rule and the nets compile."""

    command: str
    per: str
    methods: tuple[Counted, ...]
    circuit: dict[str, Gates]
    """By the inputs of a gate, in words."""
    nets: dict[str, bool]
    """Whether a net compiles to the rule, by its name."""


@dataclass(frozen=True)
class EdgeRates:
    """How well the edges of one operation match the true contours at one noise."""

    operation: str
    sigma: int
    precision: float
    recall: float
    figure_of_merit: float
    marked: float
    """Edge pixels of all pixels."""
    precision_without_p2: float


@dataclass(frozen=True)
class EdgeQuality:
    """Every operator at every noise."""

    command: str
    gradient_threshold: int
    brightness_threshold: int
    seeds: int
    rows: tuple[EdgeRates, ...]


@dataclass(frozen=True)
class Experiments:
    """Those that were made."""

    table_two: TableTwo | None = None
    quantisation: Quantisation | None = None
    hidden_neurons: HiddenNeurons | None = None
    operation_counts: OperationCounts | None = None
    edge_quality: EdgeQuality | None = None
    quality: Quality | None = None
    literal_holes: LiteralHoles | None = None
    cluster_runs: ClusterRuns | None = None
    batches: Batches | None = None


def load_experiments(directory: Path) -> Experiments:
    """Whatever is in the folder `experiments` of `directory`."""
    return Experiments(_load(directory, "table-2", _table_two),
                       _load(directory, "quantisation", _quantisation),
                       _load(directory, "hidden-neurons", _hidden_neurons),
                       _load(directory, "operation-counts", _operation_counts),
                       _load(directory, "edge-quality", _edge_quality),
                       _load(directory, "quality", parse_quality),
                       _load(directory, "literal-holes", parse_literal_holes),
                       _load(directory, "cluster-runs", parse_cluster_runs),
                       _load(directory, "batches", parse_batches))


def _load(directory: Path, name: str, parse: Callable[[Fields], Loaded]) -> Loaded | None:
    path = directory / "experiments" / f"{name}.json"
    if not path.exists():
        return None
    fields = read_object(path)
    fields.check_schema()
    if fields.text("experiment") != name:
        raise ReportError(f"{fields.where}: experiment is '{fields.text('experiment')}'; "
                          f"it must be '{name}'")
    return parse(fields)


def _count_to(fields: Fields, key: str, most: int) -> int:
    fields.at_most(key, most)
    return fields.count(key)


def _truth(fields: Fields, key: str) -> bool:
    value = fields.data.get(key)
    if not isinstance(value, bool):
        raise ReportError(f"{fields.where}: {key} is {value!r}; it must be true or false")
    return value


def _table_two(fields: Fields) -> TableTwo:
    rows = tuple(PaperRow(row.text("method"), row.text("operation"),
                          row.positive("paper_seconds"), row.positive("paper_ratio"))
                 for row in fields.some("rows"))
    return TableTwo(fields.text("command"), fields.text("image"), fields.text("machine"), rows)


def _quantisation(fields: Fields) -> Quantisation:
    total = fields.count("descriptors", 1)
    rows = tuple(FixedPoint(row.text("weights"), row.count("fractional_bits"), _right(row, total),
                            row.count("largest_integer"))
                 for row in fields.some("rows"))
    key = fields.renamed("as_published", "as_printed")
    published = _right(fields.child(key), total) if fields.has(key) else {}
    return Quantisation(fields.text("command"), total, rows, published)


def _right(fields: Fields, total: int) -> dict[str, int]:
    return {"sigmoid": _count_to(fields, "right_sigmoid", total),
            "linear threshold": _count_to(fields, "right_linear", total)}


def _hidden_neurons(fields: Fields) -> HiddenNeurons:
    total, seeds = fields.count("descriptors", 1), fields.count("seeds", 1)
    rows = [Trained(row.count("hidden"), _count_to(row, "best", total),
                    row.at_most("median", total), _count_to(row, "seeds_with_all_right", seeds),
                    row.number("median_epochs_of_those"))
            for row in fields.some("rows")]
    return HiddenNeurons(fields.text("command"), total, seeds,
                         tuple(sorted(rows, key=lambda row: row.hidden)))


def _operation_counts(fields: Fields) -> OperationCounts:
    methods = tuple(_counted(method) for method in fields.some("methods"))
    circuit = fields.child("circuit")
    gates = {words: Gates(circuit.child(key).count("gates"), circuit.child(key).count("inverters"))
             for words, key in (("two", "two_input"), ("three", "three_input"))}
    nets = {net.text("net"): _truth(net, "compiles_to_the_rule")
            for net in fields.children("nets")}
    return OperationCounts(fields.text("command"), fields.text("per"), methods, gates, nets)


def _edge_quality(fields: Fields) -> EdgeQuality:
    rows = tuple(EdgeRates(row.text("operation"), row.count("sigma"),
                           *(row.at_most(key, 1) for key in (
                               "precision", "recall", "figure_of_merit", "marked",
                               "precision_without_p2")))
                 for row in fields.some("rows"))
    return EdgeQuality(fields.text("command"), fields.count(fields.renamed("gradient_threshold", "p1")),
                       fields.count(fields.renamed("brightness_threshold", "p2")),
                       fields.count("seeds", 1), rows)


def _counted(fields: Fields) -> Counted:
    sums, activations = ({kind: fields.child(part).count(kind) for kind in KINDS}
                         for part in ("sums", "activations"))
    paper = fields.text("paper") if fields.data.get("paper") else ""
    return Counted(fields.text("method"), paper, sums, activations)
