"""Tests that long computations report their progress. On a signal, they end at once and leave no
incomplete files."""

import json
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from cli import BIN, SOURCE, Run

# A million positions with their contact pattern, or a map with a million points, would take hours or at least
# minutes.
POSITIONS = """
[contact]
positions = 100000
pitches = 10
pattern = true
"""
MAP = """
[contact]
positions = 64
[contact.map]
x = "crossing_deg"
x_range = [-0.05, 0.05]
y = "center_distance_mm"
y_range = [0, 0.2]
points = [1000, 1000]
"""
WITHIN = 1.0  # s, permitted time from the signal to the end


def pair():
    text = (SOURCE / "examples" / "misaligned_pair.toml").read_text()
    return text[:text.index("[contact]")]


class Stop(unittest.TestCase):
    def stopped(self, verb, spec, sent, *args):
        """Stops a program after its first progress line, and returns this line. The program must
        end within WITHIN seconds of the signal."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "case.toml"
            path.write_text(spec)
            command = [BIN, verb, str(path), *args]
            with open(Path(folder) / "out", "wb") as out, subprocess.Popen(
                    command, stdout=out, stderr=subprocess.PIPE, cwd=folder, text=True) as p:
                first = p.stderr.readline()
                start = time.monotonic()
                os.kill(p.pid, sent)
                rest = p.stderr.read()
                status = p.wait(30)
                took = time.monotonic() - start
            self.assertEqual(status, 3, rest)
            self.assertEqual((Path(folder) / "out").read_bytes(), b"")
            self.assertEqual(sorted(f.name for f in Path(folder).iterdir()), ["case.toml", "out"])
            self.assertIn("stopped; nothing was written", rest)
            self.assertLess(took, WITHIN)
            return first

    def test_a_million_positions(self):
        self.assertRegex(self.stopped("contact", pair() + POSITIONS, signal.SIGINT, "--json"), r"contact, 2 s: computing the positions, \d+ % done")

    def test_a_million_points_of_a_map(self):
        self.assertRegex(self.stopped("contact", pair() + MAP, signal.SIGTERM), r"contact, 2 s: computing the map of two errors, \d % done")

    def test_run_leaves_no_folder(self):
        self.assertIn("run, 2 s: ", self.stopped("run", pair() + MAP, signal.SIGTERM, "--json"))

    def test_run_of_a_drive_leaves_no_folder(self):
        drive = "[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\nnormal_module_mm = 2\ntorque_Nm = 5\n"
        self.assertIn("run, 2 s: ", self.stopped("run", drive + POSITIONS, signal.SIGINT, "--json"))

    def test_export_leaves_no_file(self):
        """A 3MF file of millions of triangles takes a minute. Regression: the signal itself ended the program, also while it
        wrote files."""
        drive = "[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\nnormal_module_mm = 20\nhelix_angle_deg = 20\n"
        for spec, tolerance in ((drive, "3e-3"), (pair(), "1e-4")):
            first = self.stopped("export", spec, signal.SIGINT, "--3mf", "a.3mf", "--mesh-tolerance", tolerance)
            self.assertIn("export, 2 s: making the files", first)

    def test_short_work_says_nothing(self):
        run = Run("contact", pair() + "[contact]\npositions = 8\n", "--json")
        self.assertEqual((run.status, run.err), (0, ""))

    def test_what_pair_refuses_is_marked_by_fit(self):
        """The verb fit marks each branch that the verb pair rejects, and gives the same message. A gear
        with two teeth has such branches."""
        wish = ("[gear1]\nteeth = 2\nnormal_module_mm = 2\nhelix_angle_deg = 20\n"
                "[gear2]\nteeth = 30\nnormal_module_mm = 2\nhelix_angle_deg = -20\n[pair]\ncenter_distance_mm = {}\n")
        marked = 0
        for distance in (29, 31, 34.1, 40, 52):
            branches = Run("fit", wish.format(distance), "--json").json.get("fit", {}).get("branches", [])
            for i, b in enumerate(branches):
                pair_run = Run("pair", json.dumps(b["spec"]), "--json", name="pair.json")
                self.assertEqual(pair_run.status, 1 if "refused" in b else 0, pair_run.err)
                if "refused" in b:
                    marked += 1
                    self.assertTrue(pair_run.err.strip().endswith(": " + b["refused"]), pair_run.err)
                    self.assertIn("rejected by `gearwright pair`: ", Run("fit", wish.format(distance)).out)
        self.assertGreater(marked, 0)


if __name__ == "__main__":
    unittest.main()
