"""Tests gears with few teeth as a user specifies them: circular fillets, gears cut by gears, and every
kind of error."""
import math
import re
import unittest

from cli import Asked, Run

PINION = """[gear1]
teeth = 2
normal_module_mm = 1.75
lead_angle_deg = 60
hand = "right"
profile_shift = 0.7
face_width_mm = 20
[gear1.rack]
dedendum = 1.0
root_fillet_radius = 0
[gear1.root_fillet]
kind = "circular"
offset_mm = 0.01
[gear1.tip_fillet]
kind = "circular"
radius_mm = 0.332
"""
WHEEL = "[gear2]\nteeth = 60\nface_width_mm = 20\n"
CUT = WHEEL + "cut_by = \"gear1\"\n"
SPUR = "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 10\n"
RING = "[gear2]\nteeth = -60\nface_width_mm = 10\n"


class Fillets(Asked):
    def test_keys_of_the_interface(self):
        g = self.ok("gear", PINION)["gears"][0]
        self.assertEqual(g["kind"], "involute")
        self.assertFalse(g["undercut"])
        for key, value in (("root_fillet_radius_mm", 1.0453973845897083), ("root_fillet_span_deg", 60.1360257445374),
                           ("tip_fillet_radius_mm", 0.332), ("tip_fillet_span_deg", 26.6871404537872),
                           ("undercut_l_mm", 0.235880152767074), ("point_c_l_mm", 0.245880152767074)):
            self.assertAlmostEqual(g[key], value, places=11, msg=key)
        plain = self.ok("gear", PINION.split("[gear1.root_fillet]")[0])["gears"][0]
        for key in ("root_fillet_radius_mm", "root_fillet_span_deg", "tip_fillet_radius_mm", "tip_fillet_span_deg", "point_c_l_mm"):
            self.assertIsNone(plain[key], key)
        self.assertAlmostEqual(plain["undercut_l_mm"], 0.235880152767074, places=11)
        self.assertTrue(plain["undercut"])

    def test_kind_is_circular(self):
        self.assertEqual(self.ok("gear", PINION.replace("kind = \"circular\"\n", "")), self.ok("gear", PINION))
        for table in ("root_fillet", "tip_fillet"):
            spec = PINION.replace(f"[gear1.{table}]\nkind = \"circular\"", f"[gear1.{table}]\nkind = \"elliptic\"")
            self.refused(spec, f"gear1.{table}.kind", "circular", verb="gear")

    def test_outline_has_arcs_and_no_lands(self):
        arcs = self.ok("outline", PINION, "--gear", 1, "--points", 9)["arcs"]
        self.assertEqual([a["name"] for a in arcs], ["root_fillet", "flank", "tip_fillet"])
        for before, after in zip(arcs, arcs[1:]):
            self.assertEqual(before["points"][-1], after["points"][0])
        root, tip = arcs[0]["points"], arcs[2]["points"]
        # The middle of the space is at 90° to the tooth.
        self.assertAlmostEqual(root[0][0], 0, places=14)

        self.assertEqual(tip[-1][1], 0)
        for x, y in root:
            self.assertAlmostEqual(math.dist((x, y), (0, 2.148140708140892)), 1.0453973845897083, places=12)
        for x, y in tip:
            self.assertAlmostEqual(math.dist((x, y), (4.147879053267113, 0)), 0.332, places=12)

    def test_radius_too_large_names_the_largest(self):
        spec = PINION.replace("profile_shift = 0.7", "profile_shift = 0.3").replace("teeth = 2", "teeth = 8")
        message = self.refused(spec.replace("0.332", "9"), "gear1.tip_fillet.radius_mm", "no circle of this radius", verb="gear")
        largest = float(re.search(r"at most ([0-9.]+)", message).group(1))
        bare = re.sub(r"\[gear1\.root_fillet\][^\[]*", "", spec)
        # The printed value has six digits and must itself be permitted.
        self.ok("gear", bare.replace("0.332", repr(largest)))
        self.refused(bare.replace("0.332", repr(largest * (1 + 2e-5))), "gear1.tip_fillet.radius_mm", verb="gear")

    def test_offset(self):
        self.refused(PINION.replace("0.01", "-0.01"), "gear1.root_fillet.offset_mm", "negative", verb="gear")
        message = self.refused(PINION.replace("0.01", "5"), "gear1.root_fillet.offset_mm", "less than", verb="gear")
        greatest = float(re.search(r"must be less than ([0-9.]+)", message).group(1))
        self.ok("gear", PINION.replace("0.01", repr(greatest * (1 - 1e-9))))
        self.refused(PINION.replace("0.01", repr(greatest * (1 + 2e-5))), "gear1.root_fillet.offset_mm", verb="gear")
        without = self.ok("gear", PINION.replace("offset_mm = 0.01\n", ""))["gears"][0]
        self.assertEqual(without["point_c_l_mm"], without["undercut_l_mm"])

    def test_one_number_places_a_tip_fillet(self):
        for more, key in (("l_mm = 1.9", "l_mm"), ("clearance_mm = 0.4", "clearance_mm")):
            self.refused(PINION + more + "\n", "gear1.tip_fillet." + key, "leave out the others", verb="gear")
        both = PINION.replace("radius_mm = 0.332", "l_mm = 1.9\nclearance_mm = 0.4")
        self.refused(both, "gear1.tip_fillet.clearance_mm", verb="gear")
        by_l = self.ok("gear", PINION.replace("radius_mm = 0.332", "l_mm = 1.9008136969860153601"))["gears"][0]
        self.assertAlmostEqual(by_l["tip_fillet_radius_mm"], 0.332, places=12)

    def test_values_out_of_range(self):
        for line, key in (("radius_mm = 0", "radius_mm"), ("radius_mm = -1", "radius_mm"), ("radius_mm = nan", "radius_mm"),
                          ("radius_mm = \"0.3\"", "radius_mm"), ("l_mm = 99", "l_mm"), ("l_mm = -1", "l_mm"),
                          ("l_mm = inf", "l_mm")):
            self.refused(PINION.replace("radius_mm = 0.332", line), "gear1.tip_fillet." + key, verb="gear")
        self.refused(PINION.replace("radius_mm = 0.332", "radus_mm = 0.3"), "gear1.tip_fillet.radus_mm", "radius_mm", verb="gear")
        self.refused(PINION.replace("offset_mm", "ofset_mm"), "gear1.root_fillet.ofset_mm", "offset_mm", verb="gear")
        self.refused(SPUR + "tip_fillet = 3\n", "gear1.tip_fillet", verb="gear")

    def test_clearance(self):
        gears = "[gear1]\nteeth = 20\nnormal_module_mm = 3\nface_width_mm = 20\n[gear1.tip_fillet]\n{}\n[gear2]\nteeth = 40\nnormal_module_mm = 3\nface_width_mm = 20\n"
        # Without a given clearance, it is 0.2 m + 0.05 mm.
        for line, wanted in (("clearance_mm = 0.9", 0.9), ("", 0.65)):
            p = self.ok("pair", gears.format(line))
            self.assertAlmostEqual(p["pair"]["tip_clearance_mm"][0], wanted, places=12)
            self.assertGreater(p["gears"][0]["tip_fillet_radius_mm"], 0)
        self.refused(gears.format("clearance_mm = 0.9").split("[gear2]")[0], "gear1.tip_fillet.clearance_mm", "mating gear", verb="gear")
        key = "gear1.tip_fillet"
        r = Run("pair", gears.format("clearance_mm = 9"), "--json")
        self.assertEqual(r.status, 1)
        self.assertTrue(r.json["error"]["key"].startswith(key), r.err)

    def test_clearance_to_a_gear_that_this_tip_cuts(self):
        for line in ("clearance_mm = 0.4", ""):
            spec = PINION.replace("radius_mm = 0.332", line) + CUT
            self.refused(spec, "gear1.tip_fillet.clearance_mm", "the tip of this gear cuts gear 2")

    def test_rings_have_what_their_cutter_leaves(self):
        for table in ("root_fillet]\noffset_mm = 0.1", "tip_fillet]\nradius_mm = 0.3"):
            self.refused(SPUR + RING + "normal_module_mm = 2\n[gear2." + table + "\n", "gear2." + table.split("]")[0], "internal gear")


