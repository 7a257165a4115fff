#!/usr/bin/env python3
"""Compiles the program with clang++ and with g++ -O0, and compares both with the native one, which g++ -O2 makes.

    tests/dist/test_compilers.py NATIVE [--examples N] [--only clang|unoptimised]

For every verb and example, exit status and bytes of --json are the same, and so are all files of `run`: a compiler
may only choose instructions, because sums have a fixed order, products are not fused, and the elementary functions are
those of musl (tests/cli/test_elementary.py). The programs are in build/compilers.
"""
import argparse
import os
import subprocess
import sys
import tempfile

from comparing import SOURCE, compare_answers, compare_files, some_examples
from programs import Programs, Report

KINDS = {
    "clang": ("clang", "-DCMAKE_UNITY_BUILD=ON"),
    # The flags of the preset are those of the configuration Release.
    "unoptimised": ("release", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DNDEBUG"),
}


def build(kind):
    """Returns the path of the program, which is compiled if it is older than its sources."""
    preset, *options = KINDS[kind]
    folder = SOURCE / "build/compilers" / kind
    for command in (["cmake", "--preset", preset, "-B", folder, *options, "-DGEARWRIGHT_TESTS=OFF", "-DGEARWRIGHT_BENCH=OFF",
                     "-DGEARWRIGHT_PYTHON=OFF", "-DGEARWRIGHT_MPI=OFF"],
                    ["cmake", "--build", folder, "--target", "gearwright_cli"]):
        done = subprocess.run(command, cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            sys.exit(f"{done.stdout[-3000:]}\n{kind}: the program was not compiled")
    return folder / "gearwright"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("native")
    parser.add_argument("--examples", type=int, default=1000, help="only N examples, evenly spread over all")
    parser.add_argument("--only", choices=list(KINDS), help="only this program")
    options = parser.parse_args()
    report, examples = Report(), some_examples(options.examples)
    for kind in [options.only] if options.only else KINDS:
        print(f"{kind}:", flush=True)
        program = build(kind)
        done = subprocess.run([sys.executable, SOURCE / "tests/cli/test_elementary.py"], env=dict(os.environ, GW_BIN=str(program)),
                              stderr=subprocess.PIPE, text=True)
        report.check("elementary functions", done.returncode == 0, done.stderr[-500:])
        programs = Programs(options.native, program, None)
        with tempfile.TemporaryDirectory() as folder:
            compare_answers(programs, report, examples, folder)
            compare_files(programs, report, examples, folder)
    print(f"{report.passed} passed, {len(report.failed)} failed")
    sys.exit(1 if report.failed else 0)


main()
