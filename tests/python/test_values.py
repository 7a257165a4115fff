"""Tests Gear and Pair as values: made and read by name, changed by replace(). Errors name the invalid
key."""

import copy
import errno
import json
import math
import os
import pickle

import numpy as np
import pytest

import gearwright as gw
from common import pair, pinion, wheel


def test_numbers_of_the_front_door():
    # docs/programming.md shows the same pair in C++.
    p = pair()
    assert f"{p.gear1.tip_diameter:.4f}" == "50.4992"
    assert f"{p.contact_ratio:.4f}" == "2.2772"
    assert f"{p.backlash.normal:.4f}" == "0.1214"
    assert p.gear1.base_diameter == p.gear1.as_dict()["base_diameter_mm"]
    assert p.gear1.helix_angle == pytest.approx(math.radians(15), rel=1e-15)
    assert p["center_distance_mm"] == p.center_distance == 78.6056


def test_names_and_keys_say_the_same():
    by_name = gw.Gear(teeth=17, normal_module=2.5, helix_angle=math.radians(15))
    by_key = gw.Gear(teeth=np.int64(17), normal_module_mm=np.float32(2.5), helix_angle_deg=15)
    assert by_name.helix_angle == pytest.approx(by_key.helix_angle, rel=1e-15)
    table = {"tip_relief": 0.02, "tip_relief_start": 48.0}
    relieved = pinion(modifications=table)
    assert relieved.spec["modifications"]["tip_relief_um"] == 20.0
    with pytest.raises(gw.SpecError) as e:
        gw.Gear(teeth=17, normal_module=2.5, normal_module_mm=2.5)
    assert e.value.key == "normal_module_mm"


def test_replace():
    p = pair()
    further = p.replace(center_distance=79)
    assert further.center_distance == 79 and p.center_distance == 78.6056
    assert further.backlash.normal > p.backlash.normal
    assert p.replace(gear1={"profile_shift": 0.2}).gear1.profile_shift == 0.2
    assert p.replace(gear1={"profile_shift": 0.2}).replace(gear1={"profile_shift": None}).spec == \
        p.replace(gear1=p.gear1.replace(profile_shift=None)).spec
    assert p.replace(gear2=wheel(teeth=44)).gear2.teeth == 44
    assert pinion().replace(teeth=19).teeth == 19
    assert "thickness_allowance_mm" not in pinion().replace(thickness_allowance=None).spec
    # If no centre distance is given, it follows from the teeth.
    assert p.replace(center_distance=None).center_distance == pytest.approx(78.6056, abs=1e-4)


def test_a_gear_of_a_pair_stands_by_itself():
    shifts_wanted = gw.Pair(gw.Gear(teeth=17, normal_module=2), gw.Gear(teeth=30, normal_module=2),
                            center_distance=48)
    again = gw.Gear(**shifts_wanted.gear1.spec)
    assert again.profile_shift == shifts_wanted.gear1.profile_shift != 0
    assert again.tip_diameter == shifts_wanted.gear1.tip_diameter


def test_a_chosen_shift_is_said():
    gears = [gw.Gear(teeth=z, normal_module=2.5, helix_angle_deg=beta) for z, beta in ((17, 15), (43, -15))]
    chosen = gw.Pair(*gears, center_distance=79)
    x = [g.profile_shift for g in (chosen.gear1, chosen.gear2)]
    assert f"profile_shift={x[0]:.4g} / {x[1]:.4g} (chosen)" in repr(chosen)
    notes = [w for w in chosen.warnings if w.code == "profile_shifts_chosen"]
    assert len(notes) == 1 and f"{x[0]:.6g}" in notes[0].message
    assert {f.level for f in chosen.verdict.findings if f.code == "profile_shifts_chosen"} == {"green"}
    assert "chosen" not in repr(pair()) and "chosen" not in repr(gw.Pair(*gears))
    with pytest.raises(gw.SpecError, match="choose_profile_shifts"):
        gw.Pair(*gears, center_distance=79, choose_profile_shifts=False)
    again = gw.Pair(chosen.gear1, chosen.gear2, center_distance=79, choose_profile_shifts=False)
    assert again.contact_ratio == chosen.contact_ratio


