"""The paper's experiments on the page and in experiments.md."""

from __future__ import annotations

import json
from typing import Any

import pytest
from conftest import OPERATION, SIZES, Run, entries

from report.build import build
from report.experiment_layout import TITLE, Table
from report.experiment_tables import holding_from, make_tables
from report.experiments import KINDS, load_experiments
from report.loading import load_study

NAMES = ("edge-quality", "table-2", "quantisation", "hidden-neurons", "operation-counts",
         "literal-holes", "batches")
NET = "net_single_layer_cluster"
TITLES = ("Table 2 then and now", "Recognition rate under fixed point",
          "Hidden neurons against recognition rate", "Operation counts", "The compiled circuit")


def make_experiments() -> dict[str, dict[str, Any]]:
    """The files, by name."""
    def file(name: str, **more: Any) -> dict[str, Any]:
        return {"schema": 1, "experiment": name, "command": f"thinbench experiment {name}"} | more
    table = [("Holes | found", "holes", 0.67, 0.92), ("The rule", OPERATION, 0.73, 1.0),
             ("Cluster", NET, 0.89, 1.22)]
    fixed = [(w, b, 256 if b else 250) for w in ("rounded", "truncated") for b in (0, 1, 2)]
    trained = [(2, 225, 220.5, 0), (5, 256, 240.0, 1), (9, 256, 256.0, 4)]
    counts = {kind: number for number, kind in enumerate(KINDS)}
    return {
        "edge-quality": file("edge-quality", p1=40, p2=128, seeds=2, rows=[
            {"operation": "edges_sobel", "sigma": sigma, "precision": 0.75, "recall": 1,
             "figure_of_merit": 0.5, "marked": sigma / 16, "precision_without_p2": 0.25}
            for sigma in (8, 0)]),
        "table-2": file("table-2", image="510 x 412", machine="Pentium II", rows=[
            {"method": m, "operation": o, "paper_seconds": s, "paper_ratio": r}
            for m, o, s, r in table]),
        "quantisation": file("quantisation", descriptors=256, rows=[
            {"weights": w, "fractional_bits": b, "right_sigmoid": right, "right_linear": 256,
             "largest_integer": 20 << b} for w, b, right in fixed]),
        "hidden-neurons": file("hidden-neurons", descriptors=256, seeds=4, rows=[
            {"hidden": h, "best": b, "median": m, "seeds_with_all_right": s,
             "median_epochs_of_those": 100.0 * s} for h, b, m, s in trained]),
        "literal-holes": file("literal-holes", rows=[
            {"pictures": "one plate", "tried": 41, "right": 41, "refused": 0, "true_holes": 40,
             "counted": 40},
            {"pictures": "many", "tried": 1, "right": 0, "refused": 1, "true_holes": 254,
             "counted": None}]),
        "batches": file("batches", images=2000, rounds=9, rows=[
            {"operation": OPERATION, "side": side, "dark": 0.2, "passes": 9, "single": "lut (avx2)",
             "level": "avx2", "single_per_second": 1e6, "batch_per_second": 1e6 * ratio,
             "ratio": ratio, "ratio_low": ratio - 0.25, "ratio_high": ratio + 0.5}
            for side, ratio in ((28, 7.5), (64, 2.25))]),
        "operation-counts": file(
            "operation-counts", per="dark pixel",
            methods=[{"method": "The rule", "paper": "", "sums": counts,
                      "activations": dict.fromkeys(KINDS, 7)}],
            circuit={"two_input": {"gates": 14, "inverters": 6},
                     "three_input": {"gates": 8, "inverters": 0}},
            nets=[{"net": "a", "compiles_to_the_rule": True},
                  {"net": "b", "compiles_to_the_rule": False}])}


