#!/usr/bin/env bash
# demo/Surface_mesh_foliation/build_engine.sh: compiles the engine to WebAssembly, which makes
# build/engine/engine.js and engine.wasm. Installs what that needs (Debian 12).
set -euo pipefail
cd "$(dirname "$0")/../.."

test/install_packages.sh library wasm

export NODE_PATH=/usr/share/nodejs # where Debian has what the optimizer needs
emcmake cmake -S demo/Surface_mesh_foliation -B build/engine -G Ninja
cmake --build build/engine
ls -l build/engine/engine.js build/engine/engine.wasm
