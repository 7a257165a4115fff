#!/usr/bin/env bash
# Makes programs for users without packages or a compiler. The results are in build/dist.
#
#   tools/dist.sh [TARGET ...]     default: windows-x86_64 linux-x86_64 linux-aarch64
#
#   gearwright-VERSION-windows-x86_64.zip     gearwright.exe, examples, documents, the page, licences, the list of
#                                             linked libraries (SPDX)
#   gearwright-VERSION-windows-x86_64-setup.exe  the same as an installer, with start menu, PATH and uninstaller
#   gearwright-VERSION-linux-x86_64.tar.gz    the same for any Linux, fully static
#   gearwright-VERSION-linux-aarch64.tar.gz
#   gearwright-VERSION-1.x86_64.rpm, .aarch64.rpm     the same programs as packages without dependencies
#   *.deb                                     program, library with headers, Python module and search on many ranks
#                                             as packages for Debian 12
#   gearwright-VERSION-*.whl, gearwright-VERSION.tgz, gearwright-VERSION.html
#                                             the wheel, the npm package and the page
#   gearwright-VERSION.html.spdx.json         the list of the libraries in the page
#   SHA256SUMS
#
# The link of a program for WebAssembly, the compression of a package and the largest source files of the libraries
# each keep only one core busy. The page and the npm package, the libraries and the packages are therefore made in the
# background, beside the compilation of the programs.
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -n 's/^project(gearwright VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ $# -gt 0 ] || set -- windows-x86_64 linux-x86_64 linux-aarch64
dist=$PWD/build/dist
portable=$PWD/build/portable
page=$PWD/build/web/gearwright.html
mkdir -p "$dist"
# Files of older versions would be listed in SHA256SUMS.
find "$dist" -maxdepth 1 -type f ! -name "*gearwright*[-_]$version[-_.]*" -delete

pack() {
  local target=$1 build=$portable/$1 name=gearwright-$version-$1 program=gearwright
  case $target in windows-*) program=gearwright.exe ;; esac
  local folder=$build/pack/$name
  rm -rf "$build/pack"
  mkdir -p "$folder"
  cp "$build/$program" README.md CHANGELOG.md LICENSE "$folder/"
  cp -r examples "$folder/examples"
  cp -r docs "$folder/docs"
  rm -rf "$folder/docs/figures" "$folder/docs/doxygen" "$folder/docs/Doxyfile"
  tools/sbom.py "$version" "$target" "$build" "$portable/sources" "$folder"
  cp "$page" "$folder/"
  tools/sbom.py "$version" page - apps/web "$folder/licences/page"
  # Names are sorted, and all files have the same date, so that the same input gives the same bytes.
  find "$build/pack" -exec touch -h -d "@${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}" {} +
  if [ "$program" = gearwright.exe ]; then
    rm -f "$dist/$name.zip"
    (cd "$build/pack" && find "$name" | LC_ALL=C sort | TZ=UTC zip -q -X -@ "$dist/$name.zip")
    tools/windows_installer.sh "$version" "$folder" "$dist/$name-setup.exe"
  else
    local run=$folder/$program
    [ "$target" != linux-aarch64 ] || run="qemu-aarch64-static $run"
    [ "$target" != linux-x86_64 ] || tools/deb.sh "$dist"
    tools/rpm.sh "$version" "${target#linux-}" "$folder" "$run" "$dist"
    (cd "$build/pack" && tar --sort=name --owner=0 --group=0 --numeric-owner -cf - "$name") | gzip -9n >"$dist/$name.tar.gz"
  fi
}

# If a step fails, all processes of the background jobs end. Each job is a group of processes.
set -m
trap 'for job in $(jobs -p); do kill -- "-$job" 2>/dev/null || true; done' EXIT
page_and_npm() {
  cmake --preset wasm -DGEARWRIGHT_TESTS=OFF >/dev/null
  cmake --build --preset wasm --target web_npm
  make web npm
}
page_and_npm &
page_job=$!
libraries() {
  for target in "$@"; do tools/portable_libraries.sh "$target"; done
}
libraries "$@" &
libraries_job=$!
make python
wait $libraries_job
packing=()
for target in "$@"; do
  tools/portable_program.sh "$target"
  # Every package contains the page.
  [ ${#packing[@]} -gt 0 ] || wait $page_job
  # The packages of linux-x86_64 contain objects of the preset `release`, which no other target changes.
  pack "$target" &
  packing+=($!)
done
for job in "${packing[@]}"; do wait "$job"; done
cp build/web/gearwright-"$version".tgz build/python/gearwright-"$version"-*.whl "$dist/"
cp "$page" "$dist/gearwright-$version.html"
cp "$portable/$1/pack/gearwright-$version-$1/licences/page/gearwright.spdx.json" "$dist/gearwright-$version.html.spdx.json"
(cd "$dist" && rm -f SHA256SUMS && sha256sum -- * >.sums && mv .sums SHA256SUMS)
ls -l "$dist"
