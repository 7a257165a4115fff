// The density of contact patterns over a family: how often each place of a flank carries.
//
//   δ   thickness of the marking compound, mm
//                                    theory: docs/theory/14-scatter.md, [T14.27]
//
// A place is counted in a sample if the gap there is at most δ at some position of the mesh, so that
// marking compound of this thickness would show there after a full mesh of that pair. The gap is
// that of contact_pattern(), the exact field at each place; nothing is fitted to ellipses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gearwright/contact/pattern.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

struct Scatter;      // scatter/scatter.hpp
struct ScatterTask;  // scatter/scatter.hpp

struct DensityRequest {
  double marking = 0.00635;  ///< δ  mm
  int positions = 32;        ///< per pitch
  int samples = 32;          ///< of each replicate, a power of two, at most ScatterTask::samples
  RasterSize size{17, 33};
};

/// Places of one flank and their shares of the samples.
struct FlankDensity {
  std::vector<double> diameter;     ///< mm, growing: rows
  std::vector<double> height;       ///< mm, growing, z of the gear's own frame: columns
  std::vector<std::int64_t> count;  ///< samples that cover the place, [row · columns + column]
  bool internal = false;

  double share(std::size_t at, std::int64_t of) const {
    return static_cast<double>(count[at]) / static_cast<double>(of);
  }
};

struct PatternDensity {
  double marking = 0.0;  ///< δ  mm
  std::int64_t samples = 0;
  std::array<FlankDensity, 2> flanks;  ///< of gear 1 and gear 2
};

/// The density over the first samples of each replicate of a family. Pitch deviations and
/// thicknesses have no effect on it.
///
/// Accuracy  of a sample as contact_pattern(); of a share as that of the samples
/// Laws      (1) without deviations a place has the share 1 or 0, as the pattern of the pair
///           (2) a greater δ lowers no share   (3) the same on any number of threads
/// Domain    marking > 0, positions ≥ 2, a raster of 2 × 2 or more (contract)
PatternDensity pattern_density(const ContactSetup& setup, const ScatterTask& task,
                               const Scatter& scatter, const DensityRequest& request);

}  // namespace gearwright
