#include "gearwright/drive/drive_error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/drive/drive_phases.hpp"
#include "gearwright/drive/drive_places.hpp"

namespace gearwright {

namespace {

using detail::MeshPhase;
using Wave = std::complex<double>;
constexpr int kMostHarmonics = kErrorPositions / 2 - 1;
/// rad; a smaller variation of a curve is a rounding error, as in contact_curve()
constexpr double kRounding = Angle::arcseconds(1e-9).rad();

Wave phasor(double turns) { return std::polar(1.0, kTurn * turns); }

// Returns e^{2πi turn/kErrorPositions}. `turn` is an integer, so the angle is exact.
Wave root_of_unity(int turn) {
  static const std::vector<Wave> all = [] {
    std::vector<Wave> list;
    for (int j = 0; j < kErrorPositions; ++j)
      list.push_back(phasor(static_cast<double>(j) / kErrorPositions));
    return list;
  }();
  return all[static_cast<std::size_t>(turn % kErrorPositions)];
}

// The harmonics of the transmission error of a mesh. There are none if the flanks are conjugate and
// the mesh has no errors, or if the mesh does not move the output.
struct MeshCurve {
  std::vector<Wave> waves;   // complex amplitudes of harmonics 0, 1, …, kErrorPositions/2
  std::vector<Wave> shares;  // for each harmonic: mean over the planets of e^{−2πikγ}
};

class DriveCurves {
 public:
  DriveCurves(const Drive& drive, const MeshErrors& errors) : drive_(drive), errors_(errors) {}

  // Computes the curves of the meshes that move the output. Returns false if this is impossible.
  bool make() {
    auto phases = detail::phases_of(drive_);
    if (!phases) return false;
    phases_ = std::move(*phases);
    curves_.resize(phases_.size());
    for (std::size_t m = 0; m < curves_.size(); ++m) {
      if (phases_[m].idle()) continue;
      if (!find_waves(m)) return false;
      find_shares(m);
    }
    return true;
  }

