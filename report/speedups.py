"""Reads speedups.csv, the speed-ups that were measured in pairs, where a run has it."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

from report.cases import case_in, isa_label, place_of_peer
from report.errors import ReportError
from report.json_fields import Fields
from report.model import SCOPES, PairedRatio, RowName

CSV = "speedups.csv"
REFERENCE = "reference"
COLUMNS = ("operation", "technique", "isa", "threads", "scope", "input", "against", "ratio", "low",
           "high", "processes", "flags", "clock", "layout", "output_hash", "verified")


def load_speedups(directory: Path) -> dict[RowName, PairedRatio]:
    """Ratios to the references by row; none for runs from before there were any."""
    path = directory / CSV
    if not path.exists():
        return {}
    try:
        reader = csv.DictReader(io.StringIO(path.read_text(encoding="utf-8")), strict=True)
        lines = list(reader)
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, csv.Error) as error:
        raise ReportError(f"{path}: not a table: {error}; measure it again") from None
    missing = [column for column in COLUMNS if column not in (reader.fieldnames or ())]
    if missing:
        raise ReportError(f"{path}: column '{missing[0]}' is missing; it must be given")
    found = (_read(line, f"{path}: line {number}") for number, line in enumerate(lines, 2)
             if line["against"] == REFERENCE)
    return {name: ratio for name, ratio in found if not _is_misplaced(name)}


def _is_misplaced(name: RowName) -> bool:
    """True for a peer that was compared with a reference to which it is not equal."""
    return place_of_peer(name.case, name.technique) != name.case


def _read(line: dict[str, str], where: str) -> tuple[RowName, PairedRatio]:
    if any(value is None for value in line.values()):
        raise ReportError(f"{where}: fields are missing; measure it again")
    if line["scope"] not in SCOPES:
        raise ReportError(f"{where}: scope is '{line['scope']}'; it must be "
                          f"{' or '.join(SCOPES)}")
    for column in ("clock", "layout", "output_hash"):
        if not line[column]:
            raise ReportError(f"{where}: {column} is ''; it must be given")
    if line["verified"] != "1":
        raise ReportError(f"{where}: verified is '{line['verified']}'; it must be 1")
    name = RowName(case_in(Fields(line, where)), line["technique"], isa_label(line["isa"]),
                   int(_positive(line, "threads", where)), line["scope"], line["input"])
    low, ratio, high = (_positive(line, column, where) for column in ("low", "ratio", "high"))
    if not low <= ratio <= high:
        raise ReportError(f"{where}: ratio {ratio:g} is not between low {low:g} and "
                          f"high {high:g}; it must be")
    flags = tuple(flag for flag in line["flags"].split(";") if flag)
    return name, PairedRatio(ratio, low, high, int(_positive(line, "processes", where)), flags)


def _positive(line: dict[str, str], column: str, where: str) -> float:
    try:
        value = float(line[column])
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise ReportError(f"{where}: {column} is '{line[column]}'; it must be a number above zero")
    return value
