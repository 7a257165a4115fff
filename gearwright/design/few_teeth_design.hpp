// Design of a pinion of few teeth and the wheel that it cuts: the profile shifts with the longest
// path of contact without undercut, cusp, pointed tooth or interference.
//
//   x1, x2   shifts of pinion and wheel: the two unknowns       C    clearance at both tips, mm
//   The wheel is cut by the pinion's longer twin, whose tip fillet and root fillet it follows; both
//   gears are then shortened by C.   theory: docs/theory/06-few-teeth.md, 6.7
//
// Every candidate is generated exactly. The shifts are searched on a grid of 0.05, then on finer
// ones around the best, to 0.001. The conditions of a mounted pair are checked for the best
// candidate first, and then for the next ones until one is accepted: interference takes ten times
// as long to find as the teeth take to cut.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "gearwright/base/progress.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Lengths mm.
struct FewTeethProblem {
  std::array<int, 2> teeth{};  ///< the wheel's is < 0 if it is internal
  double normal_module = 0.0;
  Angle normal_pressure_angle{};
  std::optional<Angle> helix;             ///< β of the pinion; by default from the centre distance
  std::optional<double> center_distance;  ///< a; free if absent
  std::optional<double> pinion_shift;     ///< x1; computed if absent
  StraightRack rack;                      ///< of the pinion; its root is the circular fillet's
  double root_offset = 0.0;               ///< of C from the undercut limit
  double min_tip_land = 0.0;              ///< normal thickness at both tips
  double min_gap = 0.0;                   ///< chord of both spaces where the flanks begin
  double clearance = 0.0;                 ///< C
  double backlash = 0.0;                  ///< circumferential
  double contact_ratio = 1.2;             ///< total, which determines the face width
  std::optional<double> face_width;       ///< of both; by default as the contact ratio requires
  Progress* progress = nullptr;           ///< reports the progress
};

struct FewTeethDesign {
  FewTeethDesign() = default;  ///< empty, and not an aggregate; design_few_teeth() makes it
  CylindricalSpec pinion, cutter;
  double wheel_tip_diameter, wheel_shift;
  double generating_distance, center_distance;
  double face_width;
  ParallelPair pair;
};

struct FewTeethAnswer {
  std::optional<FewTeethDesign> design;
  std::string limit;   ///< without a design: the condition that rejected the candidate that got
                       ///< furthest
  int candidates = 0;  ///< tried
};

/// The design with the greatest transverse contact ratio. Of designs that agree to 0.02, the one
/// with the least |x1 + x2| is chosen.
///
/// Errors    `gear1.helix_angle` when neither helix nor centre distance is given; `gear2.teeth`
Result<FewTeethAnswer> design_few_teeth(const FewTeethProblem& problem);

}  // namespace gearwright
