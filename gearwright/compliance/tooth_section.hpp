// Contains the data of a tooth section from which the compliance is computed. They are the mesh,
// the positions on the flank that the tables use, and the modes, and they do not depend on the face
// width.
//
//   Lengths are in normal modules, and E = 1. A compliance is E·u·m_n/F, or E·u/F′ in plane strain.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <memory>
#include <optional>

#include "gearwright/compliance/half_space.hpp"
#include "gearwright/compliance/section_modes.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// `draft` uses a coarser mesh and fewer modes than `full` and is two to three times as fast.
enum class ComplianceAccuracy { full, draft };

/// The properties of the body of a gear on which the compliance depends.
struct ElasticBody {
  /// Diameter at which the body is fixed, mm. An internal gear is fixed at the outside of its rim.
  double bore_diameter = 0.0;
  double poisson_ratio = 0.3;
  double youngs_modulus = 206000.0;  ///< MPa
};

namespace detail {

struct ToothSection {
  SectionMesh mesh;
  SectionModes modes;
  double poisson_ratio = 0.3;
  double tau = 0.0;       ///< τ, rotation of the section per length; the loaded flank is at y > 0
  std::vector<double> s;  ///< evenly spaced positions along the flank, as arc lengths
  std::vector<double> c;  ///< half widths of the bumps at these positions
  double flank_lo = 0.0, flank_hi = 0.0;    ///< arc lengths at the ends of the flank
  std::vector<Functional> bumps;            ///< bumps along the normal of the screw surface
  std::vector<double> radius_lengths;       ///< arc lengths at evenly spaced radii of the flank
  double radius_lo = 0.0, radius_hi = 0.0;  ///< radii at the ends of the flank

  /// Returns the arc length at a radius, in modules, extrapolated linearly beyond the flank.
  double length_at_radius(double radius) const;
  FlankMetric metric(double s) const;
};

/// Returns mesh options for a section that turns by `twist` along the face, rad/mm.
SectionMeshOptions mesh_options(const Gear& gear, double twist, ComplianceAccuracy accuracy);
double mode_tolerance(ComplianceAccuracy accuracy, bool helical);

/// Returns the half width of a bump at s, which is 0.3 modules, or less near the tip.
double bump_width(double s, double flank_hi);
}  // namespace detail
/// Makes the section of a tooth whose loaded flank lies at y > 0. `twist` is the rotation of the
/// section along the face, rad/mm. `also` is an additional position on the flank for which modes
/// are computed, as an arc length in normal modules. `progress` counts as in section_modes().
///
/// Domain    a gear with teeth (contract)
/// Errors    as make_section_mesh
Result<std::shared_ptr<const detail::ToothSection>> make_tooth_section(
    const Gear& gear, double twist, const ElasticBody& body, ComplianceAccuracy accuracy,
    std::optional<double> also = std::nullopt, Progress* progress = nullptr);

}  // namespace gearwright
