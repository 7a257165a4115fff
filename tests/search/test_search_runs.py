"""Tests that listed designs run. The verb pair reports no interference and a positive tip clearance
for them, and their rows keep the margins."""
import unittest

from searching import Asked, Run, folder, search, spec, taken


class WhatRuns(Asked):
    """With the default limits, every listed design runs according to the verb pair."""
    DRAWN = {"ratio": [1.95, 2.05], "center_distance_mm": [99, 101], "modules_mm": "ISO54-I", "pinion_teeth": [14, 40]}
    WISH = DRAWN | {"mounting": "extended"}
    TIGHT = {"ratio": [1.9, 2.1], "center_distance_mm": [99, 101], "modules_mm": [1.25, 2, 3, 3.5, 4, 4.5, 5, 6],
             "pinion_teeth": [10, 60], "mounting": "tight"}
    FREE = {"ratio": [1, 6], "center_distance_mm": 100, "modules_mm": [2, 3, 5], "pinion_teeth": [10, 40], "mounting": "extended"}

    def runs(self, text, ranks):
        for rank in ranks:
            pair = taken(text, rank)["pair"]
            self.assertEqual(pair["interference"], [], f"rank {rank}")
            self.assertGreater(min(pair["tip_clearance_mm"]), 0)

    def test_the_wish_of_the_quickstart(self):
        text = spec(self.WISH)
        found = search(text)
        self.assertEqual(found["margins"], {"interference": "exclude", "tip_clearance_min": 0.02, "form_clearance_min": 0.02})
        self.runs(text, range(1, len(found["designs"]) + 1))
        drawn = search(spec(self.DRAWN))
        self.assertEqual([drawn["margins"][key] for key in ("tip_clearance_min", "mounting")], [0.1, "tight"])
        self.runs(spec(self.DRAWN), range(1, len(drawn["designs"]) + 1))
        flagged = search(spec(self.WISH, interference="flag"))
        self.assertEqual(flagged["margins"], {"interference": "flag", "tip_clearance_min": None, "form_clearance_min": 0})
        self.assertTrue(any(row["interference"] for row in flagged["designs"]))
        self.assertLess(found["feasible_count"], flagged["feasible_count"])
        self.assertEqual(search(spec(self.WISH, avoid_interference=False))["designs"], flagged["designs"])
        self.assertEqual(search(spec(self.WISH, avoid_interference=True))["designs"], found["designs"])

    def test_tight_centres_and_a_distance(self):
        for keys, least in ((self.TIGHT, 50), (self.FREE, 200)):
            text = spec(keys)
            rows = search(text)["designs"]
            self.assertGreater(len(rows), least)
            self.runs(text, sorted({1, 2, 3, len(rows)} | set(range(4, len(rows), max(1, len(rows) // 25)))))

    def test_margins_are_kept_and_may_be_0(self):
        for keys in (self.WISH, self.TIGHT):
            areas = []
            for margin in (0, 0.02, 0.1):
                rows = search(spec(keys, tip_clearance_min=margin, form_clearance_min=margin))["designs"]
                for row in rows:
                    m = row["module_mm"]
                    self.assertGreaterEqual(min(row["tip_clearance_mm"]), (margin - 1e-9) * m)
                    self.assertGreaterEqual(min(row["form_clearance_path_mm"]), (margin - 1e-9) * m)
                areas.append(sum(row["region"]["area"] for row in rows))
            self.assertLess(areas[2], areas[0])

    def test_contradictions(self):
        for keys, key in (({"interference": "flag", "form_clearance_min": 0.02}, "form_clearance_min"),
                          ({"interference": "flag", "avoid_interference": True}, "avoid_interference"),
                          ({"interference": "allow"}, "interference")):
            r = Run("search", spec(self.WISH | keys), "--json", folder=folder())
            self.assertEqual([r.status, r.json["error"]["key"]], [1, f"search.{key}"])

    def test_the_effective_contact_ratio_ranks(self):
        rows = search(spec(self.WISH, interference="flag"))["designs"]
        ratios = [row["contact_ratio_true"] for row in rows if row["point"] == "eq11"]
        self.assertEqual(ratios, sorted(ratios, reverse=True))
        deep = search(spec(self.WISH, interference="flag", objective="formula_contact_ratio"))["designs"]
        self.assertTrue(deep[0]["interference"])


if __name__ == "__main__":
    unittest.main()
