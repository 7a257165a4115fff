// Computes the face load factor K_Hβ from the load along the teeth, for a rating with
// `face_load_factor = "computed"`.
//
// The standard computes K_Hβ from the misalignment of flanks without crowning. Here, K_Hβ is the
// greatest load per length divided by the mean load per length. Both loads are computed by the
// analysis under load, with the modifications of the flanks and the shafts.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/arrange/slice_resolutions.hpp"
#include "gearwright/rating/rating.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

/// Computes K_Hβ of a pair for any torque. K_Hβ is computed at both limits of the mesh misalignment
/// f_ma, and the greater value applies.
///
/// Formula   [T11.53]
class FaceLoads {
 public:
  /// Prepares the computation for a pair that is not double-helical. Notes about the gear bodies
  /// are added to `notes`.
  ///
  /// Errors    those of load_task() and pair_compliance()
  static Result<FaceLoads> of(const Arranged& arranged, const ContactErrors& errors,
                              LoadInput input, const RatingInput& rating,
                              std::vector<Warning>& notes, Progress* progress = nullptr);
  /// Returns K_Hβ ≥ 1 at the torque, the speed and the load factors of `input`. The member
  /// `face_load_factor` of `input` has no effect.
  ///
  /// Errors    those of rate() and judge_load(); `rating.face_load_factor` if the load cannot be
  ///           computed at some position
  Result<double> at(const RatedPair& pair, RatingInput input);

 private:
  FaceLoads(LoadTask task, SliceResolutions resolutions)
      : task_(std::move(task)), resolutions_(std::move(resolutions)) {}

  LoadTask task_;
  SliceResolutions resolutions_;
};

/// Returns the greatest torque with the required safeties, N m, if K_Hβ changes with the torque.
/// The equation torque_of_safety(K_Hβ(T)) = T is solved by the secant method for ln T. The result
/// is none if there is no such torque, if the load along the teeth cannot be computed at a torque
/// of the iteration, or if the iteration does not converge.
///
/// Accuracy  1e-5, relative; the returned torque has the required safeties
std::optional<double> torque_with_face_loads(const RatedPair& pair, RatingInput input,
                                             const Safeties& wanted, FaceLoads& faces);

}  // namespace gearwright
