"""Numbers that are what they must be: the library gets no others."""
from __future__ import annotations

from operator import index
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._library import InvalidArgument


def _in_range(given: Any, name: str, least: int, most: int) -> int:
    try:
        number = index(given)
    except TypeError:
        raise TypeError(f"{name}: expected a whole number, got {type(given).__name__}") from None
    if not least <= number <= most:
        raise InvalidArgument(-1, f"{name} {number} is not in {least}..{most}")
    return number


def unsigned(given: Any, name: str) -> int:
    """A field of a struct, which may stand for yes or no."""
    return _in_range(given, name, 0, 2**32 - 1)


def whole(given: Any, name: str) -> int:
    """An id, an index or a number of something: not yes or no, as in set_pinned(body, False)."""
    if isinstance(given, bool):
        raise TypeError(f"{name}: expected a whole number, got bool")
    return unsigned(given, name)


def mask(given: Any, name: str) -> int:
    """A set of bits; ~1 is all but the first."""
    return _in_range(given, name, -(2**31), 2**32 - 1) & 2**32 - 1


def value(given: Any, name: str) -> int:
    """One of an enumeration's."""
    return _in_range(given, name, -(2**31), 2**31 - 1)


def flag(given: Any, name: str) -> Any:
    return bool(given) if isinstance(given, np.bool_) else value(given, name)


def number(given: Any, name: str) -> float:
    if not isinstance(given, (str, bytes, bytearray)):
        try:
            return float(given)
        except TypeError:
            pass
    raise TypeError(f"{name}: expected a number, got {type(given).__name__}")


def numbers_as(number: np.dtype[Any], array: NDArray[Any]) -> NDArray[Any]:
    """Floats of the library's width; whole numbers only from such, and in range."""
    if array.dtype == number or array.size == 0:
        return array.astype(number, copy=False)
    whole = number.kind in "iu"
    if array.dtype.kind not in ("iu" if whole else "iuf"):
        raise TypeError(f"expected {'whole numbers' if whole else 'numbers'}, got {array.dtype}")
    if whole and not np.iinfo(number).min <= array.min() <= array.max() <= np.iinfo(number).max:
        raise ValueError(f"a number is out of the range of {number}")
    return array.astype(number)
