#include "gearwright/arrange/proposed_flanks.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/load/unloaded_tips.hpp"

namespace gearwright {

namespace {

constexpr double kNoise = 0.01;  // µm, twice the accuracy of C_i: no reason for one more µm

constexpr double kSame =
    0.01;  // relative: reliefs of two gears that are nearer than this are equal

// Whole µm, upwards, so that the tips carry no load.
double whole_um_above(double mm) { return std::ceil(mm * kUmPerMm - kNoise) / kUmPerMm; }

double whole_um(double mm) { return std::round(mm * kUmPerMm) / kUmPerMm; }

// The radius of curvature of an involute at a diameter, mm.
double roll_length(double base_radius, double diameter) {
  return std::sqrt(std::max(0.0, diameter * diameter / 4 - base_radius * base_radius));
}

PairModifications flanks_of(const LeadProposal& lead, bool gear2_drives) {
  PairModifications m;
  for (FlankModifications& flank : m[0]) flank.lead_crowning = lead.crowning;
  m[0][gear2_drives ? 1 : 0].lead_slope = lead.slope;
  return m;
}

}  // namespace

std::array<double, 2> ReliefProposal::tip_amount(double pitch_deviation) const {
  return {whole_um_above(deflection[0] + pitch_deviation),
          whole_um_above(deflection[1] + pitch_deviation)};
}

double ReliefProposal::root_amount(double pitch_deviation) const {
  return whole_um_above(tip_amount(pitch_deviation)[1] * root_factor);
}

Result<std::optional<ReliefProposal>> propose_relief(const Arranged& arranged, const LoadTask& task,
                                                     const PairCompliance& compliance,
                                                     ReliefLength length,
                                                     const LeadProposal* lead) {
  const InvolutePair* const pair = arranged.pair->involute();
  GW_EXPECTS(pair != nullptr && task.request.regime == LoadRegime::line);
  const auto one = relief_starts(*pair, 1, length);
  const auto two = relief_starts(*pair, 2, length);
  if (!one || !two) return std::optional<ReliefProposal>();
  const Mesh<double>& mesh = pair->mesh;
  ReliefProposal p;
  p.length = length;
  p.tip_start = {whole_um(one->tip), whole_um(two->tip)};
  p.root_start = whole_um(one->root);
  const auto setup = lead ? task.setup.with_modifications(flanks_of(*lead, task.gear2_drives))
                          : Result(task.setup);
  if (!setup) return setup.error();
  const auto found = unloaded_tips(*setup, {mesh.rho1_true_begin, mesh.rho1_true_end, p.tip_start},
                                   compliance, task.request, task.gear2_drives);
  if (!found) return found.error();
  p.deflection = found->amount;
  p.unloaded = found->unloaded;
  // Equal gears have equal reliefs, but half a percent is lost in the tables of neighbouring teeth.
  const double greater = std::max(p.deflection[0], p.deflection[1]);
  if (std::abs(p.deflection[0] - p.deflection[1]) < kSame * greater)
    p.deflection = {greater, greater};
  const double r_b = pair->input.gears[0].radius;
  const double start = roll_length(r_b, p.root_start);
  const double form = roll_length(r_b, 2 * flank_extent(arranged.gear(1)).rho_root_form);
  p.root_factor = (start - form) / (start - mesh.rho1_true_begin);
  return std::optional(p);
}

FaceDeflection face_deflection(const RatedPair& pair, const MeshShafts& shafts, double torque) {
  GW_EXPECTS(shafts.any());
  const double F_t = 2 * torque / pair.gears[pair.place(1)].reference_diameter;
  const std::vector<double> f = shaft_deviation(pair, shafts, F_t);
  // Least squares of c + S x + B (1 − 4x²). The points are symmetric about x = 0, so the linear
  // part is independent of the others.
  const auto n = static_cast<double>(f.size());
  const auto x_of = [&](std::size_t k) { return static_cast<double>(k) / (n - 1) - 0.5; };
  double mean = 0.0;
  for (std::size_t k = 0; k < f.size(); ++k) mean += (1 - 4 * x_of(k) * x_of(k)) / n;
  double fx = 0.0;
  double xx = 0.0;
  double fg = 0.0;
  double gg = 0.0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    const double x = x_of(k);
    const double g = 1 - 4 * x * x - mean;
    fx += f[k] * x;
    xx += x * x;
    fg += f[k] * g;
    gg += g * g;
  }
  const double approach = -std::cos(pair.beta_b) / kUmPerMm;
  return {approach * fx / xx, approach * fg / gg};
}

LeadProposal propose_lead(const FaceDeflection& deflection, double deviation, double face_1,
                          double face) {
  const double wider = face_1 / face;
  return {whole_um(deflection.slope * wider),
          whole_um(std::max(0.0, deviation / 2 - deflection.bow) * wider * wider)};
}

}  // namespace gearwright
