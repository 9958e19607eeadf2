"""clang-format decides the layout of C and C++."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SOURCES = sorted(path for directory in ("kernels", "reference", "bench", "tools", "tests")
                 for ending in ("*.c", "*.h", "*.cpp", "*.hpp") for path in (ROOT / directory).rglob(ending))


@pytest.mark.skipif(shutil.which("clang-format") is None, reason="clang-format is not installed")
def test_clang_format_changes_nothing() -> None:
    assert len(SOURCES) > 500
    done = subprocess.run(["xargs", "-0", "-n", "50", "-P", "2", "clang-format", "--dry-run", "--Werror"], check=False,
                          input="\0".join(map(str, SOURCES)), text=True, stderr=subprocess.PIPE)
    assert done.returncode == 0, done.stderr[:2000]
