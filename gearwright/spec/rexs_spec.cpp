#include "gearwright/spec/rexs_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "gearwright/base/units.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/spec/toml_text.hpp"

namespace gearwright {

namespace {

using Component = RexsComponent;

Error no_spec(std::string rule) { return {"", "", std::move(rule)}; }

std::string named(const Component& c) {
  return c.name.empty() ? fmt::format("{} {}", c.type, c.id) : fmt::format("\"{}\"", c.name);
}

bool is_gear(const Component& c) { return c.type == "cylindrical_gear" || c.type == "ring_gear"; }

struct Stage {
  const Component* stage;
  std::array<const Component*, 2> gears;
};

class Reader {
 public:
  explicit Reader(const RexsModel& model) : model_(model) {}

  Result<RexsSpec> spec() {
    if (auto error = find_stages()) return *error;
    const auto sets = model_.of_type("planetary_stage");
    if (sets.size() > 1 || (!sets.empty() && model_.of_type("ring_gear").size() != 1))
      return no_spec(
          "the file has several planetary stages or ring gears, but only a single planetary set "
          "can be read");
    auto made = !sets.empty() ? planetary() : stages_.size() == 1 ? pair() : train();
    if (!made) return made.error();
    note_the_rest();
    return RexsSpec{std::move(made).take(), std::move(notes_)};
  }

 private:
  std::optional<Error> find_stages() {
    for (const RexsRelation& r : model_.relations) {
      const Component* stage = r.type == "stage" ? model_.find(r.of("stage")) : nullptr;
      if (!stage || stage->type != "cylindrical_stage") continue;
      Stage s{stage, {model_.find(r.of("gear_1")), model_.find(r.of("gear_2"))}};
      for (const Component* gear : s.gears) {
        if (!gear || !is_gear(*gear))
          return no_spec(
              fmt::format("stage {} does not have two cylindrical gears", named(*stage)));
        if (!gear->number("number_of_teeth"))
          return no_spec(fmt::format("gear {} has no `number_of_teeth`", named(*gear)));
      }
      stages_.push_back(s);
    }
    if (stages_.empty()) return no_spec("the file has no cylindrical stage");
    return std::nullopt;
  }

  // The first component with a type in `types` that belongs to the same relation as `id`. The type
  // of the relation must be in `relations`.
  const Component* related(std::string_view id, std::initializer_list<std::string_view> relations,
                           std::initializer_list<std::string_view> types) const {
    for (const RexsRelation& r : model_.relations) {
      if (std::find(relations.begin(), relations.end(), r.type) == relations.end() || !r.names(id))
        continue;
      for (const auto& [role, other] : r.refs) {
        const Component* const c = model_.find(other);
        if (c && c->id != id && std::find(types.begin(), types.end(), c->type) != types.end())
          return c;
      }
    }
    return nullptr;
  }

  const Component* flank_of(const Component& gear) const {
    return related(gear.id, {"flank"}, {"cylindrical_gear_flank", "flank_geometry"});
  }
  const Component* shaft_of(const Component& gear) const {
    return related(gear.id, {"assembly"}, {"shaft"});
  }
  // The tool is connected to the gear or to its flank, by a reference or by a manufacturing step.
  const Component* tool_of(const Component& gear) const {
    const Component* const flank = flank_of(gear);
    for (const Component* part : {&gear, flank}) {
      if (!part) continue;
      const Component* const tool =
          related(part->id, {"reference", "ordered_reference", "manufacturing_step"},
                  {"rack_shaped_tool", "cutter_wheel_tool"});
      if (tool) return tool;
    }
    return nullptr;
  }

  int teeth_of(const Component& gear) const {
    const int z = static_cast<int>(std::lround(std::abs(*gear.number("number_of_teeth"))));
    return gear.type == "ring_gear" ? -z : z;
  }

  std::optional<double> shift_of(const Component& gear) const {
    const Component* const flank = flank_of(gear);
    return flank ? flank->number("addendum_modification_coefficient") : std::nullopt;
  }

  // The rack of a tool. In version 2.0 the radius of the tip corners has a new name.
  static Json rack_of(const Component& tool) {
    Json rack = Json::object();
    const bool hob = tool.type == "rack_shaped_tool";
    if (auto h = tool.number("addendum_coefficient_reference_profile"))
      rack[hob ? "dedendum" : "addendum"] = *h;
    auto radius = tool.number("tip_radius_factor");
    if (!radius) radius = tool.number("tip_corner_radius_factor_reference_profile");
    if (radius) rack[hob ? "root_fillet_radius" : "tip_fillet_radius"] = *radius;
    return rack;
  }

