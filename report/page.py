"""The study as one self-contained page."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup
from PIL import Image

from report import formatting
from report.cases import file_stem
from report.claims.claim import Claim, to_table
from report.errors import ReportError
from report.experiment_layout import TITLE, Table
from report.findings import find, main_sentence, noise_of, noise_sentence, speedup_sentence
from report.model import NOISY_PERCENT, Study, input_order
from report.plot_style import CARD, GRID, INK, MUTED, Plot
from report.sweeps import Section
from report.sweeps.section import TITLE as SWEEPS

TEMPLATES = Path(__file__).parent / "templates"
PAGE_BYTES = 2_900_000
FIXED_BYTES, ROW_BYTES, CELL_BYTES = 70_000, 520, 90
"""The page stays below 3 MB: what texts and table rows leave is for pictures and plots."""

LARGE_PICTURE = 100_000
"""Bytes of a PNG file from which a JPEG stands for it on the page."""

PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
THEME_VARIABLES = {INK: "--ink", MUTED: "--muted", GRID: "--line", CARD: "--card"}


@dataclass(frozen=True)
class Picture:
    """An input, or what an operation made of it; `source` embeds or, if too large, is empty."""

    path: str
    caption: str
    alt: str
    width: int
    height: int
    source: str


@dataclass(frozen=True)
class Figure:
    """A plot as it stands on the page; `drawing` is empty if the page had no room left."""

    plot: Plot
    drawing: Markup


class Room:
    """How many bytes may still be embedded."""

    def __init__(self, size: int) -> None:
        self._left = size

    def take(self, size: int) -> bool:
        """Claims room if there is enough of it."""
        fits = size <= self._left
        self._left -= size if fits else 0
        return fits


def to_html(study: Study, plots: list[Plot], tables: list[Table], claims: list[Claim],
            limits: Table | None = None, latex: Sequence[str] = (),
            sweeps: Section | None = None) -> str:
    """The finished page; `tables` are of the paper's experiments, `latex` names files."""
    shown = [*tables, *([limits] if limits else []), *(sweeps.tables if sweeps else ())]
    cells = sum(len(row) for table in shown for row in table.rows)
    room = Room(PAGE_BYTES - FIXED_BYTES - ROW_BYTES * len(study.rows) - CELL_BYTES * cells)
    findings = find(study)
    return _environment().get_template("page.html.j2").render(
        study=study, findings=findings, main_sentence=main_sentence(findings),
        noise_sentence=noise_sentence(noise_of(study)),
        speedup_sentence=speedup_sentence(study), pictures=_pictures(study, room),
        figures=[_figure(plot, number, room) for number, plot in enumerate(plots)],
        claims=to_table(claims), limits=limits,
        limits_figure=limits and limits.plot and _figure(limits.plot, len(plots) + len(tables), room),
        latex=latex, experiments_title=TITLE,
        experiments=[(table, table.plot and _figure(table.plot, len(plots) + number, room))
                     for number, table in enumerate(tables)],
        sweeps=sweeps, sweeps_title=SWEEPS, sweep_figures=[
            _figure(plot, len(plots) + len(tables) + 1 + number, room)
            for number, plot in enumerate(sweeps.plots if sweeps else ())],
        noisy_percent=NOISY_PERCENT, nothing=formatting.NOTHING,
        input_names=sorted({row.name.input for row in study.rows}, key=input_order))


def _environment() -> Environment:
    environment = Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True,
                              undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    filters = (formatting.microseconds, formatting.times, formatting.percent, formatting.speedup_text,
               formatting.scope_label, formatting.duration, formatting.kibibytes)
    environment.filters.update({function.__name__: function for function in filters})
    return environment


def _figure(plot: Plot, number: int, room: Room) -> Figure:
    drawing = inline_svg(plot, f"plot{number}-")
    return Figure(plot, drawing if room.take(len(drawing)) else Markup(""))


def inline_svg(plot: Plot, prefix: str) -> Markup:
    """The drawing for use inside HTML: identifiers made unique, neutral colours from the page.

    The neutral colours become the page's CSS variables, so that the drawing follows dark mode.
    """
    text = plot.svg.decode("utf-8")
    text = text[text.index("<svg"):]
    text = re.sub(r"<!--.*?-->\s*", "", text, flags=re.DOTALL)
    text = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{prefix}", text)
    text = re.sub(r"\s*\n\s*", " ", text)
    for colour, variable in THEME_VARIABLES.items():
        text = text.replace(colour, f"var({variable})")
    label = Markup('role="img" aria-label="{}"').format(plot.alt)
    text = re.sub(r'<svg\b[^>]*?(viewBox="[^"]*")[^>]*>',
                  lambda tag: f"<svg {label} {tag.group(1)}>", text, count=1)
    return Markup(text)


def _pictures(study: Study, room: Room) -> list[list[Picture]]:
    """For each input its picture followed by the results, leaving out what was not saved."""
    groups = []
    for item in sorted(study.inputs, key=lambda item: input_order(item.name)):
        names = [(item.name, f"{item.name}, the input: {item.object_pixels:,} object pixels"),
                 (f"{item.name}_grey", f"{item.name}, the grey input of the edge operators")]
        # Older runs wrote _keep_border where it is _keep now.
        names += [(f"{item.name}_{file_stem(case)}{end}", f"{case} of {item.name}")
                  for case in study.cases for end in ("", "_border")]
        group = [_picture(study, name, caption, (item.width, item.height), room)
                 for name, caption in names if (study.directory / _path(name)).is_file()]
        groups.append(group)
    return [group for group in groups if group]


def _picture(study: Study, name: str, caption: str, size: tuple[int, int], room: Room) -> Picture:
    path = study.directory / _path(name)
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ReportError(f"{path}: cannot be read: {error.strerror}") from None
    if not data.startswith(PNG_SIGNATURE):
        raise ReportError(f"{path}: starts with {data[:8]!r}; a PNG file is needed")
    kind, data = _embedded(data)
    text = base64.b64encode(data).decode("ascii")
    source = f"data:image/{kind};base64,{text}" if room.take(len(text)) else ""
    alt = f"{caption}, a picture of {size[0]} by {size[1]} pixels"
    return Picture(_path(name), caption, alt, *size, source)


def _embedded(png: bytes) -> tuple[str, bytes]:
    """The picture as the page shows it: grey noise is large as PNG, so it becomes JPEG."""
    if len(png) <= LARGE_PICTURE:
        return "png", png
    small = io.BytesIO()
    with Image.open(io.BytesIO(png)) as picture:
        picture.convert("L").save(small, format="jpeg", quality=85)
    return "jpeg", small.getvalue()


def _path(name: str) -> str:
    return f"pictures/{name}.png"
