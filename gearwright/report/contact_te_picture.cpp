#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/report/contact_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 156, 40, 74, 190, 10};  // the lanes follow
constexpr double kWidth = kArea.width, kTop = kArea.top, kPlot = kArea.tall;
constexpr double kLane = 22.0;
constexpr double kRounding = 1e-6;  // arcsec: waves below it are not drawn
constexpr double kFlat = 0.01;      // arcsec: a span below it is drawn as no more than this

const std::array<const char*, 3> kPairStyles{"tp0", "tp1", "tp2"};

const char* pair_style(int pair) {
  return kPairStyles[static_cast<std::size_t>(((pair % 3) + 3) % 3)];
}

// The shown pitch and half of its neighbours: positions with their rotation and tooth pair moved.
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

// Blocks of equal value along the rotation, borders halfway between positions.
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
  for (const ContactPoint& p : points)
    if (std::find(kinds.begin(), kinds.end(), p.kind) == kinds.end()) kinds.push_back(p.kind);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

void draw_lanes(Svg& svg, const std::vector<ContactPoint>& points, const Axis& x, double top) {
  const auto clipped = [&](const Span& s) {
    return Span{std::max(x(s.lo), x.from), std::min(x(s.hi), x.to)};
  };
  const auto name = [&](const char* words, double y) {
    svg.text({x.from - 8, y + 15}, words, Anchor::end, "tick");
  };
  name("tooth pair", top);
  constexpr int kNoPair = 1 << 30;
  const auto pair = [](const ContactPoint& p) {
    return p.kind == TouchKind::none ? kNoPair : p.pair;
  };
  for (const auto& [k, span] : blocks_of<int>(points, pair)) {
    const Span px = clipped(span);
    if (k == kNoPair || px.hi <= px.lo) continue;
    svg.rect(px.lo, top, px.hi - px.lo, kLane - 4, std::string("lane ") + pair_style(k));
    if (px.hi - px.lo > 24)
      svg.text({(px.lo + px.hi) / 2, top + 14}, pair_words(k), Anchor::middle, "inzone");
  }
  double y = top;
  for (const TouchKind kind : kinds_of(points)) {
    y += kLane;
    name(words_of(kind), y);
    svg.line({x.from, y + (kLane - 4) / 2}, {x.to, y + (kLane - 4) / 2}, "grid");
    for (const auto& [is, span] :
         blocks_of<bool>(points, [&](const ContactPoint& p) { return p.kind == kind; })) {
      const Span px = clipped(span);
      if (!is || px.hi <= px.lo) continue;
      svg.rect(px.lo, y, px.hi - px.lo, kLane - 4,
               kind == TouchKind::none ? "zone none"
               : is_edge(kind)         ? "lane edge"
                                       : "lane inside");
    }
  }
}

std::string te_svg(const ContactReport& report, bool other_flanks) {
  const ContactResult& result = other_flanks ? report.other : report.driving;
  const double pitch = pitch_of(report);
  const std::vector<ContactPoint>& one = result.positions;
  const std::vector<ContactPoint> points = repeated(one, pitch);
  const Span te = span_of(one);
  const double middle = 0.5 * (te.lo + te.hi);
  const double peak = (te.hi - te.lo) * kArcsecPerRad;
  const double height =
      kArea.height() + kLane * static_cast<double>(1 + kinds_of(points).size()) + 48;
  const Axis x = kArea.across(-pitch, pitch);
  const double half = 0.62 * std::max(peak, kFlat);
  const Axis y = kArea.up(-half, half);
  Svg svg(
      other_flanks ? "te-other" : "te", kWidth, height,
      other_flanks ? "Transmission error of the non-working flanks" : "Transmission error",
      "Over the rotation of gear 1: transmission error in arc seconds, below it which tooth pair "
      "touches and where on its flanks.");
  svg.text({12, 22}, "transmission error, arc seconds", Anchor::start, "panel");
  svg.text({kWidth - 12, 22}, "peak to peak " + shown_arcsec(peak) + "″", Anchor::end, "panel");
  // The pitch that was computed; what is beside it repeats.
  svg.rect(x(-pitch / 2), kTop, x(pitch / 2) - x(-pitch / 2), kPlot, "measured");
  const double lanes = kArea.height();
  const double foot = height - 46;
  for (const auto& [at, words] : {std::pair(-1.0, "−1"), std::pair(-0.5, "−½"), std::pair(0.0, "0"),
                                  std::pair(0.5, "½"), std::pair(1.0, "1")}) {
    svg.line({x(at * pitch), kTop - 5}, {x(at * pitch), kTop + kPlot}, "grid");
    svg.text({x(at * pitch), kTop - 10}, words, Anchor::middle, "tick");
  }
  svg.text({12, kTop - 10}, "pitches", Anchor::start, "tick");
  draw_rows(svg, x, y, 5);
  const Axis degrees{x.lo * kDegPerRad, x.hi * kDegPerRad, x.from, x.to};
  draw_foot(svg, degrees, foot - 2, foot - 2, 8, "rotation of gear 1, °");
  // The greatest and the least value, and how far they are apart.
  const double top = y((te.hi - middle) * kArcsecPerRad);
  const double bottom = y((te.lo - middle) * kArcsecPerRad);
  for (const double level : {top, bottom})
    svg.line({x.from, level}, {x.to + 20, level}, "leader dash");
  svg.line({x.to + 14, top}, {x.to + 14, bottom}, "one");
  svg.line({x.to + 10, top}, {x.to + 18, top}, "one");
  svg.line({x.to + 10, bottom}, {x.to + 18, bottom}, "one");
  const std::vector<TeRun> runs = te_runs(points);
  svg.begin_clip(x.from, kTop - 2, x.to - x.from, kPlot + 4);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TeRun& run = runs[i];
    std::vector<Vec2> curve;
    for (std::size_t k = 0; k < run.te.size(); ++k)
      curve.push_back({run.rotation[k], (run.te[k] - middle) * kArcsecPerRad});
    draw_curve(svg, x, y, curve,
               std::string("curve ") + pair_style(run.pair) + (run.edge ? " dash" : ""));
    if (i > 0 && runs[i - 1].pair != run.pair) {
      const double at = x(run.rotation.front());
      svg.line({at, kTop}, {at, kTop + kPlot}, "handover");
    }
  }
  svg.end_group();
  draw_lanes(svg, points, x, lanes);
  return svg.str();
}

