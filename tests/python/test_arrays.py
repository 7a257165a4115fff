"""Tests arrays. They contain the numbers of the JSON as columns, are not copied if possible, and may be
used by any number of threads."""

import json
import math
import subprocess

import numpy as np
import pytest

import gearwright as gw
from common import BIN, SOURCE, pair, pinion, wheel

ARCSEC = math.radians(1 / 3600)
ERRORS = {"crossing_deg": 0.03, "center_distance": 0.02, "helix_slope1_um": 4}
MODIFICATIONS = {"gear1": {"tip_relief_um": 15, "lead_crowning_um": 8, "tip_relief_start_mm": 48.0},
                 "gear2": {"lead_crowning": 0.004}}


def told(p, **tables):
    """Returns the result of the verb contact."""
    spec = json.dumps({**p.spec, **tables})
    run = subprocess.run([BIN, "batch", "contact"], input=spec, capture_output=True, text=True, check=True)
    return json.loads(run.stdout)["contact"]


def test_contact_has_the_numbers_of_the_program():
    c = pair().contact(errors=ERRORS, positions=32)
    json_of = told(pair(), errors={"crossing_deg": 0.03, "center_distance_mm": 0.02, "helix_slope1_um": 4},
                   contact={"positions": 32})
    assert json.dumps(c.as_dict()) == json.dumps(json_of)
    table = c.positions
    assert len(table) == 32
    for row, entry in zip(table, json_of["positions"], strict=True):
        for key in ("rotation1_deg", "transmission_error_arcsec", "kind"):
            assert row[key] == entry[key]
        assert row["point_mm"].tolist() == entry["point_mm"] and row["diameter_mm"].tolist() == entry["diameter_mm"]
        ellipse = entry["ellipse"]
        assert ellipse is None or row["ellipse_semi_minor_mm"] == ellipse["semi_minor_mm"]
    assert c.transmission_error == pytest.approx(table["transmission_error_arcsec"] * ARCSEC, rel=1e-15)
    assert c.peak_to_peak == pytest.approx(json_of["peak_to_peak_arcsec"] * ARCSEC)
    assert c.harmonics.shape == (len(json_of["harmonics_arcsec"]),)
    every = {said["key"] for said in gw._core._catalogue()["contact.positions"] if not said["of"]}
    assert every <= set(table.dtype.names)


def test_modifications():
    c = pair().contact(modifications=MODIFICATIONS, positions=16, pattern=True)
    assert c.spec["gear2"]["modifications"] == {"lead_crowning_um": 4.0}
    assert c.peak_to_peak > 0 and c.pattern.gear1.gap.ndim == 2
    with pytest.raises(gw.SpecError) as e:
        pair().contact(modifications={"gear1": {"tip_relif_um": 3}})
    assert "tip_relief_um" in str(e.value)
    with pytest.raises(gw.SpecError) as e:
        pair().contact(modifications={"gear3": {}})
    assert e.value.key == "modifications.gear3"


def test_a_row_of_errors_is_a_contact_of_its_own():
    p, rng = pair(), np.random.default_rng(1)
    errors = rng.normal(0, [0.01, 2e-4, 2e-4, 0.1, 0.004, 0.004], (12, 6))
    te = p.transmission_error(errors, positions=16)
    assert te.shape == (12, 16)
    for row, curve in zip(errors, te, strict=True):
        c = p.contact(errors=row, positions=16)
        assert np.allclose(np.ptp(curve), c.peak_to_peak, rtol=1e-9, atol=1e-15)
    assert gw.ERRORS[:2] == ("center_distance", "crossing") and len(gw.ERRORS) == 8
    wider = np.hstack([errors, np.zeros((12, 2))])
    assert np.array_equal(p.transmission_error(wider, positions=16), te)


def test_bits_do_not_depend_on_threads():
    p = pair()
    errors = np.random.default_rng(2).normal(0, 1e-3, (40, 6))
    one = p.transmission_error(errors, positions=8, threads=1)
    assert np.array_equal(one, p.transmission_error(errors, positions=8, threads=2), equal_nan=True)
    assert np.array_equal(one, p.transmission_error(np.asfortranarray(errors), positions=8), equal_nan=True)
    assert np.array_equal(one[::2], p.transmission_error(errors[::2], positions=8), equal_nan=True)


