// Describes the load of a pair or of a drive.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// A load on one tooth, and the points at which the deflection is computed.
struct LoadProbeInput {
  int gear = 1;
  double diameter = 0.0;                     ///< mm, diameter at which the load acts
  std::optional<std::array<double, 2>> z{};  ///< mm, heights of both ends of the load
  std::optional<double> half_width{};        ///< mm, half width of the Hertz strip
  std::vector<double> read_z{};              ///< mm, heights at which the deflection is computed
};

/// The load on a pair or a drive, and the resolution of the computation.
struct LoadInput {
  bool given = false;                    ///< true if there is a load or a probe
  std::vector<double> torques{};         ///< N m, on gear 1 of a pair or on the input of a drive
  std::vector<double> output_torques{};  ///< N m, on the driven gear of a pair, without losses;
                                         ///< `torques` follow from them
  int driver = 1;
  int positions = 64;              ///< number per pitch
  std::vector<Angle> rotations{};  ///< rotations of gear 1, used instead of positions
  std::optional<int> slices{};     ///< by default fair_slices()
  ComplianceAccuracy accuracy = ComplianceAccuracy::full;
  double deflection_slope = 0.0;  ///< S  µm, increase towards +z over the common face
  double deflection_bow = 0.0;    ///< B  µm, height of the parabola in the middle of the face
  double deflection_offset =
      0.0;  ///< µm, constant over the face; used for a half of a double-helical gear
  std::vector<LoadProbeInput> probes{};
  // For drives only:
  std::string floating{};            ///< body that is free to move radially; empty if there is none
  std::vector<double> pin_errors{};  ///< µm, tangential, one for each planet; a single number
                                     ///< applies to the first planet
};

constexpr int kMostTorques = 100, kMostProbes = 100, kMostReadings = 1000;
constexpr int kMostLoadPositions = 10'000, kMostSlices = 128;

}  // namespace gearwright
