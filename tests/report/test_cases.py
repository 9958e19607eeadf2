"""Cases of one operation: never merged, and read from runs that named them otherwise."""

from __future__ import annotations

import csv
import json

import pytest
from conftest import ROOT, Run, entries, jittered

from report.build import build
from report.cases import Case, case_named, file_stem
from report.findings import find
from report.loading import load_study
from report.short_tables import SHORT_TABLES

GUO_HALL = "thin_guo_hall"
KEEP = f"{GUO_HALL}:keep"
COMMITTED = ROOT / "results/intel-6-143-8-244dfdf2/2026-11-21-19cd2e2507"


@pytest.mark.parametrize(("name", "case"), [
    (GUO_HALL, Case(GUO_HALL, "background")),
    (KEEP, Case(GUO_HALL, "keep")),
    ("net_two_layer_linear:1", Case("net_two_layer_linear", "background", 1)),
    ("skeleton_scan:keep:20", Case("skeleton_scan", "keep", 20)),
    ("holes", Case("holes")),
])
def test_names_of_cases_are_read_and_written(name, case):
    assert case_named(name) == case and case.name == name


def test_older_names_are_those_of_cases():
    assert case_named("thin_guo_hall_keep_border") == case_named(KEEP)
    assert case_named("net_two_layer_linear_pass") == case_named("net_two_layer_linear:1")


@pytest.mark.parametrize("name", ["thin:", "thin:keep:", "thin:0", "thin:2:keep", "thin:other"])
def test_names_that_cannot_be_are_refused(run, refusal, name):
    assert case_named(name) is None
    run.iterations("/lut/baseline/1/end_to_end/scene")[0]["name"] = (
        f"{name}/lut/baseline/1/end_to_end/scene")
    assert f"case is '{name}'" in refusal(run.write())


def test_names_of_files_hold_no_colon():
    assert file_stem("net_two_layer_linear:keep:1") == "net_two_layer_linear_keep_1"


def with_both_borders(run: Run, peer_case: str = KEEP, peer_isa: str = "native") -> Run:
    """The run with Guo and Hall's rule by both borders, and OpenCV's time."""
    for case, border, times in ((GUO_HALL, "background", (1e7, 2e4)), (KEEP, "keep", (3e7, 5e4))):
        for row, ns in zip(("reference/baseline", "lut/baseline"), times):
            name = f"{case}/{row}/1/end_to_end/scene"
            run.timings["benchmarks"] += [entry | {"label": border} for entry in
                                          entries(name, (510, 412), jittered(ns, name, 9))]
    name = f"{peer_case}/opencv/{peer_isa}/1/end_to_end/scene"
    run.timings["benchmarks"] += [entry | {"label": "background" if peer_case == GUO_HALL else "keep",
                                           "peer": 1.0} for entry in
                                  entries(name, (510, 412), jittered(1e8, name, 9))]
    run.rows["peers"] = [{"technique": "opencv", "about": "OpenCV", "equal_output": True}]
    return run


def test_each_border_has_its_own_reference_files_and_columns(run):
    study = load_study(with_both_borders(run).write())
    found = {finding.case: finding for finding in find(study) if finding.input == "scene"}
    assert found[GUO_HALL].best.speedup == pytest.approx(500, rel=0.05)
    assert found[KEEP].best.speedup == pytest.approx(600, rel=0.05)
    assert not found[GUO_HALL].peers and [p.name.technique for p in found[KEEP].peers] == ["opencv"]
    build(run.directory)
    rows = list(csv.DictReader((run.directory / "timings.csv").read_text().splitlines()))
    own = [row for row in rows if row["operation"] == GUO_HALL]
    assert sorted(row["border"] for row in own) == ["background"] * 2 + ["keep"] * 3
    assert all(row["max_iterations"] == "" for row in rows)
    assert all((run.directory / f"plots/speedup_{stem}_scene.csv").exists()
               for stem in (GUO_HALL, f"{GUO_HALL}_keep"))


@pytest.mark.parametrize(("case", "isa"), [(KEEP, "native"), (GUO_HALL, "own")])
def test_ratio_to_opencv_is_of_the_case_that_it_equals(run, case, isa):
    study = load_study(with_both_borders(run, case, isa).write())
    [line] = [row for row in SHORT_TABLES["headline"](study).rows if GUO_HALL in row[0]]
    ratio = float(line[3].split("×")[0].replace(",", ""))
    assert float(line[1]) == pytest.approx(50, rel=0.02) and "OpenCV's" in line[3]
    assert ratio == pytest.approx(2000, rel=0.02)


def test_time_of_a_peer_of_other_pixels_is_not_divided(run):
    with_both_borders(run).rows["peers"][0]["equal_output"] = False
    build(run.write())
    page = (run.directory / "index.html").read_text()
    assert "opencv: 100" in page and "the fastest row's time" not in page


@pytest.mark.parametrize(("changed", "complaint"), [
    ({"border": "wide"}, "border is 'wide'"), ({"max_iterations": -1}, "max_iterations is -1")])
def test_columns_that_cannot_be_are_refused(run, refusal, changed, complaint):
    row = {"operation": "holes", "border": "", "max_iterations": None, "technique": "lut",
           "isa": "baseline", "scope": "kernel", "instructions": 1, "instructions_per_cycle": 1,
           "ns": 1, "limit_ns": 1, "percent_of_limit": 1}
    (run.write() / "limits.json").write_text(json.dumps(
        {"schema": 1, "issue_width": 6, "input": {"name": "scene", "width": 510, "height": 412},
         "rows": [row | changed], "skipped": []}))
    assert complaint in refusal(run.directory)


@pytest.mark.skipif(not COMMITTED.exists(), reason="no committed run")
def test_committed_run_is_read_by_case():
    study = load_study(COMMITTED)
    assert {"thin_zhang_suen:keep", KEEP, "net_single_layer_cluster:1"} <= set(study.cases)
    peers = {(row.name.case.name, row.name.technique) for row in study.rows if row.is_peer}
    assert (KEEP, "opencv") in peers and (GUO_HALL, "opencv") not in peers
    assert not any(row.name.isa == "own" for row in study.rows)
