"""Tests run and export on drives: every example is green and has its files, and errors of drives
contain a remedy."""
import json
import math
import re
import unittest
import zipfile

from cli import SOURCE, Run

EXAMPLES = sorted((SOURCE / "examples" / "drives").glob("*.toml"))
SET = """
[planetary]
sun = 20
planet = 25
ring = 70
planets = 3
normal_module_mm = 2
"""


class Examples(unittest.TestCase):
    def test_every_example_is_green_and_whole(self):
        self.assertGreaterEqual(len(EXAMPLES), 6)
        for example in EXAMPLES:
            with self.subTest(example=example.name):
                text = example.read_text()
                self.assertIn("examples/drives/" + example.name, text)
                r = Run("run", text, "--out", "o", "--json", name=example.name)
                self.assertEqual(r.status, 0, r.err)
                self.assertEqual(r.json["verdict"]["level"], "green", r.json["verdict"]["headline"])
                names = {f["file"] for f in r.json["files"]}
                self.assertLessEqual({"result.json", "report.html", "drive.step", "drive.glb", "drive.3mf"},
                                     {name.rsplit("/", 1)[-1] for name in names})
                page = (r.folder / "o/report.html").read_text()
                ids = re.findall(r' id="([^"]*)"', page)
                self.assertEqual(len(ids), len(set(ids)), "names of pictures are unique")
                for used in re.findall(r'href="#([^"]*)"|url\(#([^)]*)\)', page):
                    self.assertIn(used[0] or used[1], ids)
                self.assertIn("window.figureZoom =", page, "the script of the page calls it")
                self.assertIn('id="scheme"', page)
                self.assertIn('id="power"', page)
                self.assertIn('id="section-1"', page)
                self.assertNotIn("nan", re.sub(r"<[^>]*>", "", page).lower().split())


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

    def test_a_mesh_carries_its_torque(self):
        """Three planets share the torque of the sun, and the ring's mesh has the same tooth force as the sun's."""
        sun = Run("drive", SET + "torque_Nm = 60\n", "--take", "1").out
        ring = Run("drive", SET + "torque_Nm = 60\n", "--take", "2").out
        torque = [float(re.search(r"torque_Nm = (\S+)", spec).group(1)) for spec in (sun, ring)]
        self.assertAlmostEqual(torque[0], 20, 9)
        self.assertAlmostEqual(torque[1], 20 * 25 / 20, 0)  # less the loss of the first mesh
        self.assertEqual(Run("load", sun, "--json").status, 0)

    def test_a_mesh_without_load_has_no_torque(self):
        text = (SOURCE / "examples/drives/ravigneaux.toml").read_text()
        loads = ["[load]" in Run("drive", text, "--take", str(n)).out for n in (1, 2, 3, 4)]
        self.assertEqual(loads, [True, True, False, True])
        still = Run("drive", SET + "torque_Nm = 0\n", "--take", "1")
        self.assertEqual(still.status, 0, still.err)
        self.assertNotIn("[load]", still.out)

    def test_the_head_of_a_mesh_gives_faults_of_the_drive(self):
        """A Wolfrom set with a high ratio locks itself backwards; with its ring driving it locks."""
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
        self.assertIn("locks itself", " ".join(head))
        thick = SET + "thickness_allowance_mm = 0.4\n"
        self.assertEqual(Run("drive", thick, "--json").json["verdict"]["level"], "red")
        spec = Run("drive", thick, "--take", "1")
        self.assertIn("does not run as specified", spec.out.split("title")[0].replace("\n# ", " "))
        self.assertIn("does not run as specified", Run("drive", thick, "--take", "1", "--json").err)
        self.assertEqual(Run("drive", SET, "--take", "1", "--json").err, "")
        self.assertTrue(all(line.startswith("# ") and len(line) <= 80 for line in spec.out.split("title")[0].splitlines()))

    def test_a_mesh_carries_its_rating(self):
        """The safeties of a mesh are those of the drive; of the gear with the fewer engagements they are lower."""
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

    def test_a_rack_is_gear_2(self):
        drive = """
[drive]
fixed = ["frame"]
input = "pinion"
output = "bar"
body = [{ name = "frame" }, { name = "pinion" }, { name = "bar" }]
gear = [{ name = "r", body = "bar", form = "rack", teeth = 20 }, { name = "p", body = "pinion", teeth = 17, normal_module_mm = 2 }]
mesh = [{ gears = ["r", "p"] }]
"""
        spec = Run("drive", drive, "--take", "1")
        self.assertEqual(spec.status, 0, spec.err)
        pair = Run("pair", spec.out, "--json")
        self.assertEqual(pair.status, 0, pair.err)
        self.assertEqual(pair.json["pair"]["kind"], "rack_and_pinion")

    LIFT = """
[drive]
input = "shaft"
output = "bar"
speed_rpm = 60
torque_Nm = 10
body = [{ name = "shaft" }, { name = "bar" }]
gear = [{ name = "p", body = "shaft", teeth = 20, normal_module_mm = 2, helix_angle_deg = 10 },
        { name = "r", body = "bar", form = "rack", teeth = 30, height_mm = 18, normal_module_mm = 2 }]
mesh = [{ gears = ["p", "r"], efficiency = 0.98 }]
"""

    def test_a_rack_moves(self):
        """In a turn per second the rack moves by the pitch circle of its pinion, and its force has the arm of d/2."""
        drive = Run("drive", self.LIFT, "--json").json
        d = 20 * 2 / math.cos(math.radians(10))
        bar = drive["drive"]["bodies"]["bar"]
        self.assertAlmostEqual(bar["speed_m_per_s"], math.pi * d / 1000, 12)
        self.assertAlmostEqual(abs(bar["force_N"]), 0.98 * 10 / (d / 2000), 9)
        self.assertAlmostEqual(bar["power_kW"] * 1000, bar["force_N"] * bar["speed_m_per_s"], 9)
        self.assertEqual([bar[key] for key in ("speed_rpm", "torque_Nm")], [None, None])
        shaft = drive["drive"]["bodies"]["shaft"]
        self.assertEqual([shaft[key] for key in ("speed_m_per_s", "force_N")], [None, None])
        self.assertIn("Meshes with a rack are not checked", drive["verdict"]["headline"])
        text = Run("drive", self.LIFT).out
        for words in ("0.1276 m/s", "482.56 N", "pitches per turn"):
            self.assertIn(words, text)
        page = (Run("run", self.LIFT, "--out", "o").folder / "o/report.html").read_text()
        self.assertTrue("Speed of the rack" in page and ">0.1276<" in page)

    def test_the_height_of_a_rack_reaches_its_pair(self):
        pair = Run("pair", Run("drive", self.LIFT, "--take", "1").out, "--json")
        self.assertEqual(pair.status, 0, pair.err)
        self.assertAlmostEqual(pair.json["pair"]["mounting_distance_mm"], pair.json["pair"]["center_distance_mm"] + 18, 9)
        for height, word in (("height_mm = -1", "greater than 0"), ("form = \"gear\", teeth = 30, height_mm = 18", "form")):
            run = Run("drive", self.LIFT.replace('form = "rack", teeth = 30, height_mm = 18',
                                                 height if "form" in height else 'form = "rack", ' + height + ", teeth = 30"))
            self.assertEqual(run.status, 1)
            for words in ("drive.gear[2].height_mm", word):
                self.assertIn(words, run.err)

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
    """A half of a double-helical gear is a helical gear of its own face under half of the torque."""

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
        stage = self.stage() + "[errors]\nintersecting_deg = 0.01\ncrossing_deg = 0.004\n"
        spec = Run("drive", stage, "--take", "1").out
        for table in ("[load]", "[errors]", "[gear2.double_helical]"):
            self.assertIn(table, spec)
        # The transmission error of the drive is that of the whole gears, and not of a half.
        # The input turns counter-clockwise, so the flanks that work are the other ones of `contact`.
        drive = Run("drive", stage, "--json").json["drive"]["transmission_error"]["output_arcsec_peak_to_peak"]
        contact = Run("contact", spec, "--json").json["contact"]
        self.assertAlmostEqual(drive, contact["non_working_flank"]["peak_to_peak_arcsec"], 8)
        for half in contact["halves"]:
            self.assertGreater(half["non_working_flank"]["peak_to_peak_arcsec"], 1.1 * drive)
        run = Run("run", spec, "--out", "o")
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
        lift = Meshes.LIFT.replace("helix_angle_deg = 10", "helix_angle_deg = 10, face_width_mm = 50" + HALVES)
        for spec, *words in (
                (SET + "double_helical = { gap_mm = 5 }\n", "planetary.double_helical", "--expand"),
                ("[[stage]]\nteeth = [19, 58]\nnormal_module_mm = 2\ndouble_helical = { gap_mm = 5 }\n",
                 "stage[1].double_helical", "gears = ["),
                (self.stage(HALVES.replace("10", "50")), "less than the face width 50"),
                (self.stage(HALVES.replace("}", ", stagger_pitches = 0.5 }")), "staggered halves"),
                (self.stage().replace(", face_width_mm = 50", ""), "stage[1].gears[1].face_width_mm"),
                (self.stage().replace(", helix_angle_deg = 25", "").replace(", helix_angle_deg = -25", ""), "helix_angle"),
                (lift, "its pinion is double-helical")):
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


