// Computes linear functions of the amplitudes f(z) of the modes at one position along the face:
//
//   Σ_a v_a V f_a + s_a S f_a        over the nodes a of the face                          [T12.8b]
//
// V and S have a row for each function. The weights v and s of the nodes give, for example, the
// value and the slope at z. The amplitudes at the inner nodes are replaced by those at the ends of
// the element [T12.8a], so V K_ii⁻¹ K_ie and S K_ii⁻¹ K_ie are computed once for all positions.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include "gearwright/compliance/face.hpp"

namespace gearwright::detail {

class FaceReading {
 public:
  /// `of_slope` may be empty, if all slopes have the weight 0. `loads` and `face` must outlive the
  /// reading.
  FaceReading(const Face& face, const Face::Loads& loads, Eigen::MatrixXd of_value,
              Eigen::MatrixXd of_slope = {});

  /// Returns the functions under all loads, with a row for each function. `along` is the argument
  /// of Face::solve(), and `ends` contains its results side by side for all loads. The weights have
  /// an element for each node.
  Eigen::MatrixXd at(const Eigen::VectorXd& value, const Eigen::VectorXd& slope,
                     const Eigen::MatrixXd& along, const Eigen::MatrixXd& ends) const;

 private:
  // Functions of the amplitudes or of the slopes.
  struct Part {
    Eigen::MatrixXd of_node;                 // V or S
    std::array<Eigen::MatrixXd, 2> of_ends;  // V K_ii⁻¹ K_ie, for each inner node
    // V K_ii⁻¹ f, [inner node that is read][inner node that is loaded], with a column for each load
    std::array<std::array<Eigen::MatrixXd, 2>, 2> of_load;
  };
  Part part(const Face::Loads& loads, Eigen::MatrixXd of_node) const;

  const Face& face_;
  Part value_, slope_;
};

}  // namespace gearwright::detail
