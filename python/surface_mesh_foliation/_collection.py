# SPDX-License-Identifier: GPL-3.0-or-later
"""Many shapes: a function applied to each file, on many processes or a cluster, and its rows."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections import deque
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from typing import (
    Any,
    Callable,
    Iterable,
    Iterator,
    Mapping,
    NamedTuple,
    Optional,
    Sequence,
    Sized,
    Union,
)

from ._errors import FoliationError
from ._table import Row, Table, plain

Record = Mapping[str, Any]
MakeExecutor = Callable[[], Executor]

# The columns of `analyze`, besides those that every row has.
ANALYZE_COLUMNS = (
    "vertices",
    "faces",
    "genus",
    "openings",
    "nodes",
    "arcs",
    "poles",
    "length",
    "lengths",
    "moduli",
    "loop_moduli",
    "skeleton",
    "graph",
    "pickle",
)
_WINDOW_OF_GIVEN_EXECUTOR = 256


class CollectionProgress(NamedTuple):
    """How far a collection has come.

    ``done`` counts the rows of this run, ``resumed`` the files that had a row before, ``failed``
    those of both with an error; ``total`` is None if the number of files is not known. ``row`` is
    the one just written.
    """

    done: int
    failed: int
    resumed: int
    total: Optional[int]
    row: Row


class CollectionReport(NamedTuple):
    """What a run of `map_collection` has done.

    Attributes
    ----------
    rows : list of dict or None
        The rows in the order in which they came; None if they are in a table.
    done, resumed : int
        The number of rows of this run, and of files that had a row in the table before.
    failed : int
        The number of rows of both with an error.
    is_complete : bool
        Whether every file has a row now; false if ``progress`` has stopped the run.
    """

    rows: Optional[list[Row]]
    done: int
    failed: int
    resumed: int
    is_complete: bool


Callback = Callable[[CollectionProgress], Optional[bool]]


def analyze(
    file: Any, *, repair: bool = False, borders: Any = None, folder: Any = None
) -> dict[str, Any]:
    """Compute the Reeb graph of the mesh in a file, and return a row for a table.

    Parameters
    ----------
    file : str or path
        The mesh.
    repair, borders
        As for `read`.
    folder : str or path, optional
        Where to write the skeleton as SWC, the graph as GraphML, and both as a pickled `Skeleton`,
        in files that are named after the mesh and, since meshes in different folders may have the
        same name, a number made from its whole name.

    Returns
    -------
    dict
        Numbers of ``vertices``, ``faces``, ``openings``, ``nodes`` and ``arcs``, the ``genus``,
        the vertices of each of the ``poles``, the ``length`` of the skeleton, by arc the
        ``lengths`` and ``moduli``, the ``loop_moduli`` of the loops found, the names of the files
        that were written, and ``seconds``. Of a mesh that has no result, ``error`` is the message
        and ``kind`` what is wrong.
    """
    from ._arrays import path
    from ._mesh import read
    from ._solver import reeb_graph

    name = path(file)
    begin = time.perf_counter()
    record: dict[str, Any] = {"kind": None, "error": None}
    try:
        mesh = read(name, repair=repair, borders=borders)
        record["vertices"] = mesh.number_of_vertices
        record["faces"] = mesh.number_of_faces
        record["openings"] = len(mesh.openings)
        r = reeb_graph(mesh)
        arcs = r.skeleton.arcs
        record.update(
            genus=r.genus,
            nodes=r.number_of_nodes,
            arcs=r.number_of_arcs,
            poles=[pole.vertices.tolist() for pole in r.poles],
            length=r.skeleton.length,
            lengths=[float(arc["length"]) for arc in arcs],
            moduli=r.moduli.tolist(),
            loop_moduli=sorted(float(loop.modulus) for loop in r.canonical_loops.values()),
        )
        if folder is not None:
            record.update(_write_files(r.skeleton, name, path(folder)))
    except FoliationError as error:
        record.update(_error_record(error))
    record["seconds"] = time.perf_counter() - begin
    return record


def map_collection(
    files: Iterable[Any],
    function: Callable[[str], Record] = analyze,
    executor: Union[Executor, MakeExecutor, None] = None,
    *,
    table: Any = None,
    columns: Optional[Sequence[str]] = None,
    workers: Optional[int] = None,
    window: Optional[int] = None,
    attempts: int = 2,
    progress: Union[bool, Callback, None] = None,
) -> CollectionReport:
    """Apply a function to each of many files, on many processes or a cluster.

    A file for which the function fails is a row with its error. If a worker dies, files at work are
    done again; a file whose worker dies time and again, although nothing else runs, is a row, too.
    If the run is ended, even by Ctrl-C, the table has what is done, and the same call goes on.

    Parameters
    ----------
    files : iterable of str or path
        The files, which are taken one by one as the run goes on. One that occurs twice is done
        once.
    function : callable
        Takes the name of a file, and returns a dict, whose values are text, numbers, or lists,
        dicts and arrays of these. Processes must be able to import it, or it is a
        ``functools.partial`` of such a function.
    executor : concurrent.futures.Executor or callable, optional
        Where the function runs, such as the ``client.get_executor()`` of Dask or an
        ``MPIPoolExecutor``; it is not shut down. Or a function that returns a new executor, which
        is called again when one breaks. By default, processes of this machine.
    table : str or path, optional
        The file to which each row is written as it comes: JSON lines (``.jsonl``), or CSV
        (``.csv``). Files that have a row there are not done again.
    columns : sequence of str, optional
        For a table in CSV and a function other than `analyze`, the keys of its dicts.
    workers : int, optional
        The number of processes, by default that of the cores. An executor has its own.
    window : int, optional
        How many files are in flight at a time, by default two for each process, or 256 with a given
        executor. It bounds the memory, and should exceed the number of workers.
    attempts : int
        How many times a file may end its worker, while nothing else runs, before it is given up.
    progress : callable or bool, optional
        A function that is called with a `CollectionProgress` after each row; if it returns False,
        the run is stopped. True shows how far the run has come.

    Returns
    -------
    CollectionReport
        With the rows, unless they are in a table.

    Raises
    ------
    FileError
        If the table cannot be written, is another file, or is being written by another process.
    concurrent.futures.BrokenExecutor
        If workers cannot start, or an executor breaks that cannot be made again.
    """
    from ._arrays import count, path, sequence

    names = _names(files)
    total = len(files) if isinstance(files, Sized) else None
    if not callable(function):
        raise TypeError(f"function must be callable, not {function!r}")
    number = _positive(_cores() if workers is None else count(workers, "workers"), "workers")
    if workers is not None and executor is not None:
        raise ValueError("workers: an executor is given, which has its own")
    default_window = 2 * number if executor is None else _WINDOW_OF_GIVEN_EXECUTOR
    limit = _positive(default_window if window is None else count(window, "window"), "window")
    tries = _positive(count(attempts, "attempts"), "attempts")
    if columns is None and getattr(function, "func", function) is analyze:
        columns = ANALYZE_COLUMNS
    elif columns is not None:
        columns = sequence(columns, "columns")
    source = _executors(executor, number)
    with contextlib.ExitStack() as stack:
        output = None if table is None else stack.enter_context(Table(path(table), columns))
        callback = stack.enter_context(_told(progress, total))
        rows = _Rows(output, total, callback)
        run = _Run(function, source, rows, limit, tries)
        is_complete = run(names)
    return CollectionReport(rows.kept, rows.done, rows.failed, rows.resumed, is_complete)


# ===  Rows


class _Rows:
    """Takes the rows as they come, and knows which files have one."""

    def __init__(
        self, table: Optional[Table], total: Optional[int], callback: Optional[Callback]
    ) -> None:
        self.kept: Optional[list[Row]] = [] if table is None else None
        self.done = self.failed = self.resumed = 0
        self._table = table
        self._total = total
        self._callback = callback
        self._before = {} if table is None else table.files

    def has(self, name: str) -> bool:
        """Return whether a file had a row before this run, and count it."""
        if name not in self._before:
            return False
        self.resumed += 1
        self.failed += self._before[name]
        return True

    def add(self, row: Row) -> bool:
        """Write a row, tell so, and return whether to go on."""
        self.write(row)
        if self._callback is None:
            return True
        state = CollectionProgress(self.done, self.failed, self.resumed, self._total, row)
        return self._callback(state) is not False

    def write(self, row: Row) -> None:
        """Write a row."""
        if self._table is not None:
            self._table.append(row)
        if self.kept is not None:
            self.kept.append(row)
        self.done += 1
        self.failed += row["error"] is not None


def _row(function: Callable[[str], Record], name: str) -> Row:
    """Return the row of a file, whatever the function does. Runs in a worker."""
    begin = time.perf_counter()
    try:
        record = function(name)
        if not isinstance(record, Mapping):
            raise TypeError(f"the function returned {type(record).__name__}, not a dict")
        found = plain(record)
    except (Exception, SystemExit) as error:
        found = _error_record(error)
    return _completed(name, found, time.perf_counter() - begin)


def _completed(name: str, found: Row, seconds: float) -> Row:
    common = {"file": name, "seconds": seconds, "kind": None, "error": None}
    return {**common, **found, "file": name}


def _error_record(error: BaseException) -> Row:
    kind = error.kind if isinstance(error, FoliationError) else type(error).__name__
    return {"kind": kind, "error": str(error) or type(error).__name__}


# ===  The run


class _Stopped(Exception):
    """The progress function has stopped the run."""


class _Run:
    """One run over all files.

    Every file that was taken from the list is in flight, is to be done again, or has a row. Whatever
    ends the run, a file without a row counts as not done, and is left to the next run.
    """

    def __init__(
        self,
        function: Callable[[str], Record],
        source: _Executors,
        rows: _Rows,
        window: int,
        attempts: int,
    ) -> None:
        self._function = function
        self._source = source
        self._rows = rows
        self._window = window
        self._attempts = attempts
        self._in_flight: dict[Future[Row], str] = {}
        self._again: deque[str] = deque()  # each has lost one worker, perhaps through another file
        self._lost_once: set[str] = set()

    def __call__(self, names: Iterator[str]) -> bool:
        """Run, and return whether all files have a row."""
        try:
            while self._fill(names):
                self._take(wait(self._in_flight, return_when=FIRST_COMPLETED).done)
        except _Stopped:
            self._abandon()
            return False
        except BaseException:
            self._abandon()
            raise
        self._source.close()
        return True

    def _fill(self, names: Iterator[str]) -> bool:
        """Hand out files until the window is full, and return whether any are in flight."""
        while len(self._in_flight) < self._window:
            name = self._again.popleft() if self._again else self._next(names)
            if name is None:
                break
            try:
                future = self._source.submit(_row, self._function, name)
            except BrokenExecutor as error:
                if not self._source.is_used:
                    raise  # another one would be no better
                self._again.appendleft(name)
                self._recover(error)
                continue
            self._in_flight[future] = name
        return len(self._in_flight) > 0

    def _next(self, names: Iterator[str]) -> Optional[str]:
        for name in names:
            if not self._rows.has(name):
                return name
        return None

    def _take(self, done: set[Future[Row]]) -> None:
        """Make rows of futures that are done, in the order in which they were submitted."""
        for future in [future for future in self._in_flight if future in done]:
            error = future.exception()
            if isinstance(error, BrokenExecutor):
                self._recover(error)
                return  # with all that were in flight
            name = self._in_flight.pop(future)
            if error is None:
                self._add(future.result())
            elif isinstance(error, Exception):  # such as KilledWorker of Dask
                self._add(_completed(name, _error_record(error), 0.0))
            else:
                raise error

    def _recover(self, error: BrokenExecutor) -> None:
        """Go on with a new executor after a worker has died.

        Which file has ended it is not known: all in flight are done again, and those that were in
        flight twice, alone.
        """
        if not self._source.can_make_another:
            raise error
        wait(self._in_flight)  # a broken executor breaks all of them at once
        lost = {f: name for f, name in self._in_flight.items() if f.exception() is not None}
        for future in lost:
            del self._in_flight[future]
        suspects = [name for name in lost.values() if name in self._lost_once]
        self._again.extend(name for name in lost.values() if name not in self._lost_once)
        self._lost_once.update(lost.values())
        self._source.close()
        for name in suspects:
            self._add(self._alone(name))

    def _alone(self, name: str) -> Row:
        """Return the row of a file while nothing else runs."""
        begin = time.perf_counter()
        for _ in range(self._attempts):
            try:
                row: Row = self._source.submit(_row, self._function, name).result()
                return row
            except BrokenExecutor:
                self._source.close()
            except Exception as error:  # such as a result that cannot be sent
                return _completed(name, _error_record(error), time.perf_counter() - begin)
        # If not even a worker without a file survives, the fault is not the file's.
        self._source.submit(_nothing).result()
        times = "once" if self._attempts == 1 else f"{self._attempts} times"
        message = f"the worker died {times} with this file alone"
        record = {"kind": "worker_died", "error": message}
        return _completed(name, record, time.perf_counter() - begin)

    def _add(self, row: Row) -> None:
        self._lost_once.discard(row["file"])
        if not self._rows.add(row):
            raise _Stopped

    def _abandon(self) -> None:
        """Give up what is in flight, except what is done already."""
        given_up = [future for future in self._in_flight if future.cancel() or not future.done()]
        self._source.close(wait=False)
        for future in self._in_flight:
            if future not in given_up and future.exception() is None:
                self._rows.write(future.result())


def _nothing() -> None:
    pass


# ===  Executors


class _Executors:
    """Where the function runs: a given executor, or one that can be made again."""

    def __init__(self, executor: Optional[Executor], make: Optional[MakeExecutor]) -> None:
        self.is_used = False  # whether the executor has taken anything since it was made
        self._executor = executor
        self._make = make

    @property
    def can_make_another(self) -> bool:
        return self._make is not None

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Submit a call to the executor, which is made if there is none."""
        if self._executor is None:
            assert self._make is not None
            made = self._make()
            if not isinstance(made, Executor):
                raise TypeError(f"executor: the function made {made!r}, which is no executor")
            self._executor = made
        future = self._executor.submit(function, *arguments)
        self.is_used = True
        return future

    def close(self, wait: bool = True) -> None:
        """End an executor that was made here; another one is made when it is needed."""
        if self._make is not None and self._executor is not None:
            executor, self._executor, self.is_used = self._executor, None, False
            executor.shutdown(wait=wait, cancel_futures=True)


