// Searches for whole drives: planetary sets of four kinds, and trains. A drive is defined by
// its numbers of teeth.
//
//   i        ratio n_in/n_out, exact [T13.3]
//   N*       number of positions per turn at which a planet can be assembled [T13.12]
//   a        centre distance of the first mesh without shifts, m_t (z_a + z_b)/2
//   c        clearance between the tip circles of neighbouring planets, modules [T13.15b]
//                                              theory: docs/theory/13-drives.md
//
// For every set, the search checks the ratio, the assembly, the clearance of neighbouring planets
// and the mesh phases. It ranks the sets that meet all limits. If the losses of the meshes are
// given, the ranking by efficiency is exact. Otherwise, the losses are estimated. The caller then
// makes the drives of the best sets.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/design/drive_shifts.hpp"
#include "gearwright/design/search_problem.hpp"
#include "gearwright/drive/phasing.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {

enum class DriveKind { planetary, stepped, wolfrom, two_suns, train };
inline constexpr std::array<std::string_view, 5> kDriveKindNames{"planetary", "stepped", "wolfrom",
                                                                 "two_suns", "train"};

enum class DriveObjective {
  efficiency,           ///< greatest efficiency with the input driving
  ratio,                ///< ratio nearest to the target
  size,                 ///< least DriveCandidate::size
  efficiency_backward,  ///< greatest efficiency with the output driving
  clearance,            ///< greatest clearance between neighbouring planets
  planets,              ///< greatest number of planets
  noise,                ///< least variation of the elastic rotation under load (drive/windup.hpp)
  mass                  ///< least DriveCandidate::mass; requires modules
};
inline constexpr std::array<std::string_view, 8> kDriveObjectiveNames{
    "efficiency", "ratio", "size", "efficiency_backward", "clearance", "planets", "noise", "mass"};

using TeethBand = std::array<int, 2>;  ///< least and greatest number of teeth; both are allowed

struct DriveSearchProblem {
  DriveKind kind = DriveKind::planetary;
  std::array<double, 2> ratio{};       ///< band of i, both ends included, signed
  std::optional<double> target_ratio;  ///< by default the middle of the band
  TeethBand planets{3, 3};
  /// Bands for the members of this kind of set. The default of a band is teeth_band().
  std::array<std::optional<TeethBand>, kSetMembers> teeth{};
  TeethBand stages{2, 2};  ///< number of stages of a train
  TeethBand pinion{17, 40}, wheel{17, 150};
  /// Greatest permissible difference between the sums of teeth of meshes with a common centre
  /// distance. The default is 1. If two rings mesh with one planet gear, the default is the
  /// greatest number of planets. For a train, the default is no limit.
  std::optional<int> coaxial_teeth;
  bool coprime = false;               ///< true if the gears of a mesh must have no common factor
  double neighbour_clearance = 1.0;   ///< lower limit of c  modules
  double sliding = kInfinity;         ///< upper limit of |ζ| of every mesh; requires modules
  double overlap = 0.0;               ///< lower limit of ε_β of every mesh; requires modules
  std::vector<PhasingClass> phasing;  ///< allowed classes; all if empty
  std::vector<DriveObjective> objectives{DriveObjective::efficiency};
  /// m_n of all meshes  mm. Each set is tried with every module. If the list is empty, no tooth
  /// geometry is computed, and sizes are in modules.
  std::vector<double> modules;
  /// True if the stages of a train may have different modules. The search then finds every train
  /// only once, with the first module of the list in all stages. The caller chooses the modules.
  bool module_per_stage = false;
  double size_max = kInfinity;  ///< upper limit of DriveCandidate::size  mm; requires modules
  /// Band of the centre distance a of every stage of a train, as mounted, mm, both ends included.
  /// The band requires `modules`, and profile shifts that are left to the search. Each stage may
  /// have another module, and each choice of modules with which every stage may reach the band is a
  /// separate candidate. `module_per_stage`, which finds a train only once, must be false.
  std::optional<std::array<double, 2>> center_distance;
  std::optional<std::array<double, 2>> face_width;  ///< b  mm, both ends included; the search
                                                    ///< chooses face widths within this band
  double face_diameters = 1.2;  ///< greatest b/d of the smaller gear of a mesh; used only if the
                                ///< search chooses the face widths
  std::optional<double> safety_flank, safety_root;  ///< lower limits of S_H and S_F of every mesh
  /// ρ of each member  kg/mm³. All gears of a train have the first value.
  std::array<double, kSetMembers> density = [] {
    std::array<double, kSetMembers> steel{};
    steel.fill(kSteelDensity);
    return steel;
  }();
  /// Helix angle, losses, allowances, backlash, spacing, and the fixed and driving members. Numbers
  /// of teeth in `base` are ignored.
  PlanetarySpec base;

