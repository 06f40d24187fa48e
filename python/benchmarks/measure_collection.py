# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures collections: one process, several, a cluster of Dask; and estimates large clusters.

    measure_collection.py MESH... [--number N] [--workers W] [--runs R] --output FOLDER

makes N meshes from those given, turned and stretched, and writes two tables: what each way gains
over one process, and what a cluster of up to a thousand workers would gain.

The estimate is this. All rows pass through one process, which needs some time for each, measured
with a function that does nothing; the rest is done by the workers; and in the end, all wait for the
mesh that takes longest. These are times of the processor; those of the first table are not.
"""

import argparse
import contextlib
import csv
import tempfile
import time
from pathlib import Path
from statistics import mean, median

import distributed
import numpy as np
import surface_mesh_foliation as smf

FILES_OF_ESTIMATE = 100_000


def nothing(file):
    return {}


def write_off(file, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, point)) for point in points.tolist()]
    lines += ["3 " + " ".join(map(str, face)) for face in faces.tolist()]
    file.write_text("\n".join(lines) + "\n")


def make_variants(files, number, folder):
    """Write so many meshes, each one of those given, turned and stretched; return the files."""
    meshes = [smf.read(file) for file in files]
    result = []
    for i in range(number):
        mesh = meshes[i % len(meshes)]
        random = np.random.default_rng(i)
        rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
        rotation *= np.linalg.det(rotation)  # no reflection
        points = mesh.vertices @ rotation * np.exp(random.uniform(-0.2, 0.2, 3))
        result.append(folder / f"{i:04}.off")
        write_off(result[-1], points, mesh.faces)
    return result


# ===  What is measured


def run_alone(files, table):
    """Do the same in this process, and return the processor's seconds of each file."""
    result = []
    with open(table, "w") as stream:
        for file in files:
            begin = time.process_time()
            row = smf.analyze(file)
            assert row["error"] is None, row["error"]
            print(row, file=stream)
            result.append(time.process_time() - begin)
    return result


def run_collection(files, table, **options):
    report = smf.map_collection(files, smf.analyze, table=table, **options)
    assert report.failed == 0 and report.done == len(files)


@contextlib.contextmanager
def dask_executor(workers, folder):
    """Give an executor of Dask with so many processes."""
    cluster = distributed.LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        host="127.0.0.1",
        dashboard_address=None,
        local_directory=str(folder / "dask"),
        silence_logs=50,
    )
    with cluster, distributed.Client(cluster) as client:
        yield client.get_executor()


def seconds_of(run, *arguments, **options):
    begin = time.perf_counter()
    run(*arguments, **options)
    return time.perf_counter() - begin


def seconds_for_a_row(executor, folder):
    """Return how long the process that all rows pass through, this one, is busy with each."""

    def seconds(number):
        names = [f"{number}_{i}" for i in range(number)]
        table = folder / f"nothing_{number}.jsonl"
        begin = time.process_time()
        smf.map_collection(names, nothing, executor, table=table, window=5000)
        return time.process_time() - begin

    seconds(100)  # workers import what they need
    return (seconds(5000) - seconds(1000)) / 4000


def measure(files, ways, runs, folder):
    """Return the medians of seconds by way, and those of each file in this process."""
    seconds = {"one process": []}
    seconds_of_files = []
    for run in range(runs):
        begin = time.perf_counter()
        seconds_of_files += run_alone(files, folder / "alone.txt")
        seconds["one process"].append(time.perf_counter() - begin)
        for i, (way, options) in enumerate(ways.items()):
            table = folder / f"table_{run}_{i}.jsonl"
            elapsed = seconds_of(run_collection, files, table, **options)
            seconds.setdefault(way, []).append(elapsed)
    return {way: median(values) for way, values in seconds.items()}, seconds_of_files


# ===  Tables


def write(file, rows):
    with open(file, "w", newline="") as stream:
        csv.writer(stream, lineterminator="\n").writerows(rows)


def write_gains(seconds, output):
    alone = seconds["one process"]
    write(output / "gains.csv", [(way, f"{alone / s:.2f}") for way, s in seconds.items()])


def estimate(workers, seconds_of_files, seconds_for_row):
    """Return the gain of a cluster, and whether its workers or the scheduler limit it."""
    work = FILES_OF_ESTIMATE * mean(seconds_of_files)
    by_workers, by_scheduler = work / workers, FILES_OF_ESTIMATE * seconds_for_row
    gain = work / (max(by_workers, by_scheduler) + max(seconds_of_files))
    return gain, "workers" if by_workers > by_scheduler else "scheduler"


def write_estimates(seconds_of_files, seconds_for_row, output):
    rows = []
    for workers in (10, 100, 1000):
        gain, limit = estimate(workers, seconds_of_files, seconds_for_row)
        rows.append((workers, f"{gain:.0f}", limit))
    write(output / "estimates.csv", rows)
    (output / "overhead.txt").write_text(
        f"{1000 * mean(seconds_of_files):.0f} ms a mesh, {1000 * seconds_for_row:.2f} ms a row\n"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--number", type=int, default=400)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    workers = arguments.workers
    with tempfile.TemporaryDirectory() as name, dask_executor(workers, Path(name)) as executor:
        folder = Path(name)
        files = make_variants(arguments.meshes, arguments.number, folder)
        ways = {
            "a pool of one process": {"workers": 1},
            f"a pool of {workers} processes": {"workers": workers},
            f"Dask with {workers} workers": {"executor": executor},
        }
        seconds, seconds_of_files = measure(files, ways, arguments.runs, folder)
        seconds_for_row = seconds_for_a_row(executor, folder)
    write_gains(seconds, arguments.output)
    write_estimates(seconds_of_files, seconds_for_row, arguments.output)


if __name__ == "__main__":  # new processes read this file
    main()
