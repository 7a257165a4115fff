"""Tests the verbs run and export for drives. Every example is green and has its files. Errors contain a
remedy."""
import json
import re
import struct
import tomllib
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


def scene_of(glb):
    """The JSON part of a GLB file."""
    return json.loads(glb[20:20 + int.from_bytes(glb[12:16], "little")])


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
                self.assertEqual(len(ids), len(set(ids)), "ids in the page must be unique")
                for used in re.findall(r'href="#([^"]*)"|url\(#([^)]*)\)', page):
                    self.assertIn(used[0] or used[1], ids)
                self.assertIn("window.figureZoom =", page, "the script of the page must call figureZoom")
                self.assertIn('id="scheme"', page)
                self.assertIn('id="power"', page)
                self.assertIn('id="section-1"', page)
                self.assertNotIn("nan", re.sub(r"<[^>]*>", "", page).lower().split())


class Stages(unittest.TestCase):
    def test_keys_that_a_stage_does_not_have_lead_to_their_place(self):
        two = "[[stage]]\nteeth = [19, 58]\n[[stage]]\nteeth = [17, 61]\n"
        for spec, *words in ((two + "speed_rpm = 1000\n", "stage[2].speed_rpm = 1000", "first stage"),
                             (two + "torque_Nm = 5\n", "stage[2].torque_Nm = 5", "stage 2"),
                             ('[[stage]]\ngears = [{ teeth = 20, normal_module_mm = 3 }, { form = "rack" }]\n',
                              "stage[1].gears[2].form", "[[drive.gear]]"),
                             (two + "output_torque_Nm = 80\n", "stage[2].output_torque_Nm", "T_out/(i η)"),
                             ("[planetary]\nsun = 18\ntorque_output_Nm = 80\n", "planetary.torque_output_Nm", "T_out/(i η)")):
            run = Run("drive", spec)
            self.assertEqual(run.status, 1)
            for word in words:
                self.assertIn(word, run.err)

    def test_two_speeds_of_one_input_contradict_each_other(self):
        """The rating of a drive and the rating of a pair reject a speed that differs from that of the input or of gear 1."""
        rating = ('[rating]\ntorque_Nm = 80\nlife_h = 10000\nquality = 6\nface_load_factor = 1.2\n'
                  'material = "16MnCr5"\nspeed_rpm = ')
        pair = "[gear1]\nteeth = 20\nnormal_module_mm = 3\n[gear2]\nteeth = 50\n[pair]\nspeed_rpm = 450\n" + rating
        drive = "[[stage]]\nteeth = [20, 50]\nnormal_module_mm = 3\nspeed_rpm = -450\n" + rating
        for spec in (pair, drive):
            self.assertEqual(Run("rate", spec + "450\n").status, 0)
            wrong = Run("rate", spec + "300\n")
            self.assertEqual(wrong.status, 1)
            for words in ("rating.speed_rpm = 300", "contradicts", "450"):
                self.assertIn(words, wrong.err)

    def test_a_power_that_contradicts_the_torque_is_named(self):
        """Regression: the error named torque_Nm, which the spec did not contain."""
        spec = ("[[stage]]\nteeth = [20, 50]\nnormal_module_mm = 3\nspeed_rpm = 450\ntorque_Nm = 80\n"
                '[rating]\npower_kW = 5\nspeed_rpm = 450\nmaterial = "16MnCr5"\n')
        run = Run("rate", spec)
        self.assertEqual(run.status, 1)
        # Oracle: T = P/ω = 5000/(2π 450/60)
        for words in ("rating.power_kW = 5: ", "106.103 N m at 450 1/min", "80 N m"):
            self.assertIn(words, run.err)


