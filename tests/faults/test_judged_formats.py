"""Image files of every format and depth, other ones in each run, written by Pillow, tifffile, ImageMagick and OpenCV,
mean what docs/images.md makes of the samples that these wrote or, of JPEG, that Pillow reads."""

from __future__ import annotations

import functools
import random
import shutil
import subprocess
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from conftest import SEED, run
from PIL import Image
from test_formats import GREY, LONG, RGB, Samples, of, shown, tiff

tifffile = pytest.importorskip("tifffile")
cv2 = pytest.importorskip("cv2")
pytestmark = pytest.mark.skipif(shutil.which("convert") is None, reason="imagemagick is not installed")



# What samples mean.

def grey(samples: Samples, highest: int) -> Samples:
    """Levels of grey or colours from 0 to `highest`; up to 255 they become those of 8 bits."""
    if highest < 255:
        samples = samples.astype(int) * 255 // highest
    return samples[..., 0] if samples.shape[2] < 3 else samples[..., :3] @ [.299, .587, .114]


def on_black(samples: Samples, highest: int) -> Samples:
    """The same of samples the last of which is opacity."""
    return grey(samples[..., :-1].astype(int) * samples[..., -1:] / highest, highest)


def of_inks(inks: Samples, highest: int) -> Samples:
    """The same of cyan, magenta, yellow and black."""
    return grey((highest - inks[..., :3].astype(float)) * (highest - inks[..., 3:].astype(float)) / highest, highest)


def judged_jpeg(path: Path) -> Samples:
    """What Pillow makes of a file with JPEG."""
    image = Image.open(path)
    samples = np.atleast_3d(np.asarray(image if image.mode in ("L", "CMYK") else image.convert("RGB")))
    return of_inks(samples, 255) if image.mode == "CMYK" else grey(samples, 255)


def assert_read(path: Path, expected: Samples, rounding: int = 1) -> None:
    """The program shows these levels, divided where they do not fit into 8 bits; numbers that are not whole may be
    rounded in several steps."""
    found = shown(path).astype(float)
    assert found.shape == expected.shape, (SEED, path)
    divisor = 2.0 ** max(0, int(expected.max()).bit_length() - 8)
    exact = np.issubdtype(expected.dtype, np.integer)
    rounding = 0 if exact else rounding + (divisor > 1)
    least, most = np.floor((expected - rounding) / divisor), np.floor((expected + rounding) / divisor)
    wrong = (found < least) | (found > most)
    assert not wrong.any(), (SEED, path, np.argwhere(wrong)[:3].tolist(), found[wrong][:3], expected[wrong][:3])


# Drawn images and files.

class Draw(random.Random):
    """Draws images and options."""

    def samples(self, channels: int, highest: int, dtype: npt.DTypeLike = np.uint16) -> Samples:
        """Noise, a ramp or areas; of few bits all levels, of many perhaps only low ones."""
        noise = np.random.default_rng(self.getrandbits(32))
        height, width = self.randint(1, 70), self.randint(1, 70)
        top = highest if channels % 2 == 0 else self.choice([highest, highest, min(highest, 255), min(highest, 4095)])
        image = noise.integers(0, top + 1, (height, width, channels))
        if self.random() < .3:
            image = np.repeat(np.repeat(image, 7, 0), 5, 1)[:height, :width]
        if self.random() < .3:
            image = np.linspace(0, top, height * width * channels).astype(int).reshape(height, width, channels)
        return image.astype(dtype)


def pam(samples: Samples, highest: int) -> bytes:
    """A file of any samples, which ImageMagick reads."""
    height, width, channels = samples.shape
    kind = ("GRAYSCALE", "GRAYSCALE_ALPHA", "RGB", "RGB_ALPHA")[channels - 1]
    head = f"P7\nWIDTH {width}\nHEIGHT {height}\nDEPTH {channels}\nMAXVAL {highest}\nTUPLTYPE {kind}\nENDHDR\n"
    return head.encode() + samples.astype(">u2" if highest > 255 else np.uint8).tobytes()