  double target() const { return target_ratio.value_or((ratio[0] + ratio[1]) / 2); }
  bool asks(DriveObjective objective) const;
};

/// Returns the members whose numbers of teeth are tried for this kind of set; none for a train.
std::vector<SetMember> members_of(const DriveSearchProblem& problem);
/// Returns the band of the number of teeth of a member, or its default.
TeethBand teeth_band(const DriveSearchProblem& problem, SetMember member);

/// Reasons for rejecting a set, in the order in which they are checked.
enum class DriveLimit { ratio, assembly, neighbours, phasing, size };
inline constexpr std::array<std::string_view, 5> kDriveLimitNames{"ratio", "assembly", "neighbours",
                                                                  "phasing", "size"};

struct DriveCandidate {
  std::array<int, kSetMembers> teeth{};      ///< > 0, also for rings; 0 if there is no such member
  std::vector<std::array<int, 2>> stages{};  ///< numbers of teeth of the stages of a train
  int planets = 1;
  double module = 1.0;     ///< m_n  mm
  double ratio = 0.0;      ///< i
  long long places = 0;    ///< N*; 0 for a train
  double clearance = 0.0;  ///< c  modules, without shifts; infinite for a train and for one planet
  double size =
      0.0;  ///< mm, without shifts. For a train, the sum of the centre distances. For a set, the
            ///< greatest of three diameters: over the planets, the tip diameter of a sun, and the
            ///< root diameter of a ring
  /// Efficiencies with the given or the estimated losses; 0 if self-locking or if not requested.
  double efficiency = 0.0, efficiency_backward = 0.0;
  /// b of each mesh  mm, in the order of the graph. Empty if the search does not size the faces. If
  /// a gear has several meshes, the gear has the greatest of their face widths.
  std::vector<double> face_widths{};
  GearShifts shifts{};                  ///< x  if the search chooses the profile shifts
  std::vector<double> stage_modules{};  ///< m_n of each stage  mm; if empty, `module` for every
                                        ///< stage
  /// Peak-to-peak variation of the elastic rotation, divided by this rotation [T13.33]. Absent if
  /// it was not requested, or if a mesh loses contact.
  std::optional<double> noise{};
  /// Mass of all gears  kg, with the bodies of GearBody. Absent if it was not requested. Until the
  /// teeth are computed, the mass is an estimate for gears without profile shift.
  std::optional<double> mass{};

  double stage_module(std::size_t stage) const {
    return stage_modules.empty() ? module : stage_modules[stage];
  }
  /// Returns x of both gears of a stage, or none if the search does not choose profile shifts.
  std::optional<std::array<double, 2>> stage_shifts(std::size_t stage) const;
  bool has_one_module() const {
    return std::adjacent_find(stage_modules.begin(), stage_modules.end(), std::not_equal_to<>()) ==
           stage_modules.end();
  }
};

struct DriveSearchResult {
  std::int64_t tested = 0;
  std::array<std::int64_t, kDriveLimitNames.size()> rejected{};
  std::vector<DriveCandidate> found;  ///< in the order of sort_by_objective() if `is_complete`
  bool is_complete = true;  ///< false if a search for trains was stopped at one of its limits
};

/// Limits of a search for trains. kMostTrains is the greatest number of trains that are found,
/// before modules are considered. If the centre distances are limited, every choice of modules
/// counts as a train. kMostTrainTrials is the greatest number of combinations of numbers of teeth.
/// These combinations include all gears except the last wheel.
inline constexpr std::size_t kMostTrains = 1'000'000;
inline constexpr std::int64_t kMostTrainTrials = 300'000'000;

