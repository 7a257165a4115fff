"""Tests circular-arc gears as a user specifies them: racks F and P, double arcs, racks given arc by arc,
and every kind of error."""
import json
import math
import unittest

from cli import SOURCE, Asked, Run

F_RACK = """kind = "circular_arc"
cutter = "F"
pressure_angle_deg = 30
arc_radius = 1.4
center_a = 0.422436
center_b = 0.243893
"""
P_RACK = """kind = "circular_arc"
cutter = "P"
pressure_angle_deg = 30
arc_radius = 1.55
center_a = 0.552339
center_b = 0.318893
"""
GEAR = """[gear{n}]
teeth = {z}
normal_module_mm = 4
helix_angle_deg = {beta}
face_width_mm = 60
{more}
[gear{n}.rack]
{rack}
"""
F = GEAR.format(n=1, z=15, beta=18, rack=F_RACK, more="")
P = GEAR.format(n=2, z=40, beta=-18, rack=P_RACK, more="")
PAIR = F + P
NAMED = """[gear{n}]
teeth = {z}
normal_module_mm = {m}
helix_angle_deg = {beta}
face_width_mm = 60
rack = "GBT12759"
"""
DOUBLE = NAMED.format(n=1, z=18, m=4, beta=22) + NAMED.format(n=2, z=50, m=4, beta=-22)
INVOLUTE_KEYS = ("normal_pressure_angle_deg", "transverse_pressure_angle_deg", "base_helix_angle_deg", "profile_shift",
                 "generating_profile_shift", "base_diameter_mm", "base_tooth_thickness_mm", "normal_base_pitch_mm",
                 "transverse_base_pitch_mm", "undercut_free_profile_shift", "undercut_l_mm")


