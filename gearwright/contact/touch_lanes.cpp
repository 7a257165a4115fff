#include "gearwright/contact/touch_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/gear/leaf_formulas.hpp"

namespace gearwright::detail {

namespace {

using namespace leaf;
using std::abs;
using std::sqrt;

double round_of(double x) { return std::nearbyint(x); }
bool both(bool a, bool b) { return a && b; }
bool not_of(bool a) { return !a; }
bool all_of(bool a) { return a; }

#define GW_LEAF_INLINE inline
#define GW_LEAF_LAMBDA
#include "gearwright/contact/touch_lanes.inc"
#undef GW_LEAF_LAMBDA
#undef GW_LEAF_INLINE

constexpr int kMostSteps = 12;  // six are usual for a start in the middle of the line of contact
constexpr double kLongestStep = 0.6;

// The polar angle of a flank minus arg(1 + i c ξ), as a polynomial of the roll angle ξ and of z. c
// is the side of the flank, ±1.
struct FlankAngle {
  double base_radius;  // mm
  double at_0, by_xi, by_xi2, by_z, by_z2;
};

// LaneSearch requires an involute whose modifications are polynomials of second degree in L = r_b
// |ξ| and in z, without mixed terms. The derivatives at one point then give all coefficients.
std::optional<FlankAngle> angle_of(const FlankPatch& f, double xi_mid) {
  const Involute* curve = f.profile.involute();
  if (!curve) return std::nullopt;
  const double c = f.profile.side();
  const double r_b = curve->base_radius();
  FlankAngle a{r_b, c * (curve->base_half_angle() - xi_mid) + f.center, -c, 0.0, f.twist, 0.0};
  if (!f.removal || f.removal->none()) return a;
  if (f.removal->has_topography() || f.removal->wavy() || f.removal->base_radius() != r_b)
    return std::nullopt;
  const double u = 0.5 * std::log(r_b * r_b * (1.0 + xi_mid * xi_mid));
  const Removal m = f.removal->at(u, 0.0, f.piece);
  const double turn = -c * f.profile.turn_per_removal(xi_mid).k;
  const double xi_u = (1.0 + xi_mid * xi_mid) / xi_mid;
  const double xi_uu = xi_u * (1.0 - 1.0 / (xi_mid * xi_mid));
  const double by_xi = m.c_u / xi_u;
  const double z_sign = f.removal_z;
  a.at_0 += turn * m.c;
  a.by_xi += turn * by_xi;
  a.by_xi2 = 0.5 * turn * (m.c_uu - by_xi * xi_uu) / (xi_u * xi_u);
  a.by_z += turn * z_sign * m.c_z;
  a.by_z2 = 0.5 * turn * m.c_zz;
  return a;
}

double kind_of(int bound) { return bound < 0 ? -1.0 : bound / 2; }
double sign_of(int bound) { return bound % 2 == 0 ? 1.0 : -1.0; }

}  // namespace

void touch_step_scalar(LaneBlock& block) {
  for (std::size_t i = 0; i < kLaneBlock; ++i)
    step_of<double>([&](LaneIn k) { return block.in[static_cast<std::size_t>(k)][i]; },
                    [&](LaneOut k, double v) { block.out[static_cast<std::size_t>(k)][i] = v; });
}

std::optional<LaneSearch> LaneSearch::of(const Transmission& transmission) {
  const ContactPair& pair = transmission.pair();
  if (pair.is_rack()) return std::nullopt;
  LaneSearch search;
  search.turn1_ = pair.rotation_sign();
  search.turn2_ = pair.ratio();
  const Mat3& m = pair.mount().rotation.matrix();
  const Vec3& shift = pair.mount().shift.r;
  std::vector<std::optional<FlankAngle>> angles;
  for (const FlankPatch& two : pair.patches(2))
    angles.push_back(angle_of(two, 0.5 * (two.s_lo + two.s_hi)));
  for (const FlankPatch& one : pair.patches(1)) {
    const double s_mid = 0.5 * (one.s_lo + one.s_hi);
    const auto a = angle_of(one, s_mid);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const FlankPatch& two = pair.patches(2)[i];
      const double xi_mid = 0.5 * (two.s_lo + two.s_hi);
      const auto& b = angles[i];
      if (!a || !b) return std::nullopt;
      const double r1 = a->base_radius, r2 = b->base_radius;
      const double n_lo = std::exp(2 * two.u_lo), n_hi = std::exp(2 * two.u_hi);
      search.fields_.push_back({r1,
                                one.profile.side(),
                                s_mid,
                                0.5 * (one.s_hi - one.s_lo),
                                0.5 * (one.z_lo + one.z_hi),
                                0.5 * (one.z_hi - one.z_lo),
                                a->at_0,
                                a->by_xi,
                                a->by_xi2,
                                a->by_z,
                                a->by_z2,
                                1.0 / (r2 * r2),
                                two.profile.side(),
                                xi_mid < 0.0 ? -1.0 : 1.0,
                                xi_mid,
                                b->at_0,
                                b->by_xi,
                                b->by_xi2,
                                b->by_z,
                                b->by_z2,
                                m(0, 0),
                                m(0, 1),
                                m(0, 2),
                                m(1, 0),
                                m(1, 1),
                                m(1, 2),
                                m(2, 0),
                                m(2, 1),
                                m(2, 2),
                                shift.x(),
                                shift.y(),
                                shift.z(),
                                n_lo,
                                1.0 / (n_hi - n_lo),
                                two.z_lo,
                                1.0 / (two.z_hi - two.z_lo),
                                2.0 / (one.s_hi - one.s_lo),
                                2.0 / (one.z_hi - one.z_lo),
                                pair.rotation_sign(),
                                pair.ratio()});
      search.widths_.push_back({xi_mid, two.u_hi - two.u_lo});
    }
  }
  return search;
}