def test_values_compare_copy_and_travel():
    assert pair() == pair() and hash(pair()) == hash(pair()) and pair() != pair(center_distance=79)
    assert pinion() == pinion() and pinion() != wheel() and pinion() != "pinion"
    for value in (pinion(), pair()):
        assert pickle.loads(pickle.dumps(value)) == value == copy.deepcopy(value) == copy.copy(value)
    assert "Gear(teeth=17" in repr(pinion()) and "Pair(17 / 43" in repr(pair())


def same(a, b):
    """Checks that two values have the same type and the same numbers, bit for bit, in JSON and in every
    attribute."""
    assert type(a) is type(b) and json.dumps(a.as_dict()) == json.dumps(b.as_dict())
    for name in (n for n in dir(a) if not n.startswith("_")):
        one, other = getattr(a, name), getattr(b, name)
        if isinstance(one, np.ndarray):
            assert one.dtype == other.dtype and one.tobytes() == other.tobytes(), name
        elif not callable(one):
            assert repr(one) == repr(other), name


def test_answers_copy_and_travel():
    p = pair(errors={"crossing_deg": 0.02})
    contact = p.contact(positions=16, pattern=True, errors={"crossing_deg": 0.03},
                        modifications={"gear1": {"lead_crowning_um": 4}})
    steel = {"name": "18CrNiMo7-6"}
    steels = p.replace(gear1={"material": steel}, gear2={"material": steel})
    rating = steels.rate(power_kW=10, speed_rpm=1480, quality=6, face_load_factor=1.2)
    loaded = p.loaded(torque_Nm=[50, 100], positions=4, slices=8, accuracy="draft")
    search = {"search": {"ratio": [3.0, 3.05], "modules_mm": [2, 2.5], "pinion_teeth": [14, 30]}}
    searches = [gw.search(search, progress=False), gw.search(search, progress=False, top=3),
                gw.search({"search": {**search["search"], "contact_ratio_min": 2.5}}, progress=False)]
    records = [p.backlash, p.verdict, contact.pattern, contact.verdict, loaded.torques[1], searches[0][1],
               gw.fit({"gear1": {"teeth": 17, "normal_module_mm": 2}, "gear2": {"teeth": 43},
                       "pair": {"center_distance_mm": 61, "shaft_angle_deg": 20}})]
    for value in [contact, rating, loaded, *searches, *records]:
        assert copy.copy(value) is value and copy.deepcopy(value) is value  # values are immutable
        again = pickle.loads(pickle.dumps(value))
        same(value, again)
        same(value, pickle.loads(pickle.dumps(again)))
    again = pickle.loads(pickle.dumps(searches))
    assert searches[2].changes and [s.changes for s in again] == [s.changes for s in searches]
    assert again[0].pair(1) == searches[0].pair(1) and again[0].report() == searches[0].report()
    assert again[0].to_numpy().tobytes() == searches[0].to_numpy().tobytes()
    assert pickle.loads(pickle.dumps(contact)).report() == contact.report()
    for error in (gw.SpecError("key", "1", "allowed", "message"), gw.FileError("disk full"),
                  gw.ContractViolation("a defect")):
        assert pickle.loads(pickle.dumps(error)).args == error.args


def test_a_search_of_a_file_travels(tmp_path):
    path = tmp_path / "search.toml"
    path.write_text('title = "from a file"\n[search]\nratio = [3.0, 3.05]\nmodules_mm = [2]\npinion_teeth = [14, 30]\n')
    found = gw.search(path, progress=False)
    path.unlink()
    again = pickle.loads(pickle.dumps(found))
    assert json.dumps(again.as_dict()) == json.dumps(found.as_dict()) and again.report() == found.report()


