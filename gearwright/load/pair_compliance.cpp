#include "gearwright/load/pair_compliance.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/parallel.hpp"
#include "gearwright/compliance/section_mesh.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/load/complementarity.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

constexpr double kHertzWidth = 0.05;  // a0 in modules; it changes results only by rounding errors
constexpr double kFairSpur = 0.25, kFairHelical = 0.4;  // modules: least default width of a slice
// Least width of a slice, in modules. Narrower slices have no solution.
constexpr double kHopelessSpur = 0.15, kHopelessHelical = 0.2, kHopelessPoints = 0.18;
// Least width of a slice as a multiple of the half width of the contact, if kMostPairs tooth pairs
// share the load.
constexpr double kHopelessWidths = 2.0;
constexpr int kMostPairs = 3;
// Least default width of a slice of an internal pair, divided by √(R m). R is the relative radius
// of curvature of the flanks, and m is the module.
constexpr double kFairWidth = 0.15;
constexpr int kSlices = 32;
constexpr int kTableSteps = 80;  // approximate number of steps of progress for a table
// True if tooth and face of both gears are equal to the last bit, so that one table serves both.
bool same_tooth(const Gear& a, const Gear& b) {
  constexpr int kPoints = 9;
  const auto& x = a.tooth->outline.arcs;
  const auto& y = b.tooth->outline.arcs;
  if (a.spec.teeth != b.spec.teeth || a.twist() != b.twist() || x.size() != y.size() ||
      a.spec.normal_module != b.spec.normal_module || a.spec.face_width != b.spec.face_width)
    return false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].name != y[i].name) return false;
    for (int k = 0; k < kPoints; ++k)
      if (x[i].point(k / (kPoints - 1.0)) != y[i].point(k / (kPoints - 1.0))) return false;
  }
  return true;
}

// Returns the width of the part of a gear's face that may be loaded, mm.
double face_of(const std::array<const Gear*, 2>& gears, std::size_t which, LoadRegime regime,
               double reach) {
  if (regime == LoadRegime::point) return std::min(gears[which]->spec.face_width, 2 * reach);
  return std::min(gears[0]->spec.face_width, gears[1]->spec.face_width);
}

// Returns the slices of the part of the face that may be loaded, in the frame N, in mm from the
// middle of the gear's face. For line contact, this part is common to both faces. For point
// contact, it is the part within the reach, which is shifted onto the face if it extends beyond an
// end.
FaceSlices slices_of(const std::array<const Gear*, 2>& gears, std::size_t which,
                     const LoadRequest& request) {
  const double own = gears[which]->spec.face_width / 2;
  if (request.regime == LoadRegime::line) {
    const double other = gears[1 - which]->spec.face_width / 2;
    const double apart = request.middle[1 - which] - request.middle[which];
    const FaceSlices common{request.slices[which], std::max(-own, apart - other),
                            std::min(own, apart + other)};
    // If the faces have no common part, no teeth touch, which the analysis reports.
    return common.lo < common.hi ? common : FaceSlices{request.slices[which], -own, own};
  }
  const double face = face_of(gears, which, request.regime, request.reach);
  const double beside = own - face / 2;
  const double middle = std::clamp(-request.middle[which], -beside, beside);
  return {request.slices[which], middle - face / 2, middle + face / 2};
}

bool same_slices(const FaceSlices& a, const FaceSlices& b) {
  return a.count == b.count && a.lo == b.lo && a.hi == b.hi;
}

