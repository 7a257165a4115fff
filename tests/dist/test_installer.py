#!/usr/bin/env python3
"""Installs the program for Windows under Wine, runs it by its name, removes it, and compares the registry.

    tests/dist/test_installer.py SETUP.EXE

Laws: after the removal, the user's PATH is the same as before the installation, for any value of PATH.
Files that the user put into the folder still exist after a second installation and after the removal.
All installed files and entries are removed. A second installation restores a missing file.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

KEY = r"HKCU\Environment"
ENTRY = r"HKCU\Software\Microsoft\Windows\CurrentVersion\Uninstall\Gearwright"


class Windows:
    def __init__(self, prefix):
        self.drive = pathlib.Path(prefix) / "drive_c"
        self.environment = dict(os.environ, WINEPREFIX=prefix, WINEDEBUG="-all", WINEDLLOVERRIDES="mscoree,mshtml=",
                                LC_ALL="C.UTF-8")

    def run(self, *arguments):
        with tempfile.TemporaryFile() as out:
            status = subprocess.run(["wine", *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=out,
                                    stderr=subprocess.DEVNULL, timeout=300, env=self.environment).returncode
            out.seek(0)
            return status, out.read().decode(errors="replace")

    def path(self):
        """Returns the user's own PATH, or None if there is none."""
        status, text = self.run("reg", "query", KEY, "/v", "Path")
        if status != 0:
            return None
        return text.split("REG_EXPAND_SZ" if "REG_EXPAND_SZ" in text else "REG_SZ", 1)[1].strip()

    def set_path(self, value):
        if value is None:
            self.run("reg", "delete", KEY, "/v", "Path", "/f")
        else:
            self.run("reg", "add", KEY, "/v", "Path", "/t", "REG_EXPAND_SZ", "/d", value, "/f")

    def files(self, name):
        users = self.drive / "users"
        return sorted(p for p in users.rglob(name))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("setup")
    setup = pathlib.Path(parser.parse_args().setup).resolve()
    failed = []

    def check(name, good, why=""):
        print(f"{'ok    ' if good else 'FAILED'} {name} {'' if good else why}", flush=True)
        if not good:
            failed.append(name)

    prefix = tempfile.mkdtemp(prefix="gearwright_wine_")
    try:
        windows = Windows(prefix)
        subprocess.run(["wineboot", "--init"], check=True, timeout=300, env=windows.environment,
                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        long_path = ";".join(rf"C:\tools\number {i}" for i in range(100))
        for before in [None, r"C:\tools", r"C:\tools;%USERPROFILE%\bin", long_path]:
            name = "no PATH" if before is None else f"PATH of {len(before)} characters"
            windows.set_path(before)
            status, _ = windows.run(setup, "/S")
            programs = windows.files("gearwright.exe")
            check(f"{name}: installed", status == 0 and len(programs) == 1, f"status {status}, {programs}")
            if not programs:
                continue
            folder = programs[0].parent
            links = sorted(p.stem for p in windows.files("*.lnk") if p.parent.name == "Gearwright")
            wanted = ["Examples", "Gearwright console", "Gearwright page", "Uninstall"]
            check(f"{name}: start menu", links == wanted and (folder / "gearwright.html").exists(), links)
            after = windows.path()
            own = "C:" + str(folder).split("drive_c", 1)[1].replace("/", "\\")
            if before is long_path:
                check(f"{name}: unchanged", after == before, after)
            else:
                check(f"{name}: has the folder", after == (own if before is None else f"{before};{own}"), after)
            mine = [folder / "mine.toml", folder / "examples" / "mine.toml", folder / "docs" / "notes.txt"]
            for path in mine:
                path.write_text("mine")
            (folder / "docs" / "page.md").unlink()
            windows.run(setup, "/S")
            check(f"{name}: the same after a second installation", windows.path() == after, windows.path())
            check(f"{name}: a second installation keeps the user's files", all(path.exists() for path in mine))
            check(f"{name}: a second installation restores a missing file", (folder / "docs" / "page.md").exists())
            status, text = windows.run(folder / "gearwright.exe", "--version")
            check(f"{name}: runs", status == 0 and text.startswith("gearwright "), text[:200])
            if before is None:
                status, text = windows.run("cmd", "/c", f"set PATH={own}&& gearwright --version")
                check(f"{name}: runs by its name", "gearwright " in text, text[:200])
                status, text = windows.run("cmd", "/c", f"cd /d {own}&& gearwright run examples\\helical_pair.toml")
                report = "examples\\helical_pair_out\\report.html"
                check(f"{name}: the first example", report in text and (folder / report.replace("\\", "/")).exists(), text[-300:])
                shutil.rmtree(folder / "examples" / "helical_pair_out", ignore_errors=True)
            windows.run(folder / "uninstall.exe", "/S", f"_?={own}")
            check(f"{name}: PATH as before", windows.path() == before, windows.path())
            left = [p for p in folder.rglob("*") if p.is_file()]
            # With _?, the uninstaller runs in its folder and waits, so it cannot delete itself.
            check(f"{name}: only the user's files are left", set(left) - {folder / "uninstall.exe"} == set(mine), left)
            check(f"{name}: no link is left", not [p for p in windows.files("*.lnk") if p.parent.name == "Gearwright"])
            check(f"{name}: no entry is left", windows.run("reg", "query", ENTRY)[0] != 0)
            shutil.rmtree(folder, ignore_errors=True)
    finally:
        subprocess.run(["wineserver", "-k"], env=windows.environment, stderr=subprocess.DEVNULL)
        subprocess.run(["wineserver", "-w"], env=windows.environment, stderr=subprocess.DEVNULL, timeout=60)
        shutil.rmtree(prefix, ignore_errors=True)
    if failed:
        sys.exit(f"{len(failed)} checks failed")


if __name__ == "__main__":
    main()
