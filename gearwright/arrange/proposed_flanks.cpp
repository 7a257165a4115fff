#include "gearwright/arrange/proposed_flanks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/load/unloaded_tips.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

constexpr double kNoise = 0.01;  // µm, twice the accuracy of C_i; a smaller excess over whole µm is
                                 // not rounded up

constexpr double kSameDepth =
    0.01;  // relative difference; below it, the reliefs of both gears are made equal

// Rounds up to whole µm, so that the tips carry no load.
double whole_um_above(double mm) { return std::ceil(mm * kUmPerMm - kNoise) / kUmPerMm; }

double whole_um(double mm) { return std::round(mm * kUmPerMm) / kUmPerMm; }

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
  const ParallelPair* const pair = arranged.pair->parallel();
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
  // Equal gears need equal reliefs, but the compliance tables of the two gears cause
  // differences of half a percent.
  const double greater = std::max(p.deflection[0], p.deflection[1]);
  if (std::abs(p.deflection[0] - p.deflection[1]) < kSameDepth * greater)
    p.deflection = {greater, greater};
  const double r_b = pair->input.gears[0].radius;
  const double start = roll_length(p.root_start / 2, r_b);
  const double form = roll_length(flank_extent(arranged.gear(1)).rho_root_form, r_b);
  p.root_factor = (start - form) / (start - mesh.rho1_true_begin);
  return std::optional(p);
}

FaceDeflection face_deflection(const LoadTask& task, const PairCompliance& compliance,
                               double torque) {
  const ContactPair pair = task.pair();
  const FaceSlices& face = compliance.slices[0];
  const double line_load = torque / (task.setup.gear(1).base_radius() * (face.hi - face.lo));
  const FaceDeflection of_shafts =
      ShaftYield(pair, task.setup.gear(1), task.setup.gear(2), compliance, task.request)
          .under(Eigen::VectorXd::Constant(face.count, line_load));
  return {of_shafts.slope + task.request.deflection_slope,
          of_shafts.bow + task.request.deflection_bow};
}

LeadProposal propose_lead(const FaceDeflection& deflection, double deviation, double face_1,
                          double face) {
  const double wider = face_1 / face;
  return {whole_um(deflection.slope * wider),
          whole_um(std::max(0.0, deviation / 2 - deflection.bow) * wider * wider)};
}

namespace {

// Calls f(gear, at_tip, relief, field) for each relief without a start, until f returns a value.
template <class Given, class F>
auto first_without_start(Given& given, const F& f) {
  using Answer = decltype(f(1, true, given.gear(1).modifications[0].tip_relief, std::string()));
  for (const int which : {1, 2}) {
    if (!given.has(which)) continue;
    for (auto& flank : given.gear(which).modifications) {
      for (const bool tip : {true, false}) {
        auto& relief = tip ? flank.tip_relief : flank.root_relief;
        if (relief.reach || relief.amount == 0.0) continue;
        const char* const name = tip ? "tip_relief" : "root_relief";
        if (auto answer = f(which, tip, relief,
                            gear_field(which, fmt::format("modifications.{}.reach", name))))
          return answer;
      }
    }
  }
  return Answer{};
}

}  // namespace

bool lacks_relief_start(const GivenPair& given) {
  return first_without_start(given,
                             [](int, bool, const Relief&, const std::string&) { return true; });
}

Error missing_relief_start(const GivenPair& given) {
  return *first_without_start(given, [](int, bool, const Relief&, const std::string& field) {
    return std::optional(absent_input(field,
                                      "; give this value, because its default depends on the "
                                      "contact ratio with gear 2, and gear 2 is absent or a rack"));
  });
}

std::optional<ReliefStarts> relief_starts(const ParallelPair& pair, int which, ReliefLength of) {
  const Mesh<double>& mesh = pair.mesh;
  if (!(mesh.true_ratio > 1.0)) return std::nullopt;
  const bool is_long = of == ReliefLength::long_relief;
  if (is_long && !(mesh.true_ratio < 2.0)) return std::nullopt;
  const double beyond = mesh.rho1_true_end - mesh.rho1_true_begin - mesh.step;
  const double length = is_long ? beyond : beyond / 2;
  // The tip of gear 1 is in contact at the end of the path of contact, and the tip of gear 2 is in
  // contact at its start.
  const double near_end = mesh.rho1_true_end - length;
  const double near_begin = mesh.rho1_true_begin + length;
  const auto i = static_cast<std::size_t>(which - 1);
  const double base_radius = pair.input.gears[i].radius;
  const auto diameter = [&](double rho1) {
    return 2 * std::hypot(base_radius, which == 1 ? rho1 : mesh.rho2(rho1));
  };
  return which == 1 ? ReliefStarts{diameter(near_end), diameter(near_begin)}
                    : ReliefStarts{diameter(near_begin), diameter(near_end)};
}

std::optional<Error> place_reliefs(GivenPair& given, const Pair& pair) {
  const auto place = [&](int which, bool tip, Relief& relief,
                         const std::string& field) -> std::optional<Error> {
    const ParallelPair* const involutes = pair.parallel();
    const auto starts = involutes ? relief_starts(*involutes, which) : std::nullopt;
    if (!starts) {
      return absent_input(field,
                          "; give this value, because its default requires involute gears on "
                          "parallel axes with a transverse contact ratio above 1");
    }
    relief.reach = tip ? starts->tip : starts->root;
    return std::nullopt;
  };
  return first_without_start(given, place);
}

}  // namespace gearwright
