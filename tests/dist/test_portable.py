#!/usr/bin/env python3
"""Compares a portable program with the native one, and runs the first commands of a user of its system.

    tests/dist/test_portable.py NATIVE PROGRAM [--under wine [--may-skip]] [--examples N] [--zip ZIP]

1. For every verb and example, exit status and bytes of --json are the same, because all programs have the
   same elementary functions and the same vectors of Eigen. Verbs that take long are compared for one example.
   The script prints how many numbers differ, and by how many units in the last place (ulp).
   Tables for spreadsheets, the manual, the schemas, the completions and the answers of `verify` are the same, too.
2. For every example, `run` writes the same files with the same bytes.
3. The program handles names and titles in Unicode, CRLF, a byte order mark, UTF-16, batch, a
   missing file, folders that accept no file, full and read-only disks (if this system permits
   mounting them), a console, and Ctrl-C.

4. The zip contains the program with the page, and the first example of the quick start runs in it.
5. The program needs no library beside it. The program for Windows has less than 12 MB.
"""
import argparse
import contextlib
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from comparing import SOURCE, compare_answers, compare_files, compare_texts, some_examples
from programs import NoWine, Programs, Report, fresh_prefix
from surroundings import console, disks, may_mount, unpacked


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
    parser.add_argument("--zip", type=pathlib.Path, help="the packed folder of the program for Windows")
    parser.add_argument("--examples", type=int, default=1000, help="only N examples, evenly spread over all")
    options = parser.parse_args()
    programs, report = Programs(options.native, options.program, options.under), Report()
    examples = some_examples(options.examples)
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
        console(programs, report, folder, "Räder für Übung/Zähne.toml")
        if may_mount():
            disks(programs, report, folder, options.program.endswith(".exe"))
        else:
            print("full and read-only disks: not tested, because this system does not permit to mount them")
        if options.zip:
            unpacked(programs, report, options.zip, stack.enter_context(tempfile.TemporaryDirectory()))
        compare_texts(programs, report, examples, folder)
        compare_answers(programs, report, examples, folder)
        compare_files(programs, report, examples, folder)
    print(f"{report.passed} passed, {len(report.failed)} failed")
    sys.exit(1 if report.failed else 0)


main()
