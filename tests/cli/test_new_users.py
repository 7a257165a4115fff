"""Tests results that new users misread: unknown keys with their suggestions, readings of an unknown gear, notes
about chosen values, and headings of listings."""
import unittest

from cli import PAIR, Asked, Run, raw

TWO = "[gear1]\nteeth = 27\nnormal_module_mm = 2\nface_width_mm = 28\n[gear2]\nteeth = 85\n"
ODD = ("[gear1]\nteeth = 31\n[gear1.measured]\ntip_diameter_mm = {}\nspan_mm = {{ 3 = 23.78, 4 = 32.64 }}\n"
       "helix_angle_deg = -12.4\nhelix_angle_uncertainty_deg = 0.3\n")


class Suggestions(Asked):
    def test_every_unknown_key_has_a_suggestion(self):
        message = self.refused("[gear1]\nz = 20\nm = 2\nb = 20\nbeta = 15\nx = 0.2\n", "gear1.b", "did you mean face_width_mm?",
                               verb="gear")
        self.assertTrue(message.endswith("also unknown here: beta (helix_angle_deg?), m (normal_module_mm?), "
                                         "x (profile_shift?), z (teeth?)"), message)
        message = self.refused("[search]\nratio = 3\nSF = 1.4\nSH = 1.2\npower = 22\n", "search.SF", verb="search")
        for word in ("safety_root_min", "SH (safety_flank_min?)", "power (power_kW in [rating]?)"):
            self.assertIn(word, message)

    def test_pinion_and_wheel_are_gears_1_and_2(self):
        self.refused("[pinion]\nteeth = 20\n[wheel]\nteeth = 40\n", "pinion", "did you mean gear1?", "wheel (gear2?)")

    def test_a_deviation_in_micrometres_is_an_angle(self):
        for key in ("crossing_um", "parallelism_mm"):
            self.refused(TWO + f"[errors]\n{key} = 20\n", f"errors.{key}", "crossing_deg", "0.01 mm over 100 mm is 0.00573°",
                         verb="contact")
        self.refused(TWO + "[errors]\nparallelism = 0.02\n", "errors.parallelism", "did you mean crossing_deg?", verb="contact")

    def test_a_span_is_a_reading(self):
        self.refused("[gear1]\nteeth = 31\nspan = { 3 = 23.78 }\n", "gear1.span", "[gear1.measured]", verb="identify")

    def test_a_stage_has_two_gears(self):
        self.refused("[[stage]]\nteeth = [18, 30, 54]\nnormal_module_mm = 2\n", "stage[1].teeth", "[[drive.mesh]]", verb="drive")

    def test_a_spec_is_no_verb(self):
        run = raw("pair.toml")
        self.assertEqual(run.returncode, 2)
        self.assertIn("give a verb before the spec, for example gearwright run pair.toml", run.stderr)


    def test_a_file_has_the_ending_of_its_option(self):
        run = Run("export", PAIR, "--step", "pair.stl")
        self.assertEqual((run.status, run.files()), (2, ["case.toml"]))
        self.assertIn("use --stl", run.err)
        self.assertEqual(Run("export", PAIR, "--dxf", "pair.DXF").status, 0)


class Values(Asked):
    def test_a_calliper_over_odd_teeth_reads_less(self):
        """The gear has a tip diameter of 101.94 mm. Over its 31 teeth, a calliper reads about 101.8 mm."""
        out = Run("identify", ODD.format(101.70)).out
        self.assertRegex(out, r"the tip is worn, or the reading\s+is a dimension over the tips")
        self.assertRegex(out, r"reads up to 0\.262 mm less")
        self.assertNotIn("dimension over the tips", Run("identify", ODD.format(101.95)).out)
        worn = Run("identify", ODD.format(101.60)).out
        self.assertNotIn("dimension over the tips", worn)

    def test_a_small_backlash_is_compared_with_the_recommended_one(self):
        tight = self.ok("pair", TWO + "[pair]\nbacklash_mm = 0.02\n")
        self.assertEqual(tight["verdict"]["level"], "green")
        self.assertEqual([f["code"] for f in tight["verdict"]["findings"]], ["little_backlash"])
        self.assertIn("0.0200 mm in the normal section (ISO/TR 10064-2 recommends at least 0.", tight["verdict"]["headline"])
        self.assertEqual(self.ok("pair", TWO + "[pair]\nbacklash_mm = 0.06\n")["verdict"]["findings"], [])

    def test_a_rack_shorter_than_its_space_is_reported(self):
        rack = "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 20\n[gear2]\nform = \"rack\"\nheight_mm = 9\nlength_mm = {}\n"
        notes = [w["message"] for w in self.ok("pair", rack.format(300))["warnings"]]
        self.assertEqual(notes, ["The rack has 47 whole teeth and is 295.31 mm long, which is 4.69029 mm less than the given length."])
        self.assertEqual(self.ok("pair", rack.format(295.3097094374406))["warnings"], [])

    def test_corrections_of_flanks_without_crowning_centre_the_pattern(self):
        """The position of the first contact is at an end of the face before and after the correction, because the
        flanks have no crowning. The contact pattern moves from the end to the middle."""
        result = self.ok("compensate", TWO + "[pair]\nbacklash_mm = 0.2\n[errors]\ncrossing_deg = 0.0115\n")["compensate"]
        self.assertGreater(abs(result["before"]["pattern_along_face"]), 0.5)
        self.assertLess(abs(result["after"]["pattern_along_face"]), 0.02)


class Listings(unittest.TestCase):
    def test_a_search_names_its_order_and_the_next_command(self):
        search = "[search]\nratio = [3, 3.1]\nmodules_mm = 2\npinion_teeth = 20\n"
        out = Run("search", search).out
        self.assertIn("Designs are ranked by contact ratio.", out)
        self.assertIn("--take NUMBER > pair.toml", out)
        out = Run("search", '[search]\nkind = "planetary"\nratio = 5\nring_teeth = 72\n').out
        self.assertIn("Designs are ranked by efficiency.", out)
        self.assertIn("--take NUMBER > drive.toml", out)

    def test_loads_use_the_unit_of_contact(self):
        out = Run("load", TWO + '[load]\ntorque_Nm = 100\naccuracy = "draft"\npositions = 4\nslices = 4\n').out
        self.assertRegex(out, r"Harmonics 1 to \d, amplitudes  +[0-9., ]+ ″\n")
        self.assertIn("the first is for gear 1", out)

    def test_a_train_has_no_carrier(self):
        train = "[[stage]]\nteeth = [18, 54]\nnormal_module_mm = 2\ntorque_Nm = 10\nspeed_rpm = 100\n"
        out = Run("drive", train).out
        self.assertNotIn("carrier", out)
        self.assertNotIn("planet", out)
        self.assertIn("relative to", Run("drive", "[planetary]\nsun = 18\nring = 72\nplanets = 3\n").out)

    def test_a_report_without_a_title_names_the_gears(self):
        run = Run("run", PAIR.replace('title = "helical pair"\n', ""), "--only", "report")
        page = (run.folder / "case_out" / "report.html").read_text()
        self.assertIn("<h1>Gear pair 17 / 43</h1>", page)


if __name__ == "__main__":
    unittest.main()
