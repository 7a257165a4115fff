"""Tests the wheel. It is small and complete, does not contain OCCT, and can be installed offline into an
empty environment."""

import json
import os
import pathlib
import platform
import re
import subprocess
import sys
import zipfile

import pytest

BUILD, SOURCE = pathlib.Path(os.environ["GW_BUILD"]), pathlib.Path(os.environ["GW_SOURCE"])
PROGRAM = """
import sys, gearwright as gw
assert sys.prefix in gw.__file__, gw.__file__
pair = gw.Pair(gw.Gear(teeth=17, normal_module=2), gw.Gear(teeth=30, normal_module=2), center_distance=48)
libraries = {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line}
beside = {l for l in libraries if "gearwright.libs" in l}
print(pair.contact_ratio, len(beside), [l for l in libraries if "libTK" in l])
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    stage = folder / "stage"
    subprocess.run([os.environ["GW_CMAKE"], "--install", str(BUILD), "--component", "python", "--strip", "--prefix",
                    str(stage)], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([sys.executable, str(SOURCE / "apps/python/pack_wheel.py"), str(stage), str(SOURCE), "0.1.0",
                    str(folder), str(BUILD / "python" / "gearwright")], check=True)
    return next(folder.glob("*.whl"))


def test_what_is_in_it(wheel):
    tag = re.match(r"gearwright-0\.1\.0-cp311-cp311-manylinux_2_(\d+)_", wheel.name)
    assert tag and int(tag[1]) <= int(platform.libc_ver()[1].split(".")[1])
    assert wheel.stat().st_size < 6e6
    names = zipfile.ZipFile(wheel).namelist()
    assert {"gearwright/__init__.py", "gearwright/_core.pyi", "gearwright/py.typed"} <= set(names)
    assert not [n for n in names if "libTK" in n or "__pycache__" in n]
    assert [n for n in names if n.startswith("gearwright.libs/libtbb")]
    folder = "gearwright-0.1.0.dist-info/"
    sbom = json.loads(zipfile.ZipFile(wheel).read(folder + "gearwright.spdx.json"))
    licences = {pathlib.Path(n).stem for n in names if n.startswith(folder + "licences/")}
    assert {"oneTBB", "fmt"} <= licences & {p["name"] for p in sbom["packages"]}


def test_pip_installs_it_without_an_index(wheel, tmp_path):
    # NumPy is the only requirement. The version of Debian is used, because the test has no package index.
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", str(tmp_path / "env")], check=True)
    python = str(tmp_path / "env/bin/python")
    clean = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", str(wheel)], check=True, env=clean)
    run = subprocess.run([python, "-c", PROGRAM], check=True, env=clean, capture_output=True, text=True,
                         cwd=tmp_path)
    ratio, beside, occt = run.stdout.split(maxsplit=2)
    assert float(ratio) > 1 and int(beside) >= 4 and occt.strip() == "[]"
