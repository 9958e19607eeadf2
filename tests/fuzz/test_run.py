"""./check fuzz: what it says about targets, here of shell scripts in their place; packed seeds."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.fuzz import run, seeds

QUIET = """#!/bin/sh
echo '#2\tINITED cov: 3 ft: 4'
echo '#500\tDONE   cov: 7 ft: 9 corp: 2/3b'
"""
FINDS = QUIET + """
for word; do case "$word" in -artifact_prefix=*) echo bad >"${word#*=}crash-1" ;; esac; done
exit 77
"""


@pytest.fixture(name="targets")
def _targets(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two targets: one finds something."""
    for name, script in (("quiet", QUIET), ("finds", FINDS)):
        (tmp_path / f"{name}.seeds").touch()
        program = tmp_path / "bin" / f"fuzz_{name}"
        program.parent.mkdir(exist_ok=True)
        program.write_text(script)
        program.chmod(0o755)
    monkeypatch.setattr(run, "BUILD", tmp_path)
    monkeypatch.setattr(run, "WORK", tmp_path)
    monkeypatch.setattr(run, "SOURCES", tmp_path)
    monkeypatch.setattr(run, "build", lambda preset, names: None)
    return tmp_path


def test_nothing_found_is_status_0_with_executions_and_coverage(
        targets: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert targets.exists() and run.main(["--seconds", "1", "quiet"]) == 0
    heading, line, total = capsys.readouterr().out.splitlines()
    assert heading.split() == ["target", "executions", "per", "second", "edges", "found"]
    assert line.split()[:2] == ["quiet", "500"] and line.split()[3:] == ["7", "nothing"]
    assert total == "1 target, 500 executions, 0 failed"


def test_a_finding_is_status_1_and_the_path_of_the_input_which_is_tried_again_first(
        targets: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run.main(["--seconds", "1"]) == 1
    assert f"  {targets}/found/finds/crash-1\n" in capsys.readouterr().out
    (targets / "bin" / "fuzz_finds").write_text(QUIET)
    assert run.main(["--seconds", "1", "finds"]) == 0
    assert (targets / "corpus" / "finds" / "crash-1").read_text() == "bad\n"


# Packed seeds.

def test_added_files_are_sorted_lines_and_are_unpacked(tmp_path: Path) -> None:
    packed, directory = str(tmp_path / "a.seeds"), tmp_path / "unpacked"
    contents = {"one": b"text\n", "bytes": bytes(range(256)), "empty": b""}
    for name, content in contents.items():
        (tmp_path / name).write_bytes(content)
        seeds.main(["add", packed, str(tmp_path / name)])
    seeds.main(["unpack", packed, str(directory)])
    assert {path.name: path.read_bytes() for path in directory.iterdir()} == contents
    assert [line.split(" ")[0] for line in Path(packed).read_text().splitlines()] == sorted(contents)


def test_a_file_with_the_name_of_a_seed_replaces_it(tmp_path: Path) -> None:
    packed, seed = tmp_path / "a.seeds", tmp_path / "seed"
    for content in (b"old", b"new"):
        seed.write_bytes(content)
        seeds.add(packed, [seed])
    assert seeds.read(packed) == {"seed": b"new"}


def test_wrong_arguments_are_the_usage() -> None:
    with pytest.raises(SystemExit, match="unpack TARGET.seeds DIRECTORY"):
        seeds.main(["add", "a.seeds"])
