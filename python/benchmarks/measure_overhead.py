# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what Python costs: from arrays to results, beside the same in C++, in turns.

    measure_overhead.py PROGRAM MESH [--levels N] [--runs R]
    measure_overhead.py --importing

The first prints the rows of a table: the number of vertices, and the time in Python divided by that
of PROGRAM, which is ``from_arrays``: medians of R runs each, on the mesh subdivided up to N times.
It is the time of the processor, since both run on one core. The second prints how many milliseconds it takes to import the module.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

import numpy as np
import surface_mesh_foliation as smf

sys.path.append(str(Path(__file__).parents[1] / "examples"))

from shapes import subdivided  # noqa: E402


def compute(points, faces, poles):
    """Compute all that the program computes."""
    r = smf.reeb_graph(smf.Mesh(points, faces), poles=poles, loops=[])
    return r.skeleton.arcs, r.skeleton.nodes, r.segments, r.arc, r.t, r.edge_values


def seconds_in_python(points, faces, poles):
    begin = time.process_time()
    results = compute(points, faces, poles)
    del results
    return time.process_time() - begin


class Program:
    """The program in C++, at work on the same arrays."""

    def __init__(self, program, points, faces, poles, folder):
        file = Path(folder, "arrays")
        sizes = np.array([len(points), len(faces), len(poles)], np.int64)
        arrays = [sizes, points.astype(np.float64), faces.astype(np.int64), poles.astype(np.int64)]
        file.write_bytes(b"".join(array.tobytes() for array in arrays))
        pipe = subprocess.PIPE
        self._process = subprocess.Popen([program, file], stdin=pipe, stdout=pipe, text=True)

    def seconds(self):
        print(file=self._process.stdin, flush=True)
        return float(self._process.stdout.readline())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.stdin.close()
        self._process.wait()


def ratio(program, points, faces, poles, runs):
    """Return the time in Python divided by that in C++, each run beside one of the other."""
    in_python, in_cpp = [], []
    with tempfile.TemporaryDirectory() as folder:
        with Program(program, points, faces, poles, folder) as other:
            for run in range(runs + 1):
                pair = seconds_in_python(points, faces, poles), other.seconds()
                if run > 0:  # the first one warms up
                    in_python.append(pair[0])
                    in_cpp.append(pair[1])
    return median(in_python) / median(in_cpp)


def milliseconds_to_import(runs=20):
    def seconds(code):
        begin = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True)
        return time.perf_counter() - begin

    pairs = [
        (seconds("import surface_mesh_foliation"), seconds("pass")) for _ in range(runs)
    ]
    return 1000 * (median(pair[0] for pair in pairs) - median(pair[1] for pair in pairs))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", nargs="?")
    parser.add_argument("mesh", nargs="?")
    parser.add_argument("--levels", type=int, default=2)
    parser.add_argument("--runs", type=int, default=15)
    parser.add_argument("--importing", action="store_true")
    arguments = parser.parse_args()
    if arguments.importing:
        print(f"{milliseconds_to_import():.0f}")
        return
    if arguments.mesh is None:
        parser.error("the program and a mesh are needed")
    mesh = smf.read(arguments.mesh)
    points, faces = np.array(mesh.vertices), np.array(mesh.faces)
    poles = smf.find_poles(mesh)
    for level in range(arguments.levels + 1):
        if level > 0:
            points, faces = subdivided(points, faces)
        print(f"{len(points)},{ratio(arguments.program, points, faces, poles, arguments.runs):.3f}")


if __name__ == "__main__":
    main()
