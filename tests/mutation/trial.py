"""One mutant: compiled, compared, linked and tested."""

from __future__ import annotations

import json
import re
import resource
import signal
import subprocess
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from threading import Lock

from families import Check, Family
from operators import Mutation
from tree import ISAS, Overlay, Tree, TreeError, environment

FAILED = re.compile(r"\[  FAILED  \] ([^\s,]+)")
RUNNING = re.compile(r"\[ RUN      \] (\S+)")
SHARED = re.compile(r"^(  static|inline) constexpr .*\bk[A-Z]\w+ =")
MEMORY = 8 << 30


@dataclass(frozen=True)
class Verdict:
    """`state` is killed, survived, not compiled or same code; `test` is what killed it."""

    state: str
    test: str = ""


@dataclass(frozen=True)
class Step:
    """What is compiled before the tests run, for an ISA; its last step ends a quick trial."""

    stage: int
    names: list[str]
    is_last: bool


class Usual:
    """The seconds that tests of the unmutated programs take; kept in a file."""

    def __init__(self, tree: Tree, file: Path) -> None:
        self.tree, self.file, self.lock = tree, file, Lock()
        self.known: dict[str, float] = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}

    def seconds(self, check: Check, isas: Sequence[str]) -> float:
        """With these ISAs."""
        key = " ".join([check.program, check.tests, *isas, *map("=".join, check.variables)])
        with self.lock:
            if key not in self.known:
                start = time.monotonic()
                test = run(self.tree.program(check.program), check, isas, 600)
                if test is not None:
                    raise TreeError(f"{check.program} {check.tests} fails without a mutation: {test}")
                self.known[key] = round(time.monotonic() - start, 1)
                self.file.write_text(json.dumps(self.known, indent=1), encoding="utf-8")
            return self.known[key]


class Trial:
    """Tries mutants, one at a time. `usual`, the seconds of the unmutated programs, can be shared."""

    def __init__(self, overlay: Overlay, usual: Usual) -> None:
        self.overlay, self.tree, self.usual = overlay, overlay.tree, usual

    def judge(self, family: Family, file: str, mutation: Mutation, thorough: bool = False) -> Verdict:
        """What becomes of a mutation of a file of kernels/."""
        checks = [check.of(file) for check in family.checks + (family.thorough if thorough else ())]
        text = (self.tree.kernels / file).read_text(encoding="utf-8")
        self.overlay.mutate(file, mutation.apply(text))
        # Several files may agree on a constant of a header: all of them are compiled before the tests run.
        shared = file.endswith(".hpp") and SHARED.search(text.split("\n")[mutation.line - 1]) is not None
        wanted = set().union(*(self.tree.inputs[check.program] for check in checks))
        names = [name for name in self.tree.objects.get(f"kernels/{file}", []) if name in wanted and
                 (shared or thorough or self.tree.is_kernel(name))]
        near = names if shared else [name for name in names if self._is_near(name, family, file)]
        far = sorted((name for name in names if name not in near), key=self.tree.is_common)
        changed: list[str] = []
        waiting = set(names)
        for step in [*self._steps(near, shared, family.first), *self._steps(far, shared, far)]:
            new = self._changed(step.names)
            if new is None:
                return Verdict("not compiled")
            changed += new
            waiting -= set(step.names)
            if not new and not (step.is_last and changed):
                continue
            killer = self._killer(checks, self._isas(step.stage, waiting, thorough), changed)
            if killer is not None:
                return killer
            if step.is_last and not thorough:
                break
        return Verdict("survived" if changed else "same code")

    def _isas(self, stage: int, waiting: set[str], thorough: bool) -> list[str]:
        """The baseline, the ISA of the stage, and those of which nothing is to be compiled yet, as they would run old
        code; if not thorough, two of them."""
        stages = {self.tree.stage_of(name) for name in waiting if not self.tree.is_common(name)} - {stage}
        others = [one for one in range(1, len(ISAS)) if one not in stages]
        if not thorough:
            others = [stage] if stage > 0 else others[-1:]
        return [ISAS[0], *(ISAS[one] for one in others)]

    def _is_near(self, name: str, family: Family, file: str) -> bool:
        """Of the same directory, or one of the family's first: enough for most mutants of a header."""
        source = self.tree.source_of(name)
        return source.split("/")[0] == file.split("/")[0] or source in family.first

    def _steps(self, names: Sequence[str], together: bool, first: Sequence[str]) -> Iterator[Step]:
        """Unless all are needed together, the first files, named by object or source, come alone."""
        for stage in range(len(ISAS)):
            part = [name for name in names if self.tree.stage_of(name) == stage]
            alone = [] if together else [name for one in first for name in part
                                         if one in (name, self.tree.source_of(name))]
            for name in alone:
                yield Step(stage, [name], False)
            yield Step(stage, [name for name in part if name not in alone], True)

    def _changed(self, names: Sequence[str]) -> list[str] | None:
        """Those whose code differs; none if one is not accepted by the compiler."""
        if not all(self.overlay.compile(name) for name in names):
            return None
        return [name for name in names if not self.overlay.is_unchanged(name)]

    def _killer(self, checks: Sequence[Check], isas: Sequence[str], changed: Sequence[str]) -> Verdict | None:
        linked: set[str] = set()
        for check in checks:
            if not self.tree.inputs[check.program].intersection(changed):
                continue
            limit = 1.5 * self.usual.seconds(check, isas) + 2
            if check.program not in linked and not self.overlay.link(check.program, changed):
                return Verdict("not compiled", f"{check.program} does not link")
            linked.add(check.program)
            test = run(self.overlay.program(check.program), check, isas, limit)
            if test is not None:
                return Verdict("killed", test)
        return None


def run(program: Path, check: Check, isas: Sequence[str], limit: float) -> str | None:
    """The first test that fails, or none. The limit is of seconds of the processor; a test that waits has more."""
    command = [str(program), f"--gtest_filter={check.tests}"]
    variables = {**environment(isas), **dict(check.variables)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=variables,
                          preexec_fn=partial(_limit, int(limit) + 1)) as process:
        try:
            output = process.communicate(timeout=60 + 5 * limit)[0].decode(errors="replace")
        except subprocess.TimeoutExpired:
            process.kill()
            output = process.communicate()[0].decode(errors="replace")
    if process.returncode == 0:
        return None
    failed = FAILED.search(output)
    if failed:
        return failed[1]
    started = RUNNING.findall(output) or [check.program]
    return f"{started[-1]} ({_end(process.returncode)})"


def _end(status: int) -> str:
    if status in (-signal.SIGXCPU, -signal.SIGKILL):
        return "time limit"
    return signal.Signals(-status).name if status < 0 else f"status {status}"


def _limit(seconds: int) -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
