#include "gearwright/spec/missing_for.hpp"

#include <algorithm>
#include <variant>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/rating/rating.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

namespace {

void add(std::vector<Error>& list, std::vector<Error> more) {
  list.insert(list.end(), more.begin(), more.end());
}

std::vector<Error> missing_for_rating(const JobSpec& spec) {
  std::vector<Error> missing;
  if (!spec.rating.given)
    missing.push_back(absent_input("rating",
                                   "; a rating needs this table, which describes the load, the "
                                   "accuracy of the gears and their mounting"));
  std::array<MaterialInput, 2> materials;
  std::array<std::string, 2> tables;
  for (const std::size_t i : {0, 1}) {
    tables[i] = material_table(spec, static_cast<int>(i) + 1);
    if (spec.rating.material) materials[i] = *spec.rating.material;
    if (spec.gears[i]) materials[i] = spec.gears[i]->material;
  }
  const int halves = spec.has(1) && spec.gear(1).double_helical ? 2 : 1;
  add(missing, missing_for_rating(spec.rating, materials, tables, halves));
  const auto given = [&](const char* key) { return spec.given.contains(key); };
  if (spec.rating.input.face_load_computed && !given("gear1.shaft") && !given("gear2.shaft") &&
      !given("load.deflection_slope_um") && !given("load.deflection_bow_um"))
    missing.push_back(absent_input(
        "gear1.shaft",
        "; face_load_factor = \"computed\" needs the deflection of the shafts. Give a shaft with "
        "its bearings in [gear1.shaft] or [gear2.shaft], or give deflection_slope_um in [load], "
        "which is 0 for rigid shafts"));
  std::erase_if(missing, [&](const Error& e) {
    // If other data of a gear are missing, the material of the gear was not read. If the spec gives
    // this material, it must not be reported as missing.
    const bool of_material = e.field == tables[0] || e.field == tables[1];
    return of_material && spec.given.contains(e.field);
  });
  return missing;
}

constexpr std::array<std::string_view, 4> kTolerances{"scatter.errors.", "scatter.bearings.",
                                                      "scatter.gear1.", "scatter.gear2."};

bool any_tolerance(const JobSpec& spec) {
  const ScatterInput& s = spec.scatter;
  const auto graded = [](const auto& gear) { return gear && gear->tolerance.quality; };
  if (s.quality || std::any_of(spec.gears.begin(), spec.gears.end(), graded)) return true;
  const auto thin = [](const auto& gear) {
    return gear && (gear->allowance_ends || gear->tolerance.says_thickness());
  };
  const PairInput& pair = spec.pair;
  if (s.given && (pair.distance_tolerance || pair.distance_deviations || pair.backlash_ends ||
                  std::any_of(spec.gears.begin(), spec.gears.end(), thin)))
    return true;
  const auto given = [](const auto& tolerance) { return tolerance.has_value(); };
  const auto of_gear = [&](const ScatterGear& gear) {
    return gear.thickness || gear.pitch || gear.profile_waves || gear.helix_waves ||
           std::any_of(gear.modifications.begin(), gear.modifications.end(), given);
  };
  return s.bearings || std::any_of(s.errors.begin(), s.errors.end(), given) ||
         std::any_of(s.gears.begin(), s.gears.end(), of_gear);
}

// True if a table of [scatter] has a key, so that the error about this table is the only one.
bool begins_tolerances(const JobSpec& spec) {
  return std::any_of(spec.given.begin(), spec.given.end(), [](const std::string& key) {
    return std::any_of(kTolerances.begin(), kTolerances.end(),
                       [&](std::string_view table) { return key.starts_with(table); });
  });
}

// False for circular-arc gears and for crossed axes. For such gears, no missing inputs of a rating
// are reported, because the rating rejects them with the reason.
bool can_be_rated(const JobSpec& spec) {
  const bool crossed = spec.pair.shaft_angle && spec.pair.shaft_angle->rad() != 0.0;
  return !crossed && std::none_of(spec.gears.begin(), spec.gears.end(), [](const auto& gear) {
    return gear && !std::holds_alternative<StraightRack>(gear->cylindrical.rack);
  });
}

}  // namespace

