"""Tests REXS files. A file written by `export --rexs` gives the same pair or drive when it is read. Files
of other programs can be read."""
import json
import math
import tempfile
import tomllib
import unittest
import zipfile
from pathlib import Path

from cli import SOURCE, raw

EXAMPLES = SOURCE / "examples"

SET = """
[planetary]
sun = 19
planet = 17
ring = 56
planets = 3
normal_module_mm = 2
face_width_mm = 20
center_distance_mm = 37
thickness_allowance_mm = -0.05
torque_Nm = 100
speed_rpm = 1000
"""

TRAIN = """
[[stage]]
teeth = [20, 61]
normal_module_mm = 2
helix_angle_deg = 15
thickness_allowance_mm = -0.05
torque_Nm = 10

[[stage]]
teeth = [18, 55]
normal_module_mm = 2.5
profile_shift = [0.3, 0.1]
"""


PAIR = "[[stage]]\nteeth = [20, 61]\nnormal_module_mm = 2\nthickness_allowance_mm = -0.04\n"
HELICAL_SET = """
[[stage]]
normal_module_mm = 2.5
helix_angle_deg = 12
face_width_mm = 24
planetary = { sun = 20, planet = 25, ring = 70, planets = 3 }
"""
OTHER_SET = """
[[stage]]
normal_module_mm = 3
planetary = { sun = 18, planet = 24, ring = 66, planets = 4, fixed = "carrier", output = "ring" }
"""
LOAD = "torque_Nm = 40\nspeed_rpm = 900\n"


def numbers(tree, path=""):
    """Returns every number of a tree with its path."""
    if isinstance(tree, dict):
        return {k: v for key, value in tree.items() for k, v in numbers(value, f"{path}.{key}").items()}
    if isinstance(tree, list):
        return {k: v for i, value in enumerate(tree) for k, v in numbers(value, f"{path}.{i}").items()}
    return {path: tree} if isinstance(tree, (int, float)) and not isinstance(tree, bool) else {}


