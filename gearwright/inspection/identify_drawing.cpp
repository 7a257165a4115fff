// Computes the values with which a drawing describes an identified gear: the basic rack, the
// profile shift, the thickness allowance and the tip diameter.
//
//   x_E   generating profile shift, from the thickness of the teeth     x    profile shift
//   E_sn  thickness allowance, 2 m_n tan α_n (x_E − x)                  d_a  tip diameter
//   x_a   profile shift that follows from the tip, (d_a − d)/(2 m_n) − h_aP* [T10.34]
//                                              theory: docs/theory/10-inspection.md
//
// Spans and balls determine only x_E. The tip diameter depends on x. The root diameter depends on
// x_E, because a tooth is thinned by feeding the cutter deeper.
#include <algorithm>
#include <cmath>
#include <vector>

#include "gearwright/generation/outline.hpp"
#include "gearwright/inspection/identify_model.hpp"
#include "gearwright/inspection/thickness_series.hpp"

namespace gearwright::detail {

namespace {

// Lengths in modules.
constexpr double kMostUsualAllowance = 0.1;  // upper limit of a usual allowance, unless
                                             // kUsualSeries gives a smaller limit
constexpr double kMostAllowance = 0.2;       // a greater allowance is implausible
constexpr double kNearTip = 0.02;            // usual tolerance of a tip radius
constexpr double kMinusTip = 0.05;           // greatest undersize that indicates x = 0
constexpr double kMostWear = 0.1;            // greatest wear of a tip radius
constexpr double kShortestTip = 0.25;        // greatest plausible deviation from the tip that the
                                             // rack gives; a greater one contradicts the flanks
// The usual series of DIN 3967 with the greatest allowance, for gears without required backlash.
constexpr std::string_view kUsualSeries = "c27";

// Standard deviations, in modules, for the comparison of racks, and the costs of a tip and of a
// root that no rack explains.
constexpr double kWearScatter = 0.05;
constexpr double kUsualAllowance = 0.06;
constexpr double kAllowanceScatter = 0.04;
constexpr double kRootScatterOfRack = 0.04;
constexpr double kMostTipCost = 8.0;
constexpr double kMostRootCost = 4.5;

struct RackChoice {
  std::string_view name;
  StraightRack rack;
  double log_prior;
};

// Returns the named racks that a gear of this series and pressure angle can have.
std::vector<RackChoice> rack_choices(ModuleSeries series, double alpha) {
  const auto is = [&](double degrees) {
    return std::abs(alpha - Angle::degrees(degrees).rad()) < 1e-9;
  };
  std::vector<RackChoice> list;
  const auto iso = [&](std::string_view name, double share) {
    list.push_back({name, *iso53_rack(name), std::log(share)});
  };
  const auto agma = [&](std::string_view name, double share) {
    const AgmaRack& rack = *agma_rack(name);
    if (is(rack.normal_pressure_angle.deg())) list.push_back({name, rack.rack, std::log(share)});
  };
  if (series == ModuleSeries::diametral_pitch) {
    agma("AGMA-14.5", 1.0);
    agma("AGMA-20", 0.85);
    agma("AGMA-25", 1.0);
    agma("AGMA-stub", 0.1);
    if (list.empty()) iso("ISO53-A", 1.0);
    if (is(20)) iso("ISO53-D", 0.05);
  } else {
    iso("ISO53-A", 0.85);
    iso("ISO53-D", 0.1);
    agma("AGMA-14.5", 0.1);
    agma("AGMA-stub", 0.01);
  }
  return list;
}

double square(double v) { return v * v; }

// The numbers of one gear that the functions below share. Lengths are in mm, as in the readings.
class Drawing {
 public:
  Drawing(const IdentifyProblem& p, const GearNumbers& g, double shift_uncertainty)
      : p_(p),
        m_(g.module),
        tan_(std::tan(g.alpha)),
        side_(side_of(g.teeth)),
        d_(std::abs(g.teeth) * g.module / std::cos(g.beta)),
        x_E_(g.shift),
        u_(shift_uncertainty),
        by_thickness_(!p.spans.empty() || !p.balls.empty()) {
    if (p.profile_shift) {
      known_ = p.profile_shift;
    } else if (p.thickness_allowance) {
      known_ = x_E_ - *p.thickness_allowance / (2 * m_ * tan_);
    }
    usual_ = kMostUsualAllowance;
    if (const auto ends = thickness_allowances(kUsualSeries, d_))
      usual_ = std::min(usual_, -(*ends)[0] / m_);
    near_ = kNearTip + p.tip.uncertainty.value_or(kLength) / (2 * m_);
  }

  DrawnGear with(const RackChoice& choice) const {
    DrawnGear gear;
    gear.rack = choice.name;
    gear.profile_shift = shift(choice.rack);
    const double allowance = 2 * m_ * tan_ * (x_E_ - gear.profile_shift);
    // If the tooth is thicker than x gives, but only by less than the uncertainty, the
    // allowance is 0.
    const bool within = allowance > 0.0 && !known_ && x_E_ - gear.profile_shift <= u_;
    gear.thickness_allowance = within ? 0.0 : allowance;
    gear.nominal_tip_diameter = d_ + side_ * 2 * m_ * (choice.rack.addendum + gear.profile_shift);
    gear.root_diameter = d_ - side_ * 2 * m_ * (choice.rack.dedendum - x_E_);
    gear.shift_of_tip = shift_of_tip(choice.rack);
    set_tip(gear);
    return gear;
  }

