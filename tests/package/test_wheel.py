"""The Python package builds from a source archive, installs into a fresh environment and works."""

from __future__ import annotations

import re
import shutil
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from conftest import ROOT, released, reuse, run

FIRST_CALL = ("import numpy, thinbench; "
              "print(thinbench.thin(numpy.ones((3, 9), bool)).sum(), thinbench.__version__)")
VERSION = re.search(r"project\(thinbench VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


@pytest.fixture(scope="module")
def distributions(build: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An sdist, and a wheel built from it by `python3 -m build`."""
    if found := released("*.tar.gz"):
        return found[0].parent
    pytest.importorskip("build")
    directory = tmp_path_factory.mktemp("dist")
    source = tmp_path_factory.mktemp("source") / "thinbench"
    copy_tree(source)
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", directory, source,
        **reuse(build))
    return directory


def copy_tree(target: Path) -> None:
    """The sources without what builds and runs leave there; also where there is no repository."""
    left_out = shutil.ignore_patterns(".*", "build", "results", "__pycache__", "*.so")
    shutil.copytree(ROOT, target, ignore=left_out)


def install_and_call(wheel: Path, directory: Path) -> str:
    """The first call from a fresh environment that has the system's NumPy."""
    run(sys.executable, "-m", "venv", "--system-site-packages", directory / "venv")
    python = directory / "venv" / "bin" / "python"
    run(python, "-m", "pip", "install", "--no-deps", "--no-index", "--quiet", wheel)
    return run(python, "-c", FIRST_CALL, cwd=directory, PYTHONPATH="").strip()


def test_wheel_is_for_any_python_3_and_needs_only_system_libraries(distributions, tmp_path):
    (wheel,) = distributions.glob("*linux*.whl")
    assert wheel.name == f"thinbench-{VERSION}-py3-none-linux_x86_64.whl"
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        library = archive.extract("thinbench/libthinbench.so", tmp_path)
    assert {"thinbench/py.typed", "thinbench/compat/cv2.py"} <= set(names)
    needed = [line for line in run("readelf", "-d", library).splitlines() if "NEEDED" in line]
    assert not [line for line in needed if "tbb" in line]
    assert install_and_call(wheel, tmp_path) == f"7 {VERSION}"


def test_source_archive_holds_only_what_the_build_needs(distributions):
    (archive,) = distributions.glob("*.tar.gz")
    with tarfile.open(archive) as files:
        names = {member.name.split("/", 1)[1] for member in files if member.isfile()}
    directories = {name.split("/")[0] for name in names if "/" in name}
    # The objects are not compiled from the archive here, so their sources are compared instead.
    sources = {path.relative_to(ROOT).as_posix() for directory in ("kernels", "cmake")
               for path in (ROOT / directory).rglob("*") if path.is_file()}
    of_the_study = {name for name in sources if name.startswith("kernels/techniques/")}
    assert of_the_study and not of_the_study & names
    assert (sources - of_the_study) | {"CMakeLists.txt", "LICENSE"} <= names
    assert directories == {"cmake", "docs", "kernels", "python", "thinbench.egg-info"}


def test_pip_wheel_without_index_or_isolation(build, tmp_path):
    source = tmp_path / "thinbench"
    copy_tree(source)
    run(sys.executable, "-m", "pip", "wheel", ".", "--no-deps", "--no-index",
        "--no-build-isolation", "--wheel-dir", tmp_path, cwd=source, **reuse(build))
    (wheel,) = tmp_path.glob("*.whl")
    assert install_and_call(wheel, tmp_path) == f"7 {VERSION}"
