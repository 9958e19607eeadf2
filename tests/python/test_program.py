"""The commands of the program do what the functions of Python do; pictures of all kinds; pipes."""

from __future__ import annotations

import base64
import csv
import json
import subprocess
from xml.etree import ElementTree

import numpy as np
import pytest

import thinbench
from images import random_image
from tests.programs import assert_rejected, run

cv2 = pytest.importorskip("cv2")
pil = pytest.importorskip("PIL.Image")


@pytest.fixture
def picture(tmp_path):
    path = tmp_path / "a picture.png"
    image = np.pad(random_image(8), 3)
    cv2.imwrite(str(path), image * np.uint8(255))
    return path, image


def made(*words: object, data: bytes | None = None) -> subprocess.CompletedProcess[bytes]:
    done = run(*words, "--foreground", "bright", data=data)
    assert done.returncode == 0, done.stderr
    return done


def test_commands_equal_the_functions_of_python(picture, tmp_path):
    path, image = picture
    out = tmp_path / "out.png"
    made("fill-holes", path, out)
    np.testing.assert_array_equal(cv2.imread(str(out), -1) != 0, thinbench.fill_holes(image))
    made("fill-holes", path, out, "--connectivity", 4, "--max-area", 30)
    np.testing.assert_array_equal(cv2.imread(str(out), -1) != 0,
                                  thinbench.fill_holes(image, connectivity=4, max_area=30))
    for name in ("out.png", "out.tif", "out.pgm"):
        for connectivity in (4, 8):
            made("labels", path, tmp_path / name, "--connectivity", connectivity)
            found = cv2.imread(str(tmp_path / name), -1)
            assert found.dtype == np.uint16
            np.testing.assert_array_equal(found, thinbench.label_image(image, connectivity=connectivity)[0])
        made("distance", path, tmp_path / name)
        np.testing.assert_array_equal(cv2.imread(str(tmp_path / name), -1), np.rint(thinbench.distances(image)))
    for connectivity in (4, 8):
        number = thinbench.euler_number(image, connectivity=connectivity)
        assert int(made("euler", path, "--connectivity", connectivity).stdout) == number
    listed = json.loads(made("localise", path, "--json", "--brightness-threshold", 128).stdout)
    table = thinbench.localise_objects(255 - image * np.uint8(255))
    assert [one["area"] for one in listed["objects"]] == list(table["area"][~table["is_hole"]])


def test_tables_of_holes_and_localise_are_alike_as_csv_and_json(picture, tmp_path):
    path, image = picture
    height, width = image.shape
    for command in ("holes", "localise"):
        table = tmp_path / "table.csv"
        found = json.loads(made(command, path, "--json", "--csv", table).stdout)
        assert (found["file"], found["page"], found["width"], found["height"]) == (str(path), 1, width, height)
        rows = list(csv.DictReader(table.open(newline="")))
        objects = {row["id"]: row for row in rows if row["kind"] == "object"}
        assert len(objects) == len(found["objects"])
        for one in found["objects"]:
            row = objects[str(one["id"])]
            assert (row["file"], row["image_width"], row["image_height"]) == (str(path), str(width), str(height))
            assert int(row["area"]) == one["area"] and float(row["centre_x"]) == pytest.approx(one["centre"][0])
            assert [int(row[name]) for name in ("left", "top", "width", "height")] == one["box"]
            holes = [int(row["id"]) for row in rows if row["enclosing_object"] == str(one["id"])]
            assert holes == [hole["id"] for hole in one["holes"]]


def test_the_table_of_a_graph_has_the_file_and_the_size(picture, tmp_path):
    path, image = picture
    found = json.loads(made("graph", path, "--json", "--csv", tmp_path / "graph.csv").stdout)
    assert (found["file"], found["width"], found["height"]) == (str(path), image.shape[1], image.shape[0])
    rows = list(csv.DictReader((tmp_path / "graph.csv").open(newline="")))
    assert len(rows) == len(found["edges"])
    kinds = {node["id"]: node["kind"] for node in found["nodes"]}
    for row, edge in zip(rows, found["edges"]):
        assert (row["file"], row["page"], row["image_width"]) == (str(path), "1", str(image.shape[1]))
        assert [int(row[name]) for name in ("id", "from", "to", "pixels")] == [
            edge[name] for name in ("id", "from", "to", "pixels")]
        ends = [int(row[name]) for name in ("start_x", "start_y", "stop_x", "stop_y")]
        assert ends == edge["points"][0] + edge["points"][-1]
        assert (row["from_kind"], row["to_kind"]) == (kinds[edge["from"]], kinds[edge["to"]])
        assert [float(row[name]) for name in ("length", "chord", "width_mean", "width_min", "width_max")] == [
            edge[name] for name in ("length", "chord", "width_mean", "width_min", "width_max")]


