"""Tests the verb propose as a user calls it: the shortest spec, the table, --take, --csv, and errors."""

import csv
import json
import math
import tempfile
import unittest
from pathlib import Path

from cli import Run

PAIR = """
[gear1]
teeth = 25
normal_module_mm = 3
face_width_mm = 20
{gear1}
[gear2]
teeth = 43
{gear2}
[load]
positions = 8
slices = 8
accuracy = "draft"
{load}
"""


def propose(*options, gear1="", gear2="", load="torque_Nm = 100", verb="propose"):
    return Run(verb, PAIR.format(gear1=gear1, gear2=gear2, load=load), *options)


class Propose(unittest.TestCase):
    def test_the_table_and_each_spec(self):
        graded = "quality = 5"
        answer = propose("--json", gear1=graded)
        self.assertEqual(answer.status, 0, answer.err)
        found = answer.json["propose"]
        self.assertEqual(len(found["proposals"]), 10)
        self.assertEqual(found["proposals"][0]["profile"], "as_given")
        self.assertIn("verdict", answer.json)
        for number in (1, found["recommended"], 10):
            taken = propose("--take", str(number), gear1=graded)
            self.assertEqual(taken.status, 0, taken.err)
            if number > 1:
                self.assertIn(f"# Proposal {number} of `gearwright propose`", taken.out)
            torque = Run("load", taken.out, "--json").json["load"]["torques"][0]
            score = found["proposals"][number - 1]["under_load"][0]["score"]
            for key in ("peak_to_peak_arcsec", "max_pressure_MPa", "face_load_factor", "edge_carries"):
                self.assertEqual(score[key], torque[key], (number, key))
        best = found["proposals"][found["recommended"] - 1]["worst"]
        half_um = 0.5e-3 / (1.5 * 43 * math.cos(math.radians(20))) * 3600 * 180 / math.pi  # along the line of action
        self.assertLessEqual(best["peak_to_peak_arcsec"], found["proposals"][0]["worst"]["peak_to_peak_arcsec"] + half_um)
        self.assertGreaterEqual(found["proposals"][1]["peak_to_peak_without_load_arcsec"], 0)
        same = propose("--take", "2", "--json", gear1=graded)
        self.assertEqual(same.json, found["proposals"][1]["spec"])

    def test_the_report_of_run_shows_proposals_for_graded_gears(self):
        for gear1, shown in (("quality = 5", True), ("", False)):
            with tempfile.TemporaryDirectory() as folder:
                run = propose("--out", folder, gear1=gear1, verb="run")
                self.assertEqual(run.status, 0, run.err)
                page = (Path(folder) / "report.html").read_text()
            self.assertEqual("Proposed modifications</h2>" in page, shown)
            for figure in ("compared-te", "proposals-plot"):
                self.assertEqual(f'id="{figure}"' in page, shown, figure)

    def test_text_and_csv(self):
        text = propose()
        self.assertIn("* Recommended:", text.out)
        self.assertIn("long tip relief", text.out)
        self.assertNotRegex(text.out, r"[ \t]\n")
        rows = list(csv.DictReader(propose("--csv", load="torque_Nm = [50, 100]").out.splitlines()))
        found = propose("--json", load="torque_Nm = [50, 100]").json["propose"]["proposals"]
        self.assertEqual(len(rows), len(found))
        for row, proposal in zip(rows, found):
            self.assertEqual(row["profile"], proposal["profile"])
            for i, load in enumerate(proposal["under_load"]):
                self.assertEqual(float(row[f"under_load.{i + 1}.score.max_pressure_MPa"]), load["score"]["max_pressure_MPa"])
        self.assertEqual(float(rows[1]["gears.1.tip_relief_um"]), found[1]["gears"][0]["tip_relief_um"])
        self.assertNotIn("spec", rows[0])

    def test_errors(self):
        self.assertEqual(propose("--json", load="").json["error"]["key"], "load.torque_Nm")
        self.assertEqual(propose("--take", "9").status, 1)
        crossed = propose("--json", gear2="helix_angle_deg = 20\n[pair]\nshaft_angle_deg = 20")
        self.assertEqual(crossed.json["error"]["key"], "pair.shaft_angle_deg")
        self.assertIn("touch at points", crossed.json["error"]["message"])
        halves = propose("--json", gear1="helix_angle_deg = 20\ndouble_helical = { gap_mm = 6 }")
        self.assertEqual(halves.json["error"]["key"], "gear1.double_helical")
        flank = propose("--json", gear1="[gear1.modifications]\ntip_relief_um = -3")
        self.assertEqual(flank.json["error"]["key"], "gear1.modifications.tip_relief_um")


if __name__ == "__main__":
    unittest.main()
