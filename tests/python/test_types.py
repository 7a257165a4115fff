"""Tests the type stubs. Everything in them exists, and mypy reports no errors for them or for a program
that uses them."""

import ast
import os
import pathlib
import subprocess
import sys
import textwrap

import gearwright as gw

PACKAGE = pathlib.Path(gw.__file__).parent


def mypy(*files, cwd):
    # mypy reports no errors for packages on PYTHONPATH, so the stubs are found by MYPYPATH alone. Missing imports are
    # matplotlib and pandas, which have no types.
    env = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    options = ["--strict", "--no-incremental", "--ignore-missing-imports"]
    return subprocess.run([sys.executable, "-m", "mypy", *options, *map(str, files)], cwd=cwd, capture_output=True,
                          text=True, env={**env, "MYPYPATH": str(PACKAGE.parent)})


def test_stubs_say_what_is_there():
    tree = ast.parse((PACKAGE / "_core.pyi").read_text())
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and hasattr(gw._core, node.name):
            there = dir(getattr(gw._core, node.name))
            told = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            if node.name != "Record":
                own = {n for n in vars(getattr(gw._core, node.name)) if not n.startswith("_")}
                assert own <= told, (node.name, own - told)
            assert told - {"__getattr__"} <= set(there), (node.name, told - set(there))
        if isinstance(node, ast.FunctionDef):
            assert hasattr(gw._core, node.name), node.name


def test_mypy(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(textwrap.dedent("""
        import gearwright as gw

        pinion = gw.Gear(teeth=17, normal_module=2.5, helix_angle_deg=15)
        wheel = pinion.replace(teeth=43, helix_angle_deg=-15)
        pair = gw.Pair(pinion, wheel, center_distance=79)
        distance: float = pair.center_distance
        ratio: float | None = pair.gear_ratio  # None for a rack
        pair = gw.Pair(pinion, wheel, scatter={"samples": 8}, units="mm").replace(scatter={"samples": 9})
        pair = pair.replace(units="inch").replace(center_distance_in=3.1)
        known: bool = "tip_diameter_mm" in pinion and "peak_to_peak_arcsec" in pair.contact()
        keys: list[str] = list(pinion)
        shown: str = pair.figures[0]._repr_html_()
        gw.identify("gear.toml")
        gw.measure("pair.toml")
        gw.solve(gw.load_drive({"planetary": {"sun": 20}}), "drive")
        try:
            loaded: gw.Gear | gw.Pair = gw.load("pair.toml")
        except gw.SpecError as e:
            print(e.key, e.allowed)
    """))
    run = mypy(program, PACKAGE / "__init__.py", cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
    program.write_text("import gearwright as gw\ngw.Gear(teeth='x').tip_diameterr\n")
    run = mypy(program, cwd=tmp_path)
    assert "arg-type" in run.stdout and "attr-defined" in run.stdout, run.stdout
