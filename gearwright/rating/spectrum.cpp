#include "gearwright/rating/spectrum.hpp"

#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

constexpr double kLastCycles = 1e10;
constexpr int kHalvings = 60;

// The strength of the flank or root of one gear, σ(N) = σ_0 Z(N) (σ_ref/σ_0)^w(N). Z is the life
// factor, and w is Life::reference.
struct Strength {
  MaterialKind kind;
  bool flank;
  double basic;      // σ_0: σ_Hlim for the flank, σ_Flim Y_ST Y_M for the root
  double reference;  // σ_ref, the strength at the reference number of cycles

  double at(double cycles, const LifeChoice& choice) const {
    const Life life = flank ? flank_life(kind, cycles, choice) : root_life(kind, cycles, choice);
    return basic * life.factor.value * std::pow(reference / basic, life.reference);
  }
  // Returns N(σ), infinite below the strength at 10¹⁰ cycles and 0 above the static strength.
  double cycles(double stress, const LifeChoice& choice) const {
    if (stress <= at(kLastCycles, choice)) return kInfinity;
    double lo = 0.0, hi = std::log10(kLastCycles);
    if (stress > at(1.0, choice)) return 0.0;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (lo + hi) / 2;
      (at(std::pow(10.0, middle), choice) >= stress ? lo : hi) = middle;
    }
    return std::pow(10.0, lo);
  }
};

struct Step {
  double stress, cycles;
  Strength strength;
};

double damage(const std::vector<Step>& steps, double factor, const LifeChoice& choice) {
  double sum = 0.0;
  for (const Step& s : steps) {
    const double bears = s.strength.cycles(factor * s.stress, choice);
    if (bears == 0.0) return kInfinity;
    sum += s.cycles / bears;
  }
  return sum;
}

double safety(const std::vector<Step>& steps, const LifeChoice& choice) {
  double lo = std::log(1e-3), hi = std::log(1e3);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (lo + hi) / 2;
    (damage(steps, std::exp(middle), choice) <= 1.0 ? lo : hi) = middle;
  }
  return std::exp(lo);
}

}  // namespace

RatingInput input_of(const LoadBin& step, RatingInput input) {
  input.application_factor = 1.0;
  input.torque = step.torque;
  input.speed = step.speed;
  input.life_h.reset();
  if (step.face_load_factor) input.face_load_factor = step.face_load_factor;
  return input;
}

Result<SpectrumRating> rate_spectrum(const RatedPair& pair, const RatingInput& input,
                                     const std::vector<LoadBin>& spectrum) {
  GW_EXPECTS(!spectrum.empty());
  std::array<std::vector<Step>, 2> flank, root;
  for (const LoadBin& bin : spectrum) {
    GW_EXPECTS(bin.torque > 0.0 && bin.speed > 0.0 && bin.hours > 0.0);
    const RatingInput in = input_of(bin, input);
    const auto rated = rate(pair, in);
    if (!rated) return rated.error();
    for (std::size_t i = 0; i < 2; ++i) {
      const Material& m = in.materials[i];
      const double teeth =
          pair.gears[pair.place(1)].teeth /
          static_cast<double>(pair.gears[pair.place(static_cast<int>(i) + 1)].teeth);
      const double cycles = 60.0 * bin.hours * bin.speed * std::abs(teeth);
      flank[i].push_back({rated->sigma_H[i].value,
                          cycles,
                          {m.kind, true, m.sigma_Hlim, rated->sigma_HG[i].value}});
      const double basic = m.sigma_Flim * rated->Y_ST[i].value * rated->Y_M[i].value;
      root[i].push_back(
          {rated->sigma_F[i].value, cycles, {m.kind, false, basic, rated->sigma_FG[i].value}});
    }
  }
  SpectrumRating r{};
  for (std::size_t i = 0; i < 2; ++i) {
    r.damage_flank[i] = damage(flank[i], 1.0, input.life);
    r.damage_root[i] = damage(root[i], 1.0, input.life);
    r.S_H[i] = safety(flank[i], input.life);
    r.S_F[i] = safety(root[i], input.life);
  }
  return r;
}

}  // namespace gearwright
