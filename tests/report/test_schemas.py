"""JSON documents of the programs, checked by their schemas."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import jsonschema
import pytest
from fake_programs import MACHINE

from report.errors import ReportError
from report.schemas import DIRECTORY, check_schema
from tests.programs import PROGRAMS, ROOT


@pytest.mark.parametrize("path", sorted(DIRECTORY.glob("*.json")), ids=lambda path: path.stem)
def test_schemas_are_schemas(path: Path) -> None:
    jsonschema.Draft202012Validator.check_schema(json.loads(path.read_text()))


def test_the_field_that_is_wrong_is_named() -> None:
    machine = {name: value for name, value in MACHINE.items() if name != "commit"}
    check_schema("machine", machine, "machine.json")
    with pytest.raises(ReportError, match=r"^machine.json: compiler: 'id' is a required property"):
        check_schema("machine", machine | {"compiler": {
            "version": "12", "flags": "", "build_type": ""}}, "machine.json")


@pytest.mark.skipif(not (PROGRAMS / "thinbench-study").exists(), reason=f"no programs in {PROGRAMS}")
@pytest.mark.parametrize("schema, command", [
    ("variants", "thinbench-study list --json"),
    ("counts", "thinbench-study instructions --filter ^euler_number/bitpacked/baseline/1/ --out out"),
    ("weights", "thinbench-study train cluster --out out"),
    ("weights", "thinbench-study train two-layer --seed 2 --out out"),
    ("scene", "thinbench-study scene out.png --truth"),
    ("regions", f"thinbench holes {ROOT}/results/pictures/scene.jpg --json")])
def test_what_programs_write_fits_its_schema(schema: str, command: str, tmp_path: Path) -> None:
    program, *words = command.split()
    done = subprocess.run([PROGRAMS / program, *words], check=True, stdout=subprocess.PIPE, text=True, cwd=tmp_path)
    written = tmp_path / "out"
    check_schema(schema, json.loads(written.read_text() if written.exists() else done.stdout), schema)