@pytest.mark.parametrize("errors, key", [
    (np.zeros(6), "errors"),
    (np.zeros((3, 5)), "errors"),
    (np.zeros((2, 3, 6)), "errors"),
    ("many", "errors"),
    ([[0, math.nan, 0, 0, 0, 0]], "errors[0].crossing_deg"),
    ([[0] * 6, [0, 0, 0, 0, math.inf, 0]], "errors[1].helix_slope1_um"),
    ([[0, 1.0, 0, 0, 0, 0]], "errors[0].crossing_deg"),
    ([[0] * 6 + [1.5, 0]], "errors[0].cutter_lead1_deg"),
])
def test_what_is_no_array_of_errors_is_named(errors, key):
    with pytest.raises(gw.SpecError) as e:
        pair().transmission_error(errors)
    assert e.value.key == key and e.value.allowed


NO_REAL_NUMBERS = [np.zeros((1, 6), dtype=complex), np.zeros((1, 6), dtype="m8[ns]"), np.zeros((1, 6), dtype="m8[s]"),
                   np.zeros((1, 6), dtype="M8[D]"), np.zeros((1, 6), dtype=bool), np.zeros((1, 6), dtype=object),
                   np.zeros((1, 6)).astype(str), np.ma.masked_array(np.zeros((1, 6)), mask=True), [[1j] * 6],
                   [["1"] * 6], [[None] * 6]]


@pytest.mark.parametrize("given", NO_REAL_NUMBERS, ids=lambda a: str(np.asarray(a).dtype) + type(a).__name__)
def test_numbers_are_real(given):
    row = given[0]
    for call, key in ((lambda: pair().transmission_error(given), "errors"), (lambda: pair().contact(errors=row), "errors"),
                      (lambda: pair().sweep(center_distance=row), "pair.center_distance"),
                      (lambda: pair().sweep(gear1={"profile_shift": row}), "gear1.profile_shift")):
        with pytest.raises(gw.SpecError) as e:
            call()
        assert e.value.key == key
    for form in (gw.involute, gw.inverse_involute, lambda a: gw.contact_ratio(17, 43, a), gw.shift_limits,
                 lambda a: gw.backlash(17, 43, 0, 0, a), lambda a: gw.center_distance(17, 43, helix_angle=a)):
        with pytest.raises(TypeError, match="real number"):
            form(row)


def test_times_are_no_numbers_of_a_spec():
    for time in (np.timedelta64(17, "ns"), np.datetime64(17, "ns"), np.array([17], "m8[ns]")):
        with pytest.raises(TypeError):
            gw.Gear(teeth=time, normal_module=2)


def test_sweep_has_the_whole_message():
    rows = pair().sweep(center_distance=[10.0, 78.7])
    with pytest.raises(gw.SpecError) as e:
        pair().replace(center_distance=10.0)
    assert list(rows["error"]) == [str(e.value), ""] and len(str(e.value)) > 80
    assert rows["center_distance_mm"][1] == 78.7 and math.isnan(rows["center_distance_mm"][0])
    assert pair().sweep(center_distance=[])["error"].shape == (0,)


def plain(**more):
    gears = [gw.Gear(teeth=z, normal_module=2.5, face_width=25) for z in (17, 43)]
    return gw.Pair(*gears, **more)


