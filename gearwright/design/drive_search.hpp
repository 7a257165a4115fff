// Searches for whole drives: planetary sets of four kinds, and trains. A drive is defined by
// its numbers of teeth.
//
//   i        ratio n_in/n_out, exact [T13.3]
//   N*       number of positions per turn at which a planet can be assembled [T13.12]
//   a        centre distance of the first mesh without shifts, m_t (z_a + z_b)/2
//   c        clearance between the tip circles of neighbouring planets, modules [T13.15b]
//                                              theory: docs/theory/13-drives.md
//
// For every set, the ratio, the assembly, the clearance of neighbouring planets and the mesh
// phases are checked. The sets that meet all limits are ranked. If the losses of the meshes are
// given, the ranking by efficiency is exact. Otherwise the losses are estimated. The caller
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

using TeethBand = std::array<int, 2>;  ///< both ends included

struct DriveSearchProblem {
  DriveKind kind = DriveKind::planetary;
  std::array<double, 2> ratio{};       ///< band of i, both ends included, signed
  std::optional<double> target_ratio;  ///< by default the middle of the band
  TeethBand planets{3, 3};
  /// Bands for the members of this kind of set. By default, the bands of teeth_band() are used.
  std::array<std::optional<TeethBand>, kSetMembers> teeth{};
  TeethBand stages{2, 2};  ///< number of stages of a train
  TeethBand pinion{17, 40}, wheel{17, 150};
  /// Greatest permissible difference between the sums of teeth of meshes with a common centre
  /// distance. The default is 1, or the number of planets if two rings mesh with one planet gear.
  /// For a train, the default is no limit.
  std::optional<int> coaxial_teeth;
  bool coprime = false;              ///< true if the gears of every mesh must have no common factor
  double neighbour_clearance = 1.0;  ///< lower limit of c  modules
  double sliding = kInfinity;        ///< upper limit of |ζ| of every mesh; requires modules
  double overlap = 0.0;              ///< lower limit of ε_β of every mesh; requires modules
  std::vector<PhasingClass> phasing;  ///< allowed classes; all if empty
  std::vector<DriveObjective> objectives{DriveObjective::efficiency};
  /// m_n of all meshes  mm; each set is tried with every module. If the list is empty, no tooth
  /// geometry is computed, and sizes are in modules.
  std::vector<double> modules;
  /// True if each stage of a train may have its own module. The search then finds every train
  /// only once, with the first of the modules in all stages, and the caller chooses the
  /// modules.
  bool module_per_stage = false;
  double size_max = kInfinity;  ///< upper limit of DriveCandidate::size  mm; requires modules
  /// a of every stage of a train  mm, as mounted; a band with both ends included. Requires modules
  /// and profile shifts that the search chooses, and excludes `module_per_stage`. Every train is
  /// found once for each choice of the modules of its stages that gives such distances.
  std::optional<std::array<double, 2>> center_distance;
  std::optional<std::array<double, 2>> face_width;  ///< b  mm, band of the face widths from which
                                                    ///<    the search chooses, both ends included
  double face_diameters = 1.2;  ///< greatest b/d of the smaller gear of a mesh, if the search
                                ///< chooses the face widths
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

/// The members of this kind of set whose numbers of teeth are tried; empty for a train.
std::vector<SetMember> members_of(const DriveSearchProblem& problem);
/// The band of the number of teeth of a member. If the problem gives no band, the default is used.
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
      0.0;  ///< mm, without shifts; for a set, the greatest of the diameter over the planets, the
            ///< tip diameters of suns and the root diameters of rings; for a train, the sum of the
            ///< centre distances
  /// Efficiencies with given or estimated losses; 0 if self-locking or not requested.
  double efficiency = 0.0, efficiency_backward = 0.0;
  /// b of each mesh  mm, in the order of the graph; empty if the search does not size the faces. A
  /// gear with several meshes has the greatest of their face widths.
  std::vector<double> face_widths{};
  GearShifts shifts{};                  ///< x  if the search chooses the profile shifts
  std::vector<double> stage_modules{};  ///< m_n of each stage  mm; if empty, every stage has
                                        ///< `module`
  /// Variation of the elastic rotation, peak to peak, divided by this rotation [T13.33]. Absent if
  /// not requested, or if a mesh loses contact.
  std::optional<double> noise{};
  /// Mass of all gears  kg, with the bodies of GearBody. Absent if not requested. Until the teeth
  /// are computed, it is an estimate for gears without profile shift.
  std::optional<double> mass{};

