#!/usr/bin/env bash
# Installs the npm packages for the tests and the page. Every FOLDER has a package.json and a
# package-lock.json, and its packages are installed into its node_modules. The folders are tests/cad
# (mesh validators), tests/search (result tables), tests/schema (JSON Schema) and apps/web (the page).
#
#   tools/install_npm_tools.sh [FOLDER ...]     default: the folders of the tests
#
# Exactly the locked versions are installed, and their install scripts are not run. A second call
# does nothing.
set -euo pipefail
cd "$(dirname "$0")/.."

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
  say "installing the $what of $folder"
  if ! (cd "$folder" &&
    npm ci --ignore-scripts --no-audit --no-fund --loglevel=error "$@"); then
    say "could not install the packages of $folder/package.json; is there a network?"
    exit 3
  fi
  cp "$folder/package-lock.json" "$stamp"
}

[ $# -gt 0 ] || set -- tests/cad tests/search tests/schema
for folder in "$@"; do
  case $folder in
    tests/cad) install_folder "$folder" "mesh validators" --omit=optional ;;
    # Optional dependencies are installed here, because they contain the libraries for this machine.
    tests/search) install_folder "$folder" "reader of result tables" ;;
    tests/schema) install_folder "$folder" "validator of JSON Schema" ;;
    apps/web) install_folder "$folder" "page's libraries and builder" ;;
    *)
      say "unknown folder $folder"
      exit 2
      ;;
  esac
done
