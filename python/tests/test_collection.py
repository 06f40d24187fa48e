# SPDX-License-Identifier: GPL-3.0-or-later
"""Collections: rows, tables, runs that are ended and go on, workers that die, the command."""

import functools
import json
import os
import pickle
import signal
import subprocess
import sys
import time
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf
from surface_mesh_foliation.collection import main
from test_read import off

HERE = Path(__file__).parent
PATHS = [str(Path(smf.__file__).parents[1]), str(HERE), str(HERE.parent / "examples")]


class Immediate(Executor):
    """Runs everything in this process, when the first result is waited for, and counts."""

    def __init__(self, breaks_after=None):
        self.in_flight = self.most = self.submitted = 0
        self._breaks_after = breaks_after

    def submit(self, function, /, *arguments):
        if self.submitted == self._breaks_after:
            raise BrokenExecutor("a worker died")
        self.submitted += 1
        future = Late(self, function, arguments)
        self.in_flight += 1
        self.most = max(self.most, self.in_flight)
        return future


class Late(Future):
    """Becomes done when someone waits for it."""

    def __init__(self, executor, function, arguments):
        super().__init__()
        self._call = executor, function, arguments
        self.__dict__["_state"] = "PENDING"

    @property
    def _state(self):
        call = self.__dict__.pop("_call", None)
        if call is not None:
            executor, function, arguments = call
            executor.in_flight -= 1
            self.set_result(function(*arguments))
        return self.__dict__["_state"]

    @_state.setter
    def _state(self, state):
        self.__dict__["_state"] = state


# ===  What runs in workers. Each run leaves a byte in a file beside the one it is about.


def note(file):
    with open(f"{file}.runs", "ab") as stream:
        stream.write(b".")


def runs(file):
    return os.path.getsize(f"{file}.runs") if os.path.exists(f"{file}.runs") else 0


def size(file):
    note(file)
    return {"size": len(os.path.basename(file)), "pid": os.getpid()}


def slow_size(file):
    time.sleep(0.02)
    return size(file)


def very_slow_size(file):
    record = size(file)
    time.sleep(60 if os.path.basename(file) > "03" else 0)
    return record


def interrupt(file):
    os.kill(os.getpid(), signal.SIGINT)
    return size(file)


def die_once(file):
    if file.endswith("05") and runs(file) == 0:
        note(file)
        os.kill(os.getpid(), signal.SIGKILL)
    return slow_size(file)


def die_always(file):
    if file.endswith(("03", "11")):
        note(file)
        os.kill(os.getpid(), signal.SIGKILL)
    return slow_size(file)


def fail(file):
    if file.endswith("01"):
        raise ZeroDivisionError("nothing to divide by\nin two lines")
    if file.endswith("02"):
        return 3
    if file.endswith("03"):
        return {"function": fail}
    if file.endswith("04"):
        sys.exit("out")
    if file.endswith("05"):
        return {"nan": np.nan, "array": np.arange(3), "one": np.int64(1), "path": Path("a")}
    return {}


def cannot_start():
    raise OSError("no license")


@pytest.fixture
def files(tmp_path):
    return [str(tmp_path / f"{i:02}") for i in range(20)]


@pytest.fixture
def meshes(tmp_path):
    """Return the names of three meshes, a file that is broken, and none."""
    for folder, arm in (("one", 7), ("two", 9)):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "body.off").write_text(off(*shapes.body(arm=arm)))
    (tmp_path / "torus.off").write_text(off(*shapes.torus(12, 18)))
    (tmp_path / "broken.off").write_text("OFF\n3 1 0\n0 0 0\n")
    names = ("one/body.off", "two/body.off", "torus.off", "broken.off", "missing.off")
    return [str(tmp_path / name) for name in names]


def by_file(rows):
    return {row["file"]: row for row in rows}


def check_complete(rows, files, wrong=()):
    """Check that there is one row for each file, with the result that it should have."""
    rows = list(rows)
    assert sorted(row["file"] for row in rows) == sorted(files)
    for row in rows:
        if row["file"] not in wrong:
            assert row["error"] is None and int(row["size"]) == 2


