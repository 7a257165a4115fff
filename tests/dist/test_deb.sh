#!/usr/bin/env bash
# Installs the Debian packages in a bare Debian 12, upgrades and removes them, and uses them as a programmer does.
#
#   tests/dist/test_deb.sh NATIVE FOLDER     FOLDER contains the .deb files
#
# Needs root, for the chroot. Laws: the static program for Linux runs without any package; the program gives the answer of
# the native one; an upgrade keeps every file that the new version has; after the removal no file of the packages is left;
# a C++ program compiles with CMake and with pkg-config, and the module for Python gives the numbers of the program.
set -euo pipefail
native=$(realpath "$1") folder=$(realpath "$2")
source=$(cd "$(dirname "$0")/../.." && pwd)
[ "$(id -u)" = 0 ] || { echo "test_deb: a chroot needs root" >&2; exit 1; }
work=$(mktemp -d)
root=$work/root
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf "$work"' EXIT

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
quiet() { inside "$@" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; echo "failed: $*"; exit 1; }; }

debootstrap --variant=minbase --include=ca-certificates bookworm "$root" >"$work/log" 2>&1 || { tail -n 20 "$work/log"; exit 1; }
mount -t proc proc "$root/proc"
mkdir "$root/given" "$root/newer"
cp "$folder"/*.deb "$root/given/"
cp -r "$source/tests/consumer" "$source/examples" "$root/"

# The static program runs before any package is installed.
tar -xzf "$folder"/gearwright-*-linux-x86_64.tar.gz -C "$root/given" --strip-components=1 --wildcards '*/gearwright'
inside /given/gearwright pair /examples/fixed_center_distance.toml >"$work/here"
"$native" pair "$source/examples/fixed_center_distance.toml" | cmp - "$work/here"
quiet apt-get update

# A newer version: the same files with another number.
for package in "$root"/given/*.deb; do
  dpkg-deb -R "$package" "$work/unpacked"
  sed -i 's/^Version: .*/&+1/' "$work/unpacked/DEBIAN/control"
  dpkg-deb --root-owner-group -Zgzip -b "$work/unpacked" "$root/newer/$(basename "$package")" >/dev/null
  rm -rf "$work/unpacked"
done

for version in given newer; do
  quiet sh -c "apt-get install -y --no-install-recommends /$version/*.deb"
  installed=$(inside dpkg-query -W -f '${Version}\n' gearwright)
  wanted=$(dpkg-deb -f "$(ls "$root/$version"/gearwright_*.deb)" Version)
  [ "$installed" = "$wanted" ] || { echo "installed is $installed instead of $wanted"; exit 1; }
  changed=$(inside dpkg --verify gearwright libgearwright-dev python3-gearwright gearwright-mpi || true)
  [ -z "$changed" ] || { echo "not as in the packages: $changed"; exit 1; }
done
inside gearwright pair /examples/fixed_center_distance.toml >"$work/here"
"$native" pair "$source/examples/fixed_center_distance.toml" | cmp - "$work/here"
quiet gearwright run /examples/helical_pair.toml --out /tmp/helical
[ -s "$root/tmp/helical/report.html" ]

cat >"$root/tmp/module.py" <<'PYTHON'
import json, subprocess, tomllib
import gearwright as gw
pinion = gw.Gear(teeth=17, normal_module=2.5, profile_shift=0.3, face_width=25)
pair = gw.Pair(pinion, gw.Gear(teeth=43, normal_module=2.5, face_width=25), center_distance=76)
assert pair.center_distance == 76 and 1 < pair.contact_ratio < 2, pair
spec = "/examples/helical_pair.toml"
with open(spec, "rb") as file:
    here = gw.solve(tomllib.load(file), "pair")
there = json.loads(subprocess.run(["gearwright", "pair", spec, "--json"], capture_output=True, check=True).stdout)
assert here["pair"] == there["pair"]
PYTHON
inside python3 /tmp/module.py

quiet apt-get install -y --no-install-recommends g++ cmake ninja-build pkg-config
quiet cmake -G Ninja -S /consumer -B /tmp/built
quiet cmake --build /tmp/built
quiet /tmp/built/consumer
quiet sh -c 'g++ -std=c++20 /consumer/main.cpp $(pkg-config --cflags --libs gearwright) -o /tmp/by_pkg_config && /tmp/by_pkg_config'

quiet apt-get purge -y gearwright libgearwright-dev python3-gearwright gearwright-mpi
left=$(find "$root" -xdev -iname '*gearwright*' -not -path "$root/given/*" -not -path "$root/newer/*" -not -path "$root/tmp/*")
[ -z "$left" ] || { echo "left after the removal: $left"; exit 1; }
echo "packages: installed, upgraded, used and removed"
