#!/usr/bin/env bash
# demo/Surface_mesh_foliation/build.sh [OUTPUT]: installs what the page needs (Debian 12's emscripten;
# npm packages in the versions of package-lock.json), compiles the engine to WebAssembly, and builds the
# page, a folder of static files that any web server can serve: build/page, or OUTPUT.
set -euo pipefail
cd "$(dirname "$0")"
root=$(cd ../.. && pwd)

"$root/test/install_packages.sh" page
command -v npm >/dev/null || "$root/test/install_packages.sh" node
./build_engine.sh
npm ci --no-audit --no-fund --loglevel=error
npx tsc
node build.mjs "${1:-$root/build/page}"
