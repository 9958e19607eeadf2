"""What a reader must know about a machine and a build to judge or to repeat measurements."""

from __future__ import annotations

import datetime
import json
import os
import platform
import subprocess
from pathlib import Path
from typing import Any

from report.errors import ReportError
from report.measure.benchmarks import Json

LSCPU = {"family": "CPU family:", "flags": "Flags:", "model": "Model:", "name": "Model name:", "stepping": "Stepping:",
         "vendor": "Vendor ID:"}
"""What lscpu calls the facts about a processor."""
VENDORS = {"GenuineIntel": "intel", "AuthenticAMD": "amd"}


def machine_facts(program: Path, commit: str) -> Json:
    """What the measurements depend on; of the build what thinbench_benchmarks tells."""
    done = subprocess.run([program, "--machine"], check=False, text=True, stdout=subprocess.PIPE)
    if done.returncode != 0:
        raise ReportError("the machine could not be described; see the line above")
    build: Json = json.loads(done.stdout)
    cpu = cpu_of(_lscpu())
    gib = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGESIZE") / 2**30
    facts = build | {
        "schema": 1, "fingerprint": fingerprint(cpu, build["compiler"]), "cpu": cpu, "cores": os.cpu_count() or 1,
        "caches": caches_of(_lscpu("--caches", "--bytes")), "memory_gib": round(gib, 1), "os": _system(),
        "kernel": f"{platform.system()} {platform.release()}",
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")}
    return dict(sorted(facts.items())) | {"commit": commit}


def fingerprint(cpu: Json, compiler: Json) -> str:
    """Equal for equal processors with equal flags and programs built by the same compiler with the same flags."""
    digest = 0x811C9DC5  # FNV-1a: short, and the same everywhere
    text = f"{' '.join(cpu['flags'])} {compiler['id']} {compiler['version']} {compiler['flags']}"
    for byte in text.encode():
        digest = (digest ^ byte) * 0x01000193 & 0xFFFFFFFF
    return f"{cpu['vendor']}-{cpu['family']}-{cpu['model']}-{cpu['stepping']}-{digest:08x}"


def cpu_of(lines: list[Json]) -> Json:
    """"unknown" where lscpu does not tell; family, model and stepping as numbers where they are."""
    found = {line["field"]: line["data"] for line in lines}
    cpu: Json = {name: found.get(field, "unknown") for name, field in LSCPU.items()}
    cpu["flags"] = sorted(found.get(LSCPU["flags"], "").split())
    cpu["vendor"] = VENDORS.get(cpu["vendor"], cpu["vendor"].lower())
    return cpu | {name: int(cpu[name]) for name in ("family", "model", "stepping") if cpu[name].isdecimal()}


def caches_of(lines: list[Json]) -> list[Json]:
    """Nearest first."""
    return [{"level": line["level"], "size_kib": int(line["one-size"]) // 1024, "type": line["type"]} for line in lines]


def _lscpu(*words: str) -> list[Any]:
    """Its list; none where it cannot be run or has nothing to say."""
    try:
        done = subprocess.run(["lscpu", "--json", *words], check=False, text=True, capture_output=True,
                              env=os.environ | {"LC_ALL": "C"})
        return [line for lines in json.loads(done.stdout).values() for line in lines]
    except (OSError, ValueError, AttributeError):
        return []


def _system() -> str:
    """The full name of the operating system."""
    try:
        return platform.freedesktop_os_release()["PRETTY_NAME"]
    except OSError:
        return "unknown"
