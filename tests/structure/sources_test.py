"""Every test of C++ is compiled: one that no CMakeLists.txt names would look like one that passes."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]


@pytest.mark.skipif("THINBENCH_BUILD" not in os.environ, reason="a build with sanitizers or counters")
def test_every_test_of_cpp_is_compiled() -> None:
    commands = json.loads(Path(os.environ["THINBENCH_BUILD"], "compile_commands.json").read_text(encoding="utf-8"))
    compiled = {Path(command["file"]).resolve() for command in commands}
    assert [path for path in TESTS.rglob("*_test.cpp") if path not in compiled] == []
