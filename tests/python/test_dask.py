"""thinbench.dask: equal to the result in memory, whatever the chunks, and after a worker's death."""

from __future__ import annotations

import contextlib
import importlib
import os
import resource
import signal
import subprocess
import sys

import numpy as np
import pytest

import thinbench
from images import random_image
from thinbench import Rule

dask = pytest.importorskip("dask")
da = pytest.importorskip("dask.array")
zarr = pytest.importorskip("zarr")
tb_dask = pytest.importorskip("thinbench.dask")
dask_thinning = importlib.import_module("thinbench._dask_thinning")


def random_rule(seed: int, **options: object) -> Rule:
    """Of two tables that remove pixels, and often add some."""
    changed = np.random.RandomState(seed).rand(2, 512) < 0.1
    return Rule(((np.arange(512) & 16) != 0) ^ changed, **options)


RULES = {name: name for name in [*thinbench.rules(), "thin_lu_wang", "majority", "erode", "golay_l"]} | {
    "tables": random_rule(1, max_iterations=3), "tables, border kept": random_rule(2, max_iterations=4, border="keep"),
    "net": Rule.named("net_two_layer_linear")}
OPTIONS = [{}, {"max_iterations": 2}, {"border": "background", "max_iterations": 2**31 - 1},
           *({"border": border} for border in ("background", "keep", "foreground"))]


def or_reason(function, *arguments, **options):
    """The result of a call, or why it is rejected."""
    try:
        return function(*arguments, **options)
    except ValueError as error:
        assert "\n" not in str(error)
        return str(error)


@pytest.fixture(autouse=True)
def synchronous():
    """Without threads, unless a cluster is in use: tasks are tiny."""
    with dask.config.set(scheduler="synchronous"):
        yield


def random_chunks(size: int, random: np.random.RandomState, max_size: int) -> tuple[int, ...]:
    sizes: list[int] = []
    while sum(sizes) < size:
        sizes.append(min(random.randint(1, max_size), size - sum(sizes)))
    return tuple(sizes)


def random_array(seed: int, max_chunk: int = 40) -> tuple[np.ndarray, object]:
    """An image of bool or uint8, and a dask array of it with uneven chunks."""
    random = np.random.RandomState(seed)
    image = random_image(seed, 90)
    image = image * np.uint8(7) if seed % 3 == 0 else image
    chunks = tuple(random_chunks(size, random, max_chunk) for size in image.shape)
    return image, da.from_array(image, chunks=chunks)


@pytest.mark.parametrize("rule", RULES.values(), ids=RULES)
@pytest.mark.parametrize("options", OPTIONS, ids=str)
def test_result_equals_that_in_memory_for_any_chunks_and_limited_ones_are_lazy(rule, options):
    computed = []
    for seed in range(4):
        image, array = random_array(seed)
        counted = array.map_blocks(lambda block: computed.append(1) or block, meta=array._meta)
        computed.clear()
        result = or_reason(tb_dask.thin, counted, rule, depth=16 + 4 * seed, **options)
        if isinstance(result, str):
            assert "no bound" in result or result == or_reason(thinbench.thin, image, rule, **options)
            return
        assert not computed or options != {"max_iterations": 2}
        assert result.chunks == array.chunks and result.dtype == array.dtype
        np.testing.assert_array_equal(result.compute(), thinbench.thin(image, rule, **options))
        assert computed


def count_chunks(monkeypatch) -> list[int]:
    """The number of chunks that each round computes, filled by later calls."""
    rounds: list[int] = []
    run_round = dask_thinning._run_round

    def counted(blocks, active, *arguments):
        rounds.append(int(active.sum()))
        return run_round(blocks, active, *arguments)

    monkeypatch.setattr(dask_thinning, "_run_round", counted)
    return rounds


def test_one_round_suffices_where_all_chunks_come_to_rest_and_quiet_chunks_are_skipped(monkeypatch):
    rounds = count_chunks(monkeypatch)
    image = np.zeros((200, 400), bool)
    image[50:60, 10:390] = True
    tb_dask.thin(da.from_array(image, chunks=40), depth=20)
    assert rounds == [50]
    rounds.clear()
    image[20:180, 20:180] = True
    result = tb_dask.thin(da.from_array(image, chunks=40), depth=20)
    np.testing.assert_array_equal(result.compute(), thinbench.thin(image))
    assert rounds[0] == 50 and len(rounds) > 3 and rounds[-1] < 36


@pytest.mark.parametrize("shape", [(0, 0), (0, 5), (5, 0), (1, 1), (1, 50), (50, 1)])
def test_small_and_empty_arrays_are_accepted(shape):
    image = np.ones(shape, bool)
    array = da.from_array(image, chunks=7)
    for limit in (None, 1):
        np.testing.assert_array_equal(tb_dask.thin(array, max_iterations=limit, depth=4).compute(),
                                      thinbench.thin(image, max_iterations=limit))
    labels, table = tb_dask.label_regions(array)
    assert len(table["area"]) == len(thinbench.find_regions(image)["area"])
    assert labels.compute().shape == shape


