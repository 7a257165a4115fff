#!/usr/bin/env bash
# Installs the npm package in an empty folder without the registry, and compares it with the native program.
#
#   tests/dist/test_npm.sh NATIVE PACKAGE.tgz
#
# Laws: the package needs no other; its program and its module give the numbers of the native program; it contains the
# licences of what is linked into it.
set -euo pipefail
native=$(realpath "$1") package=$(realpath "$2")
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
echo '{"private": true, "type": "module"}' >package.json
npm install --offline --silent --no-audit --no-fund "$package"
[ "$(ls node_modules)" = gearwright ] || { echo "the package needs $(ls node_modules)"; exit 1; }
spec=$source/examples/fixed_center_distance.toml
"$native" pair "$spec" --json >native.json
npx --offline gearwright pair "$spec" --json | cmp - native.json
npx --offline gearwright run "$source/examples/spur_pair.toml" --out found >/dev/null
[ -s found/report.html ]
cat >module.mjs <<'JS'
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { solve } from "gearwright";
const [, , spec] = process.argv;
assert.deepEqual(solve(readFileSync(spec, "utf8")).pair, JSON.parse(readFileSync("native.json", "utf8")).pair);
const listed = JSON.parse(readFileSync("node_modules/gearwright/gearwright.spdx.json", "utf8"));
for (const name of ["musl", "Eigen", "Emscripten"]) assert(listed.packages.some((p) => p.name === name), name);
assert(readFileSync("node_modules/gearwright/licences/Emscripten.txt", "utf8").includes("musl"));
JS
node module.mjs "$spec"
echo "$(basename "$package"): installed, run and imported"
