// The keys of [load] and [[load.probe]]: torque, and how finely teeth under it are looked at.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright {

/// [[load.probe]]
struct LoadProbeInput {
  int gear = 1;
  double diameter = 0.0;                   ///< mm
  std::optional<std::array<double, 2>> z;  ///< mm
  std::optional<double> half_width;        ///< mm
  std::vector<double> read_z;              ///< mm
};

/// [load]
struct LoadInput {
  bool given = false;
  std::vector<double> torques;  ///< N m, on gear 1
  int driver = 1;
  int positions = 64;            ///< per pitch
  std::vector<Angle> rotations;  ///< of gear 1: these instead of positions
  std::optional<int> slices;     ///< absent: fair_slices
  ComplianceAccuracy accuracy = ComplianceAccuracy::full;
  double deflection_slope = 0.0;  ///< µm
  double deflection_bow = 0.0;    ///< µm
  std::vector<LoadProbeInput> probes;
};

constexpr int kMostTorques = 100, kMostProbes = 100, kMostReadings = 1000;
constexpr int kMostLoadPositions = 10'000, kMostSlices = 128;

const KeyTable& load_keys();
const KeyTable& load_probe_keys();

}  // namespace gearwright
