// Errors of teeth under load, in percent, relative to independent finite elements and to finer
// divisions in the same method.
//
// The independent elements are gmsh triangles with up to 68 000 unknowns, CalculiX C3D20 with 105
// 840, and two gears of triangles in node-to-node contact; 25 teeth, x = 0, rack 1.25/0.38, bore
// radius 6 m, ν = 0.3. Internal gears are compared with the triangles of tests/oracle/plane_teeth.
#include <fmt/format.h>

#include <cmath>

#include "gearwright/compliance/probe.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "tests/accuracy/ledger.hpp"
#include "tests/oracle/plane_section.hpp"

namespace gearwright::ledger {

namespace {

constexpr double kModule = 3.0;

Gear gear_of(double beta_deg, double face) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = 25, .module = kModule, .beta_deg = beta_deg, .x = 0.0, .face_width = face});
  s.rack = *iso53_rack("ISO53-A");
  return std::move(make_gear(s)).take();
}
ElasticBody body_of(double e) { return {12 * kModule, 0.3, e}; }

double percent(double got, double of) { return 100 * std::abs(got / of - 1); }

Row section() {
  Row row{"load.section", "25 teeth at r = 13.4, 12.5, 11.9 m; triangles", "%", 0.5, 0.0, ""};
  const Gear gear = gear_of(0, 30);
  const double reference[][2] = {{13.4, 13.324}, {12.5, 7.247}, {11.9, 5.5155}};
  for (const auto& [r, want] : reference) {
    const auto a = probe_compliance(gear, body_of(1.0), {.diameter = 2 * r * kModule},
                                    ComplianceAccuracy::full);
    row.see(percent(a->own, want), fmt::format("r {} m", r));
  }
  return row;
}

Row ring_section() {
  Row row{"load.ring_section",
          "rings of 40, 60, 100 teeth, a rim of 2.5 m, at 0.2, 0.5, 0.9 of the flank; triangles",
          "%",
          0.5,
          0.0,
          ""};
  for (const int teeth : {40, 60, 100}) {
    CylindricalSpec s = testing::plain_spec({.teeth = -teeth, .module = 1.0, .face_width = 10});
    s.rack = *iso53_rack("ISO53-A");
    const Gear ring = *cut_by_default(std::move(make_gear(s)).take());
    const double held = ring.root_diameter + 5;
    const oracle::PlaneGear plane = oracle::plane_section(ring, held, 1);
    for (const double up : {0.2, 0.5, 0.9}) {
      const double radius = (1 - up) * *ring.root_form_radius() + up * ring.tip_form_radius();
      const auto got = probe_compliance(ring, {held, 0.3, 1.0}, {.diameter = 2 * radius},
                                        ComplianceAccuracy::full);
      const double want = oracle::plane_teeth(plane, {{0, radius, 0.05}}, 1.5).yield(0, 0);
      row.see(percent(got->own, want), fmt::format("{} teeth, {} of the flank", teeth, up));
    }
  }
  return row;
}

// The comparison excludes the loaded region, because the bricks have no Hertz strip there. Errors
// are relative to the greatest value of the bricks.
Row along_face() {
  Row row{"load.along_face",
          "spur, b = 10 m, loads at the end and in the middle; bricks",
          "%",
          3,
          0.0,
          ""};
  struct Load {
    double from;
    std::vector<double> want;  // at z = 0, 1, … 10 m
  };
  const Gear gear = gear_of(0, 30);
  for (const Load& load :
       {Load{0.0, {8.554, 3.449, 1.752, 0.872, 0.427, 0.215, 0.117, 0.073, 0.05, 0.034, 0.017}},
        Load{4.5, {0.213, 0.406, 0.685, 1.174, 1.995, 3.535, 1.537, 0.875, 0.501, 0.295, 0.152}}}) {
    ComplianceProbe probe{.diameter = 2 * 13.2 * kModule};
    probe.loaded = {kModule * (load.from - 5), kModule * (load.from - 4.5)};
    for (int z = 0; z <= 10; ++z) probe.read.push_back(kModule * (z - 5));
    const auto a = probe_compliance(gear, body_of(1.0), probe, ComplianceAccuracy::full);
    double greatest = 0.0;
    const auto read = [&](int z) { return std::abs(z - load.from - 0.25) > 0.9; };
    for (int z = 0; z <= 10; ++z) greatest = std::max(greatest, load.want[z]);
    for (int z = 0; z <= 10; ++z)
      if (read(z))
        row.see(100 * std::abs(a->profile[z] * kModule - load.want[z]) / greatest,
                fmt::format("load at {} m, read at {} m", load.from, z));
  }
  return row;
}

