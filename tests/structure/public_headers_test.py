"""Public headers compile alone and reach nothing but themselves and the standard library."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
INCLUDE_FOLDER = ROOT / "kernels" / "include"
COMPILER = os.environ.get("CXX", "g++")
FLAGS = ["-std=c++20", "-x", "c++", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
STANDARD_HEADER = re.compile(r"^[a-z_0-9]+$")  # those of the standard library have no extension


def headers(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.h*"))


def compiler_says(folder: Path, header: str, *options: str) -> subprocess.CompletedProcess[str]:
    command = [COMPILER, *FLAGS, f"-I{folder}", *options, "-"]
    program = f'#include "{header}"\n'
    return subprocess.run(command, input=program, capture_output=True, text=True, check=False)


def reached_outside(folder: Path, header: str) -> list[str]:
    """Headers that are no system headers and lie outside thinbench/, by the compiler's own list."""
    run = compiler_says(folder, header, "-MM")
    assert run.returncode == 0, run.stderr
    paths = run.stdout.replace("\\\n", " ").split()[1:]
    inside = (folder / "thinbench").resolve()
    return [path for path in paths if path != "-" and inside not in Path(path).resolve().parents]


def odd_includes(folder: Path, header: str) -> list[str]:
    """Lines that include something other than a public header or a standard one."""
    odd = []
    for number, line in enumerate((folder / header).read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r"\s*#\s*include\s*(\S+)", line)
        if not match:
            continue
        name = match.group(1)
        is_standard = name[0] == "<" and STANDARD_HEADER.match(name[1:-1])
        if not (is_standard or name.startswith('"thinbench/')):
            odd.append(f"{header}:{number} includes {name}")
    return odd


@pytest.mark.parametrize("header", headers(INCLUDE_FOLDER))
def test_header_compiles_alone(header):
    run = compiler_says(INCLUDE_FOLDER, header, "-fsyntax-only")
    assert run.returncode == 0, f"{header} does not compile alone:\n{run.stderr}"


@pytest.mark.parametrize("header", headers(INCLUDE_FOLDER))
def test_header_reaches_public_and_standard_headers_only(header):
    assert odd_includes(INCLUDE_FOLDER, header) == []
    assert reached_outside(INCLUDE_FOLDER, header) == []


def test_there_are_public_headers_and_all_lie_in_one_folder():
    found = headers(INCLUDE_FOLDER)
    assert "thinbench/thinning.hpp" in found
    assert all(header.startswith("thinbench/") for header in found)


def test_an_internal_header_that_is_reached_is_named(tmp_path):
    (tmp_path / "thinbench").mkdir()
    (tmp_path / "image").mkdir()
    (tmp_path / "image" / "planes.hpp").write_text("#pragma once\n")
    (tmp_path / "thinbench" / "bad.hpp").write_text(
        '#pragma once\n#include <vector>\n#include "image/planes.hpp"\n#include <tbb/version.h>\n'
    )
    assert odd_includes(tmp_path, "thinbench/bad.hpp") == [
        'thinbench/bad.hpp:3 includes "image/planes.hpp"',
        "thinbench/bad.hpp:4 includes <tbb/version.h>",
    ]
    assert [Path(path).name for path in reached_outside(tmp_path, "thinbench/bad.hpp")] == [
        "planes.hpp"
    ]


def test_a_header_that_needs_another_first_does_not_compile_alone(tmp_path):
    (tmp_path / "thinbench").mkdir()
    (tmp_path / "thinbench" / "bad.hpp").write_text("#pragma once\nstd::size_t size();\n")
    run = compiler_says(tmp_path, "thinbench/bad.hpp", "-fsyntax-only")
    assert run.returncode != 0
