"""Tests the verb rate as a user calls it: the documented keys, a published report, errors by key, verdict
and remedies, and the agreement of JSON, CSV and listing."""

import csv
import io
import tempfile
import unittest

from cli import SOURCE, Run

HEAD = """[gear1]
teeth = 24
normal_module_mm = 14
helix_angle_deg = 10
profile_shift = 0.48
face_width_mm = 360
tip_diameter_mm = 380.747
{material1}
[gear2]
teeth = 95
profile_shift = 0.6691
face_width_mm = 360
tip_diameter_mm = 1395.376
{material2}
[pair]
center_distance_mm = 861
"""
STEEL = """[gear{n}.material]
kind = "case_hardened"
sigma_Hlim_MPa = 1500
sigma_Flim_MPa = 430
"""
RATING = """[rating]
power_kW = 5000
speed_rpm = 1165.9
application_factor = 1.25
face_load_factor = 1.15
life_h = 175200
lubricant_viscosity_40C_mm2_s = 220
quality = [6, 6]
flank_roughness_um = [4.8, 4.8]
root_roughness_um = [20, 20]
"""


def spec(rating=RATING, material1=STEEL.format(n=1), material2=STEEL.format(n=2)):
    return HEAD.format(material1=material1, material2=material2) + rating


class Rate(unittest.TestCase):
    def rated(self, text):
        run = Run("rate", text, "--json")
        self.assertEqual(run.status, 0, run.err)
        return run.json["rating"]

    def test_shafts_determine_the_face_load_factor(self):
        own = RATING.replace("face_load_factor = 1.15\n", "")
        shaft = "[gear1.shaft]\nbearings_mm = [-300, 420]\ndiameter_mm = 250\n"
        rigid = self.rated(spec(own + "misalignment_um = 20\n" + shaft.replace("250", "250000")))
        self.assertAlmostEqual(rigid["F_betax_um"], 1.33 * rigid["f_sh_um"] + 20, places=6)
        soft = self.rated(spec(own + "misalignment_um = 20\n" + shaft))
        self.assertAlmostEqual(soft["F_betax_um"], 1.33 * soft["f_sh_um"] + 20, places=6)
        self.assertGreater(soft["K_Hbeta"], rigid["K_Hbeta"])
        self.assertEqual(self.rated(spec(RATING + shaft))["K_Hbeta"], 1.15)

    def test_shafts_that_are_impossible(self):
        own = RATING.replace("face_load_factor = 1.15\n", "")
        good = "[gear1.shaft]\nbearings_mm = [-300, 420]\ndiameter_mm = 250\n"
        mounting = "[rating.mounting]\nbearing_span_mm = 720\nshaft_diameter_mm = 250\n"
        for text, key, word in [
                (good.replace("-300", "420"), "gear1.shaft.bearings_mm", "must be in rising order"),
                (good + "steps_mm = [0]\n", "gear1.shaft.steps_mm", "list of diameters"),
                (good.replace("250", "[250, 200]"), "gear1.shaft.steps_mm", "one entry fewer"),
                (good.replace("250", "[250, 200, 150]") + "steps_mm = [50, 0]\n", "gear1.shaft.steps_mm", "must be in rising order"),
                (good.replace("250", "-250"), "gear1.shaft.diameter_mm", "greater than 0"),
                (good + mounting, "gear1.shaft", "rating.mounting")]:
            with self.subTest(key=key, word=word):
                self.refused(spec(own + text), key, word)

    def refused(self, text, key, word):
        run = Run("rate", text, "--json")
        self.assertEqual(run.status, 1, run.out[:200])
        self.assertEqual(run.json["error"]["key"], key)
        self.assertIn(word, run.json["error"]["message"])

    def test_report(self):
        r = self.rated(spec())
        # The report rounds the speed to 1165.9. Half a unit of its last digit changes the force by 10.3 N.
        self.assertAlmostEqual(r["F_t_N"], 240064.4, delta=10.3)
        self.assertAlmostEqual(r["sigma_H0_MPa"], 570.79, delta=0.02)
        for got, want in zip(r["S_H"], (1.81, 1.88)):
            # The wheels of the report have a web, which is ignored here.
            self.assertAlmostEqual(got, want, delta=0.03)
        self.assertEqual(r["formulas"]["Z_epsilon"]["branch"], "helical, ε_β ≥ 1")

    def test_every_key_of_the_interface(self):
        r = self.rated(spec())
        keys = """F_t_N v_m_per_s K_A K_v K_Hbeta K_Fbeta K_Halpha K_Falpha c_th_prime c_prime c_gamma_alpha c_gamma_beta
            n_E1_rpm N Z_H Z_B Z_D Z_E Z_epsilon Z_beta Z_NT Z_L Z_v Z_R Z_W Z_X sigma_H0_MPa sigma_H_MPa sigma_HG_MPa S_H Y_F
            Y_S Y_beta Y_B Y_DT Y_NT Y_delta_relT Y_R_relT Y_X h_F_mm s_Fn_mm rho_F_mm alpha_Fen_deg d_en_mm sigma_F0_MPa
            sigma_F_MPa sigma_FG_MPa S_F formulas""".split()
        for key in keys:
            self.assertIn(key, r)
        for key in keys[:-1]:
            if not key.endswith("_mm") and key != "alpha_Fen_deg":
                self.assertIn(key, r["formulas"], key)
                self.assertIn("formula", r["formulas"][key])

    def test_power_and_torque_are_one_load(self):
        by_power = self.rated(spec())
        torque = by_power["torque_Nm"][0]
        by_torque = self.rated(spec(RATING.replace("power_kW = 5000", f"torque_Nm = {torque!r}")))
        self.assertEqual(by_power, by_torque)
        both = RATING.replace("power_kW = 5000", f"power_kW = 5000\ntorque_Nm = {torque!r}")
        self.assertEqual(self.rated(spec(both)), by_power)

    def test_named_material(self):
        named = '[gear{}.material]\nname = "18CrNiMo7-6"\n'
        a = self.rated(spec(material1=named.format(1), material2=named.format(2)))
        b = self.rated(spec())
        self.assertEqual(a["S_F"], b["S_F"])

    def test_bad_input_by_key(self):
        without = lambda line: "\n".join(x for x in RATING.splitlines() if not x.startswith(line)) + "\n"
        self.refused(spec(without("power_kW")), "rating.torque_Nm", "is missing")
        self.refused(spec(RATING.replace("power_kW = 5000", "power_kW = 5000\ntorque_Nm = 40000")), "rating.torque_Nm", "contradicts power_kW")
        self.refused(spec(without("speed_rpm")), "rating.power_kW", "speed_rpm")
        self.refused(spec(RATING.replace("speed_rpm = 1165.9", "speed_rpm = 0")), "rating.speed_rpm", "greater than 0")
        by_torque = without("speed_rpm").replace("power_kW = 5000", "torque_Nm = 40953").replace("life_h = 175200\n", "")
        self.refused(spec(by_torque), "rating.speed_rpm", "dynamic factor")
        self.assertIsNone(self.rated(spec(by_torque + "dynamic_factor = 1.1\n"))["N"])
        self.refused(spec(RATING.replace("[6, 6]", "[6, 13]")), "rating.quality", "between 0 and 12")
        self.refused(spec(RATING.replace("[6, 6]", "[6, 6.5]")), "rating.quality", "whole")
        coarse = RATING.replace("[6, 6]", "[6, 12]")
        self.rated(spec(coarse))
        self.refused(spec(coarse + 'standard = "ISO 6336:2019"\n'), "rating.quality", "1 to 11")
        self.refused(spec(without("quality")), "rating.quality", "is missing")
        self.refused(spec(without("face_load_factor")), "rating.face_load_factor", "mounting")
        self.refused(spec(RATING.replace("life_h", "live_h")), "rating.live_h", "life_h")
        self.refused(spec(material1='[gear1.material]\nname = "18CrNiMo7-5"\n'), "gear1.material.name", "18CrNiMo7-6")
        for plastic in ("POM", "pa66-GF30", "Delrin 500", "PEEK"):
            self.refused(spec(material1=f'[gear1.material]\nname = "{plastic}"\n'), "gear1.material.name", "VDI 2736")
        self.refused(spec(material1=""), "gear1.material", "is missing")
        # Gear 2 has the material of gear 1.
        self.assertEqual(self.rated(spec(material2="")), self.rated(spec()))
        self.refused(spec(material1='[gear1.material]\nname = "42CrMo4"\nsurface_hardness_HV = 900\n'),
                     "gear1.material.surface_hardness_HV", "outside the range")
        self.refused(spec(""), "rating", "is missing")
        plastic = '[gear1.material]\nkind = "plastic"\nsigma_Hlim_MPa = 50\nsigma_Flim_MPa = 30\n'
        self.refused(spec(material1=plastic), "gear1.material.kind", "VDI 2736")

    def test_all_that_is_missing_is_said_at_once(self):
        gears = "[gear1]\nteeth = 20\nnormal_module_mm = 2\n[gear2]\nteeth = 40\n"
        lines = {"rating.torque_Nm": "torque_Nm = 50", "rating.speed_rpm": "speed_rpm = 1500",
                 "rating.quality": "quality = 6", "rating.face_load_factor": "face_load_factor = 1.2"}
        materials = "".join(f'[gear{n}.material]\nname = "16MnCr5"\n' for n in (1, 2))
        run = Run("rate", gears + "[rating]\n", "--json")
        self.assertEqual((run.status, run.json["error"]["key"]), (1, "rating.torque_Nm"))
        for word in (*lines.values(), *list(lines)[1:], "gear1.material", "gear2.material"):
            self.assertIn(word, run.json["error"]["message"])
        # If [rating] is missing, the message lists its required keys. With these keys, the rating is
        # computed.
        for line in (*lines.values(), 'name = "16MnCr5"'):
            self.refused(gears, "rating", line)
        self.rated(gears + materials + "\n".join(["[rating]", *lines.values()]))
        # If a key is given, the message does not list it. The key of the error is the first missing one.
        for key, line in lines.items():
            rest = [other for other in lines if other != key]
            run = Run("rate", gears + f"[rating]\n{line}\n", "--json")
            message = run.json["error"]["message"]
            self.assertEqual(run.json["error"]["key"], "gear1.material" if key == "rating.torque_Nm" else "rating.torque_Nm")
            for other in rest[1:] if key != "rating.torque_Nm" else rest:
                self.assertIn(other, message)
            self.assertNotIn(f"{key} (", message)

    def test_verdict_has_remedies_that_hold(self):
        heavy = RATING.replace("power_kW = 5000", "power_kW = 12000")
        run = Run("rate", spec(heavy + "safety_flank_min = 1.25\n"), "--json", "--strict")
        self.assertEqual(run.status, 4)
        finding = next(f for f in run.json["verdict"]["findings"] if f["code"] == "flank_safety")
        self.assertRegex(finding["remedy"], r"^\d+ mm more face width")
        more = int(finding["remedy"].split()[0])
        wider = spec(heavy).replace("face_width_mm = 360", f"face_width_mm = {360 + more}")
        self.assertGreaterEqual(min(self.rated(wider)["S_H"]), 1.25)

    def test_listing_and_csv_say_the_same(self):
        r = self.rated(spec())
        listing = Run("rate", spec()).out
        for word in ("S_F", "ISO 6336-1, 6.5.4, (13), (14): subcritical, N ≤ 0.85", f"{r['S_F'][0]:.3f}", f"{r['sigma_H0_MPa']:.2f}"):
            self.assertIn(word, listing)
        rows = {row["key"]: row for row in csv.DictReader(io.StringIO(Run("rate", spec(), "--csv").out))}
        self.assertEqual(float(rows["rating.S_H"]["second"]), r["S_H"][1])
        self.assertEqual(rows["rating.K_v"]["formula"], "ISO 6336-1, 6.5.4, (13), (14)")

    def test_accuracy_of_rating_and_drawing(self):
        def differs(quality):
            drawn = spec().replace("teeth = 24\n", f"teeth = 24\nquality = {quality}\n", 1)
            findings = Run("rate", drawn, "--json").json["verdict"]["findings"]
            return [(f["level"], f["message"]) for f in findings if f["code"] == "rating_quality"]

        self.assertEqual(differs(6), [])
        self.assertEqual(differs(7), [("amber", "The rating uses grade 6 for gear 1, but the drawing uses gear1.quality = 7.")])

    def test_editions_of_rating_and_drawing(self):
        """One note if the drawing has tolerances of another edition than the rating; none if it has no tolerances."""
        def noted(tolerance):
            drawn = spec().replace("teeth = 24\n", "teeth = 24\n" + tolerance, 1)
            with tempfile.TemporaryDirectory() as folder:
                run = Run("run", drawn, "--only", "report", "--json", "--out", folder)
            return [w["message"] for w in run.json["warnings"] if w["code"] == "tolerance_editions"]

        (note,) = noted("quality = 6\n")
        for word in ("ISO 1328-1:1995", "ISO 1328-1:2013", 'edition = "ISO 1328:1995"', 'standard = "ISO 6336:2019"'):
            self.assertIn(word, note)
        self.assertEqual(noted('tolerance = { quality = 6, edition = "ISO 1328:1995" }\n'), [])
        self.assertEqual(noted(""), [])

    def test_spectrum(self):
        step = "[[rating.spectrum]]\ntorque_Nm = {}\nspeed_rpm = 1165.9\nduration_h = {}\n"
        life = RATING.replace("life_h = 175200\n", "").replace("application_factor = 1.25\n", "")
        one = self.rated(spec(life + step.format(40952.7, 175200)))
        plain = self.rated(spec(life + "life_h = 175200\n"))
        for a, b in zip(one["S_H_spectrum"] + one["S_F_spectrum"], plain["S_H"] + plain["S_F"]):
            self.assertAlmostEqual(a, b, delta=1e-4)
        both = spec(life + "application_factor = 1.25\n" + step.format(250000, 1e-4) + step.format(20000, 1e5))
        run = Run("rate", both, "--json")
        lowest = run.json["rating"]["S_H_spectrum"][0]
        noted = [w["message"] for w in run.json["warnings"] if w["code"] == "spectrum_rated"]
        self.assertIn(f"with K_A = 1, the lowest safety factor is {lowest:.2f} against pitting", noted[0])
        self.assertIn("with K_A = 1.25", noted[0])
        listing = Run("rate", both).out
        self.assertIn("Spectrum, ISO 6336-6, with K_A = 1\n", listing)
        self.assertRegex(listing, r"damage of the flanks +U_H +\d\.\de-\d\d")
        weak = Run("rate", both.replace("[rating]\n", "[rating]\nsafety_flank_min = 9\n"), "--json")
        self.assertIn("spectrum_safety", [f["code"] for f in weak.json["verdict"]["findings"]])
        self.refused(spec(RATING + step.format(1, 1)), "rating.life_h", "spectrum")
        self.refused(spec(life + step.format(0, 1)), "rating.spectrum[1].torque_Nm", "greater than 0")

    def test_sizing(self):
        wanted = "safety_flank_min = 1.3\nsafety_root_min = 1.6\n"
        r = self.rated(spec(RATING + wanted))
        at = RATING.replace("power_kW = 5000", f"torque_Nm = {r['torque_holding_Nm']!r}")
        self.assertGreaterEqual(min(self.rated(spec(at))["S_H"]), 1.3 * (1 - 1e-9))
        wide = spec().replace("face_width_mm = 360", f"face_width_mm = {r['face_width_holding_mm']!r}")
        self.assertGreaterEqual(min(self.rated(wide)["S_H"]), 1.3)

    def test_example_holds(self):
        run = Run("rate", (SOURCE / "examples/rated_pair.toml").read_text(), "--json")
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual([f["code"] for f in run.json["verdict"]["findings"] if f["code"].endswith("_safety")], [])

    def test_the_pair_on_shafts_can_be_built(self):
        """Its backlash exceeds the recommendation of ISO/TR 10064-2 within its tolerances. The verdict has no finding."""
        run = Run("rate", (SOURCE / "examples/shaft_pair.toml").read_text(), "--json")
        self.assertEqual(run.json["verdict"]["findings"], [])
        pair = Run("pair", (SOURCE / "examples/shaft_pair.toml").read_text(), "--json").json["pair"]
        m_n, a = 4, pair["center_distance_mm"]
        self.assertGreater(min(pair["interval"]["backlash"]["normal_mm"]), 2 / 3 * (0.06 + 0.0005 * a + 0.03 * m_n))

    def test_later_edition(self):
        a, b = (self.rated(spec(RATING + f'standard = "ISO 6336:{year}"\n')) for year in (2006, 2019))
        self.assertNotEqual(a["Y_F"], b["Y_F"])
        self.assertEqual(b["standard"], "ISO 6336:2019")


