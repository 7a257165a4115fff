// Gears, pairs and report inputs for the tests of report/.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/gear/basic.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/partners.hpp"
#include "gearwright/report/report.hpp"

namespace gearwright::testing {

inline Gear sample_gear(int teeth, double module, double helix_deg, double shift,
                        double tip_fillet = 0.0, double allowance = 0.0) {
  CylindricalSpec spec = testing::plain_spec({.teeth = teeth,
                                              .module = module,
                                              .beta_deg = helix_deg,
                                              .x = shift,
                                              .face_width = 10 * module});
  spec.thickness_allowance = allowance;
  spec.straight_rack().tip_fillet_radius = tip_fillet;
  auto gear = make_gear(spec);
  GW_EXPECTS(static_cast<bool>(gear));
  return std::move(gear).take();
}

inline ParallelPair sample_pair(Gear gear_1, Gear gear_2, double center_distance) {
  auto pair = mount_as<ParallelPair>(std::move(gear_1), std::move(gear_2), {center_distance});
  GW_EXPECTS(static_cast<bool>(pair));
  return std::move(pair).take();
}

/// Returns an ordinary helical pair with backlash: 17/43, m_n 2.5, ±15°, x 0.3 and 0.1.
inline ParallelPair helical_pair() {
  return sample_pair(sample_gear(17, 2.5, 15, 0.3, 0.0, -0.06), sample_gear(43, 2.5, -15, 0.1),
                     78.6056);
}
/// Returns a pair 8/25 with undercut, contact beyond the base tangent point, and a contact ratio
/// below 1.
inline ParallelPair undercut_pair() {
  return sample_pair(sample_gear(8, 2, 0, 0), sample_gear(25, 2, 0, 0), 33);
}
inline ParallelPair internal_pair() {
  return sample_pair(sample_gear(18, 2, 0, 0.2), sample_gear(-60, 2, 0, 0.2), 42);
}

/// Returns a gear with two teeth and circular root and tip fillets, from table 1 of the paper in
/// docs/theory/06-few-teeth.md.
inline Gear two_teeth(double face_width = 17.5, double shift = 0.7) {
  CylindricalSpec spec = testing::plain_spec(
      {.teeth = 2, .module = 1.75, .beta_deg = 30, .x = shift, .face_width = face_width});
  spec.straight_rack().root_fillet_radius = 0.3;
  spec.straight_rack().dedendum = 1.0 + 0.3 * (1.0 - std::sin(spec.normal_pressure_angle.rad()));
  spec.root_fillet = RootFilletSpec{0.01};
  spec.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, 0.332};
  auto gear = make_gear(spec);
  GW_EXPECTS(static_cast<bool>(gear));
  return std::move(gear).take();
}
inline Gear cut_gear(const Gear& cutter, int teeth, double shift, double face_width) {
  auto distance = generating_distance(cutter, teeth, shift);
  GW_EXPECTS(static_cast<bool>(distance));
  auto gear = make_pinion_cut_gear(cutter, {teeth, *distance, face_width, {}});
  GW_EXPECTS(static_cast<bool>(gear));
  return std::move(gear).take();
}
/// Returns the pair 2/60 of the same table. Gear 2 is cut by gear 1, and the pair is mounted at the
/// generating distance.
inline ParallelPair two_and_sixty(double face_width = 17.5) {
  Gear pinion = two_teeth(face_width);
  Gear wheel = cut_gear(pinion, 60, -1.4, face_width);
  const double distance = wheel.cut_by->distance;
  return sample_pair(std::move(pinion), std::move(wheel), distance);
}
/// Returns a pinion with 18 teeth in an internal gear with 60 teeth, which was cut by a cutter with
/// 20 teeth. The centre distance differs from the backlash-free centre distance by only 0.05 mm.
inline ParallelPair pinion_in_cut_ring() {
  CylindricalSpec cutter = testing::plain_spec({.teeth = 20, .module = 2, .face_width = 20});
  cutter.straight_rack().addendum = 1.25;
  auto made = make_gear(cutter);
  GW_EXPECTS(static_cast<bool>(made));
  return sample_pair(sample_gear(18, 2, 0, 0.2), cut_gear(*made, -60, 0.2, 20), 41.0755);
}

inline Gear gear_as_itself(int teeth, double base_diameter, double base_thickness,
                           double base_helix_deg, double tip_diameter, double face_width,
                           double rack_deg = 20) {
  const BaseGear<double> base{teeth, base_diameter / 2, base_thickness,
                              Angle::degrees(base_helix_deg).rad()};
  const auto rack = as_rack(base, Angle::degrees(rack_deg).rad());
  CylindricalSpec spec = testing::plain_spec({.teeth = teeth,
                                              .module = rack.normal_module,
                                              .x = rack.profile_shift,
                                              .face_width = face_width});
  spec.normal_pressure_angle = Angle::degrees(rack_deg);
  spec.helix_angle = Angle::radians(rack.helix_angle);
  spec.tip_diameter = tip_diameter;
  auto gear = make_gear(spec);
  GW_EXPECTS(static_cast<bool>(gear));
  return std::move(gear).take();
}

