// Tooth contact, computed from the rotation to which each point of flank 1 pushes gear 2. This is
// the slowest method. It uses no normal and no curvature. Edges, corners and several tooth pairs
// need no special treatment.
//
//   ρ, ψ, z    cylindrical coordinates about a gear's axis
//   θ(ρ)       azimuth of a flank at z = 0
//   t(z)       turn of section z, helix and lead modifications
//   k          tooth pair: teeth k pitches later
//
// A point of flank 1, seen at rotation φ_1 from gear 2's tilted but unturned frame, lies on flank 2
// when
//
//   φ_2* = ψ_2 − θ_2(ρ_2) − t_2(z_2)    (next to the expected rotation φ_1 N_1/N_2, modulo a turn)
//
// and the position of gear 2 is the greatest φ_2* over all points that lie within the radii and
// faces of both flanks and less than half a turn about axis 1 from the centre line. The edges of
// gear 2 are the curves on flank 1 at which the bounds of gear 2 lie. The ends of the admitted part
// of a section are solved for, not sampled.
//
// The search evaluates sections z_1 at equal steps, and in each the admitted intervals of ρ_1 at
// equal steps. Every peak is refined (Brent in ρ, golden section in z). Golden section also
// converges to a bound of z, because there is no point beyond it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "tests/oracle/flank_surface.hpp"
#include "tests/oracle/mounting.hpp"

namespace gearwright::oracle::tca {

/// One flank in the frame of its gear. n is not used.
struct CloudFlank {
  std::function<Real(Real rho)> azimuth;  ///< θ(ρ)  continuous; next to 0 on gear 1
  std::function<Real(Real z)> turn;       ///< t(z)
  Real rho_low = 0, rho_high = 0;         ///< finite
  Real z_low = 0, z_high = 0;             ///< finite on gear 1
};

struct CloudPair {
  CloudFlank flank_1, flank_2;
  int teeth_1 = 0, teeth_2 = 0;
  Mounting mounting;
};

/// The position of the maximum: inside both flanks, on a bound of one flank, or where two bounds
/// meet. Coinciding faces on parallel axes count as face_1. `half_turn` is the bound of the search
/// itself.
enum class CloudKind { interior, root_1, tip_1, face_1, root_2, tip_2, face_2, half_turn, corner };

struct CloudTouch {
  Real rotation_2 = 0;  ///< φ_2
  int pair = 0;         ///< k
  CloudKind kind = CloudKind::interior;
  Real rho_1 = 0, z_1 = 0;
  Real rho_2 = 0, z_2 = 0;
  Vector3 point_f;
};

/// The resolution of the search. An admitted part of a face or of a section is missed if it is
/// smaller than a step.
struct CloudSteps {
  int sections = 100, radii = 48;
};

/// The contact of tooth pair k alone. φ_2 is the rotation of gear 2. Absent if no point of flank 1
/// is admitted.
/// Accuracy  φ_2 1e-15 rad. The position is accurate to 1e-9 of the flank on a smooth peak of
///           curvature 1, and on a flat one as far as φ_2 is constant. The bound of an edge is met
///           to 1e-15
std::optional<CloudTouch> cloud_touch_of_pair(const CloudPair& pair, Real rotation_1, int k,
                                              CloudSteps steps = {});

/// The pairs with an admitted point, among those whose teeth come near the centre line.
std::vector<CloudTouch> cloud_touches(const CloudPair& pair, Real rotation_1,
                                      CloudSteps steps = {});

/// The pair that carries the load.
std::optional<CloudTouch> cloud_touch(const CloudPair& pair, Real rotation_1,
                                      CloudSteps steps = {});

/// θ(ρ) of the flank of a circular arc between two rack angles. ρ must be monotone along it.
/// Throws    std::invalid_argument if ρ is not monotone, or for a ρ that is outside both ends by
///           more than 1e-12 of its value
class ArcOutline {
 public:
  ArcOutline(const ArcFlank& flank, Real theta_low, Real theta_high);

  Real theta(Real rho) const;       ///< the rack angle
  Real operator()(Real rho) const;  ///< the azimuth
  Real rho_low() const;
  Real rho_high() const;

 private:
  struct Node {
    Real theta, rho;
  };
  Node node(Real theta) const;

  ArcFlank flank_;
  std::vector<Node> nodes_;  // in ascending order of ρ
};

/// The flank of a circular arc with the lead errors. Its radii are those of the whole arc, |z| ≤
/// half_face.
CloudFlank cloud_flank(const ArcFlank& flank, Real theta_low, Real theta_high, LeadTurn lead,
                       Real half_face);

/// An involute flank with the lead errors.
CloudFlank cloud_flank(const InvoluteFlank& flank, Real rho_low, Real rho_high, LeadTurn lead,
                       Real half_face);

}  // namespace gearwright::oracle::tca
