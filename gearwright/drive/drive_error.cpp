#include "gearwright/drive/drive_error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/drive/drive_places.hpp"

namespace gearwright {

namespace {

using Wave = std::complex<double>;
constexpr int kMostHarmonics = kErrorPositions / 2 - 1;
/// rad; a curve with less variation contains only rounding errors, as in contact_curve()
constexpr double kRounding = Angle::arcseconds(1e-9).rad();

Wave phasor(double turns) { return std::polar(1.0, kTurn * turns); }

// The transmission error of a mesh as waves, with its position in time.
struct MeshCurve {
  bool first_drives = true;
  double weight = 0.0;  // rad of the output per mm of the curve
  double event = 0.0;   // position of the pitch point in the curve, in periods
  double time = 0.0;  // delay of that event after the first mesh of the same frequency, in periods
  std::vector<Wave> waves;   // amplitudes of the harmonics 0, 1, …, kErrorPositions/2
  std::vector<Wave> shares;  // of each harmonic: mean over the planets of e^{−2πikγ}
};

using Flanks = std::array<FlankModifications, 2>;

// The flanks of a gear seen from its other face. The gear then turns in the opposite direction, and its
// right flank becomes the left one. None for a flank with a measured topography.
std::optional<Flanks> turned_over(const Flanks& flanks) {
  Flanks turned{flanks[1], flanks[0]};
  for (FlankModifications& flank : turned) {
    if (flank.topography) return std::nullopt;
    flank.lead_slope = -flank.lead_slope;
  }
  return turned;
}

ContactErrors turned_over(ContactErrors errors) {
  errors.intersecting = -1.0 * errors.intersecting;
  errors.axial = -errors.axial;
  return errors;
}

class DriveCurves {
 public:
  DriveCurves(const Drive& drive, const MeshErrors& errors) : drive_(drive), errors_(errors) {}

  // Computes the curves of all meshes. Returns false if a number is missing.
  bool make() {
    const DriveGraph& graph = drive_.graph;
    const auto to_output = lossless_loads(graph, drive_.motion, graph.output);
    const auto to_input = lossless_loads(graph, drive_.motion, graph.inputs.front());
    for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
      curves_.emplace_back();
      const auto& pair = drive_.geometry.pairs[m];
      if (!pair || !pair->involute() || !to_output[m].fits() || !to_input[m].fits()) return false;
      MeshCurve& curve = curves_.back();
      curve.first_drives = first_drives(m, to_input[m].value());
      const Gear& gear = pair->gear(1);
      curve.weight =
          std::abs(to_output[m].value()) * kTurn / gear.reference().base_pitch_transverse;
      const double share = thickness_share(*pair->involute(), 1) / 2;
      curve.event = curve.first_drives ? -share : share;
      if (!find_waves(m, *pair)) return false;
      find_shares(m);
    }
    return find_times();
  }

  DriveError error(int harmonics) const {
    DriveError found;
    for (const std::size_t first : frequencies()) {
      const auto teeth = drive_.frequency_ratio(first);
      for (int k = 1; k <= harmonics; ++k)
        found.lines.push_back({k * teeth.value_or(0.0), 2 * std::abs(sum(first, k, 0.0))});
      double least = 0.0, greatest = 0.0;
      for (int i = 0; i < kErrorPositions; ++i) {
        // The time of position i of the curve of the first mesh.
        const double t =
            static_cast<double>(i) / kErrorPositions - curves_[first].event - curves_[first].time;
        double value = 0.0;
        for (int k = 1; k <= kErrorPositions / 2; ++k)
          value += (2 * k < kErrorPositions ? 2 : 1) * sum(first, k, t).real();
        least = i == 0 ? value : std::min(least, value);
        greatest = i == 0 ? value : std::max(greatest, value);
      }
      found.peak_to_peak += greatest - least;
    }
    std::stable_sort(found.lines.begin(), found.lines.end(), [](const auto& a, const auto& b) {
      return a.frequency_ratio < b.frequency_ratio;
    });
    return found;
  }

 private:
  // ω of a body relative to the frame of the mesh.
  double turning(std::size_t body, std::size_t mesh) const {
    const auto frame = drive_.graph.frame(drive_.graph.meshes[mesh]);
    const auto& speeds = drive_.motion.speeds;
    return (speeds[body][0] - (frame ? speeds[*frame][0] : Rational())).value();
  }

  bool first_drives(std::size_t m, double load) const {
    if (drive_.flow && !drive_.flow->self_locking() && drive_.flow->driver[m] >= 0)
      return drive_.flow->driver[m] == 0;
    const DriveGear& a = drive_.graph.gear(drive_.graph.meshes[m], 0);
    return -a.factor() * load * turning(a.body, m) > 0.0;
  }

