#include "tests/oracle/touching_screws.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/oracle/flank_search.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/require.hpp"
#include "tests/oracle/screw_tangency.hpp"

namespace gearwright::oracle {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Rotations that differ by less than this are equal. The value is a thousand times the rounding
// error of a sum of angles of one turn.
constexpr double kSameRotation = 1e-12;  // rad
// Permitted difference between search and solution. It is a thousand times the error of either.
constexpr double kTwoWays = 1e-10;  // rad
// Tolerance for an edge. Near a base circle, the length of the string is the square root of a
// difference of two radii.
constexpr double kAtEnd = 1e-7;  // in centre distances

void check(const Screw& g) {
  require(g.teeth >= 1, "a screw has at least one tooth");
  require(g.base_radius > 0 && g.tip_radius > g.base_radius, "0 < base radius < tip radius");
  require(std::abs(g.base_helix) < kPi / 2, "the base helix angle is below a right angle");
  require(g.base_thickness / (2 * g.base_radius) >= fallen_back(roll_at(g, g.tip_radius)),
          "the flanks of a tooth meet above its tip");
}

void check(const ScrewPair& p) {
  check(p.first);
  check(p.second);
  require(p.center_distance > std::max(p.first.tip_radius, p.second.tip_radius),
          "no tip reaches the other axis");
  require(std::abs(p.shaft_angle) < kPi, "the shaft angle is below half a turn");
  require(p.half_face >= 0, "the face width is not negative");
  // Turns per mm, counted in pitches. The value must be the same for both gears; otherwise the
  // teeth would not stay in step.
  const double one = p.first.teeth * turn_per_length(p.first);
  const double two = p.second.teeth * turn_per_length(p.second);
  require(!parallel(p) || std::abs(one + two) <= 1e-9 * std::abs(one),
          "parallel axes: the helices of both gears fit each other");
}

/// On parallel axes, the section z = 0 represents all sections. No face limits it.
bool one_section(const ScrewPair& p) { return parallel(p) && p.half_face == 0.0; }

/// Sets `margin`, the distance from the nearest end of either flank, mm, and `where`, this end.
void to_ends(const ScrewPair& p, const Flank& flank, double u_1, double z_1, double u_2,
             Touch& touch) {
  const double r_1 = p.first.base_radius, r_2 = p.second.base_radius;
  touch.string_1 = r_1 * u_1, touch.string_2 = r_2 * u_2;
  const std::array<std::pair<double, Where>, 5> ends = {
      {{r_1 * (flank.tip_1() - u_1), Where::tip_1},
       {r_2 * (flank.tip_2() - u_2), Where::tip_2},
       {r_1 * u_1, Where::base_1},
       {r_2 * u_2, Where::base_2},
       {one_section(p) ? std::numeric_limits<double>::infinity() : p.half_face - std::abs(z_1),
        Where::face_1}}};
  const auto least = std::min_element(
      ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  touch.margin = least->first, touch.where = least->second;
}

/// Distance from z = 0 within which gear 1 must be searched. Both tip cylinders contain a point
/// only if it is near enough to the plane through axis 1 and x. The sections of the cylinders give
/// this limit, and the same applies to axis 2.
double axial_reach(const ScrewPair& p) {
  const double a = p.center_distance, a_1 = p.first.tip_radius, a_2 = p.second.tip_radius;
  if (a >= a_1 + a_2) return -1.0;
  const auto side = [a](double own, double other) {
    const double nearest = a - other;
    return std::sqrt((own - nearest) * (own + nearest));
  };
  if (parallel(p)) {
    // The pattern repeats with every axial pitch, with each tooth in the position of the next one.
    const double k = turn_per_length(p.first);
    return std::min(p.half_face, k == 0 ? 0.0 : kPi / (p.first.teeth * std::abs(k)));
  }
  const double reach = (side(a_2, a_1) + side(a_1, a_2) * std::abs(std::cos(p.shaft_angle))) /
                       std::abs(std::sin(p.shaft_angle));
  return std::min(p.half_face, reach);
}

/// Half the angle at axis 1 of the part of its tip circle that tips of gear 2 can reach.
double opening_1(const ScrewPair& p) {
  return std::acos((p.center_distance - p.second.tip_radius) / p.first.tip_radius);
}

}  // namespace

std::optional<Touch> touch_of_tooth(const ScrewPair& p, double rotation_1, Side side, int tooth) {
  check(p);
  const double reach = axial_reach(p);
  if (reach < 0) return std::nullopt;
  const int sigma = static_cast<int>(side);
  const Flank flank(p, rotation_1, sigma, tooth);
  const auto [low, high] = overlap(flank, flank.sections_within(opening_1(p), reach));
  if (low > high) return std::nullopt;

  // Sections at equal steps are evaluated. Then the search continues between the neighbours of each
  // section that is not lower than both and higher than at least one of them. This excludes the
  // middle of a flat ridge.
  const int sections = high > low ? 40 : 0;
  const auto best_at = [&flank](double z) { return best_in_section(flank, z).value; };
  const auto section = [&, low = low, high = high](int i) {
    return sections == 0 ? low : low + (high - low) * i / sections;
  };
  std::vector<Peak> peaks;
  for (int i = 0; i <= sections; ++i) peaks.push_back({best_at(section(i)), section(i)});
  for (int i = 0; i <= sections && sections > 0; ++i) {
    const double here = peaks[i].value;
    const double before = i > 0 ? peaks[i - 1].value : kNone;
    const double after = i < sections ? peaks[i + 1].value : kNone;
    if (here == kNone || here < std::max(before, after)) continue;
    if (here < std::min(before, after) + kSameRotation) continue;
    peaks.push_back(
        climb(best_at, section(std::max(i - 1, 0)), section(std::min(i + 1, sections)), kCorner));
  }
  double best = kNone;
  for (const Peak& peak : peaks) best = std::max(best, peak.value);
  if (best == kNone) return std::nullopt;

  // On a line of contact, several sections are equally good. The one farthest from the ends of the
  // flanks is used.
  std::optional<Touch> found;
  double z_1 = 0, u_1 = 0;
  for (const Peak& peak : peaks) {
    if (peak.value < best - kSameRotation) continue;
    Touch here;
    const double u = best_in_section(flank, peak.at).at;
    to_ends(p, flank, u, peak.at, flank.mate_roll(u, peak.at), here);
    if (found && here.margin <= found->margin) continue;
    found = here, z_1 = peak.at, u_1 = u;
  }
  const Matrix3d turn_1 = about_z(azimuth_1(p, rotation_1, tooth));
  found->tooth = tooth;
  found->searched_2 = found->rotation_2 = -sigma * best;
  found->point = turn_1 * flank_point(p.first, sigma, u_1, z_1);
  found->normal = turn_1 * flank_normal(p.first, sigma, u_1, z_1);

  Tangency start;
  start.u_1 = u_1, start.z_1 = z_1, start.u_2 = flank.mate_roll(u_1, z_1);
  start.z_2 = (tilt_2(p).transpose() * found->point).z();
  start.rotation_2 = found->rotation_2;
  const Tangency solved = tangency(p, rotation_1, sigma, tooth, start);
  Touch inside = *found;
  to_ends(p, flank, solved.u_1, solved.z_1, solved.u_2, inside);
  const double ahead = -sigma * (solved.rotation_2 - found->searched_2);
  const bool tangent = solved.residual < 1e-10 * p.center_distance, within = inside.margin >= 0;
  if (tangent && within && ahead > kTwoWays) {  // the search has missed it
    found->where = Where::unsettled;
    found->rotation_2 = solved.rotation_2;
    return found;
  }
  if (!tangent || !within || ahead < -kTwoWays) {
    // An edge stops gear 2. The tangency belongs to extensions of the flanks, or to a point that is
    // passed later. Just beyond an end, the gap is flat, so it determines the position less
    // accurately than the tangency does.
    if (tangent && !within && std::abs(ahead) < kTwoWays)
      found->where = inside.where;
    else if (found->margin > kAtEnd * p.center_distance)
      found->where = Where::unsettled;
    return found;
  }
  inside.where = Where::flanks;
  inside.rotation_2 = solved.rotation_2;
  inside.point = solved.point, inside.normal = solved.normal, inside.residual = solved.residual;
  return inside;
}

std::optional<Touch> touch(const ScrewPair& p, double rotation_1, Side side) {
  check(p);
  const double reach = axial_reach(p);
  if (reach < 0) return std::nullopt;
  // All teeth whose flanks come within the opening at some point of the reach.
  const double half_tooth = p.first.base_thickness / (2 * p.first.base_radius);
  const double width = opening_1(p) + half_tooth + std::abs(turn_per_length(p.first)) * reach;
  const double per_turn = p.first.teeth / (2 * kPi);
  const double first = std::ceil((rotation_1 - width) * per_turn);
  const double last = std::floor((rotation_1 + width) * per_turn);
  require(last - first < 5000, "a face width is required if the axes are this close to parallel");

  const int sigma = static_cast<int>(side);
  std::vector<Touch> all;
  double best = kNone;
  for (int n = static_cast<int>(first); n <= static_cast<int>(last); ++n) {
    if (const auto one = touch_of_tooth(p, rotation_1, side, n)) {
      all.push_back(*one);
      best = std::max(best, -sigma * one->rotation_2);
    }
  }
  std::optional<Touch> chosen;
  for (const Touch& one : all) {
    if (-sigma * one.rotation_2 < best - kSameRotation) continue;
    const bool better = !chosen ||
                        (one.where == Where::flanks) > (chosen->where == Where::flanks) ||
                        ((one.where == Where::flanks) == (chosen->where == Where::flanks) &&
                         one.margin > chosen->margin);
    if (better) chosen = one;
  }
  return chosen;
}

std::optional<double> play(const ScrewPair& pair, double rotation_1) {
  const auto behind = touch(pair, rotation_1, Side::leading);
  const auto ahead = touch(pair, rotation_1, Side::trailing);
  if (!behind || !ahead) return std::nullopt;
  return ahead->rotation_2 - behind->rotation_2;
}

std::ostream& operator<<(std::ostream& os, Where where) {
  constexpr std::array kNames = {"flanks", "tip_1",  "tip_2",    "base_1",
                                 "base_2", "face_1", "unsettled"};
  return os << kNames[static_cast<int>(where)];
}

}  // namespace gearwright::oracle
