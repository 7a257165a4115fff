"""Tests searches for drives. The listed values are those that the verb drive computes for the spec that
--take writes."""
import json
import unittest

from searching import Run, folder, spec

SET = {"kind": "planetary", "ratio": [4.4, 4.6], "planets": [3, 4], "sun_teeth": [15, 24], "normal_module_mm": 2,
       "objective": ["efficiency", "size"]}
SMALL_SUNS = {"kind": "planetary", "ratio": [4.8, 5.2], "sun_teeth": [10, 16], "normal_module_mm": 2,
              "thickness_allowance_mm": -0.05}
TRAIN = {"kind": "train", "ratio": [11.9, 12.1], "pinion_teeth": [17, 19], "wheel_teeth": [55, 70], "objective": "size"}


class DriveSearch(unittest.TestCase):
    def test_taken_specs_have_the_listed_numbers(self):
        for keys in (SET, TRAIN):
            where = folder(spec(keys))
            found = Run("search", None, "--json", folder=where)
            self.assertEqual(found.status, 0, found.err)
            search = found.json["search"]
            self.assertEqual(search["tested"], sum(search["rejected"].values()) + search["feasible_count"])
            for place in (1, len(search["designs"])):
                taken = Run("search", None, "--take", str(place), folder=where)
                again = folder(taken.out)
                drive = Run("drive", None, "--json", folder=again).json["drive"]
                design = search["designs"][place - 1]
                for key in ("ratio", "ratio_exact", "efficiency"):
                    self.assertEqual(design[key], drive[key], key)
                expanded = folder(Run("drive", None, "--expand", folder=again).out)
                graph = Run("drive", None, "--json", folder=expanded).json["drive"]
                self.assertEqual(json.dumps(graph["meshes"]), json.dumps(drive["meshes"]))

    def test_small_suns_are_not_undercut(self):
        where = folder(spec(SMALL_SUNS))
        found = Run("search", None, "--json", "--top", "100", folder=where).json["search"]
        self.assertGreater(len(found["designs"]), 10)
        gears = {(design["teeth"][member], design["profile_shift"][member])
                 for design in found["designs"] for member in ("sun", "planet")}
        for teeth, shift in gears:
            keys = f"teeth = {teeth}\nnormal_module_mm = 2\nprofile_shift = {shift}\nthickness_allowance_mm = -0.05\n"
            gear = Run("gear", "[gear1]\n" + keys, "--json", folder=folder()).json["gears"][0]
            self.assertFalse(gear["undercut"], keys)
        for place in range(1, len(found["designs"]) + 1):
            taken = Run("search", None, "--top", "100", "--take", str(place), folder=where)
            drive = Run("drive", None, "--json", folder=folder(taken.out)).json
            design = found["designs"][place - 1]
            self.assertEqual(drive["verdict"]["level"], "green")
            self.assertEqual(drive["drive"]["coaxial"]["profile_shift"], design["profile_shift"])
            self.assertAlmostEqual(drive["drive"]["center_distance_mm"], design["center_distance_mm"], delta=1e-9)

    def test_threads_do_not_matter(self):
        where = folder(spec(SET))
        one, two = (Run("search", None, "--json", "--threads", n, folder=where).out for n in ("1", "3"))
        self.assertEqual(one, two)

    def test_a_life_uses_the_speed_of_the_search(self):
        keys = SET | {"speed_rpm": 1500, "torque_Nm": 60, "face_width_mm": [10, 60], "safety_root_min": 1.4}
        rating = "\n[rating]\nlife_h = 10000\nquality = 6\nface_load_factor = 1.2\n[rating.material]\nname = \"16MnCr5\"\n"
        found = Run("search", None, "--json", "--top", "1", folder=folder(spec(keys, rating)))
        self.assertEqual(found.status, 0, found.err)
        with_speed = Run("search", None, "--json", "--top", "1", folder=folder(spec(keys, rating.replace("[rating]", "[rating]\nspeed_rpm = 1500"))))
        self.assertEqual(found.json["search"]["designs"], with_speed.json["search"]["designs"])

    def test_a_greatest_size(self):
        whole, limited = (Run("search", None, "--json", folder=folder(spec(SET | keys | {"objective": "size"}))).json["search"]
                          for keys in ({}, {"size_max_mm": 150}))
        self.assertEqual(limited["rejected"]["size"], whole["feasible_count"] - limited["feasible_count"])
        self.assertGreater(limited["rejected"]["size"], 0)
        self.assertLessEqual(max(d["size_mm"] for d in limited["designs"]), 150)

    def test_the_unit_of_the_size_is_the_module_if_none_is_given(self):
        """The sets without a module have sizes in modules, also in inch specs."""
        keys = {"kind": "planetary", "ratio": 4, "sun_teeth": 20, "planet_teeth": 20, "ring_teeth": 60, "planets": 4}
        for top in ("", 'units = "inch"\n'):
            where = folder(top + spec(keys))
            design = Run("search", None, "--json", folder=where).json["search"]["designs"][0]
            self.assertEqual(design["size_modules"], 62.5)
            self.assertIsNone(design.get("size_mm", design.get("size_in")))
            self.assertIn("modules", Run("search", None, folder=where).out)
        with_module = Run("search", None, "--json", folder=folder(spec(keys | {"normal_module_mm": 2}))).json["search"]["designs"][0]
        self.assertEqual((with_module["size_mm"], with_module["size_modules"]), (125, None))

    def test_advice_names_the_key_that_helps(self):
        train = {"kind": "train", "ratio": -4, "stages": 1, "pinion_teeth": 20, "normal_module_mm": 2}
        said = Run("search", None, folder=folder(spec(train | {"size_max_mm": 10}))).out
        self.assertIn("greater than size_max_mm", said)
        self.assertNotIn("spacing", said)
        said = Run("search", None, folder=folder(spec(train | {"backlash_mm": 20}))).out
        self.assertIn("a smaller backlash_mm", said)

    def test_noise_ranks(self):
        names = ["noise", "size", "efficiency"]
        found = Run("search", None, "--json", folder=folder(spec(SET | {"objective": names}))).json["search"]
        designs = found["designs"]
        noise = [d["noise"] for d in designs]
        self.assertEqual(noise, sorted(noise))
        self.assertEqual(designs[0]["phasing"], "sequential")
        costs = [(d["noise"], d["size_mm"], -d["efficiency"]) for d in designs]
        front = [i for i, a in enumerate(costs) if not any(b != a and all(x <= y for x, y in zip(b, a)) for b in costs)]
        self.assertEqual(found["pareto"], front)
        self.assertIn("ΔΘ/Θ", Run("search", None, folder=folder(spec(SET | {"objective": names}))).out)
        plain = Run("search", None, "--json", folder=folder(spec(SET))).json["search"]["designs"][0]
        self.assertIsNone(plain["noise"])

    def test_a_centre_distance(self):
        train = {**TRAIN, "normal_module_mm": [1.75, 2], "center_distance_mm": [78, 80]}
        where = folder(spec(train))
        search = Run("search", None, "--json", folder=where).json["search"]
        self.assertEqual(search["tested"], sum(search["rejected"].values()) + search["feasible_count"])
        self.assertGreater(len(search["designs"]), 3)
        for place, design in enumerate(search["designs"], 1):
            taken = Run("search", None, "--take", str(place), folder=where)
            drive = Run("drive", None, "--json", folder=folder(taken.out)).json
            self.assertEqual(drive["verdict"]["level"], "green")
            distances = [mesh["pair"]["center_distance_mm"] for mesh in drive["drive"]["meshes"].values()]
            for a, listed in zip(distances, design["stage_center_distances_mm"], strict=True):
                self.assertAlmostEqual(a, listed, delta=1e-9)
                self.assertTrue(78 - 1e-9 < a < 80 + 1e-9, distances)
        none = Run("search", None, folder=folder(spec(train | {"center_distance_mm": 10})))
        self.assertIn("center_distance_mm", none.out + none.err)

    def test_what_a_search_cannot_be(self):
        for keys, key in (({"sun2_teeth": 20}, "search.sun2_teeth"), ({"stages": 2}, "search.stages"),
                          ({"kind": "conical"}, "search.kind"), ({"output": "ring"}, "search.output"),
                          ({"ratio": [5, 4]}, "search.ratio"), ({"size_max_mm": -1}, "search.size_max_mm"),
                          ({"normal_module_mm": None, "size_max_mm": 100}, "search.size_max_mm"),
                          ({"center_distance_mm": 80}, "search.center_distance_mm"),
                          ({"objective": "colour"}, "search.objective"), ({"objective": "torque_ripple"}, "search.objective")):
            refused = Run("search", None, "--json", folder=folder(spec(SET | keys)))
            self.assertEqual((refused.status, refused.json["error"]["key"]), (1, key), refused.err)
        for keys in ({"normal_module_mm": 2, "profile_shift": 0, "center_distance_mm": 80}, {"center_distance_mm": 80},
                     {"normal_module_mm": 2, "center_distance_mm": [90, 80]},
                     {"normal_module_mm": 2, "center_distance_mm": 0},
                     {"normal_module_mm": 2, "center_distance_mm": [80, 85, 90]}):
            refused = Run("search", None, "--json", folder=folder(spec(TRAIN | keys)))
            self.assertEqual(refused.json["error"]["key"].split("[")[0], "search.center_distance_mm", refused.err)
        folder_wanted = Run("search", None, "--out", "o", folder=folder(spec(SET)))
        self.assertEqual(folder_wanted.status, 2)
        self.assertIn("--json", folder_wanted.err)


if __name__ == "__main__":
    unittest.main()
