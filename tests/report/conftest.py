"""A small synthetic benchmark run, and the means to spoil it in one place."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import matplotlib.image
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

OPERATION = "thin_naccache_shinghal"
SIZES = {"scene": (510, 412), "square_64": (64, 64), "square_1024": (1024, 1024)}
REFERENCE_NS_PER_PIXEL = 20.0

# Technique, instruction set, threads, and the gain in end-to-end and kernel rows.
VARIANTS = (
    ("lut", "baseline", 1, 3.0, None),
    ("bitpacked", "baseline", 1, 20.0, 30.0),
    ("simd_bitpacked", "avx2", 1, 60.0, 120.0),
    ("simd_bitpacked", "avx512", 1, 90.0, 200.0),
    ("simd_bitpacked", "avx512", 2, 100.0, 240.0),
)

MACHINE: dict[str, Any] = {
    "schema": 1, "fingerprint": "intel-6-143-8-1a2b3c4d",
    "cpu": {"vendor": "intel", "family": 6, "model": 143, "stepping": 8,
            "name": "Intel Xeon <Platinum> 8481C", "flags": ["sse4_2", "avx2", "avx512f"]},
    "cores": 2,
    "caches": [{"level": 1, "type": "Data", "size_kib": 48},
               {"level": 1, "type": "Instruction", "size_kib": 32},
               {"level": 2, "type": "Unified", "size_kib": 2048}],
    "memory_gib": 23, "kernel": "6.1.0", "os": "Debian 12",
    "compiler": {"id": "GNU", "version": "12.2.0", "flags": "-O3", "build_type": "Release"},
    "libraries": {"xsimd": "8.1.0", "benchmark": "1.7.1"}, "commit": "abc1234",
    "date": "2026-11-21T00:10:00Z", "options": {"quick": True, "filter": ""},
    "isa_available": ["baseline", "sse4.2", "avx2", "avx512"], "isa_cap": "avx512",
}


def entries(name: str, size: tuple[int, int], times_ns: list[float]) -> list[dict[str, Any]]:
    """What Google Benchmark writes for one row: its repetitions, then a misleading aggregate.

    Of the two clocks, the one that must not be read shows twice the time.
    """
    width, height = size
    right, wrong = "cpu_time", "real_time"
    if name.split("/")[3] != "1":
        right, wrong = wrong, right
    common = {"name": f"{name}/iterations:9/process_time", "time_unit": "ns", "width": width,
              "height": height, "counted_iterations": 14.0, "label": "background", "verified": 1.0}
    found = [common | {"run_type": "iteration", right: t, wrong: 2 * t, "repetition_index": i}
             for i, t in enumerate(times_ns)]
    aggregate = {"name": common["name"] + "_median", "run_type": "aggregate",
                 "aggregate_name": "median", "cpu_time": 1.0, "real_time": 1.0}
    return found + [common | aggregate]


def jittered(centre: float, seed: str, count: int = 5) -> list[float]:
    """Repetitions around a time, the same for the same seed."""
    dice = random.Random(seed)
    return [centre * dice.uniform(0.995, 1.005) for _ in range(count)]


def make_timings() -> dict[str, Any]:
    """Every variant on every input, with the reference of each input."""
    found = []
    for name, size in SIZES.items():
        base = REFERENCE_NS_PER_PIXEL * size[0] * size[1]
        gains = [("reference/baseline/1/end_to_end", 1.0)]
        for technique, isa, threads, end_to_end, kernel in VARIANTS:
            variant = f"{technique}/{isa}/{threads}"
            gains += [(f"{variant}/end_to_end", end_to_end), (f"{variant}/kernel", kernel)]
        for middle, gain in gains:
            if gain:
                row = f"{OPERATION}/{middle}/{name}"
                found += entries(row, size, jittered(base / gain, row))
    return {"context": {"num_cpus": 2, "library_build_type": "release"}, "benchmarks": found}


def make_rows() -> dict[str, Any]:
    """The inputs of the run and one skipped row."""
    inputs = [{"name": name, "width": w, "height": h, "hash": "0123456789abcdef",
               "object_pixels": w * h // 3} for name, (w, h) in SIZES.items()]
    skipped = {"row": f"{OPERATION}/simd_bitpacked/avx512icl/1/kernel/scene",
               "reason": "this machine lacks avx512icl"}
    return {"schema": 1, "inputs": inputs, "skipped": [skipped], "verified": 30, "failed": 0}


@dataclass
class Run:
    """A run that can be changed and written to disk."""

    directory: Path
    timings: dict[str, Any] = field(default_factory=make_timings)
    machine: dict[str, Any] = field(default_factory=lambda: json.loads(json.dumps(MACHINE)))
    rows: dict[str, Any] = field(default_factory=make_rows)

    def write(self) -> Path:
        """Puts the three files and two pictures where the report expects them."""
        pictures = self.directory / "pictures"
        pictures.mkdir(parents=True, exist_ok=True)
        for name in ("timings", "machine", "rows"):
            (self.directory / f"{name}.json").write_text(json.dumps(getattr(self, name)))
        checks = np.indices((412, 510)).sum(axis=0) // 20 % 2
        for name in ("scene", f"scene_{OPERATION}"):
            matplotlib.image.imsave(pictures / f"{name}.png", checks, cmap="gray")
        return self.directory

    def iterations(self, part: str) -> list[dict[str, Any]]:
        """The repetitions of the rows whose names contain `part`."""
        return [entry for entry in self.timings["benchmarks"]
                if part in entry["name"] and entry["run_type"] == "iteration"]


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """A fresh run that a test may spoil before it calls write()."""
    return Run(tmp_path / "run")


@dataclass(frozen=True)
class Built:
    """What the command made of the synthetic run."""

    directory: Path
    stdout: str

    def text(self, name: str) -> str:
        """One of the files."""
        return (self.directory / name).read_text(encoding="utf-8")


def command(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Runs the program as a user does."""
    return subprocess.run([sys.executable, "-m", "report", *map(str, arguments)], cwd=ROOT,
                          capture_output=True, text=True, check=False)


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Built:
    """The unspoilt run, built once for all tests that only look."""
    directory = Run(tmp_path_factory.mktemp("built") / "run").write()
    done = command("build", directory)
    assert done.returncode == 0, done.stderr
    return Built(directory, done.stdout)


@pytest.fixture
def refusal(capsys: pytest.CaptureFixture[str]) -> Callable[[Path], str]:
    """Builds a directory that must be refused, and returns the one line that says why."""
    from report.__main__ import main

    def build(directory: Path) -> str:
        before = _files(directory)
        assert main(["build", str(directory)]) == 1
        error = capsys.readouterr().err
        assert error.startswith("report: ") and error.count("\n") == 1
        assert _files(directory) == before, "a refused run must leave nothing behind"
        return error

    return build


def _files(directory: Path) -> set[Path]:
    return set(directory.rglob("*"))
