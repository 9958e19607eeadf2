"""The blocks of docs/python.md run in order and print what the page says."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import pytest

PAGE = Path(__file__).resolve().parents[2] / "docs" / "python.md"
PLOTS = ["edges.png", "coins.png", "horse.png"]


def blocks() -> list[tuple[str, str]]:
    """Each block of Python with the output given below it, or an empty text."""
    pattern = r"```python\n(.*?)```(?:\n\n```text\n(.*?)```)?"
    return re.findall(pattern, PAGE.read_text(encoding="utf-8"), re.DOTALL)


def test_page_runs_and_prints_what_it_says(tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    pytest.importorskip("skimage.data")
    pytest.importorskip("dask.array")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for code, expected in blocks():
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(code, str(PAGE), "exec"), names)
        assert printed.getvalue() == expected
    for plot in PLOTS:
        assert (tmp_path / plot).stat().st_size > 10_000
