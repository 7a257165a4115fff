"""Tests double-helical gears. The verbs gear, pair and measure compute one half, and run and export write
the whole gears. Verbs that support only gears with one helix reject the table."""

import json
import re
import struct
import tempfile
import unittest
from pathlib import Path

from cli import SOURCE, Run

PAIR = """[gear1]
teeth = 23
normal_module_mm = 3
helix_angle_deg = 28
face_width_mm = 150
[gear1.double_helical]
gap_mm = 30
{}
[gear2]
teeth = 67
face_width_mm = 150
[gear2.double_helical]
gap_mm = 30
"""


class TwoHalves(unittest.TestCase):
    def test_a_pair_has_the_numbers_of_one_half(self):
        answer = json.loads(Run("pair", PAIR.format(""), "--json").out)
        gear = answer["gears"][0]
        self.assertEqual((gear["face_width_mm"], gear["half_face_width_mm"], gear["apex_to_half_mm"]), (150, 60, 15))
        self.assertAlmostEqual(answer["pair"]["overlap_ratio"], 2.988748794338065, 12)
        text = Run("pair", PAIR.format("")).out
        for words in ("Double helical", "face width of one half", "150.0000"):
            self.assertIn(words, text)
        self.assertIn("half_face_width_mm", Run("pair", PAIR.format(""), "--csv").out)

    def test_a_gap_that_leaves_no_face_is_named(self):
        """Regression: the error named the face width of a half, which no key gives."""
        run = Run("pair", PAIR.format("").replace("gap_mm = 30", "gap_mm = 149.9999"))
        self.assertEqual(run.status, 1)
        for words in ("gear1.double_helical.gap_mm = 149.9999: leaves each half 5e-05 mm", "between 0.003 mm"):
            self.assertIn(words, run.err)

    def test_a_hob_that_needs_a_wider_gap_is_a_warning(self):
        run = Run("pair", PAIR.format("hob_diameter_mm = 120\nhob_half_length_mm = 20"), "--json")
        self.assertIn("hob_run_out", [w["code"] for w in json.loads(run.out)["warnings"]])

    def test_edge_contact_is_that_of_either_half(self):
        """The verdict and the report count the rotations at which an edge of either half touches."""
        spec = PAIR.format("stagger_pitches = 0.5") + "stagger_pitches = 0.5\n[errors]\ncrossing_deg = 0.08\n"
        spec += "[gear1.modifications]\nlead_crowning_um = 20\nprofile_crowning_um = 6\n"
        answer = json.loads(Run("contact", spec, "--json").out)
        halves = [h["positions"] for h in answer["contact"]["halves"]]
        edge = [any(p["kind"] not in ("interior", "line", "ridge") for p in both) for both in zip(*halves)]
        share = sum(edge) / len(edge)
        self.assertTrue(0 < share < 1, share)
        found = next(f for f in answer["verdict"]["findings"] if f["code"] == "edge_contact")
        self.assertAlmostEqual(found["values"]["share"], share, 12)
        run = Run("run", spec, "--only", "report", "--out", "out")
        text = re.sub("<[^>]*>", " ", (run.folder / "out/report.html").read_text())
        row = rf"Share of the rotation with an edge in contact\s+%\s+{100 * share:.0f} "
        self.assertRegex(text, row)

    def rated(self, spec, torque):
        steel = '[gear1.material]\nname = "18CrNiMo7-6"\n'
        load = (f"[rating]\ntorque_Nm = {torque}\nspeed_rpm = 1200\nquality = 6\nface_load_factor = 1.2\n"
                "life_h = 20000\nlubricant_viscosity_40C_mm2_s = 220\n")
        run = Run("rate", spec + steel + load, "--json")
        self.assertEqual(run.status, 0, run.err)
        return json.loads(run.out)["rating"]

    def test_the_halves_share_the_load(self):
        """The rating to ISO 6336 with b = 2 b_B and the overlap ratio of one half equals the rating
        of one half under half of the torque."""
        both = self.rated(PAIR.format(""), 4000)
        half = PAIR.format("").replace("[gear1.double_helical]\ngap_mm = 30\n", "")
        half = half.replace("[gear2.double_helical]\ngap_mm = 30\n", "").replace("150", "60")
        one = self.rated(half, 2000)
        total = {"torque_Nm", "power_kW", "F_t_N", "torque_holding_Nm", "face_width_holding_mm"}
        formulas = [r.pop("formulas") for r in (both, one)]
        differ = {key for key in both if both[key] != one[key]}
        self.assertEqual(differ, total)
        self.assertEqual([key for key in formulas[0] if formulas[0][key] != formulas[1][key]], ["K_gamma"])
        self.assertEqual(both["torque_holding_Nm"], 2 * one["torque_holding_Nm"])
        self.assertAlmostEqual(both["face_width_holding_mm"], 2 * one["face_width_holding_mm"] + 30, 9)
        self.assertIn("two halves that carry equal loads", Run("rate", PAIR.format("") + "[gear1.material]\nname = \"18CrNiMo7-6\"\n"
                      "[rating]\ntorque_Nm = 4000\nspeed_rpm = 1200\nquality = 6\nface_load_factor = 1.2\n").out)

    def test_the_halves_share_the_load_at_the_ends_of_the_tolerances(self):
        """The least safety of the nominal pair is 1.15. If one half carried the whole load, the safety
        would be 0.8."""
        both = PAIR.format("") + "".join(f'[gear{n}.tolerance]\nthickness_series = "cd25"\n' for n in (1, 2))
        run = Run("rate", both + '[pair]\ncenter_distance_tolerance = "js7"\n[gear1.material]\nname = "18CrNiMo7-6"\n'
                  "[rating]\ntorque_Nm = 2500\nspeed_rpm = 1200\nquality = 6\nface_load_factor = 1.2\n", "--json")
        answer = json.loads(run.out)
        self.assertEqual(answer["verdict"]["level"], "green", answer["verdict"])
        flank, root = (min(answer["rating"][key]) for key in ("S_H", "S_F"))
        self.assertIn(f"The lowest safety factor is {flank:.2f} against pitting and {root:.2f} against root breakage.",
                      answer["verdict"]["headline"])

    def test_a_mounting_of_one_helix_is_an_error(self):
        rating = "[gear1.material]\nname = \"18CrNiMo7-6\"\n[rating]\ntorque_Nm = 4000\nspeed_rpm = 1200\nquality = 6\n"
        run = Run("rate", PAIR.format("") + rating)
        self.assertIn("face_load_factor = 1.2", run.err)
        self.assertNotIn("mounting", run.err)
        run = Run("rate", PAIR.format("") + "[gear1.material]\nname = \"18CrNiMo7-6\"\n[rating]\ntorque_Nm = 4000\n"
                  "speed_rpm = 1200\nquality = 6\n[rating.mounting]\nbearing_span_mm = 300\npinion_offset_mm = 0\n"
                  "shaft_diameter_mm = 60\narrangement = \"a\"\n")
        self.assertEqual(run.status, 1)
        self.assertIn("rating.face_load_factor", run.err)
        run = Run("rate", PAIR.format("") + "[gear1.material]\nname = \"18CrNiMo7-6\"\n[rating]\ntorque_Nm = 4000\n"
                  "speed_rpm = 1200\nquality = 6\n[gear2.shaft]\nbearings_mm = [-150, 150]\ndiameter_mm = 60\n")
        self.assertEqual(run.status, 1)
        for word in ("gear2.shaft", "rating.face_load_factor"):
            self.assertIn(word, run.err)

    def test_verbs_for_one_helix_reject_it(self):
        run = Run("compensate", PAIR.format("") + "[compensate]\n")
        self.assertEqual(run.status, 1)
        for words in ("gear1.double_helical", "one half"):
            self.assertIn(words, run.err)

    SCATTER = "[scatter]\nsamples = 8\nreplicates = 2\npercentiles = [50]\n"

    def scatter(self, spec):
        return json.loads(Run("scatter", spec, "--json").out)["scatter"]

    def test_scatter_is_that_of_the_whole_gears(self):
        """Without tolerances, every sample has the numbers of contact, which are the means of both
        halves. The place along the face is that of the half whose contact is farther from its
        middle. It is > 0 in the direction away from the apex."""
        for stagger, crowning, crossing in ((0, 0, 0.006), (0.5, 12, 0.012), (0.5, 12, -0.012), (0.25, 12, 0.07)):
            spec = (PAIR.replace("gap_mm = 30", f"gap_mm = 30\nstagger_pitches = {stagger}").format("")
                    + f"[gear1.modifications]\nlead_crowning_um = {crowning}\nprofile_crowning_um = {crowning}\n"
                    + f"[errors]\ncrossing_deg = {crossing}\nintersecting_deg = 0.01\n")
            found = self.scatter(spec + self.SCATTER + "[scatter.errors]\ncenter_distance_mm = [0, 0]\n")
            contact = self.contact(spec + "[contact]\npositions = 32\n")
            self.assertNotEqual(*(half["peak_to_peak_arcsec"] for half in contact["halves"]))
            for key, of in (("peak_to_peak_arcsec", "continuous_peak_to_peak_arcsec"), ("least_play_deg", "least_play_deg")):
                self.assertAlmostEqual(found[key]["mean"], contact[of], 9)
            self.assertAlmostEqual(found["harmonic1_arcsec"]["mean"], contact["harmonics_arcsec"][0], 7)
            self.assertIsNone(found["long_period_arcsec"])
            halves = [half["positions"] for half in contact["halves"]]
            edges = sum(p["kind"] not in ("interior", "line", "ridge") for half in halves for p in half)
            self.assertAlmostEqual(found["edge_share"]["mean"], edges / 64, 12)
            places = [away * sum(p["height_mm"][0] for p in half if p["kind"] != "line") / 30 / 32
                      for away, half in zip((1, -1), halves)]
            self.assertAlmostEqual(found["contact_along_face"]["mean"], max(places, key=abs), 9)
        self.assertGreater(self.scatter(PAIR.format("") + self.SCATTER + "[scatter.errors]\ncrossing_deg = [-0.01, 0.01]\n")
                           ["peak_to_peak_arcsec"]["standard_deviation"], 0.01)

    def test_the_worst_sample_of_halves_is_a_contact_of_them(self):
        spec = PAIR.format("") + self.SCATTER + ("worst_case = true\nloosening = true\n[scatter.errors]\n"
                                                 "crossing_deg = [-0.01, 0.01]\nintersecting_deg = [-0.01, 0.01]\n")
        found = self.scatter(spec)
        worst = found["worst"]["peak_to_peak_arcsec"]
        self.assertGreaterEqual(worst["value"], found["peak_to_peak_arcsec"]["greatest"] - 1e-9)
        at = "".join(f"{name.removeprefix('errors.')} = {value}\n" for name, value in worst["at"].items())
        contact = self.contact(PAIR.format("") + f"[errors]\n{at}[contact]\npositions = 32\n")
        self.assertAlmostEqual(worst["value"], contact["continuous_peak_to_peak_arcsec"], 6)
        self.assertEqual(len(found["loosening"]["tolerances"]), 2)

    def test_a_scatter_of_halves_rejects_what_needs_one_helix(self):
        for key, table in (("pattern", "pattern = true\n"),
                           ("gear1.pitch", 'quality = 6\n[scatter.gear1]\npitch = "F_p"\n'),
                           ("gear2.pitch", 'quality = 6\n[scatter.gear2]\npitch = "F_p"\n')):
            run = Run("scatter", PAIR.format("") + "[load]\ntorque_Nm = 100\n" + self.SCATTER + table +
                      "[scatter.errors]\ncrossing_deg = [-0.01, 0.01]\n")
            self.assertEqual(run.status, 1, key)
            for words in (f"scatter.{key}", "double-helical"):
                self.assertIn(words, run.err)

    def test_robust_corrections_of_halves(self):
        spec = (PAIR.format("") + self.SCATTER + "[scatter.errors]\ncrossing_deg = [-0.01, 0.01]\n[scatter.robust]\n"
                'corrections = ["gear1.lead_crowning_um"]\npercentile = 50\n')
        found = self.scatter(spec)["robust"]
        self.assertLess(found["after"]["percentile_arcsec"], found["before"]["percentile_arcsec"])
        taken = Run("scatter", spec, "--take")
        self.assertIn("lead_crowning_um", taken.out)
        # The comparison uses the samples of the next seed, so these samples give its percentile.
        again = self.scatter(taken.out.replace("[scatter]", "[scatter]\nseed = 2", 1))["peak_to_peak_arcsec"]
        self.assertAlmostEqual(again["percentiles"][0], found["after"]["percentile_arcsec"], 6)

    LOAD = '[load]\ntorque_Nm = 1500\npositions = 8\nslices = 8\naccuracy = "draft"\n'

    def test_a_scatter_of_halves_under_load_is_load(self):
        """Without tolerances, every sample has the numbers of the whole gears under load."""
        for stagger, errors in ((0, ""), (0.5, "crossing_deg = 0.01\n"), (0.25, "center_distance_mm = 0.1\n")):
            spec = (PAIR.replace("gap_mm = 30", f"gap_mm = 30\nstagger_pitches = {stagger}").format("")
                    + self.LOAD + f"deflection_slope_um = 12\n[errors]\n{errors}")
            found = self.scatter(spec + self.SCATTER + "loaded = true\n[scatter.errors]\nintersecting_deg = [0, 0]\n")
            loaded = json.loads(Run("load", spec, "--json").out)["load"]["torques"][0]
            family = found["loaded"][0]
            self.assertEqual(family["torque_Nm"], 1500)
            for key, of in (("peak_to_peak_arcsec", "peak_to_peak_arcsec"), ("max_pressure_MPa", "max_pressure_MPa"),
                            ("face_load_factor", "face_load_factor")):
                self.assertAlmostEqual(family[key]["mean"] / loaded[of], 1, 9, key)
                self.assertLess(family[key]["greatest"] - family[key]["least"], 1e-9)

    def test_robust_corrections_of_halves_under_load(self):
        spec = (PAIR.format("") + self.LOAD + "[scatter]\nsamples = 8\nreplicates = 2\npercentiles = [50]\n"
                "[scatter.errors]\ncrossing_deg = [-0.02, 0.02]\n[scatter.robust]\n"
                'aim = "loaded_transmission_error"\npercentile = 50\n'
                'corrections = ["gear1.lead_crowning_um", "gear1.profile_crowning_um"]\n')
        found = self.scatter(spec)["robust"]
        self.assertLess(found["after"]["percentile_arcsec"], 0.7 * found["before"]["percentile_arcsec"])
        self.assertEqual(found["after"]["loaded"][0]["torque_Nm"], 1500)
        taken = Run("scatter", spec, "--take").out.replace("[scatter]", "[scatter]\nseed = 2\nloaded = true", 1)
        again = self.scatter(taken)["loaded"][0]["peak_to_peak_arcsec"]
        self.assertAlmostEqual(again["percentiles"][0], found["after"]["percentile_arcsec"], 6)

    def test_a_grade_adds_no_pitches_of_halves(self):
        found = self.scatter(PAIR.format("") + self.SCATTER + "quality = 6\nindices = true\n")
        self.assertIn("gear1.profile_waves", found["inputs"])
        self.assertEqual([name for name in found["inputs"] if name.endswith("pitch")], [])

    def contact(self, spec):
        return json.loads(Run("contact", spec, "--json").out)["contact"]

    def test_contact_is_the_mean_of_both_halves(self):
        found = self.contact(PAIR.format("") + "[errors]\ncrossing_deg = 0.01\nintersecting_deg = 0.02\n"
                             "[contact]\npattern = true\n[contact.map]\nx = \"crossing_deg\"\nx_range = [-0.02, 0.02]\n"
                             "y = \"intersecting_deg\"\ny_range = [-0.02, 0.02]\npoints = [3, 3]\n")
        first, second = found["halves"]
        self.assertNotEqual(first["peak_to_peak_arcsec"], second["peak_to_peak_arcsec"])
        for k, whole in enumerate(found["positions"]):
            a, b = (half["positions"][k]["transmission_error_arcsec"] for half in (first, second))
            self.assertAlmostEqual(whole["transmission_error_arcsec"], (a + b) / 2, 9)
            self.assertIsNone(whole["point_mm"])
            # The half extends from z = 15 mm to z = 75 mm.
            self.assertGreater(first["positions"][k]["point_mm"][2], 14.999)
            self.assertLess(second["positions"][k]["point_mm"][2], -14.999)
        self.assertEqual(len(found["axial_float_um"]), len(found["positions"]))
        # The errors of the spec lie between the points of the map. The map is symmetric about the mirror
        # plane.
        rows = found["map"]["peak_to_peak_arcsec"]
        self.assertAlmostEqual(rows[0][0], rows[2][2], 6)
        self.assertAlmostEqual(rows[0][2], rows[2][0], 6)

    def test_contact_without_errors_is_that_of_a_half(self):
        half = PAIR.format("").replace("face_width_mm = 150", "face_width_mm = 60")
        half = "\n".join(line for line in half.splitlines() if "double_helical" not in line and "gap_mm" not in line)
        alone, found = self.contact(half), self.contact(PAIR.format(""))
        for key in ("peak_to_peak_arcsec", "least_play_deg", "contact_lost"):
            self.assertEqual(alone[key], found[key])
        self.assertEqual([p["transmission_error_arcsec"] for p in alone["positions"]],
                         [p["transmission_error_arcsec"] for p in found["positions"]])

    def test_load_is_shared_by_the_halves(self):
        table = "[load]\ntorque_Nm = 2000\npositions = 4\naccuracy = \"draft\"\n[errors]\ncrossing_deg = 0.002\n"
        load = json.loads(Run("load", PAIR.format("") + table, "--json").out)["load"]
        whole = load["torques"][0]
        halves = [half["torques"][0] for half in load["halves"]]
        self.assertEqual([whole["torque_Nm"]] + [h["torque_Nm"] for h in halves], [2000, 1000, 1000])
        self.assertEqual(whole["max_pressure_MPa"], max(h["max_pressure_MPa"] for h in halves))
        for k, position in enumerate(whole["positions"]):
            self.assertAlmostEqual(position["transmission_error_arcsec"],
                                   sum(h["positions"][k]["transmission_error_arcsec"] for h in halves) / 2, 9)

    def test_run_shows_both_halves(self):
        table = ("[errors]\nintersecting_deg = 0.01\n[load]\ntorque_Nm = 2000\npositions = 4\naccuracy = \"draft\"\n")
        with tempfile.TemporaryDirectory() as folder:
            run = Run("run", PAIR.format("") + table, "--only", "result,report", "--out", folder)
            self.assertEqual(run.status, 0, run.err)
            report = (Path(folder) / "report.html").read_text()
            ids = re.findall(r'\sid="([^"]+)"', report)
            self.assertEqual(sorted(ids), sorted(set(ids)))
            for heading in ("Half at z &gt; 0", "Half at z &lt; 0"):
                self.assertEqual(report.count(heading), 2, heading)  # contact and load
            self.assertNotIn("contact", json.loads((Path(folder) / "result.json").read_text())["verdict"].get("not_judged", []))

    def test_run_writes_the_whole_gears(self):
        with tempfile.TemporaryDirectory() as folder:
            run = Run("run", PAIR.format(""), "--only", "stl,report", "--out", folder)
            self.assertEqual(run.status, 0, run.err)
            report = (Path(folder) / "report.html").read_text()
            for words in ("Double-helical gear pair", "150.0000", "Groove diameter"):
                self.assertTrue(words in report, words)
            # 84 bytes, then 50 per triangle. The faces end at ±75 mm, the groove at ±15 mm.
            for gear in (1, 2):
                data = (Path(folder) / f"gear{gear}.stl").read_bytes()[84:]
                heights = {round(struct.unpack_from("<f", data, at + 20)[0], 3) for at in range(0, len(data), 50)}
                self.assertEqual((min(heights), max(heights)), (-75, 75))
                self.assertTrue({-15, 15} <= heights)
                self.assertFalse([z for z in heights if abs(z) < 15])

    def test_run_rejects_tables_for_one_helix(self):
        run = Run("run", PAIR.format("") + "[compensate]\n")
        self.assertEqual(run.status, 1)
        self.assertIn("is not supported for double-helical gears", run.err)

    def test_files_have_the_modifications_of_both_halves(self):
        """A tip relief of 0.1 mm removes the same volume from each half of the mesh."""
        plain = PAIR.format("")
        relieved = plain.replace("[gear2]", "[gear1.modifications]\ntip_relief_um = 100\ntip_relief_start_mm = 80\n[gear2]", 1)
        volumes = []
        for spec in (plain, relieved):
            with tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "gear1.stl"
                run = Run("export", spec, "--gear", "1", "--mesh-tolerance", "0.002", "--stl", str(file))
                self.assertEqual(run.status, 0, run.err)
                self.assertNotIn("without flank modifications", run.out)
                data = file.read_bytes()[84:]
                half = [0.0, 0.0]
                for at in range(0, len(data), 50):
                    a, b, c = (struct.unpack_from("<3f", data, at + 12 + 12 * i) for i in range(3))
                    six = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                           + a[2] * (b[0] * c[1] - b[1] * c[0]))
                    half[min(a[2], b[2], c[2]) < 0] += six / 6
                volumes.append(half)
        removed = [was - now for was, now in zip(*volumes)]
        self.assertGreater(min(removed), 100)
        self.assertAlmostEqual(removed[0] / removed[1], 1, delta=0.02)

    def test_gear_2_takes_the_halves_of_gear_1(self):
        short = PAIR.format("").replace("face_width_mm = 150\n[gear2.double_helical]\ngap_mm = 30\n", "")
        self.assertEqual(Run("pair", short, "--json").out, Run("pair", PAIR.format(""), "--json").out)

    def test_a_groove_is_deeper_than_the_teeth(self):
        gear = json.loads(Run("pair", PAIR.format(""), "--json").out)["gears"][0]
        self.assertEqual(gear["groove_diameter_mm"], gear["root_diameter_mm"] - 1.5)
        run = Run("pair", PAIR.format("groove_diameter_mm = 75"))
        self.assertEqual(run.status, 1)
        for words in ("gear1.double_helical.groove_diameter_mm = 75", "root diameter"):
            self.assertIn(words, run.err)

    def test_a_bore_that_meets_the_groove(self):
        gear = json.loads(Run("pair", PAIR.format(""), "--json").out)["gears"][0]
        bore = (gear["groove_diameter_mm"] + gear["root_diameter_mm"]) / 2
        for kind in ("--step", "--stl"):
            run = Run("export", PAIR.format(f"[gear1.bore]\ndiameter_mm = {bore}"), "--gear", "1", kind, "x." + kind[2:])
            self.assertEqual(run.status, 1)
            for words in ("gear1.bore.diameter_mm", "groove between the halves"):
                self.assertIn(words, run.err)

        verdict = Run("pair", PAIR.format(f"[gear1.bore]\ndiameter_mm = {bore}"), "--json").json["verdict"]
        self.assertEqual((verdict["level"], verdict["findings"][0]["code"]), ("red", "no_body"))
        self.assertIn("groove between the halves", verdict["findings"][0]["message"])
        remedy = verdict["findings"][0]["change"]["gear1.bore.diameter_mm"]
        self.assertEqual(Run("pair", PAIR.format(f"[gear1.bore]\ndiameter_mm = {remedy}"), "--json").json["verdict"]["level"],
                         Run("pair", PAIR.format(""), "--json").json["verdict"]["level"])

    def test_staggered_halves_without_a_gap_have_no_files(self):
        spec = PAIR.format("").replace("gap_mm = 30", "stagger_pitches = 0.5")
        verdict = Run("pair", spec, "--json").json["verdict"]
        self.assertEqual(verdict["level"], "amber")
        self.assertIn("stagger_without_gap", [f["code"] for f in verdict["findings"]])
        run = Run("export", spec, "--step", "x.step")
        self.assertEqual(run.status, 1)
        self.assertIn("gear1.double_helical.gap_mm = 0", run.err)

    def test_face_widths_include_both_halves_and_the_gap(self):
        """The remedy is the face width for which one half has an overlap ratio of 1."""
        pair = Run("pair", PAIR.format(""), "--json").json["pair"]
        face = pair["needed_face_width_mm"]["whole_overlap_1"]
        self.assertAlmostEqual(face, 2 * pair["needed_face_width_mm"]["overlap_1"] + 30, 9)
        self.assertRegex(Run("pair", PAIR.format("")).out, f"overlap ratio of 1 +b +{face:.4f}")
        again = Run("pair", PAIR.format("").replace("150", str(face)), "--json").json["pair"]
        self.assertAlmostEqual(again["overlap_ratio"], 1, 9)
        self.assertIn("apply to one half", Run("pair", PAIR.format("")).out)

    def test_the_face_width_of_a_remedy_is_that_of_the_gear(self):
        arcs = (SOURCE / "examples/circular_arc_drive.toml").read_text() + "[gear1.double_helical]\ngap_mm = 10\n"
        red = Run("pair", arcs, "--json").json["verdict"]
        self.assertEqual(red["level"], "red")
        width = float(re.search(r"face width of (\S+) mm on both gears", red["headline"]).group(1))
        wide = re.sub(r"face_width_mm = \d+", f"face_width_mm = {width}", arcs)
        self.assertNotEqual(Run("pair", wide, "--json").json["verdict"]["level"], "red")

    def test_halves_that_make_no_pair_are_errors(self):
        for old, new, key in (("150\n[gear2.double_helical]\ngap_mm = 30", "120\n[gear2.double_helical]\ngap_mm = 10",
                               "gear2.double_helical.gap_mm"),
                              ("helix_angle_deg = 28\n", "", "gear1.helix_angle_deg"),
                              ("gap_mm = 30\n\n", "gap_mm = 150\n", "gear1.double_helical.gap_mm")):
            run = Run("pair", PAIR.format("").replace(old, new, 1))
            self.assertEqual(run.status, 1)
            self.assertIn(key, run.err)


if __name__ == "__main__":
    unittest.main()