def test_sweep_and_replace_agree():
    # Regression: backlash=[0.1] was an angle of 0.1 rad, because only keys without a list of numbers could be varied.
    row = plain().sweep(backlash=[0.1])[0]
    assert row["backlash_normal_mm"] == plain().replace(backlash=0.1).backlash.normal == pytest.approx(0.1)
    basic = gw.load(SOURCE / "examples" / "basic_gear_pair.toml")
    rated = gw.load(SOURCE / "examples" / "rated_pair.toml")
    # Regression: the rules between several keys applied to replace() only.
    for p, change in ((pair(), {"backlash_deg": 0.1}), (pair(), {"backlash": 0.1}), (basic, {"gear1": {"profile_shift": 0.123}}),
                      (basic, {"gear1": {"teeth": 10}}), (rated, {"speed_rpm": 500}), (pair(), {"shaft_angle": 30}),
                      (pair(), {"gear2": {"teeth": 43.5}}), (pair(), {"gear1": {"normal_module": -1}})):
        with pytest.raises(gw.SpecError) as e:
            p.replace(**change)
        as_row = {k: {name: [x] for name, x in v.items()} if isinstance(v, dict) else [v] for k, v in change.items()}
        row = p.sweep(**as_row)[0]
        assert row["error"] == str(e.value) and math.isnan(row["center_distance_mm"]), change
    shifts = [-0.2, 0.1, 0.4]
    rows = pair().sweep(gear1={"profile_shift": shifts}, center_distance=[78.4, 78.6, 78.9])
    for row, x, a in zip(rows, shifts, rows["center_distance_mm"], strict=True):
        alone = pair().replace(gear1={"profile_shift": x}, center_distance=a)
        assert not row["error"] and row["backlash_normal_mm"] == alone.backlash.normal


def test_sweep_needs_two_gears():
    rack = gw.load({"gear1": {"teeth": 20, "normal_module": 2, "face_width": 20}, "gear2": {"form": "rack"}})
    with pytest.raises(gw.SpecError) as e:
        rack.sweep(center_distance=[20.0])
    assert e.value.key.startswith("gear2")


def test_a_forgotten_unit_is_named():
    for make, name, remedy in ((lambda: gw.Gear(teeth=17, normal_module=2, helix_angle=15), "helix_angle",
                                "in rad; use helix_angle_deg = 15"),
                               (lambda: pair().contact(errors={"crossing": 2}), "errors.crossing",
                                "in rad; use crossing_deg = 2")):
        with pytest.raises(gw.SpecError, match=remedy) as e:
            make()
        assert e.value.key.endswith(name.split(".")[-1])


def test_arguments_without_effect_are_rejected():
    for kind, argument in (("step", "tolerance"), ("svg", "tolerance"), ("step", "splines"), ("stl", "splines")):
        with pytest.raises(gw.SpecError, match="effect") as e:
            getattr(pinion(), kind)(**{argument: 0.01 if argument == "tolerance" else True})
        assert e.value.key == argument


def test_sweep_wants_a_dict_of_a_gear():
    for wrong in (5, [0.1, 0.2], "profile_shift"):
        with pytest.raises(gw.SpecError) as e:
            pair().sweep(gear1=wrong)
        assert e.value.key == "gear1"


def test_threads_in_range():
    for threads in (-1, 10 ** 6):
        for call in (lambda n: pair().transmission_error(np.zeros((1, 6)), threads=n),
                     lambda n: pair().sweep(center_distance=[78.7], threads=n),
                     lambda n: gw.search({"search": {"ratio": 2, "modules_mm": [2], "pinion_teeth": [20, 22]}}, threads=n)):
            with pytest.raises(gw.SpecError) as e:
                call(threads)
            assert e.value.key == "threads"


def test_positions_in_range():
    for positions in (-1, 0, 10 ** 8):
        with pytest.raises(gw.SpecError) as e:
            pair().transmission_error(np.zeros((1, 6)), positions=positions)
        assert e.value.key == "positions"


def test_outline():
    arcs = pinion().outline(points=50)
    assert list(arcs) == ["root_land", "root_fillet", "flank", "tip_land"]
    assert all(a.dtype == float and a.shape[1] == 2 for a in arcs.values()) and arcs["flank"].shape == (50, 2)
    assert np.array_equal(arcs["root_fillet"][-1], arcs["flank"][0])
    assert np.hypot(*arcs["tip_land"].T) * 2 == pytest.approx(pinion().tip_diameter)
    section = pinion().section(points=10)
    assert np.array_equal(section[0], section[-1])
    area = 0.5 * abs(np.sum(section[:-1, 0] * section[1:, 1] - section[1:, 0] * section[:-1, 1]))
    assert math.pi * pinion().root_diameter ** 2 / 4 < area < math.pi * pinion().tip_diameter ** 2 / 4
    for wrong in (lambda: pinion().outline(points=1), lambda: pinion(teeth=900).section(points=100_000)):
        with pytest.raises(gw.SpecError) as e:
            wrong()
        assert e.value.key == "points"
    severed = gw.Gear(teeth=5, normal_module=1, profile_shift=-3)
    with pytest.raises(gw.SpecError) as e:
        severed.outline()
    assert e.value.key == "profile_shift"


