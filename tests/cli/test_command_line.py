"""Tests the command line as users type it: misspelt verbs, pipes, tables for a spreadsheet, reused
folders, and batches."""
import csv
import io
import json
import os
import pathlib
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest

from cli import BIN, PAIR, SOURCE, Asked, Run, new_folder, raw

GEAR = "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 10\n"


def piped(text, *args, cwd=None):
    return subprocess.run([BIN, *args], input=text, capture_output=True, text=True, timeout=120, cwd=cwd)


def table(text):
    return list(csv.reader(io.StringIO(text)))


class Start(unittest.TestCase):
    def test_an_answer_starts_at_once(self):
        """Measures processor time, which other programs on the machine hardly affect. A pair takes
        about 11 ms."""
        def seconds(*args):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.assertEqual(raw(*args).returncode, 0)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

        for args in (("--version",), ("pair", str(pathlib.Path(SOURCE, "examples/spur_pair.toml")))):
            self.assertLess(statistics.median(seconds(*args) for _ in range(11)), 0.05, args)


class Words(unittest.TestCase):
    def test_a_slip_of_an_option_or_a_part_is_named(self):
        for args, near in ((("pair", "x.toml", "--jsn"), "--json"), (("search", "x.toml", "--takee=3"), "--take"),
                           (("run", "x.toml", "--only", "svg,repport"), "report"), (("batch", "piar", "x.json"), "pair")):
            p = raw(*args)
            self.assertEqual(p.returncode, 2)
            self.assertIn(f"did you mean {near}?", p.stderr)
        self.assertIn("pair has no option --zzzz (", raw("pair", "x.toml", "--zzzz").stderr)

    def test_a_slip_of_a_verb_is_named(self):
        for wrong, near in (("gaer", "gear"), ("pear", "gear"), ("contct", "contact"), ("serach", "search"), ("exprot", "export"),
                            ("Pair", "pair"), ("meas", "measure"), ("pare", "pair")):
            p = raw(wrong, "x.toml")
            self.assertEqual(p.returncode, 2)
            self.assertRegex(p.stderr, f"no verb {wrong}; did you mean (gear|pair|{near})\\?")
        p = raw("frobnicate")
        self.assertIn("verbs: ", p.stderr)
        self.assertNotIn("\x1b", raw("g\x1b[31m").stderr)

    def test_help_and_version_wherever_they_are_asked_for(self):
        for args in (("help",), ("--help",), ("help", "pair"), ("pair", "--help"), ("help", "--help")):
            p = raw(*args)
            self.assertEqual([p.returncode, p.stderr], [0, ""], args)
            self.assertIn("pair", p.stdout)
        self.assertEqual(raw("help", "pair").stdout, raw("pair", "--help").stdout)
        self.assertEqual(raw("help", "gaer").returncode, 2)
        version = raw("--version").stdout
        self.assertTrue(version.startswith("gearwright 0."))
        for args in (("-V",), ("pair", "--version"), ("search", "-V"), ("schema", "--version")):
            p = raw(*args)
            self.assertEqual([p.returncode, p.stdout], [0, version], args)

    def test_an_empty_name_is_no_default(self):
        r = Run("run", GEAR, "--out", "")
        self.assertEqual([r.status, r.files()], [2, ["case.toml"]])

    def test_it_starts_at_once(self):
        best = min(self.start() for _ in range(10))
        self.assertLess(best, 0.1)  # 20 ms on an idle machine; 0.2 s if OCCT is linked
        libraries = subprocess.run(["ldd", BIN], capture_output=True, text=True).stdout
        self.assertNotIn("libTK", libraries)

    def start(self):
        begin = time.monotonic()
        raw("--version")
        return time.monotonic() - begin


