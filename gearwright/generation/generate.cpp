#include "gearwright/generation/generate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/generation/branch.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

using detail::Branch;
using detail::branch_of;

void add_branches(std::vector<Branch>& branches, const RackMotion& motion, const EdgeArc& arc,
                  const EdgeLine& line) {
  const double xi_begin = rack_involute_roll(motion, line, line.begin_height + motion.shift);
  const double xi_end = std::isinf(line.end_height)
                            ? kInfinity
                            : rack_involute_roll(motion, line, line.end_height + motion.shift);
  if (!(xi_end > 0.0)) return;  // the cusp removes the whole branch
  auto curve = std::make_shared<Involute>(rack_involute(motion, line));
  const double r_b = curve->base_radius();
  const auto radius = [&](double xi) {
    return std::isinf(xi) ? kInfinity : r_b * std::hypot(1.0, xi);
  };
  const double xi_lo = std::max(0.0, xi_begin);
  branches.push_back({arc.cuts, curve, xi_lo, xi_end, radius(xi_lo), radius(xi_end),
                      arc.smooth_start && xi_begin >= 0.0});
}

void add_branches(std::vector<Branch>& branches, const RackMotion& motion, const EdgeArc& arc,
                  const EdgeCircle& circle) {
  const double begin = circle.begin_tau.rad();
  const double end = circle.end_tau.rad();
  auto curve = std::make_shared<RackTrochoid>(motion, circle);
  const auto f = curve->cusp_polynomial();
  const double direction = end > begin ? 1.0 : -1.0;
  const double s_a = std::sin(begin);
  const double s_b = std::sin(end);
  std::vector<double> cuts{begin};
  std::vector<double> cusps = polynomial_roots(f, std::min(s_a, s_b), std::max(s_a, s_b));
  if (direction < 0.0) std::reverse(cusps.begin(), cusps.end());
  for (double s : cusps) cuts.push_back(std::asin(std::min(1.0, s)));
  cuts.push_back(end);
  bool smooth = arc.smooth_start;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = std::sin(0.5 * (cuts[i] + cuts[i + 1]));
    const bool forward = evaluate_polynomial(f, middle) * direction > 0.0;
    if (forward) {
      Branch branch = branch_of(arc.cuts, curve, cuts[i], cuts[i + 1], 1.0);
      branch.smooth_start = smooth;
      if (arc.cuts == ArcName::root_fillet)
        branch.turns =
            curve->neck_angles(std::min(cuts[i], cuts[i + 1]), std::max(cuts[i], cuts[i + 1]));
      branches.push_back(std::move(branch));
    }
    smooth = false;  // no branch continues smoothly after a cusp
  }
}

// Adds the circular root fillet. It replaces the part of the profile below ξ_C that the rack cuts.
// [T6.2]
std::optional<Error> put_root_fillet(std::vector<Branch>& branches, int teeth,
                                     const CircularFillet& root, GeneratedTooth& tooth) {
  Branch& flank = branches.front();
  if (!(root.roll < flank.t_hi)) {
    return Error{"root_fillet", "",
                 "no circle centred in the tooth space touches the flank at this offset"};
  }
  const double gamma = std::numbers::pi / teeth;
  auto circle = std::make_shared<OffsetCircle>(root.arc.distance, gamma, root.arc.radius);
  const double t_lo = gamma - std::numbers::pi;
  flank.t_lo = root.roll;
  flank.height_lo = flank.height(root.roll);
  flank.smooth_start = true;
  Branch fillet{ArcName::root_fillet,       circle,       t_lo,
                t_lo + root.arc.span.rad(), root.arc.end, flank.height_lo};
  if (const auto ray = circle->tangent_ray()) fillet.turns = {gamma - *ray};
  branches.insert(branches.begin(), std::move(fillet));
  tooth.root_fillet = root.arc;
  tooth.root_radius = root.arc.end;
  return std::nullopt;
}

