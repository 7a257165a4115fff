// The compliance of a single tooth at one position, under a unit line force normal to the flank.
//
// It is used for comparisons with finite elements and measurements.
//                                      theory: docs/theory/12-loaded-contact.md, [T12.9]
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// A probe on the flank at y > 0 of tooth 0, which is the side of `outline`.
struct ComplianceProbe {
  double diameter = 0.0;                          ///< mm
  std::optional<std::array<double, 2>> loaded{};  ///< z of both ends of the load, mm; none for a
                                                  ///< uniform load on an infinitely wide gear
  std::optional<double> half_width{};             ///< a  mm, of the Hertz strip; default 0.05 m_n
  std::vector<double> read{};                     ///< z  mm, at which deflections are computed
};

struct ProbeAnswer {
  /// Deflection along the normal under the load: for an infinitely wide gear in mm per N/mm, otherwise
  /// the mean over the loaded part in mm per N.
  double own = 0.0;
  std::vector<double> profile;  ///< mm per N, at `read`
};

/// The compliance of a tooth of the gear.
///
/// Errors    as make_section_mesh; `diameter` if it is not on the flank; `z` and `read_z` if they are
///           not on the face
Result<ProbeAnswer> probe_compliance(const Gear& gear, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy);
/// The compliance of a tooth with the transverse section of the gear and another helix, whose section
/// turns by `twist`, rad/mm.
Result<ProbeAnswer> probe_compliance(const Gear& gear, double twist, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy);

/// Displacement along the line of action, E·u/F′, due to the twist of the body under a line force F′ at
/// the base radius. The body is a full disc from the bore to the root, or the rim of an internal gear
/// from its outside to the root. [T12.16]
double body_twist(double base_radius, double bore_radius, double root_radius, double poisson_ratio);

}  // namespace gearwright