def convert(samples: Samples, highest: int, path: Path, *options: object, kind: str = "") -> None:
    """By ImageMagick."""
    words = ["convert", "pam:-", *map(str, options), f"{kind}{path}"]
    subprocess.run(words, input=pam(samples, highest), check=True, capture_output=True)


KINDS: dict[str, Callable[[Draw, Path], None]] = {}


def for_all(names: dict[str, tuple[object, ...]]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Names kinds of files for what writes one, with these arguments last, and calls assert_read."""
    def named(write: Callable[..., None]) -> Callable[..., None]:
        for name, arguments in names.items():
            KINDS[name] = functools.partial(lambda more, draw, path: write(draw, path, *more), arguments)
        return write
    return named


@for_all({f"PNG, type {colours}, {bits} bits": (colours, bits) for colours, depths in (
    (0, (1, 2, 4, 8, 16)), (2, (8, 16)), (4, (8, 16)), (6, (8, 16))) for bits in depths})
def _png(draw: Draw, path: Path, colours: int, bits: int) -> None:
    path, highest = path.with_suffix(".png"), 2**bits - 1
    samples = draw.samples({0: 1, 2: 3, 4: 2, 6: 4}[colours], highest)
    convert(samples, highest, path, "-interlace", draw.choice(["none", "PNG"]), "-define", f"png:bit-depth={bits}",
            "-define", f"png:color-type={colours}")
    assert path.read_bytes()[24:26] == bytes([bits, colours])
    assert_read(path, grey(samples, highest))


@for_all({f"{suffix[1:].upper()}, palette of {bits} bits": (suffix, bits) for suffix in (".png", ".bmp", ".tif")
          for bits in ((1, 2, 4, 8) if suffix == ".png" else (8,))})
def _palette(draw: Draw, path: Path, suffix: str, bits: int) -> None:
    path = path.with_suffix(suffix)
    indices = draw.samples(1, 2**bits - 1, np.uint8)[..., 0]
    colours = np.array([draw.randrange(256) for _ in range(3 * 2**bits)], np.uint8)
    image = Image.fromarray(indices, "P")
    image.putpalette(colours.tobytes())
    image.save(path, **({"bits": bits} if suffix == ".png" else {}))
    assert_read(path, grey(colours.reshape(-1, 3)[indices], 255))


COMPRESSIONS = {".tif": [None, "tiff_lzw", "tiff_adobe_deflate", "packbits"], ".png": [None], ".bmp": [None]}


@for_all({f"{suffix[1:].upper()}, {mode}, Pillow": (suffix, mode) for suffix in COMPRESSIONS
          for mode in ("1", "L", "RGB", "RGBA", "CMYK", "LA")
          if (mode not in ("CMYK", "LA") or suffix == ".tif") and (mode, suffix) != ("RGBA", ".bmp")})
def _pillow(draw: Draw, path: Path, suffix: str, mode: str) -> None:
    path = path.with_suffix(suffix)
    compressions = COMPRESSIONS[suffix] + (["group3", "group4"] if (mode, suffix) == ("1", ".tif") else [])
    samples = draw.samples(len(Image.new(mode, (1, 1)).getbands()), 1 if mode == "1" else 255, np.uint8)
    pixels = samples * 255 if mode == "1" else samples
    image = Image.fromarray(pixels[..., 0] if pixels.shape[2] == 1 else pixels, "L" if mode == "1" else mode)
    chosen = draw.choice(compressions)
    image.convert(mode).save(path, **({"compression": chosen} if chosen else {}))
    meaning = of_inks if mode == "CMYK" else on_black if suffix == ".tif" and mode in ("RGBA", "LA") else grey
    assert_read(path, meaning(pixels, 255))


TYPES = {"u1": 255, "u2": 65535, "u4": 65535, "i1": 127, "i2": 32767, "f4": 65535, "f8": 65535}


@for_all({f"TIFF, {photometric}, {dtype}, tifffile": (photometric, dtype) for dtype in TYPES
          for photometric in ("minisblack", "miniswhite", "rgb", "separated")
          if photometric in ("minisblack", "rgb") or dtype in ("u1", "u2")})
def _tifffile(draw: Draw, path: Path, photometric: str, dtype: str) -> None:
    path, highest = path.with_suffix(".tif"), TYPES[dtype]
    samples = draw.samples({"rgb": 3, "separated": 4}.get(photometric, 1), highest, np.int64)
    if dtype[0] == "i" and draw.random() < .7:
        samples -= draw.choice([1, highest + 1])
    part: dict[str, object] = {"rowsperstrip": draw.randint(1, 80)}
    if draw.random() < .5:
        part = {"tile": (16 * draw.randint(1, 3), 16 * draw.randint(1, 3))}
    planes = samples.shape[2] > 1 and draw.random() < .5
    stored = samples.astype(dtype)
    with tifffile.TiffWriter(path, bigtiff=draw.random() < .3, byteorder=draw.choice("<>")) as file:
        file.write(stored.transpose(2, 0, 1) if planes else stored[..., 0] if samples.shape[2] == 1 else stored,
                   photometric=photometric, planarconfig="separate" if planes else None,
                   compression=draw.choice([None, "zlib"]), **part)
    if photometric == "miniswhite":
        samples = highest - samples
    if dtype[0] == "i":
        samples -= min(samples.min(), 0)
    assert_read(path, of_inks(samples, highest) if photometric == "separated" else grey(samples, max(highest, 255)))


@for_all({f"TIFF, {channels} channels, {bits} bits, packed here": (channels, bits)
          for channels in (1, 3) for bits in (*range(1, 9), 10, 12, 14, 16)})
def _packed(draw: Draw, path: Path, channels: int, bits: int) -> None:
    path, highest = path.with_suffix(".tif"), 2**bits - 1
    samples = draw.samples(channels, highest, ">u2")
    height, width, _ = samples.shape
    side = draw.choice([0, 16, 32])  # of tiles
    padded = np.pad(samples, ((0, -height % side), (0, -width % side), (0, 0))) if side else samples
    blocks = [np.packbits(np.unpackbits(block.view(np.uint8).reshape(*block.shape, 2), axis=3)[..., 16 - bits:].reshape(
        len(block), -1), axis=1).tobytes() for rows in np.split(padded, len(padded) // side if side else 1)
        for block in map(np.ascontiguousarray, np.split(rows, rows.shape[1] // side if side else 1, axis=1))]
    tags = of(RGB if channels == 3 else GREY, channels, bits)
    tags |= {322: (LONG, [side]), 323: (LONG, [side])} if side else {}
    if bits == 16:
        blocks = [np.frombuffer(block, ">u2").astype("<u2").tobytes() for block in blocks]
    path.write_bytes(tiff(width, height, blocks, tags))
    assert_read(path, grey(samples, highest))


@for_all({f"TIFF, {channels} channels, {bits} bits, ImageMagick": (channels, bits)
          for channels in (1, 3, 4) for bits in (1, 2, 4, 8, 16) if channels < 4 or bits > 4})
def _magick_tiff(draw: Draw, path: Path, channels: int, bits: int) -> None:
    path, highest = path.with_suffix(".tif"), 2**bits - 1
    samples = draw.samples(channels, highest)
    options = ["-compress", draw.choice(["None", "LZW", "Zip", "RLE"] + ["Group4", "Fax"] * (bits * channels == 1))]
    options += ["-endian", draw.choice(["MSB", "LSB"]), "-depth", bits, "-define", "tiff:alpha=unassociated"]
    parts = [[], ["-interlace", "Plane"], ["-define", "tiff:tile-geometry=32x16"]]
    options += draw.choice(parts if bits >= 8 else parts[:2])  # it writes wrong tiles of fewer bits
    options += ["-type", {1: "Grayscale", 3: "TrueColor", 4: "TrueColorMatte"}[channels]]
    convert(samples, highest, path, *options)
    assert_read(path, on_black(samples, highest) if channels == 4 else grey(samples, highest))


@for_all({"JPEG, grey": ("L",), "JPEG, colours": ("RGB",), "JPEG, inks": ("CMYK",),
          "TIFF with JPEG, grey": ("L", ".tif"), "TIFF with JPEG, colours": ("RGB", ".tif")})
def _jpeg(draw: Draw, path: Path, mode: str, suffix: str = ".jpg") -> None:
    path = path.with_suffix(suffix)
    samples = draw.samples(len(mode), 255, np.uint8)
    options: dict[str, object] = {"compression": "jpeg"} if suffix == ".tif" else {
        "progressive": draw.random() < .5, "optimize": draw.random() < .5, "subsampling": draw.randrange(3)}
    Image.fromarray(np.squeeze(samples, 2) if mode == "L" else samples, mode).save(
        path, quality=draw.randint(20, 100), **options)
    assert_read(path, judged_jpeg(path).astype(float), 2)


@for_all({"JPEG, restart markers": ()})
def _restarts(draw: Draw, path: Path) -> None:
    path = path.with_suffix(".jpg")
    cv2.imwrite(str(path), draw.samples(3, 255, np.uint8), [cv2.IMWRITE_JPEG_RST_INTERVAL, draw.randint(1, 9)])
    assert_read(path, judged_jpeg(path))


@for_all({"BMP, runs of 8 bits": ("-type", "Palette", "-compress", "RLE"), "BMP, 4 bits": ("-colors", 16),
          "BMP, version 2": ("-type", "Palette"), "BMP, version 3": (), "BMP, 32 bits": ("-alpha", "set")})
def _bmp(draw: Draw, path: Path, *options: object) -> None:
    path = path.with_suffix(".bmp")
    levels = 16 * draw.samples(1, 15, np.uint8)
    convert(np.repeat(levels, 3, 2), 255, path, *options,
            kind="bmp2:" if "Palette" in options and "RLE" not in options else "bmp3:" if not options else "")
    assert_read(path, levels[..., 0])


@for_all({"BMP, 5-6-5": ("RGB565", (31, 63, 31)), "BMP, 5-5-5": ("RGB555", (31, 31, 31))})
def _deep_bmp(draw: Draw, path: Path, subtype: str, highest: tuple[int, ...]) -> None:
    path = path.with_suffix(".bmp")
    bits = draw.samples(3, 63) % (np.array(highest) + 1)
    convert(np.ceil(bits * 65535 / highest).astype(np.uint16), 65535, path, "-define", f"bmp:subtype={subtype}")
    assert_read(path, grey(bits * 255 / highest, 255))


@for_all({f"PNM, P{kind}, {'16' if deep else '8'} bits": (kind, deep) for kind in (1, 2, 3, 4, 5, 6, 7)
          for deep in (False, True) if kind not in (1, 4) or not deep})
def _pnm(draw: Draw, path: Path, kind: int, deep: bool) -> None:
    highest = 1 if kind in (1, 4) else draw.randint(256, 65535) if deep else draw.randint(1, 255)
    samples = draw.samples(3 if kind in (3, 6) else draw.randint(1, 4) if kind == 7 else 1, highest)
    height, width, _ = samples.shape
    path = path.with_suffix(".pnm")
    head = f"P{kind}\n#c\n{width}\t{height}\n" + (f"{highest}\n" if highest > 1 or kind not in (1, 4) else "")
    if kind == 7:
        path.write_bytes(pam(samples, highest))
    elif kind < 4:
        path.write_text(head + draw.choice([" ", "\n"]).join(map(str, samples.ravel().tolist())) + "\n")
    else:
        body = np.packbits(samples[..., 0] > 0, axis=1) if kind == 4 else samples.astype(">u2" if deep else np.uint8)
        path.write_bytes(head.encode() + body.tobytes())
    assert_read(path, grey(1 - samples.astype(int) if kind in (1, 4) else samples, highest))


@pytest.mark.parametrize("name", KINDS)
def test_files_of_other_programs_mean_what_they_wrote(name: str, tmp_path: Path) -> None:
    KINDS[name](Draw(SEED + zlib.crc32(name.encode())), tmp_path / "a")


@pytest.mark.parametrize("dtype", ["u8", "f2", "c8"])
def test_samples_that_are_not_read_are_one_line(dtype: str, tmp_path: Path) -> None:
    tifffile.imwrite(tmp_path / "a.tif", Draw(SEED).samples(1, 255, dtype)[..., 0], photometric="minisblack")
    run(["thinbench", "holes", "a.tif"], tmp_path).assert_failed("its samples are .*; known are")
