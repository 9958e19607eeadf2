"""Programs under faults: they end with one clear line, a status other than 0 and nothing half-written, or do the
work all the same; and the next run works."""

from __future__ import annotations

import ctypes
import itertools
import os
import random
import re
import resource
import shutil
import signal
import struct
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import NO_FAULT, READERS, ROOT, SHIM, Fault, Files, Result, files_in, finish, limit, mounted, run, start

ROWS = "^euler_number/bitpacked/baseline/1"
COMMANDS = {
    "run": "thinbench run thin_guo_hall {}/large.png out.png",
    "run_pgm": "thinbench run thin_guo_hall {}/large.png out.pgm",
    "run_grey_tiff": "thinbench run thin_guo_hall {}/large.pgm out.tif --threads 2",
    "run_pbm": "thinbench run thin_guo_hall {}/a.pbm out.pbm",
    "run_tiff": "thinbench run thin_guo_hall {}/a.tif out.tif",
    "holes": "thinbench holes {}/large.png --threads 2",
    "overlay": "thinbench holes {}/large.png --overlay out.png",
    "edges": "thinbench edges {}/large.png out.png --threads 2",
    "fill_holes": "thinbench fill-holes {}/large.png out.png --threads 2",
    "labels": "thinbench labels {}/large.png out.png --threads 2",
    "distance": "thinbench distance {}/large.pgm out.tif --threads 2",
    "euler": "thinbench euler {}/large.png --threads 2",
    "localise": "thinbench localise {}/large.png --threads 2",
    "localise_overlay": "thinbench localise {}/large.png --overlay out.png",
    "csv": "thinbench localise {}/large.png --csv out.csv",
    "graph": "thinbench graph {}/large.png --threads 2 --json",
    "graph_overlay": "thinbench graph {}/large.png --overlay out.svg",
    "path": "thinbench path {}/large.png --start 1,1 --goal 1490,990 --foreground dark --width 9",
    "path_overlay": "thinbench path {}/large.png --start 1,1 --goal 1490,990 --foreground dark --overlay out.png",
    "batch": "thinbench batch thin_guo_hall {}/many --out results --threads 2",
    "batch_holes": "thinbench batch holes {}/many --out results --threads 1",
    "batch_table": "thinbench batch graph {}/many --out results --threads 2 --overlay svg --table table.csv",
    "rule": "thinbench run majority {}/large.png out.png",
    "rule_of_your_own": "thinbench run B3/S23 {}/large.png out.png --max-iterations 3",
    "save": "thinbench rule golay_l --save rule.json",
    "train": "thinbench-study train cluster --out weights.json",
    "verify": "thinbench-study verify --quick --filter " + ROWS,
    "instructions": f"thinbench-study instructions --filter {ROWS} --out counts.json",
    "scene": "thinbench-study scene out.png",
    "facts": "thinbench_benchmarks --input square_64 --filter ^edges_sobel/autovec/baseline/1 --facts facts.json",
    "benchmarks": "thinbench_benchmarks --input square_64 --filter ^edges_sobel/autovec/baseline/1",
}
VOLATILE = re.compile(rb"[0-9.]+ ms|(,[0-9.e-]+){3}(?=,,\n)|\"date\": .*|\"seconds\":[0-9.e-]+")
"""What differs from run to run: times."""
PRINTS_TIMES = {"batch", "batch_holes", "batch_table", "benchmarks"}


def words_of(name: str, inputs: Path) -> list[str]:
    """A command as a list."""
    return [word.format(inputs) for word in COMMANDS[name].split()]


def without_times(files: Files) -> Files:
    """What every run must give."""
    return {name: VOLATILE.sub(b"", data) for name, data in files.items()}


def made_by(name: str, result: Result, work: Path) -> Files:
    """Files, and what it printed."""
    assert result.status == 0, result
    shown = {} if name in PRINTS_TIMES else {"standard output": result.out}
    return without_times(files_in(work) | shown)


@pytest.fixture(scope="session", name="expected")
def _expected(inputs: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Files]:
    """What a command makes where nothing is wrong."""
    known: dict[str, Files] = {}

    def of(name: str) -> Files:
        if name not in known:
            work = tmp_path_factory.mktemp(name) / "work"
            work.mkdir()
            known[name] = made_by(name, run(words_of(name, inputs), work), work)
        return known[name]
    return of