class CutBy(Asked):
    def test_by_name_with_the_total_shift(self):
        j = self.ok("pair", PINION + CUT + "profile_shift_pair = -0.7\n")
        p, g = j["pair"], j["gears"][1]
        self.assertAlmostEqual(p["center_distance_mm"], 61.335092849361306, places=11)
        self.assertAlmostEqual(g["generating_center_distance_mm"], 61.335092849361306, places=11)
        self.assertEqual((g["kind"], g["cutter_teeth"]), ("generated", 2))
        self.assertAlmostEqual(g["profile_shift"], -1.4, places=12)
        self.assertAlmostEqual(g["helix_angle_deg"], -30, places=12)
        self.assertEqual(g["normal_module_mm"], 1.75)
        self.assertAlmostEqual(p["backlash"]["normal_base_mm"], 0, places=12)
        self.assertIsNone(g["undercut_free_profile_shift"])

    def test_generating_distance_by_each_way(self):
        by_total = self.ok("pair", PINION + CUT + "profile_shift_pair = -0.7\n")["gears"][1]
        by_shift = self.ok("pair", PINION + CUT + "profile_shift = -1.4\n")["gears"][1]
        by_place = self.ok("pair", PINION + CUT + "[pair]\ncenter_distance_mm = 61.335092849361306\n")["gears"][1]
        absent = self.ok("pair", PINION + CUT)["gears"][1]
        for g in (by_shift, by_place):
            self.assertAlmostEqual(g["generating_center_distance_mm"], by_total["generating_center_distance_mm"], places=11)
            self.assertAlmostEqual(g["root_diameter_mm"], by_total["root_diameter_mm"], places=11)
        self.assertAlmostEqual(absent["generating_center_distance_mm"], 62.642504207074395, places=11)  # e = 0

    def test_mounted_further_apart_than_cut(self):
        j = self.ok("pair", PINION + CUT + "profile_shift_pair = -0.7\n[pair]\ncenter_distance_mm = 61.4\n")
        self.assertAlmostEqual(j["gears"][1]["generating_center_distance_mm"], 61.335092849361306, places=11)
        self.assertEqual(j["pair"]["center_distance_mm"], 61.4)
        self.assertGreater(j["pair"]["backlash"]["normal_base_mm"], 0)
        self.assertAlmostEqual(j["pair"]["tip_clearance_mm"][0], 61.4 - 61.335092849361306, places=10)

    def test_gear1_cut_by_gear2(self):
        swapped = (PINION + CUT).replace("gear1", "gearX").replace("gear2", "gear1").replace("gearX", "gear2")
        a, b = self.ok("pair", PINION + CUT), self.ok("pair", swapped)
        for key in ("tip_diameter_mm", "root_diameter_mm", "root_form_diameter_mm", "profile_shift"):
            self.assertEqual(a["gears"][1][key], b["gears"][0][key], key)
        self.assertEqual(a["pair"]["center_distance_mm"], b["pair"]["center_distance_mm"])

    def test_a_cutter_of_its_own_as_a_table(self):
        cutter = PINION.replace("[gear1", "[gear2.cut_by").replace("face_width_mm = 20\n", "")
        named = self.ok("gear", PINION + CUT + "profile_shift_pair = -0.7\n")["gears"][1]
        table = self.ok("gear", PINION + WHEEL + "profile_shift_pair = -0.7\n" + cutter)["gears"][1]
        for key in named:
            if isinstance(named[key], float):
                self.assertAlmostEqual(named[key], table[key], places=11, msg=key)
        # A single gear with a separate cutter needs no mating gear.
        alone = self.ok("gear", (WHEEL + "profile_shift_pair = -0.7\n" + cutter).replace("gear2", "gear1"))["gears"][0]
        self.assertAlmostEqual(alone["root_diameter_mm"], named["root_diameter_mm"], places=11)

    def test_a_cutter_takes_what_it_shares(self):
        own = "normal_module_mm = 2\nhelix_angle_deg = 20\n"
        ring = SPUR.replace("face", "helix_angle_deg = 20\nface") + RING + own + "[gear2.cut_by]\nteeth = 25\n"
        g = self.ok("gear", ring)["gears"][1]
        self.assertEqual((g["normal_module_mm"], g["helix_angle_deg"], g["cutter_teeth"]), (2, 20, 25))
        # The gear takes all other data from its mating gear.
        g = self.ok("gear", SPUR + RING + "[gear2.cut_by]\nteeth = 25\n")["gears"][1]
        self.assertEqual((g["normal_module_mm"], g["helix_angle_deg"]), (2, 0))

    def test_said_twice(self):
        self.ok("pair", PINION + CUT + "normal_module_mm = 1.75\nhelix_angle_deg = -30\n")
        for line, key in (("normal_module_mm = 2", "normal_module_mm"), ("helix_angle_deg = 30", "helix_angle_deg"),
                          ("normal_pressure_angle_deg = 25", "normal_pressure_angle_deg")):
            self.refused(PINION + CUT + line + "\n", "gear2." + key, "cut_by")

    def test_ring_cut_by_its_planet(self):
        j = self.ok("pair", SPUR + RING + "cut_by = \"gear1\"\n")
        g = j["gears"][1]
        self.assertEqual((g["kind"], j["pair"]["kind"]), ("generated", "parallel_internal"))
        self.assertAlmostEqual(j["pair"]["center_distance_mm"], 40, places=12)
        self.assertAlmostEqual(g["root_diameter_mm"], 2 * (40 + 22), places=12)
        self.assertAlmostEqual(j["pair"]["backlash"]["normal_base_mm"], 0, places=12)
        arcs = self.ok("outline", SPUR + RING + "cut_by = \"gear1\"\n", "--gear", 2)["arcs"]
        self.assertEqual(arcs[-1]["points"][-1][1], 0)
        self.assertGreater(math.hypot(*arcs[0]["points"][0]), math.hypot(*arcs[-1]["points"][-1]))

    def test_tables_for_people(self):
        out = Run("gear", PINION + CUT + "profile_shift_pair = -0.7\n").out
        for words in ("Circular root fillet", "Circular tip fillet", "undercut limit"):
            self.assertIn(words, out)


