"""Tests searches whose designs are drawn, with face widths, allowances and the verdict on the resulting
pair.

    listed     samples of the designs have no finding above green, the verbs rate and pair give the
               same numbers for them, and the verdict of the verb run is green
    least      a face width that is one step smaller is not sufficient
    backlash   a range of backlash, a series, and a tolerance of the centre distance
    defaults   centre distances without backlash, DIN 3967 cd25, limits of |x| and |ζ|, and how to change them
    refused    errors by key
    Long…      fifty random searches
"""
import json
import math
import random
import tomllib
import unittest

from searching import SOURCE, Asked, Run, folder, search, spec

HOUSING = {"ratio": [3.087, 3.213], "center_distance_mm": 125, "modules_mm": "ISO54-I", "pinion_teeth": [15, 40],
           "helix_angle_deg": [8, 20], "helix_step_deg": 4, "face_width_mm": [10, 120], "safety_flank_min": 1.3,
           "safety_root_min": 1.6, "objective": "mass"}
STEEL = '[gear1.material]\nname = "18CrNiMo7-6"\n'
LOAD = """[rating]
power_kW = 11
speed_rpm = 1450
application_factor = 1.25
life_h = 20000
quality = 6
face_load_factor = 1.3
"""


def drawn(after=STEEL + LOAD, **keys):
    return spec(HOUSING, after, **keys)


class Drawn(Asked):
    def made(self, text, rank):
        """Returns the spec of the design with this rank, the result of the verb rate for it, and the pair
        of the verb pair."""
        take = Run("search", text, "--take", rank, folder=folder())
        self.assertEqual(take.status, 0, take.err)
        rate = Run("rate", take.out, "--json", folder=take.folder, name="pair.toml")
        self.assertEqual(rate.status, 0, rate.err)
        pair = Run("pair", take.out, "--json", folder=take.folder, name="pair.toml")
        self.assertEqual(pair.status, 0, pair.err)
        return tomllib.loads(take.out), rate.json, pair.json["pair"]

    def findings(self, verdict):
        return [f for f in verdict["findings"] if f["level"] != "green"]

    def is_as_listed(self, text, found, rank):
        design = found["designs"][rank - 1]
        made, answer, pair = self.made(text, rank)
        self.assertEqual([self.findings(answer["verdict"]), answer["verdict"]["level"]], [[], "green"], f"rank {rank}")
        for key in ("S_H", "S_F"):
            for got, want in zip(design[key], answer["rating"][key]):
                self.assertAlmostEqual(got, want, delta=1e-12 * want, msg=f"{rank} {key}")
        self.assertEqual(made["gear1"]["face_width_mm"], design["face_width_mm"])
        for got, want in ((design["center_distance_mm"], pair["center_distance_mm"]),
                          (design["contact_ratio"], pair["transverse_contact_ratio"]),
                          (design["overlap_ratio"], pair["overlap_ratio"]),
                          (design["backlash_normal_mm"], pair["backlash"]["normal_base_mm"]),
                          *zip(design["tip_clearance_mm"], pair["tip_clearance_mm"])):
            self.assertAlmostEqual(got, want, delta=1e-9 * max(1.0, abs(want)), msg=f"rank {rank}")
        if "backlash_mm" in design:
            ends = sorted(pair["interval"]["backlash"]["normal_mm"])
            for got, want in zip(design["backlash_mm"], ends):
                self.assertAlmostEqual(got, want, delta=1e-9)
        return made


