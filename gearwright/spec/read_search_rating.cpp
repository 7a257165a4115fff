#include "gearwright/spec/read_search.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/judge.hpp"
#include "gearwright/base/error.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/spec/missing_for.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

namespace {

// Returns the materials in the tables of the gears, even if these tables contain no teeth. If gear
// 2 has no material, it has the material of gear 1. A gear without a material of its own or of gear
// 1 has the material of [rating].
std::array<MaterialInput, 2> read_materials(const Json& tree, const RatingTable& rating) {
  std::array<MaterialInput, 2> materials;
  bool before = false;
  for (const std::size_t i : {0, 1}) {
    const std::string gear = i == 0 ? "gear1" : "gear2";
    if (rating.material) materials[i] = *rating.material;
    if (before) materials[i] = materials[0];
    before = tree.contains(gear) && tree[gear].contains("material");
    if (before)
      materials[i] =
          read_table<MaterialInput>(material_keys(), tree[gear]["material"], gear + ".material");
  }
  return materials;
}

// Returns the key of [search] that needs a rating, or "" if there is none. The table [search] may
// be incomplete.
std::string rating_key(const Json& search) {
  for (const char* key : {"safety_flank_min", "safety_root_min"})
    if (search.contains(key)) return key;
  const Json& objective = search.contains("objective") ? search["objective"] : search;
  for (std::size_t i = 0; i < kObjectiveNames.size(); ++i) {
    const Json name = kObjectiveNames[i];
    if (needs_rating(static_cast<Objective>(i)) &&
        (objective == name || (objective.is_array() && is_in(name, objective))))
      return "objective";
  }
  return "";
}

constexpr const char* kNeedsRating =
    "needs the tables [rating] and [gear1.material]; for example, [rating] with torque_Nm = 50 (or "
    "power_kW, or output_torque_Nm on gear 2), speed_rpm = 1500 and quality = 6, and "
    "[gear1.material] with name = \"16MnCr5\"";

// Returns the first of the keys that is in the table.
std::string given_of(const TableReader& t, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (t.given(key)) return key;
  return {};
}

void check_faces(const TableReader& t, const SearchProblem& p) {
  if (!p.sizes_faces()) return;
  const std::string key =
      given_of(t, {"face_width_mm", "face_width_modules", "face_width_diameters"});
  require_parallel(t, p, key,
                   "must be a single number on crossed axes, because a search chooses face widths "
                   "only on parallel axes");
  if (p.shift_step)
    t.fail(key,
           "must be a single number if shift_step is given, because the points of its grid are not "
           "rated");
  if (!p.limits.safety_flank && !p.limits.safety_root && !p.limits.overlap_ratio)
    t.fail(key,
           "is a band, from which each design takes the least width that satisfies the limits; "
           "also give safety_flank_min, safety_root_min or overlap_ratio_min, or replace the band "
           "by a single width");
}

}  // namespace

void lend_face_load(Json& tree) {
  if (!tree.contains("search") || !tree.contains("rating") || !tree["rating"].is_object()) return;
  // If the spec also describes a complete pair, the rating of this pair has no default factor.
  if (tree.contains("gear1") && tree["gear1"].contains("teeth")) return;
  Json& rating = tree["rating"];
  const bool plastic = rating.value("standard", Json()) == "VDI 2736:2014";
  if (plastic || rating.contains("face_load_factor") || rating.contains("mounting")) return;
  rating["face_load_factor"] = kSearchFaceLoad;
  rating["face_load_factor_assumed"] = true;
}

bool has_default_face_load(const JobSpec& spec) {
  return spec.rating.input.face_load_factor && !spec.given.contains("rating.face_load_factor");
}

bool wants_rating(const SearchProblem& problem, const RatingTable& rating) {
  const bool by_rating =
      std::any_of(problem.objectives.begin(), problem.objectives.end(), needs_rating);
  const bool by_mass = problem.ranks_by(Objective::mass) || problem.ranks_by(Objective::cost);
  return problem.limits.safety_flank || problem.limits.safety_root || by_rating ||
         (rating.given && by_mass);
}

