"""What ./study, ./check and tools/release say before they build: help, wrong options, missing rights."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def said(directory: Path, *words: str, **environment: str) -> tuple[int, str]:
    """The exit status, and all of standard output or the last line of standard error."""
    done = subprocess.run([ROOT / words[0], *words[1:]], cwd=directory, text=True, capture_output=True, check=False,
                          stdin=subprocess.DEVNULL, env=os.environ | environment)
    return done.returncode, done.stdout if done.returncode == 0 else done.stderr.splitlines()[-1]


@pytest.mark.parametrize(("command", "status", "text"), [
    ("study --help", 0, "--quality-image FILE"),
    ("study sweeps --help", 0, "usage: ./study sweeps"),
    ("study many-images --help", 0, "usage: ./study many-images"),
    ("study compare --help", 0, "usage: ./study compare"),
    ("study --no-install --quik", 2, "--quik"),
    ("study --no-install --image absent.png", 2, "cannot read the image 'absent.png'"),
    ("study --no-install --foreground black", 2, "--foreground: invalid choice: 'black'"),
    *((f"study --no-install --threshold={value}", 2, f"expected an integer in [0, 255] or 'otsu', got '{value}'")
      for value in ("256", "-1", "1.5", "ottsu")),
    ("study --no-install --threads 1,4", 2, "expected integers in [2, 1024], got '1,4'"),
    ("study --no-install --threads two", 2, "expected integers with commas between them, got 'two'"),
    ("study --no-install --foreground dark", 2, "--foreground needs --image"),
    ("study --no-install --filter (", 2, "--filter: '(' is not a regular expression"),
    ("study --no-install sweeps --only sizes", 2, "--only: invalid choice: 'sizes'"),
    ("study --no-install sweeps --seconds many", 2, "expected an integer from 1 to 999999, got 'many'"),
    ("study --no-install compare absent absent", 1, "absent/run.json: cannot be read"),
    ("study --no-install compare absent", 2, "expected two runs or more"),
    ("check -h", 0, "Usage: ./check"),
    ("check --no-install fuzz --help", 0, "usage: ./check fuzz"),
    ("check --no-install coverage --help", 0, "usage: ./check coverage"),
    ("check --no-install mutants --help", 0, "usage: python3 tests/mutation/run.py"),
    ("check --no-install fuzz --seconds long", 2, "--seconds: expected a number above 0, got 'long'"),
    ("check --no-install fuzz --hours 0", 2, "--hours: expected a number above 0, got '0'"),
    ("check --no-install fuzz --jobs 0", 2, "--jobs: expected 1 or more, got 0"),
    ("check --no-install fuzz loud", 2, "no target is named 'loud'; known: "),
    ("check --no-install mutants -n -1", 2, "--number: expected an integer of at least 0, got '-1'"),
    ("check soak --help", 0, "soak has --seconds N, --threads N, --seed N"),
    ("check asan tsan", 2, "check: expected one thing to check, got 'asan' and 'tsan'"),
    ("check fast", 2, "check: 'fast' is neither an option nor something to check; see ./check --help"),
    ("tools/release --help", 0, "Usage: tools/release"),
    ("tools/release --fast", 2, "release: '--fast' is not an option; see tools/release --help")])
def test_command_says_it_in_one_line(command: str, status: int, text: str, tmp_path: Path) -> None:
    found, words = said(tmp_path, *command.split())
    assert (found, text in words) == (status, True), words


def test_files_of_the_callers_directory_are_not_imported(tmp_path: Path) -> None:
    for name in ("report.py", "numpy.py"):
        (tmp_path / name).write_text("raise SystemExit(9)\n", encoding="utf-8")
    status, words = said(tmp_path, "study", "--no-install", "--quik")
    assert status == 2 and "--quik" in words


@pytest.mark.parametrize("script", ["study", "check"])
def test_a_user_who_may_not_install_is_told_what_to_run(script: str, tmp_path: Path) -> None:
    """No package is there, and sudo asks in vain."""
    for name, line in {"dpkg-query": "exit 1", "sudo": "exit 1", "id": "echo 1000"}.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{line}\n", encoding="utf-8")
        (tmp_path / name).chmod(0o755)
    status, words = said(tmp_path, script, PATH=f"{tmp_path}:{os.environ['PATH']}")
    assert status == 1
    assert (f"{script}: packages are missing and this user may not install them; run: sudo apt-get update && sudo "
            "apt-get install -y --no-install-recommends g++ cmake") in words