class Stages(unittest.TestCase):
    def test_keys_that_a_stage_does_not_have_lead_to_their_place(self):
        two = "[[stage]]\nteeth = [19, 58]\n[[stage]]\nteeth = [17, 61]\n"
        for spec, *words in ((two + "speed_rpm = 1000\n", "stage.speed_rpm = 1000", "first stage"),
                             (two + "torque_Nm = 5\n", "stage.torque_Nm = 5", "stage 2"),
                             ('[[stage]]\ngears = [{ teeth = 20, normal_module_mm = 3 }, { form = "rack" }]\n',
                              "stage[1].gears[2].form", "[[drive.gear]]")):
            run = Run("drive", spec)
            self.assertEqual(run.status, 1)
            for word in words:
                self.assertIn(word, run.err)


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = Run("run", SET, "--out", "o", "--json")

    def file(self, name):
        return self.made.folder / "o" / name

    def test_planets_are_copies_of_one_shape_in_places_of_their_own(self):
        step = self.file("drive.step").read_text()
        self.assertEqual(step.count("MANIFOLD_SOLID_BREP"), 3)
        for name in ("sun", "planet 1", "planet 2", "planet 3", "ring"):
            self.assertIn(f"'{name}'", step)
        self.assertEqual(step.count("NEXT_ASSEMBLY_USAGE_OCCURRENCE"), 5)
        data = self.file("drive.glb").read_bytes()
        length = int.from_bytes(data[12:16], "little")
        scene = json.loads(data[20:20 + length])
        self.assertEqual([n["name"] for n in scene["nodes"]], ["sun", "planet 1", "planet 2", "planet 3", "ring"])
        self.assertEqual([n["mesh"] for n in scene["nodes"]], [0, 1, 1, 1, 2])
        self.assertEqual(len(scene["meshes"]), 3)
        # Planet 2 is at a third of a turn about the sun, at the centre distance of 45 mm.
        at = scene["nodes"][2]["matrix"][12:15]
        self.assertAlmostEqual(at[0], -0.0225, places=9)
        self.assertAlmostEqual(at[1], 0.045 * 3 ** 0.5 / 2, places=9)

    def test_parts_for_a_printer_stand_on_the_plate_and_apart(self):
        with zipfile.ZipFile(self.file("drive.3mf")) as z:
            model = z.read("3D/3dmodel.model").decode()
        items = [list(map(float, t.split())) for t in re.findall(r'<item [^>]*transform="([^"]*)"', model)]
        self.assertEqual(len(items), 5)
        self.assertEqual({t[11] for t in items}, {10.0})  # half a face of 20 mm
        tips = [22.0, 27.0, 27.0, 27.0, 77.5]
        for i, a in enumerate(items):
            for k in range(i):
                b = items[k]
                self.assertGreater(((a[9] - b[9]) ** 2 + (a[10] - b[10]) ** 2) ** 0.5, tips[i] + tips[k])

    def test_export_writes_the_named_files(self):
        r = Run("export", SET, "--step", "s.step", "--3mf", "p.3mf", "--json")
        self.assertEqual(r.status, 0, r.err)
        step = (r.folder / "s.step").read_text()
        self.assertEqual(len(step.splitlines()), len(self.file("drive.step").read_text().splitlines()))
        self.assertEqual(len(r.json["files"]), 2)

    def test_without_a_module_there_is_a_report_and_no_solid(self):
        r = Run("run", SET.replace("normal_module_mm = 2\n", ""), "--out", "o", "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual({f["file"].rsplit("/", 1)[-1] for f in r.json["files"]}, {"result.json", "report.html"})
        page = (r.folder / "o/report.html").read_text()
        self.assertIn('id="scheme"', page)
        self.assertNotIn('id="section-1"', page)

    def test_run_judges_the_safeties_as_rate_does(self):
        weak = SET + ("torque_Nm = 400\nspeed_rpm = 100\nmaterial = \"42CrMo4\"\n"
                      "[rating]\nquality = 6\nface_load_factor = 1.2\n")
        rated = Run("rate", weak, "--json")
        made = Run("run", weak, "--out", "o", "--json")
        self.assertEqual(made.json["verdict"], rated.json["verdict"])
        self.assertEqual(made.json["verdict"]["level"], "red")
        for mesh in ("sun_planet", "planet_ring"):
            self.assertEqual(made.json["drive"]["meshes"][mesh]["rating"], rated.json["drive"]["meshes"][mesh]["rating"])
        self.assertIn(">Strength</h2>", (made.folder / "o/report.html").read_text())

    def test_the_headline_names_the_least_safeties(self):
        light = SET + ("torque_Nm = 10\nspeed_rpm = 100\nmaterial = \"42CrMo4\"\nthickness_allowance_mm = -0.05\n"
                       "[rating]\nquality = 6\nface_load_factor = 1.2\n")
        answer = Run("rate", light, "--json").json
        self.assertEqual(answer["verdict"]["level"], "green", answer["verdict"])
        ratings = [mesh["rating"] for mesh in answer["drive"]["meshes"].values()]
        flank, root = (min(s for r in ratings for s in r[key]) for key in ("S_H", "S_F"))
        self.assertIn(f"The least safety against pitting is {flank:.2f}, against root breakage {root:.2f}.",
                      answer["verdict"]["headline"])

    def test_two_torques_that_differ(self):
        spec = SET + "torque_Nm = 30\nspeed_rpm = 100\nmaterial = \"42CrMo4\"\n[rating]\nquality = 6\nface_load_factor = 1.2\n"
        refused = Run("rate", spec + "torque_Nm = 40\n", "--json")
        self.assertEqual((refused.status, refused.json["error"]["key"]), (1, "rating.torque_Nm"), refused.err)
        self.assertIn("30 N m", refused.json["error"]["message"])
        same = Run("rate", spec + "torque_Nm = 30\n", "--json")
        self.assertEqual(same.json["drive"], Run("rate", spec, "--json").json["drive"])

    def test_a_red_drive_has_a_remedy_that_helps(self):
        red = SET + "profile_shift = { sun = 0.2, planet = 0.1 }\ntip_diameter_mm = { ring = 137.6 }\n"
        r = Run("drive", red, "--json")
        verdict = r.json["verdict"]
        self.assertEqual(verdict["level"], "red")
        change = verdict["findings"][0]["change"]
        self.assertEqual(list(change), ["planetary.tip_diameter_mm.ring"])
        value = change["planetary.tip_diameter_mm.ring"]
        again = Run("drive", red.replace("137.6", str(value)), "--json")
        self.assertNotEqual(again.json["verdict"]["level"], "red")


class BadInput(unittest.TestCase):
    def error(self, spec, key, *words):
        r = Run("drive", spec)
        self.assertEqual(r.status, 1, r.out)
        for word in (key, *words):
            self.assertIn(word, r.err)

    def test_impossible_assemblies_name_teeth_and_numbers_of_planets(self):
        self.error(SET.replace("planets = 3", 'planets = 4\nspacing = "equal"'), "planetary.spacing",
                   "sun 18 or 22", "ring 68 or 72", "3 or 5 planets")

    def test_a_ring_that_is_no_ring(self):
        self.error(SET.replace("ring = 70", "ring = 24"), "planetary.ring", "more teeth than planet = 25")
        self.error(SET.replace("ring = 70", "ring = 25"), "planetary.ring", "more teeth than planet = 25")
        self.error(SET.replace("ring = 70\n", ""), "planetary.ring", "a second sun")

    def test_unknown_members(self):
        self.error(SET + "profile_shift = { suun = 0.1 }\n", "planetary.profile_shift.suun", "sun, sun2")
        self.error(SET + 'output = "carier"\n', "planetary.output", "carrier")

    def test_an_output_that_stands_still(self):
        self.error("[planetary]\nplanet = 20\nring = 60\nring2 = 60\nplanets = 3\n"
                   'input = "carrier"\noutput = "ring2"\n', "planetary.output", "does not rotate")

    def test_loops_whose_ratios_disagree_name_their_meshes(self):
        bodies = "".join(f'[[drive.body]]\nname = "{b}"\n' for b in "abc")
        gears = "".join(f'[[drive.gear]]\nname = "{n}"\nbody = "{n[0]}"\nteeth = {z}\n'
                        for n, z in (("a1", 20), ("b1", 30), ("c1", 40), ("c2", 41), ("b2", 33)))
        meshes = "".join(f'[[drive.mesh]]\ngears = ["{a}", "{b}"]\n'
                         for a, b in (("a1", "b1"), ("b1", "c1"), ("b2", "c2")))
        self.error('[drive]\ninput = "a"\noutput = "c"\n' + bodies + gears + meshes, "drive.fixed", "b1_c1, b2_c2")

    def fact(self, spec, code, *words):
        r = Run("drive", spec, "--json")
        self.assertEqual(r.status, 0, r.err)
        worst = r.json["verdict"]["findings"][0]
        self.assertEqual((worst["code"], worst["level"]), (code, "red"))
        for word in words:
            self.assertIn(word, worst["message"])

    def test_planets_that_collide(self):
        self.fact("[planetary]\nsun = 14\nplanet = 40\nring = 94\nplanets = 4\nnormal_module_mm = 1\n",
                  "planets_collide", "at most 3 fit")

    def test_distances_that_no_shift_reaches(self):
        self.fact(SET + "center_distance_mm = 30\n", "not_coaxial", "reference centre distance: 45 mm")
        self.fact(SET + "center_distance_mm = 60\n", "not_coaxial", "sun_planet", "60.0000 mm", "profile shifts of")


if __name__ == "__main__":
    unittest.main()
