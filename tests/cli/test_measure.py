"""Tests the inspection of a gear as a workshop needs it: tools, tolerances, and the identification of the
gear."""
import json
import math
import tomllib
import unittest

from cli import SOURCE, Asked, Run

GEAR = """
[gear1]
teeth = 20
normal_module_mm = 2
face_width_mm = 20
"""
BROKEN = (SOURCE / "examples/broken_gear.toml").read_text()
THINNED = """
units = "inch"
[gear1]
teeth = 32
helix_angle_deg = 0
[gear1.measured]
span_in = { 4 = 0.4475, 5 = 0.5703 }
tip_diameter_in = 1.416
[gear2]
teeth = 64
[pair]
center_distance_in = 2.0
"""


def with_tools(lines, gear=GEAR):
    return gear + "[gear1.measure]\n" + lines + "\n"


class Measuring(Asked):
    def measure(self, spec):
        return self.ok("measure", spec)["gears"][0]["measure"]

    def test_tools_are_chosen_or_asked_for(self):
        usual = self.measure(GEAR)
        self.assertEqual(usual["span"]["teeth"], 3)
        self.assertEqual(usual["span"]["contact"], "usable")
        self.assertAlmostEqual(usual["span"]["length_mm"], 15.32087875196761, 11)
        self.assertEqual([s["teeth"] for s in usual["spans"]], [1, 2, 3, 4])
        self.assertEqual(usual["over_balls"]["ball_diameter_mm"], usual["ball_sizes"]["metric_mm"])
        asked = self.measure(with_tools("span_teeth = 2\nball_diameter_mm = 3.5\npin_diameter_mm = 4\nchord_diameter_mm = 41"))
        self.assertEqual(asked["span"]["teeth"], 2)
        self.assertAlmostEqual(asked["over_balls"]["dimension_mm"], 44.92929001744306, 11)
        self.assertAlmostEqual(asked["over_pins"]["three_mm"], 46.55188732875178, 11)
        self.assertEqual(asked["tooth_thickness"]["diameter_mm"], 41)
        # Balls have the diameter of the given pins, unless such balls do not touch the flanks.
        pins = self.measure(with_tools("pin_diameter_mm = 3.5"))
        self.assertEqual(pins["over_balls"], asked["over_balls"])
        self.assertIn("Span measurement", Run("measure", GEAR).out)

    def test_what_cannot_be_measured_is_named(self):
        for line, key, word in (("span_teeth = 9", "span_teeth", "1 to 4 teeth"), ("span_teeth = 21", "span_teeth", "between 1 and 20"),
                                ("ball_diameter_mm = 1", "ball_diameter_mm", "too small to touch both flanks"),
                                ("ball_diameter_mm = 9", "ball_diameter_mm", "rests on the tips"),
                                ("ball_diameter_mm = 2.6", "ball_diameter_mm", "does not project"),
                                ("pin_diameter_mm = 1", "pin_diameter_mm", "too small"), ("span_teeth = 2.5", "span_teeth", "whole"),
                                ("ball_diameter_mm = -1", "ball_diameter_mm", "greater than 0")):
            self.refused(with_tools(line), "gear1.measure." + key, word, verb="measure")
        ring = GEAR.replace("20\nnormal", "-60\nhelix_angle_deg = 12\nnormal")
        self.refused(with_tools("span_teeth = 6", ring), "gear1.measure.span_teeth", "balls", verb="measure")
        self.refused(with_tools("pin_diameter_mm = 3.5", ring), "gear1.measure.pin_diameter_mm", "balls", verb="measure")
        m = self.measure(ring)
        self.assertIsNone(m["span"])
        self.assertIsNone(m["over_pins"]["three_mm"])

    def test_reasons_are_those_of_the_gear(self):
        ring = "[gear1]\nteeth = -80\nnormal_module_mm = 2\nhelix_angle_deg = 15\nface_width_mm = 20\n"
        self.assertIn("because plane anvils do not fit", " ".join(Run("measure", ring).out.split()))
        small = "[gear1]\nteeth = 30\nnormal_module_mm = 0.4\nface_width_mm = 3\nquality = 6\n"
        self.assertIn("normal module of 0.4 mm is outside its range", " ".join(Run("measure", small).out.split()))
        for line in ("quality,flank tolerance class,,,6,", "edition,edition of ISO 1328-1,,,ISO 1328:2013,"):
            self.assertIn("gears.measure.tolerances." + line, Run("measure", small, "--csv").out)
        self.assertIn("ISO 1328-1:2013 has the flank tolerance classes 1 to 11",
                      Run("measure", small.replace("quality = 6", "quality = 13")).err)
        self.assertIn('thickness_series = "25cd": must be',
                      Run("measure", small + '[gear1.tolerance]\nthickness_series = "25cd"\n').err)

    def test_a_contact_off_the_flank_is_a_warning(self):
        j = self.ok("measure", with_tools("span_teeth = 5"))
        self.assertEqual(j["gears"][0]["measure"]["span"]["contact"], "beyond_tip")
        self.assertIn("span_off_flank", [w["code"] for w in j["warnings"]])

    def test_tolerances_of_the_flanks(self):
        t = self.measure(GEAR + "quality = 6")["tolerances"]
        self.assertEqual(t["single_pitch_um"], 8.5)  # (0.04 + 0.8 + 5) √2 = 8.26
        self.assertNotIn("tolerances", self.measure(GEAR))
        old = self.measure(GEAR + '[gear1.tolerance]\nquality = 6\nedition = "ISO 1328:1995"')["tolerances"]
        self.assertNotEqual(old["profile_total_um"], t["profile_total_um"])
        self.refused(GEAR + "quality = 12", "gear1.quality", "1 to 11", verb="measure")
        self.refused(GEAR + "quality = 12\n[gear2]\nteeth = 43\n[scatter]\n", "gear1.quality", "1 to 11", verb="scatter")
        self.refused(GEAR + "quality = 6\n[gear1.tolerance]\nquality = 7", "gear1.tolerance.quality", "contradicts", verb="measure")

    def test_tolerances_of_a_pair(self):
        old = '[gear{}.tolerance]\nquality = 6\nedition = "ISO 1328:1995"\n'
        pair = GEAR + "[gear2]\nteeth = 41\nface_width_mm = 18\n[pair]\nbearing_span_mm = 36\n" + old.format(1) + old.format(2)
        t = [g["measure"]["tolerances"] for g in self.ok("measure", pair)["gears"]]
        for one in t:
            self.assertAlmostEqual(one["base_pitch_um"], one["single_pitch_um"] * math.cos(math.radians(20)), 9)
            self.assertGreater(one["single_flank_composite_um"], one["tooth_single_flank_composite_um"])
            self.assertEqual(one["axis_deviation_um"], max(a["helix_total_um"] for a in t))  # L = 2 b
            self.assertEqual(one["axis_inclination_um"], 2 * one["axis_deviation_um"])
        self.assertGreater(t[1]["sector_pitch_um"], t[1]["single_pitch_um"])
        alone = self.measure(GEAR + old.format(1))["tolerances"]
        self.assertIsNone(alone["single_flank_composite_um"])
        self.assertIsNone(alone["axis_deviation_um"])
        later = self.ok("measure", pair.replace("1995", "2013"))["gears"][0]["measure"]["tolerances"]
        self.assertGreater(later["sector_pitch_um"], later["single_pitch_um"])
        self.assertLess(later["sector_pitch_um"], later["cumulative_pitch_um"])
        self.assertIsNotNone(later["base_pitch_um"])

    def test_three_pins_lie_deeper_than_two_where_teeth_are_odd(self):
        for teeth, beta in ((20, 0), (21, 0), (21, 12), (-61, 0)):
            pins = self.measure(GEAR.replace("teeth = 20", f"teeth = {teeth}\nhelix_angle_deg = {beta}"))["over_pins"]
            side = 1 if teeth > 0 else -1
            d_K = pins["center_diameter_mm"]
            c = math.cos(math.pi / (2 * abs(teeth))) if teeth % 2 and not beta else 1
            self.assertAlmostEqual(pins["three_mm"], d_K * c + side * pins["pin_diameter_mm"], 9)
            self.assertAlmostEqual(pins["three_pins_mm"], d_K * c * c + side * pins["pin_diameter_mm"], 9)

    def test_intervals_in_json_and_for_people(self):
        spec = GEAR + "thickness_allowance_mm = [-0.10, -0.06]"
        m = self.measure(spec)
        lower, upper = m["interval"]["span"]["length_mm"]
        self.assertLess(lower, m["span"]["length_mm"])
        self.assertGreater(upper, m["span"]["length_mm"])
        self.assertLess(*m["interval"]["over_balls"]["dimension_mm"])
        out = Run("measure", spec).out
        self.assertIn("gear 1 lower", out)
        self.assertIn("gear 1 upper", out)
        self.refused(GEAR + "thickness_allowance_mm = [-0.06, -0.10]", "gear1.thickness_allowance_mm", "in rising order", verb="gear")
        self.refused(GEAR + "thickness_allowance_mm = [-0.06, 0, 1]", "gear1.thickness_allowance_mm", verb="gear")
        self.refused(GEAR + 'thickness_allowance_mm = 0\n[gear1.tolerance]\nthickness_series = "cd25"',
                     "gear1.tolerance.thickness_series", "thick", verb="gear")
        self.refused(GEAR + '[gear1.tolerance]\nthickness_series = "zz25"', "gear1.tolerance.thickness_series", "DIN 3967", verb="gear")
        self.refused(GEAR + "[gear1.tolerance]\ntip_diameter_deviations_mm = [0.0, -0.01]",
                     "gear1.tolerance.tip_diameter_deviations_mm", "in rising order", verb="gear")
        fit = GEAR + '[gear1.tolerance]\ntip_diameter_fit = "{}"\n'
        gear = self.ok("gear", fit.format("h9"))["gears"][0]
        lower, upper = gear["interval"]["tip_diameter_mm"]
        self.assertEqual(upper, gear["tip_diameter_mm"])
        self.assertLess(lower, upper)
        self.refused(fit.format("H9"), "gear1.tolerance.tip_diameter_fit", "h1 to h12", "shaft", verb="gear")
        self.refused(fit.format("h9") + "tip_diameter_deviations_mm = [-0.1, 0.0]", "gear1.tolerance.tip_diameter_fit",
                     "tip_diameter_deviations_mm", verb="gear")

    def test_nominal_points_for_a_measuring_machine(self):
        r = Run("measure", GEAR + "[gear1.modifications]\nlead_crowning_um = 10\n", "--points", "9x5")
        self.assertEqual(r.status, 0, r.err)
        head, *rows = r.out.splitlines()
        self.assertEqual(head, "gear,flank,diameter_mm,height_mm,x_mm,y_mm,z_mm,nx,ny,nz")
        self.assertEqual(len(rows), 2 * 9 * 5)
        *_, nx, ny, nz = map(float, rows[0].split(",")[2:])
        self.assertAlmostEqual(nx * nx + ny * ny + nz * nz, 1, 12)
        for grid in ("9", "1x5", "9x", "9x5x2", "9y5", "9x1001"):
            self.assertEqual(Run("measure", GEAR, "--points", grid).status, 2, grid)

    def test_nominal_points_of_the_root_fillet(self):
        r = Run("measure", GEAR, "--points", "9x5", "--fillet-points", "6")
        self.assertEqual(r.status, 0, r.err)
        rows = [row.split(",") for row in r.out.splitlines()[1:]]
        self.assertEqual([sum(row[1] == flank for row in rows) for flank in ("right", "right_fillet", "left", "left_fillet")],
                         [45, 30, 45, 30])
        fillet = [row for row in rows if row[1] == "left_fillet"]
        gear = self.ok("gear", GEAR)["gears"][0]
        self.assertAlmostEqual(float(fillet[0][2]), gear["root_diameter_mm"], 9)
        self.assertAlmostEqual(float(fillet[5][2]), gear["root_form_diameter_mm"], 9)
        self.assertEqual({row[3] for row in fillet}, {row[3] for row in rows if row[1] == "left"})
        self.assertEqual(Run("measure", GEAR, "--fillet-points", "6").status, 2)
        self.assertEqual(Run("measure", GEAR, "--points", "9x5", "--fillet-points", "1").status, 2)

    def test_active_diameters_of_a_mounted_gear(self):
        alone = self.measure(GEAR)["flank"]
        self.assertNotIn("active_root_diameter_mm", alone)
        pair = GEAR + "[gear2]\nteeth = 31\nface_width_mm = 20\n"
        flanks = [g["measure"]["flank"] for g in self.ok("measure", pair)["gears"]]
        mounted = self.ok("pair", pair)["pair"]
        for flank, root in zip(flanks, mounted["contact_root_diameter_mm"]):
            self.assertAlmostEqual(flank["active_root_diameter_mm"], root, 9)
            self.assertAlmostEqual(flank["active_tip_roll_length_mm"], flank["tip_form_roll_length_mm"], 9)
        self.assertIn("active root diameter", Run("measure", pair).out)
        # If gears cannot be mounted, they can still be measured.
        apart = self.ok("measure", pair + "normal_module_mm = 3\n")["gears"][0]["measure"]
        self.assertNotIn("active_root_diameter_mm", apart["flank"])

    def test_the_page_has_what_is_measured(self):
        r = Run("run", GEAR + "quality = 6\nthickness_allowance_mm = [-0.1, -0.06]\n", "--only", "report", "--out", "out")
        self.assertEqual(r.status, 0, r.err)
        page = (r.folder / "out/report.html").read_text()
        for word in ("Inspection", "Span measurement", "Gear 1, profile", "band of 11", "Gear 1 at the limits of the thickness allowance"):
            self.assertTrue(word in page, word)

    def identified(self, spec):
        """Returns the result of `identify` without the specs, which contain all other keys of the given spec."""
        found = self.ok("identify", spec)["identify"]
        for candidate in found["candidates"]:
            del candidate["spec"]
        return found

    def test_the_mating_gear_and_the_distance_of_the_pair_are_readings(self):
        inside = ('[gear1]\nteeth = 21\n[gear1.measured]\ntip_diameter_mm = 45.9\n'
                  'mating_teeth = 43\ncenter_distance_mm = 64\n')
        beside = ('[gear1]\nteeth = 21\n[gear1.measured]\ntip_diameter_mm = 45.9\n'
                  '[gear2]\nteeth = 43\n[pair]\ncenter_distance_mm = 64\n')
        self.assertEqual(self.identified(inside), self.identified(beside))
        alone = inside.replace("mating_teeth = 43\ncenter_distance_mm = 64\n", "")
        self.assertNotEqual(self.identified(alone), self.identified(beside))
        swapped = ('[gear1]\nteeth = 43\nmaterial = "16MnCr5"\nface_width_mm = 20\n[gear2]\nteeth = 21\n'
                   '[gear2.measured]\ntip_diameter_mm = 45.9\n[pair]\ncenter_distance_mm = 64\n')
        self.assertEqual(self.identified(swapped)["candidates"], self.identified(beside)["candidates"])
        for old, new, key, word in (("teeth = 43", "teeth = 43.5", "gear2.teeth", "whole"),
                                    ("teeth = 43", "teeth = 43\nmodul = 2", "gear2.modul", "module"),
                                    ("= 64", "= -64", "pair.center_distance_mm", "greater than 0")):
            self.refused(beside.replace(old, new), key, word, verb="identify")
        taken = Run("identify", beside, "--take", 1)  # the result is a complete pair
        self.assertAlmostEqual(self.ok("pair", taken.out)["pair"]["center_distance_mm"], 64, delta=1e-12)

    def test_readings_that_are_not_used_are_named(self):
        """Regression: readings of gear 2 had no effect and no message beside readings of gear 1."""
        both = ('[gear1]\nteeth = 17\nhelix_angle_deg = 0\n[gear1.measured]\ntip_diameter_mm = 19.0\n'
                '[gear2]\nteeth = 51\n[gear2.measured]\ntip_diameter_mm = 53.0\n')
        answer = self.ok("identify", both)
        self.assertEqual([(w["code"], w["gear"]) for w in answer["warnings"]], [("not_read", 2)])
        self.assertIn("gear2.measured was not used", " ".join(Run("identify", both).out.split()))
        first = Run("identify", both, "--take", 1).out
        second = Run("identify", first, "--take", 1).out
        pair = self.ok("pair", second)
        self.assertEqual([g["normal_module_mm"] for g in pair["gears"]], [1, 1])
        self.assertEqual([g["tip_diameter_mm"] for g in pair["gears"]], [19, 53])

    def test_a_gear_from_its_readings(self):
        found = self.ok("identify", BROKEN)["identify"]
        first = found["candidates"][0]
        self.assertEqual((first["normal_module_mm"], first["normal_pressure_angle_deg"]), (2.5, 20))
        self.assertAlmostEqual(first["helix_angle_deg"], 18, 9)
        self.assertAlmostEqual(first["profile_shift"], 0.2170, 3)
        self.assertGreater(first["uncertainty"]["profile_shift"], 0)
        self.assertIn(" 18.000 ", Run("identify", BROKEN).out)
        taken = Run("identify", BROKEN, "--take", 1)
        spec = tomllib.loads(taken.out)
        self.assertEqual(spec["gear1"]["normal_module_mm"], 2.5)
        again = self.measure(taken.out + "[gear1.measure]\nspan_teeth = 3\nball_diameter_mm = 5\n")
        self.assertAlmostEqual(again["span"]["length_mm"], 19.751, 2)
        self.assertAlmostEqual(again["over_balls"]["dimension_mm"], 69.426, 2)
        self.assertEqual(json.loads(Run("identify", BROKEN, "--take", 1, "--json").out), first["spec"])
        self.assertEqual(first["spec"]["gear1"], spec["gear1"])
        self.assertEqual(Run("identify", BROKEN, "--take", 99).status, 1)
        self.refused(BROKEN, "gear1.normal_module_mm", "identify", verb="gear")
        self.refused(GEAR, "gear1.measured", "missing", verb="identify")
        self.refused(BROKEN.replace("3 = 19.751", "x = 19.751"), "gear1.measured.span_mm", "number of teeth", verb="identify")
        self.refused(BROKEN.replace("teeth = 23", ""), "gear1.teeth", verb="identify")

    def test_contradictory_readings_are_named(self):
        wrong = BROKEN.replace("4 = 27.131", "4 = 27.431, 5 = 34.511")
        said = self.ok("identify", wrong)["identify"]["contradiction"]
        self.assertEqual((said["reading"], said["tool"]), ("span", 4))
        self.assertAlmostEqual(said["expected"], 27.131, 2)
        self.assertIn("contradicts", Run("identify", wrong).out)

    def test_an_identified_gear_has_an_allowance_instead_of_a_shift(self):
        taken = Run("identify", THINNED, "--take", 1)
        spec = tomllib.loads(taken.out)
        self.assertEqual(spec["gear1"]["profile_shift"], 0)
        self.assertAlmostEqual(spec["gear1"]["thickness_allowance_in"], -0.0017, delta=0.0006)  # ± of the spans
        self.assertEqual(spec["gear1"]["rack"], "AGMA-20")
        pair = Run("pair", taken.out, "--json").json
        self.assertEqual(pair["gears"][1]["profile_shift"], 0)  # the mating gear is standard
        self.assertGreater(pair["pair"]["backlash"]["normal_in"], 0.001)
        self.assertIn("The spec describes x_E = ", Run("identify", THINNED).out)
        # A backlash of the pair determines the thickness.
        wanted = THINNED.replace("center_distance_in", "backlash_in = 0.003\ncenter_distance_in")
        spec = tomllib.loads(Run("identify", wanted, "--take", 1).out)
        self.assertEqual(spec["gear1"]["profile_shift"], 0)
        self.assertNotIn("thickness_allowance_in", spec["gear1"])

    def test_the_rack_of_an_identified_gear(self):
        stub = ('units = "inch"\n[gear1]\nteeth = 24\nhelix_angle_deg = 0\n[gear1.measured]\n'
                'span_in = { 3 = 0.4800, 4 = 0.6645 }\ntip_diameter_in = 1.598\n')
        spec = tomllib.loads(Run("identify", stub, "--take", 1).out)["gear1"]
        self.assertEqual(spec["rack"], "AGMA-stub")
        self.assertAlmostEqual(spec["tip_diameter_in"], 1.6, 9)
        old = ('units = "inch"\n[gear1]\nteeth = 40\nhelix_angle_deg = 0\n[gear1.measured]\n'
               'span_in = { 4 = 0.6768, 5 = 0.8669 }\ntip_diameter_in = 2.624\nroot_diameter_in = 2.347\n')
        taken = Run("identify", old, "--take", 1).out
        self.assertEqual(tomllib.loads(taken)["gear1"]["rack"], "AGMA-14.5")
        self.assertAlmostEqual(Run("gear", taken, "--json").json["gears"][0]["root_diameter_in"], 2.347, 2)
        wrong = Run("identify", old.replace("2.347", "2.300"))
        self.assertIn("root diameter contradicts the other readings, because it is 2.3 in", wrong.out)

    def test_mistakes_that_explain_readings(self):
        counted = Run("identify", THINNED.replace("teeth = 32", "teeth = 31"))
        self.assertIn("tip diameter contradicts", counted.out)
        self.assertIn("all readings agree with a gear of 32 teeth with DP 24", counted.out)
        mixed = Run("identify", THINNED.replace("1.416", "35.97"))
        self.assertIn("If the tip diameter is in mm", mixed.out)
        self.assertIn("implausible", mixed.out)
        in_mm = THINNED.replace("0.4475", "11.3665").replace("0.5703", "14.4856").replace("1.416", "35.97")
        in_mm = in_mm.split("[gear2]")[0]
        self.assertIn("If all lengths are in mm", Run("identify", in_mm).out)
        found = Run("identify", in_mm, "--json").json["identify"]["alternative"]
        self.assertEqual((found["mistake"], found["gear"]["normal_diametral_pitch_per_in"]), ("all", 24))
        self.assertIsNone(Run("identify", THINNED, "--json").json["identify"]["alternative"])

    def test_an_unknown_gear_keeps_its_other_keys(self):
        more = BROKEN.replace("teeth = 23\n", 'teeth = 23\nmaterial = "16MnCr5"\nquality = 7\n')
        more += "[gear1.bore]\ndiameter_mm = 20\n"
        spec = tomllib.loads(Run("identify", more, "--take", 1).out)
        self.assertEqual(spec["gear1"]["bore"], {"diameter_mm": 20})
        self.assertEqual(spec["gear1"]["quality"], 7)
        self.assertIn("material", spec["gear1"])
        self.assertEqual(Run("gear", Run("identify", more, "--take", 1).out).status, 0)
        self.refused(more.replace("diameter_mm = 20", "diameter_mm = -20"), "gear1.bore.diameter_mm", "greater than 0", verb="identify")
        known = BROKEN.replace("teeth = 23\n", "teeth = 23\nthickness_allowance_mm = -0.05\n")
        spec = tomllib.loads(Run("identify", known, "--take", 1).out)["gear1"]
        self.assertEqual(spec["thickness_allowance_mm"], -0.05)
        self.assertAlmostEqual(spec["profile_shift"], 0.2170 + 0.05 / (5 * math.tan(math.radians(20))), 3)
        rack = BROKEN.replace("teeth = 23\n", 'teeth = 23\nrack = "ISO53-D"\n')
        self.assertEqual(tomllib.loads(Run("identify", rack, "--take", 1).out)["gear1"]["rack"], "ISO53-D")
        for key, line in (("lead_angle_deg", "lead_angle_deg = 72"), ("transverse_pressure_angle_deg", "transverse_pressure_angle_deg = 20")):
            self.refused(BROKEN.replace("teeth = 23\n", f"teeth = 23\n{line}\n"), "gear1." + key, "unknown gear", verb="identify")

    def test_an_unmeasured_mate_and_the_usual_tips_are_named(self):
        readings = '[gear1]\nteeth = 23\n[gear1.measured]\nspan_mm = { 2 = 9.55, 3 = 15.43 }\ntip_diameter_mm = 52.1\n'
        alone = " ".join(Run("identify", readings).out.split())
        self.assertNotIn("is not measured", alone)
        self.assertIn("usual tip", alone)
        self.assertIn("This measurement also distinguishes candidate 1 from candidates", alone)
        for candidate in self.ok("identify", readings)["identify"]["candidates"]:
            self.assertIn(f'{candidate["drawing"]["nominal_tip_diameter_mm"]:.3f}', alone)
        with_mate = readings + "[gear2]\nteeth = 61\n[pair]\ncenter_distance_mm = 88.5\n"
        words = "The profile shift of gear 2 is not measured; the program computes it from the centre distance."
        self.assertIn(words, " ".join(Run("identify", with_mate).out.split()))
        taken = Run("identify", with_mate, "--take", 1).out
        self.assertIn(words, " ".join(taken.replace("#", " ").split()))
        self.assertNotIn(words, Run("identify", with_mate.replace("teeth = 61", "teeth = 61\nprofile_shift = 0")).out)

    def test_readings_that_no_gear_has(self):
        """The readings of a spur gear and a lead contradict each other, because the lead of a spur gear is infinite."""
        spur = ("[gear1]\nteeth = 23\n[gear1.measured]\nspan_mm = {3 = 19.4272, 4 = 26.8075}\ntip_diameter_mm = 63\n"
                "over_balls_mm = [{ball_diameter_mm = 4.5, dimension_mm = 64.3665}]\n")
        self.assertIn("585 mm instead of infinite", " ".join(Run("identify", spur + "lead_mm = 585\n").out.split()))
        contradiction = self.ok("identify", spur + "lead_mm = 585\n")["identify"]["contradiction"]
        self.assertEqual((contradiction["reading"], contradiction["expected"]), ("lead", None))
        for more, key in (("lead_mm = 585\nhelix_angle_deg = 0\n", "lead_mm"),
                          ("lead_mm = -585\nhelix_angle_deg = 15\n", "lead_mm"),
                          ("root_diameter_mm = 70\n", "root_diameter_mm")):
            self.refused(spur + more, f"gear1.measured.{key}", "", verb="identify")


if __name__ == "__main__":
    unittest.main()
