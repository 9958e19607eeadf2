"""README's example builds against an installation, by pkg-config and as part of another project."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from conftest import ROOT, code_block, readme_block, reuse, run

OUTPUT = readme_block("text", "iterations").strip()


@pytest.fixture(scope="module")
def prefix(build: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("prefix")
    run("cmake", "--install", build, "--prefix", directory)
    return directory


def write_example(directory: Path, cmake: str) -> None:
    (directory / "example.cpp").write_text(readme_block("cpp", "int main"))
    (directory / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.25)\nproject(example CXX)\n{cmake}")


def build_and_run(directory: Path, *options: object, **variables: str) -> str:
    run("cmake", "-G", "Ninja", "-B", "build", *options, cwd=directory, **variables)
    run("cmake", "--build", "build", cwd=directory, **variables)
    return run("build/example", cwd=directory).strip()


def test_readme_example_has_at_most_15_lines():
    lines = readme_block("cpp", "int main").splitlines()
    assert len([line for line in lines if line.strip()]) <= 15


@pytest.mark.parametrize("library", ["thinbench", "thinbench_shared"])
def test_find_package(prefix, library, tmp_path):
    cmake = readme_block("cmake", "find_package")
    write_example(tmp_path, cmake.replace("thinbench::thinbench", f"thinbench::{library}"))
    assert build_and_run(tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}") == OUTPUT


def test_find_package_rejects_another_minor_version(prefix, tmp_path):
    write_example(tmp_path, "find_package(thinbench 9.9 QUIET)\n"
                            "message(STATUS \"found: ${thinbench_FOUND}\")\n")
    text = run("cmake", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}", cwd=tmp_path)
    assert "found: 0" in text


def library_flags(prefix: Path, static: bool = False) -> tuple[list[str], str]:
    """Flags of the installed library, by pkg-config, and its directory."""
    (directory,) = prefix.rglob("pkgconfig")
    flags = run("pkg-config", *["--static"] * static, "--cflags", "--libs", "thinbench", PKG_CONFIG_PATH=str(directory))
    return flags.replace("-lthinbench", "-l:libthinbench.a" if static else "-lthinbench").split(), str(directory.parent)


@pytest.mark.parametrize("static", [False, True])
def test_pkg_config(prefix, tmp_path, static):
    write_example(tmp_path, "")
    flags, directory = library_flags(prefix, static)
    run("g++", "-std=c++20", "example.cpp", "-o", "example", *flags, cwd=tmp_path)
    variables = {} if static else {"LD_LIBRARY_PATH": directory}
    assert run(tmp_path / "example", **variables).strip() == OUTPUT
    done = subprocess.run(["g++", "-std=c++20", "-D_GLIBCXX_DEBUG", "example.cpp", "-o", "debug", *flags],
                          cwd=tmp_path, text=True, capture_output=True, check=False)
    assert done.returncode != 0
    assert "undefined reference to `thinbench::detail::kInterface1x0Debug'" in done.stderr


C_FLAGS = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]


def test_c_example_of_the_documentation(prefix, tmp_path):
    (tmp_path / "example.c").write_text(code_block("docs/library.md", "c", "int main"))
    flags, directory = library_flags(prefix)
    run("gcc", *C_FLAGS, "example.c", "-o", "example", *flags, cwd=tmp_path)
    skeleton = run(tmp_path / "example", LD_LIBRARY_PATH=directory)
    assert 5 <= skeleton.count("#") <= 14
    assert len(skeleton.splitlines()) == 12


def test_rule_examples_of_the_documentation(prefix, tmp_path):
    flags, directory = library_flags(prefix)
    head, body = code_block("docs/rules.md", "cpp", "make_window_table").split("using namespace thinbench;")
    (tmp_path / "example.cpp").write_text(f"""#include <cstdint>
{head}using namespace thinbench;
int main() {{
  constexpr int width = 4, height = 3;
  const std::uint8_t data[width * height] = {{1, 0, 1, 1, 0, 0, 1, 1}};
  std::uint8_t out[width * height];
  {body}
  return iterations == 2 && out[0] == 0 && out[2] == 255 && out[7] == 255 ? 0 : 1;
}}""")
    run("g++", "-std=c++20", *C_FLAGS[1:], "example.cpp", "-o", "example", *flags, cwd=tmp_path)
    run(tmp_path / "example", LD_LIBRARY_PATH=directory)
    main = """
