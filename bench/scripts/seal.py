"""Writes DIR/files.json: of which machine and commit the run in DIR is, and what it measured.

Usage: seal.py DIR

The report refuses a folder whose measured files are not those listed.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from report.provenance import SEAL, measured_files  # noqa: E402


def seal(directory: Path) -> None:
    """Takes machine and commit from machine.json."""
    machine = json.loads((directory / "machine.json").read_text(encoding="utf-8"))
    text = json.dumps({"schema": 1, "fingerprint": machine["fingerprint"],
                       "commit": machine["commit"], "files": measured_files(directory)}, indent=2)
    part = directory / f"{SEAL}.part"
    part.write_text(text + "\n", encoding="utf-8")
    part.replace(directory / SEAL)


if __name__ == "__main__":
    seal(Path(sys.argv[1]))
