"""Speed-ups that were measured in pairs, and runs that have none."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import pytest
from conftest import OPERATION, Run

from report.build import build
from report.loading import load_study
from report.summary import to_text

HEADER = ("operation,technique,isa,threads,scope,input,against,ratio,low,high,processes,rounds,"
          "reference_ns,variant_ns,clock,layout,output_hash,flags,verified,against_row")
ROW = f"{OPERATION},simd_bitpacked,avx512,2,end_to_end,scene"
REST = "9,18,4200000,42000,wall,0+2048,0123456789abcdef"


def with_speedups(run: Run, ratios: str = "123.4,120.1,125.9", flags: str = "via",
                  against: str = "reference") -> Run:
    directory = run.write()
    lines = [HEADER, f"{ROW},{against},{ratios},{REST},{flags},1,{OPERATION}/reference"]
    (directory / "speedups.csv").write_text("\n".join(lines) + "\n")
    write_controls(directory)
    return run


def write_controls(directory: Path, **changed: Any) -> None:
    """The first line of the samples, and the beginning of another."""
    same, slowed = ({"ratio": r, "low": r - 0.01, "high": r + 0.01} for r in (1.0, 0.91))
    first = {"schema": 1, "kind": "run", "processes": 9, "control_same": same,
             "control_slowed": slowed, "groups_with_failed_control": 0, "verdict": "PASS"} | changed
    (directory / "samples.jsonl").write_text(json.dumps(first) + '\n{"kind": "row", ')


def row_in_csv(run: Run) -> dict[str, str]:
    rows = csv.DictReader((run.directory / "timings.csv").read_text().splitlines())
    return next(row for row in rows if ",".join(list(row.values())[:6]) == ROW)


def test_paired_ratio_takes_the_place_of_the_ratio_of_medians(run):
    printed = " ".join(build(with_speedups(run).directory).split())
    found = row_in_csv(run)
    assert found["speedup_vs_reference"] == "123.4000"
    assert (found["speedup_low"], found["speedup_high"]) == ("120.1000", "125.9000")
    assert found["speedup_from"] == "paired"
    assert "123 times as fast as the scalar reference" in printed
    assert "interval 120 to 126" in printed
    assert "123× (120 to 126)" in (run.directory / "index.html").read_text()
    assert "123× (120 to 126)" in (run.directory / "timings.md").read_text()


def test_rows_that_were_not_paired_keep_the_ratio_of_medians_and_say_so(run):
    printed = " ".join(build(with_speedups(run).directory).split())
    assert "Speed-ups of 1 of 27 rows were measured in pairs by 9 processes, all controls" in printed
    rows = list(csv.DictReader((run.directory / "timings.csv").read_text().splitlines()))
    assert sum(row["speedup_from"] == "medians" for row in rows) == len(rows) - 1


def test_run_without_pairs_says_so(run):
    study = load_study(run.write())
    assert not study.has_pairs
    assert "this run has no speedups.csv" in to_text(study)


def test_pairs_with_other_rows_are_no_speed_up_over_the_reference(run):
    assert not load_study(with_speedups(run, against="best_scalar").directory).has_pairs


def test_inconclusive_ratios_are_marked_everywhere(run):
    printed = build(with_speedups(run, flags="via;inconclusive").directory)
    assert "123×?" in printed
    assert "1 are inconclusive" in " ".join(printed.split())
    assert "123× (120 to 126, inconclusive)" in (run.directory / "timings.md").read_text()


@pytest.mark.parametrize(("ratios", "complaint"), [
    ("fast,1,2", "line 2: ratio is 'fast'; it must be a number above zero"),
    ("1,-1,2", "line 2: low is '-1'; it must be a number above zero"),
    ("1,nan,2", "line 2: low is 'nan'; it must be a number above zero"),
    ("3,1,2", "line 2: ratio 3 is not between low 1 and high 2; it must be"),
])
def test_ratios_that_cannot_be_are_refused(run, refusal, ratios, complaint):
    assert complaint in refusal(with_speedups(run, ratios).directory)


def test_table_without_a_column_or_cut_short_is_refused(run, refusal):
    path = with_speedups(run).directory / "speedups.csv"
    whole = path.read_text()
    path.write_text(whole.replace(",against,", ",towards,"))
    assert "column 'against' is missing; it must be given" in refusal(run.directory)
    path.write_text(whole[:whole.index(",9,18,")])
    assert "line 2: fields are missing; measure it again" in refusal(run.directory)
    path.write_bytes(b"\xff\xfe")
    assert "not a table" in refusal(run.directory)


def test_noise_controls_stand_on_the_page(run):
    build(with_speedups(run).directory)
    page = (run.directory / "index.html").read_text()
    assert ("a row against itself 1.000 (0.990 to 1.010), a row slowed by 10 % 0.910 "
            "(0.900 to 0.920), 0 groups with a failed control: PASS") in page


@pytest.mark.parametrize(("changed", "complaint"), [
    ({"schema": 2}, "samples.jsonl: schema is 2; it must be 1"),
    ({"kind": "row"}, "samples.jsonl: kind is 'row'; the first line must be of kind 'run'"),
    ({"control_same": None}, "samples.jsonl: field 'control_same' is missing; it must be given"),
    ({"control_slowed": None}, "field 'control_slowed' is missing; it must be given"),
])
def test_speedups_without_noise_controls_are_refused(run, refusal, changed, complaint):
    write_controls(with_speedups(run).directory, **changed)
    assert complaint in refusal(run.directory)
    (run.directory / "samples.jsonl").unlink()
    assert "samples.jsonl: no such file; a finished run leaves it here" in refusal(run.directory)


@pytest.mark.parametrize(("right", "wrong", "complaint"), [
    (",0+2048,", ",,", "line 2: layout is ''; it must be given"),
    (",wall,", ",,", "line 2: clock is ''; it must be given"),
    (",0123456789abcdef,", ",,", "line 2: output_hash is ''; it must be given"),
    (",1,thin", ",0,thin", "line 2: verified is '0'; it must be 1"),
    (",layout,", ",place,", "column 'layout' is missing; it must be given"),
    (",avx512,", ",sve2,", "speedups.csv: row thin_naccache_shinghal/simd_bitpacked/sve2/2/"
     "end_to_end/scene is not in timings.json; all files must come from one run"),
])
def test_speedups_without_provenance_or_of_another_run_are_refused(run, refusal, right, wrong,
                                                                   complaint):
    path = with_speedups(run).directory / "speedups.csv"
    path.write_text(path.read_text().replace(right, wrong))
    assert complaint in refusal(run.directory)
