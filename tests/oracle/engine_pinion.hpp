// Compares a gear that the engine has cut by a pinion cutter with the result of sweeping this
// cutter.
//
// The outline of the cutter is computed by the engine. The sweep computes the gear that this
// outline cuts, and does not check the outline itself.
//
//   E        generating centre distance, mm      ρ, θ   polar, gear frame; tooth 0 is on θ = 0
//   q        a point of the gear in the frame of the cutter
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/generation/pinion_envelope.hpp"
#include "tests/oracle/engine_curves.hpp"
#include "tests/oracle/engine_numbers.hpp"
#include "tests/oracle/outline_against_sweep.hpp"
#include "tests/oracle/swept_pinion.hpp"

namespace gearwright::oracle {

/// The sweep of a finished gear as cutter.
///
/// Domain    `cutter` has an outline
inline SweptPinion swept_by(const Gear& cutter, const PinionCutSpec& gear) {
  return SweptPinion({cutter.spec.teeth, gear.teeth, gear.distance},
                     curves_of(cutter.tooth->outline));
}

enum class Ending { error, through_axis, severed, tooth };

struct PinionCutOutcome {
  Ending ending = Ending::error;
  std::string key;     ///< of the error
  std::string broken;  ///< the disagreement as a sentence; empty if the sweep agrees
  double worst = 0.0;  ///< mm, greatest |clearance| over the points of the outline
  bool pointed = false, undercut = false, rounded_tip = false;
  bool land_cut = false;    ///< true if the root of the cutter made the tip land
  bool caught_tip = false;  ///< true if the tip of an internal gear was partly cut when the cutter
                            ///< left
  bool caught_flank = false;  ///< true if the gear was rejected because a part of the flank would
                              ///< be cut
};

/// Resolution of the sweep.
struct PinionCheck {
  double on_surface = 1e-9;  ///< mm
  int points_per_arc = 3;    ///< least number, ends included
  double longest = 0.5;      ///< greatest distance between neighbours, modules
};

namespace pinion_detail {

inline double clearance_at(const SweptPinion& sweep, double rho, double theta) {
  return sweep.clearance({rho * std::cos(theta), rho * std::sin(theta)});
}

// The engine reports that the cutter, when leaving, cuts the flank. Then the involute that the
// flank of the cutter generates must be cut away at some point.
inline std::string deny_caught_flank(const Gear& cutter, const PinionCutSpec& gear,
                                     const SweptPinion& sweep, double on_surface) {
  constexpr int kPlaces = 400;
  const Arc* flank = cutter.tooth->outline.find(ArcName::flank);
  if (!flank) return "a cutter without a flank catches the ring's";
  const PinionMotion motion{cutter.spec.teeth, gear.teeth, gear.distance};
  const auto cut = pinion_involute(motion, curve_as<Involute>(*flank->curve));
  if (!cut) return "the cutter's involute cuts none, and yet it catches the ring's";
  const double from = cut->roll(flank->end), to = cut->roll(flank->begin);
  for (int i = 0; i <= kPlaces; ++i) {
    const Vec2 p = cut->flank.point(from + (to - from) * i / kPlaces);
    if (sweep.clearance(p) < -on_surface) return {};
  }
  return "the oracle finds the flank whole that is said to be caught";
}

// Parts that must not be cut: the land of the blank, and the middle of the tooth down to the root.
inline std::string deny_middle(const GeneratedTooth& tooth, double land_end,
                               const SweptPinion& sweep, double on_surface) {
  for (const double part : {0.0, 0.25, 0.5, 0.75, 0.95}) {
    if (clearance_at(sweep, tooth.tip_radius, part * land_end) < -on_surface)
      return fmt::format("the tip land is cut at {} of its half", part);
    const double rho = tooth.tip_radius + part * (tooth.root_radius - tooth.tip_radius);
    if (clearance_at(sweep, rho, 0.0) < -on_surface)
      return fmt::format("the middle of the tooth is cut at the radius {}", rho);
  }
  return {};
}

// A point that is nearer to the axis of the internal gear than the centrode, and that is cut by a
// part of the cutter outside the cutter's centrode. This cannot happen while the tooth enters.
inline bool caught_by_tip(const std::vector<Vec2>& points, const SweptPinion& sweep) {
  const PinionSweepNumbers& n = sweep.numbers();
  const double per_tooth = n.center_distance / -(n.gear_teeth + n.cutter_teeth);
  return std::any_of(points.begin(), points.end(), [&](const Vec2& p) {
    if (!(p.norm() < -per_tooth * n.gear_teeth)) return false;
    return sweep.seen_by_cutter(p, sweep.nearest(p).roll).norm() > per_tooth * n.cutter_teeth;
  });
}

inline std::string deny_tooth(const Gear& cut, const SweptPinion& sweep, const PinionCheck& check,
                              PinionCutOutcome& outcome) {
  const GeneratedTooth& tooth = *cut.tooth;
  const double longest = check.longest * cut.spec.normal_module;
  const bool land = !tooth.pointed && !tooth.rounded_tip;
  outcome.land_cut =
      land && (tooth.tip_cut_by_rack ||
               std::abs(sweep.clearance({tooth.tip_radius, 0.0})) <= check.on_surface);
  const auto points = edged_points(tooth, check.points_per_arc, outcome.land_cut, longest);
  const OutlineAgainstSweep held =
      outline_against_sweep(points, sweep, cut.internal() ? Tooth::ring : Tooth::external);
  outcome.worst = held.worst;
  outcome.caught_tip = cut.internal() && caught_by_tip(points, sweep);
  const auto at = [&](std::size_t i) {
    return fmt::format(" at point {} of {}, ({}, {}), radius {}", i, points.size(), points[i].x(),
                       points[i].y(), points[i].norm());
  };
  if (!(held.worst <= check.on_surface))
    return fmt::format("off the surface by {} mm", held.worst) + at(held.worst_index);
  if (!(held.min_inward > 0.0)) {
    return fmt::format("no material inside: {} mm", held.min_inward) + at(held.min_inward_index);
  }
  if (!(held.max_outward < 0.0)) {
    return fmt::format("material outside: {} mm", held.max_outward) + at(held.max_outward_index);
  }
  if (!(held.longest_step <= longest + 4 * kBeside))
    return fmt::format("a hole of {} mm in the outline", held.longest_step);
  return deny_middle(tooth, std::atan2(points.back().y(), points.back().x()), sweep,
                     check.on_surface);
}

}  // namespace pinion_detail

/// Makes the gear and checks it by the sweep. The points of the outline must lie on the surface,
/// with material on the inner side only and without gaps between them. A severed tooth must be cut
/// at its neck. A flank that the leaving cutter cuts must be cut at some point.
///
/// Domain    `cutter` exists
/// Cost      about 20 ms
inline PinionCutOutcome check_pinion_cut(const Gear& cutter, const PinionCutSpec& wanted,
                                         const PinionCheck& check = {}) {
  PinionCutOutcome outcome;
  const auto cut = make_pinion_cut_gear(cutter, wanted);
  const SweptPinion sweep = swept_by(cutter, wanted);
  if (!cut) {
    const Error& error = cut.error();
    outcome.key = error.field;
    if (error.field.empty() || error.message().find(error.field) == std::string::npos) {
      outcome.broken = "an error that does not name its field: " + error.message();
    } else if (error.message().find("catch the ring's flanks") != std::string::npos) {
      outcome.caught_flank = true;
      outcome.broken = pinion_detail::deny_caught_flank(cutter, wanted, sweep, check.on_surface);
    }
    return outcome;
  }
  const GeneratedTooth& tooth = *cut->tooth;
  if (tooth.through_axis || tooth.severed) {
    outcome.ending = tooth.through_axis ? Ending::through_axis : Ending::severed;
    if (!tooth.outline.arcs.empty()) {
      outcome.broken = "a tooth that does not exist has arcs";
    } else if (cut->warnings.empty()) {
      outcome.broken = "nothing is said about it";
    } else if (tooth.through_axis) {
      if (wanted.teeth < 0 || wanted.distance > cutter.tooth->tip_radius)
        outcome.broken = "the cutter does not reach the axis";
    } else if (pinion_detail::clearance_at(sweep, *tooth.neck_radius, 0.0) > check.on_surface) {
      outcome.broken = "the oracle finds that the neck is not cut";
    }
    return outcome;
  }
  outcome.ending = Ending::tooth;
  outcome.pointed = tooth.pointed;
  outcome.rounded_tip = tooth.rounded_tip;
  outcome.undercut = cut->undercut;
  outcome.broken = pinion_detail::deny_tooth(*cut, sweep, check, outcome);
  return outcome;
}

}  // namespace gearwright::oracle