  Json gear_table(const Component& gear, bool of_drive) {
    Json table = Json::object();
    table["teeth"] = teeth_of(gear);
    put(table, "normal_module_mm", gear.number("normal_module"));
    const Component* const flank = flank_of(gear);
    if (flank) put(table, "normal_pressure_angle_deg", flank->number("normal_pressure_angle"));
    put(table, "helix_angle_deg", gear.number("helix_angle_reference_diameter"));
    put(table, "profile_shift", shift_of(gear));
    put(table, "face_width_mm", gear.number("face_width"));
    put(table, "tip_diameter_mm", gear.number("tip_diameter"));
    auto series = gear.text("tooth_thickness_deviation_tolerance_series_din_3967_1978");
    if (!series) series = gear.text("din_3967_deviation_tolerance_series");
    if (series && !of_drive) table["thickness_series"] = *series;
    if (const auto allowance = allowance_of(gear, series, of_drive))
      table["thickness_allowance_mm"] = *allowance;
    if (const Component* const tool = tool_of(gear)) {
      const Json rack = rack_of(*tool);
      if (tool->type == "rack_shaped_tool" && !rack.empty()) {
        table["rack"] = rack;
      } else if (tool->type == "cutter_wheel_tool" && tool->number("number_of_teeth")) {
        if (of_drive) {
          note(
              "The pinion cutter is not read, because the gears of a drive are cut by default "
              "cutters.");
        } else {
          table["cut_by"] = {{"teeth", std::lround(*tool->number("number_of_teeth"))}};
          if (!rack.empty()) table["cut_by"]["rack"] = rack;
          if (table.erase("thickness_allowance_mm") + table.erase("thickness_series") > 0)
            note(
                fmt::format("The thickness of gear {} is not read, because its cutter determines "
                            "the thickness.",
                            named(gear)));
        }
      }
    }
    if (const Component* const material = related(gear.id, {"reference"}, {"material"}))
      note(fmt::format("The material {} of gear {} is not read.",
                       material->text("material_designation").value_or(named(*material)),
                       named(gear)));
    return table;
  }

  // The thickness allowance, computed from the generating profile shift. In a drive, which has no
  // tolerances, it is the mean allowance of the series.
  std::optional<double> allowance_of(const Component& gear,
                                     const std::optional<std::string>& series,
                                     bool of_drive) const {
    const Component* const flank = flank_of(gear);
    const auto module = gear.number("normal_module");
    if (!flank || !module) return std::nullopt;
    if (series && !of_drive) return std::nullopt;
    if (series) {
      const double beta = gear.number("helix_angle_reference_diameter").value_or(0.0) * kRadPerDeg;
      const auto both =
          thickness_allowances(*series, std::abs(teeth_of(gear)) * *module / std::cos(beta));
      return both ? std::optional(((*both)[0] + (*both)[1]) / 2) : std::nullopt;
    }
    const auto x = shift_of(gear);
    const auto generated = flank->number("generated_addendum_modification_coefficient");
    if (!x || !generated) return std::nullopt;
    const double alpha = flank->number("normal_pressure_angle").value_or(20.0) * kRadPerDeg;
    return (*generated - *x) * 2 * *module * std::tan(alpha);
  }

  static void put(Json& table, const char* key, std::optional<double> value) {
    if (value) table[key] = *value;
  }

  void note(std::string text) {
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end())
      notes_.push_back(std::move(text));
  }

  static std::optional<double> distance_of(const Stage& s) {
    return s.stage->number("center_distance");
  }

  std::string title() const {
    const auto units = model_.of_type("gear_unit");
    return !units.empty() && !units[0]->name.empty() ? units[0]->name : "gear unit";
  }

  Json start() const { return {{"title", title()}}; }

  Result<Json> pair() {
    Stage s = stages_[0];
    if (teeth_of(*s.gears[0]) < 0) std::swap(s.gears[0], s.gears[1]);
    Json spec = start();
    spec["gear1"] = gear_table(*s.gears[0], false);
    spec["gear2"] = gear_table(*s.gears[1], false);
    if (auto a = distance_of(s)) spec["pair"]["center_distance_mm"] = *a;
    return spec;
  }

  // The load on this shaft that defines a torque, or null.
  const Component* torque_on(const Component& shaft) const {
    for (const Component* load : model_.of_type("external_load"))
      if (load->text("defines_torque") == "true" && load->number("torque_around_u_axis") &&
          related(load->id, {"assembly"}, {"shaft"}) == &shaft)
        return load;
    return nullptr;
  }

