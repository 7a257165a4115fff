"""Tests the verb load as a user calls it: keys, errors by key, the form of the result, and laws of the
results."""

import json
import math
import re
import tempfile
import unittest
from pathlib import Path

from cli import Run

PAIR = """
[gear1]
teeth = 25
normal_module_mm = 3.0
face_width_mm = 30.0
bore = {{ diameter_mm = 36.0 }}
{gear1}
[gear2]
teeth = 43
face_width_mm = 28.0
bore = {{ diameter_mm = 60.0 }}
{gear2}
{rest}
"""
DRAFT = '[load]\npositions = 4\nslices = 8\naccuracy = "draft"\n'


def load(gear1="", gear2="", rest=DRAFT + "torque_Nm = 100\n", options=("--json",)):
    return Run("load", PAIR.format(gear1=gear1, gear2=gear2, rest=rest), *options)


class Load(unittest.TestCase):
    def answer(self, **words):
        run = load(**words)
        self.assertEqual(run.status, 0, run.err)
        return run.json["load"]

    def test_form_of_the_answer(self):
        answer = self.answer(rest=DRAFT + "torque_Nm = [50, 100]\n")
        self.assertEqual([t["torque_Nm"] for t in answer["torques"]], [50, 100])
        for t in answer["torques"]:
            self.assertEqual(len(t["positions"]), 4)
            self.assertLess(t["mesh_stiffness_N_per_mm_um"]["min"], t["mesh_stiffness_N_per_mm_um"]["max"])
            self.assertLess(t["mesh_stiffness_N_per_mm_um"]["mean"],
                            t["mesh_stiffness_without_twist_N_per_mm_um"]["mean"])
            self.assertEqual(len(t["max_root_stress_MPa"]), 2)
            for p in t["positions"]:
                self.assertAlmostEqual(sum(p["share"]), 1.0, places=12)
        self.assertEqual(answer["probes"], [])

    def test_more_torque_is_more_of_everything(self):
        low, high = self.answer(rest=DRAFT + "torque_Nm = [50, 200]\n")["torques"]
        for key in ("max_pressure_MPa", "peak_to_peak_arcsec"):
            self.assertGreater(high[key], low[key], key)
        for a, b in zip(low["positions"], high["positions"]):
            self.assertGreater(b["approach_um"], a["approach_um"])

    def test_the_quietest_torque_is_marked(self):
        relief = "modifications = { tip_relief_um = 20, tip_relief_start_mm = 78 }\n"
        rest = DRAFT.replace("positions = 4", "positions = 16") + "torque_Nm = [20, 100, 400]\n"
        answer = self.answer(gear1=relief, rest=rest)
        quiet = min(answer["torques"], key=lambda t: t["peak_to_peak_arcsec"])["torque_Nm"]
        self.assertEqual(answer["quietest_torque_Nm"], quiet)
        text = load(gear1=relief, rest=rest, options=()).out
        marked = [line for line in text.splitlines() if line.startswith("  quietest")]
        self.assertEqual([float(line.split()[1]) for line in marked], [quiet])
        self.assertNotIn("quietest_torque_Nm", self.answer())

    def test_a_narrow_face_has_fewer_slices(self):
        answer = self.answer(gear1="helix_angle_deg = 20", gear2="helix_angle_deg = -20",
                             rest='[load]\npositions = 4\naccuracy = "draft"\ntorque_Nm = 100\n')
        # 28 mm are divided into slices of 0.4 modules.
        self.assertEqual(len(answer["torques"][0]["face_load_N_per_mm"]), 23)
        run = load(gear1="helix_angle_deg = 20", gear2="helix_angle_deg = -20",
                   rest='[load]\npositions = 4\naccuracy = "draft"\ntorque_Nm = 100\nslices = 40\n')
        self.assertEqual(run.status, 1)
        self.assertIn("23 slices are sufficient", run.err)

    def test_shares_are_as_even_as_without_errors(self):
        helices = {"gear1": "helix_angle_deg = 15", "gear2": "helix_angle_deg = -15"}
        rest = DRAFT.replace("positions = 4", "positions = 16") + "torque_Nm = 200\n"
        even = self.answer(**helices, rest=rest)["torques"][0]
        crossed = self.answer(**helices, rest=rest + "[errors]\ncrossing_deg = 0.03\n")["torques"][0]
        self.assertEqual(even["transverse_load_factor"], 1.0)
        most = [max(max(p["share"]) for p in t["positions"]) for t in (crossed, even)]
        self.assertAlmostEqual(crossed["transverse_load_factor"], most[0] / most[1], delta=1e-14)

    def run_of(self, folder, rest, gear2=""):
        run = Run("run", PAIR.format(gear1="", gear2=gear2, rest=rest), "--json", "--out", folder)
        self.assertEqual(run.status, 0, run.err)
        return json.loads(run.out), (Path(folder) / "report.html").read_text()

    def test_run_has_it_in_its_result_and_on_its_page(self):
        rest = DRAFT + "torque_Nm = [50, 100]\n"
        with tempfile.TemporaryDirectory() as folder:
            result, page = self.run_of(folder, rest)
            self.assertEqual(result["load"], self.answer(rest=rest))
            self.assertIn(">Under load</h2>", page)
            self.assertIn("Harris map", page)
            self.assertIn("Transverse load factor", page)
            # The result contains only the given rotations, but the page always shows a whole pitch.
            some = rest.replace("positions = 4", "rotation1_deg = [0.0, 1.0]")
            result, page = self.run_of(folder, some)
            self.assertEqual(result["load"], self.answer(rest=some))
            self.assertIn("At each of 64 positions of a pitch", page)

    def test_run_without_load_has_none(self):
        with tempfile.TemporaryDirectory() as folder:
            for rest in ("", DRAFT):  # [load] without a torque; [rating] may use its other keys
                result, page = self.run_of(folder, rest)
                self.assertNotIn("load", result)
                self.assertNotIn(">Under load</h2>", page)

    def test_run_says_why_there_is_none(self):
        with tempfile.TemporaryDirectory() as folder:
            # An internal gear has no outline if its cutter is unknown.
            def bare_ring(rest):
                text = PAIR.format(gear1="profile_shift = 0.5", gear2="profile_shift = -1.2", rest=DRAFT + rest)
                text = text.replace("teeth = 25", "teeth = 8").replace("teeth = 43", "teeth = -30")
                text = text.replace("36.0", "3.0").replace("bore = { diameter_mm = 60.0 }", "")
                run = Run("run", text, "--json", "--out", folder)
                self.assertEqual(run.status, 0, run.err)
                return {w["code"]: w["message"] for w in json.loads(run.out)["warnings"]}

            self.assertIn("gear2.cut_by", bare_ring("torque_Nm = 5\n")["no_load"])
            self.assertIn("Corrections cannot be computed", bare_ring('torque_Nm = 5\n[compensate]\naim = "pressure"\n')["no_contact"])
            run = Run("run", PAIR.format(gear1="", gear2="", rest=DRAFT + "torque_Nm = -50\n"), "--json", "--out", folder)
            self.assertEqual((run.status, run.json["error"]["key"]), (1, "load.torque_Nm"))

    def compensated(self, compensate, torque="torque_Nm = [40, 120]\n", verb="compensate", options=("--json",)):
        rest = DRAFT + torque + "[errors]\ncrossing_deg = 0.03\n[pair]\nbacklash_mm = 0.1\n[compensate]\n" + compensate
        return Run(verb, PAIR.format(gear1="", gear2="", rest=rest), *options)

    def test_corrections_under_load(self):
        only = 'corrections = ["gear1.lead_slope_um"]\n'
        run = self.compensated('aim = "pressure"\n' + only)
        self.assertEqual(run.status, 0, run.err)
        answer = run.json["compensate"]
        self.assertEqual(answer["aim"], "pressure")
        self.assertEqual([l["torque_Nm"] for l in answer["under_load"]], [40, 120])
        worst = [max(l[when]["max_pressure_MPa"] for l in answer["under_load"]) for when in ("before", "after")]
        self.assertLess(worst[1], 0.8 * worst[0])
        self.assertEqual(answer["corrections"][0]["spec_key"], "gear1.modifications.right_lead_slope_um")
        # The values before the correction equal the results of the verb load.
        load = self.compensated("", verb="load").json["load"]["torques"]
        for l, t in zip(answer["under_load"], load):
            self.assertEqual(l["before"]["max_pressure_MPa"], t["max_pressure_MPa"])
            self.assertEqual(l["before"]["peak_to_peak_arcsec"], t["peak_to_peak_arcsec"])
        text = self.compensated('aim = "pressure"\n' + only, options=()).out
        self.assertIn("Under 120 N m", text)
        with tempfile.TemporaryDirectory() as folder:
            run = self.compensated('aim = "pressure"\n' + only, verb="run", options=("--json", "--out", folder))
            self.assertEqual(run.json["compensate"], answer)
            self.assertIn("With these corrections, the greatest pressure on the flanks under", (Path(folder) / "report.html").read_text())

    def test_the_values_are_those_of_the_worst_combination(self):
        rest = 'aim = "pressure"\ncorrections = ["gear1.lead_crowning_um"]\n'
        text = self.compensated(rest + "[compensate.range]\nhelix_slope1_um = [-10, 10]\n", "torque_Nm = 40\n", options=()).out
        self.assertIn("Under 40 N m, for the worst combination of errors\n", text)
        self.assertIn("Without load, for the worst combination of errors\n", text)

    def test_corrections_without_load_are_as_before(self):
        answer = self.compensated("").json["compensate"]
        self.assertEqual(answer, self.compensated('aim = "transmission_error"\n').json["compensate"])
        self.assertNotIn("under_load", answer)
        self.assertNotIn("aim", answer)

    def test_corrections_under_load_want_a_torque(self):
        run = self.compensated('aim = "loaded_transmission_error"\n', torque="")
        self.assertEqual((run.status, run.json["error"]["key"]), (1, "load.torque_Nm"))
        run = self.compensated('aim = "silence"\n')
        self.assertEqual((run.status, run.json["error"]["key"]), (1, "compensate.aim"))

    def test_probe(self):
        probe = "[[load.probe]]\ndiameter_mm = 75\n"
        wide = self.answer(rest=probe)
        self.assertEqual(wide["torques"], [])
        self.assertGreater(wide["probes"][0]["own_um_per_N_mm"], 0)
        part = self.answer(rest=probe + "z_mm = [-5, 5]\nread_z_mm = [-10, 10]\n")["probes"][0]
        left, right = part["profile_um_per_N"]
        self.assertAlmostEqual(left / right, 1.0, places=6)
        self.assertGreater(part["own_um_per_N"], left)

    def test_refusals_name_the_key(self):
        for words, key in (
            ({"rest": DRAFT}, "load.torque_Nm"),
            ({"rest": DRAFT + "torque_Nm = 0\n"}, "load.torque_Nm"),
            ({"rest": DRAFT + "torque_Nm = [10, -1]\n"}, "load.torque_Nm"),
            ({"rest": DRAFT + 'torque_Nm = "ten"\n'}, "load.torque_Nm"),
            ({"gear1": "material = { youngs_modulus_MPa = 0 }"}, "gear1.material.youngs_modulus_MPa"),
            ({"gear1": "material = { poisson_ratio = 0.5 }"}, "gear1.material.poisson_ratio"),
            ({"gear1": 'material = { kind = "plastic" }'}, "gear1.material.youngs_modulus_MPa"),
            ({"rest": "[load]\ntorque_Nm = 30000\npositions = 4\nslices = 128\naccuracy = \"draft\"\n"},
             "load.slices"),
            ({"rest": "[[load.probe]]\ndiameter_mm = 200\n"}, "load.probe[0].diameter_mm"),
            ({"rest": "[[load.probe]]\ndiameter_mm = 75\nz_mm = [-40, 2]\n"}, "load.probe[0].z_mm"),
        ):
            run = load(**words)
            self.assertEqual(run.status, 1, words)
            self.assertEqual(run.json["error"]["key"], key)

    def test_the_torque_of_the_rating_is_used(self):
        rated = "[rating]\npower_kW = 6\nspeed_rpm = 1000\napplication_factor = 1.25\n"
        run = load(rest=DRAFT + rated)
        self.assertEqual(run.status, 0, run.err)
        torque = 60 * 6000 / (2 * math.pi * 1000)
        self.assertAlmostEqual(run.json["load"]["torques"][0]["torque_Nm"], torque, delta=6e-4)
        noted = [w["message"] for w in run.json["warnings"] if w["code"] == "torque_of_rating"]
        self.assertIn("the nominal torque of [rating], 57.296 N m on gear 1, is used", noted[0])
        own = load(rest=DRAFT + "torque_Nm = 50\n" + rated).json
        self.assertEqual(own["load"]["torques"][0]["torque_Nm"], 50)
        self.assertNotIn("torque_of_rating", [w["code"] for w in own["warnings"]])

    def test_a_kind_has_its_elasticity(self):
        """The elasticity follows from the kind of the material, as in a rating."""
        by_kind = load(gear1='material = { kind = "cast" }', rest=DRAFT + "torque_Nm = 50\n")
        by_number = load(gear1="material = { youngs_modulus_MPa = 126000 }", rest=DRAFT + "torque_Nm = 50\n")
        self.assertEqual(by_kind.status, 0, by_kind.err)
        self.assertEqual(by_kind.json["load"], by_number.json["load"])

    def test_bore_above_the_root(self):
        text = PAIR.format(gear1="", gear2="", rest=DRAFT + "torque_Nm = 10\n")
        run = Run("load", text.replace("36.0", "70.0"), "--json")
        self.assertEqual(run.status, 1)
        self.assertEqual(run.json["error"]["key"], "gear1.bore.diameter_mm")

    def ring(self, bore="", rest=DRAFT + "torque_Nm = 100\n"):
        text = PAIR.format(gear1="", gear2="tip_diameter_mm = 190.2", rest=rest)
        text = text.replace("teeth = 43", "teeth = -65").replace("bore = { diameter_mm = 60.0 }", bore)
        return Run("load", text, "--json")

    def test_an_internal_pair_is_held_at_its_rim(self):
        drawn = self.ring()
        self.assertEqual(drawn.status, 0, drawn.err)
        self.assertIn("held_at_rim_as_drawn", [w["code"] for w in drawn.json["warnings"]])
        root = 3 * (65 + 2.5)
        same = self.ring(f"bore = {{ diameter_mm = {root + 15} }}")
        self.assertNotIn("held_at_rim_as_drawn", [w["code"] for w in same.json["warnings"]])
        self.assertEqual(same.json["load"]["torques"], drawn.json["load"]["torques"])
        deep = self.ring(f"bore = {{ diameter_mm = {root + 60} }}").json["load"]["torques"][0]
        self.assertLess(deep["mesh_stiffness_N_per_mm_um"]["mean"],
                        drawn.json["load"]["torques"][0]["mesh_stiffness_N_per_mm_um"]["mean"])

    def test_a_rim_inside_the_roots(self):
        run = self.ring("bore = { diameter_mm = 200 }")
        self.assertEqual(run.status, 1)
        self.assertEqual(run.json["error"]["key"], "gear2.bore.diameter_mm")

    def test_a_probe_of_a_ring(self):
        run = self.ring(rest=DRAFT + "[[load.probe]]\ngear = 2\ndiameter_mm = 195\n")
        self.assertGreater(run.json["load"]["probes"][0]["own_um_per_N_mm"], 0)

    def test_a_single_point_that_touches_is_an_answer(self):
        answer = self.answer(rest=DRAFT + "torque_Nm = 1e-9\ndeflection_slope_um = 30\n")
        self.assertGreaterEqual(answer["torques"][0]["positions"][0]["approach_um"], 0)

    def test_csv_has_a_row_for_each_position(self):
        run = load(rest=DRAFT + "torque_Nm = [50, 100]\n", options=("--csv",))
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual(len(run.out.strip().splitlines()), 1 + 2 * 4)


