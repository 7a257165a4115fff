// Search for whole drives: planetary sets of five kinds and trains, by their numbers of teeth.
//
//   i        = n_in/n_out, exactly [T13.3]
//   N*       number of places per turn at which a planet can be assembled [T13.12]
//   a        centre distance, a = m_t (z_a + z_b)/2 of the first mesh without shifts
//   c        clearance between the tip circles of neighbouring planets, modules [T13.15b]
//                                              theory: docs/theory/13-drives.md
//
// Ratio, assembly, neighbouring planets and phases of every set are checked, and the sets that meet all
// limits are ranked. The ranking by efficiency is exact if the losses of the meshes are given; otherwise
// they are estimated. The caller makes the drives of the best sets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/drive/phasing.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {

enum class DriveKind { planetary, stepped, wolfrom, two_suns, train };
inline constexpr std::array<std::string_view, 5> kDriveKindNames{"planetary", "stepped", "wolfrom",
                                                                 "two_suns", "train"};

enum class DriveObjective {
  efficiency,           ///< greatest efficiency if the input drives
  ratio,                ///< ratio nearest to the target
  size,                 ///< least overall diameter
  efficiency_backward,  ///< greatest efficiency if the output drives
  clearance,            ///< greatest clearance between neighbouring planets
  planets               ///< greatest number of planets
};
inline constexpr std::array<std::string_view, 6> kDriveObjectiveNames{
    "efficiency", "ratio", "size", "efficiency_backward", "clearance", "planets"};

using TeethBand = std::array<int, 2>;  ///< closed

struct DriveSearchProblem {
  DriveKind kind = DriveKind::planetary;
  std::array<double, 2> ratio{};       ///< closed, signed
  std::optional<double> target_ratio;  ///< by default the middle of the band
  TeethBand planets{3, 3};
  /// Bands of the members of the kind; by default the bands of teeth_band().
  std::array<std::optional<TeethBand>, kSetMembers> teeth{};
  TeethBand stages{2, 2};  ///< number of stages of a train, all with one module
  TeethBand pinion{17, 40}, wheel{17, 150};
  /// Greatest difference between the sums of teeth of meshes on one circle. The default is 1, or the
  /// number of planets if two rings mesh with one planet gear. A train has no limit by default.
  std::optional<int> coaxial_teeth;
  double neighbour_clearance = 1.0;   ///< c ≥ this  modules
  std::vector<PhasingClass> phasing;  ///< allowed classes; all if empty
  std::vector<DriveObjective> objectives{DriveObjective::efficiency};
  /// m_n of all meshes  mm; each set is tried with every module. If empty, there is no geometry of
  /// teeth, and sizes are in modules.
  std::vector<double> modules;
  double size_max = kInfinity;  ///< greatest DriveCandidate::size  mm; requires modules
  std::optional<std::array<double, 2>> face_width;  ///< b  mm, closed band of the sized face width
  double face_diameters = 1.2;                      ///< greatest b/d of the smallest gear if sized
  std::optional<double> safety_flank, safety_root;  ///< least S_H and S_F of every mesh
  std::string series;  ///< of DIN 3967, "cd25", the allowances of all gears; empty: those of `base`
  /// Helix angle, losses, spacing, and the fixed and driving members. The numbers of teeth in it are not
  /// used.
  PlanetarySpec base;

  double target() const { return target_ratio.value_or((ratio[0] + ratio[1]) / 2); }
  bool asks(DriveObjective objective) const;
};

/// The members of the kind whose numbers of teeth are tried; empty for a train.
std::vector<SetMember> members_of(const DriveSearchProblem& problem);
/// The band of the number of teeth of a member, as given or by default.
TeethBand teeth_band(const DriveSearchProblem& problem, SetMember member);

/// Reasons for rejecting a set, in the order in which they are checked.
enum class DriveLimit { ratio, assembly, neighbours, phasing, size };
inline constexpr std::array<std::string_view, 5> kDriveLimitNames{"ratio", "assembly", "neighbours",
                                                                  "phasing", "size"};

/// A drive by its numbers of teeth.
struct DriveCandidate {
  std::array<int, kSetMembers> teeth{};      ///< > 0, also for rings; 0 if there is no such member
  std::vector<std::array<int, 2>> stages{};  ///< of a train
  int planets = 1;
  double module = 1.0;     ///< m_n  mm
  double ratio = 0.0;      ///< i
  long long places = 0;    ///< N*; 0 for a train
  double clearance = 0.0;  ///< c  modules, without shifts; infinite for a train and for one planet
  double size = 0.0;  ///< mm: overall diameter without shifts; for a train, sum of centre distances
  /// Efficiencies with given or estimated losses; 0 if self-locking or not requested.
  double efficiency = 0.0, efficiency_backward = 0.0;
  std::optional<double> face_width{};  ///< b  mm, if the search sizes the face width
};

struct DriveSearchResult {
  std::int64_t tested = 0;
  std::array<std::int64_t, kDriveLimitNames.size()> rejected{};
  std::vector<DriveCandidate> found;  ///< best first by the first objective, then by size
};

/// All candidates that meet the limits.
///
/// Formula   the sums of teeth of all meshes on one circle agree to `coaxial_teeth`, because all
///           meshes of a set have one module
/// Domain    bands from 1 to kMostDriveTeeth (contract)
/// Errors    `drive.fixed`, `drive.input`, `drive.output` if there is no such member, or if one
///           member has two of these functions
Result<DriveSearchResult> search_drives(const DriveSearchProblem& problem, int threads = 0);
/// Sets the fixed, input and output members that the problem does not give. If there are two rings
/// (wolfrom) or two suns, one is fixed and the other is the output. Other kinds use the defaults of a
/// set.
void complete_ends(DriveSearchProblem& problem);
/// The set of a candidate, with the losses and ends of the problem.   Domain: not a train
PlanetarySpec set_of(const DriveSearchProblem& problem, const DriveCandidate& candidate);
/// The greatest face width that the search may choose, mm, from the band and from b/d.
double greatest_face_width(const DriveSearchProblem& problem, const DriveCandidate& candidate);

/// The mean thickness allowance of a gear by the series of the problem, mm. It is 0 for a gear that the
/// series does not contain.
double mean_allowance(const DriveSearchProblem& problem, const DriveCandidate& candidate,
                      int teeth);

/// The number by which candidates are ranked for an objective; smaller is better.
double cost_of(const DriveSearchProblem& problem, const DriveCandidate& candidate,
               DriveObjective objective);

/// Indices of the candidates that are not dominated in all objectives.
std::vector<std::size_t> pareto_front(const DriveSearchProblem& problem,
                                      const std::vector<DriveCandidate>& candidates);

/// Greatest number of teeth in a search. The product of three such numbers is exact in double.
inline constexpr int kMostDriveTeeth = 2000;

}  // namespace gearwright
