"""Tests missing and unknown input. All missing values are reported at once, before any computation. The
program reports values that gear 2 inherits and values that it chooses. Unsupported keys and wrong
words have specific messages with suggestions."""
import time
import unittest

from cli import SOURCE, Run

TWO = "[gear1]\nteeth = 17\nnormal_module_mm = 2.5\n{}\n[gear2]\nteeth = 43\n{}\n"
RATING = "[rating]\ntorque_Nm = 50\nspeed_rpm = 1500\nquality = 6\nface_load_factor = 1.2\n"
STEEL = '[gear{}.material]\nname = "{}"\n'
LOAD = "[load]\ntorque_Nm = 100\n"
KEYS = {"rating.torque_Nm": "torque_Nm = 50", "rating.speed_rpm": "speed_rpm = 1500", "rating.quality": "quality = 6",
        "rating.face_load_factor": "face_load_factor = 1.2", "gear1.material": '"16MnCr5"'}


class Asked(unittest.TestCase):
    def refused(self, verb, spec, key, *words, none=()):
        run = Run(verb, spec, "--json")
        self.assertEqual(run.status, 1, f"{spec}\n{run.out[:300]}")
        error = run.json["error"]
        self.assertEqual(error["key"], key, run.err)
        for word in words:
            self.assertIn(word, error["message"])
        for word in none:
            self.assertNotIn(word, error["message"])
        return error["message"]

    def answer(self, verb, spec, *options):
        run = Run(verb, spec, "--json", *options)
        self.assertEqual(run.status, 0, f"{spec}\n{run.err}")
        return run.json

    def notes(self, answer, code):
        self.assertEqual([f["level"] for f in answer["verdict"]["findings"] if f["code"] == code],
                         ["green"] * sum(w["code"] == code for w in answer["warnings"]))
        return [(w["gear"], w["message"]) for w in answer["warnings"] if w["code"] == code]


class Lacking(Asked):
    def test_run_computes_nothing_first(self):
        spec = TWO.format("face_width_mm = 25", "face_width_mm = 25") + LOAD + RATING.replace("quality = 6\n", "")
        start = time.monotonic()
        message = self.refused("run", spec, "gear1.material", "rating.quality (", "quality = 6")
        self.assertLess(time.monotonic() - start, 2.0)  # loaded contact alone takes longer
        self.assertNotIn("load", message.replace("face load", "").replace("face_load", ""))

    def test_every_verb_says_all_at_once(self):
        gears = TWO.format("", "")
        self.refused("rate", gears, "rating", *KEYS, *KEYS.values())
        self.refused("rate", gears + "[rating]\n", "rating.torque_Nm", *list(KEYS)[1:], *KEYS.values())
        self.refused("run", gears + "[rating]\n", "rating.torque_Nm", *list(KEYS)[1:], *KEYS.values())
        self.refused("load", gears, "load.torque_Nm", "torque_Nm = 100", none=("rating",))
        aim = '[compensate]\naim = "pressure"\n[rating]\n'
        self.refused("compensate", gears + aim, "load.torque_Nm", none=("rating",))
        self.refused("run", gears + aim, "load.torque_Nm", *KEYS)
        # For a single gear or an empty file, the message lists the missing data of the gears and the missing
        # data for the verb.
        alone = "[gear1]\nteeth = 17\n"
        self.refused("rate", alone, "gear1.normal_module_mm", "gear2 (", *KEYS.values())
        self.refused("load", alone, "gear1.normal_module_mm", "gear2 (", "torque_Nm = 100")
        self.refused("pair", "title = \"nothing\"\n", "gear1", "gear2")
        self.refused("pair", "[gear1]\n[gear2]\n", "gear1.teeth", "gear1.normal_module_mm", "gear2.teeth",
                     none=("gear2.normal_module_mm",))
        self.refused("pair", ByName.GEAR + "[gear2]\n", "gear2.teeth", none=("module",))
        self.refused("rate", gears + "[rating]\npower_kW = 5\n", "rating.speed_rpm", "rating.quality (", "gear1.material",
                     none=("rating.torque_Nm",))
        # If there is any other error, only this error is reported.
        self.refused("rate", gears + "[rating]\nquality = 13\n", "rating.quality", none=("missing",))

    def test_what_no_rating_is_for_lacks_nothing(self):
        crossed = TWO.format("helix_angle_deg = 45", "helix_angle_deg = 45") + "[pair]\nshaft_angle_deg = 90\n"
        self.refused("rate", crossed, "pair.shaft_angle_deg", none=("missing",))
        arcs = (SOURCE / "examples" / "circular_arc_drive.toml").read_text()
        self.refused("rate", arcs, "gear1.rack", "ISO 6336", none=("missing",))

    def test_a_search_with_its_rating(self):
        # A search has a default face load factor.
        needed = {key: example for key, example in KEYS.items() if key != "rating.face_load_factor"}
        self.refused("search", "[search]\nsafety_flank_min = 1.2\n[rating]\n", "search.ratio", *needed, none=("face_load_factor",))
        self.refused("search", "[search]\nobjective = \"safety\"\n", "search.ratio", "rating (", *needed.values())
        self.refused("search", "[search]\n[rating]\n", "search.ratio", none=("rating",))

    def test_what_is_not_computed_is_not_lacking(self):
        gears = TWO.format("", "")
        for verb in ("gear", "pair", "contact"):
            self.answer(verb, gears + "[rating]\n")
        self.answer("rate", gears + STEEL.format(1, "16MnCr5") + RATING)


