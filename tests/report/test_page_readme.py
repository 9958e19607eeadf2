"""Figures in documents come from a run that is in the tree."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT, all_rows, write_run

from report.errors import ReportError
from report.page.readme import fill_documents, marked

MARKED = ("Before.\n<!-- headline: made by report readme -->\nold\n<!-- end -->\n"
          "Between.\n<!-- run: made by report readme -->\nold\n<!-- end -->\n"
          "<!-- speed thin_guo_hall:keep edges_sobel: made by report readme -->\n<!-- end -->\nAfter.\n")


def test_only_what_stands_between_the_marks_changes(tmp_path):
    (tmp_path / "README.md").write_text(MARKED)
    fill_documents(write_run(tmp_path / "run", all_rows()), [tmp_path / "README.md"])
    text = (tmp_path / "README.md").read_text()
    assert "old" not in text
    assert all(words in text for words in ("Before.\n", "Between.\n", "After.\n"))
    assert "| Guo-Hall, border kept, `thin_guo_hall` | 64.0 µs | simd_bitpacked, avx512 | 156× " \
           "(153 to 159) | 1,406× |" in text
    assert "[all timings](run/timings.csv)" in text
    assert "| `simd_bitpacked` | avx512 | 156× (153 to 159) | 156× (153 to 159) |" in text
    assert "| `opencv` | native |" in text


def test_filling_twice_changes_nothing(tmp_path):
    readme = tmp_path / "README.md"
    readme.write_text((ROOT / "README.md").read_text())
    directory = write_run(tmp_path / "run", all_rows())
    fill_documents(directory, [readme])
    once = readme.read_text()
    fill_documents(directory, [readme])
    assert readme.read_text() == once


@pytest.mark.parametrize("text", ["No marks.\n", MARKED.replace("headline", "healdine")])
def test_a_document_without_known_marks_is_rejected_and_nothing_is_written(tmp_path, text):
    (tmp_path / "good.md").write_text(MARKED)
    (tmp_path / "bad.md").write_text(text)
    with pytest.raises(ReportError, match="bad.md: .*headline"):
        fill_documents(write_run(tmp_path / "run", all_rows()),
                       [tmp_path / "good.md", tmp_path / "bad.md"])
    assert (tmp_path / "good.md").read_text() == MARKED


def test_every_run_that_a_document_quotes_is_in_the_tree():
    assert marked(ROOT)
    documents = [ROOT / "README.md", ROOT / "report" / "CLAIMS.md", *(ROOT / "docs").glob("*.md")]
    kept = {path.parent.name.rpartition("-")[2] for path in (ROOT / "results").glob("*/*/run.json")}
    for document in documents:
        quoted = set(re.findall(r"[Rr]uns? of commit\s+([0-9a-f]+)", document.read_text()))
        assert quoted <= kept, f"{document} quotes {quoted - kept}, which is not in results/"
