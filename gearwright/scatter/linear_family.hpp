// Estimates the peak-to-peak TE of the members of a family to first order. The estimate is fast
// enough for a diagram that follows a slider.
//
//   T_i    greatest gap angle over the profile at place i; a place is one axial position z on one
//          tooth pair
//   e      errors of a member minus nominal errors
//   ΔC     material removed from the member at place i minus material removed from the nominal pair
//   T_i(x) ≈ T_i + Σ ∂T_i/∂e · e + Σ ∂T_i/∂C · ΔC       theory: docs/theory/14-scatter.md, [T14.26]
//
// T at a fixed place is nearly linear in the errors (section 14.5). Only T is linearised. TE is the
// greatest of the linearised T over all places, so the contact can move along the face, edges can
// begin to touch, and another tooth pair can come into contact.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/sensitivity.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

class LinearFamily {
 public:
  /// Prepares the estimate. Returns none if the nominal pair loses contact at some position.
  ///
  /// Domain    request.positions ≥ 2 (contract)
  static std::optional<LinearFamily> of(const ContactSetup& setup, const MemberRequest& request);

  /// Returns the peak-to-peak TE of a member, rad. Thickness, pitch deviations and the lead angle
  /// of a cutter have no effect.
  ///
  /// Accuracy  T_i is exact to the first order in the deviation
  /// Laws      (1) without a deviation, the result equals continuous_peak_to_peak()   (2) for small
  ///           deviations, the result changes like continuous_peak_to_peak()
  double peak_to_peak(const Deviation& deviation) const;

 private:
  struct Place {
    double te;                           // T_i of the nominal pair in the frame N, rad
    std::array<double, 6> by_error;      // ∂T_i/∂e, in the order of kErrorKinds
    std::array<RemovalTurn, 2> removal;  // ∂T_i/∂C of each gear
    std::array<double, 2> drawn;         // mm removed from each gear of the nominal pair
  };
  // A tooth pair at a position. The places are the heights at which its flanks face each other, in
  // ascending order.
  struct Row {
    int pair;
    std::vector<std::vector<Place>> runs;  // sequences of neighbouring heights
  };
  struct Member;

  explicit LinearFamily(const ContactSetup& setup) : setup_(setup) {}
  void add_position(class GapSearch& search, double phi);
  double greatest(const Row& row, const Member& member) const;

  ContactSetup setup_;                       // has a field of removed material on both gears
  std::array<bool, 2> left_{};               // true if the left flank of the gear touches
  std::vector<std::vector<Row>> positions_;  // over a pitch, including both ends
  // continuous_peak_to_peak() of the nominal pair minus its first-order estimate, rad
  double correction_ = 0.0;
};

/// Returns first-order estimates of the peak-to-peak TE, rad, for the first `count` samples of the
/// first replicate of a task.
///
/// Errors    as check_family(); nothing_touches() if the nominal pair loses contact
Result<std::vector<double>> linear_spans(const ContactSetup& setup, const ScatterTask& task,
                                         int count);

}  // namespace gearwright
