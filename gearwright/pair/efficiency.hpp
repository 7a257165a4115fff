// The efficiency of a pair under Coulomb friction.
//
//   μ    coefficient of friction, constant     w_1, w_2   speeds of the contact over the flanks
//   v_n = r_b1 cos β_b1   speed along the common normal, per radian of gear 1
//                                              theory: docs/theory/04-conjugate-action.md, 4.8
//
// The normal force is constant, and the tooth pairs in contact share it equally. Losses of
// bearings, oil and seals are not included.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/pair/mesh.hpp"

namespace gearwright {

struct Efficiency {
  std::optional<double> gear1_drives;  ///< η_12; none if gear 1 cannot drive (self-locking)
  std::optional<double> gear2_drives;
};

/// M_i is the component of w_i in the direction of sliding, averaged over the path and divided by
/// v_n. The efficiencies are η_12 = (1 + μ M_2)/(1 + μ M_1) and η_21 = (1 − μ M_1)/(1 − μ M_2).
/// [T4.27]
struct SlidingShares {
  double first, second;  ///< M_1, M_2; M_1 − M_2 is the mean sliding speed divided by v_n
};

/// The clipped path of contact. The speeds of the contact change linearly with ρ_1.
struct SlidingPath {
  double begin, end, step;  ///< range of ρ_1, mm; tooth pairs are `step` apart
  FlankSpeeds<double> at_begin, at_end;
  double normal_speed;  ///< v_n
};

/// M_1 and M_2, by integrals in closed form over each zone of the path. [T4.26]
///
/// Domain    begin < end, and the sliding speed is not the same at both ends (contract)
SlidingShares sliding_shares(const SlidingPath& path);
SlidingShares sliding_shares(const MeshInput<double>& in, const Mesh<double>& mesh);

/// The efficiencies η_12 and η_21 for the coefficient of friction μ.   Domain: μ ≥ 0 (contract)
Efficiency efficiency(const SlidingShares& shares, double friction);

// A zone of the line of action in which the number of tooth pairs in contact is constant.

struct ContactZone {
  double begin, end;  ///< mm of ρ_1
  int pairs;          ///< number of tooth pairs in contact; 0 beyond the end of the path if the
                      ///< contact ratio is below 1
};

/// Returns the zones of the path begin…end. A zone ends where a neighbouring tooth pair enters or
/// leaves contact. The distance between neighbouring pairs is `step`.
///
/// Domain    begin ≤ end, step > 0 (contract)
std::vector<ContactZone> contact_zones(double begin, double end, double step);

}  // namespace gearwright
