"""Stands in for the programs of a build: plans and samples with known times, at once.

Run as `fake_programs.py thinbench|thinbench_sampler COMPILER ...`; the environment's FAKE_SLOWDOWN
multiplies all times."""

from __future__ import annotations

import json
import os
import random
import sys
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
    "options": {}, "isa_available": ["baseline", "avx2"], "isa_cap": None,
}


def make_plan(inputs: tuple[str, ...] = ("scene",), pixels: str = "0" * 16) -> Json:
    """One case on each input."""
    plan: Json = {
        "sources": {"pictures": [], "drawn": list(inputs), "foreground": "auto",
                    "threshold": None}, "cycle_ns": 0.25,
        "groups": [], "rows": {}, "skipped": [], "verified": 5 * len(inputs), "mismatches": [],
        "inputs": [{"name": name, "width": _side(name), "height": 50, "hash": pixels,
                    "grey_hash": pixels, "foreground_pixels": 9} for name in inputs],
        "peers": [{"technique": name, "about": name, "equal_output": name == EQUAL_PEER}
                  for name in (EQUAL_PEER, *OTHER_PEERS)]}
    for name in inputs:
        rows = {f"thin_guo_hall/{technique}/{_isa(technique)}/1/end_to_end/{name}":
                _row(technique, name) for technique in TIMES}
        plan["rows"] |= rows
        plan["groups"].append({"entries": _entries(list(rows)), "layouts": 2})
    return plan


def _side(name: str) -> int:
    return int(name.split("_")[1]) if name.startswith("square_") else 64


def _isa(technique: str) -> str:
    return "avx2" if technique.startswith("simd") else "baseline"


def _row(technique: str, name: str) -> Json:
    return {"case": "thin_guo_hall", "operation": "thin_guo_hall", "border": "background",
            "max_iterations": None, "technique": technique, "isa": _isa(technique), "threads": 1,
            "scope": "end_to_end", "input": name, "counter": 7, "plan_bytes": None,
            "peer": technique in (EQUAL_PEER, *OTHER_PEERS),
            "default": technique == "simd_bitpacked", "scalar": technique == "bitpacked"}


def _entries(names: list[str]) -> list[Json]:
    common = {"calls": 10, "delay_ns": 0, "warm_up": 1, "visits": 3, "threaded": False,
              "seconds": 0.01, "hash": "0" * 16}
    control = names[list(TIMES).index("bitpacked")]
    return [*({"name": name, "role": "row"} | common for name in names),
            {"name": control, "role": "same"} | common,
            {"name": control, "role": "slowed"} | common | {"delay_ns": 5e3}]


def make_group(group: Json, dice: random.Random, spread: float, slowed: float = 1.1,
               same: float = 1.0) -> list[list[list[float]]]:
    """What a process finds in a group: no epoch is shorter than the true time, and some process
    has one that is hardly longer."""
    slowdown = float(os.environ.get("FAKE_SLOWDOWN", "1"))
    found = []
    for entry in group["entries"]:
        factor = {"row": 1.0, "same": same, "slowed": slowed}[entry["role"]]
        time = slowdown * TIMES[entry["name"].split("/")[1]] * factor
        found.append([[time * (1 + spread * dice.random()) for _ in range(3)]
                      for _ in range(group["layouts"])])
    return found


def _sampler(words: list[str]) -> int:
    if words[0] == "plan":
        inputs = [Path(word).stem for before, word in zip(words, words[1:]) if before in ("--input", "--image")]
        print(json.dumps(make_plan(tuple(inputs) or ("scene",))))
        return 2 if "broken" in inputs else 0
    plan = json.load(sys.stdin)
    assert plan["cycle_ns"] > 0
    dice = random.Random(int(words[-1]))
    state = json.dumps({"chain_ns": 0.3})
    print(state)
    for index, group in reversed(list(enumerate(plan["groups"]))):
        for times in zip(*make_group(group, dice, 0.005)):  # by layout
            print(json.dumps({"group": index, "entries": times}), flush=True)
    print(state)
    return 0


def install(directory: Path, compiler: str = "GNU") -> Path:
    """Makes the programs of a build."""
    directory.mkdir(parents=True, exist_ok=True)
    for name in ("thinbench-study", "thinbench_sampler"):
        program = directory / name
        program.write_text("#!/bin/sh\nexec /usr/bin/python3 "
                           f'"{__file__}" {name} {compiler} "$@"\n')
        program.chmod(0o755)
    return directory


def machine_of(compiler: str) -> Json:
    """Each compiler makes another fingerprint."""
    return MACHINE | {"fingerprint": f"intel-6-143-8-{len(compiler):08x}",
                      "compiler": MACHINE["compiler"] | {"id": compiler}}


if __name__ == "__main__":
    if sys.argv[1] == "thinbench_sampler":
        sys.exit(_sampler(sys.argv[3:]))
    print(json.dumps(machine_of(sys.argv[2])))
