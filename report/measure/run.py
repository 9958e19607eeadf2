"""A run: its directory describes it completely, so that runs can be moved, merged and compared."""

from __future__ import annotations

import json
import lzma
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from report.errors import ReportError
from report.files import read_bytes, read_json, to_json, write_files
from report.measure.converge import control_flag, control_ratios
from report.measure.sampler import Json, Samples
from report.measure.timings import Origin, Row, read_csv, rows_of, to_csv
from report.schemas import check_schema

SCHEMA = 3
RUN, TIMINGS, SAMPLES = "run.json", "timings.csv", "samples.jsonl.xz"

MAX_FAILED = 0.05
"""Share of groups whose controls may fail before the run as a whole concludes nothing."""

@dataclass(frozen=True)
class Run:
    """What run.json and timings.csv hold."""

    directory: Path
    facts: Json
    rows: list[Row]

    @property
    def machine(self) -> Json:
        """As `thinbench-study machine` describes it, build included."""
        machine: Json = self.facts["machine"]
        return machine

    @property
    def is_conclusive(self) -> bool:
        """Whether the controls passed."""
        return bool(self.facts["controls"]["passed"])


def load_run(directory: Path) -> Run:
    """Raises ReportError where the directory holds no run of this version."""
    facts = read_json(directory / RUN)
    check_schema("run", facts, str(directory / RUN))
    return Run(directory, facts, read_csv(directory / TIMINGS))


def load_samples(directory: Path) -> list[Samples]:
    """The raw samples."""
    try:
        return Samples.from_json_lines(read_bytes(directory / SAMPLES).decode().splitlines())
    except (ValueError, LookupError, TypeError) as error:
        raise ReportError(f"{directory / SAMPLES}: holds no samples: {error}") from None


def machine_facts(program: Path, commit: str) -> Json:
    """What the measurements depend on, told by the program that was built with the sampler."""
    done = subprocess.run([program, "machine", "--commit", commit], check=False, text=True,
                          stdout=subprocess.PIPE)
    if done.returncode != 0:
        raise ReportError("the machine could not be described; see the line above")
    facts: Json = json.loads(done.stdout)
    return facts


def write_run(directory: Path, machine: Json, options: Json,
              parts: list[tuple[str, Samples]], name: str = "") -> Run:
    """Makes run.json, timings.csv and samples of plans that were measured. Each part has the name
    of its parameter sweep, "" for none. A run is named after its directory."""
    name = f"{machine['fingerprint']}/{name or directory.resolve().name}"
    rows: list[Row] = []
    for sweep, samples in parts:
        rows += rows_of(samples, Origin(name, machine["fingerprint"], machine["commit"], sweep))
    facts = {"schema": SCHEMA, "run": name, "machine": machine, "options": options,
             "controls": controls_of([samples for _, samples in parts]),
             "state": state_of([samples for _, samples in parts]), **_merged(parts)}
    lines = "".join(f"{line}\n" for _, samples in parts for line in samples.to_json_lines())
    write_files(directory, {SAMPLES: lzma.compress(lines.encode(), preset=9),
                            TIMINGS: to_csv(rows).encode(), RUN: to_json(facts)})
    return Run(directory, facts, rows)


def controls_of(runs: list[Samples]) -> Json:
    """The A/A control and the injected slowdown of every group: medians, and how many failed."""
    groups = [(samples, index) for samples in runs
              for index in range(len(samples.plan["groups"]))]
    if not groups:
        return {"groups": 0, "same": None, "slowed": None, "failed": 0, "passed": False}
    ratios = np.array([control_ratios(*group) for group in groups])
    failed = sum(bool(control_flag(*group)) for group in groups)
    same, slowed = np.median(ratios, axis=0).tolist()
    return {"groups": len(groups), "same": same, "slowed": slowed, "failed": failed,
            "passed": failed <= MAX_FAILED * len(groups)}


def state_of(runs: list[Samples]) -> Json:
    """Of the machine while the runs were measured: medians over processes."""
    processes = [process for samples in runs for process in samples.processes]
    states = [state for process in processes for state in process.states]
    return {"cycle_ns": float(np.median([samples.plan["cycle_ns"] for samples in runs])),
            "foreign_load": float(np.median([process.foreign_load for process in processes])),
            "chain_ns": float(np.median([state["chain_ns"] for state in states]))}


def _merged(parts: list[tuple[str, Samples]]) -> Json:
    """Inputs, peers and skipped rows of all plans, each once."""
    merged: dict[str, dict[str, Any]] = {"inputs": {}, "peers": {}, "skipped": {}}
    keys = {"inputs": "name", "peers": "technique", "skipped": "row"}
    for _, samples in parts:
        for kind, items in merged.items():
            items |= {item[keys[kind]]: item for item in samples.plan[kind]}
    return {kind: list(items.values()) for kind, items in merged.items()} | {
        "verified": sum(samples.plan["verified"] for _, samples in parts)}