// Returns the half width of the contact of involute teeth at the pitch point, mm, if kMostPairs
// tooth pairs share the greatest torque. [T12.12]
double least_half_width(const Gear& gear_1, const Gear& gear_2, const LoadRequest& request) {
  if (request.regime == LoadRegime::point || request.torques.empty()) return 0.0;
  const double torque = *std::max_element(request.torques.begin(), request.torques.end());
  const double face = face_of({&gear_1, &gear_2}, 0, request.regime, request.reach);
  const double line_load = torque / (gear_1.base_radius() * face * kMostPairs);
  const auto& reference = gear_1.reference();
  const double tan_alpha = std::tan(reference.transverse_pressure_angle);
  const double flatter = 1 / gear_1.base_radius() + gear_2.side() / gear_2.base_radius();
  const double radius = tan_alpha / (flatter * std::cos(reference.base_helix_angle));
  double soft = 0.0;
  for (const ElasticBody& b : request.bodies)
    soft += (1 - b.poisson_ratio * b.poisson_ratio) / b.youngs_modulus;
  return hertz_half_width(line_load, radius, 1 / soft);
}

// True if the bodies of two gears with equal teeth and equal slices have equal tables of
// compliance. A table does not depend on Young's modulus.
bool same_body(const ElasticBody& a, const ElasticBody& b) {
  return a.bore_diameter == b.bore_diameter && a.poisson_ratio == b.poisson_ratio;
}

}  // namespace

Result<std::shared_ptr<const ToothTable>> tooth_compliance(const Gear& gear_1, const Gear& gear_2,
                                                           int which, const LoadRequest& request) {
  const Gear& gear = which == 1 ? gear_1 : gear_2;
  const double m = gear.spec.normal_module;
  const FaceSlices slices =
      slices_of({&gear_1, &gear_2}, static_cast<std::size_t>(which - 1), request);
  const double sin_b =
      std::sin(gear_1.spec.helix_angle.rad()) * std::cos(gear_1.spec.normal_pressure_angle.rad());
  // In the section, the loaded flank is the left flank, at y > 0. In the frame N, the right flanks
  // of an external pair touch, so the section is mirrored. For an internal pair, the frame N itself
  // is a mirror image, in which the pinion touches with its left flank, as in the section. The
  // internal gear touches with its right flank, so its section is mirrored.
  const double twist = -gear.side() * gear.twist();
  const auto section = make_tooth_section(gear, twist, request.bodies[which - 1], request.accuracy,
                                          std::nullopt, request.progress);
  if (!section) return of_gear(which, section.error());
  ToothTableRequest t;
  t.face_width = gear.spec.face_width / m;
  t.slices = {slices.count, slices.lo / m, slices.hi / m};
  t.half_width = kHertzWidth * (gear_1.spec.normal_module / m);
  t.root_stress = request.root_stress;
  t.line_per_height = 1 / std::sqrt(1 - sin_b * sin_b);
  t.progress = request.progress;
  return std::make_shared<const ToothTable>(*section, t);
}

std::string_view to_string(LoadRegime regime) {
  return regime == LoadRegime::line ? "line" : "point";
}

std::array<int, 2> fair_slices(const Gear& gear_1, const Gear& gear_2, LoadRegime regime,
                               double reach) {
  const double m = gear_1.spec.normal_module;
  double fair = gear_1.spec.helix_angle.rad() == 0.0 ? kFairSpur : kFairHelical;
  if (gear_2.internal()) {
    // The relative radius of curvature R of the flanks is greatest where the tip of the pinion
    // touches. It is computed for the reference centre distance.
    const double between = (gear_2.base_radius() - gear_1.base_radius()) *
                           std::tan(gear_1.reference().transverse_pressure_angle);
    const double rho = roll_length(gear_1.tip_form_radius(), gear_1.base_radius());
    if (between > 0.0)
      fair = std::max(fair, kFairWidth * std::sqrt(rho * (rho + between) / between / m));
  }
  const auto count = [&](std::size_t which) {
    const double face = face_of({&gear_1, &gear_2}, which, regime, reach);
    return static_cast<int>(std::clamp<double>(face / (fair * m), kLeastSlices, kSlices));
  };
  return {count(0), count(1)};
}

