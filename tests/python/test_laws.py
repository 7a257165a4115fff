"""Tests laws of gears with numbers that Hypothesis chooses, beginning with degenerate ones."""

import math

import pytest
from hypothesis import given, settings, strategies as st

import gearwright as gw

settings.register_profile("gears", deadline=None, max_examples=60, derandomize=True)
settings.load_profile("gears")

gears = st.fixed_dictionaries({
    "teeth": st.integers(5, 200),
    "normal_module": st.sampled_from([0.5, 1.0, 2.0, 3.0]),
    "helix_angle_deg": st.one_of(st.just(0.0), st.floats(-45, 45)),
    "profile_shift": st.floats(-0.6, 0.9),
    "face_width": st.floats(1, 60),
})


@given(gears)
def test_doubling_the_module_doubles_every_length(numbers):
    one = gw.Gear(**numbers)
    two = gw.Gear(**{**numbers, "normal_module": 2 * numbers["normal_module"], "face_width": 2 * numbers["face_width"]})
    for name in ("reference_diameter", "base_diameter", "tip_diameter"):
        assert getattr(two, name) == 2 * getattr(one, name)


@given(gears)
def test_the_hand_changes_nothing(numbers):
    one = gw.Gear(**numbers).as_dict()
    other = gw.Gear(**{**numbers, "helix_angle_deg": -numbers["helix_angle_deg"]}).as_dict()
    for key, value in one.items():
        if key not in ("helix_angle_deg", "base_helix_angle_deg", "lead_mm"):
            assert other[key] == value, key


def mounted(numbers, teeth, **place):
    gear = gw.Gear(**numbers)
    mate = gear.replace(teeth=teeth, helix_angle_deg=-numbers["helix_angle_deg"])
    return gw.Pair(gear, mate, **place)


@given(gears, st.integers(5, 200))
def test_exchanging_the_gears_changes_no_ratio(numbers, teeth):
    try:
        pair = mounted(numbers, teeth)
    except gw.SpecError as e:
        assert e.key and e.allowed
        return
    back = gw.Pair(pair.gear2, pair.gear1)
    assert back.center_distance == pytest.approx(pair.center_distance, rel=1e-12)
    if pair.contact_ratio is not None:
        assert back.contact_ratio == pytest.approx(pair.contact_ratio, rel=1e-9, abs=1e-9)


@given(gears, st.integers(5, 200), st.floats(0, 0.4))
def test_backlash_grows_with_the_distance(numbers, teeth, further):
    try:
        pair = mounted(numbers, teeth)
        more = pair.replace(center_distance=pair.center_distance + further * numbers["normal_module"])
    except gw.SpecError:
        return
    assert pair.backlash.normal == pytest.approx(0, abs=1e-9 * pair.center_distance)
    assert more.backlash.normal >= pair.backlash.normal - 1e-9 * pair.center_distance


@given(gears)
def test_whatever_stands_there_a_gear_or_a_sentence(numbers):
    broken = dict(numbers)
    for name in numbers:
        for bad in (math.nan, -math.inf, "x", [], {}, True):
            broken = {**numbers, name: bad}
            with pytest.raises(gw.SpecError) as e:
                gw.Gear(**broken)
            assert e.value.key.startswith(name)