class Inherited(Asked):
    def test_gear_2_takes_the_face_width_of_gear_1(self):
        gears = "[gear1]\nteeth = 17\nnormal_module_mm = 2\nface_width_mm = 30\n[gear2]\nteeth = 43\n{}"
        def widths(own, pair=""):
            return [g["face_width_mm"] for g in self.answer("pair", gears.format(own) + pair)["gears"]]
        self.assertEqual(widths(""), [30, 30])
        self.assertEqual(widths("face_width_mm = 25\n"), [30, 25])
        self.assertEqual(widths("helix_angle_deg = 40\n", "[pair]\nshaft_angle_deg = 40\n"), [30, 20])

    def test_material_and_quality_of_gear_1(self):
        both = self.answer("rate", TWO.format("", "") + STEEL.format(1, "16MnCr5") + STEEL.format(2, "16MnCr5") + RATING)
        one = self.answer("rate", TWO.format("", "") + STEEL.format(1, "16MnCr5") + RATING)
        self.assertEqual(one["rating"], both["rating"])
        self.assertEqual(self.notes(one, "inherited"), [(2, "Gear 2 takes these absent values from gear 1: material 16MnCr5.")])
        self.assertEqual(self.notes(both, "inherited"), [])
        # The accuracy grade may be in three tables: of the gear, of its tolerances, or [rating].
        rating = RATING.replace("quality = 6\n", "")
        for words in ("quality = 6", "[gear1.tolerance]\nquality = 6"):
            given = self.answer("rate", TWO.format(words, "") + STEEL.format(1, "16MnCr5") + rating)
            self.assertEqual(given["rating"], both["rating"])
            self.assertEqual(self.notes(given, "inherited"), [(2, "Gear 2 takes these absent values from gear 1: material 16MnCr5, quality 6.")])
        mixed = self.answer("rate", TWO.format("quality = 6", "quality = 8") + STEEL.format(1, "16MnCr5") + rating)
        as_list = self.answer("rate", TWO.format("", "") + STEEL.format(1, "16MnCr5") + rating + "quality = [6, 8]\n")
        self.assertEqual(mixed["rating"], as_list["rating"])

    def test_readings_of_a_known_gear_change_nothing_that_is_missing(self):
        spec = TWO.format("face_width_mm = 20", "[gear2.measured]\nspan_uncertainty_mm = 0.01")
        self.refused("scatter", spec, "scatter.errors", "is missing")
        self.refused("load", spec, "load.torque_Nm", "is missing")

    def test_material_by_its_name_alone(self):
        short, steel = 'material = "16MnCr5"\n', STEEL.format(1, "16MnCr5")
        named = self.answer("rate", TWO.format(short, "") + RATING)
        table = self.answer("rate", TWO.format("", "") + steel + RATING)
        self.assertEqual(named["rating"], table["rating"])
        in_rating = self.answer("rate", TWO.format("", "") + RATING + short)
        self.assertEqual(in_rating["rating"], table["rating"])
        self.refused("rate", TWO.format('material = "16MnCr6"\n', "") + RATING, "gear1.material.name", "16MnCr6", "16MnCr5")
        self.refused("rate", TWO.format("material = 45\n", "") + RATING, "gear1.material", "must be a table")
        drawn = self.answer("gear", '[drawing]\nmaterial = "C45"\n' + TWO.format(short, ""))
        self.assertEqual(drawn["drawing"]["material"], "C45")

    def test_material_in_rating(self):
        common = '[rating.material]\nname = "16MnCr5"\n'
        both = self.answer("rate", TWO.format("", "") + STEEL.format(1, "16MnCr5") + STEEL.format(2, "16MnCr5") + RATING)
        shared = self.answer("rate", TWO.format("", "") + RATING + common)
        self.assertEqual(shared["rating"], both["rating"])
        own = TWO.format("", "") + STEEL.format(2, "42CrMo4")
        unlike = self.answer("rate", own + STEEL.format(1, "16MnCr5") + RATING)
        self.assertEqual(self.answer("rate", own + RATING + common)["rating"], unlike["rating"])
        self.refused("rate", TWO.format("", "") + RATING + "[rating.material]\nsigma_Hlim_MPa = 1500\n",
                     "rating.material.sigma_Flim_MPa", "is missing")

    def test_tolerances_of_gear_2(self):
        gears = self.answer("measure", TWO.format("quality = 6", ""))["gears"]
        same = self.answer("measure", TWO.format("quality = 6", "quality = 6"))["gears"]
        self.assertEqual(gears, same)