CONTACT = """[gear1]
teeth = 25
normal_module_mm = 3
face_width_mm = 24
bore = { diameter_mm = 36 }
[gear1.material]
name = "18CrNiMo7-6"
[gear1.modifications]
tip_relief_um = 12
tip_relief_start_mm = 79.0
[gear2]
teeth = 43
face_width_mm = 24
bore = { diameter_mm = 60 }
[gear2.material]
name = "18CrNiMo7-6"
[gear2.modifications]
tip_relief_um = 12
tip_relief_start_mm = 133.0
[load]
torque_Nm = 1
positions = 8
slices = 8
accuracy = "draft"
[rating]
torque_Nm = 200
speed_rpm = 1000
application_factor = 1.25
quality = 6
face_load_factor = 1.0
"""


class Contact(unittest.TestCase):
    """Tests the rating together with loaded contact."""

    def test_beside_the_standard(self):
        r = Run("rate", CONTACT.replace("face_load_factor", "tooth_contact = true\nface_load_factor"), "--json").json["rating"]
        torque = 200 * 1.25 * r["K_v"]
        self.assertAlmostEqual(r["contact_torque_Nm"], torque, delta=1e-12 * torque)
        load = Run("load", CONTACT.replace("torque_Nm = 1\n", f"torque_Nm = {r['contact_torque_Nm']!r}\n", 1), "--json").json
        load = load["load"]["torques"][0]
        self.assertEqual(r["contact_pressure_MPa"], load["max_pressure_MPa"])
        self.assertEqual(r["contact_root_stress_MPa"], load["max_root_stress_MPa"])
        self.assertEqual(r["contact_face_load_factor"], load["face_load_factor"])
        self.assertAlmostEqual(load["c_gamma_alpha"], r["c_gamma_alpha"], delta=1e-12)
        self.assertEqual(load["stiffness_over_c_gamma_alpha"],
                         load["mesh_stiffness_without_twist_N_per_mm_um"]["mean"] / load["c_gamma_alpha"])
        for i in (0, 1):
            self.assertAlmostEqual(r["contact_pressure_over_sigma_H"][i], r["contact_pressure_MPa"] / r["sigma_H_MPa"][i], delta=1e-14)
            self.assertAlmostEqual(r["contact_root_stress_over_sigma_F"][i], r["contact_root_stress_MPa"][i] / r["sigma_F_MPa"][i], delta=1e-14)
            # Two independent methods for the same tooth must agree in magnitude.
            self.assertTrue(0.7 < r["contact_pressure_over_sigma_H"][i] < 1.5, r["contact_pressure_over_sigma_H"])
            self.assertTrue(0.5 < r["contact_root_stress_over_sigma_F"][i] < 1.5, r["contact_root_stress_over_sigma_F"])

    def test_rotations_do_not_replace_the_positions(self):
        wish = CONTACT.replace("face_load_factor", "tooth_contact = true\nface_load_factor")
        turned = wish.replace("positions = 8", "positions = 8\nrotation1_deg = [2.0]")
        self.assertEqual(*(Run("rate", spec, "--json").json["rating"] for spec in (wish, turned)))

    def test_only_where_asked(self):
        r = Run("rate", CONTACT, "--json").json["rating"]
        self.assertFalse([key for key in r if key.startswith("contact_")])
        text = Run("rate", CONTACT.replace("face_load_factor", "tooth_contact = true\nface_load_factor")).out
        self.assertIn("Additional computation of the teeth under load", text)
        self.assertIn("p_H/σ_H", text)

    def test_of_an_internal_pair(self):
        ring = CONTACT.replace("teeth = 43", "teeth = -67\ntip_diameter_mm = 196.5").replace("bore = { diameter_mm = 60 }\n", "")
        ring = ring[:ring.index("[gear2.modifications]")] + ring[ring.index("[load]"):]
        run = Run("rate", ring.replace("face_load_factor", "tooth_contact = true\nface_load_factor"), "--json")
        self.assertEqual(run.status, 0, run.out[:200])
        r = run.json["rating"]
        for i in (0, 1):
            self.assertTrue(0.7 < r["contact_pressure_over_sigma_H"][i] < 1.5, r["contact_pressure_over_sigma_H"])
            self.assertTrue(0.5 < r["contact_root_stress_over_sigma_F"][i] < 1.5, r["contact_root_stress_over_sigma_F"])


