#include "gearwright/spec/read_search_rating.hpp"

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/spec/missing_for_rating.hpp"
#include "gearwright/spec/read_rating.hpp"

namespace gearwright {

namespace {

// Of a gear's table, with teeth or without; gear 2 without one is of what gear 1 is of.
std::array<MaterialInput, 2> read_materials(const Json& tree) {
  std::array<MaterialInput, 2> materials;
  for (const std::size_t i : {0, 1}) {
    const std::string gear = i == 0 ? "gear1" : "gear2";
    const bool said = tree.contains(gear) && tree[gear].contains("material");
    if (said) materials[i] = read_material(tree[gear]["material"], gear + ".material");
    if (!said && i == 1) materials[1] = materials[0];
  }
  return materials;
}

}  // namespace

bool wants_rating(const SearchProblem& problem, const RatingTable& rating) {
  return problem.limits.safety_flank || problem.limits.safety_root ||
         problem.ranks_by(Objective::safety) || (rating.given && problem.ranks_by(Objective::mass));
}

void read_search_rating(const Json& tree, const RatingTable& rating, SearchProblem& problem) {
  if (!wants_rating(problem, rating) && !problem.weighs()) return;
  const std::array<MaterialInput, 2> given = read_materials(tree);
  constexpr double kPerCubicMillimetre = 1e-9;
  for (const std::size_t i : {0, 1}) {
    const auto row = given[i].name ? material_named(*given[i].name) : std::nullopt;
    if (row) problem.density[i] = row->density;
    if (given[i].density) problem.density[i] = *given[i].density * kPerCubicMillimetre;
  }
  if (!wants_rating(problem, rating)) return;

  const TableReader t(search_keys(), tree["search"], "search");
  const char* asked = problem.limits.safety_flank  ? "safety_flank_min"
                      : problem.limits.safety_root ? "safety_root_min"
                                                   : "objective";
  if (problem.crossed())
    t.fail(asked, "has no place beside shaft_angle_deg: ISO 6336 rates gears on parallel axes");
  if (!rating.given) {
    t.fail(asked,
           "needs a table [rating] with the load, power_kW or torque_Nm, speed_rpm, quality and "
           "face_load_factor or [rating.mounting], and [gear1.material]");
  }
  if (!rating.spectrum.empty()) {
    t.fail(asked,
           "has no place beside [[rating.spectrum]], which a search does not go through: give one "
           "load that stands for it, torque_Nm with life_h");
  }
  if (problem.shift_step)
    t.fail(asked, "has no place beside shift_step, whose points are not rated; leave one out");
  SearchRating wanted;
  wanted.input = rating.input;
  wanted.power_kW = rating.power;
  if (rating.web_thickness) {
    wanted.web = rating.web_thickness;
    wanted.rim = rating.rim_thickness;
  }
  // What gear 2 has from gear 1 is named where it stands.
  const bool own = tree.contains("gear2") && tree["gear2"].contains("material");
  const std::array<int, 2> named{1, own ? 2 : 1};
  if (const auto missing = missing_for_rating(rating, given, named)) throw SpecError{*missing};
  for (const std::size_t i : {0, 1}) {
    auto material = material_of(given[i], named[i], rating.input.edition);
    if (!material) throw SpecError{spelled(material.error())};
    problem.density[i] = material->density;
    wanted.input.materials[i] = std::move(material).take();
  }
  SearchLimits& limits = problem.limits;
  if (!limits.safety_flank) limits.safety_flank = rating.safety_flank_min;
  if (!limits.safety_root) limits.safety_root = rating.safety_root_min;
  problem.rating = std::move(wanted);
}

}  // namespace gearwright