class Pipes(unittest.TestCase):
    def test_standard_input_is_toml_or_json(self):
        want = Run("pair", PAIR, "--json").out
        self.assertEqual(piped(PAIR, "pair", "-", "--json").stdout, want)
        tree = json.dumps(tomllib.loads(PAIR))
        self.assertEqual(piped("\n " + tree, "pair", "-", "--json").stdout, want)
        p = piped(GEAR + "x_y = 1\n", "gear", "-", "--json")
        self.assertEqual(p.returncode, 1)
        self.assertIn("standard input:5:1: gear1.x_y", p.stderr)
        # The folder of the results is named after a file.
        self.assertEqual(piped(GEAR, "run", "-").returncode, 2)
        self.assertEqual(piped("", "gear", "-").returncode, 1)

    def test_what_take_prints_pipes_back(self):
        wish = (SOURCE / "examples/crossed_fit.toml").read_text()
        for args in (("--json",), ()):
            taken = piped(wish, "fit", "-", "--take", "1", *args).stdout
            self.assertEqual(piped(taken, "pair", "-").returncode, 0, taken)
        search = '[search]\nratio = 2\nmodules_mm = [2]\npinion_teeth = 20\ncenter_distance_mm = [60, 62]\n'
        taken = piped(search, "search", "-", "--take", "1", "--json").stdout
        self.assertEqual(piped(taken, "pair", "-").returncode, 0, taken)

    def test_angles_come_back_as_they_were_given(self):
        for angle in (15, 60, 7.3, 33.333, 0.1, -12.34567, 29.9999999999):
            spec = PAIR.replace("= -15", f"= {-angle}").replace("= 15", f"= {angle}")
            gears = json.loads(piped(spec, "gear", "-", "--json").stdout)["gears"]
            self.assertEqual([g["helix_angle_deg"] for g in gears], [angle, -angle])

    def test_titles_are_only_shown(self):
        title = 'gear 😀 \u0085 \x1b[31mred\x07 \x7f "quoted" \\ \u009b31m'
        tree = tomllib.loads((SOURCE / "examples/crossed_fit.toml").read_text()) | {"title": title + "\x00"}
        taken = piped(json.dumps(tree), "fit", "-", "--take", "1").stdout
        self.assertEqual(tomllib.loads(taken)["title"], title + "\x00")
        for verb in ("gear", "pair", "contact", "compensate", "measure"):
            p = piped(taken, verb, "-")
            self.assertEqual(p.returncode, 0, p.stderr)
            for raw_character in "\x1b\x07\x00\x7f\u0085\u009b":
                self.assertNotIn(raw_character, p.stdout + p.stderr, verb)
        self.assertIn("😀", piped(taken, "pair", "-").stdout)


class Tables(unittest.TestCase):
    def test_pair_as_csv(self):
        rows = table(Run("pair", PAIR, "--csv").out)
        self.assertEqual(rows[0], ["key", "quantity", "symbol", "unit", "first", "second"])
        self.assertTrue(all(len(r) == 6 for r in rows))
        said = {r[0]: r[1:] for r in rows}
        answer = Run("pair", PAIR, "--json").json
        self.assertEqual([float(x) for x in said["gears.tip_diameter_mm"][3:]], [g["tip_diameter_mm"] for g in answer["gears"]])
        self.assertEqual(float(said["pair.contact_ratio"][3]), answer["pair"]["contact_ratio"])
        self.assertEqual([float(x) for x in said["pair.backlash.rotation_deg"][3:]], answer["pair"]["backlash"]["rotation_deg"])
        self.assertEqual(said["pair.center_distance_mm"][2], "mm")
        self.assertEqual(raw("pair", "x.toml", "--csv", "--json").returncode, 2)

    def test_csv_has_what_only_gear_2_has_and_longer_lists(self):
        keys = [row[0] for row in table(Run("pair", PAIR, "--csv").out)]
        for end in ("1", "2", "3"):
            self.assertIn(f"pair.sliding_velocity_mm_per_rad.total.{end}", keys)
        bulge = {"gear1": {"teeth": 20, "normal_module_mm": 2.5, "face_width_mm": 25},
                 "gear2": {"teeth": 60, "normal_module_mm": 2.5, "face_width_mm": 25, "profile_shift": 0,
                           "tip_diameter_mm": 153.5,
                           "cut_by": {"teeth": 10, "profile_shift": 0, "rack": {"addendum": 1.25}}}}
        rows = {row[0]: row for row in table(Run("pair", json.dumps(bulge), "--csv", name="pair.json").out)}
        self.assertEqual(rows["gears.tip_bulge_mm"][4], "")
        self.assertAlmostEqual(float(rows["gears.tip_bulge_mm"][5]), 8.0247e-3, places=6)

    def test_contact_as_csv(self):
        spec = PAIR + "[errors]\ncrossing_deg = 0.1\n[contact]\npositions = 16\n"
        rows = table(Run("contact", spec, "--csv").out)
        positions = Run("contact", spec, "--json").json["contact"]["positions"]
        self.assertEqual(len(rows), 1 + len(positions))
        self.assertEqual(len(set(rows[0])), len(rows[0]))
        for name in ("rotation1_deg", "transmission_error_arcsec", "point_mm.3", "rack_angle_deg"):
            column = rows[0].index(name)
            for row, p in zip(rows[1:], positions):
                self.assertEqual(len(row), len(rows[0]))
                self.assertEqual(float(row[column]), p["point_mm"][2] if "." in name else p[name])

    def test_outline_as_csv(self):
        rows = table(Run("outline", PAIR, "--points", 5, "--csv").out)
        arcs = Run("outline", PAIR, "--points", 5, "--json").json["arcs"]
        self.assertEqual(rows[0], ["arc", "x_mm", "y_mm"])
        self.assertEqual([[float(x) for x in r[1:]] for r in rows[1:]], [p for a in arcs for p in a["points"]])


