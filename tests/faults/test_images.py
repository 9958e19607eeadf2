"""Image files that say how they are turned, and hostile ones: what the program makes of them, and the memory it takes."""

from __future__ import annotations

import io
import json
import re
import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import READERS, Fault, expect_rejected, files_in, measured_run, parts, run
from PIL import Image, TiffImagePlugin
from test_formats import LONG, SHORT, Tags, tiff

GREY = parts()


@pytest.mark.parametrize("kind, orientation, command", [
    *(("jpg", orientation, "holes") for orientation in range(1, 9)),
    *((kind, orientation, "holes") for kind in ("png", "tif") for orientation in (6, 7)),
    ("png", 6, "graph --labels"), ("tif", 6, "graph --labels")])
def test_images_are_turned_as_they_say(kind: str, orientation: int, command: str, tmp_path: Path) -> None:
    """EXIF of JPEG and PNG, the tag of TIFF."""
    exif = Image.Exif()
    exif[0x112] = orientation
    more: dict[str, object] = {"tiffinfo": {0x112: orientation}} if kind == "tif" else {"exif": exif, "quality": 95}
    GREY.save(tmp_path / f"a.{kind}", **more)
    turns = [None, Image.Transpose.FLIP_LEFT_RIGHT, Image.Transpose.ROTATE_180, Image.Transpose.FLIP_TOP_BOTTOM,
             Image.Transpose.TRANSPOSE, Image.Transpose.ROTATE_270, Image.Transpose.TRANSVERSE,
             Image.Transpose.ROTATE_90]
    turn = turns[orientation - 1]
    (GREY if turn is None else GREY.transpose(turn)).save(tmp_path / "expected.png")
    results = [run(["thinbench", *command.split(), name, "--json"], tmp_path) for name in (f"a.{kind}", "expected.png")]
    found, expected = (json.loads(result.out) for result in results)
    key = "objects" if command == "holes" else "edges"
    assert found[key] == expected[key] != []


