// What a spec says of measuring a gear: [gearN.measure], the tools, and [gearN.tolerance], what the
// readings may be.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"

namespace gearwright {

/// [gearN.measure]: the tools, and where they touch.
struct MeasureInput {
  std::optional<int> span_teeth;         ///< k
  std::optional<double> ball_diameter;   ///< D_M  mm
  std::optional<double> pin_diameter;    ///< D_M  mm
  std::optional<double> chord_diameter;  ///< d_y  mm
};

/// From, to.
using Ends = std::array<double, 2>;

/// [gearN.tolerance]: the grade of the flanks, the thickness allowances said in another way, and the
/// deviations of the tip diameter that the gear is given or gets.
struct ToleranceInput {
  std::optional<int> quality;                           ///< A, the ISO 1328 grade
  FlankTolerances edition = FlankTolerances::iso_2013;  ///< of ISO 1328-1
  std::optional<std::string> series;                    ///< of DIN 3967, "cd25"
  std::optional<Ends> span;                             ///< W_k  mm
  std::optional<Ends> over_balls;                       ///< M_d  mm
  /// A_da, mm: lower and upper deviation of d_a. The upper end is the longer tooth, of a ring the
  /// shorter one.
  std::optional<Ends> tip_deviations;

  bool says_thickness() const { return series || span || over_balls; }
};

const KeyTable& measure_keys();
const KeyTable& tolerance_keys();

}  // namespace gearwright
