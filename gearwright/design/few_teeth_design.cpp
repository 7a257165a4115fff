#include "gearwright/design/few_teeth_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/generation/pinion_envelope.hpp"
#include "gearwright/math/root.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright {

namespace {

constexpr int kSteepestHelix = 75;     // degrees; greatest helix angle
constexpr double kMinTipFillet = 0.1;  // least radius of the pinion's tip fillet, modules; with a
                                       // smaller radius, the cutter, which has the same fillet,
                                       // would overheat
constexpr double kSameRatio = 0.02;
// Sums of shifts, modules, count as equal if they differ by less than this value. The grid has
// steps of 0.001.
constexpr double kSameGivenSum = 1e-6;
// Helix angles are rounded to 1/kHelixSteps of a degree, so that drawings can show them exactly.
constexpr double kHelixSteps = 1e9;
// Relative amount by which the least centre distance exceeds the sum of the base radii.
constexpr double kOffBase = 1e-9;
// Relative rounding error between two computations of the same radius.
constexpr double kSameRadius = 1e-9;

// The rank of a feasible candidate. The contact ratio in steps of 0.02 is compared first, then |x1
// + x2|.
struct Rank {
  double ratio, sum;  // contact ratio and |x1 + x2|, as whole numbers of steps

  static Rank of(double ratio, double shift_sum) {
    return {std::floor(ratio / kSameRatio), std::round(std::abs(shift_sum) / kSameGivenSum)};
  }
  bool is_better_than(const Rank& other) const {
    return ratio != other.ratio ? ratio > other.ratio : sum < other.sum;
  }
};

// The last check that a candidate reached, and the condition that rejected the candidate.
struct DesignVerdict {
  int stage = 0;
  double shortfall =
      0.0;  // amount by which the check failed; among the candidates that failed at the same check,
            // the one with the smallest amount is reported
  std::string limit;
  std::optional<FewTeethDesign> design;
};

DesignVerdict stopped(int stage, std::string limit, double shortfall = 0.0) {
  return {stage, shortfall, std::move(limit), std::nullopt};
}

// A candidate whose gears have been cut, but are not mounted yet: both gears, the generating
// distance of the wheel (`distance`) and the intended centre distance of the pair (`mounted`), mm.
struct Cut {
  CylindricalSpec pinion, cutter;
  Gear gear_1, gear_2;
  double distance, mounted;
};

struct Candidate {
  double x1, x2;
  DesignVerdict verdict;
  std::optional<Rank> rank;
};

// Returns the chord of the tooth space at the start of the flanks.
double gap_of(const Gear& gear) {
  const Arc* flank = gear.tooth->outline.find(ArcName::flank);
  const Vec2& p = flank->begin_point;
  const double half = std::numbers::pi / std::abs(gear.spec.teeth) - std::atan2(p.y(), p.x());
  return 2 * p.norm() * std::sin(half);
}

class FewTeethSearch {
 public:
  explicit FewTeethSearch(const FewTeethProblem& p) : p_(p), side_(side_of(p.teeth[1])) {}

  DesignVerdict best;
  int tried = 0;

  void run() {
    const bool wheel_free = !(p_.center_distance && p_.helix);
    double x1 = 0.5, x2 = -0.5;
    double step = 0.05;
    scan(p_.pinion_shift ? 0.0 : 1.5, wheel_free ? 2.5 : 0.0, step, x1, x2);
    while (best.design && step > 0.0005) {
      step /= 5;
      const double reach = 6 * step;
      scan(p_.pinion_shift ? 0.0 : reach, wheel_free ? reach : 0.0, step, best_x1_, best_x2_);
    }
  }

