"""Tests the verdict: the last line of every listing, `verdict` in every JSON, and the exit status 4 with
--strict."""

import json
import unittest

from cli import SOURCE, Run

GREEN = """
[gear1]
teeth = 20
normal_module_mm = 2
face_width_mm = 20
profile_shift = 0.2
thickness_allowance_mm = -0.05
[gear2]
teeth = 41
normal_module_mm = 2
face_width_mm = 20
"""
AMBER = GREEN.replace("teeth = 20", "teeth = 15").replace("profile_shift = 0.2", "profile_shift = 0")
RED = GREEN + "profile_shift = 0\n[pair]\ncenter_distance_mm = 61\n"
ASKEW = GREEN + "[errors]\ncrossing_deg = 0.05\nintersecting_deg = 0.3\n"
MISALIGNED = """
[gear1]
teeth = 24
normal_module_mm = 2.5
helix_angle_deg = 15
profile_shift = 0.3
face_width_mm = 28
thickness_allowance_mm = -0.05
[gear1.modifications]
lead_slope_um = {slope}
lead_crowning_um = 8
profile_crowning_um = 4
[gear2]
teeth = {teeth}
thickness_allowance_mm = -0.05
[errors]
crossing_deg = {crossing}
[contact]
positions = 16
driver = {driver}
"""


