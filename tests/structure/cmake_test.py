"""Every command of ./check has a preset that can be configured, and CI runs what the documents promise. CMake knows
Darwin and rejects what it does not know."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PRESETS = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
# Commands that build by the preset of another, or by none: mutants copies the sources.
OTHER_PRESETS = {"fuzz": "asan", "soak": "release", "cpus": "release", "tidy": "clang", "mutants": None}
NEEDED = {"aarch64": "/usr/lib/aarch64-linux-gnu/libtbb.so", "clang-19": "/usr/bin/clang++-19",
          "s390x": "/usr/lib/s390x-linux-gnu/libtbb.so", "libcxx": "/usr/lib/llvm-19/include/c++/v1/vector",
          "web": "/usr/bin/em++", "windows": "/usr/bin/x86_64-w64-mingw32-g++-posix"}
NEEDED |= dict.fromkeys(("asan", "clang", "coverage"), "/usr/bin/clang++")


def commands() -> list[str]:
    """Those that ./check --help lists."""
    text = subprocess.run([ROOT / "check", "--help"], capture_output=True, text=True,
                          check=True).stdout
    return re.findall(r"^  ([a-z][\w-]*)  +\S", text, re.MULTILINE)


def configured_presets() -> list[str]:
    presets = {OTHER_PRESETS.get(command, command) for command in commands()}
    return sorted(preset for preset in presets if preset)


def test_all_commands_are_listed() -> None:
    assert {"release", "fuzz", "mutants", "odr"} <= set(commands())
    assert set(OTHER_PRESETS) <= set(commands())


@pytest.mark.parametrize("preset", configured_presets())
def test_preset_of_a_command_can_be_built_and_tested(preset: str) -> None:
    assert preset in [one["configurePreset"] for one in PRESETS["buildPresets"]]
    tests = [one.get("configurePreset") for one in PRESETS["testPresets"]]
    assert preset in tests or preset == "odr"  # which only links


@pytest.mark.parametrize("preset", configured_presets())
def test_preset_of_a_command_is_configured_in_a_path_with_spaces(preset: str,
                                                                 tmp_path: Path) -> None:
    if preset in NEEDED and not Path(NEEDED[preset]).exists():
        pytest.skip(f"{NEEDED[preset]}, which ./check {preset} installs, is missing")
    sources = tmp_path / "a path"
    sources.symlink_to(ROOT)
    run = subprocess.run(["cmake", "--preset", preset, "-B", tmp_path / "build it"], cwd=sources,
                         env=os.environ | {"PWD": str(sources)}, capture_output=True, text=True,
                         check=False)
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "build it" / "build.ninja").exists()


def test_ci_checks_what_the_documents_promise() -> None:
    lines = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    ran = set(re.findall(r'^(?:exec |\w+=\w+ )?"\$root/check" ?([\w-]*)', lines, re.MULTILINE))
    assert ran >= {"--all", "cpus", "clang", "fuzz"}


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
