"""Runs that do not say where they come from, or say different things, are refused."""

from __future__ import annotations

import json
import lzma
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import OPERATION, ROOT, Run
from test_limits import make_limits

from report.build import build

BUILD = {"compiler": {"id": "GNU", "version": "12.2.0", "flags": "-O3", "build_type": "Release"}}
COMMITTED = sorted((ROOT / "results").glob("*/*/machine.json"))


def seal(directory: Path) -> None:
    """As ./study does at the end of a run."""
    subprocess.run([sys.executable, ROOT / "bench/scripts/seal.py", directory], check=True)


def sealed(run: Run) -> Path:
    """A run with an experiment, as ./study leaves it."""
    run.timings["context"] |= {"thinbench_fingerprint": run.machine["fingerprint"],
                               "thinbench_commit": run.machine["commit"]}
    directory = run.write()
    (directory / "experiments").mkdir()
    (directory / "experiments/table-2.json").write_text(json.dumps(TABLE_TWO))
    seal(directory)
    return directory


TABLE_TWO = {"schema": 1, "experiment": "table-2", "command": "c", "image": "510 x 412",
             "machine": "Pentium II", "rows": [
                 {"method": "Rule", "operation": OPERATION, "paper_seconds": 0.7,
                  "paper_ratio": 1.0}]}


@pytest.mark.parametrize("path", COMMITTED, ids=lambda path: path.parent.name)
def test_committed_runs_are_accepted(path, tmp_path):
    copy = shutil.copytree(path.parent, tmp_path / "run")
    assert "Page:" in build(copy)


def test_sealed_runs_are_accepted_also_when_packed(run):
    directory = sealed(run)
    assert "Page:" in build(directory)
    plain = directory / "timings.json"
    (directory / "timings.json.xz").write_bytes(lzma.compress(plain.read_bytes()))
    plain.unlink()
    assert "Page:" in build(directory)


@pytest.mark.parametrize("key", ["fingerprint", "commit", "compiler", "libraries", "cpu", "cores",
                                 "os", "kernel", "date", "caches", "isa_available", "options"])
def test_machine_without_a_field_is_refused_by_its_name(run, refusal, key):
    del run.machine[key]
    assert f"machine.json: field '{key}' is missing; it must be given" in refusal(run.write())


@pytest.mark.parametrize("key", ["name", "flags"])
def test_processor_without_a_field_is_refused_by_its_name(run, refusal, key):
    del run.machine["cpu"][key]
    assert f"machine.json: cpu: field '{key}' is missing" in refusal(run.write())


@pytest.mark.parametrize("key", ["id", "version", "flags", "build_type"])
def test_build_without_a_field_is_refused_by_its_name(run, refusal, key):
    del run.machine["compiler"][key]
    assert f"machine.json: compiler: {key} is None; it must be a string" in refusal(run.write())


def test_no_libraries_and_no_instruction_sets_are_refused(run, refusal):
    run.machine["libraries"] = {}
    assert "libraries: names no library" in refusal(run.write())
    run.machine |= {"libraries": {"xsimd": "8.1.0"}, "isa_available": []}
    assert "isa_available is []; it must name an instruction set" in refusal(run.write())


def test_input_without_its_hash_is_refused(run, refusal):
    del run.rows["inputs"][0]["hash"]
    assert "inputs[0]: field 'hash' is missing; it must be given" in refusal(run.write())
    del run.rows["inputs"][0]
    assert ("rows.json has no input 'scene'; its size and hash are needed"
            in refusal(run.write()))


@pytest.mark.parametrize(("key", "what", "right"), [
    ("thinbench_fingerprint", "machine", "intel-6-143-8-1a2b3c4d"),
    ("thinbench_commit", "commit", "abc1234"), ("thinbench_build_type", "build", "Release")])
def test_timings_of_another_machine_commit_or_build_are_refused(run, refusal, key, what, right):
    run.timings["context"][key] = "other"
    assert (f"timings.json: context: is of {what} 'other', but machine.json of '{right}'; "
            "all files must come from one run") in refusal(run.write())


