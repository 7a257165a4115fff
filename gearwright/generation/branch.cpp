#include "gearwright/generation/branch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/error.hpp"
#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright::detail {

// The tip circle and the end of a branch count as equal within this relative difference.
constexpr double kSameEnd = 1e-12;
// Least length of a root land, relative to half a pitch. A shorter land at a full-radius root is
// only a rounding error.
constexpr double kNoLand = 1e-12;

double Branch::t_at(double h) const {
  if (h <= height_lo) return t_lo;
  if (h >= height_hi) return t_hi;
  return side > 0.0 ? curve->parameter_at_radius(h, t_lo, t_hi)
                    : curve->parameter_at_radius(-h, t_hi, t_lo);
}

void Branch::end_at(double h) {
  if (height_hi - h > kSameEnd * std::abs(h)) ends_on_center_line = false;
  t_hi = t_at(h);
  height_hi = h;
}

void Branch::start_at(double h) {
  t_lo = t_at(h);
  height_lo = h;
}

Branch branch_of(ArcName name, CurvePtr curve, double t_lo, double t_hi, double side) {
  const double lo = side * curve->point(t_lo).norm();
  const double hi = side * curve->point(t_hi).norm();
  return {name, std::move(curve), t_lo, t_hi, lo, hi, false, side};
}

namespace {

// Finds the smallest half angle of that part of the root fillet that lies below the tip.
void find_neck(const std::vector<Branch>& chain, double tip_height, GeneratedTooth& tooth) {
  for (const Branch& branch : chain) {
    if (branch.name != ArcName::root_fillet || branch.height_lo >= tip_height) continue;
    const double t_end = branch.t_at(tip_height);
    std::vector<double> candidates{branch.t_lo, t_end};
    const auto [lo, hi] = std::minmax(branch.t_lo, t_end);
    for (double t : branch.turns)
      if (t > lo && t < hi) candidates.push_back(t);
    for (double t : candidates) {
      const double theta = branch.curve->polar_angle(t);
      if (!tooth.neck_half_angle || theta < tooth.neck_half_angle->rad()) {
        tooth.neck_half_angle = Angle::radians(theta);
        tooth.neck_radius = branch.curve->point(t).norm();
      }
    }
  }
}

// Ends the chain at the tip circle, or at the point of the tooth if the tooth is pointed below that
// circle.
void end_at_tip(std::vector<Branch>& chain, double side, GeneratedTooth& tooth) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Branch& branch = chain[i];
    const double tip = side * tooth.tip_radius;
    const bool final = i + 1 == chain.size();
    if (final) GW_ENSURES(branch.height_hi >= tip - kAtTip * tooth.tip_radius);
    const bool last = final || branch.height_hi >= tip;
    const double end = std::min(branch.height_hi, tip);
    if (branch.ends_on_center_line && branch.height_hi - end <= kSameEnd * tooth.tip_radius) {
      tooth.tip_radius = std::abs(branch.height_hi);
      tooth.rounded_tip = true;
    } else if (branch.theta_at(end) <= 0.0) {
      // The root finder solves for the parameter of the curve. The radius is nearly stationary
      // here, so it would not determine the position accurately.
      const double t_end = branch.t_at(end);
      const auto theta = [&](double t) { return branch.curve->polar_angle(t); };
      branch.t_hi = find_root(theta, std::min(branch.t_lo, t_end), std::max(branch.t_lo, t_end)).x;
      branch.height_hi = branch.height(branch.t_hi);
      tooth.tip_radius = std::abs(branch.height_hi);
      tooth.pointed = true;
    }
    if (last || tooth.pointed) {
      const double end_height = side * tooth.tip_radius;
      if (branch.height_hi - end_height > kSameEnd * tooth.tip_radius) branch.end_at(end_height);
      chain.resize(i + 1);
      return;
    }
  }
}

void write_outline(const std::vector<Branch>& chain, const ToothEnds& ends, GeneratedTooth& tooth) {
  Outline& outline = tooth.outline;
  outline.teeth = ends.teeth;
  const int z = std::abs(ends.teeth);
  const double half_pitch = std::numbers::pi / z;
  const auto root_circle = std::make_shared<AxisCircle>(tooth.root_radius);
  const SinCos middle = sincos_turn(1, 2LL * z);
  Vec2 joint = tooth.root_radius * Vec2(middle.cos, middle.sin);
  if (ends.root_land_angle < half_pitch * (1 - kNoLand)) {
    const Vec2 end = root_circle->point(ends.root_land_angle);
    outline.arcs.push_back(
        {ArcName::root_land, root_circle, half_pitch, ends.root_land_angle, joint, end});
    joint = end;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Branch& branch = chain[i];
    Vec2 end = branch.curve->point(branch.t_hi);
    if (i + 1 == chain.size() && (tooth.pointed || tooth.rounded_tip))
      end = Vec2(tooth.tip_radius, 0.0);
    outline.arcs.push_back({branch.name, branch.curve, branch.t_lo, branch.t_hi, joint, end});
    joint = end;
  }
  if (!tooth.pointed && !tooth.rounded_tip) {
    const double theta_tip = chain.back().curve->polar_angle(chain.back().t_hi);
    outline.arcs.push_back({ArcName::tip_land, std::make_shared<AxisCircle>(tooth.tip_radius),
                            theta_tip, 0.0, joint, Vec2(tooth.tip_radius, 0.0)});
  }
}