@pytest.mark.parametrize("call", [
    gw.load, lambda name: gw.search(name, progress=False), lambda name: pinion().stl(name),
    lambda name: pair().drawing(name), lambda name: gw.verify(name),
    lambda name: gw.search({"search": {"ratio": 2, "modules_mm": [2], "pinion_teeth": [20, 22]}}, progress=False, out=name)])
def test_what_is_no_name_of_a_file_is_said(call):
    with pytest.raises(ValueError) as e:
        call("a\0b")
    assert "cast" not in str(e.value) and "incompatible" not in str(e.value)


@pytest.mark.parametrize("call", [gw.verify, gw.load, gw.search, gw.solve, gw.fit, gw.measure, gw.identify, gw.compensate,
                                  pinion().stl, pair().drawing, pair().stl])
@pytest.mark.parametrize("wrong", [True, 1, 2.5, 1j])
def test_a_number_is_no_file(call, wrong):
    # A whole number is a descriptor of an open file. Regression: True stood for standard output and closed
    # it.
    with pytest.raises((TypeError, gw.SpecError)) as e:
        call(wrong)
    assert "cast" not in str(e.value)
    os.fstat(1), os.fstat(2)


def test_a_dict_with_itself_in_it():
    inner = {}
    inner["gear1"] = inner
    for call in (gw.load, gw.solve, lambda spec: gw.Gear(**spec), lambda spec: pair().contact(errors=spec)):
        with pytest.raises((RecursionError, gw.SpecError)):
            call(inner)


def test_a_record_or_a_search_is_no_spec():
    # Regression: each of these ended the interpreter, because it has keys or positions but no items.
    found = gw.search({"search": {"ratio": [3.0, 3.05], "modules_mm": [2], "pinion_teeth": [14, 30]}}, progress=False)
    for value in (pair().backlash, found, pair().verdict):
        for call in (gw.load, lambda v: gw.Gear(teeth=v, normal_module=2), lambda v: pinion().replace(rack=v)):
            with pytest.raises((gw.SpecError, TypeError)):
                call(value)


def test_every_quantity_is_an_attribute():
    for value, table in ((pinion(), "gear"), (pair(), "pair")):
        keyed = value.as_dict()
        for said in gw._core._catalogue()[table]:
            attribute = getattr(value, said["name"])
            assert getattr(type(value), said["name"]).__doc__ == said["doc"]
            if isinstance(attribute, float) and said["unit"] in ("mm", "") and said["key"] in keyed:
                assert attribute == keyed[said["key"]]


def test_an_absent_quantity_is_none():
    # Regression: records lacked the quantities that do not apply, although the stubs give `| None`.
    tables = gw._core._catalogue()
    rack = gw.load({"gear1": {"teeth": 20, "normal_module": 2, "face_width": 20}, "gear2": {"form": "rack"}})
    for record, table in ((pair().backlash, "pair.backlash"), (rack.backlash, "rack_pair.backlash"), (rack.rack, "rack"),
                          (pair().verdict, "verdict"), (pair().contact(positions=8), "contact")):
        names = [entry["name"] for entry in tables[table]]
        assert all(hasattr(record, name) for name in names), [n for n in names if not hasattr(record, n)]
    with pytest.raises(gw.SpecError, match="rack"):
        rack.animate()


def test_items_by_key():
    for value in (pinion(), pair(), pair().contact(positions=8)):
        assert list(value) == list(value.as_dict()) and all(key in value for key in value) and "nothing" not in value
        first = next(iter(value))
        assert value[first] == value.as_dict()[first]


