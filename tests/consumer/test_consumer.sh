#!/usr/bin/env bash
# Tests the installed library. find_package and pkg-config both build a program that runs, from a
# prefix that was moved after the installation.
#
# Environment: GW_BUILD, GW_SOURCE, GW_CXX, GW_CMAKE as set by ctest.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$GW_CMAKE" --install "$GW_BUILD" --prefix "$work/first" >"$work/install.log" ||
  { cat "$work/install.log"; exit 1; }
mv "$work/first" "$work/moved"
prefix=$work/moved
if [ -x "$GW_BUILD/gearwright" ]; then
  [ -x "$prefix/bin/gearwright" ] || { echo "the program was built but not installed"; exit 1; }
fi

# The consumer is compiled as the library was: a sanitizer build needs its run-time library.
flags=$(sed -n 's/^CMAKE_CXX_FLAGS:[A-Z]*=//p' "$GW_BUILD/CMakeCache.txt")

echo "== find_package"
"$GW_CMAKE" -G Ninja -S "$GW_SOURCE/tests/consumer" -B "$work/build" \
  -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$GW_CXX" -DCMAKE_CXX_FLAGS="$flags"
"$GW_CMAKE" --build "$work/build"
found=$(sed -n 's/^gearwright_DIR:[A-Z]*=//p' "$work/build/CMakeCache.txt")
case $found in
  "$prefix"/*) ;;
  *) echo "find_package took $found instead of the new installation"; exit 1 ;;
esac
"$work/build/consumer"
"$work/build/consumer_of_cad"

echo "== headers: the standard library, Eigen and our own, nothing else"
cd "$prefix/include"
if grep -rnE '^ *# *include +<(boost|nlohmann|fmt|toml\+\+|zlib|CLI|TK|BRep|Geom|gp_|TopoDS)' .; then
  echo "an installed header shows a library that its user need not have"
  exit 1
fi
for header in $(find gearwright -name '*.hpp' | sort); do echo "#include \"$header\""; done >"$work/all.hpp"

# This program includes every installed header. The program above includes one header for all.
echo "== pkg-config"
pc=$(dirname "$(find "$prefix" -name gearwright.pc)")
export PKG_CONFIG_PATH=$pc
[ "$(pkg-config --modversion gearwright)" = 0.1.0 ] || { echo "wrong version"; exit 1; }
# shellcheck disable=SC2046,SC2086
"$GW_CXX" -std=c++20 $flags -include "$work/all.hpp" "$GW_SOURCE/tests/consumer/main.cpp" \
  $(pkg-config --cflags --libs gearwright) -o "$work/by_pkg_config"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir gearwright) "$work/by_pkg_config"
