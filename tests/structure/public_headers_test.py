"""Public headers compile alone and include only each other and the standard library."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
INCLUDE_DIRECTORY = ROOT / "kernels" / "include"
COMPILER = os.environ.get("CXX", "g++")
FLAGS = ["-std=c++20", "-x", "c++", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only"]
STANDARD_HEADER = re.compile(r"^([a-z_0-9]+|stddef\.h|stdint\.h)$")
OPENCV_HEADER = "thinbench/opencv.hpp"  # the one header that needs another library


def headers() -> list[str]:
    names = {path.relative_to(INCLUDE_DIRECTORY).as_posix() for path in INCLUDE_DIRECTORY.rglob("*.h*")}
    return sorted(names - {OPENCV_HEADER})


def invalid_includes(header: str) -> list[str]:
    """Lines that include anything but public and standard headers."""
    invalid = []
    for number, line in enumerate((INCLUDE_DIRECTORY / header).read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r"\s*#\s*include\s*(\S+)", line)
        if not match:
            continue
        name = match.group(1)
        is_standard = name[0] == "<" and STANDARD_HEADER.match(name[1:-1])
        if not (is_standard or name.startswith('"thinbench/')):
            invalid.append(f"{header}:{number} includes {name}")
    return invalid


@pytest.mark.parametrize("header", headers())
def test_header_compiles_alone(header):
    run = subprocess.run([COMPILER, *FLAGS, f"-I{INCLUDE_DIRECTORY}", "-"], input=f'#include "{header}"\n',
                         capture_output=True, text=True, check=False)
    assert run.returncode == 0, f"{header} does not compile alone:\n{run.stderr}"


@pytest.mark.parametrize("header", headers())
def test_header_includes_only_public_and_standard_headers(header):
    assert invalid_includes(header) == []


def test_all_public_headers_are_in_one_directory():
    found = headers()
    assert "thinbench/thinning.hpp" in found
    assert all(header.startswith("thinbench/") for header in set(found) - {"thinbench.h"})


def test_only_the_header_for_opencv_includes_opencv():
    own = invalid_includes(OPENCV_HEADER)
    assert [line.split()[-1] for line in own] == ["<opencv2/core.hpp>"]
