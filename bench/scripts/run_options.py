"""Prints, as JSON for machine.json, with what options a study was run.

Usage: run_options.py yes|no FILTER REPETITIONS LARGEST_SQUARE yes|no FOREGROUND THRESHOLD [IMAGE...]
"""

from __future__ import annotations

import json
import sys
from pathlib import Path


def run_options(arguments: list[str]) -> dict[str, object]:
    """The options by name; images by their files' names, since directories are private."""
    quick, regex, repetitions, largest, peers, foreground, threshold, *images = arguments
    return {"quick": quick == "yes", "filter": regex, "repetitions": int(repetitions),
            "largest_square": int(largest), "peers": peers == "yes",
            "foreground": foreground, "threshold": threshold,
            "images": [Path(image).name for image in images]}


if __name__ == "__main__":
    print(json.dumps(run_options(sys.argv[1:])))
