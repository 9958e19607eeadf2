"""The blocks of Python in docs/ run in order and print what their page says."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import pytest

DOCS = Path(__file__).resolve().parents[2] / "docs"
PLOTS = ["edges.png", "coins.png", "horse.png"]


def blocks(page: Path) -> list[tuple[str, str]]:
    """Each block of Python with the output given below it, or an empty text."""
    pattern = r"```python\n(.*?)```(?:\n\n```text\n(.*?)```)?"
    return re.findall(pattern, page.read_text(encoding="utf-8"), re.DOTALL)


def run(page: Path) -> None:
    names: dict[str, object] = {}
    for code, expected in blocks(page):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(code, str(page), "exec"), names)
        assert printed.getvalue() == expected


def test_page_of_the_package_runs_and_prints_what_it_says(tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    pytest.importorskip("skimage.data")
    pytest.importorskip("dask.array")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    run(DOCS / "python.md")
    for plot in PLOTS:
        assert (tmp_path / plot).stat().st_size > 10_000


def test_page_of_graphs_runs_and_prints_what_it_says(tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    pytest.importorskip("skimage.data")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    run(DOCS / "graphs.md")
    assert (tmp_path / "main-path.png").stat().st_size > 10_000


def test_page_of_custom_rules_runs_and_prints_what_it_says():
    run(DOCS / "rules.md")