class VerdictTest(unittest.TestCase):
    def test_every_verb_that_mounts_a_pair_says_it(self):
        for verb in ("pair", "contact", "run"):
            for spec, level in ((GREEN, "green"), (AMBER, "amber"), (RED, "red")):
                with self.subTest(verb=verb, level=level):
                    said = Run(verb, spec, "--json").json["verdict"]
                    self.assertEqual(said["level"], level, said["headline"])
                    text = Run(verb, spec)
                    self.assertEqual(text.status, 0)
                    last = " ".join(text.out[text.out.rindex("\nVerdict:") :].split())
                    self.assertEqual(last, f"Verdict: {level}. {said['headline']}")
                    if level != "green":
                        worst = said["findings"][0]
                        self.assertEqual(worst["level"], level)
                        self.assertTrue(worst["remedy"])
                        self.assertTrue(worst["change"])

    def test_the_advised_slope_centres_the_contact(self):
        """Regression: the advice was 7 µm where -31 µm centres the contact. With 7 µm an edge touched at every position,
        and the contact off the middle was then no finding of its own."""
        for teeth, driver, crossing in ((40, 1, 0.069), (40, 1, -0.072), (40, 2, 0.074), (40, 2, -0.078), (71, 1, -0.078),
                                        (71, 2, -0.064), (-60, 1, 0.078), (-60, 2, 0.077)):
            with self.subTest(teeth=teeth, driver=driver, crossing=crossing):
                def contact(slope=0):
                    run = Run("contact", MISALIGNED.format(teeth=teeth, driver=driver, crossing=crossing, slope=slope), "--json").json
                    heights = [p["height_mm"][0] for p in run["contact"]["positions"]]
                    return run, sum(heights) / len(heights) / 14

                given = contact()[0]["verdict"]["findings"]
                advice = next(f for f in given if f["code"] == "contact_place")
                slope = advice["change"]["gear1.modifications.lead_slope_um"]
                self.assertIn(f"With a lead slope of {slope:g} µm on gear 1, the contact lies in the middle", advice["remedy"])
                run, place = contact(slope)
                self.assertLess(abs(place), 0.05)
                self.assertFalse({f["code"] for f in run["verdict"]["findings"]} & {"contact_place", "edge_contact"})
                for other in (slope - 8, slope + 8):
                    self.assertGreater(abs(contact(other)[1]), 0.15)

    def test_advice_that_does_not_help_is_not_given(self):
        """The crossing of 2° is far beyond the slopes that a flank can have."""
        run = Run("contact", MISALIGNED.format(teeth=40, driver=1, crossing=2, slope=0), "--json").json
        self.assertFalse([f for f in run["verdict"]["findings"] if "lies in the middle" in (f["remedy"] or "")])

    def test_a_gear_alone_has_one_too(self):
        cut_through = "[gear1]\nteeth = 4\nnormal_module_mm = 2\nprofile_shift = -0.6\nface_width_mm = 10\n"
        said = Run("gear", cut_through, "--json").json["verdict"]
        self.assertEqual(said["level"], "red")
        self.assertIn("Gear 1 cannot be made as specified", said["headline"])
        self.assertEqual([Run("gear", cut_through).status, Run("gear", cut_through, "--strict").status], [0, 4])
        self.assertIn("Verdict: green. The gear can be cut as specified.",
                      Run("gear", GREEN.split("[gear2]")[0]).out)

    def test_the_cause_of_an_unusual_gear_is_named(self):
        gear = "[gear1]\nteeth = 20\nnormal_module_mm = 3\nface_width_mm = 25\n"
        for more, words in (
            ("tip_diameter_mm = 90", ("can be cut, but not to its tip diameter", "With a tip diameter of 68")),
            ("thickness_allowance_mm = -4", ("allowance of -4.0000 mm causes the undercut",
                                             "With a thickness allowance of -0.37 mm")),
            ("rack = { dedendum = 1.4, root_fillet_radius = 0.3, protuberance = 0.4 }",
             ("The protuberance of the cutter, 1.2000 mm, removes the flank",)),
        ):
            out = " ".join(Run("gear", gear + more + "\n").out.split())
            for part in words:
                self.assertIn(part, out)
        single = " ".join(Run("gear", gear.replace("20", "1", 1)).out.split())
        self.assertIn("root_fillet can replace the root", single)
        self.assertIn("With 18 teeth on gear 1, gear 1 can be cut without undercut", single)

    def test_a_bore_that_leaves_no_body_is_no_gear(self):
        for gear, limit in (
            ({"teeth": 20, "bore": {"diameter_mm": 19}}, "17.498"),
            ({"teeth": 20, "bore": {"diameter_mm": 17, "keyway_width_mm": 5, "keyway_depth_mm": 2}}, "keyway"),
            ({"teeth": -60, "bore": {"diameter_mm": 60}}, "62.5"),
        ):
            spec = {"gear1": {"normal_module_mm": 1, "face_width_mm": 10, **gear}}
            run = Run("gear", json.dumps(spec), "--json", name="spec.json")
            self.assertEqual(run.status, 0, run.err)
            self.assertEqual(run.json["verdict"]["level"], "red", gear)
            finding = run.json["verdict"]["findings"][0]
            self.assertEqual(finding["code"], "no_body")
            self.assertIn(limit, finding["message"])

    def test_a_thin_rim_is_a_caution(self):
        """The rim thickness factor of ISO 6336-3 is defined above half the tooth height, or 1.75 m_n for a ring. Regression:
        a rim of 0.05 mm was green."""
        for gear, thick, thin in (({"teeth": 24}, 19.2, 21.4),  # d_f = 21.5, h = 2.25
                                  ({"teeth": -48}, 54.1, 50.7)):  # d_f = 50.5
            def run(bore):
                spec = {"gear1": {**gear, "normal_module_mm": 1, "face_width_mm": 6, "bore": {"diameter_mm": bore}}}
                return Run("gear", json.dumps(spec), "--json", name="spec.json").json["verdict"]
            self.assertNotIn("thin_rim", [f["code"] for f in run(thick)["findings"]])
            finding = run(thin)["findings"][0]
            self.assertEqual((finding["code"], finding["level"]), ("thin_rim", "amber"))
            enough = finding["change"]["gear1.bore.diameter_mm"]
            self.assertNotIn("thin_rim", [f["code"] for f in run(enough)["findings"]])
            self.assertLessEqual(abs(enough - (19.25 if gear["teeth"] > 0 else 54.0)), 0.101)

    def test_a_remedy_has_the_numbers_of_the_pair(self):
        near = "[gear1]\nteeth = 12\nnormal_module_mm = 2\n[gear2]\nteeth = 40\n[pair]\ncenter_distance_mm = 50.5\n"
        said = Run("pair", near, "--json").json["verdict"]
        self.assertIn("requires profile shifts with a sum of -0.65", said["headline"])
        self.assertIn("reference centre distance is 52 mm", said["headline"])
        # The remedy is the greatest tip diameter, in steps of 0.01 mm, at which there is no finding.
        long = GREEN.replace("teeth = 41", "teeth = 41\ntip_diameter_mm = 88")
        found = next(f for f in Run("pair", long, "--json").json["verdict"]["findings"] if f["code"] == "form_circle")
        (key, tip), = found["change"].items()
        self.assertEqual(key, "gear2.tip_diameter_mm")
        self.assertIn(f"With a tip diameter of {tip:g} mm on gear 2", found["remedy"])
        for d, clear in ((tip, True), (tip + 0.01, False)):
            level = Run("pair", long.replace("= 88", f"= {d}"), "--json").json["verdict"]["level"]
            self.assertEqual(level == "green", clear, d)

    def test_tolerances_are_judged_at_their_worst_ends(self):
        tight = """
[gear1]
teeth = 17
normal_module_mm = 2
face_width_mm = 20
[gear2]
teeth = 43
face_width_mm = 20
[pair]
center_distance_mm = 60
"""
        self.assertEqual(Run("pair", tight, "--json").json["verdict"]["level"], "green")
        tolerated = tight + 'center_distance_tolerance = "JS7"\n'
        said = Run("pair", tolerated, "--json").json
        worst = said["verdict"]["findings"][0]
        self.assertEqual((said["verdict"]["level"], worst["code"]), ("red", "negative_backlash"))
        self.assertEqual(worst["at"], "At a centre distance of 59.9850 mm")
        self.assertEqual(worst["values"]["backlash_mm"], said["pair"]["interval"]["backlash"]["normal_mm"][1])
        (key, allowance), = worst["change"].items()
        self.assertEqual(key, "gear1.thickness_allowance_mm")
        thinner = tolerated.replace("teeth = 17", f"teeth = 17\nthickness_allowance_mm = {allowance}")
        self.assertEqual(Run("pair", thinner, "--json").json["verdict"]["level"], "green")
        # The nominal pair has one backlash. The tolerance of the centre distance changes it.
        thinned = Run("pair", tolerated + "backlash_mm = 0.12\n", "--json").json
        least = thinned["pair"]["interval"]["backlash"]["normal_mm"][1]
        self.assertAlmostEqual(least, 0.12 - 0.0109, places=3)
        self.assertNotIn("thickness_allowance_mm", thinned["gears"][0]["interval"])

    def test_each_verb_names_what_it_did_not_judge(self):
        spec = (SOURCE / "examples" / "loaded_pair.toml").read_text().replace("positions = 32\nslices = 24", "positions = 4\nslices = 8")
        spec = spec.replace("[80, 250]", "[80]")
        for verb, pending in (("gear", ["pair"]), ("pair", ["contact", "load"]), ("contact", ["load"]), ("load", ["contact"])):
            verdict = Run(verb, spec, "--json").json["verdict"]
            self.assertEqual((verdict["level"], verdict["not_judged"]), ("green", pending), verb)
        self.assertIn("Parts that are not judged: contact, load.", " ".join(Run("pair", spec).out.split()))
        ran = Run("run", spec, "--json", "--only", "result").json["verdict"]
        self.assertEqual((ran["level"], ran["not_judged"]), ("green", []))

    def test_a_pinion_of_eight_teeth_wants_more_shift_and_then_a_shorter_tip(self):
        spec = "[gear1]\nteeth = 8\nnormal_module_mm = 2\nprofile_shift = {}\nface_width_mm = 20\n[gear2]\nteeth = 24\n"
        def worst(x):
            return Run("pair", spec.format(x), "--json").json["verdict"]["findings"][0]
        red = worst(0)
        self.assertEqual(red["code"], "contact_ratio")
        self.assertGreater(red["change"]["gear1.profile_shift"], 0)
        self.assertIn("the contact ratio is 1.", red["remedy"])
        pointed = worst(0.62)
        self.assertEqual(pointed["code"], "pointed")
        self.assertLess(pointed["change"]["gear1.tip_diameter_mm"], 22.48)

    def test_a_correction_at_its_bound_is_said(self):
        example = (SOURCE / "examples" / "misaligned_pair.toml").read_text().split("[compensate.range]")[0]
        askew = example + "[compensate.range]\ncrossing_deg = [0.1, 0.2]\n"
        j = Run("compensate", askew, "--json").json
        self.assertTrue(j["compensate"]["corrections"][0]["at_bound"])
        self.assertEqual(j["compensate"]["corrections"][0]["spec_key"].split(".")[:2], ["gear1", "modifications"])
        self.assertIn("correction_at_bound", [w["code"] for w in j["warnings"]])
        self.assertRegex(" ".join(Run("compensate", askew).out.split()), "The .* of gear 1 is at the end of the range.")

    def test_strict_ends_in_4_unless_it_is_green(self):
        for verb in ("pair", "contact", "run"):
            for spec, status in ((GREEN, 0), (AMBER, 4), (RED, 4)):
                with self.subTest(verb=verb, status=status):
                    self.assertEqual(Run(verb, spec, "--strict").status, status)
                    self.assertEqual(Run(verb, spec, "--strict", "--json").status, status)
                    self.assertEqual(Run(verb, spec).status, 0)

    def test_findings_stand_worst_first(self):
        order = ["red", "amber", "green"]
        levels = [f["level"] for f in Run("pair", RED, "--json").json["verdict"]["findings"]]
        self.assertEqual(levels, sorted(levels, key=order.index))

    def test_an_edge_that_touches_is_no_green(self):
        verdict = Run("contact", ASKEW, "--json").json["verdict"]
        codes = [f["code"] for f in verdict["findings"] if f["level"] != "green"]
        self.assertIn("edge_contact", codes)
        self.assertNotEqual(verdict["level"], "green")
        # Without its errors, the same pair is green.
        self.assertEqual(Run("pair", ASKEW, "--json").json["verdict"]["level"], "green")

    def test_compensate_judges_the_corrected_pair_under_its_errors(self):
        wrong = ASKEW.replace("crossing_deg = 0.05", "crossing_deg = 5") + "[compensate]\ncorrections = [\"gear1.lead_slope_um\"]\n"
        self.assertEqual(Run("contact", wrong, "--json").json["verdict"]["level"], "red")
        left = Run("compensate", wrong, "--json")
        self.assertEqual(left.status, 0, left.err)
        taken = Run("contact", json.dumps(left.json["compensate"]["spec"]), "--json", name="better.json").json
        self.assertEqual(left.json["verdict"]["level"], taken["verdict"]["level"])
        self.assertEqual(left.json["verdict"]["level"], "red")
        self.assertEqual(Run("compensate", wrong, "--strict").status, 4)

    def test_numbers_without_the_errors_are_called_so(self):
        wide = GREEN + "[errors]\ncenter_distance_mm = 0.5\n"
        self.assertIn("Without errors: The pair runs", Run("contact", wide, "--json").json["verdict"]["headline"])
        self.assertNotIn("Without errors", Run("pair", wide, "--json").json["verdict"]["headline"])

    def test_axes_that_cross_unasked_are_no_green(self):
        slip = GREEN.replace("teeth = 41", "helix_angle_deg = -14\nteeth = 41").replace(
            "teeth = 20", "helix_angle_deg = 12\nteeth = 20")
        self.assertEqual(Run("pair", slip, "--json").json["verdict"]["level"], "amber")

    def test_the_page_says_the_same(self):
        ran = Run("run", ASKEW)
        result = json.loads((ran.folder / "case_out/result.json").read_text())
        page = (ran.folder / "case_out/report.html").read_text()
        level = result["verdict"]["level"]
        self.assertIn(f'<p class="verdict {level}"><b>{level}</b>', page)
        self.assertIn("An edge is in contact during", page)


if __name__ == "__main__":
    unittest.main()
