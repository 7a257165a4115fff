#include "gearwright/arrange/face_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

Result<FaceLoads> FaceLoads::of(const Arranged& arranged, const ContactErrors& errors,
                                LoadInput input, const RatingInput& rating,
                                std::vector<Warning>& notes, Progress* progress) {
  input.torques = {rating.torque * rating.application_factor * rating.mesh_load_factor};
  input.rotations.clear();
  auto made = load_task(arranged, errors, input, notes);
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.root_stress = false;
  task.request.progress = progress;
  auto compliance = task.compliance();
  if (!compliance) return compliance.error();
  task.request.progress = nullptr;
  return FaceLoads(std::move(task),
                   SliceResolutions(input.slices.has_value(), std::move(compliance).take()));
}

Result<double> FaceLoads::at(const RatedPair& pair, RatingInput input) {
  input.face_load_factor = 1.0;  // K_v does not depend on K_Hβ
  const auto rated = rate(pair, input);
  if (!rated) return rated.error();
  const double f_ma = input.misalignment ? *input.misalignment
                                         : std::hypot((*rated->tolerance)[0].f_Hbeta,
                                                      (*rated->tolerance)[1].f_Hbeta);
  const double torque = input.torque * rated->K_A.value * rated->K_gamma.value * rated->K_v.value;
  task_.request.torques = {from_newton_metres(torque)};
  double greatest = 1.0;
  const double deviation = f_ma * std::cos(pair.beta_b) * kMmPerUm;
  const auto limits =
      resolutions_.solve(task_, [&](const LoadTask& with, const PairCompliance& compliance) {
        return contacts_at_limits(with, compliance, deviation);
      });
  if (!limits) return limits.error();
  task_.request.slices = limits->slices;
  for (const LoadedContact& limit : limits->contacts) {
    std::vector<Warning> unused;  // warnings of `load`, which apply at the limits only
    if (auto error = judge_load(task_, limit, unused)) return *error;
    const auto scores = loaded_scores(limit);
    if (scores.empty())
      return Error{
          "rating.face_load_factor", "\"computed\"",
          fmt::format(
              "at {} N m and f_ma = {} µm there are positions at which no teeth touch or the "
              "forces do not converge; give a number for this factor, or give stiffer shafts",
              format_number(torque), format_number(f_ma)),
          FailureKind::not_converged};
    greatest = std::max(greatest, *scores.front().face_load_factor);
  }
  return greatest;
}

std::optional<double> torque_with_face_loads(const RatedPair& pair, RatingInput input,
                                             const Safeties& wanted, FaceLoads& faces) {
  // Greatest relative difference between T and the torque with the required safeties at K_Hβ(T).
  constexpr double kSameTorque = 2e-6;
  constexpr int kMostSteps = 12;
  double log_torque = std::log(input.torque);
  std::optional<std::array<double, 2>> before;  // of the last step: ln T, distance
  for (int step = 0; step < kMostSteps; ++step) {
    input.torque = std::exp(log_torque);
    const auto K_Hbeta = faces.at(pair, input);
    if (!K_Hbeta) return std::nullopt;
    input.face_load_factor = *K_Hbeta;
    const auto torque = torque_of_safety(pair, input, wanted);
    if (!torque) return std::nullopt;
    const double distance = std::log(*torque) - log_torque;
    if (distance >= 0.0 && distance <= kSameTorque) return input.torque;
    const double missing = distance - kSameTorque / 2;
    const double slope = before ? (distance - (*before)[1]) / (log_torque - (*before)[0]) : -1.0;
    before = {log_torque, distance};
    log_torque -= missing / (slope < 0.0 ? slope : -1.0);
  }
  return std::nullopt;
}

}  // namespace gearwright
