"""A mutant, built in a copy of the sources and tested."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path

from choice import Candidate, Result
from families import Check

ROOT = Path(__file__).resolve().parents[2]
COPIED = ("CMakeLists.txt", "kernels", "reference", "bench", "tools", "tests", "cmake", "python")
# In the copy, a file has another text in place of this one: there the instruction sets are given.
EDITED = "kernels/CMakeLists.txt"
BEFORE, AFTER = "set(thinbench_isas ${isas}", "set(isas ${MUTANT_ISAS})\nset(thinbench_isas ${isas}"
QUICK_ISAS, ALL_ISAS = "baseline", "baseline;avx2;avx512icl"  # 128, 256 and 512 bits
FLAGS = ("-GNinja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER=g++",
         "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DTHINBENCH_ISA_OPTIMISATION=-O1",
         "-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=gold",  # three times as fast
         "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST",
         "-DTHINBENCH_BUILD_PYTHON=OFF", "-DTHINBENCH_INSTALL=OFF")
FAILED = re.compile(r"\[  FAILED  \] ([^\s,]+)")
MEMORY = 8 << 30


class TreeError(Exception):
    """The copy cannot be made, built or tested."""


def copy_sources(to: Path) -> None:
    """Files that are as they should be remain untouched, so that nothing is built twice."""
    listed = subprocess.run(["git", "ls-files", "--", *COPIED], cwd=ROOT, capture_output=True,
                            text=True, check=True)
    for name in listed.stdout.splitlines():
        if not (ROOT / name).is_file():
            continue
        text = (ROOT / name).read_bytes()
        if name == EDITED:
            if BEFORE.encode() not in text:
                raise TreeError(f"{name} does not contain '{BEFORE}'; see tests/mutation/trial.py")
            text = text.replace(BEFORE.encode(), AFTER.encode())
        if not (to / name).exists() or (to / name).read_bytes() != text:
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            (to / name).write_bytes(text)
            shutil.copymode(ROOT / name, to / name)


class Build:
    """Programs of the copy with some instruction sets; `pristine` has those without a mutation."""

    def __init__(self, sources: Path, directory: Path, isas: str, programs: Sequence[str]) -> None:
        self.directory, self.pristine = directory, directory / "pristine"
        self.usual: dict[Check, float] = {}
        if not (directory / "build.ninja").exists():
            subprocess.run(["cmake", "-S", sources, "-B", directory, *FLAGS,
                            f"-DMUTANT_ISAS={isas}"], check=False)
        if subprocess.run(["ninja", "-C", directory, *programs], check=False).returncode:
            raise TreeError(f"the copy cannot be built; run: ninja -C {directory}")
        self.pristine.mkdir(exist_ok=True)
        for program in programs:
            shutil.copy2(directory / "bin" / program, self.pristine)

    def result(self, checks: Sequence[Check]) -> Result:
        """Of the mutant that is in the sources now. Each program is built when its turn comes."""
        changed = False
        for check in checks:
            program = self.directory / "bin" / check.program
            if subprocess.run(["ninja", "-C", self.directory, check.program],
                              capture_output=True, check=False).returncode:
                return Result("not compiled")
            if program.read_bytes() == (self.pristine / check.program).read_bytes():
                continue
            changed = True
            test = run(program, check, 1.5 * self._usual_seconds(check) + 2)
            if test is not None:
                return Result("killed", test)
        return Result("survived" if changed else "same code")

    def _usual_seconds(self, check: Check) -> float:
        if check not in self.usual:
            start = time.monotonic()
            test = run(self.pristine / check.program, check, 600)
            if test is not None:
                raise TreeError(f"{check.program} {check.tests} fails without a mutation: {test}")
            self.usual[check] = time.monotonic() - start
        return self.usual[check]


class Trial:
    """Tries mutants, one at a time: with one instruction set first, which notices most of them."""

    def __init__(self, sources: Path, quick: Build, thorough: Build) -> None:
        self.kernels, self.quick, self.thorough = sources / "kernels", quick, thorough

    def result(self, one: Candidate, is_explained: bool = False) -> Result:
        """Of one mutant. Those of which we know why no test notices them are tried quickly only."""
        checks, thorough = ([check.of(one.file) for check in part]
                            for part in (one.family.checks, one.family.thorough))
        path, start = self.kernels / one.file, time.monotonic()
        text = path.read_text(encoding="utf-8")
        path.write_text(one.mutation.apply(text), encoding="utf-8")
        try:
            result = self.quick.result(checks)
            if result.state in ("survived", "same code") and not is_explained:
                result = self.thorough.result(checks + thorough)
        finally:
            path.write_text(text, encoding="utf-8")
        return Result(result.state, result.test, round(time.monotonic() - start, 1))


def run(program: Path, check: Check, limit: float) -> str | None:
    """The first test that fails, or none. `limit` is in seconds of the processor; a test that
    waits has more."""
    command = ["prlimit", f"--cpu={int(limit) + 1}", f"--as={MEMORY}", "--core=0", str(program),
               f"--gtest_filter={check.tests}"]
    variables = {**os.environ, "GTEST_FAIL_FAST": "1", **dict(check.variables)}
    try:
        done = subprocess.run(command, capture_output=True, env=variables, text=True,
                              errors="replace", check=False, timeout=60 + 5 * limit)
    except subprocess.TimeoutExpired:
        return f"{check.program} (time limit)"
    if done.returncode == 0:
        return None
    failed = FAILED.search(done.stdout)
    return failed[1] if failed else f"{check.program} (status {done.returncode})"
