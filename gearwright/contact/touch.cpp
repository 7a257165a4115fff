#include "gearwright/contact/touch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

constexpr double kLastStep = 1e-7;    // scaled; the remaining error is the square of this length
constexpr double kLongestStep = 0.6;  // greatest step, relative to half the patch
constexpr double kFlatTouch = 1e-14;  // rad, scaled: smaller slopes are rounding errors
constexpr double kTinyBend = -1e-15;  // replaces a curvature of 0
constexpr int kMaxTouchSteps = 80;
constexpr double kBroken = 1e-9;       // scaled; greatest violation of a bound by a valid touch
constexpr double kWorse = 1e-13;       // rad; rounding error of the gap field T and of the merit
constexpr double kTinySquare = 1e-12;  // square of a scaled length; steps below it are not halved
constexpr double kMinPrice = 1e-3;     // rad per scaled length; least penalty of a violated bound
// Two touches count as one maximum if their T differs by less than kSameTe, rad, and their scaled
// distance is less than kSamePlace.
constexpr double kSameTe = 1e-12;
constexpr double kSamePlace = 1e-5;
// Makes H negative definite by changing the sign of positive eigenvalues. If T is constant in one
// direction within rounding, the function sets the slope in that direction to 0 and returns true.
bool make_concave(detail::StepProblem& p) {
  const double mean = 0.5 * (p.h_ss + p.h_zz);
  const double half = 0.5 * (p.h_ss - p.h_zz);
  const double root = std::sqrt(half * half + p.h_sz * p.h_sz);
  const double big = mean >= 0.0 ? mean + root : mean - root;
  double small = 0.0;
  if (big != 0.0) small = (p.h_ss * p.h_zz - p.h_sz * p.h_sz) / big;
  // Eigenvector of the eigenvalue `big`.
  double e_s = big - p.h_zz;
  double e_z = p.h_sz;
  if (std::abs(p.h_ss - big) > std::abs(p.h_zz - big)) {
    e_s = p.h_sz;
    e_z = big - p.h_ss;
  }
  const double length = std::sqrt(e_s * e_s + e_z * e_z);
  if (length > 0.0) {
    e_s /= length;
    e_z /= length;
  } else {
    e_s = 1.0;
    e_z = 0.0;
  }
  const double g_big = e_s * p.g_s + e_z * p.g_z;
  double g_small = -e_z * p.g_s + e_s * p.g_z;
  const bool flat = std::abs(small) < kFlatTouch && std::abs(g_small) < kFlatTouch;
  if (flat) g_small = 0.0;
  if (!flat && big < 0.0 && small < 0.0) return false;
  const auto bend = [](double h) { return std::min(-std::abs(h), kTinyBend); };
  const double h_big = bend(big);
  const double h_small = flat ? kTinyBend : bend(small);
  p.g_s = e_s * g_big - e_z * g_small;
  p.g_z = e_z * g_big + e_s * g_small;
  p.h_ss = e_s * e_s * h_big + e_z * e_z * h_small;
  p.h_zz = e_z * e_z * h_big + e_s * e_s * h_small;
  p.h_sz = e_s * e_z * (h_big - h_small);
  return flat;
}

// Returns the azimuth of flank 1 at s in the section z = 0 at the rotation of the field, in the
// frame N.
double azimuth_of(const GapField& field, double s) {
  const FlankPatch& a = field.one();
  const PolarJet p = a.profile.at(s);
  return std::arg(p.factor) + p.phase + a.center + field.rotation_sign() * field.rotation();
}

}  // namespace

TouchSearch::TouchSearch(const GapField& field, double mesh_azimuth, double reach)
    : field_(field), mesh_azimuth_(mesh_azimuth), reach_(reach) {
  const FlankPatch& a = field.one();
  const FlankPatch& b = field.two();
  scale_ = {0.5 * (a.s_lo + a.s_hi), 0.5 * (a.s_hi - a.s_lo), 0.5 * (a.z_lo + a.z_hi),
            0.5 * (a.z_hi - a.z_lo), b.u_hi - b.u_lo,         b.z_hi - b.z_lo};
}

