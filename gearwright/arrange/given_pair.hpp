// The data of one or two gears on a drawing. arrange() computes absent values from given values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

/// The mounting of the two gears.
struct PairInput {
  std::optional<double> center_distance;  ///< a  mm
  std::optional<Angle> shaft_angle;       ///< Σ, signed
  Mounting mounting = Mounting::tight;
  bool choose_profile_shifts = true;  ///< true to compute absent shifts from the centre distance
  bool shorten_tips = false;          ///< true to shorten tips by k m_n if no tip diameter is given
  std::optional<double> friction_coefficient;  ///< μ
  std::optional<double> speed_rpm;             ///< n_1  1/min
  // The backlash that thinning of the teeth must produce, in one of three forms.
  std::optional<double> backlash;                  ///< j_n  mm, normal
  std::optional<double> backlash_circumferential;  ///< j_t  mm, at gear 1's working pitch circle
  std::optional<Angle> backlash_angle;             ///< rotation of gear 1 while gear 2 is held
  std::optional<Ends> backlash_ends;               ///< j_n  mm, least and greatest
  double backlash_split = 0.5;                     ///< share of the thinning on gear 1
  std::optional<Ends> distance_deviations;         ///< lower, upper deviation of the centre
                                                   ///< distance, mm
  std::optional<std::string> distance_tolerance;   ///< tolerance of ISO 286, "JS7"
  std::optional<double> bearing_span;              ///< L  mm, for the tolerances of the axes

  /// True if the teeth must be thinned for a given backlash.
  bool wants_backlash() const { return backlash || backlash_circumferential || backlash_angle; }
};

struct GivenPair {
  std::array<std::optional<GearInput>, 2> gears;  ///< a single gear is gears[0]
  PairInput pair;
  bool shaft_angle_found = false;  ///< true if the shaft angle is computed from the centre distance
  std::vector<Warning> notes;      ///< about the input; arrange() adds them to the warnings

  /// Gear 1 or 2; null if this gear is not given.
  GearInput* find(int which) {
    auto& gear = gears[static_cast<std::size_t>(which - 1)];
    return gear ? &*gear : nullptr;
  }
  const GearInput* find(int which) const { return const_cast<GivenPair&>(*this).find(which); }
  bool has(int which) const { return find(which) != nullptr; }
  /// Gear 1 or 2.   Domain  this gear is given (contract)
  GearInput& gear(int which) {
    GW_EXPECTS(has(which));
    return *find(which);
  }
  const GearInput& gear(int which) const { return const_cast<GivenPair&>(*this).gear(which); }
};

// Checks whether the input is possible for gears with circular-arc teeth.

/// True if the gear has circular-arc teeth: its own rack, or the rack of its cutter, consists of
/// arcs.
bool has_arcs(const GearInput& gear);

/// True if at least one gear of the pair has circular-arc teeth.
bool has_arcs(const GivenPair& given);

/// Rejects inputs that have no meaning for circular-arc teeth: a pinion cutter with such teeth, tip
/// shortening that follows from profile shifts, and crossed axes.
std::optional<Error> check_arcs(const GivenPair& given);

}  // namespace gearwright
