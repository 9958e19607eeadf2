"""The CSV file: medians over rounds, with intervals."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from statistics import median
from typing import Any

from report.errors import ReportError
from report.files import read_bytes
from report.measure.estimates import Estimate, interval_ranks
from report.many_images.steps import Figures, Samples, Step


@dataclass(frozen=True)
class Origin:
    """Where and beside what the figures were measured."""

    commit: str
    machine: str
    processor: str
    cores: int
    foreign_load: float  # mean number of processors that other processes kept busy


@dataclass(frozen=True)
class Result:  # pylint: disable=too-many-instance-attributes
    """A quantity of a step. The ratio is that of the step to its base, where both have the quantity
    and are not the same."""

    experiment: str
    method: str
    x: int
    quantity: str
    median: float
    low: float
    high: float
    base: str
    ratio: float | None
    ratio_low: float | None
    ratio_high: float | None
    rounds: int
    commit: str
    machine: str
    processor: str
    cores: int
    foreign_load: float


def results_of(steps: list[Step], samples: Samples, origin: Origin) -> list[Result]:
    """A result for each quantity of each step."""
    return [_result(step, quantity, samples, origin)
            for step in steps for quantity in samples[step.key][0]]


def _result(step: Step, quantity: str, samples: Samples, origin: Origin) -> Result:
    own, base = samples[step.key], samples[step.base]
    values = _estimate([one[quantity] for one in own])
    ratio: tuple[float | None, float | None, float | None] = (None, None, None)
    if step.base != step.key and _has_ratio(quantity, base):
        ratios = _estimate([one[quantity] / other[quantity] for one, other in zip(own, base)])
        ratio = ratios.value, ratios.low, ratios.high
    base_name = f"{step.base.method}, {step.base.x}" if step.base.x else step.base.method
    return Result(*step.key, quantity, values.value, values.low, values.high, base_name, *ratio,
                  len(own), **asdict(origin))


def _has_ratio(quantity: str, base: Sequence[Figures]) -> bool:
    return all(figures.get(quantity, 0) > 0 for figures in base)


def _estimate(values: Sequence[float]) -> Estimate:
    low, high = interval_ranks(len(values))
    ordered = sorted(values)
    return Estimate(median(values), ordered[low], ordered[high])


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