def test_chunks_of_a_constant_array_repeat_one_pixel():
    labels, table = tb_dask.label_regions(da.ones((40, 50), dtype=bool, chunks=16))
    assert table["area"].tolist() == [2000] and (labels.compute() == 1).all()


def test_regions_equal_those_in_memory():
    for seed in range(40):
        image, array = random_array(seed, 30)
        expected_labels, expected = thinbench.label_regions(image)
        labels, table = tb_dask.label_regions(array)
        assert list(table) == list(expected)
        for name, column in table.items():
            np.testing.assert_array_equal(column, expected[name], err_msg=name)
            assert column.dtype == expected[name].dtype
        np.testing.assert_array_equal(labels.compute(), expected_labels)
        assert labels.chunks == array.chunks and labels.dtype == np.int32


ARRAY = da.ones((9, 9), dtype=bool, chunks=3)


@pytest.mark.parametrize(("call", "error", "message"), [
    (lambda: tb_dask.thin(np.ones((4, 4), bool)), TypeError, "ndarray"),
    (lambda: tb_dask.thin(da.ones((4, 4))), TypeError, "float64"),
    (lambda: tb_dask.thin(ARRAY[ARRAY.any(axis=1)]), ValueError, "chunks of known size"),
    (lambda: tb_dask.thin(ARRAY, "zhang"), ValueError, "'zhang'"),
    (lambda: tb_dask.thin(ARRAY, depth=1), ValueError, "got 1"),
    (lambda: tb_dask.thin(ARRAY, depth=2.5), TypeError, "2.5"),
    (lambda: tb_dask.thin(ARRAY, out="."), ValueError, "'.' exists"),
    (lambda: tb_dask.thin(ARRAY, out=np.ones((9, 9), bool)), TypeError, "ndarray"),
    (lambda: tb_dask.thin(ARRAY, out=zarr.zeros((9, 8), dtype=bool)), ValueError, r"\(9, 8\)"),
    (lambda: tb_dask.find_regions(np.ones((4, 4), bool)), TypeError, "ndarray"),
    *((lambda call=call, more=more: call(da.zeros((7, 40, 50), dtype=np.uint8), *more), ValueError,
       r"expected shape \(H, W\), got \(7, 40, 50\)") for call, *more in (
          (tb_dask.thin,), (tb_dask.find_regions,), (tb_dask.detect_edges,), (tb_dask.distances, 3),
          (tb_dask.fill_holes, 3))),
    *((lambda value=value: tb_dask.distances(ARRAY, value), ValueError, "max_distance") for value in (0, np.nan, 1e6)),
    (lambda: tb_dask.fill_holes(ARRAY, 0), ValueError, "max_size"),
])
def test_invalid_arguments_are_rejected_in_one_line(call, error, message):
    with pytest.raises(error, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_missing_packages_are_named(monkeypatch):
    code = "import sys; sys.modules['dask'] = None; import thinbench.dask"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "ImportError: thinbench.dask needs dask: install python3-dask" in run.stderr
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(ImportError, match="out: needs zarr: install python3-zarr"):
        tb_dask.thin(ARRAY, out="new")


def test_out_is_written_when_complete(tmp_path):
    image, array = random_array(8)
    expected = thinbench.thin(image)
    path = tmp_path / "skeleton.zarr"
    np.testing.assert_array_equal(tb_dask.thin(array, out=path).compute(), expected)
    assert os.listdir(tmp_path) == ["skeleton.zarr"]
    existing = zarr.open(tmp_path / "existing.zarr", mode="w", shape=image.shape, chunks=(5, 11),
                         dtype=image.dtype)
    tb_dask.thin(array, out=existing, max_iterations=99)
    np.testing.assert_array_equal(existing[:], expected)


@contextlib.contextmanager
def cluster_of(workers: int, **options: object):
    """Its client, which dask uses meanwhile."""
    distributed = pytest.importorskip("distributed")
    cluster = distributed.LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None,
                                       silence_logs=60, **options)
    with dask.config.set(scheduler=None), cluster, distributed.Client(cluster) as client:
        yield client


