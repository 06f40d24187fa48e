# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions, which say what is wrong and where."""

from __future__ import annotations

from typing import Any, Sequence


class FoliationError(Exception):
    """The base of all exceptions of the package.

    Attributes
    ----------
    message : str
        One line that says what is wrong, where, and often what to do.
    kind : str
        What is wrong, for programs: ``"not_closed"``, ``"invalid_pole"``,
        ``"intersecting_loops"``, ... (the names of ``Problem_kind`` in C++, in lower case).
    vertices, faces, loops : tuple of int
        The places concerned, if any.
    """

    def __init__(
        self,
        message: str,
        kind: str = "unknown",
        vertices: Sequence[int] = (),
        faces: Sequence[int] = (),
        loops: Sequence[int] = (),
    ) -> None:
        super().__init__(message)
        self.message = message
        self.kind = kind
        self.vertices = tuple(vertices)
        self.faces = tuple(faces)
        self.loops = tuple(loops)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.kind, self.vertices, self.faces, self.loops)

    def __str__(self) -> str:
        return self.message


class FileError(FoliationError, OSError):
    """A file cannot be read or written, or does not follow its format."""


class MeshError(FoliationError, ValueError):
    """A mesh is no oriented manifold of triangles, or something else is wrong with it."""


class LoopsError(FoliationError, ValueError):
    """Poles, loops and heights do not form a loop system."""


class ParameterError(FoliationError, ValueError):
    """An argument is out of its range."""


class EdgeValueError(FoliationError, ValueError):
    """Values of edges are not those of a foliation with closed leaves."""


class SolverError(FoliationError, RuntimeError):
    """A linear system could not be factored or solved."""


class CertificateError(FoliationError, RuntimeError):
    """A foliation failed its certificate: no wrong graph is ever returned."""


class StoppedError(FoliationError, RuntimeError):
    """The solver was stopped without a result."""


_CLASS_OF_KIND = {
    "file": FileError,
    "no_loop": LoopsError,
    "invalid_pole": LoopsError,
    "invalid_loop": LoopsError,
    "intersecting_loops": LoopsError,
    "inessential_loop": LoopsError,
    "homotopic_loops": LoopsError,
    "invalid_height": LoopsError,
}


def problem(
    kind: str,
    message: str,
    vertices: Sequence[int],
    faces: Sequence[int],
    loops: Sequence[int],
) -> FoliationError:
    """Return the exception that a problem would be, without raising it."""
    return _CLASS_OF_KIND.get(kind, MeshError)(message, kind, vertices, faces, loops)
