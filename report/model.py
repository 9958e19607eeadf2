"""The clock cycles that a model of the processor takes for the code of a result: llvm-mca's."""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

from report.files import read_json, to_json, write_file

PROGRAM = "llvm-mca-19"
"""Of the package llvm-19, in which no other version's program has this name."""

MODELLED = frozenset({
    "sandybridge", "ivybridge", "haswell", "broadwell", "skylake", "skylake-avx512", "cascadelake",
    "cooperlake", "icelake-client", "icelake-server", "tigerlake", "rocketlake", "sapphirerapids",
    "emeraldrapids", "znver1", "znver2", "znver3", "znver4"})
"""Processors that LLVM 19 has a model of. For others it takes that of another one without saying
so: for znver5 that of Zen 4, which is narrower (docs/measuring.md)."""

SLOT = 32
"""An instruction has up to 15 bytes; what follows its own is decoded too, and ends before 30."""


def add_model(path: Path) -> None:
    """Replaces the code in limits.json by the cycles that it takes in the model. Adds which model,
    or why there is none."""
    data = read_json(path)
    codes = [row.pop("code") for row in data["rows"]]
    cpu = processor()
    why_not = why_no_model(cpu)
    data["model"] = f"none: {why_not}" if why_not else f"llvm-mca 19, {cpu}"
    for row, code in zip(data["rows"], codes if not why_not else []):
        cycles = model_cycles(assembly(code), cpu)
        row.update({} if cycles is None else {"model_cycles": cycles})
    write_file(path, to_json(data))


def why_no_model(cpu: str) -> str:
    """Empty where there is one."""
    if not cpu:
        return f"{PROGRAM} is not installed (package llvm-19)"
    return "" if cpu in MODELLED else f"LLVM 19 has no model of this processor ({cpu})"


def processor() -> str:
    """LLVM's name of this machine's; empty without llvm-mca."""
    found = re.search(r"Host CPU: (\S+)", _output(PROGRAM, "--version"))
    return found[1] if found else ""


def assembly(code: dict[str, str]) -> str:
    """The instructions of a call in the order of execution."""
    slots = [bytes.fromhex(text).ljust(SLOT, b"\x90") for text in code["instructions"].split()]
    with tempfile.NamedTemporaryFile() as file:
        file.write(b"".join(slots))
        file.flush()
        listing = _output("objdump", "-D", "-b", "binary", "-m", "i386:x86-64",
                          "--no-show-raw-insn", file.name)
    places = re.findall(r"^ *([0-9a-f]+):\t([^#\n]*)", listing, flags=re.MULTILINE)
    lines = {int(place, 16): _followed(text.strip()) for place, text in places}
    return "\n".join(lines[SLOT * number] for number in _numbers(code["order"]))


def model_cycles(text: str, cpu: str) -> int | None:
    """Of all instructions, one after another; None where the model lacks one of them."""
    report = _output(PROGRAM, "-mtriple=x86_64", f"-mcpu={cpu}", "-iterations=1",
                     "-resource-pressure=0", "-instruction-info=0", text=text)
    found = re.search(r"^Total Cycles: +(\d+)", report, flags=re.MULTILINE)
    return int(found[1]) if found else None


def _followed(line: str) -> str:
    """llvm-mca assumes 100 cycles for a call, but what is called is here: so a call is a jump that
    stores where to return."""
    return "push $0\njmp 0" if line.startswith("call") else line


def _numbers(order: str) -> Iterator[int]:
    for first, last, count in re.findall(r"(\d+)-(\d+)\*(\d+)", order):
        for _ in range(int(count)):
            yield from range(int(first), int(last) + 1)


def _output(*words: str, text: str = "") -> str:
    """Empty where the program is missing or fails."""
    try:
        done = subprocess.run(words, input=text, capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return done.stdout if done.returncode == 0 else ""
