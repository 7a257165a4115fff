// toml++ 3.3 answers some broken input ("[" and a newline) with an assert instead of a parse error;
// the release behaviour of the same code is a clean parse error, so this file takes that in every
// build.
#ifndef NDEBUG
#define NDEBUG
#endif
#include "gearwright/spec/spec.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "gearwright/base/output_file.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/spec/read_contact.hpp"
#include "gearwright/spec/read_gear.hpp"
#include "gearwright/spec/read_search.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

Json to_json(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    Json result = Json::object();
    for (const auto& [key, value] : *table) result[std::string(key.str())] = to_json(value);
    return result;
  }
  if (const auto* array = node.as_array()) {
    Json result = Json::array();
    for (const toml::node& value : *array) result.push_back(to_json(value));
    return result;
  }
  if (const auto* v = node.as_integer()) return v->get();
  if (const auto* v = node.as_floating_point()) return v->get();
  if (const auto* v = node.as_boolean()) return v->get();
  if (const auto* v = node.as_string()) return v->get();
  return "(a date or time)";
}

constexpr int kDeepest = 32;  // tables in tables; a spec has three

// Reads JSON with its nesting bounded and every key of a table there once, as TOML has it.
Json parse_strict_json(std::string_view text) {
  std::vector<std::set<std::string>> keys;
  const auto look = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > kDeepest) {
      throw SpecError{
          {"", "", fmt::format("the spec cannot be read: it nests more than {} tables", kDeepest)}};
    }
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key &&
        !keys.back().insert(parsed.get<std::string>()).second) {
      const std::string key = printable(parsed.get<std::string>(), 60);
      throw SpecError{{key, "", "stands twice in one table; leave one out"}};
    }
    return true;
  };
  return Json::parse(text.begin(), text.end(), look);
}

// The first line with more dots outside quotes than tables may nest: the TOML parser calls itself
// for each part of a dotted name.
std::optional<int> deep_line(std::string_view text) {
  int line = 1;
  int dots = 0;
  char quote = 0;
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      dots = 0;
      quote = 0;
    } else if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ',') {
      dots = 0;  // the next one of a list
    } else if (c == '.' && ++dots > 8 * kDeepest) {
      return line;
    }
  }
  return std::nullopt;
}

PairInput read_pair(const Json& node) {
  TableReader t(pair_keys(), node, "pair");
  PairInput p;
  t.read(p);
  t.finish();
  return p;
}

FitInput read_fit(const Json& node) {
  TableReader t(fit_keys(), node, "fit");
  FitInput f;
  t.read(f);
  for (const Key& key : fit_keys().keys) {
    const std::string name(key.key);
    if (!f.few_teeth && !key.needs.empty() && t.has(name))
      t.fail(name, "belongs to few_teeth = true");
  }
  t.finish();
  return f;
}

void note_keys(const Json& table, const std::string& path, GivenKeys& keys) {
  for (const auto& [key, value] : table.items()) {
    const std::string here = path.empty() ? key : path + "." + key;
    keys.insert(here);
    if (value.is_object()) note_keys(value, here, keys);
  }
}

JobSpec read_tree(const Json& tree, const std::filesystem::path& folder) {
  TableReader t(spec_keys(), tree, "");
  JobSpec spec;
  spec.tree = json_text(tree);
  note_keys(tree, "", spec.given);
  spec.title = t.text("title").value_or("");
  const Json* gear_1 = t.table("gear1");
  const Json* gear_2 = t.table("gear2");
  const Json* search = t.table("search");
  // Beside [search] a gear's table without teeth says only what the search does not choose.
  const auto is_gear = [&](const Json* gear) {
    return gear && (!search || gear->contains("teeth"));
  };
  if (is_gear(gear_1)) spec.gears[0] = read_gear(gear_keys(), *gear_1, "gear1", gear_2, folder);
  if (is_gear(gear_2)) spec.gears[1] = read_gear(gear_keys(), *gear_2, "gear2", gear_1, folder);
  if (search) spec.search = read_search(*search, gear_1, gear_2);
  if (const Json* node = t.table("pair")) spec.pair = read_pair(*node);
  if (const Json* node = t.table("fit")) spec.fit = read_fit(*node);
  if (const Json* node = t.table("errors")) spec.errors = read_errors(*node);
  if (const Json* node = t.table("contact")) spec.contact = read_contact(*node);
  if (const Json* node = t.table("compensate")) spec.compensate = read_compensate(*node);
  t.finish();
  if (!spec.gears[0] && !spec.search) {
    throw SpecError{{"gear1", "",
                     "is missing; a spec describes a gear in a table [gear1] with at least "
                     "teeth and normal_module_mm"}};
  }
  return spec;
}

JobSpec with_text(JobSpec spec, std::string_view text) {
  spec.text = text;
  return spec;
}

Error syntax_error(const std::string& what) { return {"", "", "the spec cannot be read: " + what}; }

}  // namespace

Result<JobSpec> read_spec(std::string_view text, SpecFormat format,
                          const std::filesystem::path& folder) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return syntax_error("it is empty; the least is [gear1] with teeth and normal_module_mm");
  }
  try {
    if (format == SpecFormat::json) {
      const Json tree = parse_strict_json(text);
      if (!tree.is_object()) return syntax_error("a JSON spec is one object, {\"gear1\": {...}}");
      return with_text(read_tree(tree, folder), text);
    }
    if (const auto line = deep_line(text)) {
      return syntax_error(fmt::format("line {} nests more than {} tables", *line, kDeepest));
    }
    return with_text(read_tree(to_json(toml::parse(text)), folder), text);
  } catch (const SpecError& e) {
    return e.error;
  } catch (const toml::parse_error& e) {
    const auto& at = e.source().begin;
    return syntax_error(fmt::format("line {}, column {}: {}", at.line, at.column, e.description()));
  } catch (const nlohmann::json::exception& e) {
    // The library's own words begin with "[json.exception.parse_error.101] ".
    const std::string what = e.what();
    const std::size_t at = what.find("] ");
    return syntax_error(printable(at == std::string::npos ? what : what.substr(at + 2), 200));
  }
}

Result<JobSpec> read_spec_file(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw IoError("cannot read " + path.string() + ": it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError("cannot read " + path.string() + ": " + std::strerror(errno));
  std::string text(kMaxSpec + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw IoError("cannot read " + path.string() + ": " + std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMaxSpec) {
    return syntax_error(
        fmt::format("{} has more than {} bytes, which no gear needs", path.string(), kMaxSpec));
  }
  const bool in_folder = std::filesystem::is_regular_file(path, error);
  return read_spec(text, path.extension() == ".json" ? SpecFormat::json : SpecFormat::toml,
                   in_folder ? path.parent_path() : std::filesystem::path());
}

}  // namespace gearwright
