// Gears, pairs and report inputs for the tests of this room.
#pragma once

#include <string>
#include <utility>

#include "gearwright/report/report.hpp"

namespace gearwright::testing {

inline Gear sample_gear(int teeth, double module, double helix_deg, double shift,
                        double tip_fillet = 0.0, double allowance = 0.0) {
  CylindricalSpec spec;
  spec.teeth = teeth;
  spec.normal_module = module;
  spec.helix_angle = Angle::degrees(helix_deg);
  spec.profile_shift = shift;
  spec.thickness_allowance = allowance;
  spec.face_width = 10 * module;
  spec.rack.tip_fillet_radius = tip_fillet;
  auto gear = make_gear(spec);
  GW_EXPECTS(static_cast<bool>(gear));
  return std::move(gear).take();
}

inline Pair sample_pair(Gear gear_1, Gear gear_2, double center_distance) {
  auto pair = mount_parallel(std::move(gear_1), std::move(gear_2), {center_distance});
  GW_EXPECTS(static_cast<bool>(pair));
  return std::move(pair).take();
}

/// 17/43, m_n 2.5, ±15°, x 0.3 and 0.1: an ordinary helical pair with backlash.
inline Pair helical_pair() {
  return sample_pair(sample_gear(17, 2.5, 15, 0.3, 0.0, -0.06), sample_gear(43, 2.5, -15, 0.1),
                     78.6056);
}
/// 8/25: undercut, contact beyond the base tangent point, contact ratio below 1.
inline Pair undercut_pair() {
  return sample_pair(sample_gear(8, 2, 0, 0), sample_gear(25, 2, 0, 0), 33);
}
inline Pair internal_pair() {
  return sample_pair(sample_gear(18, 2, 0, 0.2), sample_gear(-60, 2, 0, 0.2), 42);
}

/// What a job would hand over.
inline ReportInput report_input(const Pair& pair) {
  ReportInput input;
  input.title = "Sample";
  input.gears = {&pair.gears[0], &pair.gears[1]};
  input.pair = &pair;
  for (int i : {0, 1}) {
    for (Warning w : pair.gears[static_cast<std::size_t>(i)].warnings) {
      w.gear = i + 1;
      input.warnings.push_back(std::move(w));
    }
  }
  for (const Warning& w : pair.warnings) input.warnings.push_back(w);
  input.files = {{"gear1.step", "STEP solid of gear 1", "within 0.9 µm"}};
  input.spec_text = "[gear1]\nteeth = 17\n";
  input.version = "0.0.0";
  return input;
}

inline ReportInput report_input(const Gear& gear) {
  ReportInput input;
  input.gears = {&gear};
  for (Warning w : gear.warnings) {
    w.gear = 1;
    input.warnings.push_back(std::move(w));
  }
  return input;
}

}  // namespace gearwright::testing
