"""Tests searches that are rejected: the exit status, the key, the permitted values, and that no file is
written."""
import re
import resource
import subprocess
import time
import unittest

from searching import BIN, SMALL, Asked, Run, chunks, contents, end, folder, raw, spec, start

TABLES = {"pinion rack": '[gear1.rack]\nprotuberance = 0.02\n', "rounded tip": "[gear2.rack]\ntip_fillet_radius = 0.1\n",
          "ramp": "[gear1.rack]\ntool_addendum = 0.9\nsemi_topping_angle_deg = 45\n"}


def modules(count):
    return [round(1 + i / 1000, 3) for i in range(count)]


class Refused(Asked):
    def no(self, text, key, *words, args=()):
        """Checks for exit status 1, the key in the JSON, the words in the message, and that no file was
        written."""
        where = folder(text)
        r = Run("search", None, "--json", "--out", "o", *args, folder=where)
        self.assertEqual(r.status, 1, f"{text}\n{r.out}\n{r.err}")
        self.assertEqual(r.json["error"]["key"], key, r.err)
        self.assertIn(r.json["error"]["message"], r.err)
        for word in words:
            self.assertIn(word, r.json["error"]["message"])
        self.assertEqual(r.files(), ["case.toml"])
        return r.json["error"]

    def test_bands(self):
        for key, least, most in (("ratio", 2.1, 1.9), ("center_distance_mm", 101, 99), ("pinion_teeth", 40, 12),
                                 ("profile_shift", 1.0, -0.6), ("helix_angle_deg", 20, 10)):
            self.no(spec(**{key: [least, most]}), f"search.{key}", f"{most:g}", f"{least:g}", "write the least value first")
            self.no(spec(**{key: []}), f"search.{key}", "empty list")
            self.no(spec(**{key: [1, 2, 3]}), f"search.{key}", "3 values")
            self.no(spec(**{key: "two"}), f"search.{key}", "two", "[least, greatest]" if key != "profile_shift" else "number")
            self.no(spec(**{key: True}), f"search.{key}", "not a number")
        for word in ("nan", "inf", "-inf"):
            self.no(spec(ratio=None, after=f"ratio = [1.9, {word}]\n"), "search.ratio", word)
        self.no(spec(profile_shift=0.3), "search.profile_shift", "[lower limit, upper limit]")

    def test_ratios_and_teeth(self):
        self.no(spec(ratio=[-1, 1]), "search.ratio", "must not contain 0", "negative for internal")
        self.no(spec(ratio=[0.5, 0.9]), "search.ratio", "contain values of 1 or more")
        self.no(spec(ratio=[-0.9, -0.5]), "search.ratio", "contain values below -1")
        self.no(spec(ratio=[1.0001, 1.0002]), "search.ratio", "widen")
        self.no(spec(pinion_teeth=[12.5, 40]), "search.pinion_teeth", "whole numbers")
        self.no(spec(pinion_teeth=[2, 40]), "search.pinion_teeth", "between 3 and 20000")
        self.no(spec(pinion_teeth=[12, 30000]), "search.pinion_teeth", "between 3 and 20000")
        # Such a wheel would have more than 20 000 teeth.
        self.no(spec(pinion_teeth=[12, 9524]), "search.ratio", "20000.4", "at most 20000")
        self.no(spec(ratio=[-800, -2]), "search.ratio", "32000", "at most 20000")
        self.assertEqual(Run("search", spec(pinion_teeth=[9500, 9523], modules_mm=[2]), folder=folder()).status, 0)

    def test_modules(self):
        names = ("ISO54-I", "ISO54-I+II", "a list")
        for value, words in (([2, 0], ("contains 0, but every value", "0.001")),
                             ([2, -1.5], ("contains -1.5, but every value", "0.001")),
                             ([2, 2.5, 2], ("2 twice",)), ([], ("empty", *names)), ("ISO54", names), (["2"], ("not a number", *names)),
                             ([1e-9], ("0.001",)), (1e9, ("1000",)), (True, names)):
            self.no(spec(modules_mm=value), "search.modules_mm", *words)
        self.no(spec(modules_mm=None, after="modules_mm = nan\n"), "search.modules_mm", "nan")

    def test_what_is_missing(self):
        self.no("[gear1]\nteeth = 20\nnormal_module_mm = 2\n", "search", "at least the key ratio")
        self.no(spec(ratio=None), "search.ratio", "is missing", "z2/z1", "[1.9, 2.1]")
        self.no("[search]\n", "search.ratio", "[1.9, 2.1]")
        self.no("search = 3\n", "search", "table")
        self.no("[[search]]\nratio = 2\n", "search", "table")

    def test_words_that_are_not_known(self):
        for wrong, near in (("contact_ratio_minn", "contact_ratio_min"), ("objectiv", "objective"), ("sliding", "sliding_max"),
                            ("pinion_tooth", "pinion_teeth"), ("lamda", "lambda"), ("centre_distance_mm", "center_distance_mm")):
            self.no(spec(SMALL | {wrong: 2}), f"search.{wrong}", f"did you mean {near}?")
        self.no(spec().replace("[search]", "[serch]"), "serch", "search")
        for wrong, near in (("slidng", "sliding"), ("contactratio", "contact_ratio"), ("areas", "area"), ("Size", "size")):
            self.no(spec(objective=wrong), "search.objective", wrong, f"did you mean {near}?", "shift")
            self.no(spec(objective=["ratio", wrong]), "search.objective", wrong, f"did you mean {near}?")
        self.no(spec(objective=[]), "search.objective", "empty")
        self.no(spec(objective=["ratio", "size", "ratio"]), "search.objective", "ratio twice")
        self.no(spec(objective=3), "search.objective", "3", "contact_ratio")
        self.no(spec(mounting="tihgt"), "search.mounting", '"extended", "tight"')
        self.no(spec(racks=["ISO53-E"]), "search.racks", "ISO53-E", "ISO53-A")
        self.no(spec(racks=[]), "search.racks", "list of names")
        self.no(spec(after="[gear1]\nface_width = 3\n"), "gear1.face_width", "face_width_mm")

    def test_limits_out_of_range(self):
        for key, values, words in (
                ("contact_ratio_min", (-1, 11), ("0 and 10",)), ("tip_thickness_min", (-0.1, 2), ("0 and 1.5",)),
                ("sliding_max", (-1, 2000), ("0 and 1000",)), ("tip_clearance_min", (-2, 5), ("-1 and 1",)),
                ("lambda", (100,), ("-10 and 10",)), ("undercut_depth", (4,), ("0 and 3",)), ("face_width_mm", (0, -3), ("greater",)),
                ("coprime", (1, "yes"), ("true or false",)), ("avoid_interference", (0,), ("true or false",)),
                ("helix_angle_deg", (90, -95), ("-89 and 89",)), ("center_distance_mm", (0, -5), ("greater than 0",)),
                ("shaft_angle_deg", (200, -180, 1e-300), ("178",)), ("shift_step", (0, 1e-9, 2), ("between",))):
            for value in values:
                self.no(spec(**{key: value}), f"search.{key}", *words)
        self.no(spec(helix_step_deg=1), "search.helix_step_deg", "helix_angle_deg")
        self.no(spec(helix_angle_deg=[0, 20], helix_step_deg=1e-9), "search.helix_step_deg", "at most")
        self.no(spec(helix_angle_deg=[0, 20], helix_step_deg=0), "search.helix_step_deg", "greater")
        self.no(spec(helix_angle_deg=3, helix_angles_deg=[1, 2]), "search.helix_angles_deg", "helix_angle_deg")

    def test_whole_overlap_ratios(self):
        def no(key, *words, **changed):
            keys = {"helix_angle_deg": [8, 20], "face_width_mm": [20, 30], "overlap_ratio": 1} | changed
            self.no(spec(**keys), f"search.{key}", *words)
        no("overlap_ratio", "1.5", "whole numbers", overlap_ratio=[1, 1.5])
        no("overlap_ratio", "2 twice", overlap_ratio=[2, 1, 2])
        no("overlap_ratio", "between 1 and 20", overlap_ratio=0)
        no("overlap_ratio", "helix_angle_deg = [least, greatest]", helix_angle_deg=12)
        no("overlap_ratio", "leave out helix_angle_deg of [gear1]", helix_angle_deg=None,
           after="[gear1]\nhelix_angle_deg = 12\n")
        no("overlap_ratio", "face_width_mm", face_width_mm=None)
        no("overlap_ratio", "leave out helix_step_deg", helix_step_deg=1)
        no("overlap_ratio", "crossed axes", shaft_angle_deg=90, helix_angle_deg=[40, 50], face_width_mm=20)
        no("overlap_ratio", "combinations", "at most 100000", face_width_step_mm=1e-4)
        no("face_width_diameters", "overlap_ratio", "numbers of teeth", face_width_diameters=[0.2, 1])
        # arcsin(3 π 2/30) = 38.93° and arcsin(3 π 2.5/24) = 79.03°; 20 mm are too narrow for 3 π 2.5 mm
        no("overlap_ratio", "38.93 to 79.04 degrees", overlap_ratio=3, modules_mm=[2, 2.5], face_width_mm=[24, 30],
           face_width_step_mm=6)
        no("overlap_ratio", "38.93 to 79.04 degrees", "(default: [5, 30])", overlap_ratio=3, modules_mm=[2, 2.5],
           face_width_mm=[24, 30], face_width_step_mm=6, helix_angle_deg=None)
        no("overlap_ratio", "no helix angle between 1 and 89", overlap_ratio=20)

    def test_the_same_thing_twice_is_not_counted_twice(self):
        self.no(spec(helix_angles_deg=[10, 12, 10]), "search.helix_angles_deg", "10 twice")
        self.no(spec(racks=["ISO53-A", "ISO53-C", "ISO53-A"]), "search.racks", "ISO53-A", "twice")

    def test_what_a_search_does_not_know(self):
        self.no(spec(shaft_angle_deg=90, sliding_max=2), "search.sliding_max", "crossed axes")
        self.no(spec(shaft_angle_deg=90, objective="sliding"), "search.objective", "crossed axes")
        self.no(spec(shaft_angle_deg=90, ratio=[-4, -3]), "search.shaft_angle_deg", "internal")
        self.no(spec(shaft_angle_deg=90, helix_angle_deg=-10), "search.helix_angle_deg", "100", "89")
        self.no(spec(shaft_angle_deg=90, mounting="tight", shorten_tips=True), "search.shorten_tips", "parallel")
        self.no(spec(shorten_tips=True), "search.shorten_tips", "tight")
        for table in TABLES.values():
            self.no(spec(after=table), re.search(r"gear\d.rack", table)[0], "protuberance", "does not support")
        for kind in ("double_circular_arc", "bogus"):
            self.no(spec(after=f'[gear1.rack]\nkind = "{kind}"\n'), "gear1.rack.kind", "straight")
        self.no(spec(after="[gear1]\nnormal_module_mm = 2\n"), "gear1.normal_module_mm", "cannot be combined with [search]")
        self.no(spec(racks=["ISO53-A"], after='[gear1]\nrack = "ISO53-C"\n'), "search.racks", "contradicts")
        self.no(spec(after="[gear1]\nnormal_pressure_angle_deg = 20\n[gear2]\nnormal_pressure_angle_deg = 25\n"),
                "gear2.normal_pressure_angle_deg", "25", "20")

    def test_a_pair_beside_the_search_is_not_read_and_that_is_said(self):
        r = Run("search", spec(after="[pair]\ncenter_distance_mm = 100\n"), "--json", folder=folder())
        self.assertEqual([w["code"] for w in r.json["warnings"]], ["not_read"])
        r = Run("search", spec(after="[pair]\ncenter_distance_mm = 100\n"), folder=folder())
        self.assertIn("The table [pair] has no effect on a search", " ".join(r.out.split()))

    def test_teeth_of_a_gear_beside_the_search_are_not_read_and_that_is_said(self):
        for after in ("[gear1]\nteeth = 20\nnormal_module_mm = 2\n", "[gear1]\nteeth = 20\nnormal_module_mm = 2\n[gear2]\nteeth = 40\n"):
            r = Run("search", spec(after=after), "--json", folder=folder())
            self.assertEqual([w["code"] for w in r.json["warnings"]], ["not_read"], r.json["warnings"])
            self.assertIn("uses pinion_teeth, ratio", r.json["warnings"][0]["message"])
            r = Run("search", spec(after=after), folder=folder())
            self.assertIn("have no effect on a search", " ".join(r.out.split()))
        self.assertEqual(Run("search", spec(after="[gear1]\nface_width_mm = 18\n"), "--json", folder=folder()).json["warnings"], [])

    def test_take(self):
        for text, rank, words in ((spec(), 47, "must be 1 to 46"), (spec(contact_ratio_min=1.95), 1, "no design is feasible")):
            r = Run("search", text, "--take", rank, "--json", folder=folder())
            self.assertEqual([r.status, r.json["error"]["key"], r.json["error"]["value"]], [1, "--take", str(rank)])
            self.assertIn(words, r.err)
            self.assertEqual(r.files(), ["case.toml"])
            r = Run("search", text, "--take", rank, folder=folder())
            self.assertEqual([r.status, r.out], [1, ""])

    def test_command_line(self):
        shards = ("0/3", "4/3", "a/b", "1/0", "-1/3", "1/", "/3", "1", "1/3/5", "1 /3", "+1/3", "1.0/3", "", "99999999999/99999999999")
        lines = [("--take", 0), ("--take", "-1"), ("--take", "x"), ("--take", 10**9), ("--top", 0), ("--top", "many"), ("--threads", 0),
                 ("--chunk", 0), ("--chunk", 1 << 30), ("--resume",), ("--shard", "1/3"), ("--out", ""), ("--out",), ("--bogus",),
                 *(("--shard", shard, "--out", "o") for shard in shards)]
        for args in lines:
            where = folder(spec())
            command = [BIN, "search", "case.toml", *map(str, args)]
            p = subprocess.run(command, cwd=where, capture_output=True, text=True, timeout=60)
            self.assertEqual([p.returncode, p.stdout], [2, ""], f"{args}\n{p.stderr}")
            self.assertIn(args[0], p.stderr)
            self.assertEqual([f.name for f in where.iterdir()], ["case.toml"], args)
        self.assertEqual(raw("search").returncode, 2)


