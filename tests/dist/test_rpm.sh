#!/usr/bin/env bash
# Checks a package for rpm: its requirements, the findings of rpmlint, and that the unpacked program
# gives the same answers as the native one.
#
#   tests/dist/test_rpm.sh NATIVE PACKAGE.rpm [EMULATOR]
set -euo pipefail
native=$(realpath "$1") package=$(realpath "$2") emulator=${3:-}
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

needs=$(rpm -qp --requires "$package" | grep -v '^rpmlib(' || true)
[ -z "$needs" ] || { echo "the package needs $needs"; exit 1; }
rpm -qlp "$package" >"$work/files"
for file in /usr/bin/gearwright /usr/share/man/man1/gearwright.1.gz /usr/share/licenses/gearwright/LICENSE \
  /usr/share/licenses/gearwright/gearwright.spdx.json /usr/share/doc/gearwright/examples/helical_pair.toml; do
  grep -qx "$file" "$work/files" || { echo "$file is not in the package"; exit 1; }
done
! grep 'licences/page' "$work/files" || { echo "the package lists the libraries of the page, which it does not contain"; exit 1; }
# The package is not signed, and static linking is its purpose, so these two findings are expected.
rpmlint "$package" >"$work/lint" 2>&1 || true
grep -q 'packages and .* specfiles checked' "$work/lint" || { cat "$work/lint"; echo "rpmlint did not end"; exit 1; }
! grep -E ': E: ' "$work/lint" | grep -vE 'no-signature|statically-linked-binary' || { echo "rpmlint finds errors"; exit 1; }

(cd "$work" && rpm2cpio "$package" | cpio -id --quiet)
for verb in pair run; do
  mkdir -p "$work/$verb"
done
$emulator "$work/usr/bin/gearwright" pair "$source/examples/fixed_center_distance.toml" >"$work/pair/here"
"$native" pair "$source/examples/fixed_center_distance.toml" >"$work/pair/native"
cmp "$work/pair/here" "$work/pair/native"
$emulator "$work/usr/bin/gearwright" run "$work/usr/share/doc/gearwright/examples/helical_pair.toml" --out "$work/run" >/dev/null
[ -s "$work/run/report.html" ]
echo "$(basename "$package"): needs nothing, runs"
