"""Nothing that lasts or is compared is measured by the system's clock, which may jump."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SYSTEM_CLOCK = re.compile(r"\b(?:system_clock|CLOCK_REALTIME|gettimeofday|datetime\.now|last_write_time|"
                          r"st_mtime?|std::time)\b|\btime\.time\(")
# When a run took place; whether a file was changed, for which times need only differ.
DATES = {"bench/machine/machine.cpp", "report/measure/command.py", "tools/support/file_bytes.cpp"}


def test_only_dates_come_from_the_system_clock() -> None:
    files = [path for directory in ("kernels", "tools", "bench", "report", "python")
             for path in (ROOT / directory).rglob("*") if path.suffix in {".cpp", ".hpp", ".py"}]
    assert {path.relative_to(ROOT).as_posix() for path in files
            if SYSTEM_CLOCK.search(path.read_text(encoding="utf-8"))} == DATES
