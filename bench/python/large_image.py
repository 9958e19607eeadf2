"""Draws a large binary image as PBM (P4): the benchmark's scene in many sizes, mirrored at random.

    large_image.py WIDTH HEIGHT OUT.pbm [--program build/release/bin/thinbench-study] [--seed N]

Squares of the image hold one scene enlarged 32 times or several smaller ones. Takes memory for one
row of squares, packed.
"""

from __future__ import annotations

import argparse
import subprocess
import tempfile
from pathlib import Path

import cv2
import numpy as np

SCALES = (1, 2, 4, 8, 16, 32)
WEIGHTS = (4, 4, 4, 4, 2, 1)
WIDTH, HEIGHT = 512 * SCALES[-1], 412 * SCALES[-1]  # of a square; a scene is 2 pixels narrower


def scenes(program: Path) -> dict[int, np.ndarray]:
    """The scene of each scale, as bool."""
    found = {}
    with tempfile.TemporaryDirectory() as directory:
        for scale in SCALES:
            file = f"{directory}/scene.png"
            subprocess.run([program, "scene", file, "--binary", "--scale", str(scale)], check=True,
                           stdout=subprocess.DEVNULL)
            found[scale] = cv2.imread(file, cv2.IMREAD_GRAYSCALE) != 0
    return found


def packed_square(drawn: dict[int, np.ndarray], random: np.random.RandomState) -> np.ndarray:
    """Packed rows of a square of scenes of one scale, each mirrored at random."""
    scale = random.choice(SCALES, p=np.array(WEIGHTS) / sum(WEIGHTS))
    scene = np.pad(drawn[scale], ((0, 0), (scale, scale)))
    kinds = [np.packbits(scene[::y, ::x], axis=1) for y in (1, -1) for x in (1, -1)]
    count = SCALES[-1] // scale
    return np.vstack([np.hstack([kinds[random.randint(4)] for _ in range(count)])
                      for _ in range(count)])


def draw(width: int, height: int, out: Path, program: Path, seed: int) -> None:
    drawn = scenes(program)
    random = np.random.RandomState(seed)
    row_bytes = (width + 7) // 8
    with out.open("wb") as file:
        file.write(f"P4\n{width} {height}\n".encode())
        for top in range(0, height, HEIGHT):
            row = np.zeros((min(HEIGHT, height - top), row_bytes), np.uint8)
            for left in range(0, row_bytes, WIDTH // 8):
                part = row[:, left:left + WIDTH // 8]
                part[:] = packed_square(drawn, random)[:part.shape[0], :part.shape[1]]
            if width % 8:
                row[:, -1] &= 0xFF << (8 - width % 8) & 0xFF
            file.write(row.data)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("width", type=int)
    parser.add_argument("height", type=int)
    parser.add_argument("out", type=Path)
    parser.add_argument("--program", type=Path, default=Path("build/release/bin/thinbench-study"))
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    draw(arguments.width, arguments.height, arguments.out, arguments.program, arguments.seed)


if __name__ == "__main__":
    main()
