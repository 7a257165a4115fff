"""Tests the scatter over the designs of a search. Rows equal the results of the verb scatter, bit
for bit. Shards, ranks and killed processes do not change the files."""
import csv
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from searching import BIN, SMALL, Run, chunks, end, folder, spec, wait_until

MPIRUN = shutil.which("mpirun")
AS_ROOT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "ASAN_OPTIONS": "detect_leaks=0"}
FILES = ["scatter.csv", "scatter.html", "scatter.json"]
TOLERANCES = """
[gear1.modifications]
lead_crowning_um = 6
profile_crowning_um = 5
[scatter]
samples = 16
replicates = 4
percentiles = [50, 90]
{}
[scatter.errors]
center_distance_mm = [-0.02, 0.02]
crossing_deg = [-0.02, 0.02]
helix_slope1_um = [-8, 8]
"""
SEARCH = SMALL | {"pinion_teeth": [24, 34], "center_distance_mm": [98, 102], "modules_mm": [2, 2.5], "face_width_mm": 20,
                  "profile_shift": [-0.3, 0.8]}
TEXT = spec(SEARCH, after=TOLERANCES.format(""))


def study(where, *args, name="case.toml"):
    r = Run("scatter", None, *args, folder=where, name=name)
    return r


def begin(where, out, *args, program=(BIN,), **options):
    return subprocess.Popen([*program, "scatter", "case.toml", "--designs", "found", "--out", str(out), *map(str, args)], cwd=where,
                            text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def contents(out):
    return {name: (out / name).read_bytes() for name in FILES}


class ScatterDesigns(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.where = folder(TEXT)
        assert Run("search", None, "--out", "found", folder=cls.where).status == 0
        r = Run("scatter", None, "--designs", "found", "--out", "alone", "--json", folder=cls.where)
        assert r.status == 0, r.err
        cls.result = r.json["scatter_designs"]
        cls.alone = contents(cls.where / "alone")

    def test_the_table_has_the_values_of_the_result(self):
        rows = list(csv.DictReader(self.alone["scatter.csv"].decode().splitlines()))
        designs = self.result["designs"]
        self.assertEqual(len(rows), len(designs) + len(self.result["refused"]))
        for row, design in zip(rows, designs):
            spread, of = design["peak_to_peak_arcsec"], design["probability"]
            expected = {
                "design": design["design"], "module_mm": design["module_mm"], "z1": design["teeth"][0],
                "z2": design["teeth"][1], "x1": design["profile_shift"][0], "x2": design["profile_shift"][1],
                "center_distance_mm": design["center_distance_mm"], "percentile_arcsec": spread["percentiles"][1],
                "percentile_lower_arcsec": spread["lower"][1], "percentile_upper_arcsec": spread["upper"][1],
                "mean_arcsec": spread["mean"], "edge_contact": of["edge_contact"]["value"],
                "edge_contact_lower": of["edge_contact"]["lower"], "edge_contact_upper": of["edge_contact"]["upper"],
                "jam": of["jam"]["value"], "jam_upper": of["jam"]["upper"], "contact_lost": of["contact_lost"]["value"],
                "contact_lost_upper": of["contact_lost"]["upper"]}
            for key, value in expected.items():
                self.assertEqual(float(row[key]), value, key)

    def go(self, out, *args, **options):
        status, printed, err = end(begin(self.where, self.where / out, *args, **options))
        self.assertEqual(status, 0, err)
        return printed

    def same(self, out):
        for name, one in self.alone.items():
            self.assertTrue((self.where / out / name).read_bytes() == one, f"{out}/{name} is different")

    def test_rows_are_those_of_scatter(self):
        rows = self.result["designs"]
        self.assertEqual(self.result["count"], len(rows) + len(self.result["refused"]))
        self.assertGreater(len(rows), 8)
        for row in (rows[0], rows[len(rows) // 2], rows[-1]):
            take = Run("search", None, "--take", row["design"], folder=self.where).out
            self.assertIn("lead_crowning_um", take)
            one = Run("scatter", take, "--json", folder=folder()).json["scatter"]
            for key in ("peak_to_peak_arcsec", "least_play_deg", "contact_along_face", "probability"):
                self.assertEqual(row[key], one[key], (row["design"], key))

    def test_the_order(self):
        percentiles = [row["peak_to_peak_arcsec"]["percentiles"][1] for row in self.result["designs"]]
        self.assertEqual(percentiles, sorted(percentiles))
        self.assertEqual(self.result["percentile"], 90)
        numbers = [row["design"] for row in self.result["designs"]]
        self.assertEqual(sorted(numbers), list(range(1, len(numbers) + 1)))
        self.assertNotEqual(numbers, sorted(numbers))

    def test_the_search_of_the_spec(self):
        """Without --designs, the verb runs the search first. --top limits it to the best designs."""
        self.assertEqual(study(self.where, "--json").json["scatter_designs"], self.result)
        few = study(self.where, "--json", "--top", 3).json["scatter_designs"]
        best = [row for row in self.result["designs"] if row["design"] <= 3]
        self.assertEqual(few["designs"], best)
        piped = subprocess.run([BIN, "scatter", "-", "--csv"], input=TEXT, text=True, capture_output=True, check=True).stdout
        self.assertEqual(piped.encode(), self.alone["scatter.csv"].replace(b"\r\n", b"\n"))

    def test_the_table(self):
        out = study(self.where).out
        best = self.result["designs"][0]
        line = next(row for row in out.splitlines() if row.lstrip().startswith("1 "))
        self.assertIn(f" {best['design']} ", line)
        self.assertIn(f"{best['peak_to_peak_arcsec']['percentiles'][1]:.4f}", line)
        self.assertIn("90 %", out)
        self.assertIn(f"--take {best['design']}", out)

    def test_threads(self):
        self.go("threads", "--threads", 1)
        self.same("threads")

    def test_shards(self):
        for i in (2, 3, 1):
            out = self.go("shards", "--shard", f"{i}/3")
            self.assertEqual("the last shard" in out, i != 1, out)
        self.same("shards")

    def test_killed_and_resumed(self):
        process = begin(self.where, self.where / "killed", "--threads", 1)
        self.assertTrue(wait_until(lambda: chunks(self.where / "killed") > 1))
        process.kill()
        end(process)
        self.assertIn("--resume", study(self.where, "--designs", "found", "--out", "killed").err)
        self.go("killed", "--resume")
        self.same("killed")

    @unittest.skipUnless(MPIRUN and os.path.exists(os.path.join(os.environ["GW_BUILD"], "gearwright-mpi")), "no mpirun")
    def test_ranks(self):
        mpi = (MPIRUN, "--oversubscribe", "-n", "2", os.path.join(os.environ["GW_BUILD"], "gearwright-mpi"))
        self.go("ranks", program=mpi, env=AS_ROOT)
        self.same("ranks")

    def test_ctrl_c(self):
        where = folder(TEXT.replace("samples = 16", "samples = 65536"))
        for how in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([BIN, "scatter", "case.toml", "--out", "o", "--top", "2"], cwd=where, text=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertRegex(process.stderr.readline(), r"of 2 designs, computing the samples, \d+ % done")
            sent = time.monotonic()
            process.send_signal(how)
            _, err = process.communicate(timeout=20)
            self.assertLess(time.monotonic() - sent, 2)
            self.assertEqual(process.returncode, 3)
            self.assertIn("--resume continues", err)
            shutil.rmtree(where / "o")

    def test_designs_without_a_scatter(self):
        """If a relief does not fit the profile of a design, the design is listed with the reason. The
        others are ranked."""
        long = TEXT.replace("profile_crowning_um = 5", "profile_crowning_um = 5\ntip_relief_um = 10\ntip_relief_start_mm = 69.5")
        long = long.replace("samples = 16", "samples = 1")
        r = study(folder(long), "--json")
        self.assertEqual(r.status, 0, r.err)
        found = r.json["scatter_designs"]
        self.assertTrue(found["designs"] and found["refused"], r.out[:3000])
        self.assertEqual(len(found["designs"]) + len(found["refused"]), found["count"])
        for row in found["refused"]:
            self.assertIn("tip_relief", row["reason"])
        listing = study(folder(long)).out
        self.assertIn(f"Designs whose scatter was not computed: {len(found['refused'])}", listing)

    def no(self, where, status, key, *words, args=()):
        r = study(where, "--json", *args)
        self.assertEqual(r.status, status, r.out + r.err)
        if key is not None:
            self.assertEqual(r.json["error"]["key"], key, r.err)
        for word in words:
            self.assertIn(word, r.err)

    def test_bad_input(self):
        where = folder(TEXT)
        (where / "pair.json").write_text('{"gears": []}')
        (where / "text.json").write_text("[search]")
        (where / "huge.json").write_text('{"search": 1e999}')
        (where / "begun.json").write_text('{"search": {"finished": false}, "warnings": []}')
        (where / "old.json").write_text('{"search": {"designs": [{"teeth": [20, 40]}]}}')
        (where / "empty").mkdir()
        for name, word in (("pair.json", "not the result of a search"), ("text.json", "not the result of a search"),
                           ("huge.json", "not the result of a search"),
                           ("begun.json", "not finished"), ("old.json", "this version"), ("empty", "no search.json"),
                           ("found.parquet", "search.json instead")):
            self.no(where, 1, "--designs", name, word, args=("--designs", name))
        self.assertEqual(study(where, "--designs", "missing.json").status, 3)
        self.no(where, 2, None, "--out", args=("--shard", "1/2"))
        self.no(where, 2, None, "1 <= i <= N", args=("--shard", "3/2", "--out", "o"))
        self.no(where, 2, None, "gearwright search SPEC --take N", args=("--take",))
        other = folder(spec(SEARCH | {"modules_mm": [1.5]}, after=TOLERANCES.format("")))
        shutil.copytree(self.where / "found", other / "found")
        self.no(other, 1, "--designs", "another search", args=("--designs", "found"))
        self.no(folder(spec(SEARCH)), 1, "scatter.errors", "crossing_deg", args=())
        pair = "[gear1]\nteeth = 20\nnormal_module_mm = 2\n[gear2]\nteeth = 40\n[scatter]\nquality = 6\n"
        self.no(folder(pair), 1, "search", "spec of the search", args=("--designs", "x.json"))
        self.no(folder(pair), 1, "", "`gearwright run` writes files", args=("--out", "o"))
        self.no(folder(TEXT.replace("lead_crowning_um", "lead_crown_um")), 1, "gear1.modifications.lead_crown_um", "lead_crowning_um")
        self.assertEqual([p.name for p in folder(TEXT).iterdir()], ["case.toml"])

    def test_another_study_in_the_folder(self):
        self.go("other")
        changed = self.where / "changed.toml"
        changed.write_text(TEXT.replace("samples = 16", "samples = 32"))
        r = Run("scatter", None, "--designs", "found", "--out", "other", "--resume", "--json", folder=self.where, name="changed.toml")
        self.assertEqual(r.status, 1)
        self.assertIn("scatter.samples was 16 and is now 32", r.err)


if __name__ == "__main__":
    unittest.main()