def test_timings_of_a_machine_with_other_caches_are_refused(run, refusal):
    run.timings["context"]["caches"] = [
        {"type": "Data", "level": 1, "size": 32768, "num_sharing": 1},
        {"type": "Instruction", "level": 1, "size": 32768, "num_sharing": 1},
        {"type": "Unified", "level": 2, "size": 2097152, "num_sharing": 1}]
    assert ("is of machine with caches 'L1 32 KiB, L2 2048 KiB', but machine.json of "
            "'L1 48 KiB, L2 2048 KiB'") in refusal(run.write())
    run.timings["context"]["caches"][0]["size"] = 49152
    assert "Page:" in build(run.write())


@pytest.mark.parametrize(("changed", "complaint"), [
    ({"build": BUILD | {"compiler": BUILD["compiler"] | {"version": "13.1.0"}}},
     "limits.json: build: compiler: is of compiler version '13.1.0', but machine.json of '12.2.0'"),
    ({"build": BUILD | {"compiler": BUILD["compiler"] | {"flags": "-O2"}}},
     "is of compiler flags '-O2', but machine.json of '-O3'"),
    ({"rows": [make_limits()["rows"][0] | {"isa": "avx512icl"}]},
     "rows[0]: isa is 'avx512icl', but machine.json has baseline, sse4.2, avx2, avx512"),
    ({"input": {"name": "scene", "width": 510, "height": 412, "hash": "fedcba"}},
     "hash of 'scene' is fedcba, but 0123456789abcdef in rows.json"),
])
def test_limits_of_another_build_machine_or_input_are_refused(run, refusal, changed, complaint):
    limits = make_limits() | {"build": BUILD}
    path = run.write() / "limits.json"
    path.write_text(json.dumps(limits))
    assert "Page:" in build(run.directory)
    path.write_text(json.dumps(limits | changed))
    assert complaint in refusal(run.directory)


@pytest.mark.parametrize("name", ["timings.json", "rows.json", "machine.json",
                                  "experiments/table-2.json"])
def test_any_file_of_another_run_is_refused(run, refusal, name):
    path = sealed(run) / name
    path.write_text(path.read_text() + " ")
    error = refusal(run.directory)
    assert f"{name}: SHA-256 is " in error and "it is of another run, or was changed" in error


def test_files_that_a_run_lacks_or_has_too_many_of_are_refused(run, refusal):
    directory = sealed(run)
    (directory / "limits.json").write_text(json.dumps(make_limits()))
    assert "limits.json: not listed in files.json; it is of another run" in refusal(directory)
    (directory / "limits.json").unlink()
    (directory / "experiments/table-2.json").unlink()
    assert "table-2.json: no such file, but files.json lists it" in refusal(directory)


def test_runs_whose_seal_is_gone_broken_or_of_another_run_are_refused(run, refusal):
    path = sealed(run) / "files.json"
    whole = path.read_text()
    path.write_text(whole[:-40])
    assert "files.json: not complete JSON" in refusal(run.directory)
    path.write_text(whole.replace('"schema": 1', '"schema": 2'))
    assert "files.json: schema is 2; it must be 1" in refusal(run.directory)
    path.write_text(whole.replace('"abc1234"', '"abc1235"'))
    assert "files.json: is of commit 'abc1235', but machine.json of 'abc1234'" in refusal(
        run.directory)
    path.write_text(whole.replace("intel-6-143-8-1a2b3c4d", "amd-25-1"))
    assert "files.json: is of machine 'amd-25-1', but machine.json of" in refusal(run.directory)
    path.unlink()
    assert "files.json: no such file; a finished run leaves it here" in refusal(run.directory)


@pytest.mark.parametrize("name", ["limits.json", "experiments/table-2.json"])
def test_truncated_json_of_any_part_is_refused(run, refusal, name):
    directory = run.write()
    (directory / "experiments").mkdir()
    text = json.dumps(make_limits() if name == "limits.json" else TABLE_TWO)
    (directory / name).write_text(text[:-30])
    error = refusal(directory)
    assert name in error and "not complete JSON" in error


@pytest.mark.parametrize("schema", [0, 2, "1", None])
def test_unknown_schema_of_any_part_is_refused(run, refusal, schema):
    directory = run.write()
    (directory / "experiments").mkdir()
    (directory / "experiments/table-2.json").write_text(json.dumps(TABLE_TWO | {"schema": schema}))
    assert "table-2.json: schema is" in refusal(directory)