double TouchSearch::bound(const GapJet& at, double s, double z, int j) const {
  const FlankPatch& a = field_.one();
  const FlankPatch& b = field_.two();
  switch (j) {
    case 0: return (s - a.s_lo) / scale_.s_half;
    case 1: return (a.s_hi - s) / scale_.s_half;
    case 2: return (z - a.z_lo) / scale_.z_half;
    case 3: return (a.z_hi - z) / scale_.z_half;
    case 4: return (at.u.v - b.u_lo) / scale_.u_width;
    case 5: return (b.u_hi - at.u.v) / scale_.u_width;
    case 6: return (at.Z.v - b.z_lo) / scale_.Z_width;
    default: return (b.z_hi - at.Z.v) / scale_.Z_width;
  }
}

void TouchSearch::fill(const GapJet& at, double s, double z, detail::StepProblem& p) const {
  const double ks = scale_.s_half;
  const double kz = scale_.z_half;
  p.g_s = at.t.s * ks;
  p.g_z = at.t.z * kz;
  p.h_ss = at.t.ss * ks * ks;
  p.h_sz = at.t.sz * ks * kz;
  p.h_zz = at.t.zz * kz * kz;
  const double u_s = at.u.s * ks / scale_.u_width;
  const double u_z = at.u.z * kz / scale_.u_width;
  const double Z_s = at.Z.s * ks / scale_.Z_width;
  const double Z_z = at.Z.z * kz / scale_.Z_width;
  p.bounds[0] = {0, 1, 0};
  p.bounds[1] = {0, -1, 0};
  p.bounds[2] = {0, 0, 1};
  p.bounds[3] = {0, 0, -1};
  p.bounds[4] = {0, u_s, u_z};
  p.bounds[5] = {0, -u_s, -u_z};
  p.bounds[6] = {0, Z_s, Z_z};
  p.bounds[7] = {0, -Z_s, -Z_z};
  for (int j = 0; j < detail::kBounds; ++j) p.bounds[j].c = bound(at, s, z, j);
}

Touch TouchSearch::from(double s, double z, double s2, const detail::ActiveSet& active) const {
  ++count_.searches;
  Touch t;
  t.s = s;
  t.z = z;
  t.s2 = s2;
  t.active = active;
  detail::StepProblem p;
  const double ks = scale_.s_half;
  const double kz = scale_.z_half;
  // The merit of a point is its T minus an exact penalty for violated bounds.
  double price = 0.0;
  const auto merit = [&](const GapJet& at) {
    double broken = 0.0;
    for (int j = 0; j < detail::kBounds; ++j) broken += std::max(0.0, -p.bounds[j].c);
    return at.t.v - price * broken;
  };
  double last_merit = -kInfinity;
  double d_s = 0.0;  // the last step, scaled
  double d_z = 0.0;
  GapJet at{};
  for (int i = 0; i < kMaxTouchSteps; ++i) {
    at = field_.at(t.s, t.z, t.s2);
    ++t.evaluations;
    ++count_.evaluations;
    fill(at, t.s, t.z, p);
    // A step that lowers the merit is halved. Very short steps are not halved, because their change
    // of the merit is a rounding error.
    if (const double now = merit(at);
        now < last_merit - kWorse && d_s * d_s + d_z * d_z > kTinySquare) {
      d_s *= 0.5;
      d_z *= 0.5;
      t.s -= d_s * ks;
      t.z -= d_z * kz;
      continue;
    }
    // The bounds of flank 2 are curved. The curvature of an active bound times its multiplier is
    // therefore added to H.
    for (int m = 0; m < 2; ++m) {
      const int j = m == 0 ? t.active.first : t.active.second;
      const double mu = t.multiplier[m];
      if (j < 4 || mu == 0.0) continue;
      const Jet2& c = j < 6 ? at.u : at.Z;
      const double k = (j % 2 == 0 ? mu : -mu) / (j < 6 ? scale_.u_width : scale_.Z_width);
      p.h_ss += k * c.ss * ks * ks;
      p.h_sz += k * c.sz * ks * kz;
      p.h_zz += k * c.zz * kz * kz;
    }
    t.flat = make_concave(p);
    const detail::FeasibleStep step = detail::solve_step(p, t.active);
    t.active = step.active;
    t.multiplier = step.multiplier;
    d_s = step.d_s;
    d_z = step.d_z;
    const double length = std::sqrt(d_s * d_s + d_z * d_z);
    if (!std::isfinite(length)) break;
    if (length < kLastStep) {
      t.te = at.t.v + (at.t.s * d_s * ks + at.t.z * d_z * kz) +
             0.5 * (at.t.ss * d_s * d_s * ks * ks + 2 * at.t.sz * d_s * d_z * ks * kz +
                    at.t.zz * d_z * d_z * kz * kz);
      t.s += d_s * ks;
      t.z += d_z * kz;
      t.stop = step.feasible ? Touch::Stop::converged : Touch::Stop::no_room;
      return t;
    }
    price = std::max(price, 10.0 * std::max(step.multiplier[0], step.multiplier[1]) + kMinPrice);
    last_merit = merit(at);
    if (length > kLongestStep) {
      d_s *= kLongestStep / length;
      d_z *= kLongestStep / length;
    }
    t.s += d_s * ks;
    t.z += d_z * kz;
  }
  t.stop = Touch::Stop::too_long;
  // If D (touch.hpp) is empty, the steps do not converge, and a bound remains violated.
  double broken = 0.0;
  for (const auto& b : p.bounds) broken = std::max(broken, -b.c);
  if (broken > kBroken) t.stop = Touch::Stop::no_room;
  return t;
}

