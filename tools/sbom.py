#!/usr/bin/env python3
"""Prints an SPDX 2.3 document of what a portable program contains.

    tools/sbom.py VERSION SOURCES > gearwright.spdx.json

SOURCES is the folder that tools/portable_libraries.sh fetched. Versions are those of Debian's packages; licences are
stated as in their debian/copyright, which was read for each.
"""
import json
import pathlib
import subprocess
import sys

# Debian source package: name of the library, licence of the files that are linked, home page
LINKED = {
    "fmtlib": ("fmt", "MIT", "https://fmt.dev"),
    "zlib": ("zlib", "Zlib", "https://zlib.net"),
    "onetbb": ("oneTBB", "Apache-2.0", "https://github.com/oneapi-src/oneTBB"),
    "nlopt": ("NLopt", "LGPL-2.1-or-later AND MIT", "https://nlopt.readthedocs.io"),
    "highway": ("Highway", "Apache-2.0", "https://github.com/google/highway"),
    "libzstd": ("Zstandard", "BSD-3-Clause", "https://facebook.github.io/zstd"),
    "sqlite3": ("SQLite", "blessing", "https://sqlite.org"),
}
# Debian package of headers, likewise
HEADERS = {
    "libeigen3-dev": ("Eigen", "MPL-2.0", "https://eigen.tuxfamily.org"),
    "libboost-dev": ("Boost", "BSL-1.0", "https://www.boost.org"),
    "nlohmann-json3-dev": ("JSON for Modern C++", "MIT", "https://github.com/nlohmann/json"),
    "libtomlplusplus-dev": ("toml++", "MIT", "https://marzer.github.io/tomlplusplus"),
    "libcli11-dev": ("CLI11", "BSD-3-Clause", "https://github.com/CLIUtils/CLI11"),
}


def source_version(sources, package):
    found = list(sources.glob(f"{package}_*.dsc"))
    if len(found) != 1:
        sys.exit(f"sbom: {sources} has {len(found)} source packages {package}; expected one")
    lines = found[0].read_text(errors="replace").splitlines()
    return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("Version:"))


def header_version(package):
    return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True,
                          check=True).stdout


def entry(name, version, licence, home):
    return {"name": name, "SPDXID": "SPDXRef-" + "".join(c for c in name if c.isalnum()), "versionInfo": version,
            "downloadLocation": "NOASSERTION", "homepage": home, "filesAnalyzed": False,
            "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION"}


def main():
    version, sources = sys.argv[1], pathlib.Path(sys.argv[2])
    product = entry("gearwright", version, "Apache-2.0", "NOASSERTION")
    del product["homepage"]
    parts = [entry(n, source_version(sources, p), l, h) for p, (n, l, h) in LINKED.items()]
    parts += [entry(n, header_version(p), l, h) for p, (n, l, h) in HEADERS.items()]
    date = subprocess.run(["git", "log", "-1", "--format=%cd", "--date=format-local:%Y-%m-%dT%H:%M:%SZ"],
                          capture_output=True, text=True, check=True, env={"TZ": "UTC", "PATH": "/usr/bin"}).stdout
    print(json.dumps({
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"gearwright-{version}", "documentNamespace": f"https://spdx.org/spdxdocs/gearwright-{version}",
        "creationInfo": {"created": date.strip(), "creators": ["Tool: tools/sbom.py"]},
        "packages": [product, *parts],
        "relationships": [
            {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-gearwright"},
            *({"spdxElementId": "SPDXRef-gearwright", "relationshipType": "STATIC_LINK",
               "relatedSpdxElement": part["SPDXID"]} for part in parts)]}, indent=1))


main()
