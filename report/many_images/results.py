"""The CSV file: the time of each quantity, its interval, and ratios."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

import pandas as pd

from report.errors import ReportError
from report.files import read_bytes
from report.many_images.steps import QUANTITIES, Step, row_of
from report.measure.estimates import Estimates, Time, ratio_of

CSV = "many_images.csv"


@dataclass(frozen=True)
class Origin:
    """Where the figures were measured."""

    commit: str
    machine: str
    processor: str
    cores: int


@dataclass(frozen=True)
class Result:  # pylint: disable=too-many-instance-attributes
    """A quantity of a step; `time`, `high` and `typical` are those of report.measure.estimates, and
    the ratio is that of its time to the base's, none for the base itself."""

    experiment: str
    method: str
    x: int
    quantity: str
    time: float
    high: float
    typical: float
    base: str
    ratio: float | None
    ratio_low: float | None
    ratio_high: float | None
    rounds: int
    flags: str
    commit: str
    machine: str
    processor: str
    cores: int


def results_of(steps: list[Step], samples: pd.DataFrame, origin: Origin) -> list[Result]:
    """A result for each quantity of each step."""
    times = Estimates(samples)
    return [_result(step, quantity, times.time(name), times.time(row_of(step.base, quantity)), origin)
            for step in steps for quantity in QUANTITIES if (name := row_of(step.key, quantity)) in times]


def _result(step: Step, quantity: str, own: Time, base: Time, origin: Origin) -> Result:
    ratio = ratio_of(own, base)
    ratios = (None, None, None) if step.base == step.key else (ratio.value, ratio.low, ratio.high)
    base_name = f"{step.base.method}, {step.base.x}" if step.base.x else step.base.method
    return Result(*step.key, quantity, own.value, own.high, own.typical, base_name,
                  *ratios, own.processes, "" if own.settled and base.settled else "open", **asdict(origin))


def series(results: list[Result], experiment: str, quantity: str) -> dict[str, list[Result]]:
    """By method, in the order of the file."""
    found: dict[str, list[Result]] = {}
    for one in results:
        if (one.experiment, one.quantity) == (experiment, quantity):
            found.setdefault(one.method, []).append(one)
    return found


def to_csv(results: Iterable[Result]) -> str:
    """Four digits; empty where there is no ratio."""
    stream = io.StringIO()
    names = [field.name for field in fields(Result)]
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(names)
    writer.writerows([_text(getattr(one, name)) for name in names] for one in results)
    return stream.getvalue()


def _text(value: Any) -> str:
    return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


def read_csv(path: Path) -> list[Result]:
    """Raises ReportError where the file is no such table."""
    try:
        lines = csv.DictReader(io.StringIO(read_bytes(path).decode()))
        return [Result(**{field.name: _value(line[field.name], str(field.type))
                          for field in fields(Result)}) for line in lines]
    except (ValueError, LookupError, TypeError) as error:
        raise ReportError(f"{path}: not such a table: {error}") from None


def _value(text: str, kind: str) -> Any:
    if kind == "str":
        return text
    return int(text) if kind == "int" else float(text) if text else None
