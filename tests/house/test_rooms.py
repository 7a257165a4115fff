"""Tests the includes between rooms, and the form of every source file.

The rows of rooms are read from CONTRIBUTING.md (the block marked `rooms`, highest first). Rules:

    room      a file of gearwright/ROOM includes only its own room and lower rows, not another room of its
              row; *_test.cpp may include every room; no file of gearwright/ includes apps/
    door      the only file in gearwright/ itself is gearwright.hpp, which is for programs. It may include
              every room except apps, and no room includes it
    store     the files of large searches include only base
    cycle     no header includes itself through others
    kernel    only the tests cad/step*_test.cpp and their reader use OCCT, whose headers end in .hxx
    relative  includes of project files start at the root
    opening   a header starts with a comment and contains #pragma once
    length    no source file is longer than 450 lines
    path      no source contains the name of a folder of a particular machine

Each rule is first tested with snippets that violate it, so that a rule that no longer detects anything
fails.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(os.environ.get("GW_SOURCE", Path(__file__).resolve().parents[2]))
MAX_LINES = 450
SOURCE = re.compile(r"(\.(cpp|hpp|py|mjs|js|ts|sh|cmake|in|toml)|CMakeLists\.txt|Makefile|run)$")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.M)
# Built from parts, so that this file does not break its own rule.
MACHINE_PATH = re.compile(r"(?<![\w.])/(?:work|root|home)/\w|\.\./(?:" + "sha" + "red)")
DOOR = "gearwright/gearwright.hpp"
KERNEL = re.compile(r"gearwright/cad/(step\w*_test\.cpp|testing/step_reader\.[ch]pp)$")
# The bootstrap script uses the home folder of root in a chroot of its own.
PATH_EXEMPT = {"tools/bootstrap_check.sh"}


def read_rows(contributing):
    """Returns the height of each room, 0 for the lowest."""
    block = re.search(r"```rooms\n(.*?)```", contributing, re.S)
    if block is None:
        raise SystemExit("CONTRIBUTING.md has no ```rooms block")
    rows = [line.split() for line in block.group(1).strip().splitlines()]
    return {room: height for height, row in enumerate(reversed(rows)) for room in row}


def own_room(path, rows):
    """Returns the room of a path: gearwright/ROOM/... or apps/...; None for tests and
    bench."""
    parts = path.split("/")
    if parts[0] == "apps":
        return "apps"
    if parts[0] == "gearwright" and len(parts) > 2:
        return parts[1]
    return None


def check_includes(path, text, rows):
    faults = []
    here = own_room(path, rows)
    if here is not None and here not in rows:
        return [f"{path}: room {here} is not in the picture of CONTRIBUTING.md"]
    is_test = path.endswith("_test.cpp") or path.startswith(("tests/", "bench/", "docs/", "examples/"))
    if path.startswith("gearwright/") and here is None and path != DOOR:
        return [f"{path}: lies in no room; only {DOOR} does"]
    for quote, target in INCLUDE.findall(text):
        if target == DOOR:
            if path.startswith(("gearwright/", "apps/")):
                faults.append(f"{path}: {DOOR} is for programs; include what is used")
            continue
        if target.startswith((".", "../")):
            faults.append(f'{path}: "{target}" does not start at the root')
            continue
        if target.endswith(".hxx") and not KERNEL.match(path):
            faults.append(f"{path}: {target} is of OCCT, which only reads STEP files in tests")
        there = own_room(target, rows)
        if there is None or not target.startswith(("gearwright/", "apps/")):
            if quote == '"' and path.startswith("gearwright/"):
                faults.append(f'{path}: "{target}" does not start at the root')
            continue
        if there not in rows:
            faults.append(f"{path}: includes {target} of an unknown room")
            continue
        if quote == "<":
            faults.append(f"{path}: our own <{target}> wants quotes")
        if here == "store" and there not in ("store", "base"):
            faults.append(f"{path}: store knows base only, not {target}")
        if path == DOOR:
            if there == "apps":
                faults.append(f"{path}: the door includes {target}")
        elif is_test:
            if there == "apps" and here not in (None, "apps"):
                faults.append(f"{path}: a test of a room includes {target}")
        elif there != here and rows[there] >= rows[here]:
            way = "beside" if rows[there] == rows[here] else "above"
            faults.append(f"{path}: room {here} includes {target}, {way} it")
    return faults


def check_form(path, text):
    faults = []
    lines = text.count("\n")
    if lines > MAX_LINES:
        faults.append(f"{path}: {lines} lines, {MAX_LINES} is the end")
    if path.endswith(".hpp"):
        if not re.match(r"//+ \w", text):
            faults.append(f"{path}: does not open with its idea")
        if not re.search(r"^#pragma once$", text, re.M):
            faults.append(f"{path}: no #pragma once")
    if path not in PATH_EXEMPT:
        for hit in MACHINE_PATH.finditer(text):
            line = text.count("\n", 0, hit.start()) + 1
            faults.append(f"{path}:{line}: names a folder of a machine: {hit.group(0)}")
    return faults


def find_cycles(graph):
    """Returns the cycles of the include graph {file: [files]}, each as a list of files that ends with
    its first file."""
    state, stack, cycles = {}, [], []

    def visit(node):
        state[node] = "open"
        stack.append(node)
        for target in graph.get(node, ()):
            if state.get(target) == "open":
                cycles.append(stack[stack.index(target):] + [target])
            elif target not in state:
                visit(target)
        stack.pop()
        state[node] = "done"

    for node in sorted(graph):
        if node not in state:
            visit(node)
    return cycles


def check_house(files, rows):
    """Returns all faults of {path: text}."""
    faults, graph = [], {}
    for path, text in sorted(files.items()):
        if path.endswith((".hpp", ".cpp")):
            faults += check_includes(path, text, rows)
            graph[path] = [t for _, t in INCLUDE.findall(text) if t in files]
        faults += check_form(path, text)
    faults += ["cycle: " + " -> ".join(cycle) for cycle in find_cycles(graph)]
    return faults


def self_test(rows):
    """Checks that every rule rejects the snippets that violate it and accepts valid ones."""
    head = "// An idea.\n#pragma once\n"

    def header(*targets):
        return head + "".join(f'#include "{t}"\n' for t in targets)

    far = "/" + "home/somebody/gear.toml"
    beside = "../" + "sha" + "red/x.json"
    broken = [
        ("above it", {"gearwright/math/a.hpp": header("gearwright/gear/b.hpp")}),
        ("beside it", {"gearwright/curve/a.hpp": header("gearwright/kinematics/b.hpp")}),
        ("beside it", {"gearwright/cad/a.cpp": header("gearwright/report/b.hpp")}),
        ("above it", {"gearwright/job/a.hpp": header("apps/cli/b.hpp")}),
        ("store knows base only", {"gearwright/store/a.hpp": header("gearwright/math/b.hpp")}),
        ("lies in no room", {"gearwright/a.hpp": head}),
        ("is for programs", {"gearwright/job/a.hpp": header(DOOR)}),
        ("the door includes", {DOOR: header("apps/cli/b.hpp")}),
        ("a test of a room", {"gearwright/job/a_test.cpp": header("apps/cli/b.hpp")}),
        ("is of OCCT", {"gearwright/cad/step.cpp": head + "#include <TopoDS.hxx>\n"}),
        ("not in the picture", {"gearwright/attic/a.hpp": head}),
        ("unknown room", {"gearwright/job/a.hpp": header("gearwright/attic/b.hpp")}),
        ("start at the root", {"gearwright/job/a.hpp": header("b.hpp")}),
        ("start at the root", {"gearwright/job/a.hpp": header("../math/b.hpp")}),
        ("wants quotes", {"gearwright/job/a.hpp": head + "#include <gearwright/math/b.hpp>\n"}),
        ("cycle", {"gearwright/math/a.hpp": header("gearwright/math/b.hpp"),
                   "gearwright/math/b.hpp": header("gearwright/math/a.hpp")}),
        ("does not open", {"gearwright/math/a.hpp": "#pragma once\n// An idea.\n"}),
        ("no #pragma", {"gearwright/math/a.hpp": "// An idea.\n"}),
        ("lines", {"gearwright/math/a.cpp": "\n" * (MAX_LINES + 1)}),
        ("a folder of a machine", {"tests/cli/test_a.py": f"open('{far}')\n"}),
        ("a folder of a machine", {"gearwright/math/a.cpp": f"// see {beside}\n"}),
    ]
    for expected, files in broken:
        faults = check_house(files, rows)
        assert any(expected in fault for fault in faults), f"blind to: {expected}: {files}"
    sound = {
        "gearwright/math/a.hpp": header("gearwright/base/angle.hpp", "gearwright/math/b.hpp"),
        "gearwright/math/b.hpp": header("gearwright/base/angle.hpp"),
        "gearwright/base/angle.hpp": head + "#include <cmath>\n#include <Eigen/Core>\n",
        "gearwright/math/a_test.cpp": header("gearwright/job/c.hpp", "gearwright/cad/step.hpp"),
        "gearwright/cad/step_a_test.cpp": head + "#include <TopoDS.hxx>\n",
        DOOR: header("gearwright/math/a.hpp", "gearwright/cad/step.hpp"),
        "examples/cpp/a.cpp": "#include <gearwright/gearwright.hpp>\n",
        "apps/cli/main.cpp": header("gearwright/cad/step.hpp", "apps/cli/table.hpp"),
        "tests/house/a.cpp": "// as ratio 1/work and framework/home are words\n" + "\n" * 400,
    }
    assert check_house(sound, rows) == [], check_house(sound, rows)


def source_files():
    """Returns the sources of the project. These are the files that git tracks or would track. Without
    git, they are all files except those of builds."""
    listed = subprocess.run(
        ["git", "-C", str(ROOT), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True)
    if listed.returncode == 0:
        names = listed.stdout.decode().split("\0")
    else:
        names = [str(p.relative_to(ROOT)) for p in ROOT.rglob("*")]
        names = [n for n in names if not re.search(r"^build/|_out/|node_modules/|^\.git/", n)]
    return {n: (ROOT / n).read_text(encoding="utf-8") for n in names
            if SOURCE.search(n) and (ROOT / n).is_file()}


def main():
    rows = read_rows((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    self_test(rows)
    files = source_files()
    ours = [n for n in files if n.startswith("gearwright/")]
    assert len(ours) >= 10, f"found only {len(ours)} files of gearwright/ under {ROOT}"
    faults = check_house(files, rows)
    for fault in faults:
        print(fault)
    print(f"{len(files)} source files, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
