# SPDX-License-Identifier: GPL-3.0-or-later
"""report.py LCOV-FILE JSON-FILE: prints a table by folder of the lines and branches of include/ that
tests reach, and the places that no test reaches, each by the first of its lines. The files are what
`llvm-cov export` has written with -format=lcov, for lines, and with -skip-functions, for branches.
What is instantiated for several types counts once. Ends with status 1 if a place is not explained in
unreached.txt, if an explained one is gone, or if less than 97 % of all lines are reached.
"""

import json
import sys
from collections import Counter, defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PACKAGE = ROOT / "include" / "CGAL" / "Surface_mesh_foliation"
GOAL = 97


def header_of(path):
    path = Path(path).resolve()
    return path.relative_to(PACKAGE) if PACKAGE in path.parents else None


def counts_of_lines(file):
    """By header and line, how often it ran."""
    result = defaultdict(Counter)
    header = None
    for record in file.read_text().splitlines():
        kind, _, values = record.partition(":")
        if kind == "SF":
            header = header_of(values)
        elif header is not None and kind == "DA":
            line, count = values.split(",")[:2]
            result[header][int(line)] += int(count)
    return result


def counts_of_branches(file):
    """By header and branch, how often it was taken; a branch is a place in the text, and an outcome."""
    result = defaultdict(Counter)
    for record in json.loads(file.read_text())["data"][0]["files"]:
        header = header_of(record["filename"])
        if header is not None:
            for *place, taken, not_taken, _, _, _ in record["branches"]:
                result[header][(*place, True)] += taken
                result[header][(*place, False)] += not_taken
    return result


def missed_places(counts):
    """The first and last lines of each run of lines of code that no test reaches."""
    result, is_in_place = [], False
    for line, count in sorted(counts.items()):
        if count == 0 and is_in_place:
            result[-1] = result[-1][0], line
        elif count == 0:
            result.append((line, line))
        is_in_place = count == 0
    return result


def read_explanations(file):
    """The places that are explained, each by header and first line."""
    return {line for line in file.read_text().splitlines()
            if line and not line.startswith(("#", "  "))}


def share(reached, all_of_them):
    return f"{100 * reached / all_of_them:6.1f} %" if all_of_them else " " * 8


def print_row(name, lines, branches):
    reached = sum(count > 0 for count in lines)
    taken = sum(count > 0 for count in branches)
    print(f"{name:32} {len(lines):7} {len(lines) - reached:7} {share(reached, len(lines))}"
          f" {len(branches):9} {len(branches) - taken:7} {share(taken, len(branches))}")


def print_table(lines, branches):
    print(f"{'':32} {'lines':>7} {'missed':>7} {'':8} {'branches':>9} {'missed':>7}")
    by_folder = defaultdict(list)
    for header in sorted(lines):
        by_folder[header.parent].append(header)
    for folder, headers in by_folder.items():
        name = "public headers" if folder == Path(".") else str(folder)
        print_row(name, [n for h in headers for n in lines[h].values()],
                  [n for h in headers for n in branches[h].values()])
    print_row("all", [n for counts in lines.values() for n in counts.values()],
              [n for counts in branches.values() for n in counts.values()])


def main(lcov_file, json_file):
    lines, branches = counts_of_lines(Path(lcov_file)), counts_of_branches(Path(json_file))
    explained = read_explanations(Path(__file__).parent / "unreached.txt")
    print_table(lines, branches)

    unknown = set(explained)
    is_complete = True
    for header in sorted(lines):
        source = (PACKAGE / header).read_text().splitlines()
        for first, last in missed_places(lines[header]):
            text = source[first - 1].strip()
            unknown.discard(f"{header}: {text}")
            if f"{header}: {text}" not in explained:
                print(f"not reached: {header}, lines {first} to {last}: {text}")
                is_complete = False
    for place in sorted(unknown):
        header, _, text = place.partition(": ")
        file = PACKAGE / header
        if file.exists() and text in map(str.strip, file.read_text().splitlines()):
            print(f"explained, but reached here: {place}")
        else:
            print(f"explained, but gone: {place}")
            is_complete = False
    counts = [count for header in lines.values() for count in header.values()]
    is_enough = 100 * sum(count > 0 for count in counts) >= GOAL * len(counts) > 0
    return 0 if is_enough and is_complete else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
