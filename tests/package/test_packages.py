"""Installation without a build is one line; Debian packages install, run and are removed without a trace."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from conftest import ROOT, released, run

PACKAGES = {"thinbench", "libthinbench-dev", "python3-thinbench"}


@pytest.fixture(scope="module")
def packages(build: Path, tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    if shutil.which("dpkg") is None or os.geteuid() != 0:
        pytest.skip("dpkg installs packages, and only for root")
    if found := released("*.deb"):
        return found
    directory = tmp_path_factory.mktemp("packages")
    run("cpack", "-G", "DEB", "-B", directory, cwd=build)
    return sorted(directory.glob("*.deb"))


def files_in(root: Path) -> set[str]:
    return {path.relative_to(root).as_posix() for path in root.rglob("*")
            if not path.is_dir() and "var/lib/dpkg" not in path.as_posix()}


def test_packages_install_run_and_are_removed_without_a_trace(packages, tmp_path):
    database = tmp_path / "var" / "lib" / "dpkg"
    for name in ("info", "updates", "triggers"):
        (database / name).mkdir(parents=True)
    (database / "status").touch()
    dpkg = ["dpkg", f"--root={tmp_path}", "--force-depends", "--force-bad-path", "--force-not-root",
            "--force-script-chrootless",
            f"--log={database}/log"]
    run(*dpkg, "--install", *packages)
    found = files_in(tmp_path)
    assert {"usr/bin/thinbench", "usr/share/man/man1/thinbench.1",
            "usr/share/bash-completion/completions/thinbench"} <= found
    assert any(name.endswith("thinbench.pc") for name in found)
    assert {f"usr/share/doc/{package}/copyright" for package in PACKAGES} <= found
    assert run(tmp_path / "usr/bin/thinbench", "--version").startswith("thinbench ")
    code = "import thinbench, numpy; print(thinbench.thin(numpy.ones((3, 9), bool)).sum(), thinbench.__file__)"
    said = run("/usr/bin/python3", "-B", "-c", code, PYTHONPATH=str(tmp_path / "usr/lib/python3/dist-packages"))
    assert said.startswith("7 ") and str(tmp_path) in said
    run(*dpkg, "--purge", *PACKAGES)
    assert files_in(tmp_path) == set()


def test_packages_say_what_they_are_and_need(packages):
    fields = [run("dpkg-deb", "--field", path, "Package", "Depends", "Description") for path in packages]
    names = {re.search("Package: (.*)", text)[1] for text in fields}
    assert names == PACKAGES
    assert all(re.search("Depends: .*libc6", text) for text in fields)
    development = next(path for path in packages if path.name.startswith("libthinbench-dev"))
    assert run("dpkg-deb", "--info", development, "shlibs") == "libthinbench 1 libthinbench-dev (>= 1.0.0)\n"


def installed_without(missing, component, build, directory):
    """`cmake --install` of a component, or of all, where a file was not built."""
    script = (build / "cmake_install.cmake").read_text()
    path = re.escape(missing) + r'(\.[0-9.]+)?"\)'
    assert re.search(path, script)
    (directory / "install.cmake").write_text(re.sub(path, 'missing")', script))
    chosen = [f"-DCMAKE_INSTALL_COMPONENT={component}"] if component else []
    return subprocess.run(["cmake", f"-DCMAKE_INSTALL_PREFIX={directory / 'prefix'}", *chosen, "-P",
                           directory / "install.cmake"], capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("missing", "component", "target"), [
    ("libthinbench.a", "", "thinbench"), ("libthinbench.so", "", "thinbench_shared"),
    ("bin/thinbench", "", "thinbench_program"), ("python/thinbench/libthinbench.so", "python", "thinbench_python")])
def test_installing_what_is_not_built_says_what_to_run_and_leaves_nothing(build, tmp_path, missing, component, target):
    failed = installed_without(missing, component, build, tmp_path)
    said = " ".join(failed.stderr.split())
    assert failed.returncode != 0
    assert f"{target} is not built; first run: cmake --build {build} --target {target}" in said
    assert not (tmp_path / "prefix").exists()


def test_a_component_needs_only_what_is_in_it(build, tmp_path):
    done = installed_without("libthinbench.a", "program", build, tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "prefix" / "bin" / "thinbench").exists()


def test_the_manual_page_has_every_command(build):
    page = (ROOT / "tools" / "manual" / "thinbench.1").read_text()
    help_text = run(build / "bin" / "thinbench", "--help")
    commands = dict(re.findall(r"^  ([a-z-]+) {2,}(\S.*)$", help_text[help_text.index("Subcommands:"):], re.MULTILINE))
    assert len(commands) > 10
    for name, what in commands.items():
        assert f".TP\n.B {name}\n{what}\n" in page


def test_the_completion_knows_commands_and_options(build):
    script = (f"PATH={build / 'bin'}:$PATH; source {ROOT}/tools/manual/thinbench.bash-completion; "
              "COMP_WORDS=(thinbench fil); COMP_CWORD=1; _thinbench; echo ${COMPREPLY[@]}; "
              "COMP_WORDS=(thinbench holes --chan); COMP_CWORD=2; _thinbench; echo ${COMPREPLY[@]}")
    assert run("bash", "-c", script).split() == ["fill-holes", "--channel"]