Check = Callable[[str, Fault, str], None]


@pytest.fixture(name="works")
def _works(inputs: Path, tmp_path: Path, expected: Callable[[str], Files]) -> Callable[..., None]:
    """Runs a command that must do its work, and compares the result with the usual one."""
    def check(name: str, fault: Fault = NO_FAULT) -> None:
        result = run(words_of(name, inputs), tmp_path, fault)
        assert made_by(name, result, tmp_path) == expected(name)
    return check


@pytest.fixture(name="fails")
def _fails(inputs: Path, tmp_path: Path, works: Callable[..., None]) -> Check:
    """Runs a command that must fail with one line and leave everything as it was, then without the fault."""
    def check(name: str, fault: Fault, says: str) -> None:
        before = files_in(tmp_path)
        run(words_of(name, inputs), tmp_path, fault).assert_failed(says)
        assert files_in(tmp_path) == before
        works(name)
    return check


# Full disks.

FULL = Fault("file size limit", limit(resource.RLIMIT_FSIZE, 16))
FULL_OUT = Fault("/dev/full", out="/dev/full")
DRAWERS = ["overlay", "localise_overlay", "graph_overlay", "path_overlay"]
PIXELS = ["fill_holes", "labels", "distance"]
WRITERS = ["run", "run_pgm", "run_grey_tiff", "run_pbm", "run_tiff", "edges", "batch", "batch_holes",
           "batch_table", "csv", "rule", "save", "train", "instructions", "scene", *DRAWERS, *PIXELS]
PRINTERS = ["holes", "euler", "localise", "graph", "path"]


@pytest.mark.parametrize("name", WRITERS)
def test_full_disk(name: str, fails: Check) -> None:
    """Nothing of the file is left."""
    fails(name, FULL, "File too large")


@pytest.mark.parametrize("name", [*PRINTERS, "verify", "benchmarks"])
def test_full_standard_output(name: str, fails: Check) -> None:
    """It holds the result."""
    fails(name, FULL_OUT, "standard output cannot be written")


SMALL_DISK = ('mount -t tmpfs -o size=4k none "$PWD" && cd "$PWD" && "$@" >/dev/null; '
              'status=$?; ls -A; exit $status')


@pytest.mark.parametrize("name", ["run_pgm", "scene", *DRAWERS, "distance"])
def test_disk_of_4_kilobytes(name: str, inputs: Path, tmp_path: Path, works: Callable[..., None]) -> None:
    """As test_full_disk, by a real file system."""
    result = run(words_of(name, inputs), tmp_path, Fault("small disk", prefix=mounted(SMALL_DISK)))
    result.assert_failed("No space left on device")
    assert result.out == b""
    works(name)


# Directories that cannot be written to, also where root runs the tests.

def _without_override() -> None:
    """From its start on, the program of root obeys modes of files as others do."""
    ctypes.CDLL(None).prctl(24, 1, 0, 0, 0)  # PR_CAPBSET_DROP, CAP_DAC_OVERRIDE


@pytest.mark.parametrize("name", [name for name in WRITERS if name != "instructions"])
def test_read_only_directory(name: str, inputs: Path, tmp_path: Path, works: Callable[..., None]) -> None:
    """The directory is named or the file in it."""
    tmp_path.chmod(0o555)
    result = run(words_of(name, inputs), tmp_path, Fault("read-only", _without_override))
    tmp_path.chmod(0o755)
    result.assert_failed("Permission denied")
    assert files_in(tmp_path) == {}
    works(name)


# Little memory.

def _memory(inputs: Path) -> int:
    """The address space that the libraries need before an image is read, in KiB."""
    low, high = 0, 1 << 22
    while high - low > 256:
        middle = (low + high) // 2
        starts = run(["thinbench", "holes", "tiny.pgm"], inputs, Fault("", limit(resource.RLIMIT_AS, middle << 10)))
        low, high = (low, middle) if starts.status == 0 else (middle, high)
    return high


