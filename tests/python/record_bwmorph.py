"""Records Octave's bwmorph(image, 'thin', n) in bwmorph.json; needs octave and octave-image.

Usage: python3 tests/python/record_bwmorph.py
"""

from __future__ import annotations

import hashlib
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from images import iteration_limit, random_image

CASES = 2000
FILE = Path(__file__).with_name("bwmorph.json")


def digest(image: np.ndarray) -> str:
    """A short hash of shape and pixels."""
    content = repr(image.shape).encode() + np.packbits(image.astype(bool)).tobytes()
    return hashlib.sha256(content).hexdigest()[:12]


def script(directory: str) -> str:
    """Octave: every image of the directory, thinned."""
    return f"""pkg load image
for i = 0:{CASES - 1}
  n = [0 1 2 3 4 5 Inf](mod(i, 7) + 1);
  image = dlmread(sprintf("{directory}/%d.txt", i)) != 0;
  dlmwrite(sprintf("{directory}/%d.out", i), bwmorph(image, "thin", n), " ");
end
printf("%s %s", OCTAVE_VERSION, pkg("list", "image"){{1}}.version);
"""


def main() -> None:
    with tempfile.TemporaryDirectory() as directory:
        for seed in range(CASES):
            np.savetxt(f"{directory}/{seed}.txt", random_image(seed), "%d")
        run = subprocess.run(["octave-cli", "--eval", script(directory)], check=True,
                             capture_output=True, text=True)
        octave, package = run.stdout.split()[-2:]
        hashes = []
        for seed in range(CASES):
            thinned = np.loadtxt(f"{directory}/{seed}.out", ndmin=2)
            hashes.append(digest(thinned.reshape(random_image(seed).shape)))
    FILE.write_text(json.dumps({"octave": octave, "octave-image": package, "hashes": hashes},
                               indent=0) + "\n")


if __name__ == "__main__":
    assert iteration_limit(6) is None
    main()
