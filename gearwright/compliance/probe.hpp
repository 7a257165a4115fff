// The compliance of a single tooth at one position, under a unit line force normal to the flank.
//
// It is used for comparisons with finite elements and measurements, and is the smallest user of the
// section, its modes and the contact kernel.  theory: docs/theory/12-loaded-contact.md, [T12.9]
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// A probe on the flank at y > 0 of tooth 0, which is the side of `outline`.
struct ComplianceProbe {
  double diameter = 0.0;                          ///< mm
  std::optional<std::array<double, 2>> loaded{};  ///< z from, to, mm; none for a load along a wide
                                                  ///< gear
  std::optional<double> half_width{};             ///< a  mm, of the Hertz strip; default 0.05 m_n
  std::vector<double> read{};                     ///< z  mm
};

struct ProbeAnswer {
  /// Deflection along the normal under the load. For a wide gear it is in mm per N/mm, otherwise
  /// the mean over the loaded part in mm per N.
  double own = 0.0;
  std::vector<double> profile;  ///< mm per N, at `read`
};

/// Errors    as make_section_mesh; `diameter` off the flank; `z` and `read_z` off the face
Result<ProbeAnswer> probe_compliance(const Gear& gear, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy);

/// The same for the gear's transverse section with a turn per mm that differs from that of its own
/// helix.
Result<ProbeAnswer> probe_compliance(const Gear& gear, double twist, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy);

/// The turn of a full disc from bore to root, or of an internal gear's rim from its outside to the
/// root, under a line force F′ at the base radius, as a displacement along the line of action:
/// E·u/F′. [T12.16]
double body_twist(double base_radius, double bore_radius, double root_radius, double poisson_ratio);

}  // namespace gearwright
