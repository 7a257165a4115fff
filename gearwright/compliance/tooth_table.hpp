// Influence coefficients of the positions on a tooth's flank: tables over slices of the face and
// positions along the flank, used for all rotations, torques and errors.
//
//   C(s, z; s′, z′) = C_FE[b, b] − H[b, b] + H[a, a]                                       [T12.9]
//   The first two terms are the table, by cubic interpolation in s and s′; the third is computed
//   along the contact line. E = 1, lengths in normal modules: C is E·u·m_n/F, forces and
//   displacements are those of a whole slice.    theory: docs/theory/12-loaded-contact.md
#pragma once

#include <memory>
#include <vector>

#include "gearwright/compliance/root_points.hpp"
#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// The slices of the face, in normal modules from the middle of the face.
struct FaceSlices {
  int count = 32;
  double lo = 0.0, hi = 0.0;
  double width() const { return (hi - lo) / count; }
  double middle(int j) const { return lo + (j + 0.5) * width(); }
};

/// The arc length along the flank at which the contact line of a tooth crosses each slice;
/// arbitrary for slices that it does not cross.
using LinePlaces = std::vector<double>;

/// A place of the flank and the face, normal modules.
struct TablePlace {
  double s, z;
};

struct ToothTableRequest {
  double face_width = 0.0;  ///< of this gear, normal modules
  FaceSlices slices;
  double half_width = 0.05;      ///< a0 of H[a, a], normal modules
  double line_per_height = 1.0;  ///< length of a contact line per height, 1/cos β_b
  bool root_stress = true;
  Progress* progress = nullptr;  ///< eight steps for each place along the flank
};

class ToothTable {
 public:
  ToothTable(std::shared_ptr<const detail::ToothSection> section, const ToothTableRequest& request);

  const detail::ToothSection& section() const { return *section_; }
  /// Coefficients between the positions of one line; symmetric.
  Eigen::MatrixXd same_tooth(const LinePlaces& line) const;
  /// Displacements on the line of tooth `k` under forces on a line of tooth 0, k not 0. Beyond
  /// side_teeth(), the result is that of the last real tooth, because only the rotation of the body
  /// reaches that far.
  Eigen::MatrixXd other_tooth(int k, const LinePlaces& read, const LinePlaces& loaded) const;
  int side_teeth() const { return section_->mesh.side_teeth; }
  int slices() const { return n_; }

  /// Forces on the table's grid, with a row per slice and a column per place along the flank: the
  /// forces on the slices of a line, or a force of 1 at a place.
  Eigen::MatrixXd on_grid(const LinePlaces& line, const Eigen::VectorXd& force) const;
  Eigen::MatrixXd on_grid(const TablePlace& place) const;
  /// Displacement on tooth `k`, as a mean with the weights `read`, under forces on tooth 0, without
  /// the contact itself. It consists of the first two terms of [T12.9], where H is that of the half
  /// space alone. Its mirror image at a free end stays in C_FE, because no H[a, a] restores it.
  double yield(int k, const Eigen::MatrixXd& read, const Eigen::MatrixXd& loaded) const;

  /// Stress at the root points of tooth k, −1 … 1, under forces on the grid of tooth 0: adds to
  /// `stress`, six rows per point, a column per slice. E and lengths as above: σ·m_n²/F.
  void add_root_stress(int k, const Eigen::MatrixXd& force, Eigen::MatrixXd& stress) const;
  const detail::RootPoints& root() const { return root_; }

 private:
  struct Weights {
    int first;
    std::array<double, 4> w;
  };
  static Weights cubic(const std::vector<double>& places, double x);
  Weights weights(double s) const;
  void make(const ToothTableRequest& request);
  void make_local(const ToothTableRequest& request);
  double& entry(std::vector<double>& t, int i, int j, int k, int l) const;

  std::shared_ptr<const detail::ToothSection> section_;
  FaceSlices slices_;
  double half_face_ = 0.0;
  int n_ = 0, places_ = 0;
  std::vector<double> middles_;             // of the slices
  std::vector<double> same_;                // [load slice][read slice][load place][read place]
  std::vector<double> image_;               // as same_, of H[b, b] mirrored at the ends
  std::vector<std::vector<double>> other_;  // of tooth −side … side
  Eigen::MatrixXd hertz_;                   // H[a, a] of slices
  detail::RootPoints root_;
  // Of tooth −1, 0, 1: [load place](6·points·slices × load slices)
  std::vector<std::vector<Eigen::MatrixXd>> stress_;
};

}  // namespace gearwright
