"""Tests the verbs as a user types them: outputs, exit statuses and files."""
import json
import math
import re
import struct
import unittest

from cli import PAIR, SOURCE, Run, new_folder, raw


class Verbs(unittest.TestCase):
    def test_gear_json_has_every_key_of_the_interface(self):
        r = Run("gear", PAIR, "--json")
        self.assertEqual(r.status, 0, r.err)
        keys = """teeth kind normal_module_mm normal_pressure_angle_deg transverse_pressure_angle_deg
          helix_angle_deg base_helix_angle_deg profile_shift lead_mm reference_diameter_mm base_diameter_mm
          tip_diameter_mm root_diameter_mm root_form_diameter_mm tip_form_diameter_mm base_tooth_thickness_mm
          reference_tooth_thickness_normal_mm tip_tooth_thickness_normal_mm pointed_diameter_mm undercut
          undercut_free_profile_shift pointed severed through_axis tip_cut_by_rack neck_thickness_mm""".split()
        for gear in r.json["gears"]:
            self.assertEqual([k for k in keys if k not in gear], [])
        self.assertIn("warnings", r.json)

    def test_pair_json_has_every_key_of_the_interface(self):
        r = Run("pair", PAIR, "--json")
        self.assertEqual(r.status, 0, r.err)
        keys = """kind gear_ratio shaft_angle_deg center_distance_mm reference_center_distance_mm
          backlash_free_center_distance_mm working_normal_pressure_angle_deg
          working_transverse_pressure_angle_deg working_helix_angle_deg working_pitch_diameter_mm contact_ratio
          transverse_contact_ratio contact_ratio_true overlap_ratio extended_center_distance_mm line_of_action
          interference tip_clearance_mm specific_sliding backlash pitch_plane_distance_mm min_face_width_mm
          min_face_width_both_flanks_mm minimum_center_distance contact_ratio_range""".split()
        self.assertEqual([k for k in keys if k not in r.json["pair"]], [])
        self.assertEqual(r.json["pair"]["kind"], "parallel_external")
        line = r.json["pair"]["line_of_action"]
        a, b = line["leading"]
        self.assertAlmostEqual(math.dist(a, b), line["length_mm"], places=12)

    def test_a_speed_gives_the_pitch_line_velocity_in_every_output(self):
        with_speed = PAIR + "[pair]\nspeed_rpm = 1500\n"
        pair = Run("pair", with_speed, "--json").json["pair"]
        # The distance of the pitch point from axis 1 is a/(1 + u).
        want = 2 * math.pi * pair["center_distance_mm"] / (1 + pair["gear_ratio"]) * 1500 / 60e3
        for velocity in pair["pitch_line_velocity_m_per_s"]:
            self.assertAlmostEqual(velocity, want, places=12)
        self.assertRegex(Run("pair", with_speed).out, rf"pitch line velocity +v_t +{want:.4f} +{want:.4f} +m/s")
        ran = Run("run", with_speed)
        self.assertEqual(ran.status, 0, ran.err)
        self.assertIn("pitch line velocity", (ran.folder / "case_out/report.html").read_text().lower())
        self.assertNotIn("pitch_line_velocity_m_per_s", Run("pair", PAIR, "--json").json["pair"])
        self.assertIn("pair.speed_rpm", Run("pair", PAIR + "[pair]\nspeed_rpm = 0\n").err)

    def test_free_play_is_the_backlash_without_collision(self):
        j = Run("pair", PAIR, "--json").json["pair"]["backlash"]
        for free, play in zip(j["free_rotation_deg"], j["rotation_deg"], strict=True):
            self.assertAlmostEqual(free, play, delta=1e-12 * abs(play))

    def test_outline_runs_from_space_to_tooth_without_gaps(self):
        r = Run("outline", PAIR, "--gear", 2, "--points", 7, "--json")
        self.assertEqual(r.status, 0, r.err)
        arcs = r.json["arcs"]
        self.assertEqual([a["name"] for a in arcs], ["root_land", "root_fillet", "flank", "tip_land"])
        for a in arcs:
            self.assertEqual(len(a["points"]), 7)
        for a, b in zip(arcs, arcs[1:]):
            self.assertEqual(a["points"][-1], b["points"][0])
        x, y = arcs[0]["points"][0]
        self.assertAlmostEqual(math.atan2(y, x), math.pi / 43, places=15)
        self.assertEqual(arcs[-1]["points"][-1][1], 0)

    def test_run_writes_everything_and_nothing_else(self):
        r = Run("run", PAIR, "--json")
        self.assertEqual(r.status, 0, r.err)
        want = ["result.json", "report.html", "drawing.pdf", "pair.glb", "pair.step"]
        for g in ("gear1", "gear2"):
            want += [g + e for e in (".stl", ".3mf", ".dxf", ".svg", ".step")]
        self.assertEqual(r.files(), sorted(["case.toml"] + ["case_out/" + w for w in want]))
        on_disk = json.loads((r.folder / "case_out/result.json").read_text())
        self.assertEqual(on_disk["pair"], r.json["pair"])
        for f in r.json["files"]:
            if f["file"].endswith(".step"):
                self.assertLessEqual(f["max_deviation_um"], 0.1)

    def test_mounted_files_put_space_0_to_the_mesh(self):
        r = Run("export", PAIR, "--glb", "pair.glb")
        self.assertEqual(r.status, 0, r.err)
        glb = (r.folder / "pair.glb").read_bytes()
        nodes = json.loads(glb[20:20 + struct.unpack("<I", glb[12:16])[0]])["nodes"]
        by_name = {n["name"]: n.get("matrix", [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]) for n in nodes}
        a = Run("pair", PAIR, "--json").json["pair"]["center_distance_mm"]
        turn = math.pi * (1 - 1 / 43)
        want = [math.cos(turn), math.sin(turn), 0, 0, -math.sin(turn), math.cos(turn), 0, 0, 0, 0, 1, 0, a / 1000, 0, 0, 1]
        for got, value in zip(by_name["gear2"], want):
            self.assertAlmostEqual(got, value, places=14)
        self.assertEqual(by_name["gear1"][12:15], [0, 0, 0])

    def test_export_writes_the_protocol_that_is_asked_for(self):
        for words, name, schema in ((), "AP242", "AP242_MANAGED_MODEL"), (("--step-schema", "ap214"), "AP214", "AUTOMOTIVE_DESIGN"):
            r = Run("export", PAIR, "--step", "zwei Räder.step", *words, "--json")
            self.assertEqual(r.status, 0, r.err)
            self.assertEqual(r.json["files"][0]["what"], "STEP, " + name)
            text = (r.folder / "zwei Räder.step").read_text(encoding="ascii")
            self.assertIn("FILE_SCHEMA(('" + schema, text)
            self.assertIn(r"'zwei R\X2\00E4\X0\der'", text)
        r = Run("export", PAIR, "--step", "a.step", "--step-schema", "ap203")
        self.assertEqual(r.status, 2)
        self.assertNotIn("a.step", r.files())

    def test_run_of_a_single_gear(self):
        r = Run("run", "[gear1]\nteeth = 21\nnormal_module_mm = 2\nface_width_mm = 9\n")
        self.assertEqual(r.status, 0, r.err)
        self.assertNotIn("case_out/pair.glb", r.files())
        self.assertIn("case_out/gear1.stl", r.files())

    def test_ring_pair_is_whole_and_names_its_cutter(self):
        spec = "[gear1]\nteeth = 18\nnormal_module_mm = 2\nprofile_shift = 0.3\n[gear2]\nteeth = -60\nnormal_module_mm = 2\nprofile_shift = -0.3\n"
        r = Run("run", spec, "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual(r.json["pair"]["kind"], "parallel_internal")
        self.assertIn("default_cutter", [w["code"] for w in r.json["warnings"]])
        self.assertIn("case_out/gear2.step", r.files())
        self.assertIn("case_out/pair.glb", r.files())
        r = Run("outline", spec, "--gear", 2, "--json")
        self.assertEqual(r.status, 0)
        radii = [math.hypot(*p) for a in r.json["arcs"] for p in a["points"]]
        # The radius decreases from the root inwards.
        self.assertTrue(all(b <= a + 1e-12 for a, b in zip(radii, radii[1:])))

    def test_same_spec_same_bytes(self):
        a, b = Run("run", PAIR), Run("run", PAIR)
        for f in a.files():
            self.assertEqual((a.folder / f).read_bytes(), (b.folder / f).read_bytes(), f)

    def test_json_spec_is_the_same_door(self):
        a = Run("pair", PAIR, "--json")
        tree = {"title": "helical pair",
                "gear1": {"teeth": 17, "normal_module_mm": 2.5, "helix_angle_deg": 15, "profile_shift": 0.3, "face_width_mm": 25},
                "gear2": {"teeth": 43, "normal_module_mm": 2.5, "helix_angle_deg": -15, "profile_shift": 0.1, "face_width_mm": 25}}
        b = Run("pair", json.dumps(tree), "--json", name="case.json")
        self.assertEqual(a.out, b.out)

    def test_export_writes_the_named_files_only(self):
        r = Run("export", PAIR, "--gear", 1, "--stl", "a.stl", "--dxf", "a.dxf", "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual(r.files(), ["a.dxf", "a.stl", "case.toml"])

    def test_workshop_drawings(self):
        r = Run("export", PAIR, "--drawing", "pair.pdf", "--json")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual([f["what"] for f in r.json["files"]], ["PDF drawing"])
        self.assertEqual(r.json["files"][0]["note"], "A4, scale 1:1, 1:2")
        self.assertEqual((r.folder / "pair.pdf").read_bytes().count(b"/Type /Page "), 2)
        r = Run("export", PAIR, "--drawing", "one.SVG", "--gear", 2, "--sheet", "A3", "--step", "one.step")
        self.assertEqual(r.files(), ["case.toml", "one.SVG", "one.step"])
        svg = (r.folder / "one.SVG").read_text()
        self.assertIn(">1/1<", svg)
        self.assertIn(">Centre distance<", svg)  # for a single gear, too
        for name, words in (("a.png", "ends in .pdf, .svg or .dxf"), ("case.toml", "ends in"), ("pdf", "ends in")):
            r = Run("export", PAIR, "--drawing", name)
            self.assertEqual(r.status, 2, name)
            self.assertIn(words, r.err)
        for verb in ("export", "run"):
            self.assertEqual(Run(verb, PAIR, *(["--drawing", "a.pdf"] if verb == "export" else []), "--sheet", "A5").status, 2)
        for sheet in ("A4", "A3"):
            run = Run("run", PAIR, "--out", "o", "--only", "drawing", "--sheet", sheet, "--json")
            self.assertEqual(run.json["files"][0]["note"].split(",")[0], sheet)
            export = Run("export", PAIR, "--drawing", "a.pdf", "--sheet", sheet)
            self.assertEqual((run.folder / "o/drawing.pdf").read_bytes(), (export.folder / "a.pdf").read_bytes())
        drive = Run("run", "[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\n", "--sheet", "A3")
        self.assertEqual(drive.status, 2)
        self.assertIn("a drive has no workshop drawing", drive.err)
        title = 'title = "pair of 歯車"\n' + PAIR.replace('title = "helical pair"', "")
        note = Run("export", title, "--drawing", "a.pdf", "--json").json["files"][0]["note"]
        self.assertIn("4 letters are missing in the fonts of the PDF", note)
        bore = PAIR + "[gear2.bore]\ndiameter_mm = 200\n"
        r = Run("export", bore, "--drawing", "a.pdf", "--json")
        self.assertEqual((r.status, r.json["error"]["key"], r.files()), (1, "gear2.bore.diameter_mm", ["case.toml"]))

    def test_a_fit_without_its_bore_or_keyway_is_reported(self):
        fits = '[drawing]\nbore_fit = "H7"\nkeyway_fit = "JS9"\n' + PAIR
        bore = fits.replace("[gear2]", "[gear1.bore]\ndiameter_mm = 20\n[gear2]")
        keyed = bore.replace("[gear2]", "keyway_width_mm = 6\nkeyway_depth_mm = 2.8\n[gear2]")
        for spec, keys in ((fits, ["drawing.bore_fit", "drawing.keyway_fit"]), (bore, ["drawing.keyway_fit"]), (keyed, [])):
            notes = [w["message"] for w in Run("pair", spec, "--json").json["warnings"] if w["code"] == "not_read"]
            self.assertEqual(len(notes), len(keys), notes)
            for note, key in zip(notes, keys):
                self.assertIn(key, note)

    def test_a_texture_of_a_bore_without_its_bore_is_reported(self):
        texture = '[drawing]\nflank_roughness = "Ra 0.8"\nbore_roughness = "Ra 1.6"\n' + PAIR
        bore = texture.replace("[gear2]", "[gear1.bore]\ndiameter_mm = 20\n[gear2]")
        for spec, count in ((texture, 1), (bore, 0)):
            r = Run("pair", spec, "--json")
            notes = [w["message"] for w in r.json["warnings"] if w["code"] == "not_read"]
            self.assertEqual(len(notes), count, notes)
            self.assertTrue(all("drawing.bore_roughness" in note for note in notes), notes)
        long = Run("pair", texture.replace("Ra 1.6", "Ra 1.6 in the whole bore"), "--json")
        self.assertEqual((long.status, long.json["error"]["key"]), (1, "drawing.bore_roughness"))

    def test_drawings_of_both_gears_stand_in_place(self):
        r = Run("export", PAIR, "--dxf", "both.dxf", "--svg", "both.svg", "--dxf-splines")
        self.assertEqual(r.status, 0, r.err)
        self.assertEqual((r.folder / "both.svg").read_text().count("<path "), 2)
        a = Run("pair", PAIR, "--json").json
        lines = (r.folder / "both.dxf").read_text().split("ENTITIES\n")[1].split("ENDSEC")[0].splitlines()
        x = [float(v) for code, v in zip(lines[::2], lines[1::2]) if code.strip() == "10"]
        reach = a["pair"]["center_distance_mm"] + a["gears"][1]["tip_diameter_mm"] / 2
        self.assertAlmostEqual(max(x), reach, delta=0.05)
        self.assertAlmostEqual(min(x), -a["gears"][0]["tip_diameter_mm"] / 2, delta=0.5)

    def test_verify_refuses_what_is_no_case_file(self):
        case = '{"cases": [{"id": "a", "source": "b", "expected": {"x": 1}, "spec": %s}]}'
        where = new_folder()
        for text, words in ((case % ('{"a": ' * 50_000 + "1" + "}" * 50_000), "more than 64 nested levels"),
                            (case % ("[" * 50_000 + "]" * 50_000), "more than 64 nested levels"),
                            ("{", "line 1")):
            (where / "cases.json").write_text(text)
            p = raw("verify", where / "cases.json")
            self.assertEqual([p.returncode, p.stdout], [1, ""], p.stderr)
            self.assertIn(words, p.stderr)
            self.assertNotIn("json.exception", p.stderr)
        p = raw("verify", "/dev/zero")
        self.assertEqual([p.returncode, p.stdout], [3, ""], p.stderr)
        self.assertIn("more than", p.stderr)

    def test_verify_runs_the_golden_cases(self):
        # The golden tests verify all files. These three contain the verbs gear, pair, measure, fit and drive.
        p = raw("verify", *[SOURCE / f"tests/golden/{name}.json" for name in ("conjugate_action", "drives", "inspection")])
        self.assertEqual(p.returncode, 0, p.stdout + p.stderr)
        self.assertRegex(p.stdout, r"(\d+) of \1 cases agree")

    def test_help_teaches_by_example(self):
        p = raw("--help")
        self.assertEqual(p.returncode, 0)
        self.assertIn("gearwright run pair.toml", p.stdout)
        for verb in ("run", "gear", "outline", "pair", "export", "verify"):
            p = raw(verb, "--help")
            self.assertEqual(p.returncode, 0)
            self.assertIn("Example:", p.stdout)

    def test_tables_for_people(self):
        r = Run("pair", PAIR)
        self.assertEqual(r.status, 0)
        for word in ("centre distance", "ε_α", "j_bn", "gear 2"):
            self.assertIn(word, r.out)

    def test_every_example_runs(self):
        # The test runs the commands in the opening comment of each example. It also runs `run`, unless the
        # example is for `fit`, `search` or `identify`.
        examples = sorted((SOURCE / "examples").glob("*.toml"))
        self.assertTrue(examples)
        for example in examples:
            text = example.read_text()
            commands = [c.split() for c in re.findall(r"^#   gearwright (.+)$", text, re.M)]
            self.assertTrue(commands, example.name)
            asked = {verb for verb, *_ in commands}
            if not asked & {"run", "fit", "search", "identify"}:
                commands.append(["run", "examples/" + example.name])
            for verb, path, *options in commands:
                with self.subTest(example=example.name, verb=verb):
                    self.assertEqual(path, "examples/" + example.name)
                    r = Run(verb, text, *options, name=example.name)
                    self.assertEqual(r.status, 0, r.err)

    def test_examples_of_crossed_axes_need_no_warning(self):
        for name in ("crossed_pair", "basic_gear_pair"):
            r = Run("pair", (SOURCE / "examples" / (name + ".toml")).read_text(), "--json")
            self.assertEqual(r.json["pair"]["kind"], "crossed")
            self.assertEqual(r.json["warnings"], [])
            self.assertGreater(r.json["pair"]["contact_ratio_true"], 1.5)

    def test_both_answers_of_the_fit_example_mount_at_their_place(self):
        wish = (SOURCE / "examples/crossed_fit.toml").read_text()
        branches = Run("fit", wish, "--json").json["fit"]["branches"]
        self.assertEqual(len(branches), 2)
        for number, branch in enumerate(branches, 1):
            taken = Run("fit", wish, "--take", number)
            self.assertEqual(taken.status, 0, taken.err)
            r = Run("pair", taken.out, "--json")
            self.assertEqual(r.json["warnings"], [])
            least = r.json["pair"]["minimum_center_distance"]
            for key in ("center_distance_mm", "shaft_angle_deg"):
                self.assertAlmostEqual(least[key], branch[key], places=9)
                self.assertAlmostEqual(r.json["pair"][key], branch[key], places=9)


if __name__ == "__main__":
    unittest.main()
