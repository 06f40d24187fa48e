#!/usr/bin/env bash
# package/test_packages.sh PACKAGES [ROOT]: installs the Debian packages of the folder PACKAGES, with
# what they depend on, in a Debian 12 of their own in the folder ROOT (build/packages_root by default;
# an existing one is used again), and uses them there: the program on a mesh, its man page and
# completion, a project with CMake, one with pkg-config, an example. Needs to be root, for chroot.
set -euo pipefail
packages=$(realpath "$1")
cd "$(dirname "$0")/.."
root=$(realpath -m "${2:-build/packages_root}")
version=$(sed -n 's/^#define CGAL_SURFACE_MESH_FOLIATION_VERSION "\(.*\)"/\1/p' \
  include/CGAL/Surface_mesh_foliation/version.h)

[ "$(id -u)" -eq 0 ] || { echo "package/test_packages.sh has to be run by root" >&2; exit 1; }
test/install_packages.sh chroot

if [ ! -e "$root/var/lib/dpkg/status" ]; then
  debootstrap --variant=minbase bookworm "$root.part" "$(test/debian_mirror.sh)"
  mv "$root.part" "$root"
  # documentation is what is tested here, too, but containers' configurations may leave it out
  rm -f "$root"/etc/dpkg/dpkg.cfg.d/*docs*
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"
[ ! -e /etc/apt/apt.conf.d ] || cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"

rm -rf "$root/packages" "$root/consumer"
mkdir -p "$root/consumer"
cp -r "$packages" "$root/packages"
cp -r test/consumer.cpp test/consumer_find_package test/consumer_pkg_config.sh "$root/consumer/"
cp -r package/test_completion.sh "$root/consumer/"

inside()
{
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" \
    chroot "$root" bash -euo pipefail -c "$1"
}

mount -t proc proc "$root/proc" # bash reads the output of commands through it
trap 'umount "$root/proc"' EXIT

echo "== The program alone"
inside 'apt-get update -qq
  apt-get install -y -qq --no-install-recommends /packages/surface-mesh-foliation_*.deb >/dev/null
  if dpkg-query -W libcgal-dev 2>/dev/null; then
    echo "the program brings a library for developers along" >&2
    exit 1
  fi'
printf '%s\n' OFF '4 4 0' '0 0 0' '1 0 0' '0 1 0' '0 0 1' \
  '3 0 2 1' '3 0 1 3' '3 0 3 2' '3 1 2 3' >"$root/consumer/tetrahedron.off"
inside "cd /consumer
  test \"\$(surface-mesh-foliation --version)\" = 'Surface_mesh_foliation $version'
  surface-mesh-foliation tetrahedron.off --pole 0 --pole 1 --pole 2 --pole 3 \
    --output 'a folder' --json >graph.json
  grep -q '\"certified\": true' graph.json
  test -s 'a folder/reeb_graph.graphml'
  ! surface-mesh-foliation missing.off 2>errors
  grep missing.off errors
  zcat /usr/share/man/man1/surface-mesh-foliation.1.gz | grep -q max
  mkdir -p completion
  cp /usr/share/bash-completion/completions/surface-mesh-foliation completion/completion.bash
  ./test_completion.sh completion"

echo "== The library and its documentation"
inside "apt-get install -y -qq --no-install-recommends g++ cmake make pkgconf \
    /packages/libsurface-mesh-foliation-d*.deb >/dev/null
  cd /consumer
  ./consumer_pkg_config.sh g++ /usr '$version' ./by_pkg_config
  cmake -S consumer_find_package -B build -D EXPECTED_VERSION='$version' -D CMAKE_BUILD_TYPE=Debug
  cmake --build build
  build/consumer
  test -s /usr/share/doc/libsurface-mesh-foliation-doc/html/index.html
  g++ -std=c++17 \$(pkg-config --cflags surface-mesh-foliation) \
    /usr/share/doc/libsurface-mesh-foliation-doc/examples/reeb_graph_surface_mesh.cpp \
    -o example \$(pkg-config --libs surface-mesh-foliation)
  ./example tetrahedron.off 0 1 2 3"

echo "== Removed again"
# shellcheck disable=SC2016
inside 'apt-get purge -y -qq surface-mesh-foliation libsurface-mesh-foliation-dev \
    libsurface-mesh-foliation-doc >/dev/null
  left=$(find /usr -iname "*surface?mesh?foliation*")
  if [ -n "$left" ]; then
    echo "left behind: $left" >&2
    exit 1
  fi'
echo "The packages of version $version install, work and can be removed."