bool TouchSearch::window(double& z_lo, double& z_hi) const {
  const FlankPatch& a = field_.one();
  z_lo = a.z_lo;
  z_hi = a.z_hi;
  const double at_lo = azimuth_of(field_, a.s_lo);
  const double at_hi = azimuth_of(field_, a.s_hi);
  constexpr double kSlack = 0.05;  // margin for errors of mounting and bulging profiles, rad
  const double lo = mesh_azimuth_ - reach_ - kSlack - std::max(at_lo, at_hi);
  const double hi = mesh_azimuth_ + reach_ + kSlack - std::min(at_lo, at_hi);
  if (a.twist == 0.0) return lo <= 0.0 && hi >= 0.0;
  z_lo = std::max(z_lo, std::min(lo / a.twist, hi / a.twist));
  z_hi = std::min(z_hi, std::max(lo / a.twist, hi / a.twist));
  return z_lo <= z_hi;
}

bool TouchSearch::within_a_turn(const Touch& t) const {
  const double azimuth = azimuth_of(field_, t.s) + t.z * field_.one().twist;
  return std::abs(azimuth - mesh_azimuth_) < std::numbers::pi;
}

namespace {

constexpr int kRows = 7;
constexpr int kSections = 9;

struct GridNode {
  double s = 0.0, s2 = 0.0, value = 0.0;
  double broken = 0.0;  // distance outside flank 2, scaled; 0 inside D
};

using Grid = std::array<std::array<GridNode, kRows>, kSections>;

// True if the node lies inside D and no neighbour inside D has a greater value.
bool is_peak(const Grid& grid, int i, int k) {
  if (grid[i][k].broken > 0.0) return false;
  for (int p = std::max(0, i - 1); p <= std::min(kSections - 1, i + 1); ++p) {
    for (int q = std::max(0, k - 1); q <= std::min(kRows - 1, k + 1); ++q)
      if (grid[p][q].broken == 0.0 && grid[p][q].value > grid[i][k].value) return false;
  }
  return true;
}

// Returns the row of a section from which a search starts: the row with the greatest value inside
// D, or, if no node lies inside D, the row nearest to D.
int best_row(const std::array<GridNode, kRows>& section) {
  int best = 0;
  for (int k = 1; k < kRows; ++k) {
    const GridNode& a = section[k];
    const GridNode& b = section[best];
    if (a.broken < b.broken || (a.broken == b.broken && a.value > b.value)) best = k;
  }
  return best;
}

}  // namespace