def test_mesh_is_closed_and_not_copied():
    vertices, triangles = pinion(bore={"diameter": 12}).mesh(tolerance=0.02)
    assert vertices.dtype == np.float64 and triangles.dtype == np.uint32
    assert vertices.base is not None and not vertices.flags.owndata
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    back = {(b, a) for a, b in edges.tolist()}
    assert len(back) == len(edges) and all(tuple(e) in back for e in edges.tolist())
    assert vertices[:, 2].min() == -12.5 and vertices[:, 2].max() == 12.5
    for value in (pinion(), pinion(helix_angle_deg=0), pair()):
        kinds = ("mesh",) * (value != pair()) + ("step", "stl", "glb", "threemf", "dxf", "svg", "drawing")
        for kind in kinds:  # Regression: 1e-300 caused an endless loop
            for tolerance in (math.nan, math.inf, 0.0, -1.0, 1e-300, 1e-8, 11):
                with pytest.raises(gw.SpecError) as e:
                    getattr(value, kind)(tolerance=tolerance)
                assert e.value.key == "tolerance"


def test_files(tmp_path):
    assert pinion().stl()[80:84] != b"\0\0\0\0" and pair().glb()[:4] == b"glTF"
    assert pinion().threemf()[:2] == b"PK" and b"SECTION" in pinion().dxf() and pinion().svg().startswith(b"<")
    for value in (pinion(), pair()):
        assert value.step().startswith(b"ISO-10303-21;")
    path = pinion().stl(tmp_path / "gear.stl", tolerance=0.05)
    assert path.read_bytes() == pinion().stl(tolerance=0.05)
    with pytest.raises(OSError):
        pinion().stl(tmp_path / "none" / "gear.stl")


def test_drawing(tmp_path):
    for form, start in (("pdf", b"%PDF"), ("svg", b"<"), ("dxf", b"0\nSECTION")):
        assert pinion().drawing(format=form).startswith(start)
    path = pair().drawing(tmp_path / "drawing.PDF", sheet="A3")
    assert path.read_bytes() == pair().drawing(sheet="A3") != pair().drawing()
    (tmp_path / "pair.json").write_text(json.dumps(pair().spec))
    for more, value in (([], pair()), (["--gear", "2"], pair().gear2)):
        subprocess.run([BIN, "export", tmp_path / "pair.json", "--drawing", tmp_path / "told.svg", *more], check=True)
        assert value.drawing(format="svg") == (tmp_path / "told.svg").read_bytes()
    for wrong, key in (({"path": "drawing.png"}, "path"), ({"format": "png"}, "format"), ({"sheet": "A5"}, "sheet"),
                       ({"tolerance": 0}, "tolerance")):
        with pytest.raises(gw.SpecError) as e:
            pinion().drawing(**wrong)
        assert e.value.key == key


def test_pose():
    first, second = pair().pose(1), pair().pose(2)
    assert first.shape == (4, 4) and np.allclose(first[:3, :3].T @ first[:3, :3], np.eye(3))
    assert second[0, 3] == pair().center_distance and np.array_equal(first[3], [0, 0, 0, 1])
    with pytest.raises(gw.SpecError):
        pair().pose(3)


def test_shows_itself():
    for value in (pinion(), pair(), pair().contact(positions=16)):
        html = value._repr_html_()
        assert html.startswith("<iframe") and "prefers-color-scheme" in html and "&lt;svg" in html
    assert pair().report().startswith("<!DOCTYPE html>") and "Tooth contact" in pair().contact(positions=16).report()
    assert pinion().report().startswith("<!DOCTYPE html>")


