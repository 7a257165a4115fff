#include "gearwright/arrange/loaded_pair.hpp"

#include <utility>

#include "gearwright/arrange/notes.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/load/loaded_halves.hpp"

namespace gearwright {

namespace {

const Halves& narrower_of(const std::array<std::optional<Halves>, 2>& halves) {
  GW_EXPECTS(halves[0] && halves[1]);
  return halves[1]->half_face_width < halves[0]->half_face_width ? *halves[1] : *halves[0];
}

}  // namespace

bool equal_halves(const Halves& halves, const ContactErrors& errors, const LoadInput& input) {
  return input.deflection_slope == 0.0 && alike_halves(halves.given.stagger_pitches, errors);
}

LoadInput input_of_half(const LoadInput& whole, const Halves& narrower, const Gear& gear_1,
                        bool below) {
  LoadInput input = whole;
  input.probes.clear();
  for (double& torque : input.torques) torque /= 2;
  // With x = z/b, the deflection over the whole face is slope · x + bow · (1 − 4x²). The
  // deflection over the half follows from an expansion of this polynomial about the middle of
  // the half.
  const double share = narrower.half_face_width / narrower.face_width;
  const double x = (1 - share) / 2;
  const double slope = below ? -whole.deflection_slope : whole.deflection_slope;
  input.deflection_slope = (slope - 8 * x * whole.deflection_bow) * share;
  input.deflection_bow = whole.deflection_bow * share * share;
  input.deflection_offset =
      slope * x + whole.deflection_bow * (1 - 4 * x * x) - input.deflection_bow;
  if (below)
    input.rotations = rotations_of_second(gear_1, narrower.given.stagger_pitches,
                                          std::move(input.rotations), input.positions, 1);
  return input;
}

Result<std::vector<LoadTask>> load_tasks_of_halves(
    const Arranged& arranged, const std::array<std::optional<Halves>, 2>& halves,
    const ContactErrors& errors, const LoadInput& input, std::vector<Warning>& warnings) {
  std::vector<LoadTask> tasks;
  for (const bool below : {false, true}) {
    std::vector<Warning> found;
    const LoadInput half = input_of_half(input, narrower_of(halves), arranged.gear(1), below);
    auto task = load_task(arranged, errors, half, found, HalfPlace{below, nullptr});
    if (!task) return task.error();
    if (!below) add_new(std::move(found), warnings);
    tasks.push_back(std::move(task).take());
  }
  return tasks;
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
  std::vector<Warning> found;
  auto made = loaded(arranged, errors, input_of_half(input, narrower, gear_1, false), found,
                     progress, HalfPlace{});
  if (!made) return made.error();
  add_new(std::exchange(found, {}), warnings);
  const LoadAnalysis first = std::move(made).take();
  LoadInput below = input_of_half(input, narrower, gear_1, true);
  below.slices = first.compliance->slices[0].count;  // the same for both gears on parallel axes
  auto image =
      equal_halves(narrower, errors, input)
          ? Result(first)
          : loaded(arranged, errors, below, found, progress, HalfPlace{true, &*first.compliance});
  if (!image) return image.error();
  add_new(std::move(found), warnings, kSecondHalf);
  LoadAnalysis second = std::move(image).take();
  const bool whole_pitch = input.rotations.empty();
  second.contact = second_half(*std::move(second.contact),
                               behind(narrower.given.stagger_pitches, gear_1), whole_pitch);
  whole.contact = whole_load({&*first.contact, &*second.contact}, gear_1, whole_pitch);
  whole.compliance = first.compliance;
  whole.standard = first.standard;
  whole.halves.push_back(first);
  whole.halves.push_back(std::move(second));
  return whole;
}

}  // namespace gearwright