@pytest.fixture(scope="session", name="memory")
def _memory_fixture(inputs: Path) -> int:
    """Found once."""
    return _memory(inputs)


NO_MEMORY = "not enough memory|Cannot allocate memory|Resource temporarily unavailable"


@pytest.mark.parametrize("name", ["run", "run_grey_tiff", "edges", "rule", *DRAWERS, *PIXELS, *PRINTERS])
def test_little_memory(name: str, memory: int, inputs: Path, tmp_path: Path, expected: Callable[[str], Files]) -> None:
    """Wherever it ends, with one line or with the right result."""
    failures = 0
    for more in [0, 1000, 2000, 3000, 5000]:
        directory = tmp_path / str(more)
        directory.mkdir()
        fault = Fault("", limit(resource.RLIMIT_AS, (memory + more) << 10))
        result = run(words_of(name, inputs), directory, fault)
        if result.status == 0:
            assert made_by(name, result, directory) == expected(name)
            continue
        failures += 1
        assert result.status == 1 and len(result.errors) == 1, (more, result)
        assert re.search(NO_MEMORY, result.errors[0]), result
        assert files_in(directory) == {}
    assert failures > 0


def test_batch_with_little_memory(memory: int, inputs: Path, tmp_path: Path, works: Callable[..., None],
                                  expected: Callable[[str], Files]) -> None:
    """Images fail one by one, though decoders do not always say why; what is there is right."""
    says = NO_MEMORY + "|it is damaged"
    failures = 0
    for more in [0, 300, 600, 1200, 2000]:
        result = run(words_of("batch", inputs), tmp_path, Fault("", limit(resource.RLIMIT_AS, (memory + more) << 10)))
        assert result.status in (0, 1)
        if result.status == 1:
            head, *lines = [line for line in result.errors if not line.startswith("thinbench: ")] or [""]
            assert re.fullmatch(r"\d failures?:|", head), result
            assert all(re.search(says, line) for line in [*lines, *result.errors[1:]]), result
            failures += 1
        check_whole(without_times(files_in(tmp_path)), expected("batch"))
    assert failures > 0
    works("batch")


# Killed programs.

def check_whole(made: Files, expected: Files) -> None:
    """Whatever has its name is complete; a manifest has whole lines."""
    for name, data in made.items():
        if name.endswith("manifest.csv"):
            assert data == b"" or data.endswith(b"\n")
        elif not Path(name).name.startswith("."):
            assert data == expected[name], name


@pytest.mark.parametrize("name", ["run", "run_grey_tiff", "batch", "batch_table", "train"])
def test_killed_at_random_moments(name: str, inputs: Path, tmp_path: Path, works: Callable[..., None],
                                  expected: Callable[[str], Files]) -> None:
    """SIGKILL several times; then an undisturbed run."""
    expected(name)
    begin = time.monotonic()
    works(name)
    seconds = time.monotonic() - begin
    chance = random.Random(name)
    for _ in range(4):
        process = start(words_of(name, inputs), tmp_path)
        time.sleep(chance.uniform(0, seconds))
        os.kill(process.pid, signal.SIGKILL)
        assert finish(process).status in (-9, 0)
        check_whole(without_times(files_in(tmp_path)), expected(name))
    works(name)


@pytest.mark.parametrize("name", ["run", "run_grey_tiff", "run_pbm", "csv", "save", "train", "scene",
                                  *DRAWERS, *PIXELS])
def test_killed_before_the_result_has_its_name(name: str, inputs: Path, tmp_path: Path,
                                               works: Callable[..., None]) -> None:
    """The next run removes the hidden file, too."""
    assert run(words_of(name, inputs), tmp_path, shim("kill")).status == -9
    assert [path.name for path in tmp_path.iterdir() if not path.name.startswith(".")] == []
    assert files_in(tmp_path) != {}
    works(name)


# Outputs of which other names remain.


def test_interrupt_keeps_a_whole_file(inputs: Path, tmp_path: Path, expected: Callable[[str], Files]) -> None:
    """Beside an output of two names that is half-written."""
    (tmp_path / "out.pgm").write_bytes(b"old")
    (tmp_path / "other").hardlink_to(tmp_path / "out.pgm")
    assert run(words_of("run_pgm", inputs), tmp_path, shim("interrupt")).status == -signal.SIGINT
    assert sorted(files_in(tmp_path)) == ["other", "out.pgm", "out.pgm.whole"]
    assert (tmp_path / "out.pgm.whole").read_bytes() == expected("run_pgm")["out.pgm"]