class Chosen(Asked):
    SPEC = "[gear1]\nteeth = 17\nnormal_module_mm = 2.5\nhelix_angle_deg = 15\n{}\n[gear2]\nteeth = 43\n{}\n[pair]\ncenter_distance_mm = 79\n"

    def test_a_chosen_shift_is_said(self):
        answer = self.answer("pair", self.SPEC.format("", ""))
        x = [g["profile_shift"] for g in answer["gears"]]
        self.assertNotEqual(x, [0, 0])
        words = f"For the centre distance a = 79 mm these profile shifts were chosen: gear1.profile_shift = {x[0]:.6g} and gear2.profile_shift = {x[1]:.6g}."
        self.assertEqual(self.notes(answer, "profile_shifts_chosen"), [(None, words)])
        out = Run("pair", self.SPEC.format("", "")).out
        self.assertIn("note: " + words, " ".join(out.split()))
        self.assertLessEqual(max(len(line) for line in out[out.index("note: "):].splitlines()), 80)
        half = self.answer("pair", self.SPEC.format("profile_shift = 0.3", ""))
        self.assertIn(": gear2.profile_shift = ", self.notes(half, "profile_shifts_chosen")[0][1])
        self.assertEqual(self.notes(self.answer("pair", self.SPEC.format("profile_shift = 0", "profile_shift = 0")),
                                    "profile_shifts_chosen"), [])
        no_distance = self.SPEC.format("", "").replace("center_distance_mm = 79\n", "")
        self.assertEqual(self.notes(self.answer("pair", no_distance), "profile_shifts_chosen"), [])

    def test_the_pinion_of_an_internal_pair_is_not_undercut(self):
        """Regression: 12 teeth in a ring of 40 at 22 mm had x1 = -0.77 and x2 = 0, and a contact ratio of 0.487."""
        ring = "[gear1]\nteeth = {}\nnormal_module_mm = 1.5\nface_width_mm = 10\n[gear2]\nteeth = -40\n[pair]\ncenter_distance_mm = {}\n"
        answer = self.answer("pair", ring.format(12, 22) + "backlash_mm = 0.2\n")
        x = [g["profile_shift"] for g in answer["gears"]]
        self.assertEqual([g["undercut"] for g in answer["gears"]], [False, False])
        self.assertAlmostEqual(x[0], 0.39, 12)  # h_Ff* - z sin²α/2 + 0.1/(2 m tan α), rounded up to two decimals
        self.assertGreater(answer["pair"]["contact_ratio_true"], 1.2)
        # A pinion of 20 teeth is not undercut without a shift, so it gets the whole sum.
        x = [g["profile_shift"] for g in self.answer("pair", ring.format(20, 14.7))["gears"]]
        self.assertGreater(x[0], 0)
        self.assertEqual(x[1], 0)

    def test_it_can_be_forbidden(self):
        x = [g["profile_shift"] for g in self.answer("pair", self.SPEC.format("", ""))["gears"]]
        forbid = "choose_profile_shifts = false\n"
        self.refused("pair", self.SPEC.format("", "") + forbid, "gear1.profile_shift", "pair.choose_profile_shifts = false",
                     "pair.center_distance_mm = 79", f"gear1.profile_shift = {x[0]:.6g}", f"gear2.profile_shift = {x[1]:.6g}")
        self.refused("pair", self.SPEC.format("profile_shift = 0.3", "") + forbid, "gear2.profile_shift", "gear2.profile_shift = ")
        self.answer("pair", self.SPEC.format("profile_shift = 0", "profile_shift = 0") + forbid)
        self.answer("pair", self.SPEC.format("", "").replace("center_distance_mm = 79\n", forbid))


