// toml++ 3.3 answers some broken input ("[" and a newline) with an assert instead of a parse error;
// the release behaviour of the same code is a clean parse error, so this file takes that in every
// build.
#ifndef NDEBUG
#define NDEBUG
#endif
#include "gearwright/job/spec.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "gearwright/base/output_file.hpp"
#include "gearwright/job/table_reader.hpp"

namespace gearwright {

namespace {

constexpr double kSameInput = 1e-9;  // two ways of saying one thing may differ by rounding

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
Json parse_json(std::string_view text) {
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
      throw SpecError{{key, "", fmt::format("{}: stands twice in one table; leave one out", key)}};
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
    } else if (c == '.' && ++dots > 8 * kDeepest) {
      return line;
    }
  }
  return std::nullopt;
}

// One quantity said by several keys: each reader gives the value in the first one's unit.
class Once {
 public:
  Once(TableReader& table, std::string what) : table_(table), what_(std::move(what)) {}
  void offer(const std::string& key, std::optional<double> value) {
    keys_ += (keys_.empty() ? "" : ", ") + key;
    if (!value) return;
    if (value_ && std::abs(*value - *value_) > kSameInput * std::abs(*value_)) {
      table_.fail(key, fmt::format("contradicts {}: both say the {}, leave one out", key_, what_));
    }
    if (!value_) {
      value_ = value;
      key_ = key;
    }
  }
  std::optional<double> value() const { return value_; }
  double required() const {
    if (!value_) {
      const std::string first = keys_.substr(0, keys_.find(','));
      table_.fail(first, fmt::format("is missing; the {} is needed, by one of: {}", what_, keys_));
    }
    return *value_;
  }

 private:
  TableReader& table_;
  std::string what_;
  std::string keys_;
  std::string key_;
  std::optional<double> value_;
};

StraightRack read_rack(TableReader& gear) {
  const Json* node = gear.any("rack");
  if (!node) return *iso53_rack("ISO53-A");
  if (node->is_string()) {
    const auto rack = iso53_rack(node->get<std::string>());
    if (!rack) {
      gear.fail("rack", "must be \"ISO53-A\", \"ISO53-B\", \"ISO53-C\", \"ISO53-D\" or a table, [" +
                            gear.name("rack") + "]");
    }
    return *rack;
  }
  if (!node->is_object()) gear.fail("rack", "must be a name in quotes or a table");
  TableReader t(*node, gear.name("rack"));
  const auto kind = t.one_of("kind", {"straight", "circular_arc"});
  if (kind && *kind == "circular_arc") {
    t.fail("kind", "this version cuts with straight racks only; \"straight\" is allowed");
  }
  StraightRack rack;
  if (auto v = t.number("addendum")) rack.addendum = *v;
  if (auto v = t.number("dedendum")) rack.dedendum = *v;
  if (auto v = t.number("root_fillet_radius")) rack.root_fillet_radius = *v;
  if (auto v = t.number("tip_fillet_radius")) rack.tip_fillet_radius = *v;
  rack.tool_addendum = t.number("tool_addendum");
  if (auto v = t.number("semi_topping_angle_deg")) rack.semi_topping_angle = Angle::degrees(*v);
  if (auto v = t.number("protuberance")) rack.protuberance = *v;
  if (auto v = t.number("protuberance_angle_deg")) rack.protuberance_angle = Angle::degrees(*v);
  t.finish();
  return rack;
}

std::optional<Bore> read_bore(TableReader& gear) {
  const Json* node = gear.table("bore");
  if (!node) return std::nullopt;
  TableReader t(*node, gear.name("bore"));
  const auto diameter = t.positive("diameter_mm");
  const auto width = t.positive("keyway_width_mm");
  const auto depth = t.positive("keyway_depth_mm");
  t.finish();
  if (!diameter) t.fail("diameter_mm", "is missing: a bore needs its diameter");
  if (width.has_value() != depth.has_value()) {
    t.fail(width ? "keyway_depth_mm" : "keyway_width_mm",
           "is missing: a keyway needs width and depth");
  }
  if (width && *width >= *diameter) {
    t.fail("keyway_width_mm",
           fmt::format("must be less than the bore's diameter {} mm", *diameter));
  }
  return Bore{*diameter, width.value_or(0.0), depth.value_or(0.0)};
}

