# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles the tests with all mutants of the headers, runs them once for each mutant, and prints
those that survive, and a table; see mutation.sh."""

import argparse
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

from weave import woven_headers

ROOT = Path(__file__).resolve().parent.parent.parent
TESTS = ROOT / "test" / "Surface_mesh_foliation"
PACKAGE = Path("include") / "CGAL" / "Surface_mesh_foliation"
# headers, and the tests that see them first
ROOMS = {
    "internal/Homotopy": ["Homotopy"],
    "internal/Foliation": ["Foliation", "Solver/test_tree_map_steps.cpp"],
    "internal/Leaves/certify.h": ["Solver/test_certificate.cpp",
                                  "Solver/test_certificate_of_extraction.cpp"],
}
TOO_LARGE = "test_measured_foliation.cpp"  # takes longer than the others together
KINDS = ("made", "killed", "too slow", "explained", "survived", "not compiled")
MEMORY = 2 << 30


def run(command, **options):
    return subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          **options)


def headers_of_rooms(pattern):
    result = []
    for room in ROOMS:
        path = ROOT / PACKAGE / room
        files = [path] if path.is_file() else sorted(path.glob("*.h"))
        result += [str(file.relative_to(ROOT / PACKAGE)) for file in files]
    return [name for name in result if re.search(pattern, name)]


def test_files():
    result = []
    for folders in ROOMS.values():
        for name in folders:
            path = TESTS / name
            result += [path] if path.is_file() else sorted(path.glob("*.cpp"))
    return [file for file in result if file.name != TOO_LARGE]


def files_for(header, seconds):
    """The test files, those that belong to the header's room first, and quick ones first."""
    own = next(tests for room, tests in ROOMS.items() if header.startswith(room))

    def rank(file):
        name = str(file.relative_to(TESTS))
        return not any(name.startswith(folder) for folder in own), seconds[file]

    return sorted(test_files(), key=rank)


def filter_of(file):
    """The filter of GoogleTest for the tests of a file."""
    suites = sorted(set(re.findall(r"^TEST(?:_F|_P)?\((\w+)", file.read_text(), re.M)))
    return ":".join(f"{suite}.*:*/{suite}.*" for suite in suites)


class Program:
    """The tests, compiled with all mutants of the headers."""

    def __init__(self, folder, compiler, names):
        self.folder, self.names = folder, names
        self.program = folder / "tests"
        self.compile = [
            *shlex.split(compiler), "-std=c++17", "-O1", "-w", "-Wno-invalid-constexpr", "-DCGAL_DEBUG",
            # what reads nothing, or outside of an array, is not to go on by chance
            "-ftrivial-auto-var-init=pattern", "-D_GLIBCXX_ASSERTIONS",
            '-DSMF_DATA_DIR=""', '-DSMF_SHARED_DIR=""', "-ferror-limit=0",
            "-include", str(ROOT / "test/mutation/mutants.h"), "-I", str(folder / "include"),
            "-I", str(ROOT / "include"), "-I", str(ROOT), "-I", str(TESTS),
            "-isystem", "/usr/include/eigen3", str(folder / "tests.cpp")]
        self.excluded = set()  # the numbers of mutants that do not compile

    def weave(self):
        """Writes the copies of the headers, and returns the headers."""
        arguments = ["-x", "c++", "-std=c++17", f"-I{ROOT}/include", "-isystem/usr/include/eigen3",
                     "-DCGAL_DEBUG"]
        headers = woven_headers(ROOT / "include", self.names, arguments, self.excluded)
        for header in headers:
            copy = self.folder / PACKAGE / header.name
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(header.woven().encode("latin-1"))
        return headers

    def build(self):
        """Compiles, without the mutants that do not compile."""
        (self.folder / "tests.cpp").write_text(
            "".join(f'#include "{file}"\n' for file in test_files()))
        while True:
            found = self.mutants_with_errors(self.weave())
            if not found:
                break
            self.excluded |= found
        libraries = ["-lgtest_main", "-lgtest", "-lgmp", "-lmpfr", "-pthread"]
        subprocess.run([*self.compile, "-o", str(self.program), *libraries], check=True)

    def mutants_with_errors(self, headers):
        """The mutants in the lines that errors name, be it as where a template is used."""
        check = run([*self.compile, "-fsyntax-only", "-fno-caret-diagnostics"])
        if check.returncode == 0:
            return set()
        result = set()
        for header in headers:
            path = re.escape(str(self.folder / PACKAGE / header.name))
            lines = {int(n) for n in re.findall(rf"^{path}:(\d+):\d+:", check.stdout, re.M)}
            result |= {m.number for m in header.mutants if m.line in lines} - self.excluded
        if not result:
            sys.exit(check.stdout)
        return result

    def passes(self, file, mutant, seconds):
        """Whether the tests of a file pass; None if they take more seconds of the processor's."""
        command = [str(self.program), f"--gtest_filter={filter_of(file)}", "--gtest_fail_fast",
                   "--gtest_brief=1"]
        environment = {**os.environ, "SMF_MUTANT": str(mutant)}

        def set_limits():
            for kind, limit in ((resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_CPU, seconds),
                                (resource.RLIMIT_CORE, 0)):
                resource.setrlimit(kind, (limit, limit))

        status = run(command, env=environment, cwd=self.folder, preexec_fn=set_limits,
                     errors="replace").returncode
        return None if status in (-signal.SIGXCPU, -signal.SIGKILL) else status == 0


