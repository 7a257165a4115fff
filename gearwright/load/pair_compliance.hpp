// What the teeth of a pair yield: a table for each gear, whatever torque, errors and modifications.
//
// A table takes most of the time of an answer under load, so that whoever asks often keeps them.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "gearwright/base/headway.hpp"
#include "gearwright/compliance/tooth_table.hpp"

namespace gearwright {

struct LoadRequest {
  std::vector<double> torques;     ///< M1  N mm, on gear 1, > 0
  int positions = 64;              ///< over one pitch of gear 1
  std::vector<Angle> rotations{};  ///< of gear 1: these instead of positions
  int slices = 32;                 ///< over the common face
  ComplianceAccuracy accuracy = ComplianceAccuracy::full;
  std::array<ElasticBody, 2> bodies{};
  double deflection_slope = 0.0;  ///< mm, further approach of the flanks over the common face
  double deflection_bow = 0.0;    ///< mm, height of its parabola in the middle
  Headway* headway = nullptr;
  /// Does the work of items [0, n) by calling it for ranges that together are all of them, from
  /// several threads if it likes; none: one after the other. The answer is the same to the last bit.
  std::function<void(std::size_t n, const std::function<void(std::size_t, std::size_t)>& work)>
      spread{};
};

/// The tables of both gears: what the outlines, faces and materials give. Torques, errors and
/// modifications do not change them.
struct PairCompliance {
  std::array<std::shared_ptr<const ToothTable>, 2> table;
  std::array<ElasticBody, 2> bodies;
  FaceSlices slices;        ///< mm
  double half_width = 0.0;  ///< a0  mm
};

/// Of `ready` what is there is taken and not made anew: same_compliance says when it may be.
///
/// Domain    parallel external involute gears (contract)
/// Errors    `gearN.…` as make_section_mesh
Result<PairCompliance> pair_compliance(
    const Gear& gear_1, const Gear& gear_2, const LoadRequest& request,
    const std::array<std::shared_ptr<const ToothTable>, 2>& ready = {});

/// The table of gear `which` of a pair, the longer part of pair_compliance.
///
/// Errors    as pair_compliance
Result<std::shared_ptr<const ToothTable>> tooth_compliance(const Gear& gear_1, const Gear& gear_2,
                                                           int which, const LoadRequest& request);

/// Whether gear `which` of two pairs has one table: the same tooth, faces, body, slices and accuracy,
/// to the last bit.
bool same_compliance(const std::array<const Gear*, 2>& a, const LoadRequest& of_a,
                     const std::array<const Gear*, 2>& b, const LoadRequest& of_b, int which);

/// request.spread, or all at once.
void in_ranges(const LoadRequest& request, std::size_t n,
               const std::function<void(std::size_t, std::size_t)>& work);

}  // namespace gearwright
