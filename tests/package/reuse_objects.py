#!/usr/bin/env python3
"""A compiler launcher that copies objects of this build instead of compiling the same again.

Compiling the kernels takes minutes, so tests that build the library inside another project set
CMAKE_CXX_COMPILER_LAUNCHER to this file and THINBENCH_REUSED_BUILD to a build directory. A source is
the same if its path below kernels/ and its ISA are. Anything else is compiled.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import sys
from pathlib import Path


def key(command: str) -> tuple[str, str] | None:
    """The source below kernels/ and the ISA of a compilation."""
    source = re.search(r" -c \S*?kernels/(\S+)", command)
    isa = re.search(r"-DTHINBENCH_ISA=(\w+)", command)
    return (source.group(1), isa.group(1) if isa else "") if source else None


def objects(build: Path) -> dict[tuple[str, str], Path]:
    """The objects of a build."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        entry_key = key(entry["command"])
        output = re.search(r" -o (\S+)", entry["command"])
        if entry_key and output:
            found[entry_key] = Path(entry["directory"]) / output.group(1)
    return found


def main() -> None:
    command = sys.argv[1:]
    text = " " + " ".join(command)
    if "-x c++-header" in text or "cmake_pch.hxx.gch" in text:
        Path(command[command.index("-o") + 1]).touch()
        return
    target = key(text)
    known = objects(Path(os.environ["THINBENCH_REUSED_BUILD"]))
    if target and known.get(target, Path("none")).is_file():
        shutil.copyfile(known[target], command[command.index("-o") + 1])
        if "-MF" in command:
            Path(command[command.index("-MF") + 1]).write_text("")
        return
    os.execvp(command[0], command)


if __name__ == "__main__":
    main()