double read_helix(TableReader& t) {
  const auto beta = t.number("helix_angle_deg");
  const auto lead = t.number("lead_angle_deg");
  const auto hand = t.one_of("hand", {"right", "left"});
  if (beta && !(std::abs(*beta) < 90.0)) {
    t.fail("helix_angle_deg", "must lie between -90 (left hand) and 90 (right hand)");
  }
  if (lead && !(*lead > 0.0 && *lead <= 90.0)) {
    t.fail("lead_angle_deg", "must be greater than 0 and at most 90 (spur)");
  }
  if (lead && !hand && *lead < 90.0) {
    t.fail("lead_angle_deg", "needs hand = \"right\" or \"left\" beside it");
  }
  Once once(t, "helix angle");
  once.offer("helix_angle_deg", beta);
  if (lead) once.offer("lead_angle_deg", (90.0 - *lead) * (hand && *hand == "left" ? -1.0 : 1.0));
  const double value = once.value().value_or(0.0);
  if (hand && value != 0.0 && (value > 0.0) != (*hand == "right")) {
    t.fail("hand", "contradicts the sign of helix_angle_deg (> 0 is a right hand)");
  }
  return value;
}

// Keys of the interface that change a gear's geometry and are not in this version.
void refuse_what_is_not_here(TableReader& t) {
  t.refuse(
      "basic",
      "gears given by their base cylinder are not in this version; give module, helix and shift");
  t.refuse("cut_by",
           "generation by a pinion cutter is not in this version; give the gear its own rack");
  t.refuse("profile_shift_pair", "belongs to cut_by, which is not in this version");
  t.refuse("root_fillet",
           "a modified root fillet is not in this version; the rack's root_fillet_radius is");
  t.refuse("tip_fillet",
           "a modified tip fillet is not in this version; the rack's tip_fillet_radius is");
  t.refuse("modifications", "flank modifications are not in this version");
}

std::optional<double> pressure_angle(TableReader& t, const char* key) {
  const auto value = t.number(key);
  if (value && !(*value > 0.0 && *value < 90.0))
    t.fail(key, "must lie between 0 and 90, usually 14.5 to 30");
  return value;
}

// α_n of the transverse angle α_t, both in degrees:  tan α_n = tan α_t cos β.
double normal_of_transverse(double alpha_t, double cos_beta) {
  return Angle::radians(std::atan(std::tan(Angle::degrees(alpha_t).rad()) * cos_beta)).deg();
}

