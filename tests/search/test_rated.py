"""Tests searches that rate their designs. Every listed design satisfies the limits, also according to the
verb rate.

    taken      the verb rate gives every listed design the safeties and the mass of its row
    limits     designs below a required safety are rejected, and the result contains their number under its
               name
    order      designs are sorted by mass, by safety, or by both
    nothing    if no design is feasible, the search lists the safest design and changes that would help
    refused    errors by key: no [rating], no material, a spectrum, crossed axes
"""
import csv
import io
import json
import math
import unittest

from searching import Asked, Run, duckdb, folder, search, spec

BANDS = {"ratio": [2, 3], "modules_mm": [2, 2.5], "pinion_teeth": [17, 26], "center_distance_mm": [80, 90],
         "face_width_modules": 10}
STEEL = '[gear1.material]\nname = "18CrNiMo7-6"\n'
LOAD = """[rating]
power_kW = 20
speed_rpm = 1480
application_factor = 1.25
life_h = 20000
lubricant_viscosity_40C_mm2_s = 220
quality = 6
flank_roughness_um = 4
root_roughness_um = 16
face_load_factor = 1.2
"""
SAFE = {"safety_flank_min": 1.0, "safety_root_min": 1.4}
HELICAL = {"helix_angle_deg": [8, 16], "helix_step_deg": 8}
RING = {"ratio": [-4, -3], "modules_mm": [2], "pinion_teeth": [17, 19], "center_distance_mm": [36, 42], "face_width_modules": 10,
        "safety_flank_min": 0.3, "safety_root_min": 0.3}


def rated(after=STEEL + LOAD, **keys):
    return spec(BANDS | SAFE | keys, after)


class Taken(unittest.TestCase):
    def feed_back(self, text, least):
        found = search(text)
        self.assertGreaterEqual(len(found["designs"]), least)
        for rank, design in enumerate(found["designs"], 1):
            take = Run("search", text, "--take", rank, folder=folder())
            self.assertEqual(take.status, 0, take.err)
            rate = Run("rate", take.out, "--json", folder=take.folder, name="pair.toml")
            self.assertEqual(rate.status, 0, rate.err)
            for key in ("S_H", "S_F"):
                for got, want in zip(design[key], rate.json["rating"][key]):
                    self.assertAlmostEqual(got, want, delta=1e-12 * want, msg=f"{rank} {key}")
            gears = Run("gear", take.out, "--json", folder=take.folder, name="pair.toml").json["gears"]
            mass = 0
            for gear, width in zip(gears, self.widths(take.out)):
                mean, outside = (gear["tip_diameter_mm"] + gear["root_diameter_mm"]) / 2, 0
                if gear["teeth"] < 0:
                    outside = gear["root_diameter_mm"] + 5 * gear["normal_module_mm"]
                mass += 7.83e-6 * width * math.pi / 4 * abs(mean**2 - outside**2)
            self.assertAlmostEqual(design["mass_kg"], mass, delta=1e-12 * mass)
        return found

    @staticmethod
    def widths(text):
        import tomllib
        made = tomllib.loads(text) if not text.lstrip().startswith("{") else json.loads(text)
        return [made[g]["face_width_mm"] for g in ("gear1", "gear2")]

    def test_spur(self):
        self.feed_back(rated(), 5)

    def test_helical_by_modules(self):
        self.feed_back(rated(**HELICAL, face_width_modules=12, pinion_teeth=[20, 22]), 5)

    def test_tight_with_shortened_tips_and_mounting(self):
        after = STEEL + LOAD.replace("face_load_factor = 1.2\n", "") + (
            "rim_thickness_mm = 8\nweb_thickness_mm = 9\n"
            "[rating.mounting]\nbearing_span_mm = 120\npinion_offset_mm = 10\nshaft_diameter_mm = 30\n")
        self.feed_back(rated(after, mounting="tight", shorten_tips=True, pinion_teeth=[20, 23]), 3)

    def test_two_materials_and_interference(self):
        after = STEEL + '[gear2.material]\nname = "42CrMo4"\ndensity_kg_per_m3 = 7830\n' + LOAD
        self.feed_back(rated(after, interference="flag", undercut_margin=-0.2, pinion_teeth=[14, 17], ratio=[2, 2.2],
                             center_distance_mm=[40, 90], safety_flank_min=0.2, safety_root_min=0.2), 5)

    def test_internal(self):
        self.feed_back(rated(**RING), 3)


