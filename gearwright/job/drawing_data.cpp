#include "gearwright/job/drawing_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// Returns the member with this path, for example "span.length_mm", or null if it has no value.
const Member* find(const ValueRecord& record, std::string_view path) {
  const Member* const m = member_at(record, path);
  return m && !all_nothing(m->value) ? m : nullptr;
}

// Returns a value with the unit of the sheet. Lengths in inch have four decimals, even if the last
// one is zero.
std::string number(const QuantityInfo& info, double value, UnitSystem units) {
  const UnitSystem own = system_of(info, units);
  if (unit_in(own, info.unit) == Unit::inch)
    return with_minus(fixed_decimals(value_in(own, info.unit, value), 4));
  const int digits = digits_in(own, info.unit, digits_of(info));
  const std::string text = short_decimals(value_in(own, info.unit, value), digits);
  return with_minus(text) + (info.unit == Unit::deg ? "°" : "");
}

}  // namespace

std::optional<std::string> Records::value(std::string_view path, Sign sign) const {
  const Member* const m = find(nominal, path);
  if (!m) return std::nullopt;
  if (const ValueList* ends = m->value.list(); ends && m->info->type == Type::number)
    return number(*m->info, *ends->front().number(), units) + " … " +
           number(*m->info, *ends->back().number(), units);
  const auto x = m->value.number();
  if (!x || m->info->type != Type::number) return with_minus(text_of(*m->info, m->value));
  if (const auto limits = between(*m->info, path)) return limits;
  return number(*m->info, sign == Sign::kept ? *x : std::abs(*x), units);
}

bool Records::has_limits(std::string_view path) const {
  const Member* const m = find(nominal, path);
  return m && m->info->type == Type::number && between(*m->info, path);
}

std::optional<std::string> Records::between(const QuantityInfo& info, std::string_view path) const {
  if (ends.size() != 2) return std::nullopt;
  const Member *const a = find(ends[0], path), *const b = find(ends[1], path);
  if (!a || !b || !a->value.number() || !b->value.number()) return std::nullopt;
  const double x = *a->value.number(), y = *b->value.number();
  const std::string from = number(info, std::min(x, y), units),
                    to = number(info, std::max(x, y), units);
  // Two equal deviations give one size, which is not the nominal size unless both are zero.
  const Member* const drawn = find(nominal, path);
  const auto size = drawn ? drawn->value.number() : std::nullopt;
  if (from == to && size && from == number(info, *size, units)) return std::nullopt;
  if (info.unit != Unit::mm) return from + " … " + to;
  const auto decimals = [](const std::string& text) {
    return static_cast<int>(text.size() - std::min(text.find('.'), text.size() - 1) - 1);
  };
  const auto aligned = [&, digits = std::max(decimals(from), decimals(to))](double mm) {
    return with_minus(fixed_decimals(value_in(system_of(info, units), info.unit, mm), digits));
  };
  return aligned(std::min(x, y)) + " … " + aligned(std::max(x, y));
}

void add_data(DataGroup& group, const Records& r, std::string_view path, Sign sign) {
  const Member* const m = find(r.nominal, path);
  if (m) group.rows.push_back({capitalised(m->info->words), m->info->symbol, *r.value(path, sign)});
}

void add_module(DataGroup& group, const Records& r, double normal_module) {
  if (r.units == UnitSystem::inch)
    group.rows.push_back(
        {"Normal diametral pitch", "P_nd", fmt::format("{:.8g}", kMmPerInch / normal_module)});
  else
    add_data(group, r, "normal_module_mm");
}

std::string rack_name(const JobSpec& spec, int which) {
  const std::string name = spec.tree->tables.at(gear_field(which)).value("rack", "ISO53-A");
  return name.starts_with("ISO53") ? "ISO 53" + name.substr(5) : name;
}

