"""What image files mean that no other program writes as test_judged_formats.py has it: levels of pixels, each file made
here byte by byte or by Pillow."""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from conftest import SEED, expect_rejected, run
from PIL import Image

Samples = npt.NDArray[Any]
WHOLE = "--threshold 1 --foreground bright --min-area 2147483647 --overlay shown.png".split()


def shown(path: Path) -> Samples:
    """The grey levels of an image, in 8 bits."""
    result = run(["thinbench", "holes", path.name, *WHOLE], path.parent)
    assert result.status == 0, (SEED, path, result)
    return np.asarray(Image.open(path.parent / "shown.png"))[..., 0]


def facts(path: Path, *options: str) -> dict[str, object]:
    """What is found."""
    result = run(["thinbench", "holes", path.name, "--json", *options], path.parent)
    assert result.status == 0, result
    found: dict[str, object] = json.loads(result.out)
    return found | {"remarks": result.err.decode()}


def objects(path: Path, *options: str) -> int:
    """How many."""
    found = facts(path, *options)["objects"]
    assert isinstance(found, list)
    return len(found)


# TIFF.

TEXT, SHORT, LONG, DOUBLE = 2, 3, 4, 12
SIZES = {TEXT: "B", SHORT: "H", LONG: "I", DOUBLE: "d"}
Tags = dict[int, tuple[int, Sequence[float]]]


def tiff(width: int, height: int, blocks: Sequence[bytes], tags: Tags) -> bytes:
    """Of these strips or tiles, little-endian and not compressed unless the tags say so."""
    is_tiled = 322 in tags
    offsets = [8 + sum(map(len, blocks[:i])) for i in range(len(blocks))]
    every: Tags = {256: (LONG, [width]), 257: (LONG, [height]), 258: (SHORT, [8]), 259: (SHORT, [1]),
                   262: (SHORT, [1]), 277: (SHORT, [1]), 278: (LONG, [height]),
                   324 if is_tiled else 273: (LONG, offsets),
                   325 if is_tiled else 279: (LONG, [len(block) for block in blocks])} | tags
    data = b"".join(blocks)
    data += b"\0" * (len(data) % 2)
    entries, more = b"", b""
    end = 8 + len(data) + 2 + 12 * len(every) + 4
    for tag in sorted(every):
        kind, values = every[tag]
        packed = struct.pack(f"<{len(values)}{SIZES[kind]}", *values)
        if len(packed) > 4:
            more += packed
            packed = struct.pack("<I", end + len(more) - len(packed))
        entries += struct.pack("<HHI", tag, kind, len(values)) + packed.ljust(4, b"\0")
    count = struct.pack("<H", len(every))
    return b"II*\0" + struct.pack("<I", 8 + len(data)) + data + count + entries + bytes(4) + more


def shorts(*values: int) -> bytes:
    return struct.pack(f"<{len(values)}H", *[v % 65536 for v in values])


EXTRA, FORMAT, PHOTOMETRIC, SAMPLES, BITS = 338, 339, 262, 277, 258
GREY, RGB, PALETTE, YCBCR, LAB = 1, 2, 3, 6, 8


def of(kind: int, samples: int, bits: int) -> Tags:
    """Pixels of such samples."""
    return {PHOTOMETRIC: (SHORT, [kind]), SAMPLES: (SHORT, [samples]), BITS: (SHORT, [bits] * samples)}


