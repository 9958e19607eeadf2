"""Rules given as tables: any function of the 3 x 3 window of a pixel."""

from __future__ import annotations

import os
import weakref
from collections.abc import Callable, Iterable
from typing import Any, Literal, NamedTuple, TypeVar, overload

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library, _rule_files, _tables
from thinbench._thinning import limit_of, run

_BORDERS = {name: name.encode() for name in _rule_files.BORDERS}
_Rule = TypeVar("_Rule", bound="CustomRule")


class NamedRule(NamedTuple):
    """What `named_rules` says about a rule."""

    description: str
    source: str
    sub_iterations: int
    border: str
    max_iterations: int | None


def named_rules() -> dict[str, NamedRule]:
    """Custom rules that are known by a name, for `CustomRule.named`.

    Returns
    -------
    dict
        From name to NamedRule, sorted by name. Its max_iterations are the default: None where the
        rule repeats until nothing changes.

    Examples
    --------
    >>> import thinbench
    >>> thinbench.named_rules()["majority"].max_iterations
    1
    """
    found = {}
    for name in _library.all_names(_library.named_rule_name):
        rule = _library.find_named_rule(name.encode())
        found[name] = NamedRule(rule.description, rule.source, rule.sub_iterations, rule.border,
                                rule.max_iterations or None)
    return found


