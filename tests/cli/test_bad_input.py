"""Tests each kind of invalid input. The program returns the documented exit status and a message with the
key, and writes no incomplete file."""
import math
import os
import re
import subprocess
import unittest

from cli import BIN, PAIR, Run, raw

GEAR = "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 10\n"


def two(extra1="", extra2="", pair=""):
    body = "teeth = 20\nnormal_module_mm = 2\nface_width_mm = 10\n"
    return f"[gear1]\n{body}{extra1}\n[gear2]\n{body}{extra2}\n[pair]\n{pair}\n"


class BadInput(unittest.TestCase):
    def refused(self, spec, key, *words, verb="pair"):
        r = Run(verb, spec, "--json")
        self.assertEqual(r.status, 1, f"{spec}\n{r.err}")
        self.assertEqual(r.json["error"]["key"], key, r.err)
        for word in words:
            self.assertIn(word, r.err)
        self.assertEqual(r.files(), ["case.toml"])

    def test_values_out_of_range(self):
        for line, key in (("teeth = 0", "teeth"), ("teeth = 17.5", "teeth"), ("normal_module_mm = -1", "normal_module_mm"),
                          ("normal_module_mm = inf", "normal_module_mm"), ("normal_module_mm = \"2\"", "normal_module_mm")):
            spec = "\n".join(line if l.startswith(key) else l for l in GEAR.splitlines())
            self.refused(spec, "gear1." + key, key, verb="gear")
        for line in ("helix_angle_deg = 95", "profile_shift = nan", "tip_diameter_mm = 10", "normal_pressure_angle_deg = 0",
                     "thickness_allowance_mm = inf"):
            self.refused(GEAR + line, "gear1." + line.split(" =")[0], line.split(" =")[0], verb="gear")

    def test_unknown_key_names_the_nearest(self):
        self.refused(GEAR.replace("teeth", "teeeth"), "gear1.teeeth", "teeth", verb="gear")
        self.refused(GEAR + "profile_shfit = 0.1", "gear1.profile_shfit", "profile_shift", verb="gear")
        self.refused(GEAR + "[gear1.rack]\ndedendumm = 1.2", "gear1.rack.dedendumm", "dedendum", verb="gear")
        self.refused(GEAR + "[gear3]\nteeth = 3", "gear3", "gear", verb="gear")

    def test_contradictions_name_both(self):
        self.refused(GEAR + "normal_diametral_pitch_per_in = 10", "gear1.normal_diametral_pitch_per_in",
                     "normal_module_mm", verb="gear")
        self.refused(GEAR + "helix_angle_deg = 10\nlead_angle_deg = 70\nhand = \"right\"", "gear1.lead_angle_deg",
                     "helix_angle_deg", verb="gear")
        # If a value is given twice, both must agree.
        self.assertEqual(Run("gear", GEAR + "normal_diametral_pitch_per_in = 12.7").status, 0)

    def test_impossible_pairs(self):
        self.refused(two(pair="center_distance_mm = 30"), "pair.center_distance_mm", "greater than")
        equal = ("helix_angle_deg = 10", "helix_angle_deg = 10")
        self.refused(two(*equal, "shaft_angle_deg = 0"), "pair.shaft_angle_deg", "-10")
        self.refused(two(*equal), "gear2.helix_angle_deg", "-10", "shaft_angle_deg = 20")
        unlike = two("helix_angle_deg = 10", "helix_angle_deg = 20")
        self.assertIn("default_shaft_angle", [w["code"] for w in Run("pair", unlike, "--json").json["warnings"]])
        self.refused(two("helix_angle_deg = 10", "helix_angle_deg = 30", "shaft_angle_deg = 170"), "pair.shaft_angle_deg", "outside the possible range")
        self.refused(two(*equal, "shaft_angle_deg = -20"), "pair.shaft_angle_deg", "outside the possible range")
        self.refused(two("helix_angle_deg = 10", "helix_angle_deg = -10", "shaft_angle_deg = 5"), "pair.shaft_angle_deg", "parallel")
        self.refused(two(*equal, "shaft_angle_deg = 200"), "pair.shaft_angle_deg", "180")
        ring = two(*equal).replace("teeth = 20", "teeth = -60").replace("teeth = -60", "teeth = 20", 1)
        self.refused(ring.replace("helix_angle_deg = 10", "helix_angle_deg = 15", 1), "gear2.helix_angle_deg", "same hand")
        self.refused(two("", "").replace("normal_module_mm = 2\nface_width_mm = 10\n\n[pair]", "normal_module_mm = 3\n[pair]"),
                     "gear2.normal_module_mm", "base pitch")
        self.refused(two("profile_shift = -0.5", "profile_shift = -0.5"), "gear1.profile_shift", "greater than")
        self.refused(two("", "").replace("teeth = 20", "teeth = -20", 1), "gear1.teeth", "internal gear")
        self.refused(GEAR, "gear2", "gear2")
        self.refused(two("teeth_ = 1"), "gear1.teeth_", "teeth")

    def test_too_small_a_distance_is_negative_backlash_not_an_error(self):
        r = Run("pair", two("profile_shift = 0.2", "profile_shift = 0.2", "center_distance_mm = 40.5"), "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertLess(r.json["pair"]["backlash"]["normal_mm"], 0)
        self.assertIn("negative_backlash", [w["code"] for w in r.json["warnings"]])

    def test_gears_that_cannot_exist_are_answers(self):
        r = Run("gear", GEAR.replace("20", "3") + "profile_shift = -1", "--json")
        self.assertEqual(r.status, 0, r.err)
        gear = r.json["gears"][0]
        self.assertTrue(gear["severed"] or gear["through_axis"])
        self.assertEqual(Run("outline", GEAR.replace("20", "3") + "profile_shift = -1").status, 1)
        # The report of `run` states why the gear does not exist. There are no CAD files.
        r = Run("run", GEAR.replace("20", "3") + "profile_shift = -1")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual(r.files(), ["case.toml", "case_out/report.html", "case_out/result.json"])

    def test_an_allowance_that_removes_the_teeth_is_named(self):
        """Regression: a thick allowance was reported as a wrong profile shift."""
        thin = GEAR.replace("teeth = 20", "teeth = 17")
        mate = "\n[gear2]\nteeth = 40\nface_width_mm = 10\n"
        for allowance in ("-3.5", "-6", "[-3.6, -3]"):
            spec = thin + f"thickness_allowance_mm = {allowance}" + mate
            self.refused(spec, "gear1.thickness_allowance_mm", "must be at least -2.")
        spec = thin + "thickness_allowance_mm = -6"
        r = Run("export", spec, "--stl", "a.stl", "--json")
        self.assertEqual(r.json["error"]["key"], "gear1.thickness_allowance_mm", r.err)
        self.refused(thin + "thickness_allowance_mm = [-3, 3]" + mate, "gear1.thickness_allowance_mm")

    def test_a_backlash_is_found_up_to_the_limit_of_the_cutters(self):
        """Regression: a first step beyond the limit was reported as a limit of the backlash."""
        spec = two("profile_shift = -1.873", "profile_shift = 1.873", "backlash_mm = {}")
        spec = spec.replace("teeth = 20", "teeth = 40").replace("teeth = 40", "teeth = 20", 1)
        for backlash in (0.001, 0.005, 0.02):
            answer = Run("pair", spec.format(backlash), "--json").json
            self.assertAlmostEqual(answer["pair"]["backlash"]["normal_mm"], backlash, delta=1e-9)
        self.refused(spec.format(0.03), "pair.backlash_mm", "at most 0.02915")
        # Regression: the teeth must become thicker, but the first step made them thinner, which is impossible.
        apart = spec.replace("backlash_mm", "center_distance_mm = 60.1\nbacklash_mm")
        self.assertAlmostEqual(Run("pair", apart.format(0.06), "--json").json["pair"]["backlash"]["normal_mm"], 0.06, delta=1e-9)

    def test_an_impossible_distance_names_the_distance_without_shifts(self):
        spec = "[gear1]\nteeth = 200\nnormal_module_mm = 1\n[gear2]\nteeth = 200\n[pair]\ncenter_distance_mm = 15000\n"
        self.refused(spec, "pair.center_distance_mm", ". Without profile shifts, the centre distance is 200.0000 mm.")

    def test_a_profile_shift_has_a_range(self):
        """The printed limit leaves a tooth, and a shift that is greater by 0.0002 does not."""
        for shift in (3, 30):
            r = Run("pair", two(f"profile_shift = {shift}"), "--json")
            limit = float(re.search(r"at most ([0-9.]+) leaves a tooth", r.json["error"]["message"])[1])
            for x, cut in ((limit, False), (limit + 0.0002, True)):
                gear = Run("gear", GEAR + f"profile_shift = {x}", "--json").json["gears"][0]
                self.assertEqual(gear["severed"], cut, x)
        # Oracle: m_n (z1 + z2)/2 = 40
        self.refused(two(pair="center_distance_mm = 60"), "pair.center_distance_mm",
                     "Without profile shifts, the centre distance is 40.0000 mm")

    def test_a_wrong_unit_or_type_names_the_remedy(self):
        self.refused(GEAR.replace("20", '"20"'), "gear1.teeth", "write it without quotes", verb="gear")
        self.refused(two(pair="center_distance_in = 3"), "pair.center_distance_in",
                     'did you mean center_distance_mm = 76.2? A length in inch needs units = "inch"')
        # Oracle: the cutter is pointed at the dedendum 1.25 if tan α_n = π/(4 · 1.25)
        self.refused(GEAR + "normal_pressure_angle_deg = 45", "gear1.normal_pressure_angle_deg",
                     f"less than {math.degrees(math.atan(math.pi / 5)):.6g}°", verb="gear")

    def test_racks(self):
        rack = GEAR + "[gear1.rack]\n"
        self.refused(rack + "root_fillet_radius = 0.9", "gear1.rack.root_fillet_radius", "greatest", verb="gear")
        self.refused(rack + "dedendum = 9", "gear1.rack.dedendum", "the greatest dedendum is", verb="gear")
        self.refused(rack + "semi_topping_angle_deg = 45", "gear1.rack.semi_topping_angle_deg", "tool_addendum", verb="gear")
        self.refused(rack + "protuberance = 0.1\nprotuberance_angle_deg = 25", "gear1.rack.protuberance_angle_deg", verb="gear")
        self.refused(GEAR + "rack = \"ISO53-E\"", "gear1.rack", "ISO53-A", verb="gear")

    def test_bores(self):
        r = Run("export", GEAR + "[gear1.bore]\ndiameter_mm = 39", "--stl", "a.stl", "--json")
        self.assertEqual(r.status, 1)
        self.assertEqual(r.json["error"]["key"], "gear1.bore.diameter_mm")
        self.assertEqual(r.files(), ["case.toml"])

    def test_all_verbs_have_one_limit_of_a_bore(self):
        """Regression: pair, STEP and STL named limits of 36.250, 36.249 and 36.248 mm, and 18 teeth as a remedy."""
        spec = two("[gear1.bore]\ndiameter_mm = 36").replace("teeth = 20", "teeth = 17", 1)
        texts = [Run("pair", spec).out + Run("pair", spec).err]
        texts += [Run("run", spec, "--only", kind).err for kind in ("step", "stl")]
        found = [" ".join(text.split()) for text in texts]
        limits = [re.search(r"at most ([0-9.]+) mm, so that it lies", text)[1] for text in found]
        self.assertEqual(len(set(limits)), 1, limits)
        self.assertIn("With a bore of", found[0])
        self.assertNotIn("teeth on gear 1", found[0])

    def test_what_is_not_in_this_version_says_so(self):
        self.refused(GEAR + "[gear1.modifications]\ntip_relief_um = 20", "gear1.modifications.tip_relief_start_mm", "missing", verb="gear")
        self.refused(two(pair="shaft_angle_deg = 90"), "pair.shaft_angle_deg", "parallel")

    def test_files_that_are_no_spec(self):
        for text in ("", "   \n", "[", "teeth", "[gear1]\nteeth = ", "[gear1", b"\xef\xb3\xbf", b"\x00\x01\xff", "x = 1979-05-27"):
            r = Run("gear", text, "--json")
            self.assertEqual(r.status, 1, repr(text))
            self.assertTrue(r.json["error"]["message"])
        for text in ("{", "[]", "{\"gear1\": 3}", "{\"gear1\": {\"teeth\": 1e400}}"):
            self.assertEqual(Run("gear", text, "--json", name="case.json").status, 1, text)

    def test_nesting_is_bounded(self):
        deep = "{\"a\":" * 100_000 + "1" + "}" * 100_000
        for text, name in ((deep, "case.json"), ("[" * 700_000, "case.json"), ("[" + "a." * 100_000 + "a]\n", "case.toml"),
                           ("a." * 100_000 + "a = 1\n", "case.toml")):
            self.assertEqual(Run("gear", text, "--json", name=name).status, 1, text[:20])

    def test_utf_16_is_named(self):
        for encoding in ("utf-16-le", "utf-16-be"):
            r = Run("gear", ("\ufeff" + GEAR).encode(encoding))
            self.assertEqual(r.status, 1, r.err)
            self.assertIn("is UTF-16 text; save it as UTF-8", r.err)

    def test_any_bytes_give_one_json_object(self):
        for text in (b'{"gear1": "\xff"}', b'{"gear1":{"teeth":17,"normal_module_mm":2},"title":"\xff"}',
                     ('{"gear1": {"teeth": 20, "normal_module_mm": 2, "rack": "x' + "ä" * 50 + '"}}').encode()):
            r = Run("gear", text, "--json", name="case.json")
            self.assertEqual(r.status, 1)
            self.assertIsNotNone(r.json, r.out)
        r = Run("gear", GEAR + '"k\\u001b[31m" = 1')
        self.assertEqual(r.status, 1)
        self.assertNotIn("\x1b", r.err)
        self.assertEqual(Run("gear", '{"gear1": {"teeth": 17, "teeth": 18, "normal_module_mm": 2}}', name="case.json").status, 1)

    def test_wild_numbers_name_their_key(self):
        for line in ("profile_shift = 1e20", "thickness_allowance_mm = 1e300", "face_width_mm = 1e300", "helix_angle_deg = 89.9999",
                     "tip_diameter_mm = 1e300", "normal_pressure_angle_deg = 1e-300", "face_width_mm = 5e-324"):
            spec = "\n".join(l for l in GEAR.splitlines() if not l.startswith(line.split(" =")[0])) + "\n" + line
            r = Run("run", spec, "--json")
            self.assertEqual(r.status, 1, line + r.err)
            self.assertEqual(r.json["error"]["key"], "gear1." + line.split(" =")[0])
            self.assertEqual(r.files(), ["case.toml"])

    def test_too_large_to_be_of_use_leaves_nothing(self):
        r = Run("export", GEAR.replace("face_width_mm = 10", "face_width_mm = 10000\nhelix_angle_deg = 20"), "--stl", "a.stl")
        self.assertEqual(r.status, 1)
        self.assertIn("vertices", r.err)
        self.assertEqual(r.files(), ["case.toml"])

    def test_outputs_do_not_overwrite_each_other_or_the_spec(self):
        for args in (("--stl", "a.x", "--glb", "./a.x"), ("--svg", "case.toml")):
            r = Run("export", GEAR, *args)
            self.assertEqual(r.status, 2, args)
            self.assertEqual(r.files(), ["case.toml"])
        self.assertEqual(Run("export", GEAR, "--stl", "a.stl", "--mesh-tolerance", "nan").status, 2)

    def test_different_racks_need_their_numbers(self):
        other = "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 10\n{}\n[gear2]\nteeth = 30\nnormal_pressure_angle_deg = 25\nnormal_module_mm = 2.0736721767743314\nface_width_mm = 10\n{}\n[pair]\n{}"
        self.assertEqual(Run("pair", other.format("", "", "")).status, 0)
        thin = Run("pair", other.format("thickness_allowance_mm = -0.1", "", ""), "--json").json["pair"]
        self.assertGreater(thin["backlash"]["normal_mm"], 0.09)
        self.refused(other.format("", "", 'mounting = "extended"'), "pair.mounting", "module")
        self.refused(other.format("", "", "shorten_tips = true"), "pair.shorten_tips", "module")
        self.refused(other.format("profile_shift = 0", "", "center_distance_mm = 51"), "gear2.profile_shift", "module")

    def test_what_is_not_read_is_said(self):
        r = Run("pair", two(pair="friction_coefficient = 0.05") + "[gear1.measured]\ntip_diameter_mm = 44", "--json")
        self.assertEqual(sum(w["code"] == "not_read" for w in r.json["warnings"]), 0)
        self.assertGreater(r.json["pair"]["efficiency"]["gear1_drives"], 0.98)

    def test_teeth_that_do_not_meet_have_no_contact_ratio(self):
        r = Run("pair", two("profile_shift = 0", "profile_shift = 0", "center_distance_mm = 45"), "--json")
        self.assertEqual(r.json["pair"]["contact_ratio_true"], 0)
        self.assertIn("no_contact", [w["code"] for w in r.json["warnings"]])

    def test_shortening_never_lengthens_and_is_the_same_in_every_verb(self):
        apart = two(pair="center_distance_mm = 41\nshorten_tips = true").replace("face_width_mm = 10", "face_width_mm = 10\nprofile_shift = 0")
        self.assertEqual(Run("pair", apart, "--json").json["gears"][0]["tip_diameter_mm"], 44)
        spec = two("profile_shift = 0.5", "profile_shift = 0.5", "shorten_tips = true")
        a, b = (Run(v, spec, "--json").json["gears"][0]["tip_diameter_mm"] for v in ("gear", "pair"))
        self.assertEqual(a, b)
        self.assertLess(a, 46)

    def test_huge_file_is_refused_at_once(self):
        r = Run("gear", b"# " + b"x" * 100_000_000, "--json")
        self.assertEqual(r.status, 1)
        self.assertIn("bytes", r.err)

    def test_command_line(self):
        for args in ((), ("nonsense",), ("gear",), ("gear", "x.toml", "--bogus"), ("outline", "x.toml", "--gear", "3"),
                     ("outline", "x.toml", "--points", "1"), ("export", "x.toml")):
            self.assertEqual(raw(*args).returncode, 2, args)

    def test_outside_world(self):
        self.assertEqual(raw("gear", "/no/such/file.toml").returncode, 3)
        self.assertEqual(raw("gear", "/").returncode, 3)
        r = Run("run", PAIR, "--out", "/proc/nothing/here")
        self.assertEqual(r.status, 3, r.err)
        self.assertIn("--out selects another folder", r.err)
        r = Run("export", PAIR, "--gear", 1, "--stl", "/no/such/folder/a.stl")
        self.assertEqual(r.status, 3)
        self.assertIn("/no/such/folder/a.stl", r.err)
        with open("/dev/full", "w") as full:
            p = subprocess.run([BIN, "gear", r.spec], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(p.returncode, 3)

    def test_full_disk_leaves_no_half_file(self):
        # A limit of the file size has the same effect as a full disk.
        r = Run("gear", PAIR)
        p = subprocess.run(["bash", "-c", f"ulimit -f 8; trap '' XFSZ; exec '{BIN}' run '{r.spec}' --out '{r.folder}/o'"],
                           capture_output=True, text=True)
        self.assertEqual(p.returncode, 3, p.stderr)
        for f in os.listdir(r.folder / "o"):
            self.assertFalse(f.endswith(".part"), f)
            self.assertLess((r.folder / "o" / f).stat().st_size, 8 * 1024 + 1)


if __name__ == "__main__":
    unittest.main()
