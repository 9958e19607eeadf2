"""JSON documents of the programs, checked by their schemas. Programs are those of the environment's
THINBENCH_PROGRAMS, or of the release build."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import jsonschema
import pytest
from fake_programs import MACHINE

from report.errors import ReportError
from report.schemas import DIRECTORY, check_schema

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(os.environ.get("THINBENCH_PROGRAMS", ROOT / "build" / "release" / "bin"))
ROW = "^euler_number/bitpacked/baseline/1/"

needs_programs = pytest.mark.skipif(not (PROGRAMS / "thinbench-study").exists(),
                                    reason=f"no programs in {PROGRAMS}")


def printed(*words: str | Path, program: str = "thinbench-study") -> str:
    """By a program."""
    return subprocess.run([PROGRAMS / program, *words], check=True, stdout=subprocess.PIPE,
                          text=True).stdout


@pytest.mark.parametrize("path", sorted(DIRECTORY.glob("*.json")), ids=lambda path: path.stem)
def test_schemas_are_schemas(path: Path) -> None:
    jsonschema.Draft202012Validator.check_schema(json.loads(path.read_text()))


def test_the_field_that_is_wrong_is_named() -> None:
    machine = {name: value for name, value in MACHINE.items() if name != "commit"}
    check_schema("machine", machine, "machine.json")
    with pytest.raises(ReportError, match=r"^machine.json: compiler: 'id' is a required property"):
        check_schema("machine", machine | {"compiler": {
            "version": "12", "flags": "", "build_type": ""}}, "machine.json")


@needs_programs
@pytest.mark.parametrize("schema, program, words", [
    ("machine", "thinbench_benchmarks", ["--machine"]), ("variants", "thinbench-study", ["list", "--json"])])
def test_what_is_printed_fits_its_schema(schema: str, program: str, words: list[str]) -> None:
    check_schema(schema, json.loads(printed(*words, program=program)), schema)


@needs_programs
@pytest.mark.parametrize("schema, words", [
    ("counts", ["instructions", "--filter", ROW]),
    ("weights", ["train", "cluster"]), ("weights", ["train", "two-layer", "--seed", "2"])])
def test_what_is_written_fits_its_schema(schema: str, words: list[str], tmp_path: Path) -> None:
    path = tmp_path / "written.json"
    printed(*words, "--out", path)
    check_schema(schema, json.loads(path.read_text()), schema)


@needs_programs
def test_what_is_told_of_an_image_fits_its_schema(tmp_path: Path) -> None:
    path = tmp_path / "scene.png"
    check_schema("scene", json.loads(printed("scene", path, "--truth")), "scene")
    check_schema("regions", json.loads(printed("holes", path, "--json", program="thinbench")), "holes")
