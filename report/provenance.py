"""Refuses runs whose files are not of one machine, one build, one commit and the same inputs."""

from __future__ import annotations

import hashlib
import lzma
from pathlib import Path

from report.errors import ReportError
from report.json_fields import Fields, read_object
from report.model import Input, Machine

SEAL = "files.json"
"""Fingerprint, commit, and the SHA-256 of every measured file of the run; written last."""

MEASURED = ("timings.json", "rows.json", "machine.json", "speedups.csv", "samples.jsonl",
            "limits.json", "experiments/*.json")
"""What a run measures; files packed by xz count as what is in them."""


def check_provenance(directory: Path, machine: Machine, timings: Fields,
                     inputs: tuple[Input, ...]) -> None:
    """Everything that the files say of where they come from must agree.

    Runs from before there were seals have none; what else they say is compared all the same.
    """
    context = _context(timings)
    _check_context(context, machine)
    _check_limits(directory, machine, inputs)
    if context.has("thinbench_fingerprint") or (directory / SEAL).exists():
        _check_seal(directory, machine)


def measured_files(directory: Path) -> dict[str, str]:
    """The SHA-256 of what is in each measured file, by its name without .xz."""
    found = {}
    for pattern in MEASURED:
        for path in sorted([*directory.glob(pattern), *directory.glob(f"{pattern}.xz")]):
            name = path.relative_to(directory).as_posix()
            found[name.removesuffix(".xz")] = _hash(path)
    return found


def _hash(path: Path) -> str:
    try:
        data = path.read_bytes()
        return hashlib.sha256(lzma.decompress(data) if path.suffix == ".xz" else data).hexdigest()
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error.strerror}") from None
    except (EOFError, lzma.LZMAError) as error:
        raise ReportError(f"{path}: not complete: {error}; run the benchmark again") from None


def _context(timings: Fields) -> Fields:
    return timings.child("context") if timings.has("context") else Fields({}, timings.where)


def _check_context(context: Fields, machine: Machine) -> None:
    for key, what, right in (("thinbench_fingerprint", "machine", machine.fingerprint),
                             ("thinbench_commit", "commit", machine.commit),
                             ("thinbench_build_type", "build", machine.compiler["build_type"])):
        if context.has(key):
            _must_agree(context.where, what, context.text(key), right)
    if context.has("caches") and machine.caches:
        sizes = [(item.count("level"), item.count("size") // 1024)
                 for item in context.children("caches") if item.data.get("type") != "Instruction"]
        _must_agree(context.where, "machine with caches", _cache_words(sorted(sizes)),
                    _cache_words([(cache.level, cache.size_kib) for cache in machine.caches]))


def _cache_words(sizes: list[tuple[int, int]]) -> str:
    return ", ".join(f"L{level} {size} KiB" for level, size in sizes)


def _must_agree(where: str, what: str, found: str, right: str) -> None:
    if found != right:
        raise ReportError(f"{where}: is of {what} '{found}', but machine.json of '{right}'; "
                          "all files must come from one run")


def _check_limits(directory: Path, machine: Machine, inputs: tuple[Input, ...]) -> None:
    path = directory / "limits.json"
    if not path.exists():
        return
    limits = read_object(path)
    if limits.has("build"):
        _check_build(limits.child("build").child("compiler"), machine)
    _check_levels(limits, machine)
    shape = limits.child("input")
    size = (shape.data.get("width"), shape.data.get("height"))
    for item in inputs:
        same = item.name == shape.data.get("name") and (item.width, item.height) == size
        if same and shape.has("hash") and shape.text("hash") != item.hash:
            raise ReportError(f"{shape.where}: hash of '{item.name}' is {shape.text('hash')}, but "
                              f"{item.hash} in rows.json; all files must come from one run")


def _check_build(compiler: Fields, machine: Machine) -> None:
    for key, right in machine.compiler.items():
        _must_agree(compiler.where, f"compiler {key}", str(compiler.data.get(key)), right)


def _check_levels(limits: Fields, machine: Machine) -> None:
    """Rows of instruction sets that the machine lacks were counted on another."""
    for row in limits.children("rows"):
        if row.text("isa") not in machine.isa_available:
            raise ReportError(f"{row.where}: isa is '{row.text('isa')}', but machine.json has "
                              f"{', '.join(machine.isa_available)}; all files must come from one run")


def _check_seal(directory: Path, machine: Machine) -> None:
    seal = read_object(directory / SEAL)
    seal.check_schema()
    _must_agree(seal.where, "machine", seal.text("fingerprint"), machine.fingerprint)
    _must_agree(seal.where, "commit", seal.text("commit"), machine.commit)
    files = seal.child("files")
    measured = measured_files(directory)
    for name in sorted(files.data.keys() | measured.keys()):
        if name not in measured:
            raise ReportError(f"{directory / name}: no such file, but {SEAL} lists it; "
                              "all files of a run are needed")
        if name not in files.data:
            raise ReportError(f"{directory / name}: not listed in {SEAL}; it is of another run")
        if files.text(name) != measured[name]:
            raise ReportError(f"{directory / name}: SHA-256 is {measured[name][:16]}..., but "
                              f"{files.text(name)[:16]}... in {SEAL}; it is of another run, or "
                              "was changed")
