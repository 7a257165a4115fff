"""Tests drives. They are made from keys, and their values are read by name and equal those of the program."""

import copy
import json
import math
import pickle

import pytest

import gearwright as gw

KEYS = {"sun": 21, "planet": 24, "ring": 69, "planets": 3, "normal_module": 2, "thickness_allowance": -0.05,
        "speed_rpm": 1500, "torque_Nm": 40}


def test_numbers_are_those_of_the_program():
    drive = gw.planetary(**KEYS)
    answer = gw.solve({"planetary": {**KEYS}}, "drive")
    assert drive.as_dict() == answer["drive"]
    assert drive.ratio == drive["ratio"] == pytest.approx(30 / 7)
    assert drive.bodies["carrier"].speed_rpm == pytest.approx(350)
    assert drive.center_distance == drive["center_distance_mm"]
    assert drive.backlash.output == pytest.approx(math.radians(drive["backlash"]["output_deg"]))
    # The value is that of docs/programming.md.
    assert drive.meshes["sun_planet"].pair.contact_ratio == pytest.approx(1.5855, abs=1e-4)
    assert drive.verdict.level in ("green", "amber", "red")
    assert "30/7" in repr(drive)
    with pytest.raises(AttributeError):
        drive.efficency


def test_values_do_not_change():
    drive = gw.planetary(**KEYS)
    four = drive.replace(planets=4)
    assert drive.assembly.positions == four.assembly.positions == 90
    assert drive.assembly.equal and not four.assembly.equal
    assert drive.replace(normal_module_mm=3).center_distance == pytest.approx(1.5 * drive.center_distance)
    drive.as_dict()["ratio"] = drive.spec["planetary"]["sun"] = 0
    assert drive == pickle.loads(pickle.dumps(drive)) == copy.deepcopy(drive) == gw.planetary(**KEYS)


def test_a_drive_is_immutable_and_hashable():
    drive = gw.planetary(**KEYS)
    for change in (lambda: setattr(drive, "ratio", 99), lambda: setattr(drive, "foo", 3), lambda: delattr(drive, "_spec")):
        with pytest.raises(AttributeError, match="replace"):
            change()
    assert {drive: 1}[gw.planetary(**KEYS)] == 1 and copy.copy(drive) is drive
    assert gw.solve(drive, "drive")["drive"] == drive.as_dict()


def test_names_have_no_unit():
    rated = gw.planetary(**KEYS).rate(material={"name": "17CrNiMo6"}, quality=[6, 6], face_load_factor=1.2)["sun_planet"]
    assert rated.sigma_H == rated.sigma_H_MPa == rated["sigma_H_MPa"] and rated.F_t == rated.F_t_N
    assert gw.planetary(**KEYS).bodies["sun"].speed == 1500


def test_a_drive_of_an_inch_spec_is_in_mm():
    # Regression: keys ended in _in, and the attributes in mm did not exist.
    inches = gw.Drive({"units": "inch", "planetary": {**{k: v for k, v in KEYS.items() if k != "thickness_allowance"},
                                                      "thickness_allowance_in": -0.002, "face_width_in": 1}})
    metric = gw.planetary(**{**KEYS, "thickness_allowance": -0.0508, "face_width": 25.4})
    pair = inches.meshes["sun_planet"].pair
    assert pair.center_distance == pair["center_distance_mm"] == metric.meshes["sun_planet"].pair.center_distance == 45
    assert inches.as_dict().keys() == metric.as_dict().keys() and inches.spec["units"] == "inch"
    with pytest.raises(gw.SpecError) as e:
        inches.replace(face_width_in=-1)
    assert e.value.key == "planetary.face_width_in"


def test_trains_and_ratings():
    train = gw.train({"teeth": [19, 58], "mesh_efficiency": 0.985}, {"teeth": [17, 67], "mesh_efficiency": 0.984})
    assert train["ratio_exact"] == [58 * 67, 19 * 17]
    assert [stage.ratio for stage in train.stages] == [pytest.approx(-58 / 19), pytest.approx(-67 / 17)]
    rated = gw.planetary(**KEYS).rate(material={"name": "17CrNiMo6"}, quality=[6, 6], face_load_factor=1.2)
    assert set(rated) == {"sun_planet", "planet_ring"}
    assert rated["sun_planet"].Y_M == [1.0, 0.7]
    with pytest.raises(gw.SpecError) as error:
        gw.planetary(sun=20, planet=25, ring=70, fixed="rign")
    assert error.value.key == "planetary.fixed"


def test_every_speed_has_an_input():
    # Regression: with a second speed, the bodies of a set with one input had no speeds.
    for drive, key in ((lambda: gw.planetary(**{**KEYS, "speed_rpm": [1500, 20]}), "planetary.speed_rpm"),
                       (lambda: gw.train({"teeth": [19, 58], "speed_rpm": [1500, 20]}), "stage[1].speed_rpm")):
        with pytest.raises(gw.SpecError, match="has 2 numbers for 1 input") as e:
            drive()
        assert e.value.key == key and e.value.value == "[1500, 20]"


def test_spec_files_keep_their_folder(tmp_path):
    (tmp_path / "flank.csv").write_text("diameter_mm,z_mm,removed_um\n39.5,-10,1\n39.5,10,1\n46,-10,1\n46,10,1\n")
    gear = {"normal_module_mm": 2, "face_width_mm": 20}
    stage = {"gears": [{"teeth": 21, "modifications": {"topography": "flank.csv"}, **gear}, {"teeth": 43, **gear}]}
    path = tmp_path / "stage.json"
    path.write_text(json.dumps({"stage": [stage]}))
    drive = gw.load_drive(path)
    assert drive == pickle.loads(pickle.dumps(drive)) == drive.replace(title="A stage") == gw.Drive(drive.spec, tmp_path)
    assert gw.solve(path, "drive")["drive"] == drive.as_dict()
    with pytest.raises(gw.SpecError, match="flank.csv"):
        gw.Drive(drive.spec)
    with pytest.raises(gw.FileError):
        gw.load_drive(tmp_path / "none.toml")
    with pytest.raises(TypeError, match="load_drive"):
        gw.Drive(str(path))


def test_tables_and_units():
    drive = gw.planetary(**KEYS).replace(rating={"quality": [6, 6]}, planets=4)
    assert drive.spec["rating"] == {"quality": [6, 6]} and drive.spec["planetary"]["planets"] == 4
    assert "rating" not in drive.replace(rating=None).spec
    assert gw._drives.Part({"displacement_um": 8.36}).displacement == pytest.approx(8.36e-3)
