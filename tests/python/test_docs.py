"""The blocks of Python in README and docs/ run in order and print what their page says."""

from __future__ import annotations

import contextlib
import io
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


def blocks(page: Path) -> list[tuple[str, str]]:
    """Each block of Python with the output given below it, or an empty text."""
    pattern = r"```python\n(.*?)```(?:\n\n```text\n(.*?)```)?"
    return re.findall(pattern, page.read_text(encoding="utf-8"), re.DOTALL)


def test_the_block_of_the_readme_runs():
    photo = np.zeros((60, 80, 3), np.uint8)
    photo[20:40, 20:60] = 200, 10, 10
    (code, _), = blocks(ROOT / "README.md")
    names: dict[str, object] = {"photo": photo}
    exec(compile(code, "README.md", "exec"), names)
    assert 0 < np.count_nonzero(names["skeleton"]) < 80


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


def test_the_script_of_large_images_prints_what_its_page_says(tmp_path):
    """In a process of its own, as dask's workers import the file."""
    pytest.importorskip("distributed")
    pytest.importorskip("zarr")
    (code, expected), = blocks(ROOT / "docs" / "large-images.md")
    (tmp_path / "script.py").write_text(code, encoding="utf-8")
    printed = subprocess.run([sys.executable, "script.py"], cwd=tmp_path, check=True, capture_output=True, text=True)
    assert printed.stdout == expected