class Folders(unittest.TestCase):
    def test_only_some_files(self):
        r = Run("run", PAIR, "--only", "svg,report")
        self.assertEqual(r.files(), ["case.toml", "case_out/gear1.svg", "case_out/gear2.svg", "case_out/report.html"])
        r = Run("run", PAIR, "--only", "result,glb", "--json")
        self.assertEqual(r.files(), ["case.toml", "case_out/pair.glb", "case_out/result.json"])
        self.assertEqual(json.loads((r.folder / "case_out/result.json").read_text())["pair"], r.json["pair"])
        for wrong in ("pdf", "", "step,"):
            self.assertEqual(Run("run", PAIR, "--only", wrong).status, 2, wrong)

    def test_a_run_clears_up_after_its_former_run_and_nobody_else(self):
        folder = str(new_folder())
        run = lambda spec, *args: self.assertEqual(Run("run", spec, "--out", folder + "/o", *args, folder=folder).status, 0)
        out = pathlib.Path(folder) / "o"
        run(PAIR)
        self.assertTrue((out / "gear2.stl").exists())
        (out / "notes.txt").write_text("mine")
        (out / "gear2.svg").write_text("drawn anew by hand")
        (out / "gear2.dxf").unlink()
        (out / "gear2.dxf").symlink_to(out / "notes.txt")
        with (out / ".gearwright_files").open("a") as file:
            file.write(f"00000000 4 notes.txt\n00000000 9 ../case.toml\n00000000 0 .\nrubbish\n")
        run(GEAR)
        left = sorted(f.name for f in out.iterdir())
        self.assertEqual([f for f in left if "gear2" in f or "pair" in f or "notes" in f], ["gear2.dxf", "gear2.svg", "notes.txt"])
        self.assertTrue((pathlib.Path(folder) / "case.toml").exists())
        self.assertTrue((out / "gear1.stl").exists())
        run(GEAR, "--only", "svg")
        self.assertEqual(sorted(f.name for f in out.iterdir()),
                         [".gearwright_files", "gear1.svg", "gear2.dxf", "gear2.svg", "notes.txt"])
        # If a run fails, it removes no file.
        Run("run", GEAR.replace("20", "-20") + "tip_diameter_mm = -1\n", "--out", folder + "/o", folder=folder)
        self.assertTrue((out / "gear1.svg").exists())


class Batches(unittest.TestCase):
    def test_one_answer_per_line_in_order(self):
        specs = [{"gear1": {"teeth": 17 + i % 50, "normal_module_mm": 2}, "gear2": {"teeth": 60}} for i in range(300)]
        specs[7] = {"gear1": {"teeth": 17, "module": 2}}
        specs[9] = {"gear1": {"teeth": 30, "normal_module_mm": 1}}
        lines = [json.dumps(s) for s in specs]
        lines[11] = "{nonsense"
        text = "\n".join(lines) + "\n"
        p = piped(text, "batch")
        self.assertEqual(p.returncode, 1)
        answers = [json.loads(line) for line in p.stdout.splitlines()]
        self.assertEqual(len(answers), 300)
        for i, (spec, a) in enumerate(zip(specs, answers)):
            if i in (7, 11):
                self.assertIn("error", a)
            else:
                self.assertEqual(a["gears"][0]["teeth"], spec["gear1"]["teeth"])
        self.assertEqual(answers[7]["error"]["key"], "gear1.module")
        self.assertNotIn("pair", answers[9])
        self.assertEqual(piped(text, "batch", "--threads", "1").stdout, p.stdout)
        with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
            file.write(text)
            file.flush()
            self.assertEqual(piped("", "batch", file.name).stdout, p.stdout)
        # The last line may have no line feed.
        self.assertEqual(len(piped(lines[0] + "\n" + lines[1], "batch", "-").stdout.splitlines()), 2)

    def test_the_answers_are_those_of_the_verb(self):
        for verb in ("gear", "pair", "measure", "contact"):
            p = piped(json.dumps(tomllib.loads(PAIR)) + "\n", "batch", verb)
            self.assertEqual(json.loads(p.stdout), Run(verb, PAIR, "--json").json, verb)
        for args in (("run",), ("gaer",), ("pair", "a", "b"), ("--threads", "0")):
            self.assertEqual(piped("", "batch", *args).returncode, 2, args)
        self.assertEqual(piped("", "batch", "no_such.jsonl").returncode, 3)
        self.assertEqual([piped("", "batch").returncode, piped("", "batch").stdout], [0, ""])


