"""Tests reliefs without a given start. They are short reliefs, so the reliefs of both gears leave one
base pitch of the path.

closed form   the start diameters agree with those computed from the printed line of action
law           without load, such a pair has no transmission error, but with longer reliefs it has one
refused       a single gear and crossed axes
"""
import math
import re
import unittest

from cli import Asked, Run

GEARS = """[gear1]
teeth = {z1}
normal_module_mm = 2
helix_angle_deg = {beta}
profile_shift = 0.2
face_width_mm = 20
{gear1}
[gear2]
teeth = {z2}
helix_angle_deg = {mate}
profile_shift = 0.1
face_width_mm = 20
{gear2}
"""


def pair(gear1="", gear2="", z1=23, z2=61, beta=0.0):
    return GEARS.format(z1=z1, z2=z2, beta=beta, mate=-beta if z2 > 0 else beta, gear1=gear1, gear2=gear2)


def table(gear, rest):
    return f"[gear{gear}.modifications]\n{rest}\n"


class Starts(Asked):
    def drawn(self, text):
        """Returns the start diameters in the report, by gear and relief."""
        run = Run("run", text, "--out", "made", "--only", "report")
        if run.status == 2:
            run = Run("run", text, "--out", "made")
        self.assertEqual(run.status, 0, run.err)
        page = (run.folder / "made/report.html").read_text()
        found = re.findall(r"gear (\d): ([^<]*from diameter[^<]*)", page)
        return {int(gear): dict(re.findall(r"(tip relief|root relief) [\d.]+\s?µm from diameter ([\d.]+)", words))
                for gear, words in found}

    def expected(self, text):
        """Returns the start diameters computed from the result of the verb pair: (ε_α − 1) p_bt/2 from
        each end."""
        answer = self.ok("pair", text)
        line, gears = answer["pair"], answer["gears"]
        d_b = [g["base_diameter_mm"] for g in gears]
        rho = [[math.sqrt((d / 2) ** 2 - (b / 2) ** 2) for d in (g["tip_form_diameter_mm"],)][0] for g, b in zip(gears, d_b)]
        p_bt = math.pi * d_b[0] / abs(gears[0]["teeth"])
        a, alpha = line["center_distance_mm"], math.acos(abs(d_b[1] + math.copysign(1, gears[1]["teeth"]) * d_b[0]) / 2 / line["center_distance_mm"])
        n = a * math.sin(alpha)
        ring = gears[1]["teeth"] < 0
        end = rho[0]
        begin = rho[1] - n if ring else n - rho[1]
        length = (end - begin - p_bt) / 2
        where = {1: {"tip relief": end - length, "root relief": begin + length},
                 2: {"tip relief": begin + length, "root relief": end - length}}
        def diameter(gear, rho_1):
            r = rho_1 if gear == 1 else (n + rho_1 if ring else n - rho_1)
            return 2 * math.hypot(d_b[gear - 1] / 2, r)
        return {g: {name: diameter(g, x) for name, x in names.items()} for g, names in where.items()}

    def test_closed_form(self):
        both = "tip_relief_um = 12\nroot_relief_um = 5"
        for keys in ({}, {"beta": 15.0}, {"z1": 40, "z2": 41}):
            text = pair(table(1, both), table(2, both), **keys)
            want, got = self.expected(text), self.drawn(text)
            self.assertEqual(set(got), {1, 2})
            for gear in (1, 2):
                for name in ("tip relief", "root relief"):
                    self.assertAlmostEqual(float(got[gear][name]), want[gear][name], delta=2e-6 * want[gear][name])

    def test_short_reliefs_are_free_of_transmission_error(self):
        short = "tip_relief_um = 12"
        text = pair(table(1, short), table(2, short))
        self.assertLess(self.ok("contact", text)["contact"]["peak_to_peak_arcsec"], 1e-6)
        starts = self.expected(text)
        longer = [f"tip_relief_um = 12\ntip_relief_start_mm = {starts[g]['tip relief'] - 0.1}" for g in (1, 2)]
        self.assertGreater(self.ok("contact", pair(table(1, longer[0]), table(2, longer[1])))["contact"]["peak_to_peak_arcsec"], 0.1)

    def test_a_start_that_is_given_stays(self):
        given = table(1, "tip_relief_um = 12\ntip_relief_start_mm = 49")
        self.assertEqual(self.drawn(pair(given))[1]["tip relief"], "49")

    def test_refused(self):
        alone = "[gear1]\nteeth = 23\nnormal_module_mm = 2\n" + table(1, "tip_relief_um = 12")
        run = Run("gear", alone, "--json")
        self.assertEqual([run.status, run.json["error"]["key"]], [1, "gear1.modifications.tip_relief_start_mm"])
        crossed = ("[gear1]\nteeth = 20\nnormal_module_mm = 2\nhelix_angle_deg = 45\n" + table(1, "tip_relief_um = 12") +
                   "[gear2]\nteeth = 30\nhelix_angle_deg = 45\n[pair]\nshaft_angle_deg = 90\n")
        run = Run("contact", crossed, "--json")
        self.assertEqual([run.status, run.json["error"]["key"]], [1, "gear1.modifications.tip_relief_start_mm"])
        self.assertIn("parallel axes", run.json["error"]["message"])
        length = Run("contact", pair(table(1, "end_relief_um = 12")), "--json")
        self.assertEqual(length.json["error"]["key"], "gear1.modifications.end_relief_length_mm")


if __name__ == "__main__":
    unittest.main()
