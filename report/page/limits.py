"""limits.json: the instructions of rows on one thread, and the least time that they take."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

from report.errors import ReportError
from report.files import read_json
from report.formatting import NOTHING, duration
from report.measure.sampler import Json

FILE = "limits.json"
HEADER = ("Variant", "Scope", "Instructions", "Per cycle", "Time", "Lower bound", "Reached")


@dataclass(frozen=True)
class Limits:
    """Table rows by operation."""

    sentence: str
    rows: dict[str, list[tuple[str, ...]]]


def load_limits(directory: Path) -> Limits:
    """Without rows where nothing was counted."""
    path = directory / FILE
    if not path.exists():
        return Limits("", {})
    data = read_json(path)
    rows: dict[str, list[tuple[str, ...]]] = defaultdict(list)
    try:
        for row in sorted(data["rows"], key=lambda row: row["ns"]):
            rows[row["operation"]].append(_cells(row))
        width = f"{data['issue_width']:g}"
    except (KeyError, TypeError) as error:
        raise ReportError(f"{path}: no list of lower bounds: {error} is missing") from None
    return Limits(f"Instructions were counted exactly. The bound assumes a core that issues {width} "
                  "instructions in every cycle, which was not measured.", rows)


def _cells(row: Json) -> tuple[str, ...]:
    name = "/".join(row["row"].split("/")[:3])
    per_cycle = row.get("instructions_per_cycle")
    return (name, row["scope"].replace("_", " "), f"{row['instructions']:,}",
            NOTHING if per_cycle is None else f"{per_cycle:.2f}", duration(row["ns"]),
            duration(row["limit_ns"]), f"{row['percent_of_limit']:.0f} %")