// Names the branches other than the flank. Branches below the flank belong to the root fillet, and
// branches above it to the tip fillet.
void name_by_place(std::vector<Branch>& chain) {
  const auto is_flank = [](const Branch& b) { return b.name == ArcName::flank; };
  const auto flank = std::find_if(chain.begin(), chain.end(), is_flank);
  const bool any = flank != chain.end();
  for (auto b = chain.begin(); b != chain.end(); ++b) {
    if (b == flank) continue;
    const bool at_root = any ? b < flank : b->name == ArcName::root_fillet;
    if (!any && b != chain.begin() && (b - 1)->name == ArcName::tip_fillet) {
      b->name = ArcName::tip_fillet;
      continue;
    }
    b->name = at_root ? ArcName::root_fillet : ArcName::tip_fillet;
  }
}

// Returns the error if the branches do not join. Heights along the edge of a rack never decrease,
// so the branches of a rack always meet, and only a circular fillet can cause an error. A branch of
// a pinion cutter may end without meeting another branch.
std::optional<Error> amiss(const std::vector<Branch>& chain, const ToothEnds& ends,
                           const GeneratedTooth& tooth) {
  if (ends.rack) {
    const bool root = tooth.root_fillet.has_value();
    if (!chain.empty() && !(root && chain.front().name != ArcName::root_fillet))
      return std::nullopt;
    GW_ENSURES(root || tooth.tip_fillet);
    return Error{root ? "root_fillet.offset" : "tip_fillet", "",
                 "leaves no flank between the root fillet and the tip that the rack cuts; use a "
                 "smaller fillet, or a rack without semi-topping and tip rounding"};
  }
  if (!chain.empty() && is_continuous(chain)) return std::nullopt;
  return Error{
      "cut_by", "",
      "a sharp edge of the cutter outside its rolling circle generates a loop that does not touch "
      "the tooth; use a cutter with fewer teeth, a shorter tip or no undercut, or change the "
      "generating centre distance"};
}

}  // namespace

Result<GeneratedTooth> finish_tooth(const std::vector<Branch>& branches, const ToothEnds& ends,
                                    GeneratedTooth tooth) {
  const double side = ends.side;
  const auto nearer = [&](double a, double b) {
    return side > 0.0 ? std::min(a, b) : std::max(a, b);
  };
  tooth.tip_radius = nearer(ends.blank_radius, ends.cutter_radius);
  if (!(side * tooth.tip_radius > side * tooth.root_radius)) {
    return refused("tip_diameter", 2 * ends.blank_radius, {2 * tooth.root_radius},
                   side > 0.0 ? "must be greater than the root diameter {} mm"
                              : "must be less than the root diameter {} mm");
  }
  const double tip_height = side * tooth.tip_radius;
  std::vector<Branch> chain;
  if (!ends.turns_back) chain = assemble(branches, tip_height);
  if (chain.empty() && ends.all) {
    chain = lower_envelope(ends.all(), tip_height);
    name_by_place(chain);
  }
  if (auto error = amiss(chain, ends, tooth)) return *error;
  find_neck(chain, side * tooth.tip_radius, tooth);
  if (tooth.neck_half_angle && tooth.neck_half_angle->rad() <= 0.0) {
    tooth.severed = true;
    return tooth;
  }
  end_at_tip(chain, side, tooth);
  // If the radii at which the blank and the cutter end the tooth differ only by rounding, the tip
  // does not count as cut by the rack.
  constexpr double kOneRadius = 1e-13;
  tooth.tip_cut_by_rack =
      !tooth.pointed && !tooth.rounded_tip &&
      side * (ends.blank_radius - ends.cutter_radius) > kOneRadius * std::abs(ends.cutter_radius);
  for (const Branch& branch : chain) {
    if (branch.name != ArcName::flank) continue;
    // A rack of arcs may cut several flank arcs. The usable flank extends from the start of the
    // first flank arc to the end of the last flank arc. For a single involute, this is [T3.15].
    if (!tooth.form_radius || !ends.rack) tooth.form_radius = std::abs(branch.height_lo);
    tooth.tip_form_radius = std::abs(branch.height_hi);
  }
  write_outline(chain, ends, tooth);
  return tooth;
}

}  // namespace gearwright::detail
