"""Tests output_torque_Nm, the torque on the driven gear of a pair: T_1 = T_2 z_1/|z_2|, without losses."""

import math
import unittest

from cli import Run

PAIR = """
[gear1]
teeth = 20
normal_module_mm = 3
face_width_mm = 20
material = "16MnCr5"
quality = 6
[gear2]
teeth = {teeth}
"""
LOAD = '[load]\npositions = 6\nslices = 8\naccuracy = "draft"\n'
RATING = "[rating]\nspeed_rpm = 1000\nface_load_factor = 1.2\n"
SEARCH = """
[gear1]
material = "16MnCr5"
[search]
ratio = [2.4, 3.6]
modules_mm = [3]
pinion_teeth = [20, 22]
face_width_mm = 30
safety_flank_min = 0.5
mounting = "tight"
thickness_series = "none"
"""


class OutputTorque(unittest.TestCase):
    def torques(self, teeth, load):
        answer = Run("load", PAIR.format(teeth=teeth) + LOAD + load, "--json")
        self.assertEqual(answer.status, 0, answer.err)
        return [t["torque_Nm"] for t in answer.json["load"]["torques"]]

    def test_load_has_the_torque_on_gear_1(self):
        self.assertEqual(self.torques(50, "output_torque_Nm = [100, 250]\n"), [40, 100])
        self.assertEqual(self.torques(-50, "output_torque_Nm = 250\n"), [100])
        self.assertEqual(self.torques(78, "output_torque_Nm = 390\n"), [100])  # 390 · (20/78) is less than 100 in double
        self.assertEqual(self.torques(50, "output_torque_Nm = 100\ndriver = 2\n"), [100])

    def test_rating_has_the_torque_on_both_gears(self):
        out, plain = (Run("rate", PAIR.format(teeth=50) + RATING + load, "--json").json["rating"]
                      for load in ("output_torque_Nm = 250\n", "torque_Nm = 100\n"))
        self.assertEqual(out["torque_Nm"], [100, 250])
        self.assertEqual(out["F_t_N"], 2000 * 100 / 60)
        self.assertEqual(out, plain)

    def test_a_design_of_a_search_has_the_torque_of_its_ratio(self):
        spec = SEARCH + RATING + "quality = 6\noutput_torque_Nm = 200\n"
        found = Run("search", spec, "--json").json["search"]["designs"]
        ratios = set()
        for number, design in list(enumerate(found, 1))[:12:4]:
            ratios.add(design["ratio"])
            taken = Run("search", spec, "--take", str(number))
            self.assertEqual(taken.status, 0, taken.err)
            rating = Run("rate", taken.out, "--json").json["rating"]
            self.assertTrue(math.isclose(rating["torque_Nm"][0], 200 / design["ratio"], rel_tol=1e-12))
            for key in ("S_H", "S_F"):
                for one, two in zip(design[key], rating[key]):
                    self.assertTrue(math.isclose(one, two, rel_tol=1e-9), (design["teeth"], key, one, two))
        self.assertGreater(len(ratios), 1)
        self.assertIn("200 N m on gear 2", Run("search", spec).out)

    def test_a_change_of_the_load_is_a_change_of_the_given_key(self):
        spec = SEARCH.replace("0.5", "5") + RATING + "quality = 6\noutput_torque_Nm = 200\n"
        changes = Run("search", spec, "--json").json["search"]["changes"]
        self.assertIn("rating.output_torque_Nm", [change["key"] for change in changes])

    def test_errors_name_the_given_key(self):
        drive = "[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\nnormal_module_mm = 2\n"
        for spec, key, word in (
                (PAIR.format(teeth=50) + LOAD + "torque_Nm = 1\noutput_torque_Nm = 2\n", "load.output_torque_Nm", "torque_Nm"),
                (PAIR.format(teeth=50) + RATING + "power_kW = 1\noutput_torque_Nm = 2\n", "rating.output_torque_Nm", "power_kW"),
                (PAIR.format(teeth=50) + LOAD + "output_torque_Nm = 0\n", "load.output_torque_Nm", "greater than 0"),
                (drive + LOAD + "output_torque_Nm = 2\n", "load.output_torque_Nm", "T_out/(i η)"),
                (drive + RATING + "output_torque_Nm = 2\n", "rating.output_torque_Nm", "T_out/(i η)"),
                (PAIR.format(teeth=50) + LOAD + "torque_out_Nm = 2\n", "load.torque_out_Nm", "output_torque_Nm in [load]")):
            run = Run("drive" if spec.startswith("[planetary]") else "load", spec, "--json")
            self.assertEqual(run.status, 1, spec)
            self.assertEqual(run.json["error"]["key"], key)
            self.assertIn(word, run.json["error"]["message"])


if __name__ == "__main__":
    unittest.main()
