#!/usr/bin/env bash
# demo/Surface_mesh_foliation/test.sh: tests the page that build.sh has made: its parts under node, and
# all of it in Debian's Chromium, without a window. What a click takes is written to
# build/page_test/page.csv, and pictures of the page to build/page_test/pictures.
set -euo pipefail
cd "$(dirname "$0")"

../../test/install_packages.sh browser
node test/run_unit_tests.mjs
node --test test/browser/*.test.mjs
