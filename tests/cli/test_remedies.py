"""Tests that the printed remedies help: each change of a verdict, and each limit of an error, is applied and the program is
run again."""

import copy
import json
import random
import re
import unittest

from cli import SOURCE, Run

LEVELS = {"green": 0, "amber": 1, "red": 2}
PAIR = {"gear1": {"teeth": 20, "normal_module_mm": 2, "face_width_mm": 20}, "gear2": {"teeth": 40}}


def solved(verb, spec):
    return Run(verb, json.dumps(spec), "--json", name="case.json").json


def with_value(spec, path, value):
    spec = copy.deepcopy(spec)
    *tables, key = path.split(".")
    table = spec
    for name in tables:
        table = table.setdefault(name, {})
    table[key] = value
    return spec


def levels(answer):
    """The worst level of each finding, by code and gear."""
    found = {}
    for f in answer["verdict"]["findings"]:
        key = f["code"], f["gear"]
        found[key] = max(found.get(key, 0), LEVELS[f["level"]])
    return found


def random_pair(draw):
    """A pair as a user might write it, often with a fault."""
    m = draw.choice([1, 2, 2.5, 4])
    ring = draw.random() < 0.25
    z1 = draw.randint(9, 30)
    z2 = -draw.randint(z1 + 12, 90) if ring else draw.randint(12, 70)
    beta = draw.choice([0, 0, 12, 20])
    gear = {"teeth": z1, "normal_module_mm": m, "helix_angle_deg": beta, "face_width_mm": draw.choice([5, 10]) * m}
    if draw.random() < 0.5:
        gear["profile_shift"] = round(draw.uniform(-0.4, 0.8), 2)
    if draw.random() < 0.5:
        gear["thickness_allowance_mm"] = round(-draw.uniform(0.01, 0.15) * m, 3)
    mate = {"teeth": z2, "helix_angle_deg": beta if ring else -beta, "face_width_mm": gear["face_width_mm"]}
    spec = {"gear1": gear, "gear2": mate}
    if draw.random() < 0.3:
        teeth = abs(z2) - z1 if ring else z1 + z2
        nominal = m * teeth / 2 / (1 if beta == 0 else {12: 0.9781476, 20: 0.9396926}[beta])
        spec["pair"] = {"center_distance_mm": round(nominal + draw.uniform(-0.2, 0.6) * m, 2)}
    if draw.random() < 0.5:
        spec["errors"] = {draw.choice(["crossing_deg", "intersecting_deg"]): round(draw.uniform(-0.2, 0.2), 3)}
        spec["contact"] = {"positions": 8}
    return spec


