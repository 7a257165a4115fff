#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/contact_scene.hpp"
#include "gearwright/figure/load_figures.hpp"

namespace gearwright {

namespace {

constexpr std::array<const char*, 2> kOfGear{"curve g1", "curve g2 dash"};
constexpr std::size_t kWaves = 3;  // number of harmonics in the Harris map

// Returns the value at each position, with the first value repeated a pitch later.
template <class Of>
std::vector<Vec2> over_the_pitch(const LoadScene& scene, const LoadedTorque& t, const Of& of) {
  std::vector<Vec2> values;
  for (const LoadedPosition& p : t.positions) values.push_back({p.rotation1.deg(), of(p)});
  const Vec2 first = values.front();
  values.push_back({first.x() + pitch_of(scene) * kDegPerRad, first.y()});
  return values;
}

std::vector<Vec2> from_its_mean(std::vector<Vec2> values) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (std::isnan(values[i].y())) continue;
    sum += values[i].y();
    ++count;
  }
  for (Vec2& v : values) v.y() -= sum / count;
  return values;
}

// Makes a figure over the rotation of gear 1 with a curve for every shown torque.
template <class Of>
Figure over_the_rotation(const LoadScene& scene, Figure f, const Of& of) {
  f.x = {"rotation of gear 1", "°"};
  f.pitch = pitch_of(scene) * kDegPerRad;
  f.keys = torque_keys(scene);
  for (const std::size_t i : shown_torques(scene)) {
    const LoadedTorque& t = scene.contact.torques[i];
    f.line(of(t), "curve " + curve_style(f.marks.size()), torque_words(t));
  }
  return f;
}

std::optional<Figure> fitted(Figure f, bool from_zero) {
  return fit_axes(f, 0.06, from_zero) ? std::optional(std::move(f)) : std::nullopt;
}

// Returns the load share of one tooth pair during its mesh, as points (rotation of the pair from
// the centre line in pitches, share). The share is 0 at both ends of the curve.
std::vector<Vec2> share_curve(const LoadScene& scene, const LoadedTorque& t) {
  const double step = 1.0 / static_cast<double>(t.positions.size());
  std::vector<Vec2> values;
  for (const LoadedPosition& p : t.positions)
    for (const LoadedPair& k : p.pairs)
      values.push_back({own_pitches(scene, p, k), share_of(p, k.pair)});
  std::sort(values.begin(), values.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  if (values.empty()) return values;
  values.insert(values.begin(), {values.front().x() - step, 0.0});
  values.push_back({values.back().x() + step, 0.0});
  return values;
}

}  // namespace

std::optional<Figure> loaded_te_figure(const LoadScene& scene) {
  Figure f = over_the_rotation(
      scene,
      {.id = "loaded-te",
       .title = "Loaded transmission error",
       .description =
           "Transmission error relative to its mean over the rotation of gear 1, for each torque.",
       .caption = ", each curve relative to its mean.",
       .x = {},
       .y = {"transmission error", "arc seconds"}},
      [&](const LoadedTorque& t) {
        return from_its_mean(
            over_the_pitch(scene, t, [](const LoadedPosition& p) { return p.te.arcsec(); }));
      });
  f.line(
      from_its_mean(over_the_pitch(scene, shown_torque(scene),
                                   [](const LoadedPosition& p) { return p.unloaded_te.arcsec(); })),
      "before", "without load");
  f.keys.push_back({"before", "without load"});
  f.note = "peak to peak " + shown_arcsec(shown_torque(scene).peak_to_peak.arcsec()) + "″";
  return fitted(std::move(f), false);
}

