"""Tests strength and loaded contact in Python. The results equal the program's JSON, bit for bit."""

import json
import subprocess

import numpy as np
import pytest

import gearwright as gw
from common import BIN, SOURCE, batch, pair

STEEL = {"material": {"name": "18CrNiMo7-6"}}
LOAD = {"torque_Nm": 150, "speed_rpm": 1480, "quality": 6, "face_load_factor": 1.2}
COARSE = {"torque_Nm": [60, 200], "positions": 6, "slices": 8, "accuracy": "draft"}


def program(verb, path):
    return json.loads(subprocess.run([BIN, verb, str(path), "--json"], capture_output=True, text=True, check=True).stdout)


def of_steel():
    return pair().replace(gear1=STEEL, gear2=STEEL)


def same(answer, told, table):
    assert json.dumps(answer.as_dict()) == json.dumps(told[table])
    assert json.dumps(answer.verdict.as_dict()) == json.dumps(told["verdict"])
    assert [w["message"] for w in answer.warnings] == [w["message"] for w in told["warnings"]]


def test_a_rating_is_the_program_s():
    path = SOURCE / "examples/rated_pair.toml"
    rating = gw.load(path).rate()
    told = program("rate", path)
    same(rating, told, "rating")
    assert list(rating.S_H) == told["rating"]["S_H"] and rating.sigma_H[0] == told["rating"]["sigma_H_MPa"][0]
    assert "S_H=" in repr(rating) and gw.Pair.rate.__doc__ and "safety against pitting" in gw.Rating.S_H.__doc__
    assert gw.solve(rating.spec, "rate") == told


def test_a_rating_under_other_loads():
    p = of_steel()
    rating = p.rate(**LOAD)
    same(rating, batch("rate", [{**p.spec, "rating": LOAD}])[0], "rating")
    assert rating.pair.spec["rating"]["torque_Nm"] == 150 and "rating" not in p.spec
    assert min(p.rate(**{**LOAD, "torque_Nm": 300}).S_F) < min(rating.S_F)
    assert p.replace(rating=LOAD).rate(torque_Nm=300).S_F == p.rate(**{**LOAD, "torque_Nm": 300}).S_F


def test_a_rating_refuses():
    with pytest.raises(gw.SpecError) as e:
        of_steel().rate()
    assert e.value.key == "rating"
    with pytest.raises(gw.SpecError) as e:
        pair().rate(**LOAD)
    assert e.value.key.startswith("gear1.material")
    with pytest.raises(gw.SpecError) as e:
        of_steel().rate(**LOAD, torqe_Nm=3)
    assert "torque_Nm" in str(e.value)


def test_teeth_under_load_are_the_program_s():
    p = gw.load(SOURCE / "examples/loaded_pair.toml")
    loaded = p.loaded(**COARSE)
    told = batch("load", [{**p.spec, "load": {**p.spec["load"], **COARSE}}])[0]
    same(loaded, told, "load")
    assert [t.torque for t in loaded.torques] == [60, 200] and "2 torques" in repr(loaded)
    assert loaded.torques[1].peak_to_peak == pytest.approx(
        told["load"]["torques"][1]["peak_to_peak_arcsec"] * np.pi / 648000)
    table = loaded.positions
    assert table.shape == (2, 6)
    for row, t in zip(table, told["load"]["torques"], strict=True):
        assert row["transmission_error_arcsec"].tolist() == [q["transmission_error_arcsec"] for q in t["positions"]]
        assert row["root_stress_MPa"].tolist() == [q["root_stress_MPa"] for q in t["positions"]]


def test_errors_and_modifications_under_load():
    p = gw.load(SOURCE / "examples/loaded_pair.toml")
    straight = p.loaded(errors={"crossing_deg": 0.0}, **COARSE)
    askew = p.loaded(errors={"crossing_deg": 0.05}, **COARSE)
    assert askew.torques[0].face_load_factor > straight.torques[0].face_load_factor
    crowned = p.loaded(modifications={"gear1": {"lead_crowning_um": 10}}, **COARSE)
    assert crowned.spec["gear1"]["modifications"] == {"lead_crowning_um": 10}
    with pytest.raises(gw.SpecError) as e:
        pair().loaded(positions=8)
    assert e.value.key == "load.torque_Nm"


def test_only_probes():
    probed = pair().loaded(probe=[{"gear": 1, "diameter": 44.0}], accuracy="draft")
    assert probed.positions is None and not probed.torques and len(probed.probes) == 1
