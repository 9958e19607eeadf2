"""On which pictures the printed relabelling scan counts right: its file and its table."""

from __future__ import annotations

from dataclasses import dataclass

from report.experiment_layout import Table, columns, counted
from report.json_fields import Fields


@dataclass(frozen=True)
class LiteralCount:
    """How often the relabelling scan counts right on one kind of pictures."""

    pictures: str
    tried: int
    right: int
    refused: int
    true_holes: int
    """Of the first picture that is not right, or of the last one."""
    counted: int | None
    """On the same picture; None where it was refused."""


@dataclass(frozen=True)
class LiteralHoles:
    """The printed relabelling scan on several kinds of pictures."""

    command: str
    rows: tuple[LiteralCount, ...]


def parse_literal_holes(fields: Fields) -> LiteralHoles:
    """What a file of this experiment holds."""
    return LiteralHoles(fields.text("command"),
                        tuple(_count(row) for row in fields.some("rows")))


def _count(row: Fields) -> LiteralCount:
    tried = row.count("tried", 1)
    right, refused = (int(row.at_most(key, tried)) for key in ("right", "refused"))
    found = None if row.data.get("counted") is None else row.count("counted")
    return LiteralCount(row.text("pictures"), tried, right, refused, row.count("true_holes"), found)


def literal_holes_table(data: LiteralHoles) -> Table:
    """A row for each kind of pictures."""
    header = columns(["Pictures"], ["Tried", "Right", "Refused", "Holes", "Counted"])
    rows = tuple((row.pictures, str(row.tried), str(row.right), str(row.refused),
                  str(row.true_holes), "refused" if row.counted is None else str(row.counted))
                 for row in data.rows)
    always = sum(row.right == row.tried for row in data.rows)
    sentence = (f"The relabelling scan as printed counts right on all pictures of {always} of "
                f"{counted(len(data.rows), 'kind')}. Holes and Counted are of the first picture on "
                "which it is not right, or of the last one; refused are pictures that need more "
                "than 254 grey levels. It counts every contour but one as a hole, so each object "
                "beyond the first adds one. Behind walls of one or two pixels the contours of a "
                "hole and of its object touch and count as one.")
    return Table("Holes by the printed scan", sentence, header, rows, data.command)