/// Returns all candidates that meet the limits.
///
/// Formula   all meshes of a set have the same module. Meshes with a common centre distance must
///           therefore have nearly equal sums of teeth, with a difference of at most
///           `coaxial_teeth`
/// Domain    for a set, bands of teeth from 1 to kMostDriveTeeth; for a limited centre distance, a
///           train with `module_per_stage` = false (contract)
/// Errors    for a set, `drive.fixed`, `drive.input` or `drive.output` if the set has no such
///           member, if there is more than one fixed member or more than one input, or if one
///           member has two of these functions
Result<DriveSearchResult> search_drives(const DriveSearchProblem& problem, int threads = 0);
/// Sets the fixed, input and output members that the problem does not give. In a set with two rings
/// (wolfrom) or two suns, one ring or sun is fixed, and the other is the output. For other kinds,
/// the defaults of the set are used.
void complete_ends(DriveSearchProblem& problem);
/// Returns the set of a candidate, with the losses and the fixed, input and output members of the
/// problem.   Domain: not a train
PlanetarySpec set_of(const DriveSearchProblem& problem, const DriveCandidate& candidate);
/// Returns the helix angle of the first gear of a stage of a train, degrees. The hand alternates
/// from stage to stage. Both gears of an intermediate shaft then have the same hand, and their
/// axial forces have opposite directions.
double stage_helix_deg(const DriveSearchProblem& problem, std::size_t stage);
/// True if this train has a coaxial output. The conditions are that `coaxial_teeth` and modules are
/// given, that the train has several stages with one module, and that the search chooses the
/// profile shifts.
bool is_coaxial(const DriveSearchProblem& problem, const DriveCandidate& train);
/// Least and greatest sum of the profile shifts of a stage with a limited centre distance. Without
/// a limit and with usual thickness allowances, shift_trials() gives sums from 0 to 2.
inline constexpr std::array<double, 2> kStageShiftSums{-1.0, 3.0};
/// True if a stage with this module and this sum of teeth z_1 + z_2 can have a centre distance
/// within the limits of the problem. The sum of its profile shifts must be within kStageShiftSums.
///
/// Formula   [T2.16]
bool may_reach(const DriveSearchProblem& problem, int sum_of_teeth, double module);
/// Returns the train with these modules of its stages, and with its new size and mass.
DriveCandidate with_modules(const DriveSearchProblem& problem, DriveCandidate train,
                            const std::vector<double>& modules);
/// Returns the candidate with the greatest face widths within the band and the greatest b/d. If the
/// search does not size the faces, the function returns the candidate unchanged.
DriveCandidate widest(const DriveSearchProblem& problem, DriveCandidate candidate);
/// Returns the face widths b of the gears of a set, by member. The result is empty for a train, or
/// if the search does not size the faces.
PerMember member_face_widths(const DriveCandidate& candidate);

/// Returns the number by which candidates are ranked for an objective. Smaller numbers are better.
double cost_of(const DriveSearchProblem& problem, const DriveCandidate& candidate,
               DriveObjective objective);

/// Efficiencies that differ by at most this value count as equal in the ranking. The estimate of
/// the losses of a mesh is far less accurate.
inline constexpr double kSameEfficiency = 1e-4;

/// Sorts a list by the first objective of the search, the best first, and then by size. If the
/// first objective is an efficiency, the sorted list is then divided into groups. The efficiencies
/// within a group are at most kSameEfficiency less than that of its first candidate. Each group is
/// sorted by size.
template <class T, class CandidateOf>
void sort_by_objective(const DriveSearchProblem& problem, std::span<T> list,
                       const CandidateOf& candidate_of) {
  const DriveObjective first = problem.objectives.front();
  const auto cost = [&](const T& t) { return cost_of(problem, candidate_of(t), first); };
  const auto size = [&](const T& t) { return candidate_of(t).size; };
  std::stable_sort(list.begin(), list.end(), [&](const T& a, const T& b) {
    return cost(a) != cost(b) ? cost(a) < cost(b) : size(a) < size(b);
  });
  if (first != DriveObjective::efficiency && first != DriveObjective::efficiency_backward) return;
  for (auto begin = list.begin(); begin != list.end();) {
    const double worst = cost(*begin) + kSameEfficiency;
    const auto end = std::find_if(begin, list.end(), [&](const T& t) { return cost(t) > worst; });
    std::stable_sort(begin, end, [&](const T& a, const T& b) { return size(a) < size(b); });
    begin = end;
  }
}

/// Returns the indices of the candidates that no other candidate dominates in all objectives. The
/// list is empty if there is only one objective.
std::vector<std::size_t> pareto_front(const DriveSearchProblem& problem,
                                      const std::vector<DriveCandidate>& candidates);

inline constexpr int kMostStages = 4;
/// Greatest number of teeth in a search. The product of three such numbers is exact in double.
inline constexpr int kMostDriveTeeth = 2000;

}  // namespace gearwright
