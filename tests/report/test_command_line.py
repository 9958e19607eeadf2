"""The program as a user meets it."""

from __future__ import annotations

from conftest import command


def test_help_shows_an_example():
    done = command("build", "--help")
    assert done.returncode == 0 and "python3 -m report build results/" in done.stdout


def test_refusal_is_one_line_on_standard_error(tmp_path):
    done = command("build", tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("report: ") and done.stderr.count("\n") == 1


def test_wrong_usage_is_told_apart_from_refused_data():
    assert command().returncode == 2
