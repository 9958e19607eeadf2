"""Reads machine.json: what a reader needs to judge or repeat a run."""

from __future__ import annotations

from report.errors import ReportError
from report.json_fields import Fields
from report.model import Cache, Machine
from report.run_options import load_run_options

COMPILER_FIELDS = ("id", "version", "flags", "build_type")
LABELS = {"Cores": "cores", "Memory, GiB": "memory_gib", "Operating system": "os",
          "Kernel": "kernel", "Date": "date", "Instruction set capped at": "isa_cap"}
NEEDED = ("cores", "os", "kernel", "date")
"""Facts that every run must give; "unknown" is an answer."""


def load_machine(fields: Fields) -> Machine:
    """The machine, compiler and commit of a run; what identifies them must be there."""
    fields.check_schema()
    cpu = fields.child("cpu")
    compiler = fields.child("compiler")
    return Machine(
        fingerprint=fields.text("fingerprint"), commit=fields.text("commit"),
        compiler={key: _plain(compiler, key) for key in COMPILER_FIELDS},
        libraries=_libraries(fields.child("libraries")),
        cpu_name=cpu.text("name"),
        cpu_flags=_texts(cpu, "flags"),
        caches=_caches(fields),
        isa_available=_levels(fields),
        facts=_facts(fields, cpu),
        run=load_run_options(fields.child("options")))


def run_warnings(timings: Fields) -> tuple[str, ...]:
    """What Google Benchmark noticed about the run that makes its numbers doubtful."""
    context = timings.data.get("context")
    if not isinstance(context, dict):
        return ()
    # library_build_type is not read: Debian's package always says "debug", whatever it is.
    found = []
    if context.get("cpu_scaling_enabled") is True:
        found.append("The processor's clock was free to change during the run (CPU scaling).")
    if context.get("thinbench_build_type", "Release") != "Release":
        found.append(f"This was a {context['thinbench_build_type']} build: its times mean little.")
    return tuple(found)


def _plain(fields: Fields, key: str) -> str:
    """A string that may be empty, as compiler flags may be, but not absent."""
    value = fields.data.get(key)
    if not isinstance(value, str):
        raise ReportError(f"{fields.where}: {key} is {value!r}; it must be a string")
    return value


def _libraries(fields: Fields) -> dict[str, str]:
    if not fields.data:
        raise ReportError(f"{fields.where}: names no library; it must give each one's version")
    return {name: "absent" if version is None else str(version)
            for name, version in sorted(fields.data.items())}


def _texts(fields: Fields, key: str) -> tuple[str, ...]:
    return tuple(map(str, fields.listed(key)))


def _levels(fields: Fields) -> tuple[str, ...]:
    levels = _texts(fields, "isa_available")
    if not levels:
        raise ReportError(f"{fields.where}: isa_available is []; it must name an instruction set")
    return levels


def _caches(fields: Fields) -> tuple[Cache, ...]:
    data = [item for item in fields.children("caches") if item.data.get("type") != "Instruction"]
    return tuple(sorted((Cache(item.count("level", 1), item.count("size_kib", 1))
                         for item in data), key=lambda cache: cache.level))


def _facts(fields: Fields, cpu: Fields) -> dict[str, str]:
    """Further facts, each under the label that the page prints."""
    model = "-".join(str(cpu.data[key]) for key in ("vendor", "family", "model", "stepping")
                     if cpu.has(key))
    for key in NEEDED:
        fields.required(key)
    given = {label: str(fields.data[key]) for label, key in LABELS.items() if fields.has(key)}
    return ({"Vendor, family, model, stepping": model} if model else {}) | given