class Fitted(Asked):
    def test_the_bore_of_the_design_is_checked(self):
        """Regression: fit printed a spec whose bore of 3 mm the verb run rejects."""
        spec = ("[gear1]\nteeth = 1\nnormal_module_mm = 2\nface_width_mm = 15\n{}[gear2]\nteeth = 24\n[pair]\n"
                "center_distance_mm = 30\n[fit]\nfew_teeth = true\nleast_tip_land_mm = 0.8\nleast_gap_mm = 0.8\n"
                "clearance_mm = 0.3\nbacklash_mm = 0.2\n")
        self.refused(spec.format("[gear1.bore]\ndiameter_mm = 3\n"), "gear1.bore.diameter_mm", "at most 0.801 mm", verb="fit")
        out = Run("fit", spec.format("")).out
        pair = self.ok("pair", Run("fit", spec.format(""), "--take", 1).out)["pair"]
        j = pair["backlash"]
        words = f"The backlash is {j['circumferential_mm'][0]:.4f} mm along the working pitch circles and {j['normal_mm']:.4f} mm in the normal section."
        self.assertIn(words, " ".join(out.split()))


class CutByErrors(Asked):
    def test_circles(self):
        spec = SPUR + "cut_by = \"gear2\"\n" + CUT
        self.refused(spec, "gear1.cut_by", "needs its own rack or cutter")
        for cut, which in ((SPUR.replace("normal_module_mm = 2\n", "") + "cut_by = \"gear1\"\n", 1), (PINION + WHEEL + "cut_by = \"gear2\"\n", 2)):
            self.refused(cut, f"gear{which}.cut_by", "itself", verb="gear")

    def test_unknown_names(self):
        for value in ("\"gear3\"", "\"pinion\"", "\"\"", "3", "true", "[\"gear1\"]"):
            self.refused(PINION + WHEEL + f"cut_by = {value}\n", "gear2.cut_by", "gear1")
        self.refused(SPUR.replace("normal_module_mm = 2\n", "") + "cut_by = \"gear2\"\n", "gear1.cut_by", "[gear2]", verb="gear")
        self.refused(PINION + WHEEL + "[gear2.cut_by]\nteeeth = 2\n", "gear2.cut_by.teeeth", "teeth")
        self.refused(PINION + WHEEL + "[gear2.cut_by]\nprofile_shift = 0.7\n", "gear2.cut_by.teeth", "missing")

    def test_a_ring_is_no_cutter(self):
        ring = SPUR.replace("teeth = 20", "teeth = -60") + "[gear2]\nteeth = 20\nface_width_mm = 10\ncut_by = \"gear1\"\n"
        self.refused(ring, "gear2.cut_by", "internal gear", verb="gear")
        self.refused(SPUR + RING + "[gear2.cut_by]\nteeth = -20\n", "gear2.cut_by.teeth", "internal gear")
        self.refused(SPUR + RING + "[gear2.cut_by]\nteeth = 20\ncut_by = \"gear1\"\n", "gear2.cut_by.cut_by", "rack")

    def test_a_cutter_larger_than_the_ring(self):
        for teeth in (20, 21, 60):
            spec = SPUR.replace("teeth = 20", f"teeth = {teeth}") + RING.replace("-60", "-20") + "cut_by = \"gear1\"\n"
            self.refused(spec, "gear2.teeth", "does not fit into the internal gear", "19", verb="gear")

    def test_keys_without_a_place(self):
        for lines, key in (("rack = \"ISO53-A\"\n", "rack"), ("thickness_allowance_mm = -0.1\n", "thickness_allowance_mm"),
                           ("[gear2.root_fillet]\noffset_mm = 0.1\n", "root_fillet"), ("[gear2.tip_fillet]\nradius_mm = 0.1\n", "tip_fillet"),
                           ("[gear2.rack]\naddendum = 1\n", "rack")):
            self.refused(PINION + CUT + lines, "gear2." + key, "cannot be combined with cut_by")
        self.refused(PINION + WHEEL.replace("face", "profile_shift_pair = -0.7\nnormal_module_mm = 1.75\nface"), "gear2.profile_shift_pair", "cut_by")
        self.refused(PINION + CUT + "[pair]\nshorten_tips = true\n", "pair.shorten_tips", "tip_diameter_mm")

    def test_both_shifts(self):
        self.refused(PINION + CUT + "profile_shift = -1.4\nprofile_shift_pair = -0.7\n", "gear2.profile_shift_pair", "profile_shift, because both")

    def test_a_shift_out_of_reach(self):
        for key in ("profile_shift", "profile_shift_pair"):
            message = self.refused(PINION + CUT + f"{key} = -9\n", f"gear2.{key}", "at least")
            self.assertNotIn("nan", message)
        least = float(re.search(r"at least (-[0-9.]+)", self.refused(PINION + CUT + "profile_shift = -9\n", "gear2.profile_shift")).group(1))
        self.refused(PINION + CUT + f"profile_shift = {least - 2e-5!r}\n", "gear2.profile_shift")

    def test_a_distance_too_small(self):
        message = self.refused(PINION + CUT + "[pair]\ncenter_distance_mm = 50\n", "pair.center_distance_mm", "greater than")
        least = float(re.search(r"greater than ([0-9.]+)", message).group(1))
        self.assertAlmostEqual(least, 1.8628891263196041418 * 31, places=3)
        # If two values are close, the message contains enough digits to distinguish them.
        message = self.refused(PINION + CUT + "[pair]\ncenter_distance_mm = 57.7495629\n", "pair.center_distance_mm")
        least = float(re.search(r"greater than ([0-9.]+)", message).group(1))
        self.assertAlmostEqual(least, 1.8628891263196041418 * 31, places=6)

    def test_a_cutter_that_is_no_gear(self):
        spec = PINION.split("[gear1.rack]")[0].replace("0.7", "-0.7") + CUT
        self.refused(spec, "gear2.cut_by", "nothing is left of the gear", verb="gear")

    def test_errors_in_a_cutters_table(self):
        bad = PINION.replace("[gear1", "[gear2.cut_by")
        for change, key in ((("0.332", "99"), "tip_fillet.radius_mm"), (("0.01", "99"), "root_fillet.offset_mm"),
                            (("dedendum = 1.0", "dedendum = 99"), "rack.dedendum"), (("radius_mm = 0.332", "clearance_mm = 1"), "tip_fillet")):
            self.refused(PINION + WHEEL + bad.replace(*change), "gear2.cut_by." + key)

    def test_a_pair_of_which_neither_waits(self):
        # Each gear has a separate cutter.
        own = "[gear{0}]\nteeth = {1}\nface_width_mm = 10\nprofile_shift = 0\n[gear{0}.cut_by]\nteeth = 25\nnormal_module_mm = 2\n"
        j = self.ok("pair", own.format(1, 20) + own.format(2, 40))
        self.assertAlmostEqual(j["pair"]["center_distance_mm"], 60, places=11)
        self.assertEqual([g["cutter_teeth"] for g in j["gears"]], [25, 25])


if __name__ == "__main__":
    unittest.main()
