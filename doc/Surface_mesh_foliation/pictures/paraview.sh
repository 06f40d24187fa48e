#!/usr/bin/env bash
# doc/Surface_mesh_foliation/pictures/paraview.sh: takes the picture of ParaView's window for the
# manual, fig/paraview.png. ParaView excludes python3-vtk9, and what depends on it: so run this in a
# system of its own (Debian 12), after test/paraview.sh, which installs the module.
set -euo pipefail
cd "$(dirname "$0")/../../.."

test/install_packages.sh program paraview screenshots

build=$PWD/build/paraview
tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$build" --strip-components=2 \
  data/meshes/camel.off
PYTHONPATH=$("$build/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
export PYTHONPATH
export SMF_PICTURE_MESH=$build/camel.off SMF_PICTURE_CAMERA="1 0.15 0.3 0 1 0"
export SMF_PICTURE_READY=$build/ready # a file that the script makes in the end
rm -f "$SMF_PICTURE_READY"

xvfb-run --auto-servernum --server-args="-screen 0 1400x1050x24" bash -euo pipefail -c '
  paraview --dr --script="$PWD/doc/Surface_mesh_foliation/pictures/show_in_paraview.py" &
  for ((second = 0; second < 300; ++second)); do
    [ ! -e "$SMF_PICTURE_READY" ] || break
    sleep 1
  done
  window=$(xdotool search --onlyvisible --name "^ParaView" | tail -n 1)
  xdotool windowmove "$window" 0 0 windowsize "$window" 1400 1050
  sleep 10 # the window is drawn again
  import -window root "$PWD/doc/Surface_mesh_foliation/fig/paraview.png"
  kill -9 $!'
