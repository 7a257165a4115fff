"""Tests a rack as gear 2: its quantities, section, solids and report, and the messages of verbs that do
not support racks."""

import json
import math
import re
import tempfile
import unittest
from pathlib import Path

from cli import Run

RACK = """[gear1]
teeth = 20
normal_module_mm = 2
face_width_mm = 25
[gear2]
form = "rack"
"""


class ARack(unittest.TestCase):
    def test_the_shortest_spec_is_answered(self):
        r = Run("pair", RACK)
        self.assertEqual(r.status, 0, r.err)
        for words in ("travel per turn of the pinion", "125.6637", "Verdict: green. The rack and pinion run"):
            self.assertIn(words, r.out)
        r = Run("pair", RACK, "--csv")
        self.assertIn("pair.travel_mm_per_turn,", r.out)
        self.assertIn("rack.transverse_pitch_mm,", r.out)

    def test_a_contact_ratio_below_one_is_an_answer_with_a_remedy(self):
        # A rack has no second gear whose face width could be changed.
        pinion = '[gear1]\nteeth = 8\nnormal_module_mm = 2\n'
        rack = '[gear2]\nform = "rack"\n'
        spur = json.loads(Run("pair", pinion + rack, "--json").out)
        self.assertLess(spur["pair"]["contact_ratio_true"], 1)
        change = spur["verdict"]["findings"][0]["change"]
        better = pinion + f"profile_shift = {change['gear1.profile_shift']}\n" + rack
        self.assertGreaterEqual(json.loads(Run("pair", better, "--json").out)["pair"]["contact_ratio_true"], 1)
        narrow = Run("pair", pinion + "helix_angle_deg = 10\nface_width_mm = 1\n" + rack, "--json")
        self.assertLess(json.loads(narrow.out)["pair"]["contact_ratio_true"], 1)
        self.assertIn("contact_ratio", json.loads(narrow.out)["verdict"]["findings"][0]["code"])

    def test_a_rack_without_a_size_has_files(self):
        r = Run("run", RACK, "--out", "o")
        self.assertEqual(r.status, 0, r.err)
        self.assertIn("Verdict: green.", r.out)
        text = " ".join((r.out + r.err).split())
        self.assertIn("The number of teeth of the rack is not given; pictures and files contain 21 teeth", text)
        self.assertIn("The height of the rack is not given; 8.5 mm (3 modules below the roots) is used", text)
        self.assertTrue((r.folder / "o/gear2.step").exists())
        self.assertTrue("The mesh at the pitch point" in (r.folder / "o/report.html").read_text())

    def test_gear_and_pair_give_both_parts(self):
        for verb in ("gear", "pair"):
            r = Run(verb, RACK + "teeth = 30\nheight_mm = 18\n", "--json")
            answer = json.loads(r.out)
            self.assertEqual(answer["gears"][1]["form"], "rack")
            self.assertAlmostEqual(answer["gears"][1]["length_mm"], 30 * 6.283185307179586, 12)
            self.assertEqual(answer["pair"]["kind"], "rack_and_pinion")
            self.assertEqual(answer["pair"]["mounting_distance_mm"], 20 + 18)

    def test_contact_under_errors_is_that_of_a_large_wheel(self):
        # A wheel of 4000 teeth has the radius r = 4000 mm. Its results differ from those of a rack by the
        # order of 1/z2.
        errors = "[gear1.modifications]\nlead_crowning_um = 10\nprofile_crowning_um = 5\n" \
                 "[errors]\ncrossing_deg = 0.02\ncenter_distance_mm = 0.05\n[contact]\npattern = true\n"
        rack = json.loads(Run("contact", RACK + errors, "--json").out)["contact"]
        wheel = RACK.replace('form = "rack"', "teeth = 4000")
        large = json.loads(Run("contact", wheel + errors, "--json").out)["contact"]
        to_um = math.radians(1 / 3600) * 4000e3
        self.assertAlmostEqual(rack["peak_to_peak_um"], large["peak_to_peak_arcsec"] * to_um, delta=0.02)
        self.assertAlmostEqual(rack["continuous_peak_to_peak_um"],
                               large["continuous_peak_to_peak_arcsec"] * to_um, delta=0.02)
        for a, b in zip(rack["positions"], large["positions"]):
            self.assertAlmostEqual(a["transmission_error_um"], b["transmission_error_arcsec"] * to_um, delta=0.2)
            self.assertAlmostEqual(a["diameter_mm"][0], b["diameter_mm"][0], delta=0.1)
            self.assertIsNone(a["diameter_mm"][1])
            self.assertNotIn("rotation2_deg", a)
        slopes = rack["sensitivity"]["crossing_per_deg"]["transmission_error_um"]
        of_wheel = large["sensitivity"]["crossing_per_deg"]["transmission_error_arcsec"]
        self.assertAlmostEqual(slopes[32], of_wheel[32] * to_um, delta=0.01 * abs(slopes[32]))
        self.assertNotIn("helix_slope2_per_um", rack["sensitivity"])
        self.assertEqual(list(rack["pattern"]), ["gear1"])

    def test_contact_without_errors_is_exact(self):
        r = Run("contact", RACK)
        self.assertEqual(r.status, 0, r.err)
        for words in ("contact on", "µm", "Verdict: green"):
            self.assertIn(words, r.out)
        answer = json.loads(Run("contact", RACK, "--json").out)["contact"]
        self.assertLess(answer["peak_to_peak_um"], 1e-9)
        self.assertAlmostEqual(answer["least_play_mm"], 0, 12)
        header = Run("contact", RACK, "--csv").out.splitlines()[0]
        self.assertIn("transmission_error_um", header)
        self.assertNotIn("arcsec", header)

    def test_what_a_rack_cannot_be_is_said(self):
        for verb, extra, *words in (
                ("load", "", "gear2.form", "The verbs gear, pair, contact, outline, export and run",
                 "teeth = 200", "docs/spec.md"),
                ("contact", "[errors]\nhelix_slope2_um = 5\n", "errors.helix_slope2_um", "rack"),
                ("contact", "[contact.map]\nx = \"crossing_deg\"\nx_range = [-0.1, 0.1]\n"
                 "y = \"center_distance_mm\"\ny_range = [0, 0.1]\n", "contact.map", "two gears"),
                ("rate", "", "gear2.form", "needs two gears"),
                ("scatter", "", "gear2.form", "needs two gears"),
                ("fit", "", "gear2.form", "needs two gears"),
                ("outline --gear 2", "teeth = 9\nheight_mm = 9\nthickness_allowance_mm = 2\n",
                 "gear2.thickness_allowance_mm", "closes at the root"),
                ("run", "teeth = 9\nheight_mm = 9\n[rating]\ntorque_Nm = 50\n", "rating", "gear 2 is a rack"),
                ("pair", "[pair]\nshaft_angle_deg = 0\n", "pair.shaft_angle_deg", "backlash_mm"),
                ("pair", "thickness_allowance_mm = -0.1\n[pair]\nbacklash_mm = 0.1\n", "pair.backlash_mm",
                 "gear2.thickness_allowance_mm"),
                ("pair", "teeth = 9\nlength_mm = 90\n", "length_mm", "teeth"),
                ("pair", "length_mm = 6.28\n", "gear2.length_mm = 6.28", "between 6.28319 mm", "1 and of 100 000 teeth"),
                ("pair", "length_mm = 1e8\n", "gear2.length_mm", "628319", "100 000 teeth"),
                ("pair", "profile_shift = 0.2\n", "gear2.profile_shift", "does not apply to a rack"),
                ("pair", "tip_relief = 9\n", "gear2.tip_relief", "unknown key"),
                ("pair", "teeth = 0\n", "gear2.teeth", "1")):
            with self.subTest(verb=verb, extra=extra):
                verb, *options = verb.split()
                r = Run(verb, RACK + extra, *options)
                self.assertEqual(r.status, 1)
                for w in words:
                    self.assertIn(w, r.err)
        r = Run("pair", RACK.replace("teeth = 20", "teeth = -60"))
        self.assertEqual(r.status, 1)
        self.assertIn("gear1.teeth = -60: the pinion of a rack must be an external gear", r.err)

    def refused(self, verb, spec, *words):
        verb, *options = verb.split()
        r = Run(verb, spec, *options)
        self.assertEqual(r.status, 1, r.out)
        for w in words:
            self.assertIn(w, r.err)
        self.assertEqual(r.files(), ["case.toml"])
        return r.err

    def test_all_verbs_have_the_same_limits_of_the_body(self):
        """Regression: `pair` was green, and `run` wrote the files of the pinion only."""
        for verb in ("gear", "pair", "contact", "outline --gear 2", "export --step x.step", "run --out o"):
            for line, *words in (("height_mm = 1", "gear2.height_mm = 1: must be at least 2.501 mm"),
                                 ("height_mm = 1e8", "gear2.height_mm", "must be at most 200000 mm"),
                                 ("face_width_mm = 1e-9", "gear2.face_width_mm", "between 0.002 mm and 200000 mm")):
                with self.subTest(verb=verb, line=line):
                    self.refused(verb, RACK + line + "\n", *words)

    def test_no_contact_names_its_cause(self):
        # The tip radius and the addendum are 22 mm and 2 mm.
        pair = RACK + "[pair]\ncenter_distance_mm = 25\n"
        err = self.refused("contact", pair, "pair.center_distance_mm = 25: no teeth touch", "reach only 24 mm",
                           "a smaller centre distance")
        self.assertNotIn("errors", err)
        self.refused("contact", RACK + "[errors]\ncenter_distance_mm = 5\n", "errors: no teeth touch", "smaller errors")

    def test_a_misspelled_form_names_both_forms(self):
        for word in ("Rack", "rak"):
            self.refused("pair", RACK.replace('"rack"', f'"{word}"'), f'gear2.form = "{word}": must be one of "gear", "rack"',
                         "did you mean rack?")

    def test_a_pinion_without_teeth_has_a_remedy(self):
        self.refused("pair", RACK.replace("teeth = 20", "teeth = 1"), "gear1.profile_shift = 0", "root_fillet can replace")

    def test_a_length_gives_the_whole_teeth_that_fit(self):
        pitch = 2 * math.pi
        for length, teeth in ((100, 15), (repr(15 * pitch), 15), (15 * pitch - 1e-6, 14), (16 * pitch + 0.01, 16)):
            answer = json.loads(Run("pair", RACK + f"length_mm = {length}\n", "--json").out)
            rack, pair = answer["gears"][1], answer["pair"]
            self.assertEqual(rack["teeth"], teeth)
            self.assertAlmostEqual(rack["length_mm"], teeth * pitch, 12)
            self.assertFalse([w for w in answer["warnings"] if "number of teeth of the rack" in w["message"]])
            # The path of contact from A to E, computed from the tip circle and the tip line, lies between the
            # ends of the rack at both ends of the usable travel.
            alpha = math.radians(20)
            r_b = 20 * math.cos(alpha)
            recess = math.sqrt(22**2 - r_b**2) - 20 * math.sin(alpha)
            reach = max(recess, 2 / math.sin(alpha)) * math.cos(alpha)
            self.assertAlmostEqual(pair["usable_travel_mm"], teeth * pitch - 2 * reach, 9)
        self.assertEqual(json.loads(Run("pair", RACK + "teeth = 1\n", "--json").out)["pair"]["usable_travel_mm"], 0)
        self.assertIsNone(json.loads(Run("pair", RACK, "--json").out)["pair"]["usable_travel_mm"])
        self.assertIn("usable travel", Run("pair", RACK + "length_mm = 100\n").out)

    def test_a_rack_without_teeth_is_an_error(self):
        # The tooth is half a pitch thick, 3.14 mm.
        r = Run("pair", RACK + "thickness_allowance_mm = -4.95\n")
        self.assertEqual(r.status, 1, r.out)
        self.assertIn("gear2.thickness_allowance_mm = -4.95", r.err)

    def test_a_backlash_thins_pinion_and_rack(self):
        helical = RACK.replace("[gear2]", "helix_angle_deg = 20\nprofile_shift = 0.2\n[gear2]")
        for where in ("", "center_distance_mm = 21.8\n"):
            for key, of in (("backlash_mm = 0.12", lambda b, r: b["normal_mm"]),
                            ("backlash_circumferential_mm = 0.12", lambda b, r: b["circumferential_mm"][0]),
                            ("backlash_deg = 0.12", lambda b, r: b["rotation_deg"])):
                answer = json.loads(Run("pair", helical + "[pair]\n" + where + key + "\n", "--json").out)
                pair, gears = answer["pair"], answer["gears"]
                self.assertAlmostEqual(of(pair["backlash"], gears), 0.12, 10)
                # Both teeth have the same thinning, which is measured at the reference circle and the datum line.
                nominal = math.pi + 2 * 0.2 * 2 * math.tan(math.radians(20))
                first = gears[0]["reference_tooth_thickness_normal_mm"] - nominal
                second = gears[1]["reference_tooth_thickness_normal_mm"] - math.pi
                self.assertAlmostEqual(first, second, 10)
        split = json.loads(Run("pair", RACK + "[pair]\nbacklash_mm = 0.12\nbacklash_split = 1\n", "--json").out)
        self.assertAlmostEqual(split["gears"][1]["reference_tooth_thickness_normal_mm"], math.pi, 12)
        thick = Run("pair", RACK + "[pair]\nbacklash_mm = 0.1\ncenter_distance_mm = 20.5\n")
        self.assertIn("made thicker than their profile shifts require, by 0.263", " ".join((thick.out + thick.err).split()))

    def test_the_section_is_that_of_the_basic_rack(self):
        r = Run("outline", RACK + "teeth = 9\nheight_mm = 12\n", "--gear", "2", "--json")
        self.assertEqual(r.status, 0, r.err)
        arcs = {a["name"]: a["points"] for a in json.loads(r.out)["arcs"]}
        self.assertEqual(list(arcs), ["root_land", "root_fillet", "flank", "tip_land"])
        self.assertEqual(arcs["root_land"][0], [-2.5, math.pi])
        self.assertEqual(arcs["tip_land"][-1], [2.0, 0.0])
        for x, y in arcs["flank"]:
            self.assertAlmostEqual(y, math.pi / 2 - x * math.tan(math.radians(20)), 13)

    def test_files_of_the_rack_and_of_the_assembly(self):
        for helix in ("", "helix_angle_deg = 20\n"):
            spec = RACK.replace("[gear2]", helix + "[gear2]") + "teeth = 10\nheight_mm = 12\n"
            with self.subTest(helix=helix), tempfile.TemporaryDirectory() as folder:
                out = Path(folder) / "out"
                r = Run("run", spec, "--out", out)
                self.assertEqual(r.status, 0, r.err)
                self.assertRegex(r.out, r"drawing\.pdf +PDF drawing +A4, scale [0-9:]+, [0-9:]+,")
                written = {p.name for p in out.iterdir()}
                kinds = ("step", "stl", "3mf", "dxf", "svg")
                self.assertLessEqual({f"gear{i}.{k}" for i in (1, 2) for k in kinds}, written)
                self.assertLessEqual({"pair.step", "pair.glb", "report.html", "result.json", "drawing.pdf"}, written)
                page = (out / "report.html").read_text()
                for words in ("rack and pinion</p>", "The mesh at the pitch point", "Travel per turn"):
                    self.assertTrue(words in page, words)
                # The drawing of the rack alone has the size of the bar, 10 pitches by 14 mm, and a margin.
                length = 10 * 2 * math.pi / math.cos(math.radians(20 if helix else 0))
                w, h = map(float, re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', (out / "gear2.svg").read_text()).groups())
                self.assertAlmostEqual(h - w, length - 14, 5)
                # All triangles of the solid are inside the bar.
                triangles = (out / "gear2.stl").read_bytes()
                self.assertEqual(len(triangles), 84 + 50 * int.from_bytes(triangles[80:84], "little"))

    def test_the_rack_has_a_drawing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "rack.svg"
            r = Run("export", RACK + "teeth = 26\nheight_mm = 12\n", "--gear", "2", "--drawing", path)
            self.assertEqual(r.status, 0, r.err)
            texts = re.findall(r"<text[^>]*>([^<]*)</text>", path.read_text())
            # Length 26 p_t, back to datum line, back to tips, and the dimension over a pin of 3.25 mm.
            over = 12 + (3.25 / math.cos(math.radians(20)) - math.pi) / (2 * math.tan(math.radians(20))) + 3.25 / 2
            for words in ("163.363", "12", "14", "Section in the middle of the face width"):
                self.assertIn(words, texts)
            rack = json.loads(Run("pair", RACK + "teeth = 26\nheight_mm = 12\n", "--json").out)["gears"][1]
            self.assertEqual(rack["pin_diameter_mm"], 3.25)
            self.assertAlmostEqual(rack["over_pin_mm"], over, 12)
            self.assertIn(f"{over:.4f}".rstrip("0"), texts)

    def test_parts_that_are_not_judged_are_named(self):
        judged = lambda verb: Run(verb, RACK + "[errors]\ncrossing_deg = 0.02\n", "--json").json["verdict"]["not_judged"]
        self.assertEqual([judged("pair"), judged("contact")], [["contact"], []])

    def test_the_report_shows_the_contact_under_errors(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            r = Run("run", RACK + "[errors]\ncrossing_deg = 0.02\n", "--out", out)
            self.assertEqual(r.status, 0, r.err)
            contact = json.loads((out / "result.json").read_text())["contact"]
            self.assertIn("peak_to_peak_um", contact)
            page = (out / "report.html").read_text()
            for words in ("Minimum backlash along the rack", "rack moves evenly", "transmission error, µm"):
                self.assertTrue(words in page, words)

    def test_a_rack_that_jams_is_red(self):
        r = Run("pair", RACK + "[pair]\ncenter_distance_mm = 19.9\n", "--strict")
        self.assertEqual(r.status, 4)
        self.assertIn("jam", r.out)


if __name__ == "__main__":
    unittest.main()
