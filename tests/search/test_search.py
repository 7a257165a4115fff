"""Tests the verb search as a user calls it: its designs, its output, and the agreement of both with other
verbs.

    sets     spur_searches.json: two independent programs found the same sets, by regions and by a brute-force
             grid
    taken    the verb pair, run on the output of --take N, gives the numbers of the row
    files    search.parquet (read by DuckDB), best.csv, search.json and report.html contain the same result
    changes  if nothing is feasible, each proposed change makes some design feasible, but 99 % of a
             numeric change does not
"""
import csv
import io
import json
import math
import re
import struct
import subprocess
import tomllib
import unittest

from searching import BIN, FILES, SMALL, SOURCE, WIDE, Asked, Run, contents, duckdb, end, folder, search, spec, start, taken

SLIDING = ("sliding1_A", "sliding1_E", "sliding2_A", "sliding2_E")
RACK = '[gear1]\nrack = "ISO53-A"\n'
BANDS = {"center_distance_mm": [59, 61], "ratio": [1.45, 1.55], "modules_mm": [1.5, 2, 2.5, 3], "pinion_teeth": [12, 30]}
CROSSED = {"ratio": [1.9, 2.1], "center_distance_mm": [60, 62], "modules_mm": [1.5, 2], "pinion_teeth": [9, 20],
           "shaft_angle_deg": 90, "helix_angle_deg": [40, 50], "helix_step_deg": 5}
HELICAL = {"modules_mm": [2, 2.5], "pinion_teeth": [20, 34], "helix_angle_deg": [8, 20], "helix_step_deg": 6, "face_width_mm": 22}
RING = {"ratio": [-3.2, -2.8], "center_distance_mm": [38, 42], "modules_mm": [2, 2.5], "pinion_teeth": [14, 24]}
KINDS = {
    "extended": spec(after=RACK),
    "tight": spec(SMALL | BANDS, RACK, mounting="tight"),
    "shortened tips": spec(SMALL | BANDS, RACK, mounting="tight", shorten_tips=True),
    "helical": spec(SMALL | HELICAL, RACK),
    "helical, shortened tips": spec(SMALL | HELICAL, RACK, mounting="tight", shorten_tips=True),
    "internal, extended": spec(SMALL | RING, RACK, mounting="extended"),
    "internal": spec(SMALL | RING, RACK),
    "crossed": spec(SMALL | CROSSED, RACK),
    "crossed, tight": spec(SMALL | CROSSED, RACK, mounting="tight"),
    "crossed, left hand": spec(SMALL | CROSSED, RACK, shaft_angle_deg=-70, helix_angle_deg=[-45, -30]),
    "racks": spec(racks=["ISO53-A", "ISO53-B", "ISO53-D"]),
    "gears of its own": spec(after="[gear1]\nnormal_pressure_angle_deg = 25\nhelix_angle_deg = -12\nface_width_mm = 18\n"
                             "[gear1.rack]\naddendum = 1.1\ndedendum = 1.4\nroot_fillet_radius = 0.2\n"
                             '[gear2]\nrack = "ISO53-C"\n'),
}


