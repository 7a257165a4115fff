// Proposes flank modifications that follow from load, tolerances and shaft deflection: tip and root
// reliefs, helix crowning and helix slope.
//
//   C_i        least tip relief of gear i under the load [T12.27]   f_pt  single pitch deviation
//   C_a, C_f   tip and root relief              C_Hβ, C_β   helix slope and crowning modification
//   δ(x)       approach due to shaft deflection, x = z/b    f_Hβ  helix slope deviation
//   S, B       slope of δ over the face, and height of its parabola
//
// Amounts are normal to the flank, in whole µm.     theory: docs/theory/12-loaded-contact.md
#pragma once

#include <array>
#include <optional>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/arrange/loaded_pair.hpp"

namespace gearwright {

// Computes where short and long reliefs start. If only the amount of a relief is given, the
// relief is short.
//
//   ε_α   transverse contact ratio over the usable flanks       p_bt   transverse base pitch
//   ρ     radius of curvature of a flank, which gives the position on the path of contact
//
// Short tip reliefs on both gears leave one base pitch of the path without relief, so an
// unrelieved tooth is always in contact. Each relief covers half of the remaining path,
// (ε_α − 1) p_bt/2. A long relief covers (ε_α − 1) p_bt. It ends where single pair contact
// begins. The root relief of a gear has the same length as its tip relief and lies at the
// opposite end of the path.
//                                       theory: docs/theory/12-loaded-contact.md

enum class ReliefLength { short_relief, long_relief };

/// Start diameters of the tip relief and of the root relief of gear `which`, mm. relief_starts()
/// returns none if the contact ratio of the flanks is at most 1. It also returns none for long
/// reliefs if the contact ratio is at least 2, because there is then no single pair contact.
///
/// Formula   [T12.29]
struct ReliefStarts {
  double tip, root;
};
std::optional<ReliefStarts> relief_starts(const ParallelPair& pair, int which,
                                          ReliefLength length = ReliefLength::short_relief);

/// True if some tip or root relief has an amount but no start.
bool lacks_relief_start(const GivenPair& given);
/// Returns the error about the first relief that has no start, for a gear without a mating gear.
/// Such a gear needs a given start, because the start can be computed only for a pair.
///
/// Domain lacks_relief_start(given)
Error missing_relief_start(const GivenPair& given);

/// Computes the start of each tip or root relief that has none, on both gears of a pair.
///
/// Errors    `gearN.modifications.tip_relief.reach` or `….root_relief.reach` if the pair allows no
///           such start
std::optional<Error> place_reliefs(GivenPair& given, const Pair& pair);

struct LeadProposal {
  double slope = 0.0, crowning = 0.0;  ///< C_Hβ, C_β  mm, of gear 1
  bool any() const { return slope != 0.0 || crowning != 0.0; }
};

/// The proposal contains a relief at the tip of each gear. A tip relief and a root relief on gear 1
/// alone are equivalent, because the root of gear 1 meets the tip of gear 2.
struct ReliefProposal {
  ReliefLength length = ReliefLength::short_relief;
  std::array<double, 2> deflection{};  ///< C_i  mm, due to the load
  /// False if the tip of the gear carries load even with the greatest relief.
  std::array<bool, 2> unloaded{true, true};
  std::array<double, 2> tip_start{};  ///< mm, diameters, rounded to 1 µm
  double root_start = 0.0;            ///< mm, diameter on gear 1
  double root_factor = 1.0;  ///< C_f/C_a2; > 1 if the usable flank of gear 1 starts below its first
                             ///< point of contact

  /// Return C_a of each gear, and C_f of gear 1, mm. `pitch_deviation` is f_pt of both gears
  /// together, mm, normal to the flank.
  std::array<double, 2> tip_amount(double pitch_deviation) const;
  double root_amount(double pitch_deviation) const;
};

/// Returns the reliefs for the errors and deflections of the task. If `lead` is given, it replaces
/// the flank modifications of the task.
///
/// Formula   [T12.28], [T12.29], [T12.30]
/// Domain    a pair with line contact, and the compliance of its teeth (contract)
/// None      if reliefs of this length are impossible: ε_α ≤ 1, or ε_α ≥ 2 for long reliefs
/// Errors    as unloaded_tips() and ContactSetup::with_modifications()
Result<std::optional<ReliefProposal>> propose_relief(const Arranged& arranged, const LoadTask& task,
                                                     const PairCompliance& compliance,
                                                     ReliefLength length,
                                                     const LeadProposal* lead = nullptr);

/// Returns the deflection that the shafts have under a torque on gear 1, N mm, plus the given
/// deflection. The load is assumed to be uniform over the face, because the proposed helix slope
/// compensates the deflection and thus makes the load uniform.
///
/// Formula   [T12.31], [T12.37]
/// Domain    a pair with line contact, and its compliance (contract)
FaceDeflection face_deflection(const LoadTask& task, const PairCompliance& compliance,
                               double torque);

/// Returns the helix slope and the crowning of gear 1 that compensate a deflection and a deviation.
///
/// `face_1` is the face of gear 1 and `face` the common face, mm. `deviation` is f_Hβ of both gears
/// together over the common face, mm, normal to the flank.
///
/// Formula   [T12.32]
LeadProposal propose_lead(const FaceDeflection& deflection, double deviation, double face_1,
                          double face);

}  // namespace gearwright