TIFFS: dict[str, tuple[bytes, list[list[int]]]] = {
    "16 bits with signs": (tiff(4, 1, [shorts(-1, 0, 300, 32767)], of(GREY, 1, 16) | {FORMAT: (SHORT, [2])}),
                           [[0, 0, 1, 128]]),
    "16 bits with signs but no negative number": (
        tiff(3, 1, [shorts(0, 1, 255)], of(GREY, 1, 16) | {FORMAT: (SHORT, [2])}), [[0, 1, 255]]),
    "grey multiplied by its opacity": (
        tiff(2, 1, [b"\x20\x40\xc8\xff"], of(GREY, 2, 8) | {EXTRA: (SHORT, [1])}), [[32, 200]]),
    "12 bits with opacity": (tiff(2, 1, [b"\x0f\xff\xff\x0f\xf8\x00"], of(GREY, 2, 12) | {EXTRA: (SHORT, [2])}),
                             [[0xFF, 0x80]]),
    "palette of 16 bits": (
        tiff(2, 1, [shorts(0, 40000)],
             of(PALETTE, 1, 16) | {320: (SHORT, ([0] * 40000 + [25700] + [0] * 25535) * 3)}),
        [[0, 100]]),
    "YCbCr with few hues": (
        tiff(4, 2, [b"\x0a\x14\x1e\x28\x80\x80" b"\x32\x3c\x46\x50\x80\x80"],
             of(YCBCR, 3, 8) | {530: (SHORT, [2, 2])}),
        [[10, 20, 50, 60], [30, 40, 70, 80]]),
    "Lab": (tiff(2, 1, [b"\0\0\0\xff\0\0"], of(LAB, 3, 8)),
            [[0, 249]]),  # libtiff's white point; ImageMagick says 255
    "a strip of more rows than there are": (
        tiff(2, 2, [bytes([1, 2, 3, 255])], {278: (LONG, [2**31 - 1])}), [[1, 2], [3, 255]]),
    "32 bits above 65535": (tiff(3, 1, [struct.pack("<3I", 0, 10**6, 2 * 10**6)], of(GREY, 1, 32)), [[0, 127, 255]]),
    "real numbers": (tiff(4, 1, [struct.pack("<4f", -1, float("nan"), 0, 1)], of(GREY, 1, 32) | {FORMAT: (SHORT, [3])}),
                     [[0, 0, 127, 255]]),
    "opacity after another sample": (tiff(2, 1, [b"\x20\1\xff\xc8\2\0"], of(GREY, 3, 8) | {EXTRA: (SHORT, [0, 2])}),
                                     [[32, 0]]),
    "the same in planes": (tiff(2, 1, [b"\x20\xc8", b"\1\2", b"\xff\0"],
                                of(GREY, 3, 8) | {EXTRA: (SHORT, [0, 2]), 284: (SHORT, [2])}), [[32, 0]]),
}


@pytest.mark.parametrize("compression", [33003, 34712, 34892, 50013, 65000])
def test_unknown_compression_is_named(compression: int, tmp_path: Path) -> None:
    (tmp_path / "a.tif").write_bytes(tiff(2, 2, [bytes(4)], {259: (SHORT, [compression])}))
    expect_rejected("holes a.tif", tmp_path, f"its compression {compression}.* is not supported")


