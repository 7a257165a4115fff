#!/usr/bin/env bash
# Makes the programs that need no package and no compiler: build/dist.
#
#   tools/dist.sh [TARGET ...]     default: windows-x86_64 linux-x86_64 linux-aarch64
#
#   gearwright-VERSION-windows-x86_64.zip          gearwright.exe, the examples, the documents and, if it was built, the page
#   gearwright-VERSION-linux-x86_64.tar.gz         the same for any Linux: fully static
#   gearwright-VERSION-linux-aarch64.tar.gz
#   gearwright-VERSION.spdx.json                   what is linked in, with versions and licences
#   SHA256SUMS
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -n 's/^project(gearwright VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ $# -gt 0 ] || set -- windows-x86_64 linux-x86_64 linux-aarch64
dist=$PWD/build/dist
mkdir -p "$dist"

pack() {
  local target=$1 build=$PWD/build/portable/$1 name=gearwright-$version-$1 program=gearwright
  case $target in windows-*) program=gearwright.exe ;; esac
  local folder=$build/pack/$name
  rm -rf "$build/pack"
  mkdir -p "$folder"
  cp "$build/$program" README.md CHANGELOG.md LICENSE "$folder/"
  cp -r examples "$folder/examples"
  cp -r docs "$folder/docs"
  rm -rf "$folder/docs/figures" "$folder/docs/doxygen" "$folder/docs/Doxyfile"
  [ ! -f build/web/gearwright.html ] || cp build/web/gearwright.html "$folder/"
  # The same input gives the same bytes: names in order, one date.
  find "$build/pack" -exec touch -h -d "@${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}" {} +
  if [ "$program" = gearwright.exe ]; then
    rm -f "$dist/$name.zip"
    (cd "$build/pack" && find "$name" | LC_ALL=C sort | zip -q -X -@ "$dist/$name.zip")
  else
    (cd "$build/pack" && tar --sort=name --owner=0 --group=0 --numeric-owner -cf - "$name") | gzip -9n >"$dist/$name.tar.gz"
  fi
}

for target in "$@"; do
  tools/portable_libraries.sh "$target"
  cmake -S . -B "build/portable/$target" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
    -DGEARWRIGHT_WERROR=ON -DGEARWRIGHT_TESTS=OFF -DGEARWRIGHT_BENCH=OFF \
    -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/toolchains/$target.cmake" \
    -DGEARWRIGHT_LIBRARIES="$PWD/build/portable/libraries/$target" >/dev/null
  cmake --build "build/portable/$target" --target gearwright_cli -j "${JOBS:-$(nproc)}"
  pack "$target"
done
tools/sbom.py "$version" build/portable/sources >"$dist/gearwright-$version.spdx.json"
(cd "$dist" && rm -f SHA256SUMS && sha256sum -- * >.sums && mv .sums SHA256SUMS)
ls -l "$dist"