class PlaneSections(unittest.TestCase):
    def test_every_angle_of_a_planet_has_a_plane_section(self):
        for sun, planet, ring, count, distance in ((19, 17, 56, 3, "38.3556"), (21, 37, 95, 4, "58"),
                                                   (22, 35, 92, 3, "57"), (25, 23, 71, 3, "48")):
            with self.subTest(sun=sun, planet=planet, ring=ring):
                spec = f"[planetary]\nsun = {sun}\nplanet = {planet}\nring = {ring}\nplanets = {count}\n"
                spec += f"normal_module_mm = 2\ncenter_distance_mm = {distance}\n"
                r = Run("export", spec, "--svg", "set.svg")
                self.assertEqual(r.status, 0, r.err)


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
        scene = scene_of(self.file("drive.glb").read_bytes())
        self.assertEqual([n["name"] for n in scene["nodes"]], ["sun", "planet 1", "planet 2", "planet 3", "ring"])
        self.assertEqual([n["mesh"] for n in scene["nodes"]], [0, 1, 1, 1, 2])
        self.assertEqual(len(scene["meshes"]), 3)
        # Planet 2 has turned by a third of a turn about the sun. The centre distance is 45 mm.
        at = scene["nodes"][2]["matrix"][12:15]
        self.assertAlmostEqual(at[0], -0.0225, places=9)
        self.assertAlmostEqual(at[1], 0.045 * 3 ** 0.5 / 2, places=9)

    def test_parts_for_a_printer_stand_on_the_plate_and_apart(self):
        with zipfile.ZipFile(self.file("drive.3mf")) as z:
            model = z.read("3D/3dmodel.model").decode()
        items = [list(map(float, t.split())) for t in re.findall(r'<item [^>]*transform="([^"]*)"', model)]
        self.assertEqual(len(items), 5)
        self.assertEqual({t[11] for t in items}, {10.0})  # half of the face width of 20 mm
        tips = [22.0, 27.0, 27.0, 27.0, 77.5]
        for i, a in enumerate(items):
            for k in range(i):
                b = items[k]
                self.assertGreater(((a[9] - b[9]) ** 2 + (a[10] - b[10]) ** 2) ** 0.5, tips[i] + tips[k])

    def test_a_part_has_its_own_file(self):
        """The mesh of a planet alone has as many triangles as the same gear of the pair, and the
        same size, and lies on z = 0."""
        part = Run("export", SET, "--gear", "planet", "--stl", "p.stl", "--3mf", "p.3mf", "--dxf", "p.dxf")
        self.assertEqual(part.status, 0, part.err)
        pair = Run("drive", SET, "--take", "1")
        alone = Run("export", pair.out, "--gear", "2", "--stl", "p.stl")
        planet, gear = ((run.folder / "p.stl").read_bytes() for run in (part, alone))
        self.assertEqual(len(planet), len(gear))
        def bounds(stl):
            points = [struct.unpack_from("<9f", stl, at + 12) for at in range(84, len(stl), 50)]
            axes = [[p[i + k] for p in points for i in (0, 3, 6)] for k in range(3)]
            return [max(a) - min(a) for a in axes], min(axes[2])
        (size, low), (same, _) = bounds(planet), bounds(gear)
        self.assertAlmostEqual(low, 0, 5)
        for a, b in zip(size, same):
            self.assertAlmostEqual(a, b, delta=0.05)  # the tooth that is at the top may differ
        for name, words in (("moon", "its parts are sun, planet and ring"), ("1", "is not a part of the drive")):
            run = Run("export", SET, "--gear", name, "--stl", "p.stl")
            self.assertEqual(run.status, 1)
            self.assertIn(words, " ".join(run.err.split()))
        self.assertEqual(Run("export", pair.out, "--gear", "planet", "--stl", "p.stl").status, 2)

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
        self.assertIn(f"The lowest safety factor is {flank:.2f} against pitting and {root:.2f} against root breakage.",
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
                   "sun 18 or 22", "ring 68 or 72", "; 3 planets; ")

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
                  "planets_collide", "At most 3 copies fit")

    def test_distances_that_no_shift_reaches(self):
        self.fact(SET + "center_distance_mm = 30\n", "not_coaxial", "the reference centre distance is 45 mm")
        self.fact(SET + "center_distance_mm = 60\n", "not_coaxial", "sun_planet", "60.0000 mm", "profile shifts of",
                  "A centre distance from 44.")

    def test_rings_that_do_not_fit_name_those_that_do(self):
        for ring in (30, 76):
            self.fact(SET.replace("ring = 70", f"ring = {ring}"), "not_coaxial",
                      "ring must be close to sun + 2 planet = 70; ring = 66 to 72 is possible.")
        for ring in (66, 72):
            r = Run("drive", SET.replace("ring = 70", f"ring = {ring}"), "--json")
            self.assertNotEqual(r.json["verdict"]["level"], "red")

    def test_bores_by_member_are_those_of_the_graph(self):
        """The files of a set with bores are those of its [drive], in which each gear has the table bore."""
        stage = '[[stage]]\nteeth = [20, 61]\nnormal_module_mm = 2\nbore_mm = [12, 20]\n'
        ring = '[[stage]]\nteeth = [20, -61]\nnormal_module_mm = 2\nbore_mm = 12\n'
        for spec, bores in ((SET + "bore_mm = { sun = 12, planet = 8, ring = 165 }\n", [12, 8, 165]),
                            (SET + "bore_mm = 10\n", [10, 10, None]), (stage, [12, 20]), (ring, [12, None]),
                            ("[[stage]]\nnormal_module_mm = 2\nbore_mm = { sun = 9 }\nplanetary = { sun = 20, "
                             "planet = 25, ring = 70, planets = 3 }\n", [9, None, None])):
            graph = Run("drive", spec, "--expand")
            gears = tomllib.loads(graph.out)["drive"]["gear"]
            self.assertEqual([g.get("bore", {}).get("diameter_mm") for g in gears], bores)
            files = []
            for text in (spec, graph.out):
                r = Run("export", text, "--stl", "drive.stl")
                self.assertEqual(r.status, 0, r.err)
                files.append((r.folder / "drive.stl").read_bytes())
            self.assertEqual(files[0], files[1])
        inch = Run("drive", 'units = "inch"\n' + SET +
                   "bore_in = { sun = 0.5 }\n", "--expand")
        self.assertEqual(tomllib.loads(inch.out)["drive"]["gear"][0]["bore"]["diameter_in"], 0.5)
        self.error(SET + "bore_mm = 0\n", "planetary.bore_mm", "must be greater than 0")
        self.error(SET + "bore = 8\n", "planetary.bore", "bore_mm")

    def test_an_unknown_key_of_a_rack_is_an_error(self):
        spec = ('[drive]\ninput = "p"\noutput = "r"\n[[drive.body]]\nname = "p"\n[[drive.body]]\nname = "r"\n'
                '[[drive.gear]]\nname = "p"\nbody = "p"\nteeth = 20\nnormal_module_mm = 2\n'
                '[[drive.gear]]\nname = "r"\nbody = "r"\nform = "rack"\nteth = 30\n'
                '[[drive.mesh]]\ngears = ["p", "r"]\n')
        self.error(spec, "drive.gear[2].teth = 30", "teeth")

    def test_numbers_by_member_have_the_ranges_of_their_keys(self):
        for line, key, word in (("bore_mm = { sun = 0 }", "bore_mm.sun = 0", "greater than 0"),
                                ("mesh_efficiency = { sun_planet = 1.2 }", "mesh_efficiency.sun_planet = 1.2", "at most 1"),
                                ("tip_diameter_mm = { ring = -9 }", "tip_diameter_mm.ring = -9", "greater than 0"),
                                ("profile_shift = { sun = 1e300 }", "profile_shift.sun = 1e+300", "between -10000 and 10000"),
                                ("helix_angle_deg = 95", "helix_angle_deg = 95", "between -89 and 89"),
                                ("bore_mm = { sun = true }", "bore_mm.sun = true", "must be a number"),
                                ("thickness_allowance_mm = { sun = inf }", "thickness_allowance_mm.sun", "finite")):
            self.error(SET + line + "\n", "planetary." + key, word)
        stage = "[[stage]]\nteeth = [20, 61]\nnormal_module_mm = 2\n"
        self.error(stage + "profile_shift = [0.1, 2e4]\n", "stage[1].profile_shift", "between -10000 and 10000")
        self.error(stage + "mesh_efficiency = 0\n", "stage[1].mesh_efficiency = 0", "greater than 0")