@pytest.mark.parametrize("compression", ["group3", "group4", "tiff_lzw", "tiff_adobe_deflate", "packbits"])
@pytest.mark.parametrize("out", ["out.png", "out.tif"])
def test_damaged_tiff_is_rejected_and_leniently_read(compression: str, out: str, tmp_path: Path) -> None:
    noise = np.random.RandomState(0).rand(200, 300) < .5
    Image.fromarray(noise).save(tmp_path / "a.tif", compression=compression)
    data = bytearray((tmp_path / "a.tif").read_bytes())
    data[len(data) // 3:len(data) // 3 + 40] = b"\xff\0" * 20 if compression == "packbits" else bytes(40)
    if compression == "packbits":  # whatever its bytes, they mean pixels: too few of them
        data = bytearray(tiff(300, 200, [bytes(data[8:3000])], {259: (SHORT, [32773]), BITS: (SHORT, [1])}))
    (tmp_path / "a.tif").write_bytes(data)
    words = ["thinbench", "run", "thin_guo_hall", "a.tif", out]
    run(words, tmp_path).assert_failed("cannot read 'a.tif': ")
    result = run([*words, "--lenient"], tmp_path)
    assert result.status == 0 and b"warning: a.tif: " in result.err, result


def test_rows_too_long_for_the_decoder_are_one_line_with_the_name(tmp_path: Path) -> None:
    (tmp_path / "a.tif").write_bytes(tiff(2**30 + 9, 9, [b"\xb4\xae\xaa"], {259: (SHORT, [2]), BITS: (SHORT, [1])}))
    for out, says in (("out.tif", "there is not enough memory for it"), ("out.png", "it has more than 2\\^31 pixels")):
        run(["thinbench", "run", "thin_guo_hall", "a.tif", out], tmp_path).assert_failed(f"cannot read 'a.tif': {says}")


def test_map_keeps_its_coordinates(tmp_path: Path) -> None:
    line = np.zeros((9, 9), np.uint8)
    line[4, 2:7] = 255
    keys = [1, 1, 0, 2, 1025, 0, 1, 1, 3072, 0, 1, 25832]
    (tmp_path / "a.tif").write_bytes(tiff(9, 9, [line.tobytes()], {
        33550: (DOUBLE, [0.5, 0.5, 0]), 33922: (DOUBLE, [0, 0, 0, 4500000, 5400000, 0]), 34735: (SHORT, keys)}))
    result = run(["thinbench", "graph", "a.tif", "--geojson", "a.json", "--crop", "1,0,8x9"], tmp_path)
    assert result.status == 0 and b"GeoTIFF tags, EPSG:25832" in result.err, result
    found = json.loads((tmp_path / "a.json").read_text())
    assert found["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::25832"
    assert [feature["geometry"]["coordinates"] for feature in found["features"]][:2] == [
        [4500001.25, 5399997.75], [4500003.25, 5399997.75]]
    run(["thinbench", "graph", "a.tif", "--geojson", "a.json", "--transform", "1,0,0,0,1,0"], tmp_path)
    assert "crs" not in json.loads((tmp_path / "a.json").read_text())


@pytest.mark.parametrize("orientation", range(1, 9))
def test_map_that_is_turned_keeps_its_coordinates(orientation: int, tmp_path: Path) -> None:
    line = np.zeros((5, 9), np.uint8)
    line[1, 2:7] = 255
    (tmp_path / "a.tif").write_bytes(tiff(9, 5, [line.tobytes()], {
        274: (SHORT, [orientation]), 33550: (DOUBLE, [0.5, 2, 0]), 33922: (DOUBLE, [0, 0, 0, 100, 200, 0])}))
    assert run(["thinbench", "graph", "a.tif", "--geojson", "a.json"], tmp_path).status == 0
    features = json.loads((tmp_path / "a.json").read_text())["features"]
    ends = sorted(feature["geometry"]["coordinates"] for feature in features[:2])
    assert ends == [[101.25, 197], [103.25, 197]]


@pytest.mark.parametrize("keys, epsg", [
    ({1024: 1, 2048: 4326, 3072: 25832}, 25832), ({1024: 2, 2048: 4326}, 4326), ({2048: 4326}, 4326),
    ({1024: 1, 2048: 4326}, None), ({1024: 1, 2048: 4326, 3072: 32767}, None), ({1024: 3, 2048: 4978}, None)])
def test_only_the_system_of_the_coordinates_is_named(keys: dict[int, int], epsg: int | None, tmp_path: Path) -> None:
    entries = [number for key, value in sorted(keys.items()) for number in (key, 0, 1, value)]
    (tmp_path / "a.tif").write_bytes(tiff(3, 3, [bytes([0, 0, 0, 0, 255, 0, 0, 0, 0])], {
        33550: (DOUBLE, [1, 1, 0]), 33922: (DOUBLE, [0] * 6), 34735: (SHORT, [1, 1, 0, len(keys), *entries])}))
    assert run(["thinbench", "graph", "a.tif", "--geojson", "a.json"], tmp_path).status == 0
    crs = json.loads((tmp_path / "a.json").read_text()).get("crs", {"properties": {"name": "none"}})
    assert crs["properties"]["name"].split(":")[-1] == str(epsg or "none")


def test_lengths_of_a_map_have_a_spacing_and_its_coordinates_remain(tmp_path: Path) -> None:
    (tmp_path / "a.tif").write_bytes(tiff(3, 3, [bytes([0, 0, 0, 255, 255, 255, 0, 0, 0])], {
        33550: (DOUBLE, [0.5, 0.5, 0]), 33922: (DOUBLE, [0, 0, 0, 100, 200, 0])}))
    assert run(["thinbench", "graph", "a.tif", "--geojson", "a.json", "--spacing", "0.5"], tmp_path).status == 0
    line = json.loads((tmp_path / "a.json").read_text())["features"][-1]
    assert line["properties"]["length"] == 1
    assert line["geometry"]["coordinates"] == [[100.25, 199.25], [101.25, 199.25]]


# Several images in a file.

def test_smaller_copies_and_masks_are_no_pages(tmp_path: Path) -> None:
    tifffile = pytest.importorskip("tifffile")
    page = np.zeros((40, 40), np.uint8)
    page[10:30, 10:30] = 255
    with tifffile.TiffWriter(tmp_path / "a.tif") as file:
        for kind, image in ((0, page), (1, page[::2, ::2]), (4, page > 0), (2, page)):
            file.write(image, subfiletype=kind, metadata=None)
    assert run(["thinbench", "batch", "holes", "a.tif", "--out", "out"], tmp_path).status == 0
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["a_page1.json", "a_page4.json", "manifest.csv"]


def test_a_page_that_cannot_be_read_is_an_error(tmp_path: Path) -> None:
    page = Image.new("L", (9, 9))
    page.save(tmp_path / "a.tif", save_all=True, append_images=[page, page])
    data = bytearray((tmp_path / "a.tif").read_bytes())
    first, = struct.unpack_from("<I", data, 4)
    entries, = struct.unpack_from("<H", data, first)
    second, = struct.unpack_from("<I", data, first + 2 + 12 * entries)
    width = data.index(struct.pack("<HH", 256, LONG), second)
    struct.pack_into("<HHI", data, width, 256, TEXT, 9)
    (tmp_path / "a.tif").write_bytes(data)
    result = run(["thinbench", "batch", "holes", "a.tif", "--out", "out"], tmp_path)
    assert result.status == 1 and b"'a.tif': its page 2 cannot be read" in result.err, result
    assert (tmp_path / "out/a_page1.json").exists() and not (tmp_path / "out/a_page2.json").exists()


# Numbers of files.

REAL, SIGNED = 3, 2
NODATA = 42113


def row(numbers: npt.NDArray[Any], channels: int = 1, more: Tags | None = None) -> bytes:
    """A TIFF file of these samples in a row of pixels."""
    kind = {"f": REAL, "i": SIGNED, "u": 1}[numbers.dtype.kind]
    tags = of(GREY, channels, 8 * numbers.itemsize) | {FORMAT: (SHORT, [kind] * channels)} | (more or {})
    return tiff(numbers.size // channels, 1, [numbers.tobytes()], tags)


LOWEST = float(np.finfo(np.float32).min)


@pytest.mark.parametrize("numbers, threshold, bright", [
    (np.float32([-9999, 0, 199.99, 200, 300]), "200", 2),
    (np.float32([-9999, 0, 199.99, 200, 300]), "199.98", 3),
    (np.float32([LOWEST, 100, 100]), "200", 0),
    (np.float32([LOWEST, 100, 100]), "50", 2),
    (np.float32([-0.2, 0.5, 0.7, 0.69]), "0.7", 1),
    (np.float32([1, 2.5, np.nan]), "1", 2),
    (np.float32([1, 2.5]), "-50", 2),
    (np.float32([1, 2.5]), "1e6", 0),
    (np.float32([7, 7]), "7.5", 0),
    (np.float64([-1.797e308, 3, 4]), "3.5", 1),
    (np.float64([-1e39, 3, 4]), "3.5", 1),
    (np.float64([0, 1e39, 2e39]), "1.5e39", 1),
    (np.float64([-1e300, -1e-300, 1e-300]), "0", 1),
    (np.float64([1700000000, 1700000050, 1700000100.5]), "1700000050", 2),
    (np.float64([20000000, 20000001, 20000002]), "20000001", 2),
    (np.float32([0, 65535]), "-1", 2),
    (np.uint32([0, 65535]), "65536", 0),
    (np.uint32([0, 1, 2**32 - 1]), "4294967296", 0),
    (np.int32([-5, 0, 5, 100000]), "0", 3),
    (np.int8([-5, 0, 100]), "300", 0),
    (np.uint32([0, 99, 100, 131070]), "100", 2),
    (np.uint32([0, 99, 100, 131070]), "131070", 1),
    (np.uint32([3, 5]), "100000", 0),
    (np.int16([-300, -50, -51, 200]), "-50", 2),
    (np.int16([-1, 20, 250]), "20.5", 1),
    (np.uint16([1, 2, 3]), "1.5", 2),
    (np.uint8([1, 2, 3]), "2.5", 1)])
def test_thresholds_are_numbers_of_the_file(numbers: npt.NDArray[Any], threshold: str, bright: int, tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    path.write_bytes(row(numbers))
    found = facts(path, "--threshold", threshold, "--foreground", "bright")
    parts: Any = found["objects"]
    assert (sum(part["area"] for part in parts), found["threshold"]) == (bright, float(threshold))


@pytest.mark.parametrize("numbers, least", [
    (np.float32([-9999, 5.5, 6, 90]), 6), (np.int16([-9999, -3, 6, 90]), 6), (np.int32([-9999, 5, 6, 90]), 6),
    (np.float64([-9999] * 6 + [1000, 1200]), 1000), (np.int16([-9999] * 6 + [1000, 1200]), 1000)])
def test_nodata_is_the_least_number(numbers: npt.NDArray[Any], least: int, tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    path.write_bytes(row(numbers, more={NODATA: (TEXT, b"-9999\0")}))
    found = facts(path)
    parts: Any = found["objects"]
    assert (sum(part["area"] for part in parts), "bright" in str(found["foreground"])) == (1, True)
    assert least < float(str(found["threshold"])) <= numbers[-1]


@pytest.mark.parametrize("numbers, text", [
    *((np.array([-9999, 1000, 1000, 2000], kind), "-9999") for kind in (np.int16, np.int32, np.float32, np.float64)),
    (np.float32([LOWEST, 1000.5, 1000, 2000]), "-3.40282346638529e+38"),
    (np.float64([-np.finfo(float).max, 1000.5, 1000, 2000]), " -1.7976931348623157e+308 "),
    (np.float32([np.nan, 1000.5, 1000, 2000]), "1000.#IND")])
@pytest.mark.parametrize("threshold, bright", [("-20000", 3), ("0", 3), ("1", 3), ("1000", 3), ("1500", 1), ("2001", 0)])
def test_nodata_is_below_any_threshold(numbers: npt.NDArray[Any], text: str, threshold: str, bright: int,
                                       tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    path.write_bytes(row(numbers, more={NODATA: (TEXT, text.encode() + b"\0")}))
    found: Any = facts(path, "--threshold", threshold, "--foreground", "bright")["objects"]
    assert sum(part["area"] for part in found) == bright


@pytest.mark.parametrize("data", [
    row(np.float32([-9999, -9999]), more={NODATA: (TEXT, b"-9999\0")}),
    row(np.float32([np.nan, np.nan])),
    row(np.int32([-9999, -9999]), more={NODATA: (TEXT, b"-9999\0")}),
    row(np.float32([1, 0, 2, 0]), 2, {EXTRA: (SHORT, [2])})], ids=["nodata", "NaN", "integers", "transparent"])
@pytest.mark.parametrize("threshold", ["otsu", "-20000", "0", "0.5", "1e6"])
def test_a_tile_without_numbers_has_no_objects(data: bytes, threshold: str, tmp_path: Path) -> None:
    (tmp_path / "a.tif").write_bytes(data)
    assert objects(tmp_path / "a.tif", "--threshold", threshold) == 0


@pytest.mark.parametrize("kind, opaque", [(np.int16, 32767), (np.float32, 255), (np.uint32, 255), (np.uint32, 2**32 - 1)])
def test_opacity_is_no_number_of_the_picture(kind: type, opaque: int, tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    path.write_bytes(row(np.array([100, opaque, 300, opaque, 300, 0], kind), 2, {EXTRA: (SHORT, [2])}))
    for threshold, bright in (("200", 1), ("100", 2), ("301", 0)):
        found: Any = facts(path, "--threshold", threshold, "--foreground", "bright")["objects"]
        assert sum(part["area"] for part in found) == bright
    assert objects(path, "--channel", "alpha", "--threshold", "1", "--foreground", "bright") == 1


@pytest.mark.parametrize("samples, threshold, bright", [
    (np.float32([0, 0, 500, .25, 700, .75, 1000, 1]), ".5", 2),
    (np.int16([-500, 0, -500, 1000, 900, 800, 3, 32767]), "800", 3),
    (np.uint32([1, 0, 2, 100, 3, 128, 4, 255]), "128", 2),
    (np.uint8([1, 0, 2, 100, 3, 128, 4, 255]), "128", 2)])
def test_opacity_has_numbers_of_its_own(samples: npt.NDArray[Any], threshold: str, bright: int, tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    path.write_bytes(row(samples, 2, {EXTRA: (SHORT, [2]), NODATA: (TEXT, b"800\0")}))
    found: Any = facts(path, "--channel", "alpha", "--threshold", threshold, "--foreground", "bright")["objects"]
    assert sum(part["area"] for part in found) == bright


def test_inks_are_not_signed(tmp_path: Path) -> None:
    tags = of(5, 4, 8) | {FORMAT: (SHORT, [SIGNED] * 4)}
    (tmp_path / "a.tif").write_bytes(tiff(2, 1, [bytes(8)], tags))
    expect_rejected("holes a.tif", tmp_path, "its photometric interpretation 5 has signed samples")


@pytest.mark.parametrize("command", ["edges", "localise", "holes"])
def test_a_threshold_above_all_levels_of_8_bits_is_read(command: str, tmp_path: Path) -> None:
    (tmp_path / "a.tif").write_bytes(row(np.arange(256, dtype=np.int16)))
    out = ["b.png"] if command == "edges" else []
    assert run(["thinbench", command, "a.tif", *out, "--threshold", "300"], tmp_path).status == 0


def test_one_negative_number_leaves_the_contrast(tmp_path: Path) -> None:
    for name, lowest in (("a", 0), ("b", -1)):
        levels = two_parts(20, 250, 250).astype(np.int16)
        levels[0, 0] = lowest
        (tmp_path / f"{name}.tif").write_bytes(
            tiff(100, 60, [levels.tobytes()], of(GREY, 1, 16) | {FORMAT: (SHORT, [SIGNED])}))
        assert run(["thinbench", "edges", f"{name}.tif", f"{name}.png"], tmp_path).status == 0
    assert np.asarray(Image.open(tmp_path / "a.png"))[5:].any()
    np.testing.assert_array_equal(Image.open(tmp_path / "a.png"), Image.open(tmp_path / "b.png"))


# 16 bits.

def two_parts(low: int, first: int, second: int) -> npt.NDArray[np.uint16]:
    image = np.full((60, 100), low, np.uint16)
    image[10:40, 10:40] = first
    image[20:50, 60:90] = second
    return image


@pytest.mark.parametrize("kind", ["png", "tif", "pgm"])
def test_levels_of_16_bits_are_those_of_the_file(kind: str, tmp_path: Path) -> None:
    path = tmp_path / f"a.{kind}"
    levels = two_parts(530, 680, 690)
    if kind == "pgm":
        path.write_bytes(b"P5 100 60 4095\n" + levels.astype(">u2").tobytes())
    else:
        Image.fromarray(levels).save(path)
    found = facts(path)
    assert (objects(path), found["threshold"]) == (2, 531)
    note = f"note: {path.name}: 16 bits, levels 530 to 690; foreground is bright (grey level >= 531)"
    assert note in str(found["remarks"])
    assert objects(path, "--threshold", "685") == 1
    assert objects(path, "--threshold", "local", "--window", "101") == 2


def test_masks_of_labels_and_own_outputs_are_read_again(tmp_path: Path) -> None:
    Image.fromarray(two_parts(0, 1, 2)).save(tmp_path / "labels16.png")
    assert objects(tmp_path / "labels16.png") == 2
    outputs = [("labels", "b.png"), ("labels", "b.tif"), ("distance", "c.png"), ("distance --float", "c.tif")]
    for command, out in outputs:
        words = command.split()
        assert run(["thinbench", words[0], "labels16.png", out, *words[1:]], tmp_path).status == 0
        assert objects(tmp_path / out) == 2, out


def test_edges_of_16_bits_are_those_of_their_upper_8(tmp_path: Path) -> None:
    deep = two_parts(40, 200, 220) * 257
    Image.fromarray(deep).save(tmp_path / "a.png")
    Image.fromarray((deep >> 8).astype(np.uint8)).save(tmp_path / "b.png")
    for name in ("a", "b"):
        assert run(["thinbench", "edges", f"{name}.png", f"{name}_edges.png"], tmp_path).status == 0
    assert (tmp_path / "a_edges.png").read_bytes() == (tmp_path / "b_edges.png").read_bytes()


def test_threshold_beyond_the_levels_of_8_bits(tmp_path: Path) -> None:
    Image.fromarray(two_parts(0, 200, 255).astype(np.uint8)).save(tmp_path / "a.png")
    expect_rejected("holes a.png --threshold 256", tmp_path, "--threshold: expected up to 255")


def test_many_labels_take_32_bits(tmp_path: Path) -> None:
    dots = np.zeros((600, 600), np.uint8)
    dots[::2, ::2] = 255
    Image.fromarray(dots).save(tmp_path / "dots.png")
    words = ["thinbench", "labels", "dots.png"]
    run([*words, "out.png"], tmp_path).assert_failed("labels up to 90000")
    assert run([*words, "out.tif"], tmp_path).status == 0
    labels = np.asarray(Image.open(tmp_path / "out.tif"))
    assert labels.max() == 90000 and labels[598, 598] == 90000
    graph = run(["thinbench", "graph", "out.tif", "--labels", "--thinning", "none"], tmp_path)
    assert graph.out.startswith(b"90000 nodes (90000 isolated), 0 edges"), graph.out[:99]


def test_distances_as_real_numbers(tmp_path: Path) -> None:
    Image.fromarray(two_parts(0, 255, 255).astype(np.uint8)).save(tmp_path / "a.png")
    assert run(["thinbench", "distance", "a.png", "d.tif", "--float", "--spacing", "0.25"], tmp_path).status == 0
    found = np.asarray(Image.open(tmp_path / "d.tif"))
    assert found.dtype == np.float32 and found.max() == 3.75 and found[10, 10] == .25
    run(["thinbench", "distance", "a.png", "d.png", "--float"], tmp_path).assert_failed("only .tif and .tiff", status=2)


# BMP.

def bmp(bits: int, compression: int, masks: bytes, pixels: bytes, width: int, height: int, size: int = 40,
        colours: bytes = b"") -> bytes:
    """`masks` belong to the header where that is larger than 40 bytes, else they follow it."""
    used = len(colours) // 4
    head = struct.pack("<IiiHHIIiiII", size, width, height, 1, bits, compression, len(pixels), 0, 0, used, 0)
    head = (head + masks).ljust(size, b"\0") + colours
    return b"BM" + struct.pack("<IHHI", 14 + len(head) + len(pixels), 0, 0, 14 + len(head)) + head + pixels


GREYS = b"".join(bytes([i, i, i, 0]) for i in range(256))
M565, M555 = struct.pack("<3I", 0xF800, 0x7E0, 0x1F), struct.pack("<3I", 0x7C00, 0x3E0, 0x1F)
BMPS: dict[str, tuple[bytes, list[list[int]]]] = {
    "masks of 32 bits": (bmp(32, 3, struct.pack("<3I", 0xFF000000, 0xFF0000, 0xFF00),
                             struct.pack("<4I", 0xFFFFFF00, 0xFF000000, 0x00FF0000, 0), 4, 1), [[255, 76, 150, 0]]),
    "masks beyond 24 bits": (bmp(24, 3, struct.pack("<3I", *[0xFF000000] * 3), b"\xff" * 6 + b"\0\0", 2, 1), [[0, 0]]),
    "4-4-4": (bmp(16, 3, struct.pack("<3I", 0xF00, 0xF0, 0xF), shorts(0xFFF, 0x888, 0, 0), 4, 1), [[255, 136, 0, 0]]),
    "5-5-5-1": (bmp(16, 3, M555 + struct.pack("<I", 0x8000), shorts(0xFFFF, 0xBDEF, 0x8000, 0x8000), 4, 1, 56),
                [[255, 123, 0, 0]]),
    "version 4": (bmp(16, 3, M565, shorts(0xFFFF, 0), 2, 1, 108), [[255, 0]]),
    "version 5": (bmp(24, 0, b"", b"\7\7\7\xc8\xc8\xc8\0\0", 2, 1, 124), [[7, 200]]),
    "top row first": (bmp(8, 0, b"", b"\1\2\0\0\3\4\0\0", 2, -2, colours=GREYS), [[1, 2], [3, 4]]),
    "2 bits": (bmp(2, 0, b"", b"\x1b\0\0\0", 4, 1, colours=GREYS[:8] + GREYS[396:400] + GREYS[-4:]), [[0, 1, 99, 255]]),
    "runs with padded rows": (bmp(8, 1, b"", bytes([6, 200, 2, 0, 0, 0]) * 4 + b"\0\1", 6, 4, colours=GREYS),
                              [[200] * 6] * 4),
    "runs of 4 bits, single pixels and steps": (
        bmp(4, 2, b"", b"\3\x12\0\0" b"\0\3\x34\x50" b"\0\2\1\1" b"\1\x60\0\1", 5, 3, colours=GREYS[:64]),
        [[0, 0, 0, 0, 6], [3, 4, 5, 0, 0], [1, 2, 1, 0, 0]]),
    "OS/2": (b"BM" + struct.pack("<IHHIIHHHH", 34, 0, 0, 32, 12, 2, 1, 1, 1) + b"\0\0\0\xff\xff\xff" b"\x40\0\0\0",
             [[0, 255]]),
}


@pytest.mark.parametrize("name, data, levels", [
    *(("a.tif", *made) for made in TIFFS.values()), *(("a.bmp", *made) for made in BMPS.values())],
    ids=[*TIFFS, *BMPS])
def test_files_mean_these_levels(name: str, data: bytes, levels: list[list[int]], tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(data)
    assert shown(tmp_path / name).tolist() == levels


def test_bmp_that_is_not_read_says_why(tmp_path: Path) -> None:
    (tmp_path / "a.bmp").write_bytes(bmp(0, 4, b"", b"\xff\xd8", 1, 1))
    expect_rejected("holes a.bmp", tmp_path, "holds a JPEG or PNG file")
    (tmp_path / "a.bmp").write_bytes(bmp(8, 1, b"", b"\6\1", 6, 4, colours=GREYS))
    expect_rejected("holes a.bmp", tmp_path, "truncated")


# Palettes and transparency.


def test_palette_files_hold_labels(tmp_path: Path) -> None:
    labels = np.zeros((9, 20), np.uint8)
    labels[4, 2:8], labels[4, 11:18] = 1, 2
    image = Image.fromarray(labels, "P")
    image.putpalette([0, 0, 0, 255, 0, 0, 0, 255, 0])
    for name in ("a.png", "a.bmp", "a.tif"):
        image.save(tmp_path / name)
        result = run(["thinbench", "graph", name, "--labels", "--thinning", "none"], tmp_path)
        assert result.status == 0 and b"label 2" in result.out, result


def write_drawing(path: Path) -> None:
    """Black, in the channel of opacity alone."""
    ink = np.zeros((60, 100, 4), np.uint8)
    ink[10:40, 10:40, 3] = ink[20:50, 60:90, 3] = 255
    if path.suffix == ".bmp":
        masks = struct.pack("<4I", 0xFF0000, 0xFF00, 0xFF, 0xFF000000)
        path.write_bytes(bmp(32, 3, masks, ink[::-1].tobytes(), 100, 60, 108))
    else:
        Image.fromarray(ink).save(path)


@pytest.mark.parametrize("name", ["a.png", "a.tif", "a.bmp"])
def test_drawing_in_the_opacity_alone(name: str, tmp_path: Path) -> None:
    write_drawing(tmp_path / name)
    found = facts(tmp_path / name)
    assert found["objects"] == []
    assert "--background black or white, or --channel alpha, takes it otherwise" in str(found["remarks"])
    assert objects(tmp_path / name, "--channel", "alpha") == 2
    assert objects(tmp_path / name, "--background", "white") == 2
    assert objects(tmp_path / name, "--background", "black") == 0
    assert "warning: a" not in str(facts(tmp_path / name, "--channel", "alpha")["remarks"])


def test_opacity_that_is_not_there(tmp_path: Path) -> None:
    Image.new("L", (3, 3)).save(tmp_path / "a.png")
    expect_rejected("holes a.png --channel alpha", tmp_path, "--channel alpha: it has no transparency")


# Pixels that are all alike.

def test_colours_of_one_grey_level_are_told_apart_by_channel_auto(tmp_path: Path) -> None:
    colours = np.full((60, 100, 3), (255, 0, 0), np.uint8)
    colours[10:40, 10:40] = (0, 130, 0)
    for name in ("a.png", "a.tif", "a.bmp"):
        Image.fromarray(colours).save(tmp_path / name)
        remarks = str(facts(tmp_path / name)["remarks"])
        assert "its colours have the same grey level; --channel auto tells them apart" in remarks
        assert objects(tmp_path / name, "--channel", "auto") == 1
    Image.new("RGB", (5, 5), (255, 0, 0)).save(tmp_path / "a.png")
    assert "--channel" not in str(facts(tmp_path / "a.png")["remarks"])


def test_one_grey_level_is_named_as_the_file_has_it(tmp_path: Path) -> None:
    Image.fromarray(np.full((5, 5), 480, np.uint16)).save(tmp_path / "a.png")
    assert "the same grey level, 480: none is foreground" in str(facts(tmp_path / "a.png")["remarks"])
    Image.new("L", (5, 5), 200).save(tmp_path / "a.png")
    assert "the same grey level, 200: none is foreground" in str(facts(tmp_path / "a.png")["remarks"])


# Holes drawn in time that their number takes.

def test_overlay_of_many_holes(tmp_path: Path) -> None:
    """Quadratic time would be minutes: a million holes of one object."""
    plate = np.full((4002, 4002), 255, np.uint8)
    plate[2::4, 2::4] = 0
    Image.fromarray(plate).save(tmp_path / "a.png", compress_level=1)
    words = "thinbench holes a.png --threshold 128 --foreground bright --min-area 1 --overlay out.png"
    result = run(words.split(), tmp_path)
    assert result.status == 0 and result.out.startswith(b"1 object, 1000000 holes"), result.out[:99]
    drawn = np.asarray(Image.open(tmp_path / "out.png"))
    assert (drawn[2402, 2402] == [255, 40, 40]).all() and (drawn[2401, 2402] == [255, 40, 40]).all()
