"""The page for browsers, in Chromium: its pixels are those of the native library."""

from __future__ import annotations

import gzip
import io
import os
import re
import struct
import time
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

import thinbench
from tests import browser

ROOT = Path(__file__).resolve().parents[2]
PAGE = Path(os.environ.get("THINBENCH_PAGE", ROOT / "build" / "web" / "index.html"))
pytestmark = browser.needs_chromium
SCENE = ROOT / "results" / "pictures" / "scene.jpg"


class Page(browser.Page):
    """Its settings, and what it saves."""

    def __init__(self, directory: Path) -> None:
        super().__init__()
        self.directory = directory
        self.driver.execute_cdp_cmd("Browser.setDownloadBehavior",
                                    {"behavior": "allow", "downloadPath": str(directory)})

    def open(self, width: int = 1300, dark: bool = False) -> None:
        self.look(PAGE.as_uri(), width, dark)
        self.until("document.getElementById('rule').value")

    def find(self, name: str) -> Any:
        return self.driver.find_element(By.ID, name)

    def settle(self) -> None:
        """Waits until what was asked for is shown."""
        self.until("!isRunning && !isStale && waiting.size === 0")
        assert not self.failed(), self.status()

    def status(self) -> str:
        return str(self.find("status").get_attribute("textContent"))

    def failed(self) -> bool:
        return "failed" in self.find("status").get_attribute("class")

    def choose(self, path: Path) -> None:
        self.value("(window.shownBefore = document.getElementById('status').textContent = '') || 1")
        self.find("file").send_keys(str(path))
        self.until("document.getElementById('status').textContent && !isRunning && waiting.size === 0"
                   " && !document.getElementById('status').textContent.startsWith('Reading')")

    def set(self, **values: object) -> None:
        """Changes settings as a reader does, without waiting in between."""
        for name, value in values.items():
            self.driver.execute_script("""
                const field = document.getElementById('settings').elements[arguments[0]];
                if (field instanceof RadioNodeList) document.getElementById(arguments[1]).checked = true;
                else field.value = arguments[1];
                (field[0]?.type === 'radio' ? field[0] : field).dispatchEvent(new Event('input', {bubbles: true}));
                """, name, str(value))
        self.settle()

    def show(self, path: Path, **settings: object) -> None:
        """Opens the page with a picture and these settings."""
        self.open()
        self.choose(path)
        self.set(**settings)

    def save(self, kind: str) -> bytes:
        """What a click on the button saves."""
        self.find(kind).click()
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            files = [one for one in self.directory.iterdir() if one.suffix == f".{kind}"]
            if files:
                content = files[0].read_bytes()
                files[0].unlink()
                return content
            time.sleep(0.02)
        raise AssertionError(f"no {kind} was saved")

    def png(self) -> Any:
        return np.asarray(Image.open(io.BytesIO(self.save("png"))).convert("RGB"))

    def table(self) -> list[list[str]]:
        return [line.split(",") for line in self.save("csv").decode().splitlines()]


@pytest.fixture(scope="module", name="page")
def _page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    page = Page(tmp_path_factory.mktemp("saved"))
    yield page
    page.driver.quit()


