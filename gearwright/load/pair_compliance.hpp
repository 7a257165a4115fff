// The compliance of the teeth of a pair: a table for each gear, independent of torque, errors and
// modifications.
//
// Computing a table takes most of the time under load, so callers with several requests keep the
// tables.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/compliance/tooth_table.hpp"

namespace gearwright {

/// The kind of contact under load: along lines, for parallel involute flanks, or about points, for
/// crossed and circular-arc teeth.
enum class LoadRegime { line, point };
std::string_view to_string(LoadRegime regime);

struct LoadRequest {
  std::vector<double> torques;     ///< M1  N mm, on gear 1, > 0
  int positions = 64;              ///< over one pitch of gear 1
  std::vector<Angle> rotations{};  ///< rotations of gear 1, used instead of `positions`
  int slices = 32;  ///< over the common face, for point contact over the face of each gear; see
                    ///< fair_slices
  LoadRegime regime = LoadRegime::line;
  ComplianceAccuracy accuracy = ComplianceAccuracy::full;
  std::array<ElasticBody, 2> bodies{};
  // Of lines only:
  double deflection_slope = 0.0;   ///< mm, further approach of the flanks over the common face
  double deflection_bow = 0.0;     ///< mm, height of its parabola in the middle
  double deflection_offset = 0.0;  ///< mm, the part that is constant over the face
  bool root_stress = true;         ///< if false, tables and positions have no root stress
  Progress* progress = nullptr;
};

/// A number of slices of the common face that is fine enough and never too fine. It is 32, or as
/// many as make a slice a quarter of a module wide (0.4 modules for helical teeth), but at least 4.
/// Narrower slices may make the matrix of [T12.14] indefinite: for spur teeth from 0.17 modules on,
/// and of 24 random helical pairs, none at 0.36 and a quarter at 0.32. Internal pairs have a
/// wider contact. Their slices are four half widths of contact under 125 N/mm per mm of module at
/// the pinion's tip, which six pairs from 14:30 to 40:52 bore up to 400 MPa at the roots. For point
/// contact, the wider face is divided.
int fair_slices(const Gear& gear_1, const Gear& gear_2, LoadRegime regime);

/// True if the slices are too narrow for the resolution of modes and elements, which is known
/// without a table: below 0.15 modules, or 0.18 for helical teeth. The matrix of [T12.14] is then
/// indefinite for every torque. Of a dozen pairs (external and internal, draft and full) none had a
/// solution at 0.16 and 0.2. For point contact, the compliance of a place would be negative.
bool surely_too_fine(const Gear& gear_1, const Gear& gear_2, const LoadRequest& request);

/// The tables of both gears, which follow from the outlines, faces and materials. Torques, errors
/// and modifications do not change them.
struct PairCompliance {
  std::array<std::shared_ptr<const ToothTable>, 2> table;
  std::array<ElasticBody, 2> bodies;
  std::array<FaceSlices, 2> slices;  ///< mm, on each gear; equal on both for line contact
  double half_width = 0.0;           ///< a0  mm
};

/// Tables in `ready` are reused; same_compliance determines when this is allowed.
///
/// Domain    gear 1 external; LoadRegime::line: involute gears on parallel axes; LoadRegime::point:
///           gear 2 external too (contract)
/// Errors    `gearN.…` as make_section_mesh
Result<PairCompliance> pair_compliance(
    const Gear& gear_1, const Gear& gear_2, const LoadRequest& request,
    const std::array<std::shared_ptr<const ToothTable>, 2>& ready = {});

/// The table of gear `which` of a pair, the longer part of pair_compliance.
///
/// Errors    as pair_compliance
Result<std::shared_ptr<const ToothTable>> tooth_compliance(const Gear& gear_1, const Gear& gear_2,
                                                           int which, const LoadRequest& request);

/// True if gear `which` of two pairs has the same table: the same tooth, faces, body, slices and
/// accuracy, to the last bit.
bool same_compliance(const std::array<const Gear*, 2>& a, const LoadRequest& of_a,
                     const std::array<const Gear*, 2>& b, const LoadRequest& of_b, int which);

}  // namespace gearwright