std::optional<Figure> compared_te_figure(const std::vector<TeCurve>& curves) {
  Figure f{.id = "compared-te",
           .title = "Loaded transmission error before and after modification",
           .description =
               "Transmission error relative to its mean over the rotation of gear 1, as given and "
               "with modifications.",
           .caption = ", each curve relative to its mean.",
           .x = {"rotation of gear 1", "°"},
           .y = {"transmission error", "arc seconds"}};
  for (const TeCurve& curve : curves) {
    std::vector<Vec2> values = curve.points;
    if (values.size() < 2) continue;
    f.pitch = (values[1].x() - values[0].x()) * static_cast<double>(values.size());
    values.emplace_back(values.front().x() + f.pitch, values.front().y());
    f.line(from_its_mean(std::move(values)), curve.style, curve.words);
    f.keys.push_back({curve.style, curve.words});
  }
  return fitted(std::move(f), false);
}

std::optional<Figure> share_figure(const LoadScene& scene) {
  Figure f{.id = "load-share" + scene.part,
           .title = "Load share",
           .description = "Share of the load that one tooth pair carries during its mesh.",
           .caption = " of one tooth pair while it carries load.",
           .x = {"rotation of the tooth pair from the centre line", "pitches"},
           .y = {"share of the load", ""}};
  f.pitch = scene.gear2_drives ? -1.0 : 1.0;
  f.keys = torque_keys(scene);
  for (const std::size_t i : shown_torques(scene)) {
    const LoadedTorque& t = scene.contact.torques[i];
    std::vector<Vec2> values = share_curve(scene, t);
    if (!values.empty())
      f.line(std::move(values), "curve " + curve_style(f.marks.size()), torque_words(t));
  }
  return fitted(std::move(f), true);
}

std::optional<Figure> pair_share_figure(const LoadScene& scene) {
  const LoadedTorque& t = shown_torque(scene);
  const std::vector<Vec2> own = share_curve(scene, t);
  if (own.empty()) return std::nullopt;
  const double pitch = pitch_of(scene) * kDegPerRad;
  Figure f{
      .id = "load-pairs" + scene.part,
      .title = "Load shares of the tooth pairs",
      .description = "Load shares of all tooth pairs in mesh over the rotation of gear 1.",
      .caption = fmt::format(
          " at {}. The shaded pitch is repeated. The curves of neighbouring tooth pairs differ in "
          "colour and line width. The tooth pairs are numbered, starting with 0 for the pair "
          "nearest to the centre line. The sum of the curves is 1.",
          torque_words(t)),
      .x = {"rotation of gear 1", "°", -pitch, pitch},
      .y = {"share of the load", "", 0.0, 1.06}};
  f.pitch = pitch;
  f.bar({-pitch / 2, -kInfinity}, {pitch / 2, kInfinity}, "measured");
  const double turn = scene.gear2_drives ? -pitch : pitch;
  // The picture shows rotations from −1 to 1 pitch. In this range, the rotation of pair k from the
  // centre line goes from −1 − k to 1 − k pitches.
  const int first = static_cast<int>(std::ceil(-1.0 - own.back().x()));
  const int last = static_cast<int>(std::floor(1.0 - own.front().x()));
  for (int k = first; k <= last; ++k) {
    std::vector<Vec2> values;
    for (const Vec2& v : own)
      if (std::abs(v.x() + k) <= 1.0) values.push_back({(v.x() + k) * turn, v.y()});
    if (values.size() < 2) continue;
    f.line(std::move(values), std::string("curve ") + pair_style(k), "tooth pair " + pair_words(k));
    f.marks.back().label = pair_words(k);
    f.marks.back().label_style = "halo";
  }
  return f;
}

std::optional<Figure> stiffness_figure(const LoadScene& scene) {
  const bool points = scene.contact.regime == LoadRegime::point;
  return fitted(
      over_the_rotation(
          scene,
          {.id = "mesh-stiffness" + scene.part,
           .title = "Mesh stiffness",
           .description = fmt::format(
               "Stiffness ({} divided by approach) over the rotation of gear 1, for each torque.",
               points ? "force" : "line load"),
           .caption = ". The secant stiffness includes the twist of the bodies.",
           .x = {},
           .y = {"stiffness", points ? "N/µm" : "N/(mm µm)"}},
          [&](const LoadedTorque& t) {
            return over_the_pitch(scene, t, [](const LoadedPosition& p) { return p.stiffness; });
          }),
      true);
}

