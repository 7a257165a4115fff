// The keys of [pair]: how the two gears are mounted.
#pragma once

#include <optional>
#include <string>

#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/inspection_keys.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

/// [pair]
struct PairInput {
  std::optional<double> center_distance;  ///< a  mm
  std::optional<Angle> shaft_angle;       ///< Σ, signed
  Mounting mounting = Mounting::tight;
  bool choose_profile_shifts = true;  ///< absent ones, at a given centre distance
  bool shorten_tips = false;          ///< tips cut back by k m_n, where no tip diameter is given
  std::optional<double> friction_coefficient;  ///< μ
  std::optional<double> speed_rpm;             ///< n_1  1/min
  // The backlash that the teeth are thinned for, said in one of three ways.
  std::optional<double> backlash;                  ///< j_n  mm, normal
  std::optional<double> backlash_circumferential;  ///< j_t  mm, at gear 1's working pitch circle
  std::optional<Angle> backlash_angle;             ///< of gear 1, gear 2 held
  std::optional<Ends> backlash_ends;               ///< j_n  mm, least and greatest
  double backlash_split = 0.5;                     ///< gear 1's share of it
  std::optional<Ends> distance_deviations;         ///< lower, upper  mm, of the centre distance
  std::optional<std::string> distance_tolerance;   ///< of ISO 286, "JS7"
  std::optional<double> bearing_span;              ///< L  mm, for the tolerances of the axes
};

/// Whether the teeth are to be thinned for a backlash.
inline bool wants_backlash(const PairInput& pair) {
  return pair.backlash || pair.backlash_circumferential || pair.backlash_angle;
}

const KeyTable& pair_keys();

}  // namespace gearwright
