# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of what users pass in, with messages that name the argument."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any, Iterable, Optional

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]
else:  # numpy.typing takes a while to import
    Floats = Ints = Bools = np.ndarray

_LARGEST = np.iinfo(np.int64).max


def _array(values: Any, name: str, kinds: str, what: str) -> npt.NDArray[Any]:
    try:
        array = np.asarray(values)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name}: not an array of {what}: {error}") from error
    if array.size == 0 and array.dtype.kind in "fiu":
        return array
    if array.dtype.kind not in kinds:
        raise TypeError(f"{name} must be {what}, not of the type {array.dtype}")
    return array


def _check_shape(array: npt.NDArray[Any], name: str, columns: Optional[int]) -> None:
    if columns is None:
        if array.ndim != 1:
            raise ValueError(f"{name} must have one dimension, not the shape {array.shape}")
    elif array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} must have the shape (n, {columns}), not {array.shape}")


def floats(values: Any, name: str, columns: Optional[int] = None) -> Floats:
    """Return a contiguous array of numbers, a list or a table with so many columns."""
    array = _array(values, name, "fiu", "real numbers")
    _check_shape(array, name, columns)
    return np.ascontiguousarray(array, dtype=np.float64)


def ints(values: Any, name: str, columns: Optional[int] = None) -> Ints:
    """Return a contiguous array of integers, a list or a table with so many columns."""
    array = _array(values, name, "iu", "integers")
    _check_shape(array, name, columns)
    if array.dtype.kind == "u" and array.size > 0 and array.max() > _LARGEST:
        raise ValueError(f"{name} has the number {array.max()}, which is too large")
    return np.ascontiguousarray(array, dtype=np.int64)


def values_of(values: Any, name: str, size: int, of_what: str) -> Floats:
    """Return an array with a number for each vertex or edge."""
    array = floats(values, name)
    if len(array) != size:
        raise ValueError(f"{name}: {len(array)} numbers for {size} {of_what}")
    return array


def integer(value: Any, name: str) -> int:
    """Return an integer, such as the number of a vertex."""
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} must be an integer, not {value!r}")
    try:
        result = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, not {value!r}") from None
    if abs(result) > _LARGEST:
        raise ValueError(f"{name}, {result}, is too large")
    return result


def count(value: Any, name: str) -> int:
    """Return an integer that is not negative."""
    number = integer(value, name)
    if not 0 <= number < 2**31:
        raise ValueError(f"{name}, {number}, is negative or too large")
    return number


def real(value: Any, name: str) -> float:
    """Return a number, which may be infinite, but is not NaN."""
    if isinstance(value, (bool, np.bool_, str, bytes)):
        raise TypeError(f"{name} must be a number, not {value!r}")
    try:
        result = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {value!r}") from None
    except OverflowError:
        raise ValueError(f"{name} is too large") from None
    if result != result:
        raise ValueError(f"{name} is not a number (NaN)")
    return result


def path(value: Any) -> str:
    """Return a file name as text."""
    import os

    if hasattr(value, "read"):
        raise TypeError("a file is given by its name or path, not as an open file")
    return os.fsdecode(value)


def read_only(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Return the array, which can no longer be written to: others share it."""
    array.setflags(write=False)
    return array


def sequence(values: Any, name: str) -> list[Any]:
    """Return the elements of any iterable, but not of a string."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise TypeError(f"{name} must be a sequence, not {values!r}")
    return list(np.asarray(values) if isinstance(values, memoryview) else values)
