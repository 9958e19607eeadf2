"""mypy finds nothing in the package."""

from __future__ import annotations

import shutil
import subprocess

import pytest
from conftest import ROOT


@pytest.mark.skipif(shutil.which("mypy") is None, reason="mypy is not installed")
def test_package_is_typed() -> None:
    done = subprocess.run(["mypy", "--strict", "--ignore-missing-imports", "--no-error-summary", "--cache-dir", "/dev/null",
                           "report"], cwd=ROOT, text=True, capture_output=True, check=False)
    assert done.stdout + done.stderr == ""