 private:
  void scan(double reach1, double reach2, double step, double x1, double x2) {
    const int n1 = static_cast<int>(std::lround(reach1 / step));
    const int n2 = static_cast<int>(std::lround(reach2 / step));
    std::vector<Candidate> all;
    for (int i = -n1; i <= n1; ++i) {
      // Shifts are rounded to as many decimals as drawings show.
      for (int k = -n2; k <= n2; ++k)
        all.push_back({p_.pinion_shift.value_or(std::round((x1 + i * step) * 1000) / 1000),
                       std::round((x2 + k * step) * 1000) / 1000,
                       {},
                       std::nullopt});
    }
    tried += static_cast<int>(all.size());
    begin_stage(p_.progress, "testing pairs of profile shifts",
                static_cast<std::int64_t>(all.size()));
    // Candidates are independent, so the result does not depend on the number of threads.
    parallel_for(all.size(), [&](std::size_t i) {
      Candidate& c = all[i];
      const auto cut = cut_gears(c.x1, c.x2, c.verdict);
      if (cut) c.rank = rank_of(*cut);
      count_step(p_.progress);
    });
    mount_the_best(all);
    if (best.design) return;
    for (Candidate& c : all) {
      if (got_further(c.verdict)) best = std::move(c.verdict);
    }
  }

  // Mounts candidates until one is accepted. The candidates are mounted in the order of their
  // ranks. If ranks are equal, the order of the grid applies.
  void mount_the_best(std::vector<Candidate>& all) {
    std::vector<Candidate*> order;
    for (Candidate& c : all) {
      if (c.rank && !(best.design && !c.rank->is_better_than(best_rank_))) order.push_back(&c);
    }
    std::stable_sort(order.begin(), order.end(), [](const Candidate* a, const Candidate* b) {
      return a->rank->is_better_than(*b->rank);
    });
    // Candidates are mounted in parallel in groups of 1, 2, 4 and so on. The first groups are
    // small, because usually one of the first candidates is accepted.
    begin_stage(p_.progress, "mounting the pairs", static_cast<std::int64_t>(order.size()));
    std::size_t together = 1;
    for (std::size_t from = 0; from < order.size(); from += together, together *= 2) {
      together = std::min({together, std::size_t{64}, order.size() - from});
      parallel_for(together, [&](std::size_t i) {
        Candidate& c = *order[from + i];
        auto cut = cut_gears(c.x1, c.x2, c.verdict);
        c.verdict = mounted(std::move(*cut));
        count_step(p_.progress);
      });
      for (std::size_t i = from; i < from + together; ++i) {
        Candidate& c = *order[i];
        if (!c.verdict.design) continue;
        best = std::move(c.verdict);
        best_rank_ = *c.rank;
        best_x1_ = c.x1;
        best_x2_ = c.x2;
        return;
      }
    }
  }

  bool got_further(const DesignVerdict& v) const {
    return v.stage > best.stage || (v.stage == best.stage && v.shortfall < best.shortfall);
  }

  static Rank rank_of(const Cut& cut) {
    const auto input = mesh_input(cut.gear_1, cut.gear_2, {cut.mounted, std::nullopt});
    // If the centre distance is at most the sum of the base radii, the gears cannot mesh. The
    // contact ratio of such a candidate is set to 0, so that it is tried last.
    const bool meshes = cut.mounted > base_radius_sum(input.gears);
    const double ratio = meshes ? mesh_of(input).true_ratio : 0.0;
    return Rank::of(std::isfinite(ratio) ? ratio : 0.0,
                    cut.pinion.profile_shift + cut.gear_2.spec.profile_shift);
  }

  CylindricalSpec cutter_spec(double beta, double x1) const {
    CylindricalSpec c;
    c.teeth = p_.teeth[0];
    c.normal_module = p_.normal_module;
    c.normal_pressure_angle = p_.normal_pressure_angle;
    c.helix_angle =
        Angle::degrees(std::round(Angle::radians(beta).deg() * kHelixSteps) / kHelixSteps);
    c.profile_shift = x1;
    c.face_width = p_.face_width.value_or(10 * p_.normal_module);
    c.rack = p_.rack;
    c.root_fillet = RootFilletSpec{p_.root_offset};
    const double r_t = std::max(kMinTipFillet * p_.normal_module, p_.min_tip_land / 2);
    c.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, r_t};
    return c;
  }