class Listed(unittest.TestCase):
    def test_limits_take_away_and_are_counted(self):
        # The designs are not drawn. Otherwise the verdict would reject more of them.
        every = search(rated(safety_flank_min=None, safety_root_min=None, objective="safety", interference="flag"))
        some = search(rated(interference="flag"))
        keeps = [d for d in every["designs"] if min(d["S_H"]) >= 1.0 and min(d["S_F"]) >= 1.4]
        self.assertEqual(sorted((d["module_mm"], *d["teeth"]) for d in keeps),
                         sorted((d["module_mm"], *d["teeth"]) for d in some["designs"]))
        gone = some["rejected"]["safety_flank"] + some["rejected"]["safety_root"]
        self.assertEqual(gone, len(every["designs"]) - len(keeps))
        self.assertGreater(gone, 0)
        self.assertEqual(some["margins"]["safety_flank_min"], 1.0)
        self.assertNotIn("safety_flank", search(spec(BANDS))["rejected"])
        self.assertNotIn("S_H", search(spec(BANDS))["designs"][0])

    def test_order(self):
        def balanced(found):
            return [d for d in found["designs"] if d["point"] == "eq11"]
        masses = [d["mass_kg"] for d in balanced(search(rated(objective="mass")))]
        self.assertEqual(masses, sorted(masses))
        safe = balanced(search(rated(objective="safety")))
        worth = [min(min(d["S_H"]) / 1.0, min(d["S_F"]) / 1.4) for d in safe]
        self.assertEqual(worth, sorted(worth, reverse=True))
        for d, w in zip(safe, worth):
            self.assertAlmostEqual(d["objective"], w, delta=1e-15 * w)
        both = search(rated(objective=["mass", "safety"]))
        self.assertGreater(len(both["pareto"]), 1)
        light = search(spec(BANDS | {"objective": "mass"}))
        self.assertIn("mass_kg", light["designs"][0])
        self.assertNotIn("S_H", light["designs"][0])

    def test_default_face_load_factor(self):
        bare = LOAD.replace("face_load_factor = 1.2\n", "")
        found = search(rated(STEEL + bare, safety_flank_min=0.7))
        self.assertEqual(found.pop("face_load_factor"), 1.4)
        self.assertEqual(found, search(rated(STEEL + bare + "face_load_factor = 1.4\n", safety_flank_min=0.7)))
        run = Run("search", rated(STEEL + bare, safety_flank_min=0.7), folder=folder())
        self.assertIn("K_Hβ = 1.4 is a default. Give face_load_factor or [rating.mounting]", run.out)
        take = Run("search", rated(STEEL + bare, safety_flank_min=0.7), "--take", 1, folder=folder())
        self.assertIn("face_load_factor = 1.4", take.out)
        self.assertIn("face_load_factor_assumed = true", take.out)
        rate = Run("rate", take.out, folder=take.folder, name="pair.toml")
        self.assertEqual(rate.status, 0)
        self.assertRegex(rate.out, r"K_Hβ +1\.4000 +default of a search, not given by the user\n")
        own = take.out.replace("face_load_factor_assumed = true\n", "")
        self.assertRegex(Run("rate", own, folder=take.folder, name="own.toml").out, r"K_Hβ +1\.4000 +given by the user\n")

    def test_factors_that_are_1_by_default(self):
        self.assertEqual(search(rated())["assumed_factors"], {"K_gamma": 1})
        bare = "".join(line for line in (STEEL + LOAD).splitlines(True)
                       if not line.startswith(("application", "lubricant", "flank_r", "root_r")))
        self.assertEqual(search(rated(bare, safety_flank_min=0.7))["assumed_factors"],
                         dict.fromkeys(("K_A", "K_gamma", "Z_L", "Z_R", "Y_R_relT"), 1))
        words = " ".join(Run("search", rated(bare, safety_flank_min=0.7), folder=folder()).out.split())
        self.assertIn("K_A, K_γ, Z_L, Z_R and Y_RrelT are 1 by default. Give application_factor, mesh_load_factor, "
                      "lubricant_viscosity_40C_mm2_s, flank_roughness_um and root_roughness_um in [rating].", words)
        self.assertNotIn("assumed_factors", search(spec(BANDS)))

    def test_safeties_of_the_rating_count(self):
        here = search(rated(STEEL + LOAD + "safety_flank_min = 1.1\n", safety_flank_min=None))
        self.assertEqual(here["margins"]["safety_flank_min"], 1.1)
        self.assertTrue(all(min(d["S_H"]) >= 1.1 for d in here["designs"]))

    def test_listing_and_files(self):
        run = Run("search", rated(objective="mass"), "--out", "found", folder=folder())
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("rated by ISO 6336:2006", run.out)
        self.assertIn("face width 10 modules, S_H ≥ 1, S_F ≥ 1.4", " ".join(run.out.split()))
        self.assertRegex(run.out, r" kg\n")
        found = json.loads((run.folder / "found/search.json").read_text())["search"]
        rows = list(csv.DictReader(io.StringIO((run.folder / "found/best.csv").read_text())))
        self.assertEqual(len(rows), len(found["designs"]))
        columns = set(rows[0])
        self.assertEqual(columns - set(self.plain_columns()), {"face_width_mm", "S_H1", "S_H2", "S_F1", "S_F2", "mass_kg"})
        table = duckdb(run.folder / "found/search.parquet", "select S_H1, S_F2, mass_kg, face_width_mm from data order by mass_kg")
        masses = sorted(d["mass_kg"] for d in found["designs"])
        self.assertEqual([row["mass_kg"] for row in table], masses)
        for row, design in zip(rows, found["designs"]):
            self.assertEqual(float(row["face_width_mm"]), design["face_width_mm"])
            self.assertEqual(design["face_width_mm"], 10 * design["module_mm"])
            self.assertEqual([float(row["S_H1"]), float(row["S_H2"])], design["S_H"])
            self.assertEqual([float(row["S_F1"]), float(row["S_F2"])], design["S_F"])
            self.assertEqual(float(row["mass_kg"]), design["mass_kg"])
        page = (run.folder / "found/report.html").read_text()
        self.assertIn("safety against pitting of gear 1", page)
        self.assertIn("mass of both gears", page)
        self.assertIn("Designs are rated by ISO 6336:2006, ", page)

    @staticmethod
    def plain_columns():
        run = Run("search", spec(BANDS), "--out", "found", folder=folder())
        return (run.folder / "found/best.csv").read_text().splitlines()[0].split(",")

    def test_a_campaign_is_the_search(self):
        run = Run("search", rated(), "--out", "parts", "--chunk", 7, folder=folder())
        self.assertEqual(run.status, 0, run.err)
        whole = Run("search", rated(), "--out", "whole", folder=folder())
        for name in ("search.json", "best.csv", "search.parquet"):
            self.assertEqual((run.folder / "parts" / name).read_bytes(), (whole.folder / "whole" / name).read_bytes(), name)
        changed = Run("search", rated(STEEL + LOAD.replace("power_kW = 20", "power_kW = 21")), "--out", "parts", "--chunk", 7,
                      "--resume", folder=run.folder)
        self.assertEqual(changed.status, 1)
        self.assertIn("power_kW", changed.err)

    def test_not_read(self):
        run = Run("search", spec(BANDS, STEEL + LOAD), "--json", folder=folder())
        self.assertEqual([w["code"] for w in run.json["warnings"]], ["not_read"])
        self.assertIn("safety_flank_min", run.json["warnings"][0]["message"])


