"""Tests the JSON Schema of specs with an independent validator, and compares it with the program.

If the program accepts an example or a spec from the tests of the command line, the spec is valid. If the
program rejects a type, a word or a key in it, the spec is invalid. For each key of the schema, both reject
values of a wrong type and values outside the range.
"""
import copy
import json
import os
import pathlib
import re
import subprocess
import tempfile
import tomllib
import unittest

BIN, NODE = os.environ["GW_BIN"], os.environ["GW_NODE"]
SOURCE = pathlib.Path(os.environ["GW_SOURCE"])
SPECS = pathlib.Path(os.environ["GW_SPECS"])
SCHEMA = SOURCE / "docs/schema/spec.schema.json"
# Matches the program's messages about types, words, numbers of values and keys. The class `Ranges` tests
# ranges.
OF_THE_READER = re.compile(r"unknown key in|: must be (a (whole )?number\n|true or false|a text in quotes|one of \"|a table, )|"
                           r": is an empty list|values, but must be|is not a number(?! of teeth)")


def say(values):
    """Returns ajv's result for each (name, value), as {name: reason}. The reason is "" if the value is
    valid."""
    lines = "".join(json.dumps({"name": name, "value": value}) + "\n" for name, value in values)
    p = subprocess.run([NODE, SOURCE / "tests/schema/validate.mjs", SCHEMA], input=lines, capture_output=True, text=True)
    if p.returncode != 0:
        raise RuntimeError(f"ajv (tools/install_npm_tools.sh): {p.stderr}")
    said = [json.loads(line) for line in p.stdout.splitlines()]
    return {s["name"]: "" if s["valid"] else s["why"] or "refused" for s in said}


def parsed(text, name):
    """Returns the tree of a spec. Returns None if the text is not a spec or contains values that JSON
    cannot represent."""
    try:
        tree = json.loads(text) if name.endswith(".json") else tomllib.loads(text)
        return json.loads(json.dumps(tree, allow_nan=False))
    except (ValueError, TypeError, RecursionError):
        return None


def refusals(specs):
    """Returns the program's message for each (name, spec), as {name: message}. The message is "" if the
    spec is accepted. A single run of `verify` tests all specs."""
    cases = [{"id": name, "source": "here", "verb": "drive" if spec.keys() & DRIVES else "gear", "spec": spec,
              "expected": {"drive.ratio" if spec.keys() & DRIVES else "gears.0.teeth": "a word that no number equals"}}
             for name, spec in specs]
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump({"cases": cases}, file)
        file.flush()
        p = subprocess.run([BIN, "verify", file.name, "--json"], capture_output=True, text=True, timeout=300)
    said = {c["id"]: c["differences"][0] for c in json.loads(p.stdout)["cases"]}
    return {name: "" if re.match(r"(gears\.0\.teeth|drive\.ratio): got", why) else why for name, why in said.items()}


class Shipped(unittest.TestCase):
    def test_the_program_prints_it(self):
        for args in ((), ("--json",)):
            p = subprocess.run([BIN, "schema", "spec", *args], capture_output=True, text=True)
            self.assertEqual([p.returncode, p.stdout], [0, SCHEMA.read_text()])
        self.assertEqual(subprocess.run([BIN, "schema", "gear"], capture_output=True).returncode, 2)

    def test_every_example_is_valid(self):
        files = [*SOURCE.glob("examples/**/*.toml"), *SOURCE.glob("tests/fuzz/corpus/spec/*")]
        self.assertGreater(len(files), 20)
        for name, why in say([(str(f), parsed(f.read_text(), f.name)) for f in files]).items():
            self.assertEqual(why, "", name)


class OfTheTests(unittest.TestCase):
    def test_the_validator_says_what_the_program_said(self):
        kept = [json.loads(line) for file in sorted(SPECS.glob("*.jsonl")) for line in file.read_text().splitlines()]
        trees = [(k, parsed(k["text"], k["name"])) for k in kept]
        trees = [(k, tree) for k, tree in trees if tree is not None]
        said = say([(str(i), tree) for i, (_, tree) in enumerate(trees)])
        read = refused = 0
        for i, (k, _) in enumerate(trees):
            why = said[str(i)]
            if k["status"] == 0:
                read += 1
                self.assertEqual(why, "", k["text"])
            elif k["status"] == 1 and OF_THE_READER.search(k["message"]):
                refused += 1
                self.assertNotEqual(why, "", k["message"] + k["text"])
        self.assertGreater(read, 140)
        self.assertGreater(refused, 40)


