"""The same data gives the same bytes, wherever and however it is built."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT, Run
from test_experiments import make_experiments
from test_limits import make_limits
from test_quality import make_quality, write
from test_speedups import with_speedups

MADE = {"index.html", "timings.csv", "timings.md", "experiments.md", "claims.md", "limits.md",
        "headline.tex", "ladder.tex", "claims.tex", "table_two.tex", "plots/limits.svg",
        "plots/limits.png", "plots/limits.csv", "plots/hidden_neurons.svg",
        "plots/skeletons_blobs.svg", "plots/skeletons_blobs.csv"}


def whole_run(directory: Path) -> Path:
    """A run with everything that a report can show."""
    run = write(Run(directory), make_quality())
    with_speedups(run)
    (directory / "limits.json").write_text(json.dumps(make_limits()))
    for name, data in make_experiments().items():
        (directory / f"experiments/{name}.json").write_text(json.dumps(data))
    return directory


def outputs(directory: Path, **environment: str) -> dict[str, bytes]:
    """What a process of its own makes of the run, by file name."""
    before = set(directory.rglob("*"))
    done = subprocess.run([sys.executable, "-m", "report", "build", directory], cwd=ROOT,
                          env=os.environ | environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return {path.relative_to(directory).as_posix(): path.read_bytes()
            for path in directory.rglob("*") if path.is_file() and path not in before}


@pytest.mark.parametrize("environment", [
    {"PYTHONHASHSEED": "1"}, {"PYTHONHASHSEED": "2", "TZ": "Asia/Tokyo", "LC_ALL": "C"},
    {"SOURCE_DATE_EPOCH": "0", "MPLBACKEND": "svg", "COLUMNS": "40"}], ids=str)
def test_all_outputs_are_the_same_bytes_in_another_folder_and_environment(tmp_path, environment):
    one = whole_run(tmp_path / "one")
    two = tmp_path / "elsewhere" / "two"
    shutil.copytree(one, two)
    for path in two.rglob("*"):
        os.utime(path, (1, 1))
    found, again = outputs(one), outputs(two, **environment)
    assert found.keys() == again.keys() and found.keys() >= MADE
    assert [name for name in found if found[name] != again[name]] == []


def test_a_build_over_an_older_one_changes_no_byte(tmp_path):
    directory = whole_run(tmp_path / "run")
    found = outputs(directory)
    assert outputs(directory) == {}
    assert [name for name in found if (directory / name).read_bytes() != found[name]] == []


def test_order_of_rows_in_the_file_does_not_matter(tmp_path):
    one, two = Run(tmp_path / "one"), Run(tmp_path / "two")
    two.timings["benchmarks"].reverse()
    found, again = outputs(one.write()), outputs(two.write())
    assert [name for name in found if found[name] != again[name]] == []
