"""Records Octave's bwmorph in bwmorph.json: "thin" with several n on all images, the other
operations on some, as hashes that `joined` describes. Needs octave and octave-image.

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
OPERATIONS = ["bothat", "bridge", "clean", "close", "diag", "dilate", "endpoints", "erode", "fill", "hbreak",
              "majority", "open", "remove", "spur", "tophat"]
OPERATION_CASES = 300
FILE = Path(__file__).with_name("bwmorph.json")


def digest(image: np.ndarray) -> str:
    """A short hash of shape and pixels."""
    content = repr(image.shape).encode() + np.packbits(image.astype(bool)).tobytes()
    return hashlib.sha256(content).hexdigest()[:12]


def joined(digests: list[str]) -> str:
    """Two digits of each, which tell the seed that differs, and a hash that all digits enter."""
    return ("".join(one[:2] for one in digests)
            + "+" + hashlib.sha256("".join(digests).encode()).hexdigest())


def assert_recorded(kind: str, results: list[np.ndarray]) -> None:
    """The results are Octave's, for the seeds from 0 on."""
    recorded = json.loads(FILE.read_text())["hashes"][kind]
    digests = [digest(result) for result in results]
    differing = [seed for seed, one in enumerate(digests)
                 if one[:2] != recorded[2 * seed:2 * seed + 2]]
    assert joined(digests) == recorded, f"two digits differ for the seeds {differing}"


def repetitions(seed: int) -> int:
    """n of the operations other than thin."""
    return 1 + 2 * (seed % 2)


def script(directory: str) -> str:
    """Octave: every image of the directory, thinned; the first ones by the other operations, too."""
    operations = ", ".join(f'"{operation}"' for operation in OPERATIONS)
    return f"""pkg load image
operations = {{{operations}}};
for i = 0:{CASES - 1}
  n = [0 1 2 3 4 5 Inf](mod(i, 7) + 1);
  image = dlmread(sprintf("{directory}/%d.txt", i)) != 0;
  dlmwrite(sprintf("{directory}/%d.thin", i), bwmorph(image, "thin", n), " ");
  if i >= {OPERATION_CASES}, continue; end
  for o = 1:numel(operations)
    result = bwmorph(image, operations{{o}}, 1 + 2 * mod(i, 2));
    dlmwrite(sprintf("{directory}/%d.%s", i, operations{{o}}), result, " ");
  end
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

        def hashes(kind: str, cases: int) -> str:
            results = [np.loadtxt(f"{directory}/{seed}.{kind}", ndmin=2) for seed in range(cases)]
            return joined([digest(result.reshape(random_image(seed).shape))
                           for seed, result in enumerate(results)])

        operations = {name: hashes(name, OPERATION_CASES) for name in OPERATIONS}
        recorded = {"octave": octave, "octave-image": package,
                    "hashes": {"thin": hashes("thin", CASES), **operations}}
    FILE.write_text(json.dumps(recorded, indent=0) + "\n")


if __name__ == "__main__":
    assert iteration_limit(6) is None
    main()