def children_seconds():
    """Returns the processor time of all child processes that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class Large(Asked):
    # 9·10^14 candidates, the greatest number for a spec.
    WIDEST = {"ratio": [1, 5], "pinion_teeth": [10, 2000], "modules_mm": modules(1400), "helix_angle_deg": [0, 40],
              "helix_step_deg": 0.0005}

    def refused_at_once(self, text, candidates):
        where = folder(text)
        before = children_seconds()
        r = Run("search", None, "--json", "--out", "o", folder=where)
        self.assertLess(children_seconds() - before, 5)
        self.assertEqual(r.status, 1, r.err)
        self.assertEqual(r.json["error"]["key"], "--yes-large")
        self.assertEqual(r.files(), ["case.toml"])
        said = re.search(r"(\S+) candidates would take about (\d+) (\w+) on this machine, at (\S+) candidates per second on (\d+) thread", r.err)
        self.assertTrue(said, r.err)
        self.assertAlmostEqual(float(said[1]) / candidates, 1, delta=0.01)
        seconds = int(said[2]) * {"seconds": 1, "minutes": 60, "hours": 3600, "days": 86400, "years": 31557600}[said[3]]
        # The message rounds the rate to three digits and the duration to whole years.

        self.assertAlmostEqual(seconds * float(said[4]) / candidates, 1, delta=0.01 + 0.5 / int(said[2]))
        for words in ("--yes-large", "--shard", "--out"):
            self.assertIn(words, r.err)
        return float(said[4]) / int(said[5])

    def test_says_how_long_it_would_take(self):
        # The predicted rate is compared with the measured rate of a search with one helix angle and a few
        # modules. A busy machine can disturb either of them, so one good agreement is sufficient.
        ratios = []
        while len(ratios) < 4 and not any(0.2 < ratio < 5 for ratio in ratios):
            part = folder(spec(SMALL | self.WIDEST, modules_mm=modules(2), helix_angle_deg=10, helix_step_deg=None))
            began = time.monotonic()
            part = Run("search", None, "--json", "--threads", 1, folder=part)
            tested = part.json["search"]["tested"]
            rate = tested / (time.monotonic() - began)
            ratios.append(self.refused_at_once(spec(SMALL | self.WIDEST), tested / 2 * 1400 * 80001) / rate)
        self.assertTrue(any(0.2 < ratio < 5 for ratio in ratios), f"predicted rates over measured rates: {ratios}")

    def test_more_chunks_than_can_be_kept(self):
        where = folder(spec(SMALL | self.WIDEST))
        r = Run("search", None, "--json", "--out", "o", "--yes-large", folder=where)
        self.assertEqual(r.status, 1, r.err)
        self.assertIn("divide the list of modules", r.json["error"]["message"])
        self.assertEqual(r.files(), ["case.toml"])

    def test_as_large_as_can_be_asked_for(self):
        text = spec(ratio=[1, 2], pinion_teeth=[3, 10000], modules_mm=modules(100_000), helix_angle_deg=[0, 40], helix_step_deg=0.00041,
                    racks=["ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"])
        self.refused_at_once(text, 4e5 * (int(40 / 0.00041) + 2) * sum(z + 1 for z in range(3, 10001)))


class Campaigns(Asked):
    CHUNK = ("--chunk", 100)

    def no(self, where, out, *args):
        """Checks that the program rejects the call and changes no file. Returns its message."""
        before = {p: p.read_bytes() for p in where.rglob("*") if p.is_file()}
        status, text, err = end(start(where, out, *args))
        self.assertEqual([status, text], [1, ""], err)
        self.assertEqual({p: p.read_bytes() for p in where.rglob("*") if p.is_file()}, before)
        return err

    def test_resume_without_a_campaign(self):
        where = folder(spec())
        self.assertIn("no search to resume", self.no(where, "o", "--resume"))
        (where / "empty").mkdir()
        self.assertIn("no search to resume", self.no(where, "empty", "--resume", *self.CHUNK))
        self.assertEqual(list((where / "empty").iterdir()), [])

    def test_resume_with_another_spec(self):
        where = folder(spec())
        self.assertEqual(end(start(where, "o", *self.CHUNK))[0], 0)
        for changed, words in (({"contact_ratio_min": 1.3}, ("contact_ratio_min was not set and is now 1.3",)),
                               ({"pinion_teeth": [12, 41]}, ("pinion_teeth was [12,40] and is now [12,41]",)),
                               ({"profile_shift": None}, ("profile_shift was [-0.6,1.0] and is not set now",)),
                               ({"ratio": [1.8, 2.1], "modules_mm": [2], "coprime": True, "lambda": 0.75},
                                ("ratio was", "modules_mm was", "more"))):
            (where / "case.toml").write_text(spec(**changed))
            for how in (("--resume",), ("--shard", "1/2")):
                err = self.no(where, "o", *how, *self.CHUNK)
                for word in ("this folder contains a search with another spec", *words):
                    self.assertIn(word, err)
            self.assertIn("this folder contains another search", self.no(where, "o", *self.CHUNK))
        (where / "case.toml").write_text(spec(after="[gear1]\nface_width_mm = 30\n"))
        self.assertIn("gear1.face_width_mm was not set and is now 30", self.no(where, "o", "--resume", *self.CHUNK))
        (where / "case.toml").write_text(spec())
        self.assertIn("trials of a chunk was 100 and is now 90", self.no(where, "o", "--resume", "--chunk", 90))
        self.assertEqual(end(start(where, "o", "--resume", *self.CHUNK))[0], 0)

    def test_beginning_where_a_campaign_is(self):
        where = folder(spec())
        self.assertEqual(end(start(where, "o", *self.CHUNK))[0], 0)
        err = self.no(where, "o", *self.CHUNK)
        for word in ("this folder contains a search", "5 of 5 chunks", "--resume", "another folder"):
            self.assertIn(word, err)

    def test_take_says_nothing_while_shards_are_left(self):
        where = folder(spec())
        status, out, err = end(start(where, "o", "--shard", "1/3", "--take", 1, *self.CHUNK))
        self.assertEqual([status, out], [1, ""])
        self.assertIn("not finished, 2 of 5 chunks", err)
        self.assertEqual(chunks(where / "o"), 2)


class World(Asked):
    def test_out_cannot_be_written(self):
        for kind in ((), ("--chunk", 50), ("--shard", "1/2")):
            where = folder(spec())
            (where / "file").write_text("mine")
            for out in ("file", "file/below", "/proc/nothing/here", "/dev/null/x"):
                status, text, err = end(start(where, out, *kind))
                self.assertEqual([status, text], [3, ""], err)
                self.assertIn(out, err)
            self.assertEqual((where / "file").read_text(), "mine")
            self.assertEqual(sorted(p.name for p in where.iterdir()), ["case.toml", "file"])

    def test_full_stdout(self):
        where = folder(spec())
        for args in ((), ("--json",), ("--take", "2"), ("--json", "--take", "2"), ("--json", "--out", "o")):
            with open("/dev/full", "w") as full:
                p = subprocess.run([BIN, "search", "case.toml", *args], cwd=where, stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(p.returncode, 3, args)
            self.assertIn("standard output", p.stderr)
        contents(where / "o")  # the requested files must be complete

    def test_full_disk(self):
        # A limit of the file size has the same effect as a full disk.
        for blocks in (1, 8, 40):
            where = folder(spec())
            script = f"ulimit -f {blocks}; exec '{BIN}' search case.toml --out o"
            p = subprocess.run(["bash", "-c", script], cwd=where, capture_output=True, text=True)
            self.assertEqual([p.returncode, p.stdout], [3, ""], p.stderr)
            for path in (where / "o").iterdir():
                self.assertNotIn("part", path.name)
                self.assertLessEqual(path.stat().st_size, blocks * 1024)

    def test_no_such_spec(self):
        p = subprocess.run([BIN, "search", "/no/such.toml"], capture_output=True, text=True)
        self.assertEqual(p.returncode, 3)


if __name__ == "__main__":
    unittest.main()
