#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright {

namespace {

// Lists the kinds of contact with the fraction of positions that have each kind. If there is
// contact at an edge, the explanation of this kind is added to `legend`.
std::string kinds_of(const ContactResult& result, std::string& legend) {
  std::vector<std::pair<TouchKind, int>> count;
  for (const ContactPoint& p : result.positions) {
    const auto it =
        std::find_if(count.begin(), count.end(), [&](const auto& c) { return c.first == p.kind; });
    if (it == count.end()) {
      count.emplace_back(p.kind, 1);
    } else {
      ++it->second;
    }
  }
  std::string text;
  for (const auto& [kind, n] : count) {
    text += fmt::format("{}{} {} %", text.empty() ? "" : ", ", to_string(kind),
                        std::lround(100.0 * n / static_cast<double>(result.positions.size())));
    if (is_sharp(kind))
      legend +=
          fmt::format("{}{}: {}", legend.empty() ? "\n  " : "; ", to_string(kind), words_of(kind));
  }
  return text;
}

// Returns, as text, the displacement over the common face width due to an angular error of the
// axes.
std::string over_face(const SolvedJob& job, double degrees) {
  double face = kInfinity;
  for (const Gear& gear : job.gears) face = std::min(face, gear.spec.face_width);
  const UnitSystem units = job.spec.units();
  return fmt::format("{} {} over the common face",
                     text_in(units, Unit::um, std::tan(degrees * kRadPerDeg) * face * kUmPerMm, 2),
                     unit_text(units, Unit::um));
}

// Lists the transmission error and the axial float of the whole gears, and the point of contact on
// each half.
TextTable halves_table(const ContactAnswer& answer, UnitSystem units) {
  const auto mm = [&](double x) { return text_in(units, Unit::mm, x, 4); };
  const std::string unit(unit_text(units, Unit::mm));
  TextTable table{
      "",
      {"rotation 1", "TE", "axial float", "z > 0", "diam. 1", "z 1", "z < 0", "diam. 1", "z 1"}};
  table.units = {"°", "″", std::string(unit_text(units, Unit::um)), "", unit, unit, "", unit, unit};
  table.notes = {
      "axial float: axial movement of gear 1 relative to gear 2; z 1: axial position of the "
      "contact, from the middle of the half"};
  const auto& positions = answer.driving.positions;
  const std::size_t step = std::max<std::size_t>(1, positions.size() / 32);
  for (std::size_t i = 0; i < positions.size(); i += step) {
    const ContactPoint& p = positions[i];
    std::vector<std::string> cells{fixed_decimals(p.rotation1.deg(), 4), "no contact"};
    if (p.kind != TouchKind::none) {
      cells[1] = fixed_decimals(p.te.arcsec(), 5);
      cells.push_back(text_in(units, Unit::um, answer.float_axial[i] * kUmPerMm, 4));
      for (const ContactView& half : answer.halves) {
        const ContactPoint& at = half.driving.positions[i];
        cells.insert(cells.end(),
                     {std::string(to_string(at.kind)), mm(at.diameter[0]), mm(at.height[0])});
      }
    }
    cells.resize(table.columns.size());
    table.rows.push_back({"", "", std::move(cells)});
  }
  return table;
}

}  // namespace

std::string contact_listing(const SolvedJob& job, const ContactAnswer& answer) {
  const ContactResult& r = answer.driving;
  const UnitSystem units = job.spec.units();
  // The transmission error of a rack is a displacement along the rack.
  const std::string_view error_unit = unit_text(units, r.rack ? Unit::um : Unit::arcsec);
  const auto error_text = [&](Angle te, int decimals) {
    return r.rack ? text_in(units, Unit::um, kUmPerMm * r.rack.of(te), decimals)
                  : fixed_decimals(te.arcsec(), decimals);
  };
  std::string out = title_listing(job.spec);
  std::vector<ValueRecord> records{contact_quantities().of(answer)};
  std::vector<std::string> columns;
  for (const ContactView& half : answer.halves) {
    if (columns.empty()) columns.emplace_back("whole");
    columns.emplace_back(columns.size() == 1 ? "half z > 0" : "half z < 0");
    records.push_back(contact_quantities().of(half));
  }
  out += quantity_listing(job.spec.units(), contact_quantities().table(), records, columns);
  const auto row = [&](const std::string& what, const std::string& value) {
    out += fmt::format("  {:<42}{}\n", what, value);
  };
  for (std::size_t i = 0; i < kErrorCount; ++i) {
    const ErrorEntry& error = error_entries()[i];
    const double value = job.spec.errors.value[i];
    if (value == 0.0) continue;
    const bool tilt = error.kind == ErrorKind::crossing || error.kind == ErrorKind::intersecting;
    const Unit unit = unit_of(error.key);
    row(fmt::format("Error, {}", error.words),
        fmt::format("{}{}{}{}", value_in(units, unit, value), unit == Unit::deg ? "" : " ",
                    unit_text(units, unit), tilt ? ", which is " + over_face(job, value) : ""));
  }
  std::string legend;
  row("Contact", kinds_of(r, legend));
  if (!r.harmonics.empty()) {
    std::string waves;
    for (std::size_t i = 0; i < std::min<std::size_t>(5, r.harmonics.size()); ++i)
      waves += (i ? ", " : "") + error_text(r.harmonics[i], 4);
    row("Harmonics 1 to 5, amplitudes", fmt::format("{} {}", waves, error_unit));
  }
  if (answer.pattern) {
    std::vector<std::string> shares;
    for (const FlankRaster& raster : *answer.pattern) {
      const auto marked = std::count_if(raster.gap.begin(), raster.gap.end(), [&](double gap) {
        return gap <= job.spec.contact.marking;
      });
      if (!raster.gap.empty())
        shares.push_back(fixed_decimals(
            100.0 * static_cast<double>(marked) / static_cast<double>(raster.gap.size()), 1));
    }
    row("Marked share of the flanks of each gear", fmt::format("{} %", fmt::join(shares, ", ")));
  }
  if (answer.map) {
    double least = kInfinity, greatest = 0.0;
    for (const std::vector<double>& line : answer.map->value)
      for (const double te : line) {
        if (te < least) least = te;
        if (te > greatest) greatest = te;
      }
    if (least <= greatest)
      row("Peak to peak over the map of errors",
          fmt::format("{} to {} {}", error_text(Angle::radians(least), 3),
                      error_text(Angle::radians(greatest), 3), error_unit));
  }
  if (!answer.halves.empty()) return out + "\n" + table_listing(halves_table(answer, units));
  // Of many positions, only equally spaced ones are listed, fewer than 64. The option --json lists
  // all positions.
  const std::size_t step = std::max<std::size_t>(1, r.positions.size() / 32);
  std::vector<std::string> names;
  records.clear();
  for (std::size_t i = 0; i < r.positions.size(); i += step) {
    names.emplace_back(r.positions[i].kind == TouchKind::none ? "no contact" : "");
    records.push_back(position_quantities().of(r.positions[i]));
  }
  out += "\n" + row_listing(units, names, records,
                            {"rotation1_deg", "transmission_error_arcsec", "transmission_error_um",
                             "tooth", "kind", "diameter_mm", "rack_height_mm", "height_mm",
                             "ellipse.semi_major_mm", "ellipse.semi_minor_mm"});
  return out + (legend.empty() ? legend : legend + "\n");
}

}  // namespace gearwright