class RemedyTest(unittest.TestCase):
    def helps(self, verb, spec):
        """Applies the remedy of each finding. The finding must vanish, and no other finding may be new or worse."""
        answer = solved(verb, spec)
        if "verdict" not in answer:
            return 0
        before, tried = levels(answer), 0
        for finding in answer["verdict"]["findings"]:
            if not finding["change"]:
                continue
            changed = spec
            for path, value in finding["change"].items():
                changed = with_value(changed, path, value)
            after = solved(verb, changed)
            self.assertIn("verdict", after, (spec, finding["remedy"], after))
            now = levels(after)
            self.assertEqual(now.get((finding["code"], finding["gear"]), 0), 0, (spec, finding["remedy"]))
            self.assertEqual([k for k, v in now.items() if v > before.get(k, 0)], [], (spec, finding["remedy"]))
            tried += 1
        return tried

    def test_every_change_of_a_verdict_helps(self):
        draw = random.Random(20)
        tried = 0
        for _ in range(40):
            spec = random_pair(draw)
            tried += self.helps("contact" if "errors" in spec else "pair", spec)
        self.assertGreater(tried, 15)

    def test_a_remedy_is_tried_under_the_errors(self):
        """Regression: a thicker tooth removed the undercut, and the pair jammed under its crossing error."""
        self.assertGreater(self.helps("contact", {
            "gear1": {"teeth": 17, "normal_module_mm": 1, "face_width_mm": 20, "profile_shift": 0, "thickness_allowance_mm": -0.2},
            "gear2": {"teeth": 43, "face_width_mm": 20, "profile_shift": 0}, "pair": {"center_distance_mm": 30},
            "errors": {"crossing_deg": 0.2}}), 0)

    def test_edge_contact_of_a_crowned_pair_has_one_remedy(self):
        """Regression: a crowning and a slope were proposed side by side. The slope centres the contact and removes both."""
        gear = {"teeth": 24, "normal_module_mm": 2.5, "helix_angle_deg": 15, "profile_shift": 0.3, "face_width_mm": 28,
                "thickness_allowance_mm": -0.05, "modifications": {"lead_crowning_um": 8, "profile_crowning_um": 4}}
        found = solved("contact", {"gear1": gear, "gear2": {"teeth": 40, "thickness_allowance_mm": -0.05},
                                   "errors": {"crossing_deg": 0.069}, "contact": {"positions": 16}})["verdict"]["findings"]
        changes = {f["code"]: f["change"] for f in found if f["level"] == "amber"}
        self.assertEqual(set(changes), {"edge_contact", "contact_place"})
        self.assertEqual(changes["edge_contact"], {"gear1.modifications.lead_slope_um": -30})
        self.assertEqual(changes["contact_place"], changes["edge_contact"])

    def test_flanks_that_overlap_far_have_no_contact_of_fillets(self):
        """Regression: contact of tips with fillets was computed for half a minute although the flanks jam."""
        spec = {"gear1": {"teeth": 20, "normal_module_mm": 2, "face_width_mm": 20, "helix_angle_deg": 20},
                "gear2": {"teeth": -60, "face_width_mm": 20}, "errors": {"center_distance_mm": 40}}
        codes = [f["code"] for f in solved("contact", spec)["verdict"]["findings"]]
        self.assertIn("jam", codes)
        self.assertNotIn("fillet_contact", codes)


class LimitTest(unittest.TestCase):
    def limit(self, verb, spec, path):
        """The limit that the error of this key names. With the limit, the spec is accepted."""
        error = solved(verb, spec)["error"]
        self.assertEqual(error["key"], path, error)
        limit = float(re.search(r"must be at (?:most|least) (-?[\d.]+)", error["message"])[1])
        self.assertNotIn("error", solved(verb, with_value(spec, path, limit)), (error, limit))
        return limit

    def test_a_backlash_names_its_greatest_value(self):
        """Regression: the error named a profile shift of 0, or the dedendum of circular arcs."""
        for path, value, limit in (("pair.backlash_mm", 8, 5.48), ("pair.backlash_mm", 30, 5.48), ("pair.backlash_deg", 30, 15.7)):
            self.assertAlmostEqual(self.limit("pair", with_value(PAIR, path, value), path), limit, 1)
        arcs = {"teeth": 18, "normal_module_mm": 4, "helix_angle_deg": 22, "face_width_mm": 60, "rack": "GBT12759"}
        pair = {"gear1": arcs, "gear2": {**arcs, "teeth": 50, "helix_angle_deg": -22}, "pair": {"backlash_mm": 0}}
        self.assertAlmostEqual(self.limit("pair", pair, "pair.backlash_mm"), 0.24, 2)

    def test_an_allowance_beyond_the_cutter_names_its_least_value(self):
        cut = {"teeth": 30, "cut_by": {"teeth": 20, "normal_module_mm": 2}, "thickness_allowance_mm": -4}
        self.assertAlmostEqual(self.limit("pair", {**PAIR, "gear2": cut}, "gear2.thickness_allowance_mm"), -1.49, 2)

    def test_errors_name_the_tolerance(self):
        """Regression: the errors named the tip diameter, the shift or the centre distance at one end."""
        for path, value in (("gear1.tolerance.tip_diameter_deviations_mm", [-30, 0]), ("gear1.thickness_allowance_mm", [-3, 0]),
                            ("pair.center_distance_deviations_mm", [-30, 0])):
            error = solved("pair", with_value(PAIR, path, value))["error"]
            self.assertEqual(error["key"], path)
            self.assertIn("one end of this tolerance requires", error["message"])
        for allowance in (-3, 9):
            self.assertEqual(solved("pair", with_value(PAIR, "gear1.thickness_allowance_mm", allowance))["error"]["key"],
                             "gear1.thickness_allowance_mm")

    def test_one_tooth_has_no_dimension_over_balls(self):
        """Regression: the message contained an allowance of 1.8e17 mm."""
        gear = {"teeth": 1, "normal_module_mm": 4, "helix_angle_deg": 35, "face_width_mm": 40, "profile_shift": 0.7,
                "root_fillet": {"kind": "circular"}, "measure": {"ball_diameter_mm": 8}, "tolerance": {"over_balls_mm": [20, 20.1]}}
        error = solved("measure", {"gear1": gear})["error"]
        self.assertEqual(error["key"], "gear1.tolerance.over_balls_mm")
        self.assertIn("single tooth space", error["message"])