class Solids(unittest.TestCase):
    RACK = ('[drive]\ninput = "p"\noutput = "r"\n[[drive.body]]\nname = "p"\n[[drive.body]]\nname = "r"\n'
            '[[drive.gear]]\nname = "p"\nbody = "p"\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 20\n'
            '[[drive.gear]]\nname = "r"\nbody = "r"\nform = "rack"\nteeth = 30\nheight_mm = 10\n'
            '[[drive.mesh]]\ngears = ["p", "r"]\n')

    def test_the_files_of_a_drive_contain_its_rack_in_place(self):
        """The rack has the position that it has in its pair, and its STEP file has as many faces as
        that of the pair."""
        run = Run("run", self.RACK, "--out", "o", "--json")
        self.assertEqual(run.status, 0, run.err)
        self.assertLessEqual({"drive.step", "drive.glb", "drive.3mf", "drive.dxf"},
                             {f["file"].rsplit("/", 1)[-1] for f in run.json["files"]})
        nodes = scene_of((run.folder / "o/drive.glb").read_bytes())["nodes"]
        self.assertEqual([n["name"] for n in nodes], ["p", "r"])
        at = nodes[1]["matrix"]
        distance = run.json["drive"]["meshes"]["p_r"]["rack_pair"]["center_distance_mm"]
        self.assertAlmostEqual(1000 * at[12], distance, places=9)
        # Tooth 0 of the pinion, on the x axis, is in the space in the middle of a rack of 30 teeth.
        self.assertAlmostEqual(at[13], 0, places=9)
        self.assertEqual([at[0], at[5]], [-1, -1])
        pair = Run("drive", self.RACK, "--take", "1")
        made = Run("export", pair.out, "--step", "rack.step")
        self.assertEqual(made.status, 0, made.err)
        faces = [re.search(r"(\d+) faces", f["note"]).group(1) for f in run.json["files"] if f["file"].endswith(".step")]
        self.assertIn(faces[0] + " faces", made.out)

    def test_a_rack_with_two_pinions_has_no_files(self):
        two = self.RACK + ('[[drive.body]]\nname = "q"\n[[drive.gear]]\nname = "q"\nbody = "q"\nteeth = 18\n'
                           'normal_module_mm = 2\nface_width_mm = 20\n[[drive.mesh]]\ngears = ["q", "r"]\n')
        made = Run("export", two, "--step", "rack.step")
        self.assertEqual(made.status, 1)
        self.assertIn('drive.gear = "r": is a rack with 2 pinions', made.err)

    def test_the_cylinder_between_two_gears_clears_the_gears_beside_it(self):
        """Gear g5, with a tip radius of 62 mm, is beside the shaft of g2 and g3. The angle of its
        axis determines their distance."""

        def spec(angle):
            gears = "".join(f'[[drive.gear]]\nname = "{n}"\nbody = "{b}"\nteeth = {z}\nnormal_module_mm = 2\nface_width_mm = 20\n'
                            for n, b, z in (("g1", "a", 20), ("g2", "b", 60), ("g3", "b", 60), ("g4", "d", 20), ("g5", "c", 60),
                                            ("g6", "a", 20)))
            return ('[drive]\ninput = "a"\noutput = "d"\n' + "".join(f'[[drive.body]]\nname = "{b}"\n' for b in "abcd") + gears +
                    '[[drive.mesh]]\ngears = ["g1", "g2"]\n'
                    f'[[drive.mesh]]\ngears = ["g6", "g5"]\nangle_deg = {angle}\n'
                    '[[drive.mesh]]\ngears = ["g3", "g4"]\nangle_deg = 90\n')
        # The axes of b and c are 80 mm apart at 60°. The gear needs 62 mm, and a quarter of a module stays free.
        made = Run("export", spec(60), "--step", "n.step")
        self.assertEqual(made.status, 0, made.err)
        radii = re.findall(r"CYLINDRICAL_SURFACE\('[^']*',#\d+,([0-9.]+)\)", (made.folder / "n.step").read_text())
        self.assertIn(17.5, [round(float(r), 9) for r in radii])
        made = Run("export", spec(10), "--step", "n.step")
        self.assertIn("g3 is not joined to g2, because there is no room for a shaft", " ".join(made.out.split()))

    def test_gears_of_one_body_are_one_solid(self):
        joint = (SOURCE / "examples/drives/robot_joint.toml").read_text()
        made = Run("export", joint, "--step", "j.step", "--glb", "j.glb", "--stl", "j.stl", "--3mf", "j.3mf")
        self.assertEqual(made.status, 0, made.err)
        self.assertEqual((made.folder / "j.step").read_text().count("MANIFOLD_SOLID_BREP"), 4)
        scene = scene_of((made.folder / "j.glb").read_bytes())
        self.assertEqual([n["name"] for n in scene["nodes"]],
                         ["sun", "planet 1", "planet 2", "planet 3", "ring", "ring2"])
        self.assertEqual(len(scene["meshes"]), 4)
        with zipfile.ZipFile(made.folder / "j.3mf") as z:
            self.assertEqual(z.read("3D/3dmodel.model").decode().count("<item "), 6)
        gearbox = (SOURCE / "examples/drives/two_stage_gearbox.toml").read_text()
        made = Run("export", gearbox, "--step", "g.step")
        self.assertEqual((made.folder / "g.step").read_text().count("MANIFOLD_SOLID_BREP"), 3)

    def test_clocked_planets_are_different_solids(self):
        # 17·13 + 60·30 is not a multiple of 3, so planets at equal pitch must be clocked.
        clocked = ("[planetary]\nsun = 17\nplanet = 30\nplanet2 = 13\nring2 = 60\nplanets = 3\nfixed = \"ring2\"\n"
                   "normal_module_mm = 2\nspacing = \"equal_clocked\"\nface_width_mm = 10\n")
        made = Run("export", clocked, "--step", "c.step")
        self.assertEqual(made.status, 0, made.err)
        self.assertEqual((made.folder / "c.step").read_text().count("MANIFOLD_SOLID_BREP"), 5)

    def test_gears_with_different_bores_are_separate_solids(self):
        joint = (SOURCE / "examples/drives/robot_joint.toml").read_text()
        for bore, solids, note in (("bore_mm = { planet = 8 }", 5, "planet2 is not joined to planet, because their bores differ"),
                                   ("bore_mm = { planet = 8, planet2 = 8 }", 4, "")):
            made = Run("export", joint + bore + "\n", "--step", "j.step")
            self.assertEqual(made.status, 0, made.err)
            self.assertEqual((made.folder / "j.step").read_text().count("MANIFOLD_SOLID_BREP"), solids)
            self.assertIn(note, " ".join(made.out.split()))

    def test_files_that_cannot_exist_give_their_reason(self):
        joint = (SOURCE / "examples/drives/robot_joint.toml").read_text()
        for arguments, words in ((("export", joint, "--svg", "j.svg"), "gears in 2 planes"),
                                 (("run", joint, "--only", "dxf", "--out", "o"), "gears in 2 planes"),
                                 (("run", joint, "--only", "drawing", "--out", "o"), "has no drawing"),
                                 (("run", joint.replace("normal_module_mm = 1\n", ""), "--only", "step", "--out", "o"),
                                  "give the module")):
            made = Run(*arguments)
            self.assertEqual(made.status, 1)
            self.assertIn(words, made.err)


if __name__ == "__main__":
    unittest.main()
