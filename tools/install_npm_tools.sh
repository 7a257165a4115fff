#!/usr/bin/env bash
# Installs the readers and validators that tests use from npm: the package.json and
# package-lock.json of tests/cad (meshes), tests/search (result tables) and tests/schema (JSON
# Schema), each into the node_modules beside it.
#
# Exactly the locked versions, without running their install scripts; a second call does nothing.
set -euo pipefail
cd "$(dirname "$0")/../tests"

say() { printf 'install_npm_tools: %s\n' "$*" >&2; }

install_folder() { # FOLDER WHAT [npm option ...]
  local folder=$1 what=$2
  shift 2
  local stamp=$folder/node_modules/.installed
  if [ -f "$stamp" ] && cmp -s "$folder/package-lock.json" "$stamp"; then return; fi
  if ! command -v npm >/dev/null; then
    say "npm is missing (Debian: apt-get install nodejs npm)"
    exit 3
  fi
  say "installing the $what of tests/$folder"
  if ! (cd "$folder" &&
    npm ci --ignore-scripts --no-audit --no-fund --loglevel=error "$@"); then
    say "could not install the packages of tests/$folder/package.json; is there a network?"
    exit 3
  fi
  cp "$folder/package-lock.json" "$stamp"
}

install_folder cad "mesh validators" --omit=optional
install_folder search "reader of result tables" # its library for this machine counts as optional
install_folder schema "validator of JSON Schema"
