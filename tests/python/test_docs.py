"""The blocks of Python in docs/ run in order and print what their page says."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def blocks(page: Path) -> list[tuple[str, str]]:
    """Each block of Python with the output given below it, or an empty text."""
    pattern = r"```python\n(.*?)```(?:\n\n```text\n(.*?)```)?"
    return re.findall(pattern, page.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize(("page", "plots"), [
    ("python", ["edges.png", "coins.png", "horse.png"]), ("graphs", ["main-path.png"]), ("rules", []),
    ("path-planning", [])])
def test_blocks_of_a_page_run_and_print_what_it_says(page, plots, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib").use("Agg")
    pytest.importorskip("skimage.data")
    pytest.importorskip("dask.array")
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(ROOT / "python" / "examples")
    names: dict[str, object] = {}
    for code, expected in blocks(ROOT / "docs" / f"{page}.md"):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(code, page, "exec"), names)
        assert printed.getvalue() == expected
    for plot in plots:
        assert (tmp_path / plot).stat().st_size > 10_000
