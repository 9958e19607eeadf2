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
FLAGS = ["-std=c++20", "-x", "c++", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
STANDARD_HEADER = re.compile(r"^([a-z_0-9]+|stddef\.h|stdint\.h)$")
OPENCV_HEADER = "thinbench/opencv.hpp"  # the one header that needs another library


def headers(directory: Path) -> list[str]:
    names = {path.relative_to(directory).as_posix() for path in directory.rglob("*.h*")}
    return sorted(names - {OPENCV_HEADER})


def run_compiler(directory: Path, header: str, *options: str) -> subprocess.CompletedProcess[str]:
    command = [COMPILER, *FLAGS, f"-I{directory}", *options, "-"]
    program = f'#include "{header}"\n'
    return subprocess.run(command, input=program, capture_output=True, text=True, check=False)


def included_outside(directory: Path, header: str) -> list[str]:
    """Non-system headers outside thinbench/ that the header includes, directly or not."""
    run = run_compiler(directory, header, "-MM")
    assert run.returncode == 0, run.stderr
    paths = run.stdout.replace("\\\n", " ").split()[1:]
    inside = (directory / "thinbench").resolve()
    public = [inside, (directory / "thinbench.h").resolve()]
    return [path for path in paths
            if path != "-" and not {Path(path).resolve(), *Path(path).resolve().parents} & {*public}]


def invalid_includes(directory: Path, header: str) -> list[str]:
    """Lines that include anything but public and standard headers."""
    invalid = []
    for number, line in enumerate((directory / header).read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r"\s*#\s*include\s*(\S+)", line)
        if not match:
            continue
        name = match.group(1)
        is_standard = name[0] == "<" and STANDARD_HEADER.match(name[1:-1])
        if not (is_standard or name.startswith('"thinbench/')):
            invalid.append(f"{header}:{number} includes {name}")
    return invalid


@pytest.mark.parametrize("header", headers(INCLUDE_DIRECTORY))
def test_header_compiles_alone(header):
    run = run_compiler(INCLUDE_DIRECTORY, header, "-fsyntax-only")
    assert run.returncode == 0, f"{header} does not compile alone:\n{run.stderr}"


@pytest.mark.parametrize("header", headers(INCLUDE_DIRECTORY))
def test_header_includes_only_public_and_standard_headers(header):
    assert invalid_includes(INCLUDE_DIRECTORY, header) == []
    assert included_outside(INCLUDE_DIRECTORY, header) == []


def test_all_public_headers_are_in_one_directory():
    found = headers(INCLUDE_DIRECTORY)
    assert "thinbench/thinning.hpp" in found
    assert all(header.startswith("thinbench/") for header in set(found) - {"thinbench.h"})


def test_only_the_header_for_opencv_includes_opencv():
    own = invalid_includes(INCLUDE_DIRECTORY, OPENCV_HEADER)
    assert [line.split()[-1] for line in own] == ["<opencv2/core.hpp>"]


def test_included_internal_header_is_reported(tmp_path):
    (tmp_path / "thinbench").mkdir()
    (tmp_path / "core").mkdir()
    (tmp_path / "core" / "planes.hpp").write_text("#pragma once\n")
    (tmp_path / "thinbench" / "bad.hpp").write_text(
        '#pragma once\n#include <vector>\n#include "core/planes.hpp"\n#include <tbb/version.h>\n'
    )
    assert invalid_includes(tmp_path, "thinbench/bad.hpp") == [
        'thinbench/bad.hpp:3 includes "core/planes.hpp"',
        "thinbench/bad.hpp:4 includes <tbb/version.h>",
    ]
    assert [Path(path).name for path in included_outside(tmp_path, "thinbench/bad.hpp")] == [
        "planes.hpp"
    ]


def test_header_that_depends_on_another_is_detected(tmp_path):
    (tmp_path / "thinbench").mkdir()
    (tmp_path / "thinbench" / "bad.hpp").write_text("#pragma once\nstd::size_t size();\n")
    run = run_compiler(tmp_path, "thinbench/bad.hpp", "-fsyntax-only")
    assert run.returncode != 0
