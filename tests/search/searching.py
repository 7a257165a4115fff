"""Helpers for the tests of searches: specs, processes that run a search, and the files of a search."""
import json
import os
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from cli import BIN, SOURCE, Asked, Run, new_folder, raw  # noqa: E402,F401

FILES = ["best.csv", "report.html", "search.json", "search.parquet"]
# The regions follow from the theory alone, without further limits. Other tests check the default limits.
SMALL = {"ratio": [1.9, 2.1], "center_distance_mm": [99, 101], "modules_mm": [2, 2.5, 3], "pinion_teeth": [12, 40],
         "profile_shift": [-0.6, 1.0], "interference": "flag"}
# 4.2 million candidates, of which 3633 are feasible. The search takes one or two seconds.
WIDE = SMALL | {"modules_mm": "ISO54-I+II", "pinion_teeth": [12, 300], "helix_angle_deg": [8, 20], "helix_step_deg": 1}


def toml(value):
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, str):
        return f'"{value}"'
    return str(value).lower()


def spec(keys=SMALL, after="", **changed):
    """Returns the text of a [search]. A key that is changed to None is omitted."""
    table = {key: value for key, value in (keys | changed).items() if value is not None}
    return "[search]\n" + "".join(f"{key} = {toml(value)}\n" for key, value in table.items()) + after


def folder(text=None):
    """Returns a new folder, which is removed when the tests end. If a text is given, the folder contains
    it as case.toml."""
    path = new_folder()
    if text is not None:
        (path / "case.toml").write_text(text)
    return path


def search(text, *args):
    """Returns the member `search` of the JSON."""
    r = Run("search", text, "--json", *args, folder=folder())
    assert r.status == 0, f"{text}\n{r.err}"
    return r.json["search"]


def taken(text, rank):
    """Returns the result of the verb pair for the design with this rank."""
    r = Run("search", text, "--take", rank, folder=folder())
    assert r.status == 0, r.err
    pair = Run("pair", r.out, "--json", folder=r.folder, name="pair.toml")
    assert pair.status == 0, f"{r.out}\n{pair.err}"
    return pair.json


def contents(out):
    """Returns the contents of the four files of a finished search."""
    return {name: (pathlib.Path(out) / name).read_bytes() for name in FILES}


def chunks(out):
    """Returns the number of finished chunks."""
    return len(list(pathlib.Path(out).glob("chunks/*.chunk")))


def start(where, out, *args, program=(BIN,), **options):
    """Starts a search of case.toml in a new process."""
    return subprocess.Popen([*program, "search", "case.toml", "--out", str(out), *map(str, args)], cwd=where, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def end(process, seconds=120):
    """Waits for a process and returns its exit status, stdout and stderr. If it does not end in time, it
    is killed."""
    try:
        out, err = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.terminate()  # mpirun then ends its ranks
        time.sleep(5)
        process.kill()
        process.communicate()
        raise
    return process.returncode, out, err


def wait_until(true, seconds=60.0, every=0.005):
    """Waits until true() returns True. Returns False if this does not happen in time."""
    last = time.monotonic() + seconds
    while time.monotonic() < last:
        if true():
            return True
        time.sleep(every)
    return False


def duckdb(parquet, sql):
    """Returns the rows of an SQL query, which read_parquet.mjs prints."""
    p = subprocess.run([os.environ.get("GW_NODE") or "node", str(pathlib.Path(__file__).with_name("read_parquet.mjs")), str(parquet), sql],
                       capture_output=True, text=True, timeout=120)
    if p.returncode:
        raise RuntimeError(p.stderr)
    return json.loads(p.stdout)
