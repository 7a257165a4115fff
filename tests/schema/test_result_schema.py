"""Tests the JSON Schema of results with an independent validator. Every result of the examples is valid.
A result with an unknown key or a wrong type is rejected."""
import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

BIN, NODE = os.environ["GW_BIN"], os.environ["GW_NODE"]
SOURCE = pathlib.Path(os.environ["GW_SOURCE"])
sys.path.insert(0, str(SOURCE / "tests/cli"))
import inch  # noqa: E402

VERBS = ("gear", "pair", "measure", "identify", "fit", "contact", "outline", "search")


def answers():
    """Returns {name: result} for every verb and every example. An error is a result, too."""
    found = {}
    for spec in sorted((SOURCE / "examples").glob("*.toml")):
        for verb in VERBS:
            p = subprocess.run([BIN, verb, spec, "--json"], capture_output=True, text=True, timeout=120)
            if p.stdout.strip():
                found[f"{spec.name} {verb}"] = json.loads(p.stdout)
    for name in ("helical_pair", "misaligned_pair", "crossed_pair", "gearbox_search", "steering_rack"):
        spec = {"units": "inch"} | inch.spec_in_inch(tomllib.loads((SOURCE / f"examples/{name}.toml").read_text()))
        for verb in VERBS:
            p = subprocess.run([BIN, verb, "-", "--json"], input=json.dumps(spec), capture_output=True, text=True)
            if p.stdout.strip():
                found[f"{name} {verb} in inch"] = json.loads(p.stdout)
    with tempfile.TemporaryDirectory() as out:
        first = [BIN, "search", SOURCE / "examples/gearbox_search.toml", "--out", out, "--shard", "1/3", "--json"]
        p = subprocess.run([*first, "--chunk", "100"], capture_output=True, text=True, timeout=120)
        found["unfinished search"] = json.loads(p.stdout)
    return found


def refused(values):
    """Returns the values that ajv rejects, as {name: reason}."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as schema:
        schema.write(subprocess.run([BIN, "schema", "result"], capture_output=True, text=True, check=True).stdout)
        schema.flush()
        lines = "".join(json.dumps({"name": n, "value": v}) + "\n" for n, v in values.items())
        p = subprocess.run([NODE, SOURCE / "tests/schema/validate.mjs", schema.name], input=lines, capture_output=True,
                           text=True)
    if p.returncode != 0:
        raise RuntimeError(f"ajv (tools/install_npm_tools.sh): {p.stderr}")
    said = [json.loads(line) for line in p.stdout.splitlines()]
    assert len(said) == len(values), p.stdout
    return {s["name"]: s["why"] for s in said if not s["valid"]}


class Results(unittest.TestCase):
    def test_answers_are_valid_and_others_are_not(self):
        valid = answers()
        self.assertGreater(len(valid), 90)
        self.assertEqual(refused(valid), {})
        self.assertFalse(valid["unfinished search"]["search"]["finished"])
        good = valid["helical_pair.toml pair"]
        wrong = {}
        for name, change in (("key", lambda j: j["gears"][0].update(tip_diameter=1.0)),
                             ("type", lambda j: j["gears"][0].update(teeth="17")),
                             ("null", lambda j: j["gears"][0].update(tip_diameter_mm=None)),
                             ("word", lambda j: j["pair"].update(kind="parallel")),
                             ("missing", lambda j: j["pair"].pop("contact_ratio")),
                             ("length", lambda j: j["pair"].update(tip_clearance_mm=[0.1]))):
            wrong[name] = copy.deepcopy(good)
            change(wrong[name])
        self.assertEqual(sorted(refused(wrong)), sorted(wrong))


if __name__ == "__main__":
    unittest.main()