  double log_worth(const RackChoice& choice) const {
    double cost = 0.0;
    const auto x_a = shift_of_tip(choice.rack);
    if (x_a && by_thickness_) {
      const double x = known_.value_or(x_E_);
      const double shorter = std::max(0.0, x - *x_a - u_);
      const double thinner = known_ ? std::max(0.0, *x_a - x - near_)
                                    : std::max(0.0, 2 * tan_ * (*x_a - x) - kUsualAllowance);
      cost += std::min(kMostTipCost,
                       (square(shorter / kWearScatter) + square(thinner / kAllowanceScatter)) / 2);
    }
    if (p_.root.value) cost += std::min(kMostRootCost, square(root_misfit(choice.rack)) / 2);
    return choice.log_prior - cost;
  }

  std::optional<Contradiction> contradiction(const DrawnGear& gear,
                                             const StraightRack& rack) const {
    if (!by_thickness_) return std::nullopt;
    if (const auto x_a = gear.shift_of_tip) {
      const double longer = known_ ? *x_a - gear.profile_shift - kShortestTip
                                   : 2 * tan_ * (*x_a - x_E_ - u_) - kMostAllowance;
      if (longer > 0.0 || gear.profile_shift - *x_a > kShortestTip)
        return Contradiction{Reading::tip_diameter, 0.0, *p_.tip.value, gear.nominal_tip_diameter};
    }
    if (p_.root.value && root_misfit(rack) > 3.0)
      return Contradiction{Reading::root_diameter, 0.0, *p_.root.value, gear.root_diameter};
    return std::nullopt;
  }

 private:
  std::optional<double> shift_of_tip(const StraightRack& rack) const {
    if (!p_.tip.value) return std::nullopt;
    return side_ * (*p_.tip.value - d_) / (2 * m_) - rack.addendum;
  }

  // Returns the distance of the measured root from the root of this rack, in standard deviations.
  double root_misfit(const StraightRack& rack) const {
    const double depth = side_ * (d_ - *p_.root.value) / (2 * m_) + x_E_;
    const double reading = p_.root.uncertainty.value_or(kLength) / (2 * m_);
    return std::abs(depth - rack.dedendum) /
           std::hypot(kRootScatterOfRack, std::hypot(reading, u_) / kSigmas);
  }

  // True if the allowance that belongs to the profile shift x is at least −`most` modules and is
  // positive only within the uncertainty of x_E.
  bool leaves(double x, double most) const {
    return x_E_ - x <= u_ && 2 * tan_ * (x_E_ - x) >= -most;
  }

  double shift(const StraightRack& rack) const {
    if (known_) return *known_;
    if (!by_thickness_) return x_E_;
    const auto x_a = shift_of_tip(rack);
    if (!x_a) return leaves(0.0, usual_) ? 0.0 : x_E_;
    const bool not_longer = *x_a <= near_;
    if (not_longer && *x_a >= -kMinusTip && leaves(0.0, kMostAllowance)) return 0.0;
    if (not_longer && (*x_a >= -kMostWear || *x_a < x_E_) && leaves(0.0, usual_)) return 0.0;
    return *x_a > x_E_ && leaves(*x_a, kMostAllowance) ? *x_a : x_E_;
  }

  void set_tip(DrawnGear& gear) const {
    gear.tip_diameter = gear.nominal_tip_diameter;
    gear.tip = TipReading::none;
    if (!p_.tip.value) return;
    const double longer = side_ * (*p_.tip.value - gear.nominal_tip_diameter) / (2 * m_);
    if (longer > 0.0 || longer < -kMostWear) gear.tip_diameter = *p_.tip.value;
    gear.tip = longer > near_         ? TipReading::longer
               : longer >= -kNearTip  ? TipReading::as_drawn
               : longer >= -kMostWear ? TipReading::worn
                                      : TipReading::shortened;
  }

  const IdentifyProblem& p_;
  double m_, tan_, side_, d_, x_E_, u_;
  bool by_thickness_;            // true if there are spans or balls, which determine x_E
  std::optional<double> known_;  // x, if it is known
  double usual_, near_;
};

}  // namespace

DrawnGear drawn_gear(const IdentifyProblem& problem, const GearNumbers& gear, ModuleSeries series,
                     double shift_uncertainty) {
  const Drawing drawing(problem, gear, shift_uncertainty);
  const std::vector<RackChoice> choices = problem.rack
                                              ? std::vector<RackChoice>{{"", *problem.rack, 0.0}}
                                              : rack_choices(series, gear.alpha);
  const auto best = std::max_element(choices.begin(), choices.end(),
                                     [&](const RackChoice& a, const RackChoice& b) {
                                       return drawing.log_worth(a) < drawing.log_worth(b);
                                     });
  DrawnGear drawn = drawing.with(*best);
  drawn.contradiction = drawing.contradiction(drawn, best->rack);
  return drawn;
}

}  // namespace gearwright::detail
