"""The table of what bounds rows."""

from __future__ import annotations

import csv
import json
import re
from typing import Any

import pytest
from conftest import OPERATION, ROOT, Run, entries

from report.build import build
from report.limit_reasons import OF_TECHNIQUE, SENTENCES


def make_limits(**changed: Any) -> dict[str, Any]:
    """Two scopes of a row, of which one has iterations; times are near those of the run."""
    row = {"operation": OPERATION, "technique": "simd_bitpacked", "isa": "avx512",
           "scope": "end_to_end", "instructions": 300000, "ns": 45000.0,
           "instructions_per_cycle": 3.25, "limit_ns": 25000.0, "percent_of_limit": 54.2}
    kernel = row | {"scope": "kernel", "ns": 22000.0, "limit_ns": 12000.0,
                    "instructions_per_row_and_iteration": 52.04}
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
            "| 54 % | \N{EN DASH} | 7.00 | vector ports |") in text
    assert "| 22.00 | 12.00 | 54 % | 52.0 | \N{EN DASH} | vector ports |" in text


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
    assert "| 300,000 | 3.25 | 45.00 | 25.00 | 54 % | \N{EN DASH} | 8.00 | vector ports |" in text
    write(run, make_limits(technique="simd_bytes"))
    build(run.directory)
    assert "54 % | \N{EN DASH} | \N{EN DASH} |" in (run.directory / "limits.md").read_text()


def test_figure_shows_the_fastest_row_of_each_operation_and_scope(run):
    limits = make_limits()
    limits["rows"].append(limits["rows"][1] | {"technique": "lut", "ns": 90000.0})
    build(write(run, limits).directory)
    rows = list(csv.DictReader((run.directory / "plots/limits.csv").read_text().splitlines()))
    assert [(row["scope"], row["ns"], row["limit_ns"], row["bottleneck"]) for row in rows] == [
        ("end_to_end", "45000.0", "25000.0", "vector ports"),
        ("kernel", "22000.0", "12000.0", "vector ports")]
    drawing = (run.directory / "plots/limits.svg").read_text()
    assert "54 %" in drawing and "45.0 µs, limit 25.0 µs</title>" in drawing
    assert len(drawing) < 20_000
    page = (run.directory / "index.html").read_text()
    assert 'href="plots/limits.csv"' in page and "![" in (run.directory / "limits.md").read_text()


def techniques() -> list[str]:
    """The names in the catalogue."""
    text = (ROOT / "kernels/include/thinbench/options.hpp").read_text()
    names = re.findall(r'TechniqueInfo\{Technique::\w+,\s*"(\w+)"', text)
    assert len(names) == len(set(re.findall(r"Technique::(\w+),", text))) > 0
    return names


def test_every_technique_has_a_known_bound():
    missing = [name for name in techniques() if name not in OF_TECHNIQUE]
    assert not missing, (f"{', '.join(missing)}: OF_TECHNIQUE in report/limit_reasons.py must say "
                         "what bounds them")
    gone = [name for name in OF_TECHNIQUE if name not in techniques()]
    assert not gone, f"{', '.join(gone)}: in OF_TECHNIQUE, but no technique in options.hpp"
    assert set(OF_TECHNIQUE.values()) <= SENTENCES.keys()


def between(run: Run, **changed: Any) -> dict[str, str]:
    """The last column by scope."""
    build(write(run, make_limits(**changed)).directory)
    lines = (run.directory / "limits.md").read_text().splitlines()
    cells = [line[2:-2].split(" | ") for line in lines if line.startswith(f"| {OPERATION}")]
    return {row[1]: row[-1] for row in cells}


@pytest.mark.parametrize("technique, word", [
    ("lut", "table loads"), ("bitpacked", "integer ports"), ("bitpacked_runs", "branches"),
    ("simd_bitpacked_tiles", "lists"), ("new_one", "not known")])
def test_row_below_its_limit_has_the_bound_of_its_technique(run, technique, word):
    assert between(run, technique=technique) == {"end to end": word, "kernel": "vector ports"}


@pytest.mark.parametrize("percent, word", [(79.9, "vector ports"), (80.0, ""), (104.0, "")])
def test_nothing_stands_between_from_four_fifths_of_the_limit(run, percent, word):
    assert between(run, percent_of_limit=percent)["end to end"] == word


def copied(run: Run, scope: str, ns: float) -> None:
    """A copy beside the rows."""
    run.timings["benchmarks"] += [entry | {"peer": 1} for entry in entries(
        f"{OPERATION}/copy/own/1/{scope}/scene", (510, 412), [ns])]


@pytest.mark.parametrize("ns, word", [(22500.0, "bytes"), (22400.0, "vector ports")])
def test_copy_that_takes_half_of_the_time_means_bytes(run, ns, word):
    copied(run, "end_to_end", ns)
    assert between(run)["end to end"] == word


def test_kernels_are_not_bound_by_bytes(run):
    copied(run, "kernel", 21000.0)
    assert between(run)["kernel"] == "vector ports"


@pytest.mark.parametrize("ns, word", [(53000.0, "unsteady"), (50000.0, "vector ports")])
def test_row_that_took_a_tenth_less_among_the_timings_is_unsteady(run, ns, word):
    assert between(run, ns=ns) == {"end to end": word, "kernel": "vector ports"}


def test_words_are_explained_once_and_only_those_that_occur(run):
    between(run)
    page, text = ((run.directory / name).read_text() for name in ("index.html", "limits.md"))
    assert text.count(f"- vector ports: {SENTENCES['vector ports']}") == 1
    assert page.count("<dt>vector ports</dt>") == 1
    assert "- branches" not in text and "<dt>branches</dt>" not in page
    limits = make_limits()
    limits["rows"] = [row | {"percent_of_limit": 90.0} for row in limits["rows"]]
    build(write(run, limits).directory)
    assert "\n- " not in (run.directory / "limits.md").read_text()


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
