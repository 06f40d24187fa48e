#!/usr/bin/python3
# Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""tables.py RESULTS TABLES PICTURES: makes the tables and plots of the manual's chapter Experiments
from the results of the experiments. All three are folders; every number of that chapter is made
here."""

import csv
import math
import statistics
import sys
from collections import Counter, defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FUNCTIONS = ["height", "geodesic distance", "commute-time distance", "first eigenfunction",
             "harmonic (cotangent)", "harmonic (mean value)"]
OURS = ["ours (star)", "ours (canonical loops)", "ours (all found)"]


def read(name):
    with open(RESULTS / f"{name}.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write(name, note, titles, rows):
    """writes a table of the manual; a note of one line goes below it"""
    with open(TABLES / f"experiment_{name}.csv", "w", encoding="utf-8") as file:
        file.write(f"# {note} Made by: experiments/run.sh\n")
        for row in [titles, *rows]:
            file.write(",".join(str(field) for field in row) + "\n")


def grouped(rows, *columns):
    result = defaultdict(list)
    for row in rows:
        result[tuple(row[c] for c in columns)].append(row)
    return result


def numbers(rows, column):
    return [float(row[column]) for row in rows if row[column] != ""]


def mean(rows, column):
    values = numbers(rows, column)
    return statistics.mean(values) if values else math.nan


def total(rows, column):
    return sum(numbers(rows, column))


def median(rows, column):
    values = numbers(rows, column)
    return statistics.median(values) if values else math.nan


def percent(share):
    return "" if math.isnan(share) else f"{100 * share:.0f}%"


def highest_tenth(values):
    """the least of the highest tenth of some values"""
    return sorted(values)[int(0.9 * len(values))]


def decimals(value, digits):
    return "" if math.isnan(value) else f"{value:.{digits}f}"


def shapes_of(rows):
    return list(dict.fromkeys(row["shape"] for row in rows))


def number_of_shapes(rows):
    n = len(shapes_of(rows))
    return "One shape" if n == 1 else f"{n} shapes"


# ===  Conciseness


def expert(rows):
    """of one function on one shape at several levels of persistence, the row of the best level:
    that with the most limbs in one arc, then the most parts like one arc, then the fewest nodes"""
    return max(rows, key=lambda row: (int(row["limbs in one arc"]), int(row["parts like one arc"]),
                                      -int(row["nodes"])))


def nodes_and_arcs(rows):
    return f"{median(rows, 'nodes'):.0f} / {median(rows, 'arcs'):.0f}"


def conciseness():
    rows = read("conciseness")
    by_graph = grouped(rows, "graph")
    table = []
    for name in FUNCTIONS + OURS:
        mine = by_graph[(name,)]
        raw = [row for row in mine if float(row["persistence"]) == 0]
        best = [expert(group) for group in grouped(mine, "shape").values()]
        limbs, parts = total(best, "limbs"), total(best, "limbs") + len(best)
        table.append([name, nodes_and_arcs(raw),
                      percent(total(raw, "limbs in one arc") / limbs), nodes_and_arcs(best),
                      percent(total(best, "limbs in one arc") / limbs),
                      percent(total(best, "parts like one arc") / parts),
                      max(int(row["largest degree"]) for row in best)])
    write("conciseness",
          f"{number_of_shapes(rows)} with {int(limbs)} limbs. Chosen: the best of six levels "
          "of persistence for each shape and function.",
          ["graph", "nodes / arcs (medians)", "limbs in one arc", "nodes / arcs (chosen)",
           "limbs in one arc (chosen)", "parts like one arc (chosen)", "largest degree of a node"],
          table)

    by_shape = []
    for shape in shapes_of(rows):
        mine = grouped([row for row in rows if row["shape"] == shape], "graph")
        by_shape.append([shape, mine[(OURS[0],)][0]["limbs"]] +
                        [f"{mine[(name,)][0]['nodes']} / {expert(mine[(name,)])['nodes']}"
                         for name in FUNCTIONS] +
                        [mine[(name,)][0]["nodes"] for name in OURS])
    write("conciseness_by_shape", "Numbers of nodes; of functions raw and chosen.",
          ["shape", "limbs"] + FUNCTIONS + OURS, by_shape)

    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4))
    levels = sorted({float(row["persistence"]) for row in rows})
    for name in FUNCTIONS + OURS:
        style = "--" if name in OURS else "-"
        x = range(len(levels))
        at = [[row for row in by_graph[(name,)]
               if name in OURS or float(row["persistence"]) == level] for level in levels]
        axes[0].plot(x, [median(a, "nodes") for a in at], style, label=name)
        axes[1].plot(x, [100 * total(a, "limbs in one arc") / total(a, "limbs") for a in at], style)
    axes[0].set_yscale("log")
    axes[0].set_ylabel("nodes (median)")
    axes[1].set_ylabel("limbs in one arc, percent")
    for axis in axes:
        axis.set_xticks(range(len(levels)), [f"{100 * level:g}%" for level in levels])
        axis.set_xlabel("persistence, as a share of the range")
    figure.legend(loc="center left", bbox_to_anchor=(0.99, 0.5), frameon=False)
    figure.tight_layout()
    figure.savefig(PICTURES / "experiment_conciseness.png", dpi=110, bbox_inches="tight")


def degrees():
    """of nodes, from the rows of conciseness; of functions at all levels of persistence"""
    rows = read("conciseness")
    table = []
    for (name,), mine in grouped(rows, "graph").items():
        largest = [max(int(row["largest degree"]) for row in group)
                   for group in grouped(mine, "shape").values()]
        table.append([name, max(largest)] +
                     [sum(1 for degree in largest if degree >= least) for least in (4, 5, 6)])
    write("degrees", f"{number_of_shapes(rows)}.",
          ["graph", "largest degree of a node", "shapes with a node of degree 4 or more",
           "of degree 5 or more", "of degree 6 or more"], table)


# ===  Stability


def hand():
    """the fist of figure 1, from the rows of poses"""
    rows = [row for row in read("poses") if row["shape"] == "hand" and row["graph"] in
            ("harmonic (cotangent)", "harmonic (mean value)", OURS[0], "ours (loop by hand)")]
    table = [[name, percent(float(row["persistence"])) if name in FUNCTIONS else "",
              decimals(float(row["mean nodes"]), 1),
              percent(float(row["isomorphic"])), percent(float(row["arcs that agree"]))]
             for (name,), mine in grouped(rows, "graph").items() for row in mine]
    write("hand", f"{rows[0]['pairs']} pairs of poses of one fist, with its six poles given.",
          ["graph", "persistence", "nodes (mean)", "isomorphic", "arcs that agree"], table)


def best_level(rows, key):
    """the level of persistence at which one function does best, over all shapes"""
    return max(grouped(rows, "persistence").values(), key=lambda group: mean(group, key))


def poses():
    rows = read("poses")
    graphs = [row for row in rows if row["graph"] != "poles found again"]
    by_graph = grouped(graphs, "graph")
    table = []
    for name in FUNCTIONS + OURS:
        mine = by_graph[(name,)]
        best = best_level(mine, "isomorphic")
        raw = [row for row in mine if float(row["persistence"]) == 0]
        level = float(best[0]["persistence"])
        table.append([name, percent(mean(raw, "isomorphic")), percent(mean(raw, "arcs that agree")),
                      percent(level) if name in FUNCTIONS else "",
                      decimals(mean(best, "mean nodes"), 1),
                      percent(mean(best, "isomorphic")), percent(mean(best, "arcs that agree"))])
    pairs = int(total(by_graph[(OURS[0],)], "pairs"))
    write("poses",
          f"{pairs} pairs of poses of {len(shapes_of(rows))} shapes; means over the shapes. "
          "Chosen: the best of three levels of persistence.",
          ["graph", "isomorphic", "arcs that agree", "persistence chosen", "nodes", "isomorphic (chosen)",
           "arcs that agree (chosen)"], table)

    names = ["harmonic (cotangent)", "harmonic (mean value)"] + OURS
    by_shape = []
    for shape in shapes_of(rows):
        mine = grouped([row for row in rows if row["shape"] == shape], "graph")
        again = mean(mine[("poles found again",)], "arcs that agree")
        by_shape.append([shape] + [f"{percent(mean(best, 'isomorphic'))} / "
                                   f"{percent(mean(best, 'arcs that agree'))}"
                                   for best in (best_level(mine[(name,)], "isomorphic")
                                                for name in names)] + [percent(again)])
    write("poses_by_shape", "Isomorphic pairs / arcs that agree.",
          ["shape"] + names + ["poles found again"], by_shape)


def variants():
    rows = read("variants")
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    by_graph = grouped(rows, "graph")
    table = []
    for name in FUNCTIONS + OURS:
        best = best_level(by_graph[(name,)], "isomorphic")
        cells = []
        for kind in kinds:
            mine = [row for row in best if row["kind"] == kind]
            cells += [percent(mean(mine, "isomorphic")), percent(mean(mine, "arcs that agree"))]
        table.append([name] + cells)
    write("variants",
          f"{number_of_shapes(rows)}. Of functions the best of three levels of persistence.",
          ["graph"] + [f"{kind}: {what}" for kind in kinds
                       for what in ("isomorphic", "arcs that agree")], table)


def change(row):
    """of what a graph measures, relative to what it was"""
    return float(row["after"]) / float(row["before"]) - 1


def spread(rows, quantity, digits):
    """of the sizes of changes: median, highest tenth and largest"""
    changes = [abs(change(row)) for row in rows if row["quantity"] == quantity]
    if not changes:
        return ""
    return " / ".join(f"{100 * value:.{digits}f}%" for value in (
        statistics.median(changes), highest_tenth(changes), max(changes)))


def measures():
    rows = read("measures")
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    table = []
    for kind in kinds:
        for graph, mine in grouped([row for row in rows if row["kind"] == kind], "graph").items():
            number = Counter(row["quantity"] for row in mine)
            table.append([kind, *graph, number["flux"], spread(mine, "flux", 0),
                          spread(mine, "length", 1), number["modulus"] or "",
                          spread(mine, "modulus", 1)])
    note = ("Sizes of changes, relative to what was before: median / least of the highest tenth / "
            f"largest. {number_of_shapes(rows)}.")
    write("measures", note, ["kind of variants", "graph", "arcs", "flux", "length", "moduli",
                                    "modulus"], table)

    graphs = grouped(read("variants"), "variant", "graph")
    by_variant = []
    for (variant,), mine in grouped(rows, "variant").items():
        star = [row for row in mine if row["graph"] == OURS[0]]
        by_variant.append([variant, spread(star, "flux", 0), spread(star, "length", 1),
                           spread(mine, "modulus", 1)] +
                          [percent(mean(graphs[(variant, graph)], "isomorphic"))
                           for graph in OURS[:2]])
    write("measures_by_variant", f"{note} Fluxes and lengths of the star, moduli of canonical loops.",
          ["variant", "flux", "length", "modulus", "star isomorphic", "canonical isomorphic"],
          by_variant)

    variants_of = {kind: list(dict.fromkeys(row["variant"] for row in rows if row["kind"] == kind))
                   for kind in kinds}
    names = [name for kind in kinds for name in variants_of[kind]]
    figure, axes = plt.subplots(1, 3, figsize=(10, 4.2), sharey=True)
    for axis, (quantity, graph) in zip(axes, (("flux", OURS[0]), ("length", OURS[0]),
                                              ("modulus", OURS[1]))):
        ratios = [[1 + change(row) for row in rows
                   if (row["variant"], row["quantity"], row["graph"]) == (name, quantity, graph)]
                  for name in names]
        # horizontal boxes, whiskers from the lowest to the highest tenth, and dots beyond them
        axis.boxplot(ratios, None, ".", False, (10, 90), widths=0.6,
                     flierprops={"markersize": 3}, medianprops={"color": "tab:red"})
        axis.axvline(1, color="gray", linewidth=0.7, zorder=0)
        axis.set_xscale("log")
        if quantity == "flux":
            ticks = [0.2, 0.5, 1, 2, 5]
        else:
            ticks = [0.6, 0.8, 1, 1.2, 1.4]
        axis.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        axis.minorticks_off()
        axis.set_xlabel(f"{quantity}, after / before")
    axes[0].set_yticks(range(1, len(names) + 1), names)
    axes[0].invert_yaxis()
    figure.tight_layout()
    figure.savefig(PICTURES / "experiment_measures.png", dpi=110, bbox_inches="tight")


# ===  The others


def times():
    """one row is the paper's, from its Section 5.5.1"""
    rows = read("times")
    table = [["the paper (bodies of figure 15)", 6869, "", "210.77", "", "", "", "0.02"]]
    for row in rows:
        table.append([row["shape"], row["vertices"], row["sweeps"],
                      decimals(float(row["moves"]), 2), row["over-relaxed sweeps"],
                      decimals(float(row["over-relaxed moves"]), 2),
                      decimals(float(row["Newton's method"]), 3),
                      decimals(float(row["graph"]), 3)])
    write("times", "Seconds on one core, of the paper's AMD Ryzen 9 3950X and of an "
          f"{rows[0]['processor']}.",
          ["mesh", "vertices", "sweeps", "Whitehead moves", "over-relaxed sweeps",
           "over-relaxed moves", "Newton's method", "graph of the foliation"], table)


