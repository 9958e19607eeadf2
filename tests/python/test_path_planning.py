"""The example of path planning: what docs/path-planning.md says of its paths."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage

import thinbench
from test_path import ROOT, assert_is_path, length, planning as path_planning

EXAMPLE = ROOT / "python" / "examples" / "path_planning.py"

FREE = path_planning.floor_plan()
SKELETON = thinbench.prune(thinbench.thin(FREE), min_widths=1, image=FREE)
CLEARANCE = ndimage.distance_transform_edt(FREE)
NARROW, WIDE = 16, 32


def planned(width, start=path_planning.START, goal=path_planning.GOAL):
    return path_planning.plan_path(FREE, SKELETON, width, start, goal)


def run(*options, cwd):
    package = str(Path(thinbench.__file__).parents[1])
    return subprocess.run([sys.executable, EXAMPLE, *map(str, options)], cwd=cwd, text=True, capture_output=True,
                          env={**os.environ, "PYTHONPATH": package}, check=False)


@pytest.mark.parametrize("width", [0.5, *range(1, 36)])
def test_every_pixel_is_as_clear_as_the_robot_is_wide_and_next_to_the_one_before(width):
    assert_is_path(planned(width), FREE, path_planning.START, path_planning.GOAL, width)


def test_the_narrow_robot_takes_the_narrow_door_and_a_shorter_path():
    top, left, bottom, right = path_planning.DOORS[4]
    door = np.zeros_like(FREE)
    door[top:bottom, left:right] = True
    narrow, wide = planned(NARROW), planned(WIDE)
    assert door[tuple(narrow.T)].any() and not door[tuple(wide.T)].any()
    assert length(narrow) < length(wide)


@pytest.mark.parametrize("on_skeleton", [True, False])
def test_start_and_goal_may_lie_anywhere_that_is_clear(on_skeleton):
    width = 10
    near = SKELETON if on_skeleton else ndimage.binary_dilation(SKELETON, np.ones((5, 5)))
    points = np.argwhere(near & (2 * CLEARANCE >= width + 4))
    for first, last in np.random.RandomState(1).randint(len(points), size=(30, 2)):
        start, goal = tuple(points[first]), tuple(points[last])
        assert_is_path(planned(width, start, goal), FREE, start, goal, width)


def test_no_clear_path_over_the_skeletons_pixels_is_shorter():
    for width in (4, NARROW, 25, WIDE):
        ends = [path_planning.START, path_planning.GOAL]
        lines = path_planning.with_points(SKELETON, CLEARANCE, width, ends)
        shortest = path_planning.in_order(np.argwhere(lines & (2 * CLEARANCE >= width)), *ends)
        assert length(planned(width)) == pytest.approx(length(shortest))


def test_of_parallel_edges_a_robot_takes_the_shortest_that_is_wide_enough():
    free = np.zeros((90, 200), bool)
    free[4:86, 4:196] = True
    free[20:50, 40:160] = False  # 16 rows above it, 36 below; start and goal are near the upper passage
    start, goal = (14, 14), (14, 186)
    skeleton, clearance = thinbench.thin(free), ndimage.distance_transform_edt(free)
    joined = path_planning.with_points(skeleton, clearance, 10, [start, goal])
    edges = thinbench.skeleton_graph(joined, not_thin="ignore").edges
    ends = np.sort([edges["from"], edges["to"]], axis=0)
    assert len(np.unique(ends, axis=1).T) < len(ends.T)
    paths = {width: path_planning.plan_path(free, skeleton, width, start, goal) for width in (10, 18)}
    for width, path in paths.items():
        assert_is_path(path, free, start, goal, width)
    middles = {width: path[path[:, 1] == 100, 0] for width, path in paths.items()}
    assert (middles[10] < 20).all() and (middles[18] >= 50).all()


def test_where_a_robot_does_not_fit_the_error_says_so(tmp_path):
    with pytest.raises(ValueError, match=r"no path from \(150, 40\) to \(80, 590\) is wide enough .* 50 pixels wide"):
        planned(50)
    for width, reason in ((50, "no path"), (90, "no straight line")):
        ended = run("--robot", NARROW, width, cwd=tmp_path)
        assert (ended.returncode, ended.stdout, ended.stderr.count("\n")) == (1, "", 1)
        assert ended.stderr.startswith(f"path_planning.py: {reason}") and f"{width} pixels wide" in ended.stderr
    assert run("--robot", "-1", cwd=tmp_path).returncode == 2
    assert list(tmp_path.iterdir()) == []


def test_without_options_it_draws_the_picture_of_its_page(tmp_path):
    from matplotlib.image import imread

    ended = run(cwd=tmp_path)
    assert (ended.returncode, ended.stderr, ended.stdout.count("\n")) == (0, "", 2)
    drawn, shown = imread(tmp_path / "paths.png"), imread(ROOT / "docs" / "pictures" / "path-planning.png")
    assert drawn.shape == shown.shape and np.abs(drawn - shown).mean() < 0.02  # other fonts may differ