class CustomRule:
    """A rule of 1 to 8 sub-iterations, each a table of the new value of a pixel for each of the 512
    values of its 3 x 3 window.

    Bit k of a window is its pixel k in raster order: bit 0 the north-west neighbour, bit 4 the
    pixel itself, bit 8 the south-east neighbour; foreground is 1. A sub-iteration computes all
    pixels from the same image; an iteration applies every sub-iteration once. `apply` compiles the
    rule to machine code for this processor at its first use.

    Immutable, hashable and picklable; threads may use a rule at the same time.

    Parameters
    ----------
    tables : array of bool, or of integers 0 and 1, shape (512,) or (sub-iterations, 512)
    border : {"background", "keep", "foreground"}
        What lies outside the image. "keep": background, and the outermost pixels never change.
    max_iterations : int, optional
        Stop after this many iterations, at least 1. Default: until nothing changes, which is only
        for rules that remove pixels and never add any, or the reverse.
    optimise : bool
        Search for fewer gates, up to 2 s per table instead of 20 ms.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> erosion = thinbench.CustomRule(np.arange(512) == 511, max_iterations=1)
    >>> print(thinbench.apply(np.ones((3, 5), bool), erosion)[1].astype(int))
    [0 1 1 1 0]
    """

    __slots__ = ("__weakref__", "_border", "_gates", "_handle", "_max_iterations", "_optimise",
                 "_tables")

    def __init__(self, tables: npt.ArrayLike, *, border: str = "background",
                 max_iterations: int | None = None, optimise: bool = False) -> None:
        self._tables = _tables.bits("tables", tables)
        self._tables.flags.writeable = False
        self._max_iterations = limit_of(max_iterations) or None
        self._border = border
        self._optimise = bool(optimise)
        self._gates: tuple[int, ...] | None = None
        self._handle = _library.custom_rule(
            _tables.to_words(self._tables), _arrays.one_of("border", border, _BORDERS),
            self._max_iterations or 0, self._optimise)
        weakref.finalize(self, _library.custom_rule_destroy, self._handle)

    @classmethod
    def from_hensel(cls: type[_Rule], notation: str, *, border: str = "background",
                    max_iterations: int | None = None, optimise: bool = False) -> _Rule:
        """A cellular automaton in Hensel's notation, such as "B3/S23" or "B2-a/S12".

        After B stand the numbers of foreground neighbours with which a background pixel becomes
        foreground, after S those with which a foreground pixel remains foreground; letters choose
        or, after "-", exclude arrangements. Other parameters as for CustomRule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> life = thinbench.CustomRule.from_hensel("B3/S23", max_iterations=1)
        >>> blinker = np.zeros((3, 3), bool)
        >>> blinker[1] = True
        >>> print(thinbench.apply(blinker, life).astype(int))
        [[0 1 0]
         [0 1 0]
         [0 1 0]]
        """
        return cls(_tables.from_hensel(notation), border=border, max_iterations=max_iterations,
                   optimise=optimise)

    @classmethod
    def from_patterns(cls: type[_Rule], patterns: Iterable[str], *, border: str = "background",
                      max_iterations: int | None = None, optimise: bool = False) -> _Rule:
        """The table of Pillow's `ImageMorph.LutBuilder(patterns).build_lut()`.

        A pattern such as "4:(... .1. 111)->1" gives the result for all windows that match. Pillow's
        MorphOp also clears the outermost pixels of an image, which no table does. Other parameters
        as for CustomRule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> dilation = thinbench.CustomRule.from_patterns(["4:(... .0. .1.)->1"], max_iterations=1)
        >>> print(thinbench.apply(np.array([[False, True, False, False]]), dilation).astype(int))
        [[1 1 1 0]]
        """
        return cls(_tables.from_patterns(patterns), border=border, max_iterations=max_iterations,
                   optimise=optimise)

    @classmethod
    def from_makelut(cls: type[_Rule], lut: npt.ArrayLike, order: str = "matlab", *,
                     border: str = "background", max_iterations: int | None = None,
                     optimise: bool = False) -> _Rule:
        """The 512 values of `makelut(function, 3)`, or an array of such rows.

        `order` is "matlab" or "octave", whose functions number windows differently: by columns from
        the north-west pixel as bit 0 or as bit 8. Other parameters as for CustomRule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> lut = np.zeros(512, bool)
        >>> lut[0b000_010_010] = True               # the pixel and its west neighbour
        >>> rule = thinbench.CustomRule.from_makelut(lut)
        >>> [int(window) for window in np.flatnonzero(rule.tables)]
        [24]
        """
        return cls(_tables.from_makelut(lut, order), border=border, max_iterations=max_iterations,
                   optimise=optimise)

    @classmethod
    def from_deletions(cls: type[_Rule], deleted: npt.ArrayLike, order: str = "descriptor", *,
                       border: str = "background", max_iterations: int | None = None,
                       optimise: bool = False) -> _Rule:
        """A thinning rule: 256 values by neighbours, true where a foreground pixel is removed.

        An array of shape (256,) or (sub-iterations, 256). `order` says which neighbour each bit of
        the index is: "descriptor" (east, then anticlockwise: the tables of scikit-image's `thin`),
        "clockwise" (from north-west: the table of scikit-image's `skeletonize`) or "raster" (from
        north-west). Other parameters as for CustomRule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> outline = thinbench.CustomRule.from_deletions(np.arange(256) == 255, max_iterations=1)
        >>> print(thinbench.apply(np.ones((3, 5), bool), outline)[1].astype(int))
        [1 0 0 0 1]
        """
        return cls(_tables.from_deletions(deleted, order), border=border,
                   max_iterations=max_iterations, optimise=optimise)

    @classmethod
    def from_function(cls: type[_Rule], next_value: Callable[[npt.NDArray[np.bool_]], Any], *,
                      border: str = "background", max_iterations: int | None = None,
                      optimise: bool = False) -> _Rule:
        """One sub-iteration: `next_value(window)` for all 512 windows.

        It gets an array of bool of shape (3, 3) and returns the new value of the pixel in the
        middle. It is called here only, not by `apply`. Other parameters as for CustomRule.

        Examples
        --------
        >>> import thinbench
        >>> rule = thinbench.CustomRule.from_function(lambda w: w[1, 1] or w[0, 1])
        >>> rule.gates
        (1,)
        """
        return cls(_tables.from_function(next_value), border=border, max_iterations=max_iterations,
                   optimise=optimise)

    @classmethod
    def named(cls: type[_Rule], name: str) -> _Rule:
        """One of `named_rules()`, with the border and limit that its source gives it.

        Examples
        --------
        >>> import thinbench
        >>> thinbench.CustomRule.named("thin")
        CustomRule(2 sub-iterations, border='background', max_iterations=None)
        """
        rule = _library.find_named_rule(_tables.encoded("name", name))
        return cls(_tables.from_words(rule.words), border=rule.border,
                   max_iterations=rule.max_iterations or None)

    @classmethod
    def load(cls: type[_Rule], path: str | os.PathLike[str]) -> _Rule:
        """The rule of a JSON file; docs/rules.md has the format.

        Raises
        ------
        OSError, ValueError
            If the file cannot be read, or is not a rule: the error names the file and the field.
        """
        rule = _rule_files.read(path)
        return cls(rule.tables, border=rule.border, max_iterations=rule.max_iterations)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the tables, the border and the limit to a JSON file, for `load`."""
        _rule_files.write(path, _rule_files.Rule(self._tables, self._border, self._max_iterations))

    def with_limit(self: _Rule, max_iterations: int | None) -> _Rule:
        """The same rule with another limit.

        Examples
        --------
        >>> import thinbench
        >>> thinbench.CustomRule.named("life").with_limit(100).max_iterations
        100
        """
        return type(self)(self._tables, border=self._border, max_iterations=max_iterations,
                          optimise=self._optimise)

    @property
    def tables(self) -> npt.NDArray[np.bool_]:
        """Read-only, of shape (sub-iterations, 512)."""
        return self._tables.view()

    @property
    def border(self) -> str:
        """"background", "keep" or "foreground"."""
        return self._border

    @property
    def max_iterations(self) -> int | None:
        """None: until nothing changes."""
        return self._max_iterations

    @property
    def optimise(self) -> bool:
        """Whether it searches longer for fewer gates."""
        return self._optimise

    @property
    def gates(self) -> tuple[int, ...]:
        """The number of three-input gates of each sub-iteration's circuit."""
        if self._gates is None:
            self._gates = tuple(_library.custom_rule_gates(self._handle, index)
                                for index in range(len(self._tables)))
        return self._gates

    def _key(self) -> tuple[bytes, str, int | None, bool]:
        return self._tables.tobytes(), self._border, self._max_iterations, self._optimise

    def __eq__(self, other: object) -> bool:
        return isinstance(other, CustomRule) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self._tables, self._border, self._max_iterations,
                           self._optimise)

    def __repr__(self) -> str:
        count = len(self._tables)
        return (f"{type(self).__name__}({count} sub-iteration{'s' if count > 1 else ''}, "
                f"border={self._border!r}, max_iterations={self._max_iterations})")


