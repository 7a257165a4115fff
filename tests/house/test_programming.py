"""Tests that docs/programming.md shows every program of examples/cpp unchanged, that the C++ of README.md compiles,
and that CONTRIBUTING.md shows the code of a verb as it is.

    <!-- example: gear.cpp -->
    ```cpp
    ...
    ```
    <!-- end -->

    verbatim  a block is the file, letter for letter
    complete  every program has a block, and every block has a program
    length    a program has 20 to 60 lines, not counting its output
    verb      the parts of "A new verb" occur in job/verbs.cpp or job/analysis.cpp, apart from white space

If GW_WRITE_DOCS is set, the blocks are replaced. Each rule is first tested with a page that violates it,
so that a rule that no longer detects anything fails.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(os.environ.get("GW_SOURCE", Path(__file__).resolve().parents[2]))
PAGE = ROOT / "docs/programming.md"
VERB = re.compile(r"^## A new verb\n.*?^```cpp\n(.*?)^```", re.S | re.M)
BLOCK = re.compile(r"(<!-- example: (\S+) -->\n).*?(<!-- end -->)", re.S)
LINES = range(20, 61)


def written(page, programs):
    """Returns the page with every block replaced by its program. A block without a program is kept."""
    def block(found):
        text = programs.get(found.group(2))
        return found.group(0) if text is None else f"{found.group(1)}```cpp\n{text}```\n{found.group(3)}"
    return BLOCK.sub(block, page)


def check(page, programs):
    faults = []
    shown = [name for _, name, _ in BLOCK.findall(page)]
    for name in sorted(set(programs) - set(shown)):
        faults.append(f"{name}: docs/programming.md has no block <!-- example: {name} -->")
    for name in sorted(set(shown) - set(programs)):
        faults.append(f"{name}: is shown by docs/programming.md, but examples/cpp has no such program")
    if written(page, programs) != page:
        faults.append("docs/programming.md does not show the programs as they are: write it with GW_WRITE_DOCS=1")
    for name, text in sorted(programs.items()):
        program, _, printed = text.partition("\n/* prints\n")
        if not printed.endswith("*/\n"):
            faults.append(f"{name}: does not end with /* prints")
        if program.count("\n") not in LINES:
            faults.append(f"{name}: {program.count(chr(10))} lines; {LINES[0]} to {LINES[-1]} are the measure")
    return faults


def compiled(page):
    """Returns the messages of the compiler for the C++ of a page, as the statements of one function."""
    faults = []
    eigen = subprocess.run(["pkg-config", "--cflags", "eigen3"], capture_output=True, text=True, check=True).stdout.split()
    for block in re.findall(r"```cpp\n(.*?)```", page, re.S):
        lines = block.splitlines()
        heads = [line for line in lines if line.startswith(("#include", "using"))]
        body = [line for line in lines if line not in heads]
        program = "\n".join([*heads, "void readme() {", *body, "}", ""])
        command = [os.environ.get("GW_CXX", "c++"), "-std=c++20", "-fsyntax-only", f"-I{ROOT}", *eigen, "-x", "c++", "-"]
        run = subprocess.run(command, input=program, capture_output=True, text=True)
        faults += run.stderr.splitlines()[:5] if run.returncode else []
    return faults


def verb_faults(page, code):
    """Returns the parts of the verb of a page that are not in the code. Empty lines separate the parts."""
    def folded(text):
        return "".join(text.split())
    parts = VERB.search(page).group(1).split("\n\n")
    return [f"CONTRIBUTING.md: not in the code of the verbs: {p}" for p in parts if folded(p) not in folded(code)]


def self_test():
    text = "// An idea.\n" + "int x;\n" * 25 + "\n/* prints\n1\n*/\n"
    page = f"# P\n\n<!-- example: a.cpp -->\n```cpp\n{text}```\n<!-- end -->\n"
    assert check(page, {"a.cpp": text}) == [], check(page, {"a.cpp": text})
    assert written(page.replace("An idea", "x"), {"a.cpp": text}) == page
    for word, broken, programs in [
            ("as they are", page.replace("An idea", "Another"), {"a.cpp": text}),
            ("has no block", page, {"a.cpp": text, "b.cpp": text}),
            ("no such program", page, {}),
            ("does not end", page, {"a.cpp": text.replace("prints", "says")}),
            ("the measure", page, {"a.cpp": text.replace("int x;\n", "")})]:
        assert any(word in fault for fault in check(broken, programs)), f"blind to: {word}"
    verb = "## A new verb\n\n```cpp\nint run() {\n  return 1;\n}\n\n    {\"run\", run},\n```\n"
    assert verb_faults(verb, "int run() { return 1; }\nVerb k[] = {{\"run\", run},};") == []
    assert len(verb_faults(verb, "int run() { return 2; }")) == 2
    assert compiled("```cpp\nconst double x = nothing;\n```") and not compiled("```cpp\nint x = 1;\n```")


def main():
    self_test()
    programs = {p.name: p.read_text(encoding="utf-8") for p in (ROOT / "examples/cpp").glob("*.cpp")}
    assert len(programs) >= 12, f"only {len(programs)} programs in examples/cpp"
    page = PAGE.read_text(encoding="utf-8")
    if os.environ.get("GW_WRITE_DOCS"):
        page = written(page, programs)
        PAGE.write_text(page, encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert "```cpp" in readme
    contributing = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    verbs = "".join((ROOT / f"gearwright/job/{name}.cpp").read_text(encoding="utf-8") for name in ("verbs", "analysis"))
    faults = check(page, programs) + compiled(readme) + verb_faults(contributing, verbs)
    for fault in faults:
        print(fault)
    print(f"{len(programs)} programs, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
