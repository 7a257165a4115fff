#include "gearwright/drive/loaded_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/drive/drive_places.hpp"
#include "gearwright/drive/mesh_springs.hpp"
#include "gearwright/drive/planet_equilibrium.hpp"

namespace gearwright {

namespace {

using detail::MeshPhase;
using detail::MeshSprings;
using detail::MeshState;
using detail::not_loaded;
using detail::PlanetEquilibrium;
using detail::PlanetState;
using detail::set_of;

/// Limit of the common multiple in positions_of(). A number of planets that would raise the
/// multiple above this limit is left out.
constexpr int kMostCommon = 60;
/// Greatest number of combinations of the requested positions for a set with several mesh
/// frequencies. With 64 positions for each frequency, two frequencies are possible, but three are
/// not.
constexpr double kMostCombinations = 1e5;

// Returns the number of positions over a period. It is a multiple of the numbers of planets, so
// that the meshes of planets at equal pitch pass the same positions and can share springs.
int positions_of(const Drive& drive, int least) {
  int common = 1;
  for (const PlanetSet& set : drive.sets) {
    const int both = std::lcm(common, set.group.count);
    if (both <= kMostCommon) common = both;
  }
  return (least + common - 1) / common * common;
}

// The springs of a mesh at the positions of all of its copies.
struct MeshUnderLoad {
  MeshSprings springs;
  std::vector<std::vector<std::size_t>> at;  // [copy][time]: index of the spring

  MeshState state(std::size_t copy, std::size_t time) const {
    const std::size_t i = at[copy][time];
    return {&springs.springs[i], springs.leads[i]};
  }
};

// The results of a set over all combinations of the positions of its meshes.
class SetTurn {
 public:
  SetTurn(const PlanetEquilibrium& equilibrium, const PlanetSet& set, std::size_t positions,
          std::size_t frequencies)
      : output(frequencies, std::vector<double>(positions)),
        copies_(static_cast<std::size_t>(set.group.count)) {
    const auto& nominal = equilibrium.nominal();
    greatest_mesh_ = static_cast<std::size_t>(std::max_element(nominal.begin(), nominal.end()) -
                                              nominal.begin());
    for (const std::size_t m : equilibrium.meshes()) shares.mesh_load_factors.emplace_back(m, 1.0);
    shares.share.assign(copies_, std::vector<double>(positions));
    shares.least.assign(copies_, std::numeric_limits<double>::infinity());
    shares.greatest.assign(copies_, 0.0);
  }

  std::size_t positions() const { return output.front().size(); }
  std::size_t combinations() const {
    std::size_t count = 1;
    for (std::size_t f = 0; f < output.size(); ++f) count *= positions();
    return count;
  }

  // Adds the equilibrium in which the meshes of each frequency f are at the position at[f].
  void add(const PlanetState& state, const std::vector<std::size_t>& at) {
    const double part = static_cast<double>(positions()) / static_cast<double>(combinations());
    for (std::size_t f = 0; f < at.size(); ++f) output[f][at[f]] += part * state.output;
    least_ = std::min(least_, state.output);
    greatest_ = std::max(greatest_, state.output);
    for (std::size_t k = 0; k < state.forces.size(); ++k) {
      const auto& forces = state.forces[k];
      const double sum = std::accumulate(forces.begin(), forces.end(), 0.0);
      for (std::size_t i = 0; i < copies_; ++i) {
        const double share = forces[i] / sum;
        double& factor = shares.mesh_load_factors[k].second;
        factor = std::max(factor, static_cast<double>(copies_) * forces[i] / sum);
        if (k != greatest_mesh_) continue;
        shares.share[i][at.front()] += part * share;
        shares.least[i] = std::min(shares.least[i], share);
        shares.greatest[i] = std::max(shares.greatest[i], share);
      }
    }
    if (!shares.floating) return;
    shares.displacement.resize(positions(), Vec2::Zero());
    shares.displacement[at.front()] += part * state.displacement;
    shares.greatest_displacement =
        std::max(shares.greatest_displacement.value_or(0.0), state.displacement.norm());
  }

