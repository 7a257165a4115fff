"""Tests a pinion and its rack as a Pair. Its results equal the results of the program, and results that
need two gears are rejected."""

import html
import json
import pickle
import re
import subprocess

import pytest

import gearwright as gw
from common import BIN, SOURCE

PATH = SOURCE / "examples/steering_rack.toml"
ERRORS = {"crossing_deg": 0.02, "center_distance_mm": 0.05}


def program(verb, spec):
    run = subprocess.run([BIN, verb, "-", "--json"], input=json.dumps(spec), capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def test_quantities_are_those_of_the_program():
    rack = gw.load(PATH)
    told = program("pair", rack.spec)
    assert json.dumps(rack.as_dict()) == json.dumps(told["pair"])
    assert json.dumps(rack.gear1.as_dict()) == json.dumps(told["gears"][0])
    assert rack.rack["length_mm"] == told["gears"][1]["length_mm"]
    assert rack.center_distance == told["pair"]["center_distance_mm"]
    assert rack.mounting_distance == told["pair"]["mounting_distance_mm"]
    assert rack.shaft_angle is None
    assert rack.verdict.headline == told["verdict"]["headline"]
    assert repr(rack).startswith("Pair(8 / rack, ")
    assert pickle.loads(pickle.dumps(rack)) == rack
    assert gw.Pair(gw.Gear(teeth=20, normal_module=2), gw.Gear(teeth=40, normal_module=2)).rack is None


def test_contact_is_that_of_the_program():
    rack = gw.load(PATH)
    contact = rack.contact(errors=ERRORS, positions=32)
    told = program("contact", {**rack.spec, "errors": ERRORS, "contact": {"positions": 32}})
    assert json.dumps(contact.as_dict()) == json.dumps(told["contact"])
    assert contact.verdict.headline == told["verdict"]["headline"]
    assert [f.title for f in contact.figures] == ["Transmission error", "Transmission error of the non-working flanks",
                                                  "Gear 1"]
    assert contact.figures[0].data["y"]["unit"] == "µm"
    assert "rack moves evenly" in contact.report()


def test_attributes_of_the_contact_are_lengths_along_the_rack():
    contact = gw.load(PATH).contact(errors=ERRORS, positions=32)
    record = contact.as_dict()
    for name, key, unit in (("peak_to_peak", "peak_to_peak_um", 1e-3),
                            ("continuous_peak_to_peak", "continuous_peak_to_peak_um", 1e-3),
                            ("least_play", "least_play_mm", 1)):
        assert getattr(contact, name) == pytest.approx(unit * record[key], rel=1e-15)
    assert list(contact.harmonics) == pytest.approx([1e-3 * h for h in record["harmonics_um"]], rel=1e-15)
    for name, key in (("transmission_error", "transmission_error_um"), ("travel", "travel_mm")):
        unit = 1e-3 if key.endswith("_um") else 1
        assert list(getattr(contact, name)) == pytest.approx([unit * p[key] for p in record["positions"]], rel=1e-15)
    assert f"peak_to_peak_um={record['peak_to_peak_um']:.4g}" in repr(contact)
    assert "for the travel of a rack" in type(contact).harmonics.__doc__


def test_modifications_and_driver():
    rack = gw.load(PATH)
    crowned = {"gear1": {"lead_crowning_um": 10}}
    contact = rack.contact(modifications=crowned, driver=2)
    told = program("contact", {**rack.spec, "gear1": {**rack.spec["gear1"], "modifications": crowned["gear1"]},
                               "contact": {"driver": 2}})
    assert json.dumps(contact.as_dict()) == json.dumps(told["contact"])


def test_files_and_pictures():
    rack = gw.load(PATH)
    assert rack.step().count(b"MANIFOLD_SOLID_BREP") == 2
    assert rack.drawing()[:5] == b"%PDF-"
    drawing = rack.drawing(format="svg").decode()
    assert "Rack data" in drawing and "2/2" in drawing
    assert rack.pose(2)[0, 3] == rack.center_distance
    assert "Rack data" in rack._repr_html_() and "Rack data" in rack.report()
    assert [f.title for f in rack.figures] == ["The mesh at the pitch point"]
    for page in (html.unescape(rack._repr_html_()), rack.report()):
        used = set(re.findall(r'href="#([^"]+)"', page))
        assert "gear2" in used
        assert used <= set(re.findall(r' id="([^"]+)"', page))


@pytest.mark.parametrize("call", [
    lambda p: p.gear2, lambda p: p.loaded(torque_Nm=5), lambda p: p.rate(torque_Nm=5, speed_rpm=100, quality=6),
    lambda p: p.transmission_error([[0, 0, 0, 0, 0, 0]]), lambda p: gw.scatter(p, errors={"crossing_deg": [-0.01, 0.01]}),
    lambda p: gw.compensate(p)])
def test_results_that_need_two_gears(call):
    with pytest.raises(gw.SpecError, match='gear2.form = "rack": makes gear 2 a rack, but'):
        call(gw.load(PATH))
