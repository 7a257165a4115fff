"""Tests the meshes of a drive as pairs. The spec that `drive --take` prints has the numbers of the drive.
For a double-helical mesh, these are the numbers of one half."""
import json
import math
import re
import tomllib
import unittest

from cli import SOURCE, Run
from test_drive import EXAMPLES, SET
from test_drive_racks import LIFT


class Meshes(unittest.TestCase):
    def test_the_spec_of_a_mesh_has_the_numbers_of_the_drive(self):
        compared = 0
        for example in EXAMPLES:
            text = example.read_text()
            meshes = Run("drive", text, "--json").json["drive"]["meshes"]
            for number, (name, mesh) in enumerate(meshes.items(), 1):
                with self.subTest(example=example.name, mesh=name):
                    spec = Run("drive", text, "--take", str(number))
                    self.assertEqual(spec.status, 0, spec.err)
                    title = next(line for line in spec.out.splitlines() if line.startswith("title"))
                    self.assertIn(name, title)
                    pair = Run("pair", spec.out, "--json").json["pair"]
                    self.assertEqual({key: pair[key] for key in mesh["pair"]}, mesh["pair"])
                    compared += 1
        self.assertGreaterEqual(compared, 12)

    def test_the_contact_of_a_mesh_is_that_of_its_spec(self):
        """With errors of mounting, or with the verb `run`, every mesh has the record of the verb `contact`."""
        errors = "\n[errors]\ncrossing_deg = 0.01\naxial_mm = 0.1\n[contact]\npositions = 16\npattern = true\n"
        for name in ("two_stage_gearbox", "ravigneaux", "wind_turbine_stage"):
            text = (SOURCE / f"examples/drives/{name}.toml").read_text() + errors
            meshes = Run("drive", text, "--json").json["drive"]["meshes"]
            for number, mesh in enumerate(meshes.values(), 1):
                with self.subTest(example=name, mesh=number):
                    pair = Run("drive", text, "--take", str(number))
                    alone = Run("contact", pair.out, "--json")
                    self.assertEqual(alone.status, 0, alone.err)
                    self.assertGreater(mesh["contact"]["peak_to_peak_arcsec"], 0)
                    self.assertEqual(mesh["contact"], alone.json["contact"])
        self.assertIn("Tooth contact", Run("drive", SET + errors).out)
        self.assertNotIn("contact", Run("drive", SET, "--json").json["drive"]["meshes"]["sun_planet"])
        made = Run("run", SET, "--json", "--out", "made").json["drive"]["meshes"]
        alone = Run("contact", Run("drive", SET, "--take", "1").out, "--json").json
        self.assertEqual(made["sun_planet"]["contact"], alone["contact"])

    def test_an_idler_has_two_places(self):
        """The other place has the same ratio and backlash, but another force on the pin of the idler."""
        sides = [Run("drive", "[planetary]\nsun = 26\nidler = 17\nplanet = 17\nring = 80\nplanets = 3\n"
                     f"normal_module_mm = 2\ntorque_Nm = 50\nidler_side = '{side}'\n", "--json").json["drive"]
                 for side in ("counter_clockwise", "clockwise")]
        for key in ("ratio", "backlash"):
            self.assertEqual(sides[0][key], sides[1][key])
        for key in ("positions", "neighbour_clearance_mm"):
            self.assertAlmostEqual(sides[0]["assembly"][key], sides[1]["assembly"][key], 9)
        force = [side["bodies"]["idler"]["radial_force_N"] for side in sides]
        self.assertGreater(force[0], 1.2 * force[1])
        for text in (SET, SET.replace("[planetary]", "[planetary]\nidler_side = 'counter_clockwise'")):
            self.assertEqual(Run("drive", text, "--json").status, 0)
        wrong = Run("drive", SET + "idler_side = 'clockwise'\n", "--json")
        self.assertEqual(wrong.json["error"]["key"], "planetary.idler_side")

    def test_a_mesh_carries_its_torque(self):
        """Three planets share the torque of the sun. The tooth forces of a planet in its meshes with the
        sun and with the ring are equal."""
        sun = Run("drive", SET + "torque_Nm = 60\n", "--take", "1").out
        ring = Run("drive", SET + "torque_Nm = 60\n", "--take", "2").out
        torque = [float(re.search(r"torque_Nm = (\S+)", spec).group(1)) for spec in (sun, ring)]
        self.assertAlmostEqual(torque[0], 20, 9)
        self.assertAlmostEqual(torque[1], 20 * 25 / 20, 0)  # minus the loss in the first mesh
        self.assertEqual(Run("load", sun, "--json").status, 0)

    def test_a_mesh_without_load_has_no_torque(self):
        text = (SOURCE / "examples/drives/ravigneaux.toml").read_text()
        loads = ["[load]" in Run("drive", text, "--take", str(n)).out for n in (1, 2, 3, 4)]
        self.assertEqual(loads, [True, True, False, True])
        still = Run("drive", SET + "torque_Nm = 0\n", "--take", "1")
        self.assertEqual(still.status, 0, still.err)
        self.assertNotIn("[load]", still.out)

    def test_a_mesh_without_module_has_no_contact(self):
        """The second mesh has no module and does not move the output, so only the errors of the
        first mesh are judged."""
        gear = '[[drive.gear]]\nname = "{}"\nbody = "{}"\nteeth = {}\n'
        spec = '[drive]\ninput = "a"\noutput = "b"\n' + "".join(f'[[drive.body]]\nname = "{b}"\n' for b in "abc")
        for name, body, teeth in (("g1", "a", 20), ("g2", "b", 40)):
            spec += gear.format(name, body, teeth) + "normal_module_mm = 2\n"
        spec += gear.format("g3", "b", 30) + gear.format("g4", "c", 33)
        spec += '[[drive.mesh]]\ngears = ["g1", "g2"]\n[[drive.mesh]]\ngears = ["g3", "g4"]\n[errors]\ncrossing_deg = 0.1\n'
        verdict = Run("drive", spec, "--json").json["verdict"]
        self.assertEqual(verdict["not_judged"], [])
        self.assertIn("edge_contact", [f["code"] for f in verdict["findings"]])

    def test_the_head_of_a_mesh_gives_faults_of_the_drive(self):
        """A Wolfrom set with a high ratio is self-locking if the ring drives."""
        locked = """
[planetary]
sun = 12
planet = 30
planet2 = 29
ring = 72
ring2 = 71
planets = 3
normal_module_mm = 1
friction_coefficient = 0.3
input = "ring2"
output = "sun"
torque_Nm = 5
"""
        drive = Run("drive", locked, "--json").json
        self.assertTrue(drive["drive"]["self_locking"])
        head = [line for line in Run("drive", locked, "--take", "1").out.splitlines() if line.startswith("#")]
        self.assertIn("cannot drive the output", " ".join(head).replace("# ", ""))
        self.assertEqual(drive["verdict"]["level"], "red")
        self.assertIn("cannot_drive", [f["code"] for f in drive["verdict"]["findings"]])
        thick = SET + "thickness_allowance_mm = 0.4\n"
        self.assertEqual(Run("drive", thick, "--json").json["verdict"]["level"], "red")
        spec = Run("drive", thick, "--take", "1")
        self.assertIn("does not run as specified", spec.out.split("title")[0].replace("\n# ", " "))
        self.assertIn("does not run as specified", Run("drive", thick, "--take", "1", "--json").err)
        self.assertEqual(Run("drive", SET, "--take", "1", "--json").err, "")
        self.assertTrue(all(line.startswith("# ") and len(line) <= 80 for line in spec.out.split("title")[0].splitlines()))

    def test_a_mesh_carries_its_rating(self):
        """The safeties of a mesh equal those of the drive. If the flanks of its gears are used differently,
        the spec has the more severe use for both gears, so its safeties may be lower."""
        rating = ('\n[rating]\ntorque_Nm = 40\nspeed_rpm = 1450\nlife_h = 20000\nquality = 6\nface_load_factor = 1.3\n'
                  'lubricant_viscosity_40C_mm2_s = 220\nmaterial = { name = "16MnCr5" }\n')
        train = (SOURCE / "examples/drives/two_stage_gearbox.toml").read_text() + rating
        for drive, meshes in ((train, 2), (SET + rating, 2)):
            rated = list(Run("rate", drive, "--json").json["drive"]["meshes"].values())
            for number in range(1, meshes + 1):
                spec = Run("drive", drive, "--take", str(number))
                pair = Run("rate", spec.out, "--json")
                self.assertEqual(pair.status, 0, pair.err + spec.out)
                of_drive, of_pair = rated[number - 1]["rating"], pair.json["rating"]
                self.assertEqual(of_pair["F_t_N"], of_drive["F_t_N"])
                if "engage" not in spec.out:
                    for key in ("S_H", "S_F", "K_v"):
                        self.assertEqual(of_pair[key], of_drive[key])
                else:
                    for key in ("S_H", "S_F"):
                        for a, b in zip(of_pair[key], of_drive[key]):
                            self.assertLessEqual(a, b)
        idle = (SOURCE / "examples/drives/ravigneaux.toml").read_text() + rating.replace("torque_Nm = 40\nspeed_rpm = 1450\n", "")
        self.assertIn("The table [rating] is left out", Run("drive", idle, "--take", "3").out)

    def test_the_driving_gear_is_that_of_the_drive(self):
        back = SET + 'torque_Nm = 60\ninput = "carrier"\noutput = "sun"\n'
        self.assertIn("driver = 2", Run("drive", back, "--take", "1").out)
        self.assertNotIn("driver", Run("drive", SET + "torque_Nm = 60\n", "--take", "1").out)

    def test_a_backlash_thins_the_teeth(self):
        """Every mesh has the given backlash, and the printed specs of its meshes have it, too."""
        for text, wanted in ((SET + "backlash_mm = 0.1\n", {"sun_planet": 0.1, "planet_ring": 0.1}),
                             (SET + "backlash_mm = [0.06, 0.1]\n", {"sun_planet": 0.08, "planet_ring": 0.08}),
                             (SET + "backlash_mm = { sun_planet = 0.05, planet_ring = 0.3 }\n",
                              {"sun_planet": 0.05, "planet_ring": 0.3}),
                             ("[[stage]]\nteeth = [19, 58]\nnormal_module_mm = 2\nhelix_angle_deg = 20\n"
                              "profile_shift = [0.3, 0.2]\nbacklash_mm = 0.15\n", {"s1_gear1_gear2": 0.15}),
                             ("[[stage]]\nnormal_module_mm = 2\nbacklash_mm = 0.15\n[stage.planetary]\nsun = 20\n"
                              "planet = 25\nring = 70\n", {"s1_sun_planet": 0.15, "s1_planet_ring": 0.15})):
            run = Run("drive", text, "--json")
            self.assertEqual(run.status, 0, run.err)
            meshes = run.json["drive"]["meshes"]
            for number, (name, backlash) in enumerate(wanted.items(), 1):
                self.assertAlmostEqual(meshes[name]["pair"]["backlash"]["normal_mm"], backlash, delta=1e-9)
                pair = Run("pair", Run("drive", text, "--take", number).out, "--json").json["pair"]
                self.assertAlmostEqual(pair["backlash"]["normal_mm"], backlash, delta=1e-9)
            expanded = Run("drive", text, "--expand").out
            self.assertEqual(Run("drive", expanded, "--json").json["drive"]["meshes"], meshes)
            self.assertNotIn("thickened_for_backlash", [w["code"] for w in run.json["verdict"]["findings"]])
        run = Run("drive", SET.replace("normal_module_mm", "#") + "backlash_mm = 0.1\n", "--json")
        self.assertEqual(run.json["error"]["key"], "planetary.backlash_mm")
        for keys in ("thickness_allowance_mm = -0.05\n", 'thickness_series = "cd25"\n'):
            run = Run("drive", SET + keys + "backlash_mm = 0.1\n", "--json")
            self.assertEqual(run.json["error"]["key"], "planetary.backlash_mm")
        run = Run("drive", "[[stage]]\nteeth = [17, 51]\nnormal_module_mm = 2\nbacklash_mm = {gear1_gear2 = 0.1}\n", "--json")
        self.assertIn("a pair of gears has one mesh", run.json["error"]["message"])

    def test_a_backlash_that_no_teeth_can_have_names_its_mesh(self):
        """The finding has the value of `backlash_mm`, the allowances that it requires, and the greatest possible backlash."""
        lift = LIFT.replace('r"], efficiency', 'r"], backlash_mm = 4, efficiency')
        for text, names, requires in ((lift, ["p_r"], "thickness allowances of -2 mm for p and -2 mm for r"),
                                      (SET + "backlash_mm = 9\n", ["sun_planet", "planet_ring"], "thickness allowances of -4.5 mm for")):
            findings = Run("drive", text, "--json").json["verdict"]["findings"]
            self.assertEqual([f["code"] for f in findings if f["level"] == "red"], ["not_coaxial"] * len(names))
            for finding, name in zip(findings, names):
                self.assertRegex(finding["message"], f"^The mesh {name} cannot have a backlash of .*{requires}")
            limit = re.search(r"At most (\S+) mm is possible", findings[0]["message"]).group(1)
            most = Run("drive", re.sub(r"backlash_mm = \d", f"backlash_mm = {limit}", text), "--json").json
            self.assertNotIn("cannot", most["verdict"]["headline"])
        headline = Run("drive", LIFT.replace("= 18", "= 18, thickness_allowance_mm = -2"), "--json").json["verdict"]["headline"]
        self.assertIn("The mesh p_r cannot be mounted: r: thickness_allowance_mm = -2: must lie between -1.6857", headline)

    def test_a_series_gives_the_means_of_its_allowances(self):
        """cd25 has −69 µm up to 50 mm and −90 µm up to 125 mm in the mean."""
        text = SET + 'thickness_series = "cd25"\n'
        expanded = tomllib.loads(Run("drive", text, "--expand").out)["drive"]["gear"]
        for gear in expanded:
            d = abs(gear["teeth"]) * gear["normal_module_mm"]
            self.assertAlmostEqual(gear["thickness_allowance_mm"], -0.069 if d <= 50 else -0.09 if d <= 125 else -0.12, delta=1e-12)
        stage = '[[stage]]\nteeth = [19, 58]\nnormal_module_mm = 2\nthickness_series = "cd25"\n'
        expanded = tomllib.loads(Run("drive", stage, "--expand").out)["drive"]["gear"]
        self.assertEqual([g["thickness_allowance_mm"] for g in expanded], [-0.069, -0.09])
        for drive in (text, stage):
            meshes = Run("drive", drive, "--json").json["drive"]["meshes"]
            for number, mesh in enumerate(meshes.values(), 1):
                taken = Run("drive", drive, "--take", str(number)).out
                self.assertEqual(taken.count('thickness_series = "cd25"'), 2)
                self.assertNotIn("thickness_allowance_mm", taken)
                pair = Run("pair", taken, "--json").json["pair"]
                self.assertEqual(pair["backlash"]["normal_mm"], mesh["pair"]["backlash"]["normal_mm"])
                self.assertEqual(len(pair["interval"]["backlash"]["normal_mm"]), 2)

    def test_the_rating_lists_the_factors_of_every_mesh(self):
        rating = "[rating]\npower_kW = 5\nspeed_rpm = 1000\nquality = 6\nface_load_factor = 1.2\nmaterial = \"16MnCr5\"\n"
        out = Run("rate", SET + rating).out
        for name in ("sun_planet", "planet_ring"):
            _, _, factors = out.partition(f"Strength of {name}\n")
            for symbol in ("Z_H", "K_v", "K_Hβ", "Y_F", "S_H", "S_F"):
                self.assertRegex(factors, rf" {symbol} +\d")
            self.assertRegex(factors, r"^\s*" + r"\s+".join(name.split("_")) + r"\s*\n")
        self.assertIn("The rating uses K_γ = 1 (the default)", " ".join(out.split()))
        given = Run("rate", SET + rating + "mesh_load_factor = 1.1\n").out
        self.assertNotIn("(the default), as if the planets", " ".join(given.split()))

    def test_circular_arcs_have_a_backlash(self):
        """The headline of a drive whose teeth are circular arcs states their backlash along the normal, as that of
        the pair does."""
        arcs = tomllib.loads((SOURCE / "examples/circular_arc_drive.toml").read_text())
        gears = [{key: value for key, value in arcs[f"gear{i}"].items() if key != "bore"} for i in (1, 2)]
        for distance in (696.9, 696.8444):
            train = {"stage": [{"gears": gears, "center_distance_mm": distance}]}
            answer = Run("drive", json.dumps(train), "--json", name="drive.json").json
            self.assertEqual(answer["drive"]["coaxial"] or {}, {})
            self.assertNotEqual(answer["verdict"]["level"], "red", answer["verdict"]["headline"])
            mesh = {"name": "m", "gears": ["p", "w"], "center_distance_mm": distance}
            drive = {"fixed": [], "input": "in", "output": "out", "body": [{"name": "in"}, {"name": "out"}],
                     "gear": [{"name": "p", "body": "in", **gears[0]},
                              {"name": "w", "body": "out", **gears[1]}],
                     "mesh": [mesh]}
            answer = Run("drive", json.dumps({"drive": drive}), "--json", name="drive.json").json
            pair = Run("pair", json.dumps({"gear1": gears[0], "gear2": gears[1],
                                           "pair": {"center_distance_mm": distance}}), "--json",
                       name="pair.json").json["pair"]
            normal = pair["backlash"]["normal_mm"]
            said = f"The least backlash is {normal:.4f} mm." if normal >= 5e-5 else "There is no backlash in the mesh m."
            self.assertIn(said, answer["verdict"]["headline"])

    def test_a_mesh_of_circular_arcs_has_its_section_in_the_report(self):
        arcs = tomllib.loads((SOURCE / "examples/circular_arc_drive.toml").read_text())
        gears = [{key: value for key, value in arcs[f"gear{i}"].items() if key != "bore"} for i in (1, 2)]
        made = Run("run", json.dumps({"stage": [{"gears": gears}]}), "--out", "o", "--only", "result,report", "--json",
                   name="drive.json")
        self.assertEqual(made.status, 0, made.err)
        page = (made.folder / "o/report.html").read_text()
        (name,) = made.json["drive"]["meshes"]
        self.assertTrue(re.search(f">Mesh {name}</h2>", page))
        self.assertTrue('id="mesh1-contact1"' in page)

    def test_verbs_for_pairs_name_the_way_to_a_mesh(self):
        run = Run("contact", SET)
        self.assertEqual(run.status, 1)
        self.assertIn("--take 1", run.err)

    def test_a_mesh_that_is_not_there(self):
        run = Run("drive", SET, "--take", "3")
        self.assertEqual(run.status, 1)
        self.assertIn("must be 1 to 2", run.err)


