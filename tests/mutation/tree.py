"""A copy of the sources, built for mutants: few instruction sets, little optimisation."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from families import programs

ROOT = Path(__file__).resolve().parents[2]
ISAS = ("baseline", "avx2", "avx512icl")  # 128, 256 and 512 bits
ISAS_VARIABLE = "THINBENCH_MUTATION_ISAS"
OBJECT = re.compile(r"^kernels/CMakeFiles/thinbench_(\w+)\.dir/(.+)\.o$")

# In the copy other instruction sets are neither built nor available, and the variable says which are.
EDITS: tuple[tuple[str, str, str], ...] = (
    ("kernels/CMakeLists.txt", "thinbench_isas baseline sse42 avx2 avx512 avx512icl",
     "thinbench_isas " + " ".join(ISAS)),
    ("kernels/CMakeLists.txt", '"-O3;', '"-O1;'),
    ("tests/CMakeLists.txt", "foreach(isa baseline sse42 avx2 avx512 avx512icl)", "foreach(isa ${thinbench_isas})"),
    ("kernels/dispatch/exported.hpp", "  static const Kernels kKernels;",
     "  [[gnu::weak]] static const Kernels kKernels;"),
    ("kernels/dispatch/exported.hpp", "  return *table.at(static_cast<std::size_t>(isa));\n",
     "  const Kernels* const built = table.at(static_cast<std::size_t>(isa));\n"
     "  return built != nullptr ? *built : Exported<Kernels, Isa::baseline>::kKernels;\n"),
    ("kernels/dispatch/isa.cpp", "bool cpu_supports(Isa isa) {\n",
     "bool cpu_supports(Isa isa) {\n"
     f'  const char* const only = std::getenv("{ISAS_VARIABLE}");\n'
     f'  const std::string built = only == nullptr ? " {" ".join(ISAS)} " : only;\n'
     '  if (built.find(" " + std::string(isa_name(isa)) + " ") == std::string::npos) return false;\n'))
FLAGS = ("-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER=g++", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
         "-DTHINBENCH_ISA_OPTIMISATION=-O1", "-DTHINBENCH_BUILD_PYTHON=OFF", "-DTHINBENCH_INSTALL=OFF")


class TreeError(Exception):
    """The copy cannot be made or built."""


def _output(command: Sequence[str], cwd: Path) -> str:
    run = subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise TreeError(f"{' '.join(command)} failed:\n{run.stdout[-2000:]}{run.stderr[-2000:]}")
    return run.stdout


class Tree:
    """The copy is `directory`/tree, its build `directory`/build, objects of mutants `directory`/mutant."""

    def __init__(self, directory: Path) -> None:
        self.sources, self.build = directory / "tree", directory / "build"
        self.kernels, self.mutant = self.sources / "kernels", directory / "mutant"
        self.objects: dict[str, list[str]] = {}  # by source or header, relative to the copy
        self.commands: dict[str, list[str]] = {}  # by object
        self.links: dict[str, list[str]] = {}  # by program
        self.inputs: dict[str, set[str]] = {}  # objects, by program

    def prepare(self, jobs: int) -> None:
        """Copies and builds what is not yet built, and reads what depends on what."""
        self._copy()
        if not (self.build / "build.ninja").exists():
            _output(["cmake", "-S", str(self.sources), "-B", str(self.build), "-G", "Ninja", *FLAGS], ROOT)
        if subprocess.run(["ninja", f"-j{jobs}", "-C", str(self.build), *programs()], check=False).returncode:
            raise TreeError(f"the unmutated copy cannot be built; run: ninja -C {self.build}")
        self._read_graph()

    def _copy(self) -> None:
        tracked = _output(["git", "ls-files", "--", "CMakeLists.txt", "kernels", "reference", "bench", "tests", "cmake",
                           "python"], ROOT).splitlines()
        for name in tracked:
            path = ROOT / name
            if not path.is_file():
                continue
            text = path.read_bytes()
            for file, before, after in EDITS:
                if file == name:
                    if before.encode() not in text:
                        raise TreeError(f"{name} does not contain '{before.strip()}', which the copy replaces; "
                                        "see EDITS in tests/mutation/tree.py")
                    text = text.replace(before.encode(), after.encode())
            copy = self.sources / name
            if not copy.exists() or copy.read_bytes() != text:
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes(text)
                shutil.copymode(path, copy)

    def _read_graph(self) -> None:
        for entry in json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8")):
            command = shlex.split(entry["command"])
            self.commands[command[command.index("-o") + 1]] = command
        found = ""
        for line in _output(["ninja", "-t", "deps"], self.build).splitlines():
            if line and not line.startswith(" "):
                found = line.split(":")[0]
            elif line.strip().startswith(str(self.sources)) and found in self.commands:
                self.objects.setdefault(line.strip()[len(str(self.sources)) + 1:], []).append(found)
        for program in programs():
            link = _output(["ninja", "-t", "commands", "-s", f"bin/{program}"], self.build)
            self.links[program] = shlex.split(next(part for part in link.split("&&") if " -o " in part))
            inputs = _output(["ninja", "-t", "inputs", f"bin/{program}"], self.build).split("\n")
            self.inputs[program] = {name for name in inputs if name.endswith(".o")}

    def stage_of(self, name: str) -> int:
        """Objects of ISAs after the baseline form stages of their own."""
        match = OBJECT.match(name)
        return ISAS.index(match[1]) if match and match[1] in ISAS else 0

    def compile(self, name: str) -> Path | None:
        """The object of the sources as they are now, or none if the compiler rejects them."""
        to = self.mutant / name
        to.parent.mkdir(parents=True, exist_ok=True)
        command = list(self.commands[name])
        command[command.index("-o") + 1] = str(to)
        run = subprocess.run(command, cwd=self.build, capture_output=True, check=False, timeout=300)
        return to if run.returncode == 0 else None

    def is_unchanged(self, name: str) -> bool:
        """Whether the mutant's object is the same, byte by byte."""
        return (self.build / name).read_bytes() == (self.mutant / name).read_bytes()

    def link(self, program: str, changed: Sequence[str]) -> Path | None:
        """The program with these objects replaced; they come before the libraries, which have old ones."""
        to = self.mutant / program
        command = list(self.links[program])
        command[command.index("-o") + 1] = str(to)
        command = [str(self.mutant / word) if word in changed else word for word in command]
        first = next(i for i, word in enumerate(command) if word.endswith(".o"))
        for name in changed:
            if str(self.mutant / name) not in command and name in self.inputs[program]:
                command.insert(first, str(self.mutant / name))
        run = subprocess.run(command, cwd=self.build, capture_output=True, check=False)
        return to if run.returncode == 0 else None

    def program(self, name: str) -> Path:
        """The unmutated program."""
        return self.build / "bin" / name


def environment(isas: Sequence[str]) -> dict[str, str]:
    """For programs that may use these ISAs, and stop at the first failure."""
    return {**os.environ, ISAS_VARIABLE: f" {' '.join(isas)} ", "GTEST_FAIL_FAST": "1"}
