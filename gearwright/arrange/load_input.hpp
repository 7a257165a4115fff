// The load of a pair or of a drive: torques, deflections of the shafts, probes of single teeth,
// planets.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// A load on one tooth, and the place at which its deflection is computed.
struct LoadProbeInput {
  int gear = 1;
  double diameter = 0.0;                     ///< mm
  std::optional<std::array<double, 2>> z{};  ///< mm
  std::optional<double> half_width{};        ///< mm
  std::vector<double> read_z{};              ///< mm
};

/// The load of a pair or of a drive, and the resolution of the computation.
struct LoadInput {
  bool given = false;             ///< true if there is a load or a probe
  std::vector<double> torques{};  ///< N m, on gear 1; of a drive on its input
  int driver = 1;
  int positions = 64;              ///< per pitch
  std::vector<Angle> rotations{};  ///< rotations of gear 1, used instead of positions
  std::optional<int> slices{};     ///< fair_slices by default
  ComplianceAccuracy accuracy = ComplianceAccuracy::full;
  double deflection_slope = 0.0;  ///< µm
  double deflection_bow = 0.0;    ///< µm
  double deflection_offset =
      0.0;  ///< µm, constant over the face; used for a half of a double-helical gear
  std::vector<LoadProbeInput> probes{};
  // Of drives only:
  std::string floating{};            ///< body that is free to move radially; empty: none
  std::vector<double> pin_errors{};  ///< µm, of each pin, tangential; one number: of the first
};

constexpr int kMostTorques = 100, kMostProbes = 100, kMostReadings = 1000;
constexpr int kMostLoadPositions = 10'000, kMostSlices = 128;

}  // namespace gearwright