CROSSED = """
gear1 = {{ teeth = 16, normal_module_mm = 2, helix_angle_deg = 45, face_width_mm = 20 }}
gear2 = {{ teeth = 31, normal_module_mm = 2, helix_angle_deg = 45, face_width_mm = 20 }}
pair = {{ shaft_angle_deg = 90 }}
{rest}
"""


class Points(unittest.TestCase):
    def test_crossed_teeth_touch_at_points(self):
        run = Run("load", CROSSED.format(rest=DRAFT + "torque_Nm = [5, 20]\n"), "--json")
        self.assertEqual(run.status, 0, run.err)
        answer = run.json["load"]
        self.assertEqual(answer["regime"], "point")
        for t in answer["torques"]:
            self.assertNotIn("mesh_stiffness_N_per_mm_um", {k for k, v in t.items() if v is not None})
            self.assertGreater(t["contact_stiffness_N_per_um"]["mean"], 0)
            for p in t["positions"]:
                self.assertEqual(len(p["points"]), len(p["share"]))
                whole = sum(k["force_N"] for k in p["points"])
                for k, share in zip(p["points"], p["share"]):
                    self.assertAlmostEqual(k["force_N"], share * whole, delta=1e-9 * whole)
                    area = 3.141592653589793 * k["semi_major_mm"] * k["semi_minor_mm"]
                    self.assertAlmostEqual(k["pressure_MPa"] * area, 1.5 * k["force_N"], delta=1e-4 * whole)
        low, high = answer["torques"]
        self.assertGreater(high["max_pressure_MPa"], low["max_pressure_MPa"])
        # The contact stiffness of a Hertz contact point increases with the load.
        self.assertGreater(high["contact_stiffness_N_per_um"]["mean"], low["contact_stiffness_N_per_um"]["mean"])

    def test_double_arcs_touch_at_two_places(self):
        pair = """
gear1 = {{ teeth = 18, normal_module_mm = 4, helix_angle_deg = 22, face_width_mm = 60, rack = "GBT12759" }}
gear2 = {{ teeth = 50, normal_module_mm = 4, helix_angle_deg = -22, face_width_mm = 60, rack = "GBT12759" }}
{rest}
"""
        run = Run("load", pair.format(rest=DRAFT + "torque_Nm = 200\n"), "--json")
        self.assertEqual(run.status, 0, run.err)
        for p in run.json["load"]["torques"][0]["positions"]:
            high = [k for k in p["points"] if k["diameter_mm"][0] > 78]
            low = [k for k in p["points"] if k["diameter_mm"][0] < 78]
            self.assertGreater(len(high), 0)
            self.assertGreater(len(low), 0)

    def test_each_face_of_crossed_gears_has_its_own_slices(self):
        """The teeth touch near the middle of a wide face, so the root stress there does not depend on the width."""
        stress = {}
        for first, second in ((8, 80), (20, 20), (20, 80)):
            spec = CROSSED.replace("20 }}", f"{first} }}}}", 1).replace("20 }}", f"{second} }}}}")
            spec = spec.replace("normal_module_mm = 2,", "normal_module_mm = 2, modifications = {{ profile_crowning_um = 20 }},")
            run = Run("load", spec.format(rest=DRAFT.replace("slices = 8\n", "") + "torque_Nm = 2\n"), "--json")
            self.assertEqual(run.status, 0, run.err)
            torque = run.json["load"]["torques"][0]
            self.assertFalse(torque["edge_carries"])
            stress[first, second] = torque["max_root_stress_MPa"]
        for wide, narrow in zip(stress[20, 80], stress[20, 20]):
            self.assertAlmostEqual(wide / narrow, 1, delta=0.04)

    def test_lines_are_named_too(self):
        run = load()
        self.assertEqual(run.json["load"]["regime"], "line")
        self.assertNotIn("points", run.json["load"]["torques"][0]["positions"][0])

    def test_deflections_are_for_lines(self):
        run = Run("load", CROSSED.format(rest=DRAFT + "torque_Nm = 5\ndeflection_bow_um = 3\n"), "--json")
        self.assertEqual(run.status, 1)
        self.assertEqual(run.json["error"]["key"], "load.deflection_bow_um")

    def test_shafts_are_for_lines(self):
        shaft = "[gear2.shaft]\nbearings_mm = [-40, 40]\ndiameter_mm = 20\n"
        crossed = ("[gear1]\nteeth = 16\nnormal_module_mm = 2\nhelix_angle_deg = 45\n[gear2]\nteeth = 31\n"
                   "normal_module_mm = 2\nhelix_angle_deg = 45\n[pair]\nshaft_angle_deg = 90\n")
        halves = ("[gear1]\nteeth = 20\nnormal_module_mm = 2\nhelix_angle_deg = 25\nface_width_mm = 40\n"
                  "[gear1.double_helical]\ngap_mm = 6\n[gear2]\nteeth = 31\n")
        for gears, word in ((crossed, "point contact"), (halves, "double-helical")):
            run = Run("load", gears + shaft + "[load]\ntorque_Nm = 20\n", "--json")
            self.assertEqual(run.status, 1, run.out)
            self.assertEqual(run.json["error"]["key"], "gear2.shaft")
            self.assertIn(word, run.err)


