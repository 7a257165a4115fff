"""Compares the deflection of helical teeth along the face width with finite elements of CalculiX
(tests/oracle/bricks)."""
import importlib.util
import json
import unittest

from cli import SOURCE, Run

FROM = SOURCE / "tests/oracle/bricks/tooth_bricks.py"
# Limit of the error relative to the greatest value of the row. This value is under the load, where a strip
# replaces the loaded elements.
OF_ALL = 0.02
# m_n from the middle of the load. Farther away, strip and loaded elements give the same result.
AWAY = 1.25
OF_AWAY = 0.05  # limit of the error there, relative to the greatest value there
MODULE = 3.0
MODULUS = 200000.0


def bricks():
    spec = importlib.util.spec_from_file_location("tooth_bricks", FROM)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def probes(data, gear):
    """Returns E u m_n / F as the program computes it, with a row for each load."""
    half = data["face_width"] / 2
    text = f"""
[gear1]
teeth = {data["teeth"]}
normal_module_mm = {MODULE}
helix_angle_deg = {gear["helix_angle_deg"]}
rack = "{data["rack"]}"
face_width_mm = {data["face_width"] * MODULE}
bore = {{ diameter_mm = {gear["bore_diameter"] * MODULE} }}
material = {{ youngs_modulus_MPa = {MODULUS}, poisson_ratio = {data["poisson_ratio"]} }}
"""
    for load in gear["loads"]:
        text += f"""
[[load.probe]]
diameter_mm = {load["diameter"] * MODULE}
z_mm = {[(z - half) * MODULE for z in load["z"]]}
read_z_mm = {[(z - half) * MODULE for z in data["read_z"]]}
"""
    run = Run("load", text, "--json")
    if run.status:
        raise AssertionError(run.err)
    return [[1e-3 * MODULUS * MODULE * u for u in p["profile_um_per_N"]] for p in run.json["load"]["probes"]]


class Bricks(unittest.TestCase):
    def test_the_program_agrees(self):
        data = json.loads(FROM.with_suffix(".json").read_text())
        for gear in data["gears"]:
            for load, row in zip(gear["loads"], probes(data, gear)):
                middle = sum(load["z"]) / 2
                far = [abs(z - middle) >= AWAY for z in data["read_z"]]
                error = [abs(a - b) for a, b in zip(row, load["strip"])]
                of_all = max(error) / max(load["strip"])
                of_away = max(e for e, f in zip(error, far) if f) / max(u for u, f in zip(load["bumps"], far) if f)
                where = f"{gear['helix_angle_deg']} deg, d = {load['diameter']:.2f} m_n, z = {load['z']}"
                print(f"{where}: {100 * of_all:.1f} % of the greatest value, {100 * of_away:.1f} % away from the load")
                with self.subTest(where):
                    self.assertLess(of_all, OF_ALL)
                    self.assertLess(of_away, OF_AWAY)

    def test_calculix_gives_the_data_again(self):
        oracle = bricks()
        if not oracle.installed():
            self.skipTest("ccx is not installed (Debian: calculix-ccx)")
        data = json.loads(FROM.with_suffix(".json").read_text())
        kept = data["gears"][-1]
        anew = oracle.made(kept["helix_angle_deg"], oracle.LOADS[:1])
        self.assertEqual(anew["unknowns"], kept["unknowns"])
        for a, b in zip(anew["loads"][0]["bumps"], kept["loads"][0]["bumps"]):
            self.assertAlmostEqual(a, b, delta=1e-4 * b)


if __name__ == "__main__":
    unittest.main()