class Gears(Asked):
    def test_keys_of_the_interface(self):
        g = self.ok("gear", F)["gears"][0]
        d = 15 * 4 / math.cos(math.radians(18))
        self.assertEqual(g["kind"], "circular_arc")
        for key, value in (("reference_diameter_mm", d), ("tip_diameter_mm", d + 7.2), ("root_diameter_mm", d - 2.4)):
            self.assertAlmostEqual(g[key], value, places=12, msg=key)
        for key in INVOLUTE_KEYS:
            self.assertIsNone(g[key], key)
        s_n = 2 * 4 * (math.sqrt(1.4**2 - 0.243893**2) - 0.422436)
        self.assertAlmostEqual(g["reference_tooth_thickness_normal_mm"], s_n, places=12)
        self.assertAlmostEqual(g["flank_begin_rack_angle_deg"], 9.668, places=3)
        self.assertLess(g["undercut_limit_rack_angle_deg"], g["flank_begin_rack_angle_deg"])
        self.assertFalse(g["undercut"])

    def test_diametral_pitch_and_defaults(self):
        inch = F.replace("normal_module_mm = 4", "normal_diametral_pitch_per_in = 6.35")
        self.assertEqual(self.ok("gear", inch), self.ok("gear", F))
        said = F.replace(F_RACK, F_RACK + "addendum = 0.9\ndedendum = 0.3\nroot_fillet_radius = 0.35\n")
        self.assertEqual(self.ok("gear", said), self.ok("gear", F))
        silent = F.replace("pressure_angle_deg = 30\n", "")
        self.assertEqual(self.ok("gear", silent), self.ok("gear", F))

    def test_table_leaves_out_what_is_not_there(self):
        r = Run("gear", PAIR)
        self.assertEqual(r.status, 0)
        for word in ("nan", "base", "profile shift", "pressure angle"):
            self.assertNotIn(word, r.out)
        self.assertIn("undercut limit", r.out)
        mixed = F + "[gear2]\nteeth = 40\nnormal_module_mm = 4\n"
        r = Run("gear", mixed)
        self.assertEqual(r.status, 0, r.err)
        self.assertNotIn("nan", r.out)
        self.assertIn("base diameter", r.out)

    def test_outline(self):
        arcs = self.ok("outline", PAIR, "--gear", 2, "--points", 20)["arcs"]
        self.assertEqual([a["name"] for a in arcs], ["root_land", "root_fillet", "flank", "tip_land"])
        arcs = self.ok("outline", DOUBLE, "--points", 20)["arcs"]
        self.assertEqual([a["name"] for a in arcs], ["root_fillet", "flank", "flank", "flank", "tip_land"])
        for before, after in zip(arcs, arcs[1:]):
            self.assertEqual(before["points"][-1], after["points"][0])

    def test_double_arcs_by_name_and_by_numbers(self):
        table = GEAR.format(n=1, z=18, beta=22, more="", rack="kind = \"double_circular_arc\"\nconcave_radius = 1.41\n"
                            "concave_height = 0.0285\nspace_width = 1.1773\n")
        named = NAMED.format(n=1, z=18, m=4, beta=22)
        self.assertEqual(self.ok("gear", table), self.ok("gear", named))
        for m in (8, 20):
            self.refused(named.replace("normal_module_mm = 4", f"normal_module_mm = {m}"), "gear1.rack",
                         f"{m}\u00a0mm", "double_circular_arc", verb="gear")
        for key in ("concave_radius", "concave_height", "space_width"):
            lines = "\n".join(line for line in table.splitlines() if not line.startswith(key))
            self.refused(lines, f"gear1.rack.{key}", "missing", verb="gear")

    def test_any_arcs(self):
        # These arcs describe rack F.
        joint = math.asin((0.243893 - 0.3 + 0.35) / 1.75)
        y = -0.422436 + 1.75 * math.cos(joint)
        top = math.degrees(math.acos(0.422436 / 1.4))
        rack = f"""kind = "arcs"
addendum = 0.9
dedendum = 0.3
arcs = [
  {{ part = "root_fillet", center_height = 0.05, center_offset = {y}, radius = -0.35, begin_deg = 90, end_deg = {math.degrees(joint)} }},
  {{ center_height = -0.243893, center_offset = -0.422436, radius = 1.4, begin_deg = {math.degrees(joint)}, end_deg = {top} }},
]
"""
        spec = GEAR.format(n=1, z=15, beta=18, rack=rack, more="")
        got, want = self.ok("gear", spec)["gears"][0], self.ok("gear", F)["gears"][0]
        for key, value in want.items():
            if isinstance(value, float):
                self.assertAlmostEqual(got[key], value, places=10, msg=key)
            else:
                self.assertEqual(got[key], value, key)
        pair = self.ok("pair", spec + P)["pair"]
        self.assertAlmostEqual(pair["working_normal_pressure_angle_deg"], 30, places=3)
        self.refused(spec.replace("radius = 1.4", "radius = 1.5"), "gear1.rack.arcs[2]", "begins at", verb="gear")
        self.refused(spec.replace("part = \"root_fillet\"", "part = \"root\""), "gear1.rack.arcs[1].part", verb="gear")
        self.refused(spec.replace("arcs = [", "arcs = [ 3,"), "gear1.rack.arcs[1]", "table", verb="gear")
        self.refused(GEAR.format(n=1, z=15, beta=18, rack="kind = \"arcs\"\naddendum = 1\ndedendum = 1\narcs = []", more=""),
                     "gear1.rack.arcs", "list", verb="gear")

    def test_refusals_name_the_key(self):
        def rack(old, new):
            return F.replace(old, new)
        for old, key in (("cutter = \"F\"\n", "cutter"), ("arc_radius = 1.4\n", "arc_radius"),
                         ("center_a = 0.422436\n", "center_a"), ("center_b = 0.243893\n", "center_b")):
            self.refused(rack(old, ""), f"gear1.rack.{key}", "missing", verb="gear")
        self.refused(rack("arc_radius = 1.4", "arc_radius = -1"), "gear1.rack.arc_radius", "greater than 0", verb="gear")
        self.refused(F + "addendum = 1.2\n", "gear1.rack.addendum", "meet in a point", "1.09", verb="gear")
        self.refused(F + "dedendum = 0.7\n", "gear1.rack.dedendum", "0.593", verb="gear")
        self.refused(F + "tip_fillet_radius = 0.1\n", "gear1.rack.tip_fillet_radius", "root_fillet_radius", verb="gear")
        self.refused(rack("pressure_angle_deg = 30", "pressure_angle_deg = 80"), "gear1.rack.pressure_angle_deg", verb="gear")
        self.refused(rack("\"circular_arc\"", "\"circular\""), "gear1.rack.kind", "double_circular_arc", verb="gear")
        for more, key in (("normal_pressure_angle_deg = 20", "normal_pressure_angle_deg"),
                          ("profile_shift = 0.2", "profile_shift"),
                          ("root_fillet = { offset_mm = 0.1 }", "root_fillet"),
                          ("tip_fillet = { radius_mm = 0.1 }", "tip_fillet"),
                          ("basic = { base_diameter_mm = 50, base_tooth_thickness_mm = 6 }", "basic")):
            self.refused(GEAR.format(n=1, z=15, beta=18, rack=F_RACK, more=more), f"gear1.{key}", verb="gear")
        self.refused(F.replace("teeth = 15", "teeth = -60"), "gear1.teeth", "internal gear", verb="gear")
        self.assertEqual(self.ok("gear", GEAR.format(n=1, z=15, beta=18, rack=F_RACK, more="profile_shift = 0")),
                         self.ok("gear", F))


