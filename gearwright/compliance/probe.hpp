// Computes the compliance of a single tooth under a unit line force normal to its flank, for
// comparison with finite elements and measurements.
//                                      theory: docs/theory/12-loaded-contact.md, [T12.9]
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// The load on the flank at y > 0 of tooth 0, which is the flank that the verb `outline` prints.
struct ComplianceProbe {
  double diameter = 0.0;  ///< d_y  mm, diameter at which the load acts
  /// z of both ends of the load, mm. If absent, the load is uniform on an infinitely wide gear.
  std::optional<std::array<double, 2>> loaded{};
  std::optional<double> half_width{};  ///< a  mm, of the Hertz strip; 0.05 m_n if absent
  std::vector<double> read{};          ///< z  mm, positions of the computed deflections
};

struct ProbeAnswer {
  /// Deflection along the normal at the position of the load. For an infinitely wide gear, the
  /// unit is mm per N/mm. Otherwise it is mm per N, and the value is the mean over the loaded
  /// part of the face.
  double own = 0.0;
  std::vector<double> profile;  ///< deflection at each z of `read`, mm per N
  bool wide = false;            ///< true for an infinitely wide gear, in plane strain
};

/// Computes the compliance of a tooth of the gear at the position of the probe.
///
/// Errors    as make_section_mesh; `diameter` if it does not lie on the flank or is less than 0.02
///           modules, in radius, from its tip end; `z` if it does not contain two ascending
///           positions on the face; `read_z` if a position does not lie on the face
Result<ProbeAnswer> probe_compliance(const Gear& gear, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy);
/// Computes the compliance of a tooth that has the transverse section of the gear but another
/// helix. The section of this tooth turns by `twist` along the face, rad/mm.
Result<ProbeAnswer> probe_compliance(const Gear& gear, double twist, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy);

/// Returns E u/F′, where u is the displacement along the line of action due to the twist of the
/// body under a line force F′ at the base radius. The body is the full disc between bore and root,
/// or the rim of an internal gear between its roots and its outside diameter. [T12.16]
double body_twist(double base_radius, double bore_radius, double root_radius, double poisson_ratio);

}  // namespace gearwright
