#!/usr/bin/env bash
# Makes the Debian packages: program, library with headers, Python module, search on many ranks. They contain the
# objects of the preset `release`, so the tests run what they install.
#
#   tools/deb.sh OUTPUT_FOLDER
set -euo pipefail
output=$(realpath -m "$1")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --preset release -DGEARWRIGHT_PYTHON=ON >/dev/null
cmake --build --preset release --target gearwright_cli --target gearwright_mpi --target python_module
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)} \
  cpack --config build/release/CPackConfig.cmake -B "$work" >"$work/log" || { cat "$work/log"; exit 1; }
lintian --fail-on error,warning "$work"/*.deb
mkdir -p "$output"
mv "$work"/*.deb "$output/"
