"""What ./check --record notes."""

from __future__ import annotations

import pytest

from report import checks
from report.errors import ReportError


@pytest.mark.parametrize(("said", "noted"), [
    (["100% tests passed, 0 tests failed out of 2210", "Total Test time (real) = 5 s"], "2,210 tests"),
    (["13 targets, 5,000 executions, 0 failed"], "13 targets, 5,000 executions, 0 failed"),
    (["1 target, 5 executions, 0 failed"], "1 target, 5 executions, 0 failed"),
    (["killed: 298 of 300, 99.3 %; required: 98 %"], "killed: 298 of 300, 99.3 %; required: 98 %"),
    (["98.60 % of lines, 95.20 % of branches"], "98.60 % of lines, 95.20 % of branches"),
    (["====== 12 passed, 1 skipped in 3.1s ======"], "12 passed, 1 skipped"),
    (["== something else"], "passed")])
def test_the_last_words_of_a_check_are_its_result(said, noted):
    assert checks.summary(said) == noted


DOCUMENT = """Before.

<!-- checks: made by check --record -->
| command | commit | minutes | result |
| --- | --- | ---: | --- |
| `./check asan` | 9876543210 | 44.1 | 6 \\| tests |
| `./check tsan` | 9876543210 | 26.8 | 5 \\| tests |
<!-- end -->

After.
"""


def recorded(tmp_path, status):
    """The status and the document, after a check of two words more."""
    check, document = tmp_path / "check", tmp_path / "testing.md"
    check.write_text(f"#!/bin/sh\necho 100% tests passed, 0 tests failed out of 7\nexit {status}\n")
    check.chmod(0o755)
    document.write_text(DOCUMENT)
    status = checks.record([str(check), "--no-install", "asan", "-n", "3"], document)
    return status, document.read_text().splitlines()


def test_a_check_that_passed_is_noted_with_its_commit_in_place_of_its_last_row(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(checks, "git", lambda *words: "" if words[0] == "status" else "0123456789")
    status, lines = recorded(tmp_path, 0)
    assert status == 0
    assert "0 tests failed" in capsys.readouterr().out
    before = DOCUMENT.splitlines()
    row = lines.pop(5)
    assert row == "| `./check asan -n 3` | 0123456789 | 0.0 | 7 tests |"
    assert lines == before[:5] + before[6:]


def test_a_check_that_failed_is_not_noted(tmp_path, monkeypatch):
    monkeypatch.setattr(checks, "git", lambda *words: "")
    assert recorded(tmp_path, 3) == (3, DOCUMENT.splitlines())


def test_a_document_without_the_table_is_rejected():
    with pytest.raises(ReportError, match="no table of checks"):
        checks.with_row("a page", ["`./check asan`"])


def test_changed_files_have_no_commit_to_note(tmp_path, monkeypatch):
    monkeypatch.setattr(checks, "git", lambda *words: " M check")
    with pytest.raises(ReportError, match="commit them first"):
        recorded(tmp_path, 0)
