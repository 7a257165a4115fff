"""Writes the type stubs of the extension module from core.pyi.in, the catalogue and the docstrings of the module.

    make_stubs.py PACKAGE      writes PACKAGE/_core.pyi
"""

import re
import sys
from pathlib import Path

# Removes the folder of this script from the search path, because it contains the sources of the package,
# and adds the folder of the built package.
sys.path[0] = str(Path(sys.argv[1]).parent)
import gearwright._core as core  # noqa: E402

PLAIN = {"number": "float", "whole": "int", "index": "int", "flag": "bool", "word": "str", "text": "str",
         "map": "dict[str, Any]"}


def class_of(table):
    """Returns the name of the class for a table, such as _PairBacklash for "pair.backlash". A space
    becomes an underscore, because "scatter probability" and "scatter.probability" are different
    tables."""
    parts = [part.replace(".", " ").replace("_", " ").split() for part in table.split(" ")]
    return "_" + "_".join("".join(word[0].upper() + word[1:] for word in words) for words in parts)


def type_of(entry):
    if entry["type"] == "column":
        return "Array"
    if entry["type"] == "number" and entry["list"][:1] == [0]:
        return "Array" if entry["always"] else "Array | None"
    inner = class_of(entry["of"]) if entry["of"] else PLAIN.get(entry["type"], "Record")
    text = inner
    for length in reversed(entry["list"]):
        item = text if entry["always"] or text.startswith("tuple") else f"{text} | None"
        text = f"tuple[{', '.join([item] * length) if 0 < length < 5 else item + ', ...'}]"
    return text if entry["always"] else f"{text} | None"


def attributes(entries):
    """Returns a property for each name. Two keys with the same name in different units have the same docstring."""
    one_each = {entry["name"]: entry for entry in entries}
    return "".join(f'    @property\n    def {name}(self) -> {type_of(entry)}:\n        {quoted(entry["doc"])}\n'
                   for name, entry in one_each.items())


def records_of(text, tables):
    """Returns the classes that the text uses, together with all classes that these use in turn.

    Each class is made from one of the tables.
    """
    made = {}
    while True:
        used = text + "".join(made.values())
        missing = [name for name in tables if name not in made and re.search(rf"\b{class_of(name)}\b", used)]
        if not missing:
            return "".join(made[name] for name in tables if name in made)
        for name in missing:
            made[name] = f"class {class_of(name)}(Record):\n" + attributes(tables[name]) + "\n"


def keywords(keys):
    """Returns the keywords of a table: keys, keys without their unit, and keys of lengths in inch."""
    kinds = {"number": "float", "whole": "int", "boolean": "bool", "text": "str"}
    lines, seen = [], set()
    for key in keys:
        kind = "Any" if key["list"] else kinds.get(key["kind"], "Any")
        for name in (key["key"], key["name"], key["in_inch"]):
            if name not in seen:
                seen.add(name)
                lines.append(f"        {name}: {kind} | None = ...,\n")
    return "".join(lines)


def quoted(doc):
    return '"""' + doc.replace("\\", "\\\\").replace('"""', "'''") + '"""'


def doc_of(member):
    """Returns the docstring of a class, a function or a property, without the signature that pybind11
    adds to it."""
    first, _, rest = (member.__doc__ or "").strip().partition("\n")
    doc = (rest if "->" in first else f"{first}\n{rest}").strip()
    return doc if not doc or doc.endswith(".") else doc + "."


def with_docs(text):
    """Returns the text of the stubs with docstrings. Each class and each member that ends in an ellipsis gets its
    docstring from the module."""
    lines, owner, name = [], core, ""
    for line in text.splitlines():
        if found := re.match(r"class (\w+):", line):
            owner = getattr(core, found[1])
            line += "\n    " + quoted(doc_of(owner)) + "\n"
        elif re.match(r"\w", line):
            owner = core
        if found := re.match(r" *def (\w+)", line):
            name = found[1]
        ends = line.endswith(": ...") and not name.startswith("_") and hasattr(owner, name)
        if ends and (doc := doc_of(getattr(owner, name))):
            line = line[:-4] + "\n" + ("    " if owner is core else "        ") + quoted(doc)
        lines.append(line)
    return "\n".join(lines) + "\n"


def main():
    tables = core._catalogue()
    keys = core._keys()
    columns = [dict(entry, type="column") for entry in tables["contact.positions"] if not entry["of"]]
    contact = [entry for entry in tables["contact"] if entry["name"] != "positions"]
    text, *blocks = Path(__file__).with_name("core.pyi.in").read_text(encoding="utf-8").split("# block ")
    made = dict(block.split("\n", 1) for block in blocks)
    made["file members"] = "".join(made["file members"].replace("FILE", file)
                                   for file in ("step", "stl", "threemf", "glb", "dxf", "svg"))
    names = {entry["name"] for entry in tables["pair"]}
    of_racks = [dict(entry, always=False) for entry in tables["rack_pair"] if entry["name"] not in names]
    # Quantities that a pair of gears always has and a rack pair lacks, such as the shaft angle, may be None.
    racks = {entry["name"] for entry in tables["rack_pair"]}
    of_pairs = [dict(entry, always=entry["always"] and entry["name"] in racks) for entry in tables["pair"]]
    for name, entries in (("gear", tables["gear"]), ("pair", of_pairs + of_racks), ("contact", contact + columns),
                          ("rating", tables["rating"]), ("loaded", tables["load"])):
        made[f"{name} attributes"] = attributes(entries)
    for name in ("gear", "pair", "compensate", "scatter", "rating", "load", "contact"):
        made[f"{name} keywords"] = keywords(keys[name])
    made["gear keywords"] = "        units: str | None = ...,\n" + made["gear keywords"]
    made["sweep keywords"] = made["pair keywords"].replace("float | None", "ArrayLike")
    for mark, body in made.items():
        text, count = re.subn(rf"^ *# {mark}\n", lambda _, body=body: body, text, flags=re.M)
        assert count, f"core.pyi.in has no {mark}"
    text = with_docs(text.replace("# records\n", records_of(text, tables)))
    Path(sys.argv[1], "_core.pyi").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
