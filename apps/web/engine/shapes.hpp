// Data of the engine for a page, as JSON with rows of numbers for buffers.
//
// A row is binary data in the tree, so trees can be made and tested without a browser. bindings.cpp
// converts trees to values of JavaScript. The names and meanings of members are those of engine.d.ts.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gearwright/contact/pattern.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright::web {

using Numbers = std::vector<double>;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();  ///< a missing value

/// The typed array of JavaScript for a row. It is stored as the subtype of the binary data.
enum class RowType : std::uint8_t { float64, float32, uint32, uint8 };
Json row(const Numbers& numbers);
Json row(const std::vector<float>& numbers);
Json row(const std::vector<std::uint32_t>& numbers);
Json row(std::string_view bytes);

struct ContactCurve {
  struct Column {
    int width;
    std::variant<Numbers, std::vector<std::string>> values;
  };
  int n;
  std::map<std::string, Column> columns;
  double peak_to_peak_arcsec, mean_slope;
  Numbers harmonics_arcsec;
  bool contact_lost;
  std::string words;  // summary in words
};

Json shape(const ContactCurve& curve);
Json shape(const FlankRaster& raster);
/// A figure for a width in px, with its caption as HTML and its data. A figure of the gears in section has no
/// caption.
Json shape(const Figure& figure, double width);

}  // namespace gearwright::web
