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

import numpy
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


def test_its_tag_is_true(wheel, tmp_path):
    """The tag is not newer than this system, and permits every symbol that a library of the wheel needs."""
    tag = re.match(r"gearwright-0\.1\.0-cp311-cp311-manylinux_2_(\d+)_", wheel.name)
    assert tag and int(tag[1]) <= int(platform.libc_ver()[1].split(".")[1])
    zipfile.ZipFile(wheel).extractall(tmp_path)
    permitted = {"GLIBC": (2, int(tag[1])), "GLIBCXX": (3, 4, 29 if int(tag[1]) < 35 else 30), "CXXABI": (1, 3, 13)}
    libraries = [path for path in tmp_path.rglob("*.so*") if path.is_file()]
    assert len(libraries) >= 5
    for library in libraries:
        text = subprocess.run(["readelf", "--wide", "--version-info", library], capture_output=True, text=True, check=True).stdout
        for name, version in re.findall(r"Name: (GLIBC|GLIBCXX|CXXABI)_([0-9.]+)", text):
            assert tuple(map(int, version.split("."))) <= permitted[name], f"{library.name} needs {name}_{version}"


def test_what_is_in_it(wheel):
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
    # The environment has no package of the system. NumPy, the only requirement, is a link to that of Debian, because the
    # test has no package index.
    subprocess.run([sys.executable, "-m", "venv", str(tmp_path / "env")], check=True)
    python = str(tmp_path / "env/bin/python")
    packages = next((tmp_path / "env/lib").glob("python3*/site-packages"))
    for path in pathlib.Path(numpy.__file__).parent.parent.glob("numpy*"):
        (packages / path.name).symlink_to(path)
    clean = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", str(wheel)], check=True, env=clean)
    run = subprocess.run([python, "-c", PROGRAM], check=True, env=clean, capture_output=True, text=True,
                         cwd=tmp_path)
    ratio, beside, occt = run.stdout.split(maxsplit=2)
    assert float(ratio) > 1 and int(beside) >= 4 and occt.strip() == "[]"