int main(void) {
  uint8_t image[5][7] = {{0}};
  image[1][2] = 9;
  if (dilate(&image[0][0], 7, 5, 0) != THINBENCH_OK || image[1][3] != 0) return 1;
  return dilate(&image[0][0], 7, 5, 2) != THINBENCH_OK || image[3][4] != 255 || image[4][2] != 0;
}
"""
    (tmp_path / "dilate.c").write_text(code_block("docs/library.md", "c", "dilate") + main)
    run("gcc", *C_FLAGS, "dilate.c", "-o", "dilate", *flags, cwd=tmp_path)
    run(tmp_path / "dilate", LD_LIBRARY_PATH=directory)


def test_opencv_example_of_the_documentation(prefix, tmp_path):
    (tmp_path / "example.cpp").write_text(code_block("docs/library.md", "cpp", "opencv.hpp"))
    flags = run("pkg-config", "--cflags", "opencv4").split()
    run("g++", "-std=c++20", "-fsyntax-only", f"-I{prefix}/include", *flags, "example.cpp",
        cwd=tmp_path)


def test_add_subdirectory(build, tmp_path):
    """Without options: a subproject builds the library alone and forces nothing on its parent."""
    (tmp_path / "thinbench").symlink_to(ROOT)
    example = readme_block("cmake", "find_package").splitlines()
    write_example(tmp_path, "\n".join(["add_subdirectory(thinbench)", *example[1:]]) +
                  "\nget_property(tests DIRECTORY thinbench PROPERTY BUILDSYSTEM_TARGETS)\n"
                  "message(STATUS \"type '${CMAKE_BUILD_TYPE}' standard '${CMAKE_CXX_STANDARD}' "
                  "targets '${tests}'\")\n")
    assert build_and_run(tmp_path, **reuse(build)) == OUTPUT
    assert "type '' standard '' targets 'thinbench_flags'" in run("cmake", "build", cwd=tmp_path)


def test_library_without_tbb_is_found_with_headers_in_another_directory(build, tmp_path):
    options = [f"-DTHINBENCH_BUILD_{part}=OFF" for part in ("PROGRAMS", "TESTS", "PYTHON")]
    run("cmake", "-G", "Ninja", "-S", ROOT, "-B", tmp_path / "library", *options,
        "-DTHINBENCH_WITH_TBB=OFF", "-DCMAKE_INSTALL_INCLUDEDIR=include/other", **reuse(build))
    run("cmake", "--build", tmp_path / "library", **reuse(build))
    run("cmake", "--install", tmp_path / "library", "--prefix", tmp_path / "prefix")
    example = tmp_path / "example"
    example.mkdir()
    write_example(example, readme_block("cmake", "find_package"))
    assert build_and_run(example, f"-DCMAKE_PREFIX_PATH={tmp_path / 'prefix'}") == OUTPUT


def test_programs_without_tbb_are_rejected_in_one_line(tmp_path):
    done = subprocess.run(["cmake", "-S", ROOT, "-B", tmp_path, "-DTHINBENCH_WITH_TBB=OFF"],
                          capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert "THINBENCH_WITH_TBB" in done.stderr and "oneTBB" in done.stderr


def test_version_is_the_same_everywhere():
    project = re.search(r"project\(thinbench VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
    assert project
    assert f'kVersion = "{project.group(1)}"' in (ROOT / "kernels/include/thinbench/version.hpp").read_text()
    assert f"\nversion: {project.group(1)}\n" in (ROOT / "CITATION.cff").read_text()
    assert f'"thinbench {project.group(1)}"' in (ROOT / "tools/manual/thinbench.1").read_text().splitlines()[0]
    export = (ROOT / "kernels/include/thinbench/export.h").read_text()
    macros = re.findall(r"#define THINBENCH_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", export)
    assert ".".join(macros) == project.group(1)


def test_installed_headers_are_the_public_ones(prefix):
    found = {path.relative_to(prefix / "include").as_posix()
             for path in (prefix / "include").rglob("*") if path.is_file()}
    public = ROOT / "kernels" / "include"
    assert found == {path.relative_to(public).as_posix() for path in public.rglob("*.h*")}


def test_exported_symbols_are_the_recorded_ones(prefix):
    """THINBENCH_RECORD_SYMBOLS=1 records them again. Those of C are what the header declares and its test calls."""
    (library,) = [path for path in prefix.rglob("libthinbench.so.*") if not path.is_symlink()]
    text = run("nm", "-DC", "--defined-only", library)
    exported = sorted({line.split(" ", 2)[2] for line in text.splitlines()})
    declared = set(re.findall(r"\b(thinbench_\w+)\(", (ROOT / "kernels/include/thinbench.h").read_text()))
    calls = (ROOT / "tests/api/c_interface_test.c").read_text()
    assert [name for name in exported if name.startswith("thinbench_")] == sorted(declared)
    assert [name for name in declared if f"{name}(" not in calls] == []
    symbols = [name for name in exported if name not in declared]
    golden = Path(__file__).with_name("exported_symbols.txt")
    if "THINBENCH_RECORD_SYMBOLS" in os.environ:
        golden.write_text("\n".join(symbols) + "\n")
    assert symbols == golden.read_text().splitlines()
    assert not [name for name in symbols if not name.startswith(("thinbench", "THINBENCH"))]
