#!/usr/bin/env bash
# Compiles the libraries that a portable program links statically, from Debian's source packages.
#
#   tools/portable_libraries.sh TARGET     TARGET: windows-x86_64, linux-x86_64, linux-aarch64
#
# The result is build/portable/libraries/TARGET with include/ and lib/. Sources are fetched once with
# apt-get source, which uses separate package lists and leaves those of the system unchanged. A second
# call does nothing. If a mirror lists a version that it does not have, the next older version is
# fetched. The exit status is 75 if there is none.
set -euo pipefail
cd "$(dirname "$0")/.."
target=${1:?usage: tools/portable_libraries.sh TARGET}
toolchain=$PWD/cmake/toolchains/$target.cmake
[ -f "$toolchain" ] || { echo "portable_libraries: no target $target in cmake/toolchains" >&2; exit 2; }
root=$PWD/build/portable
sources=$root/sources
into=$root/libraries/$target
jobs=${JOBS:-$(nproc)}
packages=(fmtlib zlib onetbb highway libzstd sqlite3 musl)
# A folder is complete if its file names these packages.
complete() { [ "$(cat "$1/complete" 2>/dev/null)" = "${packages[*]}" ]; }
complete "$into" && exit 0

fetch() {
  complete "$sources" && return
  rm -rf "$sources"
  mkdir -p "$sources/apt/parts" "$sources/apt/lists/partial" "$sources/apt/cache/archives/partial"
  # Debian 12 stores the list of its package sources in one of two formats.
  local given=/etc/apt/sources.list.d/debian.sources
  [ ! -f $given ] || sed 's/^Types:.*/Types: deb-src/' $given >"$sources/apt/parts/debian.sources"
  [ ! -f /etc/apt/sources.list ] || sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >"$sources/apt/parts/debian.list"
  local options=(-qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$sources/apt/parts"
    -o Dir::State::lists="$sources/apt/lists" -o Dir::Cache="$sources/apt/cache" -o APT::Sandbox::User=root)
  apt-get "${options[@]}" update || exit 75
  local package version
  for package in "${packages[@]}"; do
    for version in $(apt-cache "${options[@]}" showsrc --only-source "$package" | sed -n 's/^Version: //p' | sort -rVu); do
      (cd "$sources" && apt-get "${options[@]}" source "$package=$version") && continue 2
      echo "portable_libraries: the sources of $package $version cannot be fetched, trying an older version" >&2
    done
    exit 75
  done
  echo "${packages[*]}" >"$sources/complete"
}

# Prints the unpacked folder of a source package.
folder() { find "$sources" -maxdepth 1 -type d -name "$1-*" | head -n 1; }

# Configures and installs a library that has a CMakeLists.txt. Arguments: FOLDER, then options of CMake.
with_cmake() {
  local from=$1
  shift
  local build=$root/made/$target/$(basename "$from")
  # Messages of a library name its sources, wherever they are.
  local flags="-ffp-contract=off -ffile-prefix-map=$root=."
  cmake -S "$from" -B "$build" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_INSTALL_PREFIX="$into" -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_SHARED_LIBS=OFF \
    -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_C_FLAGS="$flags" \
    "$@" >"$build.log" 2>&1 || { tail -n 30 "$build.log" >&2; exit 1; }
  cmake --build "$build" -j "$jobs" --target install >>"$build.log" 2>&1 || { tail -n 30 "$build.log" >&2; exit 1; }
}