def discs(width: int, height: int, seed: int) -> Any:
    """Rings and discs, with grey levels between them."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[:height, :width]
    image = np.full((height, width), 30.0)
    for _ in range(12):
        distance = np.hypot(x - random.uniform(0, width), y - random.uniform(0, height))
        image = np.maximum(image, 220 / (1 + np.exp(np.minimum(distance - random.uniform(4, 30), 50))))
        image = np.where(distance < random.uniform(0, 6), 20, image)
    return (image + random.uniform(0, 12, image.shape)).astype(np.uint8)


def in_colours(width: int, height: int, seed: int) -> Any:
    return np.stack([discs(width, height, seed + i) for i in range(3)], axis=-1)


def noise(width: int, height: int, density: float) -> Any:
    return (np.random.default_rng(7).random((height, width)) < density).astype(np.uint8) * 255


MADE = {
    "discs": discs(200, 150, 1), "dark": 255 - discs(131, 97, 2), "colours": in_colours(180, 120, 3),
    "noise": noise(257, 129, 0.4), "dense": noise(64, 64, 0.7), "wide": discs(1500, 20, 5), "tall": discs(3, 700, 6),
    "flat": np.full((20, 30), 77, np.uint8), "pixel": np.array([[200]], np.uint8),
}
PICTURES = [*MADE, "scene.jpg", "scene_inverted.jpg", "skeleton.png", "edges_sobel.png"]


@pytest.fixture(scope="module", name="files")
def _files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    directory = tmp_path_factory.mktemp("pictures")
    found = {name: ROOT / "results" / "pictures" / name for name in PICTURES if "." in name}
    for name, pixels in MADE.items():
        found[name] = directory / f"{name}.png"
        Image.fromarray(pixels).save(found[name])
    return found


def pixels_of(path: Path) -> Any:
    return np.asarray(Image.open(path).convert("RGB"))


def is_set(picture: Any) -> Any:
    """Of a PNG with black and white alone."""
    assert set(np.unique(picture)) <= {0, 255}
    return picture[..., 0] > 0


def thinned(**options: Any) -> Callable[[Any], Any]:
    return lambda pixels: thinbench.thin(thinbench.binarise(pixels, **options))


@pytest.mark.parametrize(("name", "settings", "expected"), [
    *((name, {}, thinned()) for name in PICTURES),
    ("scene.jpg", {"prune": 12}, lambda pixels: thinbench.prune(thinned()(pixels), 12)),
    *(("colours", settings, thinned(**options)) for settings, options in (
        ({"foreground": "dark"}, {"foreground": "dark"}), ({"foreground": "bright"}, {"foreground": "bright"}),
        ({"method": "level", "level": 60}, {"threshold": 60}),
        ({"method": "local", "offset": 4}, {"threshold": "local", "offset": 4}),
        *(({"channel": name}, {"channel": name}) for name in ("red", "blue", "saturation", "value", "auto"))))])
def test_skeletons_are_those_of_the_native_library(page, files, name, settings, expected):
    page.show(files[name], **settings)
    skeleton = expected(pixels_of(files[name]))
    assert np.array_equal(is_set(page.png()), skeleton)
    rows = page.table()
    assert rows[0][-2:] == ["x", "y"] and len(rows) == 1 + skeleton.sum()


@pytest.mark.parametrize(("name", "choice", "settings", "expected"), [
    ("discs", "rule", {}, lambda pixels, rule: thinbench.thin(thinbench.binarise(pixels), rule)),
    ("scene.jpg", "edge", {"operation": "edges", "gradient": 30, "brightness": 100},
     lambda pixels, operator: thinbench.detect_edges(pixels[..., 0], operator, 30, 100) > 0)])
def test_every_choice_gives_the_pixels_of_the_native_library(page, files, name, choice, settings, expected):
    page.open()
    page.choose(files[name])
    words = page.value(f"[...document.getElementById('{choice}').options].map(one => one.value)")
    assert len(words) > (20 if choice == "rule" else 2)
    for word in words:
        page.set(**settings, **{choice: word})
        assert np.array_equal(is_set(page.png()), expected(pixels_of(files[name]), word)), word


@pytest.mark.parametrize("name", ["discs", "noise", "scene.jpg"])
def test_objects_and_holes_are_those_of_the_native_library(page, files, name):
    page.show(files[name], operation="holes")
    labels, table = thinbench.label_regions(thinbench.binarise(pixels_of(files[name])))
    rows = [row[3:] for row in page.table()[1:]]
    columns = ["enclosing_object", "area", "centroid-1", "centroid-0", "bbox-1", "bbox-0"]
    assert np.array_equal([[float(cell) for cell in row[2:8]] for row in rows],
                          np.column_stack([table[column] for column in columns]))
    assert [row[0] == "hole" for row in rows] == table["is_hole"].tolist()
    objects = int((~table["is_hole"]).sum())
    green, red = [0, 170, 0], [255, 40, 40]
    colours = np.array([[0, 0, 0], *[green] * objects, *[red] * (len(rows) - objects)])
    assert np.array_equal(page.png(), colours[labels])


def test_small_regions_are_omitted_with_their_holes(page, files):
    page.show(files["scene.jpg"], operation="holes", area=300)
    table = thinbench.find_regions(thinbench.binarise(pixels_of(SCENE)))
    large = table["area"] >= 300
    kept = [i for i in range(len(large)) if large[i]
            and (not table["is_hole"][i] or large[table["enclosing_object"][i] - 1])]
    rows = page.table()[1:]
    assert 0 < len(kept) < len(large)
    assert [int(row[6]) for row in rows] == table["area"][kept].tolist()
    objects = [row for row in rows if row[3] == "object"]
    assert [int(row[4]) for row in objects] == list(range(1, len(objects) + 1))


def test_labels_are_those_of_the_native_library(page, files):
    page.show(files["noise"], operation="labels")
    labels, count = thinbench.label_image(thinbench.binarise(pixels_of(files["noise"])))
    names = re.search(r"labelColours = \[(.*?)\]", (ROOT / "web/worker.js").read_text(encoding="utf-8"), re.DOTALL)
    assert names
    colours = [[int(name[i:i + 2], 16) for i in (0, 2, 4)] for name in re.findall(r"#(\w{6})", names[1])]
    expected = np.array([[0, 0, 0], *(colours[i % len(colours)] for i in range(count))])[labels]
    assert np.array_equal(page.png(), expected)
    assert len(page.table()) == 1 + count


@pytest.mark.parametrize(("name", "prune"), [("scene.jpg", 0), ("scene.jpg", 15), ("noise", 0)])
def test_graphs_are_those_of_the_native_library(page, files, name, prune):
    page.show(files[name], operation="graph", prune=prune)
    binary = thinbench.binarise(pixels_of(files[name]))
    skeleton = thinbench.prune(thinbench.thin(binary), prune)
    graph = thinbench.skeleton_graph(skeleton, binary, not_thin="ignore")
    rows = np.array([[float(cell) for cell in [*row[4:6], *row[13:]]] for row in page.table()[1:]])
    edges = graph.edges
    expected = np.column_stack([edges["from"] + 1, edges["to"] + 1,
                                *(edges[column] for column in ("length", "chord", "width-mean", "width-median",
                                                               "width-min", "width-max"))])
    assert np.array_equal(rows[:, :2], expected[:, :2])
    np.testing.assert_allclose(rows[:, 2:], expected[:, 2:], rtol=1e-14)
    assert np.array_equal(page.png().any(axis=-1), skeleton)
    drawing = ElementTree.fromstring(page.save("svg"))
    names = [one.tag.partition("}")[2] for one in drawing.iter()]
    assert names.count("polyline") == len(rows) and names.count("circle") == len(graph.nodes["kind"])


def test_svg_has_the_pixels_of_the_result(page, files):
    page.show(files["discs"])
    drawing = ElementTree.fromstring(page.save("svg"))
    drawn = np.zeros((150, 200), bool)
    for path in drawing.iter("{http://www.w3.org/2000/svg}path"):
        for begin, y, end in re.findall(r"M(\d+) (\d+)\.5H(\d+)", path.attrib["d"]):
            drawn[int(y), int(begin):int(end)] = True
    assert np.array_equal(drawn, thinbench.thin(thinbench.binarise(pixels_of(files["discs"]))))


def test_what_is_transparent_counts_as_white(page, tmp_path):
    pixels = np.zeros((40, 50, 4), np.uint8)
    pixels[10:30, 12:40, 3] = 255
    Image.fromarray(pixels).save(tmp_path / "bar.png")
    page.show(tmp_path / "bar.png")
    assert np.array_equal(is_set(page.png()), thinbench.thin(pixels[..., 3] > 0))


def chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def huge_png() -> bytes:
    """10,000 x 5,001 pixels of one bit, in a few kilobytes."""
    header = struct.pack(">IIBBBBB", 10000, 5001, 1, 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(bytes(1251 * 5001))) + chunk(b"IEND", b""))


BAD = {"empty.png": b"", "text.png": b"This is no picture.\n", "truncated.png": None, "huge.png": huge_png(),
       "script.svg": b"<svg xmlns='http://www.w3.org/2000/svg' onload='alert(1)'><script>alert(1)</script></svg>"}


@pytest.mark.parametrize("name", BAD)
def test_a_bad_file_gives_one_line_and_the_next_one_is_read(page, files, tmp_path, name):
    content = BAD[name]
    whole = files["colours"].read_bytes()
    (tmp_path / name).write_bytes(whole[:60] if content is None else content)
    page.open()
    page.choose(tmp_path / name)
    assert page.failed()
    line = page.status()
    assert line.startswith(f"{name}: ") and len(line) > len(name) + 20 and "\n" not in line
    if name == "huge.png":
        assert "expected at most 50 megapixels, got 10000 x 5001 pixels" in line
    page.choose(files["discs"])
    page.settle()
    assert page.png().shape == (150, 200, 3)


def test_a_wrong_number_gives_one_line_and_the_next_one_works(page, files):
    page.show(files["discs"])
    page.find("prune").clear()
    page.find("prune").send_keys("-3")
    page.until("document.getElementById('status').textContent.includes(\"'-3'\")")
    assert page.status() == ("Remove branches shorter than (pixels): expected a whole number from 0 to 100000, "
                             "got '-3'")
    page.set(prune=5)
    assert "Objects" in page.status()


@pytest.mark.parametrize("event", ["paste", "drop"])
def test_a_picture_is_pasted_or_dropped(page, event):
    page.open()
    page.driver.execute_async_script("""
        const done = arguments[1], canvas = new OffscreenCanvas(60, 40), context = canvas.getContext('2d');
        context.fillStyle = '#000';
        context.fillRect(10, 10, 30, 12);
        canvas.convertToBlob().then(blob => {
          const data = new DataTransfer();
          data.items.add(new File([blob], 'given.png', {type: 'image/png'}));
          dispatchEvent(arguments[0] === 'paste' ? new ClipboardEvent('paste', {clipboardData: data})
                                                 : new DragEvent('drop', {dataTransfer: data, cancelable: true}));
          done();
        });""", event)
    page.until("document.getElementById('status').textContent.includes('Objects: 1')")
    assert page.png().shape == (40, 60, 3)


def test_all_of_it_works_by_keyboard(page, files):
    page.open()
    page.value("document.getElementById('sample').focus()")
    page.driver.switch_to.active_element.send_keys(Keys.ENTER)
    page.until("size && after")
    reached = set()
    for _ in range(40):
        ActionChains(page.driver).send_keys(Keys.TAB).perform()
        reached.add(page.driver.switch_to.active_element.get_attribute("id"))
    assert reached >= {"file", "sample", "thin", "rule", "prune", "foreground", "method", "channel", "out", "fit",
                       "in", "png", "svg", "csv", "masked", "over", "before", "after"}
    page.find("thin").send_keys(Keys.ARROW_RIGHT)
    page.until("after?.operation === 'holes'")
    assert "Holes: 5" in page.status()
    scale = page.value("view.scale")
    page.find("after").send_keys("+")
    page.until(f"view.scale > {scale}")
    x = page.value("view.x")
    page.find("after").send_keys(Keys.ARROW_RIGHT)
    page.until(f"view.x > {x}")
    page.find("after").send_keys("0")
    page.until(f"view.scale === {scale}")


def test_every_control_has_a_name(page):
    page.open()
    nameless = page.value("[...document.querySelectorAll('input, select, button, canvas, [role=region]')].filter(one =>"
                          " !one.labels?.length && !one.ariaLabel && !(one.matches('button') && one.textContent))"
                          ".map(one => one.id)")
    assert nameless == []


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize("width", [360, 820, 1300])
def test_nothing_overflows_whatever_is_done(page, files, width, dark):
    page.open(width, dark)
    page.choose(files["wide"])
    for operation in ("thin", "holes", "labels", "graph", "edges"):
        page.set(operation=operation)
        page.value("document.querySelector('details').open = true")
        assert page.value("innerWidth") == width
        assert page.value("document.documentElement.scrollWidth") <= width
    assert all(page.contrast(words, "page") >= 4.5 for words in ("ink", "muted", "accent", "warn", "bad"))


def test_the_page_lives_while_it_computes_and_the_latest_settings_win(page, tmp_path):
    Image.fromarray(noise(3000, 2000, 0.5)).save(tmp_path / "large.png")
    page.open()
    page.choose(tmp_path / "large.png")
    page.value("(window.frames_ = 0, window.tick = () => { ++frames_; if (isRunning) setTimeout(tick, 5) }) && 1")
    page.set(operation="graph")
    page.driver.execute_script("""
        const field = document.getElementById('settings').elements;
        for (const name of ['edges', 'holes', 'thin', 'labels']) {
          document.getElementById(name).checked = true;
          field.operation[0].dispatchEvent(new Event('input', {bubbles: true}));
        }
        tick();""")
    page.settle()
    assert page.value("after.operation") == "labels"
    assert page.value("frames_") > 5


def test_the_page_needs_no_network_and_says_nothing_to_the_console(page, files):
    page.errors()
    page.show(files["scene.jpg"])
    addresses = page.value("performance.getEntriesByType('resource').map(one => one.name)")
    assert [one for one in addresses if not one.startswith(("blob:", "data:"))] == []
    assert page.errors() == []


def test_the_page_is_one_file_of_at_most_a_megabyte():
    assert len(gzip.compress(PAGE.read_bytes())) <= 1_000_000
