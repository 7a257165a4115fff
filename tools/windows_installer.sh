#!/usr/bin/env bash
# Makes the Windows installer, with start menu, PATH and uninstaller, from an unpacked folder.
#
#   tools/windows_installer.sh VERSION FOLDER OUTPUT
set -euo pipefail
version=$1 folder=$(realpath "$2") output=$(realpath -m "$3")
files=$(mktemp)
trap 'rm -f "$files"' EXIT
# The uninstaller deletes the installed files by name, then the folders that are empty.
(cd "$folder" && find . -type f -printf 'Delete "$INSTDIR\\%P"\n' && find . -depth -mindepth 1 -type d -printf 'RMDir "$INSTDIR\\%P"\n') |
  sed 's#/#\\#g' >"$files"
makensis -V2 -DVERSION="$version" -DFOLDER="$folder" -DFILES="$files" -DOUTPUT="$output" \
  "$(dirname "$0")/../packaging/windows/installer.nsi"
