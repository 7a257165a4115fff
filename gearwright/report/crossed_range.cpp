#include "gearwright/report/crossed_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/pair/series.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"

namespace gearwright {

namespace {

constexpr int kSteps = 240;
constexpr double kMargin = 0.07;  // added at either end, as a fraction of the range of angles
// The range ends where the transverse pressure angle is this far from its limit, in rad. At the
// limit, the helix angle of one gear is 90° and its pitch radius is infinite. At the end of the
// range, the pressure angle of the common rack is within 1e-6 rad of the limit.
constexpr double kBeforeLimit = 1e-3;
// Transverse pressure angles are at most 90° minus this value, in rad, because the involute
// function is infinite at 90°. Rounding may bring the angle of a mounted pair above this maximum.
// The reduction to the maximum then changes the centre distance by at most kAtLimit times the base
// radius.
constexpr double kAtLimit = 1e-8;
constexpr double kMinAngle = 2e-3;  // rad, least α_wn of the range; a rack cannot have α_wn = 0

// Returns the transverse pressure angle of the limiting gear. The samples are spaced by this angle.
// The pressure angle of the common rack is unsuitable as a parameter, because it is stationary at
// the limit.
double transverse_of(const BasePair<double>& gears, double alpha_n) {
  const double c_g = std::cos(gears[limiting_gear(gears)].helix_angle);
  return std::min(kHalfPi - kAtLimit, std::asin(std::min(1.0, std::sin(alpha_n) / c_g)));
}

std::optional<CrossedSample> sample_at_transverse(const CrossedPair& pair, double alpha) {
  const BasePair<double>& gears = pair.input.gears;
  const CrossedPlace place = crossed_place(gears, alpha);
  if (!shaft_angle_range(gears).contains(place.shaft_angle.rad())) return std::nullopt;
  MeshInput<double> in = pair.input;
  in.center_distance = place.center_distance;
  in.shaft_angle = place.shaft_angle.rad();
  const Mesh<double> mesh = mesh_of(in);
  return CrossedSample{place, mesh.path_ratio, face_widths(mesh)};
}

// Returns the two gears with the module and the pressure angle of one common rack. Returns none if
// their racks differ.
std::optional<ReferencePair<double>> shared_rack(const CrossedPair& pair) {
  ReferencePair<double> racks;
  for (std::size_t i : {0u, 1u}) racks[i] = pair.gears[i].spec.reference_input();
  const auto equal = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); };
  if (!equal(racks[0].normal_module, racks[1].normal_module) ||
      !equal(racks[0].normal_pressure_angle, racks[1].normal_pressure_angle))
    return std::nullopt;
  racks[1].normal_module = racks[0].normal_module;
  racks[1].normal_pressure_angle = racks[0].normal_pressure_angle;
  return racks;
}

}  // namespace

std::optional<CrossedSample> crossed_sample(const CrossedPair& pair, Angle normal_pressure_angle) {
  const double alpha_n = normal_pressure_angle.rad();
  const BasePair<double>& gears = pair.input.gears;
  if (!(alpha_n > 0.0) || !has_rack(gears[limiting_gear(gears)], alpha_n)) return std::nullopt;
  return sample_at_transverse(pair, transverse_of(gears, alpha_n));
}

std::vector<CrossedSample> crossed_samples(const CrossedPair& pair) {
  const BasePair<double>& gears = pair.input.gears;
  const double limit = kHalfPi - std::abs(gears[limiting_gear(gears)].helix_angle);
  std::vector<double> worth{pair.mesh.rack.normal_pressure_angle};
  if (pair.min_distance) worth.push_back(pair.min_distance->normal_pressure_angle.rad());
  if (pair.contact_ratio_range) {
    worth.push_back(pair.contact_ratio_range->lo.normal_pressure_angle.rad());
    worth.push_back(pair.contact_ratio_range->hi.normal_pressure_angle.rad());
  }
  const auto [least, greatest] = std::minmax_element(worth.begin(), worth.end());
  const double margin =
      std::max(kMargin * (*greatest - *least), pair.contact_ratio_range ? 0.005 : 0.06);
  const double lo = std::max(*least - margin, std::min(*least, kMinAngle));
  const double hi = std::min(*greatest + margin, limit);
  const double from = transverse_of(gears, lo);
  const double to = std::min(transverse_of(gears, hi), kHalfPi - kBeforeLimit);
  std::vector<CrossedSample> samples;
  for (int k = 0; k <= kSteps; ++k) {
    const auto s = sample_at_transverse(pair, from + k * (to - from) / kSteps);
    if (s) samples.push_back(*s);
  }
  GW_ENSURES(samples.size() > 1);
  return samples;
}

std::vector<Approximation> approximations(const CrossedPair& pair) {
  const auto racks = pair.side() > 0.0 ? shared_rack(pair) : std::nullopt;
  if (!racks || !pair.min_distance) return {};
  const auto series = min_distance_series(*racks);
  std::vector<Approximation> all;
  const auto add = [&](const char* name, const char* letter, const std::optional<double>& alpha_n) {
    if (alpha_n) all.push_back({name, letter, Angle::radians(*alpha_n)});
  };
  add("1 term", "1", series.pressure_angle(1));
  add("2 terms", "2", series.pressure_angle(2));
  add("3 terms", "3", series.pressure_angle(3));
  add("Virtual spur pair", "v", series.virtual_pressure_angle());
  add("Virtual spur pair, corrected", "v′", series.corrected_virtual_pressure_angle());
  std::erase_if(
      all, [&](const Approximation& a) { return !crossed_sample(pair, a.normal_pressure_angle); });
  return all;
}

FigureAxis angle_axis(double lo, double hi) {
  return {
      .words = "working normal pressure angle", .unit = "°", .lo = lo, .hi = hi, .symbol = "α_wn"};
}

void add_angles(Figure& f, const CrossedPair& pair, const std::vector<CrossedSample>& samples) {
  f.x = angle_axis(samples.front().place.normal_pressure_angle.deg(),
                   samples.back().place.normal_pressure_angle.deg());
  if (const auto& range = pair.contact_ratio_range) {
    f.bar({range->lo.normal_pressure_angle.deg(), -kInfinity},
          {std::min(range->hi.normal_pressure_angle.deg(), f.x.hi), kInfinity}, "band");
  }
  std::vector<LetterAt> marks;
  const auto mark = [&](const char* words, const std::string& style, double at) {
    marks.push_back({fmt::format("{} {}°", words, fixed(at, 3)), Vec2(at, -kInfinity), style,
                     "tick halo " + style});
  };
  mark("mounted", "here", deg(pair.mesh.rack.normal_pressure_angle));
  if (pair.min_distance)
    mark("least distance", "least", pair.min_distance->normal_pressure_angle.deg());
  add_letters(f, marks);
}

}  // namespace gearwright
