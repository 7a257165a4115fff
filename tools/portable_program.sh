#!/usr/bin/env bash
# Compiles a program that needs no package, with the libraries of tools/portable_libraries.sh.
#
#   tools/portable_program.sh TARGET     TARGET: windows-x86_64, linux-x86_64, linux-aarch64
#
# The result is build/portable/TARGET/gearwright(.exe). The program for linux-x86_64 consists of the objects of the
# preset `release`. The others are cross-compiled.
set -euo pipefail
cd "$(dirname "$0")/.."
target=${1:?usage: tools/portable_program.sh TARGET}
jobs=${JOBS:-$(nproc)}
portable=$PWD/build/portable
tools/portable_libraries.sh "$target"
if [ "$target" = linux-x86_64 ]; then
  cmake --preset release >/dev/null
  exec cmake --build --preset release --target gearwright_static -j "$jobs"
fi
# -Werror is not used, because MinGW's g++ 12 warns of uninitialised members of a std::variant, and
# the native g++ 12 does not.
cmake -S . -B "$portable/$target" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
  -DGEARWRIGHT_TESTS=OFF -DGEARWRIGHT_BENCH=OFF \
  -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/toolchains/$target.cmake" \
  -DGEARWRIGHT_LIBRARIES="$portable/libraries/$target" >/dev/null
cmake --build "$portable/$target" --target gearwright_cli -j "$jobs"