PLACES = {"holes": [], "localise": [], "graph": [], "path": ["--start", "0,0", "--goal", "9,0"]}
"""Commands that draw, and what they need."""


def test_geojson_is_what_the_program_writes(tmp_path):
    labels = np.pad(np.repeat([[3, 0, 200, 200]], 9, axis=0).repeat(5, axis=1), 2).astype(np.uint8)
    cv2.imwrite(str(tmp_path / "a.png"), labels)
    assert run("graph", tmp_path / "a.png", "--labels", "--spacing", "3,2", "--geojson", tmp_path / "a.json").returncode == 0
    graph = thinbench.graph_of_labels(thinbench.thin_labels(labels), labels, spacing=(2, 3))
    assert graph.to_geojson() == json.loads((tmp_path / "a.json").read_text())


@pytest.fixture
def rings(tmp_path):
    """A free way along the upper border, and three objects with a hole each."""
    image = np.zeros((60, 120), np.uint8)
    image[:3] = 255
    for x in (5, 45, 80):
        cv2.rectangle(image, (x, 15), (x + 25, 45), 255, 6)
    path = tmp_path / "rings.png"
    cv2.imwrite(str(path), image)
    return path, image


@pytest.mark.parametrize("command", PLACES)
def test_overlays_are_images_or_svg_by_their_names(rings, tmp_path, command):
    path, image = rings
    words = [command, path, *PLACES[command]]
    listed = made(*words).stdout
    for name in ("a.png", "a.tif", "a.bmp", "a.PNG"):
        assert made(*words, "--overlay", tmp_path / name).stdout == listed
        drawn = cv2.imread(str(tmp_path / name))
        assert drawn.shape == (*image.shape, 3)
        assert (drawn.min(axis=2) != drawn.max(axis=2)).any()  # something has a colour
    made(*words, "--overlay", tmp_path / "a.svg")
    svg = ElementTree.parse(tmp_path / "a.svg").getroot()
    assert svg.get("viewBox") == "0 0 120 60"
    ground = svg.find("{*}image").get("{*}href") or svg.find("{*}image").get("href")
    ground = cv2.imdecode(np.frombuffer(base64.b64decode(ground.partition(",")[2]), np.uint8), -1)
    np.testing.assert_array_equal(ground, image)
    count = {"holes": 4 + 3, "localise": 4 + 3, "graph": 4, "path": 2}[command]  # lines, without crosses
    lines = svg.findall(".//{*}polygon" if command in ("holes", "localise") else ".//{*}polyline")
    assert len(lines) == count
    for name in ("a.jpg", "a.pgm", "a", "a.txt"):
        assert_rejected("", *words, "--overlay", tmp_path / name, status=(2,))
        assert not (tmp_path / name).exists()


@pytest.mark.parametrize("words", [[*map(str, (name, "-", *more)), "--overlay", "-"] for name, more in PLACES.items()]
                         + [["graph", "-", "--out", "-"]])
def test_an_overlay_on_standard_output_is_png_and_the_list_moves(rings, tmp_path, words):
    path, _ = rings
    piped = made(*words, data=path.read_bytes())
    option = words[-2]
    listed = made(*[path if word == "-" else word for word in words[:-2]], option, tmp_path / "a.png").stdout
    assert piped.stdout == (tmp_path / "a.png").read_bytes() and listed in piped.stderr


def test_packed_files_read_and_write_the_standard_streams(picture, tmp_path):
    path, image = picture
    pil.fromarray(image).save(tmp_path / "a.pbm")
    packed = (tmp_path / "a.pbm").read_bytes()
    for options, data in (([], packed), (["--raw", f"{image.shape[1]}x{image.shape[0]}"], np.packbits(image, 1).tobytes())):
        (tmp_path / "in").write_bytes(data)
        out = tmp_path / "out.pbm"
        assert run("run", "thin_guo_hall", tmp_path / "in", out, *options).returncode == 0
        expected = out.read_bytes()
        out.unlink()
        assert run("run", "thin_guo_hall", "-", out, *options, data=data).returncode == 0
        assert out.read_bytes() == expected
        if options:
            assert run("run", "thin_guo_hall", "-", "-", *options, data=data).stdout == expected


@pytest.mark.parametrize("words", [["run", "thin_guo_hall"], ["edges"], ["fill-holes"], ["labels"], ["distance"]])
def test_a_pipe_reads_standard_input_and_writes_png(picture, tmp_path, words):
    path, _ = picture
    made(*words, path, tmp_path / "out.png")
    assert made(*words, "-", "-", data=path.read_bytes()).stdout == (tmp_path / "out.png").read_bytes()


