"""Which operations there are for readers: their order, their words, and what to quote of each."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from report.measure.run import Run
from report.measure.timings import END_TO_END, Row

COPIES = ("copy", "copy_bits", "read_bits")
"""Peers that are lower bounds: the image copied or read."""

COPIED_ALIKE = ("thin_", "midpoint_scan", "net_")
"""Cases that all read one byte per pixel and write one: the copy of one is that of the others."""

ARITHMETIC = ("simd_float_bits", "simd_fixed_point", "autovec")
"""Techniques that evaluate a net's sums and activations for every pixel."""

PRINTED_RULE = "thin_naccache_shinghal"

LABELS = {
    "thin_guo_hall": "Guo-Hall", "thin_zhang_suen": "Zhang-Suen",
    "thin_mb2": "MB2", "thin_spta_directional": "SPTA, directional",
    "thin_spta": "SPTA, sequential", "thin_lu_wang": "Lü-Wang", "thin_guo_hall_skimage": "Guo-Hall as in scikit-image",
    "thin_zhang_suen_skimage": "Zhang-Suen as in scikit-image",
    PRINTED_RULE: "the paper's rule", "midpoint_scan": "midpoint scan",
    "edges_sobel": "Sobel edges", "edges_prewitt": "Prewitt edges",
    "edges_roberts4": "Roberts edges, 2 × 2", "edges_roberts9": "Roberts edges, 3 × 3",
    "edges_mero_vassy": "Mero-Vassy edges, 3 × 3", "edges_mero_vassy_5x5": "Mero-Vassy edges, 5 × 5",
    "holes": "objects and holes", "objects": "objects", "fill_holes": "filled holes",
    "fill_holes_4": "filled holes, 4-conn.",
    "label_image": "label image", "label_image_4": "label image, 4-conn.",
    "label_objects": "label image and objects", "label_objects_4": "label image and objects, 4-conn.",
    "label_regions": "label image, objects and holes",
    "euler_number": "Euler number, 8-conn.", "euler_number_4": "Euler number, 4-conn.",
    "localise_objects": "grey image to centres",
    "batch_guo_hall": "many images, Guo-Hall", "batch_zhang_suen": "many images, Zhang-Suen",
    "batch_naccache_shinghal": "many images, the paper's rule",
    "skeleton_graph": "skeleton to graph", "squared_distances": "squared distances",
    "net_two_layer_linear": "two-layer net, linear", "net_two_layer_sigmoid": "two-layer net, sigmoid",
    "net_two_layer_rounded": "two-layer net, rounded", "net_single_layer_cluster": "cluster of nets"}
"""In the order of the page: useful rules, the paper's, edges, regions, graphs, nets."""

HEADLINES = (
    "thin_guo_hall", "thin_guo_hall:keep", "thin_zhang_suen", "thin_zhang_suen:keep", "thin_mb2",
    PRINTED_RULE, "midpoint_scan", "edges_sobel", "holes", "label_image", "euler_number", "localise_objects",
    "net_two_layer_linear")
"""Cases of the first table."""


@dataclass(frozen=True)
class Headline:
    """What to quote of one case: end to end and on one thread."""

    case: str
    label: str
    best: Row
    """The library's choice."""
    scalar: Row | None
    """The fastest variant without vectors."""
    avx2: Row | None
    peer: Row | None
    copy: Row | None

    @property
    def operation(self) -> str:
        """Without options."""
        return self.best.operation

    @property
    def over_scalar(self) -> float | None:
        """What vectors add."""
        return self.scalar.time_ns / self.best.time_ns if self.scalar else None

    @property
    def copy_share(self) -> float | None:
        """How much of the row's time a copy of its bytes takes."""
        return self.copy.time_ns / self.best.time_ns if self.copy else None


class Rows:
    """Rows of a run on its main image, which is the first that was not drawn for a series."""

    def __init__(self, run: Run) -> None:
        inputs = [item["name"] for item in run.facts["inputs"]]
        self.run = run
        self.rows = [row for row in run.rows if not row.sweep]
        timed = {row.input for row in self.rows}
        found = [name for name in inputs if name in timed]
        images = [name for name in found if not is_square(name)]
        self.input = (images or found or [""])[0]
        self.equal_peers = {peer["technique"] for peer in run.facts["peers"]
                            if peer["equal_output"]}
        self.cases = sorted({row.case for row in self.rows}, key=place)

    def of(self, case: str, image: str = "") -> list[Row]:
        """End to end and on one thread, as tables quote them."""
        return [row for row in self.rows if row.case == case and row.input == (image or self.input)
                and row.threads == 1 and row.scope == END_TO_END]

    def own(self, case: str) -> list[Row]:
        """This project's variants among them."""
        return [row for row in self.of(case) if not (row.peer or row.is_reference)]

    def reference(self, case: str) -> Row | None:
        """The scalar reference."""
        return next((row for row in self.of(case) if row.is_reference), None)

    def headline(self, case: str) -> Headline | None:
        """None where nothing can be quoted."""
        own = self.own(case)
        best = next((row for row in own if row.default), None) or fastest(own)
        if best is None:
            return None
        avx2 = fastest(row for row in own if row.isa == "avx2")
        peer = next((row for row in self.of(case) if row.peer and best.peer_name
                     and row.technique == best.peer_name), None)
        scalar = fastest(row for row in own if row.scalar)
        return Headline(case, label(case), best, scalar, avx2, peer, self.copy(case))

    def headlines(self, cases: Iterable[str] = HEADLINES) -> list[Headline]:
        """Those that were measured; all cases where none of these was."""
        found = [line for line in map(self.headline, cases) if line]
        return found or [line for line in map(self.headline, self.cases) if line]

    def copy(self, case: str) -> Row | None:
        """The lower bound of a case, measured with it or with another that moves the same bytes."""
        bounds = [row for row in self.rows if row.input == self.input and row.scope == END_TO_END]
        own = (row for row in bounds if row.case == case and row.technique in COPIES)
        other = fastest(row for row in bounds if row.technique == "copy"
                        and case.startswith(COPIED_ALIKE))
        return next(own, None) or (other and replace(
            other, operation=case.partition(":")[0], speedup_vs_reference=None, speedup_low=None,
            speedup_high=None))


def fastest(rows: Iterable[Row]) -> Row | None:
    """The row of the shortest time, if there are rows."""
    own = list(rows)
    return min(own, key=lambda row: row.time_ns) if own else None


def is_square(name: str) -> bool:
    """Whether it is an image of the series of sizes."""
    return name.startswith("square_")


def place(case: str) -> tuple[int, str]:
    """Sorts cases as LABELS does."""
    operation = case.partition(":")[0]
    order = list(LABELS)
    return (order.index(operation) if operation in order else len(order)), case


def label(case: str) -> str:
    """A case in few words, for tables."""
    operation, *options = case.split(":")
    words = [LABELS.get(operation, operation.replace("_", " "))]
    words += ["border kept" if option == "keep" else f"{option} iteration{'' if option == '1' else 's'}" for option in options]
    return ", ".join(words)


def title(case: str) -> str:
    """A case in words, for headings."""
    words = label(case)
    if case == PRINTED_RULE:
        return "thinning by the paper's rule"
    first, comma, rest = words.partition(",")
    return f"{first} thinning{comma}{rest}" if case.startswith("thin_") else words


def peer_title(run: Run, technique: str) -> str:
    """The name and version of a peer, such as OpenCV 4.6.0."""
    about = next((peer["about"] for peer in run.facts["peers"] if peer["technique"] == technique),
                 technique)
    return str(about).partition(",")[0]
