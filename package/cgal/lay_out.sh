#!/usr/bin/env bash
# package/cgal/lay_out.sh [--flat] FOLDER: lays the package out as a package of CGAL, in the new FOLDER:
# Surface_mesh_foliation with include, examples, test, benchmark, demo, doc and package_info, which
# drops into CGAL's sources; with --flat in the way of CGAL's releases, where packages share the
# folders include, examples and test.
#
# What is not the same here and there:
# - headers have CGAL's notice with $URL$ and $Id$, and include CGAL/license/Surface_mesh_foliation.h.
#   The license stays GPL-3.0-or-later: a commercial one is for the owners to grant.
# - each folder of programs is a project of its own, in which each .cpp is listed. Tests are in one
#   folder and need GoogleTest, without which they are not compiled. Left out are those of optional
#   libraries that CGAL does not use (CHOLMOD, hypre), of readers with VTK and Assimp, and of the main
#   program, which is a demo here: CGAL's test suite runs all examples without arguments.
# - the tables of the manual, made of CSV files, are finished, and its chapters are not numbered.
# The folders python and demo, with the page, stay outside of CGAL.
set -euo pipefail
cd "$(dirname "$0")/../.."

umask 022
is_flat=false
if [ "${1:-}" = --flat ]; then
  is_flat=true
  shift
fi
[ $# -eq 1 ] || { echo "usage: package/cgal/lay_out.sh [--flat] FOLDER" >&2; exit 2; }
folder=$(realpath -m "$1")
name=Surface_mesh_foliation
[ ! -e "$folder/$name" ] || { echo "$folder/$name exists; give a new folder" >&2; exit 1; }
$is_flat && package=$folder || package=$folder/$name

# copy FROM TO: the tracked files of one folder to another
copy()
{
  mkdir -p "$2"
  (cd "$1" && git ls-files -z . | xargs -0 cp --parents --target-directory "$2")
}

# give_notice FILE...: CGAL's notice instead of ours
give_notice()
{
  # shellcheck disable=SC2016
  sed -i -e 's|^// This file is part of Surface_mesh_foliation\.$|// This file is part of CGAL (www.cgal.org).|' \
    -e 's|^// SPDX-License-Identifier: \(.*\)$|// $URL$\n// $Id$\n// SPDX-License-Identifier: \1\n//\n// Author(s)     : The Surface_mesh_foliation authors|' \
    "$@"
}

# ===  Headers

copy include "$package/include"
mapfile -t headers < <(find "$package/include" -ipath '*surface_mesh_foliation*' -name '*.h' | sort)
give_notice "${headers[@]}"
# after the guard
sed -i -e '/^#define CGAL_SURFACE_MESH_FOLIATION.*_H$/a\\n#include <CGAL/license/Surface_mesh_foliation.h>' \
  "${headers[@]}"

# ===  Programs

# begin_project FOLDER NAME: the beginning of its CMakeLists.txt
begin_project()
{
  cat >"$1/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.12...3.31)
project($2)

find_package(CGAL REQUIRED)

find_package(Eigen3 3.4 QUIET)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  message("NOTICE: These programs require the Eigen library (3.4 or greater), and will not be compiled.")
  return()
endif()
CMAKE
}

# add_programs FOLDER INDENTATION LIBRARIES FILE...: adds them to its CMakeLists.txt
add_programs()
{
  local list=$1/CMakeLists.txt indentation=$2 libraries=$3 file
  shift 3
  for file in "$@"; do
    file=$(basename "$file")
    cat >>"$list" <<CMAKE
${indentation}create_single_source_cgal_program("$file")
${indentation}target_link_libraries(${file%.cpp} PRIVATE $libraries)
CMAKE
  done
}

examples=$package/examples/$name
copy examples/$name "$examples"
demo=$package/demo/$name
mkdir -p "$demo"
mv "$examples/foliation_reeb_graph.cpp" "$examples/main_program" "$demo/"
begin_project "$examples" ${name}_Examples
add_programs "$examples" "" CGAL::Eigen3_support "$examples"/*.cpp

begin_project "$demo" ${name}_Demo
cat >>"$demo/CMakeLists.txt" <<'CMAKE'

find_package(CLI11 QUIET)
find_package(nlohmann_json QUIET)
if(CLI11_FOUND AND nlohmann_json_FOUND)
  add_executable(foliation_reeb_graph foliation_reeb_graph.cpp)
  add_to_cached_list(CGAL_EXECUTABLE_TARGETS foliation_reeb_graph)
  target_link_libraries(foliation_reeb_graph PRIVATE
    CGAL::CGAL CGAL::Eigen3_support CLI11::CLI11 nlohmann_json::nlohmann_json)
else()
  message("NOTICE: This demo requires CLI11 and nlohmann_json, and will not be compiled.")
endif()
CMAKE

tests=$package/test/$name
copy test/$name/include "$tests/include"
copy generators "$tests/generators"
for file in $(git ls-files "test/$name/*/test_*.cpp"); do
  case $file in
    */Programs/* | *_with_vtk.cpp | *_with_assimp.cpp) ;;
    */test_cholmod_solver.cpp | */test_boomer_amg_solver.cpp) ;;
    *) cp "$file" "$tests/" ;;
  esac