DRIVES = {"planetary", "stage", "drive"}  # a spec with one of these tables is a drive
GEAR = {"teeth": 20, "normal_module_mm": 2, "face_width_mm": 10}
F = {"kind": "circular_arc", "cutter": "F", "arc_radius": 1.4, "center_a": 0.1, "center_b": 0.1}
DOUBLE = {"kind": "double_circular_arc", "concave_radius": 1.42, "concave_height": 0.0325, "space_width": 1.1773}
ARC = {"center_height": 0.1, "center_offset": 0.1, "radius": 1, "begin_deg": 20, "end_deg": 10}
MAP = {"x": "crossing_deg", "x_range": [-1, 1], "y": "axial_mm", "y_range": [-1, 1]}
SEARCH = {"ratio": [1.9, 2.1], "modules_mm": [2], "pinion_teeth": [12, 40]}


def of_gear(**more):
    return {"gear1": GEAR | more}


SET = {"sun": 20, "planet": 25, "ring": 70, "planets": 3}
GRAPH = {"body": [{"name": "a"}, {"name": "b"}], "gear": [{"name": "g", "body": "a", "teeth": 20}, {"name": "h", "body": "b", "teeth": 40}],
         "mesh": [{"gears": ["g", "h"]}], "input": "a", "output": "b"}