class Shafts(unittest.TestCase):
    SPEC = """
[gear1]
teeth = 21
normal_module_mm = 3
helix_angle_deg = {beta}
face_width_mm = 30
[gear1.shaft]
bearings_mm = [-30, 70]
diameter_mm = 32
youngs_modulus_MPa = {modulus}
[gear2]
teeth = 41
[load]
torque_Nm = [100, 400]
positions = 8
slices = 12
accuracy = "draft"
{rest}
"""

    def under_load(self, beta=12, modulus=206000, rest="", shaft=True):
        spec = self.SPEC.format(beta=beta, modulus=modulus, rest=rest)
        if not shaft:
            spec = re.sub(r"\[gear1\.shaft\].*(?=\[gear2\])", "", spec, flags=re.DOTALL)
        run = Run("load", spec, "--json")
        self.assertEqual(run.status, 0, run.err)
        return run.json["load"]["torques"]

    def test_the_load_follows_the_shaft(self):
        soft, stiff, none = self.under_load(), self.under_load(modulus=1e9), self.under_load(shaft=False)
        for s, r, n in zip(soft, stiff, none):
            more = s["face_load_factor"] - n["face_load_factor"]
            self.assertGreater(more, 0.1)
            self.assertAlmostEqual(r["face_load_factor"], n["face_load_factor"], delta=2 * more * 206000 / 1e9)
            self.assertNotIn("shaft_slope_um", n)
            # The deflection is nearly proportional to the torque.
            self.assertAlmostEqual(r["shaft_slope_um"] * 1e9 / 206000, s["shaft_slope_um"], delta=0.3 * abs(s["shaft_slope_um"]))
        self.assertAlmostEqual(soft[1]["shaft_slope_um"] / soft[0]["shaft_slope_um"], 4, delta=0.8)

    def test_a_given_deflection_is_added(self):
        plain = self.under_load()[1]
        opposite = self.under_load(rest=f"deflection_slope_um = {-plain['shaft_slope_um']}")[1]
        self.assertLess(opposite["face_load_factor"], plain["face_load_factor"])


