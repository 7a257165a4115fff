// Computes the phases of the meshes of a group of planets, and the harmonics that cancel because of
// these phases.
//
//   γ_i    delay of the mesh of copy i after the mesh of copy 0, in periods. The sun turns
//          counter-clockwise as seen from the carrier [T13.16]
//   R_k    fraction of harmonic k that remains in the torque and in the axial force [T13.18]
//   F_k^±  fraction of harmonic k that remains in a transverse force that turns with the sun (+) or
//          against the sun (−) [T13.18]
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <vector>

#include "gearwright/drive/assembly.hpp"

namespace gearwright {

/// Classification by the first harmonic. [T13.19]
enum class PhasingClass {
  in_phase,    ///< R = 1: torques add, forces cancel
  sequential,  ///< R = 0, and F^+ or F^− is 1: the whole rotating force remains
  counter,     ///< torques and forces cancel
  mixed,       ///< any other case: parts of torques and forces remain
};

struct Resultant {
  double torque, force_forward, force_backward;  ///< R_k, F_k^+, F_k^−
};

struct Phasing {
  PhasingClass kind = PhasingClass::mixed;
  std::vector<Resultant> resultants;  ///< for the harmonics 1, 2, …
};

/// Returns γ_i of a central gear with z teeth. z is < 0 for a ring.
///
/// Formula   γ_i = frac(z u_i); [T13.16]
std::vector<Rational> mesh_phases(int teeth, const std::vector<Rational>& turns);

/// Computes the class of the phasing and the remaining fractions of harmonics 1 to `harmonics`.
///
/// Formula   R_k = |Σ exp(−2πj k γ_i)|/N, F_k^± = |Σ exp(−2πj k γ_i ± 2πj u_i)|/N with j² = −1 and
///           sums over the copies i; [T13.18], [T13.19]
/// Domain    one phase for each element of `turns`, at least one (contract)
Phasing phasing(const std::vector<Rational>& phases, const std::vector<Rational>& turns,
                int harmonics);

/// Returns the delay, in periods, of the contact of a planet gear with a ring after the contact of
/// this planet gear with a sun. Both contacts are at the pitch points of the loaded flanks.
/// `share_1` and `share_2` are the ratios of the planet's tooth thickness to the pitch on its two
/// working pitch circles.
///
/// Formula   frac(z_p/2 ∓ (s_1/p_1 + s_2/p_2)/2), with − if the sun drives; [T13.17]
double sun_ring_phase(int planet_teeth, double share_1, double share_2, bool sun_drives);

}  // namespace gearwright
