// The spec's pair under torque, and probes of its teeth: the verb `load`.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/job/contact_setup.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

struct LoadAnswer {
  std::optional<LoadedContact> contact;      ///< none: only probes were asked
  std::optional<PairCompliance> compliance;  ///< of its teeth
  std::vector<ProbeAnswer> probes;           ///< of spec.load.probes
};

/// Of the root diameter: where a gear without a bore is held.
inline constexpr double kShaft = 0.5;

/// Errors    `load` without torque and probes; `gear2` missing; `pair.…` and `gearN.…` where loaded
///           contact is not made for such gears; `gearN.material.poisson_ratio`, `gearN.bore.…`,
///           `load.slices` too many, `load.probe[i].…`; as ContactSetup
Result<LoadAnswer> answer_load(SolvedJob& job, Progress* progress = nullptr);

/// Whether it refuses gears that loaded contact is not made for, and no number of the spec.
bool not_made_for_load(const Error& error);

/// The same under this one torque on gear 1, N m, with the other numbers of [load].
Result<LoadedContact> contact_under(SolvedJob& job, double torque, Progress* progress = nullptr);

/// The part of answer_load with a torque, made ready for one who takes it in steps: tables of the
/// teeth, positions, and at last judge_load.
struct LoadTask {
  ContactSetup setup;
  LoadRequest request;  ///< without progress
  bool gear2_drives = false;
  bool with_errors = false;  ///< or deflections

  ContactPair pair() const { return setup.pair(gear2_drives); }
  /// The same without errors, for K_Hα; none: there are none.
  std::optional<ContactPair> perfect_pair() const;
  Result<PairCompliance> compliance() const;
  LoadedContact contact(const PairCompliance& compliance) const;
};

/// Errors    as answer_load, and `load` without torque
Result<LoadTask> load_task(SolvedJob& job);

/// What there is to say against an answer; what it has to be read with becomes warnings of the job.
std::optional<Error> judge_load(SolvedJob& job, const LoadTask& task, const LoadedContact& found);

/// That an edge of a tooth carries under a torque, N mm.
Warning edge_carries_at(double torque);

/// What ISO 6336 says at each torque of an answer with contact, of solid discs; none where it says
/// nothing of such pairs.
std::vector<LoadStandard> load_standard(const SolvedJob& job, const LoadAnswer& answer);

LoadView load_view(const SolvedJob& job, const LoadAnswer& answer);

}  // namespace gearwright
