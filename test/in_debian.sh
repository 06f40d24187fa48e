#!/usr/bin/env bash
# test/in_debian.sh SUITE ARCHITECTURE [CMAKE-ARGUMENT...]: builds and runs tests in a Debian of its own
# in build/debian/SUITE-ARCHITECTURE (debootstrap; an existing one is used again), with the compiler and
# the CGAL that it has:
#   test/in_debian.sh trixie amd64      Debian 13
#   test/in_debian.sh bookworm i386     32 bits
# By default these are the tests of the rooms that decide what is exact, with warnings as errors; with
# -D SURFACE_MESH_FOLIATION_TESTS= all. Needs to be root, for chroot.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -ge 2 ] || { echo "usage: test/in_debian.sh SUITE ARCHITECTURE [CMAKE-ARGUMENT...]" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || { echo "test/in_debian.sh has to be run by root" >&2; exit 1; }
suite=$1 architecture=$2
shift 2
root=$PWD/build/debian/$suite-$architecture

test/install_packages.sh chroot
if [ ! -e "$root/var/lib/dpkg/status" ]; then
  rm -rf "$root.part"
  debootstrap --variant=minbase --arch="$architecture" "$suite" "$root.part" "$(test/debian_mirror.sh)"
  mv "$root.part" "$root"
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"
[ ! -e /etc/apt/apt.conf.d ] || cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"

# the sources, without the times of files that have not changed
mkdir -p "$root/source"
git ls-files -z |
  xargs -0 cp --parents --preserve=timestamps --update --target-directory "$root/source"

inside()
{
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" \
    chroot "$root" "$@"
}
inside sh -c 'cd /source && test/install_packages.sh library tests'

flags=
# the registers of the old coprocessor would round twice
[ "$architecture" != i386 ] || flags="-msse2 -mfpmath=sse"
inside cmake -S /source -B /build -G Ninja \
  -D CMAKE_BUILD_TYPE=Release \
  -D CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
  -D CMAKE_CXX_FLAGS="$flags" \
  -D SURFACE_MESH_FOLIATION_WERROR=ON \
  -D SURFACE_MESH_FOLIATION_CHECK_HEADERS=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_PYTHON=OFF \
  -D SURFACE_MESH_FOLIATION_TESTS='^test_(common|mesh|homotopy|loops|foliation)$' \
  "$@"
targets=$(inside ninja -C /build -t targets all | sed -n 's/^\(test_[a-z]*\): phony$/\1/p')
wanted=$(inside cmake -L -N -B /build | sed -n 's/^SURFACE_MESH_FOLIATION_TESTS:STRING=//p')
if [ -n "$wanted" ]; then
  # (what is not wanted is no part of the target all, but for the program of all headers)
  targets=$(grep -E "foundations|foliations" <<<"$targets")
else
  targets=all
fi
# shellcheck disable=SC2086
inside cmake --build /build --target $targets
inside ctest --test-dir /build --output-on-failure --no-tests=error --parallel "$(nproc)" \
  --tests-regex '^test_'
