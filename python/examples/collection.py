# SPDX-License-Identifier: GPL-3.0-or-later
"""Many shapes: a table of all, on all cores; their distances; and those that are like another."""

import pickle
from functools import partial
from pathlib import Path

import shapes
import surface_mesh_foliation as smf


def write_off(file, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(str, point)) for point in points]
    lines += ["3 " + " ".join(map(str, face)) for face in faces]
    file.write_text("\n".join(lines) + "\n")


def main():
    # %% a folder with a few shapes, one of them a file that is broken
    folder = Path("shapes")
    folder.mkdir(exist_ok=True)
    for arm in (6, 7, 8):
        write_off(folder / f"body_{arm}.off", *shapes.body(arm=arm))
    write_off(folder / "torus.off", *shapes.torus(16, 24))
    (folder / "broken.off").write_text("OFF\n3 1 0\n0 0 0\n")

    # %% a row for each; the same call again does only what is not done
    files = sorted(folder.glob("*.off"))
    function = partial(smf.analyze, folder="results")
    report = smf.map_collection(files, function, table="shapes.jsonl", progress=True)
    print(report.done, "rows,", report.failed, "with an error")
    rows = list(smf.read_table("shapes.jsonl"))
    for row in rows:
        print(row["file"], row["error"] or f"{row['arcs']} arcs, genus {row['genus']}")

    # %% graphs that were kept can be compared
    graphs = {}
    for row in rows:
        if row["error"] is None:
            graphs[row["file"]] = pickle.loads(Path(row["pickle"]).read_bytes())
    print(smf.distance_matrix(graphs.values()))

    # %% the shapes that are most like another one
    query = smf.reeb_graph(shapes.body(arm=9))
    for neighbor in smf.retrieve(query, graphs, k=3):
        print(neighbor.name, neighbor.distance, neighbor.moduli_distance)


if __name__ == "__main__":  # new processes may read this file
    main()
