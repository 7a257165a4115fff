// Values as the report's tables show them.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright::shown {

inline std::string length(const std::optional<double>& mm) { return fixed(mm, kLengthDigits); }
inline std::string angle(const std::optional<double>& rad) {
  return fixed(rad ? std::optional(kDegPerRad * *rad) : std::nullopt, kAngleDigits);
}
inline std::string angle(Angle value) { return angle(value.rad()); }
inline std::string ratio(const std::optional<double>& value) { return fixed(value, kRatioDigits); }
inline std::string none() { return std::string(kNoValue); }

/// A factor as given: no digit more than the input had.
inline std::string given(double value) { return fmt::format("{:.10g}", value); }

}  // namespace gearwright::shown