class Nothing(Asked):
    HEAVY = LOAD.replace("power_kW = 20", "power_kW = 50")

    def test_safest_and_changes(self):
        text = rated(STEEL + self.HEAVY)
        found = search(text)
        self.assertEqual(found["feasible_count"], 0)
        safest = found["safest"]
        self.assertLess(min(min(safest["S_H"]), min(safest["S_F"]) / 1.4), 1)
        changes = {c["key"]: c for c in found["changes"]}
        self.assertIn("rating.power_kW", changes)
        self.assertIn("search.face_width_modules", changes)
        for key, change in changes.items():
            to = json.loads(change["to"]) if change["to"][0] in "[0123456789-tf" else change["to"].strip('"')
            table, name = key.rsplit(".", 1)
            with self.subTest(key=key):
                if table == "search":
                    self.assertGreater(search(rated(STEEL + self.HEAVY, **{name: to}))["feasible_count"], 0)
                elif key == "rating.power_kW":
                    lighter = LOAD.replace("power_kW = 20", f"power_kW = {to}")
                    self.assertGreater(search(rated(STEEL + lighter))["feasible_count"], 0)
                    more = LOAD.replace("power_kW = 20", f"power_kW = {50 - 0.9 * (50 - to)}")
                    self.assertEqual(search(rated(STEEL + more))["feasible_count"], 0)

    def test_one_safety_is_its_own_change(self):
        # The designs are not drawn. Otherwise the gears with the thinnest teeth would also need the required
        # safeties.
        found = search(rated(STEEL + self.HEAVY, safety_root_min=None, interference="flag"))
        reach = [c for c in found["changes"] if c["key"] == "search.safety_flank_min"]
        best = max(min(d["S_H"]) for d in
                   search(rated(STEEL + self.HEAVY, safety_root_min=None, safety_flank_min=None, objective="safety",
                                interference="flag"))["designs"])
        self.assertAlmostEqual(float(reach[0]["to"]), best, delta=1e-3)
        self.assertLessEqual(float(reach[0]["to"]), best)

    def test_a_better_steel(self):
        soft = '[gear1.material]\nname = "42CrMo4"\n'
        self.assertEqual(search(rated(soft + LOAD))["feasible_count"], 0)
        steels = [c for c in search(rated(soft + LOAD))["changes"] if c["key"] == "gear1.material.name"]
        self.assertEqual([c["from"] for c in steels], ['"42CrMo4"'])
        better = f'[gear1.material]\nname = {steels[0]["to"]}\n'
        self.assertGreater(search(rated(better + LOAD))["feasible_count"], 0)

    def test_the_lowest_safety_rejects_a_drawing(self):
        # Both safeties are less than 1. The verdict lists the lower one first, here that of the flanks. Regression: the search
        # named the safety of the roots, as its code comes first.
        found = search(spec({"ratio": [2.5, 2.5], "modules_mm": [2], "pinion_teeth": [20, 20], "face_width_mm": 20, "helix_angle_deg": 12,
                             "center_distance_mm": [70, 75], "thickness_series": "cd25", "objective": "safety"},
                            STEEL + LOAD.replace("power_kW = 20", "power_kW = 25")))
        self.assertLess(min(found["safest"]["S_H"]), min(found["safest"]["S_F"]))
        self.assertEqual(found["rejected_by_finding"], {"flank_safety": 1})
        self.assertIn("against pitting", found["safest_finding"])

    def test_the_finding_that_rejects_the_safest_design(self):
        # The safeties are sufficient, but the least centre distance is smaller than the backlash-free one.
        text = spec({"ratio": [2.5, 2.5], "modules_mm": [2], "pinion_teeth": [20, 20], "face_width_mm": 20, "helix_angle_deg": 12,
                     "safety_flank_min": 1, "safety_root_min": 1, "thickness_series": "h21", "center_distance_tolerance": "JS11"},
                    STEEL + LOAD.replace("power_kW = 20", "power_kW = 8"))
        found = search(text)
        self.assertEqual((found["feasible_count"], found["rejected"]["verdict"]), (0, 1))
        self.assertEqual(found["rejected_by_finding"], {"negative_backlash": 1})
        self.assertGreater(min(found["safest"]["S_H"] + found["safest"]["S_F"]), 1)
        self.assertIn("The backlash is negative", found["safest_finding"])
        words = " ".join(Run("search", text, folder=folder()).out.split())
        self.assertIn("The verdict on its drawing rejects it: " + found["safest_finding"], words)
        impossible = text.replace('thickness_series = "h21"', "backlash_mm = [0, 0.001]")
        found = search(impossible)
        self.assertEqual((found["rejected"]["verdict"], found["rejected_by_finding"]), (1, {}))
        self.assertIn("The pair cannot be drawn. pair.backlash_mm: the range is too narrow", found["safest_finding"])
        self.assertIn("a pair that cannot be drawn or rated: 1", Run("search", impossible, folder=folder()).out)
        self.assertNotIn("safest_finding", search(rated(STEEL + self.HEAVY)))

    def test_a_key_with_two_limits_is_named_once(self):
        text = spec({"ratio": [3.087, 3.213], "center_distance_mm": 125, "helix_angle_deg": [8, 20], "overlap_ratio_min": 1,
                     "safety_flank_min": 1.89, "safety_root_min": 1.6, "objective": "balance"},
                    '[gear1]\nrack = "ISO53-D"\n' + STEEL + "[rating]\npower_kW = 11\nspeed_rpm = 1450\nlife_h = 20000\n"
                    "quality = 6\n[rating.mounting]\nbearing_span_mm = 120\npinion_offset_mm = 20\nshaft_diameter_mm = 35\n")
        words = " ".join(Run("search", text, folder=folder()).out.split())
        self.assertIn("ended after 300 trials for each key", words)
        self.assertEqual(words.count("`search.profile_shift`"), 1)
        # The nominal teeth of this design have the required safeties, but not its thinnest teeth.
        self.assertRegex(words, r"S_H = 1\.891 and S_F = 3\.178 with nominal teeth\. The verdict on its drawing rejects it: ")

    def test_in_words(self):
        run = Run("search", rated(STEEL + self.HEAVY), folder=folder())
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("The safest rejected design ", run.out)
        self.assertIn("rating.power_kW = ", run.out)


