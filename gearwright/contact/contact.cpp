#include "gearwright/contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/lane_track.hpp"
#include "gearwright/pair/mounted_gears.hpp"

namespace gearwright {

namespace {

double least_squares_slope(const std::vector<ContactPoint>& points) {
  double n = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  for (const ContactPoint& p : points) {
    if (p.kind == TouchKind::none) continue;
    n += 1.0;
    sum_x += p.rotation1.rad();
    sum_y += p.te.rad();
  }
  if (n < 2.0) return 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const ContactPoint& p : points) {
    if (p.kind == TouchKind::none) continue;
    const double x = p.rotation1.rad() - sum_x / n;
    xx += x * x;
    xy += x * (p.te.rad() - sum_y / n);
  }
  return xx > 0.0 ? xy / xx : 0.0;
}

}  // namespace

std::optional<Angle> play_between(const ContactPoint& working, const ContactPoint& non_working,
                                  bool gear2_drives) {
  if (working.kind == TouchKind::none || non_working.kind == TouchKind::none) return std::nullopt;
  return (gear2_drives ? -1.0 : 1.0) * (non_working.te - working.te);
}

std::optional<Angle> least_play(const ContactResult& working, const ContactResult& non_working,
                                bool gear2_drives) {
  std::optional<Angle> least;
  for (std::size_t i = 0; i < working.positions.size(); ++i) {
    const auto play = play_between(working.positions[i], non_working.positions[i], gear2_drives);
    if (play) least = std::min(least.value_or(*play), *play);
  }
  return least;
}

bool jams(Angle least_play, const Gear& moved) {
  const double radius = std::abs(moved.reference_diameter) / 2;
  return least_play.rad() * radius * std::cos(moved.spec.helix_angle.rad()) <=
         -no_backlash(moved.spec.normal_module);
}

std::vector<PairTouch> one_pitch(Transmission& transmission, double first, int n,
                                 std::optional<detail::LaneTrack>* track) {
  // If gear 2 drives, a rotation in the frame N (contact_pair.hpp) has the opposite sign of the
  // rotation in the housing. The first position in N is therefore the last position in the housing.
  const ContactPair& pair = transmission.pair();
  const double from = pair.gear2_drives() ? -first - (n - 1) * (pair.pitch() / n) : first;
  if (track) *track = detail::LaneTrack::of(transmission, from, n);
  auto touches = track && *track ? (*track)->touches() : transmission.over_a_pitch(from, n);
  if (pair.gear2_drives()) std::reverse(touches.begin(), touches.end());
  return touches;
}

std::vector<Angle> harmonics(const std::vector<double>& te, int most) {
  GW_EXPECTS(!te.empty());
  const auto n = static_cast<int>(te.size());
  std::vector<Complex> roots;
  for (int i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * i / n;
    roots.emplace_back(std::cos(turn), -std::sin(turn));
  }
  std::vector<Angle> amplitude;
  const double mean = te[0];  // any value near the mean reduces rounding errors
  for (int h = 1; h <= std::min(most, (n - 1) / 2); ++h) {
    Complex sum = 0.0;
    for (int i = 0; i < n; ++i) {
      const auto turn = static_cast<std::size_t>((static_cast<long long>(h) * i) % n);
      sum += (te[static_cast<std::size_t>(i)] - mean) * roots[turn];
    }
    amplitude.push_back(Angle::radians(2.0 * std::abs(sum) / n));
  }
  return amplitude;
}

ContactResult analyse_contact(const ContactPair& pair, const ContactRequest& request) {
  GW_EXPECTS(request.positions >= 2 && request.pitches >= 1 && request.marking > 0.0);
  Transmission transmission(pair, request.progress);
  ContactResult result;
  std::vector<PairTouch> touches;
  std::vector<Angle> rotations = request.rotations;
  const int n = request.positions;
  // The progress counts several steps per position: one for finding the touch, one for describing
  // the touch, and one for each influence.
  const auto wanted =
      static_cast<std::int64_t>(rotations.size()) *
          static_cast<std::int64_t>(2 + request.influences.size()) +
      (rotations.empty()
           ? static_cast<std::int64_t>(n) *
                 (1 + request.pitches * (1 + static_cast<std::int64_t>(request.influences.size())))
           : 0);
  begin_stage(request.progress,
              pair.gear2_drives() ? "computing the positions with gear 2 driving"
                                  : "computing the positions",
              wanted);
  if (rotations.empty()) {
    // Errors of mounting do not rotate with the gears, so all pitches have the same touches. Only
    // the number of the tooth pair increases by one per pitch.
    const double first = -0.5 * request.pitches * pair.pitch();
    const std::vector<PairTouch> once = one_pitch(transmission, first, n);
    for (int i = 0; i < request.pitches * n; ++i) {
      rotations.push_back(Angle::radians(first + pair.pitch() * (static_cast<double>(i) / n)));
      touches.push_back(once[i % n]);
      touches.back().pair += static_cast<int>(pair.turned()) * (i / n);
    }
  } else {
    for (const Angle r : rotations) touches.push_back(transmission.at(pair.to_world(r.rad())));
  }
  Angle least = Angle::radians(kInfinity);
  Angle greatest = -least;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const ContactPoint p = describe(transmission, touches[i], rotations[i], request.marking);
    result.positions.push_back(p);
    count_step(request.progress);
    if (p.kind == TouchKind::none) {
      result.contact_lost = true;
      continue;
    }
    least = std::min(least, p.te);
    greatest = std::max(greatest, p.te);
  }
  if (greatest >= least) result.peak_to_peak = greatest - least;
  result.mean_slope = least_squares_slope(result.positions);
  if (request.rotations.empty() && !result.contact_lost) {
    std::vector<double> te;
    for (int i = 0; i < n; ++i)
      te.push_back(result.positions[static_cast<std::size_t>(i)].te.rad());
    result.harmonics = harmonics(te);
  }
  for (const Influence& influence : request.influences) {
    std::vector<Sensitivity> column;
    for (const PairTouch& t : touches) {
      count_step(request.progress);
      column.push_back(t.found() ? sensitivity(transmission, t, influence)
                                 : Sensitivity{0.0, Vec3::Zero()});
    }
    result.sensitivities.push_back(std::move(column));
  }
  result.unfinished = transmission.too_long();
  result.rack = {pair.rack_radius()};
  result.work = transmission.count();
  return result;
}

std::vector<double> transmission_error(const ContactPair& pair, int positions) {
  Transmission transmission(pair);
  std::vector<double> te;
  for (const PairTouch& t : one_pitch(transmission, -0.5 * pair.pitch(), positions))
    te.push_back(t.found() ? pair.turned() * t.te() : kNoNumber);
  return te;
}

double peak_to_peak(const std::vector<double>& te) {
  double least = kInfinity, greatest = -kInfinity;
  for (const double v : te) {  // std::min and std::max return their first argument if v is NaN
    least = std::min(least, v);
    greatest = std::max(greatest, v);
  }
  return greatest >= least ? greatest - least : kNoNumber;
}

std::optional<Angle> sampled_peak_to_peak(const std::vector<double>& te) {
  const double span = peak_to_peak(te);
  return span >= 0.0 ? std::optional(Angle::radians(span)) : std::nullopt;
}

}  // namespace gearwright