# ===  Rows


def test_a_row_has_what_is_computed(meshes, tmp_path):
    report = smf.map_collection(meshes, workers=2)
    assert report[1:] == (5, 2, 0, True)
    rows = by_file(report.rows)
    for name in meshes[:3]:
        r = smf.reeb_graph(smf.read(name))
        row = rows[name]
        assert row["error"] is None and row["kind"] is None and row["seconds"] > 0
        counts = row["vertices"], row["faces"], row["nodes"], row["arcs"], row["genus"]
        mesh = r.mesh
        assert counts[:2] == (mesh.number_of_vertices, mesh.number_of_faces)
        assert counts[2:] == (r.number_of_nodes, r.number_of_arcs, r.genus)
        assert row["poles"] == [pole.vertices.tolist() for pole in r.poles]
        assert row["moduli"] == r.moduli.tolist()
        assert row["lengths"] == [arc["length"] for arc in r.skeleton.arcs]
        assert row["length"] == pytest.approx(sum(row["lengths"]))
        assert row["loop_moduli"] == sorted(x.modulus for x in r.canonical_loops.values())
    assert len(rows[meshes[0]]["loop_moduli"]) > 0
    for name in meshes[3:]:
        assert rows[name]["kind"] == "file" and name in rows[name]["error"]


def test_files_of_results_are_written(meshes, tmp_path):
    function = functools.partial(smf.analyze, folder=tmp_path / "results")
    rows = smf.map_collection(meshes, function, Immediate()).rows
    assert "skeleton" not in rows[3]
    written = sorted(str(file) for file in (tmp_path / "results").iterdir())
    names = [row[kind] for row in rows[:3] for kind in ("skeleton", "graph", "pickle")]
    assert written == sorted(names)  # two meshes have the same name in different folders
    for row in rows[:3]:
        r = smf.reeb_graph(smf.read(row["file"]))
        assert Path(row["skeleton"]).read_text() == r.skeleton.swc()
        assert "<graphml" in Path(row["graph"]).read_text()
        graph = pickle.loads(Path(row["pickle"]).read_bytes())
        assert smf.distance(graph, r) == 0


def test_whatever_a_function_does_is_a_row(files, tmp_path):
    table = tmp_path / "table.jsonl"
    report = smf.map_collection(files[:6], fail, workers=2, table=table)
    assert report.rows is None and report.failed == 4
    rows = by_file(smf.read_table(table))
    kinds = [rows[file]["kind"] for file in files[:6]]
    assert kinds == [None, "ZeroDivisionError", "TypeError", "TypeError", "SystemExit", None]
    assert rows[files[1]]["error"] == "nothing to divide by\nin two lines"
    again = smf.map_collection(files[:6], fail, Immediate(), table=table)
    assert (again.done, again.resumed, again.failed) == (0, 6, 4)
    found = {key: rows[files[5]][key] for key in ("nan", "array", "one", "path")}
    assert found == {"nan": None, "array": [0, 1, 2], "one": 1, "path": "a"}


def test_csv_has_the_same_rows(meshes, files, tmp_path):
    table = tmp_path / "table.csv"
    smf.map_collection(meshes, executor=Immediate(), table=table)
    expected = smf.map_collection(meshes, executor=Immediate()).rows
    for row, wanted in zip(smf.read_table(table), expected):
        for key, value in wanted.items():
            if key in ("seconds", "file", "error", "kind"):
                assert key == "seconds" or row[key] == value
            else:
                assert json.loads(row[key]) == value
    table = tmp_path / "other.csv"
    with pytest.raises(ValueError, match="columns"):
        smf.map_collection(files[:6], fail, Immediate(), table=table)
    with pytest.raises(ValueError, match="none for 'nan'"):
        smf.map_collection(files[:6], fail, Immediate(), table=table, columns=["one"])
    columns = ["nan", "array", "one", "path"]
    table = tmp_path / "third.csv"
    smf.map_collection(files[:6], fail, Immediate(), table=table, columns=columns)
    rows = list(smf.read_table(table))
    assert [row["one"] for row in rows] == [None] * 5 + ["1"]
    assert rows[1]["error"] == "nothing to divide by in two lines"
    with pytest.raises(ValueError, match="use .jsonl"):
        smf.map_collection(["a\nb"], fail, Immediate(), table=table, columns=columns)


