// Computes the points x of the samples of a family, and the peak-to-peak TE of the members at
// these points. The points x are Sobol's points or random points, and they have the
// distributions and the correlations of the tolerances.
//                theory: docs/theory/14-scatter.md, [T14.4] to [T14.6], [T14.30]
// Internal to scatter/.
#pragma once

#include <cstdint>
#include <vector>

#include "gearwright/math/sobol.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Checks that samples of the family can be computed.
///
/// Errors    as check_ends(); `scatter` if the tolerances have more coordinates than the table
///           of Sobol's points
std::optional<Error> check_family(const ContactSetup& setup,
                                  const std::vector<ScatterTolerance>& tolerances);

class SamplePoints {
 public:
  /// The task must outlive the object.
  explicit SamplePoints(const ScatterTask& task);

  /// Returns x of sample n of a replicate, in the users' units.
  std::vector<double> at(int replicate, std::uint32_t n) const { return from(0, replicate, n); }
  /// Returns x of sample n of a second set, which is independent of the samples of at(). The points
  /// of the sequence have twice as many coordinates as x. at() uses the first half of the
  /// coordinates, and this function uses the second half.
  std::vector<double> of_other_half(int replicate, std::uint32_t n) const {
    return from(dimensions_, replicate, n);
  }
  /// Returns x of the first `count` samples of a replicate.
  std::vector<std::vector<double>> first(int replicate, int count) const;

 private:
  std::vector<double> from(int first_coordinate, int replicate, std::uint32_t n) const;

  const ScatterTask& task_;
  int dimensions_;
  SobolPoints points_;
  Copula copula_;
};

/// Returns the peak to peak of the continuous TE curve, rad, of the member at each of these points
/// x, with its derivatives with respect to the influences.
std::vector<MemberSpan> spans_at(const ContactSetup& setup, const ScatterTask& task,
                                 const std::vector<std::vector<double>>& places,
                                 std::span<const Influence> influences = {});

/// Returns the peak-to-peak TE of each member, rad, or kLostSpan if the member loses contact.
std::vector<double> ranked(const std::vector<MemberSpan>& spans);
constexpr double kLostSpan = 1e3;  ///< rad, greater than any other value

}  // namespace gearwright
