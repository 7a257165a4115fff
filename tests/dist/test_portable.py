#!/usr/bin/env python3
"""Compares a portable program with the native one, and tries what users of its system do first.

    tests/dist/test_portable.py NATIVE PROGRAM [--under wine] [--examples N]

1. Every verb on every example: the same exit status, and every number of --json within kNear of the native one.
2. All files of `run`: the same names; how many have the same bytes is printed, not required.
3. Names and titles in Unicode, CRLF, a byte order mark, UTF-16 (refused), batch, a missing file, help.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
VERBS = "gear pair contact measure rate identify fit drive".split()
kNear = 1e-9  # relative: results of solvers whose last steps follow another C library's sin and atan


class Programs:
    def __init__(self, native, program, under):
        self.native = [str(pathlib.Path(native).resolve())]
        self.other = ([under] if under else []) + [str(pathlib.Path(program).resolve())]
        self.environment = dict(os.environ, WINEDEBUG="-all", LANG="C.UTF-8")

    def run(self, command, *arguments, folder, stdin=None):
        p = subprocess.run([*command, *map(str, arguments)], capture_output=True, cwd=folder, input=stdin,
                           timeout=300, env=self.environment)
        return p.returncode, p.stdout, p.stderr.decode(errors="replace")


class Report:
    def __init__(self):
        self.passed, self.failed = 0, []

    def check(self, name, good, why=""):
        if good:
            self.passed += 1
        else:
            self.failed.append(name)
            print(f"FAILED {name}: {why}", flush=True)


def differences(a, b, path=""):
    """(values, values that differ, greatest relative difference, first structural difference)"""
    if isinstance(a, dict) and isinstance(b, dict):
        if list(a) != list(b):
            return 0, 0, math.inf, f"{path}: keys {sorted(set(a) ^ set(b))}"
        parts = [differences(a[k], b[k], f"{path}.{k}") for k in a]
    elif isinstance(a, list) and isinstance(b, list):
        if len(a) != len(b):
            return 0, 0, math.inf, f"{path}: {len(a)} and {len(b)} entries"
        parts = [differences(x, y, f"{path}.{i}") for i, (x, y) in enumerate(zip(a, b))]
    elif isinstance(a, (int, float)) and isinstance(b, (int, float)) and not isinstance(a, bool):
        if a == b:
            return 1, 0, 0.0, ""
        return 1, 1, abs(a - b) / max(abs(a), abs(b), 1.0), path
    else:
        return (1, 0, 0.0, "") if a == b or isinstance(a, str) else (1, 1, math.inf, path)
    total = sum(p[0] for p in parts), sum(p[1] for p in parts)
    worst = max(parts, key=lambda p: p[2], default=(0, 0, 0.0, ""))
    return *total, worst[2], worst[3]


def compare_answers(programs, report, examples, folder):
    values = different = 0
    greatest = 0.0
    for example in examples:
        for verb in VERBS:
            status, text, _ = programs.run(programs.native, verb, example, "--json", folder=folder)
            other, other_text, errors = programs.run(programs.other, verb, example, "--json", folder=folder)
            name = f"{verb} {example.name}"
            if status != other:
                report.check(name, False, f"status {other}, native {status}: {errors[-300:]}")
                continue
            n, d, worst, where = differences(json.loads(text), json.loads(other_text))
            values, different, greatest = values + n, different + d, max(greatest, worst)
            report.check(name, worst <= kNear, f"{where} differs by {worst:.3g}")
    print(f"values {values}, of which {different} differ, at most by {greatest:.2g} relative")


def compare_files(programs, report, examples, folder):
    same = different = 0
    for example in examples:
        for command, out in ((programs.native, "native"), (programs.other, "other")):
            status, _, errors = programs.run(command, "run", example, "--out", f"{example.stem}_{out}", folder=folder)
            report.check(f"run {example.name} ({out})", status == 0, errors[-300:])
        one, two = (pathlib.Path(folder, f"{example.stem}_{out}") for out in ("native", "other"))
        names = sorted(p.name for p in one.iterdir()) if one.exists() else []
        report.check(f"files of {example.name}", two.exists() and names == sorted(p.name for p in two.iterdir()))
        for name in names:
            equal = (two / name).exists() and (one / name).read_bytes() == (two / name).read_bytes()
            same, different = same + equal, different + (not equal)
    print(f"files {same + different}, of which {same} have the same bytes")


def first_minutes(programs, report, windows, folder):
    spec = (SOURCE / "examples/spur_pair.toml").read_text()

    def run(*arguments, stdin=None):
        return programs.run(programs.other, *arguments, folder=folder, stdin=stdin)

    place = pathlib.Path(folder, "Räder für Übung")
    place.mkdir()
    (place / "Zähne.toml").write_text('title = "Zahnräder 歯車"\n' + spec, encoding="utf-8")
    status, _, errors = run("run", "Räder für Übung/Zähne.toml")
    report.check("run in a folder with a Unicode name", status == 0 and (place / "Zähne_out/report.html").exists(), errors)
    status, text, errors = run("pair", "Räder für Übung/Zähne.toml")
    report.check("a title in Unicode is printed", status == 0 and "歯車" in text.decode(), errors)
    for name, data, good in (("CRLF", spec.replace("\n", "\r\n").encode(), True),
                             ("a byte order mark", b"\xef\xbb\xbf" + spec.encode(), True),
                             ("UTF-16", spec.encode("utf-16"), False)):
        pathlib.Path(folder, "saved.toml").write_bytes(data)
        status, _, errors = run("pair", "saved.toml")
        report.check(f"a spec with {name}", status == (0 if good else 1) and (good or "UTF-8" in errors), errors)
    lines = b'{"gear1":{"teeth":20,"normal_module_mm":2}}\r\n{"gear1":{"teeth":2000000,"normal_module_mm":2}}\r\n'
    status, text, errors = run("batch", "gear", stdin=lines)
    answers = text.decode().splitlines()
    report.check("batch", len(answers) == 2 and "gears" in answers[0] and "error" in answers[1], errors)
    status, _, errors = run("pair", "no_such_file.toml")
    report.check("a missing file", status == 3 and "no_such_file.toml" in errors, errors)
    status, text, errors = run("pair", "-", stdin=spec.encode())
    report.check("a spec on standard input", status == 0, errors)
    status, text, errors = run("--help")
    report.check("help", status == 0 and b"\r" not in text, errors)
    if windows:
        status, text, errors = run("export", "Räder für Übung\\Zähne.toml", "--stl", "Räder für Übung\\a.stl")
        report.check("paths with backslashes", status == 0 and (place / "a.stl").exists(), errors)
        status, text, errors = run("run", str(SOURCE / "examples/spur_pair.toml"), "--out", "o/p")
        report.check("paths are printed with backslashes", "o\\p\\report.html" in text.decode(), text.decode()[-500:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("native")
    parser.add_argument("program")
    parser.add_argument("--under", help="what runs the program: wine, qemu-aarch64-static")
    parser.add_argument("--examples", type=int, default=1000, help="so many examples only")
    options = parser.parse_args()
    programs, report = Programs(options.native, options.program, options.under), Report()
    examples = sorted(SOURCE.glob("examples/*.toml"))[:options.examples]
    with tempfile.TemporaryDirectory() as folder:
        compare_answers(programs, report, examples, folder)
        compare_files(programs, report, examples[:6], folder)
        first_minutes(programs, report, options.program.endswith(".exe"), folder)
    print(f"{report.passed} passed, {len(report.failed)} failed")
    sys.exit(1 if report.failed else 0)


main()
