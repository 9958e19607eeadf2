"""`path` of Python and of the program: of least cost, wide enough everywhere, one line where there is none."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import thinbench
from tests.programs import ROOT, assert_rejected, run_text

sys.path.insert(0, str(ROOT / "python" / "examples"))
pytest.importorskip("matplotlib")
planning = pytest.importorskip("path_planning")
cv2 = pytest.importorskip("cv2")
ndimage = pytest.importorskip("scipy.ndimage")


@pytest.fixture
def plan(tmp_path):
    free = planning.floor_plan()
    path = tmp_path / "plan.png"
    cv2.imwrite(str(path), free * np.uint8(255))
    return path, free


def xy(point):
    return f"{point[1]},{point[0]}"


def assert_is_path(found, free, start, goal, width):
    assert tuple(found[0]) == tuple(start) and tuple(found[-1]) == tuple(goal)
    assert (np.abs(np.diff(found, axis=0)).max(axis=1, initial=0) == 1).all() or len(found) == 1
    assert free[tuple(found.T)].all()
    assert (room_at_halves(free)[tuple((2 * found).T)] >= width).all()
    assert (room_at_halves(free)[tuple((found[1:] + found[:-1]).T)] >= width).all()


def length(path):
    return np.hypot(*np.diff(path, axis=0).T).sum()


def room_at_halves(free):
    """Twice the distance from obstacles, at pixels and halfway between them."""
    fine = np.ones([2 * side - 1 for side in free.shape])
    fine[::2, ::2] = free
    return np.full(fine.shape, np.inf) if free.all() else ndimage.distance_transform_edt(fine)


@pytest.mark.parametrize("width", [16, 32])
def test_the_robots_of_the_floor_plan(plan, tmp_path, width):
    path, free = plan
    found = thinbench.find_path(free, planning.START, planning.GOAL, width)
    assert_is_path(found, free, planning.START, planning.GOAL, width)
    overlay = tmp_path / "path.png"
    made = run_text("path", path, "--start", xy(planning.START), "--goal", xy(planning.GOAL), "--width", width, "--json",
               "--overlay", overlay)
    assert made.returncode == 0, made.stderr
    listed = json.loads(made.stdout)
    np.testing.assert_array_equal(np.array(listed["points"])[:, ::-1], found)
    assert listed["length"] == pytest.approx(length(found)) and listed["min_width"] >= width
    skeleton = thinbench.prune(thinbench.thin(free), min_widths=1, image=free)
    by_steps = planning.plan_path(free, skeleton, width, planning.START, planning.GOAL)
    assert length(found) == pytest.approx(length(by_steps), rel=0.005)
    assert cv2.imread(str(overlay)).shape == (*free.shape, 3)


def test_free_space_of_more_than_half_a_map_is_nothing_doubtful(plan):
    for options in ([], ["--foreground", "bright"]):
        made = run_text("path", plan[0], "--start", xy(planning.START), "--goal", xy(planning.GOAL), *options)
        assert made.returncode == 0 and "warning" not in made.stderr


@pytest.mark.parametrize("words, said", [
    (["--start", "640,5", "--goal", "590,80"],
     "start 640,5 is outside the map of 640 x 480 pixels; free space is "),
    (["--start", "40", "--goal", "590,80"], "--start: expected X,Y such as 120,45, got '40'"),
    (["--start", "-1,5", "--goal", "590,80"], "--start"),
    (["--start", "4,5", "--goal", "99999999999,80"], "--goal: expected X,Y"),
    (["--start", "40,150"], "--goal"),
    (["--start", "40,150", "--goal", "590,80", "--width", "-2"], "--width"),
    (["--start", "40,150", "--goal", "590,80", "--overlay", "x.jpg"], "JPEG")])
def test_what_cannot_be_is_one_line(plan, words, said):
    assert_rejected(said, "path", plan[0], *words)


def test_a_map_without_obstacles_and_a_path_of_one_pixel():
    assert len(thinbench.find_path(np.ones((9, 9), bool), (0, 0), (8, 8), 1000)) >= 9
    assert thinbench.find_path(np.ones((9, 9), bool), (4, 4), (4, 4)).tolist() == [[4, 4]]


# A corridor of 21 rows and a way around an unknown block in it.
LEVELS = np.full((41, 101), 0, np.uint8)
LEVELS[10:31, 5:96] = 254
LEVELS[10:26, 45:56] = 205
YAML = "image: map.png\nresolution: 0.05\norigin: [3, -2, 2.5]\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
ENDS = ["--start", "20,20", "--goal", "80,20"]


@pytest.fixture
def saved(tmp_path, monkeypatch):
    """Writes the map and a description of it into the working directory."""
    monkeypatch.chdir(tmp_path)
    cv2.imwrite("map.png", LEVELS)
    (tmp_path / "map.yaml").write_text(YAML)


def found_by(*words):
    made = run_text("path", *words, "--json")
    assert made.returncode == 0, made.stderr
    return json.loads(made.stdout), made.stderr


def metres(pixels):
    """Centres of pixels, by complex numbers."""
    x, y = np.array(pixels).T
    places = 3 - 2j + 0.05 * (x + 0.5 + 1j * (LEVELS.shape[0] - y - 0.5)) * np.exp(2.5j)
    return np.stack([places.real, places.imag], axis=1)


@pytest.mark.parametrize("name", ["map.yaml", "map.png"])
def test_unknown_pixels_of_an_occupancy_map_are_obstacles_or_free(saved, name):
    found, said = found_by(name, *ENDS)
    expected = thinbench.find_path(LEVELS == 254, (20, 20), (20, 80))
    np.testing.assert_array_equal(np.array(found["points"])[:, ::-1], expected)
    assert expected[:, 0].max() >= 27 and found["unit"] == "pixel"
    assert said == (f"note: {name}: occupancy map; unknown counts as obstacle (176 pixels); "
                    "--unknown free overrides this\n")
    assert found_by(name, *ENDS, "--unknown", "obstacle") == (found, "")
    found, said = found_by(name, *ENDS, "--unknown", "free")
    assert found["points"] == [[x, 20] for x in range(20, 81)] and said == ""
    assert (found["length"], found["min_width"]) == (60, 22)


def test_options_for_pictures_make_an_occupancy_map_a_picture(saved):
    for options in (["--threshold", "100"], ["--foreground", "bright"], ["--channel", "grey"], ["--blur", "0"]):
        found, said = found_by("map.png", *ENDS, *options)
        assert found["points"] == [[x, 20] for x in range(20, 81)] and "occupancy" not in said
        assert_rejected(f"map.png: --unknown is for occupancy maps; with {options[0]} the image is a picture\n",
                        "path", "map.png", *ENDS, *options, "--unknown", "free", status=(1,))
        assert_rejected(f"{options[0]} is for pictures", "path", "map.yaml", *ENDS, *options, status=(2,))


def test_metres_are_in_the_frame_of_the_map(saved):
    start, goal = (f"{x!r},{y!r}" for x, y in metres([(20, 20), (80, 20)]).tolist())
    words = ["map.yaml", "--unit", "m", "--start", start, "--goal", goal, "--width", "0.3"]
    found, _ = found_by(*words)
    pixels = found_by("map.yaml", *ENDS, "--width", "6")[0]
    np.testing.assert_allclose(found["points"], metres(pixels["points"]), atol=1e-12)
    assert (found["unit"], found["robot_width"], found["width"]) == ("m", 0.3, 101)
    for key in ("length", "min_width"):
        assert found[key] == pytest.approx(0.05 * pixels[key])
    assert run_text("path", *words).stdout == (f"path: {len(pixels['points'])} pixels, length {found['length']:.2f} m, "
                                               f"min width {found['min_width']:.2f} m\n")


@pytest.mark.parametrize("width, fits", [("0.28", True), ("0.29", False)])  # 0.28 / 0.02 is more than 14
def test_width_in_metres_that_just_fits(saved, tmp_path, width, fits):
    levels = np.full((20, 30), 254, np.uint8)
    levels[[2, 16]] = 0
    cv2.imwrite("map.png", levels)
    (tmp_path / "map.yaml").write_text("image: map.png\nresolution: 0.02\norigin: [0, 0, 0]\n")
    made = run_text("path", "map.yaml", "--unit", "m", "--start", "0.11,0.21", "--goal", "0.51,0.21", "--width", width)
    assert made.returncode == (0 if fits else 1) and ("length 0.40 m, min width 0.28 m" in made.stdout) == fits


def snapped(*words):
    made = run_text("path", *words, "--snap", "--json")
    assert made.returncode == 0, made.stderr
    return json.loads(made.stdout)["points"][0], made.stderr.splitlines()[-1]


def test_snap_moves_to_the_nearest_room(saved):
    words = ["map.png", "--start", "50,12", "--goal", "80,20"]  # from where columns 44 and 56 are 6 away
    assert_rejected("thinbench: map.png: start 50,12 is an obstacle; the nearest pixel with room is 44,12, 6 pixels "
                    "away; --snap moves it there; free space is occupancy < 0.196\n", "path", *words)
    assert snapped(*words) == ([44, 12], "note: map.png: start 50,12 is moved to 44,12, 6 pixels away")
    assert snapped(*words, "--width", "6")[0] == [42, 12]
    assert_rejected("map.png: goal 80,11 has room for a width of 4 pixels, not of 6 pixels; the nearest pixel with "
                    "room is 80,12, 1 pixel away", "path", "map.png", "--start", "20,20", "--goal", "80,11", "--width", "6")
    assert_rejected("start 50,12 is an obstacle; no free pixel has room for a width of 23 pixels", "path", *words,
                    "--width", "23", "--snap")
    levels = np.full((5, 5), 255, np.uint8)
    levels[2, 2] = 0
    cv2.imwrite("dot.png", levels)
    assert snapped("dot.png", "--start", "2,2", "--goal", "4,4", "--foreground", "bright")[0] == [2, 1]


def test_snap_speaks_of_metres(saved):
    point = ["{:.9g},{:.9g}".format(*place) for place in metres([(50, 12), (44, 12), (80, 20), (40, 14)])]
    words = ["map.yaml", "--unit", "m", "--start", point[0], "--goal", point[2]]
    place, said = snapped(*words)
    assert said == f"note: map.yaml: start {point[0]} is moved to {point[1]}, 0.3 m away"
    np.testing.assert_allclose(place, metres([(44, 12)])[0])
    assert_rejected("has room for a width of 1.1 m, not of 2 m; no free pixel has room for a width of 2 m", "path",
                    "map.yaml", "--unit", "m", "--start", point[2], "--goal", point[2], "--width", "2")
    assert_rejected(f"map.yaml: no path from {point[3]} to {point[2]} is 0.5 m wide; free space is ", "path", *words,
                    "--snap", "--width", "0.5", status=(3,))


@pytest.mark.parametrize("words, status, said", [
    ("map.png --unit m", 2, "--unit m: expected a map description, .yaml or .yml, got 'map.png'"),
    ("map.yaml --crop 0,0,9x9", 2, "--crop is for pictures, and 'map.yaml' describes an occupancy map"),
    ("map.yaml --overlay map.png", 2, "'map.png' is read or written as another file"),
    ("map.yaml --unit m --start 1,2,3", 2, "--start: expected X,Y in metres such as 1.5,-2, got '1,2,3'"),
    ("map.yaml --unit m --goal -300,0.5", 1, "goal -300,0.5 m, which is pixel 4884,-3546, is outside the map of 101 x 41 pixels"),
    ("plan.png --unknown free", 1, "--unknown is for occupancy maps; the grey levels of this image are not 0, 205"),
    ("long.png --snap", 1, "map: expected sides of at most 32767, got 32768 x 30; free space is "),
    ("none.yaml", 1, "cannot read 'none.yaml': there is no such file"),
    ("lost.yaml", 1, "cannot read 'none.pgm': there is no such file"),
    ("bad.yaml", 1, "cannot read 'bad.yaml': resolution: expected metres per pixel, a number above 0, got '0'")])
def test_what_cannot_be_of_an_occupancy_map_is_one_line(saved, plan, tmp_path, words, status, said):
    cv2.imwrite("long.png", np.full((30, 32768), 9, np.uint8))
    (tmp_path / "lost.yaml").write_text(YAML.replace("map.png", "none.pgm"))
    (tmp_path / "bad.yaml").write_text(YAML.replace("0.05", "0"))
    words = words.split()
    for name in {"--start", "--goal"} - set(words):
        words += [name, "2,-2.5" if "m" in words else "20,20"]
    assert_rejected(said, "path", *words, status=(status,))


def test_levels_that_are_unknown_by_ros_and_free_by_the_thresholds_give_a_warning(saved, tmp_path):
    (tmp_path / "map.yaml").write_text(YAML.replace("0.196", "0.25"))
    found, said = found_by("map.yaml", *ENDS)
    assert found["length"] == 60 and said.startswith("warning: map.yaml: grey level 205") and said.count("\n") == 1


# The example: what docs/path-planning.md says of its paths.

FREE = planning.floor_plan()
SKELETON = thinbench.prune(thinbench.thin(FREE), min_widths=1, image=FREE)
CLEARANCE = ndimage.distance_transform_edt(FREE)
NARROW = 16


def planned(width, start=planning.START, goal=planning.GOAL):
    return planning.plan_path(FREE, SKELETON, width, start, goal)


def run_example(*options, cwd):
    package = str(Path(thinbench.__file__).parents[1])
    return subprocess.run([sys.executable, planning.__file__, *map(str, options)], cwd=cwd, text=True,
                          capture_output=True, env={**os.environ, "PYTHONPATH": package}, check=False)


@pytest.mark.parametrize("width", [0.5, *range(1, 36)])
def test_every_pixel_is_as_clear_as_the_robot_is_wide_and_next_to_the_one_before(width):
    assert_is_path(planned(width), FREE, planning.START, planning.GOAL, width)


@pytest.mark.parametrize("on_skeleton", [True, False])
def test_start_and_goal_may_lie_anywhere_that_is_clear(on_skeleton):
    width = 10
    near = SKELETON if on_skeleton else ndimage.binary_dilation(SKELETON, np.ones((5, 5)))
    points = np.argwhere(near & (2 * CLEARANCE >= width + 4))
    for first, last in np.random.RandomState(1).randint(len(points), size=(30, 2)):
        start, goal = tuple(points[first]), tuple(points[last])
        assert_is_path(planned(width, start, goal), FREE, start, goal, width)


def test_no_clear_path_over_the_skeletons_pixels_is_shorter():
    for width in (4, NARROW, 25, 32):
        ends = [planning.START, planning.GOAL]
        lines = planning.with_points(SKELETON, CLEARANCE, width, ends)
        shortest = planning.in_order(np.argwhere(lines & (2 * CLEARANCE >= width)), *ends)
        assert length(planned(width)) == pytest.approx(length(shortest))


def test_of_parallel_edges_a_robot_takes_the_shortest_that_is_wide_enough():
    free = np.zeros((90, 200), bool)
    free[4:86, 4:196] = True
    free[20:50, 40:160] = False  # 16 rows above it, 36 below; start and goal are near the upper passage
    start, goal = (14, 14), (14, 186)
    skeleton, clearance = thinbench.thin(free), ndimage.distance_transform_edt(free)
    joined = planning.with_points(skeleton, clearance, 10, [start, goal])
    edges = thinbench.skeleton_graph(joined, not_thin="ignore").edges
    ends = np.sort([edges["from"], edges["to"]], axis=0)
    assert len(np.unique(ends, axis=1).T) < len(ends.T)
    paths = {width: planning.plan_path(free, skeleton, width, start, goal) for width in (10, 18)}
    for width, path in paths.items():
        assert_is_path(path, free, start, goal, width)
    middles = {width: path[path[:, 1] == 100, 0] for width, path in paths.items()}
    assert (middles[10] < 20).all() and (middles[18] >= 50).all()


def test_where_a_robot_does_not_fit_the_error_says_so(tmp_path):
    with pytest.raises(ValueError, match=r"no path from \(150, 40\) to \(80, 590\) is wide enough .* 50 pixels wide"):
        planned(50)
    for width, reason in ((50, "no path"), (90, "no straight line")):
        ended = run_example("--robot", NARROW, width, cwd=tmp_path)
        assert (ended.returncode, ended.stdout, ended.stderr.count("\n")) == (1, "", 1)
        assert ended.stderr.startswith(f"path_planning.py: {reason}") and f"{width} pixels wide" in ended.stderr
    assert run_example("--robot", "-1", cwd=tmp_path).returncode == 2
    assert list(tmp_path.iterdir()) == []


def test_without_options_it_draws_the_picture_of_its_page(tmp_path):
    from matplotlib.image import imread

    ended = run_example(cwd=tmp_path)
    assert (ended.returncode, ended.stderr, ended.stdout.count("\n")) == (0, "", 2)
    drawn, shown = imread(tmp_path / "paths.png"), imread(ROOT / "docs" / "pictures" / "path-planning.png")
    assert drawn.shape == shown.shape and np.abs(drawn - shown).mean() < 0.02  # other fonts may differ
