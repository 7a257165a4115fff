#include "gearwright/design/design_strength.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "gearwright/design/design_objectives.hpp"
#include "gearwright/design/face_width.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

namespace {

double tip_diameter(const ShiftGraph& graph, const DesignRow& row, std::size_t i) {
  const TrialGear& g = graph.gears()[i];
  const double m = row.trial.module;
  return 2 * m * std::abs(leaf::tip_radius(g.r, g.addendum, row.shift[i], row.tip_alteration / m));
}

double root_diameter(const ShiftGraph& graph, const DesignRow& row, std::size_t i) {
  const TrialGear& g = graph.gears()[i];
  return 2 * row.trial.module * std::abs(g.r - g.dedendum + row.cut_shift(i, graph.problem()));
}

// True if the tip of the mating gear touches only the involute of gear i, which is the part of the
// flank that the straight flank of the rack cuts.
bool is_on_straight_flank(const ShiftGraph& graph, const DesignRow& row, std::size_t i) {
  const TrialGear& g = graph.gears()[i];
  const auto& clearance = row.form_clearance[i];
  if (!clearance || *clearance < 0.0) return false;
  const double undercut = leaf::undercut_limit<double>(g.flank_depth, g.teeth, g.sin_transverse,
                                                       std::cos(graph.trial().helix[i].rad()));
  return row.cut_shift(i, graph.problem()) >= undercut && row.tip_thickness[i] >= 0.0;
}

// Returns the cut of the internal gear. The result is absent if the pair has no closed form. This
// is the case if the tip of the pinion reaches the fillet, if the tips are shortened, if the
// internal gear has an allowance, or if the problem has no store of cuts.
std::optional<RingCut> cut_off_fillet(const ShiftGraph& graph, const DesignRow& row) {
  const auto& rating = graph.problem().rating;
  if (!rating || !rating->ring_cuts || row.tip_alteration != 0.0 || row.allowance[1] != 0.0)
    return std::nullopt;
  const auto cut = rating->ring_cuts->of(graph.problem(), row.trial, row.shift[1]);
  if (!cut) return std::nullopt;
  const auto& [pinion, wheel] = graph.gears();
  const double tip = leaf::curvature_at(
      leaf::tip_radius(pinion.r, pinion.addendum, row.shift[0], 0.0), pinion.r_b);
  const double N = std::abs(graph.place(row.shift[0] + row.shift[1]).N);
  const double end = leaf::curvature_at(cut->form_radius, std::abs(wheel.r_b));
  return N + tip <= end ? cut : std::nullopt;
}

RatedPair pair_on_straight_flanks(const ShiftGraph& graph, const DesignRow& row,
                                  const std::optional<RingCut>& cut) {
  const SearchProblem& problem = graph.problem();
  const Trial& t = row.trial;
  const double m = t.module;
  RatedPair r;
  r.normal_module = m;
  r.alpha_n = problem.normal_pressure_angle.rad();
  r.beta = std::abs(t.helix[0].rad());
  r.center_distance = row.center_distance;
  r.face_width = row.face_width;
  const std::array<int, 2> teeth{t.z1, t.z2};
  double sum = 0.0;
  for (const std::size_t i : {0, 1}) {
    const auto reference = reference_geometry(ReferenceInput<double>{
        teeth[i], m, r.alpha_n, t.helix[i].rad(), row.shift[i], row.allowance[i]});
    if (i == 0) {
      r.alpha_t = reference.transverse_pressure_angle;
      r.beta_b = std::abs(reference.base_helix_angle);
    }
    const double side = side_of(teeth[i]);
    sum += side * reference.base_diameter / 2;
    const StraightRack rack = rack_of(problem, t, i);
    RatedGear& g = r.gears[i];
    g.teeth = teeth[i];
    g.reference_diameter = reference.reference_diameter;
    g.base_diameter = reference.base_diameter;
    g.tip_form_diameter = tip_diameter(graph, row, i);
    g.tip_diameter = g.tip_form_diameter;  // the whole tip touches the mating flank
    g.root_diameter = root_diameter(graph, row, i);
    g.tooth_height = std::abs(g.tip_diameter - g.root_diameter) / 2;
    g.profile_shift = row.shift[i];
    g.generating_shift = reference.generating_profile_shift;
    g.virtual_teeth = virtual_teeth(g.teeth, r.beta, r.beta_b);
    g.face_width = r.face_width;
    g.tool.addendum = rack.addendum;
    g.tool.dedendum = rack.dedendum;
    g.tool.fillet =
        std::min(rack.root_fillet_radius, full_radius(rack, problem.normal_pressure_angle));
    if (cut && i == 1) {
      g.tool.cutter_teeth = cut->cutter_teeth;
      g.tool.fillet = std::min(g.tool.fillet, cut->tip_rounding);
      g.bore = default_rim(g.root_diameter, m);
    }
  }
  r.alpha_wt = std::acos(std::min(1.0, std::abs(sum) / r.center_distance));
  r.u = static_cast<double>(t.z2) / t.z1;
  r.epsilon_alpha = row.contact_ratio;
  r.epsilon_beta = r.face_width * std::sin(r.beta) / (std::numbers::pi * m);
  return r;
}

}  // namespace

