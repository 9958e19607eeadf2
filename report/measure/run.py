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
from report.measure.estimates import Estimate, Floats, estimate_of_logs
from report.measure.sampler import Json, Samples
from report.measure.timings import Origin, Row, quiet_group, read_csv, rows_of, to_csv
from report.schemas import check_schema

SCHEMA = 2
RUN, TIMINGS, SAMPLES = "run.json", "timings.csv", "samples.jsonl.xz"

SAME_WITHIN, SLOWED_BEYOND = 0.01, 0.05
"""Logarithms. The A/A control must come this close to 1, the injected slowdown must be found to be
at least half of its 10 %."""


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
    """The A/A control and the injected slowdown: each process gives the median over all groups."""
    found: dict[str, list[Floats]] = {"same": [], "slowed": []}
    for samples in runs:
        for role, logs in found.items():
            logs += _control_logs(samples, role)
    count = min((len(logs) for logs in found["same"]), default=0)
    if count == 0:
        return {"same": None, "slowed": None, "processes": 0, "passed": False}
    same, slowed = (estimate_of_logs(np.nanmedian([logs[:count] for logs in found[role]], axis=0))
                    for role in ("same", "slowed"))
    return {"same": vars(same), "slowed": vars(slowed), "processes": count,
            "passed": bool(controls_pass(same, slowed))}


def controls_pass(same: Estimate, slowed: Estimate) -> bool:
    """Whether a row equals itself and an injected slowdown is found; both are speed-ups."""
    return (np.log(same.low) <= SAME_WITHIN and np.log(same.high) >= -SAME_WITHIN
            and np.log(slowed.high) <= -SLOWED_BEYOND)


def _control_logs(samples: Samples, role: str) -> list[Floats]:
    """For each group and process: ln(speed-up) of the control over the row that it repeats."""
    found = []
    for index, group in enumerate(samples.plan["groups"]):
        entries = group["entries"]
        control = next(number for number, entry in enumerate(entries) if entry["role"] == role)
        base = next(number for number, entry in enumerate(entries)
                    if entry["name"] == entries[control]["name"])
        logs = quiet_group(samples, index).logs
        found.append(logs[:, base] - logs[:, control])
    return found


def state_of(runs: list[Samples]) -> Json:
    """Of the machine while the runs were measured: medians over processes."""
    processes = [process for samples in runs for process in samples.processes]
    states = [state for process in processes for state in process.states]
    return {"foreign_load": float(np.median([process.foreign_load for process in processes])),
            "chain_ns": float(np.median([state["chain_ns"] for state in states])),
            "copy_ns": float(np.median([state["copy_ns"] for state in states]))}


def _merged(parts: list[tuple[str, Samples]]) -> Json:
    """Inputs, peers and skipped rows of all plans, each once."""
    merged: dict[str, dict[str, Any]] = {"inputs": {}, "peers": {}, "skipped": {}}
    keys = {"inputs": "name", "peers": "technique", "skipped": "row"}
    for _, samples in parts:
        for kind, items in merged.items():
            items |= {item[keys[kind]]: item for item in samples.plan[kind]}
    return {kind: list(items.values()) for kind, items in merged.items()} | {
        "verified": sum(samples.plan["verified"] for _, samples in parts)}