class Undercut(unittest.TestCase):
    def test_the_stated_shift_avoids_undercut_with_a_backlash(self):
        """Regression: 0.3897 was stated for the first pair, which is still undercut at 0.391, because the allowance for the
        backlash changes with the shift."""
        for z1, z2, m, pair in ((12, -48, 1.5, {"backlash_mm": 0.2}), (10, 30, 1, {"backlash_mm": 0.2, "backlash_split": 1}),
                                (9, 31, 2, {"backlash_deg": 0.5}), (11, 25, 1, {"backlash_circumferential_mm": 0.1, "center_distance_mm": 18})):
            spec = {"gear1": {"teeth": z1, "normal_module_mm": m, "face_width_mm": 10, "profile_shift": 0.1}, "gear2": {"teeth": z2}, "pair": pair}
            message = next(w["message"] for w in solved("pair", spec)["warnings"] if w["code"] == "undercut")
            self.assertIn("with teeth thinned for pair.backlash", message)
            least = float(re.search(r"profile shift of at least ([0-9.]+) avoids", message).group(1))
            for shift, undercut in ((least, False), (least - 3e-4, True)):
                gear = solved("pair", with_value(spec, "gear1.profile_shift", shift))["gears"][0]
                self.assertEqual(gear["undercut"], undercut, (spec, shift))

    def test_the_ratio_is_kept_if_a_shift_helps(self):
        """Regression: 20 teeth were proposed for 12 teeth in a ring of 48. With 10:30, each shift makes the tip thin."""
        spec = {"gear1": {"teeth": 10, "normal_module_mm": 1}, "gear2": {"teeth": 30}, "pair": {"backlash_mm": 0.2}}
        self.assertIn("and the gear ratio is 1.5.", solved("pair", spec)["verdict"]["headline"])
        spec = {"gear1": {"teeth": 12, "normal_module_mm": 1.5, "face_width_mm": 10}, "gear2": {"teeth": -48}, "pair": {"backlash_mm": 0.2}}
        verdict = solved("pair", spec)["verdict"]
        change = verdict["findings"][0]["change"]
        self.assertEqual(list(change), ["gear1.profile_shift"])
        after = solved("pair", with_value(spec, *next(iter(change.items()))))
        self.assertNotIn(verdict["findings"][0]["code"], [f["code"] for f in after["verdict"]["findings"]])

    def test_a_rack_has_remedies_with_numbers(self):
        spec = {"gear1": {"teeth": 16, "normal_module_mm": 1, "face_width_mm": 8, "thickness_allowance_mm": -0.05},
                "gear2": {"form": "rack", "thickness_allowance_mm": -0.05}}
        verdict = solved("pair", spec)["verdict"]
        self.assertEqual(verdict["level"], "amber")
        path, value = next(iter(verdict["findings"][0]["change"].items()))
        self.assertEqual(solved("pair", with_value(spec, path, value))["verdict"]["level"], "green")
        spec["gear1"]["teeth"] = 20
        for part in ("gear1", "gear2"):
            del spec[part]["thickness_allowance_mm"]
        self.assertIn("recommends at least", solved("pair", spec)["verdict"]["headline"])


