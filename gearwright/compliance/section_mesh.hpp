// Finite elements of the transverse section of a gear: some teeth with their exact outline, and the
// rest of the rim smooth at the root circle. The section is held at the bore. An internal gear,
// whose teeth point inwards, is held at the outside of its rim.
//
//   t    place along half an outline: element by element, from the middle of the space (0) to the
//        end of the side at the tip land (n)
//   c    across: 0 on the outline, 1 on the tooth's centre line
//   Lengths in normal modules.                        theory: docs/theory/12-loaded-contact.md
//
// The tooth's centre line is the x axis, tooth k is k pitches counter-clockwise of it. The mesh
// is its own mirror image. Loads act on the side y > 0 of tooth 0.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

/// The fineness of a section mesh, as numbers of elements along the outline and across.
struct SectionMeshOptions {
  int side_teeth = 1;  ///< real teeth on either side of tooth 0
  int fillet = 6;
  int flank = 7;
  int across = 3;
  int rim = 2;
  int body = 6;
  int rest = 10;            ///< around the smooth part of the rim
  double to_tip = 1.25;     ///< if > 1, finer towards the tip, where contact ends
  double to_outline = 1.3;  ///< if > 1, finer towards the outline
};

struct SectionMesh {
  std::vector<std::complex<double>> nodes;  ///< normal modules
  std::vector<std::array<int, 9>> elements;
  std::vector<int> bore;  ///< nodes that are held
  double outward = 1.0;   ///< 1 if the teeth point outwards, −1 for an internal gear
  /// The outline of tooth 0 on its side y > 0: element e carries t from e to e + 1 on its side
  /// y = −1, with x growing with t or against it.
  struct Edge {
    int element;
    bool forward;
  };
  std::vector<Edge> edges;
  std::vector<std::vector<Edge>> tooth_edges;  ///< edges of each tooth, from −side_teeth on
  int fillet_begin = 0, flank_begin = 0, flank_end = 0;  ///< elements of the outline
  /// Nodes of tooth k in one order for all teeth, k from −side_teeth on.
  std::vector<std::vector<int>> teeth;
  int side_teeth = 1;
  int tooth_count = 0;       ///< |z|
  double root_radius = 0.0;  ///< normal modules
  double bore_radius = 0.0;  ///< radius at which the body is held

  /// The exact outline of tooth 0: the arc, the position on it, 0 … 1, and the point.
  struct OnArc {
    const Arc* arc;
    double u;
  };
  OnArc arc_at(double t) const;
  std::complex<double> outline(double t) const;
  /// Arc length from t = 0, and back.
  double length_at(double t) const;
  double parameter_at(double length) const;

  std::vector<Arc> arcs;  ///< without the tip land; lengths in mm
  double module = 1.0;    ///< m_n  mm
  std::vector<int> arc_begin;
  double to_tip = 1.25;
  std::vector<double> lengths;  ///< at kLengthSteps places per element
};

/// Domain    0 < bore radius (contract), which is the outside radius of the rim of an internal gear
/// Errors    `bore.diameter` that leaves no rim; `teeth` where elements fold: the outline is undercut
///           or pointed beyond what this mesh can follow
Result<SectionMesh> make_section_mesh(const Outline& outline, double module, double bore_radius,
                                      const SectionMeshOptions& options);

}  // namespace gearwright
