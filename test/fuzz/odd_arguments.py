# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of the module that nobody should hand over, chosen by bytes; see python_boundary.py."""

import numpy as np
import surface_mesh_foliation as smf


class LikeArray:
    """What numpy takes for an array, of a size that is not that of its elements."""

    def __len__(self):
        return 5

    def __getitem__(self, i):
        raise IndexError(i)


class FailingArray:
    def __array__(self, *_, **__):
        raise ValueError("no array today")


NAN = float("nan")
INFINITY = float("inf")
INTEGERS = [-1, 0, 1, 2, 11, 12, 2**31 - 1, 2**31, 2**32, 2**63 - 1, -(2**63)]
REALS = [NAN, INFINITY, -INFINITY, -0.0, 0.5, -1.0, 1e308, 5e-324, 1e-9, 1e20]
OTHERS = [
    None, True, 2**64, -(10**400), 1j, "", "fill", "ends", "auto", "cotangent", "\udc80", "a\0b",
    b"a", (), [], {}, [[]], [None], [[0, 1], [2]], [0, [1]], {0}, range(3), object(), int,
    np.zeros((0, 3)), np.array(3), np.array(0.5), np.array("a"), np.array(None), np.int8(-1),
    np.uint64(2**64 - 1), np.float16(0.5), np.longdouble(1), np.bool_(True), np.datetime64(0, "s"),
    np.ma.masked, LikeArray(), FailingArray(),
]  # fmt: skip
ODD = INTEGERS + REALS + OTHERS
# (no arrays of times: numpy 1.24 writes beyond its memory when it makes short strings of them)
DTYPES = [
    "int8", "uint8", "int16", "uint32", ">i4", ">i8", "uint64", "float16", "float32", ">f8",
    "longdouble", "complex64", "bool", "object", "U3", "S2", "i4,f8",
]  # fmt: skip


def unaligned(array):
    memory = bytearray(1) + array.tobytes()
    return np.frombuffer(memory, array.dtype, offset=1).reshape(array.shape)


def read_only(array):
    result = array.copy()
    result.setflags(write=False)
    return result


LAYOUTS = [
    lambda a: a[::-1], lambda a: a[..., ::-1], lambda a: a[::2], lambda a: np.repeat(a, 2, 0)[::2],
    lambda a: a[:-1], lambda a: a[:0], lambda a: a[..., :0], lambda a: a[..., :2], lambda a: a[0],
    lambda a: np.concatenate([a, a]), lambda a: a.T, lambda a: a[None], lambda a: a[..., None],
    lambda a: a.ravel(), np.asfortranarray, lambda a: np.broadcast_to(a[:1], a.shape),
    lambda a: a.byteswap().newbyteorder(), unaligned, read_only, lambda a: a.tolist(), memoryview,
    lambda a: a.view(np.recarray), np.ma.asarray, lambda a: list(a), lambda a: tuple(a.tolist()),
    lambda a: iter(a), lambda a: a.view(np.uint8), np.ascontiguousarray, np.hstack, np.unique,
]  # fmt: skip


CANNOT_DO = (TypeError, ValueError, IndexError, OverflowError, AttributeError, RuntimeError)


def with_odd_element(source, array):
    result = array.copy()
    value = source.choose(REALS if array.dtype.kind == "f" else INTEGERS)
    result.flat[source.below(256) % max(1, result.size)] = value
    return result


def odd_array(source, array):
    """Return the array with another type, layout or element, as far as numpy can do that."""
    kind = source.below(4)
    try:
        if kind == 0:
            return array.astype(source.choose(DTYPES))
        if kind == 1:
            return source.choose(LAYOUTS)(array)
        if kind == 2:
            return odd_array(source, source.choose(LAYOUTS)(array))
        return with_odd_element(source, array)
    except CANNOT_DO:
        return array


def odd(source, value):
    """Return mostly the value itself, and else one like it, or another."""
    way = source.below(8)
    if way < 4:
        return value
    if isinstance(value, np.ndarray) and way < 7:
        return odd_array(source, value)
    if isinstance(value, (list, tuple)) and len(value) > 0 and way < 7:
        result = list(value)
        place = source.below(len(result))
        result[place] = odd(source, result[place])
        if way == 6:
            return result
        return smf.Loop(*result) if isinstance(value, smf.Loop) else type(value)(result)
    return source.choose(ODD)