def add_net(run: Run, arithmetic_ns: float, circuit: float) -> None:
    """Times a net by arithmetic, and as a circuit by the rule's time times `circuit`."""
    rule = run.iterations(f"{OPERATION}/simd_bitpacked/avx2/1/kernel/scene")[0]["cpu_time"]
    times = {"reference/baseline/1/end_to_end": 6e7,
             "simd_float_bits/avx2/1/end_to_end": arithmetic_ns,
             "simd_bitpacked/avx2/1/kernel": rule * circuit}
    for middle, time in times.items():
        run.timings["benchmarks"] += entries(f"{NET}/{middle}/scene", SIZES["scene"], [time] * 3)


def write(run: Run, experiments: dict[str, dict[str, Any]]) -> Run:
    folder = run.write() / "experiments"
    folder.mkdir(exist_ok=True)
    for name, data in experiments.items():
        (folder / f"{name}.json").write_text(json.dumps(data))
    return run


@pytest.fixture
def full(run: Run) -> Run:
    """A run with a net and with all experiments, not yet changed nor built."""
    add_net(run, 4e6, 1.0)
    return write(run, make_experiments())


def tables_of(run: Run) -> dict[str, Table]:
    study = load_study(run.directory)
    return {table.title: table for table in make_tables(study, load_experiments(run.directory))}


def test_tables_stand_on_the_page_and_in_markdown_beside_it(full):
    build(full.directory)
    page, text = ((full.directory / name).read_text() for name in ("index.html", "experiments.md"))
    assert page.index('<section id="plots">') < page.index('<section id="experiments">')
    assert page.index('<section id="experiments">') < page.index('<section id="rows">')
    assert 'href="#experiments"' in page and 'href="experiments.md"' in page
    for title in TITLES:
        assert f">{title}</h3>" in page and f"## {title}\n" in text
    for name in NAMES:
        command = f"thinbench experiment {name}"
        assert f"<code>{command}</code>" in page and f"`{command}`" in text
    assert "| many | 1 | 0 | 1 | 254 | refused |" in text
    assert "on all pictures of 1 of 2 kinds" in text
    assert "| edges_sobel | 8 | 0.750 | 1.000 | 0.500 | 50.0 % | 0.250 |" in text
    assert "as edges_sobel marks at sigma 8, would come that near to 99.8 % of" in text
    assert "each object beyond the first adds one" in text
    assert r"| Holes \| found | 0.67 | 0.92 | – | – | – | – | – |" in text
    assert len(page.encode()) < 3_000_000


def test_plot_is_on_the_page_and_the_same_every_time(full):
    drawings = [full.directory / f"plots/hidden_neurons.{ending}" for ending in ("svg", "png")]
    build(full.directory)
    first = [path.read_bytes() for path in drawings]
    build(full.directory)
    assert [path.read_bytes() for path in drawings] == first
    assert 'href="plots/hidden_neurons.svg"' in (full.directory / "index.html").read_text()


def test_run_without_experiments_has_no_such_section(run):
    build(run.write())
    page = (run.directory / "index.html").read_text()
    assert TITLE not in page and 'id="experiments"' not in page
    assert not (run.directory / "experiments.md").exists()


@pytest.mark.parametrize("name", NAMES)
def test_one_experiment_alone_is_shown(run, name):
    write(run, {name: make_experiments()[name]})
    assert {table.command for table in tables_of(run).values()} == {f"thinbench experiment {name}"}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("change", [{"schema": 2}, {"schema": None}, {"experiment": "other"},
                                    {"command": ""}])
def test_other_files_than_the_experiment_are_refused(run, refusal, name, change):
    write(run, {name: make_experiments()[name] | change})
    error = refusal(run.directory)
    assert f"{name}.json" in error and next(iter(change)) in error


@pytest.mark.parametrize("name", NAMES)
def test_truncated_experiment_is_refused(full, refusal, name):
    path = full.directory / f"experiments/{name}.json"
    path.write_bytes(path.read_bytes()[:-5])
    error = refusal(full.directory)
    assert f"{name}.json" in error and "not complete JSON" in error


@pytest.mark.parametrize(("name", "key", "value"), [
    ("table-2", "paper_seconds", 0), ("table-2", "operation", None),
    ("quantisation", "right_sigmoid", 257), ("quantisation", "right_linear", 2.5),
    ("hidden-neurons", "seeds_with_all_right", 5), ("hidden-neurons", "median", -1),
    ("literal-holes", "right", 2), ("literal-holes", "counted", -1),
    ("batches", "single_per_second", 0), ("batches", "ratio", 3), ("batches", "dark", 1.5)])
