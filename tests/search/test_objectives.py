"""Tests the objectives efficiency, balance, cost and noise of a search for pairs. The transmission error under load is
tested by test_loaded_designs.

    plain      every combination of module, teeth and helix angle is searched alone, and the
               objectives of the designs on the line of Eq. 11 are computed from the results of the
               verbs pair and rate; the ranking and the Pareto front of these designs follow from
               these numbers
    refused    objectives that need [rating], synonyms, and numbers out of their ranges
    printed    the listing, best.csv and the page contain the objectives
"""
import csv
import io
import math
import unittest

from searching import Run, folder, search, spec, toml

BANDS = {"ratio": [2.2, 2.6], "modules_mm": [2, 2.5], "pinion_teeth": [20, 21], "helix_angles_deg": [0, 13],
         "face_width_modules": 12, "safety_flank_min": 0.6, "safety_root_min": 0.9}
TABLES = """[gear1.material]
name = "18CrNiMo7-6"
[rating]
torque_Nm = 150
speed_rpm = 1480
life_h = 20000
quality = 6
face_load_factor = 1.2
"""
NEW = ("efficiency", "balance", "cost", "noise")
MU = 0.07


def wish(objective, **keys):
    return spec(BANDS | {"friction_coefficient": MU, "objective": objective, "loaded_designs": 0} | keys, TABLES)


def combinations():
    for module in BANDS["modules_mm"]:
        for z1 in range(BANDS["pinion_teeth"][0], BANDS["pinion_teeth"][1] + 1):
            for z2 in range(math.ceil(2.2 * z1 - 1e-9), math.floor(2.6 * z1 + 1e-9) + 1):
                for beta in BANDS["helix_angles_deg"]:
                    yield module, z1, z2, beta


def alone(module, z1, z2, beta, objective="contact_ratio"):
    """Returns the design of one combination, or None, and its spec as a pair."""
    text = wish(objective, modules_mm=module, pinion_teeth=z1, ratio=[z2 / z1 - 1e-9, z2 / z1 + 1e-9], helix_angles_deg=[beta])
    found = search(text)
    if not found["designs"]:
        return None, None
    take = Run("search", text, "--take", 1, folder=folder())
    return found["designs"][0], take.out


def lines(path, overlap, turn):
    """Returns the length of the contact lines, as the number of teeth in contact."""
    if overlap == 0:
        return sum(0 <= turn + k < path for k in range(-5, 6))
    return sum(max(0, min(turn + k, path) - max(turn + k - overlap, 0)) for k in range(-5, 12)) / overlap


def plain_noise(pair, rating, gears):
    path = pair["contact_ratio_true"] - pair["overlap_ratio"]
    length = [lines(path, pair["overlap_ratio"], (n + 0.5) / 3000) for n in range(3000)]
    force = 2000 * 150 / gears[0]["base_diameter_mm"] / gears[0]["face_width_mm"]
    return force / rating["c_gamma_alpha"] * path * (1 / min(length) - 1 / max(length))


def plain_objectives(text):
    """Returns the objectives of a pair, computed from the results of other verbs."""
    where = folder()
    run = Run("pair", text, "--json", folder=where, name="pair.toml")
    pair, gears = run.json["pair"], run.json["gears"]
    rating = Run("rate", text, "--json", folder=where, name="pair.toml").json["rating"]
    flank = (min(rating["S_H"]) / BANDS["safety_flank_min"]) ** 2
    roots = [s / BANDS["safety_root_min"] for s in rating["S_F"]]
    mass = 0
    for g in gears:
        middle = (g["tip_diameter_mm"] + g["root_diameter_mm"]) / 2
        mass += 7.83e-6 * math.pi / 4 * middle ** 2 * g["face_width_mm"]
    d_1 = gears[0]["reference_diameter_mm"]
    return {"efficiency": pair["efficiency"]["gear1_drives"], "balance": max([flank] + roots) / min([flank] + roots),
            "cost": mass * math.sqrt(gears[0]["face_width_mm"] / d_1), "mass": mass, "noise": plain_noise(pair, rating, gears)}


