#!/usr/bin/env bash
# Tests that the documents can be made. Every equation that a header cites is a link with a valid
# target, and so is every link from page to page. Skipped (77) if doxygen is not installed; `make
# docs` installs it.
set -euo pipefail
command -v doxygen >/dev/null || { echo "doxygen not found, run: make docs"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$GW_SOURCE/tools/make_docs.sh" "$work"

fail() { echo "$1"; exit 1; }
html=$work/html
# The translation of comments must produce labelled paragraphs, symbols and units of members, links
# to equations, and the notation at the head of a file.
grep -q '<dt>Accuracy</dt>' "$html/namespacegearwright.html" || fail "no labelled paragraphs"
grep -q '<span class="unit">mm</span>' "$html/structgearwright_1_1CylindricalSpec.html" ||
  fail "no units at members"
grep -q 'href="theory_02.html#eq_T2_1"' "$html/namespacegearwright.html" || fail "no links to equations"
grep -q '<pre class="notation">' "$html/involute_8hpp.html" || fail "no notation at a file's head"
# The translation must not break a link or a letter without an error of doxygen.
if grep -lE '&amp;#[0-9]+;|\\\[|@gw|@ref' "$html"/*.html; then fail "markup left in the pages above"; fi
