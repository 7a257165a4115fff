"""Specs in inch. The same gears in mm and in inch have the same answer, number by number; errors, listings and printed specs
are in the units of the spec."""
import json
import math
import re
import tomllib
import unittest

import inch
from cli import SOURCE, Run, batch

PAIR = """
units = "inch"
[gear1]
teeth = 17
normal_diametral_pitch_per_in = 10
helix_angle_deg = 15
profile_shift = 0.3
face_width_in = 1
[gear1.modifications]
tip_relief_uin = 400
tip_relief_start_in = 1.95
[gear2]
teeth = 43
profile_shift = 0.1
[pair]
backlash_in = 0.004
"""
VERBS = ("gear", "pair", "measure", "rate", "identify", "fit", "drive", "contact", "outline", "search")
LENGTH_IN_MM = re.compile(r"\d (mm|µm)(?![²/\w])|(?<!module)_mm\b|_um\b")


def coarse_example(path):
    """Returns the spec with coarse finite elements and few samples, because a conversion of units does not depend on them."""
    spec = tomllib.loads(path.read_text())
    if "load" in spec:
        spec["load"] |= {"accuracy": "draft", "slices": 8, "positions": 8}
    if "scatter" in spec:
        spec["scatter"] |= {"samples": 16, "replicates": 2}
    return spec


def answers(verb, specs):
    """Returns the JSON of each spec."""
    if verb == "outline":  # `batch` does not support this verb
        return [Run(verb, json.dumps(spec), "--json", name="case.json").json for spec in specs]
    return batch(verb, specs)


class Law(unittest.TestCase):
    def test_the_answer_in_inch_is_the_answer_in_mm(self):
        paths = sorted(SOURCE.glob("examples/**/*.toml"))
        specs = [coarse_example(path) for path in paths]
        for spec in specs:
            if "search" in spec:  # the default step of face widths is 1 mm or 0.05 in, so it is given here
                spec["search"].setdefault("face_width_step_mm", 1)
        in_inch = [{"units": "inch"} | inch.spec_in_inch(spec) for spec in specs]
        compared = 0
        for verb in VERBS:
            mm = answers(verb, specs)
            solved = [i for i, answer in enumerate(mm) if "error" not in answer]
            self.assertTrue(solved, verb)
            for i, other in zip(solved, answers(verb, [in_inch[i] for i in solved]), strict=True):
                self.assertNotIn("error", other, f"{paths[i]} {verb}")
                self.assertEqual(inch.differences(mm[i], other), [], f"{paths[i]} {verb}")
                compared += len(inch.numbers(mm[i]))
        self.assertGreater(compared, 50_000)

    def same(self, text, *verbs):
        """Solves the spec in both systems and returns both JSON answers of the last verb."""
        spec = tomllib.loads(text)
        in_inch = {"units": "inch"} | inch.spec_in_inch(spec)
        for verb in verbs:
            mm, other = (Run(verb, json.dumps(s), "--json", name="case.json") for s in (spec, in_inch))
            self.assertEqual((mm.status, other.status), (0, 0), mm.err + other.err)
            self.assertEqual(inch.differences(mm.json, other.json), [], verb)
        return mm.json, other.json

    def test_numbers_by_member_and_by_number_of_teeth(self):
        members = ("[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\nnormal_module_mm = 2\n"
                   "face_width_mm = {sun = 20, planet = 18, ring = 19}\n"
                   "thickness_allowance_mm = {sun = -0.05, planet = -0.04, ring = -0.06}\ntorque_Nm = 20\n")
        self.same(members + "tip_diameter_mm = {sun = 43.8}\n", "drive")
        found, _ = self.same(members + "center_distance_mm = {sun_planet = 45.5}\n", "drive")
        self.assertAlmostEqual(found["drive"]["center_distance_mm"], 45.5)
        readings = ("[gear1]\nteeth = 23\n[gear1.measured]\nspan_mm = {3 = 19.751, 4 = 27.131}\ntip_diameter_mm = 66.71\n"
                    "over_balls_mm = [{ball_diameter_mm = 5, dimension_mm = 69.426}]\nlead_mm = 585\n")
        self.same(readings, "identify")

    def test_readings_that_contradict_each_other(self):
        readings = ("[gear1]\nteeth = 23\n[gear1.measured]\ntip_diameter_mm = 66.71\nlead_mm = 585\nover_balls_mm = ["
                    "{ball_diameter_mm = 5, dimension_mm = 69.426}, {ball_diameter_mm = 4.5, dimension_mm = 68.9}, "
                    "{ball_diameter_mm = 5.5, dimension_mm = 70.783}]\n")
        _, found = self.same(readings, "identify")
        contradiction = found["identify"]["contradiction"]
        self.assertEqual((contradiction["unit"], contradiction["tool_unit"]), ("in", "in"))
        self.assertLess(contradiction["value"], 3)

    def test_tables_for_spreadsheets(self):
        for name in ("crossed_pair", "crossed_ring_pair", "ring_pair", "rated_pair", "circular_arc_drive", "steering_rack"):
            spec = tomllib.loads((SOURCE / f"examples/{name}.toml").read_text())
            in_inch = json.dumps({"units": "inch"} | inch.spec_in_inch(spec))
            for verb in ("gear", "pair", "rate") if name == "rated_pair" else ("gear", "pair"):
                mm = Run(verb, json.dumps(spec), "--csv", name="case.json")
                other = Run(verb, in_inch, "--csv", name="case.json")
                self.assertEqual((mm.status, other.status), (0, 0), other.err)
                self.assertEqual(inch.csv_differences(mm.out, other.out), [], f"{name} {verb}")

    def test_the_changes_that_a_search_needs(self):
        text = ("[search]\nmodules_mm = [2]\nratio = [1.9, 2.1]\npinion_teeth = [20, 24]\ncenter_distance_mm = 50\n"
                "face_width_mm = 20\n")
        mm, other = self.same(text, "search")
        changes = zip(mm["search"]["changes"], other["search"]["changes"], strict=True)
        lengths = [(a, b) for a, b in changes if a["key"].endswith("_mm") and a["key"] != "search.modules_mm"]
        self.assertTrue(lengths, mm["search"]["changes"])
        for a, b in lengths:
            self.assertEqual(b["key"], a["key"][:-2] + "in")
            for end in ("from", "to"):
                ends = [value if isinstance(value, list) else [value] for value in map(json.loads, (a[end], b[end]))]
                for in_mm, in_inch in zip(*ends, strict=True):
                    self.assertAlmostEqual(25.4 * in_inch, in_mm, delta=1e-9)
        run = Run("search", json.dumps({"units": "inch"} | inch.spec_in_inch(tomllib.loads(text))), name="case.json")
        self.assertIn(f"{lengths[0][1]['key']} = {lengths[0][1]['to']} instead of {lengths[0][1]['from']}", run.out)