def accidental_poles():
    rows = [row for row in read("accidental_poles")
            if float(row["edges that are not Delaunay"]) > 0]
    groups = list(grouped(rows, "triangulation", "weights").items())
    groups += [(("all", weights), mine) for (weights,), mine in grouped(rows, "weights").items()]
    table = []
    for (triangulation, weights), mine in groups:
        def meshes(condition):
            return sum(1 for row in mine if condition(row))
        table.append([triangulation, weights, len(mine),
                      percent(mean(mine, "edges that are not Delaunay")),
                      meshes(lambda row: row["default solver"] == "certified"),
                      meshes(lambda row: int(row["of repaired moves"]) > 0),
                      meshes(lambda row: int(row["accidental poles of literal moves"]) > 0),
                      decimals(mean(mine, "accidental poles of literal moves"), 1)])
    write("accidental_poles",
          f"Meshes of {len(shapes_of(rows))} shapes that are not Delaunay; "
          "at most 2000 sweeps of moves.",
          ["triangulation", "weights", "meshes", "edges that are not Delaunay",
           "certified by the default solver", "with accidental poles by repaired moves",
           "with accidental poles by literal moves", "poles by literal moves (mean)"], table)


def topological_noise():
    rows = read("topological_noise")
    by_graph = grouped(rows, "graph")
    table = []
    for (name,), all_levels in by_graph.items():
        best = best_level(all_levels, "isomorphic")
        for_kind = grouped(best, "kind")
        table.append([name, percent(float(best[0]["persistence"])) if name in FUNCTIONS else "",
                      decimals(mean(best, "nodes before"), 1), decimals(mean(best, "nodes"), 1)] +
                     [percent(mean(for_kind[(kind,)], column)) for kind in ("tunnels", "bridges")
                      for column in ("isomorphic", "arcs that agree")])
    write("topological_noise",
          f"{number_of_shapes(rows)} with one to five small handles. Of functions the best of "
          "three levels of persistence of extrema and cycles.",
          ["graph", "persistence", "nodes without handles", "nodes", "tunnels: isomorphic",
           "tunnels: arcs that agree", "bridges: isomorphic",
           "bridges: arcs that agree"], table)