bool TouchSearch::uneven() const {
  const auto has = [](const FlankPatch& f) {
    return f.removal && (f.removal->has_topography() || f.removal->wavy());
  };
  return has(field_.one()) || has(field_.two());
}

// T varies slowly along the line of contact and rapidly across it. The maxima of T are therefore
// first computed in each section (a line of constant z) by Newton steps along the profile. These
// steps start at every row (a line of constant s) whose T exceeds T of both neighbouring rows. If
// no neighbouring section has a greater maximum nearby, a search starts from this maximum.
std::vector<std::array<double, 3>> TouchSearch::crests(double z_lo, double z_hi) const {
  constexpr int kFine = 25;   // sections, eight for each of three waves over the face
  constexpr int kAcross = 7;  // rows
  constexpr int kSteps = 4;
  struct Crest {
    double s = 0.0, s2 = 0.0, value = -kInfinity;
  };
  const FlankPatch& a = field_.one();
  const double step = (a.s_hi - a.s_lo) / (kAcross - 1);
  std::vector<std::vector<Crest>> sections(kFine);
  const auto height = [&](int i) { return z_lo + (z_hi - z_lo) * i / (kFine - 1); };
  const auto inside = [&](const GapJet& at, double s, double z) {
    for (int j = 4; j < detail::kBounds; ++j)
      if (bound(at, s, z, j) < 0.0) return false;
    return true;
  };
  for (int i = 0; i < kFine; ++i) {
    const double z = height(i);
    std::array<Crest, kAcross> rows;
    double s2 = 0.5 * (field_.two().s_lo + field_.two().s_hi);
    for (int k = 0; k < kAcross; ++k) {
      const double s = a.s_lo + step * k;
      const GapJet at = field_.at(s, z, s2);
      ++count_.evaluations;
      if (inside(at, s, z)) rows[k] = {s, s2, at.t.v};
    }
    for (int k = 0; k < kAcross; ++k) {
      const auto value = [&](int other) {
        return other < 0 || other >= kAcross ? -kInfinity : rows[other].value;
      };
      if (value(k) == -kInfinity || value(k) < value(k - 1) || value(k) < value(k + 1)) continue;
      Crest best = rows[k];
      Crest at_step = best;
      for (int n = 0; n < kSteps; ++n) {
        const GapJet at = field_.at(at_step.s, z, at_step.s2);
        ++count_.evaluations;
        if (!inside(at, at_step.s, z)) break;
        at_step.value = at.t.v;
        if (at_step.value > best.value) best = at_step;
        const double d = at.t.ss < 0.0 ? -at.t.s / at.t.ss : std::copysign(step, at.t.s);
        at_step.s = std::clamp(at_step.s + std::clamp(d, -step, step), a.s_lo, a.s_hi);
      }
      sections[i].push_back(best);
    }
  }
  std::vector<std::array<double, 3>> starts;
  for (int i = 0; i < kFine; ++i) {
    for (const Crest& c : sections[i]) {
      // The line of contact is inclined, so the same crest has another s in a neighbouring section.
      const auto higher = [&](int other) {
        if (other < 0 || other >= kFine) return false;
        return std::any_of(sections[other].begin(), sections[other].end(), [&](const Crest& o) {
          return std::abs(o.s - c.s) < 1.5 * step && o.value > c.value;
        });
      };
      if (!higher(i - 1) && !higher(i + 1)) starts.push_back({c.s, height(i), c.s2});
    }
  }
  return starts;
}

