"""CMake knows Darwin and rejects what it does not know."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
def configured(directory: Path, system: str, processor: str) -> subprocess.CompletedProcess[str]:
    """For another system, as far as this one's compiler allows: nothing is built."""
    options = {"CMAKE_SYSTEM_NAME": system, "CMAKE_SYSTEM_PROCESSOR": processor, "CMAKE_CXX_COMPILER": "g++",
               "CMAKE_CXX_COMPILER_WORKS": "ON", "CMAKE_TRY_COMPILE_TARGET_TYPE": "STATIC_LIBRARY",
               "CMAKE_FIND_ROOT_PATH_MODE_PACKAGE": "NEVER", "CMAKE_LIBRARY_ARCHITECTURE": "x86_64-linux-gnu",
               "THINBENCH_BUILD_PROGRAMS": "OFF", "THINBENCH_BUILD_TESTS": "OFF", "THINBENCH_WITH_TBB": "OFF"}
    return subprocess.run(["cmake", "-S", ROOT, "-B", directory, "-G", "Ninja",
                           *(f"-D{name}={value}" for name, value in options.items())],
                          capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("processor", "isa"), [("arm64", "neon_sha3"), ("x86_64", "avx512icl")])
def test_cmake_knows_darwin(processor: str, isa: str, tmp_path: Path) -> None:
    done = configured(tmp_path, "Darwin", processor)
    assert done.returncode == 0, done.stderr
    ninja = (tmp_path / "build.ninja").read_text(encoding="utf-8")
    assert f"thinbench_{isa}" in ninja and "version-script" not in ninja
    assert "SONAME = libthinbench.1.dylib" in ninja
    (exports,) = set(re.findall(r"-exported_symbols_list,(\S+)", ninja))
    assert "_thinbench_*" in Path(exports).read_text(encoding="utf-8").splitlines()


def test_another_system_is_rejected_in_one_line(tmp_path: Path) -> None:
    done = configured(tmp_path, "Haiku", "x86_64")
    assert "thinbench needs Linux, macOS, Windows or Emscripten, this is Haiku" in " ".join(done.stderr.split())