def symmetry():
    rows = read("symmetry")
    jug = [row for row in rows if row["shape"] == "jug"]
    bodies = [row for row in rows if row["shape"] != "jug"]
    table = []
    for name in FUNCTIONS + OURS:
        cells = []
        for group in (jug, bodies):
            mine = [row for row in group if row["graph"] == name]
            best = max(grouped(mine, "persistence").values(), key=lambda g: total(g, "pairs found"),
                       default=[])
            cells.append(f"{int(total(best, 'pairs found'))} of {int(total(best, 'pairs'))}")
        table.append([name] + cells)
    write("symmetry", f"{len(shapes_of(bodies))} bodies. Of functions the best of three levels of "
          "persistence.",
          ["graph", "pairs of handles of the jug", "pairs of limbs of bodies"], table)


def skeletons():
    rows = read("skeletons")
    table = []
    columns = [("spurious", 1), ("components", 0), ("inside", 3), ("median balance", 2),
               ("lowest tenth of balance", 2), ("turning", 1)]
    units = {row["shape"]: float(row["time"]) for row in rows if row["method"] == OURS[1]}
    for row in rows:
        row["spurious"] = int(row["ends"]) - int(row["limbs with an end"])
        row["time"] = float(row["time"]) / units[row["shape"]]
    for (method,), mine in grouped(rows, "method").items():
        table.append([method, percent(total(mine, "limbs with an end") / total(mine, "limbs"))] +
                     [decimals(mean(mine, column), digits) for column, digits in columns] +
                     [decimals(median(mine, "time"), 1)])
    write("skeletons",
          f"{number_of_shapes(rows)}: means; the time is a median, in units of that of the "
          "third row.",
          ["method", "limbs with an end", "other ends", "components", "share inside",
           "balance (median)", "balance (lowest tenth)", "turning", "time"], table)

    def quantiles(group, in_what, digits, what="distance"):
        tenth = "highest tenth" if what == "distance" else "highest tenth of error"
        return [f"{100 * median(group, f'{name} in {in_what}'):.{digits}f}%"
                for name in (f"median {what}", tenth)]
    methods = grouped(rows, "method")
    axis = [[method] + quantiles(mine, "radii", 0) + quantiles(mine, "diagonals", 2)
            for (method,), mine in methods.items()]
    first = next(iter(methods.values()))
    axis.append(["error of the measure"] + quantiles(first, "radii", 1, "error") +
                quantiles(first, "diagonals", 2, "error"))
    write("medial_axis",
          f"{number_of_shapes(rows)}: medians over the shapes of the median and of the least of "
          "the highest tenth of each.",
          ["method", "in radii (median)", "in radii (highest tenth)", "in diagonals (median)",
           "in diagonals (highest tenth)"], axis)

    by_shape = [[shape, *(" / ".join(quantiles(group, "radii", 0))
                          for group in grouped(mine, "method").values()),
                 " / ".join(quantiles(mine, "radii", 1, "error"))]
                for (shape,), mine in grouped(rows, "shape").items()]
    write("medial_axis_by_shape",
          "Distances from the medial axis in radii: median / least of the highest tenth.",
          ["shape", *(method for (method,) in methods), "error of the measure"], by_shape)