Result<RatedPair> mounted_design(const ShiftGraph& graph, const DesignRow& row) {
  const SearchProblem& problem = graph.problem();
  const Trial& t = row.trial;
  std::array<std::optional<Gear>, 2> gears;
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.teeth = i == 0 ? t.z1 : t.z2;
    spec.normal_module = t.module;
    spec.normal_pressure_angle = problem.normal_pressure_angle;
    spec.helix_angle = t.helix[i];
    spec.profile_shift = row.shift[i];
    spec.thickness_allowance = row.allowance[i];
    spec.face_width = row.face_width;
    if (row.tip_alteration != 0.0) spec.tip_diameter = tip_diameter(graph, row, i);
    spec.rack = rack_of(problem, t, i);
    auto gear = make_gear_with_default_cutter(spec);
    if (!gear) return gear.error();
    gears[i] = std::move(gear).take();
  }
  const auto pair = mount(*std::move(gears[0]), *std::move(gears[1]),
                          PairSpec{.center_distance = row.center_distance});
  if (!pair) return pair.error();
  return rated_pair(*pair);
}

Result<RatedPair> pair_of_design(const ShiftGraph& graph, const DesignRow& row) {
  std::optional<RingCut> cut;
  bool straight = is_on_straight_flank(graph, row, 0);
  if (straight && row.trial.z2 < 0) {
    cut = cut_off_fillet(graph, row);
    straight = cut.has_value();
  } else if (straight) {
    straight = is_on_straight_flank(graph, row, 1);
  }
  return straight ? pair_on_straight_flanks(graph, row, cut) : mounted_design(graph, row);
}

namespace {

void set_face_width(const ShiftGraph& graph, DesignRow& row, double width) {
  row.overlap_ratio *= width / row.face_width;
  row.face_width = width;
  row.mass = mass_of(graph, row);
}

struct LeastSafeties {
  std::array<std::optional<double>, 2> flank{}, root{};
  std::optional<double> deflection{};  // µm, teeth under the rated torque
};

// Returns the safety factors for one state of the teeth. A state is the nominal design, or the pair
// at one combination of the limits of the tolerances. `input` contains the gear body of the nominal
// design.
LeastSafeties safeties_of(const RatedPair& pair, const RatingInput& input) {
  const auto rating = rate(pair, input);
  if (!rating) return {};
  // Far outside the limits of the standard, a factor may have no value.
  const auto number = [](const Factor& f) {
    return std::isfinite(f.value) ? std::optional(f.value) : std::nullopt;
  };
  LeastSafeties found;
  for (const std::size_t i : {0, 1}) {
    found.flank[i] = number(rating->S_H[i]);
    found.root[i] = number(rating->S_F[i]);
  }
  found.deflection = mean_deflection(pair, *rating);
  return found;
}

// Returns the smallest ratio of a safety factor to its limit, or 0 if a safety factor has no value.
// If drawings are checked, a limit that is not given is 1, because the verdict requires safety
// factors of at least 1.
double share_of(const SearchProblem& problem, const LeastSafeties& found) {
  double share = std::numeric_limits<double>::infinity();
  const auto keep = [&](const std::optional<double>& safety, std::optional<double> least) {
    if (!least && problem.draw) least = 1.0;
    if (least) share = std::min(share, safety ? *safety / *least : 0.0);
  };
  for (const std::size_t i : {0, 1}) {
    keep(found.flank[i], problem.limits.safety_flank);
    keep(found.root[i], problem.limits.safety_root);
  }
  return share;
}

// Returns the smallest ratio of a safety factor to its limit over all states of the teeth, for the
// face width of the row. The function stores the safety factors of the first state in the row.
double required_share(const SearchProblem& problem, const std::vector<RatedPair>& states,
                      DesignRow& row) {
  const SearchRating& asked = *problem.rating;
  RatingInput input = asked.input_of(row.trial.z1, row.trial.z2);
  double share = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < states.size(); ++k) {
    const RatedPair wide = with_face_width(states[k], row.face_width);
    if (k == 0 && asked.web) input.body = rated_body(wide, *asked.web, *asked.rim);
    const LeastSafeties found = safeties_of(wide, input);
    if (k == 0) {
      row.flank_safety = found.flank;
      row.root_safety = found.root;
      row.noise = noise_of(row, found.deflection);
    }
    share = std::min(share, share_of(problem, found));
  }
  return share;
}

// Sets the smallest face width of the band that gives sufficient safety factors in all states of
// the teeth. If no width is sufficient, sets the greatest width. Safety factors grow with at most
// the fourth power of the width (rating/sizing.cpp), so the search skips widths that are certainly
// insufficient. The row gets the safety factors of the first state, which is the nominal design.
void size_face(const ShiftGraph& graph, const std::vector<RatedPair>& states, DesignRow& row) {
  constexpr double kPower = 4.0;
  const SearchProblem& problem = graph.problem();
  for (;;) {
    const double share = required_share(problem, states, row);
    if (share >= 1.0 || !problem.sizes_faces()) return;
    const double most = face_widths(problem, row.trial)[1];
    if (row.face_width >= most) return;
    const double width = share > 0.0 ? row.face_width * std::pow(share, -1 / kPower) : 0.0;
    const auto next = next_face_width(problem, row.trial, row.face_width, width);
    set_face_width(graph, row, next.value_or(most));
  }
}

}  // namespace

