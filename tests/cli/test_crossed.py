"""Tests crossed pairs as a user specifies them: gears given by their base cylinders, any shaft angle, the
verbs fit and measure, and gears with different racks."""
import json
import math
import unittest

from cli import Run

# The pair 9/15 of the paper. Each gear is given by its base cylinder.
BASIC = """[gear1]
teeth = 9
tip_diameter_mm = 46.65
face_width_mm = 16
[gear1.basic]
base_diameter_mm = 37.4892228898867
base_tooth_thickness_mm = 7.263
base_helix_angle_deg = 47.408
[gear2]
teeth = 15
tip_diameter_mm = 65.27
face_width_mm = 14
[gear2.basic]
base_diameter_mm = 52.6687933717901
base_tooth_thickness_mm = 7.618
base_helix_angle_deg = 36.595
[pair]
{}
"""
WISH = "[gear1]\nteeth = 12\nnormal_module_mm = 1.5\nface_width_mm = 12\n{}\n[gear2]\nteeth = 24\nnormal_module_mm = 1.5\nface_width_mm = 12\n{}\n[pair]\n{}\n"
# A pinion in an internal gear, with axes crossed by 10°.
RING = """[gear1]
teeth = 20
normal_module_mm = 2
helix_angle_deg = 20
face_width_mm = 10
thickness_allowance_mm = -0.05
{}
[gear2]
teeth = -61
normal_module_mm = 2
helix_angle_deg = 10
face_width_mm = 10
tip_diameter_mm = 121.6
thickness_allowance_mm = -0.05
[pair]
{}
"""