// Adds the circular tip fillet or the rounded tip corner. It replaces the part of the profile above
// ξ_J that the rack cuts. [T6.3], [T6.17]
std::optional<Error> put_tip_fillet(std::vector<Branch>& branches, const CircularFillet& tip,
                                    GeneratedTooth& tooth) {
  Branch& flank = branches.back();
  if (!(tip.roll > flank.t_lo && tip.roll <= flank.t_hi)) {
    return Error{
        "tip_fillet", "",
        "the fillet would have to touch the tooth at a place where the rack leaves no flank"};
  }
  flank.t_hi = tip.roll;
  flank.height_hi = flank.height(tip.roll);
  const double land = tip.arc.land.rad();
  Branch fillet{ArcName::tip_fillet,
                std::make_shared<OffsetCircle>(tip.arc.distance, land, tip.arc.radius),
                land + tip.arc.span.rad(),
                land,
                flank.height_hi,
                tip.arc.end,
                true};
  fillet.ends_on_center_line = land == 0.0;
  branches.push_back(std::move(fillet));
  tooth.tip_fillet = tip.arc;
  return std::nullopt;
}

std::optional<Error> put_fillets(std::vector<Branch>& branches, int teeth,
                                 const CircularFillets& fillets, GeneratedTooth& tooth) {
  const auto flank = std::find_if(branches.begin(), branches.end(),
                                  [](const Branch& b) { return b.name == ArcName::flank; });
  if (flank == branches.end()) {
    return Error{fillets.root ? "root_fillet" : "tip_fillet", "",
                 "the rack leaves no involute that the fillet could touch"};
  }
  // The tip is treated first, because removing branches at the front changes the position of the
  // flank.
  if (fillets.tip) {
    branches.erase(flank + 1, branches.end());
    if (fillets.root) branches.back().t_lo = std::max(branches.back().t_lo, fillets.root->roll);
    if (auto error = put_tip_fillet(branches, *fillets.tip, tooth)) return error;
  }
  if (!fillets.root) return std::nullopt;
  const auto first = std::find_if(branches.begin(), branches.end(),
                                  [](const Branch& b) { return b.name == ArcName::flank; });
  branches.erase(branches.begin(), first);
  return put_root_fillet(branches, teeth, *fillets.root, tooth);
}

}  // namespace

double left_by_land(const CutterEdge& edge, const RackMotion& motion) {
  return motion.pitch_radius + motion.shift + edge.bottom_height;
}

Result<GeneratedTooth> cut_by_rack(const CutterEdge& edge, const RackMotion& motion, int teeth,
                                   double blank_radius, const CircularFillets& fillets) {
  GW_EXPECTS(teeth >= 1);
  GeneratedTooth tooth{};
  tooth.root_radius = motion.pitch_radius + motion.shift - edge.tip_depth;
  detail::ToothEnds ends{teeth, 1.0, 0.0, blank_radius, left_by_land(edge, motion)};
  if (!(tooth.root_radius > 0.0) && !fillets.root) {
    tooth.tip_radius = std::min(blank_radius, ends.cutter_radius);
    tooth.through_axis = true;
    return tooth;
  }
  std::vector<Branch> branches;
  for (const EdgeArc& arc : edge.arcs) {
    if (fillets.root && arc.cuts == ArcName::root_fillet) continue;
    std::visit([&](const auto& shape) { add_branches(branches, motion, arc, shape); }, arc.shape);
  }
  if (fillets.root || fillets.tip) {
    if (auto error = put_fillets(branches, teeth, fillets, tooth)) return *error;
    if (tooth.tip_fillet) ends.blank_radius = std::min(blank_radius, tooth.tip_fillet->end);
  }
  // A root with a circular fillet ends on the centre line of the space, without a land.
  ends.root_land_angle = fillets.root ? std::numbers::pi / teeth
                                      : edge.tip_land_end / (motion.cos_beta * motion.pitch_radius);
  return detail::finish_tooth(branches, ends, std::move(tooth));
}

}  // namespace gearwright
