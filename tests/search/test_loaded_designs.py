"""Tests the transmission error under load of the best designs of a search by noise.

    value      loaded_noise_um is that of the verb load for the spec that --take prints
    order      the designs are sorted by it, for any --top and any number of threads; if noise is
               not the first objective, the order and the Pareto front do not change
    failures   a design without a value has the reason in the warnings and in the listing
"""
import csv
import io
import math
import unittest

from searching import Run, duckdb, folder, search, spec

KEYS = {"ratio": [2.2, 2.6], "modules_mm": [2], "pinion_teeth": [20, 21], "helix_angles_deg": [0, 13], "face_width_modules": 12,
        "safety_flank_min": 0.6, "safety_root_min": 0.9, "objective": "noise", "loaded_designs": 2}
TABLES = """[gear1.material]
name = "18CrNiMo7-6"
[rating]
torque_Nm = 150
speed_rpm = 1480
life_h = 20000
quality = 6
face_load_factor = 1.2
"""
QUICK = '[load]\naccuracy = "draft"\npositions = 8\nslices = 8\n'


def text(load=QUICK, **keys):
    return spec(KEYS | keys, TABLES + load)


def by_load(given, rank):
    """Returns the greatest peak to peak along the line of action, µm, over the torques of the verb load."""
    take = Run("search", given, "--take", rank, folder=folder())
    load = Run("load", take.out, "--json", folder=take.folder, name="pair.toml")
    gear = Run("gear", take.out, "--json", folder=take.folder, name="pair.toml").json["gears"][1]
    angles = [math.radians(t["peak_to_peak_arcsec"] / 3600) for t in load.json["load"]["torques"]]
    return 1e3 * max(angles) * gear["base_diameter_mm"] / 2


class Loaded(unittest.TestCase):
    def near(self, a, b):
        self.assertAlmostEqual(a, b, delta=1e-9 * b)

    def test_value_is_that_of_load(self):
        for given, count in ((text(), 2), (text(QUICK + "torque_Nm = [40, 300]\n", objective=["noise", "mass"], loaded_designs=1), 1),
                             (text(QUICK + "[errors]\ncrossing_deg = 0.02\n", loaded_designs=1), 1)):
            rows = search(given)["designs"]
            values = [row["loaded_noise_um"] for row in rows]
            self.assertEqual(values[count:], [None] * (len(rows) - count))
            for rank in range(count):
                self.near(values[rank], by_load(given, rank + 1))

    def test_order(self):
        rows = search(text())["designs"]
        plain = search(text(loaded_designs=0))["designs"]
        self.assertNotIn("loaded_noise_um", plain[0])
        estimate = [row["trial"] for row in plain]
        trials = [row["trial"] for row in rows]
        self.assertEqual(set(trials[:2]), set(estimate[:2]))
        self.assertEqual(trials[2:], estimate[2:])
        values = [row["loaded_noise_um"] for row in rows[:2]]
        self.assertEqual(values, sorted(values))
        for args in (("--top", 1), ("--threads", 1, "--top", 3)):
            fewer = search(text(), *args)["designs"]
            self.assertEqual(fewer, rows[:len(fewer)], args)

    def test_other_first_objective_keeps_its_order(self):
        given = {"objective": ["mass", "noise"], "loaded_designs": 1}
        found, plain = search(text(**given)), search(text(**given | {"loaded_designs": 0}))
        self.assertEqual([row["trial"] for row in found["designs"]], [row["trial"] for row in plain["designs"]])
        self.assertEqual(found["pareto"], plain["pareto"])
        self.assertEqual(sum(row["loaded_noise_um"] is not None for row in found["designs"]), 1)

    def test_files(self):
        run = Run("search", text(), "--out", "found", "--top", 1, folder=folder())
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("The transmission error under load is computed for the first 2 designs", " ".join(run.out.split()))
        rows = list(csv.DictReader(io.StringIO((run.folder / "found/best.csv").read_text())))
        self.assertEqual(len(rows), 1)
        every = duckdb(run.folder / "found/search.parquet", "select loaded_noise_um as x from data where loaded_noise_um is not null")
        self.assertEqual(len(every), 2)
        self.assertEqual(float(rows[0]["loaded_noise_um"]), min(row["x"] for row in every))

    def test_failures(self):
        given = text('[load]\nslices = 128\ntorque_Nm = 0.001\n')
        run = Run("search", given, "--json", folder=folder())
        self.assertEqual({row["loaded_noise_um"] for row in run.json["search"]["designs"]}, {None})
        reasons = [w["message"] for w in run.json["warnings"] if w["code"] == "no_load"]
        self.assertEqual(len(reasons), 2)
        for reason in reasons:
            self.assertRegex(reason, r"module 2, 21:\d\d teeth: load.slices = 128: ")
        listing = " ".join(Run("search", given, folder=folder()).out.split())
        self.assertIn(" ".join(reasons[0].split()), listing)

    def test_key(self):
        wrong = Run("search", text(objective="mass"), "--json", folder=folder())
        self.assertEqual(wrong.json["error"]["key"], "search.loaded_designs")
        self.assertIn("noise", wrong.json["error"]["message"])


if __name__ == "__main__":
    unittest.main()
