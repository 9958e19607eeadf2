"""Tables as LaTeX."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest
from conftest import OPERATION, Built, Run

from report.build import build
from report.experiment_layout import columns
from report.latex import SYMBOLS, escaped, tabular

TRICKY = r"100 % of a_b & c #1 $x$ {y} \z ~ ^ < > | \"q\" [1] * µs 3× 5² a → b – `code_1` end"
LATEX = shutil.which("pdflatex") or shutil.which("lualatex")


def unescaped(symbol: str, text: str) -> list[str]:
    return re.findall(rf"(?<!\\){re.escape(symbol)}", text)


@pytest.mark.parametrize("symbol", "%_&#")
def test_symbols_that_latex_takes_as_its_own_are_escaped(symbol):
    assert escaped(f"a {symbol} b") == f"a \\{symbol} b"
    assert not unescaped(symbol, escaped(TRICKY))


def test_what_backslashes_and_braces_become_is_not_escaped_again():
    assert escaped("\\") == r"\textbackslash{}"
    assert escaped("{a}") == r"\{a\}"
    assert escaped("~^") == r"\textasciitilde{}\textasciicircum{}"


def test_code_is_set_like_a_typewriters_and_a_single_quote_stays():
    assert escaped("a `b_c` d") == r"a \texttt{b\_c} d"
    assert escaped("a ` b") == r"a \textasciigrave{} b"
    assert escaped("`a` ` b") == r"\texttt{a} \textasciigrave{} b"


def test_no_line_begins_with_what_the_line_before_would_take():
    text = tabular(columns(["a"], ["b"]), (("[1pt]", "*"),))
    assert "\n{[}1pt] & {*} \\\\\n" in text


def test_lines_have_as_many_cells_as_the_layout_has_columns(built: Built):
    for name in ("headline.tex", "ladder.tex", "claims.tex"):
        text = built.text(name)
        assert text.startswith("% Run of commit abc1234 on Intel Xeon <Platinum> 8481C (intel-6-")
        layout = re.search(r"\\begin\{tabular\}\{(.*)\}\n", text)
        assert layout
        wanted = len(re.findall(r"[lr]|p\{[^}]*\}", layout.group(1)))
        lines = [line for line in text.splitlines() if line.endswith(r" \\")]
        assert lines and all(len(unescaped("&", line)) == wanted - 1 for line in lines), name
        assert not unescaped("_", text) and not unescaped("#", text), name


def test_headline_names_the_rule_and_its_speed_up(built: Built):
    assert rf"the paper's thinning, \texttt{{{OPERATION.replace('_', chr(92) + '_')}}} & " in \
        built.text("headline.tex")
    assert r"simd\_bitpacked, avx512 & " in built.text("headline.tex")


def test_tables_without_rows_are_not_written(run: Run):
    build(run.write())
    assert not (run.directory / "nets.tex").exists()
    assert not (run.directory / "table_two.tex").exists()


@pytest.mark.skipif(LATEX is None, reason="neither pdflatex nor lualatex is installed")
def test_tables_compile(built: Built, tmp_path):
    rows = tuple((symbol, TRICKY) for symbol in SYMBOLS)
    (tmp_path / "tricky.tex").write_text(tabular(columns(["a_b", "%"], []), rows), encoding="utf-8")
    names = [*sorted(built.directory.glob("*.tex")), tmp_path / "tricky.tex"]
    inputs = "\n\n".join(rf"\input{{{name}}}" for name in names)
    (tmp_path / "all.tex").write_text(
        "\\documentclass{article}\n\\begin{document}\n" + inputs + "\n\\end{document}\n")
    done = subprocess.run([str(LATEX), "-halt-on-error", "-interaction=nonstopmode", "all.tex"],
                          cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-3000:]
