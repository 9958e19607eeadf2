"""The README's tables come from a run."""

from __future__ import annotations

import pytest
from conftest import Run

from report.errors import ReportError
from report.readme import fill_readme
from report.short_tables import SHORT_TABLES

NAMES = (*SHORT_TABLES, "run")


def page_with(names: tuple[str, ...]) -> str:
    return "before\n" + "".join(
        f"<!-- {name}: made by report readme -->\nold\n<!-- end of {name} -->\nbetween\n"
        for name in names)


def test_tables_are_replaced_and_words_stay(run: Run):
    readme = run.write() / "README.md"
    readme.write_text(page_with(NAMES))
    fill_readme(run.directory, readme)
    once = readme.read_text()
    assert "old" not in once and once.count("between") == len(NAMES)
    assert "| the paper's thinning, `thin_naccache_shinghal` |" in once
    assert "| reference | baseline |" in once and "Run of commit abc1234" in once
    fill_readme(run.directory, readme)
    assert readme.read_text() == once


def test_readme_without_marks_is_refused_and_left_alone(run: Run):
    readme = run.write() / "README.md"
    readme.write_text(page_with(NAMES[1:]))
    with pytest.raises(ReportError, match="both marks are needed"):
        fill_readme(run.directory, readme)
    assert readme.read_text() == page_with(NAMES[1:])


def test_missing_readme_is_one_clear_line(run: Run):
    with pytest.raises(ReportError, match="cannot be read"):
        fill_readme(run.write(), run.directory / "nothing.md")