def test_closed_forms_are_those_of_pairs():
    z1, z2 = np.array([12, 17, 23]), np.array([30, 43, 71])
    x1, x2 = np.array([0.4, 0.3, 0.0]), np.array([0.1, 0.1, -0.2])
    beta = math.radians(15)
    table = gw.pair_table(z1, z2, x1, x2, beta, normal_module=2.5)
    for i in range(3):
        g1 = gw.Gear(teeth=z1[i], normal_module=2.5, helix_angle=beta, profile_shift=x1[i], face_width=20)
        p = gw.Pair(g1, g1.replace(teeth=z2[i], helix_angle=-beta, profile_shift=x2[i]))
        assert table["center_distance"][i] == pytest.approx(p.center_distance, rel=1e-12)
        assert table["working_pressure_angle"][i] == pytest.approx(p.working_transverse_pressure_angle[0], rel=1e-12)
        assert table["contact_ratio"][i] == pytest.approx(p.transverse_contact_ratio, rel=1e-11)
        assert table["tip_thickness1"][i] == pytest.approx(p.gear1.tip_tooth_thickness_normal, rel=1e-11)
        further = p.replace(center_distance=p.center_distance + 0.1)
        j = gw.backlash(z1[i], z2[i], x1[i], x2[i], further.center_distance, beta, normal_module=2.5)
        assert isinstance(j, float) and j == pytest.approx(further.backlash.normal, rel=1e-9)
        if g1.undercut is False:  # the form circle of ISO53-A, whose straight flank has this depth
            depth = 1.25 - 0.38 * (1 - math.sin(math.radians(20)))
            true = gw.pair_table(z1[i], z2[i], x1[i], x2[i], beta, normal_module=2.5, flank_depth=depth)
            assert true["contact_ratio_true"] == pytest.approx(p.transverse_contact_ratio_true, rel=1e-11)
    assert all(math.isnan(v) for z in (0, 0.5, math.nan) for v in gw.pair_table(z, 43).values())
    assert gw.center_distance(z1[:, None], z2).shape == (3, 3)
    assert gw.working_pressure_angle(17, 43) == pytest.approx(math.radians(20), rel=1e-14)


def test_columns_and_single_numbers_broadcast_alike():
    z1, x, beta = np.arange(12.0, 40.0)[:, None], np.linspace(-0.2, 0.5, 900), math.radians(12)
    ones = np.ones((28, 900))
    for form, given in ((gw.contact_ratio, (z1, 43, x, 0.1, beta)), (gw.backlash, (z1, 43, x, 0.1, 40.0, beta)),
                        (gw.inverse_involute, (0.1 * x,)), (gw.involute, (x,))):
        found = form(*given)
        assert np.array_equal(found, form(*(g * ones[: found.shape[0]] if found.ndim == 2 else g for g in given)),
                              equal_nan=True)
        last = form(*(np.broadcast_to(g, found.shape).flat[-1] for g in given))
        assert isinstance(last, float) and last == found.flat[-1]
    assert gw.backlash([], 43, 0, 0, 30.0).shape == (0,) and gw.center_distance(z1, 43, []).shape == (28, 0)
    assert gw.inverse_involute(np.float32(0)) == 0.0


def test_closed_forms_out_of_their_domain():
    assert np.isnan(gw.involute([math.pi / 2, math.nan])).all() and gw.involute(0.0) == 0.0
    y = np.linspace(-2, 2, 401)
    assert gw.involute(gw.inverse_involute(y)) == pytest.approx(y, rel=1e-13, abs=1e-16)
    assert math.isnan(gw.inverse_involute(math.inf)) and math.isnan(gw.contact_ratio(17, 43, -60, 0))
    assert np.isnan(gw.backlash([17, 0, 17.5], 43, 0, 0, [1.0, 30, 30])).all()
    least, greatest = gw.shift_limits([10, 17, 30, 0, 17.5])
    assert least[:3] == pytest.approx([1 - z * math.sin(math.radians(20)) ** 2 / 2 for z in (10, 17, 30)])
    assert (greatest[:3] > least[:3]).all() and np.isnan(least[3:]).all()
    assert gw.Gear(teeth=10, normal_module=1, profile_shift=least[0] + 1e-9).undercut is False
    assert gw.Gear(teeth=10, normal_module=1, profile_shift=least[0] - 1e-3).undercut is True
    with pytest.raises(ValueError, match="could not be broadcast|shape mismatch"):
        gw.center_distance([1, 2], [1, 2, 3])
    # Regression: these rows were numbers, such as a centre distance of -60 mm for a module of -2 mm.
    table = gw.pair_table([17, 17, 17, -17, -43, 43, 17], [43, 43, 43, -43, 17, -17, -43],
                          normal_module=[-2, 0, math.inf, 1, 1, 1, 1])
    for name, column in table.items():
        assert np.isnan(column[:-1]).all() and not math.isnan(column[-1]), name
    assert gw.center_distance(17, -43) == pytest.approx(13) and math.isnan(gw.contact_ratio(17, 43, normal_module=0))


