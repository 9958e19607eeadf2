"""What a run says, and which runs are refused."""

from __future__ import annotations

import lzma
from statistics import median

import pytest
from conftest import OPERATION, SIZES, Run, entries, jittered

from report.build import build
from report.errors import ReportError
from report.findings import find
from report.loading import load_study, parse_name
from report.cases import Case
from report.model import Row, RowName
from report.page import to_html


def row_of(run: Run, part: str) -> Row:
    study = load_study(run.write())
    return next(row for row in study.rows if part in str(row.name))


def test_median_is_of_iterations_not_of_aggregates(run):
    name = f"{OPERATION}/bitpacked/baseline/1/kernel/scene"
    row = row_of(run, "bitpacked/baseline/1/kernel/scene")
    right = median(entry["cpu_time"] for entry in run.iterations(name))
    assert row.median_ns == pytest.approx(right)
    assert len(row.samples_ns) == 5


def test_one_thread_is_timed_by_processor_and_several_by_the_clock_on_the_wall(run):
    one = row_of(run, "simd_bitpacked/avx512/1/kernel/scene")
    two = row_of(run, "simd_bitpacked/avx512/2/kernel/scene")
    assert set(one.samples_ns) == {e["cpu_time"] for e in run.iterations("avx512/1/kernel/scene")}
    assert set(two.samples_ns) == {e["real_time"] for e in run.iterations("avx512/2/kernel/scene")}


def test_both_scopes_are_compared_to_the_end_to_end_reference(run):
    study = load_study(run.write())
    reference = next(row for row in study.select(OPERATION, "scene") if row.name.is_reference)
    for row in study.select(OPERATION, "scene"):
        assert row.speedup == pytest.approx(reference.median_ns / row.median_ns)


def test_time_units_are_converted(run):
    for entry in run.iterations("/lut/"):
        entry.update(time_unit="us", cpu_time=entry["cpu_time"] / 1e3)
    width, height = SIZES["scene"]
    assert row_of(run, "/lut/baseline/1/end_to_end/scene").ns_per_pixel == pytest.approx(
        20 / 3, rel=0.01)
    assert row_of(run, "/lut/baseline/1/end_to_end/scene").pixels == width * height


def test_suffixes_of_the_library_are_dropped():
    name = parse_name("thin/lut/avx2/2/kernel/scene/iterations:9/repeats:5/real_time", "here")
    assert name == RowName(Case("thin"), "lut", "avx2", 2, "kernel", "scene")


def test_one_interrupted_repetition_does_not_make_a_row_noisy():
    name = RowName(Case("thin"), "lut", "baseline", 1, "kernel", "scene")
    calm = Row(name, 2, 2, 1, (100.0, 101.0, 100.0, 101.0, 100.0, 101.0, 900.0), 200.0)
    wild = Row(name, 2, 2, 1, (100.0, 110.0, 120.0, 130.0), 200.0)
    assert not calm.is_noisy and wild.is_noisy


def test_spread_of_one_repetition_is_unknown():
    row = Row(RowName(Case("thin"), "lut", "baseline", 1, "kernel", "scene"), 2, 2, 1, (100.0,), 200.0)
    assert row.spread_percent is None and not row.is_noisy


def test_unknown_techniques_and_counters_left_out_are_accepted(run):
    name = f"{OPERATION}/quantum/avx1024/8/kernel/scene"
    added = entries(name, SIZES["scene"], jittered(5e4, name))
    for entry in added:
        del entry["counted_iterations"]
    run.timings["benchmarks"] += added
    assert row_of(run, "quantum").iterations is None


@pytest.mark.parametrize("name", [
    "thin/lut/baseline/1/kernel", "thin//baseline/1/kernel/scene",
    "thin/lut/baseline/0/kernel/scene",
    "thin/lut/baseline/two/kernel/scene", "thin/lut/baseline/1/everything/scene",
    "thin/lut/base\nline/1/kernel/scene", "BM_thin"])
def test_malformed_name_is_refused(name):
    with pytest.raises(ReportError, match="malformed name"):
        parse_name(name, "timings.json")


def test_missing_directory_is_refused(tmp_path, refusal):
    assert "no such directory" in refusal(tmp_path / "nowhere")


@pytest.mark.parametrize("name", ["timings.json", "machine.json", "rows.json"])
def test_missing_file_is_refused(run, refusal, name):
    (run.write() / name).unlink()
    assert name in refusal(run.directory)


@pytest.mark.parametrize("name", ["timings.json", "machine.json", "rows.json"])
def test_truncated_json_is_refused(run, refusal, name):
    path = run.write() / name
    path.write_bytes(path.read_bytes()[:-40])
    error = refusal(run.directory)
    assert name in error and "not complete JSON" in error


