# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of results, one row a line, which grow while a run goes on and survive its end."""

from __future__ import annotations

import csv
import errno
import io
import json
import math
import os
from typing import Any, Iterator, Mapping, Optional, Sequence

from ._errors import FileError

Row = dict[str, Any]

# These come first in every row; ``error`` and ``kind`` are None if all went well.
COMMON_COLUMNS = ("file", "seconds", "kind", "error")


def plain(value: Any) -> Any:
    """Return a value as JSON has it: arrays become lists, and numbers that are not finite None."""
    if value is None or isinstance(value, (str, bool, int)):
        return value
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {_key(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if hasattr(value, "tolist"):  # arrays and numbers of numpy
        return plain(value.tolist())
    if isinstance(value, os.PathLike):
        return os.fsdecode(value)
    raise TypeError(f"a table has no place for a value of the type {type(value).__name__}")


def _key(key: Any) -> str:
    if not isinstance(key, str):
        raise TypeError(f"the names of columns are text, not {key!r}")
    return key


class Table:
    """A table that is open for writing.

    Every row is one line, ended by a line feed and written by one call, so that whatever ends the
    run, at most the last line of the file is not whole. Opening the table drops such a line. While
    it is open, no other process can open it for writing.

    Attributes
    ----------
    files : dict
        The files that had a row when the table was opened, and whether the row has an error.
    """

    def __init__(self, name: str, columns: Optional[Sequence[str]] = None) -> None:
        self.name = name
        self.files: dict[str, bool] = {}
        self._columns = _columns(name, columns)
        flags = os.O_RDWR | os.O_CREAT | os.O_APPEND | getattr(os, "O_BINARY", 0)
        try:
            self._descriptor = os.open(name, flags, 0o666)
        except OSError as error:
            raise FileError(f"{name} cannot be written: {error.strerror}", "file") from None
        try:
            self._lock()
            self._resume()
        except BaseException:
            self.close()
            raise

    def append(self, row: Row) -> None:
        """Write a row."""
        line = _json_line(row) if self._columns is None else _csv_line(row, self._columns)
        self._write(line)

    def close(self) -> None:
        os.close(self._descriptor)

    def __enter__(self) -> Table:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _write(self, line: bytes) -> None:
        """Write a line, or nothing of it: another may follow."""
        end = os.fstat(self._descriptor).st_size
        try:
            # A regular file takes all of it, unless the disk is full.
            if os.write(self._descriptor, line) < len(line):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        except OSError as error:
            os.ftruncate(self._descriptor, end)
            raise FileError(f"{self.name} cannot be written: {error.strerror}", "file") from None

    def _lock(self) -> None:
        try:
            import fcntl
        except ImportError:  # no such locks on this system
            return
        try:
            # Locks of this kind are not inherited by workers, which may outlive this process.
            fcntl.lockf(self._descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except (BlockingIOError, PermissionError):
            raise FileError(f"{self.name} is being written by another process", "file") from None
        except OSError:  # a file system without locks
            return

    def _resume(self) -> None:
        """Note the files that have a row, and cut off a last line that is not whole."""
        whole = 0
        broken: Optional[str] = None
        # Closing another descriptor of the file would give up the lock.
        with open(self._descriptor, "rb", closefd=False) as file:
            for number, line in enumerate(file, 1):
                if broken is not None:
                    raise FileError(broken, "file")
                try:
                    row = _parsed(line, self._columns, number)
                except ValueError as error:
                    broken = f"{self.name}, line {number}: {error}"
                    if number == 1 and line.endswith(b"\n"):  # not one of our tables
                        raise FileError(broken, "file") from None
                    continue
                whole += len(line)
                if row is not None:
                    self.files[row["file"]] = row.get("error") is not None
        if broken is not None:
            os.ftruncate(self._descriptor, whole)
        if whole == 0 and self._columns is not None:
            self._write(_csv_text(self._columns))


def read_table(file: Any) -> Iterator[Row]:
    """Read the rows of a table, one after another.

    Parameters
    ----------
    file : str or path
        A table that `map_collection` has written, or is writing. In CSV all values are text, and
        an empty one is None.

    Yields
    ------
    dict
        The rows. A last line that is not whole is left out.
    """
    name = os.fsdecode(file)
    columns: Optional[list[str]] = [] if _is_csv(name) else None
    try:
        stream = open(name, "rb")
    except OSError as error:
        raise FileError(f"{name} cannot be read: {error.strerror}", "file") from None
    with stream:
        for number, line in enumerate(stream, 1):
            if not line.endswith(b"\n"):
                return
            try:
                if number == 1 and columns is not None:
                    columns = next(csv.reader([_text(line)]))
                    continue
                row = _parsed(line, columns, number)
            except ValueError as error:
                raise FileError(f"{name}, line {number}: {error}", "file") from None
            if row is not None:
                yield row


def _is_csv(name: str) -> bool:
    if name.endswith(".csv"):
        return True
    if name.endswith((".jsonl", ".ndjson")):
        return False
    raise ValueError(f"table: {name!r} ends with neither .jsonl nor .csv")


def _columns(name: str, columns: Optional[Sequence[str]]) -> Optional[list[str]]:
    """Return the columns of a table in CSV; None for JSON, where every row names its own."""
    if not _is_csv(name):
        return None
    if columns is None:
        raise ValueError("columns: a table in CSV needs the names of the columns beforehand")
    if isinstance(columns, str):
        raise TypeError("columns must be a sequence of names, not a text")
    result = [*COMMON_COLUMNS, *(_key(c) for c in columns if c not in COMMON_COLUMNS)]
    if len(set(result)) < len(result):
        raise ValueError("columns: a name occurs twice")
    if any("\n" in column or "\r" in column for column in result):
        raise ValueError("columns: a name has a line break")
    return result


def _json_line(row: Row) -> bytes:
    return json.dumps(row, allow_nan=False).encode("ascii") + b"\n"


def _csv_line(row: Row, columns: Sequence[str]) -> bytes:
    for key in row:
        if key not in columns:
            raise ValueError(f"columns: there is none for {key!r}")
    if "\n" in row["file"] or "\r" in row["file"]:
        raise ValueError(f"table: CSV cannot have the file name {row['file']!r}; use .jsonl")
    return _csv_text([_cell(row.get(column)) for column in columns])


def _cell(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, str):
        return " ".join(value.splitlines())  # a row is a line
    return json.dumps(value)


def _csv_text(cells: Sequence[str]) -> bytes:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(cells)
    return text.getvalue().encode("utf-8", "surrogateescape")  # of names that are not UTF-8


def _text(line: bytes) -> str:
    return line.decode("utf-8", "surrogateescape")


def _parsed(line: bytes, columns: Optional[Sequence[str]], number: int) -> Optional[Row]:
    """Return the row of a line; None for the line with the names of the columns."""
    if not line.endswith(b"\n"):
        raise ValueError("the line is not whole")
    if columns is None:
        row = json.loads(line)
        if not isinstance(row, dict) or not isinstance(row.get("file"), str):
            raise ValueError("the line is no row of a table")
        return row
    if number == 1:
        if line != _csv_text(columns):
            raise ValueError("the columns are not those of this run")
        return None
    try:
        (cells,) = csv.reader([_text(line)], strict=True)
    except csv.Error as error:
        raise ValueError(str(error)) from None
    if len(cells) != len(columns):
        raise ValueError(f"{len(cells)} values for {len(columns)} columns")
    return {column: cell if cell else None for column, cell in zip(columns, cells)}
