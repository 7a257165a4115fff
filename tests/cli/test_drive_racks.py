"""Tests drives with a rack: its numbers as those of a pair, its motion, its limits, and its pictures."""
import math
import re
import unittest

from cli import Run

LIFT = """
[drive]
input = "shaft"
output = "bar"
speed_rpm = 60
torque_Nm = 10
body = [{ name = "shaft" }, { name = "bar" }]
gear = [{ name = "p", body = "shaft", teeth = 20, normal_module_mm = 2, helix_angle_deg = 10 },
        { name = "r", body = "bar", form = "rack", teeth = 30, height_mm = 18 }]
mesh = [{ gears = ["p", "r"], efficiency = 0.98 }]
"""


class Racks(unittest.TestCase):
    def test_a_rack_is_gear_2(self):
        drive = """
[drive]
fixed = ["frame"]
input = "pinion"
output = "bar"
body = [{ name = "frame" }, { name = "pinion" }, { name = "bar" }]
gear = [{ name = "r", body = "bar", form = "rack", teeth = 20 }, { name = "p", body = "pinion", teeth = 17, normal_module_mm = 2 }]
mesh = [{ gears = ["r", "p"] }]
"""
        spec = Run("drive", drive, "--take", "1")
        self.assertEqual(spec.status, 0, spec.err)
        pair = Run("pair", spec.out, "--json")
        self.assertEqual(pair.status, 0, pair.err)
        self.assertEqual(pair.json["pair"]["kind"], "rack_and_pinion")

    def test_a_rack_moves(self):
        """At one turn per second, the rack moves by the pitch circumference of its pinion every second.
        Its force acts at the radius d/2."""
        drive = Run("drive", LIFT, "--json").json
        d = 20 * 2 / math.cos(math.radians(10))
        bar = drive["drive"]["bodies"]["bar"]
        self.assertAlmostEqual(bar["speed_m_per_s"], math.pi * d / 1000, 12)
        self.assertAlmostEqual(abs(bar["force_N"]), 0.98 * 10 / (d / 2000), 9)
        self.assertAlmostEqual(bar["power_kW"] * 1000, bar["force_N"] * bar["speed_m_per_s"], 9)
        self.assertEqual([bar[key] for key in ("speed_rpm", "torque_Nm")], [None, None])
        shaft = drive["drive"]["bodies"]["shaft"]
        self.assertEqual([shaft[key] for key in ("speed_m_per_s", "force_N")], [None, None])
        self.assertEqual(drive["verdict"]["level"], "green")
        self.assertIn("no backlash between the rack and its pinion", drive["verdict"]["headline"])
        self.assertAlmostEqual(bar["travel_per_input_turn_mm"], math.pi * d, 9)
        self.assertIsNone(shaft["travel_per_input_turn_mm"])
        self.assertIn(f"travel {math.pi * d:.4f} mm per turn of the input", drive["verdict"]["headline"])
        text = Run("drive", LIFT).out
        for words in (" 0.1276 ", " m/s ", f" {math.pi * d:.4f} ", " -482.6 ", "pitches per turn"):
            self.assertIn(words, text)
        page = (Run("run", LIFT, "--out", "o").folder / "o/report.html").read_text()
        self.assertTrue("Speed of the rack" in page and ">0.1276<" in page)
        ids = re.findall(r' id="([^"]*)"', page)
        self.assertEqual(len(ids), len(set(ids)))
        self.assertLessEqual({"scheme", "section-1", "gear2"}, set(ids))  # gear2 is the shape of the rack
        self.assertIn("r 30, rack, 0.1276 m/s", page)
        self.assertLessEqual(set(re.findall(r'href="#([^"]*)"', page)), set(ids))

    def test_a_single_input_drives(self):
        """Force and speed of a rack, and torque and speed of a shaft, have the same sign. The error has the keys
        that were given."""
        lift = LIFT.replace('input = "shaft"', 'input = "bar"').replace('output = "bar"', 'output = "shaft"')
        for drive, load, speed in ((LIFT, "torque_Nm", "speed_rpm"), (lift, "force_N", "speed_m_per_s")):
            for sign in (1, -1):
                run = Run("drive", drive.replace("speed_rpm = 60", f"{speed} = 2").replace("torque_Nm = 10", f"{load} = {sign * 10}"))
                self.assertEqual(run.status, 0 if sign > 0 else 1, run.err)
                self.assertIn("" if sign > 0 else f"drive.{load} = -10: must have the sign of", run.err)

    def test_a_rack_is_not_rated(self):
        """ISO 6336 does not cover a rack. The verdict names its mesh, and the listing has no empty row."""
        rating = '[rating]\nlife_h = 10000\nquality = 6\nface_load_factor = 1.2\nmaterial = "16MnCr5"\n'
        rated = Run("rate", LIFT + rating, "--json")
        self.assertEqual(rated.status, 0, rated.err)
        (name,) = rated.json["drive"]["meshes"]
        self.assertEqual(rated.json["verdict"]["not_judged"], [f"rating of the mesh {name}"])
        text = Run("rate", LIFT + rating).out
        self.assertNotIn("Strength", text)
        self.assertIn(f"not judged: rating of the mesh {name}.", " ".join(text.split()))

    def test_a_rack_has_contact_and_a_verdict(self):
        """Under errors, the travel of the rack deviates by as much as `contact` gives for the pinion and its rack."""
        askew = LIFT.replace('r"], efficiency', 'r"], center_distance_mm = 20.4, efficiency')
        askew += "[errors]\ncrossing_deg = 0.1\n[contact]\npositions = 256\n"
        drive = Run("drive", askew, "--json").json
        contact = Run("contact", Run("drive", askew, "--take", "1").out, "--json").json
        error = drive["drive"]["transmission_error"]
        self.assertIsNone(error["output_arcsec_peak_to_peak"])
        self.assertGreater(error["output_peak_to_peak_um"], 1)
        self.assertAlmostEqual(error["output_peak_to_peak_um"], contact["contact"]["peak_to_peak_um"], 9)
        self.assertGreater(error["lines"][0]["amplitude_um"], 0)
        # Edges in contact are findings of the drive, as they are findings of the pair.
        codes = [[f["code"] for f in answer["verdict"]["findings"] if f["level"] != "green"] for answer in (drive, contact)]
        self.assertEqual(codes[0], codes[1])
        self.assertIn("edge_contact", codes[0])
        mesh = drive["drive"]["meshes"]["p_r"]
        self.assertEqual(mesh["rack_pair"]["kind"], "rack_and_pinion")
        self.assertIn("The least backlash is", drive["verdict"]["headline"])
        page = (Run("run", askew, "--out", "o").folder / "o/report.html").read_text()
        self.assertIn(">Mesh p_r</h2>", page)
        self.assertIn("transmission error of the rack", page.lower())
        pair = Run("pair", Run("drive", askew, "--take", "1").out, "--json").json["pair"]["backlash"]
        play = drive["drive"]["backlash"]
        self.assertAlmostEqual(play["output_mm"], 2 * (20.4 - 20 / math.cos(math.radians(10))) * math.tan(math.radians(20))
                               / math.cos(math.radians(10)), 12)
        self.assertAlmostEqual(play["output_mm"], pair["circumferential_mm"][1], 12)
        self.assertAlmostEqual(play["input_deg"], pair["rotation_deg"], 12)
        self.assertEqual([play["output_deg"], play["input_mm"]], [None, None])
        tight = Run("drive", LIFT.replace('r"], efficiency', 'r"], center_distance_mm = 20.2, efficiency'), "--json")
        self.assertEqual(tight.json["verdict"]["level"], "red")
        self.assertEqual(tight.json["verdict"]["findings"][0]["code"], "negative_backlash")

    def test_a_rack_drives(self):
        """If a rack drives, its speed is the pitch line velocity of the pinion. Its force has the lever arm
        d/2."""
        back = LIFT.replace('input = "shaft"\noutput = "bar"', 'input = "bar"\noutput = "shaft"')
        drive = Run("drive", back.replace("speed_rpm = 60", "speed_m_per_s = 0.5").replace("torque_Nm = 10", "force_N = 800"), "--json")
        self.assertEqual(drive.status, 0, drive.err)
        bodies = drive.json["drive"]["bodies"]
        d = 20 * 2 / math.cos(math.radians(10))
        self.assertAlmostEqual(bodies["bar"]["speed_m_per_s"], 0.5, 14)
        self.assertAlmostEqual(bodies["bar"]["force_N"], 800, 10)
        self.assertAlmostEqual(bodies["shaft"]["speed_rpm"], 60 * 0.5 / (math.pi * d / 1000), 9)
        self.assertAlmostEqual(abs(bodies["shaft"]["torque_Nm"]), 0.98 * 800 * d / 2000, 9)
        self.assertAlmostEqual(bodies["bar"]["power_kW"], 0.4, 12)
        for spec, words in ((back, ("drive.speed_rpm", "speed_m_per_s")),
                            (back.replace("speed_rpm = 60\n", ""), ("drive.torque_Nm", "force_N")),
                            (LIFT.replace("speed_rpm = 60", "speed_m_per_s = 0.5"), ("drive.speed_m_per_s", "input is a rack"))):
            run = Run("drive", spec)
            self.assertEqual(run.status, 1)
            for word in words:
                self.assertIn(word, run.err)

    def test_the_height_of_a_rack_reaches_its_pair(self):
        pair = Run("pair", Run("drive", LIFT, "--take", "1").out, "--json")
        self.assertEqual(pair.status, 0, pair.err)
        self.assertAlmostEqual(pair.json["pair"]["mounting_distance_mm"], pair.json["pair"]["center_distance_mm"] + 18, 9)
        for height, word in (("height_mm = -1", "greater than 0"), ("form = \"gear\", teeth = 30, height_mm = 18", "form")):
            run = Run("drive", LIFT.replace('form = "rack", teeth = 30, height_mm = 18',
                                                 height if "form" in height else 'form = "rack", ' + height + ", teeth = 30"))
            self.assertEqual(run.status, 1)
            for words in ("drive.gear[2].height_mm", word):
                self.assertIn(words, run.err)

    def test_a_rack_has_a_length_or_a_number_of_teeth(self):
        """Regression: the number of teeth that was used until the length is known counted as given."""
        bar = 'form = "rack", teeth = 30'
        pitch = 2 * math.pi / math.cos(math.radians(10))
        spec = LIFT.replace(bar, 'form = "rack", length_mm = 200')
        taken = Run("drive", spec, "--take", "1")
        self.assertEqual(taken.status, 0, taken.err)
        pair = Run("pair", taken.out, "--json")
        self.assertEqual(pair.status, 0, pair.err)
        self.assertEqual(pair.json["gears"][1]["teeth"], int(200 / pitch))
        both = Run("drive", LIFT.replace(bar, bar + ", length_mm = 200"))
        self.assertEqual(both.status, 1)
        for words in ("drive.gear[2].length_mm = 200", "only one of the keys"):
            self.assertIn(words, both.err)

    def test_a_rack_in_a_drive_has_the_limits_of_a_rack(self):
        for given, words in (("height_mm = 1", "r: height_mm = 1: must be at least 2.501 mm"),
                             ("height_mm = 18, face_width_mm = 1e-9", "r: face_width_mm = 1e-09: must lie between 0.002 mm")):
            drive = Run("drive", LIFT.replace("height_mm = 18", given), "--json").json
            self.assertEqual(drive["verdict"]["level"], "red")
            self.assertIn(words, drive["verdict"]["headline"])

    def test_a_rack_with_too_many_teeth_is_not_a_gear_with_few(self):
        """Regression: the teeth of the rack were examined as those of a gear, whose root "lies beyond the axis"."""
        run = Run("run", LIFT.replace("teeth = 30", "teeth = 100000"), "--out", "o")
        self.assertEqual(run.status, 1)
        self.assertIn("fewer teeth", run.err)
        self.assertNotIn("axis", run.err)


if __name__ == "__main__":
    unittest.main()
