#include "gearwright/inspection/identify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/generation/outline.hpp"
#include "gearwright/inspection/identify_model.hpp"

namespace gearwright {

namespace {

using namespace detail;  // NOLINT(google-build-using-namespace): internal parts of this folder
using std::numbers::pi;

constexpr double kNothing = 1e-4;  // least likelihood of a candidate in the list
constexpr double kMostHelix = 45;  // degrees; worms have greater helix angles
// A hypothesis, which is a rack with its fit and its evidence.
struct Found {
  StandardRack rack;
  RackFit fit;
  double log_worth;
};

// Logarithms of the prior probabilities that the helix angle is 0, any angle, or a given whole
// number of degrees.
struct HelixPrior {
  double spur = std::log(0.45), any = std::log(0.10), whole = std::log(0.45 / 63);
  double of_degrees(int n) const { return whole + (n % 5 == 0 ? std::log(3.0) : 0.0); }
};

class Searching {
 public:
  Searching(const IdentifyProblem& problem, std::vector<Observation> readings)
      : problem_(problem), readings_(std::move(readings)) {}

  std::vector<Found> all() {
    std::vector<Found> found;
    for (const StandardRack& rack : standard_racks()) {
      if (problem_.normal_pressure_angle &&
          std::abs(problem_.normal_pressure_angle->rad() - rack.alpha) > kSameAngle)
        continue;
      if (possible(rack.module, rack.alpha)) add(rack, found);
    }
    if (const auto module = module_of_pitch()) {
      // A nonstandard module with the known or the usual pressure angle is also tried.
      const double alpha = problem_.normal_pressure_angle.value_or(Angle::degrees(20)).rad();
      add({*module / std::cos(alpha), alpha, ModuleSeries::none, {}, kLogOwnModule}, found);
    }
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.log_worth > b.log_worth; });
    return found;
  }

 private:
  static constexpr double kSameAngle = 1e-6;
  static constexpr double kLogOwnModule = -3.5;

  // Returns the base pitch and its standard deviation, computed from the span over the least and
  // the span over the greatest number of teeth. Returns none if all spans are over the same number
  // of teeth.
  std::optional<std::array<double, 2>> base_pitch() const {
    const Observation *least = nullptr, *most = nullptr;
    for (const Observation& o : readings_) {
      if (o.kind != Reading::span) continue;
      if (!least || o.tool < least->tool) least = &o;
      if (!most || o.tool > most->tool) most = &o;
    }
    if (!least || most->tool == least->tool) return std::nullopt;
    const double apart = most->tool - least->tool;
    return std::array{(most->value - least->value) / apart,
                      std::hypot(most->sigma, least->sigma) / apart};
  }
  std::optional<double> module_of_pitch() const {
    const auto pitch = base_pitch();
    return pitch && (*pitch)[0] > 0.0 ? std::optional((*pitch)[0] / pi) : std::nullopt;
  }

  // True if a gear of this rack can agree with the base pitch that follows from the spans. Without
  // such a base pitch, the gear must roughly agree with the readings that depend on the size.
  bool possible(double m, double alpha) const {
    if (const auto pitch = base_pitch())
      return std::abs(pi * m * std::cos(alpha) - (*pitch)[0]) < 6 * (*pitch)[1];
    const double z = std::abs(problem_.teeth);
    const double most = 1 / std::cos(kMostHelix * kRadPerDeg);
    for (const Observation& o : readings_) {
      const double size = o.value / m;
      switch (o.kind) {
        case Reading::tip_diameter:
        case Reading::over_balls:
        case Reading::root_diameter:
          if (size < z - 5 || size > z * most + 5) return false;
          break;
        case Reading::center_distance:
          if (2 * size < std::abs(problem_.teeth + o.tool) - 3 ||
              2 * size > std::abs(problem_.teeth + o.tool) * most + 3)
            return false;
          break;
        case Reading::span:
          if (size < (o.tool - 2) * pi * std::cos(alpha) || size > (o.tool + 2) * pi + z / 20)
            return false;
          break;
        default: break;
      }
    }
    return true;
  }

  void take(const StandardRack& rack, const std::optional<RackFit>& fit, double log_prior,
            std::vector<Found>& found) const {
    if (!fit) return;
    found.push_back({rack, *fit, rack.log_prior + log_prior + fit->log_evidence});
  }