GEAR = "teeth = {}, normal_module_mm = 2, helix_angle_deg = {}, face_width_mm = 50"
HALVES = ", double_helical = { gap_mm = 10 }"
STAGE = "[[stage]]\ngears = [{{ {}{} }}, {{ {}{} }}]\nspeed_rpm = 1500\ntorque_Nm = 60\n"


class DoubleHelical(unittest.TestCase):
    """A half of a double-helical gear is a helical gear with its own face width under half of the torque."""

    def stage(self, pinion=HALVES, wheel=HALVES):
        return STAGE.format(GEAR.format(21, 25), pinion, GEAR.format(64, -25), wheel)

    def test_a_mesh_has_the_numbers_of_one_half(self):
        both = Run("drive", self.stage(), "--json")
        self.assertEqual(both.status, 0, both.err)
        one = Run("drive", self.stage("", "").replace("= 50", "= 20"), "--json")
        pairs = [next(iter(run.json["drive"]["meshes"].values()))["pair"] for run in (both, one)]
        self.assertEqual(pairs[0]["overlap_ratio"], pairs[1]["overlap_ratio"])
        whole, face = [pair.pop("needed_face_width_mm") for pair in pairs]
        self.assertAlmostEqual(whole["whole_overlap_1"], 2 * face["overlap_1"] + 10, 9)
        self.assertEqual(*pairs)
        pair = Run("pair", Run("drive", self.stage(), "--take", "1").out, "--json").json["pair"]
        self.assertEqual(pair["overlap_ratio"], pairs[0]["overlap_ratio"])

    def test_a_gap_that_leaves_no_face_is_named(self):
        run = Run("drive", self.stage(HALVES.replace("10", "49.99999"), HALVES.replace("10", "49.99999")), "--json")
        for words in ("beside the gap of 49.99999 mm, each half has face_width_mm = 5e-06", "between 0.002 mm"):
            self.assertIn(words, run.json["verdict"]["headline"])

    def test_the_halves_share_the_load(self):
        rating = "[rating]\nquality = 6\nface_load_factor = 1.2\nmaterial = \"16MnCr5\"\n"
        both = Run("rate", self.stage() + rating, "--json")
        self.assertEqual(both.status, 0, both.err)
        one = Run("rate", self.stage("", "").replace("= 50", "= 20").replace("= 60", "= 30") + rating, "--json")
        safeties = [next(iter(run.json["drive"]["meshes"].values()))["rating"] for run in (both, one)]
        for key in ("S_H", "S_F"):
            self.assertEqual(safeties[0][key], safeties[1][key])
        mounted = rating.replace("face_load_factor = 1.2\n", "") + ("[rating.mounting]\nbearing_span_mm = 300\n"
                                                                    "shaft_diameter_mm = 60\n")
        run = Run("rate", self.stage() + mounted)
        self.assertEqual(run.status, 1)
        self.assertIn("rating.face_load_factor", run.err)

    def test_the_spec_of_a_mesh_runs(self):
        stage = self.stage() + "[errors]\nintersecting_deg = 0.01\ncrossing_deg = 0.004\n[contact]\npositions = 256\n"
        spec = Run("drive", stage, "--take", "1").out
        for table in ("[load]", "[errors]", "[gear2.double_helical]"):
            self.assertIn(table, spec)
        # The transmission error of the drive is computed for the whole gears, not for one half. The input
        # turns counter-clockwise, so the spec describes the gears as seen from the other face.
        self.assertIn("as seen from the other face", " ".join(spec.replace("\n# ", " ").split()))
        drive = Run("drive", stage, "--json").json["drive"]["transmission_error"]["output_arcsec_peak_to_peak"]
        contact = Run("contact", spec, "--json").json["contact"]
        askew = stage.replace("crossing_deg = 0.004", "crossing_deg = 0.1")
        self.assertIn("edge_contact", [f["code"] for f in Run("drive", askew, "--json").json["verdict"]["findings"]])
        self.assertAlmostEqual(drive, contact["peak_to_peak_arcsec"], 8)
        for half in contact["halves"]:
            self.assertGreater(half["peak_to_peak_arcsec"], 1.1 * drive)
        draft = spec.replace("[load]\n", '[load]\naccuracy = "draft"\npositions = 4\n').replace("positions = 256", "positions = 8")
        run = Run("run", draft, "--only", "result,report", "--out", "o")
        self.assertEqual(run.status, 0, run.err)

    def test_the_files_have_both_halves(self):
        run = Run("run", self.stage(), "--out", "o", "--json")
        self.assertEqual(run.status, 0, run.err)
        step = (run.folder / "o/drive.step").read_text()
        self.assertEqual(step.count("MANIFOLD_SOLID_BREP"), 2)
        expanded = Run("drive", self.stage(), "--expand").out
        self.assertEqual(expanded.count("double_helical"), 2)
        again = Run("drive", expanded, "--json").json["drive"]["meshes"]
        self.assertEqual(again, Run("drive", self.stage(), "--json").json["drive"]["meshes"])

    def test_halves_that_do_not_mesh_are_errors(self):
        lift = LIFT.replace("helix_angle_deg = 10", "helix_angle_deg = 10, face_width_mm = 50" + HALVES)
        for spec, *words in (
                (SET + "double_helical = { gap_mm = 5 }\n", "planetary.double_helical", "--expand"),
                ("[[stage]]\nteeth = [19, 58]\nnormal_module_mm = 2\ndouble_helical = { gap_mm = 5 }\n",
                 "stage[1].double_helical", "gears = ["),
                (self.stage(HALVES.replace("10", "50")), "stage[1].gears[1].double_helical.gap_mm = 50: ",
                 "less than the face width 50"),
                ("face_width_mm = 30".join(self.stage(HALVES, HALVES.replace("10", "4")).rsplit("face_width_mm = 50", 1)),
                 "stage[1].gears[2].double_helical.gap_mm = 4: ", "not opposite each other"),
                (self.stage(HALVES.replace("}", ", stagger_pitches = 0.5 }")),
                 "stage[1].gears[1].double_helical.stagger_pitches = 0.5: ", "staggered halves"),
                (self.stage(HALVES.replace("}", ", groove_diameter_mm = 43 }")),
                 "stage[1].gears[1].double_helical.groove_diameter_mm = 43: ", "less than the root diameter"),
                (Run("drive", self.stage(), "--expand").out.replace("gap_mm = 10", "gap_mm = 10\nhob_diameter_mm = 5", 1),
                 "drive.gear[1].double_helical.hob_diameter_mm = 5: ", "twice the depth of the teeth"),
                ('units = "inch"\n' + self.stage(HALVES.replace("10", "60")).replace("_mm", "_in").replace("module_in", "module_mm"),
                 "stage[1].gears[1].double_helical.gap_in = 60: ", "less than the face width 50 in"),
                (self.stage().replace(", face_width_mm = 50", ""), "stage[1].gears[1].face_width_mm"),
                (self.stage().replace(", helix_angle_deg = 25", "").replace(", helix_angle_deg = -25", ""), "helix_angle"),
                (lift, "the pinion of this mesh is double-helical")):
            run = Run("drive", spec)
            self.assertEqual(run.status, 1, spec)
            for word in words:
                self.assertIn(word, run.err)

    def test_a_bore_of_a_drive_is_in_its_files_and_its_verdict(self):
        bore = ", bore = { diameter_mm = %s }"
        good = Run("drive", self.stage(HALVES + bore % 20), "--json")
        self.assertNotEqual(good.json["verdict"]["level"], "red", good.json["verdict"]["headline"])
        meshed = Run("export", self.stage(HALVES + bore % 20), "--stl", "a.stl")
        self.assertEqual(meshed.status, 0, meshed.err)
        solid = Run("export", self.stage(), "--stl", "a.stl")
        self.assertGreater((meshed.folder / "a.stl").stat().st_size, (solid.folder / "a.stl").stat().st_size)
        wide = Run("drive", self.stage(HALVES + bore % 41), "--json")
        self.assertEqual(wide.json["verdict"]["level"], "red")
        self.assertIn("bore", wide.json["verdict"]["headline"])


if __name__ == "__main__":
    unittest.main()