void LaneSearch::solve(std::vector<PairTouch>& touches) const {
  using I = LaneIn;
  using O = LaneOut;
  LaneBlock block;
  std::array<PairTouch*, kLaneBlock> owner{};
  std::array<int, kLaneBlock> steps{}, loaded;
  if (touches.empty()) return;
  loaded.fill(touches.front().fields);
  const auto& first = fields_[static_cast<std::size_t>(touches.front().fields)];
  for (std::size_t k = 0; k < static_cast<std::size_t>(I::s); ++k) block.in[k].fill(first[k]);
  const auto in = [&](I k, std::size_t i) -> double& {
    return block.in[static_cast<std::size_t>(k)][i];
  };
  const auto out = [&](O k, std::size_t i) { return block.out[static_cast<std::size_t>(k)][i]; };
  const auto set_bounds = [&](std::size_t i, const ActiveSet& active) {
    in(I::kind_a, i) = kind_of(active.first);
    in(I::sign_a, i) = sign_of(active.first);
    in(I::kind_b, i) = kind_of(active.second);
    in(I::sign_b, i) = sign_of(active.second);
  };
  std::size_t next = 0, busy = 0;
  ActiveSet last, chosen;
  const auto take_next = [&](std::size_t i) {
    if (owner[i]) --busy;
    owner[i] = nullptr;
    if (next == touches.size()) return;
    PairTouch& t = touches[next++];
    const auto& field = fields_[static_cast<std::size_t>(t.fields)];
    if (loaded[i] != t.fields)
      for (std::size_t k = 0; k < static_cast<std::size_t>(I::s); ++k) block.in[k][i] = field[k];
    loaded[i] = t.fields;
    in(I::b1_0, i) = field[static_cast<std::size_t>(I::b1_0)] + turn1_ * t.phi;
    in(I::b2_0, i) = field[static_cast<std::size_t>(I::b2_0)] + turn2_ * t.phi;
    in(I::s, i) = t.touch.s;
    in(I::z, i) = t.touch.z;
    in(I::mu_a, i) = in(I::mu_b, i) = 0.0;
    // If the start is not a touch, the active bounds of the touch found last are tried first.
    if (!t.touch.found()) t.touch.active = last;
    set_bounds(i, t.touch.active);
    owner[i] = &t;
    steps[i] = 0;
    ++busy;
  };
  for (std::size_t i = 0; i < kLaneBlock; ++i) take_next(i);
  while (busy > 0) {
    touch_step(block);
    for (std::size_t i = 0; i < kLaneBlock; ++i) {
      if (!owner[i]) continue;
      PairTouch& at = *owner[i];
      ++steps[i];
      const bool lost = out(O::astray, i) > 0.0 || steps[i] > kMostSteps;
      if (!lost && out(O::holds, i) > 0.0) {
        in(I::s, i) = out(O::s, i);
        in(I::z, i) = out(O::z, i);
        in(I::mu_a, i) = std::max(0.0, out(O::mu_a, i));
        in(I::mu_b, i) = std::max(0.0, out(O::mu_b, i));
        if (out(O::last, i) == 0.0) continue;
        Touch& t = at.touch;
        t.stop = Touch::Stop::converged;
        t.te = out(O::te, i);
        t.flat = out(O::flat, i) > 0.0;
        t.s = in(I::s, i);
        t.z = in(I::z, i);
        const std::array<double, 2>& of_flank2 = widths_[static_cast<std::size_t>(at.fields)];
        t.s2 = of_flank2[0];
        // LaneSearch bounds N = |W|², while TouchSearch bounds u = ln |W|. The multiplier of a
        // bound of N is therefore converted to the multiplier of the corresponding bound of u.
        const auto price = [&](I kind, I mu) {
          const double k = in(kind, i);
          return k > 1.5 && k < 2.5 ? in(mu, i) * out(O::by_n, i) * of_flank2[1] : in(mu, i);
        };
        t.multiplier = {price(I::kind_a, I::mu_a), price(I::kind_b, I::mu_b)};
        t.evaluations = steps[i];
        last = t.active;
        t.slope = out(O::slope, i);
        t.arm = out(O::arm, i);
        take_next(i);
        continue;
      }
      StepProblem p{out(O::g_s, i),  out(O::g_z, i),  out(O::h_ss, i),
                    out(O::h_sz, i), out(O::h_zz, i), {}};
      const double sigma = out(O::sigma, i), zeta = out(O::zeta, i);
      const double n = out(O::n, i), n_s = out(O::n_s, i), n_z = out(O::n_z, i);
      const double Z = out(O::Z, i), Z_s = out(O::Z_s, i), Z_z = out(O::Z_z, i);
      p.bounds = {{{sigma + 1, 1, 0},
                   {1 - sigma, -1, 0},
                   {zeta + 1, 0, 1},
                   {1 - zeta, 0, -1},
                   {n, n_s, n_z},
                   {1 - n, -n_s, -n_z},
                   {Z, Z_s, Z_z},
                   {1 - Z, -Z_s, -Z_z}}};
      const FeasibleStep step = lost ? FeasibleStep{} : solve_step(p, chosen);
      const double length = std::sqrt(step.d_s * step.d_s + step.d_z * step.d_z);
      if (lost || !step.feasible || !std::isfinite(length)) {
        at.fields = -1;
        take_next(i);
        continue;
      }
      const double limit = length > kLongestStep ? kLongestStep / length : 1.0;
      in(I::s, i) += step.d_s * limit * in(I::s_half, i);
      in(I::z, i) += step.d_z * limit * in(I::z_half, i);
      in(I::mu_a, i) = step.multiplier[0];
      in(I::mu_b, i) = step.multiplier[1];
      set_bounds(i, step.active);
      at.touch.active = chosen = step.active;
    }
  }
}

}  // namespace gearwright::detail
