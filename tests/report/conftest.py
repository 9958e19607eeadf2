"""A small synthetic run, made of Row objects; samples of made-up programs."""

from __future__ import annotations

import random
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from PIL import Image

import fake_programs
from report.__main__ import main
from report.files import to_json, write_files
from report.measure.benchmarks import Json
from report.measure.timings import Row, to_csv

ROOT = Path(__file__).resolve().parents[2]

MACHINE: dict[str, Any] = fake_programs.MACHINE | {"isa_available": ["baseline", "avx2", "avx512"]}

SIZES = {"scene": (510, 412), "square_64": (64, 64), "square_128": (128, 128)}
EQUAL = "opencv"

NS = {("reference", "baseline"): 1e7, ("lut", "baseline"): 4e6, ("bitpacked", "baseline"): 5e5,
      ("simd_bitpacked", "avx2"): 1.2e5, ("simd_bitpacked", "avx512"): 6.4e4}
"""Nanoseconds of a call on one thread, end to end."""


def without_progress(errors: str) -> str:
    """Standard error without the lines that a slow machine adds."""
    return "".join(line for line in errors.splitlines(keepends=True) if " s left" not in line)


def make_row(case: str, technique: str, isa: str, ns: float, reference_ns: float = 1e7,
             **changes: Any) -> Row:
    """A row whose figures agree with each other."""
    operation, *options = case.split(":")
    ratio = reference_ns / ns
    row = Row(operation, technique, isa, 1, "end_to_end", "scene", 510, 412, 31, ns, 1.02 * ns,
              1.05 * ns, ns / 510 / 412, ratio, 0.98 * ratio, 1.02 * ratio, 9, "", None, None, None,
              "", False, isa == "avx512", isa == "baseline", True,
              "keep" if options else "background", None, "run", MACHINE["fingerprint"], "abc1234",
              "")
    return replace(row, **changes)


def make_rows(case: str, slower: float = 1.0) -> list[Row]:
    """All variants of a case, in both scopes and on two threads."""
    rows = [make_row(case, *key, slower * ns, slower * 1e7) for key, ns in NS.items()]
    best = replace(rows[-1], time_ns=slower * 3e4, speedup_vs_reference=1e7 / 3e4)
    return [*rows, replace(best, scope="kernel"), replace(best, threads=2)]


def with_peer(rows: list[Row], ns: float) -> list[Row]:
    """The same, and OpenCV beside it."""
    peer = replace(rows[0], technique=EQUAL, isa="native", peer=True, time_ns=ns, high_ns=ns,
                   default=False, scalar=False)
    return [replace(row, speedup_vs_peer=ns / row.time_ns, peer_low=ns / row.high_ns,
                    peer_high=ns / row.time_ns, peer_name=EQUAL)
            if row.scope == "end_to_end" else row for row in rows] + [peer]


def all_rows() -> list[Row]:
    """Four operations, one with and without border, and a series of sizes."""
    edges = [replace(row, border="") for row in with_peer(make_rows("edges_sobel"), 8e5)]
    copy = replace(edges[0], technique="copy", isa="native", peer=True, time_ns=4e3,
                   default=False, scalar=False)
    squares = [replace(make_row("holes", "simd_runs", "avx2", 1e4 * side), input=f"square_{side}",
                       width=side, height=side, border="") for side in (64, 128)]
    return [*make_rows("thin_naccache_shinghal", 0.5), *make_rows("thin_guo_hall"),
            *with_peer(make_rows("thin_guo_hall:keep"), 9e7), *edges, copy, *squares]


def make_facts(rows: list[Row]) -> dict[str, Any]:
    """run.json."""
    names = [name for name in SIZES if any(row.input == name for row in rows)]
    return {"schema": 3, "run": "intel/made", "machine": MACHINE, "options": {"quick": True},
            "controls": {"groups": 9, "same": 1.0, "slowed": 0.91, "failed": 0},
            "state": {"cycle_ns": 0.25, "probe_ns": 6000.0, "quiet": 0.9, "longer": 1.0},
            "inputs": [{"name": name, "width": SIZES[name][0], "height": SIZES[name][1],
                        "hash": "0" * 16, "grey_hash": "1" * 16, "foreground_pixels": 99}
                       for name in names],
            "peers": [{"technique": EQUAL, "about": "OpenCV 4.6.0, 1 thread", "equal_output": True}],
            "skipped": [{"row": "thin_guo_hall/lut/avx2/1/kernel/scene", "reason": "no <avx2>"}],
            "verified": 24}


def write_run(directory: Path, rows: list[Row], **facts: Any) -> Path:
    """With two images."""
    (directory / "pictures").mkdir(parents=True)
    checks = (np.indices((412, 510)).sum(axis=0) // 20 % 2 * 255).astype(np.uint8)
    for name in ("scene_grey", "scene_thin_guo_hall"):
        Image.fromarray(checks).save(directory / "pictures" / f"{name}.png")
    write_files(directory, {"timings.csv": to_csv(rows).encode(),
                            "run.json": to_json(make_facts(rows) | facts)})
    return directory


@dataclass(frozen=True)
class Built:
    """What `build` made of a run."""

    directory: Path
    stdout: str

    def text(self, name: str) -> str:
        """One of the files."""
        return (self.directory / name).read_text(encoding="utf-8")


def build(directory: Path, capsys: pytest.CaptureFixture[str]) -> Built:
    """As a user does."""
    assert main(["build", str(directory)]) == 0
    return Built(directory, capsys.readouterr().out)


Make = Callable[..., Built]


@pytest.fixture(name="make")
def _make(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Make:
    """Builds a run of rows, beside files by their names, with changed facts."""
    def make(rows: list[Row] | None = None, files: dict[str, bytes] | None = None, **facts: Any) -> Built:
        directory = write_run(tmp_path / "run", all_rows() if rows is None else rows, **facts)
        write_files(directory, files or {})
        return build(directory, capsys)
    return make


@pytest.fixture(name="built")
def _built(make: Make) -> Built:
    """The whole synthetic run."""
    return make()


@pytest.fixture(name="rejection")
def _rejection(capsys: pytest.CaptureFixture[str]) -> Iterator[Callable[..., str]]:
    """Runs a command that must fail and leave nothing behind; gives the one line that says why."""
    def run(*words: str | Path) -> str:
        before = set(Path(words[1]).rglob("*"))
        assert main([str(word) for word in words]) == 1
        error = capsys.readouterr().err
        assert error.startswith("study: ") and error.count("\n") == 1
        assert set(Path(words[1]).rglob("*")) == before
        return error
    yield run


def study(programs: Path, *words: object) -> subprocess.CompletedProcess[str]:
    """A command of ./study on programs that exist already, in a directory for each preset."""
    return subprocess.run(["/usr/bin/python3", Path(__file__).with_name("fake_study.py"), programs,
                           *map(str, words)], check=False, text=True, capture_output=True)


def make_samples(facts: Json, noise: fake_programs.Noise = fake_programs.Noise(), processes: int = 9,
                 seed: int = 1) -> pd.DataFrame:
    """As processes find them."""
    dice = random.Random(seed)
    lines = [(process, *line, noise.clock * fake_programs.CYCLE) for process in range(processes)
             for line in fake_programs.lines_of(facts, dice, noise)]
    return pd.DataFrame(lines, columns=["process", "row", "ns", "before", "after", "cycle"])
