"""Writes what doxygen reads: every header and page of the list, translated, under one folder.

    prepare.py FOLDER FILE ...      FILE relative to the source folder, which is the working directory

Two pages are made on the way: theory.md leads to the theory pages in their order, and examples.md, if
there are programs in examples/cpp, shows each of them as it is. Prints doxygen's INPUT, the pages in the
order of the tree of contents.
"""

import sys
from pathlib import Path

from headers import header
from pages import page

THEORY = """# Theory {#theory}

Every equation has a number, such as \\[@ref eq_T2_1 "T2.1"\\], and the code cites it. Each page
names its sources, has a figure drawn by the engine itself, and says which function computes an equation
and which test proves it.

"""
EXAMPLES = """# Example programs {#examples}

The tests compile and run each of them.
"""


def main(folder, files):
    folder = Path(folder)

    def write(name, text):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")

    numbers = []
    for name in files:
        text = Path(name).read_text(encoding="utf-8")
        write(name, page(name, text, set(files)) if name.endswith(".md") else header(text))
        if name.startswith("docs/theory/"):
            numbers.append(Path(name).name[:2])
    write("theory.md", THEORY + "".join(f"- @subpage theory_{n}\n" for n in sorted(numbers)))
    programs = sorted(Path("examples/cpp").glob("*.cpp"))
    order = ["README.md", "docs/quickstart.md", "docs/spec.md", "theory.md", "docs", "CONTRIBUTING.md",
             "CHANGELOG.md", "gearwright"]
    if programs:
        order.insert(2, "examples.md")
        write("examples.md", EXAMPLES + "".join(
            f"\n## {p.name} {{#examples-{p.stem}}}\n\n```{{.cpp}}\n{p.read_text(encoding='utf-8')}```\n"
            for p in programs))
    print("INPUT =", *(f"{folder}/{name}" for name in order))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
