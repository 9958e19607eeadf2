"""What there is, and what this machine can run."""

from __future__ import annotations

from typing import NamedTuple

from thinbench import _arrays, _library
from thinbench._thinning import RULES


class Variant(NamedTuple):
    """A way to compute a rule; all variants of a rule give the same pixels."""

    technique: str
    isa: str
    threaded: bool  # takes several threads
    unavailable: str | None  # why it cannot run here


def rules() -> dict[str, str]:
    """Names and descriptions of the thinning rules.

    Examples
    --------
    >>> import thinbench
    >>> print(thinbench.rules()["zhang_suen"])
    Zhang and Suen 1984, two sub-iterations; loses 2 x 2 blocks
    """
    return {name: _library.rule_description(index).decode() for index, name in enumerate(RULES)}


def variants(rule: str = "guo_hall") -> list[Variant]:
    """All variants of a rule.

    Examples
    --------
    >>> import thinbench
    >>> thinbench.variants("guo_hall")[0]
    Variant(technique='lut', isa='baseline', threaded=False, unavailable=None)
    """
    name = _arrays.one_of("rule", rule, RULES)
    return [Variant(technique or "", isa or "", threaded, reason)
            for technique, isa, threaded, reason in _library.rule_variants(name)]


def cpu() -> dict[str, bool]:
    """Instruction sets, and whether this processor has each; the last one that it has is used.

    The environment variable THINBENCH_MAX_ISA, read once, limits what is used.

    Examples
    --------
    >>> import thinbench
    >>> thinbench.cpu()["baseline"]
    True
    """
    return {name: _library.isa_available(name.encode()) == 1
            for name in _library.all_names(_library.isa_name)}
