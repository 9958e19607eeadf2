"""Rules: what thinning computes."""

from __future__ import annotations

import os
import weakref
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from thinbench import _arrays, _library, _rule_files, _tables

_ACTIVATIONS = {"sigmoid": b"sigmoid", "linear": b"linear"}
_Recipe = Callable[[], int | None]  # picklable


class Rule:
    """What `thin` computes: a rule given by tables, a notation, a name, a file or weights of a net.

    A rule has sub-iterations, each of which computes all pixels from the same image; an iteration
    applies each of them once. Rule(tables) has 1 to 8, each a table of the new value of a pixel for
    each of the 512 values of its 3 x 3 window. Bit k of a window is its pixel k in raster order:
    bit 0 the north-west neighbour, bit 4 the pixel itself, bit 8 the south-east neighbour;
    foreground is 1. Tables are compiled to machine code for this processor at their first use.

    Immutable, hashable and picklable; threads may use a rule at the same time. Rules are equal if
    they have the same tables, border and limit or, without tables, the same name.

    Parameters
    ----------
    tables : array of bool, or of integers 0 and 1, shape (512,) or (sub-iterations, 512)
    border : {"background", "keep", "foreground"}
        What lies outside the image. "keep": background, and the outermost pixels never change.
    max_iterations : int, optional
        Stop after this many iterations, at least 1. Default: until nothing changes. A rule that
        both adds and removes pixels may never end, so it needs a limit, here or in each call.
    optimise : bool
        Search for fewer gates, up to 2 s per table instead of 20 ms.

    Examples
    --------
    >>> import numpy as np
    >>> import thinbench
    >>> erosion = thinbench.Rule(np.arange(512) == 511, max_iterations=1)
    >>> print(thinbench.apply(np.ones((3, 5), bool), erosion)[1].astype(int))
    [0 1 1 1 0]
    """

    __slots__ = ("__weakref__", "_handle", "_info", "_recipe", "_tables")

    def __init__(self, tables: npt.ArrayLike, *, border: str = "background",
                 max_iterations: int | None = None, optimise: bool = False) -> None:
        _arrays.one_of("border", border, _library.BORDERS)
        self._own(partial(_of_tables, _tables.bits("tables", tables), border, _arrays.limit(max_iterations),
                          bool(optimise)))

    def _own(self, recipe: _Recipe) -> Rule:
        """Makes and takes a handle of the library; the recipe makes that of an equal rule in another process."""
        self._handle = recipe()
        self._recipe = recipe
        # A thread may still thin when the program ends.
        weakref.finalize(self, _library.rule_destroy, self._handle).atexit = False
        self._info = _library.describe(self._handle)
        self._tables = _tables.from_words(self._info.words)
        self._tables.flags.writeable = False
        return self

    @classmethod
    def named(cls, name: str) -> Rule:
        """One of `rules()` or of `named_rules()`, with the border and limit that its source gives it.

        Examples
        --------
        >>> import thinbench
        >>> thinbench.Rule.named("majority")
        Rule(majority, 1 sub-iteration, border='background', max_iterations=1)
        """
        return cls.__new__(cls)._own(partial(_of_name, _tables.encoded("rule", name)))

    @classmethod
    def from_two_layer_net(cls, weights: npt.ArrayLike, activation: str = "sigmoid") -> Rule:
        """The two-layer net of the paper with other weights; docs/nets.md has the formula.

        Parameters
        ----------
        weights : array of shape (9, 9)
            A row for each neuron, the output neuron last: 8 weights, and the bias. Within
            [-1e30, 1e30].
        activation : {"sigmoid", "linear"}

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> weights = np.zeros((9, 9))
        >>> weights[8, 8] = -3                      # an output of 0 for all neighbourhoods
        >>> net = thinbench.Rule.from_two_layer_net(weights, "linear")
        >>> bool(thinbench.thin(np.ones((3, 5), bool), net).any())
        False
        """
        return cls.__new__(cls)._own(partial(_of_two_layer_net, _weights(weights, 9),
                                             _arrays.one_of("activation", activation, _ACTIVATIONS)))

    @classmethod
    def from_cluster(cls, last: npt.ArrayLike, weights: npt.ArrayLike) -> Rule:
        """The cluster of single-layer nets of the paper with other weights; docs/nets.md.

        Parameters
        ----------
        last : array of int, shape (nets,)
            Net i has the descriptors from that of the net before up to last[i]; the last one is 255.
        weights : array of shape (nets, 9)
            Of each net 8 weights, and the bias. Within [-1e30, 1e30].

        Examples
        --------
        >>> import thinbench
        >>> keep = thinbench.Rule.from_cluster([255], [[0, 0, 0, 0, 0, 0, 0, 0, 1]])
        >>> bool(keep.tables[0, 16])
        True
        """
        array = np.atleast_1d(_arrays.as_array("last", last))
        if array.ndim != 1 or array.size == 0:
            raise ValueError("last: expected shape (nets,) with at least one net, and weights of shape (nets, 9); "
                             f"got {array.shape}")
        ends = np.array([_arrays.integer("last", end) for end in array], np.int32)
        return cls.__new__(cls)._own(partial(_of_cluster, ends, _weights(weights, len(ends))))

    @classmethod
    def from_hensel(cls, notation: str, *, border: str = "background",
                    max_iterations: int | None = None, optimise: bool = False) -> Rule:
        """A cellular automaton in Hensel's notation, such as "B3/S23" or "B2-a/S12".

        After B stand the numbers of foreground neighbours with which a background pixel becomes
        foreground, after S those with which a foreground pixel remains foreground; letters choose
        or, after "-", exclude arrangements. Other parameters as for Rule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> life = thinbench.Rule.from_hensel("B3/S23", max_iterations=1)
        >>> blinker = np.zeros((3, 3), bool)
        >>> blinker[1] = True
        >>> print(thinbench.apply(blinker, life).astype(int))
        [[0 1 0]
         [0 1 0]
         [0 1 0]]
        """
        return cls(_tables.from_hensel(notation), border=border, max_iterations=max_iterations, optimise=optimise)

    @classmethod
    def from_patterns(cls, patterns: Iterable[str], *, border: str = "background",
                      max_iterations: int | None = None, optimise: bool = False) -> Rule:
        """The table of Pillow's `ImageMorph.LutBuilder(patterns).build_lut()`.

        A pattern such as "4:(... .1. 111)->1" gives the result for all windows that match. Pillow's
        MorphOp also clears the outermost pixels of an image, which no table does. Other parameters
        as for Rule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> dilation = thinbench.Rule.from_patterns(["4:(... .0. .1.)->1"], max_iterations=1)
        >>> print(thinbench.apply(np.array([[False, True, False, False]]), dilation).astype(int))
        [[1 1 1 0]]
        """
        return cls(_tables.from_patterns(patterns), border=border, max_iterations=max_iterations, optimise=optimise)

    @classmethod
    def from_values(cls, lut: npt.ArrayLike, order: str = "matlab", *, border: str = "background",
                    max_iterations: int | None = None, optimise: bool = False) -> Rule:
        """The 512 values of `makelut(function, 3)`, or an array of such rows.

        `order` is "matlab" or "octave", whose functions number windows differently: by columns from
        the north-west pixel as bit 0 or as bit 8. Other parameters as for Rule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> lut = np.zeros(512, bool)
        >>> lut[0b000_010_010] = True               # the pixel and its west neighbour
        >>> rule = thinbench.Rule.from_values(lut)
        >>> [int(window) for window in np.flatnonzero(rule.tables)]
        [24]
        """
        return cls(_tables.from_values(lut, order), border=border, max_iterations=max_iterations, optimise=optimise)

    @classmethod
    def from_removals(cls, removed: npt.ArrayLike, order: str = "descriptor", *, border: str = "background",
                      max_iterations: int | None = None, optimise: bool = False) -> Rule:
        """A thinning rule: 256 values by neighbours, true where a foreground pixel is removed.

        An array of shape (256,) or (sub-iterations, 256). `order` says which neighbour each bit of
        the index is: "descriptor" (east, then anticlockwise: the tables of scikit-image's `thin`),
        "clockwise" (from north-west: the table of scikit-image's `skeletonize`) or "raster" (from
        north-west). Other parameters as for Rule.

        Examples
        --------
        >>> import numpy as np
        >>> import thinbench
        >>> outline = thinbench.Rule.from_removals(np.arange(256) == 255, max_iterations=1)
        >>> print(thinbench.apply(np.ones((3, 5), bool), outline)[1].astype(int))
        [1 0 0 0 1]
        """
        return cls(_tables.from_removals(removed, order), border=border,
                   max_iterations=max_iterations, optimise=optimise)

    @classmethod
    def from_function(cls, next_value: Callable[[npt.NDArray[np.bool_]], Any], *, border: str = "background",
                      max_iterations: int | None = None, optimise: bool = False) -> Rule:
        """One sub-iteration: `next_value(window)` for all 512 windows.

        It gets an array of bool of shape (3, 3) and returns the new value of the pixel in the
        middle, True or False. It is called here only, not by `apply`. Other parameters as for Rule.

        Examples
        --------
        >>> import thinbench
        >>> rule = thinbench.Rule.from_function(lambda w: w[1, 1] or w[0, 1])
        >>> rule.gates
        (1,)
        """
        return cls(_tables.from_function(next_value), border=border, max_iterations=max_iterations, optimise=optimise)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Rule:
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
        if not len(self._tables):
            raise ValueError(f"rule: {self.name!r} has no tables that could be saved")
        _rule_files.write(path, _rule_files.Rule(self._tables, self.border, self.max_iterations))

    @property
    def handle(self) -> int | None:
        """For the C interface; valid as long as the rule."""
        return self._handle

    @property
    def name(self) -> str:
        """That of a built-in or named rule, "custom" for tables and "net" for weights."""
        return self._info.name

    @property
    def is_built_in(self) -> bool:
        """Whether it is one of `rules()`."""
        return self._info.is_built_in

    @property
    def description(self) -> str:
        """Of a built-in or named rule; else empty, as is `source`."""
        return self._info.description

    @property
    def source(self) -> str:
        """Where a named rule is from."""
        return self._info.source

    @property
    def tables(self) -> npt.NDArray[np.bool_]:
        """Read-only, of shape (sub-iterations, 512); none for "mb2"."""
        return self._tables.view()

    @property
    def border(self) -> str:
        """"background", "keep" or "foreground", unless a call says otherwise."""
        return self._info.border

    @property
    def max_iterations(self) -> int | None:
        """The limit unless a call says otherwise. None: until nothing changes."""
        limit = self._info.max_iterations
        return None if limit == _library.UNLIMITED else limit

    @property
    def reach(self) -> int:
        """How many pixels the effect of a pixel advances in an iteration."""
        return self._info.reach

    @property
    def gates(self) -> tuple[int, ...]:
        """The number of three-input gates of each sub-iteration's circuit."""
        return tuple(_library.gates(self._handle, index) for index in range(len(self._tables)))

    def _key(self) -> tuple[Any, ...]:
        what = self._tables.tobytes() if len(self._tables) else self.name
        return what, self.border, self.max_iterations

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Rule) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def __reduce__(self) -> tuple[Any, ...]:
        return _copied, (type(self), self._recipe), getattr(self, "__dict__", None)

    def __repr__(self) -> str:
        count = len(self._tables)
        sub_iterations = f"{_arrays.counted(count, 'sub-iteration')}, " if count else ""
        return (f"Rule({self.name}, {sub_iterations}border={self.border!r}, "
                f"max_iterations={self.max_iterations})")


