"""The images of a run: inside the page, scaled down where they are large."""

from __future__ import annotations

import base64
import io
from dataclasses import dataclass
from pathlib import Path

from PIL import Image

from report.page.operations import PRINTED_RULE, Rows, title

FIRST = ("thin_guo_hall", "thin_zhang_suen", "thin_naccache_shinghal", "edges_sobel")
"""What the first screen shows beside the input, as far as it was made."""

MAX_BYTES = 200_000
SIDES = (1024, 768, 512, 384)
"""Of images that are scaled down; even noise of the last is small enough."""

MAX_TOTAL_BYTES = 1_000_000
"""Of all images in the page, which is to stay small."""


@dataclass(frozen=True)
class Picture:
    """An image with its words; `source` is a data URI, "" where the page is full."""

    source: str
    path: str
    caption: str


class Pictures:
    """Loads each image once."""

    def __init__(self, directory: Path, rows: Rows) -> None:
        self.directory, self.rows, self.bytes = directory, rows, 0

    def of_case(self, case: str) -> Picture | None:
        """What the case makes of the main input; None where there is no such image."""
        remark = ", which breaks lines" if case == PRINTED_RULE else ""
        return self._picture(f"{self.rows.input}_{case.replace(':', '_')}.png", title(case) + remark)

    def inputs(self) -> list[Picture]:
        """The main input in grey, and its foreground, of which most operations are timed."""
        name = self.rows.input
        found = (self._picture(f"{name}_grey.png", f"the picture, {name}"),
                 self._picture(f"{name}.png", "its foreground, as it was measured"))
        return [picture for picture in found if picture]

    def first(self) -> list[Picture]:
        """The input and a few results."""
        cases = [case for case in FIRST if case in self.rows.cases] or self.rows.cases
        return [*self.inputs(), *(one for one in map(self.of_case, cases[:3]) if one)]

    def _picture(self, name: str, caption: str) -> Picture | None:
        path = self.directory / "pictures" / name
        if not path.is_file():
            return None
        data = path.read_bytes() if path.stat().st_size <= MAX_BYTES else b""
        if not data:
            data = _scaled_down(path)
            caption += ", scaled down"
        fits = self.bytes + len(data) <= MAX_TOTAL_BYTES
        self.bytes += len(data) if fits else 0
        source = f"data:image/png;base64,{base64.b64encode(data).decode()}" if fits else ""
        return Picture(source, f"pictures/{name}", caption)


def _scaled_down(path: Path) -> bytes:
    """A PNG file of at most MAX_BYTES, of any image."""
    Image.MAX_IMAGE_PIXELS = None  # a file of the run itself
    with Image.open(path) as file:
        image = file.convert("L")
    data = b""
    for side in SIDES:
        image.thumbnail((side, side))
        out = io.BytesIO()
        image.save(out, "PNG", optimize=True)
        data = out.getvalue()
        if len(data) <= MAX_BYTES:
            break
    return data