  void add(const StandardRack& rack, std::vector<Found>& found) const {
    const bool own = rack.series == ModuleSeries::none;
    const Unknowns of_shift{.shift = true, .helix = false, .module = own};
    const Unknowns of_both{.shift = true, .helix = true, .module = own};
    const auto at = [&](double beta) {
      return GearNumbers{problem_.teeth, rack.module, rack.alpha, beta, 0.0};
    };
    if (problem_.helix_angle)
      return take(rack, fit_rack(at(std::abs(problem_.helix_angle->rad())), of_shift, readings_),
                  0.0, found);
    const HelixPrior prior;
    const auto spur = fit_rack(at(0.0), of_shift, readings_);
    take(rack, spur, prior.spur, found);
    if (measured_as_spur_ring()) return;
    std::optional<RackFit> best;
    std::vector<RackFit> fits;  // one for each helix angle
    if (spur) fits.push_back(*spur);
    for (int degrees = 1; degrees <= kMostHelix; ++degrees) {
      const GearNumbers gear = at(degrees * kRadPerDeg);
      if (!own && off_the_lead(gear)) continue;
      const auto fit = fit_rack(gear, of_shift, readings_);
      take(rack, fit, prior.of_degrees(degrees), found);
      if (fit) fits.push_back(*fit);
      if (fit && (!best || fit->log_evidence > best->log_evidence)) best = fit;
    }
    const GearNumbers start = best ? best->gear : at(lead_angle(rack.module).value_or(0.2));
    auto any = fit_rack(start, of_both, readings_);
    if (any) integrate_near_spur(fits, *any);
    take(rack, any, prior.any, found);
  }

  // Readings depend on β², so near β = 0 the evidence of a free helix angle is no normal
  // distribution of β. There, the function replaces Laplace's approximation by the integral over
  // the fits for β = 0 and for whole numbers of degrees [T10.41].
  static void integrate_near_spur(const std::vector<RackFit>& fits, RackFit& any) {
    constexpr double kStep = kRadPerDeg, kRange = kMostHelix * kRadPerDeg;
    if (any.sigma_helix < kStep || any.gear.beta > 2 * any.sigma_helix || fits.empty()) return;
    double top = -std::numeric_limits<double>::infinity(), sum = 0.0, square = 0.0;
    for (const RackFit& f : fits) top = std::max(top, f.log_evidence);
    for (const RackFit& f : fits) {
      const double weight = std::exp(f.log_evidence - top) * (f.gear.beta == 0.0 ? 0.5 : 1.0);
      const double off = f.gear.beta - any.gear.beta;
      sum += weight;
      square += weight * off * off;
    }
    any.log_evidence = top + std::log(sum * kStep / kRange);
    any.sigma_helix = std::max(kStep / 2, std::sqrt(square / sum));
  }

  bool has(Reading kind) const {
    return std::any_of(readings_.begin(), readings_.end(),
                       [&](const Observation& o) { return o.kind == kind; });
  }
  // True for an internal gear with a span, unless a lead or a helix angle is measured as well.
  // Plane anvils do not fit into the spaces of an internal helical gear.
  bool measured_as_spur_ring() const {
    return problem_.teeth < 0 && has(Reading::span) && !has(Reading::lead) &&
           !has(Reading::helix_angle);
  }

  // True if the measured lead or helix angle rules out the helix angle of this gear.
  bool off_the_lead(const GearNumbers& gear) const {
    return std::any_of(readings_.begin(), readings_.end(), [&](const Observation& o) {
      if (o.kind != Reading::lead && o.kind != Reading::helix_angle) return false;
      return std::abs(*residual(gear, o)) > 8.0;
    });
  }
  std::optional<double> lead_angle(double module) const {
    for (const Observation& o : readings_) {
      if (o.kind == Reading::helix_angle) return o.value;
      if (o.kind != Reading::lead) continue;
      const double sine = o.value * pi * std::abs(problem_.teeth) * module;
      if (sine < 0.99) return std::asin(sine);
    }
    return std::nullopt;
  }

  const IdentifyProblem& problem_;
  std::vector<Observation> readings_;
};

// Returns the greatest acceptable χ² of the exact readings. One gear in ten thousand exceeds it.
double most_misfit(const std::vector<Observation>& readings, const RackFit& fit) {
  const auto exact = std::count_if(readings.begin(), readings.end(),
                                   [](const Observation& o) { return o.exact(); });
  const double freedom = std::max(0.0, double(exact) - fit.free);
  return freedom > 0.0 ? 12.0 + 3.2 * freedom : 1.0;
}

