#include "gearwright/arrange/design_drawing.hpp"

#include "gearwright/arrange/judge.hpp"

namespace gearwright {

namespace {

struct RatedDrawing {
  RatedPair pair;
  RatingInput input;
  Rating rating;
  WantedSafety wanted;
};

std::optional<RatedDrawing> rate_drawing(const SearchProblem& problem, const Arranged& arranged) {
  const SearchRating& asked = *problem.rating;
  const auto pair = rated_pair(*arranged.pair);
  if (!pair) return std::nullopt;
  RatedDrawing rated{*pair, asked.input, {}, {}};
  if (asked.web) rated.input.body = rated_body(*pair, *asked.web, *asked.rim);
  auto rating = rate(rated.pair, rated.input);
  if (!rating) return std::nullopt;
  rated.rating = std::move(rating).take();
  rated.wanted = {problem.limits.safety_flank.value_or(1.0),
                  problem.limits.safety_root.value_or(1.0)};
  return rated;
}

double normal_backlash(const Arranged& arranged) {
  return arranged.pair->involute()->mesh.backlash.normal;
}

}  // namespace

GivenPair drawing_of(const SearchProblem& problem, const DesignRow& row) {
  GivenPair given;
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.teeth = i == 0 ? row.trial.z1 : row.trial.z2;
    spec.normal_module = row.trial.module;
    spec.normal_pressure_angle = problem.normal_pressure_angle;
    spec.helix_angle = row.trial.helix[i];
    spec.profile_shift = row.shift[i];
    spec.face_width = row.face_width;
    spec.rack = rack_of(problem, row.trial, i);
    given.gears[i] = GearInput::of(spec);
    if (!problem.allowances.series.empty())
      given.gears[i]->tolerance.series = problem.allowances.series;
  }
  PairInput& pair = given.pair;
  pair.center_distance = row.center_distance;
  pair.shaft_angle = problem.shaft_angle;
  pair.mounting = problem.mounting;
  pair.shorten_tips = problem.shorten_tips;
  pair.distance_tolerance = problem.allowances.distance_tolerance;
  if (const auto& ends = problem.allowances.backlash) {
    pair.backlash = ((*ends)[0] + (*ends)[1]) / 2;
    if ((*ends)[0] < (*ends)[1]) pair.backlash_ends = *ends;
  }
  return given;
}

DrawnDesign judge_drawing(const SearchProblem& problem, const DesignRow& row) {
  auto made = arrange(drawing_of(problem, row), Scope::pair);
  if (!made) return {};
  Arranged arranged = std::move(made).take();
  DrawnDesign drawn;
  if (arranged.ends)
    drawn.backlash = {normal_backlash(arranged.ends->upper), normal_backlash(arranged.ends->lower)};
  JudgedWith with;
  std::optional<RatedDrawing> rated;
  if (problem.rating) {
    rated = rate_drawing(problem, arranged);
    if (!rated) return drawn;
    with.rating = JudgedRating{&rated->pair, &rated->input, &rated->rating, rated->wanted};
    for (const Warning& limit : rated->rating.limits) arranged.warnings.push_back(limit);
  }
  drawn.runs = true;
  bool wider_helps = problem.sizes_faces();
  visit_states(arranged, with, [&](const JudgedState& state) {
    for (const Finding& finding : state.findings) {
      if (finding.level == Level::green || finding.code == WarningCode::rating_plastic) continue;
      drawn.runs = false;
      const bool safety =
          finding.code == WarningCode::flank_safety || finding.code == WarningCode::root_safety;
      wider_helps = wider_helps && safety;
    }
    if (state.pair) drawn.at_ends.push_back(*state.pair);
    return drawn.runs || wider_helps;
  });
  if (drawn.runs || !wider_helps) drawn.at_ends.clear();
  return drawn;
}

}  // namespace gearwright
