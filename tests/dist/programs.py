"""Runs the native program and another one with the same arguments, in a fresh Wine if the other is for Windows."""
import contextlib
import os
import pathlib
import subprocess
import tempfile

# A program that runs longer has stopped answering, s. QEMU needs about 20 times the time of the native program, and
# other programs may use the same processors.
LONGEST = 3600


class Programs:
    def __init__(self, native, program, under):
        self.native = [str(pathlib.Path(native).resolve())]
        self.other = ([under] if under else []) + [str(pathlib.Path(program).resolve())]
        self.environment = dict(os.environ, WINEDEBUG="-all", LC_ALL="C.UTF-8")

    def run(self, command, *arguments, folder, stdin=None):
        # The script uses files instead of pipes, because background processes of Wine keep the ends
        # of a pipe open.
        with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            given.write(stdin or b"")
            given.seek(0)
            status = subprocess.run([*command, *map(str, arguments)], stdin=given, stdout=out, stderr=err, cwd=folder,
                                    timeout=LONGEST, env=self.environment).returncode
            out.seek(0)
            err.seek(0)
            return status, out.read(), err.read().decode(errors="replace")


class NoWine(Exception):
    """Wine does not run the commands of Windows itself."""


@contextlib.contextmanager
def fresh_prefix(programs):
    """Creates a new Windows for Wine. Its server runs until the end, so that a start of the
    program takes half a second. Raises NoWine if a command of Windows itself does not run there."""
    with tempfile.TemporaryDirectory(prefix="gearwright_wine_") as prefix:
        programs.environment.update(WINEPREFIX=prefix, WINEDLLOVERRIDES="mscoree,mshtml=", HOME=prefix)
        programs.environment.pop("DISPLAY", None)
        quiet = dict(env=programs.environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            subprocess.run(["wineboot", "--init"], check=True, timeout=300, **quiet)
            subprocess.run(["wine", "cmd", "/c", "exit 0"], check=True, timeout=60, **quiet)
        except (OSError, subprocess.SubprocessError) as error:
            raise NoWine(f"Wine does not start on this machine: {error}") from error
        subprocess.run(["wineserver", "-p"], **quiet)  # status 2: it runs already
        try:
            yield
        finally:
            subprocess.run(["wineserver", "-k"], **quiet)
            subprocess.run(["wineserver", "-w"], timeout=60, **quiet)


class Report:
    def __init__(self):
        self.passed, self.failed = 0, []

    def check(self, name, good, why=""):
        if good:
            self.passed += 1
        else:
            self.failed.append(name)
            print(f"FAILED {name}: {why}", flush=True)