DesignRow rated(const ShiftGraph& graph, DesignRow row) {
  const SearchProblem& problem = graph.problem();
  std::vector<RatedPair> states;
  if (problem.rating) {
    auto made = pair_of_design(graph, row);
    if (!made) return row;
    states.push_back(std::move(made).take());
    size_face(graph, states, row);
  }
  while (problem.draw && !short_of(problem, row)) {
    DrawnDesign drawn = problem.draw(problem, row);
    row.runs = drawn.runs;
    row.finding = drawn.finding;
    if (drawn.backlash) row.backlash_ends = {(*drawn.backlash)[0], (*drawn.backlash)[1]};
    const auto wider = next_face_width(problem, row.trial, row.face_width, row.face_width);
    if (drawn.runs || drawn.at_ends.empty() || !wider) break;
    // If the safety factors are too low at some limits of the tolerances, the face width is chosen
    // once more. The states at all limits of the tolerances are then taken into account, too.
    states.resize(1);
    std::move(drawn.at_ends.begin(), drawn.at_ends.end(), std::back_inserter(states));
    set_face_width(graph, row, *wider);
    size_face(graph, states, row);
    row.runs = true;
    row.finding.reset();
  }
  return row;
}

std::optional<Limit> short_of(const SearchProblem& problem, const DesignRow& row) {
  // A safety factor without a value does not meet its limit.
  const auto holds = [&](const auto& safeties, const std::optional<double>& least) {
    return !problem.rating || !least ||
           std::all_of(safeties.begin(), safeties.end(),
                       [&](const auto& s) { return s && *s >= *least; });
  };
  if (!holds(row.flank_safety, problem.limits.safety_flank)) return Limit::safety_flank;
  if (!holds(row.root_safety, problem.limits.safety_root)) return Limit::safety_root;
  return row.runs ? std::nullopt : std::optional(Limit::verdict);
}

std::optional<double> least_safety(const SearchProblem& problem, const DesignRow& row) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : {0, 1}) {
    if (!row.flank_safety[i] || !row.root_safety[i]) return std::nullopt;
    least = std::min({least, *row.flank_safety[i] / problem.limits.safety_flank.value_or(1.0),
                      *row.root_safety[i] / problem.limits.safety_root.value_or(1.0)});
  }
  return least;
}

double GearBody::mass() const {
  const double d_m = (tip_diameter + root_diameter) / 2;
  const double outside = root_diameter + 5 * normal_module;
  const double area = teeth > 0 ? d_m * d_m : outside * outside - d_m * d_m;
  return density * face_width * std::numbers::pi / 4 * area;
}

double mass_of(const ShiftGraph& graph, const DesignRow& row) {
  double mass = 0.0;
  for (const std::size_t i : {0, 1})
    mass += GearBody{graph.problem().density[i],   row.face_width,
                     graph.gears()[i].teeth,       tip_diameter(graph, row, i),
                     root_diameter(graph, row, i), row.trial.module}
                .mass();
  return mass;
}

namespace {

// Chooses the cutter for module 1. Every length is proportional to the module.
std::optional<RingCut> cut_of(const SearchProblem& problem, const Trial& trial, double shift) {
  CylindricalSpec spec;
  spec.teeth = trial.z2;
  spec.normal_module = 1.0;
  spec.normal_pressure_angle = problem.normal_pressure_angle;
  spec.helix_angle = trial.helix[1];
  spec.profile_shift = shift;
  spec.face_width = kFaceModules;  // has no effect on the tooth
  spec.rack = rack_of(problem, trial, 1);
  const auto ring = make_gear(spec);
  if (!ring) return std::nullopt;
  const auto cut = cut_by_default(*ring);
  if (!cut) return RingCut{};
  return RingCut{cut->cut_by->cutter_teeth, *cut->tooth->form_radius, cut->cut_by->tip_rounding};
}

}  // namespace

std::optional<RingCut> RingCuts::of(const SearchProblem& problem, const Trial& trial,
                                    double shift) {
  const StraightRack rack = rack_of(problem, trial, 1);
  const Key key{trial.z2,      shift,         trial.helix[1],         problem.normal_pressure_angle,
                rack.addendum, rack.dedendum, rack.root_fillet_radius};
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = cuts_.find(key); found != cuts_.end()) return found->second;
  }
  const auto cut = cut_of(problem, trial, shift);
  const std::lock_guard lock(mutex_);
  constexpr std::size_t kMost = 1 << 16;  // limits the memory for stored cuts to a few megabytes
  if (cuts_.size() >= kMost) cuts_.clear();
  cuts_.emplace(key, cut);
  return cut;
}

std::size_t RingCuts::size() const {
  const std::lock_guard lock(mutex_);
  return cuts_.size();
}

}  // namespace gearwright
