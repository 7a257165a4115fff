"""Tests gears, pairs and drives of specs in inch. Names without a unit are in mm and rad, and gears keep their units."""

import copy
import pickle

import numpy as np
import pytest

import gearwright as gw
from common import pair

SPEC = {"units": "inch", "gear1": {"teeth": 17, "normal_diametral_pitch_per_in": 10, "face_width_in": 1},
        "gear2": {"teeth": 43}, "pair": {"center_distance_in": 3.01}}


def inches(**more):
    return gw.load({**SPEC, **more})


def test_a_gear_keeps_its_units():
    # Regression: each of these raised an error about face_width_in, because the gear had lost its units.
    p = inches()
    for gear in (p.gear1, p.gear2):
        assert gear.spec["units"] == "inch" and gear.face_width == 25.4
        assert pickle.loads(pickle.dumps(gear)) == gear == copy.copy(gear) == gw.Gear(**gear.spec)
        assert gear.replace(teeth=18).teeth == 18 and gear.replace(face_width=50.8).spec["face_width_in"] == 2
        assert gw.solve(gear)["gears"][0]["face_width_in"] == 1 and "span" in gw.measure(gear)
    again = gw.Pair(p.gear1, p.gear2, center_distance_in=3.01)
    assert again.spec["units"] == "inch" and again.contact_ratio == pytest.approx(p.contact_ratio, rel=1e-12)
    assert p.replace(gear2=p.gear2.replace(teeth=44)).gear2.teeth == 44
    assert gw.load({"gear1": p.gear1, "gear2": p.gear2}).gear1 == p.gear1
    single = gw.Gear(units="inch", teeth=20, normal_diametral_pitch_per_in=8, face_width_in=0.3333333333333333)
    assert single.spec["face_width_in"] == 0.3333333333333333 and single.replace(teeth=21).face_width == single.face_width
    with pytest.raises(gw.SpecError, match="inch"):
        gw.Gear(units="furlong", teeth=20, normal_module=2)


def test_units_are_converted():
    p = inches()
    metric = p.replace(units="mm")
    assert "units" not in metric.spec and metric.spec["gear1"]["face_width_mm"] == 25.4
    assert metric.contact_ratio == p.contact_ratio and metric.center_distance == pytest.approx(76.454, abs=1e-12)
    assert metric.replace(units="inch").spec["pair"]["center_distance_in"] == 3.01
    assert pair().replace(units="inch").contact_ratio == pytest.approx(pair().contact_ratio, rel=1e-12)
    mixed = gw.Pair(p.gear1, metric.gear2, center_distance=76.5)
    assert mixed.spec["units"] == "inch" and mixed.spec["gear2"]["face_width_in"] == 1
    assert gw.Pair(p.gear1, metric.gear2, units="mm").spec["gear1"]["face_width_mm"] == 25.4
    assert gw.Gear(**p.gear1.spec).replace(units="mm").spec["face_width_mm"] == 25.4


def test_names_are_in_mm():
    p = inches()
    assert p.replace(center_distance=76.5).center_distance == pytest.approx(76.5, abs=1e-12)
    assert p.replace(center_distance=76.2).spec["pair"]["center_distance_in"] == 3
    assert p.replace(gear1={"face_width": 12.7}).gear1.spec["face_width_in"] == 0.5
    row = p.contact(errors=[0.0254, 0, 0, 0, 0, 0])
    assert row.spec["errors"]["center_distance_in"] == 0.001
    by_name, by_key = p.contact(errors={"center_distance": 0.0254}), p.contact(errors={"center_distance_in": 0.001})
    assert by_name.as_dict() == by_key.as_dict() == row.as_dict()
    assert p.contact(marking=0.00635).spec["contact"]["marking_in"] == 0.00025
    relieved = p.contact(modifications={"gear1": {"tip_relief": 0.0127}})
    assert relieved.spec["gear1"]["modifications"]["tip_relief_uin"] == 500
    assert gw.Gear(units="inch", teeth=20, normal_module=2.54, face_width=25.4).spec["face_width_in"] == 1
    for given in (lambda: p.replace(center_distance_mm=76.5), lambda: p.contact(errors={"center_distance_mm": 0.02})):
        with pytest.raises(gw.SpecError, match="center_distance_in"):
            given()


def test_sweep():
    p = inches()
    by_name, by_key = p.sweep(center_distance=[76.2, 76.5]), p.sweep(center_distance_in=np.array([76.2, 76.5]) / 25.4)
    assert by_name["center_distance_mm"] == pytest.approx([76.2, 76.5], abs=1e-12)
    assert by_name["backlash_normal_mm"] == pytest.approx(by_key["backlash_normal_mm"], abs=1e-12)
    refused = p.sweep(center_distance_mm=[76.2])["error"][0]
    with pytest.raises(gw.SpecError) as e:
        p.replace(center_distance_mm=76.2)
    assert refused == str(e.value)
