#!/usr/bin/env bash
# Checks the formatting, which must be clean, and prints advice of clang-tidy. build/lint contains
# compile commands without precompiled headers, because clang-tidy cannot read the ones of g++.
#
#   tools/lint.sh [--fix]     --fix formats in place instead of reporting
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t sources < <(find gearwright apps tests bench docs examples -name node_modules -prune -o \
  \( -name '*.cpp' -o -name '*.hpp' \) -print | sort)
if [ "${1:-}" = --fix ]; then
  clang-format -i "${sources[@]}"
  exit 0
fi
clang-format --dry-run --Werror "${sources[@]}"
echo "lint: ${#sources[@]} files are formatted"

# Headers are checked through the sources that include them.
mapfile -t units < <(printf '%s\n' "${sources[@]}" |
  grep -E '^(gearwright|apps)/.*\.cpp$' | grep -v '_test\.cpp$')
run-clang-tidy -quiet -p build/lint -j "${JOBS:-$(nproc)}" "${units[@]/#/$PWD/}" 2>/dev/null |
  sed 's/\x1b\[[0-9;]*m//g' | grep -vE '^clang-tidy|^$' || true
