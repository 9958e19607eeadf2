"""Tables in Markdown: times, and ratios with their intervals."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pandas as pd

from report.formatting import duration, interval, markdown_table, three_digits
from report.many_images.steps import CALLS, CHUNKS, IMAGES, IN_MEMORY, STAGES, WORKERS


def _images(results: pd.DataFrame) -> str:
    stages = [dict(_lines(results, IMAGES, f"{stage}_ms")) for stage in STAGES]
    lines = [[f"`{method}`", *(three_digits(of[method].time) for of in stages),
              _ratio(stages[1][method]), three_digits(1e3 / total.time), _ratio(total)]
             for method, total in _lines(results, IMAGES, "total_ms")]
    return markdown_table(["one thread", *(f"{stage}, ms" for stage in STAGES),
                           "compute / the batch's", "images/s", "time / the batch's"], lines,
                          frozenset(range(1, 7)))


def _workers(results: pd.DataFrame) -> str:
    lines = [[method, str(one.x), three_digits(1e3 / one.time), _ratio(one)]
             for method, one in _lines(results, WORKERS, "ms_per_image")]
    return markdown_table(["workers", "number", "images/s", "time / one thread's"], lines,
                          frozenset({1, 2, 3}))


def _calls(results: pd.DataFrame) -> str:
    found = dict(_lines(results, CALLS, "ms_per_call"))
    lines = [[f"`{one.base}`", duration(1e6 * found[one.base].time), f"`{method}`",
              duration(1e6 * one.time), _ratio(one)]
             for method, one in found.items() if pd.notna(one.ratio)]
    return markdown_table(["here", "time", "the same by", "its time", "its time / ours"], lines,
                          frozenset({1, 3, 4}))


def _dask(results: pd.DataFrame) -> str:
    """What dask takes for a chunk is the difference of two times."""
    found = list(_lines(results, CHUNKS, "ns_per_pixel"))
    memory = dict(found)[IN_MEMORY].time
    lines = [[method, f"{one.x:,} x {one.x:,}", three_digits(1e-6 * one.x**2 * (one.time - memory)),
              _ratio(one)] for method, one in found if method != IN_MEMORY]
    return markdown_table(["dask on", "chunk", "ms per chunk beyond memory",
                           "processor time / that of one call"], lines, frozenset({2, 3}))


def _lines(results: pd.DataFrame, experiment: str, quantity: str) -> Iterator[tuple[str, Any]]:
    """Each line with its method, by method."""
    chosen = results[(results["experiment"] == experiment) & (results["quantity"] == quantity)]
    for method, curve in chosen.groupby("method", sort=False):
        yield from ((str(method), one) for one in curve.itertuples())


def _ratio(one: Any) -> str:
    if pd.isna(one.ratio):
        return ""
    flags = f", {one.flags}" if one.flags else ""
    return f"{three_digits(one.ratio)} ({interval(one.ratio_low, one.ratio_high)}{flags})"


TABLES: dict[str, Callable[[pd.DataFrame], str]] = {
    IMAGES: _images, WORKERS: _workers, CALLS: _calls, CHUNKS: _dask}
"""By experiment."""