def _copied(kind: type[Rule], recipe: _Recipe) -> Rule:
    return kind.__new__(kind)._own(recipe)


def _of_tables(tables: _tables.Tables, border: str, max_iterations: int, optimise: bool) -> int | None:
    words = _tables.to_words(tables)
    return _library.handle_from(_library.rule_from_tables, words.ctypes.data, len(words),
                                _library.thinning(_library.BORDERS[border], max_iterations), optimise)


def _of_name(name: bytes) -> int | None:
    try:
        return _library.handle_from(_library.rule_named, name)
    except ValueError as error:
        known = _library.all_names(_library.rule_name)
        meant = (_arrays.meant(name.decode(), [*known, *(f"thin_{one}" for one in known)])
                 or "; rules() and named_rules() have the names, Rule.from_hensel takes a notation")
        raise ValueError(f"{error}{meant}") from None


def _of_two_layer_net(neurons: npt.NDArray[np.float32], activation: bytes) -> int | None:
    return _library.handle_from(_library.rule_from_two_layer_net, neurons.ctypes.data, activation)


def _of_cluster(ends: npt.NDArray[np.int32], nets: npt.NDArray[np.float32]) -> int | None:
    return _library.handle_from(_library.rule_from_cluster, ends.ctypes.data, nets.ctypes.data, len(ends))


def _weights(weights: npt.ArrayLike, neurons: int) -> npt.NDArray[np.float32]:
    array = _arrays.as_array("weights", weights)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"weights: expected numbers, got dtype {array.dtype}")
    if array.shape != (neurons, 9):
        raise ValueError(f"weights: expected shape ({neurons}, 9), got {array.shape}")
    with np.errstate(over="ignore"):  # infinite weights are rejected by the library
        return np.array(array, np.float32, order="C")