class Pairs(Asked):
    def test_keys_of_the_pair(self):
        p = self.ok("pair", PAIR)["pair"]
        a = 55 * 2 / math.cos(math.radians(18))
        self.assertEqual(p["kind"], "parallel_external")
        self.assertAlmostEqual(p["center_distance_mm"], a, places=12)
        self.assertEqual(p["reference_center_distance_mm"], p["center_distance_mm"])
        self.assertAlmostEqual(p["working_normal_pressure_angle_deg"], 30, places=3)
        self.assertAlmostEqual(p["overlap_ratio"], 60 * math.sin(math.radians(18)) / (4 * math.pi), places=12)
        self.assertEqual(p["contact_ratio"], p["overlap_ratio"])
        self.assertEqual(p["transverse_contact_ratio"], 0)
        self.assertAlmostEqual(p["tip_clearance_mm"][0], 0.6, places=12)
        self.assertAlmostEqual(p["tip_clearance_mm"][1], 1.2, places=12)
        self.assertLess(abs(p["backlash"]["normal_base_mm"]), 1e-5)
        for key in ("backlash_free_center_distance_mm", "extended_center_distance_mm", "specific_sliding",
                    "minimum_center_distance", "contact_ratio_range", "efficiency"):
            self.assertIsNone(p[key], key)
        self.assertEqual(p["interference"], [])
        [c] = p["arc_contacts"]
        self.assertEqual(c["convex_gear"], 1)
        k1, k2 = c["gap_curvature_per_mm"]
        self.assertTrue(0 < k1 < k2)
        self.assertAlmostEqual(c["ellipse"]["semi_major_mm"], math.sqrt(2 * 0.00635 / k1), places=12)
        line = p["line_of_action"]
        self.assertEqual([round(q[2], 9) for q in line["leading"]], [-30, 30])

    def test_given_distance_moves_the_contact(self):
        a = 55 * 2 / math.cos(math.radians(18))
        for change in (0.1, -0.05):
            p = self.ok("pair", PAIR + f"[pair]\ncenter_distance_mm = {a + change!r}\n")["pair"]
            first = math.degrees(math.asin(0.5 - change / (0.15 * 4)))
            self.assertAlmostEqual(p["working_normal_pressure_angle_deg"], first, delta=0.3)
            self.assertEqual(p["backlash"]["rotation_deg"][0] > 0, change > 0)
        self.refused(PAIR + f"[pair]\ncenter_distance_mm = {a + 2}\n", "pair.center_distance_mm", "between")

    def test_warnings(self):
        def codes(spec):
            return [w["code"] for w in self.ok("pair", spec)["warnings"]]
        self.assertEqual(codes(PAIR), [])
        self.assertIn("pressure_angle", codes(PAIR.replace("pressure_angle_deg = 30", "pressure_angle_deg = 29")))
        off = Run("pair", PAIR.replace("pressure_angle_deg = 30", "pressure_angle_deg = 29"), "--json").json
        self.assertIn("Check: Gear 1: The given pressure angle of the rack", off["verdict"]["headline"])
        self.assertIn("contact_ratio", codes(PAIR.replace("face_width_mm = 60", "face_width_mm = 30")))
        self.assertIn("contact_off_flank", codes(PAIR + "[pair]\ncenter_distance_mm = 115.91\n"))
        self.assertIn("unequal_lead", codes(PAIR.replace("helix_angle_deg = 18", "helix_angle_deg = 18.09")))
        self.assertIn("not_read", codes(PAIR + "[pair]\nfriction_coefficient = 0.05\n"))

    def test_what_does_not_go_together(self):
        involute = "[gear2]\nteeth = 40\nnormal_module_mm = 4\nhelix_angle_deg = -18\n"
        self.refused(F + involute, "gear2.rack", "involute")
        self.refused(F + involute.replace("40", "-40"), "gear2.rack", "involute")
        self.refused(F + F.replace("gear1", "gear2").replace("= 18", "= -18"), "gear2.rack", "combine racks F and P")
        self.refused(PAIR.replace("helix_angle_deg = -18", "helix_angle_deg = 18"), "gear2.helix_angle_deg", "opposite")
        self.refused(PAIR.replace("helix_angle_deg = -18", "helix_angle_deg = 0").replace("helix_angle_deg = 18", "helix_angle_deg = 0"),
                     "gear1.helix_angle_deg", "helix")
        self.refused(PAIR + "[pair]\nshaft_angle_deg = 10\n", "pair.shaft_angle_deg", "parallel")
        self.refused(PAIR + "[pair]\nshorten_tips = true\n", "pair.shorten_tips")
        self.refused(F + "[gear2]\nteeth = 40\ncut_by = \"gear1\"\n", "gear2.cut_by", "circular-arc")
        self.refused(F, "gear2", "missing")
        self.refused(PAIR, "gear1.rack", "involute", verb="fit")
        r = Run("gear", F, "--as-rack", ",20", "--json")
        self.assertEqual(r.status, 1)

    def test_measure_has_no_chord(self):
        j = self.ok("measure", F)
        self.assertIsNone(j["gears"][0]["measure"]["chordal_thickness"])
        self.assertIn("no_chord", [w["code"] for w in j["warnings"]])

    def test_double_arcs_touch_twice(self):
        p = self.ok("pair", DOUBLE)["pair"]
        self.assertEqual([c["convex_gear"] for c in p["arc_contacts"]], [1, 2])
        self.assertAlmostEqual(p["contact_ratio"], 2 * p["overlap_ratio"], places=12)
        self.assertAlmostEqual(p["backlash"]["normal_base_mm"], 0.06 * 4 * math.cos(math.radians(24)), delta=2e-3)


