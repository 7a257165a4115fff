#include "gearwright/spec/rexs_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/rexs_chain.hpp"

namespace gearwright {

namespace {

using Component = RexsComponent;

Error no_spec(std::string rule) { return {"", "", std::move(rule)}; }

class Reader {
 public:
  explicit Reader(const RexsModel& model) : model_(model) {}

  Result<RexsSpec> spec() {
    if (auto error = check_numbers()) return *error;
    if (auto error = find_stages()) return *error;
    auto links = rexs_links(model_, stages_);
    if (!links) return links.error();
    const bool single = links->size() == 1;
    auto made = !single              ? train(std::move(links).take())
                : links->front().set ? planetary(*links->front().set)
                                     : Result(pair());
    if (!made) return made.error();
    note_the_rest();
    return RexsSpec{std::move(made).take(), std::move(notes_)};
  }

 private:
  // Returns the error of the first wrong number of a part of a stage. A wrong number of another
  // component does not affect the spec, so it is only noted.
  std::optional<Error> check_numbers() {
    const auto parts = rexs_parts_of_stages(model_);
    for (const Component& c : model_.components) {
      const auto error = rexs_number_error(c);
      if (!error) continue;
      if (parts.contains(c.id)) return *error;
      note(fmt::format("A component without a cylindrical stage is not read: {}.", error->rule));
    }
    return std::nullopt;
  }

  std::optional<Error> find_stages() {
    for (const char* type : {"bevel_stage", "worm_stage", "general_stage"})
      for (const Component* stage : model_.of_type(type))
        return no_spec(fmt::format("stage {} is a {}, but only cylindrical stages can be read",
                                   rexs_name(*stage), type));
    for (const RexsRelation& r : model_.relations) {
      const Component* stage = r.type == "stage" ? model_.find(r.of("stage")) : nullptr;
      if (!stage || stage->type != "cylindrical_stage") continue;
      RexsStage s{stage, {model_.find(r.of("gear_1")), model_.find(r.of("gear_2"))}};
      for (const Component* gear : s.gears) {
        if (!gear || !is_rexs_gear(*gear))
          return no_spec(
              fmt::format("stage {} does not have two cylindrical gears", rexs_name(*stage)));
        if (!gear->number("number_of_teeth"))
          return no_spec(fmt::format("gear {} has no `number_of_teeth`", rexs_name(*gear)));
      }
      stages_.push_back(s);
    }
    if (stages_.empty()) return no_spec("the file has no cylindrical stage");
    return std::nullopt;
  }

  const Component* flank_of(const Component& gear) const {
    return model_.related(gear.id, {"flank"}, {"cylindrical_gear_flank", "flank_geometry"});
  }
  const Component* shaft_of(const Component& gear) const {
    return model_.related(gear.id, {"assembly"}, {"shaft"});
  }
  // The tool is connected to the gear or to its flank, by a reference or by a manufacturing step.
  const Component* tool_of(const Component& gear) const {
    const Component* const flank = flank_of(gear);
    for (const Component* part : {&gear, flank}) {
      if (!part) continue;
      const Component* const tool =
          model_.related(part->id, {"reference", "ordered_reference", "manufacturing_step"},
                         {"rack_shaped_tool", "cutter_wheel_tool"});
      if (tool) return tool;
    }
    return nullptr;
  }

  std::optional<double> shift_of(const Component& gear) const {
    const Component* const flank = flank_of(gear);
    return flank ? flank->number("addendum_modification_coefficient") : std::nullopt;
  }