# ===  Workers that die


def test_a_worker_that_is_killed_loses_nothing(files, tmp_path):
    table = tmp_path / "table.jsonl"
    killed = []

    def kill(progress):
        if progress.done == 4:
            killed.append(progress.row["pid"])
            os.kill(progress.row["pid"], signal.SIGKILL)

    smf.map_collection(files, slow_size, workers=2, table=table, progress=kill)
    rows = list(smf.read_table(table))
    check_complete(rows, files)
    assert killed and len({row["pid"] for row in rows}) > 2  # there were new workers


def test_a_file_that_kills_a_worker_once_is_done_again(files):
    report = smf.map_collection(files, die_once, workers=2)
    check_complete(report.rows, files)
    assert report.failed == 0 and runs(files[5]) == 2


def test_a_file_that_kills_every_worker_is_a_row(files):
    report = smf.map_collection(files, die_always, workers=2, attempts=3)
    wrong = files[3], files[11]
    check_complete(report.rows, files, wrong)
    assert report.failed == 2
    for file in wrong:
        row = by_file(report.rows)[file]
        assert row["kind"] == "worker_died" and "3 times" in row["error"]
        assert runs(file) == 5  # twice among others, and then alone


def test_workers_that_cannot_start_are_no_fault_of_files(files, tmp_path):
    table = tmp_path / "table.jsonl"

    def make():
        return ProcessPoolExecutor(1, initializer=cannot_start)

    with pytest.raises(BrokenExecutor):
        smf.map_collection(files, size, make, table=table)
    assert list(smf.read_table(table)) == []


def test_an_executor_that_breaks_is_made_again_if_it_can_be(files, tmp_path):
    table = tmp_path / "table.jsonl"
    with pytest.raises(BrokenExecutor):
        smf.map_collection(files, size, Immediate(8), table=table, window=3)
    rows = list(smf.read_table(table))
    assert 5 <= len(rows) <= 8 and all(row["error"] is None for row in rows)
    made = []

    def make():
        made.append(Immediate(8))
        return made[-1]

    check_complete(smf.map_collection(files, size, make, window=3).rows, files)
    assert [executor.submitted for executor in made] == [8, 8, 4]
    with pytest.raises(BrokenExecutor):  # others would be broken, too
        smf.map_collection(files, size, lambda: Immediate(0))


# ===  Runs that are ended


@pytest.mark.parametrize("suffix", ["jsonl", "csv"])
def test_a_run_is_resumed(files, tmp_path, suffix):
    table = tmp_path / f"table.{suffix}"
    options = {"table": table, "columns": ["size", "pid"]}
    report = smf.map_collection(
        files, slow_size, workers=2, progress=lambda progress: progress.done < 5, **options
    )
    done = [row["file"] for row in smf.read_table(table)]
    assert not report.is_complete and 5 <= report.done == len(done) < len(files)
    report = smf.map_collection(files + files, slow_size, workers=2, **options)
    assert report.is_complete
    assert (report.done, report.resumed) == (len(files) - len(done), len(done))
    check_complete(smf.read_table(table), files)
    assert all(runs(file) == 1 for file in done)


def test_ctrl_c_leaves_what_is_done(files, tmp_path):
    table = tmp_path / "table.jsonl"

    def end(progress):
        if progress.done == 6:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        smf.map_collection(files, slow_size, workers=2, table=table, progress=end)
    done = [row["file"] for row in smf.read_table(table)]
    assert 6 <= len(done) < len(files)
    smf.map_collection(files, slow_size, workers=2, table=table)
    check_complete(smf.read_table(table), files)
    assert all(runs(file) == 1 for file in done)