@pytest.mark.parametrize("start", [b"RIFF", b"RIFFr\0 ", b"RIFFr\0  WEB", b"\0\0\0 ftyp", b"GIF8", b"\x89PNG", b"BM"])
def test_beginnings_of_images_are_one_line(start: bytes, tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(start)
    expect_rejected("holes a.png", tmp_path, "a.png")


@pytest.mark.parametrize(("kind", "says"), [
    ("gif", "it is a GIF file"), ("webp", "it is a WebP file"), ("jp2", "it is a JPEG 2000 file"),
    ("ico", "not an image of a known format"), ("tga", "not an image of a known format")])
def test_other_kinds_are_refused(kind: str, says: str, tmp_path: Path) -> None:
    """Whatever decoders are installed."""
    GREY.save(tmp_path / f"a.{kind}")
    expect_rejected(f"holes a.{kind}", tmp_path, says)


# Hostile files.

def chunk(kind: bytes, data: bytes) -> bytes:
    """Of a PNG file."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width: int, height: int, bits: int, colours: int, data: bytes) -> bytes:
    """With any claims."""
    head = struct.pack(">IIBBBBB", width, height, bits, colours, 0, 0, 0)
    palette = chunk(b"PLTE", bytes(48)) if colours == 3 else b""
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + palette + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def jpeg(width: int, height: int, frame: int) -> bytes:
    """A real one with another size and kind of frame."""
    stream = io.BytesIO()
    GREY.save(stream, "jpeg", progressive=frame == 0xC2)
    data = bytearray(stream.getvalue())
    at = data.index(b"\xff\xc2" if frame == 0xC2 else b"\xff\xc0")
    data[at + 1] = frame
    data[at + 5:at + 9] = struct.pack(">HH", height, width)
    return bytes(data)


NOTHING = zlib.compress(bytes(10_000_000), 9)


def tiff_of(width: int, height: int, compression: int, tile: int = 0) -> bytes:
    """Ten kilobytes that claim a size."""
    tags: Tags = {259: (SHORT, [compression])}
    return tiff(width, height, [NOTHING], tags | ({322: (LONG, [tile]), 323: (LONG, [tile])} if tile else {}))


BOMBS = {
    "grey.png": png(30000, 30000, 8, 0, NOTHING), "1 bit.png": png(30000, 30000, 1, 0, NOTHING),
    "16 bits.png": png(30000, 30000, 16, 6, NOTHING), "palette.png": png(30000, 30000, 4, 3, NOTHING),
    "baseline.jpg": jpeg(30000, 30000, 0xC0), "progressive.jpg": jpeg(30000, 30000, 0xC2),
    "plain.tif": tiff_of(30000, 30000, 1), "lzw.tif": tiff_of(30000, 30000, 5), "deflate.tif": tiff_of(30000, 30000, 8),
    "packbits.tif": tiff_of(30000, 30000, 32773),
    "a.bmp": b"BM" + struct.pack("<IIIIiiHHIIIIII", 10000, 0, 54, 40, 30000, -30000, 1, 24, 0, 0, 0, 0, 0, 0) + NOTHING,
    "a.pgm": b"P5 30000 30000 255\n" + NOTHING, "text.pgm": b"P2 30000 30000 255\n" + b"1 " * 5000,
    "a.pam": b"P7\nWIDTH 30000\nHEIGHT 30000\nDEPTH 3\nMAXVAL 255\nTUPLTYPE RGB\nENDHDR\n" + NOTHING,
    "text.pbm": b"P1 30000 30000\n" + b"1" * 5000,
}


@pytest.fixture(scope="session", name="idle_bytes")
def _idle_bytes(inputs: Path) -> int:
    """What the program takes with an image of a few pixels."""
    return measured_run(["thinbench", "holes", "tiny.pgm"], inputs)[1]


@pytest.mark.parametrize("kind", BOMBS)
def test_bombs_are_refused_by_their_headers(kind: str, idle_bytes: int, tmp_path: Path) -> None:
    """10 KB that claim 30,000 x 30,000 pixels take no memory."""
    (tmp_path / kind).write_bytes(BOMBS[kind])
    words = READERS[sorted(BOMBS).index(kind) % len(READERS)].split()
    result, peak = measured_run(["thinbench", *(word.format(kind) for word in words)], tmp_path)
    result.assert_failed("bytes, too few for 30000 x 30000 pixels")
    assert peak < idle_bytes + (4 << 20)
    assert list(files_in(tmp_path)) == [kind]


def test_batch_refuses_bombs_and_does_the_rest(idle_bytes: int, tmp_path: Path) -> None:
    """All at once."""
    (tmp_path / "in").mkdir()
    for kind, data in BOMBS.items():
        (tmp_path / "in" / f"{kind.replace('.', ' ')}.png").write_bytes(data)
    GREY.save(tmp_path / "in" / "right.png")
    result, peak = measured_run(["thinbench", "batch", "holes", "in", "--out", "out", "--threads", "2"], tmp_path)
    assert result.status == 1 and f"1 image done, {len(BOMBS)} failed".encode() in result.out, result
    assert len(re.findall(b"too few for 30000 x 30000 pixels", result.err)) == len(BOMBS)
    assert peak < idle_bytes + (16 << 20)
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"right.json", "manifest.csv"}


@pytest.mark.parametrize("name, data, says", [
    ("arithmetic coding.jpg", jpeg(300, 200, 0xC9), "arithmetic coding"),
    ("large tiles.tif", tiff_of(16, 16, 8, 16384), "its tiles of 16384 x 16384 pixels are larger than its 16 x 16"),
    ("no pixels.png", png(0, 5, 8, 0, NOTHING), "damaged"),
    ("colours.png", png(5, 5, 8, 7, NOTHING), "damaged"),
    ("bits.png", png(5, 5, 3, 0, NOTHING), "damaged"),
    ("huge.png", png(2**31 - 1, 2**31 - 1, 1, 0, NOTHING), "pixels|damaged"),
    ("huge.tif", tiff_of(2**32 - 1, 2**32 - 1, 8), "pixels|damaged"),
    ("huge.pgm", b"P5 99999999999999999999 2 255\n", "damaged|pixels"),
    ("negative.pgm", b"P5 -5 5 255\n" + b"1" * 99, "damaged"),
    ("huge.pam", b"P7\nWIDTH 3\nHEIGHT 9223372036854775807\nDEPTH 3\nMAXVAL 255\nENDHDR\n", "damaged|pixels"),
], ids=lambda value: value if isinstance(value, str) else "")
def test_hostile_headers_give_one_line(name: str, data: bytes, says: str, tmp_path: Path) -> None:
    """And take no time."""
    (tmp_path / name).write_bytes(data)
    expect_rejected(f"holes '{name}'", tmp_path, says)


def test_limit_of_pixels_can_be_lowered(tmp_path: Path) -> None:
    """For services."""
    GREY.save(tmp_path / "a.png")
    lower = Fault("", environment={"THINBENCH_MAX_PIXELS": "59999"})
    GREY.convert("1").save(tmp_path / "bits.tif")
    for words in ("holes a.png", "run thin_guo_hall bits.tif out.tif"):
        run(["thinbench", *words.split()], tmp_path, lower).assert_failed(
            "it has more pixels than THINBENCH_MAX_PIXELS=59999 allows")


# Memory: what the file, the image and the operation need, 10 % and, to find more in images of this size, 4 MB instead of 64.

SIDE = 4000


def save_one_strip(path: Path) -> None:
    """Compressed."""
    size, TiffImagePlugin.STRIP_SIZE = TiffImagePlugin.STRIP_SIZE, 1 << 30
    parts(SIDE, SIDE).save(path, compression="tiff_lzw")
    TiffImagePlugin.STRIP_SIZE = size


LARGE: dict[str, tuple[Callable[[Path], object], float]] = {
    "large.png": (lambda path: parts(SIDE, SIDE).save(path, compress_level=1), 0),
    "large.jpg": (lambda path: parts(SIDE, SIDE).save(path), 0),
    "colour.png": (lambda path: parts(SIDE, SIDE).convert("RGB").save(path, compress_level=1), 3),
    "large.pgm": (lambda path: parts(SIDE, SIDE).save(path), 1),
    "large.tif": (lambda path: parts(SIDE, SIDE).save(path), 1),
    "one strip.tif": (save_one_strip, 0),
    "progressive.jpg": (lambda path: parts(SIDE, SIDE).save(path, progressive=True), 2),
    "black.png": (lambda path: path.write_bytes(
        png(SIDE, SIDE, 1, 0, zlib.compress(bytes(SIDE * (SIDE // 8 + 1)), 9))), 0),
}
NEEDED = {"run thin_guo_hall {} out.png": 1.25, "run thin_guo_hall {} out.tif": 1.25, "holes {}": 1.2,
          "edges {} out.png": 2, "batch thin_guo_hall {} --out out --threads 1": 1.25,
          "fill-holes {} out.png": 1.2, "localise {}": 2.2, "labels {} out.png": 7, "distance {} out.png": 11,
          "holes {} --threshold local": 2.2, "euler {}": 1, "graph {} --csv out.csv": 11.5,
          "path {} --start 1,1 --goal 3998,3998 --foreground dark": 25, "holes {} --overlay out.png": 6.5}
"""Bytes per pixel: of the image, of edges beside it, of planes of bits, of runs and of graphs."""


@pytest.mark.parametrize("kind", LARGE)
def test_memory(kind: str, idle_bytes: int, tmp_path: Path) -> None:
    """The highest that a program ever held. All commands read one kind, "holes" reads the others."""
    write, decoder = LARGE[kind]
    write(tmp_path / kind)
    for command, needed in NEEDED.items():
        if kind != "large.png" and not command.startswith("holes"):
            continue
        result, peak = measured_run(["thinbench", *(word.format(kind) for word in command.split())], tmp_path)
        assert result.status == 0, result
        allowed = 1.1 * (needed + decoder) * SIDE * SIDE + (4 << 20)
        assert peak - idle_bytes < allowed, (command, (peak - idle_bytes) / SIDE / SIDE)
