"""Runs the program in a new folder. All tests of the command line use this module."""
import atexit
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

BIN = os.environ["GW_BIN"]
SOURCE = pathlib.Path(os.environ["GW_SOURCE"])
# File to which each run appends its spec and result. tests/schema checks these specs with an independent
# validator.
SPECS = pathlib.Path(os.environ["GW_SPECS"]) if "GW_SPECS" in os.environ else None
if SPECS:
    SPECS.parent.mkdir(parents=True, exist_ok=True)
    SPECS.write_text("")

PAIR = """
title = "helical pair"
[gear1]
teeth = 17
normal_module_mm = 2.5
helix_angle_deg = 15
profile_shift = 0.3
face_width_mm = 25
[gear2]
teeth = 43
normal_module_mm = 2.5
helix_angle_deg = -15
profile_shift = 0.1
face_width_mm = 25
"""


def new_folder():
    """Returns an empty folder, which is removed when the tests end."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="gearwright_"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def keep(verb, name, text, status, message):
    """Appends a spec and its result to the file for tests/schema. Specs of users are shorter than 64 kB."""
    if SPECS and len(text) <= 1 << 16:
        kept = {"verb": verb, "name": name, "text": text, "status": status, "message": message}
        with SPECS.open("a") as file:
            file.write(json.dumps(kept) + "\n")


class Run:
    """One run of the program: exit status, stdout, stderr, the parsed JSON or None, and the folder of the
    run."""

    def __init__(self, verb, spec=PAIR, *args, name="case.toml", folder=None, stdout=subprocess.PIPE):
        self.folder = pathlib.Path(folder or new_folder())
        self.spec = self.folder / name
        if isinstance(spec, bytes):
            self.spec.write_bytes(spec)
        elif spec is not None:
            self.spec.write_text(spec)
        command = [BIN, verb, str(self.spec), *map(str, args)]
        p = subprocess.run(command, stdout=stdout, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                           timeout=120)
        self.status, self.out, self.err = p.returncode, p.stdout or "", p.stderr
        try:
            self.json = json.loads(self.out)
        except ValueError:
            self.json = None
        if self.spec.is_file():
            keep(verb, self.spec.name, self.spec.read_bytes().decode(errors="replace"), self.status, self.err)

    def files(self):
        """Returns the files of the run, except for the list of files that the verb run writes."""
        files = (f for f in self.folder.rglob("*") if f.is_file() and f.name != ".gearwright_files")
        return sorted(str(f.relative_to(self.folder)) for f in files)


def batch(verb, specs):
    """Returns the JSON of each spec, a dict. All specs are solved in one process."""
    lines = [json.dumps(spec) for spec in specs]
    p = subprocess.run([BIN, "batch", verb], input="".join(line + "\n" for line in lines), capture_output=True, text=True,
                       timeout=120)
    answers = [json.loads(line) for line in p.stdout.splitlines()]
    assert len(answers) == len(specs), p.stderr
    for line, answer in zip(lines, answers):
        message = answer["error"]["message"] + "\n" if "error" in answer else ""
        keep(verb, "case.json", line, int("error" in answer), message)
    return answers


def raw(*args):
    return subprocess.run([BIN, *args], capture_output=True, text=True, timeout=120)


class Asked(unittest.TestCase):
    """Runs the program and checks that it returns a result, or an error that contains the key and leaves
    no file."""

    def ok(self, verb, spec, *args):
        r = Run(verb, spec, "--json", *args)
        self.assertEqual(r.status, 0, f"{spec}\n{r.err}")
        return r.json

    def refused(self, spec, key, *words, verb="pair"):
        r = Run(verb, spec, "--json")
        self.assertEqual(r.status, 1, f"{spec}\n{r.out}")
        self.assertEqual(r.json["error"]["key"], key, r.err)
        for word in words:
            self.assertIn(word, r.json["error"]["message"])
        self.assertEqual(r.files(), ["case.toml"])
        return r.json["error"]["message"]
