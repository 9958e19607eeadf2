"""Which rows run the same machine code in two builds, so that nothing need be measured."""

from __future__ import annotations

import hashlib
import re
import subprocess
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ISA_OBJECT = re.compile(r"/thinbench_(?:techniques_)?([a-z0-9_]+)\.dir/")
"""Where CMake puts what is compiled once for each ISA."""


def same_isas(before: Path, now: Path, isas: Sequence[str]) -> set[str]:
    """The ISAs, of these in rising order, whose rows run the same machine code. A row runs objects
    of its ISA, of lower ones, and those that are compiled once. None where a directory of programs
    is no longer part of its build."""
    objects = [_objects(programs) for programs in (before, now)]
    if not all(objects):
        return set()
    changed = {name for name in objects[0].keys() | objects[1].keys()
               if objects[0].get(name) != objects[1].get(name)}
    names = [isa.replace(".", "") for isa in isas]
    lowest = min((_index(name, names) for name in changed), default=len(isas))
    return set(isas[:lowest])


def _index(name: str, isas: list[str]) -> int:
    """Of the lowest ISA whose rows may run an object."""
    found = ISA_OBJECT.search(name)
    return isas.index(found[1]) if found and found[1] in isas else 0


def _objects(programs: Path) -> dict[str, str]:
    """Hashes of what the benchmarks were linked from: code, data and relocations of each object."""
    build = programs.parent
    done = subprocess.run(["ninja", "-C", str(build), "-t", "inputs", "bin/thinbench_benchmarks"],
                          check=False, text=True, capture_output=True)
    names = [line for line in done.stdout.splitlines() if line.endswith(".o")]
    if done.returncode != 0 or not all((build / name).exists() for name in names):
        return {}
    with tempfile.TemporaryDirectory() as directory, ThreadPoolExecutor() as pool:
        return dict(zip(names, pool.map(
            lambda item: _hash(build / item[1], Path(directory) / str(item[0])),
            enumerate(names))))


def _hash(file: Path, stripped: Path) -> str:
    subprocess.run(["objcopy", "--strip-debug", "--remove-section=.comment", str(file),
                    str(stripped)], check=True)
    return hashlib.sha256(stripped.read_bytes()).hexdigest()
