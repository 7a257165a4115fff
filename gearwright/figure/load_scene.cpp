#include "gearwright/figure/load_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

// Dashes and widths distinguish the curves if they are printed in grey.
constexpr std::array<const char*, 5> kCurves{"c-flank", "c-root-fillet dash", "c-tip-land dot",
                                             "c-tip-fillet dashdot", "c-root-land bold"};
constexpr std::size_t kMostFrames = 64;

// Returns `count` of the numbers 0 … n − 1, evenly spaced, including both ends.
std::vector<std::size_t> some_of(std::size_t n, std::size_t count) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(i * (n - 1) / (count - 1));
  return list;
}

}  // namespace

std::vector<std::size_t> shown_torques(const LoadScene& scene) {
  const std::size_t n = scene.contact.torques.size();
  if (n == 1) return {0};
  return some_of(n, std::min(n, kCurves.size()));
}

const LoadedTorque& shown_torque(const LoadScene& scene) {
  const auto& all = scene.contact.torques;
  if (scene.chosen) return all.at(*scene.chosen);
  return *std::max_element(all.begin(), all.end(),
                           [](const auto& a, const auto& b) { return a.torque < b.torque; });
}

std::string torque_words(const LoadedTorque& torque) {
  return fmt::format("{:.6g} N m", newton_metres(torque.torque));
}

std::string curve_style(std::size_t i) { return kCurves[i % kCurves.size()]; }

std::vector<FigureKey> torque_keys(const LoadScene& scene) {
  std::vector<FigureKey> keys;
  for (const std::size_t i : shown_torques(scene))
    keys.push_back({"line " + curve_style(keys.size()), torque_words(scene.contact.torques[i])});
  return keys;
}

double pitch_of(const LoadScene& scene) {
  return 2 * std::numbers::pi / std::abs(scene.gears[0]->spec.teeth);
}

double own_pitches(const LoadScene& scene, const LoadedPosition& at, const LoadedPair& pair) {
  const double turned = scene.gear2_drives ? -at.rotation1.rad() : at.rotation1.rad();
  return turned / pitch_of(scene) - pair.pair;
}

std::vector<std::size_t> frame_positions(const LoadScene& scene) {
  const std::size_t n = shown_torque(scene).positions.size();
  const std::size_t step = (n + kMostFrames - 1) / kMostFrames;
  const std::size_t count = n / step;
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < count; ++k) list.push_back((k * n / count + n / 2) % n);
  return list;
}

std::vector<double> heights_of(const LoadScene& scene, std::size_t which) {
  const FaceSlices& s = scene.contact.slices[which];
  std::vector<double> heights;
  for (int j = 0; j < s.count; ++j) heights.push_back(s.middle(j));
  return heights;
}

}  // namespace gearwright
