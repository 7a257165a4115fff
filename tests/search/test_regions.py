"""Tests regions of profile shifts by comparing random points with the pairs that have these shifts."""
import json
import math
import random
import subprocess
import unittest

from searching import BIN, search


class Regions(unittest.TestCase):
    def test_the_region_of_an_internal_pair_holds_the_pairs_that_run(self):
        """The verb pair judges pairs with random shifts. The pairs that run are those inside the boundary
        of the region, and their share gives the area."""
        found = search('[search]\nratio = [-3.01, -3]\nmodules_mm = [2]\npinion_teeth = [22, 22]\nmounting = "tight"\n')["designs"][0]
        region, m = found["region"], 2.0
        sides = [side for e in region["edges"] for side in zip(e["points"], e["points"][1:])]
        box = ((-0.3, 1.05), (-2.5, 1.2))
        draw = random.Random(66)
        points = [tuple(draw.uniform(*ends) for ends in box) for _ in range(1000)]
        gear = lambda z, x: {"teeth": z, "normal_module_mm": m, "profile_shift": x, "face_width_mm": 20}
        lines = "".join(json.dumps({"gear1": gear(22, x[0]), "gear2": gear(-66, x[1])}) + "\n" for x in points)
        done = subprocess.run([BIN, "batch", "pair"], input=lines, capture_output=True, text=True, check=False)
        least_x1 = 1 - 11 * math.sin(math.radians(20)) ** 2
        inside = 0
        differ = []
        for x, line in zip(points, done.stdout.splitlines(), strict=True):
            answer = json.loads(line)
            runs = False
            if "error" not in answer:  # an error means that there is no working pressure angle
                pair = answer["pair"]
                runs = (x[0] >= least_x1 and min(pair["contact_ratio"], pair["contact_ratio_true"]) >= 1.2
                        and min(pair["tip_clearance_mm"]) >= 0.02 * m and pair["internal"]["involute_margin_mm"] >= 0.02 * m
                        and min(g["tip_tooth_thickness_normal_mm"] for g in answer["gears"]) >= 0.2 * m)
            crossed = sum((a[1] > x[1]) != (b[1] > x[1]) and x[0] < a[0] + (b[0] - a[0]) * (x[1] - a[1]) / (b[1] - a[1])
                          for a, b in sides)
            inside += runs
            if runs != (crossed % 2 == 1):
                differ.append(x)
        # A curved edge is drawn with 25 points, so a few per mille of the region lie between chord and curve.
        self.assertLessEqual(len(differ), 8, differ)
        share = inside / len(points)
        whole = math.prod(hi - lo for lo, hi in box)
        self.assertAlmostEqual(share * whole, region["area"], delta=4 * whole * math.sqrt(share * (1 - share) / len(points)))


if __name__ == "__main__":
    unittest.main()
