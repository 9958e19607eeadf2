"""Options that choose rows and images, the same for every command that measures."""

from __future__ import annotations

import argparse
import re
from pathlib import Path


def add_row_options(parser: argparse.ArgumentParser, default_filter: str = "") -> None:
    """--filter, --image, --foreground, --threshold."""
    add_filter_option(parser, default_filter)
    parser.add_argument("--image", metavar="FILE", type=image_file, action="append", default=[],
                        help="measure on this image instead of the built-in scene; repeatable")
    parser.add_argument("--foreground", choices=("auto", "bright", "dark"), default="auto",
                        help="which pixels of these images are foreground; auto, the default, "
                             "takes the class that covers less of the image border")
    parser.add_argument("--threshold", metavar="N|otsu", type=_threshold, default="otsu",
                        help="bright are grey levels >= N, 0 to 255; otsu, the default, is the "
                             "level that separates the two classes best")


def add_filter_option(parser: argparse.ArgumentParser, default: str = "") -> None:
    """--filter."""
    parser.add_argument("--filter", metavar="REGEX", type=_regex, default=default,
                        help="only rows whose name case/technique/isa/threads/scope/input matches; "
                             "a case is an operation, with :keep where the image border is kept "
                             "and :N for at most N iterations")


def check_binarise_options(parser: argparse.ArgumentParser, options: argparse.Namespace,
                           images: list[Path]) -> None:
    """--foreground and --threshold need an image."""
    for name, default in (("foreground", "auto"), ("threshold", "otsu")):
        if getattr(options, name) != default and not images:
            parser.error(f"--{name} needs --image")


def binarise_words(options: argparse.Namespace) -> list[str]:
    """As the programs take them."""
    words = [] if options.foreground == "auto" else ["--foreground", options.foreground]
    return words + ([] if options.threshold == "otsu" else ["--threshold", options.threshold])


def input_words(options: argparse.Namespace) -> list[str]:
    """The images as thinbench_benchmarks takes them."""
    words = [word for image in options.image for word in ("--image", str(image))]
    return words + binarise_words(options) if words else []


def positive(text: str) -> int:
    """An integer above zero."""
    if not re.fullmatch("[1-9][0-9]{0,5}", text):
        raise argparse.ArgumentTypeError(f"expected an integer from 1 to 999999, got '{text}'")
    return int(text)


def _regex(text: str) -> str:
    try:
        re.compile(text)
    except re.error as error:
        raise argparse.ArgumentTypeError(f"'{text}' is not a regular expression: {error}") from None
    return text


def image_file(text: str) -> Path:
    """A file that exists."""
    path = Path(text)
    if not path.is_file():
        raise argparse.ArgumentTypeError(f"cannot read the image '{text}'")
    return path.resolve()


def _threshold(text: str) -> str:
    if text != "otsu" and not (text.isascii() and text.isdigit() and int(text) <= 255):
        raise argparse.ArgumentTypeError(f"expected an integer in [0, 255] or 'otsu', got '{text}'")
    return text
