"""What sources may use: dates of the system's clock, intrinsics and names of systems, each where it is allowed. And
every test of C++ is compiled: one that no CMakeLists.txt names would look like one that passes."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
KERNELS = ROOT / "kernels"


def sources(directory: Path, *endings: str) -> list[Path]:
    return sorted(file for file in directory.rglob("*") if file.suffix in {".hpp", ".cpp", ".h", *endings})


@pytest.mark.skipif("THINBENCH_BUILD" not in os.environ, reason="a build with sanitizers or counters")
def test_every_test_of_cpp_is_compiled() -> None:
    commands = json.loads(Path(os.environ["THINBENCH_BUILD"], "compile_commands.json").read_text(encoding="utf-8"))
    compiled = {Path(command["file"]).resolve() for command in commands}
    assert [path for path in (ROOT / "tests").rglob("*_test.cpp") if path not in compiled] == []


# Nothing that lasts or is compared is measured by the system's clock, which may jump.
SYSTEM_CLOCK = re.compile(r"\b(?:system_clock|CLOCK_REALTIME|gettimeofday|datetime\.now|last_write_time|"
                          r"st_mtime?|std::time)\b|\btime\.time\(")
# When a run took place; whether a file was changed, for which times need only differ.
DATES = {"report/measure/command.py", "report/measure/machine.py", "tools/support/file_bytes.cpp"}


def test_only_dates_come_from_the_system_clock() -> None:
    files = [file for directory in ("kernels", "tools", "bench", "report", "python")
             for file in sources(ROOT / directory, ".py")]
    assert {file.relative_to(ROOT).as_posix() for file in files
            if SYSTEM_CLOCK.search(file.read_text(encoding="utf-8"))} == DATES


# Only kernels/simd/ and what nets add to it use intrinsics or test for an architecture; what detects features does the
# latter.
SIMD = KERNELS / "simd"
OTHERS = {KERNELS / "core" / "features.cpp", KERNELS / "techniques" / "masked_lanes.hpp"}

ARCHITECTURE = re.compile(
    r"""\b_mm\d*_\w+ | \b__m(?:64|128|256|512)\w*\b | \b__mmask\d+ | \b__builtin_ia32_\w+
      | \b_(?:pext|pdep|bextr|blsi|blsmsk|blsr|tzcnt|lzcnt|popcnt)_?u\d+
      | \bv[a-z]\w*_[usfp](?:8|16|32|64)\b | \b(?:u?int|float|poly)\d+x\d+(?:x\d)?_t\b
      | <(?:\w*mmintrin|x86intrin|arm_\w+)\.h>
      | \b__(?:AVX|SSE|SSSE|BMI|FMA|GFNI|POPCNT|LZCNT|ARM_)\w*
      | \b__(?:x86_64|i386|aarch64|arm)__\b""",
    re.VERBOSE,
)


def findings(file: Path) -> Iterator[str]:
    """'file:line: name' for each use outside of comments."""
    for number, line in enumerate(file.read_text().splitlines(), start=1):
        for match in ARCHITECTURE.finditer(line.split("//", 1)[0]):
            yield f"{file.relative_to(ROOT)}:{number}: {match[0]}"


def test_only_the_vocabulary_depends_on_the_architecture():
    outside = [file for file in sources(KERNELS) if SIMD not in file.parents and file not in OTHERS]
    assert len(outside) > 50
    found = [finding for file in outside for finding in findings(file)]
    assert not found, "outside kernels/simd/:\n" + "\n".join(found)


def test_architecture_files_of_the_vocabulary_are_recognised():
    assert [file.name for file in sources(SIMD) if any(findings(file))] == [
        "avx2.hpp", "avx512.hpp", "neon.hpp", "sse2.hpp", "vector.hpp", "vocabulary.hpp"]


SYSTEM = re.compile(r"_WIN32|_WIN64|__MINGW\w*|__APPLE__|__linux__|__unix__")


def test_kernels_ask_for_a_system_only_where_the_design_says() -> None:
    found = {path.relative_to(ROOT).as_posix() for path in (ROOT / "kernels").rglob("*")
             if path.is_file() and SYSTEM.search(path.read_text(encoding="utf-8"))}
    section = (ROOT / "docs" / "design.md").read_text(encoding="utf-8").partition("## Another system\n")[2]
    named = set(re.findall(r"`(kernels/[\w/.]+)`", section.partition("\n## ")[0]))
    assert found and found <= named
