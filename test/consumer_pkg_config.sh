#!/usr/bin/env bash
# test/consumer_pkg_config.sh COMPILER PREFIX VERSION OUTPUT: compiles consumer.cpp as users without
# CMake do, with what pkg-config says about the package installed in PREFIX, and runs it.
set -euo pipefail
compiler=$1 prefix=$2 version=$3 output=$4

export PKG_CONFIG_PATH=$prefix/share/pkgconfig
pkg-config --print-errors --exact-version "$version" surface-mesh-foliation
read -ra flags <<<"$(pkg-config --cflags surface-mesh-foliation)"
read -ra libraries <<<"$(pkg-config --libs surface-mesh-foliation)"
"$compiler" -std=c++17 "${flags[@]}" -D "EXPECTED_VERSION=\"$version\"" \
  "$(dirname "$0")/consumer.cpp" -o "$output" "${libraries[@]}"
"$output"
