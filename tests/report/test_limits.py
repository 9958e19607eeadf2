"""The table of what bounds rows."""

from __future__ import annotations

import csv
import json
from typing import Any

from conftest import OPERATION, Run, entries

from report.build import build


def make_limits(**changed: Any) -> dict[str, Any]:
    """Two scopes of a row, of which one has passes."""
    row = {"operation": OPERATION, "technique": "simd_bitpacked", "isa": "avx512",
           "scope": "end_to_end", "instructions": 300000, "ns": 45000.0,
           "instructions_a_cycle": 3.25, "limit_ns": 25000.0, "percent_of_limit": 54.2}
    kernel = row | {"scope": "kernel", "ns": 30000.0, "instructions_a_row_and_pass": 52.04}
    return {"schema": 1, "kind": "limits", "issue_width": 6.0,
            "input": {"name": "scene", "width": 510, "height": 412},
            "rows": [kernel, row | changed], "skipped": [{"row": "x", "reason": "y"}]}


def write(run: Run, limits: dict[str, Any]) -> Run:
    """The run with limits beside it."""
    (run.write() / "limits.json").write_text(json.dumps(limits))
    return run


def test_limits_stand_on_the_page_and_in_a_file_of_their_own(run):
    run.timings["benchmarks"] += [entry | {"peer": 1} for entry in entries(
        f"{OPERATION}/copy/own/1/end_to_end/scene", (510, 412), [7000.0])]
    build(write(run, make_limits()).directory)
    page, text = ((run.directory / name).read_text() for name in ("index.html", "limits.md"))
    assert 'id="limits"' in page and 'href="#limits"' in page
    assert "issues 6 instructions in every cycle" in page and "1 rows execute too many" in page
    assert (f"| {OPERATION} | end to end | simd_bitpacked | avx512 | 300,000 | 3.25 | 45.00 | 25.00 "
            "| 54 % | \N{EN DASH} | 7.00 |") in text
    assert "| 30.00 | 25.00 | 54 % | 52.0 | \N{EN DASH} |" in text


def test_the_sentence_says_how_instructions_were_counted(run):
    build(write(run, make_limits()).directory)
    assert "510 x 412 pixels, counted by single steps;" in (run.directory / "limits.md").read_text()
    write(run, make_limits(method="callgrind"))
    build(run.directory)
    text = (run.directory / "limits.md").read_text()
    assert "counted, 1 rows by callgrind and the others by single steps;" in text


def test_bit_packed_rows_are_set_beside_a_copy_of_packed_bits(run):
    fill = [f"fill_holes/{what}/1/end_to_end/scene" for what in ("reference/baseline", "copy_bits/own")]
    run.timings["benchmarks"] += entries(fill[0], (510, 412), [9000.0])
    run.timings["benchmarks"] += [entry | {"peer": 1}
                                  for entry in entries(fill[1], (510, 412), [8000.0])]
    build(write(run, make_limits()).directory)
    text = (run.directory / "limits.md").read_text()
    assert "| simd_bitpacked | avx512 | 300,000 | 3.25 | 45.00 | 25.00 | 54 % | \N{EN DASH} | 8.00 |" in text
    write(run, make_limits(technique="simd_bytes"))
    build(run.directory)
    assert "54 % | \N{EN DASH} | \N{EN DASH} |" in (run.directory / "limits.md").read_text()


def test_figure_shows_the_fastest_row_of_each_operation_and_scope(run):
    limits = make_limits()
    limits["rows"].append(limits["rows"][1] | {"technique": "lut", "ns": 90000.0})
    build(write(run, limits).directory)
    rows = list(csv.DictReader((run.directory / "plots/limits.csv").read_text().splitlines()))
    assert [(row["scope"], row["ns"], row["limit_ns"]) for row in rows] == [
        ("end_to_end", "45000.0", "25000.0"), ("kernel", "30000.0", "25000.0")]
    drawing = (run.directory / "plots/limits.svg").read_text()
    assert "54 %" in drawing and "45.0 µs, limit 25.0 µs</title>" in drawing
    assert len(drawing) < 20_000
    page = (run.directory / "index.html").read_text()
    assert 'href="plots/limits.csv"' in page and "![" in (run.directory / "limits.md").read_text()


def test_run_without_limits_has_no_such_section(run):
    build(run.write())
    assert 'id="limits"' not in (run.directory / "index.html").read_text()
    assert not (run.directory / "limits.md").exists()


def test_limits_that_cannot_be_are_refused(run, refusal):
    assert "schema is 2; it must be 1" in refusal(write(run, make_limits() | {"schema": 2}).directory)
    assert "rows[1]: ns is 0; it must be a number above zero" in refusal(
        write(run, make_limits(ns=0)).directory)
    assert "scope is 'all'; it must be end_to_end or kernel" in refusal(
        write(run, make_limits(scope="all")).directory)