  double transverse_angle(double beta) const {
    return std::atan(std::tan(p_.normal_pressure_angle.rad()) / std::cos(beta));
  }
  // Returns the sum of the base radii; for an internal pair, their difference.
  double base_distance(double beta) const {
    const int z = p_.teeth[0] + p_.teeth[1];
    return p_.normal_module * std::abs(z) / (2 * std::cos(beta)) * std::cos(transverse_angle(beta));
  }

  std::optional<double> distance_at(double beta, double x1, double x2) const {
    const double inv = nominal_working_involute(
        p_.teeth[0], p_.teeth[1], p_.normal_pressure_angle.rad(), transverse_angle(beta), x1 + x2);
    if (!(inv >= 0.0)) return std::nullopt;
    return base_distance(beta) / std::cos(inverse_involute(inv));
  }

  double play_of(double beta, double x1, double x2) const {
    if (p_.backlash == 0.0) return 0.0;
    const auto e = distance_at(beta, x1, x2);
    const double r = base_distance(beta);
    if (!e || !(*e > r)) return 0.0;
    return p_.backlash / (2 * std::sqrt((*e - r) * (*e + r)) / r);
  }

  std::optional<double> helix_of(double x1, double x2) const {
    if (p_.helix) return p_.helix->rad();
    const auto miss = [&](double beta) {
      const auto e = distance_at(beta, x1, x2);
      return e ? *e + side_ * play_of(beta, x1, x2) - *p_.center_distance : kNoNumber;
    };
    // `miss` is the difference from the given centre distance. If the shifts have no backlash-free
    // centre distance, `miss` is NaN. The search therefore proceeds in steps of one degree.
    double before = 0.0;
    for (int degree = 1; degree <= kSteepestHelix; ++degree) {
      const double beta = Angle::degrees(degree).rad();
      if (miss(before) <= 0.0 && miss(beta) >= 0.0) return find_root(miss, before, beta).x;
      before = beta;
    }
    return std::nullopt;
  }

  // Computes the generating centre distance E for a given helix angle and centre distance a. E is
  // the solution of E + σ j/(2 tan α_wt) = a, where j is the backlash. The shift of the wheel
  // follows from E.
  std::optional<double> distance_within(const Gear& cutter) const {
    const double r =
        cutter.base_radius() * std::abs(1.0 + static_cast<double>(p_.teeth[1]) / p_.teeth[0]);
    const double a = *p_.center_distance;
    if (p_.backlash == 0.0) return a;
    const auto miss = [&](double e) {
      return e + side_ * p_.backlash * r / (2 * std::sqrt((e - r) * (e + r))) - a;
    };
    const double lo = r * (1 + kOffBase);
    // Unless the gears are near their base circles, the backlash changes the centre distance only
    // slightly. E then lies close to a.
    const double hi = side_ > 0.0 ? a : 2 * a;
    if (!(lo < hi)) return std::nullopt;
    const double from = side_ > 0.0 ? std::max(lo, a - 0.5 * (a - r)) : a;
    if (!(miss(from) <= 0.0 && miss(hi) >= 0.0)) return std::nullopt;
    return find_root(miss, from, hi).x;
  }

  // Cuts the gears of a candidate. If they cannot be cut, the reason is stored in `verdict`.
  std::optional<Cut> cut_gears(double x1, double x2, DesignVerdict& verdict) const {
    auto made = candidate(x1, x2);
    if (auto* cut = std::get_if<Cut>(&made)) return std::move(*cut);
    verdict = std::get<DesignVerdict>(std::move(made));
    return std::nullopt;
  }

  using Made = std::variant<DesignVerdict, Cut>;

