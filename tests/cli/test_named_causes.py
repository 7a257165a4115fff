"""Tests that a message names the key that causes the error, its value, and a remedy that leads to a valid spec."""
import re
import subprocess
import unittest

from cli import BIN, SOURCE, Run

GEAR = "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 10\n"
PAIR = "[gear1]\nteeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 25\n{}[gear2]\nteeth = 43\nface_width_mm = 25\n"


class NamedCauses(unittest.TestCase):
    def refused(self, verb, spec, key, *words, value=None, name="case.toml"):
        r = Run(verb, spec, "--json", name=name)
        self.assertEqual(r.status, 1, f"{spec}\n{r.err}")
        self.assertEqual(r.json["error"]["key"], key, r.err)
        if value is not None:
            self.assertEqual(r.json["error"]["value"], value, r.err)
        for word in words:
            self.assertIn(word, r.json["error"]["message"])
        return r

    def test_all_verbs_reject_modifications_that_do_not_fit(self):
        """Regression: gear, pair and measure were green for these modifications, and contact rejected them."""
        for keys, key in (("tip_relief_um = 5000\ntip_relief_start_mm = 44\n", "tip_relief_um"),
                          ("lead_crowning_um = 1e7\n", "lead_crowning_um"),
                          ("tip_relief_um = 100\ntip_relief_start_mm = 300\n", "tip_relief_start_mm")):
            spec = PAIR.format("[gear1.modifications]\n" + keys)
            messages = {self.refused(verb, spec, "gear1.modifications." + key).json["error"]["message"]
                        for verb in ("gear", "pair", "measure", "contact")}
            self.assertEqual(len(messages), 1, messages)
        good = PAIR.format("[gear1.modifications]\ntip_relief_um = 20\ntip_relief_start_mm = 46\n")
        for verb in ("gear", "pair", "measure"):
            self.assertEqual(Run(verb, good).status, 0)

    def test_a_pointed_cutter_is_a_warning(self):
        """Regression: the tip diameter of a separate cutter was reduced without a message."""
        spec = ("[gear1]\nteeth = 17\nnormal_module_mm = 2\nface_width_mm = 20\n[gear2]\nteeth = -60\nface_width_mm = 20\n"
                "cut_by = {{ teeth = 20, tip_diameter_mm = {} }}\n")

        def pointed(tip):
            answer = Run("gear", spec.format(tip), "--json").json
            return [w["message"] for w in answer["warnings"] if w["code"] == "pointed"], answer["gears"][1]
        words, ring = pointed(100)
        # Oracle: s = 0 at d = d_b/cos α with inv α = π/40 + inv 20°, d = 46.1533 mm; the ring is cut to 2 · 40 mm + d.
        self.assertIn("46.1533 mm", words[0])
        self.assertIn("tip_diameter_mm, 100.0000 mm", words[0])
        self.assertAlmostEqual(ring["root_diameter_mm"], 80 + 46.1533, delta=1e-4)
        self.assertEqual(pointed(45)[0], [])

    def test_a_number_that_is_too_large_names_its_key(self):
        """Regression: the message had no key, and for 1e400 the remedy was to leave out the unit."""
        for spec, key, number in ((GEAR.replace("= 2\n", "= 1e400\n"), "gear1.normal_module_mm", "1e400"),
                                  (GEAR.replace("= 20\n", "= 99999999999999999999\n"), "gear1.teeth", "99999999999999999999"),
                                  ("gear1 = { teeth = 20, rack = { addendum = 1e999 } }", "gear1.rack.addendum", "1e999"),
                                  ("[[stage]]\nteeth = [20, 30]\n[[stage]]\nteeth = [20, 1e999]\n", "stage[2].teeth", "1e999")):
            r = self.refused("gear", spec, key, "is too large", "1000000000", value=number)
            self.assertNotIn("unit", r.err)
        # Regression: the path named the entry after the one with this number.
        self.refused("drive", '{"stage": [{"teeth": [20, 30]}, {"teeth": [1e400, 3]}]}', "stage[2].teeth[1]", "is too large",
                     value="1e400", name="case.json")
        self.refused("gear", '{"gear1": {"teeth": [20, 1e400]}}', "gear1.teeth[2]", "is too large", value="1e400", name="case.json")

    def test_a_byte_order_mark_does_not_hide_the_format(self):
        """Regression: JSON with a byte order mark on standard input was read as TOML."""
        text = '\ufeff{"gear1": {"teeth": 20, "normal_module_mm": 2}}'
        p = subprocess.run([BIN, "gear", "-"], input=text.encode(), capture_output=True)
        self.assertEqual(p.returncode, 0, p.stderr)

    def test_texts_of_other_programs_have_a_remedy(self):
        for text, word in ((GEAR + "profile_shift = \u22120.1\n", "write the minus sign as -"),
                           (GEAR.replace("\n", "\r"), "save the file with LF or CR LF"),
                           (GEAR.encode("utf-16-le"), "is UTF-16 text; save it as UTF-8"),
                           (GEAR.encode("utf-16-be"), "is UTF-16 text; save it as UTF-8")):
            r = Run("gear", text if isinstance(text, bytes) else text.encode())
            self.assertEqual(r.status, 1)
            self.assertIn(word, r.err)

    def test_an_empty_key_is_named(self):
        r = self.refused("gear", '"" = 1\n' + GEAR, '""', "unknown key in the file", value="1")
        self.assertIn("case.toml:1:1:", r.err)

    def test_a_reading_without_a_range_is_the_only_missing_value(self):
        """Regression: the message also named the table [scatter.errors], which is present, as missing."""
        r = self.refused("scatter", GEAR + "[gear2]\nteeth = 30\n[scatter.errors]\ncrossing_deg = { distribution = \"normal\" }\n",
                         "scatter.errors.crossing_deg.range")
        self.assertNotIn("also missing", r.err)
        self.refused("scatter", GEAR + "[gear2]\nteeth = 30\n", "scatter.errors", "is missing")

    def test_a_set_without_an_output_names_the_bodies(self):
        """Regression: the messages named the output and the same body, which were not given."""
        planets = "[planetary]\nsun = 20\nplanet = 25\nring = 70\n"
        self.refused("drive", planets + 'fixed = ["ring", "carrier"]\n', "planetary.fixed", "leaves no body for the output", "fix fewer bodies")
        self.assertEqual(Run("drive", planets + 'fixed = ["ring"]\n').status, 0)
        self.refused("drive", "[planetary]\nplanet = 25\nring = 70\n", "planetary.sun", "no default output")
        named = '[planetary]\nplanet = 25\nring = 70\nfixed = "ring"\ninput = "carrier"\noutput = "planet"\n'
        self.assertEqual(Run("drive", named).status, 0)

    def test_a_drive_names_the_place_of_a_key(self):
        two = "[[stage]]\nteeth = [19, 58]\n[[stage]]\nteeth = [17, 61]\n"
        self.refused("drive", two + "speed_rpm = 100\n", "stage[2].speed_rpm", value="100")
        self.refused("drive", two + "torque_Nm = 5\n", "stage[2].torque_Nm", value="5")
        own = "{ teeth = 20, normal_module_mm = 2, cut_by = { teeth = 20 } }"
        self.refused("drive", f"[[stage]]\ngears = [{own}, {{ teeth = 30 }}]\n", "stage[1].gears[1].cut_by",
                     "compute this mesh as a pair")
        graph = '[drive]\ninput = "a"\noutput = "b"\nmesh = [{ gears = ["A", "B"] }]\ngear = [{ name = "A", body = "a", teeth = 20 }]\n'
        self.refused("drive", graph, "drive.gear[1].body", "[[drive.body]]")
        bodies = graph + 'body = [{ name = "a" }, { name = "" }]\n'
        self.refused("drive", bodies, "drive.body[2].name", "at least one character")

    def test_a_list_of_a_stage_has_two_numbers(self):
        """Regression: a list of one number was accepted, and the documents named a list of two numbers only."""
        stage = "[[stage]]\nteeth = [20, 30]\nnormal_module_mm = 2\n"
        for key in ("profile_shift", "thickness_allowance_mm", "bore_mm"):
            for value in ("[1.5]", "[1, 2, 3]"):
                self.refused("drive", stage + f"{key} = {value}\n", "stage[1]." + key)
        for value in ("0.1", "[0.1, 0.1]"):
            self.assertEqual(Run("drive", stage + f"profile_shift = {value}\n").status, 0)

    def test_remedies_name_keys_that_exist(self):
        rating = 'material = "16MnCr5"\n'
        drive = "[[stage]]\nteeth = [20, 30]\nnormal_module_mm = 2\ntorque_Nm = 10\nspeed_rpm = 100\nface_width_mm = 20\n"
        r = Run("rate", drive + "[rating]\n" + rating)
        self.assertIn("for a pair of gears without a drive, a shaft with its bearings in gear1.shaft", r.err)
        r = Run("drive", "[planetary]\nsun = 1\nplanet = 1\nring = 3\nnormal_module_mm = 1\n", "--json")
        self.assertIn("It belongs to a gear that has its own table", r.json["verdict"]["headline"])

    def test_a_cutter_with_too_many_teeth_names_a_possible_number(self):
        """Regression: the error had no value, and the remedy was a cutter without undercut, which the cutter was."""
        spec = "[gear1]\nteeth = 17\nnormal_module_mm = 2\n[gear2]\nteeth = -60\ncut_by = {{ teeth = {} }}\n"
        message = self.refused("pair", spec.format(58), "gear2.cut_by.teeth", value="58").json["error"]["message"]
        teeth = int(message.split("a similar cutter with ")[1].split(" teeth")[0])
        self.assertLess(teeth, 58)
        self.assertEqual(Run("gear", spec.format(teeth)).status, 0)

    def test_a_rack_names_the_radius_that_has_no_dedendum(self):
        """Regression: the message named a dedendum that was not given, and had neither a limit nor a remedy."""
        arcs = (SOURCE / "examples/circular_arc_drive.toml").read_text()
        self.refused("pair", arcs.replace("arc_radius = 1.4\n", "arc_radius = 3\n"), "gear1.rack.dedendum",
                     "no dedendum is possible", "arc_radius would help")

    def test_a_remedy_for_negative_backlash_leaves_none(self):
        """Regression: with the thickness allowance of the remedy, the backlash was -0.0073 mm."""
        arcs = (SOURCE / "examples/circular_arc_drive.toml").read_text()
        spec = arcs.replace("arc_radius = 1.4\n", "arc_radius = 1.5\n") + "\n[pair]\ncenter_distance_mm = 697.17\n"
        headline = Run("pair", spec, "--json").json["verdict"]["headline"]
        self.assertGreater(float(re.search(r"the backlash is (-?[0-9.]+) mm", headline)[1]), -1e-3)

    def test_the_option_of_a_rack_names_the_gear(self):
        r = Run("gear", GEAR, "--as-rack", "3,20")
        self.assertEqual(r.status, 1)
        self.assertIn("--as-rack = 3,20: is not possible for gear 1: the base pitch", r.err)

    def test_a_drive_names_the_entry_and_the_cause(self):
        graph = ('[drive]\ninput = "a"\noutput = "b"\nbody = [{ name = "a" }, { name = "b" }]\n'
                 'gear = [{ name = "A", body = "a", teeth = 20 }, { name = "B", body = "b", teeth = 30 }, { name = "C", body = "a", teeth = 9 }]\n'
                 'mesh = [{ gears = ["A", "B"] }, { gears = ["A", "C"] }]\n')
        self.refused("drive", graph, "drive.mesh[2]", "both gears are on body a")
        riders = ('[drive]\ninput = "s"\noutput = "c"\nfixed = "r"\nbody = [{ name = "s" }, { name = "c" }, { name = "r" }, '
                  '{ name = "p", rides_on = "c", count = 3, positions_deg = [0, 121, 240] }]\n'
                  'gear = [{ name = "S", body = "s", teeth = 20 }, { name = "P", body = "p", teeth = 25 }, '
                  '{ name = "R", body = "r", teeth = -70 }]\nmesh = [{ gears = ["S", "P"] }, { gears = ["P", "R"] }]\n')
        self.refused("drive", riders, "drive.body[4].positions_deg", "cannot be assembled", value="121")
        # Regression: the headline gave the overlap of copies that cannot be assembled, and "at most 4 copies fit" for 3.
        spec = ("[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\nnormal_module_mm = 2\nring2 = 72\n"
                'output = "ring2"\n')
        verdict = Run("drive", spec, "--json").json["verdict"]
        self.assertIn("cannot be assembled", verdict["headline"])
        self.assertNotIn("copies fit", str(verdict))
        ring = Run("drive", "[[stage]]\nteeth = [20, -25]\nnormal_module_mm = 2\n", "--json").json["verdict"]["headline"]
        self.assertIn("(tip_diameter_mm, which a gear with its own table can have)", ring)


if __name__ == "__main__":
    unittest.main()