/// Returns two gears mounted at a shaft angle. The centre distance exceeds the backlash-free centre
/// distance by `more`.
inline CrossedPair crossed_sample_pair(Gear gear_1, Gear gear_2, double shaft_angle_deg,
                                       double more = 0.0, std::optional<double> friction = {}) {
  const auto nominal = base_pair(gear_1, gear_2);
  const auto place = complete_place(nominal, {}, Angle::degrees(shaft_angle_deg));
  GW_EXPECTS(static_cast<bool>(place));
  auto pair = mount_as<CrossedPair>(std::move(gear_1), std::move(gear_2),
                                    {place->center_distance + more, place->shaft_angle, friction});
  GW_EXPECTS(static_cast<bool>(pair));
  return std::move(pair).take();
}

/// Returns a pair 9/15 at 90°. The base diameters, thicknesses and helix angles are those of Mägi's
/// example after Zeise.
inline CrossedPair crossed_pair() {
  return crossed_sample_pair(gear_as_itself(9, 37.4892228898867, 7.263, 47.408, 46.65, 24),
                             gear_as_itself(15, 52.6687933717901, 7.618, 36.595, 65.27, 24), 90, 0,
                             0.05);
}
/// Returns two left-hand gears with backlash.
inline CrossedPair left_hand_pair() {
  return crossed_sample_pair(sample_gear(12, 2, -40, 0.2), sample_gear(20, 2, -30, 0.1), -70, 0.3);
}
inline CrossedPair opposite_hand_pair() {
  return crossed_sample_pair(sample_gear(17, 2, 35, 0), sample_gear(33, 2, -15, 0.1), 20);
}
/// Returns a pair whose axes are half a degree from parallel, so the lines of action lie far
/// outside the faces.
inline CrossedPair nearly_parallel_pair() {
  return crossed_sample_pair(sample_gear(17, 2, 20.5, 0.2), sample_gear(33, 2, -20, 0), 0.5);
}
/// Returns a worm with one tooth. Its friction is so high that the wheel cannot drive.
inline CrossedPair worm_pair() {
  return crossed_sample_pair(sample_gear(1, 2, 80, 0), sample_gear(30, 2, 10, 0), 90, 0, 0.3);
}
inline CrossedPair spur_and_helical_pair() {
  return crossed_sample_pair(sample_gear(20, 2, 0, 0), sample_gear(30, 2, 30, 0.3), 30.4);
}
/// Returns a pair whose gears are too far apart for contact.
inline CrossedPair crossed_apart() {
  return crossed_sample_pair(sample_gear(20, 2, 45, 0), sample_gear(30, 2, 45, 0), 90, 20);
}
inline std::vector<CrossedPair> crossed_pairs() {
  std::vector<CrossedPair> pairs;
  for (const auto make : {crossed_pair, left_hand_pair, opposite_hand_pair, nearly_parallel_pair,
                          worm_pair, spur_and_helical_pair, crossed_apart})
    pairs.push_back(make());
  return pairs;
}

/// Sets the verdict on the gears, pair and contact of a report, with additional warnings.
inline void judge(ReportInput& input, std::vector<Warning> warnings) {
  Judged judged;
  judged.gears = input.gears;
  judged.pair = input.pair ? &*input.pair : nullptr;
  judged.warnings = &warnings;
  input.verdict = verdict_of(judged);
}

inline std::vector<Warning> warnings_of(const MountedGears& pair) {
  std::vector<Warning> warnings;
  for (int i : {0, 1}) {
    for (Warning w : pair.gears[static_cast<std::size_t>(i)].warnings) {
      w.gear = i + 1;
      warnings.push_back(std::move(w));
    }
  }
  for (const Warning& w : pair.warnings) warnings.push_back(w);
  return warnings;
}

/// Returns the report input that a job would pass.
template <std::derived_from<MountedGears> Kind>
ReportInput report_input(const Kind& pair) {
  ReportInput input;
  input.title = "Sample";
  input.gears = {&pair.gears[0], &pair.gears[1]};
  input.pair = pair;
  judge(input, warnings_of(pair));
  input.files = {{"gear1.step", "STEP solid of gear 1", "within 0.9 µm"}};
  input.spec_text = "[gear1]\nteeth = 17\n";
  return input;
}

inline ReportInput report_input(const Gear& gear) {
  ReportInput input;
  input.gears = {&gear};
  std::vector<Warning> warnings = gear.warnings;
  for (Warning& w : warnings) w.gear = 1;
  judge(input, warnings);
  return input;
}

}  // namespace gearwright::testing
