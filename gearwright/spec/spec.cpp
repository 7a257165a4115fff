#include "gearwright/spec/spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/base/error.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"
#include "gearwright/spec/read_gear.hpp"
#include "gearwright/spec/read_search.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

void note_keys(const Json& table, const std::string& path, GivenKeys& keys) {
  for (const auto& [key, value] : table.items()) {
    const std::string here = path.empty() ? key : path + "." + key;
    keys.insert(here);
    if (value.is_object()) note_keys(value, here, keys);
  }
}

bool says_thickness(const Json& tolerance) {
  return tolerance.contains("thickness_series") || tolerance.contains("span_mm") ||
         tolerance.contains("over_balls_mm");
}

// Rejects a backlash that is given together with the tooth thickness, because each of them
// determines the other.
void check_backlash(const Json& tree, const JobSpec& spec) {
  if (!spec.pair.wants_backlash()) return;
  const PairInput& p = spec.pair;
  const std::string key = p.backlash                   ? "backlash_mm"
                          : p.backlash_circumferential ? "backlash_circumferential_mm"
                                                       : "backlash_deg";
  const TableReader t(pair_keys(), tree["pair"], "pair");
  for (const std::string gear : {"gear1", "gear2"}) {
    if (!tree.contains(gear)) t.fail(key, "needs two gears, but there is no table [" + gear + "]");
    for (const char* other : {"thickness_allowance_mm", "cut_by", "basic", "tolerance"}) {
      if (!tree[gear].contains(other)) continue;
      if (other == std::string("tolerance") && !says_thickness(tree[gear][other])) continue;
      t.fail(key, fmt::format("cannot be combined with {}.{}, because both determine the tooth "
                              "thickness; leave out one of the two",
                              gear, other));
    }
  }
}

// Collects the missing inputs of all tables of a spec and reports them as one error.
class Lacks {
 public:
  template <class F>
  void of(F read) {
    try {
      read();
    } catch (const SpecError& e) {
      if (e.missing.empty()) throw;
      add(e.missing);
      caught_.push_back(e);
    }
  }
  void add(const std::vector<Error>& more) {
    for (const Error& error : more) {
      const auto known = std::find_if(all_.begin(), all_.end(),
                                      [&](const Error& e) { return e.field == error.field; });
      if (known == all_.end()) {
        all_.push_back(error);
      } else {
        *known = error;  // the later list, which belongs to a verb, gives more details
      }
    }
  }
  /// If the first input is missing, the second input is not reported, because it has a default when
  /// the first is given.
  void shared(const std::string& first, const std::string& second) {
    if (!has(first)) return;
    std::erase_if(all_, [&](const Error& e) { return e.field == second; });
  }
  bool any() const { return !all_.empty(); }
  bool has(const std::string& field) const {
    return std::any_of(all_.begin(), all_.end(), [&](const Error& e) { return e.field == field; });
  }
  /// Replaces the error of a missing input by a more detailed one.
  void explain(const Error& error) {
    add({error});
    caught_.clear();
  }
  void finish() const {
    if (all_.empty()) return;
    if (caught_.size() == 1 && caught_[0].missing.size() == all_.size()) throw caught_[0];
    throw SpecError{all_missing(all_), all_};
  }

 private:
  std::vector<Error> all_;
  std::vector<SpecError> caught_;
};

// Returns the error of a missing module of gear 1. The error names the module that fits the centre
// distance. Without a centre distance, it names the readings from which the module can be computed.
Error missing_module(const Json& tree) {
  const auto number = [&](const char* table, const char* key) {
    const Json& of = tree.value(table, Json::object());
    const auto it = of.find(key);
    return it != of.end() && it->is_number() ? it->get<double>() : 0.0;
  };
  std::string hint =
      "or, if it is unknown, give readings in [gear1.measured], from which the command `gearwright "
      "identify` computes the module";
  const double a = number("pair", "center_distance_mm");
  const double z1 = number("gear1", "teeth"), z2 = number("gear2", "teeth");
  if (a > 0.0 && z1 != 0.0 && z2 != 0.0 && z1 + z2 != 0.0 &&
      number("pair", "shaft_angle_deg") == 0.0) {
    const double beta = Angle::degrees(number("gear1", "helix_angle_deg")).rad();
    hint = fmt::format(
        "for these teeth without profile shift at the centre distance of {} mm, normal_module_mm "
        "is {:.6g}. The command `gearwright search` finds standard modules with profile shifts for "
        "center_distance_mm and ratio in [search]",
        format_number(a), 2 * a * std::cos(beta) / std::abs(z1 + z2));
  }
  return absent_input(
      "gear1.normal_module_mm",
      fmt::format("; give the module, for example normal_module_mm = 2 (possible keys: {}); {}",
                  fmt::join(gear_keys().ways("normal_module_mm"), ", "), hint));
}

