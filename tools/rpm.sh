#!/usr/bin/env bash
# Makes an .rpm from an unpacked folder with a static program (packaging/linux/gearwright.spec).
#
#   tools/rpm.sh VERSION MACHINE FOLDER RUN OUTPUT_FOLDER
#
# RUN is the command that runs the program on this machine. The program then prints the manual page
# and the completions.
set -euo pipefail
version=$1 machine=$2 folder=$(realpath "$3") run=$4 output=$(realpath -m "$5")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
$run manual >"$work/gearwright.1"
licences=$(python3 - "$folder/gearwright.spdx.json" <<'PYTHON'
import json, sys
names = {p["licenseDeclared"] for p in json.load(open(sys.argv[1]))["packages"]}
print(" AND ".join(f"({n})" if " OR " in n or " AND " in n else n for n in sorted(names)))
PYTHON
)
for shell in bash zsh fish; do $run completion "$shell" >"$work/$shell"; done
epoch=${SOURCE_DATE_EPOCH:-$(git -C "$(dirname "$0")" log -1 --format=%ct)}
SOURCE_DATE_EPOCH=$epoch rpmbuild -bb --quiet --target "$machine" --define "_topdir $work/rpm" \
  --define "gw_version $version" --define "gw_folder $folder" --define "gw_date $(LC_ALL=C date -u -d "@$epoch" "+%a %b %d %Y")" --define "gw_made $work" --define "gw_licences $licences" \
  --define "_rpmdir $output" --define "_rpmfilename %{NAME}-%{VERSION}-%{RELEASE}.%{ARCH}.rpm" \
  --define "use_source_date_epoch_as_buildtime 1" --define "clamp_mtime_to_source_date_epoch 1" \
  --define "_buildhost gearwright" "$(dirname "$0")/../packaging/linux/gearwright.spec"
