"""A run: its directory describes it completely, so that runs can be moved, merged and compared."""

from __future__ import annotations

import lzma
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from report.files import read_json, to_json, write_files
from report.measure.benchmarks import Json, groups_of
from report.measure.controls import control_of
from report.measure.estimates import NEEDED, Estimates
from report.measure.measurement import Part
from report.measure.timings import Origin, Row, read_csv, rows_of, to_csv
from report.schemas import check_schema

SCHEMA = 3
RUN, TIMINGS, SAMPLES = "run.json", "timings.csv", "samples.csv.xz"

@dataclass(frozen=True)
class Run:
    """What run.json and timings.csv hold."""

    directory: Path
    facts: Json
    rows: list[Row]

    @property
    def machine(self) -> Json:
        """As report.measure.machine describes it, build included."""
        machine: Json = self.facts["machine"]
        return machine


def load_run(directory: Path) -> Run:
    """Raises ReportError where the directory holds no run of this version."""
    facts = read_json(directory / RUN)
    check_schema("run", facts, str(directory / RUN))
    return Run(directory, facts, read_csv(directory / TIMINGS))


def write_run(directory: Path, machine: Json, options: Json, parts: Sequence[Part], name: str = "") -> Run:
    """Makes run.json, timings.csv and the samples of what was measured. A run is named after its directory."""
    name = f"{machine['fingerprint']}/{name or directory.resolve().name}"
    samples = samples_of(parts)
    found = [(part, estimates_of(part, samples)) for part in parts]
    rows = [row for part, times in found
            for row in rows_of(part.facts, times, Origin(name, machine["fingerprint"], machine["commit"], part.sweep))]
    facts = {"schema": SCHEMA, "run": name, "machine": machine, "options": options,
             "controls": controls_of(found), "state": state_of(found), **_merged(found)}
    write_files(directory, {SAMPLES: lzma.compress(samples.to_csv(index=False, float_format="%.5g").encode(), preset=6),
                            TIMINGS: to_csv(rows).encode(), RUN: to_json(facts)})
    return Run(directory, facts, rows)


def samples_of(parts: Sequence[Part]) -> pd.DataFrame:
    """One long table of all parts."""
    return pd.concat([part.samples.assign(sweep=part.sweep) for part in parts], ignore_index=True)


def estimates_of(part: Part, samples: pd.DataFrame) -> Estimates:
    """Of the rows of a part, with the clock and the gate of all samples."""
    return Estimates(samples, samples[samples["sweep"] == part.sweep])


def controls_of(found: Sequence[tuple[Part, Estimates]]) -> Json:
    """The A/A control and the injected slowdown of every group: medians, and how many failed."""
    controls = [one for part, times in found for group in groups_of(part.facts)
                if (one := control_of(group, times)).same is not None]
    failed = sum(bool(one.flag) for one in controls)
    return {"groups": len(controls), "same": _median([one.same for one in controls]),
            "slowed": _median([one.slowed for one in controls]), "failed": failed}


def _median(values: list[Any]) -> float | None:
    return float(np.median(values)) if values else None


def state_of(found: Sequence[tuple[Part, Estimates]]) -> Json:
    """Of the machine while the run was measured, and how many times as long the rows that lack quiet moments need."""
    lacking = [NEEDED / max(time.quiet, 0.5) for part, times in found for name in part.facts["rows"]
               if name in times and not (time := times.time(name)).settled]
    times = found[0][1]
    return {"cycle_ns": times.cycle_ns, "probe_ns": times.probe_ns, "quiet": times.quiet,
            "longer": max(lacking, default=1.0)}


def _merged(found: Sequence[tuple[Part, Estimates]]) -> Json:
    """Inputs, peers and skipped rows of all parts, each once; rows that failed are skipped, too."""
    merged: dict[str, dict[str, Any]] = {"inputs": {}, "peers": {}, "skipped": {}}
    keys = {"inputs": "name", "peers": "technique", "skipped": "row"}
    for part, times in found:
        for kind, items in merged.items():
            items |= {item[keys[kind]]: item for item in part.facts[kind]}
        merged["skipped"] |= {name: {"row": name, "reason": "it was not measured: it failed, or time was up"}
                              for name in part.facts["rows"] if name not in times}
    return {kind: list(items.values()) for kind, items in merged.items()} | {
        "verified": sum(part.facts["verified"] for part, _ in found)}