  DriveError error(int harmonics) const {
    DriveError found;
    for (const std::size_t first : frequencies()) {
      const auto teeth = drive_.frequency_ratio(first);
      // The time at which the first mesh of this frequency is at position 0 of its curve.
      const double begin = -phases_[first].event - phases_[first].time;
      std::vector<Wave> waves;
      for (int k = 0; k <= kErrorPositions / 2; ++k) waves.push_back(sum(first, k, begin));
      for (int k = 1; k <= harmonics; ++k)
        found.lines.push_back(
            {k * teeth.value_or(0.0), 2 * std::abs(waves[static_cast<std::size_t>(k)])});
      // Without errors, all waves are exactly 0. The frequency is then skipped to save time. A
      // search computes thousands of such drives.
      if (std::all_of(waves.begin(), waves.end(), [](const Wave& w) { return w == 0.0; })) continue;
      double least = 0.0, greatest = 0.0;
      for (int i = 0; i < kErrorPositions; ++i) {
        double value = 0.0;
        for (int k = 1; k <= kErrorPositions / 2; ++k)
          value += (2 * k < kErrorPositions ? 2 : 1) *
                   (waves[static_cast<std::size_t>(k)] * root_of_unity(k * i)).real();
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
  // Returns the transmission error of a mesh over one pitch. For a double-helical pair, this is the
  // error of both halves together. If the gears are seen from the other face, the half at z < 0 has
  // the hand that the drawing gives.
  static std::vector<double> curve_of(const ContactSetup& setup, bool gear2_drives, bool turned) {
    if (!setup.gear(1).gap)
      return gearwright::transmission_error(setup.pair(gear2_drives), kErrorPositions);
    const HalvesPair both =
        HalvesSetup(setup, 0.0, turned ? -1.0 : 1.0).pair(setup.place().errors, gear2_drives);
    return gearwright::transmission_error(both.mesh, kErrorPositions);
  }

  // Returns the transmission error of a mesh, rad. The result is empty if it cannot be computed.
  std::vector<double> of_mesh(std::size_t m, const ContactErrors& errors) const {
    if (m < drive_.contacts.size() && drive_.contacts[m]) {
      std::vector<double> te;
      for (const ContactPoint& p : drive_.contacts[m]->driving.positions)
        te.push_back(p.kind == TouchKind::none ? std::nan("") : p.te.rad());
      return te;
    }
    if (drive_.geometry.racks[m]) {
      const auto pair = detail::rack_contact(drive_, m, errors, phases_[m]);
      return pair ? gearwright::transmission_error(*pair, kErrorPositions) : std::vector<double>();
    }
    const auto setup = detail::mesh_contact(drive_, m, errors, phases_[m].turned);
    return setup ? curve_of(*setup, !phases_[m].first_drives, phases_[m].turned)
                 : std::vector<double>();
  }

  // Returns the transmission error of a mesh along the line of action, mm. It is > 0 if the driven
  // gear is ahead. of_mesh() returns an angle of gear 2, so the sign is changed if gear 2 drives.
  // The result is empty if the error cannot be computed.
  std::vector<double> along_line(std::size_t m, const ContactErrors& errors) const {
    std::vector<double> te = of_mesh(m, errors);
    // The travel of a rack is stored as an angle of the pinion.
    const auto& rack = drive_.geometry.racks[m];
    const double r_b =
        rack ? rack->pinion.base_radius() : drive_.geometry.pairs[m]->gear(2).base_radius();
    if (std::any_of(te.begin(), te.end(), [](double x) { return std::isnan(x); })) return {};
    if (peak_to_peak(te) < kRounding) return std::vector<double>(te.size(), 0.0);
    for (double& x : te) x *= phases_[m].first_drives ? r_b : -r_b;
    return te;
  }

  bool conjugate(std::size_t m, const ContactErrors& errors) const {
    const DriveMesh& mesh = drive_.graph.meshes[m];
    const auto& rack = drive_.geometry.racks[m];
    const double ratio = rack ? rack->true_contact_ratio() + rack->overlap_ratio
                              : drive_.geometry.pairs[m]->contact_ratio_true();
    return ratio >= 1.0 && errors == ContactErrors() &&
           !any_modification(drive_.graph.gear(mesh, 0).modifications) &&
           !any_modification(drive_.graph.gear(mesh, 1).modifications);
  }

  bool find_waves(std::size_t m) {
    MeshCurve& curve = curves_[m];
    const ContactErrors errors = errors_ ? errors_(m) : ContactErrors();
    if (conjugate(m, errors)) return true;
    const std::vector<double> e = along_line(m, errors);
    if (e.empty()) return false;
    curve.waves.assign(kErrorPositions / 2 + 1, 0.0);
    for (int k = 0; k <= kErrorPositions / 2; ++k) {
      Wave wave = 0.0;
      for (int j = 0; j < kErrorPositions; ++j) {
        // The curve starts half a pitch before its middle. The middle is the reference of the
        // phase.
        wave += (e[static_cast<std::size_t>(j)] - e[0]) *
                std::conj(root_of_unity(k * (j + kErrorPositions / 2)));
      }
      curve.waves[static_cast<std::size_t>(k)] = wave / double(kErrorPositions);
    }
    return true;
  }

  void find_shares(std::size_t m) {
    const MeshPhase& phase = phases_[m];
    if (curves_[m].waves.empty()) return;
    curves_[m].shares.assign(kErrorPositions / 2 + 1, 1.0);
    if (phase.phases.empty()) return;
    for (std::size_t k = 0; k < curves_[m].shares.size(); ++k) {
      Wave mean = 0.0;
      for (const Rational& gamma : phase.phases)
        mean += phasor(-phase.sense * (Rational(static_cast<long long>(k)) * gamma).frac().value());
      mean /= static_cast<double>(phase.phases.size());
      curves_[m].shares[k] = std::abs(mean) < 1e-12 ? Wave(0.0) : mean;  // smaller means are
                                                                         // rounding errors
    }
  }

  // Returns the first mesh of each frequency that affects the output.
  std::vector<std::size_t> frequencies() const {
    std::vector<std::size_t> list;
    for (std::size_t m = 0; m < phases_.size(); ++m)
      if (phases_[m].first == m && !phases_[m].idle()) list.push_back(m);
    return list;
  }

  // Returns the sum of harmonic k of all meshes of one frequency at the time t, as a rotation of
  // the output, rad.
  Wave sum(std::size_t first, int k, double t) const {
    Wave total = 0.0;
    for (std::size_t m = 0; m < curves_.size(); ++m) {
      const MeshPhase& p = phases_[m];
      if (p.first != first || curves_[m].waves.empty()) continue;
      const MeshCurve& c = curves_[m];
      const auto at = static_cast<std::size_t>(k);
      total += p.weight * c.waves[at] * c.shares[at] * phasor(k * (t + p.event - p.time));
    }
    return total;
  }

  const Drive& drive_;
  const MeshErrors& errors_;
  std::vector<MeshPhase> phases_;
  std::vector<MeshCurve> curves_;
};

}  // namespace

std::optional<DriveError> transmission_error(const Drive& drive, int harmonics,
                                             const MeshErrors& errors) {
  GW_EXPECTS(harmonics >= 1);
  if (drive.motion.freedom != 1 || !drive.motion.redundant.empty()) return std::nullopt;
  DriveCurves curves(drive, errors);
  if (!curves.make()) return std::nullopt;
  DriveError found = curves.error(std::min(harmonics, kMostHarmonics));
  found.lever = drive.lever(drive.graph.output);
  return found;
}

}  // namespace gearwright
