"""Tests the verb propose as a user calls it: the shortest spec, the table, --take, --csv, and errors."""

import json
import unittest

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
                self.assertIn(f"# Proposal {number} of the verb propose", taken.out)
            torque = Run("load", taken.out, "--json").json["load"]["torques"][0]
            score = found["proposals"][number - 1]["under_load"][0]["score"]
            for key in ("peak_to_peak_arcsec", "max_pressure_MPa", "face_load_factor", "edge_carries"):
                self.assertEqual(score[key], torque[key], (number, key))
        best = found["proposals"][found["recommended"] - 1]["worst"]
        self.assertLessEqual(best["peak_to_peak_arcsec"], found["proposals"][0]["worst"]["peak_to_peak_arcsec"])
        same = propose("--take", "2", "--json", gear1=graded)
        self.assertEqual(same.json, found["proposals"][1]["spec"])

    def test_text_and_csv(self):
        text = propose()
        self.assertIn("* Recommended:", text.out)
        self.assertIn("long tip relief", text.out)
        self.assertNotRegex(text.out, r"[ \t]\n")
        rows = propose("--csv", load="torque_Nm = [50, 100]").out.splitlines()
        self.assertEqual(len(rows), 1 + 2 * 5)
        self.assertTrue(rows[0].startswith("proposal,torque_Nm,peak_to_peak_arcsec"))

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
