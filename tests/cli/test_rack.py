"""A rack as gear 2: the verbs gear and pair, and what the others say."""

import json
import unittest

from cli import Run

RACK = """[gear1]
teeth = 20
normal_module_mm = 2
face_width_mm = 25
[gear2]
form = "rack"
"""


class ARack(unittest.TestCase):
    def test_the_shortest_spec_is_answered(self):
        r = Run("pair", RACK)
        self.assertEqual(r.status, 0, r.err)
        for words in ("travel per turn of the pinion", "125.6637", "Verdict: green. The rack and pinion run"):
            self.assertIn(words, r.out)
        r = Run("pair", RACK, "--csv")
        self.assertIn("pair.travel_mm_per_turn,", r.out)
        self.assertIn("rack.transverse_pitch_mm,", r.out)

    def test_gear_and_pair_give_both_parts(self):
        for verb in ("gear", "pair"):
            r = Run(verb, RACK + "teeth = 30\nheight_mm = 18\n", "--json")
            answer = json.loads(r.out)
            self.assertEqual(answer["gears"][1]["form"], "rack")
            self.assertAlmostEqual(answer["gears"][1]["length_mm"], 30 * 6.283185307179586, 12)
            self.assertEqual(answer["pair"]["kind"], "rack_and_pinion")
            self.assertEqual(answer["pair"]["mounting_distance_mm"], 20 + 18)

    def test_what_a_rack_cannot_be_is_said(self):
        for verb, extra, *words in (
                ("contact", "", "gear2.form", "the verbs gear and pair"),
                ("pair", "[pair]\nbacklash_mm = 0.1\n", "pair.backlash_mm", "thickness allowances"),
                ("pair", "profile_shift = 0.2\n", "gear2.profile_shift", "unknown key"),
                ("pair", "teeth = 0\n", "gear2.teeth", "1")):
            with self.subTest(verb=verb, extra=extra):
                r = Run(verb, RACK + extra)
                self.assertEqual(r.status, 1)
                for w in words:
                    self.assertIn(w, r.err)
        r = Run("pair", RACK.replace("teeth = 20", "teeth = -60"))
        self.assertEqual(r.status, 1)
        self.assertIn("gear1.teeth = -60: a rack meshes with an external gear only", r.err)

    def test_a_rack_that_jams_is_red(self):
        r = Run("pair", RACK + "[pair]\ncenter_distance_mm = 19.9\n", "--strict")
        self.assertEqual(r.status, 4)
        self.assertIn("jam", r.out)


if __name__ == "__main__":
    unittest.main()
