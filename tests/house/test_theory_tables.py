"""Tests that every equation of the theory pages has a function that computes it and a test that proves it.

The last sections of docs/theory/NN-*.md are `In the code and in the tests`, a table, and `Sources`. A row
of the table has three cells: labels, functions, tests.

    | [T2.1] | `involute`, [math/involute.hpp](../../gearwright/math/involute.hpp) | `Involute.known_values`, [...](...) |

A name belongs to the next link after it. Semicolons separate files.

    complete  every equation of the page has a row, and no row contains any other equation
    function  the file exists, and declares, defines or calls the function or type
    cited     one of the files of the row, or its neighbour (.hpp, .cpp), cites the label
    test      the .cpp contains TEST(Suite, name), the .py `def name`, the .json of golden values "name"
    page      every page has sources and shows its figure, docs/theory/images/NN-*.svg

If a function is renamed, the table must be changed too. The message contains the line. Each rule is first
tested with pages that violate it, so that a rule that no longer detects anything fails.
"""

import posixpath
import re
import sys
from pathlib import Path

from test_theory_labels import ROOT, citations, split_page

TABLE = "In the code and in the tests"
LINK = re.compile(r"\[([^\]]+)\]\(([^)]+)\)")
NAME = re.compile(r"`([^`]+)`")


def sections(text):
    """Returns {title without its number: (line, body)} of the sections of the second level."""
    parts = re.split(r"^## (?:\d+\.\d+ )?(.*)$", text, flags=re.M)
    found, line = {}, 1 + parts[0].count("\n")
    for title, body in zip(parts[1::2], parts[2::2]):
        found[title.strip()] = (line, body)
        line += body.count("\n")
    return found


def references(cell):
    """Returns every (name, linked file or None) of a cell."""
    found = []
    for part in cell.split(";"):
        link = LINK.search(part)
        names = NAME.findall(LINK.sub("", part)) or [""]
        found += [(name, link.group(2) if link else None) for name in names]
    return found


def without_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)


def declares(text, name):
    """Returns true if C++ declares, defines or calls `a::b`. Every part must occur, and the last part must
    be a function, a type or a named lambda."""
    code = without_comments(text)
    *scopes, last = (re.escape(part) for part in name.split("::"))
    if not all(re.search(rf"\b{scope}\b", code) for scope in scopes):
        return False
    return bool(re.search(rf"\b{last}\s*\(|\b(?:struct|class|using|auto) {last}\b", code))


def proves(path, text, name):
    if path.endswith(".py"):
        return bool(re.search(rf"^ *def {re.escape(name)}\(", text, re.M))
    if path.endswith(".json"):
        return f'"{name}"' in text
    suite, _, case = name.partition(".")
    return bool(re.search(rf"\bTEST(?:_F|_P)?\(\s*{re.escape(suite)},\s*{re.escape(case)}\s*\)", text))


def cites(path, label, read):
    stem = posixpath.splitext(path)[0]
    return any(label in {found for _, found in citations(text)}
               for text in (read(name) for name in {path, stem + ".hpp", stem + ".cpp"}) if text)


def check_row(where, page, cells, read):
    """Returns all faults of one row. read(path) returns the text of a project file, or None."""
    if len(cells) != 3:
        return [f"{where}: a row has three cells: equations, functions, tests"], []
    faults, files = [], set()
    labels = [label for _, label in citations(cells[0])]
    if not labels:
        faults.append(f"{where}: this row names no equation")
    for kind, cell, holds in (("function", cells[1], lambda path, text, name: declares(text, name)),
                              ("test", cells[2], proves)):
        for name, link in references(cell):
            row = f"{where}: {', '.join(labels)}"
            if not name or not link:
                faults.append(f"{row}: a {kind} is a name in `...` and the link of its file: {cell}")
                continue
            path = posixpath.normpath(posixpath.join(posixpath.dirname(page), link))
            text = read(path)
            if text is None:
                faults.append(f"{row}: there is no file {path}; if it was moved, say here where to")
            elif not holds(path, text, name):
                faults.append(f"{row}: {path} has no {kind} {name}; if it was renamed, say the new name here")
            if kind == "function" and text is not None:
                files.add(path)
    for label in labels:
        if files and not any(cites(path, label, read) for path in files):
            faults.append(f"{where}: no comment in {', '.join(sorted(files))} cites [{label}]; "
                          f"write the label where the code computes it, or name the right file here")
    return faults, labels


