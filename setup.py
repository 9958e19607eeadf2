"""Builds the shared library by CMake and puts it into the package."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

ROOT = Path(__file__).resolve().parent
ENDINGS = (".so", ".dylib", ".dll")


def version() -> str:
    return re.search(r"project\(thinbench VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildWithLibrary(build_py):
    """Also builds the shared library, with std::thread, so that it needs no other; by the cross compiler of
    CMAKE_TOOLCHAIN_FILE in the environment, if it is set."""

    def run(self) -> None:
        super().run()
        build = Path(self.get_finalized_command("build").build_temp).resolve()
        build /= Path(os.environ.get("CMAKE_TOOLCHAIN_FILE", "native")).stem
        options = ["PROGRAMS", "TESTS", "PYTHON"]
        self.call("cmake", "-S", str(ROOT), "-B", str(build), "-G", "Ninja",
                  "-DCMAKE_BUILD_TYPE=Release", "-DTHINBENCH_WITH_TBB=OFF",
                  *(f"-DTHINBENCH_BUILD_{option}=OFF" for option in options))
        self.call("cmake", "--build", str(build), "--target", "thinbench_shared")
        (library,) = (path for ending in ENDINGS for path in build.glob(f"*/libthinbench{ending}"))
        package = ROOT / "python" if self.editable_mode else Path(self.build_lib)
        for old in (package / "thinbench").glob("libthinbench.*"):
            old.unlink()
        self.copy_file(str(library.resolve()), str(package / "thinbench" / library.name))
        self.distribution.is_for_windows = library.suffix == ".dll"

    def call(self, *command: str) -> None:
        try:
            subprocess.run(command, check=True, stdout=sys.stderr)
        except FileNotFoundError:
            sys.exit("thinbench needs CMake 3.25, Ninja, a C++20 compiler and xsimd to build "
                     "(Debian: cmake ninja-build g++ libxsimd-dev)")
        except subprocess.CalledProcessError as error:
            sys.exit(f"{' '.join(command)} failed with status {error.returncode}")


class PlatformWheel(bdist_wheel):
    """For any Python 3: the library is loaded by ctypes."""

    def get_tag(self) -> tuple[str, str, str]:
        return ("py3", "none", "win_amd64" if self.distribution.is_for_windows else super().get_tag()[2])


class BinaryDistribution(Distribution):
    is_for_windows = False

    def has_ext_modules(self) -> bool:
        return True


setup(version=version(), distclass=BinaryDistribution,
      cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel})