  // The chain of stages along their common shafts. It starts at the shaft with the given torque, or
  // at the first stage if there is none.
  Result<Json> train() {
    const auto next_on = [&](const Component* shaft, const std::set<const Component*>& used) {
      Stage* found = nullptr;
      for (Stage& s : stages_) {
        if (used.count(s.stage) > 0) continue;
        for (const std::size_t i : {0U, 1U}) {
          if (!shaft || shaft_of(*s.gears[i]) != shaft) continue;
          if (i == 1) std::swap(s.gears[0], s.gears[1]);
          found = &s;
          break;
        }
        if (found) break;
      }
      return found;
    };
    const Component* first = nullptr;
    for (const Component* shaft : model_.of_type("shaft")) {
      const auto on_it = std::count_if(stages_.begin(), stages_.end(), [&](const Stage& s) {
        return shaft_of(*s.gears[0]) == shaft || shaft_of(*s.gears[1]) == shaft;
      });
      if (on_it == 1 && (!first || torque_on(*shaft))) first = shaft;
    }
    std::set<const Component*> used;
    Json spec = start();
    spec["stage"] = Json::array();
    const Component* shaft = first;
    while (Stage* s = next_on(shaft, used)) {
      used.insert(s->stage);
      Json stage = {{"gears", {gear_table(*s->gears[0], true), gear_table(*s->gears[1], true)}}};
      if (auto a = distance_of(*s)) stage["center_distance_mm"] = *a;
      if (spec["stage"].empty()) add_load(stage, *shaft);
      spec["stage"].push_back(std::move(stage));
      shaft = shaft_of(*s->gears[1]);
    }
    if (used.size() != stages_.size())
      return no_spec(
          fmt::format("the {} cylindrical stages do not form a chain from one shaft to the next; "
                      "describe such a gear unit by [drive], or use a separate file for each stage",
                      stages_.size()));
    return spec;
  }

  void add_load(Json& table, const Component& shaft) {
    const Component* const load = torque_on(shaft);
    if (!load) return;
    table["torque_Nm"] = std::abs(*load->number("torque_around_u_axis"));
    auto speed = load->number("rotational_speed");
    if (!speed) speed = shaft.number("rotational_speed");
    if (speed) table["speed_rpm"] = std::abs(*speed);
  }

  Result<Json> planetary() {
    const Component* ring = model_.of_type("ring_gear")[0];
    const Component* sun = nullptr;
    const Component* planet = nullptr;
    std::set<std::string> planets;
    for (const Stage& s : stages_) {
      for (const std::size_t i : {0U, 1U}) {
        if (s.gears[i] != ring) continue;
        planet = s.gears[1 - i];
        planets.insert(planet->id);
      }
    }
    for (const Stage& s : stages_)
      for (const std::size_t i : {0U, 1U})
        if (planets.count(s.gears[i]->id) > 0 && s.gears[1 - i] != ring) sun = s.gears[1 - i];
    if (!sun || !planet)
      return no_spec("the planetary stage has no sun, planet and ring that mesh");
    Json spec = start();
    Json& set = spec["planetary"] = Json::object();
    set["sun"] = teeth_of(*sun);
    set["planet"] = teeth_of(*planet);
    set["ring"] = teeth_of(*ring);
    set["planets"] = planets.size();
    put(set, "normal_module_mm", sun->number("normal_module"));
    if (const Component* flank = flank_of(*sun))
      put(set, "normal_pressure_angle_deg", flank->number("normal_pressure_angle"));
    put(set, "helix_angle_deg", sun->number("helix_angle_reference_diameter"));
    const std::array<std::pair<const char*, const Component*>, 3> members{
        {{"sun", sun}, {"planet", planet}, {"ring", ring}}};
    for (const auto& [name, gear] : members) {
      const Json table = gear_table(*gear, true);
      for (const char* key :
           {"face_width_mm", "profile_shift", "thickness_allowance_mm", "tip_diameter_mm"})
        if (table.contains(key)) set[key][name] = table[key];
      if (table.contains("rack"))
        note(fmt::format("The tool of the {} is not read. The basic rack of ISO 53 replaces it.",
                         name));
    }
    for (const Stage& s : stages_)
      if (auto a = distance_of(s)) set["center_distance_mm"] = *a;
    if (const Component* shaft = shaft_of(*sun)) add_load(set, *shaft);
    return spec;
  }

  // Adds a note with the types of the components that no key of a spec describes.
  void note_the_rest() {
    std::map<std::string, int> left;
    for (const Component& c : model_.components) {
      constexpr std::array kRead{"cylindrical_gear", "ring_gear",        "cylindrical_stage",
                                 "gear_unit",        "planetary_stage",  "cylindrical_gear_flank",
                                 "flank_geometry",   "rack_shaped_tool", "cutter_wheel_tool",
                                 "external_load",    "material"};
      if (std::find(kRead.begin(), kRead.end(), c.type) == kRead.end()) ++left[c.type];
    }
    std::string list;
    for (const auto& [type, count] : left)
      list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", type, count);
    if (!list.empty()) note("Components that are not read: " + list + ".");
  }

  const RexsModel& model_;
  std::vector<Stage> stages_;
  std::vector<std::string> notes_;
};

}  // namespace

Result<RexsSpec> spec_of_rexs(const RexsModel& model) { return Reader(model).spec(); }

Result<std::string> spec_text_of_rexs(std::string_view xml) {
  const auto model = read_rexs(xml);
  if (!model) return model.error();
  const auto spec = spec_of_rexs(*model);
  if (!spec) return spec.error();
  std::string text = fmt::format("# This spec was read from a REXS {} file{}.\n", model->version,
                                 model->application.empty() ? "" : " of " + model->application);
  for (const std::string& n : spec->notes) text += "# " + n + "\n";
  return text + "\n" + toml_text(spec->tables);
}

}  // namespace gearwright