def _executors(executor: Union[Executor, MakeExecutor, None], workers: int) -> _Executors:
    if executor is None:
        from ._processes import Processes

        return _Executors(None, lambda: Processes(workers))
    if isinstance(executor, Executor):
        return _Executors(executor, None)
    if callable(executor):
        return _Executors(None, executor)
    raise TypeError(f"executor must be a concurrent.futures.Executor, not {executor!r}")


# ===  Arguments


def _names(files: Any) -> Iterator[str]:
    """Return the names of files one by one, each once."""
    if isinstance(files, (str, bytes, os.PathLike)) or not isinstance(files, Iterable):
        raise TypeError(f"files must be a sequence of names, not {files!r}")
    return _unique(files)


def _unique(files: Iterable[Any]) -> Iterator[str]:
    from ._arrays import path

    seen = set()
    for file in files:
        name = path(file)
        if name not in seen:
            seen.add(name)
            yield name


def _positive(number: int, name: str) -> int:
    if number < 1:
        raise ValueError(f"{name} must be at least 1")
    return number


def _cores() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))  # those that this process may use
    return os.cpu_count() or 1


# ===  Files of results


def _write_files(skeleton: Any, name: str, folder: str) -> dict[str, str]:
    import hashlib
    import pickle

    os.makedirs(folder, exist_ok=True)
    number = hashlib.sha256(os.fsencode(os.path.abspath(name))).hexdigest()[:8]
    stem = os.path.join(folder, f"{os.path.splitext(os.path.basename(name))[0]}-{number}")
    _replace(f"{stem}.swc", skeleton.write_swc)
    _replace(f"{stem}.graphml", skeleton.write_graphml)
    data = pickle.dumps(skeleton)

    def write(file: str) -> None:
        with open(file, "wb") as stream:
            stream.write(data)

    _replace(f"{stem}.pickle", write)
    return {"skeleton": f"{stem}.swc", "graph": f"{stem}.graphml", "pickle": f"{stem}.pickle"}