class Sets(unittest.TestCase):
    def test_the_searches_of_the_source(self):
        for case in json.loads((SOURCE / "tests/oracle/spur_searches.json").read_text())["searches"]:
            given, limits = case["input"], case["input"]["limits"]
            shifts = None if limits["floor"] is None else [limits["floor"], limits["ceil"]]
            found = search(spec(ratio=given["ratio"], center_distance_mm=given["C"], contact_ratio_min=given["eps_min"],
                                modules_mm="ISO54-I", pinion_teeth=given["z1"], coprime=given["coprime"], profile_shift=shifts,
                                tip_thickness_min=limits["sa_min"], target_ratio=given["target_ratio"],
                                undercut_depth=given["hF"], tip_clearance_min=0, form_clearance_min=0))
            self.assertEqual(found["tested"], case["tested"])
            self.assertEqual(found["feasible_count"], case["feasible_count"])
            names = {key.replace("_", " ").replace("center", "centre"): n for key, n in found["rejected"].items() if n}
            self.assertEqual(names, case["rejected"])
            designs = sorted([d["module_mm"], *d["teeth"]] for d in found["designs"])
            self.assertEqual(designs, sorted(case["feasible"]))
            regions = {(d["module_mm"], *d["teeth"]): d["region"] for d in found["designs"]}
            for r in case["some_regions"]:
                region = regions[r["m"], r["z1"], r["z2"]]
                self.assertAlmostEqual(region["area"], r["area"], delta=1e-11)
                self.assertAlmostEqual(region["shift_sum"][0], r["S_lo"], delta=1e-11)
                self.assertAlmostEqual(region["shift_sum"][1], r["S_hi"], delta=1e-11)

    def test_the_example(self):
        found = search((SOURCE / "examples/gearbox_search.toml").read_text())
        self.assertGreater(found["feasible_count"], 0)

    def test_coprime_ones_are_those_without_a_common_factor(self):
        every, some = search(spec()), search(spec(coprime=True))
        kept = [d["teeth"] for d in every["designs"] if math.gcd(*d["teeth"]) == 1]
        self.assertEqual([d["teeth"] for d in some["designs"]], kept)
        self.assertLess(0, len(kept))
        self.assertLess(some["tested"], every["tested"])


