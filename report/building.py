"""Configures and builds with CMake, with a progress line. Run as
`python3 -m report.building PRESET [TARGET...]` by ./check."""

from __future__ import annotations

import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from report.errors import ReportError
from report.progress import Progress

ROOT = Path(__file__).resolve().parent.parent
STEP = re.compile(r"\[(\d+)/(\d+)\]")
BENCHMARKS = ("thinbench_benchmarks",)
ISA_FLAGS = {"avx512icl": "avx512_vbmi2", "avx512": "avx512bw", "avx2": "avx2"}
"""By what Linux names one of the instructions, highest first."""


def build(preset: str, targets: Sequence[str] = (), root: Path = ROOT, isas: Sequence[str] = ()) -> Path:
    """Returns the directory of the programs, with kernels for these ISAs or for all. The log is shown only if
    something fails."""
    if shutil.which("cmake") is None:
        raise ReportError("there is no program 'cmake'; leave out --no-install, or install it")
    chosen = [f"-DTHINBENCH_ISAS={';'.join(isas)}"] if isas else []
    log = root / "build" / f"{preset}.log"
    _check_writable(root / "build" / preset, log)
    with log.open("w", encoding="utf-8") as out:
        configure = subprocess.run(["cmake", "--preset", preset, *chosen], cwd=root, stdout=out,
                                   stderr=subprocess.STDOUT, check=False)
        done = configure.returncode == 0 and _make(preset, targets, root, out)
    if not done:
        sys.stderr.write("".join(log.read_text(encoding="utf-8").splitlines(True)[-40:]))
        raise ReportError(f"the build failed; the whole log is {log}")
    return root / "build" / preset / "bin"


def isas_in_use(cpuinfo: Path = Path("/proc/cpuinfo")) -> list[str]:
    """The baseline, AVX2 and the highest ISA of this machine: what a quick study compiles. Empty, that is all,
    where this is unknown or THINBENCH_MAX_ISA asks for another."""
    if os.environ.get("THINBENCH_MAX_ISA") or platform.machine() != "x86_64" or not cpuinfo.exists():
        return []
    flags = set(re.findall(r"\w+", cpuinfo.read_text(encoding="utf-8", errors="replace")))
    highest = next((isa for isa, flag in ISA_FLAGS.items() if flag in flags), None)
    return list(dict.fromkeys(["baseline", "avx2", highest])) if highest else []


def _check_writable(directory: Path, log: Path) -> None:
    """Else the build would be blamed."""
    try:
        directory.mkdir(parents=True, exist_ok=True)
        log.touch()
        with tempfile.TemporaryFile(dir=directory):
            pass
    except OSError as error:
        raise ReportError(f"'{error.filename or directory}' cannot be written: {error.strerror}; "
                          "the build needs a working tree that may be written to") from None


def _make(preset: str, targets: Sequence[str], root: Path, log: object) -> bool:
    command = ["cmake", "--build", "--preset", preset, "--parallel"]
    command += ["--target", *targets] if targets else []
    progress: Progress | None = None
    with subprocess.Popen(command, cwd=root, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True) as process:
        assert process.stdout
        for line in process.stdout:
            log.write(line)  # type: ignore[attr-defined]
            if step := STEP.match(line):
                progress = progress or Progress("building", int(step[2]))
                progress.set(int(step[1]), int(step[2]))  # globs are checked first, as a build
    if progress:
        progress.close()
    return process.returncode == 0


if __name__ == "__main__":
    try:
        build(sys.argv[1], sys.argv[2:])
    except ReportError as error:
        sys.exit(f"building: {error}")
