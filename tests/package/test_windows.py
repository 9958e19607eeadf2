"""The DLL and the wheel for Windows, as far as a cross compiler and wine show: ./check windows."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from conftest import ROOT, readme_block, released, reuse, run
from test_cmake_package import OUTPUT, write_example
from test_wheel import VERSION, copy_tree

WINE = ROOT / "tests" / "windows" / "wine"
TOOLCHAIN = ROOT / "cmake" / "windows.cmake"


@pytest.fixture(scope="module")
def dll(build: Path) -> Path:
    library = build / "bin" / "libthinbench.dll"
    if not library.exists():
        pytest.skip("a build for another system")
    return library


def objdump(*options: object) -> str:
    return run("x86_64-w64-mingw32-objdump", *options)


def test_dll_needs_only_the_system(dll):
    needed = re.findall(r"DLL Name: (\S+)", objdump("-p", dll))
    assert {name.lower() for name in needed} == {
        "kernel32.dll", "msvcrt.dll", "api-ms-win-core-synch-l1-2-0.dll"}  # the last: WaitOnAddress


def test_dll_exports_what_is_marked(dll):
    table = objdump("-p", dll).partition("[Ordinal/Name Pointer] Table")[2]
    names = re.findall(r"^\s*\[ *\d+\] (\S+)$", table, re.MULTILINE)
    declared = re.findall(r"\b(thinbench_\w+)\(", (ROOT / "kernels/include/thinbench.h").read_text())
    assert sorted(name for name in names if not name.startswith("_Z")) == sorted(set(declared))
    assert [name for name in names if name.startswith("_Z") and not re.match("_ZN?K?9thinbench", name)] == []


def test_no_vector_on_the_stack_is_taken_for_aligned(dll):
    """The stack of Windows is aligned to 16 bytes."""
    code = objdump("-d", "--no-show-raw-insn", dll)
    assert re.search(r"vmov\w*u\w*\s.*\(.*%ymm", code)
    aligned = r"vmov(?:dqa\w*|ap[sd])\s+(?:.*\(.*%[yz]mm|%[yz]mm\d+,.*\().*"
    assert re.findall(aligned, code) == []


def test_works_where_the_path_has_spaces_and_letters_of_other_scripts(dll, tmp_path):
    directory = tmp_path / "Büro 画像"
    directory.mkdir()
    shutil.copy(dll, directory)
    shutil.copy(dll.with_name("c_interface_test.exe"), directory)
    run(WINE, "c_interface_test.exe", cwd=directory)


@pytest.mark.parametrize("library", ["thinbench", "thinbench_shared"])
def test_installed_library_is_found_and_linked(dll, library, tmp_path):
    prefix = tmp_path / "prefix"
    run("cmake", "--install", dll.parents[1], "--prefix", prefix)
    cmake = readme_block("cmake", "find_package").replace("thinbench::thinbench", f"thinbench::{library}")
    write_example(tmp_path, cmake)
    run("cmake", "-G", "Ninja", "-B", "build", "--toolchain", TOOLCHAIN,
        f"-Dthinbench_DIR={prefix}/lib/cmake/thinbench", cwd=tmp_path)
    run("cmake", "--build", "build", cwd=tmp_path)
    dlls = "Z:" + str(prefix / "bin").replace("/", "\\")
    assert run(WINE, tmp_path / "build" / "example.exe", WINEPATH=dlls).splitlines()[0] == OUTPUT


@pytest.fixture(scope="module")
def wheel(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    if found := released("*win_amd64.whl"):
        return found[0]
    dll = request.getfixturevalue("dll")
    directory = tmp_path_factory.mktemp("wheel")
    copy_tree(directory / "thinbench")
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", directory, directory / "thinbench",
        CMAKE_TOOLCHAIN_FILE=str(TOOLCHAIN), **reuse(dll.parents[1]))
    (found,) = directory.glob("*.whl")
    return found


def test_wheel_holds_the_package_and_the_dll(wheel):
    assert wheel.name == f"thinbench-{VERSION}-py3-none-win_amd64.whl"
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if name.startswith("thinbench/")}
        library = archive.read("thinbench/libthinbench.dll")
    sources = {path.relative_to(ROOT / "python").as_posix() for path in (ROOT / "python" / "thinbench").rglob("*py*")
               if path.suffix in {".py", ".typed"}}
    assert names == sources | {"thinbench/libthinbench.dll"}
    assert library.startswith(b"MZ")


def test_package_loads_the_dll_that_the_wheel_holds(wheel, tmp_path):
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path)
    code = ("import ctypes, sys, numpy; sys.platform = 'win32'; "
            "ctypes.CDLL = lambda path: sys.exit(path); import thinbench")
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=False, capture_output=True, text=True)
    assert Path(done.stderr.strip()) == tmp_path / "thinbench" / "libthinbench.dll"
