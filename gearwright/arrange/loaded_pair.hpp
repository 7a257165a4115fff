// Computes a pair under torque and probes of its teeth: bodies, resolution, and a check that the result
// can be used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/arrange/load_input.hpp"
#include "gearwright/base/progress.hpp"
#include "gearwright/compliance/probe.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

/// The pair for contact analysis, with the modifications of its input.
///
/// Domain    a pair (contract)
/// Errors    as ContactSetup::of
Result<ContactSetup> setup_of(const Arranged& arranged, const ContactErrors& errors);

struct LoadAnalysis {
  std::optional<LoadedContact> contact;      ///< none if there are probes only
  std::optional<PairCompliance> compliance;  ///< of its teeth
  std::vector<ProbeAnswer> probes;           ///< of LoadInput::probes
  /// The halves of a double-helical pair at z > 0 and at z < 0, otherwise empty. If there are halves,
  /// the other results are those of the whole gears.
  std::vector<LoadAnalysis> halves{};
};

/// The position of a half of a double-helical pair. Each half is computed as a separate pair, and the
/// half at z < 0 as its mirror image.
struct HalfPlace {
  std::array<double, 2> middle{};  ///< mm, as ContactMount
  bool below = false;
  const PairCompliance* ready = nullptr;  ///< that of the other half, which has the same teeth
};

/// Fraction of the root diameter at which a gear without a bore is held.
inline constexpr double kShaft = 0.5;

/// The pair under each of the torques, and its probes. Warnings about limits of the result are added
/// to `warnings`.
///
/// Domain    torques or probes; torques need a pair (contract)
/// Errors    `pair.…` and `gearN.…` if loaded contact does not support such gears;
///           `gearN.material.poisson_ratio`, `gearN.bore.…`, `load.slices` if there are too many,
///           `load.probe[i].…`; as setup_of
Result<LoadAnalysis> loaded(const Arranged& arranged, const ContactErrors& errors,
                            const LoadInput& input, std::vector<Warning>& warnings,
                            Progress* progress = nullptr,
                            const std::optional<HalfPlace>& half = {});

/// The pair under the single torque `torque` on gear 1, N m, with the other numbers of `input`.
Result<LoadedContact> contact_under(const Arranged& arranged, const ContactErrors& errors,
                                    const LoadInput& input, double torque,
                                    std::vector<Warning>& warnings, Progress* progress = nullptr);

/// The computation of loaded() for torques, divided into steps: the compliance of the teeth, the
/// contact at all positions, and finally judge_load().
struct LoadTask {
  ContactSetup setup;
  LoadRequest request;  ///< without progress
  bool gear2_drives = false;
  bool with_errors = false;   ///< true with errors of mounting or deflections
  double torque_share = 1.0;  ///< of the torque on gear 1; 0.5 for a half of a double-helical gear

  ContactPair pair() const { return setup.pair(gear2_drives); }
  /// The same pair without errors, for K_Hα; none if there are no errors.
  std::optional<ContactPair> perfect_pair() const;
  Result<PairCompliance> compliance() const;
  LoadedContact contact(const PairCompliance& compliance) const;
};

/// Errors    as loaded(), and `load` without torque
Result<LoadTask> load_task(const Arranged& arranged, const ContactErrors& errors,
                           const LoadInput& input, std::vector<Warning>& warnings);

/// The reason why a result cannot be used. Warnings about limits of a usable result are added to
/// `warnings`.
std::optional<Error> judge_load(const LoadTask& task, const LoadedContact& found,
                                std::vector<Warning>& warnings);

/// The note that a gear without a bore is held at a default diameter, mm.
Warning held_without_bore(const std::string& gear, bool internal, double diameter);

/// The warning that an edge of a tooth carries load under a torque, N mm.
Warning edge_carries_at(double torque);

}  // namespace gearwright