  Made candidate(double x1, double x2) const {
    const auto beta = helix_of(x1, x2);
    if (!beta)
      return stopped(1, "the centre distance, which requires a helix angle of more than 75°");
    const CylindricalSpec spec = cutter_spec(*beta, x1);
    auto cutter = make_gear(spec);
    if (!cutter) return stopped(2, "the pinion's fillets: " + cutter.error().quoted());
    if (!cutter->exists() || !cutter->tooth->form_radius || !cutter->tooth->rounded_tip)
      return stopped(2, "a pinion tooth that ends before its tip fillet");
    double distance = 0.0;
    double mounted = 0.0;
    if (p_.center_distance) {
      mounted = *p_.center_distance;
      const auto within = p_.helix ? distance_within(*cutter)
                                   : std::optional(mounted - side_ * play_of(*beta, x1, x2));
      if (!within) return stopped(3, "the centre distance, which leaves no room for the backlash");
      distance = *within;
    } else {
      const auto e = generating_distance(*cutter, p_.teeth[1], x2);
      if (!e) return stopped(3, "the wheel: " + e.error().quoted());
      distance = *e;
      const double r_t =
          cutter->base_radius() * std::abs(1.0 + static_cast<double>(p_.teeth[1]) / p_.teeth[0]);
      const double tan_w = std::sqrt((distance - r_t) * (distance + r_t)) / r_t;
      mounted = distance + side_ * p_.backlash / (2 * tan_w);
    }
    auto whole = make_pinion_cut_gear(*cutter, {p_.teeth[1], distance, spec.face_width, {}});
    if (!whole) return stopped(4, "the wheel: " + whole.error().quoted());
    return finished(spec, *cutter, *whole, distance, mounted);
  }

  Made finished(const CylindricalSpec& spec, const Gear& cutter, const Gear& whole, double distance,
                double mounted) const {
    if (!whole.exists() || !whole.tooth->form_radius) return stopped(5, "a wheel without teeth");
    if (whole.undercut) return stopped(6, "undercut of the wheel");
    if (has_cusp(cutter, whole, distance)) return stopped(7, "a cusp at the wheel's tip");
    CylindricalSpec pinion = spec;
    pinion.tip_diameter = 2 * (cutter.tooth->tip_radius - p_.clearance);
    const double wheel_tip = 2 * (whole.tooth->tip_radius - side_ * p_.clearance);
    if (pinion.tip_diameter <= 2 * *cutter.tooth->tip_form_radius) pinion.tip_fillet.reset();
    const auto g1 = make_gear(pinion);
    const auto g2 =
        make_pinion_cut_gear(cutter, {p_.teeth[1], distance, spec.face_width, wheel_tip});
    if (!g1 || !g2 || g1->pointed() || g2->pointed() || !g2->tooth->form_radius)
      return stopped(8, "the tip clearance, which leaves no tooth");
    for (const Gear* g : {&*g1, &*g2}) {
      const int which = g == &*g1 ? 1 : 2;
      const double land = tip_width(*g);
      if (land < p_.min_tip_land) {
        return stopped(
            9,
            fmt::format(
                "the land at the tip of gear {}, which is {:.3f} mm instead of at least {} mm",
                which, land, p_.min_tip_land),
            p_.min_tip_land - land);
      }
      const double gap = gap_of(*g);
      if (gap < p_.min_gap) {
        return stopped(10,
                       fmt::format("the tooth space at the root of gear {}, which is {:.3f} mm "
                                   "wide instead of at least {} mm",
                                   which, gap, p_.min_gap),
                       p_.min_gap - gap);
      }
    }
    return Cut{pinion, spec, *g1, *g2, distance, mounted};
  }