def _replace(file: str, write: Callable[[str], None]) -> None:
    """Write a file that is whole whenever it is there."""
    unfinished = f"{file}.{os.getpid()}.unfinished"
    try:
        write(unfinished)
        os.replace(unfinished, file)
    except BaseException:
        with contextlib.suppress(OSError):
            os.remove(unfinished)
        raise


# ===  Progress


@contextlib.contextmanager
def _told(
    progress: Union[bool, Callback, None], total: Optional[int]
) -> Iterator[Optional[Callback]]:
    if progress is None or progress is False:
        yield None
    elif progress is True:
        with _shown(total) as show:
            yield show
    elif callable(progress):
        yield progress
    else:
        raise TypeError(f"progress must be a function, True or None, not {progress!r}")


@contextlib.contextmanager
def _shown(total: Optional[int]) -> Iterator[Callback]:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield _write
        print(file=sys.stderr)
        return
    with tqdm(total=total, unit=" shapes") as bar:
        yield lambda progress: _update(bar, progress)


def _write(progress: CollectionProgress) -> None:
    of_total = "" if progress.total is None else f" of {progress.total}"
    text = f"{progress.done + progress.resumed}{of_total} shapes, {progress.failed} failed"
    print(f"\r{text}\033[K", end="", file=sys.stderr, flush=True)


def _update(bar: Any, progress: CollectionProgress) -> None:
    bar.set_postfix_str(f"{progress.failed} failed", refresh=False)
    bar.update(progress.done + progress.resumed - bar.n)
