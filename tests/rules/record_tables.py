"""Records tables and results of other programs in tables.json: Octave's bwmorph, Pillow's
LutBuilder, scikit-image's thin. Needs octave and octave-image, Pillow and scikit-image.

Bits are hexadecimal, four per digit, the first in the digit's highest bit: pixels of an image in
raster order, windows of a table in the order of thinbench::WindowTable.

Usage: python3 tests/rules/record_tables.py
"""

from __future__ import annotations

import json
import random
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import PIL
import skimage
from PIL import ImageMorph
from skimage.morphology import _skeletonize

FILE = Path(__file__).with_name("tables.json")
OPERATIONS = ["bridge", "clean", "diag", "dilate", "endpoints", "erode", "fill", "hbreak",
              "majority", "remove", "spur", "thin"]
SHAPE = (10, 14)
DENSITIES = [0.15, 0.3, 0.5, 0.6, 0.75, 0.9]
WINDOWS = 512
CELL = 9  # pixels, so that windows do not touch


def hexadecimal(bits) -> str:
    return np.packbits(np.asarray(bits, dtype=bool).ravel()).tobytes().hex()


def window_sheet() -> np.ndarray:
    """Every window in the middle of a cell, one cell below the other."""
    sheet = np.zeros((WINDOWS * CELL, CELL), dtype=bool)
    for window in range(WINDOWS):
        pixels = [window >> k & 1 for k in range(9)]
        sheet[window * CELL + 3 : window * CELL + 6, 3:6] = np.reshape(pixels, (3, 3))
    return sheet


def images() -> list[np.ndarray]:
    generator = np.random.default_rng(1)
    return [generator.random(SHAPE) < density for density in DENSITIES]


def script(directory: str, count: int) -> str:
    """Octave: each operation once on all images, the last of which is the sheet; thin also to the
    end."""
    quoted = ", ".join(f'"{operation}"' for operation in OPERATIONS)
    return f"""pkg load image
operations = {{{quoted}}};
for i = 0:{count - 1}
  image = dlmread(sprintf("{directory}/%d.txt", i)) != 0;
  for o = 1:numel(operations)
    name = operations{{o}};
    dlmwrite(sprintf("{directory}/%d.%s", i, name), bwmorph(image, name, 1), " ");
  end
  dlmwrite(sprintf("{directory}/%d.all", i), bwmorph(image, "thin", Inf), " ");
end
printf("%s %s", OCTAVE_VERSION, pkg("list", "image"){{1}}.version);
"""


def bwmorph() -> dict:
    inputs = [*images(), window_sheet()]
    with tempfile.TemporaryDirectory() as directory:
        for i, image in enumerate(inputs):
            np.savetxt(f"{directory}/{i}.txt", image, "%d")
        run = subprocess.run(["octave-cli", "--eval", script(directory, len(inputs))], check=True,
                             capture_output=True, text=True)
        octave, package = run.stdout.split()[-2:]

        def results(kind: str) -> list[str]:
            return [hexadecimal(np.loadtxt(f"{directory}/{i}.{kind}", ndmin=2))
                    for i in range(len(DENSITIES))]

        def table(kind: str) -> str:
            sheet = np.loadtxt(f"{directory}/{len(DENSITIES)}.{kind}", ndmin=2)
            return hexadecimal(sheet[CELL // 2 :: CELL, CELL // 2])

        operations = {name: {"table": table(name), "once": results(name)} for name in OPERATIONS}
        operations["thin"]["all"] = results("all")
    del operations["thin"]["table"]  # it has two sub-iterations
    return {"octave": octave, "octave-image": package, "height": SHAPE[0], "width": SHAPE[1],
            "images": [hexadecimal(image) for image in images()], "operations": operations}


def random_pattern(generator: random.Random) -> str:
    operations = "".join(generator.sample("14MN", generator.randint(1, 3)))
    rows = ["".join(generator.choices("01.X", [3, 3, 4, 1], k=3)) for _ in range(3)]
    separator = generator.choice([" ", "", "\n    "])
    return f"{operations}:({separator.join(rows)})->{generator.randint(0, 1)}"


def pillow() -> dict:
    known = ["corner", "dilation4", "dilation8", "erosion4", "erosion8", "edge"]
    lists = [ImageMorph.LutBuilder(op_name=name).patterns for name in known]
    generator = random.Random(2)
    lists += [[random_pattern(generator) for _ in range(i // 3)] for i in range(20)]
    return {"pillow": PIL.__version__,
            "tables": [{"patterns": patterns,
                        "table": hexadecimal(ImageMorph.LutBuilder(patterns).build_lut())}
                       for patterns in lists]}


def text_of(content: dict) -> str:
    """JSON with one line per operation and per list of patterns."""
    return re.sub(r"\n {4,}|\n {3}(?=[]}])", "", json.dumps(content, indent=1))


def main() -> None:
    thin = [hexadecimal(_skeletonize.G123_LUT), hexadecimal(_skeletonize.G123P_LUT)]
    content = {"bwmorph": bwmorph(), "pillow": pillow(),
               "skimage": {"scikit-image": skimage.__version__, "thin": thin}}
    FILE.write_text(text_of(content) + "\n")


if __name__ == "__main__":
    main()
