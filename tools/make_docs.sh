#!/usr/bin/env bash
# Makes the documents as HTML in FOLDER/html/index.html. Every warning of doxygen is an error. The
# settings are in docs/Doxyfile.
#
#   tools/make_docs.sh [FOLDER]     default: build/docs
#
# The script needs the packages of the group [docs]. It builds nothing, so it needs no compiler and
# no library.
set -euo pipefail
cd "$(dirname "$0")/.."

out=$(realpath -m "${1:-build/docs}")
rm -rf "$out/input" "$out/html"
mkdir -p "$out"
version=$(sed -n 's/^project(gearwright VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
mapfile -t headers < <(cmake -P cmake/gw_public_headers.cmake)
pages=$(python3 -B docs/doxygen/prepare.py "$out/input" README.md CONTRIBUTING.md CHANGELOG.md \
  docs/*.md docs/theory/*.md "${headers[@]}")
# Messages are printed with the name of the source. Their line numbers refer to the prepared copy in
# $out/input.
{
  cat docs/Doxyfile
  echo "PROJECT_NUMBER = $version"
  echo "OUTPUT_DIRECTORY = $out"
  echo "STRIP_FROM_PATH = $out/input"
  echo "STRIP_FROM_INC_PATH = $out/input"
  echo "USE_MDFILE_AS_MAINPAGE = $out/input/README.md"
  echo "$pages"
} | doxygen - 2>&1 | sed "s#^$out/input/##" >&2
echo "Documents  $out/html/index.html"
