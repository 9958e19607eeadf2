"""The tables of docs/, from the CSV file."""

from __future__ import annotations

from dataclasses import replace

from report.formatting import interval, markdown_table, three_digits
from report.many_images.of_arrays import CHUNKS, LARGE
from report.many_images.of_files import IMAGES, STAGES, WORKERS
from report.many_images.plots import series
from report.many_images.results import Result


def tables(results: list[Result]) -> dict[str, str]:
    """Markdown by experiment: medians, in brackets intervals."""
    return {IMAGES: _images(results), WORKERS: _workers(results), CHUNKS: _dask(results),
            LARGE: _out_of_core(results)}


def _images(results: list[Result]) -> str:
    of = {quantity: series(results, IMAGES, quantity)
          for quantity in (*(f"{stage}_ms" for stage in STAGES), "images_per_second")}
    lines = []
    for method, (rate,) in of["images_per_second"].items():
        stages = [of[f"{stage}_ms"][method][0] for stage in STAGES]
        lines.append([f"`{method}`", *(three_digits(one.median) for one in stages),
                      _ratio(stages[1]), three_digits(rate.median), _ratio(_inverse(rate))])
    return markdown_table(["one thread", *(f"{stage}, ms" for stage in STAGES),
                           "compute / the batch's", "images/s",
                           "the batch's images/s / these"], lines, frozenset(range(1, 7)))


def _workers(results: list[Result]) -> str:
    lines = [[method, str(one.x), _value(one), _ratio(one)]
             for method, curve in series(results, WORKERS, "images_per_second").items()
             for one in curve]
    return markdown_table(["workers", "number", "images/s", "ratio to one thread"], lines,
                          frozenset({1, 2, 3}))


def _dask(results: list[Result]) -> str:
    whole = series(results, CHUNKS, "ns_per_pixel")
    lines = []
    for method, curve in series(results, CHUNKS, "ms_per_chunk_beyond_memory").items():
        ratios = {one.x: one for one in whole[method]}
        lines += [[method, f"{one.x:,} x {one.x:,}", _value(one), _ratio(ratios[one.x])]
                  for one in curve]
    return markdown_table(["dask on", "chunk", "ms per chunk beyond memory",
                           "all processor time, ratio to one call"], lines, frozenset({2, 3}))


def _out_of_core(results: list[Result]) -> str:
    walls = series(results, LARGE, "wall_ns_per_pixel")
    lines = []
    for method, curve in series(results, LARGE, "ns_per_pixel").items():
        lines += [[method, f"{one.x:,} x {one.x:,}", _value(one), _ratio(one), _ratio(wall)]
                  for one, wall in zip(curve, walls[method])]
    return markdown_table(["", "image", "processor time per pixel, ns", "ratio to in memory",
                           "wall time, ratio"], lines, frozenset({2, 3, 4}))


def _value(one: Result) -> str:
    return f"{three_digits(one.median)} ({interval(one.low, one.high)})"


def _inverse(one: Result) -> Result:
    """With the ratio of the base to it."""
    if one.ratio is None or one.ratio_low is None or one.ratio_high is None:
        return one
    return replace(one, ratio=1 / one.ratio, ratio_low=1 / one.ratio_high,
                   ratio_high=1 / one.ratio_low)


def _ratio(one: Result) -> str:
    if one.ratio is None:
        return ""
    return f"{three_digits(one.ratio)} ({interval(one.ratio_low, one.ratio_high)})"
