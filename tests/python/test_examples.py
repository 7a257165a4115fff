"""Tests that the examples run if their libraries are installed. The head of each example states whether
the tests run it."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

from common import SOURCE

EXAMPLES = sorted((SOURCE / "examples/python").glob("*.py"))
PACKAGE = os.environ["PYTHONPATH"].split(os.pathsep)[0]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda p: p.stem)
def test_example(path, tmp_path):
    text = path.read_text(encoding="utf-8")
    compile(text, path, "exec")
    said = re.search(r'"""(.*?)"""', text, re.S).group(1)
    (tmp_path / "examples").symlink_to(SOURCE / "examples")
    command = [sys.executable, str(path)]
    if "Not run by the tests" in said:
        pytest.skip("Debian does not contain its library")
    if "freecadcmd" in said:
        if not shutil.which("freecadcmd"):
            pytest.skip("FreeCAD is not installed")
        command = ["freecadcmd", str(path)]
    else:
        assert "Run by the tests" in said
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300,
                         env={**os.environ, "PYTHONPATH": PACKAGE})
    assert run.returncode == 0 and run.stdout.strip(), run.stderr


def test_no_example_is_forgotten():
    assert {"with_build123d", "with_cadquery", "with_freecad", "with_trimesh", "with_pyvista"} <= {
        pathlib.Path(p).stem for p in EXAMPLES}