def test_what_is_finished_when_a_run_ends_has_a_row(files, tmp_path):
    table = tmp_path / "table.jsonl"
    options = {"table": table, "window": 4}  # all four are done when the first one is waited for
    smf.map_collection(files, size, Immediate(), progress=lambda progress: False, **options)
    assert [row["file"] for row in smf.read_table(table)] == files[:4]


def test_ctrl_c_is_not_for_workers(files):
    check_complete(smf.map_collection(files, interrupt, workers=2).rows, files)


@pytest.mark.parametrize("suffix", ["jsonl", "csv"])
def test_a_last_line_that_is_not_whole_is_done_again(files, tmp_path, suffix):
    table = tmp_path / f"table.{suffix}"
    options = {"table": table, "columns": ["size", "pid"]}
    smf.map_collection(files[:3], size, Immediate(), **options)
    whole = table.read_bytes()
    begin = whole.rindex(b"\n", 0, -1) + 1
    for end in range(begin, len(whole)):
        table.write_bytes(whole[:end])
        assert len(list(smf.read_table(table))) == 2
        report = smf.map_collection(files[:4], size, Immediate(), **options)
        assert (report.done, report.resumed) == (2, 2)
        check_complete(smf.read_table(table), files[:4])
    table.write_bytes(whole[:begin] + b"\0\0\0\n")  # what a crash of the system may leave
    assert smf.map_collection(files[:3], size, Immediate(), **options).resumed == 2
    check_complete(smf.read_table(table), files[:3])
    for end in range(whole.index(b"\n") + 1):  # within the first line
        table.write_bytes(whole[:end])
        assert smf.map_collection(files[:1], size, Immediate(), **options).done == 1
        check_complete(smf.read_table(table), files[:1])


def test_a_table_is_never_overwritten_if_it_is_another_file(files, tmp_path):
    table = tmp_path / "table.jsonl"
    table.write_text('{"file": "a"}\nsomething\n{"file": "b"}\n')
    with pytest.raises(smf.FileError, match="line 2"):
        smf.map_collection(files, size, Immediate(), table=table)
    with pytest.raises(smf.FileError, match="line 2"):
        list(smf.read_table(table))
    assert len(table.read_text().splitlines()) == 3
    for text in ("a text\n", "[1]\n", '{"name": 3}\n'):
        table.write_text(text)
        with pytest.raises(smf.FileError, match="line 1"):
            smf.map_collection(files, size, Immediate(), table=table)
        assert table.read_text() == text
    table = tmp_path / "table.csv"
    table.write_text("name,size\na,3\n")
    with pytest.raises(smf.FileError, match="columns are not those of this run"):
        smf.map_collection(files, size, Immediate(), table=table, columns=["size"])
    assert table.read_text() == "name,size\na,3\n"