def test_packed_files_are_read_and_truncated_ones_are_refused(run, refusal):
    path = run.write() / "timings.json"
    packed = path.with_name("timings.json.xz")
    whole = lzma.compress(path.read_bytes())
    path.unlink()
    packed.write_bytes(whole)
    assert load_study(run.directory).rows
    packed.write_bytes(whole[:-40])
    assert "not complete JSON" in refusal(run.directory)


@pytest.mark.parametrize("text", ["", "[]", "null", '{"benchmarks": 3}', "\xff", "[" * 100000])
def test_other_json_than_a_run_is_refused(run, refusal, text):
    (run.write() / "timings.json").write_text(text, encoding="latin-1")
    assert "timings.json" in refusal(run.directory)


@pytest.mark.parametrize("part", ["machine", "rows"])
@pytest.mark.parametrize("schema", [2, "1", None])
def test_unknown_schema_version_is_refused(run, refusal, part, schema):
    getattr(run, part)["schema"] = schema
    error = refusal(run.write())
    assert f"{part}.json" in error and "schema" in error and "must be 1" in error


@pytest.mark.parametrize("key", ["fingerprint", "commit", "compiler", "libraries"])
@pytest.mark.parametrize("value", [None, "", {}, 7])
def test_missing_provenance_is_refused(run, refusal, key, value):
    run.machine[key] = value
    assert key in refusal(run.write())


def test_row_without_reference_is_refused(run, refusal):
    run.timings["benchmarks"] = [entry for entry in run.timings["benchmarks"]
                                 if "reference/baseline/1/end_to_end/scene" not in entry["name"]]
    error = refusal(run.write())
    assert f"{OPERATION}/reference/baseline/1/end_to_end/scene is needed" in error


@pytest.mark.parametrize("value", [0.0, 0.5, None, "yes"])
def test_unverified_row_is_refused(run, refusal, value):
    run.iterations("simd_bitpacked/avx2/1/kernel/scene")[3]["verified"] = value
    error = refusal(run.write())
    assert "simd_bitpacked/avx2/1/kernel/scene was not verified" in error


def test_failed_verification_anywhere_is_refused(run, refusal):
    run.rows["failed"] = 2
    assert "failed is 2" in refusal(run.write())


def test_run_without_rows_is_refused(run, refusal):
    run.timings["benchmarks"] = [entry for entry in run.timings["benchmarks"]
                                 if entry["run_type"] == "aggregate"]
    assert "no rows" in refusal(run.write())


def test_benchmark_that_reported_an_error_is_refused(run, refusal):
    run.iterations("/lut/")[0].update(error_occurred=True, error_message="output differs")
    assert "output differs" in refusal(run.write())


@pytest.mark.parametrize("value", [0, -1.0, float("nan"), float("inf"), "12", True, None])
def test_time_that_is_no_time_is_refused(run, refusal, value):
    run.iterations("/lut/")[0]["cpu_time"] = value
    assert "cpu_time" in refusal(run.write())


def test_row_of_another_size_than_its_input_is_refused(run, refusal):
    for entry in run.iterations("/lut/baseline/1/end_to_end/scene"):
        entry["width"] = 511
    error = refusal(run.write())
    assert "511 x 412" in error and "510 x 412" in error


def test_repetitions_that_disagree_are_refused(run, refusal):
    run.iterations("/lut/baseline/1/end_to_end/scene")[0]["counted_iterations"] = 15.0
    assert "disagree" in refusal(run.write())


def test_picture_that_is_no_picture_is_refused(run, refusal):
    (run.write() / "pictures/scene.png").write_bytes(b"GIF89a")
    assert "PNG" in refusal(run.directory)


def test_place_that_cannot_be_written_is_said_and_nothing_is_left(run, refusal):
    (run.write() / "plots").write_text("in the way")
    assert "plots: cannot be written" in refusal(run.directory)


def test_peers_are_shown_but_never_the_fastest(run):
    name = f"{OPERATION}/opencv/own/1/end_to_end/scene"
    added = entries(name, SIZES["scene"], jittered(10.0, name))
    for entry in added:
        entry["peer"] = 1.0
    run.timings["benchmarks"] += added
    run.rows["peers"] = [{"technique": "opencv", "about": "OpenCV, 1 thread"}]
    study = load_study(run.write())
    finding = next(one for one in find(study) if one.input == "scene")
    assert finding.best and not finding.best.is_peer
    assert [row.name.technique for row in finding.peers] == ["opencv"]
    build(run.directory)
    page, text = ((run.directory / name).read_text() for name in ("index.html", "timings.md"))
    assert 'opencv <span class="flag">peer</span>' in page and "| opencv (peer) |" in text
    assert "OpenCV, 1 thread" in to_html(study, [], [], [])