// PAIR2D-25, plane strain, computed with a face width of 120 modules.
Row approach() {
  Row row{"load.approach",
          "pair 25/25, 100 N/mm, seven phases; two gears of triangles",
          "%",
          0.7,
          0.0,
          ""};
  const double face = 120 * kModule;
  const Gear gear = gear_of(0, face);
  ContactMount mount;
  mount.center_distance = gear.reference_diameter;
  const ContactPair pair({&gear, {}}, {&gear, {}}, mount);
  const double rb = gear.base_radius();
  const double pb = 2 * M_PI * rb / 25;
  LoadRequest request;
  request.bodies = {body_of(206000), body_of(206000)};
  request.slices = {24, 24};
  request.torques = {100 * face * rb};
  const double phases[] = {0.05, 0.15, 0.3, 0.5, 0.75, 0.8, 0.95};
  const double want[] = {5.0349, 4.9662, 4.9286, 4.9852, 7.3650, 7.3547, 7.4242};  // µm
  // The contact position at rotation 0 gives the rotation at which the flanks touch in each phase.
  request.rotations = {Angle()};
  const auto compliance = pair_compliance(gear, gear, request);
  const LoadedContact start = loaded_contact(pair, gear, gear, *compliance, request);
  const LoadedPair& at = start.torques[0].positions[0].pairs.back();
  const double u = std::sqrt(at.radius[12][0] * at.radius[12][0] - rb * rb);
  request.rotations.clear();
  for (const double phase : phases)
    request.rotations.push_back(
        Angle::radians((1.8963 * kModule + (phase - at.pair) * pb - u) / rb));
  const LoadedContact c = loaded_contact(pair, gear, gear, *compliance, request);
  for (std::size_t i = 0; i < std::size(phases); ++i)
    row.see(percent(1000 * c.torques[0].positions[i].approach, want[i]),
            fmt::format("phase {}", phases[i]));
  return row;
}

Row slices() {
  Row row{"load.slices", "25/25 spur and at 15°, b = 10 m: mean stiffness of 24 slices; 36",
          "%",           0.3,
          0.0,           ""};
  for (const double beta : {0.0, 15.0}) {
    const Gear one = gear_of(beta, 30);
    const Gear two = gear_of(-beta, 30);
    ContactMount mount;
    mount.center_distance = one.reference_diameter;
    const ContactPair pair({&one, {}}, {&two, {}}, mount);
    double mean[2];
    for (int i = 0; i < 2; ++i) {
      LoadRequest request;
      request.bodies = {body_of(206000), body_of(206000)};
      request.accuracy = ComplianceAccuracy::draft;
      request.positions = 8;
      request.slices = i == 0 ? std::array{24, 24} : std::array{36, 36};
      request.torques = {100e3};
      const auto compliance = pair_compliance(one, two, request);
      mean[i] = loaded_contact(pair, one, two, *compliance, request).torques[0].stiffness.mean;
    }
    row.see(percent(mean[0], mean[1]), fmt::format("β {}°", beta));
  }
  return row;
}

}  // namespace

std::vector<Row> load_rows() {
  return {section(), ring_section(), along_face(), approach(), slices()};
}

}  // namespace gearwright::ledger
