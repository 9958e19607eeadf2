"""What ./check --record notes."""

from __future__ import annotations

import json
import sys

import pytest

from report import checks
from report.errors import ReportError


@pytest.mark.parametrize(("said", "noted"), [
    (["100% tests passed, 0 tests failed out of 2210", "Total Test time (real) = 5 s"], "2,210 tests"),
    (["13 targets, 5,000 executions, found by 0"], "13 targets, 5,000 executions, found by 0"),
    (["killed: 298 of 300, 99.3 %; required: 98 %"], "killed: 298 of 300, 99.3 %; required: 98 %"),
    (["98.60 % of lines, 95.20 % of branches"], "98.60 % of lines, 95.20 % of branches"),
    (["====== 12 passed, 1 skipped in 3.1s ======"], "12 passed, 1 skipped"),
    (["== something else"], "passed")])
def test_the_last_words_of_a_check_are_its_result(said, noted):
    assert checks.summary(said) == noted


def recorded(tmp_path, status):
    command = [sys.executable, "-c", f"print('100% tests passed, 0 tests failed out of 7'); raise SystemExit({status})"]
    return checks.record("asan", command, tmp_path / "checks.json")


def test_a_check_that_passed_is_noted_with_its_commit_and_shown(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(checks, "git", lambda *words: "" if words[0] == "status" else "0123456789")
    assert recorded(tmp_path, 0) == 0
    assert "0 tests failed" in capsys.readouterr().out
    entry = json.loads((tmp_path / "checks.json").read_text())["asan"]
    assert entry["commit"] == "0123456789" and entry["result"] == "7 tests"
    assert "| 0123456789 |" in checks.checks_table(tmp_path / "checks.json")


def test_a_check_that_failed_is_not_noted(tmp_path, monkeypatch):
    monkeypatch.setattr(checks, "git", lambda *words: "")
    assert recorded(tmp_path, 3) == 3
    assert not (tmp_path / "checks.json").exists()


def test_changed_files_have_no_commit_to_note(tmp_path, monkeypatch):
    monkeypatch.setattr(checks, "git", lambda *words: " M check")
    with pytest.raises(ReportError, match="commit them first"):
        recorded(tmp_path, 0)
