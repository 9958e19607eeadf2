"""A mutant, built in a copy of the sources and tested."""

from __future__ import annotations

import filecmp
import os
import re
import shutil
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from choice import Candidate, Result
from report.errors import ReportError
from report.git import git

ROOT = Path(__file__).resolve().parents[2]
FLAGS = ("-GNinja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER=g++",
         "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DTHINBENCH_ISA_OPTIMISATION=-O1",
         "-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=gold",  # three times as fast
         "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST",
         "-DTHINBENCH_BUILD_PYTHON=OFF", "-DTHINBENCH_INSTALL=OFF")


class Build:
    """Programs of the copy with some instruction sets; `pristine` has those without a mutation."""

    def __init__(self, sources: Path, directory: Path, isas: str, programs: Sequence[str]) -> None:
        self.directory, self.pristine = directory, directory / "pristine"
        self.usual: dict[str, float] = {}
        if not (directory / "build.ninja").exists():
            subprocess.run(["cmake", "-S", sources, "-B", directory, *FLAGS, f"-DTHINBENCH_ISAS={isas}"],
                           check=False)
        if subprocess.run(["ninja", "-C", directory, *programs], check=False).returncode:
            raise ReportError(f"the copy cannot be built; run: ninja -C {directory}")
        shutil.copytree(directory / "bin", self.pristine, dirs_exist_ok=True)

    def result(self, checks: Sequence[str]) -> Result:
        """Of the mutant that is in the sources now. Each program is built when its turn comes."""
        changed = False
        for check in checks:
            name = check.split()[0]
            if subprocess.run(["ninja", "-C", self.directory, name], capture_output=True, check=False).returncode:
                return Result("not compiled")
            if filecmp.cmp(self.directory / "bin" / name, self.pristine / name, shallow=False):
                continue
            changed = True
            if test := run(self.directory / "bin", check, 1.5 * self._usual_seconds(check) + 2):
                return Result("killed", test)
        return Result("survived" if changed else "same code")

    def _usual_seconds(self, check: str) -> float:
        if check not in self.usual:
            start = time.monotonic()
            if test := run(self.pristine, check, 600):
                raise ReportError(f"{check} fails without a mutation: {test}")
            self.usual[check] = time.monotonic() - start
        return self.usual[check]


@dataclass(frozen=True)
class Trial:
    """Tries mutants, one at a time: with one instruction set first, which notices most of them."""

    kernels: Path
    quick: Build
    thorough: Build

    def result(self, one: Candidate, is_explained: bool = False) -> Result:
        """Of one mutant. Those of which we know why no test notices them are tried quickly only."""
        path, start = self.kernels / one.file, time.monotonic()
        checks, thorough = ([check.replace("{stem}", path.stem) for check in some]
                            for some in (one.family.checks, one.family.thorough))
        text = path.read_text(encoding="utf-8")
        path.write_text(one.mutation.apply(text), encoding="utf-8")
        try:
            result = self.quick.result(checks)
            if result.state in ("survived", "same code") and not is_explained:
                result = self.thorough.result(checks + thorough)
        finally:
            path.write_text(text, encoding="utf-8")
        return Result(result.state, result.test, round(time.monotonic() - start, 1))


def prepare(directory: Path, programs: Sequence[str]) -> Trial:
    """Copies and builds. Files that are as they should be remain untouched, so that nothing is built twice."""
    tree = directory / "tree"
    if shutil.which("ccache"):  # what is as before a mutant, or the same for all ISAs, is not compiled again
        os.environ |= {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache", "CCACHE_DIR": str(directory / "ccache"),
                       "CCACHE_BASEDIR": str(directory), "CCACHE_SLOPPINESS": "pch_defines,time_macros"}
    names = (git("ls-files") or "").splitlines()
    if not names:
        raise ReportError("mutants need a clone, with git, as the sources that it lists are copied")
    for old in tree.rglob("*"):  # of files that are gone, which a pattern of CMake would find
        if old.is_file() and str(old.relative_to(tree)) not in names:
            old.unlink()
    for name in names:
        source, copy = ROOT / name, tree / name
        if source.is_file() and not (copy.is_file() and filecmp.cmp(source, copy, shallow=False)):
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)
    return Trial(tree / "kernels", Build(tree, directory / "quick", "baseline", programs),
                 Build(tree, directory / "thorough", "baseline;avx2;avx512icl", programs))  # 128, 256 and 512 bits


def run(programs: Path, check: str, limit: float) -> str:
    """The first test that fails, or ''. `limit` is in seconds of the processor; a test that waits has more."""
    program, *rest = check.split()
    tests, *variables = rest or ["*"]
    command = ["env", "GTEST_FAIL_FAST=1", *variables, "prlimit", f"--cpu={int(limit) + 1}", f"--as={8 << 30}",
               "--core=0", str(programs / program), f"--gtest_filter={tests}"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False,
                              timeout=60 + 5 * limit)
    except subprocess.TimeoutExpired:
        return f"{program} (time limit)"
    if done.returncode == 0:
        return ""
    failed = re.search(r"\[  FAILED  \] ([^\s,]+)", done.stdout)
    return failed[1] if failed else f"{program} (status {done.returncode})"
