"""Runs the programs that were built: those of the directory THINBENCH_PROGRAMS, or of the release build."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PROGRAMS = Path(os.environ.get("THINBENCH_PROGRAMS", ROOT / "build/release/bin"))


def run(*words: object, data: bytes | None = None,
        stdout: object = subprocess.PIPE) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([PROGRAMS / "thinbench", *map(str, words)], stdout=stdout, stderr=subprocess.PIPE,
                          input=data, check=False)


def run_text(*words: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAMS / "thinbench", *map(str, words)], capture_output=True, text=True, check=False)


def assert_rejected(said: str, *words: object, status: tuple[int, ...] = (1, 2),
                    data: bytes | None = None) -> None:
    """By one line on standard error and nothing else."""
    failed = run(*words, data=data)
    assert failed.returncode in status and failed.stdout == b"", failed
    assert failed.stderr.count(b"\n") == 1 and said in failed.stderr.decode(), failed
