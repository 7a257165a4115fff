// Teeth with unequal pitches, and flanks with waves, within the tolerances of a grade.
//
//   ε_k   angle by which tooth k is ahead, rad      r   reference radius, mm      χ   a phase
//   f_f   height of a wave, mm                          q   −1 to 1 over the usable flank or the face
//                                    theory: docs/theory/14-scatter.md, [T14.20], [T14.21]
// Internal to scatter/.
#pragma once

#include <vector>

#include "gearwright/gear/modifications.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// ε of every tooth: r ε_k = e sin(2πk/z + χ) + g_k, where g is a closed random walk that `share`, `phase`
/// and `eccentric` determine.
///
/// Formula   [T14.20]
/// Domain    share ≥ 0, 0 ≤ eccentric ≤ 1 (contract)
/// Laws      (1) the sum is 0   (2) r ε_k varies by at most share · F_pT, and no step exceeds f_ptT;
///           one of the two limits is reached
std::vector<double> uneven_pitch(const Gear& gear, const VaryingPitch& tolerance, double share,
                                 double phase, double eccentric);

struct FormWave {
  bool along_face;
  int waves;
  double phase;   ///< χ  rad
  double height;  ///< f_f  mm
};

/// Adds a wave to the modifications of both flanks: ½ f_f sin(π w q + χ).
///
/// Formula   [T14.21], by a spline with 16 points per wave
/// Accuracy  1e-3 of the height
/// Domain    waves ≥ 1; topographies made by this function only (contract)
void add_wave(std::array<FlankModifications, 2>& flanks, const FlankExtent& extent,
              const FormWave& wave);

}  // namespace gearwright
