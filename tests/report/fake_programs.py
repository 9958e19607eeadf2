"""Stands in for the programs of a build: facts and samples with known times, at once.

Run as `fake_programs.py NAME COMPILER ...`; the environment's FAKE_SLOWDOWN
multiplies all times."""

from __future__ import annotations

import json
import os
import random
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Json = dict[str, Any]

TIMES = {"reference": 1e6, "bitpacked": 5e4, "simd_bitpacked": 1e4, "leptonica_4": 8e4,
         "leptonica_8": 4e4, "copy": 2e3}
"""Nanoseconds of a call. leptonica_8 and copy compute something else."""

EQUAL_PEER, OTHER_PEERS = "leptonica_4", ("leptonica_8", "copy")

MACHINE: Json = {
    "schema": 1, "fingerprint": "intel-6-143-8-1a2b3c4d",
    "cpu": {"vendor": "intel", "family": 6, "model": 143, "stepping": 8, "name": "Fake <CPU>",
            "flags": ["avx2", "sse4_2"]},
    "cores": 2, "caches": [{"level": 1, "type": "Data", "size_kib": 48}], "memory_gib": 23,
    "kernel": "Linux 6.1.0", "os": "Debian 12",
    "compiler": {"id": "GNU", "version": "12.2.0", "flags": "-O3", "build_type": "Release"},
    "libraries": {"xsimd": "8.1.0"}, "commit": "abc1234", "date": "2026-11-21T00:10:00Z",
    "isa_available": ["baseline", "avx2"], "isa_cap": None,
}


PROBE, CYCLE = 6000.0, 0.25
"""Nanoseconds."""

REPETITIONS = 8


def make_facts(inputs: tuple[str, ...] = ("scene",), pixels: str = "0" * 16) -> Json:
    """One case on each input."""
    facts: Json = {
        "sources": {"pictures": [], "drawn": list(inputs), "foreground": "auto", "threshold": None},
        "rows": {}, "skipped": [], "verified": 5 * len(inputs), "mismatches": [],
        "inputs": [{"name": name, "width": _side(name), "height": 50, "hash": pixels,
                    "grey_hash": pixels, "foreground_pixels": 9} for name in inputs],
        "peers": [{"technique": name, "about": name, "equal_output": name == EQUAL_PEER}
                  for name in (EQUAL_PEER, *OTHER_PEERS)]}
    for name in inputs:
        facts["rows"] |= {f"thin_guo_hall/{technique}/{_isa(technique)}/1/end_to_end/{name}": _row(technique, name)
                          for technique in TIMES}
    return facts


def _side(name: str) -> int:
    return int(name.split("_")[1]) if name.startswith("square_") else 64


def _isa(technique: str) -> str:
    return "avx2" if technique.startswith("simd") else "baseline"


def _row(technique: str, name: str) -> Json:
    return {"case": "thin_guo_hall", "operation": "thin_guo_hall", "border": "background",
            "max_iterations": None, "technique": technique, "isa": _isa(technique), "threads": 1,
            "scope": "end_to_end", "input": name, "iterations": 7,
            "peer": technique in (EQUAL_PEER, *OTHER_PEERS),
            "default": technique == "simd_bitpacked", "scalar": technique == "bitpacked",
            "seconds": 1e-9 * TIMES[technique], "hash": "0" * 16}


@dataclass(frozen=True)
class Noise:
    """What a machine adds to the known times of a process."""

    spread: float = 0.005  # of quiet repetitions
    busy: float = 0.0  # share of repetitions beside a neighbour, which take half as long again
    slowed: float = 1.1
    same: float = 1.0
    clock: float = 1.0  # how many times as long a cycle is


def lines_of(facts: Json, dice: random.Random, noise: Noise = Noise()) -> Iterator[tuple[str, float, float, float]]:
    """Row, ns of a call and both probes, for each repetition. A quiet call takes its known time at least."""
    slowdown = float(os.environ.get("FAKE_SLOWDOWN", "1"))
    for name, row in facts["rows"].items():
        controls = (("/again", noise.same), ("/slowed", noise.slowed)) if row["technique"] == "bitpacked" else ()
        for suffix, factor in (("", 1.0), *controls):
            for _ in range(REPETITIONS):
                neighbour = 1.5 if dice.random() < noise.busy else 1.0
                ns = noise.clock * neighbour * slowdown * factor * TIMES[row["technique"]]
                probe = noise.clock * neighbour * PROBE
                yield name + suffix, ns * (1 + noise.spread * dice.random()), probe, probe * (1 + 0.001 * dice.random())


def _benchmarks(compiler: str, words: list[str]) -> int:
    if "--machine" in words:
        build = {name: MACHINE[name] for name in ("compiler", "libraries", "isa_available", "isa_cap")}
        print(json.dumps(build | {"compiler": MACHINE["compiler"] | {"id": compiler}}))
        return 0
    given = dict(zip(words, words[1:]))
    if "--facts" in given:
        inputs = [Path(word).stem for before, word in zip(words, words[1:]) if before in ("--input", "--image")]
        Path(given["--facts"]).write_text(json.dumps(make_facts(tuple(inputs) or ("scene",))))
        return 2 if "broken" in inputs else 0
    facts = json.loads(Path(given["--known"]).read_text())
    with open(given["--samples"], "w", encoding="utf-8") as stream:
        stream.write("row,repetition,calls,wall_ns,cpu_ns,probe_before_ns,probe_after_ns,cycle_ns\n")
        for row, ns, before, after in lines_of(facts, random.Random(1)):
            stream.write(f"{row},0,10,{2 * ns},{ns},{before},{after},{CYCLE}\n")
    return 0


def install(directory: Path, compiler: str = "GNU") -> Path:
    """Makes the programs of a build."""
    directory.mkdir(parents=True, exist_ok=True)
    for name in ("thinbench-study", "thinbench_benchmarks"):
        program = directory / name
        program.write_text("#!/bin/sh\nexec /usr/bin/python3 "
                           f'"{__file__}" {name} {compiler} "$@"\n')
        program.chmod(0o755)
    return directory


if __name__ == "__main__":
    sys.exit(_benchmarks(sys.argv[2], sys.argv[3:]))