def _restored(cls: type[CustomRule], tables: npt.NDArray[np.bool_], border: str,
              max_iterations: int | None, optimise: bool) -> CustomRule:
    return cls(tables, border=border, max_iterations=max_iterations, optimise=optimise)


@overload
def apply(image: npt.ArrayLike, rule: CustomRule, *, threads: int = ...,
          return_iterations: Literal[False] = ..., out: npt.NDArray[Any] | None = ...,
          ) -> npt.NDArray[Any]: ...


@overload
def apply(image: npt.ArrayLike, rule: CustomRule, *, threads: int = ...,
          return_iterations: Literal[True], out: npt.NDArray[Any] | None = ...,
          ) -> tuple[npt.NDArray[Any], int]: ...


@overload
def apply(image: npt.ArrayLike, rule: CustomRule, *, threads: int = ..., return_iterations: bool,
          out: npt.NDArray[Any] | None = ...,
          ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]: ...


def apply(image: npt.ArrayLike, rule: CustomRule, *, threads: int = 1,
          return_iterations: bool = False, out: npt.NDArray[Any] | None = None,
          ) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], int]:
    """Apply a custom rule to a binary image, or to every image of a stack.

    Parameters
    ----------
    image : array of bool or uint8, shape (H, W) or (N, H, W)
        As in `thin`.
    rule : CustomRule
        Has the border and the limit.
    threads, return_iterations, out
        As in `thin`. The iterations include the last one if it changed nothing.

    Returns
    -------
    array of the shape and dtype of the image
        True or 255 for foreground, else 0. With `return_iterations` a tuple of this and an int.

    Raises
    ------
    TypeError, ValueError
        If an argument does not fit; then nothing is written.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> noisy = np.ones((5, 5), bool)
    >>> noisy[2, 2] = False
    >>> bool(thinbench.apply(noisy, thinbench.CustomRule.named("fill"))[2, 2])
    True
    """
    if not isinstance(rule, CustomRule):
        raise TypeError(f"rule: expected a CustomRule, got {rule!r}")
    options = _library.options(threads=_arrays.integer("threads", threads))
    return run(_library.apply, rule._handle, image, options, return_iterations, out)
