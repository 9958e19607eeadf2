"""`binarise` of Python and of the program: one choice, on colours and in uneven light."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

import thinbench
from tests.programs import assert_rejected, run_text as run

cv2 = pytest.importorskip("cv2")
IDENTITY = "B/S012345678"


def steel_on_teal() -> np.ndarray:
    """Red, green, blue: eight steel parts, six of them with a hole, as bright as the paper they lie on."""
    random = np.random.RandomState(3)
    photo = np.full((480, 640, 3), (40, 160, 150), float)
    parts = np.zeros(photo.shape[:2], np.uint8)
    for k in range(8):
        centre = 90 + 150 * (k % 4), 130 + 220 * (k // 4)
        cv2.circle(parts, centre, 50, 255, -1)
        if k < 6:
            cv2.circle(parts, centre, 18, 0, -1)
    photo[parts > 0] = 125, 125, 128
    photo += random.normal(0, 8, photo.shape[:2])[..., None]
    return photo.clip(0, 255).astype(np.uint8)


def page() -> np.ndarray:
    """Grey levels: dark letters on paper that light falls on from the left."""
    image = np.tile(np.linspace(230, 60, 400), (200, 1))
    ink = np.zeros(image.shape, np.uint8)
    for row in range(5):
        cv2.putText(ink, "skeletons of text", (10, 35 + 36 * row), cv2.FONT_HERSHEY_SIMPLEX, 1, 255, 2)
    image[ink > 0] *= 0.5
    return (image + np.random.RandomState(1).normal(0, 2, image.shape)).clip(0, 255).astype(np.uint8)


def written(path: Path, image: np.ndarray) -> Path:
    cv2.imwrite(str(path), image[..., ::-1] if image.ndim == 3 else image)
    return path


def by_program(tmp_path: Path, image: np.ndarray, *options: object) -> np.ndarray:
    made = run("run", IDENTITY, written(tmp_path / "in.png", image), tmp_path / "out.png", *options)
    assert made.returncode == 0, made.stderr
    return cv2.imread(str(tmp_path / "out.png"), cv2.IMREAD_GRAYSCALE) > 0


@pytest.mark.parametrize("channel", ["red", "auto"])
def test_steel_parts_on_teal_paper_have_their_holes(tmp_path, channel):
    photo = written(tmp_path / "parts.png", steel_on_teal())
    assert "8 objects, 6 holes" not in run("holes", photo).stdout
    found = run("holes", photo, "--channel", channel)
    assert found.stdout.startswith("8 objects, 6 holes\n")
    assert (f"note: {photo}: channel is " in found.stderr) == (channel == "auto")


@pytest.mark.parametrize(("command", "out"), [
    ("run thin_guo_hall", ["out.png"]), ("edges", ["out.png"]), ("holes", []), ("graph", []),
    ("batch holes", ["--out", "found"])])
def test_every_command_takes_a_channel_and_says_which_it_took(tmp_path, monkeypatch, command, out):
    monkeypatch.chdir(tmp_path)
    photo = written(tmp_path / "parts.png", steel_on_teal())
    made = run(*command.split(), photo, *out, "--channel", "auto")
    assert made.returncode == 0
    if "batch" in command:
        assert ",8,6," in Path("found/manifest.csv").read_text()
    else:
        assert "channel is saturation" in made.stderr


@pytest.mark.parametrize("channel", ["red", "green", "blue", "saturation", "value", "auto"])
def test_grey_pictures_are_untouched(tmp_path, channel):
    grey = page()
    expected = by_program(tmp_path, grey)
    np.testing.assert_array_equal(by_program(tmp_path, grey, "--channel", channel), expected)
    np.testing.assert_array_equal(thinbench.binarise(np.dstack([grey] * 3), channel=channel), expected)


@pytest.mark.parametrize("options", [{}, {"foreground": "dark"}, {"threshold": 100}, {"threshold": "local"},
                                     {"threshold": "local", "window": 31, "offset": 4},
                                     {"threshold": "local", "foreground": "bright"}])
@pytest.mark.parametrize("channel", ["red", "green", "blue", "saturation", "value", "auto", "grey"])
@pytest.mark.parametrize(("dtype", "levels"), [(np.uint8, (0, 256)), (np.uint16, (600, 1000))])
def test_python_equals_the_program(tmp_path, channel, options, dtype, levels):
    photo = np.random.RandomState(5).randint(*levels, (41, 57, 3)).astype(dtype)
    photo[10:30, 20:40] //= 3
    if dtype == np.uint16 and options.get("threshold") == 100:
        options = options | {"threshold": 700}
    words = [word for name, value in options.items() for word in (f"--{name}", value)]
    found = thinbench.binarise(photo, channel=channel, **options)
    np.testing.assert_array_equal(found, by_program(tmp_path, photo, "--channel", channel, *words))
    opaque = np.dstack([photo, np.full(photo.shape[:2], np.iinfo(dtype).max, dtype)])
    np.testing.assert_array_equal(thinbench.binarise(opaque, channel=channel, **options), found)


def test_the_manifest_has_no_threshold_where_it_is_local(tmp_path):
    path = written(tmp_path / "page.png", page())
    for words, threshold in ((["--threshold", "99"], "99"), (["--threshold", "local"], "")):
        run("batch", "edges", path, "--out", tmp_path / words[1], *words)
        (row,) = csv.DictReader((tmp_path / words[1] / "manifest.csv").open())
        assert row["threshold"] == threshold and row["foreground"]


def test_a_page_in_uneven_light_needs_a_local_threshold(tmp_path):
    path = written(tmp_path / "page.png", page())
    whole = run("holes", path, "--min-area", 20)
    assert "warning: " in whole.stderr and "--threshold local" in whole.stderr
    local = run("holes", path, "--min-area", 20, "--threshold", "local")
    assert "foreground is dark" in local.stderr and "warning: " not in local.stderr
    letters = 5 * len("skeletonsoftext")
    assert abs(int(local.stdout.split()[0]) - letters) < abs(int(whole.stdout.split()[0]) - letters)
    assert int(local.stdout.split()[0]) == letters


def test_crop_and_blur(tmp_path):
    grey = page()
    found = by_program(tmp_path, grey, "--crop", "10,20,100x50", "--threshold", 100, "--foreground", "bright")
    np.testing.assert_array_equal(found, grey[20:70, 10:110] >= 100)
    found = by_program(tmp_path, grey, "--blur", 1.5, "--threshold", 100, "--foreground", "bright")
    smooth = cv2.GaussianBlur(grey, (0, 0), 1.5, borderType=cv2.BORDER_REPLICATE)
    np.testing.assert_array_equal(found, smooth >= 100)


@pytest.mark.parametrize("words, said", [
    (["--channel", "rde"], "rde"), (["--crop", "1,1,9999x2"], "is not inside the image of 400 x 200 pixels"),
    (["--crop", "1,1"], "expected X,Y,WIDTHxHEIGHT"), (["--crop", "0,0,0x5"], "got '0,0,0x5'"),
    (["--crop", "9999999999,1,9999999999x1"], "is not inside"), (["--blur", "-1"], "[0, 100]"),
    (["--blur", "nan"], "[0, 100]"), (["--threshold", "local", "--window", "4"], "odd integer in [3, 65535]"),
    (["--window", "5"], "needs --threshold local"), (["--threshold", "local", "--offset", "256"], "[0, 255]")])
def test_the_program_rejects_what_does_not_fit_in_one_line(tmp_path, words, said):
    path = written(tmp_path / "page.png", page())
    assert_rejected(said, "run", "thin_guo_hall", path, tmp_path / "out.png", *words)
    assert not (tmp_path / "out.png").exists()


SKIMAGE_FINE = ["camera.png", "cell.png", "clock_motion.png", "horse.png", "moon.png", "phantom.png",
                "hubble_deep_field.jpg", "retina.jpg", "bw_text.png", "logo.png"]
SKIMAGE_WRONG = ["page.png", "text.png", "coins.png", "grass.png", "gravel.png", "coffee.png", "rocket.jpg"]


@pytest.mark.parametrize("name", SKIMAGE_FINE + SKIMAGE_WRONG)
def test_the_warning_tells_wrong_from_right(name):
    skimage = pytest.importorskip("skimage")
    path = Path(skimage.data_dir) / name
    if not path.exists():
        pytest.skip(f"{path} is not there")
    assert ("the two classes overlap" in run("holes", path).stderr) == (name in SKIMAGE_WRONG)


def test_bool_is_0_and_255():
    picture = np.random.RandomState(5).rand(20, 30) < .2
    np.testing.assert_array_equal(thinbench.binarise(picture), picture)
    np.testing.assert_array_equal(thinbench.binarise(picture, foreground="dark", threshold=255), ~picture)


@pytest.mark.parametrize("shape", [(0, 0), (0, 5), (1, 1), (0, 4, 3), (3, 0, 4)])
def test_empty_and_small_images(shape):
    assert thinbench.binarise(np.zeros(shape, np.uint8), channel="auto").shape == shape[:2]
