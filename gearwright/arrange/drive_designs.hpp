// Computes the designs of a search for drives. The candidates are computed in their order, in the
// same way as by the verb `drive`. They are also rated if the search requires safeties. A candidate
// is listed if its verdict is green.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/design/drive_search.hpp"
#include "gearwright/design/train_strength.hpp"
#include "gearwright/drive/drive.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// A drive in the result of a search. Its verdict is green.
struct FoundDrive {
  DriveCandidate candidate;
  Drive drive;
};

/// The reasons why a computed candidate is left out.
enum class DriveFault { no_teeth, neighbours, sliding, overlap, safety, verdict };
inline constexpr std::array<std::string_view, 6> kDriveFaultNames{
    "no_teeth", "neighbours", "sliding", "overlap", "safety", "verdict"};

struct DriveDesigns {
  std::vector<FoundDrive> list;     ///< in the order of drive_designs()
  std::vector<std::size_t> pareto;  ///< indices in `list`
  std::size_t computed = 0;
  std::size_t green = 0;         ///< computed candidates with a green verdict
  std::size_t hopeless = 0;      ///< trains that were left out because their estimated safeties are
                                 ///< too small or, if each stage has its own module, because they
                                 ///< are too large
  std::size_t beyond_limit = 0;  ///< candidates that were not computed because of
                                 ///< kMostComputedDrives; 0 if `top` drives were found
  std::array<std::size_t, kDriveFaultNames.size()> left_out{};
};

/// A search for drives, and the inputs that its designs need.
struct DriveDesignTask {
  DriveSearchProblem problem;
  double face_step;     ///< mm; step of the face widths from which the search chooses
  Safeties required{};  ///< of every mesh
  /// Rates the meshes of a drive. Empty if the designs are not rated.
  std::function<std::optional<Error>(Drive&)> rate{};
  Progress* progress = nullptr;
};

/// Returns the `top` best drives and, if there are several objectives, up to `top` further drives
/// of the Pareto front. Drives are computed in the order of the candidates. If the order of the
/// candidates uses an estimate of the first objective, each group of kRankedDrives green drives is
/// sorted by exact values. A candidate without a green verdict is replaced by the next one, until
/// kMostComputedDrives candidates of the same module have been computed. A train is left out if the
/// estimate of design/train_strength.hpp shows that the train cannot have the required safeties, or
/// if the sliding of one stage exceeds the limit. If each stage may have its own module, the stage
/// gets the least module with which it has the required safeties.
///
/// Laws      (1) if a search with one module finds a drive, a search over a list that contains
///           this module also finds a drive
///           (2) the first `top` drives are the first drives of every longer list
/// Errors    an error of `rate` that occurs before any drive has been rated
Result<DriveDesigns> drive_designs(const DriveDesignTask& task, const DriveSearchResult& result,
                                   std::size_t top, int threads);

/// Number of drives that are sorted together by their exact values. The number is a constant,
/// because the order of the drives must not depend on `top`.
inline constexpr std::size_t kRankedDrives = 100;
/// Greatest number of candidates of each module that are computed.
inline constexpr std::size_t kMostComputedDrives = 20000;

/// Returns the drive of a candidate, with its shifts and its face widths.
///
/// Errors    as graph_of()
Result<DriveInput> drive_of(const DriveSearchProblem& problem, const DriveCandidate& candidate);

/// A design, the reason why a candidate is left out, or an error of the rating.
using DriveOutcome = std::variant<FoundDrive, DriveFault, Error>;

/// Makes the drive of a candidate, chooses its profile shifts, modules and face widths, rates the
/// drive and judges it.
class DriveDesigner {
 public:
  /// The task must outlive the designer.
  explicit DriveDesigner(const DriveDesignTask& task) : task_(task), problem_(task.problem) {}

  /// Returns the design of a candidate. If the search gives no profile shifts, several are tried,
  /// and the best design according to the objectives is returned.
  DriveOutcome operator()(DriveCandidate candidate) const;
  /// Rates a train. If the candidate has no face widths, the greatest ones are used. The result
  /// contains the train with its face widths and, for each stage, the greatest safeties over all
  /// trials of profile shifts. Returns none if the train cannot be rated.
  std::optional<RatedTrain> rated(DriveCandidate candidate) const;
  /// Returns the least value, over all trials of profile shifts, of the greatest specific sliding
  /// |ζ| of a train. The result is 0 if the teeth cannot be made, because the train is then left
  /// out for another reason.
  double least_sliding(DriveCandidate candidate) const;

 private:
  std::vector<GearShifts> trials(DriveCandidate candidate) const;
  bool is_better(const DriveOutcome& a, const DriveOutcome& b) const;
  std::optional<std::vector<Safeties>> mesh_safeties(const DriveCandidate& candidate) const;
  DriveOutcome with_stage_modules(DriveCandidate candidate) const;
  std::vector<double> least_steps(DriveCandidate candidate, double below,
                                  const std::vector<double>& greatest) const;
  void set_steps(DriveCandidate& candidate, const std::vector<double>& steps) const;
  DriveOutcome sized(DriveCandidate candidate) const;
  std::optional<Drive> made_from(const DriveCandidate& candidate) const;
  DriveOutcome with_widths(DriveCandidate candidate) const;

  const DriveDesignTask& task_;
  const DriveSearchProblem& problem_;
};

}  // namespace gearwright
