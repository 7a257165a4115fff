#include "gearwright/job/csv_answer.hpp"

#include <cmath>

#include <fmt/format.h>

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

std::optional<PointGrid> parse_grid(const std::string& text) {
  constexpr int kMost = 1000;
  const auto parts = split(text, 'x');
  if (parts.size() != 2) return std::nullopt;
  const auto profile = whole_number(parts[0]), helix = whole_number(parts[1]);
  const auto sane = [](const auto& n) { return n && *n >= 2 && *n <= kMost; };
  if (!sane(profile) || !sane(helix)) return std::nullopt;
  return PointGrid{static_cast<int>(*profile), static_cast<int>(*helix)};
}

FlankExtent extent_of(const Gear& gear, const EvaluationRanges& ranges) {
  return {gear.base_radius(), ranges.root_form.diameter / 2, ranges.tip_form.diameter / 2,
          gear.spec.face_width};
}

namespace {

void append(std::string& text, UnitSystem units, int which, const std::string& flank,
            const std::vector<NominalPoint>& points) {
  const auto length = [&](double mm) { return value_in(units, Unit::mm, mm); };
  for (const NominalPoint& p : points)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", which, flank, length(p.diameter),
                        length(p.height), length(p.point.x()), length(p.point.y()),
                        length(p.point.z()), p.normal.x(), p.normal.y(), p.normal.z());
}

}  // namespace

Result<std::string> nominal_csv(const SolvedJob& job, const PointGrid& grid,
                                const std::optional<int>& fillet) {
  const UnitSystem units = job.spec.units();
  std::string text = "gear,flank";
  for (const char* key : {"diameter_mm", "height_mm", "x_mm", "y_mm", "z_mm"})
    text += "," + key_in(units, key);
  text += ",nx,ny,nz\n";
  for (std::size_t i = 0; i < job.gears.size(); ++i) {
    const int which = static_cast<int>(i) + 1;
    const Gear& gear = job.gears[i];
    const auto ranges = evaluation_ranges(gear);
    if (!ranges)
      return Error{gear_field(which), "",
                   "has no usable involute flank on which points could be computed"};
    for (const FlankSide side : {FlankSide::right, FlankSide::left}) {
      const bool right = side == FlankSide::right;
      const char* const flank = right ? "right" : "left";
      const auto field = make_removal_field(job.completed.gears[i]->modifications[right ? 0 : 1],
                                            extent_of(gear, *ranges));
      if (!field) return within(gear_field(which, "modifications"), field.error());
      append(text, units, which, flank, nominal_points(gear, *field, side, *ranges, grid));
      if (!fillet) continue;
      const auto points = fillet_points(gear, side, *ranges, {*fillet, grid.helix});
      if (points.empty())
        return Error{gear_field(which), "", "has no root fillet on which points could be computed"};
      append(text, units, which, std::string(flank) + "_fillet", points);
    }
  }
  return text;
}

namespace {

constexpr int kSteps = 120;

std::optional<FlankToleranceValues> tolerances_of(const Gear& gear, const ToleranceInput& given) {
  if (!given.quality || !has_class(given.edition, *given.quality)) return std::nullopt;
  return flank_tolerances(given.edition, *given.quality, tolerance_subject(gear));
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
