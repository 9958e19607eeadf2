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
    chosen: bool  # for images of the size asked for


def rules() -> dict[str, str]:
    """Names and descriptions of the thinning rules.

    Returns
    -------
    dict
        From name to description, in the order of the catalogue.

    Examples
    --------
    >>> import thinbench
    >>> print(thinbench.rules()["zhang_suen"])
    Zhang and Suen 1984, two sub-iterations; loses 2 x 2 blocks
    """
    return {name: _library.rule_description(index).decode() for index, name in enumerate(RULES)}


def variants(rule: str = "guo_hall", shape: tuple[int, int] = (412, 510)) -> list[Variant]:
    """All variants of a rule, and which one `thin` takes.

    Parameters
    ----------
    rule : str
        One of `rules()`.
    shape : tuple of two ints
        Height and width of the images that the choice is for, on one thread.

    Returns
    -------
    list of Variant

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import thinbench
    >>> thinbench.variants("guo_hall")[0]
    Variant(technique='lut', isa='baseline', threaded=False, unavailable=None, chosen=False)
    """
    name = _arrays.one_of("rule", rule, RULES)
    height, width = (_arrays.integer("shape", side) for side in shape)
    chosen = _library.chosen_variant(name, height, width)
    return [Variant(technique or "", isa or "", threaded, reason,
                    (technique, isa) == chosen and not threaded)
            for technique, isa, threaded, reason in _library.rule_variants(name)]


def cpu() -> dict[str, bool]:
    """Instruction sets, and whether each can be used; the last one that can is the default.

    An instruction set can be used if the processor has it and the environment variable
    THINBENCH_MAX_ISA, read once, does not exclude it.

    Returns
    -------
    dict
        From name to bool, from "baseline" up.

    Examples
    --------
    >>> import thinbench
    >>> thinbench.cpu()["baseline"]
    True
    """
    return {name: _library.isa_available(name.encode()) == 1
            for name in _library.all_names(_library.isa_name)}
