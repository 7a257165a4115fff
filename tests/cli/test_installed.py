"""Tests the content of the installation: program, completion, manual page and documents, but nothing that
was not built."""
import gzip
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from cli import new_folder

BUILD = pathlib.Path(os.environ["GW_BUILD"])
CMAKE = os.environ.get("GW_CMAKE", "cmake")


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.prefix = pathlib.Path(tempfile.mkdtemp(prefix="gearwright_installed_"))
        cls.ran = subprocess.run([CMAKE, "--install", BUILD, "--component", "runtime", "--prefix", cls.prefix],
                                 capture_output=True, text=True)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.prefix)

    def has(self, pattern):
        found = list(self.prefix.glob(pattern))
        self.assertEqual(len(found), 1, pattern + self.ran.stderr)
        return found[0]

    def test_everything_a_user_meets_is_there(self):
        self.assertEqual(self.ran.returncode, 0, self.ran.stderr)
        self.assertIn("complete -F", self.has("share/bash-completion/completions/gearwright").read_text())
        self.assertTrue(self.has("share/zsh/vendor-completions/_gearwright").read_text().startswith("#compdef"))
        self.assertIn("complete -c", self.has("share/fish/vendor_completions.d/gearwright.fish").read_text())
        self.assertIn(".TH GEARWRIGHT", gzip.decompress(self.has("share/man/man1/gearwright.1.gz").read_bytes()).decode())
        self.assertIn("Apache-2.0", self.has("share/doc/gearwright/copyright").read_text())
        self.assertIn("urgency", gzip.decompress(self.has("share/doc/gearwright/changelog.gz").read_bytes()).decode())
        self.has("share/doc/gearwright/examples/helical_pair.toml")
        self.has("share/gearwright/spec.schema.json")

    def test_the_program_writes_a_solid_where_it_was_installed(self):
        folder = new_folder()
        spec = self.has("share/doc/gearwright/examples/spur_pair.toml")
        p = subprocess.run([self.prefix / "bin/gearwright", "export", spec, "--gear", "1", "--step", folder / "a.step"],
                           capture_output=True, text=True)
        self.assertEqual([p.returncode, p.stderr], [0, ""])
        self.assertTrue((folder / "a.step").read_text().startswith("ISO-10303-21"))

    def test_what_was_not_built_is_not_asked_for(self):
        # `make demo` builds only the program, so the install script must not require other targets.
        script = (BUILD / "cmake_install.cmake").read_text()
        programs = [l for l in script.splitlines() if "TYPE EXECUTABLE" in l and "gearwright-mpi" in l]
        for line in programs:
            self.assertIn("OPTIONAL", line)


if __name__ == "__main__":
    unittest.main()