class Crossed(unittest.TestCase):
    def test_pair(self):
        r = Run("pair", BASIC.format("shaft_angle_deg = 90\nfriction_coefficient = 0.05"), "--json")
        self.assertEqual(r.status, 0, r.err)
        p = r.json["pair"]
        self.assertEqual(p["kind"], "crossed")
        self.assertAlmostEqual(p["center_distance_mm"], 50.010003913967104, places=11)
        self.assertAlmostEqual(p["contact_ratio"], 1.7308718877159246, places=11)
        self.assertEqual([w["code"] for w in r.json["warnings"]], [])
        a, b = p["line_of_action"]["leading"]
        self.assertAlmostEqual(math.dist(a, b), p["line_of_action"]["length_mm"], places=11)
        self.assertEqual(p["transverse_contact_ratio"], None)
        self.assertTrue(0.85 < p["efficiency"]["gear1_drives"] < 0.95)
        sliding = p["sliding_velocity_mm_per_rad"]
        for across, along, total in zip(sliding["across_teeth"], sliding["along_teeth"], sliding["total"]):
            self.assertAlmostEqual(math.hypot(across, along), total, places=12)
        table = Run("pair", BASIC.format("shaft_angle_deg = 90"))
        for words in ("crossed axes", "face width for both flanks", "Minimum centre distance", "contact ratio of at least 1"):
            self.assertIn(words, table.out)

    def test_run_draws_the_pair_where_it_stands(self):
        r = Run("run", BASIC.format("shaft_angle_deg = 90"), "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertIn("case_out/pair.glb", r.files())
        self.assertIn("rossed", (r.folder / "case_out/report.html").read_text())

    def test_an_internal_pair(self):
        plain = Run("pair", RING.format("", "shaft_angle_deg = 10"), "--json")
        self.assertEqual(plain.status, 0, plain.err)
        p = plain.json["pair"]
        self.assertEqual((p["kind"], p["gear_ratio"]), ("crossed", -61 / 20))
        # Both gears have the same rack, so their pitch cylinders are the reference cylinders.
        self.assertAlmostEqual(p["working_normal_pressure_angle_deg"], 20, places=10)
        self.assertAlmostEqual(p["center_distance_mm"], 61 / math.cos(math.radians(10)) - 20 / math.cos(math.radians(20)), places=9)
        self.assertAlmostEqual(p["backlash"]["normal_mm"], 0.1, places=10)
        self.assertIsNone(p["backlash"]["free_rotation_deg"])
        self.assertIsNone(p["contact_ratio_range"])
        warning = next(w for w in plain.json["warnings"] if w["code"] == "saddle_gap")
        needed = p["needed_lead_crowning_um"]
        self.assertIn(f"{math.ceil(100 * needed[0]) / 100:.2f} µm on gear 1", warning["message"])
        self.assertRegex(" ".join(Run("pair", RING.format("", "shaft_angle_deg = 10")).out.split()), "With a lead crowning of 5 µm on gear 1, the flanks stay clear of each other")
        for share, codes in ((0.97, ["saddle_gap"]), (1.03, [])):
            crowned = f"[gear1.modifications]\nlead_crowning_um = {share * needed[0]}"
            r = Run("pair", RING.format(crowned, "shaft_angle_deg = 10"), "--json")
            self.assertEqual([w["code"] for w in r.json["warnings"] if w["code"] == "saddle_gap"], codes)
        # Without crowning, an edge touches before the flank would touch. The lead is about the
        # crowning that is needed. With crowning, the flanks touch inside their limits.
        lead = {}
        for crowning in (0, 3 * needed[0]):
            text = RING.format(f"[gear1.modifications]\nlead_crowning_um = {crowning}", "shaft_angle_deg = 10")
            points = Run("contact", text, "--json").json["contact"]["positions"]
            arm = math.radians(1 / 3600) * 116.2 / 2 * math.cos(math.radians(9.4)) * 1000  # µm per arcsecond
            half = p["backlash"]["rotation_deg"][1] / 2 * 3600
            lead[crowning] = [(q["transmission_error_arcsec"] + half) * arm for q in points]
        self.assertTrue(all(0.5 * needed[0] < t < 1.5 * needed[0] for t in lead[0]), lead)
        self.assertTrue(all(-1e-6 < t < 0.3 * needed[0] for t in lead[3 * needed[0]]), lead)

    def test_limits_of_an_internal_pair(self):
        def error(verb, text):
            r = Run(verb, text, "--json")
            self.assertEqual(r.status, 1, text)
            return r.json["error"]

        e = error("pair", RING.format("", ""))
        self.assertEqual(e["key"], "gear2.helix_angle_deg")
        self.assertIn("pair.shaft_angle_deg", e["message"])
        e = error("pair", RING.format("", "shaft_angle_deg = 9"))
        self.assertEqual(e["key"], "pair.shaft_angle_deg")
        self.assertIn("minus the helix angle of the internal gear", e["message"])
        unshifted = RING.replace("_angle_deg = 20", "_angle_deg = 20\nprofile_shift = 0").replace("_angle_deg = 10", "_angle_deg = 10\nprofile_shift = 0")
        placed = lambda a: unshifted.format("", f"shaft_angle_deg = 10\ncenter_distance_mm = {a}")
        e = error("pair", placed(30))
        self.assertEqual(e["key"], "pair.center_distance_mm")
        self.assertIn("more curved", e["message"])
        least = float(e["message"].split("greater than ")[1].split(" mm")[0])
        for a, status in ((least * 0.9999, 1), (least * 1.0001, 0)):
            self.assertEqual(Run("pair", placed(a)).status, status)
        e = error("load", RING.format("", "shaft_angle_deg = 10\n[load]\ntorque_Nm = 10"))
        self.assertEqual(e["key"], "pair.shaft_angle_deg")
        self.assertIn("parallel axes only", e["message"])
        e = error("fit", RING.format("", "shaft_angle_deg = 10\ncenter_distance_mm = 40"))
        self.assertEqual(e["key"], "pair.shaft_angle_deg")

    def test_files_of_an_internal_pair(self):
        r = Run("run", RING.format("", "shaft_angle_deg = 10"), "--json")
        self.assertEqual(r.status, 0, r.err)
        for name in ("gear1.step", "gear2.step", "gear1.stl", "gear2.dxf", "pair.step", "pair.glb"):
            self.assertIn("case_out/" + name, r.files())

    def test_a_gear_as_itself_works_like_any_other(self):
        self.assertEqual(Run("outline", BASIC.format(""), "--gear", 2, "--json").status, 0)
        gear = Run("gear", BASIC.format(""), "--json").json["gears"][0]
        self.assertAlmostEqual(gear["normal_module_mm"], 3, places=12)
        self.assertAlmostEqual(gear["base_tooth_thickness_mm"], 7.263, places=12)
        named = BASIC.format("").replace("teeth = 9", "teeth = 9\nnormal_pressure_angle_deg = 17.5")
        self.assertAlmostEqual(Run("gear", named, "--json").json["gears"][0]["profile_shift"], -0.23333293634423116, places=11)

    def test_a_root_that_is_known(self):
        root = BASIC.format("").replace("base_helix_angle_deg = 47.408", "base_helix_angle_deg = 47.408\nroot_diameter_mm = 34\nroot_form_diameter_mm = 38")
        gear = Run("gear", root, "--json").json["gears"][0]
        self.assertAlmostEqual(gear["root_diameter_mm"], 34, places=10)
        r = Run("gear", root.replace("root_form_diameter_mm = 38", "root_form_diameter_mm = 60"), "--json")
        self.assertEqual(r.json["error"]["key"], "gear1.basic.root_form_diameter_mm")

    def test_another_rack(self):
        r = Run("gear", BASIC.format(""), "--as-rack", ",17.5", "--json")
        rack = r.json["gears"][0]["as_rack"]
        self.assertAlmostEqual(rack["normal_module_mm"], 2.955885244721772, places=12)
        self.assertAlmostEqual(rack["helix_angle_deg"], 50.526466529067285, places=11)
        self.assertAlmostEqual(Run("gear", BASIC.format(""), "--as-rack", "3,", "--json").json["gears"][1]["as_rack"]["normal_pressure_angle_deg"], 20, places=9)
        self.assertEqual(Run("gear", BASIC.format(""), "--as-rack", "3,21").status, 1)
        self.assertEqual(Run("gear", BASIC.format(""), "--as-rack", ",50").status, 1)
        # These helix angles would exceed 60°, and 90° is impossible.
        for module in ("1e16", "1e17", "1e300", "50"):
            r = Run("gear", BASIC.format(""), "--as-rack", module + ",")
            self.assertEqual(r.status, 1, r.err)
            self.assertIn("60°", r.err)
        inch = Run("gear", 'units = "inch"\n[gear1]\nteeth = 25\nnormal_diametral_pitch_per_in = 10\n', "--as-rack", "2.6,20")
        # A module stays in mm.
        self.assertIn("for the pressure angle 20° the module must be 2.54\u00a0mm, or for the module 2.6\u00a0mm the pressure angle", inch.err)
        for junk in ("3", ",", "", "3,20,1", "x,20", "-3,20", "3,nan", "3 ,20x", "0x3,", ",1e-300", ",85"):
            self.assertEqual(Run("gear", BASIC.format(""), "--as-rack", junk).status, 2, junk)

    def test_a_drawing_of_crossed_gears_is_refused(self):
        text = BASIC.format("shaft_angle_deg = 90")
        for option in ("--dxf", "--svg"):
            r = Run("export", text, option, "pair.out")
            self.assertEqual((r.status, r.files()), (1, ["case.toml"]))
            self.assertIn("--gear 1", r.err)
            self.assertEqual(Run("export", text, option, "one.out", "--gear", 2).status, 0)

    def test_near_the_ends_of_the_reach(self):
        gears = "[gear1]\nteeth = 17\nnormal_module_mm = 2.5\nhelix_angle_deg = {}\n[gear2]\nteeth = 30\nnormal_module_mm = 2.5\nhelix_angle_deg = {}\n[pair]\nshaft_angle_deg = {}\n"
        p = Run("pair", gears.format(20, 0, 89.8), "--json").json["pair"]
        self.assertAlmostEqual(p["backlash"]["normal_mm"], 0, places=11)
        for helices, sigma in (((20, 0), 89.9999), ((45, 45), 179.999999)):
            r = Run("pair", gears.format(*helices, sigma), "--json")
            self.assertEqual(r.json["error"]["key"], "pair.shaft_angle_deg")
        r = Run("pair", gears.format(0, 20, 91), "--json")
        self.assertIn("outside the possible range by 1°", r.json["error"]["message"])
        for beta in (89.99999999999999, -89.99999999999999):
            self.assertEqual(Run("pair", gears.format(89.99999999999999, beta, 0), "--json").json["error"]["key"], "gear1.helix_angle_deg")

    def test_errors_of_a_gear_as_itself_speak_of_it(self):
        for change, words in ((("base_diameter_mm = 37.4892228898867", "base_diameter_mm = 0.001"), "gear1.basic"),
                              (("base_tooth_thickness_mm = 7.263", "base_tooth_thickness_mm = 1e6"), "gear1.basic")):
            r = Run("gear", BASIC.format("").replace(*change), "--json")
            self.assertEqual(r.json["error"]["key"], words)
        same = BASIC.format("").replace("teeth = 9", "teeth = 9\nhelix_angle_deg = 51.576509202864735")
        self.assertEqual(Run("gear", same).status, 0)

    def test_a_gear_without_a_chord_does_not_hide_the_other(self):
        text = "[gear1]\nteeth = 17\nnormal_module_mm = 2\nface_width_mm = 9\n[gear2]\nteeth = 3\nnormal_module_mm = 2\nface_width_mm = 9\nprofile_shift = -1\n"
        r = Run("measure", text, "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual(r.json["gears"][1]["measure"]["chordal_thickness"], None)
        self.assertGreater(r.json["gears"][0]["measure"]["chordal_thickness"]["chord_mm"], 3)
        self.assertIn("no_chord", [w["code"] for w in r.json["warnings"]])

    def test_contradictions_of_a_gear_as_itself(self):
        for line in ("helix_angle_deg = 10", "profile_shift = 0.1", "thickness_allowance_mm = -0.1", "normal_module_mm = 3.1\nnormal_pressure_angle_deg = 20"):
            r = Run("gear", BASIC.format("").replace("teeth = 9", "teeth = 9\n" + line), "--json")
            self.assertEqual(r.status, 1, line)
            self.assertIn("gear1." + line.split(" ")[0], r.json["error"]["key"])
        r = Run("gear", BASIC.format("").replace("47.408", "75"), "--json")
        self.assertEqual(r.json["error"]["key"], "gear1.normal_pressure_angle_deg")
        self.assertIn("15", r.json["error"]["message"])

    def test_fit_and_take(self):
        wish = WISH.format("", "", "center_distance_mm = 40\nshaft_angle_deg = 90")
        branches = Run("fit", wish, "--json").json["fit"]["branches"]
        self.assertEqual(len(branches), 2)
        self.assertAlmostEqual(branches[1]["helix_angle_deg"][0], 62.94761677137, places=9)
        for number, branch in enumerate(branches, 1):
            taken = Run("fit", wish, "--take", number)
            self.assertEqual(taken.status, 0)
            pair = Run("pair", taken.out, "--json").json["pair"]
            self.assertAlmostEqual(pair["backlash"]["normal_base_mm"], 0, places=11)
            self.assertAlmostEqual(pair["minimum_center_distance"]["shaft_angle_deg"], 90, places=9)
            self.assertEqual(pair, Run("pair", json.dumps(branch["spec"]), "--json", name="case.json").json["pair"])
        self.assertEqual(Run("fit", wish, "--take", 3).status, 1)
        none = Run("fit", wish.replace("= 40", "= 37"))
        self.assertEqual(none.status, 0)
        self.assertIn("There is no such pair", none.out)

    def test_fit_refuses_what_it_cannot_ask(self):
        for lines, key in (
                (("", "", ""), "pair.center_distance_mm"),
                (("transverse_module_mm = 1.5", "", "center_distance_mm = 40\nshaft_angle_deg = 90"), "gear1.transverse_module_mm"),
                (("", "normal_pressure_angle_deg = 25", "center_distance_mm = 40\nshaft_angle_deg = 90"), "gear2.normal_module_mm")):
            text = WISH.format(*lines)
            if "transverse" in lines[0]:
                text = text.replace("normal_module_mm = 1.5\n", "", 1)
            r = Run("fit", text, "--json")
            self.assertEqual(r.status, 1, text)
            self.assertEqual(r.json["error"]["key"], key)

    def test_a_shift_follows_from_distance_and_angle(self):
        text = WISH.format("helix_angle_deg = 45\nprofile_shift = 0.1", "helix_angle_deg = 45", "center_distance_mm = 38.4\nshaft_angle_deg = 90")
        p = Run("pair", text, "--json").json
        self.assertAlmostEqual(p["pair"]["backlash"]["normal_base_mm"], 0, places=11)
        # Without a shaft angle, the given centre distance is the minimum one of the pair.
        text = WISH.format("helix_angle_deg = 46\nprofile_shift = 0.1", "helix_angle_deg = 45", "center_distance_mm = 38.4\nshaft_angle_deg = 90")
        r = Run("pair", text.replace("shaft_angle_deg = 90", ""), "--json")
        self.assertAlmostEqual(r.json["pair"]["minimum_center_distance"]["center_distance_mm"], 38.4, places=10)
        self.assertIn("default_shaft_angle", [w["code"] for w in r.json["warnings"]])
        r = Run("pair", text.replace("shaft_angle_deg = 90", "").replace("38.4", "30"), "--json")
        self.assertEqual(r.json["error"]["key"], "pair.center_distance_mm")

    def test_nearly_parallel_axes_are_judged_by_the_computed_contact(self):
        """Regression: the verdict was red, "the teeth do not touch", although they touch at every position."""
        gear = "[gear{}]\nteeth = {}\nnormal_module_mm = 2.5\nface_width_mm = 25\nthickness_allowance_mm = -0.05\nhelix_angle_deg = {}\n"
        spec = gear.format(1, 17, 15) + "profile_shift = 0.3\nmodifications = { lead_crowning_um = 40 }\n" + gear.format(2, 43, -14.98)
        spec += "[pair]\nshaft_angle_deg = 0.02\n"
        answer = Run("contact", spec, "--json").json
        self.assertFalse(answer["contact"]["contact_lost"])
        self.assertEqual(answer["verdict"]["level"], "amber")
        self.assertIn("at every position, but the contact is not conjugate", answer["verdict"]["headline"])
        self.assertEqual(Run("pair", spec, "--json").json["verdict"]["level"], "red")

    def test_measure(self):
        text = BASIC.format("").replace("[gear2]", "[gear1.measure]\nchord_diameter_mm = 43.44544689997543\n[gear2]")
        gears = Run("measure", text, "--json").json["gears"]
        chord = gears[0]["measure"]["chordal_thickness"]
        self.assertAlmostEqual(chord["chord_mm"], 3.7221882761818854, places=12)
        self.assertAlmostEqual(chord["height_mm"], 0.030867235727118, places=12)
        self.assertIn("chordal_thickness", gears[1]["measure"])
        r = Run("measure", text.replace("43.44544689997543", "60"), "--json")
        self.assertEqual(r.json["error"]["key"], "gear1.measure.chord_diameter_mm")
        self.assertIn("calliper", Run("measure", text).out)


if __name__ == "__main__":
    unittest.main()
