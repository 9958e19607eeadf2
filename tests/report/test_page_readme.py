"""Figures in documents come from a run that is in the tree."""

from __future__ import annotations

import re

import pandas as pd
import pytest
from conftest import ROOT, all_rows, write_run

from report.errors import ReportError
from report.many_images.results import COLUMNS, read_csv, to_csv
from report.measure.run import load_run
from report.page.readme import MANY_IMAGES, fill_documents, filled, makers_of, marked

MARKED = ("Before.\n<!-- headline: made by report readme -->\nold\n<!-- end -->\n"
          "Between.\n<!-- run: made by report readme -->\nold\n<!-- end -->\n"
          "<!-- speed thin_guo_hall:keep edges_sobel holes@square_64: made by report readme -->\n"
          "<!-- end -->\nAfter.\n")


def test_only_what_stands_between_the_marks_changes(tmp_path):
    (tmp_path / "README.md").write_text(MARKED)
    fill_documents(write_run(tmp_path / "run", all_rows()), [tmp_path / "README.md"])
    text = (tmp_path / "README.md").read_text()
    assert "old" not in text
    assert all(words in text for words in ("Before.\n", "Between.\n", "After.\n"))
    assert "| Guo-Hall, border kept, `thin_guo_hall:keep` | 64.0 µs | 120 µs | simd_bitpacked, avx512 | 156× " \
           "(153\N{EN DASH}159) | 1,406× |" in text
    assert "[all timings](run/timings.csv)" in text
    assert "| `simd_bitpacked` | avx512 | 156× (153\N{EN DASH}159) | 156× (153\N{EN DASH}159) | \N{EN DASH} |" in text
    assert "| `holes` on `square_64` |" in text
    assert "| `simd_runs` | avx2 | \N{EN DASH} | \N{EN DASH} | 15.6× (15.3\N{EN DASH}15.9) |" in text
    assert "| `opencv` | native |" in text


def test_filling_twice_changes_nothing(tmp_path):
    readme = tmp_path / "README.md"
    readme.write_text((ROOT / "README.md").read_text())
    directory = write_run(tmp_path / "run", all_rows())
    fill_documents(directory, [readme])
    once = readme.read_text()
    fill_documents(directory, [readme])
    assert readme.read_text() == once


def write_many_images(directory):
    """One experiment of ./study many-images."""
    machine = ["abc1234", "intel-6-143-8-1a2b3c4d", "Fake", 2]
    lines = [["calls", "ours", 0, "ms_per_call", 0.0413, 0.042, 0.05, "ours", None, None, None, 5, "", *machine],
             ["calls", "theirs", 0, "ms_per_call", 63.3, 0.042, 0.05, "ours", 1533, 1500, 1540, 5, "open", *machine]]
    (directory / MANY_IMAGES).parent.mkdir(parents=True)
    (directory / MANY_IMAGES).write_text(to_csv(pd.DataFrame(lines, columns=COLUMNS)))
    return directory


def test_many_images_fill_their_parts_and_no_other(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(f"{MARKED}<!-- many-images calls: made by report readme -->\nold\n<!-- end -->\n")
    fill_documents(write_many_images(tmp_path / "run"), [page])
    text = page.read_text()
    assert text.startswith(MARKED)
    assert "| `ours` | 41.3 µs | `theirs` | 63.3 ms | 1,533 (1,500\N{EN DASH}1,540, open) |" in text
    assert "Run of commit abc1234 on Fake (intel-6-143-8-1a2b3c4d), 2 cores: " \
           "[all figures](run/many-images/many_images.csv)." in text
    page.write_text(text.replace("-images calls:", "-images walls:"))
    with pytest.raises(ReportError, match="walls.*expected one of .*calls"):
        fill_documents(tmp_path / "run", [page])


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
    kept = {load_run(path.parent).machine["commit"] for path in runs()}
    kept |= {commit for path in (ROOT / "results").glob(f"*/*/{MANY_IMAGES}") for commit in read_csv(path)["commit"]}
    for document in documents:
        quoted = set(re.findall(r"[Rr]uns? of commit\s+([0-9a-f]+)", document.read_text()))
        assert quoted <= kept, f"{document} quotes {quoted - kept}, which is not in results/"


def test_documents_have_the_figures_of_the_runs_that_they_quote():
    directories = {path.parent for path in runs()}
    directories |= {path.parents[1] for path in (ROOT / "results").glob(f"*/*/{MANY_IMAGES}")}
    compared = 0
    for document in marked(ROOT):
        text = document.read_text(encoding="utf-8")
        assert "readme -->\n<!-- end -->" not in text, f"{document} has a part that is not filled"
        for directory in directories:
            if directory.name.rpartition("-")[2] in text:
                assert filled(document, makers_of(directory)) == text, f"./study readme {directory}"
                compared += 1
    assert compared >= 2  # README.md and the claims


def runs():
    """In the tree."""
    return sorted((ROOT / "results").glob("*/*/run.json"))


def test_a_run_its_directory_and_its_rows_have_one_name():
    assert runs()
    for path in runs():
        run = load_run(path.parent)
        assert run.facts["run"] == f"{path.parent.parent.name}/{path.parent.name}"
        assert {row.run for row in run.rows} == {run.facts["run"]}
        assert path.parent.name.endswith(f"-{run.machine['commit']}")
        assert path.parent.parent.name == run.machine["fingerprint"]