# Compiles a library without its own build system, which would also build tests. Arguments: NAME, language (C or CXX),
# options of the compiler, then sources.
plain() {
  local name=$1 language=$2 options=$3 compiler work=$root/made/$target/$1
  shift 3
  compiler=$(sed -n "s/^set(CMAKE_${language}_COMPILER \\(.*\\))\$/\\1/p" "$toolchain")
  mkdir -p "$work"
  # shellcheck disable=SC2086
  (cd "$work" && printf '%s\0' "$@" | xargs -0 -n 1 -P "$jobs" "$compiler" -O2 -fPIC -ffp-contract=off \
    -ffile-prefix-map="$root=." $options -c)
  ar rcs "$into/lib/lib$name.a" "$work"/*.o
}

fmt() {
  local from
  from=$(folder fmtlib)
  cp -r "$from/include/fmt" "$into/include/"
  plain fmt CXX "-DNDEBUG -std=c++20 -I$from/include" "$from/src/format.cc"
}

# The headers compute. The library only finds the instruction sets of the processor.
highway() {
  local from
  from=$(folder highway)
  mkdir -p "$into/include/hwy/contrib"
  cp "$from"/hwy/*.h "$into/include/hwy/"
  cp -r "$from/hwy/ops" "$into/include/hwy/"
  cp -r "$from/hwy/contrib/math" "$into/include/hwy/contrib/"
  plain hwy CXX "-DNDEBUG -std=c++20 -I$from" "$from"/hwy/{aligned_allocator,per_target,targets}.cc
}

# Builds SQLite from one file, which its own scripts make with tclsh.
sqlite() {
  local together=$root/made/sqlite
  if [ ! -f "$together/complete" ]; then
    rm -rf "$together"
    cp -r "$(folder sqlite3)" "$together"
    (cd "$together" && ./configure --disable-tcl >configure.log 2>&1 && make sqlite3.c >make.log 2>&1)
    touch "$together/complete"
  fi
  cp "$together/sqlite3.h" "$into/include/"
  # -Os is fast enough, because a search writes only one row of its journal for each chunk.
  plain sqlite3 C "-Os -DSQLITE_THREADSAFE=1 -DSQLITE_OMIT_LOAD_EXTENSION" "$together/sqlite3.c"
}

zlib() {
  local from
  from=$(folder zlib)
  cp "$from/zlib.h" "$from/zconf.h" "$into/include/"
  plain z C "-D_LARGEFILE64_SOURCE=1" "$from"/{adler32,compress,crc32,deflate,infback,inffast,inflate,inftrees,trees,uncompr,zutil}.c
}

# A search uses levels 1 and 3, whose methods are fast and double_fast. The other methods, and the decoder, which only
# reads the record of a finished search, are compiled for size.
zstd() {
  local from options="-DZSTD_LEGACY_SUPPORT=0 -DZSTD_DISABLE_ASM -DXXH_NAMESPACE=ZSTD_"
  from=$(folder libzstd)/lib
  cp "$from/zstd.h" "$into/include/"
  plain zstd C "-Os $options" "$from"/decompress/*.c "$from"/compress/zstd_{lazy,ldm,opt}.c
  plain zstd C "-O3 $options" "$from"/common/*.c "$from"/compress/{fse,huf,zstd}_compress.c "$from"/compress/hist.c \
    "$from"/compress/zstd_{compress_literals,compress_sequences,compress_superblock,double_fast,fast}.c
}

# Compiles the elementary functions of musl. The headers are those of a 32-bit machine, because
# there, as on Windows, the type with 64 bits is `long long`. __FP_FAST_FMA would change the last
# bits on ARM.
elementary() {
  local from header=$root/made/$target/musl names
  from=$(folder musl)
  mkdir -p "$header/bits"
  sed -f "$from/tools/mkalltypes.sed" "$from/arch/i386/bits/alltypes.h.in" "$from/include/alltypes.h.in" >"$header/bits/alltypes.h"
  names=$(sed '/^#/d; s#\<c\(abs\|arg\)\>#../complex/&#g' tools/elementary.txt)
  # shellcheck disable=SC2046,SC2086
  plain elementary C "-std=c99 -nostdinc -ffreestanding -fno-math-errno -Wno-attributes -Dsqrt=__builtin_sqrt -Dfabs=__builtin_fabs
    -U__FP_FAST_FMA -D_XOPEN_SOURCE=700 -I$header -I$from/arch/generic -I$from/arch/i386 -I$from/src/internal
    -I$from/src/include -I$from/include" $(printf "$from/src/math/%s.c " $names)
}

# The objects of the preset `release` call toml++ as a library, which Debian has only as a shared one.
# The other programs use only its headers.
tomlplusplus() {
  local work=$root/made/$target/tomlplusplus
  mkdir -p "$work"
  printf '#define TOML_IMPLEMENTATION\n#include <toml++/toml.h>\n' >"$work/toml.cpp"
  g++ -std=c++20 -O2 -DNDEBUG -fPIC -ffp-contract=off -DTOML_HEADER_ONLY=0 -c "$work/toml.cpp" -o "$work/toml.o"
  ar rcs "$into/lib/libtomlplusplus.a" "$work/toml.o"
}

fetch
rm -rf "$into" "$root/made/$target"
mkdir -p "$into/lib" "$into/include" "$root/made/$target"
fmt
zlib
# oneTBB needs no speed, because the program calls it once for each item of a search or each position of a mesh.
with_cmake "$(folder onetbb)" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF \
  -DTBB_FIND_PACKAGE=OFF
highway
zstd
sqlite
if [ "$target" = linux-x86_64 ]; then tomlplusplus; else elementary; fi
echo "${packages[*]}" >"$into/complete"