class OtherMessages(unittest.TestCase):
    def test_a_rounding_error_is_no_backlash(self):
        """Regressions: "the backlash is -0.0000 mm", "touch 7.401e-05 mm"."""
        tight = {"gear1": {"teeth": 20, "normal_module_mm": 1, "profile_shift": 0}, "gear2": {"teeth": 40, "profile_shift": 0},
                 "pair": {"center_distance_mm": 29.9}}
        self.assertIn("With a centre distance of 30 mm, there is no backlash.", solved("pair", tight)["verdict"]["headline"])
        early = {"gear1": {"teeth": 12, "profile_shift": 0.39, "normal_module_mm": 1.5, "face_width_mm": 10}, "gear2": {"teeth": -48},
                 "pair": {"backlash_mm": 0.2}}
        messages = [w["message"] for w in solved("pair", early)["warnings"] if w["code"] == "beyond_flank"]
        self.assertTrue(any("still 0.074 µm apart" in m for m in messages), messages)

    def test_circular_arcs_in_a_drive_are_not_rated_or_loaded(self):
        arcs = {"normal_module_mm": 4, "helix_angle_deg": 22, "face_width_mm": 60, "rack": "GBT12759"}
        drive = {"input": "a", "output": "b", "body": [{"name": "a"}, {"name": "b"}], "mesh": [{"gears": ["p", "w"]}], "gear": [
            {**arcs, "name": "p", "body": "a", "teeth": 18}, {**arcs, "name": "w", "body": "b", "teeth": 50, "helix_angle_deg": -22}]}
        rating = {"torque_Nm": 100, "speed_rpm": 100, "quality": 6, "face_load_factor": 1.2}
        lossy = {**drive, "mesh": [{"gears": ["p", "w"], "efficiency": 0.98}]}
        for one in (drive, lossy):
            message = solved("rate", {"drive": one, "rating": rating})["error"]["message"]
            self.assertIn("circular-arc teeth, but ISO 6336 rates involute teeth only", message)
        message = solved("drive", {"drive": drive, "load": {"torque_Nm": 100}})["error"]["message"]
        self.assertIn("does not apply to circular-arc teeth", message)

    def test_the_verdict_states_the_backlash_of_the_result(self):
        spec = (SOURCE / "examples/circular_arc_drive.toml").read_text() + "\n[pair]\nbacklash_mm = 0.1\n"
        answer = Run("pair", spec, "--json").json
        self.assertAlmostEqual(answer["pair"]["backlash"]["normal_mm"], 0.1, 9)
        self.assertIn("a backlash of 0.1000 mm in the normal section", answer["verdict"]["headline"])

    def test_a_mesh_without_backlash_is_named(self):
        stage = {"teeth": [19, 58], "normal_module_mm": 2}
        said = solved("drive", {"stage": [{**stage, "thickness_series": "cd25"}, stage]})["verdict"]["headline"]
        self.assertIn("There is no backlash in the mesh s2_gear1_gear2. A thickness allowance of -0.06 mm on both of its gears", said)

    def test_readings_that_do_not_decide_are_named(self):
        """Regressions: one reading contradicted "the others", and two miscounted spans gave x_E = 1.37 without a remark."""
        def listing(**gear):
            return " ".join(Run("identify", json.dumps({"gear1": gear}), name="case.json").out.split())

        single = listing(teeth=29, helix_angle_deg=80, measured={"span_mm": {"4": 20}})
        self.assertIn("No standard gear matches this reading", single)
        self.assertNotIn("other readings", single)
        spans = listing(teeth=29, measured={"span_mm": {"3": 38.13, "4": 48.46}})
        self.assertIn("With one tooth more in each span, all readings agree with a gear of 29 teeth with the module 3.5", spans)
        self.assertIn("Measure the tip diameter, which is about 110.089 mm for this gear and 172.248 mm for candidate 1.", spans)


if __name__ == "__main__":
    unittest.main()