namespace {

// Adds the rows of a pinion cutter. `mate` is the number of the mating gear if the mating gear
// is the cutter, and 0 otherwise. The workshop may replace the default cutter by another one, so
// the generating centre distance of the default cutter is omitted.
void add_cutter(DataGroup& group, const PinionCutting& cutter, int mate, const Records& r) {
  const std::string origin = cutter.by_default ? ", default cutter"
                             : mate > 0        ? fmt::format(", gear {}", mate)
                                               : "";
  group.rows.push_back(
      {"Pinion cutter, teeth", "z_0", fmt::format("{}{}", cutter.cutter_teeth, origin)});
  if (!cutter.by_default) add_data(group, r, "generating_center_distance_mm");
  group.rows.push_back({"Pinion cutter, tip corner", "ρ_a0",
                        short_decimals(value_in(r.units, Unit::mm, cutter.tip_rounding), 4)});
}

void add_rack(DataGroup& group, const SolvedJob& job, int which, const Records& r) {
  const Gear& gear = job.gear(which);
  const auto& cut_by = job.completed.gear(which).cut_by;
  if (const auto* rack = std::get_if<DoubleArcRack>(&gear.spec.rack); rack && rack->named)
    return group.rows.push_back({"Basic rack", "", "GB/T 12759-1991"});
  if (!gear.involute()) return group.rows.push_back({"Basic rack", "", "with circular arcs"});
  if (gear.cut_by) add_cutter(group, *gear.cut_by, cut_by ? cut_by->gear : 0, r);
  if (gear.cut_by && !gear.cut_by->by_default) return;
  const StraightRack& rack = gear.spec.straight_rack();
  if (rack.named) return group.rows.push_back({"Basic rack", "", rack_name(job.spec, which)});
  group.rows.push_back({"Addendum, basic rack", "h_aP*", fmt::format("{:.10g}", rack.addendum)});
  group.rows.push_back({"Dedendum, basic rack", "h_fP*", fmt::format("{:.10g}", rack.dedendum)});
  group.rows.push_back(
      {"Root fillet, basic rack", "ρ_fP*", fmt::format("{:.10g}", rack.root_fillet_radius)});
}

DataGroup teeth(const SolvedJob& job, int which, const Records& r) {
  const Gear& gear = job.gear(which);
  const auto& halves = job.halves[which - 1];
  DataGroup group{gear.involute() ? "Gear data by DIN 3966-1, symbols of ISO 21771"
                                  : "Gear data, symbols of ISO 21771",
                  {}};
  add_data(group, r, "teeth");
  add_module(group, r, gear.spec.normal_module);
  add_data(group, r, "normal_pressure_angle_deg");
  add_data(group, r, "helix_angle_deg", Sign::dropped);
  if (halves)
    group.rows.push_back({"Hand of helix", "",
                          fmt::format("double-helical, {} at z > 0", *r.value("hand_of_helix"))});
  else if (gear.spec.helix_angle.rad() != 0.0)
    add_data(group, r, "hand_of_helix");
  if (halves) {
    const Records two{double_helical_quantities().of(*halves), r.units};
    if (halves->given.stagger_pitches != 0.0) add_data(group, two, "stagger_pitches");
    for (const char* key : {"half_face_width_mm", "gap_mm", "groove_diameter_mm"})
      add_data(group, two, key);
  }
  add_data(group, r, "lead_mm", Sign::dropped);
  add_rack(group, job, which, r);
  add_data(group, r, "profile_shift");
  return group;
}

// Adds a row for a size and a row for its limits. If there are no deviations, the row of the limits
// is blank.
void size_rows(DataGroup& group, UnitSystem units, const std::string& what,
               const std::string& symbol, double size, const std::string& fit,
               const std::optional<std::array<double, 2>>& deviations) {
  const bool mm = units == UnitSystem::mm;
  const auto inch = [&](double x) { return fixed_decimals(value_in(units, Unit::mm, x), 4); };
  const std::string text = mm ? with_minus(short_decimals(size, 4)) : inch(size);
  group.rows.push_back({what, symbol, fit.empty() ? text : text + " " + fit});
  // A limit that is not a whole number of µm needs a fourth decimal.
  const auto limit = [&](double deviation) {
    if (!mm) return inch(size + deviation);
    const double um = 1e3 * (size + deviation);
    return fixed_decimals(size + deviation, std::abs(um - std::round(um)) < 1e-6 ? 3 : 4);
  };
  group.rows.push_back(
      {"Limits", "", deviations ? limit((*deviations)[0]) + " … " + limit((*deviations)[1]) : ""});
}

std::optional<std::array<double, 2>> limits_of(const std::string& fit, double size) {
  const auto deviations = hole_deviations(fit, size);
  return deviations ? std::optional(*deviations) : std::nullopt;
}

DataGroup bore_group(const Gear& gear, const DrawingInput& words, UnitSystem units) {
  DataGroup group{"Bore and keyway", {}};
  if (gear.internal() || !gear.bore) return group;
  const Bore& bore = *gear.bore;
  size_rows(group, units, "Bore", "Ø", bore.diameter, words.bore_fit,
            limits_of(words.bore_fit, bore.diameter));
  if (!bore.has_keyway()) return group;
  const double width = bore.keyway_width;
  size_rows(group, units, "Keyway, width", "b", width, words.keyway_fit,
            limits_of(words.keyway_fit, width));
  std::optional<std::array<double, 2>> depth;
  if (!words.keyway_fit.empty()) depth = {0.0, keyway_depth_deviation(width)};
  size_rows(group, units, "Keyway, bore with depth", "d + t_2", bore.diameter + bore.keyway_depth,
            "", depth);
  return group;
}

DataGroup diameters(const Records& r) {
  DataGroup group{"Diameters", {}};
  for (const char* key : {"reference_diameter_mm", "base_diameter_mm", "tip_diameter_mm"})
    add_data(group, r, key);
  if (!r.has_limits("tip_diameter_mm")) group.rows.push_back({"Tip diameter, limits", "", ""});
  for (const char* key : {"root_diameter_mm", "root_form_diameter_mm", "tip_form_diameter_mm"})
    add_data(group, r, key);
  return group;
}

DataGroup thickness(bool ring, const GearInput& input, const Records& gear,
                    const Records& measure) {
  DataGroup group{"Tooth thickness", {}};
  if (input.tolerance.series)
    group.rows.push_back({"Allowance and tolerance", "", *input.tolerance.series + ", DIN 3967"});
  else if (!gear.has_limits("reference_tooth_thickness_normal_mm"))
    group.rows.push_back({"Allowance and tolerance", "", ""});
  add_data(group, gear, "reference_tooth_thickness_normal_mm");
  add_data(group, gear, "thickness_allowance_mm");
  if (const auto teeth = measure.value("span.teeth"))
    group.rows.push_back({fmt::format("Span over {} {}", *teeth, ring ? "tooth spaces" : "teeth"),
                          "W_" + *teeth, *measure.value("span.length_mm")});
  const bool pins = input.measure.pin_diameter && !input.measure.ball_diameter;
  add_data(group, measure, pins ? "over_pins.pin_diameter_mm" : "over_balls.ball_diameter_mm");
  if (const auto over = measure.value(pins ? "over_pins.three_mm" : "over_balls.dimension_mm"))
    group.rows.push_back(
        {fmt::format("Dimension {} two {}", ring ? "between" : "over", pins ? "pins" : "balls"),
         pins ? "M_dR" : "M_dK", *over});
  return group;
}

std::string amount(const ModificationEntry& entry, const FlankModifications& m, UnitSystem units) {
  const double um = value_in(units, Unit::um, kUmPerMm * entry.amount_of(m));
  const std::string text =
      fmt::format("{} {}", with_minus(short_decimals(um, digits_in(units, Unit::um, 3))),
                  unit_text(units, Unit::um));
  if (!entry.relief || !(m.*entry.relief).reach) return text;
  const bool diameter = entry.reach == "_start_mm";
  return text + (diameter ? " from Ø" : " over ") +
         short_decimals(value_in(units, Unit::mm, *(m.*entry.relief).reach), 4);
}

// Both halves of a double-helical gear are mirror images, so the rows describe both.
DataGroup modifications(const BothFlanks& flanks, bool halves, UnitSystem units) {
  DataGroup group{"Flank modifications, material removed", {}};
  bool one_sided = false, slope = false;
  for (const ModificationEntry& entry : modification_entries()) {
    const std::array<std::string, 2> texts{amount(entry, flanks[0], units),
                                           amount(entry, flanks[1], units)};
    const std::string words = capitalised(std::string(entry.words));
    for (const std::size_t i : {0u, 1u}) {
      if (entry.amount_of(flanks[i]) == 0.0) continue;
      const bool both = texts[0] == texts[1];
      one_sided = one_sided || !both;
      slope = slope || entry.symbol.starts_with("C_Hβ");
      const char* side = both ? "" : i == 0 ? ", right" : ", left";
      group.rows.push_back(
          {words + side, std::string(entry.symbol.substr(0, entry.symbol.find(" ="))), texts[i]});
      if (both) break;
    }
  }
  if (flanks[0].topography || flanks[1].topography)
    group.rows.push_back({"Topography", "", "by a separate table"});
  if (one_sided) group.rows.push_back({"Right flank, seen from +z, tooth upwards", "", "right"});
  if (one_sided || slope) group.rows.push_back({"Face +z of the axial section", "", "right"});
  if (slope)
    group.rows.push_back({"A positive helix slope removes more at", "",
                          halves ? "outer end of each half" : "face +z"});
  return group;
}

// If there is no flank tolerance class, its row is blank. The workshop then notices the omission.
DataGroup tolerances(const ToleranceInput& given, bool halves, const Records& measure) {
  if (!given.quality) return {"Tolerances, ISO 1328-1", {{"Flank tolerance class", "", ""}}};
  DataGroup group{
      fmt::format("Tolerances in {}, ISO 1328-1:{}, class {}", unit_text(measure.units, Unit::um),
                  given.edition == FlankTolerances::iso_2013 ? 2013 : 1995, *given.quality),
      {}};
  for (const char* path :
       {"tolerances.single_pitch_um", "tolerances.cumulative_pitch_um",
        "tolerances.profile_total_um", "tolerances.profile_form_um", "tolerances.profile_slope_um",
        "tolerances.helix_total_um", "tolerances.helix_form_um", "tolerances.helix_slope_um",
        "tolerances.runout_um", "flank.profile_evaluation_mm", "flank.helix_evaluation_mm"}) {
    const Member* const m = find(measure.nominal, path);
    if (!m) continue;
    // In the edition of 1995, the symbols do not have the subscript T.
    std::string symbol = m->info->symbol, value = *measure.value(path);
    if (given.edition == FlankTolerances::iso_1995 && symbol.ends_with('T')) symbol.pop_back();
    if (m->info->unit == Unit::mm) value += fmt::format(" {}", unit_text(measure.units, Unit::mm));
    std::string words = capitalised(m->info->words);
    if (halves && m->info->key == "helix_evaluation_mm") words += ", from the middle of each half";
    group.rows.push_back({std::move(words), symbol, value});
  }
  return group;
}

DataGroup mate(const SolvedJob& job, int which, const std::string& number_of_mate) {
  DataGroup group{job.rack ? "Mating rack" : "Mating gear", {}};
  if (job.parts() > 1) group.rows.push_back({"Drawing number", "", number_of_mate});
  if (job.rack) add_rack_mounting(group, job);
  if (!job.pair) return group;
  const Gear& other = job.gears[which == 1 ? 1 : 0];
  group.rows.push_back({"Number of teeth", which == 1 ? "z_2" : "z_1",
                        with_minus(fmt::format("{}", other.spec.teeth))});
  Records pair{pair_record(job), job.spec.units()};
  if (job.ends) {
    RecordLimits limits = pair_limits(job);
    pair.ends = {std::move(limits.lower), std::move(limits.upper)};
  }
  if (const auto& tolerance = job.completed.pair.distance_tolerance;
      tolerance && !pair.ends.empty()) {
    const double half =
        std::abs(job.ends->upper.pair->center_distance() - job.pair->center_distance());
    const QuantityInfo& info = *find(pair.nominal, "center_distance_mm")->info;
    group.rows.push_back(
        {capitalised(info.words), info.symbol,
         fmt::format("{} ± {} ({})", number(info, job.pair->center_distance(), pair.units),
                     number(info, half, pair.units), *tolerance)});
  } else {
    add_data(group, pair, "center_distance_mm");
  }
  if (job.pair->shaft_angle().rad() != 0.0) add_data(group, pair, "shaft_angle_deg");
  add_data(group, pair, "backlash.normal_mm");
  return group;
}

}  // namespace

std::vector<DataGroup> gear_drawing_data(const SolvedJob& job, int which,
                                         const std::string& number_of_mate) {
  const std::size_t i = which - 1;
  const GearInput& input = *job.completed.gears[i];
  const UnitSystem units = job.spec.units();
  Records gear{gear_quantities().of(job.gears[i]), units};
  Records measure{measure_records(job)[i], units};
  if (job.ends) {
    RecordLimits limits = gear_limits(job, i);
    gear.ends = {std::move(limits.lower), std::move(limits.upper)};
    measure.ends = measure_end_records(job)[i];
  }
  const bool halves = job.halves[i].has_value();
  std::vector<DataGroup> groups{teeth(job, which, gear), diameters(gear),
                                thickness(job.gears[i].internal(), input, gear, measure),
                                bore_group(job.gears[i], job.spec.drawing, units),
                                modifications(input.modifications, halves, units)};
  if (job.gears[i].involute()) groups.push_back(tolerances(input.tolerance, halves, measure));
  groups.push_back(mate(job, which, number_of_mate));
  std::erase_if(groups, [](const DataGroup& group) { return group.rows.empty(); });
  return groups;
}

}  // namespace gearwright
