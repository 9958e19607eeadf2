"""Draws what is measured, from the built-in scene."""

from __future__ import annotations

import subprocess
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from report.progress import Progress

NOISE = 8.0
"""Standard deviation in grey levels, on top of the scene's own."""

Image = npt.NDArray[np.uint8]


def draw_scene(program: Path, work: Path, *words: str) -> Image:
    """As `thinbench-study scene` draws it; that program is beside `program`."""
    file = work / "scene.png"
    subprocess.run([program.with_name("thinbench-study"), "scene", file, *words], check=True, stdout=subprocess.DEVNULL)
    return np.asarray(cv2.imread(str(file), cv2.IMREAD_GRAYSCALE))


def draw_files(scene: Image, directory: Path, count: int) -> list[Path]:
    """PNG files: the scene with other noise, shifted and mirrored."""
    directory.mkdir()
    random = np.random.RandomState(1)
    files = [directory / f"{number:06}.png" for number in range(count)]
    progress = Progress("drawing", count)
    for file in files:
        step_y, step_x, *shift = (*random.choice((-1, 1), 2), *random.randint(0, scene.shape))
        moved = np.roll(scene[::step_y, ::step_x], shift, (0, 1))
        noisy = moved + random.normal(0, NOISE, scene.shape)
        cv2.imwrite(str(file), np.clip(noisy, 0, 255).astype(np.uint8))
        progress.advance(1)
    progress.close()
    return files


def repeated(scene: Image, side: int, rows: int) -> npt.NDArray[np.bool_]:
    """`rows` rows of a binary image that consists of copies of the scene."""
    copies = (-(-rows // scene.shape[0]), -(-side // scene.shape[1]))
    return np.tile(scene != 0, copies)[:rows, :side]
