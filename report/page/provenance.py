"""Where the numbers come from: machine, build, controls, inputs, peers."""

from __future__ import annotations

from report.formatting import three_digits
from report.measure.run import Run
from report.measure.benchmarks import Json


def provenance(run: Run) -> list[tuple[str, str]]:
    """Terms and what they stand for; skipped rows are listed elsewhere."""
    machine, facts = run.machine, run.facts
    compiler, state = machine["compiler"], facts["state"]
    found = [
        ("Run", facts["run"]), ("Measured", str(machine["date"])), ("Commit", machine["commit"]),
        ("Processor", _processor(machine["cpu"])), ("Cores", str(machine["cores"])),
        ("Caches", ", ".join(map(_cache, machine["caches"]))),
        ("Memory", f"{machine['memory_gib']} GiB" if "memory_gib" in machine else ""),
        ("System", ", ".join(machine[key] for key in ("os", "kernel") if machine.get(key))),
        ("Instruction sets", ", ".join(machine["isa_available"])),
        ("Compiler", f"{compiler['id']} {compiler['version']}, {compiler['flags']}"),
        ("Libraries", ", ".join(f"{name} {text}" for name, text in machine["libraries"].items())),
        ("Options", ", ".join(filter(None, map(_option, facts["options"].items())))),
        ("Controls", _controls(facts["controls"])),
        ("Clock", f"times are those at a clock cycle of {state['cycle_ns']:.3f} ns"),
        ("State", f"{100 * state['quiet']:.0f} % of the moments were quiet" if "quiet" in state else "")]
    found += [(f"Input {item['name']}", _input(item)) for item in facts["inputs"]]
    found += [(f"Peer {item['technique']}",
               item["about"] + (" (equal output)" if item["equal_output"] else ""))
              for item in facts["peers"]]
    return [(term, text) for term, text in found if text]


def skipped(run: Run) -> list[tuple[str, list[str]]]:
    """Rows that were not measured, by reason."""
    by_reason: dict[str, list[str]] = {}
    for item in run.facts["skipped"]:
        by_reason.setdefault(item["reason"], []).append(item["row"])
    return sorted(by_reason.items())


def _option(item: tuple[str, object]) -> str:
    name, value = item
    if name == "peers":
        return "" if value else "without peers"
    if isinstance(value, bool):
        return name if value else ""
    return f"{name} {value}" if value not in ("", [], None) else ""


def _processor(cpu: Json) -> str:
    return (f"{cpu['name']} ({cpu['vendor']}, family {cpu['family']}, model {cpu['model']}, "
            f"stepping {cpu['stepping']})")


def _cache(cache: Json) -> str:
    size = cache["size_kib"]
    return (f"L{cache['level']} {cache['type'].lower()} " +
            (f"{size} KiB" if size < 1024 else f"{size / 1024:g} MiB"))


def _controls(controls: Json) -> str:
    if not controls["same"]:
        return "none"
    return (f"medians over {controls['groups']} cases: a row against itself {controls['same']:.4f}, "
            f"the same row with a delay of a tenth {controls['slowed']:.4f}; {controls['failed']} cases failed")


def _input(item: Json) -> str:
    share = 100 * item["foreground_pixels"] / (item["width"] * item["height"])
    return (f"{item['width']} × {item['height']} pixels, {three_digits(share)} % foreground, hash "
            f"{item['hash']}, in grey {item['grey_hash']}")