class Rexs(unittest.TestCase):
    def exported(self, spec, folder):
        """Returns the path of the REXS file of a spec."""
        path = Path(folder) / "made.rexs"
        run = raw("export", str(spec), "--rexs", str(path))
        self.assertEqual(run.returncode, 0, run.stderr)
        return path

    def same_numbers(self, one, two, but=()):
        for path, value in one.items():
            if not any(word in path for word in but):
                self.assertTrue(math.isclose(value, two.get(path, math.nan), rel_tol=1e-9, abs_tol=1e-9),
                                (path, value, two.get(path)))

    def test_pairs_read_back(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("helical_pair", "spur_pair", "loaded_pair", "ring_pair", "planetary_ring", "shaft_pair"):
                spec = EXAMPLES / f"{name}.toml"
                made = self.exported(spec, folder)
                one, two = (numbers(json.loads(raw("pair", str(f), "--json").stdout)) for f in (spec, made))
                self.same_numbers(one, two, ("bore", "keyway", "interval", "warnings", "verdict"))

    def test_drives_read_back(self):
        with tempfile.TemporaryDirectory() as folder:
            for spec in (SET, TRAIN):
                source = Path(folder) / "drive.toml"
                source.write_text(spec)
                made = self.exported(source, folder)
                one, two = (numbers(json.loads(raw("drive", str(f), "--json").stdout)["drive"]) for f in (source, made))
                self.same_numbers(one, two)

    def test_trains_with_planetary_sets_read_back(self):
        """A set may be before, after or between other stages, and several sets may follow each other."""
        with tempfile.TemporaryDirectory() as folder:
            for first, *others in ((PAIR, HELICAL_SET), (HELICAL_SET, PAIR), (OTHER_SET, HELICAL_SET),
                                   (PAIR, OTHER_SET, PAIR), (HELICAL_SET, HELICAL_SET, OTHER_SET)):
                source = Path(folder) / "drive.toml"
                source.write_text(first + LOAD + "".join(others))
                made = self.exported(source, folder)
                one, two = (json.loads(raw("drive", str(f), "--json").stdout)["drive"] for f in (source, made))
                self.assertEqual(one["ratio_exact"], two["ratio_exact"])
                self.assertEqual(list(one["bodies"]), list(two["bodies"]))
                self.assertEqual(len(one["stages"]), 1 + len(others))
                self.same_numbers(numbers(one), numbers(two))

    def test_the_examples_of_drives_read_back(self):
        """The members, the held members, the inputs, the output and the load are those of the exported drive."""
        with tempfile.TemporaryDirectory() as folder:
            for spec in sorted((EXAMPLES / "drives").glob("*.toml")):
                made = self.exported(spec, folder)
                one, two = (json.loads(raw("drive", str(f), "--json").stdout)["drive"] for f in (spec, made))
                self.assertEqual(one["ratio_exact"], two["ratio_exact"], spec)
                self.assertEqual(list(one["bodies"]), list(two["bodies"]), spec)
                self.same_numbers(numbers(one), numbers(two), (".load",))

    def test_an_export_states_what_the_file_does_not_contain(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "drive.toml"
            source.write_text(SET + "spacing = \"equal\"\nfriction_coefficient = 0.1\n")
            run = raw("export", str(source), "--rexs", str(Path(folder) / "made.rexs"))
            self.assertIn("without the positions of the planets, without friction", " ".join(run.stdout.split()))

    def test_the_rack_of_a_ring_is_not_that_of_its_pinion(self):
        """The default cutter of a ring is not in the file. The ring that is read has the usual rack."""
        pair = ("[gear1]\nteeth = 16\nnormal_module_mm = 3\nprofile_shift = 0.42\n"
                "rack = {addendum = 1.1, dedendum = 1.35, root_fillet_radius = 0.2}\n"
                "[gear2]\nteeth = -47\nprofile_shift = -0.245\nrack = \"ISO53-")
        with tempfile.TemporaryDirectory() as folder:
            source, path = Path(folder) / "pair.toml", Path(folder) / "made.rexs"
            for name, left_out in (("A", False), ("C", True)):
                source.write_text(pair + name + "\"\n")
                run = raw("export", str(source), "--rexs", str(path))
                note = " ".join(run.stdout.split())
                self.assertEqual("without the basic rack of the internal gear" in note, left_out)
                roots = [json.loads(raw("gear", str(f), "--json").stdout)["gears"][1]["root_diameter_mm"]
                         for f in (source, path)]
                self.assertAlmostEqual(roots[0], roots[1], delta=1e-9)

    def test_a_full_root_radius_reads_back(self):
        """At 25°, the radius 0.38 of ISO53-A does not fit, and the full radius replaces it."""
        gear = "teeth = {}\nnormal_module_mm = 2\nnormal_pressure_angle_deg = 25\n"
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "pair.toml"
            source.write_text(f"[gear1]\n{gear.format(20)}[gear2]\n{gear.format(40)}")
            made = self.exported(source, folder)
            one, two = (numbers(json.loads(raw("gear", str(f), "--json").stdout)["gears"]) for f in (source, made))
            self.assertGreater(len(one), 20)
            self.same_numbers(one, two)

    def test_torque_and_speed_of_a_pair_read_back(self):
        """The torque of a driving gear 2 is on its shaft in the file, and on gear 1 in the spec."""
        pair = (EXAMPLES / "spur_pair.toml").read_text()
        pair = pair.replace("[pair]\n", "[pair]\nspeed_rpm = 900\n")
        load = "\n[load]\ntorque_Nm = 40\ndriver = {}\n"
        with tempfile.TemporaryDirectory() as folder:
            for driver in (1, 2):
                source = Path(folder) / "pair.toml"
                source.write_text(pair + load.format(driver))
                made = self.exported(source, folder)
                spec = tomllib.loads(raw("import", str(made)).stdout)
                self.assertAlmostEqual(spec["load"]["torque_Nm"], 40, delta=1e-12)
                self.assertAlmostEqual(spec["pair"]["speed_rpm"], 900, delta=1e-9)
                self.assertEqual(spec["load"].get("driver", 1), driver)

    def test_an_export_states_that_it_cannot_be_read_back(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "drive.toml"
            bodies = "".join(f"[[drive.body]]\nname = '{name}'\n" for name in "abc")
            gears = "".join(f"[[drive.gear]]\nname = 'g{name}'\nbody = '{name}'\nteeth = {z}\n"
                            "normal_module_mm = 2\n" for name, z in (("a", 20), ("b", 40), ("c", 50)))
            meshes = "".join(f"[[drive.mesh]]\ngears = ['ga', 'g{name}']\n" for name in "bc")
            source.write_text("[drive]\ninput = 'a'\noutput = 'b'\n" + bodies + gears + meshes)
            path = Path(folder) / "made.rexs"
            run = raw("export", str(source), "--rexs", str(path))
            self.assertIn("Gearwright cannot read it: the 2 stages do not form a chain", " ".join(run.stdout.split()))
            self.assertEqual(raw("import", str(path)).returncode, 1)

    def test_json_has_the_content_of_xml(self):
        """A file in JSON gives the same spec as the file in XML, for every example that can be exported."""
        with tempfile.TemporaryDirectory() as folder:
            made = [Path(folder) / f"made.{ending}" for ending in ("rexs", "rexsj")]
            for spec in (*sorted((EXAMPLES / "drives").glob("*.toml")), EXAMPLES / "helical_pair.toml",
                         EXAMPLES / "ring_pair.toml"):
                for path in made:
                    run = raw("export", str(spec), "--rexs", str(path))
                    self.assertEqual(run.returncode, 0, run.stderr)
                xml, text = (raw("import", str(path)) for path in made)
                self.assertEqual((text.stdout, text.stderr, text.returncode), (xml.stdout, xml.stderr, 0), spec)
            model = json.loads(made[1].read_text())["model"]
            self.assertEqual(model["version"], "1.7")
            gear = next(c for c in model["components"] if c["type"] == "cylindrical_gear")
            teeth = next(a for a in gear["attributes"] if a["id"] == "number_of_teeth")
            self.assertEqual(teeth["integer"], tomllib.loads(spec.read_text())["gear1"]["teeth"])
            run = raw("pair", str(made[1]), "--json")
            self.assertEqual(run.stdout, raw("pair", str(made[0]), "--json").stdout)

    def test_a_compressed_file_contains_the_file_in_xml(self):
        """The archive is read by zipfile, and an archive of zipfile gives the spec of its only REXS file."""
        with tempfile.TemporaryDirectory() as folder:
            made = self.exported(EXAMPLES / "helical_pair.toml", folder)
            path = Path(folder) / "model.rexsz"
            run = raw("export", str(EXAMPLES / "helical_pair.toml"), "--rexs", str(path))
            self.assertEqual(run.returncode, 0, run.stderr)
            with zipfile.ZipFile(path) as archive:
                self.assertIsNone(archive.testzip())
                self.assertEqual(archive.namelist(), ["model.rexs"])
                self.assertEqual(archive.read("model.rexs"), made.read_bytes())
            spec = raw("import", str(made)).stdout
            self.assertEqual(raw("import", str(path)).stdout, spec)
            for method in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
                with zipfile.ZipFile(path, "w", method) as archive:
                    archive.writestr("spectra/load.csv", "1;2\n")
                    archive.writestr("unit/other.rexs", made.read_text())
                    archive.comment = b"made by another program"
                self.assertEqual(raw("import", str(path)).stdout, spec)

    def test_a_broken_archive_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            made = self.exported(EXAMPLES / "helical_pair.toml", folder)
            path = Path(folder) / "model.rexsz"

            def refused(content, words):
                path.write_bytes(content)
                run = raw("import", str(path))
                self.assertEqual((run.returncode, run.stdout), (1, ""), words)
                self.assertIn(words, " ".join(run.stderr.split()))

            def archive(files, method=zipfile.ZIP_DEFLATED):
                with zipfile.ZipFile(path, "w", method) as out:
                    for name, text in files.items():
                        out.writestr(name, text)
                return path.read_bytes()

            text = made.read_text()
            whole = archive({"a.rexs": text})
            refused(whole[:-30], "the archive ends too early or is damaged")
            refused(b"PK\x03\x04", "the archive ends too early or is damaged")
            for at in (0, 60, len(whole) // 2):  # the local header and the compressed bytes
                refused(whole[:at] + bytes([whole[at] ^ 0x55]) + whole[at + 1:],
                        "is not XML" if at == 0 else "a.rexs in the archive is damaged; copy the archive again")
            directory = whole.index(b"PK\x01\x02")
            secret = whole[:directory + 8] + b"\x01" + whole[directory + 9:]
            refused(secret, "is encrypted; compress it without a password")
            refused(archive({"a.rexs": text}, zipfile.ZIP_BZIP2), "by another method than deflate")
            refused(archive({"a.rexs": "x" * (5 << 20)}), "has more than 4194304 bytes")
            refused(archive({"a.txt": text}), "no file whose name ends in .rexs or .rexsj")
            refused(archive({"a.rexs": text, "b.rexsj": "{}"}), "2 REXS files (a.rexs and b.rexsj)")
            refused(b"{}", "not REXS")

    def test_import_prints_the_spec_that_every_verb_reads(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "drive.toml"
            source.write_text(TRAIN)
            made = self.exported(source, folder)
            printed = raw("import", str(made)).stdout
            for words in ("# This spec was read from a REXS 1.7 file of Gearwright.", "[[stage]]", "[[stage.gears]]"):
                self.assertIn(words, printed)
            source.write_text(printed)
            self.assertEqual(raw("drive", str(source), "--json").stdout, raw("drive", str(made), "--json").stdout)

    def test_what_is_no_stage_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, word in (("crossed_pair", "parallel axes"), ("circular_arc_drive", "circular-arc"),
                               ("herringbone_pair", "a single helix"), ("printed_gear", "two gears"),
                               ("steering_rack", 'gear2.form = "rack": is not supported')):
                run = raw("export", str(EXAMPLES / f"{name}.toml"), "--rexs", str(Path(folder) / "made.rexs"))
                self.assertEqual(run.returncode, 1, name)
                self.assertIn(word, run.stderr)
            self.assertEqual(list(Path(folder).iterdir()), [])
            halves = Path(folder) / "halves.toml"
            halves.write_text("[[stage]]\n[[stage.gears]]\nteeth = 20\nnormal_module_mm = 2\nhelix_angle_deg = 25\n"
                              "face_width_mm = 48\ndouble_helical = { gap_mm = 8 }\n[[stage.gears]]\nteeth = 40\n")
            run = raw("export", str(halves), "--rexs", str(Path(folder) / "made.rexs"))
            self.assertEqual([run.returncode, "s1_gear1: is double-helical" in run.stderr], [1, True], run.stderr)
            self.assertEqual(list(Path(folder).iterdir()), [halves])
            broken = Path(folder) / "broken.rexs"
            broken.write_text("<model version=\"1.0\"><components></model>")
            run = raw("pair", str(broken))
            self.assertEqual(run.returncode, 1)
            self.assertIn("not XML", run.stderr)


if __name__ == "__main__":
    unittest.main()
