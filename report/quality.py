"""How good the skeletons of each operation are, as the experiment left it."""

from __future__ import annotations

from dataclasses import dataclass

from report.cases import Case, case_in
from report.json_fields import Fields

LEAST, ONE_TURN = "least_symmetry", "symmetry"


@dataclass(frozen=True)
class Skeleton:
    """What was measured on the skeleton of one input by one case."""

    case: Case
    input: str
    objects: tuple[int, int]
    """Before and after, as are the holes."""
    holes: tuple[int, int]
    pixels: int
    blocks: int
    ends: int
    branches: int
    mean_distance: float
    largest_distance: float
    least_symmetry: float
    """The smallest overlap with the skeletons of the rotated input."""
    iterations: int

    @property
    def keeps_topology(self) -> bool:
        """True if there are as many objects and holes as before."""
        return self.objects[0] == self.objects[1] and self.holes[0] == self.holes[1]


@dataclass(frozen=True)
class Quality:
    """Every case on every input."""

    command: str
    rows: tuple[Skeleton, ...]
    turns: int = 3
    """By how many quarters the input was rotated at most; files of older versions: by one."""

    @property
    def symmetry_field(self) -> str:
        """What the file calls the overlap."""
        return ONE_TURN if self.turns == 1 else LEAST

    @property
    def inputs(self) -> list[str]:
        """Their names, in the order of the file."""
        return list(dict.fromkeys(row.input for row in self.rows))


def parse_quality(fields: Fields) -> Quality:
    """The experiment's file."""
    rows = fields.some("rows")
    older = not any(row.has(LEAST) for row in rows)
    return Quality(fields.text("command"),
                   tuple(_skeleton(row, ONE_TURN if older else LEAST) for row in rows),
                   1 if older else 3)


def _skeleton(row: Fields, symmetry: str) -> Skeleton:
    def change(of: str) -> tuple[int, int]:
        return row.count(f"{of}_before"), row.count(f"{of}_after")
    return Skeleton(case_in(row), row.text("input"), change("objects"), change("holes"),
                    row.count("pixels"), row.count("blocks"), row.count("ends"),
                    row.count("branches"),
                    row.number("mean_distance"), row.number("largest_distance"),
                    row.at_most(symmetry, 1), row.count("iterations", 1))
