#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr double kRounding = 1e-6;  // arcsec; smaller harmonics are not drawn
constexpr double kFlat = 0.01;      // arcsec; the axis is scaled for at least this peak-to-peak TE

// Returns the positions of the shown pitch and of half a pitch on each side of it. The rotations
// and tooth pairs of the repeated positions are shifted.
std::vector<ContactPoint> repeated(const std::vector<ContactPoint>& one, double pitch) {
  const int n = static_cast<int>(one.size());
  const int half = n / 2;
  std::vector<ContactPoint> list;
  for (int i = -half; i < n + half; ++i) {
    const int turns = (i + n) / n - 1;
    ContactPoint p = one[static_cast<std::size_t>(i - turns * n)];
    p.rotation1 += Angle::radians(turns * pitch);
    p.pair += turns;
    list.push_back(p);
  }
  return list;
}

struct Span {
  double lo, hi;
};

Span span_of(const std::vector<ContactPoint>& points) {
  Span s{1e300, -1e300};
  for (const ContactPoint& p : points) {
    if (p.kind == TouchKind::none) continue;
    s = {std::min(s.lo, p.te.rad()), std::max(s.hi, p.te.rad())};
  }
  return s;
}

// Divides the rotation into blocks of equal value. The borders are halfway between positions.
template <typename Value, typename Of>
std::vector<std::pair<Value, Span>> blocks_of(const std::vector<ContactPoint>& points,
                                              const Of& of) {
  std::vector<std::pair<Value, Span>> blocks;
  const double half = 0.5 * (points[1].rotation1 - points[0].rotation1).rad();
  for (const ContactPoint& p : points) {
    const Span here{p.rotation1.rad() - half, p.rotation1.rad() + half};
    if (!blocks.empty() && blocks.back().first == of(p)) {
      blocks.back().second.hi = here.hi;
    } else {
      blocks.push_back({of(p), here});
    }
  }
  return blocks;
}

std::vector<TouchKind> kinds_of(const std::vector<ContactPoint>& points) {
  std::vector<TouchKind> kinds;
  for (const ContactPoint& p : points) add_once(kinds, p.kind);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

void add_lanes(Figure& figure, const std::vector<ContactPoint>& points) {
  constexpr int kNoPair = 1 << 30;
  const auto pair = [](const ContactPoint& p) {
    return p.kind == TouchKind::none ? kNoPair : p.pair;
  };
  FigureLane pairs{"tooth pair", {}};
  for (const auto& [k, span] : blocks_of<int>(points, pair))
    if (k != kNoPair)
      pairs.blocks.push_back({span.lo * kDegPerRad, span.hi * kDegPerRad,
                              std::string("lane ") + pair_style(k), pair_words(k)});
  figure.lanes.push_back(std::move(pairs));
  for (const TouchKind kind : kinds_of(points)) {
    FigureLane lane{words_of(kind), {}};
    const char* const style = kind == TouchKind::none ? "zone none"
                              : is_edge(kind)         ? "lane edge"
                                                      : "lane inside";
    for (const auto& [is, span] :
         blocks_of<bool>(points, [&](const ContactPoint& p) { return p.kind == kind; }))
      if (is) lane.blocks.push_back({span.lo * kDegPerRad, span.hi * kDegPerRad, style, ""});
    figure.lanes.push_back(std::move(lane));
  }
}

// Returns the intersection of the linear extensions of two curves between the positions b and c. If
// there is no intersection between them, returns the middle of b and c.
Vec2 crossing(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 middle = 0.5 * (b + c);
  const double slope_1 = (b - a).y() / (b - a).x();
  const double slope_2 = (d - c).y() / (d - c).x();
  if (slope_1 == slope_2) return middle;
  const double x = (c.y() - b.y() + slope_1 * b.x() - slope_2 * c.x()) / (slope_1 - slope_2);
  if (!(x >= b.x() && x <= c.x())) return middle;
  return {x, b.y() + slope_1 * (x - b.x())};
}

}  // namespace

std::vector<TeRun> te_runs(const std::vector<ContactPoint>& positions) {
  std::vector<TeRun> runs;
  const std::size_t n = positions.size();
  const Span span = span_of(positions);
  const auto at = [&](std::size_t i) {
    return Vec2(positions[i].rotation1.rad(), positions[i].te.rad());
  };
  const auto same_pair = [&](std::size_t i, std::size_t k) {
    return k < n && positions[k].kind != TouchKind::none && positions[k].pair == positions[i].pair;
  };
  bool open = false;
  for (std::size_t i = 0; i < n; ++i) {
    const ContactPoint& p = positions[i];
    if (p.kind == TouchKind::none) {
      open = false;
      continue;
    }
    const bool edge = is_edge(p.kind);
    if (!open || runs.back().pair != p.pair || runs.back().edge != edge) {
      TeRun run{p.pair, edge, {}, {}};
      if (open) {
        // Neighbouring runs share a point. If both runs belong to the same tooth pair, the
        // shared point is the last position of the first run. Otherwise, it is the intersection
        // of their curves.
        Vec2 border = at(i - 1);
        if (runs.back().pair != p.pair) {
          border = 0.5 * (at(i - 1) + at(i));
          if (i >= 2 && same_pair(i - 1, i - 2) && same_pair(i, i + 1))
            border = crossing(at(i - 2), at(i - 1), at(i), at(i + 1));
          border.y() = std::clamp(border.y(), span.lo, span.hi);
          runs.back().rotation.push_back(border.x());
          runs.back().te.push_back(border.y());
        }
        run.rotation.push_back(border.x());
        run.te.push_back(border.y());
      }
      runs.push_back(std::move(run));
      open = true;
    }
    runs.back().rotation.push_back(p.rotation1.rad());
    runs.back().te.push_back(p.te.rad());
  }
  return runs;
}

