"""Records tables of other programs in tables.json: Octave's bwmorph, Pillow's LutBuilder,
scikit-image's thin. Needs octave and octave-image, Pillow and scikit-image.

Bits are hexadecimal, four per digit, the first in the digit's highest bit: windows in the order of
thinbench::WindowTable.

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
              "majority", "remove", "spur"]
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


SCRIPT = """pkg load image
image = dlmread("sheet.txt") != 0;
names = strsplit("{operations}");
for i = 1:numel(names)
  dlmwrite(names{{i}}, bwmorph(image, names{{i}}, 1), " ");
end
printf("%s %s", OCTAVE_VERSION, pkg("list", "image"){{1}}.version);
"""


def bwmorph() -> dict:
    with tempfile.TemporaryDirectory() as directory:
        np.savetxt(f"{directory}/sheet.txt", window_sheet(), "%d")
        run = subprocess.run(["octave-cli", "--eval", SCRIPT.format(operations=" ".join(OPERATIONS))],
                             check=True, capture_output=True, text=True, cwd=directory)
        octave, package = run.stdout.split()[-2:]
        tables = {name: hexadecimal(np.loadtxt(f"{directory}/{name}")[CELL // 2 :: CELL, CELL // 2])
                  for name in OPERATIONS}
    return {"octave": octave, "octave-image": package, "tables": tables}


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