def test_answers_compare():
    p = pair()
    steels = p.replace(gear1={"material": {"name": "18CrNiMo7-6"}}, gear2={"material": {"name": "18CrNiMo7-6"}})
    rate = dict(torque_Nm=150, speed_rpm=1480, quality=6, face_load_factor=1.2)
    load = dict(torque_Nm=[50], positions=4, slices=8, accuracy="draft")
    for make, other in ((lambda: p.contact(positions=8), p.contact(positions=16)),
                        (lambda: steels.rate(**rate), steels.rate(**{**rate, "torque_Nm": 100})),
                        (lambda: p.loaded(**load), p.loaded(**{**load, "torque_Nm": [60]}))):
        assert make() == make() != other and hash(make()) == hash(make()) and make() != p


def test_an_object_without_a_value():
    # Regression: the attributes of such an object read memory that no constructor had set.
    for type_, use in ((gw.Contact, lambda o: o.positions), (gw.Search, repr), (gw.Gear, lambda o: o.teeth),
                       (gw.Pair, repr), (type(pinion().figures[0]), lambda o: o.title)):
        with pytest.raises(TypeError):
            use(type_.__new__(type_))


def test_numbers_of_other_types():
    # Regression: a long double raised RecursionError, and bytes were a list of numbers.
    assert pinion(thickness_allowance=np.longdouble("-0.05")) == pinion()
    assert gw.Gear(teeth=17, normal_module=2, thickness_allowance=np.array([-0.1, -0.05], np.longdouble)).spec[
        "thickness_allowance_mm"] == [-0.1, -0.05]
    for wrong in (b"\0\1", bytearray(b"\0\1"), np.clongdouble(1)):
        with pytest.raises(TypeError, match="cannot contain"):
            pinion(thickness_allowance=wrong)


def test_a_right_angle_is_no_forgotten_unit():
    with pytest.raises(gw.SpecError, match="89") as e:
        pinion(helix_angle_deg=None, helix_angle=math.pi / 2)
    assert "1.5708" not in str(e.value)


def test_a_drawing_has_one_format(tmp_path):
    assert pinion().drawing(format="svg").startswith(b"<") and pinion().drawing().startswith(b"%PDF")
    assert pinion().drawing(tmp_path / "g.pdf", format="pdf").exists()
    with pytest.raises(gw.SpecError, match="contradicts") as e:
        pinion().drawing(tmp_path / "h.pdf", format="svg")
    assert e.value.key == "format" and not (tmp_path / "h.pdf").exists()


def test_measure_and_verify(tmp_path):
    # Regression: the dimensions of gear 2 were dropped for a spec.
    path = tmp_path / "pair.json"
    path.write_text(json.dumps(pair().spec))
    assert gw.measure(pair().spec) == gw.measure(path) == gw.measure(pair()) and len(gw.measure(pair())) == 2
    assert gw.measure(pinion()) == gw.measure({"gear1": pinion().spec})
    for reader in (gw.verify, gw.load):
        with pytest.raises(gw.FileError, match="none.json") as missing:
            reader(tmp_path / "none.json")
        assert missing.value.errno == errno.ENOENT and missing.value.filename == str(tmp_path / "none.json")
        again = pickle.loads(pickle.dumps(missing.value))
        assert (again.errno, again.filename, str(again)) == (errno.ENOENT, missing.value.filename, str(missing.value))
    with pytest.raises(gw.FileError) as absent:
        pinion().stl(tmp_path / "absent" / "gear.stl")
    assert absent.value.errno == errno.ENOENT and absent.value.filename == str(tmp_path / "absent" / "gear.stl")
    for call, needs in ((gw.search, "search"), (gw.identify, "measured"), (gw.Drive, "planetary")):
        with pytest.raises(gw.SpecError, match=needs) as e:
            call({})
        assert e.value.key == "spec"


def test_records():
    backlash = pair().backlash
    assert "normal" in dir(backlash) and backlash["normal_mm"] == backlash.normal
    assert backlash.as_dict() == pair().as_dict()["backlash"]
    with pytest.raises(AttributeError, match="nothing"):
        backlash.nothing
    assert pair().verdict.level in ("green", "amber", "red")