def check_page(page, text, read):
    faults, seen = [], set()
    found = sections(text)
    name = posixpath.splitext(posixpath.basename(page))[0]
    if f"(images/{name}.svg)" not in text or read(f"docs/theory/images/{name}.svg") is None:
        faults.append(f"{page}: no figure images/{name}.svg; docs/figures draws one for every page")
    if not found.get("Sources", (0, ""))[1].strip():
        faults.append(f"{page}: no section Sources; it says where each equation comes from")
    defined = [label for _, label in split_page(text)[0]]
    if defined and TABLE not in found:
        return faults + [f"{page}: no section '{TABLE}' for its {len(defined)} equations"]
    first, body = found.get(TABLE, (0, ""))
    for number, line in enumerate(body.splitlines(), first):
        if not line.startswith("| ") or line.startswith("| equation"):
            continue
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        more, labels = check_row(f"{page}:{number}", page, cells, read)
        faults += more
        for label in labels:
            if label not in defined:
                faults.append(f"{page}:{number}: [{label}] is no equation of this page")
        seen |= set(labels)
    for label in defined:
        if label not in seen:
            faults.append(f"{page}: [{label}] is in no row of '{TABLE}'")
    return faults


def self_test():
    page = "docs/theory/02-x.md"
    row = ("| [T2.1]…[T2.2] | `f`, `A::g`, [a.hpp](../../gearwright/a.hpp) | `Suite.case`, "
           "[a_test.cpp](../../gearwright/a_test.cpp); `test_it`, [t.py](../../tests/t.py); "
           "`gears.0.d`, [t.json](../../tests/t.json) |")
    sound = ("# 2\n![x](images/02-x.svg)\n```text\na = b   [T2.1]\nc = d   [T2.2]\n```\n"
             f"## 2.1 {TABLE}\n\n| equation | function | test |\n|---|---|---|\n{row}\n\n## 2.2 Sources\n\nOurs.\n")
    files = {"gearwright/a.hpp": "/// [T2.1]\ndouble f(double);\nstruct A { double g() const; };  // h()\n",
             "gearwright/a.cpp": "// [T2.2]\ndouble f(double) {}\n",
             "gearwright/a_test.cpp": "TEST_F(Suite, case) {}\n", "tests/t.py": "def test_it():\n    pass\n",
             "tests/t.json": '{"gears.0.d": 3}', "docs/theory/images/02-x.svg": "<svg/>"}
    assert check_page(page, sound, files.get) == [], check_page(page, sound, files.get)

    def expect(word, old, new, changed=()):
        assert old in sound
        faults = check_page(page, sound.replace(old, new), {**files, **dict(changed)}.get)
        assert any(word in fault for fault in faults), f"blind to: {word}: {faults}"

    expect("[T2.2] is in no row", "[T2.1]…[T2.2] |", "[T2.1] |")
    expect("[T2.3] is no equation", "[T2.1]…[T2.2] |", "[T2.1]…[T2.3] |")
    expect("names no equation", "[T2.1]…[T2.2] |", "the first |")
    expect("no function h", "`f`", "`h`")
    expect("no function B::g", "`A::g`", "`B::g`")
    expect("no file gearwright/b.hpp", "wright/a.hpp", "wright/b.hpp")
    expect("no test Suite.other", "Suite.case", "Suite.other")
    expect("no test test_other", "`test_it`", "`test_other`")
    expect("no test gears.1.d", "`gears.0.d`", "`gears.1.d`")
    expect("a function is a name", "`f`, `A::g`, ", "")
    expect("a test is a name", ", [t.py](../../tests/t.py)", "")
    expect("three cells", "`test_it`,", "`test_it` |")
    expect("cites [T2.2]", "Ours", "Ours", {"gearwright/a.cpp": "double f(double) {}\n"})
    expect("no section Sources", "Sources\n\nOurs.", "Sources\n")
    expect("no figure", "02-x.svg", "02-y.svg")
    expect("no figure", "Ours", "Ours", {"docs/theory/images/02-x.svg": None})
    expect("no section 'In the code", TABLE, "Elsewhere")
    where = check_page(page, sound.replace("`f`", "`h`"), files.get)[0]
    assert where.startswith(f"{page}:11: T2.1, T2.2"), where


def main():
    self_test()

    def read(name):
        path = ROOT / name
        return path.read_text(encoding="utf-8") if path.is_file() else None

    pages = sorted((ROOT / "docs/theory").glob("[0-9]*-*.md"))
    texts = {str(p.relative_to(ROOT)): p.read_text(encoding="utf-8") for p in pages}
    count = sum(len(split_page(text)[0]) for text in texts.values())
    assert len(texts) >= 10 and count >= 180, f"{len(texts)} pages, {count} equations: looked in the wrong place"
    faults = [fault for page, text in texts.items() for fault in check_page(page, text, read)]
    for fault in faults:
        print(fault)
    print(f"{len(texts)} pages, {count} equations, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
