"""The build under test: THINBENCH_BUILD in the environment; packages from it or, by tools/release, in THINBENCH_DIST."""

from __future__ import annotations

import atexit
import functools
import json
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def build() -> Path:
    return Path(os.environ["THINBENCH_BUILD"])


def released(pattern: str) -> list[Path]:
    """What tools/release made; nothing unless it calls the tests."""
    directory = os.environ.get("THINBENCH_DIST")
    return sorted(Path(directory).glob(pattern)) if directory else []


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


@functools.cache
def reuse(build: Path) -> dict[str, str]:
    """Environment in which CMake takes the kernels' objects from this build."""
    lines = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = re.search(r" -c \S*?kernels/(\S+)", entry["command"])
        output = re.search(r" -o (\S+)", entry["command"])
        if source and output and not output.group(1).endswith(".gch"):
            isa = re.search(r"-DTHINBENCH_ISA=(\w+)", entry["command"])
            lines.append("\t".join([source.group(1), isa.group(1) if isa else "",
                                    str(Path(entry["directory"]) / output.group(1))]))
    file = build / f"objects.{os.getpid()}.tsv"
    atexit.register(file.unlink)
    file.write_text("\n".join(lines) + "\n")
    launcher = Path(__file__).with_name("reuse_objects.sh")
    return {"CMAKE_CXX_COMPILER_LAUNCHER": str(launcher), "THINBENCH_OBJECTS": str(file)}