@pytest.mark.parametrize("change, key, allowed", [
    ({"teeth": 0}, "teeth", "internal gear"),
    ({"teeth": 17.5}, "teeth", "whole"),
    ({"normal_module": -1}, "normal_module_mm", "0.001"),
    ({"normal_module": math.nan}, "normal_module", "finite"),
    ({"profile_shift": math.inf}, "profile_shift", "finite"),
    ({"helix_angle_deg": 95}, "helix_angle_deg", "89"),
    ({"helix_angle_deg": [0.1, 0.2]}, "helix_angle_deg", "number"),
    ({"tip_diameter": 10}, "tip_diameter_mm", "root diameter"),
    ({"modul": 2}, "modul", "module"),
    ({"rack": {"addendum": -3}}, "rack.addendum", ""),
    ({"teeth": 10 ** 30}, "teeth", "larger than"),
])
def test_what_is_wrong_is_named(change, key, allowed):
    with pytest.raises(gw.SpecError) as e:
        pinion(**change)
    assert e.value.key == key and allowed in e.value.allowed
    assert str(e.value) == e.value.message and key in e.value.message and "gear1" not in str(e.value)
    assert isinstance(e.value, ValueError) and pickle.loads(pickle.dumps(e.value)).key == key


def test_negative_teeth_outside_and_inside():
    ring = gw.Gear(teeth=-66, normal_module=1.5)  # an internal gear
    assert ring.teeth == -66
    with pytest.raises(gw.SpecError) as e:
        gw.Pair(ring, gw.Gear(teeth=21, normal_module=1.5))
    assert e.value.key.startswith("gear1")


def test_errors_of_a_pair():
    with pytest.raises(gw.SpecError) as e:
        pair(center_distance=10)
    assert e.value.key == "pair.center_distance_mm" and e.value.value == "10"
    with pytest.raises(gw.SpecError) as e:
        pair(center_distanc=10)
    assert "center_distance_mm" in str(e.value)
    with pytest.raises(gw.SpecError) as e:
        gw.Pair(pinion(), wheel(helix_angle_deg=15))
    assert e.value.key == "gear2.helix_angle_deg"
    with pytest.raises(TypeError):
        pinion(teeth=object())


def test_load(tmp_path):
    path = tmp_path / "gear.toml"
    path.write_text("[gear1]\nteeth = 21\nnormal_module_mm = 2\n")
    assert gw.load(path).teeth == 21 and isinstance(gw.load(str(path)), gw.Gear)
    with pytest.raises(OSError):
        gw.load(tmp_path / "none.toml")
    path.write_text("[gear1]\nteeth = 21\nnormal_module_mm = -2\n")
    with pytest.raises(gw.SpecError) as e:
        gw.load(path)
    assert e.value.key == "gear1.normal_module_mm"


def test_a_double_helical_gear_is_the_whole_gear():
    gear = gw.Gear(teeth=15, normal_module=1.5, helix_angle_deg=30, face_width=20, double_helical={"gap": 4})
    assert gear.face_width == 20 and gear["half_face_width_mm"] == 8 and "Double-helical" in gear.report()
    vertices, _ = gear.mesh()
    assert vertices[:, 2].min() == -10 and vertices[:, 2].max() == 10 and 2 in vertices[:, 2]
    pair = gw.Pair(gear, gw.Gear(teeth=40, normal_module=1.5, helix_angle_deg=-30, face_width=20, double_helical={"gap": 4}))
    contact = pair.contact(errors={"intersecting": 0.0005})
    # The curves of both flanks, and for each half the patterns on both gears.
    assert len(contact.figures) == 6
    first, second = contact.halves
    assert first["peak_to_peak_arcsec"] != second["peak_to_peak_arcsec"]
    # Many mountings are supported only for gears with one helix.
    with pytest.raises(gw.SpecError) as e:
        pair.transmission_error([[0.0] * 6])
    assert e.value.key == "gear1.double_helical"
