"""Tests drives under load: load shares of the planets and K_γ, the loaded transmission error of a mesh
compared with the verb load, and the errors for specs without a load."""
import re
import unittest

from cli import SOURCE, Run

SET = """
[planetary]
sun = 20
planet = 25
ring = 70
planets = 3
normal_module_mm = 2
face_width_mm = 12
thickness_allowance_mm = -0.05
torque_Nm = 60
"""
DRAFT = '[load]\naccuracy = "draft"\npositions = 12\n'
STAGE = "[[stage]]\nteeth = [19, 58]\nnormal_module_mm = 2\nface_width_mm = 12\nthickness_allowance_mm = -0.05\ntorque_Nm = 60\n"


STEPPED = SET.replace("planet = 25", "planet = 25\nplanet2 = 18").replace("ring = 70", "ring2 = 63")


class Shares(unittest.TestCase):
    def of(self, load, text=SET):
        run = Run("drive", text + DRAFT + load, "--json")
        self.assertEqual(run.status, 0, run.err)
        return run.json["drive"]["load"]

    def test_planets_share_the_load(self):
        load = self.of("pin_error_um = [4, 0, 0]\n")
        (of_set,) = load["sets"]
        self.assertEqual(load["torque_Nm"], 60)
        self.assertEqual(of_set["carrier"], "carrier")
        self.assertAlmostEqual(sum(of_set["share_mean"]), 1, 9)
        self.assertLess(of_set["share_max"][0], 0.33)
        self.assertAlmostEqual(of_set["mesh_load_factor"], 3 * max(of_set["share_max"]), 2)
        self.assertEqual(len(of_set["shares"]), 3)
        self.assertEqual({len(share) for share in of_set["shares"]}, {12})
        self.assertIsNone(of_set["floating"])
        self.assertGreater(load["output_arcsec_peak_to_peak"], 0)
        self.assertEqual(load["rigid_arcsec_peak_to_peak"], 0)

    def test_a_floating_sun_makes_three_shares_equal(self):
        (of_set,) = self.of('pin_error_um = 15\nfloating = "sun"\n')["sets"]
        self.assertAlmostEqual(of_set["mesh_load_factor"], 1, 7)
        self.assertGreater(of_set["displacement_um"], 5)

    def test_stepped_planets_have_a_curve_for_each_frequency(self):
        load = self.of("pin_error_um = [4, 0, 0]\n", STEPPED)
        (of_set,) = load["sets"]
        self.assertAlmostEqual(sum(of_set["share_mean"]), 1, 9)
        self.assertLess(of_set["share_max"][0], 0.33)
        self.assertAlmostEqual(of_set["mesh_load_factor"], 3 * max(of_set["share_max"]), 2)
        ratios = [curve["frequency_ratio"] for curve in load["curves"]]
        self.assertEqual(len(ratios), 2)
        self.assertAlmostEqual(ratios[0] / ratios[1], 25 / 18, 12)
        floating = self.of('pin_error_um = 15\nfloating = "sun"\n', STEPPED)["sets"][0]
        self.assertAlmostEqual(floating["mesh_load_factor"], 1, 7)
        self.assertIsNone(floating["mesh_load_factors"])
        three = self.of("", STEPPED.replace("ring2 = 63", "ring = 70\nring2 = 63").replace("planets", 'output = "ring2"\nplanets'))
        (of_set,) = three["sets"]
        self.assertEqual(len(of_set["mesh_load_factors"]), 3)
        self.assertEqual(max(of_set["mesh_load_factors"]), of_set["mesh_load_factor"])
        self.assertLess(min(of_set["mesh_load_factors"]), 0.9 * of_set["mesh_load_factor"])
        joint = (SOURCE / "examples/drives/robot_joint.toml").read_text()  # its planets are in phase
        self.assertAlmostEqual(self.of("", joint + "\n")["sets"][0]["mesh_load_factor"], 1, 7)

    def test_unequal_shares_are_a_finding_without_a_rating(self):
        """A pin that is 60 µm ahead leaves the load to the planet that is 60 µm behind, so K_γ is almost 3."""
        for pin in (60, 2):
            run = Run("drive", SET + DRAFT + f"pin_error_um = [{pin}, {-pin}, 0]\n", "--json")
            found = [f for f in run.json["verdict"]["findings"] if f["code"] == "mesh_load_factor"]
            self.assertEqual([f["level"] for f in found], ["amber"] if pin == 60 else [], found)

    def test_a_mesh_has_the_curve_of_the_verb_load(self):
        """If there are no shifts and allowances, the loaded flanks touch at the pitch point a quarter of
        a period from the centre line. Both verbs then compute the same positions."""
        fine = '[load]\npositions = 128\naccuracy = "draft"\n'
        text = STAGE.replace("thickness_allowance_mm = -0.05\n", "") + fine
        drive = Run("drive", text, "--json").json["drive"]["load"]
        take = Run("drive", text, "--take", "1")
        (at,) = Run("load", take.out, "--json").json["load"]["torques"]
        self.assertIsNone(drive["mesh_load_factor"])
        self.assertAlmostEqual(drive["output_arcsec_peak_to_peak"] / at["peak_to_peak_arcsec"], 1, 9)

    def test_the_spec_of_a_mesh_has_its_driver_and_resolution(self):
        """If the carrier drives, the planet drives the sun, which is gear 1."""
        text = SET.replace("planets = 3", 'planets = 3\ninput = "carrier"\noutput = "sun"') + DRAFT
        sun, ring = (Run("drive", text, "--take", n).out for n in ("1", "2"))
        for spec, drivers in ((sun, 2), (ring, 2)):
            self.assertEqual(spec.count("driver = 2"), drivers)
            self.assertIn('accuracy = "draft"', spec)
            self.assertIn("positions = 12", spec)
            self.assertEqual(Run("load", spec).status, 0)

    def test_without_the_table_nothing_changes(self):
        self.assertNotIn("load", Run("drive", SET, "--json").json["drive"])

    def test_the_rating_keeps_its_factor(self):
        text = (SOURCE / "examples/drives/planetary_set.toml").read_text()
        rating = '[rating]\nquality = [6, 6]\nmesh_load_factor = 1.1\nface_load_factor = 1.2\nmaterial = "16MnCr5"\n'
        plain = Run("rate", text + rating, "--json")
        self.assertEqual(plain.status, 0, plain.err)
        loaded = Run("rate", text + rating + DRAFT, "--json")
        self.assertEqual(loaded.status, 0, loaded.err)
        self.assertEqual(loaded.json["drive"]["load"]["rated_mesh_load_factor"], 1.1)
        self.assertEqual({name: mesh["rating"] for name, mesh in plain.json["drive"]["meshes"].items()},
                         {name: mesh["rating"] for name, mesh in loaded.json["drive"]["meshes"].items()})
        self.assertIn("The rating uses K_γ = 1.100", Run("rate", text + rating + DRAFT).out)
        page = (Run("run", text + rating + DRAFT, "--out", "o").folder / "o/report.html").read_text()
        computed = loaded.json["drive"]["load"]["mesh_load_factor"]
        self.assertIn(f"The most loaded planet carries {computed:.3f} times an equal share. The rating uses K_γ = 1.100.", page)
        self.assertIn("<h2>Mesh planet_ring</h2>\n<p>Gear 1 is planet, gear 2 is ring.</p>",
                      re.sub(r"<h2 [^>]*>", "<h2>", page))

    def test_a_greater_factor_than_the_rating_is_a_finding(self):
        """A pin that is 30 µm out of place unloads its planet, so the other two carry half of the load each: K_γ = 3/2."""
        text = '''[planetary]
sun = 18
planet = 21
ring = 60
planets = 3
normal_module_mm = 1.25
face_width_mm = 14
profile_shift = { sun = 0.1 }
thickness_allowance_mm = -0.05
torque_Nm = 18.6
speed_rpm = 350
[load]
positions = 8
accuracy = "draft"
pin_error_um = PINS
[rating]
life_h = 3000
quality = 6
face_load_factor = 1.2
material = "16MnCr5"
'''
        def factor(pins, *extra):
            run = Run("rate", text.replace("PINS", pins) + "".join(extra), "--json")
            verdict = run.json["verdict"]
            return verdict, [f for f in verdict["findings"] if f["code"] == "mesh_load_factor"]
        verdict, found = factor("[30, 0, 0]")
        self.assertEqual(verdict["level"], "amber")
        self.assertEqual([f["level"] for f in found], ["amber"])
        for words in ("K_γ = 1.500", "K_γ = 1.000", "mesh_load_factor = 1.5"):
            self.assertIn(words, found[0]["message"])
        self.assertEqual(factor("[0, 0, 0]")[1], [])
        for own in ("1.501", "{ sun_planet = 1.501, planet_ring = 1.501 }", '"computed"'):
            self.assertEqual(factor("[30, 0, 0]", f"mesh_load_factor = {own}\n")[1], [], own)
        (one,) = factor("[30, 0, 0]", "mesh_load_factor = { planet_ring = 1.6 }\n")[1]
        self.assertIn("In the mesh sun_planet", one["message"])

    def test_each_mesh_has_its_own_factor(self):
        """The rating of a mesh with its own K_γ is that of the set in which all meshes have this K_γ. The computed
        factors are those of the planets under load, which differ between the meshes of a 3K set."""
        three = STEPPED.replace("ring2 = 63", "ring = 70\nring2 = 63").replace("planets", 'output = "ring2"\nplanets')
        rating = '[rating]\nspeed_rpm = 1000\nquality = 6\nface_load_factor = 1.2\nmaterial = "16MnCr5"\nmesh_load_factor = '
        def rated(factor, load=""):
            run = Run("rate", three + load + rating + factor + "\n", "--json")
            self.assertEqual(run.status, 0, run.err)
            return run.json["drive"]
        by_mesh = rated("{ sun_planet = 1.1, planet_ring2 = 1.3 }")["meshes"]
        for name, factor in (("sun_planet", "1.1"), ("planet_ring", "1"), ("planet_ring2", "1.3")):
            self.assertEqual(by_mesh[name]["rating"], rated(factor)["meshes"][name]["rating"], name)
        drive = rated('"computed"', DRAFT + "pin_error_um = [10, 0, 0]\n")
        factors = [mesh["rating"]["K_gamma"] for mesh in drive["meshes"].values()]
        self.assertEqual(factors, drive["load"]["sets"][0]["mesh_load_factors"])
        self.assertGreater(max(factors) - min(factors), 0.01)
        take = Run("drive", three + DRAFT + rating + '"computed"\n', "--take", "1")
        self.assertIn("mesh_load_factor = 1.", take.out)
        for factor, words in (("{ sun_ring = 1.1 }", "such meshes are sun_planet, planet_ring and planet_ring2"),
                              ('"computed"', "needs the table [load]"), ('"auto"', 'or "computed"'),
                              ("{ sun_planet = 0.5 }", "between 1 and 100")):
            run = Run("rate", three + rating + factor + "\n")
            self.assertEqual(run.status, 1, factor)
            self.assertIn(words, " ".join(run.err.split()), factor)
        pair = Run("rate", "[gear1]\nteeth = 20\nnormal_module_mm = 2\n[gear2]\nteeth = 40\n[rating]\ntorque_Nm = 10\n"
                   "speed_rpm = 100\nquality = 6\nface_load_factor = 1.2\nmaterial = \"16MnCr5\"\n"
                   "mesh_load_factor = { sun_planet = 1.1 }\n")
        self.assertIn("must be a number for a pair", pair.err)


