// Designs a pinion with few teeth and its wheel. The search chooses the profile shifts with the
// longest path of contact without undercut, cusps, pointed teeth and interference.
//
//   x1, x2   profile shifts of pinion and wheel, the unknowns     C    clearance at both tips, mm
//
// The cutter of the wheel has the shape of the pinion, but is longer by C at the tip. The wheel is
// therefore conjugate to the pinion, including the tip fillet and the root fillet of the pinion.
// After cutting, the tips of both gears are shortened by C.
//                                  theory: docs/theory/06-few-teeth.md, 6.7
//
// The teeth of every candidate are generated exactly. The shifts are searched on a grid with steps
// of 0.05, and then on finer grids around the best candidate, down to steps of 0.001.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "gearwright/base/progress.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Lengths are in mm.
struct FewTeethProblem {
  std::array<int, 2> teeth{};  ///< numbers of teeth of pinion and wheel; < 0 for an internal gear
  double normal_module = 0.0;
  Angle normal_pressure_angle{};
  std::optional<Angle> helix;  ///< β of the pinion; if absent, β follows from the centre
                               ///< distance
  std::optional<double> center_distance;  ///< a; free if absent
  std::optional<double> pinion_shift;     ///< x1; computed if absent
  StraightRack rack;                      ///< rack of the pinion; a circular root fillet replaces
                                          ///< the fillet of the rack
  double root_offset = 0.0;               ///< distance between the root fillet and the undercut
                                          ///< limit
  double min_tip_land = 0.0;              ///< least normal thickness at both tips
  double min_gap = 0.0;                   ///< least chord of the tooth spaces of both gears at the
                                          ///< start of the flanks
  double clearance = 0.0;                 ///< C
  double backlash = 0.0;                  ///< circumferential backlash
  double contact_ratio = 1.2;             ///< total contact ratio, which determines the face width
  std::optional<double> face_width;       ///< face width of both gears; if absent, it follows from
                                          ///< the contact ratio
  Progress* progress = nullptr;           ///< reports the progress
};

struct FewTeethDesign {
  FewTeethDesign() = default;  ///< empty; prevents aggregate initialisation
  CylindricalSpec pinion, cutter;
  double wheel_tip_diameter, wheel_shift;
  double generating_distance, center_distance;
  double face_width;
  ParallelPair pair;
};

struct FewTeethAnswer {
  std::optional<FewTeethDesign> design;
  /// If there is no design, the condition that rejected the best candidate. The best candidate is
  /// the one that passed the most checks.
  std::string limit;
  int candidates = 0;  ///< number of candidates tried
};
/// Returns the design with the greatest transverse contact ratio. If contact ratios lie within the
/// same step of 0.02, they count as equal, and the design with the smallest |x1 + x2| is chosen.
///
/// Errors    `gear1.helix_angle` if neither helix angle nor centre distance is given; `gear2.teeth`
///           if an internal gear does not have more teeth than its pinion
Result<FewTeethAnswer> design_few_teeth(const FewTeethProblem& problem);

}  // namespace gearwright
