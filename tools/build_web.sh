#!/usr/bin/env bash
# Builds the page. The results are the engine for WebAssembly, the folder build/web for a web server
# and the single file build/web/gearwright.html.
#
#   tools/build_web.sh [JOBS]
#
# GEARWRIGHT_ENGINE is a folder with an engine that is already compiled.
set -euo pipefail
cd "$(dirname "$0")/.."

jobs=${1:-$(nproc)}
if [ -z "${GEARWRIGHT_ENGINE:-}" ]; then
  # Debian's emscripten requires node modules, which are in Debian's folder of node modules.
  modules=$(dpkg -L node-acorn 2>/dev/null | sed -n 's#/acorn/package.json$##p' | head -1)
  export NODE_PATH=${modules:-${NODE_PATH:-}}
  cmake --preset wasm -DGEARWRIGHT_TESTS=OFF >/dev/null
  cmake --build --preset wasm --target gearwright_engine -j "$jobs"
fi

tools/install_npm_tools.sh apps/web
cd apps/web
node_modules/.bin/tsc -p .
rm -rf ../../build/web/assets
node_modules/.bin/vite build --logLevel warn
node_modules/.bin/vite build --logLevel warn --mode single
cd ../../build/web
size=$(wc -c <gearwright.html)
printf 'build/web/gearwright.html  %d.%02d MB, opens from disk\n' $((size / 1000000)) $((size % 1000000 / 10000))
if [ "$size" -ge 2990000 ]; then
  echo "build_web: gearwright.html has 2.99 MB or more" >&2
  exit 1
fi
