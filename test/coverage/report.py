# SPDX-License-Identifier: GPL-3.0-or-later
"""report.py LCOV-FILE...: prints a table by folder of the lines and branches of include/ that tests
reach, according to files by `llvm-cov export -format=lcov`, and the places that no test reaches,
each by the first of its lines. A line that is instantiated for several types counts once. Ends with
status 1 if a place is not explained in unreached.txt, if an explained one is reached after all, or if
less than 97 % of all lines are reached."""

import sys
from collections import Counter, defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PACKAGE = ROOT / "include" / "CGAL" / "Surface_mesh_foliation"
GOAL = 97


def read_counts(files):
    """How often lines and branches ran: by header, by line or by (line, branch)."""
    lines, branches = defaultdict(Counter), defaultdict(Counter)
    for file in files:
        header = None
        for record in Path(file).read_text().splitlines():
            kind, _, values = record.partition(":")
            if kind == "SF":
                path = Path(values)
                header = path.relative_to(PACKAGE) if PACKAGE in path.parents else None
            elif header is not None and kind == "DA":
                line, count = values.split(",")[:2]
                lines[header][int(line)] += int(count)
            elif header is not None and kind == "BRDA":
                line, block, branch, count = values.split(",")
                branches[header][int(line), block, branch] += 0 if count == "-" else int(count)
    return lines, branches


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


def main(files):
    lines, branches = read_counts(files)
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
    for text in sorted(unknown):
        print(f"explained, but reached or gone: {text}")
    counts = [count for header in lines.values() for count in header.values()]
    is_enough = 100 * sum(count > 0 for count in counts) >= GOAL * len(counts) > 0
    return 0 if is_enough and is_complete and not unknown else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
