"""One mutant: compiled, compared, linked and tested."""

from __future__ import annotations

import re
import resource
import signal
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from families import Check, Family
from operators import Mutation
from tree import ISAS, Overlay, TreeError, environment

FAILED = re.compile(r"\[  FAILED  \] ([^\s,]+)")
RUNNING = re.compile(r"\[ RUN      \] (\S+)")
MEMORY = 8 << 30


@dataclass(frozen=True)
class Verdict:
    """`state` is killed, survived, not compiled or same code; `test` is what killed it."""

    state: str
    test: str = ""


class Trial:
    """Tries mutants, one at a time. `seconds`, the times of the unmutated programs, can be shared."""

    def __init__(self, overlay: Overlay, seconds: dict[tuple[Check, int], float]) -> None:
        self.overlay, self.tree, self.seconds = overlay, overlay.tree, seconds

    def judge(self, family: Family, file: str, mutation: Mutation) -> Verdict:
        """What becomes of a mutation of a file of kernels/."""
        text = (self.tree.kernels / file).read_text(encoding="utf-8")
        self.overlay.mutate(file, mutation.apply(text))
        wanted = set().union(*(self.tree.inputs[check.program] for check in family.checks))
        names = [name for name in self.tree.objects.get(f"kernels/{file}", []) if name in wanted]
        changed: list[str] = []
        for stage, part in self._stages(family, names):
            new = self._changed(part)
            if new is None:
                return Verdict("not compiled")
            changed += new
            if not new:
                continue
            killer = self._killer(family, stage, changed)
            if killer is not None:
                return killer
        return Verdict("survived" if changed else "same code")

    def _stages(self, family: Family, names: Sequence[str]) -> list[tuple[int, list[str]]]:
        """What to compile before the tests run: first a few files, then the baseline's and common ones,
        then those of each further ISA. Until then that ISA is not available."""
        first = [name for name in names if self.tree.stage_of(name) == 0 and
                 any(name.endswith(f"/{source}.o") for source in family.first)]
        stages = [(0, first)]
        for stage in range(len(ISAS)):
            stages.append((stage, [name for name in names if self.tree.stage_of(name) == stage and
                                   name not in first]))
        return [(stage, part) for stage, part in stages if part]

    def _changed(self, names: Sequence[str]) -> list[str] | None:
        """Those whose code differs; none if one is not accepted by the compiler."""
        if not all(self.overlay.compile(name) for name in names):
            return None
        return [name for name in names if not self.overlay.is_unchanged(name)]

    def _killer(self, family: Family, stage: int, changed: Sequence[str]) -> Verdict | None:
        linked: set[str] = set()
        for check in family.checks:
            if not self.tree.inputs[check.program].intersection(changed):
                continue
            limit = 5 * self._usual_seconds(check, stage) + 10
            if check.program not in linked and not self.overlay.link(check.program, changed):
                return Verdict("not compiled", f"{check.program} does not link")
            linked.add(check.program)
            test = run(self.overlay.program(check.program), check, stage, limit)
            if test is not None:
                return Verdict("killed", test)
        return None

    def _usual_seconds(self, check: Check, stage: int) -> float:
        if (check, stage) not in self.seconds:
            start = time.monotonic()
            test = run(self.tree.program(check.program), check, stage, 600)
            if test is not None:
                raise TreeError(f"{check.program} {check.tests} fails without a mutation: {test}")
            self.seconds[check, stage] = time.monotonic() - start
        return self.seconds[check, stage]


def run(program: Path, check: Check, stage: int, limit: float) -> str | None:
    """The first test that fails, or none."""
    isas = sorted({ISAS[0], ISAS[stage]})
    command = [str(program), f"--gtest_filter={check.tests}"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment(isas),
                          preexec_fn=_limit_memory) as process:
        try:
            output = process.communicate(timeout=limit)[0].decode(errors="replace")
        except subprocess.TimeoutExpired:
            process.kill()
            return f"{_last(process.communicate()[0].decode(errors='replace'), check)} (time limit)"
    if process.returncode == 0:
        return None
    failed = FAILED.search(output)
    if failed:
        return failed[1]
    end = signal.Signals(-process.returncode).name if process.returncode < 0 else f"status {process.returncode}"
    return f"{_last(output, check)} ({end})"


def _last(output: str, check: Check) -> str:
    started: list[str] = RUNNING.findall(output)
    return started[-1] if started else check.program


def _limit_memory() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