// True if gear f has a fitted module, and gear k is the same gear with a standard module.
bool is_standard_gear(const Found& k, const Found& f) {
  const double module = 3 * f.fit.sigma_module;
  const double helix = 3 * (k.fit.sigma_helix + f.fit.sigma_helix) + 1e-9;
  return k.rack.series != ModuleSeries::none && f.rack.series == ModuleSeries::none &&
         k.rack.alpha == f.rack.alpha &&
         std::abs(k.fit.gear.module - f.fit.gear.module) <= module &&
         std::abs(k.fit.gear.beta - f.fit.gear.beta) <= helix;
}

// Removes every gear with a fitted module that a likelier gear with a standard module explains. No
// helix angle is removed, because the hypotheses of [T10.39] exclude each other.
std::vector<Found> without_doubles(const std::vector<Found>& all) {
  std::vector<Found> kept;
  for (const Found& f : all)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Found& k) { return is_standard_gear(k, f); }))
      kept.push_back(f);
  return kept;
}

double signed_helix(const IdentifyProblem& p, double beta) {
  const bool left = (p.lead.value && *p.lead.value < 0.0) ||
                    (p.helix.value && p.helix.value->rad() < 0.0) ||
                    (p.helix_angle && p.helix_angle->rad() < 0.0);
  return left ? -beta : beta;
}

std::vector<IdentifiedGear> candidates_of(const IdentifyProblem& p,
                                          const std::vector<Found>& found) {
  std::vector<IdentifiedGear> list;
  if (found.empty()) return list;
  double sum = 0.0;
  const double top = found.front().log_worth;
  for (const Found& f : found) sum += std::exp(f.log_worth - top);
  for (const Found& f : found) {
    const double likelihood = std::exp(f.log_worth - top) / sum;
    if (likelihood < kNothing || static_cast<int>(list.size()) == kMostCandidates) break;
    const GearNumbers& g = f.fit.gear;
    const double shift_uncertainty = kSigmas * f.fit.sigma_shift;
    list.push_back({drawn_gear(p, g, f.rack.series, shift_uncertainty), p.teeth, g.module,
                    f.rack.series, f.rack.diametral_pitch, Angle::radians(g.alpha),
                    Angle::radians(signed_helix(p, g.beta)), g.shift, likelihood, f.fit.misfit,
                    kSigmas * f.fit.sigma_module, shift_uncertainty,
                    Angle::radians(kSigmas * f.fit.sigma_helix)});
  }
  return list;
}

// Finds the reading that contradicts all others. The other readings agree with a standard gear, and
// `found` then contains the hypotheses that they support.
std::optional<Contradiction> contradiction(const IdentifyProblem& p,
                                           const std::vector<Observation>& readings,
                                           std::vector<Found>& found) {
  std::optional<Contradiction> worst;
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!readings[i].exact()) continue;
    std::vector<Observation> others = readings;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    auto without = Searching(p, others).all();
    if (without.empty() || without.front().rack.series == ModuleSeries::none ||
        without.front().fit.misfit > most_misfit(others, without.front().fit) ||
        without.front().log_worth <= best)
      continue;
    const auto expected = reading_of(without.front().fit.gear, readings[i]);
    if (!expected) continue;
    best = without.front().log_worth;
    // An observed lead is the reciprocal of the reading, so that of a spur gear is 0.
    const auto as_read = [&](double value) -> std::optional<double> {
      if (readings[i].kind == Reading::lead)
        return value > 0.0 ? std::optional(1 / value) : std::nullopt;
      return readings[i].kind == Reading::helix_angle ? value * kDegPerRad : value;
    };
    worst = Contradiction{readings[i].kind, readings[i].tool, *as_read(readings[i].value),
                          as_read(*expected)};
    found = std::move(without);
  }
  return worst;
}

}  // namespace

Identification detail::identify_readings(const IdentifyProblem& problem, LeaveOut leave_out) {
  const std::vector<Observation> readings = observations(problem);
  std::vector<Found> found = Searching(problem, readings).all();
  Identification answer;
  const bool fits =
      !found.empty() && found.front().fit.misfit <= most_misfit(readings, found.front().fit);
  const bool several = readings.size() > 1;
  if (!fits && several && leave_out == LeaveOut::one)
    answer.contradiction = contradiction(problem, readings, found);
  found = without_doubles(found);
  if (found.empty() || (!fits && !answer.contradiction)) {
    answer.reason =
        found.empty() ? "no standard gear with this number of teeth has the measured size"
        : several
            ? "no standard gear matches these readings, even if one reading is left out"
            : "no standard gear matches this reading; check the reading and the number of teeth";
  }
  answer.candidates = candidates_of(problem, found);
  answer.next = next_measurement(problem, answer.candidates);
  return answer;
}

}  // namespace gearwright
