#include "gearwright/report/load_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr std::array<const char*, 5> kCurves{"c-flank", "c-root-fillet", "c-tip-land",
                                             "c-tip-fillet", "c-root-land"};
constexpr std::size_t kMostFrames = 64;

// `count` of 0 … n − 1, evenly, both ends among them.
std::vector<std::size_t> some_of(std::size_t n, std::size_t count) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(i * (n - 1) / (count - 1));
  return list;
}

}  // namespace

std::vector<std::size_t> shown_torques(const LoadReport& report) {
  const std::size_t n = report.contact.torques.size();
  if (n == 1) return {0};
  return some_of(n, std::min(n, kCurves.size()));
}

const LoadedTorque& heaviest(const LoadReport& report) {
  const auto& all = report.contact.torques;
  return *std::max_element(all.begin(), all.end(),
                           [](const auto& a, const auto& b) { return a.torque < b.torque; });
}

std::string torque_words(const LoadedTorque& torque) {
  return fmt::format("{:.6g} N m", torque.torque / kMmPerM);
}

std::string curve_style(std::size_t i) { return kCurves[i % kCurves.size()]; }

std::string torque_keys(const LoadReport& report) {
  std::string keys;
  const auto shown = shown_torques(report);
  for (std::size_t i = 0; i < shown.size(); ++i)
    keys += caption_key(curve_style(i), torque_words(report.contact.torques[shown[i]])) + " ";
  return keys;
}

double pitch_of(const LoadReport& report) {
  return 2 * std::numbers::pi / std::abs(report.gears[0]->spec.teeth);
}

double own_pitches(const LoadReport& report, const LoadedPosition& at, const LoadedPair& pair) {
  const double turned = report.gear2_drives ? -at.rotation1.rad() : at.rotation1.rad();
  return turned / pitch_of(report) - pair.pair;
}

std::vector<std::size_t> slider_positions(const LoadReport& report) {
  // The slider begins where gear 1 is not turned, in the middle of the positions.
  const std::size_t n = heaviest(report).positions.size();
  const std::size_t step = (n + kMostFrames - 1) / kMostFrames;
  const std::size_t count = n / step;
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < count; ++k) list.push_back((k * n / count + n / 2) % n);
  return list;
}

std::string frame_attributes(std::size_t k, std::size_t n) {
  return fmt::format("data-frame=\"{}\" data-frames=\"{}\"{}", k, n,
                     k == 0 ? "" : " visibility=\"hidden\"");
}

std::vector<double> heights_of(const LoadReport& report, std::size_t which) {
  const FaceSlices& s = report.contact.slices[which];
  std::vector<double> heights;
  for (int j = 0; j < s.count; ++j) heights.push_back(s.middle(j));
  return heights;
}

}  // namespace gearwright
