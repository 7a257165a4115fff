// Describes the finite elements of the transverse section of a gear. Some teeth are meshed with
// their exact outline. The rest of the rim has no teeth and ends at the root circle. The section is
// fixed at the bore. For an internal gear, it is fixed at the outside of the rim.
//
//   t    position along half an outline, counted in elements. t is 0 in the middle of the tooth
//        space and n, the number of elements, at the tip land
//   c    position across the tooth: 0 on the outline, 1 on the centre line of the tooth
//   Lengths in normal modules.                        theory: docs/theory/12-loaded-contact.md
//
// The centre line of tooth 0 is the x axis. Tooth k lies k pitches counter-clockwise from tooth 0.
// The mesh is symmetric about the x axis. Loads act on the side y > 0 of tooth 0.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

/// The fineness of a section mesh: numbers of elements along the outline and across the tooth.
struct SectionMeshOptions {
  int side_teeth = 1;  ///< number of teeth with their exact outline on each side of tooth 0, at
                       ///< most (|z| − 1)/2
  int fillet = 6;
  int flank = 7;
  int across = 3;
  int rim = 2;
  int body = 6;
  int rest = 10;            ///< elements around the smooth part of the rim
  double to_tip = 1.25;     ///< if > 1, the mesh is finer towards the tip, where contact ends
  double to_outline = 1.3;  ///< if > 1, the mesh is finer towards the outline
};

struct SectionMesh {
  std::vector<std::complex<double>> nodes;  ///< normal modules
  std::vector<std::array<int, 9>> elements;
  std::vector<int> bore;  ///< nodes that are fixed
  double outward = 1.0;   ///< 1 if the teeth point outwards, −1 for an internal gear
  /// The part of an outline from t = e to t = e + 1, where e is the index of the edge. This part is
  /// the side y = −1 of `element`. `forward` is true if x of the element increases with t.
  struct Edge {
    int element;
    bool forward;
  };
  std::vector<Edge> edges;                     ///< edges of tooth 0 on its side y > 0
  std::vector<std::vector<Edge>> tooth_edges;  ///< for each tooth, beginning with −side_teeth
  int fillet_begin = 0, flank_begin = 0, flank_end = 0;  ///< t at the ends of fillet and flank
  /// Nodes of each tooth, in the same order for all teeth. The first tooth is −side_teeth.
  std::vector<std::vector<int>> teeth;
  int side_teeth = 1;
  int tooth_count = 0;       ///< |z|
  double root_radius = 0.0;  ///< normal modules
  double bore_radius = 0.0;  ///< normal modules, radius at which the body is fixed

  /// A point on the exact outline of tooth 0: an arc and the position on it, 0 … 1.
  struct OnArc {
    const Arc* arc;
    double u;
  };
  OnArc arc_at(double t) const;
  std::complex<double> outline(double t) const;
  /// Returns the arc length of the outline from 0 to t, in normal modules.
  double length_at(double t) const;
  double parameter_at(double length) const;  ///< the inverse of length_at()

  std::vector<Arc> arcs;       ///< arcs of the outline except the tip land; lengths in mm
  double module = 1.0;         ///< m_n  mm
  std::vector<int> arc_begin;  ///< t at which each arc begins, and t at the end of the last arc
  double to_tip = 1.25;
  std::vector<double> lengths;  ///< arc lengths at kLengthSteps positions per element
};
/// Returns an error if a gear with this number of teeth has no mesh. An internal gear has z < 0.
std::optional<Error> too_few_teeth(int teeth);
/// Makes the mesh. For an internal gear, `bore_radius` is the outside radius of the rim.
///
/// Domain    0 < bore radius (contract)
/// Errors    `bore.diameter` if no rim remains; `teeth` if the gear has fewer than 3 teeth or no
///           flank, or if elements fold, which happens if the outline is too undercut or too pointed
///           for this mesh
Result<SectionMesh> make_section_mesh(const Outline& outline, double module, double bore_radius,
                                      const SectionMeshOptions& options);

}  // namespace gearwright
