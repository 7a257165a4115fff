// Computes a pair under torque, and the compliance at probes of its teeth. The gear bodies and the
// resolution are chosen here, and the result is checked for validity.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/arrange/load_input.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/base/progress.hpp"
#include "gearwright/compliance/probe.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

/// Returns the pair for contact analysis, with the given flank modifications.
///
/// Domain    a pair (contract)
/// Errors    as ContactSetup::of()
Result<ContactSetup> setup_of(const Arranged& arranged, const ContactErrors& errors);

struct LoadAnalysis {
  std::optional<LoadedContact> contact;      ///< none if the input contains only probes
  std::optional<PairCompliance> compliance;  ///< compliance of the teeth
  std::vector<LoadStandard> standard;        ///< result of load_standard() for `contact`
  std::vector<ProbeAnswer> probes;           ///< results of LoadInput::probes
  /// The halves of a double-helical pair at z > 0 and z < 0; empty for other gears. If there are
  /// halves, the other members describe the whole gears. Each half carries half of the torque, so
  /// the values of the standard for one half apply to the whole gears.
  std::vector<LoadAnalysis> halves{};
};

/// One half of a double-helical pair. Each half is computed as a separate pair, and the half at z <
/// 0 is replaced by its mirror image.
struct HalfPlace {
  bool below = false;
  const PairCompliance* ready = nullptr;  ///< compliance of the other half if both halves have
                                          ///< equal teeth; null if it must be computed
};

/// The diameter at which a gear without a bore is held, as a fraction of the root diameter.
inline constexpr double kShaft = 0.5;

/// Returns the results of the pair under each of the torques, and the results of the probes.
/// Warnings about the validity of the result are added to `warnings`.
///
/// Domain    torques need a pair (contract)
/// Errors    `load.torques` without torques and probes, and if a torque is not > 0; `load.driver`
///           if it is not 1 or 2; `pair.…` and `gearN.…` if loaded contact does not support such
///           gears; `load.deflection_…` and `gearN.shaft` for point contact; the member that causes
///           a deflection if no teeth touch under it; `load.torques` if the forces converge at no
///           position; `gearN.material.youngs_modulus`, `gearN.material.poisson_ratio`,
///           `gearN.bore.…`, `load.slices` if there are too many, `load.probe[i].…`; the errors of
///           setup_of
Result<LoadAnalysis> loaded(const Arranged& arranged, const ContactErrors& errors,
                            const LoadInput& input, std::vector<Warning>& warnings,
                            Progress* progress = nullptr,
                            const std::optional<HalfPlace>& half = {});

/// Returns the result under `torque` on gear 1, N m. All other numbers come from `input`.
Result<LoadedContact> contact_under(const Arranged& arranged, const ContactErrors& errors,
                                    const LoadInput& input, double torque,
                                    std::vector<Warning>& warnings, Progress* progress);

/// The computation that loaded() performs for the torques, divided into steps. The steps are the
/// compliance of the teeth, the contact at all positions, and judge_load().
struct LoadTask {
  ContactSetup setup;
  LoadRequest request;  ///< without `progress`
  bool gear2_drives = false;
  bool with_errors = false;   ///< true if there are errors of mounting or deflections
  double torque_share = 1.0;  ///< share of the torque on gear 1; 0.5 for one half of a
                              ///< double-helical gear

  ContactPair pair() const { return setup.pair(gear2_drives); }
  /// Returns the pair without errors, the reference for K_Hα, or none if there are no errors.
  std::optional<ContactPair> perfect_pair() const;
  Result<PairCompliance> compliance() const;
  LoadedContact contact(const PairCompliance& compliance) const;
};

/// Errors    as loaded(); `load.torques` if no torque is given, even if there are probes
Result<LoadTask> load_task(const Arranged& arranged, const ContactErrors& errors,
                           const LoadInput& input, std::vector<Warning>& warnings,
                           const std::optional<HalfPlace>& half = {});

/// Returns LoadTask::contact() as the only element of a list, for SliceResolutions::solve().
std::vector<LoadedContact> one_contact(const LoadTask& task, const PairCompliance& compliance);

/// Halves both numbers of slices, but not below kLeastSlices. Returns false if neither number can
/// be reduced. See SliceResolutions.
bool halve_slices(std::array<int, 2>& slices);

/// Returns the contact for the helix slope deviations −`deviation` and +`deviation`, without root
/// stress and at no more than 16 positions per pitch. `deviation` is in mm over the common face,
/// normal to the flank. If the request contains rotations, they are used instead of these
/// positions.
std::vector<LoadedContact> contacts_at_limits(const LoadTask& task,
                                              const PairCompliance& compliance, double deviation);

/// Returns the reason why a result cannot be used. If it can be used, returns none and adds
/// warnings about the validity of the result to `warnings`.
std::optional<Error> judge_load(const LoadTask& task, const LoadedContact& found,
                                std::vector<Warning>& warnings);

/// Returns the note that a gear without a bore is held at a default diameter, mm. `code` is
/// held_at_half_the_root or held_at_rim_as_drawn.
Warning held_without_bore(const std::string& gear, WarningCode code, double diameter);

/// Returns the warning that an edge of a tooth carries load under these torques, N mm.
Warning edge_carries_at(const std::vector<double>& torques);

// Mesh stiffness and root stress according to ISO 6336, for comparison with the results of loaded
// contact.

/// Returns the values of ISO 6336 for solid discs, at each torque for which `answer` contains
/// contact. The list is empty if the standard does not cover the pair.
std::vector<LoadStandard> load_standard(const Arranged& arranged, const LoadAnalysis& answer);

/// Adds a note for each torque at which the mean stiffness differs from c_γα by more than a
/// quarter. The note contains the factor of each cause of the difference and the remaining factor.
///
/// Domain    a result of this task with contact (contract)
void explain_stiffness(const Arranged& arranged, const LoadTask& task, const LoadAnalysis& answer,
                       std::vector<Warning>& warnings);

/// Computes each half of a double-helical pair under half of the torque, and combines the results.
/// `arranged` contains the half at z > 0. The deflections in `input` refer to the whole face
/// including the gap. If the faces differ, they refer to the face of the narrower gear.
///
/// Domain    `halves` of both gears (contract)
/// Errors    as loaded()
Result<LoadAnalysis> loaded_halves(const Arranged& arranged,
                                   const std::array<std::optional<Halves>, 2>& halves,
                                   const ContactErrors& errors, const LoadInput& input,
                                   std::vector<Warning>& warnings, Progress* progress = nullptr);

/// Returns the tasks of the half at z > 0 and of the mirror image of the other half.
///
/// Domain    `halves` of both gears (contract)
/// Errors    as load_task()
Result<std::vector<LoadTask>> load_tasks_of_halves(
    const Arranged& arranged, const std::array<std::optional<Halves>, 2>& halves,
    const ContactErrors& errors, const LoadInput& input, std::vector<Warning>& warnings);

/// True if the load distributions of both halves are mirror images of each other. In this case,
/// only one half is computed.
bool equal_halves(const Halves& halves, const ContactErrors& errors, const LoadInput& input);

/// Derives the input for one half from the input for the whole gears. It has half of the torque,
/// and the deflections over this half. If `below` is true, the half is at z < 0, and its rotations
/// and the direction of z are those of its mirror image. Probes are omitted.
LoadInput input_of_half(const LoadInput& whole, const Halves& narrower, const Gear& gear_1,
                        bool below);

}  // namespace gearwright
