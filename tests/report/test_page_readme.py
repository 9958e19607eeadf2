"""The README's table comes from a run."""

from __future__ import annotations

import pytest
from conftest import ROOT, all_rows, write_run

from report.errors import ReportError
from report.page.readme import fill_readme

MARKED = ("Before.\n<!-- headline: made by report readme -->\nold\n<!-- end of headline -->\n"
          "Between.\n<!-- run: made by report readme -->\nold\n<!-- end of run -->\nAfter.\n")


def test_only_what_stands_between_the_marks_changes(tmp_path):
    (tmp_path / "README.md").write_text(MARKED)
    fill_readme(write_run(tmp_path / "run", all_rows()), tmp_path / "README.md")
    text = (tmp_path / "README.md").read_text()
    assert "old" not in text
    assert all(words in text for words in ("Before.\n", "Between.\n", "After.\n"))
    assert "| Guo-Hall, border kept, `thin_guo_hall` | 64.0 µs | simd_bitpacked, avx512 | 156× " \
           "(153 to 159) | 1,406× |" in text
    assert "[all timings](run/timings.csv)" in text


def test_filling_twice_changes_nothing(tmp_path):
    readme = tmp_path / "README.md"
    readme.write_text((ROOT / "README.md").read_text())
    directory = write_run(tmp_path / "run", all_rows())
    fill_readme(directory, readme)
    once = readme.read_text()
    fill_readme(directory, readme)
    assert readme.read_text() == once


def test_a_missing_mark_is_named_and_nothing_is_written(tmp_path):
    (tmp_path / "README.md").write_text("No marks.\n")
    with pytest.raises(ReportError, match="headline"):
        fill_readme(write_run(tmp_path / "run", all_rows()), tmp_path / "README.md")
    assert (tmp_path / "README.md").read_text() == "No marks.\n"
