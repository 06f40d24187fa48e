#!/usr/bin/env bash
# test/paraview.sh: installs ParaView (Debian 12) and tests the filter of the Python module inside
# it. ParaView excludes VTK's own Python module and what depends on it: Debian's packages
# python3-vtk9 and libvtk9-dev are removed. So this is not a part of test/run.sh; a machine that has
# ParaView also runs the test paraview of ctest.
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh library paraview

# as a user would, with the system's Python, which is ParaView's, too
environment=build/paraview
/usr/bin/python3 -m venv --system-site-packages "$environment"
"$environment/bin/pip" install --quiet --no-build-isolation --no-index ./python
packages=$("$environment/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')

PYTHONPATH=$packages PYTHONDONTWRITEBYTECODE=1 pvbatch python/tests/paraview_plugin.py |
  tee "$environment.log"
tail -n 1 "$environment.log" | grep -qx 'paraview: all is well'
