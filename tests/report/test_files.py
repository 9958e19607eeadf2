"""Files that are written whole, and files that are read."""

from __future__ import annotations

import os
import platform
import resource
import subprocess
from pathlib import Path

import pytest

from report import files
from report.building import build, isas_in_use
from report.errors import ReportError
from report.files import check_directory, read_bytes, write_file
from report.git import commit_name

ROOT = Path(__file__).resolve().parents[2]


def test_symbolic_links_are_written_through(tmp_path: Path) -> None:
    (tmp_path / "b").mkdir()
    link = tmp_path / "link"
    link.symlink_to("b/a.json")
    for data in (b"new", b"newer"):  # the first makes the file
        write_file(link, data)
        assert (tmp_path / "b" / "a.json").read_bytes() == data
    assert link.is_symlink() and sorted(os.listdir(tmp_path / "b")) == ["a.json"]


def test_nothing_but_regular_files_is_replaced_or_read(tmp_path: Path) -> None:
    pipe = tmp_path / "a.json"
    os.mkfifo(pipe)
    with pytest.raises(ReportError, match="a.json: cannot be written: it is not a regular file"):
        write_file(pipe, b"new")
    with pytest.raises(ReportError, match="a.json: cannot be read: it is not a regular file"):
        read_bytes(pipe)
    assert pipe.is_fifo() and os.listdir(tmp_path) == ["a.json"]


@pytest.fixture(name="old")
def _old(tmp_path: Path) -> Path:
    """A file of two names."""
    path = tmp_path / "a.json"
    path.write_bytes(b"old")
    (tmp_path / "b.json").hardlink_to(path)
    return path


def test_replaced_files_keep_their_mode_and_their_other_names(tmp_path: Path, old: Path) -> None:
    path = tmp_path / "alone.json"
    path.write_bytes(b"old")
    path.chmod(0o600)
    write_file(path, b"new")
    assert path.stat().st_mode & 0o777 == 0o600
    write_file(old, b"newer")
    other = old.with_name("b.json")
    assert other.read_bytes() == b"newer" and other.samefile(old)


def write_on_full_disk(path: Path, data: bytes, most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Once the finished file is there, no file may grow beyond so many bytes."""
    replace, limits = files._replace, resource.getrlimit(resource.RLIMIT_FSIZE)

    def replace_with_limit(target: Path, finished: Path) -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, limits[1]))
        try:
            replace(target, finished)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    monkeypatch.setattr(files, "_replace", replace_with_limit)
    write_file(path, data)


def test_full_disk_keeps_an_old_file_of_two_names(old: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(ReportError, match="a.json: cannot be written: File too large$"):
        write_on_full_disk(old, bytes(100_000), 20_000, monkeypatch)
    assert old.read_bytes() == b"old" and sorted(os.listdir(old.parent)) == ["a.json", "b.json"]


def test_interrupt_while_a_file_of_two_names_is_overwritten_leaves_the_whole(
        old: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(*_: object) -> int:
        raise KeyboardInterrupt
    monkeypatch.setattr(os, "sendfile", interrupt)
    with pytest.raises(KeyboardInterrupt):
        write_file(old, b"new")
    assert old.with_name("a.json.whole").read_bytes() == b"new"
    assert sorted(os.listdir(old.parent)) == ["a.json", "a.json.whole", "b.json"]


def test_unwritable_tree_is_named_before_the_build_can_be_blamed(tmp_path: Path) -> None:
    (tmp_path / "build").write_text("in the way")
    with pytest.raises(ReportError, match="build/release' cannot be written: .*; the build needs a"):
        build("release", (), tmp_path)


PREPARE = """
import sys
import report.__main__, report.building, report.compare, report.many_images.command, report.study, report.sweeps.command, report.pages
def late(*_, **__):
    sys.exit("too late")
for module in (report.many_images.command, report.pages, report.study, report.sweeps.command):
    module.build = late
report.compare.load_run = late
sys.exit(report.__main__.main(sys.argv[1:]))
"""


@pytest.mark.parametrize(("command", "out", "why"), [
    *((command, "file", "Not a directory") for command in ("study", "sweeps", "pages", "many-images", "compare a b")),
    ("study", "file/a/b", "Not a directory"), ("study", "link", "No such file")])
def test_outputs_that_cannot_be_written_are_named_before_the_work(command: str, out: str, why: str,
                                                                  tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    (tmp_path / "link").symlink_to("absent")
    done = subprocess.run(["/usr/bin/python3", "-c", PREPARE, *command.split(), "--out", tmp_path / out], check=False,
                          text=True, capture_output=True, env=os.environ | {"PYTHONPATH": str(ROOT)})
    blamed = tmp_path / out.split("/", 1)[0]
    assert done.returncode == 1 and done.stderr.count("\n") == 1
    assert done.stderr.startswith(f"study: {blamed}: cannot be written: {why}")
    assert sorted(os.listdir(tmp_path)) == ["file", "link"]


def test_directories_that_can_be_written_are_not_made_yet(tmp_path: Path) -> None:
    check_directory(tmp_path / "a" / "b")
    assert os.listdir(tmp_path) == []


def test_missing_programs_are_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert commit_name() == "unknown"
    with pytest.raises(ReportError, match="there is no program 'cmake'; leave out --no-install, or install it"):
        build("release")


@pytest.mark.skipif(platform.machine() != "x86_64", reason="ISAs of x86-64")
def test_a_quick_study_compiles_what_the_machine_has(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("THINBENCH_MAX_ISA", raising=False)

    def isas(flags: str) -> list[str]:
        (tmp_path / "cpuinfo").write_text(f"model name : CPU\nflags : fpu {flags}\n")
        return isas_in_use(tmp_path / "cpuinfo")
    assert isas("avx2 avx512bw avx512_vbmi2") == ["baseline", "avx2", "avx512icl"]
    assert isas("avx2 avx512bw") == ["baseline", "avx2", "avx512"]
    assert isas("avx2") == ["baseline", "avx2"]
    assert isas("sse4_2") == [] == isas_in_use(tmp_path / "absent")
    monkeypatch.setenv("THINBENCH_MAX_ISA", "sse4.2")
    assert isas("avx2") == []


ENDING = """
import os, pathlib, runpy, signal, sys
import report.compare
def write_and_end(parser, options):
    try:
        os.kill(os.getpid(), getattr(signal, sys.argv[-1]))
    finally:
        print("removed")
report.compare.run_compare = write_and_end
runpy.run_module("report", run_name="__main__")
"""


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_signals_that_end_the_program_let_it_remove_unfinished_files(name: str) -> None:
    done = subprocess.run(["/usr/bin/python3", "-c", ENDING, "compare", name], check=False,
                          text=True, capture_output=True, env=os.environ | {"PYTHONPATH": str(ROOT)})
    assert (done.returncode, done.stdout) == (130, "removed\n")
    assert done.stderr == "study: interrupted\n"