  // Returns the rack of a tool. The radius of the tip corners is read from the attribute of version
  // 2.0 or, if that is absent, from the older attribute.
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
    table["teeth"] = rexs_teeth(gear);
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
              "The pinion cutter is not read, because a drive uses default cutters for all its "
              "gears.");
        } else {
          table["cut_by"] = {{"teeth", std::lround(*tool->number("number_of_teeth"))}};
          if (!rack.empty()) table["cut_by"]["rack"] = rack;
          if (table.erase("thickness_allowance_mm") + table.erase("thickness_series") > 0)
            note(
                fmt::format("The thickness of gear {} is not read, because its cutter determines "
                            "the thickness.",
                            rexs_name(gear)));
        }
      }
    }
    if (const Component* const material = model_.related(gear.id, {"reference"}, {"material"}))
      note(fmt::format("The material {} of gear {} is not read.",
                       material->text("material_designation").value_or(rexs_name(*material)),
                       rexs_name(gear)));
    return table;
  }

  // Returns the thickness allowance, computed from the generating profile shift. If a series is
  // given for a pair, the result is empty. If a series is given for a drive, the result is the mean
  // allowance of the series, because a drive has no tolerances.
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
          thickness_allowances(*series, std::abs(rexs_teeth(gear)) * *module / std::cos(beta));
      return both ? std::optional(((*both)[0] + (*both)[1]) / 2) : std::nullopt;
    }
    const auto x = shift_of(gear);
    const auto generated = flank->number("generated_addendum_modification_coefficient");
    if (!x || !generated) return std::nullopt;
    const double alpha = flank->number("normal_pressure_angle").value_or(20.0) * kRadPerDeg;
    // Rounding to 1e-12 mm removes the floating-point error of the difference.
    return std::round((*generated - *x) * 2 * *module * std::tan(alpha) * 1e12) / 1e12;
  }

  // Adds the usual rack to a gear 2 without a tool. Otherwise, it would have the rack of gear 1.
  void give_usual_rack(const Json& one, Json& two, const Component& gear_2) {
    if (!one.contains("rack") || two.contains("rack") || two.contains("cut_by")) return;
    two["rack"] = "ISO53-A";
    note(
        fmt::format("The file has no tool that is read for gear {}. The basic rack ISO53-A of "
                    "ISO 53 replaces it.",
                    rexs_name(gear_2)));
  }

  static void put(Json& table, const char* key, std::optional<double> value) {
    if (value) table[key] = *value;
  }

  void note(std::string text) { add_once(notes_, std::move(text)); }

  static std::optional<double> distance_of(const RexsStage& s) {
    return s.stage->number("center_distance");
  }

  std::string title() const {
    const auto units = model_.of_type("gear_unit");
    return !units.empty() && !units[0]->name.empty() ? units[0]->name : "gear unit";
  }

  Json start() const { return {{"title", title()}}; }

  Json pair() {
    RexsStage s = stages_[0];
    if (rexs_teeth(*s.gears[0]) < 0) std::swap(s.gears[0], s.gears[1]);
    Json spec = start();
    spec["gear1"] = gear_table(*s.gears[0], false);
    spec["gear2"] = gear_table(*s.gears[1], false);
    give_usual_rack(spec["gear1"], spec["gear2"], *s.gears[1]);
    if (auto a = distance_of(s)) spec["pair"]["center_distance_mm"] = *a;
    add_pair_load(spec, s);
    return spec;
  }

  // Adds the torque and the speed of gear 1. If only the torque of gear 2 is defined, gear 2 drives,
  // and its torque and speed are converted by the ratio.
  void add_pair_load(Json& spec, const RexsStage& s) const {
    const double ratio =
        std::abs(static_cast<double>(rexs_teeth(*s.gears[1])) / rexs_teeth(*s.gears[0]));
    for (const std::size_t i : {1U, 0U}) {
      const Component* const shaft = shaft_of(*s.gears[i]);
      if (!shaft) continue;
      Json given = Json::object();
      add_load(given, *shaft);
      const double speed = i == 0 ? 1.0 : ratio;
      if (given.contains("speed_rpm"))
        spec["pair"]["speed_rpm"] = given["speed_rpm"].get<double>() * speed;
      if (!given.contains("torque_Nm")) continue;
      spec["load"] = {{"torque_Nm", given["torque_Nm"].get<double>() / speed}};
      if (i == 1) spec["load"]["driver"] = 2;
    }
  }

  // Returns the spec of several stages, which are listed in the order of rexs_chain().
  Result<Json> train(std::vector<RexsLink> links) {
    auto chain = rexs_chain(model_, std::move(links));
    if (!chain) return chain.error();
    Json spec = start();
    spec["stage"] = Json::array();
    for (const RexsLink& link : *chain) {
      Json stage = Json::object();
      const bool first = spec["stage"].empty();
      if (!link.set) {
        const auto& [one, two] = link.pair.gears;
        stage["gears"] = {gear_table(*one, true), gear_table(*two, true)};
        give_usual_rack(stage["gears"][0], stage["gears"][1], *two);
        if (auto a = distance_of(link.pair)) stage["center_distance_mm"] = *a;
        if (first) add_load(stage, *shaft_of(*one));
      } else {
        auto set = set_table(*link.set);
        if (!set) return set.error();
        Json table = std::move(set).take();
        table["fixed"] = one_or_all(link.fixed);
        table["input"] = link.input;
        table["output"] = link.output;
        for (const std::string& id : link.set->bodies.at(link.input))
          if (const Component* part = model_.find(id); first && part && part->type == "shaft")
            add_load(table, *part);
        stage["planetary"] = std::move(table);
      }
      spec["stage"].push_back(std::move(stage));
    }
    return spec;
  }

  void add_load(Json& table, const Component& shaft) const {
    const Component* const load = rexs_torque(model_, shaft);
    const auto torque = load ? load->number("torque_around_u_axis") : std::nullopt;
    const auto speed = shaft.number("rotational_speed");
    if (torque) table["torque_Nm"] = std::abs(*torque);
    if (speed && rexs_drives(model_, shaft)) table["speed_rpm"] = std::abs(*speed);
  }

  Result<Json> planetary(const RexsSet& found) {
    auto set = set_table(found);
    if (!set) return set.error();
    Json spec = start();
    spec["planetary"] = std::move(set).take();
    add_ends(spec["planetary"], found);
    return spec;
  }

  // Returns the table [planetary] of a set, without the held bodies, the inputs and the output.
  Result<Json> set_table(const RexsSet& found) {
    Json set = Json::object();
    std::vector<std::pair<std::string, const Component*>> members;
    for (const std::string& name : set_member_names())
      if (const auto it = found.gears.find(name); it != found.gears.end())
        members.emplace_back(*it);
    for (const auto& [name, gear] : members) set[name] = rexs_teeth(*gear);
    set["planets"] = found.planets;
    const Component& planet = *found.gears.at("planet");
    const Json first = gear_table(planet, true);
    for (const char* key : {"normal_module_mm", "normal_pressure_angle_deg"})
      if (first.contains(key)) set[key] = first[key];
    for (const auto& [name, gear] : members) {
      const Json table = gear_table(*gear, true);
      for (const char* key : {"normal_module_mm", "normal_pressure_angle_deg"})
        if (table.value(key, 0.0) != first.value(key, 0.0))
          return no_spec(fmt::format(
              "gear {} has a different {} from gear {}, but all gears of [planetary] must have the "
              "same value; describe such a drive by [drive]",
              rexs_name(*gear),
              std::string_view(key).starts_with("normal_module") ? "module" : "pressure angle",
              rexs_name(planet)));
      for (const char* key :
           {"face_width_mm", "profile_shift", "thickness_allowance_mm", "tip_diameter_mm"})
        if (table.contains(key)) set[key][name] = table[key];
      // Programs write the helix angle of a ring with different signs. A ring has the hand of its
      // planet, so the sign of the planet is used.
      const bool stepped = name == "ring2" && found.gears.count("planet2") > 0;
      const Component& sign =
          gear->type == "ring_gear" ? *found.gears.at(stepped ? "planet2" : "planet") : *gear;
      if (const auto beta = sign.number("helix_angle_reference_diameter").value_or(0.0);
          beta != 0.0)
        set["helix_angle_deg"][name] = beta;
      if (table.contains("rack"))
        note(fmt::format("The tool of the {} is not read. The basic rack of ISO 53 replaces it.",
                         name));
    }
    for (const auto& [copy, gear] : found.copies) {
      note_differences(copy, gear);
      note_differences(flank_of(*copy), flank_of(*gear));
    }
    Json distances = Json::object();
    for (const auto& [name, mesh] : found.meshes) put(distances, name.c_str(), distance_of(mesh));
    const bool one = std::all_of(distances.begin(), distances.end(),
                                 [&](const Json& a) { return a == distances.front(); });
    if (!distances.empty()) set["center_distance_mm"] = one ? distances.front() : distances;
    return set;
  }

  // Adds a note for each number of a copy of a planet or of its mesh that differs from the first
  // copy. [planetary] describes only the first copy.
  void note_differences(const Component* copy, const Component* first) {
    if (!copy || !first) return;
    for (const auto& [attribute, text] : copy->attributes)
      if (is_rexs_number(*copy, attribute) && copy->number(attribute) != first->number(attribute))
        note(
            fmt::format("The attribute `{}` of {} (id {}) is not read, because it differs from "
                        "that of {} (id {}), but all planets of [planetary] are equal.",
                        attribute, rexs_name(*copy), copy->id, rexs_name(*first), first->id));
  }

  static Json one_or_all(Json list) { return list.size() == 1 ? list[0] : list; }

  void add_ends(Json& set, const RexsSet& found) {
    if (found.fixed)
      set["fixed"] = one_or_all(*found.fixed);
    else
      note(
          "The file does not state which member is held, so the key `fixed` has its default "
          "value.");
    if (!found.output.empty()) set["output"] = found.output;
    if (found.inputs.empty()) {
      note(
          "The file does not state which member drives, so the key `input` has its default value.");
      return;
    }
    Json names, speeds = Json::array();
    const double sense = found.inputs[0].speed_rpm.value_or(1.0) < 0.0 ? -1.0 : 1.0;
    for (const RexsEnd& end : found.inputs) {
      names.push_back(end.body);
      if (end.speed_rpm) speeds.push_back(sense * *end.speed_rpm);
    }
    set["input"] = one_or_all(names);
    if (speeds.size() == found.inputs.size()) set["speed_rpm"] = one_or_all(speeds);
    if (const auto torque = found.inputs[0].torque_Nm) set["torque_Nm"] = std::abs(*torque);
  }

  // Adds a note with the types of the components that no key of a spec describes.
  void note_the_rest() {
    std::map<std::string, int> left;
    for (const Component& c : model_.components) {
      constexpr std::array kRead{"cylindrical_gear", "ring_gear",          "cylindrical_stage",
                                 "gear_unit",        "planetary_stage",    "cylindrical_gear_flank",
                                 "flank_geometry",   "rack_shaped_tool",   "cutter_wheel_tool",
                                 "external_load",    "material",           "gear_casing",
                                 "coupling",         "switchable_coupling"};
      // A shaft only connects gears. If its speed is its only attribute, nothing is lost.
      const bool plain = c.type == "shaft" &&
                         std::all_of(c.attributes.begin(), c.attributes.end(), [](const auto& a) {
                           return a.first == "defines_speed" || a.first == "rotational_speed";
                         });
      if (!plain && !is_in(c.type, kRead)) ++left[c.type];
    }
    std::string list;
    for (const auto& [type, count] : left)
      list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", type, count);
    if (!list.empty()) note("Components that are not read: " + list + ".");
  }

  const RexsModel& model_;
  std::vector<RexsStage> stages_;
  std::vector<std::string> notes_;
};

}  // namespace

Result<RexsSpec> spec_of_rexs(const RexsModel& model) { return Reader(model).spec(); }

Result<std::string> spec_text_of_rexs(std::string_view file) {
  const auto model = read_rexs(file);
  if (!model) return model.error();
  const auto spec = spec_of_rexs(*model);
  if (!spec) return spec.error();
  std::string text = fmt::format("# This spec was read from a REXS {} file{}.\n", model->version,
                                 model->application.empty() ? "" : " of " + model->application);
  for (const std::string& n : spec->notes) text += "# " + n + "\n";
  return text + "\n" + toml_text(spec->tables);
}

}  // namespace gearwright
