"""clang-format decides the layout of C and C++; mypy finds nothing in the packages, and the annotations of thinbench
serve a typed caller."""

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


EXAMPLE = ROOT / "python" / "examples" / "path_planning.py"

CALLER = """
import numpy as np
import numpy.typing as npt
import thinbench

image: npt.NDArray[np.uint8] = np.ones((4, 4), np.uint8)
skeleton = thinbench.thin(image)
pair: tuple[npt.NDArray[np.uint8], int] = thinbench.thin(image, return_iterations=True)
flag: bool = len(image) > 3
either = thinbench.thin(image, return_iterations=flag)
table = thinbench.find_regions(image)
labels, columns = thinbench.label_regions(image)
rule = thinbench.Rule.from_hensel("B3/S23", max_iterations=1)
cells: tuple[npt.NDArray[np.uint8], int] = thinbench.apply(image, rule, return_iterations=True)
thinbench.thin(image, threads="2")  # expected error
"""


def mypy(*arguments: object) -> str:
    if shutil.which("mypy") is None:
        pytest.skip("mypy is not installed")
    run = subprocess.run(["mypy", "--strict", "--no-error-summary", "--cache-dir", "/dev/null", *map(str, arguments)],
                         cwd=ROOT, text=True, capture_output=True, check=False)
    return run.stdout + run.stderr


@pytest.mark.parametrize("words", [["python/thinbench"], ["--ignore-missing-imports", "report"]])
def test_packages_are_typed(words):
    assert mypy(*words) == ""


def test_annotations_serve_a_typed_caller_and_the_example(tmp_path):
    (tmp_path / "caller.py").write_text(CALLER)
    found = mypy("--ignore-missing-imports", "--no-warn-unused-ignores", "python/thinbench", EXAMPLE,
                 tmp_path / "caller.py")
    errors = [line for line in found.splitlines() if "error:" in line]
    assert len(errors) == 1 and "caller.py:15" in errors[0] and '"thin"' in errors[0]