def test_a_full_disk_leaves_whole_rows(files, tmp_path, monkeypatch):
    table = tmp_path / "table.jsonl"
    write = os.write
    calls = []

    def write_half(descriptor, line):
        calls.append(line)
        return write(descriptor, line[: len(line) // 2] if len(calls) == 3 else line)

    monkeypatch.setattr(os, "write", write_half)
    with pytest.raises(smf.FileError, match="cannot be written"):
        smf.map_collection(files, size, Immediate(), table=table, window=4)
    monkeypatch.undo()
    lines = table.read_bytes().splitlines(keepends=True)
    assert lines[:2] == calls[:2] and lines[2:] == calls[3:]
    smf.map_collection(files, size, Immediate(), table=table)
    check_complete(smf.read_table(table), files)


def start(code, *arguments):
    command = [sys.executable, "-c", f"import sys; sys.path[:0] = {PATHS!r}\n{code}", *arguments]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for(condition):
    end = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < end, "nothing happens"
        time.sleep(0.01)


def is_running(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="needs /proc")
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_what_ends_the_run_ends_its_workers(files, tmp_path, number):
    table = tmp_path / "table.jsonl"
    code = (
        "import surface_mesh_foliation as smf, test_collection\n"
        "smf.map_collection(sys.argv[2:], test_collection.very_slow_size, workers=2,"
        " table=sys.argv[1])"
    )
    process = start(code, str(table), *files)
    try:
        wait_for(lambda: runs(files[4]) and runs(files[5]))
        wait_for(lambda: table.read_bytes().count(b"\n") == 4)
        with pytest.raises(smf.FileError, match="another process"):
            smf.map_collection(files, size, Immediate(), table=table)
        workers = {row["pid"] for row in smf.read_table(table)}
        assert any(map(is_running, workers))
        process.send_signal(number)
        process.communicate(timeout=120)
        assert process.returncode != 0
    finally:
        process.kill()
    wait_for(lambda: not any(map(is_running, workers)))
    report = smf.map_collection(files, size, Immediate(), table=table)
    assert report.resumed == 4 and runs(files[0]) == 1
    check_complete(smf.read_table(table), files)


# ===  Memory, executors, progress


def test_only_a_window_of_files_is_in_flight(tmp_path):
    taken = []

    def many():
        for i in range(5000):
            taken.append(i)
            yield tmp_path / f"{i:05}"

    ahead = []

    def look(progress):
        ahead.append(len(taken) - progress.done)

    executor = Immediate()
    table = tmp_path / "table.jsonl"
    report = smf.map_collection(
        many(), fail, executor, table=table, window=7, progress=look
    )
    assert report.done == executor.submitted == 5000 and report.rows is None
    assert executor.most == 7 and max(ahead) <= 7
    assert sum(1 for _ in smf.read_table(table)) == 5000


def test_a_given_executor_is_used_and_not_shut_down(files):
    with ProcessPoolExecutor(2) as pool:
        rows = smf.map_collection(files, size, pool).rows
        check_complete(rows, files)
        pids = {row["pid"] for row in rows}
        assert pool.submit(os.getpid).result() in pids and os.getpid() not in pids


def test_an_error_of_the_executor_is_a_row(files):
    class Cluster(Immediate):
        def submit(self, function, /, name_function, name):
            future = Future()
            if name == files[2]:
                future.set_exception(MemoryError("this worker was ended"))
            else:
                future.set_result(function(name_function, name))
            return future

    rows = by_file(smf.map_collection(files, size, Cluster()).rows)
    row = rows.pop(files[2])
    assert (row["kind"], row["error"]) == ("MemoryError", "this worker was ended")
    check_complete(rows.values(), files[:2] + files[3:])


def test_progress_is_told_and_shown(files, capsys):
    told = []
    smf.map_collection(files[:6], fail, Immediate(), progress=told.append)
    assert [p.done for p in told] == list(range(1, 7))
    assert told[-1].failed == 4 and told[-1].total == 6 and told[-1].row["file"] in files
    smf.map_collection(files[:6], fail, Immediate(), progress=True)
    shown = capsys.readouterr().err
    assert "6" in shown and "4 failed" in shown
    smf.map_collection(iter(files[:6]), fail, Immediate(), progress=told.append)
    assert told[-1].total is None


@pytest.mark.parametrize(
    "change, error",
    [
        ({"files": "a.off"}, TypeError),
        ({"files": 3}, TypeError),
        ({"files": [3]}, TypeError),
        ({"function": "analyze"}, TypeError),
        ({"executor": 3}, TypeError),
        ({"executor": lambda: 3}, TypeError),
        ({"workers": 0}, ValueError),
        ({"workers": -1}, ValueError),
        ({"workers": 1.5}, TypeError),
        ({"workers": 2, "executor": Immediate()}, ValueError),
        ({"window": 0}, ValueError),
        ({"window": True}, TypeError),
        ({"attempts": 0}, ValueError),
        ({"table": "table.txt"}, ValueError),
        ({"table": 3}, TypeError),
        ({"table": "no/such/folder/table.jsonl"}, smf.FileError),
        ({"table": "table.csv", "columns": ["a", "a"]}, ValueError),
        ({"table": "table.csv", "columns": [3]}, TypeError),
        ({"table": "table.csv", "columns": "size"}, TypeError),
        ({"table": "table.csv", "columns": ["a\nb"]}, ValueError),
        ({"progress": 3}, TypeError),
    ],
)
def test_wrong_arguments_are_refused(files, tmp_path, monkeypatch, change, error):
    monkeypatch.chdir(tmp_path)
    arguments = {"files": files, "function": size, **change}
    with pytest.raises(error):
        smf.map_collection(**arguments)
    assert not any(runs(file) for file in files)


# ===  Distances and retrieval


@pytest.fixture(scope="module")
def graphs():
    some = [shapes.body(), shapes.body(arm=9), shapes.torus(12, 18), shapes.body(arm=9, leg=7)]
    return [smf.reeb_graph(mesh) for mesh in some]


def test_a_distance_matrix_has_all_distances(graphs):
    matrix = smf.distance_matrix(graphs)
    np.testing.assert_array_equal(matrix, matrix.T)
    np.testing.assert_array_equal(np.diag(matrix), 0)
    for i, first in enumerate(graphs):
        for j, second in enumerate(graphs):
            assert matrix[i, j] == pytest.approx(smf.distance(first, second))
    assert matrix[0, 2] == np.inf and 0 < matrix[0, 1] < 1
    with ProcessPoolExecutor(2) as pool:
        np.testing.assert_array_equal(smf.distance_matrix(iter(graphs), pool), matrix)
    assert smf.distance_matrix([]).shape == (0, 0)


def test_the_nearest_shapes_are_retrieved(graphs):
    found = smf.retrieve(graphs[0], graphs, k=9)
    assert [neighbor.name for neighbor in found][0::3] == [0, 2]  # itself; what does not match
    assert found[0].distance == found[0].moduli_distance == 0
    distances = [smf.distance(graphs[0], graphs[n.name]) for n in found]
    assert [n.distance for n in found] == distances == sorted(distances)
    named = {name: graph.skeleton for name, graph in zip("abcd", graphs)}
    assert smf.retrieve(graphs[0], named, k=2) == [
        neighbor._replace(name="abcd"[neighbor.name]) for neighbor in found[:2]
    ]
    assert smf.retrieve(graphs[0], (graph for graph in graphs), k=9) == found


def test_ties_are_retrieved_in_order(graphs):
    found = smf.retrieve(graphs[1], [graphs[2], graphs[1], graphs[0], graphs[1], graphs[2]])
    assert [neighbor.name for neighbor in found] == [1, 3, 2, 0, 4]


def test_shapes_that_do_not_match_are_ordered_by_moduli(graphs):
    thin = smf.reeb_graph(shapes.torus(12, 18, radius=0.2))
    found = smf.retrieve(graphs[2], [graphs[0], thin, graphs[2]], k=3)
    assert [neighbor.name for neighbor in found] == [2, 1, 0]
    others = [smf.reeb_graph(shapes.plate(1)), smf.reeb_graph(shapes.plate(2)), thin]
    found = smf.retrieve(graphs[0], others, k=3)
    assert all(neighbor.distance == np.inf for neighbor in found)
    moduli = [neighbor.moduli_distance for neighbor in found]
    assert moduli == sorted(moduli) and moduli[0] < moduli[2]


def test_the_distance_of_moduli_is_that_of_distributions(graphs):
    def sampled(first, second, number):
        """Compare quantiles in the middle of equal steps, which no jump of them crosses."""
        at = (np.arange(number) + 0.5) / number
        one, other = (np.sort(np.log(r.moduli)) for r in (first, second))
        both = one[(at * len(one)).astype(int)] - other[(at * len(other)).astype(int)]
        return np.abs(both).mean()

    first, second = graphs[0], graphs[2]
    number = 60 * first.number_of_arcs * second.number_of_arcs
    (neighbor,) = smf.retrieve(first, [second])
    assert first.number_of_arcs != second.number_of_arcs
    assert neighbor.moduli_distance == pytest.approx(sampled(first, second, number))
    (back,) = smf.retrieve(second, [first])
    assert back.moduli_distance == pytest.approx(neighbor.moduli_distance)


def test_wrong_arguments_of_retrieval_are_refused(graphs):
    for k, error in ((0, ValueError), (-1, ValueError), (1.5, TypeError), (True, TypeError)):
        with pytest.raises(error):
            smf.retrieve(graphs[0], graphs, k)
    for query, collection in ((3, graphs), (graphs[0], 3), (graphs[0], [3]), (graphs[0], "ab")):
        with pytest.raises(TypeError):
            smf.retrieve(query, collection)
    for arguments in ((3,), ([3],), (graphs, 3)):
        with pytest.raises(TypeError):
            smf.distance_matrix(*arguments)


# ===  The command


def test_the_command_writes_a_table(meshes, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main([*meshes[:3], "--workers", "2", "--quiet"]) == 0
    assert capsys.readouterr() == ("", "")
    assert {row["file"] for row in smf.read_table("collection.jsonl")} == set(meshes[:3])
    (tmp_path / "names.txt").write_text("\n".join(meshes) + "\n\n")
    options = ["--list", "names.txt", "--table", "t.csv", "--folder", "out", "--borders", "ends"]
    assert main([*options, "--repair", "--workers", "1"]) == 1
    assert "5 meshes, and 0 that were done before, 2 without" in capsys.readouterr().out
    rows = by_file(smf.read_table("t.csv"))
    assert set(rows) == set(meshes) and Path(rows[meshes[0]]["skeleton"]).exists()
    assert main([*options, "--workers", "1"]) == 1
    assert "0 meshes, and 5 that were done before, 2 without" in capsys.readouterr().out
    assert main([meshes[0], *options[2:4]]) == 0  # of those asked for, all have a result


@pytest.mark.parametrize(
    "arguments, message",
    [
        ([], "there are no meshes"),
        (["a.off", "--workers", "0"], "no number from 1"),
        (["a.off", "--workers", "two"], "no number from 1"),
        (["a.off", "--table", "t.txt"], "neither .jsonl nor .csv"),
        (["a.off", "--borders", "-1"], "neither ends, fill nor a length"),
        (["a.off", "--borders", "nan"], "neither ends, fill nor a length"),
        (["a.off", "--table", "no/folder/t.csv"], "cannot be written"),
        (["--list", "no-such-list"], "no-such-list"),
    ],
)
def test_the_command_refuses_what_is_wrong(tmp_path, monkeypatch, capsys, arguments, message):
    monkeypatch.chdir(tmp_path)
    try:
        code = main([*arguments, "--quiet"])
    except SystemExit as error:
        code = error.code
    assert code == 2
    assert message in capsys.readouterr().err


def test_the_command_runs_as_a_module(meshes, tmp_path):
    module = "surface_mesh_foliation.collection"
    code = f"import runpy; runpy.run_module({module!r}, run_name='__main__')"
    process = start(code, "--help")
    output, _ = process.communicate(timeout=120)
    assert process.returncode == 0 and "Exit codes" in output and "smf-collection" in output
    process = start(code, meshes[3], "--table", str(tmp_path / "t.jsonl"), "--workers", "1")
    process.communicate(timeout=120)
    assert process.returncode == 1


def test_ctrl_c_ends_the_command(meshes, tmp_path, monkeypatch, capsys):
    def interrupt(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("surface_mesh_foliation._collection.map_collection", interrupt)
    assert main([meshes[0], "--table", str(tmp_path / "t.jsonl")]) == 130
    assert "has what is done" in capsys.readouterr().err


def test_the_command_is_installed():
    text = (HERE.parent / "pyproject.toml").read_text()
    assert 'smf-collection = "surface_mesh_foliation.collection:main"' in text
