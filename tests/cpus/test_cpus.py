"""The program on emulated x86-64 processors. Run by ./check cpus; needs qemu-x86_64 and THINBENCH_PROGRAMS, the
directory of the programs."""

from __future__ import annotations

import json
import re
import subprocess
from typing import Any

import pytest

from tests.programs import PROGRAMS

CPUS: dict[str, tuple[set[str], dict[str, str]]] = {
    "Conroe": ({"baseline"}, {"sse4.2": "sse4.2, popcnt", "avx2": "sse4.2, popcnt, avx2, bmi, bmi2"}),
    "Nehalem": ({"baseline", "sse4.2"}, {"avx2": "avx2, bmi, bmi2"}),
    "max,-bmi2": ({"baseline", "sse4.2"}, {"avx2": "bmi2"}),
    "max": ({"baseline", "sse4.2", "avx2"}, {}),
    "max,-xsave": ({"baseline", "sse4.2"}, {"avx2": "avx2"}),  # the system does not keep wide registers
}
"""By processor: the instruction sets that run, and what is said to be missing for others. The emulator has no AVX-512."""
QUICK = "^(thin_guo_hall|thin_mb2|edges_sobel|euler_number|midpoint_scan|net_two_layer_linear:1)/simd"
"""A few seconds of work without an emulator."""


def emulated(cpu: str, *arguments: str) -> str:
    done = subprocess.run(["qemu-x86_64", "-cpu", cpu, str(PROGRAMS / "thinbench-study"), *arguments],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{cpu}: status {done.returncode}: {done.stderr[-2000:]}"
    return done.stdout


@pytest.fixture(name="variants", scope="module", params=CPUS)
def of_cpu(request: pytest.FixtureRequest) -> tuple[str, list[dict[str, Any]]]:
    return request.param, json.loads(emulated(request.param, "list", "--json"))


def test_available_are_the_instruction_sets_whose_features_the_processor_has(variants):
    cpu, listed = variants
    assert {v["isa"] for v in listed if v["available"] and not v["peer"]} == CPUS[cpu][0]


def test_the_missing_features_are_named(variants):
    cpu, listed = variants
    for isa, missing in CPUS[cpu][1].items():
        reasons = {v["reason"] for v in listed if v["isa"] == isa and not v["peer"]}
        assert reasons == {f"this machine lacks {missing}"}


def test_the_fastest_that_is_available_is_of_the_best_instruction_set(variants):
    cpu, listed = variants
    fastest = {v["isa"] for v in listed if v["fastest"] and v["operation"] == "thin_guo_hall"}
    assert fastest == {"avx2" if "avx2" in CPUS[cpu][0] else "baseline"}


def test_all_that_runs_equals_the_reference(variants):
    cpu, _ = variants
    last = emulated(cpu, "verify", "--quick", "--threads", "2", "--filter", QUICK).splitlines()[-1]
    found = re.fullmatch(r"(\d+) passed, 0 failed, (\d+) skipped", last)
    assert found and int(found[1]) > 15, f"{cpu}: {last}"
