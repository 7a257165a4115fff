// Makes the drive of a candidate of a search: chooses its profile shifts, its modules and its face
// width, rates it and judges it. Internal to job/.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "gearwright/catalogue/drive_search_quantities.hpp"
#include "gearwright/design/train_strength.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// A design, the reason why a candidate is left out, or an error of the spec.
using DriveOutcome = std::variant<FoundDrive, DriveFault, Error>;

class DriveDesigner {
 public:
  DriveDesigner(const JobSpec& spec, const DriveSearchProblem& problem);

  /// If the search gives no profile shifts, several are tried, and the best design by the
  /// objectives is returned.
  DriveOutcome operator()(DriveCandidate candidate) const;
  /// A train with its greatest face width and, for each stage, the greatest safeties over all trials
  /// of profile shifts. None if the train cannot be rated.
  std::optional<RatedTrain> rated(DriveCandidate candidate) const;
  /// The least specific sliding of a train over all trials of profile shifts. It is 0 if the teeth
  /// cannot be made, because this is another reason to leave a train out.
  double least_sliding(DriveCandidate candidate) const;
  /// The safeties that every design must have.
  StageSafety required() const;
  bool rates() const { return rates_; }

 private:
  struct MadeDrive;

  std::vector<GearShifts> trials(DriveCandidate candidate) const;
  bool is_better(const DriveOutcome& a, const DriveOutcome& b) const;
  std::optional<std::vector<StageSafety>> stage_safeties(const DriveCandidate& candidate) const;
  DriveOutcome with_stage_modules(DriveCandidate candidate) const;
  DriveOutcome sized(DriveCandidate candidate) const;
  std::optional<MadeDrive> made_from(const DriveCandidate& candidate) const;
  DriveOutcome with_width(DriveCandidate candidate) const;

  const JobSpec& spec_;
  const DriveSearchProblem& problem_;
  bool rates_;
};

}  // namespace gearwright