  // The transmission error of a mesh over one pitch. For a double-helical pair it is that of the whole
  // gears. If these are turned over, the half with the hand of the drawing is at z < 0.
  static std::vector<double> curve_of(const ContactSetup& setup, bool gear2_drives, bool turned) {
    if (!setup.gear(1).gap)
      return gearwright::transmission_error(setup.pair(gear2_drives), kErrorPositions);
    const double side = turned ? -1.0 : 1.0;
    const std::array middles{side * middle_of_half(setup.gear(1)),
                             side * middle_of_half(setup.gear(2))};
    const ContactSetup one = setup.half_at(middles, false), image = setup.half_at(middles, true);
    const ContactPair a = one.pair(gear2_drives), b = image.pair(gear2_drives);
    return gearwright::transmission_error(HalvesMesh{&setup.gear(1), {&a, &b}}, kErrorPositions);
  }

  bool find_waves(std::size_t m, const Pair& pair) {
    MeshCurve& curve = curves_[m];
    curve.waves.assign(kErrorPositions / 2 + 1, 0.0);
    const DriveGraph& graph = drive_.graph;
    PairModifications flanks{graph.gear(graph.meshes[m], 0).modifications,
                             graph.gear(graph.meshes[m], 1).modifications};
    ContactErrors errors = errors_ ? errors_(m) : ContactErrors();
    const bool modified = any_modification(flanks[0]) || any_modification(flanks[1]);
    const bool whole = pair.involute()->contact_ratio_true() >= 1.0;
    if (!modified && whole && errors == ContactErrors()) return true;
    // The contact analysis of a pair turns gear 1 clockwise.
    const bool turned = turning(graph.gear(graph.meshes[m], 0).body, m) > 0.0;
    if (turned) {
      for (Flanks& of_gear : flanks) {
        const auto over = turned_over(of_gear);
        if (!over) return false;
        of_gear = *over;
      }
      errors = turned_over(errors);
    }
    const auto setup = ContactSetup::of(pair, errors, flanks);
    if (!setup) return false;
    const bool gear2_drives = !curve.first_drives;
    const auto te = curve_of(*setup, gear2_drives, turned);
    if (std::any_of(te.begin(), te.end(), [](double x) { return std::isnan(x); })) return false;
    if (peak_to_peak(te) < kRounding) return true;
    // The error is > 0 if gear 2 is ahead of gear 1. If gear 2 drives, gear 1 is the driven gear, and
    // the sign changes.
    const double r_b = pair.gear(2).base_radius() * (gear2_drives ? -1 : 1);
    for (int k = 0; k <= kErrorPositions / 2; ++k) {
      Wave wave = 0.0;
      for (int j = 0; j < kErrorPositions; ++j) {
        // The curve starts half a pitch before its middle. With integers, vanishing waves are exactly 0.
        const int turn = k * (j + kErrorPositions / 2) % kErrorPositions;
        wave += (te[static_cast<std::size_t>(j)] - te[0]) *
                phasor(-static_cast<double>(turn) / kErrorPositions);
      }
      curve.waves[static_cast<std::size_t>(k)] = wave * r_b / double(kErrorPositions);
    }
    return true;
  }

  const PlanetSet* set_of(std::size_t m) const {
    for (const PlanetSet& set : drive_.sets)
      if (std::find(set.group.meshes.begin(), set.group.meshes.end(), m) != set.group.meshes.end())
        return &set;
    return nullptr;
  }

  // The copies of a planet mesh later by γ. If planets mesh with each other, γ is that of the central
  // gear whose mesh has the same frequency.
  void find_shares(std::size_t m) {
    const DriveGraph& graph = drive_.graph;
    curves_[m].shares.assign(kErrorPositions / 2 + 1, 1.0);
    const PlanetSet* set = set_of(m);
    if (!set) return;
    std::optional<std::size_t> central;
    for (const std::size_t other : set->group.meshes)
      if (!central && (other == m || drive_.frequency_ratio(other) == drive_.frequency_ratio(m)))
        for (const std::size_t g : graph.meshes[other].gears)
          if (!graph.body(graph.gears[g]).carrier) central = g;
    if (!central) return;
    const DriveGear& gear = graph.gears[*central];
    const double sense = gear.factor() * turning(gear.body, m) < 0.0 ? -1.0 : 1.0;
    const auto phases = mesh_phases(gear.teeth, set->assembly.turns);
    for (std::size_t k = 0; k < curves_[m].shares.size(); ++k) {
      Wave mean = 0.0;
      for (const Rational& phase : phases)
        mean += phasor(-sense * (Rational(static_cast<long long>(k)) * phase).frac().value());
      mean /= static_cast<double>(phases.size());
      curves_[m].shares[k] = std::abs(mean) < 1e-12 ? Wave(0.0) : mean;  // rounding of N terms
    }
  }

