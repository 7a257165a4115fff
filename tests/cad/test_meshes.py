"""Tests mesh files with independent programs.

  test_meshes.py [FILE.stl FILE.glb FILE.3mf ...]

Without files, the program ($GW_BIN) writes pairs, each pair as one file and as one file for each gear: a
helical pair with a keyway, a gear with two teeth and the wheel that it cuts, a gear with one tooth and its
wheel, an internal gear cut by a pinion cutter, and double circular arcs.

  .stl  admesh: every edge is shared, no facet is degenerate, nothing is repaired, and there is one part for
        each gear
  .3mf  lib3mf 1.8 through lib3mf_read_test.cpp, and Python's zipfile
  .glb  check_meshes.mjs: the Khronos validator; manifold-3d for .stl and .3mf

A reader that is not installed is reported and skipped. Exit status 0: no errors; 1: errors; 77: no reader
is installed.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
HELICAL = """
title = "mesh files"
[gear1]
teeth = 17
normal_module_mm = 2.5
helix_angle_deg = 15
profile_shift = 0.3
face_width_mm = 25
[gear1.bore]
diameter_mm = 14
keyway_width_mm = 5
keyway_depth_mm = 2.3
[gear2]
teeth = 31
face_width_mm = 25
normal_module_mm = 2.5
helix_angle_deg = -15
"""
FILLETED = """
profile_shift = {x}
rack = {{ dedendum = 1.0, root_fillet_radius = 0 }}
root_fillet = {{ offset_mm = {offset} }}
tip_fillet = {{ radius_mm = {radius} }}
"""
TWO_TEETH = """
[gear1]
teeth = 2
normal_module_mm = 1.75
helix_angle_deg = 30
face_width_mm = 12
""" + FILLETED.format(x=0.7, offset=0.01, radius=0.332) + """
[gear2]
teeth = 60
face_width_mm = 6
cut_by = "gear1"
[gear2.bore]
diameter_mm = 20
"""
ONE_TOOTH = """
[gear1]
teeth = 1
normal_module_mm = 2
helix_angle_deg = -55
face_width_mm = 14
""" + FILLETED.format(x=0.75, offset=0.05, radius=0.5) + """
[gear2]
teeth = 30
face_width_mm = 6
cut_by = "gear1"
"""
RING = """
[gear1]
teeth = 18
normal_module_mm = 2
helix_angle_deg = 20
profile_shift = 0.3
face_width_mm = 10
[gear2]
teeth = -49
face_width_mm = 8
profile_shift = -0.3
tip_diameter_mm = 101.6
bore = { diameter_mm = 118 }
[gear2.cut_by]
teeth = 20
rack = { addendum = 1.25, tip_fillet_radius = 0.2 }
"""
DOUBLE_ARCS = """
[gear1]
teeth = 14
normal_module_mm = 2
helix_angle_deg = 20
face_width_mm = 10
rack = "GBT12759"
[gear2]
teeth = 27
normal_module_mm = 2
helix_angle_deg = -20
face_width_mm = 10
rack = "GBT12759"
bore = { diameter_mm = 20 }
"""
SPECS = {"helical": HELICAL, "two_teeth": TWO_TEETH, "one_tooth": ONE_TOOTH, "ring": RING, "double_arcs": DOUBLE_ARCS}

readers = 0
faults = []


def fault(file, message):
    faults.append(f"{file}: {message}")


def run(command, **options):
    # After the header of 80 bytes, admesh 0.98.4 prints bytes of its own memory, which are not always text.
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, errors="replace", **options)


def write_files(folder, text):
    folder.mkdir()
    spec = folder / "pair.toml"
    spec.write_text(text)
    files = []
    for gears in (["--gear", "1"], ["--gear", "2"], []):
        stem = "gear" + gears[1] if gears else "pair"
        made = [folder / f"{stem}.{kind}" for kind in ("stl", "glb", "3mf")]
        command = [os.environ["GW_BIN"], "export", spec, *gears]
        for file in made:
            command += ["--" + file.suffix[1:], file]
        result = run(command)
        if result.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))}\n{result.stderr}")
        files += made
    return files


def check_stl(files):
    global readers
    if not shutil.which("admesh"):
        print("admesh: not installed")
        return
    readers += 1
    # Values that admesh 0.98 prints before any repair. All of them must be 0.
    zero = ("Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed",
            "Facets added", "Facets reversed", "Backwards edges", "Normals fixed")
    for file in files:
        text = run(["admesh", file]).stdout
        print(f"{file.name}: admesh")
        for name in zero:
            found = re.search(rf"{name}\s*:\s*(\d+)", text)
            if not found or found[1] != "0":
                fault(file, f"admesh: {name} {found[1] if found else 'not printed'}")
        parts = re.search(r"Number of parts\s*:\s*(\d+)", text)
        volume = re.search(r"Volume\s*:\s*(-?[\d.]+)", text)
        expected = "2" if file.stem == "pair" else "1"
        if not parts or parts[1] != expected:
            fault(file, f"admesh: {parts[1] if parts else 'no'} parts, not {expected}")
        if not volume or float(volume[1]) <= 0:
            fault(file, "admesh: volume not positive")


def check_3mf(files, folder):
    global readers
    for file in files:
        bad = zipfile.ZipFile(file).testzip()
        if bad:
            fault(file, f"zip: {bad}")
    include = Path("/usr/include/lib3mf")
    compiler = os.environ.get("GW_CXX") or shutil.which("c++")
    if not include.is_dir() or not compiler:
        print("lib3mf: not installed")
        return
    reader = folder / "lib3mf_read_test"
    built = run([compiler, "-std=c++17", "-w", "-isystem", include, HERE / "lib3mf_read_test.cpp",
                 "-l3MF", "-o", reader])
    if built.returncode != 0:
        fault("lib3mf_read_test.cpp", built.stderr)
        return
    readers += 1
    result = run([reader, *files])
    print(result.stdout, end="")
    if result.returncode != 0:
        fault("lib3mf", result.stderr)


def check_by_node(files):
    global readers
    node = os.environ.get("GW_NODE") or shutil.which("node")
    if not node:
        print("node: not installed")
        return
    modules = os.environ.get("GW_NODE_MODULES")
    result = run([node, HERE / "check_meshes.mjs", *files, *(["--modules", modules] if modules else [])])
    print(result.stdout, end="")
    if result.returncode == 77:
        print(f"check_meshes.mjs: {result.stderr}", end="")
        return
    readers += 1
    if result.returncode != 0:
        fault("check_meshes.mjs", result.stderr)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = [Path(a) for a in sys.argv[1:]] or [
            file for name, text in SPECS.items() for file in write_files(folder / name, text)]
        by_kind = {kind: [f for f in files if f.suffix == kind] for kind in (".stl", ".3mf", ".glb")}
        if sum(map(len, by_kind.values())) != len(files):
            sys.exit("only .stl, .3mf and .glb files")
        if by_kind[".stl"]:
            check_stl(by_kind[".stl"])
        if by_kind[".3mf"]:
            check_3mf(by_kind[".3mf"], folder)
        check_by_node(files)
    for line in faults:
        print(line, file=sys.stderr)
    if faults:
        return 1
    return 0 if readers else 77


sys.exit(main())
