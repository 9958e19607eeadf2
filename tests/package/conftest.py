"""The build under test: THINBENCH_BUILD in the environment."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def build() -> Path:
    return Path(os.environ["THINBENCH_BUILD"])


def run(*command: object, cwd: Path | None = None, **variables: str) -> str:
    """Standard output of a command that must succeed."""
    done = subprocess.run([str(part) for part in command], cwd=cwd, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=os.environ | variables)
    assert done.returncode == 0, done.stdout[-4000:]
    return done.stdout


def code_block(page: str, language: str, containing: str) -> str:
    """A code block of a page."""
    text = (ROOT / page).read_text(encoding="utf-8")
    blocks = re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)
    found = [block for block in blocks if containing in block]
    assert len(found) == 1, f"{page} has {len(found)} {language} blocks with {containing}"
    return found[0]


def readme_block(language: str, containing: str) -> str:
    """A code block of README."""
    return code_block("README.md", language, containing)


def reuse(build: Path) -> dict[str, str]:
    """Environment in which CMake takes the kernels' objects from this build."""
    launcher = Path(__file__).with_name("reuse_objects.py")
    return {"CMAKE_CXX_COMPILER_LAUNCHER": str(launcher), "THINBENCH_REUSED_BUILD": str(build)}
