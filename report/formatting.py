"""How numbers and names are written for people: one place, so that all outputs agree."""

from __future__ import annotations

from report.model import END_TO_END, Row

NOTHING = "\N{EN DASH}"


def microseconds(ns: float) -> str:
    """A time in microseconds with two decimals, so that a column of them lines up."""
    return f"{ns / 1e3:,.2f}"


def three_digits(value: float) -> str:
    """About three digits and never an exponent, such as 1.25, 38.1 or 4,120."""
    digits = 2 if value < 9.995 else 1 if value < 99.95 else 0
    return f"{value:,.{digits}f}"


def times(factor: float) -> str:
    """A speed-up, such as 38.1×."""
    return f"{three_digits(factor)}×"


def speedup_text(row: Row) -> str:
    """A speed-up with its interval where one was measured, such as 254× (251 to 258)."""
    if row.paired is None:
        return times(row.speedup)
    interval = f"{three_digits(row.paired.low)} to {three_digits(row.paired.high)}"
    doubt = ", inconclusive" if row.paired.is_inconclusive else ""
    return f"{times(row.speedup)} ({interval}{doubt})"


def percent(value: float | None) -> str:
    """A spread with one decimal, or a dash if one repetition gave none."""
    return NOTHING if value is None else f"{value:.1f} %"


def scope_label(scope: str) -> str:
    """The scope in words."""
    return "end to end" if scope == END_TO_END else scope.replace("_", " ")


def kibibytes(size_kib: int) -> str:
    """A memory size in the larger of KiB and MiB that keeps it readable."""
    return f"{size_kib} KiB" if size_kib < 1024 else f"{size_kib / 1024:.3g} MiB"


def duration(ns: float) -> str:
    """A time in prose with about three digits, such as 61.9 µs."""
    value, unit = _with_unit(ns)
    return f"{three_digits(value)} {unit}"


def round_duration(ns: float) -> str:
    """A time that is a round number, such as 20 ms on an axis."""
    value, unit = _with_unit(ns)
    return f"{value:g} {unit}"


def _with_unit(ns: float) -> tuple[float, str]:
    """The time in the largest unit of which it is at least one."""
    for unit, scale in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if ns >= 0.9999 * scale:
            return ns / scale, unit
    return ns, "ns"