  DesignVerdict mounted(Cut cut) const {
    auto pair = mount_as<ParallelPair>(std::move(cut.gear_1), std::move(cut.gear_2), {cut.mounted});
    if (!pair) return stopped(11, pair.error().quoted());
    if (!pair->interference.empty())
      return stopped(12, "interference: " + pair->interference.front().message);
    if (!pair->beyond_flank.empty())
      return stopped(12, "contact beyond the flank: " + pair->beyond_flank.front().message);
    if (!(pair->contact_ratio_true() > 0.0)) return stopped(13, "teeth that do not touch");
    return made(cut.pinion, cut.cutter, std::move(pair).take(), cut.distance, cut.mounted);
  }

  DesignVerdict made(CylindricalSpec pinion, const CylindricalSpec& cutter, ParallelPair pair,
                     double distance, double mounted) const {
    const auto needed = face_width_for_total(pair, p_.contact_ratio);
    double face = p_.face_width.value_or(0.0);
    if (!needed)
      return stopped(14,
                     fmt::format("the contact ratio of {:.3f}, which a helix angle would increase",
                                 pair.mesh.true_ratio),
                     p_.contact_ratio - pair.mesh.true_ratio);
    if (!p_.face_width) face = std::max(std::ceil(*needed * 10) / 10, p_.normal_module);
    if (face < *needed)
      return stopped(14,
                     fmt::format("the face width, which is {:.2f} mm instead of the {:.2f} mm that "
                                 "a contact ratio of {} requires",
                                 face, std::ceil(*needed * 100) / 100, p_.contact_ratio),
                     *needed - face);
    pinion.face_width = face;
    FewTeethDesign design;
    design.pinion = pinion;
    design.cutter = cutter;
    design.wheel_tip_diameter = pair.gears[1].tip_diameter;
    design.wheel_shift = pair.gears[1].spec.profile_shift;
    design.generating_distance = distance;
    design.center_distance = mounted;
    design.face_width = face;
    design.pair = std::move(pair);
    return {15, 0.0, "", std::move(design)};
  }

  // True if the concave root of the pinion cuts a cusp into the wheel. The flank of the wheel then
  // ends before the point that is conjugate to the start of the pinion's flank.
  bool has_cusp(const Gear& cutter, const Gear& whole, double distance) const {
    const Arc& flank = *cutter.tooth->outline.find(ArcName::flank);
    const auto& involute = curve_as<Involute>(*flank.curve);
    const auto cut = pinion_involute({p_.teeth[0], p_.teeth[1], distance}, involute);
    const double end = cut->flank.base_radius() * std::hypot(1.0, cut->roll(flank.begin));
    return std::abs(*whole.tooth->tip_form_radius - end) > kSameRadius * end;
  }

  // Returns the width of the finished tip. If a fillet rounds the whole tip, this is the diameter
  // of the fillet. Otherwise, it is the width of the tip land.
  static double tip_width(const Gear& g) {
    if (g.tooth->rounded_tip && g.tooth->tip_fillet) return 2 * g.tooth->tip_fillet->radius;
    return g.tip_tooth_thickness_normal.value_or(0.0);
  }

  const FewTeethProblem& p_;
  double side_;
  Rank best_rank_{};
  double best_x1_ = 0.0, best_x2_ = 0.0;
};

}  // namespace

Result<FewTeethAnswer> design_few_teeth(const FewTeethProblem& problem) {
  if (!problem.helix && !problem.center_distance) {
    return absent_input(gear_field(1, "helix_angle"),
                        "; a pinion with few teeth needs a helix angle, or `pair.center_distance`, "
                        "from which the helix angle is computed");
  }
  if (problem.teeth[1] < 0 && -problem.teeth[1] <= problem.teeth[0]) {
    return refused(
        gear_field(2, "teeth"), problem.teeth[1],
        fmt::format("an internal gear must have more teeth than its pinion (gear 1 has {})",
                    problem.teeth[0]));
  }
  FewTeethSearch search(problem);
  search.run();
  return FewTeethAnswer{std::move(search.best.design), search.best.limit, search.tried};
}

}  // namespace gearwright
