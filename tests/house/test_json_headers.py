"""Tests that every header with a struct that contains a tree includes the definition of Json.

spec/json.hpp only declares Json. A member `Json tree` or `std::vector<Json> rows = {}` needs the definition. If a
header does not include it, the precompiled header of the build hides the fault, and programs without this
precompiled header do not compile. The rules are first tested with lines of both kinds.
"""

import os
import re
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GW_SOURCE", Path(__file__).resolve().parents[2]))
DEFINITION = "#include <nlohmann/json.hpp>"
MEMBER = re.compile(r"^\s*(?:std::\w+<[^;()]*\bJson\b[^;()]*>|Json)\s+\w+\s*(?:=[^;]*|\{[^;]*\})?;", re.M)


def contains_tree(text):
    return bool(MEMBER.search(re.sub(r"//.*", "", text)))


class JsonHeaders(unittest.TestCase):
    def test_the_rule_finds_members(self):
        for line in ("  Json tables;", "  std::vector<Json> specs{};  ///< one for each", "  std::vector<Json> rows = {};",
                     "  std::optional<Json> record;", "  std::map<std::string, Json> parts;"):
            self.assertTrue(contains_tree(line), line)
        for line in ("Json rows_json(UnitSystem units);", "  const Json& node_;", "  const Json* find(const std::string& key);",
                     "// Json tables;", "  std::function<Json(int)> make;", "  std::vector<std::pair<std::string, const Json*>> list();",
                     "using Json = nlohmann::ordered_json;"):
            self.assertFalse(contains_tree(line), line)

    def test_headers_include_the_definition(self):
        headers = [path for room in ("gearwright", "apps") for path in sorted((ROOT / room).rglob("*.hpp"))
                   if "node_modules" not in path.parts]
        self.assertGreater(len(headers), 100)
        faults = [str(path.relative_to(ROOT)) for path in headers
                  if contains_tree(text := path.read_text()) and DEFINITION not in text]
        self.assertEqual(faults, [])


if __name__ == "__main__":
    unittest.main()