class Words(unittest.TestCase):
    def test_a_search_by_diametral_pitch(self):
        text = ('title = "case"\nunits = "inch"\n[search]\nratio = [3.1, 3.2]\ncenter_distance_in = 5\n'
                'diametral_pitches_per_in = 8\nhelix_angle_deg = 25\nobjective = "mass"\n')
        listed = Run("search", text)
        self.assertEqual(listed.status, 0, listed.err)
        self.assertNotRegex(listed.out, r"3\.175| kg\n")
        self.assertRegex(listed.out, r"8\.000")
        self.assertRegex(listed.out, r"\blb\b")
        design = Run("search", text, "--json").json["search"]["designs"][0]
        self.assertAlmostEqual(design["normal_diametral_pitch_per_in"], 8, delta=1e-12)
        self.assertEqual(design["module_mm"], 3.175)
        taken = Run("search", text, "--take", 1).out
        self.assertRegex(taken, r'title = "case, \d+:\d+, diametral pitch 8"')
        in_mm = Run("search", "[search]\nratio = [3.1, 3.2]\ncenter_distance_mm = 127\nmodules_mm = 3\nhelix_angle_deg = 25\n"
                    'objective = "mass"\n', "--json").json["search"]["designs"][0]
        self.assertNotIn("normal_diametral_pitch_per_in", in_mm)

    def test_errors_are_in_inch(self):
        for old, new, *words in (
                ("face_width_in = 1", "face_width_in = -1", "gear1.face_width_in = -1: must be greater than 0"),
                ("face_width_in = 1", "face_with_in = 1", "gear1.face_with_in = 1: unknown key", "face_width_in"),
                ("[pair]", "[pair]\nbearing_span_in = -2", "pair.bearing_span_in = -2: must be greater than 0"),
                ("[pair]", "[contact]\nmarking_in = 1\n[pair]", "contact.marking_in = 1: ", "at most 0.03937",
                 "usually 0.0001181 to 0.0003937"),
                ("[pair]", "[pair]\ncenter_distance_in = 1", "pair.center_distance_in = 1:"),
                ("[pair]", "[pair]\nbacklash = 2", "pair.backlash = 2: unknown key", "backlash_in"),
                ("teeth = 17", "teeth = 17\nnormal_module_in = 0.1", "gear1.normal_module_in = 0.1: is not a key, because modules are in mm"),
                ("[pair]", "[compensate]\ncorrections = [\"gear1.lead_crowning_um\"]\n[pair]",
                 "compensate.corrections[1] = \"gear1.lead_crowning_um\": is not allowed", "give gear1.lead_crowning_uin"),
                ('"inch"', '"cm"', 'units = "cm": must be one of "mm", "inch"')):
            run = Run("pair", PAIR.replace(old, new))
            self.assertEqual(run.status, 1, new)
            for text in words:
                self.assertIn(text, run.err)
            if "cm" not in new and "_um" not in new:
                self.assertNotRegex(run.err, LENGTH_IN_MM)

    def test_units_are_never_mixed_silently(self):
        run = Run("pair", PAIR.replace("face_width_in = 1", "face_width_mm = 25"))
        self.assertIn("gear1.face_width_mm = 25: is not allowed", run.err)
        self.assertIn("give face_width_in = 0.984251968503937", run.err)
        run = Run("pair", PAIR.replace('units = "inch"', ""))
        self.assertEqual(run.status, 1)
        self.assertIn('needs units = "inch" at the top', run.err)

    def test_names_that_the_user_chose_are_kept(self):
        spec = PAIR.replace("[pair]", '[scatter.groups]\ncase_in = ["errors.crossing_deg"]\n[drawing]\nnumber = "plate_20_mm"\n'
                            "[pair]").replace('"inch"', '"inch"\ntitle = "bush 20 mm, ring_mm"')
        self.assertEqual(Run("pair", spec, "--json").json["title"], "bush 20 mm, ring_mm")
        self.assertIn("bush 20 mm, ring_mm", Run("pair", spec).out)
        drive = ('units = "inch"\n[drive]\ninput = "a_in"\noutput = "wheel"\n[[drive.body]]\nname = "a_in"\n[[drive.body]]\n'
                 'name = "wheel"\n[[drive.gear]]\nname = "p_in"\nbody = "a_in"\nteeth = 20\nnormal_module_mm = 2\n'
                 'face_width_in = 1\n[[drive.gear]]\nname = "q_mm"\nbody = "wheel"\nteeth = 40\nnormal_module_mm = 2\n'
                 'face_width_in = 1\n[[drive.mesh]]\ngears = ["p_in", "q_mm"]\n')
        run = Run("drive", drive, "--json")
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual(sorted(run.json["drive"]["bodies"]), ["a_in", "wheel"])

    def test_a_corrected_spec_keeps_the_numbers_that_are_not_lengths(self):
        text = (SOURCE / "examples/misaligned_pair.toml").read_text().replace(
            "[compensate.range]", "[compensate.range]\ncenter_distance_mm = [-0.05, 0.05]") + (
            '\n[scatter.errors]\naxial_mm = {range = [-0.1, 0.1], distribution = "normal", cpk = 1.25}\n')
        spec = {"units": "inch"} | inch.spec_in_inch(tomllib.loads(text))
        run = Run("compensate", json.dumps(spec), "--take", name="case.json")
        self.assertEqual(run.status, 0, run.err)
        taken = tomllib.loads(run.out) if not run.out.startswith("{") else json.loads(run.out)
        self.assertEqual(taken["scatter"]["errors"]["axial_in"]["cpk"], 1.25)
        self.assertAlmostEqual(taken["scatter"]["errors"]["axial_in"]["range"][1], 0.1 / 25.4)
        run = Run("compensate", json.dumps(spec), name="case.json")
        self.assertIn("Centre distance -0.001969 in, ", run.out)
        self.assertNotRegex(" ".join(run.out.split()), LENGTH_IN_MM)

    def test_bores_are_listed_in_inch(self):
        run = Run("scatter", PAIR + "[scatter]\nsamples = 4\nreplicates = 2\n[scatter.bearings]\nspan_in = 4\n"
                                    "radius_in = 0.001\n")
        self.assertRegex(run.out, r"bearings\.bore_a  in +-0\.001 +0\.001 ")

    def test_a_tip_below_the_root_of_a_drive(self):
        run = Run("drive", 'units = "inch"\n[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\n'
                           "normal_module_mm = 2\ntip_diameter_in = {sun = 1}\n")
        self.assertIn("tip_diameter_in = 1: must be greater than the root diameter 1.378 in", " ".join(run.out.split()))

    def test_no_listing_mixes_units(self):
        for verb in ("gear", "pair", "measure", "contact"):
            text = Run(verb, PAIR).out
            for line in text.splitlines():
                if "module" not in line and "per mm" not in line:
                    self.assertNotRegex(line, LENGTH_IN_MM, verb)
            self.assertIn("  in\n", text.replace("in  in", "in  in\n"))
        for name in ("crossed_ring_pair", "misaligned_pair", "rated_pair", "ring_pair", "circular_arc_drive"):
            spec = {"units": "inch"} | inch.spec_in_inch(tomllib.loads((SOURCE / f"examples/{name}.toml").read_text()))
            for verb in ("pair", "rate") if name == "rated_pair" else ("pair", "contact"):
                text = Run(verb, json.dumps(spec), name="case.json").out
                verdict = " ".join(text[text.rfind("Verdict"):].split())  # lines are wrapped between number and unit
                self.assertNotRegex(verdict, LENGTH_IN_MM, name)
                self.assertNotIn("hardened: ρ' = 0.0030 mm", text)

    def test_tables_for_spreadsheets(self):
        rows = Run("pair", PAIR, "--csv").out.splitlines()
        self.assertIn("pair.center_distance_in,centre distance,a,in,", "\n".join(rows))
        self.assertIn("gears.normal_module_mm,normal module,m_n,mm,2.54,2.54", rows)
        self.assertTrue(Run("outline", PAIR, "--csv", "--gear", "1").out.startswith("arc,x_in,y_in"))

    def test_pins_of_a_gear_given_by_its_diametral_pitch(self):
        measures = [g["measure"] for g in Run("measure", PAIR, "--json").json["gears"]]
        self.assertEqual([m["over_pins"]["pin_diameter_in"] for m in measures], [0.1728, 0.1728])
        self.assertEqual([m["over_balls"]["ball_diameter_in"] for m in measures], [0.1728, 0.1728])
        ring = Run("measure", 'units = "inch"\n[gear1]\nteeth = -60\nnormal_diametral_pitch_per_in = 8\n', "--json").json
        self.assertEqual(ring["gears"][0]["measure"]["over_pins"]["pin_diameter_in"], 0.21)
        by_module = Run("measure", PAIR.replace("normal_diametral_pitch_per_in = 10", "normal_module_mm = 2.54"), "--json")
        self.assertNotEqual(by_module.json["gears"][0]["measure"]["over_pins"]["pin_diameter_in"], 0.1728)

    def test_pin_of_a_rack_given_by_the_diametral_pitch_of_its_pinion(self):
        text = 'units = "inch"\n[gear1]\nteeth = 20\n{}\n[gear2]\nform = "rack"\nteeth = 12\nheight_in = 0.5\n'
        rack = Run("gear", text.format("normal_diametral_pitch_per_in = 10"), "--json").json["gears"][1]
        self.assertEqual(rack["pin_diameter_in"], 0.1728)
        slope = math.tan(math.radians(20))
        height = (0.1728 / math.cos(math.radians(20)) - math.pi / 20) / (2 * slope)
        self.assertAlmostEqual(rack["over_pin_in"], 0.5 + height + 0.0864, 12)
        by_module = Run("gear", text.format("normal_module_mm = 2.54"), "--json").json["gears"][1]
        self.assertAlmostEqual(by_module["pin_diameter_in"] * 25.4, 4.25, 12)

    def test_racks_of_agma_bring_their_pressure_angle(self):
        for rack, degrees, whole in (("AGMA-14.5", 14.5, 2.157), ("AGMA-20", 20, 2.25), ("AGMA-25", 25, 2.25),
                                     ("AGMA-stub", 20, 1.8)):
            gear = f'units = "inch"\n[gear1]\nteeth = 40\nnormal_diametral_pitch_per_in = 4\nrack = "{rack}"\n'
            made = Run("gear", gear, "--json").json["gears"][0]
            self.assertEqual(made["normal_pressure_angle_deg"], degrees)
            self.assertAlmostEqual((made["tip_diameter_in"] - made["root_diameter_in"]) / 2 * 4, whole, delta=1e-12)
            run = Run("gear", gear + "normal_pressure_angle_deg = 17.5\n")
            self.assertIn(f"has a pressure angle of {degrees}°", run.err)

    def test_a_gear_of_14_5_degrees_names_its_standard_rack(self):
        gear = "[gear1]\nteeth = 40\nnormal_diametral_pitch_per_in = 4\nnormal_pressure_angle_deg = {}\n{}"
        for angle, rack, noted in ((14.5, "", True), (20, "", False), (14.5, 'rack = "AGMA-14.5"\n', False),
                                   (14.5, 'rack = "ISO53-A"\n', False)):
            run = Run("gear", gear.format(angle, rack), "--json")
            notes = [w["message"] for w in run.json["warnings"] if w["code"] == "default_rack"]
            self.assertEqual(bool(notes), noted, (angle, rack))
            if noted:
                self.assertIn('rack = "AGMA-14.5"', notes[0])

    def test_a_fitted_pair_keeps_its_diametral_pitch(self):
        text = (SOURCE / "examples/printed_drive_fit.toml").read_text()
        text = text.replace("normal_module_mm = 2", "normal_diametral_pitch_per_in = 12.7")
        taken = tomllib.loads(Run("fit", text, "--take", 1).out)
        for gear in (taken["gear1"], taken["gear2"]["cut_by"]):
            self.assertEqual(gear["normal_diametral_pitch_per_in"], 12.7)
            self.assertNotIn("normal_module_mm", gear)

    def test_a_search_tries_diametral_pitches(self):
        text = ('units = "inch"\n[search]\nratio = [2.9, 3.1]\npinion_teeth = [18, 22]\ncenter_distance_in = [3, 12]\n'
                "diametral_pitches_per_in = {}\n")
        for pitches, modules in (("[8, 10]", {3.175, 2.54}), ('"coarse"', None)):
            found = Run("search", text.format(pitches), "--json").json["search"]["designs"]
            used = {d["module_mm"] for d in found}
            self.assertTrue(found)
            self.assertTrue(used <= (modules or {25.4 / p for p in (2, 2.25, 2.5, 3, 4, 6, 8, 10, 12, 16)}), used)
        taken = Run("search", text.format("3"), "--take", "1").out
        self.assertEqual(taken.count("normal_diametral_pitch_per_in = 3.0\n"), 2, taken)
        self.assertEqual(Run("pair", taken).status, 0)
        run = Run("search", text.format("[8, 8]"), "--json")
        self.assertIn("diametral_pitches_per_in", run.err)