done
begin_project "$tests" ${name}_Tests
cat >>"$tests/CMakeLists.txt" <<'CMAKE'

find_package(GTest QUIET)
if(NOT TARGET GTest::gtest_main)
  message("NOTICE: These tests require GoogleTest, and will not be compiled.")
  return()
endif()

include_directories(${CMAKE_CURRENT_SOURCE_DIR})
find_path(SMF_DATA_DIR hand.off NO_DEFAULT_PATH
  PATHS ../../../Data/data/meshes ../../data/meshes)
mark_as_advanced(SMF_DATA_DIR)
if(NOT SMF_DATA_DIR)
  set(SMF_DATA_DIR "") # what needs CGAL's meshes is skipped
endif()
add_definitions(-DCGAL_DEBUG -DSMF_DATA_DIR="${SMF_DATA_DIR}" -DSMF_SHARED_DIR="")

CMAKE
mapfile -t with_main < <(grep -l '^int main(' "$tests"/*.cpp)
mapfile -t with_spectra < <(cd "$tests" && ls test_feature_functions.cpp test_feature_poles*.cpp)
others=()
for file in "$tests"/*.cpp; do
  case " ${with_main[*]} ${with_spectra[*]} test_parallel.cpp " in
    *" $file "* | *" $(basename "$file") "*) ;;
    *) others+=("$file") ;;
  esac
done
add_programs "$tests" "" "CGAL::Eigen3_support GTest::gtest_main" "${others[@]}"
add_programs "$tests" "" "CGAL::Eigen3_support GTest::gtest" "${with_main[@]}"
cat >>"$tests/CMakeLists.txt" <<'CMAKE'

find_path(SMF_SPECTRA_INCLUDE_DIR Spectra/SymEigsSolver.h)
mark_as_advanced(SMF_SPECTRA_INCLUDE_DIR)
if(SMF_SPECTRA_INCLUDE_DIR)
CMAKE
add_programs "$tests" "  " "CGAL::Eigen3_support GTest::gtest_main" "${with_spectra[@]}"
cat >>"$tests/CMakeLists.txt" <<'CMAKE'
else()
  message("NOTICE: Some tests require Spectra, and will not be compiled.")
endif()

find_package(TBB QUIET)
include(CGAL_TBB_support)
if(TARGET CGAL::TBB_support)
CMAKE
add_programs "$tests" "  " "CGAL::Eigen3_support CGAL::TBB_support GTest::gtest_main" \
  "$tests/test_parallel.cpp"
cat >>"$tests/CMakeLists.txt" <<'CMAKE'
else()
  message("NOTICE: Some tests require TBB, and will not be compiled.")
endif()
CMAKE

benchmarks=$package/benchmark/$name
copy benchmark/$name "$benchmarks"
rm -r "$benchmarks/experiments"
copy generators "$benchmarks/generators"
begin_project "$benchmarks" ${name}_Benchmark
cat >>"$benchmarks/CMakeLists.txt" <<'CMAKE'

find_package(benchmark QUIET)
if(NOT benchmark_FOUND)
  message("NOTICE: These benchmarks require Google Benchmark, and will not be compiled.")
  return()
endif()

include_directories(${CMAKE_CURRENT_SOURCE_DIR})
add_definitions(-DSMF_DATA_DIR="../../../Data/data/meshes" -DSMF_SHARED_DIR="")

CMAKE
add_programs "$benchmarks" "" "CGAL::Eigen3_support benchmark::benchmark" "$benchmarks"/*.cpp

# only headers have the notice of CGAL, but none says that it is part of something else
mapfile -t files < <(find "$examples" "$demo" "$tests" "$benchmarks" -name '*.cpp' -o -name '*.h')
give_notice "${files[@]}"

# ===  Manual

doc=$package/doc/$name
copy doc/$name "$doc"
rm -r "$doc/CMakeLists.txt" "$doc/data" "$doc/pictures"
cmake -D DATA="$PWD/doc/$name/data" -D OUTPUT="$doc/tables" -P doc/tables.cmake
sed -i '/foliation_reeb_graph\.cpp/d' "$doc/examples.txt"
sed -i 's|^\\cgalPkgLicense{.*}|\\cgalPkgBib{cgal:smf-smf}\n\\cgalPkgLicense{\\ref licensesGPL "GPL"}|' \
  "$doc/PackageDescription.txt"
# (the aliases as in doc/BaseDoxyfile.in, but for the numbers)
{
  cat <<'DOXYFILE'
@INCLUDE = ${CGAL_DOC_PACKAGE_DEFAULTS}
PROJECT_NAME = "CGAL ${CGAL_DOC_VERSION} - Surface Mesh Foliation"
EXTRACT_ALL        = NO
HIDE_UNDOC_CLASSES = YES
HIDE_UNDOC_MEMBERS = YES
DOXYFILE
  room=$name/internal
  for file in Common/Named_parameters Common/exceptions Foliation/Foliation_statistics Loops/Loop \
    Mesh/Triangle_soup Scalar_reeb_graph/Critical_kind Solver/Simplicial_cholesky_solver; do
    echo "INPUT += \${CGAL_PACKAGE_INCLUDE_DIR}/CGAL/$room/$file.h"
  done
  cat <<'DOXYFILE'
EXAMPLE_PATH      += ${CGAL_PACKAGE_DOC_DIR}/tables
PREDEFINED        += "CGAL_NP_TEMPLATE_PARAMETERS=NamedParameters = parameters::Default_named_parameters" \
                     "CGAL_NP_CLASS=NamedParameters"
ALIASES += "smfChapter{2}=\page \1 \2"
ALIASES += "smfTable{1}=\htmlinclude \1.html"
ALIASES += "smfHeader{2}=\headerfile internal/\1 <CGAL/Surface_mesh_foliation/\2>"
DOXYFILE
} >"$doc/Doxyfile.in"

# ===  Package info, and what other packages of CGAL have to say about this one

copy package_info/$name "$package/package_info/$name"
if $is_flat; then
  license=$package/include/CGAL/license
  mkdir -p "$license"
else
  license=$folder/Installation/include/CGAL/license
  mkdir -p "$license"
  echo "$name Surface Mesh Foliation" >"$license/gpl_package_list.txt.add"
fi
cat >"$license/$name.h" <<'HEADER'
// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// It stands in for the header of this name that CGAL generates from gpl_package_list.txt.

#ifndef CGAL_LICENSE_SURFACE_MESH_FOLIATION_H
#define CGAL_LICENSE_SURFACE_MESH_FOLIATION_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("You use the CGAL Surface Mesh Foliation package under the terms of the GPLv3+.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "You use the CGAL Surface Mesh Foliation package under the terms of the GPLv3+. You get this \
error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_SURFACE_MESH_FOLIATION_H
HEADER

find "$package" -type f -ipath '*surface_mesh_foliation*' -exec chmod 644 {} +
echo "Laid out in $package"