std::string material_table(const JobSpec& spec, int which) {
  for (const std::string& table :
       {gear_field(which, "material"), gear_field(1, "material"), std::string("rating.material")})
    if (spec.given.contains(table)) return table;
  return gear_field(1, "material");
}

std::vector<Error> missing_for_rating(const RatingTable& rating,
                                      const std::array<MaterialInput, 2>& materials,
                                      const std::array<std::string, 2>& tables, int halves) {
  std::vector<Error> missing;
  if (!rating.torque && !rating.power && !rating.output_torque) {
    missing.push_back(absent_input(
        "rating.torque_Nm",
        "; a rating needs a load. Give power_kW with speed_rpm, torque_Nm on gear 1, for example "
        "torque_Nm = 50, or output_torque_Nm on gear 2"));
  }
  RatingInput input = rating.input;
  if (input.face_load_computed) input.face_load_factor = 1.0;  // replaced by the computed value
  bool known = true;
  for (const std::size_t i : {0, 1}) {
    const auto material = material_of(materials[i], tables[i], input.edition);
    known = known && material;
    if (material) {
      input.materials[i] = *material;
    } else {
      missing.push_back(spelled(material.error()));
    }
  }
  // Inputs of VDI 2736 depend on the materials, so they are listed only if the materials are known.
  if (known || input.edition != RatingEdition::vdi_2736)
    for (const Error& error : missing_inputs(input, halves)) missing.push_back(spelled(error));
  return missing;
}

std::vector<Error> missing_for(SpecUse use, const JobSpec& spec) {
  // If gear 2 is a rack, nothing is reported as missing. A verb that does not support racks rejects
  // the spec with the reason.
  if (spec.rack) return {};
  std::vector<Error> missing;
  const auto unknown = [&](int which) { return spec.measured[which - 1] && !spec.has(which); };
  if (spec.search || spec.given.contains("search") || unknown(1) || unknown(2) || spec.drive)
    return missing;
  const bool two = spec.given.contains("gear2");
  const bool torque = !spec.load.torques.empty() || !spec.load.output_torques.empty();
  const bool probes_alone = use == SpecUse::load && !torque && !spec.load.probes.empty();
  const bool of_two = use != SpecUse::geometry && use != SpecUse::run && !probes_alone;
  const bool rating_torque = spec.rating.torque || spec.rating.power || spec.rating.output_torque;
  if (use == SpecUse::propose && !torque && !rating_torque)
    missing.push_back(absent_input("load.torque_Nm",
                                   ": enter a torque on gear 1 in N m, for example torque_Nm = "
                                   "100, or give power_kW and speed_rpm in [rating]"));
  const bool under_torque =
      (use == SpecUse::load && !probes_alone && !rating_torque) ||
      ((use == SpecUse::compensate || (use == SpecUse::run && spec.compensate.given && two)) &&
       under_load(spec.compensate.aim));
  const bool rated = can_be_rated(spec) &&
                     (use == SpecUse::rate || (use == SpecUse::run && spec.rating.given && two));
  if (of_two && !two)
    missing.push_back(
        absent_input("gear2", "; a pair needs a second gear, for example [gear2] with teeth = 40"));
  if (under_torque && !torque)
    missing.push_back(absent_input(
        "load.torque_Nm", "; give a torque on gear 1 in N m, for example torque_Nm = 100"));
  if (use == SpecUse::scatter && !any_tolerance(spec) && !begins_tolerances(spec))
    missing.push_back(absent_input(
        "scatter.errors",
        "; the command `gearwright scatter` needs a range for at least one number. Give "
        "crossing_deg = [-0.02, 0.02] in [scatter.errors], for example. Other possibilities are "
        "span_mm and radius_mm in [scatter.bearings], thickness_allowance_mm = [-0.02, 0.02] or "
        "modifications in [scatter.gear1], and a grade (quality = 6). A table [scatter] without "
        "ranges is sufficient if another table has a tolerance, such as "
        "center_distance_tolerance = \"JS7\" in [pair]"));
  if (rated) add(missing, missing_for_rating(spec));
  return missing;
}

std::optional<Error> missing_error(SpecUse use, const JobSpec& spec) {
  const std::vector<Error> missing = missing_for(use, spec);
  return missing.empty() ? std::nullopt : std::optional(all_missing(missing));
}

}  // namespace gearwright
