#!/usr/bin/env python3
"""Compares a portable program with the native one, and runs the first commands of a user of its system.

    tests/dist/test_portable.py NATIVE PROGRAM [--under wine [--may-skip]] [--examples N]

1. For every verb and example, exit status and bytes of --json are the same, because all programs have the
   same elementary functions and the same vectors of Eigen. Verbs that take long are compared for one example.
   The script prints how many numbers differ, and by how many units in the last place (ulp).
2. For every example, `run` writes the same files with the same bytes.
3. The program handles names and titles in Unicode, CRLF, a byte order mark, UTF-16, batch, a missing
   file, folders that accept no file, and Ctrl-C.
4. The program needs no library beside it. The program for Windows has less than 12 MB.
"""
import argparse
import contextlib
import json
import math
import os
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile
import time

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
VERBS = "gear pair contact load measure rate identify fit drive outline".split()
LONG = {"scattered_pair": "scatter", "misaligned_pair": "compensate", "quiet_pair": "propose", "housing_search": "search"}


class Programs:
    def __init__(self, native, program, under):
        self.native = [str(pathlib.Path(native).resolve())]
        self.other = ([under] if under else []) + [str(pathlib.Path(program).resolve())]
        self.environment = dict(os.environ, WINEDEBUG="-all", LC_ALL="C.UTF-8")

    def run(self, command, *arguments, folder, stdin=None):
        # The script uses files instead of pipes, because background processes of Wine keep the ends
        # of a pipe open.
        with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            given.write(stdin or b"")
            given.seek(0)
            status = subprocess.run([*command, *map(str, arguments)], stdin=given, stdout=out, stderr=err, cwd=folder,
                                    timeout=600, env=self.environment).returncode
            out.seek(0)
            err.seek(0)
            return status, out.read(), err.read().decode(errors="replace")


class NoWine(Exception):
    """Wine does not run the commands of Windows itself."""