# The flanks of gear 1 meet below its tip diameter.
POINTED = """
[gear1]
teeth = 14
normal_module_mm = 1
face_width_mm = 10
profile_shift = 0.739
rack = {{ addendum = 1.1 }}
material = {{ name = "16MnCr5" }}
[gear2]
teeth = 64
face_width_mm = 10
material = {{ name = "16MnCr5" }}
[load]
torque_Nm = 5
positions = 8
accuracy = "draft"
{rest}
"""


class PointedTeeth(unittest.TestCase):
    def test_every_verb_has_numbers(self):
        run = Run("load", POINTED.format(rest=""), "--json")
        self.assertEqual(run.status, 0, run.err)
        torque = run.json["load"]["torques"][0]
        self.assertGreater(torque["max_pressure_MPa"], 500)
        self.assertGreater(min(torque["max_root_stress_MPa"]), 50)
        for p in torque["positions"]:
            self.assertGreater(p["approach_um"], 0)
            self.assertGreater(p["max_pressure_MPa"], 0)
        self.assertNotIn("nan", Run("load", POINTED.format(rest="")).out)

    def test_the_rating_beside_them(self):
        rating = ("[rating]\ntorque_Nm = 5\nspeed_rpm = 1500\nquality = 6\nface_load_factor = 1.2\n"
                  "tooth_contact = true\n")
        run = Run("rate", POINTED.format(rest=rating), "--json")
        self.assertEqual(run.status, 0, run.err)
        self.assertGreater(run.json["rating"]["contact_pressure_MPa"], 500)

    def test_corrections_for_their_pressure(self):
        wish = '[errors]\ncrossing_deg = 0.02\n[compensate]\naim = "pressure"\ncorrections = ["gear1.lead_slope_um"]\n'
        run = Run("compensate", POINTED.format(rest="slices = 8\n" + wish).replace("positions = 8", "positions = 4"),
                  "--json")
        self.assertEqual(run.status, 0, run.err)
        scores = run.json["compensate"]["under_load"][0]
        self.assertGreater(scores["before"]["max_pressure_MPa"], scores["after"]["max_pressure_MPa"])
        self.assertGreater(scores["after"]["max_pressure_MPa"], 500)

    def test_the_whole_page(self):
        with tempfile.TemporaryDirectory() as folder:
            run = Run("run", POINTED.format(rest=""), "--out", folder + "/made")
            self.assertEqual(run.status, 0, run.err)
            self.assertIn("Under load", (Path(folder) / "made" / "report.html").read_text())


if __name__ == "__main__":
    unittest.main()
