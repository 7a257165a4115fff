// Computes the density of contact patterns over a family, which is the fraction of the members
// whose pattern covers a point of a flank.
//
//   δ   thickness of the marking compound, mm
//                                    theory: docs/theory/14-scatter.md, [T14.27]
//
// A sample covers a place if the gap at this place is at most δ at some position of the mesh. At
// such a place, marking compound of the thickness δ leaves a mark after a full mesh. The gap is the
// exact gap of contact_pattern(), not an approximation by ellipses.
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
  int positions = 32;        ///< number per pitch for each sample
  int samples = 32;          ///< per replicate, a power of two, at most ScatterTask::samples
  RasterSize size{17, 33};
};

/// The places of one flank, and the number of samples that cover each place.
struct FlankDensity {
  std::vector<double> diameter;     ///< mm, diameters of the rows, ascending
  std::vector<double> height;       ///< mm, z of the columns in the gear's own frame, ascending
  std::vector<std::int64_t> count;  ///< samples that cover the place, [row · columns + column]
  double side = 1.0;                ///< σ, 1 for an external and −1 for an internal gear

  double share(std::size_t at, std::int64_t of) const {
    return static_cast<double>(count[at]) / static_cast<double>(of);
  }
};

struct PatternDensity {
  double marking = 0.0;  ///< δ  mm
  std::int64_t samples = 0;
  std::array<FlankDensity, 2> flanks;  ///< flanks of gear 1 and gear 2
};

/// Returns the density over the first samples of each replicate of a family. Pitch deviations and
/// thicknesses have no effect on the density.
///
/// Accuracy  each sample as contact_pattern(); a share has a sampling error
/// Laws      (1) without deviations, the share of a place is 1 if the pattern of the pair covers
///           the place, and otherwise 0   (2) a greater δ does not lower any share
///           (3) the result does not depend on the number of threads
/// Domain    marking > 0, positions ≥ 2, a raster of 2 × 2 or more (contract)
PatternDensity pattern_density(const ContactSetup& setup, const ScatterTask& task,
                               const Scatter& scatter, const DensityRequest& request);

}  // namespace gearwright
