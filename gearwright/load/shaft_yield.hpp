// Computes the displacement of the flanks by the bending and the twist of the shafts. This
// displacement couples all places of contact along the face.
//
//   β_b, r_b, ρ   base helix angle; base radius and radius of curvature of a flank at a place
//   s_i           +1 or −1, sign of the moment of the axial force in the plane of action
//   S_ij          displacement along the normal at place i per normal force at place j, summed over
//                 both gears
//
// A normal force of 1 on a flank acts on the shaft as a force cos β_b along the line of action, a
// moment s_i ρ sin β_b in the plane of action, a moment r_b sin β_b perpendicular to this plane,
// and a torque r_b cos β_b. The displacement along the normal contains the same four parts, so S is
// symmetric.
//                                                theory: docs/theory/12-loaded-contact.md, [T12.35]
#pragma once

#include <array>
#include <vector>

#include "gearwright/contact/contact_pair.hpp"
#include "gearwright/load/pair_compliance.hpp"

namespace gearwright {

/// The linear and the parabolic part of an approach of the flanks along the common face, mm.
struct FaceDeflection {
  double slope = 0.0;  ///< S  increase over the common face, towards +z
  double bow = 0.0;    ///< B  height of the parabola in the middle
  bool any() const { return slope != 0.0 || bow != 0.0; }
};
/// Fits slope, bow and a constant to `approach` by least squares. `approach` contains the approach
/// in the middle of each of n equal slices, from −z to +z.
///
/// Formula   [T12.31]
/// Domain    at least three values (contract)
FaceDeflection face_deflection(const Eigen::VectorXd& approach);

class ShaftYield {
 public:
  /// Computes S for the shafts of the request. If the request has no shafts, S is 0.
  ///
  /// Domain    LoadRegime::line; `compliance` was computed for the same request (contract)
  ShaftYield(const ContactPair& pair, const Gear& one, const Gear& two,
             const PairCompliance& compliance, const LoadRequest& request);

  struct Place {
    /// Index of the slice, in the order of ascending z in the frame N.
    int slice;
    std::array<double, 2> radius;  ///< mm, on each gear
  };
  bool any() const { return shafts_[0].influence || shafts_[1].influence; }
  /// Returns S between these places, mm/N.
  ///
  /// Formula   [T12.35]
  Eigen::MatrixXd between(const std::vector<Place>& places) const;
  /// Returns S for a contact at the pitch point in every slice. The slices are in the order of
  /// ascending z in the housing frame.
  const Eigen::MatrixXd& at_pitch_point() const { return at_pitch_point_; }
  /// Returns slope and bow of the approach of the flanks. `line_load`, N/mm, has a value for each
  /// slice, in the order of ascending z in the housing.
  FaceDeflection under(const Eigen::VectorXd& line_load) const;

 private:
  struct OfGear {
    const ShaftInfluence* influence = nullptr;
    double base_radius = 0.0, sign = 0.0;
  };
  Eigen::MatrixXd yield(const std::vector<int>& slices,
                        const std::array<std::vector<double>, 2>& rho) const;

  std::array<OfGear, 2> shafts_;
  double sin_b_ = 0.0, cos_b_ = 1.0;
  bool reversed_;  // true if ascending z in the frame N is descending z in the housing
  FaceSlices slices_;
  Eigen::MatrixXd at_pitch_point_;
};

}  // namespace gearwright