# What only a library in front of the system's can do.

def shim(fault: str) -> Fault:
    """See shim.c."""
    assert Path(SHIM).is_file(), "build the target fault_shim"
    # OpenBLAS, which OpenCV may use, starts threads before main() and interrupts a program where that fails.
    return Fault(fault, environment={"LD_PRELOAD": SHIM, "FAULT": fault, "OPENBLAS_NUM_THREADS": "1"})


MOST = ["run", "run_grey_tiff", "run_tiff", "edges", "batch", "batch_table", "rule_of_your_own", "train",
        "facts", *PRINTERS, *PIXELS]


@pytest.mark.parametrize("name, fault", [
    *((name, "clock") for name in [*MOST, "verify", "benchmarks"]),  # it jumps by two years, forwards and backwards
    *((name, fault) for name in MOST for fault in ("proc", "threads"))])  # nothing there can be read, none be started
def test_work_is_done_all_the_same(name: str, fault: str, works: Callable[..., None]) -> None:
    works(name, shim(fault))


def test_instructions_are_counted_without_proc(inputs: Path, tmp_path: Path) -> None:
    """By single steps: the program does not find the one that valgrind runs."""
    result = run(words_of("instructions", inputs), tmp_path, shim("proc"))
    assert result.status == 0 and b"/proc/self/exe cannot be read: rows are counted by single steps" in result.err
    assert set(files_in(tmp_path)) == {"counts.json"}


def test_instructions_without_threads(fails: Check) -> None:
    """Rows are prepared on a thread of their own."""
    fails("instructions", shim("threads"), "cannot be counted: .*Resource temporarily unavailable")


# Processors and memory that can do less.

def _one_processor() -> None:
    """The first that is allowed."""
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})


@pytest.mark.parametrize("name", ["run_grey_tiff", "batch", "facts"])
def test_one_processor(name: str, works: Callable[..., None]) -> None:
    """For several threads."""
    works(name, Fault("one processor", _one_processor))