void read_search_rating(const Json& tree, JobSpec& spec) {
  const RatingTable& rating = spec.rating;
  // If gear 2 takes its material from gear 1, the error names the table of gear 1.
  const std::array<std::string, 2> tables{material_table(spec, 1), material_table(spec, 2)};
  const auto check = [&](const std::array<MaterialInput, 2>& given) {
    const std::vector<Error> missing = missing_for_rating(rating, given, tables);
    if (!missing.empty()) throw SpecError{all_missing(missing), missing};
  };
  if (!spec.search) {
    const std::string by = rating_key(tree["search"]);
    if (by.empty()) return;
    if (rating.given) check(read_materials(tree, rating));
    const Error table = absent_input("rating", "; search." + by + " " + kNeedsRating);
    if (!rating.given) throw SpecError{table, {table}};
    return;
  }
  SearchProblem& problem = *spec.search;
  problem.rating_unused = rating.given && !wants_rating(problem, rating);
  if (!wants_rating(problem, rating) && !problem.weighs()) return;
  const std::array<MaterialInput, 2> given = read_materials(tree, rating);
  for (const std::size_t i : {0, 1}) {
    const auto density = density_of(given[i]);
    if (density) problem.density[i] = *density;
    if (!density && given[i].kind == MaterialKind::plastic && problem.weighs()) {
      const Error error = absent_input(tables[i] + ".density_kg_per_m3",
                                       "; the mass of a plastic gear needs its density");
      throw SpecError{error, {error}};
    }
  }
  if (!wants_rating(problem, rating)) return;

  const TableReader t(search_keys(), tree["search"], "search");
  const char* by = problem.limits.safety_flank  ? "safety_flank_min"
                   : problem.limits.safety_root ? "safety_root_min"
                                                : "objective";
  require_parallel(t, problem, by,
                   "cannot be combined with shaft_angle_deg, because ISO 6336 rates gears on "
                   "parallel axes");
  if (!rating.given) t.fail(by, kNeedsRating);
  if (problem.ranks_by(Objective::noise) && rating.input.edition == RatingEdition::vdi_2736)
    t.fail("objective",
           "noise is not available with standard = \"VDI 2736:2014\", which has no mesh stiffness");
  if (!rating.spectrum.empty()) {
    t.fail(by,
           "cannot be combined with [[rating.spectrum]], which a search does not support; give one "
           "equivalent load by torque_Nm and life_h");
  }
  if (problem.shift_step)
    t.fail(by,
           "cannot be combined with shift_step, because the points of its grid are not rated; "
           "leave out one of the two");
  SearchRating wanted;
  wanted.input = rating.input;
  wanted.power_kW = rating.power;
  if (spec.load.driver != 2) wanted.output_torque = rating.output_torque;
  if (rating.web_thickness) {
    wanted.web = rating.web_thickness;
    wanted.rim = rating.rim_thickness;
  }
  check(given);
  for (const std::size_t i : {0, 1}) {
    auto material = material_of(given[i], tables[i], rating.input.edition);
    if (!material) throw SpecError{spelled(material.error())};
    wanted.input.materials[i] = std::move(material).take();
  }
  SearchLimits& limits = problem.limits;
  if (!limits.safety_flank) limits.safety_flank = rating.safety_flank_min;
  if (!limits.safety_root) limits.safety_root = rating.safety_root_min;
  problem.rating = std::move(wanted);
}

void read_search_drawing(const Json& search, SearchProblem& p) {
  const TableReader t(search_keys(), search, "search");
  const bool wide = p.face_width || p.face_modules || p.face_diameters;
  const bool safe = p.limits.safety_flank || p.limits.safety_root;
  if (safe && !wide && !p.crossed() && !p.shift_step) p.face_diameters = kUsualFace;
  SearchAllowances& allowances = p.allowances;
  const bool no_allowances = allowances.series == kNoAllowances;
  if (no_allowances) allowances.series.clear();
  check_faces(t, p);
  const std::string tolerance =
      given_of(t, {"thickness_series", "backlash_mm", "center_distance_tolerance"});
  const bool toleranced = allowances.thin_teeth() || allowances.distance_tolerance;
  if (toleranced)
    require_parallel(t, p, tolerance,
                     "is not available on crossed axes; add this key to the pair that --take "
                     "writes");
  if (toleranced && p.shift_step)
    t.fail(tolerance,
           "cannot be combined with shift_step, because no drawing is made for the points of its "
           "grid");
  if (toleranced && !p.limits.avoid_interference)
    t.fail(tolerance,
           "needs interference = \"exclude\", because a drawing is made only for designs that run");
  // The designs have nominal teeth if `mounting` is given without tolerances and without a band of
  // face widths. The value thickness_series = "none" also counts as a tolerance here.
  const bool nominal = t.given("mounting") && !toleranced && !no_allowances && !p.has_face_band();
  const bool drawn = !nominal && !p.crossed() && !p.shift_step && p.limits.avoid_interference;
  if (drawn && !t.given("mounting")) p.mounting = Mounting::tight;
  if (p.shorten_tips && !p.tight()) {
    t.fail("shorten_tips",
           "needs mounting = \"tight\" on parallel axes, because the extended centre distance does "
           "not reduce the tip clearance");
  }
  if (!drawn) return;
  const bool backlash_is_made = allowances.thin_teeth() || p.mounting == Mounting::extended;
  if (!backlash_is_made && !no_allowances) allowances.series = kUsualSeries;
  SearchLimits& limits = p.limits;
  if (!t.given("profile_shift")) {
    limits.min_shift = -kDrawnShift;
    limits.max_shift = kDrawnShift;
  }
  if (!t.given("sliding_max")) limits.sliding = kDrawnSliding;
  if (!t.given("tip_clearance_min")) limits.tip_clearance = kMarginTip;
  p.draw = judge_drawing;
}

}  // namespace gearwright
