// Flank modifications that follow from the load, the tolerances and the shafts: tip and root reliefs,
// helix crowning and slope.
//
//   C_i        least tip relief of gear i under the load [T12.27]          f_pt   single pitch
//   C_a, C_f   tip and root relief              C_Hβ, C_β   helix slope and crowning
//   δ(x)       approach of the flanks by deflection of the shafts, x = z/b      f_Hβ   helix slope
//   S, B       its slope over the face and the height of its parabola
//
// Amounts are normal to the flank, and whole µm.      theory: docs/theory/12-loaded-contact.md
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/arrange/relief_start.hpp"
#include "gearwright/rating/shaft_misalignment.hpp"

namespace gearwright {

struct LeadProposal {
  double slope = 0.0, crowning = 0.0;  ///< C_Hβ, C_β  mm, of gear 1
  bool any() const { return slope != 0.0 || crowning != 0.0; }
};

/// Reliefs at the tips of both gears. A tip and a root relief of gear 1 can replace them, because the
/// root of gear 1 meets the tip of gear 2.
struct ReliefProposal {
  ReliefLength length = ReliefLength::short_relief;
  std::array<double, 2> deflection{};  ///< C_i  mm, due to the load
  /// False if the tip of a gear still carries load with the greatest relief.
  std::array<bool, 2> unloaded{true, true};
  std::array<double, 2> tip_start{};  ///< mm, diameters, rounded to 1 µm
  double root_start = 0.0;            ///< mm, of gear 1
  double root_factor = 1.0;  ///< C_f over C_a2: the flank of gear 1 begins below the first contact

  /// C_a of each gear and C_f of gear 1, mm. `pitch_deviation`: of both gears together, mm, normal
  /// to the flank.
  std::array<double, 2> tip_amount(double pitch_deviation) const;
  double root_amount(double pitch_deviation) const;
};

/// The reliefs for the errors and deflections of the task, with the helix modifications of the input,
/// or with those of `lead` instead.
///
/// Formula   [T12.28], [T12.29], [T12.30]
/// Domain    a pair with line contact, tables of its teeth (contract)
/// None      if the pair has no reliefs of this length: ε_α ≤ 1, or ≥ 2 for long ones
/// Errors    as unloaded_tips()
Result<std::optional<ReliefProposal>> propose_relief(const Arranged& arranged, const LoadTask& task,
                                                     const PairCompliance& compliance,
                                                     ReliefLength length,
                                                     const LeadProposal* lead = nullptr);

/// The deflection of the shafts as `load` uses it, mm.
struct FaceDeflection {
  double slope = 0.0;  ///< S  over the common face, > 0 towards +z
  double bow = 0.0;    ///< B  in the middle
  bool any() const { return slope != 0.0 || bow != 0.0; }
};

/// The part of the deflection of both shafts under a torque on gear 1, N mm, that is linear and
/// parabolic along the face, normal to the flank.
///
/// Formula   [T12.31]
/// Domain    a gear with a shaft is external (contract)
FaceDeflection face_deflection(const RatedPair& pair, const MeshShafts& shafts, double torque);

/// `face_1` is the face of gear 1 and `face` the common one, mm. `deviation`: f_Hβ of both gears
/// together over the common face, mm, normal to the flank.
///
/// Formula   [T12.32]
LeadProposal propose_lead(const FaceDeflection& deflection, double deviation, double face_1,
                          double face);

}  // namespace gearwright