def _without_executable_memory() -> None:
    """From now on mprotect() cannot make memory executable: a filter of system calls, see seccomp(2)."""
    load, equal, test, end = 0x20, 0x15, 0x45, 0x06
    program = b"".join(struct.pack("<HBBI", *step) for step in (
        (load, 0, 0, 0), (equal, 0, 3, 10), (load, 0, 0, 32), (test, 0, 1, 4), (end, 0, 0, 0x5000D),
        (end, 0, 0, 0x7FFF0000)))
    buffer = ctypes.create_string_buffer(program)
    header = ctypes.create_string_buffer(struct.pack("<HxxxxxxQ", len(program) // 8, ctypes.addressof(buffer)))
    prctl = ctypes.CDLL(None).prctl
    if prctl(38, 1, 0, 0, 0) != 0 or prctl(22, 2, header) != 0:  # no new privileges; filter
        raise OSError("no filter of system calls")


@pytest.mark.skipif(os.uname().machine != "x86_64", reason="machine code and numbers of calls are those of x86-64")
@pytest.mark.parametrize("name", ["rule", "rule_of_your_own", "batch", "verify"])
def test_no_executable_memory(name: str, inputs: Path, tmp_path: Path, expected: Callable[[str], Files]) -> None:
    """The interpreter does the work."""
    result = run(words_of(name, inputs), tmp_path, Fault("no executable memory", _without_executable_memory))
    assert made_by(name, result, tmp_path) == expected(name)


@pytest.mark.parametrize("name", ["run", "facts", "benchmarks"])
def test_unknown_processor(name: str, inputs: Path, tmp_path: Path) -> None:
    """A cap that does not exist is wrong usage."""
    fault = Fault("", environment={"THINBENCH_MAX_ISA": "avx3"})
    result = run(words_of(name, inputs), tmp_path, fault)
    result.assert_failed("avx3", status=2)
    assert files_in(tmp_path) == {}


# Standard streams that are not there.

@pytest.mark.parametrize("name", ["run", "run_grey_tiff", "run_pbm", "train"])
def test_closed_streams(name: str, inputs: Path, tmp_path: Path, expected: Callable[[str], Files]) -> None:
    """No text goes into a file that was opened in place of a stream."""
    result = run(words_of(name, inputs), tmp_path, Fault("closed", lambda: os.closerange(0, 3)))
    right = expected(name)
    made = without_times(files_in(tmp_path))
    assert made == {key: right[key] for key in made} and (made or result.status == 1), result


# Input that is not what it was.

@pytest.mark.parametrize("kind", ["png", "pgm", "bmp", "jpg", "pbm", "tif", "grey.tif"])
def test_truncated_input(kind: str, inputs: Path, tmp_path: Path) -> None:
    """At any length, and for any command."""
    data = (inputs / f"a.{kind}").read_bytes()
    sizes = (0, 1, 40, len(data) // 2, len(data) - 40)
    for size, command in [*itertools.product(sizes, READERS[:1]), *itertools.product(sizes[3:4], READERS[1:])]:
        (tmp_path / f"in.{kind}").write_bytes(data[:size])
        before = files_in(tmp_path)
        result = run(["thinbench", *command.format(f"in.{kind}").split()], tmp_path)
        result.assert_failed(f"cannot read 'in.{kind}': ")
        assert files_in(tmp_path) == before


TICK = 0.02
"""Seconds before a file is changed: more than a tick of any file system's clock, so that its times show it."""


@pytest.mark.parametrize("change", ["grows", "shrinks", "keeps its size", "is replaced"])
def test_change_while_it_is_read_is_seen(change: str, inputs: Path, tmp_path: Path) -> None:
    """For certain: the program waits in the middle of reading."""
    path = Path(shutil.copy(inputs / "large.pgm", tmp_path / "in.pgm"))
    process = start(["thinbench", "run", "thin_guo_hall", "in.pgm", "out.png"], tmp_path, shim("read"))
    wait_until(lambda: (tmp_path / "reading").exists())
    time.sleep(TICK)
    data = path.read_bytes()
    if change == "is replaced":
        (tmp_path / "new").write_bytes(data)
        (tmp_path / "new").rename(path)
    else:
        path.write_bytes({"grows": data + b"more", "shrinks": data[:999], "keeps its size": data[:-1] + b"\1"}[change])
    (tmp_path / "reading").unlink()
    finish(process).assert_failed("cannot read 'in.pgm': it changed while it was read")
    assert list(files_in(tmp_path)) == ["in.pgm"]


def wait_until(happened: Callable[[], bool]) -> None:
    """Or fail, where a program hangs."""
    for _ in range(60_000):
        if happened():
            return
        time.sleep(0.01)
    raise TimeoutError


# The study, on a run that was measured before.

STUDY = [str(ROOT / "study"), "--no-install"]


@pytest.fixture(name="measured")
def _measured(tmp_path: Path) -> Path:
    """A copy of one that is in the repository."""
    run_file = min((ROOT / "results").glob("*/*/run.json"))
    return Path(shutil.copytree(run_file.parent, tmp_path / "run"))


@pytest.mark.parametrize("fault, says", [
    (FULL_OUT, "standard output cannot be written"),
    (Fault("file size limit", limit(resource.RLIMIT_FSIZE, 1024)), "cannot be written: File too large"),
    (Fault("little memory", limit(resource.RLIMIT_AS, 60_000_000)), "cannot be loaded|not enough memory")], ids=str)
def test_study(fault: Fault, says: str, measured: Path, tmp_path: Path) -> None:
    """One line and nothing half-written; the page is whole before standard output fails."""
    before = files_in(tmp_path)
    result = run([*STUDY, "build", "run"], tmp_path, fault)
    result.assert_failed(f"^study: .*({says})")
    assert files_in(tmp_path) == before or fault is FULL_OUT
    if fault.name == "file size limit":  # takes seconds
        assert run([*STUDY, "build", "run"], tmp_path).status == 0
        assert (measured / "index.html").stat().st_size > 10_000
