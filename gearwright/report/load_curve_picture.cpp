#include "gearwright/report/load_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/base/units.hpp"
#include "gearwright/load/load_summary.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kWaves = 3;  // in the Harris map

const char* const kTurn = "rotation of gear 1, °";

// A value at each position, and the first once more a pitch later.
template <class Of>
std::vector<Vec2> over_the_pitch(const LoadReport& report, const LoadedTorque& t, const Of& of) {
  std::vector<Vec2> values;
  for (const LoadedPosition& p : t.positions) values.push_back({p.rotation1.deg(), of(p)});
  const Vec2 first = values.front();
  values.push_back({first.x() + pitch_of(report) * kDegPerRad, first.y()});
  return values;
}

// The same for every torque that is shown.
template <class Of>
std::vector<PlotCurve> torque_curves(const LoadReport& report, const Of& of) {
  std::vector<PlotCurve> curves;
  for (const std::size_t i : shown_torques(report))
    curves.push_back({of(report.contact.torques[i]), "curve " + curve_style(curves.size())});
  return curves;
}

void from_their_mean(std::vector<Vec2>& values) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (std::isnan(values[i].y())) continue;
    sum += values[i].y();
    ++count;
  }
  for (Vec2& v : values) v.y() -= sum / count;
}

}  // namespace

std::string loaded_te_figure(const LoadReport& report) {
  std::vector<PlotCurve> curves = torque_curves(report, [&](const LoadedTorque& t) {
    return over_the_pitch(report, t, [](const LoadedPosition& p) { return p.te.arcsec(); });
  });
  curves.push_back({over_the_pitch(report, heaviest(report),
                                   [](const LoadedPosition& p) { return p.unloaded_te.arcsec(); }),
                    "before"});
  for (PlotCurve& c : curves) from_their_mean(c.values);
  return captioned(
      curves_svg({"loaded-te", "Loaded transmission error",
                  "Over the rotation of gear 1: transmission error from its mean, for each torque.",
                  "transmission error, arc seconds", kTurn},
                 curves, false),
      "<strong>Loaded transmission error</strong>, each curve from its mean. " +
          torque_keys(report) + caption_key("before", "without load"));
}

std::string share_figure(const LoadReport& report) {
  const double step = 1.0 / static_cast<double>(heaviest(report).positions.size());
  const auto curves = torque_curves(report, [&](const LoadedTorque& t) {
    std::vector<Vec2> values;
    for (const LoadedPosition& p : t.positions)
      for (const LoadedPair& k : p.pairs)
        values.push_back({own_pitches(report, p, k), share_of(p, k.pair)});
    std::sort(values.begin(), values.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    if (values.empty()) return values;
    // Before and after it bears nothing.
    values.insert(values.begin(), {values.front().x() - step, 0.0});
    values.push_back({values.back().x() + step, 0.0});
    return values;
  });
  return captioned(
      curves_svg({"load-share", "Load share of a tooth pair",
                  "Over the way of one tooth pair through its mesh: its part of the whole load.",
                  "share of the load", "turn of the tooth pair from the centre line, pitches"},
                 curves, true),
      "<strong>Load share</strong> of one tooth pair from where it begins to bear to where it "
      "ceases. " +
          torque_keys(report));
}

std::string stiffness_figure(const LoadReport& report) {
  const bool points = report.contact.regime == LoadRegime::point;
  const auto curves = torque_curves(report, [&](const LoadedTorque& t) {
    return over_the_pitch(report, t, [](const LoadedPosition& p) { return p.stiffness; });
  });
  return captioned(
      curves_svg({"mesh-stiffness", "Mesh stiffness",
                  fmt::format("Over the rotation of gear 1: {} over approach, for each torque.",
                              points ? "force" : "line load"),
                  points ? "N/µm" : "N/(mm µm)", kTurn},
                 curves, true),
      "<strong>Mesh stiffness</strong>, secant, bodies’ twist included. " + torque_keys(report));
}

std::string harris_figure(const LoadReport& report) {
  const auto& torques = report.contact.torques;
  const LoadedTorque* quiet = quietest(report.contact);
  if (!quiet) return {};
  std::vector<const LoadedTorque*> by_torque;
  for (const LoadedTorque& t : torques) by_torque.push_back(&t);
  std::stable_sort(by_torque.begin(), by_torque.end(),
                   [](const auto* a, const auto* b) { return a->torque < b->torque; });
  if (!(by_torque.front()->torque < by_torque.back()->torque)) return {};
  const auto line = [&](auto of, const std::string& style) {
    PlotCurve c{{}, style, true};
    for (const LoadedTorque* t : by_torque) c.values.push_back({t->torque / kMmPerM, of(*t)});
    return c;
  };
  std::vector<PlotCurve> curves{
      line([](const LoadedTorque& t) { return t.peak_to_peak.arcsec(); }, "curve ink")};
  std::string keys = caption_key("ink", "peak to peak") + " ";
  for (std::size_t h = 0; h < std::min(kWaves, quiet->harmonics.size()); ++h) {
    curves.push_back(line(
        [h](const LoadedTorque& t) { return t.harmonics.empty() ? kNaN : t.harmonics[h].arcsec(); },
        "curve " + curve_style(h)));
    keys +=
        caption_key(curve_style(h), fmt::format("{} wave{} per pitch", h + 1, h == 0 ? "" : "s")) +
        " ";
  }
  return captioned(
      curves_svg(
          {"harris", "Harris map",
           "Over the torque: the loaded transmission error's peak to peak and the amplitudes "
           "of its first waves.",
           "arc seconds", "torque on gear 1, N m"},
          curves, true),
      fmt::format("<strong>Harris map</strong>: {}Of the torques asked for the quietest is {}, "
                  "{}″ from peak to peak.",
                  keys, torque_words(*quiet), shown_arcsec(quiet->peak_to_peak.arcsec())));
}

}  // namespace gearwright