class Plain(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.designs = {}
        for key in combinations():
            design, text = alone(*key)
            if design and design["point"] == "eq11":
                cls.designs[key] = plain_objectives(text)

    @staticmethod
    def key(design):
        return (design["module_mm"], *design["teeth"], design["helix_angle_deg"][0])

    @staticmethod
    def cost(name, values):
        return -values[name] if name == "efficiency" else values[name]

    def balanced(self, objective):
        found = search(wish(objective))
        return found, [d for d in found["designs"] if d["point"] == "eq11"]

    def test_each_objective_ranks(self):
        self.assertGreater(len(self.designs), 20)
        for name in NEW:
            found, rows = self.balanced(name)
            self.assertEqual({self.key(d) for d in rows}, set(self.designs), name)
            column = {"cost": "relative_cost", "noise": "noise_um"}.get(name, name)
            # The sampling of the noise has an error.
            near = 0.01 if name == "noise" else 1e-9
            costs = [self.cost(name, self.designs[self.key(d)]) for d in rows]
            for before, after in zip(costs, costs[1:]):
                self.assertLessEqual(before, after + 2 * near, name)
            for d in rows:
                self.assertAlmostEqual(d["objective"], self.designs[self.key(d)][name], delta=near, msg=f"{name} {self.key(d)}")
                self.assertEqual(d[column], d["objective"])

    def test_fronts_of_two_and_three(self):
        sizes = []
        for names in (["cost", "efficiency"], ["balance", "cost"], ["efficiency", "balance", "mass"]):
            found, _ = self.balanced(names)
            front = {self.key(found["designs"][i]) for i in found["pareto"]}
            costs = {key: [self.cost(n, v) for n in names] for key, v in self.designs.items()}
            best = {a for a, mine in costs.items() if not any(
                all(x <= y + 1e-10 for x, y in zip(its, mine)) and any(x < y - 1e-10 for x, y in zip(its, mine))
                for b, its in costs.items() if b != a)}
            self.assertEqual(front, best, names)
            sizes.append(len(front))
        self.assertGreater(max(sizes), 2)  # one design may be the best in both balance and cost

    def test_whole_overlap_is_quiet(self):
        found = search(wish("noise", face_width_modules=None, helix_angles_deg=[0, 13], face_width_mm=27.93, modules_mm=[2]))
        first = found["designs"][0]
        self.assertAlmostEqual(first["overlap_ratio"], 1.0, delta=2e-3)
        self.assertLess(first["noise_um"], 0.02)
        spur = [d for d in found["designs"] if d["overlap_ratio"] == 0]
        self.assertGreater(min(d["noise_um"] for d in spur), 1.0)

    def test_exponent_0_is_the_mass(self):
        for d in search(wish("cost", cost_exponent=0))["designs"]:
            self.assertEqual(d["relative_cost"], d["mass_kg"])


class Refused(unittest.TestCase):
    def no(self, text, key, *words):
        run = Run("search", text, "--json", folder=folder())
        self.assertEqual(run.json["error"]["key"], key, run.err)
        for word in words:
            self.assertIn(word, run.json["error"]["message"])

    def test_by_key(self):
        bare = {k: v for k, v in BANDS.items() if not k.startswith("safety")}
        for name in ("balance", "noise"):
            self.no(spec(bare | {"objective": name}), "search.objective", "[rating]")
            self.no(spec(bare | {"objective": ["mass", name]}), "search.objective", "[rating]")
            self.no("[search]\nobjective = " + toml(name) + "\n", "search.ratio", "rating (")
            crossed = bare | {"objective": name, "shaft_angle_deg": 90, "helix_angles_deg": [45]}
            self.no(spec(crossed, TABLES), "search.objective", name, "crossed axes")
        for name in ("efficiency", "cost"):
            self.assertGreater(search(spec(bare | {"objective": name}))["feasible_count"], 0)
        for wrong, near in (("loss", "efficiency"), ("quiet", "noise"), ("price", "cost"), ("balanced", "balance"), ("noize", "noise")):
            self.no(spec(bare | {"objective": wrong}), "search.objective", f"did you mean {near}?")
        self.no(wish("efficiency", friction_coefficient=1), "search.friction_coefficient")
        self.no(wish("efficiency", friction_coefficient=-0.1), "search.friction_coefficient")
        self.no(wish("cost", cost_exponent=-1), "search.cost_exponent")

    def test_default_friction(self):
        def losses(mu):
            return [1 - d["efficiency"] for d in search(wish("efficiency", friction_coefficient=mu))["designs"]]
        self.assertEqual(losses(None), losses(0.05))
        self.assertNotIn("efficiency", search(wish("mass", friction_coefficient=None))["designs"][0])
        self.assertIn("efficiency", search(wish("mass"))["designs"][0])


class Printed(unittest.TestCase):
    def test_listing_and_files(self):
        run = Run("search", wish(list(NEW)), "--out", "found", folder=folder())
        self.assertEqual(run.status, 0, run.err)
        for word in ("η", "R_max/R_min", "relative", "δ_pp"):
            self.assertIn(word, run.out)
        rows = list(csv.DictReader(io.StringIO((run.folder / "found/best.csv").read_text())))
        for column in ("efficiency", "balance", "relative_cost", "noise_um"):
            self.assertTrue(all(float(row[column]) > 0 for row in rows), column)
        page = (run.folder / "found/report.html").read_text()
        for words in ("balance of the load reserves", "relative cost", "estimated transmission error under load", "efficiency"):
            self.assertIn(words, page)


if __name__ == "__main__":
    unittest.main()
