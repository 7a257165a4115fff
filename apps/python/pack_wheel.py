"""Packs a staged package into a wheel, with the shared libraries that it needs.

    pack_wheel.py STAGE SOURCE VERSION INTO BUILT     BUILT is the package in the build folder

The tag names the oldest glibc for which two conditions hold (PEP 600). First, this glibc has the
symbols that the module and its libraries need. Second, every system with this glibc has a libstdc++
with the symbols that the module and its libraries need. The folder gearwright.libs contains fmt,
TBB and the other libraries, so the module itself needs only libraries on which a wheel may depend.
The wheel contains the list of these libraries (SPDX) with their licences.
"""

import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

# Libraries that every Linux system with support for manylinux wheels provides (PEP 600).
OF_THE_SYSTEM = {"linux-vdso.so.1", "libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "libz.so.1",
                 "libpthread.so.0", "libdl.so.2", "librt.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}

# The newest symbols of libstdc++ that a tag permits, and the glibc of that tag (manylinux-policy.json of auditwheel).
STANDARD_LIBRARIES = (((3, 4, 29), (2, 34)), ((3, 4, 30), (2, 35)), ((3, 4, 32), (2, 38)), ((3, 4, 33), (2, 39)))


def needed(library):
    listing = subprocess.run(["ldd", str(library)], capture_output=True, text=True, check=True).stdout
    return {name: path for name, path in re.findall(r"^\s*(\S+) => (\S+)", listing, re.M)}


def bundle(stage, built):
    """Copies the libraries that `built` needs, except system libraries, to the folder in which the staged module
    looks for them."""
    into = stage / "gearwright.libs"
    into.mkdir()
    for name, path in sorted(needed(built).items()):
        if name not in OF_THE_SYSTEM:
            shutil.copyfile(path, into / name)


def newest_glibc(libraries):
    """Returns the version of glibc for the tag, from the symbols that the libraries need."""
    text = "".join(subprocess.run(["readelf", "--wide", "--version-info", str(library)], capture_output=True, text=True,
                                  check=True).stdout for library in libraries)

    def newest(name):
        return max(tuple(map(int, version.split("."))) for version in re.findall(rf"Name: {name}_([0-9.]+)", text))

    standard = newest("GLIBCXX")
    of_standard = next((glibc for version, glibc in STANDARD_LIBRARIES if standard <= version), None)
    assert of_standard, f"no tag of a wheel permits GLIBCXX_{'.'.join(map(str, standard))}"
    return max(newest("GLIBC")[:2], of_standard)


def metadata(source, version):
    description = (source / "docs" / "python.md").read_text(encoding="utf-8")
    return ("Metadata-Version: 2.1\nName: gearwright\n"
            f"Version: {version}\n"
            "Summary: An exact engine for cylindrical gears\n"
            "Requires-Python: >=3.11\nRequires-Dist: numpy\n"
            "License-File: LICENSE\nDescription-Content-Type: text/markdown\n\n" + description)


def main():
    stage, source, into, built = (Path(sys.argv[i]) for i in (1, 2, 4, 5))
    version = sys.argv[3]
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    libc, _ = platform.libc_ver()
    assert libc == "glibc", f"there is no wheel tag for {libc}"
    module = next(built.glob("_core.*.so"))
    parts = stage.parent / "wheel_licences"
    shutil.rmtree(parts, ignore_errors=True)
    subprocess.run([sys.executable, source / "tools/sbom.py", version, "wheel", stage, stage, parts], check=True, cwd=source)
    bundle(stage, module)
    major, minor = newest_glibc([module, *(stage / "gearwright.libs").iterdir()])
    tag = f"{python}-{python}-manylinux_{major}_{minor}_{platform.machine()}"
    info = stage / f"gearwright-{version}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(metadata(source, version), encoding="utf-8")
    (info / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: gearwright\nRoot-Is-Purelib: false\n"
                                f"Tag: {tag}\n", encoding="utf-8")
    shutil.copytree(parts, info, dirs_exist_ok=True)
    shutil.copyfile(source / "LICENSE", info / "LICENSE")
    for old in into.glob("*.whl"):
        old.unlink()
    subprocess.run([sys.executable, "-m", "wheel", "pack", "--dest-dir", str(into), str(stage)], check=True)


if __name__ == "__main__":
    main()
