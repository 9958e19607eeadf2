"""./check fuzz: what it says about targets, here of shell scripts in their place, and about its arguments."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.fuzz import run

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


def test_a_finding_is_status_1_and_the_path_of_the_input(
        targets: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run.main(["--seconds", "1"]) == 1
    assert f"  {targets}/found/finds/crash-1\n" in capsys.readouterr().out


def test_what_was_found_is_tried_again_first(targets: Path) -> None:
    assert run.main(["--seconds", "1", "finds"]) == 1
    (targets / "bin" / "fuzz_finds").write_text(QUIET)
    assert run.main(["--seconds", "1", "finds"]) == 0
    assert (targets / "corpus" / "finds" / "crash-1").read_text() == "bad\n"


@pytest.mark.parametrize("words, said", [
    (["--seconds", "0"], "--seconds: expected a number above 0, got '0'"),
    (["--hours", "many"], "--hours: expected a number above 0, got 'many'"),
    (["--jobs", "0"], "--jobs: expected 1 or more, got 0"),
    (["loud"], "no target is named 'loud'; known: finds, quiet")])
def test_wrong_arguments_are_one_line_and_status_2(
        targets: Path, words: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert targets.exists()
    with pytest.raises(SystemExit) as ended:
        run.main(words)
    assert ended.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1].endswith(said)
