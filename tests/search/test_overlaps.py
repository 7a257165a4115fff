"""Tests searches whose helix angles follow from a whole overlap ratio.

    plain    the angles and the number of candidates are those of the list of all multiples of 0.01°
    taken    --take writes the helix angle and the face width of the row
    rated    the listed designs have the required safety of the flanks, and the first one has a
             green verdict at the width of its angle
"""
import math
import unittest

from searching import Run, folder, search, spec, taken

KEYS = {"ratio": [1.9, 2.1], "center_distance_mm": [99, 101], "modules_mm": [2, 2.5], "pinion_teeth": [20, 34],
        "helix_angle_deg": [8, 20], "face_width_mm": [20, 36], "face_width_step_mm": 2, "overlap_ratio": [1, 2]}
NOMINAL = {"interference": "flag", "objective": "shift"}
RATED = """[gear1.material]
name = "18CrNiMo7-6"
[rating]
torque_Nm = 150
speed_rpm = 1480
quality = 6
face_load_factor = 1.3
"""


def overlap(width, module, beta_deg):
    return width * math.sin(math.radians(beta_deg)) / (math.pi * module)


class WholeOverlaps(unittest.TestCase):
    def check(self, row):
        beta, number = row["helix_angle_deg"][0], round(row["overlap_ratio"])
        self.assertIn(number, (1, 2))
        self.assertTrue(8 <= beta <= 20)
        self.assertAlmostEqual(100 * beta, round(100 * beta), delta=1e-9)
        self.assertEqual(row["face_width_mm"] % 2, 0)
        self.assertAlmostEqual(row["overlap_ratio"], overlap(row["face_width_mm"], row["module_mm"], beta), delta=1e-12)
        self.assertLess(overlap(row["face_width_mm"], row["module_mm"], beta - 0.01), number)
        self.assertGreaterEqual(row["overlap_ratio"], number * (1 - 1e-12))

    def test_angles_and_candidates(self):
        text = spec(KEYS | NOMINAL)
        found = search(text, "--top", 1000)
        for row in found["designs"]:
            self.check(row)
        self.assertGreater(len({(row["face_width_mm"], row["helix_angle_deg"][0]) for row in found["designs"]}), 10)
        combinations = 0
        for module in KEYS["modules_mm"]:
            for width in range(20, 37, 2):
                for number in (1, 2):
                    first = next((k for k in range(1, 9000) if overlap(width, module, k / 100) >= number), 9000)
                    combinations += 800 <= first <= 2000
        one = search(spec(KEYS | NOMINAL, modules_mm=[2], helix_angle_deg=12, face_width_mm=20, overlap_ratio=None))["tested"]
        self.assertEqual(found["tested"], combinations * one)
        pair = taken(text, 1)
        self.assertEqual(pair["gears"][0]["helix_angle_deg"], found["designs"][0]["helix_angle_deg"][0])
        self.assertAlmostEqual(pair["pair"]["overlap_ratio"], found["designs"][0]["overlap_ratio"], delta=1e-12)

    def test_rated_designs(self):
        text = spec(KEYS | {"modules_mm": [2], "overlap_ratio": 1, "safety_flank_min": 1.6, "safety_root_min": 1.4,
                            "objective": "noise", "loaded_designs": 0}, RATED)
        found = search(text)
        self.assertGreater(found["feasible_count"], 0)
        self.assertGreater(found["rejected"]["safety_flank"], 0)
        for row in found["designs"][:20]:
            self.check(row)
            self.assertGreaterEqual(min(row["S_H"]), 1.6)
            # [T9.15]: for ε_β = 1 + δ, λ varies by at most δ, which is 0.00125 from 8° on. The
            # teeth yield by less than 40 µm.
            self.assertLess(row["noise_um"], 0.05)
        r = Run("search", text, "--take", 1, folder=folder())
        rate = Run("rate", r.out, "--json", folder=r.folder, name="pair.toml")
        self.assertEqual(rate.status, 0, rate.err)
        self.assertEqual(rate.json["verdict"]["level"], "green")
        for got, want in zip(found["designs"][0]["S_H"], rate.json["rating"]["S_H"]):
            self.assertAlmostEqual(got, want, delta=1e-12 * want)

    def test_default_widths(self):
        keys = KEYS | {"modules_mm": [2], "face_width_mm": None, "face_width_step_mm": 1, "overlap_ratio": 1}
        found = search(spec(keys | {"safety_flank_min": 1.2, "objective": "mass"}, RATED))
        self.assertGreater(found["feasible_count"], 0)
        for row in found["designs"]:
            share = row["face_width_mm"] / (2 * row["teeth"][0] / math.cos(math.radians(row["helix_angle_deg"][0])))
            self.assertTrue(0.2 <= share <= 1, row)
            self.assertLess(overlap(row["face_width_mm"], 2, row["helix_angle_deg"][0] - 0.01), 1)
            self.assertGreaterEqual(row["overlap_ratio"], 1 - 1e-12)
        wide = search(spec(keys | {"safety_flank_min": 1.2, "objective": "mass", "face_width_mm": [1, 100]}, RATED))
        self.assertEqual([d for d in wide["designs"] if d["face_width_mm"] * math.cos(math.radians(d["helix_angle_deg"][0]))
                          <= 2 * d["teeth"][0]][0]["face_width_mm"], found["designs"][0]["face_width_mm"])
        refused = Run("search", spec(keys | NOMINAL), folder=folder())
        self.assertEqual(refused.status, 1)
        self.assertIn("search.overlap_ratio", refused.err)
        self.assertIn("or a required safety by safety_flank_min or safety_root_min", " ".join(refused.err.split()))

    def test_widths_of_an_inch_spec(self):
        keys = {"ratio": [1.9, 2.1], "center_distance_in": [3.9, 4], "diametral_pitches_per_in": [10, 12],
                "helix_angle_deg": [8, 20], "face_width_in": [1, 1.5], "overlap_ratio": 1} | NOMINAL
        found = search('units = "inch"\n' + spec(keys))
        self.assertTrue(found["designs"])
        for row in found["designs"]:  # multiples of the default step, 0.05 in
            steps = row["face_width_in"] / 0.05
            self.assertAlmostEqual(steps, round(steps), delta=1e-9)

    def test_a_short_overlap_is_named(self):
        words = "overlap_ratio = 1 in [search] gives every design a whole overlap ratio."
        narrow = KEYS | NOMINAL | {"overlap_ratio": None, "face_width_mm": 10, "face_width_step_mm": None}
        listed = lambda keys: " ".join(Run("search", spec(keys), folder=folder()).out.split())  # noqa: E731
        self.assertIn("have an overlap ratio ε_β below 1. " + words, listed(narrow))
        for other in ({"helix_angle_deg": 0}, {"overlap_ratio_min": 0.2}, {"face_width_mm": 200}):
            self.assertNotIn(words, listed(narrow | other), other)

    def test_default_band(self):
        text = spec(KEYS | NOMINAL, helix_angle_deg=None)
        found = search(text)
        self.assertEqual(found.pop("helix_angle_deg"), [5, 30])
        self.assertEqual(found, search(spec(KEYS | NOMINAL, helix_angle_deg=[5, 30])))
        self.assertTrue(found["designs"])
        words = "β from 5° to 30° is a default. Give helix_angle_deg = [least, greatest] in [search] for another band."
        self.assertIn(words, " ".join(Run("search", text, folder=folder()).out.split()))
        self.assertNotIn("is a default", Run("search", spec(KEYS | NOMINAL), folder=folder()).out)


if __name__ == "__main__":
    unittest.main()