std::vector<Touch> TouchSearch::every_maximum() const {
  std::vector<Touch> found;
  double z_lo = 0.0;
  double z_hi = 0.0;
  if (!window(z_lo, z_hi)) return found;
  ++count_.cold_starts;
  const FlankPatch& a = field_.one();
  const auto search = [&](double s, double z, double s2) {
    const Touch t = from(s, z, s2, {});
    if (!t.found() || !within_a_turn(t)) return;
    for (const Touch& other : found) {
      if (std::abs(other.te - t.te) < kSameTe &&
          std::abs(other.s - t.s) < kSamePlace * scale_.s_half &&
          std::abs(other.z - t.z) < kSamePlace * scale_.z_half)
        return;
    }
    found.push_back(t);
  };
  const auto greatest_first = [](const Touch& x, const Touch& y) { return x.te > y.te; };
  if (uneven()) {
    for (const auto& [s, z, s2] : crests(z_lo, z_hi)) search(s, z, s2);
    if (!found.empty()) {
      std::sort(found.begin(), found.end(), greatest_first);
      return found;
    }
  }
  Grid grid;
  const auto height = [&](int i) { return z_lo + (z_hi - z_lo) * i / (kSections - 1); };
  for (int i = 0; i < kSections; ++i) {
    double s2 = 0.5 * (field_.two().s_lo + field_.two().s_hi);
    for (int k = 0; k < kRows; ++k) {
      GridNode& node = grid[i][k];
      node.s = a.s_lo + (a.s_hi - a.s_lo) * k / (kRows - 1);
      const GapJet at = field_.at(node.s, height(i), s2);
      ++count_.evaluations;
      node.s2 = s2;
      node.value = at.t.v;
      for (int j = 4; j < detail::kBounds; ++j)
        node.broken = std::max(node.broken, -bound(at, node.s, height(i), j));
    }
  }
  const auto start = [&](int i, int k) { search(grid[i][k].s, height(i), grid[i][k].s2); };
  const auto inside = [&](int i) { return grid[i][best_row(grid[i])].broken == 0.0; };
  int nearest = 0;
  bool any = false;
  for (int i = 0; i < kSections; ++i) {
    const int best = best_row(grid[i]);
    if (grid[i][best].broken < grid[nearest][best_row(grid[nearest])].broken) nearest = i;
    if (!inside(i)) continue;
    any = true;
    for (int k = 0; k < kRows; ++k)
      if (is_peak(grid, i, k)) start(i, k);
    // If D ends between two sections, T may be greatest at that end.
    const bool end = i == 0 || !inside(i - 1) || i + 1 == kSections || !inside(i + 1);
    if (end && !is_peak(grid, i, best)) start(i, best);
  }
  // If no search has started, D may be thin and lie between the nodes.
  if (!any) start(nearest, best_row(grid[nearest]));
  std::sort(found.begin(), found.end(), greatest_first);
  return found;
}

Touch TouchSearch::from_middle() const {
  double z_lo = 0.0;
  double z_hi = 0.0;
  if (!window(z_lo, z_hi)) return Touch{};
  const FlankPatch& a = field_.one();
  struct Place {
    double s = 0.0, z = 0.0, s2 = 0.0, value = 0.0, broken = kInfinity;
  } best;
  for (int i = 1; i <= 3; ++i) {
    double s2 = 0.5 * (field_.two().s_lo + field_.two().s_hi);
    for (int k = 1; k <= 3; ++k) {
      const double s = a.s_lo + (a.s_hi - a.s_lo) * k / 4;
      const double z = z_lo + (z_hi - z_lo) * i / 4;
      const GapJet at = field_.at(s, z, s2);
      ++count_.evaluations;
      double broken = 0.0;
      for (int j = 4; j < detail::kBounds; ++j) broken = std::max(broken, -bound(at, s, z, j));
      if (broken < best.broken || (broken == best.broken && at.t.v > best.value))
        best = {s, z, s2, at.t.v, broken};
    }
  }
  const Touch t = from(best.s, best.z, best.s2, {});
  return t.found() && within_a_turn(t) ? t : cold();
}

Touch TouchSearch::cold() const {
  const std::vector<Touch> all = every_maximum();
  return all.empty() ? Touch{} : all.front();
}

}  // namespace gearwright