// Copies the material of [rating] to each gear that has no material of its own. If [rating] has no
// accuracy grades, copies the grades of the gears to [rating].
void share_with_rating(const Json& tree, JobSpec& spec) {
  RatingTable& rating = spec.rating;
  auto& [one, two] = spec.gears;
  for (const char* gear : {"gear1", "gear2"}) {
    auto& made = spec.gears[gear == std::string_view("gear2")];
    if (made && rating.material && !tree[gear].contains("material"))
      made->material = *rating.material;
  }
  if (rating.input.quality || !one || !two) return;
  if (one->tolerance.quality && two->tolerance.quality)
    rating.input.quality = {*one->tolerance.quality, *two->tolerance.quality};
}

void check_speeds(const JobSpec& spec) {
  const auto &own = spec.pair.speed_rpm, &rated = spec.rating.input.speed;
  if (own && rated && std::abs(*own - *rated) > kSameInput * *own)
    throw SpecError{{"rating.speed_rpm", format_number(*rated),
                     fmt::format("contradicts pair.speed_rpm = {}, which is also the speed of gear "
                                 "1; leave out one of the two",
                                 format_number(*own))}};
}

void share_shafts(const Json& tree, JobSpec& spec) {
  MeshShafts shafts;
  shafts.gear2_drives = spec.load.driver == 2;
  for (const int which : {1, 2}) {
    const std::size_t i = which - 1;
    const auto& gear = spec.gears[i];
    if (!gear || !gear->shaft) continue;
    const std::string key = gear_field(which, "shaft");
    const auto refuse = [&](const char* why) { throw SpecError{{key, "", why}}; };
    if (tree.contains("search"))
      refuse(
          "does not apply to a search, whose gears have no position on a shaft; give "
          "rating.face_load_factor or [rating.mounting]");
    if (gear->cylindrical.teeth < 0)
      refuse(
          "does not apply to an internal gear, because its rim is not a shaft; give the shaft of "
          "the pinion, which alone determines the face load factor");
    if (spec.rating.input.mounting)
      refuse(
          "cannot be combined with [rating.mounting], which also describes the shaft of the "
          "pinion; leave out one of the two");
    shafts.of[i] = gear->shaft;
  }
  if (shafts.any()) spec.rating.input.shafts = shafts;
}

// Computes the torques on gear 1 from the torques on the driven gear, without losses. In a search,
// the numbers of teeth are those of each design, and only the case that gear 2 drives is known here.
void find_input_torques(const Json& tree, JobSpec& spec) {
  LoadInput& load = spec.load;
  RatingTable& rating = spec.rating;
  if (load.output_torques.empty() && !rating.output_torque) return;
  const std::string table = load.output_torques.empty() ? "rating" : "load";
  if (is_drive(tree) || is_drive_search(tree.value("search", Json())))
    throw SpecError{{table + ".output_torque_Nm", shown(tree[table]["output_torque_Nm"]),
                     "applies to a pair; for a drive, give the torque on the input by torque_Nm, "
                     "T_in = T_out/(i η). The command `gearwright drive` computes i and η without "
                     "a torque"}};
  const bool on_gear_2 = load.driver != 2;
  if (on_gear_2 && !(spec.has(1) && spec.has(2))) return;
  const auto on_gear_1 = [&](double torque) {
    return on_gear_2 ? balancing_torque(torque, spec.gear(1).cylindrical.teeth,
                                        spec.gear(2).cylindrical.teeth)
                     : torque;
  };
  for (const double torque : load.output_torques) load.torques.push_back(on_gear_1(torque));
  if (!rating.output_torque) return;
  rating.torque = on_gear_1(*rating.output_torque);
  rating.input.torque = *rating.torque;
}

// Rejects K_Hβ = "computed" for specs whose rating cannot compute it: searches, drives and
// double-helical gears.
void refuse_computed_face_load(const Json& tree, const JobSpec& spec) {
  if (!spec.rating.input.face_load_computed) return;
  const auto refuse = [](const char* why) {
    throw SpecError{{"rating.face_load_factor", "\"computed\"", why}};
  };
  if (tree.contains("search"))
    refuse(
        "is not supported in a search, because it would take seconds for each design; give a "
        "number or [rating.mounting]. The spec that --take writes can have \"computed\"");
  if (is_drive(tree))
    refuse("is not supported for a drive, whose bodies have no shafts; give a number");
  if (spec.has(1) && spec.gear(1).double_helical)
    refuse("is supported for single-helical gears only; give a number");
}

// Rejects the keys of [load] that describe planets if the spec has no drive.
void refuse_planets(const Json& tree) {
  const auto load = tree.find("load");
  if (is_drive(tree) || load == tree.end() || !load->is_object()) return;
  for (const char* key : {"floating", "pin_error_um"})
    if (load->contains(key))
      throw SpecError{{std::string("load.") + key, shown((*load)[key]),
                       "applies to the planets of a drive, but the spec has no drive ([planetary], "
                       "[[stage]] or [drive])"}};
}

