#include "gearwright/pair/drive.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright {

namespace {

double overlap_per_mm(const ParallelPair& pair) {
  const double tan_b = std::abs(pair.mesh.tan_base_helix[0]);
  return tan_b / pair.mesh.step;
}

}  // namespace

std::optional<double> face_width_for_total(const ParallelPair& pair, double total) {
  if (!(pair.contact_ratio_true() > 0.0)) return std::nullopt;
  const double missing = total - pair.mesh.true_ratio;
  if (missing <= 0.0) return 0.0;
  const double gain = overlap_per_mm(pair);
  if (gain == 0.0) return std::nullopt;
  return missing / gain;
}

std::optional<double> face_width_needed(const ParallelPair& pair) {
  if (pair.mesh.true_ratio >= 1.0) return std::nullopt;
  const auto face = face_width_for_total(pair, 1.0);
  if (!face) return std::nullopt;
  // The face width is rounded up to a multiple of 0.01 mm. If it exceeds such a multiple by less
  // than kWhole of 0.01 mm, the excess is a rounding error and is ignored.
  constexpr double kWhole = 1e-9;
  return std::ceil(pair.whole_face(*face) * 100 - kWhole) / 100;
}

std::optional<double> face_width_for_overlap(const ParallelPair& pair) {
  const double gain = overlap_per_mm(pair);
  if (gain == 0.0) return std::nullopt;
  return 1.0 / gain;
}

std::array<double, 2> contact_ends(const InvolutePair& pair) {
  const Mesh<double>& m = pair.mesh;
  if (!(m.true_ratio > 0.0)) return {m.rho1_A, m.rho1_E};
  return {pair.gears[0].undercut ? m.rho1_true_begin : m.rho1_A,
          pair.gears[1].undercut ? m.rho1_true_end : m.rho1_E};
}

std::array<double, 2> approach_and_recess(const ParallelPair& pair) {
  if (!(pair.contact_ratio_true() > 0.0)) return {0.0, 0.0};
  const Mesh<double>& m = pair.mesh;
  const double c = std::clamp(m.rho1_C, m.rho1_true_begin, m.rho1_true_end);
  return {(c - m.rho1_true_begin) / m.step, (m.rho1_true_end - c) / m.step};
}

std::array<double, 2> axial_force(const ParallelPair& pair) {
  const double tan_w = pair.mesh.rack.sides[0].tan_helix;
  return {0.0 - tan_w, tan_w};
}

double backlash_per_distance(const ParallelPair& pair) {
  return pair.side() * 2.0 * pair.mesh.rack.sides[0].tan_transverse;
}

}  // namespace gearwright