@pytest.mark.parametrize("words", [["holes"], ["localise"], ["euler"], ["graph"]])
def test_lists_read_standard_input(picture, words):
    path, _ = picture
    assert made(*words, "-", data=path.read_bytes()).stdout == made(*words, path).stdout


def test_a_full_standard_output_is_an_error(picture):
    with open("/dev/full", "wb") as full:
        failed = run("fill-holes", picture[0], "-", stdout=full)
    assert failed.returncode == 1 and b"standard output cannot be written" in failed.stderr


def square():
    grey = np.zeros((20, 30), np.uint8)
    grey[5:10, 5:10] = 255
    return pil.fromarray(grey)


def transparent_picture(kind):
    """Of a square, and what Pillow needs to save it with transparent pixels."""
    image = square().convert(kind)
    if kind in ("LA", "RGBA"):
        image.putalpha(square())
        return image, {}
    return image, {"transparency": {"1": 0, "L": 0, "P": b"\0\xff", "RGB": (0, 0, 0)}[kind]}


@pytest.mark.parametrize("kind", ["LA", "RGBA", "1", "L", "P", "RGB"])
def test_a_transparent_image_brings_a_warning(tmp_path, kind):
    path = tmp_path / "logo.png"
    image, how = transparent_picture(kind)
    image.save(path, **how)
    found = run("holes", path)
    assert f"warning: {path}: the image is transparent" in found.stderr.decode() and b"1 object," in found.stdout
    assert b"warning: -: the image is transparent" in run("holes", "-", data=path.read_bytes()).stderr
    assert run("batch", "holes", path, "--out", tmp_path / "out").returncode == 0
    assert "the image is transparent" in (tmp_path / "out" / "manifest.csv").read_text()


@pytest.mark.parametrize("kind, how", [("RGBA", {}), ("L", {"transparency": 7}), ("RGB", {"transparency": (1, 2, 3)}),
                                       ("P", {"transparency": b"\xff\xff"})])
def test_an_opaque_image_brings_none(tmp_path, kind, how):
    square().convert(kind).save(tmp_path / "a.png", **how)
    assert b"transparent" not in run("holes", tmp_path / "a.png").stderr


FILES = {
    "white.png": lambda path: cv2.imwrite(str(path), np.full((5, 5), 255, np.uint8)),
    "empty": lambda path: path.touch(),
    "text": lambda path: path.write_bytes(b"no picture"),
    "zeros": lambda path: path.write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(40))}


@pytest.mark.parametrize("words, status, said", [
    *((f"{words} -", 2, "expected the name of a file, got '-'") for words in (
        "holes a.pbm --csv", "localise a.pbm --csv", "graph a.pbm --csv", "graph a.pbm --geojson",
        "rule golay_l --save", "batch holes a.pbm --out out --table")),
    *((f"run {word} a.pbm out.png", 2, f"'{word}' is done by 'thinbench {command}'\n") for word, command in (
        ("edges_sobel", "edges --operator sobel"), ("holes", "holes"), ("fill_holes", "fill-holes"),
        ("euler_number", "euler"), ("localise_objects", "localise"), ("labels", "labels"),
        ("graph", "graph"), ("path", "path"))),
    ("graph a.pbm --out - --overlay -", 2, ""),
    *((f"{words} - --json", 2, "--json is printed on standard output") for words in (
        "graph a.pbm --out", "graph a.pbm --overlay", "holes a.pbm --overlay",
        "path a.pbm --start 1,1 --goal 2,2 --overlay")),
    ("distance a.pbm out.png --spacing 0.0001", 1, "so all become 0; give --spacing in a smaller unit"),
    ("run thin_guo_hall - out.pbm --raw 999x999 < a.pbm", 1, "cannot read standard input: it has"),
    ("run thin_guo_hall - - < empty", 1, "standard input: the file is empty"),
    ("run thin_guo_hall - - < text", 1, "standard input: it is not an image of a known format"),
    ("run thin_guo_hall - - < zeros", 1, "standard input"),
    ("distance white.png out.png --foreground bright", 1, "all of it is foreground")])
def test_what_cannot_be_is_one_line_and_makes_no_file(picture, tmp_path, monkeypatch, words, status, said):
    monkeypatch.chdir(tmp_path)
    pil.fromarray(picture[1]).save("a.pbm")
    for name, write in FILES.items():
        if name in words.split():
            write(tmp_path / name)
    before = set(tmp_path.iterdir())
    words, _, stdin = words.partition(" < ")
    assert_rejected(said, *words.split(), status=(status,), data=(tmp_path / stdin).read_bytes() if stdin else None)
    assert set(tmp_path.iterdir()) == before
