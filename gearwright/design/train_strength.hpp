// Estimates the greatest safety factors of a train from other trains that the same search has
// already rated. A search uses the estimate to skip the rating of trains that cannot have the
// required safety factors.
//
//   T_k      Π u_j of the earlier stages, which is the torque on the pinion of stage k divided by
//            the torque on the input
//   w        T_k/(b z_1), proportional to the load per face width
//   κ        w (u + 1)/(u z_1); if all other factors are equal, S_H ∝ 1/√κ and S_F ∝ 1/w
//                                              theory: docs/theory/11-rating.md
//
// All trains of an estimate have the same module, helix angle, material, load and life. For each
// stage, least squares fit ln(S_H √κ) and ln(S_F w) by linear functions of ln z_1, ln u and ln w.
// These terms approximate the factors that change slowly with the numbers of teeth and with the
// load, such as Z_ε, K_v, K_Hα and Y_F. The bound is the fit plus its greatest residual plus a
// margin. least_width() uses the fit alone.
#pragma once

#include <vector>

#include "gearwright/design/drive_search.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

/// A rated train. If the search chooses face widths, `candidate` has the face widths of the rating.
struct RatedTrain {
  DriveCandidate candidate;
  std::vector<Safeties> stages;
};

/// Margins, in ln S, that are added to the greatest residuals of the fits. They were determined
/// with 3000 trains of modules from 1.5 mm to 3 mm. For each module, 64 of the trains were used for
/// the fits. The residuals of the other trains exceeded the greatest residual of the fit by at most
/// 0.020 (S_H) and 0.057 (S_F).
inline constexpr double kFlankMargin = 0.05, kRootMargin = 0.12;
inline constexpr std::size_t kLeastRatedTrains = 24;

class TrainStrength {
 public:
  /// Makes an object without rated trains. may_hold() then always returns true.
  TrainStrength() = default;
  /// Fits the safety factors of all stages. Stages with equal indices from the input share a fit.
  explicit TrainStrength(const std::vector<RatedTrain>& rated);

  /// Returns false if, according to the estimate, this stage of the train cannot have the required
  /// safety factors.
  bool may_hold(const DriveCandidate& candidate, std::size_t stage, const Safeties& required) const;
  /// Returns the face width, mm, with which this stage has the required safety factors according to
  /// the fits. The width in `candidate` is not used. Returns 0 if neither factor grows with the
  /// width.
  ///
  /// Formula   ln S_H = A + (p − 1/2) ln w and ln S_F = B + (q − 1) ln w, where p and q are the
  ///           coefficients of ln w in the fits; b = T_k/(w z_1) for the smaller w
  /// Domain    estimates() (contract)
  double least_width(const DriveCandidate& candidate, std::size_t stage,
                     const Safeties& required) const;
  /// True if there is an estimate for trains with this number of stages.
  bool estimates(std::size_t stages) const { return stages <= stages_.size(); }
  /// True if, according to the estimate, a stage of the train cannot have the required safety
  /// factors.
  ///
  /// `candidate`  with the greatest face widths, if the search chooses them
  /// Laws         (1) a train of the fits that has the required safeties is not hopeless
  ///              (2) a hopeless train is also hopeless for higher required safeties
  bool is_hopeless(const DriveCandidate& candidate, const Safeties& required) const;

 private:
  struct Fit {
    double constant = 0.0, per_teeth = 0.0, per_ratio = 0.0, per_load = 0.0;
    double above = 0.0;  // greatest residual with its margin, which is not part of `constant`

    // ln(S √κ) or ln(S w), without the term of the load
    double without_load(double log_teeth, double log_ratio) const {
      return constant + per_teeth * log_teeth + per_ratio * log_ratio;
    }
  };
  struct StageFit {
    Fit flank, root;
  };
  std::vector<StageFit> stages_;  // empty if there are too few rated trains
};

}  // namespace gearwright
