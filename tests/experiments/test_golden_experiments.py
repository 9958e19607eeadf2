"""Experiments are deterministic: what is committed is what this build computes, byte for byte. To record another:
`thinbench-study experiment NAME --out results/experiments/NAME.json`."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from tests.programs import PROGRAMS, ROOT

RECORDED = ROOT / "results" / "experiments"


@pytest.mark.parametrize("name", ["cluster-runs", "edge-quality", "hidden-neurons", "literal-holes", "operation-counts",
                                  "quality", "quantisation"])
def test_experiment_equals_the_recorded_one(name: str, tmp_path: Path) -> None:
    out = tmp_path / "out.json"
    subprocess.run([PROGRAMS / "thinbench-study", "experiment", name, "--out", out], check=True,
                   stdout=subprocess.DEVNULL)
    assert out.read_bytes() == (RECORDED / f"{name}.json").read_bytes()