class Files(Asked):
    def test_run_writes_everything(self):
        for name in ("circular_arc_drive", "gbt12759_pair"):
            spec = (SOURCE / "examples" / (name + ".toml")).read_text().replace("face_width_mm = 180", "face_width_mm = 160")
            r = Run("run", spec, "--json", "--out", "made")
            self.assertEqual(r.status, 0, r.err)
            self.assertEqual(r.json["warnings"], [])
            kinds = ["stl", "3mf", "dxf", "svg", "step"]
            for file in [f"gear{i}.{k}" for i in (1, 2) for k in kinds] + ["pair.glb", "report.html", "result.json"]:
                self.assertIn(f"made/{file}", r.files())
            saved = json.loads((r.folder / "made/result.json").read_text())
            self.assertEqual(saved["pair"], r.json["pair"])
            for f in r.json["files"]:
                if f["max_deviation_um"] is not None:
                    self.assertLess(f["max_deviation_um"], 5.0001)
            page = (r.folder / "made/report.html").read_text()
            self.assertNotIn("involute", page.split(">Specification</h2>")[0])

    def test_export_in_place(self):
        r = Run("export", DOUBLE, "--dxf", "both.dxf", "--svg", "one.svg", "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual(r.files(), ["both.dxf", "case.toml", "one.svg"])


if __name__ == "__main__":
    unittest.main()
