"""Tests import the package of the build tree: PYTHONPATH=build/release/python."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