class Taken(unittest.TestCase):
    def test_an_internal_pair_that_nobody_mounts_has_no_negative_backlash(self):
        # Regression: at the extended centre distance, the teeth of the first design were too thick by 0.18
        # mm.
        ring = {"ratio": [-4, -3], "modules_mm": 2, "pinion_teeth": [20, 22]}
        pair = taken(spec(ring, thickness_series="none"), 1)
        self.assertNotEqual(pair["verdict"]["level"], "red")
        self.assertLess(abs(pair["pair"]["backlash"]["normal_base_mm"]), 1e-9)
        pair = taken(spec(ring), 1)
        self.assertEqual(pair["verdict"]["level"], "green")
        self.assertGreater(pair["pair"]["backlash"]["normal_base_mm"], 0.05)

    def agree(self, a, b, what):
        if a is None or b is None:
            self.assertEqual(a, b, what)
        else:
            self.assertLessEqual(abs(a - b), 1e-12 * max(1.0, abs(b)), f"{what}: row {a}, pair {b}")

    def same(self, row, pair, kind):
        p, gears = pair["pair"], pair["gears"]
        crossed = p["kind"] == "crossed"
        path = p["contact_ratio"] if crossed else p["transverse_contact_ratio"]
        working = p["working_normal_pressure_angle_deg"] if crossed else p["working_transverse_pressure_angle_deg"][0]
        angle = "normal" if crossed else "transverse"
        overlap = p["overlap_ratio"] or 0.0
        values = [("center_distance_mm", p["center_distance_mm"]), ("ratio", p["gear_ratio"]), ("contact_ratio", path),
                  ("overlap_ratio", overlap), ("backlash_normal_mm", p["backlash"]["normal_base_mm"]),
                  (f"working_{angle}_pressure_angle_deg", working)]
        for key, value in values:
            self.agree(row[key], value, f"{kind}: {key}")
        # The root fillet of an internal gear depends on its cutter, which a search does not choose.
        if p["kind"] != "parallel_internal":
            self.agree(row["contact_ratio_true"], p["contact_ratio_true"] - overlap, f"{kind}: contact_ratio_true")
        for i, gear in enumerate(gears):
            for key, value in (("teeth", gear["teeth"]), ("helix_angle_deg", gear["helix_angle_deg"]),
                               ("profile_shift", gear["profile_shift"]), ("tip_clearance_mm", p["tip_clearance_mm"][i]),
                               ("tip_thickness_mm", gear["tip_tooth_thickness_normal_mm"])):
                self.agree(row[key][i], value, f"{kind}: {key} of gear {i + 1}")
            for end_, name in enumerate("AE"):
                sliding = p["specific_sliding"][f"gear{i + 1}"][end_]
                self.agree(row["specific_sliding"][f"gear{i + 1}"][end_], sliding, f"{kind}: sliding of gear {i + 1} at {name}")
        shortened = p["tip_shortening_mm"] if "shortened" in kind else 0.0
        self.agree(row["tip_alteration_mm"], shortened, f"{kind}: tip_alteration_mm")
        self.agree(row["ratio_error"], row["ratio"] - sum(tomllib.loads(KINDS[kind])["search"]["ratio"]) / 2, kind)

    def test_every_kind_of_pair(self):
        for kind, text in KINDS.items():
            with self.subTest(kind):
                rows = search(text)["designs"]
                self.assertGreater(len(rows), 4, kind)
                for rank in (1, len(rows) // 2, len(rows)):
                    self.same(rows[rank - 1], taken(text, rank), kind)

    def test_every_design_of_a_search(self):
        text = KINDS["extended"].replace("[99, 101]", "100")
        KINDS["exactly 100"] = text
        rows = search(text)["designs"]
        self.assertGreater(len(rows), 15)
        for rank, row in enumerate(rows, 1):
            self.same(row, taken(text, rank), "exactly 100")
            self.assertAlmostEqual(row["center_distance_mm"], 100, delta=1e-9)

    def test_internal_pairs_say_so(self):
        row = search(KINDS["internal"])["designs"][0]
        self.assertLess(row["ratio"], -2.8 - 1e-12)
        self.assertLess(row["teeth"][1], 0)
        self.assertGreater(row["center_distance_mm"], 0)

    def test_the_rack_is_the_one_named(self):
        text = KINDS["racks"]
        rows = search(text)["designs"]
        self.assertEqual({row["rack"] for row in rows}, {1, 2, 3})
        for number, name in enumerate(("ISO53-A", "ISO53-B", "ISO53-D"), 1):
            rank = next(i for i, row in enumerate(rows, 1) if row["rack"] == number)
            given = tomllib.loads(Run("search", text, "--take", rank, folder=folder()).out)
            self.assertEqual([given[gear]["rack"] for gear in ("gear1", "gear2")], [name, name])

    def test_as_json(self):
        r = Run("search", KINDS["gears of its own"], "--take", 2, "--json", folder=folder())
        self.assertEqual(r.json, tomllib.loads(Run("search", KINDS["gears of its own"], "--take", 2, folder=folder()).out))
        self.assertEqual(r.json["gear1"]["helix_angle_deg"], -12)
        self.assertEqual(r.json["gear1"]["rack"], {"addendum": 1.1, "dedendum": 1.4, "root_fillet_radius": 0.2})
        self.assertEqual(Run("pair", r.out, "--json", name="pair.json", folder=folder()).status, 0)


class Answer(Asked):
    def costs(self, row, target):
        """Returns the value of each objective for a row. Smaller values are better."""
        sliding = [abs(z) for gear in row["specific_sliding"].values() for z in gear if z is not None]
        return {"contact_ratio": -row["contact_ratio_true"], "formula_contact_ratio": -row["contact_ratio"], "ratio": abs(row["ratio"] - target),
                "size": row["module_mm"] ** 2 * sum(z * z for z in row["teeth"]), "shift": abs(sum(row["profile_shift"])),
                "area": -row["region"]["area"], "sliding": max(sliding) if len(sliding) == 4 else None}

    def test_json_is_all_that_stdout_holds(self):
        p = Run("search", spec(), "--json", "--out", "o", folder=folder())
        self.assertEqual(list(p.json), ["search", "warnings"])
        self.assertEqual(p.err, "")
        s = p.json["search"]
        self.assertEqual(s["tested"], s["feasible_count"] + sum(s["rejected"].values()))
        self.assertEqual(len(s["designs"]), s["feasible_count"])
        # Each number has the fewest digits that give the same double.
        def digits(token):
            return len(re.sub(r"^-?0*\.?0*|[eE].*|\.", "", token).rstrip("0"))

        tokens = set(re.findall(r"(?<=[\[:,])-?\d[^,\]}\s]*", p.out))
        self.assertGreater(len(tokens), 20)
        for token in tokens:
            self.assertEqual(digits(token), digits(repr(float(token))), token)

    def test_regions_are_closed_and_hold_their_design(self):
        for row in search(KINDS["helical"])["designs"][:20]:
            edges = row["region"]["edges"]
            self.assertTrue({edge["constraint"] for edge in edges} <= {"s1min", "s1max", "s2min", "s2max", "Cmin", "Cmax", "eps",
                                                                         "eps_true"}, edges)
            for edge, following in zip(edges, edges[1:] + edges[:1]):
                self.assertLess(math.dist(edge["points"][-1], following["points"][0]), 1e-9)
            corners = [p for edge in edges for p in edge["points"]]
            area = sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(corners, corners[1:] + corners[:1])) / 2
            # The chords of the curves enclose a slightly smaller area.
            self.assertAlmostEqual(abs(area), row["region"]["area"], delta=2e-3 * row["region"]["area"] + 1e-12)
            for i in (0, 1):
                self.assertLessEqual(min(p[i] for p in corners), row["profile_shift"][i] + 1e-9)
                self.assertGreaterEqual(max(p[i] for p in corners), row["profile_shift"][i] - 1e-9)

    def test_objectives_rank(self):
        # In the second search, many regions have no point of Eq. 11.
        texts = [spec(), spec(center_distance_mm=[100.4, 100.6])]
        for text in texts:
            for name in ("contact_ratio", "ratio", "size", "shift", "area", "sliding", "formula_contact_ratio"):
                found = search(text + f'objective = "{name}"\ntarget_ratio = 2.03\n')
                keys = []
                for row in found["designs"]:
                    cost = self.costs(row, 2.03)[name] if row["point"] == "eq11" else None
                    self.assertEqual(row["objective"] is None, cost is None)
                    if cost is not None:
                        self.assertAlmostEqual(abs(row["objective"]), abs(cost), delta=1e-12 * max(1, abs(cost)))
                    keys.append((cost is None, round(cost or 0, 10), round(-row["contact_ratio"], 10), row["module_mm"],
                                 row["teeth"][0], abs(row["teeth"][1])))
                self.assertEqual(keys, sorted(keys), name)
                self.assertEqual(found["pareto"], [])
        self.assertEqual({row["point"] for row in found["designs"]}, {"eq11", "lo_hi"})

    def test_the_front(self):
        names = ["sliding", "contact_ratio", "area"]
        found = search(spec(objective=names))
        rows, front = found["designs"], found["pareto"]
        costs = [tuple(round(self.costs(row, 2)[n], 10) for n in names) if None not in row["objective"].values() else None
                 for row in rows]
        best = [i for i, a in enumerate(costs) if a and not any(
            b and b != a and all(x <= y for x, y in zip(b, a)) for b in costs)]
        self.assertEqual(front, best)
        self.assertTrue(1 < len(front) < len(rows))
        self.assertEqual(front, list(range(len(front))))
        for part in (rows[:len(front)], rows[len(front):]):
            values = [row["objective"]["sliding"] for row in part if row["objective"]["sliding"] is not None]
            self.assertEqual(values, sorted(values))
        self.assertEqual(search(spec(objective=names), "--top", 3)["pareto"], [0, 1, 2])

    def test_top(self):
        every = search(spec())
        r = Run("search", spec(), "--json", "--top", 5, "--out", "o", folder=folder())
        self.assertEqual(r.json["search"]["designs"], every["designs"][:5])
        self.assertEqual(r.json["search"]["feasible_count"], every["feasible_count"])
        self.assertEqual([w["code"] for w in r.json["warnings"]], ["designs_cut"])
        self.assertEqual(len((r.folder / "o/best.csv").read_text().splitlines()), 6)
        count = duckdb(r.folder / "o/search.parquet", "select count(*) as n from data")
        self.assertEqual(count, [{"n": every["feasible_count"]}])
        # --top does not limit --take
        self.assertEqual(Run("search", spec(), "--top", 2, "--take", 7, folder=folder()).out,
                         Run("search", spec(), "--take", 7, folder=folder()).out)

    def test_limits_hold_and_cost_designs(self):
        free = search(spec())["feasible_count"]
        for key, value, holds in (("sliding_max", 1.2, lambda r: self.costs(r, 2)["sliding"] <= 1.2 + 1e-9),
                                  ("contact_ratio_min", 1.6, lambda r: min(r["contact_ratio"], r["contact_ratio_true"]) >= 1.6 - 1e-9),
                                  ("interference", "exclude", lambda r: not r["interference"]),
                                  ("tip_thickness_min", 0.7, lambda r: min(r["tip_thickness_mm"]) >= 0.7 * r["module_mm"] - 1e-9)):
            rows = search(spec(**{key: value}))["designs"]
            self.assertTrue(all(map(holds, rows)), key)
            self.assertLess(0, len(rows), key)
            self.assertLess(len(rows), free + (key == "tip_thickness_min"), key)
        loose = KINDS["helical"]
        rows = search(loose + "")["designs"]
        tied = search(loose.replace("[search]\n", "[search]\noverlap_ratio_min = 1.0\n"))["designs"]
        self.assertTrue(all(row["overlap_ratio"] >= 1.0 for row in tied))
        self.assertTrue(0 < len(tied) < len(rows))

    def test_the_table_for_people(self):
        r = Run("search", spec(), "--out", "o", folder=folder())
        self.assertEqual(r.status, 0)
        for words in ("459 candidates", "46 are feasible", "centre distance out of reach: 413", "26 more", "o/search.parquet"):
            self.assertIn(words, r.out)
        best = search(spec())["designs"][0]
        self.assertRegex(r.out, "\nCommon to all designs\n  profile shifts  balanced\n")
        self.assertRegex(r.out, rf"\n +\*?1 +{best['module_mm']:.3f} +{best['teeth'][0]} +{best['teeth'][1]} ")
        for example in ("gearbox_search", "housing_search"):
            out = Run("search", (SOURCE / f"examples/{example}.toml").read_text(), folder=folder()).out
            self.assertIn("Common to all designs", out)
            self.assertLessEqual(max(len(line) for line in out.splitlines()), 110)


