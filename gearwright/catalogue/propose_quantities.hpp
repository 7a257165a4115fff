// The quantities of proposed flank modifications: `propose` of a result.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/proposed_flanks.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/load/loaded_score.hpp"

namespace gearwright {

/// The profile modifications of a proposal: those of the spec, or reliefs of a length at the tips of
/// both gears, or at the tip and the root of gear 1.
enum class ProposedProfile { as_given, short_tips, long_tips, short_gear1, long_gear1 };

/// The amounts of a gear, mm; none where the proposal leaves those of the spec.
struct ProposedGear {
  std::optional<double> tip_relief{}, tip_start{};
  std::optional<double> root_relief{}, root_start{};
  std::optional<double> lead_crowning{}, lead_slope{};
};

struct ProposedLoad {
  double torque;  ///< N mm
  LoadedScore score;
};

struct Proposal {
  ProposedProfile profile = ProposedProfile::as_given;
  bool pitch = false;  ///< with pitch deviations in the amounts of the reliefs
  bool lead = false;   ///< with helix crowning and slope
  std::array<ProposedGear, 2> gears{};
  std::vector<ProposedLoad> loads{};       ///< at each torque
  LoadedScore worst = no_score();          ///< of all torques
  std::optional<LoadedScore> at_limits{};  ///< at the greatest helix slope deviations, the worst
  /// Loaded transmission error under the greatest torque, over the rotation of gear 1: °, ″.
  std::vector<Vec2> transmission_error{};
  Value spec{};  ///< the whole spec with these modifications
};

struct ProposeView {
  double torque = 0.0;                                      ///< N mm, on gear 1, of the amounts
  std::optional<std::array<double, 2>> short_deflection{};  ///< C_i  mm
  std::optional<double> pitch_deviation{};     ///< mm, normal to the flank, of both gears together
  std::optional<double> helix_deviation{};     ///< mm, over the common face, of both gears together
  std::optional<FaceDeflection> deflection{};  ///< of the shafts, or as given
  std::vector<Proposal> proposals{};           ///< the spec as given first
  std::size_t recommended = 0;                 ///< index
  std::string reason{};
};

const Quantities<ProposeView>& propose_quantities();
const Quantities<Proposal>& proposal_quantities();

/// "short tip relief with f_pb, helix crowning"
std::string words_of(const Proposal& proposal);
/// "tip relief 12 µm from 79.123 mm, helix crowning 8 µm"; empty if the gear is as given.
std::string amounts_of(const ProposedGear& gear);

}  // namespace gearwright
