"""A table and a contact sheet of skeletons for each input."""

from __future__ import annotations

from pathlib import Path

from report.experiment_layout import Table, columns
from report.plot_skeletons import plot_skeletons
from report.quality import Quality, Skeleton

HEADER = columns(["Case"], ["Objects", "Holes", "Pixels", "2×2 blocks", "Ends", "Branches",
                                 "Mean distance", "Largest", "Least symmetry", "Iterations"])
TURNS = {1: "one rotation, by 90 degrees", 3: "rotations by 90, 180 and 270 degrees"}


def make_quality_tables(quality: Quality, directory: Path) -> list[Table]:
    """One for each input; the pictures are read from the run's folder."""
    return [_table(quality, name, directory) for name in quality.inputs]


def _table(quality: Quality, name: str, directory: Path) -> Table:
    rows = [row for row in quality.rows if row.input == name]
    plot = plot_skeletons(name, rows, directory / "pictures", quality.symmetry_field)
    return Table(f"Skeletons of {name}", _sentence(rows, quality.turns), HEADER, tuple(map(_cells, rows)),
                 quality.command, plot=plot)


def _sentence(rows: list[Skeleton], turns: int) -> str:
    broken = [row.case.name for row in rows if not row.keeps_topology]
    said = (f"Objects or holes are not as many as before with {', '.join(broken)}." if broken else
            "Every case leaves as many objects and holes as there were.")
    return (f"{said} Objects are 8-connected, holes 4-connected. Distances, in pixels, are from "
            "the medial axis: the ridge of the exact Euclidean distance to the background, where it rises "
            "by less than 0.8 per pixel in every direction. Least symmetry: the smallest overlap with "
            f"the skeleton of the rotated input, rotated back, over {TURNS[turns]}; 1 is none lost.")


def _cells(row: Skeleton) -> tuple[str, ...]:
    return (row.case.name, _change(row.objects), _change(row.holes), f"{row.pixels:,}",
            f"{row.blocks:,}", f"{row.ends:,}", f"{row.branches:,}", f"{row.mean_distance:.3f}",
            f"{row.largest_distance:.2f}", f"{row.least_symmetry:.3f}", str(row.iterations))


def _change(counts: tuple[int, int]) -> str:
    before, after = counts
    return f"{before:,}" if before == after else f"{before:,} → {after:,}"