double crossed_reach(const Gear& gear_1, const Gear& gear_2) {
  constexpr double kBeyond = 2.0;  // modules
  const double m = gear_1.spec.normal_module;
  double path = 0.0;
  for (const Gear* gear : {&gear_1, &gear_2})
    path = std::max(path, (gear->tip_diameter - gear->reference_diameter) / 2 /
                              std::sin(gear->spec.normal_pressure_angle.rad()));
  return std::max(path + kBeyond * m, kSlices * kFairHelical * m / 2);
}

NarrowestSlices narrowest_slices(const Gear& gear_1, const Gear& gear_2,
                                 const LoadRequest& request) {
  const double one = slices_of({&gear_1, &gear_2}, 0, request).width();
  const double two = slices_of({&gear_1, &gear_2}, 1, request).width();
  return two < one ? NarrowestSlices{2, two} : NarrowestSlices{1, one};
}

bool surely_too_fine(const Gear& gear_1, const Gear& gear_2, const LoadRequest& request) {
  const double least = gear_1.spec.helix_angle.rad() == 0.0 ? kHopelessSpur
                       : request.regime == LoadRegime::line ? kHopelessHelical
                                                            : kHopelessPoints;
  const double contact = kHopelessWidths * least_half_width(gear_1, gear_2, request);
  return narrowest_slices(gear_1, gear_2, request).width <
         std::max(least * gear_1.spec.normal_module, contact);
}

LoadRequest LoadRequest::undeflected() const {
  LoadRequest rigid = *this;
  rigid.shafts = {};
  rigid.deflection_slope = rigid.deflection_bow = rigid.deflection_offset = 0.0;
  return rigid;
}

Result<PairCompliance> pair_compliance(
    const Gear& gear_1, const Gear& gear_2, const LoadRequest& request,
    const std::array<std::shared_ptr<const ToothTable>, 2>& ready) {
  // The number of teeth is checked first, because the table of the other gear takes seconds.
  for (const int which : {1, 2})
    if (auto error = too_few_teeth((which == 1 ? gear_1 : gear_2).spec.teeth))
      return of_gear(which, *error);
  PairCompliance c;
  c.table = ready;
  c.bodies = request.bodies;
  for (std::size_t g = 0; g < 2; ++g) {
    c.slices[g] = slices_of({&gear_1, &gear_2}, g, request);
    GW_EXPECTS(!request.shafts[g] || request.middle[0] == request.middle[1]);
    if (const auto& shaft = request.shafts[g])
      c.shafts[g] = shaft_influence(*shaft, c.slices[g], (g == 0 ? gear_1 : gear_2).root_diameter);
  }
  c.half_width = kHertzWidth * gear_1.spec.normal_module;
  begin_stage(request.progress, "computing the compliance of the teeth", 2 * kTableSteps);
  std::array<std::optional<Error>, 2> errors;
  const auto make = [&](std::size_t g) {
    if (c.table[g]) return;
    auto table = tooth_compliance(gear_1, gear_2, static_cast<int>(g) + 1, request);
    if (table)
      c.table[g] = *table;
    else
      errors[g] = table.error();
  };
  const bool alike = same_tooth(gear_1, gear_2) &&
                     same_body(request.bodies[0], request.bodies[1]) &&
                     same_slices(c.slices[0], c.slices[1]);
  parallel_for(alike ? 1 : 2, make);
  for (const auto& error : errors)
    if (error) return *error;
  if (alike) c.table[1] = c.table[0];
  return c;
}

bool same_compliance(const std::array<const Gear*, 2>& a, const LoadRequest& of_a,
                     const std::array<const Gear*, 2>& b, const LoadRequest& of_b, int which) {
  const std::size_t g = which - 1;
  return of_a.accuracy == of_b.accuracy && of_a.root_stress == of_b.root_stress &&
         of_a.regime == of_b.regime && same_slices(slices_of(a, g, of_a), slices_of(b, g, of_b)) &&
         same_body(of_a.bodies[g], of_b.bodies[g]) && same_tooth(*a[g], *b[g]);
}

}  // namespace gearwright
