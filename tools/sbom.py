#!/usr/bin/env python3
"""Writes the list of the libraries that a program contains or links (SPDX 2.3), and the licences of those contained.

    tools/sbom.py VERSION TARGET BUILD SOURCES INTO

BUILD contains gearwright.map, in which the linker lists the archives whose members are in the program, and SOURCES is
the folder that tools/portable_libraries.sh fetched. Without a map, BUILD is the root of a package, whose programs and
modules link shared libraries. The script writes INTO/gearwright.spdx.json and INTO/licences. It fails if a library is
not in the tables below. If TARGET begins with "wheel", the package contains the shared libraries that it links, except
those of every Linux system. If TARGET is "npm" or "page", BUILD is not read, because all libraries are linked into
WebAssembly; SOURCES of "page" is apps/web, with the packages of npm that the page contains. Versions are those of Debian's
packages or of npm. Licences are those that the file debian/copyright of a package gives for the linked files.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import time

# Archive: Debian source package, name of the library, licence of the files that are linked, home page
LINKED = {
    "libfmt.a": ("fmtlib", "fmt", "MIT", "https://fmt.dev"),
    "libz.a": ("zlib", "zlib", "Zlib", "https://zlib.net"),
    "libtbb.a": ("onetbb", "oneTBB", "Apache-2.0", "https://github.com/oneapi-src/oneTBB"),
    "libtbb12.a": ("onetbb", "oneTBB", "Apache-2.0", "https://github.com/oneapi-src/oneTBB"),
    "libhwy.a": ("highway", "Highway", "Apache-2.0", "https://github.com/google/highway"),
    "libzstd.a": ("libzstd", "Zstandard", "BSD-3-Clause", "https://facebook.github.io/zstd"),
    "libelementary.a": ("musl", "musl", "MIT", "https://musl.libc.org"),
    "libsqlite3.a": ("sqlite3", "SQLite", "blessing", "https://sqlite.org"),
}
# Debian source package of a shared library that only a .deb links: name of the library, licence, home page
SHARED = {
    "openmpi": ("Open MPI", "BSD-3-Clause", "https://www.open-mpi.org"),
    "tomlplusplus": ("toml++", "MIT", "https://marzer.github.io/tomlplusplus"),
}
# Debian package of headers: name of the library, licence, home page
HEADERS = {
    "libeigen3-dev": ("Eigen", "MPL-2.0", "https://eigen.tuxfamily.org"),
    "libboost1.74-dev": ("Boost", "BSL-1.0", "https://www.boost.org"),
    "nlohmann-json3-dev": ("JSON for Modern C++", "MIT", "https://github.com/nlohmann/json"),
    "libtomlplusplus-dev": ("toml++", "MIT", "https://marzer.github.io/tomlplusplus"),
    "libcli11-dev": ("CLI11", "BSD-3-Clause", "https://github.com/CLIUtils/CLI11"),
}
# The same for programs in WebAssembly, in which emscripten's libraries are those of the system.
WEB = (
    ("emscripten", "Emscripten", "MIT OR NCSA", "https://emscripten.org"),
    ("emscripten", "musl", "MIT", "https://musl.libc.org"),
    ("emscripten", "libc++ and compiler-rt", "Apache-2.0 WITH LLVM-exception", "https://llvm.org"),
    ("emscripten", "dlmalloc", "CC0-1.0", "https://gee.cs.oswego.edu/dl/html/malloc.html"),
    ("libfmt-dev", "fmt", "MIT", "https://fmt.dev"),
    ("libstb-dev", "stb", "MIT OR Unlicense", "https://github.com/nothings/stb"),
)
# Package of npm that the page contains: name of the library, licence, home page
PAGE = {
    "three": ("three.js", "MIT", "https://threejs.org"),
    "fzstd": ("fzstd", "MIT", "https://github.com/101arrowz/fzstd"),
}
# Beginning of the name of the Debian package of a runtime library of the compiler: name of the library,
# licence, home page
RUNTIME = {
    "libstdc++": ("libstdc++", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libgcc": ("libgcc", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "gcc-mingw": ("libgcc", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "g++-mingw": ("libstdc++", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org"),
    "libc6": ("GNU C Library", "LGPL-2.1-or-later", "https://www.gnu.org/software/libc"),
    "mingw-w64": ("MinGW-w64 runtime", "ZPL-2.1 AND MIT AND BSD-3-Clause", "https://www.mingw-w64.org"),
}


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def archives(build):
    """Returns the paths of the archives of which the program contains a member, from the first part of the map."""
    map_file = build / "gearwright.map"
    text = map_file.read_text(errors="replace").split("Memory Configuration")[0] if map_file.exists() else ""
    found = {(build / name).resolve() for name in re.findall(r"^(\S+\.a)\([^)]*\)", text, re.MULTILINE)}
    return sorted(path for path in found if path.name != "libgearwright.a")


def from_source(sources, package):
    found = list(sources.glob(f"{package}_*.dsc"))
    if len(found) != 1:
        sys.exit(f"sbom: {sources} has {len(found)} source packages {package}; expected one")
    lines = found[0].read_text(errors="replace").splitlines()
    version = next(line.split(":", 1)[1].strip() for line in lines if line.startswith("Version:"))
    return version, next(p for p in sources.glob(f"{package}-*") if p.is_dir()) / "debian/copyright"


def from_system(package):
    return output("dpkg-query", "-W", "-f", "${Version}", package), pathlib.Path("/usr/share/doc", package.split(":")[0], "copyright")


def package_of(path):
    """Returns the Debian package of a file, or "". Debian 12 lists files of /usr/lib with or without /usr."""
    for name in (str(path), str(path).removeprefix("/usr")):
        found = subprocess.run(["dpkg", "-S", name], capture_output=True, text=True).stdout
        if found:
            return found.split(": ")[0]
    return ""


def runtime(package):
    return next((v for k, v in RUNTIME.items() if package.startswith(k)), None)


def shared(root, contained):
    """Returns the shared libraries that files below root need, in the form of contents(). If `contained`, the package
    will contain them, except the runtime libraries and zlib, which every system has."""
    known = {package: about for package, *about in LINKED.values()} | SHARED
    files = [path for path in root.rglob("*") if path.is_file() and path.read_bytes()[:4] == b"\x7fELF"]
    found = {line for path in files for line in output("ldd", str(path)).splitlines()}
    direct = {name for path in files for name in re.findall(r"NEEDED.*\[(.*)\]", output("readelf", "-dW", str(path)))}
    for line in sorted(found):
        match = re.match(r"\s*(\S+) => (\S+)", line)
        if not match or match[1] not in direct:
            continue
        owner = package_of(pathlib.Path(match[2]).resolve())
        about = runtime(owner) or known.get(output("dpkg-query", "-W", "-f", "${source:Package}", owner))
        if about is None:
            sys.exit(f"sbom: a program links {match[2]} ({owner}), which tools/sbom.py lacks")
        name, licence, home = about
        version, text = from_system(owner)
        inside = contained and not runtime(owner) and match[1] != "libz.so.1"
        yield name, version, text if inside else None, licence, home, "CONTAINS" if inside else "DYNAMIC_LINK"


def elementary():
    """Returns the elementary functions of the native build (cmake/gw_elementary.cmake), in the form of contents()."""
    _, name, licence, home = LINKED["libelementary.a"]
    yield name, *from_system("musl-dev"), licence, home, "STATIC_LINK"


def from_npm(folder):
    """Returns what the page contains from npm, in the form of contents()."""
    versions = json.loads((folder / "package.json").read_text())["dependencies"]
    for package, version in versions.items():
        if package not in PAGE:
            sys.exit(f"sbom: the page contains {package}, which tools/sbom.py lacks")
        name, licence, home = PAGE[package]
        yield name, version, folder / "node_modules" / package / "LICENSE", licence, home, "CONTAINS"


def web(target, sources):
    """Returns what the page or the package of npm contains besides headers, in the form of contents()."""
    for package, name, licence, home in WEB:
        yield name, *from_system(package), licence, home, "STATIC_LINK"
    if target == "page":
        yield from from_npm(sources)


def native(target, build, sources):
    """Returns what a program or a package of this system contains besides headers, in the form of contents()."""
    if not (build / "gearwright.map").exists():
        linked = list(shared(build, target.startswith("wheel")))
        yield from linked
        if linked:  # a program or a module, not a library for other programs
            yield from elementary()
    for path in archives(build):
        if path.name == "libtomlplusplus.a":
            continue  # compiled from the headers below
        if path.name == "libelementary.a" and build.parent not in path.parents:
            yield from elementary()
            continue
        if path.name in LINKED and build.parent in path.parents:
            package, name, licence, home = LINKED[path.name]
            yield name, *from_source(sources, package), licence, home, "STATIC_LINK"
            continue
        owner = package_of(path)
        known = runtime(owner)
        if known is None:
            sys.exit(f"sbom: the program contains parts of {path} ({owner or 'not from a package'}), which is not in the tables of tools/sbom.py")
        name, licence, home = known
        yield name, *from_system(owner), licence, home, "STATIC_LINK"


def contents(target, build, sources):
    """Returns name, version, file with the licence (or None), licence, home page and SPDX relationship."""
    yield from web(target, sources) if target in ("npm", "page") else native(target, build, sources)
    for package, (name, licence, home) in HEADERS.items():
        yield name, *from_system(package), licence, home, "CONTAINS"


def entry(name, version, licence, home):
    return {"name": name, "SPDXID": "SPDXRef-" + "".join(c for c in name if c.isalnum()), "versionInfo": version,
            "downloadLocation": "NOASSERTION", "homepage": home, "filesAnalyzed": False,
            "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION"}


def licence_text(copyright_file, licence):
    """Returns the licence of a library and its authors. The file of Boost lists the authors of every file of Boost in
    45 000 lines. Programs need no copy of this list (BSL-1.0), so only the text of the licence is returned."""
    text = copyright_file.read_text(encoding="utf-8", errors="replace")
    return re.search(r"^License: BSL-1\.0\n(?: .*\n)+", text, re.M)[0] if licence == "BSL-1.0" else text


def seconds_of_sources():
    """Returns the date of the sources, that of CHANGELOG.md if they do not come from git."""
    try:
        return int(os.environ.get("SOURCE_DATE_EPOCH") or output("git", "log", "-1", "--format=%ct"))
    except (OSError, subprocess.CalledProcessError):
        return int((pathlib.Path(__file__).resolve().parent.parent / "CHANGELOG.md").stat().st_mtime)


def main():
    version, target, build, sources, into = sys.argv[1:3] + [pathlib.Path(p).resolve() for p in sys.argv[3:]]
    licences = into / "licences"
    licences.mkdir(parents=True, exist_ok=True)
    product = entry("gearwright", version, "Apache-2.0", "NOASSERTION")
    del product["homepage"]
    packages, relations, written = {}, [], set()
    for name, its_version, copyright_file, licence, home, relation in contents(target, build, sources):
        part = entry(name, its_version, licence, home)
        if part["SPDXID"] in packages:
            continue
        packages[part["SPDXID"]] = part
        relations.append({"spdxElementId": product["SPDXID"], "relationshipType": relation,
                          "relatedSpdxElement": part["SPDXID"]})
        if copyright_file and copyright_file not in written:
            written.add(copyright_file)
            file = licences / (part["SPDXID"].removeprefix("SPDXRef-") + ".txt")
            file.write_text(licence_text(copyright_file, licence), encoding="utf-8")
    date = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds_of_sources()))
    (into / "gearwright.spdx.json").write_text(json.dumps({
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"gearwright-{version}-{target}",
        "documentNamespace": f"https://gearwright.invalid/spdx/{version}/{target}",
        "creationInfo": {"created": date, "creators": ["Tool: tools/sbom.py"]},
        "packages": [product, *packages.values()],
        "relationships": [
            {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": product["SPDXID"]},
            *relations]}, indent=1, ensure_ascii=False) + "\n")


main()