bool waves_are_rounding(const std::vector<Angle>& waves) {
  return std::none_of(waves.begin(), waves.end(), [](Angle w) { return w.arcsec() > kRounding; });
}

std::optional<Figure> transmission_error_figure(const ContactScene& scene,
                                                const ContactResult& result) {
  const bool other = &result != &scene.driving;
  const Span te = span_of(result.positions);
  if (te.hi < te.lo) return std::nullopt;
  const double pitch = pitch_of(scene) * kDegPerRad;
  const double middle = 0.5 * (te.lo + te.hi);
  const TeUnit unit = te_unit(result.rack);
  const double peak = (te.hi - te.lo) * unit.per_rad;
  const double half = 0.62 * std::max(peak, kFlat);
  Figure f{
      other ? "te-other" : "te",
      other ? "Transmission error of the non-working flanks" : "Transmission error",
      fmt::format("Transmission error in {} over the rotation of gear 1. Below the curve are the "
                  "tooth pair in contact and the position of the contact on the flanks.",
                  unit.words),
      fmt::format(
          ", relative to the middle of its range, {}. The shaded pitch has {} positions and "
          "is repeated. The curves of neighbouring tooth pairs differ in colour and line width. "
          "The tooth pairs are numbered, starting with 0 for the pair nearest to the centre line. "
          "A dashed curve means that an edge touches. A dotted vertical line marks the change from "
          "one tooth pair to the next.",
          unit.text(Angle::radians(middle)), result.positions.size()),
      {"rotation of gear 1", "°", -pitch, pitch},
      {"transmission error", unit.words, -half, half},
      "peak to peak " + unit.text(scene.span[other].value_or(Angle::radians(te.hi - te.lo)))};
  f.pitch = pitch;
  f.bar({-pitch / 2, -kInfinity}, {pitch / 2, kInfinity}, "measured");
  for (const double level : {te.hi, te.lo}) {
    const double y = (level - middle) * unit.per_rad;
    f.line({{-kInfinity, y}, {kInfinity, y}}, "leader dash");
  }
  const std::vector<ContactPoint> points = repeated(result.positions, pitch_of(scene));
  const std::vector<TeRun> runs = te_runs(points);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TeRun& run = runs[i];
    std::vector<Vec2> curve;
    for (std::size_t k = 0; k < run.te.size(); ++k)
      curve.push_back({run.rotation[k] * kDegPerRad, (run.te[k] - middle) * unit.per_rad});
    if (i > 0 && runs[i - 1].pair != run.pair)
      f.line({{curve.front().x(), -kInfinity}, {curve.front().x(), kInfinity}}, "handover");
    f.line(std::move(curve),
           std::string("curve ") + pair_style(run.pair) + (run.edge ? " dash" : ""),
           "tooth pair " + pair_words(run.pair));
  }
  add_lanes(f, points);
  return f;
}

std::optional<Figure> spectrum_figure(const ContactResult& result) {
  if (result.harmonics.empty() || waves_are_rounding(result.harmonics)) return std::nullopt;
  const TeUnit unit = te_unit(result.rack);
  std::vector<double> amplitudes;
  for (const Angle w : result.harmonics) amplitudes.push_back(unit.of(w));
  const int n = static_cast<int>(amplitudes.size());
  const auto amplitude = [&](int h) {
    return h < 1 || h > n ? 0.0 : amplitudes[static_cast<std::size_t>(h - 1)];
  };
  const double most = *std::max_element(amplitudes.begin(), amplitudes.end());
  Figure f{"spectrum",
           "Spectrum",
           fmt::format("The bars show the amplitude at each order of the mesh frequency, in {}.",
                       unit.words),
           " of the transmission error, with the amplitude of each harmonic.",
           {"order of mesh frequency", "", 0.3, n + 0.7, true},
           {"amplitude", unit.words, 0.0, 1.15 * std::max(most, kFlat / 2)}};
  std::vector<int> by_size;
  for (int h = 1; h <= n; ++h) {
    const std::string hover =
        fmt::format("order {}: {}{}", h, shown_arcsec(amplitude(h)), unit.symbol);
    f.bar({h - 0.35, 0.0}, {h + 0.35, amplitude(h)}, "bar alpha", hover);
    by_size.push_back(h);
  }
  // The values of at most three peaks are shown. A peak is omitted if it is lower than 2 % of the
  // axis. It is also omitted if a higher peak is shown whose order differs by at most three.
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](int a, int b) { return amplitude(a) > amplitude(b); });
  std::vector<int> named;
  for (const int h : by_size) {
    const double a = amplitude(h);
    const bool near =
        std::any_of(named.begin(), named.end(), [&](int other) { return std::abs(other - h) < 4; });
    const bool peak = amplitude(h - 1) < a && amplitude(h + 1) < a;
    if (near || !peak || named.size() >= 3 || a < 0.02 * f.y.hi) continue;
    named.push_back(h);
    f.text({h == 1 ? h - 0.35 : h, a}, "", h == 1 ? Anchor::start : Anchor::middle, "halo",
           {0.0, -6.0});
    f.marks.back().length = {a, arcsec_decimals(a), unit.words};
  }
  return f;
}

}  // namespace gearwright
