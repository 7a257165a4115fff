// The quantities of proposed flank modifications. A result contains them under `propose`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/proposed_flanks.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

/// The profile modifications of a proposal. They are those of the spec, or short or long reliefs.
/// The reliefs are either at the tips of both gears or at the tip and the root of gear 1.
enum class ProposedProfile { as_given, short_tips, long_tips, short_gear1, long_gear1 };

/// The amounts of a gear in mm. An amount is empty if the proposal keeps the value of the spec.
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
  bool pitch = false;  ///< true if the reliefs are also sufficient for the pitch deviations
  bool lead = false;   ///< true if a helix crowning, a helix slope or both are proposed
  std::array<ProposedGear, 2> gears{};
  std::vector<ProposedLoad> loads{};       ///< results for each torque
  LoadedScore worst = no_score();          ///< worst values over all torques
  std::optional<LoadedScore> at_limits{};  ///< worst values at both limits of the helix slope
                                           ///< deviation
  std::optional<Angle> without_load{};     ///< peak-to-peak transmission error of rigid teeth; none
                                           ///< if contact is lost
  /// Transmission error under the greatest torque: rotation of gear 1 in °, error in ″.
  std::vector<Vec2> transmission_error{};
  Value spec{};  ///< the whole spec with these modifications
};

struct ProposeView {
  double torque = 0.0;                                      ///< N mm, torque on gear 1 for which
                                                            ///< the amounts are computed
  std::optional<std::array<double, 2>> short_deflection{};  ///< C_i  mm, deflection at the tip of
                                                            ///< each gear with short reliefs
  std::optional<double> pitch_deviation{};     ///< mm, normal to the flank, of both gears together
  std::optional<double> helix_deviation{};     ///< mm, over the common face, of both gears together
  std::optional<FaceDeflection> deflection{};  ///< deflection of the shafts plus the deflection in
                                               ///< [load]
  std::vector<Proposal> proposals{};           ///< the first entry is the spec as given
  std::size_t recommended = 0;                 ///< index in `proposals`
  std::string reason{};
};

const Quantities<ProposeView>& propose_quantities();
const Quantities<Proposal>& proposal_quantities();

/// Returns the proposal in words, for example "short tip relief with f_pb, helix crowning".
std::string words_of(const Proposal& proposal);
/// Returns the indices of the proposals with the same spec as proposal `i`, beginning with `i`
/// itself. The list is empty if a proposal before `i` has the same spec.
std::vector<std::size_t> same_proposals(const std::vector<Proposal>& proposals, std::size_t i);
/// Returns the numbers and the words of all proposals in `same` except the first. An example is "3,
/// 4, 6: long tip relief; helix crowning; long tip relief, helix crowning". The text is empty if
/// `same` contains only one index.
std::string words_of_same(const std::vector<Proposal>& proposals,
                          const std::vector<std::size_t>& same);
/// Returns the amounts as text, for example "tip relief 12 µm from 79.123 mm, helix crowning 8 µm".
/// The text is empty if the gear is unchanged.
std::string amounts_of(const ProposedGear& gear);

}  // namespace gearwright
