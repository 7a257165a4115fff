#include "gearwright/arrange/loaded_halves.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/load/loaded_halves.hpp"

namespace gearwright {

namespace {

const Halves& narrower_of(const std::array<std::optional<Halves>, 2>& halves) {
  GW_EXPECTS(halves[0] && halves[1]);
  return *halves[halves[1]->half_face_width < halves[0]->half_face_width ? 1 : 0];
}

// The rotation of the half at z < 0 relative to that of the gear.
Angle behind(const Halves& halves, const Gear& gear_1) {
  return Angle::radians(-halves.given.stagger_pitches * 2 * std::numbers::pi / gear_1.spec.teeth);
}

// Adds the warnings that are not there yet.
void add_new(std::vector<Warning> found, const char* before, std::vector<Warning>& warnings) {
  for (Warning& w : found) {
    const auto same = [&](const Warning& other) {
      return w.code == other.code && w.message == other.message;
    };
    if (std::any_of(warnings.begin(), warnings.end(), same)) continue;
    w.message = before + w.message;
    warnings.push_back(std::move(w));
  }
}

}  // namespace

LoadInput input_of_half(const LoadInput& whole, const Halves& narrower, const Gear& gear_1,
                        bool below) {
  LoadInput input = whole;
  input.probes.clear();
  for (double& torque : input.torques) torque /= 2;
  // Over the whole face, with x = z/b: slope · x + bow · (1 − 4x²), about the middle of this half.
  const double share = narrower.half_face_width / narrower.face_width;
  const double x = narrower.middle() / narrower.face_width;
  const double slope = below ? -whole.deflection_slope : whole.deflection_slope;
  input.deflection_slope = (slope - 8 * x * whole.deflection_bow) * share;
  input.deflection_bow = whole.deflection_bow * share * share;
  input.deflection_offset =
      slope * x + whole.deflection_bow * (1 - 4 * x * x) - input.deflection_bow;
  if (!below || narrower.given.stagger_pitches == 0.0) return input;
  if (input.rotations.empty()) {
    const double pitch = 2 * std::numbers::pi / gear_1.spec.teeth;
    for (int i = 0; i < input.positions; ++i)
      input.rotations.push_back(
          Angle::radians(pitch * (static_cast<double>(i) / input.positions - 0.5)));
  }
  for (Angle& r : input.rotations) r += behind(narrower, gear_1);
  return input;
}

Result<LoadAnalysis> loaded_halves(const Arranged& arranged,
                                   const std::array<std::optional<Halves>, 2>& halves,
                                   const ContactErrors& errors, const LoadInput& input,
                                   std::vector<Warning>& warnings, Progress* progress) {
  const Halves& narrower = narrower_of(halves);
  const Gear& gear_1 = arranged.gear(1);
  LoadAnalysis whole;
  if (!input.probes.empty() || input.torques.empty()) {
    LoadInput probes = input;
    probes.torques.clear();
    auto made = loaded(arranged, errors, probes, warnings, progress);
    if (!made || input.torques.empty()) return made;
    whole = std::move(made).take();
  }
  HalfPlace place{{narrower.middle(), narrower.middle()}};
  std::vector<Warning> found;
  auto made = loaded(arranged, errors, input_of_half(input, narrower, gear_1, false), found,
                     progress, place);
  if (!made) return made.error();
  add_new(std::exchange(found, {}), "", warnings);
  const LoadAnalysis first = std::move(made).take();
  place = {place.middle, true, &*first.compliance};
  auto image = loaded(arranged, errors, input_of_half(input, narrower, gear_1, true), found,
                      progress, place);
  if (!image) return image.error();
  add_new(std::move(found), "Half at z < 0: ", warnings);
  LoadAnalysis second = std::move(image).take();
  const bool whole_pitch = input.rotations.empty();
  second.contact = second_half(*std::move(second.contact), behind(narrower, gear_1), whole_pitch);
  const double base_radius = first.contact->regime == LoadRegime::line ? gear_1.base_radius() : 0.0;
  whole.contact = whole_load({&*first.contact, &*second.contact}, base_radius, whole_pitch);
  whole.compliance = first.compliance;
  whole.halves.push_back(first);
  whole.halves.push_back(std::move(second));
  return whole;
}

}  // namespace gearwright
