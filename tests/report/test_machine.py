"""Facts about this machine, from lscpu and the program."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from fake_programs import MACHINE, install

from report.measure.machine import caches_of, cpu_of, fingerprint, machine_facts
from report.schemas import check_schema

CPU, COMPILER = MACHINE["cpu"], MACHINE["compiler"]


def test_facts_of_the_processor_are_those_of_lscpu() -> None:
    told = {"Vendor ID:": "AuthenticAMD", "Model name:": "AMD EPYC", "CPU family:": "25", "Model:": "17",
            "Stepping:": "r1p1", "Flags:": "sse2 avx2 bmi1", "Other:": "8"}
    assert cpu_of([{"field": field, "data": text} for field, text in told.items()]) == {
        "vendor": "amd", "family": 25, "model": 17, "stepping": "r1p1", "name": "AMD EPYC",
        "flags": ["avx2", "bmi1", "sse2"]}


def test_caches_are_in_kib() -> None:
    assert caches_of([{"name": "L1d", "one-size": "49152", "type": "Data", "level": 1}]) == [
        {"level": 1, "type": "Data", "size_kib": 48}]


@pytest.mark.parametrize("script", ["exit 1", "echo", "echo '[]'"])
def test_facts_are_unknown_without_lscpu(script: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "lscpu").write_text(f"#!/bin/sh\n{script}\n")
    (tmp_path / "lscpu").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    facts = machine_facts(install(tmp_path / "bin") / "thinbench_benchmarks", "")
    assert facts["cpu"] == {**dict.fromkeys(("vendor", "family", "model", "stepping", "name"), "unknown"), "flags": []}
    assert facts["caches"] == [] and facts["fingerprint"].startswith("unknown-unknown-unknown-unknown-")


def test_the_fingerprint_depends_on_flags_and_compiler_but_not_on_the_name() -> None:
    assert fingerprint(CPU, COMPILER) == fingerprint(CPU | {"name": "another"}, COMPILER)
    assert fingerprint(CPU | {"flags": ["avx2"]}, COMPILER) != fingerprint(CPU, COMPILER)
    assert fingerprint(CPU, COMPILER | {"id": "Clang"}) != fingerprint(CPU, COMPILER)


def test_runs_of_the_same_build_keep_their_fingerprint() -> None:
    """The directories of results/ are named after it."""
    runs = sorted((Path(__file__).parents[2] / "results").glob("*/*/run.json"))
    machines = [json.loads(path.read_text(encoding="utf-8"))["machine"] for path in runs]
    assert machines and all(fingerprint(one["cpu"], one["compiler"]) == one["fingerprint"] for one in machines)


def test_facts_fit_their_schema(tmp_path: Path) -> None:
    facts = machine_facts(install(tmp_path) / "thinbench_benchmarks", "abc")
    assert facts.pop("commit") == "abc"
    check_schema("machine", facts, "machine")
