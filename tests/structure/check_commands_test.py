"""Every command of ./check has a preset that can be configured, and CI runs what the documents promise."""

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
