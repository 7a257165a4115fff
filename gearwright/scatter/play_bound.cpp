#include "gearwright/scatter/play_bound.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

// The least and the greatest value of one part of a deviation over all `corners` that
// least_play_bound() is given.
struct PlayEnds {
  double least = kInfinity, greatest = -kInfinity;

  void include(double x) {
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
  double half() const { return 0.5 * (greatest - least); }
  double size() const { return std::max(std::abs(least), std::abs(greatest)); }
};

// Each part of a deviation is linear in x, so its range over the corners contains all members.
struct Extent {
  PlayEnds distance, crossing, intersecting, axial;
  std::array<PlayEnds, 2> twist;
  // Amounts, by gear, flank and modification.
  std::array<std::array<std::array<PlayEnds, kModifications.size()>, 2>, 2> amount;

  void include(const Deviation& d) {
    distance.include(d.errors.center_distance);
    crossing.include(d.errors.crossing.rad());
    intersecting.include(d.errors.intersecting.rad());
    axial.include(d.errors.axial);
    for (std::size_t g = 0; g < 2; ++g) {
      twist[g].include(d.errors.helix_twist[g]);
      for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t m = 0; m < kModifications.size(); ++m)
          amount[g][side][m].include(kModifications[m].amount_of(d.modifications[g][side]));
    }
  }
};

// True if the removed material has no kinks, so that its second derivative is bounded.
bool is_smooth(const FlankModifications& m) {
  const auto relieved = [&](const ModificationMember& one) {
    return one.relief && one.amount_of(m) != 0.0;
  };
  return !m.topography && m.profile_wave.waves == 0 && m.helix_wave.waves == 0 &&
         std::none_of(kModifications.begin(), kModifications.end(), relieved);
}

bool is_covered(const Deviation& d) {
  if (d.errors.cutter_lead != std::array<Angle, 2>{}) return false;
  return std::all_of(d.modifications.begin(), d.modifications.end(), [](const auto& flanks) {
    return is_smooth(flanks[0]) && is_smooth(flanks[1]);
  });
}

// Returns an upper bound, rad, of the second-order term 2 · ½Λ|x|² of both flanks together. It
// applies to all members of the family. Returns none if the flanks can touch near a base circle.
std::optional<double> second_order(const ContactSetup& setup, const Extent& e) {
  const std::array<const Gear*, 2> gears = setup.gears();
  std::array<double, 2> r_b{};
  std::array<double, 2> rho_tip{};
  for (std::size_t g = 0; g < 2; ++g) {
    r_b[g] = gears[g]->base_radius();
    rho_tip[g] = roll_length(gears[g]->actual_tip_radius(), r_b[g]);
  }
  const double half_face = 0.5 * std::max(gears[0]->spec.face_width, gears[1]->spec.face_width);
  const double R = std::hypot(gears[0]->actual_tip_radius(), half_face);
  const double tilt = e.crossing.half() + e.intersecting.half();
  const double twist = (e.twist[0].half() + e.twist[1].half()) * half_face;
  const double turn = tilt + twist;
  // Greatest displacement of a place across the plane of action, along the axis, and in any
  // direction.
  const double across = e.distance.half() + tilt * half_face +
                        e.twist[0].half() * half_face * rho_tip[0] +
                        e.twist[1].half() * half_face * rho_tip[1];
  const double along = e.axial.half() + turn * R;
  const double any = e.distance.half() + along;
  const double a = setup.place().center_distance + e.distance.least;
  const double N = roll_length(a, r_b[0] + r_b[1]);
  const double rho = std::min(N - rho_tip[0], N - rho_tip[1]) - any;
  if (!(rho > 0.0)) return std::nullopt;
  const double lever = r_b[1] * std::cos(gears[1]->reference().base_helix_angle);
  double sum = across * across / (2 * rho * r_b[1]) + turn * turn * R / (2 * lever) +
               (e.twist[0].half() * r_b[0] / r_b[1] + e.twist[1].half()) * along;
  // A field of removed material with the amount 1 has a slope of at most 4/L and a second
  // derivative of at most 8/L², where L is the length over which the field extends.
  for (std::size_t g = 0; g < 2; ++g) {
    const FlankExtent flank = flank_extent(*gears[g]);
    const double L =
        std::min(roll_length(flank.rho_tip_form, r_b[g]) - roll_length(flank.rho_root_form, r_b[g]),
                 flank.face_width);
    for (std::size_t m = 0; m < kModifications.size(); ++m) {
      const PlayEnds &right = e.amount[g][0][m], &left = e.amount[g][1][m];
      const double varying = std::max(right.half(), left.half());
      const double most = std::max(right.size(), left.size());
      sum += (varying * 4 / L * any + most * 4 / (L * L) * any * any) / lever;
    }
  }
  return 2 * sum;
}

}  // namespace

std::optional<double> least_play_bound(const ContactSetup& setup, const ScatterTask& task,
                                       const std::vector<std::vector<double>>& corners) {
  const bool external = setup.gear(1).involute() && !setup.gear(2).internal();
  if (corners.empty() || !external || setup.place().axis_angle != Angle() || task.member.stagger)
    return std::nullopt;
  std::vector<Deviation> deviations;
  Extent extent;
  for (const auto& x : corners) {
    const Deviation& d = deviations.emplace_back(deviation_at(setup, task.tolerances, x));
    if (!is_covered(d)) return std::nullopt;
    extent.include(d);
  }
  const auto bend = second_order(setup, extent);
  if (!bend) return std::nullopt;
  SampleValues play(corners.size());
  parallel_for(
      corners.size(),
      [&](std::size_t i) {
        play[i] = member_at(setup, deviations[i], task.member)[ScatterQuantity::least_play];
        count_step(task.progress);
      },
      task.threads);
  double least = kInfinity;
  for (const auto& p : play) {
    if (!p) return std::nullopt;
    least = std::min(least, *p);
  }
  return least - *bend;
}

}  // namespace gearwright