class NoModule(Asked):
    def test_the_module_that_fits_is_named(self):
        pair = "[gear1]\nteeth = 12\n[gear2]\nteeth = 36\n[pair]\ncenter_distance_mm = 40\n"
        for verb in ("pair", "fit", "run"):
            self.refused(verb, pair, "gear1.normal_module_mm", "centre distance of 40 mm, normal_module_mm is 1.66667", "[search]")
        helical = pair.replace("teeth = 12", "teeth = 12\nhelix_angle_deg = 20")
        self.refused("pair", helical, "gear1.normal_module_mm", "normal_module_mm is 1.56615")  # 80 cos 20°/48

    def test_readings_have_a_table(self):
        for verb in ("identify", "gear"):
            self.refused(verb, "[gear1]\nteeth = 34\ntip_diameter_mm = 45.1\n", "gear1.normal_module_mm",
                         "give readings in [gear1.measured]", "identify")


class ByName(Asked):
    GEAR = "[gear1]\nteeth = 20\nnormal_module_mm = 2\n"

    def test_what_does_not_exist_here(self):
        gear, two = self.GEAR, self.GEAR + "[gear2]\nteeth = 61\n"
        for spec, key, *words in (
                (two + "[gear3]\nteeth = 20\n", "gear3", "at most two gears", "[[stage]]"),
                (gear + "form = \"bevel\"\n", "gear1.form", "cylindrical gears and racks only"),
                (gear + "cone_angle_deg = 45\n", "gear1.cone_angle_deg", "bevel gears"),
                (gear + "[worm]\nstarts = 1\n", "worm", "not bevel gears or worm gears"),
                (gear + "[gear1.bore]\nshape = \"D\"\n", "gear1.bore.shape", "a bore is round"),
                (two + "[rack]\nteeth = 20\n", "rack", "A rack that meshes with gear 1 is described by [gear2]", "[gear1.rack]"),
                (gear + "[gear2]\nteeth = 0\n", "gear2.teeth", "form = \"rack\"", "teeth = -61"),
                (gear + "form = \"rack\"\n", "gear1.form", "must not be a rack"),
                (two + "[pair]\nherringbone = true\n", "pair.herringbone", "[gear1.double_helical]", "gap_mm = 0"),
                (gear + "herringbone = true\n", "gear1.herringbone", "[gear1.double_helical]", "gap_mm = 0"),
                (gear + "units = \"inch\"\n", "gear1.units", "at the top of the spec"),
                (gear + "[gear1.rack]\npoints = [[0, 0], [1, 1]]\n", "gear1.rack.points", "not supported", "arcs"),
                (gear + "internal = true\n", "gear1.internal", "teeth = -61"),
                (gear + "[gear1.measured]\nhelix_deg = 15\n", "gear1.measured.helix_deg", "helix_angle_deg")):
            for verb in ("gear", "pair", "run"):
                self.refused(verb, spec, key, *words, none=("did you mean", "nearest", "unknown key", "missing"))
        # A misspelt key that is close to a known key has the usual message.
        self.refused("gear", gear + "teethh = 3\n", "gear1.teethh", "did you mean teeth?")

    def test_a_word_that_is_meant(self):
        search = "[search]\nratio = 2\npinion_teeth = [12, 40]\nmodules_mm = 2\nobjective = {}\n"
        for wrong, near in (("weight", "mass"), ("strength", "safety"), ("Mass", "mass"), ("slidng", "sliding")):
            self.refused("search", search.format(f'"{wrong}"'), "search.objective", f"unknown objective; did you mean {near}?")
        self.refused("search", search.format('["ratio", "weight"]'), "search.objective",
                     "unknown objective weight; did you mean mass?")
        self.refused("search", search.format('"colour"'), "search.objective", "contact_ratio, ratio, size", none=("did you mean",))
        for wrong in ("brass", "unobtainium"):
            self.refused("rate", self.GEAR + STEEL.format(1, wrong), "gear1.material.name", "18CrNiMo7-6", "sigma_Hlim_MPa",
                         "youngs_modulus_MPa", none=("did you mean",))
        for wrong in ("POM", "PA66"):  # the table of materials contains no plastics
            self.refused("rate", self.GEAR + STEEL.format(1, wrong), "gear1.material.name", "is a plastic", "sigma_Hlim_MPa",
                         "youngs_modulus_MPa", none=("did you mean", "18CrNiMo7-6"))
        for wrong, near in (("C45", "C45N"), ("16mncr5", "16MnCr5"), ("18CrNiMo7", "18CrNiMo7-6")):
            self.refused("rate", self.GEAR + STEEL.format(1, wrong), "gear1.material.name", f"did you mean {near}?")


if __name__ == "__main__":
    unittest.main()