  // Returns the range of the output rotation minus the sum of the ranges of the curves in `output`.
  // This is 0 if the rotation is a sum of independent parts, one for each frequency.
  double coupling() const {
    if (output.size() < 2) return 0.0;
    double sum = greatest_ - least_;
    for (const auto& mean : output) {
      const auto [least, greatest] = std::minmax_element(mean.begin(), mean.end());
      sum -= *greatest - *least;
    }
    return sum;
  }

  PlanetShares shares;
  std::vector<std::vector<double>> output;  // rotation of the output, mean over the positions of
                                            // the other frequencies, [frequency][position]
 private:
  std::size_t copies_, greatest_mesh_ = 0;
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = -least_;
};

class DriveUnderLoad {
 public:
  DriveUnderLoad(const Drive& drive, const DriveLoadCase& load)
      : drive_(drive), load_(load), positions_(positions_of(drive, load.positions)) {}

  std::optional<Error> make(Progress* progress) {
    auto phases = detail::phases_of(drive_);
    if (!phases)
      return not_loaded("needs the geometry of all meshes and a possible place for each planet");
    phases_ = std::move(*phases);
    for (const PlanetSet& set : drive_.sets)
      if (auto error = too_many_positions(set)) return error;
    meshes_.resize(phases_.size());
    begin_stage(progress, "computing the meshes under load",
                static_cast<std::int64_t>(phases_.size()));
    for (std::size_t m = 0; m < phases_.size(); ++m) {
      if (drive_.flow->driver[m] >= 0)
        if (auto error = make_mesh(m)) return error;
      count_step(progress);
    }
    for (std::size_t m = 0; m < phases_.size(); ++m)
      if (phases_[m].first == m) curves_.push_back(curve_of(m));
    for (std::size_t s = 0; s < drive_.sets.size(); ++s)
      if (auto error = make_set(s)) return error;
    return std::nullopt;
  }

  LoadedDrive result() {
    LoadedDrive found;
    found.torque = load_.torque;
    found.error.peak_to_peak = coupling_;
    found.sets = std::move(sets_);
    for (std::size_t m = 0, c = 0; m < phases_.size(); ++m) {
      if (phases_[m].first != m) continue;
      LoadedDrive::Curve& curve = curves_[c++];
      if (!curve.loaded.empty()) add_error(curve, found.error);
      found.curves.push_back(std::move(curve));
    }
    std::erase_if(found.curves, [](const auto& curve) { return curve.loaded.empty(); });
    std::stable_sort(
        found.error.lines.begin(), found.error.lines.end(),
        [](const auto& a, const auto& b) { return a.frequency_ratio < b.frequency_ratio; });
    return found;
  }

 private:
  // Returns the first mesh of each frequency. Each gear of a stepped planet has its own frequency.
  std::vector<std::size_t> frequencies(const PlanetSet& set) const {
    std::vector<std::size_t> list;
    for (const std::size_t m : set.group.meshes) {
      if (drive_.flow->driver[m] < 0) continue;
      const std::size_t first = phases_[m].first;
      add_once(list, first);
    }
    return list;
  }

  std::optional<Error> too_many_positions(const PlanetSet& set) const {
    const std::size_t count = frequencies(set).size();
    // The limit applies to the number of positions that the user requests. positions_ may be
    // greater, because it is a multiple of the numbers of planets. The additional positions cost
    // little time.
    if (count < 2 || std::pow(load_.positions, count) <= kMostCombinations) return std::nullopt;
    return Error{"load.positions", std::to_string(load_.positions),
                 fmt::format("is too many for planets with {} mesh frequencies, because all "
                             "combinations of their positions are computed; give at most {}",
                             count, static_cast<int>(std::pow(kMostCombinations, 1.0 / count)))};
  }

  int copies(std::size_t m) const {
    const PlanetSet* set = set_of(drive_, m);
    return set ? set->group.count : 1;
  }

  // Returns the force F_bt of an equal share of the load [T13.6].
  double nominal(std::size_t m) const {
    const double base_pitch = drive_.geometry.pairs[m]->gear(1).reference().base_pitch_transverse;
    return std::abs(drive_.flow->load[m]) * from_newton_metres(load_.torque) * kTurn / base_pitch /
           copies(m);
  }

