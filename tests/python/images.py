"""Random binary images of many shapes."""

from __future__ import annotations

import numpy as np


def random_image(seed: int, max_side: int = 64) -> np.ndarray:
    """A bool image: noise, blobs, bars or rectangles at the border. RandomState never changes."""
    random = np.random.RandomState(seed)
    height, width = random.randint(1, max_side + 1, 2)
    image = random.rand(height, width) < random.rand()
    kind = random.randint(4)
    if kind == 1:
        for _ in range(random.randint(1, 4)):
            padded = np.pad(image, 1)
            image = padded[:-2, 1:-1] | padded[2:, 1:-1] | padded[1:-1, :-2] | padded[1:-1, 2:]
    if kind == 2:
        image &= False
        for _ in range(random.randint(1, 8)):
            y, x = random.randint(height), random.randint(width)
            image[y:y + random.randint(1, 12), x:x + random.randint(1, 40)] ^= True
    if kind == 3:
        image[random.randint(height):, :random.randint(width)] = True
    return image


def iteration_limit(seed: int) -> int | None:
    """0 to 5, or none."""
    return (0, 1, 2, 3, 4, 5, None)[seed % 7]
