// The section of a tooth for its compliance: the mesh, the positions on the flank for tables, and
// the modes. It depends on the outline only, not on the face.
//
//   Lengths in normal modules, E = 1: a compliance is E·u·m_n/F, in plane strain E·u/F′.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <memory>
#include <optional>

#include "gearwright/compliance/half_space.hpp"
#include "gearwright/compliance/section_modes.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// draft: a coarser mesh and fewer modes, two to three times as fast.
enum class ComplianceAccuracy { full, draft };

/// The body of a gear, for its compliance.
struct ElasticBody {
  double bore_diameter = 0.0;  ///< mm, where the body is held; the outside of the rim of an
                               ///< internal gear
  double poisson_ratio = 0.3;
  double youngs_modulus = 206000.0;  ///< MPa
};

namespace detail {

struct ToothSection {
  SectionMesh mesh;
  SectionModes modes;
  double poisson_ratio = 0.3;
  double tau = 0.0;       ///< turn per length of the section, its loaded flank at y > 0
  std::vector<double> s;  ///< places along the flank, evenly spaced, arc length
  std::vector<double> c;  ///< half widths of their bumps
  double flank_lo = 0.0, flank_hi = 0.0;  ///< arc lengths of the flank's ends
  std::vector<Functional> bumps;          ///< along the normal of the screw surface

  std::vector<double> radius_lengths;  ///< arc length at even radii of the flank
  double radius_lo = 0.0, radius_hi = 0.0;

  /// Arc length at a radius, in modules; beyond the flank it continues linearly.
  double length_at_radius(double radius) const;
  /// Metric of the flank at a place.
  FlankMetric metric(double s) const;
};

/// Options for the section of a gear that turns by `twist` per mm, which is the gear's own value or
/// that of a probe.
SectionMeshOptions mesh_options(const Gear& gear, double twist, ComplianceAccuracy accuracy);
double mode_tolerance(ComplianceAccuracy accuracy, bool helical);

/// The half width of a bump at s: 0.3 modules, less near the tip.
double bump_width(double s, double flank_hi);

}  // namespace detail

/// `twist` is the turn per mm of the section whose loaded flank lies at y > 0.
///
/// `also`: one more position along the flank for which modes are computed. `progress`: as in
/// section_modes.
///
/// Domain    a gear with teeth (contract)
/// Errors    as make_section_mesh
Result<std::shared_ptr<const detail::ToothSection>> make_tooth_section(
    const Gear& gear, double twist, const ElasticBody& body, ComplianceAccuracy accuracy,
    std::optional<double> also = std::nullopt, Progress* progress = nullptr);

}  // namespace gearwright