  std::optional<Error> make_mesh(std::size_t m) {
    const std::string& name = drive_.graph.meshes[m].name;
    const MeshPhase& phase = phases_[m];
    const auto errors = load_.errors ? load_.errors(m) : ContactErrors();
    const auto setup = detail::mesh_contact(drive_, m, errors, phase.turned);
    if (!setup)
      return not_loaded(
          "cannot be computed, because the mesh has no usable flanks, or because a measured gear "
          "is loaded on the flank without readings",
          name);
    MeshUnderLoad& mesh = meshes_[m];
    const ContactPair pair = setup->pair(!phase.first_drives);
    const double pitch = pair.pitch();
    // Copies whose delays differ by whole positions use the same springs.
    std::vector<double> rotations;
    std::vector<std::pair<Rational, std::size_t>> classes;  // fraction of a position; index of its
                                                            // first spring
    const int n = positions_;
    for (std::size_t i = 0; i < static_cast<std::size_t>(copies(m)); ++i) {
      Rational delay = phase.phases.empty() ? Rational() : phase.phases[i] * Rational(n);
      if (phase.sense < 0.0) delay = -delay;
      const Rational part = delay.frac();
      auto known = std::find_if(classes.begin(), classes.end(),
                                [&](const auto& c) { return c.first == part; });
      if (known == classes.end()) {
        classes.emplace_back(part, rotations.size());
        known = classes.end() - 1;
        for (int j = 0; j < n; ++j) {
          const double x = (j - part.value()) / n + phase.event - phase.time;
          rotations.push_back(pitch * (x - std::floor(x + 0.5)));
        }
      }
      const auto whole = static_cast<long>(delay.floor().value());
      mesh.at.emplace_back();
      for (int j = 0; j < n; ++j)
        mesh.at.back().push_back(known->second +
                                 static_cast<std::size_t>(((j - whole) % n + n) % n));
    }
    auto springs = detail::mesh_springs(*setup, !phase.first_drives, load_.requests[m],
                                        detail::load_levels(copies(m)), nominal(m), rotations);
    if (!springs) {
      Error error = springs.error();
      error.rule = fmt::format("{} (mesh {})", error.rule, name);
      return error;
    }
    mesh.springs = std::move(springs).take();
    return std::nullopt;
  }

  // Returns the sum of the errors of all meshes of one frequency. The loaded curve does not include
  // the meshes of planets, because make_set() adds them later.
  LoadedDrive::Curve curve_of(std::size_t first) const {
    LoadedDrive::Curve curve;
    curve.frequency_ratio = drive_.frequency_ratio(first).value_or(0.0);
    for (std::size_t m = 0; m < phases_.size(); ++m) {
      const MeshUnderLoad& mesh = meshes_[m];
      if (phases_[m].first != first || mesh.at.empty()) continue;
      curve.loaded.resize(static_cast<std::size_t>(positions_));
      curve.rigid.resize(static_cast<std::size_t>(positions_));
      for (std::size_t j = 0; j < curve.rigid.size(); ++j) {
        for (std::size_t i = 0; i < mesh.at.size(); ++i)
          curve.rigid[j] +=
              phases_[m].weight * mesh.state(i, j).lead / static_cast<double>(mesh.at.size());
        if (set_of(drive_, m)) continue;
        const MeshState state = mesh.state(0, j);
        curve.loaded[j] += phases_[m].weight * (state.lead - state.spring->approach(nominal(m)));
      }
    }
    return curve;
  }

  std::optional<Error> make_set(std::size_t s) {
    const PlanetSet& set = drive_.sets[s];
    detail::PlanetErrors errors{{}, load_.pin_errors};
    if (load_.floating && holds(set, *load_.floating)) errors.floating = load_.floating;
    std::vector<double> nominals(phases_.size(), 0.0);
    for (std::size_t m = 0; m < nominals.size(); ++m)
      if (!meshes_[m].at.empty()) nominals[m] = nominal(m);
    const PlanetEquilibrium equilibrium(drive_, set, phases_, nominals, errors);
    if (equilibrium.meshes().empty()) return std::nullopt;
    const std::vector<std::size_t> first = frequencies(set);
    SetTurn turn(equilibrium, set, static_cast<std::size_t>(positions_), first.size());
    turn.shares.set = s;
    turn.shares.floating = errors.floating;
    std::vector<std::size_t> at(first.size(), 0);
    for (std::size_t left = turn.combinations(); left > 0; --left) {
      const PlanetState state = equilibrium.solve(states_at(equilibrium.meshes(), first, at));
      if (!state.found)
        return errors.floating
                   ? Error{"load.floating", drive_.graph.bodies[*errors.floating].name,
                           "is not held in equilibrium by its planets; at least three planets "
                           "around this body, or two opposite planets, are needed"}
                   : not_loaded("at this torque, no equilibrium of the planets was found");
      turn.add(state, at);
      for (std::size_t f = 0; f < at.size() && ++at[f] == turn.positions(); ++f) at[f] = 0;
    }
    for (std::size_t f = 0; f < first.size(); ++f) {
      std::vector<double>& loaded = curves_[frequency(first[f])].loaded;
      for (std::size_t j = 0; j < loaded.size(); ++j) loaded[j] += turn.output[f][j];
    }
    coupling_ += turn.coupling();
    sets_.push_back(std::move(turn.shares));
    return std::nullopt;
  }

