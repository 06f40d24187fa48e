# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress of a solver: told to a function, or shown."""

from __future__ import annotations

import contextlib
import sys
from typing import Any, Callable, Iterator, NamedTuple, Optional, Union


class Progress(NamedTuple):
    """How far a solver has come.

    The number of vertices is that of the mesh at work: coarser meshes come first.
    """

    vertices: int
    iteration: int
    optimality: float


Callback = Callable[[Progress], Optional[bool]]
CoreCallback = Optional[Callable[[int, int, float], Optional[bool]]]


@contextlib.contextmanager
def told(progress: Union[bool, Callback, None]) -> Iterator[CoreCallback]:
    """Give the function that the solver calls; what it shows is gone in the end."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        with _shown() as show:
            yield lambda *numbers: show(Progress(*numbers))
    elif callable(progress):
        callback = progress
        yield lambda *numbers: callback(Progress(*numbers))
    else:
        raise TypeError(f"progress must be a function, True or None, not {progress!r}")


@contextlib.contextmanager
def _shown() -> Iterator[Callback]:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield _write
        print(file=sys.stderr)
        return
    with tqdm(unit=" iterations", leave=False) as bar:
        yield lambda progress: _update(bar, progress)


def _text(progress: Progress) -> str:
    return (
        f"{progress.vertices} vertices, iteration {progress.iteration}, "
        f"optimality {progress.optimality:.1e}"
    )


def _write(progress: Progress) -> None:
    print(f"\r{_text(progress)}\033[K", end="", file=sys.stderr, flush=True)


def _update(bar: Any, progress: Progress) -> None:
    bar.set_description_str(_text(progress))
    bar.update()
