#!/usr/bin/env bash
# Checks that the project builds on a new machine. The script makes a minimal Debian 12 in DIR, clones
# the project there and runs make demo and make test. The first run is as root and installs missing
# packages. The second run is as an ordinary user, and no package may then be missing.
#
#   tools/bootstrap_check.sh [--prepare-only] DIR
#
# DIR must be new or made by this script. The script mounts only /proc of this machine in DIR, and
# always unmounts it at the end. DIR has only the devices that debootstrap makes, as in a plain
# container. The package mirror is the one that this machine uses. The script needs root and
# debootstrap. With --prepare-only it stops before make.
set -euo pipefail

prepare_only=no
if [ "${1:-}" = --prepare-only ]; then
  prepare_only=yes
  shift
fi
if [ $# -ne 1 ] || [ -z "$1" ]; then
  echo "usage: tools/bootstrap_check.sh [--prepare-only] DIR" >&2
  exit 2
fi
source_dir=$(cd "$(dirname "$0")/.." && pwd)
root=$(realpath -m "$1")
say() { printf 'bootstrap_check: %s\n' "$*" >&2; }

if [ "$(id -u)" -ne 0 ]; then say "needs root (debootstrap, chroot)"; exit 3; fi
if ! command -v debootstrap >/dev/null; then
  say "needs debootstrap (apt-get install debootstrap)"
  exit 3
fi
marker=$root/etc/gearwright_bootstrap
if [ -e "$root" ] && [ ! -e "$marker" ] && [ -n "$(ls -A "$root")" ]; then
  say "$root is not empty and was not made by this script"
  exit 2
fi

# Prints the first archive that offers the suite bookworm, from either format of the sources.
mirror=$(apt-get indextargets --format '$(RELEASE) $(SITE)' 'Created-By: Packages' 2>/dev/null |
  awk '$1 == "bookworm" { print $2; exit }')
if [ -z "$mirror" ]; then say "this machine's package sources name no bookworm mirror"; exit 3; fi

mounts=()
undo() {
  local i
  for ((i = ${#mounts[@]} - 1; i >= 0; --i)); do umount -l "${mounts[$i]}" || true; done
}
trap undo EXIT
trap 'say "stopped at line $LINENO"' ERR
trap 'exit 130' INT TERM

proxy=$(apt-config shell p Acquire::http::Proxy | sed "s/^p='\(.*\)'$/\1/")
if [ ! -e "$marker" ]; then
  say "debootstrap into $root"
  mkdir -p "$root"
  http_proxy=${http_proxy:-$proxy} debootstrap --variant=minbase \
    --include=ca-certificates,make,git bookworm "$root" "$mirror" >"$root.log" 2>&1 ||
    { tail -n 20 "$root.log" >&2; say "debootstrap failed, see $root.log"; exit 3; }
  touch "$marker"
fi

say "copying this machine's package configuration"
rm -rf "$root"/etc/apt/sources.list.d "$root"/etc/apt/sources.list
mkdir -p "$root"/etc/apt/sources.list.d "$root"/etc/apt/apt.conf.d "$root"/etc/apt/keyrings
# Only Debian's own sources are used, because the check is for a machine with nothing else.
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
  if [ -f "$file" ] && grep -qF "$mirror" "$file"; then
    cp "$file" "$root/etc/apt/${file#/etc/apt/}"
  fi
done
for folder in apt.conf.d auth.conf.d; do
  if [ -d /etc/apt/$folder ]; then
    mkdir -p "$root/etc/apt/$folder"
    # Copies settings of proxies, access rights and transports, but not the hooks of other
    # packages.
    for file in /etc/apt/$folder/*; do
      if grep -qsE '^ *Acquire|^ *machine ' "$file"; then cp "$file" "$root$file"; fi
    done
  fi
done
cp -L /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/certs/ca-certificates.crt"
for file in /etc/resolv.conf /etc/hosts; do
  if [ -f $file ]; then cp -L $file "$root$file"; fi
done
registry=
if command -v npm >/dev/null; then registry=$(npm config get registry 2>/dev/null || true); fi

mount -t proc proc "$root/proc"
mounts+=("$root/proc")

user=newcomer
home_of() { if [ "$1" = root ]; then echo /root; else echo "/home/$1"; fi; }

inside() { # USER COMMAND: runs the command in the user's clone
  local home
  home=$(home_of "$1")
  chroot --userspec="$1" "$root" env -i HOME="$home" USER="$1" LC_ALL=C.UTF-8 \
    PATH="$(if [ "$1" = root ]; then echo /usr/sbin:/usr/bin:/sbin:/bin; else echo /usr/bin:/bin; fi)" \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt \
    bash -euc "cd $home/gearwright && $2"
}

make_goals() { # USER GOAL ...
  local who=$1 goal begin
  shift
  for goal in "$@"; do
    say "$who: make $goal"
    begin=$SECONDS
    inside "$who" "make $goal"
    say "$who: make $goal took $((SECONDS - begin)) s"
  done
}

say "cloning"
chroot "$root" sh -c "id $user >/dev/null 2>&1 || useradd --create-home $user"
for who in root $user; do
  home=$root$(home_of $who)
  [ -z "$registry" ] || echo "registry=$registry" >"$home/.npmrc"
  rm -rf "$home/gearwright"
  git clone -q --no-hardlinks "$source_dir" "$home/gearwright"
  chroot "$root" chown -R "$who:" "$(home_of $who)/gearwright"
done

inside root 'make --version | head -n 1; git --version; git status --short | head; apt-get -q update'
if [ $prepare_only = yes ]; then say "prepared: $root"; exit 0; fi

make_goals root demo demo test
packages=$(sha256sum <"$root/var/lib/dpkg/status")
make_goals $user demo test
if [ "$packages" != "$(sha256sum <"$root/var/lib/dpkg/status")" ]; then
  say "packages changed while $user built"
  exit 1
fi
say "passed, as root and as $user"