class Files(unittest.TestCase):
    def bits(self, value):
        return None if value is None else struct.pack("<d", float(value))

    def check(self, text):
        where = folder(text)
        status, out, err = end(start(where, "o", "--json"))
        self.assertEqual(status, 0, err)
        self.assertEqual(sorted(p.name for p in (where / "o").iterdir()), FILES)
        files = contents(where / "o")
        self.assertEqual(files["search.json"].decode(), out)
        found = json.loads(out)["search"]
        self.tables(where / "o/search.parquet", files["best.csv"].decode(), found)
        self.page(files["report.html"].decode(), found)

    def columns(self, row, crossed):
        """Returns the row of the table that corresponds to a design of the JSON."""
        want = {"module_mm": row["module_mm"], "rack": row.get("rack", 1), "point": row["point"],
                "working_angle_deg": row[f"working_{'normal' if crossed else 'transverse'}_pressure_angle_deg"],
                "interference": int(row["interference"]), "area": row["region"]["area"],
                "shift_sum_min": row["region"]["shift_sum"][0], "shift_sum_max": row["region"]["shift_sum"][1]}
        for key in ("ratio", "center_distance_mm", "contact_ratio", "contact_ratio_true", "overlap_ratio", "backlash_normal_mm",
                    "tip_alteration_mm"):
            want[key] = row[key]
        for i in (0, 1):
            n = i + 1
            want |= {f"z{n}": row["teeth"][i], f"helix{n}_deg": row["helix_angle_deg"][i], f"x{n}": row["profile_shift"][i],
                     f"tip_thickness{n}_mm": row["tip_thickness_mm"][i], f"tip_clearance{n}_mm": row["tip_clearance_mm"][i],
                     f"form_clearance_path{n}_mm": row["form_clearance_path_mm"][i],
                     f"lo_x{n}": row["region"]["lo"][i], f"hi_x{n}": row["region"]["hi"][i]}
            want |= {f"sliding{n}_{'AE'[e]}": row["specific_sliding"][f"gear{n}"][e] for e in (0, 1)}
        zetas = [want[key] for key in SLIDING]
        want["sliding_max"] = None if None in zetas else max(map(abs, zetas))
        return want

    def tables(self, parquet, text, found):
        crossed = "working_normal_pressure_angle_deg" in found["designs"][0]
        wanted = [self.columns(row, crossed) for row in found["designs"]]
        rows = duckdb(parquet, "select * from data")
        self.assertEqual(len(rows), found["feasible_count"])
        self.assertEqual(set(rows[0]), set(wanted[0]) | {"trial"})
        trials = [row["trial"] for row in rows]
        # The trials are in their order and not repeated.
        self.assertEqual(trials, sorted(set(trials)))

        def design(row):
            return tuple(row[key] for key in ("rack", "module_mm", "z1", "z2", "helix1_deg"))

        by_design = {design(row): row for row in rows}
        self.assertEqual(set(by_design), {design(row) for row in wanted})
        listed = list(csv.DictReader(io.StringIO(text)))
        self.assertEqual(len(listed), len(wanted))
        for rank, (want, line) in enumerate(zip(wanted, listed)):
            row = by_design[design(want)]
            self.assertEqual(line["rank"], str(rank + 1))
            self.assertEqual(line["front"], str(int(rank in found["pareto"])))
            for key, value in want.items():
                if isinstance(value, str):
                    self.assertEqual([row[key], line[key]], [value, value])
                    continue
                self.assertEqual(self.bits(row[key]), self.bits(value), f"{key}: {row[key]} {value}")
                self.assertEqual(self.bits(float(line[key]) if line[key] else None), self.bits(value), f"{key}: {line[key]} {value}")
            self.assertEqual(int(line["trial"]), row["trial"])

    def page(self, html, found):
        self.assertTrue(html.lstrip().lower().startswith("<!doctype html>"))
        self.assertEqual(re.findall(r"""(?:src|href)\s*=\s*["']?(?!#|data:)[^"'>\s]+""", html), [])
        self.assertNotRegex(html, r"@import|url\(\s*['\"]?(?!#|data:)|\bfetch\(|XMLHttpRequest")
        self.assertIn(str(found["feasible_count"]), html)
        best = found["designs"][0]
        self.assertIn(str(best["teeth"][0]), html)

    def test_files(self):
        for kind in ("extended", "shortened tips", "helical", "internal", "crossed", "racks"):
            with self.subTest(kind):
                self.check(KINDS[kind])

    def test_a_front_in_the_table(self):
        self.check(spec(objective=["size", "sliding"]))

    def test_the_table_says_of_what_it_is(self):
        where = folder(spec())
        end(start(where, "o"))
        pairs = duckdb(where / "o/search.parquet", "select decode(key) as k, decode(value) as v from "
                       "parquet_kv_metadata(getvariable('file'))")
        told = {row["k"]: row["v"] for row in pairs}
        self.assertEqual(json.loads(told["spec"])["search"], {k: v for k, v in SMALL.items()})
        self.assertEqual(told["trials"], "459")
        version = subprocess.run([BIN, "--version"], capture_output=True, text=True).stdout.split()[-1]
        self.assertEqual(told["program"], f"gearwright {version}")

    def test_many_designs(self):
        for top, listed in ((), 1000), (("--top", 1500), 1500):
            where = folder(spec(WIDE))
            self.assertEqual(end(start(where, "o", *top))[0], 0)
            files = contents(where / "o")
            self.assertEqual(len(files["best.csv"].splitlines()), listed + 1)
            found = json.loads(files["search.json"])["search"]
            self.assertEqual(len(found["designs"]), top[1] if top else found["feasible_count"])
            counts = duckdb(where / "o/search.parquet", "select count(*) as n, count(distinct trial) as m from data")
            self.assertEqual(counts, [{"n": found["feasible_count"], "m": found["feasible_count"]}])

    def test_nothing_feasible_makes_the_files_too(self):
        where = folder(spec(contact_ratio_min=1.95))
        status, out, err = end(start(where, "o", "--json"))
        self.assertEqual(status, 0, err)
        files = contents(where / "o")
        self.assertEqual(files["search.json"].decode(), out)
        self.assertEqual(duckdb(where / "o/search.parquet", "select count(*) as n from data"), [{"n": 0}])
        self.assertEqual(len(files["best.csv"].splitlines()), 1)
        self.assertIn(b"contact_ratio_min", files["report.html"])


