"""Tests that no room below the catalogue uses the keys, tables or terms of a file.

Rooms below the catalogue (CONTRIBUTING.md, the block marked `rooms`) name the members of their structs.
The catalogue converts these names to keys. String literals of these rooms must not contain:

    key     a key of a spec with a unit, "tip_diameter_mm" (all keys are in docs/schema/spec.schema.json)
    table   the header of a table, "[gear1" or "[pair]", or the words table, key, spec file, TOML
    gear    a path that begins with gear1. or gear2. (gear/gear.hpp composes these paths)
    tick    a member between backticks that belongs to no key, so that no interface can convert it; the name of a
            verb, "verb `run`", and a command, "`gearwright drive SPEC --take N`", are permitted

Each rule is first tested with a snippet that violates it.
"""

import json
import os
import re
import sys
from pathlib import Path

from test_rooms import read_rows

ROOT = Path(os.environ.get("GW_SOURCE", Path(__file__).resolve().parents[2]))
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
RAW = re.compile(r'R"\(.*?\)"', re.S)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
UNIT = re.compile(r"_(?:mm|deg|um|per_in|arcsec|rpm)$")
# Other units that member names omit, as in kStrengthUnits of catalogue/key.cpp.
STRENGTH_UNIT = re.compile(r"_(?:kW|Nm|C|MPa|HV|m2|m2K_per_W|kg_per_m3)$")
TABLE = re.compile(r"\[(?:gear\d?|pair|fit|search|errors|contact|compensate)\b|\btwo tables\b|\bthe table\b|\ba table\b|"
                   r"\bspec file\b|\bTOML\b|\bthe key\b|\bkeys\b")
GEAR = re.compile(r"\bgear[12]\.")
TICK = re.compile(r"`([^`]*)`")
VERB = re.compile(r"\bverb `\w+`|`gearwright [a-z]+[^`]*`")


def schema_keys():
    """Returns all keys of a spec, and those that contain a unit."""
    schema = json.loads((ROOT / "docs/schema/spec.schema.json").read_text(encoding="utf-8"))
    keys = set(schema["properties"])
    for table in schema["$defs"].values():
        keys |= set(table.get("properties", {}))
    return keys, {key for key in keys if UNIT.search(key)}


def members(keys, catalogue):
    """Returns the names that the catalogue can spell: keys without their unit, and the members
    in its entries."""
    names = {STRENGTH_UNIT.sub("", UNIT.sub("", key)) for key in keys}
    for text in catalogue:
        for fields in re.findall(r"\.fields = \{([^{}]*)\}|\.with_fields\(\{([^{}]*)\}\)", text):
            names |= {part for field in re.findall(r'"([^"]*)"', "".join(fields)) for part in field.split(".")}
        # A limit of a search is a member whose name is the key without the suffix.
        names |= {re.sub(r"_(?:min|max)$", "", key) for key in re.findall(r'\blimit\(\s*"(\w+)"', text)}
    # modification_keys.cpp and error_keys.cpp compose the names of these members of reliefs and errors.
    return names | {"amount", "reach", "shape", "helix_twist", "cutter_lead"}


def literals(text):
    """Returns the string literals of a source. Adjacent literals are joined. Literals in includes and
    in comments are omitted."""
    # Text inside a literal that looks like a comment is kept.
    out, at = [], 0
    token = re.compile(f"{RAW.pattern}|{LITERAL.pattern}|{COMMENT.pattern}|'(?:[^'\\\\]|\\\\.)'", re.S)
    last_end = None
    for hit in token.finditer(text):
        word = hit.group(0)
        if not word.startswith(('"', 'R"')):
            continue
        line = text[text.rfind("\n", 0, hit.start()) + 1:hit.start()]
        if re.match(r"\s*#\s*include", line):
            continue
        body = word[3:-2] if word.startswith('R"') else word[1:-1]
        joined = last_end is not None and text[last_end:hit.start()].strip() == ""
        if joined:
            out[-1] = (out[-1][0], out[-1][1] + body)
        else:
            out.append((text.count("\n", 0, hit.start()) + 1, body))
        last_end = hit.end()
    return out


def check(path, text, unit_keys, known):
    faults = []
    for line, literal in literals(text):
        where = f'{path}:{line}: "{literal}"'
        for word in re.findall(r"[A-Za-z_][A-Za-z_0-9]*", literal):
            if word in unit_keys:
                faults.append(f"{where} names the key {word}")
        plain = TICK.sub("", literal)
        if TABLE.search(plain):
            faults.append(f"{where} speaks of a file's tables or keys")
        if GEAR.search(plain):
            faults.append(f"{where} names a gear's table")
        for member in TICK.findall(VERB.sub("", literal)):
            parts = [p for p in re.sub(r"\[(?:\d*|\{\})\]|\{[^}]*\}", "", member).split(".") if p]
            if not all(p in known or p in ("gear1", "gear2", "left", "right") for p in parts):
                faults.append(f"{where}: no key has the member `{member}`")
    return faults


def self_test(unit_keys, known):
    broken = {
        'f("gear1.tip_diameter_mm");': "names the key tip_diameter_mm",
        'f("a tip_diameter_" "mm here");': "names the key tip_diameter_mm",
        'f("exchange the two tables");': "speaks of a file",
        'f("see [gear2.cut_by]");': "speaks of a file",
        'f("gear1.teeth");': "names a gear's table",
        'f("needs `tool_adendum`");': "no key has the member",
        'f(R"(tip_diameter_mm)");': "names the key tip_diameter_mm",
    }
    for text, expected in broken.items():
        faults = check("gearwright/gear/a.cpp", text, unit_keys, known)
        assert any(expected in fault for fault in faults), f"blind to: {text}: {faults}"
    sound = '''#include "gearwright/gear/gear.hpp"
// the key gear1.tip_diameter_mm of a table
f("the verb `run`, the command `gearwright drive SPEC --take N`");
f("rack.dedendum", "`pair.center_distance` or `gear2.cut_by`", "a stable gear 1. Table", '"', "the ring is gear 2");
'''
    assert check("gearwright/gear/a.cpp", sound, unit_keys, known) == [], check("a", sound, unit_keys, known)


def main():
    rows = read_rows((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    below = [room for room, height in rows.items() if height < rows["catalogue"]]
    assert "gear" in below and "job" not in below, below
    keys, unit_keys = schema_keys()
    assert len(unit_keys) > 60, unit_keys
    catalogue = [f.read_text(encoding="utf-8") for f in sorted((ROOT / "gearwright/catalogue").glob("*_keys.cpp"))]
    known = members(keys, catalogue)
    self_test(unit_keys, known)
    faults, count = [], 0
    for room in sorted(below):
        for file in sorted((ROOT / "gearwright" / room).rglob("*")):
            name = str(file.relative_to(ROOT))
            if file.suffix not in (".cpp", ".hpp", ".inc") or name.endswith("_test.cpp") or "/testing/" in name:
                continue
            count += 1
            faults += check(name, file.read_text(encoding="utf-8"), unit_keys, known)
    assert count > 100, f"found only {count} files"
    for fault in faults:
        print(fault)
    print(f"{count} files of {len(below)} rooms, {len(unit_keys)} keys, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