class Refused(Asked):
    def no(self, text, key, *words):
        run = Run("search", text, "--json", folder=folder())
        self.assertEqual(run.status, 1, run.out[:300])
        self.assertEqual(run.json["error"]["key"], key, run.err)
        for word in words:
            self.assertIn(word, run.json["error"]["message"])

    def test_by_key(self):
        self.no(rated(STEEL), "search.safety_flank_min", "[rating]", "[gear1.material]")
        self.no(rated(STEEL, safety_flank_min=None), "search.safety_root_min", "[rating]")
        self.no(rated(STEEL, safety_flank_min=None, safety_root_min=None, objective="safety"), "search.objective", "[rating]")
        self.no(rated(LOAD), "gear1.material", "is missing")
        self.no(rated(STEEL.replace("18CrNiMo7-6", "18CrNiMo7-5") + LOAD), "gear1.material.name", "did you mean")
        self.no(rated(STEEL + '[gear2.material]\nkind = "plastic"\nsigma_Hlim_MPa = 40\nsigma_Flim_MPa = 20\n' + LOAD),
                "gear2.material.kind", "VDI 2736")
        for line, key in (("quality = 6\n", "rating.quality"), ("power_kW = 20\n", "rating.torque_Nm")):
            self.no(rated(STEEL + LOAD.replace(line, "")), key, "is missing")
        # All values are missing. Gear 2 has the material of gear 1, so the message lists only that of gear 1.
        self.no(rated("[rating]\n"), "rating.torque_Nm", "gear1.material (", "rating.quality (", "rating.speed_rpm (")
        self.no(rated(STEEL + LOAD, safety_flank_min=0), "search.safety_flank_min", "0")
        self.no(rated(STEEL + LOAD, safety_flank_min="high"), "search.safety_flank_min")
        self.no(rated(STEEL + LOAD, shift_step=0.05), "search.safety_flank_min", "shift_step")
        self.no(rated(STEEL + LOAD, shaft_angle_deg=90, helix_angle_deg=45), "search.safety_flank_min", "parallel axes")
        spectrum = LOAD.replace("life_h = 20000\n", "").replace("power_kW = 20\n", "") + (
            "[[rating.spectrum]]\ntorque_Nm = 100\nspeed_rpm = 1480\nduration_h = 100\n")
        self.no(rated(STEEL + spectrum), "search.safety_flank_min", "spectrum")
        self.no(rated(STEEL + LOAD, face_width_mm=20, face_width_modules=10), "search.face_width_modules", "face_width_mm")