class Pictures(unittest.TestCase):
    """Reports in inch. Texts of figures and tables have no lengths in mm, except modules, and the axes of each
    figure are those of the report in mm, divided by the size of the unit."""
    RATIOS = (1.0, 25.4, 0.0254, 25.4 ** 2)

    def report(self, spec):
        """Returns the report, or None if the spec has none."""
        run = Run("run", json.dumps(spec), "--only", "report", "--out", "out", name="case.json")
        return (run.folder / "out/report.html").read_text() if run.status == 0 else None

    def axes(self, page):
        """Returns {id of a figure: the ends of its axes}."""
        found = {}
        for name, picture in re.findall(r'<svg class="zoom" id="([^"]*)"(.*?)</svg>', page, re.S):
            for axis in re.findall(r'data-[xy]="(\S+) (\S+) ', picture):
                found.setdefault(name, []).append([float(end) for end in axis])
        return found

    def test_no_picture_and_no_table_mixes_units(self):
        compared = 0
        for path in sorted(SOURCE.glob("examples/**/*.toml")):
            spec = coarse_example(path)
            if "gear1" not in spec and not any(key in spec for key in ("planetary", "drive", "stage")):
                continue
            mm = self.report(spec)
            if mm is None:  # these need the verbs identify, fit and search
                self.assertIn(path.stem, ("broken_gear", "crossed_fit", "housing_search"))
                continue
            other = self.report({"units": "inch"} | inch.spec_in_inch(spec))
            self.assertIsNotNone(other, path.name)
            body = re.sub(r"<(style|script|pre)\b.*?</\1>", "", other, flags=re.S)
            texts = re.findall(r">([^<>]+)<", body) + re.findall(r'data-(?:name|value)="([^"]*)"', body)
            for text in texts:
                if re.search(r"(?<!\u00a0)\b(mm|µm)\b(?!²)", text) and not re.search("N/|module|kg/mm|per mm", text):
                    before = body[:body.find(">" + text + "<")][-300:]
                    self.assertIn("module", before, f"{path.name}: {text}")
            left, right = self.axes(mm), self.axes(other)
            self.assertEqual(left.keys(), right.keys(), path.name)
            for name, axes in left.items():
                for old, new in zip(axes, right[name], strict=True):
                    size = max(old, key=abs) / max(new, key=abs)
                    self.assertTrue(any(abs(size / r - 1) < 1e-6 for r in self.RATIOS), f"{path.name} {name} {old} {new}")
                    compared += size != 1.0
        self.assertGreater(compared, 100)


