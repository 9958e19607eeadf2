"""The model of the processor, on a recorded llvm-mca and on the real one."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from report.files import read_json, to_json
from report.model import PROGRAM, add_model, assembly, model_cycles
from report.schemas import check_schema
from test_schemas import ROW, needs_programs, printed

needs_llvm_mca = pytest.mark.skipif(not shutil.which(PROGRAM), reason="llvm-19 is not installed")

ADDITIONS = {"instructions": "4801d8" + 12 * "00", "order": "0-0*1000"}
"""add %rbx,%rax a thousand times; what follows it in memory is another instruction."""

RECORDED = """Iterations:        1
Instructions:      16079
Total Cycles:      3156
Total uOps:        16120

Dispatch Width:    6
"""


def fake_llvm_mca(directory: Path, cpu: str, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keeps what it is given in the file `given`."""
    program = directory / PROGRAM
    program.write_text(f"""#!/bin/sh
[ "$1" != --version ] || {{ echo "  Host CPU: {cpu}"; exit; }}
echo "$@" > "{directory}/given"
cat >> "{directory}/given"
cat <<'TEXT'
{RECORDED}
TEXT
""")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{directory}:/usr/bin:/bin")
    return directory / "given"


def limits(directory: Path, code: dict[str, str]) -> Path:
    """A file as thinbench-study writes it, less what the model does not read."""
    path = directory / "limits.json"
    path.write_bytes(to_json({"rows": [{"row": "a", "code": code}]}))
    return path


def test_a_model_gets_the_code_in_the_order_of_execution(tmp_path, monkeypatch):
    given = fake_llvm_mca(tmp_path, "znver4", monkeypatch)
    code = {"instructions": "4801d8ffffffffffffffffffffffff 31c0ffffffffffffffffffffffffff c3",
            "order": "0-1*2 2-2*1"}
    path = limits(tmp_path, code)
    add_model(path)
    assert read_json(path) == {"model": "llvm-mca 19, znver4",
                               "rows": [{"row": "a", "model_cycles": 3156}]}
    words, *lines = given.read_text().splitlines()
    assert "-mcpu=znver4 -iterations=1" in words
    assert [line.split()[0] for line in lines] == ["add", "xor", "add", "xor", "ret"]


def test_a_processor_without_a_model_of_its_own_has_none(tmp_path, monkeypatch):
    fake_llvm_mca(tmp_path, "znver5", monkeypatch)
    path = limits(tmp_path, ADDITIONS)
    add_model(path)
    assert read_json(path) == {"model": "none: LLVM 19 has no model of this processor (znver5)",
                               "rows": [{"row": "a"}]}


def test_without_llvm_mca_the_file_says_so(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    path = limits(tmp_path, ADDITIONS)
    add_model(path)
    assert read_json(path)["model"] == "none: llvm-mca-19 is not installed (package llvm-19)"


@needs_llvm_mca
def test_dependent_additions_take_a_cycle_each():
    assert 1000 <= (model_cycles(assembly(ADDITIONS), "znver4") or 0) <= 1010


@needs_llvm_mca
def test_calls_and_returns_take_no_hundred_cycles():
    code = {"instructions": "e810000000 c3", "order": "0-1*1000"}
    assert (model_cycles(assembly(code), "znver4") or 10**6) < 20_000


@needs_llvm_mca
def test_code_that_the_model_lacks_has_no_cycles():
    ternary = {"instructions": "62f3ed4825d996", "order": "0-0*1"}
    assert model_cycles(assembly(ternary), "znver4") is not None
    assert model_cycles(assembly(ternary), "znver3") is None


@needs_programs
@needs_llvm_mca
def test_every_instruction_that_was_counted_is_in_the_model(tmp_path):
    path = tmp_path / "limits.json"
    printed("instructions", "--limits", "--quick", "--filter", ROW, "--out", path)
    row = json.loads(path.read_text())["rows"][0]
    text = assembly(row["code"])
    assert abs(len(text.replace("push $0\njmp 0", "call").splitlines()) - row["instructions"]) < 100
    assert "(bad)" not in text
    assert (model_cycles(text, "sapphirerapids") or 0) > row["instructions"] / 6
    add_model(path)
    check_schema("counts", read_json(path), "limits.json")