def new_folder(folder):
    """An empty folder; of what there is, only what this program has left is removed."""
    mark = folder / "made_by_mutation_testing"
    if folder.exists() and any(folder.iterdir()) and not mark.exists():
        sys.exit(f"{folder} has other files in it: name a new folder")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    mark.touch()
    return folder


def seconds_without_mutant(program):
    """The seconds that the tests of each file take."""
    result = {}
    for file in test_files():
        start = time.monotonic()
        if not program.passes(file, 0, resource.RLIM_INFINITY):
            sys.exit(f"The tests of {file} fail without any mutant.")
        result[file] = time.monotonic() - start
        print(f"{result[file]:7.2f} s  {file.relative_to(TESTS)}")
    return result


def verdict_on(program, mutant, seconds):
    for file in files_for(mutant.header, seconds):
        passes = program.passes(file, mutant.number, 2 + round(10 * seconds[file]))
        if not passes:
            return "too slow" if passes is None else "killed"
    return "survived"


def sample_of(mutants, size, seed):
    """As many from each header as its share, but at least two, or all there are."""
    if size is None or size >= len(mutants):
        return mutants
    chooser = random.Random(seed)
    by_header = {}
    for mutant in mutants:
        by_header.setdefault(mutant.header, []).append(mutant)
    result = []
    for group in by_header.values():
        share = max(2, round(size * len(group) / len(mutants)))
        result += chooser.sample(group, min(share, len(group)))
    return sorted(result, key=lambda mutant: mutant.number)


def read_explanations():
    """By mutant, the reason why no test can kill it."""
    result = {}
    mutant = None
    for line in (ROOT / "test/mutation/survivors.txt").read_text().splitlines():
        if line.startswith("  ") and mutant is not None:
            result[mutant] = f"{result[mutant]} {line.strip()}".strip()
        elif line and not line.startswith("#"):
            mutant = line
            result[mutant] = ""
    return result


def print_table(verdicts):
    """verdicts: by mutant"""
    rows = {}
    for mutant, verdict in verdicts.items():
        rows.setdefault(mutant.header, Counter()).update(["made", verdict])
    rows["all"] = sum(rows.values(), Counter())
    width = max(map(len, rows))
    print(f"{'':{width}}", *(f"{kind:>12}" for kind in KINDS))
    for name, row in rows.items():
        print(f"{name:{width}}", *(f"{row[kind]:12}" for kind in KINDS))
    counted = rows["all"]["killed"] + rows["all"]["too slow"] + rows["all"]["survived"]
    if counted:
        killed = 100 * (1 - rows["all"]["survived"] / counted)
        print(f"Killed: {killed:.1f} % of those not explained")


def main():
    parser = argparse.ArgumentParser(prog="test/mutation.sh")
    parser.add_argument("--sample", type=int, help="how many mutants to run; all by default")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--headers", default="", help="a regular expression of headers")
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "mutation")
    parser.add_argument("--compiler", default="clang++-14")
    parser.add_argument("--list", action="store_true", help="print the mutants only")
    options = parser.parse_args()

    folder = new_folder(options.build.resolve())
    program = Program(folder, options.compiler, headers_of_rooms(options.headers))
    mutants = [mutant for header in program.weave() for mutant in header.mutants]
    sample = sample_of(mutants, options.sample, options.seed)
    if options.list:
        print(*sample, sep="\n")
        return 0
    print(f"{len(mutants)} mutants, of which {len(sample)} are run")

    program.build()
    explanations = read_explanations()
    seconds = seconds_without_mutant(program)
    verdicts = {}
    is_list_right = True
    for count, mutant in enumerate(sample, 1):
        if count % 50 == 0:
            print(f"{count} of {len(sample)}", flush=True)
        if mutant.number in program.excluded:
            verdicts[mutant] = "not compiled"
            continue
        verdict = verdict_on(program, mutant, seconds)
        if verdict == "survived" and str(mutant) in explanations:
            verdict = "explained"
        elif str(mutant) in explanations:
            print(f"{verdict}, although explained: {mutant}", flush=True)
            is_list_right = False
        elif verdict == "survived":
            print(f"survived: line {mutant.line} of {mutant}", flush=True)
        verdicts[mutant] = verdict
    for unknown in sorted(set(explanations) - {str(mutant) for mutant in mutants}):
        if not options.headers:
            print(f"explained, but there is no such mutant: {unknown}")
            is_list_right = False
    print_table(verdicts)
    return 0 if is_list_right and "survived" not in verdicts.values() else 1


if __name__ == "__main__":
    sys.exit(main())
