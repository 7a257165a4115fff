"""Tests that code decides by enumerators, and not by the texts of errors and warnings.

The field, the rule and the message of an error are texts for users. The kind of an error is a FailureKind, its gear
and its member are a Subject (base/subject.hpp), and the fact of a warning is a WarningCode. Sources must not
contain:

    compare   a comparison of a field, a rule or a message with another text
    search    a search in a rule or a message

ALLOWED lists the lines that do not find out what happened, with the reasons. Each rule is first tested with a line
that violates it.
"""

import os
import re
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GW_SOURCE", Path(__file__).resolve().parents[2]))
COMPARE = re.compile(r"\b(?:field|rule|message)\s*[!=]=|[!=]=\s*[\w.>()-]*[.>](?:field|rule|message)\b")
SEARCH = re.compile(r"[.>](?:rule|message(?:\(\))?)\.(?:find|starts_with|contains)\b|\bmessage\.(?:find|contains)\b")
ALLOWED = {
    "gearwright/base/subject.cpp": {"field == known.name": "the table of the members"},
    "apps/python/values.cpp": {"error.rule.find(table)": "rewords a sentence for a gear without a table"},
    "gearwright/arrange/judge_drive.cpp": {"part.finding.message == f.message &&":
                                           "the same finding of a gear in two meshes",
                                           "message.find(name)": "a sentence without the name gets it as its heading"},
    "gearwright/spec/spec.cpp": {"e.field == error.field": "joins two lists of missing inputs",
                                 "e.field == second": "removes an input from this list",
                                 "e.field == field": "finds an input in this list"},
    "gearwright/spec/missing_for.cpp": {"e.field == tables[0] || e.field == tables[1]": "finds an input in its list"},
    "gearwright/job/rack_question.cpp": {"error.field ==": "places the value as in the option, MODULE,ANGLE"},
    "gearwright/job/scatter_answer.cpp": {"t.name == error.field": "finds a tolerance by its name, which is data"},
}


def faults_of(name, text):
    """Returns the lines of a source that compare or search texts and are not in ALLOWED."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        code = re.sub(r"//.*", "", line)
        if not (COMPARE.search(code) or SEARCH.search(code)):
            continue
        if not any(allowed in code for allowed in ALLOWED.get(name, {})):
            found.append(f"{name}:{number}: {line.strip()}")
    return found


class ErrorTexts(unittest.TestCase):
    def test_the_rules_find_violations(self):
        for line in ('if (error.field == "gear1")', "made.error().field != name", 'if (e.rule == "is missing")',
                     "own.message == fault.message", 'w.message.find("gear ")', 'error.rule.starts_with("must")',
                     "t.name == error.field", "message.find(name) == npos"):
            self.assertTrue(faults_of("gearwright/job/a.cpp", line), line)
        for line in ("subject_of(error.field).gear == 1", "// error.field == x", "error.field.empty()",
                     "error.kind == FailureKind::missing", "w.code == other.code"):
            self.assertEqual(faults_of("gearwright/job/a.cpp", line), [])

    def test_no_source_compares_texts_of_errors(self):
        faults, count = [], 0
        for file in sorted([*(ROOT / "gearwright").rglob("*"), *(ROOT / "apps").rglob("*")]):
            name = str(file.relative_to(ROOT))
            if file.suffix not in (".cpp", ".hpp") or name.endswith("_test.cpp") or "/testing/" in name:
                continue
            count += 1
            faults += faults_of(name, file.read_text(encoding="utf-8"))
        self.assertGreater(count, 500)
        self.assertEqual(faults, [])

    def test_every_allowed_line_exists(self):
        for name, lines in ALLOWED.items():
            text = (ROOT / name).read_text(encoding="utf-8")
            for line in lines:
                self.assertIn(line, text, name)


if __name__ == "__main__":
    unittest.main()
