// Computes the compliance of the teeth of a pair, in a table for each gear, and of the shafts. The
// compliance does not depend on torque, errors or modifications. The tables take most of the
// computing time of a loaded contact, so a caller with several requests should keep them.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/progress.hpp"
#include "gearwright/compliance/shaft_influence.hpp"
#include "gearwright/compliance/tooth_table.hpp"

namespace gearwright {

/// The kind of contact under load. Involute flanks on parallel axes touch along lines. Crossed and
/// circular-arc teeth touch about points.
enum class LoadRegime { line, point };
std::string_view to_string(LoadRegime regime);

struct LoadRequest {
  std::vector<double> torques;     ///< M1  N mm, on gear 1, > 0
  int positions = 64;              ///< over one pitch of gear 1
  std::vector<Angle> rotations{};  ///< rotations of gear 1, used instead of `positions`
  /// Numbers of slices of the loaded part of each face; equal for line contact; see fair_slices().
  std::array<int, 2> slices{32, 32};
  /// Greatest |z| in the frame N at which the teeth are loaded, mm, for point contact only; see
  /// crossed_reach().
  double reach = kInfinity;
  LoadRegime regime = LoadRegime::line;
  ComplianceAccuracy accuracy = ComplianceAccuracy::full;
  std::array<ElasticBody, 2> bodies{};
  /// The shafts of the gears, for line contact only. A shaft that is not given is rigid.
  std::array<std::optional<Shaft>, 2> shafts{};
  // An additional deflection, for line contact only, given as an approach of the flanks in mm.
  double deflection_slope = 0.0;   ///< mm, increase from one end of the common face to the other
  double deflection_bow = 0.0;     ///< mm, height of the parabola in the middle of the face
  double deflection_offset = 0.0;  ///< mm, the part that is constant over the face
  /// z of the middle of each face in frame N, mm, including a displacement along the axis. Both
  /// values are equal if the gears have shafts.
  std::array<double, 2> middle{};
  bool root_stress = true;  ///< if false, tables and positions have no root stress
  Progress* progress = nullptr;

  bool deflects() const {
    return shafts[0] || shafts[1] || deflection_slope != 0.0 || deflection_bow != 0.0;
  }
  /// Returns the same request with rigid shafts and without deflections.
  LoadRequest undeflected() const;
};

/// Returns numbers of slices of the loaded part of each face that give accurate results and usually
/// a solution. Each number is 32. If 32 slices would be narrower than a quarter of a module (0.4
/// modules for helical teeth), the number is less than 32, but at least 4. For line contact, the
/// loaded part is the common face, and both numbers are equal.
///
/// Narrower slices may make the matrix of [T12.14] indefinite. For spur teeth, this happened at
/// widths of 0.17 modules and less. In a test with 24 random helical pairs, a quarter of the pairs
/// had an indefinite matrix at a width of 0.32 modules, and none at 0.36 modules.
///
/// The contact of internal pairs is wider than that of external pairs, so their slices must be
/// wider. The least width of a slice is at least four times the half width of the contact of steel
/// gears at the pinion's tip under a line load of 125 N/mm per mm of module. With slices of this
/// width, all six tested pairs, with tooth numbers from 14:30 to 40:52, had a solution up to 400
/// MPa at the roots.
///
/// For point contact, the root stress depends on the width of the slices. For crossed gears with 17
/// and 31 teeth at 90°, the stress is 2 % lower with slices of 0.6 modules than with slices of 0.2
/// modules. With slices of 1.25 modules, it is 10 % lower.
std::array<int, 2> fair_slices(const Gear& gear_1, const Gear& gear_2, LoadRegime regime,
                               double reach = kInfinity);

/// Returns the value of LoadRequest::reach for crossed axes. The path of contact extends beyond the
/// pitch point by at most h_a/sin α_n. The value is this length plus 2 modules for the ellipses and
/// errors. It is at least half of the width of 32 slices of 0.4 modules.
double crossed_reach(const Gear& gear_1, const Gear& gear_2);

inline constexpr int kLeastSlices = 4;  ///< least number of slices of a face

/// The gear (1 or 2) with the narrowest slices, and their width, mm.
struct NarrowestSlices {
  int gear;
  double width;
};
NarrowestSlices narrowest_slices(const Gear& gear_1, const Gear& gear_2,
                                 const LoadRequest& request);

/// True if the slices are too narrow for the section modes and the finite elements. The limit is
/// 0.15 modules for spur teeth, 0.2 modules for helical teeth with line contact, and 0.18 modules
/// for helical teeth with point contact. The matrix of [T12.14] is indefinite for such slices,
/// whatever the torque is. A dozen external and internal pairs were tested with draft and full
/// accuracy. None had a solution at a width of 0.16 modules (spur teeth) or 0.2 modules (helical
/// teeth). For point contact, the compliance of a place would be negative.
///
/// For line contact, a second limit is twice the half width of the contact if three tooth pairs
/// share the greatest torque. Spur pairs of steel with 20:40 and 60:90 teeth had no solution at
/// less than 2.2 times the greatest half width. The check needs no tooth table.
bool surely_too_fine(const Gear& gear_1, const Gear& gear_2, const LoadRequest& request);

/// The compliance of both gears. The tables depend only on the outlines, faces and materials.
struct PairCompliance {
  std::array<std::shared_ptr<const ToothTable>, 2> table;
  std::array<ElasticBody, 2> bodies;
  std::array<FaceSlices, 2> slices;                       ///< mm, on each gear, in frame N
  double half_width = 0.0;                                ///< a0  mm
  std::array<std::optional<ShaftInfluence>, 2> shafts{};  ///< for the shafts of the request
};

/// Computes the compliance. `ready` may contain tables from an earlier call, for which
/// same_compliance() must be true. These tables are used instead of new ones. The shafts are
/// always computed.
///
/// Domain    gear 1 is external; with LoadRegime::line, involute gears on parallel axes; with
///           LoadRegime::point, gear 2 is also external; with a shaft, both values of `middle` are
///           equal (contract)
/// Errors    `gearN.…` as make_section_mesh
Result<PairCompliance> pair_compliance(
    const Gear& gear_1, const Gear& gear_2, const LoadRequest& request,
    const std::array<std::shared_ptr<const ToothTable>, 2>& ready = {});

/// Returns the table of gear `which` (1 or 2) of a pair. Most of the computing time of
/// pair_compliance() is needed for the tables.
///
/// Errors    as pair_compliance
Result<std::shared_ptr<const ToothTable>> tooth_compliance(const Gear& gear_1, const Gear& gear_2,
                                                           int which, const LoadRequest& request);

/// True if gear `which` has the same table in the pairs `a` and `b`. This is the case if its tooth,
/// face, slices and body without Young's modulus are equal to the last bit, and if the requests
/// have the same accuracy, regime and `root_stress`.
bool same_compliance(const std::array<const Gear*, 2>& a, const LoadRequest& of_a,
                     const std::array<const Gear*, 2>& b, const LoadRequest& of_b, int which);

}  // namespace gearwright
