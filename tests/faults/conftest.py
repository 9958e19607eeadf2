"""Starts the built programs, with and without a fault, and compares what they leave behind.

THINBENCH_FAULT_SHIM is the library made of shim.c."""

from __future__ import annotations

import os
import random
import re
import resource
import shlex
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from PIL import Image, ImageDraw

from tests.programs import PROGRAMS, ROOT

SHIM = os.environ.get("THINBENCH_FAULT_SHIM", str(ROOT / "build/release/tests/faults/libfault_shim.so"))
SEED = int(os.environ.get("THINBENCH_IMAGES_SEED") or random.SystemRandom().randrange(2**32))
"""Of images that differ from run to run."""
SECONDS = 600
"""After so long a program counts as hanging."""

REMARKS = re.compile(r".*about \d+ s left|note: |warning: |wrote |\w+: \d+ images in |\d+ rows? w(as|ere) not counted|\d{4}-\d\d-|Run(ning| on) |CPU Caches|"
                     r"  L\d |Load Average|\*\*\*WARNING")
"""Lines on standard error that are no failures, those of Google Benchmark included."""


@dataclass(frozen=True)
class Result:
    """Of a program that has ended."""

    status: int
    out: bytes
    err: bytes

    @property
    def errors(self) -> list[str]:
        """Lines on standard error that report a failure."""
        lines = self.err.decode(errors="replace").splitlines()
        return [line for line in lines if not REMARKS.match(line)]

    def assert_failed(self, says: str = "", status: int = 1) -> None:
        """With one line that has this pattern."""
        assert self.status == status and len(self.errors) == 1, self
        assert re.search(says, self.errors[0]), self


@dataclass(frozen=True)
class Fault:
    """What is wrong while a program runs."""

    name: str
    in_child: Callable[[], None] = lambda: None  # before the program begins
    environment: Mapping[str, str] = field(default_factory=dict)
    prefix: Sequence[str] = ()  # of the command
    out: str = os.devnull  # another file as standard output

    def __str__(self) -> str:
        return self.name


NO_FAULT = Fault("none")


def start(words: Sequence[str], directory: Path, fault: Fault = NO_FAULT,
          stdin: int = subprocess.DEVNULL) -> subprocess.Popen[bytes]:
    """In this directory. The first word is the program, of those that were built, or a path."""
    program = words[0] if "/" in words[0] else str(PROGRAMS / words[0])
    with open(fault.out, "wb") as out:
        return subprocess.Popen(  # pylint: disable=subprocess-popen-preexec-fn
            [*fault.prefix, program, *words[1:]], cwd=directory, stdin=stdin,
            stdout=subprocess.PIPE if fault.out == os.devnull else out, stderr=subprocess.PIPE,
            env={**os.environ, **fault.environment}, preexec_fn=fault.in_child)


def finish(process: subprocess.Popen[bytes]) -> Result:
    """Waits for the end. A program that hangs is killed."""
    try:
        out, err = process.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        process.kill()
        raise
    return Result(process.returncode, out or b"", err)


def run(words: Sequence[str], directory: Path, fault: Fault = NO_FAULT,
        stdin: int = subprocess.DEVNULL) -> Result:
    """From start to end."""
    return finish(start(words, directory, fault, stdin))


MEASURE = """
import resource, subprocess, sys
status = subprocess.run(sys.argv[1:]).returncode
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, file=sys.stderr)
sys.exit(status)"""


def measured_run(words: Sequence[str], directory: Path) -> tuple[Result, int]:
    """With the highest number of bytes of resident memory. A process in between is needed: to that of a child counts
    what the parent held when it began."""
    result = run(words, directory, Fault("measured", prefix=("/usr/bin/python3", "-ISc", MEASURE)))
    lines = result.err.splitlines(keepends=True)
    return Result(result.status, result.out, b"".join(lines[:-1])), int(lines[-1]) * 1024


Files = dict[str, bytes]


def files_in(directory: Path) -> Files:
    """All files below a directory, hidden ones included, by name; directories end with a slash."""
    return {str(path.relative_to(directory)) + "/" * path.is_dir():
            b"" if path.is_dir() else path.read_bytes() for path in directory.rglob("*")}


def expect_rejected(command: str, directory: Path, says: str) -> None:
    """The program ends with one line that has this pattern and leaves nothing new."""
    before = files_in(directory)
    run(["thinbench", *shlex.split(command)], directory).assert_failed(says)
    assert files_in(directory) == before


def parts(width: int = 300, height: int = 200) -> Image.Image:
    """Two parts, one with a hole, in grey."""
    image = Image.new("L", (300, 200), 10)
    draw = ImageDraw.Draw(image)
    draw.rectangle((20, 20, 120, 90), fill=220)
    draw.rectangle((50, 40, 60, 50), fill=12)
    draw.ellipse((150, 60, 280, 180), fill=200)
    return image.resize((width, height), Image.Resampling.NEAREST)


def binary(image: Image.Image) -> Image.Image:
    """Of one bit per pixel."""
    return image.point(lambda grey: 255 * (grey > 100)).convert("1")


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Also where nothing failed, as a run may be slow."""
    terminalreporter.write_line(f"THINBENCH_IMAGES_SEED={SEED}")


@pytest.fixture(scope="session", name="inputs")
def _inputs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A directory of images."""
    directory = tmp_path_factory.mktemp("inputs")
    (directory / "many").mkdir()
    for name in ("a.png", "a.pgm", "a.bmp", "a.jpg"):
        parts().save(directory / name)
    parts(1500, 1000).save(directory / "large.png")
    for name in ("large.pgm", "large.grey.tif"):
        parts(1500, 1000).save(directory / name)
    parts(2, 2).save(directory / "tiny.pgm")
    parts().save(directory / "a.grey.tif")
    for name, image in (("a", binary(parts())), ("large", binary(parts(1500, 1000)))):
        image.save(directory / f"{name}.pbm")
        image.save(directory / f"{name}.tif", compression="group4")
    for i in range(6):
        parts(300 + i, 200).save(directory / "many" / f"{i}.png")
    return directory


def limit(number: int, value: int) -> Callable[[], None]:
    """Sets a limit of the system in the child."""
    return lambda: resource.setrlimit(number, (value, value))


READERS = ["run thin_guo_hall {} out.tif", "run majority {} out.png", "holes {}", "edges {} out.png",
           "fill-holes {} out.png", "labels {} out.png", "distance {} out.png", "euler {}",
           "localise {} --csv out.csv --overlay out.svg", "graph {} --csv out.csv --overlay out.png",
           "path {} --start 1,1 --goal 9,9 --overlay out.svg"]
"""Commands that read an image."""


def mounted(commands: str) -> tuple[str, ...]:
    """The prefix of a program that runs where these commands may mount file systems."""
    prefix = ("unshare", "-rm", "sh", "-c")
    if subprocess.run([*prefix, "mount -t tmpfs none /mnt"], check=False, capture_output=True).returncode:
        pytest.skip("mounting needs root or namespaces of users")
    return (*prefix, commands, "sh")
