#!/usr/bin/env bash
# test/mutation.sh [OPTION...]: mutation testing of the headers that decide what is exact: which of
# their mutants (an operator, a number or a condition changed, a statement dropped) no test notices.
#
#   test/mutation.sh                            all mutants
#   test/mutation.sh --sample 150 --seed 1      some, from all headers; the same for the same seed
#   test/mutation.sh --headers 'Tripod|Lifts'   those of some headers
#   test/mutation.sh --list                     prints them, and runs nothing
#
# All mutants are woven into copies of the headers (mutation/weave.py), the tests are compiled with
# these once, and run for each mutant until one fails (mutation/run.py). Mutants that change nothing
# that a test could see are explained in mutation/survivors.txt. Fails if another one survives, or
# if that list is wrong. Debian 12.
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh library tests mutation
exec /usr/bin/python3 test/mutation/run.py "$@" # Debian's, whose libclang it is
