# SPDX-License-Identifier: GPL-3.0-or-later
"""The command smf-collection: the Reeb graphs of many meshes, as a table."""

from __future__ import annotations

import argparse
import functools
import sys
from typing import Iterator, Optional, Sequence

_DESCRIPTION = """\
Computes the Reeb graph of each of many meshes, on all cores, and writes a table with one row a
mesh: numbers of vertices, faces, nodes and arcs, genus, poles, lengths, moduli, and what is wrong
with a mesh that has no result. A run that was ended goes on where it was, by the same command."""

_EPILOG = """\
Exit codes: 0 if every mesh has a result, 1 if some have none (their rows have the error), 2 if the
run cannot begin or go on, 130 if it was ended by Ctrl-C."""


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command, and return its exit code."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if not options.meshes and options.list is None:
        parser.error("there are no meshes: give files, or a list of them by --list")
    from ._collection import analyze, map_collection

    function = functools.partial(
        analyze, repair=options.repair, borders=options.borders, folder=options.folder
    )
    try:
        report = map_collection(
            _Meshes(options.meshes, options.list),
            function,
            table=options.table,
            workers=options.workers,
            progress=not options.quiet,
        )
    except KeyboardInterrupt:
        print(f"ended; {options.table} has what is done", file=sys.stderr)
        return 130
    except (OSError, RuntimeError, ValueError) as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 2
    if not options.quiet:
        print(
            f"{report.done} meshes, and {report.resumed} that were done before, "
            f"{report.failed} without a result: {options.table}"
        )
    return 1 if report.failed else 0


class _Meshes:
    """The names that are given, then those of a list, which is read as the run goes on."""

    def __init__(self, names: Sequence[str], listed: Optional[str]) -> None:
        self._names = names
        self._listed = listed

    def __iter__(self) -> Iterator[str]:
        yield from self._names
        if self._listed == "-":
            yield from _lines(sys.stdin)
        elif self._listed is not None:
            with open(self._listed, encoding="utf-8", errors="surrogateescape") as file:
                yield from _lines(file)


def _lines(file: Iterator[str]) -> Iterator[str]:
    for line in file:
        name = line.rstrip("\r\n")
        if name:
            yield name


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="smf-collection", description=_DESCRIPTION, epilog=_EPILOG
    )
    parser.add_argument("meshes", nargs="*", metavar="MESH", help="OFF, OBJ, PLY or STL files")
    parser.add_argument(
        "--list", metavar="FILE", help="a file with a name of a mesh in each line; - for stdin"
    )
    parser.add_argument(
        "--table",
        metavar="FILE",
        type=_table,
        default="collection.jsonl",
        help="where rows are written: JSON lines (.jsonl) or CSV (.csv); default: %(default)s",
    )
    parser.add_argument(
        "--folder", metavar="FOLDER", help="where to write skeletons (SWC) and graphs (GraphML)"
    )
    parser.add_argument(
        "--workers", metavar="N", type=_workers, help="processes; default: the number of cores"
    )
    parser.add_argument("--repair", action="store_true", help="repair meshes before")
    parser.add_argument(
        "--borders",
        metavar="HOW",
        type=_borders,
        help="openings are ends of the graph (ends) or filled (fill); or a length: those with "
        "shorter borders are filled; default: short ones are filled",
    )
    parser.add_argument("--quiet", action="store_true", help="print nothing but errors")
    return parser


def _table(text: str) -> str:
    if not text.endswith((".csv", ".jsonl", ".ndjson")):
        raise argparse.ArgumentTypeError(f"{text!r} ends with neither .jsonl nor .csv")
    return text


def _workers(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text) <= 10_000:
        raise argparse.ArgumentTypeError(f"{text!r} is no number from 1 to 10000")
    return int(text)


def _borders(text: str) -> object:
    if text in ("ends", "fill"):
        return text
    try:
        length = float(text)
    except ValueError:
        length = -1.0
    if not 0 <= length < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r} is neither ends, fill nor a length")
    return length


if __name__ == "__main__":
    sys.exit(main())