def discs(side: int) -> np.ndarray:
    """Discs across chunks, which take many iterations, on noise."""
    random = np.random.RandomState(1)
    image = np.kron(random.rand(side // 10, side // 10) < 0.3, np.ones((10, 10), bool))
    y, x = np.ogrid[:side, :side]
    for _ in range(5):
        centre_y, centre_x, radius = *random.randint(0, side, 2), random.randint(50, 90)
        image |= (y - centre_y)**2 + (x - centre_x)**2 < radius**2
    return image


def test_two_worker_processes_and_a_killed_one_give_the_result_in_memory(tmp_path, monkeypatch):
    image = discs(1000)
    source = zarr.open(tmp_path / "image.zarr", mode="w", shape=image.shape, chunks=(190, 230),
                       dtype=bool)
    source[:] = image
    array = da.from_zarr(source)
    expected = thinbench.thin(image)
    rounds = count_chunks(monkeypatch)
    with cluster_of(2) as client:
        result = tb_dask.thin(array, out=tmp_path / "skeleton.zarr")
        np.testing.assert_array_equal(zarr.open(tmp_path / "skeleton.zarr", "r")[:], expected)
        assert len(rounds) > 1
        table = tb_dask.find_regions(result)
        np.testing.assert_array_equal(table["area"], thinbench.find_regions(expected)["area"])
        run_round = dask_thinning._run_round

        def killed_before_the_second(*arguments):
            if len(rounds) == 1:
                os.kill(next(iter(client.run(os.getpid).values())), signal.SIGKILL)
            return run_round(*arguments)

        rounds.clear()
        monkeypatch.setattr(dask_thinning, "_run_round", killed_before_the_second)
        np.testing.assert_array_equal(tb_dask.thin(array).compute(), expected)


def test_a_worker_killed_while_it_computes_gives_the_result_in_memory(tmp_path):
    image, killed = discs(600), tmp_path / "killed"

    def kill_own_worker_once(block):
        """Read by one worker while the other thins."""
        try:
            killed.touch(exist_ok=False)
        except FileExistsError:
            return block
        os.kill(os.getpid(), signal.SIGKILL)

    array = da.from_array(image, chunks=(150, 150)).map_blocks(
        kill_own_worker_once, dtype=bool, meta=np.empty((0, 0), bool))
    with cluster_of(2):
        np.testing.assert_array_equal(tb_dask.thin(array).compute(), thinbench.thin(image))
    assert killed.exists()


def peak_bytes() -> int:
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def test_a_worker_with_less_memory_than_the_array_writes_the_result(tmp_path):
    """It puts chunks on disk, in each round."""
    tile = np.zeros((4000, 4000), bool)
    tile[200::400] = tile[201::400] = True
    array = zarr.open(str(tmp_path / "map.zarr"), mode="w", shape=(16000, 24000), chunks=tile.shape, dtype=bool)
    for top in range(0, 16000, 4000):
        for left in range(0, 24000, 4000):
            array[top:top + 4000, left:left + 4000] = tile
    with cluster_of(1, memory_limit="350MB", local_directory=tmp_path) as client:
        skeleton = tb_dask.thin(da.from_zarr(array), out=str(tmp_path / "skeleton.zarr"))
        (peak,) = client.run(peak_bytes).values()
    assert peak < array.nbytes
    part = zarr.open(str(tmp_path / "skeleton.zarr"), mode="r")[:5000, :5000]
    assert (part == thinbench.thin(np.tile(tile, (2, 2)))[:5000, :5000]).all()
    assert skeleton.shape == array.shape


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("operator", ["sobel", "mero_vassy_5x5", "roberts4"])
def test_edges_equal_those_in_memory(seed, operator):
    image, _ = random_array(seed)
    grey = np.random.RandomState(seed).randint(0, 256, image.shape).astype(np.uint8)
    chunks = tuple(random_chunks(size, np.random.RandomState(seed), 40) for size in image.shape)
    found = tb_dask.detect_edges(da.from_array(grey, chunks=chunks), operator, 60, 100)
    assert found.chunks == chunks
    np.testing.assert_array_equal(found.compute(), thinbench.detect_edges(grey, operator, 60, 100))


@pytest.mark.parametrize("seed", range(12))
def test_fill_holes_fills_holes_up_to_the_halo(seed):
    image, array = random_array(seed)
    size = 1 + seed % 5
    labels, table = thinbench.label_regions(image)
    filled = image != 0
    for i in np.flatnonzero(table["is_hole"]):
        if max(table["bbox-2"][i] - table["bbox-0"][i], table["bbox-3"][i] - table["bbox-1"][i]) <= size:
            filled |= labels == table["label"][i]
    found = tb_dask.fill_holes(array, size).compute()
    assert found.dtype == image.dtype
    np.testing.assert_array_equal(found != 0, filled)


@pytest.mark.parametrize("seed", range(12))
def test_distances_are_exact_up_to_the_halo(seed):
    image, array = random_array(seed)
    limit = 1 + seed % 4 / 2
    expected = thinbench.distances(image)
    expected[expected > limit] = np.inf
    np.testing.assert_array_equal(tb_dask.distances(array, limit).compute(), expected)