class Wish(unittest.TestCase):
    """The shortest search that a designer would type: a ratio, a housing, a load and two safeties."""
    WISH = {"ratio": [3.087, 3.213], "center_distance_mm": 125, "safety_flank_min": 1.3, "safety_root_min": 1.6,
            "objective": "mass"}

    def test_absent_keys_are_the_usual_ones(self):
        usual = {"modules_mm": "ISO54-I", "pinion_teeth": [12, 40], "face_width_diameters": [0.2, 1]}
        found = search(spec(self.WISH, STEEL + LOAD))
        self.assertEqual(found, search(spec(self.WISH | usual, STEEL + LOAD)))
        self.assertGreaterEqual(found["feasible_count"], 10)

    def test_every_design_runs_and_is_no_wider_than_needed(self):
        text = spec(self.WISH, STEEL + LOAD)
        for rank, design in enumerate(search(text)["designs"][:6], 1):
            take = Run("search", text, "--take", rank, folder=folder())
            pair = Run("pair", take.out, "--json", folder=take.folder, name="pair.toml")
            self.assertEqual(pair.json["verdict"]["level"], "green", take.out)
            rate = Run("rate", take.out, "--json", folder=take.folder, name="pair.toml").json
            self.assertGreaterEqual(min(rate["rating"]["S_H"]), 1.3)
            self.assertGreaterEqual(min(rate["rating"]["S_F"]), 1.6)
            gear = pair.json["gears"][0]
            self.assertLessEqual(0.2, gear["face_width_mm"] / gear["reference_diameter_mm"])
            self.assertLessEqual(gear["face_width_mm"] / gear["reference_diameter_mm"], 1)


if __name__ == "__main__":
    unittest.main()
