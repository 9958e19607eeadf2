"""Draws the pictures of docs/rules.md: what each named rule changes, on images made from the scene.

A picture shows a part of the image in which the rule changes many pixels, enlarged. Foreground that
remains is black, foreground that becomes background orange, background that becomes foreground
blue.

Usage: python3 bench/python/rule_pictures.py [PROGRAMS [DIRECTORY]]
PROGRAMS is build/release/bin unless given, DIRECTORY results/pictures/rules.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

ROOT = Path(__file__).resolve().parents[2]
WIDTH, HEIGHT, SCALE = 64, 40, 3
WHITE, BLACK, ORANGE, BLUE = (255, 255, 255), (0, 0, 0), (60, 160, 255), (220, 110, 30)  # BGR

# The image that shows a rule best; "parts" for all others. Skeletons have ends, fragments gaps.
INPUTS = {
    "skeleton": ["endpoints", "prune"],
    "fragments": ["bridge"],
    "noise": ["clean", "diag", "fill", "hbreak", "life", "majority", "spur"],
}
Image = npt.NDArray[np.bool_]


class Drawing:
    """Runs the programs in a directory."""

    def __init__(self, programs: Path, directory: Path) -> None:
        self.programs = programs
        self.directory = directory

    def run(self, *words: str, program: str = "thinbench") -> str:
        return subprocess.run([self.programs / program, *words], cwd=self.directory, check=True, text=True,
                              capture_output=True).stdout

    def make_inputs(self) -> None:
        self.run("scene", "parts.png", "--binary", program="thinbench-study")
        self.run("run", "thin_guo_hall", "parts.png", "skeleton.png", "--foreground", "bright")
        self.run("run", "thin_naccache_shinghal", "parts.png", "fragments.png",
                 "--foreground", "bright")
        self.run("scene", "grey.png", "--noise", "60", program="thinbench-study")
        self.run("run", "B/S012345678", "grey.png", "noise.png", "--foreground", "dark")

    def read(self, name: str) -> Image:
        grey = cv2.imread(str(self.directory / name), cv2.IMREAD_GRAYSCALE)
        return np.asarray(grey > 0, np.bool_)

    def picture(self, rule: str) -> npt.NDArray[np.uint8]:
        name = next((name for name, rules in INPUTS.items() if rule in rules), "parts") + ".png"
        self.run("run", rule, name, "out.png", "--foreground", "bright")
        before, after = self.read(name), self.read("out.png")
        part = telling_part(before, after)
        return enlarged(coloured(before[part], after[part]))


def telling_part(before: Image, after: Image) -> tuple[slice, slice]:
    """The first part of the picture's size, on a coarse grid, with much changed and much left."""
    height, width = before.shape
    parts = [(slice(y, y + HEIGHT), slice(x, x + WIDTH)) for y in range(0, height - HEIGHT + 1, 4)
             for x in range(0, width - WIDTH + 1, 4)]
    changed = before != after
    return max(parts, key=lambda part: min(int(changed[part].sum()), int(after[part].sum())))


def coloured(before: Image, after: Image) -> npt.NDArray[np.uint8]:
    picture = np.full((*before.shape, 3), WHITE, np.uint8)
    picture[before & after] = BLACK
    picture[before & ~after] = ORANGE
    picture[~before & after] = BLUE
    return picture


def enlarged(picture: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    return picture.repeat(SCALE, axis=0).repeat(SCALE, axis=1)


def main() -> None:
    arguments = [Path(word).resolve() for word in sys.argv[1:3]]
    programs = arguments[0] if arguments else ROOT / "build" / "release" / "bin"
    target = arguments[1] if arguments[1:] else ROOT / "results" / "pictures" / "rules"
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as directory:
        drawing = Drawing(programs, Path(directory))
        drawing.make_inputs()
        for line in drawing.run("rule", "--list").splitlines()[1:]:
            rule = line.split()[0]
            cv2.imwrite(str(target / f"{rule}.png"), drawing.picture(rule),
                        [cv2.IMWRITE_PNG_COMPRESSION, 9])


if __name__ == "__main__":
    main()
