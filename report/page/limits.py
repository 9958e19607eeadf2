"""limits.json: the instructions of rows on one thread, and the clock cycles that they take."""

from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

from report.errors import ReportError
from report.files import read_json
from report.formatting import NOTHING, duration
from report.measure.sampler import Json

FILE = "limits.json"
SCHEMA = 2
HEADER = ("Variant, end to end", "Instructions", "Time", "Cycles", "Per cycle")
MODEL_HEADER = ("Cycles of the model", "Of measured")


@dataclass(frozen=True)
class Limits:
    """Table rows by operation, and what they were measured on."""

    counted: str = ""
    sentence: str = ""
    header: tuple[str, ...] = HEADER
    rows: dict[str, list[tuple[str, ...]]] = field(default_factory=dict)


def load_limits(directory: Path) -> Limits:
    """Without rows where nothing was counted, or by a version that assumed a bound."""
    path = directory / FILE
    data = read_json(path) if path.exists() else {}
    if not isinstance(data, dict):
        raise ReportError(f"{path}: expected an object, got {type(data).__name__}")
    if data.get("schema") != SCHEMA:
        return Limits()
    rows: dict[str, list[tuple[str, ...]]] = defaultdict(list)
    try:
        has_model = any("model_cycles" in row for row in data["rows"])
        for row in sorted(data["rows"], key=lambda row: row["ns"]):
            rows[row["operation"]].append(_cells(row) + (_model_cells(row) if has_model else ()))
        return Limits(_counted(data["input"]), _sentence(data),
                      HEADER + (MODEL_HEADER if has_model else ()), rows)
    except (KeyError, TypeError) as error:
        raise ReportError(f"{path}: no list of clock cycles: {error} is missing") from None


def _counted(image: Json) -> str:
    """The image, which is not the one that the rest of the page is about."""
    strip = re.fullmatch(r"(.*)_(\d+)_rows", image["name"])
    what = f"the middle {strip[2]} rows of {strip[1]}" if strip else image["name"]
    return f"{what}, {image['width']} × {image['height']} pixels"


def _sentence(data: Json) -> str:
    text = ("Calls were timed, and their instructions counted, on these pixels alone. A clock cycle "
            f"took {data['cycle_ns']:.3f} ns, to which the other times of this page are not scaled. ")
    kind, _, why = data["model"].partition("none: ")
    if why:
        return f"{text}There is no model to compare with: {why}."
    return (f"{text}The model ({kind}) gets the same instructions in the same order, finds all data "
            "in the nearest cache and predicts every jump.")


def _cells(row: Json) -> tuple[str, ...]:
    name = "/".join(row["row"].split("/")[:3])
    return (name, f"{row['instructions']:,}", duration(row["ns"]), f"{row['cycles']:,.0f}",
            f"{row['instructions_per_cycle']:.2f}")


def _model_cells(row: Json) -> tuple[str, ...]:
    cycles = row.get("model_cycles")
    if cycles is None:
        return (NOTHING, NOTHING)
    return (f"{cycles:,}", f"{100 * cycles / row['cycles']:.0f} %")