class Changes(unittest.TestCase):
    def changes(self, keys, after=""):
        text = spec(keys, after)
        found = search(text)
        self.assertEqual([found["feasible_count"], found["designs"]], [0, []])
        efforts = [change["effort"] for change in found["changes"]]
        self.assertEqual(efforts, sorted(efforts))
        for change in found["changes"]:
            key = change["key"].removeprefix("search.")
            old, new = (json.loads(change[end_]) for end_ in ("from", "to"))
            if keys[key] == [old, old]:  # a range with equal limits is printed as one value
                old = keys[key]
            self.assertEqual(old, keys[key], change)
            self.assertGreater(search(spec(keys | {key: new}, after))["feasible_count"], 0, change)
            if isinstance(old, bool) or key == "pinion_teeth":
                continue
            shy = [o + 0.99 * (n - o) for o, n in zip(old, new)] if isinstance(old, list) else old + 0.99 * (new - old)
            self.assertEqual(search(spec(keys | {key: shy}, after))["feasible_count"], 0, f"{change}, {shy}")
        # The listing shows the same changes.
        told = Run("search", text, folder=folder()).out
        for change in found["changes"]:
            self.assertIn(f"{change['key']} = {change['to']} instead of {change['from']}", told)
        return {change["key"].removeprefix("search.") for change in found["changes"]}

    def test_each_limit_that_is_in_the_way(self):
        base = SMALL | {"modules_mm": [2, 2.5]}
        one = base | {"ratio": [2, 2], "center_distance_mm": [90.4, 90.6], "pinion_teeth": [31, 32], "profile_shift": [-0.1, 0.1],
                      "modules_mm": [2]}
        self.assertIn("contact_ratio_min", self.changes(base | {"contact_ratio_min": 1.95}))
        self.assertLessEqual({"center_distance_mm", "pinion_teeth", "profile_shift"}, self.changes(one))
        self.assertIn("tip_thickness_min", self.changes(base | {"tip_thickness_min": 1.2, "profile_shift": [0.3, 1.0],
                                                                "contact_ratio_min": 1.2}))
        self.assertIn("sliding_max", self.changes(base | {"sliding_max": 0.2}))
        self.assertIn("tip_clearance_min", self.changes(base | {"tip_clearance_min": 0.3, "mounting": "tight"}))
        helical = base | {"helix_angle_deg": [10, 12], "face_width_mm": 10, "overlap_ratio_min": 1}
        self.assertIn("overlap_ratio_min", self.changes(helical))
        self.assertIn("coprime", self.changes(base | {"ratio": [2, 2], "coprime": True}))
        ring = base | {"ratio": [-2, -1.9], "center_distance_mm": [26, 27], "pinion_teeth": [12, 16]}
        self.assertTrue(self.changes(ring))
        self.changes(base | {"undercut_margin": 4.0})

    def test_too_many_candidates_to_ask_again(self):
        r = Run("search", spec(pinion_teeth=[300, 3000], modules_mm=[5, 6, 8]), "--json", folder=folder())
        self.assertGreater(r.json["search"]["tested"], 2_000_000)
        self.assertEqual(r.json["search"]["changes"], [])
        self.assertEqual([w["code"] for w in r.json["warnings"]], ["changes_left_out"])


if __name__ == "__main__":
    unittest.main()