class Listed(Drawn):
    def test_the_housing(self):
        text = drawn()
        found = search(text)
        self.assertGreater(len(found["designs"]), 20)
        self.assertGreater(found["rejected"]["verdict"], 0)
        step = max(1, len(found["designs"]) // 10)
        for rank in range(1, len(found["designs"]) + 1, step):
            self.is_as_listed(text, found, rank)
        for design in found["designs"]:
            self.assertGreater(design["backlash_mm"][0], 0.05)
            self.assertLessEqual(max(map(abs, design["profile_shift"])), 1.0)
            for sliding in design["specific_sliding"].values():
                self.assertLessEqual(max(map(abs, sliding)), 3.0)
            self.assertEqual(design["face_width_mm"] % 1, 0)

    def test_run_says_the_same(self):
        text = drawn(helix_angle_deg=12, helix_step_deg=None)
        take = Run("search", text, "--take", 1, folder=folder())
        run = Run("run", take.out, "--strict", "--out", "made", folder=take.folder, name="pair.toml")
        self.assertEqual(run.status, 0, run.out + run.err)
        self.assertEqual(json.loads((run.folder / "made/result.json").read_text())["verdict"]["level"], "green")

    def test_the_least_width(self):
        text = drawn(helix_angle_deg=[10, 18], overlap_ratio_min=1.0)
        found = search(text)
        self.assertGreater(len(found["designs"]), 3)
        for rank, design in enumerate(found["designs"][:8], 1):
            self.assertGreaterEqual(design["overlap_ratio"], 1.0)
            made, _, _ = self.made(text, rank)
            module, beta = design["module_mm"], math.radians(abs(design["helix_angle_deg"][0]))
            b = design["face_width_mm"] - 1
            for gear in ("gear1", "gear2"):
                made[gear]["face_width_mm"] = b
            less = Run("rate", json.dumps(made), "--json", folder=folder(), name="pair.json")
            self.assertEqual(less.status, 0, less.err)
            holds = not self.findings(less.json["verdict"]) and b * math.sin(beta) / (math.pi * module) >= 1.0
            self.assertFalse(holds and b >= 10, f"rank {rank}: {b} mm would be sufficient")

    def test_width_by_the_diameter(self):
        found = search(drawn(face_width_diameters=[0.3, 0.5]))
        for design in found["designs"]:
            d_1 = design["module_mm"] * design["teeth"][0] / math.cos(math.radians(design["helix_angle_deg"][0]))
            self.assertLessEqual(design["face_width_mm"], 0.5 * d_1 + 1e-9)
            self.assertGreaterEqual(design["face_width_mm"], 0.3 * d_1 - 1e-9)
        self.assertGreater(len(found["designs"]), 0)
        self.assertEqual(search(drawn(face_width_mm=[10, 20], face_width_modules=[30, 40]))["feasible_count"], 0)

    def test_a_range_of_backlash(self):
        text = drawn(backlash_mm=[0.1, 0.2], center_distance_tolerance="JS7", helix_angle_deg=10, helix_step_deg=None)
        found = search(text)
        self.assertGreater(len(found["designs"]), 3)
        for rank in (1, 2, len(found["designs"])):
            self.is_as_listed(text, found, rank)
            for got, want in zip(found["designs"][rank - 1]["backlash_mm"], (0.1, 0.2)):
                self.assertAlmostEqual(got, want, delta=1e-9)

    def test_internal(self):
        text = drawn(ratio=[-4, -3.5], center_distance_mm=None, modules_mm=[2, 2.5], pinion_teeth=[18, 22], helix_angle_deg=0,
                     helix_step_deg=None, safety_flank_min=1.0)
        found = search(text)
        self.assertGreater(len(found["designs"]), 3)
        for rank in (1, 2, len(found["designs"])):
            self.is_as_listed(text, found, rank)

    def test_without_a_rating(self):
        plain = {"ratio": [2.9, 3.1], "center_distance_mm": 80, "modules_mm": [2, 2.5], "pinion_teeth": [15, 30]}
        for text in (spec(plain), spec(plain, face_width_mm=30), (SOURCE / "examples/gearbox_search.toml").read_text()):
            found = search(text)
            self.assertGreater(len(found["designs"]), 0)
            for rank in range(1, len(found["designs"]) + 1):
                take = Run("search", text, "--take", rank, folder=folder())
                pair = Run("pair", take.out, "--json", "--strict", folder=take.folder, name="pair.toml")
                self.assertEqual(pair.status, 0, f"rank {rank}: {pair.out}")
                self.assertNotIn("no_backlash", [f["code"] for f in pair.json["verdict"]["findings"]])

    def test_a_single_width_with_safeties(self):
        text = drawn(face_width_mm=40)
        found = search(text)
        self.assertGreater(len(found["designs"]), 3)
        for rank in (1, 2, len(found["designs"])):
            self.is_as_listed(text, found, rank)

    def test_the_grade_is_in_both_gears(self):
        for standard, edition in (("ISO 6336:2006", "ISO 1328:1995"), ("ISO 6336:2019", None)):
            made, _, _ = self.made(drawn(STEEL + LOAD.replace("quality = 6", f'quality = [6, 7]\nstandard = "{standard}"')), 1)
            self.assertEqual([made[gear]["tolerance"]["quality"] for gear in ("gear1", "gear2")], [6, 7])
            self.assertEqual(made["gear1"]["tolerance"].get("edition"), edition)

    def test_files(self):
        run = Run("search", drawn(helix_step_deg=6), "--out", "found", "--chunk", 5000, folder=folder())
        self.assertEqual(run.status, 0, run.err)
        for words in ("drawn and checked as by `gearwright run`: mounting tight, thickness series cd25, -1 <= x <= 1, |ζ| <= 3",
                      "face width 10 mm to 120 mm (the least sufficient width)", "j_n mm"):
            self.assertIn(words, " ".join(run.out.split()))
        head = (run.folder / "found/best.csv").read_text().splitlines()[0].split(",")
        self.assertLessEqual({"backlash_min_mm", "backlash_max_mm", "face_width_mm", "overlap_ratio"}, set(head))
        found = json.loads((run.folder / "found/search.json").read_text())["search"]
        self.assertEqual(found, search(drawn(helix_step_deg=6)))


class Defaults(Drawn):
    def test_what_is_said(self):
        margins = search(drawn())["margins"]
        self.assertEqual({key: margins[key] for key in ("mounting", "thickness_series", "backlash_mm", "profile_shift", "sliding_max",
                                                        "tip_clearance_min")},
                         {"mounting": "tight", "thickness_series": "cd25", "backlash_mm": None, "profile_shift": [-1, 1],
                          "sliding_max": 3, "tip_clearance_min": 0.1})

    def test_plain_searches_have_them_too(self):
        plain = {"ratio": 3, "modules_mm": 2, "pinion_teeth": [17, 19]}
        for text in (spec(plain), spec(plain, face_width_mm=20), drawn(face_width_mm=40),
                     drawn(face_width_mm=40, safety_flank_min=None, safety_root_min=None, objective="ratio")):
            margins = search(text)["margins"]
            self.assertEqual([margins[key] for key in ("mounting", "thickness_series", "profile_shift", "sliding_max")],
                             ["tight", "cd25", [-1, 1], 3])

    def test_how_to_leave_them(self):
        margins = search(drawn(mounting="extended", sliding_max=5, profile_shift=[-0.5, 1.5], tip_clearance_min=0.15))["margins"]
        self.assertEqual([margins[key] for key in ("mounting", "thickness_series", "profile_shift", "sliding_max", "tip_clearance_min")],
                         ["extended", None, [-0.5, 1.5], 5, 0.15])
        self.assertIsNone(search(drawn(thickness_series="none"))["margins"]["thickness_series"])
        self.assertNotIn("mounting", search(drawn(face_width_mm=40, interference="flag"))["margins"])
        # The key mounting alone gives the nominal teeth of the theory.
        plain = {"ratio": 3, "modules_mm": 2, "pinion_teeth": [17, 19]}
        for mounting in ("tight", "extended"):
            for keys in ({}, {"face_width_mm": 20}):
                self.assertNotIn("mounting", search(spec(plain | keys, mounting=mounting))["margins"])


class Refused(Asked):
    def no(self, text, key, *words):
        run = Run("search", text, "--json", folder=folder())
        self.assertEqual(run.status, 1, run.out[:300])
        self.assertEqual(run.json["error"]["key"], f"search.{key}", run.err)
        for word in words:
            self.assertIn(word, run.json["error"]["message"])

    def test_by_key(self):
        plain = {"ratio": 3, "modules_mm": 2, "pinion_teeth": [17, 19]}
        self.no(spec(plain, face_width_mm=[10, 20]), "face_width_mm", "safety_flank_min", "overlap_ratio_min")
        self.no(spec(plain, face_width_mm=[20, 10]), "face_width_mm", "empty band")
        self.no(spec(plain, thickness_series="cd99"), "thickness_series")
        self.no(spec(plain, thickness_series="cd25", backlash_mm=0.1), "backlash_mm", "thickness_series")
        self.no(spec(plain, thickness_series="cd25", interference="flag"), "thickness_series", "exclude")
        self.no(spec(plain, thickness_series="cd25", shift_step=0.1), "thickness_series", "shift_step")
        self.no(spec(plain, center_distance_tolerance="H7"), "center_distance_tolerance", "JS")
        self.no(spec(plain, backlash_mm=0.1, shaft_angle_deg=90, helix_angle_deg=45), "backlash_mm", "crossed axes")
        self.no(spec(plain, face_width_modules=[8, 12], overlap_ratio_min=0, shaft_angle_deg=90, helix_angle_deg=45),
                "face_width_modules", "crossed axes")


class LongDrawnSearches(Drawn):
    def test_fifty_random_wishes(self):
        rng = random.Random(35)
        listed = 0
        for n in range(50):
            i = rng.uniform(1.2, 6)
            a = rng.choice([50, 63, 80, 100, 112, 125, 160, 200])
            torque = rng.uniform(0.02, 0.3) * (a / 10) ** 3
            keys = {"ratio": [i * 0.97, i * 1.03], "center_distance_mm": a, "helix_angle_deg": rng.choice([0, 8, 12, 15, 20]),
                    "helix_step_deg": None, "face_width_mm": [10, 100], "safety_flank_min": rng.choice([1.0, 1.2, 1.4]),
                    "safety_root_min": rng.choice([1.2, 1.6, 2.0]), "objective": rng.choice(["mass", "safety", "contact_ratio"])}
            if rng.random() < 0.3:
                keys["backlash_mm"] = [0.05, 0.2]
            if rng.random() < 0.5:
                keys["center_distance_tolerance"] = "JS7"
            load = LOAD.replace("power_kW = 11", f"torque_Nm = {torque:.4g}").replace("quality = 6", f"quality = {rng.randint(4, 8)}")
            text = drawn(STEEL + load, **keys)
            found = search(text)
            count = len(found["designs"])
            for rank in sorted({1, 2, count // 2, count} & set(range(1, count + 1))):
                with self.subTest(wish=n, rank=rank):
                    self.is_as_listed(text, found, rank)
                    listed += 1
        self.assertGreater(listed, 50)


if __name__ == "__main__":
    unittest.main()
