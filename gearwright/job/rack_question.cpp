// Implements the option --as-rack of the verb `gear`, which describes the teeth of a gear by
// another rack.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

// If the user gives a module and an angle, the base pitch of this rack may differ from that of the
// gear by one part in a million, because users round their input.
constexpr double kSameRack = 1e-6;
// Permitted normal pressure angles of the rack in degrees, the same as for a gear.
constexpr double kMinRackAngle = 1.0, kMaxRackAngle = 60.0;

double deg(double rad) { return Angle::radians(rad).deg(); }

}  // namespace

std::optional<RackQuestion> parse_rack_question(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    return std::nullopt;
  const auto number = [](const std::string& part, bool& good) -> std::optional<double> {
    if (part.empty()) return std::nullopt;
    char* end = nullptr;
    const double v = std::strtod(part.c_str(), &end);
    // strtod also accepts hexadecimal numbers, "inf" and "nan", which are rejected here.
    good = good && part.find_first_not_of("0123456789.eE+-") == std::string::npos;
    good = good && end == part.c_str() + part.size() && std::isfinite(v) && v > 0.0;
    return v;
  };
  bool good = true;
  RackQuestion q;
  q.normal_module = number(text.substr(0, comma), good);
  if (const auto angle = number(text.substr(comma + 1), good)) {
    q.normal_pressure_angle = Angle::degrees(*angle);
    good = good && *angle >= kMinRackAngle && *angle <= kMaxRackAngle;
  }
  if (!good || (!q.normal_module && !q.normal_pressure_angle)) return std::nullopt;
  return q;
}

Result<ReferenceInput<double>> gear_as_rack(const Gear& gear, const RackQuestion& question) {
  const auto bad = [](const std::string& value, const std::string& why) {
    return Error{"--as-rack", value, why, FailureKind::option};
  };
  if (!gear.involute())
    return bad("", "only involute teeth can be described by a rack of another pressure angle");
  const BaseGear<double> base = base_gear(gear.spec.teeth, gear.reference());
  const double m_cos = normal_base_pitch(base) / std::numbers::pi;
  double alpha = question.normal_pressure_angle.value_or(Angle()).rad();
  if (question.normal_module) {
    const double m = *question.normal_module;
    if (!(m > m_cos)) {
      return bad(format_number(m, m_cos) + ",",
                 fmt::format("no rack of this module describes the gear; the module must be "
                             "greater than m_n cos α_n = {}\u00a0mm",
                             format_number(m_cos, m)));
    }
    const double of_module = std::acos(m_cos / m);
    const double m_max = m_cos / std::cos(kMaxRackAngle * kRadPerDeg);
    if (m > m_max) {
      return bad(format_number(m, m_max) + ",",
                 fmt::format("with this module and the base pitch of the gear, the pressure angle "
                             "would be {}°, but at most {}° is allowed; the module must be at most "
                             "{}\u00a0mm",
                             format_number(deg(of_module), kMaxRackAngle), kMaxRackAngle,
                             format_number(m_max, m)));
    }
    if (!question.normal_pressure_angle) {
      alpha = of_module;
    } else if (std::abs(m * std::cos(alpha) - m_cos) > kSameRack * m_cos) {
      return bad(fmt::format("{:.9g},{:.9g}", m, deg(alpha)),
                 fmt::format("the base pitch of this rack differs from the base pitch of the gear; "
                             "for the pressure angle {:.9g}° the module must be {:.9g}\u00a0mm, or "
                             "for the module {:.9g}\u00a0mm the pressure angle must be {:.9g}°",
                             deg(alpha), m_cos / std::cos(alpha), m, deg(of_module)));
    }
  }
  if (!has_rack(base, alpha)) {
    const double limit = 90 - std::abs(deg(base.helix_angle));
    return bad("," + format_number(deg(alpha), limit),
               fmt::format("no rack of this pressure angle describes the gear; the pressure angle "
                           "must be less than {}°, which is 90° minus the base helix angle",
                           format_number(limit, deg(alpha))));
  }
  return as_rack(base, alpha);
}

Json rack_json(const ReferenceInput<double>& rack) {
  return to_json(as_rack_quantities().of(rack));
}

std::string rack_listing(const std::vector<ReferenceInput<double>>& racks, UnitSystem units) {
  std::vector<ValueRecord> records;
  for (const auto& rack : racks) records.push_back(as_rack_quantities().of(rack));
  return quantity_listing(units, as_rack_quantities().table(), records,
                          gear_columns(records.size()));
}

}  // namespace gearwright