  double stage_module(std::size_t stage) const {
    return stage_modules.empty() ? module : stage_modules[stage];
  }
  /// x of both gears of a stage; none if the search does not choose them.
  std::optional<std::array<double, 2>> stage_shifts(std::size_t stage) const;
  bool has_one_module() const {
    return std::adjacent_find(stage_modules.begin(), stage_modules.end(), std::not_equal_to<>()) ==
           stage_modules.end();
  }
};

struct DriveSearchResult {
  std::int64_t tested = 0;
  std::array<std::int64_t, kDriveLimitNames.size()> rejected{};
  std::vector<DriveCandidate> found;  ///< in the order of sort_by_objective()
  bool is_complete = true;  ///< false if a search for trains was stopped at one of its limits
};

/// kMostTrains is the greatest number of trains that a search finds, before modules are
/// considered. With limited centre distances, the choices of modules are counted too. A search
/// tries combinations of the numbers of teeth of all gears except the last wheel. kMostTrainTrials
/// is the greatest number of these combinations.
inline constexpr std::size_t kMostTrains = 1'000'000;
inline constexpr std::int64_t kMostTrainTrials = 300'000'000;

/// All candidates that meet the limits.
///
/// Formula   all meshes of a set have the same module, so meshes with a common centre distance must
///           have nearly equal sums of teeth. These sums differ by at most `coaxial_teeth`
/// Domain    bands from 1 to kMostDriveTeeth (contract)
/// Errors    `drive.fixed`, `drive.input` or `drive.output` if the set has no such member, or if
///           one member has two of these functions
Result<DriveSearchResult> search_drives(const DriveSearchProblem& problem, int threads = 0);
/// Sets the fixed, input and output members that the problem does not give. In a set with two rings
/// (wolfrom) or two suns, one of the two is fixed and the other is the output. For other kinds, the
/// defaults of the set are used.
void complete_ends(DriveSearchProblem& problem);
/// The set of a candidate, with the losses and the fixed, input and output members of the
/// problem.   Domain: not a train
PlanetarySpec set_of(const DriveSearchProblem& problem, const DriveCandidate& candidate);
/// The helix angle of the first gear of a stage of a train, degrees. The hand alternates from stage
/// to stage, so that both gears of an intermediate shaft have the same hand and their axial forces
/// have opposite directions.
double stage_helix_deg(const DriveSearchProblem& problem, std::size_t stage);
/// True if the output of this train gets the axis of its input. This requires that `coaxial_teeth`
/// is given, that the train has several stages with one module, and that the search chooses the
/// profile shifts.
bool is_coaxial(const DriveSearchProblem& problem, const DriveCandidate& train);
/// Least and greatest sum of the profile shifts of a stage whose centre distance is limited.
/// Without a limit, shift_trials() gives sums from 0 to 2 for usual thickness allowances.
inline constexpr std::array<double, 2> kStageShiftSums{-1.0, 3.0};
/// True if a stage of a train with this sum of teeth z_1 + z_2 and this module can have a centre
/// distance within the limits of the problem, by kStageShiftSums.
///
/// Formula   [T2.16]
bool may_reach(const DriveSearchProblem& problem, int sum_of_teeth, double module);
/// The train with these modules of its stages, and with the size and the mass that follow from them.
DriveCandidate with_modules(const DriveSearchProblem& problem, DriveCandidate train,
                            const std::vector<double>& modules);
/// The candidate with the greatest face widths that the band of face widths and the greatest b/d
/// permit. If the search does not size the faces, the candidate is unchanged.
DriveCandidate widest(const DriveSearchProblem& problem, DriveCandidate candidate);
/// The face widths b of the gears of a set, by member. Empty for a train, or if the search does not
/// size the faces.
PerMember member_face_widths(const DriveCandidate& candidate);

/// The number by which candidates are ranked for an objective; a smaller number is better.
double cost_of(const DriveSearchProblem& problem, const DriveCandidate& candidate,
               DriveObjective objective);

/// Greatest difference between efficiencies that count as equal in the ranking. The estimate of the
/// losses of a mesh is far less accurate.
inline constexpr double kSameEfficiency = 1e-4;

/// Sorts a list by the first objective of the search, the best first, and then by size. If the
/// first objective is an efficiency, the sorted list is divided into groups. The candidates of a
/// group are at most kSameEfficiency worse than its first candidate, and each group is sorted by
/// size.
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

/// Indices of the candidates that no other candidate dominates in all objectives.
std::vector<std::size_t> pareto_front(const DriveSearchProblem& problem,
                                      const std::vector<DriveCandidate>& candidates);

inline constexpr int kMostStages = 4;
/// Greatest number of teeth in a search. The product of three such numbers is exact in double.
inline constexpr int kMostDriveTeeth = 2000;

}  // namespace gearwright
