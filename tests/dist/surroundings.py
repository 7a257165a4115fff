"""Tests a program in the surroundings of a user: a console, full disks and disks that cannot be
written, and the packed folder."""
import contextlib
import fcntl
import os
import pathlib
import pty
import re
import select
import struct
import subprocess
import tempfile
import termios
import time
import zipfile

from comparing import SOURCE


def shown_in_console(programs, folder, *arguments, seconds=60):
    """Runs the program in a console of 120 columns and returns its status and what the console shows. Wine draws
    its console into the terminal, with movements of the cursor, which are removed."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 60, 120, 0, 0))
    process = subprocess.Popen([*programs.other, *map(str, arguments)], stdin=theirs, stdout=theirs, stderr=theirs, cwd=folder,
                               env=dict(programs.environment, TERM="xterm"), start_new_session=True)
    os.close(theirs)
    shown, deadline = b"", time.monotonic() + seconds
    while time.monotonic() < deadline:
        if select.select([ours], [], [], 0.5)[0]:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # the other end is closed
                break
            shown += piece
        elif process.poll() is not None:
            break
    if process.poll() is None:
        process.kill()
    os.close(ours)
    text = re.sub(r"\x1b(\[[0-9;?]*[ -/]*[@-~]|\][^\x07]*\x07|[()][A-Z0-9]|[=>])", " ", shown.decode("utf-8", errors="replace"))
    return process.wait(), text


def console(programs, report, folder, spec):
    """The console shows words, symbols and titles in UTF-8."""
    status, text = shown_in_console(programs, folder, "pair", spec)
    report.check("a console: status", status == 0, status)
    for word in ("Zahnräder", "歯", "α_wt", "ε_γ", "°"):
        report.check(f"a console shows {word}", word in text, text[-2000:])


def may_mount():
    """Returns whether this system permits mounting a disk. Mounting requires root and more rights
    than some containers have."""
    with tempfile.TemporaryDirectory() as folder:
        if subprocess.run(["mount", "-t", "tmpfs", "tmpfs", folder], stderr=subprocess.DEVNULL).returncode:
            return False
        subprocess.run(["umount", folder], check=True)
        return True


@contextlib.contextmanager
def small_disk(folder, size, read_only=False):
    """Mounts a disk of `size` bytes."""
    folder.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder], check=True)
    try:
        if read_only:
            subprocess.run(["mount", "-o", "remount,ro", folder], check=True)
        yield folder
    finally:
        subprocess.run(["umount", folder], check=True)


def disks(programs, report, folder, windows):
    """If a disk is full or cannot be written, the program ends with status 3 and names the file. A
    file appears as a whole or not at all, and an older file remains unchanged."""
    spec = SOURCE / "examples/spur_pair.toml"
    wish = SOURCE / "examples/housing_search.toml"
    for kind, size, read_only in (("full", 65536, False), ("read-only", 1 << 20, True)):
        disk = pathlib.Path(folder, f"{kind}_disk")
        with small_disk(disk, size, read_only):
            for name, arguments in (("run", ("run", spec, "--out", f"{kind}_disk/o")),
                                    ("export", ("export", spec, "--step", f"{kind}_disk/pair.step")),
                                    ("search", ("search", wish, "--out", f"{kind}_disk/found"))):
                status, _, errors = programs.run(programs.other, *arguments, folder=folder)
                report.check(f"{name} to a {kind} disk", status == 3 and f"{kind}_disk" in errors, f"status {status}: {errors}")
                report.check(f"{name} to a {kind} disk: separators", not windows or f"{kind}_disk/" not in errors, errors)
                left = [path.name for path in disk.rglob("*") if ".part" in path.name]
                report.check(f"{name} to a {kind} disk leaves no part of a file", not left, left)
    old = pathlib.Path(folder, "old.step")
    old.write_text("old")
    old.chmod(0o444)  # on Windows, the attribute `read-only`
    status, _, errors = programs.run(programs.other, "export", spec, "--step", "old.step", folder=folder)
    whole = old.read_text() if status else old.read_text()[:12]
    report.check("a file that is marked as read-only", (status, whole) in ((3, "old"), (0, "ISO-10303-21")), f"{status} {errors}")
    report.check("no part of a file is left beside it", not list(pathlib.Path(folder).glob("*.part")))


def unpacked(programs, report, archive, folder):
    """Unpacks the zip and runs the first example in it by the name of the program, as a user does in a console."""
    with zipfile.ZipFile(archive) as zipped:
        zipped.extractall(folder)
    top = next(path for path in pathlib.Path(folder).iterdir() if path.name in archive.name and path.is_dir())
    names = {path.name for path in top.iterdir()}
    wanted = {"gearwright.exe", "gearwright.html", "README.md", "CHANGELOG.md", "LICENSE", "examples", "docs", "licences",
              "gearwright.spdx.json"}
    report.check("the zip has the program, the page, examples and documents", wanted <= names, wanted - names)
    licences = {path.name for path in top.glob("licences/page/licences/*.txt")}
    report.check("the zip has the licences of the page", {"threejs.txt", "fzstd.txt", "Emscripten.txt"} <= licences, licences)
    report.check("the zip has no DLL", not list(top.rglob("*.dll")), names)
    page = (top / "gearwright.html").read_text(encoding="utf-8")
    report.check("the page is one file", "<script src=" not in page and '<link rel="stylesheet"' not in page)
    status, text, errors = programs.run(["wine", "cmd", "/c"], r"gearwright run examples\helical_pair.toml", folder=top)
    shown = re.search(r"\S+report\.html", text.decode())
    report.check("the first example", status == 0 and shown is not None, errors + text.decode()[-500:])
    if shown:
        report.check("the path of the report has backslashes", "/" not in shown[0] and "\\" in shown[0], shown[0])
        status, text, errors = programs.run(["wine", "cmd", "/c"], f"dir {shown[0]}", folder=top)
        report.check("the report is where the path says", status == 0 and b"report.html" in text, text.decode(errors="replace"))
