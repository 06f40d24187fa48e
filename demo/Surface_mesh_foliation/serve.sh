#!/usr/bin/env bash
# demo/Surface_mesh_foliation/serve.sh [PORT]: shows the page that build.sh has made, on this machine.
set -euo pipefail
cd "$(dirname "$0")"
[ -f ../../build/page/index.html ] || ./build.sh
exec node serve.mjs ../../build/page "$@"