# For each table, a spec that contains it, and the path to it.
STAGE = {"torque_Nm": 100, "speed_rpm": 1000, "duration_h": 10}
TABLES = {
    "gear": (of_gear(), ("gear1",)),
    "cutter": (of_gear(cut_by={"teeth": 10}), ("gear1", "cut_by")),
    "basic": (of_gear(basic={"base_diameter_mm": 37.588, "base_tooth_thickness_mm": 3.5}), ("gear1", "basic")),
    "root_fillet": (of_gear(root_fillet={}), ("gear1", "root_fillet")),
    "tip_fillet": (of_gear(tip_fillet={}), ("gear1", "tip_fillet")),
    "double_helical": (of_gear(helix_angle_deg=30, double_helical={}), ("gear1", "double_helical")),
    "measure": (of_gear(measure={}), ("gear1", "measure")),
    "tolerance": (of_gear(tolerance={}), ("gear1", "tolerance")),
    "measured": (of_gear(measured={}), ("gear1", "measured")),
    "measured_ball": (of_gear(measured={"over_balls_mm": [{"ball_diameter_mm": 5, "dimension_mm": 69}]}),
                      ("gear1", "measured", "over_balls_mm", 0)),
    "bore": (of_gear(bore={"diameter_mm": 10, "keyway_width_mm": 3, "keyway_depth_mm": 1}), ("gear1", "bore")),
    "shaft": (of_gear(shaft={"bearings_mm": [-60, 45], "diameter_mm": [35, 42], "steps_mm": [-20]}), ("gear1", "shaft")),
    "modifications": (of_gear(modifications={}), ("gear1", "modifications")),
    "rack": (of_gear(rack={}), ("gear1", "rack")),
    "rack_circular_arc": (of_gear(rack=F), ("gear1", "rack")),
    "rack_double_circular_arc": (of_gear(rack=DOUBLE), ("gear1", "rack")),
    "rack_arcs": (of_gear(rack={"kind": "arcs", "addendum": 1, "dedendum": 1, "arcs": [ARC]}), ("gear1", "rack")),
    "rack_arc": (of_gear(rack={"kind": "arcs", "addendum": 1, "dedendum": 1, "arcs": [ARC]}), ("gear1", "rack", "arcs", 0)),
    "pair": (of_gear() | {"pair": {}}, ("pair",)),
    "fit": (of_gear() | {"fit": {"few_teeth": True}}, ("fit",)),
    "drawing": (of_gear() | {"drawing": {}}, ("drawing",)),
    "errors": (of_gear() | {"errors": {}}, ("errors",)),
    "contact": (of_gear() | {"contact": {}}, ("contact",)),
    "contact_map": (of_gear() | {"contact": {"map": MAP}}, ("contact", "map")),
    "compensate": (of_gear() | {"compensate": {}}, ("compensate",)),
    "compensate_range": (of_gear() | {"compensate": {"range": {}}}, ("compensate", "range")),
    "scatter": (of_gear() | {"scatter": {}}, ("scatter",)),
    "scatter_errors": (of_gear() | {"scatter": {"errors": {}}}, ("scatter", "errors")),
    "scatter_range": (of_gear() | {"scatter": {"errors": {"crossing_deg": {"range": [0, 1]}}}}, ("scatter", "errors", "crossing_deg")),
    "scatter_correlations": (of_gear() | {"scatter": {
        "errors": {"crossing_deg": [-0.01, 0.01], "intersecting_deg": [-0.01, 0.01]},
        "correlations": [{"between": ["errors.crossing_deg", "errors.intersecting_deg"], "value": 0.5}]}},
        ("scatter", "correlations", 0)),
    "scatter_bearings": (of_gear() | {"scatter": {"bearings": {"span_mm": 100, "radius_mm": 0.02}}}, ("scatter", "bearings")),
    "scatter_gear": (of_gear() | {"scatter": {"gear1": {}}}, ("scatter", "gear1")),
    "scatter_robust": (of_gear() | {"scatter": {"robust": {}}}, ("scatter", "robust")),
    "scatter_modifications": (of_gear() | {"scatter": {"gear1": {"modifications": {}}}}, ("scatter", "gear1", "modifications")),
    "material": (of_gear(material={}), ("gear1", "material")),
    "rating": (of_gear() | {"rating": {"torque_Nm": 100, "speed_rpm": 1000}}, ("rating",)),
    "rating_mounting": (of_gear() | {"rating": {"torque_Nm": 100, "mounting": {"bearing_span_mm": 100, "shaft_diameter_mm": 30}}},
                        ("rating", "mounting")),
    "rating_plastic": (of_gear() | {"rating": {"torque_Nm": 100, "standard": "VDI 2736:2014", "plastic": {}}},
                       ("rating", "plastic")),
    "rating_spectrum": (of_gear() | {"rating": {"spectrum": [STAGE]}}, ("rating", "spectrum", 0)),
    "load": (of_gear() | {"load": {"torque_Nm": 100}}, ("load",)),
    "load_probe": (of_gear() | {"load": {"torque_Nm": 100, "probe": [{"gear": 1, "diameter_mm": 40}]}}, ("load", "probe", 0)),
    "search": ({"search": SEARCH}, ("search",)),
    "drive_search": ({"search": {"kind": "planetary", "ratio": [4.4, 4.6], "planets": [3, 5], "sun_teeth": [12, 40]}}, ("search",)),
    "blank": ({"search": SEARCH, "gear1": {}}, ("gear1",)),
    "rack_bar": (of_gear() | {"gear2": {"form": "rack"}}, ("gear2",)),
    "planetary": ({"planetary": SET}, ("planetary",)),
    "stage": ({"stage": [{"teeth": [20, 40]}]}, ("stage", 0)),
    "drive": ({"drive": GRAPH}, ("drive",)),
    "drive_body": ({"drive": GRAPH}, ("drive", "body", 0)),
    "drive_gear": ({"drive": GRAPH}, ("drive", "gear", 0)),
    "drive_mesh": ({"drive": GRAPH}, ("drive", "mesh", 0)),
}
# Keys that exclude or require another key of their table, with the changes that make a valid spec.
BESIDE = {"transverse_module_mm": {"normal_module_mm": None}, "normal_diametral_pitch_per_in": {"normal_module_mm": None},
          "lead_angle_deg": {"hand": "right"}}


def changed(spec, way, keys):
    spec = copy.deepcopy(spec)
    table = spec
    for step in way:
        table = table[step]
    for key, value in keys.items():
        table.pop(key, None)
        if value is not None:
            table[key] = value
    return spec


def beyond(schema):
    """Yields numbers just outside the range that a schema allows."""
    for least, step in (("minimum", -1), ("maximum", 1)):
        if least in schema:
            yield schema[least] + step * max(abs(schema[least]) * 1e-6, 1 if schema.get("type") == "integer" else 1e-6)
    for end in ("exclusiveMinimum", "exclusiveMaximum"):
        if end in schema:
            yield schema[end]
    if schema.get("not") == {"const": 0}:
        yield 0


