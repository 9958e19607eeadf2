"""Only kernels/simd/ and what nets add to it use intrinsics or test for an architecture; what detects features does the
latter."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

KERNELS = Path(__file__).resolve().parents[2] / "kernels"
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
            yield f"{file.relative_to(KERNELS.parent)}:{number}: {match[0]}"


def sources(directory: Path) -> list[Path]:
    return sorted(file for file in directory.rglob("*") if file.suffix in {".hpp", ".cpp", ".h"})


def test_only_the_vocabulary_depends_on_the_architecture():
    outside = [file for file in sources(KERNELS) if SIMD not in file.parents and file not in OTHERS]
    assert len(outside) > 50
    found = [finding for file in outside for finding in findings(file)]
    assert not found, "outside kernels/simd/:\n" + "\n".join(found)


def test_architecture_files_of_the_vocabulary_are_recognised():
    assert [file.name for file in sources(SIMD) if any(findings(file))] == [
        "avx2.hpp", "avx512.hpp", "neon.hpp", "sse2.hpp", "vector.hpp", "vocabulary.hpp"]