  // Returns the springs of the meshes if the meshes of each frequency f are at the position at[f].
  std::vector<std::vector<MeshState>> states_at(const std::vector<std::size_t>& loaded,
                                                const std::vector<std::size_t>& first,
                                                const std::vector<std::size_t>& at) const {
    std::vector<std::vector<MeshState>> states(loaded.size());
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      const auto f = std::find(first.begin(), first.end(), phases_[loaded[k]].first);
      const MeshUnderLoad& mesh = meshes_[loaded[k]];
      for (std::size_t i = 0; i < mesh.at.size(); ++i)
        states[k].push_back(mesh.state(i, at[static_cast<std::size_t>(f - first.begin())]));
    }
    return states;
  }

  bool holds(const PlanetSet& set, std::size_t body) const {
    if (set.group.carrier == body) return true;
    return std::any_of(set.group.meshes.begin(), set.group.meshes.end(), [&](std::size_t m) {
      const DriveMesh& mesh = drive_.graph.meshes[m];
      return drive_.graph.gear(mesh, 0).body == body || drive_.graph.gear(mesh, 1).body == body;
    });
  }

  // Returns the index of the curve whose first mesh is `first`.
  std::size_t frequency(std::size_t first) const {
    std::size_t index = 0;
    for (std::size_t m = 0; m < first; ++m) index += phases_[m].first == m ? 1 : 0;
    return index;
  }

  void add_error(LoadedDrive::Curve& curve, DriveError& error) const {
    const auto n = static_cast<double>(positions_);
    for (std::vector<double>* values : {&curve.loaded, &curve.rigid}) {
      const double mean = std::accumulate(values->begin(), values->end(), 0.0) / n;
      for (double& v : *values) v -= mean;
    }
    const auto [least, greatest] = std::minmax_element(curve.loaded.begin(), curve.loaded.end());
    error.peak_to_peak += *greatest - *least;
    for (int k = 1; k <= load_.harmonics && 2 * k < positions_; ++k) {
      std::complex<double> wave = 0.0;
      for (int j = 0; j < positions_; ++j)
        wave += curve.loaded[static_cast<std::size_t>(j)] *
                std::polar(1.0, -kTurn * static_cast<double>(k * j % positions_) / n);
      error.lines.push_back({k * curve.frequency_ratio, 2 * std::abs(wave) / n});
    }
  }

  const Drive& drive_;
  const DriveLoadCase& load_;
  int positions_;
  std::vector<MeshPhase> phases_;
  std::vector<MeshUnderLoad> meshes_;
  std::vector<LoadedDrive::Curve> curves_;
  std::vector<PlanetShares> sets_;
  double coupling_ = 0.0;
};

}  // namespace

double PlanetShares::mean(std::size_t planet) const {
  const auto& of = share[planet];
  return std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
}

std::pair<std::size_t, double> PlanetShares::mesh_load_factor() const {
  return *std::max_element(mesh_load_factors.begin(), mesh_load_factors.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
}

Result<LoadedDrive> loaded_drive(const Drive& drive, const DriveLoadCase& load,
                                 Progress* progress) {
  GW_EXPECTS(load.requests.size() == drive.graph.meshes.size());
  if (auto error = check_load(drive, load)) return *error;
  DriveUnderLoad under(drive, load);
  if (auto error = under.make(progress)) return *error;
  return under.result();
}

}  // namespace gearwright
