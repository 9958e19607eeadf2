"""The CSV file: the time of each quantity, its interval, and ratios."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import pandas as pd

from report.errors import ReportError
from report.files import read_bytes
from report.many_images.steps import QUANTITIES, Step, row_of
from report.measure.estimates import Estimates, Time, ratio_of

CSV = "many_images.csv"

RATIOS = ["ratio", "ratio_low", "ratio_high"]
FIGURES = ["experiment", "method", "x", "quantity", "time", "high", "typical", "base", *RATIOS, "rounds", "flags"]
COLUMNS = [*FIGURES, "commit", "machine", "processor", "cores"]


def results_of(steps: list[Step], samples: pd.DataFrame, machine: dict[str, Any]) -> pd.DataFrame:
    """A line for each quantity of each step. `time`, `high` and `typical` are those of report.measure.estimates; the
    ratio is that of its time to the base's, none for the base itself."""
    times = Estimates(samples)
    lines = [_figures(step, quantity, times.time(name), times.time(row_of(step.base, quantity)))
             for step in steps for quantity in QUANTITIES if (name := row_of(step.key, quantity)) in times]
    return pd.DataFrame(lines, columns=FIGURES).assign(
        commit=machine["commit"], machine=machine["fingerprint"], processor=machine["cpu"]["name"],
        cores=machine["cores"])


def _figures(step: Step, quantity: str, own: Time, base: Time) -> list[Any]:
    ratio = ratio_of(own, base)
    ratios: list[float | None] = [None] * 3 if step.base == step.key else [ratio.value, ratio.low, ratio.high]
    base_name = f"{step.base.method}, {step.base.x}" if step.base.x else step.base.method
    return [*step.key, quantity, own.value, own.high, own.typical, base_name, *ratios, own.processes,
            "" if own.settled and base.settled else "open"]


def to_csv(results: pd.DataFrame) -> str:
    """Four digits; empty where there is no ratio."""
    return str(results.to_csv(index=False, float_format="%.4g", lineterminator="\n"))


def read_csv(path: Path) -> pd.DataFrame:
    """Raises ReportError where the file is no such table."""
    try:
        found = pd.read_csv(io.BytesIO(read_bytes(path)), dtype={"flags": str, "commit": str}, keep_default_na=False,
                            na_values={name: [""] for name in RATIOS})
        return found[COLUMNS]
    except (ValueError, LookupError) as error:
        raise ReportError(f"{path}: not such a table: {error}") from None