// Where the straight continuation of one curve meets that of the next, between two positions.
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
        // Neighbouring runs meet: of one pair at the last position, of two where they cross.
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

std::string te_figure(const ContactReport& report, bool other_flanks) {
  const ContactResult& result = other_flanks ? report.other : report.driving;
  const Span te = span_of(result.positions);
  if (te.hi < te.lo) return {};
  const double middle = 0.5 * (te.lo + te.hi) * kArcsecPerRad;
  return captioned(
      te_svg(report, other_flanks),
      fmt::format(
          "<strong>Transmission error{}</strong>, from its middle at {}″. {} positions in the "
          "shaded "
          "pitch, which repeats for ever. A colour for each tooth pair, numbered from the one "
          "nearest the centre line; dashed: an edge touches; dotted upright: one pair hands over "
          "to "
          "the next.",
          other_flanks ? " of the non-working flanks" : "", shown_arcsec(middle),
          report.positions));
}

std::string te_spectrum_figure(const ContactReport& report) {
  const std::vector<Angle>& waves = report.driving.harmonics;
  if (waves.empty() || waves_are_rounding(waves)) return {};
  constexpr PlotArea kSpectrum{kWidth, 66, 18, 46, 240, 48};
  std::vector<double> arcsec;
  for (const Angle w : waves) arcsec.push_back(w.arcsec());
  const double most = *std::max_element(arcsec.begin(), arcsec.end());
  const int n = static_cast<int>(arcsec.size());
  const Axis x = kSpectrum.across(0.3, n + 0.7);
  const Axis y = kSpectrum.up(0.0, 1.15 * std::max(most, kFlat / 2));
  Svg svg(
      "spectrum", kWidth, kSpectrum.height(), "Spectrum of the transmission error",
      "Bars: amplitudes at the first, second, third order of the mesh frequency and so on, in arc "
      "seconds.");
  svg.text({12, 22}, "amplitude, arc seconds", Anchor::start, "panel");
  draw_rows(svg, x, y, 5);
  const double wide = 0.7 * (x(2) - x(1));
  std::vector<int> by_size;
  for (int h = 1; h <= n; ++h) {
    const double a = arcsec[static_cast<std::size_t>(h - 1)];
    svg.rect(x(h) - wide / 2, y(a), wide, y(0.0) - y(a), "bar alpha");
    if (h == 1 || h % 2 == 0)
      svg.text({x(h), y(0.0) + 17}, std::to_string(h), Anchor::middle, "tick");
    by_size.push_back(h);
  }
  svg.text({(x.from + x.to) / 2, y(0.0) + 38}, "order of mesh frequency", Anchor::middle, "tick");
  // Values of peaks, where no bar stands in the words' way: the tallest three.
  const auto amplitude = [&](int h) {
    return h < 1 || h > n ? 0.0 : arcsec[static_cast<std::size_t>(h - 1)];
  };
  std::stable_sort(by_size.begin(), by_size.end(), [&](int a, int b) {
    return arcsec[static_cast<std::size_t>(a - 1)] > arcsec[static_cast<std::size_t>(b - 1)];
  });
  std::vector<int> named;
  for (const int h : by_size) {
    const double a = arcsec[static_cast<std::size_t>(h - 1)];
    const bool near =
        std::any_of(named.begin(), named.end(), [&](int other) { return std::abs(other - h) < 4; });
    const bool peak = amplitude(h - 1) < a && amplitude(h + 1) < a;
    if (near || !peak || named.size() >= 3 || a < 0.02 * y.hi) continue;
    named.push_back(h);
    svg.text({x(h), y(a)}, shown_arcsec(a), h == 1 ? Anchor::start : Anchor::middle, "halo",
             {h == 1 ? -wide / 2 : 0.0, -6.0});
  }
  return captioned(svg.str(),
                   "<strong>Spectrum</strong> of the transmission error: amplitude of each "
                   "harmonic.");
}

}  // namespace gearwright