// Rejects a gear 2 whose form is neither a gear nor a rack. The form determines which keys [gear2]
// may contain.
void check_form(const Json& gear_2) {
  const auto form = gear_2.find("form");
  if (form == gear_2.end() || !form->is_string() || *form == "gear" || is_rack(gear_2)) return;
  throw SpecError{
      {"gear2.form", shown(*form), one_of_rule(form->get<std::string>(), {"gear", "rack"})}};
}

// Reads a rack as gear 2. [pair] may then contain only the keys that apply to a rack.
RackBar read_rack_bar(const Json& rack, const Json& tree, const std::optional<GearInput>& pinion) {
  TableReader t(rack_bar_keys(), rack, "gear2");
  for (const auto& [key, value] : rack.items())
    if (gear_keys().find(key) && !rack_bar_keys().find(key)) t.fail(key, std::string(kNotOfRack));
  RackBar bar;
  t.read(bar);
  if (pinion) {
    const CylindricalSpec& teeth = pinion->cylindrical;
    set_rack_length(t, std::numbers::pi * teeth.normal_module / std::cos(teeth.helix_angle.rad()),
                    bar);
  }
  t.finish();
  const auto pair = tree.find("pair");
  if (pair == tree.end() || !pair->is_object()) return bar;
  constexpr std::array kOfRacks{
      "center_distance_mm",          "speed_rpm",    "friction_coefficient", "backlash_mm",
      "backlash_circumferential_mm", "backlash_deg", "backlash_split"};
  for (const auto& [key, value] : pair->items()) {
    if (is_in(key, kOfRacks) || !pair_keys().find(key)) continue;
    throw SpecError{
        {"pair." + key, shown(value),
         fmt::format("does not apply to a rack and pinion, for which only {} are allowed",
                     fmt::join(kOfRacks, ", "))}};
  }
  return bar;
}

// Rejects a double-helical gear if the spec has a search or a fit, if the gear is unknown, or if
// the gear is the pinion of a rack.
void refuse_halves(const Json* gear, const std::string& path, const Json& tree) {
  if (!gear || !gear->contains("double_helical")) return;
  TableReader t(gear_keys(), *gear, path);
  if (tree.contains("search") || tree.contains("fit") || is_unknown_gear(*gear))
    t.fail("double_helical", "is not supported in a search, a fit or an identification");
  if (is_rack(tree.value("gear2", Json::object())))
    t.fail("double_helical",
           "is not supported for the pinion of a rack; give the gears of one half, with the face "
           "width of the half. The other half has the same numbers with the opposite hand, and the "
           "halves share the force on the rack");
}

// Checks the modifications in the table of a gear without teeth. The designs of a search have these
// modifications.
void check_modifications(const Json* gear, const char* name, const std::filesystem::path& folder) {
  if (!gear || gear->contains("teeth")) return;  // read_gear() reads a complete gear
  TableReader t(blank_keys(), *gear, name);
  read_modifications(t, folder);
}

