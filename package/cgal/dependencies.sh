#!/usr/bin/env bash
# package/cgal/dependencies.sh CGAL: prints the packages of CGAL whose headers the headers of this
# package reach, in the form of package_info/Surface_mesh_foliation/dependencies. CGAL is a folder
# whose include has CGAL's headers and ours. In it, all packages share one folder; which package a
# header is from is said by packages_of_headers.txt. Readers with VTK and Assimp, and solvers with
# CHOLMOD and hypre, do not count, as where these libraries are missing.
set -euo pipefail
include=$(realpath "$1")/include
table=$(dirname "$0")/packages_of_headers.txt
name=Surface_mesh_foliation

# the headers that are reached, by all of ours at once
cd "$include"
find CGAL/$name -name '*.h' ! -name 'read_with_*' ! -name 'Cholmod_*' ! -name 'Boomer_*' \
  ! -name 'Hypre_*' | sort | sed 's|.*|#include <&>|' |
  g++ -std=c++17 -M -x c++ -I "$include" -isystem /usr/include/eigen3 -D CGAL_EIGEN3_ENABLED - |
  grep -oE "$include/CGAL/[^ ]+" | sed "s|^$include/||" | sort -u >"${TMPDIR:-/tmp}/reached.$$"
trap 'rm -f "${TMPDIR:-/tmp}/reached.$$"' EXIT
cd - >/dev/null

# lines of the table: a package, and an extended regular expression of the headers that are from it
awk '
  NR == FNR { if (!/^#/ && NF == 2) { package[++count] = $1; pattern[count] = $2 } next }
  {
    for (i = 1; i <= count && $0 !~ "^CGAL/(" pattern[i] ")"; ++i)
      ;
    if (i > count)
    {
      print "packages_of_headers.txt does not know " $0 >"/dev/stderr"
      unknown = 1
    }
    else
      found[package[i]] = 1
  }
  END { for (name in found) print name; exit unknown }
' "$table" "${TMPDIR:-/tmp}/reached.$$" | LC_ALL=C sort
