"""Matplotlib's SVG without what nobody sees: half the bytes, the same drawing."""

from __future__ import annotations

import re
from zlib import crc32

FALLBACK_FONTS = "'DejaVu Sans', Verdana, sans-serif"
"""Letters stay letters; Verdana is as wide as DejaVu Sans."""

HOVER = "hover: "
"""With what the name of a group begins that is a title for whoever points at it."""

DIGITS = 1
"""Behind the point, of lengths in points: a tenth of a point is less than a pixel of most screens."""


def small_svg(svg: bytes) -> bytes:
    """Drops white space, empty groups, names of groups, needless digits, and clipping.

    No figure draws beyond its axes: their limits follow from what they show.
    """
    text = svg.decode("utf-8")
    text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    text = re.sub(r"<[^>]*>", lambda tag: _small_tag(tag.group()), text)
    text = re.sub(r">\s+<", "><", text)
    text = re.sub(r"(?:<g/>)+|<clipPath.*?</clipPath>|<defs></defs>", "", text)
    return _with_classes(text).encode("utf-8")


def _with_classes(text: str) -> str:
    """Looks become classes, named after what they say: drawings on one page may share them."""
    rules: dict[str, str] = {}

    def named(style: re.Match[str]) -> str:
        name = f"s{crc32(style.group(1).encode()):x}"
        rules[name] = style.group(1)
        return f' class="{name}"'

    text = re.sub(r' style="([^"]*)"', named, text)
    sheet = "".join(f".{name}{{{look}}}" for name, look in sorted(rules.items()))
    return text.replace("</style>", f"{sheet}</style>", 1)


def _small_tag(tag: str) -> str:
    tag = re.sub(r"\s+", " ", tag)
    tag = re.sub(r'\b(?:d|x|y)="[^"]*"', lambda places: _rounded(places.group()), tag)
    tag = re.sub(rf'^<g id="{HOVER}([^"]*)"(.*)', r"<g\2<title>\1</title>", tag)
    tag = re.sub(r'^<g id="[^"]*"', "<g", tag)
    tag = re.sub(r' clip-path="[^"]*"', "", tag)
    tag = re.sub(r' transform="rotate\(-?0 [^"]*\)"', "", tag)
    return tag.replace("'DejaVu Sans'", FALLBACK_FONTS)


def _rounded(places: str) -> str:
    shorter = re.sub(r"-?\d+\.\d+", lambda number: f"{float(number.group()):.{DIGITS}f}", places)
    return shorter.replace(' "', '"')