class Printed(unittest.TestCase):
    def test_a_printed_spec_keeps_its_units_and_its_numbers(self):
        spec = "units = \"inch\"\n" + (SOURCE / "examples/crossed_fit.toml").read_text()
        spec = json.dumps({"units": "inch"} | inch.spec_in_inch(tomllib.loads(spec)))
        taken = Run("fit", spec, "--take", "1", name="case.json")
        self.assertEqual(taken.status, 0, taken.err)
        self.assertTrue(taken.out.startswith('units = "inch"') or '\nunits = "inch"' in taken.out, taken.out)
        self.assertNotRegex(taken.out, r"(?<!module)_mm")
        again = Run("pair", taken.out, "--json")
        self.assertEqual(again.status, 0, again.err)
        branch = Run("fit", spec, "--json", name="case.json").json["fit"]["branches"][0]
        self.assertEqual(again.json["pair"]["center_distance_in"], branch["spec"]["pair"]["center_distance_in"])
        self.assertEqual(branch["spec"]["units"], "inch")

    def test_face_widths_of_searches_are_round_in_inch(self):
        """Within a band in inch, the widths are multiples of 0.05 in, as those of a spec in mm are of 1 mm."""
        text = ('units = "inch"\n[search]\nratio = [2.9, 3.1]\npinion_teeth = [18, 22]\ndiametral_pitches_per_in = [8]\n'
                'face_width_in = [0.5, 2]\nsafety_flank_min = 1\nsafety_root_min = 1\n'
                '[gear1.material]\nname = "16MnCr5"\n[rating]\ntorque_Nm = 60\nspeed_rpm = 1000\nquality = [6, 6]\n')
        for more, step in (("", 0.05), ("face_width_step_in = 0.0625\n", 0.0625)):
            run = Run("search", text.replace("safety_flank", more + "safety_flank"), "--json")
            self.assertEqual(run.status, 0, run.err)
            widths = [design["face_width_in"] for design in run.json["search"]["designs"]]
            self.assertTrue(widths)
            self.assertLess(min(widths), 2)
            for width in widths:
                self.assertAlmostEqual(width / step, round(width / step), 9)
                self.assertLessEqual(0.5, width)

    def test_the_files_of_a_search(self):
        spec = tomllib.loads((SOURCE / "examples/gearbox_search.toml").read_text())
        mm = Run("search", json.dumps(spec), "--out", "found", name="case.json")
        other = Run("search", json.dumps({"units": "inch"} | inch.spec_in_inch(spec)), "--out", "found", name="case.json")
        self.assertEqual((mm.status, other.status), (0, 0), other.err)
        answers = [json.loads((run.folder / "found/search.json").read_text()) for run in (mm, other)]
        self.assertEqual(inch.differences(*answers), [])
        best = [(run.folder / "found/best.csv").read_text() for run in (mm, other)]
        self.assertEqual(*best)  # the tables are in mm
        report = (other.folder / "found/report.html").read_text()
        self.assertIn("Lengths are in inch, angles", report)
        distance = answers[1]["search"]["designs"][0]["center_distance_in"]
        self.assertIn(f"centre distance {distance:.5f} in", report)

    def test_what_is_in_mm_only_says_so(self):
        search = {"units": "inch"} | inch.spec_in_inch(tomllib.loads((SOURCE / "examples/gearbox_search.toml").read_text()))
        search["scatter"] = {"errors": {"axial_in": [-0.001, 0.001]}}
        run = Run("scatter", json.dumps(search), "--out", "found", name="case.json")
        self.assertEqual(run.status, 1)
        self.assertIn("give the spec in mm", run.err)


if __name__ == "__main__":
    unittest.main()
