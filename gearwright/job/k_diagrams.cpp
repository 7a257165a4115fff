#include "gearwright/job/k_diagrams.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/nominal_csv.hpp"

namespace gearwright {

namespace {

constexpr int kSteps = 120;

std::optional<FlankToleranceValues> tolerances_of(const Gear& gear, const ToleranceInput& asked) {
  if (!asked.quality || !has_class(asked.edition, *asked.quality)) return std::nullopt;
  return flank_tolerances(asked.edition, *asked.quality, tolerance_subject(gear));
}

KDiagram diagram_of(std::string name, const Gear& gear, const RemovalField& field,
                    const EvaluationRanges& r,
                    const std::optional<FlankToleranceValues>& tolerances) {
  KDiagram d{std::move(name), {{}, r.profile, {}}, {{}, r.helix, {}}};
  if (tolerances) {
    d.profile.tolerance = tolerances->profile_total;
    d.helix.tolerance = tolerances->helix_total;
  }
  const double lo = std::min(r.root_form.length, r.tip_form.length);
  const double hi = std::max(r.root_form.length, r.tip_form.length);
  const double b = gear.spec.face_width, r_b = gear.base_radius();
  const auto removed = [&](double length, double z) {
    return -kUmPerMm * field.at(std::log(std::hypot(r_b, length)), z).c;
  };
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const double length = lo + t * (hi - lo), z = (t - 0.5) * b;
    d.profile.design.emplace_back(length, removed(length, 0.0));
    d.helix.design.emplace_back(z, removed((lo + hi) / 2, z));
  }
  return d;
}

bool same_design(const KDiagram& a, const KDiagram& b) {
  const auto same = [](const FlankTrace& s, const FlankTrace& t) { return s.design == t.design; };
  return same(a.profile, b.profile) && same(a.helix, b.helix);
}

}  // namespace

std::vector<KDiagram> k_diagrams(const SolvedJob& job) {
  std::vector<KDiagram> list;
  for (std::size_t i = 0; i < job.gears.size(); ++i) {
    const Gear& gear = job.gears[i];
    const GearInput& input = *job.completed.gears[i];
    const auto ranges = evaluation_ranges(gear);
    if (!ranges) continue;
    const auto tolerances = tolerances_of(gear, input.tolerance);
    const FlankExtent extent = extent_of(gear, *ranges);
    const auto right = make_removal_field(input.modifications[0], extent);
    const auto left = make_removal_field(input.modifications[1], extent);
    if (!right || !left || (!tolerances && right->none() && left->none())) continue;
    const std::string name = fmt::format("Gear {}", i + 1);
    KDiagram first = diagram_of(name + ", right flank", gear, *right, *ranges, tolerances);
    KDiagram second = diagram_of(name + ", left flank", gear, *left, *ranges, tolerances);
    if (same_design(first, second)) {
      first.name = name;
      list.push_back(std::move(first));
    } else {
      list.push_back(std::move(first));
      list.push_back(std::move(second));
    }
  }
  return list;
}

}  // namespace gearwright