PLASTIC = """[gear1]
teeth = 17
normal_module_mm = 1
profile_shift = 0.2
face_width_mm = 8
[gear1.material]
name = "18CrNiMo7-6"
[gear2]
teeth = 39
profile_shift = 0.1
face_width_mm = 6
[gear2.material]
name = "a POM"
kind = "plastic"
poisson_ratio = 0.35
density_kg_per_m3 = 1410
temperatures_C = [20, 60, 100]
youngs_modulus_by_temperature_MPa = [2800, 1800, 1000]
sigma_Hlim_by_temperature_MPa = [60, 45, 30]
sigma_Flim_by_temperature_MPa = [40, 28, 16]
[rating]
standard = "VDI 2736:2014"
torque_Nm = 0.4
speed_rpm = 1500
application_factor = 1.25
[rating.plastic]
ambient_temperature_C = 23
friction_coefficient = 0.2
"""


class Plastic(unittest.TestCase):
    def refused(self, text, key, *words):
        run = Run("rate", text, "--json")
        self.assertEqual(run.status, 1, run.out[:200])
        self.assertEqual(run.json["error"]["key"], key, run.err)
        for word in words:
            self.assertIn(word, run.json["error"]["message"])

    def test_warm_teeth(self):
        run = Run("rate", PLASTIC, "--json")
        self.assertEqual(run.status, 0, run.err)
        r = run.json["rating"]
        self.assertEqual(r["standard"], "VDI 2736:2014")
        self.assertTrue(23 < r["root_temperature_C"][1] < r["flank_temperature_C"][1] < 100, r["flank_temperature_C"])
        self.assertEqual([r["flank_temperature_C"][0], r["sigma_Flim_MPa"]], [None, [430, None]])
        warm = r["root_temperature_C"][1]
        self.assertAlmostEqual(r["sigma_FG_MPa"][1], 2 * (40 - 12 * (warm - 20) / 40), delta=1e-9)
        self.assertAlmostEqual(r["S_F"][1], r["sigma_FG_MPa"][1] / r["sigma_F_MPa"][1], delta=1e-12)
        self.assertIsNone(r["c_prime"])
        self.assertEqual(r["Z_L"], [None, None])
        self.assertNotIn("Z_L", r["formulas"])
        self.assertIn("VDI 2736", r["formulas"]["S_F"]["formula"])
        self.assertIn("tip", str(r["formulas"]["Y_F"]["branch"]))
        self.assertIn("rating_plastic", [w["code"] for w in run.json["warnings"]])
        self.assertGreater(r["torque_holding_Nm"], 0)

    def test_given_temperatures(self):
        given = PLASTIC.replace("ambient_temperature_C = 23\nfriction_coefficient = 0.2",
                                "flank_temperature_C = [30, 40]\nroot_temperature_C = 40")
        r = Run("rate", given, "--json").json["rating"]
        self.assertEqual(r["flank_temperature_C"], [30, 40])
        self.assertEqual(r["sigma_FG_MPa"][1], 68)
        text = Run("rate", given).out
        self.assertIn("temperature of the roots", text)
        self.assertIn("Y_ε", text)

    def test_by_key(self):
        self.refused(PLASTIC.replace("torque_Nm = 0.4", "torque_Nm = 40"), "gear2.material.temperatures_C", "100 °C")
        self.refused(PLASTIC.replace("VDI 2736:2014", "ISO 6336:2006"), "rating.plastic", "VDI 2736")
        iso = PLASTIC.replace("VDI 2736:2014", "ISO 6336:2006")
        self.refused(iso[:iso.index("[rating.plastic]")], "gear2.material.kind", "VDI 2736:2014")
        self.refused(PLASTIC.replace("friction_coefficient = 0.2\n", ""), "rating.plastic.friction_coefficient", "is missing")
        self.refused(PLASTIC.replace("ambient_temperature_C = 23\n", ""), "rating.plastic.ambient_temperature_C", "is missing")
        self.refused(PLASTIC.replace("speed_rpm = 1500\n", ""), "rating.speed_rpm", "is missing")
        self.refused(PLASTIC.replace("[20, 60, 100]", "[20, 100, 60]"), "gear2.material.temperatures_C", "rising")
        self.refused(PLASTIC.replace("[40, 28, 16]", "[40, 28]"), "gear2.material.sigma_Flim_by_temperature_MPa", "2 values, but temperatures_C has 3")
        self.refused(PLASTIC.replace("temperatures_C = [20, 60, 100]\n", ""), "gear2.material.sigma_Hlim_by_temperature_MPa",
                     "temperatures_C")
        self.refused(PLASTIC.replace("youngs_modulus_by_temperature_MPa = [2800, 1800, 1000]\n", ""),
                     "gear2.material.youngs_modulus_MPa", "is missing")
        self.refused(PLASTIC.replace('kind = "plastic"', 'kind = "cast"'), "gear2.material.temperatures_C", "plastic")
        steel = PLASTIC[:PLASTIC.index("kind =")].replace("a POM", "42CrMo4") + PLASTIC[PLASTIC.index("[rating]"):]
        self.refused(steel, "rating.standard", "plastic")

    def test_search_of_plastics(self):
        text = PLASTIC[PLASTIC.index("[gear2.material]"):] + """[gear1.material]
name = "18CrNiMo7-6"
[search]
ratio = [2.2, 2.4]
modules_mm = [0.8, 1]
pinion_teeth = [15, 20]
safety_root_min = 1.5
objective = "mass"
"""
        run = Run("search", text, "--json")
        self.assertEqual(run.status, 0, run.err)
        design = run.json["search"]["designs"][0]
        take = Run("search", text, "--take", 1)
        rate = Run("rate", take.out, "--json").json["rating"]
        for key in ("S_H", "S_F"):
            for got, want in zip(design[key], rate[key]):
                self.assertAlmostEqual(got, want, delta=1e-12 * want)


if __name__ == "__main__":
    unittest.main()
