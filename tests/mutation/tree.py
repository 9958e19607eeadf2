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

ROOT = Path(__file__).resolve().parents[2]
ISAS = ("baseline", "avx2", "avx512icl")  # 128, 256 and 512 bits
ISAS_VARIABLE = "THINBENCH_MUTATION_ISAS"
OBJECT = re.compile(r"^kernels/(techniques/)?CMakeFiles/thinbench_(?:techniques_)?(\w+)\.dir/(.+)\.o$")

# In the copy other instruction sets are neither built nor available, and the variable says which are.
EDITS: tuple[tuple[str, str, str], ...] = (
    ("kernels/CMakeLists.txt", "set(thinbench_isas ${isas}", "set(thinbench_isas " + " ".join(ISAS)),
    ("kernels/CMakeLists.txt", '"-O3;', '"-O1;'),
    ("kernels/core/exported.hpp", "kIsas[i]>::kKernels",
     "(" + " || ".join(f"kIsas[i] == Isa::{isa}" for isa in ISAS) +
     ") ? kIsas[i] : Isa::baseline>::kKernels"),
    ("kernels/core/isa.cpp", "bool cpu_supports(Isa isa) {\n",
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
    """The copy is `directory`/tree, its build `directory`/build."""

    def __init__(self, directory: Path) -> None:
        self.sources, self.build = directory / "tree", directory / "build"
        self.kernels = self.sources / "kernels"
        self.objects: dict[str, list[str]] = {}  # by source or header, relative to the copy
        self.commands: dict[str, list[str]] = {}  # by object
        self.links: dict[str, list[str]] = {}  # by program
        self.inputs: dict[str, set[str]] = {}  # objects, by program

    def prepare(self, jobs: int, programs: Sequence[str]) -> None:
        """Copies and builds what is not yet built of these programs, and reads what depends on what."""
        self._copy()
        if not (self.build / "build.ninja").exists():
            _output(["cmake", "-S", str(self.sources), "-B", str(self.build), "-G", "Ninja", *FLAGS], ROOT)
        if subprocess.run(["ninja", f"-j{jobs}", "-C", str(self.build), *programs], check=False).returncode:
            raise TreeError(f"the unmutated copy cannot be built; run: ninja -C {self.build}")
        self._read_graph(programs)

    def _copy(self) -> None:
        tracked = _output(["git", "ls-files", "--", "CMakeLists.txt", "kernels", "reference", "bench", "tools", "tests",
                           "cmake", "python"], ROOT).splitlines()
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

    def _read_graph(self, programs: Sequence[str]) -> None:
        for entry in json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8")):
            command = shlex.split(entry["command"])
            self.commands[command[command.index("-o") + 1]] = command
        found = ""
        for line in _output(["ninja", "-t", "deps"], self.build).splitlines():
            if line and not line.startswith(" "):
                found = line.split(":")[0]
            elif line.strip().startswith(str(self.sources)) and found in self.commands:
                self.objects.setdefault(line.strip()[len(str(self.sources)) + 1:], []).append(found)
        for program in programs:
            link = _output(["ninja", "-t", "commands", "-s", f"bin/{program}"], self.build)
            self.links[program] = shlex.split(next(part for part in link.split("&&") if " -o " in part))
            inputs = _output(["ninja", "-t", "inputs", f"bin/{program}"], self.build).split("\n")
            self.inputs[program] = {name for name in inputs if name.endswith(".o")}

    def stage_of(self, name: str) -> int:
        """Objects of ISAs after the baseline form stages of their own."""
        match = OBJECT.match(name)
        return ISAS.index(match[2]) if match and match[2] in ISAS else 0

    def is_kernel(self, name: str) -> bool:
        """Not an object of a test or of what tests use."""
        return name.startswith("kernels/")

    def is_common(self, name: str) -> bool:
        """Not compiled for each ISA."""
        match = OBJECT.match(name)
        return match is None or match[2] not in ISAS

    def source_of(self, name: str) -> str:
        """The source of an object, relative to kernels/; empty if it is not there."""
        match = OBJECT.match(name)
        return (match[1] or "") + match[3] if match else ""

    def program(self, name: str) -> Path:
        """The unmutated program."""
        return self.build / "bin" / name


class Overlay:
    """A mutated file before the copy, and what is built with it. Includes name files from kernels/ on, so the
    compiler finds the mutated one first."""

    def __init__(self, tree: Tree, directory: Path) -> None:
        self.tree, self.directory, self.file = tree, directory, ""

    def mutate(self, file: str, text: str) -> None:
        """From now on this file of kernels/ has this text; all others are as in the copy."""
        shutil.rmtree(self.directory / "kernels", ignore_errors=True)
        path = self.directory / "kernels" / file
        path.parent.mkdir(parents=True)
        path.write_text(text, encoding="utf-8")
        self.file = file

    def compile(self, name: str) -> bool:
        """Whether the compiler accepts what the object is made of."""
        to = self.directory / name
        to.parent.mkdir(parents=True, exist_ok=True)
        command = list(self.tree.commands[name])
        command[command.index("-o") + 1] = str(to)
        own, mine = str(self.tree.kernels / self.file), str(self.directory / "kernels" / self.file)
        command = [mine if word == own else word for word in command]
        command[1:1] = [f"-I{self.directory}/kernels", f"-I{self.directory}/kernels/include"]
        run = subprocess.run(command, cwd=self.tree.build, capture_output=True, check=False, timeout=300)
        return run.returncode == 0

    def is_unchanged(self, name: str) -> bool:
        """Whether the mutant's object is the same, byte by byte."""
        return (self.tree.build / name).read_bytes() == (self.directory / name).read_bytes()

    def link(self, program: str, changed: Sequence[str]) -> bool:
        """Whether the program links with these objects. They come before the libraries, which have old ones."""
        own = {name: str(self.directory / name) for name in changed if name in self.tree.inputs[program]}
        command = list(self.tree.links[program])
        command[command.index("-o") + 1] = str(self.program(program))
        command.insert(1, "-fuse-ld=gold")  # three times as fast
        first = next(i for i, word in enumerate(command) if word.endswith(".o"))
        command[first:first] = [path for name, path in own.items() if name not in command]
        command = [own.get(word, word) for word in command]
        return subprocess.run(command, cwd=self.tree.build, capture_output=True, check=False).returncode == 0

    def program(self, name: str) -> Path:
        """The mutated program."""
        return self.directory / name


def environment(isas: Sequence[str]) -> dict[str, str]:
    """For programs that may use these ISAs, and stop at the first failure."""
    return {**os.environ, ISAS_VARIABLE: f" {' '.join(isas)} ", "GTEST_FAIL_FAST": "1"}