  // The direction from the axis of a gear to its mesh m, turns.
  std::optional<double> direction(std::size_t m, std::size_t gear) const {
    const DriveMesh& mesh = drive_.graph.meshes[m];
    const DriveGear& a = drive_.graph.gear(mesh, 0);
    const DriveGear& b = drive_.graph.gear(mesh, 1);
    double theta = mesh.direction.value_or(Angle()).rad();
    if (const PlanetSet* set = set_of(m)) {
      const auto one = place_of(*set, a.body), two = place_of(*set, b.body);
      if (!one || !two) return std::nullopt;
      theta = std::arg(*two - *one);
    }
    const bool towards_b = gear == mesh.gears[0] && b.teeth > 0;
    return theta / kTurn + (towards_b ? 0.0 : 0.5);
  }

  std::optional<Wave> place_of(const PlanetSet& set, std::size_t body) const {
    const auto& riders = set.group.riders;
    const auto at = std::find(riders.begin(), riders.end(), body);
    if (at == riders.end()) return 0.0;
    std::optional<GeometryFault> fault;
    const auto places = rider_places(drive_.graph, set.group, drive_.geometry.distance, fault);
    if (!places) return std::nullopt;
    const RiderPlace& place = (*places)[static_cast<std::size_t>(at - riders.begin())];
    return std::polar(place.distance, place.angle);
  }

  // Time at which the loaded flank of the gear passes the pitch point of a mesh, periods. [T13.17]
  std::optional<double> passing(std::size_t m, int side) const {
    const DriveMesh& mesh = drive_.graph.meshes[m];
    const DriveGear& gear = drive_.graph.gear(mesh, side);
    const auto theta = direction(m, mesh.gears[static_cast<std::size_t>(side)]);
    if (!theta) return std::nullopt;
    const double sense = turning(gear.body, m) < 0.0 ? -1.0 : 1.0;
    const bool drives = curves_[m].first_drives == (side == 0);
    const double half = thickness_share(*drive_.geometry.pairs[m]->involute(), side + 1) / 2;
    return sense * std::abs(gear.teeth) * *theta + (drives ? -half : half);
  }

  // Computes the delays of all meshes. Meshes that share a gear are followed one after the other.
  bool find_times() {
    const DriveGraph& graph = drive_.graph;
    chain_.assign(curves_.size(), curves_.size());
    for (std::size_t first = 0; first < curves_.size(); ++first) {
      if (chain_[first] != curves_.size()) continue;
      chain_[first] = first;
      std::vector<std::size_t> reached{first};
      for (std::size_t at = 0; at < reached.size(); ++at) {
        const std::size_t m = reached[at];
        for (std::size_t n = 0; n < curves_.size(); ++n) {
          if (chain_[n] != curves_.size() ||
              graph.frame(graph.meshes[n]) != graph.frame(graph.meshes[m]))
            continue;
          for (const int i : {0, 1})
            for (const int j : {0, 1}) {
              const DriveGear& one = graph.gear(graph.meshes[m], i);
              const DriveGear& two = graph.gear(graph.meshes[n], j);
              if (one.body != two.body || one.teeth != two.teeth || chain_[n] == first) continue;
              const auto here = passing(m, i), there = passing(n, j);
              if (!here || !there) return false;
              curves_[n].time = curves_[m].time + *there - *here;
              chain_[n] = first;
              reached.push_back(n);
            }
        }
      }
    }
    return true;
  }

  // The first mesh of each chain.
  std::vector<std::size_t> frequencies() const {
    std::vector<std::size_t> list;
    for (std::size_t m = 0; m < chain_.size(); ++m)
      if (chain_[m] == m) list.push_back(m);
    return list;
  }

  // Harmonic k of all meshes of a chain at time t, rad of the output.
  Wave sum(std::size_t first, int k, double t) const {
    Wave total = 0.0;
    for (std::size_t m = 0; m < curves_.size(); ++m) {
      if (chain_[m] != first) continue;
      const MeshCurve& c = curves_[m];
      const auto at = static_cast<std::size_t>(k);
      total += c.weight * c.waves[at] * c.shares[at] * phasor(k * (t + c.event - c.time));
    }
    return total;
  }

  const Drive& drive_;
  const MeshErrors& errors_;
  std::vector<MeshCurve> curves_;
  std::vector<std::size_t> chain_;  // for each mesh: the first mesh with its frequency
};

}  // namespace

std::optional<DriveError> transmission_error(const Drive& drive, int harmonics,
                                             const MeshErrors& errors) {
  GW_EXPECTS(harmonics >= 1);
  const auto is_rack = [](const DriveGear& gear) { return gear.rack; };
  if (drive.motion.freedom != 1 || !drive.motion.redundant.empty() ||
      std::any_of(drive.graph.gears.begin(), drive.graph.gears.end(), is_rack))
    return std::nullopt;
  DriveCurves curves(drive, errors);
  if (!curves.make()) return std::nullopt;
  return curves.error(std::min(harmonics, kMostHarmonics));
}

}  // namespace gearwright