@contextlib.contextmanager
def fresh_prefix(programs):
    """Creates a new Windows for Wine. Its server runs until the end, so that a start of the
    program takes half a second. Raises NoWine if a command of Windows itself does not run there."""
    with tempfile.TemporaryDirectory(prefix="gearwright_wine_") as prefix:
        programs.environment.update(WINEPREFIX=prefix, WINEDLLOVERRIDES="mscoree,mshtml=", HOME=prefix)
        programs.environment.pop("DISPLAY", None)
        quiet = dict(env=programs.environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            subprocess.run(["wineboot", "--init"], check=True, timeout=300, **quiet)
            subprocess.run(["wine", "cmd", "/c", "exit 0"], check=True, timeout=60, **quiet)
        except (OSError, subprocess.SubprocessError) as error:
            raise NoWine(f"Wine does not start on this machine: {error}") from error
        subprocess.run(["wineserver", "-p"], **quiet)  # status 2: it runs already
        try:
            yield
        finally:
            subprocess.run(["wineserver", "-k"], **quiet)
            subprocess.run(["wineserver", "-w"], timeout=60, **quiet)


class Report:
    def __init__(self):
        self.passed, self.failed = 0, []

    def check(self, name, good, why=""):
        if good:
            self.passed += 1
        else:
            self.failed.append(name)
            print(f"FAILED {name}: {why}", flush=True)


def place(x):
    """Returns doubles as integers in the same order. Neighbours differ by 1, the unit in the
    last place."""
    bits = struct.unpack("<q", struct.pack("<d", x))[0]
    return bits if bits >= 0 else -(bits & 0x7FFFFFFFFFFFFFFF)


class Differences:
    """Compares the numbers of two answers. Counts them, and stores the ulp of each difference and the
    path of the greatest relative difference."""

    def __init__(self):
        self.values, self.ulps, self.greatest, self.where, self.broken = 0, [], 0.0, "", ""

    def compare(self, a, b, path=""):
        number = (int, float)
        if isinstance(a, dict) and isinstance(b, dict):
            if list(a) != list(b):
                self.broken = f"{path}: keys {sorted(set(a) ^ set(b)) or 'in another order'}"
                return
            for key in a:
                self.compare(a[key], b[key], f"{path}.{key}")
        elif isinstance(a, list) and isinstance(b, list):
            if len(a) != len(b):
                self.broken = f"{path}: {len(a)} and {len(b)} entries"
                return
            for i, (x, y) in enumerate(zip(a, b)):
                self.compare(x, y, f"{path}.{i}")
        elif isinstance(a, number) and isinstance(b, number) and not isinstance(a, bool) and not isinstance(b, bool):
            self.values += 1
            if a == b:
                return
            self.ulps.append(abs(place(float(a)) - place(float(b))))
            relative = abs(a - b) / max(abs(a), abs(b), 1.0)
            if relative > self.greatest:
                self.greatest, self.where = relative, path
        elif a != b and not (isinstance(a, str) and isinstance(b, str)):
            self.broken = f"{path}: {a} and {b}"  # messages may contain rounded numbers


def compare_answers(programs, report, examples, folder):
    total, answers, equal_bytes, shares = Differences(), 0, 0, []
    for example in examples:
        for verb in [*VERBS, *([LONG[example.stem]] if example.stem in LONG else [])]:
            status, text, _ = programs.run(programs.native, verb, example, "--json", folder=folder)
            other, other_text, errors = programs.run(programs.other, verb, example, "--json", folder=folder)
            name = f"{verb} {example.name}"
            if status != other:
                report.check(name, False, f"status {other}, native {status}: {errors[-300:]}")
                continue
            if status != 0:
                report.passed += 1
                continue
            one = Differences()
            one.compare(json.loads(text), json.loads(other_text))
            report.check(name, text == other_text, one.broken or f"{one.where} differs by {one.greatest:.3g}")
            answers, equal_bytes = answers + 1, equal_bytes + (text == other_text)
            total.values, total.ulps = total.values + one.values, total.ulps + one.ulps
            if one.greatest > total.greatest:
                total.greatest, total.where = one.greatest, f"{name}{one.where}"
            if one.ulps:
                shares.append(f"  {name}: {len(one.ulps)} of {one.values}, greatest {one.greatest:.1e} at {one.where}")
    print("\n".join(shares))
    below = [sum(u <= limit for u in total.ulps) for limit in (1, 4, 64)]
    print(f"answers {answers}, of which {equal_bytes} have the same bytes; numbers {total.values}, of which "
          f"{len(total.ulps)} differ: {below[0]} by 1 ulp, {below[1]} by at most 4, {below[2]} by at most 64; "
          f"greatest relative difference {total.greatest:.1e} ({total.where})", flush=True)


def compare_files(programs, report, examples, folder):
    kinds = {}
    for example in examples:
        ends = []
        for command, out in ((programs.native, "native"), (programs.other, "other")):
            status, _, errors = programs.run(command, "run", example, "--out", f"{example.stem}_{out}", folder=folder)
            ends.append(status)
        report.check(f"run {example.name}", ends[0] == ends[1], f"status {ends[1]}, native {ends[0]}: {errors[-300:]}")
        one, two = (pathlib.Path(folder, f"{example.stem}_{out}") for out in ("native", "other"))
        names = sorted(p.name for p in one.iterdir()) if one.exists() else []
        others = sorted(p.name for p in two.iterdir()) if two.exists() else []
        report.check(f"files of {example.name}", names == others, f"{others}, native {names}")
        for name in sorted(set(names) & set(others)):
            count = kinds.setdefault(pathlib.Path(name).suffix, [0, 0])
            same = (one / name).read_bytes() == (two / name).read_bytes()
            count[0] += 1
            count[1] += same
            report.check(f"{name} of {example.name}", same, "has other bytes")
    print("files with the same bytes: " + ", ".join(f"{k} {same} of {n}" for k, (n, same) in sorted(kinds.items())))


def needs_nothing(report, program):
    """Checks the dependencies: Windows itself has the DLLs below, and a program for Linux has
    neither a loader nor libraries."""
    if program.endswith(".exe"):
        text = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", program], capture_output=True, text=True, check=True).stdout
        needed = {line.split()[-1].lower() for line in text.splitlines() if "DLL Name:" in line}
        report.check("DLLs", needed <= {"kernel32.dll", "msvcrt.dll", "shell32.dll", "user32.dll", "advapi32.dll"}, needed)
    else:
        text = subprocess.run(["readelf", "-dlW", program], capture_output=True, text=True, check=True).stdout
        report.check("static", "INTERP" not in text and "NEEDED" not in text, text)
    size = pathlib.Path(program).stat().st_size
    report.check("below 12 MB", size < 12e6 or not program.endswith(".exe"), size)
    print(f"size {size / 1e6:.2f} MB")


def first_minutes(programs, report, windows, folder):
    spec = (SOURCE / "examples/spur_pair.toml").read_text()

    def run(*arguments, stdin=None):
        return programs.run(programs.other, *arguments, folder=folder, stdin=stdin)

    inside = pathlib.Path(folder, "Räder für Übung")
    inside.mkdir()
    title = next(line for line in spec.splitlines() if line.startswith("title"))
    (inside / "Zähne.toml").write_text(spec.replace(title, 'title = "Zahnräder 歯車"'), encoding="utf-8")
    status, _, errors = run("run", "Räder für Übung/Zähne.toml")
    page = inside / "Zähne_out/report.html"
    report.check("run in a folder with a Unicode name", status == 0 and page.exists(), errors)
    report.check("the title in the report", page.exists() and "歯車" in page.read_text(encoding="utf-8"))
    status, text, errors = run("pair", "Räder für Übung/Zähne.toml")
    report.check("a title in Unicode is printed", status == 0 and "歯車" in text.decode(), errors)
    for name, data, good in (("CRLF", spec.replace("\n", "\r\n").encode(), True),
                             ("a byte order mark", b"\xef\xbb\xbf" + spec.encode(), True),
                             ("both", b"\xef\xbb\xbf" + spec.replace("\n", "\r\n").encode(), True),
                             ("UTF-16", spec.encode("utf-16"), False)):
        pathlib.Path(folder, "saved.toml").write_bytes(data)
        status, _, errors = run("pair", "saved.toml")
        report.check(f"a spec with {name}", status == (0 if good else 1) and (good or "save it as UTF-8" in errors), errors)
    lines = b'{"gear1":{"teeth":20,"normal_module_mm":2}}\r\n{"gear1":{"teeth":2000000,"normal_module_mm":2}}\r\n'
    status, text, errors = run("batch", "gear", stdin=lines)
    answers = text.decode().splitlines()
    report.check("batch", len(answers) == 2 and '"error"' not in answers[0] and '"error"' in answers[1], text.decode() + errors)
    status, _, errors = run("pair", "no_such_file.toml")
    report.check("a missing file", status == 3 and "no_such_file.toml" in errors, errors)
    status, text, errors = run("pair", "-", stdin=spec.encode())
    report.check("a spec on standard input", status == 0, errors)
    status, text, errors = run("--help")
    report.check("help", status == 0 and b"\r" not in text, errors)
    # A folder that accepts no file, even for root on Linux: /proc, which Wine shows on drive Z.
    closed = "Z:\\proc\\gearwright_out" if windows else "/proc/gearwright_out"
    status, text, errors = run("run", SOURCE / "examples/spur_pair.toml", "--out", closed)
    report.check("a folder that cannot be made", status == 3 and closed in errors, f"{status} {errors}")
    status, text, errors = run("export", SOURCE / "examples/spur_pair.toml", "--stl", closed + ".stl")
    report.check("a file that cannot be written", status == 3 and closed in errors, f"{status} {errors}")
    wish = SOURCE / "examples/housing_search.toml"
    status, text, errors = run("search", wish, "--out", "found")
    report.check("a search with a folder", status == 0 and any(pathlib.Path(folder, "found").glob("*.parquet")),
                 f"{status} {errors} {os.listdir(pathlib.Path(folder, 'found')) if pathlib.Path(folder, 'found').exists() else ''}")
    status, text, errors = run("compensate", SOURCE / "examples/misaligned_pair.toml")
    report.check("compensate", status == 0, f"{status} {errors}")
    if windows:
        status, text, errors = run("export", "Räder für Übung\\Zähne.toml", "--stl", "Räder für Übung\\a.stl")
        report.check("paths with backslashes", status == 0 and (inside / "a.stl").exists(), errors)
        status, text, errors = run("run", SOURCE / "examples/spur_pair.toml", "--out", "o/p")
        report.check("paths are printed with backslashes", "o\\p\\report.html" in text.decode(), text.decode()[-500:])


def interrupted(programs, report, folder):
    """Stops a long search with Ctrl-C. Wine converts the signal to an event of the console."""
    pathlib.Path(folder, "long.toml").write_text('[search]\nratio = [1, 8]\nmodules_mm = "ISO54-I+II"\npinion_teeth = [20, 1070]\n')
    with tempfile.TemporaryFile() as err:
        process = subprocess.Popen([*programs.other, "search", "long.toml", "--out", "stopped"], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=err, cwd=folder, env=programs.environment)
        deadline = time.monotonic() + 60
        while not os.fstat(err.fileno()).st_size and time.monotonic() < deadline:
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        try:
            status = process.wait(timeout=60)
        except subprocess.TimeoutExpired:
            process.kill()
            status = None
        err.seek(0)
        errors = err.read().decode(errors="replace")
    report.check("Ctrl-C", status == 3 and "--resume continues the search" in errors, f"{status} {errors}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("native")
    parser.add_argument("program")
    parser.add_argument("--under", help="what runs the program: wine, qemu-aarch64-static")
    parser.add_argument("--may-skip", action="store_true", help="if Wine does not start, print the reason and end with 0")
    parser.add_argument("--examples", type=int, default=1000, help="only N examples, evenly spread over all")
    options = parser.parse_args()
    programs, report = Programs(options.native, options.program, options.under), Report()
    examples = sorted([*SOURCE.glob("examples/*.toml"), *SOURCE.glob("examples/drives/*.toml")])
    count = min(options.examples, len(examples))
    examples = [examples[i * len(examples) // count] for i in range(count)]
    needs_nothing(report, options.program)
    with contextlib.ExitStack() as stack:
        if options.under == "wine":
            try:
                stack.enter_context(fresh_prefix(programs))
            except NoWine as error:
                print(f"The program for Windows was built but not run. {error}")
                sys.exit(0 if options.may_skip and not report.failed else 1)
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        first_minutes(programs, report, options.program.endswith(".exe"), folder)
        interrupted(programs, report, folder)
        compare_answers(programs, report, examples, folder)
        compare_files(programs, report, examples, folder)
    print(f"{report.passed} passed, {len(report.failed)} failed")
    sys.exit(1 if report.failed else 0)


main()
