# SPDX-License-Identifier: GPL-3.0-or-later
"""Collections on a cluster: that of Dask, with two processes of this machine."""

import os
import signal

import pytest
import surface_mesh_foliation as smf
from test_collection import PATHS, check_complete, die_always, runs, slow_size

distributed = pytest.importorskip("distributed")


@pytest.fixture
def client(tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(PATHS))
    cluster = distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        host="127.0.0.1",
        dashboard_address=None,
        local_directory=str(tmp_path / "dask"),
        silence_logs=50,  # the cluster would tell of each worker that dies
    )
    with cluster, distributed.Client(cluster) as client:
        yield client


@pytest.fixture
def files(tmp_path):
    return [str(tmp_path / f"{i:02}") for i in range(40)]


def test_a_worker_that_is_killed_loses_nothing(client, files, tmp_path):
    table = tmp_path / "table.jsonl"
    killed = []

    def kill(progress):
        if progress.done == 5:
            killed.append(progress.row["pid"])
            os.kill(progress.row["pid"], signal.SIGKILL)

    executor = client.get_executor()
    report = smf.map_collection(files, slow_size, executor, table=table, progress=kill)
    assert report.is_complete and report.done == len(files) and report.failed == 0
    rows = list(smf.read_table(table))
    check_complete(rows, files)
    assert len(killed) == 1 and rows[-1]["pid"] != killed[0]
    again = smf.map_collection(files, slow_size, executor, table=table)
    assert (again.done, again.resumed) == (0, len(files))


def test_a_file_that_kills_every_worker_is_a_row(client, files):
    files = files[:6]  # of which one has the name that is deadly
    report = smf.map_collection(files, die_always, client.get_executor(), window=2)
    rows = {row["file"]: row for row in report.rows}
    assert sorted(rows) == files and report.done == len(files)
    assert rows[files[3]]["kind"] == "KilledWorker" and runs(files[3]) > 1
    assert [row["error"] for row in rows.values()].count(None) >= len(files) - 2