class Racks(Asked):
    def test_a_default_fillet_always_fits(self):
        rack = "[gear1]\nteeth = 30\nnormal_module_mm = 2\nhelix_angle_deg = 20\n[gear1.rack]\nkind = \"circular_arc\"\ncutter = \"P\"\narc_radius = 1.4\ncenter_a = {}\ncenter_b = {}\n"
        from math import cos, pi, radians, sin
        for psi in (20, 25, 28, 30):  # full radius 0.80, 0.73, 0.62, 0.44
            a, b = 1.4 * cos(radians(psi)) - pi / 4, 1.4 * sin(radians(psi)) - 0.45
            r = Run("gear", rack.format(round(a, 6), round(b, 6)), "--json")
            self.assertEqual(r.status, 0, r.err)
            given = Run("gear", rack.format(round(a, 6), round(b, 6)) + "root_fillet_radius = 0.5\n", "--json")
            self.assertEqual(given.status, 1 if psi == 30 else 0)
            if psi == 30:
                self.assertEqual(given.json["error"]["key"], "gear1.rack.root_fillet_radius")
            else:
                self.assertEqual(given.out, r.out)


class Made(unittest.TestCase):
    def test_completion_knows_every_verb_and_option(self):
        options = set(re.findall(r"^  (?:-\w,)?(--[a-z0-9-]+)", raw("export", "--help").stdout, re.M))
        self.assertIn("--mesh-tolerance", options)
        for shell in ("bash", "zsh", "fish"):
            p = raw("completion", shell)
            self.assertEqual(p.returncode, 0)
            for word in ("compensate", "batch", "schema", *(o.lstrip("-") for o in options)):
                self.assertIn(word, p.stdout, shell)
            if shutil.which(shell) and shell != "fish":
                check = subprocess.run([shell, "-n"], input=p.stdout, capture_output=True, text=True)
                self.assertEqual([check.returncode, check.stderr], [0, ""])
        self.assertEqual(raw("completion", "tcsh").returncode, 2)

    def bash_completes(self, *words):
        script = raw("completion", "bash").stdout
        ask = script + "COMP_WORDS=(%s)\nCOMP_CWORD=%d\ncompopt() { :; }\n_gearwright\necho ${COMPREPLY[*]}" % (
            " ".join(f"'{w}'" for w in words), len(words) - 1)
        return subprocess.run(["bash", "-c", ask], capture_output=True, text=True).stdout.split()

    def test_bash_completes(self):
        self.assertEqual(self.bash_completes("gearwright", "comp"), ["compensate", "completion"])
        self.assertEqual(self.bash_completes("gearwright", "schema", "s"), ["spec"])
        self.assertIn("--csv", self.bash_completes("gearwright", "pair", "x.toml", "--"))
        self.assertEqual(self.bash_completes("gearwright", "outline", "--gear", ""), ["1", "2"])
        self.assertEqual(self.bash_completes("gearwright", "help", "pai"), ["pair"])

    def test_the_manual_page_names_keys_and_verbs(self):
        page = raw("manual").stdout
        for word in ("normal_module_mm", "backlash_mm", "gearwright compensate", ".SH \"EXIT STATUS\""):
            self.assertIn(word, page.replace("\\-", "-"))
        if shutil.which("man"):
            with tempfile.NamedTemporaryFile("w", suffix=".1") as file:
                file.write(page)
                file.flush()
                p = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", file.name], capture_output=True, text=True,
                                   env=os.environ | {"LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANROFFSEQ": ""})
                self.assertEqual([p.returncode, p.stderr], [0, ""])


if __name__ == "__main__":
    unittest.main()
