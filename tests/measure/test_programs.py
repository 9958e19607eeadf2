"""thinbench_benchmarks: facts, samples, controls and errors. Nothing here depends on how long a call takes."""

from __future__ import annotations

import csv
import json
import subprocess
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from tests.programs import PROGRAMS

NAME = "edges_sobel/autovec/baseline/1/end_to_end/square_64"
REFERENCE = "edges_sobel/reference/baseline/1/end_to_end/square_64"
ROW = ("--input", "square_64", "--no-peers", "--filter", f"^{NAME}$")
COLUMNS = ["row", "repetition", "calls", "wall_ns", "cpu_ns", "probe_before_ns", "probe_after_ns", "cycle_ns"]


def benchmarks(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAMS / "thinbench_benchmarks", *words], text=True, capture_output=True, check=False)


@pytest.fixture(name="facts", scope="module")
def _facts(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("facts") / "facts.json"
    done = benchmarks(*ROW, "--facts", path)
    assert (done.returncode, done.stdout) == (0, ""), done.stderr
    return path


def measured(tmp_path: Path, *words: str | Path) -> list[dict[str, Any]]:
    """Lines of the samples."""
    done = benchmarks("--samples", tmp_path / "samples.csv", *words)
    assert done.returncode == 0, done.stderr
    with (tmp_path / "samples.csv").open(encoding="utf-8") as stream:
        lines = list(csv.DictReader(stream))
    assert list(lines[0]) == COLUMNS
    return lines


def changed(facts: Path, tmp_path: Path, **values: object) -> Path:
    """Facts with other values of the row."""
    document = json.loads(facts.read_text(encoding="utf-8"))
    document["rows"][NAME] |= values
    path = tmp_path / "changed.json"
    path.write_text(json.dumps(document), encoding="utf-8")
    return path


def test_facts_tell_of_the_row_and_its_reference(facts: Path) -> None:
    document = json.loads(facts.read_text(encoding="utf-8"))
    assert list(document) == ["sources", "inputs", "peers", "rows", "skipped", "verified", "mismatches"]
    assert sorted(document["rows"]) == [NAME, REFERENCE] and document["verified"] == 1
    row = document["rows"][NAME]
    assert {"case", "operation", "border", "max_iterations", "technique", "isa", "threads", "scope", "input",
            "iterations", "peer", "default", "scalar", "seconds", "hash"} == set(row)
    assert row["hash"] == document["rows"][REFERENCE]["hash"] and row["seconds"] > 0
    assert [item["name"] for item in document["inputs"]] == ["square_64"]


def test_known_rows_and_their_controls_are_measured(facts: Path, tmp_path: Path) -> None:
    lines = measured(tmp_path, "--known", facts)
    assert {line["row"] for line in lines} == {NAME, REFERENCE, f"{NAME}/again", f"{NAME}/slowed"}
    for line in lines:
        assert int(line["calls"]) >= 1
        assert all(float(line[name]) > 0 for name in COLUMNS[3:] if name != "cpu_ns")
    repetitions = Counter(line["row"] for line in lines)
    assert all(1 <= count <= 25 for count in repetitions.values())


def test_by_hand_every_row_is_repeated_so_that_a_median_is_shown(tmp_path: Path) -> None:
    lines = measured(tmp_path, *ROW, "--seconds-per-row", "0")
    assert set(Counter(line["row"] for line in lines).values()) == {4}


def test_pictures_are_the_inputs_and_what_operations_make_of_them(tmp_path: Path) -> None:
    out = tmp_path / "new" / "pictures"
    done = benchmarks("--pictures", out, "--input", "square_64")
    assert (done.returncode, done.stdout) == (0, ""), done.stderr
    found = {path.name for path in out.iterdir()}
    assert {"square_64.png", "square_64_grey.png", "square_64_thin_guo_hall_keep.png", "square_64_edges_sobel.png",
            "square_64_fill_holes.png"} <= found
    assert not {"square_64_net_two_layer_linear.png", "square_64_holes.png"} & found


def test_an_unknown_input_of_pictures_is_one_line(tmp_path: Path) -> None:
    done = benchmarks("--pictures", tmp_path / "pictures", "--input", "squares")
    assert done.returncode == 2 and "input 'squares': expected scene, square_N" in done.stderr
    assert done.stderr.count("\n") == 1 and not (tmp_path / "pictures").exists()


def test_more_seconds_are_more_repetitions(facts: Path, tmp_path: Path) -> None:
    few, many = (len(measured(tmp_path, "--known", facts, "--seconds-per-row", seconds)) for seconds in ("0", "1"))
    assert (few, many) == (4, 4 * 25)


def test_the_injected_delay_is_a_tenth_of_what_the_facts_say(facts: Path, tmp_path: Path) -> None:
    """With so long a call the delay is a millisecond, whatever the call takes; where each sample of the clock cycle
    was interrupted, less."""
    lines = measured(tmp_path, "--known", changed(facts, tmp_path, seconds=0.01), "--benchmark_filter=/slowed$")
    assert any(float(line["wall_ns"]) > 0.9e6 for line in lines)


def test_a_wrong_result_is_an_error_and_other_rows_are_measured(facts: Path, tmp_path: Path) -> None:
    samples = tmp_path / "samples.csv"
    done = benchmarks("--known", changed(facts, tmp_path, hash="0123456789abcdef"), "--samples", samples)
    assert done.returncode == 1 and "it gave another result" in done.stderr
    with samples.open(encoding="utf-8") as stream:
        assert {line["row"] for line in csv.DictReader(stream)} == {REFERENCE}


def test_results_that_an_earlier_process_compared_are_not_compared_again(facts: Path, tmp_path: Path) -> None:
    wrong = changed(facts, tmp_path, hash="0123456789abcdef")
    assert len(measured(tmp_path, "--known", wrong, "--checked")) == len(measured(tmp_path, "--known", facts))


@pytest.mark.parametrize("text", ["{}", '{"rows": {'])
def test_facts_that_are_none_are_named(tmp_path: Path, text: str) -> None:
    path = tmp_path / "facts.json"
    path.write_text(text, encoding="utf-8")
    done = benchmarks("--known", path)
    assert done.returncode == 1 and done.stderr.count("\n") == 1 and "facts.json: holds no facts" in done.stderr


def test_slow_rows_are_skipped_with_the_reason(tmp_path: Path) -> None:
    path = tmp_path / "facts.json"
    assert benchmarks(*ROW, "--max-call", "1e-9", "--facts", path).returncode == 0
    document = json.loads(path.read_text(encoding="utf-8"))
    assert document["rows"] == {}
    assert {item["reason"] for item in document["skipped"]} == {"a call takes more than 1e-09 s"}


@pytest.mark.parametrize(("words", "message"), [
    (("--filter", "no_such_row"), "no row matches the filter 'no_such_row'"),
    (("--facts", "a", "--known", "b"), "--facts"),
    (("--checked",), "--checked requires --known"),
    (("--bogus",), "there is no option '--bogus'")])
def test_wrong_usage_is_status_2_and_a_line(words: tuple[str, ...], message: str) -> None:
    done = benchmarks(*words)
    assert done.returncode == 2 and message in done.stderr and done.stderr.count("\n") == 1


def test_by_hand_each_row_is_a_line_with_its_name() -> None:
    done = benchmarks("--input", "square_64", "--benchmark_filter=^edges_sobel/autovec/baseline/1", "--seconds-per-row", "0")
    assert done.returncode == 0, done.stderr
    lines = [line for line in done.stdout.splitlines() if line.startswith("edges_sobel/")]
    assert sorted(line.split()[0] for line in lines) == [f"{NAME}/again_median", f"{NAME}/slowed_median", f"{NAME}_median"]


def test_google_benchmarks_json_has_every_repetition() -> None:
    done = benchmarks("--input", "square_64", "--filter", "^edges_sobel/", "--benchmark_filter=autovec/baseline/1",
                      "--seconds-per-row", "0", "--benchmark_format=json")
    found = json.loads(done.stdout)["benchmarks"]
    names = [row["name"] for row in found if row["run_type"] == "iteration"]
    assert names.count(NAME) == 4
    assert all(row["probe_before"] > 0 for row in found if row["run_type"] == "iteration")


def test_google_benchmarks_json_names_each_value_of_a_repetition_once() -> None:
    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        assert len(dict(pairs)) == len(pairs), pairs
        return dict(pairs)

    done = benchmarks("--input", "square_64", "--benchmark_filter=^thin_guo_hall/lut/baseline/1",
                      "--seconds-per-row", "0", "--benchmark_format=json")
    row = json.loads(done.stdout, object_pairs_hook=once)["benchmarks"][0]
    assert row["thinning_iterations"] > 1 and row["iterations"] >= 1
