// Computes tables of influence coefficients between positions on the flanks of a gear. A position
// is given by a slice of the face and an arc length along the flank. The same tables are used for
// all rotations, torques and errors.
//
//   C(s, z; s′, z′) = C_FE[b, b] − H[b, b] + H[a, a]                                       [T12.9]
//                                                theory: docs/theory/12-loaded-contact.md
//
// The tables contain the first two terms, which are interpolated in s and s′ by cubics. The third
// term is computed along the contact line. Lengths are in normal modules and E = 1, so C is
// E·u·m_n/F. Each force is the total over a slice, and each displacement is the mean over a slice.
#pragma once

#include <memory>
#include <vector>

#include "gearwright/compliance/face.hpp"
#include "gearwright/compliance/root_points.hpp"
#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// Equal slices of the face or of a part of it, in normal modules unless mm are stated. z = 0 is
/// the middle of the face.
struct FaceSlices {
  int count = 32;
  double lo = 0.0, hi = 0.0;
  double width() const { return (hi - lo) / count; }
  double middle() const { return (lo + hi) / 2; }
  /// Returns the mirror image of the slices in the plane z = 0.
  FaceSlices reflected() const { return {count, -hi, -lo}; }
  double middle(int j) const { return lo + (j + 0.5) * width(); }
};

/// For each slice, the arc length along the flank at which the contact line of a tooth crosses the
/// slice. The value is arbitrary for slices that the line does not cross.
using LinePlaces = std::vector<double>;
/// A position on the flank: arc length s and height z, normal modules.
struct TablePlace {
  double s, z;
};

struct ToothTableRequest {
  double face_width = 0.0;  ///< whole face width of this gear, normal modules
  FaceSlices slices;
  double half_width = 0.05;      ///< half width a of the strip in H[a, a], normal modules
  double line_per_height = 1.0;  ///< length of the contact line per unit of height, 1/cos β_b
  bool root_stress = true;       ///< true if root stresses are to be computed
  Progress* progress = nullptr;  ///< counts two steps for each position along the flank, one for
                                 ///< each slice, another one with root stress, and two more
};

class ToothTable {
 public:
  ToothTable(std::shared_ptr<const detail::ToothSection> section, const ToothTableRequest& request);

  const detail::ToothSection& section() const { return *section_; }
  /// Returns the coefficients C between the slices of one contact line, as a symmetric matrix.
  Eigen::MatrixXd same_tooth(const LinePlaces& line) const;
  /// Returns the coefficients for displacements on the line `read` of tooth k (≠ 0) under forces on
  /// the line `loaded` of tooth 0. Rows are slices of `read`, and columns are slices of `loaded`.
  /// If |k| exceeds side_teeth(), the result for the farthest tooth in the finite-element mesh is
  /// returned, because only the rotation of the body has an effect at such distances.
  Eigen::MatrixXd other_tooth(int k, const LinePlaces& read, const LinePlaces& loaded) const;
  int side_teeth() const { return section_->mesh.side_teeth; }
  int slices() const { return n_; }

  /// Returns the forces that act on the slices of a line, distributed over the grid of the table.
  /// The grid has a row per slice and a column per position along the flank.
  Eigen::MatrixXd on_grid(const LinePlaces& line, const Eigen::VectorXd& force) const;
  /// Distributes a unit force at a position over the grid of the table.
  Eigen::MatrixXd on_grid(const TablePlace& place) const;
  /// Returns the displacement on tooth k, averaged with the weights `read`, under the forces
  /// `loaded` on tooth 0. The result is the sum of the first two terms of [T12.9] and does not
  /// include the deformation at the contact itself. The mirror images of H[b, b] beyond the ends of
  /// the face are omitted, because the corresponding images of H[a, a] are not part of the result.
  double yield(int k, const Eigen::MatrixXd& read, const Eigen::MatrixXd& loaded) const;
  /// Adds to `stress` the stresses σ·m_n²/F at the root points of tooth k (−1, 0 or 1) under forces
  /// on the grid of tooth 0. `stress` has six rows per point and a column per slice.
  void add_root_stress(int k, const Eigen::MatrixXd& force, Eigen::MatrixXd& stress) const;
  const detail::RootPoints& root() const { return root_; }

 private:
  struct Weights {
    int first;
    std::array<double, 4> w;
  };
  static Weights cubic(const std::vector<double>& places, double x);
  Weights weights(double s) const;
  // Interpolates in a table between load slice j and read slice l.
  double entry(const std::vector<double>& table, int j, const Weights& from, int l,
               const Weights& to) const;
  void make(const ToothTableRequest& request);
  void make_root_stress(const ToothTableRequest& request, const detail::Face& face,
                        const detail::Face::Loads& loads, const Eigen::MatrixXd& along,
                        const Eigen::MatrixXd& ends);
  void store(std::vector<double>& to, int l, const Eigen::Ref<const Eigen::MatrixXd>& u);
  // Returns the slice at −z if slice j is at z. For a spur gear, both slices have the same
  // coefficients.
  int mirrored(int j) const { return n_ - 1 - j; }
  // True if the coefficients of the mirror image of slice j are those of slice j, so that they are
  // not computed.
  bool has_image(int j) const { return mirrored(j) >= solved_; }
  void make_local(const ToothTableRequest& request);
  double& entry(std::vector<double>& t, int i, int j, int k, int l) const;

  std::shared_ptr<const detail::ToothSection> section_;
  FaceSlices slices_;
  double half_face_ = 0.0;
  int n_ = 0, places_ = 0;
  int solved_ = 0;  // the slices 0 … solved_ − 1 are loaded; the other ones are mirror images
  std::vector<double> middles_;  // middles of the slices
  // C_FE − H[b, b] of one tooth, in the order [load slice][read slice][load place][read place].
  std::vector<double> same_;
  // Mirror images of H[b, b] in the ends of the face, in the order of same_.
  std::vector<double> image_;
  std::vector<std::vector<double>> other_;  // C_FE of teeth −side … side, without tooth 0
  Eigen::MatrixXd hertz_;                   // H[a, a] between slices
  detail::RootPoints root_;
  // Stresses of teeth −1, 0 and 1: [tooth][load place], each a matrix with 6·points·slices rows and
  // a column per load slice.
  std::vector<std::vector<Eigen::MatrixXd>> stress_;
};

}  // namespace gearwright