JobSpec read_tree(const Json& spec_in_mm, const GivenKeys& given,
                  const std::filesystem::path& folder, SpecUse use) {
  Inherited made = inherit(with_named_materials(spec_in_mm));
  if (is_drive(made.tree) || is_drive_search(made.tree.value("search", Json())))
    lend_speed(made.tree);
  lend_face_load(made.tree);
  const Json& tree = made.tree;
  TableReader t(spec_keys(), tree, "");
  t.refuse_unknown();
  JobSpec spec;
  spec.given = given;
  Lacks lacks;
  spec.tree = std::make_shared<const SpecTree>(SpecTree{tree});
  spec.inherited = made.noted;
  const Json* gear_1 = t.table("gear1");
  const Json* gear_2 = t.table("gear2");
  const Json* search = t.table("search");
  if (gear_2) check_form(*gear_2);
  // In a spec with [search], a table of a gear without teeth contains only the data that the search
  // does not choose. The mating gear of an unknown gear needs only its number of teeth.
  const auto is_gear = [&](const Json* gear) {
    const Json* other = gear == gear_1 ? gear_2 : gear_1;
    return gear && (!search || gear->contains("teeth")) && !is_unknown_gear(*gear) &&
           !(gear == gear_2 && is_rack(*gear)) &&
           !(other && is_unknown_gear(*other) && !has_module(*gear));
  };
  spec.measured = {read_measured(tree, 1), read_measured(tree, 2)};
  const bool unknown = spec.measured[0] || spec.measured[1];
  for (const char* table : {"planetary", "stage", "drive"}) t.any(table);  // read below
  if (is_drive(tree)) {
    for (const char* table : {"gear1", "gear2", "pair", "search"})
      t.refuse(table,
               "cannot be combined with a drive, because a spec describes either a drive or a pair "
               "of gears");
    lacks.of([&] { spec.drive = std::make_shared<const DriveInput>(read_drive(tree, folder)); });
  } else if (!gear_1 && !search && !unknown) {
    lacks.add({absent_input(
        "gear1", "; a spec needs a table [gear1] with at least teeth and normal_module_mm")});
  }
  if (is_gear(gear_1))
    lacks.of([&] { spec.gears[0] = read_gear(gear_keys(), *gear_1, "gear1", gear_2, folder); });
  if (is_gear(gear_2))
    lacks.of([&] { spec.gears[1] = read_gear(gear_keys(), *gear_2, "gear2", gear_1, folder); });
  if (gear_2 && is_rack(*gear_2))
    lacks.of([&] { spec.rack = read_rack_bar(*gear_2, tree, spec.gears[0]); });
  refuse_halves(gear_1, "gear1", tree);
  refuse_halves(gear_2, "gear2", tree);
  if (lacks.has("gear1.normal_module_mm")) lacks.explain(missing_module(tree));
  lacks.shared("gear1.normal_module_mm", "gear2.normal_module_mm");
  lacks.shared("gear2.teeth",
               "gear2.normal_module_mm");  // if gear 2 has teeth, it takes the module of gear 1
  if (spec.gears[1] && made.helix_angle) spec.gears[1]->helix_given = false;
  const bool drives = search && is_drive_search(*search);
  if (drives) {
    for (const char* table : {"gear1", "gear2", "pair"})
      t.refuse(table, "cannot be combined with a search for drives");
    lacks.of([&] { read_drive_search(*search); });  // the table is read again when it is used
  }
  if (search && !drives)
    lacks.of([&] { spec.search = read_search(*search, gear_1, gear_2, spec.units()); });
  if (spec.search) {
    lacks.of([&] { check_modifications(gear_1, "gear1", folder); });
    lacks.of([&] { check_modifications(gear_2, "gear2", folder); });
  }
  if (const Json* scatter = t.table("scatter"))
    lacks.of([&] { spec.scatter = read_scatter(*scatter); });
  for (const Key& key : spec_keys().keys)
    if (key.place) lacks.of([&] { t.read(key, static_cast<SpecTables&>(spec)); });
  read_mesh_load_factors(tree);  // read here only to report errors; a rating reads them again
  refuse_planets(tree);
  share_with_rating(tree, spec);
  check_speeds(spec);
  share_shafts(tree, spec);
  find_input_torques(tree, spec);
  refuse_computed_face_load(tree, spec);
  if (search && !drives) lacks.of([&] { read_search_rating(tree, spec); });
  if (spec.search) lacks.of([&] { read_search_drawing(*search, *spec.search); });
  t.finish();
  if (!lacks.any()) check_backlash(tree, spec);
  lacks.add(missing_for(use, spec));
  lacks.finish();
  return spec;
}

Result<JobSpec> read_parsed(const Json& tree, std::string text, const std::filesystem::path& folder,
                            SpecUse use) {
  GivenKeys given;
  Json in_mm;
  try {
    in_mm = in_catalogue_units(tree, given);
  } catch (const SpecError& e) {
    return e.error;
  }
  note_keys(in_mm, "", given);
  try {
    JobSpec spec = read_tree(in_mm, given, folder, use);
    spec.text = std::move(text);
    spec.folder = folder;
    return spec;
  } catch (const SpecError& e) {
    return in_units_of(given, e.error);
  }
}

}  // namespace

Result<JobSpec> read_spec_tree(const Json& tree, const std::filesystem::path& folder, SpecUse use) {
  if (auto error = check_tree(tree)) return *error;
  return read_parsed(tree, json_text(tree, 2), folder, use);
}

Result<JobSpec> read_spec(const SpecText& text, SpecUse use) {
  const auto tree = parse_spec(text.text, text.format);
  if (!tree) return tree.error();
  return read_parsed(*tree, text.text, text.folder, use);
}

Result<JobSpec> read_spec(std::string_view text, SpecFormat format,
                          const std::filesystem::path& folder, SpecUse use) {
  return read_spec({"", std::string(text), format, folder}, use);
}

std::optional<Error> only_in_mm(const JobSpec& spec, std::string_view feature) {
  if (spec.units() == UnitSystem::mm) return std::nullopt;
  return Error{
      "units", "\"inch\"",
      fmt::format("is not supported by {}; give the spec in mm, without the key units", feature)};
}

Result<JobSpec> read_spec_file(const std::filesystem::path& path) {
  const auto text = read_spec_text(path);
  if (!text) return text.error();
  return read_spec(*text);
}

}  // namespace gearwright
