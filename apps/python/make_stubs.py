"""Type stubs of the extension module: core.pyi.in with the catalogue's keys and quantities in it.

    make_stubs.py PACKAGE      writes PACKAGE/_core.pyi
"""

import sys
from pathlib import Path

sys.path[0] = str(Path(sys.argv[1]).parent)  # not the package's sources, which lie beside this script
import gearwright._core as core  # noqa: E402

PLAIN = {"number": "float", "whole": "int", "index": "int", "flag": "bool", "word": "str", "text": "str",
         "map": "dict[str, Any]"}


def class_of(table):
    """"pair.backlash" as _PairBacklash."""
    words = table.replace(".", " ").replace("_", " ").split()
    return "_" + "".join(word[0].upper() + word[1:] for word in words)


def type_of(said):
    if said["type"] == "column":
        return "Array"
    if said["type"] == "number" and said["list"][:1] == [0]:
        return "Array" if said["always"] else "Array | None"
    inner = class_of(said["of"]) if said["of"] else PLAIN.get(said["type"], "Record")
    text = inner
    for length in reversed(said["list"]):
        item = text if said["always"] or text.startswith("tuple") else f"{text} | None"
        text = f"tuple[{', '.join([item] * length) if 0 < length < 5 else item + ', ...'}]"
    return text if said["always"] else f"{text} | None"


def attribute(said):
    doc = said["doc"].replace("\\", "\\\\").replace('"""', "'''")
    return f'    @property\n    def {said["name"]}(self) -> {type_of(said)}:\n        """{doc}"""\n'


def keywords(keys):
    kinds = {"number": "float", "whole": "int", "boolean": "bool", "text": "str"}
    lines, seen = [], set()
    for key in keys:
        kind = "Any" if key["list"] else kinds.get(key["kind"], "Any")
        for name in (key["key"], key["name"]):
            if name not in seen:
                seen.add(name)
                lines.append(f"        {name}: {kind} | None = ...,\n")
    return "".join(lines)


def main():
    tables = core._catalogue()
    keys = core._keys()
    records = [f"class {class_of(name)}(Record):\n" + "".join(map(attribute, said))
               for name, said in tables.items() if name not in ("gear", "pair", "contact", "contact.positions", "rating", "load")]
    columns = [dict(said, type="column") for said in tables["contact.positions"] if not said["of"]]
    contact = [said for said in tables["contact"] if said["name"] != "positions"]
    text = Path(__file__).with_name("core.pyi.in").read_text(encoding="utf-8")
    for mark, made in (("    # gear attributes\n", "".join(map(attribute, tables["gear"]))),
                       ("    # pair attributes\n", "".join(map(attribute, tables["pair"]))),
                       ("    # contact attributes\n", "".join(map(attribute, contact + columns))),
                       ("    # rating attributes\n", "".join(map(attribute, tables["rating"]))),
                       ("    # loaded attributes\n", "".join(map(attribute, tables["load"]))),
                       ("        # gear keywords\n", keywords(keys["gear"])),
                       ("        # pair keywords\n", keywords(keys["pair"])),
                       ("        # sweep keywords\n", keywords(keys["pair"]).replace("float | None", "ArrayLike")),
                       ("        # compensate keywords\n", keywords(keys["compensate"])),
                       ("        # rating keywords\n", keywords(keys["rating"])),
                       ("        # load keywords\n", keywords(keys["load"])),
                       ("        # contact keywords\n", keywords(keys["contact"])),
                       ("# records\n", "\n".join(records))):
        assert mark in text, f"core.pyi.in has no {mark.strip()}"
        text = text.replace(mark, made)
    Path(sys.argv[1], "_core.pyi").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