def segmentations():
    rows = read("segmentations")
    sdf = "shape diameter function"
    groups = {}
    for (method,), mine in grouped(rows, "method").items():
        if method == sdf:
            groups[sdf + " (default)"] = [group[0] for group in grouped(mine, "shape").values()]
            groups[sdf + " (best of all settings)"] = [
                min(group, key=lambda row: float(row["rand difference"]))
                for group in grouped(mine, "shape").values()]
        else:
            groups[method] = mine
    table = [[name, decimals(mean(mine, "segments"), 1)] +
             [decimals(mean(mine, column), 3) for column in
              ("rand difference", "hamming difference", "cut discrepancy")] +
             [percent(total(mine, "parts like one segment") / total(mine, "parts"))]
             for name, mine in groups.items()]
    write("segmentations", f"{number_of_shapes(rows)}; means. Smaller differences are better.",
          ["method", "segments", "Rand difference", "Hamming difference", "cut discrepancy",
           "parts like one segment"], table)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    RESULTS, TABLES, PICTURES = map(Path, sys.argv[1:])
    for folder in (TABLES, PICTURES):
        folder.mkdir(parents=True, exist_ok=True)
    for make, results in ((conciseness, "conciseness"), (degrees, "conciseness"), (poses, "poses"),
                          (hand, "poses"), (variants, "variants"), (measures, "measures"),
                          (times, "times"),
                          (accidental_poles, "accidental_poles"),
                          (topological_noise, "topological_noise"), (symmetry, "symmetry"),
                          (skeletons, "skeletons"), (segmentations, "segmentations")):
        if (RESULTS / f"{results}.csv").exists():
            make()
        else:
            print(f"there are no results {results}", file=sys.stderr)
