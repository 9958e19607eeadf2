"""Nothing that lasts or is compared is measured by the system's clock, which may jump."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SYSTEM_CLOCK = re.compile(r"\b(?:system_clock|CLOCK_REALTIME|gettimeofday|datetime\.now|last_write_time|"
                          r"st_mtime?|std::time)\b|\btime\.time\(")
# When a run took place.
DATES = {"bench/machine/machine.cpp", "report/study.py"}


def readers_of_the_clock(root: Path) -> set[str]:
    files = [path for directory in ("kernels", "tools", "bench", "report", "python")
             for path in (root / directory).rglob("*") if path.suffix in {".cpp", ".hpp", ".py"}]
    return {path.relative_to(root).as_posix() for path in files
            if SYSTEM_CLOCK.search(path.read_text(encoding="utf-8"))}


def test_only_dates_come_from_the_system_clock() -> None:
    assert readers_of_the_clock(ROOT) == DATES


def test_a_duration_by_the_system_clock_is_found(tmp_path: Path) -> None:
    (tmp_path / "tools").mkdir()
    (tmp_path / "tools" / "batch.cpp").write_text("std::chrono::system_clock::now();\n")
    (tmp_path / "tools" / "fine.cpp").write_text("std::chrono::steady_clock::now(); run_time(1);\n")
    assert readers_of_the_clock(tmp_path) == {"tools/batch.cpp"}
