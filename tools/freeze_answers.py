#!/usr/bin/env python3
"""Hashes all outputs of the program, to compare two builds before and after a change of the code.

    tools/freeze_answers.py build/release/gearwright before.txt [SPECS]
    … change the code, build …
    tools/freeze_answers.py build/release/gearwright after.txt [SPECS]
    diff before.txt after.txt

Each line contains the sha256 of one output, its exit status and its name. The outputs are those of every verb on
every example, as text, JSON and CSV, and on every spec of the fuzz corpus, as JSON, all files of `run` on the examples,
and all help texts. SPECS is a file with every spec that a test runs and its verb. tests/cli writes this file if the
environment variable GW_SPECS contains its name.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent
VERBS = "gear pair contact compensate propose load rate measure identify fit drive scatter search".split()
FORMATS = {"text": [], "json": ["--json"], "csv": ["--csv"]}
SLOW = {("compensate", "loaded_pair")}  # takes minutes


def outcome(binary, arguments, folder):
    """Returns the status and the output of one run, with the name of its folder replaced."""
    p = subprocess.run([binary, *arguments], capture_output=True, cwd=folder, timeout=600)
    # Progress depends on the clock.
    errors = re.sub(rb"gearwright: \w+, \d+ s: .*\n", b"", p.stderr)
    return p.returncode, (p.stdout + b"\0" + errors).replace(str(folder).encode(), b"FOLDER")


def line(name, status, data):
    return f"{hashlib.sha256(data).hexdigest()} {status} {name}"


def answers(binary, name, text, verb, formats):
    """Returns the outputs of one verb on one spec."""
    with tempfile.TemporaryDirectory() as folder:
        spec = pathlib.Path(folder, "case.toml")
        spec.write_bytes(text)
        return [line(f"{name} {verb} {form}", *outcome(binary, [verb, str(spec), *FORMATS[form]], folder))
                for form in formats]


def files(binary, example):
    """Returns the files of `run` on one example, and its drawings of a gear."""
    with tempfile.TemporaryDirectory() as folder:
        lines = []
        status, text = outcome(binary, ["run", str(example), "--out", "out"], folder)
        if status == 0:
            text = text.split(b"\0")[0]  # stderr contains the names of files that take long
        lines.append(line(f"{example.stem} run", status, text))
        for file in sorted(pathlib.Path(folder, "out").rglob("*")):
            if file.is_file():
                data = re.sub(rb"\d{4}-\d\d-\d\dT[\d:]+", b"DATE", file.read_bytes())
                lines.append(line(f"{example.stem} run {file.name}", 0, data))
        status, text = outcome(binary, ["outline", str(example), "--gear", "1", "--points", "9"], folder)
        return [*lines, line(f"{example.stem} outline", status, text)]


def help_texts(binary):
    verbs = [*VERBS, "run", "outline", "export", "verify", "schema", "batch"]
    asked = [["--help"], ["schema"], ["schema", "result"], *([v, "--help"] for v in verbs)]
    with tempfile.TemporaryDirectory() as folder:
        return [line(" ".join(a), *outcome(binary, a, folder)) for a in asked]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("binary", help="the program whose outputs are hashed")
    arguments.add_argument("out", help="the file for the list of hashes")
    arguments.add_argument("specs", nargs="?", help="specs of tests, as tests/cli writes them with GW_SPECS")
    given = arguments.parse_args()
    binary, out = os.path.abspath(given.binary), given.out
    jobs = [(help_texts, binary)]
    for example in sorted((SOURCE / "examples").glob("*.toml")):
        jobs.append((files, binary, example))
        for verb in VERBS:
            if (verb, example.stem) not in SLOW:
                jobs.append((answers, binary, example.stem, example.read_bytes(), verb, list(FORMATS)))
    for spec in sorted((SOURCE / "tests/fuzz/corpus/spec").glob("*.toml")):
        for verb in VERBS:
            jobs.append((answers, binary, "fuzz/" + spec.stem, spec.read_bytes(), verb, ["json"]))
    if given.specs:
        kept = {(k["verb"], k["text"]) for k in map(json.loads, open(given.specs))}
        for verb, text in sorted(kept):
            name = hashlib.sha256(text.encode()).hexdigest()[:12]
            if verb in VERBS:
                jobs.append((answers, binary, "test/" + name, text.encode(), verb, ["text", "json"]))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        done = [pool.submit(*job) for job in jobs]
        lines = [one for each in done for one in each.result()]
    pathlib.Path(out).write_text("\n".join(lines) + "\n")
    print(f"{len(lines)} outputs")


main()
