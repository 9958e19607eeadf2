"""`path` of Python and of the program: of least cost, wide enough everywhere, one line where there is none."""

from __future__ import annotations

import heapq
import json
import sys

import numpy as np
import pytest

import thinbench
from images import random_image
from program import ROOT, assert_rejected, run_text

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


def neighbours(pixel, free, width, rooms):
    """Those at the ends of steps with room, each with its distance."""
    row, column = pixel
    for y in range(max(row - 1, 0), min(row + 2, free.shape[0])):
        for x in range(max(column - 1, 0), min(column + 2, free.shape[1])):
            slips = not free[row, x] and not free[y, column]
            if (y, x) != pixel and free[y, x] and not slips and min(rooms[2 * y, 2 * x], rooms[y + row, x + column]) >= width:
                yield (y, x), np.sqrt(abs(y - row) + abs(x - column))


def least_cost(free, width, skeleton, start, goal):
    """Dijkstra's algorithm over all pixels with room; infinite where there is no path."""
    rooms = room_at_halves(free)
    costs, queue = {start: 0.0}, [(0.0, start)]
    while queue:
        cost, pixel = heapq.heappop(queue)
        if pixel == goal:
            return cost
        if cost > costs[pixel]:
            continue
        for other, step in neighbours(pixel, free, width, rooms):
            new = cost + (step if skeleton[pixel] and skeleton[other] else 4 * step)
            if new < costs.get(other, np.inf):
                costs[other] = new
                heapq.heappush(queue, (new, other))
    return np.inf


def cost_of(path, skeleton):
    on = skeleton[tuple(path.T)]
    steps = np.hypot(*np.diff(path, axis=0).T)
    return np.where(on[1:] & on[:-1], steps, 4 * steps).sum()


@pytest.mark.parametrize("seed", range(200))
def test_no_path_costs_less_and_there_is_one_wherever_steps_with_room_join_start_and_goal(seed):
    free = ndimage.binary_dilation(random_image(seed, 40), iterations=1 + seed % 3)
    width = [0, 2, 2.5, 3, 4][seed % 5]
    room = free & (2 * ndimage.distance_transform_edt(free) >= width)
    skeleton = thinbench.prune(thinbench.thin(free), min_widths=1, image=free)
    random, places = np.random.RandomState(seed), np.argwhere(room)
    for _ in range(3 if len(places) > 1 else 0):
        start, goal = map(tuple, random.permutation(places)[:2])
        cost = least_cost(free, width, skeleton, start, goal)
        if np.isfinite(cost):
            found = thinbench.find_path(free, start, goal, width)
            assert_is_path(found, free, start, goal, width)
            assert cost_of(found, skeleton) == pytest.approx(cost)
        else:
            with pytest.raises(ValueError, match="^no path from"):
                thinbench.find_path(free, start, goal, width)


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
    np.testing.assert_array_equal(np.array(listed["pixels"])[:, ::-1], found)
    assert listed["length"] == pytest.approx(length(found)) and listed["min_width"] >= width
    skeleton = thinbench.prune(thinbench.thin(free), min_widths=1, image=free)
    by_steps = planning.plan_path(free, skeleton, width, planning.START, planning.GOAL)
    assert length(found) == pytest.approx(length(by_steps), rel=0.005)
    assert cv2.imread(str(overlay)).shape == (*free.shape, 3)


def test_the_path_follows_the_skeleton():
    free = np.zeros((41, 101), bool)
    free[5:36, 5:96] = True
    found = thinbench.find_path(free, (20, 20), (20, 80))
    assert (found[:, 0] == 20).all()
    found = thinbench.find_path(free, (10, 20), (10, 80))
    assert found[30:-30, 0].min() >= 19


def test_free_space_of_more_than_half_a_map_is_nothing_doubtful(plan):
    for options in ([], ["--foreground", "bright"]):
        made = run_text("path", plan[0], "--start", xy(planning.START), "--goal", xy(planning.GOAL), *options)
        assert made.returncode == 0 and "warning" not in made.stderr


@pytest.mark.parametrize("words, said", [
    (["--start", "640,5", "--goal", "590,80"],
     "start: row 5, column 640 is outside the map of 640 x 480 pixels; free space is "),
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