def test_shift_limits():
    # Regression: the least shift of an internal gear was the end of the searched shifts, -65 for 60 teeth.
    least, greatest = gw.shift_limits([-60, -20])
    assert np.isneginf(least).all()
    ring = gw.Gear(teeth=-60, normal_module=1, profile_shift=greatest[0] - 1e-9)
    assert ring.tip_diameter == pytest.approx(ring.base_diameter, abs=1e-7)
    thick = gw.shift_limits(-60, tip_thickness=0.9)
    assert -5 < thick[0] < thick[1] == greatest[0]
    ring = gw.Gear(teeth=-60, normal_module=1, profile_shift=thick[0])
    assert ring.tip_tooth_thickness_normal == pytest.approx(0.9, abs=1e-9)
    pinion = gw.Gear(teeth=17, normal_module=1, profile_shift=gw.shift_limits(17)[1])
    assert pinion.tip_tooth_thickness_normal == pytest.approx(0.2, abs=1e-9)


@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_numbers_for_all_rows_are_finite(number):
    # Regression: pair_table(17, 43, addendum=nan) had sliding = inf
    for form, names in ((lambda **a: gw.pair_table(17, 43, **a), ("addendum", "dedendum", "flank_depth")),
                        (lambda **a: gw.shift_limits(17, **a), ("tip_thickness", "addendum", "flank_depth")),
                        (lambda **a: gw.backlash(17, 43, 0, 0, 30.5, **a), ("normal_module",))):
        for name in names:
            with pytest.raises(ValueError, match=f"^{name} = {number}: must be finite"):
                form(**{name: number})


def test_arguments_of_closed_forms_are_named():
    row = np.array([1.0, 1.2])
    for call, name in ((lambda: gw.pair_table(17, 43, addendum=row), "addendum"),
                       (lambda: gw.pair_table(17, 43, flank_depth=[1, 2]), "flank_depth"),
                       (lambda: gw.pair_table(17, 43, normal_pressure_angle=row), "normal_pressure_angle"),
                       (lambda: gw.pair_table(17, 43, columns="contact_ratio"), "columns"),
                       (lambda: gw.backlash(17, 43, 0, 0, 31, normal_module=row), "normal_module"),
                       (lambda: gw.shift_limits(17, tip_thickness=row), "tip_thickness"),
                       (lambda: gw.center_distance(17, 43, module=2), r"center_distance\(\).*'module'.*normal_module"),
                       (lambda: gw.contact_ratio(17, 43, columns=("sliding",)), r"contact_ratio\(\).*'columns'")):
        with pytest.raises(TypeError, match="^" + name):
            call()
    with pytest.raises(ValueError, match="'foo'.*contact_ratio_true"):
        gw.pair_table(17, 43, columns=("foo",))
    assert gw.pair_table(17, 43, addendum=np.array(1.0), columns=["sliding"]).keys() == {"sliding"}


@pytest.mark.parametrize("angle", [5.0, -1.0, 0.0, math.pi / 2, math.nan, math.inf, 1e308])
def test_closed_forms_want_a_pressure_angle(angle):
    # Regression: shift_limits terminated the interpreter for 5 rad
    for form in (lambda **a: gw.shift_limits(17, **a), lambda **a: gw.contact_ratio(17, 43, **a),
                 lambda **a: gw.backlash(17, 43, 0, 0, 30.5, **a)):
        with pytest.raises(ValueError, match="normal_pressure_angle"):
            form(normal_pressure_angle=angle)


def test_wheel_of_the_pair_is_a_left_hand():
    assert wheel().helix_angle < 0