std::optional<Figure> root_turn_figure(const LoadScene& scene) {
  const LoadedTorque& t = shown_torque(scene);
  Figure f{.id = "root-stress-turn" + scene.part,
           .title = "Greatest root stress",
           .description =
               "Greatest principal stress at the roots of both gears over the rotation of gear 1.",
           .caption = fmt::format(" at {}.", torque_words(t)),
           .x = {"rotation of gear 1", "°"},
           .y = {"root stress", "N/mm²"}};
  f.pitch = pitch_of(scene) * kDegPerRad;
  f.keys = {{"line edge-g1", "gear 1"}, {"line dash edge-g2", "gear 2"}};
  for (std::size_t g = 0; g < 2; ++g)
    f.line(over_the_pitch(scene, t, [g](const LoadedPosition& p) { return p.root_stress[g]; }),
           kOfGear[g], fmt::format("gear {}", g + 1));
  return fitted(std::move(f), true);
}

std::optional<Figure> root_face_figure(const LoadScene& scene) {
  Figure f{.id = "root-stress-face" + scene.part,
           .title = "Root stress over the face",
           .description = "Greatest stress along the fillet of each gear, over the face.",
           .caption = ", as the greatest value along the fillet.",
           .x = {"along the face from its middle", "mm"},
           .y = {"root stress", "N/mm²"}};
  f.keys = {{"line edge-g1", "gear 1"}, {"line dash edge-g2", "gear 2"}};
  for (std::size_t g = 0; g < 2; ++g) {
    if (shown_torque(scene).root_stress[g].size() == 0) continue;
    const auto heights = heights_of(scene, g);
    const Eigen::RowVectorXd most = shown_torque(scene).root_stress[g].colwise().maxCoeff();
    std::vector<Vec2> values;
    for (std::size_t j = 0; j < heights.size(); ++j)
      values.push_back({heights[j], most[static_cast<Eigen::Index>(j)]});
    f.line(std::move(values), kOfGear[g], fmt::format("gear {}", g + 1));
  }
  return fitted(std::move(f), true);
}

std::optional<Figure> harris_figure(const LoadScene& scene) {
  const LoadedTorque* quiet = quietest(scene.contact);
  if (!quiet) return std::nullopt;
  std::vector<const LoadedTorque*> by_torque;
  for (const LoadedTorque& t : scene.contact.torques) by_torque.push_back(&t);
  std::stable_sort(by_torque.begin(), by_torque.end(),
                   [](const auto* a, const auto* b) { return a->torque < b->torque; });
  if (!(by_torque.front()->torque < by_torque.back()->torque)) return std::nullopt;
  Figure f{.id = "harris",
           .title = "Harris map",
           .description =
               "Peak-to-peak value of the loaded transmission error and amplitudes of its first "
               "harmonics over the torque.",
           .caption = fmt::format(
               ". Of the given torques, {} has the least transmission error, {}″ peak to peak.",
               torque_words(*quiet), shown_arcsec(quiet->peak_to_peak.arcsec())),
           .x = {"torque on gear 1", "N m"},
           .y = {"transmission error", "arc seconds"}};
  const auto add = [&](auto of, const std::string& style, const std::string& words) {
    std::vector<Vec2> values;
    for (const LoadedTorque* t : by_torque) values.push_back({newton_metres(t->torque), of(*t)});
    f.line(values, "curve " + style, words);
    for (const Vec2& v : values)
      if (std::isfinite(v.y())) f.dot(v, 3.0, "mark");
    f.keys.push_back({"line " + style, words});
  };
  add([](const LoadedTorque& t) { return t.peak_to_peak.arcsec(); }, "ink", "peak to peak");
  for (std::size_t h = 0; h < std::min(kWaves, quiet->harmonics.size()); ++h)
    add(
        [h](const LoadedTorque& t) {
          return t.harmonics.empty() ? kNoNumber : t.harmonics[h].arcsec();
        },
        curve_style(h), fmt::format("order {} of the mesh frequency", h + 1));
  return fitted(std::move(f), true);
}

}  // namespace gearwright