class Messages(unittest.TestCase):
    def test_bad_input_is_explained(self):
        pair = "[gear1]\nteeth = 20\nnormal_module_mm = 2\n[gear2]\nteeth = 40\n[load]\ntorque_Nm = 5\n"
        differential = SET.replace("planets = 3", 'planets = 3\nfixed = []\ninput = ["sun", "ring"]')
        apart = SET.replace("sun = 20", "sun = 19").replace("planet = 25", "planet = 17").replace("ring = 70", "ring = 56")
        for verb, spec, *words in (
                ("load", pair + 'floating = "sun"\n', "load.floating", "[planetary]"),
                ("load", pair + "pin_error_um = 5\n", "load.pin_error_um", "planets of a drive"),
                ("drive", SET.replace("torque_Nm = 60", "") + DRAFT, "load.torque_Nm", "torque_Nm on the input"),
                ("drive", SET + DRAFT + "torque_Nm = 50\n", "load.torque_Nm = 50", "contradicts the torque of 60 N m"),
                ("drive", SET + DRAFT + "torque_Nm = [60, 70]\n", "load.torque_Nm", "must be one number"),
                ("drive", SET + DRAFT + 'floating = "sum"\n', "load.floating", "sun"),
                ("drive", SET + DRAFT + 'floating = "planet"\n', "load.floating", "the central gears"),
                ("drive", SET + DRAFT + "pin_error_um = [1, 2]\n", "load.pin_error_um", "3 pins (3 of planet"),
                ("drive", apart + DRAFT, "load", "gears that do not fit: "),
                ("drive", SET.replace("planets = 3", "planets = 1") + DRAFT + 'floating = "sun"\n', "load.floating", "single planet"),
                ("drive", SET + DRAFT + "driver = 2\n", "load.driver", "--take N"),
                ("drive", STAGE + DRAFT + "pin_error_um = [1, 2]\n", "load.pin_error_um", "has no planets"),
                ("drive", STEPPED + DRAFT.replace("12", "400"), "load.positions = 400", "at most"),
                ("drive", differential + DRAFT, "load", "several inputs"),
        ):
            with self.subTest(words=words):
                run = Run(verb, spec)
                self.assertEqual(run.status, 1, run.out)
                for word in words:
                    self.assertIn(word, run.err)


if __name__ == "__main__":
    unittest.main()
