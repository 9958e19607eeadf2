"""With THINBENCH_STRICT in the environment a test that is skipped because something is not installed fails: on the
machine that decides, nothing may go untested unseen."""

from __future__ import annotations

import os
import re
import signal
import sys
from collections.abc import Generator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))  # for the packages `report` and `tests`

MISSING = re.compile(r"could not import|not installed|is not there|no programs in|mounting needs|only for root")

for _number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):  # programs inherit what nohup ignores
    if signal.getsignal(_number) is signal.SIG_IGN:
        signal.signal(_number, signal.SIG_DFL)


def _judge(report: pytest.TestReport | pytest.CollectReport) -> None:
    if report.outcome == "skipped" and "THINBENCH_STRICT" in os.environ and MISSING.search(str(report.longrepr)):
        report.outcome = "failed"


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.Stash, None]:
    """Tests that are skipped."""
    _judge((yield).get_result())  # type: ignore[attr-defined]


@pytest.hookimpl(hookwrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.Stash, None]:
    """Modules that are skipped as a whole."""
    _judge((yield).get_result())  # type: ignore[attr-defined]
