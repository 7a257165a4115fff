"""Computes the bricks of a stepped shaft again (tests/oracle/shafts). The unit tests ShaftBricks compare the
closed form with these data."""
import importlib.util
import json
import unittest

from cli import SOURCE

FROM = SOURCE / "tests/oracle/shafts/stepped_shafts.py"


def oracle():
    spec = importlib.util.spec_from_file_location("stepped_shafts", FROM)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Shafts(unittest.TestCase):
    def setUp(self):
        self.oracle = oracle()
        if not self.oracle.installed():
            self.skipTest("ccx is not installed (Debian: calculix-ccx)")
        self.kept = {shaft["name"]: shaft for shaft in json.loads(FROM.with_suffix(".json").read_text())["shafts"]}

    def near(self, anew, kept, share):
        self.assertEqual(len(anew), len(kept))
        most = max(map(abs, kept))
        for a, b in zip(anew, kept):
            self.assertAlmostEqual(a, b, delta=share * most)

    def test_calculix_gives_the_data_again(self):
        self.assertEqual(set(self.kept), set(self.oracle.SHAFTS))
        for name, kept in self.kept.items():
            with self.subTest(name):
                anew = self.oracle.made(name)
                self.assertEqual(anew["unknowns"], kept["unknowns"])
                for key in ("z", "w_um", "slope_urad", "face_z", "twist_urad"):
                    self.near(anew[key], kept[key], 1e-4)

    def test_finer_bricks_give_the_same(self):
        name = "between the bearings"
        self.oracle.CORE = 3
        w, slope = self.oracle.Bricks(self.oracle.SHAFTS[name]).bending()
        self.near(1e3 * w, self.kept[name]["w_um"], 0.005)
        # At the plane of a step, the slope is the mean over the smaller section, which warps.
        self.near(1e6 * slope, self.kept[name]["slope_urad"], 0.01)


if __name__ == "__main__":
    unittest.main()