GearInput read_gear(const Json& node, const std::string& path) {
  TableReader t(node, path);
  GearInput g;
  CylindricalSpec& c = g.cylindrical;
  const auto teeth = t.integer("teeth");
  if (teeth && *teeth == 0) t.fail("teeth", "must not be 0; negative for an internal gear (ring)");
  refuse_what_is_not_here(t);
  c.helix_angle = Angle::degrees(read_helix(t));
  const double cos_beta = std::cos(c.helix_angle.rad());
  Once module(t, "module");
  module.offer("normal_module_mm", t.positive("normal_module_mm"));
  const auto pitch = t.positive("normal_diametral_pitch_per_in");
  module.offer("normal_diametral_pitch_per_in",
               pitch ? std::optional(25.4 / *pitch) : std::nullopt);
  const auto m_t = t.positive("transverse_module_mm");
  module.offer("transverse_module_mm", m_t ? std::optional(*m_t * cos_beta) : std::nullopt);
  Once alpha(t, "pressure angle");
  alpha.offer("normal_pressure_angle_deg", pressure_angle(t, "normal_pressure_angle_deg"));
  const auto alpha_t = pressure_angle(t, "transverse_pressure_angle_deg");
  alpha.offer("transverse_pressure_angle_deg",
              alpha_t ? std::optional(normal_of_transverse(*alpha_t, cos_beta)) : std::nullopt);
  c.normal_pressure_angle = Angle::degrees(alpha.value().value_or(20.0));
  g.profile_shift = t.number("profile_shift");
  c.thickness_allowance = t.number("thickness_allowance_mm").value_or(0.0);
  const auto face = t.positive("face_width_mm");
  c.tip_diameter = t.positive("tip_diameter_mm");
  c.rack = read_rack(t);
  g.bore = read_bore(t);
  for (const char* key : {"measure", "measured"}) {
    if (t.has(key)) g.not_read.push_back("[" + t.name(key) + "]");
  }
  t.finish();
  // A misspelt key is named before the one that is missing because of it.
  if (!teeth)
    t.fail("teeth", "is missing: the number of teeth, negative for an internal gear (ring)");
  c.teeth = *teeth;
  c.normal_module = module.required();
  g.face_width_given = face.has_value();
  c.face_width = face.value_or(10 * c.normal_module);
  return g;
}

PairInput read_pair(const Json& node, std::vector<std::string>& not_read) {
  TableReader t(node, "pair");
  PairInput p;
  p.center_distance = t.positive("center_distance_mm");
  const auto mounting = t.one_of("mounting", {"tight", "extended"});
  if (mounting && *mounting == "extended") p.mounting = Mounting::extended;
  p.shorten_tips = t.boolean("shorten_tips").value_or(false);
  const auto sigma = t.number("shaft_angle_deg");
  if (sigma && *sigma != 0.0) {
    t.fail("shaft_angle_deg", "this version mounts gears on parallel axes only; 0 is allowed");
  }
  const auto friction = t.number("friction_coefficient");
  if (friction && !(*friction >= 0.0)) {
    t.fail("friction_coefficient", "must be 0 or greater, usually 0.03 to 0.1");
  }
  if (friction) not_read.push_back("pair.friction_coefficient");
  t.finish();
  return p;
}

JobSpec read_tree(const Json& tree) {
  TableReader t(tree, "");
  JobSpec spec;
  spec.title = t.text("title").value_or("");
  if (const Json* node = t.table("gear1")) spec.gears[0] = read_gear(*node, "gear1");
  if (const Json* node = t.table("gear2")) spec.gears[1] = read_gear(*node, "gear2");
  if (const Json* node = t.table("pair")) spec.pair = read_pair(*node, spec.not_read);
  for (const char* key : {"errors", "contact", "search", "fit", "compensate"}) {
    if (t.has(key)) spec.not_read.push_back("[" + std::string(key) + "]");
  }
  t.finish();
  if (!spec.gears[0]) {
    throw SpecError{{"gear1", "",
                     "gear1: is missing; a spec describes a gear in a table [gear1] with at least "
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

Result<JobSpec> read_spec(std::string_view text, SpecFormat format) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return syntax_error("it is empty; the least is [gear1] with teeth and normal_module_mm");
  }
  try {
    if (format == SpecFormat::json) {
      const Json tree = parse_json(text);
      if (!tree.is_object()) return syntax_error("a JSON spec is one object, {\"gear1\": {...}}");
      return with_text(read_tree(tree), text);
    }
    if (const auto line = deep_line(text)) {
      return syntax_error(fmt::format("line {} nests more than {} tables", *line, kDeepest));
    }
    return with_text(read_tree(to_json(toml::parse(text))), text);
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
  std::string text(kLargestSpec + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw IoError("cannot read " + path.string() + ": " + std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kLargestSpec) {
    return syntax_error(
        fmt::format("{} has more than {} bytes, which no gear needs", path.string(), kLargestSpec));
  }
  return read_spec(text, path.extension() == ".json" ? SpecFormat::json : SpecFormat::toml);
}

}  // namespace gearwright
