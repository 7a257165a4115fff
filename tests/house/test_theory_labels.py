"""Tests that every equation cited by the code occurs in the theory pages exactly once.

An equation is a line inside a ``` block of docs/theory/NN-*.md that ends with its label, [TN.m] or
[TN.ma], where N is the number of the page. A label anywhere else is a citation, in gearwright/, apps/,
docs/ or examples. A range [T2.1]...[T2.4] (also with the one-character ellipsis) and a list [T2.1, T2.3]
cite every label in them.

    unique    no label is defined twice
    page      a label is on the page with its number
    cited     every citation has an equation
    used      the labels of a page have consecutive numbers 1, 2, ...

Each rule is first tested with pages that violate it, so that a rule that no longer detects anything fails.
"""

import os
import re
import sys
from pathlib import Path

ROOT = Path(os.environ.get("GW_SOURCE", Path(__file__).resolve().parents[2]))
LABEL = r"T(\d+)\.(\d+)([a-z]?)"
DEFINITION = re.compile(r"\[" + LABEL + r"\][ \t]*$")
BRACKET = re.compile(r"\[(T\d+\.\d+[a-z]?(?:, ?T\d+\.\d+[a-z]?)*)\]")
RANGE = re.compile(r"\[T(\d+)\.(\d+)\](?:…|\.\.\.| to )\[T(\d+)\.(\d+)\]")
SUFFIXES = {".hpp", ".cpp", ".md", ".toml", ".py"}


def split_page(text):
    """Returns the definitions [(line, label)] of a page, and the page without them."""
    found, rest, inside = [], [], False
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            inside = not inside
        hit = DEFINITION.search(line) if inside else None
        if hit:
            found.append((number, hit.group(0).strip()[1:-1]))
            line = line[: hit.start()]
        rest.append(line)
    return found, "\n".join(rest)


def citations(text):
    """Returns every (line, label) that a text cites."""
    found = []
    for hit in BRACKET.finditer(text):
        line = text.count("\n", 0, hit.start()) + 1
        found += [(line, label.strip()) for label in hit.group(1).split(",")]
    for hit in RANGE.finditer(text):
        line = text.count("\n", 0, hit.start()) + 1
        page, low, other, high = (int(g) for g in hit.groups())
        if page != other or low > high:
            found.append((line, f"{hit.group(0)} (a range that runs backward)"))
            continue
        found += [(line, f"T{page}.{m}") for m in range(low, high + 1)]
    return found


def check_labels(pages, texts):
    """Returns all faults. Pages and texts are {path: text}."""
    faults, where, texts = [], {}, dict(texts)
    numbers = {}
    for path, text in sorted(pages.items()):
        page = int(re.match(r"(\d+)-", path.rsplit("/", 1)[-1]).group(1))
        definitions, texts[path] = split_page(text)
        for line, label in definitions:
            if label in where:
                faults.append(f"{path}:{line}: [{label}] is defined a second time, first {where[label]}")
            where.setdefault(label, f"{path}:{line}")
            n, m, letter = re.fullmatch(LABEL, label).groups()
            if int(n) != page:
                faults.append(f"{path}:{line}: [{label}] stands on page {page}")
            if not letter:
                numbers.setdefault(page, set()).add(int(m))
    for page, found in sorted(numbers.items()):
        for m in sorted(set(range(1, max(found) + 1)) - found):
            faults.append(f"page {page}: [T{page}.{m}] is missing between others")
    for path, text in sorted(texts.items()):
        for line, label in citations(text):
            if label not in where:
                faults.append(f"{path}:{line}: [{label}] has no equation in docs/theory")
    return faults


def self_test():
    page = "# 2\n```text\na = b   [T2.1]\nc = d   [T2.2]\ne [T2.2a]\n```\nby [T2.1]\n"
    sound = {"docs/theory/02-x.md": page}
    code = {"gearwright/a.hpp": "/// [T2.1]…[T2.2], [T2.1, T2.2a]\n"}
    assert check_labels(sound, code) == [], check_labels(sound, code)

    def expect(word, pages, texts):
        faults = check_labels(pages, texts)
        assert any(word in fault for fault in faults), f"blind to: {word}: {faults}"

    expect("a second time", {"docs/theory/02-x.md": page + "```\nf [T2.1]\n```\n"}, {})
    expect("stands on page 3", {"docs/theory/03-x.md": page}, {})
    expect("[T2.3] has no equation", sound, {"gearwright/a.cpp": "// [T2.3]\n"})
    expect("[T2.4] has no equation", sound, {"gearwright/a.cpp": "// [T2.1]…[T2.4]\n"})
    expect("[T2.9] has no equation", sound, {"gearwright/a.cpp": "// see [T2.1, T2.9]\n"})
    expect("[T2.7] has no equation", {"docs/theory/02-x.md": page + "by [T2.7]\n"}, {})
    expect("runs backward", sound, {"gearwright/a.cpp": "// [T2.2]…[T2.1]\n"})
    expect("is missing between", {"docs/theory/02-x.md": page.replace("T2.1", "T2.3")}, {})
    # A label in running text does not define an equation.
    expect("has no equation", {"docs/theory/02-x.md": "by the law\n[T2.1]\n"}, {})


def main():
    self_test()
    pages = {str(p.relative_to(ROOT)): p.read_text(encoding="utf-8")
             for p in (ROOT / "docs/theory").glob("[0-9]*-*.md")}
    texts = {}
    for folder in ("gearwright", "apps", "docs", "examples", "tests", "bench"):
        for p in (ROOT / folder).rglob("*"):
            name = str(p.relative_to(ROOT))
            if p.suffix in SUFFIXES and name not in pages and p.name != Path(__file__).name:
                if "node_modules" not in name:
                    texts[name] = p.read_text(encoding="utf-8")
    # The page on notation explains labels but defines no equation.
    cited = sum(len(citations(t)) for n, t in texts.items() if n.startswith("gearwright/"))
    assert len(pages) >= 4 and cited >= 20, f"{len(pages)} pages, {cited} citations: looked in the wrong place"
    faults = check_labels(pages, texts)
    for fault in faults:
        print(fault)
    defined = sum(len(split_page(t)[0]) for t in pages.values())
    print(f"{defined} equations, {cited} citations in the code, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