def test_impossible_values_are_refused(run, refusal, name, key, value):
    experiments = make_experiments()
    experiments[name]["rows"][1][key] = value
    assert key in refusal(write(run, experiments).directory)


@pytest.mark.parametrize(("name", "key"), [(name, "rows") for name in NAMES[:3]]
                         + [("operation-counts", "methods")])
def test_experiment_without_rows_is_refused(run, refusal, name, key):
    write(run, {name: make_experiments()[name] | {key: []}})
    assert f"{key} is []" in refusal(run.directory)


def test_net_of_which_it_is_not_said_whether_it_is_the_rule_is_refused(run, refusal):
    experiments = make_experiments()
    experiments["operation-counts"]["nets"][0]["compiles_to_the_rule"] = "yes"
    assert "must be true or false" in refusal(write(run, experiments).directory)


def test_batches_say_their_ratios_by_size(full):
    table = tables_of(full)["Many small images"]
    assert table.rows[0][-1] == "7.50× (7.25 to 8.00)"
    assert "7.5 to 7.5 times at 28 x 28 pixels, 2.2 to 2.2 times at 64 x 64" in table.verdict
    assert table.plot and "1,000,000, 7,500,000" in table.plot.alt


def test_ratios_are_to_the_rule_in_the_same_column(full):
    rows = {row[0]: row for row in tables_of(full)["Table 2 then and now"].rows}
    assert rows["The rule"][4] == rows["The rule"][7] == "1.00"
    scalar = 6e7 / (20.0 * 510 * 412)
    assert float(rows["Cluster"][4]) == pytest.approx(scalar, rel=0.01)
    assert rows["Cluster"][5:7] == ("simd float bits (avx2)", "4,000.00")
    assert rows["The rule"][5] == "simd bitpacked (avx512)"


@pytest.mark.parametrize(("arithmetic_ns", "circuit", "words"), [
    (4e6, 1.5, ("still slower than the rule: 85", "takes 1.50 times the rule's time")),
    (4e4, 0.9, ("no longer slower than the rule: 1.1", "takes 0.90 times the rule's time"))])
def test_verdict_follows_the_times(run, arithmetic_ns, circuit, words):
    add_net(run, arithmetic_ns, circuit)
    verdict = tables_of(write(run, make_experiments()))["Table 2 then and now"].verdict
    assert all(part in verdict for part in words), verdict


def test_without_a_timed_net_there_is_no_verdict(run):
    table = tables_of(write(run, make_experiments()))["Table 2 then and now"]
    assert table.verdict == "" and "no net was timed" in table.sentence


def test_sentences_follow_the_counts(run):
    experiments = make_experiments()
    before = tables_of(write(run, experiments))
    assert "from 1 fractional bit on (rounded weights)" in before[TITLES[1]].sentence
    assert "gets 250" in before[TITLES[1]].sentence
    assert before[TITLES[2]].sentence.startswith("5 hidden neurons are the fewest")
    assert "from 9 on every seed does" in before[TITLES[2]].sentence
    assert "1 of 2 nets" in before[TITLES[4]].sentence
    experiments["quantisation"]["rows"][2]["right_linear"] = 255
    experiments["hidden-neurons"]["rows"][2]["seeds_with_all_right"] = 3
    after = tables_of(write(run, experiments))
    assert "no number of fractional bits" in after[TITLES[1]].sentence
    assert "some seeds still do not" in after[TITLES[2]].sentence


def test_counts_of_sums_and_activations_are_kept_apart(full):
    row = tables_of(full)["Operation counts"].rows[0]
    assert row[:4] == ("The rule", "–", "0 + 7", "1 + 7")


def test_what_holds_to_the_end_begins_after_the_last_exception():
    assert holding_from([1, 0, 1, 1], bool) == 1 and holding_from([1, 0], bool) is None
