#!/usr/bin/env bash
# Installs the mesh validators of tests/cad (package.json, package-lock.json) into its node_modules.
#
# Exactly the locked versions, without running their install scripts; a second call does nothing.
set -euo pipefail
cd "$(dirname "$0")/../tests/cad"

stamp=node_modules/.installed
if [ -f $stamp ] && cmp -s package-lock.json $stamp; then exit 0; fi

say() { printf 'install_npm_tools: %s\n' "$*" >&2; }
if ! command -v npm >/dev/null; then
  say "npm is missing (Debian: apt-get install nodejs npm)"
  exit 3
fi
say "installing the mesh validators of tests/cad"
if ! npm ci --ignore-scripts --omit=optional --no-audit --no-fund --loglevel=error; then
  say "could not install the packages of tests/cad/package.json; is there a network?"
  exit 3
fi
cp package-lock.json $stamp