def wrong(schema):
    """Yields values that the schema of a key does not allow."""
    kind = schema.get("type")
    if kind in ("number", "integer"):
        yield from beyond(schema)
        yield from ("1", True, [1], {})
        if kind == "integer":
            yield 5.5
    elif kind == "boolean":
        yield from (1, "yes")
    elif kind == "string":
        yield from (3, True)
    elif kind == "array":
        yield []
        if schema["maxItems"] < 100:
            yield [schema["items"].get("enum", [1])[0]] * (schema["maxItems"] + 1)
        yield from ([{}], "two", {})
        if "type" in schema["items"]:
            yield from ([n] * schema["minItems"] for n in beyond(schema["items"]))
    elif "enum" in schema:
        yield from (schema["enum"][0] + "x", 3)
    elif "$ref" in schema:
        yield from (3, "word")
    elif "anyOf" in schema:
        kinds = {t for part in schema["anyOf"] for t in [part.get("type"), "enum" in part and "word", "$ref" in part and "table"] if t}
        yield True
        if {"type": "string"} in schema["anyOf"]:  # names that the user chose; a list of them may be empty
            return
        if "word" in kinds or "array" in kinds:
            yield "no such word"
        for part in schema["anyOf"]:
            if part.get("type") == "array":
                yield []


class Ranges(unittest.TestCase):
    """Both validators reject an invalid value. The program's message names its key."""

    def test_every_key(self):
        schema = json.loads(SCHEMA.read_text())
        self.assertEqual(set(TABLES), set(schema["$defs"]) - {"whole_gear", "only_mm", "only_inch"})
        cases = []
        for table, (spec, way) in TABLES.items():
            for key, about in schema["$defs"][table]["properties"].items():
                values = [*wrong(about)]
                self.assertTrue(values or set(about) <= {"description", "default"}, f"{table}.{key}: no wrong value")
                for value in values:
                    cases.append((f"{table}.{key} = {value!r}", changed(spec, way, BESIDE.get(key, {}) | {key: value}), key))
            cases.append((f"{table}: no such key", changed(spec, way, {"no_such_key": 1}), "no_such_key"))
        said = say([(name, spec) for name, spec, _ in cases])
        said_right = say([(table, spec) for table, (spec, _) in TABLES.items()])
        for table, why in said_right.items():
            self.assertEqual(why, "", table)
        sentences = refusals([(name, spec) for name, spec, _ in cases])
        self.assertEqual(len(sentences), len(cases))
        for name, _, key in cases:
            with self.subTest(name):
                self.assertIn(key, sentences[name], "the program accepts it")
                self.assertNotEqual(said[name], "", f"ajv accepts it; message of the program: {sentences[name]}")
        # The program accepts the specs of TABLES themselves. Searches are omitted, because the verb gear
        # rejects them.
        for table, sentence in refusals([(table, spec) for table, (spec, _) in TABLES.items()]).items():
            if "search" not in TABLES[table][0]:
                self.assertNotRegex(sentence, r"must be|unknown key|is missing", table)
        self.assertGreater(len(cases), 500)

    def test_forms_of_a_value_are_those_of_the_program(self):
        for table, key, right, wrong in (
                ("stage", "angle_deg", (30, "coaxial"), ([30], {"a": 30}, 400, "axial")),
                ("stage", "bore_mm", (8, [8, 10]), ([], [8], [8, 9, 10], ["8"], -1, "8")),
                ("planetary", "torque_Nm", (5, [5]), ([5, 6], {"sun": 5}, "5")),
                ("rating", "mesh_load_factor", (1.2,), ([1.2], 0.5, "calculated"))):
            spec, way = TABLES[table]
            cases = [(f"{key} = {value!r}", changed(spec, way, {key: value})) for value in right + wrong]
            said, sentences = say(cases), refusals(cases)
            for name, _ in cases[:len(right)]:
                self.assertEqual(said[name], "", name)
            for name, _ in cases[len(right):]:
                self.assertNotEqual(said[name], "", name)
                self.assertIn(key, sentences[name], name)


if __name__ == "__main__":
    unittest.main()
