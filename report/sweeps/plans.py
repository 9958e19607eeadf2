"""What is swept: the inputs and the rows of each sweep."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from report.measure.timings import REFERENCE, Row

DRAWN = ("thin_guo_hall", "thin_naccache_shinghal", "midpoint_scan", "edges_sobel", "holes",
         "localise_objects")
THINNING = ("thin_guo_hall", "thin_zhang_suen", "thin_naccache_shinghal", "thin_spta_directional",
            "thin_mb2")
NOISE = ("thin_guo_hall", "thin_zhang_suen", "thin_naccache_shinghal", "thin_mb2", "midpoint_scan", "edges_sobel",
         "holes", "objects", "fill_holes", "euler_number", "label_image", "label_objects", "label_regions",
         "localise_objects", "squared_distances", "skeleton_graph")
"""Of every family."""

AWKWARD_SIDES = (33, 63, 65, 100, 127, 511, 513, 1000, 1023, 1025, 2049)
"""At the ends of words and cache lines, and just beyond."""

Place = float | str


@dataclass(frozen=True)
class Sweep:
    """`inputs` makes names of drawn inputs, of the quick sweep or the full one."""

    name: str
    what: str  # the values that are swept, as the axis of a plot says it
    operations: tuple[str, ...]
    inputs: Callable[[bool], list[str]]
    place: Callable[[Row], Place]  # the value of a row
    variants: str = "best"
    threads: str = "1"  # regular expression
    max_call: float = 0.01
    """Slower rows are verified, but not measured. It keeps long references out, which would take
    most of the time."""


def density_inputs(quick: bool) -> list[str]:
    """Noise without its extremes: a full square belongs to the sweep of depths."""
    side, blocks, percents = ((512, (1, 4, 16), (10, 50, 90)) if quick else
                              (1024, (1, 4, 8, 16), (10, 25, 50, 75, 90)))
    return [f"noise_{side}_{percent}_{block}" for block in blocks for percent in percents]


def size_inputs(quick: bool) -> list[str]:
    """Powers of two and awkward sides."""
    largest = 512 if quick else 4096
    sides = sorted({*AWKWARD_SIDES, *(32 << step for step in range(8))})
    return [f"square_{side}" for side in sides if side <= largest + 1]


def depth_inputs(quick: bool) -> list[str]:
    """Squares that iterations have to erode."""
    side = 512 if quick else 1024
    return [f"squares_{side}_{4 << step}" for step in range(5 if quick else 7)]


def _number(row: Row, index: int) -> float:
    return float(re.findall(r"\d+", row.input)[index])


SWEEPS = (
    Sweep("density", "foreground blocks of the noise, %", NOISE, density_inputs,
          lambda row: _number(row, 1), max_call=0.03),
    Sweep("size", "side of the square, pixels", DRAWN, size_inputs,
          lambda row: row.width, max_call=0.03),
    Sweep("threads", "threads", DRAWN, lambda quick: ["scene"] if quick else ["scene", "tiled_5"],
          lambda row: row.threads, threads="[0-9]+", max_call=0.03),
    Sweep("depth", "side of the foreground squares, pixels", (*THINNING, "midpoint_scan"),
          depth_inputs, lambda row: _number(row, 1)),
    Sweep("enlarged", "times that the scene is enlarged", (*THINNING, "holes"),
          lambda quick: [f"enlarged_{times}" for times in ((1, 2) if quick else (1, 2, 4))],
          lambda row: _number(row, 0), max_call=0.03),
    Sweep("isa", "ISA", ("thin_zhang_suen", *DRAWN), lambda quick: ["scene"],
          lambda row: row.isa, variants="all", max_call=0.03),
)
BY_NAME = {sweep.name: sweep for sweep in SWEEPS}


def thread_steps(cores: int) -> list[int]:
    """2, 3 ... 8, then half as many more each time, up to all cores; 2 on a single core."""
    steps = []
    threads = 2
    while threads < cores:
        steps.append(threads)
        threads += 1 if threads < 8 else threads // 2
    return [*steps, max(cores, 2)]


def plan_words(sweep: Sweep, quick: bool, cores: int) -> list[str]:
    """The options of `thinbench_benchmarks`."""
    names = f"^({'|'.join(sweep.operations)})/.*/{sweep.threads}/end_to_end/"
    words = ["--no-peers", "--variants", sweep.variants, "--max-call", str(sweep.max_call), "--filter", names]
    words += _repeated("--input", sweep.inputs(quick))
    return words + (_repeated("--threads", thread_steps(cores)) if sweep.threads != "1" else [])


def _repeated(option: str, values: Iterable[object]) -> list[str]:
    return [word for value in values for word in (option, str(value))]


def curve_of(row: Row) -> str:
    """Rows of one sweep and case belong to one curve where this is equal."""
    if row.sweep == "isa" or row.technique == REFERENCE:
        return row.technique
    name = f"{row.technique}/{row.isa}"
    if row.sweep == "density":
        return f"{name}, blocks of {_number(row, 2):g}"
    return f"{name}, {row.input}" if row.sweep == "threads" else name
