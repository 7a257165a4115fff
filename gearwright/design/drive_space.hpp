// Enumerates the numbers of teeth of all sets in a search for drives. Internal to design/.
#pragma once

#include <algorithm>
#include <array>

#include "gearwright/design/drive_search.hpp"

namespace gearwright {

using TeethOfSet = std::array<int, kSetMembers>;

/// Returns the greatest permissible difference between the sums of teeth of meshes with a common
/// centre distance.
inline int coaxial_slack(const DriveSearchProblem& problem) {
  if (problem.coaxial_teeth) return *problem.coaxial_teeth;
  const bool one_gear = !problem.teeth[static_cast<std::size_t>(SetMember::planet2)];
  return problem.kind == DriveKind::wolfrom && one_gear ? problem.planets[1] : 1;
}

/// Estimates the efficiency η of a mesh from the numbers of teeth (z < 0 for a ring) and the
/// coefficient of friction μ. The estimate is used for ranking only.
double estimated_efficiency(int z1, int z2, double friction);

/// Sets the noise of all candidates, for gears without profile shift. Helical teeth also need a
/// face width and modules. If the search has both, the face width and the first module are used.
/// The search ranks by this estimate until the teeth are computed.
void estimate_noise(const DriveSearchProblem& problem, std::vector<DriveCandidate>& candidates,
                    int threads);

/// Returns the mass of a candidate for gears without profile shift, kg. The result is absent if the
/// mass is not requested or if the problem has no modules. If the search sizes the faces, the
/// widths of the candidate are used or, if it has none, the greatest widths. The search ranks by
/// this estimate until the teeth are computed.
std::optional<double> estimated_mass(const DriveSearchProblem& problem,
                                     const DriveCandidate& candidate);

/// Adds all trains of the problem to the result. The ratio determines the number of teeth of the
/// last wheel. A stage is not tried if no module gives it the required centre distance.
void search_trains(const DriveSearchProblem& problem, DriveSearchResult& result);
/// Replaces every train by several trains, one for each choice of modules that gives the required
/// centre distances. Converts the size from modules to mm. If the size of a train exceeds the
/// limit, the train is rejected.
void give_stage_modules(const DriveSearchProblem& problem, DriveSearchResult& result);

/// Visits all sets of one kind in which the planet has a given number of teeth.
class DriveSpace {
 public:
  explicit DriveSpace(const DriveSearchProblem& problem)
      : kind_(problem.kind), slack_(coaxial_slack(problem)) {
    for (const SetMember m : members_of(problem)) has_[at(m)] = true;
    for (std::size_t m = 0; m < kSetMembers; ++m)
      band_[m] = teeth_band(problem, static_cast<SetMember>(m));
  }

  TeethBand first_band() const { return band_[at(SetMember::planet)]; }

  template <class Visit>
  void visit(int planet, const Visit& visit) const {
    using M = SetMember;
    TeethOfSet z{};
    z[at(M::planet)] = planet;
    switch (kind_) {
      case DriveKind::planetary:
        each(M::sun, z, [&] { near(M::ring, z, z[at(M::sun)] + 2 * planet, [&] { visit(z); }); });
        break;
      case DriveKind::stepped:
        each(M::sun, z, [&] {
          each(M::planet2, z, [&] {
            near(M::ring2, z, z[at(M::sun)] + planet + z[at(M::planet2)], [&] { visit(z); });
          });
        });
        break;
      case DriveKind::two_suns:
        each(M::sun, z, [&] {
          each(M::planet2, z, [&] {
            near(M::sun2, z, z[at(M::sun)] + planet - z[at(M::planet2)], [&] { visit(z); });
          });
        });
        break;
      case DriveKind::wolfrom:
        each(M::ring, z, [&] {
          if (has_[at(M::planet2)]) {
            each(M::planet2, z, [&] { second_ring(z, z[at(M::planet2)], visit); });
          } else {
            second_ring(z, planet, visit);
          }
        });
        break;
      case DriveKind::train: break;
    }
  }

 private:
  static std::size_t at(SetMember m) { return static_cast<std::size_t>(m); }

  template <class Visit>
  void second_ring(TeethOfSet& z, int planet2, const Visit& visit) const {
    using M = SetMember;
    near(M::ring2, z, z[at(M::ring)] - z[at(M::planet)] + planet2, [&] {
      if (has_[at(M::sun)]) {
        near(M::sun, z, z[at(M::ring)] - 2 * z[at(M::planet)], [&] { visit(z); });
      } else {
        visit(z);
      }
    });
  }

  template <class Next>
  void each(SetMember m, TeethOfSet& z, const Next& next) const {
    for (z[at(m)] = band_[at(m)][0]; z[at(m)] <= band_[at(m)][1]; ++z[at(m)]) next();
    z[at(m)] = 0;
  }
  // Tries the numbers of teeth near `middle`, which gives a coaxial set without profile shifts.
  template <class Next>
  void near(SetMember m, TeethOfSet& z, int middle, const Next& next) const {
    const int last = std::min(band_[at(m)][1], middle + slack_);
    for (z[at(m)] = std::max(band_[at(m)][0], middle - slack_); z[at(m)] <= last; ++z[at(m)])
      next();
    z[at(m)] = 0;
  }

  DriveKind kind_;
  int slack_;
  std::array<bool, kSetMembers> has_{};
  std::array<TeethBand, kSetMembers> band_{};
};

}  // namespace gearwright
