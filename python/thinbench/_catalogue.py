"""What there is, and what this machine can run."""

from __future__ import annotations

from thinbench import _library
from thinbench._rules import Rule


def _rules(built_in: bool) -> dict[str, Rule]:
    """The rules of the library that are built in, or those that are not."""
    rules = {name: Rule.named(name) for name in _library.all_names(_library.rule_name)}
    return {name: rule for name, rule in rules.items() if rule.is_built_in == built_in}


def rules() -> dict[str, Rule]:
    """The built-in rules, most of which thin.

    Returns
    -------
    dict
        From name to Rule, in the order of the catalogue.

    Examples
    --------
    >>> import thinbench
    >>> print(thinbench.rules()["zhang_suen"].description)
    Zhang and Suen 1984, two sub-iterations; loses 2 x 2 blocks
    """
    return _rules(built_in=True)


def named_rules() -> dict[str, Rule]:
    """Other rules that are known by a name, which are given by tables.

    Returns
    -------
    dict
        From name to Rule, sorted by name.

    Examples
    --------
    >>> import thinbench
    >>> thinbench.named_rules()["majority"].description
    'foreground where five or more of the nine pixels are'
    """
    return _rules(built_in=False)


def isas() -> dict[str, bool]:
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
    >>> thinbench.isas()["baseline"]
    True
    """
    return {name: _library.isa_available(name.encode()) == 1
            for name in _library.all_names(_library.isa_name)}
