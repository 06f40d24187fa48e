#!/usr/bin/env bash
# package/release.sh [--without-ci] FOLDER: makes a release of the commit that is checked out, in a new
# FOLDER outside of the sources, from a clean clone: checks, tarball, Debian packages, wheel, tests of
# what was made, release notes and checksums. Nothing is published: at the end it prints what is left
# to do. With --without-ci it does not run .ci/run, for a commit that has passed it.
set -euo pipefail
cd "$(dirname "$0")/.."

runs_ci=true
if [ "${1:-}" = --without-ci ]; then
  runs_ci=false
  shift
fi
[ $# -eq 1 ] || { echo "usage: package/release.sh [--without-ci] FOLDER" >&2; exit 2; }
folder=$(realpath -m "$1")
[ ! -e "$folder" ] || { echo "$folder exists; give a new folder" >&2; exit 1; }
case $folder/ in
  "$PWD"/*) echo "$folder is within the sources; give one outside" >&2; exit 1 ;;
esac

stage()
{
  printf '\n=== %s (after %d min %d s)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60))
}

stage "Clean clone"
[ -z "$(git status --porcelain)" ] || {
  echo "there are changes that are not committed (git status)" >&2
  exit 1
}
commit=$(git rev-parse HEAD)
mkdir -p "$folder"
git clone --quiet --no-local . "$folder/clone"
git -C "$folder/clone" checkout --quiet --detach "$commit"
version=$(sed -n 's/^#define CGAL_SURFACE_MESH_FOLIATION_VERSION "\(.*\)"/\1/p' \
  "$folder/clone/include/CGAL/Surface_mesh_foliation/version.h")
tag=v$version
if git rev-parse --quiet --verify "refs/tags/$tag" >/dev/null; then
  echo "the tag $tag exists: package/set_version.sh decides the next version" >&2
  exit 1
fi
DEBFULLNAME=${DEBFULLNAME:-$(git config user.name)}
DEBEMAIL=${DEBEMAIL:-$(git config user.email)}
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct "$commit")
export DEBFULLNAME DEBEMAIL SOURCE_DATE_EPOCH

stage "Checks"
cd "$folder/clone"
test/install_packages.sh style library python chroot speed
test/spelling.sh
for check in every_file_is_listed every_header_is_tested includes_run_downwards \
  test_files_stand_side_by_side named_files_exist versions_agree; do
  cmake -D SOURCE_DIR="$PWD" -P test/$check.cmake
done
if $runs_ci; then
  .ci/run
fi

stage "Tarball"
name=surface-mesh-foliation-$version
git archive --format=tar --prefix="$name/" HEAD | gzip -9n >"$folder/$name.tar.gz"
tar -xzf "$folder/$name.tar.gz" -C "$folder"

# From here on, all is made of the tarball, as others would do it.
cd "$folder/$name"

stage "Debian packages"
package/make_packages.sh "$folder/build"
cp "$folder"/build/packages/*.deb "$folder/"

stage "Wheel"
/usr/bin/python3 -m venv --system-site-packages "$folder/venv"
"$folder/venv/bin/pip" wheel --quiet --no-build-isolation --no-index --no-deps \
  --wheel-dir "$folder" ./python

stage "The wheel, installed and used"
"$folder/venv/bin/pip" install --quiet --no-index --no-deps "$folder"/*.whl
(cd "$folder" && venv/bin/python - "$version" <<'PYTHON'
import sys
import numpy as np
import surface_mesh_foliation as smf

vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
result = smf.reeb_graph(smf.Mesh(vertices, faces), poles=[0, 1, 2, 3])
assert smf.__version__ == sys.argv[1]
assert result.graph.number_of_edges() == 4, result.graph
print("a graph of", result.graph.number_of_nodes(), "nodes")
PYTHON
)

stage "The Debian packages, installed and used"
package/test_packages.sh "$folder/build/packages" "$folder/root"

stage "Notes and checksums"
package/release_notes.sh >"$folder/release_notes.md"
cd "$folder"
sha512sum -- *.tar.gz *.deb *.whl | tee SHA512SUMS

cat <<TEXT

=== Ready, and not published (after $((SECONDS / 60)) min)
Version $version of commit $commit is in $folder. What is left to do, by hand:
  1. read release_notes.md, and go through the checklist of CONTRIBUTING.md;
  2. git tag --sign $tag $commit --file $folder/release_notes.md && git push origin $tag
  3. attach the tarball, the packages, the wheel and SHA512SUMS to the release of that tag;
  4. put the SHA512 of the tarball into the ports of vcpkg and Conan, if they are in registries.
TEXT
