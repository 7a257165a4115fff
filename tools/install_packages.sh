#!/usr/bin/env bash
# Installs only the missing packages of the given groups of tools/packages.txt.
#
#   tools/install_packages.sh [group ...]     default: core
#   tools/install_packages.sh --list [group ...]     prints missing packages, installs nothing
#
# The script checks dpkg first, so a second call takes no time and needs neither a network nor root.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
list_only=no
if [ "${1:-}" = --list ]; then
  list_only=yes
  shift
fi
[ $# -gt 0 ] || set -- core

say() { printf 'install_packages: %s\n' "$*" >&2; }

# Prints the names of one group, without those whose command exists already.
group_packages() {
  awk -v group="$1" '
    { sub(/#.*/, "") }
    /^\[/ { gsub(/[][ \t]/, ""); here = ($0 == group); found += here; next }
    here && NF { print $1, substr($2, 2) }
    END { exit found ? 0 : 1 }' "$here/packages.txt" |
    while read -r name command; do
      if [ -z "$command" ] || ! command -v "$command" >/dev/null; then echo "$name"; fi
    done
}

wanted=()
for group in "$@"; do
  if ! names=$(group_packages "$group"); then
    say "no group [$group] in tools/packages.txt"
    exit 2
  fi
  mapfile -t -O "${#wanted[@]}" wanted <<<"$names"
done

if ! command -v dpkg-query >/dev/null; then
  say "this is not a Debian system; please install the equivalents of: ${wanted[*]}"
  exit 0
fi

missing=()
for name in "${wanted[@]}"; do
  [ -n "$name" ] || continue
  status=$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$name")
done
if [ $list_only = yes ]; then
  [ ${#missing[@]} -eq 0 ] || printf '%s\n' "${missing[@]}"
  exit 0
fi
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if command -v sudo >/dev/null; then
    as_root=(sudo)
  else
    say "missing packages: ${missing[*]}"
    say "installing them needs root or sudo. As root: apt-get install ${missing[*]}"
    exit 3
  fi
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y
  --no-install-recommends -o Acquire::Retries=2 -o Dpkg::Use-Pty=0)

say "installing: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# The package lists may be missing or old. They are updated once if the first attempt fails.
if "${apt[@]}" install "${missing[@]}" >"$log" 2>&1; then exit 0; fi
say "updating the package lists"
if "${apt[@]}" update >>"$log" 2>&1 && "${apt[@]}" install "${missing[@]}" >>"$log" 2>&1; then
  exit 0
fi
grep -E '^(E|W):' "$log" | sort -u | head -n 12 >&2 || true
say "could not install: ${missing[*]}"
say "is there a network, and do the package sources of this machine name a Debian 12 mirror?"
exit 3
